/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_rate_float32
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rate_float32, SHA-256 of the design
 * 31ed0d27ee8b531e5c2589c12026c45377f8972a74d90b9c32f43acb61687ecb
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
 * range:       |omega| <= 2000 deg/s (34.907 rad/s), 300 updates/s; |dtheta| <= 0.054946 rad;
 *              |phi| <= 0.1703 rad; beyond it nothing is bounded: accuracy is lost and, far beyond
 *              it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 2 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2e-11 (scalar), 6.4e-12 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       76       0   61        13       3       0     0     0     0       0
 * update shared           75       1   61        13       0       0     0     0     0       0
 * update emitted          75       1   61        13       0       0     0     0     0       0
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
#include "rotation_vector_3_coning_rate_float32.h"

#if ROTATION_VECTOR_3_CONING_RATE_FLOAT32_VERSION != 1
#error "rotation_vector_3_coning_rate_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_3_coning_rate_float32_init(rotation_vector_3_coning_rate_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
    state->omega_last[0] = 0.0F;
    state->omega_last[1] = 0.0F;
    state->omega_last[2] = 0.0F;
}

void rotation_vector_3_coning_rate_float32_set_quaternion(
    rotation_vector_3_coning_rate_float32_state *state, const float q_nb[4])
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

void rotation_vector_3_coning_rate_float32_start(
    rotation_vector_3_coning_rate_float32_state *state, const float omega[3])
{
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void rotation_vector_3_coning_rate_float32_update(
    rotation_vector_3_coning_rate_float32_state *state, const float omega[9])
{
    /* attitude and input, along the sensor's axes: body x, y, z = y, -x, z */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float omega1_x = omega[0];
    const float omega1_y = omega[1];
    const float omega1_z = omega[2];
    const float omega2_x = omega[3];
    const float omega2_y = omega[4];
    const float omega2_z = omega[5];
    const float omega3_x = omega[6];
    const float omega3_y = omega[7];
    const float omega3_z = omega[8];

    /* the sample at the start of the interval */
    const float omega_last_x = state->omega_last[0];
    const float omega_last_y = state->omega_last[1];
    const float omega_last_z = state->omega_last[2];

    /* theta1 = T (1/8 w0 + 19/72 w1 - 5/72 w2 + 1/72 w3)   [polynomial through all samples] */
    const float theta1_x_1 = 0.00041666668F /* 1/2400 */ * omega_last_x;
    const float theta1_y_1 = 0.00041666668F /* 1/2400 */ * omega_last_y;
    const float theta1_z_1 = 0.00041666668F /* 1/2400 */ * omega_last_z;
    const float theta1_x_2 = 0.00087962963F /* 19/21600 */ * omega1_x;
    const float theta1_y_2 = 0.00087962963F /* 19/21600 */ * omega1_y;
    const float theta1_z_2 = 0.00087962963F /* 19/21600 */ * omega1_z;
    const float theta1_x_3 = theta1_x_1 + theta1_x_2;
    const float theta1_y_3 = theta1_y_1 + theta1_y_2;
    const float theta1_z_3 = theta1_z_1 + theta1_z_2;
    const float theta1_x_4 = -0.00023148148F /* -1/4320 */ * omega2_x;
    const float theta1_y_4 = -0.00023148148F /* -1/4320 */ * omega2_y;
    const float theta1_z_4 = -0.00023148148F /* -1/4320 */ * omega2_z;
    const float theta1_x_5 = theta1_x_3 + theta1_x_4;
    const float theta1_y_5 = theta1_y_3 + theta1_y_4;
    const float theta1_z_5 = theta1_z_3 + theta1_z_4;
    const float theta1_x_6 = 4.6296296e-05F /* 1/21600 */ * omega3_x;
    const float theta1_y_6 = 4.6296296e-05F /* 1/21600 */ * omega3_y;
    const float theta1_z_6 = 4.6296296e-05F /* 1/21600 */ * omega3_z;
    const float theta1_x = theta1_x_5 + theta1_x_6;
    const float theta1_y = theta1_y_5 + theta1_y_6;
    const float theta1_z = theta1_z_5 + theta1_z_6;

    /* theta2 = T (- 1/72 w0 + 13/72 w1 + 13/72 w2 - 1/72 w3)   [polynomial through all samples] */
    const float theta2_x_1 = -4.6296296e-05F /* -1/21600 */ * omega_last_x;
    const float theta2_y_1 = -4.6296296e-05F /* -1/21600 */ * omega_last_y;
    const float theta2_z_1 = -4.6296296e-05F /* -1/21600 */ * omega_last_z;
    const float theta2_x_2 = 0.00060185185F /* 13/21600 */ * omega1_x;
    const float theta2_y_2 = 0.00060185185F /* 13/21600 */ * omega1_y;
    const float theta2_z_2 = 0.00060185185F /* 13/21600 */ * omega1_z;
    const float theta2_x_3 = theta2_x_1 + theta2_x_2;
    const float theta2_y_3 = theta2_y_1 + theta2_y_2;
    const float theta2_z_3 = theta2_z_1 + theta2_z_2;
    const float theta2_x_4 = 0.00060185185F /* 13/21600 */ * omega2_x;
    const float theta2_y_4 = 0.00060185185F /* 13/21600 */ * omega2_y;
    const float theta2_z_4 = 0.00060185185F /* 13/21600 */ * omega2_z;
    const float theta2_x_5 = theta2_x_3 + theta2_x_4;
    const float theta2_y_5 = theta2_y_3 + theta2_y_4;
    const float theta2_z_5 = theta2_z_3 + theta2_z_4;
    const float theta2_x_6 = -4.6296296e-05F /* -1/21600 */ * omega3_x;
    const float theta2_y_6 = -4.6296296e-05F /* -1/21600 */ * omega3_y;
    const float theta2_z_6 = -4.6296296e-05F /* -1/21600 */ * omega3_z;
    const float theta2_x = theta2_x_5 + theta2_x_6;
    const float theta2_y = theta2_y_5 + theta2_y_6;
    const float theta2_z = theta2_z_5 + theta2_z_6;

    /* theta3 = T (1/72 w0 - 5/72 w1 + 19/72 w2 + 1/8 w3)   [polynomial through all samples] */
    const float theta3_x_1 = 4.6296296e-05F /* 1/21600 */ * omega_last_x;
    const float theta3_y_1 = 4.6296296e-05F /* 1/21600 */ * omega_last_y;
    const float theta3_z_1 = 4.6296296e-05F /* 1/21600 */ * omega_last_z;
    const float theta3_x_2 = -0.00023148148F /* -1/4320 */ * omega1_x;
    const float theta3_y_2 = -0.00023148148F /* -1/4320 */ * omega1_y;
    const float theta3_z_2 = -0.00023148148F /* -1/4320 */ * omega1_z;
    const float theta3_x_3 = theta3_x_1 + theta3_x_2;
    const float theta3_y_3 = theta3_y_1 + theta3_y_2;
    const float theta3_z_3 = theta3_z_1 + theta3_z_2;
    const float theta3_x_4 = 0.00087962963F /* 19/21600 */ * omega2_x;
    const float theta3_y_4 = 0.00087962963F /* 19/21600 */ * omega2_y;
    const float theta3_z_4 = 0.00087962963F /* 19/21600 */ * omega2_z;
    const float theta3_x_5 = theta3_x_3 + theta3_x_4;
    const float theta3_y_5 = theta3_y_3 + theta3_y_4;
    const float theta3_z_5 = theta3_z_3 + theta3_z_4;
    const float theta3_x_6 = 0.00041666668F /* 1/2400 */ * omega3_x;
    const float theta3_y_6 = 0.00041666668F /* 1/2400 */ * omega3_y;
    const float theta3_z_6 = 0.00041666668F /* 1/2400 */ * omega3_z;
    const float theta3_x = theta3_x_5 + theta3_x_6;
    const float theta3_y = theta3_y_5 + theta3_y_6;
    const float theta3_z = theta3_z_5 + theta3_z_6;

    /* p = theta_1 + theta_3 */
    const float p_x = theta1_y + theta3_y;
    const float p_y_negated = theta1_x + theta3_x;
    const float p_z = theta1_z + theta3_z;

    /* d = theta_3 - theta_1 */
    const float d_x = theta3_y - theta1_y;
    const float d_y = theta1_x - theta3_x;
    const float d_z = theta3_z - theta1_z;

    /* S = p + theta_2 */
    const float S_x = p_x + theta2_y;
    const float S_y_negated = p_y_negated + theta2_x;
    const float S_z = p_z + theta2_z;

    /* g = S + 2 theta_2   [cao (12)] */
    const float g_x_1 = S_x + theta2_y;
    const float g_y_negated_1 = S_y_negated + theta2_x;
    const float g_z_1 = S_z + theta2_z;
    const float g_x = g_x_1 + theta2_y;
    const float g_y_negated = g_y_negated_1 + theta2_x;
    const float g_z = g_z_1 + theta2_z;

    /* k = 9/40 d   [cao (12)] */
    const float k_x = 0.225F /* 9/40 */ * d_x;
    const float k_y = 0.225F /* 9/40 */ * d_y;
    const float k_z = 0.225F /* 9/40 */ * d_z;

    /* coning = g x k   [cao (12)] */
    const float coning_x_negated_1 = g_y_negated * k_z;
    const float coning_x_negated_2 = g_z * k_y;
    const float coning_x_negated = coning_x_negated_1 + coning_x_negated_2;
    const float coning_y_1 = g_z * k_x;
    const float coning_y_2 = g_x * k_z;
    const float coning_y = coning_y_1 - coning_y_2;
    const float coning_z_1 = g_x * k_y;
    const float coning_z_2 = g_y_negated * k_x;
    const float coning_z = coning_z_1 + coning_z_2;

    /* phi = S + coning   [cao (12)] */
    const float phi_x = S_x - coning_x_negated;
    const float phi_y = coning_y - S_y_negated;
    const float phi_z = S_z + coning_z;

    /* phi_square = |phi|^2 */
    const float phi_square_1 = phi_x * phi_x;
    const float phi_square_2 = phi_y * phi_y;
    const float phi_square_3 = phi_z * phi_z;
    const float phi_square_4 = phi_square_1 + phi_square_2;
    const float phi_square = phi_square_4 + phi_square_3;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const float u_1 = phi_square * 0.00260329F /* 116/44559 */;
    const float u_2 = -0.12499999F /* -1983523/15868185 */ + u_1;
    const float u = phi_square * u_2;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const float s_1 = phi_square * 0.00026041668F /* 1/3840 */;
    const float s_2 = -0.020833334F /* -1/48 */ + s_1;
    const float s_3 = phi_square * s_2;
    const float s = 0.5F + s_3;

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
    state->omega_last[0] = omega3_x;
    state->omega_last[1] = omega3_y;
    state->omega_last[2] = omega3_z;
}

void rotation_vector_3_coning_rate_float32_quaternion(
    const rotation_vector_3_coning_rate_float32_state *state, float q_nb[4])
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

void rotation_vector_3_coning_rate_float32_dcm(
    const rotation_vector_3_coning_rate_float32_state *state, float c_nb[9])
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
