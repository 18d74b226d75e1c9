/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_3_coning_rate_fixed32
 *
 * qcone 0.1.0, design rotation_vector_3_coning_rate_fixed32, SHA-256 of the design
 * 3ae4617739c375514976a5ec496c47ad432deb9d402d3822246506f56b078e39
 *
 * algorithm:   rotation-vector-3-coning, form factored, q' = q + q (x) (r - 1), renormalised on
 *              every update
 * source:      cao (12), cao (14)
 * equation:    phi = theta_1 + theta_2 + theta_3 + 9/20 theta_1 x theta_3 + 27/40 theta_2 x
 *              (theta_3 - theta_1)
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (17.322 rad/s), 100 updates/s; |dtheta| <= 0.081797 rad; |phi|
 *              <= 0.2575 rad; | |q| - 1 | <= 0.0156 always, proved; each component of an input
 *              beyond it is clamped to it
 * truncation:  minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *              2.2e-14 (scalar), 3.1e-12 (vector), proved over the rationals
 * rounding:    one update is within 3.3e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  17 of 29 rounded sums of products drop a whole word, 11 before formats were
 *              searched for that; of one update's errors in the first order it made 3.4e-09 of
 *              3.3e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       80       0   64        13       0       0     0     0     0       0      0
 * update shared           76       4   64        13       0       0     0     0     0       0      0
 * update emitted          76       0   55        19       3       0     0     0     0       9     63
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_3_CONING_RATE_FIXED32_H
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_3_coning_rate_fixed32: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_Q_FRACTION_BITS 30
/* omega: value = raw * 2^-25. */
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_OMEGA_FRACTION_BITS 25
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_SUBSAMPLES 3
/* Time of one update in seconds. */
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_3_CONING_RATE_FIXED32_STATE_INIT { { 1073741824, 0, 0, 0 }, { 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
} rotation_vector_3_coning_rate_fixed32_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_3_coning_rate_fixed32_init(rotation_vector_3_coning_rate_fixed32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The newest rate is kept: start() need not be called again.
 */
void rotation_vector_3_coning_rate_fixed32_set_quaternion(
    rotation_vector_3_coning_rate_fixed32_state *state, const int32_t q_nb[4]);

/*
 * Take the rate sample at the start of the first update. Type of values: int32_t.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void rotation_vector_3_coning_rate_fixed32_start(
    rotation_vector_3_coning_rate_fixed32_state *state, const int32_t omega[3]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * omega: 3 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 17.322; each component of an input beyond it is clamped to it.
 * Truncation: minimax polynomials of degree 3 (cos) and 2 (sin) in |phi|^2; error of r at most
 *   2.2e-14 (scalar), 3.1e-12 (vector), proved over the rationals.
 * Rounding: one update is within 3.3e-09 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_3_coning_rate_fixed32_update(
    rotation_vector_3_coning_rate_fixed32_state *state, const int32_t omega[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_3_coning_rate_fixed32_quaternion(
    const rotation_vector_3_coning_rate_fixed32_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
