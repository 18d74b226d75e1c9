"""Square root, arctangent, arcsine without a library: polynomials, a division or two, and selections.

The polynomials are chosen for the number format (`Functions` of the routine's `Writing`); where none are chosen,
in the real language, the functions are operations of their own. No step branches: a selection computes both sides.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from qcone.ir.blocks import Number, Scalar, number, sqrt
from qcone.ir.builder import Builder
from qcone.ir.operations import RealOp
from qcone.ir.update import horner
from qcone.ir.writing import Functions

PI = Fraction(31415926535897932384626433832795028841971693993751, 10**49)
"""Pi, nearer than any format needs."""
ABOVE_PI = Fraction(31416, 10**4)
ARCTANGENT_END = Fraction(4143, 10**4)
"""The largest argument of the arctangent's polynomial."""


@dataclass(frozen=True)
class Condition:
    """A truth value of the routine; `select` takes it."""

    builder: Builder
    value: int


def within(a: Scalar, low: Number, high: Number) -> Scalar:
    """Return a, which lies between two numbers: in fixed point, where its range must be plain, as a clamp."""
    if not a.builder.writing.fixed:
        return a
    value = a.builder.clamp(a.value, Fraction(low), Fraction(high))
    return Scalar(a.builder, (value,), a.builder.group("other", (value,), (a.group,)))


def wide(a: Scalar) -> Scalar:
    """Return a, in fixed point in a word twice as wide: for what a root is taken of."""
    if not a.builder.writing.fixed:
        return a
    value = a.builder.emit(RealOp.WIDE, a.value)
    return Scalar(a.builder, (value,), a.builder.group("other", (value,), (a.group,)))


def less(a: Scalar, b: Scalar | Number) -> Condition:
    """Return a < b."""
    other = b if isinstance(b, Scalar) else number(b, a)
    return Condition(a.builder, a.builder.emit(RealOp.LESS, a.value, other.value))


def select(condition: Condition, chosen: Scalar | Number, otherwise: Scalar | Number) -> Scalar:
    """Return one of two scalars."""
    like = chosen if isinstance(chosen, Scalar) else otherwise
    assert isinstance(like, Scalar)
    parts = [each if isinstance(each, Scalar) else number(each, like) for each in (chosen, otherwise)]
    value = condition.builder.emit(RealOp.SELECT, condition.value, *(each.value for each in parts))
    return Scalar(like.builder, (value,), like.builder.group("other", (value,), [each.group for each in parts]))


def magnitude(a: Scalar) -> tuple[Condition, Scalar]:
    """Return whether a < 0, and |a|."""
    negative = less(a, 0)
    return negative, select(negative, -a, a)


def reciprocal_root(t: Scalar) -> Scalar:
    """Return 1/sqrt(t) for 1 <= t <= 4: a polynomial and two Newton steps y (3 - t y^2)/2."""
    if t.builder.writing.functions is None:
        return 1 / sqrt(t)
    t = within(t, 1, 4)
    y = within(horner(_chosen(t).reciprocal_root, t), Fraction(1, 4), Fraction(5, 4))
    for _ in range(2):
        y = within(y + Fraction(1, 2) * y * (1 - t * (y * y)), Fraction(1, 4), Fraction(5, 4))
    return y


def square_root(x: Scalar) -> Scalar:
    """Return sqrt(x) for 0 <= x < 1: x is brought to [1, 4) by powers of four, a selection each."""
    scale: Scalar = number(Fraction(1, 2), x)
    for power in _chosen(x).ladder:
        end = Fraction(1, 4**power)
        small = less(x, end)
        x = select(small, wide(Fraction(4**power) * within(x, 0, end)), x)
        scale = select(small, Fraction(1, 2**power) * scale, scale)
    t = within(Fraction(4) * x, 1, 4)
    return t * reciprocal_root(t) * scale


def ratio(small: Scalar, large: Scalar) -> Scalar:
    """Return small/large of 0 <= small <= large; 0 where both are 0, and for a ratio near the least normal number."""
    functions = small.builder.writing.functions
    return small / large if functions is None else _quotient(small, large, _counts(small, large, functions))


def _counts(small: Scalar, large: Scalar, functions: Functions) -> Condition:
    return less(functions.negligible * large, small)


def _quotient(top: Scalar, bottom: Scalar, counts: Condition) -> Scalar:
    """Return top/bottom where it counts, else 0: runtime libraries round subnormal quotients in ways of their own."""
    return select(counts, top, 0) / select(counts, bottom, 1)


def arctangent_2(y: Scalar, x: Scalar) -> Scalar:
    """Return atan2(y, x) in [-pi, pi]; 0 for x = y = 0.

    The smaller over the larger magnitude lies in [0, 1]; above tan(pi/8) the angle is counted from pi/4, by
    (a - b)/(a + b), so that the polynomial's argument stays below 0.4143: one division in all. A ratio near the
    least normal number is taken for 0, far below the last bit of any angle that is not as small itself.
    """
    functions = x.builder.writing.functions
    if functions is None:
        return _operation(RealOp.ARCTANGENT_2, y, x)
    y_negative, y_size = magnitude(y)
    x_negative, x_size = magnitude(x)
    steep = less(x_size, y_size)
    small, large = select(steep, x_size, y_size), select(steep, y_size, x_size)
    past = less(functions.eighth * large, small)
    top = select(past, small - large, small)
    bottom = select(past, small + large, large)
    if x.builder.writing.fixed:
        t = within(top / within(bottom, functions.smallest, 8), -ARCTANGENT_END, ARCTANGENT_END)
    else:
        t = _quotient(top, bottom, _counts(small, large, functions))
    square = t * t
    angle = t + t * (square * horner(functions.arctangent, square))
    angle = select(past, PI / 4 + angle, angle)
    angle = select(steep, PI / 2 - angle, angle)
    angle = select(x_negative, PI - angle, angle)
    return select(y_negative, -angle, angle)


def arcsine(x: Scalar) -> Scalar:
    """Return asin(x), x clamped to [-1, 1]: atan2(x, sqrt((1 - x)(1 + x)))."""
    if x.builder.writing.functions is None:
        return _operation(RealOp.ARCSINE, x)
    x = select(less(x, -1), -1, x)
    x = select(less(number(1, x), x), 1, x)
    return arctangent_2(x, square_root_of_unit((1 - x) * (1 + x)))


def sine_cosine(angle: Scalar) -> tuple[Scalar, Scalar]:
    """Return (sin, cos) of an angle of at most 3 pi in size: folded to [0, pi/4], a polynomial each."""
    functions = angle.builder.writing.functions
    if functions is None:
        return _operation(RealOp.SINE, angle), _operation(RealOp.COSINE, angle)
    angle = within(select(less(number(PI, angle), angle), angle - 2 * PI, angle), -3 * ABOVE_PI, ABOVE_PI)
    angle = within(select(less(angle, -PI), angle + 2 * PI, angle), -ABOVE_PI, ABOVE_PI)
    negative, size = magnitude(angle)
    size = within(size, 0, ABOVE_PI)
    obtuse = less(number(PI / 2, size), size)
    size = within(select(obtuse, PI - size, size), 0, ABOVE_PI / 2)
    steep = less(number(PI / 4, size), size)
    t = within(select(steep, PI / 2 - size, size), 0, ABOVE_PI / 4)
    square = t * t
    sine = t + t * (square * horner(functions.sine, square))
    cosine = 1 + square * horner(functions.cosine, square)
    up, along = select(steep, cosine, sine), select(steep, sine, cosine)
    return select(negative, -up, up), select(obtuse, -along, along)


def sine_cosine_of_small(angle: Scalar) -> tuple[Scalar, Scalar]:
    """Return (sin, cos) of an angle whose size the design declares to be small: a few terms of the series each."""
    chosen = angle.builder.writing.small_angle
    if chosen is None:
        return _operation(RealOp.SINE, angle), _operation(RealOp.COSINE, angle)
    square = angle * angle
    sine = angle + angle * (square * horner(chosen.sine, square)) if chosen.sine else angle
    cosine = 1 + square * horner(chosen.cosine, square) if chosen.cosine else number(1, angle)
    return sine, cosine


def square_root_of_unit(x: Scalar) -> Scalar:
    """Return sqrt(x) for 0 <= x <= 1."""
    if x.builder.writing.functions is None:
        return sqrt(x)
    return Fraction(2) * square_root(Fraction(1, 4) * x)


def _operation(op: RealOp, *arguments: Scalar) -> Scalar:
    first = arguments[0]
    value = first.builder.emit(op, *(each.value for each in arguments))
    return Scalar(first.builder, (value,), first.builder.group("other", (value,), [each.group for each in arguments]))


def _chosen(x: Scalar) -> Functions:
    functions = x.builder.writing.functions
    assert functions is not None, "this function is written out only where a number format has chosen its polynomials"
    return functions
