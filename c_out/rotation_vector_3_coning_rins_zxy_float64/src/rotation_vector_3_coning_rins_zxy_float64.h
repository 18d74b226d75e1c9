/* Generated, do not edit. Made by: qcone generate rins.toml --design rotation_vector_3_coning_rins_zxy_float64
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rins_zxy_float64, SHA-256 of the design
 * 3c1f31ccbce384fdd049a2067a908282b689d7772136cbd246153e64f512acae
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
 * euler as-written                 80       0   54        17      10       4     0     0    27      57
 * euler shared                     59      20   54        17       9       4     0     0    27      57
 * euler emitted                    59      20   54        17       9       4     0     0    27      57
 * correct as-written               32       0   25         6       3       0     0     0     5       9
 * correct shared                   32       0   25         6       3       0     0     0     5       9
 * correct emitted                  32       0   25         6       3       0     0     0     5       9
 * body_quaternion as-written       57       0   35         5      11       0     0     0     5       9
 * body_quaternion shared           54       3   29        11       3       0     0     0     5       9
 * body_quaternion emitted          54       3   29        11       3       0     0     0     5       9
 * body_dcm as-written               9       0    9         6       0       0     0     0     0       0
 * body_dcm shared                   9       0    9         6       0       0     0     0     0       0
 * body_dcm emitted                  9       0    9         6       0       0     0     0     0       0
 * body_euler as-written            80       0   54        17      10       4     0     0    27      57
 * body_euler shared                59      20   54        17       9       4     0     0    27      57
 * body_euler emitted               59      20   54        17       9       4     0     0    27      57
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_RINS_ZXY_FLOAT64_H
#define ROTATION_VECTOR_3_CONING_RINS_ZXY_FLOAT64_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "rotation_vector_3_coning_rins_zxy_float64: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "rotation_vector_3_coning_rins_zxy_float64: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (DBL_MANT_DIG != 53)
#error "rotation_vector_3_coning_rins_zxy_float64: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_RINS_ZXY_FLOAT64_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_RINS_ZXY_FLOAT64_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_RINS_ZXY_FLOAT64_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_RINS_ZXY_FLOAT64_STATE_INIT { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    double q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    double azimuth_harmonic[3]; /* A, B, C of the encoder error A sin al + B cos al + C, rad */
    double tilt_x_harmonic[3]; /* A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad */
    double tilt_y_harmonic[3]; /* A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad */
} rotation_vector_3_coning_rins_zxy_float64_state;

/*
 * Set the identity attitude and clear the history. Type of values: double.
 *
 * The attitude is the identity; history and residual are empty.
 * The correction is zero.
 */
void rotation_vector_3_coning_rins_zxy_float64_init(rotation_vector_3_coning_rins_zxy_float64_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: double.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The correction is kept.
 */
void rotation_vector_3_coning_rins_zxy_float64_set_quaternion(
    rotation_vector_3_coning_rins_zxy_float64_state *state, const double q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: double.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *   4.4e-22 (scalar), 4.1e-20 (vector), proved over the rationals.
 * Rounding: not bounded.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_rins_zxy_float64_update(
    rotation_vector_3_coning_rins_zxy_float64_state *state, const double dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: double.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_rins_zxy_float64_quaternion(
    const rotation_vector_3_coning_rins_zxy_float64_state *state, double q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: double.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void rotation_vector_3_coning_rins_zxy_float64_dcm(
    const rotation_vector_3_coning_rins_zxy_float64_state *state, double c_nb[9]);

/*
 * Give roll, pitch and yaw. Type of values: double.
 *
 * rpy: roll, pitch, yaw, rad, convention zxy; roll and yaw in [-pi, pi], pitch at most pi/2 in
 *   size.
 * The attitude of the three angles is within 8 units in the last place of pi of the quaternion's,
 *   poles included; each angle within 4 such units over cos(pitch).
 */
void rotation_vector_3_coning_rins_zxy_float64_euler(
    const rotation_vector_3_coning_rins_zxy_float64_state *state, double rpy[3]);

/*
 * Take the harmonics of the encoder's error and of the tilt. Type of values: double.
 *
 * azimuth: A, B, C of the encoder's error A sin al + B cos al + C, rins (13).
 * tilt_x: A2, B2, C2 of the sensors' tilt A2 sin 2al + B2 cos 2al + C2 about x, rins (16).
 * tilt_y: the same about y.
 * Range: rad; sqrt(A^2 + B^2) + |C| of each at most 0.0029089. Zero after init(); kept by what
 *   sets the attitude.
 */
void rotation_vector_3_coning_rins_zxy_float64_set_correction(
    rotation_vector_3_coning_rins_zxy_float64_state *state, const double azimuth[3],
    const double tilt_x[3], const double tilt_y[3]);

/*
 * Correct the encoder's angle, and give the tilt of the sensors at it. Type of values: double.
 *
 * encoder: angle of the sensors against the body about the body's z axis, at the time of the
 *   attitude; rad, at most 3 pi in size: 0..2 pi and -pi..pi both, with half a turn to spare.
 *   Beyond it the result is wrong.
 * angle: al - (A sin al + B cos al + C), not wrapped; within half a unit of its last place and
 *   5.2e-18 rad.
 * tilt: about x and y, at the corrected angle, rad; within 1.6e-17 rad of the exact function.
 */
void rotation_vector_3_coning_rins_zxy_float64_correct(
    const rotation_vector_3_coning_rins_zxy_float64_state *state, const double encoder[1],
    double angle[1], double tilt[2]);

/*
 * Give the attitude quaternion of the body. Type of values: double.
 *
 * angle: rad, as correct() gives it.
 * tilt: about x and y, rad, as correct() gives it.
 * q_nb: w, x, y, z; body to navigation, C_b^n = C_s^n C_s'^s C_b^s'.
 * Each component is within 1.8e-15 of the exact function of the arguments and of the attitude that
 *   quaternion() gives.
 */
void rotation_vector_3_coning_rins_zxy_float64_body_quaternion(
    const rotation_vector_3_coning_rins_zxy_float64_state *state, const double angle[1],
    const double tilt[2], double q_nb[4]);

/*
 * Give the direction cosine matrix of the body. Type of values: double.
 *
 * q_nb: as body_quaternion() gives it.
 * c_nb: row major, v_n = C_nb v_b.
 */
void rotation_vector_3_coning_rins_zxy_float64_body_dcm(const double q_nb[4], double c_nb[9]);

/*
 * Give roll, pitch and yaw of the body. Type of values: double.
 *
 * q_nb: as body_quaternion() gives it.
 * rpy: roll, pitch, yaw, rad, convention zxy; roll and yaw in [-pi, pi], pitch at most pi/2 in
 *   size.
 * The attitude of the three angles is within 8 units in the last place of pi of the quaternion's,
 *   poles included; each angle within 4 such units over cos(pitch).
 */
void rotation_vector_3_coning_rins_zxy_float64_body_euler(const double q_nb[4], double rpy[3]);

#ifdef __cplusplus
}
#endif

#endif
