/* Test only: runs rows of vectors through rotation_vector_3_coning_float64 and writes every word of its state and outputs.
 * Not part of the firmware; compiled beside it so that what is tested is what ships.
 */
#include <stdint.h>

#include "rotation_vector_3_coning_float64.h"

#if ROTATION_VECTOR_3_CONING_FLOAT64_VERSION != 1
#error "rotation_vector_3_coning_float64_run.c and rotation_vector_3_coning_float64.h are of different versions: generate both again"
#endif

void rotation_vector_3_coning_float64_run(int32_t rows, const int32_t *restart, const double *attitude,
    const double *before, const double *input, double *words, int32_t *contracted);
int rotation_vector_3_coning_float64_contracts(void);

/* 1 + e and 1 + 2e, its square when that is rounded; e = 2^-13. Volatile: the compiler computes nothing. */
static volatile float rotation_vector_3_coning_float64_contracts_float[2] = {1.0001220703125F, 1.000244140625F};

static int rotation_vector_3_coning_float64_contracts_float_plain(void)
{
    const float a = rotation_vector_3_coning_float64_contracts_float[0];
    const float expression = (a * a) - rotation_vector_3_coning_float64_contracts_float[1];
    const float b = rotation_vector_3_coning_float64_contracts_float[0];
    const float c = rotation_vector_3_coning_float64_contracts_float[1];
    const float forward = b * b;
    const float subtracted = forward - c;
    const float d = rotation_vector_3_coning_float64_contracts_float[0];
    const float e = rotation_vector_3_coning_float64_contracts_float[1];
    const float backward = d * d;
    const float reversed = e - backward;
    return (expression != 0.0F) || (subtracted != 0.0F) || (reversed != 0.0F);
}

/* 1 + e and 1 + 2e, its square when that is rounded; e = 2^-27. Volatile: the compiler computes nothing. */
static volatile double rotation_vector_3_coning_float64_contracts_double[2] = {1.000000007450580596923828125, 1.00000001490116119384765625};

static int rotation_vector_3_coning_float64_contracts_double_plain(void)
{
    const double a = rotation_vector_3_coning_float64_contracts_double[0];
    const double expression = (a * a) - rotation_vector_3_coning_float64_contracts_double[1];
    const double b = rotation_vector_3_coning_float64_contracts_double[0];
    const double c = rotation_vector_3_coning_float64_contracts_double[1];
    const double forward = b * b;
    const double subtracted = forward - c;
    const double d = rotation_vector_3_coning_float64_contracts_double[0];
    const double e = rotation_vector_3_coning_float64_contracts_double[1];
    const double backward = d * d;
    const double reversed = e - backward;
    return (expression != 0.0) || (subtracted != 0.0) || (reversed != 0.0);
}

static void rotation_vector_3_coning_float64_contracts_float_lanes(const float *restrict a, const float *restrict c, float *restrict o)
{
    const float m0 = a[0] * a[0];
    const float m1 = a[1] * a[1];
    const float m2 = a[2] * a[2];
    const float m3 = a[3] * a[3];
    o[0] = m0 - c[0];
    o[1] = m1 + c[1];
    o[2] = m2 - c[2];
    o[3] = m3 + c[3];
}

static void rotation_vector_3_coning_float64_contracts_double_lanes(const double *restrict a, const double *restrict c, double *restrict o)
{
    const double m0 = a[0] * a[0];
    const double m1 = a[1] * a[1];
    o[0] = m0 - c[0];
    o[1] = m1 + c[1];
}

/* Called through volatile pointers: inlined, the lanes would be scalars again and would not be paired. */
static void (*volatile rotation_vector_3_coning_float64_contracts_float_call)(const float *restrict a, const float *restrict c,
                                        float *restrict o) = rotation_vector_3_coning_float64_contracts_float_lanes;
static void (*volatile rotation_vector_3_coning_float64_contracts_double_call)(const double *restrict a, const double *restrict c,
                                         double *restrict o) = rotation_vector_3_coning_float64_contracts_double_lanes;

static int rotation_vector_3_coning_float64_contracts_paired(void)
{
    const float a = rotation_vector_3_coning_float64_contracts_float[0];
    const float c = rotation_vector_3_coning_float64_contracts_float[1];
    const double x = rotation_vector_3_coning_float64_contracts_double[0];
    const double z = rotation_vector_3_coning_float64_contracts_double[1];
    const float as[4] = {a, a, a, a};
    const float cs[4] = {c, -c, c, -c};
    const double xs[2] = {x, x};
    const double zs[2] = {z, -z};
    float o[4];
    double w[2];
    int narrow;
    rotation_vector_3_coning_float64_contracts_float_call(as, cs, o);
    rotation_vector_3_coning_float64_contracts_double_call(xs, zs, w);
    narrow = (o[0] != 0.0F) || (o[1] != 0.0F) || (o[2] != 0.0F) || (o[3] != 0.0F);
    return narrow || (w[0] != 0.0) || (w[1] != 0.0);
}

/* Tells whether this build fuses products with sums: bit 0 = alone, bit 1 = in neighbouring lanes. */
int rotation_vector_3_coning_float64_contracts(void)
{
    return ((rotation_vector_3_coning_float64_contracts_float_plain() || rotation_vector_3_coning_float64_contracts_double_plain()) ? 1 : 0) | (rotation_vector_3_coning_float64_contracts_paired() ? 2 : 0);
}


/* restart: 0 goes on, 1 is init, 2 is set_quaternion with the row's attitude. */
void rotation_vector_3_coning_float64_run(int32_t rows, const int32_t *restart, const double *attitude,
    const double *before, const double *input, double *words, int32_t *contracted)
{
    rotation_vector_3_coning_float64_state state = ROTATION_VECTOR_3_CONING_FLOAT64_STATE_INIT;
    for (int32_t row = 0; row < rows; ++row) {
        double *out = &words[17 * row];
        if (restart[row] == 1) {
            rotation_vector_3_coning_float64_init(&state);
        } else if (restart[row] == 2) {
            rotation_vector_3_coning_float64_set_quaternion(&state, &attitude[4 * row]);
        }
        rotation_vector_3_coning_float64_update(&state, &input[9 * row]);
        *out++ = state.q[0];
        *out++ = state.q[1];
        *out++ = state.q[2];
        *out++ = state.q[3];
        rotation_vector_3_coning_float64_quaternion(&state, out);
        out += 4;
        rotation_vector_3_coning_float64_dcm(&state, out);
        out += 9;
    }
    (void)before;
    *contracted = rotation_vector_3_coning_float64_contracts();
}
