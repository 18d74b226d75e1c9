"""The small C functions of fixed point against exact integers: every rounding, both signs, ties, the ends of words.

Compiled by each compiler at two levels, and run under the sanitizer of undefined behaviour. The bit-true model's
rounding is held against the same integers.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

from fixed_designs import ACCUMULATIONS, FLAGSHIP, fixed
from qcone.backends import bittrue_fixed
from qcone.backends.c_fixed import shift_name
from qcone.backends.c_furniture import furniture
from qcone.formats.fixed import ROUNDINGS, WIDTHS, Fixed, Signal
from qcone.ir.detail import Shift
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Operation, Place, Program, Role, Routine, Shape, walk
from qcone.targets.build import build_shared
from qcone.targets.compiler import Compiler, compilers
from qcone.targets.host import Library
from qcone.targets.sanitize import run_sanitized

Words = NDArray[np.int64]
Case = tuple[int, int, int, str]
"""The width of a sum, that of its result, how many bits are dropped, and how."""
ALWAYS = {1, 2, 8, 15, 16, 17, 31, 32, 33, 62}
PAIRS = {"fixed32": ((64, 64), (64, 32), (32, 32)), "fixed16": ((32, 32), (32, 16))}
NUMBERS = {name: Fixed(name, width) for name, width in WIDTHS.items()}
EACH_COMPILER = pytest.mark.parametrize("compiler", compilers(), ids=lambda each: each.name)
EACH_NUMBER = pytest.mark.parametrize("name", PAIRS)


@cache
def shifts(name: str) -> set[int]:
    """Return how many bits are dropped: few, many, about a word, and every number in the flagships."""
    bundles = [fixed(f"{FLAGSHIP} {name} {how}") for how in ACCUMULATIONS]
    seen = {
        each.detail.bits
        for bundle in bundles
        for routine in bundle.machine.routines
        for each in walk(routine.body)
        if isinstance(each, Operation) and each.op is MachineOp.SHIFT_RIGHT and isinstance(each.detail, Shift)
    }
    assert len(seen) > 5
    return seen | ALWAYS


@cache
def cases(name: str) -> dict[Case, Operation]:
    """Return every rounding of a format, as an operation."""
    made = {}
    for k, ((whole, result), bits, rounding) in enumerate(product(PAIRS[name], sorted(shifts(name)), ROUNDINGS), 2):
        if bits < whole - 1:
            shift = Shift(bits, rounding, whole)
            made[whole, result, bits, rounding] = Operation(
                k, MachineOp.SHIFT_RIGHT, (whole // 32 - 1,), format=Signal(result, -bits), detail=shift
            )
    return made


@cache
def texts(name: str) -> str:
    """Return the small functions, as they stand in a source."""
    blocks = [Block(f"x{width}", Shape.SCALAR, Role.INPUT, format=Signal(width, 0)) for width in (32, 64)]
    reads = [
        Operation(k, MachineOp.READ, place=Place(block.name, Index(0)), format=block.format)
        for k, block in enumerate(blocks)
    ]
    routine = Routine("update", tuple(blocks), (*reads, *cases(name).values()))
    made = furniture(Program("roundings", (), (routine,)), NUMBERS[name])
    assert len({each.name for each in made}) == len(made)
    return "#include <stdint.h>\n" + "".join(each.text for each in made)


def called(case: Case, name: str) -> str:
    return shift_name(cases(name)[case], case[0])


def words(whole: int, result: int, bits: int, rounding: str) -> Words:
    """Return words whose rounding fits: ties and their neighbours, both ends, zero, and any others."""
    half, top = 1 << (bits - 1), 1 << min(whole - 1, result - 1 + bits)
    # The sum with half a last bit has to fit its word: that is proved of every sum.
    low, high = -top, top - 1 - (half if rounding != "floor" else 0)
    random = np.random.default_rng(bits)
    near = [0, 1, half, 1 << bits, 3 * half, 5 * half, 1 << (whole - 2)]
    chosen = [sign * each + off for each in near for sign in (1, -1) for off in (-1, 0, 1)]
    chosen += [low, low + 1, low + half, high, high - 1, high - half]
    chosen += [(int(k) << bits) + half for k in random.integers(low >> bits, (high >> bits) + 1, 50)]
    chosen += [int(k) for k in random.integers(low, high, 200, endpoint=True)]
    return np.array([each for each in chosen if low <= each <= high], np.int64)


def exact(given: Words, bits: int, rounding: str) -> list[int]:
    """Return x / 2^bits, rounded by definition."""
    values = [Fraction(int(x), 1 << bits) for x in given]
    if rounding == "up":
        return [(value + Fraction(1, 2)).__floor__() for value in values]
    return [round(value) if rounding == "even" else value.__floor__() for value in values]


@EACH_NUMBER
def test_ties_are_among_the_words_at_both_signs(name: str) -> None:
    for whole, result, bits, rounding in cases(name):
        given = [int(x) for x in words(whole, result, bits, rounding)]
        ties = [x for x in given if (x >> (bits - 1)) % 2 and not x % (1 << (bits - 1))]
        assert min(ties) < 0
        assert max(ties) > 0 or bits + 1 >= whole - 1


@EACH_NUMBER
def test_the_model_rounds_as_exact_integers_do(name: str) -> None:
    for case in cases(name):
        given = words(*case)
        assert bittrue_fixed.rounded(given, *case[2:]).tolist() == exact(given, *case[2:])


@EACH_NUMBER
@EACH_COMPILER
@pytest.mark.parametrize("level", ["-O0", "-O2"])
@pytest.mark.parametrize("shifts", ["arithmetically", "otherwise"])
def test_the_c_rounds_as_exact_integers_do(compiler: Compiler, level: str, name: str, shifts: str) -> None:
    """On a machine that shifts a negative word arithmetically, and by what is written for every other."""
    text = texts(name)
    if shifts == "otherwise":
        text = text.replace("-1) >> 1) == -1) ?", "-1) >> 1) == 0) ?")
        assert text != texts(name)
    head = "void run_{}(int32_t rows, const int64_t *x, int64_t *out)"
    loops = "".join(
        f"{head.format(called(case, name))};\n{head.format(called(case, name))}\n{{\n    int32_t k;\n"
        f"    for (k = 0; k < rows; k++) {{ out[k] = {called(case, name)}((int{case[0]}_t)x[k]); }}\n}}\n"
        for case in cases(name)
    )
    declared = "".join(f"{head.format(called(case, name))};" for case in cases(name))
    library = Library(build_shared(compiler, {"roundings.c": text + loops}, level), declared)
    for case in cases(name):
        given = words(*case)
        out = np.zeros(len(given), np.int64)
        library.run(f"run_{called(case, name)}", len(given), given, out)
        assert out.tolist() == exact(given, *case[2:]), case


MAIN = """\
#include <stdio.h>
int main(int argc, char **argv)
{
    int64_t x, y;
    int k;
    FILE *in = fopen(argv[1], "rb");
    FILE *out = fopen(argv[2], "wb");
    if (argc != 3 || in == NULL || out == NULL) { return 9; }
CALLS    return fclose(in) + fclose(out);
}
"""


@EACH_NUMBER
@EACH_COMPILER
def test_no_rounding_has_undefined_behaviour(compiler: Compiler, name: str) -> None:
    rows = {case: words(*case) for case in cases(name)}
    calls = "".join(
        f"    for (k = 0; k < {len(given)}; k++) {{\n        if (fread(&x, sizeof x, 1, in) != 1) {{ return 9; }}\n"
        f"        y = {called(case, name)}((int{case[0]}_t)x);\n"
        "        if (fwrite(&y, sizeof y, 1, out) != 1) { return 9; }\n    }\n"
        for case, given in rows.items()
    )
    data = np.concatenate(list(rows.values())).tobytes()
    main = texts(name) + MAIN.replace("CALLS", calls)
    report = run_sanitized(compiler, {"empty.c": "typedef int empty;\n"}, "-O1", main, data)
    assert report.first == ""
    if report.available:
        expected = [each for case, given in rows.items() for each in exact(given, *case[2:])]
        assert np.frombuffer(report.output, np.int64).tolist() == expected
