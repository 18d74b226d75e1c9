/* Generated, do not edit. Made by: qcone generate picard.toml --design picard_1_3_as_written_float64
 *
 * qcone 0.1.0, design picard_1_3_as_written_float64, SHA-256 of the design
 * a93ed6d583cdd04624bb5ac7eab19ccaa25ec9259445c879d7d79ba74592cab1
 *
 * algorithm:   picard-3, form as-written, q' = q (x) r, not renormalised
 * source:      cao (7), (8), (9)
 * equation:    r = [a_c, a_s sigma], sigma = theta
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; beyond
 *              it nothing is bounded: accuracy is lost and, far beyond it, the state can diverge
 *              to NaN for good, so clamp inputs that can be so large; setting the attitude anew
 *              brings it back
 * truncation:  series of the algorithm's order in |phi|; error of r at most 2.6e-07 (scalar),
 *              2.6e-09 (vector)
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       26       0   14         2       6       0     0     0     0       0
 * update shared           23       3    8         8       0       0     0     0     0       0
 * update emitted          23       3    8         8       0       0     0     0     0       0
 * dcm as-written          30       0    6         9       0       0     0     0     0       0
 * dcm shared              10       6    6         8       0       0     0     0     0       0
 * dcm emitted             10       6    6         8       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "picard_1_3_as_written_float64.h"

#if PICARD_1_3_AS_WRITTEN_FLOAT64_VERSION != 1
#error "picard_1_3_as_written_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void picard_1_3_as_written_float64_init(picard_1_3_as_written_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void picard_1_3_as_written_float64_set_quaternion(
    picard_1_3_as_written_float64_state *state, const double q_nb[4])
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

void picard_1_3_as_written_float64_update(
    picard_1_3_as_written_float64_state *state, const double dtheta[3])
{
    /* attitude and input */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];
    const double dtheta_x = dtheta[0];
    const double dtheta_y = dtheta[1];
    const double dtheta_z = dtheta[2];

    /* h = 1/4 |sigma|^2   [cao (9)] */
    const double h_1 = dtheta_x * dtheta_x;
    const double h_2 = dtheta_y * dtheta_y;
    const double h_3 = dtheta_z * dtheta_z;
    const double h_4 = h_1 + h_2;
    const double h_5 = h_4 + h_3;
    const double h = 0.25 * h_5;

    /* a_c = cos(|sigma|/2), series   [cao (9)] */
    const double a_c_1 = 0.5 * h;
    const double a_c = 1.0 - a_c_1;

    /* a_s = sin(|sigma|/2)/|sigma|, series   [cao (9)] */
    const double a_s_1 = 0.16666666666666666 /* 1/6 */ * h;
    const double a_s_2 = 1.0 - a_s_1;
    const double a_s = 0.5 * a_s_2;

    /* r = [a_c, a_s sigma]   [cao (9)] */
    const double r_x = a_s * dtheta_x;
    const double r_y = a_s * dtheta_y;
    const double r_z = a_s * dtheta_z;

    /* q_next = q (x) r */
    const double q_next_w_1 = q_w * a_c;
    const double q_next_w_2 = q_x * r_x;
    const double q_next_w_3 = q_y * r_y;
    const double q_next_w_4 = q_z * r_z;
    const double q_next_w_5 = q_next_w_1 - q_next_w_2;
    const double q_next_w_6 = q_next_w_5 - q_next_w_3;
    const double q_next_w = q_next_w_6 - q_next_w_4;
    const double q_next_x_1 = q_x * a_c;
    const double q_next_x_2 = q_w * r_x;
    const double q_next_x_3 = q_z * r_y;
    const double q_next_x_4 = q_y * r_z;
    const double q_next_x_5 = q_next_x_1 + q_next_x_2;
    const double q_next_x_6 = q_next_x_5 - q_next_x_3;
    const double q_next_x = q_next_x_6 + q_next_x_4;
    const double q_next_y_1 = q_y * a_c;
    const double q_next_y_2 = q_z * r_x;
    const double q_next_y_3 = q_w * r_y;
    const double q_next_y_4 = q_x * r_z;
    const double q_next_y_5 = q_next_y_1 + q_next_y_2;
    const double q_next_y_6 = q_next_y_5 + q_next_y_3;
    const double q_next_y = q_next_y_6 - q_next_y_4;
    const double q_next_z_1 = q_z * a_c;
    const double q_next_z_2 = q_y * r_x;
    const double q_next_z_3 = q_x * r_y;
    const double q_next_z_4 = q_w * r_z;
    const double q_next_z_5 = q_next_z_1 - q_next_z_2;
    const double q_next_z_6 = q_next_z_5 + q_next_z_3;
    const double q_next_z = q_next_z_6 + q_next_z_4;

    /* store */
    state->q[0] = q_next_w;
    state->q[1] = q_next_x;
    state->q[2] = q_next_y;
    state->q[3] = q_next_z;
}

void picard_1_3_as_written_float64_quaternion(
    const picard_1_3_as_written_float64_state *state, double q_nb[4])
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

void picard_1_3_as_written_float64_dcm(const picard_1_3_as_written_float64_state *state, double c_nb[9])
{
    /* q, read once */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];

    /* c_nb = C_nb(q)   [cao (5)] */
    const double c_nb_11_1 = q_w * q_w;
    const double c_nb_11_2 = q_x * q_x;
    const double c_nb_11_3 = c_nb_11_1 + c_nb_11_2;
    const double c_nb_11_4 = q_y * q_y;
    const double c_nb_11_5 = c_nb_11_3 - c_nb_11_4;
    const double c_nb_11_6 = q_z * q_z;
    const double c_nb_11 = c_nb_11_5 - c_nb_11_6;
    const double c_nb_12_1 = q_x * q_y;
    const double c_nb_12_2 = q_w * q_z;
    const double c_nb_12_3 = c_nb_12_1 - c_nb_12_2;
    const double c_nb_12 = 2.0 * c_nb_12_3;
    const double c_nb_13_1 = q_x * q_z;
    const double c_nb_13_2 = q_w * q_y;
    const double c_nb_13_3 = c_nb_13_1 + c_nb_13_2;
    const double c_nb_13 = 2.0 * c_nb_13_3;
    const double c_nb_21_1 = c_nb_12_1 + c_nb_12_2;
    const double c_nb_21 = 2.0 * c_nb_21_1;
    const double c_nb_22_1 = c_nb_11_1 - c_nb_11_2;
    const double c_nb_22_2 = c_nb_22_1 + c_nb_11_4;
    const double c_nb_22 = c_nb_22_2 - c_nb_11_6;
    const double c_nb_23_1 = q_y * q_z;
    const double c_nb_23_2 = q_w * q_x;
    const double c_nb_23_3 = c_nb_23_1 - c_nb_23_2;
    const double c_nb_23 = 2.0 * c_nb_23_3;
    const double c_nb_31_1 = c_nb_13_1 - c_nb_13_2;
    const double c_nb_31 = 2.0 * c_nb_31_1;
    const double c_nb_32_1 = c_nb_23_1 + c_nb_23_2;
    const double c_nb_32 = 2.0 * c_nb_32_1;
    const double c_nb_33_1 = c_nb_22_1 - c_nb_11_4;
    const double c_nb_33 = c_nb_33_1 + c_nb_11_6;

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
