"""The machine language: every value typed, every operation one C expression and one NumPy expression.

For floating-point numbers an operation is correctly rounded, once, in the format of its result. The
integer operations of fixed point join this table with their own rows.
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


ARITY = {
    MachineOp.LITERAL: 0,
    MachineOp.READ: 0,
    MachineOp.ADD: 2,
    MachineOp.SUBTRACT: 2,
    MachineOp.MULTIPLY: 2,
    MachineOp.DIVIDE: 2,
    MachineOp.NEGATE: 1,
    MachineOp.LESS: 2,
    MachineOp.SELECT: 3,
}
