/* Generated, do not edit. Made by: qcone generate rins.toml --design rotation_vector_3_coning_rins_fixed32_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rins_fixed32_compensated, SHA-256 of the design
 * df93b9e268c92fe753740a4652d4fd6e421dacea013b8e2311eb9cfeb3a0c7d0
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      cao (12), cao (14)
 * stage:       encoder angle and tilt of a rotating unit corrected, rins (10) to (16); the
 *              attitude kept is the sensors'
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * unit:        encoder angle at most 3 pi in size; sqrt(A^2 + B^2) + |C| of each harmonic at most
 *              0.0029089 rad (600 arcsec)
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.5e-15 (scalar), 5.5e-15 (vector), proved over the rationals
 * rounding:    one update is within 4.3e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  10 of 16 rounded sums of products drop a whole word, 2 before formats were searched
 *              for that; of one update's errors in the first order it made 4.4e-10 of 4.1e-10
 *
 * operations                 multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written                44       0   37        13       0       0     0     0     0       0      0
 * update shared                    40       4   37        13       0       0     0     0     0       0      0
 * update emitted                   40       0   43        16       3       0     0     0     0       0     34
 * dcm as-written                    9       0    9         6       0       0     0     0     0       0      0
 * dcm shared                        9       0    9         6       0       0     0     0     0       0      0
 * dcm emitted                       9       0    6         6       0       0     0     0     0       0     19
 * euler as-written                 82       0   43        19       9       3     0     0    26      54      0
 * euler shared                     54      26   43        19       9       3     0     0    26      54      0
 * euler emitted                    54       0   33        28      11       3     0     0    26      85    143
 * correct as-written               26       0   19         6       3       0     0     0     5       9      0
 * correct shared                   25       1   19         6       3       0     0     0     5       9      0
 * correct emitted                  25       0   14        10       5       0     0     0     5      14     34
 * body_quaternion as-written       49       0   27         5      11       0     0     0     5       9      0
 * body_quaternion shared           44       5   21        11       3       0     0     0     5       9      0
 * body_quaternion emitted          44       0   21        11       8       0     0     0     5      18     52
 * body_dcm as-written               9       0    9         6       0       0     0     0     0       0      0
 * body_dcm shared                   9       0    9         6       0       0     0     0     0       0      0
 * body_dcm emitted                  9       0    6         6       0       0     0     0     0       0     15
 * body_euler as-written            82       0   43        19       9       3     0     0    26      54      0
 * body_euler shared                54      26   43        19       9       3     0     0    26      54      0
 * body_euler emitted               54       0   33        28      11       3     0     0    26      85    139
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_H
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_3_coning_rins_fixed32_compensated: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-34. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_DTHETA_FRACTION_BITS 34
/* c: value = raw * 2^-30. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_C_FRACTION_BITS 30
/* rpy: value = raw * 2^-29. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_RPY_FRACTION_BITS 29
/* azimuth: value = raw * 2^-39. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_AZIMUTH_FRACTION_BITS 39
/* tilt_x: value = raw * 2^-39. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_TILT_X_FRACTION_BITS 39
/* tilt_y: value = raw * 2^-39. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_TILT_Y_FRACTION_BITS 39
/* encoder: value = raw * 2^-27. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_ENCODER_FRACTION_BITS 27
/* angle: value = raw * 2^-27. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_ANGLE_FRACTION_BITS 27
/* tilt: value = raw * 2^-36. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_TILT_FRACTION_BITS 36
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_STATE_INIT { { INT64_C(4611686018427387904), INT64_C(0), INT64_C(0), INT64_C(0) }, { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int64_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t residual[6]; /* roundings carried to the next update: of phi, v */
    int32_t azimuth_harmonic[3]; /* A, B, C of the encoder error A sin al + B cos al + C, rad */
    int32_t tilt_x_harmonic[3]; /* A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad */
    int32_t tilt_y_harmonic[3]; /* A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad */
} rotation_vector_3_coning_rins_fixed32_compensated_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 * The correction is zero.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_init(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The correction is kept.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_set_quaternion(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *   2.5e-15 (scalar), 5.5e-15 (vector), proved over the rationals.
 * Rounding: one update is within 4.3e-09 of exact arithmetic, in the norm of the components, what
 *   is carried included, which does not add up; proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_update(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_quaternion(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, int32_t q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: int32_t.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_dcm(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, int32_t c_nb[9]);

/*
 * Give roll, pitch and yaw. Type of values: int32_t.
 *
 * rpy: roll, pitch, yaw, rad, convention zxy; roll and yaw in [-pi, pi], pitch at most pi/2 in
 *   size.
 * The attitude of the three angles is within 16 last bits of theirs of the quaternion's, poles
 *   included; roll and yaw each within 16 such bits over cos(pitch).
 */
void rotation_vector_3_coning_rins_fixed32_compensated_euler(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, int32_t rpy[3]);

/*
 * Take the harmonics of the encoder's error and of the tilt. Type of values: int32_t.
 *
 * azimuth: A, B, C of the encoder's error A sin al + B cos al + C, rins (13).
 * tilt_x: A2, B2, C2 of the sensors' tilt A2 sin 2al + B2 cos 2al + C2 about x, rins (16).
 * tilt_y: the same about y.
 * Range: rad; sqrt(A^2 + B^2) + |C| of each at most 0.0029089. Zero after init(); kept by what
 *   sets the attitude.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_set_correction(
    rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t azimuth[3],
    const int32_t tilt_x[3], const int32_t tilt_y[3]);

/*
 * Correct the encoder's angle, and give the tilt of the sensors at it. Type of values: int32_t.
 *
 * encoder: angle of the sensors against the body about the body's z axis, at the time of the
 *   attitude; rad, at most 3 pi in size: 0..2 pi and -pi..pi both, with half a turn to spare.
 *   Beyond it the result is wrong.
 * angle: al - (A sin al + B cos al + C), not wrapped; within half a unit of its last place and
 *   8.7e-11 rad.
 * tilt: about x and y, at the corrected angle, rad; within 2.6e-10 rad of the exact function.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_correct(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t encoder[1],
    int32_t angle[1], int32_t tilt[2]);

/*
 * Give the attitude quaternion of the body. Type of values: int32_t.
 *
 * angle: rad, as correct() gives it.
 * tilt: about x and y, rad, as correct() gives it.
 * q_nb: w, x, y, z; body to navigation, C_b^n = C_s^n C_s'^s C_b^s'.
 * Each component is within 3e-08 of the exact function of the arguments and of the attitude that
 *   quaternion() gives.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_body_quaternion(
    const rotation_vector_3_coning_rins_fixed32_compensated_state *state, const int32_t angle[1],
    const int32_t tilt[2], int32_t q_nb[4]);

/*
 * Give the direction cosine matrix of the body. Type of values: int32_t.
 *
 * q_nb: as body_quaternion() gives it.
 * c_nb: row major, v_n = C_nb v_b.
 */
void rotation_vector_3_coning_rins_fixed32_compensated_body_dcm(const int32_t q_nb[4], int32_t c_nb[9]);

/*
 * Give roll, pitch and yaw of the body. Type of values: int32_t.
 *
 * q_nb: as body_quaternion() gives it.
 * rpy: roll, pitch, yaw, rad, convention zxy; roll and yaw in [-pi, pi], pitch at most pi/2 in
 *   size.
 * The attitude of the three angles is within 16 last bits of theirs of the quaternion's, poles
 *   included; roll and yaw each within 16 such bits over cos(pitch).
 */
void rotation_vector_3_coning_rins_fixed32_compensated_body_euler(const int32_t q_nb[4], int32_t rpy[3]);

#ifdef __cplusplus
}
#endif

#endif
