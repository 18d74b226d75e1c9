/* Generated, do not edit. Made by: qcone generate adams_moulton_4.toml --design adams_moulton_4_runge_kutta_4_float64
 *
 * qcone 0.1.0, design adams_moulton_4_runge_kutta_4_float64, SHA-256 of the design
 * 58c21ef15d20d0b86b63cfc213c488100d4f88befff89da5ac315897e2be9b8e
 *
 * algorithm:   adams-moulton-4-runge-kutta-4, form factored, q' = q + dq, renormalised on every
 *              update
 * source:      thesis2008 Adams-Moulton, Milne
 * equation:    p = q + h (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24; q + h (9 f_p + 19 f_0 - 5 f_1 +
 *              f_2)/24
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 200 updates/s; |dtheta| <= 0.050004 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * hold as-written            0       0    0         0       0       0     0     0     0       0
 * hold shared                0       0    0         0       0       0     0     0     0       0
 * hold emitted               0       0    0         0       0       0     0     0     0       0
 * start_up as-written      264       0  181        46      12       0     0     0     0       0
 * start_up shared          221      34  165        58       3       0     0     0     0       0
 * start_up emitted         221      34  165        58       3       0     0     0     0       0
 * steady as-written         75       0   37        23       2       0     0     0     0       0
 * steady shared             74       1   37        23       1       0     0     0     0       0
 * steady emitted            74       1   37        23       1       0     0     0     0       0
 * dcm as-written             9       0    9         6       0       0     0     0     0       0
 * dcm shared                 9       0    9         6       0       0     0     0     0       0
 * dcm emitted                9       0    9         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT64_H
#define ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT64_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "adams_moulton_4_runge_kutta_4_float64: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "adams_moulton_4_runge_kutta_4_float64: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (DBL_MANT_DIG != 53)
#error "adams_moulton_4_runge_kutta_4_float64: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT64_VERSION 1
/* Samples handed to one update. */
#define ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT64_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT64_INTERVAL_S 0.005
/* Initialiser of a state: what init() sets. */
#define ADAMS_MOULTON_4_RUNGE_KUTTA_4_FLOAT64_STATE_INIT { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }, 0 }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    double q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    double omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
    double f[12]; /* slopes of the last steps, newest first: h q', as written q' */
    double error[4]; /* Milne's estimate of the last step's error */
    double rates[6]; /* rates taken while the starter waits, oldest first, rad/s */
    int32_t count; /* updates since the last restart, as far as they matter */
} adams_moulton_4_runge_kutta_4_float64_state;

/*
 * Set the identity attitude and clear the history. Type of values: double.
 *
 * The attitude is the identity; history and residual are empty.
 */
void adams_moulton_4_runge_kutta_4_float64_init(adams_moulton_4_runge_kutta_4_float64_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: double.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The newest rate is kept: start() need not be called again.
 */
void adams_moulton_4_runge_kutta_4_float64_set_quaternion(
    adams_moulton_4_runge_kutta_4_float64_state *state, const double q_nb[4]);

/*
 * Take the rate sample at the start of the first update. Type of values: double.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void adams_moulton_4_runge_kutta_4_float64_start(
    adams_moulton_4_runge_kutta_4_float64_state *state, const double omega[3]);

/*
 * Advance the attitude by one update. Type of values: double.
 *
 * omega: 1 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 10.001; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: not bounded.
 * After a restart the attitude is held for two updates and current from the third on: see ready().
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void adams_moulton_4_runge_kutta_4_float64_update(
    adams_moulton_4_runge_kutta_4_float64_state *state, const double omega[3]);

/*
 * Give the attitude quaternion. Type of values: double.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void adams_moulton_4_runge_kutta_4_float64_quaternion(
    const adams_moulton_4_runge_kutta_4_float64_state *state, double q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: double.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void adams_moulton_4_runge_kutta_4_float64_dcm(
    const adams_moulton_4_runge_kutta_4_float64_state *state, double c_nb[9]);

/*
 * Give the estimated error of the last update. Type of values: double.
 *
 * e: Milne's estimate of the last step's error, components w, x, y, z of the quaternion.
 */
void adams_moulton_4_runge_kutta_4_float64_error_estimate(
    const adams_moulton_4_runge_kutta_4_float64_state *state, double e[4]);

/*
 * Tell whether the attitude is current. Type of values: double.
 *
 * 1 once the attitude belongs to the time of the newest rate; 0 before the first update, and while
 *   the starter waits.
 */
int adams_moulton_4_runge_kutta_4_float64_ready(const adams_moulton_4_runge_kutta_4_float64_state *state);

#ifdef __cplusplus
}
#endif

#endif
