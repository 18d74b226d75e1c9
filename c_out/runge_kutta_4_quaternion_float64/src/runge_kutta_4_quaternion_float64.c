/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_quaternion_float64
 *
 * qcone 0.1.0, design runge_kutta_4_quaternion_float64, SHA-256 of the design
 * 3f1768e5c19e2599680fbc5ff45502efc4eb1742c1391c1ee8af9d9821d5faaa
 *
 * algorithm:   runge-kutta-4-quaternion, form factored, q' = q + dq, renormalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = 1/2 q (x) omega; q + h (k1 + 2 k2 + 2 k3 + k4)/6
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
#include "runge_kutta_4_quaternion_float64.h"

#if RUNGE_KUTTA_4_QUATERNION_FLOAT64_VERSION != 1
#error "runge_kutta_4_quaternion_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void runge_kutta_4_quaternion_float64_init(runge_kutta_4_quaternion_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
    state->omega_last[0] = 0.0;
    state->omega_last[1] = 0.0;
    state->omega_last[2] = 0.0;
}

void runge_kutta_4_quaternion_float64_set_quaternion(
    runge_kutta_4_quaternion_float64_state *state, const double q_nb[4])
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

void runge_kutta_4_quaternion_float64_start(
    runge_kutta_4_quaternion_float64_state *state, const double omega[3])
{
    const double omega_x = omega[0];
    const double omega_y = omega[1];
    const double omega_z = omega[2];
    state->omega_last[0] = omega_x;
    state->omega_last[1] = omega_y;
    state->omega_last[2] = omega_z;
}

void runge_kutta_4_quaternion_float64_update(
    runge_kutta_4_quaternion_float64_state *state, const double omega[6])
{
    /* attitude and input */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];
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

    /* g0 = h/2 omega_0 */
    const double g0_x = 0.005 /* 1/200 */ * omega_last_x;
    const double g0_y = 0.005 /* 1/200 */ * omega_last_y;
    const double g0_z = 0.005 /* 1/200 */ * omega_last_z;

    /* g1 = h/2 omega_1 */
    const double g1_x = 0.005 /* 1/200 */ * omega1_x;
    const double g1_y = 0.005 /* 1/200 */ * omega1_y;
    const double g1_z = 0.005 /* 1/200 */ * omega1_z;

    /* g2 = h/2 omega_2 */
    const double g2_x = 0.005 /* 1/200 */ * omega2_x;
    const double g2_y = 0.005 /* 1/200 */ * omega2_y;
    const double g2_z = 0.005 /* 1/200 */ * omega2_z;

    /* k1 = q (x) g0 */
    const double k1_w_negated_1 = q_x * g0_x;
    const double k1_w_negated_2 = q_y * g0_y;
    const double k1_w_negated_3 = q_z * g0_z;
    const double k1_w_negated_4 = k1_w_negated_1 + k1_w_negated_2;
    const double k1_w_negated = k1_w_negated_4 + k1_w_negated_3;
    const double k1_x_1 = q_w * g0_x;
    const double k1_x_2 = q_y * g0_z;
    const double k1_x_3 = q_z * g0_y;
    const double k1_x_4 = k1_x_1 + k1_x_2;
    const double k1_x = k1_x_4 - k1_x_3;
    const double k1_y_1 = q_w * g0_y;
    const double k1_y_2 = q_z * g0_x;
    const double k1_y_3 = q_x * g0_z;
    const double k1_y_4 = k1_y_1 + k1_y_2;
    const double k1_y = k1_y_4 - k1_y_3;
    const double k1_z_1 = q_w * g0_z;
    const double k1_z_2 = q_x * g0_y;
    const double k1_z_3 = q_y * g0_x;
    const double k1_z_4 = k1_z_1 + k1_z_2;
    const double k1_z = k1_z_4 - k1_z_3;

    /* k2 = (q + k1/2) (x) g1 */
    const double k2_x_1 = 0.5 * k1_w_negated;
    const double k2_w_negated_1 = 0.5 * k1_x;
    const double k2_w_negated_2 = 0.5 * k1_y;
    const double k2_w_negated_3 = 0.5 * k1_z;
    const double k2_x_2 = q_w - k2_x_1;
    const double k2_w_negated_4 = q_x + k2_w_negated_1;
    const double k2_w_negated_5 = q_y + k2_w_negated_2;
    const double k2_w_negated_6 = q_z + k2_w_negated_3;
    const double k2_w_negated_7 = k2_w_negated_4 * g1_x;
    const double k2_w_negated_8 = k2_w_negated_5 * g1_y;
    const double k2_w_negated_9 = k2_w_negated_6 * g1_z;
    const double k2_w_negated_10 = k2_w_negated_7 + k2_w_negated_8;
    const double k2_w_negated = k2_w_negated_10 + k2_w_negated_9;
    const double k2_x_3 = k2_x_2 * g1_x;
    const double k2_x_4 = k2_w_negated_5 * g1_z;
    const double k2_x_5 = k2_w_negated_6 * g1_y;
    const double k2_x_6 = k2_x_3 + k2_x_4;
    const double k2_x = k2_x_6 - k2_x_5;
    const double k2_y_1 = k2_x_2 * g1_y;
    const double k2_y_2 = k2_w_negated_6 * g1_x;
    const double k2_y_3 = k2_w_negated_4 * g1_z;
    const double k2_y_4 = k2_y_1 + k2_y_2;
    const double k2_y = k2_y_4 - k2_y_3;
    const double k2_z_1 = k2_x_2 * g1_z;
    const double k2_z_2 = k2_w_negated_4 * g1_y;
    const double k2_z_3 = k2_w_negated_5 * g1_x;
    const double k2_z_4 = k2_z_1 + k2_z_2;
    const double k2_z = k2_z_4 - k2_z_3;

    /* k3 = (q + k2/2) (x) g1 */
    const double k3_x_1 = 0.5 * k2_w_negated;
    const double k3_w_negated_1 = 0.5 * k2_x;
    const double k3_w_negated_2 = 0.5 * k2_y;
    const double k3_w_negated_3 = 0.5 * k2_z;
    const double k3_x_2 = q_w - k3_x_1;
    const double k3_w_negated_4 = q_x + k3_w_negated_1;
    const double k3_w_negated_5 = q_y + k3_w_negated_2;
    const double k3_w_negated_6 = q_z + k3_w_negated_3;
    const double k3_w_negated_7 = k3_w_negated_4 * g1_x;
    const double k3_w_negated_8 = k3_w_negated_5 * g1_y;
    const double k3_w_negated_9 = k3_w_negated_6 * g1_z;
    const double k3_w_negated_10 = k3_w_negated_7 + k3_w_negated_8;
    const double k3_w_negated = k3_w_negated_10 + k3_w_negated_9;
    const double k3_x_3 = k3_x_2 * g1_x;
    const double k3_x_4 = k3_w_negated_5 * g1_z;
    const double k3_x_5 = k3_w_negated_6 * g1_y;
    const double k3_x_6 = k3_x_3 + k3_x_4;
    const double k3_x = k3_x_6 - k3_x_5;
    const double k3_y_1 = k3_x_2 * g1_y;
    const double k3_y_2 = k3_w_negated_6 * g1_x;
    const double k3_y_3 = k3_w_negated_4 * g1_z;
    const double k3_y_4 = k3_y_1 + k3_y_2;
    const double k3_y = k3_y_4 - k3_y_3;
    const double k3_z_1 = k3_x_2 * g1_z;
    const double k3_z_2 = k3_w_negated_4 * g1_y;
    const double k3_z_3 = k3_w_negated_5 * g1_x;
    const double k3_z_4 = k3_z_1 + k3_z_2;
    const double k3_z = k3_z_4 - k3_z_3;

    /* k4 = (q + k3) (x) g2 */
    const double k4_x_1 = q_w - k3_w_negated;
    const double k4_w_negated_1 = q_x + k3_x;
    const double k4_w_negated_2 = q_y + k3_y;
    const double k4_w_negated_3 = q_z + k3_z;
    const double k4_w_negated_4 = k4_w_negated_1 * g2_x;
    const double k4_w_negated_5 = k4_w_negated_2 * g2_y;
    const double k4_w_negated_6 = k4_w_negated_3 * g2_z;
    const double k4_w_negated_7 = k4_w_negated_4 + k4_w_negated_5;
    const double k4_w_negated = k4_w_negated_7 + k4_w_negated_6;
    const double k4_x_2 = k4_x_1 * g2_x;
    const double k4_x_3 = k4_w_negated_2 * g2_z;
    const double k4_x_4 = k4_w_negated_3 * g2_y;
    const double k4_x_5 = k4_x_2 + k4_x_3;
    const double k4_x = k4_x_5 - k4_x_4;
    const double k4_y_1 = k4_x_1 * g2_y;
    const double k4_y_2 = k4_w_negated_3 * g2_x;
    const double k4_y_3 = k4_w_negated_1 * g2_z;
    const double k4_y_4 = k4_y_1 + k4_y_2;
    const double k4_y = k4_y_4 - k4_y_3;
    const double k4_z_1 = k4_x_1 * g2_z;
    const double k4_z_2 = k4_w_negated_1 * g2_y;
    const double k4_z_3 = k4_w_negated_2 * g2_x;
    const double k4_z_4 = k4_z_1 + k4_z_2;
    const double k4_z = k4_z_4 - k4_z_3;

    /* dq = (k1 + k4)/6 + (k2 + k3)/3 */
    const double dq_w_negated_1 = k1_w_negated + k4_w_negated;
    const double dq_x_1 = k1_x + k4_x;
    const double dq_y_1 = k1_y + k4_y;
    const double dq_z_1 = k1_z + k4_z;
    const double dq_w_negated_2 = 0.16666666666666666 /* 1/6 */ * dq_w_negated_1;
    const double dq_x_2 = 0.16666666666666666 /* 1/6 */ * dq_x_1;
    const double dq_y_2 = 0.16666666666666666 /* 1/6 */ * dq_y_1;
    const double dq_z_2 = 0.16666666666666666 /* 1/6 */ * dq_z_1;
    const double dq_w_negated_3 = k2_w_negated + k3_w_negated;
    const double dq_x_3 = k2_x + k3_x;
    const double dq_y_3 = k2_y + k3_y;
    const double dq_z_3 = k2_z + k3_z;
    const double dq_w_negated_4 = 0.3333333333333333 /* 1/3 */ * dq_w_negated_3;
    const double dq_x_4 = 0.3333333333333333 /* 1/3 */ * dq_x_3;
    const double dq_y_4 = 0.3333333333333333 /* 1/3 */ * dq_y_3;
    const double dq_z_4 = 0.3333333333333333 /* 1/3 */ * dq_z_3;
    const double dq_w_negated = dq_w_negated_2 + dq_w_negated_4;
    const double dq_x = dq_x_2 + dq_x_4;
    const double dq_y = dq_y_2 + dq_y_4;
    const double dq_z = dq_z_2 + dq_z_4;

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

    /* dq_e = dq + e q */
    const double dq_e_w_1 = e * q_w;
    const double dq_e_x_1 = e * q_x;
    const double dq_e_y_1 = e * q_y;
    const double dq_e_z_1 = e * q_z;
    const double dq_e_w = dq_e_w_1 - dq_w_negated;
    const double dq_e_x = dq_x + dq_e_x_1;
    const double dq_e_y = dq_y + dq_e_y_1;
    const double dq_e_z = dq_z + dq_e_z_1;

    /* q_next = q + dq */
    const double q_next_w = q_w + dq_e_w;
    const double q_next_x = q_x + dq_e_x;
    const double q_next_y = q_y + dq_e_y;
    const double q_next_z = q_z + dq_e_z;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
    state->omega_last[0] = omega2_x;
    state->omega_last[1] = omega2_y;
    state->omega_last[2] = omega2_z;
}

void runge_kutta_4_quaternion_float64_quaternion(
    const runge_kutta_4_quaternion_float64_state *state, double q_nb[4])
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

void runge_kutta_4_quaternion_float64_dcm(
    const runge_kutta_4_quaternion_float64_state *state, double c_nb[9])
{
    /* q, read once */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const double x2 = q_x + q_x;
    const double y2 = q_y + q_y;
    const double z2 = q_z + q_z;
    const double wx = q_w * x2;
    const double wy = q_w * y2;
    const double wz = q_w * z2;
    const double xx = q_x * x2;
    const double xy = q_x * y2;
    const double xz = q_x * z2;
    const double yy = q_y * y2;
    const double yz = q_y * z2;
    const double zz = q_z * z2;

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
