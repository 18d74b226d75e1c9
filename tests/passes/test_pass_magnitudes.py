"""Bounds of values and of vectors: never below what an adversary finds, and above it by no more than is said here."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from searching import largest, length

from qcone import state_routines as around
from qcone.algorithms.attitude import dcm, normalised, orthonormalised
from qcone.ir.blocks import Quantity, cross, dot
from qcone.ir.builder import Builder
from qcone.ir.check import check
from qcone.ir.operations import RealOp
from qcone.ir.records import recorded_products, recorded_square, recorded_sum
from qcone.ir.statement import Block, Role, Routine, Shape
from qcone.ir.update import Rotation, increment, quaternion
from qcone.ir.writing import Writing
from qcone.passes.fuse import fuse
from qcone.passes.intervals import outward, root_above
from qcone.passes.magnitudes import Declared, Magnitudes

F = Fraction
Q = Block("q", Shape.QUATERNION, Role.STATE)
A, B = (Block(name, Shape.VECTOR, Role.INPUT) for name in "ab")
U = Block("u", Shape.SCALAR, Role.INPUT)
C = Block("c", Shape.MATRIX, Role.STATE)


def declared(low: Fraction, high: Fraction) -> Declared:
    return Declared((-high, high), (low, high))


DECLARED = {
    "q": declared(F(9, 10), F(11, 10)),
    "a": declared(F(0), F(3, 20)),
    "b": declared(F(0), F(9, 35)),
    "u": Declared((F(-3, 100), F(3, 250))),
}
"""What is declared. The author is given a, b and u times 5/3: up to 1/4, up to 3/7, from -1/20 to 1/50."""
Author = Callable[..., Quantity]


def made(author: Author, writing: Writing = Writing()) -> tuple[Routine, Quantity]:  # noqa: B008
    builder = Builder("bounded", (Q, A, B, U), writing)
    q, *others = (around.read(builder, block, 0) for block in (Q, A, B, U))
    # As in every algorithm, vectors are calculated before they are put together: bounds are taken in that order.
    result = author(q, *(F(5, 3) * each for each in others))
    size = Shape(len(result.values))
    out = Block("out", size, Role.OUTPUT)
    blocks = (Q, A, B, U, out)
    builder.blocks = blocks
    around.write(builder, out, 0, result)
    return check(fuse(check(builder.routine(), RealOp)), RealOp), result


def updated(accumulate: str, renormalise: bool) -> Author:
    def author(q: Any, a: Any, b: Any, u: Any) -> Any:
        return (q * Rotation(u, a)).finish()

    author.writing = Writing(accumulate=accumulate, renormalise=renormalise)  # type: ignore[attr-defined]
    return author


NORMS: dict[str, tuple[Author, float]] = {
    "sum": (lambda q, a, b, u: a + b, 1.0),
    "difference": (lambda q, a, b, u: a - b, 1.0),
    "scale": (lambda q, a, b, u: F(-5, 7) * a, 1.0),
    "cross": (lambda q, a, b, u: cross(a, b), 1.0),
    "cross, of a sum": (lambda q, a, b, u: cross(a, b + a), 1.6),
    "scalar times vector": (lambda q, a, b, u: u * a, 1.0),
    "quaternion times vector": (lambda q, a, b, u: q * a, 1.0),
    "quaternion of its parts": (lambda q, a, b, u: quaternion(u, a), 1.0),
    "product of quaternions": (lambda q, a, b, u: q * quaternion(u, a), 1.0),
    "update, standard": (updated("standard", renormalise=True), 1.01),
    "update, delta": (updated("delta", renormalise=True), 1.01),
    "update, never renormalised": (updated("delta", renormalise=False), 1.0),
    "increment": (lambda q, a, b, u: increment(q, q * a).finish(), 1.25),
    "normalised once": (lambda q, a, b, u: normalised(q), 1.0),
    "record of products": (
        lambda q, a, b, u: on_record(F(1, 3) * (cross(a, b) + cross(b, a + a)), [(a, b), (b, a + a)], F(1, 3)),
        3.0,
    ),
}
"""A vector or quaternion, and how far above the largest its bound may be, as a factor."""


def on_record(result: Any, pairs: Any, factor: Fraction) -> Any:
    recorded_products(result, pairs, factor)
    return result


@pytest.mark.parametrize("rule", NORMS)
def test_the_length_of_a_vector_is_bounded_closely(rule: str) -> None:
    author, slack = NORMS[rule]
    routine, result = made(author, getattr(author, "writing", Writing()))
    magnitudes = Magnitudes(routine, DECLARED)
    groups = [number for number, group in enumerate(routine.groups) if group.values == result.values]
    norm = magnitudes.norm(groups[-1])
    assert norm is not None
    found = largest(routine, DECLARED, length, result.values)
    assert found <= float(norm[1])
    assert float(norm[1]) <= found * slack * 1.002
    shortest = -largest(routine, DECLARED, lambda parts: -length(parts), result.values)
    assert float(norm[0]) <= shortest


@pytest.mark.parametrize("rule", NORMS)
def test_no_component_is_beyond_its_bound(rule: str) -> None:
    author, slack = NORMS[rule]
    routine, result = made(author, getattr(author, "writing", Writing()))
    magnitudes = Magnitudes(routine, DECLARED)
    for value in result.values:
        found = largest(routine, DECLARED, lambda parts: np.abs(parts[0]), [value])
        assert found <= float(magnitudes.of(value))
        assert float(magnitudes.of(value)) <= found * max(slack, 1.0) * 1.5


def product_of(a: Any, i: int, b: Any, j: int) -> Any:
    return tuple(a)[i] * tuple(b)[j]


SCALARS: dict[str, tuple[Author, float]] = {
    "dot": (lambda q, a, b, u: dot(a, b), 1.0),
    "square": (lambda q, a, b, u: dot(a, a), 1.0),
    "square on record": (lambda q, a, b, u: squared(q), 1.0),
    "difference from a constant": (lambda q, a, b, u: F(1, 2) * (1 - dot(a, a)), 1.0),
    "product of two": (lambda q, a, b, u: u * dot(a, b), 1.0),
    "square of a number": (lambda q, a, b, u: u * u, 1.0),
    "two components of one vector": (lambda q, a, b, u: product_of(a, 0, a, 1), 1.0),
    "components of two vectors": (lambda q, a, b, u: product_of(a, 0, b, 1), 1.0),
    "polynomial": (lambda q, a, b, u: u * (F(1, 3) + u * (F(1, 7) + u)), 1.1),
}


def squared(q: Any) -> Any:
    w, x, y, z = q
    square = w * w + x * x + y * y + z * z
    recorded_square(square, q)
    return square


@pytest.mark.parametrize("rule", SCALARS)
def test_an_interval_holds_a_number_closely(rule: str) -> None:
    author, slack = SCALARS[rule]
    routine, result = made(author)
    low, high = map(float, Magnitudes(routine, DECLARED).values[result.values[0]])
    top = largest(routine, DECLARED, lambda parts: parts[0], result.values)
    bottom = -largest(routine, DECLARED, lambda parts: -parts[0], result.values)
    assert low <= bottom + 1e-15
    assert top <= high + 1e-15
    assert high - low <= (top - bottom) * slack * 1.002


def test_a_square_is_not_negative() -> None:
    routine, result = made(lambda q, a, b, u: dot(a, a))
    assert Magnitudes(routine, DECLARED).values[result.values[0]][0] == 0
    routine, result = made(lambda q, a, b, u: dot(q, q))
    low, high = Magnitudes(routine, DECLARED).values[result.values[0]]
    assert low >= F(80, 100)
    assert high <= F(122, 100)


# -- matrices ------------------------------------------------------------------------------------------------


def rotations(low: float, high: float, lanes: int) -> np.ndarray[Any, Any]:
    """Return quaternions (4, lanes), their lengths from low to high and at both ends."""
    random = np.random.default_rng(8)
    q = random.standard_normal((4, lanes))
    q[:, : lanes // 2] = np.sign(q[:, : lanes // 2]) * (random.random((4, lanes // 2)) < 0.6)
    q[0, ~q.any(axis=0)] = 1
    return q / np.linalg.norm(q, axis=0) * random.choice([low, high, *random.uniform(low, high, 3)], lanes)


def test_no_entry_of_a_matrix_is_beyond_its_bound() -> None:
    routine, result = made(lambda q, a, b, u: dcm(q))
    magnitudes = Magnitudes(routine, DECLARED)
    q = rotations(0.9, 1.1, 20_000)
    w, x, y, z = q
    entries = [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (w * x + y * z)]
    for value, entry in zip((*result.values[:3], result.values[7]), entries, strict=True):
        found = np.abs(entry).max()
        assert 1.15 < found <= magnitudes.of(value) <= 1.5 * found


def test_rows_brought_to_right_angles_do_not_grow() -> None:
    """Two rows within 1/10 of unit length, at any angle: b + e_b b - (a . b) a is never longer than b + e_b b."""
    builder = Builder("bounded", (C, Block("out", Shape.MATRIX, Role.OUTPUT)), Writing())
    result = orthonormalised(around.read(builder, C, 0))
    around.write(builder, builder.blocks[1], 0, result)
    routine = fuse(builder.routine())
    known = {"c": Declared((F(-121, 100), F(121, 100)), (F(0), F(11, 10)))}
    magnitudes = Magnitudes(routine, known)
    random = np.random.default_rng(4)
    rows = random.standard_normal((2, 3, 50_000))
    rows[1] += rows[0] * random.choice([0, 3, 100], 50_000)
    a, b = rows / np.linalg.norm(rows, axis=1, keepdims=True) * random.choice([0.9, 1.0, 1.1, 0.2], (2, 1, 50_000))
    first = a * (3 - (a * a).sum(0)) / 2
    second = b * (3 - (b * b).sum(0)) / 2 - (a * b).sum(0) * a
    for k, row in enumerate((first, second)):
        parts = result.values[3 * k : 3 * k + 3]
        (group,) = [n for n, g in enumerate(routine.groups) if g.values == parts and "renormalised" in g.kind]
        norm = magnitudes.norm(group)
        assert norm is not None
        assert np.linalg.norm(row, axis=0).max() <= norm[1] <= 1.001
        assert all(np.abs(row).max() <= magnitudes.of(part) for part in parts)


# -- records, errors, arithmetic -----------------------------------------------------------------------------


def test_a_record_of_a_sum_is_the_sum_of_lengths() -> None:
    def author(q: Any, a: Any, b: Any, u: Any) -> Any:
        total = F(1, 2) * a + F(1, 2) * b
        recorded_sum(total, [a, b])
        return total

    routine, result = made(author)
    magnitudes = Magnitudes(routine, DECLARED)
    (group,) = [n for n, g in enumerate(routine.groups) if g.kind == "sums"]
    norm = magnitudes.norm(group)
    assert norm is not None
    assert norm[1] == pytest.approx(F(1, 2) * (F(1, 4) + F(3, 7)))  # the closer of record and sum counts
    assert result.values == routine.groups[group].values


@pytest.mark.parametrize("error", [F(1, 2**10), F(1, 2**20)])
def test_a_rounding_widens_the_bound_of_its_value_and_of_all_that_use_it(error: Fraction) -> None:
    routine, result = made(lambda q, a, b, u: F(3) * (a + b) + cross(a, a + b))
    exact = Magnitudes(routine, DECLARED)
    shared = next(group.values for group in routine.groups if group.kind == "sum")
    rounded = Magnitudes(routine, DECLARED, errors=dict.fromkeys(shared, error))
    for value in shared:
        assert rounded.of(value) - exact.of(value) == pytest.approx(error, rel=1e-3)
    for value in result.values:
        assert 3 * error <= rounded.of(value) - exact.of(value) + F(1, 2**38) <= 6 * error


@given(st.fractions(0, 10**9), st.integers(-90, 90))
def test_a_root_is_rounded_up_and_close(square: Fraction, power: int) -> None:
    value = square * F(4) ** power
    root = root_above(value)
    assert root * root >= value
    assert root * root <= value * (1 + F(1, 2**58))


@given(st.fractions(-1000, 1000), st.fractions(0, 1000))
def test_ends_are_rounded_outwards_by_little(low: Fraction, width: Fraction) -> None:
    found = outward((low, low + width))
    assert found[0] <= low
    assert found[1] >= low + width
    for end, exact in zip(found, (low, low + width), strict=True):
        assert abs(end - exact) <= abs(exact) / 2**39


def test_a_quotient_has_no_bound_where_the_divisor_may_be_zero() -> None:
    routine, _ = made(lambda q, a, b, u: dot(a, b) / u)
    with pytest.raises(ZeroDivisionError):
        Magnitudes(routine, DECLARED)
