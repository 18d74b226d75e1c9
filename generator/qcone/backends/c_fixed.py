"""C text of integer operations: what stands for each, as an expression or as a call of a small function."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from fractions import Fraction

from qcone.formats.fixed import Fixed, Signal
from qcone.formats.floating import Floating
from qcone.ir.detail import Limits, Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Call, Operation, Routine, Statement, walk

WRAPPING: Mapping[Enum, str] = {
    MachineOp.ADD: "add",
    MachineOp.SUBTRACT: "subtract",
    MachineOp.NEGATE: "negate",
    MachineOp.SHIFT_LEFT: "shift_left",
}
"""Operations whose results may be beyond the word where a design lets them wrap around."""


def integer(raw: int, width: int) -> str:
    """Return an integer constant of a word: with the macro of <stdint.h> where a plain decimal would be too narrow."""
    return f"INT64_C({raw})" if width > 32 else str(raw)


def literal(constant: Fraction, signal: Signal) -> str:
    """Return a constant as its raw word."""
    return integer(signal.raw(constant), signal.width)


def shift_name(operation: Operation, width: int) -> str:
    """Return the name of the function that shifts a sum of `width` bits right and rounds it into the result's word."""
    assert isinstance(operation.detail, Shift)
    assert isinstance(operation.format, Signal)
    word = {"up": "round", "even": "round_even", "floor": "floor"}[operation.detail.rounding]
    kind = "" if width == 2 * operation.format.width else "_wide" if width > 32 else "_short"
    return f"{word}{kind}_{operation.detail.bits}"


def clamp_name(operation: Operation, width: int) -> str:
    """Return the name of the function that clamps a word of `width` bits."""
    assert isinstance(operation.format, Signal)
    return f"clamp_{width}" + (f"_to_{operation.format.width}" if operation.format.width != width else "")


def remainder_name(operation: Operation, width: int) -> str:
    """Return the name of the function that tells what a rounding left over."""
    assert isinstance(operation.format, Signal)
    assert isinstance(operation.detail, Shift)
    kind = "" if width > operation.format.width else "wide_" if width > 32 else "short_"
    return f"left_of_{kind}{operation.detail.bits}"


def low_name(operation: Operation) -> str:
    """Return the name of the function that takes the last bits of a word."""
    assert isinstance(operation.detail, Shift)
    return f"low_{operation.detail.bits}"


def narrow_name(operation: Operation, width: int) -> str:
    """Return the name of the function that takes the lower bits of a wide word."""
    assert isinstance(operation.format, Signal)
    return f"narrow_{width}_to_{operation.format.width}"


class IntegerText:
    """Says how the integer operations of one routine are written: as C, and as the parts C is read back in."""

    def __init__(self, routine: Routine, number: Fixed | Floating) -> None:
        """Note the word of every value."""
        self.wraps = isinstance(number, Fixed) and number.overflow == "wrap"
        self.widths: dict[int, int] = {}
        for statement in walk(routine.body):
            if isinstance(statement, Operation) and isinstance(statement.format, Signal):
                self.widths[statement.result] = statement.format.width
            elif isinstance(statement, Call) and isinstance(number, Fixed):
                self.widths.update(dict.fromkeys(statement.results, number.width))

    def casts(self, operation: Operation) -> str:
        """Return the cast that stands before the first operand: where no operand is as wide as the result."""
        assert isinstance(operation.format, Signal)
        widest = max(self.widths[arg] for arg in operation.args)
        if operation.op is MachineOp.SHIFT_LEFT and operation.format.width > 32:
            return ""
        return f"({operation.format.ctype})" if widest < operation.format.width else ""

    def call(self, operation: Operation) -> tuple[str, tuple[str, ...]] | None:
        """Return the function an operation calls, and its constant arguments; None where it calls none."""
        if operation.op is MachineOp.SHIFT_RIGHT:
            return shift_name(operation, self.widths[operation.args[0]]), ()
        if operation.op is MachineOp.LOW:
            return low_name(operation), ()
        if operation.op is MachineOp.REMAINDER:
            return remainder_name(operation, self.widths[operation.args[0]]), ()
        if self.wraps and operation.op is MachineOp.NARROW:
            return narrow_name(operation, self.widths[operation.args[0]]), ()
        if self.wraps and operation.op in WRAPPING and isinstance(operation.format, Signal):
            shift = (str(operation.detail.bits),) if isinstance(operation.detail, Shift) else ()
            return f"{WRAPPING[operation.op]}_{operation.format.width}", shift
        if operation.op is MachineOp.CLAMP and isinstance(operation.detail, Limits):
            width = self.widths[operation.args[0]]
            low, high = int(operation.detail.low), int(operation.detail.high)
            return clamp_name(operation, width), (integer(low, width), integer(high, width))
        return None

    def factor(self, operation: Operation) -> str:
        """Return the power of two of a left shift."""
        assert isinstance(operation.detail, Shift)
        assert isinstance(operation.format, Signal)
        return integer(1 << operation.detail.bits, operation.format.width)


def remark(statement: Statement) -> str:
    """Return the format and bound of a value, as a comment; nothing for other statements."""
    if not isinstance(statement, Operation) or not isinstance(statement.format, Signal):
        return ""
    size = f", |x| <= {_above(statement.bound)}" if statement.bound is not None else ""
    return f"/* F{statement.format.fraction}{size} */"


def _above(bound: Fraction) -> str:
    """Return a bound in three digits, rounded up."""
    if not bound:
        return "0"
    exponent = 0
    while bound * Fraction(10) ** -exponent >= 1000:
        exponent += 1
    while bound * Fraction(10) ** -exponent < 100:
        exponent -= 1
    digits = -(-bound * Fraction(10) ** -exponent).__floor__()
    return f"{float(Fraction(digits) * Fraction(10) ** exponent):.3g}"
