"""Sums of products: exact over the rationals, one for every value that is needed, and none for a power of two."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from real_routines import F, written
from sums import Choice, expressions, fused, routine_of, sums, terms

from fixed_designs import INTEGRATED, SERIES
from qcone.admission import number_of
from qcone.errors import UsageError
from qcone.ir.blocks import cross, dot, number
from qcone.ir.evaluate import agree, evaluate
from qcone.ir.indexed import history, loop
from qcone.ir.operations import RealOp
from qcone.ir.statement import Choose, Operation
from qcone.ir.subroutine import subroutine
from qcone.passes.fuse import fuse, is_power_of_two
from qcone.pipeline import choose_exponential, prepare, write
from qcone.registry import algorithm_of
from shipped import WITH_PHI, design_of


@settings(max_examples=400, deadline=None)
@given(expressions)
def test_any_expression_fused_is_the_same_over_the_rationals(choices: list[Choice]) -> None:
    routine = routine_of(choices)
    assert agree(routine, fused(routine))


@given(expressions)
def test_what_is_left_is_no_more_than_sums(choices: list[Choice]) -> None:
    left = {each.op for each in fused(routine_of(choices)).body if isinstance(each, Operation)}
    assert left <= {RealOp.READ, RealOp.CONSTANT, RealOp.SUM}


@given(expressions)
def test_a_term_has_two_values_at_most_and_a_product_a_power_of_two(choices: list[Choice]) -> None:
    for each in sums(fused(routine_of(choices))):
        for term in each.terms:
            assert len(term.args) <= 2
            assert len(term.args) < 2 or is_power_of_two(term.coefficient)


@pytest.mark.parametrize("example", [*WITH_PHI, *SERIES, *INTEGRATED])
def test_every_routine_of_the_catalogue_fused_is_the_same(example: str) -> None:
    """As they are before anything is rounded: with their series, their renormalisation and what is carried."""
    design = design_of(example, number="fixed32", accumulate="compensated", outputs="quaternion,dcm,euler")
    algorithm = algorithm_of(design)
    program = prepare(write(design, algorithm, choose_exponential(design, algorithm, number_of(design))), design)
    for routine in program.routines:
        if not any(isinstance(each, Choose) for each in routine.body):
            assert agree(routine, fused(routine))


# -- one rounding a value ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("author", "expected"),
    [
        (lambda v, x, s: x * s + s - x, [[(1, ("x", "s")), (1, ("s",)), (-1, ("x",))]]),
        (lambda v, x, s: -(x * s), [[(-1, ("x", "s"))]]),
        (lambda v, x, s: F(1, 2) * (x * s) - F(1, 4) * x, [[(F(1, 2), ("x", "s")), (F(-1, 4), ("x",))]]),
        (lambda v, x, s: F(1, 3) * x + 5, [[(F(1, 3), ("x",)), (5, ())]]),
        (lambda v, x, s: F(1, 3) * (2 * x), [[(F(2, 3), ("x",))]]),
        (lambda v, x, s: (2 * x) * (4 * s), [[(8, ("x", "s"))]]),
        (lambda v, x, s: x + x, [[(2, ("x",))]]),
        (lambda v, x, s: x + x + x, [[(2, ("x",)), (1, ("x",))]]),
        (lambda v, x, s: x * s + s * x, [[(2, ("x", "s"))]]),
        (lambda v, x, s: x * s - s * x + s * s, [[(1, ("s", "s"))]]),
        (lambda v, x, s: 3 + x + F(1, 4), [[(F(13, 4), ()), (1, ("x",))]]),
        (lambda v, x, s: dot(v, v) - 1, [[(1, (f"v_{a}", f"v_{a}")) for a in "xyz"] + [(-1, ())]]),
        (lambda v, x, s: (x * s) * v, [[(1, ("x", "s"))], *[[(1, ("?", f"v_{a}"))] for a in "xyz"]]),
    ],
)
def test_one_sum_for_every_value_that_is_needed(author: Callable[[Any, Any, Any], Any], expected: Any) -> None:
    routine = written(author)
    found = fused(routine)
    assert [[(c, _names(names)) for c, names in each] for each in terms(found)] == expected
    assert agree(routine, found)


def _names(names: tuple[str, ...]) -> tuple[str, ...]:
    """Call values that have no name ?."""
    return tuple("?" if name.isdigit() else name for name in names)


def test_each_component_of_a_cross_product_is_one_sum() -> None:
    assert [len(each.terms) for each in sums(fused(written(lambda v, x, s: cross(v, x * v))))][-3:] == [2, 2, 2]


def test_a_value_that_is_used_twice_is_rounded_once_and_used_as_it_is() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        shared = x * s + x
        return shared * shared + shared

    first, second = sums(fused(written(author)))
    assert [len(term.args) for term in first.terms] == [2, 1]
    assert len({arg for term in second.terms for arg in term.args}) == 1


@dataclass(frozen=True)
class Written:
    """Three values to be written."""

    first: int
    second: int
    third: int

    @property
    def values(self) -> tuple[int, int, int]:
        return self.first, self.second, self.third


# -- constants and powers of two ---------------------------------------------------------------------------


def test_a_power_of_two_is_no_operation_at_all() -> None:
    (found,) = terms(fused(written(lambda v, x, s: (F(1, 8) * x) * s - F(1, 8) * x)))
    assert found == [(F(1, 8), ("x", "s")), (F(-1, 8), ("x",))]


def test_a_power_of_two_of_a_shared_value_is_taken_where_it_is_used() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        shared = x * s + x
        half = F(1, 2) * shared
        return half * half + half - shared

    first, second = sums(fused(written(author)))
    assert [term.coefficient for term in first.terms] == [1, 1]
    assert [term.coefficient for term in second.terms] == [F(1, 4), F(-1, 2)]


@pytest.mark.parametrize("author", [lambda v, x, s: number(F(1, 3), x), lambda v, x, s: F(2) - F(5, 3) + 0 * x])
def test_a_constant_that_is_written_stays_one(author: Callable[[Any, Any, Any], Any]) -> None:
    found = fused(written(author))
    (made,) = (each for each in found.body if isinstance(each, Operation) and each.op is not RealOp.READ)
    assert evaluate(found, {"s": [F(1)], "v": [F(1)] * 3, "x": [F(1)]}).blocks["out"][0] == F(1, 3)
    assert made.op is RealOp.CONSTANT or not made.args


def test_a_constant_that_is_both_a_term_and_a_value_stays_exact_in_both() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        third = number(F(1, 3), x)
        return Written((third + x).value, third.value, (third * x).value)

    found = fused(written(author))
    given = {"s": [F(1)], "v": [F(1)] * 3, "x": [F(5, 7)]}
    assert evaluate(found, given).blocks["out"] == [F(1, 3) + F(5, 7), F(1, 3), F(5, 21)]
    assert sum(each.op is RealOp.CONSTANT for each in found.body if isinstance(each, Operation)) == 1
    assert [term.coefficient for each in sums(found) for term in each.terms] == [F(1, 3), 1, F(1, 3)]


def test_a_sum_of_nothing_is_zero() -> None:
    routine = written(lambda v, x, s: x - x)
    assert agree(routine, fused(routine))


# -- what cannot be fused ----------------------------------------------------------------------------------


@subroutine
def twice(a: Any) -> Any:
    return a + a


def looped(v: Any, x: Any, s: Any) -> Any:
    h = history("h", x, 3)
    h[0] = x
    for i in loop("i", x, 1, 2):
        h[i] = h[i - 1] * s
    return h[2]


@pytest.mark.parametrize("author", [looped, lambda v, x, s: twice(x)], ids=["loop", "call"])
def test_a_loop_and_a_call_are_refused(author: Callable[[Any, Any, Any], Any]) -> None:
    with pytest.raises(UsageError) as raised:
        fuse(written(author, rolled=True))
    assert str(raised.value) == (
        "the routine 'written' has a loop or calls a subroutine: in fixed point every turn has formats of its own; set "
        'loop = "unrolled" and write subroutines out'
    )


@given(st.fractions())
def test_powers_of_two_are_told_apart(value: Any) -> None:
    size = abs(value)
    power = bool(size) and any(size == F(2) ** k for k in range(-200, 200))
    assert is_power_of_two(value) is power
