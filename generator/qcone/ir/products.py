"""The products of vectors and quaternions, written out on component values, order and signs as stated.

`emit` writes one operation and returns its value. The order of the terms is part of the contract: it is
what the emitted C does, and what symmetry properties rest on.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from qcone.ir.operations import RealOp

Emit = Callable[..., int]
Values = Sequence[int]


def cross(emit: Emit, a: Values, b: Values) -> tuple[int, ...]:
    """Return a x b: six products, three differences."""
    ax, ay, az = a
    bx, by, bz = b

    def minor(p: int, q: int, r: int, s: int) -> int:
        return emit(RealOp.SUBTRACT, emit(RealOp.MULTIPLY, p, q), emit(RealOp.MULTIPLY, r, s))

    return minor(ay, bz, az, by), minor(az, bx, ax, bz), minor(ax, by, ay, bx)


def dot(emit: Emit, a: Values, b: Values) -> int:
    """Return a . b, summed from the first component on."""
    first, *others = (emit(RealOp.MULTIPLY, p, q) for p, q in zip(a, b, strict=True))
    for other in others:
        first = emit(RealOp.ADD, first, other)
    return first


def hamilton(emit: Emit, p: Values, q: Values) -> tuple[int, ...]:
    """Return p (x) q by the signed matrix of p, cao (2): 16 products, 12 additions, 6 negations."""
    a, b, c, d = p

    def minus(value: int) -> int:
        return emit(RealOp.NEGATE, value)

    rows = (
        (a, minus(b), minus(c), minus(d)),
        (b, a, minus(d), c),
        (c, d, a, minus(b)),
        (d, minus(c), b, a),
    )
    return tuple(dot(emit, row, q) for row in rows)


def hamilton_least(emit: Emit, p: Values, q: Values) -> tuple[int, ...]:
    """Return p (x) q with the signs in the sums: 16 products, 6 additions, 6 subtractions."""
    a, b, c, d = p
    e, f, g, h = q

    def signed(first: tuple[int, int], *others: tuple[RealOp, int, int]) -> int:
        total = emit(RealOp.MULTIPLY, *first)
        for op, left, right in others:
            total = emit(op, total, emit(RealOp.MULTIPLY, left, right))
        return total

    plus, minus = RealOp.ADD, RealOp.SUBTRACT
    return (
        signed((a, e), (minus, b, f), (minus, c, g), (minus, d, h)),
        signed((a, f), (plus, b, e), (plus, c, h), (minus, d, g)),
        signed((a, g), (plus, c, e), (plus, d, f), (minus, b, h)),
        signed((a, h), (plus, d, e), (plus, b, g), (minus, c, f)),
    )


def hamilton_pure(emit: Emit, p: Values, v: Values) -> tuple[int, ...]:
    """Return p (x) (0, v): 12 products; those with the known zero are not written."""
    a, b, c, d = p
    x, y, z = v

    def three(first: int, second: int, third: int) -> int:
        return emit(RealOp.SUBTRACT, emit(RealOp.ADD, first, second), third)

    def product(left: int, right: int) -> int:
        return emit(RealOp.MULTIPLY, left, right)

    return (
        emit(RealOp.NEGATE, dot(emit, (b, c, d), (x, y, z))),
        three(product(a, x), product(c, z), product(d, y)),
        three(product(a, y), product(d, x), product(b, z)),
        three(product(a, z), product(b, y), product(c, x)),
    )
