/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_quaternion_float32
 *
 * qcone 0.1.0, design runge_kutta_4_quaternion_float32, SHA-256 of the design
 * fdf53a1309533f0eb16c977abbe6fa360894380199bbac1674b2c32a6f0e2341
 *
 * algorithm:   runge-kutta-4-quaternion, form factored, q' = q + dq, renormalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = 1/2 q (x) omega; q + h (k1 + 2 k2 + 2 k3 + k4)/6
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
 * update as-written       82       0   55        13       4       0     0     0     0       0
 * update shared           73       9   51        17       0       0     0     0     0       0
 * update emitted          73       9   51        17       0       0     0     0     0       0
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
#include "runge_kutta_4_quaternion_float32.h"

#if RUNGE_KUTTA_4_QUATERNION_FLOAT32_VERSION != 1
#error "runge_kutta_4_quaternion_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void runge_kutta_4_quaternion_float32_init(runge_kutta_4_quaternion_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
    state->omega_last[0] = 0.0F;
    state->omega_last[1] = 0.0F;
    state->omega_last[2] = 0.0F;
}

void runge_kutta_4_quaternion_float32_set_quaternion(
    runge_kutta_4_quaternion_float32_state *state, const float q_nb[4])
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

void runge_kutta_4_quaternion_float32_start(
    runge_kutta_4_quaternion_float32_state *state, const float omega[3])
{
    const float omega_x = omega[0];
    const float omega_y = omega[1];
    const float omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void runge_kutta_4_quaternion_float32_update(
    runge_kutta_4_quaternion_float32_state *state, const float omega[6])
{
    /* attitude and input */
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

    /* the sample at the start of the interval */
    const float omega_last_x = state->omega_last[0];
    const float omega_last_y = state->omega_last[1];
    const float omega_last_z = state->omega_last[2];

    /* g0 = h/2 omega_0 */
    const float g0_x = 0.005F /* 1/200 */ * omega_last_x;
    const float g0_y = 0.005F /* 1/200 */ * omega_last_y;
    const float g0_z = 0.005F /* 1/200 */ * omega_last_z;

    /* g1 = h/2 omega_1 */
    const float g1_x = 0.005F /* 1/200 */ * omega1_x;
    const float g1_y = 0.005F /* 1/200 */ * omega1_y;
    const float g1_z = 0.005F /* 1/200 */ * omega1_z;

    /* g2 = h/2 omega_2 */
    const float g2_x = 0.005F /* 1/200 */ * omega2_x;
    const float g2_y = 0.005F /* 1/200 */ * omega2_y;
    const float g2_z = 0.005F /* 1/200 */ * omega2_z;

    /* k1 = q (x) g0 */
    const float k1_w_negated_1 = q_x * g0_x;
    const float k1_w_negated_2 = q_y * g0_y;
    const float k1_w_negated_3 = q_z * g0_z;
    const float k1_w_negated_4 = k1_w_negated_1 + k1_w_negated_2;
    const float k1_w_negated = k1_w_negated_4 + k1_w_negated_3;
    const float k1_x_1 = q_w * g0_x;
    const float k1_x_2 = q_y * g0_z;
    const float k1_x_3 = q_z * g0_y;
    const float k1_x_4 = k1_x_1 + k1_x_2;
    const float k1_x = k1_x_4 - k1_x_3;
    const float k1_y_1 = q_w * g0_y;
    const float k1_y_2 = q_z * g0_x;
    const float k1_y_3 = q_x * g0_z;
    const float k1_y_4 = k1_y_1 + k1_y_2;
    const float k1_y = k1_y_4 - k1_y_3;
    const float k1_z_1 = q_w * g0_z;
    const float k1_z_2 = q_x * g0_y;
    const float k1_z_3 = q_y * g0_x;
    const float k1_z_4 = k1_z_1 + k1_z_2;
    const float k1_z = k1_z_4 - k1_z_3;

    /* k2 = (q + k1/2) (x) g1 */
    const float k2_x_1 = 0.5F * k1_w_negated;
    const float k2_w_negated_1 = 0.5F * k1_x;
    const float k2_w_negated_2 = 0.5F * k1_y;
    const float k2_w_negated_3 = 0.5F * k1_z;
    const float k2_x_2 = q_w - k2_x_1;
    const float k2_w_negated_4 = q_x + k2_w_negated_1;
    const float k2_w_negated_5 = q_y + k2_w_negated_2;
    const float k2_w_negated_6 = q_z + k2_w_negated_3;
    const float k2_w_negated_7 = k2_w_negated_4 * g1_x;
    const float k2_w_negated_8 = k2_w_negated_5 * g1_y;
    const float k2_w_negated_9 = k2_w_negated_6 * g1_z;
    const float k2_w_negated_10 = k2_w_negated_7 + k2_w_negated_8;
    const float k2_w_negated = k2_w_negated_10 + k2_w_negated_9;
    const float k2_x_3 = k2_x_2 * g1_x;
    const float k2_x_4 = k2_w_negated_5 * g1_z;
    const float k2_x_5 = k2_w_negated_6 * g1_y;
    const float k2_x_6 = k2_x_3 + k2_x_4;
    const float k2_x = k2_x_6 - k2_x_5;
    const float k2_y_1 = k2_x_2 * g1_y;
    const float k2_y_2 = k2_w_negated_6 * g1_x;
    const float k2_y_3 = k2_w_negated_4 * g1_z;
    const float k2_y_4 = k2_y_1 + k2_y_2;
    const float k2_y = k2_y_4 - k2_y_3;
    const float k2_z_1 = k2_x_2 * g1_z;
    const float k2_z_2 = k2_w_negated_4 * g1_y;
    const float k2_z_3 = k2_w_negated_5 * g1_x;
    const float k2_z_4 = k2_z_1 + k2_z_2;
    const float k2_z = k2_z_4 - k2_z_3;

    /* k3 = (q + k2/2) (x) g1 */
    const float k3_x_1 = 0.5F * k2_w_negated;
    const float k3_w_negated_1 = 0.5F * k2_x;
    const float k3_w_negated_2 = 0.5F * k2_y;
    const float k3_w_negated_3 = 0.5F * k2_z;
    const float k3_x_2 = q_w - k3_x_1;
    const float k3_w_negated_4 = q_x + k3_w_negated_1;
    const float k3_w_negated_5 = q_y + k3_w_negated_2;
    const float k3_w_negated_6 = q_z + k3_w_negated_3;
    const float k3_w_negated_7 = k3_w_negated_4 * g1_x;
    const float k3_w_negated_8 = k3_w_negated_5 * g1_y;
    const float k3_w_negated_9 = k3_w_negated_6 * g1_z;
    const float k3_w_negated_10 = k3_w_negated_7 + k3_w_negated_8;
    const float k3_w_negated = k3_w_negated_10 + k3_w_negated_9;
    const float k3_x_3 = k3_x_2 * g1_x;
    const float k3_x_4 = k3_w_negated_5 * g1_z;
    const float k3_x_5 = k3_w_negated_6 * g1_y;
    const float k3_x_6 = k3_x_3 + k3_x_4;
    const float k3_x = k3_x_6 - k3_x_5;
    const float k3_y_1 = k3_x_2 * g1_y;
    const float k3_y_2 = k3_w_negated_6 * g1_x;
    const float k3_y_3 = k3_w_negated_4 * g1_z;
    const float k3_y_4 = k3_y_1 + k3_y_2;
    const float k3_y = k3_y_4 - k3_y_3;
    const float k3_z_1 = k3_x_2 * g1_z;
    const float k3_z_2 = k3_w_negated_4 * g1_y;
    const float k3_z_3 = k3_w_negated_5 * g1_x;
    const float k3_z_4 = k3_z_1 + k3_z_2;
    const float k3_z = k3_z_4 - k3_z_3;

    /* k4 = (q + k3) (x) g2 */
    const float k4_x_1 = q_w - k3_w_negated;
    const float k4_w_negated_1 = q_x + k3_x;
    const float k4_w_negated_2 = q_y + k3_y;
    const float k4_w_negated_3 = q_z + k3_z;
    const float k4_w_negated_4 = k4_w_negated_1 * g2_x;
    const float k4_w_negated_5 = k4_w_negated_2 * g2_y;
    const float k4_w_negated_6 = k4_w_negated_3 * g2_z;
    const float k4_w_negated_7 = k4_w_negated_4 + k4_w_negated_5;
    const float k4_w_negated = k4_w_negated_7 + k4_w_negated_6;
    const float k4_x_2 = k4_x_1 * g2_x;
    const float k4_x_3 = k4_w_negated_2 * g2_z;
    const float k4_x_4 = k4_w_negated_3 * g2_y;
    const float k4_x_5 = k4_x_2 + k4_x_3;
    const float k4_x = k4_x_5 - k4_x_4;
    const float k4_y_1 = k4_x_1 * g2_y;
    const float k4_y_2 = k4_w_negated_3 * g2_x;
    const float k4_y_3 = k4_w_negated_1 * g2_z;
    const float k4_y_4 = k4_y_1 + k4_y_2;
    const float k4_y = k4_y_4 - k4_y_3;
    const float k4_z_1 = k4_x_1 * g2_z;
    const float k4_z_2 = k4_w_negated_1 * g2_y;
    const float k4_z_3 = k4_w_negated_2 * g2_x;
    const float k4_z_4 = k4_z_1 + k4_z_2;
    const float k4_z = k4_z_4 - k4_z_3;

    /* dq = (k1 + k4)/6 + (k2 + k3)/3 */
    const float dq_w_negated_1 = k1_w_negated + k4_w_negated;
    const float dq_x_1 = k1_x + k4_x;
    const float dq_y_1 = k1_y + k4_y;
    const float dq_z_1 = k1_z + k4_z;
    const float dq_w_negated_2 = 0.16666667F /* 1/6 */ * dq_w_negated_1;
    const float dq_x_2 = 0.16666667F /* 1/6 */ * dq_x_1;
    const float dq_y_2 = 0.16666667F /* 1/6 */ * dq_y_1;
    const float dq_z_2 = 0.16666667F /* 1/6 */ * dq_z_1;
    const float dq_w_negated_3 = k2_w_negated + k3_w_negated;
    const float dq_x_3 = k2_x + k3_x;
    const float dq_y_3 = k2_y + k3_y;
    const float dq_z_3 = k2_z + k3_z;
    const float dq_w_negated_4 = 0.33333334F /* 1/3 */ * dq_w_negated_3;
    const float dq_x_4 = 0.33333334F /* 1/3 */ * dq_x_3;
    const float dq_y_4 = 0.33333334F /* 1/3 */ * dq_y_3;
    const float dq_z_4 = 0.33333334F /* 1/3 */ * dq_z_3;
    const float dq_w_negated = dq_w_negated_2 + dq_w_negated_4;
    const float dq_x = dq_x_2 + dq_x_4;
    const float dq_y = dq_y_2 + dq_y_4;
    const float dq_z = dq_z_2 + dq_z_4;

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
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void runge_kutta_4_quaternion_float32_quaternion(
    const runge_kutta_4_quaternion_float32_state *state, float q_nb[4])
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

void runge_kutta_4_quaternion_float32_dcm(
    const runge_kutta_4_quaternion_float32_state *state, float c_nb[9])
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
