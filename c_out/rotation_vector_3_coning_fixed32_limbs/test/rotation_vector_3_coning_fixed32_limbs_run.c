/* Test only: runs rows of vectors through rotation_vector_3_coning_fixed32_limbs
 * and writes every word of its state and outputs. Not part of the firmware; compiled beside it so that what is
 * tested is what ships.
 */
#include <stdint.h>

#include "rotation_vector_3_coning_fixed32_limbs.h"

#if ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_VERSION != 1
#error "rotation_vector_3_coning_fixed32_limbs.h is of another version than this file: generate both again"
#endif

void rotation_vector_3_coning_fixed32_limbs_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    int64_t *words, int32_t *contracted);

/* restart: 0 goes on, 1 is init, 2 is set_quaternion with the row's attitude. */
void rotation_vector_3_coning_fixed32_limbs_run(int32_t rows, const int32_t *restart,
    const int32_t *attitude, const int32_t *before, const int32_t *input,
    int64_t *words, int32_t *contracted)
{
    static const rotation_vector_3_coning_fixed32_limbs_state initial =
        ROTATION_VECTOR_3_CONING_FIXED32_LIMBS_STATE_INIT;
    rotation_vector_3_coning_fixed32_limbs_state state = initial;
    int32_t reported[9];
    for (int32_t row = 0; row < rows; ++row) {
        int64_t *out = &words[8 * row];
        if (restart[row] == 1) {
            rotation_vector_3_coning_fixed32_limbs_init(&state);
        } else if (restart[row] == 2) {
            rotation_vector_3_coning_fixed32_limbs_set_quaternion(&state, &attitude[4 * row]);
        }
        rotation_vector_3_coning_fixed32_limbs_update(&state, &input[9 * row]);
        *out++ = (int64_t)state.q[0];
        *out++ = (int64_t)state.q[1];
        *out++ = (int64_t)state.q[2];
        *out++ = (int64_t)state.q[3];
        rotation_vector_3_coning_fixed32_limbs_quaternion(&state, reported);
        for (int32_t k = 0; k < 4; ++k) {
            *out++ = reported[k];
        }
    }
    (void)before;
    *contracted = 0;
}
