/* Generated, do not edit. Made by: qcone generate picard.toml --design picard_1_4_fixed32
 *
 * qcone 0.1.0, design picard_1_4_fixed32, SHA-256 of the design
 * fd07beb50933e25b227a45a11b2133c9d397ae748e483079a28b07e8ca7ed334
 *
 * algorithm:   picard-4, form factored, q' = q + q (x) (r - 1), renormalised on every update
 * source:      cao (7), (8), (9)
 * equation:    r = [a_c, a_s sigma], sigma = theta
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; | |q|
 *              - 1 | <= 0.00391 always, proved; within it no sum overflows, as is proved; beyond
 *              it nothing is promised: clamp inputs that can be so large
 * truncation:  series of the algorithm's order in |phi|; error of r at most 2.2e-11 (scalar),
 *              2.6e-09 (vector)
 * rounding:    one update is within 2.3e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  10 of 12 rounded sums of products drop a whole word, 2 before formats were searched
 *              for that; of one update's errors in the first order it made 3.6e-09 of 2.3e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       30       0   17         8       0       0     0     0     0       0      0
 * update shared           29       1   17         8       0       0     0     0     0       0      0
 * update emitted          29       0   22         3       3       0     0     0     0       0     13
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef PICARD_1_4_FIXED32_H
#define PICARD_1_4_FIXED32_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "picard_1_4_fixed32: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define PICARD_1_4_FIXED32_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-33. */
#define PICARD_1_4_FIXED32_DTHETA_FRACTION_BITS 33
/* Interface of the emitted code; companions check it. */
#define PICARD_1_4_FIXED32_VERSION 1
/* Samples handed to one update. */
#define PICARD_1_4_FIXED32_SUBSAMPLES 1
/* Time of one update in seconds. */
#define PICARD_1_4_FIXED32_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define PICARD_1_4_FIXED32_STATE_INIT { { 1073741824, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
} picard_1_4_fixed32_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void picard_1_4_fixed32_init(picard_1_4_fixed32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void picard_1_4_fixed32_set_quaternion(picard_1_4_fixed32_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 1 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.10001; within it no sum overflows, as is proved; beyond it nothing
 *   is promised: clamp inputs that can be so large.
 * Truncation: series of the algorithm's order in |phi|; error of r at most 2.2e-11 (scalar),
 *   2.6e-09 (vector).
 * Rounding: one update is within 2.3e-09 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void picard_1_4_fixed32_update(picard_1_4_fixed32_state *state, const int32_t dtheta[3]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void picard_1_4_fixed32_quaternion(const picard_1_4_fixed32_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
