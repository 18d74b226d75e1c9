"""Operation counts: of a routine in either language, executed once, loops and calls multiplied out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import Enum
from fractions import Fraction

from qcone.formats.fixed import Signal
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import Call, Loop, Operation, Routine, Statement

KINDS: Mapping[Enum, str] = {
    RealOp.ADD: "add",
    RealOp.ACCUMULATE: "add",
    RealOp.SUBTRACT: "subtract",
    RealOp.MULTIPLY: "multiply",
    RealOp.DIVIDE: "divide",
    RealOp.NEGATE: "negate",
    RealOp.SQUARE_ROOT: "square_root",
    RealOp.SINE: "trigonometric",
    RealOp.COSINE: "trigonometric",
    RealOp.CONSTANT: "",
    RealOp.READ: "",
    RealOp.ARCTANGENT_2: "trigonometric",
    RealOp.ARCSINE: "trigonometric",
    RealOp.LESS: "compare",
    RealOp.SELECT: "select",
    MachineOp.LESS: "compare",
    MachineOp.SELECT: "select",
    MachineOp.ADD: "add",
    MachineOp.SUBTRACT: "subtract",
    MachineOp.MULTIPLY: "multiply",
    MachineOp.DIVIDE: "divide",
    MachineOp.NEGATE: "negate",
    MachineOp.MAC: "",
    MachineOp.CLAMP: "select",
    MachineOp.SHIFT_LEFT: "shift",
    MachineOp.SHIFT_RIGHT: "shift",
    MachineOp.LOW: "shift",
    MachineOp.NARROW: "",
    MachineOp.REMAINDER: "subtract",
    RealOp.CARRY: "",
    RealOp.WIDE: "",
    RealOp.CLAMP: "",
    RealOp.SUM: "",
    MachineOp.LITERAL: "",
    MachineOp.READ: "",
}

WORD = 32


@dataclass(frozen=True)
class Counts:
    """How often each operation is executed. `power_of_two` are products by 2^k, not among `multiply`."""

    multiply: int = 0
    power_of_two: int = 0
    divide: int = 0
    add: int = 0
    subtract: int = 0
    negate: int = 0
    square_root: int = 0
    trigonometric: int = 0
    compare: int = 0
    select: int = 0
    shift: int = 0

    def __add__(self, other: Counts) -> Counts:
        """Add kind by kind."""
        return Counts(*(getattr(self, each.name) + getattr(other, each.name) for each in fields(self)))

    def as_papers_count(self) -> Counts:
        """Return the counts with products by powers of two among the products, as the papers have them."""
        values = {each.name: getattr(self, each.name) for each in fields(self)}
        return Counts(**{**values, "multiply": self.multiply + self.power_of_two, "power_of_two": 0})


def count(routine: Routine) -> Counts:
    """Count the operations one call of the routine executes."""
    constants = {
        each.result: each.constant for each in routine.body if isinstance(each, Operation) and each.constant is not None
    }
    found: Counter[str] = Counter()
    _body(routine.body, routine, constants, {}, found)
    return Counts(**found)


def _body(
    body: tuple[Statement, ...],
    routine: Routine,
    constants: dict[int, Fraction],
    counters: dict[str, int],
    found: Counter[str],
) -> None:
    for statement in body:
        match statement:
            case Operation():
                if statement.constant is not None:
                    constants[statement.result] = statement.constant
                kind = KINDS[statement.op]
                scaled = any(is_power_of_two(constants.get(arg)) for arg in statement.args)
                if kind == "multiply" and scaled and not isinstance(statement.format, Signal):
                    kind = "power_of_two"
                if kind:
                    found[kind] += 1
            case Loop():
                for turn in statement.turns(counters):
                    _body(statement.body, routine, constants, counters | {statement.counter: turn}, found)
            case Call():
                inner = count(routine.callees[statement.routine])
                found.update({each.name: getattr(inner, each.name) for each in fields(inner)})


@dataclass(frozen=True)
class Products:
    """Integer products of one call: of more than 32 bits, of fewer, and how many of both have a constant factor."""

    whole: int
    lower: int
    constant: int


def products(routine: Routine) -> Products:
    """Count the integer products of a routine without loops, those of the routines it calls included."""
    literals = {each.result for each in routine.body if isinstance(each, Operation) and each.op is MachineOp.LITERAL}
    whole = lower = constant = 0
    for statement in routine.body:
        if isinstance(statement, Call):
            inner = products(routine.callees[statement.routine])
            whole, lower, constant = whole + inner.whole, lower + inner.lower, constant + inner.constant
        elif isinstance(statement, Operation) and statement.op is MachineOp.MULTIPLY:
            assert isinstance(statement.format, Signal)
            wide = statement.format.width > WORD
            whole, lower = whole + wide, lower + (not wide)
            constant += not literals.isdisjoint(statement.args)
    return Products(whole, lower, constant)


def is_power_of_two(value: Fraction | None) -> bool:
    """Tell whether a factor is 2^k or -2^k."""
    if not value:
        return False
    top, bottom = abs(value.numerator), value.denominator
    return top & (top - 1) == 0 and bottom & (bottom - 1) == 0
