/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_previous_5_float64
 *
 * qcone 0.1.0, design rotation_vector_1_previous_5_float64, SHA-256 of the design
 * 59e512ddce52a6e98ad364fc1d33de92f09b8ab90052faef053b94a909adf345
 *
 * algorithm:   rotation-vector-1-previous-5, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      savage1998 (46)
 * equation:    phi = theta + (4247/27720 theta[-1] - 703/13860 theta[-2] + 61/4620 theta[-3] -
 *              31/13860 theta[-4] + 1/5544 theta[-5]) x theta
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1023 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *              4.3e-22 (scalar), 4.5e-20 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * start_up as-written       34       0   22         7       0       0     0     0     0       0
 * start_up shared           33       1   22         7       0       0     0     0     0       0
 * start_up emitted          33       1   22         7       0       0     0     0     0       0
 * steady as-written         55       0   37        10       0       0     0     0     0       0
 * steady shared             54       1   37        10       0       0     0     0     0       0
 * steady emitted            54       1   37        10       0       0     0     0     0       0
 * dcm as-written             9       0    9         6       0       0     0     0     0       0
 * dcm shared                 9       0    9         6       0       0     0     0     0       0
 * dcm emitted                9       0    9         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_1_previous_5_float64.h"

#if ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_VERSION != 1
#error "rotation_vector_1_previous_5_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_1_previous_5_float64_init(rotation_vector_1_previous_5_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
    state->previous[0] = 0.0;
    state->previous[1] = 0.0;
    state->previous[2] = 0.0;
    state->previous[3] = 0.0;
    state->previous[4] = 0.0;
    state->previous[5] = 0.0;
    state->previous[6] = 0.0;
    state->previous[7] = 0.0;
    state->previous[8] = 0.0;
    state->previous[9] = 0.0;
    state->previous[10] = 0.0;
    state->previous[11] = 0.0;
    state->previous[12] = 0.0;
    state->previous[13] = 0.0;
    state->previous[14] = 0.0;
    state->count = 0;
}

void rotation_vector_1_previous_5_float64_set_quaternion(
    rotation_vector_1_previous_5_float64_state *state, const double q_nb[4])
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
    state->previous[0] = 0.0;
    state->previous[1] = 0.0;
    state->previous[2] = 0.0;
    state->previous[3] = 0.0;
    state->previous[4] = 0.0;
    state->previous[5] = 0.0;
    state->previous[6] = 0.0;
    state->previous[7] = 0.0;
    state->previous[8] = 0.0;
    state->previous[9] = 0.0;
    state->previous[10] = 0.0;
    state->previous[11] = 0.0;
    state->previous[12] = 0.0;
    state->previous[13] = 0.0;
    state->previous[14] = 0.0;
    state->count = 0;
}

static void rotation_vector_1_previous_5_float64_start_up(
    rotation_vector_1_previous_5_float64_state *state, const double dtheta[3])
{
    /* attitude and input */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];
    const double dtheta_x = dtheta[0];
    const double dtheta_y = dtheta[1];
    const double dtheta_z = dtheta[2];

    /* earlier angle increments, newest first, rad, sensor axes */
    const double previous1_x = state->previous[0];
    const double previous1_y = state->previous[1];
    const double previous1_z = state->previous[2];
    const double previous2_x = state->previous[3];
    const double previous2_y = state->previous[4];
    const double previous2_z = state->previous[5];
    const double previous3_x = state->previous[6];
    const double previous3_y = state->previous[7];
    const double previous3_z = state->previous[8];
    const double previous4_x = state->previous[9];
    const double previous4_y = state->previous[10];
    const double previous4_z = state->previous[11];

    /* phi_square = |phi|^2 */
    const double phi_square_1 = dtheta_x * dtheta_x;
    const double phi_square_2 = dtheta_y * dtheta_y;
    const double phi_square_3 = dtheta_z * dtheta_z;
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
    const double v_x = s * dtheta_x;
    const double v_y = s * dtheta_y;
    const double v_z = s * dtheta_z;

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
    state->previous[0] = dtheta_x;
    state->previous[1] = dtheta_y;
    state->previous[2] = dtheta_z;
    state->previous[3] = previous1_x;
    state->previous[4] = previous1_y;
    state->previous[5] = previous1_z;
    state->previous[6] = previous2_x;
    state->previous[7] = previous2_y;
    state->previous[8] = previous2_z;
    state->previous[9] = previous3_x;
    state->previous[10] = previous3_y;
    state->previous[11] = previous3_z;
    state->previous[12] = previous4_x;
    state->previous[13] = previous4_y;
    state->previous[14] = previous4_z;
    state->count = state->count + 1;
}

static void rotation_vector_1_previous_5_float64_steady(
    rotation_vector_1_previous_5_float64_state *state, const double dtheta[3])
{
    /* attitude and input */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];
    const double dtheta_x = dtheta[0];
    const double dtheta_y = dtheta[1];
    const double dtheta_z = dtheta[2];

    /* earlier angle increments, newest first, rad, sensor axes */
    const double previous1_x = state->previous[0];
    const double previous1_y = state->previous[1];
    const double previous1_z = state->previous[2];
    const double previous2_x = state->previous[3];
    const double previous2_y = state->previous[4];
    const double previous2_z = state->previous[5];
    const double previous3_x = state->previous[6];
    const double previous3_y = state->previous[7];
    const double previous3_z = state->previous[8];
    const double previous4_x = state->previous[9];
    const double previous4_y = state->previous[10];
    const double previous4_z = state->previous[11];
    const double previous5_x = state->previous[12];
    const double previous5_y = state->previous[13];
    const double previous5_z = state->previous[14];

    /* h = 4247/27720 theta[-1] - 703/13860 theta[-2] + 61/4620 theta[-3] - 31/13860 theta[-4] + 1/5544
     * theta[-5]   [savage1998 (46)] */
    const double h_x_1 = 0.15321067821067821 /* 4247/27720 */ * previous1_x;
    const double h_y_1 = 0.15321067821067821 /* 4247/27720 */ * previous1_y;
    const double h_z_1 = 0.15321067821067821 /* 4247/27720 */ * previous1_z;
    const double h_x_2 = -0.05072150072150072 /* -703/13860 */ * previous2_x;
    const double h_y_2 = -0.05072150072150072 /* -703/13860 */ * previous2_y;
    const double h_z_2 = -0.05072150072150072 /* -703/13860 */ * previous2_z;
    const double h_x_3 = h_x_1 + h_x_2;
    const double h_y_3 = h_y_1 + h_y_2;
    const double h_z_3 = h_z_1 + h_z_2;
    const double h_x_4 = 0.013203463203463203 /* 61/4620 */ * previous3_x;
    const double h_y_4 = 0.013203463203463203 /* 61/4620 */ * previous3_y;
    const double h_z_4 = 0.013203463203463203 /* 61/4620 */ * previous3_z;
    const double h_x_5 = h_x_3 + h_x_4;
    const double h_y_5 = h_y_3 + h_y_4;
    const double h_z_5 = h_z_3 + h_z_4;
    const double h_x_6 = -0.002236652236652237 /* -31/13860 */ * previous4_x;
    const double h_y_6 = -0.002236652236652237 /* -31/13860 */ * previous4_y;
    const double h_z_6 = -0.002236652236652237 /* -31/13860 */ * previous4_z;
    const double h_x_7 = h_x_5 + h_x_6;
    const double h_y_7 = h_y_5 + h_y_6;
    const double h_z_7 = h_z_5 + h_z_6;
    const double h_x_8 = 0.00018037518037518038 /* 1/5544 */ * previous5_x;
    const double h_y_8 = 0.00018037518037518038 /* 1/5544 */ * previous5_y;
    const double h_z_8 = 0.00018037518037518038 /* 1/5544 */ * previous5_z;
    const double h_x = h_x_7 + h_x_8;
    const double h_y = h_y_7 + h_y_8;
    const double h_z = h_z_7 + h_z_8;

    /* coning = h x theta   [savage1998 (46)] */
    const double coning_x_1 = h_y * dtheta_z;
    const double coning_x_2 = h_z * dtheta_y;
    const double coning_x = coning_x_1 - coning_x_2;
    const double coning_y_1 = h_z * dtheta_x;
    const double coning_y_2 = h_x * dtheta_z;
    const double coning_y = coning_y_1 - coning_y_2;
    const double coning_z_1 = h_x * dtheta_y;
    const double coning_z_2 = h_y * dtheta_x;
    const double coning_z = coning_z_1 - coning_z_2;

    /* phi = theta + coning   [savage1998 (46)] */
    const double phi_x = dtheta_x + coning_x;
    const double phi_y = dtheta_y + coning_y;
    const double phi_z = dtheta_z + coning_z;

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
    state->previous[0] = dtheta_x;
    state->previous[1] = dtheta_y;
    state->previous[2] = dtheta_z;
    state->previous[3] = previous1_x;
    state->previous[4] = previous1_y;
    state->previous[5] = previous1_z;
    state->previous[6] = previous2_x;
    state->previous[7] = previous2_y;
    state->previous[8] = previous2_z;
    state->previous[9] = previous3_x;
    state->previous[10] = previous3_y;
    state->previous[11] = previous3_z;
    state->previous[12] = previous4_x;
    state->previous[13] = previous4_y;
    state->previous[14] = previous4_z;
}

void rotation_vector_1_previous_5_float64_update(
    rotation_vector_1_previous_5_float64_state *state, const double dtheta[3])
{
    /* the history is full after 5 updates */
    if (state->count < 5) {
        rotation_vector_1_previous_5_float64_start_up(state, dtheta);
    } else {
        rotation_vector_1_previous_5_float64_steady(state, dtheta);
    }
}

void rotation_vector_1_previous_5_float64_quaternion(
    const rotation_vector_1_previous_5_float64_state *state, double q_nb[4])
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

void rotation_vector_1_previous_5_float64_dcm(
    const rotation_vector_1_previous_5_float64_state *state, double c_nb[9])
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
