/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_rate_fixed32
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rate_fixed32, SHA-256 of the design
 * 3ae4617739c375514976a5ec496c47ad432deb9d402d3822246506f56b078e39
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (17.322 rad/s), 100 updates/s; |dtheta| <= 0.081797 rad; |phi|
 *              <= 0.2575 rad; | |q| - 1 | <= 0.0156 always, proved; each component of an input
 *              beyond it is clamped to it
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.2e-14 (scalar), 3.1e-12 (vector), proved over the rationals
 * rounding:    one update is within 3.3e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  17 of 29 rounded sums of products drop a whole word, 11 before formats were
 *              searched for that; of one update's errors in the first order it made 3.4e-09 of
 *              3.3e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       80       0   64        13       0       0     0     0     0       0      0
 * update shared           76       4   64        13       0       0     0     0     0       0      0
 * update emitted          76       0   55        19       3       0     0     0     0       9     63
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_rate_fixed32.h"

#if ROTATION_VECTOR_3_CONING_RATE_FIXED32_VERSION != 1
#error "rotation_vector_3_coning_rate_fixed32.h is of another version than this file: generate both again"
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

/* x / 2^27, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_27(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(67108864)) >> 27);
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

/* x / 2^36, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_36(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(34359738368), 36);
}

/* x / 2^40, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_40(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(549755813888), 40);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int32_t round_short_1(int32_t x)
{
    return shift_right_32(x + 1, 1);
}

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

void rotation_vector_3_coning_rate_fixed32_init(rotation_vector_3_coning_rate_fixed32_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
    state->omega_last[0] = 0;
    state->omega_last[1] = 0;
    state->omega_last[2] = 0;
}

void rotation_vector_3_coning_rate_fixed32_set_quaternion(
    rotation_vector_3_coning_rate_fixed32_state *state, const int32_t q_nb[4])
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

void rotation_vector_3_coning_rate_fixed32_start(
    rotation_vector_3_coning_rate_fixed32_state *state, const int32_t omega[3])
{
    /* each component limited to the declared range */
    const int32_t omega_x = omega[0];  /* F25, |x| <= 64 */
    const int32_t omega_y = omega[1];  /* F25, |x| <= 64 */
    const int32_t omega_z = omega[2];  /* F25, |x| <= 64 */
    const int32_t omega_last_x_1 = clamp_32(omega_x, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t omega_last_y_1 = clamp_32(omega_y, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t omega_last_z_1 = clamp_32(omega_z, -335569049, 335569049);  /* F25, |x| <= 10.1 */

    state->omega_last[0] = omega_last_x_1;
    state->omega_last[1] = omega_last_y_1;
    state->omega_last[2] = omega_last_z_1;
}

void rotation_vector_3_coning_rate_fixed32_update(
    rotation_vector_3_coning_rate_fixed32_state *state, const int32_t omega[9])
{
    /* attitude and input */
    const int32_t omega1_x = omega[0];  /* F25, |x| <= 64 */
    const int32_t omega1_y = omega[1];  /* F25, |x| <= 64 */
    const int32_t omega1_z = omega[2];  /* F25, |x| <= 64 */
    const int32_t omega2_x = omega[3];  /* F25, |x| <= 64 */
    const int32_t omega2_y = omega[4];  /* F25, |x| <= 64 */
    const int32_t omega2_z = omega[5];  /* F25, |x| <= 64 */
    const int32_t omega3_x = omega[6];  /* F25, |x| <= 64 */
    const int32_t omega3_y = omega[7];  /* F25, |x| <= 64 */
    const int32_t omega3_z = omega[8];  /* F25, |x| <= 64 */

    /* each component limited to the declared range */
    const int32_t theta1_x_1 = clamp_32(omega1_x, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_y_1 = clamp_32(omega1_y, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_z_1 = clamp_32(omega1_z, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_x_2 = clamp_32(omega2_x, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_y_2 = clamp_32(omega2_y, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_z_2 = clamp_32(omega2_z, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_x_3 = clamp_32(omega3_x, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_y_3 = clamp_32(omega3_y, -335569049, 335569049);  /* F25, |x| <= 10.1 */
    const int32_t theta1_z_3 = clamp_32(omega3_z, -335569049, 335569049);  /* F25, |x| <= 10.1 */

    /* the sample at the start of the interval */
    const int32_t omega_last_x = state->omega_last[0];  /* F25, |x| <= 17.4 */
    const int32_t omega_last_y = state->omega_last[1];  /* F25, |x| <= 17.4 */
    const int32_t omega_last_z = state->omega_last[2];  /* F25, |x| <= 17.4 */

    /* theta1 = T (1/8 w0 + 19/72 w1 - 5/72 w2 + 1/72 w3)   [polynomial through all samples] */
    const int64_t theta1_x_4 = (int64_t)1374389535 /* 1/800 */ * omega_last_x;  /* F65 */
    const int64_t theta1_x_5 = theta1_x_4 * INT64_C(4);  /* F67 */
    const int64_t theta1_x_6 = (int64_t)1450744509 /* 19/7200 */ * theta1_x_1;  /* F64 */
    const int64_t theta1_x_7 = theta1_x_6 * INT64_C(8);  /* F67 */
    const int64_t theta1_x_8 = theta1_x_5 + theta1_x_7;  /* F67 */
    const int64_t theta1_x_9 = (int64_t)610839793 /* 1/7200 */ * theta1_x_3;  /* F67 */
    const int64_t theta1_x_10 = theta1_x_8 + theta1_x_9;  /* F67 */
    const int64_t theta1_x_11 = (int64_t)1527099483 /* 1/1440 */ * theta1_x_2;  /* F66 */
    const int64_t theta1_x_12 = theta1_x_11 * INT64_C(2);  /* F67 */
    const int64_t theta1_x_13 = theta1_x_10 - theta1_x_12;  /* F67 */
    const int32_t theta1_x = round_32(theta1_x_13);  /* F35, |x| <= 0.0564 */
    const int64_t theta1_y_4 = (int64_t)1374389535 /* 1/800 */ * omega_last_y;  /* F65 */
    const int64_t theta1_y_5 = theta1_y_4 * INT64_C(4);  /* F67 */
    const int64_t theta1_y_6 = (int64_t)1450744509 /* 19/7200 */ * theta1_y_1;  /* F64 */
    const int64_t theta1_y_7 = theta1_y_6 * INT64_C(8);  /* F67 */
    const int64_t theta1_y_8 = theta1_y_5 + theta1_y_7;  /* F67 */
    const int64_t theta1_y_9 = (int64_t)610839793 /* 1/7200 */ * theta1_y_3;  /* F67 */
    const int64_t theta1_y_10 = theta1_y_8 + theta1_y_9;  /* F67 */
    const int64_t theta1_y_11 = (int64_t)1527099483 /* 1/1440 */ * theta1_y_2;  /* F66 */
    const int64_t theta1_y_12 = theta1_y_11 * INT64_C(2);  /* F67 */
    const int64_t theta1_y_13 = theta1_y_10 - theta1_y_12;  /* F67 */
    const int32_t theta1_y = round_32(theta1_y_13);  /* F35, |x| <= 0.0564 */
    const int64_t theta1_z_4 = (int64_t)1374389535 /* 1/800 */ * omega_last_z;  /* F65 */
    const int64_t theta1_z_5 = theta1_z_4 * INT64_C(4);  /* F67 */
    const int64_t theta1_z_6 = (int64_t)1450744509 /* 19/7200 */ * theta1_z_1;  /* F64 */
    const int64_t theta1_z_7 = theta1_z_6 * INT64_C(8);  /* F67 */
    const int64_t theta1_z_8 = theta1_z_5 + theta1_z_7;  /* F67 */
    const int64_t theta1_z_9 = (int64_t)610839793 /* 1/7200 */ * theta1_z_3;  /* F67 */
    const int64_t theta1_z_10 = theta1_z_8 + theta1_z_9;  /* F67 */
    const int64_t theta1_z_11 = (int64_t)1527099483 /* 1/1440 */ * theta1_z_2;  /* F66 */
    const int64_t theta1_z_12 = theta1_z_11 * INT64_C(2);  /* F67 */
    const int64_t theta1_z_13 = theta1_z_10 - theta1_z_12;  /* F67 */
    const int32_t theta1_z = round_32(theta1_z_13);  /* F35, |x| <= 0.0564 */

    /* theta2 = T (- 1/72 w0 + 13/72 w1 + 13/72 w2 - 1/72 w3)   [polynomial through all samples] */
    const int64_t theta2_x_1 = (int64_t)124076833 /* 13/7200 */ * theta1_x_1;  /* F61 */
    const int64_t theta2_x_2 = theta2_x_1 * INT64_C(64);  /* F67 */
    const int64_t theta2_x_3 = (int64_t)124076833 /* 13/7200 */ * theta1_x_2;  /* F61 */
    const int64_t theta2_x_4 = theta2_x_3 * INT64_C(64);  /* F67 */
    const int64_t theta2_x_5 = theta2_x_2 + theta2_x_4;  /* F67 */
    const int64_t theta2_x_6 = (int64_t)610839793 /* 1/7200 */ * omega_last_x;  /* F67 */
    const int64_t theta2_x_7 = (int64_t)610839793 /* 1/7200 */ * theta1_x_3;  /* F67 */
    const int64_t theta2_x_8 = theta2_x_6 + theta2_x_7;  /* F67 */
    const int64_t theta2_x_9 = theta2_x_5 - theta2_x_8;  /* F67 */
    const int32_t theta2_x = round_32(theta2_x_9);  /* F35, |x| <= 0.04 */
    const int64_t theta2_y_1 = (int64_t)124076833 /* 13/7200 */ * theta1_y_1;  /* F61 */
    const int64_t theta2_y_2 = theta2_y_1 * INT64_C(64);  /* F67 */
    const int64_t theta2_y_3 = (int64_t)124076833 /* 13/7200 */ * theta1_y_2;  /* F61 */
    const int64_t theta2_y_4 = theta2_y_3 * INT64_C(64);  /* F67 */
    const int64_t theta2_y_5 = theta2_y_2 + theta2_y_4;  /* F67 */
    const int64_t theta2_y_6 = (int64_t)610839793 /* 1/7200 */ * omega_last_y;  /* F67 */
    const int64_t theta2_y_7 = (int64_t)610839793 /* 1/7200 */ * theta1_y_3;  /* F67 */
    const int64_t theta2_y_8 = theta2_y_6 + theta2_y_7;  /* F67 */
    const int64_t theta2_y_9 = theta2_y_5 - theta2_y_8;  /* F67 */
    const int32_t theta2_y = round_32(theta2_y_9);  /* F35, |x| <= 0.04 */
    const int64_t theta2_z_1 = (int64_t)124076833 /* 13/7200 */ * theta1_z_1;  /* F61 */
    const int64_t theta2_z_2 = theta2_z_1 * INT64_C(64);  /* F67 */
    const int64_t theta2_z_3 = (int64_t)124076833 /* 13/7200 */ * theta1_z_2;  /* F61 */
    const int64_t theta2_z_4 = theta2_z_3 * INT64_C(64);  /* F67 */
    const int64_t theta2_z_5 = theta2_z_2 + theta2_z_4;  /* F67 */
    const int64_t theta2_z_6 = (int64_t)610839793 /* 1/7200 */ * omega_last_z;  /* F67 */
    const int64_t theta2_z_7 = (int64_t)610839793 /* 1/7200 */ * theta1_z_3;  /* F67 */
    const int64_t theta2_z_8 = theta2_z_6 + theta2_z_7;  /* F67 */
    const int64_t theta2_z_9 = theta2_z_5 - theta2_z_8;  /* F67 */
    const int32_t theta2_z = round_32(theta2_z_9);  /* F35, |x| <= 0.04 */

    /* theta3 = T (1/72 w0 - 5/72 w1 + 19/72 w2 + 1/8 w3)   [polynomial through all samples] */
    const int64_t theta3_x_1 = (int64_t)610839793 /* 1/7200 */ * omega_last_x;  /* F67 */
    const int64_t theta3_x_2 = (int64_t)1450744509 /* 19/7200 */ * theta1_x_2;  /* F64 */
    const int64_t theta3_x_3 = theta3_x_2 * INT64_C(8);  /* F67 */
    const int64_t theta3_x_4 = theta3_x_1 + theta3_x_3;  /* F67 */
    const int64_t theta3_x_5 = (int64_t)1374389535 /* 1/800 */ * theta1_x_3;  /* F65 */
    const int64_t theta3_x_6 = theta3_x_5 * INT64_C(4);  /* F67 */
    const int64_t theta3_x_7 = theta3_x_4 + theta3_x_6;  /* F67 */
    const int64_t theta3_x_8 = (int64_t)1527099483 /* 1/1440 */ * theta1_x_1;  /* F66 */
    const int64_t theta3_x_9 = theta3_x_8 * INT64_C(2);  /* F67 */
    const int64_t theta3_x_10 = theta3_x_7 - theta3_x_9;  /* F67 */
    const int32_t theta3_x = round_32(theta3_x_10);  /* F35, |x| <= 0.0483 */
    const int64_t theta3_y_1 = (int64_t)610839793 /* 1/7200 */ * omega_last_y;  /* F67 */
    const int64_t theta3_y_2 = (int64_t)1450744509 /* 19/7200 */ * theta1_y_2;  /* F64 */
    const int64_t theta3_y_3 = theta3_y_2 * INT64_C(8);  /* F67 */
    const int64_t theta3_y_4 = theta3_y_1 + theta3_y_3;  /* F67 */
    const int64_t theta3_y_5 = (int64_t)1374389535 /* 1/800 */ * theta1_y_3;  /* F65 */
    const int64_t theta3_y_6 = theta3_y_5 * INT64_C(4);  /* F67 */
    const int64_t theta3_y_7 = theta3_y_4 + theta3_y_6;  /* F67 */
    const int64_t theta3_y_8 = (int64_t)1527099483 /* 1/1440 */ * theta1_y_1;  /* F66 */
    const int64_t theta3_y_9 = theta3_y_8 * INT64_C(2);  /* F67 */
    const int64_t theta3_y_10 = theta3_y_7 - theta3_y_9;  /* F67 */
    const int32_t theta3_y = round_32(theta3_y_10);  /* F35, |x| <= 0.0483 */
    const int64_t theta3_z_1 = (int64_t)610839793 /* 1/7200 */ * omega_last_z;  /* F67 */
    const int64_t theta3_z_2 = (int64_t)1450744509 /* 19/7200 */ * theta1_z_2;  /* F64 */
    const int64_t theta3_z_3 = theta3_z_2 * INT64_C(8);  /* F67 */
    const int64_t theta3_z_4 = theta3_z_1 + theta3_z_3;  /* F67 */
    const int64_t theta3_z_5 = (int64_t)1374389535 /* 1/800 */ * theta1_z_3;  /* F65 */
    const int64_t theta3_z_6 = theta3_z_5 * INT64_C(4);  /* F67 */
    const int64_t theta3_z_7 = theta3_z_4 + theta3_z_6;  /* F67 */
    const int64_t theta3_z_8 = (int64_t)1527099483 /* 1/1440 */ * theta1_z_1;  /* F66 */
    const int64_t theta3_z_9 = theta3_z_8 * INT64_C(2);  /* F67 */
    const int64_t theta3_z_10 = theta3_z_7 - theta3_z_9;  /* F67 */
    const int32_t theta3_z = round_32(theta3_z_10);  /* F35, |x| <= 0.0483 */

    /* d = theta_3 - theta_1 */
    const int64_t d_x_1 = (int64_t)theta3_x - theta1_x;  /* F35 */
    const int32_t d_x = round_1(d_x_1);  /* F34, |x| <= 0.105 */
    const int64_t d_y_1 = (int64_t)theta3_y - theta1_y;  /* F35 */
    const int32_t d_y = round_1(d_y_1);  /* F34, |x| <= 0.105 */
    const int64_t d_z_1 = (int64_t)theta3_z - theta1_z;  /* F35 */
    const int32_t d_z = round_1(d_z_1);  /* F34, |x| <= 0.105 */

    /* S = p + theta_2 */
    const int64_t S_x_1 = (int64_t)theta1_x + theta3_x;  /* F35 */
    const int64_t S_x_2 = S_x_1 + theta2_x;  /* F35 */
    const int32_t S_x = round_2(S_x_2);  /* F33, |x| <= 0.145 */
    const int64_t S_y_1 = (int64_t)theta1_y + theta3_y;  /* F35 */
    const int64_t S_y_2 = S_y_1 + theta2_y;  /* F35 */
    const int32_t S_y = round_2(S_y_2);  /* F33, |x| <= 0.145 */
    const int64_t S_z_1 = (int64_t)theta1_z + theta3_z;  /* F35 */
    const int64_t S_z_2 = S_z_1 + theta2_z;  /* F35 */
    const int32_t S_z = round_2(S_z_2);  /* F33, |x| <= 0.145 */

    /* g = S + 2 theta_2   [cao (12)] */
    const int32_t g_x_fine = round_short_1(theta2_x);  /* F33 */
    const int32_t g_x = g_x_fine + S_x;  /* F33, |x| <= 0.225 */
    const int32_t g_y_fine = round_short_1(theta2_y);  /* F33 */
    const int32_t g_y = g_y_fine + S_y;  /* F33, |x| <= 0.225 */
    const int32_t g_z_fine = round_short_1(theta2_z);  /* F33 */
    const int32_t g_z = g_z_fine + S_z;  /* F33, |x| <= 0.225 */

    /* k = 9/40 d   [cao (12)] */
    const int64_t k_x_1 = (int64_t)1932735283 /* 9/40 */ * d_x;  /* F67 */
    const int32_t k_x = round_32(k_x_1);  /* F35, |x| <= 0.0236 */
    const int64_t k_y_1 = (int64_t)1932735283 /* 9/40 */ * d_y;  /* F67 */
    const int32_t k_y = round_32(k_y_1);  /* F35, |x| <= 0.0236 */
    const int64_t k_z_1 = (int64_t)1932735283 /* 9/40 */ * d_z;  /* F67 */
    const int32_t k_z = round_32(k_z_1);  /* F35, |x| <= 0.0236 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_x_1 = (int64_t)g_y * k_z;  /* F68 */
    const int64_t coning_x_2 = (int64_t)g_z * k_y;  /* F68 */
    const int64_t coning_x_3 = coning_x_1 - coning_x_2;  /* F68 */
    const int32_t coning_x = round_35(coning_x_3);  /* F33, |x| <= 0.0106 */

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_x = S_x + coning_x;  /* F33, |x| <= 0.156 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_y_1 = (int64_t)g_z * k_x;  /* F68 */
    const int64_t coning_y_2 = (int64_t)g_x * k_z;  /* F68 */
    const int64_t coning_y_3 = coning_y_1 - coning_y_2;  /* F68 */
    const int32_t coning_y = round_35(coning_y_3);  /* F33, |x| <= 0.0106 */

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_y = S_y + coning_y;  /* F33, |x| <= 0.156 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_z_1 = (int64_t)g_x * k_y;  /* F68 */
    const int64_t coning_z_2 = (int64_t)g_y * k_x;  /* F68 */
    const int64_t coning_z_3 = coning_z_1 - coning_z_2;  /* F68 */
    const int32_t coning_z = round_35(coning_z_3);  /* F33, |x| <= 0.0106 */

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_z = S_z + coning_z;  /* F33, |x| <= 0.156 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)phi_x * phi_x;  /* F66 */
    const int64_t phi_square_2 = (int64_t)phi_y * phi_y;  /* F66 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F66 */
    const int64_t phi_square_4 = (int64_t)phi_z * phi_z;  /* F66 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F66 */
    const int32_t phi_square = round_32(phi_square_5);  /* F34, |x| <= 0.0598 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)1490459 /* 4/184425 */ * phi_square;  /* F70 */
    const int64_t u_2 = INT64_C(3074456783371216934) /* 14240/5468161 */ - u_1;  /* F70 */
    const int32_t u_3 = round_40(u_2);  /* F30, |x| <= 0.00261 */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F64 */
    const int64_t u_5 = u_4 - INT64_C(2305843009115511554) /* 2935662433/23485299465 */;  /* F64 */
    const int32_t u_6 = round_32(u_5);  /* F32, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)2235647 /* 27/103741 */ * phi_square;  /* F67 */
    const int64_t y_2 = y_1 - INT64_C(3074456826063875719) /* 123281/5917489 */;  /* F67 */
    const int32_t y_3 = round_32(y_2);  /* F35, |x| <= 0.0209 */
    const int64_t y_4 = (int64_t)phi_square * y_3;  /* F69 */
    const int32_t y = round_32(y_4);  /* F37, |x| <= 0.00125 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * phi_x;  /* F70 */
    const int32_t bent_x = round_36(bent_x_1);  /* F34, |x| <= 0.000194 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x = phi_x + bent_x;  /* F34, |x| <= 0.0778 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * phi_y;  /* F70 */
    const int32_t bent_y = round_36(bent_y_1);  /* F34, |x| <= 0.000194 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y = phi_y + bent_y;  /* F34, |x| <= 0.0778 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * phi_z;  /* F70 */
    const int32_t bent_z = round_36(bent_z_1);  /* F34, |x| <= 0.000194 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z = phi_z + bent_z;  /* F34, |x| <= 0.0778 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_7 = (int64_t)phi_square * u_6;  /* F66 */
    const int32_t u = round_32(u_7);  /* F34, |x| <= 0.00747 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(134217728);  /* F61 */
    const int64_t a_2 = a_1 + INT64_C(1152921504606846976) /* 1/2 */;  /* F61 */

    /* attitude and input */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.02 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.02 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.02 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.02 */

    /* a = u + e */
    const int64_t a_3 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t a_4 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t a_5 = a_3 + a_4;  /* F61 */
    const int64_t a_6 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t a_7 = a_5 + a_6;  /* F61 */
    const int64_t a_8 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t a_9 = a_7 + a_8;  /* F61 */
    const int64_t a_10 = a_2 - a_9;  /* F61 */
    const int32_t a = round_27(a_10);  /* F34, |x| <= 0.0233 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t q_x_negated = -q_x;  /* F30 */
    const int32_t q_y_negated = -q_y;  /* F30 */
    const int32_t q_z_negated = -q_z;  /* F30 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F64 */
    const int64_t dq_w_2 = (int64_t)q_x_negated * v_x;  /* F64 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F64 */
    const int64_t dq_w_4 = (int64_t)q_y_negated * v_y;  /* F64 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F64 */
    const int64_t dq_w_6 = (int64_t)q_z_negated * v_z;  /* F64 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F64 */
    const int32_t dq_w = round_34(dq_w_7);  /* F30, |x| <= 0.127 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F64 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F64 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F64 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F64 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F64 */
    const int64_t dq_x_6 = (int64_t)q_z_negated * v_y;  /* F64 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F64 */
    const int32_t dq_x = round_34(dq_x_7);  /* F30, |x| <= 0.127 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F64 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F64 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F64 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F64 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F64 */
    const int64_t dq_y_6 = (int64_t)q_x_negated * v_z;  /* F64 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F64 */
    const int32_t dq_y = round_34(dq_y_7);  /* F30, |x| <= 0.127 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F64 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F64 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F64 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F64 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F64 */
    const int64_t dq_z_6 = (int64_t)q_y_negated * v_x;  /* F64 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F64 */
    const int32_t dq_z = round_34(dq_z_7);  /* F30, |x| <= 0.127 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = theta1_x_3;
    state->omega_last[1] = theta1_y_3;
    state->omega_last[2] = theta1_z_3;
}

void rotation_vector_3_coning_rate_fixed32_quaternion(
    const rotation_vector_3_coning_rate_fixed32_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.02 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.02 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.02 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.02 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}
