"""Lower the real language to floating-point machine operations, one for one; constants are rounded here, once."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.floating import TRUTH, Floating
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Program, Routine, Statement
from qcone.passes.rebuild import rebuild

ONE_FOR_ONE: Mapping[object, MachineOp] = {
    RealOp.READ: MachineOp.READ,
    RealOp.ADD: MachineOp.ADD,
    RealOp.ACCUMULATE: MachineOp.ADD,
    RealOp.SUBTRACT: MachineOp.SUBTRACT,
    RealOp.MULTIPLY: MachineOp.MULTIPLY,
    RealOp.DIVIDE: MachineOp.DIVIDE,
    RealOp.NEGATE: MachineOp.NEGATE,
    RealOp.SELECT: MachineOp.SELECT,
}


def lower_program(program: Program, number: Floating) -> Program:
    """Return the program with every routine in machine operations of one floating-point format."""
    return replace(program, routines=tuple(lower_float(routine, number) for routine in program.routines))


def lower_float(routine: Routine, number: Floating) -> Routine:
    """Return the routine in machine operations of one floating-point format.

    Raises UsageError for an operation firmware does without, a square root, a sine or a cosine, and for a
    constant that the format cannot hold.
    """

    def visit(operation: Operation) -> Iterable[Statement]:
        if operation.op is RealOp.CONSTANT and operation.constant is not None:
            exact = operation.constant
            rounded = _rounded(exact, routine, number)
            return (replace(operation, op=MachineOp.LITERAL, constant=rounded, exact=exact, format=number),)
        if operation.op is RealOp.LESS:
            return (replace(operation, op=MachineOp.LESS, format=TRUTH),)
        if operation.op in ONE_FOR_ONE:
            return (replace(operation, op=ONE_FOR_ONE[operation.op], format=number),)
        raise UsageError(
            f"the routine '{routine.name}' takes a {operation.op.value.replace('_', ' ')}, which emitted C does "
            'without: set form = "factored"'
        )

    body = rebuild(routine.body, visit, {})
    blocks = tuple(
        replace(block, entries=tuple(_rounded(each, routine, number) for each in block.entries), exact=block.entries)
        for block in routine.blocks
    )
    callees = {name: lower_float(callee, number) for name, callee in routine.callees.items()}
    return replace(routine, body=body, blocks=blocks, callees=callees)


def _rounded(constant: Fraction, routine: Routine, number: Floating) -> Fraction:
    try:
        return number.round(constant)
    except OverflowError as error:
        raise UsageError(f"the routine '{routine.name}': the constant {error}: scale the equation") from error
