"""The same operation on the same values is done once, and nothing that only looks the same."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from real_routines import F, operations, written

from qcone.ir.blocks import cross, sqrt
from qcone.ir.check import check
from qcone.ir.evaluate import agree
from qcone.ir.indexed import history, loop, table
from qcone.ir.labels import named
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, walk
from qcone.ir.subroutine import subroutine
from qcone.passes.share import share


@pytest.mark.parametrize(
    ("author", "left"),
    [
        (lambda v, x, s: x * s + x * s, {"multiply": 1, "add": 1}),
        (lambda v, x, s: x * s + s * x, {"multiply": 1, "add": 1}),
        (lambda v, x, s: (x + s) * (s + x), {"multiply": 1, "add": 1}),
        (lambda v, x, s: (x - s) * (s - x), {"multiply": 1, "subtract": 2}),
        (lambda v, x, s: (x / s) * (s / x), {"multiply": 1, "divide": 2}),
        (lambda v, x, s: (x / s) + (x / s), {"add": 1, "divide": 1}),
        (lambda v, x, s: -x + -x, {"negate": 1, "add": 1}),
        (lambda v, x, s: F(1, 3) * x + F(1, 3) * x, {"multiply": 1, "add": 1}),
        (lambda v, x, s: F(1, 3) * x + F(1, 5) * x, {"multiply": 2, "add": 1}),
        (lambda v, x, s: cross(v, v), {"multiply": 3, "subtract": 3}),
        (lambda v, x, s: (x + s + x) + (x + s + x), {"add": 3}),
        (lambda v, x, s: (x + x) + s + (x + (x + s)), {"add": 5}),
        (lambda v, x, s: sqrt(x) + sqrt(x), {"square_root": 1, "add": 1}),
    ],
)
def test_shared(author: Callable[[Any, Any, Any], Any], left: dict[str, int]) -> None:
    routine = written(author)
    shared = check(share(routine), RealOp)
    assert operations(shared) == left
    assert agree(routine, shared)


def test_the_order_of_a_sum_stays_that_of_its_first_place() -> None:
    routine = share(written(lambda v, x, s: (s + x) * (x + s)))
    (total,) = (each for each in routine.body if isinstance(each, Operation) and each.op is RealOp.ADD)
    assert [routine.names[arg] for arg in total.args] == ["s", "x"]


def test_the_name_moves_to_what_is_kept() -> None:
    shared = share(written(lambda v, x, s: (x + s) * named("total", x + s)))
    assert "total" in [shared.names.get(each.result) for each in shared.body if isinstance(each, Operation)]


def test_a_first_name_is_kept() -> None:
    shared = share(written(lambda v, x, s: named("one", x + s) * named("two", x + s)))
    names = [shared.names.get(each.result) for each in shared.body if isinstance(each, Operation)]
    assert "one" in names
    assert "two" not in names


def reads_of(routine: Any, block: str) -> int:
    statements = (each for each in walk(routine.body) if isinstance(each, Operation) and each.place)
    return sum(each.place.block == block for each in statements)


def test_what_changes_between_two_reads_is_read_twice() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        r = history("r", x, 2)
        r[0] = x
        first = F(1, 3) * r[0]
        r[0] = s
        return first + F(1, 3) * r[0]

    routine = written(author, rolled=True)
    shared = check(share(routine), RealOp)
    assert reads_of(shared, "r") == 2
    assert agree(routine, shared)
    assert agree(shared, written(author))


def loops(v: Any, x: Any, s: Any) -> Any:
    weight = table("weight", x, [F(1, 3), F(1, 5), F(1, 7), F(1, 9)])
    r, t = history("r", x, 4), history("t", x, 4)
    r[0] = t[0] = x * s
    for n in loop("n", x, 1, 3):
        r[n] = weight[n] * (x * s) + weight[n] * r[n - 1]
    for n in loop("n", x, 1, 3):
        t[n] = weight[n] * (x + s) + weight[n - 1] * (r[n - 1] + (x + s)) + t[n - 1]
    return r[3] + t[3] * (x + s)


def test_loops() -> None:
    """Outside values serve inside; what one loop calculates serves neither the next nor what follows."""
    routine = written(loops, rolled=True)
    shared = check(share(routine), RealOp)
    assert operations(routine) == {"multiply": 7, "add": 8}
    assert operations(shared) == {"multiply": 6, "add": 7}
    assert reads_of(shared, "weight") == reads_of(routine, "weight") - 1
    assert agree(routine, shared)
    assert agree(shared, written(loops))


def test_subroutines() -> None:
    @subroutine
    def square(a, b):  # type: ignore[no-untyped-def]
        return (a + b) * (b + a)

    shared = share(written(lambda v, x, s: square(x, s) + square(x, s)))
    assert operations(shared.callees["square"]) == {"add": 1, "multiply": 1}
