/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_dcm_float32
 *
 * qcone 0.1.0, design runge_kutta_4_dcm_float32, SHA-256 of the design
 * ebac0c7e3ecb77101bc79f90f6c23498b7c8788d1bf4852bd7b29fd60e75fdb0
 *
 * algorithm:   runge-kutta-4-dcm, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = C [omega x]; C + h (k1 + 2 k2 + 2 k3 + k4)/6, row by row
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written      107       0   54        32       0       0     0     0     0       0
 * update shared           93      14   54        32       0       0     0     0     0       0
 * update emitted          93      14   54        32       0       0     0     0     0       0
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
#include "runge_kutta_4_dcm_float32.h"

#if RUNGE_KUTTA_4_DCM_FLOAT32_VERSION != 1
#error "runge_kutta_4_dcm_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void runge_kutta_4_dcm_float32_init(runge_kutta_4_dcm_float32_state *state)
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
    state->omega_last[0] = 0.0F;
    state->omega_last[1] = 0.0F;
    state->omega_last[2] = 0.0F;
}

void runge_kutta_4_dcm_float32_set_dcm(runge_kutta_4_dcm_float32_state *state, const float c_nb[9])
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

void runge_kutta_4_dcm_float32_start(runge_kutta_4_dcm_float32_state *state, const float omega[3])
{
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void runge_kutta_4_dcm_float32_update(runge_kutta_4_dcm_float32_state *state, const float omega[6])
{
    /* attitude and input */
    const float c_11 = state->c[0];
    const float c_12 = state->c[1];
    const float c_13 = state->c[2];
    const float c_21 = state->c[3];
    const float c_22 = state->c[4];
    const float c_23 = state->c[5];
    const float omega1_x = omega[0];
    const float omega1_y = omega[1];
    const float omega1_z = omega[2];
    const float omega2_x = omega[3];
    const float omega2_y = omega[4];
    const float omega2_z = omega[5];

    /* the sample at the start of the interval */
    const float omega_last_x = state->omega_last[0];
    const float omega_last_y = state->omega_last[1];
    const float omega_last_z = state->omega_last[2];

    /* g0 = h omega_0 */
    const float g0_x = 0.01F /* 1/100 */ * omega_last_x;
    const float g0_y = 0.01F /* 1/100 */ * omega_last_y;
    const float g0_z = 0.01F /* 1/100 */ * omega_last_z;

    /* g1 = h omega_1 */
    const float g1_x = 0.01F /* 1/100 */ * omega1_x;
    const float g1_y = 0.01F /* 1/100 */ * omega1_y;
    const float g1_z = 0.01F /* 1/100 */ * omega1_z;

    /* g2 = h omega_2 */
    const float g2_x = 0.01F /* 1/100 */ * omega2_x;
    const float g2_y = 0.01F /* 1/100 */ * omega2_y;
    const float g2_z = 0.01F /* 1/100 */ * omega2_z;

    /* a1 = a x g0 */
    const float a1_x_1 = c_12 * g0_z;
    const float a1_x_2 = c_13 * g0_y;
    const float a1_x = a1_x_1 - a1_x_2;
    const float a1_y_1 = c_13 * g0_x;
    const float a1_y_2 = c_11 * g0_z;
    const float a1_y = a1_y_1 - a1_y_2;
    const float a1_z_1 = c_11 * g0_y;
    const float a1_z_2 = c_12 * g0_x;
    const float a1_z = a1_z_1 - a1_z_2;

    /* a2 = (a + a1/2) x g1 */
    const float a2_y_1 = 0.5F * a1_x;
    const float a2_x_1 = 0.5F * a1_y;
    const float a2_x_2 = 0.5F * a1_z;
    const float a2_y_2 = c_11 + a2_y_1;
    const float a2_x_3 = c_12 + a2_x_1;
    const float a2_x_4 = c_13 + a2_x_2;
    const float a2_x_5 = a2_x_3 * g1_z;
    const float a2_x_6 = a2_x_4 * g1_y;
    const float a2_x = a2_x_5 - a2_x_6;
    const float a2_y_3 = a2_x_4 * g1_x;
    const float a2_y_4 = a2_y_2 * g1_z;
    const float a2_y = a2_y_3 - a2_y_4;
    const float a2_z_1 = a2_y_2 * g1_y;
    const float a2_z_2 = a2_x_3 * g1_x;
    const float a2_z = a2_z_1 - a2_z_2;

    /* a3 = (a + a2/2) x g1 */
    const float a3_y_1 = 0.5F * a2_x;
    const float a3_x_1 = 0.5F * a2_y;
    const float a3_x_2 = 0.5F * a2_z;
    const float a3_y_2 = c_11 + a3_y_1;
    const float a3_x_3 = c_12 + a3_x_1;
    const float a3_x_4 = c_13 + a3_x_2;
    const float a3_x_5 = a3_x_3 * g1_z;
    const float a3_x_6 = a3_x_4 * g1_y;
    const float a3_x = a3_x_5 - a3_x_6;
    const float a3_y_3 = a3_x_4 * g1_x;
    const float a3_y_4 = a3_y_2 * g1_z;
    const float a3_y = a3_y_3 - a3_y_4;
    const float a3_z_1 = a3_y_2 * g1_y;
    const float a3_z_2 = a3_x_3 * g1_x;
    const float a3_z = a3_z_1 - a3_z_2;

    /* a4 = (a + a3) x g2 */
    const float a4_y_1 = c_11 + a3_x;
    const float a4_x_1 = c_12 + a3_y;
    const float a4_x_2 = c_13 + a3_z;
    const float a4_x_3 = a4_x_1 * g2_z;
    const float a4_x_4 = a4_x_2 * g2_y;
    const float a4_x = a4_x_3 - a4_x_4;
    const float a4_y_2 = a4_x_2 * g2_x;
    const float a4_y_3 = a4_y_1 * g2_z;
    const float a4_y = a4_y_2 - a4_y_3;
    const float a4_z_1 = a4_y_1 * g2_y;
    const float a4_z_2 = a4_x_1 * g2_x;
    const float a4_z = a4_z_1 - a4_z_2;

    /* da = (a1 + a4)/6 + (a2 + a3)/3 */
    const float da_x_1 = a1_x + a4_x;
    const float da_y_1 = a1_y + a4_y;
    const float da_z_1 = a1_z + a4_z;
    const float da_x_2 = 0.16666667F /* 1/6 */ * da_x_1;
    const float da_y_2 = 0.16666667F /* 1/6 */ * da_y_1;
    const float da_z_2 = 0.16666667F /* 1/6 */ * da_z_1;
    const float da_x_3 = a2_x + a3_x;
    const float da_y_3 = a2_y + a3_y;
    const float da_z_3 = a2_z + a3_z;
    const float da_x_4 = 0.33333334F /* 1/3 */ * da_x_3;
    const float da_y_4 = 0.33333334F /* 1/3 */ * da_y_3;
    const float da_z_4 = 0.33333334F /* 1/3 */ * da_z_3;
    const float da_x = da_x_2 + da_x_4;
    const float da_y = da_y_2 + da_y_4;
    const float da_z = da_z_2 + da_z_4;

    /* b1 = b x g0 */
    const float b1_x_1 = c_22 * g0_z;
    const float b1_x_2 = c_23 * g0_y;
    const float b1_x = b1_x_1 - b1_x_2;
    const float b1_y_1 = c_23 * g0_x;
    const float b1_y_2 = c_21 * g0_z;
    const float b1_y = b1_y_1 - b1_y_2;
    const float b1_z_1 = c_21 * g0_y;
    const float b1_z_2 = c_22 * g0_x;
    const float b1_z = b1_z_1 - b1_z_2;

    /* b2 = (b + b1/2) x g1 */
    const float b2_y_1 = 0.5F * b1_x;
    const float b2_x_1 = 0.5F * b1_y;
    const float b2_x_2 = 0.5F * b1_z;
    const float b2_y_2 = c_21 + b2_y_1;
    const float b2_x_3 = c_22 + b2_x_1;
    const float b2_x_4 = c_23 + b2_x_2;
    const float b2_x_5 = b2_x_3 * g1_z;
    const float b2_x_6 = b2_x_4 * g1_y;
    const float b2_x = b2_x_5 - b2_x_6;
    const float b2_y_3 = b2_x_4 * g1_x;
    const float b2_y_4 = b2_y_2 * g1_z;
    const float b2_y = b2_y_3 - b2_y_4;
    const float b2_z_1 = b2_y_2 * g1_y;
    const float b2_z_2 = b2_x_3 * g1_x;
    const float b2_z = b2_z_1 - b2_z_2;

    /* b3 = (b + b2/2) x g1 */
    const float b3_y_1 = 0.5F * b2_x;
    const float b3_x_1 = 0.5F * b2_y;
    const float b3_x_2 = 0.5F * b2_z;
    const float b3_y_2 = c_21 + b3_y_1;
    const float b3_x_3 = c_22 + b3_x_1;
    const float b3_x_4 = c_23 + b3_x_2;
    const float b3_x_5 = b3_x_3 * g1_z;
    const float b3_x_6 = b3_x_4 * g1_y;
    const float b3_x = b3_x_5 - b3_x_6;
    const float b3_y_3 = b3_x_4 * g1_x;
    const float b3_y_4 = b3_y_2 * g1_z;
    const float b3_y = b3_y_3 - b3_y_4;
    const float b3_z_1 = b3_y_2 * g1_y;
    const float b3_z_2 = b3_x_3 * g1_x;
    const float b3_z = b3_z_1 - b3_z_2;

    /* b4 = (b + b3) x g2 */
    const float b4_y_1 = c_21 + b3_x;
    const float b4_x_1 = c_22 + b3_y;
    const float b4_x_2 = c_23 + b3_z;
    const float b4_x_3 = b4_x_1 * g2_z;
    const float b4_x_4 = b4_x_2 * g2_y;
    const float b4_x = b4_x_3 - b4_x_4;
    const float b4_y_2 = b4_x_2 * g2_x;
    const float b4_y_3 = b4_y_1 * g2_z;
    const float b4_y = b4_y_2 - b4_y_3;
    const float b4_z_1 = b4_y_1 * g2_y;
    const float b4_z_2 = b4_x_1 * g2_x;
    const float b4_z = b4_z_1 - b4_z_2;

    /* db = (b1 + b4)/6 + (b2 + b3)/3 */
    const float db_x_1 = b1_x + b4_x;
    const float db_y_1 = b1_y + b4_y;
    const float db_z_1 = b1_z + b4_z;
    const float db_x_2 = 0.16666667F /* 1/6 */ * db_x_1;
    const float db_y_2 = 0.16666667F /* 1/6 */ * db_y_1;
    const float db_z_2 = 0.16666667F /* 1/6 */ * db_z_1;
    const float db_x_3 = b2_x + b3_x;
    const float db_y_3 = b2_y + b3_y;
    const float db_z_3 = b2_z + b3_z;
    const float db_x_4 = 0.33333334F /* 1/3 */ * db_x_3;
    const float db_y_4 = 0.33333334F /* 1/3 */ * db_y_3;
    const float db_z_4 = 0.33333334F /* 1/3 */ * db_z_3;
    const float db_x = db_x_2 + db_x_4;
    const float db_y = db_y_2 + db_y_4;
    const float db_z = db_z_2 + db_z_4;

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
    const float da_e_x = da_x + da_e_x_1;
    const float da_e_y = da_y + da_e_y_1;
    const float da_e_z = da_z + da_e_z_1;

    /* db_e = db + e_b b - e_ab a */
    const float db_e_x_1 = e_b * c_21;
    const float db_e_y_1 = e_b * c_22;
    const float db_e_z_1 = e_b * c_23;
    const float db_e_x_2 = db_x + db_e_x_1;
    const float db_e_y_2 = db_y + db_e_y_1;
    const float db_e_z_2 = db_z + db_e_z_1;
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
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void runge_kutta_4_dcm_float32_quaternion(const runge_kutta_4_dcm_float32_state *state, float q_nb[4])
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

void runge_kutta_4_dcm_float32_dcm(const runge_kutta_4_dcm_float32_state *state, float c_nb[9])
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
