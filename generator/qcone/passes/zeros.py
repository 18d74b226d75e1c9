"""Leave out terms that are zero: exact for finite numbers.

A product with the constant 0 is a zero of some sign. Added to a sum that cannot be -0 it changes nothing; and a
sum that began at +0 never is -0, for in rounding to nearest x + y is -0 only when both are. So a recurrence that
is written over components that are known to be zero costs no more than one written around them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Routine, Statement
from qcone.passes.fold import fold
from qcone.passes.rebuild import names_after, rebuild, regrouped
from qcone.passes.share import share


def zeros(routine: Routine) -> Routine:
    """Return the routine without terms that are products with zero, and what follows from that."""
    while True:
        shorter = share(fold(_once(routine)))
        if shorter.body == routine.body:
            return shorter
        routine = shorter


def _once(routine: Routine) -> Routine:
    facts = _Facts()
    renamed: dict[int, int] = {}

    def visit(operation: Operation) -> Iterable[Statement]:
        stand_in = facts.stand_in(operation)
        if stand_in is not None:
            renamed[operation.result] = stand_in
            return ()
        if facts.is_plus_zero(operation):
            operation = replace(operation, op=RealOp.CONSTANT, args=(), constant=Fraction(0))
        facts.learn(operation)
        return (operation,)

    body = rebuild(routine.body, visit, renamed)
    names = names_after(routine.names, renamed)
    return replace(routine, body=body, names=names, groups=regrouped(routine.groups, renamed))


class _Facts:
    """What is known of values: +0 itself, a zero of some sign, a number that is not -0, 0 + p for some p."""

    def __init__(self) -> None:
        self.plus_zero: set[int] = set()
        self.zero: set[int] = set()
        self.not_minus_zero: set[int] = set()
        self.begun: dict[int, int] = {}

    def stand_in(self, operation: Operation) -> int | None:
        """Return the operand that the operation's result is equal to, bit for bit."""
        if operation.op not in (RealOp.ADD, RealOp.SUBTRACT):
            return None
        a, b = operation.args
        if b in self.zero and a in self.not_minus_zero:
            return a
        if operation.op is RealOp.ADD and a in self.zero and b in self.not_minus_zero:
            return b
        return None

    def is_plus_zero(self, operation: Operation) -> bool:
        """Tell whether the result is +0: (0 + p) - p."""
        return operation.op is RealOp.SUBTRACT and self.begun.get(operation.args[0]) == operation.args[1]

    def learn(self, operation: Operation) -> None:
        """Note what the operation makes known."""
        result, args = operation.result, operation.args
        match operation.op:
            case RealOp.CONSTANT:
                self.not_minus_zero.add(result)
                if operation.constant == 0:
                    self.plus_zero.add(result)
                    self.zero.add(result)
            case RealOp.MULTIPLY if args[0] in self.zero or args[1] in self.zero:
                self.zero.add(result)
            case RealOp.ADD:
                if args[0] in self.not_minus_zero or args[1] in self.not_minus_zero:
                    self.not_minus_zero.add(result)
                if args[0] in self.plus_zero:
                    self.begun[result] = args[1]
            case RealOp.SUBTRACT if args[0] in self.not_minus_zero:
                self.not_minus_zero.add(result)
