/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_fixed32
 *
 * qcone 0.1.0, design dcm_taylor_3_10_fixed32, SHA-256 of the design
 * 0bb560cbd17565042464e7d9c47312e8a83259d92141a7c74adc62632cb061e6
 *
 * algorithm:   dcm-taylor-3-10, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      xu2019 (10) to (13), (11) and (13) corrected; xu2019 (11) multiplies from the wrong
 *              side; xu2019 (13) lacks the constants 1, 2, 6
 * equation:    v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j, row by row
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad;
 *              length of a row of C, less 1, <= 0.22 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 1.2e-08 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  78 of 159 rounded sums of products drop a whole word, 78 before formats were
 *              searched for that; of one update's errors in the first order it made 2.7e-08 of
 *              2.7e-08
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      473       0  285       197       0       0     0     0     0       0      0
 * update shared          399      20  252       179       0       0     0     0     0       0      0
 * update emitted         399       0  345        17      10       0     0     0     0       0    366
 * dcm as-written           0       0    0         0       0       0     0     0     0       0      0
 * dcm shared               0       0    0         0       0       0     0     0     0       0      0
 * dcm emitted              0       0    0         0       0       0     0     0     0       0      0
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "dcm_taylor_3_10_fixed32.h"

#if DCM_TAYLOR_3_10_FIXED32_VERSION != 1
#error "dcm_taylor_3_10_fixed32.h is of another version than this file: generate both again"
#endif

/* x / 2^bits, rounded down, 0 <= bits < 32. */
static inline int32_t shift_right_32(int32_t x, int bits)
{
    return ((((int32_t)-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));
}

/* x, kept from low to high. */
static inline int32_t clamp_32(int32_t x, int32_t low, int32_t high)
{
    return ((x < low) ? low : ((x > high) ? high : x));
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

/* x / 2^28, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_28(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(134217728)) >> 28);
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

void dcm_taylor_3_10_fixed32_init(dcm_taylor_3_10_fixed32_state *state)
{
    state->c[0] = 1073741824 /* 1 */;
    state->c[1] = 0;
    state->c[2] = 0;
    state->c[3] = 0;
    state->c[4] = 1073741824 /* 1 */;
    state->c[5] = 0;
    state->c[6] = 0;
    state->c[7] = 0;
    state->c[8] = 1073741824 /* 1 */;
}

void dcm_taylor_3_10_fixed32_set_dcm(dcm_taylor_3_10_fixed32_state *state, const int32_t c_nb[9])
{
    /* c_nb, read once */
    const int32_t c_nb_11 = c_nb[0];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_12 = c_nb[1];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_13 = c_nb[2];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_21 = c_nb[3];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_22 = c_nb[4];  /* F30, |x| <= 1.01 */
    const int32_t c_nb_23 = c_nb[5];  /* F30, |x| <= 1.01 */

    /* e_a = (1 - |a|^2)/2 */
    const int64_t e_a_1 = (int64_t)c_nb_11 * c_nb_11;  /* F60 */
    const int64_t e_a_2 = (int64_t)c_nb_12 * c_nb_12;  /* F60 */
    const int64_t e_a_3 = e_a_1 + e_a_2;  /* F61 */
    const int64_t e_a_4 = (int64_t)c_nb_13 * c_nb_13;  /* F60 */
    const int64_t e_a_5 = e_a_3 + e_a_4;  /* F61 */
    const int64_t e_a_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_a_5;  /* F61 */
    const int32_t e_a = round_21(e_a_6);  /* F40, |x| <= 0.000978 */

    /* e_b = (1 - |b|^2)/2 */
    const int64_t e_b_1 = (int64_t)c_nb_21 * c_nb_21;  /* F60 */
    const int64_t e_b_2 = (int64_t)c_nb_22 * c_nb_22;  /* F60 */
    const int64_t e_b_3 = e_b_1 + e_b_2;  /* F61 */
    const int64_t e_b_4 = (int64_t)c_nb_23 * c_nb_23;  /* F60 */
    const int64_t e_b_5 = e_b_3 + e_b_4;  /* F61 */
    const int64_t e_b_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_b_5;  /* F61 */
    const int32_t e_b = round_29(e_b_6);  /* F32, |x| <= 0.000978 */

    /* e_ab = a . b */
    const int64_t e_ab_1 = (int64_t)c_nb_11 * c_nb_21;  /* F60 */
    const int64_t e_ab_2 = (int64_t)c_nb_12 * c_nb_22;  /* F60 */
    const int64_t e_ab_3 = e_ab_1 + e_ab_2;  /* F60 */
    const int64_t e_ab_4 = (int64_t)c_nb_13 * c_nb_23;  /* F60 */
    const int64_t e_ab_5 = e_ab_3 + e_ab_4;  /* F60 */
    const int32_t e_ab = round_30(e_ab_5);  /* F30, |x| <= 1.01 */

    /* a_next = a + e_a a */
    const int64_t a_next_x_part_1 = (int64_t)e_a * c_nb_11;  /* F70 */
    const int32_t a_next_x_part = round_30(a_next_x_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t a_next_x_fine = round_short_10(a_next_x_part);  /* F30 */
    const int32_t a_next_x = a_next_x_fine + c_nb_11;  /* F30, |x| <= 1.01 */
    const int64_t a_next_y_part_1 = (int64_t)e_a * c_nb_12;  /* F70 */
    const int32_t a_next_y_part = round_30(a_next_y_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t a_next_y_fine = round_short_10(a_next_y_part);  /* F30 */
    const int32_t a_next_y = a_next_y_fine + c_nb_12;  /* F30, |x| <= 1.01 */
    const int64_t a_next_z_part_1 = (int64_t)e_a * c_nb_13;  /* F70 */
    const int32_t a_next_z_part = round_30(a_next_z_part_1);  /* F40, |x| <= 0.000978 */
    const int32_t a_next_z_fine = round_short_10(a_next_z_part);  /* F30 */
    const int32_t a_next_z = a_next_z_fine + c_nb_13;  /* F30, |x| <= 1.01 */

    /* b_next = b + e_b b - e_ab a */
    const int32_t e_ab_negated = -e_ab;  /* F30 */
    const int64_t b_next_x_part_1 = (int64_t)e_b * c_nb_21;  /* F62 */
    const int64_t b_next_x_part_2 = (int64_t)e_ab_negated * c_nb_11;  /* F60 */
    const int64_t b_next_x_part_3 = b_next_x_part_2 * INT64_C(4);  /* F62 */
    const int64_t b_next_x_part_4 = b_next_x_part_1 + b_next_x_part_3;  /* F62 */
    const int32_t b_next_x_part = round_32(b_next_x_part_4);  /* F30, |x| <= 1.01 */
    const int64_t b_next_x_1 = (int64_t)c_nb_21 + b_next_x_part;  /* F30 */
    const int32_t b_next_x = (int32_t)b_next_x_1;  /* F30, |x| <= 1.01 */
    const int64_t b_next_y_part_1 = (int64_t)e_b * c_nb_22;  /* F62 */
    const int64_t b_next_y_part_2 = (int64_t)e_ab_negated * c_nb_12;  /* F60 */
    const int64_t b_next_y_part_3 = b_next_y_part_2 * INT64_C(4);  /* F62 */
    const int64_t b_next_y_part_4 = b_next_y_part_1 + b_next_y_part_3;  /* F62 */
    const int32_t b_next_y_part = round_32(b_next_y_part_4);  /* F30, |x| <= 1.01 */
    const int64_t b_next_y_1 = (int64_t)c_nb_22 + b_next_y_part;  /* F30 */
    const int32_t b_next_y = (int32_t)b_next_y_1;  /* F30, |x| <= 1.01 */
    const int64_t b_next_z_part_1 = (int64_t)e_b * c_nb_23;  /* F62 */
    const int64_t b_next_z_part_2 = (int64_t)e_ab_negated * c_nb_13;  /* F60 */
    const int64_t b_next_z_part_3 = b_next_z_part_2 * INT64_C(4);  /* F62 */
    const int64_t b_next_z_part_4 = b_next_z_part_1 + b_next_z_part_3;  /* F62 */
    const int32_t b_next_z_part = round_32(b_next_z_part_4);  /* F30, |x| <= 1.01 */
    const int64_t b_next_z_1 = (int64_t)c_nb_23 + b_next_z_part;  /* F30 */
    const int32_t b_next_z = (int32_t)b_next_z_1;  /* F30, |x| <= 1.01 */

    /* c_next = a_next x b_next */
    const int64_t c_next_x_1 = (int64_t)a_next_y * b_next_z;  /* F60 */
    const int64_t c_next_x_2 = (int64_t)a_next_z * b_next_y;  /* F60 */
    const int64_t c_next_x_3 = c_next_x_1 - c_next_x_2;  /* F60 */
    const int32_t c_next_x = round_30(c_next_x_3);  /* F30, |x| <= 1.01 */
    const int64_t c_next_y_1 = (int64_t)a_next_z * b_next_x;  /* F60 */
    const int64_t c_next_y_2 = (int64_t)a_next_x * b_next_z;  /* F60 */
    const int64_t c_next_y_3 = c_next_y_1 - c_next_y_2;  /* F60 */
    const int32_t c_next_y = round_30(c_next_y_3);  /* F30, |x| <= 1.01 */
    const int64_t c_next_z_1 = (int64_t)a_next_x * b_next_y;  /* F60 */
    const int64_t c_next_z_2 = (int64_t)a_next_y * b_next_x;  /* F60 */
    const int64_t c_next_z_3 = c_next_z_1 - c_next_z_2;  /* F60 */
    const int32_t c_next_z = round_30(c_next_z_3);  /* F30, |x| <= 1.01 */

    /* store */
    state->c[0] = a_next_x;
    state->c[1] = a_next_y;
    state->c[2] = a_next_z;
    state->c[3] = b_next_x;
    state->c[4] = b_next_y;
    state->c[5] = b_next_z;
    state->c[6] = c_next_x;
    state->c[7] = c_next_y;
    state->c[8] = c_next_z;
}

void dcm_taylor_3_10_fixed32_update(dcm_taylor_3_10_fixed32_state *state, const int32_t dtheta[9])
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
    const int32_t W0_z_1 = dtheta2_z - dtheta1_z;  /* F34, |x| <= 0.00388 */
    const int32_t W0_y_1 = dtheta2_y - dtheta1_y;  /* F34, |x| <= 0.00388 */
    const int32_t W0_x_1 = dtheta2_x - dtheta1_x;  /* F34, |x| <= 0.00388 */
    const int32_t W0_z_2 = dtheta2_z + W0_z_1;  /* F34 */
    const int32_t W0_z_3 = dtheta3_z - W0_z_2;  /* F34, |x| <= 0.000647 */
    const int32_t W0_y_2 = dtheta2_y + W0_y_1;  /* F34 */
    const int32_t W0_y_3 = dtheta3_y - W0_y_2;  /* F34, |x| <= 0.000647 */
    const int32_t W0_x_2 = dtheta2_x + W0_x_1;  /* F34 */
    const int32_t W0_x_3 = dtheta3_x - W0_x_2;  /* F34, |x| <= 0.000647 */

    /* W_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    const int64_t W0_x_4 = (int64_t)3 /* 3 */ * dtheta1_x;  /* F34 */
    const int64_t W0_x_5 = W0_x_4 * INT64_C(2);  /* F35 */
    const int64_t W0_x_6 = W0_x_3 * INT64_C(2);  /* F35 */
    const int64_t W0_x_7 = W0_x_5 + W0_x_6;  /* F35 */
    const int64_t W0_x_8 = (int64_t)3 /* 3/2 */ * W0_x_1;  /* F35 */
    const int64_t W0_x_9 = W0_x_7 - W0_x_8;  /* F35 */
    const int32_t W0_x = round_1(W0_x_9);  /* F34, |x| <= 0.107 */
    const int64_t W0_y_4 = (int64_t)3 /* 3 */ * dtheta1_y;  /* F34 */
    const int64_t W0_y_5 = W0_y_4 * INT64_C(2);  /* F35 */
    const int64_t W0_y_6 = W0_y_3 * INT64_C(2);  /* F35 */
    const int64_t W0_y_7 = W0_y_5 + W0_y_6;  /* F35 */
    const int64_t W0_y_8 = (int64_t)3 /* 3/2 */ * W0_y_1;  /* F35 */
    const int64_t W0_y_9 = W0_y_7 - W0_y_8;  /* F35 */
    const int32_t W0_y = round_1(W0_y_9);  /* F34, |x| <= 0.107 */
    const int64_t W0_z_4 = (int64_t)3 /* 3 */ * dtheta1_z;  /* F34 */
    const int64_t W0_z_5 = W0_z_4 * INT64_C(2);  /* F35 */
    const int64_t W0_z_6 = W0_z_3 * INT64_C(2);  /* F35 */
    const int64_t W0_z_7 = W0_z_5 + W0_z_6;  /* F35 */
    const int64_t W0_z_8 = (int64_t)3 /* 3/2 */ * W0_z_1;  /* F35 */
    const int64_t W0_z_9 = W0_z_7 - W0_z_8;  /* F35 */
    const int32_t W0_z = round_1(W0_z_9);  /* F34, |x| <= 0.107 */
    const int64_t W1_x_1 = (int64_t)9 /* 9 */ * W0_x_1;  /* F34 */
    const int64_t W1_x_2 = (int64_t)9 /* 9 */ * W0_x_3;  /* F34 */
    const int64_t W1_x_3 = W1_x_1 - W1_x_2;  /* F34 */
    const int32_t W1_x = (int32_t)W1_x_3;  /* F34, |x| <= 0.0408 */
    const int64_t W1_y_1 = (int64_t)9 /* 9 */ * W0_y_1;  /* F34 */
    const int64_t W1_y_2 = (int64_t)9 /* 9 */ * W0_y_3;  /* F34 */
    const int64_t W1_y_3 = W1_y_1 - W1_y_2;  /* F34 */
    const int32_t W1_y = (int32_t)W1_y_3;  /* F34, |x| <= 0.0408 */
    const int64_t W1_z_1 = (int64_t)9 /* 9 */ * W0_z_1;  /* F34 */
    const int64_t W1_z_2 = (int64_t)9 /* 9 */ * W0_z_3;  /* F34 */
    const int64_t W1_z_3 = W1_z_1 - W1_z_2;  /* F34 */
    const int32_t W1_z = (int32_t)W1_z_3;  /* F34, |x| <= 0.0408 */
    const int64_t W2_x_1 = (int64_t)27 /* 27/2 */ * W0_x_3;  /* F35 */
    const int32_t W2_x = (int32_t)W2_x_1;  /* F35, |x| <= 0.00873 */
    const int64_t W2_y_1 = (int64_t)27 /* 27/2 */ * W0_y_3;  /* F35 */
    const int32_t W2_y = (int32_t)W2_y_1;  /* F35, |x| <= 0.00873 */
    const int64_t W2_z_1 = (int64_t)27 /* 27/2 */ * W0_z_3;  /* F35 */
    const int32_t W2_z = (int32_t)W2_z_1;  /* F35, |x| <= 0.00873 */

    /* a_1 = 1/1 sum_j a_(1-1-j) x W_j   [xu2019 (13)] */
    const int32_t W0_y_negated = -W0_y;  /* F34 */

    /* attitude and input */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.23 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.23 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.23 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.23 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.23 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.23 */

    /* a_1 = 1/1 sum_j a_(1-1-j) x W_j   [xu2019 (13)] */
    const int64_t a1_x_1 = (int64_t)c_12 * W0_z;  /* F64 */
    const int64_t a1_x_2 = (int64_t)c_13 * W0_y_negated;  /* F64 */
    const int64_t a1_x_3 = a1_x_1 + a1_x_2;  /* F64 */
    const int32_t a1_x = round_31(a1_x_3);  /* F33, |x| <= 0.158 */
    const int32_t W0_z_negated = -W0_z;  /* F34 */
    const int64_t a1_y_1 = (int64_t)c_13 * W0_x;  /* F64 */
    const int64_t a1_y_2 = (int64_t)c_11 * W0_z_negated;  /* F64 */
    const int64_t a1_y_3 = a1_y_1 + a1_y_2;  /* F64 */
    const int32_t a1_y = round_31(a1_y_3);  /* F33, |x| <= 0.158 */
    const int32_t W0_x_negated = -W0_x;  /* F34 */
    const int64_t a1_z_1 = (int64_t)c_11 * W0_y;  /* F64 */
    const int64_t a1_z_2 = (int64_t)c_12 * W0_x_negated;  /* F64 */
    const int64_t a1_z_3 = a1_z_1 + a1_z_2;  /* F64 */
    const int32_t a1_z = round_31(a1_z_3);  /* F33, |x| <= 0.158 */

    /* a_2 = 1/2 sum_j a_(2-1-j) x W_j   [xu2019 (13)] */
    const int64_t a2_x_part_1 = (int64_t)a1_y * W0_z;  /* F67 */
    const int64_t a2_x_part_2 = (int64_t)a1_z * W0_y_negated;  /* F67 */
    const int64_t a2_x_part_3 = a2_x_part_1 + a2_x_part_2;  /* F68 */
    const int32_t a2_x_part = round_32(a2_x_part_3);  /* F36, |x| <= 0.0168 */
    const int32_t W1_y_negated = -W1_y;  /* F34 */
    const int64_t a2_x_1 = a2_x_part * INT64_C(536870912);  /* F65 */
    const int64_t a2_x_2 = (int64_t)c_12 * W1_z;  /* F64 */
    const int64_t a2_x_3 = a2_x_1 + a2_x_2;  /* F65 */
    const int64_t a2_x_4 = (int64_t)c_13 * W1_y_negated;  /* F64 */
    const int64_t a2_x_5 = a2_x_3 + a2_x_4;  /* F65 */
    const int32_t a2_x = round_30(a2_x_5);  /* F35, |x| <= 0.0386 */
    const int64_t a2_y_part_1 = (int64_t)a1_z * W0_x;  /* F67 */
    const int64_t a2_y_part_2 = (int64_t)a1_x * W0_z_negated;  /* F67 */
    const int64_t a2_y_part_3 = a2_y_part_1 + a2_y_part_2;  /* F68 */
    const int32_t a2_y_part = round_32(a2_y_part_3);  /* F36, |x| <= 0.0168 */
    const int32_t W1_z_negated = -W1_z;  /* F34 */
    const int64_t a2_y_1 = a2_y_part * INT64_C(536870912);  /* F65 */
    const int64_t a2_y_2 = (int64_t)c_13 * W1_x;  /* F64 */
    const int64_t a2_y_3 = a2_y_1 + a2_y_2;  /* F65 */
    const int64_t a2_y_4 = (int64_t)c_11 * W1_z_negated;  /* F64 */
    const int64_t a2_y_5 = a2_y_3 + a2_y_4;  /* F65 */
    const int32_t a2_y = round_30(a2_y_5);  /* F35, |x| <= 0.0386 */
    const int64_t a2_z_part_1 = (int64_t)a1_x * W0_y;  /* F67 */
    const int64_t a2_z_part_2 = (int64_t)a1_y * W0_x_negated;  /* F67 */
    const int64_t a2_z_part_3 = a2_z_part_1 + a2_z_part_2;  /* F68 */
    const int32_t a2_z_part = round_32(a2_z_part_3);  /* F36, |x| <= 0.0168 */
    const int32_t W1_x_negated = -W1_x;  /* F34 */
    const int64_t a2_z_1 = a2_z_part * INT64_C(536870912);  /* F65 */
    const int64_t a2_z_2 = (int64_t)c_11 * W1_y;  /* F64 */
    const int64_t a2_z_3 = a2_z_1 + a2_z_2;  /* F65 */
    const int64_t a2_z_4 = (int64_t)c_12 * W1_x_negated;  /* F64 */
    const int64_t a2_z_5 = a2_z_3 + a2_z_4;  /* F65 */
    const int32_t a2_z = round_30(a2_z_5);  /* F35, |x| <= 0.0386 */

    /* a_3 = 1/3 sum_j a_(3-1-j) x W_j   [xu2019 (13)] */
    const int64_t a3_x_1 = (int64_t)a2_y * W0_z;  /* F69 */
    const int64_t a3_x_2 = (int64_t)a2_z * W0_y_negated;  /* F69 */
    const int64_t a3_x_3 = a3_x_1 + a3_x_2;  /* F69 */
    const int32_t a3_x_4 = round_32(a3_x_3);  /* F37, |x| <= 0.00822 */
    const int32_t W2_y_negated = -W2_y;  /* F35 */
    const int64_t a3_x_5 = a3_x_4 * INT64_C(1073741824);  /* F67 */
    const int64_t a3_x_6 = (int64_t)a1_y * W1_z;  /* F67 */
    const int64_t a3_x_7 = a3_x_5 + a3_x_6;  /* F67 */
    const int64_t a3_x_8 = (int64_t)a1_z * W1_y_negated;  /* F67 */
    const int64_t a3_x_9 = a3_x_7 + a3_x_8;  /* F67 */
    const int64_t a3_x_10 = (int64_t)c_12 * W2_z;  /* F65 */
    const int64_t a3_x_11 = a3_x_10 * INT64_C(4);  /* F67 */
    const int64_t a3_x_12 = a3_x_9 + a3_x_11;  /* F67 */
    const int64_t a3_x_13 = (int64_t)c_13 * W2_y_negated;  /* F65 */
    const int64_t a3_x_14 = a3_x_13 * INT64_C(4);  /* F67 */
    const int64_t a3_x_15 = a3_x_12 + a3_x_14;  /* F67 */
    const int32_t a3_x_16 = round_32(a3_x_15);  /* F35, |x| <= 0.0424 */
    const int64_t a3_y_1 = (int64_t)a2_z * W0_x;  /* F69 */
    const int64_t a3_y_2 = (int64_t)a2_x * W0_z_negated;  /* F69 */
    const int64_t a3_y_3 = a3_y_1 + a3_y_2;  /* F69 */
    const int32_t a3_y_4 = round_32(a3_y_3);  /* F37, |x| <= 0.00822 */
    const int32_t W2_z_negated = -W2_z;  /* F35 */
    const int64_t a3_y_5 = a3_y_4 * INT64_C(1073741824);  /* F67 */
    const int64_t a3_y_6 = (int64_t)a1_z * W1_x;  /* F67 */
    const int64_t a3_y_7 = a3_y_5 + a3_y_6;  /* F67 */
    const int64_t a3_y_8 = (int64_t)a1_x * W1_z_negated;  /* F67 */
    const int64_t a3_y_9 = a3_y_7 + a3_y_8;  /* F67 */
    const int64_t a3_y_10 = (int64_t)c_13 * W2_x;  /* F65 */
    const int64_t a3_y_11 = a3_y_10 * INT64_C(4);  /* F67 */
    const int64_t a3_y_12 = a3_y_9 + a3_y_11;  /* F67 */
    const int64_t a3_y_13 = (int64_t)c_11 * W2_z_negated;  /* F65 */
    const int64_t a3_y_14 = a3_y_13 * INT64_C(4);  /* F67 */
    const int64_t a3_y_15 = a3_y_12 + a3_y_14;  /* F67 */
    const int32_t a3_y_16 = round_32(a3_y_15);  /* F35, |x| <= 0.0424 */
    const int64_t a3_z_1 = (int64_t)a2_x * W0_y;  /* F69 */
    const int64_t a3_z_2 = (int64_t)a2_y * W0_x_negated;  /* F69 */
    const int64_t a3_z_3 = a3_z_1 + a3_z_2;  /* F69 */
    const int32_t a3_z_4 = round_32(a3_z_3);  /* F37, |x| <= 0.00822 */
    const int32_t W2_x_negated = -W2_x;  /* F35 */
    const int64_t a3_z_5 = a3_z_4 * INT64_C(1073741824);  /* F67 */
    const int64_t a3_z_6 = (int64_t)a1_x * W1_y;  /* F67 */
    const int64_t a3_z_7 = a3_z_5 + a3_z_6;  /* F67 */
    const int64_t a3_z_8 = (int64_t)a1_y * W1_x_negated;  /* F67 */
    const int64_t a3_z_9 = a3_z_7 + a3_z_8;  /* F67 */
    const int64_t a3_z_10 = (int64_t)c_11 * W2_y;  /* F65 */
    const int64_t a3_z_11 = a3_z_10 * INT64_C(4);  /* F67 */
    const int64_t a3_z_12 = a3_z_9 + a3_z_11;  /* F67 */
    const int64_t a3_z_13 = (int64_t)c_12 * W2_x_negated;  /* F65 */
    const int64_t a3_z_14 = a3_z_13 * INT64_C(4);  /* F67 */
    const int64_t a3_z_15 = a3_z_12 + a3_z_14;  /* F67 */
    const int32_t a3_z_16 = round_32(a3_z_15);  /* F35, |x| <= 0.0424 */
    const int64_t a3_x_17 = (int64_t)1431655765 /* 1/3 */ * a3_x_16;  /* F67 */
    const int32_t a3_x = round_31(a3_x_17);  /* F36, |x| <= 0.00766 */
    const int64_t a3_y_17 = (int64_t)1431655765 /* 1/3 */ * a3_y_16;  /* F67 */
    const int32_t a3_y = round_31(a3_y_17);  /* F36, |x| <= 0.00766 */
    const int64_t a3_z_17 = (int64_t)1431655765 /* 1/3 */ * a3_z_16;  /* F67 */
    const int32_t a3_z = round_31(a3_z_17);  /* F36, |x| <= 0.00766 */

    /* a_4 = 1/4 sum_j a_(4-1-j) x W_j   [xu2019 (13)] */
    const int64_t a4_x_1 = (int64_t)a3_y * W0_z;  /* F70 */
    const int64_t a4_x_2 = (int64_t)a3_z * W0_y_negated;  /* F70 */
    const int64_t a4_x_3 = a4_x_1 + a4_x_2;  /* F72 */
    const int64_t a4_x_4 = (int64_t)a2_y * W1_z;  /* F69 */
    const int64_t a4_x_5 = a4_x_4 * INT64_C(2);  /* F72 */
    const int64_t a4_x_6 = a4_x_3 + a4_x_5;  /* F72 */
    const int64_t a4_x_7 = (int64_t)a2_z * W1_y_negated;  /* F69 */
    const int64_t a4_x_8 = a4_x_7 * INT64_C(2);  /* F72 */
    const int64_t a4_x_9 = a4_x_6 + a4_x_8;  /* F72 */
    const int64_t a4_x_10 = (int64_t)a1_y * W2_z;  /* F68 */
    const int64_t a4_x_11 = a4_x_10 * INT64_C(4);  /* F72 */
    const int64_t a4_x_12 = a4_x_9 + a4_x_11;  /* F72 */
    const int64_t a4_x_13 = (int64_t)a1_z * W2_y_negated;  /* F68 */
    const int64_t a4_x_14 = a4_x_13 * INT64_C(4);  /* F72 */
    const int64_t a4_x_15 = a4_x_12 + a4_x_14;  /* F72 */
    const int32_t a4_x = round_32(a4_x_15);  /* F40, |x| <= 0.00104 */
    const int64_t a4_y_1 = (int64_t)a3_z * W0_x;  /* F70 */
    const int64_t a4_y_2 = (int64_t)a3_x * W0_z_negated;  /* F70 */
    const int64_t a4_y_3 = a4_y_1 + a4_y_2;  /* F72 */
    const int64_t a4_y_4 = (int64_t)a2_z * W1_x;  /* F69 */
    const int64_t a4_y_5 = a4_y_4 * INT64_C(2);  /* F72 */
    const int64_t a4_y_6 = a4_y_3 + a4_y_5;  /* F72 */
    const int64_t a4_y_7 = (int64_t)a2_x * W1_z_negated;  /* F69 */
    const int64_t a4_y_8 = a4_y_7 * INT64_C(2);  /* F72 */
    const int64_t a4_y_9 = a4_y_6 + a4_y_8;  /* F72 */
    const int64_t a4_y_10 = (int64_t)a1_z * W2_x;  /* F68 */
    const int64_t a4_y_11 = a4_y_10 * INT64_C(4);  /* F72 */
    const int64_t a4_y_12 = a4_y_9 + a4_y_11;  /* F72 */
    const int64_t a4_y_13 = (int64_t)a1_x * W2_z_negated;  /* F68 */
    const int64_t a4_y_14 = a4_y_13 * INT64_C(4);  /* F72 */
    const int64_t a4_y_15 = a4_y_12 + a4_y_14;  /* F72 */
    const int32_t a4_y = round_32(a4_y_15);  /* F40, |x| <= 0.00104 */
    const int64_t a4_z_1 = (int64_t)a3_x * W0_y;  /* F70 */
    const int64_t a4_z_2 = (int64_t)a3_y * W0_x_negated;  /* F70 */
    const int64_t a4_z_3 = a4_z_1 + a4_z_2;  /* F72 */
    const int64_t a4_z_4 = (int64_t)a2_x * W1_y;  /* F69 */
    const int64_t a4_z_5 = a4_z_4 * INT64_C(2);  /* F72 */
    const int64_t a4_z_6 = a4_z_3 + a4_z_5;  /* F72 */
    const int64_t a4_z_7 = (int64_t)a2_y * W1_x_negated;  /* F69 */
    const int64_t a4_z_8 = a4_z_7 * INT64_C(2);  /* F72 */
    const int64_t a4_z_9 = a4_z_6 + a4_z_8;  /* F72 */
    const int64_t a4_z_10 = (int64_t)a1_x * W2_y;  /* F68 */
    const int64_t a4_z_11 = a4_z_10 * INT64_C(4);  /* F72 */
    const int64_t a4_z_12 = a4_z_9 + a4_z_11;  /* F72 */
    const int64_t a4_z_13 = (int64_t)a1_y * W2_x_negated;  /* F68 */
    const int64_t a4_z_14 = a4_z_13 * INT64_C(4);  /* F72 */
    const int64_t a4_z_15 = a4_z_12 + a4_z_14;  /* F72 */
    const int32_t a4_z = round_32(a4_z_15);  /* F40, |x| <= 0.00104 */

    /* a_5 = 1/5 sum_j a_(5-1-j) x W_j   [xu2019 (13)] */
    const int64_t a5_x_1 = (int64_t)a4_y * W0_z;  /* F74 */
    const int64_t a5_x_2 = (int64_t)a4_z * W0_y_negated;  /* F74 */
    const int64_t a5_x_3 = a5_x_1 + a5_x_2;  /* F74 */
    const int32_t a5_x_4 = round_31(a5_x_3);  /* F43, |x| <= 0.000222 */
    const int64_t a5_x_5 = a5_x_4 * INT64_C(134217728);  /* F70 */
    const int64_t a5_x_6 = (int64_t)a3_y * W1_z;  /* F70 */
    const int64_t a5_x_7 = a5_x_5 + a5_x_6;  /* F70 */
    const int64_t a5_x_8 = (int64_t)a3_z * W1_y_negated;  /* F70 */
    const int64_t a5_x_9 = a5_x_7 + a5_x_8;  /* F70 */
    const int64_t a5_x_10 = (int64_t)a2_y * W2_z;  /* F70 */
    const int64_t a5_x_11 = a5_x_9 + a5_x_10;  /* F70 */
    const int64_t a5_x_12 = (int64_t)a2_z * W2_y_negated;  /* F70 */
    const int64_t a5_x_13 = a5_x_11 + a5_x_12;  /* F70 */
    const int32_t a5_x_14 = round_30(a5_x_13);  /* F40, |x| <= 0.00152 */
    const int64_t a5_y_1 = (int64_t)a4_z * W0_x;  /* F74 */
    const int64_t a5_y_2 = (int64_t)a4_x * W0_z_negated;  /* F74 */
    const int64_t a5_y_3 = a5_y_1 + a5_y_2;  /* F74 */
    const int32_t a5_y_4 = round_31(a5_y_3);  /* F43, |x| <= 0.000222 */
    const int64_t a5_y_5 = a5_y_4 * INT64_C(134217728);  /* F70 */
    const int64_t a5_y_6 = (int64_t)a3_z * W1_x;  /* F70 */
    const int64_t a5_y_7 = a5_y_5 + a5_y_6;  /* F70 */
    const int64_t a5_y_8 = (int64_t)a3_x * W1_z_negated;  /* F70 */
    const int64_t a5_y_9 = a5_y_7 + a5_y_8;  /* F70 */
    const int64_t a5_y_10 = (int64_t)a2_z * W2_x;  /* F70 */
    const int64_t a5_y_11 = a5_y_9 + a5_y_10;  /* F70 */
    const int64_t a5_y_12 = (int64_t)a2_x * W2_z_negated;  /* F70 */
    const int64_t a5_y_13 = a5_y_11 + a5_y_12;  /* F70 */
    const int32_t a5_y_14 = round_30(a5_y_13);  /* F40, |x| <= 0.00152 */
    const int64_t a5_z_1 = (int64_t)a4_x * W0_y;  /* F74 */
    const int64_t a5_z_2 = (int64_t)a4_y * W0_x_negated;  /* F74 */
    const int64_t a5_z_3 = a5_z_1 + a5_z_2;  /* F74 */
    const int32_t a5_z_4 = round_31(a5_z_3);  /* F43, |x| <= 0.000222 */
    const int64_t a5_z_5 = a5_z_4 * INT64_C(134217728);  /* F70 */
    const int64_t a5_z_6 = (int64_t)a3_x * W1_y;  /* F70 */
    const int64_t a5_z_7 = a5_z_5 + a5_z_6;  /* F70 */
    const int64_t a5_z_8 = (int64_t)a3_y * W1_x_negated;  /* F70 */
    const int64_t a5_z_9 = a5_z_7 + a5_z_8;  /* F70 */
    const int64_t a5_z_10 = (int64_t)a2_x * W2_y;  /* F70 */
    const int64_t a5_z_11 = a5_z_9 + a5_z_10;  /* F70 */
    const int64_t a5_z_12 = (int64_t)a2_y * W2_x_negated;  /* F70 */
    const int64_t a5_z_13 = a5_z_11 + a5_z_12;  /* F70 */
    const int32_t a5_z_14 = round_30(a5_z_13);  /* F40, |x| <= 0.00152 */
    const int64_t a5_x_15 = (int64_t)858993459 /* 1/5 */ * a5_x_14;  /* F72 */
    const int32_t a5_x = round_29(a5_x_15);  /* F43, |x| <= 0.000166 */
    const int64_t a5_y_15 = (int64_t)858993459 /* 1/5 */ * a5_y_14;  /* F72 */
    const int32_t a5_y = round_29(a5_y_15);  /* F43, |x| <= 0.000166 */
    const int64_t a5_z_15 = (int64_t)858993459 /* 1/5 */ * a5_z_14;  /* F72 */
    const int32_t a5_z = round_29(a5_z_15);  /* F43, |x| <= 0.000166 */

    /* a_6 = 1/6 sum_j a_(6-1-j) x W_j   [xu2019 (13)] */
    const int64_t a6_x_1 = (int64_t)a5_y * W0_z;  /* F77 */
    const int64_t a6_x_2 = (int64_t)a5_z * W0_y_negated;  /* F77 */
    const int64_t a6_x_3 = a6_x_1 + a6_x_2;  /* F77 */
    const int32_t a6_x_4 = round_32(a6_x_3);  /* F45, |x| <= 3.53e-05 */
    const int64_t a6_x_5 = a6_x_4 * INT64_C(536870912);  /* F74 */
    const int64_t a6_x_6 = (int64_t)a4_y * W1_z;  /* F74 */
    const int64_t a6_x_7 = a6_x_5 + a6_x_6;  /* F74 */
    const int64_t a6_x_8 = (int64_t)a4_z * W1_y_negated;  /* F74 */
    const int64_t a6_x_9 = a6_x_7 + a6_x_8;  /* F74 */
    const int64_t a6_x_10 = (int64_t)a3_y * W2_z;  /* F71 */
    const int64_t a6_x_11 = a6_x_10 * INT64_C(8);  /* F74 */
    const int64_t a6_x_12 = a6_x_9 + a6_x_11;  /* F74 */
    const int64_t a6_x_13 = (int64_t)a3_z * W2_y_negated;  /* F71 */
    const int64_t a6_x_14 = a6_x_13 * INT64_C(8);  /* F74 */
    const int64_t a6_x_15 = a6_x_12 + a6_x_14;  /* F74 */
    const int32_t a6_x_16 = round_32(a6_x_15);  /* F42, |x| <= 0.000254 */
    const int64_t a6_y_1 = (int64_t)a5_z * W0_x;  /* F77 */
    const int64_t a6_y_2 = (int64_t)a5_x * W0_z_negated;  /* F77 */
    const int64_t a6_y_3 = a6_y_1 + a6_y_2;  /* F77 */
    const int32_t a6_y_4 = round_32(a6_y_3);  /* F45, |x| <= 3.53e-05 */
    const int64_t a6_y_5 = a6_y_4 * INT64_C(536870912);  /* F74 */
    const int64_t a6_y_6 = (int64_t)a4_z * W1_x;  /* F74 */
    const int64_t a6_y_7 = a6_y_5 + a6_y_6;  /* F74 */
    const int64_t a6_y_8 = (int64_t)a4_x * W1_z_negated;  /* F74 */
    const int64_t a6_y_9 = a6_y_7 + a6_y_8;  /* F74 */
    const int64_t a6_y_10 = (int64_t)a3_z * W2_x;  /* F71 */
    const int64_t a6_y_11 = a6_y_10 * INT64_C(8);  /* F74 */
    const int64_t a6_y_12 = a6_y_9 + a6_y_11;  /* F74 */
    const int64_t a6_y_13 = (int64_t)a3_x * W2_z_negated;  /* F71 */
    const int64_t a6_y_14 = a6_y_13 * INT64_C(8);  /* F74 */
    const int64_t a6_y_15 = a6_y_12 + a6_y_14;  /* F74 */
    const int32_t a6_y_16 = round_32(a6_y_15);  /* F42, |x| <= 0.000254 */
    const int64_t a6_z_1 = (int64_t)a5_x * W0_y;  /* F77 */
    const int64_t a6_z_2 = (int64_t)a5_y * W0_x_negated;  /* F77 */
    const int64_t a6_z_3 = a6_z_1 + a6_z_2;  /* F77 */
    const int32_t a6_z_4 = round_32(a6_z_3);  /* F45, |x| <= 3.53e-05 */
    const int64_t a6_z_5 = a6_z_4 * INT64_C(536870912);  /* F74 */
    const int64_t a6_z_6 = (int64_t)a4_x * W1_y;  /* F74 */
    const int64_t a6_z_7 = a6_z_5 + a6_z_6;  /* F74 */
    const int64_t a6_z_8 = (int64_t)a4_y * W1_x_negated;  /* F74 */
    const int64_t a6_z_9 = a6_z_7 + a6_z_8;  /* F74 */
    const int64_t a6_z_10 = (int64_t)a3_x * W2_y;  /* F71 */
    const int64_t a6_z_11 = a6_z_10 * INT64_C(8);  /* F74 */
    const int64_t a6_z_12 = a6_z_9 + a6_z_11;  /* F74 */
    const int64_t a6_z_13 = (int64_t)a3_y * W2_x_negated;  /* F71 */
    const int64_t a6_z_14 = a6_z_13 * INT64_C(8);  /* F74 */
    const int64_t a6_z_15 = a6_z_12 + a6_z_14;  /* F74 */
    const int32_t a6_z_16 = round_32(a6_z_15);  /* F42, |x| <= 0.000254 */
    const int64_t a6_x_17 = (int64_t)1431655765 /* 1/6 */ * a6_x_16;  /* F75 */
    const int32_t a6_x = round_29(a6_x_17);  /* F46, |x| <= 2.28e-05 */
    const int64_t a6_y_17 = (int64_t)1431655765 /* 1/6 */ * a6_y_16;  /* F75 */
    const int32_t a6_y = round_29(a6_y_17);  /* F46, |x| <= 2.28e-05 */
    const int64_t a6_z_17 = (int64_t)1431655765 /* 1/6 */ * a6_z_16;  /* F75 */
    const int32_t a6_z = round_29(a6_z_17);  /* F46, |x| <= 2.28e-05 */

    /* a_7 = 1/7 sum_j a_(7-1-j) x W_j   [xu2019 (13)] */
    const int64_t a7_x_1 = (int64_t)a6_y * W0_z;  /* F80 */
    const int64_t a7_x_2 = (int64_t)a6_z * W0_y_negated;  /* F80 */
    const int64_t a7_x_3 = a7_x_1 + a7_x_2;  /* F80 */
    const int32_t a7_x_4 = round_32(a7_x_3);  /* F48, |x| <= 4.85e-06 */
    const int64_t a7_x_5 = a7_x_4 * INT64_C(536870912);  /* F77 */
    const int64_t a7_x_6 = (int64_t)a5_y * W1_z;  /* F77 */
    const int64_t a7_x_7 = a7_x_5 + a7_x_6;  /* F77 */
    const int64_t a7_x_8 = (int64_t)a5_z * W1_y_negated;  /* F77 */
    const int64_t a7_x_9 = a7_x_7 + a7_x_8;  /* F77 */
    const int64_t a7_x_10 = (int64_t)a4_y * W2_z;  /* F75 */
    const int64_t a7_x_11 = a7_x_10 * INT64_C(4);  /* F77 */
    const int64_t a7_x_12 = a7_x_9 + a7_x_11;  /* F77 */
    const int64_t a7_x_13 = (int64_t)a4_z * W2_y_negated;  /* F75 */
    const int64_t a7_x_14 = a7_x_13 * INT64_C(4);  /* F77 */
    const int64_t a7_x_15 = a7_x_12 + a7_x_14;  /* F77 */
    const int32_t a7_x_16 = round_32(a7_x_15);  /* F45, |x| <= 3.65e-05 */
    const int64_t a7_y_1 = (int64_t)a6_z * W0_x;  /* F80 */
    const int64_t a7_y_2 = (int64_t)a6_x * W0_z_negated;  /* F80 */
    const int64_t a7_y_3 = a7_y_1 + a7_y_2;  /* F80 */
    const int32_t a7_y_4 = round_32(a7_y_3);  /* F48, |x| <= 4.85e-06 */
    const int64_t a7_y_5 = a7_y_4 * INT64_C(536870912);  /* F77 */
    const int64_t a7_y_6 = (int64_t)a5_z * W1_x;  /* F77 */
    const int64_t a7_y_7 = a7_y_5 + a7_y_6;  /* F77 */
    const int64_t a7_y_8 = (int64_t)a5_x * W1_z_negated;  /* F77 */
    const int64_t a7_y_9 = a7_y_7 + a7_y_8;  /* F77 */
    const int64_t a7_y_10 = (int64_t)a4_z * W2_x;  /* F75 */
    const int64_t a7_y_11 = a7_y_10 * INT64_C(4);  /* F77 */
    const int64_t a7_y_12 = a7_y_9 + a7_y_11;  /* F77 */
    const int64_t a7_y_13 = (int64_t)a4_x * W2_z_negated;  /* F75 */
    const int64_t a7_y_14 = a7_y_13 * INT64_C(4);  /* F77 */
    const int64_t a7_y_15 = a7_y_12 + a7_y_14;  /* F77 */
    const int32_t a7_y_16 = round_32(a7_y_15);  /* F45, |x| <= 3.65e-05 */
    const int64_t a7_z_1 = (int64_t)a6_x * W0_y;  /* F80 */
    const int64_t a7_z_2 = (int64_t)a6_y * W0_x_negated;  /* F80 */
    const int64_t a7_z_3 = a7_z_1 + a7_z_2;  /* F80 */
    const int32_t a7_z_4 = round_32(a7_z_3);  /* F48, |x| <= 4.85e-06 */
    const int64_t a7_z_5 = a7_z_4 * INT64_C(536870912);  /* F77 */
    const int64_t a7_z_6 = (int64_t)a5_x * W1_y;  /* F77 */
    const int64_t a7_z_7 = a7_z_5 + a7_z_6;  /* F77 */
    const int64_t a7_z_8 = (int64_t)a5_y * W1_x_negated;  /* F77 */
    const int64_t a7_z_9 = a7_z_7 + a7_z_8;  /* F77 */
    const int64_t a7_z_10 = (int64_t)a4_x * W2_y;  /* F75 */
    const int64_t a7_z_11 = a7_z_10 * INT64_C(4);  /* F77 */
    const int64_t a7_z_12 = a7_z_9 + a7_z_11;  /* F77 */
    const int64_t a7_z_13 = (int64_t)a4_y * W2_x_negated;  /* F75 */
    const int64_t a7_z_14 = a7_z_13 * INT64_C(4);  /* F77 */
    const int64_t a7_z_15 = a7_z_12 + a7_z_14;  /* F77 */
    const int32_t a7_z_16 = round_32(a7_z_15);  /* F45, |x| <= 3.65e-05 */
    const int64_t a7_x_17 = (int64_t)1227133513 /* 1/7 */ * a7_x_16;  /* F78 */
    const int32_t a7_x = round_29(a7_x_17);  /* F49, |x| <= 2.82e-06 */
    const int64_t a7_y_17 = (int64_t)1227133513 /* 1/7 */ * a7_y_16;  /* F78 */
    const int32_t a7_y = round_29(a7_y_17);  /* F49, |x| <= 2.82e-06 */
    const int64_t a7_z_17 = (int64_t)1227133513 /* 1/7 */ * a7_z_16;  /* F78 */
    const int32_t a7_z = round_29(a7_z_17);  /* F49, |x| <= 2.82e-06 */

    /* a_8 = 1/8 sum_j a_(8-1-j) x W_j   [xu2019 (13)] */
    const int64_t a8_x_part_1 = (int64_t)a7_y * W0_z;  /* F83 */
    const int64_t a8_x_part_2 = (int64_t)a7_z * W0_y_negated;  /* F83 */
    const int64_t a8_x_part_3 = a8_x_part_1 + a8_x_part_2;  /* F86 */
    const int32_t a8_x_part = round_32(a8_x_part_3);  /* F54, |x| <= 7.5e-08 */
    const int64_t a8_x_1 = a8_x_part * INT64_C(536870912);  /* F83 */
    const int64_t a8_x_2 = (int64_t)a6_y * W1_z;  /* F80 */
    const int64_t a8_x_3 = a8_x_1 + a8_x_2;  /* F83 */
    const int64_t a8_x_4 = (int64_t)a6_z * W1_y_negated;  /* F80 */
    const int64_t a8_x_5 = a8_x_3 + a8_x_4;  /* F83 */
    const int64_t a8_x_6 = (int64_t)a5_y * W2_z;  /* F78 */
    const int64_t a8_x_7 = a8_x_6 * INT64_C(4);  /* F83 */
    const int64_t a8_x_8 = a8_x_5 + a8_x_7;  /* F83 */
    const int64_t a8_x_9 = (int64_t)a5_z * W2_y_negated;  /* F78 */
    const int64_t a8_x_10 = a8_x_9 * INT64_C(4);  /* F83 */
    const int64_t a8_x_11 = a8_x_8 + a8_x_10;  /* F83 */
    const int32_t a8_x = round_31(a8_x_11);  /* F52, |x| <= 3.59e-07 */
    const int64_t a8_y_part_1 = (int64_t)a7_z * W0_x;  /* F83 */
    const int64_t a8_y_part_2 = (int64_t)a7_x * W0_z_negated;  /* F83 */
    const int64_t a8_y_part_3 = a8_y_part_1 + a8_y_part_2;  /* F86 */
    const int32_t a8_y_part = round_32(a8_y_part_3);  /* F54, |x| <= 7.5e-08 */
    const int64_t a8_y_1 = a8_y_part * INT64_C(536870912);  /* F83 */
    const int64_t a8_y_2 = (int64_t)a6_z * W1_x;  /* F80 */
    const int64_t a8_y_3 = a8_y_1 + a8_y_2;  /* F83 */
    const int64_t a8_y_4 = (int64_t)a6_x * W1_z_negated;  /* F80 */
    const int64_t a8_y_5 = a8_y_3 + a8_y_4;  /* F83 */
    const int64_t a8_y_6 = (int64_t)a5_z * W2_x;  /* F78 */
    const int64_t a8_y_7 = a8_y_6 * INT64_C(4);  /* F83 */
    const int64_t a8_y_8 = a8_y_5 + a8_y_7;  /* F83 */
    const int64_t a8_y_9 = (int64_t)a5_x * W2_z_negated;  /* F78 */
    const int64_t a8_y_10 = a8_y_9 * INT64_C(4);  /* F83 */
    const int64_t a8_y_11 = a8_y_8 + a8_y_10;  /* F83 */
    const int32_t a8_y = round_31(a8_y_11);  /* F52, |x| <= 3.59e-07 */
    const int64_t a8_z_part_1 = (int64_t)a7_x * W0_y;  /* F83 */
    const int64_t a8_z_part_2 = (int64_t)a7_y * W0_x_negated;  /* F83 */
    const int64_t a8_z_part_3 = a8_z_part_1 + a8_z_part_2;  /* F86 */
    const int32_t a8_z_part = round_32(a8_z_part_3);  /* F54, |x| <= 7.5e-08 */
    const int64_t a8_z_1 = a8_z_part * INT64_C(536870912);  /* F83 */
    const int64_t a8_z_2 = (int64_t)a6_x * W1_y;  /* F80 */
    const int64_t a8_z_3 = a8_z_1 + a8_z_2;  /* F83 */
    const int64_t a8_z_4 = (int64_t)a6_y * W1_x_negated;  /* F80 */
    const int64_t a8_z_5 = a8_z_3 + a8_z_4;  /* F83 */
    const int64_t a8_z_6 = (int64_t)a5_x * W2_y;  /* F78 */
    const int64_t a8_z_7 = a8_z_6 * INT64_C(4);  /* F83 */
    const int64_t a8_z_8 = a8_z_5 + a8_z_7;  /* F83 */
    const int64_t a8_z_9 = (int64_t)a5_y * W2_x_negated;  /* F78 */
    const int64_t a8_z_10 = a8_z_9 * INT64_C(4);  /* F83 */
    const int64_t a8_z_11 = a8_z_8 + a8_z_10;  /* F83 */
    const int32_t a8_z = round_31(a8_z_11);  /* F52, |x| <= 3.59e-07 */

    /* a_9 = 1/9 sum_j a_(9-1-j) x W_j   [xu2019 (13)] */
    const int64_t a9_x_1 = (int64_t)a8_y * W0_z;  /* F86 */
    const int64_t a9_x_2 = (int64_t)a8_z * W0_y_negated;  /* F86 */
    const int64_t a9_x_3 = a9_x_1 + a9_x_2;  /* F86 */
    const int32_t a9_x_4 = round_32(a9_x_3);  /* F54, |x| <= 7.63e-08 */
    const int64_t a9_x_5 = a9_x_4 * INT64_C(536870912);  /* F83 */
    const int64_t a9_x_6 = (int64_t)a7_y * W1_z;  /* F83 */
    const int64_t a9_x_7 = a9_x_5 + a9_x_6;  /* F83 */
    const int64_t a9_x_8 = (int64_t)a7_z * W1_y_negated;  /* F83 */
    const int64_t a9_x_9 = a9_x_7 + a9_x_8;  /* F83 */
    const int64_t a9_x_10 = (int64_t)a6_y * W2_z;  /* F81 */
    const int64_t a9_x_11 = a9_x_10 * INT64_C(4);  /* F83 */
    const int64_t a9_x_12 = a9_x_9 + a9_x_11;  /* F83 */
    const int64_t a9_x_13 = (int64_t)a6_z * W2_y_negated;  /* F81 */
    const int64_t a9_x_14 = a9_x_13 * INT64_C(4);  /* F83 */
    const int64_t a9_x_15 = a9_x_12 + a9_x_14;  /* F83 */
    const int32_t a9_x_16 = round_32(a9_x_15);  /* F51, |x| <= 7.03e-07 */
    const int64_t a9_y_1 = (int64_t)a8_z * W0_x;  /* F86 */
    const int64_t a9_y_2 = (int64_t)a8_x * W0_z_negated;  /* F86 */
    const int64_t a9_y_3 = a9_y_1 + a9_y_2;  /* F86 */
    const int32_t a9_y_4 = round_32(a9_y_3);  /* F54, |x| <= 7.63e-08 */
    const int64_t a9_y_5 = a9_y_4 * INT64_C(536870912);  /* F83 */
    const int64_t a9_y_6 = (int64_t)a7_z * W1_x;  /* F83 */
    const int64_t a9_y_7 = a9_y_5 + a9_y_6;  /* F83 */
    const int64_t a9_y_8 = (int64_t)a7_x * W1_z_negated;  /* F83 */
    const int64_t a9_y_9 = a9_y_7 + a9_y_8;  /* F83 */
    const int64_t a9_y_10 = (int64_t)a6_z * W2_x;  /* F81 */
    const int64_t a9_y_11 = a9_y_10 * INT64_C(4);  /* F83 */
    const int64_t a9_y_12 = a9_y_9 + a9_y_11;  /* F83 */
    const int64_t a9_y_13 = (int64_t)a6_x * W2_z_negated;  /* F81 */
    const int64_t a9_y_14 = a9_y_13 * INT64_C(4);  /* F83 */
    const int64_t a9_y_15 = a9_y_12 + a9_y_14;  /* F83 */
    const int32_t a9_y_16 = round_32(a9_y_15);  /* F51, |x| <= 7.03e-07 */
    const int64_t a9_z_1 = (int64_t)a8_x * W0_y;  /* F86 */
    const int64_t a9_z_2 = (int64_t)a8_y * W0_x_negated;  /* F86 */
    const int64_t a9_z_3 = a9_z_1 + a9_z_2;  /* F86 */
    const int32_t a9_z_4 = round_32(a9_z_3);  /* F54, |x| <= 7.63e-08 */
    const int64_t a9_z_5 = a9_z_4 * INT64_C(536870912);  /* F83 */
    const int64_t a9_z_6 = (int64_t)a7_x * W1_y;  /* F83 */
    const int64_t a9_z_7 = a9_z_5 + a9_z_6;  /* F83 */
    const int64_t a9_z_8 = (int64_t)a7_y * W1_x_negated;  /* F83 */
    const int64_t a9_z_9 = a9_z_7 + a9_z_8;  /* F83 */
    const int64_t a9_z_10 = (int64_t)a6_x * W2_y;  /* F81 */
    const int64_t a9_z_11 = a9_z_10 * INT64_C(4);  /* F83 */
    const int64_t a9_z_12 = a9_z_9 + a9_z_11;  /* F83 */
    const int64_t a9_z_13 = (int64_t)a6_y * W2_x_negated;  /* F81 */
    const int64_t a9_z_14 = a9_z_13 * INT64_C(4);  /* F83 */
    const int64_t a9_z_15 = a9_z_12 + a9_z_14;  /* F83 */
    const int32_t a9_z_16 = round_32(a9_z_15);  /* F51, |x| <= 7.03e-07 */
    const int64_t a9_x_17 = (int64_t)954437177 /* 1/9 */ * a9_x_16;  /* F84 */
    const int32_t a9_x = round_32(a9_x_17);  /* F52, |x| <= 4.18e-08 */
    const int64_t a9_y_17 = (int64_t)954437177 /* 1/9 */ * a9_y_16;  /* F84 */
    const int32_t a9_y = round_32(a9_y_17);  /* F52, |x| <= 4.18e-08 */
    const int64_t a9_z_17 = (int64_t)954437177 /* 1/9 */ * a9_z_16;  /* F84 */
    const int32_t a9_z = round_32(a9_z_17);  /* F52, |x| <= 4.18e-08 */

    /* a_10 = 1/10 sum_j a_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t a10_x_1 = (int64_t)a9_y * W0_z;  /* F86 */
    const int64_t a10_x_2 = (int64_t)a9_z * W0_y_negated;  /* F86 */
    const int64_t a10_x_3 = a10_x_1 + a10_x_2;  /* F86 */
    const int64_t a10_x_4 = (int64_t)a8_y * W1_z;  /* F86 */
    const int64_t a10_x_5 = a10_x_3 + a10_x_4;  /* F86 */
    const int64_t a10_x_6 = (int64_t)a8_z * W1_y_negated;  /* F86 */
    const int64_t a10_x_7 = a10_x_5 + a10_x_6;  /* F86 */
    const int64_t a10_x_8 = (int64_t)a7_y * W2_z;  /* F84 */
    const int64_t a10_x_9 = a10_x_8 * INT64_C(4);  /* F86 */
    const int64_t a10_x_10 = a10_x_7 + a10_x_9;  /* F86 */
    const int64_t a10_x_11 = (int64_t)a7_z * W2_y_negated;  /* F84 */
    const int64_t a10_x_12 = a10_x_11 * INT64_C(4);  /* F86 */
    const int64_t a10_x_13 = a10_x_10 + a10_x_12;  /* F86 */
    const int32_t a10_x_14 = round_32(a10_x_13);  /* F54, |x| <= 8.72e-08 */
    const int64_t a10_y_1 = (int64_t)a9_z * W0_x;  /* F86 */
    const int64_t a10_y_2 = (int64_t)a9_x * W0_z_negated;  /* F86 */
    const int64_t a10_y_3 = a10_y_1 + a10_y_2;  /* F86 */
    const int64_t a10_y_4 = (int64_t)a8_z * W1_x;  /* F86 */
    const int64_t a10_y_5 = a10_y_3 + a10_y_4;  /* F86 */
    const int64_t a10_y_6 = (int64_t)a8_x * W1_z_negated;  /* F86 */
    const int64_t a10_y_7 = a10_y_5 + a10_y_6;  /* F86 */
    const int64_t a10_y_8 = (int64_t)a7_z * W2_x;  /* F84 */
    const int64_t a10_y_9 = a10_y_8 * INT64_C(4);  /* F86 */
    const int64_t a10_y_10 = a10_y_7 + a10_y_9;  /* F86 */
    const int64_t a10_y_11 = (int64_t)a7_x * W2_z_negated;  /* F84 */
    const int64_t a10_y_12 = a10_y_11 * INT64_C(4);  /* F86 */
    const int64_t a10_y_13 = a10_y_10 + a10_y_12;  /* F86 */
    const int32_t a10_y_14 = round_32(a10_y_13);  /* F54, |x| <= 8.72e-08 */
    const int64_t a10_z_1 = (int64_t)a9_x * W0_y;  /* F86 */
    const int64_t a10_z_2 = (int64_t)a9_y * W0_x_negated;  /* F86 */
    const int64_t a10_z_3 = a10_z_1 + a10_z_2;  /* F86 */
    const int64_t a10_z_4 = (int64_t)a8_x * W1_y;  /* F86 */
    const int64_t a10_z_5 = a10_z_3 + a10_z_4;  /* F86 */
    const int64_t a10_z_6 = (int64_t)a8_y * W1_x_negated;  /* F86 */
    const int64_t a10_z_7 = a10_z_5 + a10_z_6;  /* F86 */
    const int64_t a10_z_8 = (int64_t)a7_x * W2_y;  /* F84 */
    const int64_t a10_z_9 = a10_z_8 * INT64_C(4);  /* F86 */
    const int64_t a10_z_10 = a10_z_7 + a10_z_9;  /* F86 */
    const int64_t a10_z_11 = (int64_t)a7_y * W2_x_negated;  /* F84 */
    const int64_t a10_z_12 = a10_z_11 * INT64_C(4);  /* F86 */
    const int64_t a10_z_13 = a10_z_10 + a10_z_12;  /* F86 */
    const int32_t a10_z_14 = round_32(a10_z_13);  /* F54, |x| <= 8.72e-08 */

    /* b_1 = 1/1 sum_j b_(1-1-j) x W_j   [xu2019 (13)] */
    const int64_t b1_x_1 = (int64_t)c_22 * W0_z;  /* F64 */
    const int64_t b1_x_2 = (int64_t)c_23 * W0_y_negated;  /* F64 */
    const int64_t b1_x_3 = b1_x_1 + b1_x_2;  /* F64 */
    const int32_t b1_x = round_31(b1_x_3);  /* F33, |x| <= 0.158 */
    const int64_t b1_y_1 = (int64_t)c_23 * W0_x;  /* F64 */
    const int64_t b1_y_2 = (int64_t)c_21 * W0_z_negated;  /* F64 */
    const int64_t b1_y_3 = b1_y_1 + b1_y_2;  /* F64 */
    const int32_t b1_y = round_31(b1_y_3);  /* F33, |x| <= 0.158 */
    const int64_t b1_z_1 = (int64_t)c_21 * W0_y;  /* F64 */
    const int64_t b1_z_2 = (int64_t)c_22 * W0_x_negated;  /* F64 */
    const int64_t b1_z_3 = b1_z_1 + b1_z_2;  /* F64 */
    const int32_t b1_z = round_31(b1_z_3);  /* F33, |x| <= 0.158 */

    /* b_2 = 1/2 sum_j b_(2-1-j) x W_j   [xu2019 (13)] */
    const int64_t b2_x_part_1 = (int64_t)b1_y * W0_z;  /* F67 */
    const int64_t b2_x_part_2 = (int64_t)b1_z * W0_y_negated;  /* F67 */
    const int64_t b2_x_part_3 = b2_x_part_1 + b2_x_part_2;  /* F68 */
    const int32_t b2_x_part = round_32(b2_x_part_3);  /* F36, |x| <= 0.0168 */
    const int64_t b2_x_1 = b2_x_part * INT64_C(536870912);  /* F65 */
    const int64_t b2_x_2 = (int64_t)c_22 * W1_z;  /* F64 */
    const int64_t b2_x_3 = b2_x_1 + b2_x_2;  /* F65 */
    const int64_t b2_x_4 = (int64_t)c_23 * W1_y_negated;  /* F64 */
    const int64_t b2_x_5 = b2_x_3 + b2_x_4;  /* F65 */
    const int32_t b2_x = round_30(b2_x_5);  /* F35, |x| <= 0.0386 */
    const int64_t b2_y_part_1 = (int64_t)b1_z * W0_x;  /* F67 */
    const int64_t b2_y_part_2 = (int64_t)b1_x * W0_z_negated;  /* F67 */
    const int64_t b2_y_part_3 = b2_y_part_1 + b2_y_part_2;  /* F68 */
    const int32_t b2_y_part = round_32(b2_y_part_3);  /* F36, |x| <= 0.0168 */
    const int64_t b2_y_1 = b2_y_part * INT64_C(536870912);  /* F65 */
    const int64_t b2_y_2 = (int64_t)c_23 * W1_x;  /* F64 */
    const int64_t b2_y_3 = b2_y_1 + b2_y_2;  /* F65 */
    const int64_t b2_y_4 = (int64_t)c_21 * W1_z_negated;  /* F64 */
    const int64_t b2_y_5 = b2_y_3 + b2_y_4;  /* F65 */
    const int32_t b2_y = round_30(b2_y_5);  /* F35, |x| <= 0.0386 */
    const int64_t b2_z_part_1 = (int64_t)b1_x * W0_y;  /* F67 */
    const int64_t b2_z_part_2 = (int64_t)b1_y * W0_x_negated;  /* F67 */
    const int64_t b2_z_part_3 = b2_z_part_1 + b2_z_part_2;  /* F68 */
    const int32_t b2_z_part = round_32(b2_z_part_3);  /* F36, |x| <= 0.0168 */
    const int64_t b2_z_1 = b2_z_part * INT64_C(536870912);  /* F65 */
    const int64_t b2_z_2 = (int64_t)c_21 * W1_y;  /* F64 */
    const int64_t b2_z_3 = b2_z_1 + b2_z_2;  /* F65 */
    const int64_t b2_z_4 = (int64_t)c_22 * W1_x_negated;  /* F64 */
    const int64_t b2_z_5 = b2_z_3 + b2_z_4;  /* F65 */
    const int32_t b2_z = round_30(b2_z_5);  /* F35, |x| <= 0.0386 */

    /* b_3 = 1/3 sum_j b_(3-1-j) x W_j   [xu2019 (13)] */
    const int64_t b3_x_1 = (int64_t)b2_y * W0_z;  /* F69 */
    const int64_t b3_x_2 = (int64_t)b2_z * W0_y_negated;  /* F69 */
    const int64_t b3_x_3 = b3_x_1 + b3_x_2;  /* F69 */
    const int32_t b3_x_4 = round_32(b3_x_3);  /* F37, |x| <= 0.00822 */
    const int64_t b3_x_5 = b3_x_4 * INT64_C(1073741824);  /* F67 */
    const int64_t b3_x_6 = (int64_t)b1_y * W1_z;  /* F67 */
    const int64_t b3_x_7 = b3_x_5 + b3_x_6;  /* F67 */
    const int64_t b3_x_8 = (int64_t)b1_z * W1_y_negated;  /* F67 */
    const int64_t b3_x_9 = b3_x_7 + b3_x_8;  /* F67 */
    const int64_t b3_x_10 = (int64_t)c_22 * W2_z;  /* F65 */
    const int64_t b3_x_11 = b3_x_10 * INT64_C(4);  /* F67 */
    const int64_t b3_x_12 = b3_x_9 + b3_x_11;  /* F67 */
    const int64_t b3_x_13 = (int64_t)c_23 * W2_y_negated;  /* F65 */
    const int64_t b3_x_14 = b3_x_13 * INT64_C(4);  /* F67 */
    const int64_t b3_x_15 = b3_x_12 + b3_x_14;  /* F67 */
    const int32_t b3_x_16 = round_32(b3_x_15);  /* F35, |x| <= 0.0424 */
    const int64_t b3_y_1 = (int64_t)b2_z * W0_x;  /* F69 */
    const int64_t b3_y_2 = (int64_t)b2_x * W0_z_negated;  /* F69 */
    const int64_t b3_y_3 = b3_y_1 + b3_y_2;  /* F69 */
    const int32_t b3_y_4 = round_32(b3_y_3);  /* F37, |x| <= 0.00822 */
    const int64_t b3_y_5 = b3_y_4 * INT64_C(1073741824);  /* F67 */
    const int64_t b3_y_6 = (int64_t)b1_z * W1_x;  /* F67 */
    const int64_t b3_y_7 = b3_y_5 + b3_y_6;  /* F67 */
    const int64_t b3_y_8 = (int64_t)b1_x * W1_z_negated;  /* F67 */
    const int64_t b3_y_9 = b3_y_7 + b3_y_8;  /* F67 */
    const int64_t b3_y_10 = (int64_t)c_23 * W2_x;  /* F65 */
    const int64_t b3_y_11 = b3_y_10 * INT64_C(4);  /* F67 */
    const int64_t b3_y_12 = b3_y_9 + b3_y_11;  /* F67 */
    const int64_t b3_y_13 = (int64_t)c_21 * W2_z_negated;  /* F65 */
    const int64_t b3_y_14 = b3_y_13 * INT64_C(4);  /* F67 */
    const int64_t b3_y_15 = b3_y_12 + b3_y_14;  /* F67 */
    const int32_t b3_y_16 = round_32(b3_y_15);  /* F35, |x| <= 0.0424 */
    const int64_t b3_z_1 = (int64_t)b2_x * W0_y;  /* F69 */
    const int64_t b3_z_2 = (int64_t)b2_y * W0_x_negated;  /* F69 */
    const int64_t b3_z_3 = b3_z_1 + b3_z_2;  /* F69 */
    const int32_t b3_z_4 = round_32(b3_z_3);  /* F37, |x| <= 0.00822 */
    const int64_t b3_z_5 = b3_z_4 * INT64_C(1073741824);  /* F67 */
    const int64_t b3_z_6 = (int64_t)b1_x * W1_y;  /* F67 */
    const int64_t b3_z_7 = b3_z_5 + b3_z_6;  /* F67 */
    const int64_t b3_z_8 = (int64_t)b1_y * W1_x_negated;  /* F67 */
    const int64_t b3_z_9 = b3_z_7 + b3_z_8;  /* F67 */
    const int64_t b3_z_10 = (int64_t)c_21 * W2_y;  /* F65 */
    const int64_t b3_z_11 = b3_z_10 * INT64_C(4);  /* F67 */
    const int64_t b3_z_12 = b3_z_9 + b3_z_11;  /* F67 */
    const int64_t b3_z_13 = (int64_t)c_22 * W2_x_negated;  /* F65 */
    const int64_t b3_z_14 = b3_z_13 * INT64_C(4);  /* F67 */
    const int64_t b3_z_15 = b3_z_12 + b3_z_14;  /* F67 */
    const int32_t b3_z_16 = round_32(b3_z_15);  /* F35, |x| <= 0.0424 */
    const int64_t b3_x_17 = (int64_t)1431655765 /* 1/3 */ * b3_x_16;  /* F67 */
    const int32_t b3_x = round_31(b3_x_17);  /* F36, |x| <= 0.00766 */
    const int64_t b3_y_17 = (int64_t)1431655765 /* 1/3 */ * b3_y_16;  /* F67 */
    const int32_t b3_y = round_31(b3_y_17);  /* F36, |x| <= 0.00766 */
    const int64_t b3_z_17 = (int64_t)1431655765 /* 1/3 */ * b3_z_16;  /* F67 */
    const int32_t b3_z = round_31(b3_z_17);  /* F36, |x| <= 0.00766 */

    /* b_4 = 1/4 sum_j b_(4-1-j) x W_j   [xu2019 (13)] */
    const int64_t b4_x_1 = (int64_t)b3_y * W0_z;  /* F70 */
    const int64_t b4_x_2 = (int64_t)b3_z * W0_y_negated;  /* F70 */
    const int64_t b4_x_3 = b4_x_1 + b4_x_2;  /* F72 */
    const int64_t b4_x_4 = (int64_t)b2_y * W1_z;  /* F69 */
    const int64_t b4_x_5 = b4_x_4 * INT64_C(2);  /* F72 */
    const int64_t b4_x_6 = b4_x_3 + b4_x_5;  /* F72 */
    const int64_t b4_x_7 = (int64_t)b2_z * W1_y_negated;  /* F69 */
    const int64_t b4_x_8 = b4_x_7 * INT64_C(2);  /* F72 */
    const int64_t b4_x_9 = b4_x_6 + b4_x_8;  /* F72 */
    const int64_t b4_x_10 = (int64_t)b1_y * W2_z;  /* F68 */
    const int64_t b4_x_11 = b4_x_10 * INT64_C(4);  /* F72 */
    const int64_t b4_x_12 = b4_x_9 + b4_x_11;  /* F72 */
    const int64_t b4_x_13 = (int64_t)b1_z * W2_y_negated;  /* F68 */
    const int64_t b4_x_14 = b4_x_13 * INT64_C(4);  /* F72 */
    const int64_t b4_x_15 = b4_x_12 + b4_x_14;  /* F72 */
    const int32_t b4_x = round_32(b4_x_15);  /* F40, |x| <= 0.00104 */
    const int64_t b4_y_1 = (int64_t)b3_z * W0_x;  /* F70 */
    const int64_t b4_y_2 = (int64_t)b3_x * W0_z_negated;  /* F70 */
    const int64_t b4_y_3 = b4_y_1 + b4_y_2;  /* F72 */
    const int64_t b4_y_4 = (int64_t)b2_z * W1_x;  /* F69 */
    const int64_t b4_y_5 = b4_y_4 * INT64_C(2);  /* F72 */
    const int64_t b4_y_6 = b4_y_3 + b4_y_5;  /* F72 */
    const int64_t b4_y_7 = (int64_t)b2_x * W1_z_negated;  /* F69 */
    const int64_t b4_y_8 = b4_y_7 * INT64_C(2);  /* F72 */
    const int64_t b4_y_9 = b4_y_6 + b4_y_8;  /* F72 */
    const int64_t b4_y_10 = (int64_t)b1_z * W2_x;  /* F68 */
    const int64_t b4_y_11 = b4_y_10 * INT64_C(4);  /* F72 */
    const int64_t b4_y_12 = b4_y_9 + b4_y_11;  /* F72 */
    const int64_t b4_y_13 = (int64_t)b1_x * W2_z_negated;  /* F68 */
    const int64_t b4_y_14 = b4_y_13 * INT64_C(4);  /* F72 */
    const int64_t b4_y_15 = b4_y_12 + b4_y_14;  /* F72 */
    const int32_t b4_y = round_32(b4_y_15);  /* F40, |x| <= 0.00104 */
    const int64_t b4_z_1 = (int64_t)b3_x * W0_y;  /* F70 */
    const int64_t b4_z_2 = (int64_t)b3_y * W0_x_negated;  /* F70 */
    const int64_t b4_z_3 = b4_z_1 + b4_z_2;  /* F72 */
    const int64_t b4_z_4 = (int64_t)b2_x * W1_y;  /* F69 */
    const int64_t b4_z_5 = b4_z_4 * INT64_C(2);  /* F72 */
    const int64_t b4_z_6 = b4_z_3 + b4_z_5;  /* F72 */
    const int64_t b4_z_7 = (int64_t)b2_y * W1_x_negated;  /* F69 */
    const int64_t b4_z_8 = b4_z_7 * INT64_C(2);  /* F72 */
    const int64_t b4_z_9 = b4_z_6 + b4_z_8;  /* F72 */
    const int64_t b4_z_10 = (int64_t)b1_x * W2_y;  /* F68 */
    const int64_t b4_z_11 = b4_z_10 * INT64_C(4);  /* F72 */
    const int64_t b4_z_12 = b4_z_9 + b4_z_11;  /* F72 */
    const int64_t b4_z_13 = (int64_t)b1_y * W2_x_negated;  /* F68 */
    const int64_t b4_z_14 = b4_z_13 * INT64_C(4);  /* F72 */
    const int64_t b4_z_15 = b4_z_12 + b4_z_14;  /* F72 */
    const int32_t b4_z = round_32(b4_z_15);  /* F40, |x| <= 0.00104 */

    /* b_5 = 1/5 sum_j b_(5-1-j) x W_j   [xu2019 (13)] */
    const int64_t b5_x_1 = (int64_t)b4_y * W0_z;  /* F74 */
    const int64_t b5_x_2 = (int64_t)b4_z * W0_y_negated;  /* F74 */
    const int64_t b5_x_3 = b5_x_1 + b5_x_2;  /* F74 */
    const int32_t b5_x_4 = round_31(b5_x_3);  /* F43, |x| <= 0.000222 */
    const int64_t b5_x_5 = b5_x_4 * INT64_C(134217728);  /* F70 */
    const int64_t b5_x_6 = (int64_t)b3_y * W1_z;  /* F70 */
    const int64_t b5_x_7 = b5_x_5 + b5_x_6;  /* F70 */
    const int64_t b5_x_8 = (int64_t)b3_z * W1_y_negated;  /* F70 */
    const int64_t b5_x_9 = b5_x_7 + b5_x_8;  /* F70 */
    const int64_t b5_x_10 = (int64_t)b2_y * W2_z;  /* F70 */
    const int64_t b5_x_11 = b5_x_9 + b5_x_10;  /* F70 */
    const int64_t b5_x_12 = (int64_t)b2_z * W2_y_negated;  /* F70 */
    const int64_t b5_x_13 = b5_x_11 + b5_x_12;  /* F70 */
    const int32_t b5_x_14 = round_30(b5_x_13);  /* F40, |x| <= 0.00152 */
    const int64_t b5_y_1 = (int64_t)b4_z * W0_x;  /* F74 */
    const int64_t b5_y_2 = (int64_t)b4_x * W0_z_negated;  /* F74 */
    const int64_t b5_y_3 = b5_y_1 + b5_y_2;  /* F74 */
    const int32_t b5_y_4 = round_31(b5_y_3);  /* F43, |x| <= 0.000222 */
    const int64_t b5_y_5 = b5_y_4 * INT64_C(134217728);  /* F70 */
    const int64_t b5_y_6 = (int64_t)b3_z * W1_x;  /* F70 */
    const int64_t b5_y_7 = b5_y_5 + b5_y_6;  /* F70 */
    const int64_t b5_y_8 = (int64_t)b3_x * W1_z_negated;  /* F70 */
    const int64_t b5_y_9 = b5_y_7 + b5_y_8;  /* F70 */
    const int64_t b5_y_10 = (int64_t)b2_z * W2_x;  /* F70 */
    const int64_t b5_y_11 = b5_y_9 + b5_y_10;  /* F70 */
    const int64_t b5_y_12 = (int64_t)b2_x * W2_z_negated;  /* F70 */
    const int64_t b5_y_13 = b5_y_11 + b5_y_12;  /* F70 */
    const int32_t b5_y_14 = round_30(b5_y_13);  /* F40, |x| <= 0.00152 */
    const int64_t b5_z_1 = (int64_t)b4_x * W0_y;  /* F74 */
    const int64_t b5_z_2 = (int64_t)b4_y * W0_x_negated;  /* F74 */
    const int64_t b5_z_3 = b5_z_1 + b5_z_2;  /* F74 */
    const int32_t b5_z_4 = round_31(b5_z_3);  /* F43, |x| <= 0.000222 */
    const int64_t b5_z_5 = b5_z_4 * INT64_C(134217728);  /* F70 */
    const int64_t b5_z_6 = (int64_t)b3_x * W1_y;  /* F70 */
    const int64_t b5_z_7 = b5_z_5 + b5_z_6;  /* F70 */
    const int64_t b5_z_8 = (int64_t)b3_y * W1_x_negated;  /* F70 */
    const int64_t b5_z_9 = b5_z_7 + b5_z_8;  /* F70 */
    const int64_t b5_z_10 = (int64_t)b2_x * W2_y;  /* F70 */
    const int64_t b5_z_11 = b5_z_9 + b5_z_10;  /* F70 */
    const int64_t b5_z_12 = (int64_t)b2_y * W2_x_negated;  /* F70 */
    const int64_t b5_z_13 = b5_z_11 + b5_z_12;  /* F70 */
    const int32_t b5_z_14 = round_30(b5_z_13);  /* F40, |x| <= 0.00152 */
    const int64_t b5_x_15 = (int64_t)858993459 /* 1/5 */ * b5_x_14;  /* F72 */
    const int32_t b5_x = round_29(b5_x_15);  /* F43, |x| <= 0.000166 */
    const int64_t b5_y_15 = (int64_t)858993459 /* 1/5 */ * b5_y_14;  /* F72 */
    const int32_t b5_y = round_29(b5_y_15);  /* F43, |x| <= 0.000166 */
    const int64_t b5_z_15 = (int64_t)858993459 /* 1/5 */ * b5_z_14;  /* F72 */
    const int32_t b5_z = round_29(b5_z_15);  /* F43, |x| <= 0.000166 */

    /* b_6 = 1/6 sum_j b_(6-1-j) x W_j   [xu2019 (13)] */
    const int64_t b6_x_1 = (int64_t)b5_y * W0_z;  /* F77 */
    const int64_t b6_x_2 = (int64_t)b5_z * W0_y_negated;  /* F77 */
    const int64_t b6_x_3 = b6_x_1 + b6_x_2;  /* F77 */
    const int32_t b6_x_4 = round_32(b6_x_3);  /* F45, |x| <= 3.53e-05 */
    const int64_t b6_x_5 = b6_x_4 * INT64_C(536870912);  /* F74 */
    const int64_t b6_x_6 = (int64_t)b4_y * W1_z;  /* F74 */
    const int64_t b6_x_7 = b6_x_5 + b6_x_6;  /* F74 */
    const int64_t b6_x_8 = (int64_t)b4_z * W1_y_negated;  /* F74 */
    const int64_t b6_x_9 = b6_x_7 + b6_x_8;  /* F74 */
    const int64_t b6_x_10 = (int64_t)b3_y * W2_z;  /* F71 */
    const int64_t b6_x_11 = b6_x_10 * INT64_C(8);  /* F74 */
    const int64_t b6_x_12 = b6_x_9 + b6_x_11;  /* F74 */
    const int64_t b6_x_13 = (int64_t)b3_z * W2_y_negated;  /* F71 */
    const int64_t b6_x_14 = b6_x_13 * INT64_C(8);  /* F74 */
    const int64_t b6_x_15 = b6_x_12 + b6_x_14;  /* F74 */
    const int32_t b6_x_16 = round_32(b6_x_15);  /* F42, |x| <= 0.000254 */
    const int64_t b6_y_1 = (int64_t)b5_z * W0_x;  /* F77 */
    const int64_t b6_y_2 = (int64_t)b5_x * W0_z_negated;  /* F77 */
    const int64_t b6_y_3 = b6_y_1 + b6_y_2;  /* F77 */
    const int32_t b6_y_4 = round_32(b6_y_3);  /* F45, |x| <= 3.53e-05 */
    const int64_t b6_y_5 = b6_y_4 * INT64_C(536870912);  /* F74 */
    const int64_t b6_y_6 = (int64_t)b4_z * W1_x;  /* F74 */
    const int64_t b6_y_7 = b6_y_5 + b6_y_6;  /* F74 */
    const int64_t b6_y_8 = (int64_t)b4_x * W1_z_negated;  /* F74 */
    const int64_t b6_y_9 = b6_y_7 + b6_y_8;  /* F74 */
    const int64_t b6_y_10 = (int64_t)b3_z * W2_x;  /* F71 */
    const int64_t b6_y_11 = b6_y_10 * INT64_C(8);  /* F74 */
    const int64_t b6_y_12 = b6_y_9 + b6_y_11;  /* F74 */
    const int64_t b6_y_13 = (int64_t)b3_x * W2_z_negated;  /* F71 */
    const int64_t b6_y_14 = b6_y_13 * INT64_C(8);  /* F74 */
    const int64_t b6_y_15 = b6_y_12 + b6_y_14;  /* F74 */
    const int32_t b6_y_16 = round_32(b6_y_15);  /* F42, |x| <= 0.000254 */
    const int64_t b6_z_1 = (int64_t)b5_x * W0_y;  /* F77 */
    const int64_t b6_z_2 = (int64_t)b5_y * W0_x_negated;  /* F77 */
    const int64_t b6_z_3 = b6_z_1 + b6_z_2;  /* F77 */
    const int32_t b6_z_4 = round_32(b6_z_3);  /* F45, |x| <= 3.53e-05 */
    const int64_t b6_z_5 = b6_z_4 * INT64_C(536870912);  /* F74 */
    const int64_t b6_z_6 = (int64_t)b4_x * W1_y;  /* F74 */
    const int64_t b6_z_7 = b6_z_5 + b6_z_6;  /* F74 */
    const int64_t b6_z_8 = (int64_t)b4_y * W1_x_negated;  /* F74 */
    const int64_t b6_z_9 = b6_z_7 + b6_z_8;  /* F74 */
    const int64_t b6_z_10 = (int64_t)b3_x * W2_y;  /* F71 */
    const int64_t b6_z_11 = b6_z_10 * INT64_C(8);  /* F74 */
    const int64_t b6_z_12 = b6_z_9 + b6_z_11;  /* F74 */
    const int64_t b6_z_13 = (int64_t)b3_y * W2_x_negated;  /* F71 */
    const int64_t b6_z_14 = b6_z_13 * INT64_C(8);  /* F74 */
    const int64_t b6_z_15 = b6_z_12 + b6_z_14;  /* F74 */
    const int32_t b6_z_16 = round_32(b6_z_15);  /* F42, |x| <= 0.000254 */
    const int64_t b6_x_17 = (int64_t)1431655765 /* 1/6 */ * b6_x_16;  /* F75 */
    const int32_t b6_x = round_29(b6_x_17);  /* F46, |x| <= 2.28e-05 */
    const int64_t b6_y_17 = (int64_t)1431655765 /* 1/6 */ * b6_y_16;  /* F75 */
    const int32_t b6_y = round_29(b6_y_17);  /* F46, |x| <= 2.28e-05 */
    const int64_t b6_z_17 = (int64_t)1431655765 /* 1/6 */ * b6_z_16;  /* F75 */
    const int32_t b6_z = round_29(b6_z_17);  /* F46, |x| <= 2.28e-05 */

    /* b_7 = 1/7 sum_j b_(7-1-j) x W_j   [xu2019 (13)] */
    const int64_t b7_x_1 = (int64_t)b6_y * W0_z;  /* F80 */
    const int64_t b7_x_2 = (int64_t)b6_z * W0_y_negated;  /* F80 */
    const int64_t b7_x_3 = b7_x_1 + b7_x_2;  /* F80 */
    const int32_t b7_x_4 = round_32(b7_x_3);  /* F48, |x| <= 4.85e-06 */
    const int64_t b7_x_5 = b7_x_4 * INT64_C(536870912);  /* F77 */
    const int64_t b7_x_6 = (int64_t)b5_y * W1_z;  /* F77 */
    const int64_t b7_x_7 = b7_x_5 + b7_x_6;  /* F77 */
    const int64_t b7_x_8 = (int64_t)b5_z * W1_y_negated;  /* F77 */
    const int64_t b7_x_9 = b7_x_7 + b7_x_8;  /* F77 */
    const int64_t b7_x_10 = (int64_t)b4_y * W2_z;  /* F75 */
    const int64_t b7_x_11 = b7_x_10 * INT64_C(4);  /* F77 */
    const int64_t b7_x_12 = b7_x_9 + b7_x_11;  /* F77 */
    const int64_t b7_x_13 = (int64_t)b4_z * W2_y_negated;  /* F75 */
    const int64_t b7_x_14 = b7_x_13 * INT64_C(4);  /* F77 */
    const int64_t b7_x_15 = b7_x_12 + b7_x_14;  /* F77 */
    const int32_t b7_x_16 = round_32(b7_x_15);  /* F45, |x| <= 3.65e-05 */
    const int64_t b7_y_1 = (int64_t)b6_z * W0_x;  /* F80 */
    const int64_t b7_y_2 = (int64_t)b6_x * W0_z_negated;  /* F80 */
    const int64_t b7_y_3 = b7_y_1 + b7_y_2;  /* F80 */
    const int32_t b7_y_4 = round_32(b7_y_3);  /* F48, |x| <= 4.85e-06 */
    const int64_t b7_y_5 = b7_y_4 * INT64_C(536870912);  /* F77 */
    const int64_t b7_y_6 = (int64_t)b5_z * W1_x;  /* F77 */
    const int64_t b7_y_7 = b7_y_5 + b7_y_6;  /* F77 */
    const int64_t b7_y_8 = (int64_t)b5_x * W1_z_negated;  /* F77 */
    const int64_t b7_y_9 = b7_y_7 + b7_y_8;  /* F77 */
    const int64_t b7_y_10 = (int64_t)b4_z * W2_x;  /* F75 */
    const int64_t b7_y_11 = b7_y_10 * INT64_C(4);  /* F77 */
    const int64_t b7_y_12 = b7_y_9 + b7_y_11;  /* F77 */
    const int64_t b7_y_13 = (int64_t)b4_x * W2_z_negated;  /* F75 */
    const int64_t b7_y_14 = b7_y_13 * INT64_C(4);  /* F77 */
    const int64_t b7_y_15 = b7_y_12 + b7_y_14;  /* F77 */
    const int32_t b7_y_16 = round_32(b7_y_15);  /* F45, |x| <= 3.65e-05 */
    const int64_t b7_z_1 = (int64_t)b6_x * W0_y;  /* F80 */
    const int64_t b7_z_2 = (int64_t)b6_y * W0_x_negated;  /* F80 */
    const int64_t b7_z_3 = b7_z_1 + b7_z_2;  /* F80 */
    const int32_t b7_z_4 = round_32(b7_z_3);  /* F48, |x| <= 4.85e-06 */
    const int64_t b7_z_5 = b7_z_4 * INT64_C(536870912);  /* F77 */
    const int64_t b7_z_6 = (int64_t)b5_x * W1_y;  /* F77 */
    const int64_t b7_z_7 = b7_z_5 + b7_z_6;  /* F77 */
    const int64_t b7_z_8 = (int64_t)b5_y * W1_x_negated;  /* F77 */
    const int64_t b7_z_9 = b7_z_7 + b7_z_8;  /* F77 */
    const int64_t b7_z_10 = (int64_t)b4_x * W2_y;  /* F75 */
    const int64_t b7_z_11 = b7_z_10 * INT64_C(4);  /* F77 */
    const int64_t b7_z_12 = b7_z_9 + b7_z_11;  /* F77 */
    const int64_t b7_z_13 = (int64_t)b4_y * W2_x_negated;  /* F75 */
    const int64_t b7_z_14 = b7_z_13 * INT64_C(4);  /* F77 */
    const int64_t b7_z_15 = b7_z_12 + b7_z_14;  /* F77 */
    const int32_t b7_z_16 = round_32(b7_z_15);  /* F45, |x| <= 3.65e-05 */
    const int64_t b7_x_17 = (int64_t)1227133513 /* 1/7 */ * b7_x_16;  /* F78 */
    const int32_t b7_x = round_29(b7_x_17);  /* F49, |x| <= 2.82e-06 */
    const int64_t b7_y_17 = (int64_t)1227133513 /* 1/7 */ * b7_y_16;  /* F78 */
    const int32_t b7_y = round_29(b7_y_17);  /* F49, |x| <= 2.82e-06 */
    const int64_t b7_z_17 = (int64_t)1227133513 /* 1/7 */ * b7_z_16;  /* F78 */
    const int32_t b7_z = round_29(b7_z_17);  /* F49, |x| <= 2.82e-06 */

    /* b_8 = 1/8 sum_j b_(8-1-j) x W_j   [xu2019 (13)] */
    const int64_t b8_x_part_1 = (int64_t)b7_y * W0_z;  /* F83 */
    const int64_t b8_x_part_2 = (int64_t)b7_z * W0_y_negated;  /* F83 */
    const int64_t b8_x_part_3 = b8_x_part_1 + b8_x_part_2;  /* F86 */
    const int32_t b8_x_part = round_32(b8_x_part_3);  /* F54, |x| <= 7.5e-08 */
    const int64_t b8_x_1 = b8_x_part * INT64_C(536870912);  /* F83 */
    const int64_t b8_x_2 = (int64_t)b6_y * W1_z;  /* F80 */
    const int64_t b8_x_3 = b8_x_1 + b8_x_2;  /* F83 */
    const int64_t b8_x_4 = (int64_t)b6_z * W1_y_negated;  /* F80 */
    const int64_t b8_x_5 = b8_x_3 + b8_x_4;  /* F83 */
    const int64_t b8_x_6 = (int64_t)b5_y * W2_z;  /* F78 */
    const int64_t b8_x_7 = b8_x_6 * INT64_C(4);  /* F83 */
    const int64_t b8_x_8 = b8_x_5 + b8_x_7;  /* F83 */
    const int64_t b8_x_9 = (int64_t)b5_z * W2_y_negated;  /* F78 */
    const int64_t b8_x_10 = b8_x_9 * INT64_C(4);  /* F83 */
    const int64_t b8_x_11 = b8_x_8 + b8_x_10;  /* F83 */
    const int32_t b8_x = round_31(b8_x_11);  /* F52, |x| <= 3.59e-07 */
    const int64_t b8_y_part_1 = (int64_t)b7_z * W0_x;  /* F83 */
    const int64_t b8_y_part_2 = (int64_t)b7_x * W0_z_negated;  /* F83 */
    const int64_t b8_y_part_3 = b8_y_part_1 + b8_y_part_2;  /* F86 */
    const int32_t b8_y_part = round_32(b8_y_part_3);  /* F54, |x| <= 7.5e-08 */
    const int64_t b8_y_1 = b8_y_part * INT64_C(536870912);  /* F83 */
    const int64_t b8_y_2 = (int64_t)b6_z * W1_x;  /* F80 */
    const int64_t b8_y_3 = b8_y_1 + b8_y_2;  /* F83 */
    const int64_t b8_y_4 = (int64_t)b6_x * W1_z_negated;  /* F80 */
    const int64_t b8_y_5 = b8_y_3 + b8_y_4;  /* F83 */
    const int64_t b8_y_6 = (int64_t)b5_z * W2_x;  /* F78 */
    const int64_t b8_y_7 = b8_y_6 * INT64_C(4);  /* F83 */
    const int64_t b8_y_8 = b8_y_5 + b8_y_7;  /* F83 */
    const int64_t b8_y_9 = (int64_t)b5_x * W2_z_negated;  /* F78 */
    const int64_t b8_y_10 = b8_y_9 * INT64_C(4);  /* F83 */
    const int64_t b8_y_11 = b8_y_8 + b8_y_10;  /* F83 */
    const int32_t b8_y = round_31(b8_y_11);  /* F52, |x| <= 3.59e-07 */
    const int64_t b8_z_part_1 = (int64_t)b7_x * W0_y;  /* F83 */
    const int64_t b8_z_part_2 = (int64_t)b7_y * W0_x_negated;  /* F83 */
    const int64_t b8_z_part_3 = b8_z_part_1 + b8_z_part_2;  /* F86 */
    const int32_t b8_z_part = round_32(b8_z_part_3);  /* F54, |x| <= 7.5e-08 */
    const int64_t b8_z_1 = b8_z_part * INT64_C(536870912);  /* F83 */
    const int64_t b8_z_2 = (int64_t)b6_x * W1_y;  /* F80 */
    const int64_t b8_z_3 = b8_z_1 + b8_z_2;  /* F83 */
    const int64_t b8_z_4 = (int64_t)b6_y * W1_x_negated;  /* F80 */
    const int64_t b8_z_5 = b8_z_3 + b8_z_4;  /* F83 */
    const int64_t b8_z_6 = (int64_t)b5_x * W2_y;  /* F78 */
    const int64_t b8_z_7 = b8_z_6 * INT64_C(4);  /* F83 */
    const int64_t b8_z_8 = b8_z_5 + b8_z_7;  /* F83 */
    const int64_t b8_z_9 = (int64_t)b5_y * W2_x_negated;  /* F78 */
    const int64_t b8_z_10 = b8_z_9 * INT64_C(4);  /* F83 */
    const int64_t b8_z_11 = b8_z_8 + b8_z_10;  /* F83 */
    const int32_t b8_z = round_31(b8_z_11);  /* F52, |x| <= 3.59e-07 */

    /* b_9 = 1/9 sum_j b_(9-1-j) x W_j   [xu2019 (13)] */
    const int64_t b9_x_1 = (int64_t)b8_y * W0_z;  /* F86 */
    const int64_t b9_x_2 = (int64_t)b8_z * W0_y_negated;  /* F86 */
    const int64_t b9_x_3 = b9_x_1 + b9_x_2;  /* F86 */
    const int32_t b9_x_4 = round_32(b9_x_3);  /* F54, |x| <= 7.63e-08 */
    const int64_t b9_x_5 = b9_x_4 * INT64_C(536870912);  /* F83 */
    const int64_t b9_x_6 = (int64_t)b7_y * W1_z;  /* F83 */
    const int64_t b9_x_7 = b9_x_5 + b9_x_6;  /* F83 */
    const int64_t b9_x_8 = (int64_t)b7_z * W1_y_negated;  /* F83 */
    const int64_t b9_x_9 = b9_x_7 + b9_x_8;  /* F83 */
    const int64_t b9_x_10 = (int64_t)b6_y * W2_z;  /* F81 */
    const int64_t b9_x_11 = b9_x_10 * INT64_C(4);  /* F83 */
    const int64_t b9_x_12 = b9_x_9 + b9_x_11;  /* F83 */
    const int64_t b9_x_13 = (int64_t)b6_z * W2_y_negated;  /* F81 */
    const int64_t b9_x_14 = b9_x_13 * INT64_C(4);  /* F83 */
    const int64_t b9_x_15 = b9_x_12 + b9_x_14;  /* F83 */
    const int32_t b9_x_16 = round_32(b9_x_15);  /* F51, |x| <= 7.03e-07 */
    const int64_t b9_y_1 = (int64_t)b8_z * W0_x;  /* F86 */
    const int64_t b9_y_2 = (int64_t)b8_x * W0_z_negated;  /* F86 */
    const int64_t b9_y_3 = b9_y_1 + b9_y_2;  /* F86 */
    const int32_t b9_y_4 = round_32(b9_y_3);  /* F54, |x| <= 7.63e-08 */
    const int64_t b9_y_5 = b9_y_4 * INT64_C(536870912);  /* F83 */
    const int64_t b9_y_6 = (int64_t)b7_z * W1_x;  /* F83 */
    const int64_t b9_y_7 = b9_y_5 + b9_y_6;  /* F83 */
    const int64_t b9_y_8 = (int64_t)b7_x * W1_z_negated;  /* F83 */
    const int64_t b9_y_9 = b9_y_7 + b9_y_8;  /* F83 */
    const int64_t b9_y_10 = (int64_t)b6_z * W2_x;  /* F81 */
    const int64_t b9_y_11 = b9_y_10 * INT64_C(4);  /* F83 */
    const int64_t b9_y_12 = b9_y_9 + b9_y_11;  /* F83 */
    const int64_t b9_y_13 = (int64_t)b6_x * W2_z_negated;  /* F81 */
    const int64_t b9_y_14 = b9_y_13 * INT64_C(4);  /* F83 */
    const int64_t b9_y_15 = b9_y_12 + b9_y_14;  /* F83 */
    const int32_t b9_y_16 = round_32(b9_y_15);  /* F51, |x| <= 7.03e-07 */
    const int64_t b9_z_1 = (int64_t)b8_x * W0_y;  /* F86 */
    const int64_t b9_z_2 = (int64_t)b8_y * W0_x_negated;  /* F86 */
    const int64_t b9_z_3 = b9_z_1 + b9_z_2;  /* F86 */
    const int32_t b9_z_4 = round_32(b9_z_3);  /* F54, |x| <= 7.63e-08 */
    const int64_t b9_z_5 = b9_z_4 * INT64_C(536870912);  /* F83 */
    const int64_t b9_z_6 = (int64_t)b7_x * W1_y;  /* F83 */
    const int64_t b9_z_7 = b9_z_5 + b9_z_6;  /* F83 */
    const int64_t b9_z_8 = (int64_t)b7_y * W1_x_negated;  /* F83 */
    const int64_t b9_z_9 = b9_z_7 + b9_z_8;  /* F83 */
    const int64_t b9_z_10 = (int64_t)b6_x * W2_y;  /* F81 */
    const int64_t b9_z_11 = b9_z_10 * INT64_C(4);  /* F83 */
    const int64_t b9_z_12 = b9_z_9 + b9_z_11;  /* F83 */
    const int64_t b9_z_13 = (int64_t)b6_y * W2_x_negated;  /* F81 */
    const int64_t b9_z_14 = b9_z_13 * INT64_C(4);  /* F83 */
    const int64_t b9_z_15 = b9_z_12 + b9_z_14;  /* F83 */
    const int32_t b9_z_16 = round_32(b9_z_15);  /* F51, |x| <= 7.03e-07 */
    const int64_t b9_x_17 = (int64_t)954437177 /* 1/9 */ * b9_x_16;  /* F84 */
    const int32_t b9_x = round_32(b9_x_17);  /* F52, |x| <= 4.18e-08 */
    const int64_t b9_y_17 = (int64_t)954437177 /* 1/9 */ * b9_y_16;  /* F84 */
    const int32_t b9_y = round_32(b9_y_17);  /* F52, |x| <= 4.18e-08 */
    const int64_t b9_z_17 = (int64_t)954437177 /* 1/9 */ * b9_z_16;  /* F84 */
    const int32_t b9_z = round_32(b9_z_17);  /* F52, |x| <= 4.18e-08 */

    /* b_10 = 1/10 sum_j b_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t b10_x_1 = (int64_t)b9_y * W0_z;  /* F86 */
    const int64_t b10_x_2 = (int64_t)b9_z * W0_y_negated;  /* F86 */
    const int64_t b10_x_3 = b10_x_1 + b10_x_2;  /* F86 */
    const int64_t b10_x_4 = (int64_t)b8_y * W1_z;  /* F86 */
    const int64_t b10_x_5 = b10_x_3 + b10_x_4;  /* F86 */
    const int64_t b10_x_6 = (int64_t)b8_z * W1_y_negated;  /* F86 */
    const int64_t b10_x_7 = b10_x_5 + b10_x_6;  /* F86 */
    const int64_t b10_x_8 = (int64_t)b7_y * W2_z;  /* F84 */
    const int64_t b10_x_9 = b10_x_8 * INT64_C(4);  /* F86 */
    const int64_t b10_x_10 = b10_x_7 + b10_x_9;  /* F86 */
    const int64_t b10_x_11 = (int64_t)b7_z * W2_y_negated;  /* F84 */
    const int64_t b10_x_12 = b10_x_11 * INT64_C(4);  /* F86 */
    const int64_t b10_x_13 = b10_x_10 + b10_x_12;  /* F86 */
    const int32_t b10_x_14 = round_32(b10_x_13);  /* F54, |x| <= 8.72e-08 */
    const int64_t b10_y_1 = (int64_t)b9_z * W0_x;  /* F86 */
    const int64_t b10_y_2 = (int64_t)b9_x * W0_z_negated;  /* F86 */
    const int64_t b10_y_3 = b10_y_1 + b10_y_2;  /* F86 */
    const int64_t b10_y_4 = (int64_t)b8_z * W1_x;  /* F86 */
    const int64_t b10_y_5 = b10_y_3 + b10_y_4;  /* F86 */
    const int64_t b10_y_6 = (int64_t)b8_x * W1_z_negated;  /* F86 */
    const int64_t b10_y_7 = b10_y_5 + b10_y_6;  /* F86 */
    const int64_t b10_y_8 = (int64_t)b7_z * W2_x;  /* F84 */
    const int64_t b10_y_9 = b10_y_8 * INT64_C(4);  /* F86 */
    const int64_t b10_y_10 = b10_y_7 + b10_y_9;  /* F86 */
    const int64_t b10_y_11 = (int64_t)b7_x * W2_z_negated;  /* F84 */
    const int64_t b10_y_12 = b10_y_11 * INT64_C(4);  /* F86 */
    const int64_t b10_y_13 = b10_y_10 + b10_y_12;  /* F86 */
    const int32_t b10_y_14 = round_32(b10_y_13);  /* F54, |x| <= 8.72e-08 */
    const int64_t b10_z_1 = (int64_t)b9_x * W0_y;  /* F86 */
    const int64_t b10_z_2 = (int64_t)b9_y * W0_x_negated;  /* F86 */
    const int64_t b10_z_3 = b10_z_1 + b10_z_2;  /* F86 */
    const int64_t b10_z_4 = (int64_t)b8_x * W1_y;  /* F86 */
    const int64_t b10_z_5 = b10_z_3 + b10_z_4;  /* F86 */
    const int64_t b10_z_6 = (int64_t)b8_y * W1_x_negated;  /* F86 */
    const int64_t b10_z_7 = b10_z_5 + b10_z_6;  /* F86 */
    const int64_t b10_z_8 = (int64_t)b7_x * W2_y;  /* F84 */
    const int64_t b10_z_9 = b10_z_8 * INT64_C(4);  /* F86 */
    const int64_t b10_z_10 = b10_z_7 + b10_z_9;  /* F86 */
    const int64_t b10_z_11 = (int64_t)b7_y * W2_x_negated;  /* F84 */
    const int64_t b10_z_12 = b10_z_11 * INT64_C(4);  /* F86 */
    const int64_t b10_z_13 = b10_z_10 + b10_z_12;  /* F86 */
    const int32_t b10_z_14 = round_32(b10_z_13);  /* F54, |x| <= 8.72e-08 */

    /* e_a = (1 - |a|^2)/2   [re-orthogonalisation of the rows a, b] */
    const int64_t e_a_1 = (int64_t)c_11 * c_11;  /* F60 */
    const int64_t e_a_2 = (int64_t)c_12 * c_12;  /* F60 */
    const int64_t e_a_3 = e_a_1 + e_a_2;  /* F61 */
    const int64_t e_a_4 = (int64_t)c_13 * c_13;  /* F60 */
    const int64_t e_a_5 = e_a_3 + e_a_4;  /* F61 */
    const int64_t e_a_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_a_5;  /* F61 */
    const int32_t e_a = round_30(e_a_6);  /* F31, |x| <= 0.501 */

    /* e_b = (1 - |b|^2)/2   [re-orthogonalisation of the rows a, b] */
    const int64_t e_b_1 = (int64_t)c_21 * c_21;  /* F60 */
    const int64_t e_b_2 = (int64_t)c_22 * c_22;  /* F60 */
    const int64_t e_b_3 = e_b_1 + e_b_2;  /* F61 */
    const int64_t e_b_4 = (int64_t)c_23 * c_23;  /* F60 */
    const int64_t e_b_5 = e_b_3 + e_b_4;  /* F61 */
    const int64_t e_b_6 = INT64_C(1152921504606846976) /* 1/2 */ - e_b_5;  /* F61 */
    const int32_t e_b = round_30(e_b_6);  /* F31, |x| <= 0.501 */

    /* e_ab = a . b   [re-orthogonalisation of the rows a, b] */
    const int64_t e_ab_1 = (int64_t)c_11 * c_21;  /* F60 */
    const int64_t e_ab_2 = (int64_t)c_12 * c_22;  /* F60 */
    const int64_t e_ab_3 = e_ab_1 + e_ab_2;  /* F60 */
    const int64_t e_ab_4 = (int64_t)c_13 * c_23;  /* F60 */
    const int64_t e_ab_5 = e_ab_3 + e_ab_4;  /* F60 */
    const int32_t e_ab = round_30(e_ab_5);  /* F30, |x| <= 1.49 */

    /* a_10 = 1/10 sum_j a_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t a10_x_15 = (int64_t)858993459 /* 1/10 */ * a10_x_14;  /* F87 */
    const int32_t a10_x = round_29(a10_x_15);  /* F58, |x| <= 4.67e-09 */

    /* a_next = a + da */
    const int64_t a_next_x_1 = c_11 * INT64_C(2147483648);  /* F61 */
    const int64_t a_next_x_2 = a1_x * INT64_C(268435456);  /* F61 */
    const int64_t a_next_x_3 = a_next_x_1 + a_next_x_2;  /* F61 */
    const int64_t a_next_x_4 = a2_x * INT64_C(67108864);  /* F61 */
    const int64_t a_next_x_5 = a_next_x_3 + a_next_x_4;  /* F61 */
    const int64_t a_next_x_6 = a3_x * INT64_C(33554432);  /* F61 */
    const int64_t a_next_x_7 = a_next_x_5 + a_next_x_6;  /* F61 */
    const int64_t a_next_x_8 = a4_x * INT64_C(2097152);  /* F61 */
    const int64_t a_next_x_9 = a_next_x_7 + a_next_x_8;  /* F61 */
    const int64_t a_next_x_10 = a5_x * INT64_C(262144);  /* F61 */
    const int64_t a_next_x_11 = a_next_x_9 + a_next_x_10;  /* F61 */
    const int64_t a_next_x_12 = a6_x * INT64_C(32768);  /* F61 */
    const int64_t a_next_x_13 = a_next_x_11 + a_next_x_12;  /* F61 */
    const int64_t a_next_x_14 = a7_x * INT64_C(4096);  /* F61 */
    const int64_t a_next_x_15 = a_next_x_13 + a_next_x_14;  /* F61 */
    const int64_t a_next_x_16 = a8_x * INT64_C(512);  /* F61 */
    const int64_t a_next_x_17 = a_next_x_15 + a_next_x_16;  /* F61 */
    const int64_t a_next_x_18 = a9_x * INT64_C(512);  /* F61 */
    const int64_t a_next_x_19 = a_next_x_17 + a_next_x_18;  /* F61 */
    const int64_t a_next_x_20 = a10_x * INT64_C(8);  /* F61 */
    const int64_t a_next_x_21 = a_next_x_19 + a_next_x_20;  /* F61 */
    const int64_t a_next_x_22 = (int64_t)e_a * c_11;  /* F61 */
    const int64_t a_next_x_23 = a_next_x_21 + a_next_x_22;  /* F61 */
    const int32_t a_next_x = round_31(a_next_x_23);  /* F30, |x| <= 1.21 */

    /* a_10 = 1/10 sum_j a_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t a10_y_15 = (int64_t)858993459 /* 1/10 */ * a10_y_14;  /* F87 */
    const int32_t a10_y = round_29(a10_y_15);  /* F58, |x| <= 4.67e-09 */

    /* a_next = a + da */
    const int64_t a_next_y_1 = c_12 * INT64_C(2147483648);  /* F61 */
    const int64_t a_next_y_2 = a1_y * INT64_C(268435456);  /* F61 */
    const int64_t a_next_y_3 = a_next_y_1 + a_next_y_2;  /* F61 */
    const int64_t a_next_y_4 = a2_y * INT64_C(67108864);  /* F61 */
    const int64_t a_next_y_5 = a_next_y_3 + a_next_y_4;  /* F61 */
    const int64_t a_next_y_6 = a3_y * INT64_C(33554432);  /* F61 */
    const int64_t a_next_y_7 = a_next_y_5 + a_next_y_6;  /* F61 */
    const int64_t a_next_y_8 = a4_y * INT64_C(2097152);  /* F61 */
    const int64_t a_next_y_9 = a_next_y_7 + a_next_y_8;  /* F61 */
    const int64_t a_next_y_10 = a5_y * INT64_C(262144);  /* F61 */
    const int64_t a_next_y_11 = a_next_y_9 + a_next_y_10;  /* F61 */
    const int64_t a_next_y_12 = a6_y * INT64_C(32768);  /* F61 */
    const int64_t a_next_y_13 = a_next_y_11 + a_next_y_12;  /* F61 */
    const int64_t a_next_y_14 = a7_y * INT64_C(4096);  /* F61 */
    const int64_t a_next_y_15 = a_next_y_13 + a_next_y_14;  /* F61 */
    const int64_t a_next_y_16 = a8_y * INT64_C(512);  /* F61 */
    const int64_t a_next_y_17 = a_next_y_15 + a_next_y_16;  /* F61 */
    const int64_t a_next_y_18 = a9_y * INT64_C(512);  /* F61 */
    const int64_t a_next_y_19 = a_next_y_17 + a_next_y_18;  /* F61 */
    const int64_t a_next_y_20 = a10_y * INT64_C(8);  /* F61 */
    const int64_t a_next_y_21 = a_next_y_19 + a_next_y_20;  /* F61 */
    const int64_t a_next_y_22 = (int64_t)e_a * c_12;  /* F61 */
    const int64_t a_next_y_23 = a_next_y_21 + a_next_y_22;  /* F61 */
    const int32_t a_next_y = round_31(a_next_y_23);  /* F30, |x| <= 1.21 */

    /* a_10 = 1/10 sum_j a_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t a10_z_15 = (int64_t)858993459 /* 1/10 */ * a10_z_14;  /* F87 */
    const int32_t a10_z = round_29(a10_z_15);  /* F58, |x| <= 4.67e-09 */

    /* a_next = a + da */
    const int64_t a_next_z_1 = c_13 * INT64_C(2147483648);  /* F61 */
    const int64_t a_next_z_2 = a1_z * INT64_C(268435456);  /* F61 */
    const int64_t a_next_z_3 = a_next_z_1 + a_next_z_2;  /* F61 */
    const int64_t a_next_z_4 = a2_z * INT64_C(67108864);  /* F61 */
    const int64_t a_next_z_5 = a_next_z_3 + a_next_z_4;  /* F61 */
    const int64_t a_next_z_6 = a3_z * INT64_C(33554432);  /* F61 */
    const int64_t a_next_z_7 = a_next_z_5 + a_next_z_6;  /* F61 */
    const int64_t a_next_z_8 = a4_z * INT64_C(2097152);  /* F61 */
    const int64_t a_next_z_9 = a_next_z_7 + a_next_z_8;  /* F61 */
    const int64_t a_next_z_10 = a5_z * INT64_C(262144);  /* F61 */
    const int64_t a_next_z_11 = a_next_z_9 + a_next_z_10;  /* F61 */
    const int64_t a_next_z_12 = a6_z * INT64_C(32768);  /* F61 */
    const int64_t a_next_z_13 = a_next_z_11 + a_next_z_12;  /* F61 */
    const int64_t a_next_z_14 = a7_z * INT64_C(4096);  /* F61 */
    const int64_t a_next_z_15 = a_next_z_13 + a_next_z_14;  /* F61 */
    const int64_t a_next_z_16 = a8_z * INT64_C(512);  /* F61 */
    const int64_t a_next_z_17 = a_next_z_15 + a_next_z_16;  /* F61 */
    const int64_t a_next_z_18 = a9_z * INT64_C(512);  /* F61 */
    const int64_t a_next_z_19 = a_next_z_17 + a_next_z_18;  /* F61 */
    const int64_t a_next_z_20 = a10_z * INT64_C(8);  /* F61 */
    const int64_t a_next_z_21 = a_next_z_19 + a_next_z_20;  /* F61 */
    const int64_t a_next_z_22 = (int64_t)e_a * c_13;  /* F61 */
    const int64_t a_next_z_23 = a_next_z_21 + a_next_z_22;  /* F61 */
    const int32_t a_next_z = round_31(a_next_z_23);  /* F30, |x| <= 1.21 */

    /* b_10 = 1/10 sum_j b_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t b10_x_15 = (int64_t)858993459 /* 1/10 */ * b10_x_14;  /* F87 */
    const int32_t b10_x = round_29(b10_x_15);  /* F58, |x| <= 4.67e-09 */

    /* b_next = b + db */
    const int32_t e_ab_negated = -e_ab;  /* F30 */
    const int64_t b_next_x_1 = c_21 * INT64_C(2147483648);  /* F61 */
    const int64_t b_next_x_2 = b1_x * INT64_C(268435456);  /* F61 */
    const int64_t b_next_x_3 = b_next_x_1 + b_next_x_2;  /* F61 */
    const int64_t b_next_x_4 = b2_x * INT64_C(67108864);  /* F61 */
    const int64_t b_next_x_5 = b_next_x_3 + b_next_x_4;  /* F61 */
    const int64_t b_next_x_6 = b3_x * INT64_C(33554432);  /* F61 */
    const int64_t b_next_x_7 = b_next_x_5 + b_next_x_6;  /* F61 */
    const int64_t b_next_x_8 = b4_x * INT64_C(2097152);  /* F61 */
    const int64_t b_next_x_9 = b_next_x_7 + b_next_x_8;  /* F61 */
    const int64_t b_next_x_10 = b5_x * INT64_C(262144);  /* F61 */
    const int64_t b_next_x_11 = b_next_x_9 + b_next_x_10;  /* F61 */
    const int64_t b_next_x_12 = b6_x * INT64_C(32768);  /* F61 */
    const int64_t b_next_x_13 = b_next_x_11 + b_next_x_12;  /* F61 */
    const int64_t b_next_x_14 = b7_x * INT64_C(4096);  /* F61 */
    const int64_t b_next_x_15 = b_next_x_13 + b_next_x_14;  /* F61 */
    const int64_t b_next_x_16 = b8_x * INT64_C(512);  /* F61 */
    const int64_t b_next_x_17 = b_next_x_15 + b_next_x_16;  /* F61 */
    const int64_t b_next_x_18 = b9_x * INT64_C(512);  /* F61 */
    const int64_t b_next_x_19 = b_next_x_17 + b_next_x_18;  /* F61 */
    const int64_t b_next_x_20 = b10_x * INT64_C(8);  /* F61 */
    const int64_t b_next_x_21 = b_next_x_19 + b_next_x_20;  /* F61 */
    const int64_t b_next_x_22 = (int64_t)e_b * c_21;  /* F61 */
    const int64_t b_next_x_23 = b_next_x_21 + b_next_x_22;  /* F61 */
    const int64_t b_next_x_24 = (int64_t)e_ab_negated * c_11;  /* F60 */
    const int64_t b_next_x_25 = b_next_x_24 * INT64_C(2);  /* F61 */
    const int64_t b_next_x_26 = b_next_x_23 + b_next_x_25;  /* F61 */
    const int32_t b_next_x = round_31(b_next_x_26);  /* F30, |x| <= 1.21 */

    /* b_10 = 1/10 sum_j b_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t b10_y_15 = (int64_t)858993459 /* 1/10 */ * b10_y_14;  /* F87 */
    const int32_t b10_y = round_29(b10_y_15);  /* F58, |x| <= 4.67e-09 */

    /* b_next = b + db */
    const int64_t b_next_y_1 = c_22 * INT64_C(2147483648);  /* F61 */
    const int64_t b_next_y_2 = b1_y * INT64_C(268435456);  /* F61 */
    const int64_t b_next_y_3 = b_next_y_1 + b_next_y_2;  /* F61 */
    const int64_t b_next_y_4 = b2_y * INT64_C(67108864);  /* F61 */
    const int64_t b_next_y_5 = b_next_y_3 + b_next_y_4;  /* F61 */
    const int64_t b_next_y_6 = b3_y * INT64_C(33554432);  /* F61 */
    const int64_t b_next_y_7 = b_next_y_5 + b_next_y_6;  /* F61 */
    const int64_t b_next_y_8 = b4_y * INT64_C(2097152);  /* F61 */
    const int64_t b_next_y_9 = b_next_y_7 + b_next_y_8;  /* F61 */
    const int64_t b_next_y_10 = b5_y * INT64_C(262144);  /* F61 */
    const int64_t b_next_y_11 = b_next_y_9 + b_next_y_10;  /* F61 */
    const int64_t b_next_y_12 = b6_y * INT64_C(32768);  /* F61 */
    const int64_t b_next_y_13 = b_next_y_11 + b_next_y_12;  /* F61 */
    const int64_t b_next_y_14 = b7_y * INT64_C(4096);  /* F61 */
    const int64_t b_next_y_15 = b_next_y_13 + b_next_y_14;  /* F61 */
    const int64_t b_next_y_16 = b8_y * INT64_C(512);  /* F61 */
    const int64_t b_next_y_17 = b_next_y_15 + b_next_y_16;  /* F61 */
    const int64_t b_next_y_18 = b9_y * INT64_C(512);  /* F61 */
    const int64_t b_next_y_19 = b_next_y_17 + b_next_y_18;  /* F61 */
    const int64_t b_next_y_20 = b10_y * INT64_C(8);  /* F61 */
    const int64_t b_next_y_21 = b_next_y_19 + b_next_y_20;  /* F61 */
    const int64_t b_next_y_22 = (int64_t)e_b * c_22;  /* F61 */
    const int64_t b_next_y_23 = b_next_y_21 + b_next_y_22;  /* F61 */
    const int64_t b_next_y_24 = (int64_t)e_ab_negated * c_12;  /* F60 */
    const int64_t b_next_y_25 = b_next_y_24 * INT64_C(2);  /* F61 */
    const int64_t b_next_y_26 = b_next_y_23 + b_next_y_25;  /* F61 */
    const int32_t b_next_y = round_31(b_next_y_26);  /* F30, |x| <= 1.21 */

    /* b_10 = 1/10 sum_j b_(10-1-j) x W_j   [xu2019 (13)] */
    const int64_t b10_z_15 = (int64_t)858993459 /* 1/10 */ * b10_z_14;  /* F87 */
    const int32_t b10_z = round_29(b10_z_15);  /* F58, |x| <= 4.67e-09 */

    /* b_next = b + db */
    const int64_t b_next_z_1 = c_23 * INT64_C(2147483648);  /* F61 */
    const int64_t b_next_z_2 = b1_z * INT64_C(268435456);  /* F61 */
    const int64_t b_next_z_3 = b_next_z_1 + b_next_z_2;  /* F61 */
    const int64_t b_next_z_4 = b2_z * INT64_C(67108864);  /* F61 */
    const int64_t b_next_z_5 = b_next_z_3 + b_next_z_4;  /* F61 */
    const int64_t b_next_z_6 = b3_z * INT64_C(33554432);  /* F61 */
    const int64_t b_next_z_7 = b_next_z_5 + b_next_z_6;  /* F61 */
    const int64_t b_next_z_8 = b4_z * INT64_C(2097152);  /* F61 */
    const int64_t b_next_z_9 = b_next_z_7 + b_next_z_8;  /* F61 */
    const int64_t b_next_z_10 = b5_z * INT64_C(262144);  /* F61 */
    const int64_t b_next_z_11 = b_next_z_9 + b_next_z_10;  /* F61 */
    const int64_t b_next_z_12 = b6_z * INT64_C(32768);  /* F61 */
    const int64_t b_next_z_13 = b_next_z_11 + b_next_z_12;  /* F61 */
    const int64_t b_next_z_14 = b7_z * INT64_C(4096);  /* F61 */
    const int64_t b_next_z_15 = b_next_z_13 + b_next_z_14;  /* F61 */
    const int64_t b_next_z_16 = b8_z * INT64_C(512);  /* F61 */
    const int64_t b_next_z_17 = b_next_z_15 + b_next_z_16;  /* F61 */
    const int64_t b_next_z_18 = b9_z * INT64_C(512);  /* F61 */
    const int64_t b_next_z_19 = b_next_z_17 + b_next_z_18;  /* F61 */
    const int64_t b_next_z_20 = b10_z * INT64_C(8);  /* F61 */
    const int64_t b_next_z_21 = b_next_z_19 + b_next_z_20;  /* F61 */
    const int64_t b_next_z_22 = (int64_t)e_b * c_23;  /* F61 */
    const int64_t b_next_z_23 = b_next_z_21 + b_next_z_22;  /* F61 */
    const int64_t b_next_z_24 = (int64_t)e_ab_negated * c_13;  /* F60 */
    const int64_t b_next_z_25 = b_next_z_24 * INT64_C(2);  /* F61 */
    const int64_t b_next_z_26 = b_next_z_23 + b_next_z_25;  /* F61 */
    const int32_t b_next_z = round_31(b_next_z_26);  /* F30, |x| <= 1.21 */

    /* c_next = a_next x b_next */
    const int64_t c_next_x_1 = (int64_t)a_next_y * b_next_z;  /* F60 */
    const int64_t c_next_x_2 = (int64_t)a_next_z * b_next_y;  /* F60 */
    const int64_t c_next_x_3 = c_next_x_1 - c_next_x_2;  /* F60 */
    const int32_t c_next_x = round_30(c_next_x_3);  /* F30, |x| <= 1.46 */
    const int64_t c_next_y_1 = (int64_t)a_next_z * b_next_x;  /* F60 */
    const int64_t c_next_y_2 = (int64_t)a_next_x * b_next_z;  /* F60 */
    const int64_t c_next_y_3 = c_next_y_1 - c_next_y_2;  /* F60 */
    const int32_t c_next_y = round_30(c_next_y_3);  /* F30, |x| <= 1.46 */
    const int64_t c_next_z_1 = (int64_t)a_next_x * b_next_y;  /* F60 */
    const int64_t c_next_z_2 = (int64_t)a_next_y * b_next_x;  /* F60 */
    const int64_t c_next_z_3 = c_next_z_1 - c_next_z_2;  /* F60 */
    const int32_t c_next_z = round_30(c_next_z_3);  /* F30, |x| <= 1.46 */

    /* store */
    state->c[0] = a_next_x;
    state->c[1] = a_next_y;
    state->c[2] = a_next_z;
    state->c[3] = b_next_x;
    state->c[4] = b_next_y;
    state->c[5] = b_next_z;
    state->c[6] = c_next_x;
    state->c[7] = c_next_y;
    state->c[8] = c_next_z;
}

void dcm_taylor_3_10_fixed32_quaternion(const dcm_taylor_3_10_fixed32_state *state, int32_t q_nb[4])
{
    /* c, read once */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.49 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.49 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.49 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.49 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.49 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.49 */
    const int32_t c_31 = state->c[6];  /* F30, |x| <= 1.49 */
    const int32_t c_32 = state->c[7];  /* F30, |x| <= 1.49 */
    const int32_t c_33 = state->c[8];  /* F30, |x| <= 1.49 */

    /* ww = 4 w w, wx = 4 w x and so on   [Shepperd 1978] */
    const int64_t largest_1 = c_11 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_2 = (int64_t)c_22 + c_33;  /* F30 */
    const int64_t largest_3 = largest_1 - largest_2;  /* F30 */
    const int32_t largest_4 = round_2(largest_3);  /* F28, |x| <= 5.47 */
    const int64_t largest_5 = c_22 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_6 = (int64_t)c_11 + c_33;  /* F30 */
    const int64_t largest_7 = largest_5 - largest_6;  /* F30 */
    const int32_t largest_8 = round_2(largest_7);  /* F28, |x| <= 5.47 */
    const int64_t largest_9 = c_33 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int64_t largest_10 = (int64_t)c_11 + c_22;  /* F30 */
    const int64_t largest_11 = largest_9 - largest_10;  /* F30 */
    const int32_t largest_12 = round_2(largest_11);  /* F28, |x| <= 5.47 */
    const int64_t ww_1 = (int64_t)c_11 + c_22;  /* F30 */
    const int64_t ww_2 = ww_1 + c_33;  /* F30 */
    const int64_t ww_3 = ww_2 + INT64_C(1073741824) /* 1 */;  /* F30 */
    const int32_t ww = round_2(ww_3);  /* F28, |x| <= 5.47 */
    const int64_t wx_1 = (int64_t)c_32 - c_23;  /* F30 */
    const int32_t wx = round_1(wx_1);  /* F29, |x| <= 2.98 */
    const int64_t wy_1 = (int64_t)c_13 - c_31;  /* F30 */
    const int32_t wy = round_1(wy_1);  /* F29, |x| <= 2.98 */
    const int64_t wz_1 = (int64_t)c_21 - c_12;  /* F30 */
    const int32_t wz = round_1(wz_1);  /* F29, |x| <= 2.98 */
    const int64_t xy_1 = (int64_t)c_12 + c_21;  /* F30 */
    const int32_t xy = round_1(xy_1);  /* F29, |x| <= 2.98 */
    const int64_t xz_1 = (int64_t)c_13 + c_31;  /* F30 */
    const int32_t xz = round_1(xz_1);  /* F29, |x| <= 2.98 */
    const int64_t yz_1 = (int64_t)c_23 + c_32;  /* F30 */
    const int32_t yz = round_1(yz_1);  /* F29, |x| <= 2.98 */

    /* largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z   [Shepperd 1978] */
    const int32_t largest_13 = ww < largest_4;
    const int32_t largest_14 = (largest_13 != 0) ? largest_4 : ww;  /* F28, |x| <= 5.47 */
    const int32_t wx_aligned = round_short_1(wx);  /* F28 */
    const int32_t q_nb_w_1 = (largest_13 != 0) ? wx_aligned : ww;  /* F28, |x| <= 5.47 */
    const int32_t wx_aligned_2 = round_short_1(wx);  /* F28 */
    const int32_t q_nb_x_1 = (largest_13 != 0) ? largest_4 : wx_aligned_2;  /* F28, |x| <= 5.47 */
    const int32_t q_nb_y_1 = (largest_13 != 0) ? xy : wy;  /* F29, |x| <= 2.98 */
    const int32_t q_nb_z_1 = (largest_13 != 0) ? xz : wz;  /* F29, |x| <= 2.98 */
    const int32_t largest_15 = largest_14 < largest_8;
    const int32_t largest_16 = (largest_15 != 0) ? largest_8 : largest_14;  /* F28, |x| <= 5.47 */
    const int32_t wy_aligned = round_short_1(wy);  /* F28 */
    const int32_t q_nb_w_3 = (largest_15 != 0) ? wy_aligned : q_nb_w_1;  /* F28, |x| <= 5.47 */
    const int32_t xy_aligned = round_short_1(xy);  /* F28 */
    const int32_t q_nb_x_3 = (largest_15 != 0) ? xy_aligned : q_nb_x_1;  /* F28, |x| <= 5.47 */
    const int32_t q_nb_y_3 = round_short_1(q_nb_y_1);  /* F28 */
    const int32_t q_nb_y_4 = (largest_15 != 0) ? largest_8 : q_nb_y_3;  /* F28, |x| <= 5.47 */
    const int32_t q_nb_z_3 = (largest_15 != 0) ? yz : q_nb_z_1;  /* F29, |x| <= 2.98 */
    const int32_t largest_17 = largest_16 < largest_12;
    const int32_t largest = (largest_17 != 0) ? largest_12 : largest_16;  /* F28, |x| <= 5.47 */
    const int32_t wz_aligned = round_short_1(wz);  /* F28 */
    const int32_t q_nb_w_4 = (largest_17 != 0) ? wz_aligned : q_nb_w_3;  /* F28, |x| <= 5.47 */
    const int32_t xz_aligned = round_short_1(xz);  /* F28 */
    const int32_t q_nb_x_4 = (largest_17 != 0) ? xz_aligned : q_nb_x_3;  /* F28, |x| <= 5.47 */
    const int32_t yz_aligned = round_short_1(yz);  /* F28 */
    const int32_t q_nb_y_5 = (largest_17 != 0) ? yz_aligned : q_nb_y_4;  /* F28, |x| <= 5.47 */
    const int32_t q_nb_z_4 = round_short_1(q_nb_z_3);  /* F28 */
    const int32_t q_nb_z_5 = (largest_17 != 0) ? largest_12 : q_nb_z_4;  /* F28, |x| <= 5.47 */

    /* scale = 1/(2 sqrt(largest)) */
    const int32_t q_nb_w_5 = clamp_32(largest, 268435456, 1073741824);  /* F28, |x| <= 4 */
    const int32_t q_nb_w_6 = -q_nb_w_5;  /* F28 */
    const int64_t q_nb_w_7 = (int64_t)747135655 /* 47816681919/17592186044416 */ * q_nb_w_6;  /* F66 */
    /* F66 */
    const int64_t q_nb_w_8 = INT64_C(3055335112074854400) /* 182112164025/4398046511104 */ + q_nb_w_7;
    const int32_t q_nb_w_9 = round_31(q_nb_w_8);  /* F35, |x| <= 0.0387 */
    const int64_t q_nb_w_10 = (int64_t)q_nb_w_5 * q_nb_w_9;  /* F63 */
    /* F63 */
    const int64_t q_nb_w_11 = q_nb_w_10 - INT64_C(2359226658135736320) /* 2249933870445/8796093022208 */;
    const int32_t q_nb_w_12 = round_30(q_nb_w_11);  /* F33, |x| <= 0.226 */
    const int64_t q_nb_w_13 = (int64_t)q_nb_w_5 * q_nb_w_12;  /* F61 */
    /* F61 */
    const int64_t q_nb_w_14 = INT64_C(1903359871809486848) /* 1815185424623/2199023255552 */ + q_nb_w_13;
    const int32_t q_nb_w_15 = round_30(q_nb_w_14);  /* F31, |x| <= 0.725 */
    const int64_t q_nb_w_16 = (int64_t)q_nb_w_5 * q_nb_w_15;  /* F59 */
    /* F59 */
    const int64_t q_nb_w_17 = q_nb_w_16 - INT64_C(873312016427581440) /* 13325683844415/8796093022208 */;
    const int32_t q_nb_w_18 = round_29(q_nb_w_17);  /* F30, |x| <= 1.82 */
    const int64_t q_nb_w_19 = (int64_t)q_nb_w_5 * q_nb_w_18;  /* F58 */
    /* F58 */
    const int64_t q_nb_w_20 = INT64_C(549302309616861184) /* 33526752295951/17592186044416 */ + q_nb_w_19;
    const int32_t q_nb_w_21 = round_30(q_nb_w_20);  /* F28, |x| <= 7.44 */
    const int32_t q_nb_w_22 = clamp_32(q_nb_w_21, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t q_nb_w_23 = (int64_t)q_nb_w_22 * q_nb_w_22;  /* F56 */
    const int32_t q_nb_w_24 = round_26(q_nb_w_23);  /* F30, |x| <= 1.57 */
    const int64_t q_nb_w_25 = (int64_t)q_nb_w_6 * q_nb_w_24;  /* F58 */
    const int64_t q_nb_w_26 = INT64_C(288230376151711744) /* 1 */ + q_nb_w_25;  /* F58 */
    const int32_t q_nb_w_27 = round_30(q_nb_w_26);  /* F28, |x| <= 5.26 */
    const int64_t q_nb_w_28 = q_nb_w_22 * INT64_C(536870912);  /* F57 */
    const int64_t q_nb_w_29 = (int64_t)q_nb_w_22 * q_nb_w_27;  /* F56 */
    const int64_t q_nb_w_30 = q_nb_w_28 + q_nb_w_29;  /* F57 */
    const int32_t q_nb_w_31 = round_28(q_nb_w_30);  /* F29, |x| <= 3.04 */
    const int32_t q_nb_w_32 = clamp_32(q_nb_w_31, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t q_nb_w_33 = (int64_t)q_nb_w_32 * q_nb_w_32;  /* F58 */
    const int32_t q_nb_w_34 = round_28(q_nb_w_33);  /* F30, |x| <= 1.57 */
    const int64_t q_nb_w_35 = (int64_t)q_nb_w_6 * q_nb_w_34;  /* F58 */
    const int64_t q_nb_w_36 = INT64_C(288230376151711744) /* 1 */ + q_nb_w_35;  /* F58 */
    const int32_t q_nb_w_37 = round_30(q_nb_w_36);  /* F28, |x| <= 5.26 */
    const int64_t q_nb_w_38 = q_nb_w_32 * INT64_C(536870912);  /* F58 */
    const int64_t q_nb_w_39 = (int64_t)q_nb_w_32 * q_nb_w_37;  /* F57 */
    const int64_t q_nb_w_40 = q_nb_w_38 + q_nb_w_39;  /* F58 */
    const int32_t q_nb_w_41 = round_29(q_nb_w_40);  /* F29, |x| <= 3.04 */
    const int32_t q_nb_w_42 = clamp_32(q_nb_w_41, 134217728, 671088640);  /* F29, |x| <= 1.25 */

    /* q_nb = scale (its row)   [Shepperd 1978] */
    const int64_t q_nb_w_43 = (int64_t)q_nb_w_42 * q_nb_w_4;  /* F57 */
    const int32_t q_nb_w_44 = round_29(q_nb_w_43);  /* F29, |x| <= 3.42 */
    const int32_t q_nb_w = clamp_32(q_nb_w_44, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_x_5 = (int64_t)q_nb_w_42 * q_nb_x_4;  /* F57 */
    const int32_t q_nb_x_6 = round_29(q_nb_x_5);  /* F29, |x| <= 3.42 */
    const int32_t q_nb_x = clamp_32(q_nb_x_6, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_y_6 = (int64_t)q_nb_w_42 * q_nb_y_5;  /* F57 */
    const int32_t q_nb_y_7 = round_29(q_nb_y_6);  /* F29, |x| <= 3.42 */
    const int32_t q_nb_y = clamp_32(q_nb_y_7, -541065216, 541065216);  /* F29, |x| <= 1.01 */
    const int64_t q_nb_z_6 = (int64_t)q_nb_w_42 * q_nb_z_5;  /* F57 */
    const int32_t q_nb_z_7 = round_29(q_nb_z_6);  /* F29, |x| <= 3.42 */
    const int32_t q_nb_z = clamp_32(q_nb_z_7, -541065216, 541065216);  /* F29, |x| <= 1.01 */

    const int32_t q_nb_w_2 = q_nb_w * 2;  /* F30, |x| <= 1.01 */
    q_nb[0] = q_nb_w_2;
    const int32_t q_nb_x_2 = q_nb_x * 2;  /* F30, |x| <= 1.01 */
    q_nb[1] = q_nb_x_2;
    const int32_t q_nb_y_2 = q_nb_y * 2;  /* F30, |x| <= 1.01 */
    q_nb[2] = q_nb_y_2;
    const int32_t q_nb_z_2 = q_nb_z * 2;  /* F30, |x| <= 1.01 */
    q_nb[3] = q_nb_z_2;
}

void dcm_taylor_3_10_fixed32_dcm(const dcm_taylor_3_10_fixed32_state *state, int32_t c_nb[9])
{
    /* c, read once */
    const int32_t c_11 = state->c[0];  /* F30, |x| <= 1.49 */
    const int32_t c_12 = state->c[1];  /* F30, |x| <= 1.49 */
    const int32_t c_13 = state->c[2];  /* F30, |x| <= 1.49 */
    const int32_t c_21 = state->c[3];  /* F30, |x| <= 1.49 */
    const int32_t c_22 = state->c[4];  /* F30, |x| <= 1.49 */
    const int32_t c_23 = state->c[5];  /* F30, |x| <= 1.49 */
    const int32_t c_31 = state->c[6];  /* F30, |x| <= 1.49 */
    const int32_t c_32 = state->c[7];  /* F30, |x| <= 1.49 */
    const int32_t c_33 = state->c[8];  /* F30, |x| <= 1.49 */

    c_nb[0] = c_11;
    c_nb[1] = c_12;
    c_nb[2] = c_13;
    c_nb[3] = c_21;
    c_nb[4] = c_22;
    c_nb[5] = c_23;
    c_nb[6] = c_31;
    c_nb[7] = c_32;
    c_nb[8] = c_33;
}
