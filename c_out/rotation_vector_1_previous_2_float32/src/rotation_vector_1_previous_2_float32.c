/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_previous_2_float32
 *
 * qcone 0.1.0, design rotation_vector_1_previous_2_float32, SHA-256 of the design
 * be6c0c8fa61f0e997731eddc55992cd8598e57976fa0f5a6efee5e66c99bcfa7
 *
 * algorithm:   rotation-vector-1-previous-2, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      savage1998 (46)
 * equation:    phi = theta + (7/60 theta[-1] - 1/60 theta[-2]) x theta
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1014 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              1e-12 (scalar), 3.7e-10 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * start_up as-written       30       0   18         7       0       0     0     0     0       0
 * start_up shared           29       1   18         7       0       0     0     0     0       0
 * start_up emitted          29       1   18         7       0       0     0     0     0       0
 * steady as-written         42       0   24        10       0       0     0     0     0       0
 * steady shared             41       1   24        10       0       0     0     0     0       0
 * steady emitted            41       1   24        10       0       0     0     0     0       0
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
#include "rotation_vector_1_previous_2_float32.h"

#if ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_VERSION != 1
#error "rotation_vector_1_previous_2_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_1_previous_2_float32_init(rotation_vector_1_previous_2_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
    state->previous[0] = 0.0F;
    state->previous[1] = 0.0F;
    state->previous[2] = 0.0F;
    state->previous[3] = 0.0F;
    state->previous[4] = 0.0F;
    state->previous[5] = 0.0F;
    state->count = 0;
}

void rotation_vector_1_previous_2_float32_set_quaternion(
    rotation_vector_1_previous_2_float32_state *state, const float q_nb[4])
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
    state->previous[0] = 0.0F;
    state->previous[1] = 0.0F;
    state->previous[2] = 0.0F;
    state->previous[3] = 0.0F;
    state->previous[4] = 0.0F;
    state->previous[5] = 0.0F;
    state->count = 0;
}

static void rotation_vector_1_previous_2_float32_start_up(
    rotation_vector_1_previous_2_float32_state *state, const float dtheta[3])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float dtheta_x = dtheta[0];
    const float dtheta_y = dtheta[1];
    const float dtheta_z = dtheta[2];

    /* earlier angle increments, newest first, rad, sensor axes */
    const float previous1_x = state->previous[0];
    const float previous1_y = state->previous[1];
    const float previous1_z = state->previous[2];

    /* phi_square = |phi|^2 */
    const float phi_square_1 = dtheta_x * dtheta_x;
    const float phi_square_2 = dtheta_y * dtheta_y;
    const float phi_square_3 = dtheta_z * dtheta_z;
    const float phi_square_4 = phi_square_1 + phi_square_2;
    const float phi_square = phi_square_4 + phi_square_3;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const float u_1 = phi_square * 0.002603855F /* 87/33412 */;
    const float u_2 = -0.125F /* -15464664/123717313 */ + u_1;
    const float u = phi_square * u_2;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const float s_1 = phi_square * -0.020831F /* -186/8929 */;
    const float s = 0.5F + s_1;

    /* v = s phi   [cao (14)] */
    const float v_x = s * dtheta_x;
    const float v_y = s * dtheta_y;
    const float v_z = s * dtheta_z;

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
    state->previous[0] = dtheta_x;
    state->previous[1] = dtheta_y;
    state->previous[2] = dtheta_z;
    state->previous[3] = previous1_x;
    state->previous[4] = previous1_y;
    state->previous[5] = previous1_z;
    state->count = state->count + 1;
}

static void rotation_vector_1_previous_2_float32_steady(
    rotation_vector_1_previous_2_float32_state *state, const float dtheta[3])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float dtheta_x = dtheta[0];
    const float dtheta_y = dtheta[1];
    const float dtheta_z = dtheta[2];

    /* earlier angle increments, newest first, rad, sensor axes */
    const float previous1_x = state->previous[0];
    const float previous1_y = state->previous[1];
    const float previous1_z = state->previous[2];
    const float previous2_x = state->previous[3];
    const float previous2_y = state->previous[4];
    const float previous2_z = state->previous[5];

    /* h = 7/60 theta[-1] - 1/60 theta[-2]   [savage1998 (46)] */
    const float h_x_1 = 0.11666667F /* 7/60 */ * previous1_x;
    const float h_y_1 = 0.11666667F /* 7/60 */ * previous1_y;
    const float h_z_1 = 0.11666667F /* 7/60 */ * previous1_z;
    const float h_x_2 = -0.016666668F /* -1/60 */ * previous2_x;
    const float h_y_2 = -0.016666668F /* -1/60 */ * previous2_y;
    const float h_z_2 = -0.016666668F /* -1/60 */ * previous2_z;
    const float h_x = h_x_1 + h_x_2;
    const float h_y = h_y_1 + h_y_2;
    const float h_z = h_z_1 + h_z_2;

    /* coning = h x theta   [savage1998 (46)] */
    const float coning_x_1 = h_y * dtheta_z;
    const float coning_x_2 = h_z * dtheta_y;
    const float coning_x = coning_x_1 - coning_x_2;
    const float coning_y_1 = h_z * dtheta_x;
    const float coning_y_2 = h_x * dtheta_z;
    const float coning_y = coning_y_1 - coning_y_2;
    const float coning_z_1 = h_x * dtheta_y;
    const float coning_z_2 = h_y * dtheta_x;
    const float coning_z = coning_z_1 - coning_z_2;

    /* phi = theta + coning   [savage1998 (46)] */
    const float phi_x = dtheta_x + coning_x;
    const float phi_y = dtheta_y + coning_y;
    const float phi_z = dtheta_z + coning_z;

    /* phi_square = |phi|^2 */
    const float phi_square_1 = phi_x * phi_x;
    const float phi_square_2 = phi_y * phi_y;
    const float phi_square_3 = phi_z * phi_z;
    const float phi_square_4 = phi_square_1 + phi_square_2;
    const float phi_square = phi_square_4 + phi_square_3;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const float u_1 = phi_square * 0.002603855F /* 87/33412 */;
    const float u_2 = -0.125F /* -15464664/123717313 */ + u_1;
    const float u = phi_square * u_2;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const float s_1 = phi_square * -0.020831F /* -186/8929 */;
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
    state->previous[0] = dtheta_x;
    state->previous[1] = dtheta_y;
    state->previous[2] = dtheta_z;
    state->previous[3] = previous1_x;
    state->previous[4] = previous1_y;
    state->previous[5] = previous1_z;
}

void rotation_vector_1_previous_2_float32_update(
    rotation_vector_1_previous_2_float32_state *state, const float dtheta[3])
{
    /* the history is full after 2 updates */
    if (state->count < 2) {
        rotation_vector_1_previous_2_float32_start_up(state, dtheta);
    } else {
        rotation_vector_1_previous_2_float32_steady(state, dtheta);
    }
}

void rotation_vector_1_previous_2_float32_quaternion(
    const rotation_vector_1_previous_2_float32_state *state, float q_nb[4])
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

void rotation_vector_1_previous_2_float32_dcm(
    const rotation_vector_1_previous_2_float32_state *state, float c_nb[9])
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
