"""Bounds of what an update sees: over the rationals, never below what can occur."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from real_routines import F, written

from qcone.assembly import rotation_bound
from qcone.design import design_from_options
from qcone.ir.blocks import Vector, cross, dot, matrix, number, sqrt
from qcone.ir.evaluate import evaluate
from qcone.ir.indexed import table
from qcone.ir.statement import Routine
from qcone.ir.update import exp, quaternion
from qcone.passes.ranges import norms, rotation_vector_bound
from qcone.registry import algorithm_of, entries

HALF = F(1, 2)
"""The norm declared for v in `real_routines`; x and s have none."""


def last(author: Callable[[Any, Any, Any], Any]) -> Fraction | None:
    """Return the bound of what the author's function returns."""
    kept: list[int] = []

    def keep(v: Any, x: Any, s: Any) -> Any:
        result = author(v, x, s)
        kept.append(result.group)
        return result if len(result.values) <= 3 else result.vector

    return norms(written(keep))[kept[0]]


@pytest.mark.parametrize(
    ("author", "expected"),
    [
        (lambda v, x, s: v, HALF),
        (lambda v, x, s: v + v, 2 * HALF),
        (lambda v, x, s: v - F(1, 3) * v, HALF + HALF / 3),
        (lambda v, x, s: -v, HALF),
        (lambda v, x, s: F(-9, 20) * v, HALF * F(9, 20)),
        (lambda v, x, s: v / 3, HALF / 3),
        (lambda v, x, s: v / F(-1, 3), 3 * HALF),
        (lambda v, x, s: cross(v, v + v), HALF * 2 * HALF),
        (lambda v, x, s: dot(v, F(1, 3) * v), HALF * HALF / 3),
        (lambda v, x, s: dot(v, v) * v, HALF**3),
        (lambda v, x, s: number(F(-2, 3), x), F(2, 3)),
        (lambda v, x, s: 1 - dot(v, v), 1 + HALF**2),
        (lambda v, x, s: list(v)[1], HALF),
        (lambda v, x, s: table("t", x, [F(1, 3), F(-5, 7)])[0] * v, HALF * F(5, 7)),
        (lambda v, x, s: x, None),
        (lambda v, x, s: x * v, None),
        (lambda v, x, s: v + x * v, None),
        (lambda v, x, s: v / dot(v, v), None),
        (lambda v, x, s: sqrt(dot(v, v)), None),
        (lambda v, x, s: quaternion(dot(v, v), v), None),
    ],
)
def test_norms(author: Callable[[Any, Any, Any], Any], expected: Fraction | None) -> None:
    assert last(author) == expected


def test_a_matrix_has_none() -> None:
    made: list[int] = []

    def author(v: Any, x: Any, s: Any) -> Any:
        made.append(matrix([dot(v, v)] * 9).group)
        return v

    assert norms(written(author))[made[0]] is None


COMPONENTS = st.fractions(-1, 1, max_denominator=12)


@given(st.tuples(COMPONENTS, COMPONENTS, COMPONENTS))
def test_nothing_exceeds_its_bound(direction: tuple[Fraction, Fraction, Fraction]) -> None:
    """|phi|^2 of a coning-like sum, at any v of the declared norm or less, exactly."""

    def author(v: Any, x: Any, s: Any) -> Any:
        w = F(2, 3) * v + F(9, 20) * cross(v, Vector(v.builder, v.values[1:] + v.values[:1], v.group))
        return w - dot(v, w) * v

    routine = written(author)
    limit = last(author)
    assert limit is not None
    square = sum(part * part for part in direction)
    scale = HALF / 2 if square <= 4 else HALF
    v = [part * scale for part in direction] if square <= 3 else [F(0)] * 3
    assert sum(part * part for part in v) <= HALF**2
    out = evaluate(routine, {"v": v, "x": [F(1)], "s": [F(1)]}).blocks["out"]
    assert sum(part * part for part in out) <= limit**2


def exponential(author: Callable[[Any, Any, Any], Any]) -> Routine:
    return written(lambda v, x, s: exp(author(v, x, s)).v)  # type: ignore[union-attr]


def test_the_argument_of_exp() -> None:
    assert rotation_vector_bound(exponential(lambda v, x, s: v + F(1, 3) * cross(v, v))) == HALF + HALF**2 / 3


def test_the_largest_of_several() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        exp(3 * v)
        exp(F(1, 3) * v)
        return v

    assert rotation_vector_bound(exponential(author)) == 3 * HALF


def test_no_exp_no_bound() -> None:
    assert rotation_vector_bound(written(lambda v, x, s: v)) is None


def test_an_argument_without_bound() -> None:
    with pytest.raises(ValueError, match=r"^written: no bound is known for the argument of exp$"):
        rotation_vector_bound(exponential(lambda v, x, s: x * v))


@pytest.mark.parametrize(
    ("options", "phi"),
    [
        ({"subsamples": "1"}, lambda theta: theta),
        ({"subsamples": "3", "coefficients": "coning"}, lambda theta: 3 * theta + (9 / 20 + 27 / 20) * theta**2),
        ({"subsamples": "1", "previous": "1"}, lambda theta: theta + theta**2 / 12),
    ],
)
def test_the_catalogue(options: dict[str, str], phi: Callable[[float], float]) -> None:
    """573 deg/s at 100 updates/s: increments at their largest, crossed at right angles; rounded up to four digits."""
    base = {"algorithm": "rotation-vector", "number": "float32", "update_hz": "100", "max_rate_dps": "573"}
    design = design_from_options("ranged", {**base, **options}, entries())
    found = rotation_bound(algorithm_of(design), design)
    largest = phi(math.radians(573) / 100 / int(options["subsamples"]))
    assert found is not None
    assert largest <= found <= largest * 1.001
    assert (found * 10**4).denominator == 1
