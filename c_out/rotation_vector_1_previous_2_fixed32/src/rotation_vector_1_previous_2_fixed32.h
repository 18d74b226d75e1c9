/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_previous_2_fixed32
 *
 * qcone 0.1.0, design rotation_vector_1_previous_2_fixed32, SHA-256 of the design
 * 2cd2d571788f458964614fcf613a25f92303c4a2de67d6baa85b64913950fc86
 *
 * algorithm:   rotation-vector-1-previous-2, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      savage1998 (46)
 * equation:    phi = theta + (7/60 theta[-1] - 1/60 theta[-2]) x theta
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 400 updates/s; |dtheta| <= 0.025002 rad; |phi|
 *              <= 0.02509 rad; | |q| - 1 | <= 0.000244 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              2.3e-16 (scalar), 3.5e-13 (vector), proved over the rationals
 * rounding:    one update is within 9.9e-10 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  10 of 18 rounded sums of products drop a whole word, 0 before formats were searched
 *              for that; of one update's errors in the first order it made 2e-09 of 2e-09
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * start_up as-written       33       0   20         7       0       0     0     0     0       0      0
 * start_up shared           29       4   20         7       0       0     0     0     0       0      0
 * start_up emitted          29       0   25         2       4       0     0     0     0       0     19
 * steady as-written         45       0   26        10       0       0     0     0     0       0      0
 * steady shared             41       4   26        10       0       0     0     0     0       0      0
 * steady emitted            41       0   28         8       4       0     0     0     0       0     25
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_H
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_1_previous_2_fixed32: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-35. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_DTHETA_FRACTION_BITS 35
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_INTERVAL_S 0.0025
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FIXED32_STATE_INIT { { 1073741824, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, 0 }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t previous[6]; /* earlier angle increments, newest first, rad, sensor axes */
    int32_t count; /* updates since the last restart, as far as they matter */
} rotation_vector_1_previous_2_fixed32_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_1_previous_2_fixed32_init(rotation_vector_1_previous_2_fixed32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_1_previous_2_fixed32_set_quaternion(
    rotation_vector_1_previous_2_fixed32_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 1 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.025002; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *   2.3e-16 (scalar), 3.5e-13 (vector), proved over the rationals.
 * Rounding: one update is within 9.9e-10 of exact arithmetic, in the norm of the components;
 *   proved.
 * The first 2 updates after a restart use no history.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_1_previous_2_fixed32_update(
    rotation_vector_1_previous_2_fixed32_state *state, const int32_t dtheta[3]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_1_previous_2_fixed32_quaternion(
    const rotation_vector_1_previous_2_fixed32_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
