/* Test only: runs rows of vectors through adams_moulton_4_fixed32_compensated
 * and writes every word of its state and outputs. Not part of the firmware; compiled beside it so that what is
 * tested is what ships.
 */
#include <stdint.h>

#include "adams_moulton_4_fixed32_compensated.h"

#if ADAMS_MOULTON_4_FIXED32_COMPENSATED_VERSION != 1
#error "adams_moulton_4_fixed32_compensated.h is of another version than this file: generate both again"
#endif

void adams_moulton_4_fixed32_compensated_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    int64_t *words, int32_t *contracted);

/* restart: 0 goes on, 1 is init, 2 is set_quaternion with the row's attitude; either takes `before` by start. */
void adams_moulton_4_fixed32_compensated_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    int64_t *words, int32_t *contracted)
{
    static const adams_moulton_4_fixed32_compensated_state initial =
        ADAMS_MOULTON_4_FIXED32_COMPENSATED_STATE_INIT;
    adams_moulton_4_fixed32_compensated_state state = initial;
    int32_t reported[9];
    for (int32_t row = 0; row < rows; ++row) {
        int64_t *out = &words[38 * row];
        if (restart[row] == 1) {
            adams_moulton_4_fixed32_compensated_init(&state);
        } else if (restart[row] == 2) {
            adams_moulton_4_fixed32_compensated_set_quaternion(&state, &attitude[4 * row]);
        }
        if (restart[row] != 0) {
            adams_moulton_4_fixed32_compensated_start(&state, &before[3 * row]);
        }
        adams_moulton_4_fixed32_compensated_update(&state, &input[3 * row]);
        *out++ = state.q[0];
        *out++ = state.q[1];
        *out++ = state.q[2];
        *out++ = state.q[3];
        *out++ = (int64_t)state.omega_last[0];
        *out++ = (int64_t)state.omega_last[1];
        *out++ = (int64_t)state.omega_last[2];
        *out++ = (int64_t)state.f[0];
        *out++ = (int64_t)state.f[1];
        *out++ = (int64_t)state.f[2];
        *out++ = (int64_t)state.f[3];
        *out++ = (int64_t)state.f[4];
        *out++ = (int64_t)state.f[5];
        *out++ = (int64_t)state.f[6];
        *out++ = (int64_t)state.f[7];
        *out++ = (int64_t)state.f[8];
        *out++ = (int64_t)state.f[9];
        *out++ = (int64_t)state.f[10];
        *out++ = (int64_t)state.f[11];
        *out++ = (int64_t)state.error[0];
        *out++ = (int64_t)state.error[1];
        *out++ = (int64_t)state.error[2];
        *out++ = (int64_t)state.error[3];
        *out++ = (int64_t)state.rates[0];
        *out++ = (int64_t)state.rates[1];
        *out++ = (int64_t)state.rates[2];
        *out++ = (int64_t)state.rates[3];
        *out++ = (int64_t)state.rates[4];
        *out++ = (int64_t)state.rates[5];
        *out++ = (int64_t)state.count;
        adams_moulton_4_fixed32_compensated_quaternion(&state, reported);
        for (int32_t k = 0; k < 4; ++k) {
            *out++ = reported[k];
        }
        adams_moulton_4_fixed32_compensated_error_estimate(&state, reported);
        for (int32_t k = 0; k < 4; ++k) {
            *out++ = reported[k];
        }
    }
    *contracted = 0;
}
