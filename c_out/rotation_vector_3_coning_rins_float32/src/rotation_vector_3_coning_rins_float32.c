/* Generated, do not edit. Made by: qcone generate rins.toml --design rotation_vector_3_coning_rins_float32
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rins_float32, SHA-256 of the design
 * 3c667cf33afaf9e00894cacfe2ad32cc96f7b56ee14d49fc0f2bdd86a80be464
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * stage:       encoder angle and tilt of a rotating unit corrected, rins (10) to (16); the
 *              attitude kept is the sensors'
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * unit:        encoder angle at most 3 pi in size; sqrt(A^2 + B^2) + |C| of each harmonic at most
 *              0.0029089 rad (600 arcsec)
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              1.1e-12 (scalar), 3.8e-10 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations                 multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written                39       0   33        13       0       0     0     0     0       0
 * update shared                    38       1   33        13       0       0     0     0     0       0
 * update emitted                   38       1   33        13       0       0     0     0     0       0
 * dcm as-written                    9       0    9         6       0       0     0     0     0       0
 * dcm shared                        9       0    9         6       0       0     0     0     0       0
 * dcm emitted                       9       0    9         6       0       0     0     0     0       0
 * correct as-written               23       0   17         6       3       0     0     0     5       9
 * correct shared                   22       1   17         6       3       0     0     0     5       9
 * correct emitted                  22       1   17         6       3       0     0     0     5       9
 * body_quaternion as-written       44       0   24         5      11       0     0     0     5       9
 * body_quaternion shared           39       5   18        11       3       0     0     0     5       9
 * body_quaternion emitted          39       5   18        11       3       0     0     0     5       9
 * body_dcm as-written               9       0    9         6       0       0     0     0     0       0
 * body_dcm shared                   9       0    9         6       0       0     0     0     0       0
 * body_dcm emitted                  9       0    9         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#include "rotation_vector_3_coning_rins_float32.h"

#if ROTATION_VECTOR_3_CONING_RINS_FLOAT32_VERSION != 1
#error "rotation_vector_3_coning_rins_float32.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_3_coning_rins_float32_init(rotation_vector_3_coning_rins_float32_state *state)
{
    state->q[0] = 1.0F;
    state->q[1] = 0.0F;
    state->q[2] = 0.0F;
    state->q[3] = 0.0F;
    state->azimuth_harmonic[0] = 0.0F;
    state->azimuth_harmonic[1] = 0.0F;
    state->azimuth_harmonic[2] = 0.0F;
    state->tilt_x_harmonic[0] = 0.0F;
    state->tilt_x_harmonic[1] = 0.0F;
    state->tilt_x_harmonic[2] = 0.0F;
    state->tilt_y_harmonic[0] = 0.0F;
    state->tilt_y_harmonic[1] = 0.0F;
    state->tilt_y_harmonic[2] = 0.0F;
}

void rotation_vector_3_coning_rins_float32_set_quaternion(
    rotation_vector_3_coning_rins_float32_state *state, const float q_nb[4])
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

void rotation_vector_3_coning_rins_float32_update(
    rotation_vector_3_coning_rins_float32_state *state, const float dtheta[9])
{
    /* attitude and input */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];
    const float dtheta1_x = dtheta[0];
    const float dtheta1_y = dtheta[1];
    const float dtheta1_z = dtheta[2];
    const float dtheta2_x = dtheta[3];
    const float dtheta2_y = dtheta[4];
    const float dtheta2_z = dtheta[5];
    const float dtheta3_x = dtheta[6];
    const float dtheta3_y = dtheta[7];
    const float dtheta3_z = dtheta[8];

    /* p = theta_1 + theta_3 */
    const float p_x = dtheta1_x + dtheta3_x;
    const float p_y = dtheta1_y + dtheta3_y;
    const float p_z = dtheta1_z + dtheta3_z;

    /* d = theta_3 - theta_1 */
    const float d_x = dtheta3_x - dtheta1_x;
    const float d_y = dtheta3_y - dtheta1_y;
    const float d_z = dtheta3_z - dtheta1_z;

    /* S = p + theta_2 */
    const float S_x = p_x + dtheta2_x;
    const float S_y = p_y + dtheta2_y;
    const float S_z = p_z + dtheta2_z;

    /* g = S + 2 theta_2   [cao (12)] */
    const float g_x_1 = S_x + dtheta2_x;
    const float g_y_1 = S_y + dtheta2_y;
    const float g_z_1 = S_z + dtheta2_z;
    const float g_x = g_x_1 + dtheta2_x;
    const float g_y = g_y_1 + dtheta2_y;
    const float g_z = g_z_1 + dtheta2_z;

    /* k = 9/40 d   [cao (12)] */
    const float k_x = 0.225F /* 9/40 */ * d_x;
    const float k_y = 0.225F /* 9/40 */ * d_y;
    const float k_z = 0.225F /* 9/40 */ * d_z;

    /* coning = g x k   [cao (12)] */
    const float coning_x_1 = g_y * k_z;
    const float coning_x_2 = g_z * k_y;
    const float coning_x = coning_x_1 - coning_x_2;
    const float coning_y_1 = g_z * k_x;
    const float coning_y_2 = g_x * k_z;
    const float coning_y = coning_y_1 - coning_y_2;
    const float coning_z_1 = g_x * k_y;
    const float coning_z_2 = g_y * k_x;
    const float coning_z = coning_z_1 - coning_z_2;

    /* phi = S + coning   [cao (12)] */
    const float phi_x = S_x + coning_x;
    const float phi_y = S_y + coning_y;
    const float phi_z = S_z + coning_z;

    /* phi_square = |phi|^2 */
    const float phi_square_1 = phi_x * phi_x;
    const float phi_square_2 = phi_y * phi_y;
    const float phi_square_3 = phi_z * phi_z;
    const float phi_square_4 = phi_square_1 + phi_square_2;
    const float phi_square = phi_square_4 + phi_square_3;

    /* u = cos(|phi|/2) - 1, polynomial in |phi|^2   [cao (9)] */
    const float u_1 = phi_square * 0.0026038513F /* 43/16514 */;
    const float u_2 = -0.125F /* -15058244/120465953 */ + u_1;
    const float u = phi_square * u_2;

    /* s = sin(|phi|/2)/|phi|, polynomial in |phi|^2   [cao (9)] */
    const float s_1 = phi_square * -0.020830961F /* -183/8785 */;
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
}

void rotation_vector_3_coning_rins_float32_quaternion(
    const rotation_vector_3_coning_rins_float32_state *state, float q_nb[4])
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

void rotation_vector_3_coning_rins_float32_dcm(
    const rotation_vector_3_coning_rins_float32_state *state, float c_nb[9])
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

void rotation_vector_3_coning_rins_float32_set_correction(
    rotation_vector_3_coning_rins_float32_state *state, const float azimuth[3], const float tilt_x[3],
    const float tilt_y[3])
{
    /* A, B, C of the encoder error A sin al + B cos al + C, rad */
    const float azimuth_sine = azimuth[0];
    const float azimuth_cosine = azimuth[1];
    const float azimuth_offset = azimuth[2];
    state->azimuth_harmonic[0] = azimuth_sine;
    state->azimuth_harmonic[1] = azimuth_cosine;
    state->azimuth_harmonic[2] = azimuth_offset;

    /* A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad */
    const float tilt_x_sine = tilt_x[0];
    const float tilt_x_cosine = tilt_x[1];
    const float tilt_x_offset = tilt_x[2];
    state->tilt_x_harmonic[0] = tilt_x_sine;
    state->tilt_x_harmonic[1] = tilt_x_cosine;
    state->tilt_x_harmonic[2] = tilt_x_offset;

    /* A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad */
    const float tilt_y_sine = tilt_y[0];
    const float tilt_y_cosine = tilt_y[1];
    const float tilt_y_offset = tilt_y[2];
    state->tilt_y_harmonic[0] = tilt_y_sine;
    state->tilt_y_harmonic[1] = tilt_y_cosine;
    state->tilt_y_harmonic[2] = tilt_y_offset;
}

void rotation_vector_3_coning_rins_float32_correct(
    const rotation_vector_3_coning_rins_float32_state *state, const float encoder[1], float angle[1],
    float tilt[2])
{
    /* the encoder's angle and the harmonics, read once */
    const float al = encoder[0];
    const float azimuth_sine = state->azimuth_harmonic[0];
    const float azimuth_cosine = state->azimuth_harmonic[1];
    const float azimuth_offset = state->azimuth_harmonic[2];
    const float tilt_x_sine = state->tilt_x_harmonic[0];
    const float tilt_x_cosine = state->tilt_x_harmonic[1];
    const float tilt_x_offset = state->tilt_x_harmonic[2];
    const float tilt_y_sine = state->tilt_y_harmonic[0];
    const float tilt_y_cosine = state->tilt_y_harmonic[1];
    const float tilt_y_offset = state->tilt_y_harmonic[2];

    /* cos_al = cos al, with sin_al = sin al: al folded to [0, pi/4], polynomials */
    const int32_t sin_al_1 = 3.1415927F < al;
    const float sin_al_2 = al - 6.2831855F;
    const float sin_al_3 = (sin_al_1 != 0) ? sin_al_2 : al;
    const int32_t sin_al_4 = sin_al_3 < -3.1415927F;
    const float sin_al_5 = sin_al_3 + 6.2831855F;
    const float sin_al_6 = (sin_al_4 != 0) ? sin_al_5 : sin_al_3;
    const int32_t sin_al_7 = sin_al_6 < 0.0F;
    const float sin_al_8 = -sin_al_6;
    const float sin_al_9 = (sin_al_7 != 0) ? sin_al_8 : sin_al_6;
    const int32_t sin_al_10 = 1.5707964F < sin_al_9;
    const float sin_al_11 = 3.1415927F - sin_al_9;
    const float sin_al_12 = (sin_al_10 != 0) ? sin_al_11 : sin_al_9;
    const int32_t sin_al_13 = 0.7853982F < sin_al_12;
    const float sin_al_14 = 1.5707964F - sin_al_12;
    const float sin_al_15 = (sin_al_13 != 0) ? sin_al_14 : sin_al_12;
    const float sin_al_16 = sin_al_15 * sin_al_15;
    const float sin_al_17 = sin_al_16 * -0.00019495712F /* -3/15388 */;
    const float sin_al_18 = 0.008331979F /* 205/24604 */ + sin_al_17;
    const float sin_al_19 = sin_al_16 * sin_al_18;
    const float sin_al_20 = -0.16666651F /* -173294/1039765 */ + sin_al_19;
    const float sin_al_21 = sin_al_16 * sin_al_20;
    const float sin_al_22 = sin_al_15 * sin_al_21;
    const float sin_al_23 = sin_al_15 + sin_al_22;
    const float sin_al_24 = sin_al_16 * 2.4390838e-05F /* 1/40999 */;
    const float sin_al_25 = -0.0013886767F /* -100/72011 */ + sin_al_24;
    const float sin_al_26 = sin_al_16 * sin_al_25;
    const float sin_al_27 = 0.041666623F /* 39776/954625 */ + sin_al_26;
    const float sin_al_28 = sin_al_16 * sin_al_27;
    const float sin_al_29 = -0.5F /* -85104966/170209933 */ + sin_al_28;
    const float sin_al_30 = sin_al_16 * sin_al_29;
    const float sin_al_31 = 1.0F + sin_al_30;
    const float sin_al_32 = (sin_al_13 != 0) ? sin_al_31 : sin_al_23;
    const float cos_al_1 = (sin_al_13 != 0) ? sin_al_23 : sin_al_31;
    const float sin_al_33 = -sin_al_32;
    const float sin_al = (sin_al_7 != 0) ? sin_al_33 : sin_al_32;
    const float cos_al_2 = -cos_al_1;
    const float cos_al = (sin_al_10 != 0) ? cos_al_2 : cos_al_1;

    /* error = A sin al + B cos al + C   [rins (13)] */
    const float error_1 = azimuth_sine * sin_al;
    const float error_2 = azimuth_cosine * cos_al;
    const float error_3 = error_1 + error_2;
    const float error = error_3 + azimuth_offset;

    /* al_corr = al - error   [rins (15)] */
    const float al_corr = al - error;

    /* cos_error = cos(error), with sin_error: as far as so small an angle needs */
    const float cos_error_1 = error * error;
    const float cos_error_2 = cos_error_1 * -0.5F;
    const float cos_error = 1.0F + cos_error_2;

    /* cos_corr = cos(al - error), with sin_corr */
    const float sin_corr_1 = sin_al * cos_error;
    const float sin_corr_2 = cos_al * error;
    const float sin_corr = sin_corr_1 - sin_corr_2;
    const float cos_corr_1 = cos_al * cos_error;
    const float cos_corr_2 = sin_al * error;
    const float cos_corr = cos_corr_1 + cos_corr_2;

    /* cos_2al = cos 2al_corr, with sin_2al */
    const float sin_2al_1 = sin_corr + sin_corr;
    const float sin_2al = sin_2al_1 * cos_corr;
    const float cos_2al_1 = sin_2al_1 * sin_corr;
    const float cos_2al = 1.0F - cos_2al_1;

    /* delta_x = A2 sin 2al + B2 cos 2al + C2   [rins (16)] */
    const float delta_x_1 = tilt_x_sine * sin_2al;
    const float delta_x_2 = tilt_x_cosine * cos_2al;
    const float delta_x_3 = delta_x_1 + delta_x_2;
    const float delta_x = delta_x_3 + tilt_x_offset;

    /* delta_y = A2 sin 2al + B2 cos 2al + C2   [rins (16)] */
    const float delta_y_1 = tilt_y_sine * sin_2al;
    const float delta_y_2 = tilt_y_cosine * cos_2al;
    const float delta_y_3 = delta_y_1 + delta_y_2;
    const float delta_y = delta_y_3 + tilt_y_offset;

    angle[0] = al_corr;
    tilt[0] = delta_x;
    tilt[1] = delta_y;
}

void rotation_vector_3_coning_rins_float32_body_quaternion(
    const rotation_vector_3_coning_rins_float32_state *state, const float angle[1], const float tilt[2],
    float q_nb[4])
{
    /* q, read once */
    const float q_w = state->q[0];
    const float q_x = state->q[1];
    const float q_y = state->q[2];
    const float q_z = state->q[3];

    /* corrected angle and tilts */
    const float al = angle[0];
    const float delta_x = tilt[0];
    const float delta_y = tilt[1];

    /* cos_x = cos(delta_x/2), with sin_x */
    const float sin_x = 0.5F * delta_x;
    const float cos_x_1 = sin_x * sin_x;
    const float cos_x_2 = cos_x_1 * -0.5F;
    const float cos_x = 1.0F + cos_x_2;

    /* cos_y = cos(delta_y/2), with sin_y */
    const float sin_y = 0.5F * delta_y;
    const float cos_y_1 = sin_y * sin_y;
    const float cos_y_2 = cos_y_1 * -0.5F;
    const float cos_y = 1.0F + cos_y_2;

    /* tilt_z = sin_y sin_x; C_s'^s as [tilt_w, -tilt_x, -tilt_y, -tilt_z]   [rins (11)] */
    const float tilt_w = cos_y * cos_x;
    const float tilt_x = cos_y * sin_x;
    const float tilt_y = sin_y * cos_x;
    const float tilt_z = sin_y * sin_x;

    /* cos_half = cos(al/2), with sin_half: al/2 folded to [0, pi/4], polynomials */
    const float sin_half_1 = 0.5F * al;
    const int32_t sin_half_2 = 3.1415927F < sin_half_1;
    const float sin_half_3 = sin_half_1 - 6.2831855F;
    const float sin_half_4 = (sin_half_2 != 0) ? sin_half_3 : sin_half_1;
    const int32_t sin_half_5 = sin_half_4 < -3.1415927F;
    const float sin_half_6 = sin_half_4 + 6.2831855F;
    const float sin_half_7 = (sin_half_5 != 0) ? sin_half_6 : sin_half_4;
    const int32_t sin_half_8 = sin_half_7 < 0.0F;
    const float sin_half_9 = -sin_half_7;
    const float sin_half_10 = (sin_half_8 != 0) ? sin_half_9 : sin_half_7;
    const int32_t sin_half_11 = 1.5707964F < sin_half_10;
    const float sin_half_12 = 3.1415927F - sin_half_10;
    const float sin_half_13 = (sin_half_11 != 0) ? sin_half_12 : sin_half_10;
    const int32_t sin_half_14 = 0.7853982F < sin_half_13;
    const float sin_half_15 = 1.5707964F - sin_half_13;
    const float sin_half_16 = (sin_half_14 != 0) ? sin_half_15 : sin_half_13;
    const float sin_half_17 = sin_half_16 * sin_half_16;
    const float sin_half_18 = sin_half_17 * -0.00019495712F /* -3/15388 */;
    const float sin_half_19 = 0.008331979F /* 205/24604 */ + sin_half_18;
    const float sin_half_20 = sin_half_17 * sin_half_19;
    const float sin_half_21 = -0.16666651F /* -173294/1039765 */ + sin_half_20;
    const float sin_half_22 = sin_half_17 * sin_half_21;
    const float sin_half_23 = sin_half_16 * sin_half_22;
    const float sin_half_24 = sin_half_16 + sin_half_23;
    const float sin_half_25 = sin_half_17 * 2.4390838e-05F /* 1/40999 */;
    const float sin_half_26 = -0.0013886767F /* -100/72011 */ + sin_half_25;
    const float sin_half_27 = sin_half_17 * sin_half_26;
    const float sin_half_28 = 0.041666623F /* 39776/954625 */ + sin_half_27;
    const float sin_half_29 = sin_half_17 * sin_half_28;
    const float sin_half_30 = -0.5F /* -85104966/170209933 */ + sin_half_29;
    const float sin_half_31 = sin_half_17 * sin_half_30;
    const float sin_half_32 = 1.0F + sin_half_31;
    const float sin_half_33 = (sin_half_14 != 0) ? sin_half_32 : sin_half_24;
    const float cos_half_1 = (sin_half_14 != 0) ? sin_half_24 : sin_half_32;
    const float sin_half_34 = -sin_half_33;
    const float sin_half = (sin_half_8 != 0) ? sin_half_34 : sin_half_33;
    const float cos_half_2 = -cos_half_1;
    const float cos_half = (sin_half_11 != 0) ? cos_half_2 : cos_half_1;

    /* q_sb = C_s'^s C_b^s' = [tilt_w, -tilt_x, ...] (x) [cos_half, 0, 0, -sin_half]   [rins (5)] */
    const float q_sb_w_1 = tilt_w * cos_half;
    const float q_sb_w_2 = tilt_z * sin_half;
    const float q_sb_w = q_sb_w_1 - q_sb_w_2;
    const float q_sb_x_1 = tilt_y * sin_half;
    const float q_sb_x_2 = tilt_x * cos_half;
    const float q_sb_x = q_sb_x_1 - q_sb_x_2;
    const float q_sb_y_negated_1 = tilt_y * cos_half;
    const float q_sb_y_negated_2 = tilt_x * sin_half;
    const float q_sb_y_negated = q_sb_y_negated_1 + q_sb_y_negated_2;
    const float q_sb_z_negated_1 = tilt_z * cos_half;
    const float q_sb_z_negated_2 = tilt_w * sin_half;
    const float q_sb_z_negated = q_sb_z_negated_1 + q_sb_z_negated_2;

    /* q_nb = q_ns (x) q_sb   [rins (10)] */
    const float q_nb_w_1 = q_w * q_sb_w;
    const float q_nb_w_2 = q_x * q_sb_x;
    const float q_nb_w_3 = q_y * q_sb_y_negated;
    const float q_nb_w_4 = q_z * q_sb_z_negated;
    const float q_nb_w_5 = q_nb_w_1 - q_nb_w_2;
    const float q_nb_w_6 = q_nb_w_5 + q_nb_w_3;
    const float q_nb_w = q_nb_w_6 + q_nb_w_4;
    const float q_nb_x_1 = q_x * q_sb_w;
    const float q_nb_x_2 = q_w * q_sb_x;
    const float q_nb_x_3 = q_z * q_sb_y_negated;
    const float q_nb_x_4 = q_y * q_sb_z_negated;
    const float q_nb_x_5 = q_nb_x_1 + q_nb_x_2;
    const float q_nb_x_6 = q_nb_x_5 + q_nb_x_3;
    const float q_nb_x = q_nb_x_6 - q_nb_x_4;
    const float q_nb_y_1 = q_y * q_sb_w;
    const float q_nb_y_2 = q_z * q_sb_x;
    const float q_nb_y_3 = q_w * q_sb_y_negated;
    const float q_nb_y_4 = q_x * q_sb_z_negated;
    const float q_nb_y_5 = q_nb_y_1 + q_nb_y_2;
    const float q_nb_y_6 = q_nb_y_5 - q_nb_y_3;
    const float q_nb_y = q_nb_y_6 + q_nb_y_4;
    const float q_nb_z_1 = q_z * q_sb_w;
    const float q_nb_z_2 = q_y * q_sb_x;
    const float q_nb_z_3 = q_x * q_sb_y_negated;
    const float q_nb_z_4 = q_w * q_sb_z_negated;
    const float q_nb_z_5 = q_nb_z_1 - q_nb_z_2;
    const float q_nb_z_6 = q_nb_z_5 - q_nb_z_3;
    const float q_nb_z = q_nb_z_6 - q_nb_z_4;

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void rotation_vector_3_coning_rins_float32_body_dcm(const float q_nb[4], float c_nb[9])
{
    /* q_nb, read once */
    const float q_nb_w = q_nb[0];
    const float q_nb_x = q_nb[1];
    const float q_nb_y = q_nb[2];
    const float q_nb_z = q_nb[3];

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const float x2 = q_nb_x + q_nb_x;
    const float y2 = q_nb_y + q_nb_y;
    const float z2 = q_nb_z + q_nb_z;
    const float wx = q_nb_w * x2;
    const float wy = q_nb_w * y2;
    const float wz = q_nb_w * z2;
    const float xx = q_nb_x * x2;
    const float xy = q_nb_x * y2;
    const float xz = q_nb_x * z2;
    const float yy = q_nb_y * y2;
    const float yz = q_nb_y * z2;
    const float zz = q_nb_z * z2;

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
