/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_fixed32
 *
 * qcone 0.1.0, design rotation_vector_1_fixed32, SHA-256 of the design
 * 5876abe08cd4cc8474e759446ab0286fff321f420e411ef29cff088982621e66
 *
 * algorithm:   rotation-vector-1, form factored, q' = q + q (x) (r - 1), renormalised on every
 *              update
 * source:      cao (8), (9)
 * equation:    phi = theta
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1001 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              9.1e-17 (scalar), 6.6e-14 (vector), proved over the rationals
 * rounding:    one update is within 1.7e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  8 of 14 rounded sums of products drop a whole word, 1 before formats were searched
 *              for that; of one update's errors in the first order it made 2.7e-09 of 2e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       35       0   22         7       0       0     0     0     0       0      0
 * update shared           31       4   22         7       0       0     0     0     0       0      0
 * update emitted          31       0   25         4       3       0     0     0     0       0     18
 * dcm as-written           9       0    9         6       0       0     0     0     0       0      0
 * dcm shared               9       0    9         6       0       0     0     0     0       0      0
 * dcm emitted              9       0    6         6       0       0     0     0     0       0     15
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_1_fixed32.h"

#if ROTATION_VECTOR_1_FIXED32_VERSION != 1
#error "rotation_vector_1_fixed32.h is of another version than this file: generate both again"
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

/* x / 2^27, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_27(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(67108864)) >> 27);
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

/* x / 2^34, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_34(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(8589934592), 34);
}

/* x / 2^40, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_40(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(549755813888), 40);
}

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

void rotation_vector_1_fixed32_init(rotation_vector_1_fixed32_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
}

void rotation_vector_1_fixed32_set_quaternion(
    rotation_vector_1_fixed32_state *state, const int32_t q_nb[4])
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

void rotation_vector_1_fixed32_update(rotation_vector_1_fixed32_state *state, const int32_t dtheta[3])
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

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_1 = (int64_t)372811 /* 1/46082 */ * phi_square;  /* F68 */
    const int64_t u_2 = INT64_C(768614336404564651) /* 1/384 */ - u_1;  /* F68 */
    const int32_t u_3 = round_40(u_2);  /* F28, |x| <= 0.00261 */
    const int64_t u_4 = (int64_t)phi_square * u_3;  /* F62 */
    const int64_t u_5 = u_4 - INT64_C(576460752303423488) /* 1/8 */;  /* F62 */
    const int32_t u_6 = round_32(u_5);  /* F30, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int64_t y_1 = (int64_t)69899 /* 3/11521 */ * phi_square;  /* F62 */
    const int64_t y_2 = y_1 - INT64_C(96076791419721232) /* 3172865/152297521 */;  /* F62 */
    const int32_t y_3 = round_32(y_2);  /* F30, |x| <= 0.0209 */
    const int64_t y_4 = (int64_t)phi_square * y_3;  /* F64 */
    const int32_t y = round_32(y_4);  /* F32, |x| <= 0.000209 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_x_1 = (int64_t)y * dtheta_x;  /* F65 */
    const int32_t bent_x = round_32(bent_x_1);  /* F33, |x| <= 2.09e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x_1 = bent_x * 2;  /* F34 */
    const int32_t v_x = dtheta_x + v_x_1;  /* F34, |x| <= 0.0501 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_y_1 = (int64_t)y * dtheta_y;  /* F65 */
    const int32_t bent_y = round_32(bent_y_1);  /* F33, |x| <= 2.09e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y_1 = bent_y * 2;  /* F34 */
    const int32_t v_y = dtheta_y + v_y_1;  /* F34, |x| <= 0.0501 */

    /* bent = y phi   [cao (14)] */
    const int64_t bent_z_1 = (int64_t)y * dtheta_z;  /* F65 */
    const int32_t bent_z = round_32(bent_z_1);  /* F33, |x| <= 2.09e-05 */

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z_1 = bent_z * 2;  /* F34 */
    const int32_t v_z = dtheta_z + v_z_1;  /* F34, |x| <= 0.0501 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_7 = (int64_t)phi_square * u_6;  /* F64 */
    const int32_t u = round_32(u_7);  /* F32, |x| <= 0.00126 */

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
    const int32_t a = round_27(a_10);  /* F34, |x| <= 0.00517 */

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
    const int32_t dq_w = round_34(dq_w_7);  /* F30, |x| <= 0.0505 */

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
    const int32_t dq_x = round_34(dq_x_7);  /* F30, |x| <= 0.0505 */

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
    const int32_t dq_y = round_34(dq_y_7);  /* F30, |x| <= 0.0505 */

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
    const int32_t dq_z = round_34(dq_z_7);  /* F30, |x| <= 0.0505 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_1_fixed32_quaternion(const rotation_vector_1_fixed32_state *state, int32_t q_nb[4])
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

void rotation_vector_1_fixed32_dcm(const rotation_vector_1_fixed32_state *state, int32_t c_nb[9])
{
    /* q, read once */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.01 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.01 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.01 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.01 */

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const int64_t wx_1 = (int64_t)q_w * q_x;  /* F60 */
    const int32_t wx = round_29(wx_1);  /* F30, |x| <= 1.01 */
    const int64_t wy_1 = (int64_t)q_w * q_y;  /* F60 */
    const int32_t wy = round_29(wy_1);  /* F30, |x| <= 1.01 */
    const int64_t wz_1 = (int64_t)q_w * q_z;  /* F60 */
    const int32_t wz = round_29(wz_1);  /* F30, |x| <= 1.01 */
    const int64_t xx_1 = (int64_t)q_x * q_x;  /* F60 */
    const int32_t xx = round_30(xx_1);  /* F29, |x| <= 2.02 */
    const int64_t xy_1 = (int64_t)q_x * q_y;  /* F60 */
    const int32_t xy = round_29(xy_1);  /* F30, |x| <= 1.01 */
    const int64_t xz_1 = (int64_t)q_x * q_z;  /* F60 */
    const int32_t xz = round_29(xz_1);  /* F30, |x| <= 1.01 */
    const int64_t yy_1 = (int64_t)q_y * q_y;  /* F60 */
    const int32_t yy = round_30(yy_1);  /* F29, |x| <= 2.02 */
    const int64_t yz_1 = (int64_t)q_y * q_z;  /* F60 */
    const int32_t yz = round_29(yz_1);  /* F30, |x| <= 1.01 */
    const int64_t zz_1 = (int64_t)q_z * q_z;  /* F60 */
    const int32_t zz = round_30(zz_1);  /* F29, |x| <= 2.02 */

    /* c_nb = C_nb(q)   [cao (15)] */
    const int64_t c_nb_11_1 = yy * INT64_C(2);  /* F30 */
    const int64_t c_nb_11_2 = zz * INT64_C(2);  /* F30 */
    const int64_t c_nb_11_3 = c_nb_11_1 + c_nb_11_2;  /* F30 */
    const int64_t c_nb_11_4 = INT64_C(1073741824) /* 1 */ - c_nb_11_3;  /* F30 */
    const int32_t c_nb_11 = (int32_t)c_nb_11_4;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_12_1 = (int64_t)xy - wz;  /* F30 */
    const int32_t c_nb_12 = (int32_t)c_nb_12_1;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_13_1 = (int64_t)xz + wy;  /* F30 */
    const int32_t c_nb_13 = (int32_t)c_nb_13_1;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_21_1 = (int64_t)xy + wz;  /* F30 */
    const int32_t c_nb_21 = (int32_t)c_nb_21_1;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_22_1 = xx * INT64_C(2);  /* F30 */
    const int64_t c_nb_22_2 = zz * INT64_C(2);  /* F30 */
    const int64_t c_nb_22_3 = c_nb_22_1 + c_nb_22_2;  /* F30 */
    const int64_t c_nb_22_4 = INT64_C(1073741824) /* 1 */ - c_nb_22_3;  /* F30 */
    const int32_t c_nb_22 = (int32_t)c_nb_22_4;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_23_1 = (int64_t)yz - wx;  /* F30 */
    const int32_t c_nb_23 = (int32_t)c_nb_23_1;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_31_1 = (int64_t)xz - wy;  /* F30 */
    const int32_t c_nb_31 = (int32_t)c_nb_31_1;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_32_1 = (int64_t)yz + wx;  /* F30 */
    const int32_t c_nb_32 = (int32_t)c_nb_32_1;  /* F30, |x| <= 1.02 */
    const int64_t c_nb_33_1 = xx * INT64_C(2);  /* F30 */
    const int64_t c_nb_33_2 = yy * INT64_C(2);  /* F30 */
    const int64_t c_nb_33_3 = c_nb_33_1 + c_nb_33_2;  /* F30 */
    const int64_t c_nb_33_4 = INT64_C(1073741824) /* 1 */ - c_nb_33_3;  /* F30 */
    const int32_t c_nb_33 = (int32_t)c_nb_33_4;  /* F30, |x| <= 1.02 */

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
