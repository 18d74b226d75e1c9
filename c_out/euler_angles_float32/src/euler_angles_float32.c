/* Generated, do not edit. Made by: qcone generate euler_angles.toml --design euler_angles_float32
 *
 * qcone 0.1.0, design euler_angles_float32, SHA-256 of the design
 * 48f9ab909fb15d098c2ce998e1c0eeb8cbf9c60df0768fb012ea2137726dc478
 *
 * algorithm:   euler-angles, form factored, rpy' = rpy + change
 * source:      cao introduction; kinematics of roll, pitch, yaw
 * equation:    Runge-Kutta on roll' = wx + tan(pitch) (wy sin(roll) + wz cos(roll)), ...
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  sine and cosine by polynomials, each within a quarter of the last place of 1; the
 *              method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written      111       0   96        31      24       4     0     0    74     106
 * update shared          108       0   93        31      24       4     0     0    68     100
 * update emitted         108       0   93        31      24       4     0     0    68     100
 * dcm as-written          55       0   35        17       9       0     0     0    15      27
 * dcm shared              48       3   35        17       9       0     0     0    15      27
 * dcm emitted             48       3   35        17       9       0     0     0    15      27
 * euler as-written         0       0    0         0       0       0     0     0     0       0
 * euler shared             0       0    0         0       0       0     0     0     0       0
 * euler emitted            0       0    0         0       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "euler_angles_float32.h"

#if EULER_ANGLES_FLOAT32_VERSION != 1
#error "euler_angles_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void euler_angles_float32_init(euler_angles_float32_state *state)
{
    state->rpy[0] = 0.0F;
    state->rpy[1] = 0.0F;
    state->rpy[2] = 0.0F;
    state->omega_last[0] = 0.0F;
    state->omega_last[1] = 0.0F;
    state->omega_last[2] = 0.0F;
}

void euler_angles_float32_set_euler(euler_angles_float32_state *state, const float angles[3])
{
    /* angles, read once */
    const float angles_x = angles[0];
    const float angles_y = angles[1];
    const float angles_z = angles[2];

    /* store */
    state->rpy[0] = angles_x;
    state->rpy[1] = angles_y;
    state->rpy[2] = angles_z;
}

void euler_angles_float32_start(euler_angles_float32_state *state, const float omega[3])
{
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void euler_angles_float32_update(euler_angles_float32_state *state, const float omega[6])
{
    /* attitude and input */
    const float rpy_x = state->rpy[0];
    const float rpy_y = state->rpy[1];
    const float rpy_z = state->rpy[2];
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

    /* k1 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k1_z_1 = 3.1415927F < rpy_x;
    const float k1_z_2 = rpy_x - 6.2831855F;
    const float k1_z_3 = (k1_z_1 != 0) ? k1_z_2 : rpy_x;
    const int32_t k1_z_4 = k1_z_3 < -3.1415927F;
    const float k1_z_5 = k1_z_3 + 6.2831855F;
    const float k1_z_6 = (k1_z_4 != 0) ? k1_z_5 : k1_z_3;
    const int32_t k1_z_7 = k1_z_6 < 0.0F;
    const float k1_z_8 = -k1_z_6;
    const float k1_z_9 = (k1_z_7 != 0) ? k1_z_8 : k1_z_6;
    const int32_t k1_z_10 = 1.5707964F < k1_z_9;
    const float k1_z_11 = 3.1415927F - k1_z_9;
    const float k1_z_12 = (k1_z_10 != 0) ? k1_z_11 : k1_z_9;
    const int32_t k1_z_13 = 0.7853982F < k1_z_12;
    const float k1_z_14 = 1.5707964F - k1_z_12;
    const float k1_z_15 = (k1_z_13 != 0) ? k1_z_14 : k1_z_12;
    const float k1_z_16 = k1_z_15 * k1_z_15;
    const float k1_z_17 = k1_z_16 * -0.00019495712F /* -3/15388 */;
    const float k1_z_18 = 0.008331979F /* 205/24604 */ + k1_z_17;
    const float k1_z_19 = k1_z_16 * k1_z_18;
    const float k1_z_20 = -0.16666651F /* -173294/1039765 */ + k1_z_19;
    const float k1_z_21 = k1_z_16 * k1_z_20;
    const float k1_z_22 = k1_z_15 * k1_z_21;
    const float k1_z_23 = k1_z_15 + k1_z_22;
    const float k1_z_24 = k1_z_16 * 2.4390838e-05F /* 1/40999 */;
    const float k1_z_25 = -0.0013886767F /* -100/72011 */ + k1_z_24;
    const float k1_z_26 = k1_z_16 * k1_z_25;
    const float k1_z_27 = 0.041666623F /* 39776/954625 */ + k1_z_26;
    const float k1_z_28 = k1_z_16 * k1_z_27;
    const float k1_z_29 = -0.5F /* -85104966/170209933 */ + k1_z_28;
    const float k1_z_30 = k1_z_16 * k1_z_29;
    const float k1_z_31 = 1.0F + k1_z_30;
    const float k1_z_32 = (k1_z_13 != 0) ? k1_z_31 : k1_z_23;
    const float k1_z_33 = (k1_z_13 != 0) ? k1_z_23 : k1_z_31;
    const float k1_z_34 = -k1_z_32;
    const float k1_z_35 = (k1_z_7 != 0) ? k1_z_34 : k1_z_32;
    const float k1_z_36 = -k1_z_33;
    const float k1_z_37 = (k1_z_10 != 0) ? k1_z_36 : k1_z_33;
    const int32_t k1_x_1 = 3.1415927F < rpy_y;
    const float k1_x_2 = rpy_y - 6.2831855F;
    const float k1_x_3 = (k1_x_1 != 0) ? k1_x_2 : rpy_y;
    const int32_t k1_x_4 = k1_x_3 < -3.1415927F;
    const float k1_x_5 = k1_x_3 + 6.2831855F;
    const float k1_x_6 = (k1_x_4 != 0) ? k1_x_5 : k1_x_3;
    const int32_t k1_x_7 = k1_x_6 < 0.0F;
    const float k1_x_8 = -k1_x_6;
    const float k1_x_9 = (k1_x_7 != 0) ? k1_x_8 : k1_x_6;
    const int32_t k1_x_10 = 1.5707964F < k1_x_9;
    const float k1_x_11 = 3.1415927F - k1_x_9;
    const float k1_x_12 = (k1_x_10 != 0) ? k1_x_11 : k1_x_9;
    const int32_t k1_x_13 = 0.7853982F < k1_x_12;
    const float k1_x_14 = 1.5707964F - k1_x_12;
    const float k1_x_15 = (k1_x_13 != 0) ? k1_x_14 : k1_x_12;
    const float k1_x_16 = k1_x_15 * k1_x_15;
    const float k1_x_17 = k1_x_16 * -0.00019495712F /* -3/15388 */;
    const float k1_x_18 = 0.008331979F /* 205/24604 */ + k1_x_17;
    const float k1_x_19 = k1_x_16 * k1_x_18;
    const float k1_x_20 = -0.16666651F /* -173294/1039765 */ + k1_x_19;
    const float k1_x_21 = k1_x_16 * k1_x_20;
    const float k1_x_22 = k1_x_15 * k1_x_21;
    const float k1_x_23 = k1_x_15 + k1_x_22;
    const float k1_x_24 = k1_x_16 * 2.4390838e-05F /* 1/40999 */;
    const float k1_x_25 = -0.0013886767F /* -100/72011 */ + k1_x_24;
    const float k1_x_26 = k1_x_16 * k1_x_25;
    const float k1_x_27 = 0.041666623F /* 39776/954625 */ + k1_x_26;
    const float k1_x_28 = k1_x_16 * k1_x_27;
    const float k1_x_29 = -0.5F /* -85104966/170209933 */ + k1_x_28;
    const float k1_x_30 = k1_x_16 * k1_x_29;
    const float k1_x_31 = 1.0F + k1_x_30;
    const float k1_x_32 = (k1_x_13 != 0) ? k1_x_31 : k1_x_23;
    const float k1_z_38 = (k1_x_13 != 0) ? k1_x_23 : k1_x_31;
    const float k1_x_33 = -k1_x_32;
    const float k1_x_34 = (k1_x_7 != 0) ? k1_x_33 : k1_x_32;
    const float k1_z_39 = -k1_z_38;
    const float k1_z_40 = (k1_x_10 != 0) ? k1_z_39 : k1_z_38;
    const float k1_z_41 = k1_z_40 * k1_z_40;
    const int32_t k1_z_42 = k1_z_41 < 7.523164e-37F;
    const float k1_z_43 = (k1_z_42 != 0) ? 8.6736174e-19F /* 1/1152921504606846976 */ : k1_z_40;
    const float k1_z_44 = omega_last_y * k1_z_35;
    const float k1_z_45 = omega_last_z * k1_z_37;
    const float k1_z_46 = k1_z_44 + k1_z_45;
    const float k1_z = k1_z_46 / k1_z_43;
    const float k1_x_35 = k1_x_34 * k1_z;
    const float k1_x = omega_last_x + k1_x_35;
    const float k1_y_1 = omega_last_y * k1_z_37;
    const float k1_y_2 = omega_last_z * k1_z_35;
    const float k1_y = k1_y_1 - k1_y_2;

    /* rates and angles for k2 */
    const float k2_z_1 = 0.005F /* 1/200 */ * k1_x;
    const float k2_x_1 = 0.005F /* 1/200 */ * k1_y;
    const int32_t k2_z_2 = 3.1415927F < k2_z_1;
    const float k2_z_3 = (k2_z_2 != 0) ? 3.1415927F : k2_z_1;
    const int32_t k2_z_4 = k2_z_3 < -3.1415927F;
    const float k2_z_5 = (k2_z_4 != 0) ? -3.1415927F : k2_z_3;
    const int32_t k2_x_2 = 3.1415927F < k2_x_1;
    const float k2_x_3 = (k2_x_2 != 0) ? 3.1415927F : k2_x_1;
    const int32_t k2_x_4 = k2_x_3 < -3.1415927F;
    const float k2_x_5 = (k2_x_4 != 0) ? -3.1415927F : k2_x_3;
    const float k2_z_6 = rpy_x + k2_z_5;
    const float k2_x_6 = rpy_y + k2_x_5;

    /* k2 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k2_z_7 = 3.1415927F < k2_z_6;
    const float k2_z_8 = k2_z_6 - 6.2831855F;
    const float k2_z_9 = (k2_z_7 != 0) ? k2_z_8 : k2_z_6;
    const int32_t k2_z_10 = k2_z_9 < -3.1415927F;
    const float k2_z_11 = k2_z_9 + 6.2831855F;
    const float k2_z_12 = (k2_z_10 != 0) ? k2_z_11 : k2_z_9;
    const int32_t k2_z_13 = k2_z_12 < 0.0F;
    const float k2_z_14 = -k2_z_12;
    const float k2_z_15 = (k2_z_13 != 0) ? k2_z_14 : k2_z_12;
    const int32_t k2_z_16 = 1.5707964F < k2_z_15;
    const float k2_z_17 = 3.1415927F - k2_z_15;
    const float k2_z_18 = (k2_z_16 != 0) ? k2_z_17 : k2_z_15;
    const int32_t k2_z_19 = 0.7853982F < k2_z_18;
    const float k2_z_20 = 1.5707964F - k2_z_18;
    const float k2_z_21 = (k2_z_19 != 0) ? k2_z_20 : k2_z_18;
    const float k2_z_22 = k2_z_21 * k2_z_21;
    const float k2_z_23 = k2_z_22 * -0.00019495712F /* -3/15388 */;
    const float k2_z_24 = 0.008331979F /* 205/24604 */ + k2_z_23;
    const float k2_z_25 = k2_z_22 * k2_z_24;
    const float k2_z_26 = -0.16666651F /* -173294/1039765 */ + k2_z_25;
    const float k2_z_27 = k2_z_22 * k2_z_26;
    const float k2_z_28 = k2_z_21 * k2_z_27;
    const float k2_z_29 = k2_z_21 + k2_z_28;
    const float k2_z_30 = k2_z_22 * 2.4390838e-05F /* 1/40999 */;
    const float k2_z_31 = -0.0013886767F /* -100/72011 */ + k2_z_30;
    const float k2_z_32 = k2_z_22 * k2_z_31;
    const float k2_z_33 = 0.041666623F /* 39776/954625 */ + k2_z_32;
    const float k2_z_34 = k2_z_22 * k2_z_33;
    const float k2_z_35 = -0.5F /* -85104966/170209933 */ + k2_z_34;
    const float k2_z_36 = k2_z_22 * k2_z_35;
    const float k2_z_37 = 1.0F + k2_z_36;
    const float k2_z_38 = (k2_z_19 != 0) ? k2_z_37 : k2_z_29;
    const float k2_z_39 = (k2_z_19 != 0) ? k2_z_29 : k2_z_37;
    const float k2_z_40 = -k2_z_38;
    const float k2_z_41 = (k2_z_13 != 0) ? k2_z_40 : k2_z_38;
    const float k2_z_42 = -k2_z_39;
    const float k2_z_43 = (k2_z_16 != 0) ? k2_z_42 : k2_z_39;
    const int32_t k2_x_7 = 3.1415927F < k2_x_6;
    const float k2_x_8 = k2_x_6 - 6.2831855F;
    const float k2_x_9 = (k2_x_7 != 0) ? k2_x_8 : k2_x_6;
    const int32_t k2_x_10 = k2_x_9 < -3.1415927F;
    const float k2_x_11 = k2_x_9 + 6.2831855F;
    const float k2_x_12 = (k2_x_10 != 0) ? k2_x_11 : k2_x_9;
    const int32_t k2_x_13 = k2_x_12 < 0.0F;
    const float k2_x_14 = -k2_x_12;
    const float k2_x_15 = (k2_x_13 != 0) ? k2_x_14 : k2_x_12;
    const int32_t k2_x_16 = 1.5707964F < k2_x_15;
    const float k2_x_17 = 3.1415927F - k2_x_15;
    const float k2_x_18 = (k2_x_16 != 0) ? k2_x_17 : k2_x_15;
    const int32_t k2_x_19 = 0.7853982F < k2_x_18;
    const float k2_x_20 = 1.5707964F - k2_x_18;
    const float k2_x_21 = (k2_x_19 != 0) ? k2_x_20 : k2_x_18;
    const float k2_x_22 = k2_x_21 * k2_x_21;
    const float k2_x_23 = k2_x_22 * -0.00019495712F /* -3/15388 */;
    const float k2_x_24 = 0.008331979F /* 205/24604 */ + k2_x_23;
    const float k2_x_25 = k2_x_22 * k2_x_24;
    const float k2_x_26 = -0.16666651F /* -173294/1039765 */ + k2_x_25;
    const float k2_x_27 = k2_x_22 * k2_x_26;
    const float k2_x_28 = k2_x_21 * k2_x_27;
    const float k2_x_29 = k2_x_21 + k2_x_28;
    const float k2_x_30 = k2_x_22 * 2.4390838e-05F /* 1/40999 */;
    const float k2_x_31 = -0.0013886767F /* -100/72011 */ + k2_x_30;
    const float k2_x_32 = k2_x_22 * k2_x_31;
    const float k2_x_33 = 0.041666623F /* 39776/954625 */ + k2_x_32;
    const float k2_x_34 = k2_x_22 * k2_x_33;
    const float k2_x_35 = -0.5F /* -85104966/170209933 */ + k2_x_34;
    const float k2_x_36 = k2_x_22 * k2_x_35;
    const float k2_x_37 = 1.0F + k2_x_36;
    const float k2_x_38 = (k2_x_19 != 0) ? k2_x_37 : k2_x_29;
    const float k2_z_44 = (k2_x_19 != 0) ? k2_x_29 : k2_x_37;
    const float k2_x_39 = -k2_x_38;
    const float k2_x_40 = (k2_x_13 != 0) ? k2_x_39 : k2_x_38;
    const float k2_z_45 = -k2_z_44;
    const float k2_z_46 = (k2_x_16 != 0) ? k2_z_45 : k2_z_44;
    const float k2_z_47 = k2_z_46 * k2_z_46;
    const int32_t k2_z_48 = k2_z_47 < 7.523164e-37F;
    const float k2_z_49 = (k2_z_48 != 0) ? 8.6736174e-19F /* 1/1152921504606846976 */ : k2_z_46;
    const float k2_z_50 = omega1_y * k2_z_41;
    const float k2_z_51 = omega1_z * k2_z_43;
    const float k2_z_52 = k2_z_50 + k2_z_51;
    const float k2_z = k2_z_52 / k2_z_49;
    const float k2_x_41 = k2_x_40 * k2_z;
    const float k2_x = omega1_x + k2_x_41;
    const float k2_y_1 = omega1_y * k2_z_43;
    const float k2_y_2 = omega1_z * k2_z_41;
    const float k2_y = k2_y_1 - k2_y_2;

    /* rates and angles for k3 */
    const float k3_z_1 = 0.005F /* 1/200 */ * k2_x;
    const float k3_x_1 = 0.005F /* 1/200 */ * k2_y;
    const int32_t k3_z_2 = 3.1415927F < k3_z_1;
    const float k3_z_3 = (k3_z_2 != 0) ? 3.1415927F : k3_z_1;
    const int32_t k3_z_4 = k3_z_3 < -3.1415927F;
    const float k3_z_5 = (k3_z_4 != 0) ? -3.1415927F : k3_z_3;
    const int32_t k3_x_2 = 3.1415927F < k3_x_1;
    const float k3_x_3 = (k3_x_2 != 0) ? 3.1415927F : k3_x_1;
    const int32_t k3_x_4 = k3_x_3 < -3.1415927F;
    const float k3_x_5 = (k3_x_4 != 0) ? -3.1415927F : k3_x_3;
    const float k3_z_6 = rpy_x + k3_z_5;
    const float k3_x_6 = rpy_y + k3_x_5;

    /* k3 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k3_z_7 = 3.1415927F < k3_z_6;
    const float k3_z_8 = k3_z_6 - 6.2831855F;
    const float k3_z_9 = (k3_z_7 != 0) ? k3_z_8 : k3_z_6;
    const int32_t k3_z_10 = k3_z_9 < -3.1415927F;
    const float k3_z_11 = k3_z_9 + 6.2831855F;
    const float k3_z_12 = (k3_z_10 != 0) ? k3_z_11 : k3_z_9;
    const int32_t k3_z_13 = k3_z_12 < 0.0F;
    const float k3_z_14 = -k3_z_12;
    const float k3_z_15 = (k3_z_13 != 0) ? k3_z_14 : k3_z_12;
    const int32_t k3_z_16 = 1.5707964F < k3_z_15;
    const float k3_z_17 = 3.1415927F - k3_z_15;
    const float k3_z_18 = (k3_z_16 != 0) ? k3_z_17 : k3_z_15;
    const int32_t k3_z_19 = 0.7853982F < k3_z_18;
    const float k3_z_20 = 1.5707964F - k3_z_18;
    const float k3_z_21 = (k3_z_19 != 0) ? k3_z_20 : k3_z_18;
    const float k3_z_22 = k3_z_21 * k3_z_21;
    const float k3_z_23 = k3_z_22 * -0.00019495712F /* -3/15388 */;
    const float k3_z_24 = 0.008331979F /* 205/24604 */ + k3_z_23;
    const float k3_z_25 = k3_z_22 * k3_z_24;
    const float k3_z_26 = -0.16666651F /* -173294/1039765 */ + k3_z_25;
    const float k3_z_27 = k3_z_22 * k3_z_26;
    const float k3_z_28 = k3_z_21 * k3_z_27;
    const float k3_z_29 = k3_z_21 + k3_z_28;
    const float k3_z_30 = k3_z_22 * 2.4390838e-05F /* 1/40999 */;
    const float k3_z_31 = -0.0013886767F /* -100/72011 */ + k3_z_30;
    const float k3_z_32 = k3_z_22 * k3_z_31;
    const float k3_z_33 = 0.041666623F /* 39776/954625 */ + k3_z_32;
    const float k3_z_34 = k3_z_22 * k3_z_33;
    const float k3_z_35 = -0.5F /* -85104966/170209933 */ + k3_z_34;
    const float k3_z_36 = k3_z_22 * k3_z_35;
    const float k3_z_37 = 1.0F + k3_z_36;
    const float k3_z_38 = (k3_z_19 != 0) ? k3_z_37 : k3_z_29;
    const float k3_z_39 = (k3_z_19 != 0) ? k3_z_29 : k3_z_37;
    const float k3_z_40 = -k3_z_38;
    const float k3_z_41 = (k3_z_13 != 0) ? k3_z_40 : k3_z_38;
    const float k3_z_42 = -k3_z_39;
    const float k3_z_43 = (k3_z_16 != 0) ? k3_z_42 : k3_z_39;
    const int32_t k3_x_7 = 3.1415927F < k3_x_6;
    const float k3_x_8 = k3_x_6 - 6.2831855F;
    const float k3_x_9 = (k3_x_7 != 0) ? k3_x_8 : k3_x_6;
    const int32_t k3_x_10 = k3_x_9 < -3.1415927F;
    const float k3_x_11 = k3_x_9 + 6.2831855F;
    const float k3_x_12 = (k3_x_10 != 0) ? k3_x_11 : k3_x_9;
    const int32_t k3_x_13 = k3_x_12 < 0.0F;
    const float k3_x_14 = -k3_x_12;
    const float k3_x_15 = (k3_x_13 != 0) ? k3_x_14 : k3_x_12;
    const int32_t k3_x_16 = 1.5707964F < k3_x_15;
    const float k3_x_17 = 3.1415927F - k3_x_15;
    const float k3_x_18 = (k3_x_16 != 0) ? k3_x_17 : k3_x_15;
    const int32_t k3_x_19 = 0.7853982F < k3_x_18;
    const float k3_x_20 = 1.5707964F - k3_x_18;
    const float k3_x_21 = (k3_x_19 != 0) ? k3_x_20 : k3_x_18;
    const float k3_x_22 = k3_x_21 * k3_x_21;
    const float k3_x_23 = k3_x_22 * -0.00019495712F /* -3/15388 */;
    const float k3_x_24 = 0.008331979F /* 205/24604 */ + k3_x_23;
    const float k3_x_25 = k3_x_22 * k3_x_24;
    const float k3_x_26 = -0.16666651F /* -173294/1039765 */ + k3_x_25;
    const float k3_x_27 = k3_x_22 * k3_x_26;
    const float k3_x_28 = k3_x_21 * k3_x_27;
    const float k3_x_29 = k3_x_21 + k3_x_28;
    const float k3_x_30 = k3_x_22 * 2.4390838e-05F /* 1/40999 */;
    const float k3_x_31 = -0.0013886767F /* -100/72011 */ + k3_x_30;
    const float k3_x_32 = k3_x_22 * k3_x_31;
    const float k3_x_33 = 0.041666623F /* 39776/954625 */ + k3_x_32;
    const float k3_x_34 = k3_x_22 * k3_x_33;
    const float k3_x_35 = -0.5F /* -85104966/170209933 */ + k3_x_34;
    const float k3_x_36 = k3_x_22 * k3_x_35;
    const float k3_x_37 = 1.0F + k3_x_36;
    const float k3_x_38 = (k3_x_19 != 0) ? k3_x_37 : k3_x_29;
    const float k3_z_44 = (k3_x_19 != 0) ? k3_x_29 : k3_x_37;
    const float k3_x_39 = -k3_x_38;
    const float k3_x_40 = (k3_x_13 != 0) ? k3_x_39 : k3_x_38;
    const float k3_z_45 = -k3_z_44;
    const float k3_z_46 = (k3_x_16 != 0) ? k3_z_45 : k3_z_44;
    const float k3_z_47 = k3_z_46 * k3_z_46;
    const int32_t k3_z_48 = k3_z_47 < 7.523164e-37F;
    const float k3_z_49 = (k3_z_48 != 0) ? 8.6736174e-19F /* 1/1152921504606846976 */ : k3_z_46;
    const float k3_z_50 = omega1_y * k3_z_41;
    const float k3_z_51 = omega1_z * k3_z_43;
    const float k3_z_52 = k3_z_50 + k3_z_51;
    const float k3_z = k3_z_52 / k3_z_49;
    const float k3_x_41 = k3_x_40 * k3_z;
    const float k3_x = omega1_x + k3_x_41;
    const float k3_y_1 = omega1_y * k3_z_43;
    const float k3_y_2 = omega1_z * k3_z_41;
    const float k3_y = k3_y_1 - k3_y_2;

    /* rates and angles for k4 */
    const float k4_z_1 = 0.01F /* 1/100 */ * k3_x;
    const float k4_x_1 = 0.01F /* 1/100 */ * k3_y;
    const int32_t k4_z_2 = 3.1415927F < k4_z_1;
    const float k4_z_3 = (k4_z_2 != 0) ? 3.1415927F : k4_z_1;
    const int32_t k4_z_4 = k4_z_3 < -3.1415927F;
    const float k4_z_5 = (k4_z_4 != 0) ? -3.1415927F : k4_z_3;
    const int32_t k4_x_2 = 3.1415927F < k4_x_1;
    const float k4_x_3 = (k4_x_2 != 0) ? 3.1415927F : k4_x_1;
    const int32_t k4_x_4 = k4_x_3 < -3.1415927F;
    const float k4_x_5 = (k4_x_4 != 0) ? -3.1415927F : k4_x_3;
    const float k4_z_6 = rpy_x + k4_z_5;
    const float k4_x_6 = rpy_y + k4_x_5;

    /* k4 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k4_z_7 = 3.1415927F < k4_z_6;
    const float k4_z_8 = k4_z_6 - 6.2831855F;
    const float k4_z_9 = (k4_z_7 != 0) ? k4_z_8 : k4_z_6;
    const int32_t k4_z_10 = k4_z_9 < -3.1415927F;
    const float k4_z_11 = k4_z_9 + 6.2831855F;
    const float k4_z_12 = (k4_z_10 != 0) ? k4_z_11 : k4_z_9;
    const int32_t k4_z_13 = k4_z_12 < 0.0F;
    const float k4_z_14 = -k4_z_12;
    const float k4_z_15 = (k4_z_13 != 0) ? k4_z_14 : k4_z_12;
    const int32_t k4_z_16 = 1.5707964F < k4_z_15;
    const float k4_z_17 = 3.1415927F - k4_z_15;
    const float k4_z_18 = (k4_z_16 != 0) ? k4_z_17 : k4_z_15;
    const int32_t k4_z_19 = 0.7853982F < k4_z_18;
    const float k4_z_20 = 1.5707964F - k4_z_18;
    const float k4_z_21 = (k4_z_19 != 0) ? k4_z_20 : k4_z_18;
    const float k4_z_22 = k4_z_21 * k4_z_21;
    const float k4_z_23 = k4_z_22 * -0.00019495712F /* -3/15388 */;
    const float k4_z_24 = 0.008331979F /* 205/24604 */ + k4_z_23;
    const float k4_z_25 = k4_z_22 * k4_z_24;
    const float k4_z_26 = -0.16666651F /* -173294/1039765 */ + k4_z_25;
    const float k4_z_27 = k4_z_22 * k4_z_26;
    const float k4_z_28 = k4_z_21 * k4_z_27;
    const float k4_z_29 = k4_z_21 + k4_z_28;
    const float k4_z_30 = k4_z_22 * 2.4390838e-05F /* 1/40999 */;
    const float k4_z_31 = -0.0013886767F /* -100/72011 */ + k4_z_30;
    const float k4_z_32 = k4_z_22 * k4_z_31;
    const float k4_z_33 = 0.041666623F /* 39776/954625 */ + k4_z_32;
    const float k4_z_34 = k4_z_22 * k4_z_33;
    const float k4_z_35 = -0.5F /* -85104966/170209933 */ + k4_z_34;
    const float k4_z_36 = k4_z_22 * k4_z_35;
    const float k4_z_37 = 1.0F + k4_z_36;
    const float k4_z_38 = (k4_z_19 != 0) ? k4_z_37 : k4_z_29;
    const float k4_z_39 = (k4_z_19 != 0) ? k4_z_29 : k4_z_37;
    const float k4_z_40 = -k4_z_38;
    const float k4_z_41 = (k4_z_13 != 0) ? k4_z_40 : k4_z_38;
    const float k4_z_42 = -k4_z_39;
    const float k4_z_43 = (k4_z_16 != 0) ? k4_z_42 : k4_z_39;
    const int32_t k4_x_7 = 3.1415927F < k4_x_6;
    const float k4_x_8 = k4_x_6 - 6.2831855F;
    const float k4_x_9 = (k4_x_7 != 0) ? k4_x_8 : k4_x_6;
    const int32_t k4_x_10 = k4_x_9 < -3.1415927F;
    const float k4_x_11 = k4_x_9 + 6.2831855F;
    const float k4_x_12 = (k4_x_10 != 0) ? k4_x_11 : k4_x_9;
    const int32_t k4_x_13 = k4_x_12 < 0.0F;
    const float k4_x_14 = -k4_x_12;
    const float k4_x_15 = (k4_x_13 != 0) ? k4_x_14 : k4_x_12;
    const int32_t k4_x_16 = 1.5707964F < k4_x_15;
    const float k4_x_17 = 3.1415927F - k4_x_15;
    const float k4_x_18 = (k4_x_16 != 0) ? k4_x_17 : k4_x_15;
    const int32_t k4_x_19 = 0.7853982F < k4_x_18;
    const float k4_x_20 = 1.5707964F - k4_x_18;
    const float k4_x_21 = (k4_x_19 != 0) ? k4_x_20 : k4_x_18;
    const float k4_x_22 = k4_x_21 * k4_x_21;
    const float k4_x_23 = k4_x_22 * -0.00019495712F /* -3/15388 */;
    const float k4_x_24 = 0.008331979F /* 205/24604 */ + k4_x_23;
    const float k4_x_25 = k4_x_22 * k4_x_24;
    const float k4_x_26 = -0.16666651F /* -173294/1039765 */ + k4_x_25;
    const float k4_x_27 = k4_x_22 * k4_x_26;
    const float k4_x_28 = k4_x_21 * k4_x_27;
    const float k4_x_29 = k4_x_21 + k4_x_28;
    const float k4_x_30 = k4_x_22 * 2.4390838e-05F /* 1/40999 */;
    const float k4_x_31 = -0.0013886767F /* -100/72011 */ + k4_x_30;
    const float k4_x_32 = k4_x_22 * k4_x_31;
    const float k4_x_33 = 0.041666623F /* 39776/954625 */ + k4_x_32;
    const float k4_x_34 = k4_x_22 * k4_x_33;
    const float k4_x_35 = -0.5F /* -85104966/170209933 */ + k4_x_34;
    const float k4_x_36 = k4_x_22 * k4_x_35;
    const float k4_x_37 = 1.0F + k4_x_36;
    const float k4_x_38 = (k4_x_19 != 0) ? k4_x_37 : k4_x_29;
    const float k4_z_44 = (k4_x_19 != 0) ? k4_x_29 : k4_x_37;
    const float k4_x_39 = -k4_x_38;
    const float k4_x_40 = (k4_x_13 != 0) ? k4_x_39 : k4_x_38;
    const float k4_z_45 = -k4_z_44;
    const float k4_z_46 = (k4_x_16 != 0) ? k4_z_45 : k4_z_44;
    const float k4_z_47 = k4_z_46 * k4_z_46;
    const int32_t k4_z_48 = k4_z_47 < 7.523164e-37F;
    const float k4_z_49 = (k4_z_48 != 0) ? 8.6736174e-19F /* 1/1152921504606846976 */ : k4_z_46;
    const float k4_z_50 = omega2_y * k4_z_41;
    const float k4_z_51 = omega2_z * k4_z_43;
    const float k4_z_52 = k4_z_50 + k4_z_51;
    const float k4_z = k4_z_52 / k4_z_49;
    const float k4_x_41 = k4_x_40 * k4_z;
    const float k4_x = omega2_x + k4_x_41;
    const float k4_y_1 = omega2_y * k4_z_43;
    const float k4_y_2 = omega2_z * k4_z_41;
    const float k4_y = k4_y_1 - k4_y_2;

    /* change = h/6 (k1 + k4) + h/3 (k2 + k3) */
    const float change_x_1 = k1_x + k4_x;
    const float change_y_1 = k1_y + k4_y;
    const float change_z_1 = k1_z + k4_z;
    const float change_x_2 = 0.0016666667F /* 1/600 */ * change_x_1;
    const float change_y_2 = 0.0016666667F /* 1/600 */ * change_y_1;
    const float change_z_2 = 0.0016666667F /* 1/600 */ * change_z_1;
    const float change_x_3 = k2_x + k3_x;
    const float change_y_3 = k2_y + k3_y;
    const float change_z_3 = k2_z + k3_z;
    const float change_x_4 = 0.0033333334F /* 1/300 */ * change_x_3;
    const float change_y_4 = 0.0033333334F /* 1/300 */ * change_y_3;
    const float change_z_4 = 0.0033333334F /* 1/300 */ * change_z_3;
    const float change_x = change_x_2 + change_x_4;
    const float change_y = change_y_2 + change_y_4;
    const float change_z = change_z_2 + change_z_4;

    /* rpy_next = rpy + change, each in [-pi, pi] */
    const int32_t roll_1 = 3.1415927F < change_x;
    const float roll_2 = (roll_1 != 0) ? 3.1415927F : change_x;
    const int32_t roll_3 = roll_2 < -3.1415927F;
    const float roll_4 = (roll_3 != 0) ? -3.1415927F : roll_2;
    const int32_t pitch_1 = 3.1415927F < change_y;
    const float pitch_2 = (pitch_1 != 0) ? 3.1415927F : change_y;
    const int32_t pitch_3 = pitch_2 < -3.1415927F;
    const float pitch_4 = (pitch_3 != 0) ? -3.1415927F : pitch_2;
    const int32_t yaw_1 = 3.1415927F < change_z;
    const float yaw_2 = (yaw_1 != 0) ? 3.1415927F : change_z;
    const int32_t yaw_3 = yaw_2 < -3.1415927F;
    const float yaw_4 = (yaw_3 != 0) ? -3.1415927F : yaw_2;
    const float roll = rpy_x + roll_4;
    const float pitch = rpy_y + pitch_4;
    const float yaw = rpy_z + yaw_4;
    const int32_t rpy_next_x_1 = 3.1415927F < roll;
    const float rpy_next_x_2 = roll - 6.2831855F;
    const float rpy_next_x_3 = (rpy_next_x_1 != 0) ? rpy_next_x_2 : roll;
    const int32_t rpy_next_x_4 = rpy_next_x_3 < -3.1415927F;
    const float rpy_next_x_5 = rpy_next_x_3 + 6.2831855F;
    const float rpy_next_x = (rpy_next_x_4 != 0) ? rpy_next_x_5 : rpy_next_x_3;
    const int32_t rpy_next_y_1 = 3.1415927F < pitch;
    const float rpy_next_y_2 = pitch - 6.2831855F;
    const float rpy_next_y_3 = (rpy_next_y_1 != 0) ? rpy_next_y_2 : pitch;
    const int32_t rpy_next_y_4 = rpy_next_y_3 < -3.1415927F;
    const float rpy_next_y_5 = rpy_next_y_3 + 6.2831855F;
    const float rpy_next_y = (rpy_next_y_4 != 0) ? rpy_next_y_5 : rpy_next_y_3;
    const int32_t rpy_next_z_1 = 3.1415927F < yaw;
    const float rpy_next_z_2 = yaw - 6.2831855F;
    const float rpy_next_z_3 = (rpy_next_z_1 != 0) ? rpy_next_z_2 : yaw;
    const int32_t rpy_next_z_4 = rpy_next_z_3 < -3.1415927F;
    const float rpy_next_z_5 = rpy_next_z_3 + 6.2831855F;
    const float rpy_next_z = (rpy_next_z_4 != 0) ? rpy_next_z_5 : rpy_next_z_3;

    /* store */
    state->rpy[0] = rpy_next_x;
    state->rpy[1] = rpy_next_y;
    state->rpy[2] = rpy_next_z;
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void euler_angles_float32_quaternion(const euler_angles_float32_state *state, float q_nb[4])
{
    /* rpy, read once */
    const float rpy_x = state->rpy[0];
    const float rpy_y = state->rpy[1];
    const float rpy_z = state->rpy[2];

    /* q_nb = quaternion of roll, pitch, yaw (zyx) */
    const float q_nb_w_1 = 0.5F * rpy_x;
    const float q_nb_w_2 = 0.5F * rpy_y;
    const float q_nb_w_3 = 0.5F * rpy_z;
    const int32_t q_nb_w_4 = 3.1415927F < q_nb_w_1;
    const float q_nb_w_5 = q_nb_w_1 - 6.2831855F;
    const float q_nb_w_6 = (q_nb_w_4 != 0) ? q_nb_w_5 : q_nb_w_1;
    const int32_t q_nb_w_7 = q_nb_w_6 < -3.1415927F;
    const float q_nb_w_8 = q_nb_w_6 + 6.2831855F;
    const float q_nb_w_9 = (q_nb_w_7 != 0) ? q_nb_w_8 : q_nb_w_6;
    const int32_t q_nb_w_10 = q_nb_w_9 < 0.0F;
    const float q_nb_w_11 = -q_nb_w_9;
    const float q_nb_w_12 = (q_nb_w_10 != 0) ? q_nb_w_11 : q_nb_w_9;
    const int32_t q_nb_w_13 = 1.5707964F < q_nb_w_12;
    const float q_nb_w_14 = 3.1415927F - q_nb_w_12;
    const float q_nb_w_15 = (q_nb_w_13 != 0) ? q_nb_w_14 : q_nb_w_12;
    const int32_t q_nb_w_16 = 0.7853982F < q_nb_w_15;
    const float q_nb_w_17 = 1.5707964F - q_nb_w_15;
    const float q_nb_w_18 = (q_nb_w_16 != 0) ? q_nb_w_17 : q_nb_w_15;
    const float q_nb_w_19 = q_nb_w_18 * q_nb_w_18;
    const float q_nb_w_20 = q_nb_w_19 * -0.00019495712F /* -3/15388 */;
    const float q_nb_w_21 = 0.008331979F /* 205/24604 */ + q_nb_w_20;
    const float q_nb_w_22 = q_nb_w_19 * q_nb_w_21;
    const float q_nb_w_23 = -0.16666651F /* -173294/1039765 */ + q_nb_w_22;
    const float q_nb_w_24 = q_nb_w_19 * q_nb_w_23;
    const float q_nb_w_25 = q_nb_w_18 * q_nb_w_24;
    const float q_nb_w_26 = q_nb_w_18 + q_nb_w_25;
    const float q_nb_w_27 = q_nb_w_19 * 2.4390838e-05F /* 1/40999 */;
    const float q_nb_w_28 = -0.0013886767F /* -100/72011 */ + q_nb_w_27;
    const float q_nb_w_29 = q_nb_w_19 * q_nb_w_28;
    const float q_nb_w_30 = 0.041666623F /* 39776/954625 */ + q_nb_w_29;
    const float q_nb_w_31 = q_nb_w_19 * q_nb_w_30;
    const float q_nb_w_32 = -0.5F /* -85104966/170209933 */ + q_nb_w_31;
    const float q_nb_w_33 = q_nb_w_19 * q_nb_w_32;
    const float q_nb_w_34 = 1.0F + q_nb_w_33;
    const float q_nb_w_35 = (q_nb_w_16 != 0) ? q_nb_w_34 : q_nb_w_26;
    const float q_nb_w_36 = (q_nb_w_16 != 0) ? q_nb_w_26 : q_nb_w_34;
    const float q_nb_w_37 = -q_nb_w_35;
    const float q_nb_w_38 = (q_nb_w_10 != 0) ? q_nb_w_37 : q_nb_w_35;
    const float q_nb_w_39 = -q_nb_w_36;
    const float q_nb_w_40 = (q_nb_w_13 != 0) ? q_nb_w_39 : q_nb_w_36;
    const int32_t q_nb_w_41 = 3.1415927F < q_nb_w_2;
    const float q_nb_w_42 = q_nb_w_2 - 6.2831855F;
    const float q_nb_w_43 = (q_nb_w_41 != 0) ? q_nb_w_42 : q_nb_w_2;
    const int32_t q_nb_w_44 = q_nb_w_43 < -3.1415927F;
    const float q_nb_w_45 = q_nb_w_43 + 6.2831855F;
    const float q_nb_w_46 = (q_nb_w_44 != 0) ? q_nb_w_45 : q_nb_w_43;
    const int32_t q_nb_w_47 = q_nb_w_46 < 0.0F;
    const float q_nb_w_48 = -q_nb_w_46;
    const float q_nb_w_49 = (q_nb_w_47 != 0) ? q_nb_w_48 : q_nb_w_46;
    const int32_t q_nb_w_50 = 1.5707964F < q_nb_w_49;
    const float q_nb_w_51 = 3.1415927F - q_nb_w_49;
    const float q_nb_w_52 = (q_nb_w_50 != 0) ? q_nb_w_51 : q_nb_w_49;
    const int32_t q_nb_w_53 = 0.7853982F < q_nb_w_52;
    const float q_nb_w_54 = 1.5707964F - q_nb_w_52;
    const float q_nb_w_55 = (q_nb_w_53 != 0) ? q_nb_w_54 : q_nb_w_52;
    const float q_nb_w_56 = q_nb_w_55 * q_nb_w_55;
    const float q_nb_w_57 = q_nb_w_56 * -0.00019495712F /* -3/15388 */;
    const float q_nb_w_58 = 0.008331979F /* 205/24604 */ + q_nb_w_57;
    const float q_nb_w_59 = q_nb_w_56 * q_nb_w_58;
    const float q_nb_w_60 = -0.16666651F /* -173294/1039765 */ + q_nb_w_59;
    const float q_nb_w_61 = q_nb_w_56 * q_nb_w_60;
    const float q_nb_w_62 = q_nb_w_55 * q_nb_w_61;
    const float q_nb_w_63 = q_nb_w_55 + q_nb_w_62;
    const float q_nb_w_64 = q_nb_w_56 * 2.4390838e-05F /* 1/40999 */;
    const float q_nb_w_65 = -0.0013886767F /* -100/72011 */ + q_nb_w_64;
    const float q_nb_w_66 = q_nb_w_56 * q_nb_w_65;
    const float q_nb_w_67 = 0.041666623F /* 39776/954625 */ + q_nb_w_66;
    const float q_nb_w_68 = q_nb_w_56 * q_nb_w_67;
    const float q_nb_w_69 = -0.5F /* -85104966/170209933 */ + q_nb_w_68;
    const float q_nb_w_70 = q_nb_w_56 * q_nb_w_69;
    const float q_nb_w_71 = 1.0F + q_nb_w_70;
    const float q_nb_w_72 = (q_nb_w_53 != 0) ? q_nb_w_71 : q_nb_w_63;
    const float q_nb_w_73 = (q_nb_w_53 != 0) ? q_nb_w_63 : q_nb_w_71;
    const float q_nb_w_74 = -q_nb_w_72;
    const float q_nb_w_75 = (q_nb_w_47 != 0) ? q_nb_w_74 : q_nb_w_72;
    const float q_nb_w_76 = -q_nb_w_73;
    const float q_nb_w_77 = (q_nb_w_50 != 0) ? q_nb_w_76 : q_nb_w_73;
    const int32_t q_nb_w_78 = 3.1415927F < q_nb_w_3;
    const float q_nb_w_79 = q_nb_w_3 - 6.2831855F;
    const float q_nb_w_80 = (q_nb_w_78 != 0) ? q_nb_w_79 : q_nb_w_3;
    const int32_t q_nb_w_81 = q_nb_w_80 < -3.1415927F;
    const float q_nb_w_82 = q_nb_w_80 + 6.2831855F;
    const float q_nb_w_83 = (q_nb_w_81 != 0) ? q_nb_w_82 : q_nb_w_80;
    const int32_t q_nb_w_84 = q_nb_w_83 < 0.0F;
    const float q_nb_w_85 = -q_nb_w_83;
    const float q_nb_w_86 = (q_nb_w_84 != 0) ? q_nb_w_85 : q_nb_w_83;
    const int32_t q_nb_w_87 = 1.5707964F < q_nb_w_86;
    const float q_nb_w_88 = 3.1415927F - q_nb_w_86;
    const float q_nb_w_89 = (q_nb_w_87 != 0) ? q_nb_w_88 : q_nb_w_86;
    const int32_t q_nb_w_90 = 0.7853982F < q_nb_w_89;
    const float q_nb_w_91 = 1.5707964F - q_nb_w_89;
    const float q_nb_w_92 = (q_nb_w_90 != 0) ? q_nb_w_91 : q_nb_w_89;
    const float q_nb_w_93 = q_nb_w_92 * q_nb_w_92;
    const float q_nb_w_94 = q_nb_w_93 * -0.00019495712F /* -3/15388 */;
    const float q_nb_w_95 = 0.008331979F /* 205/24604 */ + q_nb_w_94;
    const float q_nb_w_96 = q_nb_w_93 * q_nb_w_95;
    const float q_nb_w_97 = -0.16666651F /* -173294/1039765 */ + q_nb_w_96;
    const float q_nb_w_98 = q_nb_w_93 * q_nb_w_97;
    const float q_nb_w_99 = q_nb_w_92 * q_nb_w_98;
    const float q_nb_w_100 = q_nb_w_92 + q_nb_w_99;
    const float q_nb_w_101 = q_nb_w_93 * 2.4390838e-05F /* 1/40999 */;
    const float q_nb_w_102 = -0.0013886767F /* -100/72011 */ + q_nb_w_101;
    const float q_nb_w_103 = q_nb_w_93 * q_nb_w_102;
    const float q_nb_w_104 = 0.041666623F /* 39776/954625 */ + q_nb_w_103;
    const float q_nb_w_105 = q_nb_w_93 * q_nb_w_104;
    const float q_nb_w_106 = -0.5F /* -85104966/170209933 */ + q_nb_w_105;
    const float q_nb_w_107 = q_nb_w_93 * q_nb_w_106;
    const float q_nb_w_108 = 1.0F + q_nb_w_107;
    const float q_nb_w_109 = (q_nb_w_90 != 0) ? q_nb_w_108 : q_nb_w_100;
    const float q_nb_w_110 = (q_nb_w_90 != 0) ? q_nb_w_100 : q_nb_w_108;
    const float q_nb_w_111 = -q_nb_w_109;
    const float q_nb_w_112 = (q_nb_w_84 != 0) ? q_nb_w_111 : q_nb_w_109;
    const float q_nb_w_113 = -q_nb_w_110;
    const float q_nb_w_114 = (q_nb_w_87 != 0) ? q_nb_w_113 : q_nb_w_110;
    const float q_nb_w_115 = q_nb_w_114 * q_nb_w_77;
    const float q_nb_w_116 = q_nb_w_115 * q_nb_w_40;
    const float q_nb_w_117 = q_nb_w_112 * q_nb_w_75;
    const float q_nb_w_118 = q_nb_w_117 * q_nb_w_38;
    const float q_nb_w = q_nb_w_116 + q_nb_w_118;
    const float q_nb_x_1 = q_nb_w_115 * q_nb_w_38;
    const float q_nb_x_2 = q_nb_w_117 * q_nb_w_40;
    const float q_nb_x = q_nb_x_1 - q_nb_x_2;
    const float q_nb_y_1 = q_nb_w_114 * q_nb_w_75;
    const float q_nb_y_2 = q_nb_y_1 * q_nb_w_40;
    const float q_nb_y_3 = q_nb_w_112 * q_nb_w_77;
    const float q_nb_y_4 = q_nb_y_3 * q_nb_w_38;
    const float q_nb_y = q_nb_y_2 + q_nb_y_4;
    const float q_nb_z_1 = q_nb_y_3 * q_nb_w_40;
    const float q_nb_z_2 = q_nb_y_1 * q_nb_w_38;
    const float q_nb_z = q_nb_z_1 - q_nb_z_2;

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void euler_angles_float32_dcm(const euler_angles_float32_state *state, float c_nb[9])
{
    /* rpy, read once */
    const float rpy_x = state->rpy[0];
    const float rpy_y = state->rpy[1];
    const float rpy_z = state->rpy[2];

    /* q_nb = quaternion of roll, pitch, yaw (zyx) */
    const float q_nb_w_1 = 0.5F * rpy_x;
    const float q_nb_w_2 = 0.5F * rpy_y;
    const float q_nb_w_3 = 0.5F * rpy_z;
    const int32_t q_nb_w_4 = 3.1415927F < q_nb_w_1;
    const float q_nb_w_5 = q_nb_w_1 - 6.2831855F;
    const float q_nb_w_6 = (q_nb_w_4 != 0) ? q_nb_w_5 : q_nb_w_1;
    const int32_t q_nb_w_7 = q_nb_w_6 < -3.1415927F;
    const float q_nb_w_8 = q_nb_w_6 + 6.2831855F;
    const float q_nb_w_9 = (q_nb_w_7 != 0) ? q_nb_w_8 : q_nb_w_6;
    const int32_t q_nb_w_10 = q_nb_w_9 < 0.0F;
    const float q_nb_w_11 = -q_nb_w_9;
    const float q_nb_w_12 = (q_nb_w_10 != 0) ? q_nb_w_11 : q_nb_w_9;
    const int32_t q_nb_w_13 = 1.5707964F < q_nb_w_12;
    const float q_nb_w_14 = 3.1415927F - q_nb_w_12;
    const float q_nb_w_15 = (q_nb_w_13 != 0) ? q_nb_w_14 : q_nb_w_12;
    const int32_t q_nb_w_16 = 0.7853982F < q_nb_w_15;
    const float q_nb_w_17 = 1.5707964F - q_nb_w_15;
    const float q_nb_w_18 = (q_nb_w_16 != 0) ? q_nb_w_17 : q_nb_w_15;
    const float q_nb_w_19 = q_nb_w_18 * q_nb_w_18;
    const float q_nb_w_20 = q_nb_w_19 * -0.00019495712F /* -3/15388 */;
    const float q_nb_w_21 = 0.008331979F /* 205/24604 */ + q_nb_w_20;
    const float q_nb_w_22 = q_nb_w_19 * q_nb_w_21;
    const float q_nb_w_23 = -0.16666651F /* -173294/1039765 */ + q_nb_w_22;
    const float q_nb_w_24 = q_nb_w_19 * q_nb_w_23;
    const float q_nb_w_25 = q_nb_w_18 * q_nb_w_24;
    const float q_nb_w_26 = q_nb_w_18 + q_nb_w_25;
    const float q_nb_w_27 = q_nb_w_19 * 2.4390838e-05F /* 1/40999 */;
    const float q_nb_w_28 = -0.0013886767F /* -100/72011 */ + q_nb_w_27;
    const float q_nb_w_29 = q_nb_w_19 * q_nb_w_28;
    const float q_nb_w_30 = 0.041666623F /* 39776/954625 */ + q_nb_w_29;
    const float q_nb_w_31 = q_nb_w_19 * q_nb_w_30;
    const float q_nb_w_32 = -0.5F /* -85104966/170209933 */ + q_nb_w_31;
    const float q_nb_w_33 = q_nb_w_19 * q_nb_w_32;
    const float q_nb_w_34 = 1.0F + q_nb_w_33;
    const float q_nb_w_35 = (q_nb_w_16 != 0) ? q_nb_w_34 : q_nb_w_26;
    const float q_nb_w_36 = (q_nb_w_16 != 0) ? q_nb_w_26 : q_nb_w_34;
    const float q_nb_w_37 = -q_nb_w_35;
    const float q_nb_w_38 = (q_nb_w_10 != 0) ? q_nb_w_37 : q_nb_w_35;
    const float q_nb_w_39 = -q_nb_w_36;
    const float q_nb_w_40 = (q_nb_w_13 != 0) ? q_nb_w_39 : q_nb_w_36;
    const int32_t q_nb_w_41 = 3.1415927F < q_nb_w_2;
    const float q_nb_w_42 = q_nb_w_2 - 6.2831855F;
    const float q_nb_w_43 = (q_nb_w_41 != 0) ? q_nb_w_42 : q_nb_w_2;
    const int32_t q_nb_w_44 = q_nb_w_43 < -3.1415927F;
    const float q_nb_w_45 = q_nb_w_43 + 6.2831855F;
    const float q_nb_w_46 = (q_nb_w_44 != 0) ? q_nb_w_45 : q_nb_w_43;
    const int32_t q_nb_w_47 = q_nb_w_46 < 0.0F;
    const float q_nb_w_48 = -q_nb_w_46;
    const float q_nb_w_49 = (q_nb_w_47 != 0) ? q_nb_w_48 : q_nb_w_46;
    const int32_t q_nb_w_50 = 1.5707964F < q_nb_w_49;
    const float q_nb_w_51 = 3.1415927F - q_nb_w_49;
    const float q_nb_w_52 = (q_nb_w_50 != 0) ? q_nb_w_51 : q_nb_w_49;
    const int32_t q_nb_w_53 = 0.7853982F < q_nb_w_52;
    const float q_nb_w_54 = 1.5707964F - q_nb_w_52;
    const float q_nb_w_55 = (q_nb_w_53 != 0) ? q_nb_w_54 : q_nb_w_52;
    const float q_nb_w_56 = q_nb_w_55 * q_nb_w_55;
    const float q_nb_w_57 = q_nb_w_56 * -0.00019495712F /* -3/15388 */;
    const float q_nb_w_58 = 0.008331979F /* 205/24604 */ + q_nb_w_57;
    const float q_nb_w_59 = q_nb_w_56 * q_nb_w_58;
    const float q_nb_w_60 = -0.16666651F /* -173294/1039765 */ + q_nb_w_59;
    const float q_nb_w_61 = q_nb_w_56 * q_nb_w_60;
    const float q_nb_w_62 = q_nb_w_55 * q_nb_w_61;
    const float q_nb_w_63 = q_nb_w_55 + q_nb_w_62;
    const float q_nb_w_64 = q_nb_w_56 * 2.4390838e-05F /* 1/40999 */;
    const float q_nb_w_65 = -0.0013886767F /* -100/72011 */ + q_nb_w_64;
    const float q_nb_w_66 = q_nb_w_56 * q_nb_w_65;
    const float q_nb_w_67 = 0.041666623F /* 39776/954625 */ + q_nb_w_66;
    const float q_nb_w_68 = q_nb_w_56 * q_nb_w_67;
    const float q_nb_w_69 = -0.5F /* -85104966/170209933 */ + q_nb_w_68;
    const float q_nb_w_70 = q_nb_w_56 * q_nb_w_69;
    const float q_nb_w_71 = 1.0F + q_nb_w_70;
    const float q_nb_w_72 = (q_nb_w_53 != 0) ? q_nb_w_71 : q_nb_w_63;
    const float q_nb_w_73 = (q_nb_w_53 != 0) ? q_nb_w_63 : q_nb_w_71;
    const float q_nb_w_74 = -q_nb_w_72;
    const float q_nb_w_75 = (q_nb_w_47 != 0) ? q_nb_w_74 : q_nb_w_72;
    const float q_nb_w_76 = -q_nb_w_73;
    const float q_nb_w_77 = (q_nb_w_50 != 0) ? q_nb_w_76 : q_nb_w_73;
    const int32_t q_nb_w_78 = 3.1415927F < q_nb_w_3;
    const float q_nb_w_79 = q_nb_w_3 - 6.2831855F;
    const float q_nb_w_80 = (q_nb_w_78 != 0) ? q_nb_w_79 : q_nb_w_3;
    const int32_t q_nb_w_81 = q_nb_w_80 < -3.1415927F;
    const float q_nb_w_82 = q_nb_w_80 + 6.2831855F;
    const float q_nb_w_83 = (q_nb_w_81 != 0) ? q_nb_w_82 : q_nb_w_80;
    const int32_t q_nb_w_84 = q_nb_w_83 < 0.0F;
    const float q_nb_w_85 = -q_nb_w_83;
    const float q_nb_w_86 = (q_nb_w_84 != 0) ? q_nb_w_85 : q_nb_w_83;
    const int32_t q_nb_w_87 = 1.5707964F < q_nb_w_86;
    const float q_nb_w_88 = 3.1415927F - q_nb_w_86;
    const float q_nb_w_89 = (q_nb_w_87 != 0) ? q_nb_w_88 : q_nb_w_86;
    const int32_t q_nb_w_90 = 0.7853982F < q_nb_w_89;
    const float q_nb_w_91 = 1.5707964F - q_nb_w_89;
    const float q_nb_w_92 = (q_nb_w_90 != 0) ? q_nb_w_91 : q_nb_w_89;
    const float q_nb_w_93 = q_nb_w_92 * q_nb_w_92;
    const float q_nb_w_94 = q_nb_w_93 * -0.00019495712F /* -3/15388 */;
    const float q_nb_w_95 = 0.008331979F /* 205/24604 */ + q_nb_w_94;
    const float q_nb_w_96 = q_nb_w_93 * q_nb_w_95;
    const float q_nb_w_97 = -0.16666651F /* -173294/1039765 */ + q_nb_w_96;
    const float q_nb_w_98 = q_nb_w_93 * q_nb_w_97;
    const float q_nb_w_99 = q_nb_w_92 * q_nb_w_98;
    const float q_nb_w_100 = q_nb_w_92 + q_nb_w_99;
    const float q_nb_w_101 = q_nb_w_93 * 2.4390838e-05F /* 1/40999 */;
    const float q_nb_w_102 = -0.0013886767F /* -100/72011 */ + q_nb_w_101;
    const float q_nb_w_103 = q_nb_w_93 * q_nb_w_102;
    const float q_nb_w_104 = 0.041666623F /* 39776/954625 */ + q_nb_w_103;
    const float q_nb_w_105 = q_nb_w_93 * q_nb_w_104;
    const float q_nb_w_106 = -0.5F /* -85104966/170209933 */ + q_nb_w_105;
    const float q_nb_w_107 = q_nb_w_93 * q_nb_w_106;
    const float q_nb_w_108 = 1.0F + q_nb_w_107;
    const float q_nb_w_109 = (q_nb_w_90 != 0) ? q_nb_w_108 : q_nb_w_100;
    const float q_nb_w_110 = (q_nb_w_90 != 0) ? q_nb_w_100 : q_nb_w_108;
    const float q_nb_w_111 = -q_nb_w_109;
    const float q_nb_w_112 = (q_nb_w_84 != 0) ? q_nb_w_111 : q_nb_w_109;
    const float q_nb_w_113 = -q_nb_w_110;
    const float q_nb_w_114 = (q_nb_w_87 != 0) ? q_nb_w_113 : q_nb_w_110;
    const float q_nb_w_115 = q_nb_w_114 * q_nb_w_77;
    const float q_nb_w_116 = q_nb_w_115 * q_nb_w_40;
    const float q_nb_w_117 = q_nb_w_112 * q_nb_w_75;
    const float q_nb_w_118 = q_nb_w_117 * q_nb_w_38;
    const float q_nb_w = q_nb_w_116 + q_nb_w_118;
    const float q_nb_x_1 = q_nb_w_115 * q_nb_w_38;
    const float q_nb_x_2 = q_nb_w_117 * q_nb_w_40;
    const float q_nb_x = q_nb_x_1 - q_nb_x_2;
    const float q_nb_y_1 = q_nb_w_114 * q_nb_w_75;
    const float q_nb_y_2 = q_nb_y_1 * q_nb_w_40;
    const float q_nb_y_3 = q_nb_w_112 * q_nb_w_77;
    const float q_nb_y_4 = q_nb_y_3 * q_nb_w_38;
    const float q_nb_y = q_nb_y_2 + q_nb_y_4;
    const float q_nb_z_1 = q_nb_y_3 * q_nb_w_40;
    const float q_nb_z_2 = q_nb_y_1 * q_nb_w_38;
    const float q_nb_z = q_nb_z_1 - q_nb_z_2;

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const float x2 = q_nb_x + q_nb_x;
    const float y2 = q_nb_y + q_nb_y;
    const float z2 = q_nb_z + q_nb_z;
    const float wx = q_nb_w * x2;
    const float wy = q_nb_w * y2;
    const float wz = q_nb_w * z2;
    const float xx = q_nb_x * x2;
    const float xy = q_nb_x * y2;
    const float xz = q_nb_x * z2;
    const float yy = q_nb_y * y2;
    const float yz = q_nb_y * z2;
    const float zz = q_nb_z * z2;

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

void euler_angles_float32_euler(const euler_angles_float32_state *state, float angles[3])
{
    /* rpy, read once */
    const float rpy_x = state->rpy[0];
    const float rpy_y = state->rpy[1];
    const float rpy_z = state->rpy[2];

    angles[0] = rpy_x;
    angles[1] = rpy_y;
    angles[2] = rpy_z;
}
