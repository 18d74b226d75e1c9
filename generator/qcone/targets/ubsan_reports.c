/* Reports of undefined behaviour for a compiler whose own runtime is slow to build: each place once, then on.
   Every record the compiler passes begins with the place; what follows it is not needed here. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

struct place {
    const char *file;
    uint32_t line;
    uint32_t column;
};

static void report(struct place *at, const char *kind)
{
    if (at->column != UINT32_MAX) {
        (void)fprintf(stderr, "%s:%lu:%lu: runtime error: %s\n", at->file, (unsigned long)at->line,
                      (unsigned long)at->column, kind);
        at->column = UINT32_MAX;
    }
}

#define RESUMES(name, kind) \
    void __ubsan_handle_##name(struct place *at); \
    void __ubsan_handle_##name(struct place *at) { report(at, kind); }

#define ENDS(name, kind) \
    void __ubsan_handle_##name(struct place *at); \
    void __ubsan_handle_##name(struct place *at) { report(at, kind); abort(); }

RESUMES(add_overflow, "signed addition overflow")
RESUMES(sub_overflow, "signed subtraction overflow")
RESUMES(mul_overflow, "signed multiplication overflow")
RESUMES(negate_overflow, "negation overflow")
RESUMES(divrem_overflow, "division by zero or division overflow")
RESUMES(shift_out_of_bounds, "shift out of bounds")
RESUMES(out_of_bounds, "index out of bounds")
RESUMES(local_out_of_bounds, "index out of bounds")
RESUMES(pointer_overflow, "pointer overflow")
RESUMES(type_mismatch_v1, "null or misaligned pointer")
RESUMES(alignment_assumption, "wrong alignment assumption")
RESUMES(float_cast_overflow, "conversion from floating point out of range")
RESUMES(load_invalid_value, "load of an invalid value")
RESUMES(implicit_conversion, "implicit conversion changes the value")
RESUMES(invalid_builtin, "invalid argument of a builtin")
RESUMES(nonnull_arg, "null argument")
RESUMES(nonnull_return_v1, "null returned")
RESUMES(nullability_arg, "null argument")
RESUMES(nullability_return_v1, "null returned")
RESUMES(vla_bound_not_positive, "array length not positive")
ENDS(builtin_unreachable, "unreachable code reached")
ENDS(missing_return, "end of function without a return")
