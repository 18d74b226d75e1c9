/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_previous_2_fixed32
 *
 * qcone 0.1.0, design rotation_vector_1_previous_2_fixed32, SHA-256 of the design
 * 2cd2d571788f458964614fcf613a25f92303c4a2de67d6baa85b64913950fc86
 *
 * algorithm:   rotation-vector-1-previous-2, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      savage1998 (46)
 * equation:    phi = theta + (7/60 theta[-1] - 1/60 theta[-2]) x theta
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 400 updates/s; |dtheta| <= 0.025002 rad; |phi|
 *              <= 0.02509 rad; | |q| - 1 | <= 0.000244 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              2.3e-16 (scalar), 3.5e-13 (vector), proved over the rationals
 * rounding:    one update is within 9.9e-10 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  10 of 18 rounded sums of products drop a whole word, 0 before formats were searched
 *              for that; of one update's errors in the first order it made 2e-09 of 2e-09
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * start_up as-written       33       0   20         7       0       0     0     0     0       0      0
 * start_up shared           29       4   20         7       0       0     0     0     0       0      0
 * start_up emitted          29       0   25         2       4       0     0     0     0       0     19
 * steady as-written         45       0   26        10       0       0     0     0     0       0      0
 * steady shared             41       4   26        10       0       0     0     0     0       0      0
 * steady emitted            41       0   28         8       4       0     0     0     0       0     25
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_1_previous_2_fixed32.h"

#if ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_VERSION != 1
#error "rotation_vector_1_previous_2_fixed32.h is of another version than this file: generate both again"
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

/* x / 2^24, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_24(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(8388608)) >> 24);
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

/* x / 2^37, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_37(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(68719476736), 37);
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

/* x / 2^11, rounded to nearest, halves up. */
static inline int32_t round_short_11(int32_t x)
{
    return shift_right_32(x + 1024, 11);
}

void rotation_vector_1_previous_2_fixed32_init(rotation_vector_1_previous_2_fixed32_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
    state->previous[0] = 0;
    state->previous[1] = 0;
    state->previous[2] = 0;
    state->previous[3] = 0;
    state->previous[4] = 0;
    state->previous[5] = 0;
    state->count = 0;
}

void rotation_vector_1_previous_2_fixed32_set_quaternion(
    rotation_vector_1_previous_2_fixed32_state *state, const int32_t q_nb[4])
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
    state->previous[0] = 0;
    state->previous[1] = 0;
    state->previous[2] = 0;
    state->previous[3] = 0;
    state->previous[4] = 0;
    state->previous[5] = 0;
    state->count = 0;
}

static void rotation_vector_1_previous_2_fixed32_start_up(
    rotation_vector_1_previous_2_fixed32_state *state, const int32_t dtheta[3])
{
    /* attitude and input */
    const int32_t dtheta_x = dtheta[0];  /* F35, |x| <= 0.0251 */
    const int32_t dtheta_y = dtheta[1];  /* F35, |x| <= 0.0251 */
    const int32_t dtheta_z = dtheta[2];  /* F35, |x| <= 0.0251 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)dtheta_x * dtheta_x;  /* F70 */
    const int64_t phi_square_2 = (int64_t)dtheta_y * dtheta_y;  /* F70 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F70 */
    const int64_t phi_square_4 = (int64_t)dtheta_z * dtheta_z;  /* F70 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F70 */
    const int32_t phi_square = round_32(phi_square_5);  /* F38, |x| <= 0.000626 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)21845 /* 352/135169 */ * phi_square;  /* F61 */
    const int64_t u_2 = u_1 - INT64_C(288230376142762695) /* 4025991479/32207931833 */;  /* F61 */
    const int32_t u_3 = round_32(u_2);  /* F29, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)1431645853 /* 3009/144433 */ * phi_square;  /* F74 */
    const int64_t y_2 = -y_1;  /* F74 */
    const int32_t y = round_32(y_2);  /* F42, |x| <= 1.31e-05 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * dtheta_x;  /* F77 */
    const int32_t bent_x = round_32(bent_x_1);  /* F45, |x| <= 3.26e-07 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x_fine = round_short_8(bent_x);  /* F37 */
    const int32_t v_x_1 = dtheta_x * 2;  /* F37 */
    const int32_t v_x = v_x_fine + v_x_1;  /* F37, |x| <= 0.0126 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * dtheta_y;  /* F77 */
    const int32_t bent_y = round_32(bent_y_1);  /* F45, |x| <= 3.26e-07 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y_fine = round_short_8(bent_y);  /* F37 */
    const int32_t v_y_1 = dtheta_y * 2;  /* F37 */
    const int32_t v_y = v_y_fine + v_y_1;  /* F37, |x| <= 0.0126 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * dtheta_z;  /* F77 */
    const int32_t bent_z = round_32(bent_z_1);  /* F45, |x| <= 3.26e-07 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z_fine = round_short_8(bent_z);  /* F37 */
    const int32_t v_z_1 = dtheta_z * 2;  /* F37 */
    const int32_t v_z = v_z_fine + v_z_1;  /* F37, |x| <= 0.0126 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F67 */
    const int32_t u = round_32(u_4);  /* F35, |x| <= 7.82e-05 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(67108864);  /* F61 */
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
    const int32_t a = round_24(a_10);  /* F37, |x| <= 0.000323 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t q_x_negated = -q_x;  /* F30 */
    const int32_t q_y_negated = -q_y;  /* F30 */
    const int32_t q_z_negated = -q_z;  /* F30 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F67 */
    const int64_t dq_w_2 = (int64_t)q_x_negated * v_x;  /* F67 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F67 */
    const int64_t dq_w_4 = (int64_t)q_y_negated * v_y;  /* F67 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F67 */
    const int64_t dq_w_6 = (int64_t)q_z_negated * v_z;  /* F67 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F67 */
    const int32_t dq_w = round_37(dq_w_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F67 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F67 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F67 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F67 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F67 */
    const int64_t dq_x_6 = (int64_t)q_z_negated * v_y;  /* F67 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F67 */
    const int32_t dq_x = round_37(dq_x_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F67 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F67 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F67 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F67 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F67 */
    const int64_t dq_y_6 = (int64_t)q_x_negated * v_z;  /* F67 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F67 */
    const int32_t dq_y = round_37(dq_y_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F67 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F67 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F67 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F67 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F67 */
    const int64_t dq_z_6 = (int64_t)q_y_negated * v_x;  /* F67 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F67 */
    const int32_t dq_z = round_37(dq_z_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;

    /* earlier angle increments, newest first, rad, sensor axes */
    const int32_t previous1_x = state->previous[0];  /* F35, |x| <= 0.0251 */
    const int32_t previous1_y = state->previous[1];  /* F35, |x| <= 0.0251 */
    const int32_t previous1_z = state->previous[2];  /* F35, |x| <= 0.0251 */

    /* store */
    state->previous[0] = dtheta_x;
    state->previous[1] = dtheta_y;
    state->previous[2] = dtheta_z;
    state->previous[3] = previous1_x;
    state->previous[4] = previous1_y;
    state->previous[5] = previous1_z;
    state->count = state->count + 1;
}

static void rotation_vector_1_previous_2_fixed32_steady(
    rotation_vector_1_previous_2_fixed32_state *state, const int32_t dtheta[3])
{
    /* attitude and input */
    const int32_t dtheta_x = dtheta[0];  /* F35, |x| <= 0.0251 */
    const int32_t dtheta_y = dtheta[1];  /* F35, |x| <= 0.0251 */
    const int32_t dtheta_z = dtheta[2];  /* F35, |x| <= 0.0251 */

    /* earlier angle increments, newest first, rad, sensor axes */
    const int32_t previous1_x = state->previous[0];  /* F35, |x| <= 0.0251 */
    const int32_t previous1_y = state->previous[1];  /* F35, |x| <= 0.0251 */
    const int32_t previous1_z = state->previous[2];  /* F35, |x| <= 0.0251 */
    const int32_t previous2_x = state->previous[3];  /* F35, |x| <= 0.0251 */
    const int32_t previous2_y = state->previous[4];  /* F35, |x| <= 0.0251 */
    const int32_t previous2_z = state->previous[5];  /* F35, |x| <= 0.0251 */

    /* h = 7/60 theta[-1] - 1/60 theta[-2]   [savage1998 (46)] */
    const int64_t h_x_1 = (int64_t)2004318071 /* 7/60 */ * previous1_x;  /* F69 */
    const int64_t h_x_2 = (int64_t)286331153 /* 1/60 */ * previous2_x;  /* F69 */
    const int64_t h_x_3 = h_x_1 - h_x_2;  /* F69 */
    const int32_t h_x = round_32(h_x_3);  /* F37, |x| <= 0.00334 */
    const int64_t h_y_1 = (int64_t)2004318071 /* 7/60 */ * previous1_y;  /* F69 */
    const int64_t h_y_2 = (int64_t)286331153 /* 1/60 */ * previous2_y;  /* F69 */
    const int64_t h_y_3 = h_y_1 - h_y_2;  /* F69 */
    const int32_t h_y = round_32(h_y_3);  /* F37, |x| <= 0.00334 */
    const int64_t h_z_1 = (int64_t)2004318071 /* 7/60 */ * previous1_z;  /* F69 */
    const int64_t h_z_2 = (int64_t)286331153 /* 1/60 */ * previous2_z;  /* F69 */
    const int64_t h_z_3 = h_z_1 - h_z_2;  /* F69 */
    const int32_t h_z = round_32(h_z_3);  /* F37, |x| <= 0.00334 */

    /* coning = h x theta   [savage1998 (46)] */
    const int64_t coning_x_1 = (int64_t)h_y * dtheta_z;  /* F72 */
    const int64_t coning_x_2 = (int64_t)h_z * dtheta_y;  /* F72 */
    const int64_t coning_x_3 = coning_x_1 - coning_x_2;  /* F72 */
    const int32_t coning_x = round_36(coning_x_3);  /* F36, |x| <= 8.34e-05 */

    /* phi = theta + coning   [savage1998 (46)] */
    const int32_t phi_x_1 = dtheta_x * 2;  /* F36 */
    const int32_t phi_x = phi_x_1 + coning_x;  /* F36, |x| <= 0.0251 */

    /* coning = h x theta   [savage1998 (46)] */
    const int64_t coning_y_1 = (int64_t)h_z * dtheta_x;  /* F72 */
    const int64_t coning_y_2 = (int64_t)h_x * dtheta_z;  /* F72 */
    const int64_t coning_y_3 = coning_y_1 - coning_y_2;  /* F72 */
    const int32_t coning_y = round_36(coning_y_3);  /* F36, |x| <= 8.34e-05 */

    /* phi = theta + coning   [savage1998 (46)] */
    const int32_t phi_y_1 = dtheta_y * 2;  /* F36 */
    const int32_t phi_y = phi_y_1 + coning_y;  /* F36, |x| <= 0.0251 */

    /* coning = h x theta   [savage1998 (46)] */
    const int64_t coning_z_1 = (int64_t)h_x * dtheta_y;  /* F72 */
    const int64_t coning_z_2 = (int64_t)h_y * dtheta_x;  /* F72 */
    const int64_t coning_z_3 = coning_z_1 - coning_z_2;  /* F72 */
    const int32_t coning_z = round_36(coning_z_3);  /* F36, |x| <= 8.34e-05 */

    /* phi = theta + coning   [savage1998 (46)] */
    const int32_t phi_z_1 = dtheta_z * 2;  /* F36 */
    const int32_t phi_z = phi_z_1 + coning_z;  /* F36, |x| <= 0.0251 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)phi_x * phi_x;  /* F72 */
    const int64_t phi_square_2 = (int64_t)phi_y * phi_y;  /* F72 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F72 */
    const int64_t phi_square_4 = (int64_t)phi_z * phi_z;  /* F72 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F72 */
    const int32_t phi_square = round_32(phi_square_5);  /* F40, |x| <= 0.00063 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)21845 /* 352/135169 */ * phi_square;  /* F63 */
    const int64_t u_2 = u_1 - INT64_C(1152921504571050778) /* 4025991479/32207931833 */;  /* F63 */
    const int32_t u_3 = round_32(u_2);  /* F31, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)1431645853 /* 3009/144433 */ * phi_square;  /* F76 */
    const int64_t y_2 = -y_1;  /* F76 */
    const int32_t y = round_32(y_2);  /* F44, |x| <= 1.32e-05 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * phi_x;  /* F80 */
    const int32_t bent_x = round_32(bent_x_1);  /* F48, |x| <= 3.29e-07 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x_fine = round_short_11(bent_x);  /* F37 */
    const int32_t v_x = v_x_fine + phi_x;  /* F37, |x| <= 0.0126 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * phi_y;  /* F80 */
    const int32_t bent_y = round_32(bent_y_1);  /* F48, |x| <= 3.29e-07 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y_fine = round_short_11(bent_y);  /* F37 */
    const int32_t v_y = v_y_fine + phi_y;  /* F37, |x| <= 0.0126 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * phi_z;  /* F80 */
    const int32_t bent_z = round_32(bent_z_1);  /* F48, |x| <= 3.29e-07 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z_fine = round_short_11(bent_z);  /* F37 */
    const int32_t v_z = v_z_fine + phi_z;  /* F37, |x| <= 0.0126 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F71 */
    const int32_t u = round_32(u_4);  /* F39, |x| <= 7.87e-05 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(4194304);  /* F61 */
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
    const int32_t a = round_24(a_10);  /* F37, |x| <= 0.000323 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t q_x_negated = -q_x;  /* F30 */
    const int32_t q_y_negated = -q_y;  /* F30 */
    const int32_t q_z_negated = -q_z;  /* F30 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F67 */
    const int64_t dq_w_2 = (int64_t)q_x_negated * v_x;  /* F67 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F67 */
    const int64_t dq_w_4 = (int64_t)q_y_negated * v_y;  /* F67 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F67 */
    const int64_t dq_w_6 = (int64_t)q_z_negated * v_z;  /* F67 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F67 */
    const int32_t dq_w = round_37(dq_w_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F67 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F67 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F67 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F67 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F67 */
    const int64_t dq_x_6 = (int64_t)q_z_negated * v_y;  /* F67 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F67 */
    const int32_t dq_x = round_37(dq_x_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F67 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F67 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F67 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F67 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F67 */
    const int64_t dq_y_6 = (int64_t)q_x_negated * v_z;  /* F67 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F67 */
    const int32_t dq_y = round_37(dq_y_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F67 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F67 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F67 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F67 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F67 */
    const int64_t dq_z_6 = (int64_t)q_y_negated * v_x;  /* F67 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F67 */
    const int32_t dq_z = round_37(dq_z_7);  /* F30, |x| <= 0.0126 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->previous[0] = dtheta_x;
    state->previous[1] = dtheta_y;
    state->previous[2] = dtheta_z;
    state->previous[3] = previous1_x;
    state->previous[4] = previous1_y;
    state->previous[5] = previous1_z;
}

void rotation_vector_1_previous_2_fixed32_update(
    rotation_vector_1_previous_2_fixed32_state *state, const int32_t dtheta[3])
{
    /* the history is full after 2 updates */
    if (state->count < 2) {
        rotation_vector_1_previous_2_fixed32_start_up(state, dtheta);
    } else {
        rotation_vector_1_previous_2_fixed32_steady(state, dtheta);
    }
}

void rotation_vector_1_previous_2_fixed32_quaternion(
    const rotation_vector_1_previous_2_fixed32_state *state, int32_t q_nb[4])
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
