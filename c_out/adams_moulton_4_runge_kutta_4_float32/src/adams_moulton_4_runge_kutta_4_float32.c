/* Generated, do not edit. Made by: qcone generate adams_moulton_4.toml --design adams_moulton_4_runge_kutta_4_float32
 *
 * qcone 0.1.0, design adams_moulton_4_runge_kutta_4_float32, SHA-256 of the design
 * 5f3628e60581488f853fffcbd9237f8a96c48036e5241e980a9948702e6878f8
 *
 * algorithm:   adams-moulton-4-runge-kutta-4, form factored, q' = q + dq, renormalised on every
 *              update
 * source:      thesis2008 Adams-Moulton, Milne
 * equation:    p = q + h (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24; q + h (9 f_p + 19 f_0 - 5 f_1 +
 *              f_2)/24
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 200 updates/s; |dtheta| <= 0.050004 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * hold as-written            0       0    0         0       0       0     0     0     0       0
 * hold shared                0       0    0         0       0       0     0     0     0       0
 * hold emitted               0       0    0         0       0       0     0     0     0       0
 * start_up as-written      264       0  181        46      12       0     0     0     0       0
 * start_up shared          221      34  165        58       3       0     0     0     0       0
 * start_up emitted         221      34  165        58       3       0     0     0     0       0
 * steady as-written         75       0   37        23       2       0     0     0     0       0
 * steady shared             74       1   37        23       1       0     0     0     0       0
 * steady emitted            74       1   37        23       1       0     0     0     0       0
 * dcm as-written             9       0    9         6       0       0     0     0     0       0
 * dcm shared                 9       0    9         6       0       0     0     0     0       0
 * dcm emitted                9       0    9         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "adams_moulton_4_runge_kutta_4_float32.h"

#if ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT32_VERSION != 1
#error "adams_moulton_4_runge_kutta_4_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void adams_moulton_4_runge_kutta_4_float32_init(adams_moulton_4_runge_kutta_4_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
    state->omega_last[0] = 0.0F;
    state->omega_last[1] = 0.0F;
    state->omega_last[2] = 0.0F;
    state->f[0] = 0.0F;
    state->f[1] = 0.0F;
    state->f[2] = 0.0F;
    state->f[3] = 0.0F;
    state->f[4] = 0.0F;
    state->f[5] = 0.0F;
    state->f[6] = 0.0F;
    state->f[7] = 0.0F;
    state->f[8] = 0.0F;
    state->f[9] = 0.0F;
    state->f[10] = 0.0F;
    state->f[11] = 0.0F;
    state->error[0] = 0.0F;
    state->error[1] = 0.0F;
    state->error[2] = 0.0F;
    state->error[3] = 0.0F;
    state->rates[0] = 0.0F;
    state->rates[1] = 0.0F;
    state->rates[2] = 0.0F;
    state->rates[3] = 0.0F;
    state->rates[4] = 0.0F;
    state->rates[5] = 0.0F;
    state->count = 0;
}

void adams_moulton_4_runge_kutta_4_float32_set_quaternion(
    adams_moulton_4_runge_kutta_4_float32_state *state, const float q_nb[4])
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
    state->f[0] = 0.0F;
    state->f[1] = 0.0F;
    state->f[2] = 0.0F;
    state->f[3] = 0.0F;
    state->f[4] = 0.0F;
    state->f[5] = 0.0F;
    state->f[6] = 0.0F;
    state->f[7] = 0.0F;
    state->f[8] = 0.0F;
    state->f[9] = 0.0F;
    state->f[10] = 0.0F;
    state->f[11] = 0.0F;
    state->error[0] = 0.0F;
    state->error[1] = 0.0F;
    state->error[2] = 0.0F;
    state->error[3] = 0.0F;
    state->rates[0] = 0.0F;
    state->rates[1] = 0.0F;
    state->rates[2] = 0.0F;
    state->rates[3] = 0.0F;
    state->rates[4] = 0.0F;
    state->rates[5] = 0.0F;
    state->count = 0;
}

void adams_moulton_4_runge_kutta_4_float32_start(
    adams_moulton_4_runge_kutta_4_float32_state *state, const float omega[3])
{
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

static void adams_moulton_4_runge_kutta_4_float32_hold(
    adams_moulton_4_runge_kutta_4_float32_state *state, const float omega[3])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];

    /* the sample at the start of the interval */
    const float omega_last_x = state->omega_last[0];
    const float omega_last_y = state->omega_last[1];
    const float omega_last_z = state->omega_last[2];

    /* rates taken while the starter waits, oldest first, rad/s */
    const float rates2_x = state->rates[3];
    const float rates2_y = state->rates[4];
    const float rates2_z = state->rates[5];

    /* store */
    state->q[0] = q_w;
    state->q[1] = q_x;
    state->q[2] = q_y;
    state->q[3] = q_z;
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
    state->rates[0] = rates2_x;
    state->rates[1] = rates2_y;
    state->rates[2] = rates2_z;
    state->rates[3] = omega_last_x;
    state->rates[4] = omega_last_y;
    state->rates[5] = omega_last_z;
    state->count = state->count + 1;
}

static void adams_moulton_4_runge_kutta_4_float32_start_up(
    adams_moulton_4_runge_kutta_4_float32_state *state, const float omega[3])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];

    /* the sample at the start of the interval */
    const float omega_last_x = state->omega_last[0];
    const float omega_last_y = state->omega_last[1];
    const float omega_last_z = state->omega_last[2];

    /* rates taken while the starter waits, oldest first, rad/s */
    const float rates1_x = state->rates[0];
    const float rates1_y = state->rates[1];
    const float rates1_z = state->rates[2];
    const float rates2_x = state->rates[3];
    const float rates2_y = state->rates[4];
    const float rates2_z = state->rates[5];

    /* rates in the middle of each interval, from the cubic through four samples */
    const float dq0_w_negated_1 = 0.3125F /* 5/16 */ * rates1_x;
    const float dq0_w_negated_2 = 0.3125F /* 5/16 */ * rates1_y;
    const float dq0_w_negated_3 = 0.3125F /* 5/16 */ * rates1_z;
    const float dq0_w_negated_4 = 0.9375F /* 15/16 */ * rates2_x;
    const float dq0_w_negated_5 = 0.9375F /* 15/16 */ * rates2_y;
    const float dq0_w_negated_6 = 0.9375F /* 15/16 */ * rates2_z;
    const float dq0_w_negated_7 = dq0_w_negated_1 + dq0_w_negated_4;
    const float dq0_w_negated_8 = dq0_w_negated_2 + dq0_w_negated_5;
    const float dq0_w_negated_9 = dq0_w_negated_3 + dq0_w_negated_6;
    const float dq0_w_negated_10 = 0.3125F /* 5/16 */ * omega_last_x;
    const float dq0_w_negated_11 = 0.3125F /* 5/16 */ * omega_last_y;
    const float dq0_w_negated_12 = 0.3125F /* 5/16 */ * omega_last_z;
    const float dq0_w_negated_13 = dq0_w_negated_7 - dq0_w_negated_10;
    const float dq0_w_negated_14 = dq0_w_negated_8 - dq0_w_negated_11;
    const float dq0_w_negated_15 = dq0_w_negated_9 - dq0_w_negated_12;
    const float dq0_w_negated_16 = 0.0625F /* 1/16 */ * omega_x;
    const float dq0_w_negated_17 = 0.0625F /* 1/16 */ * omega_y;
    const float dq0_w_negated_18 = 0.0625F /* 1/16 */ * omega_z;
    const float dq0_w_negated_19 = dq0_w_negated_13 + dq0_w_negated_16;
    const float dq0_w_negated_20 = dq0_w_negated_14 + dq0_w_negated_17;
    const float dq0_w_negated_21 = dq0_w_negated_15 + dq0_w_negated_18;
    const float dq1_w_negated_1 = -0.0625F /* -1/16 */ * rates1_x;
    const float dq1_w_negated_2 = -0.0625F /* -1/16 */ * rates1_y;
    const float dq1_w_negated_3 = -0.0625F /* -1/16 */ * rates1_z;
    const float dq1_w_negated_4 = 0.5625F /* 9/16 */ * rates2_x;
    const float dq1_w_negated_5 = 0.5625F /* 9/16 */ * rates2_y;
    const float dq1_w_negated_6 = 0.5625F /* 9/16 */ * rates2_z;
    const float dq1_w_negated_7 = dq1_w_negated_1 + dq1_w_negated_4;
    const float dq1_w_negated_8 = dq1_w_negated_2 + dq1_w_negated_5;
    const float dq1_w_negated_9 = dq1_w_negated_3 + dq1_w_negated_6;
    const float dq1_w_negated_10 = 0.5625F /* 9/16 */ * omega_last_x;
    const float dq1_w_negated_11 = 0.5625F /* 9/16 */ * omega_last_y;
    const float dq1_w_negated_12 = 0.5625F /* 9/16 */ * omega_last_z;
    const float dq1_w_negated_13 = dq1_w_negated_7 + dq1_w_negated_10;
    const float dq1_w_negated_14 = dq1_w_negated_8 + dq1_w_negated_11;
    const float dq1_w_negated_15 = dq1_w_negated_9 + dq1_w_negated_12;
    const float dq1_w_negated_16 = dq1_w_negated_13 - dq0_w_negated_16;
    const float dq1_w_negated_17 = dq1_w_negated_14 - dq0_w_negated_17;
    const float dq1_w_negated_18 = dq1_w_negated_15 - dq0_w_negated_18;
    const float middle_x_1 = 0.0625F /* 1/16 */ * rates1_x;
    const float middle_y_1 = 0.0625F /* 1/16 */ * rates1_y;
    const float middle_z_1 = 0.0625F /* 1/16 */ * rates1_z;
    const float middle_x_2 = 0.3125F /* 5/16 */ * rates2_x;
    const float middle_y_2 = 0.3125F /* 5/16 */ * rates2_y;
    const float middle_z_2 = 0.3125F /* 5/16 */ * rates2_z;
    const float middle_x_3 = middle_x_1 - middle_x_2;
    const float middle_y_3 = middle_y_1 - middle_y_2;
    const float middle_z_3 = middle_z_1 - middle_z_2;
    const float middle_x_4 = 0.9375F /* 15/16 */ * omega_last_x;
    const float middle_y_4 = 0.9375F /* 15/16 */ * omega_last_y;
    const float middle_z_4 = 0.9375F /* 15/16 */ * omega_last_z;
    const float middle_x_5 = middle_x_3 + middle_x_4;
    const float middle_y_5 = middle_y_3 + middle_y_4;
    const float middle_z_5 = middle_z_3 + middle_z_4;
    const float middle_x_6 = 0.3125F /* 5/16 */ * omega_x;
    const float middle_y_6 = 0.3125F /* 5/16 */ * omega_y;
    const float middle_z_6 = 0.3125F /* 5/16 */ * omega_z;
    const float middle_x = middle_x_5 + middle_x_6;
    const float middle_y = middle_y_5 + middle_y_6;
    const float middle_z = middle_z_5 + middle_z_6;

    /* dq0 = (k1 + k4)/6 + (k2 + k3)/3 of step 1   [Runge-Kutta] */
    const float dq0_x_1 = 0.0025F /* 1/400 */ * rates1_x;
    const float dq0_x_2 = 0.0025F /* 1/400 */ * rates1_y;
    const float dq0_x_3 = 0.0025F /* 1/400 */ * rates1_z;
    const float dq0_w_negated_22 = 0.0025F /* 1/400 */ * dq0_w_negated_19;
    const float dq0_w_negated_23 = 0.0025F /* 1/400 */ * dq0_w_negated_20;
    const float dq0_w_negated_24 = 0.0025F /* 1/400 */ * dq0_w_negated_21;
    const float dq0_w_negated_25 = 0.0025F /* 1/400 */ * rates2_x;
    const float dq0_w_negated_26 = 0.0025F /* 1/400 */ * rates2_y;
    const float dq0_w_negated_27 = 0.0025F /* 1/400 */ * rates2_z;
    const float dq0_x_4 = q_x * dq0_x_1;
    const float dq0_x_5 = q_y * dq0_x_2;
    const float dq0_x_6 = q_z * dq0_x_3;
    const float dq0_x_7 = dq0_x_4 + dq0_x_5;
    const float dq0_x_8 = dq0_x_7 + dq0_x_6;
    const float dq0_w_negated_28 = q_w * dq0_x_1;
    const float dq0_w_negated_29 = q_y * dq0_x_3;
    const float dq0_w_negated_30 = q_z * dq0_x_2;
    const float dq0_w_negated_31 = dq0_w_negated_28 + dq0_w_negated_29;
    const float dq0_w_negated_32 = dq0_w_negated_31 - dq0_w_negated_30;
    const float dq0_w_negated_33 = q_w * dq0_x_2;
    const float dq0_w_negated_34 = q_z * dq0_x_1;
    const float dq0_w_negated_35 = q_x * dq0_x_3;
    const float dq0_w_negated_36 = dq0_w_negated_33 + dq0_w_negated_34;
    const float dq0_w_negated_37 = dq0_w_negated_36 - dq0_w_negated_35;
    const float dq0_w_negated_38 = q_w * dq0_x_3;
    const float dq0_w_negated_39 = q_x * dq0_x_2;
    const float dq0_w_negated_40 = q_y * dq0_x_1;
    const float dq0_w_negated_41 = dq0_w_negated_38 + dq0_w_negated_39;
    const float dq0_w_negated_42 = dq0_w_negated_41 - dq0_w_negated_40;
    const float dq0_x_9 = 0.5F * dq0_x_8;
    const float dq0_w_negated_43 = 0.5F * dq0_w_negated_32;
    const float dq0_w_negated_44 = 0.5F * dq0_w_negated_37;
    const float dq0_w_negated_45 = 0.5F * dq0_w_negated_42;
    const float dq0_x_10 = q_w - dq0_x_9;
    const float dq0_w_negated_46 = q_x + dq0_w_negated_43;
    const float dq0_w_negated_47 = q_y + dq0_w_negated_44;
    const float dq0_w_negated_48 = q_z + dq0_w_negated_45;
    const float dq0_w_negated_49 = dq0_w_negated_46 * dq0_w_negated_22;
    const float dq0_w_negated_50 = dq0_w_negated_47 * dq0_w_negated_23;
    const float dq0_w_negated_51 = dq0_w_negated_48 * dq0_w_negated_24;
    const float dq0_w_negated_52 = dq0_w_negated_49 + dq0_w_negated_50;
    const float dq0_w_negated_53 = dq0_w_negated_52 + dq0_w_negated_51;
    const float dq0_x_11 = dq0_x_10 * dq0_w_negated_22;
    const float dq0_x_12 = dq0_w_negated_47 * dq0_w_negated_24;
    const float dq0_x_13 = dq0_w_negated_48 * dq0_w_negated_23;
    const float dq0_x_14 = dq0_x_11 + dq0_x_12;
    const float dq0_x_15 = dq0_x_14 - dq0_x_13;
    const float dq0_x_16 = dq0_x_10 * dq0_w_negated_23;
    const float dq0_x_17 = dq0_w_negated_48 * dq0_w_negated_22;
    const float dq0_x_18 = dq0_w_negated_46 * dq0_w_negated_24;
    const float dq0_x_19 = dq0_x_16 + dq0_x_17;
    const float dq0_x_20 = dq0_x_19 - dq0_x_18;
    const float dq0_x_21 = dq0_x_10 * dq0_w_negated_24;
    const float dq0_x_22 = dq0_w_negated_46 * dq0_w_negated_23;
    const float dq0_x_23 = dq0_w_negated_47 * dq0_w_negated_22;
    const float dq0_x_24 = dq0_x_21 + dq0_x_22;
    const float dq0_x_25 = dq0_x_24 - dq0_x_23;
    const float dq0_w_negated_54 = 0.5F * dq0_w_negated_53;
    const float dq0_x_26 = 0.5F * dq0_x_15;
    const float dq0_x_27 = 0.5F * dq0_x_20;
    const float dq0_x_28 = 0.5F * dq0_x_25;
    const float dq0_w_negated_55 = q_w - dq0_w_negated_54;
    const float dq0_x_29 = q_x + dq0_x_26;
    const float dq0_x_30 = q_y + dq0_x_27;
    const float dq0_x_31 = q_z + dq0_x_28;
    const float dq0_x_32 = dq0_x_29 * dq0_w_negated_22;
    const float dq0_x_33 = dq0_x_30 * dq0_w_negated_23;
    const float dq0_x_34 = dq0_x_31 * dq0_w_negated_24;
    const float dq0_x_35 = dq0_x_32 + dq0_x_33;
    const float dq0_x_36 = dq0_x_35 + dq0_x_34;
    const float dq0_w_negated_56 = dq0_w_negated_55 * dq0_w_negated_22;
    const float dq0_w_negated_57 = dq0_x_30 * dq0_w_negated_24;
    const float dq0_w_negated_58 = dq0_x_31 * dq0_w_negated_23;
    const float dq0_w_negated_59 = dq0_w_negated_56 + dq0_w_negated_57;
    const float dq0_w_negated_60 = dq0_w_negated_59 - dq0_w_negated_58;
    const float dq0_w_negated_61 = dq0_w_negated_55 * dq0_w_negated_23;
    const float dq0_w_negated_62 = dq0_x_31 * dq0_w_negated_22;
    const float dq0_w_negated_63 = dq0_x_29 * dq0_w_negated_24;
    const float dq0_w_negated_64 = dq0_w_negated_61 + dq0_w_negated_62;
    const float dq0_w_negated_65 = dq0_w_negated_64 - dq0_w_negated_63;
    const float dq0_w_negated_66 = dq0_w_negated_55 * dq0_w_negated_24;
    const float dq0_w_negated_67 = dq0_x_29 * dq0_w_negated_23;
    const float dq0_w_negated_68 = dq0_x_30 * dq0_w_negated_22;
    const float dq0_w_negated_69 = dq0_w_negated_66 + dq0_w_negated_67;
    const float dq0_w_negated_70 = dq0_w_negated_69 - dq0_w_negated_68;
    const float dq0_x_37 = q_w - dq0_x_36;
    const float dq0_w_negated_71 = q_x + dq0_w_negated_60;
    const float dq0_w_negated_72 = q_y + dq0_w_negated_65;
    const float dq0_w_negated_73 = q_z + dq0_w_negated_70;
    const float dq0_w_negated_74 = dq0_w_negated_71 * dq0_w_negated_25;
    const float dq0_w_negated_75 = dq0_w_negated_72 * dq0_w_negated_26;
    const float dq0_w_negated_76 = dq0_w_negated_73 * dq0_w_negated_27;
    const float dq0_w_negated_77 = dq0_w_negated_74 + dq0_w_negated_75;
    const float dq0_w_negated_78 = dq0_w_negated_77 + dq0_w_negated_76;
    const float dq0_x_38 = dq0_x_37 * dq0_w_negated_25;
    const float dq0_x_39 = dq0_w_negated_72 * dq0_w_negated_27;
    const float dq0_x_40 = dq0_w_negated_73 * dq0_w_negated_26;
    const float dq0_x_41 = dq0_x_38 + dq0_x_39;
    const float dq0_x_42 = dq0_x_41 - dq0_x_40;
    const float dq0_y_1 = dq0_x_37 * dq0_w_negated_26;
    const float dq0_y_2 = dq0_w_negated_73 * dq0_w_negated_25;
    const float dq0_y_3 = dq0_w_negated_71 * dq0_w_negated_27;
    const float dq0_y_4 = dq0_y_1 + dq0_y_2;
    const float dq0_y_5 = dq0_y_4 - dq0_y_3;
    const float dq0_z_1 = dq0_x_37 * dq0_w_negated_27;
    const float dq0_z_2 = dq0_w_negated_71 * dq0_w_negated_26;
    const float dq0_z_3 = dq0_w_negated_72 * dq0_w_negated_25;
    const float dq0_z_4 = dq0_z_1 + dq0_z_2;
    const float dq0_z_5 = dq0_z_4 - dq0_z_3;
    const float dq0_w_negated_79 = dq0_x_8 + dq0_w_negated_78;
    const float dq0_x_43 = dq0_w_negated_32 + dq0_x_42;
    const float dq0_y_6 = dq0_w_negated_37 + dq0_y_5;
    const float dq0_z_6 = dq0_w_negated_42 + dq0_z_5;
    const float dq0_w_negated_80 = 0.16666667F /* 1/6 */ * dq0_w_negated_79;
    const float dq0_x_44 = 0.16666667F /* 1/6 */ * dq0_x_43;
    const float dq0_y_7 = 0.16666667F /* 1/6 */ * dq0_y_6;
    const float dq0_z_7 = 0.16666667F /* 1/6 */ * dq0_z_6;
    const float dq0_w_negated_81 = dq0_w_negated_53 + dq0_x_36;
    const float dq0_x_45 = dq0_x_15 + dq0_w_negated_60;
    const float dq0_y_8 = dq0_x_20 + dq0_w_negated_65;
    const float dq0_z_8 = dq0_x_25 + dq0_w_negated_70;
    const float dq0_w_negated_82 = 0.33333334F /* 1/3 */ * dq0_w_negated_81;
    const float dq0_x_46 = 0.33333334F /* 1/3 */ * dq0_x_45;
    const float dq0_y_9 = 0.33333334F /* 1/3 */ * dq0_y_8;
    const float dq0_z_9 = 0.33333334F /* 1/3 */ * dq0_z_8;
    const float dq0_w_negated = dq0_w_negated_80 + dq0_w_negated_82;
    const float dq0_x = dq0_x_44 + dq0_x_46;
    const float dq0_y = dq0_y_7 + dq0_y_9;
    const float dq0_z = dq0_z_7 + dq0_z_9;

    /* dq1 = (k1 + k4)/6 + (k2 + k3)/3 of step 2   [Runge-Kutta] */
    const float dq1_w_negated_19 = q_w - dq0_w_negated;
    const float dq1_x_1 = q_x + dq0_x;
    const float dq1_x_2 = q_y + dq0_y;
    const float dq1_x_3 = q_z + dq0_z;
    const float dq1_w_negated_20 = 0.0025F /* 1/400 */ * dq1_w_negated_16;
    const float dq1_w_negated_21 = 0.0025F /* 1/400 */ * dq1_w_negated_17;
    const float dq1_w_negated_22 = 0.0025F /* 1/400 */ * dq1_w_negated_18;
    const float dq1_w_negated_23 = 0.0025F /* 1/400 */ * omega_last_x;
    const float dq1_w_negated_24 = 0.0025F /* 1/400 */ * omega_last_y;
    const float dq1_w_negated_25 = 0.0025F /* 1/400 */ * omega_last_z;
    const float dq1_x_4 = dq1_x_1 * dq0_w_negated_25;
    const float dq1_x_5 = dq1_x_2 * dq0_w_negated_26;
    const float dq1_x_6 = dq1_x_3 * dq0_w_negated_27;
    const float dq1_x_7 = dq1_x_4 + dq1_x_5;
    const float dq1_x_8 = dq1_x_7 + dq1_x_6;
    const float dq1_w_negated_26 = dq1_w_negated_19 * dq0_w_negated_25;
    const float dq1_w_negated_27 = dq1_x_2 * dq0_w_negated_27;
    const float dq1_w_negated_28 = dq1_x_3 * dq0_w_negated_26;
    const float dq1_w_negated_29 = dq1_w_negated_26 + dq1_w_negated_27;
    const float dq1_w_negated_30 = dq1_w_negated_29 - dq1_w_negated_28;
    const float dq1_w_negated_31 = dq1_w_negated_19 * dq0_w_negated_26;
    const float dq1_w_negated_32 = dq1_x_3 * dq0_w_negated_25;
    const float dq1_w_negated_33 = dq1_x_1 * dq0_w_negated_27;
    const float dq1_w_negated_34 = dq1_w_negated_31 + dq1_w_negated_32;
    const float dq1_w_negated_35 = dq1_w_negated_34 - dq1_w_negated_33;
    const float dq1_w_negated_36 = dq1_w_negated_19 * dq0_w_negated_27;
    const float dq1_w_negated_37 = dq1_x_1 * dq0_w_negated_26;
    const float dq1_w_negated_38 = dq1_x_2 * dq0_w_negated_25;
    const float dq1_w_negated_39 = dq1_w_negated_36 + dq1_w_negated_37;
    const float dq1_w_negated_40 = dq1_w_negated_39 - dq1_w_negated_38;
    const float dq1_x_9 = 0.5F * dq1_x_8;
    const float dq1_w_negated_41 = 0.5F * dq1_w_negated_30;
    const float dq1_w_negated_42 = 0.5F * dq1_w_negated_35;
    const float dq1_w_negated_43 = 0.5F * dq1_w_negated_40;
    const float dq1_x_10 = dq1_w_negated_19 - dq1_x_9;
    const float dq1_w_negated_44 = dq1_x_1 + dq1_w_negated_41;
    const float dq1_w_negated_45 = dq1_x_2 + dq1_w_negated_42;
    const float dq1_w_negated_46 = dq1_x_3 + dq1_w_negated_43;
    const float dq1_w_negated_47 = dq1_w_negated_44 * dq1_w_negated_20;
    const float dq1_w_negated_48 = dq1_w_negated_45 * dq1_w_negated_21;
    const float dq1_w_negated_49 = dq1_w_negated_46 * dq1_w_negated_22;
    const float dq1_w_negated_50 = dq1_w_negated_47 + dq1_w_negated_48;
    const float dq1_w_negated_51 = dq1_w_negated_50 + dq1_w_negated_49;
    const float dq1_x_11 = dq1_x_10 * dq1_w_negated_20;
    const float dq1_x_12 = dq1_w_negated_45 * dq1_w_negated_22;
    const float dq1_x_13 = dq1_w_negated_46 * dq1_w_negated_21;
    const float dq1_x_14 = dq1_x_11 + dq1_x_12;
    const float dq1_x_15 = dq1_x_14 - dq1_x_13;
    const float dq1_x_16 = dq1_x_10 * dq1_w_negated_21;
    const float dq1_x_17 = dq1_w_negated_46 * dq1_w_negated_20;
    const float dq1_x_18 = dq1_w_negated_44 * dq1_w_negated_22;
    const float dq1_x_19 = dq1_x_16 + dq1_x_17;
    const float dq1_x_20 = dq1_x_19 - dq1_x_18;
    const float dq1_x_21 = dq1_x_10 * dq1_w_negated_22;
    const float dq1_x_22 = dq1_w_negated_44 * dq1_w_negated_21;
    const float dq1_x_23 = dq1_w_negated_45 * dq1_w_negated_20;
    const float dq1_x_24 = dq1_x_21 + dq1_x_22;
    const float dq1_x_25 = dq1_x_24 - dq1_x_23;
    const float dq1_w_negated_52 = 0.5F * dq1_w_negated_51;
    const float dq1_x_26 = 0.5F * dq1_x_15;
    const float dq1_x_27 = 0.5F * dq1_x_20;
    const float dq1_x_28 = 0.5F * dq1_x_25;
    const float dq1_w_negated_53 = dq1_w_negated_19 - dq1_w_negated_52;
    const float dq1_x_29 = dq1_x_1 + dq1_x_26;
    const float dq1_x_30 = dq1_x_2 + dq1_x_27;
    const float dq1_x_31 = dq1_x_3 + dq1_x_28;
    const float dq1_x_32 = dq1_x_29 * dq1_w_negated_20;
    const float dq1_x_33 = dq1_x_30 * dq1_w_negated_21;
    const float dq1_x_34 = dq1_x_31 * dq1_w_negated_22;
    const float dq1_x_35 = dq1_x_32 + dq1_x_33;
    const float dq1_x_36 = dq1_x_35 + dq1_x_34;
    const float dq1_w_negated_54 = dq1_w_negated_53 * dq1_w_negated_20;
    const float dq1_w_negated_55 = dq1_x_30 * dq1_w_negated_22;
    const float dq1_w_negated_56 = dq1_x_31 * dq1_w_negated_21;
    const float dq1_w_negated_57 = dq1_w_negated_54 + dq1_w_negated_55;
    const float dq1_w_negated_58 = dq1_w_negated_57 - dq1_w_negated_56;
    const float dq1_w_negated_59 = dq1_w_negated_53 * dq1_w_negated_21;
    const float dq1_w_negated_60 = dq1_x_31 * dq1_w_negated_20;
    const float dq1_w_negated_61 = dq1_x_29 * dq1_w_negated_22;
    const float dq1_w_negated_62 = dq1_w_negated_59 + dq1_w_negated_60;
    const float dq1_w_negated_63 = dq1_w_negated_62 - dq1_w_negated_61;
    const float dq1_w_negated_64 = dq1_w_negated_53 * dq1_w_negated_22;
    const float dq1_w_negated_65 = dq1_x_29 * dq1_w_negated_21;
    const float dq1_w_negated_66 = dq1_x_30 * dq1_w_negated_20;
    const float dq1_w_negated_67 = dq1_w_negated_64 + dq1_w_negated_65;
    const float dq1_w_negated_68 = dq1_w_negated_67 - dq1_w_negated_66;
    const float dq1_x_37 = dq1_w_negated_19 - dq1_x_36;
    const float dq1_w_negated_69 = dq1_x_1 + dq1_w_negated_58;
    const float dq1_w_negated_70 = dq1_x_2 + dq1_w_negated_63;
    const float dq1_w_negated_71 = dq1_x_3 + dq1_w_negated_68;
    const float dq1_w_negated_72 = dq1_w_negated_69 * dq1_w_negated_23;
    const float dq1_w_negated_73 = dq1_w_negated_70 * dq1_w_negated_24;
    const float dq1_w_negated_74 = dq1_w_negated_71 * dq1_w_negated_25;
    const float dq1_w_negated_75 = dq1_w_negated_72 + dq1_w_negated_73;
    const float dq1_w_negated_76 = dq1_w_negated_75 + dq1_w_negated_74;
    const float dq1_x_38 = dq1_x_37 * dq1_w_negated_23;
    const float dq1_x_39 = dq1_w_negated_70 * dq1_w_negated_25;
    const float dq1_x_40 = dq1_w_negated_71 * dq1_w_negated_24;
    const float dq1_x_41 = dq1_x_38 + dq1_x_39;
    const float dq1_x_42 = dq1_x_41 - dq1_x_40;
    const float dq1_y_1 = dq1_x_37 * dq1_w_negated_24;
    const float dq1_y_2 = dq1_w_negated_71 * dq1_w_negated_23;
    const float dq1_y_3 = dq1_w_negated_69 * dq1_w_negated_25;
    const float dq1_y_4 = dq1_y_1 + dq1_y_2;
    const float dq1_y_5 = dq1_y_4 - dq1_y_3;
    const float dq1_z_1 = dq1_x_37 * dq1_w_negated_25;
    const float dq1_z_2 = dq1_w_negated_69 * dq1_w_negated_24;
    const float dq1_z_3 = dq1_w_negated_70 * dq1_w_negated_23;
    const float dq1_z_4 = dq1_z_1 + dq1_z_2;
    const float dq1_z_5 = dq1_z_4 - dq1_z_3;
    const float dq1_w_negated_77 = dq1_x_8 + dq1_w_negated_76;
    const float dq1_x_43 = dq1_w_negated_30 + dq1_x_42;
    const float dq1_y_6 = dq1_w_negated_35 + dq1_y_5;
    const float dq1_z_6 = dq1_w_negated_40 + dq1_z_5;
    const float dq1_w_negated_78 = 0.16666667F /* 1/6 */ * dq1_w_negated_77;
    const float dq1_x_44 = 0.16666667F /* 1/6 */ * dq1_x_43;
    const float dq1_y_7 = 0.16666667F /* 1/6 */ * dq1_y_6;
    const float dq1_z_7 = 0.16666667F /* 1/6 */ * dq1_z_6;
    const float dq1_w_negated_79 = dq1_w_negated_51 + dq1_x_36;
    const float dq1_x_45 = dq1_x_15 + dq1_w_negated_58;
    const float dq1_y_8 = dq1_x_20 + dq1_w_negated_63;
    const float dq1_z_8 = dq1_x_25 + dq1_w_negated_68;
    const float dq1_w_negated_80 = 0.33333334F /* 1/3 */ * dq1_w_negated_79;
    const float dq1_x_46 = 0.33333334F /* 1/3 */ * dq1_x_45;
    const float dq1_y_9 = 0.33333334F /* 1/3 */ * dq1_y_8;
    const float dq1_z_9 = 0.33333334F /* 1/3 */ * dq1_z_8;
    const float dq1_w_negated = dq1_w_negated_78 + dq1_w_negated_80;
    const float dq1_x = dq1_x_44 + dq1_x_46;
    const float dq1_y = dq1_y_7 + dq1_y_9;
    const float dq1_z = dq1_z_7 + dq1_z_9;

    /* dq2 = (k1 + k4)/6 + (k2 + k3)/3 of step 3   [Runge-Kutta] */
    const float first_x_1 = dq0_w_negated + dq1_w_negated;
    const float first_w_negated_1 = dq0_x + dq1_x;
    const float first_w_negated_2 = dq0_y + dq1_y;
    const float first_w_negated_3 = dq0_z + dq1_z;
    const float first_x_2 = q_w - first_x_1;
    const float first_w_negated_4 = q_x + first_w_negated_1;
    const float first_w_negated_5 = q_y + first_w_negated_2;
    const float first_w_negated_6 = q_z + first_w_negated_3;
    const float dq2_w_negated_1 = 0.0025F /* 1/400 */ * middle_x;
    const float dq2_w_negated_2 = 0.0025F /* 1/400 */ * middle_y;
    const float dq2_w_negated_3 = 0.0025F /* 1/400 */ * middle_z;
    const float dq2_w_negated_4 = 0.0025F /* 1/400 */ * omega_x;
    const float dq2_w_negated_5 = 0.0025F /* 1/400 */ * omega_y;
    const float dq2_w_negated_6 = 0.0025F /* 1/400 */ * omega_z;
    const float first_w_negated_7 = first_w_negated_4 * dq1_w_negated_23;
    const float first_w_negated_8 = first_w_negated_5 * dq1_w_negated_24;
    const float first_w_negated_9 = first_w_negated_6 * dq1_w_negated_25;
    const float first_w_negated_10 = first_w_negated_7 + first_w_negated_8;
    const float first_w_negated = first_w_negated_10 + first_w_negated_9;
    const float first_x_3 = first_x_2 * dq1_w_negated_23;
    const float first_x_4 = first_w_negated_5 * dq1_w_negated_25;
    const float first_x_5 = first_w_negated_6 * dq1_w_negated_24;
    const float first_x_6 = first_x_3 + first_x_4;
    const float first_x = first_x_6 - first_x_5;
    const float first_y_1 = first_x_2 * dq1_w_negated_24;
    const float first_y_2 = first_w_negated_6 * dq1_w_negated_23;
    const float first_y_3 = first_w_negated_4 * dq1_w_negated_25;
    const float first_y_4 = first_y_1 + first_y_2;
    const float first_y = first_y_4 - first_y_3;
    const float first_z_1 = first_x_2 * dq1_w_negated_25;
    const float first_z_2 = first_w_negated_4 * dq1_w_negated_24;
    const float first_z_3 = first_w_negated_5 * dq1_w_negated_23;
    const float first_z_4 = first_z_1 + first_z_2;
    const float first_z = first_z_4 - first_z_3;
    const float dq2_x_1 = 0.5F * first_w_negated;
    const float dq2_w_negated_7 = 0.5F * first_x;
    const float dq2_w_negated_8 = 0.5F * first_y;
    const float dq2_w_negated_9 = 0.5F * first_z;
    const float dq2_x_2 = first_x_2 - dq2_x_1;
    const float dq2_w_negated_10 = first_w_negated_4 + dq2_w_negated_7;
    const float dq2_w_negated_11 = first_w_negated_5 + dq2_w_negated_8;
    const float dq2_w_negated_12 = first_w_negated_6 + dq2_w_negated_9;
    const float dq2_w_negated_13 = dq2_w_negated_10 * dq2_w_negated_1;
    const float dq2_w_negated_14 = dq2_w_negated_11 * dq2_w_negated_2;
    const float dq2_w_negated_15 = dq2_w_negated_12 * dq2_w_negated_3;
    const float dq2_w_negated_16 = dq2_w_negated_13 + dq2_w_negated_14;
    const float dq2_w_negated_17 = dq2_w_negated_16 + dq2_w_negated_15;
    const float dq2_x_3 = dq2_x_2 * dq2_w_negated_1;
    const float dq2_x_4 = dq2_w_negated_11 * dq2_w_negated_3;
    const float dq2_x_5 = dq2_w_negated_12 * dq2_w_negated_2;
    const float dq2_x_6 = dq2_x_3 + dq2_x_4;
    const float dq2_x_7 = dq2_x_6 - dq2_x_5;
    const float dq2_x_8 = dq2_x_2 * dq2_w_negated_2;
    const float dq2_x_9 = dq2_w_negated_12 * dq2_w_negated_1;
    const float dq2_x_10 = dq2_w_negated_10 * dq2_w_negated_3;
    const float dq2_x_11 = dq2_x_8 + dq2_x_9;
    const float dq2_x_12 = dq2_x_11 - dq2_x_10;
    const float dq2_x_13 = dq2_x_2 * dq2_w_negated_3;
    const float dq2_x_14 = dq2_w_negated_10 * dq2_w_negated_2;
    const float dq2_x_15 = dq2_w_negated_11 * dq2_w_negated_1;
    const float dq2_x_16 = dq2_x_13 + dq2_x_14;
    const float dq2_x_17 = dq2_x_16 - dq2_x_15;
    const float dq2_w_negated_18 = 0.5F * dq2_w_negated_17;
    const float dq2_x_18 = 0.5F * dq2_x_7;
    const float dq2_x_19 = 0.5F * dq2_x_12;
    const float dq2_x_20 = 0.5F * dq2_x_17;
    const float dq2_w_negated_19 = first_x_2 - dq2_w_negated_18;
    const float dq2_x_21 = first_w_negated_4 + dq2_x_18;
    const float dq2_x_22 = first_w_negated_5 + dq2_x_19;
    const float dq2_x_23 = first_w_negated_6 + dq2_x_20;
    const float dq2_x_24 = dq2_x_21 * dq2_w_negated_1;
    const float dq2_x_25 = dq2_x_22 * dq2_w_negated_2;
    const float dq2_x_26 = dq2_x_23 * dq2_w_negated_3;
    const float dq2_x_27 = dq2_x_24 + dq2_x_25;
    const float dq2_x_28 = dq2_x_27 + dq2_x_26;
    const float dq2_w_negated_20 = dq2_w_negated_19 * dq2_w_negated_1;
    const float dq2_w_negated_21 = dq2_x_22 * dq2_w_negated_3;
    const float dq2_w_negated_22 = dq2_x_23 * dq2_w_negated_2;
    const float dq2_w_negated_23 = dq2_w_negated_20 + dq2_w_negated_21;
    const float dq2_w_negated_24 = dq2_w_negated_23 - dq2_w_negated_22;
    const float dq2_w_negated_25 = dq2_w_negated_19 * dq2_w_negated_2;
    const float dq2_w_negated_26 = dq2_x_23 * dq2_w_negated_1;
    const float dq2_w_negated_27 = dq2_x_21 * dq2_w_negated_3;
    const float dq2_w_negated_28 = dq2_w_negated_25 + dq2_w_negated_26;
    const float dq2_w_negated_29 = dq2_w_negated_28 - dq2_w_negated_27;
    const float dq2_w_negated_30 = dq2_w_negated_19 * dq2_w_negated_3;
    const float dq2_w_negated_31 = dq2_x_21 * dq2_w_negated_2;
    const float dq2_w_negated_32 = dq2_x_22 * dq2_w_negated_1;
    const float dq2_w_negated_33 = dq2_w_negated_30 + dq2_w_negated_31;
    const float dq2_w_negated_34 = dq2_w_negated_33 - dq2_w_negated_32;
    const float dq2_x_29 = first_x_2 - dq2_x_28;
    const float dq2_w_negated_35 = first_w_negated_4 + dq2_w_negated_24;
    const float dq2_w_negated_36 = first_w_negated_5 + dq2_w_negated_29;
    const float dq2_w_negated_37 = first_w_negated_6 + dq2_w_negated_34;
    const float dq2_w_negated_38 = dq2_w_negated_35 * dq2_w_negated_4;
    const float dq2_w_negated_39 = dq2_w_negated_36 * dq2_w_negated_5;
    const float dq2_w_negated_40 = dq2_w_negated_37 * dq2_w_negated_6;
    const float dq2_w_negated_41 = dq2_w_negated_38 + dq2_w_negated_39;
    const float dq2_w_negated_42 = dq2_w_negated_41 + dq2_w_negated_40;
    const float dq2_x_30 = dq2_x_29 * dq2_w_negated_4;
    const float dq2_x_31 = dq2_w_negated_36 * dq2_w_negated_6;
    const float dq2_x_32 = dq2_w_negated_37 * dq2_w_negated_5;
    const float dq2_x_33 = dq2_x_30 + dq2_x_31;
    const float dq2_x_34 = dq2_x_33 - dq2_x_32;
    const float dq2_y_1 = dq2_x_29 * dq2_w_negated_5;
    const float dq2_y_2 = dq2_w_negated_37 * dq2_w_negated_4;
    const float dq2_y_3 = dq2_w_negated_35 * dq2_w_negated_6;
    const float dq2_y_4 = dq2_y_1 + dq2_y_2;
    const float dq2_y_5 = dq2_y_4 - dq2_y_3;
    const float dq2_z_1 = dq2_x_29 * dq2_w_negated_6;
    const float dq2_z_2 = dq2_w_negated_35 * dq2_w_negated_5;
    const float dq2_z_3 = dq2_w_negated_36 * dq2_w_negated_4;
    const float dq2_z_4 = dq2_z_1 + dq2_z_2;
    const float dq2_z_5 = dq2_z_4 - dq2_z_3;
    const float dq2_w_negated_43 = first_w_negated + dq2_w_negated_42;
    const float dq2_x_35 = first_x + dq2_x_34;
    const float dq2_y_6 = first_y + dq2_y_5;
    const float dq2_z_6 = first_z + dq2_z_5;
    const float dq2_w_negated_44 = 0.16666667F /* 1/6 */ * dq2_w_negated_43;
    const float dq2_x_36 = 0.16666667F /* 1/6 */ * dq2_x_35;
    const float dq2_y_7 = 0.16666667F /* 1/6 */ * dq2_y_6;
    const float dq2_z_7 = 0.16666667F /* 1/6 */ * dq2_z_6;
    const float dq2_w_negated_45 = dq2_w_negated_17 + dq2_x_28;
    const float dq2_x_37 = dq2_x_7 + dq2_w_negated_24;
    const float dq2_y_8 = dq2_x_12 + dq2_w_negated_29;
    const float dq2_z_8 = dq2_x_17 + dq2_w_negated_34;
    const float dq2_w_negated_46 = 0.33333334F /* 1/3 */ * dq2_w_negated_45;
    const float dq2_x_38 = 0.33333334F /* 1/3 */ * dq2_x_37;
    const float dq2_y_9 = 0.33333334F /* 1/3 */ * dq2_y_8;
    const float dq2_z_9 = 0.33333334F /* 1/3 */ * dq2_z_8;
    const float dq2_w_negated = dq2_w_negated_44 + dq2_w_negated_46;
    const float dq2_x = dq2_x_36 + dq2_x_38;
    const float dq2_y = dq2_y_7 + dq2_y_9;
    const float dq2_z = dq2_z_7 + dq2_z_9;

    /* dq = the three steps together   [Runge-Kutta] */
    const float dq_w_negated = first_x_1 + dq2_w_negated;
    const float dq_x = first_w_negated_1 + dq2_x;
    const float dq_y = first_w_negated_2 + dq2_y;
    const float dq_z = first_w_negated_3 + dq2_z;

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

    /* dq_e = dq + e q */
    const float dq_e_w_1 = e * q_w;
    const float dq_e_x_1 = e * q_x;
    const float dq_e_y_1 = e * q_y;
    const float dq_e_z_1 = e * q_z;
    const float dq_e_w = dq_e_w_1 - dq_w_negated;
    const float dq_e_x = dq_x + dq_e_x_1;
    const float dq_e_y = dq_y + dq_e_y_1;
    const float dq_e_z = dq_z + dq_e_z_1;

    /* q_next = q + dq */
    const float q_next_w = q_w + dq_e_w;
    const float q_next_x = q_x + dq_e_x;
    const float q_next_y = q_y + dq_e_y;
    const float q_next_z = q_z + dq_e_z;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
    const float f_1 = -first_w_negated;
    state->f[0] = f_1;
    state->f[1] = first_x;
    state->f[2] = first_y;
    state->f[3] = first_z;
    const float f_2 = -dq1_x_8;
    state->f[4] = f_2;
    state->f[5] = dq1_w_negated_30;
    state->f[6] = dq1_w_negated_35;
    state->f[7] = dq1_w_negated_40;
    const float f_3 = -dq0_x_8;
    state->f[8] = f_3;
    state->f[9] = dq0_w_negated_32;
    state->f[10] = dq0_w_negated_37;
    state->f[11] = dq0_w_negated_42;
    state->count = state->count + 1;
}

static void adams_moulton_4_runge_kutta_4_float32_steady(
    adams_moulton_4_runge_kutta_4_float32_state *state, const float omega[3])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];

    /* the sample at the start of the interval */
    const float omega_last_x = state->omega_last[0];
    const float omega_last_y = state->omega_last[1];
    const float omega_last_z = state->omega_last[2];

    /* slopes of the last steps, newest first: h q', as written q' */
    const float f1_w = state->f[0];
    const float f1_x = state->f[1];
    const float f1_y = state->f[2];
    const float f1_z = state->f[3];
    const float f2_w = state->f[4];
    const float f2_x = state->f[5];
    const float f2_y = state->f[6];
    const float f2_z = state->f[7];
    const float f3_w = state->f[8];
    const float f3_x = state->f[9];
    const float f3_y = state->f[10];
    const float f3_z = state->f[11];

    /* g0 = h/2 omega, last */
    const float g0_x = 0.0025F /* 1/400 */ * omega_last_x;
    const float g0_y = 0.0025F /* 1/400 */ * omega_last_y;
    const float g0_z = 0.0025F /* 1/400 */ * omega_last_z;

    /* g1 = h/2 omega, new */
    const float g1_x = 0.0025F /* 1/400 */ * omega_x;
    const float g1_y = 0.0025F /* 1/400 */ * omega_y;
    const float g1_z = 0.0025F /* 1/400 */ * omega_z;

    /* f0 = q (x) g0 */
    const float f0_w_negated_1 = q_x * g0_x;
    const float f0_w_negated_2 = q_y * g0_y;
    const float f0_w_negated_3 = q_z * g0_z;
    const float f0_w_negated_4 = f0_w_negated_1 + f0_w_negated_2;
    const float f0_w_negated = f0_w_negated_4 + f0_w_negated_3;
    const float f0_x_1 = q_w * g0_x;
    const float f0_x_2 = q_y * g0_z;
    const float f0_x_3 = q_z * g0_y;
    const float f0_x_4 = f0_x_1 + f0_x_2;
    const float f0_x = f0_x_4 - f0_x_3;
    const float f0_y_1 = q_w * g0_y;
    const float f0_y_2 = q_z * g0_x;
    const float f0_y_3 = q_x * g0_z;
    const float f0_y_4 = f0_y_1 + f0_y_2;
    const float f0_y = f0_y_4 - f0_y_3;
    const float f0_z_1 = q_w * g0_z;
    const float f0_z_2 = q_x * g0_y;
    const float f0_z_3 = q_y * g0_x;
    const float f0_z_4 = f0_z_1 + f0_z_2;
    const float f0_z = f0_z_4 - f0_z_3;

    /* dp = (55 f0 - 59 f1 + 37 f2 - 9 f3)/24   [Adams-Bashforth] */
    const float dp_w_1 = 2.2916667F /* 55/24 */ * f0_w_negated;
    const float dp_x_1 = 2.2916667F /* 55/24 */ * f0_x;
    const float dp_y_1 = 2.2916667F /* 55/24 */ * f0_y;
    const float dp_z_1 = 2.2916667F /* 55/24 */ * f0_z;
    const float dp_w_2 = 2.4583333F /* 59/24 */ * f1_w;
    const float dp_x_2 = 2.4583333F /* 59/24 */ * f1_x;
    const float dp_y_2 = 2.4583333F /* 59/24 */ * f1_y;
    const float dp_z_2 = 2.4583333F /* 59/24 */ * f1_z;
    const float dp_w_3 = dp_w_1 + dp_w_2;
    const float dp_x_3 = dp_x_1 - dp_x_2;
    const float dp_y_3 = dp_y_1 - dp_y_2;
    const float dp_z_3 = dp_z_1 - dp_z_2;
    const float dp_w_4 = 1.5416666F /* 37/24 */ * f2_w;
    const float dp_x_4 = 1.5416666F /* 37/24 */ * f2_x;
    const float dp_y_4 = 1.5416666F /* 37/24 */ * f2_y;
    const float dp_z_4 = 1.5416666F /* 37/24 */ * f2_z;
    const float dp_w_5 = dp_w_4 - dp_w_3;
    const float dp_x_5 = dp_x_3 + dp_x_4;
    const float dp_y_5 = dp_y_3 + dp_y_4;
    const float dp_z_5 = dp_z_3 + dp_z_4;
    const float dp_w_6 = 0.375F * f3_w;
    const float dp_x_6 = 0.375F * f3_x;
    const float dp_y_6 = 0.375F * f3_y;
    const float dp_z_6 = 0.375F * f3_z;
    const float dp_w = dp_w_5 - dp_w_6;
    const float dp_x = dp_x_5 - dp_x_6;
    const float dp_y = dp_y_5 - dp_y_6;
    const float dp_z = dp_z_5 - dp_z_6;

    /* p = q + dp   [Adams-Bashforth] */
    const float p_w = q_w + dp_w;
    const float p_x = q_x + dp_x;
    const float p_y = q_y + dp_y;
    const float p_z = q_z + dp_z;

    /* fp = p (x) g1 */
    const float fp_w_negated_1 = p_x * g1_x;
    const float fp_w_negated_2 = p_y * g1_y;
    const float fp_w_negated_3 = p_z * g1_z;
    const float fp_w_negated_4 = fp_w_negated_1 + fp_w_negated_2;
    const float fp_w_negated = fp_w_negated_4 + fp_w_negated_3;
    const float fp_x_1 = p_w * g1_x;
    const float fp_x_2 = p_y * g1_z;
    const float fp_x_3 = p_z * g1_y;
    const float fp_x_4 = fp_x_1 + fp_x_2;
    const float fp_x = fp_x_4 - fp_x_3;
    const float fp_y_1 = p_w * g1_y;
    const float fp_y_2 = p_z * g1_x;
    const float fp_y_3 = p_x * g1_z;
    const float fp_y_4 = fp_y_1 + fp_y_2;
    const float fp_y = fp_y_4 - fp_y_3;
    const float fp_z_1 = p_w * g1_z;
    const float fp_z_2 = p_x * g1_y;
    const float fp_z_3 = p_y * g1_x;
    const float fp_z_4 = fp_z_1 + fp_z_2;
    const float fp_z = fp_z_4 - fp_z_3;

    /* dq = (9 fp + 19 f0 - 5 f1 + f2)/24   [Adams-Moulton] */
    const float dq_w_1 = 0.375F * fp_w_negated;
    const float dq_x_1 = 0.375F * fp_x;
    const float dq_y_1 = 0.375F * fp_y;
    const float dq_z_1 = 0.375F * fp_z;
    const float dq_w_2 = 0.7916667F /* 19/24 */ * f0_w_negated;
    const float dq_x_2 = 0.7916667F /* 19/24 */ * f0_x;
    const float dq_y_2 = 0.7916667F /* 19/24 */ * f0_y;
    const float dq_z_2 = 0.7916667F /* 19/24 */ * f0_z;
    const float dq_w_3 = dq_w_1 + dq_w_2;
    const float dq_x_3 = dq_x_1 + dq_x_2;
    const float dq_y_3 = dq_y_1 + dq_y_2;
    const float dq_z_3 = dq_z_1 + dq_z_2;
    const float dq_w_4 = 0.20833333F /* 5/24 */ * f1_w;
    const float dq_x_4 = 0.20833333F /* 5/24 */ * f1_x;
    const float dq_y_4 = 0.20833333F /* 5/24 */ * f1_y;
    const float dq_z_4 = 0.20833333F /* 5/24 */ * f1_z;
    const float dq_w_5 = dq_w_3 + dq_w_4;
    const float dq_x_5 = dq_x_3 - dq_x_4;
    const float dq_y_5 = dq_y_3 - dq_y_4;
    const float dq_z_5 = dq_z_3 - dq_z_4;
    const float dq_w_6 = 0.041666668F /* 1/24 */ * f2_w;
    const float dq_x_6 = 0.041666668F /* 1/24 */ * f2_x;
    const float dq_y_6 = 0.041666668F /* 1/24 */ * f2_y;
    const float dq_z_6 = 0.041666668F /* 1/24 */ * f2_z;
    const float dq_w = dq_w_6 - dq_w_5;
    const float dq_x = dq_x_5 + dq_x_6;
    const float dq_y = dq_y_5 + dq_y_6;
    const float dq_z = dq_z_5 + dq_z_6;

    /* error = -19/270 (dq - dp)   [Milne] */
    const float error_w_1 = dq_w - dp_w;
    const float error_x_1 = dq_x - dp_x;
    const float error_y_1 = dq_y - dp_y;
    const float error_z_1 = dq_z - dp_z;
    const float error_w = -0.07037037F /* -19/270 */ * error_w_1;
    const float error_x = -0.07037037F /* -19/270 */ * error_x_1;
    const float error_y = -0.07037037F /* -19/270 */ * error_y_1;
    const float error_z = -0.07037037F /* -19/270 */ * error_z_1;

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

    /* dq_e = dq + e q */
    const float dq_e_w_1 = e * q_w;
    const float dq_e_x_1 = e * q_x;
    const float dq_e_y_1 = e * q_y;
    const float dq_e_z_1 = e * q_z;
    const float dq_e_w = dq_w + dq_e_w_1;
    const float dq_e_x = dq_x + dq_e_x_1;
    const float dq_e_y = dq_y + dq_e_y_1;
    const float dq_e_z = dq_z + dq_e_z_1;

    /* q_next = q + dq */
    const float q_next_w = q_w + dq_e_w;
    const float q_next_x = q_x + dq_e_x;
    const float q_next_y = q_y + dq_e_y;
    const float q_next_z = q_z + dq_e_z;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
    const float f_1 = -f0_w_negated;
    state->f[0] = f_1;
    state->f[1] = f0_x;
    state->f[2] = f0_y;
    state->f[3] = f0_z;
    state->f[4] = f1_w;
    state->f[5] = f1_x;
    state->f[6] = f1_y;
    state->f[7] = f1_z;
    state->f[8] = f2_w;
    state->f[9] = f2_x;
    state->f[10] = f2_y;
    state->f[11] = f2_z;
    state->error[0] = error_w;
    state->error[1] = error_x;
    state->error[2] = error_y;
    state->error[3] = error_z;
}

void adams_moulton_4_runge_kutta_4_float32_update(
    adams_moulton_4_runge_kutta_4_float32_state *state, const float omega[3])
{
    /* the history is full after 3 updates */
    if (state->count < 2) {
        adams_moulton_4_runge_kutta_4_float32_hold(state, omega);
    } else if (state->count < 3) {
        adams_moulton_4_runge_kutta_4_float32_start_up(state, omega);
    } else {
        adams_moulton_4_runge_kutta_4_float32_steady(state, omega);
    }
}

void adams_moulton_4_runge_kutta_4_float32_quaternion(
    const adams_moulton_4_runge_kutta_4_float32_state *state, float q_nb[4])
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

void adams_moulton_4_runge_kutta_4_float32_dcm(
    const adams_moulton_4_runge_kutta_4_float32_state *state, float c_nb[9])
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

void adams_moulton_4_runge_kutta_4_float32_error_estimate(
    const adams_moulton_4_runge_kutta_4_float32_state *state, float e[4])
{
    const float error_w = state->error[0];
    const float error_x = state->error[1];
    const float error_y = state->error[2];
    const float error_z = state->error[3];
    e[0] = error_w;
    e[1] = error_x;
    e[2] = error_y;
    e[3] = error_z;
}

int adams_moulton_4_runge_kutta_4_float32_ready(const adams_moulton_4_runge_kutta_4_float32_state *state)
{
    /* the attitude is current from update 3 on */
    return (state->count >= 3) ? 1 : 0;
}
