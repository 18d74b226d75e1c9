/* Generated, do not edit. Made by: qcone generate adams_moulton_4.toml --design adams_moulton_4_heun_float32
 *
 * qcone 0.1.0, design adams_moulton_4_heun_float32, SHA-256 of the design
 * b93be256459598cc9169baf584a43786c26b762354097ee3ad88a81e690e535d
 *
 * algorithm:   adams-moulton-4-heun, form factored, q' = q + dq, renormalised on every update
 * source:      thesis2008 Adams-Moulton, Milne
 * equation:    p = q + h (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24; q + h (9 f_p + 19 f_0 - 5 f_1 +
 *              f_2)/24
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 200 updates/s; |dtheta| <= 0.050004 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 3 in the interval
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * start_up as-written       43       0   29         7       2       0     0     0     0       0
 * start_up shared           38       5   27         9       1       0     0     0     0       0
 * start_up emitted          38       5   27         9       1       0     0     0     0       0
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
#ifndef ADAMS_MOULTON_4_HEUN_FLOAT32_H
#define ADAMS_MOULTON_4_HEUN_FLOAT32_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "adams_moulton_4_heun_float32: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "adams_moulton_4_heun_float32: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (FLT_MANT_DIG != 24)
#error "adams_moulton_4_heun_float32: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define ADAMS_MOULTON_4_HEUN_FLOAT32_VERSION 1
/* Samples handed to one update. */
#define ADAMS_MOULTON_4_HEUN_FLOAT32_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ADAMS_MOULTON_4_HEUN_FLOAT32_INTERVAL_S 0.005F
/* Initialiser of a state: what init() sets. */
#define ADAMS_MOULTON_4_HEUN_FLOAT32_STATE_INIT { { 1.0F, 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F, 0.0F }, 0 }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    float q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    float omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
    float f[12]; /* slopes of the last steps, newest first: h q', as written q' */
    float error[4]; /* Milne's estimate of the last step's error */
    int32_t count; /* updates since the last restart, as far as they matter */
} adams_moulton_4_heun_float32_state;

/*
 * Set the identity attitude and clear the history. Type of values: float.
 *
 * The attitude is the identity; history and residual are empty.
 */
void adams_moulton_4_heun_float32_init(adams_moulton_4_heun_float32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: float.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 * The newest rate is kept: start() need not be called again.
 */
void adams_moulton_4_heun_float32_set_quaternion(
    adams_moulton_4_heun_float32_state *state, const float q_nb[4]);

/*
 * Take the rate sample at the start of the first update. Type of values: float.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void adams_moulton_4_heun_float32_start(adams_moulton_4_heun_float32_state *state, const float omega[3]);

/*
 * Advance the attitude by one update. Type of values: float.
 *
 * omega: 1 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 10.001; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: no function is approximated; the method is of order 3 in the interval.
 * Rounding: not bounded.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void adams_moulton_4_heun_float32_update(adams_moulton_4_heun_float32_state *state, const float omega[3]);

/*
 * Give the attitude quaternion. Type of values: float.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void adams_moulton_4_heun_float32_quaternion(
    const adams_moulton_4_heun_float32_state *state, float q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: float.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void adams_moulton_4_heun_float32_dcm(const adams_moulton_4_heun_float32_state *state, float c_nb[9]);

/*
 * Give the estimated error of the last update. Type of values: float.
 *
 * e: Milne's estimate of the last step's error, components w, x, y, z of the quaternion.
 */
void adams_moulton_4_heun_float32_error_estimate(
    const adams_moulton_4_heun_float32_state *state, float e[4]);

/*
 * Tell whether the attitude is current. Type of values: float.
 *
 * 1 once the attitude belongs to the time of the newest rate; 0 before the first update, and while
 *   the starter waits.
 */
int adams_moulton_4_heun_float32_ready(const adams_moulton_4_heun_float32_state *state);

#ifdef __cplusplus
}
#endif

#endif
