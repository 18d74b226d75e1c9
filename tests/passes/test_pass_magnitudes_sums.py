"""Bounds of sums: weighted samples whose differences are declared, and every partial sum in any order."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from test_pass_magnitudes import DECLARED, made

from qcone.ir.blocks import cross, dot
from qcone.ir.builder import Builder
from qcone.ir.check import check
from qcone.ir.evaluate import Numbers, evaluate
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Operation, Role, Routine, Shape, Write
from qcone.ir.update import quaternion
from qcone.ir.writing import Writing
from qcone.passes.fuse import fuse
from qcone.passes.magnitudes import Declared, Magnitudes, Samples

F = Fraction
Array = NDArray[np.float64]
COUNT = 4
GIVEN = Block("dtheta", Shape.VECTOR, Role.INPUT, COUNT)
OUT = Block("out", Shape.SCALAR, Role.OUTPUT)
AT = {("dtheta", 3 * k + axis): (axis, k) for k in range(COUNT) for axis in range(3)}
LARGEST, ZERO = F(1), F(0)


def weighted(row: list[Fraction]) -> tuple[Routine, int]:
    """Return the routine that gives sum c_k x_k, term by term, and the value."""
    builder = Builder("weighted", (GIVEN, OUT), Writing())
    total = builder.emit(RealOp.MULTIPLY, builder.constant(row[0]), builder.read(GIVEN, 0))
    for k, factor in enumerate(row[1:], 1):
        part = builder.emit(RealOp.MULTIPLY, builder.constant(factor), builder.read(GIVEN, 3 * k))
        total = builder.emit(RealOp.ADD, total, part)
    builder.write(OUT, 0, total)
    routine = fuse(check(builder.routine(), RealOp))
    return routine, next(each.value for each in routine.body if isinstance(each, Write))


def bound_of(row: list[Fraction], first: Fraction | None, second: Fraction | None, lsb: Fraction = ZERO) -> Fraction:
    routine, value = weighted(row)
    samples = Samples(LARGEST, first, second, AT, lsb)
    known = {"dtheta": Declared((-LARGEST, LARGEST), (F(0), LARGEST))}
    return Magnitudes(routine, known, samples).of(value)


def largest(row: list[Fraction], first: Fraction | None, second: Fraction | None) -> float:
    """Return the largest sum c_k x_k with |x_k| <= 1 and differences as declared: at a vertex of that polytope."""
    rows, limits = [*np.eye(COUNT)], [float(LARGEST)] * COUNT
    for declared, order in ((first, 1), (second, 2)):
        if declared is not None:
            rows += [*np.diff(np.eye(COUNT), order, axis=0)]
            limits += [float(declared)] * (COUNT - order)
    matrix = np.concatenate([rows, -np.array(rows)])
    right = np.array([*limits, *limits])
    chosen = np.array(list(combinations(range(len(right)), COUNT)))
    systems = matrix[chosen]
    regular = np.abs(np.linalg.det(systems)) > 1e-9
    points = np.linalg.solve(systems[regular], right[chosen[regular]][..., None])[..., 0]
    feasible = points[(points @ matrix.T <= right + 1e-9).all(axis=1)]
    return float((feasible @ np.array([float(c) for c in row])).max())


rows = st.lists(st.fractions(-4, 4, max_denominator=60), min_size=COUNT, max_size=COUNT).filter(any)
DIFFERENCES = [(None, None), (F(1, 10), None), (F(1, 10), F(1, 200)), (F(3), F(1)), (F(1, 50), F(1, 1000))]


@pytest.mark.parametrize(("first", "second"), DIFFERENCES)
@settings(max_examples=15, deadline=None)
@given(row=rows)
@example(row=[ZERO, ZERO, ZERO, LARGEST])
def test_no_samples_within_their_declaration_exceed_the_bound(
    first: Fraction | None, second: Fraction | None, row: list[Fraction]
) -> None:
    assert largest(row, first, second) <= float(bound_of(row, first, second)) + 1e-9


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        ([F(1), F(1), F(1), F(1)], F(4)),
        ([F(-1), F(1), F(0), F(0)], F(1, 10)),
        ([F(1), F(-2), F(1), F(0)], F(1, 200)),
        ([F(0), F(-1), F(2), F(-1)], F(1, 200)),
        ([F(-1), F(3), F(-3), F(1)], F(2, 200)),
        ([F(-9, 24), F(37, 24), F(-59, 24), F(55, 24)], 1 + F(12, 24) * F(1, 10) + F(28, 24) * F(1, 200)),
    ],
)
def test_bounds_of_well_known_rows(row: list[Fraction], expected: Fraction) -> None:
    """Sums, first to third differences, and the predictor of Adams and Bashforth."""
    found = bound_of(row, F(1, 10), F(1, 200))
    assert found == pytest.approx(expected, rel=1e-9)
    assert largest(row, F(1, 10), F(1, 200)) == pytest.approx(float(expected), rel=0.05)


def test_the_last_bits_of_samples_are_in_the_bound() -> None:
    """A difference of rounded samples may exceed the declared one by as much as they were rounded."""
    difference = [F(-1), F(1), F(0), F(0)]
    assert bound_of(difference, F(1, 10), None, F(1, 1000)) == pytest.approx(F(1, 10) + F(2, 1000), rel=1e-9)


# -- partial sums, in any order ------------------------------------------------------------------------------


def products_of_vectors(kind: str) -> tuple[Routine, list[Operation]]:

    authors: dict[str, Any] = {
        "cross": lambda q, a, b, u: cross(a, b),
        "dot": lambda q, a, b, u: dot(a, b),
        "product": lambda q, a, b, u: q * quaternion(u, a),
    }
    routine, result = made(authors[kind])
    return routine, [each for each in routine.body if isinstance(each, Operation) and each.result in result.values]


@pytest.mark.parametrize("kind", ["cross", "dot", "product"])
def test_no_part_of_a_product_exceeds_the_product_of_the_lengths(kind: str) -> None:
    routine, operations = products_of_vectors(kind)
    magnitudes = Magnitudes(routine, DECLARED)
    random = np.random.default_rng(3)
    inputs = {}
    for name, size in (("q", 4), ("a", 3), ("b", 3)):
        vectors = np.sign(random.standard_normal((size, 4000))) * random.choice([1, 1, 1e-3, 1.7], (size, 4000))
        inputs[name] = list(vectors / np.linalg.norm(vectors, axis=0) * float(DECLARED[name].norm[1]))  # type: ignore
    inputs["u"] = [random.choice([-0.03, 0.012], 4000)]
    named = Routine(routine.name, routine.blocks, routine.body, names={k: str(k) for k in range(200)})
    values = evaluate(named, inputs, Numbers(of=float)).named
    assert operations
    for operation in operations:
        subset = magnitudes.of_any_subset(operation)
        assert subset is not None
        terms = operation.detail.terms  # type: ignore[union-attr]
        parts = [float(term.coefficient) * np.prod([values[str(arg)] for arg in term.args], axis=0) for term in terms]
        reached = 0.0
        for size in range(1, len(parts) + 1):
            for chosen in combinations(parts, size):
                reached = max(reached, float(np.abs(sum(chosen)).max()))
        assert reached <= subset
        assert subset <= 1.03 * reached
