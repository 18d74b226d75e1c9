"""Legality of a routine: one broken rule at a time, and what is said of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import Enum
from fractions import Fraction

import pytest

from qcone.errors import UsageError
from qcone.formats.floating import FLOAT32
from qcone.ir.check import IllegalRoutineError, check, check_program
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import (
    Advance,
    Block,
    Call,
    Choose,
    Loop,
    Operation,
    Place,
    Program,
    Role,
    Routine,
    Shape,
    Statement,
    Write,
)

N, J = Index(0, (("n", 1),)), Index(0, (("j", 1),))
STATE = Block("s", Shape.VECTOR, Role.STATE)
BLOCKS = (
    STATE,
    Block("i", Shape.VECTOR, Role.INPUT),
    Block("o", Shape.SCALAR, Role.OUTPUT),
    Block("t", Shape.SCALAR, Role.TABLE, 2, entries=(Fraction(1), Fraction(2))),
    Block("r", Shape.SCALAR, Role.LOCAL, 4),
)
SCALE = Routine(
    "scale",
    (Block("arg1", Shape.SCALAR, Role.INPUT), Block("value", Shape.SCALAR, Role.OUTPUT)),
    (Operation(0, RealOp.READ, place=Place("arg1")), Write(Place("value"), 0)),
)


def read(result: int, block: str, index: Index | int = 0) -> Operation:
    place = Place(block, index if isinstance(index, Index) else Index(index))
    return Operation(result, RealOp.READ, place=place)


def constant(result: int) -> Operation:
    return Operation(result, RealOp.CONSTANT, constant=Fraction(1))


def add(result: int, *args: int) -> Operation:
    return Operation(result, RealOp.ADD, args)


def write(block: str, value: int, index: Index | int = 0) -> Write:
    return Write(Place(block, index if isinstance(index, Index) else Index(index)), value)


def loop(counter: str, first: Index | int, last: Index | int, *body: Statement) -> Loop:
    ends = [each if isinstance(each, Index) else Index(each) for each in (first, last)]
    return Loop(counter, ends[0], ends[1], body)


def routine(body: Sequence[Statement]) -> Routine:
    return Routine("broken", BLOCKS, tuple(body), callees={"scale": SCALE})


LEGAL: dict[str, list[Statement]] = {
    "nothing": [],
    "operations": [read(0, "s", 2), read(1, "i"), add(2, 0, 1), write("s", 2), write("o", 2)],
    "constant": [constant(0), write("r", 0, 3)],
    "call": [read(0, "i"), Call("scale", (0,), (1,)), write("o", 1)],
    "loop": [read(0, "i"), loop("n", 0, 3, read(1, "t"), add(2, 0, 1), write("r", 2, N))],
    "triangle": [loop("n", 1, 3, loop("j", 0, N - 1, read(0, "r", N - 1 - J), write("r", 0, N)))],
    "never run": [loop("n", 1, 0, read(0, "r", N + 90))],
    "guarded by an empty turn": [loop("n", 0, 3, loop("j", 1, N, read(0, "r", N - J), write("r", 0, J - 1)))],
    "one counter after another": [loop("n", 0, 3, constant(0), write("r", 0, N))] * 1
    + [loop("n", 0, 3, constant(1), write("r", 1, N))],
    "another component": [constant(0), write("s", 0, 1), read(1, "s")],
    "advance": [Advance(Place("s"))],
    "choose": [Choose(Place("s"), ((1, "first"),), "then")],
}


@pytest.mark.parametrize("name", LEGAL)
def test_legal(name: str) -> None:
    made = routine(LEGAL[name])
    assert check(made, RealOp) is made


ILLEGAL: dict[str, tuple[list[Statement], str]] = {
    "step": ([replace(constant(0), step=1)], "step 1 is not in the routine"),
    "step below": ([replace(constant(0), step=-1)], "step -1 is not in the routine"),
    "step of a write": ([constant(0), replace(write("o", 0), step=3)], "step 3 is not in the routine"),
    "language": ([Operation(0, MachineOp.LITERAL, constant=Fraction(1))], "is not of the language RealOp"),
    "few operands": ([constant(0), add(1, 0)], "add takes 2 operands, not 1"),
    "many operands": ([constant(0), Operation(1, RealOp.NEGATE, (0, 0))], "negate takes 1 operands, not 2"),
    "undefined operand": ([constant(0), add(1, 0, 7)], "value 7 is not defined here"),
    "own result": ([constant(0), add(1, 0, 1)], "value 1 is not defined here"),
    "undefined write": ([write("o", 5)], "value 5 is not defined here"),
    "undefined argument": ([Call("scale", (5,), (6,))], "value 5 is not defined here"),
    "out of a loop": ([loop("n", 0, 1, constant(0)), write("o", 0)], "value 0 is not defined here"),
    "twice": ([constant(0), constant(0)], "value 0 is defined twice"),
    "twice in loops": ([loop("n", 0, 1, constant(0)), loop("n", 0, 1, constant(0))], "value 0 is defined twice"),
    "twice by a call": ([constant(0), Call("scale", (0,), (0,))], "value 0 is defined twice"),
    "constant without number": ([Operation(0, RealOp.CONSTANT)], "a constant, and nothing else, holds a number"),
    "number elsewhere": (
        [constant(0), replace(add(1, 0, 0), constant=Fraction(1))],
        "a constant, and nothing else, holds a number",
    ),
    "read without place": ([Operation(0, RealOp.READ)], "a read, and nothing else, holds a place"),
    "place elsewhere": ([replace(constant(0), place=Place("i"))], "a read, and nothing else, holds a place"),
    "format": ([replace(constant(0), format=FLOAT32)], "a machine value has a format, a real value has none"),
    "no block to read": ([read(0, "z")], "there is no block 'z'"),
    "no block to write": ([constant(0), write("z", 0)], "there is no block 'z'"),
    "no block to advance": ([Advance(Place("z"))], "there is no block 'z'"),
    "below": ([read(0, "i", -1)], "i[-1] is outside the 3 components of 'i'"),
    "above": ([read(0, "i", 3)], "i[3] is outside the 3 components of 'i'"),
    "write above": ([constant(0), write("r", 0, 4)], "r[4] is outside the 4 components of 'r'"),
    "loop runs out": ([loop("n", 0, 4, constant(0), write("r", 0, N))], "r[n] is outside the 4 components of 'r'"),
    "loop runs under": ([loop("n", 0, 3, read(0, "r", N - 1))], "r[n - 1] is outside the 4 components of 'r'"),
    "last turn of a triangle": (
        [loop("n", 1, 3, loop("j", 0, N, read(0, "r", N - 1 - J)))],
        "r[n - j - 1] is outside the 4 components of 'r'",
    ),
    "no such loop": ([read(0, "r", N)], "index n: there is no loop over 'n' here"),
    "after the loop": ([loop("n", 0, 1), read(0, "r", N)], "index n: there is no loop over 'n' here"),
    "bound of no loop": ([loop("j", 0, N, constant(0))], "index n: there is no loop over 'n' here"),
    "start of no loop": ([loop("j", N, 3, constant(0))], "index n: there is no loop over 'n' here"),
    "counter in use": ([loop("n", 0, 1, loop("n", 0, 1))], "the counter 'n' is in use"),
    "write to input": ([constant(0), write("i", 0)], "'i' is read only"),
    "write to table": ([constant(0), write("t", 0)], "'t' is read only"),
    "read after write": (
        [constant(0), write("s", 0, 1), read(1, "s"), read(2, "s", 1)],
        "the state 's' is read after it was written",
    ),
    "bound of no loop in a loop": ([loop("j", 0, 1, loop("k", 0, N, constant(0)))], "there is no loop over 'n' here"),
    "read in the next turn": (
        [loop("n", 0, 1, read(0, "s"), write("s", 0, N))],
        "the state 's' is read after it was written",
    ),
    "no routine": ([Call("other", (), ())], "there is no routine 'other'"),
    "arguments": ([Call("scale", (), (0,))], "'scale' takes 1 components and gives 1"),
    "results": ([constant(0), Call("scale", (0,), ())], "'scale' takes 1 components and gives 1"),
    "choice and more": (
        [Choose(Place("s"), (), "then"), Advance(Place("s"))],
        "a routine that hands its call on does nothing else",
    ),
    "choice in a loop": ([loop("n", 0, 1, Choose(Place("s"), (), "then"))], "hands its call on does nothing else"),
}


@pytest.mark.parametrize("name", ILLEGAL)
def test_illegal(name: str) -> None:
    body, why = ILLEGAL[name]
    with pytest.raises(IllegalRoutineError) as caught:
        check(routine(body), RealOp)
    assert str(caught.value).startswith("routine 'broken': ")
    assert str(caught.value).endswith(why)
    assert caught.value.exit_code == 70


def typed(number: object) -> Routine:
    operation = Operation(0, MachineOp.LITERAL, constant=Fraction(1), format=number)  # type: ignore[arg-type]
    return routine([operation])


def test_machine_values_have_a_format() -> None:
    plain = replace(typed(FLOAT32), callees={})
    assert check(plain, MachineOp) is plain
    with pytest.raises(IllegalRoutineError, match="a machine value has a format"):
        check(replace(typed(None), callees={}), MachineOp)


@pytest.mark.parametrize("language", [RealOp, MachineOp])
def test_every_operation_belongs_to_one_language(language: type[Enum]) -> None:
    other = MachineOp if language is RealOp else RealOp
    for op in other:
        with pytest.raises(IllegalRoutineError, match=f"is not of the language {language.__name__}"):
            check(routine([Operation(0, op)]), language)


def test_what_a_routine_calls_is_checked_too() -> None:
    broken = replace(SCALE, body=(write("value", 9),))
    with pytest.raises(IllegalRoutineError, match=r"^routine 'scale': .* value 9 is not defined here$"):
        check(Routine("caller", (), (), callees={"scale": broken}), RealOp)


def test_the_state_is_the_same_everywhere() -> None:
    one = Routine("one", (STATE,), ())
    program = Program("p", (STATE,), (one,))
    assert check_program(program, RealOp) is program
    other = replace(STATE, shape=Shape.QUATERNION)
    with pytest.raises(IllegalRoutineError, match=r"^two: the state has no block Block\(name='s', shape=.*QUATERNION"):
        check_program(replace(program, routines=(one, Routine("two", (other,), ()))), RealOp)


def test_a_program_checks_its_routines() -> None:
    with pytest.raises(IllegalRoutineError, match=r"^routine 'broken'"):
        check_program(Program("p", (STATE,), (routine([read(0, "i", 3)]),)), RealOp)


def test_two_functions_of_one_name() -> None:
    """Two routines may share a subroutine; another one under its name, or under a routine's, may not be emitted."""
    other = replace(SCALE, summary="another")
    first = Routine("first", (), (), callees={"scale": SCALE})
    again = Routine("again", (), (), callees={"scale": replace(SCALE)})
    assert check_program(Program("p", (), (first, again)), RealOp)
    for clash in (replace(again, callees={"scale": other}), Routine("scale", (), ())):
        with pytest.raises(UsageError, match=r"^the subroutine 'scale' has the name of another function: rename it$"):
            check_program(Program("p", (), (first, clash)), RealOp)
