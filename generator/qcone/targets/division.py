"""Does a build divide as IEEE 754 says? Runtime libraries of targets without a divider do not always.

The division of ziglang's library (0.17) gives some subnormal quotients a last bit too little or too much. C that
divides then gives other bits there, through no fault of its own, and a report should say so.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.targets.compiler import Compiler
from qcone.targets.cross import LEVEL, built_image
from qcone.targets.emulation import Emulation, job_for
from qcone.targets.job import Buffer, Call, Pointer
from qcone.targets.machines import Target

PAIRS = 256
_TEXT = """\
void divide(int n, const {ctype} *a, const {ctype} *b, {ctype} *out);

void divide(int n, const {ctype} *a, const {ctype} *b, {ctype} *out)
{{
    for (int k = 0; k < n; ++k) {{
        out[k] = a[k] / b[k];
    }}
}}
"""


def wrong_quotient(
    compiler: Compiler, target: Target, bits: int, emulation: Emulation, cflags: Sequence[str] = ()
) -> str | None:
    """Return a subnormal quotient of floats of so many bits that a build rounds wrongly; None when all are right.

    Raises CompileError, and NotMeasuredError when the emulator crashes.
    """
    dtype = np.dtype(np.float32 if bits == 32 else np.float64)
    dividend, divisor = _operands(dtype)
    order: Any = ">" if target.big_endian else "<"
    text = _TEXT.format(ctype="float" if bits == 32 else "double")
    image = built_image(compiler, target, {"divide.c": text}, ["divide"], LEVEL, cflags)
    function = image.function("divide")
    assert function
    given = [each.astype(dtype.newbyteorder(order)).tobytes() for each in (dividend, divisor)]
    buffers = (Buffer("a", given[0]), Buffer("b", given[1]), Buffer("out", bytes(len(given[0])), True))
    call = Call(function.address, (PAIRS, Pointer(0), Pointer(1), Pointer(2)))
    ran = emulation.run(job_for(target, image, buffers, (call,)))
    found = np.frombuffer(ran.buffers[2], dtype.newbyteorder(order)).astype(dtype)
    right = dividend / divisor
    wrong = np.flatnonzero(found != right)
    if not len(wrong):
        return None
    a, b, c, d = (float(each[wrong[0]]).hex() for each in (dividend, divisor, found, right))
    return f"{a} / {b} gives {c}, not {d}"


def _operands(dtype: np.dtype[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return pairs whose quotients are subnormal and need rounding."""
    generator = np.random.default_rng(1)
    divisor = (1 + generator.random(PAIRS)).astype(dtype)
    return np.ldexp(generator.random(PAIRS), np.finfo(dtype).minexp).astype(dtype), divisor
