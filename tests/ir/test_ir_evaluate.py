"""What a routine means, over exact fractions and over high-precision floats."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from qcone.errors import UsageError
from qcone.ir.blocks import cross, number, of, sqrt
from qcone.ir.builder import Builder
from qcone.ir.evaluate import EXACT, Numbers, agree, evaluate
from qcone.ir.index import Index
from qcone.ir.indexed import history, loop, table
from qcone.ir.labels import step
from qcone.ir.operations import RealOp
from qcone.ir.statement import Advance, Block, Choose, Operation, Place, Role, Routine, Shape, Write, walk
from qcone.ir.subroutine import subroutine
from qcone.ir.update import exp
from qcone.ir.writing import AS_WRITTEN, Writing

F = Fraction
X = Block("x", Shape.SCALAR, Role.INPUT)
Y = Block("y", Shape.SCALAR, Role.INPUT)
S = Block("s", Shape.SCALAR, Role.STATE, 2)
O = Block("o", Shape.SCALAR, Role.OUTPUT)  # noqa: E741  an output
MP = Numbers(lambda value: mpmath.mpf(value.numerator) / value.denominator, mpmath.sqrt, mpmath.sin, mpmath.cos)


def of_two(write: Callable[[Any, Any], Any], rolled: bool = False) -> Routine:
    """Return the routine that gives a scalar of the scalars x and y."""
    builder = Builder("two", (X, Y, O), Writing(rolled=rolled))
    x, y = (of(builder, Shape.SCALAR, [builder.read(block, 0)]) for block in (X, Y))
    builder.write(O, 0, write(x, y).value)
    return builder.routine()


def value(routine: Routine, x: Any, y: Any, numbers: Numbers = EXACT) -> Any:
    return evaluate(routine, {"x": [x], "y": [y]}, numbers).blocks["o"][0]


@pytest.mark.parametrize(
    ("write", "expected"),
    [
        (lambda x, y: x + y, F(3, 5) + F(-2, 7)),
        (lambda x, y: x - y, F(3, 5) - F(-2, 7)),
        (lambda x, y: x * y, F(3, 5) * F(-2, 7)),
        (lambda x, y: x / y, F(3, 5) / F(-2, 7)),
        (lambda x, y: -x, F(-3, 5)),
        (lambda x, y: F(1, 3) * x - 1, F(-4, 5)),
        (lambda x, y: number(F(9, 20), x), F(9, 20)),
    ],
)
def test_exact(write: Callable[[Any, Any], Any], expected: Fraction) -> None:
    found = value(of_two(write), F(3, 5), F(-2, 7))
    assert found == expected
    assert isinstance(found, Fraction)


def test_accumulate_is_an_addition() -> None:
    body = (
        Operation(0, RealOp.READ, place=Place("x")),
        Operation(1, RealOp.READ, place=Place("y")),
        Operation(2, RealOp.ACCUMULATE, (0, 1)),
        Write(Place("o"), 2),
    )
    assert value(Routine("sum", (X, Y, O), body), F(1, 3), F(1, 4)) == F(7, 12)


def test_high_precision() -> None:
    root = of_two(lambda x, y: sqrt(x * x + y * y))
    with mpmath.workdps(40):
        assert abs(value(root, mpmath.mpf(1), mpmath.mpf(2), MP) - mpmath.sqrt(5)) < mpmath.mpf(10) ** -38
        third = of_two(lambda x, y: F(1, 3) * x)
        assert abs(value(third, mpmath.mpf(1), mpmath.mpf(0), MP) * 3 - 1) < mpmath.mpf(10) ** -38


def test_the_exponential_as_written() -> None:
    """[cos(|phi|/2), sin(|phi|/2) phi/|phi|] at 40 digits."""
    given, out = Block("phi", Shape.VECTOR, Role.INPUT), Block("r", Shape.QUATERNION, Role.OUTPUT)
    builder = Builder("exp", (given, out), AS_WRITTEN)
    result = exp(of(builder, Shape.VECTOR, [builder.read(given, part) for part in range(3)]))
    for part, each in enumerate(result.values):  # type: ignore[union-attr]
        builder.write(out, part, each)
    with mpmath.workdps(40):
        phi = [mpmath.mpf(k) / 10 for k in (1, -2, 2)]
        found = evaluate(builder.routine(), {"phi": phi}, MP).blocks["r"]
        half = mpmath.mpf(3) / 20
        expected = [mpmath.cos(half), *(mpmath.sin(half) * each / (2 * half) for each in phi)]
        assert max(abs(a - b) for a, b in zip(found, expected, strict=True)) < mpmath.mpf(10) ** -38


@pytest.mark.parametrize("op", [RealOp.SQUARE_ROOT, RealOp.SINE, RealOp.COSINE])
def test_no_root_or_angle_in_exact_arithmetic(op: RealOp) -> None:
    body = (Operation(0, RealOp.READ, place=Place("x")), Operation(1, op, (0,)), Write(Place("o"), 1))
    with pytest.raises(ArithmeticError, match=f"^{op.value} has no meaning in exact arithmetic$"):
        value(Routine("r", (X, Y, O), body), F(1), F(1))


def test_a_block_that_is_not_given() -> None:
    with pytest.raises(KeyError, match="y"):
        evaluate(of_two(lambda x, y: x + y), {"x": [F(1)]})


def test_names_and_vectors() -> None:
    given = Block("v", Shape.VECTOR, Role.INPUT, 2)
    builder = Builder("named", (given,), Writing())
    a, b = (of(builder, Shape.VECTOR, [builder.read(given, 3 * k + part) for part in range(3)]) for k in range(2))
    step("c = a x b", "", cross(a, b))
    found = evaluate(builder.routine(), {"v": [F(k) for k in (1, 2, 3, 5, 7, 11)]})
    assert found.vector("c") == (2 * 11 - 3 * 7, 3 * 5 - 1 * 11, 1 * 7 - 2 * 5)
    assert found.named["v2_z"] == 11


def test_the_state_changes_at_the_end() -> None:
    body = (
        Operation(0, RealOp.READ, place=Place("s")),
        Write(Place("s", Index(1)), 0),
        Operation(1, RealOp.READ, place=Place("s", Index(1))),
        Write(Place("s"), 1),
    )
    assert evaluate(Routine("swap", (S,), body), {"s": [F(1), F(2)]}).blocks["s"] == [2, 1]


def test_a_counter_of_the_state() -> None:
    counting = Routine("count", (S,), (Advance(Place("s", Index(1))),))
    assert evaluate(counting, {"s": [F(1), F(2)]}).blocks["s"] == [1, 3]


def test_a_choice_is_not_evaluated() -> None:
    with pytest.raises(ArithmeticError, match=r"^update only hands its call on; evaluate the routine it chooses$"):
        evaluate(Routine("update", (S,), (Choose(Place("s"), (), "steady"),)), {"s": [F(0), F(0)]})


# -- loops, histories, tables, calls ------------------------------------------------------------------------


def powers(x: Any, y: Any) -> Any:
    """Write sum_n (1/n) sum_{j < n} x^j y^(n-1-j), n = 1..4."""
    inverse = table("inverse", x, [0, 1, F(1, 2), F(1, 3), F(1, 4)])
    xs, ys, total = history("xs", x, 4), history("ys", x, 4), history("total", x, 5)
    part = history("part", x, 1)
    xs[0] = ys[0] = number(1, x)
    total[0] = number(0, x)
    for n in loop("n", x, 1, 3):
        xs[n] = x * xs[n - 1]
        ys[n] = y * ys[n - 1]
    for n in loop("n", x, 1, 4):
        part[0] = number(0, x)
        for j in loop("j", x, 0, n - 1):
            part[0] = part[0] + xs[j] * ys[n - 1 - j]
        total[n] = total[n - 1] + inverse[n] * part[0]
    return total[4]


@pytest.mark.parametrize("rolled", [True, False])
def test_nested_loops(rolled: bool) -> None:
    x, y = F(2, 3), F(-5, 7)
    expected = sum(F(1, n) * sum(x**j * y ** (n - 1 - j) for j in range(n)) for n in range(1, 5))
    assert value(of_two(powers, rolled), x, y) == expected


def test_a_rolled_body_is_written_once() -> None:
    rolled, written_out = (of_two(powers, each) for each in (True, False))
    products = [
        sum(isinstance(each, Operation) and each.op is RealOp.MULTIPLY for each in walk(routine.body))
        for routine in (rolled, written_out)
    ]
    assert products == [2 + 1 + 1, 3 * 2 + (1 + 2 + 3 + 4) + 4]


def test_calls() -> None:
    @subroutine
    def mean(a, b):  # type: ignore[no-untyped-def]
        return F(1, 2) * (a + b)

    assert value(of_two(lambda x, y: mean(mean(x, y), y)), F(1), F(0)) == F(1, 4)


def test_what_was_not_written_is_not_read() -> None:
    body = (Operation(0, RealOp.READ, place=Place("r", Index(1))),)
    routine = Routine("r", (Block("r", Shape.SCALAR, Role.LOCAL, 2),), body)
    with pytest.raises(UsageError, match=r"^r\[1\] is read before it is written"):
        evaluate(routine, {})


# -- agreement ----------------------------------------------------------------------------------------------


def test_two_forms_of_one_function_agree() -> None:
    assert agree(of_two(lambda x, y: (x + y) * (x - y)), of_two(lambda x, y: x * x - y * y))
    assert agree(of_two(powers, True), of_two(powers, False))


@pytest.mark.parametrize(
    "other",
    [
        lambda x, y: x * x + y * y,
        lambda x, y: y * y - x * x,
        lambda x, y: x * x - y * y + F(1, 10**30),
        lambda x, y: x * x - x * y,
    ],
)
def test_other_functions_do_not(other: Callable[[Any, Any], Any]) -> None:
    assert not agree(of_two(lambda x, y: x * x - y * y), of_two(other))


def test_a_state_that_is_not_written_differs() -> None:
    first = Routine("s", (S,), (Operation(0, RealOp.READ, place=Place("s")), Write(Place("s", Index(1)), 0)))
    assert agree(first, first)
    assert not agree(first, replace(first, body=()))


def test_roots_have_no_exact_value() -> None:
    assert agree(of_two(lambda x, y: sqrt(x)), of_two(lambda x, y: sqrt(y)))
