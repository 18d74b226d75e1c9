/* Generated, do not edit. Made by: qcone generate adams_moulton_4.toml --design adams_moulton_4_fixed32_compensated
 *
 * qcone 0.1.0, design adams_moulton_4_fixed32_compensated, SHA-256 of the design
 * 8dba7dd27a69fbf9f468c1a5bb888ea24642a79b341fd4cbba1b512b03909956
 *
 * algorithm:   adams-moulton-4-runge-kutta-4, form factored, q' = q + dq, the rounding carried to
 *              the next update, kept in twice the bits, renormalised on every update
 * source:      thesis2008 Adams-Moulton, Milne
 * equation:    p = q + h (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24; q + h (9 f_p + 19 f_0 - 5 f_1 +
 *              f_2)/24
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 200 updates/s; |dtheta| <= 0.050004 rad; | |q|
 *              - 1 | <= 0.2 always, proved; within it no sum overflows, as is proved; beyond it
 *              nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 8e-09 of exact arithmetic, in the norm of the components, what
 *              is carried included, which does not add up; proved
 * high words:  7 of 27 rounded sums of products drop a whole word, 7 before formats were searched
 *              for that; of one update's errors in the first order it made 1.2e-08 of 1.2e-08
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * hold as-written            0       0    0         0       0       0     0     0     0       0      0
 * hold shared                0       0    0         0       0       0     0     0     0       0      0
 * hold emitted               0       0    0         0       0       0     0     0     0       0      3
 * start_up as-written      264       0  181        46      12       0     0     0     0       0      0
 * start_up shared          221      34  165        58       3       0     0     0     0       0      0
 * start_up emitted         221       0  206        17      29       0     0     0     0       0    194
 * steady as-written         75       0   37        23       2       0     0     0     0       0      0
 * steady shared             74       1   37        23       1       0     0     0     0       0      0
 * steady emitted            74       0   44        16      10       0     0     0     0       0     71
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "adams_moulton_4_fixed32_compensated.h"

#if ADAMS_MOULTON_4_FIXED32_COMPENSATED_VERSION != 1
#error "adams_moulton_4_fixed32_compensated.h is of another version than this file: generate both again"
#endif

/* x / 2^bits, rounded down, 0 <= bits < 32. */
static inline int32_t shift_right_32(int32_t x, int bits)
{
    return ((((int32_t)-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));
}

/* x / 2^bits, rounded down, 0 <= bits < 64. */
static inline int64_t shift_right_64(int64_t x, int bits)
{
    return ((((int64_t)-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));
}

/* x / 2^1, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_1(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1)) >> 1);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^3, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_3(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(4)) >> 3);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^4, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_4(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(8)) >> 4);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^5, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_5(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(16)) >> 5);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^21, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_21(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1048576)) >> 21);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^28, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_28(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(134217728)) >> 28);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^29, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_29(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(268435456)) >> 29);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^30, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_30(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(536870912)) >> 30);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^31, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_31(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1073741824)) >> 31);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^32, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_32(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(2147483648)) >> 32);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int32_t round_short_1(int32_t x)
{
    return shift_right_32(x + 1, 1);
}

/* x / 2^3, rounded to nearest, halves up. */
static inline int32_t round_short_3(int32_t x)
{
    return shift_right_32(x + 4, 3);
}

/* x / 2^4, rounded to nearest, halves up. */
static inline int32_t round_short_4(int32_t x)
{
    return shift_right_32(x + 8, 4);
}

/* x / 2^5, rounded to nearest, halves up. */
static inline int32_t round_short_5(int32_t x)
{
    return shift_right_32(x + 16, 5);
}

/* x / 2^6, rounded to nearest, halves up. */
static inline int32_t round_short_6(int32_t x)
{
    return shift_right_32(x + 32, 6);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int64_t round_wide_1(int64_t x)
{
    return shift_right_64(x + INT64_C(1), 1);
}

/* x / 2^2, rounded to nearest, halves up. */
static inline int64_t round_wide_2(int64_t x)
{
    return shift_right_64(x + INT64_C(2), 2);
}

/* x / 2^8, rounded to nearest, halves up. */
static inline int64_t round_wide_8(int64_t x)
{
    return shift_right_64(x + INT64_C(128), 8);
}

void adams_moulton_4_fixed32_compensated_init(adams_moulton_4_fixed32_compensated_state *state)
{
    state->q[0] = INT64_C(4611686018427387904) /* 1 */;
    state->q[1] = INT64_C(0);
    state->q[2] = INT64_C(0);
    state->q[3] = INT64_C(0);
    state->omega_last[0] = 0;
    state->omega_last[1] = 0;
    state->omega_last[2] = 0;
    state->f[0] = 0;
    state->f[1] = 0;
    state->f[2] = 0;
    state->f[3] = 0;
    state->f[4] = 0;
    state->f[5] = 0;
    state->f[6] = 0;
    state->f[7] = 0;
    state->f[8] = 0;
    state->f[9] = 0;
    state->f[10] = 0;
    state->f[11] = 0;
    state->error[0] = 0;
    state->error[1] = 0;
    state->error[2] = 0;
    state->error[3] = 0;
    state->rates[0] = 0;
    state->rates[1] = 0;
    state->rates[2] = 0;
    state->rates[3] = 0;
    state->rates[4] = 0;
    state->rates[5] = 0;
    state->count = 0;
}

void adams_moulton_4_fixed32_compensated_set_quaternion(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t q_nb[4])
{
    /* q_nb, read once */
    const int32_t q_nb_w = q_nb[0];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_x = q_nb[1];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_y = q_nb[2];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_z = q_nb[3];  /* F30, |x| <= 1.01 */

    /* e = (1 - |q|^2)/2 */
    const int64_t e_1 = (int64_t)q_nb_w * q_nb_w;  /* F60 */
    const int64_t e_2 = (int64_t)q_nb_x * q_nb_x;  /* F60 */
    const int64_t e_3 = e_1 + e_2;  /* F61 */
    const int64_t e_4 = (int64_t)q_nb_y * q_nb_y;  /* F60 */
    const int64_t e_5 = e_3 + e_4;  /* F61 */
    const int64_t e_6 = (int64_t)q_nb_z * q_nb_z;  /* F60 */
    const int64_t e_7 = e_5 + e_6;  /* F61 */
    const int64_t e_8 = INT64_C(1152921504606846976) /* 1/2 */ - e_7;  /* F61 */
    const int32_t e = round_21(e_8);  /* F40, |x| <= 0.000978 */

    /* q_next = q + e q */
    const int64_t q_next_w_part_1 = (int64_t)e * q_nb_w;  /* F70 */
    const int64_t q_next_w_part = round_wide_8(q_next_w_part_1);  /* F62, |x| <= 0.000978 */
    const int64_t q_next_w_1 = q_nb_w * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_w = q_next_w_1 + q_next_w_part;  /* F62, |x| <= 1.01 */
    const int64_t q_next_x_part_1 = (int64_t)e * q_nb_x;  /* F70 */
    const int64_t q_next_x_part = round_wide_8(q_next_x_part_1);  /* F62, |x| <= 0.000978 */
    const int64_t q_next_x_1 = q_nb_x * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_x = q_next_x_1 + q_next_x_part;  /* F62, |x| <= 1.01 */
    const int64_t q_next_y_part_1 = (int64_t)e * q_nb_y;  /* F70 */
    const int64_t q_next_y_part = round_wide_8(q_next_y_part_1);  /* F62, |x| <= 0.000978 */
    const int64_t q_next_y_1 = q_nb_y * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_y = q_next_y_1 + q_next_y_part;  /* F62, |x| <= 1.01 */
    const int64_t q_next_z_part_1 = (int64_t)e * q_nb_z;  /* F70 */
    const int64_t q_next_z_part = round_wide_8(q_next_z_part_1);  /* F62, |x| <= 0.000978 */
    const int64_t q_next_z_1 = q_nb_z * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_z = q_next_z_1 + q_next_z_part;  /* F62, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->f[0] = 0;
    state->f[1] = 0;
    state->f[2] = 0;
    state->f[3] = 0;
    state->f[4] = 0;
    state->f[5] = 0;
    state->f[6] = 0;
    state->f[7] = 0;
    state->f[8] = 0;
    state->f[9] = 0;
    state->f[10] = 0;
    state->f[11] = 0;
    state->error[0] = 0;
    state->error[1] = 0;
    state->error[2] = 0;
    state->error[3] = 0;
    state->rates[0] = 0;
    state->rates[1] = 0;
    state->rates[2] = 0;
    state->rates[3] = 0;
    state->rates[4] = 0;
    state->rates[5] = 0;
    state->count = 0;
}

void adams_moulton_4_fixed32_compensated_start(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3])
{
    const int32_t omega_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_z = omega[2];  /* F26, |x| <= 10.1 */
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

static void adams_moulton_4_fixed32_compensated_hold(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3])
{
    /* attitude and input */
    const int32_t omega_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_z = omega[2];  /* F26, |x| <= 10.1 */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.21 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.21 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.21 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.21 */

    /* store */
    state->q[0] = q_w_whole;
    state->q[1] = q_x_whole;
    state->q[2] = q_y_whole;
    state->q[3] = q_z_whole;

    /* the sample at the start of the interval */
    const int32_t omega_last_x = state->omega_last[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_y = state->omega_last[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_z = state->omega_last[2];  /* F26, |x| <= 10.1 */

    /* store */
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;

    /* rates taken while the starter waits, oldest first, rad/s */
    const int32_t rates2_x = state->rates[3];  /* F27, |x| <= 10.4 */
    const int32_t rates2_y = state->rates[4];  /* F27, |x| <= 10.4 */
    const int32_t rates2_z = state->rates[5];  /* F27, |x| <= 10.4 */

    /* store */
    state->rates[0] = rates2_x;
    state->rates[1] = rates2_y;
    state->rates[2] = rates2_z;
    const int32_t omega_last_x_2 = omega_last_x * 2;  /* F27, |x| <= 10.1 */
    state->rates[3] = omega_last_x_2;
    const int32_t omega_last_y_2 = omega_last_y * 2;  /* F27, |x| <= 10.1 */
    state->rates[4] = omega_last_y_2;
    const int32_t omega_last_z_2 = omega_last_z * 2;  /* F27, |x| <= 10.1 */
    state->rates[5] = omega_last_z_2;
    state->count = state->count + 1;
}

static void adams_moulton_4_fixed32_compensated_start_up(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3])
{
    /* attitude and input */
    const int32_t omega_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_z = omega[2];  /* F26, |x| <= 10.1 */

    /* rates taken while the starter waits, oldest first, rad/s */
    const int32_t rates1_x = state->rates[0];  /* F27, |x| <= 10.4 */
    const int32_t rates1_y = state->rates[1];  /* F27, |x| <= 10.4 */
    const int32_t rates1_z = state->rates[2];  /* F27, |x| <= 10.4 */
    const int32_t rates2_x = state->rates[3];  /* F27, |x| <= 10.4 */
    const int32_t rates2_y = state->rates[4];  /* F27, |x| <= 10.4 */
    const int32_t rates2_z = state->rates[5];  /* F27, |x| <= 10.4 */

    /* rates in the middle of each interval, from the cubic through four samples */
    const int64_t dq0_w_negated_1 = (int64_t)5 /* 5/16 */ * rates1_x;  /* F31 */
    const int64_t dq0_w_negated_2 = (int64_t)15 /* 15/16 */ * rates2_x;  /* F31 */
    const int64_t dq0_w_negated_3 = dq0_w_negated_1 + dq0_w_negated_2;  /* F31 */
    const int64_t dq0_w_negated_4 = omega_x * INT64_C(2);  /* F31 */
    const int64_t dq0_w_negated_5 = dq0_w_negated_3 + dq0_w_negated_4;  /* F31 */

    /* the sample at the start of the interval */
    const int32_t omega_last_x = state->omega_last[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_y = state->omega_last[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_z = state->omega_last[2];  /* F26, |x| <= 10.1 */

    /* rates in the middle of each interval, from the cubic through four samples */
    const int64_t dq0_w_negated_6 = (int64_t)5 /* 5/16 */ * omega_last_x;  /* F30 */
    const int64_t dq0_w_negated_7 = dq0_w_negated_6 * INT64_C(2);  /* F31 */
    const int64_t dq0_w_negated_8 = dq0_w_negated_5 - dq0_w_negated_7;  /* F31 */
    const int32_t dq0_w_negated_9 = round_5(dq0_w_negated_8);  /* F26, |x| <= 16.7 */
    const int64_t dq0_w_negated_10 = (int64_t)5 /* 5/16 */ * rates1_y;  /* F31 */
    const int64_t dq0_w_negated_11 = (int64_t)15 /* 15/16 */ * rates2_y;  /* F31 */
    const int64_t dq0_w_negated_12 = dq0_w_negated_10 + dq0_w_negated_11;  /* F31 */
    const int64_t dq0_w_negated_13 = omega_y * INT64_C(2);  /* F31 */
    const int64_t dq0_w_negated_14 = dq0_w_negated_12 + dq0_w_negated_13;  /* F31 */
    const int64_t dq0_w_negated_15 = (int64_t)5 /* 5/16 */ * omega_last_y;  /* F30 */
    const int64_t dq0_w_negated_16 = dq0_w_negated_15 * INT64_C(2);  /* F31 */
    const int64_t dq0_w_negated_17 = dq0_w_negated_14 - dq0_w_negated_16;  /* F31 */
    const int32_t dq0_w_negated_18 = round_5(dq0_w_negated_17);  /* F26, |x| <= 16.7 */
    const int64_t dq0_w_negated_19 = (int64_t)5 /* 5/16 */ * rates1_z;  /* F31 */
    const int64_t dq0_w_negated_20 = (int64_t)15 /* 15/16 */ * rates2_z;  /* F31 */
    const int64_t dq0_w_negated_21 = dq0_w_negated_19 + dq0_w_negated_20;  /* F31 */
    const int64_t dq0_w_negated_22 = omega_z * INT64_C(2);  /* F31 */
    const int64_t dq0_w_negated_23 = dq0_w_negated_21 + dq0_w_negated_22;  /* F31 */
    const int64_t dq0_w_negated_24 = (int64_t)5 /* 5/16 */ * omega_last_z;  /* F30 */
    const int64_t dq0_w_negated_25 = dq0_w_negated_24 * INT64_C(2);  /* F31 */
    const int64_t dq0_w_negated_26 = dq0_w_negated_23 - dq0_w_negated_25;  /* F31 */
    const int32_t dq0_w_negated_27 = round_5(dq0_w_negated_26);  /* F26, |x| <= 16.7 */
    const int64_t first_x_1 = (int64_t)9 /* 9/16 */ * rates2_x;  /* F31 */
    const int64_t first_x_2 = (int64_t)9 /* 9/16 */ * omega_last_x;  /* F30 */
    const int64_t first_x_3 = first_x_2 * INT64_C(2);  /* F31 */
    const int64_t first_x_4 = first_x_1 + first_x_3;  /* F31 */
    const int64_t first_x_5 = omega_x * INT64_C(2);  /* F31 */
    const int64_t first_x_6 = rates1_x + first_x_5;  /* F31 */
    const int64_t first_x_7 = first_x_4 - first_x_6;  /* F31 */
    const int32_t first_x_8 = round_4(first_x_7);  /* F27, |x| <= 12.8 */
    const int64_t first_x_9 = (int64_t)9 /* 9/16 */ * rates2_y;  /* F31 */
    const int64_t first_x_10 = (int64_t)9 /* 9/16 */ * omega_last_y;  /* F30 */
    const int64_t first_x_11 = first_x_10 * INT64_C(2);  /* F31 */
    const int64_t first_x_12 = first_x_9 + first_x_11;  /* F31 */
    const int64_t first_x_13 = omega_y * INT64_C(2);  /* F31 */
    const int64_t first_x_14 = rates1_y + first_x_13;  /* F31 */
    const int64_t first_x_15 = first_x_12 - first_x_14;  /* F31 */
    const int32_t first_x_16 = round_4(first_x_15);  /* F27, |x| <= 12.8 */
    const int64_t first_x_17 = (int64_t)9 /* 9/16 */ * rates2_z;  /* F31 */
    const int64_t first_x_18 = (int64_t)9 /* 9/16 */ * omega_last_z;  /* F30 */
    const int64_t first_x_19 = first_x_18 * INT64_C(2);  /* F31 */
    const int64_t first_x_20 = first_x_17 + first_x_19;  /* F31 */
    const int64_t first_x_21 = omega_z * INT64_C(2);  /* F31 */
    const int64_t first_x_22 = rates1_z + first_x_21;  /* F31 */
    const int64_t first_x_23 = first_x_20 - first_x_22;  /* F31 */
    const int32_t first_x_24 = round_4(first_x_23);  /* F27, |x| <= 12.8 */
    const int64_t middle_x_1 = (int64_t)15 /* 15/16 */ * omega_last_x;  /* F30 */
    const int64_t middle_x_2 = middle_x_1 * INT64_C(2);  /* F31 */
    const int64_t middle_x_3 = rates1_x + middle_x_2;  /* F31 */
    const int64_t middle_x_4 = (int64_t)5 /* 5/16 */ * omega_x;  /* F30 */
    const int64_t middle_x_5 = middle_x_4 * INT64_C(2);  /* F31 */
    const int64_t middle_x_6 = middle_x_3 + middle_x_5;  /* F31 */
    const int64_t middle_x_7 = (int64_t)5 /* 5/16 */ * rates2_x;  /* F31 */
    const int64_t middle_x_8 = middle_x_6 - middle_x_7;  /* F31 */
    const int32_t middle_x = round_5(middle_x_8);  /* F26, |x| <= 16.4 */
    const int64_t middle_y_1 = (int64_t)15 /* 15/16 */ * omega_last_y;  /* F30 */
    const int64_t middle_y_2 = middle_y_1 * INT64_C(2);  /* F31 */
    const int64_t middle_y_3 = rates1_y + middle_y_2;  /* F31 */
    const int64_t middle_y_4 = (int64_t)5 /* 5/16 */ * omega_y;  /* F30 */
    const int64_t middle_y_5 = middle_y_4 * INT64_C(2);  /* F31 */
    const int64_t middle_y_6 = middle_y_3 + middle_y_5;  /* F31 */
    const int64_t middle_y_7 = (int64_t)5 /* 5/16 */ * rates2_y;  /* F31 */
    const int64_t middle_y_8 = middle_y_6 - middle_y_7;  /* F31 */
    const int32_t middle_y = round_5(middle_y_8);  /* F26, |x| <= 16.4 */
    const int64_t middle_z_1 = (int64_t)15 /* 15/16 */ * omega_last_z;  /* F30 */
    const int64_t middle_z_2 = middle_z_1 * INT64_C(2);  /* F31 */
    const int64_t middle_z_3 = rates1_z + middle_z_2;  /* F31 */
    const int64_t middle_z_4 = (int64_t)5 /* 5/16 */ * omega_z;  /* F30 */
    const int64_t middle_z_5 = middle_z_4 * INT64_C(2);  /* F31 */
    const int64_t middle_z_6 = middle_z_3 + middle_z_5;  /* F31 */
    const int64_t middle_z_7 = (int64_t)5 /* 5/16 */ * rates2_z;  /* F31 */
    const int64_t middle_z_8 = middle_z_6 - middle_z_7;  /* F31 */
    const int32_t middle_z = round_5(middle_z_8);  /* F26, |x| <= 16.4 */

    /* dq0 = (k1 + k4)/6 + (k2 + k3)/3 of step 1   [Runge-Kutta] */
    const int64_t dq0_x_1 = (int64_t)1374389535 /* 1/400 */ * rates1_x;  /* F66 */
    const int32_t dq0_x_2 = round_30(dq0_x_1);  /* F36, |x| <= 0.0259 */
    const int64_t dq0_x_3 = (int64_t)1374389535 /* 1/400 */ * rates1_y;  /* F66 */
    const int32_t dq0_x_4 = round_30(dq0_x_3);  /* F36, |x| <= 0.0259 */
    const int64_t dq0_x_5 = (int64_t)1374389535 /* 1/400 */ * rates1_z;  /* F66 */
    const int32_t dq0_x_6 = round_30(dq0_x_5);  /* F36, |x| <= 0.0259 */
    const int64_t dq0_w_negated_28 = (int64_t)1374389535 /* 1/400 */ * dq0_w_negated_9;  /* F65 */
    const int32_t dq0_w_negated_29 = round_30(dq0_w_negated_28);  /* F35, |x| <= 0.0417 */
    const int64_t dq0_w_negated_30 = (int64_t)1374389535 /* 1/400 */ * dq0_w_negated_18;  /* F65 */
    const int32_t dq0_w_negated_31 = round_30(dq0_w_negated_30);  /* F35, |x| <= 0.0417 */
    const int64_t dq0_w_negated_32 = (int64_t)1374389535 /* 1/400 */ * dq0_w_negated_27;  /* F65 */
    const int32_t dq0_w_negated_33 = round_30(dq0_w_negated_32);  /* F35, |x| <= 0.0417 */
    const int64_t dq0_w_negated_34 = (int64_t)1374389535 /* 1/400 */ * rates2_x;  /* F66 */
    const int32_t dq0_w_negated_35 = round_30(dq0_w_negated_34);  /* F36, |x| <= 0.0259 */
    const int64_t dq0_w_negated_36 = (int64_t)1374389535 /* 1/400 */ * rates2_y;  /* F66 */
    const int32_t dq0_w_negated_37 = round_30(dq0_w_negated_36);  /* F36, |x| <= 0.0259 */
    const int64_t dq0_w_negated_38 = (int64_t)1374389535 /* 1/400 */ * rates2_z;  /* F66 */
    const int32_t dq0_w_negated_39 = round_30(dq0_w_negated_38);  /* F36, |x| <= 0.0259 */

    /* attitude and input */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.21 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.21 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.21 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.21 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.21 */

    /* dq0 = (k1 + k4)/6 + (k2 + k3)/3 of step 1   [Runge-Kutta] */
    const int64_t dq0_x_7 = (int64_t)q_x * dq0_x_2;  /* F66 */
    const int64_t dq0_x_8 = (int64_t)q_y * dq0_x_4;  /* F66 */
    const int64_t dq0_x_9 = dq0_x_7 + dq0_x_8;  /* F66 */
    const int64_t dq0_x_10 = (int64_t)q_z * dq0_x_6;  /* F66 */
    const int64_t dq0_x_11 = dq0_x_9 + dq0_x_10;  /* F66 */
    const int32_t dq0_x_12 = round_32(dq0_x_11);  /* F34, |x| <= 0.093 */
    const int64_t dq0_w_negated_40 = (int64_t)q_w * dq0_x_2;  /* F66 */
    const int64_t dq0_w_negated_41 = (int64_t)q_y * dq0_x_6;  /* F66 */
    const int64_t dq0_w_negated_42 = dq0_w_negated_40 + dq0_w_negated_41;  /* F66 */
    const int64_t dq0_w_negated_43 = (int64_t)q_z * dq0_x_4;  /* F66 */
    const int64_t dq0_w_negated_44 = dq0_w_negated_42 - dq0_w_negated_43;  /* F66 */
    const int32_t dq0_w_negated_45 = round_31(dq0_w_negated_44);  /* F35, |x| <= 0.031 */
    const int64_t dq0_w_negated_46 = (int64_t)q_w * dq0_x_4;  /* F66 */
    const int64_t dq0_w_negated_47 = (int64_t)q_z * dq0_x_2;  /* F66 */
    const int64_t dq0_w_negated_48 = dq0_w_negated_46 + dq0_w_negated_47;  /* F66 */
    const int64_t dq0_w_negated_49 = (int64_t)q_x * dq0_x_6;  /* F66 */
    const int64_t dq0_w_negated_50 = dq0_w_negated_48 - dq0_w_negated_49;  /* F66 */
    const int32_t dq0_w_negated_51 = round_31(dq0_w_negated_50);  /* F35, |x| <= 0.031 */
    const int64_t dq0_w_negated_52 = (int64_t)q_w * dq0_x_6;  /* F66 */
    const int64_t dq0_w_negated_53 = (int64_t)q_x * dq0_x_4;  /* F66 */
    const int64_t dq0_w_negated_54 = dq0_w_negated_52 + dq0_w_negated_53;  /* F66 */
    const int64_t dq0_w_negated_55 = (int64_t)q_y * dq0_x_2;  /* F66 */
    const int64_t dq0_w_negated_56 = dq0_w_negated_54 - dq0_w_negated_55;  /* F66 */
    const int32_t dq0_w_negated_57 = round_31(dq0_w_negated_56);  /* F35, |x| <= 0.031 */
    const int32_t dq0_x_13 = -dq0_x_12;  /* F35 */
    const int32_t dq0_x_14 = round_short_5(dq0_x_13);  /* F30 */
    const int32_t dq0_x_15 = dq0_x_14 + q_w;  /* F30, |x| <= 1.22 */
    const int32_t dq0_w_negated_58 = round_short_6(dq0_w_negated_45);  /* F30 */
    const int32_t dq0_w_negated_59 = dq0_w_negated_58 + q_x;  /* F30, |x| <= 1.22 */
    const int32_t dq0_w_negated_60 = round_short_6(dq0_w_negated_51);  /* F30 */
    const int32_t dq0_w_negated_61 = dq0_w_negated_60 + q_y;  /* F30, |x| <= 1.22 */
    const int32_t dq0_w_negated_62 = round_short_6(dq0_w_negated_57);  /* F30 */
    const int32_t dq0_w_negated_63 = dq0_w_negated_62 + q_z;  /* F30, |x| <= 1.22 */
    const int64_t dq0_w_negated_64 = (int64_t)dq0_w_negated_59 * dq0_w_negated_29;  /* F65 */
    const int64_t dq0_w_negated_65 = (int64_t)dq0_w_negated_61 * dq0_w_negated_31;  /* F65 */
    const int64_t dq0_w_negated_66 = dq0_w_negated_64 + dq0_w_negated_65;  /* F65 */
    const int64_t dq0_w_negated_67 = (int64_t)dq0_w_negated_63 * dq0_w_negated_33;  /* F65 */
    const int64_t dq0_w_negated_68 = dq0_w_negated_66 + dq0_w_negated_67;  /* F65 */
    const int32_t dq0_w_negated_69 = round_30(dq0_w_negated_68);  /* F35, |x| <= 0.0507 */
    const int32_t dq0_x_16 = -dq0_w_negated_31;  /* F35 */
    const int64_t dq0_x_17 = (int64_t)dq0_x_15 * dq0_w_negated_29;  /* F65 */
    const int64_t dq0_x_18 = (int64_t)dq0_w_negated_61 * dq0_w_negated_33;  /* F65 */
    const int64_t dq0_x_19 = dq0_x_17 + dq0_x_18;  /* F65 */
    const int64_t dq0_x_20 = (int64_t)dq0_w_negated_63 * dq0_x_16;  /* F65 */
    const int64_t dq0_x_21 = dq0_x_19 + dq0_x_20;  /* F65 */
    const int32_t dq0_x_22 = round_30(dq0_x_21);  /* F35, |x| <= 0.0507 */
    const int32_t dq0_x_23 = -dq0_w_negated_33;  /* F35 */
    const int64_t dq0_x_24 = (int64_t)dq0_x_15 * dq0_w_negated_31;  /* F65 */
    const int64_t dq0_x_25 = (int64_t)dq0_w_negated_63 * dq0_w_negated_29;  /* F65 */
    const int64_t dq0_x_26 = dq0_x_24 + dq0_x_25;  /* F65 */
    const int64_t dq0_x_27 = (int64_t)dq0_w_negated_59 * dq0_x_23;  /* F65 */
    const int64_t dq0_x_28 = dq0_x_26 + dq0_x_27;  /* F65 */
    const int32_t dq0_x_29 = round_30(dq0_x_28);  /* F35, |x| <= 0.0507 */
    const int32_t dq0_x_30 = -dq0_w_negated_29;  /* F35 */
    const int64_t dq0_x_31 = (int64_t)dq0_x_15 * dq0_w_negated_33;  /* F65 */
    const int64_t dq0_x_32 = (int64_t)dq0_w_negated_59 * dq0_w_negated_31;  /* F65 */
    const int64_t dq0_x_33 = dq0_x_31 + dq0_x_32;  /* F65 */
    const int64_t dq0_x_34 = (int64_t)dq0_w_negated_61 * dq0_x_30;  /* F65 */
    const int64_t dq0_x_35 = dq0_x_33 + dq0_x_34;  /* F65 */
    const int32_t dq0_x_36 = round_30(dq0_x_35);  /* F35, |x| <= 0.0507 */
    const int32_t dq0_w_negated_70 = -dq0_w_negated_69;  /* F36 */
    const int32_t dq0_w_negated_71 = round_short_6(dq0_w_negated_70);  /* F30 */
    const int32_t dq0_w_negated_72 = dq0_w_negated_71 + q_w;  /* F30, |x| <= 1.23 */
    const int32_t dq0_x_37 = round_short_6(dq0_x_22);  /* F30 */
    const int32_t dq0_x_38 = dq0_x_37 + q_x;  /* F30, |x| <= 1.23 */
    const int32_t dq0_x_39 = round_short_6(dq0_x_29);  /* F30 */
    const int32_t dq0_x_40 = dq0_x_39 + q_y;  /* F30, |x| <= 1.23 */
    const int32_t dq0_x_41 = round_short_6(dq0_x_36);  /* F30 */
    const int32_t dq0_x_42 = dq0_x_41 + q_z;  /* F30, |x| <= 1.23 */
    const int64_t dq0_x_43 = (int64_t)dq0_x_38 * dq0_w_negated_29;  /* F65 */
    const int64_t dq0_x_44 = (int64_t)dq0_x_40 * dq0_w_negated_31;  /* F65 */
    const int64_t dq0_x_45 = dq0_x_43 + dq0_x_44;  /* F65 */
    const int64_t dq0_x_46 = (int64_t)dq0_x_42 * dq0_w_negated_33;  /* F65 */
    const int64_t dq0_x_47 = dq0_x_45 + dq0_x_46;  /* F65 */
    const int32_t dq0_x_48 = round_30(dq0_x_47);  /* F35, |x| <= 0.0511 */
    const int64_t dq0_w_negated_73 = (int64_t)dq0_w_negated_72 * dq0_w_negated_29;  /* F65 */
    const int64_t dq0_w_negated_74 = (int64_t)dq0_x_40 * dq0_w_negated_33;  /* F65 */
    const int64_t dq0_w_negated_75 = dq0_w_negated_73 + dq0_w_negated_74;  /* F65 */
    const int64_t dq0_w_negated_76 = (int64_t)dq0_x_42 * dq0_x_16;  /* F65 */
    const int64_t dq0_w_negated_77 = dq0_w_negated_75 + dq0_w_negated_76;  /* F65 */
    const int32_t dq0_w_negated_78 = round_30(dq0_w_negated_77);  /* F35, |x| <= 0.0511 */
    const int64_t dq0_w_negated_79 = (int64_t)dq0_w_negated_72 * dq0_w_negated_31;  /* F65 */
    const int64_t dq0_w_negated_80 = (int64_t)dq0_x_42 * dq0_w_negated_29;  /* F65 */
    const int64_t dq0_w_negated_81 = dq0_w_negated_79 + dq0_w_negated_80;  /* F65 */
    const int64_t dq0_w_negated_82 = (int64_t)dq0_x_38 * dq0_x_23;  /* F65 */
    const int64_t dq0_w_negated_83 = dq0_w_negated_81 + dq0_w_negated_82;  /* F65 */
    const int32_t dq0_w_negated_84 = round_30(dq0_w_negated_83);  /* F35, |x| <= 0.0511 */
    const int64_t dq0_w_negated_85 = (int64_t)dq0_w_negated_72 * dq0_w_negated_33;  /* F65 */
    const int64_t dq0_w_negated_86 = (int64_t)dq0_x_38 * dq0_w_negated_31;  /* F65 */
    const int64_t dq0_w_negated_87 = dq0_w_negated_85 + dq0_w_negated_86;  /* F65 */
    const int64_t dq0_w_negated_88 = (int64_t)dq0_x_40 * dq0_x_30;  /* F65 */
    const int64_t dq0_w_negated_89 = dq0_w_negated_87 + dq0_w_negated_88;  /* F65 */
    const int32_t dq0_w_negated_90 = round_30(dq0_w_negated_89);  /* F35, |x| <= 0.0511 */
    const int32_t dq0_x_49 = -dq0_x_48;  /* F35 */
    const int32_t dq0_x_50 = round_short_5(dq0_x_49);  /* F30 */
    const int32_t dq0_x_51 = dq0_x_50 + q_w;  /* F30, |x| <= 1.26 */
    const int32_t dq0_w_negated_91 = round_short_5(dq0_w_negated_78);  /* F30 */
    const int32_t dq0_w_negated_92 = dq0_w_negated_91 + q_x;  /* F30, |x| <= 1.26 */
    const int32_t dq0_w_negated_93 = round_short_5(dq0_w_negated_84);  /* F30 */
    const int32_t dq0_w_negated_94 = dq0_w_negated_93 + q_y;  /* F30, |x| <= 1.26 */
    const int32_t dq0_w_negated_95 = round_short_5(dq0_w_negated_90);  /* F30 */
    const int32_t dq0_w_negated_96 = dq0_w_negated_95 + q_z;  /* F30, |x| <= 1.26 */
    const int64_t dq0_w_negated_97 = (int64_t)dq0_w_negated_92 * dq0_w_negated_35;  /* F66 */
    const int64_t dq0_w_negated_98 = (int64_t)dq0_w_negated_94 * dq0_w_negated_37;  /* F66 */
    const int64_t dq0_w_negated_99 = dq0_w_negated_97 + dq0_w_negated_98;  /* F66 */
    const int64_t dq0_w_negated_100 = (int64_t)dq0_w_negated_96 * dq0_w_negated_39;  /* F66 */
    const int64_t dq0_w_negated_101 = dq0_w_negated_99 + dq0_w_negated_100;  /* F66 */
    const int32_t dq0_w_negated_102 = round_32(dq0_w_negated_101);  /* F34, |x| <= 0.0969 */
    const int64_t dq0_w_negated_103 = (int64_t)dq0_x_12 + dq0_w_negated_102;  /* F34 */
    const int32_t dq0_w_negated_104 = (int32_t)dq0_w_negated_103;  /* F34, |x| <= 0.0633 */
    const int32_t dq0_x_52 = -dq0_w_negated_37;  /* F36 */
    const int64_t dq0_x_53 = (int64_t)dq0_x_51 * dq0_w_negated_35;  /* F66 */
    const int64_t dq0_x_54 = (int64_t)dq0_w_negated_94 * dq0_w_negated_39;  /* F66 */
    const int64_t dq0_x_55 = dq0_x_53 + dq0_x_54;  /* F66 */
    const int64_t dq0_x_56 = (int64_t)dq0_w_negated_96 * dq0_x_52;  /* F66 */
    const int64_t dq0_x_57 = dq0_x_55 + dq0_x_56;  /* F66 */
    const int32_t dq0_x_58 = round_32(dq0_x_57);  /* F34, |x| <= 0.0969 */
    const int32_t dq0_x_59 = round_short_1(dq0_w_negated_45);  /* F34 */
    const int32_t dq0_x_60 = dq0_x_59 + dq0_x_58;  /* F34, |x| <= 0.0633 */
    const int32_t dq0_y_1 = -dq0_w_negated_39;  /* F36 */
    const int64_t dq0_y_2 = (int64_t)dq0_x_51 * dq0_w_negated_37;  /* F66 */
    const int64_t dq0_y_3 = (int64_t)dq0_w_negated_96 * dq0_w_negated_35;  /* F66 */
    const int64_t dq0_y_4 = dq0_y_2 + dq0_y_3;  /* F66 */
    const int64_t dq0_y_5 = (int64_t)dq0_w_negated_92 * dq0_y_1;  /* F66 */
    const int64_t dq0_y_6 = dq0_y_4 + dq0_y_5;  /* F66 */
    const int32_t dq0_y_7 = round_32(dq0_y_6);  /* F34, |x| <= 0.0969 */
    const int32_t dq0_y_8 = round_short_1(dq0_w_negated_51);  /* F34 */
    const int32_t dq0_y_9 = dq0_y_8 + dq0_y_7;  /* F34, |x| <= 0.0633 */
    const int32_t dq0_z_1 = -dq0_w_negated_35;  /* F36 */
    const int64_t dq0_z_2 = (int64_t)dq0_x_51 * dq0_w_negated_39;  /* F66 */
    const int64_t dq0_z_3 = (int64_t)dq0_w_negated_92 * dq0_w_negated_37;  /* F66 */
    const int64_t dq0_z_4 = dq0_z_2 + dq0_z_3;  /* F66 */
    const int64_t dq0_z_5 = (int64_t)dq0_w_negated_94 * dq0_z_1;  /* F66 */
    const int64_t dq0_z_6 = dq0_z_4 + dq0_z_5;  /* F66 */
    const int32_t dq0_z_7 = round_32(dq0_z_6);  /* F34, |x| <= 0.0969 */
    const int32_t dq0_z_8 = round_short_1(dq0_w_negated_57);  /* F34 */
    const int32_t dq0_z_9 = dq0_z_8 + dq0_z_7;  /* F34, |x| <= 0.0633 */
    const int64_t dq0_w_negated_105 = (int64_t)dq0_w_negated_69 + dq0_x_48;  /* F35 */
    const int32_t dq0_w_negated_106 = round_1(dq0_w_negated_105);  /* F34, |x| <= 0.102 */
    const int64_t dq0_x_61 = (int64_t)dq0_x_22 + dq0_w_negated_78;  /* F35 */
    const int32_t dq0_x_62 = round_1(dq0_x_61);  /* F34, |x| <= 0.102 */
    const int64_t dq0_y_10 = (int64_t)dq0_x_29 + dq0_w_negated_84;  /* F35 */
    const int32_t dq0_y_11 = round_1(dq0_y_10);  /* F34, |x| <= 0.102 */
    const int64_t dq0_z_10 = (int64_t)dq0_x_36 + dq0_w_negated_90;  /* F35 */
    const int32_t dq0_z_11 = round_1(dq0_z_10);  /* F34, |x| <= 0.102 */
    const int64_t dq0_w_negated_107 = (int64_t)1431655765 /* 1/6 */ * dq0_w_negated_104;  /* F67 */
    const int64_t dq0_w_negated_108 = (int64_t)1431655765 /* 1/3 */ * dq0_w_negated_106;  /* F66 */
    const int64_t dq0_w_negated_109 = dq0_w_negated_108 * INT64_C(2);  /* F67 */
    const int64_t dq0_w_negated_110 = dq0_w_negated_107 + dq0_w_negated_109;  /* F67 */
    const int32_t dq0_w_negated = round_32(dq0_w_negated_110);  /* F35, |x| <= 0.0445 */
    const int64_t dq0_x_63 = (int64_t)1431655765 /* 1/6 */ * dq0_x_60;  /* F67 */
    const int64_t dq0_x_64 = (int64_t)1431655765 /* 1/3 */ * dq0_x_62;  /* F66 */
    const int64_t dq0_x_65 = dq0_x_64 * INT64_C(2);  /* F67 */
    const int64_t dq0_x_66 = dq0_x_63 + dq0_x_65;  /* F67 */
    const int32_t dq0_x = round_32(dq0_x_66);  /* F35, |x| <= 0.0445 */
    const int64_t dq0_y_12 = (int64_t)1431655765 /* 1/6 */ * dq0_y_9;  /* F67 */
    const int64_t dq0_y_13 = (int64_t)1431655765 /* 1/3 */ * dq0_y_11;  /* F66 */
    const int64_t dq0_y_14 = dq0_y_13 * INT64_C(2);  /* F67 */
    const int64_t dq0_y_15 = dq0_y_12 + dq0_y_14;  /* F67 */
    const int32_t dq0_y = round_32(dq0_y_15);  /* F35, |x| <= 0.0445 */
    const int64_t dq0_z_12 = (int64_t)1431655765 /* 1/6 */ * dq0_z_9;  /* F67 */
    const int64_t dq0_z_13 = (int64_t)1431655765 /* 1/3 */ * dq0_z_11;  /* F66 */
    const int64_t dq0_z_14 = dq0_z_13 * INT64_C(2);  /* F67 */
    const int64_t dq0_z_15 = dq0_z_12 + dq0_z_14;  /* F67 */
    const int32_t dq0_z = round_32(dq0_z_15);  /* F35, |x| <= 0.0445 */

    /* dq1 = (k1 + k4)/6 + (k2 + k3)/3 of step 2   [Runge-Kutta] */
    const int32_t first_x_25 = -dq0_w_negated;  /* F35 */
    const int32_t first_x_26 = round_short_5(first_x_25);  /* F30 */
    const int32_t first_x_27 = first_x_26 + q_w;  /* F30, |x| <= 1.25 */
    const int32_t first_w_negated_1 = round_short_5(dq0_x);  /* F30 */
    const int32_t first_w_negated_2 = first_w_negated_1 + q_x;  /* F30, |x| <= 1.25 */
    const int32_t first_w_negated_3 = round_short_5(dq0_y);  /* F30 */
    const int32_t first_w_negated_4 = first_w_negated_3 + q_y;  /* F30, |x| <= 1.25 */
    const int32_t first_w_negated_5 = round_short_5(dq0_z);  /* F30 */
    const int32_t first_w_negated_6 = first_w_negated_5 + q_z;  /* F30, |x| <= 1.25 */
    const int64_t first_x_28 = (int64_t)1374389535 /* 1/400 */ * first_x_8;  /* F66 */
    const int32_t first_x_29 = round_31(first_x_28);  /* F35, |x| <= 0.0318 */
    const int64_t first_x_30 = (int64_t)1374389535 /* 1/400 */ * first_x_16;  /* F66 */
    const int32_t first_x_31 = round_31(first_x_30);  /* F35, |x| <= 0.0318 */
    const int64_t first_x_32 = (int64_t)1374389535 /* 1/400 */ * first_x_24;  /* F66 */
    const int32_t first_x_33 = round_31(first_x_32);  /* F35, |x| <= 0.0318 */
    const int64_t first_x_34 = (int64_t)1374389535 /* 1/400 */ * omega_last_x;  /* F65 */
    const int32_t first_x_35 = round_29(first_x_34);  /* F36, |x| <= 0.0251 */
    const int64_t first_x_36 = (int64_t)1374389535 /* 1/400 */ * omega_last_y;  /* F65 */
    const int32_t first_x_37 = round_29(first_x_36);  /* F36, |x| <= 0.0251 */
    const int64_t first_x_38 = (int64_t)1374389535 /* 1/400 */ * omega_last_z;  /* F65 */
    const int32_t first_x_39 = round_29(first_x_38);  /* F36, |x| <= 0.0251 */
    const int64_t first_w_negated_7 = (int64_t)first_w_negated_2 * dq0_w_negated_35;  /* F66 */
    const int64_t first_w_negated_8 = (int64_t)first_w_negated_4 * dq0_w_negated_37;  /* F66 */
    const int64_t first_w_negated_9 = first_w_negated_7 + first_w_negated_8;  /* F66 */
    const int64_t first_w_negated_10 = (int64_t)first_w_negated_6 * dq0_w_negated_39;  /* F66 */
    const int64_t first_w_negated_11 = first_w_negated_9 + first_w_negated_10;  /* F66 */
    const int32_t first_w_negated_12 = round_32(first_w_negated_11);  /* F34, |x| <= 0.0964 */
    const int64_t first_x_40 = (int64_t)first_x_27 * dq0_w_negated_35;  /* F66 */
    const int64_t first_x_41 = (int64_t)first_w_negated_4 * dq0_w_negated_39;  /* F66 */
    const int64_t first_x_42 = first_x_40 + first_x_41;  /* F66 */
    const int64_t first_x_43 = (int64_t)first_w_negated_6 * dq0_x_52;  /* F66 */
    const int64_t first_x_44 = first_x_42 + first_x_43;  /* F66 */
    const int32_t first_x_45 = round_31(first_x_44);  /* F35, |x| <= 0.0322 */
    const int64_t first_x_46 = (int64_t)first_x_27 * dq0_w_negated_37;  /* F66 */
    const int64_t first_x_47 = (int64_t)first_w_negated_6 * dq0_w_negated_35;  /* F66 */
    const int64_t first_x_48 = first_x_46 + first_x_47;  /* F66 */
    const int64_t first_x_49 = (int64_t)first_w_negated_2 * dq0_y_1;  /* F66 */
    const int64_t first_x_50 = first_x_48 + first_x_49;  /* F66 */
    const int32_t first_x_51 = round_31(first_x_50);  /* F35, |x| <= 0.0322 */
    const int64_t first_x_52 = (int64_t)first_x_27 * dq0_w_negated_39;  /* F66 */
    const int64_t first_x_53 = (int64_t)first_w_negated_2 * dq0_w_negated_37;  /* F66 */
    const int64_t first_x_54 = first_x_52 + first_x_53;  /* F66 */
    const int64_t first_x_55 = (int64_t)first_w_negated_4 * dq0_z_1;  /* F66 */
    const int64_t first_x_56 = first_x_54 + first_x_55;  /* F66 */
    const int32_t first_x_57 = round_31(first_x_56);  /* F35, |x| <= 0.0322 */
    const int32_t first_w_negated_13 = -first_w_negated_12;  /* F35 */
    const int32_t first_w_negated_14 = round_short_5(first_w_negated_13);  /* F30 */
    const int32_t first_w_negated_15 = first_w_negated_14 + first_x_27;  /* F30, |x| <= 1.27 */
    const int32_t first_x_58 = round_short_6(first_x_45);  /* F30 */
    const int32_t first_x_59 = first_x_58 + first_w_negated_2;  /* F30, |x| <= 1.27 */
    const int32_t first_x_60 = round_short_6(first_x_51);  /* F30 */
    const int32_t first_x_61 = first_x_60 + first_w_negated_4;  /* F30, |x| <= 1.27 */
    const int32_t first_x_62 = round_short_6(first_x_57);  /* F30 */
    const int32_t first_x_63 = first_x_62 + first_w_negated_6;  /* F30, |x| <= 1.27 */
    const int64_t first_x_64 = (int64_t)first_x_59 * first_x_29;  /* F65 */
    const int64_t first_x_65 = (int64_t)first_x_61 * first_x_31;  /* F65 */
    const int64_t first_x_66 = first_x_64 + first_x_65;  /* F65 */
    const int64_t first_x_67 = (int64_t)first_x_63 * first_x_33;  /* F65 */
    const int64_t first_x_68 = first_x_66 + first_x_67;  /* F65 */
    const int32_t first_x_69 = round_30(first_x_68);  /* F35, |x| <= 0.0401 */
    const int32_t first_w_negated_16 = -first_x_31;  /* F35 */
    const int64_t first_w_negated_17 = (int64_t)first_w_negated_15 * first_x_29;  /* F65 */
    const int64_t first_w_negated_18 = (int64_t)first_x_61 * first_x_33;  /* F65 */
    const int64_t first_w_negated_19 = first_w_negated_17 + first_w_negated_18;  /* F65 */
    const int64_t first_w_negated_20 = (int64_t)first_x_63 * first_w_negated_16;  /* F65 */
    const int64_t first_w_negated_21 = first_w_negated_19 + first_w_negated_20;  /* F65 */
    const int32_t first_w_negated_22 = round_30(first_w_negated_21);  /* F35, |x| <= 0.0401 */
    const int32_t first_w_negated_23 = -first_x_33;  /* F35 */
    const int64_t first_w_negated_24 = (int64_t)first_w_negated_15 * first_x_31;  /* F65 */
    const int64_t first_w_negated_25 = (int64_t)first_x_63 * first_x_29;  /* F65 */
    const int64_t first_w_negated_26 = first_w_negated_24 + first_w_negated_25;  /* F65 */
    const int64_t first_w_negated_27 = (int64_t)first_x_59 * first_w_negated_23;  /* F65 */
    const int64_t first_w_negated_28 = first_w_negated_26 + first_w_negated_27;  /* F65 */
    const int32_t first_w_negated_29 = round_30(first_w_negated_28);  /* F35, |x| <= 0.0401 */
    const int32_t first_w_negated_30 = -first_x_29;  /* F35 */
    const int64_t first_w_negated_31 = (int64_t)first_w_negated_15 * first_x_33;  /* F65 */
    const int64_t first_w_negated_32 = (int64_t)first_x_59 * first_x_31;  /* F65 */
    const int64_t first_w_negated_33 = first_w_negated_31 + first_w_negated_32;  /* F65 */
    const int64_t first_w_negated_34 = (int64_t)first_x_61 * first_w_negated_30;  /* F65 */
    const int64_t first_w_negated_35 = first_w_negated_33 + first_w_negated_34;  /* F65 */
    const int32_t first_w_negated_36 = round_30(first_w_negated_35);  /* F35, |x| <= 0.0401 */
    const int32_t first_x_70 = -first_x_69;  /* F36 */
    const int32_t first_x_71 = round_short_6(first_x_70);  /* F30 */
    const int32_t first_x_72 = first_x_71 + first_x_27;  /* F30, |x| <= 1.27 */
    const int32_t first_w_negated_37 = round_short_6(first_w_negated_22);  /* F30 */
    const int32_t first_w_negated_38 = first_w_negated_37 + first_w_negated_2;  /* F30, |x| <= 1.27 */
    const int32_t first_w_negated_39 = round_short_6(first_w_negated_29);  /* F30 */
    const int32_t first_w_negated_40 = first_w_negated_39 + first_w_negated_4;  /* F30, |x| <= 1.27 */
    const int32_t first_w_negated_41 = round_short_6(first_w_negated_36);  /* F30 */
    const int32_t first_w_negated_42 = first_w_negated_41 + first_w_negated_6;  /* F30, |x| <= 1.27 */
    const int64_t first_w_negated_43 = (int64_t)first_w_negated_38 * first_x_29;  /* F65 */
    const int64_t first_w_negated_44 = (int64_t)first_w_negated_40 * first_x_31;  /* F65 */
    const int64_t first_w_negated_45 = first_w_negated_43 + first_w_negated_44;  /* F65 */
    const int64_t first_w_negated_46 = (int64_t)first_w_negated_42 * first_x_33;  /* F65 */
    const int64_t first_w_negated_47 = first_w_negated_45 + first_w_negated_46;  /* F65 */
    const int32_t first_w_negated_48 = round_30(first_w_negated_47);  /* F35, |x| <= 0.0402 */
    const int64_t first_x_73 = (int64_t)first_x_72 * first_x_29;  /* F65 */
    const int64_t first_x_74 = (int64_t)first_w_negated_40 * first_x_33;  /* F65 */
    const int64_t first_x_75 = first_x_73 + first_x_74;  /* F65 */
    const int64_t first_x_76 = (int64_t)first_w_negated_42 * first_w_negated_16;  /* F65 */
    const int64_t first_x_77 = first_x_75 + first_x_76;  /* F65 */
    const int32_t first_x_78 = round_30(first_x_77);  /* F35, |x| <= 0.0402 */
    const int64_t first_x_79 = (int64_t)first_x_72 * first_x_31;  /* F65 */
    const int64_t first_x_80 = (int64_t)first_w_negated_42 * first_x_29;  /* F65 */
    const int64_t first_x_81 = first_x_79 + first_x_80;  /* F65 */
    const int64_t first_x_82 = (int64_t)first_w_negated_38 * first_w_negated_23;  /* F65 */
    const int64_t first_x_83 = first_x_81 + first_x_82;  /* F65 */
    const int32_t first_x_84 = round_30(first_x_83);  /* F35, |x| <= 0.0402 */
    const int64_t first_x_85 = (int64_t)first_x_72 * first_x_33;  /* F65 */
    const int64_t first_x_86 = (int64_t)first_w_negated_38 * first_x_31;  /* F65 */
    const int64_t first_x_87 = first_x_85 + first_x_86;  /* F65 */
    const int64_t first_x_88 = (int64_t)first_w_negated_40 * first_w_negated_30;  /* F65 */
    const int64_t first_x_89 = first_x_87 + first_x_88;  /* F65 */
    const int32_t first_x_90 = round_30(first_x_89);  /* F35, |x| <= 0.0402 */
    const int32_t first_w_negated_49 = -first_w_negated_48;  /* F35 */
    const int32_t first_w_negated_50 = round_short_5(first_w_negated_49);  /* F30 */
    const int32_t first_w_negated_51 = first_w_negated_50 + first_x_27;  /* F30, |x| <= 1.29 */
    const int32_t first_x_91 = round_short_5(first_x_78);  /* F30 */
    const int32_t first_x_92 = first_x_91 + first_w_negated_2;  /* F30, |x| <= 1.29 */
    const int32_t first_x_93 = round_short_5(first_x_84);  /* F30 */
    const int32_t first_x_94 = first_x_93 + first_w_negated_4;  /* F30, |x| <= 1.29 */
    const int32_t first_x_95 = round_short_5(first_x_90);  /* F30 */
    const int32_t first_x_96 = first_x_95 + first_w_negated_6;  /* F30, |x| <= 1.29 */
    const int64_t first_x_97 = (int64_t)first_x_92 * first_x_35;  /* F66 */
    const int64_t first_x_98 = (int64_t)first_x_94 * first_x_37;  /* F66 */
    const int64_t first_x_99 = first_x_97 + first_x_98;  /* F66 */
    const int64_t first_x_100 = (int64_t)first_x_96 * first_x_39;  /* F66 */
    const int64_t first_x_101 = first_x_99 + first_x_100;  /* F66 */
    const int32_t first_x_102 = round_32(first_x_101);  /* F34, |x| <= 0.0964 */
    const int64_t first_x_103 = (int64_t)first_w_negated_12 + first_x_102;  /* F34 */
    const int32_t first_x_104 = (int32_t)first_x_103;  /* F34, |x| <= 0.0643 */
    const int32_t first_w_negated_52 = -first_x_37;  /* F36 */
    const int64_t first_w_negated_53 = (int64_t)first_w_negated_51 * first_x_35;  /* F66 */
    const int64_t first_w_negated_54 = (int64_t)first_x_94 * first_x_39;  /* F66 */
    const int64_t first_w_negated_55 = first_w_negated_53 + first_w_negated_54;  /* F66 */
    const int64_t first_w_negated_56 = (int64_t)first_x_96 * first_w_negated_52;  /* F66 */
    const int64_t first_w_negated_57 = first_w_negated_55 + first_w_negated_56;  /* F66 */
    const int32_t first_w_negated_58 = round_32(first_w_negated_57);  /* F34, |x| <= 0.0964 */
    const int32_t first_w_negated_59 = round_short_1(first_x_45);  /* F34 */
    const int32_t first_w_negated_60 = first_w_negated_59 + first_w_negated_58;  /* F34, |x| <= 0.0643 */
    const int32_t first_w_negated_61 = -first_x_39;  /* F36 */
    const int64_t first_w_negated_62 = (int64_t)first_w_negated_51 * first_x_37;  /* F66 */
    const int64_t first_w_negated_63 = (int64_t)first_x_96 * first_x_35;  /* F66 */
    const int64_t first_w_negated_64 = first_w_negated_62 + first_w_negated_63;  /* F66 */
    const int64_t first_w_negated_65 = (int64_t)first_x_92 * first_w_negated_61;  /* F66 */
    const int64_t first_w_negated_66 = first_w_negated_64 + first_w_negated_65;  /* F66 */
    const int32_t first_w_negated_67 = round_32(first_w_negated_66);  /* F34, |x| <= 0.0964 */
    const int32_t first_w_negated_68 = round_short_1(first_x_51);  /* F34 */
    const int32_t first_w_negated_69 = first_w_negated_68 + first_w_negated_67;  /* F34, |x| <= 0.0643 */
    const int32_t first_w_negated_70 = -first_x_35;  /* F36 */
    const int64_t first_w_negated_71 = (int64_t)first_w_negated_51 * first_x_39;  /* F66 */
    const int64_t first_w_negated_72 = (int64_t)first_x_92 * first_x_37;  /* F66 */
    const int64_t first_w_negated_73 = first_w_negated_71 + first_w_negated_72;  /* F66 */
    const int64_t first_w_negated_74 = (int64_t)first_x_94 * first_w_negated_70;  /* F66 */
    const int64_t first_w_negated_75 = first_w_negated_73 + first_w_negated_74;  /* F66 */
    const int32_t first_w_negated_76 = round_32(first_w_negated_75);  /* F34, |x| <= 0.0964 */
    const int32_t first_w_negated_77 = round_short_1(first_x_57);  /* F34 */
    const int32_t first_w_negated_78 = first_w_negated_77 + first_w_negated_76;  /* F34, |x| <= 0.0643 */
    const int64_t first_x_105 = (int64_t)first_x_69 + first_w_negated_48;  /* F35 */
    const int32_t first_x_106 = round_1(first_x_105);  /* F34, |x| <= 0.0802 */
    const int64_t first_w_negated_79 = (int64_t)first_w_negated_22 + first_x_78;  /* F35 */
    const int32_t first_w_negated_80 = round_1(first_w_negated_79);  /* F34, |x| <= 0.0802 */
    const int64_t first_w_negated_81 = (int64_t)first_w_negated_29 + first_x_84;  /* F35 */
    const int32_t first_w_negated_82 = round_1(first_w_negated_81);  /* F34, |x| <= 0.0802 */
    const int64_t first_w_negated_83 = (int64_t)first_w_negated_36 + first_x_90;  /* F35 */
    const int32_t first_w_negated_84 = round_1(first_w_negated_83);  /* F34, |x| <= 0.0802 */

    /* dq2 = (k1 + k4)/6 + (k2 + k3)/3 of step 3   [Runge-Kutta] */
    const int64_t first_x_107 = dq0_w_negated * INT64_C(2147483648);  /* F66 */
    const int64_t first_x_108 = (int64_t)715827883 /* 1/6 */ * first_x_104;  /* F66 */
    const int64_t first_x_109 = first_x_107 + first_x_108;  /* F66 */
    const int64_t first_x_110 = (int64_t)1431655765 /* 1/3 */ * first_x_106;  /* F66 */
    const int64_t first_x_111 = first_x_109 + first_x_110;  /* F66 */
    const int32_t first_x_112 = round_32(first_x_111);  /* F34, |x| <= 0.0819 */
    const int64_t first_w_negated_85 = dq0_x * INT64_C(2147483648);  /* F66 */
    const int64_t first_w_negated_86 = (int64_t)715827883 /* 1/6 */ * first_w_negated_60;  /* F66 */
    const int64_t first_w_negated_87 = first_w_negated_85 + first_w_negated_86;  /* F66 */
    const int64_t first_w_negated_88 = (int64_t)1431655765 /* 1/3 */ * first_w_negated_80;  /* F66 */
    const int64_t first_w_negated_89 = first_w_negated_87 + first_w_negated_88;  /* F66 */
    const int32_t first_w_negated_90 = round_32(first_w_negated_89);  /* F34, |x| <= 0.0819 */
    const int64_t first_w_negated_91 = dq0_y * INT64_C(2147483648);  /* F66 */
    const int64_t first_w_negated_92 = (int64_t)715827883 /* 1/6 */ * first_w_negated_69;  /* F66 */
    const int64_t first_w_negated_93 = first_w_negated_91 + first_w_negated_92;  /* F66 */
    const int64_t first_w_negated_94 = (int64_t)1431655765 /* 1/3 */ * first_w_negated_82;  /* F66 */
    const int64_t first_w_negated_95 = first_w_negated_93 + first_w_negated_94;  /* F66 */
    const int32_t first_w_negated_96 = round_32(first_w_negated_95);  /* F34, |x| <= 0.0819 */
    const int64_t first_w_negated_97 = dq0_z * INT64_C(2147483648);  /* F66 */
    const int64_t first_w_negated_98 = (int64_t)715827883 /* 1/6 */ * first_w_negated_78;  /* F66 */
    const int64_t first_w_negated_99 = first_w_negated_97 + first_w_negated_98;  /* F66 */
    const int64_t first_w_negated_100 = (int64_t)1431655765 /* 1/3 */ * first_w_negated_84;  /* F66 */
    const int64_t first_w_negated_101 = first_w_negated_99 + first_w_negated_100;  /* F66 */
    const int32_t first_w_negated_102 = round_32(first_w_negated_101);  /* F34, |x| <= 0.0819 */
    const int32_t first_x_113 = -first_x_112;  /* F34 */
    const int32_t first_x_114 = round_short_4(first_x_113);  /* F30 */
    const int32_t first_x_115 = first_x_114 + q_w;  /* F30, |x| <= 1.29 */
    const int32_t first_w_negated_103 = round_short_4(first_w_negated_90);  /* F30 */
    const int32_t first_w_negated_104 = first_w_negated_103 + q_x;  /* F30, |x| <= 1.29 */
    const int32_t first_w_negated_105 = round_short_4(first_w_negated_96);  /* F30 */
    const int32_t first_w_negated_106 = first_w_negated_105 + q_y;  /* F30, |x| <= 1.29 */
    const int32_t first_w_negated_107 = round_short_4(first_w_negated_102);  /* F30 */
    const int32_t first_w_negated_108 = first_w_negated_107 + q_z;  /* F30, |x| <= 1.29 */
    const int64_t dq_e_w_1 = (int64_t)1374389535 /* 1/400 */ * middle_x;  /* F65 */
    const int32_t dq_e_w_2 = round_30(dq_e_w_1);  /* F35, |x| <= 0.041 */
    const int64_t dq_e_w_3 = (int64_t)1374389535 /* 1/400 */ * middle_y;  /* F65 */
    const int32_t dq_e_w_4 = round_30(dq_e_w_3);  /* F35, |x| <= 0.041 */
    const int64_t dq_e_w_5 = (int64_t)1374389535 /* 1/400 */ * middle_z;  /* F65 */
    const int32_t dq_e_w_6 = round_30(dq_e_w_5);  /* F35, |x| <= 0.041 */
    const int64_t dq_e_w_7 = (int64_t)1374389535 /* 1/400 */ * omega_x;  /* F65 */
    const int32_t dq_e_w_8 = round_29(dq_e_w_7);  /* F36, |x| <= 0.0251 */
    const int64_t dq_e_w_9 = (int64_t)1374389535 /* 1/400 */ * omega_y;  /* F65 */
    const int32_t dq_e_w_10 = round_29(dq_e_w_9);  /* F36, |x| <= 0.0251 */
    const int64_t dq_e_w_11 = (int64_t)1374389535 /* 1/400 */ * omega_z;  /* F65 */
    const int32_t dq_e_w_12 = round_29(dq_e_w_11);  /* F36, |x| <= 0.0251 */
    const int64_t first_w_negated_109 = (int64_t)first_w_negated_104 * first_x_35;  /* F66 */
    const int64_t first_w_negated_110 = (int64_t)first_w_negated_106 * first_x_37;  /* F66 */
    const int64_t first_w_negated_111 = first_w_negated_109 + first_w_negated_110;  /* F66 */
    const int64_t first_w_negated_112 = (int64_t)first_w_negated_108 * first_x_39;  /* F66 */
    const int64_t first_w_negated_113 = first_w_negated_111 + first_w_negated_112;  /* F66 */
    const int32_t first_w_negated = round_32(first_w_negated_113);  /* F34, |x| <= 0.0962 */
    const int64_t first_x_116 = (int64_t)first_x_115 * first_x_35;  /* F66 */
    const int64_t first_x_117 = (int64_t)first_w_negated_106 * first_x_39;  /* F66 */
    const int64_t first_x_118 = first_x_116 + first_x_117;  /* F66 */
    const int64_t first_x_119 = (int64_t)first_w_negated_108 * first_w_negated_52;  /* F66 */
    const int64_t first_x_120 = first_x_118 + first_x_119;  /* F66 */
    const int32_t first_x = round_31(first_x_120);  /* F35, |x| <= 0.0321 */
    const int64_t first_y_1 = (int64_t)first_x_115 * first_x_37;  /* F66 */
    const int64_t first_y_2 = (int64_t)first_w_negated_108 * first_x_35;  /* F66 */
    const int64_t first_y_3 = first_y_1 + first_y_2;  /* F66 */
    const int64_t first_y_4 = (int64_t)first_w_negated_104 * first_w_negated_61;  /* F66 */
    const int64_t first_y_5 = first_y_3 + first_y_4;  /* F66 */
    const int32_t first_y = round_31(first_y_5);  /* F35, |x| <= 0.0321 */
    const int64_t first_z_1 = (int64_t)first_x_115 * first_x_39;  /* F66 */
    const int64_t first_z_2 = (int64_t)first_w_negated_104 * first_x_37;  /* F66 */
    const int64_t first_z_3 = first_z_1 + first_z_2;  /* F66 */
    const int64_t first_z_4 = (int64_t)first_w_negated_106 * first_w_negated_70;  /* F66 */
    const int64_t first_z_5 = first_z_3 + first_z_4;  /* F66 */
    const int32_t first_z = round_31(first_z_5);  /* F35, |x| <= 0.0321 */
    const int32_t q_next_x_1 = -first_w_negated;  /* F35 */
    const int32_t q_next_x_2 = round_short_5(q_next_x_1);  /* F30 */
    const int32_t q_next_x_3 = q_next_x_2 + first_x_115;  /* F30, |x| <= 1.3 */
    const int32_t dq_e_w_13 = round_short_6(first_x);  /* F30 */
    const int32_t dq_e_w_14 = dq_e_w_13 + first_w_negated_104;  /* F30, |x| <= 1.3 */
    const int32_t dq_e_w_15 = round_short_6(first_y);  /* F30 */
    const int32_t dq_e_w_16 = dq_e_w_15 + first_w_negated_106;  /* F30, |x| <= 1.3 */
    const int32_t dq_e_w_17 = round_short_6(first_z);  /* F30 */
    const int32_t dq_e_w_18 = dq_e_w_17 + first_w_negated_108;  /* F30, |x| <= 1.3 */
    const int64_t dq_e_w_19 = (int64_t)dq_e_w_14 * dq_e_w_2;  /* F65 */
    const int64_t dq_e_w_20 = (int64_t)dq_e_w_16 * dq_e_w_4;  /* F65 */
    const int64_t dq_e_w_21 = dq_e_w_19 + dq_e_w_20;  /* F65 */
    const int64_t dq_e_w_22 = (int64_t)dq_e_w_18 * dq_e_w_6;  /* F65 */
    const int64_t dq_e_w_23 = dq_e_w_21 + dq_e_w_22;  /* F65 */
    const int32_t dq_e_w_24 = round_30(dq_e_w_23);  /* F35, |x| <= 0.0532 */
    const int32_t q_next_x_4 = -dq_e_w_4;  /* F35 */
    const int64_t q_next_x_5 = (int64_t)q_next_x_3 * dq_e_w_2;  /* F65 */
    const int64_t q_next_x_6 = (int64_t)dq_e_w_16 * dq_e_w_6;  /* F65 */
    const int64_t q_next_x_7 = q_next_x_5 + q_next_x_6;  /* F65 */
    const int64_t q_next_x_8 = (int64_t)dq_e_w_18 * q_next_x_4;  /* F65 */
    const int64_t q_next_x_9 = q_next_x_7 + q_next_x_8;  /* F65 */
    const int32_t q_next_x_10 = round_30(q_next_x_9);  /* F35, |x| <= 0.0532 */
    const int32_t q_next_x_11 = -dq_e_w_6;  /* F35 */
    const int64_t q_next_x_12 = (int64_t)q_next_x_3 * dq_e_w_4;  /* F65 */
    const int64_t q_next_x_13 = (int64_t)dq_e_w_18 * dq_e_w_2;  /* F65 */
    const int64_t q_next_x_14 = q_next_x_12 + q_next_x_13;  /* F65 */
    const int64_t q_next_x_15 = (int64_t)dq_e_w_14 * q_next_x_11;  /* F65 */
    const int64_t q_next_x_16 = q_next_x_14 + q_next_x_15;  /* F65 */
    const int32_t q_next_x_17 = round_30(q_next_x_16);  /* F35, |x| <= 0.0532 */
    const int32_t q_next_x_18 = -dq_e_w_2;  /* F35 */
    const int64_t q_next_x_19 = (int64_t)q_next_x_3 * dq_e_w_6;  /* F65 */
    const int64_t q_next_x_20 = (int64_t)dq_e_w_14 * dq_e_w_4;  /* F65 */
    const int64_t q_next_x_21 = q_next_x_19 + q_next_x_20;  /* F65 */
    const int64_t q_next_x_22 = (int64_t)dq_e_w_16 * q_next_x_18;  /* F65 */
    const int64_t q_next_x_23 = q_next_x_21 + q_next_x_22;  /* F65 */
    const int32_t q_next_x_24 = round_30(q_next_x_23);  /* F35, |x| <= 0.0532 */
    const int32_t dq_e_w_25 = -dq_e_w_24;  /* F36 */
    const int32_t dq_e_w_26 = round_short_6(dq_e_w_25);  /* F30 */
    const int32_t dq_e_w_27 = dq_e_w_26 + first_x_115;  /* F30, |x| <= 1.31 */
    const int32_t q_next_x_25 = round_short_6(q_next_x_10);  /* F30 */
    const int32_t q_next_x_26 = q_next_x_25 + first_w_negated_104;  /* F30, |x| <= 1.31 */
    const int32_t q_next_x_27 = round_short_6(q_next_x_17);  /* F30 */
    const int32_t q_next_x_28 = q_next_x_27 + first_w_negated_106;  /* F30, |x| <= 1.31 */
    const int32_t q_next_x_29 = round_short_6(q_next_x_24);  /* F30 */
    const int32_t q_next_x_30 = q_next_x_29 + first_w_negated_108;  /* F30, |x| <= 1.31 */
    const int64_t q_next_x_31 = (int64_t)q_next_x_26 * dq_e_w_2;  /* F65 */
    const int64_t q_next_x_32 = (int64_t)q_next_x_28 * dq_e_w_4;  /* F65 */
    const int64_t q_next_x_33 = q_next_x_31 + q_next_x_32;  /* F65 */
    const int64_t q_next_x_34 = (int64_t)q_next_x_30 * dq_e_w_6;  /* F65 */
    const int64_t q_next_x_35 = q_next_x_33 + q_next_x_34;  /* F65 */
    const int32_t q_next_x_36 = round_30(q_next_x_35);  /* F35, |x| <= 0.0536 */
    const int64_t dq_e_w_28 = (int64_t)dq_e_w_27 * dq_e_w_2;  /* F65 */
    const int64_t dq_e_w_29 = (int64_t)q_next_x_28 * dq_e_w_6;  /* F65 */
    const int64_t dq_e_w_30 = dq_e_w_28 + dq_e_w_29;  /* F65 */
    const int64_t dq_e_w_31 = (int64_t)q_next_x_30 * q_next_x_4;  /* F65 */
    const int64_t dq_e_w_32 = dq_e_w_30 + dq_e_w_31;  /* F65 */
    const int32_t dq_e_w_33 = round_30(dq_e_w_32);  /* F35, |x| <= 0.0536 */
    const int64_t dq_e_w_34 = (int64_t)dq_e_w_27 * dq_e_w_4;  /* F65 */
    const int64_t dq_e_w_35 = (int64_t)q_next_x_30 * dq_e_w_2;  /* F65 */
    const int64_t dq_e_w_36 = dq_e_w_34 + dq_e_w_35;  /* F65 */
    const int64_t dq_e_w_37 = (int64_t)q_next_x_26 * q_next_x_11;  /* F65 */
    const int64_t dq_e_w_38 = dq_e_w_36 + dq_e_w_37;  /* F65 */
    const int32_t dq_e_w_39 = round_30(dq_e_w_38);  /* F35, |x| <= 0.0536 */
    const int64_t dq_e_w_40 = (int64_t)dq_e_w_27 * dq_e_w_6;  /* F65 */
    const int64_t dq_e_w_41 = (int64_t)q_next_x_26 * dq_e_w_4;  /* F65 */
    const int64_t dq_e_w_42 = dq_e_w_40 + dq_e_w_41;  /* F65 */
    const int64_t dq_e_w_43 = (int64_t)q_next_x_28 * q_next_x_18;  /* F65 */
    const int64_t dq_e_w_44 = dq_e_w_42 + dq_e_w_43;  /* F65 */
    const int32_t dq_e_w_45 = round_30(dq_e_w_44);  /* F35, |x| <= 0.0536 */
    const int32_t q_next_x_37 = -q_next_x_36;  /* F35 */
    const int32_t q_next_x_38 = round_short_5(q_next_x_37);  /* F30 */
    const int32_t q_next_x_39 = q_next_x_38 + first_x_115;  /* F30, |x| <= 1.34 */
    const int32_t dq_e_w_46 = round_short_5(dq_e_w_33);  /* F30 */
    const int32_t dq_e_w_47 = dq_e_w_46 + first_w_negated_104;  /* F30, |x| <= 1.34 */
    const int32_t dq_e_w_48 = round_short_5(dq_e_w_39);  /* F30 */
    const int32_t dq_e_w_49 = dq_e_w_48 + first_w_negated_106;  /* F30, |x| <= 1.34 */
    const int32_t dq_e_w_50 = round_short_5(dq_e_w_45);  /* F30 */
    const int32_t dq_e_w_51 = dq_e_w_50 + first_w_negated_108;  /* F30, |x| <= 1.34 */
    const int64_t dq_e_w_52 = (int64_t)dq_e_w_47 * dq_e_w_8;  /* F66 */
    const int64_t dq_e_w_53 = (int64_t)dq_e_w_49 * dq_e_w_10;  /* F66 */
    const int64_t dq_e_w_54 = dq_e_w_52 + dq_e_w_53;  /* F66 */
    const int64_t dq_e_w_55 = (int64_t)dq_e_w_51 * dq_e_w_12;  /* F66 */
    const int64_t dq_e_w_56 = dq_e_w_54 + dq_e_w_55;  /* F66 */
    const int32_t dq_e_w_57 = round_32(dq_e_w_56);  /* F34, |x| <= 0.101 */
    const int64_t dq_e_w_58 = (int64_t)first_w_negated + dq_e_w_57;  /* F34 */
    const int32_t dq_e_w_59 = (int32_t)dq_e_w_58;  /* F34, |x| <= 0.0655 */
    const int64_t q_next_x_40 = (int64_t)q_next_x_39 * dq_e_w_8;  /* F66 */
    const int64_t q_next_x_41 = (int64_t)dq_e_w_49 * dq_e_w_12;  /* F66 */
    const int64_t q_next_x_42 = q_next_x_40 + q_next_x_41;  /* F66 */
    const int64_t q_next_x_43 = (int64_t)dq_e_w_51 * dq_e_w_10;  /* F66 */
    const int64_t q_next_x_44 = q_next_x_42 - q_next_x_43;  /* F66 */
    const int32_t q_next_x_45 = round_32(q_next_x_44);  /* F34, |x| <= 0.101 */
    const int32_t q_next_x_46 = round_short_1(first_x);  /* F34 */
    const int32_t q_next_x_47 = q_next_x_46 + q_next_x_45;  /* F34, |x| <= 0.0655 */
    const int64_t q_next_y_1 = (int64_t)q_next_x_39 * dq_e_w_10;  /* F66 */
    const int64_t q_next_y_2 = (int64_t)dq_e_w_51 * dq_e_w_8;  /* F66 */
    const int64_t q_next_y_3 = q_next_y_1 + q_next_y_2;  /* F66 */
    const int64_t q_next_y_4 = (int64_t)dq_e_w_47 * dq_e_w_12;  /* F66 */
    const int64_t q_next_y_5 = q_next_y_3 - q_next_y_4;  /* F66 */
    const int32_t q_next_y_6 = round_32(q_next_y_5);  /* F34, |x| <= 0.101 */
    const int32_t q_next_y_7 = round_short_1(first_y);  /* F34 */
    const int32_t q_next_y_8 = q_next_y_7 + q_next_y_6;  /* F34, |x| <= 0.0655 */
    const int64_t q_next_z_1 = (int64_t)q_next_x_39 * dq_e_w_12;  /* F66 */
    const int64_t q_next_z_2 = (int64_t)dq_e_w_47 * dq_e_w_10;  /* F66 */
    const int64_t q_next_z_3 = q_next_z_1 + q_next_z_2;  /* F66 */
    const int64_t q_next_z_4 = (int64_t)dq_e_w_49 * dq_e_w_8;  /* F66 */
    const int64_t q_next_z_5 = q_next_z_3 - q_next_z_4;  /* F66 */
    const int32_t q_next_z_6 = round_32(q_next_z_5);  /* F34, |x| <= 0.101 */
    const int32_t q_next_z_7 = round_short_1(first_z);  /* F34 */
    const int32_t q_next_z_8 = q_next_z_7 + q_next_z_6;  /* F34, |x| <= 0.0655 */
    const int64_t dq_e_w_60 = (int64_t)dq_e_w_24 + q_next_x_36;  /* F35 */
    const int32_t dq_e_w_61 = round_1(dq_e_w_60);  /* F34, |x| <= 0.107 */
    const int64_t q_next_x_48 = (int64_t)q_next_x_10 + dq_e_w_33;  /* F35 */
    const int32_t q_next_x_49 = round_1(q_next_x_48);  /* F34, |x| <= 0.107 */
    const int64_t q_next_y_9 = (int64_t)q_next_x_17 + dq_e_w_39;  /* F35 */
    const int32_t q_next_y_10 = round_1(q_next_y_9);  /* F34, |x| <= 0.107 */
    const int64_t q_next_z_9 = (int64_t)q_next_x_24 + dq_e_w_45;  /* F35 */
    const int32_t q_next_z_10 = round_1(q_next_z_9);  /* F34, |x| <= 0.107 */

    /* e = (1 - |q|^2)/2   [renormalisation, folded into the scalar part] */
    const int64_t e_1 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t e_2 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t e_3 = e_1 + e_2;  /* F61 */
    const int64_t e_4 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t e_5 = e_3 + e_4;  /* F61 */
    const int64_t e_6 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t e_7 = e_5 + e_6;  /* F61 */
    const int64_t e_8 = INT64_C(1152921504606846976) /* 1/2 */ - e_7;  /* F61 */
    const int32_t e = round_28(e_8);  /* F33, |x| <= 0.221 */

    /* dq_e = dq + e q */
    const int64_t dq_e_w_62 = (int64_t)e * q_w;  /* F63 */
    const int64_t dq_e_w_63 = dq_e_w_62 * INT64_C(2);  /* F64 */
    const int64_t dq_e_w_64 = first_x_112 * INT64_C(1073741824);  /* F64 */
    const int64_t dq_e_w_65 = (int64_t)178956971 /* 1/6 */ * dq_e_w_59;  /* F64 */
    const int64_t dq_e_w_66 = dq_e_w_64 + dq_e_w_65;  /* F64 */
    const int64_t dq_e_w_67 = (int64_t)357913941 /* 1/3 */ * dq_e_w_61;  /* F64 */
    const int64_t dq_e_w_68 = dq_e_w_66 + dq_e_w_67;  /* F64 */
    const int64_t dq_e_w_69 = dq_e_w_63 - dq_e_w_68;  /* F64 */
    const int64_t dq_e_w = round_wide_2(dq_e_w_69);  /* F62, |x| <= 0.393 */

    /* q_next = q + dq */
    const int64_t q_next_w = q_w_whole + dq_e_w;  /* F62, |x| <= 1.13 */

    /* dq_e = dq + e q */
    const int64_t dq_e_x_1 = (int64_t)e * q_x;  /* F63 */
    const int64_t dq_e_x = round_wide_1(dq_e_x_1);  /* F62, |x| <= 0.265 */

    /* q_next = q + dq */
    const int64_t q_next_x_50 = first_w_negated_90 * INT64_C(268435456);  /* F62 */
    const int64_t q_next_x_51 = q_x_whole + q_next_x_50;  /* F62 */
    const int64_t q_next_x_52 = (int64_t)44739243 /* 1/6 */ * q_next_x_47;  /* F62 */
    const int64_t q_next_x_53 = q_next_x_51 + q_next_x_52;  /* F62 */
    const int64_t q_next_x_54 = (int64_t)89478485 /* 1/3 */ * q_next_x_49;  /* F62 */
    const int64_t q_next_x_55 = q_next_x_53 + q_next_x_54;  /* F62 */
    const int64_t q_next_x = q_next_x_55 + dq_e_x;  /* F62, |x| <= 1.13 */

    /* dq_e = dq + e q */
    const int64_t dq_e_y_1 = (int64_t)e * q_y;  /* F63 */
    const int64_t dq_e_y = round_wide_1(dq_e_y_1);  /* F62, |x| <= 0.265 */

    /* q_next = q + dq */
    const int64_t q_next_y_11 = first_w_negated_96 * INT64_C(268435456);  /* F62 */
    const int64_t q_next_y_12 = q_y_whole + q_next_y_11;  /* F62 */
    const int64_t q_next_y_13 = (int64_t)44739243 /* 1/6 */ * q_next_y_8;  /* F62 */
    const int64_t q_next_y_14 = q_next_y_12 + q_next_y_13;  /* F62 */
    const int64_t q_next_y_15 = (int64_t)89478485 /* 1/3 */ * q_next_y_10;  /* F62 */
    const int64_t q_next_y_16 = q_next_y_14 + q_next_y_15;  /* F62 */
    const int64_t q_next_y = q_next_y_16 + dq_e_y;  /* F62, |x| <= 1.13 */

    /* dq_e = dq + e q */
    const int64_t dq_e_z_1 = (int64_t)e * q_z;  /* F63 */
    const int64_t dq_e_z = round_wide_1(dq_e_z_1);  /* F62, |x| <= 0.265 */

    /* q_next = q + dq */
    const int64_t q_next_z_11 = first_w_negated_102 * INT64_C(268435456);  /* F62 */
    const int64_t q_next_z_12 = q_z_whole + q_next_z_11;  /* F62 */
    const int64_t q_next_z_13 = (int64_t)44739243 /* 1/6 */ * q_next_z_8;  /* F62 */
    const int64_t q_next_z_14 = q_next_z_12 + q_next_z_13;  /* F62 */
    const int64_t q_next_z_15 = (int64_t)89478485 /* 1/3 */ * q_next_z_10;  /* F62 */
    const int64_t q_next_z_16 = q_next_z_14 + q_next_z_15;  /* F62 */
    const int64_t q_next_z = q_next_z_16 + dq_e_z;  /* F62, |x| <= 1.13 */

    /* store */
    const int64_t f_1 = first_w_negated * INT64_C(2);  /* F35 */
    const int64_t f_2 = -f_1;  /* F35 */
    const int32_t f_3 = (int32_t)f_2;  /* F35, |x| <= 0.0321 */
    const int64_t f_4 = first_w_negated_12 * INT64_C(2);  /* F35 */
    const int64_t f_5 = -f_4;  /* F35 */
    const int32_t f_6 = (int32_t)f_5;  /* F35, |x| <= 0.0322 */
    const int64_t f_7 = dq0_x_12 * INT64_C(2);  /* F35 */
    const int64_t f_8 = -f_7;  /* F35 */
    const int32_t f_9 = (int32_t)f_8;  /* F35, |x| <= 0.031 */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
    state->f[0] = f_3;
    state->f[1] = first_x;
    state->f[2] = first_y;
    state->f[3] = first_z;
    state->f[4] = f_6;
    state->f[5] = first_x_45;
    state->f[6] = first_x_51;
    state->f[7] = first_x_57;
    state->f[8] = f_9;
    state->f[9] = dq0_w_negated_45;
    state->f[10] = dq0_w_negated_51;
    state->f[11] = dq0_w_negated_57;
    state->count = state->count + 1;
}

static void adams_moulton_4_fixed32_compensated_steady(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3])
{
    /* attitude and input */
    const int32_t omega_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_z = omega[2];  /* F26, |x| <= 10.1 */

    /* the sample at the start of the interval */
    const int32_t omega_last_x = state->omega_last[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_y = state->omega_last[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_z = state->omega_last[2];  /* F26, |x| <= 10.1 */

    /* g0 = h/2 omega, last */
    const int64_t g0_x_1 = (int64_t)1374389535 /* 1/400 */ * omega_last_x;  /* F65 */
    const int32_t g0_x = round_29(g0_x_1);  /* F36, |x| <= 0.0251 */
    const int64_t g0_y_1 = (int64_t)1374389535 /* 1/400 */ * omega_last_y;  /* F65 */
    const int32_t g0_y = round_29(g0_y_1);  /* F36, |x| <= 0.0251 */
    const int64_t g0_z_1 = (int64_t)1374389535 /* 1/400 */ * omega_last_z;  /* F65 */
    const int32_t g0_z = round_29(g0_z_1);  /* F36, |x| <= 0.0251 */

    /* g1 = h/2 omega, new */
    const int64_t g1_x_1 = (int64_t)1374389535 /* 1/400 */ * omega_x;  /* F65 */
    const int32_t g1_x = round_29(g1_x_1);  /* F36, |x| <= 0.0251 */
    const int64_t g1_y_1 = (int64_t)1374389535 /* 1/400 */ * omega_y;  /* F65 */
    const int32_t g1_y = round_29(g1_y_1);  /* F36, |x| <= 0.0251 */
    const int64_t g1_z_1 = (int64_t)1374389535 /* 1/400 */ * omega_z;  /* F65 */
    const int32_t g1_z = round_29(g1_z_1);  /* F36, |x| <= 0.0251 */

    /* attitude and input */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.21 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.21 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.21 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.21 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.21 */

    /* f0 = q (x) g0 */
    const int64_t f0_w_negated_1 = (int64_t)q_x * g0_x;  /* F66 */
    const int64_t f0_w_negated_2 = (int64_t)q_y * g0_y;  /* F66 */
    const int64_t f0_w_negated_3 = f0_w_negated_1 + f0_w_negated_2;  /* F66 */
    const int64_t f0_w_negated_4 = (int64_t)q_z * g0_z;  /* F66 */
    const int64_t f0_w_negated_5 = f0_w_negated_3 + f0_w_negated_4;  /* F66 */
    const int32_t f0_w_negated = round_32(f0_w_negated_5);  /* F34, |x| <= 0.0901 */
    const int64_t f0_x_1 = (int64_t)q_w * g0_x;  /* F66 */
    const int64_t f0_x_2 = (int64_t)q_y * g0_z;  /* F66 */
    const int64_t f0_x_3 = f0_x_1 + f0_x_2;  /* F66 */
    const int64_t f0_x_4 = (int64_t)q_z * g0_y;  /* F66 */
    const int64_t f0_x_5 = f0_x_3 - f0_x_4;  /* F66 */
    const int32_t f0_x = round_31(f0_x_5);  /* F35, |x| <= 0.0301 */
    const int64_t f0_y_1 = (int64_t)q_w * g0_y;  /* F66 */
    const int64_t f0_y_2 = (int64_t)q_z * g0_x;  /* F66 */
    const int64_t f0_y_3 = f0_y_1 + f0_y_2;  /* F66 */
    const int64_t f0_y_4 = (int64_t)q_x * g0_z;  /* F66 */
    const int64_t f0_y_5 = f0_y_3 - f0_y_4;  /* F66 */
    const int32_t f0_y = round_31(f0_y_5);  /* F35, |x| <= 0.0301 */
    const int64_t f0_z_1 = (int64_t)q_w * g0_z;  /* F66 */
    const int64_t f0_z_2 = (int64_t)q_x * g0_y;  /* F66 */
    const int64_t f0_z_3 = f0_z_1 + f0_z_2;  /* F66 */
    const int64_t f0_z_4 = (int64_t)q_y * g0_x;  /* F66 */
    const int64_t f0_z_5 = f0_z_3 - f0_z_4;  /* F66 */
    const int32_t f0_z = round_31(f0_z_5);  /* F35, |x| <= 0.0301 */

    /* dp = (55 f0 - 59 f1 + 37 f2 - 9 f3)/24   [Adams-Bashforth] */
    const int32_t f0_w_negated_negated = -f0_w_negated;  /* F34 */

    /* slopes of the last steps, newest first: h q', as written q' */
    const int32_t f1_w = state->f[0];  /* F35, |x| <= 0.0331 */
    const int32_t f1_x = state->f[1];  /* F35, |x| <= 0.0331 */
    const int32_t f1_y = state->f[2];  /* F35, |x| <= 0.0331 */
    const int32_t f1_z = state->f[3];  /* F35, |x| <= 0.0331 */
    const int32_t f2_w = state->f[4];  /* F35, |x| <= 0.0331 */
    const int32_t f2_x = state->f[5];  /* F35, |x| <= 0.0331 */
    const int32_t f2_y = state->f[6];  /* F35, |x| <= 0.0331 */
    const int32_t f2_z = state->f[7];  /* F35, |x| <= 0.0331 */
    const int32_t f3_w = state->f[8];  /* F35, |x| <= 0.0331 */
    const int32_t f3_x = state->f[9];  /* F35, |x| <= 0.0331 */
    const int32_t f3_y = state->f[10];  /* F35, |x| <= 0.0331 */
    const int32_t f3_z = state->f[11];  /* F35, |x| <= 0.0331 */

    /* dp = (55 f0 - 59 f1 + 37 f2 - 9 f3)/24   [Adams-Bashforth] */
    const int32_t f1_w_negated = -f1_w;  /* F35 */
    const int64_t dp_w_1 = (int64_t)827675989 /* 37/24 */ * f2_w;  /* F64 */
    const int64_t dp_w_2 = (int64_t)1230329173 /* 55/24 */ * f0_w_negated_negated;  /* F63 */
    const int64_t dp_w_3 = dp_w_2 * INT64_C(2);  /* F64 */
    const int64_t dp_w_4 = dp_w_1 + dp_w_3;  /* F64 */
    const int64_t dp_w_5 = (int64_t)1319807659 /* 59/24 */ * f1_w_negated;  /* F64 */
    const int64_t dp_w_6 = dp_w_4 + dp_w_5;  /* F64 */
    const int64_t dp_w_7 = (int64_t)3 /* 3/8 */ * f3_w;  /* F38 */
    const int64_t dp_w_8 = dp_w_7 * INT64_C(67108864);  /* F64 */
    const int64_t dp_w_9 = dp_w_6 - dp_w_8;  /* F64 */
    const int32_t dp_w = round_31(dp_w_9);  /* F33, |x| <= 0.214 */
    const int32_t f1_x_negated = -f1_x;  /* F35 */
    const int64_t dp_x_1 = (int64_t)1230329173 /* 55/24 */ * f0_x;  /* F64 */
    const int64_t dp_x_2 = dp_x_1 * INT64_C(2);  /* F65 */
    const int64_t dp_x_3 = (int64_t)1319807659 /* 59/24 */ * f1_x_negated;  /* F64 */
    const int64_t dp_x_4 = dp_x_3 * INT64_C(2);  /* F65 */
    const int64_t dp_x_5 = dp_x_2 + dp_x_4;  /* F65 */
    const int64_t dp_x_6 = (int64_t)1655351979 /* 37/24 */ * f2_x;  /* F65 */
    const int64_t dp_x_7 = dp_x_5 + dp_x_6;  /* F65 */
    const int64_t dp_x_8 = (int64_t)3 /* 3/8 */ * f3_x;  /* F38 */
    const int64_t dp_x_9 = dp_x_8 * INT64_C(134217728);  /* F65 */
    const int64_t dp_x_10 = dp_x_7 - dp_x_9;  /* F65 */
    const int32_t dp_x = round_32(dp_x_10);  /* F33, |x| <= 0.214 */
    const int32_t f1_y_negated = -f1_y;  /* F35 */
    const int64_t dp_y_1 = (int64_t)1230329173 /* 55/24 */ * f0_y;  /* F64 */
    const int64_t dp_y_2 = dp_y_1 * INT64_C(2);  /* F65 */
    const int64_t dp_y_3 = (int64_t)1319807659 /* 59/24 */ * f1_y_negated;  /* F64 */
    const int64_t dp_y_4 = dp_y_3 * INT64_C(2);  /* F65 */
    const int64_t dp_y_5 = dp_y_2 + dp_y_4;  /* F65 */
    const int64_t dp_y_6 = (int64_t)1655351979 /* 37/24 */ * f2_y;  /* F65 */
    const int64_t dp_y_7 = dp_y_5 + dp_y_6;  /* F65 */
    const int64_t dp_y_8 = (int64_t)3 /* 3/8 */ * f3_y;  /* F38 */
    const int64_t dp_y_9 = dp_y_8 * INT64_C(134217728);  /* F65 */
    const int64_t dp_y_10 = dp_y_7 - dp_y_9;  /* F65 */
    const int32_t dp_y = round_32(dp_y_10);  /* F33, |x| <= 0.214 */
    const int32_t f1_z_negated = -f1_z;  /* F35 */
    const int64_t dp_z_1 = (int64_t)1230329173 /* 55/24 */ * f0_z;  /* F64 */
    const int64_t dp_z_2 = dp_z_1 * INT64_C(2);  /* F65 */
    const int64_t dp_z_3 = (int64_t)1319807659 /* 59/24 */ * f1_z_negated;  /* F64 */
    const int64_t dp_z_4 = dp_z_3 * INT64_C(2);  /* F65 */
    const int64_t dp_z_5 = dp_z_2 + dp_z_4;  /* F65 */
    const int64_t dp_z_6 = (int64_t)1655351979 /* 37/24 */ * f2_z;  /* F65 */
    const int64_t dp_z_7 = dp_z_5 + dp_z_6;  /* F65 */
    const int64_t dp_z_8 = (int64_t)3 /* 3/8 */ * f3_z;  /* F38 */
    const int64_t dp_z_9 = dp_z_8 * INT64_C(134217728);  /* F65 */
    const int64_t dp_z_10 = dp_z_7 - dp_z_9;  /* F65 */
    const int32_t dp_z = round_32(dp_z_10);  /* F33, |x| <= 0.214 */

    /* p = q + dp   [Adams-Bashforth] */
    const int32_t p_w_fine = round_short_3(dp_w);  /* F30 */
    const int32_t p_w = p_w_fine + q_w;  /* F30, |x| <= 1.42 */
    const int32_t p_x_fine = round_short_3(dp_x);  /* F30 */
    const int32_t p_x = p_x_fine + q_x;  /* F30, |x| <= 1.42 */
    const int32_t p_y_fine = round_short_3(dp_y);  /* F30 */
    const int32_t p_y = p_y_fine + q_y;  /* F30, |x| <= 1.42 */
    const int32_t p_z_fine = round_short_3(dp_z);  /* F30 */
    const int32_t p_z = p_z_fine + q_z;  /* F30, |x| <= 1.42 */

    /* fp = p (x) g1 */
    const int64_t fp_w_negated_1 = (int64_t)p_x * g1_x;  /* F66 */
    const int64_t fp_w_negated_2 = (int64_t)p_y * g1_y;  /* F66 */
    const int64_t fp_w_negated_3 = fp_w_negated_1 + fp_w_negated_2;  /* F66 */
    const int64_t fp_w_negated_4 = (int64_t)p_z * g1_z;  /* F66 */
    const int64_t fp_w_negated_5 = fp_w_negated_3 + fp_w_negated_4;  /* F66 */
    const int32_t fp_w_negated = round_31(fp_w_negated_5);  /* F35, |x| <= 0.0354 */
    const int64_t fp_x_1 = (int64_t)p_w * g1_x;  /* F66 */
    const int64_t fp_x_2 = (int64_t)p_y * g1_z;  /* F66 */
    const int64_t fp_x_3 = fp_x_1 + fp_x_2;  /* F66 */
    const int64_t fp_x_4 = (int64_t)p_z * g1_y;  /* F66 */
    const int64_t fp_x_5 = fp_x_3 - fp_x_4;  /* F66 */
    const int32_t fp_x = round_31(fp_x_5);  /* F35, |x| <= 0.0354 */
    const int64_t fp_y_1 = (int64_t)p_w * g1_y;  /* F66 */
    const int64_t fp_y_2 = (int64_t)p_z * g1_x;  /* F66 */
    const int64_t fp_y_3 = fp_y_1 + fp_y_2;  /* F66 */
    const int64_t fp_y_4 = (int64_t)p_x * g1_z;  /* F66 */
    const int64_t fp_y_5 = fp_y_3 - fp_y_4;  /* F66 */
    const int32_t fp_y = round_31(fp_y_5);  /* F35, |x| <= 0.0354 */
    const int64_t fp_z_1 = (int64_t)p_w * g1_z;  /* F66 */
    const int64_t fp_z_2 = (int64_t)p_x * g1_y;  /* F66 */
    const int64_t fp_z_3 = fp_z_1 + fp_z_2;  /* F66 */
    const int64_t fp_z_4 = (int64_t)p_y * g1_x;  /* F66 */
    const int64_t fp_z_5 = fp_z_3 - fp_z_4;  /* F66 */
    const int32_t fp_z = round_31(fp_z_5);  /* F35, |x| <= 0.0354 */

    /* dq = (9 fp + 19 f0 - 5 f1 + f2)/24   [Adams-Moulton] */
    const int64_t dq_w_1 = (int64_t)89478485 /* 1/24 */ * f2_w;  /* F66 */
    const int64_t dq_w_2 = (int64_t)1700091221 /* 19/24 */ * f0_w_negated_negated;  /* F65 */
    const int64_t dq_w_3 = dq_w_2 * INT64_C(2);  /* F66 */
    const int64_t dq_w_4 = dq_w_1 + dq_w_3;  /* F66 */
    const int64_t dq_w_5 = (int64_t)447392427 /* 5/24 */ * f1_w_negated;  /* F66 */
    const int64_t dq_w_6 = dq_w_4 + dq_w_5;  /* F66 */
    const int64_t dq_w_7 = (int64_t)3 /* 3/8 */ * fp_w_negated;  /* F38 */
    const int64_t dq_w_8 = dq_w_7 * INT64_C(268435456);  /* F66 */
    const int64_t dq_w_9 = dq_w_6 - dq_w_8;  /* F66 */
    const int32_t dq_w = round_31(dq_w_9);  /* F35, |x| <= 0.0453 */
    const int64_t dq_x_1 = (int64_t)3 /* 3/8 */ * fp_x;  /* F38 */
    const int64_t dq_x_2 = dq_x_1 * INT64_C(536870912);  /* F67 */
    const int64_t dq_x_3 = (int64_t)1700091221 /* 19/24 */ * f0_x;  /* F66 */
    const int64_t dq_x_4 = dq_x_3 * INT64_C(2);  /* F67 */
    const int64_t dq_x_5 = dq_x_2 + dq_x_4;  /* F67 */
    const int64_t dq_x_6 = (int64_t)894784853 /* 5/24 */ * f1_x_negated;  /* F67 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F67 */
    const int64_t dq_x_8 = (int64_t)178956971 /* 1/24 */ * f2_x;  /* F67 */
    const int64_t dq_x_9 = dq_x_7 + dq_x_8;  /* F67 */
    const int32_t dq_x = round_32(dq_x_9);  /* F35, |x| <= 0.0453 */
    const int64_t dq_y_1 = (int64_t)3 /* 3/8 */ * fp_y;  /* F38 */
    const int64_t dq_y_2 = dq_y_1 * INT64_C(536870912);  /* F67 */
    const int64_t dq_y_3 = (int64_t)1700091221 /* 19/24 */ * f0_y;  /* F66 */
    const int64_t dq_y_4 = dq_y_3 * INT64_C(2);  /* F67 */
    const int64_t dq_y_5 = dq_y_2 + dq_y_4;  /* F67 */
    const int64_t dq_y_6 = (int64_t)894784853 /* 5/24 */ * f1_y_negated;  /* F67 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F67 */
    const int64_t dq_y_8 = (int64_t)178956971 /* 1/24 */ * f2_y;  /* F67 */
    const int64_t dq_y_9 = dq_y_7 + dq_y_8;  /* F67 */
    const int32_t dq_y = round_32(dq_y_9);  /* F35, |x| <= 0.0453 */
    const int64_t dq_z_1 = (int64_t)3 /* 3/8 */ * fp_z;  /* F38 */
    const int64_t dq_z_2 = dq_z_1 * INT64_C(536870912);  /* F67 */
    const int64_t dq_z_3 = (int64_t)1700091221 /* 19/24 */ * f0_z;  /* F66 */
    const int64_t dq_z_4 = dq_z_3 * INT64_C(2);  /* F67 */
    const int64_t dq_z_5 = dq_z_2 + dq_z_4;  /* F67 */
    const int64_t dq_z_6 = (int64_t)894784853 /* 5/24 */ * f1_z_negated;  /* F67 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F67 */
    const int64_t dq_z_8 = (int64_t)178956971 /* 1/24 */ * f2_z;  /* F67 */
    const int64_t dq_z_9 = dq_z_7 + dq_z_8;  /* F67 */
    const int32_t dq_z = round_32(dq_z_9);  /* F35, |x| <= 0.0453 */

    /* error = -19/270 (dq - dp)   [Milne] */
    const int64_t error_w_1 = dp_w * INT64_C(4);  /* F35 */
    const int64_t error_w_2 = dq_w - error_w_1;  /* F35 */
    const int32_t error_w_3 = round_3(error_w_2);  /* F32, |x| <= 0.259 */
    const int64_t error_x_1 = dp_x * INT64_C(4);  /* F35 */
    const int64_t error_x_2 = dq_x - error_x_1;  /* F35 */
    const int32_t error_x_3 = round_3(error_x_2);  /* F32, |x| <= 0.259 */
    const int64_t error_y_1 = dp_y * INT64_C(4);  /* F35 */
    const int64_t error_y_2 = dq_y - error_y_1;  /* F35 */
    const int32_t error_y_3 = round_3(error_y_2);  /* F32, |x| <= 0.259 */
    const int64_t error_z_1 = dp_z * INT64_C(4);  /* F35 */
    const int64_t error_z_2 = dq_z - error_z_1;  /* F35 */
    const int32_t error_z_3 = round_3(error_z_2);  /* F32, |x| <= 0.259 */
    const int64_t error_w_4 = (int64_t)1208953757 /* 19/270 */ * error_w_3;  /* F66 */
    const int64_t error_w_5 = -error_w_4;  /* F66 */
    const int32_t error_w = round_30(error_w_5);  /* F36, |x| <= 0.0183 */
    const int64_t error_x_4 = (int64_t)1208953757 /* 19/270 */ * error_x_3;  /* F66 */
    const int64_t error_x_5 = -error_x_4;  /* F66 */
    const int32_t error_x = round_30(error_x_5);  /* F36, |x| <= 0.0183 */
    const int64_t error_y_4 = (int64_t)1208953757 /* 19/270 */ * error_y_3;  /* F66 */
    const int64_t error_y_5 = -error_y_4;  /* F66 */
    const int32_t error_y = round_30(error_y_5);  /* F36, |x| <= 0.0183 */
    const int64_t error_z_4 = (int64_t)1208953757 /* 19/270 */ * error_z_3;  /* F66 */
    const int64_t error_z_5 = -error_z_4;  /* F66 */
    const int32_t error_z = round_30(error_z_5);  /* F36, |x| <= 0.0183 */

    /* e = (1 - |q|^2)/2   [renormalisation, folded into the scalar part] */
    const int64_t e_1 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t e_2 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t e_3 = e_1 + e_2;  /* F61 */
    const int64_t e_4 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t e_5 = e_3 + e_4;  /* F61 */
    const int64_t e_6 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t e_7 = e_5 + e_6;  /* F61 */
    const int64_t e_8 = INT64_C(1152921504606846976) /* 1/2 */ - e_7;  /* F61 */
    const int32_t e = round_28(e_8);  /* F33, |x| <= 0.221 */

    /* dq_e = dq + e q */
    const int64_t dq_e_w_1 = dq_w * INT64_C(268435456);  /* F63 */
    const int64_t dq_e_w_2 = (int64_t)e * q_w;  /* F63 */
    const int64_t dq_e_w_3 = dq_e_w_1 + dq_e_w_2;  /* F63 */
    const int64_t dq_e_w = round_wide_1(dq_e_w_3);  /* F62, |x| <= 0.31 */

    /* q_next = q + dq */
    const int64_t q_next_w = q_w_whole + dq_e_w;  /* F62, |x| <= 1.05 */

    /* dq_e = dq + e q */
    const int64_t dq_e_x_1 = dq_x * INT64_C(268435456);  /* F63 */
    const int64_t dq_e_x_2 = (int64_t)e * q_x;  /* F63 */
    const int64_t dq_e_x_3 = dq_e_x_1 + dq_e_x_2;  /* F63 */
    const int64_t dq_e_x = round_wide_1(dq_e_x_3);  /* F62, |x| <= 0.31 */

    /* q_next = q + dq */
    const int64_t q_next_x = q_x_whole + dq_e_x;  /* F62, |x| <= 1.05 */

    /* dq_e = dq + e q */
    const int64_t dq_e_y_1 = dq_y * INT64_C(268435456);  /* F63 */
    const int64_t dq_e_y_2 = (int64_t)e * q_y;  /* F63 */
    const int64_t dq_e_y_3 = dq_e_y_1 + dq_e_y_2;  /* F63 */
    const int64_t dq_e_y = round_wide_1(dq_e_y_3);  /* F62, |x| <= 0.31 */

    /* q_next = q + dq */
    const int64_t q_next_y = q_y_whole + dq_e_y;  /* F62, |x| <= 1.05 */

    /* dq_e = dq + e q */
    const int64_t dq_e_z_1 = dq_z * INT64_C(268435456);  /* F63 */
    const int64_t dq_e_z_2 = (int64_t)e * q_z;  /* F63 */
    const int64_t dq_e_z_3 = dq_e_z_1 + dq_e_z_2;  /* F63 */
    const int64_t dq_e_z = round_wide_1(dq_e_z_3);  /* F62, |x| <= 0.31 */

    /* q_next = q + dq */
    const int64_t q_next_z = q_z_whole + dq_e_z;  /* F62, |x| <= 1.05 */

    /* store */
    const int64_t f_1 = f0_w_negated * INT64_C(2);  /* F35 */
    const int64_t f_2 = -f_1;  /* F35 */
    const int32_t f_3 = (int32_t)f_2;  /* F35, |x| <= 0.0301 */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
    state->f[0] = f_3;
    state->f[1] = f0_x;
    state->f[2] = f0_y;
    state->f[3] = f0_z;
    state->f[4] = f1_w;
    state->f[5] = f1_x;
    state->f[6] = f1_y;
    state->f[7] = f1_z;
    state->f[8] = f2_w;
    state->f[9] = f2_x;
    state->f[10] = f2_y;
    state->f[11] = f2_z;
    state->error[0] = error_w;
    state->error[1] = error_x;
    state->error[2] = error_y;
    state->error[3] = error_z;
}

void adams_moulton_4_fixed32_compensated_update(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3])
{
    /* the history is full after 3 updates */
    if (state->count < 2) {
        adams_moulton_4_fixed32_compensated_hold(state, omega);
    } else if (state->count < 3) {
        adams_moulton_4_fixed32_compensated_start_up(state, omega);
    } else {
        adams_moulton_4_fixed32_compensated_steady(state, omega);
    }
}

void adams_moulton_4_fixed32_compensated_quaternion(
    const adams_moulton_4_fixed32_compensated_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.21 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.21 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.21 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.21 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.21 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.21 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}

void adams_moulton_4_fixed32_compensated_error_estimate(
    const adams_moulton_4_fixed32_compensated_state *state, int32_t e[4])
{
    const int32_t error_w = state->error[0];  /* F36, |x| <= 0.0188 */
    const int32_t error_x = state->error[1];  /* F36, |x| <= 0.0188 */
    const int32_t error_y = state->error[2];  /* F36, |x| <= 0.0188 */
    const int32_t error_z = state->error[3];  /* F36, |x| <= 0.0188 */
    e[0] = error_w;
    e[1] = error_x;
    e[2] = error_y;
    e[3] = error_z;
}

int adams_moulton_4_fixed32_compensated_ready(const adams_moulton_4_fixed32_compensated_state *state)
{
    /* the attitude is current from update 3 on */
    return (state->count >= 3) ? 1 : 0;
}
