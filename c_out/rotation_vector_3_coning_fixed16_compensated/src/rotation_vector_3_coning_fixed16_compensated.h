/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_fixed16_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_fixed16_compensated, SHA-256 of the design
 * 66c168fe78656ad166a9c298e8b934d1a669109f574b48ea597cf71b2231ecdc
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed16: words of 16 bits, sums in 32; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              2.5e-11 (scalar), 4.2e-10 (vector), proved over the rationals
 * rounding:    one update is within 0.00028 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       42       0   35        13       0       0     0     0     0       0      0
 * update shared           38       4   35        13       0       0     0     0     0       0      0
 * update emitted          38       0   39        18       1       0     0     0     0       0     54
 * dcm as-written           9       0    9         6       0       0     0     0     0       0      0
 * dcm shared               9       0    9         6       0       0     0     0     0       0      0
 * dcm emitted              9       0    6         6       0       0     0     0     0       0     19
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_H
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_3_coning_fixed16_compensated: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-14. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_Q_FRACTION_BITS 14
/* dtheta: value = raw * 2^-18. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_DTHETA_FRACTION_BITS 18
/* c: value = raw * 2^-14. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_C_FRACTION_BITS 14
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_FIXED16_COMPENSATED_STATE_INIT { { 1073741824, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int16_t residual[6]; /* roundings carried to the next update: of phi, v */
} rotation_vector_3_coning_fixed16_compensated_state;

/*
 * Set the identity attitude and clear the history. Type of values: int16_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_3_coning_fixed16_compensated_init(
    rotation_vector_3_coning_fixed16_compensated_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int16_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_3_coning_fixed16_compensated_set_quaternion(
    rotation_vector_3_coning_fixed16_compensated_state *state, const int16_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int16_t.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *   2.5e-11 (scalar), 4.2e-10 (vector), proved over the rationals.
 * Rounding: one update is within 0.00028 of exact arithmetic, in the norm of the components, what
 *   is carried included, which does not add up; proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_fixed16_compensated_update(
    rotation_vector_3_coning_fixed16_compensated_state *state, const int16_t dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: int16_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_fixed16_compensated_quaternion(
    const rotation_vector_3_coning_fixed16_compensated_state *state, int16_t q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: int16_t.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void rotation_vector_3_coning_fixed16_compensated_dcm(
    const rotation_vector_3_coning_fixed16_compensated_state *state, int16_t c_nb[9]);

#ifdef __cplusplus
}
#endif

#endif
