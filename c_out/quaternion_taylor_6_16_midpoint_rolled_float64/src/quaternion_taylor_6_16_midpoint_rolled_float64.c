/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_6_16_midpoint_rolled_float64
 *
 * qcone 0.1.0, design quaternion_taylor_6_16_midpoint_rolled_float64, SHA-256 of the design
 * e6e35e68d0d15d96cd25364897bc33432919ee992b37ac559ff6a2ba312e2d5c
 *
 * algorithm:   quaternion-taylor-6-16-midpoint, form factored, q' = q + q (x) (r - 1),
 *              renormalised on every update
 * source:      xu2019 (5), (7), (8)
 * equation:    r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.016668 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 8 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written     1425       0  837       637       0       0     0     0     0       0
 * update shared         1424       1  837       637       0       0     0     0     0       0
 * update emitted        1424       1  837       637       0       0     0     0     0       0
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
#include "quaternion_taylor_6_16_midpoint_rolled_float64.h"

#if QUATERNION_TAYLOR_6_16_MIDPOINT_ROLLED_FLOAT64_VERSION != 1
#error "quaternion_taylor_6_16_midpoint_rolled_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void quaternion_taylor_6_16_midpoint_rolled_float64_init(
    quaternion_taylor_6_16_midpoint_rolled_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void quaternion_taylor_6_16_midpoint_rolled_float64_set_quaternion(
    quaternion_taylor_6_16_midpoint_rolled_float64_state *state, const double q_nb[4])
{
    /* q_nb, read once */
    const double q_nb_w = q_nb[0];
    const double q_nb_x = q_nb[1];
    const double q_nb_y = q_nb[2];
    const double q_nb_z = q_nb[3];

    /* q_square = |q|^2 */
    const double q_square_1 = q_nb_w * q_nb_w;
    const double q_square_2 = q_nb_x * q_nb_x;
    const double q_square_3 = q_square_1 + q_square_2;
    const double q_square_4 = q_nb_y * q_nb_y;
    const double q_square_5 = q_square_3 + q_square_4;
    const double q_square_6 = q_nb_z * q_nb_z;
    const double q_square = q_square_5 + q_square_6;

    /* e = (1 - |q|^2)/2 */
    const double e_1 = 1.0 - q_square;
    const double e = 0.5 * e_1;

    /* q_next = q + e q */
    const double q_next_w_1 = e * q_nb_w;
    const double q_next_x_1 = e * q_nb_x;
    const double q_next_y_1 = e * q_nb_y;
    const double q_next_z_1 = e * q_nb_z;
    const double q_next_w = q_nb_w + q_next_w_1;
    const double q_next_x = q_nb_x + q_next_x_1;
    const double q_next_y = q_nb_y + q_next_y_1;
    const double q_next_z = q_nb_z + q_next_z_1;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void quaternion_taylor_6_16_midpoint_rolled_float64_update(
    quaternion_taylor_6_16_midpoint_rolled_float64_state *state, const double dtheta[18])
{
    static const double fit[36] = {
        1.5, 3.75, 2.75, 0.375, -0.075 /* -3/40 */, 0.025 /* 1/40 */, 0.0, 4.5, 9.0, 4.125, -0.375,
        0.05 /* 1/20 */, 0.0, 0.0, 6.75, 10.125, 1.6875 /* 27/16 */, -0.84375 /* -27/32 */, 0.0, 0.0,
        0.0, 6.75, 6.75, -1.125, 0.0, 0.0, 0.0, 0.0, 5.0625 /* 81/16 */, 2.53125 /* 81/32 */, 0.0, 0.0,
        0.0, 0.0, 0.0, 3.0375 /* 243/80 */
    };
    static const double inverse[17] = {
        0.0, 1.0, 0.5, 0.3333333333333333 /* 1/3 */, 0.25, 0.2 /* 1/5 */, 0.16666666666666666 /* 1/6 */,
        0.14285714285714285 /* 1/7 */, 0.125, 0.1111111111111111 /* 1/9 */, 0.1 /* 1/10 */,
        0.09090909090909091 /* 1/11 */, 0.08333333333333333 /* 1/12 */, 0.07692307692307693 /* 1/13 */,
        0.07142857142857142 /* 1/14 */, 0.06666666666666667 /* 1/15 */, 0.0625 /* 1/16 */
    };
    static const double sign[34] = {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -1.0,
        1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0
    };
    double f[18];
    double A[30];
    double sum[1];
    double r[132];
    double term[4];
    double total[8];
    /* attitude and input */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];
    const double dtheta1_x = dtheta[0];
    const double dtheta1_y = dtheta[1];
    const double dtheta1_z = dtheta[2];
    const double dtheta2_x = dtheta[3];
    const double dtheta2_y = dtheta[4];
    const double dtheta2_z = dtheta[5];
    const double dtheta3_x = dtheta[6];
    const double dtheta3_y = dtheta[7];
    const double dtheta3_z = dtheta[8];
    const double dtheta4_x = dtheta[9];
    const double dtheta4_y = dtheta[10];
    const double dtheta4_z = dtheta[11];
    const double dtheta5_x = dtheta[12];
    const double dtheta5_y = dtheta[13];
    const double dtheta5_z = dtheta[14];
    const double dtheta6_x = dtheta[15];
    const double dtheta6_y = dtheta[16];
    const double dtheta6_z = dtheta[17];

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
    f[9] = dtheta4_x;
    f[10] = dtheta4_y;
    f[11] = dtheta4_z;
    f[12] = dtheta5_x;
    f[13] = dtheta5_y;
    f[14] = dtheta5_z;
    f[15] = dtheta6_x;
    f[16] = dtheta6_y;
    f[17] = dtheta6_z;
    for (int32_t k = 1; k <= 5; ++k) {
        for (int32_t i = 0; i <= 17 - 3 * k; ++i) {
            const double f_1 = f[17 - i];
            const double f_2 = f[14 - i];
            const double f_3 = f_1 - f_2;
            f[17 - i] = f_3;
        }
    }

    /* A_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    for (int32_t j = 0; j <= 5; ++j) {
        for (int32_t i = 0; i <= 2; ++i) {
            sum[0] = 0.0;
            for (int32_t k = 0; k <= 5; ++k) {
                const double sum_2 = sum[0];
                const double sum_1 = fit[6 * j + k];
                const double sum_4 = f[3 * k + i];
                const double sum_5 = sum_1 * sum_4;
                const double sum_6 = sum_2 + sum_5;
                sum[0] = sum_6;
            }
            const double sum_3 = sum[0];
            A[5 * j + i] = sum_3;
        }
        const double A_1 = A[5 * j];
        A[5 * j + 3] = A_1;
        const double A_2 = A[5 * j + 1];
        A[5 * j + 4] = A_2;
    }

    /* r_0 = 1   [xu2019 (8)] */
    for (int32_t i = 0; i <= 35; ++i) {
        r[i] = 0.0;
    }
    r[30] = 1.0;
    for (int32_t i = 0; i <= 7; ++i) {
        total[i] = 0.0;
    }

    /* total = r_1 + ... + r_16, and with alternating signs   [xu2019 (8)] */
    for (int32_t n = 1; n <= 16; ++n) {
        /* r_n = 1/n sum_j r_(n-1-j) (x) A_j   [xu2019 (7)] */
        for (int32_t i = 0; i <= 3; ++i) {
            term[i] = 0.0;
        }
        for (int32_t j = 0; j <= 5; ++j) {
            for (int32_t i = 0; i <= 2; ++i) {
                const double term1 = term[0];
                const double term_1 = r[6 * n - 6 * j + i + 25];
                const double term_2 = A[5 * j + i];
                const double term_3 = term_1 * term_2;
                const double term_4 = term1 - term_3;
                term[0] = term_4;
                const double term_5 = term[i + 1];
                const double term_6 = r[6 * n - 6 * j + 24];
                const double term_7 = A[5 * j + i];
                const double term_8 = term_6 * term_7;
                const double term_9 = term_5 + term_8;
                const double term_10 = r[6 * n - 6 * j + i + 26];
                const double term_11 = A[5 * j + i + 2];
                const double term_12 = term_10 * term_11;
                const double term_13 = term_9 + term_12;
                const double term_14 = r[6 * n - 6 * j + i + 27];
                const double term_15 = A[5 * j + i + 1];
                const double term_16 = term_14 * term_15;
                const double term_17 = term_13 - term_16;
                term[i + 1] = term_17;
            }
        }
        for (int32_t i = 0; i <= 3; ++i) {
            const double r_1 = inverse[n];
            const double r_2 = term[i];
            const double r_3 = r_1 * r_2;
            r[6 * n + i + 30] = r_3;
            const double total_1 = r[6 * n + i + 30];
            const double total_2 = total[i];
            const double total_3 = total_2 + total_1;
            total[i] = total_3;
            const double total_4 = sign[n + 17];
            const double total_5 = r[6 * n + i + 30];
            const double total_6 = total_4 * total_5;
            const double total_7 = total[i + 4];
            const double total_8 = total_7 + total_6;
            total[i + 4] = total_8;
        }
        const double r_4 = r[6 * n + 31];
        r[6 * n + 34] = r_4;
        const double r_5 = r[6 * n + 32];
        r[6 * n + 35] = r_5;
    }

    /* u = scalar part of r - 1   [r = (E - O)* (x) (E + O)] */
    const double total1 = total[0];
    const double total2 = total[1];
    const double total3 = total[2];
    const double total4 = total[3];
    const double total5 = total[4];
    const double total6 = total[5];
    const double total7 = total[6];
    const double total8 = total[7];
    const double u_1 = total5 + total1;
    const double u_2 = total5 * total1;
    const double u_3 = total6 * total2;
    const double u_4 = u_2 + u_3;
    const double u_5 = total7 * total3;
    const double u_6 = u_4 + u_5;
    const double u_7 = total8 * total4;
    const double u_8 = u_6 + u_7;
    const double u = u_1 + u_8;
    const double v_x_1 = total2 - total6;
    const double v_x_2 = total5 * total2;
    const double v_x_3 = total6 * total1;
    const double v_x_4 = v_x_2 - v_x_3;
    const double v_x_5 = total7 * total4;
    const double v_x_6 = v_x_4 - v_x_5;
    const double v_x_7 = total8 * total3;
    const double v_x_8 = v_x_6 + v_x_7;
    const double v_x = v_x_1 + v_x_8;
    const double v_y_1 = total3 - total7;
    const double v_y_2 = total5 * total3;
    const double v_y_3 = total7 * total1;
    const double v_y_4 = v_y_2 - v_y_3;
    const double v_y_5 = total8 * total2;
    const double v_y_6 = v_y_4 - v_y_5;
    const double v_y_7 = total6 * total4;
    const double v_y_8 = v_y_6 + v_y_7;
    const double v_y = v_y_1 + v_y_8;
    const double v_z_1 = total4 - total8;
    const double v_z_2 = total5 * total4;
    const double v_z_3 = total8 * total1;
    const double v_z_4 = v_z_2 - v_z_3;
    const double v_z_5 = total6 * total3;
    const double v_z_6 = v_z_4 - v_z_5;
    const double v_z_7 = total7 * total2;
    const double v_z_8 = v_z_6 + v_z_7;
    const double v_z = v_z_1 + v_z_8;

    /* q_square = |q|^2 */
    const double q_square_1 = q_w * q_w;
    const double q_square_2 = q_x * q_x;
    const double q_square_3 = q_y * q_y;
    const double q_square_4 = q_z * q_z;
    const double q_square_5 = q_square_1 + q_square_2;
    const double q_square_6 = q_square_5 + q_square_3;
    const double q_square = q_square_6 + q_square_4;

    /* e = (1 - |q|^2)/2   [renormalisation, folded into the scalar part] */
    const double e_1 = 1.0 - q_square;
    const double e = 0.5 * e_1;

    /* a = u + e */
    const double a = u + e;

    /* dq = q (x) [a, v]   [cao (14)] */
    const double dq_w_1 = q_w * a;
    const double dq_w_2 = q_x * v_x;
    const double dq_w_3 = dq_w_1 - dq_w_2;
    const double dq_w_4 = q_y * v_y;
    const double dq_w_5 = dq_w_3 - dq_w_4;
    const double dq_w_6 = q_z * v_z;
    const double dq_w = dq_w_5 - dq_w_6;
    const double dq_x_1 = q_w * v_x;
    const double dq_x_2 = q_x * a;
    const double dq_x_3 = dq_x_1 + dq_x_2;
    const double dq_x_4 = q_y * v_z;
    const double dq_x_5 = dq_x_3 + dq_x_4;
    const double dq_x_6 = q_z * v_y;
    const double dq_x = dq_x_5 - dq_x_6;
    const double dq_y_1 = q_w * v_y;
    const double dq_y_2 = q_y * a;
    const double dq_y_3 = dq_y_1 + dq_y_2;
    const double dq_y_4 = q_z * v_x;
    const double dq_y_5 = dq_y_3 + dq_y_4;
    const double dq_y_6 = q_x * v_z;
    const double dq_y = dq_y_5 - dq_y_6;
    const double dq_z_1 = q_w * v_z;
    const double dq_z_2 = q_z * a;
    const double dq_z_3 = dq_z_1 + dq_z_2;
    const double dq_z_4 = q_x * v_y;
    const double dq_z_5 = dq_z_3 + dq_z_4;
    const double dq_z_6 = q_y * v_x;
    const double dq_z = dq_z_5 - dq_z_6;

    /* q_next = q + dq */
    const double q_next_w = q_w + dq_w;
    const double q_next_x = q_x + dq_x;
    const double q_next_y = q_y + dq_y;
    const double q_next_z = q_z + dq_z;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void quaternion_taylor_6_16_midpoint_rolled_float64_quaternion(
    const quaternion_taylor_6_16_midpoint_rolled_float64_state *state, double q_nb[4])
{
    /* q, read once */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];

    q_nb[0] = q_w;
    q_nb[1] = q_x;
    q_nb[2] = q_y;
    q_nb[3] = q_z;
}

void quaternion_taylor_6_16_midpoint_rolled_float64_dcm(
    const quaternion_taylor_6_16_midpoint_rolled_float64_state *state, double c_nb[9])
{
    /* q, read once */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const double x2 = q_x + q_x;
    const double y2 = q_y + q_y;
    const double z2 = q_z + q_z;
    const double wx = q_w * x2;
    const double wy = q_w * y2;
    const double wz = q_w * z2;
    const double xx = q_x * x2;
    const double xy = q_x * y2;
    const double xz = q_x * z2;
    const double yy = q_y * y2;
    const double yz = q_y * z2;
    const double zz = q_z * z2;

    /* c_nb = C_nb(q)   [cao (15)] */
    const double c_nb_11_1 = yy + zz;
    const double c_nb_11 = 1.0 - c_nb_11_1;
    const double c_nb_12 = xy - wz;
    const double c_nb_13 = xz + wy;
    const double c_nb_21 = xy + wz;
    const double c_nb_22_1 = xx + zz;
    const double c_nb_22 = 1.0 - c_nb_22_1;
    const double c_nb_23 = yz - wx;
    const double c_nb_31 = xz - wy;
    const double c_nb_32 = yz + wx;
    const double c_nb_33_1 = xx + yy;
    const double c_nb_33 = 1.0 - c_nb_33_1;

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
