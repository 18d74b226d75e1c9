"""Report fused and flushed arithmetic: a C function that tells whether the build it stands in contracts a*b + c.

A fused multiply-add skips the rounding of the product, so the bits are no longer those of the written
operations. The probe multiplies numbers whose product is one rounding away from a known value and subtracts
that value: what remains is 0 when the product was rounded, and the lost bits when it was not. And half of the
smallest normal number is 0 where an FPU takes subnormal numbers for zero, which no compiler flag shows.
"""

from __future__ import annotations

import functools
import platform
import subprocess
import sys
from pathlib import Path

CONTRACTED = 1
"""Bit 0 of the probe: a*b + c was fused, in one expression or across two statements."""

SLP_CONTRACTED = 2
"""Bit 1 of the probe: neighbouring subtract and add lanes were fused (gcc's SLP vectoriser)."""

FLUSHED = 4
"""Bit 2 of the probe: subnormal results are zero."""

# (1 + e)^2 = 1 + 2e + e^2 with e^2 a quarter of an ulp: rounding drops e^2, fusing does not.
# Every form reads its own operands: a compiler does not fuse a product that has another use.
_PLAIN = """\
/* 1 + e and 1 + 2e, its square when that is rounded; e = 2^-BITS. Volatile: the compiler computes nothing. */
static volatile REAL probe_REAL[2] = {FACTOR, PRODUCT};

/* Volatile here too: comparing the difference with zero could become comparing its two sides. */
static int probe_REAL_left(REAL remainder)
{
    const volatile REAL left = remainder;
    return (left < ZERO) || (left > ZERO);
}

static int probe_REAL_plain(void)
{
    const REAL a = probe_REAL[0];
    const REAL expression = (a * a) - probe_REAL[1];
    const REAL b = probe_REAL[0];
    const REAL c = probe_REAL[1];
    const REAL forward = b * b;
    const REAL subtracted = forward - c;
    const REAL d = probe_REAL[0];
    const REAL e = probe_REAL[1];
    const REAL backward = d * d;
    const REAL reversed = e - backward;
    return probe_REAL_left(expression) || probe_REAL_left(subtracted) || probe_REAL_left(reversed);
}

/* The smallest normal number; half of it is not zero. */
static volatile REAL probe_REAL_smallest = SMALLEST;

static int probe_REAL_flushed(void)
{
    const volatile REAL halved = probe_REAL_smallest * HALF;
    return !(halved > ZERO);
}

"""

_PAIRED = """\
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
int NAME(void)
{
    const int fused = ((probe_float_plain() || probe_double_plain()) ? 1 : 0) | (probe_paired() ? 2 : 0);
    return fused | ((probe_float_flushed() || probe_double_flushed()) ? 4 : 0);
}
"""

_TYPES = (
    ("float", "13", "1.0001220703125F", "1.000244140625F", "0.0F", "0.5F", "1.17549435e-38F"),
    (
        "double",
        "27",
        "1.000000007450580596923828125",
        "1.00000001490116119384765625",
        "0.0",
        "0.5",
        "2.2250738585072014e-308",
    ),
)


def contraction_probe(name: str) -> str:
    """Return C99 text that defines `int <name>(void)`: CONTRACTED, SLP_CONTRACTED and FLUSHED as a bit mask, 0 = none.

    Compile it in the same build, with the same flags, as the code it is to speak for.
    """
    text = "int NAME(void);\n\n"
    for real, bits, factor, product, zero, half, smallest in _TYPES:
        plain = _PLAIN.replace("REAL", real).replace("BITS", bits).replace("ZERO", zero)
        plain = plain.replace("HALF", half).replace("SMALLEST", smallest)
        text += plain.replace("FACTOR", factor).replace("PRODUCT", product)
    return (text + _PAIRED).replace("NAME", name)


@functools.cache
def has_fma() -> bool:
    """Tell whether this processor has a fused multiply-add, without which nothing can contract."""
    machine = platform.machine().lower()
    if machine in {"arm64", "aarch64", "ppc64le", "s390x", "riscv64"}:
        return True
    if sys.platform == "darwin":
        return "FMA" in _sysctl("machdep.cpu.features").split()
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="ascii", errors="replace").splitlines()
    except OSError:
        return False
    return any("fma" in line.split() for line in lines if line.startswith("flags"))


def _sysctl(key: str) -> str:
    try:
        return subprocess.run(["sysctl", "-n", key], capture_output=True, text=True, check=False).stdout
    except OSError:
        return ""
