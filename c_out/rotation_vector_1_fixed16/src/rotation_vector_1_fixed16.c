/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_fixed16
 *
 * qcone 0.1.0, design rotation_vector_1_fixed16, SHA-256 of the design
 * 1ea0e80fb39ec4301f6247cbfb772aeddb3aa8d59bdc31410e425130c90399bd
 *
 * algorithm:   rotation-vector-1, form factored, q' = q + q (x) (r - 1), renormalised on every
 *              update
 * source:      cao (8), (9)
 * equation:    phi = theta
 * number:      fixed16: words of 16 bits, sums in 32; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1001 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              2.2e-11 (scalar), 2.6e-09 (vector), proved over the rationals
 * rounding:    one update is within 6.7e-05 of exact arithmetic, in the norm of the components;
 *              proved
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       33       0   20         7       0       0     0     0     0       0      0
 * update shared           29       4   20         7       0       0     0     0     0       0      0
 * update emitted          29       0   21         6       1       0     0     0     0       0     32
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_1_fixed16.h"

#if ROTATION_VECTOR_1_FIXED16_VERSION != 1
#error "rotation_vector_1_fixed16.h is of another version than this file: generate both again"
#endif

/* x / 2^bits, rounded down, 0 <= bits < 32. */
static inline int32_t shift_right_32(int32_t x, int bits)
{
    return ((((int32_t)-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));
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

/* x / 2^10, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_10(int32_t x)
{
    return (int16_t)shift_right_32(x + 512, 10);
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

/* x / 2^21, rounded to nearest, halves up; the result fits 16 bits. */
static inline int16_t round_21(int32_t x)
{
    return (int16_t)shift_right_32(x + 1048576, 21);
}

void rotation_vector_1_fixed16_init(rotation_vector_1_fixed16_state *state)
{
    state->q[0] = 16384 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
}

void rotation_vector_1_fixed16_set_quaternion(
    rotation_vector_1_fixed16_state *state, const int16_t q_nb[4])
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
    const int16_t q_next_w_part = round_14(q_next_w_part_1);  /* F24, |x| <= 0.000979 */
    const int32_t q_next_w_1 = (int32_t)q_nb_w * 1024;  /* F24 */
    const int32_t q_next_w_2 = q_next_w_1 + q_next_w_part;  /* F24 */
    const int16_t q_next_w = round_10(q_next_w_2);  /* F14, |x| <= 1.01 */
    const int32_t q_next_x_part_1 = (int32_t)e * q_nb_x;  /* F38 */
    const int16_t q_next_x_part = round_14(q_next_x_part_1);  /* F24, |x| <= 0.000979 */
    const int32_t q_next_x_1 = (int32_t)q_nb_x * 1024;  /* F24 */
    const int32_t q_next_x_2 = q_next_x_1 + q_next_x_part;  /* F24 */
    const int16_t q_next_x = round_10(q_next_x_2);  /* F14, |x| <= 1.01 */
    const int32_t q_next_y_part_1 = (int32_t)e * q_nb_y;  /* F38 */
    const int16_t q_next_y_part = round_14(q_next_y_part_1);  /* F24, |x| <= 0.000979 */
    const int32_t q_next_y_1 = (int32_t)q_nb_y * 1024;  /* F24 */
    const int32_t q_next_y_2 = q_next_y_1 + q_next_y_part;  /* F24 */
    const int16_t q_next_y = round_10(q_next_y_2);  /* F14, |x| <= 1.01 */
    const int32_t q_next_z_part_1 = (int32_t)e * q_nb_z;  /* F38 */
    const int16_t q_next_z_part = round_14(q_next_z_part_1);  /* F24, |x| <= 0.000979 */
    const int32_t q_next_z_1 = (int32_t)q_nb_z * 1024;  /* F24 */
    const int32_t q_next_z_2 = q_next_z_1 + q_next_z_part;  /* F24 */
    const int16_t q_next_z = round_10(q_next_z_2);  /* F14, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_1_fixed16_update(rotation_vector_1_fixed16_state *state, const int16_t dtheta[3])
{
    /* attitude and input */
    const int16_t dtheta_x = dtheta[0];  /* F17, |x| <= 0.101 */
    const int16_t dtheta_y = dtheta[1];  /* F17, |x| <= 0.101 */
    const int16_t dtheta_z = dtheta[2];  /* F17, |x| <= 0.101 */

    /* phi_square = |phi|^2 */
    const int32_t phi_square_1 = (int32_t)dtheta_x * dtheta_x;  /* F34 */
    const int32_t phi_square_2 = (int32_t)dtheta_y * dtheta_y;  /* F34 */
    const int32_t phi_square_3 = phi_square_1 + phi_square_2;  /* F34 */
    const int32_t phi_square_4 = (int32_t)dtheta_z * dtheta_z;  /* F34 */
    const int32_t phi_square_5 = phi_square_3 + phi_square_4;  /* F34 */
    const int16_t phi_square = round_13(phi_square_5);  /* F21, |x| <= 0.0101 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int32_t phi_square_rounded_1 = (int32_t)21845 /* 1/384 */ * phi_square;  /* F44 */
    const int16_t phi_square_rounded = round_14(phi_square_rounded_1);  /* F30, |x| <= 2.61e-05 */
    const int32_t u_1 = phi_square_rounded - 134217728 /* 1/8 */;  /* F30 */
    const int16_t u_2 = round_13(u_1);  /* F17, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int32_t y_1 = (int32_t)21845 /* 1/48 */ * phi_square;  /* F41 */
    const int32_t y_2 = -y_1;  /* F41 */
    const int16_t y = round_14(y_2);  /* F27, |x| <= 0.000209 */

    /* bent = y phi   [cao (14)] */
    const int32_t bent_x_1 = (int32_t)y * dtheta_x;  /* F44 */
    const int16_t bent_x = round_14(bent_x_1);  /* F30, |x| <= 2.09e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x_1 = (int32_t)dtheta_x * 4096;  /* F30 */
    const int32_t v_x_2 = v_x_1 + bent_x;  /* F30 */
    const int16_t v_x = round_11(v_x_2);  /* F19, |x| <= 0.0501 */

    /* bent = y phi   [cao (14)] */
    const int32_t bent_y_1 = (int32_t)y * dtheta_y;  /* F44 */
    const int16_t bent_y = round_14(bent_y_1);  /* F30, |x| <= 2.09e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y_1 = (int32_t)dtheta_y * 4096;  /* F30 */
    const int32_t v_y_2 = v_y_1 + bent_y;  /* F30 */
    const int16_t v_y = round_11(v_y_2);  /* F19, |x| <= 0.0501 */

    /* bent = y phi   [cao (14)] */
    const int32_t bent_z_1 = (int32_t)y * dtheta_z;  /* F44 */
    const int16_t bent_z = round_14(bent_z_1);  /* F30, |x| <= 2.09e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z_1 = (int32_t)dtheta_z * 4096;  /* F30 */
    const int32_t v_z_2 = v_z_1 + bent_z;  /* F30 */
    const int16_t v_z = round_11(v_z_2);  /* F19, |x| <= 0.0501 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int32_t u_3 = (int32_t)phi_square * u_2;  /* F38 */
    const int16_t u = round_14(u_3);  /* F24, |x| <= 0.00126 */

    /* a = u + e */
    const int32_t a_1 = (int32_t)u * 32;  /* F29 */
    const int32_t a_2 = a_1 + 268435456 /* 1/2 */;  /* F29 */

    /* attitude and input */
    const int16_t q_w = state->q[0];  /* F14, |x| <= 1.01 */
    const int16_t q_x = state->q[1];  /* F14, |x| <= 1.01 */
    const int16_t q_y = state->q[2];  /* F14, |x| <= 1.01 */
    const int16_t q_z = state->q[3];  /* F14, |x| <= 1.01 */

    /* a = u + e */
    const int32_t a_3 = (int32_t)q_w * q_w;  /* F28 */
    const int32_t a_4 = (int32_t)q_x * q_x;  /* F28 */
    const int32_t a_5 = a_3 + a_4;  /* F29 */
    const int32_t a_6 = (int32_t)q_y * q_y;  /* F28 */
    const int32_t a_7 = a_5 + a_6;  /* F29 */
    const int32_t a_8 = (int32_t)q_z * q_z;  /* F28 */
    const int32_t a_9 = a_7 + a_8;  /* F29 */
    const int32_t a_10 = a_2 - a_9;  /* F29 */
    const int16_t a = round_8(a_10);  /* F21, |x| <= 0.00517 */

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
    const int16_t dq_w = round_21(dq_w_10);  /* F14, |x| <= 0.0506 */

    /* q_next = q + dq */
    const int32_t q_next_w_1 = (int32_t)q_w + dq_w;  /* F14 */
    const int16_t q_next_w = (int16_t)q_next_w_1;  /* F14, |x| <= 1.01 */

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
    const int16_t dq_x = round_21(dq_x_10);  /* F14, |x| <= 0.0506 */

    /* q_next = q + dq */
    const int32_t q_next_x_1 = (int32_t)q_x + dq_x;  /* F14 */
    const int16_t q_next_x = (int16_t)q_next_x_1;  /* F14, |x| <= 1.01 */

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
    const int16_t dq_y = round_21(dq_y_10);  /* F14, |x| <= 0.0506 */

    /* q_next = q + dq */
    const int32_t q_next_y_1 = (int32_t)q_y + dq_y;  /* F14 */
    const int16_t q_next_y = (int16_t)q_next_y_1;  /* F14, |x| <= 1.01 */

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
    const int16_t dq_z = round_21(dq_z_10);  /* F14, |x| <= 0.0506 */

    /* q_next = q + dq */
    const int32_t q_next_z_1 = (int32_t)q_z + dq_z;  /* F14 */
    const int16_t q_next_z = (int16_t)q_next_z_1;  /* F14, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_1_fixed16_quaternion(const rotation_vector_1_fixed16_state *state, int16_t q_nb[4])
{
    /* q, read once */
    const int16_t q_w = state->q[0];  /* F14, |x| <= 1.01 */
    const int16_t q_x = state->q[1];  /* F14, |x| <= 1.01 */
    const int16_t q_y = state->q[2];  /* F14, |x| <= 1.01 */
    const int16_t q_z = state->q[3];  /* F14, |x| <= 1.01 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}
