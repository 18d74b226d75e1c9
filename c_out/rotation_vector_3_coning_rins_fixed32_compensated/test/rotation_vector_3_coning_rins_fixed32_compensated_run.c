/* Test only: runs rows of vectors through rotation_vector_3_coning_rins_fixed32_compensated
 * and writes every word of its state and outputs. Not part of the firmware; compiled beside it so that what is
 * tested is what ships.
 */
#include <stdint.h>

#include "rotation_vector_3_coning_rins_fixed32_compensated.h"

#if ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_VERSION != 1
#error "rotation_vector_3_coning_rins_fixed32_compensated.h is of another version than this file: generate both again"
#endif

void rotation_vector_3_coning_rins_fixed32_compensated_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    const int32_t *encoder, const int32_t *correction,
    int64_t *words, int32_t *contracted);

/* restart: 0 goes on, 1 is init, 2 is set_quaternion with the row's attitude, 3 is set_correction. */
void rotation_vector_3_coning_rins_fixed32_compensated_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    const int32_t *encoder, const int32_t *correction,
    int64_t *words, int32_t *contracted)
{
    static const rotation_vector_3_coning_rins_fixed32_compensated_state initial =
        ROTATION_VECTOR_3_CONING_RINS_FIXED32_COMPENSATED_STATE_INIT;
    rotation_vector_3_coning_rins_fixed32_compensated_state state = initial;
    int32_t reported[9];
    for (int32_t row = 0; row < rows; ++row) {
        int64_t *out = &words[54 * row];
        if (restart[row] == 1) {
            rotation_vector_3_coning_rins_fixed32_compensated_init(&state);
        } else if (restart[row] == 2) {
            rotation_vector_3_coning_rins_fixed32_compensated_set_quaternion(&state, &attitude[4 * row]);
        } else if (restart[row] == 3) {
            const int32_t *given = &correction[9 * row];
            rotation_vector_3_coning_rins_fixed32_compensated_set_correction(&state, given, &given[3], &given[6]);
        }
        rotation_vector_3_coning_rins_fixed32_compensated_update(&state, &input[9 * row]);
        *out++ = state.q[0];
        *out++ = state.q[1];
        *out++ = state.q[2];
        *out++ = state.q[3];
        *out++ = (int64_t)state.residual[0];
        *out++ = (int64_t)state.residual[1];
        *out++ = (int64_t)state.residual[2];
        *out++ = (int64_t)state.residual[3];
        *out++ = (int64_t)state.residual[4];
        *out++ = (int64_t)state.residual[5];
        *out++ = (int64_t)state.azimuth_harmonic[0];
        *out++ = (int64_t)state.azimuth_harmonic[1];
        *out++ = (int64_t)state.azimuth_harmonic[2];
        *out++ = (int64_t)state.tilt_x_harmonic[0];
        *out++ = (int64_t)state.tilt_x_harmonic[1];
        *out++ = (int64_t)state.tilt_x_harmonic[2];
        *out++ = (int64_t)state.tilt_y_harmonic[0];
        *out++ = (int64_t)state.tilt_y_harmonic[1];
        *out++ = (int64_t)state.tilt_y_harmonic[2];
        rotation_vector_3_coning_rins_fixed32_compensated_quaternion(&state, reported);
        for (int32_t k = 0; k < 4; ++k) {
            *out++ = reported[k];
        }
        rotation_vector_3_coning_rins_fixed32_compensated_dcm(&state, reported);
        for (int32_t k = 0; k < 9; ++k) {
            *out++ = reported[k];
        }
        rotation_vector_3_coning_rins_fixed32_compensated_euler(&state, reported);
        for (int32_t k = 0; k < 3; ++k) {
            *out++ = reported[k];
        }
        const int32_t *angle = &encoder[row];
        int32_t turn[3];
        int32_t body[4];
        rotation_vector_3_coning_rins_fixed32_compensated_correct(&state, angle, turn, &turn[1]);
        rotation_vector_3_coning_rins_fixed32_compensated_body_quaternion(&state, turn, &turn[1], body);
        for (int32_t k = 0; k < 3; ++k) {
            *out++ = turn[k];
        }
        for (int32_t k = 0; k < 4; ++k) {
            *out++ = body[k];
        }
        rotation_vector_3_coning_rins_fixed32_compensated_body_dcm(body, reported);
        for (int32_t k = 0; k < 9; ++k) {
            *out++ = reported[k];
        }
        rotation_vector_3_coning_rins_fixed32_compensated_body_euler(body, reported);
        for (int32_t k = 0; k < 3; ++k) {
            *out++ = reported[k];
        }
    }
    (void)before;
    *contracted = 0;
}
