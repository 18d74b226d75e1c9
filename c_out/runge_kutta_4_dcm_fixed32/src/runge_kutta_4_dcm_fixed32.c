/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_dcm_fixed32
 *
 * qcone 0.1.0, design runge_kutta_4_dcm_fixed32, SHA-256 of the design
 * f10c0c64b8ffa32ea1aed0af5f5d2f604445c14feb6a5288b7bae7716d20db52
 *
 * algorithm:   runge-kutta-4-dcm, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = C [omega x]; C + h (k1 + 2 k2 + 2 k3 + k4)/6, row by row
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad;
 *              length of a row of C, less 1, <= 0.15 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 1.6e-08 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  9 of 45 rounded sums of products drop a whole word, 3 before formats were searched
 *              for that; of one update's errors in the first order it made 2.9e-08 of 2.5e-08
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      107       0   54        32       0       0     0     0     0       0      0
 * update shared           93      14   54        32       0       0     0     0     0       0      0
 * update emitted          93       0   81         5      10       0     0     0     0       0     87
 * dcm as-written           0       0    0         0       0       0     0     0     0       0      0
 * dcm shared               0       0    0         0       0       0     0     0     0       0      0
 * dcm emitted              0       0    0         0       0       0     0     0     0       0      0
 * euler as-written       100       0   59        30       9       3     0     0    29      69      0
 * euler shared            69      29   59        30       9       3     0     0    29      69      0
 * euler emitted           69       0   52        36      12       3     0     0    29     108    171
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "runge_kutta_4_dcm_fixed32.h"

#if RUNGE_KUTTA_4_DCM_FIXED32_VERSION != 1
#error "runge_kutta_4_dcm_fixed32.h is of another version than this file: generate both again"
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

/* x, kept from low to high. */
static inline int32_t clamp_32(int32_t x, int32_t low, int32_t high)
{
    return ((x < low) ? low : ((x > high) ? high : x));
}

/* x, kept from low to high. */
static inline int64_t clamp_64(int64_t x, int64_t low, int64_t high)
{
    return ((x < low) ? low : ((x > high) ? high : x));
}

/* x, kept from low to high. */
static inline int32_t clamp_64_to_32(int64_t x, int64_t low, int64_t high)
{
    return (int32_t)((x < low) ? low : ((x > high) ? high : x));
}

/* x / 2^1, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_1(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1)) >> 1);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^2, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_2(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(2)) >> 2);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^21, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_21(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1048576)) >> 21);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^26, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_26(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(33554432)) >> 26);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^27, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_27(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(67108864)) >> 27);
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

/* x / 2^33, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_33(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(4294967296), 33);
}

/* x / 2^34, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_34(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(8589934592), 34);
}

/* x / 2^35, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_35(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(17179869184), 35);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int32_t round_short_1(int32_t x)
{
    return shift_right_32(x + 1, 1);
}

/* x / 2^2, rounded to nearest, halves up. */
static inline int32_t round_short_2(int32_t x)
{
    return shift_right_32(x + 2, 2);
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

/* x / 2^8, rounded to nearest, halves up. */
static inline int32_t round_short_8(int32_t x)
{
    return shift_right_32(x + 128, 8);
}

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

void runge_kutta_4_dcm_fixed32_init(runge_kutta_4_dcm_fixed32_state *state)
{
    state->c[0] = 1073741824 /* 1 */;
    state->c[1] = 0;
    state->c[2] = 0;
    state->c[3] = 0;
    state->c[4] = 1073741824 /* 1 */;
    state->c[5] = 0;
    state->c[6] = 0;
    state->c[7] = 0;
    state->c[8] = 1073741824 /* 1 */;
    state->omega_last[0] = 0;
    state->omega_last[1] = 0;
    state->omega_last[2] = 0;
}

void runge_kutta_4_dcm_fixed32_set_dcm(runge_kutta_4_dcm_fixed32_state *state, const int32_t c_nb[9])
{
    /* c_nb, read once */
    const int32_t c_nb_11 = c_nb[0];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_12 = c_nb[1];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_13 = c_nb[2];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_21 = c_nb[3];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_22 = c_nb[4];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_23 = c_nb[5];  /* F30, |x| <= 1.01 */

    /* e_a = (1 - |a|^2)/2 */
    const int64_t e_a_1 = (int64_t)c_nb_11 * c_nb_11;  /* F60 */
    const int64_t e_a_2 = (int64_t)c_nb_12 * c_nb_12;  /* F60 */
    const int64_t e_a_3 = e_a_1 + e_a_2;  /* F61 */
    const int64_t e_a_4 = (int64_t)c_nb_13 * c_nb_13;  /* F60 */
    const int64_t e_a_5 = e_a_3 + e_a_4;  /* F61 */
    const int64_t e_a_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_a_5;  /* F61 */
    const int32_t e_a = round_21(e_a_6);  /* F40, |x| <= 0.000978 */

    /* e_b = (1 - |b|^2)/2 */
    const int64_t e_b_1 = (int64_t)c_nb_21 * c_nb_21;  /* F60 */
    const int64_t e_b_2 = (int64_t)c_nb_22 * c_nb_22;  /* F60 */
    const int64_t e_b_3 = e_b_1 + e_b_2;  /* F61 */
    const int64_t e_b_4 = (int64_t)c_nb_23 * c_nb_23;  /* F60 */
    const int64_t e_b_5 = e_b_3 + e_b_4;  /* F61 */
    const int64_t e_b_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_b_5;  /* F61 */
    const int32_t e_b = round_29(e_b_6);  /* F32, |x| <= 0.000978 */

    /* e_ab = a . b */
    const int64_t e_ab_1 = (int64_t)c_nb_11 * c_nb_21;  /* F60 */
    const int64_t e_ab_2 = (int64_t)c_nb_12 * c_nb_22;  /* F60 */
    const int64_t e_ab_3 = e_ab_1 + e_ab_2;  /* F60 */
    const int64_t e_ab_4 = (int64_t)c_nb_13 * c_nb_23;  /* F60 */
    const int64_t e_ab_5 = e_ab_3 + e_ab_4;  /* F60 */
    const int32_t e_ab = round_30(e_ab_5);  /* F30, |x| <= 1.01 */

    /* a_next = a + e_a a */
    const int64_t a_next_x_part_1 = (int64_t)e_a * c_nb_11;  /* F70 */
    const int32_t a_next_x_part = round_30(a_next_x_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t a_next_x_fine = round_short_10(a_next_x_part);  /* F30 */
    const int32_t a_next_x = a_next_x_fine + c_nb_11;  /* F30, |x| <= 1.01 */
    const int64_t a_next_y_part_1 = (int64_t)e_a * c_nb_12;  /* F70 */
    const int32_t a_next_y_part = round_30(a_next_y_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t a_next_y_fine = round_short_10(a_next_y_part);  /* F30 */
    const int32_t a_next_y = a_next_y_fine + c_nb_12;  /* F30, |x| <= 1.01 */
    const int64_t a_next_z_part_1 = (int64_t)e_a * c_nb_13;  /* F70 */
    const int32_t a_next_z_part = round_30(a_next_z_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t a_next_z_fine = round_short_10(a_next_z_part);  /* F30 */
    const int32_t a_next_z = a_next_z_fine + c_nb_13;  /* F30, |x| <= 1.01 */

    /* b_next = b + e_b b - e_ab a */
    const int32_t e_ab_negated = -e_ab;  /* F30 */
    const int64_t b_next_x_part_1 = (int64_t)e_b * c_nb_21;  /* F62 */
    const int64_t b_next_x_part_2 = (int64_t)e_ab_negated * c_nb_11;  /* F60 */
    const int64_t b_next_x_part_3 = b_next_x_part_2 * INT64_C(4);  /* F62 */
    const int64_t b_next_x_part_4 = b_next_x_part_1 + b_next_x_part_3;  /* F62 */
    const int32_t b_next_x_part = round_32(b_next_x_part_4);  /* F30, |x| <= 1.01 */
    const int64_t b_next_x_1 = (int64_t)c_nb_21 + b_next_x_part;  /* F30 */
    const int32_t b_next_x = (int32_t)b_next_x_1;  /* F30, |x| <= 1.01 */
    const int64_t b_next_y_part_1 = (int64_t)e_b * c_nb_22;  /* F62 */
    const int64_t b_next_y_part_2 = (int64_t)e_ab_negated * c_nb_12;  /* F60 */
    const int64_t b_next_y_part_3 = b_next_y_part_2 * INT64_C(4);  /* F62 */
    const int64_t b_next_y_part_4 = b_next_y_part_1 + b_next_y_part_3;  /* F62 */
    const int32_t b_next_y_part = round_32(b_next_y_part_4);  /* F30, |x| <= 1.01 */
    const int64_t b_next_y_1 = (int64_t)c_nb_22 + b_next_y_part;  /* F30 */
    const int32_t b_next_y = (int32_t)b_next_y_1;  /* F30, |x| <= 1.01 */
    const int64_t b_next_z_part_1 = (int64_t)e_b * c_nb_23;  /* F62 */
    const int64_t b_next_z_part_2 = (int64_t)e_ab_negated * c_nb_13;  /* F60 */
    const int64_t b_next_z_part_3 = b_next_z_part_2 * INT64_C(4);  /* F62 */
    const int64_t b_next_z_part_4 = b_next_z_part_1 + b_next_z_part_3;  /* F62 */
    const int32_t b_next_z_part = round_32(b_next_z_part_4);  /* F30, |x| <= 1.01 */
    const int64_t b_next_z_1 = (int64_t)c_nb_23 + b_next_z_part;  /* F30 */
    const int32_t b_next_z = (int32_t)b_next_z_1;  /* F30, |x| <= 1.01 */

    /* c_next = a_next x b_next */
    const int64_t c_next_x_1 = (int64_t)a_next_y * b_next_z;  /* F60 */
    const int64_t c_next_x_2 = (int64_t)a_next_z * b_next_y;  /* F60 */
    const int64_t c_next_x_3 = c_next_x_1 - c_next_x_2;  /* F60 */
    const int32_t c_next_x = round_30(c_next_x_3);  /* F30, |x| <= 1.01 */
    const int64_t c_next_y_1 = (int64_t)a_next_z * b_next_x;  /* F60 */
    const int64_t c_next_y_2 = (int64_t)a_next_x * b_next_z;  /* F60 */
    const int64_t c_next_y_3 = c_next_y_1 - c_next_y_2;  /* F60 */
    const int32_t c_next_y = round_30(c_next_y_3);  /* F30, |x| <= 1.01 */
    const int64_t c_next_z_1 = (int64_t)a_next_x * b_next_y;  /* F60 */
    const int64_t c_next_z_2 = (int64_t)a_next_y * b_next_x;  /* F60 */
    const int64_t c_next_z_3 = c_next_z_1 - c_next_z_2;  /* F60 */
    const int32_t c_next_z = round_30(c_next_z_3);  /* F30, |x| <= 1.01 */

    /* store */
    state->c[0] = a_next_x;
    state->c[1] = a_next_y;
    state->c[2] = a_next_z;
    state->c[3] = b_next_x;
    state->c[4] = b_next_y;
    state->c[5] = b_next_z;
    state->c[6] = c_next_x;
    state->c[7] = c_next_y;
    state->c[8] = c_next_z;
}

void runge_kutta_4_dcm_fixed32_start(runge_kutta_4_dcm_fixed32_state *state, const int32_t omega[3])
{
    const int32_t omega_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_z = omega[2];  /* F26, |x| <= 10.1 */
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void runge_kutta_4_dcm_fixed32_update(runge_kutta_4_dcm_fixed32_state *state, const int32_t omega[6])
{
    /* attitude and input */
    const int32_t omega1_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega1_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega1_z = omega[2];  /* F26, |x| <= 10.1 */
    const int32_t omega2_x = omega[3];  /* F26, |x| <= 10.1 */
    const int32_t omega2_y = omega[4];  /* F26, |x| <= 10.1 */
    const int32_t omega2_z = omega[5];  /* F26, |x| <= 10.1 */

    /* the sample at the start of the interval */
    const int32_t omega_last_x = state->omega_last[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_y = state->omega_last[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_last_z = state->omega_last[2];  /* F26, |x| <= 10.1 */

    /* g0 = h omega_0 */
    const int64_t g0_x_1 = (int64_t)1374389535 /* 1/100 */ * omega_last_x;  /* F63 */
    const int32_t g0_x = round_32(g0_x_1);  /* F31, |x| <= 0.101 */
    const int64_t g0_y_1 = (int64_t)1374389535 /* 1/100 */ * omega_last_y;  /* F63 */
    const int32_t g0_y = round_32(g0_y_1);  /* F31, |x| <= 0.101 */
    const int64_t g0_z_1 = (int64_t)1374389535 /* 1/100 */ * omega_last_z;  /* F63 */
    const int32_t g0_z = round_32(g0_z_1);  /* F31, |x| <= 0.101 */

    /* g1 = h omega_1 */
    const int64_t g1_x_1 = (int64_t)1374389535 /* 1/100 */ * omega1_x;  /* F63 */
    const int32_t g1_x = round_29(g1_x_1);  /* F34, |x| <= 0.101 */
    const int64_t g1_y_1 = (int64_t)1374389535 /* 1/100 */ * omega1_y;  /* F63 */
    const int32_t g1_y = round_29(g1_y_1);  /* F34, |x| <= 0.101 */
    const int64_t g1_z_1 = (int64_t)1374389535 /* 1/100 */ * omega1_z;  /* F63 */
    const int32_t g1_z = round_29(g1_z_1);  /* F34, |x| <= 0.101 */

    /* g2 = h omega_2 */
    const int64_t g2_x_1 = (int64_t)1374389535 /* 1/100 */ * omega2_x;  /* F63 */
    const int32_t g2_x = round_32(g2_x_1);  /* F31, |x| <= 0.101 */
    const int64_t g2_y_1 = (int64_t)1374389535 /* 1/100 */ * omega2_y;  /* F63 */
    const int32_t g2_y = round_32(g2_y_1);  /* F31, |x| <= 0.101 */
    const int64_t g2_z_1 = (int64_t)1374389535 /* 1/100 */ * omega2_z;  /* F63 */
    const int32_t g2_z = round_32(g2_z_1);  /* F31, |x| <= 0.101 */

    /* a1 = a x g0 */
    const int32_t g0_y_negated = -g0_y;  /* F31 */

    /* attitude and input */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.16 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.16 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.16 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.16 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.16 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.16 */

    /* a1 = a x g0 */
    const int64_t a1_x_1 = (int64_t)c_12 * g0_z;  /* F61 */
    const int64_t a1_x_2 = (int64_t)c_13 * g0_y_negated;  /* F61 */
    const int64_t a1_x_3 = a1_x_1 + a1_x_2;  /* F61 */
    const int32_t a1_x = round_27(a1_x_3);  /* F34, |x| <= 0.116 */
    const int32_t g0_z_negated = -g0_z;  /* F31 */
    const int64_t a1_y_1 = (int64_t)c_13 * g0_x;  /* F61 */
    const int64_t a1_y_2 = (int64_t)c_11 * g0_z_negated;  /* F61 */
    const int64_t a1_y_3 = a1_y_1 + a1_y_2;  /* F61 */
    const int32_t a1_y = round_27(a1_y_3);  /* F34, |x| <= 0.116 */
    const int32_t g0_x_negated = -g0_x;  /* F31 */
    const int64_t a1_z_1 = (int64_t)c_11 * g0_y;  /* F61 */
    const int64_t a1_z_2 = (int64_t)c_12 * g0_x_negated;  /* F61 */
    const int64_t a1_z_3 = a1_z_1 + a1_z_2;  /* F61 */
    const int32_t a1_z = round_27(a1_z_3);  /* F34, |x| <= 0.116 */

    /* a2 = (a + a1/2) x g1 */
    const int32_t a2_y_1 = round_short_5(a1_x);  /* F30 */
    const int32_t a2_y_2 = a2_y_1 + c_11;  /* F30, |x| <= 1.21 */
    const int32_t a2_x_1 = round_short_5(a1_y);  /* F30 */
    const int32_t a2_x_2 = a2_x_1 + c_12;  /* F30, |x| <= 1.21 */
    const int32_t a2_x_3 = round_short_5(a1_z);  /* F30 */
    const int32_t a2_x_4 = a2_x_3 + c_13;  /* F30, |x| <= 1.21 */
    const int32_t g1_y_negated = -g1_y;  /* F34 */
    const int64_t a2_x_5 = (int64_t)a2_x_2 * g1_z;  /* F64 */
    const int64_t a2_x_6 = (int64_t)a2_x_4 * g1_y_negated;  /* F64 */
    const int64_t a2_x_7 = a2_x_5 + a2_x_6;  /* F64 */
    const int32_t a2_x = round_30(a2_x_7);  /* F34, |x| <= 0.121 */
    const int32_t g1_z_negated = -g1_z;  /* F34 */
    const int64_t a2_y_3 = (int64_t)a2_x_4 * g1_x;  /* F64 */
    const int64_t a2_y_4 = (int64_t)a2_y_2 * g1_z_negated;  /* F64 */
    const int64_t a2_y_5 = a2_y_3 + a2_y_4;  /* F64 */
    const int32_t a2_y = round_30(a2_y_5);  /* F34, |x| <= 0.121 */
    const int32_t g1_x_negated = -g1_x;  /* F34 */
    const int64_t a2_z_1 = (int64_t)a2_y_2 * g1_y;  /* F64 */
    const int64_t a2_z_2 = (int64_t)a2_x_2 * g1_x_negated;  /* F64 */
    const int64_t a2_z_3 = a2_z_1 + a2_z_2;  /* F64 */
    const int32_t a2_z = round_30(a2_z_3);  /* F34, |x| <= 0.121 */

    /* a3 = (a + a2/2) x g1 */
    const int32_t a3_y_1 = round_short_5(a2_x);  /* F30 */
    const int32_t a3_y_2 = a3_y_1 + c_11;  /* F30, |x| <= 1.22 */
    const int32_t a3_x_1 = round_short_5(a2_y);  /* F30 */
    const int32_t a3_x_2 = a3_x_1 + c_12;  /* F30, |x| <= 1.22 */
    const int32_t a3_x_3 = round_short_5(a2_z);  /* F30 */
    const int32_t a3_x_4 = a3_x_3 + c_13;  /* F30, |x| <= 1.22 */
    const int64_t a3_x_5 = (int64_t)a3_x_2 * g1_z;  /* F64 */
    const int64_t a3_x_6 = (int64_t)a3_x_4 * g1_y_negated;  /* F64 */
    const int64_t a3_x_7 = a3_x_5 + a3_x_6;  /* F64 */
    const int32_t a3_x = round_30(a3_x_7);  /* F34, |x| <= 0.122 */
    const int64_t a3_y_3 = (int64_t)a3_x_4 * g1_x;  /* F64 */
    const int64_t a3_y_4 = (int64_t)a3_y_2 * g1_z_negated;  /* F64 */
    const int64_t a3_y_5 = a3_y_3 + a3_y_4;  /* F64 */
    const int32_t a3_y = round_30(a3_y_5);  /* F34, |x| <= 0.122 */
    const int64_t a3_z_1 = (int64_t)a3_y_2 * g1_y;  /* F64 */
    const int64_t a3_z_2 = (int64_t)a3_x_2 * g1_x_negated;  /* F64 */
    const int64_t a3_z_3 = a3_z_1 + a3_z_2;  /* F64 */
    const int32_t a3_z = round_30(a3_z_3);  /* F34, |x| <= 0.122 */

    /* a4 = (a + a3) x g2 */
    const int32_t a_next_y_1 = round_short_4(a3_x);  /* F30 */
    const int32_t a_next_y_2 = a_next_y_1 + c_11;  /* F30, |x| <= 1.28 */
    const int32_t a_next_x_1 = round_short_4(a3_y);  /* F30 */
    const int32_t a_next_x_2 = a_next_x_1 + c_12;  /* F30, |x| <= 1.28 */
    const int32_t a_next_x_3 = round_short_4(a3_z);  /* F30 */
    const int32_t a_next_x_4 = a_next_x_3 + c_13;  /* F30, |x| <= 1.28 */

    /* da = (a1 + a4)/6 + (a2 + a3)/3 */
    const int32_t g2_y_negated = -g2_y;  /* F31 */
    const int64_t a_next_x_5 = a1_x * INT64_C(134217728);  /* F61 */
    const int64_t a_next_x_6 = (int64_t)a_next_x_2 * g2_z;  /* F61 */
    const int64_t a_next_x_7 = a_next_x_5 + a_next_x_6;  /* F61 */
    const int64_t a_next_x_8 = (int64_t)a_next_x_4 * g2_y_negated;  /* F61 */
    const int64_t a_next_x_9 = a_next_x_7 + a_next_x_8;  /* F61 */
    const int32_t a_next_x_10 = round_28(a_next_x_9);  /* F33, |x| <= 0.243 */
    const int32_t g2_z_negated = -g2_z;  /* F31 */
    const int64_t a_next_y_3 = a1_y * INT64_C(134217728);  /* F61 */
    const int64_t a_next_y_4 = (int64_t)a_next_x_4 * g2_x;  /* F61 */
    const int64_t a_next_y_5 = a_next_y_3 + a_next_y_4;  /* F61 */
    const int64_t a_next_y_6 = (int64_t)a_next_y_2 * g2_z_negated;  /* F61 */
    const int64_t a_next_y_7 = a_next_y_5 + a_next_y_6;  /* F61 */
    const int32_t a_next_y_8 = round_28(a_next_y_7);  /* F33, |x| <= 0.243 */
    const int32_t g2_x_negated = -g2_x;  /* F31 */
    const int64_t a_next_z_1 = a1_z * INT64_C(134217728);  /* F61 */
    const int64_t a_next_z_2 = (int64_t)a_next_y_2 * g2_y;  /* F61 */
    const int64_t a_next_z_3 = a_next_z_1 + a_next_z_2;  /* F61 */
    const int64_t a_next_z_4 = (int64_t)a_next_x_2 * g2_x_negated;  /* F61 */
    const int64_t a_next_z_5 = a_next_z_3 + a_next_z_4;  /* F61 */
    const int32_t a_next_z_6 = round_28(a_next_z_5);  /* F33, |x| <= 0.243 */
    const int64_t a_next_x_11 = (int64_t)a2_x + a3_x;  /* F34 */
    const int32_t a_next_x_12 = round_1(a_next_x_11);  /* F33, |x| <= 0.242 */
    const int64_t a_next_y_9 = (int64_t)a2_y + a3_y;  /* F34 */
    const int32_t a_next_y_10 = round_1(a_next_y_9);  /* F33, |x| <= 0.242 */
    const int64_t a_next_z_7 = (int64_t)a2_z + a3_z;  /* F34 */
    const int32_t a_next_z_8 = round_1(a_next_z_7);  /* F33, |x| <= 0.242 */

    /* b1 = b x g0 */
    const int64_t b1_x_1 = (int64_t)c_22 * g0_z;  /* F61 */
    const int64_t b1_x_2 = (int64_t)c_23 * g0_y_negated;  /* F61 */
    const int64_t b1_x_3 = b1_x_1 + b1_x_2;  /* F61 */
    const int32_t b1_x = round_27(b1_x_3);  /* F34, |x| <= 0.116 */
    const int64_t b1_y_1 = (int64_t)c_23 * g0_x;  /* F61 */
    const int64_t b1_y_2 = (int64_t)c_21 * g0_z_negated;  /* F61 */
    const int64_t b1_y_3 = b1_y_1 + b1_y_2;  /* F61 */
    const int32_t b1_y = round_27(b1_y_3);  /* F34, |x| <= 0.116 */
    const int64_t b1_z_1 = (int64_t)c_21 * g0_y;  /* F61 */
    const int64_t b1_z_2 = (int64_t)c_22 * g0_x_negated;  /* F61 */
    const int64_t b1_z_3 = b1_z_1 + b1_z_2;  /* F61 */
    const int32_t b1_z = round_27(b1_z_3);  /* F34, |x| <= 0.116 */

    /* b2 = (b + b1/2) x g1 */
    const int32_t b2_y_1 = round_short_5(b1_x);  /* F30 */
    const int32_t b2_y_2 = b2_y_1 + c_21;  /* F30, |x| <= 1.21 */
    const int32_t b2_x_1 = round_short_5(b1_y);  /* F30 */
    const int32_t b2_x_2 = b2_x_1 + c_22;  /* F30, |x| <= 1.21 */
    const int32_t b2_x_3 = round_short_5(b1_z);  /* F30 */
    const int32_t b2_x_4 = b2_x_3 + c_23;  /* F30, |x| <= 1.21 */
    const int64_t b2_x_5 = (int64_t)b2_x_2 * g1_z;  /* F64 */
    const int64_t b2_x_6 = (int64_t)b2_x_4 * g1_y_negated;  /* F64 */
    const int64_t b2_x_7 = b2_x_5 + b2_x_6;  /* F64 */
    const int32_t b2_x = round_30(b2_x_7);  /* F34, |x| <= 0.121 */
    const int64_t b2_y_3 = (int64_t)b2_x_4 * g1_x;  /* F64 */
    const int64_t b2_y_4 = (int64_t)b2_y_2 * g1_z_negated;  /* F64 */
    const int64_t b2_y_5 = b2_y_3 + b2_y_4;  /* F64 */
    const int32_t b2_y = round_30(b2_y_5);  /* F34, |x| <= 0.121 */
    const int64_t b2_z_1 = (int64_t)b2_y_2 * g1_y;  /* F64 */
    const int64_t b2_z_2 = (int64_t)b2_x_2 * g1_x_negated;  /* F64 */
    const int64_t b2_z_3 = b2_z_1 + b2_z_2;  /* F64 */
    const int32_t b2_z = round_30(b2_z_3);  /* F34, |x| <= 0.121 */

    /* b3 = (b + b2/2) x g1 */
    const int32_t b3_y_1 = round_short_5(b2_x);  /* F30 */
    const int32_t b3_y_2 = b3_y_1 + c_21;  /* F30, |x| <= 1.22 */
    const int32_t b3_x_1 = round_short_5(b2_y);  /* F30 */
    const int32_t b3_x_2 = b3_x_1 + c_22;  /* F30, |x| <= 1.22 */
    const int32_t b3_x_3 = round_short_5(b2_z);  /* F30 */
    const int32_t b3_x_4 = b3_x_3 + c_23;  /* F30, |x| <= 1.22 */
    const int64_t b3_x_5 = (int64_t)b3_x_2 * g1_z;  /* F64 */
    const int64_t b3_x_6 = (int64_t)b3_x_4 * g1_y_negated;  /* F64 */
    const int64_t b3_x_7 = b3_x_5 + b3_x_6;  /* F64 */
    const int32_t b3_x = round_30(b3_x_7);  /* F34, |x| <= 0.122 */
    const int64_t b3_y_3 = (int64_t)b3_x_4 * g1_x;  /* F64 */
    const int64_t b3_y_4 = (int64_t)b3_y_2 * g1_z_negated;  /* F64 */
    const int64_t b3_y_5 = b3_y_3 + b3_y_4;  /* F64 */
    const int32_t b3_y = round_30(b3_y_5);  /* F34, |x| <= 0.122 */
    const int64_t b3_z_1 = (int64_t)b3_y_2 * g1_y;  /* F64 */
    const int64_t b3_z_2 = (int64_t)b3_x_2 * g1_x_negated;  /* F64 */
    const int64_t b3_z_3 = b3_z_1 + b3_z_2;  /* F64 */
    const int32_t b3_z = round_30(b3_z_3);  /* F34, |x| <= 0.122 */

    /* b4 = (b + b3) x g2 */
    const int32_t b_next_y_1 = round_short_4(b3_x);  /* F30 */
    const int32_t b_next_y_2 = b_next_y_1 + c_21;  /* F30, |x| <= 1.28 */
    const int32_t b_next_x_1 = round_short_4(b3_y);  /* F30 */
    const int32_t b_next_x_2 = b_next_x_1 + c_22;  /* F30, |x| <= 1.28 */
    const int32_t b_next_x_3 = round_short_4(b3_z);  /* F30 */
    const int32_t b_next_x_4 = b_next_x_3 + c_23;  /* F30, |x| <= 1.28 */

    /* db = (b1 + b4)/6 + (b2 + b3)/3 */
    const int64_t b_next_x_5 = b1_x * INT64_C(134217728);  /* F61 */
    const int64_t b_next_x_6 = (int64_t)b_next_x_2 * g2_z;  /* F61 */
    const int64_t b_next_x_7 = b_next_x_5 + b_next_x_6;  /* F61 */
    const int64_t b_next_x_8 = (int64_t)b_next_x_4 * g2_y_negated;  /* F61 */
    const int64_t b_next_x_9 = b_next_x_7 + b_next_x_8;  /* F61 */
    const int32_t b_next_x_10 = round_28(b_next_x_9);  /* F33, |x| <= 0.243 */
    const int64_t b_next_y_3 = b1_y * INT64_C(134217728);  /* F61 */
    const int64_t b_next_y_4 = (int64_t)b_next_x_4 * g2_x;  /* F61 */
    const int64_t b_next_y_5 = b_next_y_3 + b_next_y_4;  /* F61 */
    const int64_t b_next_y_6 = (int64_t)b_next_y_2 * g2_z_negated;  /* F61 */
    const int64_t b_next_y_7 = b_next_y_5 + b_next_y_6;  /* F61 */
    const int32_t b_next_y_8 = round_28(b_next_y_7);  /* F33, |x| <= 0.243 */
    const int64_t b_next_z_1 = b1_z * INT64_C(134217728);  /* F61 */
    const int64_t b_next_z_2 = (int64_t)b_next_y_2 * g2_y;  /* F61 */
    const int64_t b_next_z_3 = b_next_z_1 + b_next_z_2;  /* F61 */
    const int64_t b_next_z_4 = (int64_t)b_next_x_2 * g2_x_negated;  /* F61 */
    const int64_t b_next_z_5 = b_next_z_3 + b_next_z_4;  /* F61 */
    const int32_t b_next_z_6 = round_28(b_next_z_5);  /* F33, |x| <= 0.243 */
    const int64_t b_next_x_11 = (int64_t)b2_x + b3_x;  /* F34 */
    const int32_t b_next_x_12 = round_1(b_next_x_11);  /* F33, |x| <= 0.242 */
    const int64_t b_next_y_9 = (int64_t)b2_y + b3_y;  /* F34 */
    const int32_t b_next_y_10 = round_1(b_next_y_9);  /* F33, |x| <= 0.242 */
    const int64_t b_next_z_7 = (int64_t)b2_z + b3_z;  /* F34 */
    const int32_t b_next_z_8 = round_1(b_next_z_7);  /* F33, |x| <= 0.242 */

    /* e_a = (1 - |a|^2)/2   [re-orthogonalisation of the rows a, b] */
    const int64_t e_a_1 = (int64_t)c_11 * c_11;  /* F60 */
    const int64_t e_a_2 = (int64_t)c_12 * c_12;  /* F60 */
    const int64_t e_a_3 = e_a_1 + e_a_2;  /* F61 */
    const int64_t e_a_4 = (int64_t)c_13 * c_13;  /* F60 */
    const int64_t e_a_5 = e_a_3 + e_a_4;  /* F61 */
    const int64_t e_a_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_a_5;  /* F61 */
    const int32_t e_a = round_30(e_a_6);  /* F31, |x| <= 0.501 */

    /* e_b = (1 - |b|^2)/2   [re-orthogonalisation of the rows a, b] */
    const int64_t e_b_1 = (int64_t)c_21 * c_21;  /* F60 */
    const int64_t e_b_2 = (int64_t)c_22 * c_22;  /* F60 */
    const int64_t e_b_3 = e_b_1 + e_b_2;  /* F61 */
    const int64_t e_b_4 = (int64_t)c_23 * c_23;  /* F60 */
    const int64_t e_b_5 = e_b_3 + e_b_4;  /* F61 */
    const int64_t e_b_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_b_5;  /* F61 */
    const int32_t e_b = round_30(e_b_6);  /* F31, |x| <= 0.501 */

    /* e_ab = a . b   [re-orthogonalisation of the rows a, b] */
    const int64_t e_ab_1 = (int64_t)c_11 * c_21;  /* F60 */
    const int64_t e_ab_2 = (int64_t)c_12 * c_22;  /* F60 */
    const int64_t e_ab_3 = e_ab_1 + e_ab_2;  /* F60 */
    const int64_t e_ab_4 = (int64_t)c_13 * c_23;  /* F60 */
    const int64_t e_ab_5 = e_ab_3 + e_ab_4;  /* F60 */
    const int32_t e_ab = round_30(e_ab_5);  /* F30, |x| <= 1.33 */

    /* a_next = a + da */
    const int64_t a_next_x_13 = c_11 * INT64_C(4294967296);  /* F62 */
    const int64_t a_next_x_14 = (int64_t)89478485 /* 1/6 */ * a_next_x_10;  /* F62 */
    const int64_t a_next_x_15 = a_next_x_13 + a_next_x_14;  /* F62 */
    const int64_t a_next_x_16 = (int64_t)178956971 /* 1/3 */ * a_next_x_12;  /* F62 */
    const int64_t a_next_x_17 = a_next_x_15 + a_next_x_16;  /* F62 */
    const int64_t a_next_x_18 = (int64_t)e_a * c_11;  /* F61 */
    const int64_t a_next_x_19 = a_next_x_18 * INT64_C(2);  /* F62 */
    const int64_t a_next_x_20 = a_next_x_17 + a_next_x_19;  /* F62 */
    const int32_t a_next_x = round_32(a_next_x_20);  /* F30, |x| <= 1.13 */
    const int64_t a_next_y_11 = c_12 * INT64_C(4294967296);  /* F62 */
    const int64_t a_next_y_12 = (int64_t)89478485 /* 1/6 */ * a_next_y_8;  /* F62 */
    const int64_t a_next_y_13 = a_next_y_11 + a_next_y_12;  /* F62 */
    const int64_t a_next_y_14 = (int64_t)178956971 /* 1/3 */ * a_next_y_10;  /* F62 */
    const int64_t a_next_y_15 = a_next_y_13 + a_next_y_14;  /* F62 */
    const int64_t a_next_y_16 = (int64_t)e_a * c_12;  /* F61 */
    const int64_t a_next_y_17 = a_next_y_16 * INT64_C(2);  /* F62 */
    const int64_t a_next_y_18 = a_next_y_15 + a_next_y_17;  /* F62 */
    const int32_t a_next_y = round_32(a_next_y_18);  /* F30, |x| <= 1.13 */
    const int64_t a_next_z_9 = c_13 * INT64_C(4294967296);  /* F62 */
    const int64_t a_next_z_10 = (int64_t)89478485 /* 1/6 */ * a_next_z_6;  /* F62 */
    const int64_t a_next_z_11 = a_next_z_9 + a_next_z_10;  /* F62 */
    const int64_t a_next_z_12 = (int64_t)178956971 /* 1/3 */ * a_next_z_8;  /* F62 */
    const int64_t a_next_z_13 = a_next_z_11 + a_next_z_12;  /* F62 */
    const int64_t a_next_z_14 = (int64_t)e_a * c_13;  /* F61 */
    const int64_t a_next_z_15 = a_next_z_14 * INT64_C(2);  /* F62 */
    const int64_t a_next_z_16 = a_next_z_13 + a_next_z_15;  /* F62 */
    const int32_t a_next_z = round_32(a_next_z_16);  /* F30, |x| <= 1.13 */

    /* b_next = b + db */
    const int32_t e_ab_negated = -e_ab;  /* F30 */
    const int64_t b_next_x_13 = c_21 * INT64_C(2147483648);  /* F61 */
    const int64_t b_next_x_14 = (int64_t)44739243 /* 1/6 */ * b_next_x_10;  /* F61 */
    const int64_t b_next_x_15 = b_next_x_13 + b_next_x_14;  /* F61 */
    const int64_t b_next_x_16 = (int64_t)89478485 /* 1/3 */ * b_next_x_12;  /* F61 */
    const int64_t b_next_x_17 = b_next_x_15 + b_next_x_16;  /* F61 */
    const int64_t b_next_x_18 = (int64_t)e_b * c_21;  /* F61 */
    const int64_t b_next_x_19 = b_next_x_17 + b_next_x_18;  /* F61 */
    const int64_t b_next_x_20 = (int64_t)e_ab_negated * c_11;  /* F60 */
    const int64_t b_next_x_21 = b_next_x_20 * INT64_C(2);  /* F61 */
    const int64_t b_next_x_22 = b_next_x_19 + b_next_x_21;  /* F61 */
    const int32_t b_next_x = round_31(b_next_x_22);  /* F30, |x| <= 1.13 */
    const int64_t b_next_y_11 = c_22 * INT64_C(2147483648);  /* F61 */
    const int64_t b_next_y_12 = (int64_t)44739243 /* 1/6 */ * b_next_y_8;  /* F61 */
    const int64_t b_next_y_13 = b_next_y_11 + b_next_y_12;  /* F61 */
    const int64_t b_next_y_14 = (int64_t)89478485 /* 1/3 */ * b_next_y_10;  /* F61 */
    const int64_t b_next_y_15 = b_next_y_13 + b_next_y_14;  /* F61 */
    const int64_t b_next_y_16 = (int64_t)e_b * c_22;  /* F61 */
    const int64_t b_next_y_17 = b_next_y_15 + b_next_y_16;  /* F61 */
    const int64_t b_next_y_18 = (int64_t)e_ab_negated * c_12;  /* F60 */
    const int64_t b_next_y_19 = b_next_y_18 * INT64_C(2);  /* F61 */
    const int64_t b_next_y_20 = b_next_y_17 + b_next_y_19;  /* F61 */
    const int32_t b_next_y = round_31(b_next_y_20);  /* F30, |x| <= 1.13 */
    const int64_t b_next_z_9 = c_23 * INT64_C(2147483648);  /* F61 */
    const int64_t b_next_z_10 = (int64_t)44739243 /* 1/6 */ * b_next_z_6;  /* F61 */
    const int64_t b_next_z_11 = b_next_z_9 + b_next_z_10;  /* F61 */
    const int64_t b_next_z_12 = (int64_t)89478485 /* 1/3 */ * b_next_z_8;  /* F61 */
    const int64_t b_next_z_13 = b_next_z_11 + b_next_z_12;  /* F61 */
    const int64_t b_next_z_14 = (int64_t)e_b * c_23;  /* F61 */
    const int64_t b_next_z_15 = b_next_z_13 + b_next_z_14;  /* F61 */
    const int64_t b_next_z_16 = (int64_t)e_ab_negated * c_13;  /* F60 */
    const int64_t b_next_z_17 = b_next_z_16 * INT64_C(2);  /* F61 */
    const int64_t b_next_z_18 = b_next_z_15 + b_next_z_17;  /* F61 */
    const int32_t b_next_z = round_31(b_next_z_18);  /* F30, |x| <= 1.13 */

    /* c_next = a_next x b_next */
    const int64_t c_next_x_1 = (int64_t)a_next_y * b_next_z;  /* F60 */
    const int64_t c_next_x_2 = (int64_t)a_next_z * b_next_y;  /* F60 */
    const int64_t c_next_x_3 = c_next_x_1 - c_next_x_2;  /* F60 */
    const int32_t c_next_x = round_30(c_next_x_3);  /* F30, |x| <= 1.26 */
    const int64_t c_next_y_1 = (int64_t)a_next_z * b_next_x;  /* F60 */
    const int64_t c_next_y_2 = (int64_t)a_next_x * b_next_z;  /* F60 */
    const int64_t c_next_y_3 = c_next_y_1 - c_next_y_2;  /* F60 */
    const int32_t c_next_y = round_30(c_next_y_3);  /* F30, |x| <= 1.26 */
    const int64_t c_next_z_1 = (int64_t)a_next_x * b_next_y;  /* F60 */
    const int64_t c_next_z_2 = (int64_t)a_next_y * b_next_x;  /* F60 */
    const int64_t c_next_z_3 = c_next_z_1 - c_next_z_2;  /* F60 */
    const int32_t c_next_z = round_30(c_next_z_3);  /* F30, |x| <= 1.26 */

    /* store */
    state->c[0] = a_next_x;
    state->c[1] = a_next_y;
    state->c[2] = a_next_z;
    state->c[3] = b_next_x;
    state->c[4] = b_next_y;
    state->c[5] = b_next_z;
    state->c[6] = c_next_x;
    state->c[7] = c_next_y;
    state->c[8] = c_next_z;
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void runge_kutta_4_dcm_fixed32_quaternion(const runge_kutta_4_dcm_fixed32_state *state, int32_t q_nb[4])
{
    /* c, read once */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.33 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.33 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.33 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.33 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.33 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.33 */
    const int32_t c_31 = state->c[6];  /* F30, |x| <= 1.33 */
    const int32_t c_32 = state->c[7];  /* F30, |x| <= 1.33 */
    const int32_t c_33 = state->c[8];  /* F30, |x| <= 1.33 */

    /* ww = 4 w w, wx = 4 w x and so on   [Shepperd 1978] */
    const int64_t largest_1 = c_11 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_2 = (int64_t)c_22 + c_33;  /* F30 */
    const int64_t largest_3 = largest_1 - largest_2;  /* F30 */
    const int32_t largest_4 = round_2(largest_3);  /* F28, |x| <= 4.97 */
    const int64_t largest_5 = c_22 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_6 = (int64_t)c_11 + c_33;  /* F30 */
    const int64_t largest_7 = largest_5 - largest_6;  /* F30 */
    const int32_t largest_8 = round_2(largest_7);  /* F28, |x| <= 4.97 */
    const int64_t largest_9 = c_33 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_10 = (int64_t)c_11 + c_22;  /* F30 */
    const int64_t largest_11 = largest_9 - largest_10;  /* F30 */
    const int32_t largest_12 = round_2(largest_11);  /* F28, |x| <= 4.97 */
    const int64_t ww_1 = (int64_t)c_11 + c_22;  /* F30 */
    const int64_t ww_2 = ww_1 + c_33;  /* F30 */
    const int64_t ww_3 = ww_2 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int32_t ww = round_2(ww_3);  /* F28, |x| <= 4.97 */
    const int64_t wx_1 = (int64_t)c_32 - c_23;  /* F30 */
    const int32_t wx = round_1(wx_1);  /* F29, |x| <= 2.65 */
    const int64_t wy_1 = (int64_t)c_13 - c_31;  /* F30 */
    const int32_t wy = round_1(wy_1);  /* F29, |x| <= 2.65 */
    const int64_t wz_1 = (int64_t)c_21 - c_12;  /* F30 */
    const int32_t wz = round_1(wz_1);  /* F29, |x| <= 2.65 */
    const int64_t xy_1 = (int64_t)c_12 + c_21;  /* F30 */
    const int32_t xy = round_1(xy_1);  /* F29, |x| <= 2.65 */
    const int64_t xz_1 = (int64_t)c_13 + c_31;  /* F30 */
    const int32_t xz = round_1(xz_1);  /* F29, |x| <= 2.65 */
    const int64_t yz_1 = (int64_t)c_23 + c_32;  /* F30 */
    const int32_t yz = round_1(yz_1);  /* F29, |x| <= 2.65 */

    /* largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z   [Shepperd 1978] */
    const int32_t largest_13 = ww < largest_4;
    const int32_t largest_14 = (largest_13 != 0) ? largest_4 : ww;  /* F28, |x| <= 4.97 */
    const int32_t wx_aligned = round_short_1(wx);  /* F28 */
    const int32_t q_nb_w_1 = (largest_13 != 0) ? wx_aligned : ww;  /* F28, |x| <= 4.97 */
    const int32_t wx_aligned_2 = round_short_1(wx);  /* F28 */
    const int32_t q_nb_x_1 = (largest_13 != 0) ? largest_4 : wx_aligned_2;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_y_1 = (largest_13 != 0) ? xy : wy;  /* F29, |x| <= 2.65 */
    const int32_t q_nb_z_1 = (largest_13 != 0) ? xz : wz;  /* F29, |x| <= 2.65 */
    const int32_t largest_15 = largest_14 < largest_8;
    const int32_t largest_16 = (largest_15 != 0) ? largest_8 : largest_14;  /* F28, |x| <= 4.97 */
    const int32_t wy_aligned = round_short_1(wy);  /* F28 */
    const int32_t q_nb_w_3 = (largest_15 != 0) ? wy_aligned : q_nb_w_1;  /* F28, |x| <= 4.97 */
    const int32_t xy_aligned = round_short_1(xy);  /* F28 */
    const int32_t q_nb_x_3 = (largest_15 != 0) ? xy_aligned : q_nb_x_1;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_y_3 = round_short_1(q_nb_y_1);  /* F28 */
    const int32_t q_nb_y_4 = (largest_15 != 0) ? largest_8 : q_nb_y_3;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_z_3 = (largest_15 != 0) ? yz : q_nb_z_1;  /* F29, |x| <= 2.65 */
    const int32_t largest_17 = largest_16 < largest_12;
    const int32_t largest = (largest_17 != 0) ? largest_12 : largest_16;  /* F28, |x| <= 4.97 */
    const int32_t wz_aligned = round_short_1(wz);  /* F28 */
    const int32_t q_nb_w_4 = (largest_17 != 0) ? wz_aligned : q_nb_w_3;  /* F28, |x| <= 4.97 */
    const int32_t xz_aligned = round_short_1(xz);  /* F28 */
    const int32_t q_nb_x_4 = (largest_17 != 0) ? xz_aligned : q_nb_x_3;  /* F28, |x| <= 4.97 */
    const int32_t yz_aligned = round_short_1(yz);  /* F28 */
    const int32_t q_nb_y_5 = (largest_17 != 0) ? yz_aligned : q_nb_y_4;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_z_4 = round_short_1(q_nb_z_3);  /* F28 */
    const int32_t q_nb_z_5 = (largest_17 != 0) ? largest_12 : q_nb_z_4;  /* F28, |x| <= 4.97 */

    /* scale = 1/(2 sqrt(largest)) */
    const int32_t q_nb_w_5 = clamp_32(largest, 268435456, 1073741824);  /* F28, |x| <= 4 */
    const int32_t q_nb_w_6 = -q_nb_w_5;  /* F28 */
    const int64_t q_nb_w_7 = (int64_t)747135655 /* 47816681919/17592186044416 */ * q_nb_w_6;  /* F66 */
    /* F66 */
    const int64_t q_nb_w_8 = INT64_C(3055335112074854400) /* 182112164025/4398046511104 */ + q_nb_w_7;
    const int32_t q_nb_w_9 = round_31(q_nb_w_8);  /* F35, |x| <= 0.0387 */
    const int64_t q_nb_w_10 = (int64_t)q_nb_w_5 * q_nb_w_9;  /* F63 */
    /* F63 */
    const int64_t q_nb_w_11 = q_nb_w_10 - INT64_C(2359226658135736320) /* 2249933870445/8796093022208 */;
    const int32_t q_nb_w_12 = round_30(q_nb_w_11);  /* F33, |x| <= 0.226 */
    const int64_t q_nb_w_13 = (int64_t)q_nb_w_5 * q_nb_w_12;  /* F61 */
    /* F61 */
    const int64_t q_nb_w_14 = INT64_C(1903359871809486848) /* 1815185424623/2199023255552 */ + q_nb_w_13;
    const int32_t q_nb_w_15 = round_30(q_nb_w_14);  /* F31, |x| <= 0.725 */
    const int64_t q_nb_w_16 = (int64_t)q_nb_w_5 * q_nb_w_15;  /* F59 */
    /* F59 */
    const int64_t q_nb_w_17 = q_nb_w_16 - INT64_C(873312016427581440) /* 13325683844415/8796093022208 */;
    const int32_t q_nb_w_18 = round_29(q_nb_w_17);  /* F30, |x| <= 1.82 */
    const int64_t q_nb_w_19 = (int64_t)q_nb_w_5 * q_nb_w_18;  /* F58 */
    /* F58 */
    const int64_t q_nb_w_20 = INT64_C(549302309616861184) /* 33526752295951/17592186044416 */ + q_nb_w_19;
    const int32_t q_nb_w_21 = round_30(q_nb_w_20);  /* F28, |x| <= 7.44 */
    const int32_t q_nb_w_22 = clamp_32(q_nb_w_21, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t q_nb_w_23 = (int64_t)q_nb_w_22 * q_nb_w_22;  /* F56 */
    const int32_t q_nb_w_24 = round_26(q_nb_w_23);  /* F30, |x| <= 1.57 */
    const int64_t q_nb_w_25 = (int64_t)q_nb_w_6 * q_nb_w_24;  /* F58 */
    const int64_t q_nb_w_26 = INT64_C(288230376151711744) /* 1 */ + q_nb_w_25;  /* F58 */
    const int32_t q_nb_w_27 = round_30(q_nb_w_26);  /* F28, |x| <= 5.26 */
    const int64_t q_nb_w_28 = q_nb_w_22 * INT64_C(536870912);  /* F57 */
    const int64_t q_nb_w_29 = (int64_t)q_nb_w_22 * q_nb_w_27;  /* F56 */
    const int64_t q_nb_w_30 = q_nb_w_28 + q_nb_w_29;  /* F57 */
    const int32_t q_nb_w_31 = round_28(q_nb_w_30);  /* F29, |x| <= 3.04 */
    const int32_t q_nb_w_32 = clamp_32(q_nb_w_31, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t q_nb_w_33 = (int64_t)q_nb_w_32 * q_nb_w_32;  /* F58 */
    const int32_t q_nb_w_34 = round_28(q_nb_w_33);  /* F30, |x| <= 1.57 */
    const int64_t q_nb_w_35 = (int64_t)q_nb_w_6 * q_nb_w_34;  /* F58 */
    const int64_t q_nb_w_36 = INT64_C(288230376151711744) /* 1 */ + q_nb_w_35;  /* F58 */
    const int32_t q_nb_w_37 = round_30(q_nb_w_36);  /* F28, |x| <= 5.26 */
    const int64_t q_nb_w_38 = q_nb_w_32 * INT64_C(536870912);  /* F58 */
    const int64_t q_nb_w_39 = (int64_t)q_nb_w_32 * q_nb_w_37;  /* F57 */
    const int64_t q_nb_w_40 = q_nb_w_38 + q_nb_w_39;  /* F58 */
    const int32_t q_nb_w_41 = round_29(q_nb_w_40);  /* F29, |x| <= 3.04 */
    const int32_t q_nb_w_42 = clamp_32(q_nb_w_41, 134217728, 671088640);  /* F29, |x| <= 1.25 */

    /* q_nb = scale (its row)   [Shepperd 1978] */
    const int64_t q_nb_w_43 = (int64_t)q_nb_w_42 * q_nb_w_4;  /* F57 */
    const int32_t q_nb_w_44 = round_29(q_nb_w_43);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_w = clamp_32(q_nb_w_44, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_x_5 = (int64_t)q_nb_w_42 * q_nb_x_4;  /* F57 */
    const int32_t q_nb_x_6 = round_29(q_nb_x_5);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_x = clamp_32(q_nb_x_6, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_y_6 = (int64_t)q_nb_w_42 * q_nb_y_5;  /* F57 */
    const int32_t q_nb_y_7 = round_29(q_nb_y_6);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_y = clamp_32(q_nb_y_7, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_z_6 = (int64_t)q_nb_w_42 * q_nb_z_5;  /* F57 */
    const int32_t q_nb_z_7 = round_29(q_nb_z_6);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_z = clamp_32(q_nb_z_7, -541065216, 541065216);  /* F29, |x| <= 1.01 */

    const int32_t q_nb_w_2 = q_nb_w * 2;  /* F30, |x| <= 1.01 */
    q_nb[0] = q_nb_w_2;
    const int32_t q_nb_x_2 = q_nb_x * 2;  /* F30, |x| <= 1.01 */
    q_nb[1] = q_nb_x_2;
    const int32_t q_nb_y_2 = q_nb_y * 2;  /* F30, |x| <= 1.01 */
    q_nb[2] = q_nb_y_2;
    const int32_t q_nb_z_2 = q_nb_z * 2;  /* F30, |x| <= 1.01 */
    q_nb[3] = q_nb_z_2;
}

void runge_kutta_4_dcm_fixed32_dcm(const runge_kutta_4_dcm_fixed32_state *state, int32_t c_nb[9])
{
    /* c, read once */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.33 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.33 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.33 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.33 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.33 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.33 */
    const int32_t c_31 = state->c[6];  /* F30, |x| <= 1.33 */
    const int32_t c_32 = state->c[7];  /* F30, |x| <= 1.33 */
    const int32_t c_33 = state->c[8];  /* F30, |x| <= 1.33 */

    c_nb[0] = c_11;
    c_nb[1] = c_12;
    c_nb[2] = c_13;
    c_nb[3] = c_21;
    c_nb[4] = c_22;
    c_nb[5] = c_23;
    c_nb[6] = c_31;
    c_nb[7] = c_32;
    c_nb[8] = c_33;
}

void runge_kutta_4_dcm_fixed32_euler(const runge_kutta_4_dcm_fixed32_state *state, int32_t rpy[3])
{
    /* c, read once */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.33 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.33 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.33 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.33 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.33 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.33 */
    const int32_t c_31 = state->c[6];  /* F30, |x| <= 1.33 */
    const int32_t c_32 = state->c[7];  /* F30, |x| <= 1.33 */
    const int32_t c_33 = state->c[8];  /* F30, |x| <= 1.33 */

    /* ww = 4 w w, wx = 4 w x and so on   [Shepperd 1978] */
    const int64_t largest_1 = c_11 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_2 = (int64_t)c_22 + c_33;  /* F30 */
    const int64_t largest_3 = largest_1 - largest_2;  /* F30 */
    const int32_t largest_4 = round_2(largest_3);  /* F28, |x| <= 4.97 */
    const int64_t largest_5 = c_22 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_6 = (int64_t)c_11 + c_33;  /* F30 */
    const int64_t largest_7 = largest_5 - largest_6;  /* F30 */
    const int32_t largest_8 = round_2(largest_7);  /* F28, |x| <= 4.97 */
    const int64_t largest_9 = c_33 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_10 = (int64_t)c_11 + c_22;  /* F30 */
    const int64_t largest_11 = largest_9 - largest_10;  /* F30 */
    const int32_t largest_12 = round_2(largest_11);  /* F28, |x| <= 4.97 */
    const int64_t ww_1 = (int64_t)c_11 + c_22;  /* F30 */
    const int64_t ww_2 = ww_1 + c_33;  /* F30 */
    const int64_t ww_3 = ww_2 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int32_t ww = round_2(ww_3);  /* F28, |x| <= 4.97 */
    const int64_t wx_1 = (int64_t)c_32 - c_23;  /* F30 */
    const int32_t wx = round_1(wx_1);  /* F29, |x| <= 2.65 */
    const int64_t wy_1 = (int64_t)c_13 - c_31;  /* F30 */
    const int32_t wy = round_1(wy_1);  /* F29, |x| <= 2.65 */
    const int64_t wz_1 = (int64_t)c_21 - c_12;  /* F30 */
    const int32_t wz = round_1(wz_1);  /* F29, |x| <= 2.65 */
    const int64_t xy_1 = (int64_t)c_12 + c_21;  /* F30 */
    const int32_t xy = round_1(xy_1);  /* F29, |x| <= 2.65 */
    const int64_t xz_1 = (int64_t)c_13 + c_31;  /* F30 */
    const int32_t xz = round_1(xz_1);  /* F29, |x| <= 2.65 */
    const int64_t yz_1 = (int64_t)c_23 + c_32;  /* F30 */
    const int32_t yz = round_1(yz_1);  /* F29, |x| <= 2.65 */

    /* largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z   [Shepperd 1978] */
    const int32_t largest_13 = ww < largest_4;
    const int32_t largest_14 = (largest_13 != 0) ? largest_4 : ww;  /* F28, |x| <= 4.97 */
    const int32_t wx_aligned = round_short_1(wx);  /* F28 */
    const int32_t q_nb_w_1 = (largest_13 != 0) ? wx_aligned : ww;  /* F28, |x| <= 4.97 */
    const int32_t wx_aligned_2 = round_short_1(wx);  /* F28 */
    const int32_t q_nb_x_1 = (largest_13 != 0) ? largest_4 : wx_aligned_2;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_y_1 = (largest_13 != 0) ? xy : wy;  /* F29, |x| <= 2.65 */
    const int32_t q_nb_z_1 = (largest_13 != 0) ? xz : wz;  /* F29, |x| <= 2.65 */
    const int32_t largest_15 = largest_14 < largest_8;
    const int32_t largest_16 = (largest_15 != 0) ? largest_8 : largest_14;  /* F28, |x| <= 4.97 */
    const int32_t wy_aligned = round_short_1(wy);  /* F28 */
    const int32_t q_nb_w_2 = (largest_15 != 0) ? wy_aligned : q_nb_w_1;  /* F28, |x| <= 4.97 */
    const int32_t xy_aligned = round_short_1(xy);  /* F28 */
    const int32_t q_nb_x_2 = (largest_15 != 0) ? xy_aligned : q_nb_x_1;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_y_2 = round_short_1(q_nb_y_1);  /* F28 */
    const int32_t q_nb_y_3 = (largest_15 != 0) ? largest_8 : q_nb_y_2;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_z_2 = (largest_15 != 0) ? yz : q_nb_z_1;  /* F29, |x| <= 2.65 */
    const int32_t largest_17 = largest_16 < largest_12;
    const int32_t largest = (largest_17 != 0) ? largest_12 : largest_16;  /* F28, |x| <= 4.97 */
    const int32_t wz_aligned = round_short_1(wz);  /* F28 */
    const int32_t q_nb_w_3 = (largest_17 != 0) ? wz_aligned : q_nb_w_2;  /* F28, |x| <= 4.97 */
    const int32_t xz_aligned = round_short_1(xz);  /* F28 */
    const int32_t q_nb_x_3 = (largest_17 != 0) ? xz_aligned : q_nb_x_2;  /* F28, |x| <= 4.97 */
    const int32_t yz_aligned = round_short_1(yz);  /* F28 */
    const int32_t q_nb_y_4 = (largest_17 != 0) ? yz_aligned : q_nb_y_3;  /* F28, |x| <= 4.97 */
    const int32_t q_nb_z_3 = round_short_1(q_nb_z_2);  /* F28 */
    const int32_t q_nb_z_4 = (largest_17 != 0) ? largest_12 : q_nb_z_3;  /* F28, |x| <= 4.97 */

    /* scale = 1/(2 sqrt(largest)) */
    const int32_t q_nb_w_4 = clamp_32(largest, 268435456, 1073741824);  /* F28, |x| <= 4 */
    const int32_t q_nb_w_5 = -q_nb_w_4;  /* F28 */
    const int64_t q_nb_w_6 = (int64_t)747135655 /* 47816681919/17592186044416 */ * q_nb_w_5;  /* F66 */
    /* F66 */
    const int64_t q_nb_w_7 = INT64_C(3055335112074854400) /* 182112164025/4398046511104 */ + q_nb_w_6;
    const int32_t q_nb_w_8 = round_31(q_nb_w_7);  /* F35, |x| <= 0.0387 */
    const int64_t q_nb_w_9 = (int64_t)q_nb_w_4 * q_nb_w_8;  /* F63 */
    /* F63 */
    const int64_t q_nb_w_10 = q_nb_w_9 - INT64_C(2359226658135736320) /* 2249933870445/8796093022208 */;
    const int32_t q_nb_w_11 = round_30(q_nb_w_10);  /* F33, |x| <= 0.226 */
    const int64_t q_nb_w_12 = (int64_t)q_nb_w_4 * q_nb_w_11;  /* F61 */
    /* F61 */
    const int64_t q_nb_w_13 = INT64_C(1903359871809486848) /* 1815185424623/2199023255552 */ + q_nb_w_12;
    const int32_t q_nb_w_14 = round_30(q_nb_w_13);  /* F31, |x| <= 0.725 */
    const int64_t q_nb_w_15 = (int64_t)q_nb_w_4 * q_nb_w_14;  /* F59 */
    /* F59 */
    const int64_t q_nb_w_16 = q_nb_w_15 - INT64_C(873312016427581440) /* 13325683844415/8796093022208 */;
    const int32_t q_nb_w_17 = round_29(q_nb_w_16);  /* F30, |x| <= 1.82 */
    const int64_t q_nb_w_18 = (int64_t)q_nb_w_4 * q_nb_w_17;  /* F58 */
    /* F58 */
    const int64_t q_nb_w_19 = INT64_C(549302309616861184) /* 33526752295951/17592186044416 */ + q_nb_w_18;
    const int32_t q_nb_w_20 = round_30(q_nb_w_19);  /* F28, |x| <= 7.44 */
    const int32_t q_nb_w_21 = clamp_32(q_nb_w_20, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t q_nb_w_22 = (int64_t)q_nb_w_21 * q_nb_w_21;  /* F56 */
    const int32_t q_nb_w_23 = round_26(q_nb_w_22);  /* F30, |x| <= 1.57 */
    const int64_t q_nb_w_24 = (int64_t)q_nb_w_5 * q_nb_w_23;  /* F58 */
    const int64_t q_nb_w_25 = INT64_C(288230376151711744) /* 1 */ + q_nb_w_24;  /* F58 */
    const int32_t q_nb_w_26 = round_30(q_nb_w_25);  /* F28, |x| <= 5.26 */
    const int64_t q_nb_w_27 = q_nb_w_21 * INT64_C(536870912);  /* F57 */
    const int64_t q_nb_w_28 = (int64_t)q_nb_w_21 * q_nb_w_26;  /* F56 */
    const int64_t q_nb_w_29 = q_nb_w_27 + q_nb_w_28;  /* F57 */
    const int32_t q_nb_w_30 = round_28(q_nb_w_29);  /* F29, |x| <= 3.04 */
    const int32_t q_nb_w_31 = clamp_32(q_nb_w_30, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t q_nb_w_32 = (int64_t)q_nb_w_31 * q_nb_w_31;  /* F58 */
    const int32_t q_nb_w_33 = round_28(q_nb_w_32);  /* F30, |x| <= 1.57 */
    const int64_t q_nb_w_34 = (int64_t)q_nb_w_5 * q_nb_w_33;  /* F58 */
    const int64_t q_nb_w_35 = INT64_C(288230376151711744) /* 1 */ + q_nb_w_34;  /* F58 */
    const int32_t q_nb_w_36 = round_30(q_nb_w_35);  /* F28, |x| <= 5.26 */
    const int64_t q_nb_w_37 = q_nb_w_31 * INT64_C(536870912);  /* F58 */
    const int64_t q_nb_w_38 = (int64_t)q_nb_w_31 * q_nb_w_36;  /* F57 */
    const int64_t q_nb_w_39 = q_nb_w_37 + q_nb_w_38;  /* F58 */
    const int32_t q_nb_w_40 = round_29(q_nb_w_39);  /* F29, |x| <= 3.04 */
    const int32_t q_nb_w_41 = clamp_32(q_nb_w_40, 134217728, 671088640);  /* F29, |x| <= 1.25 */

    /* q_nb = scale (its row)   [Shepperd 1978] */
    const int64_t q_nb_w_42 = (int64_t)q_nb_w_41 * q_nb_w_3;  /* F57 */
    const int32_t q_nb_w_43 = round_29(q_nb_w_42);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_w = clamp_32(q_nb_w_43, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_x_4 = (int64_t)q_nb_w_41 * q_nb_x_3;  /* F57 */
    const int32_t q_nb_x_5 = round_29(q_nb_x_4);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_x = clamp_32(q_nb_x_5, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_y_5 = (int64_t)q_nb_w_41 * q_nb_y_4;  /* F57 */
    const int32_t q_nb_y_6 = round_29(q_nb_y_5);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_y = clamp_32(q_nb_y_6, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_z_5 = (int64_t)q_nb_w_41 * q_nb_z_4;  /* F57 */
    const int32_t q_nb_z_6 = round_29(q_nb_z_5);  /* F29, |x| <= 3.11 */
    const int32_t q_nb_z = clamp_32(q_nb_z_6, -541065216, 541065216);  /* F29, |x| <= 1.01 */

    /* half_sum = (yaw + roll)/2   [zyx] */
    const int32_t half_sum_1 = q_nb_z + q_nb_x;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_2 = q_nb_w - q_nb_y;  /* F29, |x| <= 2.02 */
    const int32_t half_difference_1 = q_nb_z - q_nb_x;  /* F29, |x| <= 2.02 */
    const int32_t half_difference_2 = q_nb_w + q_nb_y;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_3 = half_sum_1 < 0;
    const int32_t half_sum_4 = -half_sum_1;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_5 = (half_sum_3 != 0) ? half_sum_4 : half_sum_1;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_6 = half_sum_2 < 0;
    const int32_t half_sum_7 = -half_sum_2;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_8 = (half_sum_6 != 0) ? half_sum_7 : half_sum_2;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_9 = half_sum_8 < half_sum_5;
    const int32_t half_sum_10 = (half_sum_9 != 0) ? half_sum_8 : half_sum_5;  /* F29, |x| <= 2.02 */
    const int32_t half_sum_11 = (half_sum_9 != 0) ? half_sum_5 : half_sum_8;  /* F29, |x| <= 2.02 */
    const int64_t half_sum_12 = (int64_t)889516847 /* 10355339/25000000 */ * half_sum_11;  /* F60 */
    const int32_t half_sum_13 = round_29(half_sum_12);  /* F31, |x| <= 0.835 */
    const int64_t half_sum_14 = half_sum_13 * INT64_C(1);  /* F31 */
    const int64_t half_sum_15 = half_sum_10 * INT64_C(4);  /* F31 */
    const int32_t half_sum_16 = half_sum_14 < half_sum_15;
    const int64_t half_sum_17 = (int64_t)half_sum_10 - half_sum_11;  /* F29 */
    const int32_t half_sum_18 = round_1(half_sum_17);  /* F28, |x| <= 4.04 */
    const int32_t half_sum_19 = round_short_1(half_sum_10);  /* F28 */
    const int32_t half_sum_20 = (half_sum_16 != 0) ? half_sum_18 : half_sum_19;  /* F28, |x| <= 4.04 */
    const int64_t half_sum_21 = (int64_t)half_sum_10 + half_sum_11;  /* F29 */
    const int32_t half_sum_22 = round_1(half_sum_21);  /* F28, |x| <= 4.04 */
    const int32_t half_sum_23 = round_short_1(half_sum_11);  /* F28 */
    const int32_t half_sum_24 = (half_sum_16 != 0) ? half_sum_22 : half_sum_23;  /* F28, |x| <= 4.04 */
    const int32_t half_sum_25 = clamp_32(half_sum_24, 2, 2147483647);  /* F28, |x| <= 4.04 */
    const int64_t half_sum_26 = half_sum_20 * INT64_C(4294967296);  /* F60 */
    const int64_t half_sum_27 = half_sum_26 / half_sum_25;  /* F32, |x| <= 5.42e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t half_sum_28 = clamp_64_to_32(half_sum_27, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t half_sum_29 = (int64_t)half_sum_28 * half_sum_28;  /* F64 */
    const int32_t half_sum_30 = round_31(half_sum_29);  /* F33, |x| <= 0.172 */
    const int64_t half_sum_31 = (int64_t)510875761 /* 382/6423 */ * half_sum_30;  /* F66 */
    const int64_t half_sum_32 = INT64_C(7773993415904670242) /* 1650/15661 */ - half_sum_31;  /* F66 */
    const int32_t half_sum_33 = round_34(half_sum_32);  /* F32, |x| <= 0.106 */
    const int64_t half_sum_34 = (int64_t)half_sum_30 * half_sum_33;  /* F65 */
    const int64_t half_sum_35 = half_sum_34 - INT64_C(5251586747234353517) /* 7339/51558 */;  /* F65 */
    const int32_t half_sum_36 = round_33(half_sum_35);  /* F32, |x| <= 0.143 */
    const int64_t half_sum_37 = (int64_t)half_sum_30 * half_sum_36;  /* F65 */
    const int64_t half_sum_38 = INT64_C(7377920055805538292) /* 58828/294171 */ + half_sum_37;  /* F65 */
    const int32_t half_sum_39 = round_34(half_sum_38);  /* F31, |x| <= 0.2 */
    const int64_t half_sum_40 = (int64_t)half_sum_30 * half_sum_39;  /* F64 */
    const int64_t half_sum_41 = half_sum_40 - INT64_C(6148909082171862706) /* 365415/1096246 */;  /* F64 */
    const int32_t half_sum_42 = round_32(half_sum_41);  /* F32, |x| <= 0.334 */
    const int64_t half_sum_43 = (int64_t)half_sum_30 * half_sum_42;  /* F65 */
    const int32_t half_sum_44 = round_30(half_sum_43);  /* F35, |x| <= 0.0573 */
    const int64_t half_sum_45 = (int64_t)half_sum_28 * half_sum_44;  /* F67 */
    const int32_t half_sum_46 = round_35(half_sum_45);  /* F32, |x| <= 0.0238 */
    const int32_t half_sum_47 = half_sum_28 + half_sum_46;  /* F32, |x| <= 0.439 */
    const int64_t half_sum_48 = INT64_C(3373259426) + half_sum_47;  /* F32 */
    const int32_t half_sum_49 = round_2(half_sum_48);  /* F30, |x| <= 1.23 */
    const int32_t half_sum_50 = round_short_2(half_sum_47);  /* F30 */
    const int32_t half_sum_51 = (half_sum_16 != 0) ? half_sum_49 : half_sum_50;  /* F30, |x| <= 1.23 */
    const int64_t half_sum_52 = INT64_C(1686629713) - half_sum_51;  /* F30 */
    const int32_t half_sum_53 = round_1(half_sum_52);  /* F29, |x| <= 2.01 */
    const int32_t half_sum_54 = round_short_1(half_sum_51);  /* F29 */
    const int32_t half_sum_55 = (half_sum_9 != 0) ? half_sum_53 : half_sum_54;  /* F29, |x| <= 2.01 */
    const int64_t half_sum_56 = INT64_C(1686629713) - half_sum_55;  /* F29 */
    const int32_t half_sum_57 = (int32_t)half_sum_56;  /* F29, |x| <= 3.58 */
    const int32_t half_sum_58 = (half_sum_6 != 0) ? half_sum_57 : half_sum_55;  /* F29, |x| <= 3.58 */
    const int32_t half_sum_59 = -half_sum_58;  /* F29, |x| <= 3.58 */
    const int32_t half_sum = (half_sum_3 != 0) ? half_sum_59 : half_sum_58;  /* F29, |x| <= 3.58 */

    /* half_difference = (yaw - roll)/2   [zyx] */
    const int32_t half_difference_3 = half_difference_1 < 0;
    const int32_t half_difference_4 = -half_difference_1;  /* F29, |x| <= 2.02 */
    /* F29, |x| <= 2.02 */
    const int32_t half_difference_5 = (half_difference_3 != 0) ? half_difference_4 : half_difference_1;
    const int32_t half_difference_6 = half_difference_2 < 0;
    const int32_t half_difference_7 = -half_difference_2;  /* F29, |x| <= 2.02 */
    /* F29, |x| <= 2.02 */
    const int32_t half_difference_8 = (half_difference_6 != 0) ? half_difference_7 : half_difference_2;
    const int32_t half_difference_9 = half_difference_8 < half_difference_5;
    /* F29, |x| <= 2.02 */
    const int32_t half_difference_10 = (half_difference_9 != 0) ? half_difference_8 : half_difference_5;
    /* F29, |x| <= 2.02 */
    const int32_t half_difference_11 = (half_difference_9 != 0) ? half_difference_5 : half_difference_8;
    /* F60 */
    const int64_t half_difference_12 = (int64_t)889516847 /* 10355339/25000000 */ * half_difference_11;
    const int32_t half_difference_13 = round_29(half_difference_12);  /* F31, |x| <= 0.835 */
    const int64_t half_difference_14 = half_difference_13 * INT64_C(1);  /* F31 */
    const int64_t half_difference_15 = half_difference_10 * INT64_C(4);  /* F31 */
    const int32_t half_difference_16 = half_difference_14 < half_difference_15;
    const int64_t half_difference_17 = (int64_t)half_difference_10 - half_difference_11;  /* F29 */
    const int32_t half_difference_18 = round_1(half_difference_17);  /* F28, |x| <= 4.04 */
    const int32_t half_difference_19 = round_short_1(half_difference_10);  /* F28 */
    /* F28, |x| <= 4.04 */
    const int32_t half_difference_20 = (half_difference_16 != 0) ? half_difference_18 : half_difference_19;
    const int64_t half_difference_21 = (int64_t)half_difference_10 + half_difference_11;  /* F29 */
    const int32_t half_difference_22 = round_1(half_difference_21);  /* F28, |x| <= 4.04 */
    const int32_t half_difference_23 = round_short_1(half_difference_11);  /* F28 */
    /* F28, |x| <= 4.04 */
    const int32_t half_difference_24 = (half_difference_16 != 0) ? half_difference_22 : half_difference_23;
    const int32_t half_difference_25 = clamp_32(half_difference_24, 2, 2147483647);  /* F28, |x| <= 4.04 */
    const int64_t half_difference_26 = half_difference_20 * INT64_C(4294967296);  /* F60 */
    const int64_t half_difference_27 = half_difference_26 / half_difference_25;  /* F32, |x| <= 5.42e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t half_difference_28 = clamp_64_to_32(half_difference_27, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t half_difference_29 = (int64_t)half_difference_28 * half_difference_28;  /* F64 */
    const int32_t half_difference_30 = round_31(half_difference_29);  /* F33, |x| <= 0.172 */
    const int64_t half_difference_31 = (int64_t)510875761 /* 382/6423 */ * half_difference_30;  /* F66 */
    /* F66 */
    const int64_t half_difference_32 = INT64_C(7773993415904670242) /* 1650/15661 */ - half_difference_31;
    const int32_t half_difference_33 = round_34(half_difference_32);  /* F32, |x| <= 0.106 */
    const int64_t half_difference_34 = (int64_t)half_difference_30 * half_difference_33;  /* F65 */
    /* F65 */
    const int64_t half_difference_35 = half_difference_34 - INT64_C(5251586747234353517) /* 7339/51558 */;
    const int32_t half_difference_36 = round_33(half_difference_35);  /* F32, |x| <= 0.143 */
    const int64_t half_difference_37 = (int64_t)half_difference_30 * half_difference_36;  /* F65 */
    /* F65 */
    const int64_t half_difference_38 = INT64_C(7377920055805538292) /* 58828/294171 */ + half_difference_37;
    const int32_t half_difference_39 = round_34(half_difference_38);  /* F31, |x| <= 0.2 */
    const int64_t half_difference_40 = (int64_t)half_difference_30 * half_difference_39;  /* F64 */
    /* F64 */
    const int64_t half_difference_41 = half_difference_40 - INT64_C(6148909082171862706) /* 365415/1096246 */;
    const int32_t half_difference_42 = round_32(half_difference_41);  /* F32, |x| <= 0.334 */
    const int64_t half_difference_43 = (int64_t)half_difference_30 * half_difference_42;  /* F65 */
    const int32_t half_difference_44 = round_30(half_difference_43);  /* F35, |x| <= 0.0573 */
    const int64_t half_difference_45 = (int64_t)half_difference_28 * half_difference_44;  /* F67 */
    const int32_t half_difference_46 = round_35(half_difference_45);  /* F32, |x| <= 0.0238 */
    const int32_t half_difference_47 = half_difference_28 + half_difference_46;  /* F32, |x| <= 0.439 */
    const int64_t half_difference_48 = INT64_C(3373259426) + half_difference_47;  /* F32 */
    const int32_t half_difference_49 = round_2(half_difference_48);  /* F30, |x| <= 1.23 */
    const int32_t half_difference_50 = round_short_2(half_difference_47);  /* F30 */
    /* F30, |x| <= 1.23 */
    const int32_t half_difference_51 = (half_difference_16 != 0) ? half_difference_49 : half_difference_50;
    const int64_t half_difference_52 = INT64_C(1686629713) - half_difference_51;  /* F30 */
    const int32_t half_difference_53 = round_1(half_difference_52);  /* F29, |x| <= 2.01 */
    const int32_t half_difference_54 = round_short_1(half_difference_51);  /* F29 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_55 = (half_difference_9 != 0) ? half_difference_53 : half_difference_54;
    const int64_t half_difference_56 = INT64_C(1686629713) - half_difference_55;  /* F29 */
    const int32_t half_difference_57 = (int32_t)half_difference_56;  /* F29, |x| <= 3.58 */
    /* F29, |x| <= 3.58 */
    const int32_t half_difference_58 = (half_difference_6 != 0) ? half_difference_57 : half_difference_55;
    const int32_t half_difference_59 = -half_difference_58;  /* F29, |x| <= 3.58 */
    /* F29, |x| <= 3.58 */
    const int32_t half_difference = (half_difference_3 != 0) ? half_difference_59 : half_difference_58;

    /* pitch = 2 atan(sqrt(up/down)) - pi/2   [zyx] */
    const int64_t pitch_1 = (int64_t)half_difference_2 * half_difference_2;  /* F58 */
    const int64_t pitch_3 = (int64_t)half_difference_1 * half_difference_1;  /* F58 */
    const int64_t pitch_4 = pitch_1 + pitch_3;  /* F60, |x| <= 2.04 */
    const int32_t pitch_5 = pitch_4 < INT64_C(268435456) /* 1/4294967296 */;
    /* F60, |x| <= 2.33e-10 */
    const int32_t pitch_6 = clamp_64_to_32(pitch_4, INT64_C(0), INT64_C(268435456));
    const int64_t pitch_7 = pitch_6 * INT64_C(1);  /* F28, |x| <= 1 */
    const int64_t pitch_8 = pitch_7 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_9 = (pitch_5 != 0) ? pitch_8 : pitch_4;  /* F60, |x| <= 2.04 */
    /* F31, |x| <= 0.501 */
    const int32_t pitch_10 = (pitch_5 != 0) ? 16384 /* 1/131072 */ : 1073741824 /* 1/2 */;
    const int32_t pitch_11 = pitch_9 < INT64_C(17592186044416) /* 1/65536 */;
    /* F60, |x| <= 1.53e-05 */
    const int64_t pitch_12 = clamp_64(pitch_9, INT64_C(0), INT64_C(17592186044416));
    const int64_t pitch_13 = pitch_12 * INT64_C(1);  /* F44, |x| <= 1 */
    const int64_t pitch_14 = pitch_13 * INT64_C(65536);  /* F60 */
    const int64_t pitch_15 = (pitch_11 != 0) ? pitch_14 : pitch_9;  /* F60, |x| <= 2.04 */
    const int32_t pitch_16 = pitch_10 * 1;  /* F39, |x| <= 0.00196 */
    const int32_t pitch_17 = round_short_8(pitch_16);  /* F31 */
    const int32_t pitch_18 = (pitch_11 != 0) ? pitch_17 : pitch_10;  /* F31, |x| <= 0.501 */
    const int32_t pitch_19 = pitch_15 < INT64_C(4503599627370496) /* 1/256 */;
    /* F60, |x| <= 0.00391 */
    const int64_t pitch_20 = clamp_64(pitch_15, INT64_C(0), INT64_C(4503599627370496));
    const int64_t pitch_21 = pitch_20 * INT64_C(1);  /* F52, |x| <= 1 */
    const int64_t pitch_22 = pitch_21 * INT64_C(256);  /* F60 */
    const int64_t pitch_23 = (pitch_19 != 0) ? pitch_22 : pitch_15;  /* F60, |x| <= 2.04 */
    const int32_t pitch_24 = pitch_18 * 1;  /* F35, |x| <= 0.0313 */
    const int32_t pitch_25 = round_short_4(pitch_24);  /* F31 */
    const int32_t pitch_26 = (pitch_19 != 0) ? pitch_25 : pitch_18;  /* F31, |x| <= 0.501 */
    const int32_t pitch_27 = pitch_23 < INT64_C(72057594037927936) /* 1/16 */;
    /* F60, |x| <= 0.0625 */
    const int64_t pitch_28 = clamp_64(pitch_23, INT64_C(0), INT64_C(72057594037927936));
    const int64_t pitch_29 = pitch_28 * INT64_C(1);  /* F56, |x| <= 1 */
    const int64_t pitch_30 = pitch_29 * INT64_C(16);  /* F60 */
    const int64_t pitch_31 = (pitch_27 != 0) ? pitch_30 : pitch_23;  /* F60, |x| <= 2.04 */
    const int32_t pitch_32 = pitch_26 * 1;  /* F33, |x| <= 0.126 */
    const int32_t pitch_33 = round_short_2(pitch_32);  /* F31 */
    const int32_t pitch_34 = (pitch_27 != 0) ? pitch_33 : pitch_26;  /* F31, |x| <= 0.501 */
    const int32_t pitch_35 = pitch_31 < INT64_C(288230376151711744) /* 1/4 */;
    /* F60, |x| <= 0.25 */
    const int64_t pitch_36 = clamp_64(pitch_31, INT64_C(0), INT64_C(288230376151711744));
    const int64_t pitch_37 = pitch_36 * INT64_C(1);  /* F58, |x| <= 1 */
    const int64_t pitch_38 = pitch_37 * INT64_C(4);  /* F60 */
    const int64_t pitch_39 = (pitch_35 != 0) ? pitch_38 : pitch_31;  /* F60, |x| <= 2.04 */
    const int32_t pitch_40 = pitch_34 * 1;  /* F32, |x| <= 0.251 */
    const int32_t pitch_41 = round_short_1(pitch_40);  /* F31 */
    const int32_t pitch_42 = (pitch_35 != 0) ? pitch_41 : pitch_34;  /* F31, |x| <= 0.501 */
    const int32_t pitch_43 = round_31(pitch_39);  /* F27, |x| <= 8.13 */
    const int32_t pitch_44 = clamp_32(pitch_43, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_45 = clamp_32(pitch_44, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_46 = -pitch_45;  /* F27 */
    const int64_t pitch_47 = (int64_t)747135655 /* 47816681919/17592186044416 */ * pitch_46;  /* F65 */
    /* F65 */
    const int64_t pitch_48 = INT64_C(1527667556037427200) /* 182112164025/4398046511104 */ + pitch_47;
    const int32_t pitch_49 = round_30(pitch_48);  /* F35, |x| <= 0.0387 */
    const int64_t pitch_50 = (int64_t)pitch_45 * pitch_49;  /* F62 */
    /* F62 */
    const int64_t pitch_51 = pitch_50 - INT64_C(1179613329067868160) /* 2249933870445/8796093022208 */;
    const int32_t pitch_52 = round_29(pitch_51);  /* F33, |x| <= 0.226 */
    const int64_t pitch_53 = (int64_t)pitch_45 * pitch_52;  /* F60 */
    /* F60 */
    const int64_t pitch_54 = INT64_C(951679935904743424) /* 1815185424623/2199023255552 */ + pitch_53;
    const int32_t pitch_55 = round_29(pitch_54);  /* F31, |x| <= 0.725 */
    const int64_t pitch_56 = (int64_t)pitch_45 * pitch_55;  /* F58 */
    /* F58 */
    const int64_t pitch_57 = pitch_56 - INT64_C(436656008213790720) /* 13325683844415/8796093022208 */;
    const int32_t pitch_58 = round_28(pitch_57);  /* F30, |x| <= 1.82 */
    const int64_t pitch_59 = (int64_t)pitch_45 * pitch_58;  /* F57 */
    /* F57 */
    const int64_t pitch_60 = INT64_C(274651154808430592) /* 33526752295951/17592186044416 */ + pitch_59;
    const int32_t pitch_61 = round_29(pitch_60);  /* F28, |x| <= 7.44 */
    const int32_t pitch_62 = clamp_32(pitch_61, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t pitch_63 = (int64_t)pitch_62 * pitch_62;  /* F56 */
    const int32_t pitch_64 = round_26(pitch_63);  /* F30, |x| <= 1.57 */
    const int64_t pitch_65 = (int64_t)pitch_46 * pitch_64;  /* F57 */
    const int64_t pitch_66 = INT64_C(144115188075855872) /* 1 */ + pitch_65;  /* F57 */
    const int32_t pitch_67 = round_29(pitch_66);  /* F28, |x| <= 5.26 */
    const int64_t pitch_68 = pitch_62 * INT64_C(536870912);  /* F57 */
    const int64_t pitch_69 = (int64_t)pitch_62 * pitch_67;  /* F56 */
    const int64_t pitch_70 = pitch_68 + pitch_69;  /* F57 */
    const int32_t pitch_71 = round_28(pitch_70);  /* F29, |x| <= 3.04 */
    const int32_t pitch_72 = clamp_32(pitch_71, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_73 = (int64_t)pitch_72 * pitch_72;  /* F58 */
    const int32_t pitch_74 = round_28(pitch_73);  /* F30, |x| <= 1.57 */
    const int64_t pitch_75 = (int64_t)pitch_46 * pitch_74;  /* F57 */
    const int64_t pitch_76 = INT64_C(144115188075855872) /* 1 */ + pitch_75;  /* F57 */
    const int32_t pitch_77 = round_29(pitch_76);  /* F28, |x| <= 5.26 */
    const int64_t pitch_78 = pitch_72 * INT64_C(536870912);  /* F58 */
    const int64_t pitch_79 = (int64_t)pitch_72 * pitch_77;  /* F57 */
    const int64_t pitch_80 = pitch_78 + pitch_79;  /* F58 */
    const int32_t pitch_81 = round_29(pitch_80);  /* F29, |x| <= 3.04 */
    const int32_t pitch_82 = clamp_32(pitch_81, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_83 = (int64_t)pitch_44 * pitch_82;  /* F56 */
    const int32_t pitch_84 = round_28(pitch_83);  /* F28, |x| <= 5.01 */
    const int64_t pitch_85 = (int64_t)pitch_84 * pitch_42;  /* F59 */
    const int32_t pitch_86 = round_30(pitch_85);  /* F29, |x| <= 2.51 */
    const int64_t pitch_87 = (int64_t)half_sum_2 * half_sum_2;  /* F58 */
    const int64_t pitch_88 = (int64_t)half_sum_1 * half_sum_1;  /* F58 */
    const int64_t pitch_89 = pitch_87 + pitch_88;  /* F60, |x| <= 2.04 */
    const int32_t pitch_90 = pitch_89 < INT64_C(268435456) /* 1/4294967296 */;
    /* F60, |x| <= 2.33e-10 */
    const int32_t pitch_91 = clamp_64_to_32(pitch_89, INT64_C(0), INT64_C(268435456));
    const int64_t pitch_92 = pitch_91 * INT64_C(1);  /* F28, |x| <= 1 */
    const int64_t pitch_93 = pitch_92 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_94 = (pitch_90 != 0) ? pitch_93 : pitch_89;  /* F60, |x| <= 2.04 */
    /* F31, |x| <= 0.501 */
    const int32_t pitch_95 = (pitch_90 != 0) ? 16384 /* 1/131072 */ : 1073741824 /* 1/2 */;
    const int32_t pitch_96 = pitch_94 < INT64_C(17592186044416) /* 1/65536 */;
    /* F60, |x| <= 1.53e-05 */
    const int64_t pitch_97 = clamp_64(pitch_94, INT64_C(0), INT64_C(17592186044416));
    const int64_t pitch_98 = pitch_97 * INT64_C(1);  /* F44, |x| <= 1 */
    const int64_t pitch_99 = pitch_98 * INT64_C(65536);  /* F60 */
    const int64_t pitch_100 = (pitch_96 != 0) ? pitch_99 : pitch_94;  /* F60, |x| <= 2.04 */
    const int32_t pitch_101 = pitch_95 * 1;  /* F39, |x| <= 0.00196 */
    const int32_t pitch_102 = round_short_8(pitch_101);  /* F31 */
    const int32_t pitch_103 = (pitch_96 != 0) ? pitch_102 : pitch_95;  /* F31, |x| <= 0.501 */
    const int32_t pitch_104 = pitch_100 < INT64_C(4503599627370496) /* 1/256 */;
    /* F60, |x| <= 0.00391 */
    const int64_t pitch_105 = clamp_64(pitch_100, INT64_C(0), INT64_C(4503599627370496));
    const int64_t pitch_106 = pitch_105 * INT64_C(1);  /* F52, |x| <= 1 */
    const int64_t pitch_107 = pitch_106 * INT64_C(256);  /* F60 */
    const int64_t pitch_108 = (pitch_104 != 0) ? pitch_107 : pitch_100;  /* F60, |x| <= 2.04 */
    const int32_t pitch_109 = pitch_103 * 1;  /* F35, |x| <= 0.0313 */
    const int32_t pitch_110 = round_short_4(pitch_109);  /* F31 */
    const int32_t pitch_111 = (pitch_104 != 0) ? pitch_110 : pitch_103;  /* F31, |x| <= 0.501 */
    const int32_t pitch_112 = pitch_108 < INT64_C(72057594037927936) /* 1/16 */;
    /* F60, |x| <= 0.0625 */
    const int64_t pitch_113 = clamp_64(pitch_108, INT64_C(0), INT64_C(72057594037927936));
    const int64_t pitch_114 = pitch_113 * INT64_C(1);  /* F56, |x| <= 1 */
    const int64_t pitch_115 = pitch_114 * INT64_C(16);  /* F60 */
    const int64_t pitch_116 = (pitch_112 != 0) ? pitch_115 : pitch_108;  /* F60, |x| <= 2.04 */
    const int32_t pitch_117 = pitch_111 * 1;  /* F33, |x| <= 0.126 */
    const int32_t pitch_118 = round_short_2(pitch_117);  /* F31 */
    const int32_t pitch_119 = (pitch_112 != 0) ? pitch_118 : pitch_111;  /* F31, |x| <= 0.501 */
    const int32_t pitch_120 = pitch_116 < INT64_C(288230376151711744) /* 1/4 */;
    /* F60, |x| <= 0.25 */
    const int64_t pitch_121 = clamp_64(pitch_116, INT64_C(0), INT64_C(288230376151711744));
    const int64_t pitch_122 = pitch_121 * INT64_C(1);  /* F58, |x| <= 1 */
    const int64_t pitch_123 = pitch_122 * INT64_C(4);  /* F60 */
    const int64_t pitch_124 = (pitch_120 != 0) ? pitch_123 : pitch_116;  /* F60, |x| <= 2.04 */
    const int32_t pitch_125 = pitch_119 * 1;  /* F32, |x| <= 0.251 */
    const int32_t pitch_126 = round_short_1(pitch_125);  /* F31 */
    const int32_t pitch_127 = (pitch_120 != 0) ? pitch_126 : pitch_119;  /* F31, |x| <= 0.501 */
    const int32_t pitch_128 = round_31(pitch_124);  /* F27, |x| <= 8.13 */
    const int32_t pitch_129 = clamp_32(pitch_128, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_130 = clamp_32(pitch_129, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_131 = -pitch_130;  /* F27 */
    const int64_t pitch_132 = (int64_t)747135655 /* 47816681919/17592186044416 */ * pitch_131;  /* F65 */
    /* F65 */
    const int64_t pitch_133 = INT64_C(1527667556037427200) /* 182112164025/4398046511104 */ + pitch_132;
    const int32_t pitch_134 = round_30(pitch_133);  /* F35, |x| <= 0.0387 */
    const int64_t pitch_135 = (int64_t)pitch_130 * pitch_134;  /* F62 */
    /* F62 */
    const int64_t pitch_136 = pitch_135 - INT64_C(1179613329067868160) /* 2249933870445/8796093022208 */;
    const int32_t pitch_137 = round_29(pitch_136);  /* F33, |x| <= 0.226 */
    const int64_t pitch_138 = (int64_t)pitch_130 * pitch_137;  /* F60 */
    /* F60 */
    const int64_t pitch_139 = INT64_C(951679935904743424) /* 1815185424623/2199023255552 */ + pitch_138;
    const int32_t pitch_140 = round_29(pitch_139);  /* F31, |x| <= 0.725 */
    const int64_t pitch_141 = (int64_t)pitch_130 * pitch_140;  /* F58 */
    /* F58 */
    const int64_t pitch_142 = pitch_141 - INT64_C(436656008213790720) /* 13325683844415/8796093022208 */;
    const int32_t pitch_143 = round_28(pitch_142);  /* F30, |x| <= 1.82 */
    const int64_t pitch_144 = (int64_t)pitch_130 * pitch_143;  /* F57 */
    /* F57 */
    const int64_t pitch_145 = INT64_C(274651154808430592) /* 33526752295951/17592186044416 */ + pitch_144;
    const int32_t pitch_146 = round_29(pitch_145);  /* F28, |x| <= 7.44 */
    const int32_t pitch_147 = clamp_32(pitch_146, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t pitch_148 = (int64_t)pitch_147 * pitch_147;  /* F56 */
    const int32_t pitch_149 = round_26(pitch_148);  /* F30, |x| <= 1.57 */
    const int64_t pitch_150 = (int64_t)pitch_131 * pitch_149;  /* F57 */
    const int64_t pitch_151 = INT64_C(144115188075855872) /* 1 */ + pitch_150;  /* F57 */
    const int32_t pitch_152 = round_29(pitch_151);  /* F28, |x| <= 5.26 */
    const int64_t pitch_153 = pitch_147 * INT64_C(536870912);  /* F57 */
    const int64_t pitch_154 = (int64_t)pitch_147 * pitch_152;  /* F56 */
    const int64_t pitch_155 = pitch_153 + pitch_154;  /* F57 */
    const int32_t pitch_156 = round_28(pitch_155);  /* F29, |x| <= 3.04 */
    const int32_t pitch_157 = clamp_32(pitch_156, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_158 = (int64_t)pitch_157 * pitch_157;  /* F58 */
    const int32_t pitch_159 = round_28(pitch_158);  /* F30, |x| <= 1.57 */
    const int64_t pitch_160 = (int64_t)pitch_131 * pitch_159;  /* F57 */
    const int64_t pitch_161 = INT64_C(144115188075855872) /* 1 */ + pitch_160;  /* F57 */
    const int32_t pitch_162 = round_29(pitch_161);  /* F28, |x| <= 5.26 */
    const int64_t pitch_163 = pitch_157 * INT64_C(536870912);  /* F58 */
    const int64_t pitch_164 = (int64_t)pitch_157 * pitch_162;  /* F57 */
    const int64_t pitch_165 = pitch_163 + pitch_164;  /* F58 */
    const int32_t pitch_166 = round_29(pitch_165);  /* F29, |x| <= 3.04 */
    const int32_t pitch_167 = clamp_32(pitch_166, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_168 = (int64_t)pitch_129 * pitch_167;  /* F56 */
    const int32_t pitch_169 = round_28(pitch_168);  /* F28, |x| <= 5.01 */
    const int64_t pitch_170 = (int64_t)pitch_169 * pitch_127;  /* F59 */
    const int32_t pitch_171 = round_30(pitch_170);  /* F29, |x| <= 2.51 */
    const int32_t pitch_172 = pitch_86 < 0;
    const int32_t pitch_173 = -pitch_86;  /* F29, |x| <= 2.51 */
    const int32_t pitch_174 = (pitch_172 != 0) ? pitch_173 : pitch_86;  /* F29, |x| <= 2.51 */
    const int32_t pitch_175 = pitch_171 < 0;
    const int32_t pitch_176 = -pitch_171;  /* F29, |x| <= 2.51 */
    const int32_t pitch_177 = (pitch_175 != 0) ? pitch_176 : pitch_171;  /* F29, |x| <= 2.51 */
    const int32_t pitch_178 = pitch_177 < pitch_174;
    const int32_t pitch_179 = (pitch_178 != 0) ? pitch_177 : pitch_174;  /* F29, |x| <= 2.51 */
    const int32_t pitch_180 = (pitch_178 != 0) ? pitch_174 : pitch_177;  /* F29, |x| <= 2.51 */
    const int64_t pitch_181 = (int64_t)889516847 /* 10355339/25000000 */ * pitch_180;  /* F60 */
    const int32_t pitch_182 = round_30(pitch_181);  /* F30, |x| <= 1.04 */
    const int64_t pitch_183 = pitch_182 * INT64_C(1);  /* F30 */
    const int64_t pitch_184 = pitch_179 * INT64_C(2);  /* F30 */
    const int32_t pitch_185 = pitch_183 < pitch_184;
    const int64_t pitch_186 = (int64_t)pitch_179 - pitch_180;  /* F29 */
    const int32_t pitch_187 = round_1(pitch_186);  /* F28, |x| <= 5.01 */
    const int32_t pitch_188 = round_short_1(pitch_179);  /* F28 */
    const int32_t pitch_189 = (pitch_185 != 0) ? pitch_187 : pitch_188;  /* F28, |x| <= 5.01 */
    const int64_t pitch_190 = (int64_t)pitch_179 + pitch_180;  /* F29 */
    const int32_t pitch_191 = round_1(pitch_190);  /* F28, |x| <= 5.01 */
    const int32_t pitch_192 = round_short_1(pitch_180);  /* F28 */
    const int32_t pitch_193 = (pitch_185 != 0) ? pitch_191 : pitch_192;  /* F28, |x| <= 5.01 */
    const int32_t pitch_194 = clamp_32(pitch_193, 2, 2147483647);  /* F28, |x| <= 5.01 */
    const int64_t pitch_195 = pitch_189 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_196 = pitch_195 / pitch_194;  /* F32, |x| <= 6.72e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t pitch_197 = clamp_64_to_32(pitch_196, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t pitch_198 = (int64_t)pitch_197 * pitch_197;  /* F64 */
    const int32_t pitch_199 = round_31(pitch_198);  /* F33, |x| <= 0.172 */
    const int64_t pitch_200 = (int64_t)510875761 /* 382/6423 */ * pitch_199;  /* F66 */
    const int64_t pitch_201 = INT64_C(7773993415904670242) /* 1650/15661 */ - pitch_200;  /* F66 */
    const int32_t pitch_202 = round_34(pitch_201);  /* F32, |x| <= 0.106 */
    const int64_t pitch_203 = (int64_t)pitch_199 * pitch_202;  /* F65 */
    const int64_t pitch_204 = pitch_203 - INT64_C(5251586747234353517) /* 7339/51558 */;  /* F65 */
    const int32_t pitch_205 = round_33(pitch_204);  /* F32, |x| <= 0.143 */
    const int64_t pitch_206 = (int64_t)pitch_199 * pitch_205;  /* F65 */
    const int64_t pitch_207 = INT64_C(7377920055805538292) /* 58828/294171 */ + pitch_206;  /* F65 */
    const int32_t pitch_208 = round_34(pitch_207);  /* F31, |x| <= 0.2 */
    const int64_t pitch_209 = (int64_t)pitch_199 * pitch_208;  /* F64 */
    const int64_t pitch_210 = pitch_209 - INT64_C(6148909082171862706) /* 365415/1096246 */;  /* F64 */
    const int32_t pitch_211 = round_32(pitch_210);  /* F32, |x| <= 0.334 */
    const int64_t pitch_212 = (int64_t)pitch_199 * pitch_211;  /* F65 */
    const int32_t pitch_213 = round_30(pitch_212);  /* F35, |x| <= 0.0573 */
    const int64_t pitch_214 = (int64_t)pitch_197 * pitch_213;  /* F67 */
    const int32_t pitch_215 = round_35(pitch_214);  /* F32, |x| <= 0.0238 */
    const int32_t pitch_216 = pitch_197 + pitch_215;  /* F32, |x| <= 0.439 */
    const int64_t pitch_217 = INT64_C(3373259426) + pitch_216;  /* F32 */
    const int32_t pitch_218 = round_2(pitch_217);  /* F30, |x| <= 1.23 */
    const int32_t pitch_219 = round_short_2(pitch_216);  /* F30 */
    const int32_t pitch_220 = (pitch_185 != 0) ? pitch_218 : pitch_219;  /* F30, |x| <= 1.23 */
    const int64_t pitch_221 = INT64_C(1686629713) - pitch_220;  /* F30 */
    const int32_t pitch_222 = round_1(pitch_221);  /* F29, |x| <= 2.01 */
    const int32_t pitch_223 = round_short_1(pitch_220);  /* F29 */
    const int32_t pitch_224 = (pitch_178 != 0) ? pitch_222 : pitch_223;  /* F29, |x| <= 2.01 */
    const int64_t pitch_225 = INT64_C(1686629713) - pitch_224;  /* F29 */
    const int32_t pitch_226 = (int32_t)pitch_225;  /* F29, |x| <= 3.58 */
    const int32_t pitch_227 = (pitch_175 != 0) ? pitch_226 : pitch_224;  /* F29, |x| <= 3.58 */
    const int32_t pitch_228 = -pitch_227;  /* F29, |x| <= 3.58 */
    const int32_t pitch_229 = (pitch_172 != 0) ? pitch_228 : pitch_227;  /* F29, |x| <= 3.58 */
    const int64_t pitch_230 = pitch_229 - INT64_C(421657428);  /* F28 */
    const int32_t pitch_231 = round_1(pitch_230);  /* F27, |x| <= 8.73 */
    const int32_t pitch = clamp_32(pitch_231, -210829207, 210829207);  /* F27, |x| <= 1.58 */

    /* roll = half_sum - half_difference, in [-pi, pi] */
    const int64_t roll_1 = (int64_t)half_sum - half_difference;  /* F29 */
    const int32_t roll_3 = round_1(roll_1);  /* F28, |x| <= 7.16 */
    const int32_t roll_4 = 843314857 < roll_3;
    const int64_t roll_5 = roll_3 - INT64_C(1686629713);  /* F28 */
    const int32_t roll_6 = round_1(roll_5);  /* F27, |x| <= 13.5 */
    const int32_t roll_7 = round_short_1(roll_3);  /* F27 */
    const int32_t roll_8 = (roll_4 != 0) ? roll_6 : roll_7;  /* F27, |x| <= 13.5 */
    const int32_t roll_9 = clamp_32(roll_8, -843316828, 421658414);  /* F27, |x| <= 6.29 */
    const int32_t roll_10 = roll_9 < -421657428;
    const int32_t roll_11 = roll_9 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t roll_12 = (roll_10 != 0) ? roll_11 : roll_9;  /* F27, |x| <= 9.43 */
    const int32_t roll = clamp_32(roll_12, -421658414, 421658414);  /* F27, |x| <= 3.15 */

    /* yaw = half_sum + half_difference, in [-pi, pi] */
    const int64_t yaw_1 = (int64_t)half_sum + half_difference;  /* F29 */
    const int32_t yaw_3 = round_1(yaw_1);  /* F28, |x| <= 7.16 */
    const int32_t yaw_4 = 843314857 < yaw_3;
    const int64_t yaw_5 = yaw_3 - INT64_C(1686629713);  /* F28 */
    const int32_t yaw_6 = round_1(yaw_5);  /* F27, |x| <= 13.5 */
    const int32_t yaw_7 = round_short_1(yaw_3);  /* F27 */
    const int32_t yaw_8 = (yaw_4 != 0) ? yaw_6 : yaw_7;  /* F27, |x| <= 13.5 */
    const int32_t yaw_9 = clamp_32(yaw_8, -843316828, 421658414);  /* F27, |x| <= 6.29 */
    const int32_t yaw_10 = yaw_9 < -421657428;
    const int32_t yaw_11 = yaw_9 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t yaw_12 = (yaw_10 != 0) ? yaw_11 : yaw_9;  /* F27, |x| <= 9.43 */
    const int32_t yaw = clamp_32(yaw_12, -421658414, 421658414);  /* F27, |x| <= 3.15 */

    const int32_t roll_2 = roll * 4;  /* F29, |x| <= 3.15 */
    rpy[0] = roll_2;
    const int32_t pitch_2 = pitch * 4;  /* F29, |x| <= 1.58 */
    rpy[1] = pitch_2;
    const int32_t yaw_2 = yaw * 4;  /* F29, |x| <= 3.15 */
    rpy[2] = yaw_2;
}
