/* Generated, do not edit. Made by: qcone generate euler_angles.toml --design euler_angles_float64
 *
 * qcone 0.1.0, design euler_angles_float64, SHA-256 of the design
 * 4e129a71d40c4bb3bb66e74b170004bf79ba471bd7ab877273ca96e125d6b11d
 *
 * algorithm:   euler-angles, form factored, rpy' = rpy + change
 * source:      cao introduction; kinematics of roll, pitch, yaw
 * equation:    Runge-Kutta on roll' = wx + tan(pitch) (wy sin(roll) + wz cos(roll)), ...
 * number:      float64, every operation rounded once
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
 * update as-written      151       0  136        31      24       4     0     0    74     106
 * update shared          148       0  133        31      24       4     0     0    68     100
 * update emitted         148       0  133        31      24       4     0     0    68     100
 * dcm as-written          70       0   50        17       9       0     0     0    15      27
 * dcm shared              63       3   50        17       9       0     0     0    15      27
 * dcm emitted             63       3   50        17       9       0     0     0    15      27
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
#include "euler_angles_float64.h"

#if EULER_ANGLES_FLOAT64_VERSION != 1
#error "euler_angles_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void euler_angles_float64_init(euler_angles_float64_state *state)
{
    state->rpy[0] = 0.0;
    state->rpy[1] = 0.0;
    state->rpy[2] = 0.0;
    state->omega_last[0] = 0.0;
    state->omega_last[1] = 0.0;
    state->omega_last[2] = 0.0;
}

void euler_angles_float64_set_euler(euler_angles_float64_state *state, const double angles[3])
{
    /* angles, read once */
    const double angles_x = angles[0];
    const double angles_y = angles[1];
    const double angles_z = angles[2];

    /* store */
    state->rpy[0] = angles_x;
    state->rpy[1] = angles_y;
    state->rpy[2] = angles_z;
}

void euler_angles_float64_start(euler_angles_float64_state *state, const double omega[3])
{
    const double omega_x = omega[0];
    const double omega_y = omega[1];
    const double omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void euler_angles_float64_update(euler_angles_float64_state *state, const double omega[6])
{
    /* attitude and input */
    const double rpy_x = state->rpy[0];
    const double rpy_y = state->rpy[1];
    const double rpy_z = state->rpy[2];
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

    /* k1 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k1_z_1 = 3.141592653589793 < rpy_x;
    const double k1_z_2 = rpy_x - 6.283185307179586;
    const double k1_z_3 = (k1_z_1 != 0) ? k1_z_2 : rpy_x;
    const int32_t k1_z_4 = k1_z_3 < -3.141592653589793;
    const double k1_z_5 = k1_z_3 + 6.283185307179586;
    const double k1_z_6 = (k1_z_4 != 0) ? k1_z_5 : k1_z_3;
    const int32_t k1_z_7 = k1_z_6 < 0.0;
    const double k1_z_8 = -k1_z_6;
    const double k1_z_9 = (k1_z_7 != 0) ? k1_z_8 : k1_z_6;
    const int32_t k1_z_10 = 1.5707963267948966 < k1_z_9;
    const double k1_z_11 = 3.141592653589793 - k1_z_9;
    const double k1_z_12 = (k1_z_10 != 0) ? k1_z_11 : k1_z_9;
    const int32_t k1_z_13 = 0.7853981633974483 < k1_z_12;
    const double k1_z_14 = 1.5707963267948966 - k1_z_12;
    const double k1_z_15 = (k1_z_13 != 0) ? k1_z_14 : k1_z_12;
    const double k1_z_16 = k1_z_15 * k1_z_15;
    const double k1_z_17 = k1_z_16 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k1_z_18 = -2.5050600311467533e-08 /* -28/1117737685 */ + k1_z_17;
    const double k1_z_19 = k1_z_16 * k1_z_18;
    const double k1_z_20 = 2.755731254530188e-06 /* 1933/701447210 */ + k1_z_19;
    const double k1_z_21 = k1_z_16 * k1_z_20;
    const double k1_z_22 = -0.00019841269825935837 /* -256734/1293939361 */ + k1_z_21;
    const double k1_z_23 = k1_z_16 * k1_z_22;
    const double k1_z_24 = 0.008333333333316484 /* 4121483234/494577988081 */ + k1_z_23;
    const double k1_z_25 = k1_z_16 * k1_z_24;
    const double k1_z_26 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k1_z_25;
    const double k1_z_27 = k1_z_16 * k1_z_26;
    const double k1_z_28 = k1_z_15 * k1_z_27;
    const double k1_z_29 = k1_z_15 + k1_z_28;
    const double k1_z_30 = k1_z_16 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k1_z_31 = -2.755529690519287e-07 /* -121/439117025 */ + k1_z_30;
    const double k1_z_32 = k1_z_16 * k1_z_31;
    const double k1_z_33 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k1_z_32;
    const double k1_z_34 = k1_z_16 * k1_z_33;
    const double k1_z_35 = -0.0013888888871736989 /* -1124664/809758081 */ + k1_z_34;
    const double k1_z_36 = k1_z_16 * k1_z_35;
    const double k1_z_37 = 0.04166666666650333 /* 10628826118/255091826833 */ + k1_z_36;
    const double k1_z_38 = k1_z_16 * k1_z_37;
    const double k1_z_39 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k1_z_38;
    const double k1_z_40 = k1_z_16 * k1_z_39;
    const double k1_z_41 = 1.0 + k1_z_40;
    const double k1_z_42 = (k1_z_13 != 0) ? k1_z_41 : k1_z_29;
    const double k1_z_43 = (k1_z_13 != 0) ? k1_z_29 : k1_z_41;
    const double k1_z_44 = -k1_z_42;
    const double k1_z_45 = (k1_z_7 != 0) ? k1_z_44 : k1_z_42;
    const double k1_z_46 = -k1_z_43;
    const double k1_z_47 = (k1_z_10 != 0) ? k1_z_46 : k1_z_43;
    const int32_t k1_x_1 = 3.141592653589793 < rpy_y;
    const double k1_x_2 = rpy_y - 6.283185307179586;
    const double k1_x_3 = (k1_x_1 != 0) ? k1_x_2 : rpy_y;
    const int32_t k1_x_4 = k1_x_3 < -3.141592653589793;
    const double k1_x_5 = k1_x_3 + 6.283185307179586;
    const double k1_x_6 = (k1_x_4 != 0) ? k1_x_5 : k1_x_3;
    const int32_t k1_x_7 = k1_x_6 < 0.0;
    const double k1_x_8 = -k1_x_6;
    const double k1_x_9 = (k1_x_7 != 0) ? k1_x_8 : k1_x_6;
    const int32_t k1_x_10 = 1.5707963267948966 < k1_x_9;
    const double k1_x_11 = 3.141592653589793 - k1_x_9;
    const double k1_x_12 = (k1_x_10 != 0) ? k1_x_11 : k1_x_9;
    const int32_t k1_x_13 = 0.7853981633974483 < k1_x_12;
    const double k1_x_14 = 1.5707963267948966 - k1_x_12;
    const double k1_x_15 = (k1_x_13 != 0) ? k1_x_14 : k1_x_12;
    const double k1_x_16 = k1_x_15 * k1_x_15;
    const double k1_x_17 = k1_x_16 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k1_x_18 = -2.5050600311467533e-08 /* -28/1117737685 */ + k1_x_17;
    const double k1_x_19 = k1_x_16 * k1_x_18;
    const double k1_x_20 = 2.755731254530188e-06 /* 1933/701447210 */ + k1_x_19;
    const double k1_x_21 = k1_x_16 * k1_x_20;
    const double k1_x_22 = -0.00019841269825935837 /* -256734/1293939361 */ + k1_x_21;
    const double k1_x_23 = k1_x_16 * k1_x_22;
    const double k1_x_24 = 0.008333333333316484 /* 4121483234/494577988081 */ + k1_x_23;
    const double k1_x_25 = k1_x_16 * k1_x_24;
    const double k1_x_26 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k1_x_25;
    const double k1_x_27 = k1_x_16 * k1_x_26;
    const double k1_x_28 = k1_x_15 * k1_x_27;
    const double k1_x_29 = k1_x_15 + k1_x_28;
    const double k1_x_30 = k1_x_16 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k1_x_31 = -2.755529690519287e-07 /* -121/439117025 */ + k1_x_30;
    const double k1_x_32 = k1_x_16 * k1_x_31;
    const double k1_x_33 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k1_x_32;
    const double k1_x_34 = k1_x_16 * k1_x_33;
    const double k1_x_35 = -0.0013888888871736989 /* -1124664/809758081 */ + k1_x_34;
    const double k1_x_36 = k1_x_16 * k1_x_35;
    const double k1_x_37 = 0.04166666666650333 /* 10628826118/255091826833 */ + k1_x_36;
    const double k1_x_38 = k1_x_16 * k1_x_37;
    const double k1_x_39 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k1_x_38;
    const double k1_x_40 = k1_x_16 * k1_x_39;
    const double k1_x_41 = 1.0 + k1_x_40;
    const double k1_x_42 = (k1_x_13 != 0) ? k1_x_41 : k1_x_29;
    const double k1_z_48 = (k1_x_13 != 0) ? k1_x_29 : k1_x_41;
    const double k1_x_43 = -k1_x_42;
    const double k1_x_44 = (k1_x_7 != 0) ? k1_x_43 : k1_x_42;
    const double k1_z_49 = -k1_z_48;
    const double k1_z_50 = (k1_x_10 != 0) ? k1_z_49 : k1_z_48;
    const double k1_z_51 = k1_z_50 * k1_z_50;
    const int32_t k1_z_52 = k1_z_51 < 7.52316384526264e-37;
    const double k1_z_53 = (k1_z_52 != 0) ? 8.673617379884035e-19 /* 1/1152921504606846976 */ : k1_z_50;
    const double k1_z_54 = omega_last_y * k1_z_45;
    const double k1_z_55 = omega_last_z * k1_z_47;
    const double k1_z_56 = k1_z_54 + k1_z_55;
    const double k1_z = k1_z_56 / k1_z_53;
    const double k1_x_45 = k1_x_44 * k1_z;
    const double k1_x = omega_last_x + k1_x_45;
    const double k1_y_1 = omega_last_y * k1_z_47;
    const double k1_y_2 = omega_last_z * k1_z_45;
    const double k1_y = k1_y_1 - k1_y_2;

    /* rates and angles for k2 */
    const double k2_z_1 = 0.005 /* 1/200 */ * k1_x;
    const double k2_x_1 = 0.005 /* 1/200 */ * k1_y;
    const int32_t k2_z_2 = 3.141592653589793 < k2_z_1;
    const double k2_z_3 = (k2_z_2 != 0) ? 3.141592653589793 : k2_z_1;
    const int32_t k2_z_4 = k2_z_3 < -3.141592653589793;
    const double k2_z_5 = (k2_z_4 != 0) ? -3.141592653589793 : k2_z_3;
    const int32_t k2_x_2 = 3.141592653589793 < k2_x_1;
    const double k2_x_3 = (k2_x_2 != 0) ? 3.141592653589793 : k2_x_1;
    const int32_t k2_x_4 = k2_x_3 < -3.141592653589793;
    const double k2_x_5 = (k2_x_4 != 0) ? -3.141592653589793 : k2_x_3;
    const double k2_z_6 = rpy_x + k2_z_5;
    const double k2_x_6 = rpy_y + k2_x_5;

    /* k2 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k2_z_7 = 3.141592653589793 < k2_z_6;
    const double k2_z_8 = k2_z_6 - 6.283185307179586;
    const double k2_z_9 = (k2_z_7 != 0) ? k2_z_8 : k2_z_6;
    const int32_t k2_z_10 = k2_z_9 < -3.141592653589793;
    const double k2_z_11 = k2_z_9 + 6.283185307179586;
    const double k2_z_12 = (k2_z_10 != 0) ? k2_z_11 : k2_z_9;
    const int32_t k2_z_13 = k2_z_12 < 0.0;
    const double k2_z_14 = -k2_z_12;
    const double k2_z_15 = (k2_z_13 != 0) ? k2_z_14 : k2_z_12;
    const int32_t k2_z_16 = 1.5707963267948966 < k2_z_15;
    const double k2_z_17 = 3.141592653589793 - k2_z_15;
    const double k2_z_18 = (k2_z_16 != 0) ? k2_z_17 : k2_z_15;
    const int32_t k2_z_19 = 0.7853981633974483 < k2_z_18;
    const double k2_z_20 = 1.5707963267948966 - k2_z_18;
    const double k2_z_21 = (k2_z_19 != 0) ? k2_z_20 : k2_z_18;
    const double k2_z_22 = k2_z_21 * k2_z_21;
    const double k2_z_23 = k2_z_22 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k2_z_24 = -2.5050600311467533e-08 /* -28/1117737685 */ + k2_z_23;
    const double k2_z_25 = k2_z_22 * k2_z_24;
    const double k2_z_26 = 2.755731254530188e-06 /* 1933/701447210 */ + k2_z_25;
    const double k2_z_27 = k2_z_22 * k2_z_26;
    const double k2_z_28 = -0.00019841269825935837 /* -256734/1293939361 */ + k2_z_27;
    const double k2_z_29 = k2_z_22 * k2_z_28;
    const double k2_z_30 = 0.008333333333316484 /* 4121483234/494577988081 */ + k2_z_29;
    const double k2_z_31 = k2_z_22 * k2_z_30;
    const double k2_z_32 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k2_z_31;
    const double k2_z_33 = k2_z_22 * k2_z_32;
    const double k2_z_34 = k2_z_21 * k2_z_33;
    const double k2_z_35 = k2_z_21 + k2_z_34;
    const double k2_z_36 = k2_z_22 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k2_z_37 = -2.755529690519287e-07 /* -121/439117025 */ + k2_z_36;
    const double k2_z_38 = k2_z_22 * k2_z_37;
    const double k2_z_39 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k2_z_38;
    const double k2_z_40 = k2_z_22 * k2_z_39;
    const double k2_z_41 = -0.0013888888871736989 /* -1124664/809758081 */ + k2_z_40;
    const double k2_z_42 = k2_z_22 * k2_z_41;
    const double k2_z_43 = 0.04166666666650333 /* 10628826118/255091826833 */ + k2_z_42;
    const double k2_z_44 = k2_z_22 * k2_z_43;
    const double k2_z_45 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k2_z_44;
    const double k2_z_46 = k2_z_22 * k2_z_45;
    const double k2_z_47 = 1.0 + k2_z_46;
    const double k2_z_48 = (k2_z_19 != 0) ? k2_z_47 : k2_z_35;
    const double k2_z_49 = (k2_z_19 != 0) ? k2_z_35 : k2_z_47;
    const double k2_z_50 = -k2_z_48;
    const double k2_z_51 = (k2_z_13 != 0) ? k2_z_50 : k2_z_48;
    const double k2_z_52 = -k2_z_49;
    const double k2_z_53 = (k2_z_16 != 0) ? k2_z_52 : k2_z_49;
    const int32_t k2_x_7 = 3.141592653589793 < k2_x_6;
    const double k2_x_8 = k2_x_6 - 6.283185307179586;
    const double k2_x_9 = (k2_x_7 != 0) ? k2_x_8 : k2_x_6;
    const int32_t k2_x_10 = k2_x_9 < -3.141592653589793;
    const double k2_x_11 = k2_x_9 + 6.283185307179586;
    const double k2_x_12 = (k2_x_10 != 0) ? k2_x_11 : k2_x_9;
    const int32_t k2_x_13 = k2_x_12 < 0.0;
    const double k2_x_14 = -k2_x_12;
    const double k2_x_15 = (k2_x_13 != 0) ? k2_x_14 : k2_x_12;
    const int32_t k2_x_16 = 1.5707963267948966 < k2_x_15;
    const double k2_x_17 = 3.141592653589793 - k2_x_15;
    const double k2_x_18 = (k2_x_16 != 0) ? k2_x_17 : k2_x_15;
    const int32_t k2_x_19 = 0.7853981633974483 < k2_x_18;
    const double k2_x_20 = 1.5707963267948966 - k2_x_18;
    const double k2_x_21 = (k2_x_19 != 0) ? k2_x_20 : k2_x_18;
    const double k2_x_22 = k2_x_21 * k2_x_21;
    const double k2_x_23 = k2_x_22 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k2_x_24 = -2.5050600311467533e-08 /* -28/1117737685 */ + k2_x_23;
    const double k2_x_25 = k2_x_22 * k2_x_24;
    const double k2_x_26 = 2.755731254530188e-06 /* 1933/701447210 */ + k2_x_25;
    const double k2_x_27 = k2_x_22 * k2_x_26;
    const double k2_x_28 = -0.00019841269825935837 /* -256734/1293939361 */ + k2_x_27;
    const double k2_x_29 = k2_x_22 * k2_x_28;
    const double k2_x_30 = 0.008333333333316484 /* 4121483234/494577988081 */ + k2_x_29;
    const double k2_x_31 = k2_x_22 * k2_x_30;
    const double k2_x_32 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k2_x_31;
    const double k2_x_33 = k2_x_22 * k2_x_32;
    const double k2_x_34 = k2_x_21 * k2_x_33;
    const double k2_x_35 = k2_x_21 + k2_x_34;
    const double k2_x_36 = k2_x_22 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k2_x_37 = -2.755529690519287e-07 /* -121/439117025 */ + k2_x_36;
    const double k2_x_38 = k2_x_22 * k2_x_37;
    const double k2_x_39 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k2_x_38;
    const double k2_x_40 = k2_x_22 * k2_x_39;
    const double k2_x_41 = -0.0013888888871736989 /* -1124664/809758081 */ + k2_x_40;
    const double k2_x_42 = k2_x_22 * k2_x_41;
    const double k2_x_43 = 0.04166666666650333 /* 10628826118/255091826833 */ + k2_x_42;
    const double k2_x_44 = k2_x_22 * k2_x_43;
    const double k2_x_45 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k2_x_44;
    const double k2_x_46 = k2_x_22 * k2_x_45;
    const double k2_x_47 = 1.0 + k2_x_46;
    const double k2_x_48 = (k2_x_19 != 0) ? k2_x_47 : k2_x_35;
    const double k2_z_54 = (k2_x_19 != 0) ? k2_x_35 : k2_x_47;
    const double k2_x_49 = -k2_x_48;
    const double k2_x_50 = (k2_x_13 != 0) ? k2_x_49 : k2_x_48;
    const double k2_z_55 = -k2_z_54;
    const double k2_z_56 = (k2_x_16 != 0) ? k2_z_55 : k2_z_54;
    const double k2_z_57 = k2_z_56 * k2_z_56;
    const int32_t k2_z_58 = k2_z_57 < 7.52316384526264e-37;
    const double k2_z_59 = (k2_z_58 != 0) ? 8.673617379884035e-19 /* 1/1152921504606846976 */ : k2_z_56;
    const double k2_z_60 = omega1_y * k2_z_51;
    const double k2_z_61 = omega1_z * k2_z_53;
    const double k2_z_62 = k2_z_60 + k2_z_61;
    const double k2_z = k2_z_62 / k2_z_59;
    const double k2_x_51 = k2_x_50 * k2_z;
    const double k2_x = omega1_x + k2_x_51;
    const double k2_y_1 = omega1_y * k2_z_53;
    const double k2_y_2 = omega1_z * k2_z_51;
    const double k2_y = k2_y_1 - k2_y_2;

    /* rates and angles for k3 */
    const double k3_z_1 = 0.005 /* 1/200 */ * k2_x;
    const double k3_x_1 = 0.005 /* 1/200 */ * k2_y;
    const int32_t k3_z_2 = 3.141592653589793 < k3_z_1;
    const double k3_z_3 = (k3_z_2 != 0) ? 3.141592653589793 : k3_z_1;
    const int32_t k3_z_4 = k3_z_3 < -3.141592653589793;
    const double k3_z_5 = (k3_z_4 != 0) ? -3.141592653589793 : k3_z_3;
    const int32_t k3_x_2 = 3.141592653589793 < k3_x_1;
    const double k3_x_3 = (k3_x_2 != 0) ? 3.141592653589793 : k3_x_1;
    const int32_t k3_x_4 = k3_x_3 < -3.141592653589793;
    const double k3_x_5 = (k3_x_4 != 0) ? -3.141592653589793 : k3_x_3;
    const double k3_z_6 = rpy_x + k3_z_5;
    const double k3_x_6 = rpy_y + k3_x_5;

    /* k3 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k3_z_7 = 3.141592653589793 < k3_z_6;
    const double k3_z_8 = k3_z_6 - 6.283185307179586;
    const double k3_z_9 = (k3_z_7 != 0) ? k3_z_8 : k3_z_6;
    const int32_t k3_z_10 = k3_z_9 < -3.141592653589793;
    const double k3_z_11 = k3_z_9 + 6.283185307179586;
    const double k3_z_12 = (k3_z_10 != 0) ? k3_z_11 : k3_z_9;
    const int32_t k3_z_13 = k3_z_12 < 0.0;
    const double k3_z_14 = -k3_z_12;
    const double k3_z_15 = (k3_z_13 != 0) ? k3_z_14 : k3_z_12;
    const int32_t k3_z_16 = 1.5707963267948966 < k3_z_15;
    const double k3_z_17 = 3.141592653589793 - k3_z_15;
    const double k3_z_18 = (k3_z_16 != 0) ? k3_z_17 : k3_z_15;
    const int32_t k3_z_19 = 0.7853981633974483 < k3_z_18;
    const double k3_z_20 = 1.5707963267948966 - k3_z_18;
    const double k3_z_21 = (k3_z_19 != 0) ? k3_z_20 : k3_z_18;
    const double k3_z_22 = k3_z_21 * k3_z_21;
    const double k3_z_23 = k3_z_22 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k3_z_24 = -2.5050600311467533e-08 /* -28/1117737685 */ + k3_z_23;
    const double k3_z_25 = k3_z_22 * k3_z_24;
    const double k3_z_26 = 2.755731254530188e-06 /* 1933/701447210 */ + k3_z_25;
    const double k3_z_27 = k3_z_22 * k3_z_26;
    const double k3_z_28 = -0.00019841269825935837 /* -256734/1293939361 */ + k3_z_27;
    const double k3_z_29 = k3_z_22 * k3_z_28;
    const double k3_z_30 = 0.008333333333316484 /* 4121483234/494577988081 */ + k3_z_29;
    const double k3_z_31 = k3_z_22 * k3_z_30;
    const double k3_z_32 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k3_z_31;
    const double k3_z_33 = k3_z_22 * k3_z_32;
    const double k3_z_34 = k3_z_21 * k3_z_33;
    const double k3_z_35 = k3_z_21 + k3_z_34;
    const double k3_z_36 = k3_z_22 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k3_z_37 = -2.755529690519287e-07 /* -121/439117025 */ + k3_z_36;
    const double k3_z_38 = k3_z_22 * k3_z_37;
    const double k3_z_39 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k3_z_38;
    const double k3_z_40 = k3_z_22 * k3_z_39;
    const double k3_z_41 = -0.0013888888871736989 /* -1124664/809758081 */ + k3_z_40;
    const double k3_z_42 = k3_z_22 * k3_z_41;
    const double k3_z_43 = 0.04166666666650333 /* 10628826118/255091826833 */ + k3_z_42;
    const double k3_z_44 = k3_z_22 * k3_z_43;
    const double k3_z_45 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k3_z_44;
    const double k3_z_46 = k3_z_22 * k3_z_45;
    const double k3_z_47 = 1.0 + k3_z_46;
    const double k3_z_48 = (k3_z_19 != 0) ? k3_z_47 : k3_z_35;
    const double k3_z_49 = (k3_z_19 != 0) ? k3_z_35 : k3_z_47;
    const double k3_z_50 = -k3_z_48;
    const double k3_z_51 = (k3_z_13 != 0) ? k3_z_50 : k3_z_48;
    const double k3_z_52 = -k3_z_49;
    const double k3_z_53 = (k3_z_16 != 0) ? k3_z_52 : k3_z_49;
    const int32_t k3_x_7 = 3.141592653589793 < k3_x_6;
    const double k3_x_8 = k3_x_6 - 6.283185307179586;
    const double k3_x_9 = (k3_x_7 != 0) ? k3_x_8 : k3_x_6;
    const int32_t k3_x_10 = k3_x_9 < -3.141592653589793;
    const double k3_x_11 = k3_x_9 + 6.283185307179586;
    const double k3_x_12 = (k3_x_10 != 0) ? k3_x_11 : k3_x_9;
    const int32_t k3_x_13 = k3_x_12 < 0.0;
    const double k3_x_14 = -k3_x_12;
    const double k3_x_15 = (k3_x_13 != 0) ? k3_x_14 : k3_x_12;
    const int32_t k3_x_16 = 1.5707963267948966 < k3_x_15;
    const double k3_x_17 = 3.141592653589793 - k3_x_15;
    const double k3_x_18 = (k3_x_16 != 0) ? k3_x_17 : k3_x_15;
    const int32_t k3_x_19 = 0.7853981633974483 < k3_x_18;
    const double k3_x_20 = 1.5707963267948966 - k3_x_18;
    const double k3_x_21 = (k3_x_19 != 0) ? k3_x_20 : k3_x_18;
    const double k3_x_22 = k3_x_21 * k3_x_21;
    const double k3_x_23 = k3_x_22 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k3_x_24 = -2.5050600311467533e-08 /* -28/1117737685 */ + k3_x_23;
    const double k3_x_25 = k3_x_22 * k3_x_24;
    const double k3_x_26 = 2.755731254530188e-06 /* 1933/701447210 */ + k3_x_25;
    const double k3_x_27 = k3_x_22 * k3_x_26;
    const double k3_x_28 = -0.00019841269825935837 /* -256734/1293939361 */ + k3_x_27;
    const double k3_x_29 = k3_x_22 * k3_x_28;
    const double k3_x_30 = 0.008333333333316484 /* 4121483234/494577988081 */ + k3_x_29;
    const double k3_x_31 = k3_x_22 * k3_x_30;
    const double k3_x_32 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k3_x_31;
    const double k3_x_33 = k3_x_22 * k3_x_32;
    const double k3_x_34 = k3_x_21 * k3_x_33;
    const double k3_x_35 = k3_x_21 + k3_x_34;
    const double k3_x_36 = k3_x_22 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k3_x_37 = -2.755529690519287e-07 /* -121/439117025 */ + k3_x_36;
    const double k3_x_38 = k3_x_22 * k3_x_37;
    const double k3_x_39 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k3_x_38;
    const double k3_x_40 = k3_x_22 * k3_x_39;
    const double k3_x_41 = -0.0013888888871736989 /* -1124664/809758081 */ + k3_x_40;
    const double k3_x_42 = k3_x_22 * k3_x_41;
    const double k3_x_43 = 0.04166666666650333 /* 10628826118/255091826833 */ + k3_x_42;
    const double k3_x_44 = k3_x_22 * k3_x_43;
    const double k3_x_45 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k3_x_44;
    const double k3_x_46 = k3_x_22 * k3_x_45;
    const double k3_x_47 = 1.0 + k3_x_46;
    const double k3_x_48 = (k3_x_19 != 0) ? k3_x_47 : k3_x_35;
    const double k3_z_54 = (k3_x_19 != 0) ? k3_x_35 : k3_x_47;
    const double k3_x_49 = -k3_x_48;
    const double k3_x_50 = (k3_x_13 != 0) ? k3_x_49 : k3_x_48;
    const double k3_z_55 = -k3_z_54;
    const double k3_z_56 = (k3_x_16 != 0) ? k3_z_55 : k3_z_54;
    const double k3_z_57 = k3_z_56 * k3_z_56;
    const int32_t k3_z_58 = k3_z_57 < 7.52316384526264e-37;
    const double k3_z_59 = (k3_z_58 != 0) ? 8.673617379884035e-19 /* 1/1152921504606846976 */ : k3_z_56;
    const double k3_z_60 = omega1_y * k3_z_51;
    const double k3_z_61 = omega1_z * k3_z_53;
    const double k3_z_62 = k3_z_60 + k3_z_61;
    const double k3_z = k3_z_62 / k3_z_59;
    const double k3_x_51 = k3_x_50 * k3_z;
    const double k3_x = omega1_x + k3_x_51;
    const double k3_y_1 = omega1_y * k3_z_53;
    const double k3_y_2 = omega1_z * k3_z_51;
    const double k3_y = k3_y_1 - k3_y_2;

    /* rates and angles for k4 */
    const double k4_z_1 = 0.01 /* 1/100 */ * k3_x;
    const double k4_x_1 = 0.01 /* 1/100 */ * k3_y;
    const int32_t k4_z_2 = 3.141592653589793 < k4_z_1;
    const double k4_z_3 = (k4_z_2 != 0) ? 3.141592653589793 : k4_z_1;
    const int32_t k4_z_4 = k4_z_3 < -3.141592653589793;
    const double k4_z_5 = (k4_z_4 != 0) ? -3.141592653589793 : k4_z_3;
    const int32_t k4_x_2 = 3.141592653589793 < k4_x_1;
    const double k4_x_3 = (k4_x_2 != 0) ? 3.141592653589793 : k4_x_1;
    const int32_t k4_x_4 = k4_x_3 < -3.141592653589793;
    const double k4_x_5 = (k4_x_4 != 0) ? -3.141592653589793 : k4_x_3;
    const double k4_z_6 = rpy_x + k4_z_5;
    const double k4_x_6 = rpy_y + k4_x_5;

    /* k4 = (roll', pitch', yaw')   [zyx kinematics] */
    const int32_t k4_z_7 = 3.141592653589793 < k4_z_6;
    const double k4_z_8 = k4_z_6 - 6.283185307179586;
    const double k4_z_9 = (k4_z_7 != 0) ? k4_z_8 : k4_z_6;
    const int32_t k4_z_10 = k4_z_9 < -3.141592653589793;
    const double k4_z_11 = k4_z_9 + 6.283185307179586;
    const double k4_z_12 = (k4_z_10 != 0) ? k4_z_11 : k4_z_9;
    const int32_t k4_z_13 = k4_z_12 < 0.0;
    const double k4_z_14 = -k4_z_12;
    const double k4_z_15 = (k4_z_13 != 0) ? k4_z_14 : k4_z_12;
    const int32_t k4_z_16 = 1.5707963267948966 < k4_z_15;
    const double k4_z_17 = 3.141592653589793 - k4_z_15;
    const double k4_z_18 = (k4_z_16 != 0) ? k4_z_17 : k4_z_15;
    const int32_t k4_z_19 = 0.7853981633974483 < k4_z_18;
    const double k4_z_20 = 1.5707963267948966 - k4_z_18;
    const double k4_z_21 = (k4_z_19 != 0) ? k4_z_20 : k4_z_18;
    const double k4_z_22 = k4_z_21 * k4_z_21;
    const double k4_z_23 = k4_z_22 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k4_z_24 = -2.5050600311467533e-08 /* -28/1117737685 */ + k4_z_23;
    const double k4_z_25 = k4_z_22 * k4_z_24;
    const double k4_z_26 = 2.755731254530188e-06 /* 1933/701447210 */ + k4_z_25;
    const double k4_z_27 = k4_z_22 * k4_z_26;
    const double k4_z_28 = -0.00019841269825935837 /* -256734/1293939361 */ + k4_z_27;
    const double k4_z_29 = k4_z_22 * k4_z_28;
    const double k4_z_30 = 0.008333333333316484 /* 4121483234/494577988081 */ + k4_z_29;
    const double k4_z_31 = k4_z_22 * k4_z_30;
    const double k4_z_32 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k4_z_31;
    const double k4_z_33 = k4_z_22 * k4_z_32;
    const double k4_z_34 = k4_z_21 * k4_z_33;
    const double k4_z_35 = k4_z_21 + k4_z_34;
    const double k4_z_36 = k4_z_22 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k4_z_37 = -2.755529690519287e-07 /* -121/439117025 */ + k4_z_36;
    const double k4_z_38 = k4_z_22 * k4_z_37;
    const double k4_z_39 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k4_z_38;
    const double k4_z_40 = k4_z_22 * k4_z_39;
    const double k4_z_41 = -0.0013888888871736989 /* -1124664/809758081 */ + k4_z_40;
    const double k4_z_42 = k4_z_22 * k4_z_41;
    const double k4_z_43 = 0.04166666666650333 /* 10628826118/255091826833 */ + k4_z_42;
    const double k4_z_44 = k4_z_22 * k4_z_43;
    const double k4_z_45 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k4_z_44;
    const double k4_z_46 = k4_z_22 * k4_z_45;
    const double k4_z_47 = 1.0 + k4_z_46;
    const double k4_z_48 = (k4_z_19 != 0) ? k4_z_47 : k4_z_35;
    const double k4_z_49 = (k4_z_19 != 0) ? k4_z_35 : k4_z_47;
    const double k4_z_50 = -k4_z_48;
    const double k4_z_51 = (k4_z_13 != 0) ? k4_z_50 : k4_z_48;
    const double k4_z_52 = -k4_z_49;
    const double k4_z_53 = (k4_z_16 != 0) ? k4_z_52 : k4_z_49;
    const int32_t k4_x_7 = 3.141592653589793 < k4_x_6;
    const double k4_x_8 = k4_x_6 - 6.283185307179586;
    const double k4_x_9 = (k4_x_7 != 0) ? k4_x_8 : k4_x_6;
    const int32_t k4_x_10 = k4_x_9 < -3.141592653589793;
    const double k4_x_11 = k4_x_9 + 6.283185307179586;
    const double k4_x_12 = (k4_x_10 != 0) ? k4_x_11 : k4_x_9;
    const int32_t k4_x_13 = k4_x_12 < 0.0;
    const double k4_x_14 = -k4_x_12;
    const double k4_x_15 = (k4_x_13 != 0) ? k4_x_14 : k4_x_12;
    const int32_t k4_x_16 = 1.5707963267948966 < k4_x_15;
    const double k4_x_17 = 3.141592653589793 - k4_x_15;
    const double k4_x_18 = (k4_x_16 != 0) ? k4_x_17 : k4_x_15;
    const int32_t k4_x_19 = 0.7853981633974483 < k4_x_18;
    const double k4_x_20 = 1.5707963267948966 - k4_x_18;
    const double k4_x_21 = (k4_x_19 != 0) ? k4_x_20 : k4_x_18;
    const double k4_x_22 = k4_x_21 * k4_x_21;
    const double k4_x_23 = k4_x_22 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double k4_x_24 = -2.5050600311467533e-08 /* -28/1117737685 */ + k4_x_23;
    const double k4_x_25 = k4_x_22 * k4_x_24;
    const double k4_x_26 = 2.755731254530188e-06 /* 1933/701447210 */ + k4_x_25;
    const double k4_x_27 = k4_x_22 * k4_x_26;
    const double k4_x_28 = -0.00019841269825935837 /* -256734/1293939361 */ + k4_x_27;
    const double k4_x_29 = k4_x_22 * k4_x_28;
    const double k4_x_30 = 0.008333333333316484 /* 4121483234/494577988081 */ + k4_x_29;
    const double k4_x_31 = k4_x_22 * k4_x_30;
    const double k4_x_32 = -0.166666666666666 /* -41891153280974/251346919685845 */ + k4_x_31;
    const double k4_x_33 = k4_x_22 * k4_x_32;
    const double k4_x_34 = k4_x_21 * k4_x_33;
    const double k4_x_35 = k4_x_21 + k4_x_34;
    const double k4_x_36 = k4_x_22 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double k4_x_37 = -2.755529690519287e-07 /* -121/439117025 */ + k4_x_36;
    const double k4_x_38 = k4_x_22 * k4_x_37;
    const double k4_x_39 = 2.4801579019900845e-05 /* 37063/1494380659 */ + k4_x_38;
    const double k4_x_40 = k4_x_22 * k4_x_39;
    const double k4_x_41 = -0.0013888888871736989 /* -1124664/809758081 */ + k4_x_40;
    const double k4_x_42 = k4_x_22 * k4_x_41;
    const double k4_x_43 = 0.04166666666650333 /* 10628826118/255091826833 */ + k4_x_42;
    const double k4_x_44 = k4_x_22 * k4_x_43;
    const double k4_x_45 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + k4_x_44;
    const double k4_x_46 = k4_x_22 * k4_x_45;
    const double k4_x_47 = 1.0 + k4_x_46;
    const double k4_x_48 = (k4_x_19 != 0) ? k4_x_47 : k4_x_35;
    const double k4_z_54 = (k4_x_19 != 0) ? k4_x_35 : k4_x_47;
    const double k4_x_49 = -k4_x_48;
    const double k4_x_50 = (k4_x_13 != 0) ? k4_x_49 : k4_x_48;
    const double k4_z_55 = -k4_z_54;
    const double k4_z_56 = (k4_x_16 != 0) ? k4_z_55 : k4_z_54;
    const double k4_z_57 = k4_z_56 * k4_z_56;
    const int32_t k4_z_58 = k4_z_57 < 7.52316384526264e-37;
    const double k4_z_59 = (k4_z_58 != 0) ? 8.673617379884035e-19 /* 1/1152921504606846976 */ : k4_z_56;
    const double k4_z_60 = omega2_y * k4_z_51;
    const double k4_z_61 = omega2_z * k4_z_53;
    const double k4_z_62 = k4_z_60 + k4_z_61;
    const double k4_z = k4_z_62 / k4_z_59;
    const double k4_x_51 = k4_x_50 * k4_z;
    const double k4_x = omega2_x + k4_x_51;
    const double k4_y_1 = omega2_y * k4_z_53;
    const double k4_y_2 = omega2_z * k4_z_51;
    const double k4_y = k4_y_1 - k4_y_2;

    /* change = h/6 (k1 + k4) + h/3 (k2 + k3) */
    const double change_x_1 = k1_x + k4_x;
    const double change_y_1 = k1_y + k4_y;
    const double change_z_1 = k1_z + k4_z;
    const double change_x_2 = 0.0016666666666666668 /* 1/600 */ * change_x_1;
    const double change_y_2 = 0.0016666666666666668 /* 1/600 */ * change_y_1;
    const double change_z_2 = 0.0016666666666666668 /* 1/600 */ * change_z_1;
    const double change_x_3 = k2_x + k3_x;
    const double change_y_3 = k2_y + k3_y;
    const double change_z_3 = k2_z + k3_z;
    const double change_x_4 = 0.0033333333333333335 /* 1/300 */ * change_x_3;
    const double change_y_4 = 0.0033333333333333335 /* 1/300 */ * change_y_3;
    const double change_z_4 = 0.0033333333333333335 /* 1/300 */ * change_z_3;
    const double change_x = change_x_2 + change_x_4;
    const double change_y = change_y_2 + change_y_4;
    const double change_z = change_z_2 + change_z_4;

    /* rpy_next = rpy + change, each in [-pi, pi] */
    const int32_t roll_1 = 3.141592653589793 < change_x;
    const double roll_2 = (roll_1 != 0) ? 3.141592653589793 : change_x;
    const int32_t roll_3 = roll_2 < -3.141592653589793;
    const double roll_4 = (roll_3 != 0) ? -3.141592653589793 : roll_2;
    const int32_t pitch_1 = 3.141592653589793 < change_y;
    const double pitch_2 = (pitch_1 != 0) ? 3.141592653589793 : change_y;
    const int32_t pitch_3 = pitch_2 < -3.141592653589793;
    const double pitch_4 = (pitch_3 != 0) ? -3.141592653589793 : pitch_2;
    const int32_t yaw_1 = 3.141592653589793 < change_z;
    const double yaw_2 = (yaw_1 != 0) ? 3.141592653589793 : change_z;
    const int32_t yaw_3 = yaw_2 < -3.141592653589793;
    const double yaw_4 = (yaw_3 != 0) ? -3.141592653589793 : yaw_2;
    const double roll = rpy_x + roll_4;
    const double pitch = rpy_y + pitch_4;
    const double yaw = rpy_z + yaw_4;
    const int32_t rpy_next_x_1 = 3.141592653589793 < roll;
    const double rpy_next_x_2 = roll - 6.283185307179586;
    const double rpy_next_x_3 = (rpy_next_x_1 != 0) ? rpy_next_x_2 : roll;
    const int32_t rpy_next_x_4 = rpy_next_x_3 < -3.141592653589793;
    const double rpy_next_x_5 = rpy_next_x_3 + 6.283185307179586;
    const double rpy_next_x = (rpy_next_x_4 != 0) ? rpy_next_x_5 : rpy_next_x_3;
    const int32_t rpy_next_y_1 = 3.141592653589793 < pitch;
    const double rpy_next_y_2 = pitch - 6.283185307179586;
    const double rpy_next_y_3 = (rpy_next_y_1 != 0) ? rpy_next_y_2 : pitch;
    const int32_t rpy_next_y_4 = rpy_next_y_3 < -3.141592653589793;
    const double rpy_next_y_5 = rpy_next_y_3 + 6.283185307179586;
    const double rpy_next_y = (rpy_next_y_4 != 0) ? rpy_next_y_5 : rpy_next_y_3;
    const int32_t rpy_next_z_1 = 3.141592653589793 < yaw;
    const double rpy_next_z_2 = yaw - 6.283185307179586;
    const double rpy_next_z_3 = (rpy_next_z_1 != 0) ? rpy_next_z_2 : yaw;
    const int32_t rpy_next_z_4 = rpy_next_z_3 < -3.141592653589793;
    const double rpy_next_z_5 = rpy_next_z_3 + 6.283185307179586;
    const double rpy_next_z = (rpy_next_z_4 != 0) ? rpy_next_z_5 : rpy_next_z_3;

    /* store */
    state->rpy[0] = rpy_next_x;
    state->rpy[1] = rpy_next_y;
    state->rpy[2] = rpy_next_z;
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void euler_angles_float64_quaternion(const euler_angles_float64_state *state, double q_nb[4])
{
    /* rpy, read once */
    const double rpy_x = state->rpy[0];
    const double rpy_y = state->rpy[1];
    const double rpy_z = state->rpy[2];

    /* q_nb = quaternion of roll, pitch, yaw (zyx) */
    const double q_nb_w_1 = 0.5 * rpy_x;
    const double q_nb_w_2 = 0.5 * rpy_y;
    const double q_nb_w_3 = 0.5 * rpy_z;
    const int32_t q_nb_w_4 = 3.141592653589793 < q_nb_w_1;
    const double q_nb_w_5 = q_nb_w_1 - 6.283185307179586;
    const double q_nb_w_6 = (q_nb_w_4 != 0) ? q_nb_w_5 : q_nb_w_1;
    const int32_t q_nb_w_7 = q_nb_w_6 < -3.141592653589793;
    const double q_nb_w_8 = q_nb_w_6 + 6.283185307179586;
    const double q_nb_w_9 = (q_nb_w_7 != 0) ? q_nb_w_8 : q_nb_w_6;
    const int32_t q_nb_w_10 = q_nb_w_9 < 0.0;
    const double q_nb_w_11 = -q_nb_w_9;
    const double q_nb_w_12 = (q_nb_w_10 != 0) ? q_nb_w_11 : q_nb_w_9;
    const int32_t q_nb_w_13 = 1.5707963267948966 < q_nb_w_12;
    const double q_nb_w_14 = 3.141592653589793 - q_nb_w_12;
    const double q_nb_w_15 = (q_nb_w_13 != 0) ? q_nb_w_14 : q_nb_w_12;
    const int32_t q_nb_w_16 = 0.7853981633974483 < q_nb_w_15;
    const double q_nb_w_17 = 1.5707963267948966 - q_nb_w_15;
    const double q_nb_w_18 = (q_nb_w_16 != 0) ? q_nb_w_17 : q_nb_w_15;
    const double q_nb_w_19 = q_nb_w_18 * q_nb_w_18;
    const double q_nb_w_20 = q_nb_w_19 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double q_nb_w_21 = -2.5050600311467533e-08 /* -28/1117737685 */ + q_nb_w_20;
    const double q_nb_w_22 = q_nb_w_19 * q_nb_w_21;
    const double q_nb_w_23 = 2.755731254530188e-06 /* 1933/701447210 */ + q_nb_w_22;
    const double q_nb_w_24 = q_nb_w_19 * q_nb_w_23;
    const double q_nb_w_25 = -0.00019841269825935837 /* -256734/1293939361 */ + q_nb_w_24;
    const double q_nb_w_26 = q_nb_w_19 * q_nb_w_25;
    const double q_nb_w_27 = 0.008333333333316484 /* 4121483234/494577988081 */ + q_nb_w_26;
    const double q_nb_w_28 = q_nb_w_19 * q_nb_w_27;
    const double q_nb_w_29 = -0.166666666666666 /* -41891153280974/251346919685845 */ + q_nb_w_28;
    const double q_nb_w_30 = q_nb_w_19 * q_nb_w_29;
    const double q_nb_w_31 = q_nb_w_18 * q_nb_w_30;
    const double q_nb_w_32 = q_nb_w_18 + q_nb_w_31;
    const double q_nb_w_33 = q_nb_w_19 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double q_nb_w_34 = -2.755529690519287e-07 /* -121/439117025 */ + q_nb_w_33;
    const double q_nb_w_35 = q_nb_w_19 * q_nb_w_34;
    const double q_nb_w_36 = 2.4801579019900845e-05 /* 37063/1494380659 */ + q_nb_w_35;
    const double q_nb_w_37 = q_nb_w_19 * q_nb_w_36;
    const double q_nb_w_38 = -0.0013888888871736989 /* -1124664/809758081 */ + q_nb_w_37;
    const double q_nb_w_39 = q_nb_w_19 * q_nb_w_38;
    const double q_nb_w_40 = 0.04166666666650333 /* 10628826118/255091826833 */ + q_nb_w_39;
    const double q_nb_w_41 = q_nb_w_19 * q_nb_w_40;
    const double q_nb_w_42 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + q_nb_w_41;
    const double q_nb_w_43 = q_nb_w_19 * q_nb_w_42;
    const double q_nb_w_44 = 1.0 + q_nb_w_43;
    const double q_nb_w_45 = (q_nb_w_16 != 0) ? q_nb_w_44 : q_nb_w_32;
    const double q_nb_w_46 = (q_nb_w_16 != 0) ? q_nb_w_32 : q_nb_w_44;
    const double q_nb_w_47 = -q_nb_w_45;
    const double q_nb_w_48 = (q_nb_w_10 != 0) ? q_nb_w_47 : q_nb_w_45;
    const double q_nb_w_49 = -q_nb_w_46;
    const double q_nb_w_50 = (q_nb_w_13 != 0) ? q_nb_w_49 : q_nb_w_46;
    const int32_t q_nb_w_51 = 3.141592653589793 < q_nb_w_2;
    const double q_nb_w_52 = q_nb_w_2 - 6.283185307179586;
    const double q_nb_w_53 = (q_nb_w_51 != 0) ? q_nb_w_52 : q_nb_w_2;
    const int32_t q_nb_w_54 = q_nb_w_53 < -3.141592653589793;
    const double q_nb_w_55 = q_nb_w_53 + 6.283185307179586;
    const double q_nb_w_56 = (q_nb_w_54 != 0) ? q_nb_w_55 : q_nb_w_53;
    const int32_t q_nb_w_57 = q_nb_w_56 < 0.0;
    const double q_nb_w_58 = -q_nb_w_56;
    const double q_nb_w_59 = (q_nb_w_57 != 0) ? q_nb_w_58 : q_nb_w_56;
    const int32_t q_nb_w_60 = 1.5707963267948966 < q_nb_w_59;
    const double q_nb_w_61 = 3.141592653589793 - q_nb_w_59;
    const double q_nb_w_62 = (q_nb_w_60 != 0) ? q_nb_w_61 : q_nb_w_59;
    const int32_t q_nb_w_63 = 0.7853981633974483 < q_nb_w_62;
    const double q_nb_w_64 = 1.5707963267948966 - q_nb_w_62;
    const double q_nb_w_65 = (q_nb_w_63 != 0) ? q_nb_w_64 : q_nb_w_62;
    const double q_nb_w_66 = q_nb_w_65 * q_nb_w_65;
    const double q_nb_w_67 = q_nb_w_66 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double q_nb_w_68 = -2.5050600311467533e-08 /* -28/1117737685 */ + q_nb_w_67;
    const double q_nb_w_69 = q_nb_w_66 * q_nb_w_68;
    const double q_nb_w_70 = 2.755731254530188e-06 /* 1933/701447210 */ + q_nb_w_69;
    const double q_nb_w_71 = q_nb_w_66 * q_nb_w_70;
    const double q_nb_w_72 = -0.00019841269825935837 /* -256734/1293939361 */ + q_nb_w_71;
    const double q_nb_w_73 = q_nb_w_66 * q_nb_w_72;
    const double q_nb_w_74 = 0.008333333333316484 /* 4121483234/494577988081 */ + q_nb_w_73;
    const double q_nb_w_75 = q_nb_w_66 * q_nb_w_74;
    const double q_nb_w_76 = -0.166666666666666 /* -41891153280974/251346919685845 */ + q_nb_w_75;
    const double q_nb_w_77 = q_nb_w_66 * q_nb_w_76;
    const double q_nb_w_78 = q_nb_w_65 * q_nb_w_77;
    const double q_nb_w_79 = q_nb_w_65 + q_nb_w_78;
    const double q_nb_w_80 = q_nb_w_66 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double q_nb_w_81 = -2.755529690519287e-07 /* -121/439117025 */ + q_nb_w_80;
    const double q_nb_w_82 = q_nb_w_66 * q_nb_w_81;
    const double q_nb_w_83 = 2.4801579019900845e-05 /* 37063/1494380659 */ + q_nb_w_82;
    const double q_nb_w_84 = q_nb_w_66 * q_nb_w_83;
    const double q_nb_w_85 = -0.0013888888871736989 /* -1124664/809758081 */ + q_nb_w_84;
    const double q_nb_w_86 = q_nb_w_66 * q_nb_w_85;
    const double q_nb_w_87 = 0.04166666666650333 /* 10628826118/255091826833 */ + q_nb_w_86;
    const double q_nb_w_88 = q_nb_w_66 * q_nb_w_87;
    const double q_nb_w_89 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + q_nb_w_88;
    const double q_nb_w_90 = q_nb_w_66 * q_nb_w_89;
    const double q_nb_w_91 = 1.0 + q_nb_w_90;
    const double q_nb_w_92 = (q_nb_w_63 != 0) ? q_nb_w_91 : q_nb_w_79;
    const double q_nb_w_93 = (q_nb_w_63 != 0) ? q_nb_w_79 : q_nb_w_91;
    const double q_nb_w_94 = -q_nb_w_92;
    const double q_nb_w_95 = (q_nb_w_57 != 0) ? q_nb_w_94 : q_nb_w_92;
    const double q_nb_w_96 = -q_nb_w_93;
    const double q_nb_w_97 = (q_nb_w_60 != 0) ? q_nb_w_96 : q_nb_w_93;
    const int32_t q_nb_w_98 = 3.141592653589793 < q_nb_w_3;
    const double q_nb_w_99 = q_nb_w_3 - 6.283185307179586;
    const double q_nb_w_100 = (q_nb_w_98 != 0) ? q_nb_w_99 : q_nb_w_3;
    const int32_t q_nb_w_101 = q_nb_w_100 < -3.141592653589793;
    const double q_nb_w_102 = q_nb_w_100 + 6.283185307179586;
    const double q_nb_w_103 = (q_nb_w_101 != 0) ? q_nb_w_102 : q_nb_w_100;
    const int32_t q_nb_w_104 = q_nb_w_103 < 0.0;
    const double q_nb_w_105 = -q_nb_w_103;
    const double q_nb_w_106 = (q_nb_w_104 != 0) ? q_nb_w_105 : q_nb_w_103;
    const int32_t q_nb_w_107 = 1.5707963267948966 < q_nb_w_106;
    const double q_nb_w_108 = 3.141592653589793 - q_nb_w_106;
    const double q_nb_w_109 = (q_nb_w_107 != 0) ? q_nb_w_108 : q_nb_w_106;
    const int32_t q_nb_w_110 = 0.7853981633974483 < q_nb_w_109;
    const double q_nb_w_111 = 1.5707963267948966 - q_nb_w_109;
    const double q_nb_w_112 = (q_nb_w_110 != 0) ? q_nb_w_111 : q_nb_w_109;
    const double q_nb_w_113 = q_nb_w_112 * q_nb_w_112;
    const double q_nb_w_114 = q_nb_w_113 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double q_nb_w_115 = -2.5050600311467533e-08 /* -28/1117737685 */ + q_nb_w_114;
    const double q_nb_w_116 = q_nb_w_113 * q_nb_w_115;
    const double q_nb_w_117 = 2.755731254530188e-06 /* 1933/701447210 */ + q_nb_w_116;
    const double q_nb_w_118 = q_nb_w_113 * q_nb_w_117;
    const double q_nb_w_119 = -0.00019841269825935837 /* -256734/1293939361 */ + q_nb_w_118;
    const double q_nb_w_120 = q_nb_w_113 * q_nb_w_119;
    const double q_nb_w_121 = 0.008333333333316484 /* 4121483234/494577988081 */ + q_nb_w_120;
    const double q_nb_w_122 = q_nb_w_113 * q_nb_w_121;
    const double q_nb_w_123 = -0.166666666666666 /* -41891153280974/251346919685845 */ + q_nb_w_122;
    const double q_nb_w_124 = q_nb_w_113 * q_nb_w_123;
    const double q_nb_w_125 = q_nb_w_112 * q_nb_w_124;
    const double q_nb_w_126 = q_nb_w_112 + q_nb_w_125;
    const double q_nb_w_127 = q_nb_w_113 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double q_nb_w_128 = -2.755529690519287e-07 /* -121/439117025 */ + q_nb_w_127;
    const double q_nb_w_129 = q_nb_w_113 * q_nb_w_128;
    const double q_nb_w_130 = 2.4801579019900845e-05 /* 37063/1494380659 */ + q_nb_w_129;
    const double q_nb_w_131 = q_nb_w_113 * q_nb_w_130;
    const double q_nb_w_132 = -0.0013888888871736989 /* -1124664/809758081 */ + q_nb_w_131;
    const double q_nb_w_133 = q_nb_w_113 * q_nb_w_132;
    const double q_nb_w_134 = 0.04166666666650333 /* 10628826118/255091826833 */ + q_nb_w_133;
    const double q_nb_w_135 = q_nb_w_113 * q_nb_w_134;
    const double q_nb_w_136 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + q_nb_w_135;
    const double q_nb_w_137 = q_nb_w_113 * q_nb_w_136;
    const double q_nb_w_138 = 1.0 + q_nb_w_137;
    const double q_nb_w_139 = (q_nb_w_110 != 0) ? q_nb_w_138 : q_nb_w_126;
    const double q_nb_w_140 = (q_nb_w_110 != 0) ? q_nb_w_126 : q_nb_w_138;
    const double q_nb_w_141 = -q_nb_w_139;
    const double q_nb_w_142 = (q_nb_w_104 != 0) ? q_nb_w_141 : q_nb_w_139;
    const double q_nb_w_143 = -q_nb_w_140;
    const double q_nb_w_144 = (q_nb_w_107 != 0) ? q_nb_w_143 : q_nb_w_140;
    const double q_nb_w_145 = q_nb_w_144 * q_nb_w_97;
    const double q_nb_w_146 = q_nb_w_145 * q_nb_w_50;
    const double q_nb_w_147 = q_nb_w_142 * q_nb_w_95;
    const double q_nb_w_148 = q_nb_w_147 * q_nb_w_48;
    const double q_nb_w = q_nb_w_146 + q_nb_w_148;
    const double q_nb_x_1 = q_nb_w_145 * q_nb_w_48;
    const double q_nb_x_2 = q_nb_w_147 * q_nb_w_50;
    const double q_nb_x = q_nb_x_1 - q_nb_x_2;
    const double q_nb_y_1 = q_nb_w_144 * q_nb_w_95;
    const double q_nb_y_2 = q_nb_y_1 * q_nb_w_50;
    const double q_nb_y_3 = q_nb_w_142 * q_nb_w_97;
    const double q_nb_y_4 = q_nb_y_3 * q_nb_w_48;
    const double q_nb_y = q_nb_y_2 + q_nb_y_4;
    const double q_nb_z_1 = q_nb_y_3 * q_nb_w_50;
    const double q_nb_z_2 = q_nb_y_1 * q_nb_w_48;
    const double q_nb_z = q_nb_z_1 - q_nb_z_2;

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void euler_angles_float64_dcm(const euler_angles_float64_state *state, double c_nb[9])
{
    /* rpy, read once */
    const double rpy_x = state->rpy[0];
    const double rpy_y = state->rpy[1];
    const double rpy_z = state->rpy[2];

    /* q_nb = quaternion of roll, pitch, yaw (zyx) */
    const double q_nb_w_1 = 0.5 * rpy_x;
    const double q_nb_w_2 = 0.5 * rpy_y;
    const double q_nb_w_3 = 0.5 * rpy_z;
    const int32_t q_nb_w_4 = 3.141592653589793 < q_nb_w_1;
    const double q_nb_w_5 = q_nb_w_1 - 6.283185307179586;
    const double q_nb_w_6 = (q_nb_w_4 != 0) ? q_nb_w_5 : q_nb_w_1;
    const int32_t q_nb_w_7 = q_nb_w_6 < -3.141592653589793;
    const double q_nb_w_8 = q_nb_w_6 + 6.283185307179586;
    const double q_nb_w_9 = (q_nb_w_7 != 0) ? q_nb_w_8 : q_nb_w_6;
    const int32_t q_nb_w_10 = q_nb_w_9 < 0.0;
    const double q_nb_w_11 = -q_nb_w_9;
    const double q_nb_w_12 = (q_nb_w_10 != 0) ? q_nb_w_11 : q_nb_w_9;
    const int32_t q_nb_w_13 = 1.5707963267948966 < q_nb_w_12;
    const double q_nb_w_14 = 3.141592653589793 - q_nb_w_12;
    const double q_nb_w_15 = (q_nb_w_13 != 0) ? q_nb_w_14 : q_nb_w_12;
    const int32_t q_nb_w_16 = 0.7853981633974483 < q_nb_w_15;
    const double q_nb_w_17 = 1.5707963267948966 - q_nb_w_15;
    const double q_nb_w_18 = (q_nb_w_16 != 0) ? q_nb_w_17 : q_nb_w_15;
    const double q_nb_w_19 = q_nb_w_18 * q_nb_w_18;
    const double q_nb_w_20 = q_nb_w_19 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double q_nb_w_21 = -2.5050600311467533e-08 /* -28/1117737685 */ + q_nb_w_20;
    const double q_nb_w_22 = q_nb_w_19 * q_nb_w_21;
    const double q_nb_w_23 = 2.755731254530188e-06 /* 1933/701447210 */ + q_nb_w_22;
    const double q_nb_w_24 = q_nb_w_19 * q_nb_w_23;
    const double q_nb_w_25 = -0.00019841269825935837 /* -256734/1293939361 */ + q_nb_w_24;
    const double q_nb_w_26 = q_nb_w_19 * q_nb_w_25;
    const double q_nb_w_27 = 0.008333333333316484 /* 4121483234/494577988081 */ + q_nb_w_26;
    const double q_nb_w_28 = q_nb_w_19 * q_nb_w_27;
    const double q_nb_w_29 = -0.166666666666666 /* -41891153280974/251346919685845 */ + q_nb_w_28;
    const double q_nb_w_30 = q_nb_w_19 * q_nb_w_29;
    const double q_nb_w_31 = q_nb_w_18 * q_nb_w_30;
    const double q_nb_w_32 = q_nb_w_18 + q_nb_w_31;
    const double q_nb_w_33 = q_nb_w_19 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double q_nb_w_34 = -2.755529690519287e-07 /* -121/439117025 */ + q_nb_w_33;
    const double q_nb_w_35 = q_nb_w_19 * q_nb_w_34;
    const double q_nb_w_36 = 2.4801579019900845e-05 /* 37063/1494380659 */ + q_nb_w_35;
    const double q_nb_w_37 = q_nb_w_19 * q_nb_w_36;
    const double q_nb_w_38 = -0.0013888888871736989 /* -1124664/809758081 */ + q_nb_w_37;
    const double q_nb_w_39 = q_nb_w_19 * q_nb_w_38;
    const double q_nb_w_40 = 0.04166666666650333 /* 10628826118/255091826833 */ + q_nb_w_39;
    const double q_nb_w_41 = q_nb_w_19 * q_nb_w_40;
    const double q_nb_w_42 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + q_nb_w_41;
    const double q_nb_w_43 = q_nb_w_19 * q_nb_w_42;
    const double q_nb_w_44 = 1.0 + q_nb_w_43;
    const double q_nb_w_45 = (q_nb_w_16 != 0) ? q_nb_w_44 : q_nb_w_32;
    const double q_nb_w_46 = (q_nb_w_16 != 0) ? q_nb_w_32 : q_nb_w_44;
    const double q_nb_w_47 = -q_nb_w_45;
    const double q_nb_w_48 = (q_nb_w_10 != 0) ? q_nb_w_47 : q_nb_w_45;
    const double q_nb_w_49 = -q_nb_w_46;
    const double q_nb_w_50 = (q_nb_w_13 != 0) ? q_nb_w_49 : q_nb_w_46;
    const int32_t q_nb_w_51 = 3.141592653589793 < q_nb_w_2;
    const double q_nb_w_52 = q_nb_w_2 - 6.283185307179586;
    const double q_nb_w_53 = (q_nb_w_51 != 0) ? q_nb_w_52 : q_nb_w_2;
    const int32_t q_nb_w_54 = q_nb_w_53 < -3.141592653589793;
    const double q_nb_w_55 = q_nb_w_53 + 6.283185307179586;
    const double q_nb_w_56 = (q_nb_w_54 != 0) ? q_nb_w_55 : q_nb_w_53;
    const int32_t q_nb_w_57 = q_nb_w_56 < 0.0;
    const double q_nb_w_58 = -q_nb_w_56;
    const double q_nb_w_59 = (q_nb_w_57 != 0) ? q_nb_w_58 : q_nb_w_56;
    const int32_t q_nb_w_60 = 1.5707963267948966 < q_nb_w_59;
    const double q_nb_w_61 = 3.141592653589793 - q_nb_w_59;
    const double q_nb_w_62 = (q_nb_w_60 != 0) ? q_nb_w_61 : q_nb_w_59;
    const int32_t q_nb_w_63 = 0.7853981633974483 < q_nb_w_62;
    const double q_nb_w_64 = 1.5707963267948966 - q_nb_w_62;
    const double q_nb_w_65 = (q_nb_w_63 != 0) ? q_nb_w_64 : q_nb_w_62;
    const double q_nb_w_66 = q_nb_w_65 * q_nb_w_65;
    const double q_nb_w_67 = q_nb_w_66 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double q_nb_w_68 = -2.5050600311467533e-08 /* -28/1117737685 */ + q_nb_w_67;
    const double q_nb_w_69 = q_nb_w_66 * q_nb_w_68;
    const double q_nb_w_70 = 2.755731254530188e-06 /* 1933/701447210 */ + q_nb_w_69;
    const double q_nb_w_71 = q_nb_w_66 * q_nb_w_70;
    const double q_nb_w_72 = -0.00019841269825935837 /* -256734/1293939361 */ + q_nb_w_71;
    const double q_nb_w_73 = q_nb_w_66 * q_nb_w_72;
    const double q_nb_w_74 = 0.008333333333316484 /* 4121483234/494577988081 */ + q_nb_w_73;
    const double q_nb_w_75 = q_nb_w_66 * q_nb_w_74;
    const double q_nb_w_76 = -0.166666666666666 /* -41891153280974/251346919685845 */ + q_nb_w_75;
    const double q_nb_w_77 = q_nb_w_66 * q_nb_w_76;
    const double q_nb_w_78 = q_nb_w_65 * q_nb_w_77;
    const double q_nb_w_79 = q_nb_w_65 + q_nb_w_78;
    const double q_nb_w_80 = q_nb_w_66 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double q_nb_w_81 = -2.755529690519287e-07 /* -121/439117025 */ + q_nb_w_80;
    const double q_nb_w_82 = q_nb_w_66 * q_nb_w_81;
    const double q_nb_w_83 = 2.4801579019900845e-05 /* 37063/1494380659 */ + q_nb_w_82;
    const double q_nb_w_84 = q_nb_w_66 * q_nb_w_83;
    const double q_nb_w_85 = -0.0013888888871736989 /* -1124664/809758081 */ + q_nb_w_84;
    const double q_nb_w_86 = q_nb_w_66 * q_nb_w_85;
    const double q_nb_w_87 = 0.04166666666650333 /* 10628826118/255091826833 */ + q_nb_w_86;
    const double q_nb_w_88 = q_nb_w_66 * q_nb_w_87;
    const double q_nb_w_89 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + q_nb_w_88;
    const double q_nb_w_90 = q_nb_w_66 * q_nb_w_89;
    const double q_nb_w_91 = 1.0 + q_nb_w_90;
    const double q_nb_w_92 = (q_nb_w_63 != 0) ? q_nb_w_91 : q_nb_w_79;
    const double q_nb_w_93 = (q_nb_w_63 != 0) ? q_nb_w_79 : q_nb_w_91;
    const double q_nb_w_94 = -q_nb_w_92;
    const double q_nb_w_95 = (q_nb_w_57 != 0) ? q_nb_w_94 : q_nb_w_92;
    const double q_nb_w_96 = -q_nb_w_93;
    const double q_nb_w_97 = (q_nb_w_60 != 0) ? q_nb_w_96 : q_nb_w_93;
    const int32_t q_nb_w_98 = 3.141592653589793 < q_nb_w_3;
    const double q_nb_w_99 = q_nb_w_3 - 6.283185307179586;
    const double q_nb_w_100 = (q_nb_w_98 != 0) ? q_nb_w_99 : q_nb_w_3;
    const int32_t q_nb_w_101 = q_nb_w_100 < -3.141592653589793;
    const double q_nb_w_102 = q_nb_w_100 + 6.283185307179586;
    const double q_nb_w_103 = (q_nb_w_101 != 0) ? q_nb_w_102 : q_nb_w_100;
    const int32_t q_nb_w_104 = q_nb_w_103 < 0.0;
    const double q_nb_w_105 = -q_nb_w_103;
    const double q_nb_w_106 = (q_nb_w_104 != 0) ? q_nb_w_105 : q_nb_w_103;
    const int32_t q_nb_w_107 = 1.5707963267948966 < q_nb_w_106;
    const double q_nb_w_108 = 3.141592653589793 - q_nb_w_106;
    const double q_nb_w_109 = (q_nb_w_107 != 0) ? q_nb_w_108 : q_nb_w_106;
    const int32_t q_nb_w_110 = 0.7853981633974483 < q_nb_w_109;
    const double q_nb_w_111 = 1.5707963267948966 - q_nb_w_109;
    const double q_nb_w_112 = (q_nb_w_110 != 0) ? q_nb_w_111 : q_nb_w_109;
    const double q_nb_w_113 = q_nb_w_112 * q_nb_w_112;
    const double q_nb_w_114 = q_nb_w_113 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double q_nb_w_115 = -2.5050600311467533e-08 /* -28/1117737685 */ + q_nb_w_114;
    const double q_nb_w_116 = q_nb_w_113 * q_nb_w_115;
    const double q_nb_w_117 = 2.755731254530188e-06 /* 1933/701447210 */ + q_nb_w_116;
    const double q_nb_w_118 = q_nb_w_113 * q_nb_w_117;
    const double q_nb_w_119 = -0.00019841269825935837 /* -256734/1293939361 */ + q_nb_w_118;
    const double q_nb_w_120 = q_nb_w_113 * q_nb_w_119;
    const double q_nb_w_121 = 0.008333333333316484 /* 4121483234/494577988081 */ + q_nb_w_120;
    const double q_nb_w_122 = q_nb_w_113 * q_nb_w_121;
    const double q_nb_w_123 = -0.166666666666666 /* -41891153280974/251346919685845 */ + q_nb_w_122;
    const double q_nb_w_124 = q_nb_w_113 * q_nb_w_123;
    const double q_nb_w_125 = q_nb_w_112 * q_nb_w_124;
    const double q_nb_w_126 = q_nb_w_112 + q_nb_w_125;
    const double q_nb_w_127 = q_nb_w_113 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double q_nb_w_128 = -2.755529690519287e-07 /* -121/439117025 */ + q_nb_w_127;
    const double q_nb_w_129 = q_nb_w_113 * q_nb_w_128;
    const double q_nb_w_130 = 2.4801579019900845e-05 /* 37063/1494380659 */ + q_nb_w_129;
    const double q_nb_w_131 = q_nb_w_113 * q_nb_w_130;
    const double q_nb_w_132 = -0.0013888888871736989 /* -1124664/809758081 */ + q_nb_w_131;
    const double q_nb_w_133 = q_nb_w_113 * q_nb_w_132;
    const double q_nb_w_134 = 0.04166666666650333 /* 10628826118/255091826833 */ + q_nb_w_133;
    const double q_nb_w_135 = q_nb_w_113 * q_nb_w_134;
    const double q_nb_w_136 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + q_nb_w_135;
    const double q_nb_w_137 = q_nb_w_113 * q_nb_w_136;
    const double q_nb_w_138 = 1.0 + q_nb_w_137;
    const double q_nb_w_139 = (q_nb_w_110 != 0) ? q_nb_w_138 : q_nb_w_126;
    const double q_nb_w_140 = (q_nb_w_110 != 0) ? q_nb_w_126 : q_nb_w_138;
    const double q_nb_w_141 = -q_nb_w_139;
    const double q_nb_w_142 = (q_nb_w_104 != 0) ? q_nb_w_141 : q_nb_w_139;
    const double q_nb_w_143 = -q_nb_w_140;
    const double q_nb_w_144 = (q_nb_w_107 != 0) ? q_nb_w_143 : q_nb_w_140;
    const double q_nb_w_145 = q_nb_w_144 * q_nb_w_97;
    const double q_nb_w_146 = q_nb_w_145 * q_nb_w_50;
    const double q_nb_w_147 = q_nb_w_142 * q_nb_w_95;
    const double q_nb_w_148 = q_nb_w_147 * q_nb_w_48;
    const double q_nb_w = q_nb_w_146 + q_nb_w_148;
    const double q_nb_x_1 = q_nb_w_145 * q_nb_w_48;
    const double q_nb_x_2 = q_nb_w_147 * q_nb_w_50;
    const double q_nb_x = q_nb_x_1 - q_nb_x_2;
    const double q_nb_y_1 = q_nb_w_144 * q_nb_w_95;
    const double q_nb_y_2 = q_nb_y_1 * q_nb_w_50;
    const double q_nb_y_3 = q_nb_w_142 * q_nb_w_97;
    const double q_nb_y_4 = q_nb_y_3 * q_nb_w_48;
    const double q_nb_y = q_nb_y_2 + q_nb_y_4;
    const double q_nb_z_1 = q_nb_y_3 * q_nb_w_50;
    const double q_nb_z_2 = q_nb_y_1 * q_nb_w_48;
    const double q_nb_z = q_nb_z_1 - q_nb_z_2;

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const double x2 = q_nb_x + q_nb_x;
    const double y2 = q_nb_y + q_nb_y;
    const double z2 = q_nb_z + q_nb_z;
    const double wx = q_nb_w * x2;
    const double wy = q_nb_w * y2;
    const double wz = q_nb_w * z2;
    const double xx = q_nb_x * x2;
    const double xy = q_nb_x * y2;
    const double xz = q_nb_x * z2;
    const double yy = q_nb_y * y2;
    const double yz = q_nb_y * z2;
    const double zz = q_nb_z * z2;

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

void euler_angles_float64_euler(const euler_angles_float64_state *state, double angles[3])
{
    /* rpy, read once */
    const double rpy_x = state->rpy[0];
    const double rpy_y = state->rpy[1];
    const double rpy_z = state->rpy[2];

    angles[0] = rpy_x;
    angles[1] = rpy_y;
    angles[2] = rpy_z;
}
