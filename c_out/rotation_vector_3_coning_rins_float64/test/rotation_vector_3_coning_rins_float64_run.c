/* Test only: runs rows of vectors through rotation_vector_3_coning_rins_float64
 * and writes every word of its state and outputs. Not part of the firmware; compiled beside it so that what is
 * tested is what ships.
 */
#include <stdint.h>

#include "rotation_vector_3_coning_rins_float64.h"

#if ROTATION_VECTOR_3_CONING_RINS_FLOAT64_VERSION != 1
#error "rotation_vector_3_coning_rins_float64.h is of another version than this file: generate both again"
#endif

void rotation_vector_3_coning_rins_float64_run(int32_t rows, const int32_t *restart,
    const double *attitude, const double *before, const double *input,
    const double *encoder, const double *correction,
    double *words, int32_t *contracted);
int rotation_vector_3_coning_rins_float64_contracts(void);

/* 1 + e and 1 + 2e, its square when that is rounded; e = 2^-13. Volatile: the compiler computes nothing. */
static volatile float probe_float[2] = {1.0001220703125F, 1.000244140625F};

/* Volatile here too: comparing the difference with zero could become comparing its two sides. */
static int probe_float_left(float remainder)
{
    const volatile float left = remainder;
    return (left < 0.0F) || (left > 0.0F);
}

static int probe_float_plain(void)
{
    const float a = probe_float[0];
    const float expression = (a * a) - probe_float[1];
    const float b = probe_float[0];
    const float c = probe_float[1];
    const float forward = b * b;
    const float subtracted = forward - c;
    const float d = probe_float[0];
    const float e = probe_float[1];
    const float backward = d * d;
    const float reversed = e - backward;
    return probe_float_left(expression) || probe_float_left(subtracted) || probe_float_left(reversed);
}

/* The smallest normal number; half of it is not zero. */
static volatile float probe_float_smallest = 1.17549435e-38F;

static int probe_float_flushed(void)
{
    const volatile float halved = probe_float_smallest * 0.5F;
    return !(halved > 0.0F);
}

/* 1 + e and 1 + 2e, its square when that is rounded; e = 2^-27. Volatile: the compiler computes nothing. */
static volatile double probe_double[2] = {1.000000007450580596923828125, 1.00000001490116119384765625};

/* Volatile here too: comparing the difference with zero could become comparing its two sides. */
static int probe_double_left(double remainder)
{
    const volatile double left = remainder;
    return (left < 0.0) || (left > 0.0);
}

static int probe_double_plain(void)
{
    const double a = probe_double[0];
    const double expression = (a * a) - probe_double[1];
    const double b = probe_double[0];
    const double c = probe_double[1];
    const double forward = b * b;
    const double subtracted = forward - c;
    const double d = probe_double[0];
    const double e = probe_double[1];
    const double backward = d * d;
    const double reversed = e - backward;
    return probe_double_left(expression) || probe_double_left(subtracted) || probe_double_left(reversed);
}

/* The smallest normal number; half of it is not zero. */
static volatile double probe_double_smallest = 2.2250738585072014e-308;

static int probe_double_flushed(void)
{
    const volatile double halved = probe_double_smallest * 0.5;
    return !(halved > 0.0);
}

static void probe_float_lanes(const float *restrict a, const float *restrict c, float *restrict o)
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

static void probe_double_lanes(const double *restrict a, const double *restrict c, double *restrict o)
{
    const double m0 = a[0] * a[0];
    const double m1 = a[1] * a[1];
    o[0] = m0 - c[0];
    o[1] = m1 + c[1];
}

/* Called through volatile pointers: inlined, the lanes would be scalars again and would not be paired. */
static void (*volatile probe_float_call)(const float *restrict a, const float *restrict c,
                                        float *restrict o) = probe_float_lanes;
static void (*volatile probe_double_call)(const double *restrict a, const double *restrict c,
                                         double *restrict o) = probe_double_lanes;

static int probe_paired(void)
{
    const float a = probe_float[0];
    const float c = probe_float[1];
    const double x = probe_double[0];
    const double z = probe_double[1];
    const float as[4] = {a, a, a, a};
    const float cs[4] = {c, -c, c, -c};
    const double xs[2] = {x, x};
    const double zs[2] = {z, -z};
    float o[4];
    double w[2];
    int narrow;
    probe_float_call(as, cs, o);
    probe_double_call(xs, zs, w);
    narrow = probe_float_left(o[0]) || probe_float_left(o[1]) || probe_float_left(o[2]) || probe_float_left(o[3]);
    return narrow || probe_double_left(w[0]) || probe_double_left(w[1]);
}

/* Tells whether this build fuses products with sums: bit 0 = alone, bit 1 = in neighbouring lanes; and, bit 2,
 * whether it takes subnormal numbers for zero.
 */
int rotation_vector_3_coning_rins_float64_contracts(void)
{
    const int fused = ((probe_float_plain() || probe_double_plain()) ? 1 : 0) | (probe_paired() ? 2 : 0);
    return fused | ((probe_float_flushed() || probe_double_flushed()) ? 4 : 0);
}

/* restart: 0 goes on, 1 is init, 2 is set_quaternion with the row's attitude, 3 is set_correction. */
void rotation_vector_3_coning_rins_float64_run(int32_t rows, const int32_t *restart,
    const double *attitude, const double *before, const double *input,
    const double *encoder, const double *correction,
    double *words, int32_t *contracted)
{
    static const rotation_vector_3_coning_rins_float64_state initial =
        ROTATION_VECTOR_3_CONING_RINS_FLOAT64_STATE_INIT;
    rotation_vector_3_coning_rins_float64_state state = initial;
    for (int32_t row = 0; row < rows; ++row) {
        double *out = &words[42 * row];
        if (restart[row] == 1) {
            rotation_vector_3_coning_rins_float64_init(&state);
        } else if (restart[row] == 2) {
            rotation_vector_3_coning_rins_float64_set_quaternion(&state, &attitude[4 * row]);
        } else if (restart[row] == 3) {
            const double *given = &correction[9 * row];
            rotation_vector_3_coning_rins_float64_set_correction(&state, given, &given[3], &given[6]);
        }
        rotation_vector_3_coning_rins_float64_update(&state, &input[9 * row]);
        *out++ = state.q[0];
        *out++ = state.q[1];
        *out++ = state.q[2];
        *out++ = state.q[3];
        *out++ = state.azimuth_harmonic[0];
        *out++ = state.azimuth_harmonic[1];
        *out++ = state.azimuth_harmonic[2];
        *out++ = state.tilt_x_harmonic[0];
        *out++ = state.tilt_x_harmonic[1];
        *out++ = state.tilt_x_harmonic[2];
        *out++ = state.tilt_y_harmonic[0];
        *out++ = state.tilt_y_harmonic[1];
        *out++ = state.tilt_y_harmonic[2];
        rotation_vector_3_coning_rins_float64_quaternion(&state, out);
        out += 4;
        rotation_vector_3_coning_rins_float64_dcm(&state, out);
        out += 9;
        const double *angle = &encoder[row];
        double *turn = out;
        rotation_vector_3_coning_rins_float64_correct(&state, angle, turn, &turn[1]);
        double *body = &turn[3];
        rotation_vector_3_coning_rins_float64_body_quaternion(&state, turn, &turn[1], body);
        out = &body[4];
        rotation_vector_3_coning_rins_float64_body_dcm(body, out);
        out += 9;
    }
    (void)before;
    *contracted = rotation_vector_3_coning_rins_float64_contracts();
}
