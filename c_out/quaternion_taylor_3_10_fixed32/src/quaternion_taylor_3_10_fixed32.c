/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_10_fixed32
 *
 * qcone 0.1.0, design quaternion_taylor_3_10_fixed32, SHA-256 of the design
 * 76889369dae871dc1816f80008251c1dba4fc00971b9902bfdf2aefabc20a84e
 *
 * algorithm:   quaternion-taylor-3-10-start, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
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
 * rounding:    one update is within 1.4e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  61 of 92 rounded sums of products drop a whole word, 26 before formats were
 *              searched for that; of one update's errors in the first order it made 2.6e-09 of
 *              2.6e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      448       0  261       196       0       0     0     0     0       0      0
 * update shared          332      16  203       157       0       0     0     0     0       0      0
 * update emitted         320       0  291        14      13       0     0     0     0       0    272
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "quaternion_taylor_3_10_fixed32.h"

#if QUATERNION_TAYLOR_3_10_FIXED32_VERSION != 1
#error "quaternion_taylor_3_10_fixed32.h is of another version than this file: generate both again"
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

/* x / 2^24, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_24(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(8388608)) >> 24);
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

/* x / 2^35, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_35(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(17179869184), 35);
}

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

void quaternion_taylor_3_10_fixed32_init(quaternion_taylor_3_10_fixed32_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
}

void quaternion_taylor_3_10_fixed32_set_quaternion(
    quaternion_taylor_3_10_fixed32_state *state, const int32_t q_nb[4])
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

void quaternion_taylor_3_10_fixed32_update(
    quaternion_taylor_3_10_fixed32_state *state, const int32_t dtheta[9])
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
    const int64_t A0_x_4 = (int64_t)3 /* 3/2 */ * dtheta1_x;  /* F35 */
    const int64_t A0_x_5 = A0_x_4 * INT64_C(2);  /* F36 */
    const int64_t A0_x_6 = A0_x_3 * INT64_C(2);  /* F36 */
    const int64_t A0_x_7 = A0_x_5 + A0_x_6;  /* F36 */
    const int64_t A0_x_8 = (int64_t)3 /* 3/4 */ * A0_x_1;  /* F36 */
    const int64_t A0_x_9 = A0_x_7 - A0_x_8;  /* F36 */
    const int32_t A0_x = round_2(A0_x_9);  /* F34, |x| <= 0.0533 */
    const int64_t A0_y_4 = (int64_t)3 /* 3/2 */ * dtheta1_y;  /* F35 */
    const int64_t A0_y_5 = A0_y_4 * INT64_C(2);  /* F36 */
    const int64_t A0_y_6 = A0_y_3 * INT64_C(2);  /* F36 */
    const int64_t A0_y_7 = A0_y_5 + A0_y_6;  /* F36 */
    const int64_t A0_y_8 = (int64_t)3 /* 3/4 */ * A0_y_1;  /* F36 */
    const int64_t A0_y_9 = A0_y_7 - A0_y_8;  /* F36 */
    const int32_t A0_y = round_2(A0_y_9);  /* F34, |x| <= 0.0533 */
    const int64_t A0_z_4 = (int64_t)3 /* 3/2 */ * dtheta1_z;  /* F35 */
    const int64_t A0_z_5 = A0_z_4 * INT64_C(2);  /* F36 */
    const int64_t A0_z_6 = A0_z_3 * INT64_C(2);  /* F36 */
    const int64_t A0_z_7 = A0_z_5 + A0_z_6;  /* F36 */
    const int64_t A0_z_8 = (int64_t)3 /* 3/4 */ * A0_z_1;  /* F36 */
    const int64_t A0_z_9 = A0_z_7 - A0_z_8;  /* F36 */
    const int32_t A0_z = round_2(A0_z_9);  /* F34, |x| <= 0.0533 */
    const int64_t A1_x_1 = (int64_t)9 /* 9/2 */ * A0_x_1;  /* F35 */
    const int64_t A1_x_2 = (int64_t)9 /* 9/2 */ * A0_x_3;  /* F35 */
    const int64_t A1_x_3 = A1_x_1 - A1_x_2;  /* F35 */
    const int32_t A1_x = (int32_t)A1_x_3;  /* F35, |x| <= 0.0204 */
    const int64_t A1_y_1 = (int64_t)9 /* 9/2 */ * A0_y_1;  /* F35 */
    const int64_t A1_y_2 = (int64_t)9 /* 9/2 */ * A0_y_3;  /* F35 */
    const int64_t A1_y_3 = A1_y_1 - A1_y_2;  /* F35 */
    const int32_t A1_y = (int32_t)A1_y_3;  /* F35, |x| <= 0.0204 */
    const int64_t A1_z_1 = (int64_t)9 /* 9/2 */ * A0_z_1;  /* F35 */
    const int64_t A1_z_2 = (int64_t)9 /* 9/2 */ * A0_z_3;  /* F35 */
    const int64_t A1_z_3 = A1_z_1 - A1_z_2;  /* F35 */
    const int32_t A1_z = (int32_t)A1_z_3;  /* F35, |x| <= 0.0204 */
    const int64_t A2_x_1 = (int64_t)27 /* 27/4 */ * A0_x_3;  /* F36 */
    const int32_t A2_x = (int32_t)A2_x_1;  /* F36, |x| <= 0.00437 */
    const int64_t A2_y_1 = (int64_t)27 /* 27/4 */ * A0_y_3;  /* F36 */
    const int32_t A2_y = (int32_t)A2_y_1;  /* F36, |x| <= 0.00437 */
    const int64_t A2_z_1 = (int64_t)27 /* 27/4 */ * A0_z_3;  /* F36 */
    const int32_t A2_z = (int32_t)A2_z_1;  /* F36, |x| <= 0.00437 */

    /* r_2 = 1/2 sum_j r_(2-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r2_w_1 = (int64_t)A0_x * A0_x;  /* F68 */
    const int64_t r2_w_2 = (int64_t)A0_y * A0_y;  /* F68 */
    const int64_t r2_w_3 = r2_w_1 + r2_w_2;  /* F69 */
    const int64_t r2_w_4 = (int64_t)A0_z * A0_z;  /* F68 */
    const int64_t r2_w_5 = r2_w_3 + r2_w_4;  /* F69 */
    const int64_t r2_w_6 = -r2_w_5;  /* F69 */
    const int32_t r2_w = round_32(r2_w_6);  /* F37, |x| <= 0.00426 */

    /* r_3 = 1/3 sum_j r_(3-1-j) (x) A_j   [xu2019 (7)] */
    const int32_t A0_x_negated = -A0_x;  /* F34 */
    const int32_t A0_y_negated = -A0_y;  /* F34 */
    const int32_t A0_z_negated = -A0_z;  /* F34 */
    const int64_t r3_w_1 = (int64_t)A1_x * A0_x_negated;  /* F69 */
    const int64_t r3_w_2 = (int64_t)A1_y * A0_y_negated;  /* F69 */
    const int64_t r3_w_3 = r3_w_1 + r3_w_2;  /* F70 */
    const int64_t r3_w_4 = (int64_t)A1_z * A0_z_negated;  /* F69 */
    const int64_t r3_w_5 = r3_w_3 + r3_w_4;  /* F70 */
    const int64_t r3_w_6 = (int64_t)A0_x_negated * A1_x;  /* F69 */
    const int64_t r3_w_7 = r3_w_6 * INT64_C(2);  /* F70 */
    const int64_t r3_w_8 = r3_w_5 + r3_w_7;  /* F70 */
    const int64_t r3_w_9 = (int64_t)A0_y_negated * A1_y;  /* F69 */
    const int64_t r3_w_10 = r3_w_9 * INT64_C(2);  /* F70 */
    const int64_t r3_w_11 = r3_w_8 + r3_w_10;  /* F70 */
    const int64_t r3_w_12 = (int64_t)A0_z_negated * A1_z;  /* F69 */
    const int64_t r3_w_13 = r3_w_12 * INT64_C(2);  /* F70 */
    const int64_t r3_w_14 = r3_w_11 + r3_w_13;  /* F70 */
    const int32_t r3_w_15 = round_32(r3_w_14);  /* F38, |x| <= 0.00488 */
    const int64_t r3_x_1 = (int64_t)r2_w * A0_x;  /* F71 */
    const int64_t r3_x_2 = (int64_t)A1_y * A0_z_negated;  /* F69 */
    const int64_t r3_x_3 = r3_x_2 * INT64_C(2);  /* F71 */
    const int64_t r3_x_4 = r3_x_1 + r3_x_3;  /* F71 */
    const int64_t r3_x_5 = (int64_t)A1_z * A0_y;  /* F69 */
    const int64_t r3_x_6 = r3_x_5 * INT64_C(2);  /* F71 */
    const int64_t r3_x_7 = r3_x_4 + r3_x_6;  /* F71 */
    const int32_t r3_x_8 = round_33(r3_x_7);  /* F38, |x| <= 0.00132 */
    const int32_t r3_x_9 = A2_x * 4;  /* F38 */
    const int32_t r3_x_10 = r3_x_8 + r3_x_9;  /* F38, |x| <= 0.00568 */
    const int64_t r3_y_1 = (int64_t)r2_w * A0_y;  /* F71 */
    const int64_t r3_y_2 = (int64_t)A1_z * A0_x_negated;  /* F69 */
    const int64_t r3_y_3 = r3_y_2 * INT64_C(2);  /* F71 */
    const int64_t r3_y_4 = r3_y_1 + r3_y_3;  /* F71 */
    const int64_t r3_y_5 = (int64_t)A1_x * A0_z;  /* F69 */
    const int64_t r3_y_6 = r3_y_5 * INT64_C(2);  /* F71 */
    const int64_t r3_y_7 = r3_y_4 + r3_y_6;  /* F71 */
    const int32_t r3_y_8 = round_33(r3_y_7);  /* F38, |x| <= 0.00132 */
    const int32_t r3_y_9 = A2_y * 4;  /* F38 */
    const int32_t r3_y_10 = r3_y_8 + r3_y_9;  /* F38, |x| <= 0.00568 */
    const int64_t r3_z_1 = (int64_t)r2_w * A0_z;  /* F71 */
    const int64_t r3_z_2 = (int64_t)A1_x * A0_y_negated;  /* F69 */
    const int64_t r3_z_3 = r3_z_2 * INT64_C(2);  /* F71 */
    const int64_t r3_z_4 = r3_z_1 + r3_z_3;  /* F71 */
    const int64_t r3_z_5 = (int64_t)A1_y * A0_x;  /* F69 */
    const int64_t r3_z_6 = r3_z_5 * INT64_C(2);  /* F71 */
    const int64_t r3_z_7 = r3_z_4 + r3_z_6;  /* F71 */
    const int32_t r3_z_8 = round_33(r3_z_7);  /* F38, |x| <= 0.00132 */
    const int32_t r3_z_9 = A2_z * 4;  /* F38 */
    const int32_t r3_z_10 = r3_z_8 + r3_z_9;  /* F38, |x| <= 0.00568 */
    const int64_t r3_w_16 = (int64_t)1431655765 /* 1/3 */ * r3_w_15;  /* F70 */
    const int32_t r3_w = round_32(r3_w_16);  /* F38, |x| <= 0.00163 */
    const int64_t r3_x_11 = (int64_t)1431655765 /* 1/3 */ * r3_x_10;  /* F70 */
    const int32_t r3_x = round_32(r3_x_11);  /* F38, |x| <= 0.0019 */
    const int64_t r3_y_11 = (int64_t)1431655765 /* 1/3 */ * r3_y_10;  /* F70 */
    const int32_t r3_y = round_32(r3_y_11);  /* F38, |x| <= 0.0019 */
    const int64_t r3_z_11 = (int64_t)1431655765 /* 1/3 */ * r3_z_10;  /* F70 */
    const int32_t r3_z = round_32(r3_z_11);  /* F38, |x| <= 0.0019 */

    /* r_4 = 1/4 sum_j r_(4-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r4_w_part_1 = (int64_t)r3_x * A0_x_negated;  /* F72 */
    const int64_t r4_w_part_2 = (int64_t)r3_y * A0_y_negated;  /* F72 */
    const int64_t r4_w_part_3 = r4_w_part_1 + r4_w_part_2;  /* F74 */
    const int64_t r4_w_part_4 = (int64_t)r3_z * A0_z_negated;  /* F72 */
    const int64_t r4_w_part_5 = r4_w_part_3 + r4_w_part_4;  /* F74 */
    const int32_t r4_w_part = round_32(r4_w_part_5);  /* F42, |x| <= 7.56e-05 */
    const int64_t r4_w_1 = r4_w_part * INT64_C(2147483648);  /* F73 */
    const int64_t r4_w_2 = (int64_t)A0_x_negated * A2_x;  /* F70 */
    const int64_t r4_w_3 = r4_w_2 * INT64_C(2);  /* F73 */
    const int64_t r4_w_4 = r4_w_1 + r4_w_3;  /* F73 */
    const int64_t r4_w_5 = (int64_t)A0_y_negated * A2_y;  /* F70 */
    const int64_t r4_w_6 = r4_w_5 * INT64_C(2);  /* F73 */
    const int64_t r4_w_7 = r4_w_4 + r4_w_6;  /* F73 */
    const int64_t r4_w_8 = (int64_t)A0_z_negated * A2_z;  /* F70 */
    const int64_t r4_w_9 = r4_w_8 * INT64_C(2);  /* F73 */
    const int64_t r4_w_10 = r4_w_7 + r4_w_9;  /* F73 */
    const int64_t r4_w_11 = (int64_t)A1_x * A1_x;  /* F70 */
    const int64_t r4_w_12 = (int64_t)A1_y * A1_y;  /* F70 */
    const int64_t r4_w_13 = r4_w_11 + r4_w_12;  /* F73 */
    const int64_t r4_w_14 = (int64_t)A1_z * A1_z;  /* F70 */
    const int64_t r4_w_15 = r4_w_13 + r4_w_14;  /* F73 */
    const int64_t r4_w_16 = r4_w_10 - r4_w_15;  /* F73 */
    const int32_t r4_w = round_32(r4_w_16);  /* F41, |x| <= 0.000406 */
    const int64_t r4_x_1 = (int64_t)r3_w * A0_x;  /* F72 */
    const int64_t r4_x_2 = (int64_t)r3_y * A0_z;  /* F72 */
    const int64_t r4_x_3 = r4_x_1 + r4_x_2;  /* F74 */
    const int64_t r4_x_4 = (int64_t)r3_z * A0_y_negated;  /* F72 */
    const int64_t r4_x_5 = r4_x_3 + r4_x_4;  /* F74 */
    const int64_t r4_x_6 = (int64_t)r2_w * A1_x;  /* F72 */
    const int64_t r4_x_7 = r4_x_5 + r4_x_6;  /* F74 */
    const int64_t r4_x_8 = (int64_t)A0_y * A2_z;  /* F70 */
    const int64_t r4_x_9 = r4_x_8 * INT64_C(4);  /* F74 */
    const int64_t r4_x_10 = r4_x_7 + r4_x_9;  /* F74 */
    const int64_t r4_x_11 = (int64_t)A0_z_negated * A2_y;  /* F70 */
    const int64_t r4_x_12 = r4_x_11 * INT64_C(4);  /* F74 */
    const int64_t r4_x_13 = r4_x_10 + r4_x_12;  /* F74 */
    const int32_t r4_x = round_32(r4_x_13);  /* F42, |x| <= 0.00021 */
    const int64_t r4_y_1 = (int64_t)r3_w * A0_y;  /* F72 */
    const int64_t r4_y_2 = (int64_t)r3_z * A0_x;  /* F72 */
    const int64_t r4_y_3 = r4_y_1 + r4_y_2;  /* F74 */
    const int64_t r4_y_4 = (int64_t)r3_x * A0_z_negated;  /* F72 */
    const int64_t r4_y_5 = r4_y_3 + r4_y_4;  /* F74 */
    const int64_t r4_y_6 = (int64_t)r2_w * A1_y;  /* F72 */
    const int64_t r4_y_7 = r4_y_5 + r4_y_6;  /* F74 */
    const int64_t r4_y_8 = (int64_t)A0_z * A2_x;  /* F70 */
    const int64_t r4_y_9 = r4_y_8 * INT64_C(4);  /* F74 */
    const int64_t r4_y_10 = r4_y_7 + r4_y_9;  /* F74 */
    const int64_t r4_y_11 = (int64_t)A0_x_negated * A2_z;  /* F70 */
    const int64_t r4_y_12 = r4_y_11 * INT64_C(4);  /* F74 */
    const int64_t r4_y_13 = r4_y_10 + r4_y_12;  /* F74 */
    const int32_t r4_y = round_32(r4_y_13);  /* F42, |x| <= 0.00021 */
    const int64_t r4_z_1 = (int64_t)r3_w * A0_z;  /* F72 */
    const int64_t r4_z_2 = (int64_t)r3_x * A0_y;  /* F72 */
    const int64_t r4_z_3 = r4_z_1 + r4_z_2;  /* F74 */
    const int64_t r4_z_4 = (int64_t)r3_y * A0_x_negated;  /* F72 */
    const int64_t r4_z_5 = r4_z_3 + r4_z_4;  /* F74 */
    const int64_t r4_z_6 = (int64_t)r2_w * A1_z;  /* F72 */
    const int64_t r4_z_7 = r4_z_5 + r4_z_6;  /* F74 */
    const int64_t r4_z_8 = (int64_t)A0_x * A2_y;  /* F70 */
    const int64_t r4_z_9 = r4_z_8 * INT64_C(4);  /* F74 */
    const int64_t r4_z_10 = r4_z_7 + r4_z_9;  /* F74 */
    const int64_t r4_z_11 = (int64_t)A0_y_negated * A2_x;  /* F70 */
    const int64_t r4_z_12 = r4_z_11 * INT64_C(4);  /* F74 */
    const int64_t r4_z_13 = r4_z_10 + r4_z_12;  /* F74 */
    const int32_t r4_z = round_32(r4_z_13);  /* F42, |x| <= 0.00021 */

    /* r_5 = 1/5 sum_j r_(5-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r5_x_1 = (int64_t)r4_y * A0_z;  /* F76 */
    const int64_t r5_x_2 = (int64_t)r4_z * A0_y_negated;  /* F76 */
    const int64_t r5_x_3 = r5_x_1 + r5_x_2;  /* F76 */
    const int32_t r5_x_4 = round_34(r5_x_3);  /* F42, |x| <= 2.24e-05 */
    const int32_t A1_y_negated = -A1_y;  /* F35 */
    const int32_t A1_z_negated = -A1_z;  /* F35 */
    const int64_t r5_x_5 = (int64_t)r4_w * A0_x;  /* F75 */
    const int64_t r5_x_6 = (int64_t)r3_w * A1_x;  /* F73 */
    const int64_t r5_x_7 = r5_x_6 * INT64_C(4);  /* F75 */
    const int64_t r5_x_8 = r5_x_5 + r5_x_7;  /* F75 */
    const int64_t r5_x_9 = (int64_t)r3_y * A1_z;  /* F73 */
    const int64_t r5_x_10 = r5_x_9 * INT64_C(4);  /* F75 */
    const int64_t r5_x_11 = r5_x_8 + r5_x_10;  /* F75 */
    const int64_t r5_x_12 = (int64_t)r3_z * A1_y_negated;  /* F73 */
    const int64_t r5_x_13 = r5_x_12 * INT64_C(4);  /* F75 */
    const int64_t r5_x_14 = r5_x_11 + r5_x_13;  /* F75 */
    const int64_t r5_x_15 = (int64_t)r2_w * A2_x;  /* F73 */
    const int64_t r5_x_16 = r5_x_15 * INT64_C(4);  /* F75 */
    const int64_t r5_x_17 = r5_x_14 + r5_x_16;  /* F75 */
    const int64_t r5_x_18 = (int64_t)A1_y * A2_z;  /* F71 */
    const int64_t r5_x_19 = r5_x_18 * INT64_C(8);  /* F75 */
    const int64_t r5_x_20 = r5_x_17 + r5_x_19;  /* F75 */
    const int64_t r5_x_21 = (int64_t)A1_z_negated * A2_y;  /* F71 */
    const int64_t r5_x_22 = r5_x_21 * INT64_C(8);  /* F75 */
    const int64_t r5_x_23 = r5_x_20 + r5_x_22;  /* F75 */
    const int32_t r5_x_24 = round_33(r5_x_23);  /* F42, |x| <= 0.00024 */
    const int32_t r5_x_25 = r5_x_24 + r5_x_4;  /* F42, |x| <= 0.000262 */
    const int64_t r5_y_1 = (int64_t)r4_z * A0_x;  /* F76 */
    const int64_t r5_y_2 = (int64_t)r4_x * A0_z_negated;  /* F76 */
    const int64_t r5_y_3 = r5_y_1 + r5_y_2;  /* F76 */
    const int32_t r5_y_4 = round_34(r5_y_3);  /* F42, |x| <= 2.24e-05 */
    const int32_t A1_x_negated = -A1_x;  /* F35 */
    const int64_t r5_y_5 = (int64_t)r4_w * A0_y;  /* F75 */
    const int64_t r5_y_6 = (int64_t)r3_w * A1_y;  /* F73 */
    const int64_t r5_y_7 = r5_y_6 * INT64_C(4);  /* F75 */
    const int64_t r5_y_8 = r5_y_5 + r5_y_7;  /* F75 */
    const int64_t r5_y_9 = (int64_t)r3_z * A1_x;  /* F73 */
    const int64_t r5_y_10 = r5_y_9 * INT64_C(4);  /* F75 */
    const int64_t r5_y_11 = r5_y_8 + r5_y_10;  /* F75 */
    const int64_t r5_y_12 = (int64_t)r3_x * A1_z_negated;  /* F73 */
    const int64_t r5_y_13 = r5_y_12 * INT64_C(4);  /* F75 */
    const int64_t r5_y_14 = r5_y_11 + r5_y_13;  /* F75 */
    const int64_t r5_y_15 = (int64_t)r2_w * A2_y;  /* F73 */
    const int64_t r5_y_16 = r5_y_15 * INT64_C(4);  /* F75 */
    const int64_t r5_y_17 = r5_y_14 + r5_y_16;  /* F75 */
    const int64_t r5_y_18 = (int64_t)A1_z * A2_x;  /* F71 */
    const int64_t r5_y_19 = r5_y_18 * INT64_C(8);  /* F75 */
    const int64_t r5_y_20 = r5_y_17 + r5_y_19;  /* F75 */
    const int64_t r5_y_21 = (int64_t)A1_x_negated * A2_z;  /* F71 */
    const int64_t r5_y_22 = r5_y_21 * INT64_C(8);  /* F75 */
    const int64_t r5_y_23 = r5_y_20 + r5_y_22;  /* F75 */
    const int32_t r5_y_24 = round_33(r5_y_23);  /* F42, |x| <= 0.00024 */
    const int32_t r5_y_25 = r5_y_24 + r5_y_4;  /* F42, |x| <= 0.000262 */
    const int64_t r5_w_1 = (int64_t)r4_x * A0_x_negated;  /* F76 */
    const int64_t r5_w_2 = (int64_t)r4_y * A0_y_negated;  /* F76 */
    const int64_t r5_w_3 = r5_w_1 + r5_w_2;  /* F76 */
    const int64_t r5_w_4 = (int64_t)r4_z * A0_z_negated;  /* F76 */
    const int64_t r5_w_5 = r5_w_3 + r5_w_4;  /* F76 */
    const int32_t r5_w_6 = round_32(r5_w_5);  /* F44, |x| <= 3.36e-05 */
    const int64_t r5_w_7 = r5_w_6 * INT64_C(536870912);  /* F73 */
    const int64_t r5_w_8 = (int64_t)r3_x * A1_x_negated;  /* F73 */
    const int64_t r5_w_9 = r5_w_7 + r5_w_8;  /* F73 */
    const int64_t r5_w_10 = (int64_t)r3_y * A1_y_negated;  /* F73 */
    const int64_t r5_w_11 = r5_w_9 + r5_w_10;  /* F73 */
    const int64_t r5_w_12 = (int64_t)r3_z * A1_z_negated;  /* F73 */
    const int64_t r5_w_13 = r5_w_11 + r5_w_12;  /* F73 */
    const int64_t r5_w_14 = (int64_t)A1_x_negated * A2_x;  /* F71 */
    const int64_t r5_w_15 = r5_w_14 * INT64_C(2);  /* F73 */
    const int64_t r5_w_16 = r5_w_13 + r5_w_15;  /* F73 */
    const int64_t r5_w_17 = (int64_t)A1_y_negated * A2_y;  /* F71 */
    const int64_t r5_w_18 = r5_w_17 * INT64_C(2);  /* F73 */
    const int64_t r5_w_19 = r5_w_16 + r5_w_18;  /* F73 */
    const int64_t r5_w_20 = (int64_t)A1_z_negated * A2_z;  /* F71 */
    const int64_t r5_w_21 = r5_w_20 * INT64_C(2);  /* F73 */
    const int64_t r5_w_22 = r5_w_19 + r5_w_21;  /* F73 */
    const int32_t r5_w_23 = round_32(r5_w_22);  /* F41, |x| <= 0.000283 */
    const int64_t r5_z_1 = (int64_t)r4_x * A0_y;  /* F76 */
    const int64_t r5_z_2 = (int64_t)r4_y * A0_x_negated;  /* F76 */
    const int64_t r5_z_3 = r5_z_1 + r5_z_2;  /* F76 */
    const int32_t r5_z_4 = round_34(r5_z_3);  /* F42, |x| <= 2.24e-05 */
    const int64_t r5_z_5 = (int64_t)r4_w * A0_z;  /* F75 */
    const int64_t r5_z_6 = (int64_t)r3_w * A1_z;  /* F73 */
    const int64_t r5_z_7 = r5_z_6 * INT64_C(4);  /* F75 */
    const int64_t r5_z_8 = r5_z_5 + r5_z_7;  /* F75 */
    const int64_t r5_z_9 = (int64_t)r3_x * A1_y;  /* F73 */
    const int64_t r5_z_10 = r5_z_9 * INT64_C(4);  /* F75 */
    const int64_t r5_z_11 = r5_z_8 + r5_z_10;  /* F75 */
    const int64_t r5_z_12 = (int64_t)r3_y * A1_x_negated;  /* F73 */
    const int64_t r5_z_13 = r5_z_12 * INT64_C(4);  /* F75 */
    const int64_t r5_z_14 = r5_z_11 + r5_z_13;  /* F75 */
    const int64_t r5_z_15 = (int64_t)r2_w * A2_z;  /* F73 */
    const int64_t r5_z_16 = r5_z_15 * INT64_C(4);  /* F75 */
    const int64_t r5_z_17 = r5_z_14 + r5_z_16;  /* F75 */
    const int64_t r5_z_18 = (int64_t)A1_x * A2_y;  /* F71 */
    const int64_t r5_z_19 = r5_z_18 * INT64_C(8);  /* F75 */
    const int64_t r5_z_20 = r5_z_17 + r5_z_19;  /* F75 */
    const int64_t r5_z_21 = (int64_t)A1_y_negated * A2_x;  /* F71 */
    const int64_t r5_z_22 = r5_z_21 * INT64_C(8);  /* F75 */
    const int64_t r5_z_23 = r5_z_20 + r5_z_22;  /* F75 */
    const int32_t r5_z_24 = round_33(r5_z_23);  /* F42, |x| <= 0.00024 */
    const int32_t r5_z_25 = r5_z_24 + r5_z_4;  /* F42, |x| <= 0.000262 */
    const int64_t r5_w_24 = (int64_t)858993459 /* 1/5 */ * r5_w_23;  /* F73 */
    const int32_t r5_w = round_32(r5_w_24);  /* F41, |x| <= 4.44e-05 */
    const int64_t r5_x_26 = (int64_t)858993459 /* 1/5 */ * r5_x_25;  /* F74 */
    const int32_t r5_x = round_32(r5_x_26);  /* F42, |x| <= 4.44e-05 */
    const int64_t r5_y_26 = (int64_t)858993459 /* 1/5 */ * r5_y_25;  /* F74 */
    const int32_t r5_y = round_32(r5_y_26);  /* F42, |x| <= 4.44e-05 */
    const int64_t r5_z_26 = (int64_t)858993459 /* 1/5 */ * r5_z_25;  /* F74 */
    const int32_t r5_z = round_32(r5_z_26);  /* F42, |x| <= 4.44e-05 */

    /* r_6 = 1/6 sum_j r_(6-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r6_x_1 = (int64_t)r5_w * A0_x;  /* F75 */
    const int64_t r6_x_2 = r6_x_1 * INT64_C(2);  /* F76 */
    const int64_t r6_x_3 = (int64_t)r5_y * A0_z;  /* F76 */
    const int64_t r6_x_4 = r6_x_2 + r6_x_3;  /* F76 */
    const int64_t r6_x_5 = (int64_t)r5_z * A0_y_negated;  /* F76 */
    const int64_t r6_x_6 = r6_x_4 + r6_x_5;  /* F76 */
    const int32_t r6_x_7 = round_32(r6_x_6);  /* F44, |x| <= 7.09e-06 */
    const int32_t A2_y_negated = -A2_y;  /* F36 */
    const int64_t r6_x_8 = (int64_t)r4_w * A1_x;  /* F76 */
    const int64_t r6_x_9 = r6_x_8 * INT64_C(2);  /* F77 */
    const int64_t r6_x_10 = (int64_t)r4_y * A1_z;  /* F77 */
    const int64_t r6_x_11 = r6_x_9 + r6_x_10;  /* F77 */
    const int64_t r6_x_12 = (int64_t)r4_z * A1_y_negated;  /* F77 */
    const int64_t r6_x_13 = r6_x_11 + r6_x_12;  /* F77 */
    const int64_t r6_x_14 = (int64_t)r3_w * A2_x;  /* F74 */
    const int64_t r6_x_15 = r6_x_14 * INT64_C(8);  /* F77 */
    const int64_t r6_x_16 = r6_x_13 + r6_x_15;  /* F77 */
    const int64_t r6_x_17 = (int64_t)r3_y * A2_z;  /* F74 */
    const int64_t r6_x_18 = r6_x_17 * INT64_C(8);  /* F77 */
    const int64_t r6_x_19 = r6_x_16 + r6_x_18;  /* F77 */
    const int64_t r6_x_20 = (int64_t)r3_z * A2_y_negated;  /* F74 */
    const int64_t r6_x_21 = r6_x_20 * INT64_C(8);  /* F77 */
    const int64_t r6_x_22 = r6_x_19 + r6_x_21;  /* F77 */
    const int32_t r6_x_23 = round_32(r6_x_22);  /* F45, |x| <= 4.04e-05 */
    const int32_t r6_x_24 = r6_x_7 * 2;  /* F45 */
    const int32_t r6_x_25 = r6_x_24 + r6_x_23;  /* F45, |x| <= 4.75e-05 */
    const int64_t r6_y_1 = (int64_t)r5_w * A0_y;  /* F75 */
    const int64_t r6_y_2 = r6_y_1 * INT64_C(2);  /* F76 */
    const int64_t r6_y_3 = (int64_t)r5_z * A0_x;  /* F76 */
    const int64_t r6_y_4 = r6_y_2 + r6_y_3;  /* F76 */
    const int64_t r6_y_5 = (int64_t)r5_x * A0_z_negated;  /* F76 */
    const int64_t r6_y_6 = r6_y_4 + r6_y_5;  /* F76 */
    const int32_t r6_y_7 = round_32(r6_y_6);  /* F44, |x| <= 7.09e-06 */
    const int32_t A2_z_negated = -A2_z;  /* F36 */
    const int64_t r6_y_8 = (int64_t)r4_w * A1_y;  /* F76 */
    const int64_t r6_y_9 = r6_y_8 * INT64_C(2);  /* F77 */
    const int64_t r6_y_10 = (int64_t)r4_z * A1_x;  /* F77 */
    const int64_t r6_y_11 = r6_y_9 + r6_y_10;  /* F77 */
    const int64_t r6_y_12 = (int64_t)r4_x * A1_z_negated;  /* F77 */
    const int64_t r6_y_13 = r6_y_11 + r6_y_12;  /* F77 */
    const int64_t r6_y_14 = (int64_t)r3_w * A2_y;  /* F74 */
    const int64_t r6_y_15 = r6_y_14 * INT64_C(8);  /* F77 */
    const int64_t r6_y_16 = r6_y_13 + r6_y_15;  /* F77 */
    const int64_t r6_y_17 = (int64_t)r3_z * A2_x;  /* F74 */
    const int64_t r6_y_18 = r6_y_17 * INT64_C(8);  /* F77 */
    const int64_t r6_y_19 = r6_y_16 + r6_y_18;  /* F77 */
    const int64_t r6_y_20 = (int64_t)r3_x * A2_z_negated;  /* F74 */
    const int64_t r6_y_21 = r6_y_20 * INT64_C(8);  /* F77 */
    const int64_t r6_y_22 = r6_y_19 + r6_y_21;  /* F77 */
    const int32_t r6_y_23 = round_32(r6_y_22);  /* F45, |x| <= 4.04e-05 */
    const int32_t r6_y_24 = r6_y_7 * 2;  /* F45 */
    const int32_t r6_y_25 = r6_y_24 + r6_y_23;  /* F45, |x| <= 4.75e-05 */
    const int64_t r6_w_1 = (int64_t)r5_x * A0_x_negated;  /* F76 */
    const int64_t r6_w_2 = (int64_t)r5_y * A0_y_negated;  /* F76 */
    const int64_t r6_w_3 = r6_w_1 + r6_w_2;  /* F76 */
    const int64_t r6_w_4 = (int64_t)r5_z * A0_z_negated;  /* F76 */
    const int64_t r6_w_5 = r6_w_3 + r6_w_4;  /* F76 */
    const int32_t r6_w_6 = round_32(r6_w_5);  /* F44, |x| <= 7.09e-06 */
    const int32_t A2_x_negated = -A2_x;  /* F36 */
    const int64_t r6_w_7 = (int64_t)r4_x * A1_x_negated;  /* F77 */
    const int64_t r6_w_8 = (int64_t)r4_y * A1_y_negated;  /* F77 */
    const int64_t r6_w_9 = r6_w_7 + r6_w_8;  /* F77 */
    const int64_t r6_w_10 = (int64_t)r4_z * A1_z_negated;  /* F77 */
    const int64_t r6_w_11 = r6_w_9 + r6_w_10;  /* F77 */
    const int64_t r6_w_12 = (int64_t)r3_x * A2_x_negated;  /* F74 */
    const int64_t r6_w_13 = r6_w_12 * INT64_C(8);  /* F77 */
    const int64_t r6_w_14 = r6_w_11 + r6_w_13;  /* F77 */
    const int64_t r6_w_15 = (int64_t)r3_y * A2_y_negated;  /* F74 */
    const int64_t r6_w_16 = r6_w_15 * INT64_C(8);  /* F77 */
    const int64_t r6_w_17 = r6_w_14 + r6_w_16;  /* F77 */
    const int64_t r6_w_18 = (int64_t)r3_z * A2_z_negated;  /* F74 */
    const int64_t r6_w_19 = r6_w_18 * INT64_C(8);  /* F77 */
    const int64_t r6_w_20 = r6_w_17 + r6_w_19;  /* F77 */
    const int32_t r6_w_21 = round_32(r6_w_20);  /* F45, |x| <= 3.76e-05 */
    const int32_t r6_w_22 = r6_w_6 * 2;  /* F45 */
    const int32_t r6_w_23 = r6_w_22 + r6_w_21;  /* F45, |x| <= 4.47e-05 */
    const int64_t r6_z_1 = (int64_t)r5_w * A0_z;  /* F75 */
    const int64_t r6_z_2 = r6_z_1 * INT64_C(2);  /* F76 */
    const int64_t r6_z_3 = (int64_t)r5_x * A0_y;  /* F76 */
    const int64_t r6_z_4 = r6_z_2 + r6_z_3;  /* F76 */
    const int64_t r6_z_5 = (int64_t)r5_y * A0_x_negated;  /* F76 */
    const int64_t r6_z_6 = r6_z_4 + r6_z_5;  /* F76 */
    const int32_t r6_z_7 = round_32(r6_z_6);  /* F44, |x| <= 7.09e-06 */
    const int64_t r6_z_8 = (int64_t)r4_w * A1_z;  /* F76 */
    const int64_t r6_z_9 = r6_z_8 * INT64_C(2);  /* F77 */
    const int64_t r6_z_10 = (int64_t)r4_x * A1_y;  /* F77 */
    const int64_t r6_z_11 = r6_z_9 + r6_z_10;  /* F77 */
    const int64_t r6_z_12 = (int64_t)r4_y * A1_x_negated;  /* F77 */
    const int64_t r6_z_13 = r6_z_11 + r6_z_12;  /* F77 */
    const int64_t r6_z_14 = (int64_t)r3_w * A2_z;  /* F74 */
    const int64_t r6_z_15 = r6_z_14 * INT64_C(8);  /* F77 */
    const int64_t r6_z_16 = r6_z_13 + r6_z_15;  /* F77 */
    const int64_t r6_z_17 = (int64_t)r3_x * A2_y;  /* F74 */
    const int64_t r6_z_18 = r6_z_17 * INT64_C(8);  /* F77 */
    const int64_t r6_z_19 = r6_z_16 + r6_z_18;  /* F77 */
    const int64_t r6_z_20 = (int64_t)r3_y * A2_x_negated;  /* F74 */
    const int64_t r6_z_21 = r6_z_20 * INT64_C(8);  /* F77 */
    const int64_t r6_z_22 = r6_z_19 + r6_z_21;  /* F77 */
    const int32_t r6_z_23 = round_32(r6_z_22);  /* F45, |x| <= 4.04e-05 */
    const int32_t r6_z_24 = r6_z_7 * 2;  /* F45 */
    const int32_t r6_z_25 = r6_z_24 + r6_z_23;  /* F45, |x| <= 4.75e-05 */
    const int64_t r6_w_24 = (int64_t)1431655765 /* 1/6 */ * r6_w_23;  /* F78 */
    const int32_t r6_w = round_32(r6_w_24);  /* F46, |x| <= 5.25e-06 */
    const int64_t r6_x_26 = (int64_t)1431655765 /* 1/6 */ * r6_x_25;  /* F78 */
    const int32_t r6_x = round_32(r6_x_26);  /* F46, |x| <= 5.25e-06 */
    const int64_t r6_y_26 = (int64_t)1431655765 /* 1/6 */ * r6_y_25;  /* F78 */
    const int32_t r6_y = round_32(r6_y_26);  /* F46, |x| <= 5.25e-06 */
    const int64_t r6_z_26 = (int64_t)1431655765 /* 1/6 */ * r6_z_25;  /* F78 */
    const int32_t r6_z = round_32(r6_z_26);  /* F46, |x| <= 5.25e-06 */

    /* r_7 = 1/7 sum_j r_(7-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r7_x_1 = (int64_t)r6_w * A0_x;  /* F80 */
    const int64_t r7_x_2 = (int64_t)r6_y * A0_z;  /* F80 */
    const int64_t r7_x_3 = r7_x_1 + r7_x_2;  /* F80 */
    const int64_t r7_x_4 = (int64_t)r6_z * A0_y_negated;  /* F80 */
    const int64_t r7_x_5 = r7_x_3 + r7_x_4;  /* F80 */
    const int32_t r7_x_6 = round_32(r7_x_5);  /* F48, |x| <= 8.39e-07 */
    const int64_t r7_x_7 = r7_x_6 * INT64_C(1073741824);  /* F78 */
    const int64_t r7_x_8 = (int64_t)r5_w * A1_x;  /* F76 */
    const int64_t r7_x_9 = r7_x_8 * INT64_C(4);  /* F78 */
    const int64_t r7_x_10 = r7_x_7 + r7_x_9;  /* F78 */
    const int64_t r7_x_11 = (int64_t)r5_y * A1_z;  /* F77 */
    const int64_t r7_x_12 = r7_x_11 * INT64_C(2);  /* F78 */
    const int64_t r7_x_13 = r7_x_10 + r7_x_12;  /* F78 */
    const int64_t r7_x_14 = (int64_t)r5_z * A1_y_negated;  /* F77 */
    const int64_t r7_x_15 = r7_x_14 * INT64_C(2);  /* F78 */
    const int64_t r7_x_16 = r7_x_13 + r7_x_15;  /* F78 */
    const int64_t r7_x_17 = (int64_t)r4_w * A2_x;  /* F77 */
    const int64_t r7_x_18 = r7_x_17 * INT64_C(2);  /* F78 */
    const int64_t r7_x_19 = r7_x_16 + r7_x_18;  /* F78 */
    const int64_t r7_x_20 = (int64_t)r4_y * A2_z;  /* F78 */
    const int64_t r7_x_21 = r7_x_19 + r7_x_20;  /* F78 */
    const int64_t r7_x_22 = (int64_t)r4_z * A2_y_negated;  /* F78 */
    const int64_t r7_x_23 = r7_x_21 + r7_x_22;  /* F78 */
    const int32_t r7_x_24 = round_32(r7_x_23);  /* F46, |x| <= 7.15e-06 */
    const int64_t r7_y_1 = (int64_t)r6_w * A0_y;  /* F80 */
    const int64_t r7_y_2 = (int64_t)r6_z * A0_x;  /* F80 */
    const int64_t r7_y_3 = r7_y_1 + r7_y_2;  /* F80 */
    const int64_t r7_y_4 = (int64_t)r6_x * A0_z_negated;  /* F80 */
    const int64_t r7_y_5 = r7_y_3 + r7_y_4;  /* F80 */
    const int32_t r7_y_6 = round_32(r7_y_5);  /* F48, |x| <= 8.39e-07 */
    const int64_t r7_y_7 = r7_y_6 * INT64_C(1073741824);  /* F78 */
    const int64_t r7_y_8 = (int64_t)r5_w * A1_y;  /* F76 */
    const int64_t r7_y_9 = r7_y_8 * INT64_C(4);  /* F78 */
    const int64_t r7_y_10 = r7_y_7 + r7_y_9;  /* F78 */
    const int64_t r7_y_11 = (int64_t)r5_z * A1_x;  /* F77 */
    const int64_t r7_y_12 = r7_y_11 * INT64_C(2);  /* F78 */
    const int64_t r7_y_13 = r7_y_10 + r7_y_12;  /* F78 */
    const int64_t r7_y_14 = (int64_t)r5_x * A1_z_negated;  /* F77 */
    const int64_t r7_y_15 = r7_y_14 * INT64_C(2);  /* F78 */
    const int64_t r7_y_16 = r7_y_13 + r7_y_15;  /* F78 */
    const int64_t r7_y_17 = (int64_t)r4_w * A2_y;  /* F77 */
    const int64_t r7_y_18 = r7_y_17 * INT64_C(2);  /* F78 */
    const int64_t r7_y_19 = r7_y_16 + r7_y_18;  /* F78 */
    const int64_t r7_y_20 = (int64_t)r4_z * A2_x;  /* F78 */
    const int64_t r7_y_21 = r7_y_19 + r7_y_20;  /* F78 */
    const int64_t r7_y_22 = (int64_t)r4_x * A2_z_negated;  /* F78 */
    const int64_t r7_y_23 = r7_y_21 + r7_y_22;  /* F78 */
    const int32_t r7_y_24 = round_32(r7_y_23);  /* F46, |x| <= 7.15e-06 */
    const int64_t r7_w_1 = (int64_t)r6_x * A0_x_negated;  /* F80 */
    const int64_t r7_w_2 = (int64_t)r6_y * A0_y_negated;  /* F80 */
    const int64_t r7_w_3 = r7_w_1 + r7_w_2;  /* F80 */
    const int64_t r7_w_4 = (int64_t)r6_z * A0_z_negated;  /* F80 */
    const int64_t r7_w_5 = r7_w_3 + r7_w_4;  /* F80 */
    const int32_t r7_w_6 = round_32(r7_w_5);  /* F48, |x| <= 8.39e-07 */
    const int64_t r7_w_7 = r7_w_6 * INT64_C(1073741824);  /* F78 */
    const int64_t r7_w_8 = (int64_t)r5_x * A1_x_negated;  /* F77 */
    const int64_t r7_w_9 = r7_w_8 * INT64_C(2);  /* F78 */
    const int64_t r7_w_10 = r7_w_7 + r7_w_9;  /* F78 */
    const int64_t r7_w_11 = (int64_t)r5_y * A1_y_negated;  /* F77 */
    const int64_t r7_w_12 = r7_w_11 * INT64_C(2);  /* F78 */
    const int64_t r7_w_13 = r7_w_10 + r7_w_12;  /* F78 */
    const int64_t r7_w_14 = (int64_t)r5_z * A1_z_negated;  /* F77 */
    const int64_t r7_w_15 = r7_w_14 * INT64_C(2);  /* F78 */
    const int64_t r7_w_16 = r7_w_13 + r7_w_15;  /* F78 */
    const int64_t r7_w_17 = (int64_t)r4_x * A2_x_negated;  /* F78 */
    const int64_t r7_w_18 = r7_w_16 + r7_w_17;  /* F78 */
    const int64_t r7_w_19 = (int64_t)r4_y * A2_y_negated;  /* F78 */
    const int64_t r7_w_20 = r7_w_18 + r7_w_19;  /* F78 */
    const int64_t r7_w_21 = (int64_t)r4_z * A2_z_negated;  /* F78 */
    const int64_t r7_w_22 = r7_w_20 + r7_w_21;  /* F78 */
    const int32_t r7_w_23 = round_32(r7_w_22);  /* F46, |x| <= 6.3e-06 */
    const int64_t r7_z_1 = (int64_t)r6_w * A0_z;  /* F80 */
    const int64_t r7_z_2 = (int64_t)r6_x * A0_y;  /* F80 */
    const int64_t r7_z_3 = r7_z_1 + r7_z_2;  /* F80 */
    const int64_t r7_z_4 = (int64_t)r6_y * A0_x_negated;  /* F80 */
    const int64_t r7_z_5 = r7_z_3 + r7_z_4;  /* F80 */
    const int32_t r7_z_6 = round_32(r7_z_5);  /* F48, |x| <= 8.39e-07 */
    const int64_t r7_z_7 = r7_z_6 * INT64_C(1073741824);  /* F78 */
    const int64_t r7_z_8 = (int64_t)r5_w * A1_z;  /* F76 */
    const int64_t r7_z_9 = r7_z_8 * INT64_C(4);  /* F78 */
    const int64_t r7_z_10 = r7_z_7 + r7_z_9;  /* F78 */
    const int64_t r7_z_11 = (int64_t)r5_x * A1_y;  /* F77 */
    const int64_t r7_z_12 = r7_z_11 * INT64_C(2);  /* F78 */
    const int64_t r7_z_13 = r7_z_10 + r7_z_12;  /* F78 */
    const int64_t r7_z_14 = (int64_t)r5_y * A1_x_negated;  /* F77 */
    const int64_t r7_z_15 = r7_z_14 * INT64_C(2);  /* F78 */
    const int64_t r7_z_16 = r7_z_13 + r7_z_15;  /* F78 */
    const int64_t r7_z_17 = (int64_t)r4_w * A2_z;  /* F77 */
    const int64_t r7_z_18 = r7_z_17 * INT64_C(2);  /* F78 */
    const int64_t r7_z_19 = r7_z_16 + r7_z_18;  /* F78 */
    const int64_t r7_z_20 = (int64_t)r4_x * A2_y;  /* F78 */
    const int64_t r7_z_21 = r7_z_19 + r7_z_20;  /* F78 */
    const int64_t r7_z_22 = (int64_t)r4_y * A2_x_negated;  /* F78 */
    const int64_t r7_z_23 = r7_z_21 + r7_z_22;  /* F78 */
    const int32_t r7_z_24 = round_32(r7_z_23);  /* F46, |x| <= 7.15e-06 */
    const int64_t r7_w_24 = (int64_t)1227133513 /* 1/7 */ * r7_w_23;  /* F79 */
    const int32_t r7_w = round_32(r7_w_24);  /* F47, |x| <= 5.36e-07 */
    const int64_t r7_x_25 = (int64_t)1227133513 /* 1/7 */ * r7_x_24;  /* F79 */
    const int32_t r7_x = round_32(r7_x_25);  /* F47, |x| <= 5.36e-07 */
    const int64_t r7_y_25 = (int64_t)1227133513 /* 1/7 */ * r7_y_24;  /* F79 */
    const int32_t r7_y = round_32(r7_y_25);  /* F47, |x| <= 5.36e-07 */
    const int64_t r7_z_25 = (int64_t)1227133513 /* 1/7 */ * r7_z_24;  /* F79 */
    const int32_t r7_z = round_32(r7_z_25);  /* F47, |x| <= 5.36e-07 */

    /* r_8 = 1/8 sum_j r_(8-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r8_w_part_1 = (int64_t)r7_x * A0_x_negated;  /* F81 */
    const int64_t r8_w_part_3 = (int64_t)r7_y * A0_y_negated;  /* F81 */
    const int64_t r8_w_part_4 = r8_w_part_1 + r8_w_part_3;  /* F84 */
    const int64_t r8_w_part_5 = (int64_t)r7_z * A0_z_negated;  /* F81 */
    const int64_t r8_w_part_6 = r8_w_part_4 + r8_w_part_5;  /* F84 */
    const int32_t r8_w_part = round_30(r8_w_part_6);  /* F54, |x| <= 1.07e-08 */
    const int64_t r8_w_part_2_1 = (int64_t)r6_x * A1_x_negated;  /* F81 */
    const int64_t r8_w_part_2_2 = (int64_t)r6_y * A1_y_negated;  /* F81 */
    const int64_t r8_w_part_2_3 = r8_w_part_2_1 + r8_w_part_2_2;  /* F84 */
    const int64_t r8_w_part_2_4 = (int64_t)r6_z * A1_z_negated;  /* F81 */
    const int64_t r8_w_part_2_5 = r8_w_part_2_3 + r8_w_part_2_4;  /* F84 */
    const int64_t r8_w_part_2_6 = (int64_t)r5_x * A2_x_negated;  /* F78 */
    const int64_t r8_w_part_2_7 = r8_w_part_2_6 * INT64_C(8);  /* F84 */
    const int64_t r8_w_part_2_8 = r8_w_part_2_5 + r8_w_part_2_7;  /* F84 */
    const int64_t r8_w_part_2_9 = (int64_t)r5_y * A2_y_negated;  /* F78 */
    const int64_t r8_w_part_2_10 = r8_w_part_2_9 * INT64_C(8);  /* F84 */
    const int64_t r8_w_part_2_11 = r8_w_part_2_8 + r8_w_part_2_10;  /* F84 */
    const int64_t r8_w_part_2_12 = (int64_t)r5_z * A2_z_negated;  /* F78 */
    const int64_t r8_w_part_2_13 = r8_w_part_2_12 * INT64_C(8);  /* F84 */
    const int64_t r8_w_part_2_14 = r8_w_part_2_11 + r8_w_part_2_13;  /* F84 */
    const int32_t r8_w_part_2 = round_32(r8_w_part_2_14);  /* F52, |x| <= 1.13e-07 */
    const int64_t r8_w_1 = r8_w_part_2 * INT64_C(4);  /* F54 */
    const int64_t r8_w_2 = r8_w_part + r8_w_1;  /* F54 */
    const int32_t r8_w = (int32_t)r8_w_2;  /* F54, |x| <= 4.38e-08 */
    const int64_t r8_x_part_1 = (int64_t)r7_w * A0_x;  /* F81 */
    const int64_t r8_x_part_3 = (int64_t)r7_y * A0_z;  /* F81 */
    const int64_t r8_x_part_4 = r8_x_part_1 + r8_x_part_3;  /* F84 */
    const int64_t r8_x_part_5 = (int64_t)r7_z * A0_y_negated;  /* F81 */
    const int64_t r8_x_part_6 = r8_x_part_4 + r8_x_part_5;  /* F84 */
    const int32_t r8_x_part = round_30(r8_x_part_6);  /* F54, |x| <= 1.07e-08 */
    const int64_t r8_x_part_2_1 = (int64_t)r6_w * A1_x;  /* F81 */
    const int64_t r8_x_part_2_2 = (int64_t)r6_y * A1_z;  /* F81 */
    const int64_t r8_x_part_2_3 = r8_x_part_2_1 + r8_x_part_2_2;  /* F84 */
    const int64_t r8_x_part_2_4 = (int64_t)r6_z * A1_y_negated;  /* F81 */
    const int64_t r8_x_part_2_5 = r8_x_part_2_3 + r8_x_part_2_4;  /* F84 */
    const int64_t r8_x_part_2_6 = (int64_t)r5_w * A2_x;  /* F77 */
    const int64_t r8_x_part_2_7 = r8_x_part_2_6 * INT64_C(16);  /* F84 */
    const int64_t r8_x_part_2_8 = r8_x_part_2_5 + r8_x_part_2_7;  /* F84 */
    const int64_t r8_x_part_2_9 = (int64_t)r5_y * A2_z;  /* F78 */
    const int64_t r8_x_part_2_10 = r8_x_part_2_9 * INT64_C(8);  /* F84 */
    const int64_t r8_x_part_2_11 = r8_x_part_2_8 + r8_x_part_2_10;  /* F84 */
    const int64_t r8_x_part_2_12 = (int64_t)r5_z * A2_y_negated;  /* F78 */
    const int64_t r8_x_part_2_13 = r8_x_part_2_12 * INT64_C(8);  /* F84 */
    const int64_t r8_x_part_2_14 = r8_x_part_2_11 + r8_x_part_2_13;  /* F84 */
    const int32_t r8_x_part_2 = round_32(r8_x_part_2_14);  /* F52, |x| <= 1.13e-07 */
    const int64_t r8_x_1 = r8_x_part_2 * INT64_C(4);  /* F54 */
    const int64_t r8_x_2 = r8_x_part + r8_x_1;  /* F54 */
    const int32_t r8_x = (int32_t)r8_x_2;  /* F54, |x| <= 4.38e-08 */
    const int64_t r8_y_part_1 = (int64_t)r7_w * A0_y;  /* F81 */
    const int64_t r8_y_part_3 = (int64_t)r7_z * A0_x;  /* F81 */
    const int64_t r8_y_part_4 = r8_y_part_1 + r8_y_part_3;  /* F84 */
    const int64_t r8_y_part_5 = (int64_t)r7_x * A0_z_negated;  /* F81 */
    const int64_t r8_y_part_6 = r8_y_part_4 + r8_y_part_5;  /* F84 */
    const int32_t r8_y_part = round_30(r8_y_part_6);  /* F54, |x| <= 1.07e-08 */
    const int64_t r8_y_part_2_1 = (int64_t)r6_w * A1_y;  /* F81 */
    const int64_t r8_y_part_2_2 = (int64_t)r6_z * A1_x;  /* F81 */
    const int64_t r8_y_part_2_3 = r8_y_part_2_1 + r8_y_part_2_2;  /* F84 */
    const int64_t r8_y_part_2_4 = (int64_t)r6_x * A1_z_negated;  /* F81 */
    const int64_t r8_y_part_2_5 = r8_y_part_2_3 + r8_y_part_2_4;  /* F84 */
    const int64_t r8_y_part_2_6 = (int64_t)r5_w * A2_y;  /* F77 */
    const int64_t r8_y_part_2_7 = r8_y_part_2_6 * INT64_C(16);  /* F84 */
    const int64_t r8_y_part_2_8 = r8_y_part_2_5 + r8_y_part_2_7;  /* F84 */
    const int64_t r8_y_part_2_9 = (int64_t)r5_z * A2_x;  /* F78 */
    const int64_t r8_y_part_2_10 = r8_y_part_2_9 * INT64_C(8);  /* F84 */
    const int64_t r8_y_part_2_11 = r8_y_part_2_8 + r8_y_part_2_10;  /* F84 */
    const int64_t r8_y_part_2_12 = (int64_t)r5_x * A2_z_negated;  /* F78 */
    const int64_t r8_y_part_2_13 = r8_y_part_2_12 * INT64_C(8);  /* F84 */
    const int64_t r8_y_part_2_14 = r8_y_part_2_11 + r8_y_part_2_13;  /* F84 */
    const int32_t r8_y_part_2 = round_32(r8_y_part_2_14);  /* F52, |x| <= 1.13e-07 */
    const int64_t r8_y_1 = r8_y_part_2 * INT64_C(4);  /* F54 */
    const int64_t r8_y_2 = r8_y_part + r8_y_1;  /* F54 */
    const int32_t r8_y = (int32_t)r8_y_2;  /* F54, |x| <= 4.38e-08 */
    const int64_t r8_z_part_1 = (int64_t)r7_w * A0_z;  /* F81 */
    const int64_t r8_z_part_3 = (int64_t)r7_x * A0_y;  /* F81 */
    const int64_t r8_z_part_4 = r8_z_part_1 + r8_z_part_3;  /* F84 */
    const int64_t r8_z_part_5 = (int64_t)r7_y * A0_x_negated;  /* F81 */
    const int64_t r8_z_part_6 = r8_z_part_4 + r8_z_part_5;  /* F84 */
    const int32_t r8_z_part = round_30(r8_z_part_6);  /* F54, |x| <= 1.07e-08 */
    const int64_t r8_z_part_2_1 = (int64_t)r6_w * A1_z;  /* F81 */
    const int64_t r8_z_part_2_2 = (int64_t)r6_x * A1_y;  /* F81 */
    const int64_t r8_z_part_2_3 = r8_z_part_2_1 + r8_z_part_2_2;  /* F84 */
    const int64_t r8_z_part_2_4 = (int64_t)r6_y * A1_x_negated;  /* F81 */
    const int64_t r8_z_part_2_5 = r8_z_part_2_3 + r8_z_part_2_4;  /* F84 */
    const int64_t r8_z_part_2_6 = (int64_t)r5_w * A2_z;  /* F77 */
    const int64_t r8_z_part_2_7 = r8_z_part_2_6 * INT64_C(16);  /* F84 */
    const int64_t r8_z_part_2_8 = r8_z_part_2_5 + r8_z_part_2_7;  /* F84 */
    const int64_t r8_z_part_2_9 = (int64_t)r5_x * A2_y;  /* F78 */
    const int64_t r8_z_part_2_10 = r8_z_part_2_9 * INT64_C(8);  /* F84 */
    const int64_t r8_z_part_2_11 = r8_z_part_2_8 + r8_z_part_2_10;  /* F84 */
    const int64_t r8_z_part_2_12 = (int64_t)r5_y * A2_x_negated;  /* F78 */
    const int64_t r8_z_part_2_13 = r8_z_part_2_12 * INT64_C(8);  /* F84 */
    const int64_t r8_z_part_2_14 = r8_z_part_2_11 + r8_z_part_2_13;  /* F84 */
    const int32_t r8_z_part_2 = round_32(r8_z_part_2_14);  /* F52, |x| <= 1.13e-07 */
    const int64_t r8_z_1 = r8_z_part_2 * INT64_C(4);  /* F54 */
    const int64_t r8_z_2 = r8_z_part + r8_z_1;  /* F54 */
    const int32_t r8_z = (int32_t)r8_z_2;  /* F54, |x| <= 4.38e-08 */

    /* r_9 = 1/9 sum_j r_(9-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r9_x_1 = (int64_t)r8_w * A0_x;  /* F88 */
    const int64_t r9_x_2 = (int64_t)r8_y * A0_z;  /* F88 */
    const int64_t r9_x_3 = r9_x_1 + r9_x_2;  /* F88 */
    const int64_t r9_x_4 = (int64_t)r8_z * A0_y_negated;  /* F88 */
    const int64_t r9_x_5 = r9_x_3 + r9_x_4;  /* F88 */
    const int32_t r9_x_6 = round_32(r9_x_5);  /* F56, |x| <= 6.99e-09 */
    const int64_t r9_x_7 = r9_x_6 * INT64_C(67108864);  /* F82 */
    const int64_t r9_x_8 = (int64_t)r7_w * A1_x;  /* F82 */
    const int64_t r9_x_9 = r9_x_7 + r9_x_8;  /* F82 */
    const int64_t r9_x_10 = (int64_t)r7_y * A1_z;  /* F82 */
    const int64_t r9_x_11 = r9_x_9 + r9_x_10;  /* F82 */
    const int64_t r9_x_12 = (int64_t)r7_z * A1_y_negated;  /* F82 */
    const int64_t r9_x_13 = r9_x_11 + r9_x_12;  /* F82 */
    const int64_t r9_x_14 = (int64_t)r6_w * A2_x;  /* F82 */
    const int64_t r9_x_15 = r9_x_13 + r9_x_14;  /* F82 */
    const int64_t r9_x_16 = (int64_t)r6_y * A2_z;  /* F82 */
    const int64_t r9_x_17 = r9_x_15 + r9_x_16;  /* F82 */
    const int64_t r9_x_18 = (int64_t)r6_z * A2_y_negated;  /* F82 */
    const int64_t r9_x_19 = r9_x_17 + r9_x_18;  /* F82 */
    const int32_t r9_x_20 = round_30(r9_x_19);  /* F52, |x| <= 1.09e-07 */
    const int64_t r9_y_1 = (int64_t)r8_w * A0_y;  /* F88 */
    const int64_t r9_y_2 = (int64_t)r8_z * A0_x;  /* F88 */
    const int64_t r9_y_3 = r9_y_1 + r9_y_2;  /* F88 */
    const int64_t r9_y_4 = (int64_t)r8_x * A0_z_negated;  /* F88 */
    const int64_t r9_y_5 = r9_y_3 + r9_y_4;  /* F88 */
    const int32_t r9_y_6 = round_32(r9_y_5);  /* F56, |x| <= 6.99e-09 */
    const int64_t r9_y_7 = r9_y_6 * INT64_C(67108864);  /* F82 */
    const int64_t r9_y_8 = (int64_t)r7_w * A1_y;  /* F82 */
    const int64_t r9_y_9 = r9_y_7 + r9_y_8;  /* F82 */
    const int64_t r9_y_10 = (int64_t)r7_z * A1_x;  /* F82 */
    const int64_t r9_y_11 = r9_y_9 + r9_y_10;  /* F82 */
    const int64_t r9_y_12 = (int64_t)r7_x * A1_z_negated;  /* F82 */
    const int64_t r9_y_13 = r9_y_11 + r9_y_12;  /* F82 */
    const int64_t r9_y_14 = (int64_t)r6_w * A2_y;  /* F82 */
    const int64_t r9_y_15 = r9_y_13 + r9_y_14;  /* F82 */
    const int64_t r9_y_16 = (int64_t)r6_z * A2_x;  /* F82 */
    const int64_t r9_y_17 = r9_y_15 + r9_y_16;  /* F82 */
    const int64_t r9_y_18 = (int64_t)r6_x * A2_z_negated;  /* F82 */
    const int64_t r9_y_19 = r9_y_17 + r9_y_18;  /* F82 */
    const int32_t r9_y_20 = round_30(r9_y_19);  /* F52, |x| <= 1.09e-07 */
    const int64_t r9_w_1 = (int64_t)r8_x * A0_x_negated;  /* F88 */
    const int64_t r9_w_2 = (int64_t)r8_y * A0_y_negated;  /* F88 */
    const int64_t r9_w_3 = r9_w_1 + r9_w_2;  /* F88 */
    const int64_t r9_w_4 = (int64_t)r8_z * A0_z_negated;  /* F88 */
    const int64_t r9_w_5 = r9_w_3 + r9_w_4;  /* F88 */
    const int32_t r9_w_6 = round_32(r9_w_5);  /* F56, |x| <= 6.99e-09 */
    const int64_t r9_w_7 = r9_w_6 * INT64_C(67108864);  /* F82 */
    const int64_t r9_w_8 = (int64_t)r7_x * A1_x_negated;  /* F82 */
    const int64_t r9_w_9 = r9_w_7 + r9_w_8;  /* F82 */
    const int64_t r9_w_10 = (int64_t)r7_y * A1_y_negated;  /* F82 */
    const int64_t r9_w_11 = r9_w_9 + r9_w_10;  /* F82 */
    const int64_t r9_w_12 = (int64_t)r7_z * A1_z_negated;  /* F82 */
    const int64_t r9_w_13 = r9_w_11 + r9_w_12;  /* F82 */
    const int64_t r9_w_14 = (int64_t)r6_x * A2_x_negated;  /* F82 */
    const int64_t r9_w_15 = r9_w_13 + r9_w_14;  /* F82 */
    const int64_t r9_w_16 = (int64_t)r6_y * A2_y_negated;  /* F82 */
    const int64_t r9_w_17 = r9_w_15 + r9_w_16;  /* F82 */
    const int64_t r9_w_18 = (int64_t)r6_z * A2_z_negated;  /* F82 */
    const int64_t r9_w_19 = r9_w_17 + r9_w_18;  /* F82 */
    const int32_t r9_w_20 = round_30(r9_w_19);  /* F52, |x| <= 1.09e-07 */
    const int64_t r9_z_1 = (int64_t)r8_w * A0_z;  /* F88 */
    const int64_t r9_z_2 = (int64_t)r8_x * A0_y;  /* F88 */
    const int64_t r9_z_3 = r9_z_1 + r9_z_2;  /* F88 */
    const int64_t r9_z_4 = (int64_t)r8_y * A0_x_negated;  /* F88 */
    const int64_t r9_z_5 = r9_z_3 + r9_z_4;  /* F88 */
    const int32_t r9_z_6 = round_32(r9_z_5);  /* F56, |x| <= 6.99e-09 */
    const int64_t r9_z_7 = r9_z_6 * INT64_C(67108864);  /* F82 */
    const int64_t r9_z_8 = (int64_t)r7_w * A1_z;  /* F82 */
    const int64_t r9_z_9 = r9_z_7 + r9_z_8;  /* F82 */
    const int64_t r9_z_10 = (int64_t)r7_x * A1_y;  /* F82 */
    const int64_t r9_z_11 = r9_z_9 + r9_z_10;  /* F82 */
    const int64_t r9_z_12 = (int64_t)r7_y * A1_x_negated;  /* F82 */
    const int64_t r9_z_13 = r9_z_11 + r9_z_12;  /* F82 */
    const int64_t r9_z_14 = (int64_t)r6_w * A2_z;  /* F82 */
    const int64_t r9_z_15 = r9_z_13 + r9_z_14;  /* F82 */
    const int64_t r9_z_16 = (int64_t)r6_x * A2_y;  /* F82 */
    const int64_t r9_z_17 = r9_z_15 + r9_z_16;  /* F82 */
    const int64_t r9_z_18 = (int64_t)r6_y * A2_x_negated;  /* F82 */
    const int64_t r9_z_19 = r9_z_17 + r9_z_18;  /* F82 */
    const int32_t r9_z_20 = round_30(r9_z_19);  /* F52, |x| <= 1.09e-07 */
    const int64_t r9_w_21 = (int64_t)954437177 /* 1/9 */ * r9_w_20;  /* F85 */
    const int32_t r9_w = round_32(r9_w_21);  /* F53, |x| <= 4.25e-09 */
    const int64_t r9_x_21 = (int64_t)954437177 /* 1/9 */ * r9_x_20;  /* F85 */
    const int32_t r9_x = round_32(r9_x_21);  /* F53, |x| <= 4.25e-09 */
    const int64_t r9_y_21 = (int64_t)954437177 /* 1/9 */ * r9_y_20;  /* F85 */
    const int32_t r9_y = round_32(r9_y_21);  /* F53, |x| <= 4.25e-09 */
    const int64_t r9_z_21 = (int64_t)954437177 /* 1/9 */ * r9_z_20;  /* F85 */
    const int32_t r9_z = round_32(r9_z_21);  /* F53, |x| <= 4.25e-09 */

    /* r_10 = 1/10 sum_j r_(10-1-j) (x) A_j   [xu2019 (7)] */
    const int64_t r10_x_1 = (int64_t)r9_w * A0_x;  /* F87 */
    const int64_t r10_x_2 = r10_x_1 * INT64_C(4);  /* F89 */
    const int64_t r10_x_3 = (int64_t)r9_y * A0_z;  /* F87 */
    const int64_t r10_x_4 = r10_x_3 * INT64_C(4);  /* F89 */
    const int64_t r10_x_5 = r10_x_2 + r10_x_4;  /* F89 */
    const int64_t r10_x_6 = (int64_t)r9_z * A0_y_negated;  /* F87 */
    const int64_t r10_x_7 = r10_x_6 * INT64_C(4);  /* F89 */
    const int64_t r10_x_8 = r10_x_5 + r10_x_7;  /* F89 */
    const int64_t r10_x_9 = (int64_t)r8_w * A1_x;  /* F89 */
    const int64_t r10_x_10 = r10_x_8 + r10_x_9;  /* F89 */
    const int64_t r10_x_11 = (int64_t)r8_y * A1_z;  /* F89 */
    const int64_t r10_x_12 = r10_x_10 + r10_x_11;  /* F89 */
    const int64_t r10_x_13 = (int64_t)r8_z * A1_y_negated;  /* F89 */
    const int64_t r10_x_14 = r10_x_12 + r10_x_13;  /* F89 */
    const int64_t r10_x_15 = (int64_t)r7_w * A2_x;  /* F83 */
    const int64_t r10_x_16 = r10_x_15 * INT64_C(64);  /* F89 */
    const int64_t r10_x_17 = r10_x_14 + r10_x_16;  /* F89 */
    const int64_t r10_x_18 = (int64_t)r7_y * A2_z;  /* F83 */
    const int64_t r10_x_19 = r10_x_18 * INT64_C(64);  /* F89 */
    const int64_t r10_x_20 = r10_x_17 + r10_x_19;  /* F89 */
    const int64_t r10_x_21 = (int64_t)r7_z * A2_y_negated;  /* F83 */
    const int64_t r10_x_22 = r10_x_21 * INT64_C(64);  /* F89 */
    const int64_t r10_x_23 = r10_x_20 + r10_x_22;  /* F89 */
    const int32_t r10_x_24 = round_32(r10_x_23);  /* F57, |x| <= 1.04e-08 */
    const int64_t r10_y_1 = (int64_t)r9_w * A0_y;  /* F87 */
    const int64_t r10_y_2 = r10_y_1 * INT64_C(4);  /* F89 */
    const int64_t r10_y_3 = (int64_t)r9_z * A0_x;  /* F87 */
    const int64_t r10_y_4 = r10_y_3 * INT64_C(4);  /* F89 */
    const int64_t r10_y_5 = r10_y_2 + r10_y_4;  /* F89 */
    const int64_t r10_y_6 = (int64_t)r9_x * A0_z_negated;  /* F87 */
    const int64_t r10_y_7 = r10_y_6 * INT64_C(4);  /* F89 */
    const int64_t r10_y_8 = r10_y_5 + r10_y_7;  /* F89 */
    const int64_t r10_y_9 = (int64_t)r8_w * A1_y;  /* F89 */
    const int64_t r10_y_10 = r10_y_8 + r10_y_9;  /* F89 */
    const int64_t r10_y_11 = (int64_t)r8_z * A1_x;  /* F89 */
    const int64_t r10_y_12 = r10_y_10 + r10_y_11;  /* F89 */
    const int64_t r10_y_13 = (int64_t)r8_x * A1_z_negated;  /* F89 */
    const int64_t r10_y_14 = r10_y_12 + r10_y_13;  /* F89 */
    const int64_t r10_y_15 = (int64_t)r7_w * A2_y;  /* F83 */
    const int64_t r10_y_16 = r10_y_15 * INT64_C(64);  /* F89 */
    const int64_t r10_y_17 = r10_y_14 + r10_y_16;  /* F89 */
    const int64_t r10_y_18 = (int64_t)r7_z * A2_x;  /* F83 */
    const int64_t r10_y_19 = r10_y_18 * INT64_C(64);  /* F89 */
    const int64_t r10_y_20 = r10_y_17 + r10_y_19;  /* F89 */
    const int64_t r10_y_21 = (int64_t)r7_x * A2_z_negated;  /* F83 */
    const int64_t r10_y_22 = r10_y_21 * INT64_C(64);  /* F89 */
    const int64_t r10_y_23 = r10_y_20 + r10_y_22;  /* F89 */
    const int32_t r10_y_24 = round_32(r10_y_23);  /* F57, |x| <= 1.04e-08 */
    const int64_t r10_w_1 = (int64_t)r9_x * A0_x_negated;  /* F87 */
    const int64_t r10_w_2 = r10_w_1 * INT64_C(4);  /* F89 */
    const int64_t r10_w_3 = (int64_t)r9_y * A0_y_negated;  /* F87 */
    const int64_t r10_w_4 = r10_w_3 * INT64_C(4);  /* F89 */
    const int64_t r10_w_5 = r10_w_2 + r10_w_4;  /* F89 */
    const int64_t r10_w_6 = (int64_t)r9_z * A0_z_negated;  /* F87 */
    const int64_t r10_w_7 = r10_w_6 * INT64_C(4);  /* F89 */
    const int64_t r10_w_8 = r10_w_5 + r10_w_7;  /* F89 */
    const int64_t r10_w_9 = (int64_t)r8_x * A1_x_negated;  /* F89 */
    const int64_t r10_w_10 = r10_w_8 + r10_w_9;  /* F89 */
    const int64_t r10_w_11 = (int64_t)r8_y * A1_y_negated;  /* F89 */
    const int64_t r10_w_12 = r10_w_10 + r10_w_11;  /* F89 */
    const int64_t r10_w_13 = (int64_t)r8_z * A1_z_negated;  /* F89 */
    const int64_t r10_w_14 = r10_w_12 + r10_w_13;  /* F89 */
    const int64_t r10_w_15 = (int64_t)r7_x * A2_x_negated;  /* F83 */
    const int64_t r10_w_16 = r10_w_15 * INT64_C(64);  /* F89 */
    const int64_t r10_w_17 = r10_w_14 + r10_w_16;  /* F89 */
    const int64_t r10_w_18 = (int64_t)r7_y * A2_y_negated;  /* F83 */
    const int64_t r10_w_19 = r10_w_18 * INT64_C(64);  /* F89 */
    const int64_t r10_w_20 = r10_w_17 + r10_w_19;  /* F89 */
    const int64_t r10_w_21 = (int64_t)r7_z * A2_z_negated;  /* F83 */
    const int64_t r10_w_22 = r10_w_21 * INT64_C(64);  /* F89 */
    const int64_t r10_w_23 = r10_w_20 + r10_w_22;  /* F89 */
    const int32_t r10_w_24 = round_32(r10_w_23);  /* F57, |x| <= 1.04e-08 */
    const int64_t r10_z_1 = (int64_t)r9_w * A0_z;  /* F87 */
    const int64_t r10_z_2 = r10_z_1 * INT64_C(4);  /* F89 */
    const int64_t r10_z_3 = (int64_t)r9_x * A0_y;  /* F87 */
    const int64_t r10_z_4 = r10_z_3 * INT64_C(4);  /* F89 */
    const int64_t r10_z_5 = r10_z_2 + r10_z_4;  /* F89 */
    const int64_t r10_z_6 = (int64_t)r9_y * A0_x_negated;  /* F87 */
    const int64_t r10_z_7 = r10_z_6 * INT64_C(4);  /* F89 */
    const int64_t r10_z_8 = r10_z_5 + r10_z_7;  /* F89 */
    const int64_t r10_z_9 = (int64_t)r8_w * A1_z;  /* F89 */
    const int64_t r10_z_10 = r10_z_8 + r10_z_9;  /* F89 */
    const int64_t r10_z_11 = (int64_t)r8_x * A1_y;  /* F89 */
    const int64_t r10_z_12 = r10_z_10 + r10_z_11;  /* F89 */
    const int64_t r10_z_13 = (int64_t)r8_y * A1_x_negated;  /* F89 */
    const int64_t r10_z_14 = r10_z_12 + r10_z_13;  /* F89 */
    const int64_t r10_z_15 = (int64_t)r7_w * A2_z;  /* F83 */
    const int64_t r10_z_16 = r10_z_15 * INT64_C(64);  /* F89 */
    const int64_t r10_z_17 = r10_z_14 + r10_z_16;  /* F89 */
    const int64_t r10_z_18 = (int64_t)r7_x * A2_y;  /* F83 */
    const int64_t r10_z_19 = r10_z_18 * INT64_C(64);  /* F89 */
    const int64_t r10_z_20 = r10_z_17 + r10_z_19;  /* F89 */
    const int64_t r10_z_21 = (int64_t)r7_y * A2_x_negated;  /* F83 */
    const int64_t r10_z_22 = r10_z_21 * INT64_C(64);  /* F89 */
    const int64_t r10_z_23 = r10_z_20 + r10_z_22;  /* F89 */
    const int32_t r10_z_24 = round_32(r10_z_23);  /* F57, |x| <= 1.04e-08 */
    const int64_t r10_x_25 = (int64_t)858993459 /* 1/10 */ * r10_x_24;  /* F90 */
    const int32_t r10_x = round_32(r10_x_25);  /* F58, |x| <= 3.63e-10 */
    const int64_t v_x_1 = A0_x * INT64_C(16777216);  /* F58 */
    const int64_t v_x_2 = A1_x * INT64_C(4194304);  /* F58 */
    const int64_t v_x_3 = v_x_1 + v_x_2;  /* F58 */
    const int64_t v_x_4 = r3_x * INT64_C(1048576);  /* F58 */
    const int64_t v_x_5 = v_x_3 + v_x_4;  /* F58 */
    const int64_t v_x_6 = r4_x * INT64_C(65536);  /* F58 */
    const int64_t v_x_7 = v_x_5 + v_x_6;  /* F58 */
    const int64_t v_x_8 = r5_x * INT64_C(65536);  /* F58 */
    const int64_t v_x_9 = v_x_7 + v_x_8;  /* F58 */
    const int64_t v_x_10 = r6_x * INT64_C(4096);  /* F58 */
    const int64_t v_x_11 = v_x_9 + v_x_10;  /* F58 */
    const int64_t v_x_12 = r7_x * INT64_C(2048);  /* F58 */
    const int64_t v_x_13 = v_x_11 + v_x_12;  /* F58 */
    const int64_t v_x_14 = r8_x * INT64_C(16);  /* F58 */
    const int64_t v_x_15 = v_x_13 + v_x_14;  /* F58 */
    const int64_t v_x_16 = r9_x * INT64_C(32);  /* F58 */
    const int64_t v_x_17 = v_x_15 + v_x_16;  /* F58 */
    const int64_t v_x_18 = v_x_17 + r10_x;  /* F58 */
    const int32_t v_x = round_24(v_x_18);  /* F34, |x| <= 0.0656 */
    const int64_t r10_y_25 = (int64_t)858993459 /* 1/10 */ * r10_y_24;  /* F90 */
    const int32_t r10_y = round_32(r10_y_25);  /* F58, |x| <= 3.63e-10 */
    const int64_t v_y_1 = A0_y * INT64_C(16777216);  /* F58 */
    const int64_t v_y_2 = A1_y * INT64_C(4194304);  /* F58 */
    const int64_t v_y_3 = v_y_1 + v_y_2;  /* F58 */
    const int64_t v_y_4 = r3_y * INT64_C(1048576);  /* F58 */
    const int64_t v_y_5 = v_y_3 + v_y_4;  /* F58 */
    const int64_t v_y_6 = r4_y * INT64_C(65536);  /* F58 */
    const int64_t v_y_7 = v_y_5 + v_y_6;  /* F58 */
    const int64_t v_y_8 = r5_y * INT64_C(65536);  /* F58 */
    const int64_t v_y_9 = v_y_7 + v_y_8;  /* F58 */
    const int64_t v_y_10 = r6_y * INT64_C(4096);  /* F58 */
    const int64_t v_y_11 = v_y_9 + v_y_10;  /* F58 */
    const int64_t v_y_12 = r7_y * INT64_C(2048);  /* F58 */
    const int64_t v_y_13 = v_y_11 + v_y_12;  /* F58 */
    const int64_t v_y_14 = r8_y * INT64_C(16);  /* F58 */
    const int64_t v_y_15 = v_y_13 + v_y_14;  /* F58 */
    const int64_t v_y_16 = r9_y * INT64_C(32);  /* F58 */
    const int64_t v_y_17 = v_y_15 + v_y_16;  /* F58 */
    const int64_t v_y_18 = v_y_17 + r10_y;  /* F58 */
    const int32_t v_y = round_24(v_y_18);  /* F34, |x| <= 0.0656 */
    const int64_t r10_z_25 = (int64_t)858993459 /* 1/10 */ * r10_z_24;  /* F90 */
    const int32_t r10_z = round_32(r10_z_25);  /* F58, |x| <= 3.63e-10 */
    const int64_t v_z_1 = A0_z * INT64_C(16777216);  /* F58 */
    const int64_t v_z_2 = A1_z * INT64_C(4194304);  /* F58 */
    const int64_t v_z_3 = v_z_1 + v_z_2;  /* F58 */
    const int64_t v_z_4 = r3_z * INT64_C(1048576);  /* F58 */
    const int64_t v_z_5 = v_z_3 + v_z_4;  /* F58 */
    const int64_t v_z_6 = r4_z * INT64_C(65536);  /* F58 */
    const int64_t v_z_7 = v_z_5 + v_z_6;  /* F58 */
    const int64_t v_z_8 = r5_z * INT64_C(65536);  /* F58 */
    const int64_t v_z_9 = v_z_7 + v_z_8;  /* F58 */
    const int64_t v_z_10 = r6_z * INT64_C(4096);  /* F58 */
    const int64_t v_z_11 = v_z_9 + v_z_10;  /* F58 */
    const int64_t v_z_12 = r7_z * INT64_C(2048);  /* F58 */
    const int64_t v_z_13 = v_z_11 + v_z_12;  /* F58 */
    const int64_t v_z_14 = r8_z * INT64_C(16);  /* F58 */
    const int64_t v_z_15 = v_z_13 + v_z_14;  /* F58 */
    const int64_t v_z_16 = r9_z * INT64_C(32);  /* F58 */
    const int64_t v_z_17 = v_z_15 + v_z_16;  /* F58 */
    const int64_t v_z_18 = v_z_17 + r10_z;  /* F58 */
    const int32_t v_z = round_24(v_z_18);  /* F34, |x| <= 0.0656 */
    const int64_t r10_w_25 = (int64_t)858993459 /* 1/10 */ * r10_w_24;  /* F90 */
    const int32_t r10_w = round_32(r10_w_25);  /* F58, |x| <= 3.63e-10 */

    /* a = u + e */
    const int64_t a_1 = r2_w * INT64_C(16777216);  /* F61 */
    const int64_t a_2 = r3_w * INT64_C(8388608);  /* F61 */
    const int64_t a_3 = a_1 + a_2;  /* F61 */
    const int64_t a_4 = r4_w * INT64_C(1048576);  /* F61 */
    const int64_t a_5 = a_3 + a_4;  /* F61 */
    const int64_t a_6 = r5_w * INT64_C(1048576);  /* F61 */
    const int64_t a_7 = a_5 + a_6;  /* F61 */
    const int64_t a_8 = r6_w * INT64_C(32768);  /* F61 */
    const int64_t a_9 = a_7 + a_8;  /* F61 */
    const int64_t a_10 = r7_w * INT64_C(16384);  /* F61 */
    const int64_t a_11 = a_9 + a_10;  /* F61 */
    const int64_t a_12 = r8_w * INT64_C(128);  /* F61 */
    const int64_t a_13 = a_11 + a_12;  /* F61 */
    const int64_t a_14 = r9_w * INT64_C(256);  /* F61 */
    const int64_t a_15 = a_13 + a_14;  /* F61 */
    const int64_t a_16 = r10_w * INT64_C(8);  /* F61 */
    const int64_t a_17 = a_15 + a_16;  /* F61 */
    const int64_t a_18 = a_17 + INT64_C(1152921504606846976) /* 1/2 */;  /* F61 */

    /* attitude and input */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.02 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.02 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.02 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.02 */

    /* a = u + e */
    const int64_t a_19 = (int64_t)q_w * q_w;  /* F60 */
    const int64_t a_20 = (int64_t)q_x * q_x;  /* F60 */
    const int64_t a_21 = a_19 + a_20;  /* F61 */
    const int64_t a_22 = (int64_t)q_y * q_y;  /* F60 */
    const int64_t a_23 = a_21 + a_22;  /* F61 */
    const int64_t a_24 = (int64_t)q_z * q_z;  /* F60 */
    const int64_t a_25 = a_23 + a_24;  /* F61 */
    const int64_t a_26 = a_18 - a_25;  /* F61 */
    const int32_t a = round_26(a_26);  /* F35, |x| <= 0.0221 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t q_x_negated = -q_x;  /* F30 */
    const int32_t q_y_negated = -q_y;  /* F30 */
    const int32_t q_z_negated = -q_z;  /* F30 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F65 */
    const int64_t dq_w_2 = (int64_t)q_x_negated * v_x;  /* F64 */
    const int64_t dq_w_3 = dq_w_2 * INT64_C(2);  /* F65 */
    const int64_t dq_w_4 = dq_w_1 + dq_w_3;  /* F65 */
    const int64_t dq_w_5 = (int64_t)q_y_negated * v_y;  /* F64 */
    const int64_t dq_w_6 = dq_w_5 * INT64_C(2);  /* F65 */
    const int64_t dq_w_7 = dq_w_4 + dq_w_6;  /* F65 */
    const int64_t dq_w_8 = (int64_t)q_z_negated * v_z;  /* F64 */
    const int64_t dq_w_9 = dq_w_8 * INT64_C(2);  /* F65 */
    const int64_t dq_w_10 = dq_w_7 + dq_w_9;  /* F65 */
    const int32_t dq_w = round_35(dq_w_10);  /* F30, |x| <= 0.141 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.02 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F64 */
    const int64_t dq_x_2 = dq_x_1 * INT64_C(2);  /* F65 */
    const int64_t dq_x_3 = (int64_t)q_x * a;  /* F65 */
    const int64_t dq_x_4 = dq_x_2 + dq_x_3;  /* F65 */
    const int64_t dq_x_5 = (int64_t)q_y * v_z;  /* F64 */
    const int64_t dq_x_6 = dq_x_5 * INT64_C(2);  /* F65 */
    const int64_t dq_x_7 = dq_x_4 + dq_x_6;  /* F65 */
    const int64_t dq_x_8 = (int64_t)q_z_negated * v_y;  /* F64 */
    const int64_t dq_x_9 = dq_x_8 * INT64_C(2);  /* F65 */
    const int64_t dq_x_10 = dq_x_7 + dq_x_9;  /* F65 */
    const int32_t dq_x = round_35(dq_x_10);  /* F30, |x| <= 0.141 */

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.02 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F64 */
    const int64_t dq_y_2 = dq_y_1 * INT64_C(2);  /* F65 */
    const int64_t dq_y_3 = (int64_t)q_y * a;  /* F65 */
    const int64_t dq_y_4 = dq_y_2 + dq_y_3;  /* F65 */
    const int64_t dq_y_5 = (int64_t)q_z * v_x;  /* F64 */
    const int64_t dq_y_6 = dq_y_5 * INT64_C(2);  /* F65 */
    const int64_t dq_y_7 = dq_y_4 + dq_y_6;  /* F65 */
    const int64_t dq_y_8 = (int64_t)q_x_negated * v_z;  /* F64 */
    const int64_t dq_y_9 = dq_y_8 * INT64_C(2);  /* F65 */
    const int64_t dq_y_10 = dq_y_7 + dq_y_9;  /* F65 */
    const int32_t dq_y = round_35(dq_y_10);  /* F30, |x| <= 0.141 */

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.02 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F64 */
    const int64_t dq_z_2 = dq_z_1 * INT64_C(2);  /* F65 */
    const int64_t dq_z_3 = (int64_t)q_z * a;  /* F65 */
    const int64_t dq_z_4 = dq_z_2 + dq_z_3;  /* F65 */
    const int64_t dq_z_5 = (int64_t)q_x * v_y;  /* F64 */
    const int64_t dq_z_6 = dq_z_5 * INT64_C(2);  /* F65 */
    const int64_t dq_z_7 = dq_z_4 + dq_z_6;  /* F65 */
    const int64_t dq_z_8 = (int64_t)q_y_negated * v_x;  /* F64 */
    const int64_t dq_z_9 = dq_z_8 * INT64_C(2);  /* F65 */
    const int64_t dq_z_10 = dq_z_7 + dq_z_9;  /* F65 */
    const int32_t dq_z = round_35(dq_z_10);  /* F30, |x| <= 0.141 */

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.02 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void quaternion_taylor_3_10_fixed32_quaternion(
    const quaternion_taylor_3_10_fixed32_state *state, int32_t q_nb[4])
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
