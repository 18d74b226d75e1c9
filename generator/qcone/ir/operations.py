"""The operations of the real language, one row each."""

from __future__ import annotations

from enum import Enum


class RealOp(Enum):
    """An operation on real numbers; the value is its name in text dumps."""

    CONSTANT = "constant"
    READ = "read"
    ADD = "add"
    SUBTRACT = "subtract"
    MULTIPLY = "multiply"
    DIVIDE = "divide"
    NEGATE = "negate"
    SQUARE_ROOT = "square_root"
    SINE = "sine"
    COSINE = "cosine"
    ARCTANGENT_2 = "arctangent_2"
    """atan2(y, x)."""
    ARCSINE = "arcsine"
    LESS = "less"
    """a < b: a truth value, which only `select` takes."""
    SELECT = "select"
    """One of two numbers by a truth value: select(condition, if true, if false)."""
    ACCUMULATE = "accumulate"
    """state + increment. In exact arithmetic an addition; the number format says how the rounding is carried."""
    CARRY = "carry"
    """The operand itself; the number format carries its rounding on to the next update."""
    WIDE = "wide"
    """The operand itself, kept in a word twice as wide."""
    CLAMP = "clamp"
    """The operand, kept between two constants: what is known of it, as an operation."""
    SUM = "sum"
    """A sum of terms, each a product of at most two values and an exact coefficient: `detail` holds them."""


ARITY: dict[RealOp, int | None] = {
    RealOp.CONSTANT: 0,
    RealOp.READ: 0,
    RealOp.ADD: 2,
    RealOp.SUBTRACT: 2,
    RealOp.MULTIPLY: 2,
    RealOp.DIVIDE: 2,
    RealOp.NEGATE: 1,
    RealOp.SQUARE_ROOT: 1,
    RealOp.SINE: 1,
    RealOp.COSINE: 1,
    RealOp.ARCTANGENT_2: 2,
    RealOp.ARCSINE: 1,
    RealOp.LESS: 2,
    RealOp.SELECT: 3,
    RealOp.ACCUMULATE: 2,
    RealOp.CARRY: 1,
    RealOp.WIDE: 1,
    RealOp.CLAMP: 1,
    RealOp.SUM: None,
}
