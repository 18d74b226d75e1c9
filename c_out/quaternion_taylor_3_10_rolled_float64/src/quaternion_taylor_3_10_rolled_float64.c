/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_10_rolled_float64
 *
 * qcone 0.1.0, design quaternion_taylor_3_10_rolled_float64, SHA-256 of the design
 * 5ed69a4d64fb4287b0559e3be13c994a9f22eda19fc6847ea786aee5b425e34b
 *
 * algorithm:   quaternion-taylor-3-10-start, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      xu2019 (5), (7), (8)
 * equation:    r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n
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
 * update as-written      448       0  261       196       0       0     0     0     0       0
 * update shared          447       1  261       196       0       0     0     0     0       0
 * update emitted         447       1  261       196       0       0     0     0     0       0
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
#include "quaternion_taylor_3_10_rolled_float64.h"

#if QUATERNION_TAYLOR_3_10_ROLLED_FLOAT64_VERSION != 1
#error "quaternion_taylor_3_10_rolled_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void quaternion_taylor_3_10_rolled_float64_init(quaternion_taylor_3_10_rolled_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void quaternion_taylor_3_10_rolled_float64_set_quaternion(
    quaternion_taylor_3_10_rolled_float64_state *state, const double q_nb[4])
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

void quaternion_taylor_3_10_rolled_float64_update(
    quaternion_taylor_3_10_rolled_float64_state *state, const double dtheta[9])
{
    static const double fit[9] = {
        1.5, -0.75, 0.5, 0.0, 4.5, -4.5, 0.0, 0.0, 6.75
    };
    static const double inverse[11] = {
        0.0, 1.0, 0.5, 0.3333333333333333 /* 1/3 */, 0.25, 0.2 /* 1/5 */, 0.16666666666666666 /* 1/6 */,
        0.14285714285714285 /* 1/7 */, 0.125, 0.1111111111111111 /* 1/9 */, 0.1 /* 1/10 */
    };
    double f[9];
    double A[15];
    double sum[1];
    double r[78];
    double term[4];
    double total[4];
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
            const double f_1 = f[8 - i];
            const double f_2 = f[5 - i];
            const double f_3 = f_1 - f_2;
            f[8 - i] = f_3;
        }
    }

    /* A_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
    for (int32_t j = 0; j <= 2; ++j) {
        for (int32_t i = 0; i <= 2; ++i) {
            sum[0] = 0.0;
            for (int32_t k = 0; k <= 2; ++k) {
                const double sum_2 = sum[0];
                const double sum_1 = fit[3 * j + k];
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
    for (int32_t i = 0; i <= 17; ++i) {
        r[i] = 0.0;
    }
    r[12] = 1.0;
    for (int32_t i = 0; i <= 3; ++i) {
        total[i] = 0.0;
    }

    /* total = r_1 + ... + r_10   [xu2019 (8)] */
    for (int32_t n = 1; n <= 10; ++n) {
        /* r_n = 1/n sum_j r_(n-1-j) (x) A_j   [xu2019 (7)] */
        for (int32_t i = 0; i <= 3; ++i) {
            term[i] = 0.0;
        }
        for (int32_t j = 0; j <= 2; ++j) {
            for (int32_t i = 0; i <= 2; ++i) {
                const double term1 = term[0];
                const double term_1 = r[6 * n - 6 * j + i + 7];
                const double term_2 = A[5 * j + i];
                const double term_3 = term_1 * term_2;
                const double term_4 = term1 - term_3;
                term[0] = term_4;
                const double term_5 = term[i + 1];
                const double term_6 = r[6 * n - 6 * j + 6];
                const double term_7 = A[5 * j + i];
                const double term_8 = term_6 * term_7;
                const double term_9 = term_5 + term_8;
                const double term_10 = r[6 * n - 6 * j + i + 8];
                const double term_11 = A[5 * j + i + 2];
                const double term_12 = term_10 * term_11;
                const double term_13 = term_9 + term_12;
                const double term_14 = r[6 * n - 6 * j + i + 9];
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
            r[6 * n + i + 12] = r_3;
            const double total_1 = r[6 * n + i + 12];
            const double total_2 = total[i];
            const double total_3 = total_2 + total_1;
            total[i] = total_3;
        }
        const double r_4 = r[6 * n + 13];
        r[6 * n + 16] = r_4;
        const double r_5 = r[6 * n + 14];
        r[6 * n + 17] = r_5;
    }

    /* (total,) = _terms(rate, dtheta[0], subsamples, order, 1) */
    const double total1 = total[0];
    const double total2 = total[1];
    const double total3 = total[2];
    const double total4 = total[3];

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
    const double a = total1 + e;

    /* dq = q (x) [a, v]   [cao (14)] */
    const double dq_w_1 = q_w * a;
    const double dq_w_2 = q_x * total2;
    const double dq_w_3 = dq_w_1 - dq_w_2;
    const double dq_w_4 = q_y * total3;
    const double dq_w_5 = dq_w_3 - dq_w_4;
    const double dq_w_6 = q_z * total4;
    const double dq_w = dq_w_5 - dq_w_6;
    const double dq_x_1 = q_w * total2;
    const double dq_x_2 = q_x * a;
    const double dq_x_3 = dq_x_1 + dq_x_2;
    const double dq_x_4 = q_y * total4;
    const double dq_x_5 = dq_x_3 + dq_x_4;
    const double dq_x_6 = q_z * total3;
    const double dq_x = dq_x_5 - dq_x_6;
    const double dq_y_1 = q_w * total3;
    const double dq_y_2 = q_y * a;
    const double dq_y_3 = dq_y_1 + dq_y_2;
    const double dq_y_4 = q_z * total2;
    const double dq_y_5 = dq_y_3 + dq_y_4;
    const double dq_y_6 = q_x * total4;
    const double dq_y = dq_y_5 - dq_y_6;
    const double dq_z_1 = q_w * total4;
    const double dq_z_2 = q_z * a;
    const double dq_z_3 = dq_z_1 + dq_z_2;
    const double dq_z_4 = q_x * total3;
    const double dq_z_5 = dq_z_3 + dq_z_4;
    const double dq_z_6 = q_y * total2;
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

void quaternion_taylor_3_10_rolled_float64_quaternion(
    const quaternion_taylor_3_10_rolled_float64_state *state, double q_nb[4])
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

void quaternion_taylor_3_10_rolled_float64_dcm(
    const quaternion_taylor_3_10_rolled_float64_state *state, double c_nb[9])
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
