"""Routines of sums: any expression of a few inputs, brought to sums of products, and what stands in them."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from hypothesis import strategies as st

from qcone.ir.builder import Builder
from qcone.ir.check import check
from qcone.ir.detail import Sum
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Operation, Role, Routine, Shape
from qcone.ir.writing import Writing
from qcone.passes.fuse import fuse

F = Fraction
GIVEN = (
    Block("kept", Shape.SCALAR, Role.STATE, 2),
    Block("first", Shape.SCALAR, Role.INPUT, 3),
    Block("second", Shape.SCALAR, Role.INPUT, 2),
)
OUT = Block("out", Shape.SCALAR, Role.OUTPUT, 3)
COEFFICIENTS = (F(1), F(-1), F(2), F(1, 2), F(-1, 4), F(8), F(1, 3), F(9, 20), F(27, 40), F(-5, 7), F(0))
Choice = tuple[str, int, int, Fraction]

expressions: st.SearchStrategy[list[Choice]] = st.lists(
    st.tuples(
        st.sampled_from(["add", "add", "subtract", "subtract", "multiply", "negate", "scale", "constant", "carry"]),
        st.integers(0, 30),
        st.integers(0, 30),
        st.sampled_from(COEFFICIENTS),
    ),
    min_size=1,
    max_size=14,
)
"""One operation each; operands are counted from the newest value backwards, so that values are used once and again."""


def routine_of(choices: list[Choice], writes: Any = (0, 3, 5)) -> Routine:
    """Return the routine of these operations: the newest value and two older ones are written."""
    builder = Builder("drawn", (*GIVEN, OUT), Writing())
    values = [builder.read(block, part) for block in GIVEN for part in range(block.size)]
    for kind, left, right, coefficient in choices:
        a, b = values[-1 - left % len(values)], values[-1 - right % len(values)]
        if kind in ("add", "subtract", "multiply"):
            values.append(builder.emit(RealOp(kind), a, b))
        elif kind == "scale":
            values.append(builder.emit(RealOp.MULTIPLY, builder.constant(coefficient), a))
        elif kind == "constant":
            values.append(builder.constant(coefficient))
        else:
            values.append(builder.emit(RealOp(kind), a))
    for part, back in enumerate(writes):
        builder.write(OUT, part, values[-1 - back % len(values)])
    builder.write(GIVEN[0], 1, values[-1])
    return check(builder.routine(), RealOp)


def fused(routine: Routine) -> Routine:
    """Return the routine in sums, legal."""
    return check(fuse(routine), RealOp)


def sums(routine: Routine) -> list[Sum]:
    """Return the sums in the order they are written."""
    return [each.detail for each in routine.body if isinstance(each, Operation) and isinstance(each.detail, Sum)]


def terms(routine: Routine) -> list[list[tuple[Fraction, tuple[str, ...]]]]:
    """Return each sum's terms: coefficient and the names of the values."""
    return [
        [(term.coefficient, tuple(routine.names.get(arg, str(arg)) for arg in term.args)) for term in each.terms]
        for each in sums(routine)
    ]
