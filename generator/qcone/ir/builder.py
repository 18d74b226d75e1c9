"""Builder: writes one routine of the real language, operation by operation, as its author calls for them.

It shares nothing behind the author's back: writing `a * b` twice makes two operations. Only the reads of
an input component are made once, since reading is not an operation of the paper.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.ir.detail import Limits
from qcone.ir.identifier import is_identifier
from qcone.ir.index import Index
from qcone.ir.operations import RealOp
from qcone.ir.statement import (
    SUFFIXES,
    Block,
    Call,
    Group,
    Loop,
    Operation,
    Place,
    Role,
    Routine,
    Shape,
    Statement,
    Step,
    Write,
    results,
)
from qcone.ir.writing import Writing

Heading = Callable[[], Step | None]


class Builder:
    """Collect the statements of one routine.

    `writing` says how the papers' shorthand is written out, loops among it. `heading` is asked, for
    operations outside any named step, which step they belong to: the author's own source line.
    """

    def __init__(self, name: str, blocks: Sequence[Block], writing: Writing, heading: Heading | None = None):
        """Begin a routine over `blocks`."""
        self.name = name
        self.blocks = list(blocks)
        self.writing = writing
        self.steps: list[Step] = []
        self.names: dict[int, str] = {}
        self.groups: list[Group] = []
        self.callees: dict[str, Routine] = {}
        self.subroutines: dict[str, Routine] = {}
        """Every routine made on the way, those that callees call among them: a name belongs to one of them."""
        self._heading = heading
        self._scopes: list[list[Statement]] = [[]]
        self._counters: list[str] = []
        self._left: set[int] = set()
        self._reads: dict[Place, int] = {}
        self._next = 0
        self._open: Step | None = None
        self._pending: list[tuple[list[Statement], int]] = []

    # -- values ---------------------------------------------------------------------------------------

    def constant(self, value: Fraction) -> int:
        """Write an exact constant."""
        return self._define(RealOp.CONSTANT, (), constant=value)

    def emit(self, op: RealOp, *args: int) -> int:
        """Write one operation and return its value."""
        self._refuse_left(args)
        return self._define(op, args)

    def clamp(self, value: int, low: Fraction, high: Fraction) -> int:
        """Keep a value between two constants."""
        self._refuse_left((value,))
        return self._define(RealOp.CLAMP, (value,), detail=Limits(low, high))

    def read(self, block: Block, component: Index | int) -> int:
        """Read a component; an input or state component is read once a routine, at the place of its first use."""
        index = component if isinstance(component, Index) else Index(component)
        place = Place(block.name, index)
        once = block.role in (Role.INPUT, Role.STATE) and not index.terms and len(self._scopes) == 1
        if once and place in self._reads:
            return self._reads[place]
        value = self._define(RealOp.READ, (), place=place)
        if not index.terms:
            entry, part = divmod(index.constant, block.shape.value)
            number = str(entry + 1) if block.count > 1 else ""
            self.names.setdefault(value, f"{block.name}{number}{SUFFIXES[block.shape][part]}")
        if once:
            self._reads[place] = value
        return value

    def write(self, block: Block, component: Index | int, value: int) -> None:
        """Store a value in a component of a block."""
        self._refuse_left((value,))
        index = component if isinstance(component, Index) else Index(component)
        self._append(Write(Place(block.name, index), value, self._step()))

    def call(self, routine: Routine, args: Sequence[int]) -> tuple[int, ...]:
        """Call a routine of scalars and return its output components."""
        self._refuse_left(args)
        size = sum(block.size for block in routine.having(Role.OUTPUT))
        results = tuple(range(self._next, self._next + size))
        self._next += size
        self.callees[routine.name] = routine
        self._append(Call(routine.name, tuple(args), results, self._step()))
        return results

    def refuse_open_loop(self) -> None:
        """Raise UsageError if the author's function, which has returned, left a rolled loop half way."""
        if self._counters:
            raise UsageError(
                f"the loop over '{self._counters[-1]}' is left by break or return; a rolled loop runs to its end: "
                "give it other bounds"
            )

    def loop(self, counter: str, first: Index, last: Index) -> Iterator[Index]:
        """Open a loop, hand out its counter once, and close it when the author's body has run."""
        if counter in self._counters or any(block.name == counter for block in self.blocks):
            raise UsageError(f"the loop counter '{counter}' has the name of another counter or block: rename it")
        _refuse_odd(counter, "loop counter")
        self._counters.append(counter)
        self._scopes.append([])
        yield Index(0, ((counter, 1),))
        inner = self._scopes.pop()
        self._counters.pop()
        self._pending = [(scope, position) for scope, position in self._pending if scope is not inner]
        body = tuple(inner)
        self._left.update(results(body))
        self._append(Loop(counter, first, last, body, self._step()))

    def group(
        self,
        kind: str,
        values: Sequence[int],
        operands: Sequence[int] = (),
        factor: Fraction | None = None,
        norm: Fraction | None = None,
    ) -> int:
        """Record that these values are one vector, quaternion or scalar; return the group's number."""
        self.groups.append(Group(kind, tuple(values), tuple(operands), factor, norm))
        return len(self.groups) - 1

    def declare(self, name: str, shape: Shape, count: int, role: Role, entries: Sequence[Fraction] = ()) -> Block:
        """Add a local history or a table of constants to the routine."""
        if any(block.name == name for block in self.blocks):
            raise UsageError(f"{self.name}: the block '{name}' is declared twice; give each history its own name")
        _refuse_odd(name, role.value if role is Role.TABLE else "history")
        block = Block(name, shape, role, count, entries=tuple(entries))
        self.blocks.append(block)
        return block

    def is_state(self, values: Sequence[int]) -> bool:
        """Tell whether these values are the attitude as it was read."""
        first = self.blocks[0]
        return all(self._reads.get(Place(first.name, Index(k))) == value for k, value in enumerate(values))

    # -- steps and names ------------------------------------------------------------------------------

    def label(self, step: Step) -> None:
        """Close a named step: everything written since the last one belongs to it."""
        number = self._number(step)
        for scope, position in self._pending:
            statement = scope[position]
            scope[position] = _with_step(statement, number)
        self._pending.clear()

    def settle(self, but_last: bool = False) -> None:
        """Leave what has a heading of its own under it: the next named step covers only what is written from here on.

        With `but_last`, that step covers the statements under the latest heading too.
        """
        last = self._heading_of(self._pending[-1]) if self._pending and but_last else Step("")
        self._pending = [each for each in self._pending if self._heading_of(each) in (last, Step(""))]

    def name_values(self, name: str, shape: Shape, values: Sequence[int]) -> None:
        """Name the components of a block; a value that has a name keeps it."""
        for value, suffix in zip(values, SUFFIXES[shape], strict=True):
            self.names.setdefault(value, name + suffix)

    def routine(self, summary: str = "") -> Routine:
        """Return what was written."""
        steps = tuple(self.steps) or (Step(""),)
        body = tuple(self._scopes[0])
        blocks = tuple(self.blocks)
        return Routine(
            self.name, blocks, body, steps, dict(self.names), tuple(self.groups), dict(self.callees), summary
        )

    # -- inside ---------------------------------------------------------------------------------------

    def _define(
        self,
        op: RealOp,
        args: tuple[int, ...],
        constant: Fraction | None = None,
        place: Place | None = None,
        detail: Limits | None = None,
    ) -> int:
        value = self._next
        self._next += 1
        self._append(Operation(value, op, args, constant, place, self._step(), detail=detail))
        return value

    def _refuse_left(self, values: Sequence[int]) -> None:
        if not self._left.isdisjoint(values):
            raise UsageError("what is calculated inside a rolled loop is used outside it: keep it in a history")

    def _append(self, statement: Statement) -> None:
        scope = self._scopes[-1]
        scope.append(statement)
        self._pending.append((scope, len(scope) - 1))

    def _step(self) -> int:
        return self._number((self._heading() if self._heading else None) or Step(""))

    def _heading_of(self, written: tuple[list[Statement], int]) -> Step:
        """Return the step of a written statement; that of its first statement for a loop, which has none itself."""
        statement = written[0][written[1]]
        while isinstance(statement, Loop) and statement.body:
            statement = statement.body[0]
        return self.steps[statement.step]

    def _number(self, step: Step) -> int:
        if step not in self.steps:
            self.steps.append(step)
        return self.steps.index(step)


def _refuse_odd(name: str, what: str) -> None:
    if not is_identifier(name):
        raise UsageError(
            f"the {what} '{name}' cannot be called so in C: use a letter, then letters, digits and underscores, "
            "and no word of the language"
        )


def _with_step(statement: Statement, number: int) -> Statement:
    """Move a statement to another step, and with it what stands inside it under the same heading."""
    if isinstance(statement, Loop):
        body = tuple(_with_step(inner, number) if inner.step == statement.step else inner for inner in statement.body)
        return replace(statement, body=body, step=number)
    return replace(statement, step=number)
