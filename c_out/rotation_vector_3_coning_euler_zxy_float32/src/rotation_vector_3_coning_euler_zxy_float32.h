/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_euler_zxy_float32
 *
 * qcone 0.1.0, design rotation_vector_3_coning_euler_zxy_float32, SHA-256 of the design
 * 0b036e947ad3308f3c958881ff69c461963e24c050993590859788bb8ee54846
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
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
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              1.1e-12 (scalar), 3.8e-10 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       39       0   33        13       0       0     0     0     0       0
 * update shared           38       1   33        13       0       0     0     0     0       0
 * update emitted          38       1   33        13       0       0     0     0     0       0
 * euler as-written        56       0   32        17      10       4     0     0    26      55
 * euler shared            37      18   32        17       9       4     0     0    26      55
 * euler emitted           37      18   32        17       9       4     0     0    26      55
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_EULER_ZXY_FLOAT32_H
#define ROTATION_VECTOR_3_CONING_EULER_ZXY_FLOAT32_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "rotation_vector_3_coning_euler_zxy_float32: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "rotation_vector_3_coning_euler_zxy_float32: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (FLT_MANT_DIG != 24)
#error "rotation_vector_3_coning_euler_zxy_float32: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_EULER_ZXY_FLOAT32_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_EULER_ZXY_FLOAT32_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_EULER_ZXY_FLOAT32_INTERVAL_S 0.01F
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_EULER_ZXY_FLOAT32_STATE_INIT { { 1.0F, 0.0F, 0.0F, 0.0F } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    float q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
} rotation_vector_3_coning_euler_zxy_float32_state;

/*
 * Set the identity attitude and clear the history. Type of values: float.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_3_coning_euler_zxy_float32_init(
    rotation_vector_3_coning_euler_zxy_float32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: float.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_3_coning_euler_zxy_float32_set_quaternion(
    rotation_vector_3_coning_euler_zxy_float32_state *state, const float q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: float.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *   1.1e-12 (scalar), 3.8e-10 (vector), proved over the rationals.
 * Rounding: not bounded.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_euler_zxy_float32_update(
    rotation_vector_3_coning_euler_zxy_float32_state *state, const float dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: float.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_euler_zxy_float32_quaternion(
    const rotation_vector_3_coning_euler_zxy_float32_state *state, float q_nb[4]);

/*
 * Give roll, pitch and yaw. Type of values: float.
 *
 * rpy: roll, pitch, yaw, rad, convention zxy; roll and yaw in [-pi, pi], pitch at most pi/2 in
 *   size.
 * The attitude of the three angles is within 8 units in the last place of pi of the quaternion's,
 *   poles included; each angle within 4 such units over cos(pitch).
 */
void rotation_vector_3_coning_euler_zxy_float32_euler(
    const rotation_vector_3_coning_euler_zxy_float32_state *state, float rpy[3]);

#ifdef __cplusplus
}
#endif

#endif
