/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_8_midpoint_fixed32_compensated
 *
 * qcone 0.1.0, design quaternion_taylor_3_8_midpoint_fixed32_compensated, SHA-256 of the design
 * 652f0a40ef1654ed78468e2d50664704c4ffe9f011aa58ddf1c565a177e4e94a
 *
 * algorithm:   quaternion-taylor-3-8-midpoint, form factored, q' = q + q (x) (r - 1), the rounding
 *              carried to the next update, kept in twice the bits, renormalised on every update
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
 * rounding:    one update is within 4.8e-09 of exact arithmetic, in the norm of the components,
 *              what is carried included, which does not add up; proved
 * high words:  60 of 81 rounded sums of products drop a whole word, 22 before formats were
 *              searched for that; of one update's errors in the first order it made 1.3e-09 of
 *              1.3e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      416       0  260       169       0       0     0     0     0       0      0
 * update shared          268      16  185       145       0       0     0     0     0       0      0
 * update emitted         256       0  263        23      15       0     0     0     0       0    267
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_H
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "quaternion_taylor_3_8_midpoint_fixed32_compensated: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_Q_FRACTION_BITS 30
/* dtheta: value = raw * 2^-34. */
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_DTHETA_FRACTION_BITS 34
/* Interface of the emitted code; companions check it. */
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_VERSION 1
/* Samples handed to one update. */
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_SUBSAMPLES 3
/* Time of one update in seconds. */
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define QUATERNION_TAYLOR_3_8_MIDPOINT_FIXED32_COMPENSATED_STATE_INIT { { INT64_C(4611686018427387904), INT64_C(0), INT64_C(0), INT64_C(0) }, { 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int64_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t residual[3]; /* roundings carried to the next update: of v */
} quaternion_taylor_3_8_midpoint_fixed32_compensated_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void quaternion_taylor_3_8_midpoint_fixed32_compensated_init(
    quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void quaternion_taylor_3_8_midpoint_fixed32_compensated_set_quaternion(
    quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state, const int32_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: one update is within 4.8e-09 of exact arithmetic, in the norm of the components, what
 *   is carried included, which does not add up; proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void quaternion_taylor_3_8_midpoint_fixed32_compensated_update(
    quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state, const int32_t dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void quaternion_taylor_3_8_midpoint_fixed32_compensated_quaternion(
    const quaternion_taylor_3_8_midpoint_fixed32_compensated_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
