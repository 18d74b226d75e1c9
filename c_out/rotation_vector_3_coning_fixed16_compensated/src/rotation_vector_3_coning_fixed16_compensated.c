/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_fixed16_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_fixed16_compensated, SHA-256 of the design
 * 66c168fe78656ad166a9c298e8b934d1a669109f574b48ea597cf71b2231ecdc
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed16: words of 16 bits, sums in 32; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              2.5e-11 (scalar), 4.2e-10 (vector), proved over the rationals
 * rounding:    one update is within 0.00028 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       42       0   35        13       0       0     0     0     0       0      0
 * update shared           38       4   35        13       0       0     0     0     0       0      0
 * update emitted          38       0   39        18       1       0     0     0     0       0     54
 * dcm as-written           9       0    9         6       0       0     0     0     0       0      0
 * dcm shared               9       0    9         6       0       0     0     0     0       0      0
 * dcm emitted              9       0    6         6       0       0     0     0     0       0     19
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_fixed16_compensated.h"

#if ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_VERSION != 1
#error "rotation_vector_3_coning_fixed16_compensated.h is of another version than this file: generate both again"
#endif

/* The word of 16 bits with these bits. */
static inline int16_t wrapped_16(uint16_t bits)
{
    return (bits <= (uint16_t)32767) ? (int16_t)bits : ((int16_t)(-(int16_t)(uint16_t)(~bits) - 1));
}

/* x / 2^bits, rounded down, 0 <= bits < 32. */
static inline int32_t shift_right_32(int32_t x, int bits)
{
    return ((((int32_t)-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));
}

/* whole - 2^5 rounded; the result fits 16 bits. */
static inline int16_t left_of_5(int32_t whole, int16_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 5);
    return wrapped_16((uint16_t)left);
}

/* whole - 2^11 rounded; the result fits 16 bits. */
static inline int16_t left_of_11(int32_t whole, int16_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 11);
    return wrapped_16((uint16_t)left);
}

/* x / 2^1, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_1(int32_t x)
{
    return (int16_t)shift_right_32(x + 1, 1);
}

/* x / 2^5, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_5(int32_t x)
{
    return (int16_t)shift_right_32(x + 16, 5);
}

/* x / 2^8, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_8(int32_t x)
{
    return (int16_t)shift_right_32(x + 128, 8);
}

/* x / 2^11, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_11(int32_t x)
{
    return (int16_t)shift_right_32(x + 1024, 11);
}

/* x / 2^13, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_13(int32_t x)
{
    return (int16_t)shift_right_32(x + 4096, 13);
}

/* x / 2^14, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_14(int32_t x)
{
    return (int16_t)shift_right_32(x + 8192, 14);
}

/* x / 2^15, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_15(int32_t x)
{
    return (int16_t)shift_right_32(x + 16384, 15);
}

/* x / 2^16, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_16(int32_t x)
{
    return (int16_t)shift_right_32(x + 32768, 16);
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

void rotation_vector_3_coning_fixed16_compensated_init(
    rotation_vector_3_coning_fixed16_compensated_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
    state->residual[0] = 0;
    state->residual[1] = 0;
    state->residual[2] = 0;
    state->residual[3] = 0;
    state->residual[4] = 0;
    state->residual[5] = 0;
}

void rotation_vector_3_coning_fixed16_compensated_set_quaternion(
    rotation_vector_3_coning_fixed16_compensated_state *state, const int16_t q_nb[4])
{
    /* q_nb, read once */
    const int16_t q_nb_w = q_nb[0];  /* F14, |x| <= 1.01 */
    const int16_t q_nb_x = q_nb[1];  /* F14, |x| <= 1.01 */
    const int16_t q_nb_y = q_nb[2];  /* F14, |x| <= 1.01 */
    const int16_t q_nb_z = q_nb[3];  /* F14, |x| <= 1.01 */

    /* e = (1 - |q|^2)/2 */
    const int32_t e_1 = (int32_t)q_nb_w * q_nb_w;  /* F28 */
    const int32_t e_2 = (int32_t)q_nb_x * q_nb_x;  /* F28 */
    const int32_t e_3 = e_1 + e_2;  /* F29 */
    const int32_t e_4 = (int32_t)q_nb_y * q_nb_y;  /* F28 */
    const int32_t e_5 = e_3 + e_4;  /* F29 */
    const int32_t e_6 = (int32_t)q_nb_z * q_nb_z;  /* F28 */
    const int32_t e_7 = e_5 + e_6;  /* F29 */
    const int32_t e_8 = 268435456 /* 1/2 */ - e_7;  /* F29 */
    const int16_t e = round_5(e_8);  /* F24, |x| <= 0.000978 */

    /* q_next = q + e q */
    const int32_t q_next_w_part_1 = (int32_t)e * q_nb_w;  /* F38 */
    const int32_t q_next_w_part = round_short_8(q_next_w_part_1);  /* F30, |x| <= 0.000979 */
    const int32_t q_next_w_1 = (int32_t)q_nb_w * 65536;  /* F30 */
    const int32_t q_next_w = q_next_w_1 + q_next_w_part;  /* F30, |x| <= 1.01 */
    const int32_t q_next_x_part_1 = (int32_t)e * q_nb_x;  /* F38 */
    const int32_t q_next_x_part = round_short_8(q_next_x_part_1);  /* F30, |x| <= 0.000979 */
    const int32_t q_next_x_1 = (int32_t)q_nb_x * 65536;  /* F30 */
    const int32_t q_next_x = q_next_x_1 + q_next_x_part;  /* F30, |x| <= 1.01 */
    const int32_t q_next_y_part_1 = (int32_t)e * q_nb_y;  /* F38 */
    const int32_t q_next_y_part = round_short_8(q_next_y_part_1);  /* F30, |x| <= 0.000979 */
    const int32_t q_next_y_1 = (int32_t)q_nb_y * 65536;  /* F30 */
    const int32_t q_next_y = q_next_y_1 + q_next_y_part;  /* F30, |x| <= 1.01 */
    const int32_t q_next_z_part_1 = (int32_t)e * q_nb_z;  /* F38 */
    const int32_t q_next_z_part = round_short_8(q_next_z_part_1);  /* F30, |x| <= 0.000979 */
    const int32_t q_next_z_1 = (int32_t)q_nb_z * 65536;  /* F30 */
    const int32_t q_next_z = q_next_z_1 + q_next_z_part;  /* F30, |x| <= 1.01 */

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
}

void rotation_vector_3_coning_fixed16_compensated_update(
    rotation_vector_3_coning_fixed16_compensated_state *state, const int16_t dtheta[9])
{
    /* attitude and input */
    const int16_t dtheta1_x = dtheta[0];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta1_y = dtheta[1];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta1_z = dtheta[2];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta2_x = dtheta[3];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta2_y = dtheta[4];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta2_z = dtheta[5];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta3_x = dtheta[6];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta3_y = dtheta[7];  /* F18, |x| <= 0.0334 */
    const int16_t dtheta3_z = dtheta[8];  /* F18, |x| <= 0.0334 */

    /* d = theta_3 - theta_1 */
    const int32_t d_x_1 = (int32_t)dtheta3_x - dtheta1_x;  /* F18 */
    const int16_t d_x = (int16_t)d_x_1;  /* F18, |x| <= 0.0667 */
    const int32_t d_y_1 = (int32_t)dtheta3_y - dtheta1_y;  /* F18 */
    const int16_t d_y = (int16_t)d_y_1;  /* F18, |x| <= 0.0667 */
    const int32_t d_z_1 = (int32_t)dtheta3_z - dtheta1_z;  /* F18 */
    const int16_t d_z = (int16_t)d_z_1;  /* F18, |x| <= 0.0667 */

    /* S = p + theta_2 */
    const int32_t S_x_1 = (int32_t)dtheta1_x + dtheta3_x;  /* F18 */
    const int32_t S_x_2 = S_x_1 + dtheta2_x;  /* F18 */
    const int16_t S_x = (int16_t)S_x_2;  /* F18, |x| <= 0.101 */
    const int32_t S_y_1 = (int32_t)dtheta1_y + dtheta3_y;  /* F18 */
    const int32_t S_y_2 = S_y_1 + dtheta2_y;  /* F18 */
    const int16_t S_y = (int16_t)S_y_2;  /* F18, |x| <= 0.101 */
    const int32_t S_z_1 = (int32_t)dtheta1_z + dtheta3_z;  /* F18 */
    const int32_t S_z_2 = S_z_1 + dtheta2_z;  /* F18 */
    const int16_t S_z = (int16_t)S_z_2;  /* F18, |x| <= 0.101 */

    /* g = S + 2 theta_2   [cao (12)] */
    const int32_t g_x_1 = (int32_t)dtheta2_x * 2;  /* F18 */
    const int32_t g_x_2 = S_x + g_x_1;  /* F18 */
    const int16_t g_x = round_1(g_x_2);  /* F17, |x| <= 0.167 */
    const int32_t g_y_1 = (int32_t)dtheta2_y * 2;  /* F18 */
    const int32_t g_y_2 = S_y + g_y_1;  /* F18 */
    const int16_t g_y = round_1(g_y_2);  /* F17, |x| <= 0.167 */
    const int32_t g_z_1 = (int32_t)dtheta2_z * 2;  /* F18 */
    const int32_t g_z_2 = S_z + g_z_1;  /* F18 */
    const int16_t g_z = round_1(g_z_2);  /* F17, |x| <= 0.167 */

    /* k = 9/40 d   [cao (12)] */
    const int32_t k_x_1 = (int32_t)29491 /* 9/40 */ * d_x;  /* F35 */
    const int16_t k_x = round_14(k_x_1);  /* F21, |x| <= 0.0151 */
    const int32_t k_y_1 = (int32_t)29491 /* 9/40 */ * d_y;  /* F35 */
    const int16_t k_y = round_14(k_y_1);  /* F21, |x| <= 0.0151 */
    const int32_t k_z_1 = (int32_t)29491 /* 9/40 */ * d_z;  /* F35 */
    const int16_t k_z = round_14(k_z_1);  /* F21, |x| <= 0.0151 */

    /* coning = g x k   [cao (12)] */
    const int32_t coning_x_1 = (int32_t)g_y * k_z;  /* F38 */
    const int32_t coning_x_2 = (int32_t)g_z * k_y;  /* F38 */
    const int32_t coning_x_3 = coning_x_1 - coning_x_2;  /* F38 */
    const int16_t coning_x = round_15(coning_x_3);  /* F23, |x| <= 0.00251 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_x_whole_1 = (int32_t)S_x * 32;  /* F23 */
    const int32_t phi_x_whole_2 = phi_x_whole_1 + coning_x;  /* F23 */
    const int16_t phi_x_carried = state->residual[0];  /* F23 */
    const int32_t phi_x_whole = phi_x_whole_2 + phi_x_carried;  /* F23 */
    const int16_t phi_x = round_5(phi_x_whole);  /* F18, |x| <= 0.103 */
    const int16_t phi_x_left = left_of_5(phi_x_whole, phi_x);  /* F23 */
    state->residual[0] = phi_x_left;

    /* coning = g x k   [cao (12)] */
    const int32_t coning_y_1 = (int32_t)g_z * k_x;  /* F38 */
    const int32_t coning_y_2 = (int32_t)g_x * k_z;  /* F38 */
    const int32_t coning_y_3 = coning_y_1 - coning_y_2;  /* F38 */
    const int16_t coning_y = round_15(coning_y_3);  /* F23, |x| <= 0.00251 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_y_whole_1 = (int32_t)S_y * 32;  /* F23 */
    const int32_t phi_y_whole_2 = phi_y_whole_1 + coning_y;  /* F23 */
    const int16_t phi_y_carried = state->residual[1];  /* F23 */
    const int32_t phi_y_whole = phi_y_whole_2 + phi_y_carried;  /* F23 */
    const int16_t phi_y = round_5(phi_y_whole);  /* F18, |x| <= 0.103 */
    const int16_t phi_y_left = left_of_5(phi_y_whole, phi_y);  /* F23 */
    state->residual[1] = phi_y_left;

    /* coning = g x k   [cao (12)] */
    const int32_t coning_z_1 = (int32_t)g_x * k_y;  /* F38 */
    const int32_t coning_z_2 = (int32_t)g_y * k_x;  /* F38 */
    const int32_t coning_z_3 = coning_z_1 - coning_z_2;  /* F38 */
    const int16_t coning_z = round_15(coning_z_3);  /* F23, |x| <= 0.00251 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_z_whole_1 = (int32_t)S_z * 32;  /* F23 */
    const int32_t phi_z_whole_2 = phi_z_whole_1 + coning_z;  /* F23 */
    const int16_t phi_z_carried = state->residual[2];  /* F23 */
    const int32_t phi_z_whole = phi_z_whole_2 + phi_z_carried;  /* F23 */
    const int16_t phi_z = round_5(phi_z_whole);  /* F18, |x| <= 0.103 */
    const int16_t phi_z_left = left_of_5(phi_z_whole, phi_z);  /* F23 */
    state->residual[2] = phi_z_left;

    /* phi_square = |phi|^2 */
    const int32_t phi_square_1 = (int32_t)phi_x * phi_x;  /* F36 */
    const int32_t phi_square_2 = (int32_t)phi_y * phi_y;  /* F36 */
    const int32_t phi_square_3 = phi_square_1 + phi_square_2;  /* F36 */
    const int32_t phi_square_4 = (int32_t)phi_z * phi_z;  /* F36 */
    const int32_t phi_square_5 = phi_square_3 + phi_square_4;  /* F36 */
    const int16_t phi_square = round_15(phi_square_5);  /* F21, |x| <= 0.0105 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int32_t phi_square_rounded_1 = (int32_t)21845 /* 1/384 */ * phi_square;  /* F44 */
    const int16_t phi_square_rounded = round_14(phi_square_rounded_1);  /* F30, |x| <= 2.73e-05 */
    const int32_t u_1 = phi_square_rounded - 134217728 /* 1/8 */;  /* F30 */
    const int16_t u_2 = round_13(u_1);  /* F17, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int32_t y_1 = (int32_t)21843 /* 176/8449 */ * phi_square;  /* F41 */
    const int32_t y_2 = -y_1;  /* F41 */
    const int16_t y = round_14(y_2);  /* F27, |x| <= 0.000218 */

    /* bent = y phi   [cao (14)] */
    const int32_t bent_x_1 = (int32_t)y * phi_x;  /* F45 */
    const int16_t bent_x = round_15(bent_x_1);  /* F30, |x| <= 2.23e-05 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_x_whole_1 = (int32_t)phi_x * 2048;  /* F30 */
    const int32_t v_x_whole_2 = v_x_whole_1 + bent_x;  /* F30 */
    const int16_t v_x_carried = state->residual[3];  /* F30 */
    const int32_t v_x_whole = v_x_whole_2 + v_x_carried;  /* F30 */
    const int16_t v_x = round_11(v_x_whole);  /* F19, |x| <= 0.0512 */
    const int16_t v_x_left = left_of_11(v_x_whole, v_x);  /* F30 */
    state->residual[3] = v_x_left;

    /* bent = y phi   [cao (14)] */
    const int32_t bent_y_1 = (int32_t)y * phi_y;  /* F45 */
    const int16_t bent_y = round_15(bent_y_1);  /* F30, |x| <= 2.23e-05 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_y_whole_1 = (int32_t)phi_y * 2048;  /* F30 */
    const int32_t v_y_whole_2 = v_y_whole_1 + bent_y;  /* F30 */
    const int16_t v_y_carried = state->residual[4];  /* F30 */
    const int32_t v_y_whole = v_y_whole_2 + v_y_carried;  /* F30 */
    const int16_t v_y = round_11(v_y_whole);  /* F19, |x| <= 0.0512 */
    const int16_t v_y_left = left_of_11(v_y_whole, v_y);  /* F30 */
    state->residual[4] = v_y_left;

    /* bent = y phi   [cao (14)] */
    const int32_t bent_z_1 = (int32_t)y * phi_z;  /* F45 */
    const int16_t bent_z = round_15(bent_z_1);  /* F30, |x| <= 2.23e-05 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_z_whole_1 = (int32_t)phi_z * 2048;  /* F30 */
    const int32_t v_z_whole_2 = v_z_whole_1 + bent_z;  /* F30 */
    const int16_t v_z_carried = state->residual[5];  /* F30 */
    const int32_t v_z_whole = v_z_whole_2 + v_z_carried;  /* F30 */
    const int16_t v_z = round_11(v_z_whole);  /* F19, |x| <= 0.0512 */
    const int16_t v_z_left = left_of_11(v_z_whole, v_z);  /* F30 */
    state->residual[5] = v_z_left;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int32_t u_3 = (int32_t)phi_square * u_2;  /* F38 */
    const int16_t u = round_14(u_3);  /* F24, |x| <= 0.00131 */

    /* a = u + e */
    const int32_t a_1 = (int32_t)u * 32;  /* F29 */
    const int32_t a_2 = a_1 + 268435456 /* 1/2 */;  /* F29 */

    /* attitude and input */
    const int32_t q_w_whole = state->q[0];  /* F30, |x| <= 1.01 */
    const int16_t q_w = round_16(q_w_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_x_whole = state->q[1];  /* F30, |x| <= 1.01 */
    const int16_t q_x = round_16(q_x_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_y_whole = state->q[2];  /* F30, |x| <= 1.01 */
    const int16_t q_y = round_16(q_y_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_z_whole = state->q[3];  /* F30, |x| <= 1.01 */
    const int16_t q_z = round_16(q_z_whole);  /* F14, |x| <= 1.01 */

    /* a = u + e */
    const int32_t a_3 = (int32_t)q_w * q_w;  /* F28 */
    const int32_t a_4 = (int32_t)q_x * q_x;  /* F28 */
    const int32_t a_5 = a_3 + a_4;  /* F29 */
    const int32_t a_6 = (int32_t)q_y * q_y;  /* F28 */
    const int32_t a_7 = a_5 + a_6;  /* F29 */
    const int32_t a_8 = (int32_t)q_z * q_z;  /* F28 */
    const int32_t a_9 = a_7 + a_8;  /* F29 */
    const int32_t a_10 = a_2 - a_9;  /* F29 */
    const int16_t a = round_8(a_10);  /* F21, |x| <= 0.00529 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t dq_w_1 = (int32_t)q_w * a;  /* F35 */
    const int32_t dq_w_2 = (int32_t)q_x * v_x;  /* F33 */
    const int32_t dq_w_3 = dq_w_2 * 4;  /* F35 */
    const int32_t dq_w_4 = (int32_t)q_y * v_y;  /* F33 */
    const int32_t dq_w_5 = dq_w_4 * 4;  /* F35 */
    const int32_t dq_w_6 = dq_w_3 + dq_w_5;  /* F35 */
    const int32_t dq_w_7 = (int32_t)q_z * v_z;  /* F33 */
    const int32_t dq_w_8 = dq_w_7 * 4;  /* F35 */
    const int32_t dq_w_9 = dq_w_6 + dq_w_8;  /* F35 */
    const int32_t dq_w_10 = dq_w_1 - dq_w_9;  /* F35 */
    const int32_t dq_w = round_short_5(dq_w_10);  /* F30, |x| <= 0.0517 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w_whole + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t dq_x_1 = (int32_t)q_w * v_x;  /* F33 */
    const int32_t dq_x_2 = dq_x_1 * 4;  /* F35 */
    const int32_t dq_x_3 = (int32_t)q_x * a;  /* F35 */
    const int32_t dq_x_4 = dq_x_2 + dq_x_3;  /* F35 */
    const int32_t dq_x_5 = (int32_t)q_y * v_z;  /* F33 */
    const int32_t dq_x_6 = dq_x_5 * 4;  /* F35 */
    const int32_t dq_x_7 = dq_x_4 + dq_x_6;  /* F35 */
    const int32_t dq_x_8 = (int32_t)q_z * v_y;  /* F33 */
    const int32_t dq_x_9 = dq_x_8 * 4;  /* F35 */
    const int32_t dq_x_10 = dq_x_7 - dq_x_9;  /* F35 */
    const int32_t dq_x = round_short_5(dq_x_10);  /* F30, |x| <= 0.0517 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x_whole + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t dq_y_1 = (int32_t)q_w * v_y;  /* F33 */
    const int32_t dq_y_2 = dq_y_1 * 4;  /* F35 */
    const int32_t dq_y_3 = (int32_t)q_y * a;  /* F35 */
    const int32_t dq_y_4 = dq_y_2 + dq_y_3;  /* F35 */
    const int32_t dq_y_5 = (int32_t)q_z * v_x;  /* F33 */
    const int32_t dq_y_6 = dq_y_5 * 4;  /* F35 */
    const int32_t dq_y_7 = dq_y_4 + dq_y_6;  /* F35 */
    const int32_t dq_y_8 = (int32_t)q_x * v_z;  /* F33 */
    const int32_t dq_y_9 = dq_y_8 * 4;  /* F35 */
    const int32_t dq_y_10 = dq_y_7 - dq_y_9;  /* F35 */
    const int32_t dq_y = round_short_5(dq_y_10);  /* F30, |x| <= 0.0517 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y_whole + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t dq_z_1 = (int32_t)q_w * v_z;  /* F33 */
    const int32_t dq_z_2 = dq_z_1 * 4;  /* F35 */
    const int32_t dq_z_3 = (int32_t)q_z * a;  /* F35 */
    const int32_t dq_z_4 = dq_z_2 + dq_z_3;  /* F35 */
    const int32_t dq_z_5 = (int32_t)q_x * v_y;  /* F33 */
    const int32_t dq_z_6 = dq_z_5 * 4;  /* F35 */
    const int32_t dq_z_7 = dq_z_4 + dq_z_6;  /* F35 */
    const int32_t dq_z_8 = (int32_t)q_y * v_x;  /* F33 */
    const int32_t dq_z_9 = dq_z_8 * 4;  /* F35 */
    const int32_t dq_z_10 = dq_z_7 - dq_z_9;  /* F35 */
    const int32_t dq_z = round_short_5(dq_z_10);  /* F30, |x| <= 0.0517 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z_whole + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_fixed16_compensated_quaternion(
    const rotation_vector_3_coning_fixed16_compensated_state *state, int16_t q_nb[4])
{
    /* q, read once */
    const int32_t q_w_whole = state->q[0];  /* F30, |x| <= 1.01 */
    const int16_t q_w = round_16(q_w_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_x_whole = state->q[1];  /* F30, |x| <= 1.01 */
    const int16_t q_x = round_16(q_x_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_y_whole = state->q[2];  /* F30, |x| <= 1.01 */
    const int16_t q_y = round_16(q_y_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_z_whole = state->q[3];  /* F30, |x| <= 1.01 */
    const int16_t q_z = round_16(q_z_whole);  /* F14, |x| <= 1.01 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}

void rotation_vector_3_coning_fixed16_compensated_dcm(
    const rotation_vector_3_coning_fixed16_compensated_state *state, int16_t c_nb[9])
{
    /* q, read once */
    const int32_t q_w_whole = state->q[0];  /* F30, |x| <= 1.01 */
    const int16_t q_w = round_16(q_w_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_x_whole = state->q[1];  /* F30, |x| <= 1.01 */
    const int16_t q_x = round_16(q_x_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_y_whole = state->q[2];  /* F30, |x| <= 1.01 */
    const int16_t q_y = round_16(q_y_whole);  /* F14, |x| <= 1.01 */
    const int32_t q_z_whole = state->q[3];  /* F30, |x| <= 1.01 */
    const int16_t q_z = round_16(q_z_whole);  /* F14, |x| <= 1.01 */

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const int32_t wx_1 = (int32_t)q_w * q_x;  /* F28 */
    const int16_t wx = round_13(wx_1);  /* F14, |x| <= 1.01 */
    const int32_t wy_1 = (int32_t)q_w * q_y;  /* F28 */
    const int16_t wy = round_13(wy_1);  /* F14, |x| <= 1.01 */
    const int32_t wz_1 = (int32_t)q_w * q_z;  /* F28 */
    const int16_t wz = round_13(wz_1);  /* F14, |x| <= 1.01 */
    const int32_t xx_1 = (int32_t)q_x * q_x;  /* F28 */
    const int16_t xx = round_14(xx_1);  /* F13, |x| <= 2.02 */
    const int32_t xy_1 = (int32_t)q_x * q_y;  /* F28 */
    const int16_t xy = round_13(xy_1);  /* F14, |x| <= 1.01 */
    const int32_t xz_1 = (int32_t)q_x * q_z;  /* F28 */
    const int16_t xz = round_13(xz_1);  /* F14, |x| <= 1.01 */
    const int32_t yy_1 = (int32_t)q_y * q_y;  /* F28 */
    const int16_t yy = round_14(yy_1);  /* F13, |x| <= 2.02 */
    const int32_t yz_1 = (int32_t)q_y * q_z;  /* F28 */
    const int16_t yz = round_13(yz_1);  /* F14, |x| <= 1.01 */
    const int32_t zz_1 = (int32_t)q_z * q_z;  /* F28 */
    const int16_t zz = round_14(zz_1);  /* F13, |x| <= 2.02 */

    /* c_nb = C_nb(q)   [cao (15)] */
    const int32_t c_nb_11_1 = (int32_t)yy * 2;  /* F14 */
    const int32_t c_nb_11_2 = (int32_t)zz * 2;  /* F14 */
    const int32_t c_nb_11_3 = c_nb_11_1 + c_nb_11_2;  /* F14 */
    const int32_t c_nb_11_4 = 16384 /* 1 */ - c_nb_11_3;  /* F14 */
    const int16_t c_nb_11 = (int16_t)c_nb_11_4;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_12_1 = (int32_t)xy - wz;  /* F14 */
    const int16_t c_nb_12 = (int16_t)c_nb_12_1;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_13_1 = (int32_t)xz + wy;  /* F14 */
    const int16_t c_nb_13 = (int16_t)c_nb_13_1;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_21_1 = (int32_t)xy + wz;  /* F14 */
    const int16_t c_nb_21 = (int16_t)c_nb_21_1;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_22_1 = (int32_t)xx * 2;  /* F14 */
    const int32_t c_nb_22_2 = (int32_t)zz * 2;  /* F14 */
    const int32_t c_nb_22_3 = c_nb_22_1 + c_nb_22_2;  /* F14 */
    const int32_t c_nb_22_4 = 16384 /* 1 */ - c_nb_22_3;  /* F14 */
    const int16_t c_nb_22 = (int16_t)c_nb_22_4;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_23_1 = (int32_t)yz - wx;  /* F14 */
    const int16_t c_nb_23 = (int16_t)c_nb_23_1;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_31_1 = (int32_t)xz - wy;  /* F14 */
    const int16_t c_nb_31 = (int16_t)c_nb_31_1;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_32_1 = (int32_t)yz + wx;  /* F14 */
    const int16_t c_nb_32 = (int16_t)c_nb_32_1;  /* F14, |x| <= 1.02 */
    const int32_t c_nb_33_1 = (int32_t)xx * 2;  /* F14 */
    const int32_t c_nb_33_2 = (int32_t)yy * 2;  /* F14 */
    const int32_t c_nb_33_3 = c_nb_33_1 + c_nb_33_2;  /* F14 */
    const int32_t c_nb_33_4 = 16384 /* 1 */ - c_nb_33_3;  /* F14 */
    const int16_t c_nb_33 = (int16_t)c_nb_33_4;  /* F14, |x| <= 1.02 */

    c_nb[0] = c_nb_11;
    c_nb[1] = c_nb_12;
    c_nb[2] = c_nb_13;
    c_nb[3] = c_nb_21;
    c_nb[4] = c_nb_22;
    c_nb[5] = c_nb_23;
    c_nb[6] = c_nb_31;
    c_nb[7] = c_nb_32;
    c_nb[8] = c_nb_33;
}
