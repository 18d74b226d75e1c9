/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_6_expanded_float64
 *
 * qcone 0.1.0, design rotation_vector_6_expanded_float64, SHA-256 of the design
 * 3fb1e249a14ccf3d0b36825e68879196d249440bd076affa6f86ff15410bde4b
 *
 * algorithm:   rotation-vector-6-expanded, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      song2013 expanded coning, derived here, cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + theta_4 + theta_5 + theta_6 + sum k_ij theta_i
 *              x theta_j
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.016668 rad; |phi|
 *              <= 0.1023 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *              4.3e-22 (scalar), 4.5e-20 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       79       0   64        25       0       0     0     0     0       0
 * update shared           78       1   64        25       0       0     0     0     0       0
 * update emitted          78       1   64        25       0       0     0     0     0       0
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
#include "rotation_vector_6_expanded_float64.h"

#if ROTATION_VECTOR_6_EXPANDED_FLOAT64_VERSION != 1
#error "rotation_vector_6_expanded_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_6_expanded_float64_init(rotation_vector_6_expanded_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
}

void rotation_vector_6_expanded_float64_set_quaternion(
    rotation_vector_6_expanded_float64_state *state, const double q_nb[4])
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

void rotation_vector_6_expanded_float64_update(
    rotation_vector_6_expanded_float64_state *state, const double dtheta[18])
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
    const double dtheta5_x = dtheta[12];
    const double dtheta5_y = dtheta[13];
    const double dtheta5_z = dtheta[14];
    const double dtheta6_x = dtheta[15];
    const double dtheta6_y = dtheta[16];
    const double dtheta6_z = dtheta[17];

    /* p1 = theta_1 + theta_6 */
    const double p1_x = dtheta1_x + dtheta6_x;
    const double p1_y = dtheta1_y + dtheta6_y;
    const double p1_z = dtheta1_z + dtheta6_z;

    /* p2 = theta_2 + theta_5 */
    const double p2_x = dtheta2_x + dtheta5_x;
    const double p2_y = dtheta2_y + dtheta5_y;
    const double p2_z = dtheta2_z + dtheta5_z;

    /* p3 = theta_3 + theta_4 */
    const double p3_x = dtheta3_x + dtheta4_x;
    const double p3_y = dtheta3_y + dtheta4_y;
    const double p3_z = dtheta3_z + dtheta4_z;

    /* d1 = theta_6 - theta_1 */
    const double d1_x = dtheta6_x - dtheta1_x;
    const double d1_y = dtheta6_y - dtheta1_y;
    const double d1_z = dtheta6_z - dtheta1_z;

    /* d2 = theta_5 - theta_2 */
    const double d2_x = dtheta5_x - dtheta2_x;
    const double d2_y = dtheta5_y - dtheta2_y;
    const double d2_z = dtheta5_z - dtheta2_z;

    /* d3 = theta_4 - theta_3 */
    const double d3_x = dtheta4_x - dtheta3_x;
    const double d3_y = dtheta4_y - dtheta3_y;
    const double d3_z = dtheta4_z - dtheta3_z;

    /* S = p1 + p2 + p3 */
    const double S_x_1 = p1_x + p2_x;
    const double S_y_1 = p1_y + p2_y;
    const double S_z_1 = p1_z + p2_z;
    const double S_x = S_x_1 + p3_x;
    const double S_y = S_y_1 + p3_y;
    const double S_z = S_z_1 + p3_z;

    /* g1 = 463/1848 p1 + 62957/92400 p2 + 38963/92400 p3   [song2013 expanded coning, derived here] */
    const double g1_x_1 = 0.25054112554112556 /* 463/1848 */ * p1_x;
    const double g1_y_1 = 0.25054112554112556 /* 463/1848 */ * p1_y;
    const double g1_z_1 = 0.25054112554112556 /* 463/1848 */ * p1_z;
    const double g1_x_2 = 0.6813528138528139 /* 62957/92400 */ * p2_x;
    const double g1_y_2 = 0.6813528138528139 /* 62957/92400 */ * p2_y;
    const double g1_z_2 = 0.6813528138528139 /* 62957/92400 */ * p2_z;
    const double g1_x_3 = g1_x_1 + g1_x_2;
    const double g1_y_3 = g1_y_1 + g1_y_2;
    const double g1_z_3 = g1_z_1 + g1_z_2;
    const double g1_x_4 = 0.42167748917748915 /* 38963/92400 */ * p3_x;
    const double g1_y_4 = 0.42167748917748915 /* 38963/92400 */ * p3_y;
    const double g1_z_4 = 0.42167748917748915 /* 38963/92400 */ * p3_z;
    const double g1_x = g1_x_3 + g1_x_4;
    const double g1_y = g1_y_3 + g1_y_4;
    const double g1_z = g1_z_3 + g1_z_4;

    /* coning1 = g1 x d1   [song2013 expanded coning, derived here] */
    const double coning1_x_1 = g1_y * d1_z;
    const double coning1_x_2 = g1_z * d1_y;
    const double coning1_x = coning1_x_1 - coning1_x_2;
    const double coning1_y_1 = g1_z * d1_x;
    const double coning1_y_2 = g1_x * d1_z;
    const double coning1_y = coning1_y_1 - coning1_y_2;
    const double coning1_z_1 = g1_x * d1_y;
    const double coning1_z_2 = g1_y * d1_x;
    const double coning1_z = coning1_z_1 - coning1_z_2;

    /* g2 = -17377/92400 p1 + 587/3300 p2 + 54731/92400 p3   [song2013 expanded coning, derived here] */
    const double g2_x_1 = -0.18806277056277057 /* -17377/92400 */ * p1_x;
    const double g2_y_1 = -0.18806277056277057 /* -17377/92400 */ * p1_y;
    const double g2_z_1 = -0.18806277056277057 /* -17377/92400 */ * p1_z;
    const double g2_x_2 = 0.1778787878787879 /* 587/3300 */ * p2_x;
    const double g2_y_2 = 0.1778787878787879 /* 587/3300 */ * p2_y;
    const double g2_z_2 = 0.1778787878787879 /* 587/3300 */ * p2_z;
    const double g2_x_3 = g2_x_1 + g2_x_2;
    const double g2_y_3 = g2_y_1 + g2_y_2;
    const double g2_z_3 = g2_z_1 + g2_z_2;
    const double g2_x_4 = 0.5923268398268399 /* 54731/92400 */ * p3_x;
    const double g2_y_4 = 0.5923268398268399 /* 54731/92400 */ * p3_y;
    const double g2_z_4 = 0.5923268398268399 /* 54731/92400 */ * p3_z;
    const double g2_x = g2_x_3 + g2_x_4;
    const double g2_y = g2_y_3 + g2_y_4;
    const double g2_z = g2_z_3 + g2_z_4;

    /* coning2 = g2 x d2   [song2013 expanded coning, derived here] */
    const double coning2_x_1 = g2_y * d2_z;
    const double coning2_x_2 = g2_z * d2_y;
    const double coning2_x = coning2_x_1 - coning2_x_2;
    const double coning2_y_1 = g2_z * d2_x;
    const double coning2_y_2 = g2_x * d2_z;
    const double coning2_y = coning2_y_1 - coning2_y_2;
    const double coning2_z_1 = g2_x * d2_y;
    const double coning2_z_2 = g2_y * d2_x;
    const double coning2_z = coning2_z_1 - coning2_z_2;

    /* g3 = 17561/92400 p1 + 2207/92400 p2 + 3139/11550 p3   [song2013 expanded coning, derived here] */
    const double coning_x_1 = coning1_x + coning2_x;
    const double coning_y_1 = coning1_y + coning2_y;
    const double coning_z_1 = coning1_z + coning2_z;
    const double g3_x_1 = 0.19005411255411256 /* 17561/92400 */ * p1_x;
    const double g3_y_1 = 0.19005411255411256 /* 17561/92400 */ * p1_y;
    const double g3_z_1 = 0.19005411255411256 /* 17561/92400 */ * p1_z;
    const double g3_x_2 = 0.023885281385281384 /* 2207/92400 */ * p2_x;
    const double g3_y_2 = 0.023885281385281384 /* 2207/92400 */ * p2_y;
    const double g3_z_2 = 0.023885281385281384 /* 2207/92400 */ * p2_z;
    const double g3_x_3 = g3_x_1 + g3_x_2;
    const double g3_y_3 = g3_y_1 + g3_y_2;
    const double g3_z_3 = g3_z_1 + g3_z_2;
    const double g3_x_4 = 0.2717748917748918 /* 3139/11550 */ * p3_x;
    const double g3_y_4 = 0.2717748917748918 /* 3139/11550 */ * p3_y;
    const double g3_z_4 = 0.2717748917748918 /* 3139/11550 */ * p3_z;
    const double g3_x = g3_x_3 + g3_x_4;
    const double g3_y = g3_y_3 + g3_y_4;
    const double g3_z = g3_z_3 + g3_z_4;

    /* coning3 = g3 x d3   [song2013 expanded coning, derived here] */
    const double coning3_x_1 = g3_y * d3_z;
    const double coning3_x_2 = g3_z * d3_y;
    const double coning3_x = coning3_x_1 - coning3_x_2;
    const double coning3_y_1 = g3_z * d3_x;
    const double coning3_y_2 = g3_x * d3_z;
    const double coning3_y = coning3_y_1 - coning3_y_2;
    const double coning3_z_1 = g3_x * d3_y;
    const double coning3_z_2 = g3_y * d3_x;
    const double coning3_z = coning3_z_1 - coning3_z_2;

    /* coning = coning1 + coning2 + coning3   [song2013 expanded coning, derived here] */
    const double coning_x = coning_x_1 + coning3_x;
    const double coning_y = coning_y_1 + coning3_y;
    const double coning_z = coning_z_1 + coning3_z;

    /* phi = S + coning   [song2013 expanded coning, derived here] */
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
    const double u_1 = phi_square * 9.687434912546681e-08 /* 1/10322650 */;
    const double u_2 = -2.1701388828355433e-05 /* -7780/358502401 */ + u_1;
    const double u_3 = phi_square * u_2;
    const double u_4 = 0.0026041666666664558 /* 32130334250/12338048352001 */ + u_3;
    const double u_5 = phi_square * u_4;
    const double u_6 = -0.125 /* -63646874136909427/509174993095275417 */ + u_5;
    const double u = phi_square * u_6;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const double s_1 = phi_square * -1.549983661763129e-06 /* -11/7096849 */;
    const double s_2 = 0.0002604166658958631 /* 87982/337850881 */ + s_1;
    const double s_3 = phi_square * s_2;
    const double s_4 = -0.02083333333333178 /* -279373508848/13409928424705 */ + s_3;
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

void rotation_vector_6_expanded_float64_quaternion(
    const rotation_vector_6_expanded_float64_state *state, double q_nb[4])
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

void rotation_vector_6_expanded_float64_dcm(
    const rotation_vector_6_expanded_float64_state *state, double c_nb[9])
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
