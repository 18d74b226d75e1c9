/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_10_midpoint_rolled_float32
 *
 * qcone 0.1.0, design quaternion_taylor_3_10_midpoint_rolled_float32, SHA-256 of the design
 * 3ad4c7749bbeab38ff01488530be01568f2594e5e9d401f45ac8ab477b7c371d
 *
 * algorithm:   quaternion-taylor-3-10-midpoint, form factored, q' = q + q (x) (r - 1),
 *              renormalised on every update
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
 * update as-written      504       0  312       205       0       0     0     0     0       0
 * update shared          503       1  312       205       0       0     0     0     0       0
 * update emitted         503       1  312       205       0       0     0     0     0       0
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
#include "quaternion_taylor_3_10_midpoint_rolled_float32.h"

#if QUATERNION_TAYLOR_3_10_MIDPOINT_ROLLED_FLOAT32_VERSION != 1
#error "quaternion_taylor_3_10_midpoint_rolled_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void quaternion_taylor_3_10_midpoint_rolled_float32_init(
    quaternion_taylor_3_10_midpoint_rolled_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
}

void quaternion_taylor_3_10_midpoint_rolled_float32_set_quaternion(
    quaternion_taylor_3_10_midpoint_rolled_float32_state *state, const float q_nb[4])
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

void quaternion_taylor_3_10_midpoint_rolled_float32_update(
    quaternion_taylor_3_10_midpoint_rolled_float32_state *state, const float dtheta[9])
{
    static const float fit[9] = {
        0.75F, 0.75F, -0.03125F /* -1/32 */, 0.0F, 1.125F, 0.5625F /* 9/16 */, 0.0F, 0.0F,
        0.84375F /* 27/32 */
    };
    static const float inverse[11] = {
        0.0F, 1.0F, 0.5F, 0.33333334F /* 1/3 */, 0.25F, 0.2F /* 1/5 */, 0.16666667F /* 1/6 */,
        0.14285715F /* 1/7 */, 0.125F, 0.11111111F /* 1/9 */, 0.1F /* 1/10 */
    };
    static const float sign[22] = {
        1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, -1.0F, 1.0F, -1.0F, 1.0F,
        -1.0F, 1.0F, -1.0F, 1.0F, -1.0F, 1.0F
    };
    float f[9];
    float A[15];
    float sum[1];
    float r[78];
    float term[4];
    float total[8];
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
    f[0] = dtheta1_x;
    f[1] = dtheta1_y;
    f[2] = dtheta1_z;
    f[3] = dtheta2_x;
    f[4] = dtheta2_y;
    f[5] = dtheta2_z;
    f[6] = dtheta3_x;
    f[7] = dtheta3_y;
    f[8] = dtheta3_z;
    for (int32_t k = 1; k <= 2; ++k) {
        for (int32_t i = 0; i <= 8 - 3 * k; ++i) {
            const float f_1 = f[8 - i];
            const float f_2 = f[5 - i];
            const float f_3 = f_1 - f_2;
            f[8 - i] = f_3;
        }
    }

    /* A_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    for (int32_t j = 0; j <= 2; ++j) {
        for (int32_t i = 0; i <= 2; ++i) {
            sum[0] = 0.0F;
            for (int32_t k = 0; k <= 2; ++k) {
                const float sum_2 = sum[0];
                const float sum_1 = fit[3 * j + k];
                const float sum_4 = f[3 * k + i];
                const float sum_5 = sum_1 * sum_4;
                const float sum_6 = sum_2 + sum_5;
                sum[0] = sum_6;
            }
            const float sum_3 = sum[0];
            A[5 * j + i] = sum_3;
        }
        const float A_1 = A[5 * j];
        A[5 * j + 3] = A_1;
        const float A_2 = A[5 * j + 1];
        A[5 * j + 4] = A_2;
    }

    /* r_0 = 1   [xu2019 (8)] */
    for (int32_t i = 0; i <= 17; ++i) {
        r[i] = 0.0F;
    }
    r[12] = 1.0F;
    for (int32_t i = 0; i <= 7; ++i) {
        total[i] = 0.0F;
    }

    /* total = r_1 + ... + r_10, and with alternating signs   [xu2019 (8)] */
    for (int32_t n = 1; n <= 10; ++n) {
        /* r_n = 1/n sum_j r_(n-1-j) (x) A_j   [xu2019 (7)] */
        for (int32_t i = 0; i <= 3; ++i) {
            term[i] = 0.0F;
        }
        for (int32_t j = 0; j <= 2; ++j) {
            for (int32_t i = 0; i <= 2; ++i) {
                const float term1 = term[0];
                const float term_1 = r[6 * n - 6 * j + i + 7];
                const float term_2 = A[5 * j + i];
                const float term_3 = term_1 * term_2;
                const float term_4 = term1 - term_3;
                term[0] = term_4;
                const float term_5 = term[i + 1];
                const float term_6 = r[6 * n - 6 * j + 6];
                const float term_7 = A[5 * j + i];
                const float term_8 = term_6 * term_7;
                const float term_9 = term_5 + term_8;
                const float term_10 = r[6 * n - 6 * j + i + 8];
                const float term_11 = A[5 * j + i + 2];
                const float term_12 = term_10 * term_11;
                const float term_13 = term_9 + term_12;
                const float term_14 = r[6 * n - 6 * j + i + 9];
                const float term_15 = A[5 * j + i + 1];
                const float term_16 = term_14 * term_15;
                const float term_17 = term_13 - term_16;
                term[i + 1] = term_17;
            }
        }
        for (int32_t i = 0; i <= 3; ++i) {
            const float r_1 = inverse[n];
            const float r_2 = term[i];
            const float r_3 = r_1 * r_2;
            r[6 * n + i + 12] = r_3;
            const float total_1 = r[6 * n + i + 12];
            const float total_2 = total[i];
            const float total_3 = total_2 + total_1;
            total[i] = total_3;
            const float total_4 = sign[n + 11];
            const float total_5 = r[6 * n + i + 12];
            const float total_6 = total_4 * total_5;
            const float total_7 = total[i + 4];
            const float total_8 = total_7 + total_6;
            total[i + 4] = total_8;
        }
        const float r_4 = r[6 * n + 13];
        r[6 * n + 16] = r_4;
        const float r_5 = r[6 * n + 14];
        r[6 * n + 17] = r_5;
    }

    /* u = scalar part of r - 1   [r = (E - O)* (x) (E + O)] */
    const float total1 = total[0];
    const float total2 = total[1];
    const float total3 = total[2];
    const float total4 = total[3];
    const float total5 = total[4];
    const float total6 = total[5];
    const float total7 = total[6];
    const float total8 = total[7];
    const float u_1 = total5 + total1;
    const float u_2 = total5 * total1;
    const float u_3 = total6 * total2;
    const float u_4 = u_2 + u_3;
    const float u_5 = total7 * total3;
    const float u_6 = u_4 + u_5;
    const float u_7 = total8 * total4;
    const float u_8 = u_6 + u_7;
    const float u = u_1 + u_8;
    const float v_x_1 = total2 - total6;
    const float v_x_2 = total5 * total2;
    const float v_x_3 = total6 * total1;
    const float v_x_4 = v_x_2 - v_x_3;
    const float v_x_5 = total7 * total4;
    const float v_x_6 = v_x_4 - v_x_5;
    const float v_x_7 = total8 * total3;
    const float v_x_8 = v_x_6 + v_x_7;
    const float v_x = v_x_1 + v_x_8;
    const float v_y_1 = total3 - total7;
    const float v_y_2 = total5 * total3;
    const float v_y_3 = total7 * total1;
    const float v_y_4 = v_y_2 - v_y_3;
    const float v_y_5 = total8 * total2;
    const float v_y_6 = v_y_4 - v_y_5;
    const float v_y_7 = total6 * total4;
    const float v_y_8 = v_y_6 + v_y_7;
    const float v_y = v_y_1 + v_y_8;
    const float v_z_1 = total4 - total8;
    const float v_z_2 = total5 * total4;
    const float v_z_3 = total8 * total1;
    const float v_z_4 = v_z_2 - v_z_3;
    const float v_z_5 = total6 * total3;
    const float v_z_6 = v_z_4 - v_z_5;
    const float v_z_7 = total7 * total2;
    const float v_z_8 = v_z_6 + v_z_7;
    const float v_z = v_z_1 + v_z_8;

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

void quaternion_taylor_3_10_midpoint_rolled_float32_quaternion(
    const quaternion_taylor_3_10_midpoint_rolled_float32_state *state, float q_nb[4])
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

void quaternion_taylor_3_10_midpoint_rolled_float32_dcm(
    const quaternion_taylor_3_10_midpoint_rolled_float32_state *state, float c_nb[9])
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
