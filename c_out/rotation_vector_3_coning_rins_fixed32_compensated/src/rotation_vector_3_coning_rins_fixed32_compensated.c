/* Generated, do not edit. Made by: qcone generate rins.toml --design rotation_vector_3_coning_rins_fixed32_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rins_fixed32_compensated, SHA-256 of the design
 * df93b9e268c92fe753740a4652d4fd6e421dacea013b8e2311eb9cfeb3a0c7d0
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      cao (12), cao (14)
 * stage:       encoder angle and tilt of a rotating unit corrected, rins (10) to (16); the
 *              attitude kept is the sensors'
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
 * unit:        encoder angle at most 3 pi in size; sqrt(A^2 + B^2) + |C| of each harmonic at most
 *              0.0029089 rad (600 arcsec)
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.5e-15 (scalar), 5.5e-15 (vector), proved over the rationals
 * rounding:    one update is within 4.3e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  10 of 16 rounded sums of products drop a whole word, 2 before formats were searched
 *              for that; of one update's errors in the first order it made 4.4e-10 of 4.1e-10
 *
 * operations                 multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written                44       0   37        13       0       0     0     0     0       0      0
 * update shared                    40       4   37        13       0       0     0     0     0       0      0
 * update emitted                   40       0   43        16       3       0     0     0     0       0     34
 * dcm as-written                    9       0    9         6       0       0     0     0     0       0      0
 * dcm shared                        9       0    9         6       0       0     0     0     0       0      0
 * dcm emitted                       9       0    6         6       0       0     0     0     0       0     19
 * euler as-written                 82       0   43        19       9       3     0     0    26      54      0
 * euler shared                     54      26   43        19       9       3     0     0    26      54      0
 * euler emitted                    54       0   33        28      11       3     0     0    26      85    143
 * correct as-written               26       0   19         6       3       0     0     0     5       9      0
 * correct shared                   25       1   19         6       3       0     0     0     5       9      0
 * correct emitted                  25       0   14        10       5       0     0     0     5      14     34
 * body_quaternion as-written       49       0   27         5      11       0     0     0     5       9      0
 * body_quaternion shared           44       5   21        11       3       0     0     0     5       9      0
 * body_quaternion emitted          44       0   21        11       8       0     0     0     5      18     52
 * body_dcm as-written               9       0    9         6       0       0     0     0     0       0      0
 * body_dcm shared                   9       0    9         6       0       0     0     0     0       0      0
 * body_dcm emitted                  9       0    6         6       0       0     0     0     0       0     15
 * body_euler as-written            82       0   43        19       9       3     0     0    26      54      0
 * body_euler shared                54      26   43        19       9       3     0     0    26      54      0
 * body_euler emitted               54       0   33        28      11       3     0     0    26      85    139
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_rins_fixed32_compensated.h"

#if ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_VERSION != 1
#error "rotation_vector_3_coning_rins_fixed32_compensated.h is of another version than this file: generate both again"
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

/* x, kept from low to high. */
static inline int32_t clamp_32(int32_t x, int32_t low, int32_t high)
{
    return ((x < low) ? low : ((x > high) ? high : x));
}

/* x, kept from low to high. */
static inline int64_t clamp_64(int64_t x, int64_t low, int64_t high)
{
    return ((x < low) ? low : ((x > high) ? high : x));
}

/* x, kept from low to high. */
static inline int32_t clamp_64_to_32(int64_t x, int64_t low, int64_t high)
{
    return (int32_t)((x < low) ? low : ((x > high) ? high : x));
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

/* x / 2^15, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_15(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(16384)) >> 15);
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

/* x / 2^23, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_23(int64_t x)
{
    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C(4194304)) >> 23);
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

/* x / 2^42, rounded to nearest, halves up; the result fits 32 bits. */
static inline int32_t round_42(int64_t x)
{
    return (int32_t)shift_right_64(x + INT64_C(2199023255552), 42);
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

/* x / 2^2, rounded to nearest, halves up. */
static inline int32_t round_short_2(int32_t x)
{
    return shift_right_32(x + 2, 2);
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

/* x / 2^17, rounded to nearest, halves up. */
static inline int32_t round_short_17(int32_t x)
{
    return shift_right_32(x + 65536, 17);
}

/* x / 2^3, rounded to nearest, halves up. */
static inline int64_t round_wide_3(int64_t x)
{
    return shift_right_64(x + INT64_C(4), 3);
}

/* x / 2^8, rounded to nearest, halves up. */
static inline int64_t round_wide_8(int64_t x)
{
    return shift_right_64(x + INT64_C(128), 8);
}

void rotation_vector_3_coning_rins_fixed32_compensated_init(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state)
{
    state->q[0] = INT64_C(4611686018427387904) /* 1 */;
    state->q[1] = INT64_C(0);
    state->q[2] = INT64_C(0);
    state->q[3] = INT64_C(0);
    state->azimuth_harmonic[0] = 0;
    state->azimuth_harmonic[1] = 0;
    state->azimuth_harmonic[2] = 0;
    state->tilt_x_harmonic[0] = 0;
    state->tilt_x_harmonic[1] = 0;
    state->tilt_x_harmonic[2] = 0;
    state->tilt_y_harmonic[0] = 0;
    state->tilt_y_harmonic[1] = 0;
    state->tilt_y_harmonic[2] = 0;
    state->residual[0] = 0;
    state->residual[1] = 0;
    state->residual[2] = 0;
    state->residual[3] = 0;
    state->residual[4] = 0;
    state->residual[5] = 0;
}

void rotation_vector_3_coning_rins_fixed32_compensated_set_quaternion(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t q_nb[4])
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

void rotation_vector_3_coning_rins_fixed32_compensated_update(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t dtheta[9])
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

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const int64_t u_7 = (int64_t)phi_square * u_6;  /* F70 */
    const int32_t u = round_32(u_7);  /* F38, |x| <= 0.00131 */

    /* a = u + e */
    const int64_t a_1 = u * INT64_C(8388608);  /* F61 */
    const int64_t a_2 = a_1 + INT64_C(1152921504606846976) /* 1/2 */;  /* F61 */

    /* attitude and input */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.01 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.01 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.01 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.01 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.01 */

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
    const int32_t v_x_negated = -v_x;  /* F35 */
    const int32_t v_y_negated = -v_y;  /* F35 */
    const int32_t v_z_negated = -v_z;  /* F35 */
    const int64_t dq_w_1 = (int64_t)q_w * a;  /* F65 */
    const int64_t dq_w_2 = (int64_t)q_x * v_x_negated;  /* F65 */
    const int64_t dq_w_3 = dq_w_1 + dq_w_2;  /* F65 */
    const int64_t dq_w_4 = (int64_t)q_y * v_y_negated;  /* F65 */
    const int64_t dq_w_5 = dq_w_3 + dq_w_4;  /* F65 */
    const int64_t dq_w_6 = (int64_t)q_z * v_z_negated;  /* F65 */
    const int64_t dq_w_7 = dq_w_5 + dq_w_6;  /* F65 */
    const int64_t dq_w = round_wide_3(dq_w_7);  /* F62, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int64_t q_next_w = q_w_whole + dq_w;  /* F62, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_x_1 = (int64_t)q_w * v_x;  /* F65 */
    const int64_t dq_x_2 = (int64_t)q_x * a;  /* F65 */
    const int64_t dq_x_3 = dq_x_1 + dq_x_2;  /* F65 */
    const int64_t dq_x_4 = (int64_t)q_y * v_z;  /* F65 */
    const int64_t dq_x_5 = dq_x_3 + dq_x_4;  /* F65 */
    const int64_t dq_x_6 = (int64_t)q_z * v_y_negated;  /* F65 */
    const int64_t dq_x_7 = dq_x_5 + dq_x_6;  /* F65 */
    const int64_t dq_x = round_wide_3(dq_x_7);  /* F62, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int64_t q_next_x = q_x_whole + dq_x;  /* F62, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_y_1 = (int64_t)q_w * v_y;  /* F65 */
    const int64_t dq_y_2 = (int64_t)q_y * a;  /* F65 */
    const int64_t dq_y_3 = dq_y_1 + dq_y_2;  /* F65 */
    const int64_t dq_y_4 = (int64_t)q_z * v_x;  /* F65 */
    const int64_t dq_y_5 = dq_y_3 + dq_y_4;  /* F65 */
    const int64_t dq_y_6 = (int64_t)q_x * v_z_negated;  /* F65 */
    const int64_t dq_y_7 = dq_y_5 + dq_y_6;  /* F65 */
    const int64_t dq_y = round_wide_3(dq_y_7);  /* F62, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int64_t q_next_y = q_y_whole + dq_y;  /* F62, |x| <= 1.01 */

    /* dq = q (x) [a, v]   [cao (14)] */
    const int64_t dq_z_1 = (int64_t)q_w * v_z;  /* F65 */
    const int64_t dq_z_2 = (int64_t)q_z * a;  /* F65 */
    const int64_t dq_z_3 = dq_z_1 + dq_z_2;  /* F65 */
    const int64_t dq_z_4 = (int64_t)q_x * v_y;  /* F65 */
    const int64_t dq_z_5 = dq_z_3 + dq_z_4;  /* F65 */
    const int64_t dq_z_6 = (int64_t)q_y * v_x_negated;  /* F65 */
    const int64_t dq_z_7 = dq_z_5 + dq_z_6;  /* F65 */
    const int64_t dq_z = round_wide_3(dq_z_7);  /* F62, |x| <= 0.0516 */

    /* q_next = q + dq */
    const int64_t q_next_z = q_z_whole + dq_z;  /* F62, |x| <= 1.01 */

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void rotation_vector_3_coning_rins_fixed32_compensated_quaternion(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, int32_t q_nb[4])
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.01 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.01 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.01 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.01 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.01 */

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}

void rotation_vector_3_coning_rins_fixed32_compensated_dcm(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, int32_t c_nb[9])
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.01 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.01 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.01 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.01 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.01 */

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

void rotation_vector_3_coning_rins_fixed32_compensated_euler(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, int32_t rpy[3])
{
    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.01 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.01 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.01 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.01 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.01 */

    /* half_sum = (yaw + roll)/2   [zxy] */
    const int64_t half_sum_1 = (int64_t)q_z + q_y;  /* F30 */
    const int32_t half_sum_2 = round_1(half_sum_1);  /* F29, |x| <= 2.01 */
    const int64_t half_sum_3 = (int64_t)q_w + q_x;  /* F30 */
    const int32_t half_sum_4 = round_1(half_sum_3);  /* F29, |x| <= 2.01 */
    const int64_t half_difference_1 = (int64_t)q_z - q_y;  /* F30 */
    const int32_t half_difference_2 = round_1(half_difference_1);  /* F29, |x| <= 2.01 */
    const int64_t half_difference_3 = (int64_t)q_w - q_x;  /* F30 */
    const int32_t half_difference_4 = round_1(half_difference_3);  /* F29, |x| <= 2.01 */
    const int32_t half_sum_5 = half_sum_2 < 0;
    const int32_t half_sum_6 = -half_sum_2;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_7 = (half_sum_5 != 0) ? half_sum_6 : half_sum_2;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_8 = half_sum_4 < 0;
    const int32_t half_sum_9 = -half_sum_4;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_10 = (half_sum_8 != 0) ? half_sum_9 : half_sum_4;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_11 = half_sum_10 < half_sum_7;
    const int32_t half_sum_12 = (half_sum_11 != 0) ? half_sum_10 : half_sum_7;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_13 = (half_sum_11 != 0) ? half_sum_7 : half_sum_10;  /* F29, |x| <= 2.01 */
    const int64_t half_sum_14 = (int64_t)889516847 /* 10355339/25000000 */ * half_sum_13;  /* F60 */
    const int32_t half_sum_15 = round_29(half_sum_14);  /* F31, |x| <= 0.832 */
    const int64_t half_sum_16 = half_sum_15 * INT64_C(1);  /* F31 */
    const int64_t half_sum_17 = half_sum_12 * INT64_C(4);  /* F31 */
    const int32_t half_sum_18 = half_sum_16 < half_sum_17;
    const int64_t half_sum_19 = (int64_t)half_sum_12 - half_sum_13;  /* F29 */
    const int32_t half_sum_20 = round_1(half_sum_19);  /* F28, |x| <= 4.02 */
    const int32_t half_sum_21 = round_short_1(half_sum_12);  /* F28 */
    const int32_t half_sum_22 = (half_sum_18 != 0) ? half_sum_20 : half_sum_21;  /* F28, |x| <= 4.02 */
    const int64_t half_sum_23 = (int64_t)half_sum_12 + half_sum_13;  /* F29 */
    const int32_t half_sum_24 = round_1(half_sum_23);  /* F28, |x| <= 4.02 */
    const int32_t half_sum_25 = round_short_1(half_sum_13);  /* F28 */
    const int32_t half_sum_26 = (half_sum_18 != 0) ? half_sum_24 : half_sum_25;  /* F28, |x| <= 4.02 */
    const int32_t half_sum_27 = clamp_32(half_sum_26, 2, 2147483647);  /* F28, |x| <= 4.02 */
    const int64_t half_sum_28 = half_sum_22 * INT64_C(4294967296);  /* F60 */
    const int64_t half_sum_29 = half_sum_28 / half_sum_27;  /* F32, |x| <= 5.39e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t half_sum_30 = clamp_64_to_32(half_sum_29, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t half_sum_31 = (int64_t)half_sum_30 * half_sum_30;  /* F64 */
    const int32_t half_sum_32 = round_31(half_sum_31);  /* F33, |x| <= 0.172 */
    const int64_t half_sum_33 = (int64_t)510875761 /* 382/6423 */ * half_sum_32;  /* F66 */
    const int64_t half_sum_34 = INT64_C(7773993415904670242) /* 1650/15661 */ - half_sum_33;  /* F66 */
    const int32_t half_sum_35 = round_34(half_sum_34);  /* F32, |x| <= 0.106 */
    const int64_t half_sum_36 = (int64_t)half_sum_32 * half_sum_35;  /* F65 */
    const int64_t half_sum_37 = half_sum_36 - INT64_C(5251586747234353517) /* 7339/51558 */;  /* F65 */
    const int32_t half_sum_38 = round_33(half_sum_37);  /* F32, |x| <= 0.143 */
    const int64_t half_sum_39 = (int64_t)half_sum_32 * half_sum_38;  /* F65 */
    const int64_t half_sum_40 = INT64_C(7377920055805538292) /* 58828/294171 */ + half_sum_39;  /* F65 */
    const int32_t half_sum_41 = round_34(half_sum_40);  /* F31, |x| <= 0.2 */
    const int64_t half_sum_42 = (int64_t)half_sum_32 * half_sum_41;  /* F64 */
    const int64_t half_sum_43 = half_sum_42 - INT64_C(6148909082171862706) /* 365415/1096246 */;  /* F64 */
    const int32_t half_sum_44 = round_32(half_sum_43);  /* F32, |x| <= 0.334 */
    const int64_t half_sum_45 = (int64_t)half_sum_32 * half_sum_44;  /* F65 */
    const int32_t half_sum_46 = round_30(half_sum_45);  /* F35, |x| <= 0.0573 */
    const int64_t half_sum_47 = (int64_t)half_sum_30 * half_sum_46;  /* F67 */
    const int32_t half_sum_48 = round_35(half_sum_47);  /* F32, |x| <= 0.0238 */
    const int32_t half_sum_49 = half_sum_30 + half_sum_48;  /* F32, |x| <= 0.439 */
    const int64_t half_sum_50 = INT64_C(3373259426) + half_sum_49;  /* F32 */
    const int32_t half_sum_51 = round_2(half_sum_50);  /* F30, |x| <= 1.23 */
    const int32_t half_sum_52 = round_short_2(half_sum_49);  /* F30 */
    const int32_t half_sum_53 = (half_sum_18 != 0) ? half_sum_51 : half_sum_52;  /* F30, |x| <= 1.23 */
    const int64_t half_sum_54 = INT64_C(1686629713) - half_sum_53;  /* F30 */
    const int32_t half_sum_55 = round_1(half_sum_54);  /* F29, |x| <= 2.01 */
    const int32_t half_sum_56 = round_short_1(half_sum_53);  /* F29 */
    const int32_t half_sum_57 = (half_sum_11 != 0) ? half_sum_55 : half_sum_56;  /* F29, |x| <= 2.01 */
    const int64_t half_sum_58 = INT64_C(1686629713) - half_sum_57;  /* F29 */
    const int32_t half_sum_59 = (int32_t)half_sum_58;  /* F29, |x| <= 3.58 */
    const int32_t half_sum_60 = (half_sum_8 != 0) ? half_sum_59 : half_sum_57;  /* F29, |x| <= 3.58 */
    const int32_t half_sum_61 = -half_sum_60;  /* F29, |x| <= 3.58 */
    const int32_t half_sum = (half_sum_5 != 0) ? half_sum_61 : half_sum_60;  /* F29, |x| <= 3.58 */

    /* half_difference = (yaw - roll)/2   [zxy] */
    const int32_t half_difference_5 = half_difference_2 < 0;
    const int32_t half_difference_6 = -half_difference_2;  /* F29, |x| <= 2.01 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_7 = (half_difference_5 != 0) ? half_difference_6 : half_difference_2;
    const int32_t half_difference_8 = half_difference_4 < 0;
    const int32_t half_difference_9 = -half_difference_4;  /* F29, |x| <= 2.01 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_10 = (half_difference_8 != 0) ? half_difference_9 : half_difference_4;
    const int32_t half_difference_11 = half_difference_10 < half_difference_7;
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_12 = (half_difference_11 != 0) ? half_difference_10 : half_difference_7;
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_13 = (half_difference_11 != 0) ? half_difference_7 : half_difference_10;
    /* F60 */
    const int64_t half_difference_14 = (int64_t)889516847 /* 10355339/25000000 */ * half_difference_13;
    const int32_t half_difference_15 = round_29(half_difference_14);  /* F31, |x| <= 0.832 */
    const int64_t half_difference_16 = half_difference_15 * INT64_C(1);  /* F31 */
    const int64_t half_difference_17 = half_difference_12 * INT64_C(4);  /* F31 */
    const int32_t half_difference_18 = half_difference_16 < half_difference_17;
    const int64_t half_difference_19 = (int64_t)half_difference_12 - half_difference_13;  /* F29 */
    const int32_t half_difference_20 = round_1(half_difference_19);  /* F28, |x| <= 4.02 */
    const int32_t half_difference_21 = round_short_1(half_difference_12);  /* F28 */
    /* F28, |x| <= 4.02 */
    const int32_t half_difference_22 = (half_difference_18 != 0) ? half_difference_20 : half_difference_21;
    const int64_t half_difference_23 = (int64_t)half_difference_12 + half_difference_13;  /* F29 */
    const int32_t half_difference_24 = round_1(half_difference_23);  /* F28, |x| <= 4.02 */
    const int32_t half_difference_25 = round_short_1(half_difference_13);  /* F28 */
    /* F28, |x| <= 4.02 */
    const int32_t half_difference_26 = (half_difference_18 != 0) ? half_difference_24 : half_difference_25;
    const int32_t half_difference_27 = clamp_32(half_difference_26, 2, 2147483647);  /* F28, |x| <= 4.02 */
    const int64_t half_difference_28 = half_difference_22 * INT64_C(4294967296);  /* F60 */
    const int64_t half_difference_29 = half_difference_28 / half_difference_27;  /* F32, |x| <= 5.39e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t half_difference_30 = clamp_64_to_32(half_difference_29, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t half_difference_31 = (int64_t)half_difference_30 * half_difference_30;  /* F64 */
    const int32_t half_difference_32 = round_31(half_difference_31);  /* F33, |x| <= 0.172 */
    const int64_t half_difference_33 = (int64_t)510875761 /* 382/6423 */ * half_difference_32;  /* F66 */
    /* F66 */
    const int64_t half_difference_34 = INT64_C(7773993415904670242) /* 1650/15661 */ - half_difference_33;
    const int32_t half_difference_35 = round_34(half_difference_34);  /* F32, |x| <= 0.106 */
    const int64_t half_difference_36 = (int64_t)half_difference_32 * half_difference_35;  /* F65 */
    /* F65 */
    const int64_t half_difference_37 = half_difference_36 - INT64_C(5251586747234353517) /* 7339/51558 */;
    const int32_t half_difference_38 = round_33(half_difference_37);  /* F32, |x| <= 0.143 */
    const int64_t half_difference_39 = (int64_t)half_difference_32 * half_difference_38;  /* F65 */
    /* F65 */
    const int64_t half_difference_40 = INT64_C(7377920055805538292) /* 58828/294171 */ + half_difference_39;
    const int32_t half_difference_41 = round_34(half_difference_40);  /* F31, |x| <= 0.2 */
    const int64_t half_difference_42 = (int64_t)half_difference_32 * half_difference_41;  /* F64 */
    /* F64 */
    const int64_t half_difference_43 = half_difference_42 - INT64_C(6148909082171862706) /* 365415/1096246 */;
    const int32_t half_difference_44 = round_32(half_difference_43);  /* F32, |x| <= 0.334 */
    const int64_t half_difference_45 = (int64_t)half_difference_32 * half_difference_44;  /* F65 */
    const int32_t half_difference_46 = round_30(half_difference_45);  /* F35, |x| <= 0.0573 */
    const int64_t half_difference_47 = (int64_t)half_difference_30 * half_difference_46;  /* F67 */
    const int32_t half_difference_48 = round_35(half_difference_47);  /* F32, |x| <= 0.0238 */
    const int32_t half_difference_49 = half_difference_30 + half_difference_48;  /* F32, |x| <= 0.439 */
    const int64_t half_difference_50 = INT64_C(3373259426) + half_difference_49;  /* F32 */
    const int32_t half_difference_51 = round_2(half_difference_50);  /* F30, |x| <= 1.23 */
    const int32_t half_difference_52 = round_short_2(half_difference_49);  /* F30 */
    /* F30, |x| <= 1.23 */
    const int32_t half_difference_53 = (half_difference_18 != 0) ? half_difference_51 : half_difference_52;
    const int64_t half_difference_54 = INT64_C(1686629713) - half_difference_53;  /* F30 */
    const int32_t half_difference_55 = round_1(half_difference_54);  /* F29, |x| <= 2.01 */
    const int32_t half_difference_56 = round_short_1(half_difference_53);  /* F29 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_57 = (half_difference_11 != 0) ? half_difference_55 : half_difference_56;
    const int64_t half_difference_58 = INT64_C(1686629713) - half_difference_57;  /* F29 */
    const int32_t half_difference_59 = (int32_t)half_difference_58;  /* F29, |x| <= 3.58 */
    /* F29, |x| <= 3.58 */
    const int32_t half_difference_60 = (half_difference_8 != 0) ? half_difference_59 : half_difference_57;
    const int32_t half_difference_61 = -half_difference_60;  /* F29, |x| <= 3.58 */
    /* F29, |x| <= 3.58 */
    const int32_t half_difference = (half_difference_5 != 0) ? half_difference_61 : half_difference_60;

    /* pitch = 2 atan(sqrt(up/down)) - pi/2   [zxy] */
    const int64_t pitch_1 = (int64_t)half_sum_4 * half_sum_4;  /* F58 */
    const int64_t pitch_3 = (int64_t)half_sum_2 * half_sum_2;  /* F58 */
    const int64_t pitch_4 = pitch_1 + pitch_3;  /* F60, |x| <= 2.02 */
    const int32_t pitch_5 = pitch_4 < INT64_C(268435456) /* 1/4294967296 */;
    /* F60, |x| <= 2.33e-10 */
    const int32_t pitch_6 = clamp_64_to_32(pitch_4, INT64_C(0), INT64_C(268435456));
    const int64_t pitch_7 = pitch_6 * INT64_C(1);  /* F28, |x| <= 1 */
    const int64_t pitch_8 = pitch_7 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_9 = (pitch_5 != 0) ? pitch_8 : pitch_4;  /* F60, |x| <= 2.02 */
    /* F31, |x| <= 0.501 */
    const int32_t pitch_10 = (pitch_5 != 0) ? 16384 /* 1/131072 */ : 1073741824 /* 1/2 */;
    const int32_t pitch_11 = pitch_9 < INT64_C(17592186044416) /* 1/65536 */;
    /* F60, |x| <= 1.53e-05 */
    const int64_t pitch_12 = clamp_64(pitch_9, INT64_C(0), INT64_C(17592186044416));
    const int64_t pitch_13 = pitch_12 * INT64_C(1);  /* F44, |x| <= 1 */
    const int64_t pitch_14 = pitch_13 * INT64_C(65536);  /* F60 */
    const int64_t pitch_15 = (pitch_11 != 0) ? pitch_14 : pitch_9;  /* F60, |x| <= 2.02 */
    const int32_t pitch_16 = pitch_10 * 1;  /* F39, |x| <= 0.00196 */
    const int32_t pitch_17 = round_short_8(pitch_16);  /* F31 */
    const int32_t pitch_18 = (pitch_11 != 0) ? pitch_17 : pitch_10;  /* F31, |x| <= 0.501 */
    const int32_t pitch_19 = pitch_15 < INT64_C(4503599627370496) /* 1/256 */;
    /* F60, |x| <= 0.00391 */
    const int64_t pitch_20 = clamp_64(pitch_15, INT64_C(0), INT64_C(4503599627370496));
    const int64_t pitch_21 = pitch_20 * INT64_C(1);  /* F52, |x| <= 1 */
    const int64_t pitch_22 = pitch_21 * INT64_C(256);  /* F60 */
    const int64_t pitch_23 = (pitch_19 != 0) ? pitch_22 : pitch_15;  /* F60, |x| <= 2.02 */
    const int32_t pitch_24 = pitch_18 * 1;  /* F35, |x| <= 0.0313 */
    const int32_t pitch_25 = round_short_4(pitch_24);  /* F31 */
    const int32_t pitch_26 = (pitch_19 != 0) ? pitch_25 : pitch_18;  /* F31, |x| <= 0.501 */
    const int32_t pitch_27 = pitch_23 < INT64_C(72057594037927936) /* 1/16 */;
    /* F60, |x| <= 0.0625 */
    const int64_t pitch_28 = clamp_64(pitch_23, INT64_C(0), INT64_C(72057594037927936));
    const int64_t pitch_29 = pitch_28 * INT64_C(1);  /* F56, |x| <= 1 */
    const int64_t pitch_30 = pitch_29 * INT64_C(16);  /* F60 */
    const int64_t pitch_31 = (pitch_27 != 0) ? pitch_30 : pitch_23;  /* F60, |x| <= 2.02 */
    const int32_t pitch_32 = pitch_26 * 1;  /* F33, |x| <= 0.126 */
    const int32_t pitch_33 = round_short_2(pitch_32);  /* F31 */
    const int32_t pitch_34 = (pitch_27 != 0) ? pitch_33 : pitch_26;  /* F31, |x| <= 0.501 */
    const int32_t pitch_35 = pitch_31 < INT64_C(288230376151711744) /* 1/4 */;
    /* F60, |x| <= 0.25 */
    const int64_t pitch_36 = clamp_64(pitch_31, INT64_C(0), INT64_C(288230376151711744));
    const int64_t pitch_37 = pitch_36 * INT64_C(1);  /* F58, |x| <= 1 */
    const int64_t pitch_38 = pitch_37 * INT64_C(4);  /* F60 */
    const int64_t pitch_39 = (pitch_35 != 0) ? pitch_38 : pitch_31;  /* F60, |x| <= 2.02 */
    const int32_t pitch_40 = pitch_34 * 1;  /* F32, |x| <= 0.251 */
    const int32_t pitch_41 = round_short_1(pitch_40);  /* F31 */
    const int32_t pitch_42 = (pitch_35 != 0) ? pitch_41 : pitch_34;  /* F31, |x| <= 0.501 */
    const int32_t pitch_43 = round_31(pitch_39);  /* F27, |x| <= 8.07 */
    const int32_t pitch_44 = clamp_32(pitch_43, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_45 = clamp_32(pitch_44, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_46 = -pitch_45;  /* F27 */
    const int64_t pitch_47 = (int64_t)747135655 /* 47816681919/17592186044416 */ * pitch_46;  /* F65 */
    /* F65 */
    const int64_t pitch_48 = INT64_C(1527667556037427200) /* 182112164025/4398046511104 */ + pitch_47;
    const int32_t pitch_49 = round_30(pitch_48);  /* F35, |x| <= 0.0387 */
    const int64_t pitch_50 = (int64_t)pitch_45 * pitch_49;  /* F62 */
    /* F62 */
    const int64_t pitch_51 = pitch_50 - INT64_C(1179613329067868160) /* 2249933870445/8796093022208 */;
    const int32_t pitch_52 = round_29(pitch_51);  /* F33, |x| <= 0.226 */
    const int64_t pitch_53 = (int64_t)pitch_45 * pitch_52;  /* F60 */
    /* F60 */
    const int64_t pitch_54 = INT64_C(951679935904743424) /* 1815185424623/2199023255552 */ + pitch_53;
    const int32_t pitch_55 = round_29(pitch_54);  /* F31, |x| <= 0.725 */
    const int64_t pitch_56 = (int64_t)pitch_45 * pitch_55;  /* F58 */
    /* F58 */
    const int64_t pitch_57 = pitch_56 - INT64_C(436656008213790720) /* 13325683844415/8796093022208 */;
    const int32_t pitch_58 = round_28(pitch_57);  /* F30, |x| <= 1.82 */
    const int64_t pitch_59 = (int64_t)pitch_45 * pitch_58;  /* F57 */
    /* F57 */
    const int64_t pitch_60 = INT64_C(274651154808430592) /* 33526752295951/17592186044416 */ + pitch_59;
    const int32_t pitch_61 = round_29(pitch_60);  /* F28, |x| <= 7.44 */
    const int32_t pitch_62 = clamp_32(pitch_61, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t pitch_63 = (int64_t)pitch_62 * pitch_62;  /* F56 */
    const int32_t pitch_64 = round_26(pitch_63);  /* F30, |x| <= 1.57 */
    const int64_t pitch_65 = (int64_t)pitch_46 * pitch_64;  /* F57 */
    const int64_t pitch_66 = INT64_C(144115188075855872) /* 1 */ + pitch_65;  /* F57 */
    const int32_t pitch_67 = round_29(pitch_66);  /* F28, |x| <= 5.26 */
    const int64_t pitch_68 = pitch_62 * INT64_C(536870912);  /* F57 */
    const int64_t pitch_69 = (int64_t)pitch_62 * pitch_67;  /* F56 */
    const int64_t pitch_70 = pitch_68 + pitch_69;  /* F57 */
    const int32_t pitch_71 = round_28(pitch_70);  /* F29, |x| <= 3.04 */
    const int32_t pitch_72 = clamp_32(pitch_71, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_73 = (int64_t)pitch_72 * pitch_72;  /* F58 */
    const int32_t pitch_74 = round_28(pitch_73);  /* F30, |x| <= 1.57 */
    const int64_t pitch_75 = (int64_t)pitch_46 * pitch_74;  /* F57 */
    const int64_t pitch_76 = INT64_C(144115188075855872) /* 1 */ + pitch_75;  /* F57 */
    const int32_t pitch_77 = round_29(pitch_76);  /* F28, |x| <= 5.26 */
    const int64_t pitch_78 = pitch_72 * INT64_C(536870912);  /* F58 */
    const int64_t pitch_79 = (int64_t)pitch_72 * pitch_77;  /* F57 */
    const int64_t pitch_80 = pitch_78 + pitch_79;  /* F58 */
    const int32_t pitch_81 = round_29(pitch_80);  /* F29, |x| <= 3.04 */
    const int32_t pitch_82 = clamp_32(pitch_81, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_83 = (int64_t)pitch_44 * pitch_82;  /* F56 */
    const int32_t pitch_84 = round_28(pitch_83);  /* F28, |x| <= 5.01 */
    const int64_t pitch_85 = (int64_t)pitch_84 * pitch_42;  /* F59 */
    const int32_t pitch_86 = round_30(pitch_85);  /* F29, |x| <= 2.51 */
    const int64_t pitch_87 = (int64_t)half_difference_4 * half_difference_4;  /* F58 */
    const int64_t pitch_88 = (int64_t)half_difference_2 * half_difference_2;  /* F58 */
    const int64_t pitch_89 = pitch_87 + pitch_88;  /* F60, |x| <= 2.02 */
    const int32_t pitch_90 = pitch_89 < INT64_C(268435456) /* 1/4294967296 */;
    /* F60, |x| <= 2.33e-10 */
    const int32_t pitch_91 = clamp_64_to_32(pitch_89, INT64_C(0), INT64_C(268435456));
    const int64_t pitch_92 = pitch_91 * INT64_C(1);  /* F28, |x| <= 1 */
    const int64_t pitch_93 = pitch_92 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_94 = (pitch_90 != 0) ? pitch_93 : pitch_89;  /* F60, |x| <= 2.02 */
    /* F31, |x| <= 0.501 */
    const int32_t pitch_95 = (pitch_90 != 0) ? 16384 /* 1/131072 */ : 1073741824 /* 1/2 */;
    const int32_t pitch_96 = pitch_94 < INT64_C(17592186044416) /* 1/65536 */;
    /* F60, |x| <= 1.53e-05 */
    const int64_t pitch_97 = clamp_64(pitch_94, INT64_C(0), INT64_C(17592186044416));
    const int64_t pitch_98 = pitch_97 * INT64_C(1);  /* F44, |x| <= 1 */
    const int64_t pitch_99 = pitch_98 * INT64_C(65536);  /* F60 */
    const int64_t pitch_100 = (pitch_96 != 0) ? pitch_99 : pitch_94;  /* F60, |x| <= 2.02 */
    const int32_t pitch_101 = pitch_95 * 1;  /* F39, |x| <= 0.00196 */
    const int32_t pitch_102 = round_short_8(pitch_101);  /* F31 */
    const int32_t pitch_103 = (pitch_96 != 0) ? pitch_102 : pitch_95;  /* F31, |x| <= 0.501 */
    const int32_t pitch_104 = pitch_100 < INT64_C(4503599627370496) /* 1/256 */;
    /* F60, |x| <= 0.00391 */
    const int64_t pitch_105 = clamp_64(pitch_100, INT64_C(0), INT64_C(4503599627370496));
    const int64_t pitch_106 = pitch_105 * INT64_C(1);  /* F52, |x| <= 1 */
    const int64_t pitch_107 = pitch_106 * INT64_C(256);  /* F60 */
    const int64_t pitch_108 = (pitch_104 != 0) ? pitch_107 : pitch_100;  /* F60, |x| <= 2.02 */
    const int32_t pitch_109 = pitch_103 * 1;  /* F35, |x| <= 0.0313 */
    const int32_t pitch_110 = round_short_4(pitch_109);  /* F31 */
    const int32_t pitch_111 = (pitch_104 != 0) ? pitch_110 : pitch_103;  /* F31, |x| <= 0.501 */
    const int32_t pitch_112 = pitch_108 < INT64_C(72057594037927936) /* 1/16 */;
    /* F60, |x| <= 0.0625 */
    const int64_t pitch_113 = clamp_64(pitch_108, INT64_C(0), INT64_C(72057594037927936));
    const int64_t pitch_114 = pitch_113 * INT64_C(1);  /* F56, |x| <= 1 */
    const int64_t pitch_115 = pitch_114 * INT64_C(16);  /* F60 */
    const int64_t pitch_116 = (pitch_112 != 0) ? pitch_115 : pitch_108;  /* F60, |x| <= 2.02 */
    const int32_t pitch_117 = pitch_111 * 1;  /* F33, |x| <= 0.126 */
    const int32_t pitch_118 = round_short_2(pitch_117);  /* F31 */
    const int32_t pitch_119 = (pitch_112 != 0) ? pitch_118 : pitch_111;  /* F31, |x| <= 0.501 */
    const int32_t pitch_120 = pitch_116 < INT64_C(288230376151711744) /* 1/4 */;
    /* F60, |x| <= 0.25 */
    const int64_t pitch_121 = clamp_64(pitch_116, INT64_C(0), INT64_C(288230376151711744));
    const int64_t pitch_122 = pitch_121 * INT64_C(1);  /* F58, |x| <= 1 */
    const int64_t pitch_123 = pitch_122 * INT64_C(4);  /* F60 */
    const int64_t pitch_124 = (pitch_120 != 0) ? pitch_123 : pitch_116;  /* F60, |x| <= 2.02 */
    const int32_t pitch_125 = pitch_119 * 1;  /* F32, |x| <= 0.251 */
    const int32_t pitch_126 = round_short_1(pitch_125);  /* F31 */
    const int32_t pitch_127 = (pitch_120 != 0) ? pitch_126 : pitch_119;  /* F31, |x| <= 0.501 */
    const int32_t pitch_128 = round_31(pitch_124);  /* F27, |x| <= 8.07 */
    const int32_t pitch_129 = clamp_32(pitch_128, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_130 = clamp_32(pitch_129, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_131 = -pitch_130;  /* F27 */
    const int64_t pitch_132 = (int64_t)747135655 /* 47816681919/17592186044416 */ * pitch_131;  /* F65 */
    /* F65 */
    const int64_t pitch_133 = INT64_C(1527667556037427200) /* 182112164025/4398046511104 */ + pitch_132;
    const int32_t pitch_134 = round_30(pitch_133);  /* F35, |x| <= 0.0387 */
    const int64_t pitch_135 = (int64_t)pitch_130 * pitch_134;  /* F62 */
    /* F62 */
    const int64_t pitch_136 = pitch_135 - INT64_C(1179613329067868160) /* 2249933870445/8796093022208 */;
    const int32_t pitch_137 = round_29(pitch_136);  /* F33, |x| <= 0.226 */
    const int64_t pitch_138 = (int64_t)pitch_130 * pitch_137;  /* F60 */
    /* F60 */
    const int64_t pitch_139 = INT64_C(951679935904743424) /* 1815185424623/2199023255552 */ + pitch_138;
    const int32_t pitch_140 = round_29(pitch_139);  /* F31, |x| <= 0.725 */
    const int64_t pitch_141 = (int64_t)pitch_130 * pitch_140;  /* F58 */
    /* F58 */
    const int64_t pitch_142 = pitch_141 - INT64_C(436656008213790720) /* 13325683844415/8796093022208 */;
    const int32_t pitch_143 = round_28(pitch_142);  /* F30, |x| <= 1.82 */
    const int64_t pitch_144 = (int64_t)pitch_130 * pitch_143;  /* F57 */
    /* F57 */
    const int64_t pitch_145 = INT64_C(274651154808430592) /* 33526752295951/17592186044416 */ + pitch_144;
    const int32_t pitch_146 = round_29(pitch_145);  /* F28, |x| <= 7.44 */
    const int32_t pitch_147 = clamp_32(pitch_146, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t pitch_148 = (int64_t)pitch_147 * pitch_147;  /* F56 */
    const int32_t pitch_149 = round_26(pitch_148);  /* F30, |x| <= 1.57 */
    const int64_t pitch_150 = (int64_t)pitch_131 * pitch_149;  /* F57 */
    const int64_t pitch_151 = INT64_C(144115188075855872) /* 1 */ + pitch_150;  /* F57 */
    const int32_t pitch_152 = round_29(pitch_151);  /* F28, |x| <= 5.26 */
    const int64_t pitch_153 = pitch_147 * INT64_C(536870912);  /* F57 */
    const int64_t pitch_154 = (int64_t)pitch_147 * pitch_152;  /* F56 */
    const int64_t pitch_155 = pitch_153 + pitch_154;  /* F57 */
    const int32_t pitch_156 = round_28(pitch_155);  /* F29, |x| <= 3.04 */
    const int32_t pitch_157 = clamp_32(pitch_156, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_158 = (int64_t)pitch_157 * pitch_157;  /* F58 */
    const int32_t pitch_159 = round_28(pitch_158);  /* F30, |x| <= 1.57 */
    const int64_t pitch_160 = (int64_t)pitch_131 * pitch_159;  /* F57 */
    const int64_t pitch_161 = INT64_C(144115188075855872) /* 1 */ + pitch_160;  /* F57 */
    const int32_t pitch_162 = round_29(pitch_161);  /* F28, |x| <= 5.26 */
    const int64_t pitch_163 = pitch_157 * INT64_C(536870912);  /* F58 */
    const int64_t pitch_164 = (int64_t)pitch_157 * pitch_162;  /* F57 */
    const int64_t pitch_165 = pitch_163 + pitch_164;  /* F58 */
    const int32_t pitch_166 = round_29(pitch_165);  /* F29, |x| <= 3.04 */
    const int32_t pitch_167 = clamp_32(pitch_166, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_168 = (int64_t)pitch_129 * pitch_167;  /* F56 */
    const int32_t pitch_169 = round_28(pitch_168);  /* F28, |x| <= 5.01 */
    const int64_t pitch_170 = (int64_t)pitch_169 * pitch_127;  /* F59 */
    const int32_t pitch_171 = round_30(pitch_170);  /* F29, |x| <= 2.51 */
    const int32_t pitch_172 = pitch_86 < 0;
    const int32_t pitch_173 = -pitch_86;  /* F29, |x| <= 2.51 */
    const int32_t pitch_174 = (pitch_172 != 0) ? pitch_173 : pitch_86;  /* F29, |x| <= 2.51 */
    const int32_t pitch_175 = pitch_171 < 0;
    const int32_t pitch_176 = -pitch_171;  /* F29, |x| <= 2.51 */
    const int32_t pitch_177 = (pitch_175 != 0) ? pitch_176 : pitch_171;  /* F29, |x| <= 2.51 */
    const int32_t pitch_178 = pitch_177 < pitch_174;
    const int32_t pitch_179 = (pitch_178 != 0) ? pitch_177 : pitch_174;  /* F29, |x| <= 2.51 */
    const int32_t pitch_180 = (pitch_178 != 0) ? pitch_174 : pitch_177;  /* F29, |x| <= 2.51 */
    const int64_t pitch_181 = (int64_t)889516847 /* 10355339/25000000 */ * pitch_180;  /* F60 */
    const int32_t pitch_182 = round_30(pitch_181);  /* F30, |x| <= 1.04 */
    const int64_t pitch_183 = pitch_182 * INT64_C(1);  /* F30 */
    const int64_t pitch_184 = pitch_179 * INT64_C(2);  /* F30 */
    const int32_t pitch_185 = pitch_183 < pitch_184;
    const int64_t pitch_186 = (int64_t)pitch_179 - pitch_180;  /* F29 */
    const int32_t pitch_187 = round_1(pitch_186);  /* F28, |x| <= 5.01 */
    const int32_t pitch_188 = round_short_1(pitch_179);  /* F28 */
    const int32_t pitch_189 = (pitch_185 != 0) ? pitch_187 : pitch_188;  /* F28, |x| <= 5.01 */
    const int64_t pitch_190 = (int64_t)pitch_179 + pitch_180;  /* F29 */
    const int32_t pitch_191 = round_1(pitch_190);  /* F28, |x| <= 5.01 */
    const int32_t pitch_192 = round_short_1(pitch_180);  /* F28 */
    const int32_t pitch_193 = (pitch_185 != 0) ? pitch_191 : pitch_192;  /* F28, |x| <= 5.01 */
    const int32_t pitch_194 = clamp_32(pitch_193, 2, 2147483647);  /* F28, |x| <= 5.01 */
    const int64_t pitch_195 = pitch_189 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_196 = pitch_195 / pitch_194;  /* F32, |x| <= 6.72e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t pitch_197 = clamp_64_to_32(pitch_196, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t pitch_198 = (int64_t)pitch_197 * pitch_197;  /* F64 */
    const int32_t pitch_199 = round_31(pitch_198);  /* F33, |x| <= 0.172 */
    const int64_t pitch_200 = (int64_t)510875761 /* 382/6423 */ * pitch_199;  /* F66 */
    const int64_t pitch_201 = INT64_C(7773993415904670242) /* 1650/15661 */ - pitch_200;  /* F66 */
    const int32_t pitch_202 = round_34(pitch_201);  /* F32, |x| <= 0.106 */
    const int64_t pitch_203 = (int64_t)pitch_199 * pitch_202;  /* F65 */
    const int64_t pitch_204 = pitch_203 - INT64_C(5251586747234353517) /* 7339/51558 */;  /* F65 */
    const int32_t pitch_205 = round_33(pitch_204);  /* F32, |x| <= 0.143 */
    const int64_t pitch_206 = (int64_t)pitch_199 * pitch_205;  /* F65 */
    const int64_t pitch_207 = INT64_C(7377920055805538292) /* 58828/294171 */ + pitch_206;  /* F65 */
    const int32_t pitch_208 = round_34(pitch_207);  /* F31, |x| <= 0.2 */
    const int64_t pitch_209 = (int64_t)pitch_199 * pitch_208;  /* F64 */
    const int64_t pitch_210 = pitch_209 - INT64_C(6148909082171862706) /* 365415/1096246 */;  /* F64 */
    const int32_t pitch_211 = round_32(pitch_210);  /* F32, |x| <= 0.334 */
    const int64_t pitch_212 = (int64_t)pitch_199 * pitch_211;  /* F65 */
    const int32_t pitch_213 = round_30(pitch_212);  /* F35, |x| <= 0.0573 */
    const int64_t pitch_214 = (int64_t)pitch_197 * pitch_213;  /* F67 */
    const int32_t pitch_215 = round_35(pitch_214);  /* F32, |x| <= 0.0238 */
    const int32_t pitch_216 = pitch_197 + pitch_215;  /* F32, |x| <= 0.439 */
    const int64_t pitch_217 = INT64_C(3373259426) + pitch_216;  /* F32 */
    const int32_t pitch_218 = round_2(pitch_217);  /* F30, |x| <= 1.23 */
    const int32_t pitch_219 = round_short_2(pitch_216);  /* F30 */
    const int32_t pitch_220 = (pitch_185 != 0) ? pitch_218 : pitch_219;  /* F30, |x| <= 1.23 */
    const int64_t pitch_221 = INT64_C(1686629713) - pitch_220;  /* F30 */
    const int32_t pitch_222 = round_1(pitch_221);  /* F29, |x| <= 2.01 */
    const int32_t pitch_223 = round_short_1(pitch_220);  /* F29 */
    const int32_t pitch_224 = (pitch_178 != 0) ? pitch_222 : pitch_223;  /* F29, |x| <= 2.01 */
    const int64_t pitch_225 = INT64_C(1686629713) - pitch_224;  /* F29 */
    const int32_t pitch_226 = (int32_t)pitch_225;  /* F29, |x| <= 3.58 */
    const int32_t pitch_227 = (pitch_175 != 0) ? pitch_226 : pitch_224;  /* F29, |x| <= 3.58 */
    const int32_t pitch_228 = -pitch_227;  /* F29, |x| <= 3.58 */
    const int32_t pitch_229 = (pitch_172 != 0) ? pitch_228 : pitch_227;  /* F29, |x| <= 3.58 */
    const int64_t pitch_230 = pitch_229 - INT64_C(421657428);  /* F28 */
    const int32_t pitch_231 = round_1(pitch_230);  /* F27, |x| <= 8.73 */
    const int32_t pitch = clamp_32(pitch_231, -210829207, 210829207);  /* F27, |x| <= 1.58 */

    /* roll = half_sum - half_difference, in [-pi, pi] */
    const int64_t roll_1 = (int64_t)half_sum - half_difference;  /* F29 */
    const int32_t roll_3 = round_1(roll_1);  /* F28, |x| <= 7.16 */
    const int32_t roll_4 = 843314857 < roll_3;
    const int64_t roll_5 = roll_3 - INT64_C(1686629713);  /* F28 */
    const int32_t roll_6 = round_1(roll_5);  /* F27, |x| <= 13.5 */
    const int32_t roll_7 = round_short_1(roll_3);  /* F27 */
    const int32_t roll_8 = (roll_4 != 0) ? roll_6 : roll_7;  /* F27, |x| <= 13.5 */
    const int32_t roll_9 = clamp_32(roll_8, -843316828, 421658414);  /* F27, |x| <= 6.29 */
    const int32_t roll_10 = roll_9 < -421657428;
    const int32_t roll_11 = roll_9 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t roll_12 = (roll_10 != 0) ? roll_11 : roll_9;  /* F27, |x| <= 9.43 */
    const int32_t roll = clamp_32(roll_12, -421658414, 421658414);  /* F27, |x| <= 3.15 */

    /* yaw = half_sum + half_difference, in [-pi, pi] */
    const int64_t yaw_1 = (int64_t)half_sum + half_difference;  /* F29 */
    const int32_t yaw_3 = round_1(yaw_1);  /* F28, |x| <= 7.16 */
    const int32_t yaw_4 = 843314857 < yaw_3;
    const int64_t yaw_5 = yaw_3 - INT64_C(1686629713);  /* F28 */
    const int32_t yaw_6 = round_1(yaw_5);  /* F27, |x| <= 13.5 */
    const int32_t yaw_7 = round_short_1(yaw_3);  /* F27 */
    const int32_t yaw_8 = (yaw_4 != 0) ? yaw_6 : yaw_7;  /* F27, |x| <= 13.5 */
    const int32_t yaw_9 = clamp_32(yaw_8, -843316828, 421658414);  /* F27, |x| <= 6.29 */
    const int32_t yaw_10 = yaw_9 < -421657428;
    const int32_t yaw_11 = yaw_9 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t yaw_12 = (yaw_10 != 0) ? yaw_11 : yaw_9;  /* F27, |x| <= 9.43 */
    const int32_t yaw = clamp_32(yaw_12, -421658414, 421658414);  /* F27, |x| <= 3.15 */

    const int32_t roll_2 = roll * 4;  /* F29, |x| <= 3.15 */
    rpy[0] = roll_2;
    const int32_t pitch_2 = pitch * 4;  /* F29, |x| <= 1.58 */
    rpy[1] = pitch_2;
    const int32_t yaw_2 = yaw * 4;  /* F29, |x| <= 3.15 */
    rpy[2] = yaw_2;
}

void rotation_vector_3_coning_rins_fixed32_compensated_set_correction(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t azimuth[3],
    const int32_t tilt_x[3], const int32_t tilt_y[3])
{
    /* A, B, C of the encoder error A sin al + B cos al + C, rad */
    const int32_t azimuth_sine = azimuth[0];  /* F39, |x| <= 0.00291 */
    const int32_t azimuth_cosine = azimuth[1];  /* F39, |x| <= 0.00291 */
    const int32_t azimuth_offset = azimuth[2];  /* F39, |x| <= 0.00291 */

    /* A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad */
    const int32_t tilt_x_sine = tilt_x[0];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_x_cosine = tilt_x[1];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_x_offset = tilt_x[2];  /* F39, |x| <= 0.00291 */

    /* A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad */
    const int32_t tilt_y_sine = tilt_y[0];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_y_cosine = tilt_y[1];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_y_offset = tilt_y[2];  /* F39, |x| <= 0.00291 */

    /* A, B, C of the encoder error A sin al + B cos al + C, rad */
    state->azimuth_harmonic[0] = azimuth_sine;
    state->azimuth_harmonic[1] = azimuth_cosine;
    state->azimuth_harmonic[2] = azimuth_offset;

    /* A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad */
    state->tilt_x_harmonic[0] = tilt_x_sine;
    state->tilt_x_harmonic[1] = tilt_x_cosine;
    state->tilt_x_harmonic[2] = tilt_x_offset;

    /* A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad */
    state->tilt_y_harmonic[0] = tilt_y_sine;
    state->tilt_y_harmonic[1] = tilt_y_cosine;
    state->tilt_y_harmonic[2] = tilt_y_offset;
}

void rotation_vector_3_coning_rins_fixed32_compensated_correct(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t encoder[1],
    int32_t angle[1], int32_t tilt[2])
{
    /* the encoder's angle and the harmonics, read once */
    const int32_t al = encoder[0];  /* F27, |x| <= 9.44 */

    /* cos_al = cos al, with sin_al = sin al: al folded to [0, pi/4], polynomials */
    const int32_t sin_al_1 = 421657428 < al;
    const int32_t sin_al_2 = al - INT64_C(843314857);  /* F27, |x| <= 15.8 */
    const int32_t sin_al_3 = (sin_al_1 != 0) ? sin_al_2 : al;  /* F27, |x| <= 15.8 */
    const int32_t sin_al_4 = clamp_32(sin_al_3, -1264975242, 421658414);  /* F27, |x| <= 9.43 */
    const int32_t sin_al_5 = sin_al_4 < -421657428;
    const int32_t sin_al_6 = sin_al_4 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t sin_al_7 = (sin_al_5 != 0) ? sin_al_6 : sin_al_4;  /* F27, |x| <= 9.43 */
    const int32_t sin_al_8 = clamp_32(sin_al_7, -421658414, 421658414);  /* F27, |x| <= 3.15 */
    const int32_t sin_al_9 = sin_al_8 < 0;
    const int32_t sin_al_10 = -sin_al_8;  /* F27, |x| <= 3.15 */
    const int32_t sin_al_11 = (sin_al_9 != 0) ? sin_al_10 : sin_al_8;  /* F27, |x| <= 3.15 */
    const int32_t sin_al_12 = clamp_32(sin_al_11, 0, 421658414);  /* F27, |x| <= 3.15 */
    const int32_t sin_al_13 = 210828714 < sin_al_12;
    const int32_t sin_al_14 = INT64_C(421657428) - sin_al_12;  /* F27, |x| <= 3.15 */
    const int32_t sin_al_15 = (sin_al_13 != 0) ? sin_al_14 : sin_al_12;  /* F27, |x| <= 3.15 */
    const int32_t sin_al_16 = clamp_32(sin_al_15, 0, 210829207);  /* F27, |x| <= 1.58 */
    const int32_t sin_al_17 = 105414357 < sin_al_16;
    const int32_t sin_al_18 = INT64_C(210828714) - sin_al_16;  /* F27, |x| <= 1.58 */
    const int32_t sin_al_19 = (sin_al_17 != 0) ? sin_al_18 : sin_al_16;  /* F27, |x| <= 1.58 */
    const int32_t sin_al_20 = clamp_32(sin_al_19, 0, 105414603);  /* F27, |x| <= 0.786 */
    const int64_t sin_al_21 = (int64_t)sin_al_20 * sin_al_20;  /* F54 */
    const int32_t sin_al_22 = round_23(sin_al_21);  /* F31, |x| <= 0.617 */
    const int64_t sin_al_23 = (int64_t)47780703 /* 1/368186 */ * sin_al_22;  /* F75 */
    const int64_t sin_al_24 = sin_al_23 - INT64_C(7494978749913852577) /* 122/614949 */;  /* F75 */
    const int32_t sin_al_25 = round_37(sin_al_24);  /* F38, |x| <= 0.000199 */
    const int64_t sin_al_26 = (int64_t)sin_al_22 * sin_al_25;  /* F69 */
    const int64_t sin_al_27 = INT64_C(4919128744126946120) /* 13624/1634881 */ + sin_al_26;  /* F69 */
    const int32_t sin_al_28 = round_35(sin_al_27);  /* F34, |x| <= 0.00834 */
    const int64_t sin_al_29 = (int64_t)sin_al_22 * sin_al_28;  /* F65 */
    const int64_t sin_al_30 = sin_al_29 - INT64_C(6148914676902249652) /* 71494348/428966089 */;  /* F65 */
    const int32_t sin_al_31 = round_32(sin_al_30);  /* F33, |x| <= 0.167 */
    const int64_t sin_al_32 = (int64_t)sin_al_22 * sin_al_31;  /* F64 */
    const int32_t sin_al_33 = round_30(sin_al_32);  /* F34, |x| <= 0.103 */
    const int64_t sin_al_34 = sin_al_20 * INT64_C(17179869184);  /* F61 */
    const int64_t sin_al_35 = (int64_t)sin_al_20 * sin_al_33;  /* F61 */
    const int64_t sin_al_36 = sin_al_34 + sin_al_35;  /* F61 */
    const int32_t sin_al_37 = round_30(sin_al_36);  /* F31, |x| <= 0.786 */
    const int64_t sin_al_38 = (int64_t)53635181 /* 14/573995 */ * sin_al_22;  /* F72 */
    const int64_t sin_al_39 = sin_al_38 - INT64_C(6557838793880402655) /* 717/516319 */;  /* F72 */
    const int32_t sin_al_40 = round_36(sin_al_39);  /* F36, |x| <= 0.00139 */
    const int64_t sin_al_41 = (int64_t)sin_al_22 * sin_al_40;  /* F67 */
    const int64_t sin_al_42 = INT64_C(6148908294918647070) /* 40055/961321 */ + sin_al_41;  /* F67 */
    const int32_t sin_al_43 = round_35(sin_al_42);  /* F32, |x| <= 0.0417 */
    const int64_t sin_al_44 = (int64_t)sin_al_22 * sin_al_43;  /* F63 */
    const int64_t sin_al_45 = sin_al_44 - INT64_C(4611685993060359195) /* 90899215/181798431 */;  /* F63 */
    const int32_t sin_al_46 = round_32(sin_al_45);  /* F31, |x| <= 0.5 */
    const int64_t sin_al_47 = (int64_t)sin_al_22 * sin_al_46;  /* F62 */
    const int64_t sin_al_48 = INT64_C(4611686018427387904) /* 1 */ + sin_al_47;  /* F62 */
    const int32_t sin_al_49 = round_32(sin_al_48);  /* F30, |x| <= 1.01 */
    const int32_t sin_al_50 = round_short_1(sin_al_37);  /* F30 */
    const int32_t sin_al_51 = (sin_al_17 != 0) ? sin_al_49 : sin_al_50;  /* F30, |x| <= 1.01 */
    const int32_t cos_al_1 = round_short_1(sin_al_37);  /* F30 */
    const int32_t cos_al_2 = (sin_al_17 != 0) ? cos_al_1 : sin_al_49;  /* F30, |x| <= 1.01 */
    const int32_t sin_al_52 = -sin_al_51;  /* F30, |x| <= 1.01 */
    const int32_t sin_al = (sin_al_9 != 0) ? sin_al_52 : sin_al_51;  /* F30, |x| <= 1.01 */
    const int32_t cos_al_3 = -cos_al_2;  /* F30, |x| <= 1.01 */
    const int32_t cos_al = (sin_al_13 != 0) ? cos_al_3 : cos_al_2;  /* F30, |x| <= 1.01 */

    /* the encoder's angle and the harmonics, read once */
    const int32_t azimuth_sine = state->azimuth_harmonic[0];  /* F39, |x| <= 0.00291 */
    const int32_t azimuth_cosine = state->azimuth_harmonic[1];  /* F39, |x| <= 0.00291 */
    const int32_t azimuth_offset = state->azimuth_harmonic[2];  /* F39, |x| <= 0.00291 */

    /* error = A sin al + B cos al + C   [rins (13)] */
    const int64_t error_1 = (int64_t)azimuth_sine * sin_al;  /* F69 */
    const int64_t error_2 = (int64_t)azimuth_cosine * cos_al;  /* F69 */
    const int64_t error_3 = error_1 + error_2;  /* F69 */
    const int64_t error_4 = azimuth_offset * INT64_C(1073741824);  /* F69 */
    const int64_t error_5 = error_3 + error_4;  /* F69 */
    const int32_t error = round_32(error_5);  /* F37, |x| <= 0.00873 */

    /* al_corr = al - error   [rins (15)] */
    const int32_t al_corr_fine_1 = -error;  /* F37 */
    const int32_t al_corr_fine = round_short_10(al_corr_fine_1);  /* F27 */
    const int32_t al_corr = al_corr_fine + al;  /* F27, |x| <= 9.45 */

    /* cos_error = cos(error), with sin_error: as far as so small an angle needs */
    const int64_t sin_error_part_1 = (int64_t)error * error;  /* F74 */
    const int32_t sin_error_part_2 = round_30(sin_error_part_1);  /* F44, |x| <= 7.62e-05 */
    const int64_t sin_error_part_3 = (int64_t)1431655765 /* 1/6 */ * sin_error_part_2;  /* F77 */
    const int64_t sin_error_part_4 = -sin_error_part_3;  /* F77 */
    const int32_t sin_error_part_5 = round_30(sin_error_part_4);  /* F47, |x| <= 1.27e-05 */
    const int64_t sin_error_part_6 = (int64_t)error * sin_error_part_5;  /* F84 */
    const int32_t sin_error_part = round_30(sin_error_part_6);  /* F54, |x| <= 1.11e-07 */
    const int64_t sin_error_1 = error * INT64_C(131072);  /* F54 */
    const int64_t sin_error_2 = sin_error_1 + sin_error_part;  /* F54 */
    const int32_t sin_error = round_22(sin_error_2);  /* F32, |x| <= 0.00873 */
    const int64_t cos_error_1 = INT64_C(35184372088832) /* 1 */ - sin_error_part_2;  /* F45 */
    const int32_t cos_error = round_15(cos_error_1);  /* F30, |x| <= 1.01 */

    /* cos_corr = cos(al - error), with sin_corr */
    const int64_t sin_corr_1 = (int64_t)sin_al * cos_error;  /* F60 */
    const int64_t sin_corr_2 = sin_corr_1 * INT64_C(4);  /* F62 */
    const int64_t sin_corr_3 = (int64_t)cos_al * sin_error;  /* F62 */
    const int64_t sin_corr_4 = sin_corr_2 - sin_corr_3;  /* F62 */
    const int32_t sin_corr = round_32(sin_corr_4);  /* F30, |x| <= 1.01 */
    const int64_t cos_corr_1 = (int64_t)cos_al * cos_error;  /* F60 */
    const int64_t cos_corr_2 = cos_corr_1 * INT64_C(4);  /* F62 */
    const int64_t cos_corr_3 = (int64_t)sin_al * sin_error;  /* F62 */
    const int64_t cos_corr_4 = cos_corr_2 + cos_corr_3;  /* F62 */
    const int32_t cos_corr = round_32(cos_corr_4);  /* F30, |x| <= 1.01 */

    /* cos_2al = cos 2al_corr, with sin_2al */
    const int64_t sin_2al_1 = (int64_t)sin_corr * cos_corr;  /* F60 */
    const int32_t sin_2al = round_30(sin_2al_1);  /* F29, |x| <= 2.04 */
    const int64_t cos_2al_1 = (int64_t)sin_corr * sin_corr;  /* F60 */
    const int64_t cos_2al_2 = INT64_C(576460752303423488) /* 1 */ - cos_2al_1;  /* F59 */
    const int32_t cos_2al = round_29(cos_2al_2);  /* F30, |x| <= 1.04 */

    /* the encoder's angle and the harmonics, read once */
    const int32_t tilt_x_sine = state->tilt_x_harmonic[0];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_x_cosine = state->tilt_x_harmonic[1];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_x_offset = state->tilt_x_harmonic[2];  /* F39, |x| <= 0.00291 */

    /* delta_x = A2 sin 2al + B2 cos 2al + C2   [rins (16)] */
    const int64_t delta_x_1 = (int64_t)tilt_x_sine * sin_2al;  /* F68 */
    const int64_t delta_x_2 = delta_x_1 * INT64_C(2);  /* F69 */
    const int64_t delta_x_3 = (int64_t)tilt_x_cosine * cos_2al;  /* F69 */
    const int64_t delta_x_4 = delta_x_2 + delta_x_3;  /* F69 */
    const int64_t delta_x_5 = tilt_x_offset * INT64_C(1073741824);  /* F69 */
    const int64_t delta_x_6 = delta_x_4 + delta_x_5;  /* F69 */
    const int32_t delta_x = round_33(delta_x_6);  /* F36, |x| <= 0.0119 */

    /* the encoder's angle and the harmonics, read once */
    const int32_t tilt_y_sine = state->tilt_y_harmonic[0];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_y_cosine = state->tilt_y_harmonic[1];  /* F39, |x| <= 0.00291 */
    const int32_t tilt_y_offset = state->tilt_y_harmonic[2];  /* F39, |x| <= 0.00291 */

    /* delta_y = A2 sin 2al + B2 cos 2al + C2   [rins (16)] */
    const int64_t delta_y_1 = (int64_t)tilt_y_sine * sin_2al;  /* F68 */
    const int64_t delta_y_2 = delta_y_1 * INT64_C(2);  /* F69 */
    const int64_t delta_y_3 = (int64_t)tilt_y_cosine * cos_2al;  /* F69 */
    const int64_t delta_y_4 = delta_y_2 + delta_y_3;  /* F69 */
    const int64_t delta_y_5 = tilt_y_offset * INT64_C(1073741824);  /* F69 */
    const int64_t delta_y_6 = delta_y_4 + delta_y_5;  /* F69 */
    const int32_t delta_y = round_33(delta_y_6);  /* F36, |x| <= 0.0119 */

    angle[0] = al_corr;
    tilt[0] = delta_x;
    tilt[1] = delta_y;
}

void rotation_vector_3_coning_rins_fixed32_compensated_body_quaternion(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t angle[1],
    const int32_t tilt[2], int32_t q_nb[4])
{
    /* corrected angle and tilts */
    const int32_t al = angle[0];  /* F27, |x| <= 9.44 */
    const int32_t delta_x = tilt[0];  /* F36, |x| <= 0.0175 */
    const int32_t delta_y = tilt[1];  /* F36, |x| <= 0.0175 */

    /* cos_x = cos(delta_x/2), with sin_x */
    const int64_t sin_x_part_1 = (int64_t)delta_x * delta_x;  /* F72 */
    const int32_t sin_x_part_2 = round_30(sin_x_part_1);  /* F44, |x| <= 7.62e-05 */
    const int64_t sin_x_part_3 = (int64_t)1431655765 /* 1/6 */ * sin_x_part_2;  /* F77 */
    const int64_t sin_x_part_4 = -sin_x_part_3;  /* F77 */
    const int32_t sin_x_part_5 = round_30(sin_x_part_4);  /* F47, |x| <= 1.27e-05 */
    const int64_t sin_x_part_6 = (int64_t)delta_x * sin_x_part_5;  /* F83 */
    const int32_t sin_x_part = round_30(sin_x_part_6);  /* F54, |x| <= 1.11e-07 */
    const int32_t sin_x_fine = round_short_17(sin_x_part);  /* F37 */
    const int32_t sin_x = sin_x_fine + delta_x;  /* F37, |x| <= 0.00873 */
    const int64_t cos_x_1 = INT64_C(35184372088832) /* 1 */ - sin_x_part_2;  /* F45 */
    const int32_t cos_x = round_15(cos_x_1);  /* F30, |x| <= 1.01 */

    /* cos_y = cos(delta_y/2), with sin_y */
    const int64_t sin_y_part_1 = (int64_t)delta_y * delta_y;  /* F72 */
    const int32_t sin_y_part_2 = round_30(sin_y_part_1);  /* F44, |x| <= 7.62e-05 */
    const int64_t sin_y_part_3 = (int64_t)1431655765 /* 1/6 */ * sin_y_part_2;  /* F77 */
    const int64_t sin_y_part_4 = -sin_y_part_3;  /* F77 */
    const int32_t sin_y_part_5 = round_30(sin_y_part_4);  /* F47, |x| <= 1.27e-05 */
    const int64_t sin_y_part_6 = (int64_t)delta_y * sin_y_part_5;  /* F83 */
    const int32_t sin_y_part = round_30(sin_y_part_6);  /* F54, |x| <= 1.11e-07 */
    const int32_t sin_y_fine = round_short_17(sin_y_part);  /* F37 */
    const int32_t sin_y = sin_y_fine + delta_y;  /* F37, |x| <= 0.00873 */
    const int64_t cos_y_1 = INT64_C(35184372088832) /* 1 */ - sin_y_part_2;  /* F45 */
    const int32_t cos_y = round_15(cos_y_1);  /* F30, |x| <= 1.01 */

    /* tilt_z = sin_y sin_x; C_s'^s as [tilt_w, -tilt_x, -tilt_y, -tilt_z]   [rins (11)] */
    const int64_t tilt_w_1 = (int64_t)cos_y * cos_x;  /* F60 */
    const int32_t tilt_w = round_30(tilt_w_1);  /* F30, |x| <= 1.01 */
    const int64_t tilt_x_1 = (int64_t)cos_y * sin_x;  /* F67 */
    const int32_t tilt_x = round_30(tilt_x_1);  /* F37, |x| <= 0.00873 */
    const int64_t tilt_y_1 = (int64_t)sin_y * cos_x;  /* F67 */
    const int32_t tilt_y = round_30(tilt_y_1);  /* F37, |x| <= 0.00873 */
    const int64_t tilt_z_1 = (int64_t)sin_y * sin_x;  /* F74 */
    const int32_t tilt_z = round_42(tilt_z_1);  /* F32, |x| <= 7.62e-05 */

    /* cos_half = cos(al/2), with sin_half: al/2 folded to [0, pi/4], polynomials */
    const int32_t sin_half_1 = al * 1;  /* F28, |x| <= 4.72 */
    const int32_t sin_half_2 = 843314857 < sin_half_1;
    const int64_t sin_half_3 = sin_half_1 - INT64_C(1686629713);  /* F28 */
    const int32_t sin_half_4 = round_1(sin_half_3);  /* F27, |x| <= 11.1 */
    const int32_t sin_half_5 = round_short_1(sin_half_1);  /* F27 */
    const int32_t sin_half_6 = (sin_half_2 != 0) ? sin_half_4 : sin_half_5;  /* F27, |x| <= 11.1 */
    const int32_t sin_half_7 = clamp_32(sin_half_6, -1264975242, 421658414);  /* F27, |x| <= 9.43 */
    const int32_t sin_half_8 = sin_half_7 < -421657428;
    const int32_t sin_half_9 = sin_half_7 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t sin_half_10 = (sin_half_8 != 0) ? sin_half_9 : sin_half_7;  /* F27, |x| <= 9.43 */
    const int32_t sin_half_11 = clamp_32(sin_half_10, -421658414, 421658414);  /* F27, |x| <= 3.15 */
    const int32_t sin_half_12 = sin_half_11 < 0;
    const int32_t sin_half_13 = -sin_half_11;  /* F27, |x| <= 3.15 */
    const int32_t sin_half_14 = (sin_half_12 != 0) ? sin_half_13 : sin_half_11;  /* F27, |x| <= 3.15 */
    const int32_t sin_half_15 = clamp_32(sin_half_14, 0, 421658414);  /* F27, |x| <= 3.15 */
    const int32_t sin_half_16 = 210828714 < sin_half_15;
    const int32_t sin_half_17 = INT64_C(421657428) - sin_half_15;  /* F27, |x| <= 3.15 */
    const int32_t sin_half_18 = (sin_half_16 != 0) ? sin_half_17 : sin_half_15;  /* F27, |x| <= 3.15 */
    const int32_t sin_half_19 = clamp_32(sin_half_18, 0, 210829207);  /* F27, |x| <= 1.58 */
    const int32_t sin_half_20 = 105414357 < sin_half_19;
    const int32_t sin_half_21 = INT64_C(210828714) - sin_half_19;  /* F27, |x| <= 1.58 */
    const int32_t sin_half_22 = (sin_half_20 != 0) ? sin_half_21 : sin_half_19;  /* F27, |x| <= 1.58 */
    const int32_t sin_half_23 = clamp_32(sin_half_22, 0, 105414603);  /* F27, |x| <= 0.786 */
    const int64_t sin_half_24 = (int64_t)sin_half_23 * sin_half_23;  /* F54 */
    const int32_t sin_half_25 = round_23(sin_half_24);  /* F31, |x| <= 0.617 */
    const int64_t sin_half_26 = (int64_t)47780703 /* 1/368186 */ * sin_half_25;  /* F75 */
    const int64_t sin_half_27 = sin_half_26 - INT64_C(7494978749913852577) /* 122/614949 */;  /* F75 */
    const int32_t sin_half_28 = round_37(sin_half_27);  /* F38, |x| <= 0.000199 */
    const int64_t sin_half_29 = (int64_t)sin_half_25 * sin_half_28;  /* F69 */
    const int64_t sin_half_30 = INT64_C(4919128744126946120) /* 13624/1634881 */ + sin_half_29;  /* F69 */
    const int32_t sin_half_31 = round_35(sin_half_30);  /* F34, |x| <= 0.00834 */
    const int64_t sin_half_32 = (int64_t)sin_half_25 * sin_half_31;  /* F65 */
    /* F65 */
    const int64_t sin_half_33 = sin_half_32 - INT64_C(6148914676902249652) /* 71494348/428966089 */;
    const int32_t sin_half_34 = round_32(sin_half_33);  /* F33, |x| <= 0.167 */
    const int64_t sin_half_35 = (int64_t)sin_half_25 * sin_half_34;  /* F64 */
    const int32_t sin_half_36 = round_30(sin_half_35);  /* F34, |x| <= 0.103 */
    const int64_t sin_half_37 = sin_half_23 * INT64_C(17179869184);  /* F61 */
    const int64_t sin_half_38 = (int64_t)sin_half_23 * sin_half_36;  /* F61 */
    const int64_t sin_half_39 = sin_half_37 + sin_half_38;  /* F61 */
    const int32_t sin_half_40 = round_30(sin_half_39);  /* F31, |x| <= 0.786 */
    const int64_t sin_half_41 = (int64_t)53635181 /* 14/573995 */ * sin_half_25;  /* F72 */
    const int64_t sin_half_42 = sin_half_41 - INT64_C(6557838793880402655) /* 717/516319 */;  /* F72 */
    const int32_t sin_half_43 = round_36(sin_half_42);  /* F36, |x| <= 0.00139 */
    const int64_t sin_half_44 = (int64_t)sin_half_25 * sin_half_43;  /* F67 */
    const int64_t sin_half_45 = INT64_C(6148908294918647070) /* 40055/961321 */ + sin_half_44;  /* F67 */
    const int32_t sin_half_46 = round_35(sin_half_45);  /* F32, |x| <= 0.0417 */
    const int64_t sin_half_47 = (int64_t)sin_half_25 * sin_half_46;  /* F63 */
    /* F63 */
    const int64_t sin_half_48 = sin_half_47 - INT64_C(4611685993060359195) /* 90899215/181798431 */;
    const int32_t sin_half_49 = round_32(sin_half_48);  /* F31, |x| <= 0.5 */
    const int64_t sin_half_50 = (int64_t)sin_half_25 * sin_half_49;  /* F62 */
    const int64_t sin_half_51 = INT64_C(4611686018427387904) /* 1 */ + sin_half_50;  /* F62 */
    const int32_t sin_half_52 = round_32(sin_half_51);  /* F30, |x| <= 1.01 */
    const int32_t sin_half_53 = round_short_1(sin_half_40);  /* F30 */
    const int32_t sin_half_54 = (sin_half_20 != 0) ? sin_half_52 : sin_half_53;  /* F30, |x| <= 1.01 */
    const int32_t cos_half_1 = round_short_1(sin_half_40);  /* F30 */
    const int32_t cos_half_2 = (sin_half_20 != 0) ? cos_half_1 : sin_half_52;  /* F30, |x| <= 1.01 */
    const int32_t sin_half_55 = -sin_half_54;  /* F30, |x| <= 1.01 */
    const int32_t sin_half = (sin_half_12 != 0) ? sin_half_55 : sin_half_54;  /* F30, |x| <= 1.01 */
    const int32_t cos_half_3 = -cos_half_2;  /* F30, |x| <= 1.01 */
    const int32_t cos_half = (sin_half_16 != 0) ? cos_half_3 : cos_half_2;  /* F30, |x| <= 1.01 */

    /* q_sb = C_s'^s C_b^s' = [tilt_w, -tilt_x, ...] (x) [cos_half, 0, 0, -sin_half]   [rins (5)] */
    const int64_t q_sb_w_1 = (int64_t)tilt_w * cos_half;  /* F60 */
    const int64_t q_sb_w_2 = q_sb_w_1 * INT64_C(4);  /* F62 */
    const int64_t q_sb_w_3 = (int64_t)tilt_z * sin_half;  /* F62 */
    const int64_t q_sb_w_4 = q_sb_w_2 - q_sb_w_3;  /* F62 */
    const int32_t q_sb_w = round_32(q_sb_w_4);  /* F30, |x| <= 1.01 */
    const int64_t q_sb_x_1 = (int64_t)tilt_y * sin_half;  /* F67 */
    const int64_t q_sb_x_2 = (int64_t)tilt_x * cos_half;  /* F67 */
    const int64_t q_sb_x_3 = q_sb_x_1 - q_sb_x_2;  /* F67 */
    const int32_t q_sb_x = round_35(q_sb_x_3);  /* F32, |x| <= 0.0175 */
    const int64_t q_sb_y_negated_1 = (int64_t)tilt_y * cos_half;  /* F67 */
    const int64_t q_sb_y_negated_2 = (int64_t)tilt_x * sin_half;  /* F67 */
    const int64_t q_sb_y_negated_3 = q_sb_y_negated_1 + q_sb_y_negated_2;  /* F67 */
    const int32_t q_sb_y_negated = round_35(q_sb_y_negated_3);  /* F32, |x| <= 0.0175 */
    const int64_t q_sb_z_negated_1 = (int64_t)tilt_z * cos_half;  /* F62 */
    const int64_t q_sb_z_negated_2 = (int64_t)tilt_w * sin_half;  /* F60 */
    const int64_t q_sb_z_negated_3 = q_sb_z_negated_2 * INT64_C(4);  /* F62 */
    const int64_t q_sb_z_negated_4 = q_sb_z_negated_1 + q_sb_z_negated_3;  /* F62 */
    const int32_t q_sb_z_negated = round_32(q_sb_z_negated_4);  /* F30, |x| <= 1.01 */

    /* q_nb = q_ns (x) q_sb   [rins (10)] */
    const int32_t q_sb_x_negated = -q_sb_x;  /* F32 */

    /* q, read once */
    const int64_t q_w_whole = state->q[0];  /* F62, |x| <= 1.01 */
    const int32_t q_w = round_32(q_w_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_x_whole = state->q[1];  /* F62, |x| <= 1.01 */
    const int32_t q_x = round_32(q_x_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_y_whole = state->q[2];  /* F62, |x| <= 1.01 */
    const int32_t q_y = round_32(q_y_whole);  /* F30, |x| <= 1.01 */
    const int64_t q_z_whole = state->q[3];  /* F62, |x| <= 1.01 */
    const int32_t q_z = round_32(q_z_whole);  /* F30, |x| <= 1.01 */

    /* q_nb = q_ns (x) q_sb   [rins (10)] */
    const int64_t q_nb_w_1 = (int64_t)q_w * q_sb_w;  /* F60 */
    const int64_t q_nb_w_2 = q_nb_w_1 * INT64_C(4);  /* F62 */
    const int64_t q_nb_w_3 = (int64_t)q_x * q_sb_x_negated;  /* F62 */
    const int64_t q_nb_w_4 = q_nb_w_2 + q_nb_w_3;  /* F62 */
    const int64_t q_nb_w_5 = (int64_t)q_y * q_sb_y_negated;  /* F62 */
    const int64_t q_nb_w_6 = q_nb_w_4 + q_nb_w_5;  /* F62 */
    const int64_t q_nb_w_7 = (int64_t)q_z * q_sb_z_negated;  /* F60 */
    const int64_t q_nb_w_8 = q_nb_w_7 * INT64_C(4);  /* F62 */
    const int64_t q_nb_w_9 = q_nb_w_6 + q_nb_w_8;  /* F62 */
    const int32_t q_nb_w_10 = round_32(q_nb_w_9);  /* F30, |x| <= 1.43 */
    const int32_t q_sb_z_negated_negated = -q_sb_z_negated;  /* F30 */
    const int64_t q_nb_x_1 = (int64_t)q_x * q_sb_w;  /* F60 */
    const int64_t q_nb_x_2 = q_nb_x_1 * INT64_C(4);  /* F62 */
    const int64_t q_nb_x_3 = (int64_t)q_w * q_sb_x;  /* F62 */
    const int64_t q_nb_x_4 = q_nb_x_2 + q_nb_x_3;  /* F62 */
    const int64_t q_nb_x_5 = (int64_t)q_z * q_sb_y_negated;  /* F62 */
    const int64_t q_nb_x_6 = q_nb_x_4 + q_nb_x_5;  /* F62 */
    const int64_t q_nb_x_7 = (int64_t)q_y * q_sb_z_negated_negated;  /* F60 */
    const int64_t q_nb_x_8 = q_nb_x_7 * INT64_C(4);  /* F62 */
    const int64_t q_nb_x_9 = q_nb_x_6 + q_nb_x_8;  /* F62 */
    const int32_t q_nb_x_10 = round_32(q_nb_x_9);  /* F30, |x| <= 1.43 */
    const int32_t q_sb_y_negated_negated = -q_sb_y_negated;  /* F32 */
    const int64_t q_nb_y_1 = (int64_t)q_y * q_sb_w;  /* F60 */
    const int64_t q_nb_y_2 = q_nb_y_1 * INT64_C(4);  /* F62 */
    const int64_t q_nb_y_3 = (int64_t)q_z * q_sb_x;  /* F62 */
    const int64_t q_nb_y_4 = q_nb_y_2 + q_nb_y_3;  /* F62 */
    const int64_t q_nb_y_5 = (int64_t)q_w * q_sb_y_negated_negated;  /* F62 */
    const int64_t q_nb_y_6 = q_nb_y_4 + q_nb_y_5;  /* F62 */
    const int64_t q_nb_y_7 = (int64_t)q_x * q_sb_z_negated;  /* F60 */
    const int64_t q_nb_y_8 = q_nb_y_7 * INT64_C(4);  /* F62 */
    const int64_t q_nb_y_9 = q_nb_y_6 + q_nb_y_8;  /* F62 */
    const int32_t q_nb_y_10 = round_32(q_nb_y_9);  /* F30, |x| <= 1.43 */
    const int64_t q_nb_z_1 = (int64_t)q_z * q_sb_w;  /* F60 */
    const int64_t q_nb_z_2 = q_nb_z_1 * INT64_C(4);  /* F62 */
    const int64_t q_nb_z_3 = (int64_t)q_y * q_sb_x_negated;  /* F62 */
    const int64_t q_nb_z_4 = q_nb_z_2 + q_nb_z_3;  /* F62 */
    const int64_t q_nb_z_5 = (int64_t)q_x * q_sb_y_negated_negated;  /* F62 */
    const int64_t q_nb_z_6 = q_nb_z_4 + q_nb_z_5;  /* F62 */
    const int64_t q_nb_z_7 = (int64_t)q_w * q_sb_z_negated_negated;  /* F60 */
    const int64_t q_nb_z_8 = q_nb_z_7 * INT64_C(4);  /* F62 */
    const int64_t q_nb_z_9 = q_nb_z_6 + q_nb_z_8;  /* F62 */
    const int32_t q_nb_z_10 = round_32(q_nb_z_9);  /* F30, |x| <= 1.43 */
    const int32_t q_nb_w = clamp_32(q_nb_w_10, -1082130432, 1082130432);  /* F30, |x| <= 1.01 */
    const int32_t q_nb_x = clamp_32(q_nb_x_10, -1082130432, 1082130432);  /* F30, |x| <= 1.01 */
    const int32_t q_nb_y = clamp_32(q_nb_y_10, -1082130432, 1082130432);  /* F30, |x| <= 1.01 */
    const int32_t q_nb_z = clamp_32(q_nb_z_10, -1082130432, 1082130432);  /* F30, |x| <= 1.01 */

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void rotation_vector_3_coning_rins_fixed32_compensated_body_dcm(const int32_t q_nb[4], int32_t c_nb[9])
{
    /* q_nb, read once */
    const int32_t q_nb_w = q_nb[0];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_x = q_nb[1];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_y = q_nb[2];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_z = q_nb[3];  /* F30, |x| <= 1.01 */

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const int64_t wx_1 = (int64_t)q_nb_w * q_nb_x;  /* F60 */
    const int32_t wx = round_29(wx_1);  /* F30, |x| <= 1.01 */
    const int64_t wy_1 = (int64_t)q_nb_w * q_nb_y;  /* F60 */
    const int32_t wy = round_29(wy_1);  /* F30, |x| <= 1.01 */
    const int64_t wz_1 = (int64_t)q_nb_w * q_nb_z;  /* F60 */
    const int32_t wz = round_29(wz_1);  /* F30, |x| <= 1.01 */
    const int64_t xx_1 = (int64_t)q_nb_x * q_nb_x;  /* F60 */
    const int32_t xx = round_30(xx_1);  /* F29, |x| <= 2.01 */
    const int64_t xy_1 = (int64_t)q_nb_x * q_nb_y;  /* F60 */
    const int32_t xy = round_29(xy_1);  /* F30, |x| <= 1.01 */
    const int64_t xz_1 = (int64_t)q_nb_x * q_nb_z;  /* F60 */
    const int32_t xz = round_29(xz_1);  /* F30, |x| <= 1.01 */
    const int64_t yy_1 = (int64_t)q_nb_y * q_nb_y;  /* F60 */
    const int32_t yy = round_30(yy_1);  /* F29, |x| <= 2.01 */
    const int64_t yz_1 = (int64_t)q_nb_y * q_nb_z;  /* F60 */
    const int32_t yz = round_29(yz_1);  /* F30, |x| <= 1.01 */
    const int64_t zz_1 = (int64_t)q_nb_z * q_nb_z;  /* F60 */
    const int32_t zz = round_30(zz_1);  /* F29, |x| <= 2.01 */

    /* c_nb = C_nb(q)   [cao (15)] */
    const int64_t c_nb_11_1 = yy * INT64_C(2);  /* F30 */
    const int64_t c_nb_11_2 = zz * INT64_C(2);  /* F30 */
    const int64_t c_nb_11_3 = c_nb_11_1 + c_nb_11_2;  /* F30 */
    const int64_t c_nb_11_4 = INT64_C(1073741824) /* 1 */ - c_nb_11_3;  /* F30 */
    const int32_t c_nb_11 = (int32_t)c_nb_11_4;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_12_1 = (int64_t)xy - wz;  /* F30 */
    const int32_t c_nb_12 = (int32_t)c_nb_12_1;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_13_1 = (int64_t)xz + wy;  /* F30 */
    const int32_t c_nb_13 = (int32_t)c_nb_13_1;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_21_1 = (int64_t)xy + wz;  /* F30 */
    const int32_t c_nb_21 = (int32_t)c_nb_21_1;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_22_1 = xx * INT64_C(2);  /* F30 */
    const int64_t c_nb_22_2 = zz * INT64_C(2);  /* F30 */
    const int64_t c_nb_22_3 = c_nb_22_1 + c_nb_22_2;  /* F30 */
    const int64_t c_nb_22_4 = INT64_C(1073741824) /* 1 */ - c_nb_22_3;  /* F30 */
    const int32_t c_nb_22 = (int32_t)c_nb_22_4;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_23_1 = (int64_t)yz - wx;  /* F30 */
    const int32_t c_nb_23 = (int32_t)c_nb_23_1;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_31_1 = (int64_t)xz - wy;  /* F30 */
    const int32_t c_nb_31 = (int32_t)c_nb_31_1;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_32_1 = (int64_t)yz + wx;  /* F30 */
    const int32_t c_nb_32 = (int32_t)c_nb_32_1;  /* F30, |x| <= 1.01 */
    const int64_t c_nb_33_1 = xx * INT64_C(2);  /* F30 */
    const int64_t c_nb_33_2 = yy * INT64_C(2);  /* F30 */
    const int64_t c_nb_33_3 = c_nb_33_1 + c_nb_33_2;  /* F30 */
    const int64_t c_nb_33_4 = INT64_C(1073741824) /* 1 */ - c_nb_33_3;  /* F30 */
    const int32_t c_nb_33 = (int32_t)c_nb_33_4;  /* F30, |x| <= 1.01 */

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

void rotation_vector_3_coning_rins_fixed32_compensated_body_euler(const int32_t q_nb[4], int32_t rpy[3])
{
    /* q_nb, read once */
    const int32_t q_nb_w = q_nb[0];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_x = q_nb[1];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_y = q_nb[2];  /* F30, |x| <= 1.01 */
    const int32_t q_nb_z = q_nb[3];  /* F30, |x| <= 1.01 */

    /* half_sum = (yaw + roll)/2   [zxy] */
    const int64_t half_sum_1 = (int64_t)q_nb_z + q_nb_y;  /* F30 */
    const int32_t half_sum_2 = round_1(half_sum_1);  /* F29, |x| <= 2.01 */
    const int64_t half_sum_3 = (int64_t)q_nb_w + q_nb_x;  /* F30 */
    const int32_t half_sum_4 = round_1(half_sum_3);  /* F29, |x| <= 2.01 */
    const int64_t half_difference_1 = (int64_t)q_nb_z - q_nb_y;  /* F30 */
    const int32_t half_difference_2 = round_1(half_difference_1);  /* F29, |x| <= 2.01 */
    const int64_t half_difference_3 = (int64_t)q_nb_w - q_nb_x;  /* F30 */
    const int32_t half_difference_4 = round_1(half_difference_3);  /* F29, |x| <= 2.01 */
    const int32_t half_sum_5 = half_sum_2 < 0;
    const int32_t half_sum_6 = -half_sum_2;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_7 = (half_sum_5 != 0) ? half_sum_6 : half_sum_2;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_8 = half_sum_4 < 0;
    const int32_t half_sum_9 = -half_sum_4;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_10 = (half_sum_8 != 0) ? half_sum_9 : half_sum_4;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_11 = half_sum_10 < half_sum_7;
    const int32_t half_sum_12 = (half_sum_11 != 0) ? half_sum_10 : half_sum_7;  /* F29, |x| <= 2.01 */
    const int32_t half_sum_13 = (half_sum_11 != 0) ? half_sum_7 : half_sum_10;  /* F29, |x| <= 2.01 */
    const int64_t half_sum_14 = (int64_t)889516847 /* 10355339/25000000 */ * half_sum_13;  /* F60 */
    const int32_t half_sum_15 = round_29(half_sum_14);  /* F31, |x| <= 0.83 */
    const int64_t half_sum_16 = half_sum_15 * INT64_C(1);  /* F31 */
    const int64_t half_sum_17 = half_sum_12 * INT64_C(4);  /* F31 */
    const int32_t half_sum_18 = half_sum_16 < half_sum_17;
    const int64_t half_sum_19 = (int64_t)half_sum_12 - half_sum_13;  /* F29 */
    const int32_t half_sum_20 = round_1(half_sum_19);  /* F28, |x| <= 4.01 */
    const int32_t half_sum_21 = round_short_1(half_sum_12);  /* F28 */
    const int32_t half_sum_22 = (half_sum_18 != 0) ? half_sum_20 : half_sum_21;  /* F28, |x| <= 4.01 */
    const int64_t half_sum_23 = (int64_t)half_sum_12 + half_sum_13;  /* F29 */
    const int32_t half_sum_24 = round_1(half_sum_23);  /* F28, |x| <= 4.01 */
    const int32_t half_sum_25 = round_short_1(half_sum_13);  /* F28 */
    const int32_t half_sum_26 = (half_sum_18 != 0) ? half_sum_24 : half_sum_25;  /* F28, |x| <= 4.01 */
    const int32_t half_sum_27 = clamp_32(half_sum_26, 2, 2147483647);  /* F28, |x| <= 4.01 */
    const int64_t half_sum_28 = half_sum_22 * INT64_C(4294967296);  /* F60 */
    const int64_t half_sum_29 = half_sum_28 / half_sum_27;  /* F32, |x| <= 5.38e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t half_sum_30 = clamp_64_to_32(half_sum_29, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t half_sum_31 = (int64_t)half_sum_30 * half_sum_30;  /* F64 */
    const int32_t half_sum_32 = round_31(half_sum_31);  /* F33, |x| <= 0.172 */
    const int64_t half_sum_33 = (int64_t)510875761 /* 382/6423 */ * half_sum_32;  /* F66 */
    const int64_t half_sum_34 = INT64_C(7773993415904670242) /* 1650/15661 */ - half_sum_33;  /* F66 */
    const int32_t half_sum_35 = round_34(half_sum_34);  /* F32, |x| <= 0.106 */
    const int64_t half_sum_36 = (int64_t)half_sum_32 * half_sum_35;  /* F65 */
    const int64_t half_sum_37 = half_sum_36 - INT64_C(5251586747234353517) /* 7339/51558 */;  /* F65 */
    const int32_t half_sum_38 = round_33(half_sum_37);  /* F32, |x| <= 0.143 */
    const int64_t half_sum_39 = (int64_t)half_sum_32 * half_sum_38;  /* F65 */
    const int64_t half_sum_40 = INT64_C(7377920055805538292) /* 58828/294171 */ + half_sum_39;  /* F65 */
    const int32_t half_sum_41 = round_34(half_sum_40);  /* F31, |x| <= 0.2 */
    const int64_t half_sum_42 = (int64_t)half_sum_32 * half_sum_41;  /* F64 */
    const int64_t half_sum_43 = half_sum_42 - INT64_C(6148909082171862706) /* 365415/1096246 */;  /* F64 */
    const int32_t half_sum_44 = round_32(half_sum_43);  /* F32, |x| <= 0.334 */
    const int64_t half_sum_45 = (int64_t)half_sum_32 * half_sum_44;  /* F65 */
    const int32_t half_sum_46 = round_30(half_sum_45);  /* F35, |x| <= 0.0573 */
    const int64_t half_sum_47 = (int64_t)half_sum_30 * half_sum_46;  /* F67 */
    const int32_t half_sum_48 = round_35(half_sum_47);  /* F32, |x| <= 0.0238 */
    const int32_t half_sum_49 = half_sum_30 + half_sum_48;  /* F32, |x| <= 0.439 */
    const int64_t half_sum_50 = INT64_C(3373259426) + half_sum_49;  /* F32 */
    const int32_t half_sum_51 = round_2(half_sum_50);  /* F30, |x| <= 1.23 */
    const int32_t half_sum_52 = round_short_2(half_sum_49);  /* F30 */
    const int32_t half_sum_53 = (half_sum_18 != 0) ? half_sum_51 : half_sum_52;  /* F30, |x| <= 1.23 */
    const int64_t half_sum_54 = INT64_C(1686629713) - half_sum_53;  /* F30 */
    const int32_t half_sum_55 = round_1(half_sum_54);  /* F29, |x| <= 2.01 */
    const int32_t half_sum_56 = round_short_1(half_sum_53);  /* F29 */
    const int32_t half_sum_57 = (half_sum_11 != 0) ? half_sum_55 : half_sum_56;  /* F29, |x| <= 2.01 */
    const int64_t half_sum_58 = INT64_C(1686629713) - half_sum_57;  /* F29 */
    const int32_t half_sum_59 = (int32_t)half_sum_58;  /* F29, |x| <= 3.58 */
    const int32_t half_sum_60 = (half_sum_8 != 0) ? half_sum_59 : half_sum_57;  /* F29, |x| <= 3.58 */
    const int32_t half_sum_61 = -half_sum_60;  /* F29, |x| <= 3.58 */
    const int32_t half_sum = (half_sum_5 != 0) ? half_sum_61 : half_sum_60;  /* F29, |x| <= 3.58 */

    /* half_difference = (yaw - roll)/2   [zxy] */
    const int32_t half_difference_5 = half_difference_2 < 0;
    const int32_t half_difference_6 = -half_difference_2;  /* F29, |x| <= 2.01 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_7 = (half_difference_5 != 0) ? half_difference_6 : half_difference_2;
    const int32_t half_difference_8 = half_difference_4 < 0;
    const int32_t half_difference_9 = -half_difference_4;  /* F29, |x| <= 2.01 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_10 = (half_difference_8 != 0) ? half_difference_9 : half_difference_4;
    const int32_t half_difference_11 = half_difference_10 < half_difference_7;
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_12 = (half_difference_11 != 0) ? half_difference_10 : half_difference_7;
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_13 = (half_difference_11 != 0) ? half_difference_7 : half_difference_10;
    /* F60 */
    const int64_t half_difference_14 = (int64_t)889516847 /* 10355339/25000000 */ * half_difference_13;
    const int32_t half_difference_15 = round_29(half_difference_14);  /* F31, |x| <= 0.83 */
    const int64_t half_difference_16 = half_difference_15 * INT64_C(1);  /* F31 */
    const int64_t half_difference_17 = half_difference_12 * INT64_C(4);  /* F31 */
    const int32_t half_difference_18 = half_difference_16 < half_difference_17;
    const int64_t half_difference_19 = (int64_t)half_difference_12 - half_difference_13;  /* F29 */
    const int32_t half_difference_20 = round_1(half_difference_19);  /* F28, |x| <= 4.01 */
    const int32_t half_difference_21 = round_short_1(half_difference_12);  /* F28 */
    /* F28, |x| <= 4.01 */
    const int32_t half_difference_22 = (half_difference_18 != 0) ? half_difference_20 : half_difference_21;
    const int64_t half_difference_23 = (int64_t)half_difference_12 + half_difference_13;  /* F29 */
    const int32_t half_difference_24 = round_1(half_difference_23);  /* F28, |x| <= 4.01 */
    const int32_t half_difference_25 = round_short_1(half_difference_13);  /* F28 */
    /* F28, |x| <= 4.01 */
    const int32_t half_difference_26 = (half_difference_18 != 0) ? half_difference_24 : half_difference_25;
    const int32_t half_difference_27 = clamp_32(half_difference_26, 2, 2147483647);  /* F28, |x| <= 4.01 */
    const int64_t half_difference_28 = half_difference_22 * INT64_C(4294967296);  /* F60 */
    const int64_t half_difference_29 = half_difference_28 / half_difference_27;  /* F32, |x| <= 5.38e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t half_difference_30 = clamp_64_to_32(half_difference_29, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t half_difference_31 = (int64_t)half_difference_30 * half_difference_30;  /* F64 */
    const int32_t half_difference_32 = round_31(half_difference_31);  /* F33, |x| <= 0.172 */
    const int64_t half_difference_33 = (int64_t)510875761 /* 382/6423 */ * half_difference_32;  /* F66 */
    /* F66 */
    const int64_t half_difference_34 = INT64_C(7773993415904670242) /* 1650/15661 */ - half_difference_33;
    const int32_t half_difference_35 = round_34(half_difference_34);  /* F32, |x| <= 0.106 */
    const int64_t half_difference_36 = (int64_t)half_difference_32 * half_difference_35;  /* F65 */
    /* F65 */
    const int64_t half_difference_37 = half_difference_36 - INT64_C(5251586747234353517) /* 7339/51558 */;
    const int32_t half_difference_38 = round_33(half_difference_37);  /* F32, |x| <= 0.143 */
    const int64_t half_difference_39 = (int64_t)half_difference_32 * half_difference_38;  /* F65 */
    /* F65 */
    const int64_t half_difference_40 = INT64_C(7377920055805538292) /* 58828/294171 */ + half_difference_39;
    const int32_t half_difference_41 = round_34(half_difference_40);  /* F31, |x| <= 0.2 */
    const int64_t half_difference_42 = (int64_t)half_difference_32 * half_difference_41;  /* F64 */
    /* F64 */
    const int64_t half_difference_43 = half_difference_42 - INT64_C(6148909082171862706) /* 365415/1096246 */;
    const int32_t half_difference_44 = round_32(half_difference_43);  /* F32, |x| <= 0.334 */
    const int64_t half_difference_45 = (int64_t)half_difference_32 * half_difference_44;  /* F65 */
    const int32_t half_difference_46 = round_30(half_difference_45);  /* F35, |x| <= 0.0573 */
    const int64_t half_difference_47 = (int64_t)half_difference_30 * half_difference_46;  /* F67 */
    const int32_t half_difference_48 = round_35(half_difference_47);  /* F32, |x| <= 0.0238 */
    const int32_t half_difference_49 = half_difference_30 + half_difference_48;  /* F32, |x| <= 0.439 */
    const int64_t half_difference_50 = INT64_C(3373259426) + half_difference_49;  /* F32 */
    const int32_t half_difference_51 = round_2(half_difference_50);  /* F30, |x| <= 1.23 */
    const int32_t half_difference_52 = round_short_2(half_difference_49);  /* F30 */
    /* F30, |x| <= 1.23 */
    const int32_t half_difference_53 = (half_difference_18 != 0) ? half_difference_51 : half_difference_52;
    const int64_t half_difference_54 = INT64_C(1686629713) - half_difference_53;  /* F30 */
    const int32_t half_difference_55 = round_1(half_difference_54);  /* F29, |x| <= 2.01 */
    const int32_t half_difference_56 = round_short_1(half_difference_53);  /* F29 */
    /* F29, |x| <= 2.01 */
    const int32_t half_difference_57 = (half_difference_11 != 0) ? half_difference_55 : half_difference_56;
    const int64_t half_difference_58 = INT64_C(1686629713) - half_difference_57;  /* F29 */
    const int32_t half_difference_59 = (int32_t)half_difference_58;  /* F29, |x| <= 3.58 */
    /* F29, |x| <= 3.58 */
    const int32_t half_difference_60 = (half_difference_8 != 0) ? half_difference_59 : half_difference_57;
    const int32_t half_difference_61 = -half_difference_60;  /* F29, |x| <= 3.58 */
    /* F29, |x| <= 3.58 */
    const int32_t half_difference = (half_difference_5 != 0) ? half_difference_61 : half_difference_60;

    /* pitch = 2 atan(sqrt(up/down)) - pi/2   [zxy] */
    const int64_t pitch_1 = (int64_t)half_sum_4 * half_sum_4;  /* F58 */
    const int64_t pitch_3 = (int64_t)half_sum_2 * half_sum_2;  /* F58 */
    const int64_t pitch_4 = pitch_1 + pitch_3;  /* F60, |x| <= 2.01 */
    const int32_t pitch_5 = pitch_4 < INT64_C(268435456) /* 1/4294967296 */;
    /* F60, |x| <= 2.33e-10 */
    const int32_t pitch_6 = clamp_64_to_32(pitch_4, INT64_C(0), INT64_C(268435456));
    const int64_t pitch_7 = pitch_6 * INT64_C(1);  /* F28, |x| <= 1 */
    const int64_t pitch_8 = pitch_7 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_9 = (pitch_5 != 0) ? pitch_8 : pitch_4;  /* F60, |x| <= 2.01 */
    /* F31, |x| <= 0.501 */
    const int32_t pitch_10 = (pitch_5 != 0) ? 16384 /* 1/131072 */ : 1073741824 /* 1/2 */;
    const int32_t pitch_11 = pitch_9 < INT64_C(17592186044416) /* 1/65536 */;
    /* F60, |x| <= 1.53e-05 */
    const int64_t pitch_12 = clamp_64(pitch_9, INT64_C(0), INT64_C(17592186044416));
    const int64_t pitch_13 = pitch_12 * INT64_C(1);  /* F44, |x| <= 1 */
    const int64_t pitch_14 = pitch_13 * INT64_C(65536);  /* F60 */
    const int64_t pitch_15 = (pitch_11 != 0) ? pitch_14 : pitch_9;  /* F60, |x| <= 2.01 */
    const int32_t pitch_16 = pitch_10 * 1;  /* F39, |x| <= 0.00196 */
    const int32_t pitch_17 = round_short_8(pitch_16);  /* F31 */
    const int32_t pitch_18 = (pitch_11 != 0) ? pitch_17 : pitch_10;  /* F31, |x| <= 0.501 */
    const int32_t pitch_19 = pitch_15 < INT64_C(4503599627370496) /* 1/256 */;
    /* F60, |x| <= 0.00391 */
    const int64_t pitch_20 = clamp_64(pitch_15, INT64_C(0), INT64_C(4503599627370496));
    const int64_t pitch_21 = pitch_20 * INT64_C(1);  /* F52, |x| <= 1 */
    const int64_t pitch_22 = pitch_21 * INT64_C(256);  /* F60 */
    const int64_t pitch_23 = (pitch_19 != 0) ? pitch_22 : pitch_15;  /* F60, |x| <= 2.01 */
    const int32_t pitch_24 = pitch_18 * 1;  /* F35, |x| <= 0.0313 */
    const int32_t pitch_25 = round_short_4(pitch_24);  /* F31 */
    const int32_t pitch_26 = (pitch_19 != 0) ? pitch_25 : pitch_18;  /* F31, |x| <= 0.501 */
    const int32_t pitch_27 = pitch_23 < INT64_C(72057594037927936) /* 1/16 */;
    /* F60, |x| <= 0.0625 */
    const int64_t pitch_28 = clamp_64(pitch_23, INT64_C(0), INT64_C(72057594037927936));
    const int64_t pitch_29 = pitch_28 * INT64_C(1);  /* F56, |x| <= 1 */
    const int64_t pitch_30 = pitch_29 * INT64_C(16);  /* F60 */
    const int64_t pitch_31 = (pitch_27 != 0) ? pitch_30 : pitch_23;  /* F60, |x| <= 2.01 */
    const int32_t pitch_32 = pitch_26 * 1;  /* F33, |x| <= 0.126 */
    const int32_t pitch_33 = round_short_2(pitch_32);  /* F31 */
    const int32_t pitch_34 = (pitch_27 != 0) ? pitch_33 : pitch_26;  /* F31, |x| <= 0.501 */
    const int32_t pitch_35 = pitch_31 < INT64_C(288230376151711744) /* 1/4 */;
    /* F60, |x| <= 0.25 */
    const int64_t pitch_36 = clamp_64(pitch_31, INT64_C(0), INT64_C(288230376151711744));
    const int64_t pitch_37 = pitch_36 * INT64_C(1);  /* F58, |x| <= 1 */
    const int64_t pitch_38 = pitch_37 * INT64_C(4);  /* F60 */
    const int64_t pitch_39 = (pitch_35 != 0) ? pitch_38 : pitch_31;  /* F60, |x| <= 2.01 */
    const int32_t pitch_40 = pitch_34 * 1;  /* F32, |x| <= 0.251 */
    const int32_t pitch_41 = round_short_1(pitch_40);  /* F31 */
    const int32_t pitch_42 = (pitch_35 != 0) ? pitch_41 : pitch_34;  /* F31, |x| <= 0.501 */
    const int32_t pitch_43 = round_31(pitch_39);  /* F27, |x| <= 8.02 */
    const int32_t pitch_44 = clamp_32(pitch_43, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_45 = clamp_32(pitch_44, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_46 = -pitch_45;  /* F27 */
    const int64_t pitch_47 = (int64_t)747135655 /* 47816681919/17592186044416 */ * pitch_46;  /* F65 */
    /* F65 */
    const int64_t pitch_48 = INT64_C(1527667556037427200) /* 182112164025/4398046511104 */ + pitch_47;
    const int32_t pitch_49 = round_30(pitch_48);  /* F35, |x| <= 0.0387 */
    const int64_t pitch_50 = (int64_t)pitch_45 * pitch_49;  /* F62 */
    /* F62 */
    const int64_t pitch_51 = pitch_50 - INT64_C(1179613329067868160) /* 2249933870445/8796093022208 */;
    const int32_t pitch_52 = round_29(pitch_51);  /* F33, |x| <= 0.226 */
    const int64_t pitch_53 = (int64_t)pitch_45 * pitch_52;  /* F60 */
    /* F60 */
    const int64_t pitch_54 = INT64_C(951679935904743424) /* 1815185424623/2199023255552 */ + pitch_53;
    const int32_t pitch_55 = round_29(pitch_54);  /* F31, |x| <= 0.725 */
    const int64_t pitch_56 = (int64_t)pitch_45 * pitch_55;  /* F58 */
    /* F58 */
    const int64_t pitch_57 = pitch_56 - INT64_C(436656008213790720) /* 13325683844415/8796093022208 */;
    const int32_t pitch_58 = round_28(pitch_57);  /* F30, |x| <= 1.82 */
    const int64_t pitch_59 = (int64_t)pitch_45 * pitch_58;  /* F57 */
    /* F57 */
    const int64_t pitch_60 = INT64_C(274651154808430592) /* 33526752295951/17592186044416 */ + pitch_59;
    const int32_t pitch_61 = round_29(pitch_60);  /* F28, |x| <= 7.44 */
    const int32_t pitch_62 = clamp_32(pitch_61, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t pitch_63 = (int64_t)pitch_62 * pitch_62;  /* F56 */
    const int32_t pitch_64 = round_26(pitch_63);  /* F30, |x| <= 1.57 */
    const int64_t pitch_65 = (int64_t)pitch_46 * pitch_64;  /* F57 */
    const int64_t pitch_66 = INT64_C(144115188075855872) /* 1 */ + pitch_65;  /* F57 */
    const int32_t pitch_67 = round_29(pitch_66);  /* F28, |x| <= 5.26 */
    const int64_t pitch_68 = pitch_62 * INT64_C(536870912);  /* F57 */
    const int64_t pitch_69 = (int64_t)pitch_62 * pitch_67;  /* F56 */
    const int64_t pitch_70 = pitch_68 + pitch_69;  /* F57 */
    const int32_t pitch_71 = round_28(pitch_70);  /* F29, |x| <= 3.04 */
    const int32_t pitch_72 = clamp_32(pitch_71, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_73 = (int64_t)pitch_72 * pitch_72;  /* F58 */
    const int32_t pitch_74 = round_28(pitch_73);  /* F30, |x| <= 1.57 */
    const int64_t pitch_75 = (int64_t)pitch_46 * pitch_74;  /* F57 */
    const int64_t pitch_76 = INT64_C(144115188075855872) /* 1 */ + pitch_75;  /* F57 */
    const int32_t pitch_77 = round_29(pitch_76);  /* F28, |x| <= 5.26 */
    const int64_t pitch_78 = pitch_72 * INT64_C(536870912);  /* F58 */
    const int64_t pitch_79 = (int64_t)pitch_72 * pitch_77;  /* F57 */
    const int64_t pitch_80 = pitch_78 + pitch_79;  /* F58 */
    const int32_t pitch_81 = round_29(pitch_80);  /* F29, |x| <= 3.04 */
    const int32_t pitch_82 = clamp_32(pitch_81, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_83 = (int64_t)pitch_44 * pitch_82;  /* F56 */
    const int32_t pitch_84 = round_28(pitch_83);  /* F28, |x| <= 5.01 */
    const int64_t pitch_85 = (int64_t)pitch_84 * pitch_42;  /* F59 */
    const int32_t pitch_86 = round_30(pitch_85);  /* F29, |x| <= 2.51 */
    const int64_t pitch_87 = (int64_t)half_difference_4 * half_difference_4;  /* F58 */
    const int64_t pitch_88 = (int64_t)half_difference_2 * half_difference_2;  /* F58 */
    const int64_t pitch_89 = pitch_87 + pitch_88;  /* F60, |x| <= 2.01 */
    const int32_t pitch_90 = pitch_89 < INT64_C(268435456) /* 1/4294967296 */;
    /* F60, |x| <= 2.33e-10 */
    const int32_t pitch_91 = clamp_64_to_32(pitch_89, INT64_C(0), INT64_C(268435456));
    const int64_t pitch_92 = pitch_91 * INT64_C(1);  /* F28, |x| <= 1 */
    const int64_t pitch_93 = pitch_92 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_94 = (pitch_90 != 0) ? pitch_93 : pitch_89;  /* F60, |x| <= 2.01 */
    /* F31, |x| <= 0.501 */
    const int32_t pitch_95 = (pitch_90 != 0) ? 16384 /* 1/131072 */ : 1073741824 /* 1/2 */;
    const int32_t pitch_96 = pitch_94 < INT64_C(17592186044416) /* 1/65536 */;
    /* F60, |x| <= 1.53e-05 */
    const int64_t pitch_97 = clamp_64(pitch_94, INT64_C(0), INT64_C(17592186044416));
    const int64_t pitch_98 = pitch_97 * INT64_C(1);  /* F44, |x| <= 1 */
    const int64_t pitch_99 = pitch_98 * INT64_C(65536);  /* F60 */
    const int64_t pitch_100 = (pitch_96 != 0) ? pitch_99 : pitch_94;  /* F60, |x| <= 2.01 */
    const int32_t pitch_101 = pitch_95 * 1;  /* F39, |x| <= 0.00196 */
    const int32_t pitch_102 = round_short_8(pitch_101);  /* F31 */
    const int32_t pitch_103 = (pitch_96 != 0) ? pitch_102 : pitch_95;  /* F31, |x| <= 0.501 */
    const int32_t pitch_104 = pitch_100 < INT64_C(4503599627370496) /* 1/256 */;
    /* F60, |x| <= 0.00391 */
    const int64_t pitch_105 = clamp_64(pitch_100, INT64_C(0), INT64_C(4503599627370496));
    const int64_t pitch_106 = pitch_105 * INT64_C(1);  /* F52, |x| <= 1 */
    const int64_t pitch_107 = pitch_106 * INT64_C(256);  /* F60 */
    const int64_t pitch_108 = (pitch_104 != 0) ? pitch_107 : pitch_100;  /* F60, |x| <= 2.01 */
    const int32_t pitch_109 = pitch_103 * 1;  /* F35, |x| <= 0.0313 */
    const int32_t pitch_110 = round_short_4(pitch_109);  /* F31 */
    const int32_t pitch_111 = (pitch_104 != 0) ? pitch_110 : pitch_103;  /* F31, |x| <= 0.501 */
    const int32_t pitch_112 = pitch_108 < INT64_C(72057594037927936) /* 1/16 */;
    /* F60, |x| <= 0.0625 */
    const int64_t pitch_113 = clamp_64(pitch_108, INT64_C(0), INT64_C(72057594037927936));
    const int64_t pitch_114 = pitch_113 * INT64_C(1);  /* F56, |x| <= 1 */
    const int64_t pitch_115 = pitch_114 * INT64_C(16);  /* F60 */
    const int64_t pitch_116 = (pitch_112 != 0) ? pitch_115 : pitch_108;  /* F60, |x| <= 2.01 */
    const int32_t pitch_117 = pitch_111 * 1;  /* F33, |x| <= 0.126 */
    const int32_t pitch_118 = round_short_2(pitch_117);  /* F31 */
    const int32_t pitch_119 = (pitch_112 != 0) ? pitch_118 : pitch_111;  /* F31, |x| <= 0.501 */
    const int32_t pitch_120 = pitch_116 < INT64_C(288230376151711744) /* 1/4 */;
    /* F60, |x| <= 0.25 */
    const int64_t pitch_121 = clamp_64(pitch_116, INT64_C(0), INT64_C(288230376151711744));
    const int64_t pitch_122 = pitch_121 * INT64_C(1);  /* F58, |x| <= 1 */
    const int64_t pitch_123 = pitch_122 * INT64_C(4);  /* F60 */
    const int64_t pitch_124 = (pitch_120 != 0) ? pitch_123 : pitch_116;  /* F60, |x| <= 2.01 */
    const int32_t pitch_125 = pitch_119 * 1;  /* F32, |x| <= 0.251 */
    const int32_t pitch_126 = round_short_1(pitch_125);  /* F31 */
    const int32_t pitch_127 = (pitch_120 != 0) ? pitch_126 : pitch_119;  /* F31, |x| <= 0.501 */
    const int32_t pitch_128 = round_31(pitch_124);  /* F27, |x| <= 8.02 */
    const int32_t pitch_129 = clamp_32(pitch_128, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_130 = clamp_32(pitch_129, 134217728, 536870912);  /* F27, |x| <= 4 */
    const int32_t pitch_131 = -pitch_130;  /* F27 */
    const int64_t pitch_132 = (int64_t)747135655 /* 47816681919/17592186044416 */ * pitch_131;  /* F65 */
    /* F65 */
    const int64_t pitch_133 = INT64_C(1527667556037427200) /* 182112164025/4398046511104 */ + pitch_132;
    const int32_t pitch_134 = round_30(pitch_133);  /* F35, |x| <= 0.0387 */
    const int64_t pitch_135 = (int64_t)pitch_130 * pitch_134;  /* F62 */
    /* F62 */
    const int64_t pitch_136 = pitch_135 - INT64_C(1179613329067868160) /* 2249933870445/8796093022208 */;
    const int32_t pitch_137 = round_29(pitch_136);  /* F33, |x| <= 0.226 */
    const int64_t pitch_138 = (int64_t)pitch_130 * pitch_137;  /* F60 */
    /* F60 */
    const int64_t pitch_139 = INT64_C(951679935904743424) /* 1815185424623/2199023255552 */ + pitch_138;
    const int32_t pitch_140 = round_29(pitch_139);  /* F31, |x| <= 0.725 */
    const int64_t pitch_141 = (int64_t)pitch_130 * pitch_140;  /* F58 */
    /* F58 */
    const int64_t pitch_142 = pitch_141 - INT64_C(436656008213790720) /* 13325683844415/8796093022208 */;
    const int32_t pitch_143 = round_28(pitch_142);  /* F30, |x| <= 1.82 */
    const int64_t pitch_144 = (int64_t)pitch_130 * pitch_143;  /* F57 */
    /* F57 */
    const int64_t pitch_145 = INT64_C(274651154808430592) /* 33526752295951/17592186044416 */ + pitch_144;
    const int32_t pitch_146 = round_29(pitch_145);  /* F28, |x| <= 7.44 */
    const int32_t pitch_147 = clamp_32(pitch_146, 67108864, 335544320);  /* F28, |x| <= 1.25 */
    const int64_t pitch_148 = (int64_t)pitch_147 * pitch_147;  /* F56 */
    const int32_t pitch_149 = round_26(pitch_148);  /* F30, |x| <= 1.57 */
    const int64_t pitch_150 = (int64_t)pitch_131 * pitch_149;  /* F57 */
    const int64_t pitch_151 = INT64_C(144115188075855872) /* 1 */ + pitch_150;  /* F57 */
    const int32_t pitch_152 = round_29(pitch_151);  /* F28, |x| <= 5.26 */
    const int64_t pitch_153 = pitch_147 * INT64_C(536870912);  /* F57 */
    const int64_t pitch_154 = (int64_t)pitch_147 * pitch_152;  /* F56 */
    const int64_t pitch_155 = pitch_153 + pitch_154;  /* F57 */
    const int32_t pitch_156 = round_28(pitch_155);  /* F29, |x| <= 3.04 */
    const int32_t pitch_157 = clamp_32(pitch_156, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_158 = (int64_t)pitch_157 * pitch_157;  /* F58 */
    const int32_t pitch_159 = round_28(pitch_158);  /* F30, |x| <= 1.57 */
    const int64_t pitch_160 = (int64_t)pitch_131 * pitch_159;  /* F57 */
    const int64_t pitch_161 = INT64_C(144115188075855872) /* 1 */ + pitch_160;  /* F57 */
    const int32_t pitch_162 = round_29(pitch_161);  /* F28, |x| <= 5.26 */
    const int64_t pitch_163 = pitch_157 * INT64_C(536870912);  /* F58 */
    const int64_t pitch_164 = (int64_t)pitch_157 * pitch_162;  /* F57 */
    const int64_t pitch_165 = pitch_163 + pitch_164;  /* F58 */
    const int32_t pitch_166 = round_29(pitch_165);  /* F29, |x| <= 3.04 */
    const int32_t pitch_167 = clamp_32(pitch_166, 134217728, 671088640);  /* F29, |x| <= 1.25 */
    const int64_t pitch_168 = (int64_t)pitch_129 * pitch_167;  /* F56 */
    const int32_t pitch_169 = round_28(pitch_168);  /* F28, |x| <= 5.01 */
    const int64_t pitch_170 = (int64_t)pitch_169 * pitch_127;  /* F59 */
    const int32_t pitch_171 = round_30(pitch_170);  /* F29, |x| <= 2.51 */
    const int32_t pitch_172 = pitch_86 < 0;
    const int32_t pitch_173 = -pitch_86;  /* F29, |x| <= 2.51 */
    const int32_t pitch_174 = (pitch_172 != 0) ? pitch_173 : pitch_86;  /* F29, |x| <= 2.51 */
    const int32_t pitch_175 = pitch_171 < 0;
    const int32_t pitch_176 = -pitch_171;  /* F29, |x| <= 2.51 */
    const int32_t pitch_177 = (pitch_175 != 0) ? pitch_176 : pitch_171;  /* F29, |x| <= 2.51 */
    const int32_t pitch_178 = pitch_177 < pitch_174;
    const int32_t pitch_179 = (pitch_178 != 0) ? pitch_177 : pitch_174;  /* F29, |x| <= 2.51 */
    const int32_t pitch_180 = (pitch_178 != 0) ? pitch_174 : pitch_177;  /* F29, |x| <= 2.51 */
    const int64_t pitch_181 = (int64_t)889516847 /* 10355339/25000000 */ * pitch_180;  /* F60 */
    const int32_t pitch_182 = round_30(pitch_181);  /* F30, |x| <= 1.04 */
    const int64_t pitch_183 = pitch_182 * INT64_C(1);  /* F30 */
    const int64_t pitch_184 = pitch_179 * INT64_C(2);  /* F30 */
    const int32_t pitch_185 = pitch_183 < pitch_184;
    const int64_t pitch_186 = (int64_t)pitch_179 - pitch_180;  /* F29 */
    const int32_t pitch_187 = round_1(pitch_186);  /* F28, |x| <= 5.01 */
    const int32_t pitch_188 = round_short_1(pitch_179);  /* F28 */
    const int32_t pitch_189 = (pitch_185 != 0) ? pitch_187 : pitch_188;  /* F28, |x| <= 5.01 */
    const int64_t pitch_190 = (int64_t)pitch_179 + pitch_180;  /* F29 */
    const int32_t pitch_191 = round_1(pitch_190);  /* F28, |x| <= 5.01 */
    const int32_t pitch_192 = round_short_1(pitch_180);  /* F28 */
    const int32_t pitch_193 = (pitch_185 != 0) ? pitch_191 : pitch_192;  /* F28, |x| <= 5.01 */
    const int32_t pitch_194 = clamp_32(pitch_193, 2, 2147483647);  /* F28, |x| <= 5.01 */
    const int64_t pitch_195 = pitch_189 * INT64_C(4294967296);  /* F60 */
    const int64_t pitch_196 = pitch_195 / pitch_194;  /* F32, |x| <= 6.72e+08 */
    /* F32, |x| <= 0.415 */
    const int32_t pitch_197 = clamp_64_to_32(pitch_196, INT64_C(-1779404950), INT64_C(1779404950));
    const int64_t pitch_198 = (int64_t)pitch_197 * pitch_197;  /* F64 */
    const int32_t pitch_199 = round_31(pitch_198);  /* F33, |x| <= 0.172 */
    const int64_t pitch_200 = (int64_t)510875761 /* 382/6423 */ * pitch_199;  /* F66 */
    const int64_t pitch_201 = INT64_C(7773993415904670242) /* 1650/15661 */ - pitch_200;  /* F66 */
    const int32_t pitch_202 = round_34(pitch_201);  /* F32, |x| <= 0.106 */
    const int64_t pitch_203 = (int64_t)pitch_199 * pitch_202;  /* F65 */
    const int64_t pitch_204 = pitch_203 - INT64_C(5251586747234353517) /* 7339/51558 */;  /* F65 */
    const int32_t pitch_205 = round_33(pitch_204);  /* F32, |x| <= 0.143 */
    const int64_t pitch_206 = (int64_t)pitch_199 * pitch_205;  /* F65 */
    const int64_t pitch_207 = INT64_C(7377920055805538292) /* 58828/294171 */ + pitch_206;  /* F65 */
    const int32_t pitch_208 = round_34(pitch_207);  /* F31, |x| <= 0.2 */
    const int64_t pitch_209 = (int64_t)pitch_199 * pitch_208;  /* F64 */
    const int64_t pitch_210 = pitch_209 - INT64_C(6148909082171862706) /* 365415/1096246 */;  /* F64 */
    const int32_t pitch_211 = round_32(pitch_210);  /* F32, |x| <= 0.334 */
    const int64_t pitch_212 = (int64_t)pitch_199 * pitch_211;  /* F65 */
    const int32_t pitch_213 = round_30(pitch_212);  /* F35, |x| <= 0.0573 */
    const int64_t pitch_214 = (int64_t)pitch_197 * pitch_213;  /* F67 */
    const int32_t pitch_215 = round_35(pitch_214);  /* F32, |x| <= 0.0238 */
    const int32_t pitch_216 = pitch_197 + pitch_215;  /* F32, |x| <= 0.439 */
    const int64_t pitch_217 = INT64_C(3373259426) + pitch_216;  /* F32 */
    const int32_t pitch_218 = round_2(pitch_217);  /* F30, |x| <= 1.23 */
    const int32_t pitch_219 = round_short_2(pitch_216);  /* F30 */
    const int32_t pitch_220 = (pitch_185 != 0) ? pitch_218 : pitch_219;  /* F30, |x| <= 1.23 */
    const int64_t pitch_221 = INT64_C(1686629713) - pitch_220;  /* F30 */
    const int32_t pitch_222 = round_1(pitch_221);  /* F29, |x| <= 2.01 */
    const int32_t pitch_223 = round_short_1(pitch_220);  /* F29 */
    const int32_t pitch_224 = (pitch_178 != 0) ? pitch_222 : pitch_223;  /* F29, |x| <= 2.01 */
    const int64_t pitch_225 = INT64_C(1686629713) - pitch_224;  /* F29 */
    const int32_t pitch_226 = (int32_t)pitch_225;  /* F29, |x| <= 3.58 */
    const int32_t pitch_227 = (pitch_175 != 0) ? pitch_226 : pitch_224;  /* F29, |x| <= 3.58 */
    const int32_t pitch_228 = -pitch_227;  /* F29, |x| <= 3.58 */
    const int32_t pitch_229 = (pitch_172 != 0) ? pitch_228 : pitch_227;  /* F29, |x| <= 3.58 */
    const int64_t pitch_230 = pitch_229 - INT64_C(421657428);  /* F28 */
    const int32_t pitch_231 = round_1(pitch_230);  /* F27, |x| <= 8.73 */
    const int32_t pitch = clamp_32(pitch_231, -210829207, 210829207);  /* F27, |x| <= 1.58 */

    /* roll = half_sum - half_difference, in [-pi, pi] */
    const int64_t roll_1 = (int64_t)half_sum - half_difference;  /* F29 */
    const int32_t roll_3 = round_1(roll_1);  /* F28, |x| <= 7.16 */
    const int32_t roll_4 = 843314857 < roll_3;
    const int64_t roll_5 = roll_3 - INT64_C(1686629713);  /* F28 */
    const int32_t roll_6 = round_1(roll_5);  /* F27, |x| <= 13.5 */
    const int32_t roll_7 = round_short_1(roll_3);  /* F27 */
    const int32_t roll_8 = (roll_4 != 0) ? roll_6 : roll_7;  /* F27, |x| <= 13.5 */
    const int32_t roll_9 = clamp_32(roll_8, -843316828, 421658414);  /* F27, |x| <= 6.29 */
    const int32_t roll_10 = roll_9 < -421657428;
    const int32_t roll_11 = roll_9 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t roll_12 = (roll_10 != 0) ? roll_11 : roll_9;  /* F27, |x| <= 9.43 */
    const int32_t roll = clamp_32(roll_12, -421658414, 421658414);  /* F27, |x| <= 3.15 */

    /* yaw = half_sum + half_difference, in [-pi, pi] */
    const int64_t yaw_1 = (int64_t)half_sum + half_difference;  /* F29 */
    const int32_t yaw_3 = round_1(yaw_1);  /* F28, |x| <= 7.16 */
    const int32_t yaw_4 = 843314857 < yaw_3;
    const int64_t yaw_5 = yaw_3 - INT64_C(1686629713);  /* F28 */
    const int32_t yaw_6 = round_1(yaw_5);  /* F27, |x| <= 13.5 */
    const int32_t yaw_7 = round_short_1(yaw_3);  /* F27 */
    const int32_t yaw_8 = (yaw_4 != 0) ? yaw_6 : yaw_7;  /* F27, |x| <= 13.5 */
    const int32_t yaw_9 = clamp_32(yaw_8, -843316828, 421658414);  /* F27, |x| <= 6.29 */
    const int32_t yaw_10 = yaw_9 < -421657428;
    const int32_t yaw_11 = yaw_9 + INT64_C(843314857);  /* F27, |x| <= 9.43 */
    const int32_t yaw_12 = (yaw_10 != 0) ? yaw_11 : yaw_9;  /* F27, |x| <= 9.43 */
    const int32_t yaw = clamp_32(yaw_12, -421658414, 421658414);  /* F27, |x| <= 3.15 */

    const int32_t roll_2 = roll * 4;  /* F29, |x| <= 3.15 */
    rpy[0] = roll_2;
    const int32_t pitch_2 = pitch * 4;  /* F29, |x| <= 1.58 */
    rpy[1] = pitch_2;
    const int32_t yaw_2 = yaw * 4;  /* F29, |x| <= 3.15 */
    rpy[2] = yaw_2;
}
