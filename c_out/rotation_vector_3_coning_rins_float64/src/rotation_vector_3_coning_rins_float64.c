/* Generated, do not edit. Made by: qcone generate rins.toml --design rotation_vector_3_coning_rins_float64
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rins_float64, SHA-256 of the design
 * 32b3c38ea6ca8aeb3ee521527980700d9fc6fdd7ddad7c47ef1a111c87168ed3
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * stage:       encoder angle and tilt of a rotating unit corrected, rins (10) to (16); the
 *              attitude kept is the sensors'
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
 * unit:        encoder angle at most 3 pi in size; sqrt(A^2 + B^2) + |C| of each harmonic at most
 *              0.0029089 rad (600 arcsec)
 * truncation:  minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *              4.4e-22 (scalar), 4.1e-20 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations                 multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written                43       0   37        13       0       0     0     0     0       0
 * update shared                    42       1   37        13       0       0     0     0     0       0
 * update emitted                   42       1   37        13       0       0     0     0     0       0
 * dcm as-written                    9       0    9         6       0       0     0     0     0       0
 * dcm shared                        9       0    9         6       0       0     0     0     0       0
 * dcm emitted                       9       0    9         6       0       0     0     0     0       0
 * correct as-written               32       0   25         6       3       0     0     0     5       9
 * correct shared                   32       0   25         6       3       0     0     0     5       9
 * correct emitted                  32       0   25         6       3       0     0     0     5       9
 * body_quaternion as-written       57       0   35         5      11       0     0     0     5       9
 * body_quaternion shared           54       3   29        11       3       0     0     0     5       9
 * body_quaternion emitted          54       3   29        11       3       0     0     0     5       9
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
#include "rotation_vector_3_coning_rins_float64.h"

#if ROTATION_VECTOR_3_CONING_RINS_FLOAT64_VERSION != 1
#error "rotation_vector_3_coning_rins_float64.h is of another version than this file: generate both again"
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

void rotation_vector_3_coning_rins_float64_init(rotation_vector_3_coning_rins_float64_state *state)
{
    state->q[0] = 1.0;
    state->q[1] = 0.0;
    state->q[2] = 0.0;
    state->q[3] = 0.0;
    state->azimuth_harmonic[0] = 0.0;
    state->azimuth_harmonic[1] = 0.0;
    state->azimuth_harmonic[2] = 0.0;
    state->tilt_x_harmonic[0] = 0.0;
    state->tilt_x_harmonic[1] = 0.0;
    state->tilt_x_harmonic[2] = 0.0;
    state->tilt_y_harmonic[0] = 0.0;
    state->tilt_y_harmonic[1] = 0.0;
    state->tilt_y_harmonic[2] = 0.0;
}

void rotation_vector_3_coning_rins_float64_set_quaternion(
    rotation_vector_3_coning_rins_float64_state *state, const double q_nb[4])
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

void rotation_vector_3_coning_rins_float64_update(
    rotation_vector_3_coning_rins_float64_state *state, const double dtheta[9])
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

void rotation_vector_3_coning_rins_float64_quaternion(
    const rotation_vector_3_coning_rins_float64_state *state, double q_nb[4])
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

void rotation_vector_3_coning_rins_float64_dcm(
    const rotation_vector_3_coning_rins_float64_state *state, double c_nb[9])
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

void rotation_vector_3_coning_rins_float64_set_correction(
    rotation_vector_3_coning_rins_float64_state *state, const double azimuth[3], const double tilt_x[3],
    const double tilt_y[3])
{
    /* A, B, C of the encoder error A sin al + B cos al + C, rad */
    const double azimuth_sine = azimuth[0];
    const double azimuth_cosine = azimuth[1];
    const double azimuth_offset = azimuth[2];
    state->azimuth_harmonic[0] = azimuth_sine;
    state->azimuth_harmonic[1] = azimuth_cosine;
    state->azimuth_harmonic[2] = azimuth_offset;

    /* A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad */
    const double tilt_x_sine = tilt_x[0];
    const double tilt_x_cosine = tilt_x[1];
    const double tilt_x_offset = tilt_x[2];
    state->tilt_x_harmonic[0] = tilt_x_sine;
    state->tilt_x_harmonic[1] = tilt_x_cosine;
    state->tilt_x_harmonic[2] = tilt_x_offset;

    /* A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad */
    const double tilt_y_sine = tilt_y[0];
    const double tilt_y_cosine = tilt_y[1];
    const double tilt_y_offset = tilt_y[2];
    state->tilt_y_harmonic[0] = tilt_y_sine;
    state->tilt_y_harmonic[1] = tilt_y_cosine;
    state->tilt_y_harmonic[2] = tilt_y_offset;
}

void rotation_vector_3_coning_rins_float64_correct(
    const rotation_vector_3_coning_rins_float64_state *state, const double encoder[1], double angle[1],
    double tilt[2])
{
    /* the encoder's angle and the harmonics, read once */
    const double al = encoder[0];
    const double azimuth_sine = state->azimuth_harmonic[0];
    const double azimuth_cosine = state->azimuth_harmonic[1];
    const double azimuth_offset = state->azimuth_harmonic[2];
    const double tilt_x_sine = state->tilt_x_harmonic[0];
    const double tilt_x_cosine = state->tilt_x_harmonic[1];
    const double tilt_x_offset = state->tilt_x_harmonic[2];
    const double tilt_y_sine = state->tilt_y_harmonic[0];
    const double tilt_y_cosine = state->tilt_y_harmonic[1];
    const double tilt_y_offset = state->tilt_y_harmonic[2];

    /* cos_al = cos al, with sin_al = sin al: al folded to [0, pi/4], polynomials */
    const int32_t sin_al_1 = 3.141592653589793 < al;
    const double sin_al_2 = al - 6.283185307179586;
    const double sin_al_3 = (sin_al_1 != 0) ? sin_al_2 : al;
    const int32_t sin_al_4 = sin_al_3 < -3.141592653589793;
    const double sin_al_5 = sin_al_3 + 6.283185307179586;
    const double sin_al_6 = (sin_al_4 != 0) ? sin_al_5 : sin_al_3;
    const int32_t sin_al_7 = sin_al_6 < 0.0;
    const double sin_al_8 = -sin_al_6;
    const double sin_al_9 = (sin_al_7 != 0) ? sin_al_8 : sin_al_6;
    const int32_t sin_al_10 = 1.5707963267948966 < sin_al_9;
    const double sin_al_11 = 3.141592653589793 - sin_al_9;
    const double sin_al_12 = (sin_al_10 != 0) ? sin_al_11 : sin_al_9;
    const int32_t sin_al_13 = 0.7853981633974483 < sin_al_12;
    const double sin_al_14 = 1.5707963267948966 - sin_al_12;
    const double sin_al_15 = (sin_al_13 != 0) ? sin_al_14 : sin_al_12;
    const double sin_al_16 = sin_al_15 * sin_al_15;
    const double sin_al_17 = sin_al_16 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double sin_al_18 = -2.5050600311467533e-08 /* -28/1117737685 */ + sin_al_17;
    const double sin_al_19 = sin_al_16 * sin_al_18;
    const double sin_al_20 = 2.755731254530188e-06 /* 1933/701447210 */ + sin_al_19;
    const double sin_al_21 = sin_al_16 * sin_al_20;
    const double sin_al_22 = -0.00019841269825935837 /* -256734/1293939361 */ + sin_al_21;
    const double sin_al_23 = sin_al_16 * sin_al_22;
    const double sin_al_24 = 0.008333333333316484 /* 4121483234/494577988081 */ + sin_al_23;
    const double sin_al_25 = sin_al_16 * sin_al_24;
    const double sin_al_26 = -0.166666666666666 /* -41891153280974/251346919685845 */ + sin_al_25;
    const double sin_al_27 = sin_al_16 * sin_al_26;
    const double sin_al_28 = sin_al_15 * sin_al_27;
    const double sin_al_29 = sin_al_15 + sin_al_28;
    const double sin_al_30 = sin_al_16 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double sin_al_31 = -2.755529690519287e-07 /* -121/439117025 */ + sin_al_30;
    const double sin_al_32 = sin_al_16 * sin_al_31;
    const double sin_al_33 = 2.4801579019900845e-05 /* 37063/1494380659 */ + sin_al_32;
    const double sin_al_34 = sin_al_16 * sin_al_33;
    const double sin_al_35 = -0.0013888888871736989 /* -1124664/809758081 */ + sin_al_34;
    const double sin_al_36 = sin_al_16 * sin_al_35;
    const double sin_al_37 = 0.04166666666650333 /* 10628826118/255091826833 */ + sin_al_36;
    const double sin_al_38 = sin_al_16 * sin_al_37;
    const double sin_al_39 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + sin_al_38;
    const double sin_al_40 = sin_al_16 * sin_al_39;
    const double sin_al_41 = 1.0 + sin_al_40;
    const double sin_al_42 = (sin_al_13 != 0) ? sin_al_41 : sin_al_29;
    const double cos_al_1 = (sin_al_13 != 0) ? sin_al_29 : sin_al_41;
    const double sin_al_43 = -sin_al_42;
    const double sin_al = (sin_al_7 != 0) ? sin_al_43 : sin_al_42;
    const double cos_al_2 = -cos_al_1;
    const double cos_al = (sin_al_10 != 0) ? cos_al_2 : cos_al_1;

    /* error = A sin al + B cos al + C   [rins (13)] */
    const double error_1 = azimuth_sine * sin_al;
    const double error_2 = azimuth_cosine * cos_al;
    const double error_3 = error_1 + error_2;
    const double error = error_3 + azimuth_offset;

    /* al_corr = al - error   [rins (15)] */
    const double al_corr = al - error;

    /* cos_error = cos(error), with sin_error: as far as so small an angle needs */
    const double sin_error_1 = error * error;
    const double sin_error_2 = sin_error_1 * 0.008333333333333333 /* 1/120 */;
    const double sin_error_3 = -0.16666666666666666 /* -1/6 */ + sin_error_2;
    const double sin_error_4 = sin_error_1 * sin_error_3;
    const double sin_error_5 = error * sin_error_4;
    const double sin_error = error + sin_error_5;
    const double cos_error_1 = sin_error_1 * 0.041666666666666664 /* 1/24 */;
    const double cos_error_2 = -0.5 + cos_error_1;
    const double cos_error_3 = sin_error_1 * cos_error_2;
    const double cos_error = 1.0 + cos_error_3;

    /* cos_corr = cos(al - error), with sin_corr */
    const double sin_corr_1 = sin_al * cos_error;
    const double sin_corr_2 = cos_al * sin_error;
    const double sin_corr = sin_corr_1 - sin_corr_2;
    const double cos_corr_1 = cos_al * cos_error;
    const double cos_corr_2 = sin_al * sin_error;
    const double cos_corr = cos_corr_1 + cos_corr_2;

    /* cos_2al = cos 2al_corr, with sin_2al */
    const double sin_2al_1 = sin_corr + sin_corr;
    const double sin_2al = sin_2al_1 * cos_corr;
    const double cos_2al_1 = sin_2al_1 * sin_corr;
    const double cos_2al = 1.0 - cos_2al_1;

    /* delta_x = A2 sin 2al + B2 cos 2al + C2   [rins (16)] */
    const double delta_x_1 = tilt_x_sine * sin_2al;
    const double delta_x_2 = tilt_x_cosine * cos_2al;
    const double delta_x_3 = delta_x_1 + delta_x_2;
    const double delta_x = delta_x_3 + tilt_x_offset;

    /* delta_y = A2 sin 2al + B2 cos 2al + C2   [rins (16)] */
    const double delta_y_1 = tilt_y_sine * sin_2al;
    const double delta_y_2 = tilt_y_cosine * cos_2al;
    const double delta_y_3 = delta_y_1 + delta_y_2;
    const double delta_y = delta_y_3 + tilt_y_offset;

    angle[0] = al_corr;
    tilt[0] = delta_x;
    tilt[1] = delta_y;
}

void rotation_vector_3_coning_rins_float64_body_quaternion(
    const rotation_vector_3_coning_rins_float64_state *state, const double angle[1], const double tilt[2],
    double q_nb[4])
{
    /* q, read once */
    const double q_w = state->q[0];
    const double q_x = state->q[1];
    const double q_y = state->q[2];
    const double q_z = state->q[3];

    /* corrected angle and tilts */
    const double al = angle[0];
    const double delta_x = tilt[0];
    const double delta_y = tilt[1];

    /* cos_x = cos(delta_x/2), with sin_x */
    const double sin_x_1 = 0.5 * delta_x;
    const double sin_x_2 = sin_x_1 * sin_x_1;
    const double sin_x_3 = sin_x_2 * 0.008333333333333333 /* 1/120 */;
    const double sin_x_4 = -0.16666666666666666 /* -1/6 */ + sin_x_3;
    const double sin_x_5 = sin_x_2 * sin_x_4;
    const double sin_x_6 = sin_x_1 * sin_x_5;
    const double sin_x = sin_x_1 + sin_x_6;
    const double cos_x_1 = sin_x_2 * 0.041666666666666664 /* 1/24 */;
    const double cos_x_2 = -0.5 + cos_x_1;
    const double cos_x_3 = sin_x_2 * cos_x_2;
    const double cos_x = 1.0 + cos_x_3;

    /* cos_y = cos(delta_y/2), with sin_y */
    const double sin_y_1 = 0.5 * delta_y;
    const double sin_y_2 = sin_y_1 * sin_y_1;
    const double sin_y_3 = sin_y_2 * 0.008333333333333333 /* 1/120 */;
    const double sin_y_4 = -0.16666666666666666 /* -1/6 */ + sin_y_3;
    const double sin_y_5 = sin_y_2 * sin_y_4;
    const double sin_y_6 = sin_y_1 * sin_y_5;
    const double sin_y = sin_y_1 + sin_y_6;
    const double cos_y_1 = sin_y_2 * 0.041666666666666664 /* 1/24 */;
    const double cos_y_2 = -0.5 + cos_y_1;
    const double cos_y_3 = sin_y_2 * cos_y_2;
    const double cos_y = 1.0 + cos_y_3;

    /* tilt_z = sin_y sin_x; C_s'^s as [tilt_w, -tilt_x, -tilt_y, -tilt_z]   [rins (11)] */
    const double tilt_w = cos_y * cos_x;
    const double tilt_x = cos_y * sin_x;
    const double tilt_y = sin_y * cos_x;
    const double tilt_z = sin_y * sin_x;

    /* cos_half = cos(al/2), with sin_half: al/2 folded to [0, pi/4], polynomials */
    const double sin_half_1 = 0.5 * al;
    const int32_t sin_half_2 = 3.141592653589793 < sin_half_1;
    const double sin_half_3 = sin_half_1 - 6.283185307179586;
    const double sin_half_4 = (sin_half_2 != 0) ? sin_half_3 : sin_half_1;
    const int32_t sin_half_5 = sin_half_4 < -3.141592653589793;
    const double sin_half_6 = sin_half_4 + 6.283185307179586;
    const double sin_half_7 = (sin_half_5 != 0) ? sin_half_6 : sin_half_4;
    const int32_t sin_half_8 = sin_half_7 < 0.0;
    const double sin_half_9 = -sin_half_7;
    const double sin_half_10 = (sin_half_8 != 0) ? sin_half_9 : sin_half_7;
    const int32_t sin_half_11 = 1.5707963267948966 < sin_half_10;
    const double sin_half_12 = 3.141592653589793 - sin_half_10;
    const double sin_half_13 = (sin_half_11 != 0) ? sin_half_12 : sin_half_10;
    const int32_t sin_half_14 = 0.7853981633974483 < sin_half_13;
    const double sin_half_15 = 1.5707963267948966 - sin_half_13;
    const double sin_half_16 = (sin_half_14 != 0) ? sin_half_15 : sin_half_13;
    const double sin_half_17 = sin_half_16 * sin_half_16;
    const double sin_half_18 = sin_half_17 * 1.5888590234853853e-10 /* 1/6293824595 */;
    const double sin_half_19 = -2.5050600311467533e-08 /* -28/1117737685 */ + sin_half_18;
    const double sin_half_20 = sin_half_17 * sin_half_19;
    const double sin_half_21 = 2.755731254530188e-06 /* 1933/701447210 */ + sin_half_20;
    const double sin_half_22 = sin_half_17 * sin_half_21;
    const double sin_half_23 = -0.00019841269825935837 /* -256734/1293939361 */ + sin_half_22;
    const double sin_half_24 = sin_half_17 * sin_half_23;
    const double sin_half_25 = 0.008333333333316484 /* 4121483234/494577988081 */ + sin_half_24;
    const double sin_half_26 = sin_half_17 * sin_half_25;
    const double sin_half_27 = -0.166666666666666 /* -41891153280974/251346919685845 */ + sin_half_26;
    const double sin_half_28 = sin_half_17 * sin_half_27;
    const double sin_half_29 = sin_half_16 * sin_half_28;
    const double sin_half_30 = sin_half_16 + sin_half_29;
    const double sin_half_31 = sin_half_17 * 2.0633620775764964e-09 /* 1/484645914 */;
    const double sin_half_32 = -2.755529690519287e-07 /* -121/439117025 */ + sin_half_31;
    const double sin_half_33 = sin_half_17 * sin_half_32;
    const double sin_half_34 = 2.4801579019900845e-05 /* 37063/1494380659 */ + sin_half_33;
    const double sin_half_35 = sin_half_17 * sin_half_34;
    const double sin_half_36 = -0.0013888888871736989 /* -1124664/809758081 */ + sin_half_35;
    const double sin_half_37 = sin_half_17 * sin_half_36;
    const double sin_half_38 = 0.04166666666650333 /* 10628826118/255091826833 */ + sin_half_37;
    const double sin_half_39 = sin_half_17 * sin_half_38;
    const double sin_half_40 = -0.49999999999999484 /* -48263372516038/96526745032077 */ + sin_half_39;
    const double sin_half_41 = sin_half_17 * sin_half_40;
    const double sin_half_42 = 1.0 + sin_half_41;
    const double sin_half_43 = (sin_half_14 != 0) ? sin_half_42 : sin_half_30;
    const double cos_half_1 = (sin_half_14 != 0) ? sin_half_30 : sin_half_42;
    const double sin_half_44 = -sin_half_43;
    const double sin_half = (sin_half_8 != 0) ? sin_half_44 : sin_half_43;
    const double cos_half_2 = -cos_half_1;
    const double cos_half = (sin_half_11 != 0) ? cos_half_2 : cos_half_1;

    /* q_sb = C_s'^s C_b^s' = [tilt_w, -tilt_x, ...] (x) [cos_half, 0, 0, -sin_half]   [rins (5)] */
    const double q_sb_w_1 = tilt_w * cos_half;
    const double q_sb_w_2 = tilt_z * sin_half;
    const double q_sb_w = q_sb_w_1 - q_sb_w_2;
    const double q_sb_x_1 = tilt_y * sin_half;
    const double q_sb_x_2 = tilt_x * cos_half;
    const double q_sb_x = q_sb_x_1 - q_sb_x_2;
    const double q_sb_y_negated_1 = tilt_y * cos_half;
    const double q_sb_y_negated_2 = tilt_x * sin_half;
    const double q_sb_y_negated = q_sb_y_negated_1 + q_sb_y_negated_2;
    const double q_sb_z_negated_1 = tilt_z * cos_half;
    const double q_sb_z_negated_2 = tilt_w * sin_half;
    const double q_sb_z_negated = q_sb_z_negated_1 + q_sb_z_negated_2;

    /* q_nb = q_ns (x) q_sb   [rins (10)] */
    const double q_nb_w_1 = q_w * q_sb_w;
    const double q_nb_w_2 = q_x * q_sb_x;
    const double q_nb_w_3 = q_y * q_sb_y_negated;
    const double q_nb_w_4 = q_z * q_sb_z_negated;
    const double q_nb_w_5 = q_nb_w_1 - q_nb_w_2;
    const double q_nb_w_6 = q_nb_w_5 + q_nb_w_3;
    const double q_nb_w = q_nb_w_6 + q_nb_w_4;
    const double q_nb_x_1 = q_x * q_sb_w;
    const double q_nb_x_2 = q_w * q_sb_x;
    const double q_nb_x_3 = q_z * q_sb_y_negated;
    const double q_nb_x_4 = q_y * q_sb_z_negated;
    const double q_nb_x_5 = q_nb_x_1 + q_nb_x_2;
    const double q_nb_x_6 = q_nb_x_5 + q_nb_x_3;
    const double q_nb_x = q_nb_x_6 - q_nb_x_4;
    const double q_nb_y_1 = q_y * q_sb_w;
    const double q_nb_y_2 = q_z * q_sb_x;
    const double q_nb_y_3 = q_w * q_sb_y_negated;
    const double q_nb_y_4 = q_x * q_sb_z_negated;
    const double q_nb_y_5 = q_nb_y_1 + q_nb_y_2;
    const double q_nb_y_6 = q_nb_y_5 - q_nb_y_3;
    const double q_nb_y = q_nb_y_6 + q_nb_y_4;
    const double q_nb_z_1 = q_z * q_sb_w;
    const double q_nb_z_2 = q_y * q_sb_x;
    const double q_nb_z_3 = q_x * q_sb_y_negated;
    const double q_nb_z_4 = q_w * q_sb_z_negated;
    const double q_nb_z_5 = q_nb_z_1 - q_nb_z_2;
    const double q_nb_z_6 = q_nb_z_5 - q_nb_z_3;
    const double q_nb_z = q_nb_z_6 - q_nb_z_4;

    q_nb[0] = q_nb_w;
    q_nb[1] = q_nb_x;
    q_nb[2] = q_nb_y;
    q_nb[3] = q_nb_z;
}

void rotation_vector_3_coning_rins_float64_body_dcm(const double q_nb[4], double c_nb[9])
{
    /* q_nb, read once */
    const double q_nb_w = q_nb[0];
    const double q_nb_x = q_nb[1];
    const double q_nb_y = q_nb[2];
    const double q_nb_z = q_nb[3];

    /* zz = 2 q_z q_z; wx, wy, ... likewise   [cao (15)] */
    const double x2 = q_nb_x + q_nb_x;
    const double y2 = q_nb_y + q_nb_y;
    const double z2 = q_nb_z + q_nb_z;
    const double wx = q_nb_w * x2;
    const double wy = q_nb_w * y2;
    const double wz = q_nb_w * z2;
    const double xx = q_nb_x * x2;
    const double xy = q_nb_x * y2;
    const double xz = q_nb_x * z2;
    const double yy = q_nb_y * y2;
    const double yz = q_nb_y * z2;
    const double zz = q_nb_z * z2;

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
