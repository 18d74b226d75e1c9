/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_10_float32
 *
 * qcone 0.1.0, design quaternion_taylor_3_10_float32, SHA-256 of the design
 * 062d68ca72b58e2239e1625d43514f13b81ddbdcff571e2961951e3955e30bc5
 *
 * algorithm:   quaternion-taylor-3-10-start, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      xu2019 (5), (7), (8)
 * equation:    r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written      448       0  261       196       0       0     0     0     0       0
 * update shared          332      16  203       157       0       0     0     0     0       0
 * update emitted         332      16  203       157       0       0     0     0     0       0
 * dcm as-written           9       0    9         6       0       0     0     0     0       0
 * dcm shared               9       0    9         6       0       0     0     0     0       0
 * dcm emitted              9       0    9         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "quaternion_taylor_3_10_float32.h"

#if QUATERNION_TAYLOR_3_10_FLOAT32_VERSION != 1
#error "quaternion_taylor_3_10_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void quaternion_taylor_3_10_float32_init(quaternion_taylor_3_10_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
}

void quaternion_taylor_3_10_float32_set_quaternion(
    quaternion_taylor_3_10_float32_state *state, const float q_nb[4])
{
    /* q_nb, read once */
    const float q_nb_w = q_nb[0];
    const float q_nb_x = q_nb[1];
    const float q_nb_y = q_nb[2];
    const float q_nb_z = q_nb[3];

    /* q_square = |q|^2 */
    const float q_square_1 = q_nb_w * q_nb_w;
    const float q_square_2 = q_nb_x * q_nb_x;
    const float q_square_3 = q_square_1 + q_square_2;
    const float q_square_4 = q_nb_y * q_nb_y;
    const float q_square_5 = q_square_3 + q_square_4;
    const float q_square_6 = q_nb_z * q_nb_z;
    const float q_square = q_square_5 + q_square_6;

    /* e = (1 - |q|^2)/2 */
    const float e_1 = 1.0F - q_square;
    const float e = 0.5F * e_1;

    /* q_next = q + e q */
    const float q_next_w_1 = e * q_nb_w;
    const float q_next_x_1 = e * q_nb_x;
    const float q_next_y_1 = e * q_nb_y;
    const float q_next_z_1 = e * q_nb_z;
    const float q_next_w = q_nb_w + q_next_w_1;
    const float q_next_x = q_nb_x + q_next_x_1;
    const float q_next_y = q_nb_y + q_next_y_1;
    const float q_next_z = q_nb_z + q_next_z_1;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void quaternion_taylor_3_10_float32_update(
    quaternion_taylor_3_10_float32_state *state, const float dtheta[9])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float dtheta1_x = dtheta[0];
    const float dtheta1_y = dtheta[1];
    const float dtheta1_z = dtheta[2];
    const float dtheta2_x = dtheta[3];
    const float dtheta2_y = dtheta[4];
    const float dtheta2_z = dtheta[5];
    const float dtheta3_x = dtheta[6];
    const float dtheta3_y = dtheta[7];
    const float dtheta3_z = dtheta[8];

    /* f_k = forward differences of theta_1 .. theta_N */
    const float A0_z_1 = dtheta3_z - dtheta2_z;
    const float A0_y_1 = dtheta3_y - dtheta2_y;
    const float A0_x_1 = dtheta3_x - dtheta2_x;
    const float A0_z_2 = dtheta2_z - dtheta1_z;
    const float A0_y_2 = dtheta2_y - dtheta1_y;
    const float A0_x_2 = dtheta2_x - dtheta1_x;
    const float A0_z_3 = A0_z_1 - A0_z_2;
    const float A0_y_3 = A0_y_1 - A0_y_2;
    const float A0_x_3 = A0_x_1 - A0_x_2;

    /* A_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    const float A0_x_4 = 1.5F * dtheta1_x;
    const float A0_x_5 = 0.0F + A0_x_4;
    const float A0_x_6 = -0.75F * A0_x_2;
    const float A0_x_7 = A0_x_5 + A0_x_6;
    const float A0_x_8 = 0.5F * A0_x_3;
    const float A0_x = A0_x_7 + A0_x_8;
    const float A0_y_4 = 1.5F * dtheta1_y;
    const float A0_y_5 = 0.0F + A0_y_4;
    const float A0_y_6 = -0.75F * A0_y_2;
    const float A0_y_7 = A0_y_5 + A0_y_6;
    const float A0_y_8 = 0.5F * A0_y_3;
    const float A0_y = A0_y_7 + A0_y_8;
    const float A0_z_4 = 1.5F * dtheta1_z;
    const float A0_z_5 = 0.0F + A0_z_4;
    const float A0_z_6 = -0.75F * A0_z_2;
    const float A0_z_7 = A0_z_5 + A0_z_6;
    const float A0_z_8 = 0.5F * A0_z_3;
    const float A0_z = A0_z_7 + A0_z_8;
    const float A1_x_1 = 4.5F * A0_x_2;
    const float A1_x_2 = 0.0F + A1_x_1;
    const float A1_x_3 = -4.5F * A0_x_3;
    const float A1_x = A1_x_2 + A1_x_3;
    const float A1_y_1 = 4.5F * A0_y_2;
    const float A1_y_2 = 0.0F + A1_y_1;
    const float A1_y_3 = -4.5F * A0_y_3;
    const float A1_y = A1_y_2 + A1_y_3;
    const float A1_z_1 = 4.5F * A0_z_2;
    const float A1_z_2 = 0.0F + A1_z_1;
    const float A1_z_3 = -4.5F * A0_z_3;
    const float A1_z = A1_z_2 + A1_z_3;
    const float A2_x_1 = 6.75F * A0_x_3;
    const float A2_x = 0.0F + A2_x_1;
    const float A2_y_1 = 6.75F * A0_y_3;
    const float A2_y = 0.0F + A2_y_1;
    const float A2_z_1 = 6.75F * A0_z_3;
    const float A2_z = 0.0F + A2_z_1;

    /* r_2 = 1/2 sum_j r_(2-1-j) (x) A_j   [xu2019 (7)] */
    const float r2_w_1 = A0_x * A0_x;
    const float r2_w_2 = 0.0F - r2_w_1;
    const float r2_w_3 = A0_y * A0_y;
    const float r2_w_4 = r2_w_2 - r2_w_3;
    const float r2_w_5 = A0_z * A0_z;
    const float r2_w_6 = r2_w_4 - r2_w_5;
    const float r2_w = 0.5F * r2_w_6;
    const float u_1 = 0.0F + r2_w;
    const float r2_x = 0.5F * A1_x;
    const float v_x_1 = A0_x + r2_x;
    const float r2_y = 0.5F * A1_y;
    const float v_y_1 = A0_y + r2_y;
    const float r2_z = 0.5F * A1_z;
    const float v_z_1 = A0_z + r2_z;

    /* r_3 = 1/3 sum_j r_(3-1-j) (x) A_j   [xu2019 (7)] */
    const float r3_w_1 = r2_x * A0_x;
    const float r3_w_2 = 0.0F - r3_w_1;
    const float r3_x_1 = r2_w * A0_x;
    const float r3_x_2 = 0.0F + r3_x_1;
    const float r3_x_3 = r2_y * A0_z;
    const float r3_x_4 = r3_x_2 + r3_x_3;
    const float r3_x_5 = r2_z * A0_y;
    const float r3_x_6 = r3_x_4 - r3_x_5;
    const float r3_w_3 = r2_y * A0_y;
    const float r3_w_4 = r3_w_2 - r3_w_3;
    const float r3_y_1 = r2_w * A0_y;
    const float r3_y_2 = 0.0F + r3_y_1;
    const float r3_y_3 = r2_z * A0_x;
    const float r3_y_4 = r3_y_2 + r3_y_3;
    const float r3_y_5 = r2_x * A0_z;
    const float r3_y_6 = r3_y_4 - r3_y_5;
    const float r3_w_5 = r2_z * A0_z;
    const float r3_w_6 = r3_w_4 - r3_w_5;
    const float r3_z_1 = r2_w * A0_z;
    const float r3_z_2 = 0.0F + r3_z_1;
    const float r3_z_3 = r2_x * A0_y;
    const float r3_z_4 = r3_z_2 + r3_z_3;
    const float r3_z_5 = r2_y * A0_x;
    const float r3_z_6 = r3_z_4 - r3_z_5;
    const float r3_w_7 = A0_x * A1_x;
    const float r3_w_8 = r3_w_6 - r3_w_7;
    const float r3_x_7 = A0_y * A1_z;
    const float r3_x_8 = r3_x_6 + r3_x_7;
    const float r3_x_9 = A0_z * A1_y;
    const float r3_x_10 = r3_x_8 - r3_x_9;
    const float r3_w_9 = A0_y * A1_y;
    const float r3_w_10 = r3_w_8 - r3_w_9;
    const float r3_y_7 = A0_z * A1_x;
    const float r3_y_8 = r3_y_6 + r3_y_7;
    const float r3_y_9 = A0_x * A1_z;
    const float r3_y_10 = r3_y_8 - r3_y_9;
    const float r3_w_11 = A0_z * A1_z;
    const float r3_w_12 = r3_w_10 - r3_w_11;
    const float r3_z_7 = A0_x * A1_y;
    const float r3_z_8 = r3_z_6 + r3_z_7;
    const float r3_z_9 = A0_y * A1_x;
    const float r3_z_10 = r3_z_8 - r3_z_9;
    const float r3_x_11 = r3_x_10 + A2_x;
    const float r3_y_11 = r3_y_10 + A2_y;
    const float r3_z_11 = r3_z_10 + A2_z;
    const float r3_w = 0.33333334F /* 1/3 */ * r3_w_12;
    const float u_2 = u_1 + r3_w;
    const float r3_x = 0.33333334F /* 1/3 */ * r3_x_11;
    const float v_x_2 = v_x_1 + r3_x;
    const float r3_y = 0.33333334F /* 1/3 */ * r3_y_11;
    const float v_y_2 = v_y_1 + r3_y;
    const float r3_z = 0.33333334F /* 1/3 */ * r3_z_11;
    const float v_z_2 = v_z_1 + r3_z;

    /* r_4 = 1/4 sum_j r_(4-1-j) (x) A_j   [xu2019 (7)] */
    const float r4_w_1 = r3_x * A0_x;
    const float r4_w_2 = 0.0F - r4_w_1;
    const float r4_x_1 = r3_w * A0_x;
    const float r4_x_2 = 0.0F + r4_x_1;
    const float r4_x_3 = r3_y * A0_z;
    const float r4_x_4 = r4_x_2 + r4_x_3;
    const float r4_x_5 = r3_z * A0_y;
    const float r4_x_6 = r4_x_4 - r4_x_5;
    const float r4_w_3 = r3_y * A0_y;
    const float r4_w_4 = r4_w_2 - r4_w_3;
    const float r4_y_1 = r3_w * A0_y;
    const float r4_y_2 = 0.0F + r4_y_1;
    const float r4_y_3 = r3_z * A0_x;
    const float r4_y_4 = r4_y_2 + r4_y_3;
    const float r4_y_5 = r3_x * A0_z;
    const float r4_y_6 = r4_y_4 - r4_y_5;
    const float r4_w_5 = r3_z * A0_z;
    const float r4_w_6 = r4_w_4 - r4_w_5;
    const float r4_z_1 = r3_w * A0_z;
    const float r4_z_2 = 0.0F + r4_z_1;
    const float r4_z_3 = r3_x * A0_y;
    const float r4_z_4 = r4_z_2 + r4_z_3;
    const float r4_z_5 = r3_y * A0_x;
    const float r4_z_6 = r4_z_4 - r4_z_5;
    const float r4_w_7 = r2_x * A1_x;
    const float r4_w_8 = r4_w_6 - r4_w_7;
    const float r4_x_7 = r2_w * A1_x;
    const float r4_x_8 = r4_x_6 + r4_x_7;
    const float r4_x_9 = r2_y * A1_z;
    const float r4_x_10 = r4_x_8 + r4_x_9;
    const float r4_x_11 = r2_z * A1_y;
    const float r4_x_12 = r4_x_10 - r4_x_11;
    const float r4_w_9 = r2_y * A1_y;
    const float r4_w_10 = r4_w_8 - r4_w_9;
    const float r4_y_7 = r2_w * A1_y;
    const float r4_y_8 = r4_y_6 + r4_y_7;
    const float r4_y_9 = r2_z * A1_x;
    const float r4_y_10 = r4_y_8 + r4_y_9;
    const float r4_y_11 = r2_x * A1_z;
    const float r4_y_12 = r4_y_10 - r4_y_11;
    const float r4_w_11 = r2_z * A1_z;
    const float r4_w_12 = r4_w_10 - r4_w_11;
    const float r4_z_7 = r2_w * A1_z;
    const float r4_z_8 = r4_z_6 + r4_z_7;
    const float r4_z_9 = r2_x * A1_y;
    const float r4_z_10 = r4_z_8 + r4_z_9;
    const float r4_z_11 = r2_y * A1_x;
    const float r4_z_12 = r4_z_10 - r4_z_11;
    const float r4_w_13 = A0_x * A2_x;
    const float r4_w_14 = r4_w_12 - r4_w_13;
    const float r4_x_13 = A0_y * A2_z;
    const float r4_x_14 = r4_x_12 + r4_x_13;
    const float r4_x_15 = A0_z * A2_y;
    const float r4_x_16 = r4_x_14 - r4_x_15;
    const float r4_w_15 = A0_y * A2_y;
    const float r4_w_16 = r4_w_14 - r4_w_15;
    const float r4_y_13 = A0_z * A2_x;
    const float r4_y_14 = r4_y_12 + r4_y_13;
    const float r4_y_15 = A0_x * A2_z;
    const float r4_y_16 = r4_y_14 - r4_y_15;
    const float r4_w_17 = A0_z * A2_z;
    const float r4_w_18 = r4_w_16 - r4_w_17;
    const float r4_z_13 = A0_x * A2_y;
    const float r4_z_14 = r4_z_12 + r4_z_13;
    const float r4_z_15 = A0_y * A2_x;
    const float r4_z_16 = r4_z_14 - r4_z_15;
    const float r4_w = 0.25F * r4_w_18;
    const float u_3 = u_2 + r4_w;
    const float r4_x = 0.25F * r4_x_16;
    const float v_x_3 = v_x_2 + r4_x;
    const float r4_y = 0.25F * r4_y_16;
    const float v_y_3 = v_y_2 + r4_y;
    const float r4_z = 0.25F * r4_z_16;
    const float v_z_3 = v_z_2 + r4_z;

    /* r_5 = 1/5 sum_j r_(5-1-j) (x) A_j   [xu2019 (7)] */
    const float r5_w_1 = r4_x * A0_x;
    const float r5_w_2 = 0.0F - r5_w_1;
    const float r5_x_1 = r4_w * A0_x;
    const float r5_x_2 = 0.0F + r5_x_1;
    const float r5_x_3 = r4_y * A0_z;
    const float r5_x_4 = r5_x_2 + r5_x_3;
    const float r5_x_5 = r4_z * A0_y;
    const float r5_x_6 = r5_x_4 - r5_x_5;
    const float r5_w_3 = r4_y * A0_y;
    const float r5_w_4 = r5_w_2 - r5_w_3;
    const float r5_y_1 = r4_w * A0_y;
    const float r5_y_2 = 0.0F + r5_y_1;
    const float r5_y_3 = r4_z * A0_x;
    const float r5_y_4 = r5_y_2 + r5_y_3;
    const float r5_y_5 = r4_x * A0_z;
    const float r5_y_6 = r5_y_4 - r5_y_5;
    const float r5_w_5 = r4_z * A0_z;
    const float r5_w_6 = r5_w_4 - r5_w_5;
    const float r5_z_1 = r4_w * A0_z;
    const float r5_z_2 = 0.0F + r5_z_1;
    const float r5_z_3 = r4_x * A0_y;
    const float r5_z_4 = r5_z_2 + r5_z_3;
    const float r5_z_5 = r4_y * A0_x;
    const float r5_z_6 = r5_z_4 - r5_z_5;
    const float r5_w_7 = r3_x * A1_x;
    const float r5_w_8 = r5_w_6 - r5_w_7;
    const float r5_x_7 = r3_w * A1_x;
    const float r5_x_8 = r5_x_6 + r5_x_7;
    const float r5_x_9 = r3_y * A1_z;
    const float r5_x_10 = r5_x_8 + r5_x_9;
    const float r5_x_11 = r3_z * A1_y;
    const float r5_x_12 = r5_x_10 - r5_x_11;
    const float r5_w_9 = r3_y * A1_y;
    const float r5_w_10 = r5_w_8 - r5_w_9;
    const float r5_y_7 = r3_w * A1_y;
    const float r5_y_8 = r5_y_6 + r5_y_7;
    const float r5_y_9 = r3_z * A1_x;
    const float r5_y_10 = r5_y_8 + r5_y_9;
    const float r5_y_11 = r3_x * A1_z;
    const float r5_y_12 = r5_y_10 - r5_y_11;
    const float r5_w_11 = r3_z * A1_z;
    const float r5_w_12 = r5_w_10 - r5_w_11;
    const float r5_z_7 = r3_w * A1_z;
    const float r5_z_8 = r5_z_6 + r5_z_7;
    const float r5_z_9 = r3_x * A1_y;
    const float r5_z_10 = r5_z_8 + r5_z_9;
    const float r5_z_11 = r3_y * A1_x;
    const float r5_z_12 = r5_z_10 - r5_z_11;
    const float r5_w_13 = r2_x * A2_x;
    const float r5_w_14 = r5_w_12 - r5_w_13;
    const float r5_x_13 = r2_w * A2_x;
    const float r5_x_14 = r5_x_12 + r5_x_13;
    const float r5_x_15 = r2_y * A2_z;
    const float r5_x_16 = r5_x_14 + r5_x_15;
    const float r5_x_17 = r2_z * A2_y;
    const float r5_x_18 = r5_x_16 - r5_x_17;
    const float r5_w_15 = r2_y * A2_y;
    const float r5_w_16 = r5_w_14 - r5_w_15;
    const float r5_y_13 = r2_w * A2_y;
    const float r5_y_14 = r5_y_12 + r5_y_13;
    const float r5_y_15 = r2_z * A2_x;
    const float r5_y_16 = r5_y_14 + r5_y_15;
    const float r5_y_17 = r2_x * A2_z;
    const float r5_y_18 = r5_y_16 - r5_y_17;
    const float r5_w_17 = r2_z * A2_z;
    const float r5_w_18 = r5_w_16 - r5_w_17;
    const float r5_z_13 = r2_w * A2_z;
    const float r5_z_14 = r5_z_12 + r5_z_13;
    const float r5_z_15 = r2_x * A2_y;
    const float r5_z_16 = r5_z_14 + r5_z_15;
    const float r5_z_17 = r2_y * A2_x;
    const float r5_z_18 = r5_z_16 - r5_z_17;
    const float r5_w = 0.2F /* 1/5 */ * r5_w_18;
    const float u_4 = u_3 + r5_w;
    const float r5_x = 0.2F /* 1/5 */ * r5_x_18;
    const float v_x_4 = v_x_3 + r5_x;
    const float r5_y = 0.2F /* 1/5 */ * r5_y_18;
    const float v_y_4 = v_y_3 + r5_y;
    const float r5_z = 0.2F /* 1/5 */ * r5_z_18;
    const float v_z_4 = v_z_3 + r5_z;

    /* r_6 = 1/6 sum_j r_(6-1-j) (x) A_j   [xu2019 (7)] */
    const float r6_w_1 = r5_x * A0_x;
    const float r6_w_2 = 0.0F - r6_w_1;
    const float r6_x_1 = r5_w * A0_x;
    const float r6_x_2 = 0.0F + r6_x_1;
    const float r6_x_3 = r5_y * A0_z;
    const float r6_x_4 = r6_x_2 + r6_x_3;
    const float r6_x_5 = r5_z * A0_y;
    const float r6_x_6 = r6_x_4 - r6_x_5;
    const float r6_w_3 = r5_y * A0_y;
    const float r6_w_4 = r6_w_2 - r6_w_3;
    const float r6_y_1 = r5_w * A0_y;
    const float r6_y_2 = 0.0F + r6_y_1;
    const float r6_y_3 = r5_z * A0_x;
    const float r6_y_4 = r6_y_2 + r6_y_3;
    const float r6_y_5 = r5_x * A0_z;
    const float r6_y_6 = r6_y_4 - r6_y_5;
    const float r6_w_5 = r5_z * A0_z;
    const float r6_w_6 = r6_w_4 - r6_w_5;
    const float r6_z_1 = r5_w * A0_z;
    const float r6_z_2 = 0.0F + r6_z_1;
    const float r6_z_3 = r5_x * A0_y;
    const float r6_z_4 = r6_z_2 + r6_z_3;
    const float r6_z_5 = r5_y * A0_x;
    const float r6_z_6 = r6_z_4 - r6_z_5;
    const float r6_w_7 = r4_x * A1_x;
    const float r6_w_8 = r6_w_6 - r6_w_7;
    const float r6_x_7 = r4_w * A1_x;
    const float r6_x_8 = r6_x_6 + r6_x_7;
    const float r6_x_9 = r4_y * A1_z;
    const float r6_x_10 = r6_x_8 + r6_x_9;
    const float r6_x_11 = r4_z * A1_y;
    const float r6_x_12 = r6_x_10 - r6_x_11;
    const float r6_w_9 = r4_y * A1_y;
    const float r6_w_10 = r6_w_8 - r6_w_9;
    const float r6_y_7 = r4_w * A1_y;
    const float r6_y_8 = r6_y_6 + r6_y_7;
    const float r6_y_9 = r4_z * A1_x;
    const float r6_y_10 = r6_y_8 + r6_y_9;
    const float r6_y_11 = r4_x * A1_z;
    const float r6_y_12 = r6_y_10 - r6_y_11;
    const float r6_w_11 = r4_z * A1_z;
    const float r6_w_12 = r6_w_10 - r6_w_11;
    const float r6_z_7 = r4_w * A1_z;
    const float r6_z_8 = r6_z_6 + r6_z_7;
    const float r6_z_9 = r4_x * A1_y;
    const float r6_z_10 = r6_z_8 + r6_z_9;
    const float r6_z_11 = r4_y * A1_x;
    const float r6_z_12 = r6_z_10 - r6_z_11;
    const float r6_w_13 = r3_x * A2_x;
    const float r6_w_14 = r6_w_12 - r6_w_13;
    const float r6_x_13 = r3_w * A2_x;
    const float r6_x_14 = r6_x_12 + r6_x_13;
    const float r6_x_15 = r3_y * A2_z;
    const float r6_x_16 = r6_x_14 + r6_x_15;
    const float r6_x_17 = r3_z * A2_y;
    const float r6_x_18 = r6_x_16 - r6_x_17;
    const float r6_w_15 = r3_y * A2_y;
    const float r6_w_16 = r6_w_14 - r6_w_15;
    const float r6_y_13 = r3_w * A2_y;
    const float r6_y_14 = r6_y_12 + r6_y_13;
    const float r6_y_15 = r3_z * A2_x;
    const float r6_y_16 = r6_y_14 + r6_y_15;
    const float r6_y_17 = r3_x * A2_z;
    const float r6_y_18 = r6_y_16 - r6_y_17;
    const float r6_w_17 = r3_z * A2_z;
    const float r6_w_18 = r6_w_16 - r6_w_17;
    const float r6_z_13 = r3_w * A2_z;
    const float r6_z_14 = r6_z_12 + r6_z_13;
    const float r6_z_15 = r3_x * A2_y;
    const float r6_z_16 = r6_z_14 + r6_z_15;
    const float r6_z_17 = r3_y * A2_x;
    const float r6_z_18 = r6_z_16 - r6_z_17;
    const float r6_w = 0.16666667F /* 1/6 */ * r6_w_18;
    const float u_5 = u_4 + r6_w;
    const float r6_x = 0.16666667F /* 1/6 */ * r6_x_18;
    const float v_x_5 = v_x_4 + r6_x;
    const float r6_y = 0.16666667F /* 1/6 */ * r6_y_18;
    const float v_y_5 = v_y_4 + r6_y;
    const float r6_z = 0.16666667F /* 1/6 */ * r6_z_18;
    const float v_z_5 = v_z_4 + r6_z;

    /* r_7 = 1/7 sum_j r_(7-1-j) (x) A_j   [xu2019 (7)] */
    const float r7_w_1 = r6_x * A0_x;
    const float r7_w_2 = 0.0F - r7_w_1;
    const float r7_x_1 = r6_w * A0_x;
    const float r7_x_2 = 0.0F + r7_x_1;
    const float r7_x_3 = r6_y * A0_z;
    const float r7_x_4 = r7_x_2 + r7_x_3;
    const float r7_x_5 = r6_z * A0_y;
    const float r7_x_6 = r7_x_4 - r7_x_5;
    const float r7_w_3 = r6_y * A0_y;
    const float r7_w_4 = r7_w_2 - r7_w_3;
    const float r7_y_1 = r6_w * A0_y;
    const float r7_y_2 = 0.0F + r7_y_1;
    const float r7_y_3 = r6_z * A0_x;
    const float r7_y_4 = r7_y_2 + r7_y_3;
    const float r7_y_5 = r6_x * A0_z;
    const float r7_y_6 = r7_y_4 - r7_y_5;
    const float r7_w_5 = r6_z * A0_z;
    const float r7_w_6 = r7_w_4 - r7_w_5;
    const float r7_z_1 = r6_w * A0_z;
    const float r7_z_2 = 0.0F + r7_z_1;
    const float r7_z_3 = r6_x * A0_y;
    const float r7_z_4 = r7_z_2 + r7_z_3;
    const float r7_z_5 = r6_y * A0_x;
    const float r7_z_6 = r7_z_4 - r7_z_5;
    const float r7_w_7 = r5_x * A1_x;
    const float r7_w_8 = r7_w_6 - r7_w_7;
    const float r7_x_7 = r5_w * A1_x;
    const float r7_x_8 = r7_x_6 + r7_x_7;
    const float r7_x_9 = r5_y * A1_z;
    const float r7_x_10 = r7_x_8 + r7_x_9;
    const float r7_x_11 = r5_z * A1_y;
    const float r7_x_12 = r7_x_10 - r7_x_11;
    const float r7_w_9 = r5_y * A1_y;
    const float r7_w_10 = r7_w_8 - r7_w_9;
    const float r7_y_7 = r5_w * A1_y;
    const float r7_y_8 = r7_y_6 + r7_y_7;
    const float r7_y_9 = r5_z * A1_x;
    const float r7_y_10 = r7_y_8 + r7_y_9;
    const float r7_y_11 = r5_x * A1_z;
    const float r7_y_12 = r7_y_10 - r7_y_11;
    const float r7_w_11 = r5_z * A1_z;
    const float r7_w_12 = r7_w_10 - r7_w_11;
    const float r7_z_7 = r5_w * A1_z;
    const float r7_z_8 = r7_z_6 + r7_z_7;
    const float r7_z_9 = r5_x * A1_y;
    const float r7_z_10 = r7_z_8 + r7_z_9;
    const float r7_z_11 = r5_y * A1_x;
    const float r7_z_12 = r7_z_10 - r7_z_11;
    const float r7_w_13 = r4_x * A2_x;
    const float r7_w_14 = r7_w_12 - r7_w_13;
    const float r7_x_13 = r4_w * A2_x;
    const float r7_x_14 = r7_x_12 + r7_x_13;
    const float r7_x_15 = r4_y * A2_z;
    const float r7_x_16 = r7_x_14 + r7_x_15;
    const float r7_x_17 = r4_z * A2_y;
    const float r7_x_18 = r7_x_16 - r7_x_17;
    const float r7_w_15 = r4_y * A2_y;
    const float r7_w_16 = r7_w_14 - r7_w_15;
    const float r7_y_13 = r4_w * A2_y;
    const float r7_y_14 = r7_y_12 + r7_y_13;
    const float r7_y_15 = r4_z * A2_x;
    const float r7_y_16 = r7_y_14 + r7_y_15;
    const float r7_y_17 = r4_x * A2_z;
    const float r7_y_18 = r7_y_16 - r7_y_17;
    const float r7_w_17 = r4_z * A2_z;
    const float r7_w_18 = r7_w_16 - r7_w_17;
    const float r7_z_13 = r4_w * A2_z;
    const float r7_z_14 = r7_z_12 + r7_z_13;
    const float r7_z_15 = r4_x * A2_y;
    const float r7_z_16 = r7_z_14 + r7_z_15;
    const float r7_z_17 = r4_y * A2_x;
    const float r7_z_18 = r7_z_16 - r7_z_17;
    const float r7_w = 0.14285715F /* 1/7 */ * r7_w_18;
    const float u_6 = u_5 + r7_w;
    const float r7_x = 0.14285715F /* 1/7 */ * r7_x_18;
    const float v_x_6 = v_x_5 + r7_x;
    const float r7_y = 0.14285715F /* 1/7 */ * r7_y_18;
    const float v_y_6 = v_y_5 + r7_y;
    const float r7_z = 0.14285715F /* 1/7 */ * r7_z_18;
    const float v_z_6 = v_z_5 + r7_z;

    /* r_8 = 1/8 sum_j r_(8-1-j) (x) A_j   [xu2019 (7)] */
    const float r8_w_1 = r7_x * A0_x;
    const float r8_w_2 = 0.0F - r8_w_1;
    const float r8_x_1 = r7_w * A0_x;
    const float r8_x_2 = 0.0F + r8_x_1;
    const float r8_x_3 = r7_y * A0_z;
    const float r8_x_4 = r8_x_2 + r8_x_3;
    const float r8_x_5 = r7_z * A0_y;
    const float r8_x_6 = r8_x_4 - r8_x_5;
    const float r8_w_3 = r7_y * A0_y;
    const float r8_w_4 = r8_w_2 - r8_w_3;
    const float r8_y_1 = r7_w * A0_y;
    const float r8_y_2 = 0.0F + r8_y_1;
    const float r8_y_3 = r7_z * A0_x;
    const float r8_y_4 = r8_y_2 + r8_y_3;
    const float r8_y_5 = r7_x * A0_z;
    const float r8_y_6 = r8_y_4 - r8_y_5;
    const float r8_w_5 = r7_z * A0_z;
    const float r8_w_6 = r8_w_4 - r8_w_5;
    const float r8_z_1 = r7_w * A0_z;
    const float r8_z_2 = 0.0F + r8_z_1;
    const float r8_z_3 = r7_x * A0_y;
    const float r8_z_4 = r8_z_2 + r8_z_3;
    const float r8_z_5 = r7_y * A0_x;
    const float r8_z_6 = r8_z_4 - r8_z_5;
    const float r8_w_7 = r6_x * A1_x;
    const float r8_w_8 = r8_w_6 - r8_w_7;
    const float r8_x_7 = r6_w * A1_x;
    const float r8_x_8 = r8_x_6 + r8_x_7;
    const float r8_x_9 = r6_y * A1_z;
    const float r8_x_10 = r8_x_8 + r8_x_9;
    const float r8_x_11 = r6_z * A1_y;
    const float r8_x_12 = r8_x_10 - r8_x_11;
    const float r8_w_9 = r6_y * A1_y;
    const float r8_w_10 = r8_w_8 - r8_w_9;
    const float r8_y_7 = r6_w * A1_y;
    const float r8_y_8 = r8_y_6 + r8_y_7;
    const float r8_y_9 = r6_z * A1_x;
    const float r8_y_10 = r8_y_8 + r8_y_9;
    const float r8_y_11 = r6_x * A1_z;
    const float r8_y_12 = r8_y_10 - r8_y_11;
    const float r8_w_11 = r6_z * A1_z;
    const float r8_w_12 = r8_w_10 - r8_w_11;
    const float r8_z_7 = r6_w * A1_z;
    const float r8_z_8 = r8_z_6 + r8_z_7;
    const float r8_z_9 = r6_x * A1_y;
    const float r8_z_10 = r8_z_8 + r8_z_9;
    const float r8_z_11 = r6_y * A1_x;
    const float r8_z_12 = r8_z_10 - r8_z_11;
    const float r8_w_13 = r5_x * A2_x;
    const float r8_w_14 = r8_w_12 - r8_w_13;
    const float r8_x_13 = r5_w * A2_x;
    const float r8_x_14 = r8_x_12 + r8_x_13;
    const float r8_x_15 = r5_y * A2_z;
    const float r8_x_16 = r8_x_14 + r8_x_15;
    const float r8_x_17 = r5_z * A2_y;
    const float r8_x_18 = r8_x_16 - r8_x_17;
    const float r8_w_15 = r5_y * A2_y;
    const float r8_w_16 = r8_w_14 - r8_w_15;
    const float r8_y_13 = r5_w * A2_y;
    const float r8_y_14 = r8_y_12 + r8_y_13;
    const float r8_y_15 = r5_z * A2_x;
    const float r8_y_16 = r8_y_14 + r8_y_15;
    const float r8_y_17 = r5_x * A2_z;
    const float r8_y_18 = r8_y_16 - r8_y_17;
    const float r8_w_17 = r5_z * A2_z;
    const float r8_w_18 = r8_w_16 - r8_w_17;
    const float r8_z_13 = r5_w * A2_z;
    const float r8_z_14 = r8_z_12 + r8_z_13;
    const float r8_z_15 = r5_x * A2_y;
    const float r8_z_16 = r8_z_14 + r8_z_15;
    const float r8_z_17 = r5_y * A2_x;
    const float r8_z_18 = r8_z_16 - r8_z_17;
    const float r8_w = 0.125F * r8_w_18;
    const float u_7 = u_6 + r8_w;
    const float r8_x = 0.125F * r8_x_18;
    const float v_x_7 = v_x_6 + r8_x;
    const float r8_y = 0.125F * r8_y_18;
    const float v_y_7 = v_y_6 + r8_y;
    const float r8_z = 0.125F * r8_z_18;
    const float v_z_7 = v_z_6 + r8_z;

    /* r_9 = 1/9 sum_j r_(9-1-j) (x) A_j   [xu2019 (7)] */
    const float r9_w_1 = r8_x * A0_x;
    const float r9_w_2 = 0.0F - r9_w_1;
    const float r9_x_1 = r8_w * A0_x;
    const float r9_x_2 = 0.0F + r9_x_1;
    const float r9_x_3 = r8_y * A0_z;
    const float r9_x_4 = r9_x_2 + r9_x_3;
    const float r9_x_5 = r8_z * A0_y;
    const float r9_x_6 = r9_x_4 - r9_x_5;
    const float r9_w_3 = r8_y * A0_y;
    const float r9_w_4 = r9_w_2 - r9_w_3;
    const float r9_y_1 = r8_w * A0_y;
    const float r9_y_2 = 0.0F + r9_y_1;
    const float r9_y_3 = r8_z * A0_x;
    const float r9_y_4 = r9_y_2 + r9_y_3;
    const float r9_y_5 = r8_x * A0_z;
    const float r9_y_6 = r9_y_4 - r9_y_5;
    const float r9_w_5 = r8_z * A0_z;
    const float r9_w_6 = r9_w_4 - r9_w_5;
    const float r9_z_1 = r8_w * A0_z;
    const float r9_z_2 = 0.0F + r9_z_1;
    const float r9_z_3 = r8_x * A0_y;
    const float r9_z_4 = r9_z_2 + r9_z_3;
    const float r9_z_5 = r8_y * A0_x;
    const float r9_z_6 = r9_z_4 - r9_z_5;
    const float r9_w_7 = r7_x * A1_x;
    const float r9_w_8 = r9_w_6 - r9_w_7;
    const float r9_x_7 = r7_w * A1_x;
    const float r9_x_8 = r9_x_6 + r9_x_7;
    const float r9_x_9 = r7_y * A1_z;
    const float r9_x_10 = r9_x_8 + r9_x_9;
    const float r9_x_11 = r7_z * A1_y;
    const float r9_x_12 = r9_x_10 - r9_x_11;
    const float r9_w_9 = r7_y * A1_y;
    const float r9_w_10 = r9_w_8 - r9_w_9;
    const float r9_y_7 = r7_w * A1_y;
    const float r9_y_8 = r9_y_6 + r9_y_7;
    const float r9_y_9 = r7_z * A1_x;
    const float r9_y_10 = r9_y_8 + r9_y_9;
    const float r9_y_11 = r7_x * A1_z;
    const float r9_y_12 = r9_y_10 - r9_y_11;
    const float r9_w_11 = r7_z * A1_z;
    const float r9_w_12 = r9_w_10 - r9_w_11;
    const float r9_z_7 = r7_w * A1_z;
    const float r9_z_8 = r9_z_6 + r9_z_7;
    const float r9_z_9 = r7_x * A1_y;
    const float r9_z_10 = r9_z_8 + r9_z_9;
    const float r9_z_11 = r7_y * A1_x;
    const float r9_z_12 = r9_z_10 - r9_z_11;
    const float r9_w_13 = r6_x * A2_x;
    const float r9_w_14 = r9_w_12 - r9_w_13;
    const float r9_x_13 = r6_w * A2_x;
    const float r9_x_14 = r9_x_12 + r9_x_13;
    const float r9_x_15 = r6_y * A2_z;
    const float r9_x_16 = r9_x_14 + r9_x_15;
    const float r9_x_17 = r6_z * A2_y;
    const float r9_x_18 = r9_x_16 - r9_x_17;
    const float r9_w_15 = r6_y * A2_y;
    const float r9_w_16 = r9_w_14 - r9_w_15;
    const float r9_y_13 = r6_w * A2_y;
    const float r9_y_14 = r9_y_12 + r9_y_13;
    const float r9_y_15 = r6_z * A2_x;
    const float r9_y_16 = r9_y_14 + r9_y_15;
    const float r9_y_17 = r6_x * A2_z;
    const float r9_y_18 = r9_y_16 - r9_y_17;
    const float r9_w_17 = r6_z * A2_z;
    const float r9_w_18 = r9_w_16 - r9_w_17;
    const float r9_z_13 = r6_w * A2_z;
    const float r9_z_14 = r9_z_12 + r9_z_13;
    const float r9_z_15 = r6_x * A2_y;
    const float r9_z_16 = r9_z_14 + r9_z_15;
    const float r9_z_17 = r6_y * A2_x;
    const float r9_z_18 = r9_z_16 - r9_z_17;
    const float r9_w = 0.11111111F /* 1/9 */ * r9_w_18;
    const float u_8 = u_7 + r9_w;
    const float r9_x = 0.11111111F /* 1/9 */ * r9_x_18;
    const float v_x_8 = v_x_7 + r9_x;
    const float r9_y = 0.11111111F /* 1/9 */ * r9_y_18;
    const float v_y_8 = v_y_7 + r9_y;
    const float r9_z = 0.11111111F /* 1/9 */ * r9_z_18;
    const float v_z_8 = v_z_7 + r9_z;

    /* r_10 = 1/10 sum_j r_(10-1-j) (x) A_j   [xu2019 (7)] */
    const float r10_w_1 = r9_x * A0_x;
    const float r10_w_2 = 0.0F - r10_w_1;
    const float r10_x_1 = r9_w * A0_x;
    const float r10_x_2 = 0.0F + r10_x_1;
    const float r10_x_3 = r9_y * A0_z;
    const float r10_x_4 = r10_x_2 + r10_x_3;
    const float r10_x_5 = r9_z * A0_y;
    const float r10_x_6 = r10_x_4 - r10_x_5;
    const float r10_w_3 = r9_y * A0_y;
    const float r10_w_4 = r10_w_2 - r10_w_3;
    const float r10_y_1 = r9_w * A0_y;
    const float r10_y_2 = 0.0F + r10_y_1;
    const float r10_y_3 = r9_z * A0_x;
    const float r10_y_4 = r10_y_2 + r10_y_3;
    const float r10_y_5 = r9_x * A0_z;
    const float r10_y_6 = r10_y_4 - r10_y_5;
    const float r10_w_5 = r9_z * A0_z;
    const float r10_w_6 = r10_w_4 - r10_w_5;
    const float r10_z_1 = r9_w * A0_z;
    const float r10_z_2 = 0.0F + r10_z_1;
    const float r10_z_3 = r9_x * A0_y;
    const float r10_z_4 = r10_z_2 + r10_z_3;
    const float r10_z_5 = r9_y * A0_x;
    const float r10_z_6 = r10_z_4 - r10_z_5;
    const float r10_w_7 = r8_x * A1_x;
    const float r10_w_8 = r10_w_6 - r10_w_7;
    const float r10_x_7 = r8_w * A1_x;
    const float r10_x_8 = r10_x_6 + r10_x_7;
    const float r10_x_9 = r8_y * A1_z;
    const float r10_x_10 = r10_x_8 + r10_x_9;
    const float r10_x_11 = r8_z * A1_y;
    const float r10_x_12 = r10_x_10 - r10_x_11;
    const float r10_w_9 = r8_y * A1_y;
    const float r10_w_10 = r10_w_8 - r10_w_9;
    const float r10_y_7 = r8_w * A1_y;
    const float r10_y_8 = r10_y_6 + r10_y_7;
    const float r10_y_9 = r8_z * A1_x;
    const float r10_y_10 = r10_y_8 + r10_y_9;
    const float r10_y_11 = r8_x * A1_z;
    const float r10_y_12 = r10_y_10 - r10_y_11;
    const float r10_w_11 = r8_z * A1_z;
    const float r10_w_12 = r10_w_10 - r10_w_11;
    const float r10_z_7 = r8_w * A1_z;
    const float r10_z_8 = r10_z_6 + r10_z_7;
    const float r10_z_9 = r8_x * A1_y;
    const float r10_z_10 = r10_z_8 + r10_z_9;
    const float r10_z_11 = r8_y * A1_x;
    const float r10_z_12 = r10_z_10 - r10_z_11;
    const float r10_w_13 = r7_x * A2_x;
    const float r10_w_14 = r10_w_12 - r10_w_13;
    const float r10_x_13 = r7_w * A2_x;
    const float r10_x_14 = r10_x_12 + r10_x_13;
    const float r10_x_15 = r7_y * A2_z;
    const float r10_x_16 = r10_x_14 + r10_x_15;
    const float r10_x_17 = r7_z * A2_y;
    const float r10_x_18 = r10_x_16 - r10_x_17;
    const float r10_w_15 = r7_y * A2_y;
    const float r10_w_16 = r10_w_14 - r10_w_15;
    const float r10_y_13 = r7_w * A2_y;
    const float r10_y_14 = r10_y_12 + r10_y_13;
    const float r10_y_15 = r7_z * A2_x;
    const float r10_y_16 = r10_y_14 + r10_y_15;
    const float r10_y_17 = r7_x * A2_z;
    const float r10_y_18 = r10_y_16 - r10_y_17;
    const float r10_w_17 = r7_z * A2_z;
    const float r10_w_18 = r10_w_16 - r10_w_17;
    const float r10_z_13 = r7_w * A2_z;
    const float r10_z_14 = r10_z_12 + r10_z_13;
    const float r10_z_15 = r7_x * A2_y;
    const float r10_z_16 = r10_z_14 + r10_z_15;
    const float r10_z_17 = r7_y * A2_x;
    const float r10_z_18 = r10_z_16 - r10_z_17;
    const float r10_w = 0.1F /* 1/10 */ * r10_w_18;
    const float u = u_8 + r10_w;
    const float r10_x = 0.1F /* 1/10 */ * r10_x_18;
    const float v_x = v_x_8 + r10_x;
    const float r10_y = 0.1F /* 1/10 */ * r10_y_18;
    const float v_y = v_y_8 + r10_y;
    const float r10_z = 0.1F /* 1/10 */ * r10_z_18;
    const float v_z = v_z_8 + r10_z;

    /* q_square = |q|^2 */
    const float q_square_1 = q_w * q_w;
    const float q_square_2 = q_x * q_x;
    const float q_square_3 = q_y * q_y;
    const float q_square_4 = q_z * q_z;
    const float q_square_5 = q_square_1 + q_square_2;
    const float q_square_6 = q_square_5 + q_square_3;
    const float q_square = q_square_6 + q_square_4;

    /* e = (1 - |q|^2)/2   [renormalisation, folded into the scalar part] */
    const float e_1 = 1.0F - q_square;
    const float e = 0.5F * e_1;

    /* a = u + e */
    const float a = u + e;

    /* dq = q (x) [a, v]   [cao (14)] */
    const float dq_w_1 = q_w * a;
    const float dq_w_2 = q_x * v_x;
    const float dq_w_3 = dq_w_1 - dq_w_2;
    const float dq_w_4 = q_y * v_y;
    const float dq_w_5 = dq_w_3 - dq_w_4;
    const float dq_w_6 = q_z * v_z;
    const float dq_w = dq_w_5 - dq_w_6;
    const float dq_x_1 = q_w * v_x;
    const float dq_x_2 = q_x * a;
    const float dq_x_3 = dq_x_1 + dq_x_2;
    const float dq_x_4 = q_y * v_z;
    const float dq_x_5 = dq_x_3 + dq_x_4;
    const float dq_x_6 = q_z * v_y;
    const float dq_x = dq_x_5 - dq_x_6;
    const float dq_y_1 = q_w * v_y;
    const float dq_y_2 = q_y * a;
    const float dq_y_3 = dq_y_1 + dq_y_2;
    const float dq_y_4 = q_z * v_x;
    const float dq_y_5 = dq_y_3 + dq_y_4;
    const float dq_y_6 = q_x * v_z;
    const float dq_y = dq_y_5 - dq_y_6;
    const float dq_z_1 = q_w * v_z;
    const float dq_z_2 = q_z * a;
    const float dq_z_3 = dq_z_1 + dq_z_2;
    const float dq_z_4 = q_x * v_y;
    const float dq_z_5 = dq_z_3 + dq_z_4;
    const float dq_z_6 = q_y * v_x;
    const float dq_z = dq_z_5 - dq_z_6;

    /* q_next = q + dq */
    const float q_next_w = q_w + dq_w;
    const float q_next_x = q_x + dq_x;
    const float q_next_y = q_y + dq_y;
    const float q_next_z = q_z + dq_z;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void quaternion_taylor_3_10_float32_quaternion(
    const quaternion_taylor_3_10_float32_state *state, float q_nb[4])
{
    /* q, read once */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}

void quaternion_taylor_3_10_float32_dcm(const quaternion_taylor_3_10_float32_state *state, float c_nb[9])
{
    /* q, read once */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const float x2 = q_x + q_x;
    const float y2 = q_y + q_y;
    const float z2 = q_z + q_z;
    const float wx = q_w * x2;
    const float wy = q_w * y2;
    const float wz = q_w * z2;
    const float xx = q_x * x2;
    const float xy = q_x * y2;
    const float xz = q_x * z2;
    const float yy = q_y * y2;
    const float yz = q_y * z2;
    const float zz = q_z * z2;

    /* c_nb = C_nb(q)   [cao (15)] */
    const float c_nb_11_1 = yy + zz;
    const float c_nb_11 = 1.0F - c_nb_11_1;
    const float c_nb_12 = xy - wz;
    const float c_nb_13 = xz + wy;
    const float c_nb_21 = xy + wz;
    const float c_nb_22_1 = xx + zz;
    const float c_nb_22 = 1.0F - c_nb_22_1;
    const float c_nb_23 = yz - wx;
    const float c_nb_31 = xz - wy;
    const float c_nb_32 = yz + wx;
    const float c_nb_33_1 = xx + yy;
    const float c_nb_33 = 1.0F - c_nb_33_1;

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
