/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_euler_float64
 *
 * qcone 0.1.0, design dcm_taylor_3_10_euler_float64, SHA-256 of the design
 * 44f78c9d4b1694acd1328571bd38d59c6fc88f5466b160b5b316eaa79c8bbb54
 *
 * algorithm:   dcm-taylor-3-10, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      xu2019 (10) to (13), (11) and (13) corrected; xu2019 (11) multiplies from the wrong
 *              side; xu2019 (13) lacks the constants 1, 2, 6
 * equation:    v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j, row by row
 * number:      float64, every operation rounded once
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
 * update as-written      473       0  285       197       0       0     0     0     0       0
 * update shared          399      20  252       179       0       0     0     0     0       0
 * update emitted         399      20  252       179       0       0     0     0     0       0
 * dcm as-written           0       0    0         0       0       0     0     0     0       0
 * dcm shared               0       0    0         0       0       0     0     0     0       0
 * dcm emitted              0       0    0         0       0       0     0     0     0       0
 * euler as-written       101       0   73        28      10       4     0     0    30      72
 * euler shared            77      23   73        28       9       4     0     0    30      72
 * euler emitted           77      23   73        28       9       4     0     0    30      72
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "dcm_taylor_3_10_euler_float64.h"

#if DCM_TAYLOR_3_10_EULER_FLOAT64_VERSION != 1
#error "dcm_taylor_3_10_euler_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void dcm_taylor_3_10_euler_float64_init(dcm_taylor_3_10_euler_float64_state *state)
{
    state->c[0] = 1.0;
    state->c[1] = 0.0;
    state->c[2] = 0.0;
    state->c[3] = 0.0;
    state->c[4] = 1.0;
    state->c[5] = 0.0;
    state->c[6] = 0.0;
    state->c[7] = 0.0;
    state->c[8] = 1.0;
}

void dcm_taylor_3_10_euler_float64_set_dcm(
    dcm_taylor_3_10_euler_float64_state *state, const double c_nb[9])
{
    /* c_nb, read once */
    const double c_nb_11 = c_nb[0];
    const double c_nb_12 = c_nb[1];
    const double c_nb_13 = c_nb[2];
    const double c_nb_21 = c_nb[3];
    const double c_nb_22 = c_nb[4];
    const double c_nb_23 = c_nb[5];

    /* e_a = (1 - |a|^2)/2 */
    const double e_a_1 = c_nb_11 * c_nb_11;
    const double e_a_2 = c_nb_12 * c_nb_12;
    const double e_a_3 = c_nb_13 * c_nb_13;
    const double e_a_4 = e_a_1 + e_a_2;
    const double e_a_5 = e_a_4 + e_a_3;
    const double e_a_6 = 1.0 - e_a_5;
    const double e_a = 0.5 * e_a_6;

    /* e_b = (1 - |b|^2)/2 */
    const double e_b_1 = c_nb_21 * c_nb_21;
    const double e_b_2 = c_nb_22 * c_nb_22;
    const double e_b_3 = c_nb_23 * c_nb_23;
    const double e_b_4 = e_b_1 + e_b_2;
    const double e_b_5 = e_b_4 + e_b_3;
    const double e_b_6 = 1.0 - e_b_5;
    const double e_b = 0.5 * e_b_6;

    /* e_ab = a . b */
    const double e_ab_1 = c_nb_11 * c_nb_21;
    const double e_ab_2 = c_nb_12 * c_nb_22;
    const double e_ab_3 = c_nb_13 * c_nb_23;
    const double e_ab_4 = e_ab_1 + e_ab_2;
    const double e_ab = e_ab_4 + e_ab_3;

    /* a_next = a + e_a a */
    const double a_next_x_1 = e_a * c_nb_11;
    const double a_next_y_1 = e_a * c_nb_12;
    const double a_next_z_1 = e_a * c_nb_13;
    const double a_next_x = c_nb_11 + a_next_x_1;
    const double a_next_y = c_nb_12 + a_next_y_1;
    const double a_next_z = c_nb_13 + a_next_z_1;

    /* b_next = b + e_b b - e_ab a */
    const double b_next_x_1 = e_b * c_nb_21;
    const double b_next_y_1 = e_b * c_nb_22;
    const double b_next_z_1 = e_b * c_nb_23;
    const double b_next_x_2 = c_nb_21 + b_next_x_1;
    const double b_next_y_2 = c_nb_22 + b_next_y_1;
    const double b_next_z_2 = c_nb_23 + b_next_z_1;
    const double b_next_x_3 = e_ab * c_nb_11;
    const double b_next_y_3 = e_ab * c_nb_12;
    const double b_next_z_3 = e_ab * c_nb_13;
    const double b_next_x = b_next_x_2 - b_next_x_3;
    const double b_next_y = b_next_y_2 - b_next_y_3;
    const double b_next_z = b_next_z_2 - b_next_z_3;

    /* c_next = a_next x b_next */
    const double c_next_x_1 = a_next_y * b_next_z;
    const double c_next_x_2 = a_next_z * b_next_y;
    const double c_next_x = c_next_x_1 - c_next_x_2;
    const double c_next_y_1 = a_next_z * b_next_x;
    const double c_next_y_2 = a_next_x * b_next_z;
    const double c_next_y = c_next_y_1 - c_next_y_2;
    const double c_next_z_1 = a_next_x * b_next_y;
    const double c_next_z_2 = a_next_y * b_next_x;
    const double c_next_z = c_next_z_1 - c_next_z_2;

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

void dcm_taylor_3_10_euler_float64_update(
    dcm_taylor_3_10_euler_float64_state *state, const double dtheta[9])
{
    /* attitude and input */
    const double c_11 = state->c[0];
    const double c_12 = state->c[1];
    const double c_13 = state->c[2];
    const double c_21 = state->c[3];
    const double c_22 = state->c[4];
    const double c_23 = state->c[5];
    const double dtheta1_x = dtheta[0];
    const double dtheta1_y = dtheta[1];
    const double dtheta1_z = dtheta[2];
    const double dtheta2_x = dtheta[3];
    const double dtheta2_y = dtheta[4];
    const double dtheta2_z = dtheta[5];
    const double dtheta3_x = dtheta[6];
    const double dtheta3_y = dtheta[7];
    const double dtheta3_z = dtheta[8];

    /* f_k = forward differences of theta_1 .. theta_N */
    const double W0_z_1 = dtheta3_z - dtheta2_z;
    const double W0_y_1 = dtheta3_y - dtheta2_y;
    const double W0_x_1 = dtheta3_x - dtheta2_x;
    const double W0_z_2 = dtheta2_z - dtheta1_z;
    const double W0_y_2 = dtheta2_y - dtheta1_y;
    const double W0_x_2 = dtheta2_x - dtheta1_x;
    const double W0_z_3 = W0_z_1 - W0_z_2;
    const double W0_y_3 = W0_y_1 - W0_y_2;
    const double W0_x_3 = W0_x_1 - W0_x_2;

    /* W_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    const double W0_x_4 = 3.0 * dtheta1_x;
    const double W0_x_5 = 0.0 + W0_x_4;
    const double W0_x_6 = -1.5 * W0_x_2;
    const double W0_x_7 = W0_x_5 + W0_x_6;
    const double W0_x = W0_x_7 + W0_x_3;
    const double W0_y_4 = 3.0 * dtheta1_y;
    const double W0_y_5 = 0.0 + W0_y_4;
    const double W0_y_6 = -1.5 * W0_y_2;
    const double W0_y_7 = W0_y_5 + W0_y_6;
    const double W0_y = W0_y_7 + W0_y_3;
    const double W0_z_4 = 3.0 * dtheta1_z;
    const double W0_z_5 = 0.0 + W0_z_4;
    const double W0_z_6 = -1.5 * W0_z_2;
    const double W0_z_7 = W0_z_5 + W0_z_6;
    const double W0_z = W0_z_7 + W0_z_3;
    const double W1_x_1 = 9.0 * W0_x_2;
    const double W1_x_2 = 0.0 + W1_x_1;
    const double W1_x_3 = -9.0 * W0_x_3;
    const double W1_x = W1_x_2 + W1_x_3;
    const double W1_y_1 = 9.0 * W0_y_2;
    const double W1_y_2 = 0.0 + W1_y_1;
    const double W1_y_3 = -9.0 * W0_y_3;
    const double W1_y = W1_y_2 + W1_y_3;
    const double W1_z_1 = 9.0 * W0_z_2;
    const double W1_z_2 = 0.0 + W1_z_1;
    const double W1_z_3 = -9.0 * W0_z_3;
    const double W1_z = W1_z_2 + W1_z_3;
    const double W2_x_1 = 13.5 * W0_x_3;
    const double W2_x = 0.0 + W2_x_1;
    const double W2_y_1 = 13.5 * W0_y_3;
    const double W2_y = 0.0 + W2_y_1;
    const double W2_z_1 = 13.5 * W0_z_3;
    const double W2_z = 0.0 + W2_z_1;

    /* a_1 = 1/1 sum_j a_(1-1-j) x W_j   [xu2019 (13)] */
    const double a1_x_1 = c_12 * W0_z;
    const double a1_x_2 = 0.0 + a1_x_1;
    const double a1_x_3 = c_13 * W0_y;
    const double a1_x = a1_x_2 - a1_x_3;
    const double a1_y_1 = c_13 * W0_x;
    const double a1_y_2 = 0.0 + a1_y_1;
    const double a1_y_3 = c_11 * W0_z;
    const double a1_y = a1_y_2 - a1_y_3;
    const double a1_z_1 = c_11 * W0_y;
    const double a1_z_2 = 0.0 + a1_z_1;
    const double a1_z_3 = c_12 * W0_x;
    const double a1_z = a1_z_2 - a1_z_3;

    /* a_2 = 1/2 sum_j a_(2-1-j) x W_j   [xu2019 (13)] */
    const double a2_x_1 = a1_y * W0_z;
    const double a2_x_2 = 0.0 + a2_x_1;
    const double a2_x_3 = a1_z * W0_y;
    const double a2_x_4 = a2_x_2 - a2_x_3;
    const double a2_x_5 = c_12 * W1_z;
    const double a2_x_6 = a2_x_4 + a2_x_5;
    const double a2_x_7 = c_13 * W1_y;
    const double a2_x_8 = a2_x_6 - a2_x_7;
    const double a2_y_1 = a1_z * W0_x;
    const double a2_y_2 = 0.0 + a2_y_1;
    const double a2_y_3 = a1_x * W0_z;
    const double a2_y_4 = a2_y_2 - a2_y_3;
    const double a2_y_5 = c_13 * W1_x;
    const double a2_y_6 = a2_y_4 + a2_y_5;
    const double a2_y_7 = c_11 * W1_z;
    const double a2_y_8 = a2_y_6 - a2_y_7;
    const double a2_z_1 = a1_x * W0_y;
    const double a2_z_2 = 0.0 + a2_z_1;
    const double a2_z_3 = a1_y * W0_x;
    const double a2_z_4 = a2_z_2 - a2_z_3;
    const double a2_z_5 = c_11 * W1_y;
    const double a2_z_6 = a2_z_4 + a2_z_5;
    const double a2_z_7 = c_12 * W1_x;
    const double a2_z_8 = a2_z_6 - a2_z_7;
    const double a2_x = 0.5 * a2_x_8;
    const double da_x_1 = a1_x + a2_x;
    const double a2_y = 0.5 * a2_y_8;
    const double da_y_1 = a1_y + a2_y;
    const double a2_z = 0.5 * a2_z_8;
    const double da_z_1 = a1_z + a2_z;

    /* a_3 = 1/3 sum_j a_(3-1-j) x W_j   [xu2019 (13)] */
    const double a3_x_1 = a2_y * W0_z;
    const double a3_x_2 = 0.0 + a3_x_1;
    const double a3_x_3 = a2_z * W0_y;
    const double a3_x_4 = a3_x_2 - a3_x_3;
    const double a3_x_5 = a1_y * W1_z;
    const double a3_x_6 = a3_x_4 + a3_x_5;
    const double a3_x_7 = a1_z * W1_y;
    const double a3_x_8 = a3_x_6 - a3_x_7;
    const double a3_x_9 = c_12 * W2_z;
    const double a3_x_10 = a3_x_8 + a3_x_9;
    const double a3_x_11 = c_13 * W2_y;
    const double a3_x_12 = a3_x_10 - a3_x_11;
    const double a3_y_1 = a2_z * W0_x;
    const double a3_y_2 = 0.0 + a3_y_1;
    const double a3_y_3 = a2_x * W0_z;
    const double a3_y_4 = a3_y_2 - a3_y_3;
    const double a3_y_5 = a1_z * W1_x;
    const double a3_y_6 = a3_y_4 + a3_y_5;
    const double a3_y_7 = a1_x * W1_z;
    const double a3_y_8 = a3_y_6 - a3_y_7;
    const double a3_y_9 = c_13 * W2_x;
    const double a3_y_10 = a3_y_8 + a3_y_9;
    const double a3_y_11 = c_11 * W2_z;
    const double a3_y_12 = a3_y_10 - a3_y_11;
    const double a3_z_1 = a2_x * W0_y;
    const double a3_z_2 = 0.0 + a3_z_1;
    const double a3_z_3 = a2_y * W0_x;
    const double a3_z_4 = a3_z_2 - a3_z_3;
    const double a3_z_5 = a1_x * W1_y;
    const double a3_z_6 = a3_z_4 + a3_z_5;
    const double a3_z_7 = a1_y * W1_x;
    const double a3_z_8 = a3_z_6 - a3_z_7;
    const double a3_z_9 = c_11 * W2_y;
    const double a3_z_10 = a3_z_8 + a3_z_9;
    const double a3_z_11 = c_12 * W2_x;
    const double a3_z_12 = a3_z_10 - a3_z_11;
    const double a3_x = 0.3333333333333333 /* 1/3 */ * a3_x_12;
    const double da_x_2 = da_x_1 + a3_x;
    const double a3_y = 0.3333333333333333 /* 1/3 */ * a3_y_12;
    const double da_y_2 = da_y_1 + a3_y;
    const double a3_z = 0.3333333333333333 /* 1/3 */ * a3_z_12;
    const double da_z_2 = da_z_1 + a3_z;

    /* a_4 = 1/4 sum_j a_(4-1-j) x W_j   [xu2019 (13)] */
    const double a4_x_1 = a3_y * W0_z;
    const double a4_x_2 = 0.0 + a4_x_1;
    const double a4_x_3 = a3_z * W0_y;
    const double a4_x_4 = a4_x_2 - a4_x_3;
    const double a4_x_5 = a2_y * W1_z;
    const double a4_x_6 = a4_x_4 + a4_x_5;
    const double a4_x_7 = a2_z * W1_y;
    const double a4_x_8 = a4_x_6 - a4_x_7;
    const double a4_x_9 = a1_y * W2_z;
    const double a4_x_10 = a4_x_8 + a4_x_9;
    const double a4_x_11 = a1_z * W2_y;
    const double a4_x_12 = a4_x_10 - a4_x_11;
    const double a4_y_1 = a3_z * W0_x;
    const double a4_y_2 = 0.0 + a4_y_1;
    const double a4_y_3 = a3_x * W0_z;
    const double a4_y_4 = a4_y_2 - a4_y_3;
    const double a4_y_5 = a2_z * W1_x;
    const double a4_y_6 = a4_y_4 + a4_y_5;
    const double a4_y_7 = a2_x * W1_z;
    const double a4_y_8 = a4_y_6 - a4_y_7;
    const double a4_y_9 = a1_z * W2_x;
    const double a4_y_10 = a4_y_8 + a4_y_9;
    const double a4_y_11 = a1_x * W2_z;
    const double a4_y_12 = a4_y_10 - a4_y_11;
    const double a4_z_1 = a3_x * W0_y;
    const double a4_z_2 = 0.0 + a4_z_1;
    const double a4_z_3 = a3_y * W0_x;
    const double a4_z_4 = a4_z_2 - a4_z_3;
    const double a4_z_5 = a2_x * W1_y;
    const double a4_z_6 = a4_z_4 + a4_z_5;
    const double a4_z_7 = a2_y * W1_x;
    const double a4_z_8 = a4_z_6 - a4_z_7;
    const double a4_z_9 = a1_x * W2_y;
    const double a4_z_10 = a4_z_8 + a4_z_9;
    const double a4_z_11 = a1_y * W2_x;
    const double a4_z_12 = a4_z_10 - a4_z_11;
    const double a4_x = 0.25 * a4_x_12;
    const double da_x_3 = da_x_2 + a4_x;
    const double a4_y = 0.25 * a4_y_12;
    const double da_y_3 = da_y_2 + a4_y;
    const double a4_z = 0.25 * a4_z_12;
    const double da_z_3 = da_z_2 + a4_z;

    /* a_5 = 1/5 sum_j a_(5-1-j) x W_j   [xu2019 (13)] */
    const double a5_x_1 = a4_y * W0_z;
    const double a5_x_2 = 0.0 + a5_x_1;
    const double a5_x_3 = a4_z * W0_y;
    const double a5_x_4 = a5_x_2 - a5_x_3;
    const double a5_x_5 = a3_y * W1_z;
    const double a5_x_6 = a5_x_4 + a5_x_5;
    const double a5_x_7 = a3_z * W1_y;
    const double a5_x_8 = a5_x_6 - a5_x_7;
    const double a5_x_9 = a2_y * W2_z;
    const double a5_x_10 = a5_x_8 + a5_x_9;
    const double a5_x_11 = a2_z * W2_y;
    const double a5_x_12 = a5_x_10 - a5_x_11;
    const double a5_y_1 = a4_z * W0_x;
    const double a5_y_2 = 0.0 + a5_y_1;
    const double a5_y_3 = a4_x * W0_z;
    const double a5_y_4 = a5_y_2 - a5_y_3;
    const double a5_y_5 = a3_z * W1_x;
    const double a5_y_6 = a5_y_4 + a5_y_5;
    const double a5_y_7 = a3_x * W1_z;
    const double a5_y_8 = a5_y_6 - a5_y_7;
    const double a5_y_9 = a2_z * W2_x;
    const double a5_y_10 = a5_y_8 + a5_y_9;
    const double a5_y_11 = a2_x * W2_z;
    const double a5_y_12 = a5_y_10 - a5_y_11;
    const double a5_z_1 = a4_x * W0_y;
    const double a5_z_2 = 0.0 + a5_z_1;
    const double a5_z_3 = a4_y * W0_x;
    const double a5_z_4 = a5_z_2 - a5_z_3;
    const double a5_z_5 = a3_x * W1_y;
    const double a5_z_6 = a5_z_4 + a5_z_5;
    const double a5_z_7 = a3_y * W1_x;
    const double a5_z_8 = a5_z_6 - a5_z_7;
    const double a5_z_9 = a2_x * W2_y;
    const double a5_z_10 = a5_z_8 + a5_z_9;
    const double a5_z_11 = a2_y * W2_x;
    const double a5_z_12 = a5_z_10 - a5_z_11;
    const double a5_x = 0.2 /* 1/5 */ * a5_x_12;
    const double da_x_4 = da_x_3 + a5_x;
    const double a5_y = 0.2 /* 1/5 */ * a5_y_12;
    const double da_y_4 = da_y_3 + a5_y;
    const double a5_z = 0.2 /* 1/5 */ * a5_z_12;
    const double da_z_4 = da_z_3 + a5_z;

    /* a_6 = 1/6 sum_j a_(6-1-j) x W_j   [xu2019 (13)] */
    const double a6_x_1 = a5_y * W0_z;
    const double a6_x_2 = 0.0 + a6_x_1;
    const double a6_x_3 = a5_z * W0_y;
    const double a6_x_4 = a6_x_2 - a6_x_3;
    const double a6_x_5 = a4_y * W1_z;
    const double a6_x_6 = a6_x_4 + a6_x_5;
    const double a6_x_7 = a4_z * W1_y;
    const double a6_x_8 = a6_x_6 - a6_x_7;
    const double a6_x_9 = a3_y * W2_z;
    const double a6_x_10 = a6_x_8 + a6_x_9;
    const double a6_x_11 = a3_z * W2_y;
    const double a6_x_12 = a6_x_10 - a6_x_11;
    const double a6_y_1 = a5_z * W0_x;
    const double a6_y_2 = 0.0 + a6_y_1;
    const double a6_y_3 = a5_x * W0_z;
    const double a6_y_4 = a6_y_2 - a6_y_3;
    const double a6_y_5 = a4_z * W1_x;
    const double a6_y_6 = a6_y_4 + a6_y_5;
    const double a6_y_7 = a4_x * W1_z;
    const double a6_y_8 = a6_y_6 - a6_y_7;
    const double a6_y_9 = a3_z * W2_x;
    const double a6_y_10 = a6_y_8 + a6_y_9;
    const double a6_y_11 = a3_x * W2_z;
    const double a6_y_12 = a6_y_10 - a6_y_11;
    const double a6_z_1 = a5_x * W0_y;
    const double a6_z_2 = 0.0 + a6_z_1;
    const double a6_z_3 = a5_y * W0_x;
    const double a6_z_4 = a6_z_2 - a6_z_3;
    const double a6_z_5 = a4_x * W1_y;
    const double a6_z_6 = a6_z_4 + a6_z_5;
    const double a6_z_7 = a4_y * W1_x;
    const double a6_z_8 = a6_z_6 - a6_z_7;
    const double a6_z_9 = a3_x * W2_y;
    const double a6_z_10 = a6_z_8 + a6_z_9;
    const double a6_z_11 = a3_y * W2_x;
    const double a6_z_12 = a6_z_10 - a6_z_11;
    const double a6_x = 0.16666666666666666 /* 1/6 */ * a6_x_12;
    const double da_x_5 = da_x_4 + a6_x;
    const double a6_y = 0.16666666666666666 /* 1/6 */ * a6_y_12;
    const double da_y_5 = da_y_4 + a6_y;
    const double a6_z = 0.16666666666666666 /* 1/6 */ * a6_z_12;
    const double da_z_5 = da_z_4 + a6_z;

    /* a_7 = 1/7 sum_j a_(7-1-j) x W_j   [xu2019 (13)] */
    const double a7_x_1 = a6_y * W0_z;
    const double a7_x_2 = 0.0 + a7_x_1;
    const double a7_x_3 = a6_z * W0_y;
    const double a7_x_4 = a7_x_2 - a7_x_3;
    const double a7_x_5 = a5_y * W1_z;
    const double a7_x_6 = a7_x_4 + a7_x_5;
    const double a7_x_7 = a5_z * W1_y;
    const double a7_x_8 = a7_x_6 - a7_x_7;
    const double a7_x_9 = a4_y * W2_z;
    const double a7_x_10 = a7_x_8 + a7_x_9;
    const double a7_x_11 = a4_z * W2_y;
    const double a7_x_12 = a7_x_10 - a7_x_11;
    const double a7_y_1 = a6_z * W0_x;
    const double a7_y_2 = 0.0 + a7_y_1;
    const double a7_y_3 = a6_x * W0_z;
    const double a7_y_4 = a7_y_2 - a7_y_3;
    const double a7_y_5 = a5_z * W1_x;
    const double a7_y_6 = a7_y_4 + a7_y_5;
    const double a7_y_7 = a5_x * W1_z;
    const double a7_y_8 = a7_y_6 - a7_y_7;
    const double a7_y_9 = a4_z * W2_x;
    const double a7_y_10 = a7_y_8 + a7_y_9;
    const double a7_y_11 = a4_x * W2_z;
    const double a7_y_12 = a7_y_10 - a7_y_11;
    const double a7_z_1 = a6_x * W0_y;
    const double a7_z_2 = 0.0 + a7_z_1;
    const double a7_z_3 = a6_y * W0_x;
    const double a7_z_4 = a7_z_2 - a7_z_3;
    const double a7_z_5 = a5_x * W1_y;
    const double a7_z_6 = a7_z_4 + a7_z_5;
    const double a7_z_7 = a5_y * W1_x;
    const double a7_z_8 = a7_z_6 - a7_z_7;
    const double a7_z_9 = a4_x * W2_y;
    const double a7_z_10 = a7_z_8 + a7_z_9;
    const double a7_z_11 = a4_y * W2_x;
    const double a7_z_12 = a7_z_10 - a7_z_11;
    const double a7_x = 0.14285714285714285 /* 1/7 */ * a7_x_12;
    const double da_x_6 = da_x_5 + a7_x;
    const double a7_y = 0.14285714285714285 /* 1/7 */ * a7_y_12;
    const double da_y_6 = da_y_5 + a7_y;
    const double a7_z = 0.14285714285714285 /* 1/7 */ * a7_z_12;
    const double da_z_6 = da_z_5 + a7_z;

    /* a_8 = 1/8 sum_j a_(8-1-j) x W_j   [xu2019 (13)] */
    const double a8_x_1 = a7_y * W0_z;
    const double a8_x_2 = 0.0 + a8_x_1;
    const double a8_x_3 = a7_z * W0_y;
    const double a8_x_4 = a8_x_2 - a8_x_3;
    const double a8_x_5 = a6_y * W1_z;
    const double a8_x_6 = a8_x_4 + a8_x_5;
    const double a8_x_7 = a6_z * W1_y;
    const double a8_x_8 = a8_x_6 - a8_x_7;
    const double a8_x_9 = a5_y * W2_z;
    const double a8_x_10 = a8_x_8 + a8_x_9;
    const double a8_x_11 = a5_z * W2_y;
    const double a8_x_12 = a8_x_10 - a8_x_11;
    const double a8_y_1 = a7_z * W0_x;
    const double a8_y_2 = 0.0 + a8_y_1;
    const double a8_y_3 = a7_x * W0_z;
    const double a8_y_4 = a8_y_2 - a8_y_3;
    const double a8_y_5 = a6_z * W1_x;
    const double a8_y_6 = a8_y_4 + a8_y_5;
    const double a8_y_7 = a6_x * W1_z;
    const double a8_y_8 = a8_y_6 - a8_y_7;
    const double a8_y_9 = a5_z * W2_x;
    const double a8_y_10 = a8_y_8 + a8_y_9;
    const double a8_y_11 = a5_x * W2_z;
    const double a8_y_12 = a8_y_10 - a8_y_11;
    const double a8_z_1 = a7_x * W0_y;
    const double a8_z_2 = 0.0 + a8_z_1;
    const double a8_z_3 = a7_y * W0_x;
    const double a8_z_4 = a8_z_2 - a8_z_3;
    const double a8_z_5 = a6_x * W1_y;
    const double a8_z_6 = a8_z_4 + a8_z_5;
    const double a8_z_7 = a6_y * W1_x;
    const double a8_z_8 = a8_z_6 - a8_z_7;
    const double a8_z_9 = a5_x * W2_y;
    const double a8_z_10 = a8_z_8 + a8_z_9;
    const double a8_z_11 = a5_y * W2_x;
    const double a8_z_12 = a8_z_10 - a8_z_11;
    const double a8_x = 0.125 * a8_x_12;
    const double da_x_7 = da_x_6 + a8_x;
    const double a8_y = 0.125 * a8_y_12;
    const double da_y_7 = da_y_6 + a8_y;
    const double a8_z = 0.125 * a8_z_12;
    const double da_z_7 = da_z_6 + a8_z;

    /* a_9 = 1/9 sum_j a_(9-1-j) x W_j   [xu2019 (13)] */
    const double a9_x_1 = a8_y * W0_z;
    const double a9_x_2 = 0.0 + a9_x_1;
    const double a9_x_3 = a8_z * W0_y;
    const double a9_x_4 = a9_x_2 - a9_x_3;
    const double a9_x_5 = a7_y * W1_z;
    const double a9_x_6 = a9_x_4 + a9_x_5;
    const double a9_x_7 = a7_z * W1_y;
    const double a9_x_8 = a9_x_6 - a9_x_7;
    const double a9_x_9 = a6_y * W2_z;
    const double a9_x_10 = a9_x_8 + a9_x_9;
    const double a9_x_11 = a6_z * W2_y;
    const double a9_x_12 = a9_x_10 - a9_x_11;
    const double a9_y_1 = a8_z * W0_x;
    const double a9_y_2 = 0.0 + a9_y_1;
    const double a9_y_3 = a8_x * W0_z;
    const double a9_y_4 = a9_y_2 - a9_y_3;
    const double a9_y_5 = a7_z * W1_x;
    const double a9_y_6 = a9_y_4 + a9_y_5;
    const double a9_y_7 = a7_x * W1_z;
    const double a9_y_8 = a9_y_6 - a9_y_7;
    const double a9_y_9 = a6_z * W2_x;
    const double a9_y_10 = a9_y_8 + a9_y_9;
    const double a9_y_11 = a6_x * W2_z;
    const double a9_y_12 = a9_y_10 - a9_y_11;
    const double a9_z_1 = a8_x * W0_y;
    const double a9_z_2 = 0.0 + a9_z_1;
    const double a9_z_3 = a8_y * W0_x;
    const double a9_z_4 = a9_z_2 - a9_z_3;
    const double a9_z_5 = a7_x * W1_y;
    const double a9_z_6 = a9_z_4 + a9_z_5;
    const double a9_z_7 = a7_y * W1_x;
    const double a9_z_8 = a9_z_6 - a9_z_7;
    const double a9_z_9 = a6_x * W2_y;
    const double a9_z_10 = a9_z_8 + a9_z_9;
    const double a9_z_11 = a6_y * W2_x;
    const double a9_z_12 = a9_z_10 - a9_z_11;
    const double a9_x = 0.1111111111111111 /* 1/9 */ * a9_x_12;
    const double da_x_8 = da_x_7 + a9_x;
    const double a9_y = 0.1111111111111111 /* 1/9 */ * a9_y_12;
    const double da_y_8 = da_y_7 + a9_y;
    const double a9_z = 0.1111111111111111 /* 1/9 */ * a9_z_12;
    const double da_z_8 = da_z_7 + a9_z;

    /* a_10 = 1/10 sum_j a_(10-1-j) x W_j   [xu2019 (13)] */
    const double a10_x_1 = a9_y * W0_z;
    const double a10_x_2 = 0.0 + a10_x_1;
    const double a10_x_3 = a9_z * W0_y;
    const double a10_x_4 = a10_x_2 - a10_x_3;
    const double a10_x_5 = a8_y * W1_z;
    const double a10_x_6 = a10_x_4 + a10_x_5;
    const double a10_x_7 = a8_z * W1_y;
    const double a10_x_8 = a10_x_6 - a10_x_7;
    const double a10_x_9 = a7_y * W2_z;
    const double a10_x_10 = a10_x_8 + a10_x_9;
    const double a10_x_11 = a7_z * W2_y;
    const double a10_x_12 = a10_x_10 - a10_x_11;
    const double a10_y_1 = a9_z * W0_x;
    const double a10_y_2 = 0.0 + a10_y_1;
    const double a10_y_3 = a9_x * W0_z;
    const double a10_y_4 = a10_y_2 - a10_y_3;
    const double a10_y_5 = a8_z * W1_x;
    const double a10_y_6 = a10_y_4 + a10_y_5;
    const double a10_y_7 = a8_x * W1_z;
    const double a10_y_8 = a10_y_6 - a10_y_7;
    const double a10_y_9 = a7_z * W2_x;
    const double a10_y_10 = a10_y_8 + a10_y_9;
    const double a10_y_11 = a7_x * W2_z;
    const double a10_y_12 = a10_y_10 - a10_y_11;
    const double a10_z_1 = a9_x * W0_y;
    const double a10_z_2 = 0.0 + a10_z_1;
    const double a10_z_3 = a9_y * W0_x;
    const double a10_z_4 = a10_z_2 - a10_z_3;
    const double a10_z_5 = a8_x * W1_y;
    const double a10_z_6 = a10_z_4 + a10_z_5;
    const double a10_z_7 = a8_y * W1_x;
    const double a10_z_8 = a10_z_6 - a10_z_7;
    const double a10_z_9 = a7_x * W2_y;
    const double a10_z_10 = a10_z_8 + a10_z_9;
    const double a10_z_11 = a7_y * W2_x;
    const double a10_z_12 = a10_z_10 - a10_z_11;
    const double a10_x = 0.1 /* 1/10 */ * a10_x_12;
    const double da_x = da_x_8 + a10_x;
    const double a10_y = 0.1 /* 1/10 */ * a10_y_12;
    const double da_y = da_y_8 + a10_y;
    const double a10_z = 0.1 /* 1/10 */ * a10_z_12;
    const double da_z = da_z_8 + a10_z;

    /* b_1 = 1/1 sum_j b_(1-1-j) x W_j   [xu2019 (13)] */
    const double b1_x_1 = c_22 * W0_z;
    const double b1_x_2 = 0.0 + b1_x_1;
    const double b1_x_3 = c_23 * W0_y;
    const double b1_x = b1_x_2 - b1_x_3;
    const double b1_y_1 = c_23 * W0_x;
    const double b1_y_2 = 0.0 + b1_y_1;
    const double b1_y_3 = c_21 * W0_z;
    const double b1_y = b1_y_2 - b1_y_3;
    const double b1_z_1 = c_21 * W0_y;
    const double b1_z_2 = 0.0 + b1_z_1;
    const double b1_z_3 = c_22 * W0_x;
    const double b1_z = b1_z_2 - b1_z_3;

    /* b_2 = 1/2 sum_j b_(2-1-j) x W_j   [xu2019 (13)] */
    const double b2_x_1 = b1_y * W0_z;
    const double b2_x_2 = 0.0 + b2_x_1;
    const double b2_x_3 = b1_z * W0_y;
    const double b2_x_4 = b2_x_2 - b2_x_3;
    const double b2_x_5 = c_22 * W1_z;
    const double b2_x_6 = b2_x_4 + b2_x_5;
    const double b2_x_7 = c_23 * W1_y;
    const double b2_x_8 = b2_x_6 - b2_x_7;
    const double b2_y_1 = b1_z * W0_x;
    const double b2_y_2 = 0.0 + b2_y_1;
    const double b2_y_3 = b1_x * W0_z;
    const double b2_y_4 = b2_y_2 - b2_y_3;
    const double b2_y_5 = c_23 * W1_x;
    const double b2_y_6 = b2_y_4 + b2_y_5;
    const double b2_y_7 = c_21 * W1_z;
    const double b2_y_8 = b2_y_6 - b2_y_7;
    const double b2_z_1 = b1_x * W0_y;
    const double b2_z_2 = 0.0 + b2_z_1;
    const double b2_z_3 = b1_y * W0_x;
    const double b2_z_4 = b2_z_2 - b2_z_3;
    const double b2_z_5 = c_21 * W1_y;
    const double b2_z_6 = b2_z_4 + b2_z_5;
    const double b2_z_7 = c_22 * W1_x;
    const double b2_z_8 = b2_z_6 - b2_z_7;
    const double b2_x = 0.5 * b2_x_8;
    const double db_x_1 = b1_x + b2_x;
    const double b2_y = 0.5 * b2_y_8;
    const double db_y_1 = b1_y + b2_y;
    const double b2_z = 0.5 * b2_z_8;
    const double db_z_1 = b1_z + b2_z;

    /* b_3 = 1/3 sum_j b_(3-1-j) x W_j   [xu2019 (13)] */
    const double b3_x_1 = b2_y * W0_z;
    const double b3_x_2 = 0.0 + b3_x_1;
    const double b3_x_3 = b2_z * W0_y;
    const double b3_x_4 = b3_x_2 - b3_x_3;
    const double b3_x_5 = b1_y * W1_z;
    const double b3_x_6 = b3_x_4 + b3_x_5;
    const double b3_x_7 = b1_z * W1_y;
    const double b3_x_8 = b3_x_6 - b3_x_7;
    const double b3_x_9 = c_22 * W2_z;
    const double b3_x_10 = b3_x_8 + b3_x_9;
    const double b3_x_11 = c_23 * W2_y;
    const double b3_x_12 = b3_x_10 - b3_x_11;
    const double b3_y_1 = b2_z * W0_x;
    const double b3_y_2 = 0.0 + b3_y_1;
    const double b3_y_3 = b2_x * W0_z;
    const double b3_y_4 = b3_y_2 - b3_y_3;
    const double b3_y_5 = b1_z * W1_x;
    const double b3_y_6 = b3_y_4 + b3_y_5;
    const double b3_y_7 = b1_x * W1_z;
    const double b3_y_8 = b3_y_6 - b3_y_7;
    const double b3_y_9 = c_23 * W2_x;
    const double b3_y_10 = b3_y_8 + b3_y_9;
    const double b3_y_11 = c_21 * W2_z;
    const double b3_y_12 = b3_y_10 - b3_y_11;
    const double b3_z_1 = b2_x * W0_y;
    const double b3_z_2 = 0.0 + b3_z_1;
    const double b3_z_3 = b2_y * W0_x;
    const double b3_z_4 = b3_z_2 - b3_z_3;
    const double b3_z_5 = b1_x * W1_y;
    const double b3_z_6 = b3_z_4 + b3_z_5;
    const double b3_z_7 = b1_y * W1_x;
    const double b3_z_8 = b3_z_6 - b3_z_7;
    const double b3_z_9 = c_21 * W2_y;
    const double b3_z_10 = b3_z_8 + b3_z_9;
    const double b3_z_11 = c_22 * W2_x;
    const double b3_z_12 = b3_z_10 - b3_z_11;
    const double b3_x = 0.3333333333333333 /* 1/3 */ * b3_x_12;
    const double db_x_2 = db_x_1 + b3_x;
    const double b3_y = 0.3333333333333333 /* 1/3 */ * b3_y_12;
    const double db_y_2 = db_y_1 + b3_y;
    const double b3_z = 0.3333333333333333 /* 1/3 */ * b3_z_12;
    const double db_z_2 = db_z_1 + b3_z;

    /* b_4 = 1/4 sum_j b_(4-1-j) x W_j   [xu2019 (13)] */
    const double b4_x_1 = b3_y * W0_z;
    const double b4_x_2 = 0.0 + b4_x_1;
    const double b4_x_3 = b3_z * W0_y;
    const double b4_x_4 = b4_x_2 - b4_x_3;
    const double b4_x_5 = b2_y * W1_z;
    const double b4_x_6 = b4_x_4 + b4_x_5;
    const double b4_x_7 = b2_z * W1_y;
    const double b4_x_8 = b4_x_6 - b4_x_7;
    const double b4_x_9 = b1_y * W2_z;
    const double b4_x_10 = b4_x_8 + b4_x_9;
    const double b4_x_11 = b1_z * W2_y;
    const double b4_x_12 = b4_x_10 - b4_x_11;
    const double b4_y_1 = b3_z * W0_x;
    const double b4_y_2 = 0.0 + b4_y_1;
    const double b4_y_3 = b3_x * W0_z;
    const double b4_y_4 = b4_y_2 - b4_y_3;
    const double b4_y_5 = b2_z * W1_x;
    const double b4_y_6 = b4_y_4 + b4_y_5;
    const double b4_y_7 = b2_x * W1_z;
    const double b4_y_8 = b4_y_6 - b4_y_7;
    const double b4_y_9 = b1_z * W2_x;
    const double b4_y_10 = b4_y_8 + b4_y_9;
    const double b4_y_11 = b1_x * W2_z;
    const double b4_y_12 = b4_y_10 - b4_y_11;
    const double b4_z_1 = b3_x * W0_y;
    const double b4_z_2 = 0.0 + b4_z_1;
    const double b4_z_3 = b3_y * W0_x;
    const double b4_z_4 = b4_z_2 - b4_z_3;
    const double b4_z_5 = b2_x * W1_y;
    const double b4_z_6 = b4_z_4 + b4_z_5;
    const double b4_z_7 = b2_y * W1_x;
    const double b4_z_8 = b4_z_6 - b4_z_7;
    const double b4_z_9 = b1_x * W2_y;
    const double b4_z_10 = b4_z_8 + b4_z_9;
    const double b4_z_11 = b1_y * W2_x;
    const double b4_z_12 = b4_z_10 - b4_z_11;
    const double b4_x = 0.25 * b4_x_12;
    const double db_x_3 = db_x_2 + b4_x;
    const double b4_y = 0.25 * b4_y_12;
    const double db_y_3 = db_y_2 + b4_y;
    const double b4_z = 0.25 * b4_z_12;
    const double db_z_3 = db_z_2 + b4_z;

    /* b_5 = 1/5 sum_j b_(5-1-j) x W_j   [xu2019 (13)] */
    const double b5_x_1 = b4_y * W0_z;
    const double b5_x_2 = 0.0 + b5_x_1;
    const double b5_x_3 = b4_z * W0_y;
    const double b5_x_4 = b5_x_2 - b5_x_3;
    const double b5_x_5 = b3_y * W1_z;
    const double b5_x_6 = b5_x_4 + b5_x_5;
    const double b5_x_7 = b3_z * W1_y;
    const double b5_x_8 = b5_x_6 - b5_x_7;
    const double b5_x_9 = b2_y * W2_z;
    const double b5_x_10 = b5_x_8 + b5_x_9;
    const double b5_x_11 = b2_z * W2_y;
    const double b5_x_12 = b5_x_10 - b5_x_11;
    const double b5_y_1 = b4_z * W0_x;
    const double b5_y_2 = 0.0 + b5_y_1;
    const double b5_y_3 = b4_x * W0_z;
    const double b5_y_4 = b5_y_2 - b5_y_3;
    const double b5_y_5 = b3_z * W1_x;
    const double b5_y_6 = b5_y_4 + b5_y_5;
    const double b5_y_7 = b3_x * W1_z;
    const double b5_y_8 = b5_y_6 - b5_y_7;
    const double b5_y_9 = b2_z * W2_x;
    const double b5_y_10 = b5_y_8 + b5_y_9;
    const double b5_y_11 = b2_x * W2_z;
    const double b5_y_12 = b5_y_10 - b5_y_11;
    const double b5_z_1 = b4_x * W0_y;
    const double b5_z_2 = 0.0 + b5_z_1;
    const double b5_z_3 = b4_y * W0_x;
    const double b5_z_4 = b5_z_2 - b5_z_3;
    const double b5_z_5 = b3_x * W1_y;
    const double b5_z_6 = b5_z_4 + b5_z_5;
    const double b5_z_7 = b3_y * W1_x;
    const double b5_z_8 = b5_z_6 - b5_z_7;
    const double b5_z_9 = b2_x * W2_y;
    const double b5_z_10 = b5_z_8 + b5_z_9;
    const double b5_z_11 = b2_y * W2_x;
    const double b5_z_12 = b5_z_10 - b5_z_11;
    const double b5_x = 0.2 /* 1/5 */ * b5_x_12;
    const double db_x_4 = db_x_3 + b5_x;
    const double b5_y = 0.2 /* 1/5 */ * b5_y_12;
    const double db_y_4 = db_y_3 + b5_y;
    const double b5_z = 0.2 /* 1/5 */ * b5_z_12;
    const double db_z_4 = db_z_3 + b5_z;

    /* b_6 = 1/6 sum_j b_(6-1-j) x W_j   [xu2019 (13)] */
    const double b6_x_1 = b5_y * W0_z;
    const double b6_x_2 = 0.0 + b6_x_1;
    const double b6_x_3 = b5_z * W0_y;
    const double b6_x_4 = b6_x_2 - b6_x_3;
    const double b6_x_5 = b4_y * W1_z;
    const double b6_x_6 = b6_x_4 + b6_x_5;
    const double b6_x_7 = b4_z * W1_y;
    const double b6_x_8 = b6_x_6 - b6_x_7;
    const double b6_x_9 = b3_y * W2_z;
    const double b6_x_10 = b6_x_8 + b6_x_9;
    const double b6_x_11 = b3_z * W2_y;
    const double b6_x_12 = b6_x_10 - b6_x_11;
    const double b6_y_1 = b5_z * W0_x;
    const double b6_y_2 = 0.0 + b6_y_1;
    const double b6_y_3 = b5_x * W0_z;
    const double b6_y_4 = b6_y_2 - b6_y_3;
    const double b6_y_5 = b4_z * W1_x;
    const double b6_y_6 = b6_y_4 + b6_y_5;
    const double b6_y_7 = b4_x * W1_z;
    const double b6_y_8 = b6_y_6 - b6_y_7;
    const double b6_y_9 = b3_z * W2_x;
    const double b6_y_10 = b6_y_8 + b6_y_9;
    const double b6_y_11 = b3_x * W2_z;
    const double b6_y_12 = b6_y_10 - b6_y_11;
    const double b6_z_1 = b5_x * W0_y;
    const double b6_z_2 = 0.0 + b6_z_1;
    const double b6_z_3 = b5_y * W0_x;
    const double b6_z_4 = b6_z_2 - b6_z_3;
    const double b6_z_5 = b4_x * W1_y;
    const double b6_z_6 = b6_z_4 + b6_z_5;
    const double b6_z_7 = b4_y * W1_x;
    const double b6_z_8 = b6_z_6 - b6_z_7;
    const double b6_z_9 = b3_x * W2_y;
    const double b6_z_10 = b6_z_8 + b6_z_9;
    const double b6_z_11 = b3_y * W2_x;
    const double b6_z_12 = b6_z_10 - b6_z_11;
    const double b6_x = 0.16666666666666666 /* 1/6 */ * b6_x_12;
    const double db_x_5 = db_x_4 + b6_x;
    const double b6_y = 0.16666666666666666 /* 1/6 */ * b6_y_12;
    const double db_y_5 = db_y_4 + b6_y;
    const double b6_z = 0.16666666666666666 /* 1/6 */ * b6_z_12;
    const double db_z_5 = db_z_4 + b6_z;

    /* b_7 = 1/7 sum_j b_(7-1-j) x W_j   [xu2019 (13)] */
    const double b7_x_1 = b6_y * W0_z;
    const double b7_x_2 = 0.0 + b7_x_1;
    const double b7_x_3 = b6_z * W0_y;
    const double b7_x_4 = b7_x_2 - b7_x_3;
    const double b7_x_5 = b5_y * W1_z;
    const double b7_x_6 = b7_x_4 + b7_x_5;
    const double b7_x_7 = b5_z * W1_y;
    const double b7_x_8 = b7_x_6 - b7_x_7;
    const double b7_x_9 = b4_y * W2_z;
    const double b7_x_10 = b7_x_8 + b7_x_9;
    const double b7_x_11 = b4_z * W2_y;
    const double b7_x_12 = b7_x_10 - b7_x_11;
    const double b7_y_1 = b6_z * W0_x;
    const double b7_y_2 = 0.0 + b7_y_1;
    const double b7_y_3 = b6_x * W0_z;
    const double b7_y_4 = b7_y_2 - b7_y_3;
    const double b7_y_5 = b5_z * W1_x;
    const double b7_y_6 = b7_y_4 + b7_y_5;
    const double b7_y_7 = b5_x * W1_z;
    const double b7_y_8 = b7_y_6 - b7_y_7;
    const double b7_y_9 = b4_z * W2_x;
    const double b7_y_10 = b7_y_8 + b7_y_9;
    const double b7_y_11 = b4_x * W2_z;
    const double b7_y_12 = b7_y_10 - b7_y_11;
    const double b7_z_1 = b6_x * W0_y;
    const double b7_z_2 = 0.0 + b7_z_1;
    const double b7_z_3 = b6_y * W0_x;
    const double b7_z_4 = b7_z_2 - b7_z_3;
    const double b7_z_5 = b5_x * W1_y;
    const double b7_z_6 = b7_z_4 + b7_z_5;
    const double b7_z_7 = b5_y * W1_x;
    const double b7_z_8 = b7_z_6 - b7_z_7;
    const double b7_z_9 = b4_x * W2_y;
    const double b7_z_10 = b7_z_8 + b7_z_9;
    const double b7_z_11 = b4_y * W2_x;
    const double b7_z_12 = b7_z_10 - b7_z_11;
    const double b7_x = 0.14285714285714285 /* 1/7 */ * b7_x_12;
    const double db_x_6 = db_x_5 + b7_x;
    const double b7_y = 0.14285714285714285 /* 1/7 */ * b7_y_12;
    const double db_y_6 = db_y_5 + b7_y;
    const double b7_z = 0.14285714285714285 /* 1/7 */ * b7_z_12;
    const double db_z_6 = db_z_5 + b7_z;

    /* b_8 = 1/8 sum_j b_(8-1-j) x W_j   [xu2019 (13)] */
    const double b8_x_1 = b7_y * W0_z;
    const double b8_x_2 = 0.0 + b8_x_1;
    const double b8_x_3 = b7_z * W0_y;
    const double b8_x_4 = b8_x_2 - b8_x_3;
    const double b8_x_5 = b6_y * W1_z;
    const double b8_x_6 = b8_x_4 + b8_x_5;
    const double b8_x_7 = b6_z * W1_y;
    const double b8_x_8 = b8_x_6 - b8_x_7;
    const double b8_x_9 = b5_y * W2_z;
    const double b8_x_10 = b8_x_8 + b8_x_9;
    const double b8_x_11 = b5_z * W2_y;
    const double b8_x_12 = b8_x_10 - b8_x_11;
    const double b8_y_1 = b7_z * W0_x;
    const double b8_y_2 = 0.0 + b8_y_1;
    const double b8_y_3 = b7_x * W0_z;
    const double b8_y_4 = b8_y_2 - b8_y_3;
    const double b8_y_5 = b6_z * W1_x;
    const double b8_y_6 = b8_y_4 + b8_y_5;
    const double b8_y_7 = b6_x * W1_z;
    const double b8_y_8 = b8_y_6 - b8_y_7;
    const double b8_y_9 = b5_z * W2_x;
    const double b8_y_10 = b8_y_8 + b8_y_9;
    const double b8_y_11 = b5_x * W2_z;
    const double b8_y_12 = b8_y_10 - b8_y_11;
    const double b8_z_1 = b7_x * W0_y;
    const double b8_z_2 = 0.0 + b8_z_1;
    const double b8_z_3 = b7_y * W0_x;
    const double b8_z_4 = b8_z_2 - b8_z_3;
    const double b8_z_5 = b6_x * W1_y;
    const double b8_z_6 = b8_z_4 + b8_z_5;
    const double b8_z_7 = b6_y * W1_x;
    const double b8_z_8 = b8_z_6 - b8_z_7;
    const double b8_z_9 = b5_x * W2_y;
    const double b8_z_10 = b8_z_8 + b8_z_9;
    const double b8_z_11 = b5_y * W2_x;
    const double b8_z_12 = b8_z_10 - b8_z_11;
    const double b8_x = 0.125 * b8_x_12;
    const double db_x_7 = db_x_6 + b8_x;
    const double b8_y = 0.125 * b8_y_12;
    const double db_y_7 = db_y_6 + b8_y;
    const double b8_z = 0.125 * b8_z_12;
    const double db_z_7 = db_z_6 + b8_z;

    /* b_9 = 1/9 sum_j b_(9-1-j) x W_j   [xu2019 (13)] */
    const double b9_x_1 = b8_y * W0_z;
    const double b9_x_2 = 0.0 + b9_x_1;
    const double b9_x_3 = b8_z * W0_y;
    const double b9_x_4 = b9_x_2 - b9_x_3;
    const double b9_x_5 = b7_y * W1_z;
    const double b9_x_6 = b9_x_4 + b9_x_5;
    const double b9_x_7 = b7_z * W1_y;
    const double b9_x_8 = b9_x_6 - b9_x_7;
    const double b9_x_9 = b6_y * W2_z;
    const double b9_x_10 = b9_x_8 + b9_x_9;
    const double b9_x_11 = b6_z * W2_y;
    const double b9_x_12 = b9_x_10 - b9_x_11;
    const double b9_y_1 = b8_z * W0_x;
    const double b9_y_2 = 0.0 + b9_y_1;
    const double b9_y_3 = b8_x * W0_z;
    const double b9_y_4 = b9_y_2 - b9_y_3;
    const double b9_y_5 = b7_z * W1_x;
    const double b9_y_6 = b9_y_4 + b9_y_5;
    const double b9_y_7 = b7_x * W1_z;
    const double b9_y_8 = b9_y_6 - b9_y_7;
    const double b9_y_9 = b6_z * W2_x;
    const double b9_y_10 = b9_y_8 + b9_y_9;
    const double b9_y_11 = b6_x * W2_z;
    const double b9_y_12 = b9_y_10 - b9_y_11;
    const double b9_z_1 = b8_x * W0_y;
    const double b9_z_2 = 0.0 + b9_z_1;
    const double b9_z_3 = b8_y * W0_x;
    const double b9_z_4 = b9_z_2 - b9_z_3;
    const double b9_z_5 = b7_x * W1_y;
    const double b9_z_6 = b9_z_4 + b9_z_5;
    const double b9_z_7 = b7_y * W1_x;
    const double b9_z_8 = b9_z_6 - b9_z_7;
    const double b9_z_9 = b6_x * W2_y;
    const double b9_z_10 = b9_z_8 + b9_z_9;
    const double b9_z_11 = b6_y * W2_x;
    const double b9_z_12 = b9_z_10 - b9_z_11;
    const double b9_x = 0.1111111111111111 /* 1/9 */ * b9_x_12;
    const double db_x_8 = db_x_7 + b9_x;
    const double b9_y = 0.1111111111111111 /* 1/9 */ * b9_y_12;
    const double db_y_8 = db_y_7 + b9_y;
    const double b9_z = 0.1111111111111111 /* 1/9 */ * b9_z_12;
    const double db_z_8 = db_z_7 + b9_z;

    /* b_10 = 1/10 sum_j b_(10-1-j) x W_j   [xu2019 (13)] */
    const double b10_x_1 = b9_y * W0_z;
    const double b10_x_2 = 0.0 + b10_x_1;
    const double b10_x_3 = b9_z * W0_y;
    const double b10_x_4 = b10_x_2 - b10_x_3;
    const double b10_x_5 = b8_y * W1_z;
    const double b10_x_6 = b10_x_4 + b10_x_5;
    const double b10_x_7 = b8_z * W1_y;
    const double b10_x_8 = b10_x_6 - b10_x_7;
    const double b10_x_9 = b7_y * W2_z;
    const double b10_x_10 = b10_x_8 + b10_x_9;
    const double b10_x_11 = b7_z * W2_y;
    const double b10_x_12 = b10_x_10 - b10_x_11;
    const double b10_y_1 = b9_z * W0_x;
    const double b10_y_2 = 0.0 + b10_y_1;
    const double b10_y_3 = b9_x * W0_z;
    const double b10_y_4 = b10_y_2 - b10_y_3;
    const double b10_y_5 = b8_z * W1_x;
    const double b10_y_6 = b10_y_4 + b10_y_5;
    const double b10_y_7 = b8_x * W1_z;
    const double b10_y_8 = b10_y_6 - b10_y_7;
    const double b10_y_9 = b7_z * W2_x;
    const double b10_y_10 = b10_y_8 + b10_y_9;
    const double b10_y_11 = b7_x * W2_z;
    const double b10_y_12 = b10_y_10 - b10_y_11;
    const double b10_z_1 = b9_x * W0_y;
    const double b10_z_2 = 0.0 + b10_z_1;
    const double b10_z_3 = b9_y * W0_x;
    const double b10_z_4 = b10_z_2 - b10_z_3;
    const double b10_z_5 = b8_x * W1_y;
    const double b10_z_6 = b10_z_4 + b10_z_5;
    const double b10_z_7 = b8_y * W1_x;
    const double b10_z_8 = b10_z_6 - b10_z_7;
    const double b10_z_9 = b7_x * W2_y;
    const double b10_z_10 = b10_z_8 + b10_z_9;
    const double b10_z_11 = b7_y * W2_x;
    const double b10_z_12 = b10_z_10 - b10_z_11;
    const double b10_x = 0.1 /* 1/10 */ * b10_x_12;
    const double db_x = db_x_8 + b10_x;
    const double b10_y = 0.1 /* 1/10 */ * b10_y_12;
    const double db_y = db_y_8 + b10_y;
    const double b10_z = 0.1 /* 1/10 */ * b10_z_12;
    const double db_z = db_z_8 + b10_z;

    /* e_a = (1 - |a|^2)/2   [re-orthogonalisation of the rows a, b] */
    const double e_a_1 = c_11 * c_11;
    const double e_a_2 = c_12 * c_12;
    const double e_a_3 = c_13 * c_13;
    const double e_a_4 = e_a_1 + e_a_2;
    const double e_a_5 = e_a_4 + e_a_3;
    const double e_a_6 = 1.0 - e_a_5;
    const double e_a = 0.5 * e_a_6;

    /* e_b = (1 - |b|^2)/2   [re-orthogonalisation of the rows a, b] */
    const double e_b_1 = c_21 * c_21;
    const double e_b_2 = c_22 * c_22;
    const double e_b_3 = c_23 * c_23;
    const double e_b_4 = e_b_1 + e_b_2;
    const double e_b_5 = e_b_4 + e_b_3;
    const double e_b_6 = 1.0 - e_b_5;
    const double e_b = 0.5 * e_b_6;

    /* e_ab = a . b   [re-orthogonalisation of the rows a, b] */
    const double e_ab_1 = c_11 * c_21;
    const double e_ab_2 = c_12 * c_22;
    const double e_ab_3 = c_13 * c_23;
    const double e_ab_4 = e_ab_1 + e_ab_2;
    const double e_ab = e_ab_4 + e_ab_3;

    /* da_e = da + e_a a */
    const double da_e_x_1 = e_a * c_11;
    const double da_e_y_1 = e_a * c_12;
    const double da_e_z_1 = e_a * c_13;
    const double da_e_x = da_x + da_e_x_1;
    const double da_e_y = da_y + da_e_y_1;
    const double da_e_z = da_z + da_e_z_1;

    /* db_e = db + e_b b - e_ab a */
    const double db_e_x_1 = e_b * c_21;
    const double db_e_y_1 = e_b * c_22;
    const double db_e_z_1 = e_b * c_23;
    const double db_e_x_2 = db_x + db_e_x_1;
    const double db_e_y_2 = db_y + db_e_y_1;
    const double db_e_z_2 = db_z + db_e_z_1;
    const double db_e_x_3 = e_ab * c_11;
    const double db_e_y_3 = e_ab * c_12;
    const double db_e_z_3 = e_ab * c_13;
    const double db_e_x = db_e_x_2 - db_e_x_3;
    const double db_e_y = db_e_y_2 - db_e_y_3;
    const double db_e_z = db_e_z_2 - db_e_z_3;

    /* a_next = a + da */
    const double a_next_x = c_11 + da_e_x;
    const double a_next_y = c_12 + da_e_y;
    const double a_next_z = c_13 + da_e_z;

    /* b_next = b + db */
    const double b_next_x = c_21 + db_e_x;
    const double b_next_y = c_22 + db_e_y;
    const double b_next_z = c_23 + db_e_z;

    /* c_next = a_next x b_next */
    const double c_next_x_1 = a_next_y * b_next_z;
    const double c_next_x_2 = a_next_z * b_next_y;
    const double c_next_x = c_next_x_1 - c_next_x_2;
    const double c_next_y_1 = a_next_z * b_next_x;
    const double c_next_y_2 = a_next_x * b_next_z;
    const double c_next_y = c_next_y_1 - c_next_y_2;
    const double c_next_z_1 = a_next_x * b_next_y;
    const double c_next_z_2 = a_next_y * b_next_x;
    const double c_next_z = c_next_z_1 - c_next_z_2;

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

void dcm_taylor_3_10_euler_float64_quaternion(
    const dcm_taylor_3_10_euler_float64_state *state, double q_nb[4])
{
    /* c, read once */
    const double c_11 = state->c[0];
    const double c_12 = state->c[1];
    const double c_13 = state->c[2];
    const double c_21 = state->c[3];
    const double c_22 = state->c[4];
    const double c_23 = state->c[5];
    const double c_31 = state->c[6];
    const double c_32 = state->c[7];
    const double c_33 = state->c[8];

    /* ww = 4 w w, wx = 4 w x and so on   [Shepperd 1978] */
    const double largest_1 = c_11 - c_22;
    const double largest_2 = largest_1 - c_33;
    const double largest_3 = largest_2 + 1.0;
    const double largest_4 = c_22 - c_11;
    const double largest_5 = largest_4 - c_33;
    const double largest_6 = largest_5 + 1.0;
    const double largest_7 = c_33 - c_11;
    const double largest_8 = largest_7 - c_22;
    const double largest_9 = largest_8 + 1.0;
    const double trace_1 = c_11 + c_22;
    const double trace = trace_1 + c_33;
    const double ww = trace + 1.0;
    const double wx = c_32 - c_23;
    const double wy = c_13 - c_31;
    const double wz = c_21 - c_12;
    const double xy = c_12 + c_21;
    const double xz = c_13 + c_31;
    const double yz = c_23 + c_32;

    /* largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z   [Shepperd 1978] */
    const int32_t largest_10 = ww < largest_3;
    const double largest_11 = (largest_10 != 0) ? largest_3 : ww;
    const double q_nb_w_1 = (largest_10 != 0) ? wx : ww;
    const double q_nb_x_1 = (largest_10 != 0) ? largest_3 : wx;
    const double q_nb_y_1 = (largest_10 != 0) ? xy : wy;
    const double q_nb_z_1 = (largest_10 != 0) ? xz : wz;
    const int32_t largest_12 = largest_11 < largest_6;
    const double largest_13 = (largest_12 != 0) ? largest_6 : largest_11;
    const double q_nb_w_2 = (largest_12 != 0) ? wy : q_nb_w_1;
    const double q_nb_x_2 = (largest_12 != 0) ? xy : q_nb_x_1;
    const double q_nb_y_2 = (largest_12 != 0) ? largest_6 : q_nb_y_1;
    const double q_nb_z_2 = (largest_12 != 0) ? yz : q_nb_z_1;
    const int32_t largest_14 = largest_13 < largest_9;
    const double largest = (largest_14 != 0) ? largest_9 : largest_13;
    const double q_nb_w_3 = (largest_14 != 0) ? wz : q_nb_w_2;
    const double q_nb_x_3 = (largest_14 != 0) ? xz : q_nb_x_2;
    const double q_nb_y_3 = (largest_14 != 0) ? yz : q_nb_y_2;
    const double q_nb_z_3 = (largest_14 != 0) ? largest_9 : q_nb_z_2;

    /* scale = 1/(2 sqrt(largest)) */
    const double scale_1 = largest * 0.00018971865870298643 /* 834391485/4398046511104 */;
    const double scale_2 = -0.004294917113327301 /* -75556980903/17592186044416 */ + scale_1;
    const double scale_3 = largest * scale_2;
    const double scale_4 = 0.042329438021056376 /* 372333674411/8796093022208 */ + scale_3;
    const double scale_5 = largest * scale_4;
    const double scale_6 = -0.23826869500408066 /* -65494800173/274877906944 */ + scale_5;
    const double scale_7 = largest * scale_6;
    const double scale_8 = 0.8445661107319893 /* 7428882073403/8796093022208 */ + scale_7;
    const double scale_9 = largest * scale_8;
    const double scale_10 = -1.9604098645106092 /* -34487895059779/17592186044416 */ + scale_9;
    const double scale_11 = largest * scale_10;
    const double scale_12 = 3.0078762989989514 /* 52915119450579/17592186044416 */ + scale_11;
    const double scale_13 = largest * scale_12;
    const double scale_14 = -3.045469355495527 /* -53576463494445/17592186044416 */ + scale_13;
    const double scale_15 = largest * scale_14;
    const double scale_16 = 2.3534559481227575 /* 41402434886713/17592186044416 */ + scale_15;
    const double scale_17 = 0.5 * scale_16;
    const double scale_18 = scale_16 * scale_16;
    const double scale_19 = largest * scale_18;
    const double scale_20 = 1.0 - scale_19;
    const double scale_21 = scale_17 * scale_20;
    const double scale_22 = scale_16 + scale_21;
    const double scale_23 = 0.5 * scale_22;
    const double scale_24 = scale_22 * scale_22;
    const double scale_25 = largest * scale_24;
    const double scale_26 = 1.0 - scale_25;
    const double scale_27 = scale_23 * scale_26;
    const double scale_28 = scale_22 + scale_27;
    const double scale = 0.5 * scale_28;

    /* q_nb = scale (its row)   [Shepperd 1978] */
    const double q_nb_w = scale * q_nb_w_3;
    const double q_nb_x = scale * q_nb_x_3;
    const double q_nb_y = scale * q_nb_y_3;
    const double q_nb_z = scale * q_nb_z_3;

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void dcm_taylor_3_10_euler_float64_dcm(const dcm_taylor_3_10_euler_float64_state *state, double c_nb[9])
{
    /* c, read once */
    const double c_11 = state->c[0];
    const double c_12 = state->c[1];
    const double c_13 = state->c[2];
    const double c_21 = state->c[3];
    const double c_22 = state->c[4];
    const double c_23 = state->c[5];
    const double c_31 = state->c[6];
    const double c_32 = state->c[7];
    const double c_33 = state->c[8];

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

void dcm_taylor_3_10_euler_float64_euler(const dcm_taylor_3_10_euler_float64_state *state, double rpy[3])
{
    /* c, read once */
    const double c_11 = state->c[0];
    const double c_12 = state->c[1];
    const double c_13 = state->c[2];
    const double c_21 = state->c[3];
    const double c_22 = state->c[4];
    const double c_23 = state->c[5];
    const double c_31 = state->c[6];
    const double c_32 = state->c[7];
    const double c_33 = state->c[8];

    /* ww = 4 w w, wx = 4 w x and so on   [Shepperd 1978] */
    const double largest_1 = c_11 - c_22;
    const double largest_2 = largest_1 - c_33;
    const double largest_3 = largest_2 + 1.0;
    const double largest_4 = c_22 - c_11;
    const double largest_5 = largest_4 - c_33;
    const double largest_6 = largest_5 + 1.0;
    const double largest_7 = c_33 - c_11;
    const double largest_8 = largest_7 - c_22;
    const double largest_9 = largest_8 + 1.0;
    const double trace_1 = c_11 + c_22;
    const double trace = trace_1 + c_33;
    const double ww = trace + 1.0;
    const double wx = c_32 - c_23;
    const double wy = c_13 - c_31;
    const double wz = c_21 - c_12;
    const double xy = c_12 + c_21;
    const double xz = c_13 + c_31;
    const double yz = c_23 + c_32;

    /* largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z   [Shepperd 1978] */
    const int32_t largest_10 = ww < largest_3;
    const double largest_11 = (largest_10 != 0) ? largest_3 : ww;
    const double q_nb_w_1 = (largest_10 != 0) ? wx : ww;
    const double q_nb_x_1 = (largest_10 != 0) ? largest_3 : wx;
    const double q_nb_y_1 = (largest_10 != 0) ? xy : wy;
    const double q_nb_z_1 = (largest_10 != 0) ? xz : wz;
    const int32_t largest_12 = largest_11 < largest_6;
    const double largest_13 = (largest_12 != 0) ? largest_6 : largest_11;
    const double q_nb_w_2 = (largest_12 != 0) ? wy : q_nb_w_1;
    const double q_nb_x_2 = (largest_12 != 0) ? xy : q_nb_x_1;
    const double q_nb_y_2 = (largest_12 != 0) ? largest_6 : q_nb_y_1;
    const double q_nb_z_2 = (largest_12 != 0) ? yz : q_nb_z_1;
    const int32_t largest_14 = largest_13 < largest_9;
    const double largest = (largest_14 != 0) ? largest_9 : largest_13;
    const double q_nb_w_3 = (largest_14 != 0) ? wz : q_nb_w_2;
    const double q_nb_x_3 = (largest_14 != 0) ? xz : q_nb_x_2;
    const double q_nb_y_3 = (largest_14 != 0) ? yz : q_nb_y_2;
    const double q_nb_z_3 = (largest_14 != 0) ? largest_9 : q_nb_z_2;

    /* scale = 1/(2 sqrt(largest)) */
    const double scale_1 = largest * 0.00018971865870298643 /* 834391485/4398046511104 */;
    const double scale_2 = -0.004294917113327301 /* -75556980903/17592186044416 */ + scale_1;
    const double scale_3 = largest * scale_2;
    const double scale_4 = 0.042329438021056376 /* 372333674411/8796093022208 */ + scale_3;
    const double scale_5 = largest * scale_4;
    const double scale_6 = -0.23826869500408066 /* -65494800173/274877906944 */ + scale_5;
    const double scale_7 = largest * scale_6;
    const double scale_8 = 0.8445661107319893 /* 7428882073403/8796093022208 */ + scale_7;
    const double scale_9 = largest * scale_8;
    const double scale_10 = -1.9604098645106092 /* -34487895059779/17592186044416 */ + scale_9;
    const double scale_11 = largest * scale_10;
    const double scale_12 = 3.0078762989989514 /* 52915119450579/17592186044416 */ + scale_11;
    const double scale_13 = largest * scale_12;
    const double scale_14 = -3.045469355495527 /* -53576463494445/17592186044416 */ + scale_13;
    const double scale_15 = largest * scale_14;
    const double scale_16 = 2.3534559481227575 /* 41402434886713/17592186044416 */ + scale_15;
    const double scale_17 = 0.5 * scale_16;
    const double scale_18 = scale_16 * scale_16;
    const double scale_19 = largest * scale_18;
    const double scale_20 = 1.0 - scale_19;
    const double scale_21 = scale_17 * scale_20;
    const double scale_22 = scale_16 + scale_21;
    const double scale_23 = 0.5 * scale_22;
    const double scale_24 = scale_22 * scale_22;
    const double scale_25 = largest * scale_24;
    const double scale_26 = 1.0 - scale_25;
    const double scale_27 = scale_23 * scale_26;
    const double scale_28 = scale_22 + scale_27;
    const double scale = 0.5 * scale_28;

    /* q_nb = scale (its row)   [Shepperd 1978] */
    const double q_nb_w = scale * q_nb_w_3;
    const double q_nb_x = scale * q_nb_x_3;
    const double q_nb_y = scale * q_nb_y_3;
    const double q_nb_z = scale * q_nb_z_3;

    /* half_sum = (yaw + roll)/2   [zyx] */
    const double half_sum_1 = q_nb_z + q_nb_x;
    const double half_sum_2 = q_nb_w - q_nb_y;
    const double half_difference_1 = q_nb_z - q_nb_x;
    const double half_difference_2 = q_nb_w + q_nb_y;
    const int32_t half_sum_3 = half_sum_1 < 0.0;
    const double half_sum_4 = -half_sum_1;
    const double half_sum_5 = (half_sum_3 != 0) ? half_sum_4 : half_sum_1;
    const int32_t half_sum_6 = half_sum_2 < 0.0;
    const double half_sum_7 = -half_sum_2;
    const double half_sum_8 = (half_sum_6 != 0) ? half_sum_7 : half_sum_2;
    const int32_t half_sum_9 = half_sum_8 < half_sum_5;
    const double half_sum_10 = (half_sum_9 != 0) ? half_sum_8 : half_sum_5;
    const double half_sum_11 = (half_sum_9 != 0) ? half_sum_5 : half_sum_8;
    const double half_sum_12 = 0.41421356 /* 10355339/25000000 */ * half_sum_11;
    const int32_t half_sum_13 = half_sum_12 < half_sum_10;
    const double half_sum_14 = half_sum_10 - half_sum_11;
    const double half_sum_15 = (half_sum_13 != 0) ? half_sum_14 : half_sum_10;
    const double half_sum_16 = half_sum_10 + half_sum_11;
    const double half_sum_17 = (half_sum_13 != 0) ? half_sum_16 : half_sum_11;
    const double half_sum_18 = 1.424047269444609e-306 * half_sum_11;
    const int32_t half_sum_19 = half_sum_18 < half_sum_10;
    const double half_sum_20 = (half_sum_19 != 0) ? half_sum_15 : 0.0;
    const double half_sum_21 = (half_sum_19 != 0) ? half_sum_17 : 1.0;
    const double half_sum_22 = half_sum_20 / half_sum_21;
    const double half_sum_23 = half_sum_22 * half_sum_22;
    const double half_sum_24 = half_sum_23 * 0.020659271935216498 /* 9646/466909 */;
    const double half_sum_25 = -0.04305880762135514 /* -31207/724753 */ + half_sum_24;
    const double half_sum_26 = half_sum_23 * half_sum_25;
    const double half_sum_27 = 0.05672404505505705 /* 23377/412118 */ + half_sum_26;
    const double half_sum_28 = half_sum_23 * half_sum_27;
    const double half_sum_29 = -0.0663687889326335 /* -210670/3174233 */ + half_sum_28;
    const double half_sum_30 = half_sum_23 * half_sum_29;
    const double half_sum_31 = 0.07689524235639426 /* 1143921/14876356 */ + half_sum_30;
    const double half_sum_32 = half_sum_23 * half_sum_31;
    const double half_sum_33 = -0.09090738837093491 /* -1364005/15004336 */ + half_sum_32;
    const double half_sum_34 = half_sum_23 * half_sum_33;
    const double half_sum_35 = 0.11111104505111347 /* 5793458/52141153 */ + half_sum_34;
    const double half_sum_36 = half_sum_23 * half_sum_35;
    const double half_sum_37 = -0.14285714133630667 /* -13419041/93933288 */ + half_sum_36;
    const double half_sum_38 = half_sum_23 * half_sum_37;
    const double half_sum_39 = 0.19999999998182857 /* 2201258242/11006291211 */ + half_sum_38;
    const double half_sum_40 = half_sum_23 * half_sum_39;
    const double half_sum_41 = -0.3333333333332519 /* -1364136838384/4092410515153 */ + half_sum_40;
    const double half_sum_42 = half_sum_23 * half_sum_41;
    const double half_sum_43 = half_sum_22 * half_sum_42;
    const double half_sum_44 = half_sum_22 + half_sum_43;
    const double half_sum_45 = 0.7853981633974483 + half_sum_44;
    const double half_sum_46 = (half_sum_13 != 0) ? half_sum_45 : half_sum_44;
    const double half_sum_47 = 1.5707963267948966 - half_sum_46;
    const double half_sum_48 = (half_sum_9 != 0) ? half_sum_47 : half_sum_46;
    const double half_sum_49 = 3.141592653589793 - half_sum_48;
    const double half_sum_50 = (half_sum_6 != 0) ? half_sum_49 : half_sum_48;
    const double half_sum_51 = -half_sum_50;
    const double half_sum = (half_sum_3 != 0) ? half_sum_51 : half_sum_50;

    /* half_difference = (yaw - roll)/2   [zyx] */
    const int32_t half_difference_3 = half_difference_1 < 0.0;
    const double half_difference_4 = -half_difference_1;
    const double half_difference_5 = (half_difference_3 != 0) ? half_difference_4 : half_difference_1;
    const int32_t half_difference_6 = half_difference_2 < 0.0;
    const double half_difference_7 = -half_difference_2;
    const double half_difference_8 = (half_difference_6 != 0) ? half_difference_7 : half_difference_2;
    const int32_t half_difference_9 = half_difference_8 < half_difference_5;
    const double half_difference_10 = (half_difference_9 != 0) ? half_difference_8 : half_difference_5;
    const double half_difference_11 = (half_difference_9 != 0) ? half_difference_5 : half_difference_8;
    const double half_difference_12 = 0.41421356 /* 10355339/25000000 */ * half_difference_11;
    const int32_t half_difference_13 = half_difference_12 < half_difference_10;
    const double half_difference_14 = half_difference_10 - half_difference_11;
    const double half_difference_15 = (half_difference_13 != 0) ? half_difference_14 : half_difference_10;
    const double half_difference_16 = half_difference_10 + half_difference_11;
    const double half_difference_17 = (half_difference_13 != 0) ? half_difference_16 : half_difference_11;
    const double half_difference_18 = 1.424047269444609e-306 * half_difference_11;
    const int32_t half_difference_19 = half_difference_18 < half_difference_10;
    const double half_difference_20 = (half_difference_19 != 0) ? half_difference_15 : 0.0;
    const double half_difference_21 = (half_difference_19 != 0) ? half_difference_17 : 1.0;
    const double half_difference_22 = half_difference_20 / half_difference_21;
    const double half_difference_23 = half_difference_22 * half_difference_22;
    const double half_difference_24 = half_difference_23 * 0.020659271935216498 /* 9646/466909 */;
    const double half_difference_25 = -0.04305880762135514 /* -31207/724753 */ + half_difference_24;
    const double half_difference_26 = half_difference_23 * half_difference_25;
    const double half_difference_27 = 0.05672404505505705 /* 23377/412118 */ + half_difference_26;
    const double half_difference_28 = half_difference_23 * half_difference_27;
    const double half_difference_29 = -0.0663687889326335 /* -210670/3174233 */ + half_difference_28;
    const double half_difference_30 = half_difference_23 * half_difference_29;
    const double half_difference_31 = 0.07689524235639426 /* 1143921/14876356 */ + half_difference_30;
    const double half_difference_32 = half_difference_23 * half_difference_31;
    const double half_difference_33 = -0.09090738837093491 /* -1364005/15004336 */ + half_difference_32;
    const double half_difference_34 = half_difference_23 * half_difference_33;
    const double half_difference_35 = 0.11111104505111347 /* 5793458/52141153 */ + half_difference_34;
    const double half_difference_36 = half_difference_23 * half_difference_35;
    const double half_difference_37 = -0.14285714133630667 /* -13419041/93933288 */ + half_difference_36;
    const double half_difference_38 = half_difference_23 * half_difference_37;
    const double half_difference_39 = 0.19999999998182857 /* 2201258242/11006291211 */ + half_difference_38;
    const double half_difference_40 = half_difference_23 * half_difference_39;
    const double half_difference_41 = -0.3333333333332519 /* -1364136838384/4092410515153 */ + half_difference_40;
    const double half_difference_42 = half_difference_23 * half_difference_41;
    const double half_difference_43 = half_difference_22 * half_difference_42;
    const double half_difference_44 = half_difference_22 + half_difference_43;
    const double half_difference_45 = 0.7853981633974483 + half_difference_44;
    const double half_difference_46 = (half_difference_13 != 0) ? half_difference_45 : half_difference_44;
    const double half_difference_47 = 1.5707963267948966 - half_difference_46;
    const double half_difference_48 = (half_difference_9 != 0) ? half_difference_47 : half_difference_46;
    const double half_difference_49 = 3.141592653589793 - half_difference_48;
    const double half_difference_50 = (half_difference_6 != 0) ? half_difference_49 : half_difference_48;
    const double half_difference_51 = -half_difference_50;
    const double half_difference = (half_difference_3 != 0) ? half_difference_51 : half_difference_50;

    /* up = square of the numerator of tan(pitch/2 + pi/4) */
    const double up_1 = half_difference_2 * half_difference_2;
    const double up_2 = half_difference_1 * half_difference_1;
    const double up = up_1 + up_2;

    /* down = square of its denominator */
    const double down_1 = half_sum_2 * half_sum_2;
    const double down_2 = half_sum_1 * half_sum_1;
    const double down = down_1 + down_2;

    /* pitch = 2 atan(sqrt(up/down)) - pi/2   [zyx] */
    const int32_t pitch_1 = down < up;
    const double pitch_2 = (pitch_1 != 0) ? down : up;
    const double pitch_3 = (pitch_1 != 0) ? up : down;
    const double pitch_4 = 1.424047269444609e-306 * pitch_3;
    const int32_t pitch_5 = pitch_4 < pitch_2;
    const double pitch_6 = (pitch_5 != 0) ? pitch_2 : 0.0;
    const double pitch_7 = (pitch_5 != 0) ? pitch_3 : 1.0;
    const double pitch_8 = pitch_6 / pitch_7;
    const double pitch_9 = 0.25 * pitch_8;
    const int32_t pitch_10 = pitch_9 < 5.421010862427522e-20 /* 1/18446744073709551616 */;
    const double pitch_11 = 1.8446744073709552e+19 * pitch_9;
    const double pitch_12 = (pitch_10 != 0) ? pitch_11 : pitch_9;
    const double pitch_13 = (pitch_10 != 0) ? 1.1641532182693481e-10 /* 1/8589934592 */ : 0.5;
    const int32_t pitch_14 = pitch_12 < 2.3283064365386963e-10 /* 1/4294967296 */;
    const double pitch_15 = 4294967296.0 * pitch_12;
    const double pitch_16 = (pitch_14 != 0) ? pitch_15 : pitch_12;
    const double pitch_17 = 1.52587890625e-05 /* 1/65536 */ * pitch_13;
    const double pitch_18 = (pitch_14 != 0) ? pitch_17 : pitch_13;
    const int32_t pitch_19 = pitch_16 < 1.52587890625e-05 /* 1/65536 */;
    const double pitch_20 = 65536.0 * pitch_16;
    const double pitch_21 = (pitch_19 != 0) ? pitch_20 : pitch_16;
    const double pitch_22 = 0.00390625 /* 1/256 */ * pitch_18;
    const double pitch_23 = (pitch_19 != 0) ? pitch_22 : pitch_18;
    const int32_t pitch_24 = pitch_21 < 0.00390625 /* 1/256 */;
    const double pitch_25 = 256.0 * pitch_21;
    const double pitch_26 = (pitch_24 != 0) ? pitch_25 : pitch_21;
    const double pitch_27 = 0.0625 /* 1/16 */ * pitch_23;
    const double pitch_28 = (pitch_24 != 0) ? pitch_27 : pitch_23;
    const int32_t pitch_29 = pitch_26 < 0.0625 /* 1/16 */;
    const double pitch_30 = 16.0 * pitch_26;
    const double pitch_31 = (pitch_29 != 0) ? pitch_30 : pitch_26;
    const double pitch_32 = 0.25 * pitch_28;
    const double pitch_33 = (pitch_29 != 0) ? pitch_32 : pitch_28;
    const int32_t pitch_34 = pitch_31 < 0.25;
    const double pitch_35 = 4.0 * pitch_31;
    const double pitch_36 = (pitch_34 != 0) ? pitch_35 : pitch_31;
    const double pitch_37 = 0.5 * pitch_33;
    const double pitch_38 = (pitch_34 != 0) ? pitch_37 : pitch_33;
    const double pitch_39 = 4.0 * pitch_36;
    const double pitch_40 = pitch_39 * 0.00018971865870298643 /* 834391485/4398046511104 */;
    const double pitch_41 = -0.004294917113327301 /* -75556980903/17592186044416 */ + pitch_40;
    const double pitch_42 = pitch_39 * pitch_41;
    const double pitch_43 = 0.042329438021056376 /* 372333674411/8796093022208 */ + pitch_42;
    const double pitch_44 = pitch_39 * pitch_43;
    const double pitch_45 = -0.23826869500408066 /* -65494800173/274877906944 */ + pitch_44;
    const double pitch_46 = pitch_39 * pitch_45;
    const double pitch_47 = 0.8445661107319893 /* 7428882073403/8796093022208 */ + pitch_46;
    const double pitch_48 = pitch_39 * pitch_47;
    const double pitch_49 = -1.9604098645106092 /* -34487895059779/17592186044416 */ + pitch_48;
    const double pitch_50 = pitch_39 * pitch_49;
    const double pitch_51 = 3.0078762989989514 /* 52915119450579/17592186044416 */ + pitch_50;
    const double pitch_52 = pitch_39 * pitch_51;
    const double pitch_53 = -3.045469355495527 /* -53576463494445/17592186044416 */ + pitch_52;
    const double pitch_54 = pitch_39 * pitch_53;
    const double pitch_55 = 2.3534559481227575 /* 41402434886713/17592186044416 */ + pitch_54;
    const double pitch_56 = 0.5 * pitch_55;
    const double pitch_57 = pitch_55 * pitch_55;
    const double pitch_58 = pitch_39 * pitch_57;
    const double pitch_59 = 1.0 - pitch_58;
    const double pitch_60 = pitch_56 * pitch_59;
    const double pitch_61 = pitch_55 + pitch_60;
    const double pitch_62 = 0.5 * pitch_61;
    const double pitch_63 = pitch_61 * pitch_61;
    const double pitch_64 = pitch_39 * pitch_63;
    const double pitch_65 = 1.0 - pitch_64;
    const double pitch_66 = pitch_62 * pitch_65;
    const double pitch_67 = pitch_61 + pitch_66;
    const double pitch_68 = pitch_39 * pitch_67;
    const double pitch_69 = pitch_68 * pitch_38;
    const double pitch_70 = 2.0 * pitch_69;
    const int32_t pitch_71 = pitch_70 < 0.0;
    const double pitch_72 = -pitch_70;
    const double pitch_73 = (pitch_71 != 0) ? pitch_72 : pitch_70;
    const int32_t pitch_74 = 1.0 < 0.0;
    const double pitch_75 = (pitch_74 != 0) ? -1.0 : 1.0;
    const int32_t pitch_76 = pitch_75 < pitch_73;
    const double pitch_77 = (pitch_76 != 0) ? pitch_75 : pitch_73;
    const double pitch_78 = (pitch_76 != 0) ? pitch_73 : pitch_75;
    const double pitch_79 = 0.41421356 /* 10355339/25000000 */ * pitch_78;
    const int32_t pitch_80 = pitch_79 < pitch_77;
    const double pitch_81 = pitch_77 - pitch_78;
    const double pitch_82 = (pitch_80 != 0) ? pitch_81 : pitch_77;
    const double pitch_83 = pitch_77 + pitch_78;
    const double pitch_84 = (pitch_80 != 0) ? pitch_83 : pitch_78;
    const double pitch_85 = 1.424047269444609e-306 * pitch_78;
    const int32_t pitch_86 = pitch_85 < pitch_77;
    const double pitch_87 = (pitch_86 != 0) ? pitch_82 : 0.0;
    const double pitch_88 = (pitch_86 != 0) ? pitch_84 : 1.0;
    const double pitch_89 = pitch_87 / pitch_88;
    const double pitch_90 = pitch_89 * pitch_89;
    const double pitch_91 = pitch_90 * 0.020659271935216498 /* 9646/466909 */;
    const double pitch_92 = -0.04305880762135514 /* -31207/724753 */ + pitch_91;
    const double pitch_93 = pitch_90 * pitch_92;
    const double pitch_94 = 0.05672404505505705 /* 23377/412118 */ + pitch_93;
    const double pitch_95 = pitch_90 * pitch_94;
    const double pitch_96 = -0.0663687889326335 /* -210670/3174233 */ + pitch_95;
    const double pitch_97 = pitch_90 * pitch_96;
    const double pitch_98 = 0.07689524235639426 /* 1143921/14876356 */ + pitch_97;
    const double pitch_99 = pitch_90 * pitch_98;
    const double pitch_100 = -0.09090738837093491 /* -1364005/15004336 */ + pitch_99;
    const double pitch_101 = pitch_90 * pitch_100;
    const double pitch_102 = 0.11111104505111347 /* 5793458/52141153 */ + pitch_101;
    const double pitch_103 = pitch_90 * pitch_102;
    const double pitch_104 = -0.14285714133630667 /* -13419041/93933288 */ + pitch_103;
    const double pitch_105 = pitch_90 * pitch_104;
    const double pitch_106 = 0.19999999998182857 /* 2201258242/11006291211 */ + pitch_105;
    const double pitch_107 = pitch_90 * pitch_106;
    const double pitch_108 = -0.3333333333332519 /* -1364136838384/4092410515153 */ + pitch_107;
    const double pitch_109 = pitch_90 * pitch_108;
    const double pitch_110 = pitch_89 * pitch_109;
    const double pitch_111 = pitch_89 + pitch_110;
    const double pitch_112 = 0.7853981633974483 + pitch_111;
    const double pitch_113 = (pitch_80 != 0) ? pitch_112 : pitch_111;
    const double pitch_114 = 1.5707963267948966 - pitch_113;
    const double pitch_115 = (pitch_76 != 0) ? pitch_114 : pitch_113;
    const double pitch_116 = 3.141592653589793 - pitch_115;
    const double pitch_117 = (pitch_74 != 0) ? pitch_116 : pitch_115;
    const double pitch_118 = -pitch_117;
    const double pitch_119 = (pitch_71 != 0) ? pitch_118 : pitch_117;
    const double pitch_120 = pitch_119 + pitch_119;
    const double pitch_121 = 1.5707963267948966 - pitch_120;
    const double pitch_122 = -pitch_121;
    const double pitch = (pitch_1 != 0) ? pitch_121 : pitch_122;

    /* roll = half_sum - half_difference, in [-pi, pi] */
    const double roll_1 = half_sum - half_difference;
    const int32_t roll_2 = 3.141592653589793 < roll_1;
    const double roll_3 = roll_1 - 6.283185307179586;
    const double roll_4 = (roll_2 != 0) ? roll_3 : roll_1;
    const int32_t roll_5 = roll_4 < -3.141592653589793;
    const double roll_6 = roll_4 + 6.283185307179586;
    const double roll = (roll_5 != 0) ? roll_6 : roll_4;

    /* yaw = half_sum + half_difference, in [-pi, pi] */
    const double yaw_1 = half_sum + half_difference;
    const int32_t yaw_2 = 3.141592653589793 < yaw_1;
    const double yaw_3 = yaw_1 - 6.283185307179586;
    const double yaw_4 = (yaw_2 != 0) ? yaw_3 : yaw_1;
    const int32_t yaw_5 = yaw_4 < -3.141592653589793;
    const double yaw_6 = yaw_4 + 6.283185307179586;
    const double yaw = (yaw_5 != 0) ? yaw_6 : yaw_4;

    rpy[0] = roll;
    rpy[1] = pitch;
    rpy[2] = yaw;
}
