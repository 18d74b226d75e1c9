/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_euler_zyx_float32
 *
 * qcone 0.1.0, design rotation_vector_3_coning_euler_zyx_float32, SHA-256 of the design
 * dcd8b71f445bcf3f97840fc0ab24d086db674f46104a2fb850a14f923a601287
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              1.1e-12 (scalar), 3.8e-10 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       39       0   33        13       0       0     0     0     0       0
 * update shared           38       1   33        13       0       0     0     0     0       0
 * update emitted          38       1   33        13       0       0     0     0     0       0
 * euler as-written        56       0   32        17      10       4     0     0    26      55
 * euler shared            37      18   32        17       9       4     0     0    26      55
 * euler emitted           37      18   32        17       9       4     0     0    26      55
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_euler_zyx_float32.h"

#if ROTATION_VECTOR_3_CONING_EULER_ZYX_FLOAT32_VERSION != 1
#error "rotation_vector_3_coning_euler_zyx_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_3_coning_euler_zyx_float32_init(
    rotation_vector_3_coning_euler_zyx_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
}

void rotation_vector_3_coning_euler_zyx_float32_set_quaternion(
    rotation_vector_3_coning_euler_zyx_float32_state *state, const float q_nb[4])
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

void rotation_vector_3_coning_euler_zyx_float32_update(
    rotation_vector_3_coning_euler_zyx_float32_state *state, const float dtheta[9])
{
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

    /* p = theta_1 + theta_3 */
    const float p_x = dtheta1_x + dtheta3_x;
    const float p_y = dtheta1_y + dtheta3_y;
    const float p_z = dtheta1_z + dtheta3_z;

    /* d = theta_3 - theta_1 */
    const float d_x = dtheta3_x - dtheta1_x;
    const float d_y = dtheta3_y - dtheta1_y;
    const float d_z = dtheta3_z - dtheta1_z;

    /* S = p + theta_2 */
    const float S_x = p_x + dtheta2_x;
    const float S_y = p_y + dtheta2_y;
    const float S_z = p_z + dtheta2_z;

    /* g = S + 2 theta_2   [cao (12)] */
    const float g_x_1 = S_x + dtheta2_x;
    const float g_y_1 = S_y + dtheta2_y;
    const float g_z_1 = S_z + dtheta2_z;
    const float g_x = g_x_1 + dtheta2_x;
    const float g_y = g_y_1 + dtheta2_y;
    const float g_z = g_z_1 + dtheta2_z;

    /* k = 9/40 d   [cao (12)] */
    const float k_x = 0.225F /* 9/40 */ * d_x;
    const float k_y = 0.225F /* 9/40 */ * d_y;
    const float k_z = 0.225F /* 9/40 */ * d_z;

    /* coning = g x k   [cao (12)] */
    const float coning_x_1 = g_y * k_z;
    const float coning_x_2 = g_z * k_y;
    const float coning_x = coning_x_1 - coning_x_2;
    const float coning_y_1 = g_z * k_x;
    const float coning_y_2 = g_x * k_z;
    const float coning_y = coning_y_1 - coning_y_2;
    const float coning_z_1 = g_x * k_y;
    const float coning_z_2 = g_y * k_x;
    const float coning_z = coning_z_1 - coning_z_2;

    /* phi = S + coning   [cao (12)] */
    const float phi_x = S_x + coning_x;
    const float phi_y = S_y + coning_y;
    const float phi_z = S_z + coning_z;

    /* phi_square = |phi|^2 */
    const float phi_square_1 = phi_x * phi_x;
    const float phi_square_2 = phi_y * phi_y;
    const float phi_square_3 = phi_z * phi_z;
    const float phi_square_4 = phi_square_1 + phi_square_2;
    const float phi_square = phi_square_4 + phi_square_3;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const float u_1 = phi_square * 0.0026038513F /* 43/16514 */;
    const float u_2 = -0.125F /* -15058244/120465953 */ + u_1;
    const float u = phi_square * u_2;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const float s_1 = phi_square * -0.020830961F /* -183/8785 */;
    const float s = 0.5F + s_1;

    /* v = s phi   [cao (14)] */
    const float v_x = s * phi_x;
    const float v_y = s * phi_y;
    const float v_z = s * phi_z;

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

void rotation_vector_3_coning_euler_zyx_float32_quaternion(
    const rotation_vector_3_coning_euler_zyx_float32_state *state, float q_nb[4])
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

void rotation_vector_3_coning_euler_zyx_float32_euler(
    const rotation_vector_3_coning_euler_zyx_float32_state *state, float rpy[3])
{
    /* q, read once */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];

    /* half_sum = (yaw + roll)/2   [zyx] */
    const float half_sum_1 = q_z + q_x;
    const float half_sum_2 = q_w - q_y;
    const float half_difference_1 = q_z - q_x;
    const float half_difference_2 = q_w + q_y;
    const int32_t half_sum_3 = half_sum_1 < 0.0F;
    const float half_sum_4 = -half_sum_1;
    const float half_sum_5 = (half_sum_3 != 0) ? half_sum_4 : half_sum_1;
    const int32_t half_sum_6 = half_sum_2 < 0.0F;
    const float half_sum_7 = -half_sum_2;
    const float half_sum_8 = (half_sum_6 != 0) ? half_sum_7 : half_sum_2;
    const int32_t half_sum_9 = half_sum_8 < half_sum_5;
    const float half_sum_10 = (half_sum_9 != 0) ? half_sum_8 : half_sum_5;
    const float half_sum_11 = (half_sum_9 != 0) ? half_sum_5 : half_sum_8;
    const float half_sum_12 = 0.41421357F /* 10355339/25000000 */ * half_sum_11;
    const int32_t half_sum_13 = half_sum_12 < half_sum_10;
    const float half_sum_14 = half_sum_10 - half_sum_11;
    const float half_sum_15 = (half_sum_13 != 0) ? half_sum_14 : half_sum_10;
    const float half_sum_16 = half_sum_10 + half_sum_11;
    const float half_sum_17 = (half_sum_13 != 0) ? half_sum_16 : half_sum_11;
    const float half_sum_18 = 7.523164e-37F * half_sum_11;
    const int32_t half_sum_19 = half_sum_18 < half_sum_10;
    const float half_sum_20 = (half_sum_19 != 0) ? half_sum_15 : 0.0F;
    const float half_sum_21 = (half_sum_19 != 0) ? half_sum_17 : 1.0F;
    const float half_sum_22 = half_sum_20 / half_sum_21;
    const float half_sum_23 = half_sum_22 * half_sum_22;
    const float half_sum_24 = half_sum_23 * 0.07901622F /* 151/1911 */;
    const float half_sum_25 = -0.13824141F /* -599/4333 */ + half_sum_24;
    const float half_sum_26 = half_sum_23 * half_sum_25;
    const float half_sum_27 = 0.1997185F /* 1419/7105 */ + half_sum_26;
    const float half_sum_28 = half_sum_23 * half_sum_27;
    const float half_sum_29 = -0.33332756F /* -19236/57709 */ + half_sum_28;
    const float half_sum_30 = half_sum_23 * half_sum_29;
    const float half_sum_31 = half_sum_22 * half_sum_30;
    const float half_sum_32 = half_sum_22 + half_sum_31;
    const float half_sum_33 = 0.7853982F + half_sum_32;
    const float half_sum_34 = (half_sum_13 != 0) ? half_sum_33 : half_sum_32;
    const float half_sum_35 = 1.5707964F - half_sum_34;
    const float half_sum_36 = (half_sum_9 != 0) ? half_sum_35 : half_sum_34;
    const float half_sum_37 = 3.1415927F - half_sum_36;
    const float half_sum_38 = (half_sum_6 != 0) ? half_sum_37 : half_sum_36;
    const float half_sum_39 = -half_sum_38;
    const float half_sum = (half_sum_3 != 0) ? half_sum_39 : half_sum_38;

    /* half_difference = (yaw - roll)/2   [zyx] */
    const int32_t half_difference_3 = half_difference_1 < 0.0F;
    const float half_difference_4 = -half_difference_1;
    const float half_difference_5 = (half_difference_3 != 0) ? half_difference_4 : half_difference_1;
    const int32_t half_difference_6 = half_difference_2 < 0.0F;
    const float half_difference_7 = -half_difference_2;
    const float half_difference_8 = (half_difference_6 != 0) ? half_difference_7 : half_difference_2;
    const int32_t half_difference_9 = half_difference_8 < half_difference_5;
    const float half_difference_10 = (half_difference_9 != 0) ? half_difference_8 : half_difference_5;
    const float half_difference_11 = (half_difference_9 != 0) ? half_difference_5 : half_difference_8;
    const float half_difference_12 = 0.41421357F /* 10355339/25000000 */ * half_difference_11;
    const int32_t half_difference_13 = half_difference_12 < half_difference_10;
    const float half_difference_14 = half_difference_10 - half_difference_11;
    const float half_difference_15 = (half_difference_13 != 0) ? half_difference_14 : half_difference_10;
    const float half_difference_16 = half_difference_10 + half_difference_11;
    const float half_difference_17 = (half_difference_13 != 0) ? half_difference_16 : half_difference_11;
    const float half_difference_18 = 7.523164e-37F * half_difference_11;
    const int32_t half_difference_19 = half_difference_18 < half_difference_10;
    const float half_difference_20 = (half_difference_19 != 0) ? half_difference_15 : 0.0F;
    const float half_difference_21 = (half_difference_19 != 0) ? half_difference_17 : 1.0F;
    const float half_difference_22 = half_difference_20 / half_difference_21;
    const float half_difference_23 = half_difference_22 * half_difference_22;
    const float half_difference_24 = half_difference_23 * 0.07901622F /* 151/1911 */;
    const float half_difference_25 = -0.13824141F /* -599/4333 */ + half_difference_24;
    const float half_difference_26 = half_difference_23 * half_difference_25;
    const float half_difference_27 = 0.1997185F /* 1419/7105 */ + half_difference_26;
    const float half_difference_28 = half_difference_23 * half_difference_27;
    const float half_difference_29 = -0.33332756F /* -19236/57709 */ + half_difference_28;
    const float half_difference_30 = half_difference_23 * half_difference_29;
    const float half_difference_31 = half_difference_22 * half_difference_30;
    const float half_difference_32 = half_difference_22 + half_difference_31;
    const float half_difference_33 = 0.7853982F + half_difference_32;
    const float half_difference_34 = (half_difference_13 != 0) ? half_difference_33 : half_difference_32;
    const float half_difference_35 = 1.5707964F - half_difference_34;
    const float half_difference_36 = (half_difference_9 != 0) ? half_difference_35 : half_difference_34;
    const float half_difference_37 = 3.1415927F - half_difference_36;
    const float half_difference_38 = (half_difference_6 != 0) ? half_difference_37 : half_difference_36;
    const float half_difference_39 = -half_difference_38;
    const float half_difference = (half_difference_3 != 0) ? half_difference_39 : half_difference_38;

    /* up = square of the numerator of tan(pitch/2 + pi/4) */
    const float up_1 = half_difference_2 * half_difference_2;
    const float up_2 = half_difference_1 * half_difference_1;
    const float up = up_1 + up_2;

    /* down = square of its denominator */
    const float down_1 = half_sum_2 * half_sum_2;
    const float down_2 = half_sum_1 * half_sum_1;
    const float down = down_1 + down_2;

    /* pitch = 2 atan(sqrt(up/down)) - pi/2   [zyx] */
    const int32_t pitch_1 = down < up;
    const float pitch_2 = (pitch_1 != 0) ? down : up;
    const float pitch_3 = (pitch_1 != 0) ? up : down;
    const float pitch_4 = 7.523164e-37F * pitch_3;
    const int32_t pitch_5 = pitch_4 < pitch_2;
    const float pitch_6 = (pitch_5 != 0) ? pitch_2 : 0.0F;
    const float pitch_7 = (pitch_5 != 0) ? pitch_3 : 1.0F;
    const float pitch_8 = pitch_6 / pitch_7;
    const float pitch_9 = 0.25F * pitch_8;
    const int32_t pitch_10 = pitch_9 < 2.3283064e-10F /* 1/4294967296 */;
    const float pitch_11 = 4294967300.0F * pitch_9;
    const float pitch_12 = (pitch_10 != 0) ? pitch_11 : pitch_9;
    const float pitch_13 = (pitch_10 != 0) ? 7.6293945e-06F /* 1/131072 */ : 0.5F;
    const int32_t pitch_14 = pitch_12 < 1.5258789e-05F /* 1/65536 */;
    const float pitch_15 = 65536.0F * pitch_12;
    const float pitch_16 = (pitch_14 != 0) ? pitch_15 : pitch_12;
    const float pitch_17 = 0.00390625F /* 1/256 */ * pitch_13;
    const float pitch_18 = (pitch_14 != 0) ? pitch_17 : pitch_13;
    const int32_t pitch_19 = pitch_16 < 0.00390625F /* 1/256 */;
    const float pitch_20 = 256.0F * pitch_16;
    const float pitch_21 = (pitch_19 != 0) ? pitch_20 : pitch_16;
    const float pitch_22 = 0.0625F /* 1/16 */ * pitch_18;
    const float pitch_23 = (pitch_19 != 0) ? pitch_22 : pitch_18;
    const int32_t pitch_24 = pitch_21 < 0.0625F /* 1/16 */;
    const float pitch_25 = 16.0F * pitch_21;
    const float pitch_26 = (pitch_24 != 0) ? pitch_25 : pitch_21;
    const float pitch_27 = 0.25F * pitch_23;
    const float pitch_28 = (pitch_24 != 0) ? pitch_27 : pitch_23;
    const int32_t pitch_29 = pitch_26 < 0.25F;
    const float pitch_30 = 4.0F * pitch_26;
    const float pitch_31 = (pitch_29 != 0) ? pitch_30 : pitch_26;
    const float pitch_32 = 0.5F * pitch_28;
    const float pitch_33 = (pitch_29 != 0) ? pitch_32 : pitch_28;
    const float pitch_34 = 4.0F * pitch_31;
    const float pitch_35 = pitch_34 * 0.006809806F /* 116991577/17179869184 */;
    const float pitch_36 = -0.08719061F /* -383468370477/4398046511104 */ + pitch_35;
    const float pitch_37 = pitch_34 * pitch_36;
    const float pitch_38 = 0.4350525F /* 239172645671/549755813888 */ + pitch_37;
    const float pitch_39 = pitch_34 * pitch_38;
    const float pitch_40 = -1.0886095F /* -4787754840185/4398046511104 */ + pitch_39;
    const float pitch_41 = pitch_34 * pitch_40;
    const float pitch_42 = 1.7312461F /* 30456404726813/17592186044416 */ + pitch_41;
    const float pitch_43 = 0.5F * pitch_42;
    const float pitch_44 = pitch_42 * pitch_42;
    const float pitch_45 = pitch_34 * pitch_44;
    const float pitch_46 = 1.0F - pitch_45;
    const float pitch_47 = pitch_43 * pitch_46;
    const float pitch_48 = pitch_42 + pitch_47;
    const float pitch_49 = 0.5F * pitch_48;
    const float pitch_50 = pitch_48 * pitch_48;
    const float pitch_51 = pitch_34 * pitch_50;
    const float pitch_52 = 1.0F - pitch_51;
    const float pitch_53 = pitch_49 * pitch_52;
    const float pitch_54 = pitch_48 + pitch_53;
    const float pitch_55 = pitch_34 * pitch_54;
    const float pitch_56 = pitch_55 * pitch_33;
    const float pitch_57 = 2.0F * pitch_56;
    const int32_t pitch_58 = pitch_57 < 0.0F;
    const float pitch_59 = -pitch_57;
    const float pitch_60 = (pitch_58 != 0) ? pitch_59 : pitch_57;
    const int32_t pitch_61 = 1.0F < 0.0F;
    const float pitch_62 = (pitch_61 != 0) ? -1.0F : 1.0F;
    const int32_t pitch_63 = pitch_62 < pitch_60;
    const float pitch_64 = (pitch_63 != 0) ? pitch_62 : pitch_60;
    const float pitch_65 = (pitch_63 != 0) ? pitch_60 : pitch_62;
    const float pitch_66 = 0.41421357F /* 10355339/25000000 */ * pitch_65;
    const int32_t pitch_67 = pitch_66 < pitch_64;
    const float pitch_68 = pitch_64 - pitch_65;
    const float pitch_69 = (pitch_67 != 0) ? pitch_68 : pitch_64;
    const float pitch_70 = pitch_64 + pitch_65;
    const float pitch_71 = (pitch_67 != 0) ? pitch_70 : pitch_65;
    const float pitch_72 = 7.523164e-37F * pitch_65;
    const int32_t pitch_73 = pitch_72 < pitch_64;
    const float pitch_74 = (pitch_73 != 0) ? pitch_69 : 0.0F;
    const float pitch_75 = (pitch_73 != 0) ? pitch_71 : 1.0F;
    const float pitch_76 = pitch_74 / pitch_75;
    const float pitch_77 = pitch_76 * pitch_76;
    const float pitch_78 = pitch_77 * 0.07901622F /* 151/1911 */;
    const float pitch_79 = -0.13824141F /* -599/4333 */ + pitch_78;
    const float pitch_80 = pitch_77 * pitch_79;
    const float pitch_81 = 0.1997185F /* 1419/7105 */ + pitch_80;
    const float pitch_82 = pitch_77 * pitch_81;
    const float pitch_83 = -0.33332756F /* -19236/57709 */ + pitch_82;
    const float pitch_84 = pitch_77 * pitch_83;
    const float pitch_85 = pitch_76 * pitch_84;
    const float pitch_86 = pitch_76 + pitch_85;
    const float pitch_87 = 0.7853982F + pitch_86;
    const float pitch_88 = (pitch_67 != 0) ? pitch_87 : pitch_86;
    const float pitch_89 = 1.5707964F - pitch_88;
    const float pitch_90 = (pitch_63 != 0) ? pitch_89 : pitch_88;
    const float pitch_91 = 3.1415927F - pitch_90;
    const float pitch_92 = (pitch_61 != 0) ? pitch_91 : pitch_90;
    const float pitch_93 = -pitch_92;
    const float pitch_94 = (pitch_58 != 0) ? pitch_93 : pitch_92;
    const float pitch_95 = pitch_94 + pitch_94;
    const float pitch_96 = 1.5707964F - pitch_95;
    const float pitch_97 = -pitch_96;
    const float pitch = (pitch_1 != 0) ? pitch_96 : pitch_97;

    /* roll = half_sum - half_difference, in [-pi, pi] */
    const float roll_1 = half_sum - half_difference;
    const int32_t roll_2 = 3.1415927F < roll_1;
    const float roll_3 = roll_1 - 6.2831855F;
    const float roll_4 = (roll_2 != 0) ? roll_3 : roll_1;
    const int32_t roll_5 = roll_4 < -3.1415927F;
    const float roll_6 = roll_4 + 6.2831855F;
    const float roll = (roll_5 != 0) ? roll_6 : roll_4;

    /* yaw = half_sum + half_difference, in [-pi, pi] */
    const float yaw_1 = half_sum + half_difference;
    const int32_t yaw_2 = 3.1415927F < yaw_1;
    const float yaw_3 = yaw_1 - 6.2831855F;
    const float yaw_4 = (yaw_2 != 0) ? yaw_3 : yaw_1;
    const int32_t yaw_5 = yaw_4 < -3.1415927F;
    const float yaw_6 = yaw_4 + 6.2831855F;
    const float yaw = (yaw_5 != 0) ? yaw_6 : yaw_4;

    rpy[0] = roll;
    rpy[1] = pitch;
    rpy[2] = yaw;
}
