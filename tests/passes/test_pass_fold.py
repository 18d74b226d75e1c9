"""Constants are calculated before run time, over the rationals; what could change a bit stays."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from real_routines import constants, operations, written

from qcone.ir.blocks import number
from qcone.ir.check import check
from qcone.ir.evaluate import agree
from qcone.ir.indexed import history, loop
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation
from qcone.ir.subroutine import subroutine
from qcone.passes.fold import fold
from qcone.passes.sweep import sweep

F = Fraction


def half(x: Any) -> Any:
    return number(F(1, 2), x)


@pytest.mark.parametrize(
    ("author", "left", "known"),
    [
        (lambda v, x, s: x * (half(x) + F(1, 3)), {"multiply": 1}, [F(5, 6)]),
        (lambda v, x, s: x * (half(x) - F(1, 3)), {"multiply": 1}, [F(1, 6)]),
        (lambda v, x, s: x * (F(1, 3) * half(x)), {"multiply": 1}, [F(1, 6)]),
        (lambda v, x, s: x * (half(x) / 3), {"multiply": 1}, [F(1, 6)]),
        (lambda v, x, s: x * -half(x), {"multiply": 1}, [F(-1, 2)]),
        (lambda v, x, s: 1 * x, {}, []),
        (lambda v, x, s: x * number(1, x), {}, []),
        (lambda v, x, s: x * (half(x) + half(x)), {}, []),
        (lambda v, x, s: -1 * x, {"negate": 1}, []),
        (lambda v, x, s: x * number(-1, x), {"negate": 1}, []),
        (lambda v, x, s: F(1, 3) * (F(1, 5) * x), {"multiply": 2}, [F(1, 5), F(1, 3)]),
        (lambda v, x, s: 1 * (1 * x) + 0, {"add": 1}, [F(0)]),
    ],
)
def test_folded(author: Callable[[Any, Any, Any], Any], left: dict[str, int], known: list[Fraction]) -> None:
    routine = written(author)
    folded = check(sweep(fold(routine)), RealOp)
    assert operations(folded) == left
    assert sorted(constants(folded)) == sorted(known)
    assert agree(routine, folded)


@pytest.mark.parametrize(
    "author",
    [
        lambda v, x, s: x + 0,
        lambda v, x, s: x - 0,
        lambda v, x, s: 0 - x,
        lambda v, x, s: 0 * x,
        lambda v, x, s: x * number(0, x),
        lambda v, x, s: x - x,
        lambda v, x, s: x / x,
        lambda v, x, s: x / 1,
        lambda v, x, s: x / 3,
        lambda v, x, s: x + x,
    ],
)
def test_kept(author: Callable[[Any, Any, Any], Any]) -> None:
    """x + 0 is not x for x = -0; x - x and 0 x are not 0 for infinity: they stay as they are written."""
    routine = written(author)
    assert operations(fold(routine)) == operations(routine)


def test_a_division_by_zero_is_not_calculated() -> None:
    routine = written(lambda v, x, s: x * (half(x) / (half(x) - half(x))))
    assert operations(sweep(fold(routine))) == {"divide": 1, "multiply": 1}


def test_the_stand_in_takes_the_name() -> None:
    from qcone.ir.labels import named

    folded = fold(written(lambda v, x, s: named("whole", 1 * (x + s))))
    (total,) = (each.result for each in folded.body if isinstance(each, Operation) and each.op is RealOp.ADD)
    assert folded.names[total] == "whole"


def test_inside_loops_and_subroutines() -> None:
    @subroutine
    def scaled(a):  # type: ignore[no-untyped-def]
        return a * (number(2, a) * half(a)) * (half(a) * half(a))

    def author(v: Any, x: Any, s: Any) -> Any:
        r = history("r", x, 4)
        r[0] = scaled(x)
        for n in loop("n", x, 1, 3):
            r[n] = 1 * r[n - 1] * (half(x) + half(x)) + x
        return r[3]

    routine = written(author, rolled=True)
    folded = check(sweep(fold(routine)), RealOp)
    assert operations(folded) == {"add": 1}
    assert operations(folded.callees["scaled"]) == {"multiply": 1}
    assert agree(routine, folded)
