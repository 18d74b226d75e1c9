"""Compensate: carry the rounding of q to the next update, by Kahan's sum in place of q + dq.

y = d - c, t = q + y, c' = (t - q) - y: in exact arithmetic c stays zero and t is q + d; in floating point
c' is what the sum lost. The residual c joins the state; what sets q anew clears it; what reports q reports
q - c, rounded once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.ir.index import Index
from qcone.ir.operations import RealOp
from qcone.ir.statement import (
    SUFFIXES,
    Block,
    Operation,
    Place,
    Program,
    Role,
    Routine,
    Shape,
    Statement,
    Step,
    Write,
    results,
    walk,
)
from qcone.passes.rebuild import rebuild

RESIDUAL = "residual"
SETTING = frozenset({"init", "set_quaternion", "set_dcm"})
"""The routines that set the attitude anew."""


def compensate(program: Program) -> Program:
    """Return the program with compensated accumulation of its attitude.

    The residual has a component for each that is accumulated: all four of a quaternion, two rows of a matrix.
    Raises UsageError for an algorithm that accumulates nothing.
    """
    carried = max(sum(map(_accumulates, walk(routine.body))) for routine in program.routines)
    if not carried:
        raise UsageError(
            'accumulate = "compensated" carries the rounding of an attitude plus an increment, and this algorithm '
            'forms none: set accumulate = "standard"'
        )
    held = program.state[0]
    unit = f"rounding error that {held.name} carries: attitude is {held.name} - residual"
    residual = Block(RESIDUAL, Shape.SCALAR, Role.STATE, carried, unit)
    state = (held, residual, *program.state[1:])
    return replace(program, state=state, routines=tuple(_routine(each, held, residual) for each in program.routines))


def _accumulates(statement: Statement) -> bool:
    return isinstance(statement, Operation) and statement.op is RealOp.ACCUMULATE


def _routine(routine: Routine, held: Block, residual: Block) -> Routine:
    accumulates = any(map(_accumulates, walk(routine.body)))
    reports = bool(routine.having(Role.OUTPUT))
    if held not in routine.blocks:
        return routine
    work = _Compensation(routine, held, residual)
    if accumulates:
        body = rebuild(routine.body, work.accumulate, {})
        body += tuple(Write(_residual(part), value, len(work.steps) - 1) for part, value in enumerate(work.left))
    elif routine.name in SETTING:
        body = (*routine.body, *work.clear())
    elif reports:
        renamed: dict[int, int] = {}
        body = rebuild(routine.body, lambda operation: work.report(operation, renamed), renamed)
    else:
        body = routine.body
    at = 1 + routine.blocks.index(held)
    blocks = (*routine.blocks[:at], residual, *routine.blocks[at:])
    return replace(routine, blocks=blocks, body=body, names=work.names, steps=tuple(work.steps))


def _residual(part: int) -> Place:
    return Place(RESIDUAL, Index(part))


class _Compensation:
    """Writes the added statements of one routine."""

    def __init__(self, routine: Routine, held: Block, residual: Block) -> None:
        self.held, self.residual = held, residual
        self.suffixes = SUFFIXES[held.shape]
        self.names = dict(routine.names)
        self.steps = [*routine.steps]
        self.left: list[int] = []
        self.next = max(results(routine.body), default=-1) + 1

    def _new(self, name: str, op: RealOp, args: tuple[int, ...], step: int, place: Place | None = None) -> Operation:
        operation = Operation(self.next, op, args, place=place, step=step)
        self.names[self.next] = name
        self.next += 1
        return operation

    def _step(self, text: str) -> int:
        step = Step(text, "Kahan 1965")
        if step not in self.steps:
            self.steps.append(step)
        return self.steps.index(step)

    def accumulate(self, operation: Operation) -> Iterable[Statement]:
        """Write y = d - c, t = q + y, c' = (t - q) - y for one component."""
        if operation.op is not RealOp.ACCUMULATE:
            return (operation,)
        q, change = operation.args
        part, suffix = len(self.left), self.suffixes[len(self.left)]
        step = self._step("y = increment - c, next = now + y, c_next = (next - now) - y, c the residual")
        carried = self._new(f"residual{suffix}", RealOp.READ, (), step, _residual(part))
        y = self._new(f"y{suffix}", RealOp.SUBTRACT, (change, carried.result), step)
        total = replace(operation, op=RealOp.ADD, args=(q, y.result), step=step)
        gained = self._new(f"gained{suffix}", RealOp.SUBTRACT, (total.result, q), step)
        left = self._new(f"residual_next{suffix}", RealOp.SUBTRACT, (gained.result, y.result), step)
        self.left.append(left.result)
        return (carried, y, total, gained, left)

    def clear(self) -> Iterable[Statement]:
        """Write zero to the residual."""
        step = len(self.steps) - 1
        zero = Operation(self.next, RealOp.CONSTANT, constant=Fraction(0), step=step)
        return (zero, *(Write(_residual(part), zero.result, step) for part in range(self.residual.size)))

    def report(self, operation: Operation, renamed: dict[int, int]) -> Iterable[Statement]:
        """Write q - c after a read of q, and let it stand for q from there on; the same for rows of a matrix."""
        place = operation.place
        if place is None or place.block != self.held.name or place.index.constant >= self.residual.size:
            return (operation,)
        part, suffix = place.index.constant, self.suffixes[place.index.constant]
        name = self.names.pop(operation.result, f"{self.held.name}{suffix}")
        self.names[operation.result] = f"state{suffix}"
        carried = self._new(f"residual{suffix}", RealOp.READ, (), operation.step, _residual(part))
        whole = self._new(name, RealOp.SUBTRACT, (operation.result, carried.result), operation.step)
        renamed[operation.result] = whole.result
        return (operation, carried, whole)
