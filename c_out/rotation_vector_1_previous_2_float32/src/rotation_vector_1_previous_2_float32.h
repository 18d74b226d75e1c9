/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_previous_2_float32
 *
 * qcone 0.1.0, design rotation_vector_1_previous_2_float32, SHA-256 of the design
 * be6c0c8fa61f0e997731eddc55992cd8598e57976fa0f5a6efee5e66c99bcfa7
 *
 * algorithm:   rotation-vector-1-previous-2, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      savage1998 (46)
 * equation:    phi = theta + (7/60 theta[-1] - 1/60 theta[-2]) x theta
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1014 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              1e-12 (scalar), 3.7e-10 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * start_up as-written       30       0   18         7       0       0     0     0     0       0
 * start_up shared           29       1   18         7       0       0     0     0     0       0
 * start_up emitted          29       1   18         7       0       0     0     0     0       0
 * steady as-written         42       0   24        10       0       0     0     0     0       0
 * steady shared             41       1   24        10       0       0     0     0     0       0
 * steady emitted            41       1   24        10       0       0     0     0     0       0
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
#ifndef ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_H
#define ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "rotation_vector_1_previous_2_float32: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "rotation_vector_1_previous_2_float32: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (FLT_MANT_DIG != 24)
#error "rotation_vector_1_previous_2_float32: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_INTERVAL_S 0.01F
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_1_PREVIOUS_2_FLOAT32_STATE_INIT { { 1.0F, 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F }, 0 }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    float q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    float previous[6]; /* earlier angle increments, newest first, rad, sensor axes */
    int32_t count; /* updates since the last restart, as far as they matter */
} rotation_vector_1_previous_2_float32_state;

/*
 * Set the identity attitude and clear the history. Type of values: float.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_1_previous_2_float32_init(rotation_vector_1_previous_2_float32_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: float.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_1_previous_2_float32_set_quaternion(
    rotation_vector_1_previous_2_float32_state *state, const float q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: float.
 *
 * dtheta: 1 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.10001; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *   1e-12 (scalar), 3.7e-10 (vector), proved over the rationals.
 * Rounding: not bounded.
 * The first 2 updates after a restart use no history.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_1_previous_2_float32_update(
    rotation_vector_1_previous_2_float32_state *state, const float dtheta[3]);

/*
 * Give the attitude quaternion. Type of values: float.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_1_previous_2_float32_quaternion(
    const rotation_vector_1_previous_2_float32_state *state, float q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: float.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void rotation_vector_1_previous_2_float32_dcm(
    const rotation_vector_1_previous_2_float32_state *state, float c_nb[9]);

#ifdef __cplusplus
}
#endif

#endif
