/* Generated, do not edit. Made by: qcone generate adams_moulton_4.toml --design adams_moulton_4_fixed32_compensated
 *
 * qcone 0.1.0, design adams_moulton_4_fixed32_compensated, SHA-256 of the design
 * 8dba7dd27a69fbf9f468c1a5bb888ea24642a79b341fd4cbba1b512b03909956
 *
 * algorithm:   adams-moulton-4-runge-kutta-4, form factored, q' = q + dq, the rounding carried to
 *              the next update, kept in twice the bits, renormalised on every update
 * source:      thesis2008 Adams-Moulton, Milne
 * equation:    p = q + h (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24; q + h (9 f_p + 19 f_0 - 5 f_1 +
 *              f_2)/24
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 200 updates/s; |dtheta| <= 0.050004 rad; | |q|
 *              - 1 | <= 0.2 always, proved; within it no sum overflows, as is proved; beyond it
 *              nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 8e-09 of exact arithmetic, in the norm of the components, what
 *              is carried included, which does not add up; proved
 * high words:  7 of 27 rounded sums of products drop a whole word, 7 before formats were searched
 *              for that; of one update's errors in the first order it made 1.2e-08 of 1.2e-08
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * hold as-written            0       0    0         0       0       0     0     0     0       0      0
 * hold shared                0       0    0         0       0       0     0     0     0       0      0
 * hold emitted               0       0    0         0       0       0     0     0     0       0      3
 * start_up as-written      264       0  181        46      12       0     0     0     0       0      0
 * start_up shared          221      34  165        58       3       0     0     0     0       0      0
 * start_up emitted         221       0  206        17      29       0     0     0     0       0    194
 * steady as-written         75       0   37        23       2       0     0     0     0       0      0
 * steady shared             74       1   37        23       1       0     0     0     0       0      0
 * steady emitted            74       0   44        16      10       0     0     0     0       0     71
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ADAMS_MOULTON_4_FIXED32_COMPENSATED_H
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "adams_moulton_4_fixed32_compensated: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-30. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_Q_FRACTION_BITS 30
/* omega: value = raw * 2^-26. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_OMEGA_FRACTION_BITS 26
/* e: value = raw * 2^-36. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_E_FRACTION_BITS 36
/* Interface of the emitted code; companions check it. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_VERSION 1
/* Samples handed to one update. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_INTERVAL_S 0.005
/* Initialiser of a state: what init() sets. */
#define ADAMS_MOULTON_4_FIXED32_COMPENSATED_STATE_INIT { { INT64_C(4611686018427387904), INT64_C(0), INT64_C(0), INT64_C(0) }, { 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, 0 }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int64_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    int32_t omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
    int32_t f[12]; /* slopes of the last steps, newest first: h q', as written q' */
    int32_t error[4]; /* Milne's estimate of the last step's error */
    int32_t rates[6]; /* rates taken while the starter waits, oldest first, rad/s */
    int32_t count; /* updates since the last restart, as far as they matter */
} adams_moulton_4_fixed32_compensated_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void adams_moulton_4_fixed32_compensated_init(adams_moulton_4_fixed32_compensated_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int32_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The newest rate is kept: start() need not be called again.
 */
void adams_moulton_4_fixed32_compensated_set_quaternion(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t q_nb[4]);

/*
 * Take the rate sample at the start of the first update. Type of values: int32_t.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void adams_moulton_4_fixed32_compensated_start(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * omega: 1 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 10.001; within it no sum overflows, as is proved; beyond it nothing
 *   is promised: clamp inputs that can be so large.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: one update is within 8e-09 of exact arithmetic, in the norm of the components, what is
 *   carried included, which does not add up; proved.
 * After a restart the attitude is held for two updates and current from the third on: see ready().
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void adams_moulton_4_fixed32_compensated_update(
    adams_moulton_4_fixed32_compensated_state *state, const int32_t omega[3]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void adams_moulton_4_fixed32_compensated_quaternion(
    const adams_moulton_4_fixed32_compensated_state *state, int32_t q_nb[4]);

/*
 * Give the estimated error of the last update. Type of values: int32_t.
 *
 * e: Milne's estimate of the last step's error, components w, x, y, z of the quaternion.
 */
void adams_moulton_4_fixed32_compensated_error_estimate(
    const adams_moulton_4_fixed32_compensated_state *state, int32_t e[4]);

/*
 * Tell whether the attitude is current. Type of values: int32_t.
 *
 * 1 once the attitude belongs to the time of the newest rate; 0 before the first update, and while
 *   the starter waits.
 */
int adams_moulton_4_fixed32_compensated_ready(const adams_moulton_4_fixed32_compensated_state *state);

#ifdef __cplusplus
}
#endif

#endif
