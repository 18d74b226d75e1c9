/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_float64
 *
 * qcone 0.1.0, design rotation_vector_3_coning_float64, SHA-256 of the design
 * c3a585f38c749d8e32eeb3497e5f9107010431c8fd234467bce7ff94e86f819e
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
#include "rotation_vector_3_coning_float64.h"

#if ROTATION_VECTOR_3_CONING_FLOAT64_VERSION != 1
#error "rotation_vector_3_coning_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_3_coning_float64_init(rotation_vector_3_coning_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void rotation_vector_3_coning_float64_set_quaternion(
    rotation_vector_3_coning_float64_state *state, const double q_nb[4])
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

void rotation_vector_3_coning_float64_update(
    rotation_vector_3_coning_float64_state *state, const double dtheta[9])
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

void rotation_vector_3_coning_float64_quaternion(
    const rotation_vector_3_coning_float64_state *state, double q_nb[4])
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

void rotation_vector_3_coning_float64_dcm(
    const rotation_vector_3_coning_float64_state *state, double c_nb[9])
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
