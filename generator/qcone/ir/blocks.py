"""What an author calculates with: scalars, vectors, quaternions and matrices whose operations are written down.

Each object is a handle on values of one `Builder`. Arithmetic writes exactly the operations of the
textbook, one by one: `cross` is six products and three differences, `q * r` is the Hamilton product by
its 4 x 4 matrix. Numbers are exact: `int` or `Fraction`; a `float` is refused, for 0.1 is not 1/10.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar, Self, TypeVar, overload

from qcone.errors import UsageError
from qcone.ir import products
from qcone.ir.builder import Builder
from qcone.ir.operations import RealOp
from qcone.ir.statement import Shape

Number = int | Fraction


def exact(value: object) -> Fraction:
    """Return the number as a Fraction; UsageError for a float or anything else that is not exact."""
    if not isinstance(value, int | float | complex | Fraction):
        raise UsageError(f"a scalar or an exact number is needed here, not a {type(value).__name__.lower()}")
    if isinstance(value, bool) or not isinstance(value, int | Fraction):
        raise UsageError(f"a constant must be exact: write it as a fraction, F(9, 20), instead of {value!r}")
    return Fraction(value)


@dataclass(frozen=True, eq=False)
class Quantity:
    """Values of one builder that form a thing; `group` is their record for range analysis."""

    builder: Builder
    values: tuple[int, ...]
    group: int
    shape: ClassVar[Shape]

    def _like(self, kind: str, values: Sequence[int], operands: Sequence[int], factor: Fraction | None = None) -> Self:
        group = self.builder.group(kind, values, operands, factor)
        return type(self)(self.builder, tuple(values), group)

    def _pairwise(self, kind: str, op: RealOp, other: Self) -> Self:
        emit = together(self, other).emit
        values = [emit(op, a, b) for a, b in zip(self.values, other.values, strict=True)]
        return self._like(kind, values, (self.group, other.group))

    def __add__(self, other: Self) -> Self:
        """Add component by component."""
        if type(other) is not type(self):
            return NotImplemented
        return self._pairwise("sum", RealOp.ADD, other)

    def __sub__(self, other: Self) -> Self:
        """Subtract component by component."""
        if type(other) is not type(self):
            return NotImplemented
        return self._pairwise("difference", RealOp.SUBTRACT, other)

    def __neg__(self) -> Self:
        """Negate every component."""
        values = [self.builder.emit(RealOp.NEGATE, value) for value in self.values]
        return self._like("scale", values, (self.group,), Fraction(-1))

    def _scaled(self, factor: Number | Scalar) -> Self:
        """Return factor times this: one product a component, the factor on the left."""
        if isinstance(factor, Scalar):
            emit = together(self, factor).emit
            values = [emit(RealOp.MULTIPLY, factor.values[0], value) for value in self.values]
            return self._like("product", values, (factor.group, self.group))
        scale = exact(factor)
        values = [self.builder.emit(RealOp.MULTIPLY, self.builder.constant(scale), value) for value in self.values]
        return self._like("scale", values, (self.group,), scale)

    def _divided(self, divisor: Number | Scalar) -> Self:
        if isinstance(divisor, Scalar):
            emit = together(self, divisor).emit
            values = [emit(RealOp.DIVIDE, value, divisor.values[0]) for value in self.values]
            return self._like("other", values, (self.group, divisor.group))
        scale = exact(divisor)
        if not scale:
            raise UsageError("a division by zero is written here")
        values = [self.builder.emit(RealOp.DIVIDE, value, self.builder.constant(scale)) for value in self.values]
        return self._like("scale", values, (self.group,), 1 / scale)


def together(*quantities: Quantity) -> Builder:
    """Return the builder of the quantities; UsageError for those of another routine: their values are not there."""
    builder = quantities[0].builder
    if any(each.builder is not builder for each in quantities):
        raise UsageError("a subroutine calculates with its arguments only: hand it every quantity as an argument")
    return builder


class Scalar(Quantity):
    """One real number."""

    shape = Shape.SCALAR

    @property
    def value(self) -> int:
        """Return the one value."""
        return self.values[0]

    def _lift(self, other: object) -> Scalar:
        if isinstance(other, Scalar):
            return other
        return number(exact(other), self)

    def __add__(self, other: Scalar | Number) -> Scalar:
        """Add a scalar or an exact number."""
        return self._pairwise("sum", RealOp.ADD, self._lift(other))

    def __radd__(self, other: Number) -> Scalar:
        """Add to an exact number."""
        return self._lift(other) + self

    def __sub__(self, other: Scalar | Number) -> Scalar:
        """Subtract a scalar or an exact number."""
        return self._pairwise("difference", RealOp.SUBTRACT, self._lift(other))

    def __rsub__(self, other: Number) -> Scalar:
        """Subtract from an exact number."""
        return self._lift(other) - self

    @overload
    def __mul__(self, other: Scalar | Number) -> Scalar: ...
    @overload
    def __mul__(self, other: Vector) -> Vector: ...
    @overload
    def __mul__(self, other: Quaternion) -> Quaternion: ...
    def __mul__(self, other: Any) -> Any:
        """Multiply; a scalar times a vector or quaternion scales it."""
        if isinstance(other, Vector | Quaternion):
            return other._scaled(self)
        if isinstance(other, Scalar):
            value = together(self, other).emit(RealOp.MULTIPLY, self.value, other.value)
            return self._like("product", (value,), (self.group, other.group))
        return self._scaled(other)

    def __rmul__(self, other: Number) -> Scalar:
        """Multiply by an exact number on the left."""
        return self._scaled(other)

    def __truediv__(self, other: Scalar | Number) -> Scalar:
        """Divide by a scalar or an exact number."""
        return self._divided(other)

    def __rtruediv__(self, other: Number) -> Scalar:
        """Divide an exact number."""
        return self._lift(other) / self


class Vector(Quantity):
    """Three components along the body axes x, y, z."""

    shape = Shape.VECTOR

    def __mul__(self, other: Scalar | Number) -> Vector:
        """Scale by a scalar or an exact number."""
        return self._scaled(other)

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar | Number) -> Vector:
        """Divide every component: three divisions, as written."""
        return self._divided(other)

    def __iter__(self) -> Iterator[Scalar]:
        """Yield the components x, y, z."""
        return _components(self)


class Quaternion(Quantity):
    """Four components w, x, y, z; scalar first, Hamilton product."""

    shape = Shape.QUATERNION

    def __mul__(self, other: Any) -> Any:
        """Multiply: by a quaternion, a pure quaternion (Vector) or a number; by a `Rotation`, see there.

        The product with a quaternion is written as the matrix of cao (2) times a column: 16 products, 12
        additions, its signs as negations. With a vector, the products with the known zero are left out.
        """
        if isinstance(other, Quaternion):
            return self.times(other)
        if isinstance(other, Vector):
            values = products.hamilton_pure(together(self, other).emit, self.values, other.values)
            return self._like("product", values, (self.group, other.group))
        if isinstance(other, int | float | Fraction | Scalar):
            return self._scaled(other if isinstance(other, Scalar) else exact(other))
        return NotImplemented

    def __rmul__(self, other: Number) -> Quaternion:
        """Scale by an exact number."""
        return self._scaled(other)

    def times(self, other: Quaternion) -> Quaternion:
        """Return the Hamilton product as cao (2) writes it."""
        values = products.hamilton(together(self, other).emit, self.values, other.values)
        return self._like("product", values, (self.group, other.group))

    @property
    def scalar(self) -> Scalar:
        """Return the scalar part w."""
        return next(_components(self))

    @property
    def vector(self) -> Vector:
        """Return the vector part (x, y, z)."""
        values = self.values[1:]
        return Vector(self.builder, values, self.builder.group("part", values, (self.group,)))

    def __iter__(self) -> Iterator[Scalar]:
        """Yield the components w, x, y, z."""
        return _components(self)


class Matrix(Quantity):
    """Nine components, row major."""

    shape = Shape.MATRIX

    def __iter__(self) -> Iterator[Scalar]:
        """Yield the components, row by row."""
        return _components(self)

    def row(self, index: int) -> Vector:
        """Return one of the three rows."""
        values = self.values[3 * index : 3 * index + 3]
        return Vector(self.builder, values, self.builder.group("row", values, (self.group,), Fraction(index)))


def number(value: Number, like: Quantity) -> Scalar:
    """Return an exact constant as a scalar, written beside `like`."""
    written = like.builder.constant(exact(value))
    known = Fraction(value)
    return Scalar(like.builder, (written,), like.builder.group("constant", (written,), (), known, abs(known)))


def vector(x: Scalar, y: Scalar, z: Scalar) -> Vector:
    """Return the vector of three scalars; nothing is calculated."""
    values = (x.value, y.value, z.value)
    return Vector(x.builder, values, x.builder.group("together", values, (x.group, y.group, z.group)))


def matrix(entries: Sequence[Scalar]) -> Matrix:
    """Return the matrix of nine scalars, row by row; nothing is calculated."""
    values = tuple(entry.value for entry in entries)
    builder = together(*entries)
    return Matrix(builder, values, builder.group("together", values, [entry.group for entry in entries]))


Q = TypeVar("Q", Scalar, Vector, Quaternion, Matrix)
BY_SHAPE: dict[Shape, type[Quantity]] = {
    Shape.SCALAR: Scalar,
    Shape.VECTOR: Vector,
    Shape.QUATERNION: Quaternion,
    Shape.MATRIX: Matrix,
}


def of(builder: Builder, shape: Shape, values: Sequence[int], norm: Fraction | None = None) -> Any:
    """Return a quantity of that shape over values that are already written."""
    return BY_SHAPE[shape](builder, tuple(values), builder.group("input", values, norm=norm))


def _components(quantity: Quantity) -> Iterator[Scalar]:
    builder = quantity.builder
    for value in quantity.values:
        yield Scalar(builder, (value,), builder.group("part", (value,), (quantity.group,)))


def cross(a: Vector, b: Vector) -> Vector:
    """Return a x b: six products, three differences."""
    return a._like("cross", products.cross(together(a, b).emit, a.values, b.values), (a.group, b.group))


def dot(a: Vector, b: Vector) -> Scalar:
    """Return a . b: three products, two additions, x first."""
    value = products.dot(together(a, b).emit, a.values, b.values)
    return Scalar(a.builder, (value,), a.builder.group("dot", (value,), (a.group, b.group)))


def sqrt(a: Scalar) -> Scalar:
    """Return the square root. Only the as-written form may hold one; a factored update does without."""
    value = a.builder.emit(RealOp.SQUARE_ROOT, a.value)
    return Scalar(a.builder, (value,), a.builder.group("root", (value,), (a.group,)))
