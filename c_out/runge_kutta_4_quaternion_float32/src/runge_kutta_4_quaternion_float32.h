/* Generated, do not edit. Made by: qcone generate runge_kutta_4.toml --design runge_kutta_4_quaternion_float32
 *
 * qcone 0.1.0, design runge_kutta_4_quaternion_float32, SHA-256 of the design
 * fdf53a1309533f0eb16c977abbe6fa360894380199bbac1674b2c32a6f0e2341
 *
 * algorithm:   runge-kutta-4-quaternion, form factored, q' = q + dq, renormalised on every update
 * source:      classical Runge 1895, Kutta 1901
 * equation:    k = 1/2 q (x) omega; q + h (k1 + 2 k2 + 2 k3 + k4)/6
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written       82       0   55        13       4       0     0     0     0       0
 * update shared           73       9   51        17       0       0     0     0     0       0
 * update emitted          73       9   51        17       0       0     0     0     0       0
 * dcm as-written           9       0    9         6       0       0     0     0     0       0
 * dcm shared               9       0    9         6       0       0     0     0     0       0
 * dcm emitted              9       0    9         6       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef RUNGE_KUTTA_4_QUATERNION_FLOAT32_H
#define RUNGE_KUTTA_4_QUATERNION_FLOAT32_H

#include <float.h>

#ifdef __FAST_MATH__
#error "runge_kutta_4_quaternion_float32: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "runge_kutta_4_quaternion_float32: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (FLT_MANT_DIG != 24)
#error "runge_kutta_4_quaternion_float32: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define RUNGE_KUTTA_4_QUATERNION_FLOAT32_VERSION 1
/* Samples handed to one update. */
#define RUNGE_KUTTA_4_QUATERNION_FLOAT32_SUBSAMPLES 2
/* Time of one update in seconds. */
#define RUNGE_KUTTA_4_QUATERNION_FLOAT32_INTERVAL_S 0.01F
/* Initialiser of a state: what init() sets. */
#define RUNGE_KUTTA_4_QUATERNION_FLOAT32_STATE_INIT { { 1.0F, 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    float q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    float omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
} runge_kutta_4_quaternion_float32_state;

/*
 * Set the identity attitude and clear the history. Type of values: float.
 *
 * The attitude is the identity; history and residual are empty.
 */
void runge_kutta_4_quaternion_float32_init(runge_kutta_4_quaternion_float32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: float.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The newest rate is kept: start() need not be called again.
 */
void runge_kutta_4_quaternion_float32_set_quaternion(
    runge_kutta_4_quaternion_float32_state *state, const float q_nb[4]);

/*
 * Take the rate sample at the start of the first update. Type of values: float.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void runge_kutta_4_quaternion_float32_start(
    runge_kutta_4_quaternion_float32_state *state, const float omega[3]);

/*
 * Advance the attitude by one update. Type of values: float.
 *
 * omega: 2 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 10.001; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: not bounded.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void runge_kutta_4_quaternion_float32_update(
    runge_kutta_4_quaternion_float32_state *state, const float omega[6]);

/*
 * Give the attitude quaternion. Type of values: float.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void runge_kutta_4_quaternion_float32_quaternion(
    const runge_kutta_4_quaternion_float32_state *state, float q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: float.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void runge_kutta_4_quaternion_float32_dcm(
    const runge_kutta_4_quaternion_float32_state *state, float c_nb[9]);

#ifdef __cplusplus
}
#endif

#endif
