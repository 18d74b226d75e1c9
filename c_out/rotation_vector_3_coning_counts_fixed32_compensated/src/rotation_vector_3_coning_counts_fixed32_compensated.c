/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_counts_fixed32_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_counts_fixed32_compensated, SHA-256 of the design
 * 9b14171298474ac6d86ad9f442001eade149f9816a5fda86819d12b183ac5abc
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 3465 deg/s (60.476 rad/s), 100 updates/s; |dtheta| <= 0.20159 rad; |phi|
 *              <= 0.678 rad; | |q| - 1 | <= 0.1 always, proved; within it no sum overflows, as is
 *              proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 4 (cos) and 4 (sin) in |phi|^2; error of r at most
 *              2.2e-14 (scalar), 6.1e-15 (vector), proved over the rationals
 * rounding:    one update is within 9.3e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  3 of 28 rounded sums of products drop a whole word, 3 before formats were searched
 *              for that; of one update's errors in the first order it made 3.7e-09 of 3.7e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       56       0   40        13       0       0     0     0     0       0      0
 * update shared           52       4   40        13       0       0     0     0     0       0      0
 * update emitted          52       0   54        26       3       0     0     0     0       0     55
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_counts_fixed32_compensated.h"

#if ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_VERSION != 1
#error "rotation_vector_3_coning_counts_fixed32_compensated.h is of another version than this file: generate both again"
#endif

/* The word of 32 bits with these bits. */
static inline int32_t wrapped_32(uint32_t bits)
{
    return (bits <= (uint32_t)2147483647) ? (int32_t)bits : (-(int32_t)(~bits) - 1);
}

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

/* whole - 2^15 rounded; the result fits 32 bits. */
static inline int32_t left_of_15(int64_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 15);
    return wrapped_32(left);
}

/* whole - 2^3 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_3(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 3);
    return wrapped_32(left);
}

/* whole - 2^5 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_5(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 5);
    return wrapped_32(left);
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

/* x / 2^15, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_15(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(16384)) >> 15);
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

/* x / 2^38, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_38(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(137438953472), 38);
}

/* x / 2^40, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_40(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(549755813888), 40);
}

/* x / 2^3, rounded to nearest, halves up. */
static inline int32_t round_short_3(int32_t x)
{
    return shift_right_32(x + 4, 3);
}

/* x / 2^5, rounded to nearest, halves up. */
static inline int32_t round_short_5(int32_t x)
{
    return shift_right_32(x + 16, 5);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int64_t round_wide_1(int64_t x)
{
    return shift_right_64(x + INT64_C(1), 1);
}

/* x / 2^8, rounded to nearest, halves up. */
static inline int64_t round_wide_8(int64_t x)
{
    return shift_right_64(x + INT64_C(128), 8);
}

void rotation_vector_3_coning_counts_fixed32_compensated_init(
    rotation_vector_3_coning_counts_fixed32_compensated_state *state)
{
    state->q[0] = INT64_C(4611686018427387904) /* 1 */;
    state->q[1] = INT64_C(0);
    state->q[2] = INT64_C(0);
    state->q[3] = INT64_C(0);
    state->residual[0] = 0;
    state->residual[1] = 0;
    state->residual[2] = 0;
    state->residual[3] = 0;
    state->residual[4] = 0;
    state->residual[5] = 0;
    state->residual[6] = 0;
    state->residual[7] = 0;
    state->residual[8] = 0;
    state->residual[9] = 0;
    state->residual[10] = 0;
    state->residual[11] = 0;
    state->residual[12] = 0;
    state->residual[13] = 0;
    state->residual[14] = 0;
}

void rotation_vector_3_coning_counts_fixed32_compensated_set_quaternion(
    rotation_vector_3_coning_counts_fixed32_compensated_state *state, const int32_t q_nb[4])
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
    state->residual[0] = 0;
    state->residual[1] = 0;
    state->residual[2] = 0;
    state->residual[3] = 0;
    state->residual[4] = 0;
    state->residual[5] = 0;
    state->residual[6] = 0;
    state->residual[7] = 0;
    state->residual[8] = 0;
    state->residual[9] = 0;
    state->residual[10] = 0;
    state->residual[11] = 0;
    state->residual[12] = 0;
    state->residual[13] = 0;
    state->residual[14] = 0;
}

void rotation_vector_3_coning_counts_fixed32_compensated_update(
    rotation_vector_3_coning_counts_fixed32_compensated_state *state, const int16_t counts[9])
{
    /* attitude and input */
    const int16_t counts1_x = counts[0];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts1_y = counts[1];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts1_z = counts[2];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts2_x = counts[3];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts2_y = counts[4];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts2_z = counts[5];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts3_x = counts[6];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts3_y = counts[7];  /* F0, |x| <= 3.28e+04 */
    const int16_t counts3_z = counts[8];  /* F0, |x| <= 3.28e+04 */

    /* theta1 = quantum T/N counts, rad, the residue carried */
    const int64_t theta1_x_whole_1 = (int64_t)1998968549 * counts1_x;  /* F49 */
    const int32_t theta1_x_carried = state->residual[0];  /* F49 */
    const int64_t theta1_x_whole = theta1_x_whole_1 + theta1_x_carried;  /* F49 */
    const int32_t theta1_x = round_15(theta1_x_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta1_x_left = left_of_15(theta1_x_whole, theta1_x);  /* F49 */
    state->residual[0] = theta1_x_left;
    const int64_t theta1_y_whole_1 = (int64_t)1998968549 * counts1_y;  /* F49 */
    const int32_t theta1_y_carried = state->residual[1];  /* F49 */
    const int64_t theta1_y_whole = theta1_y_whole_1 + theta1_y_carried;  /* F49 */
    const int32_t theta1_y = round_15(theta1_y_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta1_y_left = left_of_15(theta1_y_whole, theta1_y);  /* F49 */
    state->residual[1] = theta1_y_left;
    const int64_t theta1_z_whole_1 = (int64_t)1998968549 * counts1_z;  /* F49 */
    const int32_t theta1_z_carried = state->residual[2];  /* F49 */
    const int64_t theta1_z_whole = theta1_z_whole_1 + theta1_z_carried;  /* F49 */
    const int32_t theta1_z = round_15(theta1_z_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta1_z_left = left_of_15(theta1_z_whole, theta1_z);  /* F49 */
    state->residual[2] = theta1_z_left;

    /* theta2 = quantum T/N counts, rad, the residue carried */
    const int64_t theta2_x_whole_1 = (int64_t)1998968549 * counts2_x;  /* F49 */
    const int32_t theta2_x_carried = state->residual[3];  /* F49 */
    const int64_t theta2_x_whole = theta2_x_whole_1 + theta2_x_carried;  /* F49 */
    const int32_t theta2_x = round_15(theta2_x_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta2_x_left = left_of_15(theta2_x_whole, theta2_x);  /* F49 */
    state->residual[3] = theta2_x_left;
    const int64_t theta2_y_whole_1 = (int64_t)1998968549 * counts2_y;  /* F49 */
    const int32_t theta2_y_carried = state->residual[4];  /* F49 */
    const int64_t theta2_y_whole = theta2_y_whole_1 + theta2_y_carried;  /* F49 */
    const int32_t theta2_y = round_15(theta2_y_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta2_y_left = left_of_15(theta2_y_whole, theta2_y);  /* F49 */
    state->residual[4] = theta2_y_left;
    const int64_t theta2_z_whole_1 = (int64_t)1998968549 * counts2_z;  /* F49 */
    const int32_t theta2_z_carried = state->residual[5];  /* F49 */
    const int64_t theta2_z_whole = theta2_z_whole_1 + theta2_z_carried;  /* F49 */
    const int32_t theta2_z = round_15(theta2_z_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta2_z_left = left_of_15(theta2_z_whole, theta2_z);  /* F49 */
    state->residual[5] = theta2_z_left;

    /* theta3 = quantum T/N counts, rad, the residue carried */
    const int64_t theta3_x_whole_1 = (int64_t)1998968549 * counts3_x;  /* F49 */
    const int32_t theta3_x_carried = state->residual[6];  /* F49 */
    const int64_t theta3_x_whole = theta3_x_whole_1 + theta3_x_carried;  /* F49 */
    const int32_t theta3_x = round_15(theta3_x_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta3_x_left = left_of_15(theta3_x_whole, theta3_x);  /* F49 */
    state->residual[6] = theta3_x_left;
    const int64_t theta3_y_whole_1 = (int64_t)1998968549 * counts3_y;  /* F49 */
    const int32_t theta3_y_carried = state->residual[7];  /* F49 */
    const int64_t theta3_y_whole = theta3_y_whole_1 + theta3_y_carried;  /* F49 */
    const int32_t theta3_y = round_15(theta3_y_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta3_y_left = left_of_15(theta3_y_whole, theta3_y);  /* F49 */
    state->residual[7] = theta3_y_left;
    const int64_t theta3_z_whole_1 = (int64_t)1998968549 * counts3_z;  /* F49 */
    const int32_t theta3_z_carried = state->residual[8];  /* F49 */
    const int64_t theta3_z_whole = theta3_z_whole_1 + theta3_z_carried;  /* F49 */
    const int32_t theta3_z = round_15(theta3_z_whole);  /* F34, |x| <= 0.117 */
    const int32_t theta3_z_left = left_of_15(theta3_z_whole, theta3_z);  /* F49 */
    state->residual[8] = theta3_z_left;

    /* d = theta_3 - theta_1 */
    const int64_t d_x_1 = (int64_t)theta3_x - theta1_x;  /* F34 */
    const int32_t d_x = round_1(d_x_1);  /* F33, |x| <= 0.233 */
    const int64_t d_y_1 = (int64_t)theta3_y - theta1_y;  /* F34 */
    const int32_t d_y = round_1(d_y_1);  /* F33, |x| <= 0.233 */
    const int64_t d_z_1 = (int64_t)theta3_z - theta1_z;  /* F34 */
    const int32_t d_z = round_1(d_z_1);  /* F33, |x| <= 0.233 */

    /* S = p + theta_2 */
    const int64_t S_x_1 = (int64_t)theta1_x + theta3_x;  /* F34 */
    const int64_t S_x_2 = S_x_1 + theta2_x;  /* F34 */
    const int32_t S_x = round_2(S_x_2);  /* F32, |x| <= 0.35 */
    const int64_t S_y_1 = (int64_t)theta1_y + theta3_y;  /* F34 */
    const int64_t S_y_2 = S_y_1 + theta2_y;  /* F34 */
    const int32_t S_y = round_2(S_y_2);  /* F32, |x| <= 0.35 */
    const int64_t S_z_1 = (int64_t)theta1_z + theta3_z;  /* F34 */
    const int64_t S_z_2 = S_z_1 + theta2_z;  /* F34 */
    const int32_t S_z = round_2(S_z_2);  /* F32, |x| <= 0.35 */

    /* g = S + 2 theta_2   [cao (12)] */
    const int64_t g_x_1 = S_x * INT64_C(2);  /* F33 */
    const int64_t g_x_2 = g_x_1 + theta2_x;  /* F33 */
    const int32_t g_x = round_2(g_x_2);  /* F31, |x| <= 0.582 */
    const int64_t g_y_1 = S_y * INT64_C(2);  /* F33 */
    const int64_t g_y_2 = g_y_1 + theta2_y;  /* F33 */
    const int32_t g_y = round_2(g_y_2);  /* F31, |x| <= 0.582 */
    const int64_t g_z_1 = S_z * INT64_C(2);  /* F33 */
    const int64_t g_z_2 = g_z_1 + theta2_z;  /* F33 */
    const int32_t g_z = round_2(g_z_2);  /* F31, |x| <= 0.582 */

    /* k = 9/40 d   [cao (12)] */
    const int64_t k_x_1 = (int64_t)1932735283 /* 9/40 */ * d_x;  /* F66 */
    const int32_t k_x = round_31(k_x_1);  /* F35, |x| <= 0.0524 */
    const int64_t k_y_1 = (int64_t)1932735283 /* 9/40 */ * d_y;  /* F66 */
    const int32_t k_y = round_31(k_y_1);  /* F35, |x| <= 0.0524 */
    const int64_t k_z_1 = (int64_t)1932735283 /* 9/40 */ * d_z;  /* F66 */
    const int32_t k_z = round_31(k_z_1);  /* F35, |x| <= 0.0524 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_x_1 = (int64_t)g_y * k_z;  /* F66 */
    const int64_t coning_x_2 = (int64_t)g_z * k_y;  /* F66 */
    const int64_t coning_x_3 = coning_x_1 - coning_x_2;  /* F66 */
    const int32_t coning_x = round_31(coning_x_3);  /* F35, |x| <= 0.061 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_x_fine_carried = state->residual[9];  /* F35 */
    const int32_t phi_x_fine_whole = coning_x + phi_x_fine_carried;  /* F35 */
    const int32_t phi_x_fine = round_short_3(phi_x_fine_whole);  /* F32 */
    const int32_t phi_x_fine_left = left_of_short_3(phi_x_fine_whole, phi_x_fine);  /* F35 */
    state->residual[9] = phi_x_fine_left;
    const int32_t phi_x = phi_x_fine + S_x;  /* F32, |x| <= 0.41 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_y_1 = (int64_t)g_z * k_x;  /* F66 */
    const int64_t coning_y_2 = (int64_t)g_x * k_z;  /* F66 */
    const int64_t coning_y_3 = coning_y_1 - coning_y_2;  /* F66 */
    const int32_t coning_y = round_31(coning_y_3);  /* F35, |x| <= 0.061 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_y_fine_carried = state->residual[10];  /* F35 */
    const int32_t phi_y_fine_whole = coning_y + phi_y_fine_carried;  /* F35 */
    const int32_t phi_y_fine = round_short_3(phi_y_fine_whole);  /* F32 */
    const int32_t phi_y_fine_left = left_of_short_3(phi_y_fine_whole, phi_y_fine);  /* F35 */
    state->residual[10] = phi_y_fine_left;
    const int32_t phi_y = phi_y_fine + S_y;  /* F32, |x| <= 0.41 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_z_1 = (int64_t)g_x * k_y;  /* F66 */
    const int64_t coning_z_2 = (int64_t)g_y * k_x;  /* F66 */
    const int64_t coning_z_3 = coning_z_1 - coning_z_2;  /* F66 */
    const int32_t coning_z = round_31(coning_z_3);  /* F35, |x| <= 0.061 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_z_fine_carried = state->residual[11];  /* F35 */
    const int32_t phi_z_fine_whole = coning_z + phi_z_fine_carried;  /* F35 */
    const int32_t phi_z_fine = round_short_3(phi_z_fine_whole);  /* F32 */
    const int32_t phi_z_fine_left = left_of_short_3(phi_z_fine_whole, phi_z_fine);  /* F35 */
    state->residual[11] = phi_z_fine_left;
    const int32_t phi_z = phi_z_fine + S_z;  /* F32, |x| <= 0.41 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)phi_x * phi_x;  /* F64 */
    const int64_t phi_square_2 = (int64_t)phi_y * phi_y;  /* F64 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F64 */
    const int64_t phi_square_4 = (int64_t)phi_z * phi_z;  /* F64 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F64 */
    const int32_t phi_square = round_32(phi_square_5);  /* F32, |x| <= 0.461 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)3398133 /* 1/10354030 */ * phi_square;  /* F77 */
    const int64_t u_2 = u_1 - INT64_C(3279403634609748725) /* 69/3179537 */;  /* F77 */
    const int32_t u_3 = round_38(u_2);  /* F39, |x| <= 2.18e-05 */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F71 */
    const int64_t u_5 = INT64_C(6148914649160466235) /* 380568/146138113 */ + u_4;  /* F71 */
    const int32_t u_6 = round_38(u_5);  /* F33, |x| <= 0.00261 */
    const int64_t u_7 = (int64_t)phi_square * u_6;  /* F65 */
    const int64_t u_8 = u_7 - INT64_C(4611686018394242878) /* 17392074033/139136592265 */;  /* F65 */
    const int32_t u_9 = round_32(u_8);  /* F33, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)6043689 /* 1/186293496 */ * phi_square;  /* F82 */
    const int64_t y_2 = y_1 - INT64_C(7495790237886259762) /* 11/7096348 */;  /* F82 */
    const int32_t y_3 = round_40(y_2);  /* F42, |x| <= 1.56e-06 */
    const int64_t y_4 = (int64_t)phi_square * y_3;  /* F74 */
    const int64_t y_5 = INT64_C(4919131732909839979) /* 63798/244984321 */ + y_4;  /* F74 */
    const int32_t y_6 = round_38(y_5);  /* F36, |x| <= 0.000261 */
    const int64_t y_7 = (int64_t)phi_square * y_6;  /* F68 */
    const int64_t y_8 = y_7 - INT64_C(6148914691215809884) /* 6186333129/296943990193 */;  /* F68 */
    const int32_t y_9 = round_32(y_8);  /* F36, |x| <= 0.0209 */
    const int64_t y_10 = (int64_t)phi_square * y_9;  /* F68 */
    const int32_t y = round_31(y_10);  /* F37, |x| <= 0.0096 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * phi_x;  /* F69 */
    const int32_t bent_x = round_31(bent_x_1);  /* F38, |x| <= 0.00394 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_x_fine_carried = state->residual[12];  /* F38 */
    const int32_t v_x_fine_whole = bent_x + v_x_fine_carried;  /* F38 */
    const int32_t v_x_fine = round_short_5(v_x_fine_whole);  /* F33 */
    const int32_t v_x_fine_left = left_of_short_5(v_x_fine_whole, v_x_fine);  /* F38 */
    state->residual[12] = v_x_fine_left;
    const int32_t v_x = v_x_fine + phi_x;  /* F33, |x| <= 0.209 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * phi_y;  /* F69 */
    const int32_t bent_y = round_31(bent_y_1);  /* F38, |x| <= 0.00394 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_y_fine_carried = state->residual[13];  /* F38 */
    const int32_t v_y_fine_whole = bent_y + v_y_fine_carried;  /* F38 */
    const int32_t v_y_fine = round_short_5(v_y_fine_whole);  /* F33 */
    const int32_t v_y_fine_left = left_of_short_5(v_y_fine_whole, v_y_fine);  /* F38 */
    state->residual[13] = v_y_fine_left;
    const int32_t v_y = v_y_fine + phi_y;  /* F33, |x| <= 0.209 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * phi_z;  /* F69 */
    const int32_t bent_z = round_31(bent_z_1);  /* F38, |x| <= 0.00394 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_z_fine_carried = state->residual[14];  /* F38 */
    const int32_t v_z_fine_whole = bent_z + v_z_fine_carried;  /* F38 */
    const int32_t v_z_fine = round_short_5(v_z_fine_whole);  /* F33 */
    const int32_t v_z_fine_left = left_of_short_5(v_z_fine_whole, v_z_fine);  /* F38 */
    state->residual[14] = v_z_fine_left;
    const int32_t v_z = v_z_fine + phi_z;  /* F33, |x| <= 0.209 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_10 = (int64_t)phi_square * u_9;  /* F65 */
    const int32_t u = round_30(u_10);  /* F35, |x| <= 0.0576 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(67108864);  /* F61 */
    const int64_t a_2 = a_1 + INT64_C(1152921504606846976) /* 1/2 */;  /* F61 */

    /* attitude and input */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.11 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.11 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.11 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.11 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.11 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.11 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.11 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.11 */

    /* a = u + e */
    const int64_t a_3 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t a_4 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t a_5 = a_3 + a_4;  /* F61 */
    const int64_t a_6 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t a_7 = a_5 + a_6;  /* F61 */
    const int64_t a_8 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t a_9 = a_7 + a_8;  /* F61 */
    const int64_t a_10 = a_2 - a_9;  /* F61 */
    const int32_t a = round_28(a_10);  /* F33, |x| <= 0.163 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t v_x_negated = -v_x;  /* F33 */
    const int32_t v_y_negated = -v_y;  /* F33 */
    const int32_t v_z_negated = -v_z;  /* F33 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F63 */
    const int64_t dq_w_2 = (int64_t)q_x * v_x_negated;  /* F63 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F63 */
    const int64_t dq_w_4 = (int64_t)q_y * v_y_negated;  /* F63 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F63 */
    const int64_t dq_w_6 = (int64_t)q_z * v_z_negated;  /* F63 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F63 */
    const int64_t dq_w = round_wide_1(dq_w_7);  /* F62, |x| <= 0.421 */

    /* q_next = q + dq */
    const int64_t q_next_w = q_w_whole + dq_w;  /* F62, |x| <= 1.07 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F63 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F63 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F63 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F63 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F63 */
    const int64_t dq_x_6 = (int64_t)q_z * v_y_negated;  /* F63 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F63 */
    const int64_t dq_x = round_wide_1(dq_x_7);  /* F62, |x| <= 0.421 */

    /* q_next = q + dq */
    const int64_t q_next_x = q_x_whole + dq_x;  /* F62, |x| <= 1.07 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F63 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F63 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F63 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F63 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F63 */
    const int64_t dq_y_6 = (int64_t)q_x * v_z_negated;  /* F63 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F63 */
    const int64_t dq_y = round_wide_1(dq_y_7);  /* F62, |x| <= 0.421 */

    /* q_next = q + dq */
    const int64_t q_next_y = q_y_whole + dq_y;  /* F62, |x| <= 1.07 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F63 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F63 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F63 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F63 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F63 */
    const int64_t dq_z_6 = (int64_t)q_y * v_x_negated;  /* F63 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F63 */
    const int64_t dq_z = round_wide_1(dq_z_7);  /* F62, |x| <= 0.421 */

    /* q_next = q + dq */
    const int64_t q_next_z = q_z_whole + dq_z;  /* F62, |x| <= 1.07 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_counts_fixed32_compensated_quaternion(
    const rotation_vector_3_coning_counts_fixed32_compensated_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.11 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.11 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.11 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.11 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.11 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.11 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.11 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.11 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}
