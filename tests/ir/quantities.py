"""A builder and the quantities of its blocks, to write operations with."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import Any

from qcone.ir.blocks import Quaternion, Scalar, Vector, of
from qcone.ir.builder import Builder
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Operation, Role, Shape, walk
from qcone.ir.writing import Writing

F = Fraction
BLOCKS = (
    Block("q", Shape.QUATERNION, Role.STATE),
    Block("p", Shape.QUATERNION, Role.INPUT),
    Block("a", Shape.VECTOR, Role.INPUT, count=2),
    Block("x", Shape.SCALAR, Role.INPUT),
)


class Page:
    """A builder and the quantities of its blocks."""

    def __init__(self, writing: Writing | None = None) -> None:
        self.builder = Builder("page", BLOCKS, writing or Writing())
        self.q: Quaternion = self.take(0)
        self.p: Quaternion = self.take(1)
        self.a: Vector = self.take(2)
        self.b: Vector = self.take(2, 1)
        self.x: Scalar = self.take(3)

    def take(self, block: int, entry: int = 0) -> Any:
        chosen = BLOCKS[block]
        size = chosen.shape.value
        values = [self.builder.read(chosen, size * entry + part) for part in range(size)]
        return of(self.builder, chosen.shape, values)

    def counts(self) -> dict[str, int]:
        """Return how often each operation was written, reads and constants left out."""
        ops = (each.op for each in walk(self.builder.routine().body) if isinstance(each, Operation))
        return dict(Counter(op.value for op in ops if op not in (RealOp.READ, RealOp.CONSTANT)))
