/* Generated, do not edit. Made by: qcone generate euler_angles.toml --design euler_angles_float32
 *
 * qcone 0.1.0, design euler_angles_float32, SHA-256 of the design
 * 48f9ab909fb15d098c2ce998e1c0eeb8cbf9c60df0768fb012ea2137726dc478
 *
 * algorithm:   euler-angles, form factored, rpy' = rpy + change
 * source:      cao introduction; kinematics of roll, pitch, yaw
 * equation:    Runge-Kutta on roll' = wx + tan(pitch) (wy sin(roll) + wz cos(roll)), ...
 * number:      float32, every operation rounded once
 * flags:       -std=c99 -ffp-contract=off; with gcc, where the target has vector FMA, also
 *              -fno-tree-vectorize
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.058338 rad;
 *              beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can
 *              diverge to NaN for good, so clamp inputs that can be so large; setting the attitude
 *              anew brings it back
 * truncation:  sine and cosine by polynomials, each within a quarter of the last place of 1; the
 *              method is of order 4 in the interval
 * rounding:    not bounded
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select
 * update as-written      111       0   96        31      24       4     0     0    74     106
 * update shared          108       0   93        31      24       4     0     0    68     100
 * update emitted         108       0   93        31      24       4     0     0    68     100
 * dcm as-written          55       0   35        17       9       0     0     0    15      27
 * dcm shared              48       3   35        17       9       0     0     0    15      27
 * dcm emitted             48       3   35        17       9       0     0     0    15      27
 * euler as-written         0       0    0         0       0       0     0     0     0       0
 * euler shared             0       0    0         0       0       0     0     0     0       0
 * euler emitted            0       0    0         0       0       0     0     0     0       0
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef EULER_ANGLES_FLOAT32_H
#define EULER_ANGLES_FLOAT32_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "euler_angles_float32: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "euler_angles_float32: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (FLT_MANT_DIG != 24)
#error "euler_angles_float32: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define EULER_ANGLES_FLOAT32_VERSION 1
/* Samples handed to one update. */
#define EULER_ANGLES_FLOAT32_SUBSAMPLES 2
/* Time of one update in seconds. */
#define EULER_ANGLES_FLOAT32_INTERVAL_S 0.01F
/* Initialiser of a state: what init() sets. */
#define EULER_ANGLES_FLOAT32_STATE_INIT { { 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    float rpy[3]; /* roll, pitch, yaw, rad */
    float omega_last[3]; /* newest rate sample so far, rad/s, sensor axes */
} euler_angles_float32_state;

/*
 * Set the identity attitude and clear the history. Type of values: float.
 *
 * The attitude is the identity; history and residual are empty.
 */
void euler_angles_float32_init(euler_angles_float32_state *state);

/*
 * Set the attitude and clear the history. Type of values: float.
 *
 * angles: roll, pitch, yaw, rad, each at most pi in size; convention zyx. History is cleared.
 */
void euler_angles_float32_set_euler(euler_angles_float32_state *state, const float angles[3]);

/*
 * Take the rate sample at the start of the first update. Type of values: float.
 *
 * omega: rad/s, sensor axes. To be called once before the first update.
 */
void euler_angles_float32_start(euler_angles_float32_state *state, const float omega[3]);

/*
 * Advance the attitude by one update. Type of values: float.
 *
 * omega: 2 x 3 values, omega[3*k + axis], sub-sample k = 0 first; rad/s, the newest rate last;
 *   sensor axes.
 * The rate at the start of the interval is the last one of the update before, or start()'s.
 * Range: norm of each at most 10.001; beyond it nothing is bounded: accuracy is lost and, far
 *   beyond it, the state can diverge to NaN for good, so clamp inputs that can be so large;
 *   setting the attitude anew brings it back.
 * Truncation: sine and cosine by polynomials, each within a quarter of the last place of 1; the
 *   method is of order 4 in the interval.
 * Rounding: not bounded.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void euler_angles_float32_update(euler_angles_float32_state *state, const float omega[6]);

/*
 * Give the attitude quaternion. Type of values: float.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 to within a few units of the last place.
 */
void euler_angles_float32_quaternion(const euler_angles_float32_state *state, float q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: float.
 *
 * c_nb: row major, v_n = C_nb v_b, of the attitude as quaternion() gives it.
 */
void euler_angles_float32_dcm(const euler_angles_float32_state *state, float c_nb[9]);

/*
 * Give roll, pitch and yaw. Type of values: float.
 *
 * angles: roll, pitch, yaw, rad, convention zyx, as they are kept: each in [-pi, pi]. Past a pole
 *   the pitch goes on beyond pi/2.
 */
void euler_angles_float32_euler(const euler_angles_float32_state *state, float angles[3]);

#ifdef __cplusplus
}
#endif

#endif
