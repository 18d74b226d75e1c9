/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_10_fixed32
 *
 * qcone 0.1.0, design quaternion_taylor_3_10_fixed32, SHA-256 of the design
 * 76889369dae871dc1816f80008251c1dba4fc00971b9902bfdf2aefabc20a84e
 *
 * algorithm:   quaternion-taylor-3-10-start, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      xu2019 (5), (7), (8)
 * equation:    r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad; | |q|
 *              - 1 | <= 0.0156 always, proved; within it no sum overflows, as is proved; beyond it
 *              nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 1.4e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  61 of 92 rounded sums of products drop a whole word, 26 before formats were
 *              searched for that; of one update's errors in the first order it made 2.6e-09 of
 *              2.6e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      448       0  261       196       0       0     0     0     0       0      0
 * update shared          332      16  203       157       0       0     0     0     0       0      0
 * update emitted         320       0  291        14      13       0     0     0     0       0    272
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef QUATERNION_TAYLOR_3_10_FIXED32_H
#define QUATERNION_TAYLOR_3_10_FIXED32_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "quaternion_taylor_3_10_fixed32: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define QUATERNION_TAYLOR_3_10_FIXED32_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-34. */
#define QUATERNION_TAYLOR_3_10_FIXED32_DTHETA_FRACTION_BITS 34
/* Interface of the emitted code; companions check it. */
#define QUATERNION_TAYLOR_3_10_FIXED32_VERSION 1
/* Samples handed to one update. */
#define QUATERNION_TAYLOR_3_10_FIXED32_SUBSAMPLES 3
/* Time of one update in seconds. */
#define QUATERNION_TAYLOR_3_10_FIXED32_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define QUATERNION_TAYLOR_3_10_FIXED32_STATE_INIT { { 1073741824, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
} quaternion_taylor_3_10_fixed32_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void quaternion_taylor_3_10_fixed32_init(quaternion_taylor_3_10_fixed32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void quaternion_taylor_3_10_fixed32_set_quaternion(
    quaternion_taylor_3_10_fixed32_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: one update is within 1.4e-09 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void quaternion_taylor_3_10_fixed32_update(
    quaternion_taylor_3_10_fixed32_state *state, const int32_t dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void quaternion_taylor_3_10_fixed32_quaternion(
    const quaternion_taylor_3_10_fixed32_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
