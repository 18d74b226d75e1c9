/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_euler_float64
 *
 * qcone 0.1.0, design dcm_taylor_3_10_euler_float64, SHA-256 of the design
 * 44f78c9d4b1694acd1328571bd38d59c6fc88f5466b160b5b316eaa79c8bbb54
 *
 * algorithm:   dcm-taylor-3-10, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      xu2019 (10) to (13), (11) and (13) corrected; xu2019 (11) multiplies from the wrong
 *              side; xu2019 (13) lacks the constants 1, 2, 6
 * equation:    v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j, row by row
 * number:      float64, every operation rounded once
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
 * update as-written      473       0  285       197       0       0     0     0     0       0
 * update shared          399      20  252       179       0       0     0     0     0       0
 * update emitted         399      20  252       179       0       0     0     0     0       0
 * dcm as-written           0       0    0         0       0       0     0     0     0       0
 * dcm shared               0       0    0         0       0       0     0     0     0       0
 * dcm emitted              0       0    0         0       0       0     0     0     0       0
 * euler as-written       101       0   73        28      10       4     0     0    30      72
 * euler shared            77      23   73        28       9       4     0     0    30      72
 * euler emitted           77      23   73        28       9       4     0     0    30      72
 *
 * The bits are the same on every machine that rounds each operation to its own IEEE 754 format.
 * Under flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload
 * and sign of a NaN are unspecified.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef DCM_TAYLOR_3_10_EULER_FLOAT64_H
#define DCM_TAYLOR_3_10_EULER_FLOAT64_H

#include <float.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "dcm_taylor_3_10_euler_float64: compile without -ffast-math: the order of operations is part of the result"
#endif
#if !defined(FLT_EVAL_METHOD) && defined(__TINYC__) && !defined(__i386__)
/* tcc does not say; everywhere but on the x87 it rounds every operation to its own type. */
#elif !defined(FLT_EVAL_METHOD) || (FLT_EVAL_METHOD != 0)
#error "dcm_taylor_3_10_euler_float64: needs FLT_EVAL_METHOD 0: every operation rounded to its own type"
#endif
#if (FLT_RADIX != 2) || (DBL_MANT_DIG != 53)
#error "dcm_taylor_3_10_euler_float64: needs the binary formats of IEEE 754"
#endif

/* Interface of the emitted code; companions check it. */
#define DCM_TAYLOR_3_10_EULER_FLOAT64_VERSION 1
/* Samples handed to one update. */
#define DCM_TAYLOR_3_10_EULER_FLOAT64_SUBSAMPLES 3
/* Time of one update in seconds. */
#define DCM_TAYLOR_3_10_EULER_FLOAT64_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define DCM_TAYLOR_3_10_EULER_FLOAT64_STATE_INIT { { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    double c[9]; /* direction cosine matrix C_nb, row major: v_n = C_nb v_b */
} dcm_taylor_3_10_euler_float64_state;

/*
 * Set the identity attitude and clear the history. Type of values: double.
 *
 * The attitude is the identity; history and residual are empty.
 */
void dcm_taylor_3_10_euler_float64_init(dcm_taylor_3_10_euler_float64_state *state);

/*
 * Set the attitude, orthonormalised once, and clear the history. Type of values: double.
 *
 * c_nb: row major, orthonormal to within the format's rounding; v_n = C_nb v_b.
 * One Newton step orthonormalises two rows, the third is their cross product. History is cleared.
 */
void dcm_taylor_3_10_euler_float64_set_dcm(
    dcm_taylor_3_10_euler_float64_state *state, const double c_nb[9]);

/*
 * Advance the attitude by one update. Type of values: double.
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
void dcm_taylor_3_10_euler_float64_update(
    dcm_taylor_3_10_euler_float64_state *state, const double dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: double.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void dcm_taylor_3_10_euler_float64_quaternion(
    const dcm_taylor_3_10_euler_float64_state *state, double q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: double.
 *
 * c_nb: row major, v_n = C_nb v_b, as it is kept.
 */
void dcm_taylor_3_10_euler_float64_dcm(const dcm_taylor_3_10_euler_float64_state *state, double c_nb[9]);

/*
 * Give roll, pitch and yaw. Type of values: double.
 *
 * rpy: roll, pitch, yaw, rad, convention zyx; roll and yaw in [-pi, pi], pitch at most pi/2 in
 *   size.
 * The attitude of the three angles is within 8 units in the last place of pi of the quaternion's,
 *   poles included; each angle within 4 such units over cos(pitch).
 */
void dcm_taylor_3_10_euler_float64_euler(const dcm_taylor_3_10_euler_float64_state *state, double rpy[3]);

#ifdef __cplusplus
}
#endif

#endif
