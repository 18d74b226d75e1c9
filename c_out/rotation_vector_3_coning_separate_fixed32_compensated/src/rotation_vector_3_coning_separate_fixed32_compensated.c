/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_separate_fixed32_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_separate_fixed32_compensated, SHA-256 of the design
 * 0d35fde05338b453ce332aad84a7c14bc45f2bc2c96f983e4a86047bbbcf0bf0
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised by a call
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; | |q| - 1 | <= 0.0156 for 25841559 updates after it was set or
 *              renormalised, proved; within it no sum overflows, as is proved; beyond it nothing
 *              is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.5e-15 (scalar), 5.5e-15 (vector), proved over the rationals
 * rounding:    one update is within 5.7e-10 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; it adds at most 5.7e-10 to the
 *              length; proved
 * high words:  9 of 15 rounded sums of products drop a whole word, 2 before formats were searched
 *              for that; of one update's errors in the first order it made 3.4e-10 of 3.1e-10
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       39       0   33        12       0       0     0     0     0       0      0
 * update shared           36       3   33        12       0       0     0     0     0       0      0
 * update emitted          36       0   39        15       3       0     0     0     0       0     32
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_separate_fixed32_compensated.h"

#if ROTATION_VECTOR_3_CONING_SEPARATE_FIXED32_COMPENSATED_VERSION != 1
#error "rotation_vector_3_coning_separate_fixed32_compensated.h is of another version than this file: generate both again"
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

/* whole - 2^5 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_5(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 5);
    return wrapped_32(left);
}

/* whole - 2^8 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_8(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 8);
    return wrapped_32(left);
}

/* x / 2^21, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_21(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1048576)) >> 21);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^25, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_25(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(16777216)) >> 25);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^29, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_29(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(268435456)) >> 29);
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

/* x / 2^35, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_35(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(17179869184), 35);
}

/* x / 2^43, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_43(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(4398046511104), 43);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int32_t round_short_1(int32_t x)
{
    return shift_right_32(x + 1, 1);
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

/* x / 2^3, rounded to nearest, halves up. */
static inline int64_t round_wide_3(int64_t x)
{
    return shift_right_64(x + INT64_C(4), 3);
}

/* x / 2^4, rounded to nearest, halves up. */
static inline int64_t round_wide_4(int64_t x)
{
    return shift_right_64(x + INT64_C(8), 4);
}

/* x / 2^8, rounded to nearest, halves up. */
static inline int64_t round_wide_8(int64_t x)
{
    return shift_right_64(x + INT64_C(128), 8);
}

void rotation_vector_3_coning_separate_fixed32_compensated_init(
    rotation_vector_3_coning_separate_fixed32_compensated_state *state)
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
}

void rotation_vector_3_coning_separate_fixed32_compensated_set_quaternion(
    rotation_vector_3_coning_separate_fixed32_compensated_state *state, const int32_t q_nb[4])
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
}

void rotation_vector_3_coning_separate_fixed32_compensated_update(
    rotation_vector_3_coning_separate_fixed32_compensated_state *state, const int32_t dtheta[9])
{
    /* attitude and input */
    const int32_t dtheta1_x = dtheta[0];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta1_y = dtheta[1];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta1_z = dtheta[2];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta2_x = dtheta[3];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta2_y = dtheta[4];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta2_z = dtheta[5];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta3_x = dtheta[6];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta3_y = dtheta[7];  /* F34, |x| <= 0.0334 */
    const int32_t dtheta3_z = dtheta[8];  /* F34, |x| <= 0.0334 */

    /* d = theta_3 - theta_1 */
    const int32_t d_x = dtheta3_x - dtheta1_x;  /* F34, |x| <= 0.0667 */
    const int32_t d_y = dtheta3_y - dtheta1_y;  /* F34, |x| <= 0.0667 */
    const int32_t d_z = dtheta3_z - dtheta1_z;  /* F34, |x| <= 0.0667 */

    /* S = p + theta_2 */
    const int32_t S_x_1 = dtheta1_x + dtheta3_x;  /* F34 */
    const int32_t S_x = S_x_1 + dtheta2_x;  /* F34, |x| <= 0.101 */
    const int32_t S_y_1 = dtheta1_y + dtheta3_y;  /* F34 */
    const int32_t S_y = S_y_1 + dtheta2_y;  /* F34, |x| <= 0.101 */
    const int32_t S_z_1 = dtheta1_z + dtheta3_z;  /* F34 */
    const int32_t S_z = S_z_1 + dtheta2_z;  /* F34, |x| <= 0.101 */

    /* g = S + 2 theta_2   [cao (12)] */
    const int32_t g_x_fine = round_short_1(S_x);  /* F33 */
    const int32_t g_x = g_x_fine + dtheta2_x;  /* F33, |x| <= 0.167 */
    const int32_t g_y_fine = round_short_1(S_y);  /* F33 */
    const int32_t g_y = g_y_fine + dtheta2_y;  /* F33, |x| <= 0.167 */
    const int32_t g_z_fine = round_short_1(S_z);  /* F33 */
    const int32_t g_z = g_z_fine + dtheta2_z;  /* F33, |x| <= 0.167 */

    /* k = 9/40 d   [cao (12)] */
    const int64_t k_x_1 = (int64_t)1932735283 /* 9/40 */ * d_x;  /* F67 */
    const int32_t k_x = round_32(k_x_1);  /* F35, |x| <= 0.0151 */
    const int64_t k_y_1 = (int64_t)1932735283 /* 9/40 */ * d_y;  /* F67 */
    const int32_t k_y = round_32(k_y_1);  /* F35, |x| <= 0.0151 */
    const int64_t k_z_1 = (int64_t)1932735283 /* 9/40 */ * d_z;  /* F67 */
    const int32_t k_z = round_32(k_z_1);  /* F35, |x| <= 0.0151 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_x_1 = (int64_t)g_y * k_z;  /* F68 */
    const int64_t coning_x_2 = (int64_t)g_z * k_y;  /* F68 */
    const int64_t coning_x_3 = coning_x_1 - coning_x_2;  /* F68 */
    const int32_t coning_x = round_29(coning_x_3);  /* F39, |x| <= 0.00251 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_x_fine_carried = state->residual[0];  /* F39 */
    const int32_t phi_x_fine_whole = coning_x + phi_x_fine_carried;  /* F39 */
    const int32_t phi_x_fine = round_short_5(phi_x_fine_whole);  /* F34 */
    const int32_t phi_x_fine_left = left_of_short_5(phi_x_fine_whole, phi_x_fine);  /* F39 */
    state->residual[0] = phi_x_fine_left;
    const int32_t phi_x = phi_x_fine + S_x;  /* F34, |x| <= 0.103 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_y_1 = (int64_t)g_z * k_x;  /* F68 */
    const int64_t coning_y_2 = (int64_t)g_x * k_z;  /* F68 */
    const int64_t coning_y_3 = coning_y_1 - coning_y_2;  /* F68 */
    const int32_t coning_y = round_29(coning_y_3);  /* F39, |x| <= 0.00251 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_y_fine_carried = state->residual[1];  /* F39 */
    const int32_t phi_y_fine_whole = coning_y + phi_y_fine_carried;  /* F39 */
    const int32_t phi_y_fine = round_short_5(phi_y_fine_whole);  /* F34 */
    const int32_t phi_y_fine_left = left_of_short_5(phi_y_fine_whole, phi_y_fine);  /* F39 */
    state->residual[1] = phi_y_fine_left;
    const int32_t phi_y = phi_y_fine + S_y;  /* F34, |x| <= 0.103 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_z_1 = (int64_t)g_x * k_y;  /* F68 */
    const int64_t coning_z_2 = (int64_t)g_y * k_x;  /* F68 */
    const int64_t coning_z_3 = coning_z_1 - coning_z_2;  /* F68 */
    const int32_t coning_z = round_29(coning_z_3);  /* F39, |x| <= 0.00251 */

    /* phi, the rounding of the last update added, that of this one kept */
    const int32_t phi_z_fine_carried = state->residual[2];  /* F39 */
    const int32_t phi_z_fine_whole = coning_z + phi_z_fine_carried;  /* F39 */
    const int32_t phi_z_fine = round_short_5(phi_z_fine_whole);  /* F34 */
    const int32_t phi_z_fine_left = left_of_short_5(phi_z_fine_whole, phi_z_fine);  /* F39 */
    state->residual[2] = phi_z_fine_left;
    const int32_t phi_z = phi_z_fine + S_z;  /* F34, |x| <= 0.103 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)phi_x * phi_x;  /* F68 */
    const int64_t phi_square_2 = (int64_t)phi_y * phi_y;  /* F68 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F68 */
    const int64_t phi_square_4 = (int64_t)phi_z * phi_z;  /* F68 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F68 */
    const int32_t phi_square = round_31(phi_square_5);  /* F37, |x| <= 0.0105 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)372811 /* 1/46082 */ * phi_square;  /* F71 */
    const int64_t u_2 = INT64_C(6148914637828299127) /* 299819/115130497 */ - u_1;  /* F71 */
    const int32_t u_3 = round_43(u_2);  /* F28, |x| <= 0.00261 */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F65 */
    const int64_t u_5 = u_4 - INT64_C(4611686018427387904) /* 1/8 */;  /* F65 */
    const int32_t u_6 = round_32(u_5);  /* F33, |x| <= 0.126 */
    const int64_t u_7 = (int64_t)phi_square * u_6;  /* F70 */
    const int32_t u = round_35(u_7);  /* F35, |x| <= 0.00131 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)559189 /* 31/119051 */ * phi_square;  /* F68 */
    const int64_t y_2 = y_1 - INT64_C(6148914665395606125) /* 4957348/237952705 */;  /* F68 */
    const int32_t y_3 = round_32(y_2);  /* F36, |x| <= 0.0209 */
    const int64_t y_4 = (int64_t)phi_square * y_3;  /* F73 */
    const int32_t y = round_32(y_4);  /* F41, |x| <= 0.000218 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * phi_x;  /* F75 */
    const int32_t bent_x = round_32(bent_x_1);  /* F43, |x| <= 2.23e-05 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_x_fine_carried = state->residual[3];  /* F43 */
    const int32_t v_x_fine_whole = bent_x + v_x_fine_carried;  /* F43 */
    const int32_t v_x_fine = round_short_8(v_x_fine_whole);  /* F35 */
    const int32_t v_x_fine_left = left_of_short_8(v_x_fine_whole, v_x_fine);  /* F43 */
    state->residual[3] = v_x_fine_left;
    const int32_t v_x = v_x_fine + phi_x;  /* F35, |x| <= 0.0512 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * phi_y;  /* F75 */
    const int32_t bent_y = round_32(bent_y_1);  /* F43, |x| <= 2.23e-05 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_y_fine_carried = state->residual[4];  /* F43 */
    const int32_t v_y_fine_whole = bent_y + v_y_fine_carried;  /* F43 */
    const int32_t v_y_fine = round_short_8(v_y_fine_whole);  /* F35 */
    const int32_t v_y_fine_left = left_of_short_8(v_y_fine_whole, v_y_fine);  /* F43 */
    state->residual[4] = v_y_fine_left;
    const int32_t v_y = v_y_fine + phi_y;  /* F35, |x| <= 0.0512 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * phi_z;  /* F75 */
    const int32_t bent_z = round_32(bent_z_1);  /* F43, |x| <= 2.23e-05 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_z_fine_carried = state->residual[5];  /* F43 */
    const int32_t v_z_fine_whole = bent_z + v_z_fine_carried;  /* F43 */
    const int32_t v_z_fine = round_short_8(v_z_fine_whole);  /* F35 */
    const int32_t v_z_fine_left = left_of_short_8(v_z_fine_whole, v_z_fine);  /* F43 */
    state->residual[5] = v_z_fine_left;
    const int32_t v_z = v_z_fine + phi_z;  /* F35, |x| <= 0.0512 */

    /* dq = q (x) [u, v]   [cao (14)] */
    const int32_t v_x_negated = -v_x;  /* F35 */
    const int32_t v_y_negated = -v_y;  /* F35 */
    const int32_t v_z_negated = -v_z;  /* F35 */

    /* attitude and input */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.02 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.02 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.02 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.02 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.02 */

    /* dq = q (x) [u, v]   [cao (14)] */
    const int64_t dq_w_1 = (int64_t)q_w * u;  /* F65 */
    const int64_t dq_w_2 = (int64_t)q_x * v_x_negated;  /* F65 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F65 */
    const int64_t dq_w_4 = (int64_t)q_y * v_y_negated;  /* F65 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F65 */
    const int64_t dq_w_6 = (int64_t)q_z * v_z_negated;  /* F65 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F65 */
    const int64_t dq_w = round_wide_3(dq_w_7);  /* F62, |x| <= 0.052 */

    /* q_next = q + dq */
    const int64_t q_next_w = q_w_whole + dq_w;  /* F62, |x| <= 1.02 */

    /* dq = q (x) [u, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F65 */
    const int64_t dq_x_2 = (int64_t)q_x * u;  /* F65 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F65 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F65 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F65 */
    const int64_t dq_x_6 = (int64_t)q_z * v_y_negated;  /* F65 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F65 */
    const int64_t dq_x = round_wide_3(dq_x_7);  /* F62, |x| <= 0.052 */

    /* q_next = q + dq */
    const int64_t q_next_x = q_x_whole + dq_x;  /* F62, |x| <= 1.02 */

    /* dq = q (x) [u, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F65 */
    const int64_t dq_y_2 = (int64_t)q_y * u;  /* F65 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F65 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F65 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F65 */
    const int64_t dq_y_6 = (int64_t)q_x * v_z_negated;  /* F65 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F65 */
    const int64_t dq_y = round_wide_3(dq_y_7);  /* F62, |x| <= 0.052 */

    /* q_next = q + dq */
    const int64_t q_next_y = q_y_whole + dq_y;  /* F62, |x| <= 1.02 */

    /* dq = q (x) [u, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F65 */
    const int64_t dq_z_2 = (int64_t)q_z * u;  /* F65 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F65 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F65 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F65 */
    const int64_t dq_z_6 = (int64_t)q_y * v_x_negated;  /* F65 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F65 */
    const int64_t dq_z = round_wide_3(dq_z_7);  /* F62, |x| <= 0.052 */

    /* q_next = q + dq */
    const int64_t q_next_z = q_z_whole + dq_z;  /* F62, |x| <= 1.02 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_separate_fixed32_compensated_renormalise(
    rotation_vector_3_coning_separate_fixed32_compensated_state *state)
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.02 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.02 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.02 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.02 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.02 */

    /* e = (1 - |q|^2)/2 */
    const int64_t e_1 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t e_2 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t e_3 = e_1 + e_2;  /* F61 */
    const int64_t e_4 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t e_5 = e_3 + e_4;  /* F61 */
    const int64_t e_6 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t e_7 = e_5 + e_6;  /* F61 */
    const int64_t e_8 = INT64_C(1152921504606846976) /* 1/2 */ - e_7;  /* F61 */
    const int32_t e = round_25(e_8);  /* F36, |x| <= 0.0158 */

    /* q_next = q + e q */
    const int64_t q_next_w_part_1 = (int64_t)e * q_w;  /* F66 */
    const int64_t q_next_w_part = round_wide_4(q_next_w_part_1);  /* F62, |x| <= 0.016 */
    const int64_t q_next_w_1 = q_w * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_w = q_next_w_1 + q_next_w_part;  /* F62, |x| <= 1.01 */
    const int64_t q_next_x_part_1 = (int64_t)e * q_x;  /* F66 */
    const int64_t q_next_x_part = round_wide_4(q_next_x_part_1);  /* F62, |x| <= 0.016 */
    const int64_t q_next_x_1 = q_x * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_x = q_next_x_1 + q_next_x_part;  /* F62, |x| <= 1.01 */
    const int64_t q_next_y_part_1 = (int64_t)e * q_y;  /* F66 */
    const int64_t q_next_y_part = round_wide_4(q_next_y_part_1);  /* F62, |x| <= 0.016 */
    const int64_t q_next_y_1 = q_y * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_y = q_next_y_1 + q_next_y_part;  /* F62, |x| <= 1.01 */
    const int64_t q_next_z_part_1 = (int64_t)e * q_z;  /* F66 */
    const int64_t q_next_z_part = round_wide_4(q_next_z_part_1);  /* F62, |x| <= 0.016 */
    const int64_t q_next_z_1 = q_z * INT64_C(4294967296);  /* F62 */
    const int64_t q_next_z = q_next_z_1 + q_next_z_part;  /* F62, |x| <= 1.01 */

    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_separate_fixed32_compensated_quaternion(
    const rotation_vector_3_coning_separate_fixed32_compensated_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.02 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.02 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.02 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.02 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.02 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}
