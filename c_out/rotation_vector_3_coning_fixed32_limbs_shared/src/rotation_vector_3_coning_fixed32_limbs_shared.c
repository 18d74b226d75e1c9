/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_fixed32_limbs_shared
 *
 * qcone 0.1.0, design rotation_vector_3_coning_fixed32_limbs_shared, SHA-256 of the design
 * 37ef9f3efdc9ae36c9b4470805ce06cb34e31ad6fb1d661db741d7d5deb0d374
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums as in 64; every sum of products rounded once, to
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
 * products:    of 16- and 15-bit limbs, added before the carry, proved to fit 32 bits, alike sums
 *              in functions of their own: cortex-m0 has none of 64 bits
 * high words:  8 of 20 rounded sums of products drop a whole word, 1 before formats were searched
 *              for that; of one update's errors in the first order it made 2.3e-09 of 2.2e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       44       0   37        13       0       0     0     0     0       0      0
 * update shared           40       4   37        13       0       0     0     0     0       0      0
 * update emitted         151       0  129       126       6       0     0     0     0       0    184
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_fixed32_limbs_shared.h"

#if ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_SHARED_VERSION != 1
#error "rotation_vector_3_coning_fixed32_limbs_shared.h is of another version than this file: generate both again"
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

/* x / 2^9, rounded down. */
static inline int32_t floor_short_9(int32_t x)
{
    return shift_right_32(x, 9);
}

/* x / 2^10, rounded down. */
static inline int32_t floor_short_10(int32_t x)
{
    return shift_right_32(x, 10);
}

/* x / 2^15, rounded down. */
static inline int32_t floor_short_15(int32_t x)
{
    return shift_right_32(x, 15);
}

/* x / 2^16, rounded down. */
static inline int32_t floor_short_16(int32_t x)
{
    return shift_right_32(x, 16);
}

/* x / 2^17, rounded down. */
static inline int32_t floor_short_17(int32_t x)
{
    return shift_right_32(x, 17);
}

/* whole - 2^15 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_15(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 15);
    return wrapped_32(left);
}

/* whole - 2^16 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_16(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 16);
    return wrapped_32(left);
}

/* whole - 2^17 rounded; the result fits 32 bits. */
static inline int32_t left_of_short_17(int32_t whole, int32_t rounded)
{
    const uint32_t left = (uint32_t)whole - ((uint32_t)rounded << 17);
    return wrapped_32(left);
}

/* The last 15 bits of x, from -2^14 on: x less a multiple of 2^15. */
static inline int32_t low_15(int32_t x)
{
    return shift_right_32(wrapped_32((uint32_t)x << 17), 17);
}

/* The last 16 bits of x, from -2^15 on: x less a multiple of 2^16. */
static inline int32_t low_16(int32_t x)
{
    return shift_right_32(wrapped_32((uint32_t)x << 16), 16);
}

/* x / 2^1, rounded to nearest, halves up. */
static inline int32_t round_short_1(int32_t x)
{
    return shift_right_32(x + 1, 1);
}

/* x / 2^2, rounded to nearest, halves up. */
static inline int32_t round_short_2(int32_t x)
{
    return shift_right_32(x + 2, 2);
}

/* x / 2^3, rounded to nearest, halves up. */
static inline int32_t round_short_3(int32_t x)
{
    return shift_right_32(x + 4, 3);
}

/* x / 2^4, rounded to nearest, halves up. */
static inline int32_t round_short_4(int32_t x)
{
    return shift_right_32(x + 8, 4);
}

/* x / 2^5, rounded to nearest, halves up. */
static inline int32_t round_short_5(int32_t x)
{
    return shift_right_32(x + 16, 5);
}

/* x / 2^10, rounded to nearest, halves up. */
static inline int32_t round_short_10(int32_t x)
{
    return shift_right_32(x + 512, 10);
}

/* x / 2^14, rounded to nearest, halves up. */
static inline int32_t round_short_14(int32_t x)
{
    return shift_right_32(x + 8192, 14);
}

/* x / 2^15, rounded to nearest, halves up. */
static inline int32_t round_short_15(int32_t x)
{
    return shift_right_32(x + 16384, 15);
}

/* x / 2^16, rounded to nearest, halves up. */
static inline int32_t round_short_16(int32_t x)
{
    return shift_right_32(x + 32768, 16);
}

void rotation_vector_3_coning_fixed32_limbs_shared_init(
    rotation_vector_3_coning_fixed32_limbs_shared_state *state)
{
    state->q[0] = 1073741824 /* 1 */;
    state->q[1] = 0;
    state->q[2] = 0;
    state->q[3] = 0;
}

static int32_t rotation_vector_3_coning_fixed32_limbs_shared_set_quaternion_sum_1(
    const int32_t word_in0, const int32_t word_in1)
{
    /* sum = (a b) / 2^30 in raw words, of limbs */
    const int32_t a = word_in0;  /* F40, |x| <= 0.000978 */
    const int32_t b = word_in1;  /* F30, |x| <= 1.01 */
    const int32_t a_low = low_16(a);  /* F40 */
    const int32_t a_high_1 = a - a_low;  /* F40 */
    const int32_t a_high = floor_short_16(a_high_1);  /* F24 */
    const int32_t b_high = floor_short_16(b);  /* F14 */
    const int32_t b_low = left_of_short_16(b, b_high);  /* F30 */
    const int32_t sum_1 = a_low * b_low;  /* F70 */
    const int32_t sum_2 = a_low * b_high;  /* F54 */
    const int32_t sum_3 = a_high * b_low;  /* F54 */
    const int32_t sum_4 = sum_2 + sum_3;  /* F54 */
    const int32_t sum_5 = a_high * b_high;  /* F38 */
    const int32_t sum_6 = floor_short_16(sum_1);  /* F54 */
    const int32_t sum_7 = sum_4 + sum_6;  /* F54 */
    const int32_t sum_8 = round_short_14(sum_7);  /* F40 */
    const int32_t sum_9 = sum_5 * 4;  /* F40 */
    const int32_t sum = sum_8 + sum_9;  /* F40, |x| <= 0.000978 */
    return sum;
}

void rotation_vector_3_coning_fixed32_limbs_shared_set_quaternion(
    rotation_vector_3_coning_fixed32_limbs_shared_state *state, const int32_t q_nb[4])
{
    /* q_nb, read once */
    const int32_t q_nb_w = q_nb[0];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_x = q_nb[1];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_y = q_nb[2];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_z = q_nb[3];  /* F30, |x| <= 1.01 */

    /* e = (1 - |q|^2)/2 */
    const int32_t q_nb_w_low = low_16(q_nb_w);  /* F30 */
    const int32_t q_nb_w_high_1 = q_nb_w - q_nb_w_low;  /* F30 */
    const int32_t q_nb_w_high = floor_short_16(q_nb_w_high_1);  /* F14 */
    const int32_t q_nb_x_low = low_16(q_nb_x);  /* F30 */
    const int32_t q_nb_x_high_1 = q_nb_x - q_nb_x_low;  /* F30 */
    const int32_t q_nb_x_high = floor_short_16(q_nb_x_high_1);  /* F14 */
    const int32_t q_nb_y_low = low_16(q_nb_y);  /* F30 */
    const int32_t q_nb_y_high_1 = q_nb_y - q_nb_y_low;  /* F30 */
    const int32_t q_nb_y_high = floor_short_16(q_nb_y_high_1);  /* F14 */
    const int32_t q_nb_z_low = low_16(q_nb_z);  /* F30 */
    const int32_t q_nb_z_high_1 = q_nb_z - q_nb_z_low;  /* F30 */
    const int32_t q_nb_z_high = floor_short_16(q_nb_z_high_1);  /* F14 */
    const int32_t e_1 = q_nb_w_low * q_nb_w_low;  /* F60 */
    const int32_t e_2 = -e_1;  /* F61 */
    const int32_t e_3 = q_nb_w_low * q_nb_w_high;  /* F44 */
    const int32_t e_4 = -e_3;  /* F44 */
    const int32_t e_5 = q_nb_w_high * q_nb_w_high;  /* F28 */
    const int32_t e_6 = 268435456 - e_5;  /* F29 */
    const int32_t e_7 = q_nb_x_low * q_nb_x_low;  /* F60 */
    const int32_t e_8 = e_2 - e_7;  /* F61 */
    const int32_t e_9 = q_nb_x_low * q_nb_x_high;  /* F44 */
    const int32_t e_10 = e_4 - e_9;  /* F44 */
    const int32_t e_11 = q_nb_x_high * q_nb_x_high;  /* F28 */
    const int32_t e_12 = e_6 - e_11;  /* F29 */
    const int32_t e_13 = q_nb_y_low * q_nb_y_low;  /* F60 */
    const int32_t e_14 = -e_13;  /* F61 */
    const int32_t e_15 = q_nb_y_low * q_nb_y_high;  /* F44 */
    const int32_t e_16 = e_10 - e_15;  /* F44 */
    const int32_t e_17 = q_nb_y_high * q_nb_y_high;  /* F28 */
    const int32_t e_18 = e_12 - e_17;  /* F29 */
    const int32_t e_19 = q_nb_z_low * q_nb_z_low;  /* F60 */
    const int32_t e_20 = e_14 - e_19;  /* F61 */
    const int32_t e_21 = q_nb_z_low * q_nb_z_high;  /* F44 */
    const int32_t e_22 = e_16 - e_21;  /* F44 */
    const int32_t e_23 = q_nb_z_high * q_nb_z_high;  /* F28 */
    const int32_t e_24 = e_18 - e_23;  /* F29 */
    const int32_t e_25 = floor_short_17(e_20);  /* F44 */
    const int32_t e_26 = left_of_short_17(e_20, e_25);  /* F61 */
    const int32_t e_27 = e_8 + e_26;  /* F61 */
    const int32_t e_28 = floor_short_17(e_27);  /* F44 */
    const int32_t e_29 = e_22 + e_28;  /* F44 */
    const int32_t e_30 = e_29 + e_25;  /* F44 */
    const int32_t e_31 = round_short_4(e_30);  /* F40 */
    const int32_t e_32 = e_24 * 2048;  /* F40 */
    const int32_t e = e_31 + e_32;  /* F40, |x| <= 0.000978 */

    /* q_next = q + e q */
    /* F40, |x| <= 0.000978 */
    const int32_t q_next_w_part = rotation_vector_3_coning_fixed32_limbs_shared_set_quaternion_sum_1(e, q_nb_w);
    const int32_t q_next_w_fine = round_short_10(q_next_w_part);  /* F30 */
    const int32_t q_next_w = q_next_w_fine + q_nb_w;  /* F30, |x| <= 1.01 */
    /* F40, |x| <= 0.000978 */
    const int32_t q_next_x_part = rotation_vector_3_coning_fixed32_limbs_shared_set_quaternion_sum_1(e, q_nb_x);
    const int32_t q_next_x_fine = round_short_10(q_next_x_part);  /* F30 */
    const int32_t q_next_x = q_next_x_fine + q_nb_x;  /* F30, |x| <= 1.01 */
    /* F40, |x| <= 0.000978 */
    const int32_t q_next_y_part = rotation_vector_3_coning_fixed32_limbs_shared_set_quaternion_sum_1(e, q_nb_y);
    const int32_t q_next_y_fine = round_short_10(q_next_y_part);  /* F30 */
    const int32_t q_next_y = q_next_y_fine + q_nb_y;  /* F30, |x| <= 1.01 */
    /* F40, |x| <= 0.000978 */
    const int32_t q_next_z_part = rotation_vector_3_coning_fixed32_limbs_shared_set_quaternion_sum_1(e, q_nb_z);
    const int32_t q_next_z_fine = round_short_10(q_next_z_part);  /* F30 */
    const int32_t q_next_z = q_next_z_fine + q_nb_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

static int32_t rotation_vector_3_coning_fixed32_limbs_shared_update_sum_1(const int32_t word_in0)
{
    /* sum = (1932735283 a) / 2^32 in raw words, of limbs */
    const int32_t a = word_in0;  /* F34, |x| <= 0.0667 */
    const int32_t a_low = low_16(a);  /* F34 */
    const int32_t a_high_1 = a - a_low;  /* F34 */
    const int32_t a_high = floor_short_16(a_high_1);  /* F18 */
    const int32_t sum_1 = 13107 * a_low;  /* F67 */
    const int32_t sum_2 = 13107 * a_high;  /* F51 */
    const int32_t sum_3 = 29491 * a_low;  /* F51 */
    const int32_t sum_4 = sum_2 + sum_3;  /* F51 */
    const int32_t sum_5 = 29491 * a_high;  /* F35 */
    const int32_t sum_6 = floor_short_16(sum_1);  /* F51 */
    const int32_t sum_7 = sum_4 + sum_6;  /* F51 */
    const int32_t sum_8 = round_short_16(sum_7);  /* F35 */
    const int32_t sum = sum_8 + sum_5;  /* F35, |x| <= 0.0151 */
    return sum;
}

static int32_t rotation_vector_3_coning_fixed32_limbs_shared_update_sum_2(
    const int32_t word_in0, const int32_t word_in1, const int32_t word_in2, const int32_t word_in3)
{
    /* sum = (a b - c d) / 2^34 in raw words, of limbs */
    const int32_t a = word_in0;  /* F33, |x| <= 0.167 */
    const int32_t b = word_in1;  /* F35, |x| <= 0.0151 */
    const int32_t c = word_in2;  /* F33, |x| <= 0.167 */
    const int32_t d = word_in3;  /* F35, |x| <= 0.0151 */
    const int32_t a_low = low_16(a);  /* F33 */
    const int32_t a_high_1 = a - a_low;  /* F33 */
    const int32_t a_high = floor_short_16(a_high_1);  /* F17 */
    const int32_t b_low = low_16(b);  /* F35 */
    const int32_t b_high_1 = b - b_low;  /* F35 */
    const int32_t b_high = floor_short_16(b_high_1);  /* F19 */
    const int32_t c_low = low_16(c);  /* F33 */
    const int32_t c_high_1 = c - c_low;  /* F33 */
    const int32_t c_high = floor_short_16(c_high_1);  /* F17 */
    const int32_t d_low = low_16(d);  /* F35 */
    const int32_t d_high_1 = d - d_low;  /* F35 */
    const int32_t d_high = floor_short_16(d_high_1);  /* F19 */
    const int32_t sum_1 = a_low * b_low;  /* F68 */
    const int32_t sum_2 = a_low * b_high;  /* F52 */
    const int32_t sum_3 = a_high * b_low;  /* F52 */
    const int32_t sum_4 = sum_2 + sum_3;  /* F52 */
    const int32_t sum_5 = a_high * b_high;  /* F36 */
    const int32_t sum_6 = c_low * d_low;  /* F68 */
    const int32_t sum_7 = sum_1 - sum_6;  /* F68 */
    const int32_t sum_8 = c_low * d_high;  /* F52 */
    const int32_t sum_9 = sum_4 - sum_8;  /* F52 */
    const int32_t sum_10 = c_high * d_low;  /* F52 */
    const int32_t sum_11 = sum_9 - sum_10;  /* F52 */
    const int32_t sum_12 = c_high * d_high;  /* F36 */
    const int32_t sum_13 = sum_5 - sum_12;  /* F36 */
    const int32_t sum_14 = floor_short_16(sum_7);  /* F52 */
    const int32_t sum_15 = sum_11 + sum_14;  /* F52 */
    const int32_t sum_16 = floor_short_16(sum_15);  /* F36 */
    const int32_t sum_17 = sum_13 + sum_16;  /* F36 */
    const int32_t sum = round_short_2(sum_17);  /* F34, |x| <= 0.00251 */
    return sum;
}

static int32_t rotation_vector_3_coning_fixed32_limbs_shared_update_sum_3(
    const int32_t word_in0, const int32_t word_in1)
{
    /* sum = (a b) / 2^35 in raw words, of limbs */
    const int32_t a = word_in0;  /* F36, |x| <= 0.000218 */
    const int32_t b = word_in1;  /* F34, |x| <= 0.103 */
    const int32_t a_low = low_16(a);  /* F36 */
    const int32_t a_high_1 = a - a_low;  /* F36 */
    const int32_t a_high = floor_short_16(a_high_1);  /* F20 */
    const int32_t b_high = floor_short_16(b);  /* F18 */
    const int32_t b_low = left_of_short_16(b, b_high);  /* F34 */
    const int32_t sum_1 = a_low * b_low;  /* F70 */
    const int32_t sum_2 = a_low * b_high;  /* F54 */
    const int32_t sum_3 = a_high * b_low;  /* F54 */
    const int32_t sum_4 = sum_2 + sum_3;  /* F54 */
    const int32_t sum_5 = a_high * b_high;  /* F38 */
    const int32_t sum_6 = floor_short_16(sum_1);  /* F54 */
    const int32_t sum_7 = sum_4 + sum_6;  /* F54 */
    const int32_t sum_8 = floor_short_16(sum_7);  /* F38 */
    const int32_t sum_9 = sum_5 + sum_8;  /* F38 */
    const int32_t sum = round_short_3(sum_9);  /* F35, |x| <= 2.23e-05 */
    return sum;
}

static int32_t rotation_vector_3_coning_fixed32_limbs_shared_update_sum_4(
    const int32_t word_in0, const int32_t word_in1, const int32_t word_in2, const int32_t word_in3,
    const int32_t word_in4, const int32_t word_in5, const int32_t word_in6, const int32_t word_in7)
{
    /* sum = (a b + c d + e f - g h) / 2^35 in raw words, of limbs */
    const int32_t a = word_in0;  /* F30, |x| <= 1.01 */
    const int32_t b = word_in1;  /* F35, |x| <= 0.0512 */
    const int32_t c = word_in2;  /* F30, |x| <= 1.01 */
    const int32_t d = word_in3;  /* F35, |x| <= 0.00522 */
    const int32_t e = word_in4;  /* F30, |x| <= 1.01 */
    const int32_t f = word_in5;  /* F35, |x| <= 0.0512 */
    const int32_t g = word_in6;  /* F30, |x| <= 1.01 */
    const int32_t h = word_in7;  /* F35, |x| <= 0.0512 */
    const int32_t a_low = low_16(a);  /* F30 */
    const int32_t a_high_1 = a - a_low;  /* F30 */
    const int32_t a_high = floor_short_16(a_high_1);  /* F14 */
    const int32_t b_low = low_16(b);  /* F35 */
    const int32_t b_high_1 = b - b_low;  /* F35 */
    const int32_t b_high = floor_short_16(b_high_1);  /* F19 */
    const int32_t c_high = floor_short_16(c);  /* F14 */
    const int32_t c_low = left_of_short_16(c, c_high);  /* F30 */
    const int32_t d_low = low_16(d);  /* F35 */
    const int32_t d_high_1 = d - d_low;  /* F35 */
    const int32_t d_high = floor_short_16(d_high_1);  /* F19 */
    const int32_t e_low = low_16(e);  /* F30 */
    const int32_t e_high_1 = e - e_low;  /* F30 */
    const int32_t e_high = floor_short_16(e_high_1);  /* F14 */
    const int32_t f_low = low_16(f);  /* F35 */
    const int32_t f_high_1 = f - f_low;  /* F35 */
    const int32_t f_high = floor_short_16(f_high_1);  /* F19 */
    const int32_t g_low = low_16(g);  /* F30 */
    const int32_t g_high_1 = g - g_low;  /* F30 */
    const int32_t g_high = floor_short_16(g_high_1);  /* F14 */
    const int32_t h_low = low_16(h);  /* F35 */
    const int32_t h_high_1 = h - h_low;  /* F35 */
    const int32_t h_high = floor_short_16(h_high_1);  /* F19 */
    const int32_t sum_1 = a_low * b_low;  /* F65 */
    const int32_t sum_2 = a_low * b_high;  /* F49 */
    const int32_t sum_3 = a_high * b_low;  /* F49 */
    const int32_t sum_4 = sum_2 + sum_3;  /* F49 */
    const int32_t sum_5 = a_high * b_high;  /* F33 */
    const int32_t sum_6 = c_low * d_low;  /* F65 */
    const int32_t sum_7 = c_low * d_high;  /* F49 */
    const int32_t sum_8 = sum_4 + sum_7;  /* F49 */
    const int32_t sum_9 = c_high * d_low;  /* F49 */
    const int32_t sum_10 = sum_8 + sum_9;  /* F49 */
    const int32_t sum_11 = c_high * d_high;  /* F33 */
    const int32_t sum_12 = sum_5 + sum_11;  /* F33 */
    const int32_t sum_13 = e_low * f_low;  /* F65 */
    const int32_t sum_14 = e_low * f_high;  /* F49 */
    const int32_t sum_15 = e_high * f_low;  /* F49 */
    const int32_t sum_16 = sum_14 + sum_15;  /* F49 */
    const int32_t sum_17 = e_high * f_high;  /* F33 */
    const int32_t sum_18 = sum_12 + sum_17;  /* F33 */
    const int32_t sum_19 = g_low * h_low;  /* F65 */
    const int32_t sum_20 = sum_13 - sum_19;  /* F65 */
    const int32_t sum_21 = g_high * h_low;  /* F49 */
    const int32_t sum_22 = sum_16 - sum_21;  /* F49 */
    const int32_t sum_23 = g_low * h_high;  /* F49 */
    const int32_t sum_24 = -sum_23;  /* F49 */
    const int32_t sum_25 = g_high * h_high;  /* F33 */
    const int32_t sum_26 = sum_18 - sum_25;  /* F33 */
    const int32_t sum_27 = floor_short_16(sum_6);  /* F49 */
    const int32_t sum_28 = left_of_short_16(sum_6, sum_27);  /* F65 */
    const int32_t sum_29 = sum_1 + sum_28;  /* F65 */
    const int32_t sum_30 = floor_short_16(sum_20);  /* F49 */
    const int32_t sum_31 = left_of_short_16(sum_20, sum_30);  /* F65 */
    const int32_t sum_32 = sum_29 + sum_31;  /* F65 */
    const int32_t sum_33 = floor_short_16(sum_32);  /* F49 */
    const int32_t sum_34 = sum_10 + sum_33;  /* F49 */
    const int32_t sum_35 = sum_34 + sum_27;  /* F49 */
    const int32_t sum_36 = sum_35 + sum_30;  /* F49 */
    const int32_t sum_37 = floor_short_16(sum_22);  /* F33 */
    const int32_t sum_38 = left_of_short_16(sum_22, sum_37);  /* F49 */
    const int32_t sum_39 = sum_36 + sum_38;  /* F49 */
    const int32_t sum_40 = floor_short_16(sum_24);  /* F33 */
    const int32_t sum_41 = left_of_short_16(sum_24, sum_40);  /* F49 */
    const int32_t sum_42 = sum_39 + sum_41;  /* F49 */
    const int32_t sum_43 = floor_short_16(sum_42);  /* F33 */
    const int32_t sum_44 = sum_26 + sum_43;  /* F33 */
    const int32_t sum_45 = sum_44 + sum_37;  /* F33 */
    const int32_t sum_46 = sum_45 + sum_40;  /* F33 */
    const int32_t sum = round_short_3(sum_46);  /* F30, |x| <= 0.0516 */
    return sum;
}

void rotation_vector_3_coning_fixed32_limbs_shared_update(
    rotation_vector_3_coning_fixed32_limbs_shared_state *state, const int32_t dtheta[9])
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
    /* F35, |x| <= 0.0151 */
    const int32_t k_x = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_1(d_x);
    /* F35, |x| <= 0.0151 */
    const int32_t k_y = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_1(d_y);
    /* F35, |x| <= 0.0151 */
    const int32_t k_z = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_1(d_z);

    /* coning = g x k   [cao (12)] */
    /* F34, |x| <= 0.00251 */
    const int32_t coning_x = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_2(g_y, k_z, g_z, k_y);

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_x = S_x + coning_x;  /* F34, |x| <= 0.103 */

    /* coning = g x k   [cao (12)] */
    /* F34, |x| <= 0.00251 */
    const int32_t coning_y = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_2(g_z, k_x, g_x, k_z);

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_y = S_y + coning_y;  /* F34, |x| <= 0.103 */

    /* coning = g x k   [cao (12)] */
    /* F34, |x| <= 0.00251 */
    const int32_t coning_z = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_2(g_x, k_y, g_y, k_x);

    /* phi = S + coning   [cao (12)] */
    const int32_t phi_z = S_z + coning_z;  /* F34, |x| <= 0.103 */

    /* phi_square = |phi|^2 */
    const int32_t phi_x_low = low_16(phi_x);  /* F34 */
    const int32_t phi_x_high_1 = phi_x - phi_x_low;  /* F34 */
    const int32_t phi_x_high = floor_short_16(phi_x_high_1);  /* F18 */
    const int32_t phi_y_low = low_16(phi_y);  /* F34 */
    const int32_t phi_y_high_1 = phi_y - phi_y_low;  /* F34 */
    const int32_t phi_y_high = floor_short_16(phi_y_high_1);  /* F18 */
    const int32_t phi_z_low = low_16(phi_z);  /* F34 */
    const int32_t phi_z_high_1 = phi_z - phi_z_low;  /* F34 */
    const int32_t phi_z_high = floor_short_16(phi_z_high_1);  /* F18 */
    const int32_t phi_square_1 = phi_x_low * phi_x_low;  /* F68 */
    const int32_t phi_square_2 = phi_x_low * phi_x_high;  /* F52 */
    const int32_t phi_square_3 = phi_x_high * phi_x_high;  /* F36 */
    const int32_t phi_square_4 = phi_y_low * phi_y_low;  /* F68 */
    const int32_t phi_square_5 = phi_y_low * phi_y_high;  /* F52 */
    const int32_t phi_square_6 = phi_square_2 + phi_square_5;  /* F51 */
    const int32_t phi_square_7 = phi_y_high * phi_y_high;  /* F36 */
    const int32_t phi_square_8 = phi_square_3 + phi_square_7;  /* F36 */
    const int32_t phi_square_9 = phi_z_low * phi_z_low;  /* F68 */
    const int32_t phi_square_10 = phi_z_low * phi_z_high;  /* F52 */
    const int32_t phi_square_11 = phi_square_6 + phi_square_10;  /* F51 */
    const int32_t phi_square_12 = phi_z_high * phi_z_high;  /* F36 */
    const int32_t phi_square_13 = phi_square_8 + phi_square_12;  /* F36 */
    const int32_t phi_square_14 = floor_short_17(phi_square_4);  /* F51 */
    const int32_t phi_square_15 = left_of_short_17(phi_square_4, phi_square_14);  /* F68 */
    const int32_t phi_square_16 = phi_square_1 + phi_square_15;  /* F68 */
    const int32_t phi_square_17 = floor_short_17(phi_square_9);  /* F51 */
    const int32_t phi_square_18 = left_of_short_17(phi_square_9, phi_square_17);  /* F68 */
    const int32_t phi_square_19 = phi_square_16 + phi_square_18;  /* F68 */
    const int32_t phi_square_20 = floor_short_17(phi_square_19);  /* F51 */
    const int32_t phi_square_21 = phi_square_11 + phi_square_20;  /* F51 */
    const int32_t phi_square_22 = phi_square_21 + phi_square_14;  /* F51 */
    const int32_t phi_square_23 = phi_square_22 + phi_square_17;  /* F51 */
    const int32_t phi_square_24 = round_short_15(phi_square_23);  /* F36 */
    const int32_t phi_square = phi_square_24 + phi_square_13;  /* F36, |x| <= 0.0105 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int32_t phi_square_high = floor_short_16(phi_square);  /* F20 */
    const int32_t phi_square_low = left_of_short_16(phi_square, phi_square_high);  /* F36 */
    const int32_t u_1 = -20405 * phi_square_low;  /* F70 */
    const int32_t u_2 = 19644 - u_1;  /* F70 */
    const int32_t u_3 = -20405 * phi_square_high;  /* F54 */
    const int32_t u_4 = 29434 - u_3;  /* F54 */
    const int32_t u_5 = 6 * phi_square_low;  /* F54 */
    const int32_t u_6 = u_4 - u_5;  /* F54 */
    const int32_t u_7 = 6 * phi_square_high;  /* F38 */
    const int32_t u_8 = 164 - u_7;  /* F38 */
    const int32_t u_9 = floor_short_16(u_2);  /* F54 */
    const int32_t u_10 = u_6 + u_9;  /* F54 */
    const int32_t u_11 = floor_short_16(u_10);  /* F38 */
    const int32_t u_12 = u_8 + u_11;  /* F38 */
    const int32_t u_13 = floor_short_10(u_12);  /* F28 */
    const int32_t u_14 = u_13 + 699051;  /* F28, |x| <= 0.00261 */
    const int32_t u_15 = low_16(u_14);  /* F28 */
    const int32_t u_16 = u_14 - u_15;  /* F28 */
    const int32_t u_17 = floor_short_16(u_16);  /* F12 */
    const int32_t u_18 = phi_square_low * u_15;  /* F64 */
    const int32_t u_19 = phi_square_low * u_17;  /* F48 */
    const int32_t u_20 = phi_square_high * u_15;  /* F48 */
    const int32_t u_21 = u_19 + u_20;  /* F48 */
    const int32_t u_22 = phi_square_high * u_17;  /* F32 */
    const int32_t u_23 = u_22 - 536870912;  /* F32 */
    const int32_t u_24 = floor_short_16(u_18);  /* F48 */
    const int32_t u_25 = u_21 + u_24;  /* F48 */
    const int32_t u_26 = round_short_16(u_25);  /* F32 */
    const int32_t u_27 = u_26 + u_23;  /* F32, |x| <= 0.126 */

    /* y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2   [cao (9)] */
    const int32_t y_1 = 4363 * phi_square_low;  /* F64 */
    const int32_t y_2 = 4363 * phi_square_high;  /* F48 */
    const int32_t y_3 = y_2 + phi_square_low;  /* F48 */
    const int32_t y_4 = y_1 + 31827;  /* F64 */
    const int32_t y_5 = y_3 + 50364;  /* F48 */
    const int32_t y_6 = phi_square_high - 89478485;  /* F32 */
    const int32_t y_7 = floor_short_16(y_4);  /* F48 */
    const int32_t y_8 = y_5 + y_7;  /* F48 */
    const int32_t y_9 = floor_short_16(y_8);  /* F32 */
    const int32_t y_10 = y_9 + y_6;  /* F32, |x| <= 0.0209 */
    const int32_t y_11 = low_16(y_10);  /* F32 */
    const int32_t y_12 = y_10 - y_11;  /* F32 */
    const int32_t y_13 = floor_short_16(y_12);  /* F16 */
    const int32_t y_14 = phi_square_low * y_11;  /* F68 */
    const int32_t y_15 = phi_square_low * y_13;  /* F52 */
    const int32_t y_16 = phi_square_high * y_11;  /* F52 */
    const int32_t y_17 = y_15 + y_16;  /* F52 */
    const int32_t y_18 = phi_square_high * y_13;  /* F36 */
    const int32_t y_19 = floor_short_16(y_14);  /* F52 */
    const int32_t y_20 = y_17 + y_19;  /* F52 */
    const int32_t y_21 = round_short_16(y_20);  /* F36 */
    const int32_t y = y_21 + y_18;  /* F36, |x| <= 0.000218 */

    /* bent = y phi   [cao (14)] */
    /* F35, |x| <= 2.23e-05 */
    const int32_t bent_x = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_3(y, phi_x);

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_x = phi_x + bent_x;  /* F35, |x| <= 0.0512 */

    /* bent = y phi   [cao (14)] */
    /* F35, |x| <= 2.23e-05 */
    const int32_t bent_y = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_3(y, phi_y);

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_y = phi_y + bent_y;  /* F35, |x| <= 0.0512 */

    /* bent = y phi   [cao (14)] */
    /* F35, |x| <= 2.23e-05 */
    const int32_t bent_z = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_3(y, phi_z);

    /* v = phi/2 + bent   [cao (14)] */
    const int32_t v_z = phi_z + bent_z;  /* F35, |x| <= 0.0512 */

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int32_t u_28 = low_16(u_27);  /* F32 */
    const int32_t u_29 = u_27 - u_28;  /* F32 */
    const int32_t u_30 = floor_short_16(u_29);  /* F16 */
    const int32_t u_31 = phi_square_low * u_28;  /* F68 */
    const int32_t u_32 = phi_square_low * u_30;  /* F52 */
    const int32_t u_33 = phi_square_high * u_28;  /* F52 */
    const int32_t u_34 = u_32 + u_33;  /* F52 */
    const int32_t u_35 = phi_square_high * u_30;  /* F36 */
    const int32_t u_36 = floor_short_16(u_31);  /* F52 */
    const int32_t u_37 = u_34 + u_36;  /* F52 */
    const int32_t u_38 = round_short_16(u_37);  /* F36 */
    const int32_t u = u_38 + u_35;  /* F36, |x| <= 0.00131 */

    /* attitude and input */
    const int32_t q_w = state->q[0];  /* F30, |x| <= 1.01 */
    const int32_t q_x = state->q[1];  /* F30, |x| <= 1.01 */
    const int32_t q_y = state->q[2];  /* F30, |x| <= 1.01 */
    const int32_t q_z = state->q[3];  /* F30, |x| <= 1.01 */

    /* a = u + e */
    const int32_t q_w_low = low_15(q_w);  /* F30 */
    const int32_t q_w_high_1 = q_w - q_w_low;  /* F30 */
    const int32_t q_w_high = floor_short_15(q_w_high_1);  /* F15 */
    const int32_t q_x_low = low_15(q_x);  /* F30 */
    const int32_t q_x_high_1 = q_x - q_x_low;  /* F30 */
    const int32_t q_x_high = floor_short_15(q_x_high_1);  /* F15 */
    const int32_t q_y_low = low_15(q_y);  /* F30 */
    const int32_t q_y_high_1 = q_y - q_y_low;  /* F30 */
    const int32_t q_y_high = floor_short_15(q_y_high_1);  /* F15 */
    const int32_t q_z_low = low_15(q_z);  /* F30 */
    const int32_t q_z_high_1 = q_z - q_z_low;  /* F30 */
    const int32_t q_z_high = floor_short_15(q_z_high_1);  /* F15 */
    const int32_t a_1 = q_w_low * q_w_low;  /* F60 */
    const int32_t a_2 = -a_1;  /* F61 */
    const int32_t a_3 = q_w_low * q_w_high;  /* F45 */
    const int32_t a_4 = -a_3;  /* F45 */
    const int32_t a_5 = q_w_high * q_w_high;  /* F30 */
    const int32_t a_6 = 1073741824 - a_5;  /* F31 */
    const int32_t a_7 = q_x_low * q_x_low;  /* F60 */
    const int32_t a_8 = a_2 - a_7;  /* F61 */
    const int32_t a_9 = q_x_low * q_x_high;  /* F45 */
    const int32_t a_10 = a_4 - a_9;  /* F45 */
    const int32_t a_11 = q_x_high * q_x_high;  /* F30 */
    const int32_t a_12 = a_6 - a_11;  /* F31 */
    const int32_t a_13 = q_y_low * q_y_low;  /* F60 */
    const int32_t a_14 = a_8 - a_13;  /* F61 */
    const int32_t a_15 = q_y_low * q_y_high;  /* F45 */
    const int32_t a_16 = a_10 - a_15;  /* F45 */
    const int32_t a_17 = q_y_high * q_y_high;  /* F30 */
    const int32_t a_18 = a_12 - a_17;  /* F31 */
    const int32_t a_19 = q_z_low * q_z_low;  /* F60 */
    const int32_t a_20 = a_14 - a_19;  /* F61 */
    const int32_t a_21 = q_z_low * q_z_high;  /* F45 */
    const int32_t a_22 = a_16 - a_21;  /* F45 */
    const int32_t a_23 = q_z_high * q_z_high;  /* F30 */
    const int32_t a_24 = a_18 - a_23;  /* F31 */
    const int32_t a_25 = floor_short_16(a_20);  /* F45 */
    const int32_t a_26 = a_22 + a_25;  /* F45 */
    const int32_t a_27 = floor_short_9(a_26);  /* F36 */
    const int32_t a_28 = u + a_27;  /* F36 */
    const int32_t a_29 = round_short_1(a_28);  /* F35 */
    const int32_t a_30 = a_24 * 16;  /* F35 */
    const int32_t a = a_29 + a_30;  /* F35, |x| <= 0.00522 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int32_t a_low = low_15(a);  /* F35 */
    const int32_t a_high_1 = a - a_low;  /* F35 */
    const int32_t a_high = floor_short_15(a_high_1);  /* F20 */
    const int32_t v_x_low = low_15(v_x);  /* F35 */
    const int32_t v_x_high_1 = v_x - v_x_low;  /* F35 */
    const int32_t v_x_high = floor_short_15(v_x_high_1);  /* F20 */
    const int32_t v_y_low = low_15(v_y);  /* F35 */
    const int32_t v_y_high_1 = v_y - v_y_low;  /* F35 */
    const int32_t v_y_high = floor_short_15(v_y_high_1);  /* F20 */
    const int32_t v_z_low = low_15(v_z);  /* F35 */
    const int32_t v_z_high_1 = v_z - v_z_low;  /* F35 */
    const int32_t v_z_high = floor_short_15(v_z_high_1);  /* F20 */
    const int32_t dq_w_1 = q_w_low * a_low;  /* F65 */
    const int32_t dq_w_2 = q_w_low * a_high;  /* F50 */
    const int32_t dq_w_3 = q_w_high * a_low;  /* F50 */
    const int32_t dq_w_4 = dq_w_2 + dq_w_3;  /* F50 */
    const int32_t dq_w_5 = q_w_high * a_high;  /* F35 */
    const int32_t dq_w_6 = q_x_low * v_x_low;  /* F65 */
    const int32_t dq_w_7 = dq_w_1 - dq_w_6;  /* F65 */
    const int32_t dq_w_8 = q_x_low * v_x_high;  /* F50 */
    const int32_t dq_w_9 = dq_w_4 - dq_w_8;  /* F50 */
    const int32_t dq_w_10 = q_x_high * v_x_low;  /* F50 */
    const int32_t dq_w_11 = dq_w_9 - dq_w_10;  /* F50 */
    const int32_t dq_w_12 = q_x_high * v_x_high;  /* F35 */
    const int32_t dq_w_13 = dq_w_5 - dq_w_12;  /* F35 */
    const int32_t dq_w_14 = q_y_low * v_y_low;  /* F65 */
    const int32_t dq_w_15 = dq_w_7 - dq_w_14;  /* F65 */
    const int32_t dq_w_16 = q_y_high * v_y_low;  /* F50 */
    const int32_t dq_w_17 = dq_w_11 - dq_w_16;  /* F50 */
    const int32_t dq_w_18 = q_y_low * v_y_high;  /* F50 */
    const int32_t dq_w_19 = -dq_w_18;  /* F50 */
    const int32_t dq_w_20 = q_y_high * v_y_high;  /* F35 */
    const int32_t dq_w_21 = dq_w_13 - dq_w_20;  /* F35 */
    const int32_t dq_w_22 = q_z_low * v_z_low;  /* F65 */
    const int32_t dq_w_23 = dq_w_15 - dq_w_22;  /* F65 */
    const int32_t dq_w_24 = q_z_high * v_z_low;  /* F50 */
    const int32_t dq_w_25 = dq_w_17 - dq_w_24;  /* F50 */
    const int32_t dq_w_26 = q_z_low * v_z_high;  /* F50 */
    const int32_t dq_w_27 = dq_w_19 - dq_w_26;  /* F50 */
    const int32_t dq_w_28 = q_z_high * v_z_high;  /* F35 */
    const int32_t dq_w_29 = dq_w_21 - dq_w_28;  /* F35 */
    const int32_t dq_w_30 = floor_short_15(dq_w_23);  /* F50 */
    const int32_t dq_w_31 = dq_w_25 + dq_w_30;  /* F50 */
    const int32_t dq_w_32 = floor_short_15(dq_w_27);  /* F35 */
    const int32_t dq_w_33 = left_of_short_15(dq_w_27, dq_w_32);  /* F50 */
    const int32_t dq_w_34 = dq_w_31 + dq_w_33;  /* F50 */
    const int32_t dq_w_35 = floor_short_15(dq_w_34);  /* F35 */
    const int32_t dq_w_36 = dq_w_29 + dq_w_35;  /* F35 */
    const int32_t dq_w_37 = dq_w_36 + dq_w_32;  /* F35 */
    const int32_t dq_w = round_short_5(dq_w_37);  /* F30, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int32_t q_next_w = q_w + dq_w;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    /* F30, |x| <= 0.0516 */
    const int32_t dq_x = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_4(
        q_w, v_x, q_x, a, q_y, v_z, q_z, v_y);

    /* q_next = q + dq */
    const int32_t q_next_x = q_x + dq_x;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    /* F30, |x| <= 0.0516 */
    const int32_t dq_y = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_4(
        q_w, v_y, q_y, a, q_z, v_x, q_x, v_z);

    /* q_next = q + dq */
    const int32_t q_next_y = q_y + dq_y;  /* F30, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    /* F30, |x| <= 0.0516 */
    const int32_t dq_z = rotation_vector_3_coning_fixed32_limbs_shared_update_sum_4(
        q_w, v_z, q_z, a, q_x, v_y, q_y, v_x);

    /* q_next = q + dq */
    const int32_t q_next_z = q_z + dq_z;  /* F30, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_fixed32_limbs_shared_quaternion(
    const rotation_vector_3_coning_fixed32_limbs_shared_state *state, int32_t q_nb[4])
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
