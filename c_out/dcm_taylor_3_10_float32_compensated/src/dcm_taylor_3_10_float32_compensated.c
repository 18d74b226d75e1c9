/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_float32_compensated
 *
 * qcone 0.1.0, design dcm_taylor_3_10_float32_compensated, SHA-256 of the design
 * 6d8fe13cc3ca45a0fe3064a7d5b3fb56f9a49aad7cd64e367637331d449104f4
 *
 * algorithm:   dcm-taylor-3-10, form factored, C' = C + dC, two rows and their cross product, the
 *              rounding carried to the next update (Kahan), re-orthogonalised by a call
 * source:      xu2019 (10) to (13), (11) and (13) corrected; xu2019 (11) multiplies from the wrong
 *              side; xu2019 (13) lacks the constants 1, 2, 6
 * equation:    v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j, row by row
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
 * update as-written      453       0  273       192       0       0     0     0     0       0
 * update shared          381      18  240       192       0       0     0     0     0       0
 * update emitted         381      18  240       192       0       0     0     0     0       0
 * dcm as-written           0       0    0         0       0       0     0     0     0       0
 * dcm shared               0       0    0         6       0       0     0     0     0       0
 * dcm emitted              0       0    0         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "dcm_taylor_3_10_float32_compensated.h"

#if DCM_TAYLOR_3_10_FLOAT32_COMPENSATED_VERSION != 1
#error "dcm_taylor_3_10_float32_compensated.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void dcm_taylor_3_10_float32_compensated_init(dcm_taylor_3_10_float32_compensated_state *state)
{
    state->c[0] = 1.0F;
    state->c[1] = 0.0F;
    state->c[2] = 0.0F;
    state->c[3] = 0.0F;
    state->c[4] = 1.0F;
    state->c[5] = 0.0F;
    state->c[6] = 0.0F;
    state->c[7] = 0.0F;
    state->c[8] = 1.0F;
    state->residual[0] = 0.0F;
    state->residual[1] = 0.0F;
    state->residual[2] = 0.0F;
    state->residual[3] = 0.0F;
    state->residual[4] = 0.0F;
    state->residual[5] = 0.0F;
}

void dcm_taylor_3_10_float32_compensated_set_dcm(
    dcm_taylor_3_10_float32_compensated_state *state, const float c_nb[9])
{
    /* c_nb, read once */
    const float c_nb_11 = c_nb[0];
    const float c_nb_12 = c_nb[1];
    const float c_nb_13 = c_nb[2];
    const float c_nb_21 = c_nb[3];
    const float c_nb_22 = c_nb[4];
    const float c_nb_23 = c_nb[5];

    /* e_a = (1 - |a|^2)/2 */
    const float e_a_1 = c_nb_11 * c_nb_11;
    const float e_a_2 = c_nb_12 * c_nb_12;
    const float e_a_3 = c_nb_13 * c_nb_13;
    const float e_a_4 = e_a_1 + e_a_2;
    const float e_a_5 = e_a_4 + e_a_3;
    const float e_a_6 = 1.0F - e_a_5;
    const float e_a = 0.5F * e_a_6;

    /* e_b = (1 - |b|^2)/2 */
    const float e_b_1 = c_nb_21 * c_nb_21;
    const float e_b_2 = c_nb_22 * c_nb_22;
    const float e_b_3 = c_nb_23 * c_nb_23;
    const float e_b_4 = e_b_1 + e_b_2;
    const float e_b_5 = e_b_4 + e_b_3;
    const float e_b_6 = 1.0F - e_b_5;
    const float e_b = 0.5F * e_b_6;

    /* e_ab = a . b */
    const float e_ab_1 = c_nb_11 * c_nb_21;
    const float e_ab_2 = c_nb_12 * c_nb_22;
    const float e_ab_3 = c_nb_13 * c_nb_23;
    const float e_ab_4 = e_ab_1 + e_ab_2;
    const float e_ab = e_ab_4 + e_ab_3;

    /* a_next = a + e_a a */
    const float a_next_x_1 = e_a * c_nb_11;
    const float a_next_y_1 = e_a * c_nb_12;
    const float a_next_z_1 = e_a * c_nb_13;
    const float a_next_x = c_nb_11 + a_next_x_1;
    const float a_next_y = c_nb_12 + a_next_y_1;
    const float a_next_z = c_nb_13 + a_next_z_1;

    /* b_next = b + e_b b - e_ab a */
    const float b_next_x_1 = e_b * c_nb_21;
    const float b_next_y_1 = e_b * c_nb_22;
    const float b_next_z_1 = e_b * c_nb_23;
    const float b_next_x_2 = c_nb_21 + b_next_x_1;
    const float b_next_y_2 = c_nb_22 + b_next_y_1;
    const float b_next_z_2 = c_nb_23 + b_next_z_1;
    const float b_next_x_3 = e_ab * c_nb_11;
    const float b_next_y_3 = e_ab * c_nb_12;
    const float b_next_z_3 = e_ab * c_nb_13;
    const float b_next_x = b_next_x_2 - b_next_x_3;
    const float b_next_y = b_next_y_2 - b_next_y_3;
    const float b_next_z = b_next_z_2 - b_next_z_3;

    /* c_next = a_next x b_next */
    const float c_next_x_1 = a_next_y * b_next_z;
    const float c_next_x_2 = a_next_z * b_next_y;
    const float c_next_x = c_next_x_1 - c_next_x_2;
    const float c_next_y_1 = a_next_z * b_next_x;
    const float c_next_y_2 = a_next_x * b_next_z;
    const float c_next_y = c_next_y_1 - c_next_y_2;
    const float c_next_z_1 = a_next_x * b_next_y;
    const float c_next_z_2 = a_next_y * b_next_x;
    const float c_next_z = c_next_z_1 - c_next_z_2;

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
    state->residual[0] = 0.0F;
    state->residual[1] = 0.0F;
    state->residual[2] = 0.0F;
    state->residual[3] = 0.0F;
    state->residual[4] = 0.0F;
    state->residual[5] = 0.0F;
}

void dcm_taylor_3_10_float32_compensated_update(
    dcm_taylor_3_10_float32_compensated_state *state, const float dtheta[9])
{
    /* attitude and input */
    const float c_11 = state->c[0];
    const float c_12 = state->c[1];
    const float c_13 = state->c[2];
    const float c_21 = state->c[3];
    const float c_22 = state->c[4];
    const float c_23 = state->c[5];
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
    const float W0_z_1 = dtheta3_z - dtheta2_z;
    const float W0_y_1 = dtheta3_y - dtheta2_y;
    const float W0_x_1 = dtheta3_x - dtheta2_x;
    const float W0_z_2 = dtheta2_z - dtheta1_z;
    const float W0_y_2 = dtheta2_y - dtheta1_y;
    const float W0_x_2 = dtheta2_x - dtheta1_x;
    const float W0_z_3 = W0_z_1 - W0_z_2;
    const float W0_y_3 = W0_y_1 - W0_y_2;
    const float W0_x_3 = W0_x_1 - W0_x_2;

    /* W_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    const float W0_x_4 = 3.0F * dtheta1_x;
    const float W0_x_5 = 0.0F + W0_x_4;
    const float W0_x_6 = -1.5F * W0_x_2;
    const float W0_x_7 = W0_x_5 + W0_x_6;
    const float W0_x = W0_x_7 + W0_x_3;
    const float W0_y_4 = 3.0F * dtheta1_y;
    const float W0_y_5 = 0.0F + W0_y_4;
    const float W0_y_6 = -1.5F * W0_y_2;
    const float W0_y_7 = W0_y_5 + W0_y_6;
    const float W0_y = W0_y_7 + W0_y_3;
    const float W0_z_4 = 3.0F * dtheta1_z;
    const float W0_z_5 = 0.0F + W0_z_4;
    const float W0_z_6 = -1.5F * W0_z_2;
    const float W0_z_7 = W0_z_5 + W0_z_6;
    const float W0_z = W0_z_7 + W0_z_3;
    const float W1_x_1 = 9.0F * W0_x_2;
    const float W1_x_2 = 0.0F + W1_x_1;
    const float W1_x_3 = -9.0F * W0_x_3;
    const float W1_x = W1_x_2 + W1_x_3;
    const float W1_y_1 = 9.0F * W0_y_2;
    const float W1_y_2 = 0.0F + W1_y_1;
    const float W1_y_3 = -9.0F * W0_y_3;
    const float W1_y = W1_y_2 + W1_y_3;
    const float W1_z_1 = 9.0F * W0_z_2;
    const float W1_z_2 = 0.0F + W1_z_1;
    const float W1_z_3 = -9.0F * W0_z_3;
    const float W1_z = W1_z_2 + W1_z_3;
    const float W2_x_1 = 13.5F * W0_x_3;
    const float W2_x = 0.0F + W2_x_1;
    const float W2_y_1 = 13.5F * W0_y_3;
    const float W2_y = 0.0F + W2_y_1;
    const float W2_z_1 = 13.5F * W0_z_3;
    const float W2_z = 0.0F + W2_z_1;

    /* a_1 = 1/1 sum_j a_(1-1-j) x W_j   [xu2019 (13)] */
    const float a1_x_1 = c_12 * W0_z;
    const float a1_x_2 = 0.0F + a1_x_1;
    const float a1_x_3 = c_13 * W0_y;
    const float a1_x = a1_x_2 - a1_x_3;
    const float a1_y_1 = c_13 * W0_x;
    const float a1_y_2 = 0.0F + a1_y_1;
    const float a1_y_3 = c_11 * W0_z;
    const float a1_y = a1_y_2 - a1_y_3;
    const float a1_z_1 = c_11 * W0_y;
    const float a1_z_2 = 0.0F + a1_z_1;
    const float a1_z_3 = c_12 * W0_x;
    const float a1_z = a1_z_2 - a1_z_3;

    /* a_2 = 1/2 sum_j a_(2-1-j) x W_j   [xu2019 (13)] */
    const float a2_x_1 = a1_y * W0_z;
    const float a2_x_2 = 0.0F + a2_x_1;
    const float a2_x_3 = a1_z * W0_y;
    const float a2_x_4 = a2_x_2 - a2_x_3;
    const float a2_x_5 = c_12 * W1_z;
    const float a2_x_6 = a2_x_4 + a2_x_5;
    const float a2_x_7 = c_13 * W1_y;
    const float a2_x_8 = a2_x_6 - a2_x_7;
    const float a2_y_1 = a1_z * W0_x;
    const float a2_y_2 = 0.0F + a2_y_1;
    const float a2_y_3 = a1_x * W0_z;
    const float a2_y_4 = a2_y_2 - a2_y_3;
    const float a2_y_5 = c_13 * W1_x;
    const float a2_y_6 = a2_y_4 + a2_y_5;
    const float a2_y_7 = c_11 * W1_z;
    const float a2_y_8 = a2_y_6 - a2_y_7;
    const float a2_z_1 = a1_x * W0_y;
    const float a2_z_2 = 0.0F + a2_z_1;
    const float a2_z_3 = a1_y * W0_x;
    const float a2_z_4 = a2_z_2 - a2_z_3;
    const float a2_z_5 = c_11 * W1_y;
    const float a2_z_6 = a2_z_4 + a2_z_5;
    const float a2_z_7 = c_12 * W1_x;
    const float a2_z_8 = a2_z_6 - a2_z_7;
    const float a2_x = 0.5F * a2_x_8;
    const float da_x_1 = a1_x + a2_x;
    const float a2_y = 0.5F * a2_y_8;
    const float da_y_1 = a1_y + a2_y;
    const float a2_z = 0.5F * a2_z_8;
    const float da_z_1 = a1_z + a2_z;

    /* a_3 = 1/3 sum_j a_(3-1-j) x W_j   [xu2019 (13)] */
    const float a3_x_1 = a2_y * W0_z;
    const float a3_x_2 = 0.0F + a3_x_1;
    const float a3_x_3 = a2_z * W0_y;
    const float a3_x_4 = a3_x_2 - a3_x_3;
    const float a3_x_5 = a1_y * W1_z;
    const float a3_x_6 = a3_x_4 + a3_x_5;
    const float a3_x_7 = a1_z * W1_y;
    const float a3_x_8 = a3_x_6 - a3_x_7;
    const float a3_x_9 = c_12 * W2_z;
    const float a3_x_10 = a3_x_8 + a3_x_9;
    const float a3_x_11 = c_13 * W2_y;
    const float a3_x_12 = a3_x_10 - a3_x_11;
    const float a3_y_1 = a2_z * W0_x;
    const float a3_y_2 = 0.0F + a3_y_1;
    const float a3_y_3 = a2_x * W0_z;
    const float a3_y_4 = a3_y_2 - a3_y_3;
    const float a3_y_5 = a1_z * W1_x;
    const float a3_y_6 = a3_y_4 + a3_y_5;
    const float a3_y_7 = a1_x * W1_z;
    const float a3_y_8 = a3_y_6 - a3_y_7;
    const float a3_y_9 = c_13 * W2_x;
    const float a3_y_10 = a3_y_8 + a3_y_9;
    const float a3_y_11 = c_11 * W2_z;
    const float a3_y_12 = a3_y_10 - a3_y_11;
    const float a3_z_1 = a2_x * W0_y;
    const float a3_z_2 = 0.0F + a3_z_1;
    const float a3_z_3 = a2_y * W0_x;
    const float a3_z_4 = a3_z_2 - a3_z_3;
    const float a3_z_5 = a1_x * W1_y;
    const float a3_z_6 = a3_z_4 + a3_z_5;
    const float a3_z_7 = a1_y * W1_x;
    const float a3_z_8 = a3_z_6 - a3_z_7;
    const float a3_z_9 = c_11 * W2_y;
    const float a3_z_10 = a3_z_8 + a3_z_9;
    const float a3_z_11 = c_12 * W2_x;
    const float a3_z_12 = a3_z_10 - a3_z_11;
    const float a3_x = 0.33333334F /* 1/3 */ * a3_x_12;
    const float da_x_2 = da_x_1 + a3_x;
    const float a3_y = 0.33333334F /* 1/3 */ * a3_y_12;
    const float da_y_2 = da_y_1 + a3_y;
    const float a3_z = 0.33333334F /* 1/3 */ * a3_z_12;
    const float da_z_2 = da_z_1 + a3_z;

    /* a_4 = 1/4 sum_j a_(4-1-j) x W_j   [xu2019 (13)] */
    const float a4_x_1 = a3_y * W0_z;
    const float a4_x_2 = 0.0F + a4_x_1;
    const float a4_x_3 = a3_z * W0_y;
    const float a4_x_4 = a4_x_2 - a4_x_3;
    const float a4_x_5 = a2_y * W1_z;
    const float a4_x_6 = a4_x_4 + a4_x_5;
    const float a4_x_7 = a2_z * W1_y;
    const float a4_x_8 = a4_x_6 - a4_x_7;
    const float a4_x_9 = a1_y * W2_z;
    const float a4_x_10 = a4_x_8 + a4_x_9;
    const float a4_x_11 = a1_z * W2_y;
    const float a4_x_12 = a4_x_10 - a4_x_11;
    const float a4_y_1 = a3_z * W0_x;
    const float a4_y_2 = 0.0F + a4_y_1;
    const float a4_y_3 = a3_x * W0_z;
    const float a4_y_4 = a4_y_2 - a4_y_3;
    const float a4_y_5 = a2_z * W1_x;
    const float a4_y_6 = a4_y_4 + a4_y_5;
    const float a4_y_7 = a2_x * W1_z;
    const float a4_y_8 = a4_y_6 - a4_y_7;
    const float a4_y_9 = a1_z * W2_x;
    const float a4_y_10 = a4_y_8 + a4_y_9;
    const float a4_y_11 = a1_x * W2_z;
    const float a4_y_12 = a4_y_10 - a4_y_11;
    const float a4_z_1 = a3_x * W0_y;
    const float a4_z_2 = 0.0F + a4_z_1;
    const float a4_z_3 = a3_y * W0_x;
    const float a4_z_4 = a4_z_2 - a4_z_3;
    const float a4_z_5 = a2_x * W1_y;
    const float a4_z_6 = a4_z_4 + a4_z_5;
    const float a4_z_7 = a2_y * W1_x;
    const float a4_z_8 = a4_z_6 - a4_z_7;
    const float a4_z_9 = a1_x * W2_y;
    const float a4_z_10 = a4_z_8 + a4_z_9;
    const float a4_z_11 = a1_y * W2_x;
    const float a4_z_12 = a4_z_10 - a4_z_11;
    const float a4_x = 0.25F * a4_x_12;
    const float da_x_3 = da_x_2 + a4_x;
    const float a4_y = 0.25F * a4_y_12;
    const float da_y_3 = da_y_2 + a4_y;
    const float a4_z = 0.25F * a4_z_12;
    const float da_z_3 = da_z_2 + a4_z;

    /* a_5 = 1/5 sum_j a_(5-1-j) x W_j   [xu2019 (13)] */
    const float a5_x_1 = a4_y * W0_z;
    const float a5_x_2 = 0.0F + a5_x_1;
    const float a5_x_3 = a4_z * W0_y;
    const float a5_x_4 = a5_x_2 - a5_x_3;
    const float a5_x_5 = a3_y * W1_z;
    const float a5_x_6 = a5_x_4 + a5_x_5;
    const float a5_x_7 = a3_z * W1_y;
    const float a5_x_8 = a5_x_6 - a5_x_7;
    const float a5_x_9 = a2_y * W2_z;
    const float a5_x_10 = a5_x_8 + a5_x_9;
    const float a5_x_11 = a2_z * W2_y;
    const float a5_x_12 = a5_x_10 - a5_x_11;
    const float a5_y_1 = a4_z * W0_x;
    const float a5_y_2 = 0.0F + a5_y_1;
    const float a5_y_3 = a4_x * W0_z;
    const float a5_y_4 = a5_y_2 - a5_y_3;
    const float a5_y_5 = a3_z * W1_x;
    const float a5_y_6 = a5_y_4 + a5_y_5;
    const float a5_y_7 = a3_x * W1_z;
    const float a5_y_8 = a5_y_6 - a5_y_7;
    const float a5_y_9 = a2_z * W2_x;
    const float a5_y_10 = a5_y_8 + a5_y_9;
    const float a5_y_11 = a2_x * W2_z;
    const float a5_y_12 = a5_y_10 - a5_y_11;
    const float a5_z_1 = a4_x * W0_y;
    const float a5_z_2 = 0.0F + a5_z_1;
    const float a5_z_3 = a4_y * W0_x;
    const float a5_z_4 = a5_z_2 - a5_z_3;
    const float a5_z_5 = a3_x * W1_y;
    const float a5_z_6 = a5_z_4 + a5_z_5;
    const float a5_z_7 = a3_y * W1_x;
    const float a5_z_8 = a5_z_6 - a5_z_7;
    const float a5_z_9 = a2_x * W2_y;
    const float a5_z_10 = a5_z_8 + a5_z_9;
    const float a5_z_11 = a2_y * W2_x;
    const float a5_z_12 = a5_z_10 - a5_z_11;
    const float a5_x = 0.2F /* 1/5 */ * a5_x_12;
    const float da_x_4 = da_x_3 + a5_x;
    const float a5_y = 0.2F /* 1/5 */ * a5_y_12;
    const float da_y_4 = da_y_3 + a5_y;
    const float a5_z = 0.2F /* 1/5 */ * a5_z_12;
    const float da_z_4 = da_z_3 + a5_z;

    /* a_6 = 1/6 sum_j a_(6-1-j) x W_j   [xu2019 (13)] */
    const float a6_x_1 = a5_y * W0_z;
    const float a6_x_2 = 0.0F + a6_x_1;
    const float a6_x_3 = a5_z * W0_y;
    const float a6_x_4 = a6_x_2 - a6_x_3;
    const float a6_x_5 = a4_y * W1_z;
    const float a6_x_6 = a6_x_4 + a6_x_5;
    const float a6_x_7 = a4_z * W1_y;
    const float a6_x_8 = a6_x_6 - a6_x_7;
    const float a6_x_9 = a3_y * W2_z;
    const float a6_x_10 = a6_x_8 + a6_x_9;
    const float a6_x_11 = a3_z * W2_y;
    const float a6_x_12 = a6_x_10 - a6_x_11;
    const float a6_y_1 = a5_z * W0_x;
    const float a6_y_2 = 0.0F + a6_y_1;
    const float a6_y_3 = a5_x * W0_z;
    const float a6_y_4 = a6_y_2 - a6_y_3;
    const float a6_y_5 = a4_z * W1_x;
    const float a6_y_6 = a6_y_4 + a6_y_5;
    const float a6_y_7 = a4_x * W1_z;
    const float a6_y_8 = a6_y_6 - a6_y_7;
    const float a6_y_9 = a3_z * W2_x;
    const float a6_y_10 = a6_y_8 + a6_y_9;
    const float a6_y_11 = a3_x * W2_z;
    const float a6_y_12 = a6_y_10 - a6_y_11;
    const float a6_z_1 = a5_x * W0_y;
    const float a6_z_2 = 0.0F + a6_z_1;
    const float a6_z_3 = a5_y * W0_x;
    const float a6_z_4 = a6_z_2 - a6_z_3;
    const float a6_z_5 = a4_x * W1_y;
    const float a6_z_6 = a6_z_4 + a6_z_5;
    const float a6_z_7 = a4_y * W1_x;
    const float a6_z_8 = a6_z_6 - a6_z_7;
    const float a6_z_9 = a3_x * W2_y;
    const float a6_z_10 = a6_z_8 + a6_z_9;
    const float a6_z_11 = a3_y * W2_x;
    const float a6_z_12 = a6_z_10 - a6_z_11;
    const float a6_x = 0.16666667F /* 1/6 */ * a6_x_12;
    const float da_x_5 = da_x_4 + a6_x;
    const float a6_y = 0.16666667F /* 1/6 */ * a6_y_12;
    const float da_y_5 = da_y_4 + a6_y;
    const float a6_z = 0.16666667F /* 1/6 */ * a6_z_12;
    const float da_z_5 = da_z_4 + a6_z;

    /* a_7 = 1/7 sum_j a_(7-1-j) x W_j   [xu2019 (13)] */
    const float a7_x_1 = a6_y * W0_z;
    const float a7_x_2 = 0.0F + a7_x_1;
    const float a7_x_3 = a6_z * W0_y;
    const float a7_x_4 = a7_x_2 - a7_x_3;
    const float a7_x_5 = a5_y * W1_z;
    const float a7_x_6 = a7_x_4 + a7_x_5;
    const float a7_x_7 = a5_z * W1_y;
    const float a7_x_8 = a7_x_6 - a7_x_7;
    const float a7_x_9 = a4_y * W2_z;
    const float a7_x_10 = a7_x_8 + a7_x_9;
    const float a7_x_11 = a4_z * W2_y;
    const float a7_x_12 = a7_x_10 - a7_x_11;
    const float a7_y_1 = a6_z * W0_x;
    const float a7_y_2 = 0.0F + a7_y_1;
    const float a7_y_3 = a6_x * W0_z;
    const float a7_y_4 = a7_y_2 - a7_y_3;
    const float a7_y_5 = a5_z * W1_x;
    const float a7_y_6 = a7_y_4 + a7_y_5;
    const float a7_y_7 = a5_x * W1_z;
    const float a7_y_8 = a7_y_6 - a7_y_7;
    const float a7_y_9 = a4_z * W2_x;
    const float a7_y_10 = a7_y_8 + a7_y_9;
    const float a7_y_11 = a4_x * W2_z;
    const float a7_y_12 = a7_y_10 - a7_y_11;
    const float a7_z_1 = a6_x * W0_y;
    const float a7_z_2 = 0.0F + a7_z_1;
    const float a7_z_3 = a6_y * W0_x;
    const float a7_z_4 = a7_z_2 - a7_z_3;
    const float a7_z_5 = a5_x * W1_y;
    const float a7_z_6 = a7_z_4 + a7_z_5;
    const float a7_z_7 = a5_y * W1_x;
    const float a7_z_8 = a7_z_6 - a7_z_7;
    const float a7_z_9 = a4_x * W2_y;
    const float a7_z_10 = a7_z_8 + a7_z_9;
    const float a7_z_11 = a4_y * W2_x;
    const float a7_z_12 = a7_z_10 - a7_z_11;
    const float a7_x = 0.14285715F /* 1/7 */ * a7_x_12;
    const float da_x_6 = da_x_5 + a7_x;
    const float a7_y = 0.14285715F /* 1/7 */ * a7_y_12;
    const float da_y_6 = da_y_5 + a7_y;
    const float a7_z = 0.14285715F /* 1/7 */ * a7_z_12;
    const float da_z_6 = da_z_5 + a7_z;

    /* a_8 = 1/8 sum_j a_(8-1-j) x W_j   [xu2019 (13)] */
    const float a8_x_1 = a7_y * W0_z;
    const float a8_x_2 = 0.0F + a8_x_1;
    const float a8_x_3 = a7_z * W0_y;
    const float a8_x_4 = a8_x_2 - a8_x_3;
    const float a8_x_5 = a6_y * W1_z;
    const float a8_x_6 = a8_x_4 + a8_x_5;
    const float a8_x_7 = a6_z * W1_y;
    const float a8_x_8 = a8_x_6 - a8_x_7;
    const float a8_x_9 = a5_y * W2_z;
    const float a8_x_10 = a8_x_8 + a8_x_9;
    const float a8_x_11 = a5_z * W2_y;
    const float a8_x_12 = a8_x_10 - a8_x_11;
    const float a8_y_1 = a7_z * W0_x;
    const float a8_y_2 = 0.0F + a8_y_1;
    const float a8_y_3 = a7_x * W0_z;
    const float a8_y_4 = a8_y_2 - a8_y_3;
    const float a8_y_5 = a6_z * W1_x;
    const float a8_y_6 = a8_y_4 + a8_y_5;
    const float a8_y_7 = a6_x * W1_z;
    const float a8_y_8 = a8_y_6 - a8_y_7;
    const float a8_y_9 = a5_z * W2_x;
    const float a8_y_10 = a8_y_8 + a8_y_9;
    const float a8_y_11 = a5_x * W2_z;
    const float a8_y_12 = a8_y_10 - a8_y_11;
    const float a8_z_1 = a7_x * W0_y;
    const float a8_z_2 = 0.0F + a8_z_1;
    const float a8_z_3 = a7_y * W0_x;
    const float a8_z_4 = a8_z_2 - a8_z_3;
    const float a8_z_5 = a6_x * W1_y;
    const float a8_z_6 = a8_z_4 + a8_z_5;
    const float a8_z_7 = a6_y * W1_x;
    const float a8_z_8 = a8_z_6 - a8_z_7;
    const float a8_z_9 = a5_x * W2_y;
    const float a8_z_10 = a8_z_8 + a8_z_9;
    const float a8_z_11 = a5_y * W2_x;
    const float a8_z_12 = a8_z_10 - a8_z_11;
    const float a8_x = 0.125F * a8_x_12;
    const float da_x_7 = da_x_6 + a8_x;
    const float a8_y = 0.125F * a8_y_12;
    const float da_y_7 = da_y_6 + a8_y;
    const float a8_z = 0.125F * a8_z_12;
    const float da_z_7 = da_z_6 + a8_z;

    /* a_9 = 1/9 sum_j a_(9-1-j) x W_j   [xu2019 (13)] */
    const float a9_x_1 = a8_y * W0_z;
    const float a9_x_2 = 0.0F + a9_x_1;
    const float a9_x_3 = a8_z * W0_y;
    const float a9_x_4 = a9_x_2 - a9_x_3;
    const float a9_x_5 = a7_y * W1_z;
    const float a9_x_6 = a9_x_4 + a9_x_5;
    const float a9_x_7 = a7_z * W1_y;
    const float a9_x_8 = a9_x_6 - a9_x_7;
    const float a9_x_9 = a6_y * W2_z;
    const float a9_x_10 = a9_x_8 + a9_x_9;
    const float a9_x_11 = a6_z * W2_y;
    const float a9_x_12 = a9_x_10 - a9_x_11;
    const float a9_y_1 = a8_z * W0_x;
    const float a9_y_2 = 0.0F + a9_y_1;
    const float a9_y_3 = a8_x * W0_z;
    const float a9_y_4 = a9_y_2 - a9_y_3;
    const float a9_y_5 = a7_z * W1_x;
    const float a9_y_6 = a9_y_4 + a9_y_5;
    const float a9_y_7 = a7_x * W1_z;
    const float a9_y_8 = a9_y_6 - a9_y_7;
    const float a9_y_9 = a6_z * W2_x;
    const float a9_y_10 = a9_y_8 + a9_y_9;
    const float a9_y_11 = a6_x * W2_z;
    const float a9_y_12 = a9_y_10 - a9_y_11;
    const float a9_z_1 = a8_x * W0_y;
    const float a9_z_2 = 0.0F + a9_z_1;
    const float a9_z_3 = a8_y * W0_x;
    const float a9_z_4 = a9_z_2 - a9_z_3;
    const float a9_z_5 = a7_x * W1_y;
    const float a9_z_6 = a9_z_4 + a9_z_5;
    const float a9_z_7 = a7_y * W1_x;
    const float a9_z_8 = a9_z_6 - a9_z_7;
    const float a9_z_9 = a6_x * W2_y;
    const float a9_z_10 = a9_z_8 + a9_z_9;
    const float a9_z_11 = a6_y * W2_x;
    const float a9_z_12 = a9_z_10 - a9_z_11;
    const float a9_x = 0.11111111F /* 1/9 */ * a9_x_12;
    const float da_x_8 = da_x_7 + a9_x;
    const float a9_y = 0.11111111F /* 1/9 */ * a9_y_12;
    const float da_y_8 = da_y_7 + a9_y;
    const float a9_z = 0.11111111F /* 1/9 */ * a9_z_12;
    const float da_z_8 = da_z_7 + a9_z;

    /* a_10 = 1/10 sum_j a_(10-1-j) x W_j   [xu2019 (13)] */
    const float a10_x_1 = a9_y * W0_z;
    const float a10_x_2 = 0.0F + a10_x_1;
    const float a10_x_3 = a9_z * W0_y;
    const float a10_x_4 = a10_x_2 - a10_x_3;
    const float a10_x_5 = a8_y * W1_z;
    const float a10_x_6 = a10_x_4 + a10_x_5;
    const float a10_x_7 = a8_z * W1_y;
    const float a10_x_8 = a10_x_6 - a10_x_7;
    const float a10_x_9 = a7_y * W2_z;
    const float a10_x_10 = a10_x_8 + a10_x_9;
    const float a10_x_11 = a7_z * W2_y;
    const float a10_x_12 = a10_x_10 - a10_x_11;
    const float a10_y_1 = a9_z * W0_x;
    const float a10_y_2 = 0.0F + a10_y_1;
    const float a10_y_3 = a9_x * W0_z;
    const float a10_y_4 = a10_y_2 - a10_y_3;
    const float a10_y_5 = a8_z * W1_x;
    const float a10_y_6 = a10_y_4 + a10_y_5;
    const float a10_y_7 = a8_x * W1_z;
    const float a10_y_8 = a10_y_6 - a10_y_7;
    const float a10_y_9 = a7_z * W2_x;
    const float a10_y_10 = a10_y_8 + a10_y_9;
    const float a10_y_11 = a7_x * W2_z;
    const float a10_y_12 = a10_y_10 - a10_y_11;
    const float a10_z_1 = a9_x * W0_y;
    const float a10_z_2 = 0.0F + a10_z_1;
    const float a10_z_3 = a9_y * W0_x;
    const float a10_z_4 = a10_z_2 - a10_z_3;
    const float a10_z_5 = a8_x * W1_y;
    const float a10_z_6 = a10_z_4 + a10_z_5;
    const float a10_z_7 = a8_y * W1_x;
    const float a10_z_8 = a10_z_6 - a10_z_7;
    const float a10_z_9 = a7_x * W2_y;
    const float a10_z_10 = a10_z_8 + a10_z_9;
    const float a10_z_11 = a7_y * W2_x;
    const float a10_z_12 = a10_z_10 - a10_z_11;
    const float a10_x = 0.1F /* 1/10 */ * a10_x_12;
    const float da_x = da_x_8 + a10_x;
    const float a10_y = 0.1F /* 1/10 */ * a10_y_12;
    const float da_y = da_y_8 + a10_y;
    const float a10_z = 0.1F /* 1/10 */ * a10_z_12;
    const float da_z = da_z_8 + a10_z;

    /* b_1 = 1/1 sum_j b_(1-1-j) x W_j   [xu2019 (13)] */
    const float b1_x_1 = c_22 * W0_z;
    const float b1_x_2 = 0.0F + b1_x_1;
    const float b1_x_3 = c_23 * W0_y;
    const float b1_x = b1_x_2 - b1_x_3;
    const float b1_y_1 = c_23 * W0_x;
    const float b1_y_2 = 0.0F + b1_y_1;
    const float b1_y_3 = c_21 * W0_z;
    const float b1_y = b1_y_2 - b1_y_3;
    const float b1_z_1 = c_21 * W0_y;
    const float b1_z_2 = 0.0F + b1_z_1;
    const float b1_z_3 = c_22 * W0_x;
    const float b1_z = b1_z_2 - b1_z_3;

    /* b_2 = 1/2 sum_j b_(2-1-j) x W_j   [xu2019 (13)] */
    const float b2_x_1 = b1_y * W0_z;
    const float b2_x_2 = 0.0F + b2_x_1;
    const float b2_x_3 = b1_z * W0_y;
    const float b2_x_4 = b2_x_2 - b2_x_3;
    const float b2_x_5 = c_22 * W1_z;
    const float b2_x_6 = b2_x_4 + b2_x_5;
    const float b2_x_7 = c_23 * W1_y;
    const float b2_x_8 = b2_x_6 - b2_x_7;
    const float b2_y_1 = b1_z * W0_x;
    const float b2_y_2 = 0.0F + b2_y_1;
    const float b2_y_3 = b1_x * W0_z;
    const float b2_y_4 = b2_y_2 - b2_y_3;
    const float b2_y_5 = c_23 * W1_x;
    const float b2_y_6 = b2_y_4 + b2_y_5;
    const float b2_y_7 = c_21 * W1_z;
    const float b2_y_8 = b2_y_6 - b2_y_7;
    const float b2_z_1 = b1_x * W0_y;
    const float b2_z_2 = 0.0F + b2_z_1;
    const float b2_z_3 = b1_y * W0_x;
    const float b2_z_4 = b2_z_2 - b2_z_3;
    const float b2_z_5 = c_21 * W1_y;
    const float b2_z_6 = b2_z_4 + b2_z_5;
    const float b2_z_7 = c_22 * W1_x;
    const float b2_z_8 = b2_z_6 - b2_z_7;
    const float b2_x = 0.5F * b2_x_8;
    const float db_x_1 = b1_x + b2_x;
    const float b2_y = 0.5F * b2_y_8;
    const float db_y_1 = b1_y + b2_y;
    const float b2_z = 0.5F * b2_z_8;
    const float db_z_1 = b1_z + b2_z;

    /* b_3 = 1/3 sum_j b_(3-1-j) x W_j   [xu2019 (13)] */
    const float b3_x_1 = b2_y * W0_z;
    const float b3_x_2 = 0.0F + b3_x_1;
    const float b3_x_3 = b2_z * W0_y;
    const float b3_x_4 = b3_x_2 - b3_x_3;
    const float b3_x_5 = b1_y * W1_z;
    const float b3_x_6 = b3_x_4 + b3_x_5;
    const float b3_x_7 = b1_z * W1_y;
    const float b3_x_8 = b3_x_6 - b3_x_7;
    const float b3_x_9 = c_22 * W2_z;
    const float b3_x_10 = b3_x_8 + b3_x_9;
    const float b3_x_11 = c_23 * W2_y;
    const float b3_x_12 = b3_x_10 - b3_x_11;
    const float b3_y_1 = b2_z * W0_x;
    const float b3_y_2 = 0.0F + b3_y_1;
    const float b3_y_3 = b2_x * W0_z;
    const float b3_y_4 = b3_y_2 - b3_y_3;
    const float b3_y_5 = b1_z * W1_x;
    const float b3_y_6 = b3_y_4 + b3_y_5;
    const float b3_y_7 = b1_x * W1_z;
    const float b3_y_8 = b3_y_6 - b3_y_7;
    const float b3_y_9 = c_23 * W2_x;
    const float b3_y_10 = b3_y_8 + b3_y_9;
    const float b3_y_11 = c_21 * W2_z;
    const float b3_y_12 = b3_y_10 - b3_y_11;
    const float b3_z_1 = b2_x * W0_y;
    const float b3_z_2 = 0.0F + b3_z_1;
    const float b3_z_3 = b2_y * W0_x;
    const float b3_z_4 = b3_z_2 - b3_z_3;
    const float b3_z_5 = b1_x * W1_y;
    const float b3_z_6 = b3_z_4 + b3_z_5;
    const float b3_z_7 = b1_y * W1_x;
    const float b3_z_8 = b3_z_6 - b3_z_7;
    const float b3_z_9 = c_21 * W2_y;
    const float b3_z_10 = b3_z_8 + b3_z_9;
    const float b3_z_11 = c_22 * W2_x;
    const float b3_z_12 = b3_z_10 - b3_z_11;
    const float b3_x = 0.33333334F /* 1/3 */ * b3_x_12;
    const float db_x_2 = db_x_1 + b3_x;
    const float b3_y = 0.33333334F /* 1/3 */ * b3_y_12;
    const float db_y_2 = db_y_1 + b3_y;
    const float b3_z = 0.33333334F /* 1/3 */ * b3_z_12;
    const float db_z_2 = db_z_1 + b3_z;

    /* b_4 = 1/4 sum_j b_(4-1-j) x W_j   [xu2019 (13)] */
    const float b4_x_1 = b3_y * W0_z;
    const float b4_x_2 = 0.0F + b4_x_1;
    const float b4_x_3 = b3_z * W0_y;
    const float b4_x_4 = b4_x_2 - b4_x_3;
    const float b4_x_5 = b2_y * W1_z;
    const float b4_x_6 = b4_x_4 + b4_x_5;
    const float b4_x_7 = b2_z * W1_y;
    const float b4_x_8 = b4_x_6 - b4_x_7;
    const float b4_x_9 = b1_y * W2_z;
    const float b4_x_10 = b4_x_8 + b4_x_9;
    const float b4_x_11 = b1_z * W2_y;
    const float b4_x_12 = b4_x_10 - b4_x_11;
    const float b4_y_1 = b3_z * W0_x;
    const float b4_y_2 = 0.0F + b4_y_1;
    const float b4_y_3 = b3_x * W0_z;
    const float b4_y_4 = b4_y_2 - b4_y_3;
    const float b4_y_5 = b2_z * W1_x;
    const float b4_y_6 = b4_y_4 + b4_y_5;
    const float b4_y_7 = b2_x * W1_z;
    const float b4_y_8 = b4_y_6 - b4_y_7;
    const float b4_y_9 = b1_z * W2_x;
    const float b4_y_10 = b4_y_8 + b4_y_9;
    const float b4_y_11 = b1_x * W2_z;
    const float b4_y_12 = b4_y_10 - b4_y_11;
    const float b4_z_1 = b3_x * W0_y;
    const float b4_z_2 = 0.0F + b4_z_1;
    const float b4_z_3 = b3_y * W0_x;
    const float b4_z_4 = b4_z_2 - b4_z_3;
    const float b4_z_5 = b2_x * W1_y;
    const float b4_z_6 = b4_z_4 + b4_z_5;
    const float b4_z_7 = b2_y * W1_x;
    const float b4_z_8 = b4_z_6 - b4_z_7;
    const float b4_z_9 = b1_x * W2_y;
    const float b4_z_10 = b4_z_8 + b4_z_9;
    const float b4_z_11 = b1_y * W2_x;
    const float b4_z_12 = b4_z_10 - b4_z_11;
    const float b4_x = 0.25F * b4_x_12;
    const float db_x_3 = db_x_2 + b4_x;
    const float b4_y = 0.25F * b4_y_12;
    const float db_y_3 = db_y_2 + b4_y;
    const float b4_z = 0.25F * b4_z_12;
    const float db_z_3 = db_z_2 + b4_z;

    /* b_5 = 1/5 sum_j b_(5-1-j) x W_j   [xu2019 (13)] */
    const float b5_x_1 = b4_y * W0_z;
    const float b5_x_2 = 0.0F + b5_x_1;
    const float b5_x_3 = b4_z * W0_y;
    const float b5_x_4 = b5_x_2 - b5_x_3;
    const float b5_x_5 = b3_y * W1_z;
    const float b5_x_6 = b5_x_4 + b5_x_5;
    const float b5_x_7 = b3_z * W1_y;
    const float b5_x_8 = b5_x_6 - b5_x_7;
    const float b5_x_9 = b2_y * W2_z;
    const float b5_x_10 = b5_x_8 + b5_x_9;
    const float b5_x_11 = b2_z * W2_y;
    const float b5_x_12 = b5_x_10 - b5_x_11;
    const float b5_y_1 = b4_z * W0_x;
    const float b5_y_2 = 0.0F + b5_y_1;
    const float b5_y_3 = b4_x * W0_z;
    const float b5_y_4 = b5_y_2 - b5_y_3;
    const float b5_y_5 = b3_z * W1_x;
    const float b5_y_6 = b5_y_4 + b5_y_5;
    const float b5_y_7 = b3_x * W1_z;
    const float b5_y_8 = b5_y_6 - b5_y_7;
    const float b5_y_9 = b2_z * W2_x;
    const float b5_y_10 = b5_y_8 + b5_y_9;
    const float b5_y_11 = b2_x * W2_z;
    const float b5_y_12 = b5_y_10 - b5_y_11;
    const float b5_z_1 = b4_x * W0_y;
    const float b5_z_2 = 0.0F + b5_z_1;
    const float b5_z_3 = b4_y * W0_x;
    const float b5_z_4 = b5_z_2 - b5_z_3;
    const float b5_z_5 = b3_x * W1_y;
    const float b5_z_6 = b5_z_4 + b5_z_5;
    const float b5_z_7 = b3_y * W1_x;
    const float b5_z_8 = b5_z_6 - b5_z_7;
    const float b5_z_9 = b2_x * W2_y;
    const float b5_z_10 = b5_z_8 + b5_z_9;
    const float b5_z_11 = b2_y * W2_x;
    const float b5_z_12 = b5_z_10 - b5_z_11;
    const float b5_x = 0.2F /* 1/5 */ * b5_x_12;
    const float db_x_4 = db_x_3 + b5_x;
    const float b5_y = 0.2F /* 1/5 */ * b5_y_12;
    const float db_y_4 = db_y_3 + b5_y;
    const float b5_z = 0.2F /* 1/5 */ * b5_z_12;
    const float db_z_4 = db_z_3 + b5_z;

    /* b_6 = 1/6 sum_j b_(6-1-j) x W_j   [xu2019 (13)] */
    const float b6_x_1 = b5_y * W0_z;
    const float b6_x_2 = 0.0F + b6_x_1;
    const float b6_x_3 = b5_z * W0_y;
    const float b6_x_4 = b6_x_2 - b6_x_3;
    const float b6_x_5 = b4_y * W1_z;
    const float b6_x_6 = b6_x_4 + b6_x_5;
    const float b6_x_7 = b4_z * W1_y;
    const float b6_x_8 = b6_x_6 - b6_x_7;
    const float b6_x_9 = b3_y * W2_z;
    const float b6_x_10 = b6_x_8 + b6_x_9;
    const float b6_x_11 = b3_z * W2_y;
    const float b6_x_12 = b6_x_10 - b6_x_11;
    const float b6_y_1 = b5_z * W0_x;
    const float b6_y_2 = 0.0F + b6_y_1;
    const float b6_y_3 = b5_x * W0_z;
    const float b6_y_4 = b6_y_2 - b6_y_3;
    const float b6_y_5 = b4_z * W1_x;
    const float b6_y_6 = b6_y_4 + b6_y_5;
    const float b6_y_7 = b4_x * W1_z;
    const float b6_y_8 = b6_y_6 - b6_y_7;
    const float b6_y_9 = b3_z * W2_x;
    const float b6_y_10 = b6_y_8 + b6_y_9;
    const float b6_y_11 = b3_x * W2_z;
    const float b6_y_12 = b6_y_10 - b6_y_11;
    const float b6_z_1 = b5_x * W0_y;
    const float b6_z_2 = 0.0F + b6_z_1;
    const float b6_z_3 = b5_y * W0_x;
    const float b6_z_4 = b6_z_2 - b6_z_3;
    const float b6_z_5 = b4_x * W1_y;
    const float b6_z_6 = b6_z_4 + b6_z_5;
    const float b6_z_7 = b4_y * W1_x;
    const float b6_z_8 = b6_z_6 - b6_z_7;
    const float b6_z_9 = b3_x * W2_y;
    const float b6_z_10 = b6_z_8 + b6_z_9;
    const float b6_z_11 = b3_y * W2_x;
    const float b6_z_12 = b6_z_10 - b6_z_11;
    const float b6_x = 0.16666667F /* 1/6 */ * b6_x_12;
    const float db_x_5 = db_x_4 + b6_x;
    const float b6_y = 0.16666667F /* 1/6 */ * b6_y_12;
    const float db_y_5 = db_y_4 + b6_y;
    const float b6_z = 0.16666667F /* 1/6 */ * b6_z_12;
    const float db_z_5 = db_z_4 + b6_z;

    /* b_7 = 1/7 sum_j b_(7-1-j) x W_j   [xu2019 (13)] */
    const float b7_x_1 = b6_y * W0_z;
    const float b7_x_2 = 0.0F + b7_x_1;
    const float b7_x_3 = b6_z * W0_y;
    const float b7_x_4 = b7_x_2 - b7_x_3;
    const float b7_x_5 = b5_y * W1_z;
    const float b7_x_6 = b7_x_4 + b7_x_5;
    const float b7_x_7 = b5_z * W1_y;
    const float b7_x_8 = b7_x_6 - b7_x_7;
    const float b7_x_9 = b4_y * W2_z;
    const float b7_x_10 = b7_x_8 + b7_x_9;
    const float b7_x_11 = b4_z * W2_y;
    const float b7_x_12 = b7_x_10 - b7_x_11;
    const float b7_y_1 = b6_z * W0_x;
    const float b7_y_2 = 0.0F + b7_y_1;
    const float b7_y_3 = b6_x * W0_z;
    const float b7_y_4 = b7_y_2 - b7_y_3;
    const float b7_y_5 = b5_z * W1_x;
    const float b7_y_6 = b7_y_4 + b7_y_5;
    const float b7_y_7 = b5_x * W1_z;
    const float b7_y_8 = b7_y_6 - b7_y_7;
    const float b7_y_9 = b4_z * W2_x;
    const float b7_y_10 = b7_y_8 + b7_y_9;
    const float b7_y_11 = b4_x * W2_z;
    const float b7_y_12 = b7_y_10 - b7_y_11;
    const float b7_z_1 = b6_x * W0_y;
    const float b7_z_2 = 0.0F + b7_z_1;
    const float b7_z_3 = b6_y * W0_x;
    const float b7_z_4 = b7_z_2 - b7_z_3;
    const float b7_z_5 = b5_x * W1_y;
    const float b7_z_6 = b7_z_4 + b7_z_5;
    const float b7_z_7 = b5_y * W1_x;
    const float b7_z_8 = b7_z_6 - b7_z_7;
    const float b7_z_9 = b4_x * W2_y;
    const float b7_z_10 = b7_z_8 + b7_z_9;
    const float b7_z_11 = b4_y * W2_x;
    const float b7_z_12 = b7_z_10 - b7_z_11;
    const float b7_x = 0.14285715F /* 1/7 */ * b7_x_12;
    const float db_x_6 = db_x_5 + b7_x;
    const float b7_y = 0.14285715F /* 1/7 */ * b7_y_12;
    const float db_y_6 = db_y_5 + b7_y;
    const float b7_z = 0.14285715F /* 1/7 */ * b7_z_12;
    const float db_z_6 = db_z_5 + b7_z;

    /* b_8 = 1/8 sum_j b_(8-1-j) x W_j   [xu2019 (13)] */
    const float b8_x_1 = b7_y * W0_z;
    const float b8_x_2 = 0.0F + b8_x_1;
    const float b8_x_3 = b7_z * W0_y;
    const float b8_x_4 = b8_x_2 - b8_x_3;
    const float b8_x_5 = b6_y * W1_z;
    const float b8_x_6 = b8_x_4 + b8_x_5;
    const float b8_x_7 = b6_z * W1_y;
    const float b8_x_8 = b8_x_6 - b8_x_7;
    const float b8_x_9 = b5_y * W2_z;
    const float b8_x_10 = b8_x_8 + b8_x_9;
    const float b8_x_11 = b5_z * W2_y;
    const float b8_x_12 = b8_x_10 - b8_x_11;
    const float b8_y_1 = b7_z * W0_x;
    const float b8_y_2 = 0.0F + b8_y_1;
    const float b8_y_3 = b7_x * W0_z;
    const float b8_y_4 = b8_y_2 - b8_y_3;
    const float b8_y_5 = b6_z * W1_x;
    const float b8_y_6 = b8_y_4 + b8_y_5;
    const float b8_y_7 = b6_x * W1_z;
    const float b8_y_8 = b8_y_6 - b8_y_7;
    const float b8_y_9 = b5_z * W2_x;
    const float b8_y_10 = b8_y_8 + b8_y_9;
    const float b8_y_11 = b5_x * W2_z;
    const float b8_y_12 = b8_y_10 - b8_y_11;
    const float b8_z_1 = b7_x * W0_y;
    const float b8_z_2 = 0.0F + b8_z_1;
    const float b8_z_3 = b7_y * W0_x;
    const float b8_z_4 = b8_z_2 - b8_z_3;
    const float b8_z_5 = b6_x * W1_y;
    const float b8_z_6 = b8_z_4 + b8_z_5;
    const float b8_z_7 = b6_y * W1_x;
    const float b8_z_8 = b8_z_6 - b8_z_7;
    const float b8_z_9 = b5_x * W2_y;
    const float b8_z_10 = b8_z_8 + b8_z_9;
    const float b8_z_11 = b5_y * W2_x;
    const float b8_z_12 = b8_z_10 - b8_z_11;
    const float b8_x = 0.125F * b8_x_12;
    const float db_x_7 = db_x_6 + b8_x;
    const float b8_y = 0.125F * b8_y_12;
    const float db_y_7 = db_y_6 + b8_y;
    const float b8_z = 0.125F * b8_z_12;
    const float db_z_7 = db_z_6 + b8_z;

    /* b_9 = 1/9 sum_j b_(9-1-j) x W_j   [xu2019 (13)] */
    const float b9_x_1 = b8_y * W0_z;
    const float b9_x_2 = 0.0F + b9_x_1;
    const float b9_x_3 = b8_z * W0_y;
    const float b9_x_4 = b9_x_2 - b9_x_3;
    const float b9_x_5 = b7_y * W1_z;
    const float b9_x_6 = b9_x_4 + b9_x_5;
    const float b9_x_7 = b7_z * W1_y;
    const float b9_x_8 = b9_x_6 - b9_x_7;
    const float b9_x_9 = b6_y * W2_z;
    const float b9_x_10 = b9_x_8 + b9_x_9;
    const float b9_x_11 = b6_z * W2_y;
    const float b9_x_12 = b9_x_10 - b9_x_11;
    const float b9_y_1 = b8_z * W0_x;
    const float b9_y_2 = 0.0F + b9_y_1;
    const float b9_y_3 = b8_x * W0_z;
    const float b9_y_4 = b9_y_2 - b9_y_3;
    const float b9_y_5 = b7_z * W1_x;
    const float b9_y_6 = b9_y_4 + b9_y_5;
    const float b9_y_7 = b7_x * W1_z;
    const float b9_y_8 = b9_y_6 - b9_y_7;
    const float b9_y_9 = b6_z * W2_x;
    const float b9_y_10 = b9_y_8 + b9_y_9;
    const float b9_y_11 = b6_x * W2_z;
    const float b9_y_12 = b9_y_10 - b9_y_11;
    const float b9_z_1 = b8_x * W0_y;
    const float b9_z_2 = 0.0F + b9_z_1;
    const float b9_z_3 = b8_y * W0_x;
    const float b9_z_4 = b9_z_2 - b9_z_3;
    const float b9_z_5 = b7_x * W1_y;
    const float b9_z_6 = b9_z_4 + b9_z_5;
    const float b9_z_7 = b7_y * W1_x;
    const float b9_z_8 = b9_z_6 - b9_z_7;
    const float b9_z_9 = b6_x * W2_y;
    const float b9_z_10 = b9_z_8 + b9_z_9;
    const float b9_z_11 = b6_y * W2_x;
    const float b9_z_12 = b9_z_10 - b9_z_11;
    const float b9_x = 0.11111111F /* 1/9 */ * b9_x_12;
    const float db_x_8 = db_x_7 + b9_x;
    const float b9_y = 0.11111111F /* 1/9 */ * b9_y_12;
    const float db_y_8 = db_y_7 + b9_y;
    const float b9_z = 0.11111111F /* 1/9 */ * b9_z_12;
    const float db_z_8 = db_z_7 + b9_z;

    /* b_10 = 1/10 sum_j b_(10-1-j) x W_j   [xu2019 (13)] */
    const float b10_x_1 = b9_y * W0_z;
    const float b10_x_2 = 0.0F + b10_x_1;
    const float b10_x_3 = b9_z * W0_y;
    const float b10_x_4 = b10_x_2 - b10_x_3;
    const float b10_x_5 = b8_y * W1_z;
    const float b10_x_6 = b10_x_4 + b10_x_5;
    const float b10_x_7 = b8_z * W1_y;
    const float b10_x_8 = b10_x_6 - b10_x_7;
    const float b10_x_9 = b7_y * W2_z;
    const float b10_x_10 = b10_x_8 + b10_x_9;
    const float b10_x_11 = b7_z * W2_y;
    const float b10_x_12 = b10_x_10 - b10_x_11;
    const float b10_y_1 = b9_z * W0_x;
    const float b10_y_2 = 0.0F + b10_y_1;
    const float b10_y_3 = b9_x * W0_z;
    const float b10_y_4 = b10_y_2 - b10_y_3;
    const float b10_y_5 = b8_z * W1_x;
    const float b10_y_6 = b10_y_4 + b10_y_5;
    const float b10_y_7 = b8_x * W1_z;
    const float b10_y_8 = b10_y_6 - b10_y_7;
    const float b10_y_9 = b7_z * W2_x;
    const float b10_y_10 = b10_y_8 + b10_y_9;
    const float b10_y_11 = b7_x * W2_z;
    const float b10_y_12 = b10_y_10 - b10_y_11;
    const float b10_z_1 = b9_x * W0_y;
    const float b10_z_2 = 0.0F + b10_z_1;
    const float b10_z_3 = b9_y * W0_x;
    const float b10_z_4 = b10_z_2 - b10_z_3;
    const float b10_z_5 = b8_x * W1_y;
    const float b10_z_6 = b10_z_4 + b10_z_5;
    const float b10_z_7 = b8_y * W1_x;
    const float b10_z_8 = b10_z_6 - b10_z_7;
    const float b10_z_9 = b7_x * W2_y;
    const float b10_z_10 = b10_z_8 + b10_z_9;
    const float b10_z_11 = b7_y * W2_x;
    const float b10_z_12 = b10_z_10 - b10_z_11;
    const float b10_x = 0.1F /* 1/10 */ * b10_x_12;
    const float db_x = db_x_8 + b10_x;
    const float b10_y = 0.1F /* 1/10 */ * b10_y_12;
    const float db_y = db_y_8 + b10_y;
    const float b10_z = 0.1F /* 1/10 */ * b10_z_12;
    const float db_z = db_z_8 + b10_z;

    /* y = increment - c, next = now + y, c_next = (next - now) - y, c the residual   [Kahan 1965] */
    const float residual_11 = state->residual[0];
    const float y_11 = da_x - residual_11;
    const float a_next_x = c_11 + y_11;
    const float gained_11 = a_next_x - c_11;
    const float residual_next_11 = gained_11 - y_11;
    const float residual_12 = state->residual[1];
    const float y_12 = da_y - residual_12;
    const float a_next_y = c_12 + y_12;
    const float gained_12 = a_next_y - c_12;
    const float residual_next_12 = gained_12 - y_12;
    const float residual_13 = state->residual[2];
    const float y_13 = da_z - residual_13;
    const float a_next_z = c_13 + y_13;
    const float gained_13 = a_next_z - c_13;
    const float residual_next_13 = gained_13 - y_13;
    const float residual_21 = state->residual[3];
    const float y_21 = db_x - residual_21;
    const float b_next_x = c_21 + y_21;
    const float gained_21 = b_next_x - c_21;
    const float residual_next_21 = gained_21 - y_21;
    const float residual_22 = state->residual[4];
    const float y_22 = db_y - residual_22;
    const float b_next_y = c_22 + y_22;
    const float gained_22 = b_next_y - c_22;
    const float residual_next_22 = gained_22 - y_22;
    const float residual_23 = state->residual[5];
    const float y_23 = db_z - residual_23;
    const float b_next_z = c_23 + y_23;
    const float gained_23 = b_next_z - c_23;
    const float residual_next_23 = gained_23 - y_23;

    /* c_next = a_next x b_next */
    const float c_next_x_1 = a_next_y * b_next_z;
    const float c_next_x_2 = a_next_z * b_next_y;
    const float c_next_x = c_next_x_1 - c_next_x_2;
    const float c_next_y_1 = a_next_z * b_next_x;
    const float c_next_y_2 = a_next_x * b_next_z;
    const float c_next_y = c_next_y_1 - c_next_y_2;
    const float c_next_z_1 = a_next_x * b_next_y;
    const float c_next_z_2 = a_next_y * b_next_x;
    const float c_next_z = c_next_z_1 - c_next_z_2;

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

    /* y = increment - c, next = now + y, c_next = (next - now) - y, c the residual   [Kahan 1965] */
    state->residual[0] = residual_next_11;
    state->residual[1] = residual_next_12;
    state->residual[2] = residual_next_13;
    state->residual[3] = residual_next_21;
    state->residual[4] = residual_next_22;
    state->residual[5] = residual_next_23;
}

void dcm_taylor_3_10_float32_compensated_renormalise(dcm_taylor_3_10_float32_compensated_state *state)
{
    /* c, read once */
    const float c_11 = state->c[0];
    const float c_12 = state->c[1];
    const float c_13 = state->c[2];
    const float c_21 = state->c[3];
    const float c_22 = state->c[4];
    const float c_23 = state->c[5];

    /* e_a = (1 - |a|^2)/2 */
    const float e_a_1 = c_11 * c_11;
    const float e_a_2 = c_12 * c_12;
    const float e_a_3 = c_13 * c_13;
    const float e_a_4 = e_a_1 + e_a_2;
    const float e_a_5 = e_a_4 + e_a_3;
    const float e_a_6 = 1.0F - e_a_5;
    const float e_a = 0.5F * e_a_6;

    /* e_b = (1 - |b|^2)/2 */
    const float e_b_1 = c_21 * c_21;
    const float e_b_2 = c_22 * c_22;
    const float e_b_3 = c_23 * c_23;
    const float e_b_4 = e_b_1 + e_b_2;
    const float e_b_5 = e_b_4 + e_b_3;
    const float e_b_6 = 1.0F - e_b_5;
    const float e_b = 0.5F * e_b_6;

    /* e_ab = a . b */
    const float e_ab_1 = c_11 * c_21;
    const float e_ab_2 = c_12 * c_22;
    const float e_ab_3 = c_13 * c_23;
    const float e_ab_4 = e_ab_1 + e_ab_2;
    const float e_ab = e_ab_4 + e_ab_3;

    /* a_next = a + e_a a */
    const float a_next_x_1 = e_a * c_11;
    const float a_next_y_1 = e_a * c_12;
    const float a_next_z_1 = e_a * c_13;
    const float a_next_x = c_11 + a_next_x_1;
    const float a_next_y = c_12 + a_next_y_1;
    const float a_next_z = c_13 + a_next_z_1;

    /* b_next = b + e_b b - e_ab a */
    const float b_next_x_1 = e_b * c_21;
    const float b_next_y_1 = e_b * c_22;
    const float b_next_z_1 = e_b * c_23;
    const float b_next_x_2 = c_21 + b_next_x_1;
    const float b_next_y_2 = c_22 + b_next_y_1;
    const float b_next_z_2 = c_23 + b_next_z_1;
    const float b_next_x_3 = e_ab * c_11;
    const float b_next_y_3 = e_ab * c_12;
    const float b_next_z_3 = e_ab * c_13;
    const float b_next_x = b_next_x_2 - b_next_x_3;
    const float b_next_y = b_next_y_2 - b_next_y_3;
    const float b_next_z = b_next_z_2 - b_next_z_3;

    /* c_next = a_next x b_next */
    const float c_next_x_1 = a_next_y * b_next_z;
    const float c_next_x_2 = a_next_z * b_next_y;
    const float c_next_x = c_next_x_1 - c_next_x_2;
    const float c_next_y_1 = a_next_z * b_next_x;
    const float c_next_y_2 = a_next_x * b_next_z;
    const float c_next_y = c_next_y_1 - c_next_y_2;
    const float c_next_z_1 = a_next_x * b_next_y;
    const float c_next_z_2 = a_next_y * b_next_x;
    const float c_next_z = c_next_z_1 - c_next_z_2;

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

void dcm_taylor_3_10_float32_compensated_quaternion(
    const dcm_taylor_3_10_float32_compensated_state *state, float q_nb[4])
{
    /* c, read once */
    const float state_11 = state->c[0];
    const float residual_11 = state->residual[0];
    const float c_11 = state_11 - residual_11;
    const float state_12 = state->c[1];
    const float residual_12 = state->residual[1];
    const float c_12 = state_12 - residual_12;
    const float state_13 = state->c[2];
    const float residual_13 = state->residual[2];
    const float c_13 = state_13 - residual_13;
    const float state_21 = state->c[3];
    const float residual_21 = state->residual[3];
    const float c_21 = state_21 - residual_21;
    const float state_22 = state->c[4];
    const float residual_22 = state->residual[4];
    const float c_22 = state_22 - residual_22;
    const float state_23 = state->c[5];
    const float residual_23 = state->residual[5];
    const float c_23 = state_23 - residual_23;
    const float c_31 = state->c[6];
    const float c_32 = state->c[7];
    const float c_33 = state->c[8];

    /* ww = 4 w w, wx = 4 w x and so on   [Shepperd 1978] */
    const float largest_1 = c_11 - c_22;
    const float largest_2 = largest_1 - c_33;
    const float largest_3 = largest_2 + 1.0F;
    const float largest_4 = c_22 - c_11;
    const float largest_5 = largest_4 - c_33;
    const float largest_6 = largest_5 + 1.0F;
    const float largest_7 = c_33 - c_11;
    const float largest_8 = largest_7 - c_22;
    const float largest_9 = largest_8 + 1.0F;
    const float trace_1 = c_11 + c_22;
    const float trace = trace_1 + c_33;
    const float ww = trace + 1.0F;
    const float wx = c_32 - c_23;
    const float wy = c_13 - c_31;
    const float wz = c_21 - c_12;
    const float xy = c_12 + c_21;
    const float xz = c_13 + c_31;
    const float yz = c_23 + c_32;

    /* largest = the greatest of 4 w w, 4 x x, 4 y y, 4 z z   [Shepperd 1978] */
    const int32_t largest_10 = ww < largest_3;
    const float largest_11 = (largest_10 != 0) ? largest_3 : ww;
    const float q_nb_w_1 = (largest_10 != 0) ? wx : ww;
    const float q_nb_x_1 = (largest_10 != 0) ? largest_3 : wx;
    const float q_nb_y_1 = (largest_10 != 0) ? xy : wy;
    const float q_nb_z_1 = (largest_10 != 0) ? xz : wz;
    const int32_t largest_12 = largest_11 < largest_6;
    const float largest_13 = (largest_12 != 0) ? largest_6 : largest_11;
    const float q_nb_w_2 = (largest_12 != 0) ? wy : q_nb_w_1;
    const float q_nb_x_2 = (largest_12 != 0) ? xy : q_nb_x_1;
    const float q_nb_y_2 = (largest_12 != 0) ? largest_6 : q_nb_y_1;
    const float q_nb_z_2 = (largest_12 != 0) ? yz : q_nb_z_1;
    const int32_t largest_14 = largest_13 < largest_9;
    const float largest = (largest_14 != 0) ? largest_9 : largest_13;
    const float q_nb_w_3 = (largest_14 != 0) ? wz : q_nb_w_2;
    const float q_nb_x_3 = (largest_14 != 0) ? xz : q_nb_x_2;
    const float q_nb_y_3 = (largest_14 != 0) ? yz : q_nb_y_2;
    const float q_nb_z_3 = (largest_14 != 0) ? largest_9 : q_nb_z_2;

    /* scale = 1/(2 sqrt(largest)) */
    const float scale_1 = largest * 0.006809806F /* 116991577/17179869184 */;
    const float scale_2 = -0.08719061F /* -383468370477/4398046511104 */ + scale_1;
    const float scale_3 = largest * scale_2;
    const float scale_4 = 0.4350525F /* 239172645671/549755813888 */ + scale_3;
    const float scale_5 = largest * scale_4;
    const float scale_6 = -1.0886095F /* -4787754840185/4398046511104 */ + scale_5;
    const float scale_7 = largest * scale_6;
    const float scale_8 = 1.7312461F /* 30456404726813/17592186044416 */ + scale_7;
    const float scale_9 = 0.5F * scale_8;
    const float scale_10 = scale_8 * scale_8;
    const float scale_11 = largest * scale_10;
    const float scale_12 = 1.0F - scale_11;
    const float scale_13 = scale_9 * scale_12;
    const float scale_14 = scale_8 + scale_13;
    const float scale_15 = 0.5F * scale_14;
    const float scale_16 = scale_14 * scale_14;
    const float scale_17 = largest * scale_16;
    const float scale_18 = 1.0F - scale_17;
    const float scale_19 = scale_15 * scale_18;
    const float scale_20 = scale_14 + scale_19;
    const float scale = 0.5F * scale_20;

    /* q_nb = scale (its row)   [Shepperd 1978] */
    const float q_nb_w = scale * q_nb_w_3;
    const float q_nb_x = scale * q_nb_x_3;
    const float q_nb_y = scale * q_nb_y_3;
    const float q_nb_z = scale * q_nb_z_3;

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void dcm_taylor_3_10_float32_compensated_dcm(
    const dcm_taylor_3_10_float32_compensated_state *state, float c_nb[9])
{
    /* c, read once */
    const float state_11 = state->c[0];
    const float residual_11 = state->residual[0];
    const float c_11 = state_11 - residual_11;
    const float state_12 = state->c[1];
    const float residual_12 = state->residual[1];
    const float c_12 = state_12 - residual_12;
    const float state_13 = state->c[2];
    const float residual_13 = state->residual[2];
    const float c_13 = state_13 - residual_13;
    const float state_21 = state->c[3];
    const float residual_21 = state->residual[3];
    const float c_21 = state_21 - residual_21;
    const float state_22 = state->c[4];
    const float residual_22 = state->residual[4];
    const float c_22 = state_22 - residual_22;
    const float state_23 = state->c[5];
    const float residual_23 = state->residual[5];
    const float c_23 = state_23 - residual_23;
    const float c_31 = state->c[6];
    const float c_32 = state->c[7];
    const float c_33 = state->c[8];

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
