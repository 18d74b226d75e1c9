/* Generated, do not edit. Made by: qcone generate quaternion_taylor.toml --design quaternion_taylor_3_10_midpoint_float32
 *
 * qcone 0.1.0, design quaternion_taylor_3_10_midpoint_float32, SHA-256 of the design
 * 7990c3fe40bce909c5438010985f63997478ed43d2cdf2ecd0aca525f7dab0f9
 *
 * algorithm:   quaternion-taylor-3-10-midpoint, form factored, q' = q + q (x) (r - 1),
 *              renormalised on every update
 * source:      xu2019 (5), (7), (8)
 * equation:    r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written      504       0  312       205       0       0     0     0     0       0
 * update shared          348      16  233       185       0       0     0     0     0       0
 * update emitted         348      16  233       185       0       0     0     0     0       0
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
#ifndef QUATERNION_TAYLOR_3_10_MIDPOINT_FLOAT32_H
#define QUATERNION_TAYLOR_3_10_MIDPOINT_FLOAT32_H

#include <float.h>

#ifdef __FAST_MATH__
#error "quaternion_taylor_3_10_midpoint_float32: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "quaternion_taylor_3_10_midpoint_float32: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (FLT_MANT_DIG != 24)
#error "quaternion_taylor_3_10_midpoint_float32: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define QUATERNION_TAYLOR_3_10_MIDPOINT_FLOAT32_VERSION 1
/* Samples handed to one update. */
#define QUATERNION_TAYLOR_3_10_MIDPOINT_FLOAT32_SUBSAMPLES 3
/* Time of one update in seconds. */
#define QUATERNION_TAYLOR_3_10_MIDPOINT_FLOAT32_INTERVAL_S 0.01F
/* Initialiser of a state: what init() sets. */
#define QUATERNION_TAYLOR_3_10_MIDPOINT_FLOAT32_STATE_INIT { { 1.0F, 0.0F, 0.0F, 0.0F } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    float q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
} quaternion_taylor_3_10_midpoint_float32_state;

/*
 * Set the identity attitude and clear the history. Type of values: float.
 *
 * The attitude is the identity; history and residual are empty.
 */
void quaternion_taylor_3_10_midpoint_float32_init(quaternion_taylor_3_10_midpoint_float32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: float.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void quaternion_taylor_3_10_midpoint_float32_set_quaternion(
    quaternion_taylor_3_10_midpoint_float32_state *state, const float q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: float.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: not bounded.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void quaternion_taylor_3_10_midpoint_float32_update(
    quaternion_taylor_3_10_midpoint_float32_state *state, const float dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: float.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void quaternion_taylor_3_10_midpoint_float32_quaternion(
    const quaternion_taylor_3_10_midpoint_float32_state *state, float q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: float.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void quaternion_taylor_3_10_midpoint_float32_dcm(
    const quaternion_taylor_3_10_midpoint_float32_state *state, float c_nb[9]);

#ifdef __cplusplus
}
#endif

#endif
