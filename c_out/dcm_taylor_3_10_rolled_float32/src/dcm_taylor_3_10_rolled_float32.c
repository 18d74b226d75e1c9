/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_rolled_float32
 *
 * qcone 0.1.0, design dcm_taylor_3_10_rolled_float32, SHA-256 of the design
 * edbeb37fcf9bdb4711107cda0e6d6a68b56569e6bde08c9591fd9a4b5ed3f80d
 *
 * algorithm:   dcm-taylor-3-10, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
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
#include "dcm_taylor_3_10_rolled_float32.h"

#if DCM_TAYLOR_3_10_ROLLED_FLOAT32_VERSION != 1
#error "dcm_taylor_3_10_rolled_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void dcm_taylor_3_10_rolled_float32_init(dcm_taylor_3_10_rolled_float32_state *state)
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
}

void dcm_taylor_3_10_rolled_float32_set_dcm(
    dcm_taylor_3_10_rolled_float32_state *state, const float c_nb[9])
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
}

void dcm_taylor_3_10_rolled_float32_update(
    dcm_taylor_3_10_rolled_float32_state *state, const float dtheta[9])
{
    static const float fit[9] = {
        3.0F, -1.5F, 1.0F, 0.0F, 9.0F, -9.0F, 0.0F, 0.0F, 13.5F
    };
    static const float inverse_a[11] = {
        0.0F, 1.0F, 0.5F, 0.33333334F /* 1/3 */, 0.25F, 0.2F /* 1/5 */, 0.16666667F /* 1/6 */,
        0.14285715F /* 1/7 */, 0.125F, 0.11111111F /* 1/9 */, 0.1F /* 1/10 */
    };
    static const float inverse_b[11] = {
        0.0F, 1.0F, 0.5F, 0.33333334F /* 1/3 */, 0.25F, 0.2F /* 1/5 */, 0.16666667F /* 1/6 */,
        0.14285715F /* 1/7 */, 0.125F, 0.11111111F /* 1/9 */, 0.1F /* 1/10 */
    };
    float f[9];
    float W[15];
    float sum[1];
    float a[65];
    float t_a[3];
    float da[3];
    float b[65];
    float t_b[3];
    float db[3];
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

    /* W_j = sum_k fit_jk f_k, coefficients of the rate   [xu2019 (9)] */
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
            W[5 * j + i] = sum_3;
        }
        const float W_1 = W[5 * j];
        W[5 * j + 3] = W_1;
        const float W_2 = W[5 * j + 1];
        W[5 * j + 4] = W_2;
    }

    /* a_0 = a row of C   [xu2019 (12)] */
    for (int32_t i = 0; i <= 14; ++i) {
        a[i] = 0.0F;
    }
    a[10] = c_11;
    a[11] = c_12;
    a[12] = c_13;
    a[13] = c_11;
    a[14] = c_12;
    for (int32_t i = 0; i <= 2; ++i) {
        da[i] = 0.0F;
    }

    /* da = sum a_n   [xu2019 (12)] */
    for (int32_t n = 1; n <= 10; ++n) {
        /* a_n = 1/n sum_j a_(n-1-j) x W_j   [xu2019 (13)] */
        for (int32_t i = 0; i <= 2; ++i) {
            t_a[i] = 0.0F;
            for (int32_t j = 0; j <= 2; ++j) {
                const float t_a_1 = t_a[i];
                const float t_a_2 = a[5 * n - 5 * j + i + 6];
                const float t_a_3 = W[5 * j + i + 2];
                const float t_a_4 = t_a_2 * t_a_3;
                const float t_a_5 = t_a_1 + t_a_4;
                const float t_a_6 = a[5 * n - 5 * j + i + 7];
                const float t_a_7 = W[5 * j + i + 1];
                const float t_a_8 = t_a_6 * t_a_7;
                const float t_a_9 = t_a_5 - t_a_8;
                t_a[i] = t_a_9;
            }
        }
        for (int32_t i = 0; i <= 2; ++i) {
            const float a_1 = inverse_a[n];
            const float a_2 = t_a[i];
            const float a_3 = a_1 * a_2;
            a[5 * n + i + 10] = a_3;
            const float da_1 = da[i];
            const float da_2 = a[5 * n + i + 10];
            const float da_3 = da_1 + da_2;
            da[i] = da_3;
        }
        const float a_4 = a[5 * n + 10];
        a[5 * n + 13] = a_4;
        const float a_5 = a[5 * n + 11];
        a[5 * n + 14] = a_5;
    }

    /* da = sum a_n   [xu2019 (12)] */
    const float da1 = da[0];
    const float da2 = da[1];
    const float da3 = da[2];

    /* b_0 = a row of C   [xu2019 (12)] */
    for (int32_t i = 0; i <= 14; ++i) {
        b[i] = 0.0F;
    }
    b[10] = c_21;
    b[11] = c_22;
    b[12] = c_23;
    b[13] = c_21;
    b[14] = c_22;
    for (int32_t i = 0; i <= 2; ++i) {
        db[i] = 0.0F;
    }

    /* db = sum b_n   [xu2019 (12)] */
    for (int32_t n = 1; n <= 10; ++n) {
        /* b_n = 1/n sum_j b_(n-1-j) x W_j   [xu2019 (13)] */
        for (int32_t i = 0; i <= 2; ++i) {
            t_b[i] = 0.0F;
            for (int32_t j = 0; j <= 2; ++j) {
                const float t_b_1 = t_b[i];
                const float t_b_2 = b[5 * n - 5 * j + i + 6];
                const float t_b_3 = W[5 * j + i + 2];
                const float t_b_4 = t_b_2 * t_b_3;
                const float t_b_5 = t_b_1 + t_b_4;
                const float t_b_6 = b[5 * n - 5 * j + i + 7];
                const float t_b_7 = W[5 * j + i + 1];
                const float t_b_8 = t_b_6 * t_b_7;
                const float t_b_9 = t_b_5 - t_b_8;
                t_b[i] = t_b_9;
            }
        }
        for (int32_t i = 0; i <= 2; ++i) {
            const float b_1 = inverse_b[n];
            const float b_2 = t_b[i];
            const float b_3 = b_1 * b_2;
            b[5 * n + i + 10] = b_3;
            const float db_1 = db[i];
            const float db_2 = b[5 * n + i + 10];
            const float db_3 = db_1 + db_2;
            db[i] = db_3;
        }
        const float b_4 = b[5 * n + 10];
        b[5 * n + 13] = b_4;
        const float b_5 = b[5 * n + 11];
        b[5 * n + 14] = b_5;
    }

    /* db = sum b_n   [xu2019 (12)] */
    const float db1 = db[0];
    const float db2 = db[1];
    const float db3 = db[2];

    /* e_a = (1 - |a|^2)/2   [re-orthogonalisation of the rows a, b] */
    const float e_a_1 = c_11 * c_11;
    const float e_a_2 = c_12 * c_12;
    const float e_a_3 = c_13 * c_13;
    const float e_a_4 = e_a_1 + e_a_2;
    const float e_a_5 = e_a_4 + e_a_3;
    const float e_a_6 = 1.0F - e_a_5;
    const float e_a = 0.5F * e_a_6;

    /* e_b = (1 - |b|^2)/2   [re-orthogonalisation of the rows a, b] */
    const float e_b_1 = c_21 * c_21;
    const float e_b_2 = c_22 * c_22;
    const float e_b_3 = c_23 * c_23;
    const float e_b_4 = e_b_1 + e_b_2;
    const float e_b_5 = e_b_4 + e_b_3;
    const float e_b_6 = 1.0F - e_b_5;
    const float e_b = 0.5F * e_b_6;

    /* e_ab = a . b   [re-orthogonalisation of the rows a, b] */
    const float e_ab_1 = c_11 * c_21;
    const float e_ab_2 = c_12 * c_22;
    const float e_ab_3 = c_13 * c_23;
    const float e_ab_4 = e_ab_1 + e_ab_2;
    const float e_ab = e_ab_4 + e_ab_3;

    /* da_e = da + e_a a */
    const float da_e_x_1 = e_a * c_11;
    const float da_e_y_1 = e_a * c_12;
    const float da_e_z_1 = e_a * c_13;
    const float da_e_x = da1 + da_e_x_1;
    const float da_e_y = da2 + da_e_y_1;
    const float da_e_z = da3 + da_e_z_1;

    /* db_e = db + e_b b - e_ab a */
    const float db_e_x_1 = e_b * c_21;
    const float db_e_y_1 = e_b * c_22;
    const float db_e_z_1 = e_b * c_23;
    const float db_e_x_2 = db1 + db_e_x_1;
    const float db_e_y_2 = db2 + db_e_y_1;
    const float db_e_z_2 = db3 + db_e_z_1;
    const float db_e_x_3 = e_ab * c_11;
    const float db_e_y_3 = e_ab * c_12;
    const float db_e_z_3 = e_ab * c_13;
    const float db_e_x = db_e_x_2 - db_e_x_3;
    const float db_e_y = db_e_y_2 - db_e_y_3;
    const float db_e_z = db_e_z_2 - db_e_z_3;

    /* a_next = a + da */
    const float a_next_x = c_11 + da_e_x;
    const float a_next_y = c_12 + da_e_y;
    const float a_next_z = c_13 + da_e_z;

    /* b_next = b + db */
    const float b_next_x = c_21 + db_e_x;
    const float b_next_y = c_22 + db_e_y;
    const float b_next_z = c_23 + db_e_z;

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
}

void dcm_taylor_3_10_rolled_float32_quaternion(
    const dcm_taylor_3_10_rolled_float32_state *state, float q_nb[4])
{
    /* c, read once */
    const float c_11 = state->c[0];
    const float c_12 = state->c[1];
    const float c_13 = state->c[2];
    const float c_21 = state->c[3];
    const float c_22 = state->c[4];
    const float c_23 = state->c[5];
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

void dcm_taylor_3_10_rolled_float32_dcm(const dcm_taylor_3_10_rolled_float32_state *state, float c_nb[9])
{
    /* c, read once */
    const float c_11 = state->c[0];
    const float c_12 = state->c[1];
    const float c_13 = state->c[2];
    const float c_21 = state->c[3];
    const float c_22 = state->c[4];
    const float c_23 = state->c[5];
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
