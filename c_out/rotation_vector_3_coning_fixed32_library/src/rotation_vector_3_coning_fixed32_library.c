/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_fixed32_library
 *
 * qcone 0.1.0, design rotation_vector_3_coning_fixed32_library, SHA-256 of the design
 * 1f347bca72f09786429467f5d7a3ed8fbd9bd7364b7bb550c0bc1f746856b53f
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
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.5e-15 (scalar), 7.8e-14 (vector), proved over the rationals
 * rounding:    one update is within 1.2e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * products:    of 64 bits, by the compiler's library: cortex-m0 has none of 64 bits
 * high words:  8 of 20 rounded sums of products drop a whole word, 1 before formats were searched
 *              for that; of one update's errors in the first order it made 2.3e-09 of 2.2e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       44       0   37        13       0       0     0     0     0       0      0
 * update shared           40       4   37        13       0       0     0     0     0       0      0
 * update emitted          40       0   37        10       3       0     0     0     0       0     24
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_fixed32_library.h"

#if ROTATION_VECTOR_3_CONING_FIXED32_LIBRARY_VERSION != 1
#error "rotation_vector_3_coning_fixed32_library.h is of another version than this file: generate both again"
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

/* x / 2^42, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_42(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(2199023255552), 42);
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

void rotation_vector_3_coning_fixed32_library_init(rotation_vector_3_coning_fixed32_library_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
}

void rotation_vector_3_coning_fixed32_library_set_quaternion(
    rotation_vector_3_coning_fixed32_library_state *state, const int32_t q_nb[4])
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

void rotation_vector_3_coning_fixed32_library_update(
    rotation_vector_3_coning_fixed32_library_state *state, const int32_t dtheta[9])
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
    const int32_t coning_x = round_34(coning_x_3);  /* F34, |x| <= 0.00251 */

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_x = S_x + coning_x;  /* F34, |x| <= 0.103 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_y_1 = (int64_t)g_z * k_x;  /* F68 */
    const int64_t coning_y_2 = (int64_t)g_x * k_z;  /* F68 */
    const int64_t coning_y_3 = coning_y_1 - coning_y_2;  /* F68 */
    const int32_t coning_y = round_34(coning_y_3);  /* F34, |x| <= 0.00251 */

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_y = S_y + coning_y;  /* F34, |x| <= 0.103 */

    /* coning = g x k   [cao (12)] */
    const int64_t coning_z_1 = (int64_t)g_x * k_y;  /* F68 */
    const int64_t coning_z_2 = (int64_t)g_y * k_x;  /* F68 */
    const int64_t coning_z_3 = coning_z_1 - coning_z_2;  /* F68 */
    const int32_t coning_z = round_34(coning_z_3);  /* F34, |x| <= 0.00251 */

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_z = S_z + coning_z;  /* F34, |x| <= 0.103 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)phi_x * phi_x;  /* F68 */
    const int64_t phi_square_2 = (int64_t)phi_y * phi_y;  /* F68 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F68 */
    const int64_t phi_square_4 = (int64_t)phi_z * phi_z;  /* F68 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F68 */
    const int32_t phi_square = round_32(phi_square_5);  /* F36, |x| <= 0.0105 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)372811 /* 1/46082 */ * phi_square;  /* F70 */
    const int64_t u_2 = INT64_C(3074457318914149564) /* 299819/115130497 */ - u_1;  /* F70 */
    const int32_t u_3 = round_42(u_2);  /* F28, |x| <= 0.00261 */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F64 */
    const int64_t u_5 = u_4 - INT64_C(2305843009213693952) /* 1/8 */;  /* F64 */
    const int32_t u_6 = round_32(u_5);  /* F32, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)69899 /* 3/11521 */ * phi_square;  /* F64 */
    const int64_t y_2 = y_1 - INT64_C(384307165617423277) /* 3097422/148676257 */;  /* F64 */
    const int32_t y_3 = round_32(y_2);  /* F32, |x| <= 0.0209 */
    const int64_t y_4 = (int64_t)phi_square * y_3;  /* F68 */
    const int32_t y = round_32(y_4);  /* F36, |x| <= 0.000218 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * phi_x;  /* F70 */
    const int32_t bent_x = round_35(bent_x_1);  /* F35, |x| <= 2.23e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x = phi_x + bent_x;  /* F35, |x| <= 0.0512 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * phi_y;  /* F70 */
    const int32_t bent_y = round_35(bent_y_1);  /* F35, |x| <= 2.23e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y = phi_y + bent_y;  /* F35, |x| <= 0.0512 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * phi_z;  /* F70 */
    const int32_t bent_z = round_35(bent_z_1);  /* F35, |x| <= 2.23e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z = phi_z + bent_z;  /* F35, |x| <= 0.0512 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_7 = (int64_t)phi_square * u_6;  /* F68 */
    const int32_t u = round_32(u_7);  /* F36, |x| <= 0.00131 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(33554432);  /* F61 */
    const int64_t a_2 = a_1 + INT64_C(1152921504606846976) /* 1/2 */;  /* F61 */

    /* attitude and input */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.01 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.01 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.01 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.01 */

    /* a = u + e */
    const int64_t a_3 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t a_4 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t a_5 = a_3 + a_4;  /* F61 */
    const int64_t a_6 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t a_7 = a_5 + a_6;  /* F61 */
    const int64_t a_8 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t a_9 = a_7 + a_8;  /* F61 */
    const int64_t a_10 = a_2 - a_9;  /* F61 */
    const int32_t a = round_26(a_10);  /* F35, |x| <= 0.00522 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t q_x_negated = -q_x;  /* F30 */
    const int32_t q_y_negated = -q_y;  /* F30 */
    const int32_t q_z_negated = -q_z;  /* F30 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F65 */
    const int64_t dq_w_2 = (int64_t)q_x_negated * v_x;  /* F65 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F65 */
    const int64_t dq_w_4 = (int64_t)q_y_negated * v_y;  /* F65 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F65 */
    const int64_t dq_w_6 = (int64_t)q_z_negated * v_z;  /* F65 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F65 */
    const int32_t dq_w = round_35(dq_w_7);  /* F30, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F65 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F65 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F65 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F65 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F65 */
    const int64_t dq_x_6 = (int64_t)q_z_negated * v_y;  /* F65 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F65 */
    const int32_t dq_x = round_35(dq_x_7);  /* F30, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F65 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F65 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F65 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F65 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F65 */
    const int64_t dq_y_6 = (int64_t)q_x_negated * v_z;  /* F65 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F65 */
    const int32_t dq_y = round_35(dq_y_7);  /* F30, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F65 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F65 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F65 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F65 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F65 */
    const int64_t dq_z_6 = (int64_t)q_y_negated * v_x;  /* F65 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F65 */
    const int32_t dq_z = round_35(dq_z_7);  /* F30, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_fixed32_library_quaternion(
    const rotation_vector_3_coning_fixed32_library_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.01 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.01 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.01 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.01 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}
