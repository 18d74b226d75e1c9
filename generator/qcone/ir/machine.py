"""The machine language: every value typed, every operation one C expression and one NumPy expression.

For floating-point numbers an operation is correctly rounded, once, in the format of its result. In fixed point the
operation of bounds, formats and proofs is `mac`; `expand` turns it into integer operations, each exact but for
`shift_right`, and C and counts speak of those.
"""

from __future__ import annotations

from enum import Enum


class MachineOp(Enum):
    """An operation of the machine; the value is its name in text dumps and in operation counts."""

    LITERAL = "literal"
    """A constant, rounded once to the format; `constant` holds the rounded value."""
    READ = "read"
    """A component of a state, input, table or local block."""
    ADD = "add"
    SUBTRACT = "subtract"
    MULTIPLY = "multiply"
    DIVIDE = "divide"
    NEGATE = "negate"
    LESS = "less"
    """a < b, 1 or 0 in an int32_t."""
    SELECT = "select"
    """The second operand where the first is not 0, else the third."""
    MAC = "mac"
    """Fixed point: aligned products and words added in a wide accumulator and rounded once; `detail` holds them."""
    CLAMP = "clamp"
    """Fixed point: the operand, kept between the limits of `detail`."""
    SHIFT_LEFT = "shift_left"
    """An integer times a power of two."""
    SHIFT_RIGHT = "shift_right"
    """An integer over a power of two, rounded as `detail` says, in the word of the result."""
    REMAINDER = "remainder"
    """What rounding took away: the first operand less the second times a power of two, in the word of the result."""
    LOW = "low"
    """The last bits of a word, as a signed number: from -2^(bits-1) on."""
    NARROW = "narrow"
    """An integer that is known to fit in the word of the result."""


ARITY: dict[MachineOp, int | None] = {
    MachineOp.LITERAL: 0,
    MachineOp.READ: 0,
    MachineOp.ADD: 2,
    MachineOp.SUBTRACT: 2,
    MachineOp.MULTIPLY: 2,
    MachineOp.DIVIDE: 2,
    MachineOp.NEGATE: 1,
    MachineOp.LESS: 2,
    MachineOp.SELECT: 3,
    MachineOp.MAC: None,
    MachineOp.CLAMP: 1,
    MachineOp.SHIFT_LEFT: 1,
    MachineOp.SHIFT_RIGHT: 1,
    MachineOp.REMAINDER: 2,
    MachineOp.LOW: 1,
    MachineOp.NARROW: 1,
}
