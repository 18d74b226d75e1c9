/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_euler_zyx_float64
 *
 * qcone 0.1.0, design rotation_vector_3_coning_euler_zyx_float64, SHA-256 of the design
 * 197796450fdafe7a1d4115f47be1c504b7acaa156a26ebd29bca06a228ccaa8b
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *              4.4e-22 (scalar), 4.1e-20 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       43       0   37        13       0       0     0     0     0       0
 * update shared           42       1   37        13       0       0     0     0     0       0
 * update emitted          42       1   37        13       0       0     0     0     0       0
 * euler as-written        80       0   54        17      10       4     0     0    27      57
 * euler shared            59      20   54        17       9       4     0     0    27      57
 * euler emitted           59      20   54        17       9       4     0     0    27      57
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_euler_zyx_float64.h"

#if ROTATION_VECTOR_3_CONING_EULER_ZYX_FLOAT64_VERSION != 1
#error "rotation_vector_3_coning_euler_zyx_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_3_coning_euler_zyx_float64_init(
    rotation_vector_3_coning_euler_zyx_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void rotation_vector_3_coning_euler_zyx_float64_set_quaternion(
    rotation_vector_3_coning_euler_zyx_float64_state *state, const double q_nb[4])
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

void rotation_vector_3_coning_euler_zyx_float64_update(
    rotation_vector_3_coning_euler_zyx_float64_state *state, const double dtheta[9])
{
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

    /* p = theta_1 + theta_3 */
    const double p_x = dtheta1_x + dtheta3_x;
    const double p_y = dtheta1_y + dtheta3_y;
    const double p_z = dtheta1_z + dtheta3_z;

    /* d = theta_3 - theta_1 */
    const double d_x = dtheta3_x - dtheta1_x;
    const double d_y = dtheta3_y - dtheta1_y;
    const double d_z = dtheta3_z - dtheta1_z;

    /* S = p + theta_2 */
    const double S_x = p_x + dtheta2_x;
    const double S_y = p_y + dtheta2_y;
    const double S_z = p_z + dtheta2_z;

    /* g = S + 2 theta_2   [cao (12)] */
    const double g_x_1 = S_x + dtheta2_x;
    const double g_y_1 = S_y + dtheta2_y;
    const double g_z_1 = S_z + dtheta2_z;
    const double g_x = g_x_1 + dtheta2_x;
    const double g_y = g_y_1 + dtheta2_y;
    const double g_z = g_z_1 + dtheta2_z;

    /* k = 9/40 d   [cao (12)] */
    const double k_x = 0.225 /* 9/40 */ * d_x;
    const double k_y = 0.225 /* 9/40 */ * d_y;
    const double k_z = 0.225 /* 9/40 */ * d_z;

    /* coning = g x k   [cao (12)] */
    const double coning_x_1 = g_y * k_z;
    const double coning_x_2 = g_z * k_y;
    const double coning_x = coning_x_1 - coning_x_2;
    const double coning_y_1 = g_z * k_x;
    const double coning_y_2 = g_x * k_z;
    const double coning_y = coning_y_1 - coning_y_2;
    const double coning_z_1 = g_x * k_y;
    const double coning_z_2 = g_y * k_x;
    const double coning_z = coning_z_1 - coning_z_2;

    /* phi = S + coning   [cao (12)] */
    const double phi_x = S_x + coning_x;
    const double phi_y = S_y + coning_y;
    const double phi_z = S_z + coning_z;

    /* phi_square = |phi|^2 */
    const double phi_square_1 = phi_x * phi_x;
    const double phi_square_2 = phi_y * phi_y;
    const double phi_square_3 = phi_z * phi_z;
    const double phi_square_4 = phi_square_1 + phi_square_2;
    const double phi_square = phi_square_4 + phi_square_3;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const double u_1 = phi_square * 9.687437727939356e-08 /* 1/10322647 */;
    const double u_2 = -2.1701388828826363e-05 /* -7841/361313281 */ + u_1;
    const double u_3 = phi_square * u_2;
    const double u_4 = 0.002604166666666458 /* 32503931622/12481509742849 */ + u_3;
    const double u_5 = phi_square * u_4;
    const double u_6 = -0.125 /* -64545995202851653/516367961622813225 */ + u_5;
    const double u = phi_square * u_6;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const double s_1 = phi_square * -1.5499842233748693e-06 /* -7/4516175 */;
    const double s_2 = 0.00026041666590186107 /* 88672/340500481 */ + s_1;
    const double s_3 = phi_square * s_2;
    const double s_4 = -0.0208333333333318 /* -282645818610/13566999293281 */ + s_3;
    const double s_5 = phi_square * s_4;
    const double s = 0.5 + s_5;

    /* v = s phi   [cao (14)] */
    const double v_x = s * phi_x;
    const double v_y = s * phi_y;
    const double v_z = s * phi_z;

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

void rotation_vector_3_coning_euler_zyx_float64_quaternion(
    const rotation_vector_3_coning_euler_zyx_float64_state *state, double q_nb[4])
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

void rotation_vector_3_coning_euler_zyx_float64_euler(
    const rotation_vector_3_coning_euler_zyx_float64_state *state, double rpy[3])
{
    /* q, read once */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];

    /* half_sum = (yaw + roll)/2   [zyx] */
    const double half_sum_1 = q_z + q_x;
    const double half_sum_2 = q_w - q_y;
    const double half_difference_1 = q_z - q_x;
    const double half_difference_2 = q_w + q_y;
    const int32_t half_sum_3 = half_sum_1 < 0.0;
    const double half_sum_4 = -half_sum_1;
    const double half_sum_5 = (half_sum_3 != 0) ? half_sum_4 : half_sum_1;
    const int32_t half_sum_6 = half_sum_2 < 0.0;
    const double half_sum_7 = -half_sum_2;
    const double half_sum_8 = (half_sum_6 != 0) ? half_sum_7 : half_sum_2;
    const int32_t half_sum_9 = half_sum_8 < half_sum_5;
    const double half_sum_10 = (half_sum_9 != 0) ? half_sum_8 : half_sum_5;
    const double half_sum_11 = (half_sum_9 != 0) ? half_sum_5 : half_sum_8;
    const double half_sum_12 = 0.41421356 /* 10355339/25000000 */ * half_sum_11;
    const int32_t half_sum_13 = half_sum_12 < half_sum_10;
    const double half_sum_14 = half_sum_10 - half_sum_11;
    const double half_sum_15 = (half_sum_13 != 0) ? half_sum_14 : half_sum_10;
    const double half_sum_16 = half_sum_10 + half_sum_11;
    const double half_sum_17 = (half_sum_13 != 0) ? half_sum_16 : half_sum_11;
    const double half_sum_18 = 1.424047269444609e-306 * half_sum_11;
    const int32_t half_sum_19 = half_sum_18 < half_sum_10;
    const double half_sum_20 = (half_sum_19 != 0) ? half_sum_15 : 0.0;
    const double half_sum_21 = (half_sum_19 != 0) ? half_sum_17 : 1.0;
    const double half_sum_22 = half_sum_20 / half_sum_21;
    const double half_sum_23 = half_sum_22 * half_sum_22;
    const double half_sum_24 = half_sum_23 * 0.020659271935216498 /* 9646/466909 */;
    const double half_sum_25 = -0.04305880762135514 /* -31207/724753 */ + half_sum_24;
    const double half_sum_26 = half_sum_23 * half_sum_25;
    const double half_sum_27 = 0.05672404505505705 /* 23377/412118 */ + half_sum_26;
    const double half_sum_28 = half_sum_23 * half_sum_27;
    const double half_sum_29 = -0.0663687889326335 /* -210670/3174233 */ + half_sum_28;
    const double half_sum_30 = half_sum_23 * half_sum_29;
    const double half_sum_31 = 0.07689524235639426 /* 1143921/14876356 */ + half_sum_30;
    const double half_sum_32 = half_sum_23 * half_sum_31;
    const double half_sum_33 = -0.09090738837093491 /* -1364005/15004336 */ + half_sum_32;
    const double half_sum_34 = half_sum_23 * half_sum_33;
    const double half_sum_35 = 0.11111104505111347 /* 5793458/52141153 */ + half_sum_34;
    const double half_sum_36 = half_sum_23 * half_sum_35;
    const double half_sum_37 = -0.14285714133630667 /* -13419041/93933288 */ + half_sum_36;
    const double half_sum_38 = half_sum_23 * half_sum_37;
    const double half_sum_39 = 0.19999999998182857 /* 2201258242/11006291211 */ + half_sum_38;
    const double half_sum_40 = half_sum_23 * half_sum_39;
    const double half_sum_41 = -0.3333333333332519 /* -1364136838384/4092410515153 */ + half_sum_40;
    const double half_sum_42 = half_sum_23 * half_sum_41;
    const double half_sum_43 = half_sum_22 * half_sum_42;
    const double half_sum_44 = half_sum_22 + half_sum_43;
    const double half_sum_45 = 0.7853981633974483 + half_sum_44;
    const double half_sum_46 = (half_sum_13 != 0) ? half_sum_45 : half_sum_44;
    const double half_sum_47 = 1.5707963267948966 - half_sum_46;
    const double half_sum_48 = (half_sum_9 != 0) ? half_sum_47 : half_sum_46;
    const double half_sum_49 = 3.141592653589793 - half_sum_48;
    const double half_sum_50 = (half_sum_6 != 0) ? half_sum_49 : half_sum_48;
    const double half_sum_51 = -half_sum_50;
    const double half_sum = (half_sum_3 != 0) ? half_sum_51 : half_sum_50;

    /* half_difference = (yaw - roll)/2   [zyx] */
    const int32_t half_difference_3 = half_difference_1 < 0.0;
    const double half_difference_4 = -half_difference_1;
    const double half_difference_5 = (half_difference_3 != 0) ? half_difference_4 : half_difference_1;
    const int32_t half_difference_6 = half_difference_2 < 0.0;
    const double half_difference_7 = -half_difference_2;
    const double half_difference_8 = (half_difference_6 != 0) ? half_difference_7 : half_difference_2;
    const int32_t half_difference_9 = half_difference_8 < half_difference_5;
    const double half_difference_10 = (half_difference_9 != 0) ? half_difference_8 : half_difference_5;
    const double half_difference_11 = (half_difference_9 != 0) ? half_difference_5 : half_difference_8;
    const double half_difference_12 = 0.41421356 /* 10355339/25000000 */ * half_difference_11;
    const int32_t half_difference_13 = half_difference_12 < half_difference_10;
    const double half_difference_14 = half_difference_10 - half_difference_11;
    const double half_difference_15 = (half_difference_13 != 0) ? half_difference_14 : half_difference_10;
    const double half_difference_16 = half_difference_10 + half_difference_11;
    const double half_difference_17 = (half_difference_13 != 0) ? half_difference_16 : half_difference_11;
    const double half_difference_18 = 1.424047269444609e-306 * half_difference_11;
    const int32_t half_difference_19 = half_difference_18 < half_difference_10;
    const double half_difference_20 = (half_difference_19 != 0) ? half_difference_15 : 0.0;
    const double half_difference_21 = (half_difference_19 != 0) ? half_difference_17 : 1.0;
    const double half_difference_22 = half_difference_20 / half_difference_21;
    const double half_difference_23 = half_difference_22 * half_difference_22;
    const double half_difference_24 = half_difference_23 * 0.020659271935216498 /* 9646/466909 */;
    const double half_difference_25 = -0.04305880762135514 /* -31207/724753 */ + half_difference_24;
    const double half_difference_26 = half_difference_23 * half_difference_25;
    const double half_difference_27 = 0.05672404505505705 /* 23377/412118 */ + half_difference_26;
    const double half_difference_28 = half_difference_23 * half_difference_27;
    const double half_difference_29 = -0.0663687889326335 /* -210670/3174233 */ + half_difference_28;
    const double half_difference_30 = half_difference_23 * half_difference_29;
    const double half_difference_31 = 0.07689524235639426 /* 1143921/14876356 */ + half_difference_30;
    const double half_difference_32 = half_difference_23 * half_difference_31;
    const double half_difference_33 = -0.09090738837093491 /* -1364005/15004336 */ + half_difference_32;
    const double half_difference_34 = half_difference_23 * half_difference_33;
    const double half_difference_35 = 0.11111104505111347 /* 5793458/52141153 */ + half_difference_34;
    const double half_difference_36 = half_difference_23 * half_difference_35;
    const double half_difference_37 = -0.14285714133630667 /* -13419041/93933288 */ + half_difference_36;
    const double half_difference_38 = half_difference_23 * half_difference_37;
    const double half_difference_39 = 0.19999999998182857 /* 2201258242/11006291211 */ + half_difference_38;
    const double half_difference_40 = half_difference_23 * half_difference_39;
    const double half_difference_41 = -0.3333333333332519 /* -1364136838384/4092410515153 */ + half_difference_40;
    const double half_difference_42 = half_difference_23 * half_difference_41;
    const double half_difference_43 = half_difference_22 * half_difference_42;
    const double half_difference_44 = half_difference_22 + half_difference_43;
    const double half_difference_45 = 0.7853981633974483 + half_difference_44;
    const double half_difference_46 = (half_difference_13 != 0) ? half_difference_45 : half_difference_44;
    const double half_difference_47 = 1.5707963267948966 - half_difference_46;
    const double half_difference_48 = (half_difference_9 != 0) ? half_difference_47 : half_difference_46;
    const double half_difference_49 = 3.141592653589793 - half_difference_48;
    const double half_difference_50 = (half_difference_6 != 0) ? half_difference_49 : half_difference_48;
    const double half_difference_51 = -half_difference_50;
    const double half_difference = (half_difference_3 != 0) ? half_difference_51 : half_difference_50;

    /* up = square of the numerator of tan(pitch/2 + pi/4) */
    const double up_1 = half_difference_2 * half_difference_2;
    const double up_2 = half_difference_1 * half_difference_1;
    const double up = up_1 + up_2;

    /* down = square of its denominator */
    const double down_1 = half_sum_2 * half_sum_2;
    const double down_2 = half_sum_1 * half_sum_1;
    const double down = down_1 + down_2;

    /* pitch = 2 atan(sqrt(up/down)) - pi/2   [zyx] */
    const int32_t pitch_1 = down < up;
    const double pitch_2 = (pitch_1 != 0) ? down : up;
    const double pitch_3 = (pitch_1 != 0) ? up : down;
    const double pitch_4 = 1.424047269444609e-306 * pitch_3;
    const int32_t pitch_5 = pitch_4 < pitch_2;
    const double pitch_6 = (pitch_5 != 0) ? pitch_2 : 0.0;
    const double pitch_7 = (pitch_5 != 0) ? pitch_3 : 1.0;
    const double pitch_8 = pitch_6 / pitch_7;
    const double pitch_9 = 0.25 * pitch_8;
    const int32_t pitch_10 = pitch_9 < 5.421010862427522e-20 /* 1/18446744073709551616 */;
    const double pitch_11 = 1.8446744073709552e+19 * pitch_9;
    const double pitch_12 = (pitch_10 != 0) ? pitch_11 : pitch_9;
    const double pitch_13 = (pitch_10 != 0) ? 1.1641532182693481e-10 /* 1/8589934592 */ : 0.5;
    const int32_t pitch_14 = pitch_12 < 2.3283064365386963e-10 /* 1/4294967296 */;
    const double pitch_15 = 4294967296.0 * pitch_12;
    const double pitch_16 = (pitch_14 != 0) ? pitch_15 : pitch_12;
    const double pitch_17 = 1.52587890625e-05 /* 1/65536 */ * pitch_13;
    const double pitch_18 = (pitch_14 != 0) ? pitch_17 : pitch_13;
    const int32_t pitch_19 = pitch_16 < 1.52587890625e-05 /* 1/65536 */;
    const double pitch_20 = 65536.0 * pitch_16;
    const double pitch_21 = (pitch_19 != 0) ? pitch_20 : pitch_16;
    const double pitch_22 = 0.00390625 /* 1/256 */ * pitch_18;
    const double pitch_23 = (pitch_19 != 0) ? pitch_22 : pitch_18;
    const int32_t pitch_24 = pitch_21 < 0.00390625 /* 1/256 */;
    const double pitch_25 = 256.0 * pitch_21;
    const double pitch_26 = (pitch_24 != 0) ? pitch_25 : pitch_21;
    const double pitch_27 = 0.0625 /* 1/16 */ * pitch_23;
    const double pitch_28 = (pitch_24 != 0) ? pitch_27 : pitch_23;
    const int32_t pitch_29 = pitch_26 < 0.0625 /* 1/16 */;
    const double pitch_30 = 16.0 * pitch_26;
    const double pitch_31 = (pitch_29 != 0) ? pitch_30 : pitch_26;
    const double pitch_32 = 0.25 * pitch_28;
    const double pitch_33 = (pitch_29 != 0) ? pitch_32 : pitch_28;
    const int32_t pitch_34 = pitch_31 < 0.25;
    const double pitch_35 = 4.0 * pitch_31;
    const double pitch_36 = (pitch_34 != 0) ? pitch_35 : pitch_31;
    const double pitch_37 = 0.5 * pitch_33;
    const double pitch_38 = (pitch_34 != 0) ? pitch_37 : pitch_33;
    const double pitch_39 = 4.0 * pitch_36;
    const double pitch_40 = pitch_39 * 0.00018971865870298643 /* 834391485/4398046511104 */;
    const double pitch_41 = -0.004294917113327301 /* -75556980903/17592186044416 */ + pitch_40;
    const double pitch_42 = pitch_39 * pitch_41;
    const double pitch_43 = 0.042329438021056376 /* 372333674411/8796093022208 */ + pitch_42;
    const double pitch_44 = pitch_39 * pitch_43;
    const double pitch_45 = -0.23826869500408066 /* -65494800173/274877906944 */ + pitch_44;
    const double pitch_46 = pitch_39 * pitch_45;
    const double pitch_47 = 0.8445661107319893 /* 7428882073403/8796093022208 */ + pitch_46;
    const double pitch_48 = pitch_39 * pitch_47;
    const double pitch_49 = -1.9604098645106092 /* -34487895059779/17592186044416 */ + pitch_48;
    const double pitch_50 = pitch_39 * pitch_49;
    const double pitch_51 = 3.0078762989989514 /* 52915119450579/17592186044416 */ + pitch_50;
    const double pitch_52 = pitch_39 * pitch_51;
    const double pitch_53 = -3.045469355495527 /* -53576463494445/17592186044416 */ + pitch_52;
    const double pitch_54 = pitch_39 * pitch_53;
    const double pitch_55 = 2.3534559481227575 /* 41402434886713/17592186044416 */ + pitch_54;
    const double pitch_56 = 0.5 * pitch_55;
    const double pitch_57 = pitch_55 * pitch_55;
    const double pitch_58 = pitch_39 * pitch_57;
    const double pitch_59 = 1.0 - pitch_58;
    const double pitch_60 = pitch_56 * pitch_59;
    const double pitch_61 = pitch_55 + pitch_60;
    const double pitch_62 = 0.5 * pitch_61;
    const double pitch_63 = pitch_61 * pitch_61;
    const double pitch_64 = pitch_39 * pitch_63;
    const double pitch_65 = 1.0 - pitch_64;
    const double pitch_66 = pitch_62 * pitch_65;
    const double pitch_67 = pitch_61 + pitch_66;
    const double pitch_68 = pitch_39 * pitch_67;
    const double pitch_69 = pitch_68 * pitch_38;
    const double pitch_70 = 2.0 * pitch_69;
    const int32_t pitch_71 = pitch_70 < 0.0;
    const double pitch_72 = -pitch_70;
    const double pitch_73 = (pitch_71 != 0) ? pitch_72 : pitch_70;
    const int32_t pitch_74 = 1.0 < 0.0;
    const double pitch_75 = (pitch_74 != 0) ? -1.0 : 1.0;
    const int32_t pitch_76 = pitch_75 < pitch_73;
    const double pitch_77 = (pitch_76 != 0) ? pitch_75 : pitch_73;
    const double pitch_78 = (pitch_76 != 0) ? pitch_73 : pitch_75;
    const double pitch_79 = 0.41421356 /* 10355339/25000000 */ * pitch_78;
    const int32_t pitch_80 = pitch_79 < pitch_77;
    const double pitch_81 = pitch_77 - pitch_78;
    const double pitch_82 = (pitch_80 != 0) ? pitch_81 : pitch_77;
    const double pitch_83 = pitch_77 + pitch_78;
    const double pitch_84 = (pitch_80 != 0) ? pitch_83 : pitch_78;
    const double pitch_85 = 1.424047269444609e-306 * pitch_78;
    const int32_t pitch_86 = pitch_85 < pitch_77;
    const double pitch_87 = (pitch_86 != 0) ? pitch_82 : 0.0;
    const double pitch_88 = (pitch_86 != 0) ? pitch_84 : 1.0;
    const double pitch_89 = pitch_87 / pitch_88;
    const double pitch_90 = pitch_89 * pitch_89;
    const double pitch_91 = pitch_90 * 0.020659271935216498 /* 9646/466909 */;
    const double pitch_92 = -0.04305880762135514 /* -31207/724753 */ + pitch_91;
    const double pitch_93 = pitch_90 * pitch_92;
    const double pitch_94 = 0.05672404505505705 /* 23377/412118 */ + pitch_93;
    const double pitch_95 = pitch_90 * pitch_94;
    const double pitch_96 = -0.0663687889326335 /* -210670/3174233 */ + pitch_95;
    const double pitch_97 = pitch_90 * pitch_96;
    const double pitch_98 = 0.07689524235639426 /* 1143921/14876356 */ + pitch_97;
    const double pitch_99 = pitch_90 * pitch_98;
    const double pitch_100 = -0.09090738837093491 /* -1364005/15004336 */ + pitch_99;
    const double pitch_101 = pitch_90 * pitch_100;
    const double pitch_102 = 0.11111104505111347 /* 5793458/52141153 */ + pitch_101;
    const double pitch_103 = pitch_90 * pitch_102;
    const double pitch_104 = -0.14285714133630667 /* -13419041/93933288 */ + pitch_103;
    const double pitch_105 = pitch_90 * pitch_104;
    const double pitch_106 = 0.19999999998182857 /* 2201258242/11006291211 */ + pitch_105;
    const double pitch_107 = pitch_90 * pitch_106;
    const double pitch_108 = -0.3333333333332519 /* -1364136838384/4092410515153 */ + pitch_107;
    const double pitch_109 = pitch_90 * pitch_108;
    const double pitch_110 = pitch_89 * pitch_109;
    const double pitch_111 = pitch_89 + pitch_110;
    const double pitch_112 = 0.7853981633974483 + pitch_111;
    const double pitch_113 = (pitch_80 != 0) ? pitch_112 : pitch_111;
    const double pitch_114 = 1.5707963267948966 - pitch_113;
    const double pitch_115 = (pitch_76 != 0) ? pitch_114 : pitch_113;
    const double pitch_116 = 3.141592653589793 - pitch_115;
    const double pitch_117 = (pitch_74 != 0) ? pitch_116 : pitch_115;
    const double pitch_118 = -pitch_117;
    const double pitch_119 = (pitch_71 != 0) ? pitch_118 : pitch_117;
    const double pitch_120 = pitch_119 + pitch_119;
    const double pitch_121 = 1.5707963267948966 - pitch_120;
    const double pitch_122 = -pitch_121;
    const double pitch = (pitch_1 != 0) ? pitch_121 : pitch_122;

    /* roll = half_sum - half_difference, in [-pi, pi] */
    const double roll_1 = half_sum - half_difference;
    const int32_t roll_2 = 3.141592653589793 < roll_1;
    const double roll_3 = roll_1 - 6.283185307179586;
    const double roll_4 = (roll_2 != 0) ? roll_3 : roll_1;
    const int32_t roll_5 = roll_4 < -3.141592653589793;
    const double roll_6 = roll_4 + 6.283185307179586;
    const double roll = (roll_5 != 0) ? roll_6 : roll_4;

    /* yaw = half_sum + half_difference, in [-pi, pi] */
    const double yaw_1 = half_sum + half_difference;
    const int32_t yaw_2 = 3.141592653589793 < yaw_1;
    const double yaw_3 = yaw_1 - 6.283185307179586;
    const double yaw_4 = (yaw_2 != 0) ? yaw_3 : yaw_1;
    const int32_t yaw_5 = yaw_4 < -3.141592653589793;
    const double yaw_6 = yaw_4 + 6.283185307179586;
    const double yaw = (yaw_5 != 0) ? yaw_6 : yaw_4;

    rpy[0] = roll;
    rpy[1] = pitch;
    rpy[2] = yaw;
}
