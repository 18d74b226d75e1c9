/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_rolled_float64
 *
 * qcone 0.1.0, design dcm_taylor_3_10_rolled_float64, SHA-256 of the design
 * 6610f2d61e291a24171d83c5fc6fc6cf322a926a5a3d37000069ebc7687c5de4
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
 * update shared          471       2  285       197       0       0     0     0     0       0
 * update emitted         471       2  285       197       0       0     0     0     0       0
 * dcm as-written           0       0    0         0       0       0     0     0     0       0
 * dcm shared               0       0    0         0       0       0     0     0     0       0
 * dcm emitted              0       0    0         0       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "dcm_taylor_3_10_rolled_float64.h"

#if DCM_TAYLOR_3_10_ROLLED_FLOAT64_VERSION != 1
#error "dcm_taylor_3_10_rolled_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void dcm_taylor_3_10_rolled_float64_init(dcm_taylor_3_10_rolled_float64_state *state)
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

void dcm_taylor_3_10_rolled_float64_set_dcm(
    dcm_taylor_3_10_rolled_float64_state *state, const double c_nb[9])
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

void dcm_taylor_3_10_rolled_float64_update(
    dcm_taylor_3_10_rolled_float64_state *state, const double dtheta[9])
{
    static const double fit[9] = {
        3.0, -1.5, 1.0, 0.0, 9.0, -9.0, 0.0, 0.0, 13.5
    };
    static const double inverse_a[11] = {
        0.0, 1.0, 0.5, 0.3333333333333333 /* 1/3 */, 0.25, 0.2 /* 1/5 */, 0.16666666666666666 /* 1/6 */,
        0.14285714285714285 /* 1/7 */, 0.125, 0.1111111111111111 /* 1/9 */, 0.1 /* 1/10 */
    };
    static const double inverse_b[11] = {
        0.0, 1.0, 0.5, 0.3333333333333333 /* 1/3 */, 0.25, 0.2 /* 1/5 */, 0.16666666666666666 /* 1/6 */,
        0.14285714285714285 /* 1/7 */, 0.125, 0.1111111111111111 /* 1/9 */, 0.1 /* 1/10 */
    };
    double f[9];
    double W[15];
    double sum[1];
    double a[65];
    double t_a[3];
    double da[3];
    double b[65];
    double t_b[3];
    double db[3];
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

    /* W_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
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
            W[5 * j + i] = sum_3;
        }
        const double W_1 = W[5 * j];
        W[5 * j + 3] = W_1;
        const double W_2 = W[5 * j + 1];
        W[5 * j + 4] = W_2;
    }

    /* a_0 = a row of C   [xu2019 (12)] */
    for (int32_t i = 0; i <= 14; ++i) {
        a[i] = 0.0;
    }
    a[10] = c_11;
    a[11] = c_12;
    a[12] = c_13;
    a[13] = c_11;
    a[14] = c_12;
    for (int32_t i = 0; i <= 2; ++i) {
        da[i] = 0.0;
    }

    /* da = sum a_n   [xu2019 (12)] */
    for (int32_t n = 1; n <= 10; ++n) {
        /* a_n = 1/n sum_j a_(n-1-j) x W_j   [xu2019 (13)] */
        for (int32_t i = 0; i <= 2; ++i) {
            t_a[i] = 0.0;
            for (int32_t j = 0; j <= 2; ++j) {
                const double t_a_1 = t_a[i];
                const double t_a_2 = a[5 * n - 5 * j + i + 6];
                const double t_a_3 = W[5 * j + i + 2];
                const double t_a_4 = t_a_2 * t_a_3;
                const double t_a_5 = t_a_1 + t_a_4;
                const double t_a_6 = a[5 * n - 5 * j + i + 7];
                const double t_a_7 = W[5 * j + i + 1];
                const double t_a_8 = t_a_6 * t_a_7;
                const double t_a_9 = t_a_5 - t_a_8;
                t_a[i] = t_a_9;
            }
        }
        for (int32_t i = 0; i <= 2; ++i) {
            const double a_1 = inverse_a[n];
            const double a_2 = t_a[i];
            const double a_3 = a_1 * a_2;
            a[5 * n + i + 10] = a_3;
            const double da_1 = da[i];
            const double da_2 = a[5 * n + i + 10];
            const double da_3 = da_1 + da_2;
            da[i] = da_3;
        }
        const double a_4 = a[5 * n + 10];
        a[5 * n + 13] = a_4;
        const double a_5 = a[5 * n + 11];
        a[5 * n + 14] = a_5;
    }

    /* da = sum a_n   [xu2019 (12)] */
    const double da1 = da[0];
    const double da2 = da[1];
    const double da3 = da[2];

    /* b_0 = a row of C   [xu2019 (12)] */
    for (int32_t i = 0; i <= 14; ++i) {
        b[i] = 0.0;
    }
    b[10] = c_21;
    b[11] = c_22;
    b[12] = c_23;
    b[13] = c_21;
    b[14] = c_22;
    for (int32_t i = 0; i <= 2; ++i) {
        db[i] = 0.0;
    }

    /* db = sum b_n   [xu2019 (12)] */
    for (int32_t n = 1; n <= 10; ++n) {
        /* b_n = 1/n sum_j b_(n-1-j) x W_j   [xu2019 (13)] */
        for (int32_t i = 0; i <= 2; ++i) {
            t_b[i] = 0.0;
            for (int32_t j = 0; j <= 2; ++j) {
                const double t_b_1 = t_b[i];
                const double t_b_2 = b[5 * n - 5 * j + i + 6];
                const double t_b_3 = W[5 * j + i + 2];
                const double t_b_4 = t_b_2 * t_b_3;
                const double t_b_5 = t_b_1 + t_b_4;
                const double t_b_6 = b[5 * n - 5 * j + i + 7];
                const double t_b_7 = W[5 * j + i + 1];
                const double t_b_8 = t_b_6 * t_b_7;
                const double t_b_9 = t_b_5 - t_b_8;
                t_b[i] = t_b_9;
            }
        }
        for (int32_t i = 0; i <= 2; ++i) {
            const double b_1 = inverse_b[n];
            const double b_2 = t_b[i];
            const double b_3 = b_1 * b_2;
            b[5 * n + i + 10] = b_3;
            const double db_1 = db[i];
            const double db_2 = b[5 * n + i + 10];
            const double db_3 = db_1 + db_2;
            db[i] = db_3;
        }
        const double b_4 = b[5 * n + 10];
        b[5 * n + 13] = b_4;
        const double b_5 = b[5 * n + 11];
        b[5 * n + 14] = b_5;
    }

    /* db = sum b_n   [xu2019 (12)] */
    const double db1 = db[0];
    const double db2 = db[1];
    const double db3 = db[2];

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
    const double da_e_x = da1 + da_e_x_1;
    const double da_e_y = da2 + da_e_y_1;
    const double da_e_z = da3 + da_e_z_1;

    /* db_e = db + e_b b - e_ab a */
    const double db_e_x_1 = e_b * c_21;
    const double db_e_y_1 = e_b * c_22;
    const double db_e_z_1 = e_b * c_23;
    const double db_e_x_2 = db1 + db_e_x_1;
    const double db_e_y_2 = db2 + db_e_y_1;
    const double db_e_z_2 = db3 + db_e_z_1;
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

void dcm_taylor_3_10_rolled_float64_quaternion(
    const dcm_taylor_3_10_rolled_float64_state *state, double q_nb[4])
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

void dcm_taylor_3_10_rolled_float64_dcm(const dcm_taylor_3_10_rolled_float64_state *state, double c_nb[9])
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
