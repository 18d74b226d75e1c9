/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_8_midpoint_fixed32_compensated
 *
 * qcone 0.1.0, design quaternion_taylor_3_8_midpoint_fixed32_compensated, SHA-256 of the design
 * 652f0a40ef1654ed78468e2d50664704c4ffe9f011aa58ddf1c565a177e4e94a
 *
 * algorithm:   quaternion-taylor-3-8-midpoint, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      xu2019 (5), (7), (8)
 * equation:    r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; | |q|
 *              - 1 | <= 0.0156 always, proved; within it no sum overflows, as is proved; beyond it
 *              nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 4.8e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  60 of 81 rounded sums of products drop a whole word, 22 before formats were
 *              searched for that; of one update's errors in the first order it made 1.3e-09 of
 *              1.3e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      416       0  260       169       0       0     0     0     0       0      0
 * update shared          268      16  185       145       0       0     0     0     0       0      0
 * update emitted         256       0  263        23      15       0     0     0     0       0    267
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "quaternion_taylor_3_8_midpoint_fixed32_compensated.h"

#if QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_VERSION != 1
#error "quaternion_taylor_3_8_midpoint_fixed32_compensated.h is of another version than this file: generate both again"
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

/* whole - 2^6 rounded; the result fits 32 bits. */
static inline int32_t left_of_6(int64_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 6);
    return wrapped_32(left);
}

/* x / 2^2, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_2(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(2)) >> 2);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^4, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_4(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(8)) >> 4);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^6, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_6(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(32)) >> 6);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^21, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_21(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(1048576)) >> 21);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^22, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_22(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(2097152)) >> 22);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^25, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_25(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(16777216)) >> 25);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^26, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_26(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(33554432)) >> 26);
    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);
}

/* x / 2^27, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_27(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(67108864)) >> 27);
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

/* x / 2^33, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_33(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(4294967296), 33);
}

/* x / 2^34, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_34(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(8589934592), 34);
}

/* x / 2^9, rounded to nearest, halves up. */
static inline int32_t round_short_9(int32_t x)
{
    return shift_right_32(x + 256, 9);
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

void quaternion_taylor_3_8_midpoint_fixed32_compensated_init(
    quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state)
{
    state->q[0] = INT64_C(4611686018427387904) /* 1 */;
    state->q[1] = INT64_C(0);
    state->q[2] = INT64_C(0);
    state->q[3] = INT64_C(0);
    state->residual[0] = 0;
    state->residual[1] = 0;
    state->residual[2] = 0;
}

void quaternion_taylor_3_8_midpoint_fixed32_compensated_set_quaternion(
    quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state, const int32_t q_nb[4])
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
}

void quaternion_taylor_3_8_midpoint_fixed32_compensated_update(
    quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state, const int32_t dtheta[9])
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

    /* f_k = forward differences of theta_1 .. theta_N */
    const int32_t A0_z_1 = dtheta2_z - dtheta1_z;  /* F34, |x| <= 0.00388 */
    const int32_t A0_y_1 = dtheta2_y - dtheta1_y;  /* F34, |x| <= 0.00388 */
    const int32_t A0_x_1 = dtheta2_x - dtheta1_x;  /* F34, |x| <= 0.00388 */
    const int32_t A0_z_2 = dtheta2_z + A0_z_1;  /* F34 */
    const int32_t A0_z_3 = dtheta3_z - A0_z_2;  /* F34, |x| <= 0.000647 */
    const int32_t A0_y_2 = dtheta2_y + A0_y_1;  /* F34 */
    const int32_t A0_y_3 = dtheta3_y - A0_y_2;  /* F34, |x| <= 0.000647 */
    const int32_t A0_x_2 = dtheta2_x + A0_x_1;  /* F34 */
    const int32_t A0_x_3 = dtheta3_x - A0_x_2;  /* F34, |x| <= 0.000647 */

    /* A_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    const int64_t A0_x_4 = (int64_t)3 /* 3/4 */ * dtheta1_x;  /* F36 */
    const int64_t A0_x_5 = A0_x_4 * INT64_C(8);  /* F39 */
    const int64_t A0_x_6 = (int64_t)3 /* 3/4 */ * A0_x_1;  /* F36 */
    const int64_t A0_x_7 = A0_x_6 * INT64_C(8);  /* F39 */
    const int64_t A0_x_8 = A0_x_5 + A0_x_7;  /* F39 */
    const int64_t A0_x_9 = A0_x_8 - A0_x_3;  /* F39 */
    const int32_t A0_x = round_4(A0_x_9);  /* F35, |x| <= 0.028 */
    const int64_t A0_y_4 = (int64_t)3 /* 3/4 */ * dtheta1_y;  /* F36 */
    const int64_t A0_y_5 = A0_y_4 * INT64_C(8);  /* F39 */
    const int64_t A0_y_6 = (int64_t)3 /* 3/4 */ * A0_y_1;  /* F36 */
    const int64_t A0_y_7 = A0_y_6 * INT64_C(8);  /* F39 */
    const int64_t A0_y_8 = A0_y_5 + A0_y_7;  /* F39 */
    const int64_t A0_y_9 = A0_y_8 - A0_y_3;  /* F39 */
    const int32_t A0_y = round_4(A0_y_9);  /* F35, |x| <= 0.028 */
    const int64_t A0_z_4 = (int64_t)3 /* 3/4 */ * dtheta1_z;  /* F36 */
    const int64_t A0_z_5 = A0_z_4 * INT64_C(8);  /* F39 */
    const int64_t A0_z_6 = (int64_t)3 /* 3/4 */ * A0_z_1;  /* F36 */
    const int64_t A0_z_7 = A0_z_6 * INT64_C(8);  /* F39 */
    const int64_t A0_z_8 = A0_z_5 + A0_z_7;  /* F39 */
    const int64_t A0_z_9 = A0_z_8 - A0_z_3;  /* F39 */
    const int32_t A0_z = round_4(A0_z_9);  /* F35, |x| <= 0.028 */
    const int64_t A1_x_1 = (int64_t)9 /* 9/8 */ * A0_x_1;  /* F37 */
    const int64_t A1_x_2 = A1_x_1 * INT64_C(2);  /* F38 */
    const int64_t A1_x_3 = (int64_t)9 /* 9/16 */ * A0_x_3;  /* F38 */
    const int64_t A1_x_4 = A1_x_2 + A1_x_3;  /* F38 */
    const int32_t A1_x = (int32_t)A1_x_4;  /* F38, |x| <= 0.00437 */
    const int64_t A1_y_1 = (int64_t)9 /* 9/8 */ * A0_y_1;  /* F37 */
    const int64_t A1_y_2 = A1_y_1 * INT64_C(2);  /* F38 */
    const int64_t A1_y_3 = (int64_t)9 /* 9/16 */ * A0_y_3;  /* F38 */
    const int64_t A1_y_4 = A1_y_2 + A1_y_3;  /* F38 */
    const int32_t A1_y = (int32_t)A1_y_4;  /* F38, |x| <= 0.00437 */
    const int64_t A1_z_1 = (int64_t)9 /* 9/8 */ * A0_z_1;  /* F37 */
    const int64_t A1_z_2 = A1_z_1 * INT64_C(2);  /* F38 */
    const int64_t A1_z_3 = (int64_t)9 /* 9/16 */ * A0_z_3;  /* F38 */
    const int64_t A1_z_4 = A1_z_2 + A1_z_3;  /* F38 */
    const int32_t A1_z = (int32_t)A1_z_4;  /* F38, |x| <= 0.00437 */
    const int64_t A2_x_1 = (int64_t)27 /* 27/32 */ * A0_x_3;  /* F39 */
    const int32_t A2_x = (int32_t)A2_x_1;  /* F39, |x| <= 0.000546 */
    const int64_t A2_y_1 = (int64_t)27 /* 27/32 */ * A0_y_3;  /* F39 */
    const int32_t A2_y = (int32_t)A2_y_1;  /* F39, |x| <= 0.000546 */
    const int64_t A2_z_1 = (int64_t)27 /* 27/32 */ * A0_z_3;  /* F39 */
    const int32_t A2_z = (int32_t)A2_z_1;  /* F39, |x| <= 0.000546 */

    /* r_2 = 1/2 sum_j r_(2-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r2_w_1 = (int64_t)A0_x * A0_x;  /* F70 */
    const int64_t r2_w_2 = (int64_t)A0_y * A0_y;  /* F70 */
    const int64_t r2_w_3 = r2_w_1 + r2_w_2;  /* F71 */
    const int64_t r2_w_4 = (int64_t)A0_z * A0_z;  /* F70 */
    const int64_t r2_w_5 = r2_w_3 + r2_w_4;  /* F71 */
    const int64_t r2_w_6 = -r2_w_5;  /* F71 */
    const int32_t r2_w = round_31(r2_w_6);  /* F40, |x| <= 0.00118 */

    /* r_3 = 1/3 sum_j r_(3-1-j) (x) A_j   [xu2019 (7)] */
    const int32_t A0_x_negated = -A0_x;  /* F35 */
    const int32_t A0_y_negated = -A0_y;  /* F35 */
    const int32_t A0_z_negated = -A0_z;  /* F35 */
    const int64_t r3_w_1 = (int64_t)A1_x * A0_x_negated;  /* F73 */
    const int64_t r3_w_2 = (int64_t)A1_y * A0_y_negated;  /* F73 */
    const int64_t r3_w_3 = r3_w_1 + r3_w_2;  /* F74 */
    const int64_t r3_w_4 = (int64_t)A1_z * A0_z_negated;  /* F73 */
    const int64_t r3_w_5 = r3_w_3 + r3_w_4;  /* F74 */
    const int32_t r3_w_6 = round_32(r3_w_5);  /* F42, |x| <= 0.000183 */
    const int64_t r3_w_7 = r3_w_6 * INT64_C(2147483648);  /* F73 */
    const int64_t r3_w_8 = (int64_t)A0_x_negated * A1_x;  /* F73 */
    const int64_t r3_w_9 = r3_w_7 + r3_w_8;  /* F73 */
    const int64_t r3_w_10 = (int64_t)A0_y_negated * A1_y;  /* F73 */
    const int64_t r3_w_11 = r3_w_9 + r3_w_10;  /* F73 */
    const int64_t r3_w_12 = (int64_t)A0_z_negated * A1_z;  /* F73 */
    const int64_t r3_w_13 = r3_w_11 + r3_w_12;  /* F73 */
    const int32_t r3_w_14 = round_32(r3_w_13);  /* F41, |x| <= 0.000549 */
    const int64_t r3_x_1 = (int64_t)r2_w * A0_x;  /* F75 */
    const int64_t r3_x_2 = (int64_t)A1_y * A0_z_negated;  /* F73 */
    const int64_t r3_x_3 = r3_x_2 * INT64_C(2);  /* F75 */
    const int64_t r3_x_4 = r3_x_1 + r3_x_3;  /* F75 */
    const int64_t r3_x_5 = (int64_t)A1_z * A0_y;  /* F73 */
    const int64_t r3_x_6 = r3_x_5 * INT64_C(2);  /* F75 */
    const int64_t r3_x_7 = r3_x_4 + r3_x_6;  /* F75 */
    const int32_t r3_x_8 = round_34(r3_x_7);  /* F41, |x| <= 0.000155 */
    const int32_t r3_x_9 = A2_x * 4;  /* F41 */
    const int32_t r3_x_10 = r3_x_8 + r3_x_9;  /* F41, |x| <= 0.0007 */
    const int64_t r3_y_1 = (int64_t)r2_w * A0_y;  /* F75 */
    const int64_t r3_y_2 = (int64_t)A1_z * A0_x_negated;  /* F73 */
    const int64_t r3_y_3 = r3_y_2 * INT64_C(2);  /* F75 */
    const int64_t r3_y_4 = r3_y_1 + r3_y_3;  /* F75 */
    const int64_t r3_y_5 = (int64_t)A1_x * A0_z;  /* F73 */
    const int64_t r3_y_6 = r3_y_5 * INT64_C(2);  /* F75 */
    const int64_t r3_y_7 = r3_y_4 + r3_y_6;  /* F75 */
    const int32_t r3_y_8 = round_34(r3_y_7);  /* F41, |x| <= 0.000155 */
    const int32_t r3_y_9 = A2_y * 4;  /* F41 */
    const int32_t r3_y_10 = r3_y_8 + r3_y_9;  /* F41, |x| <= 0.0007 */
    const int64_t r3_z_1 = (int64_t)r2_w * A0_z;  /* F75 */
    const int64_t r3_z_2 = (int64_t)A1_x * A0_y_negated;  /* F73 */
    const int64_t r3_z_3 = r3_z_2 * INT64_C(2);  /* F75 */
    const int64_t r3_z_4 = r3_z_1 + r3_z_3;  /* F75 */
    const int64_t r3_z_5 = (int64_t)A1_y * A0_x;  /* F73 */
    const int64_t r3_z_6 = r3_z_5 * INT64_C(2);  /* F75 */
    const int64_t r3_z_7 = r3_z_4 + r3_z_6;  /* F75 */
    const int32_t r3_z_8 = round_34(r3_z_7);  /* F41, |x| <= 0.000155 */
    const int32_t r3_z_9 = A2_z * 4;  /* F41 */
    const int32_t r3_z_10 = r3_z_8 + r3_z_9;  /* F41, |x| <= 0.0007 */
    const int64_t r3_w_15 = (int64_t)1431655765 /* 1/3 */ * r3_w_14;  /* F73 */
    const int32_t r3_w = round_32(r3_w_15);  /* F41, |x| <= 0.000183 */
    const int64_t r3_x_11 = (int64_t)1431655765 /* 1/3 */ * r3_x_10;  /* F73 */
    const int32_t r3_x = round_32(r3_x_11);  /* F41, |x| <= 0.000234 */
    const int64_t r3_y_11 = (int64_t)1431655765 /* 1/3 */ * r3_y_10;  /* F73 */
    const int32_t r3_y = round_32(r3_y_11);  /* F41, |x| <= 0.000234 */
    const int64_t r3_z_11 = (int64_t)1431655765 /* 1/3 */ * r3_z_10;  /* F73 */
    const int32_t r3_z = round_32(r3_z_11);  /* F41, |x| <= 0.000234 */

    /* r_4 = 1/4 sum_j r_(4-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r4_w_part_1 = (int64_t)r3_x * A0_x_negated;  /* F76 */
    const int64_t r4_w_part_3 = (int64_t)r3_y * A0_y_negated;  /* F76 */
    const int64_t r4_w_part_4 = r4_w_part_1 + r4_w_part_3;  /* F78 */
    const int64_t r4_w_part_5 = (int64_t)r3_z * A0_z_negated;  /* F76 */
    const int64_t r4_w_part_6 = r4_w_part_4 + r4_w_part_5;  /* F78 */
    const int32_t r4_w_part = round_33(r4_w_part_6);  /* F45, |x| <= 4.89e-06 */
    const int64_t r4_w_part_part_1 = (int64_t)A1_x * A1_x;  /* F76 */
    const int64_t r4_w_part_part_2 = (int64_t)A1_y * A1_y;  /* F76 */
    const int64_t r4_w_part_part_3 = r4_w_part_part_1 + r4_w_part_part_2;  /* F79 */
    const int64_t r4_w_part_part_4 = (int64_t)A1_z * A1_z;  /* F76 */
    const int64_t r4_w_part_part_5 = r4_w_part_part_3 + r4_w_part_part_4;  /* F79 */
    const int64_t r4_w_part_part_6 = -r4_w_part_part_5;  /* F79 */
    const int32_t r4_w_part_part = round_32(r4_w_part_part_6);  /* F47, |x| <= 7.14e-06 */
    const int64_t r4_w_part_2_1 = r4_w_part_part * INT64_C(536870912);  /* F76 */
    const int64_t r4_w_part_2_2 = (int64_t)A0_x_negated * A2_x;  /* F74 */
    const int64_t r4_w_part_2_3 = r4_w_part_2_1 + r4_w_part_2_2;  /* F76 */
    const int64_t r4_w_part_2_4 = (int64_t)A0_y_negated * A2_y;  /* F74 */
    const int64_t r4_w_part_2_5 = r4_w_part_2_3 + r4_w_part_2_4;  /* F76 */
    const int64_t r4_w_part_2_6 = (int64_t)A0_z_negated * A2_z;  /* F74 */
    const int64_t r4_w_part_2_7 = r4_w_part_2_5 + r4_w_part_2_6;  /* F76 */
    const int32_t r4_w_part_2 = round_32(r4_w_part_2_7);  /* F44, |x| <= 1.86e-05 */
    const int32_t r4_w_1 = r4_w_part_2 * 2;  /* F45 */
    const int32_t r4_w = r4_w_part + r4_w_1;  /* F45, |x| <= 1.46e-05 */
    const int64_t r4_x_part_1 = (int64_t)r2_w * A1_x;  /* F78 */
    const int32_t r4_x_part = round_32(r4_x_part_1);  /* F48, |x| <= 1.28e-06 */
    const int64_t r4_x_1 = (int64_t)r3_w * A0_x;  /* F76 */
    const int64_t r4_x_2 = (int64_t)r3_y * A0_z;  /* F76 */
    const int64_t r4_x_3 = r4_x_1 + r4_x_2;  /* F78 */
    const int64_t r4_x_4 = (int64_t)r3_z * A0_y_negated;  /* F76 */
    const int64_t r4_x_5 = r4_x_3 + r4_x_4;  /* F78 */
    const int64_t r4_x_6 = r4_x_part * INT64_C(1073741824);  /* F78 */
    const int64_t r4_x_7 = r4_x_5 + r4_x_6;  /* F78 */
    const int64_t r4_x_8 = (int64_t)A0_y * A2_z;  /* F74 */
    const int64_t r4_x_9 = r4_x_8 * INT64_C(4);  /* F78 */
    const int64_t r4_x_10 = r4_x_7 + r4_x_9;  /* F78 */
    const int64_t r4_x_11 = (int64_t)A0_z_negated * A2_y;  /* F74 */
    const int64_t r4_x_12 = r4_x_11 * INT64_C(4);  /* F78 */
    const int64_t r4_x_13 = r4_x_10 + r4_x_12;  /* F78 */
    const int32_t r4_x = round_33(r4_x_13);  /* F45, |x| <= 1.35e-05 */
    const int64_t r4_y_part_1 = (int64_t)r2_w * A1_y;  /* F78 */
    const int32_t r4_y_part = round_32(r4_y_part_1);  /* F48, |x| <= 1.28e-06 */
    const int64_t r4_y_1 = (int64_t)r3_w * A0_y;  /* F76 */
    const int64_t r4_y_2 = (int64_t)r3_z * A0_x;  /* F76 */
    const int64_t r4_y_3 = r4_y_1 + r4_y_2;  /* F78 */
    const int64_t r4_y_4 = (int64_t)r3_x * A0_z_negated;  /* F76 */
    const int64_t r4_y_5 = r4_y_3 + r4_y_4;  /* F78 */
    const int64_t r4_y_6 = r4_y_part * INT64_C(1073741824);  /* F78 */
    const int64_t r4_y_7 = r4_y_5 + r4_y_6;  /* F78 */
    const int64_t r4_y_8 = (int64_t)A0_z * A2_x;  /* F74 */
    const int64_t r4_y_9 = r4_y_8 * INT64_C(4);  /* F78 */
    const int64_t r4_y_10 = r4_y_7 + r4_y_9;  /* F78 */
    const int64_t r4_y_11 = (int64_t)A0_x_negated * A2_z;  /* F74 */
    const int64_t r4_y_12 = r4_y_11 * INT64_C(4);  /* F78 */
    const int64_t r4_y_13 = r4_y_10 + r4_y_12;  /* F78 */
    const int32_t r4_y = round_33(r4_y_13);  /* F45, |x| <= 1.35e-05 */
    const int64_t r4_z_part_1 = (int64_t)r2_w * A1_z;  /* F78 */
    const int32_t r4_z_part = round_32(r4_z_part_1);  /* F48, |x| <= 1.28e-06 */
    const int64_t r4_z_1 = (int64_t)r3_w * A0_z;  /* F76 */
    const int64_t r4_z_2 = (int64_t)r3_x * A0_y;  /* F76 */
    const int64_t r4_z_3 = r4_z_1 + r4_z_2;  /* F78 */
    const int64_t r4_z_4 = (int64_t)r3_y * A0_x_negated;  /* F76 */
    const int64_t r4_z_5 = r4_z_3 + r4_z_4;  /* F78 */
    const int64_t r4_z_6 = r4_z_part * INT64_C(1073741824);  /* F78 */
    const int64_t r4_z_7 = r4_z_5 + r4_z_6;  /* F78 */
    const int64_t r4_z_8 = (int64_t)A0_x * A2_y;  /* F74 */
    const int64_t r4_z_9 = r4_z_8 * INT64_C(4);  /* F78 */
    const int64_t r4_z_10 = r4_z_7 + r4_z_9;  /* F78 */
    const int64_t r4_z_11 = (int64_t)A0_y_negated * A2_x;  /* F74 */
    const int64_t r4_z_12 = r4_z_11 * INT64_C(4);  /* F78 */
    const int64_t r4_z_13 = r4_z_10 + r4_z_12;  /* F78 */
    const int32_t r4_z = round_33(r4_z_13);  /* F45, |x| <= 1.35e-05 */

    /* r_5 = 1/5 sum_j r_(5-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r5_x_1 = (int64_t)r4_w * A0_x;  /* F80 */
    const int64_t r5_x_2 = (int64_t)r4_y * A0_z;  /* F80 */
    const int64_t r5_x_3 = r5_x_1 + r5_x_2;  /* F80 */
    const int64_t r5_x_4 = (int64_t)r4_z * A0_y_negated;  /* F80 */
    const int64_t r5_x_5 = r5_x_3 + r5_x_4;  /* F80 */
    const int32_t r5_x_6 = round_32(r5_x_5);  /* F48, |x| <= 1.16e-06 */
    const int32_t A1_y_negated = -A1_y;  /* F38 */
    const int32_t A1_z_negated = -A1_z;  /* F38 */
    const int64_t r5_x_7 = r5_x_6 * INT64_C(2147483648);  /* F79 */
    const int64_t r5_x_8 = (int64_t)r3_w * A1_x;  /* F79 */
    const int64_t r5_x_9 = r5_x_7 + r5_x_8;  /* F79 */
    const int64_t r5_x_10 = (int64_t)r3_y * A1_z;  /* F79 */
    const int64_t r5_x_11 = r5_x_9 + r5_x_10;  /* F79 */
    const int64_t r5_x_12 = (int64_t)r3_z * A1_y_negated;  /* F79 */
    const int64_t r5_x_13 = r5_x_11 + r5_x_12;  /* F79 */
    const int64_t r5_x_14 = (int64_t)r2_w * A2_x;  /* F79 */
    const int64_t r5_x_15 = r5_x_13 + r5_x_14;  /* F79 */
    const int64_t r5_x_16 = (int64_t)A1_y * A2_z;  /* F77 */
    const int64_t r5_x_17 = r5_x_16 * INT64_C(2);  /* F79 */
    const int64_t r5_x_18 = r5_x_15 + r5_x_17;  /* F79 */
    const int64_t r5_x_19 = (int64_t)A1_z_negated * A2_y;  /* F77 */
    const int64_t r5_x_20 = r5_x_19 * INT64_C(2);  /* F79 */
    const int64_t r5_x_21 = r5_x_18 + r5_x_20;  /* F79 */
    const int32_t r5_x_22 = round_32(r5_x_21);  /* F47, |x| <= 7.01e-06 */
    const int64_t r5_y_1 = (int64_t)r4_w * A0_y;  /* F80 */
    const int64_t r5_y_2 = (int64_t)r4_z * A0_x;  /* F80 */
    const int64_t r5_y_3 = r5_y_1 + r5_y_2;  /* F80 */
    const int64_t r5_y_4 = (int64_t)r4_x * A0_z_negated;  /* F80 */
    const int64_t r5_y_5 = r5_y_3 + r5_y_4;  /* F80 */
    const int32_t r5_y_6 = round_32(r5_y_5);  /* F48, |x| <= 1.16e-06 */
    const int32_t A1_x_negated = -A1_x;  /* F38 */
    const int64_t r5_y_7 = r5_y_6 * INT64_C(2147483648);  /* F79 */
    const int64_t r5_y_8 = (int64_t)r3_w * A1_y;  /* F79 */
    const int64_t r5_y_9 = r5_y_7 + r5_y_8;  /* F79 */
    const int64_t r5_y_10 = (int64_t)r3_z * A1_x;  /* F79 */
    const int64_t r5_y_11 = r5_y_9 + r5_y_10;  /* F79 */
    const int64_t r5_y_12 = (int64_t)r3_x * A1_z_negated;  /* F79 */
    const int64_t r5_y_13 = r5_y_11 + r5_y_12;  /* F79 */
    const int64_t r5_y_14 = (int64_t)r2_w * A2_y;  /* F79 */
    const int64_t r5_y_15 = r5_y_13 + r5_y_14;  /* F79 */
    const int64_t r5_y_16 = (int64_t)A1_z * A2_x;  /* F77 */
    const int64_t r5_y_17 = r5_y_16 * INT64_C(2);  /* F79 */
    const int64_t r5_y_18 = r5_y_15 + r5_y_17;  /* F79 */
    const int64_t r5_y_19 = (int64_t)A1_x_negated * A2_z;  /* F77 */
    const int64_t r5_y_20 = r5_y_19 * INT64_C(2);  /* F79 */
    const int64_t r5_y_21 = r5_y_18 + r5_y_20;  /* F79 */
    const int32_t r5_y_22 = round_32(r5_y_21);  /* F47, |x| <= 7.01e-06 */
    const int64_t r5_w_1 = (int64_t)r4_x * A0_x_negated;  /* F80 */
    const int64_t r5_w_2 = (int64_t)r4_y * A0_y_negated;  /* F80 */
    const int64_t r5_w_3 = r5_w_1 + r5_w_2;  /* F80 */
    const int64_t r5_w_4 = (int64_t)r4_z * A0_z_negated;  /* F80 */
    const int64_t r5_w_5 = r5_w_3 + r5_w_4;  /* F80 */
    const int32_t r5_w_6 = round_32(r5_w_5);  /* F48, |x| <= 1.13e-06 */
    const int64_t r5_w_7 = r5_w_6 * INT64_C(2147483648);  /* F79 */
    const int64_t r5_w_8 = (int64_t)r3_x * A1_x_negated;  /* F79 */
    const int64_t r5_w_9 = r5_w_7 + r5_w_8;  /* F79 */
    const int64_t r5_w_10 = (int64_t)r3_y * A1_y_negated;  /* F79 */
    const int64_t r5_w_11 = r5_w_9 + r5_w_10;  /* F79 */
    const int64_t r5_w_12 = (int64_t)r3_z * A1_z_negated;  /* F79 */
    const int64_t r5_w_13 = r5_w_11 + r5_w_12;  /* F79 */
    const int64_t r5_w_14 = (int64_t)A1_x_negated * A2_x;  /* F77 */
    const int64_t r5_w_15 = r5_w_14 * INT64_C(2);  /* F79 */
    const int64_t r5_w_16 = r5_w_13 + r5_w_15;  /* F79 */
    const int64_t r5_w_17 = (int64_t)A1_y_negated * A2_y;  /* F77 */
    const int64_t r5_w_18 = r5_w_17 * INT64_C(2);  /* F79 */
    const int64_t r5_w_19 = r5_w_16 + r5_w_18;  /* F79 */
    const int64_t r5_w_20 = (int64_t)A1_z_negated * A2_z;  /* F77 */
    const int64_t r5_w_21 = r5_w_20 * INT64_C(2);  /* F79 */
    const int64_t r5_w_22 = r5_w_19 + r5_w_21;  /* F79 */
    const int32_t r5_w_23 = round_32(r5_w_22);  /* F47, |x| <= 7.75e-06 */
    const int64_t r5_z_1 = (int64_t)r4_w * A0_z;  /* F80 */
    const int64_t r5_z_2 = (int64_t)r4_x * A0_y;  /* F80 */
    const int64_t r5_z_3 = r5_z_1 + r5_z_2;  /* F80 */
    const int64_t r5_z_4 = (int64_t)r4_y * A0_x_negated;  /* F80 */
    const int64_t r5_z_5 = r5_z_3 + r5_z_4;  /* F80 */
    const int32_t r5_z_6 = round_32(r5_z_5);  /* F48, |x| <= 1.16e-06 */
    const int64_t r5_z_7 = r5_z_6 * INT64_C(2147483648);  /* F79 */
    const int64_t r5_z_8 = (int64_t)r3_w * A1_z;  /* F79 */
    const int64_t r5_z_9 = r5_z_7 + r5_z_8;  /* F79 */
    const int64_t r5_z_10 = (int64_t)r3_x * A1_y;  /* F79 */
    const int64_t r5_z_11 = r5_z_9 + r5_z_10;  /* F79 */
    const int64_t r5_z_12 = (int64_t)r3_y * A1_x_negated;  /* F79 */
    const int64_t r5_z_13 = r5_z_11 + r5_z_12;  /* F79 */
    const int64_t r5_z_14 = (int64_t)r2_w * A2_z;  /* F79 */
    const int64_t r5_z_15 = r5_z_13 + r5_z_14;  /* F79 */
    const int64_t r5_z_16 = (int64_t)A1_x * A2_y;  /* F77 */
    const int64_t r5_z_17 = r5_z_16 * INT64_C(2);  /* F79 */
    const int64_t r5_z_18 = r5_z_15 + r5_z_17;  /* F79 */
    const int64_t r5_z_19 = (int64_t)A1_y_negated * A2_x;  /* F77 */
    const int64_t r5_z_20 = r5_z_19 * INT64_C(2);  /* F79 */
    const int64_t r5_z_21 = r5_z_18 + r5_z_20;  /* F79 */
    const int32_t r5_z_22 = round_32(r5_z_21);  /* F47, |x| <= 7.01e-06 */
    const int64_t r5_w_24 = (int64_t)858993459 /* 1/5 */ * r5_w_23;  /* F79 */
    const int32_t r5_w = round_32(r5_w_24);  /* F47, |x| <= 6.89e-07 */
    const int64_t r5_x_23 = (int64_t)858993459 /* 1/5 */ * r5_x_22;  /* F79 */
    const int32_t r5_x = round_32(r5_x_23);  /* F47, |x| <= 6.89e-07 */
    const int64_t r5_y_23 = (int64_t)858993459 /* 1/5 */ * r5_y_22;  /* F79 */
    const int32_t r5_y = round_32(r5_y_23);  /* F47, |x| <= 6.89e-07 */
    const int64_t r5_z_23 = (int64_t)858993459 /* 1/5 */ * r5_z_22;  /* F79 */
    const int32_t r5_z = round_32(r5_z_23);  /* F47, |x| <= 6.89e-07 */

    /* r_6 = 1/6 sum_j r_(6-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r6_x_1 = (int64_t)r5_w * A0_x;  /* F82 */
    const int64_t r6_x_2 = (int64_t)r5_y * A0_z;  /* F82 */
    const int64_t r6_x_3 = r6_x_1 + r6_x_2;  /* F82 */
    const int64_t r6_x_4 = (int64_t)r5_z * A0_y_negated;  /* F82 */
    const int64_t r6_x_5 = r6_x_3 + r6_x_4;  /* F82 */
    const int32_t r6_x_6 = round_32(r6_x_5);  /* F50, |x| <= 5.78e-08 */
    const int32_t A2_y_negated = -A2_y;  /* F39 */
    const int64_t r6_x_7 = (int64_t)r4_w * A1_x;  /* F83 */
    const int64_t r6_x_8 = (int64_t)r4_y * A1_z;  /* F83 */
    const int64_t r6_x_9 = r6_x_7 + r6_x_8;  /* F83 */
    const int64_t r6_x_10 = (int64_t)r4_z * A1_y_negated;  /* F83 */
    const int64_t r6_x_11 = r6_x_9 + r6_x_10;  /* F83 */
    const int64_t r6_x_12 = (int64_t)r3_w * A2_x;  /* F80 */
    const int64_t r6_x_13 = r6_x_12 * INT64_C(8);  /* F83 */
    const int64_t r6_x_14 = r6_x_11 + r6_x_13;  /* F83 */
    const int64_t r6_x_15 = (int64_t)r3_y * A2_z;  /* F80 */
    const int64_t r6_x_16 = r6_x_15 * INT64_C(8);  /* F83 */
    const int64_t r6_x_17 = r6_x_14 + r6_x_16;  /* F83 */
    const int64_t r6_x_18 = (int64_t)r3_z * A2_y_negated;  /* F80 */
    const int64_t r6_x_19 = r6_x_18 * INT64_C(8);  /* F83 */
    const int64_t r6_x_20 = r6_x_17 + r6_x_19;  /* F83 */
    const int32_t r6_x_21 = round_32(r6_x_20);  /* F51, |x| <= 5.36e-07 */
    const int32_t r6_x_22 = r6_x_6 * 2;  /* F51 */
    const int32_t r6_x_23 = r6_x_22 + r6_x_21;  /* F51, |x| <= 5.93e-07 */
    const int64_t r6_y_1 = (int64_t)r5_w * A0_y;  /* F82 */
    const int64_t r6_y_2 = (int64_t)r5_z * A0_x;  /* F82 */
    const int64_t r6_y_3 = r6_y_1 + r6_y_2;  /* F82 */
    const int64_t r6_y_4 = (int64_t)r5_x * A0_z_negated;  /* F82 */
    const int64_t r6_y_5 = r6_y_3 + r6_y_4;  /* F82 */
    const int32_t r6_y_6 = round_32(r6_y_5);  /* F50, |x| <= 5.78e-08 */
    const int32_t A2_z_negated = -A2_z;  /* F39 */
    const int64_t r6_y_7 = (int64_t)r4_w * A1_y;  /* F83 */
    const int64_t r6_y_8 = (int64_t)r4_z * A1_x;  /* F83 */
    const int64_t r6_y_9 = r6_y_7 + r6_y_8;  /* F83 */
    const int64_t r6_y_10 = (int64_t)r4_x * A1_z_negated;  /* F83 */
    const int64_t r6_y_11 = r6_y_9 + r6_y_10;  /* F83 */
    const int64_t r6_y_12 = (int64_t)r3_w * A2_y;  /* F80 */
    const int64_t r6_y_13 = r6_y_12 * INT64_C(8);  /* F83 */
    const int64_t r6_y_14 = r6_y_11 + r6_y_13;  /* F83 */
    const int64_t r6_y_15 = (int64_t)r3_z * A2_x;  /* F80 */
    const int64_t r6_y_16 = r6_y_15 * INT64_C(8);  /* F83 */
    const int64_t r6_y_17 = r6_y_14 + r6_y_16;  /* F83 */
    const int64_t r6_y_18 = (int64_t)r3_x * A2_z_negated;  /* F80 */
    const int64_t r6_y_19 = r6_y_18 * INT64_C(8);  /* F83 */
    const int64_t r6_y_20 = r6_y_17 + r6_y_19;  /* F83 */
    const int32_t r6_y_21 = round_32(r6_y_20);  /* F51, |x| <= 5.36e-07 */
    const int32_t r6_y_22 = r6_y_6 * 2;  /* F51 */
    const int32_t r6_y_23 = r6_y_22 + r6_y_21;  /* F51, |x| <= 5.93e-07 */
    const int64_t r6_w_1 = (int64_t)r5_x * A0_x_negated;  /* F82 */
    const int64_t r6_w_2 = (int64_t)r5_y * A0_y_negated;  /* F82 */
    const int64_t r6_w_3 = r6_w_1 + r6_w_2;  /* F82 */
    const int64_t r6_w_4 = (int64_t)r5_z * A0_z_negated;  /* F82 */
    const int64_t r6_w_5 = r6_w_3 + r6_w_4;  /* F82 */
    const int32_t r6_w_6 = round_32(r6_w_5);  /* F50, |x| <= 5.78e-08 */
    const int32_t A2_x_negated = -A2_x;  /* F39 */
    const int64_t r6_w_7 = (int64_t)r4_x * A1_x_negated;  /* F83 */
    const int64_t r6_w_8 = (int64_t)r4_y * A1_y_negated;  /* F83 */
    const int64_t r6_w_9 = r6_w_7 + r6_w_8;  /* F83 */
    const int64_t r6_w_10 = (int64_t)r4_z * A1_z_negated;  /* F83 */
    const int64_t r6_w_11 = r6_w_9 + r6_w_10;  /* F83 */
    const int64_t r6_w_12 = (int64_t)r3_x * A2_x_negated;  /* F80 */
    const int64_t r6_w_13 = r6_w_12 * INT64_C(8);  /* F83 */
    const int64_t r6_w_14 = r6_w_11 + r6_w_13;  /* F83 */
    const int64_t r6_w_15 = (int64_t)r3_y * A2_y_negated;  /* F80 */
    const int64_t r6_w_16 = r6_w_15 * INT64_C(8);  /* F83 */
    const int64_t r6_w_17 = r6_w_14 + r6_w_16;  /* F83 */
    const int64_t r6_w_18 = (int64_t)r3_z * A2_z_negated;  /* F80 */
    const int64_t r6_w_19 = r6_w_18 * INT64_C(8);  /* F83 */
    const int64_t r6_w_20 = r6_w_17 + r6_w_19;  /* F83 */
    const int32_t r6_w_21 = round_32(r6_w_20);  /* F51, |x| <= 5.58e-07 */
    const int32_t r6_w_22 = r6_w_6 * 2;  /* F51 */
    const int32_t r6_w_23 = r6_w_22 + r6_w_21;  /* F51, |x| <= 6.16e-07 */
    const int64_t r6_z_1 = (int64_t)r5_w * A0_z;  /* F82 */
    const int64_t r6_z_2 = (int64_t)r5_x * A0_y;  /* F82 */
    const int64_t r6_z_3 = r6_z_1 + r6_z_2;  /* F82 */
    const int64_t r6_z_4 = (int64_t)r5_y * A0_x_negated;  /* F82 */
    const int64_t r6_z_5 = r6_z_3 + r6_z_4;  /* F82 */
    const int32_t r6_z_6 = round_32(r6_z_5);  /* F50, |x| <= 5.78e-08 */
    const int64_t r6_z_7 = (int64_t)r4_w * A1_z;  /* F83 */
    const int64_t r6_z_8 = (int64_t)r4_x * A1_y;  /* F83 */
    const int64_t r6_z_9 = r6_z_7 + r6_z_8;  /* F83 */
    const int64_t r6_z_10 = (int64_t)r4_y * A1_x_negated;  /* F83 */
    const int64_t r6_z_11 = r6_z_9 + r6_z_10;  /* F83 */
    const int64_t r6_z_12 = (int64_t)r3_w * A2_z;  /* F80 */
    const int64_t r6_z_13 = r6_z_12 * INT64_C(8);  /* F83 */
    const int64_t r6_z_14 = r6_z_11 + r6_z_13;  /* F83 */
    const int64_t r6_z_15 = (int64_t)r3_x * A2_y;  /* F80 */
    const int64_t r6_z_16 = r6_z_15 * INT64_C(8);  /* F83 */
    const int64_t r6_z_17 = r6_z_14 + r6_z_16;  /* F83 */
    const int64_t r6_z_18 = (int64_t)r3_y * A2_x_negated;  /* F80 */
    const int64_t r6_z_19 = r6_z_18 * INT64_C(8);  /* F83 */
    const int64_t r6_z_20 = r6_z_17 + r6_z_19;  /* F83 */
    const int32_t r6_z_21 = round_32(r6_z_20);  /* F51, |x| <= 5.36e-07 */
    const int32_t r6_z_22 = r6_z_6 * 2;  /* F51 */
    const int32_t r6_z_23 = r6_z_22 + r6_z_21;  /* F51, |x| <= 5.93e-07 */
    const int64_t r6_w_24 = (int64_t)1431655765 /* 1/6 */ * r6_w_23;  /* F84 */
    const int32_t r6_w = round_32(r6_w_24);  /* F52, |x| <= 4.18e-08 */
    const int64_t r6_x_24 = (int64_t)1431655765 /* 1/6 */ * r6_x_23;  /* F84 */
    const int32_t r6_x = round_32(r6_x_24);  /* F52, |x| <= 4.18e-08 */
    const int64_t r6_y_24 = (int64_t)1431655765 /* 1/6 */ * r6_y_23;  /* F84 */
    const int32_t r6_y = round_32(r6_y_24);  /* F52, |x| <= 4.18e-08 */
    const int64_t r6_z_24 = (int64_t)1431655765 /* 1/6 */ * r6_z_23;  /* F84 */
    const int32_t r6_z = round_32(r6_z_24);  /* F52, |x| <= 4.18e-08 */

    /* r_7 = 1/7 sum_j r_(7-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r7_x_1 = (int64_t)r6_w * A0_x;  /* F87 */
    const int64_t r7_x_2 = (int64_t)r6_y * A0_z;  /* F87 */
    const int64_t r7_x_3 = r7_x_1 + r7_x_2;  /* F87 */
    const int64_t r7_x_4 = (int64_t)r6_z * A0_y_negated;  /* F87 */
    const int64_t r7_x_5 = r7_x_3 + r7_x_4;  /* F87 */
    const int32_t r7_x_6 = round_32(r7_x_5);  /* F55, |x| <= 3.5e-09 */
    const int64_t r7_x_7 = (int64_t)r5_w * A1_x;  /* F85 */
    const int64_t r7_x_8 = (int64_t)r5_y * A1_z;  /* F85 */
    const int64_t r7_x_9 = r7_x_7 + r7_x_8;  /* F85 */
    const int64_t r7_x_10 = (int64_t)r5_z * A1_y_negated;  /* F85 */
    const int64_t r7_x_11 = r7_x_9 + r7_x_10;  /* F85 */
    const int32_t r7_x_12 = round_32(r7_x_11);  /* F53, |x| <= 9.02e-09 */
    const int64_t r7_x_13 = r7_x_12 * INT64_C(2147483648);  /* F84 */
    const int64_t r7_x_14 = (int64_t)r4_w * A2_x;  /* F84 */
    const int64_t r7_x_15 = r7_x_13 + r7_x_14;  /* F84 */
    const int64_t r7_x_16 = (int64_t)r4_y * A2_z;  /* F84 */
    const int64_t r7_x_17 = r7_x_15 + r7_x_16;  /* F84 */
    const int64_t r7_x_18 = (int64_t)r4_z * A2_y_negated;  /* F84 */
    const int64_t r7_x_19 = r7_x_17 + r7_x_18;  /* F84 */
    const int32_t r7_x_20 = round_32(r7_x_19);  /* F52, |x| <= 3.17e-08 */
    const int32_t r7_x_21 = r7_x_20 * 8;  /* F55 */
    const int32_t r7_x_22 = r7_x_6 + r7_x_21;  /* F55, |x| <= 3.52e-08 */
    const int64_t r7_y_1 = (int64_t)r6_w * A0_y;  /* F87 */
    const int64_t r7_y_2 = (int64_t)r6_z * A0_x;  /* F87 */
    const int64_t r7_y_3 = r7_y_1 + r7_y_2;  /* F87 */
    const int64_t r7_y_4 = (int64_t)r6_x * A0_z_negated;  /* F87 */
    const int64_t r7_y_5 = r7_y_3 + r7_y_4;  /* F87 */
    const int32_t r7_y_6 = round_32(r7_y_5);  /* F55, |x| <= 3.5e-09 */
    const int64_t r7_y_7 = (int64_t)r5_w * A1_y;  /* F85 */
    const int64_t r7_y_8 = (int64_t)r5_z * A1_x;  /* F85 */
    const int64_t r7_y_9 = r7_y_7 + r7_y_8;  /* F85 */
    const int64_t r7_y_10 = (int64_t)r5_x * A1_z_negated;  /* F85 */
    const int64_t r7_y_11 = r7_y_9 + r7_y_10;  /* F85 */
    const int32_t r7_y_12 = round_32(r7_y_11);  /* F53, |x| <= 9.02e-09 */
    const int64_t r7_y_13 = r7_y_12 * INT64_C(2147483648);  /* F84 */
    const int64_t r7_y_14 = (int64_t)r4_w * A2_y;  /* F84 */
    const int64_t r7_y_15 = r7_y_13 + r7_y_14;  /* F84 */
    const int64_t r7_y_16 = (int64_t)r4_z * A2_x;  /* F84 */
    const int64_t r7_y_17 = r7_y_15 + r7_y_16;  /* F84 */
    const int64_t r7_y_18 = (int64_t)r4_x * A2_z_negated;  /* F84 */
    const int64_t r7_y_19 = r7_y_17 + r7_y_18;  /* F84 */
    const int32_t r7_y_20 = round_32(r7_y_19);  /* F52, |x| <= 3.17e-08 */
    const int32_t r7_y_21 = r7_y_20 * 8;  /* F55 */
    const int32_t r7_y_22 = r7_y_6 + r7_y_21;  /* F55, |x| <= 3.52e-08 */
    const int64_t r7_w_1 = (int64_t)r6_x * A0_x_negated;  /* F87 */
    const int64_t r7_w_2 = (int64_t)r6_y * A0_y_negated;  /* F87 */
    const int64_t r7_w_3 = r7_w_1 + r7_w_2;  /* F87 */
    const int64_t r7_w_4 = (int64_t)r6_z * A0_z_negated;  /* F87 */
    const int64_t r7_w_5 = r7_w_3 + r7_w_4;  /* F87 */
    const int32_t r7_w_6 = round_32(r7_w_5);  /* F55, |x| <= 3.5e-09 */
    const int64_t r7_w_7 = (int64_t)r5_x * A1_x_negated;  /* F85 */
    const int64_t r7_w_8 = (int64_t)r5_y * A1_y_negated;  /* F85 */
    const int64_t r7_w_9 = r7_w_7 + r7_w_8;  /* F85 */
    const int64_t r7_w_10 = (int64_t)r5_z * A1_z_negated;  /* F85 */
    const int64_t r7_w_11 = r7_w_9 + r7_w_10;  /* F85 */
    const int32_t r7_w_12 = round_32(r7_w_11);  /* F53, |x| <= 9.02e-09 */
    const int64_t r7_w_13 = r7_w_12 * INT64_C(2147483648);  /* F84 */
    const int64_t r7_w_14 = (int64_t)r4_x * A2_x_negated;  /* F84 */
    const int64_t r7_w_15 = r7_w_13 + r7_w_14;  /* F84 */
    const int64_t r7_w_16 = (int64_t)r4_y * A2_y_negated;  /* F84 */
    const int64_t r7_w_17 = r7_w_15 + r7_w_16;  /* F84 */
    const int64_t r7_w_18 = (int64_t)r4_z * A2_z_negated;  /* F84 */
    const int64_t r7_w_19 = r7_w_17 + r7_w_18;  /* F84 */
    const int32_t r7_w_20 = round_32(r7_w_19);  /* F52, |x| <= 3.1e-08 */
    const int32_t r7_w_21 = r7_w_20 * 8;  /* F55 */
    const int32_t r7_w_22 = r7_w_6 + r7_w_21;  /* F55, |x| <= 3.45e-08 */
    const int64_t r7_z_1 = (int64_t)r6_w * A0_z;  /* F87 */
    const int64_t r7_z_2 = (int64_t)r6_x * A0_y;  /* F87 */
    const int64_t r7_z_3 = r7_z_1 + r7_z_2;  /* F87 */
    const int64_t r7_z_4 = (int64_t)r6_y * A0_x_negated;  /* F87 */
    const int64_t r7_z_5 = r7_z_3 + r7_z_4;  /* F87 */
    const int32_t r7_z_6 = round_32(r7_z_5);  /* F55, |x| <= 3.5e-09 */
    const int64_t r7_z_7 = (int64_t)r5_w * A1_z;  /* F85 */
    const int64_t r7_z_8 = (int64_t)r5_x * A1_y;  /* F85 */
    const int64_t r7_z_9 = r7_z_7 + r7_z_8;  /* F85 */
    const int64_t r7_z_10 = (int64_t)r5_y * A1_x_negated;  /* F85 */
    const int64_t r7_z_11 = r7_z_9 + r7_z_10;  /* F85 */
    const int32_t r7_z_12 = round_32(r7_z_11);  /* F53, |x| <= 9.02e-09 */
    const int64_t r7_z_13 = r7_z_12 * INT64_C(2147483648);  /* F84 */
    const int64_t r7_z_14 = (int64_t)r4_w * A2_z;  /* F84 */
    const int64_t r7_z_15 = r7_z_13 + r7_z_14;  /* F84 */
    const int64_t r7_z_16 = (int64_t)r4_x * A2_y;  /* F84 */
    const int64_t r7_z_17 = r7_z_15 + r7_z_16;  /* F84 */
    const int64_t r7_z_18 = (int64_t)r4_y * A2_x_negated;  /* F84 */
    const int64_t r7_z_19 = r7_z_17 + r7_z_18;  /* F84 */
    const int32_t r7_z_20 = round_32(r7_z_19);  /* F52, |x| <= 3.17e-08 */
    const int32_t r7_z_21 = r7_z_20 * 8;  /* F55 */
    const int32_t r7_z_22 = r7_z_6 + r7_z_21;  /* F55, |x| <= 3.52e-08 */
    const int64_t r7_w_23 = (int64_t)1227133513 /* 1/7 */ * r7_w_22;  /* F88 */
    const int32_t r7_w = round_32(r7_w_23);  /* F56, |x| <= 1.74e-09 */
    const int64_t r7_x_23 = (int64_t)1227133513 /* 1/7 */ * r7_x_22;  /* F88 */
    const int32_t r7_x = round_32(r7_x_23);  /* F56, |x| <= 1.74e-09 */
    const int64_t r7_y_23 = (int64_t)1227133513 /* 1/7 */ * r7_y_22;  /* F88 */
    const int32_t r7_y = round_32(r7_y_23);  /* F56, |x| <= 1.74e-09 */
    const int64_t r7_z_23 = (int64_t)1227133513 /* 1/7 */ * r7_z_22;  /* F88 */
    const int32_t r7_z = round_32(r7_z_23);  /* F56, |x| <= 1.74e-09 */

    /* r_8 = 1/8 sum_j r_(8-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r8_w_1 = (int64_t)r7_x * A0_x_negated;  /* F91 */
    const int64_t r8_w_2 = (int64_t)r7_y * A0_y_negated;  /* F91 */
    const int64_t r8_w_3 = r8_w_1 + r8_w_2;  /* F94 */
    const int64_t r8_w_4 = (int64_t)r7_z * A0_z_negated;  /* F91 */
    const int64_t r8_w_5 = r8_w_3 + r8_w_4;  /* F94 */
    const int64_t r8_w_6 = (int64_t)r6_x * A1_x_negated;  /* F90 */
    const int64_t r8_w_7 = r8_w_6 * INT64_C(2);  /* F94 */
    const int64_t r8_w_8 = r8_w_5 + r8_w_7;  /* F94 */
    const int64_t r8_w_9 = (int64_t)r6_y * A1_y_negated;  /* F90 */
    const int64_t r8_w_10 = r8_w_9 * INT64_C(2);  /* F94 */
    const int64_t r8_w_11 = r8_w_8 + r8_w_10;  /* F94 */
    const int64_t r8_w_12 = (int64_t)r6_z * A1_z_negated;  /* F90 */
    const int64_t r8_w_13 = r8_w_12 * INT64_C(2);  /* F94 */
    const int64_t r8_w_14 = r8_w_11 + r8_w_13;  /* F94 */
    const int64_t r8_w_15 = (int64_t)r5_x * A2_x_negated;  /* F86 */
    const int64_t r8_w_16 = r8_w_15 * INT64_C(32);  /* F94 */
    const int64_t r8_w_17 = r8_w_14 + r8_w_16;  /* F94 */
    const int64_t r8_w_18 = (int64_t)r5_y * A2_y_negated;  /* F86 */
    const int64_t r8_w_19 = r8_w_18 * INT64_C(32);  /* F94 */
    const int64_t r8_w_20 = r8_w_17 + r8_w_19;  /* F94 */
    const int64_t r8_w_21 = (int64_t)r5_z * A2_z_negated;  /* F86 */
    const int64_t r8_w_22 = r8_w_21 * INT64_C(32);  /* F94 */
    const int64_t r8_w_23 = r8_w_20 + r8_w_22;  /* F94 */
    const int32_t r8_w = round_32(r8_w_23);  /* F62, |x| <= 7.58e-11 */
    const int64_t v_x_part_part_1 = r2_w * INT64_C(4194304);  /* F62 */
    const int64_t v_x_part_part_2 = r3_w * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_part_3 = v_x_part_part_1 + v_x_part_part_2;  /* F62 */
    const int64_t v_x_part_part_4 = r4_w * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_part_5 = v_x_part_part_3 + v_x_part_part_4;  /* F62 */
    const int64_t v_x_part_part_6 = r5_w * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_part_7 = v_x_part_part_5 + v_x_part_part_6;  /* F62 */
    const int64_t v_x_part_part_8 = r6_w * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_part_9 = v_x_part_part_7 + v_x_part_part_8;  /* F62 */
    const int64_t v_x_part_part_10 = r7_w * INT64_C(64);  /* F62 */
    const int64_t v_x_part_part_11 = v_x_part_part_9 + v_x_part_part_10;  /* F62 */
    const int64_t v_x_part_part_12 = v_x_part_part_11 + r8_w;  /* F62 */
    const int32_t v_x_part_part_13 = round_22(v_x_part_part_12);  /* F40, |x| <= 0.00137 */
    const int64_t v_x_part_part_14 = r2_w * INT64_C(4194304);  /* F62 */
    const int64_t v_x_part_part_15 = r4_w * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_part_16 = v_x_part_part_14 + v_x_part_part_15;  /* F62 */
    const int64_t v_x_part_part_17 = r6_w * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_part_18 = v_x_part_part_16 + v_x_part_part_17;  /* F62 */
    const int64_t v_x_part_part_19 = v_x_part_part_18 + r8_w;  /* F62 */
    const int64_t v_x_part_part_20 = r3_w * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_part_21 = r5_w * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_part_22 = v_x_part_part_20 + v_x_part_part_21;  /* F62 */
    const int64_t v_x_part_part_23 = r7_w * INT64_C(64);  /* F62 */
    const int64_t v_x_part_part_24 = v_x_part_part_22 + v_x_part_part_23;  /* F62 */
    const int64_t v_x_part_part_25 = v_x_part_part_19 - v_x_part_part_24;  /* F62 */
    const int32_t v_x_part_part_26 = round_22(v_x_part_part_25);  /* F40, |x| <= 0.00137 */
    const int64_t r8_x_1 = (int64_t)r7_w * A0_x;  /* F91 */
    const int64_t r8_x_2 = (int64_t)r7_y * A0_z;  /* F91 */
    const int64_t r8_x_3 = r8_x_1 + r8_x_2;  /* F94 */
    const int64_t r8_x_4 = (int64_t)r7_z * A0_y_negated;  /* F91 */
    const int64_t r8_x_5 = r8_x_3 + r8_x_4;  /* F94 */
    const int64_t r8_x_6 = (int64_t)r6_w * A1_x;  /* F90 */
    const int64_t r8_x_7 = r8_x_6 * INT64_C(2);  /* F94 */
    const int64_t r8_x_8 = r8_x_5 + r8_x_7;  /* F94 */
    const int64_t r8_x_9 = (int64_t)r6_y * A1_z;  /* F90 */
    const int64_t r8_x_10 = r8_x_9 * INT64_C(2);  /* F94 */
    const int64_t r8_x_11 = r8_x_8 + r8_x_10;  /* F94 */
    const int64_t r8_x_12 = (int64_t)r6_z * A1_y_negated;  /* F90 */
    const int64_t r8_x_13 = r8_x_12 * INT64_C(2);  /* F94 */
    const int64_t r8_x_14 = r8_x_11 + r8_x_13;  /* F94 */
    const int64_t r8_x_15 = (int64_t)r5_w * A2_x;  /* F86 */
    const int64_t r8_x_16 = r8_x_15 * INT64_C(32);  /* F94 */
    const int64_t r8_x_17 = r8_x_14 + r8_x_16;  /* F94 */
    const int64_t r8_x_18 = (int64_t)r5_y * A2_z;  /* F86 */
    const int64_t r8_x_19 = r8_x_18 * INT64_C(32);  /* F94 */
    const int64_t r8_x_20 = r8_x_17 + r8_x_19;  /* F94 */
    const int64_t r8_x_21 = (int64_t)r5_z * A2_y_negated;  /* F86 */
    const int64_t r8_x_22 = r8_x_21 * INT64_C(32);  /* F94 */
    const int64_t r8_x_23 = r8_x_20 + r8_x_22;  /* F94 */
    const int32_t r8_x = round_32(r8_x_23);  /* F62, |x| <= 7.58e-11 */
    const int64_t v_x_part_part_27 = A0_x * INT64_C(134217728);  /* F62 */
    const int64_t v_x_part_part_28 = A1_x * INT64_C(8388608);  /* F62 */
    const int64_t v_x_part_part_29 = v_x_part_part_27 + v_x_part_part_28;  /* F62 */
    const int64_t v_x_part_part_30 = r3_x * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_part_31 = v_x_part_part_29 + v_x_part_part_30;  /* F62 */
    const int64_t v_x_part_part_32 = r4_x * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_part_33 = v_x_part_part_31 + v_x_part_part_32;  /* F62 */
    const int64_t v_x_part_part_34 = r5_x * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_part_35 = v_x_part_part_33 + v_x_part_part_34;  /* F62 */
    const int64_t v_x_part_part_36 = r6_x * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_part_37 = v_x_part_part_35 + v_x_part_part_36;  /* F62 */
    const int64_t v_x_part_part_38 = r7_x * INT64_C(64);  /* F62 */
    const int64_t v_x_part_part_39 = v_x_part_part_37 + v_x_part_part_38;  /* F62 */
    const int64_t v_x_part_part_40 = v_x_part_part_39 + r8_x;  /* F62 */
    const int32_t v_x_part_part_41 = round_26(v_x_part_part_40);  /* F36, |x| <= 0.0304 */
    const int64_t v_x_part_part_42 = A1_x * INT64_C(8388608);  /* F62 */
    const int64_t v_x_part_part_43 = r4_x * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_part_44 = v_x_part_part_42 + v_x_part_part_43;  /* F62 */
    const int64_t v_x_part_part_45 = r6_x * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_part_46 = v_x_part_part_44 + v_x_part_part_45;  /* F62 */
    const int64_t v_x_part_part_47 = v_x_part_part_46 + r8_x;  /* F62 */
    const int64_t v_x_part_part_48 = A0_x * INT64_C(134217728);  /* F62 */
    const int64_t v_x_part_part_49 = r3_x * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_part_50 = v_x_part_part_48 + v_x_part_part_49;  /* F62 */
    const int64_t v_x_part_part_51 = r5_x * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_part_52 = v_x_part_part_50 + v_x_part_part_51;  /* F62 */
    const int64_t v_x_part_part_53 = r7_x * INT64_C(64);  /* F62 */
    const int64_t v_x_part_part_54 = v_x_part_part_52 + v_x_part_part_53;  /* F62 */
    const int64_t v_x_part_part_55 = v_x_part_part_47 - v_x_part_part_54;  /* F62 */
    const int32_t v_x_part_part_56 = round_27(v_x_part_part_55);  /* F35, |x| <= 0.0304 */
    const int64_t r8_y_1 = (int64_t)r7_w * A0_y;  /* F91 */
    const int64_t r8_y_2 = (int64_t)r7_z * A0_x;  /* F91 */
    const int64_t r8_y_3 = r8_y_1 + r8_y_2;  /* F94 */
    const int64_t r8_y_4 = (int64_t)r7_x * A0_z_negated;  /* F91 */
    const int64_t r8_y_5 = r8_y_3 + r8_y_4;  /* F94 */
    const int64_t r8_y_6 = (int64_t)r6_w * A1_y;  /* F90 */
    const int64_t r8_y_7 = r8_y_6 * INT64_C(2);  /* F94 */
    const int64_t r8_y_8 = r8_y_5 + r8_y_7;  /* F94 */
    const int64_t r8_y_9 = (int64_t)r6_z * A1_x;  /* F90 */
    const int64_t r8_y_10 = r8_y_9 * INT64_C(2);  /* F94 */
    const int64_t r8_y_11 = r8_y_8 + r8_y_10;  /* F94 */
    const int64_t r8_y_12 = (int64_t)r6_x * A1_z_negated;  /* F90 */
    const int64_t r8_y_13 = r8_y_12 * INT64_C(2);  /* F94 */
    const int64_t r8_y_14 = r8_y_11 + r8_y_13;  /* F94 */
    const int64_t r8_y_15 = (int64_t)r5_w * A2_y;  /* F86 */
    const int64_t r8_y_16 = r8_y_15 * INT64_C(32);  /* F94 */
    const int64_t r8_y_17 = r8_y_14 + r8_y_16;  /* F94 */
    const int64_t r8_y_18 = (int64_t)r5_z * A2_x;  /* F86 */
    const int64_t r8_y_19 = r8_y_18 * INT64_C(32);  /* F94 */
    const int64_t r8_y_20 = r8_y_17 + r8_y_19;  /* F94 */
    const int64_t r8_y_21 = (int64_t)r5_x * A2_z_negated;  /* F86 */
    const int64_t r8_y_22 = r8_y_21 * INT64_C(32);  /* F94 */
    const int64_t r8_y_23 = r8_y_20 + r8_y_22;  /* F94 */
    const int32_t r8_y = round_32(r8_y_23);  /* F62, |x| <= 7.58e-11 */
    const int64_t v_x_part_1 = A0_y * INT64_C(134217728);  /* F62 */
    const int64_t v_x_part_2 = A1_y * INT64_C(8388608);  /* F62 */
    const int64_t v_x_part_3 = v_x_part_1 + v_x_part_2;  /* F62 */
    const int64_t v_x_part_4 = r3_y * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_5 = v_x_part_3 + v_x_part_4;  /* F62 */
    const int64_t v_x_part_6 = r4_y * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_7 = v_x_part_5 + v_x_part_6;  /* F62 */
    const int64_t v_x_part_8 = r5_y * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_9 = v_x_part_7 + v_x_part_8;  /* F62 */
    const int64_t v_x_part_10 = r6_y * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_11 = v_x_part_9 + v_x_part_10;  /* F62 */
    const int64_t v_x_part_12 = r7_y * INT64_C(64);  /* F62 */
    const int64_t v_x_part_13 = v_x_part_11 + v_x_part_12;  /* F62 */
    const int64_t v_x_part_14 = v_x_part_13 + r8_y;  /* F62 */
    const int32_t v_x_part_15 = round_26(v_x_part_14);  /* F36, |x| <= 0.0304 */
    const int64_t v_x_part_16 = A1_y * INT64_C(8388608);  /* F62 */
    const int64_t v_x_part_17 = r4_y * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_18 = v_x_part_16 + v_x_part_17;  /* F62 */
    const int64_t v_x_part_19 = r6_y * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_20 = v_x_part_18 + v_x_part_19;  /* F62 */
    const int64_t v_x_part_21 = v_x_part_20 + r8_y;  /* F62 */
    const int64_t v_x_part_22 = A0_y * INT64_C(134217728);  /* F62 */
    const int64_t v_x_part_23 = r3_y * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_24 = v_x_part_22 + v_x_part_23;  /* F62 */
    const int64_t v_x_part_25 = r5_y * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_26 = v_x_part_24 + v_x_part_25;  /* F62 */
    const int64_t v_x_part_27 = r7_y * INT64_C(64);  /* F62 */
    const int64_t v_x_part_28 = v_x_part_26 + v_x_part_27;  /* F62 */
    const int64_t v_x_part_29 = v_x_part_21 - v_x_part_28;  /* F62 */
    const int32_t v_x_part_30 = round_27(v_x_part_29);  /* F35, |x| <= 0.0304 */
    const int64_t r8_z_1 = (int64_t)r7_w * A0_z;  /* F91 */
    const int64_t r8_z_2 = (int64_t)r7_x * A0_y;  /* F91 */
    const int64_t r8_z_3 = r8_z_1 + r8_z_2;  /* F94 */
    const int64_t r8_z_4 = (int64_t)r7_y * A0_x_negated;  /* F91 */
    const int64_t r8_z_5 = r8_z_3 + r8_z_4;  /* F94 */
    const int64_t r8_z_6 = (int64_t)r6_w * A1_z;  /* F90 */
    const int64_t r8_z_7 = r8_z_6 * INT64_C(2);  /* F94 */
    const int64_t r8_z_8 = r8_z_5 + r8_z_7;  /* F94 */
    const int64_t r8_z_9 = (int64_t)r6_x * A1_y;  /* F90 */
    const int64_t r8_z_10 = r8_z_9 * INT64_C(2);  /* F94 */
    const int64_t r8_z_11 = r8_z_8 + r8_z_10;  /* F94 */
    const int64_t r8_z_12 = (int64_t)r6_y * A1_x_negated;  /* F90 */
    const int64_t r8_z_13 = r8_z_12 * INT64_C(2);  /* F94 */
    const int64_t r8_z_14 = r8_z_11 + r8_z_13;  /* F94 */
    const int64_t r8_z_15 = (int64_t)r5_w * A2_z;  /* F86 */
    const int64_t r8_z_16 = r8_z_15 * INT64_C(32);  /* F94 */
    const int64_t r8_z_17 = r8_z_14 + r8_z_16;  /* F94 */
    const int64_t r8_z_18 = (int64_t)r5_x * A2_y;  /* F86 */
    const int64_t r8_z_19 = r8_z_18 * INT64_C(32);  /* F94 */
    const int64_t r8_z_20 = r8_z_17 + r8_z_19;  /* F94 */
    const int64_t r8_z_21 = (int64_t)r5_y * A2_x_negated;  /* F86 */
    const int64_t r8_z_22 = r8_z_21 * INT64_C(32);  /* F94 */
    const int64_t r8_z_23 = r8_z_20 + r8_z_22;  /* F94 */
    const int32_t r8_z = round_32(r8_z_23);  /* F62, |x| <= 7.58e-11 */
    const int64_t v_x_part_31 = A0_z * INT64_C(134217728);  /* F62 */
    const int64_t v_x_part_32 = A1_z * INT64_C(8388608);  /* F62 */
    const int64_t v_x_part_33 = v_x_part_31 + v_x_part_32;  /* F62 */
    const int64_t v_x_part_34 = r3_z * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_35 = v_x_part_33 + v_x_part_34;  /* F62 */
    const int64_t v_x_part_36 = r4_z * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_37 = v_x_part_35 + v_x_part_36;  /* F62 */
    const int64_t v_x_part_38 = r5_z * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_39 = v_x_part_37 + v_x_part_38;  /* F62 */
    const int64_t v_x_part_40 = r6_z * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_41 = v_x_part_39 + v_x_part_40;  /* F62 */
    const int64_t v_x_part_42 = r7_z * INT64_C(64);  /* F62 */
    const int64_t v_x_part_43 = v_x_part_41 + v_x_part_42;  /* F62 */
    const int64_t v_x_part_44 = v_x_part_43 + r8_z;  /* F62 */
    const int32_t v_x_part_45 = round_26(v_x_part_44);  /* F36, |x| <= 0.0304 */
    const int64_t v_x_part_46 = A1_z * INT64_C(8388608);  /* F62 */
    const int64_t v_x_part_47 = r4_z * INT64_C(131072);  /* F62 */
    const int64_t v_x_part_48 = v_x_part_46 + v_x_part_47;  /* F62 */
    const int64_t v_x_part_49 = r6_z * INT64_C(1024);  /* F62 */
    const int64_t v_x_part_50 = v_x_part_48 + v_x_part_49;  /* F62 */
    const int64_t v_x_part_51 = v_x_part_50 + r8_z;  /* F62 */
    const int64_t v_x_part_52 = A0_z * INT64_C(134217728);  /* F62 */
    const int64_t v_x_part_53 = r3_z * INT64_C(2097152);  /* F62 */
    const int64_t v_x_part_54 = v_x_part_52 + v_x_part_53;  /* F62 */
    const int64_t v_x_part_55 = r5_z * INT64_C(32768);  /* F62 */
    const int64_t v_x_part_56 = v_x_part_54 + v_x_part_55;  /* F62 */
    const int64_t v_x_part_57 = r7_z * INT64_C(64);  /* F62 */
    const int64_t v_x_part_58 = v_x_part_56 + v_x_part_57;  /* F62 */
    const int64_t v_x_part_59 = v_x_part_51 - v_x_part_58;  /* F62 */
    const int32_t v_x_part_60 = round_27(v_x_part_59);  /* F35, |x| <= 0.0304 */

    /* v, the rounding of the last update added, that of this one kept */
    const int32_t v_x_part_part_57 = -v_x_part_part_13;  /* F40 */
    const int64_t v_x_part_part_58 = (int64_t)v_x_part_part_26 * v_x_part_part_41;  /* F76 */
    const int64_t v_x_part_part_59 = (int64_t)v_x_part_part_56 * v_x_part_part_57;  /* F75 */
    const int64_t v_x_part_part_60 = v_x_part_part_59 * INT64_C(2);  /* F76 */
    const int64_t v_x_part_part_61 = v_x_part_part_58 + v_x_part_part_60;  /* F76 */
    const int32_t v_x_part_part = round_32(v_x_part_part_61);  /* F44, |x| <= 8.31e-05 */
    const int64_t v_x_part_61 = v_x_part_part * INT64_C(134217728);  /* F71 */
    const int64_t v_x_part_62 = (int64_t)v_x_part_60 * v_x_part_15;  /* F71 */
    const int64_t v_x_part_63 = v_x_part_61 + v_x_part_62;  /* F71 */
    const int64_t v_x_part_64 = (int64_t)v_x_part_30 * v_x_part_45;  /* F71 */
    const int64_t v_x_part_65 = v_x_part_63 - v_x_part_64;  /* F71 */
    const int32_t v_x_part = round_31(v_x_part_65);  /* F40, |x| <= 0.00193 */
    const int64_t v_x_whole_1 = v_x_part_part_41 * INT64_C(16);  /* F40 */
    const int64_t v_x_whole_2 = v_x_whole_1 + v_x_part;  /* F40 */
    const int64_t v_x_whole_3 = v_x_part_part_56 * INT64_C(32);  /* F40 */
    const int64_t v_x_whole_4 = v_x_whole_2 - v_x_whole_3;  /* F40 */
    const int32_t v_x_carried = state->residual[0];  /* F40 */
    const int64_t v_x_whole = v_x_whole_4 + v_x_carried;  /* F40 */
    const int32_t v_x = round_6(v_x_whole);  /* F34, |x| <= 0.0627 */
    const int32_t v_x_left = left_of_6(v_x_whole, v_x);  /* F40 */
    state->residual[0] = v_x_left;
    const int64_t v_y_part_part_1 = (int64_t)v_x_part_part_26 * v_x_part_15;  /* F76 */
    const int64_t v_y_part_part_2 = (int64_t)v_x_part_30 * v_x_part_part_57;  /* F75 */
    const int64_t v_y_part_part_3 = v_y_part_part_2 * INT64_C(2);  /* F76 */
    const int64_t v_y_part_part_4 = v_y_part_part_1 + v_y_part_part_3;  /* F76 */
    const int32_t v_y_part_part = round_32(v_y_part_part_4);  /* F44, |x| <= 8.31e-05 */
    const int64_t v_y_part_1 = v_y_part_part * INT64_C(134217728);  /* F71 */
    const int64_t v_y_part_2 = (int64_t)v_x_part_part_56 * v_x_part_45;  /* F71 */
    const int64_t v_y_part_3 = v_y_part_1 + v_y_part_2;  /* F71 */
    const int64_t v_y_part_4 = (int64_t)v_x_part_60 * v_x_part_part_41;  /* F71 */
    const int64_t v_y_part_5 = v_y_part_3 - v_y_part_4;  /* F71 */
    const int32_t v_y_part = round_31(v_y_part_5);  /* F40, |x| <= 0.00193 */
    const int64_t v_y_whole_1 = v_x_part_15 * INT64_C(16);  /* F40 */
    const int64_t v_y_whole_2 = v_y_whole_1 + v_y_part;  /* F40 */
    const int64_t v_y_whole_3 = v_x_part_30 * INT64_C(32);  /* F40 */
    const int64_t v_y_whole_4 = v_y_whole_2 - v_y_whole_3;  /* F40 */
    const int32_t v_y_carried = state->residual[1];  /* F40 */
    const int64_t v_y_whole = v_y_whole_4 + v_y_carried;  /* F40 */
    const int32_t v_y = round_6(v_y_whole);  /* F34, |x| <= 0.0627 */
    const int32_t v_y_left = left_of_6(v_y_whole, v_y);  /* F40 */
    state->residual[1] = v_y_left;
    const int64_t v_z_part_part_1 = (int64_t)v_x_part_part_26 * v_x_part_45;  /* F76 */
    const int64_t v_z_part_part_2 = (int64_t)v_x_part_60 * v_x_part_part_57;  /* F75 */
    const int64_t v_z_part_part_3 = v_z_part_part_2 * INT64_C(2);  /* F76 */
    const int64_t v_z_part_part_4 = v_z_part_part_1 + v_z_part_part_3;  /* F76 */
    const int32_t v_z_part_part = round_32(v_z_part_part_4);  /* F44, |x| <= 8.31e-05 */
    const int64_t v_z_part_1 = v_z_part_part * INT64_C(134217728);  /* F71 */
    const int64_t v_z_part_2 = (int64_t)v_x_part_30 * v_x_part_part_41;  /* F71 */
    const int64_t v_z_part_3 = v_z_part_1 + v_z_part_2;  /* F71 */
    const int64_t v_z_part_4 = (int64_t)v_x_part_part_56 * v_x_part_15;  /* F71 */
    const int64_t v_z_part_5 = v_z_part_3 - v_z_part_4;  /* F71 */
    const int32_t v_z_part = round_31(v_z_part_5);  /* F40, |x| <= 0.00193 */
    const int64_t v_z_whole_1 = v_x_part_45 * INT64_C(16);  /* F40 */
    const int64_t v_z_whole_2 = v_z_whole_1 + v_z_part;  /* F40 */
    const int64_t v_z_whole_3 = v_x_part_60 * INT64_C(32);  /* F40 */
    const int64_t v_z_whole_4 = v_z_whole_2 - v_z_whole_3;  /* F40 */
    const int32_t v_z_carried = state->residual[2];  /* F40 */
    const int64_t v_z_whole = v_z_whole_4 + v_z_carried;  /* F40 */
    const int32_t v_z = round_6(v_z_whole);  /* F34, |x| <= 0.0627 */
    const int32_t v_z_left = left_of_6(v_z_whole, v_z);  /* F40 */
    state->residual[2] = v_z_left;

    /* u = scalar part of r - 1   [r = (E - O)* (x) (E + O)] */
    const int64_t u_part_part_1 = (int64_t)v_x_part_part_26 * v_x_part_part_13;  /* F80 */
    const int32_t u_part_part = round_32(u_part_part_1);  /* F48, |x| <= 1.88e-06 */
    const int64_t u_part_part_2_1 = (int64_t)v_x_part_part_56 * v_x_part_part_41;  /* F71 */
    const int64_t u_part_part_2_2 = (int64_t)v_x_part_30 * v_x_part_15;  /* F71 */
    const int64_t u_part_part_2_3 = u_part_part_2_1 + u_part_part_2_2;  /* F71 */
    const int64_t u_part_part_2_4 = (int64_t)v_x_part_60 * v_x_part_45;  /* F71 */
    const int64_t u_part_part_2_5 = u_part_part_2_3 + u_part_part_2_4;  /* F71 */
    const int32_t u_part_part_2 = round_32(u_part_part_2_5);  /* F39, |x| <= 0.00277 */
    const int32_t u_part_fine = round_short_9(u_part_part);  /* F39 */
    const int32_t u_part = u_part_fine + u_part_part_2;  /* F39, |x| <= 0.00277 */
    const int64_t u_1 = (int64_t)v_x_part_part_26 + v_x_part_part_13;  /* F40 */
    const int64_t u_2 = u_part * INT64_C(2);  /* F40 */
    const int64_t u_3 = u_1 + u_2;  /* F40 */
    const int32_t u = round_2(u_3);  /* F38, |x| <= 0.00551 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(8388608);  /* F61 */
    const int64_t a_2 = a_1 + INT64_C(1152921504606846976) /* 1/2 */;  /* F61 */

    /* attitude and input */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.02 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.02 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.02 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.02 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.02 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.02 */

    /* a = u + e */
    const int64_t a_3 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t a_4 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t a_5 = a_3 + a_4;  /* F61 */
    const int64_t a_6 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t a_7 = a_5 + a_6;  /* F61 */
    const int64_t a_8 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t a_9 = a_7 + a_8;  /* F61 */
    const int64_t a_10 = a_2 - a_9;  /* F61 */
    const int32_t a = round_25(a_10);  /* F36, |x| <= 0.0213 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t v_x_negated = -v_x;  /* F34 */
    const int32_t v_y_negated = -v_y;  /* F34 */
    const int32_t v_z_negated = -v_z;  /* F34 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F66 */
    const int64_t dq_w_2 = (int64_t)q_x * v_x_negated;  /* F64 */
    const int64_t dq_w_3 = dq_w_2 * INT64_C(4);  /* F66 */
    const int64_t dq_w_4 = dq_w_1 + dq_w_3;  /* F66 */
    const int64_t dq_w_5 = (int64_t)q_y * v_y_negated;  /* F64 */
    const int64_t dq_w_6 = dq_w_5 * INT64_C(4);  /* F66 */
    const int64_t dq_w_7 = dq_w_4 + dq_w_6;  /* F66 */
    const int64_t dq_w_8 = (int64_t)q_z * v_z_negated;  /* F64 */
    const int64_t dq_w_9 = dq_w_8 * INT64_C(4);  /* F66 */
    const int64_t dq_w_10 = dq_w_7 + dq_w_9;  /* F66 */
    const int64_t dq_w = round_wide_4(dq_w_10);  /* F62, |x| <= 0.113 */

    /* q_next = q + dq */
    const int64_t q_next_w = q_w_whole + dq_w;  /* F62, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F64 */
    const int64_t dq_x_2 = dq_x_1 * INT64_C(4);  /* F66 */
    const int64_t dq_x_3 = (int64_t)q_x * a;  /* F66 */
    const int64_t dq_x_4 = dq_x_2 + dq_x_3;  /* F66 */
    const int64_t dq_x_5 = (int64_t)q_y * v_z;  /* F64 */
    const int64_t dq_x_6 = dq_x_5 * INT64_C(4);  /* F66 */
    const int64_t dq_x_7 = dq_x_4 + dq_x_6;  /* F66 */
    const int64_t dq_x_8 = (int64_t)q_z * v_y_negated;  /* F64 */
    const int64_t dq_x_9 = dq_x_8 * INT64_C(4);  /* F66 */
    const int64_t dq_x_10 = dq_x_7 + dq_x_9;  /* F66 */
    const int64_t dq_x = round_wide_4(dq_x_10);  /* F62, |x| <= 0.113 */

    /* q_next = q + dq */
    const int64_t q_next_x = q_x_whole + dq_x;  /* F62, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F64 */
    const int64_t dq_y_2 = dq_y_1 * INT64_C(4);  /* F66 */
    const int64_t dq_y_3 = (int64_t)q_y * a;  /* F66 */
    const int64_t dq_y_4 = dq_y_2 + dq_y_3;  /* F66 */
    const int64_t dq_y_5 = (int64_t)q_z * v_x;  /* F64 */
    const int64_t dq_y_6 = dq_y_5 * INT64_C(4);  /* F66 */
    const int64_t dq_y_7 = dq_y_4 + dq_y_6;  /* F66 */
    const int64_t dq_y_8 = (int64_t)q_x * v_z_negated;  /* F64 */
    const int64_t dq_y_9 = dq_y_8 * INT64_C(4);  /* F66 */
    const int64_t dq_y_10 = dq_y_7 + dq_y_9;  /* F66 */
    const int64_t dq_y = round_wide_4(dq_y_10);  /* F62, |x| <= 0.113 */

    /* q_next = q + dq */
    const int64_t q_next_y = q_y_whole + dq_y;  /* F62, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F64 */
    const int64_t dq_z_2 = dq_z_1 * INT64_C(4);  /* F66 */
    const int64_t dq_z_3 = (int64_t)q_z * a;  /* F66 */
    const int64_t dq_z_4 = dq_z_2 + dq_z_3;  /* F66 */
    const int64_t dq_z_5 = (int64_t)q_x * v_y;  /* F64 */
    const int64_t dq_z_6 = dq_z_5 * INT64_C(4);  /* F66 */
    const int64_t dq_z_7 = dq_z_4 + dq_z_6;  /* F66 */
    const int64_t dq_z_8 = (int64_t)q_y * v_x_negated;  /* F64 */
    const int64_t dq_z_9 = dq_z_8 * INT64_C(4);  /* F66 */
    const int64_t dq_z_10 = dq_z_7 + dq_z_9;  /* F66 */
    const int64_t dq_z = round_wide_4(dq_z_10);  /* F62, |x| <= 0.113 */

    /* q_next = q + dq */
    const int64_t q_next_z = q_z_whole + dq_z;  /* F62, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void quaternion_taylor_3_8_midpoint_fixed32_compensated_quaternion(
    const quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state, int32_t q_nb[4])
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
