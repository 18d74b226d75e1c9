/* Generated, do not edit. Made by: qcone generate dcm_taylor.toml --design dcm_taylor_3_10_fixed32
 *
 * qcone 0.1.0, design dcm_taylor_3_10_fixed32, SHA-256 of the design
 * 0bb560cbd17565042464e7d9c47312e8a83259d92141a7c74adc62632cb061e6
 *
 * algorithm:   dcm-taylor-3-10, form factored, C' = C + dC, two rows and their cross product,
 *              re-orthogonalised on every update
 * source:      xu2019 (10) to (13), (11) and (13) corrected; xu2019 (11) multiplies from the wrong
 *              side; xu2019 (13) lacks the constants 1, 2, 6
 * equation:    v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j, row by row
 * number:      fixed32: words of 32 bits, sums in 64; every sum of products rounded once, to
 *              nearest, halves up; formats and bounds stand beside every line: F fraction bits,
 *              value = raw * 2^-F
 * flags:       -std=c99; no other flag matters
 *
 * range:       |omega| <= 573 deg/s (10.001 rad/s), 100 updates/s; |dtheta| <= 0.033336 rad;
 *              length of a row of C, less 1, <= 0.22 always, proved; within it no sum overflows,
 *              as is proved; beyond it nothing is promised: clamp inputs that can be so large
 * truncation:  no function is approximated; the method is of order 4 in the interval
 * rounding:    one update is within 1.2e-08 of exact arithmetic, in the norm of the components;
 *              proved
 * high words:  78 of 159 rounded sums of products drop a whole word, 78 before formats were
 *              searched for that; of one update's errors in the first order it made 2.7e-08 of
 *              2.7e-08
 *
 * operations        multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select  shift
 * update as-written      473       0  285       197       0       0     0     0     0       0      0
 * update shared          399      20  252       179       0       0     0     0     0       0      0
 * update emitted         399       0  345        17      10       0     0     0     0       0    366
 * dcm as-written           0       0    0         0       0       0     0     0     0       0      0
 * dcm shared               0       0    0         0       0       0     0     0     0       0      0
 * dcm emitted              0       0    0         0       0       0     0     0     0       0      0
 *
 * Integer arithmetic of C99 alone, without undefined and without implementation-defined results:
 * the bits are the same on every conforming compiler and processor, whatever its flags.
 *
 * SPDX-License-Identifier: MIT-0
 * The maker of the generator claims no rights in this file.
 */
#ifndef DCM_TAYLOR_3_10_FIXED32_H
#define DCM_TAYLOR_3_10_FIXED32_H

#include <stdint.h>

#if !defined(INT16_MAX) || !defined(INT32_MAX) || !defined(INT64_MAX)
#error "dcm_taylor_3_10_fixed32: needs integers of exactly 16, 32 and 64 bits"
#endif

/* c: value = raw * 2^-30. */
#define DCM_TAYLOR_3_10_FIXED32_C_FRACTION_BITS 30
/* dtheta: value = raw * 2^-34. */
#define DCM_TAYLOR_3_10_FIXED32_DTHETA_FRACTION_BITS 34
/* q: value = raw * 2^-30. */
#define DCM_TAYLOR_3_10_FIXED32_Q_FRACTION_BITS 30
/* Interface of the emitted code; companions check it. */
#define DCM_TAYLOR_3_10_FIXED32_VERSION 1
/* Samples handed to one update. */
#define DCM_TAYLOR_3_10_FIXED32_SUBSAMPLES 3
/* Time of one update in seconds. */
#define DCM_TAYLOR_3_10_FIXED32_INTERVAL_S 0.01
/* Initialiser of a state: what init() sets. */
#define DCM_TAYLOR_3_10_FIXED32_STATE_INIT { { 1073741824, 0, 0, 0, 1073741824, 0, 0, 0, 1073741824 } }

#ifdef __cplusplus
extern "C" {
#endif

/* The state of one attitude; its members are private. */
typedef struct {
    int32_t c[9]; /* direction cosine matrix C_nb, row major: v_n = C_nb v_b */
} dcm_taylor_3_10_fixed32_state;

/*
 * Set the identity attitude and clear the history. Type of values: int32_t.
 *
 * The attitude is the identity; history and residual are empty.
 */
void dcm_taylor_3_10_fixed32_init(dcm_taylor_3_10_fixed32_state *state);

/*
 * Set the attitude, orthonormalised once, and clear the history. Type of values: int32_t.
 *
 * c_nb: row major, orthonormal to within the format's rounding; v_n = C_nb v_b.
 * One Newton step orthonormalises two rows, the third is their cross product. History is cleared.
 */
void dcm_taylor_3_10_fixed32_set_dcm(dcm_taylor_3_10_fixed32_state *state, const int32_t c_nb[9]);

/*
 * Advance the attitude by one update. Type of values: int32_t.
 *
 * dtheta: 3 x 3 values, dtheta[3*k + axis], sub-sample k = 0 first; rad, the integral of the body
 *   rate over each sub-sample; sensor axes.
 * Range: norm of each at most 0.033336; within it no sum overflows, as is proved; beyond it
 *   nothing is promised: clamp inputs that can be so large.
 * Truncation: no function is approximated; the method is of order 4 in the interval.
 * Rounding: one update is within 1.2e-08 of exact arithmetic, in the norm of the components;
 *   proved.
 * Arguments must not overlap the state. A reader that interrupts an update may see a torn state.
 */
void dcm_taylor_3_10_fixed32_update(dcm_taylor_3_10_fixed32_state *state, const int32_t dtheta[9]);

/*
 * Give the attitude quaternion. Type of values: int32_t.
 *
 * q_nb: w, x, y, z; body to navigation. |q_nb| = 1 but for rounding and what the truncation of one
 *   update adds.
 */
void dcm_taylor_3_10_fixed32_quaternion(const dcm_taylor_3_10_fixed32_state *state, int32_t q_nb[4]);

/*
 * Give the direction cosine matrix. Type of values: int32_t.
 *
 * c_nb: row major, v_n = C_nb v_b, as it is kept.
 */
void dcm_taylor_3_10_fixed32_dcm(const dcm_taylor_3_10_fixed32_state *state, int32_t c_nb[9]);

#ifdef __cplusplus
}
#endif

#endif
