"""From the real language to machine operations of a float: one for one, constants rounded once and correctly."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from real_routines import F, constants, written

from qcone.errors import UsageError
from qcone.formats.floating import FLOAT32, FLOAT64, FLOATING, Floating
from qcone.ir.blocks import number, sqrt
from qcone.ir.check import check
from qcone.ir.indexed import history, loop, table
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Program, Role, Routine, walk
from qcone.ir.subroutine import subroutine
from qcone.passes.lower_float import ONE_FOR_ONE, lower_float, lower_program

FORMATS = [FLOAT32, FLOAT64]


def lowered(value: Fraction, kind: Floating) -> Operation:
    """Return the literal that a constant becomes."""
    routine = lower_float(written(lambda v, x, s: number(value, x)), kind)
    (literal,) = (each for each in routine.body if isinstance(each, Operation) and each.constant is not None)
    return literal


@given(st.fractions(min_value=-(10**6), max_value=10**6, max_denominator=10**12))
def test_constants_are_rounded_once(value: Fraction) -> None:
    """NumPy's float64 of a fraction is the correctly rounded quotient; float32 has 29 bits to spare below it."""
    wide = lowered(value, FLOAT64)
    assert wide.op is MachineOp.LITERAL
    assert wide.constant == Fraction(float(value))
    assert wide.exact == value


@given(st.integers(-(2**53), 2**53), st.integers(-60, 20))
def test_constants_of_float32(whole: int, power: int) -> None:
    """A float64 is rounded to float32 by the processor, once."""
    value = Fraction(whole) * Fraction(2) ** power
    narrow = lowered(value, FLOAT32)
    assert narrow.constant == Fraction(float(np.float32(float(value))))
    assert narrow.exact == value


def test_float32_is_not_rounded_by_way_of_float64() -> None:
    """Halfway between two float32 numbers, and a little more: rounded to float64 first, the little is lost."""
    value = 1 + Fraction(1, 2**24) + Fraction(1, 2**60)
    assert lowered(value, FLOAT32).constant == 1 + Fraction(1, 2**23)
    assert Fraction(float(np.float32(float(value)))) == 1


@pytest.mark.parametrize("kind", FORMATS)
def test_operations_one_for_one(kind: Floating) -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        return (x + s) * (x - s) / (F(1, 3) * -x)

    routine = written(author)
    machine = check(lower_float(routine, kind), MachineOp)
    pairs = list(zip(routine.body, machine.body, strict=True))
    for before, after in pairs:
        if isinstance(before, Operation) and isinstance(after, Operation):
            assert (after.result, after.args, after.place, after.step) == (
                before.result,
                before.args,
                before.place,
                before.step,
            )
            assert after.format is kind
            assert after.op.value == ("literal" if before.op is RealOp.CONSTANT else before.op.value)
        else:
            assert before == after


def test_what_has_a_machine_operation() -> None:
    """Everything but constants, and what firmware does without."""
    functions = {RealOp.SQUARE_ROOT, RealOp.SINE, RealOp.COSINE, RealOp.ARCSINE, RealOp.ARCTANGENT_2}
    of_fixed_point = {RealOp.SUM, RealOp.WIDE, RealOp.CARRY, RealOp.CLAMP}
    without = {RealOp.CONSTANT, RealOp.LESS, *functions, *of_fixed_point}
    assert set(ONE_FOR_ONE) == set(RealOp) - without
    assert ONE_FOR_ONE[RealOp.ACCUMULATE] is MachineOp.ADD


@pytest.mark.parametrize("op", [RealOp.SQUARE_ROOT, RealOp.SINE, RealOp.COSINE])
def test_no_library_function(op: RealOp) -> None:
    routine = written(lambda v, x, s: sqrt(x))
    body = tuple(
        replace(each, op=op) if isinstance(each, Operation) and each.op is RealOp.SQUARE_ROOT else each
        for each in routine.body
    )
    with pytest.raises(UsageError) as caught:
        lower_float(routine.with_body(body), FLOAT32)
    assert str(caught.value) == (
        f"the routine 'written' takes a {op.value.replace('_', ' ')}, which emitted C does without: "
        'set form = "factored"'
    )


def looping() -> Routine:
    @subroutine
    def third(a):  # type: ignore[no-untyped-def]
        return F(1, 3) * a

    def author(v: Any, x: Any, s: Any) -> Any:
        weight = table("weight", x, [F(1, 3), F(-1, 10), 0])
        r = history("r", x, 3)
        r[0] = x
        for n in loop("n", x, 1, 2):
            r[n] = weight[n] * third(r[n - 1])
        return r[2]

    return written(author, rolled=True)


@pytest.mark.parametrize("kind", FORMATS)
def test_tables_loops_and_subroutines(kind: Floating) -> None:
    routine = check(lower_float(looping(), kind), MachineOp)
    (weights,) = routine.having(Role.TABLE)
    to = np.float32 if kind is FLOAT32 else np.float64
    assert weights.entries == tuple(Fraction(float(to(value))) for value in (1 / 3, -0.1, 0))
    assert {each.format for each in walk(routine.body) if isinstance(each, Operation)} == {kind}
    assert constants(routine.callees["third"]) == [Fraction(float(to(1 / 3)))]


@pytest.mark.parametrize("value", [F(10) ** 39, -(F(10) ** 39)])
def test_beyond_the_range(value: Fraction) -> None:
    routine = written(lambda v, x, s: value * x)
    with pytest.raises(
        UsageError, match=f"^the routine 'written': the constant {value} is beyond the range of float32"
    ):
        lower_float(routine, FLOAT32)
    assert lower_float(routine, FLOAT64)


def test_a_table_beyond_the_range() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        weight = table("weight", x, [F(10) ** 39])
        r = history("r", x, 1)
        for n in loop("n", x, 0, 0):
            r[n] = weight[n] * x
        return r[0]

    with pytest.raises(UsageError, match="is beyond the range of float32: scale the equation"):
        lower_float(written(author, rolled=True), FLOAT32)


def test_every_routine_of_a_program() -> None:
    routine = written(lambda v, x, s: x + s)
    program = Program("p", routine.having(Role.STATE), (routine, replace(routine, name="again")))
    for made in lower_program(program, FLOATING["float32"]).routines:
        assert check(made, MachineOp) == replace(lower_float(routine, FLOAT32), name=made.name)
