/* Test only: runs rows of vectors through dcm_taylor_3_10_fixed32
 * and writes every word of its state and outputs. Not part of the firmware; compiled beside it so that what is
 * tested is what ships.
 */
#include <stdint.h>

#include "dcm_taylor_3_10_fixed32.h"

#if DCM_TAYLOR_3_10_FIXED32_VERSION != 1
#error "dcm_taylor_3_10_fixed32.h is of another version than this file: generate both again"
#endif

void dcm_taylor_3_10_fixed32_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    int64_t *words, int32_t *contracted);

/* restart: 0 goes on, 1 is init, 2 is set_dcm with the row's attitude. */
void dcm_taylor_3_10_fixed32_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    int64_t *words, int32_t *contracted)
{
    static const dcm_taylor_3_10_fixed32_state initial =
        DCM_TAYLOR_3_10_FIXED32_STATE_INIT;
    dcm_taylor_3_10_fixed32_state state = initial;
    int32_t reported[9];
    for (int32_t row = 0; row < rows; ++row) {
        int64_t *out = &words[22 * row];
        if (restart[row] == 1) {
            dcm_taylor_3_10_fixed32_init(&state);
        } else if (restart[row] == 2) {
            dcm_taylor_3_10_fixed32_set_dcm(&state, &attitude[9 * row]);
        }
        dcm_taylor_3_10_fixed32_update(&state, &input[9 * row]);
        *out++ = (int64_t)state.c[0];
        *out++ = (int64_t)state.c[1];
        *out++ = (int64_t)state.c[2];
        *out++ = (int64_t)state.c[3];
        *out++ = (int64_t)state.c[4];
        *out++ = (int64_t)state.c[5];
        *out++ = (int64_t)state.c[6];
        *out++ = (int64_t)state.c[7];
        *out++ = (int64_t)state.c[8];
        dcm_taylor_3_10_fixed32_quaternion(&state, reported);
        for (int32_t k = 0; k < 4; ++k) {
            *out++ = reported[k];
        }
        dcm_taylor_3_10_fixed32_dcm(&state, reported);
        for (int32_t k = 0; k < 9; ++k) {
            *out++ = reported[k];
        }
    }
    (void)before;
    *contracted = 0;
}
