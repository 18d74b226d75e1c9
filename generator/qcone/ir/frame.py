"""The update of a direction cosine matrix: two rows and their increments, the third row their cross product.

With rows a, b and e_aa = (1 - a.a)/2, e_ab = -a.b of the incoming matrix, a + e_aa a and b + e_bb b + e_ab a are of
unit length and at right angles to second order: 18 products, no root, no division. The matrix keeps a proper
rotation: c = a x b has the right sign and length as far as a and b have.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from qcone.errors import UsageError
from qcone.ir.blocks import Matrix, Scalar, Vector, cross, dot, matrix
from qcone.ir.labels import step
from qcone.ir.operations import RealOp


@dataclass(frozen=True)
class RowUpdate:
    """The matrix and the increments of its first two rows, to be returned by the author; not for further use."""

    c: Matrix
    first: Vector
    second: Vector

    def finish(self) -> Matrix:
        """Write the new rows, re-orthogonalised where the `Writing` asks for it, and the third row."""
        a, b, first, second = self.c.row(0), self.c.row(1), self.first, self.second
        turned = (first, second)
        if self.c.builder.writing.renormalise:
            e_a = step("e_a = (1 - |a|^2)/2", "re-orthogonalisation of the rows a, b", _half_defect(a))
            e_b = step("e_b = (1 - |b|^2)/2", "re-orthogonalisation of the rows a, b", _half_defect(b))
            e_ab = step("e_ab = a . b", "re-orthogonalisation of the rows a, b", dot(a, b))
            first = step("da_e = da + e_a a", "", first + e_a * a)
            second = step("db_e = db + e_b b - e_ab a", "", second + e_b * b - e_ab * a)
        top = step("a_next = a + da", "", _accumulated(a, first, turned[0]))
        middle = step("b_next = b + db", "", _accumulated(b, second, turned[1]))
        bottom = step("c_next = a_next x b_next", "", cross(top, middle))
        return matrix([*top, *middle, *bottom])


def rows(c: Matrix, first: Vector, second: Vector) -> RowUpdate:
    """Return the update of a matrix by the increments of its first two rows, to be returned by the author."""
    if not isinstance(c, Matrix) or not isinstance(first, Vector) or not isinstance(second, Vector):
        raise UsageError("rows(c, da, db) takes the matrix and the increments of its first two rows")
    return RowUpdate(c, first, second)


def _half_defect(row: Vector) -> Scalar:
    return Fraction(1, 2) * (1 - dot(row, row))


def _accumulated(row: Vector, change: Vector, turned: Vector) -> Vector:
    """Write row + change; its length is bounded by what the row is turned by: re-orthogonalising shortens it.

    With |a|^2 <= 2 (1 + e_b), as the bounds of the rows show, taking e_ab a from b + e_b b cannot lengthen it:
    |b + e_b b - c a|^2 = |b|^2 (1 + e_b)^2 - c^2 (2 (1 + e_b) - |a|^2), c = a . b.
    """
    builder = row.builder
    values = [builder.emit(RealOp.ACCUMULATE, *pair) for pair in zip(row.values, change.values, strict=True)]
    kept = Fraction(1 if builder.writing.renormalise else 0)
    builder.group("row_renormalised", values, (row.group, turned.group), kept)
    return Vector(builder, tuple(values), builder.group("sum", values, (row.group, change.group)))
