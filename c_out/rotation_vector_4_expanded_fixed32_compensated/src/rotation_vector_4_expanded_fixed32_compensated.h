/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_4_expanded_fixed32_compensated
 *
 * qcone 0.1.0, design rotation_vector_4_expanded_fixed32_compensated, SHA-256 of the design
 * e6adf2bade428b0909970f9e0b47b098f85a081dca052b9e5cff8d60c2a09e7c
 *
 * algorithm:   rotation-vector-4-expanded, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      song2013 expanded coning, derived here, cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + theta_4 + sum k_ij theta_i x theta_j
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.025002 rad; |phi|
 *              <= 0.1022 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.5e-15 (scalar), 6.1e-15 (vector), proved over the rationals
 * rounding:    one update is within 4.3e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  7 of 22 rounded sums of products drop a whole word, 2 before formats were searched
 *              for that; of one update's errors in the first order it made 4.1e-10 of 4.1e-10
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       59       0   43        19       0       0     0     0     0       0      0
 * update shared           55       4   43        19       0       0     0     0     0       0      0
 * update emitted          55       0   49        25       3       0     0     0     0       0     49
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_H
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_4_expanded_fixed32_compensated: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-35. */
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_DTHETA_FRACTION_BITS 35
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_SUBSAMPLES 4
/* Time of one update in seconds. */
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_4_EXPANDED_FIXED32_COMPENSATED_STATE_INIT { { INT64_C(4611686018427387904), INT64_C(0), INT64_C(0), INT64_C(0) }, { 0, 0, 0, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int64_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t residual[6]; /* roundings carried to the next update: of phi, v */
} rotation_vector_4_expanded_fixed32_compensated_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_4_expanded_fixed32_compensated_init(
    rotation_vector_4_expanded_fixed32_compensated_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_4_expanded_fixed32_compensated_set_quaternion(
    rotation_vector_4_expanded_fixed32_compensated_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 4 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.025002; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *   2.5e-15 (scalar), 6.1e-15 (vector), proved over the rationals.
 * Rounding: one update is within 4.3e-09 of exact arithmetic, in the norm of the components, what
 *   is carried included, which does not add up; proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_4_expanded_fixed32_compensated_update(
    rotation_vector_4_expanded_fixed32_compensated_state *state, const int32_t dtheta[12]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_4_expanded_fixed32_compensated_quaternion(
    const rotation_vector_4_expanded_fixed32_compensated_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
