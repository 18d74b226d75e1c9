"""The attitude update in the papers' shorthand: exp(phi) is a rotation, q * rotation is the new attitude.

What that means in operations is decided by the `Writing` of the routine:

as written   |phi| by a square root, a unit axis by three divisions, sin and cos, q (x) r by the signed
             matrix (cao (2), (14); xu2019 table 1 counts this form)
factored     u = cos(|phi|/2) - 1 and s = sin(|phi|/2)/|phi| by polynomials in |phi|^2, v = s phi, and
             q' = q + q (x) [u + e, v] or q' = q (x) [1 + u + e, v], e = (1 - |q|^2)/2 folding a
             renormalisation into the scalar part: five products, no root, no division
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from qcone.errors import UsageError
from qcone.ir import products
from qcone.ir.blocks import Q, Quaternion, Scalar, Vector, dot, number, sqrt, together
from qcone.ir.labels import step
from qcone.ir.operations import RealOp
from qcone.ir.statement import Step


@dataclass(frozen=True)
class Update:
    """The product of the attitude and a rotation, to be returned by the author; not for further use."""

    q: Quaternion
    rotation: Rotation

    def finish(self) -> Quaternion:
        """Write the product out, as the routine's `Writing` says, and return the new attitude."""
        self.q.builder.settle()
        writing = self.q.builder.writing
        u, v, name = self.rotation.u, carried(self.rotation.v, "v"), "u"
        small = u
        if writing.renormalise:
            small, name = _with_renormalisation(self.q, small), "a"
        inner = [small.group] if small is not None else []
        length = (self.q.group, (u or number(0, v)).group, v.group)
        if writing.accumulate == "standard":
            scalar = number(1, v) if small is None else 1 + small
            r = step(f"r = [{'1' if small is None else '1 + ' + name}, v]", "", quaternion(scalar, v))
            q_next = _least_product(self.q, r)
            return step("q_next = q (x) r", "cao (14)", _rotated(q_next, (*length, r.group, *inner)))
        if small is None:
            change = step("dq = q (x) [0, v]", "cao (14)", self.q * v)
        else:
            change = step(f"dq = q (x) [{name}, v]", "cao (14)", _least_product(self.q, quaternion(small, v)))
        return accumulated(self.q, change, (*length, change.group, *inner))


def carried(v: Vector, name: str) -> Vector:
    """Write that the rounding of the vector `name` is carried to the next update, where the `Writing` asks for it."""
    builder = v.builder
    if not builder.writing.carry:
        return v
    values = [builder.emit(RealOp.CARRY, value) for value in v.values]
    builder.label(Step(f"{name}, the rounding of the last update added, that of this one kept"))
    return Vector(builder, tuple(values), builder.group("scale", values, (v.group,), Fraction(1)))


def _rotated(q_next: Quaternion, operands: Sequence[int]) -> Quaternion:
    """Return the new attitude on record as q turned by [1 + u, v], renormalised or not: so its length is bounded."""
    builder = q_next.builder
    kept = Fraction(1 if builder.writing.renormalise else 0)
    return Quaternion(builder, q_next.values, builder.group("rotated", q_next.values, operands, kept))


def accumulated(q: Quaternion, change: Quaternion, rotated: Sequence[int] = ()) -> Quaternion:
    """Write q + dq by the operation whose rounding the number format carries.

    `rotated` are the groups that bound its length where it is a rotation's; else |q| + |dq| does.
    """
    builder = q.builder
    values = [builder.emit(RealOp.ACCUMULATE, *pair) for pair in zip(q.values, change.values, strict=True)]
    group = builder.group("sum", values, (q.group, change.group))
    q_next = Quaternion(builder, tuple(values), group)
    return step("q_next = q + dq", "", _rotated(q_next, rotated) if rotated else q_next)


@dataclass(frozen=True)
class Increment:
    """The attitude and what is to be added to it, to be returned by the author; not for further use."""

    q: Quaternion
    change: Quaternion

    def finish(self) -> Quaternion:
        """Write q + dq, with the renormalisation e q added to the increment where the `Writing` asks for it."""
        change, builder = self.change, self.q.builder
        if builder.writing.renormalise:
            e = _with_renormalisation(self.q, None)
            change = step("dq_e = dq + e q", "", change + e * self.q)
        if builder.writing.as_written:
            return step("q_next = q + dq", "", self.q + change)
        kept = Fraction(1 if builder.writing.renormalise else 0)
        q_next = accumulated(self.q, change)
        builder.group("renormalised", q_next.values, (self.q.group, self.change.group), kept)
        return q_next


def increment(q: Quaternion, change: Quaternion) -> Increment:
    """Return the update q + dq, to be returned by the author."""
    if not isinstance(q, Quaternion) or not isinstance(change, Quaternion):
        raise UsageError("increment(q, dq) takes the attitude quaternion and a quaternion to be added to it")
    return Increment(q, change)


@dataclass(frozen=True)
class Rotation:
    """A unit quaternion r = [1 + u, v], its scalar part held as the small u so that no digit of it is lost.

    `u` is None where it is exactly zero.
    """

    u: Scalar | None
    v: Vector

    def __rmul__(self, q: Quaternion) -> Update:
        """Return the update q (x) r, to be returned by the author."""
        if not isinstance(q, Quaternion):
            raise UsageError(
                f"a rotation is multiplied from the left by the attitude q, not by a {type(q).__name__.lower()}"
            )
        return Update(q, self)


def _with_renormalisation(q: Quaternion, u: Scalar | None) -> Scalar:
    """Write e = (1 - |q|^2)/2 and return the scalar part u + e."""
    value = products.dot(q.builder.emit, q.values, q.values)
    square = Scalar(q.builder, (value,), q.builder.group("dot", (value,), (q.group, q.group)))
    square = step("q_square = |q|^2", "", square)
    e = step("e = (1 - |q|^2)/2", "renormalisation, folded into the scalar part", Fraction(1, 2) * (1 - square))
    return e if u is None else step("a = u + e", "", u + e)


def shortened(before: Quaternion | Vector, after: Q, crossed: bool = False) -> Q:
    """Return `after` on record as `before` brought towards unit length by one Newton step: so its length is bounded.

    `crossed` says that its part along another such vector was taken away.
    """
    kind = "row_renormalised" if crossed else "renormalised"
    after.builder.group(kind, after.values, (before.group,), Fraction(1))
    return after


def _least_product(p: Quaternion, q: Quaternion) -> Quaternion:
    values = products.hamilton_least(together(p, q).emit, p.values, q.values)
    return Quaternion(p.builder, values, p.builder.group("product", values, (p.group, q.group)))


def quaternion(scalar: Scalar, vector: Vector) -> Quaternion:
    """Return the quaternion [scalar, vector]; nothing is calculated."""
    values, builder = (*scalar.values, *vector.values), together(scalar, vector)
    return Quaternion(builder, values, builder.group("together", values, (scalar.group, vector.group)))


def rotation(u: Scalar | Literal[0], v: Vector) -> Rotation | Quaternion:
    """Return the rotation r = [1 + u, v] from its small scalar part, 0 if there is none, and its vector part."""
    if u == 0 and isinstance(v, Vector):
        return quaternion(number(1, v), v) if v.builder.writing.as_written else Rotation(None, v)
    if not isinstance(u, Scalar) or not isinstance(v, Vector):
        raise UsageError("rotation(u, v) takes the scalar part minus one and the vector part, in that order")
    return quaternion(1 + u, v) if v.builder.writing.as_written else Rotation(u, v)


def exp(phi: Vector) -> Rotation | Quaternion:
    """Return the rotation of the rotation vector `phi` [rad]: [cos(|phi|/2), sin(|phi|/2) phi/|phi|], cao (14)."""
    if not isinstance(phi, Vector):
        raise UsageError(f"exp takes a rotation vector of three components, not {type(phi).__name__}")
    builder = phi.builder
    builder.settle()
    builder.group("exp", (), (phi.group,))
    if builder.writing.as_written:
        return _exp_as_written(phi)
    series = builder.writing.series
    if series is None:
        zero = dot(phi, phi)
        return Rotation(zero, phi)
    phi = carried(phi, "phi")
    x = step("phi_square = |phi|^2", "", dot(phi, phi))
    u = step("u = cos(|phi|/2) - 1, polynomial in |phi|^2", "cao (9)", x * horner(series.cosine, x))
    if builder.writing.fixed:
        y = step("y = sin(|phi|/2)/|phi| - 1/2, polynomial in |phi|^2", "cao (9)", x * horner(series.sine, x))
        bent = step("bent = y phi", "cao (14)", y * phi)
        return Rotation(u, step("v = phi/2 + bent", "cao (14)", Fraction(1, 2) * phi + bent))
    s = step("s = sin(|phi|/2)/|phi|, polynomial in |phi|^2", "cao (9)", horner((Fraction(1, 2), *series.sine), x))
    v = step("v = s phi", "cao (14)", s * phi)
    return Rotation(u, v)


def _exp_as_written(phi: Vector) -> Quaternion:
    """Write the exponential as xu2019 counts it: a root, four divisions, a sine, a cosine, three products."""
    builder = phi.builder
    length = step("phi_0 = |phi|", "cao (14)", sqrt(dot(phi, phi)))
    half = step("half = phi_0 / 2", "cao (14)", length / 2)
    axis = step("axis = phi / phi_0", "cao (14)", phi / length)
    cosine, sine = (
        Scalar(builder, (value,), builder.group("other", (value,), (half.group,)))
        for value in (builder.emit(RealOp.COSINE, half.value), builder.emit(RealOp.SINE, half.value))
    )
    return step("r = [cos(half), sin(half) axis]", "cao (14)", quaternion(cosine, sine * axis))


def horner(coefficients: Sequence[Fraction], x: Scalar) -> Scalar:
    """Return c0 + x (c1 + x (c2 + ...)): one product and one sum a degree."""
    builder = x.builder
    last, *others = reversed(coefficients)
    value = builder.constant(last)
    total = Scalar(builder, (value,), builder.group("constant", (value,), (), last, abs(last)))
    for coefficient in others:
        total = coefficient + x * total
    return total
