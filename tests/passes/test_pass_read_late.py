"""State read late: before the first operation that needs a component of the block, in the order it was read in."""

from __future__ import annotations

from qcone.formats.fixed import Signal
from qcone.ir.check import check
from qcone.ir.detail import Shift
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Choose, Operation, Place, Role, Routine, Shape, Statement, Write
from qcone.passes.read_late import read_late

WORD, HALF = Signal(32, 20), Signal(32, 19)
BLOCKS = (
    Block("q", Shape.SCALAR, Role.STATE, 2, format=WORD),
    Block("rate", Shape.SCALAR, Role.STATE, 1, format=WORD),
    Block("given", Shape.SCALAR, Role.INPUT, 2, format=WORD),
)


def read(result: int, block: str, index: int = 0) -> Operation:
    return Operation(result, MachineOp.READ, place=Place(block, Index(index)), format=WORD)


def add(result: int, *args: int) -> Operation:
    return Operation(result, MachineOp.ADD, args, format=WORD)


def rounded(result: int, arg: int) -> Operation:
    return Operation(result, MachineOp.SHIFT_RIGHT, (arg,), format=HALF, detail=Shift(1, "up", 32))


def write(block: str, value: int, index: int = 0) -> Write:
    return Write(Place(block, Index(index)), value)


def late(*body: Statement) -> list[Statement]:
    """Return the statements as they then stand; all of them, each once."""
    made = read_late(check(Routine("update", BLOCKS, body), MachineOp))
    assert set(made.body) == set(body)
    assert len(made.body) == len(body)
    return list(check(made, MachineOp).body)


def test_a_block_is_read_where_a_component_is_first_needed() -> None:
    q = [read(0, "q"), read(1, "q", 1)]
    given = [read(2, "given"), read(3, "given", 1)]
    total, used = add(4, 2, 3), add(5, 4, 1)
    assert late(*q, *given, total, used) == [*given, total, *q, used]


def test_what_is_made_of_a_component_alone_is_read_with_it() -> None:
    q = [read(0, "q"), rounded(1, 0), read(2, "q", 1), rounded(3, 2)]
    given, used = read(4, "given"), add(5, 4, 3)
    assert late(*q, given, used) == [given, *q, used]


def test_blocks_are_read_one_by_one() -> None:
    q, rate, given = read(0, "q"), read(1, "rate"), read(2, "given")
    first, second = add(3, 2, 1), add(4, 3, 0)
    assert late(q, rate, given, first, second) == [given, rate, first, q, second]


def test_a_block_is_read_before_it_is_written() -> None:
    q = [read(0, "q"), read(1, "q", 1)]
    given = read(2, "given")
    stored, used = write("q", 2), add(3, 1, 2)
    assert late(*q, given, stored, used) == [given, *q, stored, used]
    assert late(*q, given, write("rate", 2), used) == [given, write("rate", 2), *q, used]
    assert late(q[0], given, write("rate", 0)) == [given, q[0], write("rate", 0)]


def test_what_nothing_needs_is_read_last() -> None:
    q, given = read(0, "q"), read(1, "given")
    assert late(q, given) == [given, q]


def test_a_call_that_is_handed_on_is_left_alone() -> None:
    choice = Choose(Place("rate"), (), "steady")
    assert late(choice) == [choice]
