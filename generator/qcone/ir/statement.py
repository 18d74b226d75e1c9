"""Routines: named, typed blocks and a body of statements. Both languages are made of these parts.

A routine is in static single assignment: a value is an integer, defined once, by one `Operation` (or one
`Call`). Values defined inside a loop are not visible outside it; what a loop carries from one turn to the
next lives in the components of a block. So a body can be printed as C, run on arrays, counted and bounded
without any further analysis.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from fractions import Fraction
from types import MappingProxyType

from qcone.formats.fixed import Signal
from qcone.formats.floating import Floating, Truth
from qcone.ir.detail import Detail
from qcone.ir.index import FIRST, Index


class Shape(Enum):
    """What a block holds; the value is the number of its components."""

    SCALAR = 1
    VECTOR = 3
    QUATERNION = 4
    MATRIX = 9


SUFFIXES: Mapping[Shape, tuple[str, ...]] = MappingProxyType(
    {
        Shape.SCALAR: ("",),
        Shape.VECTOR: ("_x", "_y", "_z"),
        Shape.QUATERNION: ("_w", "_x", "_y", "_z"),
        Shape.MATRIX: tuple(f"_{row}{column}" for row in "123" for column in "123"),
    }
)
"""How the components of a block are called: q_w, phi_x, c_nb_31."""


class Role(Enum):
    """Where a block lives: kept between calls, handed in, handed out, constant, or inside one call."""

    STATE = "state"
    INPUT = "input"
    OUTPUT = "output"
    TABLE = "table"
    LOCAL = "local"


@dataclass(frozen=True)
class Block:
    """A named, typed block of components: `count` scalars, vectors, quaternions or matrices in a row.

    `unit` is for the reader; `norm` bounds the Euclidean norm of each of the `count` entries, where it is
    declared; `entries` are the constants of a table, in the machine language rounded, with `exact` what they were
    rounded from. `integer` marks a counter; `format` is that of its words in fixed point.
    """

    name: str
    shape: Shape
    role: Role
    count: int = 1
    unit: str = ""
    norm: Fraction | None = None
    entries: tuple[Fraction, ...] = ()
    exact: tuple[Fraction, ...] = ()
    integer: bool = False
    format: Signal | None = None

    @property
    def size(self) -> int:
        """Return the number of components."""
        return self.shape.value * self.count


@dataclass(frozen=True)
class Place:
    """One component of a block."""

    block: str
    index: Index = FIRST

    def __str__(self) -> str:
        """Return `block[index]`."""
        return f"{self.block}[{self.index}]"


@dataclass(frozen=True)
class Operation:
    """Define one value. `constant` belongs to a constant, `place` to a read; `format` is None in the real language.

    In the machine language `constant` is rounded to the format and `exact` is what it was rounded from. `detail`
    holds what some operations need beside their operands; `bound` is, in fixed point, what the value is proved not
    to exceed in size.
    """

    result: int
    op: Enum
    args: tuple[int, ...] = ()
    constant: Fraction | None = None
    place: Place | None = None
    step: int = 0
    format: Floating | Signal | Truth | None = None
    exact: Fraction | None = None
    detail: Detail | None = None
    bound: Fraction | None = None


@dataclass(frozen=True)
class Write:
    """Store a value in a component of a state, output or local block."""

    place: Place
    value: int
    step: int = 0


@dataclass(frozen=True)
class Loop:
    """Run the body for the counter from `first` to `last`, both included; the bounds may use outer counters."""

    counter: str
    first: Index
    last: Index
    body: tuple[Statement, ...]
    step: int = 0

    def turns(self, counters: Mapping[str, int]) -> range:
        """Return the counter's values, given those of the outer loops."""
        return range(self.first.at(counters), self.last.at(counters) + 1)


@dataclass(frozen=True)
class Call:
    """Call a routine of scalars: its input components are `args`, its output components become `results`."""

    routine: str
    args: tuple[int, ...]
    results: tuple[int, ...]
    step: int = 0


@dataclass(frozen=True)
class Advance:
    """Add one to an integer counter of the state."""

    place: Place
    step: int = 0


@dataclass(frozen=True)
class Choose:
    """Hand the call on: to the first routine whose limit is above the counter, else to `otherwise`."""

    place: Place
    cases: tuple[tuple[int, str], ...]
    otherwise: str
    step: int = 0


@dataclass(frozen=True)
class Ready:
    """Return 1 when an integer counter of the state has reached `limit`, else 0."""

    place: Place
    limit: int
    step: int = 0


Statement = Operation | Write | Loop | Call | Advance | Choose | Ready


@dataclass(frozen=True)
class Step:
    """A block of operations with a heading: the equation as text, and where it stands in its source."""

    text: str
    equation: str = ""


@dataclass(frozen=True)
class Group:
    """A vector, quaternion or scalar as one thing: how its component values arose from other groups.

    Range analysis needs it: |a x b| <= |a| |b| cannot be seen from components one by one. `kind` is the
    operation's name ("input", "sum", "difference", "scale", "cross", "dot", "product", "other"); `block` the one an
    input is read from.
    """

    kind: str
    values: tuple[int, ...]
    operands: tuple[int, ...] = ()
    factor: Fraction | None = None
    norm: Fraction | None = None
    block: str = ""


@dataclass(frozen=True)
class Routine:
    """A body over blocks. `names` gives the printed names of values; `callees` the routines it may call.

    A callee that gives one component may return it `by_value`, else its results go out through an array.
    """

    name: str
    blocks: tuple[Block, ...]
    body: tuple[Statement, ...]
    steps: tuple[Step, ...] = (Step(""),)
    names: Mapping[int, str] = field(default_factory=dict)
    groups: tuple[Group, ...] = ()
    callees: Mapping[str, Routine] = field(default_factory=dict)
    summary: str = ""
    by_value: bool = False

    def block(self, name: str) -> Block:
        """Return the block of that name; KeyError when there is none."""
        for block in self.blocks:
            if block.name == name:
                return block
        raise KeyError(name)

    def having(self, role: Role) -> tuple[Block, ...]:
        """Return the blocks of one role, in order."""
        return tuple(block for block in self.blocks if block.role is role)

    def with_body(self, body: tuple[Statement, ...]) -> Routine:
        """Return the same routine with another body."""
        return replace(self, body=body)


@dataclass(frozen=True)
class Program:
    """The routines of one design over one state, in the order they are printed."""

    name: str
    state: tuple[Block, ...]
    routines: tuple[Routine, ...]

    def routine(self, name: str) -> Routine:
        """Return the routine of that name; KeyError when there is none."""
        for routine in self.routines:
            if routine.name == name:
                return routine
        raise KeyError(name)

    def has(self, name: str) -> bool:
        """Tell whether there is a routine of that name."""
        return any(routine.name == name for routine in self.routines)


def reachable(routine: Routine) -> Iterator[Routine]:
    """Yield the routines that a routine calls, those they call first."""
    for callee in routine.callees.values():
        yield from reachable(callee)
        yield callee


def results(body: tuple[Statement, ...]) -> Iterator[int]:
    """Yield every value that the statements define, those inside loops too."""
    for statement in walk(body):
        if isinstance(statement, Operation):
            yield statement.result
        elif isinstance(statement, Call):
            yield from statement.results


def walk(body: tuple[Statement, ...]) -> Iterator[Statement]:
    """Yield every statement, those inside loops too, in order."""
    for statement in body:
        yield statement
        if isinstance(statement, Loop):
            yield from walk(statement.body)


def unused(routine: Routine) -> int:
    """Return a number above those of all values, of what was taken into sums among them."""
    known = [*results(routine.body), *routine.names]
    known += [value for group in routine.groups for value in group.values]
    return max(known, default=-1) + 1
