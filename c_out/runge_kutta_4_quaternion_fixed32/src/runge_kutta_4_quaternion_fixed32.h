/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_quaternion_fixed32
 *
 * qcone 0.1.0, design runge_kutta_4_quaternion_fixed32, SHA-256 of the design
 * 52261c5b13c7e90c738c83efe187481b867ce01eca4690edd4b62c184c2fc207
 *
 * algorithm:   runge-kutta-4-quaternion, form factored, q' = q + dq, renormalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = 1/2 q (x) omega; q + h (k1 + 2 k2 + 2 k3 + k4)/6
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad; | |q|
 *              - 1 | <= 0.0625 always, proved; within it no sum overflows, as is proved; beyond it
 *              nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 2.7e-09 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  15 of 33 rounded sums of products drop a whole word, 3 before formats were searched
 *              for that; of one update's errors in the first order it made 4.3e-09 of 2.6e-09
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       82       0   55        13       4       0     0     0     0       0      0
 * update shared           73       9   51        17       0       0     0     0     0       0      0
 * update emitted          73       0   60         8       6       0     0     0     0       0     60
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef RUNGE_KUTTA_4_QUATERNION_FIXED32_H
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "runge_kutta_4_quaternion_fixed32: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_Q_FRACTION_BITS 30
/* omega: value = raw * 2^-26. */
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_OMEGA_FRACTION_BITS 26
/* Interface of the emitted code; companions check it. */
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_VERSION 1
/* Samples handed to one update. */
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_SUBSAMPLES 2
/* Time of one update in seconds. */
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define RUNGE_KUTTA_4_QUATERNION_FIXED32_STATE_INIT { { 1073741824, 0, 0, 0 }, { 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
} runge_kutta_4_quaternion_fixed32_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void runge_kutta_4_quaternion_fixed32_init(runge_kutta_4_quaternion_fixed32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The newest rate is kept: start() need not be called again.
 */
void runge_kutta_4_quaternion_fixed32_set_quaternion(
    runge_kutta_4_quaternion_fixed32_state *state, const int32_t q_nb[4]);

/*
 * Take the rate sample at the start of the first update. Type of values: int32_t.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void runge_kutta_4_quaternion_fixed32_start(
    runge_kutta_4_quaternion_fixed32_state *state, const int32_t omega[3]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * omega: 2 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 10.001; within it no sum overflows, as is proved; beyond it nothing
 *   is promised: clamp inputs that can be so large.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: one update is within 2.7e-09 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void runge_kutta_4_quaternion_fixed32_update(
    runge_kutta_4_quaternion_fixed32_state *state, const int32_t omega[6]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void runge_kutta_4_quaternion_fixed32_quaternion(
    const runge_kutta_4_quaternion_fixed32_state *state, int32_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
