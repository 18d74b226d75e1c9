"""Small routines of the real language, to hold a pass against."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from qcone.ir.blocks import of
from qcone.ir.builder import Builder
from qcone.ir.check import check
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Operation, Role, Routine, Shape, walk
from qcone.ir.writing import Writing

F = Fraction
V = Block("v", Shape.VECTOR, Role.INPUT)
X = Block("x", Shape.SCALAR, Role.INPUT)
S = Block("s", Shape.SCALAR, Role.STATE)
OUT = Block("out", Shape.SCALAR, Role.OUTPUT, 3)


def written(author: Callable[[Any, Any, Any], Any], rolled: bool = False) -> Routine:
    """Return the routine that gives up to three components, of a vector v, a scalar x and a scalar state s."""
    builder = Builder("written", (S, V, X, OUT), Writing(rolled=rolled))
    v = of(builder, Shape.VECTOR, [builder.read(V, part) for part in range(3)], F(1, 2))
    x, s = (of(builder, Shape.SCALAR, [builder.read(block, 0)]) for block in (X, S))
    for part, value in enumerate(author(v, x, s).values):
        builder.write(OUT, part, value)
    return check(builder.routine(), RealOp)


def operations(routine: Routine) -> dict[str, int]:
    """Return how often each operation stands in the routine, reads and constants left out."""
    ops = (each.op for each in walk(routine.body) if isinstance(each, Operation))
    return dict(Counter(op.value for op in ops if op not in (RealOp.READ, RealOp.CONSTANT)))


def constants(routine: Routine) -> list[Fraction]:
    """Return the constants in the order they are written."""
    return [each.constant for each in walk(routine.body) if isinstance(each, Operation) and each.constant is not None]
