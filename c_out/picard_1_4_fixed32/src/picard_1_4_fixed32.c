/* Generated, do not edit. Made by: qcone generate picard.toml --design picard_1_4_fixed32
 *
 * qcone 0.1.0, design picard_1_4_fixed32, SHA-256 of the design
 * fd07beb50933e25b227a45a11b2133c9d397ae748e483079a28b07e8ca7ed334
 *
 * algorithm:   picard-4, form factored, q' = q + q (x) (r - 1), renormalised on every update
 * source:      cao (7), (8), (9)
 * equation:    r = [a_c, a_s sigma], sigma = theta
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; | |q|
 *              - 1 | <= 0.00391 always, proved; within it no sum overflows, as is proved; beyond
 *              it nothing is promised: clamp inputs that can be so large
 * truncation:  series of the algorithm's order in |phi|; error of r at most 2.2e-11 (scalar),
 *              2.6e-09 (vector)
 * rounding:    one update is within 2.3e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  10 of 12 rounded sums of products drop a whole word, 2 before formats were searched
 *              for that; of one update's errors in the first order it made 3.6e-09 of 2.3e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       30       0   17         8       0       0     0     0     0       0      0
 * update shared           29       1   17         8       0       0     0     0     0       0      0
 * update emitted          29       0   22         3       3       0     0     0     0       0     13
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "picard_1_4_fixed32.h"

#if PICARD_1_4_FIXED32_VERSION != 1
#error "picard_1_4_fixed32.h is of another version than this file: generate both again"
#endif

/* x / 2^bits, rounded down, 0 <= bits < 32. */
static inline int32_t shift_right_32(int32_t x, int bits)
{
    return ((((int32_t)-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));
}

/* x / 2^21, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_21(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1048576)) >> 21);
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

/* x / 2^32, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_32(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(2147483648)) >> 32);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

void picard_1_4_fixed32_init(picard_1_4_fixed32_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
}

void picard_1_4_fixed32_set_quaternion(picard_1_4_fixed32_state *state, const int32_t q_nb[4])
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

void picard_1_4_fixed32_update(picard_1_4_fixed32_state *state, const int32_t dtheta[3])
{
    /* attitude and input */
    const int32_t dtheta_x = dtheta[0];  /* F33, |x| <= 0.101 */
    const int32_t dtheta_y = dtheta[1];  /* F33, |x| <= 0.101 */
    const int32_t dtheta_z = dtheta[2];  /* F33, |x| <= 0.101 */

    /* phi_square = |phi|^2 */
    const int64_t phi_square_1 = (int64_t)dtheta_x * dtheta_x;  /* F66 */
    const int64_t phi_square_2 = (int64_t)dtheta_y * dtheta_y;  /* F66 */
    const int64_t phi_square_3 = phi_square_1 + phi_square_2;  /* F66 */
    const int64_t phi_square_4 = (int64_t)dtheta_z * dtheta_z;  /* F66 */
    const int64_t phi_square_5 = phi_square_3 + phi_square_4;  /* F66 */
    const int32_t phi_square = round_32(phi_square_5);  /* F34, |x| <= 0.0101 */

    /* u = a_c - 1   [cao (9)] */
    const int64_t u_1 = (int64_t)699051 /* 1/384 */ * phi_square;  /* F62 */
    const int64_t u_2 = u_1 - INT64_C(576460752303423488) /* 1/8 */;  /* F62 */
    const int32_t u_3 = round_32(u_2);  /* F30, |x| <= 0.126 */

    /* s = a_s = 1/2 - |phi|^2/48   [cao (9)] */
    const int64_t s_1 = (int64_t)1398101 /* 1/48 */ * phi_square;  /* F60 */
    const int64_t s_2 = INT64_C(576460752303423488) /* 1/2 */ - s_1;  /* F60 */
    const int32_t s = round_29(s_2);  /* F31, |x| <= 0.501 */

    /* v = s phi   [cao (9)] */
    const int64_t v_x_1 = (int64_t)s * dtheta_x;  /* F64 */
    const int32_t v_x = round_32(v_x_1);  /* F32, |x| <= 0.0501 */
    const int64_t v_y_1 = (int64_t)s * dtheta_y;  /* F64 */
    const int32_t v_y = round_32(v_y_1);  /* F32, |x| <= 0.0501 */
    const int64_t v_z_1 = (int64_t)s * dtheta_z;  /* F64 */
    const int32_t v_z = round_32(v_z_1);  /* F32, |x| <= 0.0501 */

    /* u = a_c - 1   [cao (9)] */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F64 */
    const int32_t u = round_32(u_4);  /* F32, |x| <= 0.00126 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(536870912);  /* F61 */
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
    const int32_t a = round_29(a_10);  /* F32, |x| <= 0.00517 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t q_x_negated = -q_x;  /* F30 */
    const int32_t q_y_negated = -q_y;  /* F30 */
    const int32_t q_z_negated = -q_z;  /* F30 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F62 */
    const int64_t dq_w_2 = (int64_t)q_x_negated * v_x;  /* F62 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F62 */
    const int64_t dq_w_4 = (int64_t)q_y_negated * v_y;  /* F62 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F62 */
    const int64_t dq_w_6 = (int64_t)q_z_negated * v_z;  /* F62 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F62 */
    const int32_t dq_w = round_32(dq_w_7);  /* F30, |x| <= 0.0505 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F62 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F62 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F62 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F62 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F62 */
    const int64_t dq_x_6 = (int64_t)q_z_negated * v_y;  /* F62 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F62 */
    const int32_t dq_x = round_32(dq_x_7);  /* F30, |x| <= 0.0505 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F62 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F62 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F62 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F62 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F62 */
    const int64_t dq_y_6 = (int64_t)q_x_negated * v_z;  /* F62 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F62 */
    const int32_t dq_y = round_32(dq_y_7);  /* F30, |x| <= 0.0505 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F62 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F62 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F62 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F62 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F62 */
    const int64_t dq_z_6 = (int64_t)q_y_negated * v_x;  /* F62 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F62 */
    const int32_t dq_z = round_32(dq_z_7);  /* F30, |x| <= 0.0505 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void picard_1_4_fixed32_quaternion(const picard_1_4_fixed32_state *state, int32_t q_nb[4])
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
