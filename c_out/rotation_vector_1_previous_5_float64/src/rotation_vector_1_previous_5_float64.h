/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_previous_5_float64
 *
 * qcone 0.1.0, design rotation_vector_1_previous_5_float64, SHA-256 of the design
 * 59e512ddce52a6e98ad364fc1d33de92f09b8ab90052faef053b94a909adf345
 *
 * algorithm:   rotation-vector-1-previous-5, form factored, q' = q + q (x) (r - 1), renormalised
 *              on every update
 * source:      savage1998 (46)
 * equation:    phi = theta + (4247/27720 theta[-1] - 703/13860 theta[-2] + 61/4620 theta[-3] -
 *              31/13860 theta[-4] + 1/5544 theta[-5]) x theta
 * number:      float64, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1023 rad; beyond it nothing is bounded: accuracy is lost and, far beyond it,
 *              the state can diverge to NaN for good, so clamp inputs that can be so large;
 *              setting the attitude anew brings it back
 * truncation:  minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *              4.3e-22 (scalar), 4.5e-20 (vector), proved over the rationals
 * rounding:    not bounded
 *
 * operations          multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * start_up as-written       34       0   22         7       0       0     0     0     0       0
 * start_up shared           33       1   22         7       0       0     0     0     0       0
 * start_up emitted          33       1   22         7       0       0     0     0     0       0
 * steady as-written         55       0   37        10       0       0     0     0     0       0
 * steady shared             54       1   37        10       0       0     0     0     0       0
 * steady emitted            54       1   37        10       0       0     0     0     0       0
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
#ifndef ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_H
#define ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "rotation_vector_1_previous_5_float64: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "rotation_vector_1_previous_5_float64: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (DBL_MANT_DIG != 53)
#error "rotation_vector_1_previous_5_float64: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_1_PREVIOUS_5_FLOAT64_STATE_INIT { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }, 0 }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    double q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
    double previous[15]; /* earlier angle increments, newest first, rad, sensor axes */
    int32_t count; /* updates since the last restart, as far as they matter */
} rotation_vector_1_previous_5_float64_state;

/*
 * Set the identity attitude and clear the history. Type of values: double.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_1_previous_5_float64_init(rotation_vector_1_previous_5_float64_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: double.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_1_previous_5_float64_set_quaternion(
    rotation_vector_1_previous_5_float64_state *state, const double q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: double.
 *
 * dtheta: 1 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.10001; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: minimax polynomials of degree 4 (cos) and 3 (sin) in |phi|^2; error of r at most
 *   4.3e-22 (scalar), 4.5e-20 (vector), proved over the rationals.
 * Rounding: not bounded.
 * The first 5 updates after a restart use no history.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_1_previous_5_float64_update(
    rotation_vector_1_previous_5_float64_state *state, const double dtheta[3]);

/*
 * Give the attitude quaternion. Type of values: double.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_1_previous_5_float64_quaternion(
    const rotation_vector_1_previous_5_float64_state *state, double q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: double.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void rotation_vector_1_previous_5_float64_dcm(
    const rotation_vector_1_previous_5_float64_state *state, double c_nb[9]);

#ifdef __cplusplus
}
#endif

#endif
