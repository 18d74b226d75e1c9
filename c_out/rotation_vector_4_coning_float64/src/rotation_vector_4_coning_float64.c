/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_4_coning_float64
 *
 * qcone 0.1.0, design rotation_vector_4_coning_float64, SHA-256 of the design
 * c75810ded387f3a57993ddc0f8a762859065488e9d418a53146553c59ba0e3c0
 *
 * algorithm:   rotation-vector-4-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + theta_4 + sum k_ij theta_i x theta_j
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.025002 rad; |phi|
 *              <= 0.1022 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *              3.9e-22 (scalar), 4.7e-20 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       58       0   43        19       0       0     0     0     0       0
 * update shared           57       1   43        19       0       0     0     0     0       0
 * update emitted          57       1   43        19       0       0     0     0     0       0
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
#include "rotation_vector_4_coning_float64.h"

#if ROTATION_VECTOR_4_CONING_FLOAT64_VERSION != 1
#error "rotation_vector_4_coning_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_4_coning_float64_init(rotation_vector_4_coning_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void rotation_vector_4_coning_float64_set_quaternion(
    rotation_vector_4_coning_float64_state *state, const double q_nb[4])
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

void rotation_vector_4_coning_float64_update(
    rotation_vector_4_coning_float64_state *state, const double dtheta[12])
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
    const double dtheta4_x = dtheta[9];
    const double dtheta4_y = dtheta[10];
    const double dtheta4_z = dtheta[11];

    /* p1 = theta_1 + theta_4 */
    const double p1_x = dtheta1_x + dtheta4_x;
    const double p1_y = dtheta1_y + dtheta4_y;
    const double p1_z = dtheta1_z + dtheta4_z;

    /* p2 = theta_2 + theta_3 */
    const double p2_x = dtheta2_x + dtheta3_x;
    const double p2_y = dtheta2_y + dtheta3_y;
    const double p2_z = dtheta2_z + dtheta3_z;

    /* d1 = theta_4 - theta_1 */
    const double d1_x = dtheta4_x - dtheta1_x;
    const double d1_y = dtheta4_y - dtheta1_y;
    const double d1_z = dtheta4_z - dtheta1_z;

    /* d2 = theta_3 - theta_2 */
    const double d2_x = dtheta3_x - dtheta2_x;
    const double d2_y = dtheta3_y - dtheta2_y;
    const double d2_z = dtheta3_z - dtheta2_z;

    /* S = p1 + p2 */
    const double S_x = p1_x + p2_x;
    const double S_y = p1_y + p2_y;
    const double S_z = p1_z + p2_z;

    /* g1 = 9/35 p1 + 176/315 p2   [cao (12)] */
    const double g1_x_1 = 0.2571428571428571 /* 9/35 */ * p1_x;
    const double g1_y_1 = 0.2571428571428571 /* 9/35 */ * p1_y;
    const double g1_z_1 = 0.2571428571428571 /* 9/35 */ * p1_z;
    const double g1_x_2 = 0.5587301587301587 /* 176/315 */ * p2_x;
    const double g1_y_2 = 0.5587301587301587 /* 176/315 */ * p2_y;
    const double g1_z_2 = 0.5587301587301587 /* 176/315 */ * p2_z;
    const double g1_x = g1_x_1 + g1_x_2;
    const double g1_y = g1_y_1 + g1_y_2;
    const double g1_z = g1_z_1 + g1_z_2;

    /* coning1 = g1 x d1   [cao (12)] */
    const double coning1_x_1 = g1_y * d1_z;
    const double coning1_x_2 = g1_z * d1_y;
    const double coning1_x = coning1_x_1 - coning1_x_2;
    const double coning1_y_1 = g1_z * d1_x;
    const double coning1_y_2 = g1_x * d1_z;
    const double coning1_y = coning1_y_1 - coning1_y_2;
    const double coning1_z_1 = g1_x * d1_y;
    const double coning1_z_2 = g1_y * d1_x;
    const double coning1_z = coning1_z_1 - coning1_z_2;

    /* g2 = -38/315 p1 + 107/315 p2   [cao (12)] */
    const double g2_x_1 = -0.12063492063492064 /* -38/315 */ * p1_x;
    const double g2_y_1 = -0.12063492063492064 /* -38/315 */ * p1_y;
    const double g2_z_1 = -0.12063492063492064 /* -38/315 */ * p1_z;
    const double g2_x_2 = 0.3396825396825397 /* 107/315 */ * p2_x;
    const double g2_y_2 = 0.3396825396825397 /* 107/315 */ * p2_y;
    const double g2_z_2 = 0.3396825396825397 /* 107/315 */ * p2_z;
    const double g2_x = g2_x_1 + g2_x_2;
    const double g2_y = g2_y_1 + g2_y_2;
    const double g2_z = g2_z_1 + g2_z_2;

    /* coning2 = g2 x d2   [cao (12)] */
    const double coning2_x_1 = g2_y * d2_z;
    const double coning2_x_2 = g2_z * d2_y;
    const double coning2_x = coning2_x_1 - coning2_x_2;
    const double coning2_y_1 = g2_z * d2_x;
    const double coning2_y_2 = g2_x * d2_z;
    const double coning2_y = coning2_y_1 - coning2_y_2;
    const double coning2_z_1 = g2_x * d2_y;
    const double coning2_z_2 = g2_y * d2_x;
    const double coning2_z = coning2_z_1 - coning2_z_2;

    /* coning = coning1 + coning2   [cao (12)] */
    const double coning_x = coning1_x + coning2_x;
    const double coning_y = coning1_y + coning2_y;
    const double coning_z = coning1_z + coning2_z;

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
    const double u_1 = phi_square * 9.687435851010724e-08 /* 1/10322649 */;
    const double u_2 = -2.1701388828587957e-05 /* -7810/359884801 */ + u_1;
    const double u_3 = phi_square * u_2;
    const double u_4 = 0.0026041666666664566 /* 32316515852/12409542087169 */ + u_3;
    const double u_5 = phi_square * u_4;
    const double u_6 = -0.125 /* -64094872084675474/512758976677403793 */ + u_5;
    const double u = phi_square * u_6;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const double s_1 = phi_square * -1.5499840403309981e-06 /* -15/9677519 */;
    const double s_2 = 0.0002604166658988651 /* 88326/339171841 */ + s_1;
    const double s_3 = phi_square * s_2;
    const double s_4 = -0.02083333333333179 /* -281004159393/13488199650865 */ + s_3;
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

void rotation_vector_4_coning_float64_quaternion(
    const rotation_vector_4_coning_float64_state *state, double q_nb[4])
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

void rotation_vector_4_coning_float64_dcm(
    const rotation_vector_4_coning_float64_state *state, double c_nb[9])
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
