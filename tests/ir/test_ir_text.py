"""A routine as text: every kind of statement, exactly, and the same every time."""

from __future__ import annotations

from fractions import Fraction

from qcone.formats.floating import FLOAT32
from qcone.ir.blocks import cross, of
from qcone.ir.builder import Builder
from qcone.ir.index import Index
from qcone.ir.indexed import history, loop, table
from qcone.ir.labels import named, step
from qcone.ir.statement import Advance, Block, Choose, Place, Program, Role, Routine, Shape, Step
from qcone.ir.subroutine import subroutine
from qcone.ir.text import dump, dump_program
from qcone.ir.writing import Writing
from qcone.passes.lower_float import lower_float

F = Fraction


def example() -> Routine:
    """Write w[n] = k[n] (v x w[n-1]), the cross product a subroutine, and give w[2]."""

    @subroutine
    def turned(a, b):  # type: ignore[no-untyped-def]
        """Give a x b."""
        return cross(a, b)

    given = Block("v", Shape.VECTOR, Role.INPUT)
    out = Block("o", Shape.VECTOR, Role.OUTPUT)
    builder = Builder("example", (given, out), Writing(rolled=True))
    v = of(builder, Shape.VECTOR, [builder.read(given, part) for part in range(3)])
    w, k = history("w", v, 3), table("k", v, [0, F(1, 3), F(-1, 5)])
    w[0] = step("half = v/2", "paper (1)", F(1, 2) * v)
    for n in loop("n", v, 1, 2):
        w[n] = k[n] * turned(v, w[n - 1])
    for part, value in enumerate(named("last", w[2]).values):
        builder.write(out, part, value)
    return builder.routine()


GOLDEN = """\
routine example
  input v: vector
  output o: vector
  local w: 3 x vector
  table k: 3 x scalar
  # half = v/2  [paper (1)]
  v_x = read v[0]
  v_y = read v[1]
  v_z = read v[2]
  %3 = constant 1/2
  half_x = multiply %3, v_x
  %5 = constant 1/2
  half_y = multiply %5, v_y
  %7 = constant 1/2
  half_z = multiply %7, v_z
  w[0] := half_x
  w[1] := half_y
  w[2] := half_z
  for n in 1 .. 2
    %9 = read k[n]
    %10 = read w[3 * n - 3]
    %11 = read w[3 * n - 2]
    %12 = read w[3 * n - 1]
    %13, %14, %15 = call turned(v_x, v_y, v_z, %10, %11, %12)
    %16 = multiply %9, %13
    %17 = multiply %9, %14
    %18 = multiply %9, %15
    w[3 * n] := %16
    w[3 * n + 1] := %17
    w[3 * n + 2] := %18
  w3_x = read w[6]
  w3_y = read w[7]
  w3_z = read w[8]
  o[0] := w3_x
  o[1] := w3_y
  o[2] := w3_z

routine turned
  input arg1: vector
  input arg2: vector
  output value: vector
  arg1_x = read arg1[0]
  arg1_y = read arg1[1]
  arg1_z = read arg1[2]
  arg2_x = read arg2[0]
  arg2_y = read arg2[1]
  arg2_z = read arg2[2]
  %6 = multiply arg1_y, arg2_z
  %7 = multiply arg1_z, arg2_y
  %8 = subtract %6, %7
  %9 = multiply arg1_z, arg2_x
  %10 = multiply arg1_x, arg2_z
  %11 = subtract %9, %10
  %12 = multiply arg1_x, arg2_y
  %13 = multiply arg1_y, arg2_x
  %14 = subtract %12, %13
  value[0] := %8
  value[1] := %11
  value[2] := %14
"""


def test_golden() -> None:
    assert dump(example()) == GOLDEN


def test_stable() -> None:
    assert dump(example()) == dump(example())


def test_a_machine_routine_says_its_format() -> None:
    text = dump(lower_float(example(), FLOAT32))
    assert "  %3 = literal 1/2 : float32\n" in text
    assert "  half_x = multiply %3, v_x : float32\n" in text
    assert all(
        " : float32" in line
        for line in text.splitlines()
        if " = " in line and "call" not in line[:25] and "#" not in line
    )


def test_choice_and_counter() -> None:
    count = Block("count", Shape.SCALAR, Role.STATE, integer=True)
    place = Place("count", Index())
    choice = Routine("update", (count,), (Choose(place, ((2, "start_up"), (4, "more")), "steady"),), (Step("begin"),))
    counting = Routine("start_up", (count,), (Advance(place),))
    assert dump_program(Program("p", (count,), (choice, counting))) == (
        "routine update\n"
        "  state count: scalar\n"
        "  # begin\n"
        "  choose by count[0]: below 2: start_up; below 4: more; otherwise: steady\n"
        "\n"
        "routine start_up\n"
        "  state count: scalar\n"
        "  count[0] := count[0] + 1\n"
    )
