/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_fixed32_limbs
 *
 * qcone 0.1.0, design rotation_vector_3_coning_fixed32_limbs, SHA-256 of the design
 * 8db91a0374833888d66f2e73fa16cb7b8f58892f87e38a1066b0f55ba240f52a
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums as in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; |phi|
 *              <= 0.1021 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.5e-15 (scalar), 7.8e-14 (vector), proved over the rationals
 * rounding:    one update is within 1.2e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * products:    of 16- and 15-bit limbs, added before the carry, proved to fit 32 bits: cortex-m0
 *              has none of 64 bits
 * high words:  8 of 20 rounded sums of products drop a whole word, 1 before formats were searched
 *              for that; of one update's errors in the first order it made 2.3e-09 of 2.2e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       44       0   37        13       0       0     0     0     0       0      0
 * update shared           40       4   37        13       0       0     0     0     0       0      0
 * update emitted         151       0  117        85       3       0     0     0     0       0    110
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_H
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_3_coning_fixed32_limbs: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-34. */
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_DTHETA_FRACTION_BITS 34
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_STATE_INIT { { 1073741824, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
} rotation_vector_3_coning_fixed32_limbs_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_3_coning_fixed32_limbs_init(rotation_vector_3_coning_fixed32_limbs_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_3_coning_fixed32_limbs_set_quaternion(
    rotation_vector_3_coning_fixed32_limbs_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *   2.5e-15 (scalar), 7.8e-14 (vector), proved over the rationals.
 * Rounding: one update is within 1.2e-09 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_fixed32_limbs_update(
    rotation_vector_3_coning_fixed32_limbs_state *state, const int32_t dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_fixed32_limbs_quaternion(
    const rotation_vector_3_coning_fixed32_limbs_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
