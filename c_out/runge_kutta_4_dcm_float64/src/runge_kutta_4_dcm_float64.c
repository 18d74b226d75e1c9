/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_dcm_float64
 *
 * qcone 0.1.0, design runge_kutta_4_dcm_float64, SHA-256 of the design
 * e1c9e94232a3c6f98abebed75132d256d129092c3d004c2e3060ab0e92a41c55
 *
 * algorithm:   runge-kutta-4-dcm, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = C [omega x]; C + h (k1 + 2 k2 + 2 k3 + k4)/6, row by row
 * number:      float64, every operation rounded once
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
#include "runge_kutta_4_dcm_float64.h"

#if RUNGE_KUTTA_4_DCM_FLOAT64_VERSION != 1
#error "runge_kutta_4_dcm_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void runge_kutta_4_dcm_float64_init(runge_kutta_4_dcm_float64_state *state)
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
    state->omega_last[0] = 0.0;
    state->omega_last[1] = 0.0;
    state->omega_last[2] = 0.0;
}

void runge_kutta_4_dcm_float64_set_dcm(runge_kutta_4_dcm_float64_state *state, const double c_nb[9])
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

void runge_kutta_4_dcm_float64_start(runge_kutta_4_dcm_float64_state *state, const double omega[3])
{
    const double omega_x = omega[0];
    const double omega_y = omega[1];
    const double omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void runge_kutta_4_dcm_float64_update(runge_kutta_4_dcm_float64_state *state, const double omega[6])
{
    /* attitude and input */
    const double c_11 = state->c[0];
    const double c_12 = state->c[1];
    const double c_13 = state->c[2];
    const double c_21 = state->c[3];
    const double c_22 = state->c[4];
    const double c_23 = state->c[5];
    const double omega1_x = omega[0];
    const double omega1_y = omega[1];
    const double omega1_z = omega[2];
    const double omega2_x = omega[3];
    const double omega2_y = omega[4];
    const double omega2_z = omega[5];

    /* the sample at the start of the interval */
    const double omega_last_x = state->omega_last[0];
    const double omega_last_y = state->omega_last[1];
    const double omega_last_z = state->omega_last[2];

    /* g0 = h omega_0 */
    const double g0_x = 0.01 /* 1/100 */ * omega_last_x;
    const double g0_y = 0.01 /* 1/100 */ * omega_last_y;
    const double g0_z = 0.01 /* 1/100 */ * omega_last_z;

    /* g1 = h omega_1 */
    const double g1_x = 0.01 /* 1/100 */ * omega1_x;
    const double g1_y = 0.01 /* 1/100 */ * omega1_y;
    const double g1_z = 0.01 /* 1/100 */ * omega1_z;

    /* g2 = h omega_2 */
    const double g2_x = 0.01 /* 1/100 */ * omega2_x;
    const double g2_y = 0.01 /* 1/100 */ * omega2_y;
    const double g2_z = 0.01 /* 1/100 */ * omega2_z;

    /* a1 = a x g0 */
    const double a1_x_1 = c_12 * g0_z;
    const double a1_x_2 = c_13 * g0_y;
    const double a1_x = a1_x_1 - a1_x_2;
    const double a1_y_1 = c_13 * g0_x;
    const double a1_y_2 = c_11 * g0_z;
    const double a1_y = a1_y_1 - a1_y_2;
    const double a1_z_1 = c_11 * g0_y;
    const double a1_z_2 = c_12 * g0_x;
    const double a1_z = a1_z_1 - a1_z_2;

    /* a2 = (a + a1/2) x g1 */
    const double a2_y_1 = 0.5 * a1_x;
    const double a2_x_1 = 0.5 * a1_y;
    const double a2_x_2 = 0.5 * a1_z;
    const double a2_y_2 = c_11 + a2_y_1;
    const double a2_x_3 = c_12 + a2_x_1;
    const double a2_x_4 = c_13 + a2_x_2;
    const double a2_x_5 = a2_x_3 * g1_z;
    const double a2_x_6 = a2_x_4 * g1_y;
    const double a2_x = a2_x_5 - a2_x_6;
    const double a2_y_3 = a2_x_4 * g1_x;
    const double a2_y_4 = a2_y_2 * g1_z;
    const double a2_y = a2_y_3 - a2_y_4;
    const double a2_z_1 = a2_y_2 * g1_y;
    const double a2_z_2 = a2_x_3 * g1_x;
    const double a2_z = a2_z_1 - a2_z_2;

    /* a3 = (a + a2/2) x g1 */
    const double a3_y_1 = 0.5 * a2_x;
    const double a3_x_1 = 0.5 * a2_y;
    const double a3_x_2 = 0.5 * a2_z;
    const double a3_y_2 = c_11 + a3_y_1;
    const double a3_x_3 = c_12 + a3_x_1;
    const double a3_x_4 = c_13 + a3_x_2;
    const double a3_x_5 = a3_x_3 * g1_z;
    const double a3_x_6 = a3_x_4 * g1_y;
    const double a3_x = a3_x_5 - a3_x_6;
    const double a3_y_3 = a3_x_4 * g1_x;
    const double a3_y_4 = a3_y_2 * g1_z;
    const double a3_y = a3_y_3 - a3_y_4;
    const double a3_z_1 = a3_y_2 * g1_y;
    const double a3_z_2 = a3_x_3 * g1_x;
    const double a3_z = a3_z_1 - a3_z_2;

    /* a4 = (a + a3) x g2 */
    const double a4_y_1 = c_11 + a3_x;
    const double a4_x_1 = c_12 + a3_y;
    const double a4_x_2 = c_13 + a3_z;
    const double a4_x_3 = a4_x_1 * g2_z;
    const double a4_x_4 = a4_x_2 * g2_y;
    const double a4_x = a4_x_3 - a4_x_4;
    const double a4_y_2 = a4_x_2 * g2_x;
    const double a4_y_3 = a4_y_1 * g2_z;
    const double a4_y = a4_y_2 - a4_y_3;
    const double a4_z_1 = a4_y_1 * g2_y;
    const double a4_z_2 = a4_x_1 * g2_x;
    const double a4_z = a4_z_1 - a4_z_2;

    /* da = (a1 + a4)/6 + (a2 + a3)/3 */
    const double da_x_1 = a1_x + a4_x;
    const double da_y_1 = a1_y + a4_y;
    const double da_z_1 = a1_z + a4_z;
    const double da_x_2 = 0.16666666666666666 /* 1/6 */ * da_x_1;
    const double da_y_2 = 0.16666666666666666 /* 1/6 */ * da_y_1;
    const double da_z_2 = 0.16666666666666666 /* 1/6 */ * da_z_1;
    const double da_x_3 = a2_x + a3_x;
    const double da_y_3 = a2_y + a3_y;
    const double da_z_3 = a2_z + a3_z;
    const double da_x_4 = 0.3333333333333333 /* 1/3 */ * da_x_3;
    const double da_y_4 = 0.3333333333333333 /* 1/3 */ * da_y_3;
    const double da_z_4 = 0.3333333333333333 /* 1/3 */ * da_z_3;
    const double da_x = da_x_2 + da_x_4;
    const double da_y = da_y_2 + da_y_4;
    const double da_z = da_z_2 + da_z_4;

    /* b1 = b x g0 */
    const double b1_x_1 = c_22 * g0_z;
    const double b1_x_2 = c_23 * g0_y;
    const double b1_x = b1_x_1 - b1_x_2;
    const double b1_y_1 = c_23 * g0_x;
    const double b1_y_2 = c_21 * g0_z;
    const double b1_y = b1_y_1 - b1_y_2;
    const double b1_z_1 = c_21 * g0_y;
    const double b1_z_2 = c_22 * g0_x;
    const double b1_z = b1_z_1 - b1_z_2;

    /* b2 = (b + b1/2) x g1 */
    const double b2_y_1 = 0.5 * b1_x;
    const double b2_x_1 = 0.5 * b1_y;
    const double b2_x_2 = 0.5 * b1_z;
    const double b2_y_2 = c_21 + b2_y_1;
    const double b2_x_3 = c_22 + b2_x_1;
    const double b2_x_4 = c_23 + b2_x_2;
    const double b2_x_5 = b2_x_3 * g1_z;
    const double b2_x_6 = b2_x_4 * g1_y;
    const double b2_x = b2_x_5 - b2_x_6;
    const double b2_y_3 = b2_x_4 * g1_x;
    const double b2_y_4 = b2_y_2 * g1_z;
    const double b2_y = b2_y_3 - b2_y_4;
    const double b2_z_1 = b2_y_2 * g1_y;
    const double b2_z_2 = b2_x_3 * g1_x;
    const double b2_z = b2_z_1 - b2_z_2;

    /* b3 = (b + b2/2) x g1 */
    const double b3_y_1 = 0.5 * b2_x;
    const double b3_x_1 = 0.5 * b2_y;
    const double b3_x_2 = 0.5 * b2_z;
    const double b3_y_2 = c_21 + b3_y_1;
    const double b3_x_3 = c_22 + b3_x_1;
    const double b3_x_4 = c_23 + b3_x_2;
    const double b3_x_5 = b3_x_3 * g1_z;
    const double b3_x_6 = b3_x_4 * g1_y;
    const double b3_x = b3_x_5 - b3_x_6;
    const double b3_y_3 = b3_x_4 * g1_x;
    const double b3_y_4 = b3_y_2 * g1_z;
    const double b3_y = b3_y_3 - b3_y_4;
    const double b3_z_1 = b3_y_2 * g1_y;
    const double b3_z_2 = b3_x_3 * g1_x;
    const double b3_z = b3_z_1 - b3_z_2;

    /* b4 = (b + b3) x g2 */
    const double b4_y_1 = c_21 + b3_x;
    const double b4_x_1 = c_22 + b3_y;
    const double b4_x_2 = c_23 + b3_z;
    const double b4_x_3 = b4_x_1 * g2_z;
    const double b4_x_4 = b4_x_2 * g2_y;
    const double b4_x = b4_x_3 - b4_x_4;
    const double b4_y_2 = b4_x_2 * g2_x;
    const double b4_y_3 = b4_y_1 * g2_z;
    const double b4_y = b4_y_2 - b4_y_3;
    const double b4_z_1 = b4_y_1 * g2_y;
    const double b4_z_2 = b4_x_1 * g2_x;
    const double b4_z = b4_z_1 - b4_z_2;

    /* db = (b1 + b4)/6 + (b2 + b3)/3 */
    const double db_x_1 = b1_x + b4_x;
    const double db_y_1 = b1_y + b4_y;
    const double db_z_1 = b1_z + b4_z;
    const double db_x_2 = 0.16666666666666666 /* 1/6 */ * db_x_1;
    const double db_y_2 = 0.16666666666666666 /* 1/6 */ * db_y_1;
    const double db_z_2 = 0.16666666666666666 /* 1/6 */ * db_z_1;
    const double db_x_3 = b2_x + b3_x;
    const double db_y_3 = b2_y + b3_y;
    const double db_z_3 = b2_z + b3_z;
    const double db_x_4 = 0.3333333333333333 /* 1/3 */ * db_x_3;
    const double db_y_4 = 0.3333333333333333 /* 1/3 */ * db_y_3;
    const double db_z_4 = 0.3333333333333333 /* 1/3 */ * db_z_3;
    const double db_x = db_x_2 + db_x_4;
    const double db_y = db_y_2 + db_y_4;
    const double db_z = db_z_2 + db_z_4;

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
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void runge_kutta_4_dcm_float64_quaternion(const runge_kutta_4_dcm_float64_state *state, double q_nb[4])
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

void runge_kutta_4_dcm_float64_dcm(const runge_kutta_4_dcm_float64_state *state, double c_nb[9])
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
