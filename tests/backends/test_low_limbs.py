"""The last bits of a word as a signed number: by C, by the model and by definition, at both ends and about the cut."""

from __future__ import annotations

import numpy as np
import pytest

from qcone.backends import bittrue_fixed
from qcone.backends.c_furniture import furniture
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Operation, Place, Program, Role, Routine, Shape
from qcone.targets.build import build_shared
from qcone.targets.compiler import Compiler, compilers
from qcone.targets.host import Library

FIXED32 = Fixed("fixed32", 32)
CUTS = (2, 8, 15, 16, 31)


def lows() -> list[Operation]:
    return [
        Operation(k, MachineOp.LOW, (0,), format=Signal(32, 30), detail=Shift(bits)) for k, bits in enumerate(CUTS, 1)
    ]


def words(bits: int) -> np.ndarray:
    half, step = 1 << (bits - 1), 1 << bits
    near = [sign * (k * step + off) for k in (0, 1, 5) for off in (0, 1, half - 1, half, half + 1) for sign in (1, -1)]
    near += [-(2**31), 2**31 - 1, *np.random.default_rng(bits).integers(-(2**31), 2**31, 200).tolist()]
    return np.array([each for each in near if -(2**31) <= each < 2**31], np.int64)


def exact(given: np.ndarray, bits: int) -> list[int]:
    """Return the one number of from -2^(bits-1) to 2^(bits-1) - 1 that differs by a multiple of 2^bits."""
    return [
        next(
            x
            for x in (int(w) % (1 << bits), int(w) % (1 << bits) - (1 << bits))
            if 2 * abs(x) < 1 << bits or 2 * x == -(1 << bits)
        )
        for w in given
    ]


@pytest.mark.parametrize("bits", CUTS)
def test_the_model_takes_the_last_bits(bits: int) -> None:
    given = words(bits)
    low = Operation(1, MachineOp.LOW, (0,), format=Signal(32, 30), detail=Shift(bits))
    assert bittrue_fixed.run(low, {0: given}, {}, [], False).tolist() == exact(given, bits)


@pytest.mark.parametrize("compiler", compilers(), ids=lambda each: each.name)
@pytest.mark.parametrize("shifts", ["arithmetically", "otherwise"])
def test_the_c_takes_the_last_bits(compiler: Compiler, shifts: str) -> None:
    """On a machine that shifts a negative word arithmetically, and by what is written for every other."""
    read = Operation(0, MachineOp.READ, place=Place("x"), format=Signal(32, 30))
    routine = Routine("update", (Block("x", Shape.SCALAR, Role.INPUT, format=Signal(32, 30)),), (read, *lows()))
    small = "".join(each.text for each in furniture(Program("lows", (), (routine,)), FIXED32))
    text = small.replace("-1) >> 1) == -1) ?", "-1) >> 1) == 0) ?") if shifts == "otherwise" else small
    assert (text != small) == (shifts == "otherwise")
    heads = [f"void run_{bits}(int32_t rows, const int64_t *x, int64_t *out)" for bits in CUTS]
    loops = "".join(
        f"{head};\n{head}\n{{\n    for (int32_t k = 0; k < rows; k++) {{ out[k] = low_{bits}((int32_t)x[k]); }}\n}}\n"
        for head, bits in zip(heads, CUTS, strict=True)
    )
    source = {"lows.c": "#include <stdint.h>\n" + text + loops}
    library = Library(build_shared(compiler, source, "-O2"), "".join(f"{head};" for head in heads))
    for bits in CUTS:
        given = words(bits)
        out = np.zeros(len(given), np.int64)
        library.run(f"run_{bits}", len(given), given, out)
        assert out.tolist() == exact(given, bits), bits
