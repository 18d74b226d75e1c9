/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_quaternion_fixed32
 *
 * qcone 0.1.0, design runge_kutta_4_quaternion_fixed32, SHA-256 of the design
 * 52261c5b13c7e90c738c83efe187481b867ce01eca4690edd4b62c184c2fc207
 *
 * algorithm:   runge-kutta-4-quaternion, form factored, q' = q + dq, renormalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = 1/2 q (x) omega; q + h (k1 + 2 k2 + 2 k3 + k4)/6
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad; | |q|
 *              - 1 | <= 0.0625 always, proved; within it no sum overflows, as is proved; beyond it
 *              nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 2.7e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  15 of 33 rounded sums of products drop a whole word, 3 before formats were searched
 *              for that; of one update's errors in the first order it made 4.3e-09 of 2.6e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       82       0   55        13       4       0     0     0     0       0      0
 * update shared           73       9   51        17       0       0     0     0     0       0      0
 * update emitted          73       0   60         8       6       0     0     0     0       0     60
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "runge_kutta_4_quaternion_fixed32.h"

#if RUNGE_KUTTA_4_QUATERNION_FIXED32_VERSION != 1
#error "runge_kutta_4_quaternion_fixed32.h is of another version than this file: generate both again"
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

/* x / 2^21, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_21(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1048576)) >> 21);
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

/* x / 2^30, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_30(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(536870912)) >> 30);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^32, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_32(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(2147483648)) >> 32);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^36, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_36(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(34359738368), 36);
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

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

void runge_kutta_4_quaternion_fixed32_init(runge_kutta_4_quaternion_fixed32_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
    state->omega_last[0] = 0;
    state->omega_last[1] = 0;
    state->omega_last[2] = 0;
}

void runge_kutta_4_quaternion_fixed32_set_quaternion(
    runge_kutta_4_quaternion_fixed32_state *state, const int32_t q_nb[4])
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
    const int32_t q_next_w_part = round_30(q_next_w_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t q_next_w_fine = round_short_10(q_next_w_part);  /* F30 */
    const int32_t q_next_w = q_next_w_fine + q_nb_w;  /* F30, |x| <= 1.01 */
    const int64_t q_next_x_part_1 = (int64_t)e * q_nb_x;  /* F70 */
    const int32_t q_next_x_part = round_30(q_next_x_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t q_next_x_fine = round_short_10(q_next_x_part);  /* F30 */
    const int32_t q_next_x = q_next_x_fine + q_nb_x;  /* F30, |x| <= 1.01 */
    const int64_t q_next_y_part_1 = (int64_t)e * q_nb_y;  /* F70 */
    const int32_t q_next_y_part = round_30(q_next_y_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t q_next_y_fine = round_short_10(q_next_y_part);  /* F30 */
    const int32_t q_next_y = q_next_y_fine + q_nb_y;  /* F30, |x| <= 1.01 */
    const int64_t q_next_z_part_1 = (int64_t)e * q_nb_z;  /* F70 */
    const int32_t q_next_z_part = round_30(q_next_z_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t q_next_z_fine = round_short_10(q_next_z_part);  /* F30 */
    const int32_t q_next_z = q_next_z_fine + q_nb_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void runge_kutta_4_quaternion_fixed32_start(
    runge_kutta_4_quaternion_fixed32_state *state, const int32_t omega[3])
{
    const int32_t omega_x = omega[0];  /* F26, |x| <= 10.1 */
    const int32_t omega_y = omega[1];  /* F26, |x| <= 10.1 */
    const int32_t omega_z = omega[2];  /* F26, |x| <= 10.1 */
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void runge_kutta_4_quaternion_fixed32_update(
    runge_kutta_4_quaternion_fixed32_state *state, const int32_t omega[6])
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

    /* g0 = h/2 omega_0 */
    const int64_t g0_x_1 = (int64_t)1374389535 /* 1/200 */ * omega_last_x;  /* F64 */
    const int32_t g0_x = round_32(g0_x_1);  /* F32, |x| <= 0.0501 */
    const int64_t g0_y_1 = (int64_t)1374389535 /* 1/200 */ * omega_last_y;  /* F64 */
    const int32_t g0_y = round_32(g0_y_1);  /* F32, |x| <= 0.0501 */
    const int64_t g0_z_1 = (int64_t)1374389535 /* 1/200 */ * omega_last_z;  /* F64 */
    const int32_t g0_z = round_32(g0_z_1);  /* F32, |x| <= 0.0501 */

    /* g1 = h/2 omega_1 */
    const int64_t g1_x_1 = (int64_t)1374389535 /* 1/200 */ * omega1_x;  /* F64 */
    const int32_t g1_x = round_32(g1_x_1);  /* F32, |x| <= 0.0501 */
    const int64_t g1_y_1 = (int64_t)1374389535 /* 1/200 */ * omega1_y;  /* F64 */
    const int32_t g1_y = round_32(g1_y_1);  /* F32, |x| <= 0.0501 */
    const int64_t g1_z_1 = (int64_t)1374389535 /* 1/200 */ * omega1_z;  /* F64 */
    const int32_t g1_z = round_32(g1_z_1);  /* F32, |x| <= 0.0501 */

    /* g2 = h/2 omega_2 */
    const int64_t g2_x_1 = (int64_t)1374389535 /* 1/200 */ * omega2_x;  /* F64 */
    const int32_t g2_x = round_32(g2_x_1);  /* F32, |x| <= 0.0501 */
    const int64_t g2_y_1 = (int64_t)1374389535 /* 1/200 */ * omega2_y;  /* F64 */
    const int32_t g2_y = round_32(g2_y_1);  /* F32, |x| <= 0.0501 */
    const int64_t g2_z_1 = (int64_t)1374389535 /* 1/200 */ * omega2_z;  /* F64 */
    const int32_t g2_z = round_32(g2_z_1);  /* F32, |x| <= 0.0501 */

    /* attitude and input */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.07 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.07 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.07 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.07 */

    /* k1 = q (x) g0 */
    const int64_t k1_w_negated_1 = (int64_t)q_x * g0_x;  /* F62 */
    const int64_t k1_w_negated_2 = (int64_t)q_y * g0_y;  /* F62 */
    const int64_t k1_w_negated_3 = k1_w_negated_1 + k1_w_negated_2;  /* F62 */
    const int64_t k1_w_negated_4 = (int64_t)q_z * g0_z;  /* F62 */
    const int64_t k1_w_negated_5 = k1_w_negated_3 + k1_w_negated_4;  /* F62 */
    const int32_t k1_w_negated = round_27(k1_w_negated_5);  /* F35, |x| <= 0.0532 */
    const int64_t k1_x_1 = (int64_t)q_w * g0_x;  /* F62 */
    const int64_t k1_x_2 = (int64_t)q_y * g0_z;  /* F62 */
    const int64_t k1_x_3 = k1_x_1 + k1_x_2;  /* F62 */
    const int64_t k1_x_4 = (int64_t)q_z * g0_y;  /* F62 */
    const int64_t k1_x_5 = k1_x_3 - k1_x_4;  /* F62 */
    const int32_t k1_x = round_27(k1_x_5);  /* F35, |x| <= 0.0532 */
    const int64_t k1_y_1 = (int64_t)q_w * g0_y;  /* F62 */
    const int64_t k1_y_2 = (int64_t)q_z * g0_x;  /* F62 */
    const int64_t k1_y_3 = k1_y_1 + k1_y_2;  /* F62 */
    const int64_t k1_y_4 = (int64_t)q_x * g0_z;  /* F62 */
    const int64_t k1_y_5 = k1_y_3 - k1_y_4;  /* F62 */
    const int32_t k1_y = round_27(k1_y_5);  /* F35, |x| <= 0.0532 */
    const int64_t k1_z_1 = (int64_t)q_w * g0_z;  /* F62 */
    const int64_t k1_z_2 = (int64_t)q_x * g0_y;  /* F62 */
    const int64_t k1_z_3 = k1_z_1 + k1_z_2;  /* F62 */
    const int64_t k1_z_4 = (int64_t)q_y * g0_x;  /* F62 */
    const int64_t k1_z_5 = k1_z_3 - k1_z_4;  /* F62 */
    const int32_t k1_z = round_27(k1_z_5);  /* F35, |x| <= 0.0532 */

    /* k2 = (q + k1/2) (x) g1 */
    const int32_t k2_x_1 = -k1_w_negated;  /* F36 */
    const int32_t k2_x_2 = round_short_6(k2_x_1);  /* F30 */
    const int32_t k2_x_3 = k2_x_2 + q_w;  /* F30, |x| <= 1.09 */
    const int32_t k2_w_negated_1 = round_short_6(k1_x);  /* F30 */
    const int32_t k2_w_negated_2 = k2_w_negated_1 + q_x;  /* F30, |x| <= 1.09 */
    const int32_t k2_w_negated_3 = round_short_6(k1_y);  /* F30 */
    const int32_t k2_w_negated_4 = k2_w_negated_3 + q_y;  /* F30, |x| <= 1.09 */
    const int32_t k2_w_negated_5 = round_short_6(k1_z);  /* F30 */
    const int32_t k2_w_negated_6 = k2_w_negated_5 + q_z;  /* F30, |x| <= 1.09 */
    const int64_t k2_w_negated_7 = (int64_t)k2_w_negated_2 * g1_x;  /* F62 */
    const int64_t k2_w_negated_8 = (int64_t)k2_w_negated_4 * g1_y;  /* F62 */
    const int64_t k2_w_negated_9 = k2_w_negated_7 + k2_w_negated_8;  /* F62 */
    const int64_t k2_w_negated_10 = (int64_t)k2_w_negated_6 * g1_z;  /* F62 */
    const int64_t k2_w_negated_11 = k2_w_negated_9 + k2_w_negated_10;  /* F62 */
    const int32_t k2_w_negated = round_27(k2_w_negated_11);  /* F35, |x| <= 0.0545 */
    const int32_t g1_y_negated = -g1_y;  /* F32 */
    const int64_t k2_x_4 = (int64_t)k2_x_3 * g1_x;  /* F62 */
    const int64_t k2_x_5 = (int64_t)k2_w_negated_4 * g1_z;  /* F62 */
    const int64_t k2_x_6 = k2_x_4 + k2_x_5;  /* F62 */
    const int64_t k2_x_7 = (int64_t)k2_w_negated_6 * g1_y_negated;  /* F62 */
    const int64_t k2_x_8 = k2_x_6 + k2_x_7;  /* F62 */
    const int32_t k2_x = round_27(k2_x_8);  /* F35, |x| <= 0.0545 */
    const int32_t g1_z_negated = -g1_z;  /* F32 */
    const int64_t k2_y_1 = (int64_t)k2_x_3 * g1_y;  /* F62 */
    const int64_t k2_y_2 = (int64_t)k2_w_negated_6 * g1_x;  /* F62 */
    const int64_t k2_y_3 = k2_y_1 + k2_y_2;  /* F62 */
    const int64_t k2_y_4 = (int64_t)k2_w_negated_2 * g1_z_negated;  /* F62 */
    const int64_t k2_y_5 = k2_y_3 + k2_y_4;  /* F62 */
    const int32_t k2_y = round_27(k2_y_5);  /* F35, |x| <= 0.0545 */
    const int32_t g1_x_negated = -g1_x;  /* F32 */
    const int64_t k2_z_1 = (int64_t)k2_x_3 * g1_z;  /* F62 */
    const int64_t k2_z_2 = (int64_t)k2_w_negated_2 * g1_y;  /* F62 */
    const int64_t k2_z_3 = k2_z_1 + k2_z_2;  /* F62 */
    const int64_t k2_z_4 = (int64_t)k2_w_negated_4 * g1_x_negated;  /* F62 */
    const int64_t k2_z_5 = k2_z_3 + k2_z_4;  /* F62 */
    const int32_t k2_z = round_27(k2_z_5);  /* F35, |x| <= 0.0545 */

    /* k3 = (q + k2/2) (x) g1 */
    const int32_t k3_x_1 = -k2_w_negated;  /* F36 */
    const int32_t k3_x_2 = round_short_6(k3_x_1);  /* F30 */
    const int32_t k3_x_3 = k3_x_2 + q_w;  /* F30, |x| <= 1.09 */
    const int32_t k3_w_negated_1 = round_short_6(k2_x);  /* F30 */
    const int32_t k3_w_negated_2 = k3_w_negated_1 + q_x;  /* F30, |x| <= 1.09 */
    const int32_t k3_w_negated_3 = round_short_6(k2_y);  /* F30 */
    const int32_t k3_w_negated_4 = k3_w_negated_3 + q_y;  /* F30, |x| <= 1.09 */
    const int32_t k3_w_negated_5 = round_short_6(k2_z);  /* F30 */
    const int32_t k3_w_negated_6 = k3_w_negated_5 + q_z;  /* F30, |x| <= 1.09 */
    const int64_t k3_w_negated_7 = (int64_t)k3_w_negated_2 * g1_x;  /* F62 */
    const int64_t k3_w_negated_8 = (int64_t)k3_w_negated_4 * g1_y;  /* F62 */
    const int64_t k3_w_negated_9 = k3_w_negated_7 + k3_w_negated_8;  /* F62 */
    const int64_t k3_w_negated_10 = (int64_t)k3_w_negated_6 * g1_z;  /* F62 */
    const int64_t k3_w_negated_11 = k3_w_negated_9 + k3_w_negated_10;  /* F62 */
    const int32_t k3_w_negated = round_27(k3_w_negated_11);  /* F35, |x| <= 0.0545 */
    const int64_t k3_x_4 = (int64_t)k3_x_3 * g1_x;  /* F62 */
    const int64_t k3_x_5 = (int64_t)k3_w_negated_4 * g1_z;  /* F62 */
    const int64_t k3_x_6 = k3_x_4 + k3_x_5;  /* F62 */
    const int64_t k3_x_7 = (int64_t)k3_w_negated_6 * g1_y_negated;  /* F62 */
    const int64_t k3_x_8 = k3_x_6 + k3_x_7;  /* F62 */
    const int32_t k3_x = round_27(k3_x_8);  /* F35, |x| <= 0.0545 */
    const int64_t k3_y_1 = (int64_t)k3_x_3 * g1_y;  /* F62 */
    const int64_t k3_y_2 = (int64_t)k3_w_negated_6 * g1_x;  /* F62 */
    const int64_t k3_y_3 = k3_y_1 + k3_y_2;  /* F62 */
    const int64_t k3_y_4 = (int64_t)k3_w_negated_2 * g1_z_negated;  /* F62 */
    const int64_t k3_y_5 = k3_y_3 + k3_y_4;  /* F62 */
    const int32_t k3_y = round_27(k3_y_5);  /* F35, |x| <= 0.0545 */
    const int64_t k3_z_1 = (int64_t)k3_x_3 * g1_z;  /* F62 */
    const int64_t k3_z_2 = (int64_t)k3_w_negated_2 * g1_y;  /* F62 */
    const int64_t k3_z_3 = k3_z_1 + k3_z_2;  /* F62 */
    const int64_t k3_z_4 = (int64_t)k3_w_negated_4 * g1_x_negated;  /* F62 */
    const int64_t k3_z_5 = k3_z_3 + k3_z_4;  /* F62 */
    const int32_t k3_z = round_27(k3_z_5);  /* F35, |x| <= 0.0545 */

    /* k4 = (q + k3) (x) g2 */
    const int32_t q_next_x_1 = -k3_w_negated;  /* F35 */
    const int32_t q_next_x_2 = round_short_5(q_next_x_1);  /* F30 */
    const int32_t q_next_x_3 = q_next_x_2 + q_w;  /* F30, |x| <= 1.12 */
    const int32_t dq_e_w_1 = round_short_5(k3_x);  /* F30 */
    const int32_t dq_e_w_2 = dq_e_w_1 + q_x;  /* F30, |x| <= 1.12 */
    const int32_t dq_e_w_3 = round_short_5(k3_y);  /* F30 */
    const int32_t dq_e_w_4 = dq_e_w_3 + q_y;  /* F30, |x| <= 1.12 */
    const int32_t dq_e_w_5 = round_short_5(k3_z);  /* F30 */
    const int32_t dq_e_w_6 = dq_e_w_5 + q_z;  /* F30, |x| <= 1.12 */

    /* dq = (k1 + k4)/6 + (k2 + k3)/3 */
    const int64_t dq_e_w_7 = k1_w_negated * INT64_C(134217728);  /* F62 */
    const int64_t dq_e_w_8 = (int64_t)dq_e_w_2 * g2_x;  /* F62 */
    const int64_t dq_e_w_9 = dq_e_w_7 + dq_e_w_8;  /* F62 */
    const int64_t dq_e_w_10 = (int64_t)dq_e_w_4 * g2_y;  /* F62 */
    const int64_t dq_e_w_11 = dq_e_w_9 + dq_e_w_10;  /* F62 */
    const int64_t dq_e_w_12 = (int64_t)dq_e_w_6 * g2_z;  /* F62 */
    const int64_t dq_e_w_13 = dq_e_w_11 + dq_e_w_12;  /* F62 */
    const int32_t dq_e_w_14 = round_28(dq_e_w_13);  /* F34, |x| <= 0.109 */
    const int64_t q_next_x_4 = k1_x * INT64_C(134217728);  /* F62 */
    const int64_t q_next_x_5 = (int64_t)q_next_x_3 * g2_x;  /* F62 */
    const int64_t q_next_x_6 = q_next_x_4 + q_next_x_5;  /* F62 */
    const int64_t q_next_x_7 = (int64_t)dq_e_w_4 * g2_z;  /* F62 */
    const int64_t q_next_x_8 = q_next_x_6 + q_next_x_7;  /* F62 */
    const int64_t q_next_x_9 = (int64_t)dq_e_w_6 * g2_y;  /* F62 */
    const int64_t q_next_x_10 = q_next_x_8 - q_next_x_9;  /* F62 */
    const int32_t q_next_x_11 = round_28(q_next_x_10);  /* F34, |x| <= 0.109 */
    const int64_t q_next_y_1 = k1_y * INT64_C(134217728);  /* F62 */
    const int64_t q_next_y_2 = (int64_t)q_next_x_3 * g2_y;  /* F62 */
    const int64_t q_next_y_3 = q_next_y_1 + q_next_y_2;  /* F62 */
    const int64_t q_next_y_4 = (int64_t)dq_e_w_6 * g2_x;  /* F62 */
    const int64_t q_next_y_5 = q_next_y_3 + q_next_y_4;  /* F62 */
    const int64_t q_next_y_6 = (int64_t)dq_e_w_2 * g2_z;  /* F62 */
    const int64_t q_next_y_7 = q_next_y_5 - q_next_y_6;  /* F62 */
    const int32_t q_next_y_8 = round_28(q_next_y_7);  /* F34, |x| <= 0.109 */
    const int64_t q_next_z_1 = k1_z * INT64_C(134217728);  /* F62 */
    const int64_t q_next_z_2 = (int64_t)q_next_x_3 * g2_z;  /* F62 */
    const int64_t q_next_z_3 = q_next_z_1 + q_next_z_2;  /* F62 */
    const int64_t q_next_z_4 = (int64_t)dq_e_w_2 * g2_y;  /* F62 */
    const int64_t q_next_z_5 = q_next_z_3 + q_next_z_4;  /* F62 */
    const int64_t q_next_z_6 = (int64_t)dq_e_w_4 * g2_x;  /* F62 */
    const int64_t q_next_z_7 = q_next_z_5 - q_next_z_6;  /* F62 */
    const int32_t q_next_z_8 = round_28(q_next_z_7);  /* F34, |x| <= 0.109 */
    const int64_t dq_e_w_15 = (int64_t)k2_w_negated + k3_w_negated;  /* F35 */
    const int32_t dq_e_w_16 = round_1(dq_e_w_15);  /* F34, |x| <= 0.109 */
    const int64_t q_next_x_12 = (int64_t)k2_x + k3_x;  /* F35 */
    const int32_t q_next_x_13 = round_1(q_next_x_12);  /* F34, |x| <= 0.109 */
    const int64_t q_next_y_9 = (int64_t)k2_y + k3_y;  /* F35 */
    const int32_t q_next_y_10 = round_1(q_next_y_9);  /* F34, |x| <= 0.109 */
    const int64_t q_next_z_9 = (int64_t)k2_z + k3_z;  /* F35 */
    const int32_t q_next_z_10 = round_1(q_next_z_9);  /* F34, |x| <= 0.109 */

    /* e = (1 - |q|^2)/2   [renormalisation, folded into the scalar part] */
    const int64_t e_1 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t e_2 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t e_3 = e_1 + e_2;  /* F61 */
    const int64_t e_4 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t e_5 = e_3 + e_4;  /* F61 */
    const int64_t e_6 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t e_7 = e_5 + e_6;  /* F61 */
    const int64_t e_8 = INT64_C(1152921504606846976) /* 1/2 */ - e_7;  /* F61 */
    const int32_t e = round_27(e_8);  /* F34, |x| <= 0.0645 */

    /* dq_e = dq + e q */
    const int64_t dq_e_w_17 = (int64_t)e * q_w;  /* F64 */
    const int64_t dq_e_w_18 = dq_e_w_17 * INT64_C(4);  /* F66 */
    const int64_t dq_e_w_19 = (int64_t)715827883 /* 1/6 */ * dq_e_w_14;  /* F66 */
    const int64_t dq_e_w_20 = (int64_t)1431655765 /* 1/3 */ * dq_e_w_16;  /* F66 */
    const int64_t dq_e_w_21 = dq_e_w_19 + dq_e_w_20;  /* F66 */
    const int64_t dq_e_w_22 = dq_e_w_18 - dq_e_w_21;  /* F66 */
    const int32_t dq_e_w = round_36(dq_e_w_22);  /* F30, |x| <= 0.123 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_e_w;  /* F30, |x| <= 1.06 */

    /* dq_e = dq + e q */
    const int64_t dq_e_x_1 = (int64_t)e * q_x;  /* F64 */
    const int32_t dq_e_x = round_32(dq_e_x_1);  /* F32, |x| <= 0.0685 */

    /* q_next = q + dq */
    const int64_t q_next_x_14 = q_x * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_x_15 = (int64_t)44739243 /* 1/6 */ * q_next_x_11;  /* F62 */
    const int64_t q_next_x_16 = q_next_x_14 + q_next_x_15;  /* F62 */
    const int64_t q_next_x_17 = (int64_t)89478485 /* 1/3 */ * q_next_x_13;  /* F62 */
    const int64_t q_next_x_18 = q_next_x_16 + q_next_x_17;  /* F62 */
    const int64_t q_next_x_19 = dq_e_x * INT64_C(1073741824);  /* F62 */
    const int64_t q_next_x_20 = q_next_x_18 + q_next_x_19;  /* F62 */
    const int32_t q_next_x = round_32(q_next_x_20);  /* F30, |x| <= 1.06 */

    /* dq_e = dq + e q */
    const int64_t dq_e_y_1 = (int64_t)e * q_y;  /* F64 */
    const int32_t dq_e_y = round_32(dq_e_y_1);  /* F32, |x| <= 0.0685 */

    /* q_next = q + dq */
    const int64_t q_next_y_11 = q_y * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_y_12 = (int64_t)44739243 /* 1/6 */ * q_next_y_8;  /* F62 */
    const int64_t q_next_y_13 = q_next_y_11 + q_next_y_12;  /* F62 */
    const int64_t q_next_y_14 = (int64_t)89478485 /* 1/3 */ * q_next_y_10;  /* F62 */
    const int64_t q_next_y_15 = q_next_y_13 + q_next_y_14;  /* F62 */
    const int64_t q_next_y_16 = dq_e_y * INT64_C(1073741824);  /* F62 */
    const int64_t q_next_y_17 = q_next_y_15 + q_next_y_16;  /* F62 */
    const int32_t q_next_y = round_32(q_next_y_17);  /* F30, |x| <= 1.06 */

    /* dq_e = dq + e q */
    const int64_t dq_e_z_1 = (int64_t)e * q_z;  /* F64 */
    const int32_t dq_e_z = round_32(dq_e_z_1);  /* F32, |x| <= 0.0685 */

    /* q_next = q + dq */
    const int64_t q_next_z_11 = q_z * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_z_12 = (int64_t)44739243 /* 1/6 */ * q_next_z_8;  /* F62 */
    const int64_t q_next_z_13 = q_next_z_11 + q_next_z_12;  /* F62 */
    const int64_t q_next_z_14 = (int64_t)89478485 /* 1/3 */ * q_next_z_10;  /* F62 */
    const int64_t q_next_z_15 = q_next_z_13 + q_next_z_14;  /* F62 */
    const int64_t q_next_z_16 = dq_e_z * INT64_C(1073741824);  /* F62 */
    const int64_t q_next_z_17 = q_next_z_15 + q_next_z_16;  /* F62 */
    const int32_t q_next_z = round_32(q_next_z_17);  /* F30, |x| <= 1.06 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void runge_kutta_4_quaternion_fixed32_quaternion(
    const runge_kutta_4_quaternion_fixed32_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.07 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.07 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.07 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.07 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}
