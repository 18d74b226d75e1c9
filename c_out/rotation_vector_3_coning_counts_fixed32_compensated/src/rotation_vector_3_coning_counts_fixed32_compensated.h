/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_counts_fixed32_compensated
 *
 * qcone 0.1.0, design rotation_vector_3_coning_counts_fixed32_compensated, SHA-256 of the design
 * 9b14171298474ac6d86ad9f442001eade149f9816a5fda86819d12b183ac5abc
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 3465 deg/s (60.476 rad/s), 100 updates/s; |dtheta| <= 0.20159 rad; |phi|
 *              <= 0.678 rad; | |q| - 1 | <= 0.1 always, proved; within it no sum overflows, as is
 *              proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 4 (cos) and 4 (sin) in |phi|^2; error of r at most
 *              2.2e-14 (scalar), 6.1e-15 (vector), proved over the rationals
 * rounding:    one update is within 9.3e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  3 of 28 rounded sums of products drop a whole word, 3 before formats were searched
 *              for that; of one update's errors in the first order it made 3.7e-09 of 3.7e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       56       0   40        13       0       0     0     0     0       0      0
 * update shared           52       4   40        13       0       0     0     0     0       0      0
 * update emitted          52       0   54        26       3       0     0     0     0       0     55
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_H
#define ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_3_coning_counts_fixed32_compensated: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_Q_FRACTION_BITS 30
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_COUNTS_FIXED32_COMPENSATED_STATE_INIT { { INT64_C(4611686018427387904), INT64_C(0), INT64_C(0), INT64_C(0) }, { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int64_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t residual[15]; /* roundings carried to the next update: of theta1, theta2, theta3, phi, v */
} rotation_vector_3_coning_counts_fixed32_compensated_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_3_coning_counts_fixed32_compensated_init(
    rotation_vector_3_coning_counts_fixed32_compensated_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_3_coning_counts_fixed32_compensated_set_quaternion(
    rotation_vector_3_coning_counts_fixed32_compensated_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * counts: 3 x 3 values, counts[3*k + axis], sub-sample k = 0 first; whole counts of 125/2048
 *   deg/s, the mean rate of each sub-sample; sensor axes.
 * Range: rate at most 3465 deg/s in norm; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 4 (cos) and 4 (sin) in |phi|^2; error of r at most
 *   2.2e-14 (scalar), 6.1e-15 (vector), proved over the rationals.
 * Rounding: one update is within 9.3e-09 of exact arithmetic, in the norm of the components, what
 *   is carried included, which does not add up; proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_counts_fixed32_compensated_update(
    rotation_vector_3_coning_counts_fixed32_compensated_state *state, const int16_t counts[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_counts_fixed32_compensated_quaternion(
    const rotation_vector_3_coning_counts_fixed32_compensated_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
