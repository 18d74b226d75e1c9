"""Legality of a routine, checked after every pass: cheap, always on, and precise about what is wrong."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum

from qcone.errors import QconeError, UsageError
from qcone.ir import machine, operations
from qcone.ir.detail import Sum
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import (
    Advance,
    Call,
    Choose,
    Loop,
    Operation,
    Place,
    Program,
    Ready,
    Role,
    Routine,
    Statement,
    Write,
    reachable,
)


class IllegalRoutineError(QconeError):
    """A pass left a routine that breaks a rule of its language: a bug of ours (exit code 70)."""


Turns = Sequence[Mapping[str, int]]
"""Every combination of loop counters a statement is run with: loops are short, and so nothing is guessed."""
ARITY: Mapping[Enum, int | None] = dict((*operations.ARITY.items(), *machine.ARITY.items()))


def check(routine: Routine, language: type[Enum]) -> Routine:
    """Return the routine if it is legal in `language` (RealOp or MachineOp), else raise IllegalRoutineError."""
    _Checker(routine, language).run()
    for callee in routine.callees.values():
        check(callee, language)
    return routine


def check_program(program: Program, language: type[Enum]) -> Program:
    """Check every routine, and that each block of the state is the same wherever it appears.

    Raises UsageError where two functions would have one name: an author's subroutine has a name that is taken.
    """
    state = {block.name: block for block in program.state}
    for routine in program.routines:
        check(routine, language)
        for block in routine.having(Role.STATE):
            if state.get(block.name) != block:
                raise IllegalRoutineError(f"{routine.name}: the state has no block {block}")
    known = {routine.name: routine for routine in program.routines}
    for routine in program.routines:
        for callee in reachable(routine):
            if known.setdefault(callee.name, callee) != callee:
                raise UsageError(f"the subroutine '{callee.name}' has the name of another function: rename it")
    return program


class _Checker:
    def __init__(self, routine: Routine, language: type[Enum]) -> None:
        self.routine, self.language = routine, language
        self.defined: set[int] = set()
        self.written: set[tuple[str, int]] = set()
        """Components of blocks."""

    def run(self) -> None:
        self._body(self.routine.body, ({},), frozenset())

    def _body(self, body: Sequence[Statement], turns: Turns, visible: frozenset[int]) -> None:
        known = set(visible)
        for statement in body:
            if not 0 <= statement.step < len(self.routine.steps):
                self._fail(statement, f"step {statement.step} is not in the routine")
            match statement:
                case Operation():
                    self._operation(statement, turns, known)
                case Write():
                    self._use(statement, (statement.value,), known)
                    self._place(statement, statement.place, turns)
                    if self.routine.block(statement.place.block).role in (Role.INPUT, Role.TABLE):
                        self._fail(statement, f"'{statement.place.block}' is read only")
                    self.written |= _components(statement.place, turns)
                case Loop():
                    self._loop(statement, turns, known)
                case Call():
                    self._call(statement, known)
                case Advance() | Ready():
                    self._place(statement, statement.place, turns)
                case Choose():
                    if body is not self.routine.body or len(body) != 1:
                        self._fail(statement, "a routine that hands its call on does nothing else")

    def _loop(self, statement: Loop, turns: Turns, known: set[int]) -> None:
        """Check the body once, for every combination of counters it will run with."""
        if any(statement.counter in counters for counters in turns):
            self._fail(statement, f"the counter '{statement.counter}' is in use")
        self._counted(statement, statement.first, turns)
        self._counted(statement, statement.last, turns)
        inside = _inside(statement, turns)
        self.written |= _written(statement.body, inside)  # what one turn writes, the next one reads
        self._body(statement.body, inside, frozenset(known))

    def _operation(self, statement: Operation, turns: Turns, known: set[int]) -> None:
        op = statement.op
        if not isinstance(op, self.language):
            self._fail(statement, f"{op} is not of the language {self.language.__name__}")
        takes = None if isinstance(statement.detail, Sum) else ARITY[op]
        if takes is not None and len(statement.args) != takes:
            self._fail(statement, f"{op.value} takes {takes} operands, not {len(statement.args)}")
        self._use(statement, statement.args, known)
        if (statement.constant is not None) != (op in (RealOp.CONSTANT, MachineOp.LITERAL)):
            self._fail(statement, "a constant, and nothing else, holds a number")
        if (statement.place is not None) != (op in (RealOp.READ, MachineOp.READ)):
            self._fail(statement, "a read, and nothing else, holds a place")
        if statement.place is not None:
            self._place(statement, statement.place, turns)
            block = self.routine.block(statement.place.block)
            if block.role is Role.STATE and self.written & _components(statement.place, turns):
                self._fail(statement, f"the state '{block.name}' is read after it was written")
        if (statement.format is None) != (self.language is RealOp):
            self._fail(statement, "a machine value has a format, a real value has none")
        self._define(statement, statement.result, known)

    def _call(self, statement: Call, known: set[int]) -> None:
        callee = self.routine.callees.get(statement.routine)
        if callee is None:
            self._fail(statement, f"there is no routine '{statement.routine}'")
            return
        takes = sum(block.size for block in callee.having(Role.INPUT))
        gives = sum(block.size for block in callee.having(Role.OUTPUT))
        if (len(statement.args), len(statement.results)) != (takes, gives):
            self._fail(statement, f"'{callee.name}' takes {takes} components and gives {gives}")
        self._use(statement, statement.args, known)
        for result in statement.results:
            self._define(statement, result, known)

    def _place(self, statement: Statement, place: Place, turns: Turns) -> None:
        try:
            block = self.routine.block(place.block)
        except KeyError:
            self._fail(statement, f"there is no block '{place.block}'")
            return
        self._counted(statement, place.index, turns)
        reached = {place.index.at(counters) for counters in turns}
        if reached and not 0 <= min(reached) <= max(reached) < block.size:
            self._fail(statement, f"{place} is outside the {block.size} components of '{block.name}'")

    def _counted(self, statement: Statement, index: Index, turns: Turns) -> None:
        for name, _ in index.terms:
            if any(name not in counters for counters in turns):
                self._fail(statement, f"index {index}: there is no loop over '{name}' here")

    def _use(self, statement: Statement, args: Sequence[int], known: set[int]) -> None:
        for arg in args:
            if arg not in known:
                self._fail(statement, f"value {arg} is not defined here")

    def _define(self, statement: Statement, result: int, known: set[int]) -> None:
        if result in self.defined:
            self._fail(statement, f"value {result} is defined twice")
        self.defined.add(result)
        known.add(result)

    def _fail(self, statement: Statement, why: str) -> None:
        raise IllegalRoutineError(f"routine '{self.routine.name}': {statement}: {why}")


def _components(place: Place, turns: Turns) -> set[tuple[str, int]]:
    """Return the components that a place is in some turn of the loops around it."""
    return {(place.block, place.index.at(counters)) for counters in _having(turns, place.index)}


def _written(body: Sequence[Statement], turns: Turns) -> set[tuple[str, int]]:
    """Return the components that a body of statements writes in all of its turns."""
    found: set[tuple[str, int]] = set()
    for statement in body:
        if isinstance(statement, Write):
            found |= _components(statement.place, turns)
        elif isinstance(statement, Loop):
            found |= _written(statement.body, _inside(statement, turns))
    return found


def _inside(loop: Loop, turns: Turns) -> Turns:
    counted = _having(turns, loop.first, loop.last)
    return [{**counters, loop.counter: turn} for counters in counted for turn in loop.turns(counters)]


def _having(turns: Turns, *indices: Index) -> Turns:
    """Return the turns that know the counters of indices; an index of others is told where it stands."""
    names = {name for index in indices for name, _ in index.terms}
    return [counters for counters in turns if names <= set(counters)]
