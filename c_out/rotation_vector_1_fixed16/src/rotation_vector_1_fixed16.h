/* Generated, do not edit. Made by: qcone generate rotation_vector.toml --design rotation_vector_1_fixed16
 *
 * qcone 0.1.0, design rotation_vector_1_fixed16, SHA-256 of the design
 * 1ea0e80fb39ec4301f6247cbfb772aeddb3aa8d59bdc31410e425130c90399bd
 *
 * algorithm:   rotation-vector-1, form factored, q' = q + q (x) (r - 1), renormalised on every
 *              update
 * source:      cao (8), (9)
 * equation:    phi = theta
 * number:      fixed16: words of 16 bits, sums in 32; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.10001 rad; |phi|
 *              <= 0.1001 rad; | |q| - 1 | <= 0.00391 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *              2.2e-11 (scalar), 2.6e-09 (vector), proved over the rationals
 * rounding:    one update is within 6.7e-05 of exact arithmetic, in the norm of the components;
 *              proved
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written       33       0   20         7       0       0     0     0     0       0      0
 * update shared           29       4   20         7       0       0     0     0     0       0      0
 * update emitted          29       0   21         6       1       0     0     0     0       0     32
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef ROTATION_VECTOR_1_FIXED16_H
#define ROTATION_VECTOR_1_FIXED16_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "rotation_vector_1_fixed16: needs integers of exactly 16, 32 and 64 bits"
#endif

/* q: value = raw * 2^-14. */
#define ROTATION_VECTOR_1_FIXED16_Q_FRACTION_BITS 14
/* dtheta: value = raw * 2^-17. */
#define ROTATION_VECTOR_1_FIXED16_DTHETA_FRACTION_BITS 17
/* Interface of the emitted code; companions check it. */
#define ROTATION_VECTOR_1_FIXED16_VERSION 1
/* Samples handed to one update. */
#define ROTATION_VECTOR_1_FIXED16_SUBSAMPLES 1
/* Time of one update in seconds. */
#define ROTATION_VECTOR_1_FIXED16_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define ROTATION_VECTOR_1_FIXED16_STATE_INIT { { 16384, 0, 0, 0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int16_t q[4]; /* attitude quaternion q_nb: w, x, y, z; body to navigation */
} rotation_vector_1_fixed16_state;

/*
 * Set the identity attitude and clear the history. Type of values: int16_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void rotation_vector_1_fixed16_init(rotation_vector_1_fixed16_state *state);

/*
 * Set the attitude, normalised once, and clear the history. Type of values: int16_t.
 *
 * q_nb: w, x, y, z, of unit length to within the format's rounding; body to navigation.
 * One Newton step normalises it: an error e of |q|^2 becomes 3/4 e^2. History and residual are
 *   cleared.
 */
void rotation_vector_1_fixed16_set_quaternion(
    rotation_vector_1_fixed16_state *state, const int16_t q_nb[4]);

/*
 * Advance the attitude by one update. Type of values: int16_t.
 *
 * dtheta: 1 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.10001; within it no sum overflows, as is proved; beyond it nothing
 *   is promised: clamp inputs that can be so large.
 * Truncation: minimax polynomials of degree 2 (cos) and 1 (sin) in |phi|^2; error of r at most
 *   2.2e-11 (scalar), 2.6e-09 (vector), proved over the rationals.
 * Rounding: one update is within 6.7e-05 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void rotation_vector_1_fixed16_update(rotation_vector_1_fixed16_state *state, const int16_t dtheta[3]);

/*
 * Give the attitude quaternion. Type of values: int16_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void rotation_vector_1_fixed16_quaternion(const rotation_vector_1_fixed16_state *state, int16_t q_nb[4]);

#ifdef __cplusplus
}
#endif

#endif
