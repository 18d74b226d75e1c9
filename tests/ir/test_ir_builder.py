"""Writing a routine down: one written operation is one value, and what each operation of the papers costs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from quantities import BLOCKS, F, Page

from qcone.errors import UsageError
from qcone.ir import products
from qcone.ir.blocks import Matrix, cross, dot, matrix, number, sqrt
from qcone.ir.builder import Builder
from qcone.ir.index import Index
from qcone.ir.labels import named, step
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Place, Role, Routine, Shape, Step, Write, walk
from qcone.ir.update import quaternion
from qcone.ir.writing import Writing


@pytest.mark.parametrize(
    ("write", "expected"),
    [
        (lambda page: page.x + page.x, {"add": 1}),
        (lambda page: 1 - page.x, {"subtract": 1}),
        (lambda page: F(1, 3) + page.x, {"add": 1}),
        (lambda page: 2 * page.x, {"multiply": 1}),
        (lambda page: page.x / 3, {"divide": 1}),
        (lambda page: page.x / page.x, {"divide": 1}),
        (lambda page: -page.x, {"negate": 1}),
        (lambda page: sqrt(page.x), {"square_root": 1}),
        (lambda page: page.a + page.b, {"add": 3}),
        (lambda page: page.a - page.b, {"subtract": 3}),
        (lambda page: -page.a, {"negate": 3}),
        (lambda page: F(9, 20) * page.a, {"multiply": 3}),
        (lambda page: page.x * page.a, {"multiply": 3}),
        (lambda page: page.a * page.x, {"multiply": 3}),
        (lambda page: page.a / page.x, {"divide": 3}),
        (lambda page: cross(page.a, page.b), {"multiply": 6, "subtract": 3}),
        (lambda page: dot(page.a, page.b), {"multiply": 3, "add": 2}),
        (lambda page: page.q + page.p, {"add": 4}),
        (lambda page: page.x * page.q, {"multiply": 4}),
        (lambda page: page.q * page.p, {"multiply": 16, "add": 12, "negate": 6}),
        (lambda page: page.q * page.a, {"multiply": 12, "add": 5, "subtract": 3, "negate": 1}),
        (
            lambda page: products.hamilton_least(page.builder.emit, page.q.values, page.p.values),
            {"multiply": 16, "add": 6, "subtract": 6},
        ),
        (lambda page: matrix([page.x] * 9), {}),
        (lambda page: quaternion(page.x, page.a), {}),
        (lambda page: (page.q.scalar, page.q.vector, *page.q, *page.a), {}),
    ],
)
def test_operations_written(write: Callable[[Page], Any], expected: dict[str, int]) -> None:
    page = Page()
    write(page)
    assert page.counts() == expected


def test_the_same_product_twice_is_two_products() -> None:
    page = Page()
    first, second = page.x * page.x, page.x * page.x
    assert first.value != second.value
    assert page.counts() == {"multiply": 2}


def test_the_same_constant_twice_is_two_constants() -> None:
    page = Page()
    assert number(1, page.x).value != number(1, page.x).value


def test_every_value_is_defined_once_in_order_of_writing() -> None:
    page = Page()
    cross((page.q * page.a).vector, page.b)
    results = [each.result for each in page.builder.routine().body if isinstance(each, Operation)]
    assert results == list(range(len(results)))


def test_products_are_the_textbook_ones() -> None:
    """p (x) q by components, written independently of the product code: over numbers, not over values."""

    table: list[F] = []

    def put(value: F) -> int:
        table.append(value)
        return len(table) - 1

    def emit(op: RealOp, *args: int) -> int:
        values = [table[arg] for arg in args]
        if op is RealOp.MULTIPLY:
            return put(values[0] * values[1])
        if op is RealOp.ADD:
            return put(values[0] + values[1])
        return put(values[0] - values[1] if op is RealOp.SUBTRACT else -values[0])

    a, b, c, d = (F(k, 7) for k in (2, 3, 5, 11))
    e, f, g, h = (F(k, 13) for k in (1, 4, 9, 17))
    expected = (
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    )
    p, q = [put(value) for value in (a, b, c, d)], [put(value) for value in (e, f, g, h)]
    zero = put(F(0))
    for product in (products.hamilton, products.hamilton_least):
        assert tuple(table[value] for value in product(emit, p, q)) == expected
    whole = tuple(table[value] for value in products.hamilton(emit, p, [zero, *q[1:]]))
    assert tuple(table[value] for value in products.hamilton_pure(emit, p, q[1:])) == whole
    crossed = tuple(table[value] for value in products.cross(emit, p[1:], q[1:]))
    assert crossed == (c * h - d * g, d * f - b * h, b * g - c * f)


# -- reads ------------------------------------------------------------------------------------------------


def reads(routine: Routine) -> list[Place]:
    return [each.place for each in walk(routine.body) if isinstance(each, Operation) and each.place]


def test_inputs_and_state_are_read_once() -> None:
    page = Page()
    before = len(reads(page.builder.routine()))
    assert page.take(0).values == page.q.values
    assert page.take(2, 1).values == page.b.values
    assert len(reads(page.builder.routine())) == before == 4 + 4 + 6 + 1


def test_a_local_is_read_every_time_for_it_may_have_changed() -> None:
    page = Page()
    local = page.builder.declare("r", Shape.SCALAR, 2, Role.LOCAL)
    assert page.builder.read(local, 1) != page.builder.read(local, 1)


def test_a_read_inside_a_loop_is_not_handed_to_what_follows() -> None:
    builder = Builder("page", BLOCKS, Writing(rolled=True))
    for _ in builder.loop("n", Index(0), Index(1)):
        inside = builder.read(BLOCKS[3], 0)
    assert builder.read(BLOCKS[3], 0) != inside


def test_reads_are_named_after_the_component() -> None:
    page = Page()
    names = page.builder.routine().names
    assert [names[value] for value in page.q.values] == ["q_w", "q_x", "q_y", "q_z"]
    assert [names[value] for value in page.b.values] == ["a2_x", "a2_y", "a2_z"]
    assert names[page.x.value] == "x"


def test_a_write_stores_where_it_says() -> None:
    page = Page()
    page.builder.write(BLOCKS[0], 2, page.x.value)
    assert page.builder.routine().body[-1] == Write(Place("q", Index(2)), page.x.value)


# -- steps and names --------------------------------------------------------------------------------------


def headings(routine: Routine) -> list[tuple[str, str]]:
    """Return (heading, operation) of everything but reads."""
    return [
        (routine.steps[each.step].text, each.op.value)
        for each in routine.body
        if isinstance(each, Operation) and each.op is not RealOp.READ
    ]


def test_a_step_covers_what_was_written_since_the_last_one() -> None:
    page = Page()
    step("one = x x", "paper (1)", page.x * page.x)
    part = named("part", page.x + page.x)
    whole = step("two = x + x - x", "paper (2)", part - page.x)
    page.x / 2
    routine = page.builder.routine()
    assert headings(routine) == [
        ("one = x x", "multiply"),
        ("two = x + x - x", "add"),
        ("two = x + x - x", "subtract"),
        ("", "constant"),
        ("", "divide"),
    ]
    assert [each.equation for each in routine.steps] == ["", "paper (1)", "paper (2)"]
    assert (routine.names[part.value], routine.names[whole.value]) == ("part", "two")


def test_the_first_name_stays() -> None:
    page = Page()
    value = named("first", page.x + page.x)
    assert named("second", value) is value
    assert page.builder.routine().names[value.value] == "first"


def test_components_are_named_with_their_axes() -> None:
    page = Page()
    routine_names = page.builder.names
    made: Matrix = named("m", matrix([page.x + page.x for _ in range(9)]))
    assert [routine_names[value] for value in made.values] == [f"m_{r}{c}" for r in "123" for c in "123"]


@pytest.mark.parametrize("text", ["", "= x", "two words = x", "3 = x"])
def test_a_step_begins_with_a_name(text: str) -> None:
    page = Page()
    with pytest.raises(UsageError, match="the text must begin with a name and an equals sign"):
        step(text, "", page.x)


def test_settled_lines_keep_their_heading() -> None:
    """What has a heading of its own is not taken by a later step of the library."""
    lines = iter([Step("line 1"), Step("line 2"), Step(""), Step("line 3")])
    builder = Builder("page", BLOCKS, Writing(), lambda: next(lines))
    block = BLOCKS[3]
    x = builder.read(block, 0)
    y = builder.emit(RealOp.ADD, x, x)
    z = builder.emit(RealOp.ADD, y, y)
    builder.settle()
    builder.emit(RealOp.ADD, z, z)
    builder.label(Step("of the library"))
    routine = builder.routine()
    assert [routine.steps[each.step].text for each in routine.body] == [
        "line 1",
        "line 2",
        "of the library",
        "of the library",
    ]
