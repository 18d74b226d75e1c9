"""Sums of products of limbs: the bits of the sums they stand for, in words that never overflow, or none at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from random import Random
from typing import Any

import pytest
from exact_words import TooLargeError, run
from hypothesis import given, settings
from hypothesis import strategies as st

from qcone.formats.fixed import Signal
from qcone.ir.check import check
from qcone.ir.detail import Aligned, Mac, Shift
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Call, Operation, Place, Role, Routine, Shape, Statement, Write
from qcone.passes import limbs
from qcone.passes.expand import expand
from qcone.passes.limb_levels import levels_of
from qcone.passes.limb_ranges import Addend, Norms, Words
from qcone.passes.limb_sums import made_of_limbs

F = Fraction
WORD, WIDE = Signal(32, 30), Signal(64, 60)
Products = Sequence[tuple[tuple[int, ...], bool, int]]
"""Words, whether they are subtracted, how far they are shifted."""


def routine_of(
    sums: Sequence[Products],
    bounds: Sequence[int],
    discard: int,
    rounding: str = "up",
    constant: int = 0,
    result: int = 0,
) -> Routine:
    """Return sums of products of words of F30 whose raw sizes are bounded, and of a constant, each over 2^discard.

    The results are bounded by `result`, or by what the words' own bounds say.
    """
    reads: list[Statement] = [
        Operation(k, MachineOp.READ, place=Place("word", Index(k)), format=WORD, bound=size * WORD.lsb)
        for k, size in enumerate(bounds)
    ]
    at, signal = len(bounds), Signal(32, 60 - discard)
    body, writes = reads, []
    if constant:
        body.append(Operation(at, MachineOp.LITERAL, constant=constant * WIDE.lsb, format=WIDE))
    for k, terms in enumerate(sums):
        aligned = [Aligned(args, negative, shift) for args, negative, shift in terms]
        aligned += [Aligned((at,))] * bool(constant)
        most = sum(_size(args, bounds) << shift for args, _, shift in terms) + abs(constant)
        bound = F(result or (most >> discard) + 1) * signal.lsb
        args = tuple(dict.fromkeys(arg for each in aligned for arg in each.args))
        mac = Mac(tuple(aligned), 64, discard, rounding)
        body.append(Operation(at + 1 + k, MachineOp.MAC, args, format=signal, detail=mac, bound=bound))
        writes.append(Write(Place("sum", Index(k)), at + 1 + k))
    blocks = (
        Block("word", Shape.SCALAR, Role.INPUT, len(bounds), format=WORD),
        Block("sum", Shape.SCALAR, Role.OUTPUT, len(sums), format=signal),
    )
    return check(Routine("sums", blocks, (*body, *writes)), MachineOp)


def _size(args: tuple[int, ...], bounds: Sequence[int]) -> int:
    size = 1
    for arg in args:
        size *= bounds[arg]
    return size


def of_limbs(routine: Routine, norms: Norms = (), shared: bool = False) -> Routine:
    return check(expand(routine, made=made_of_limbs(routine, norms, shared)), MachineOp)


def operations(routine: Routine) -> list[Operation]:
    every = (each for one in (routine, *routine.callees.values()) for each in one.body)
    return [each for each in every if isinstance(each, Operation)]


def widths(routine: Routine) -> set[int]:
    """Return the widths of the words a routine makes."""
    made = (each.format for each in operations(routine) if each.op is not MachineOp.READ)
    return {each.width for each in made if isinstance(each, Signal)}


def corners(bound: int) -> list[int]:
    """Return words at the ends of their range and of the ranges of their limbs."""
    found = {bound, -bound, 0, 1, -1}
    for cut in (15, 16):
        half, top = 1 << (cut - 1), bound >> cut << cut
        found |= {
            sign * top + low for sign in (1, -1) for low in (-half, half - 1, half, -half - 1, -1, (1 << cut) - 1)
        }
    return sorted(each for each in found if -bound <= each <= bound)


PAIR = [((0, 1), False, 0)]
DOT = [((0, 4), False, 0), ((1, 5), False, 0), ((2, 6), False, 0), ((3, 7), True, 0)]
Q, V = 1077936128, 1759218605  # |q| <= 1.004 in F30, |v| <= 0.0512 in F35
KINDS: Mapping[str, tuple[Products, list[int], int, int]] = {
    "a product": (PAIR, [Q, V], 32, 0),
    "a product with few bits dropped": (PAIR, [1 << 20, 1 << 18], 8, 0),
    "a product with most of its bits dropped": (PAIR, [Q, V], 45, 0),
    "a short factor": (PAIR, [1 << 14, V], 20, 0),
    "a square": ([((0, 0), False, 0)], [V], 32, 0),
    "a difference": ([((0, 1), False, 0), ((2, 3), True, 0)], [V, V, Q, Q], 34, 0),
    "two negative products": ([((0, 1), True, 0), ((2, 3), True, 0)], [Q, V, Q, V], 34, 0),
    "four products": (DOT, [Q, Q, Q, Q, V, V, V, V], 35, 0),
    "squares from a half": ([((k, k), True, 0) for k in range(4)], [1 << 29] * 4, 31, 1 << 60),
    "a constant of all positions": ([((0, 1), True, 0)], [Q, V], 34, 3074457318914149564),
    "a negative constant": (PAIR, [Q, V], 34, -2305843009213693953),
    "a word as well": ([((0, 1), False, 0), ((2,), False, 25)], [Q, V, 1 << 27], 33, 0),
    "a word after the rounding": ([((0, 1), False, 0), ((2,), True, 36)], [Q, V, 1 << 20], 34, 0),
    "a shifted product": ([((0, 1), False, 3), ((2, 3), False, 0)], [1 << 28, V, Q, V], 35, 0),
}


@pytest.mark.parametrize("rounding", ["up", "floor"])
@pytest.mark.parametrize("kind", KINDS)
def test_bits_are_those_of_the_sum_and_no_word_overflows(kind: str, rounding: str) -> None:
    """At every corner of words and limbs, and between: `run` looks at each word on the way."""
    terms, bounds, discard, constant = KINDS[kind]
    routine = routine_of([terms], bounds, discard, rounding, constant)
    made = of_limbs(routine)
    assert widths(made) - {64} == {32}
    assert not any(each.format.width == 64 and each.op is not MachineOp.LITERAL for each in operations(made))  # type: ignore[union-attr]
    known = [corners(bound) for bound in bounds]
    rows = [list(row) for row in product(*known)] if len(bounds) < 3 else []
    ends = [[each[0], each[-1], *each[1:-1:3]] for each in known]
    for shift in range(max(map(len, known)) * 7):
        rows.append([each[(shift * (3 + k) + k) % len(each)] for k, each in enumerate(known)])
        rows.append([each[(shift >> k) % 2] if shift < 256 else each[shift % len(each)] for k, each in enumerate(ends)])
    for row in rows:
        assert run(made, {"word": row})[1] == run(routine, {"word": row})[1], row


@pytest.mark.parametrize("kind", KINDS)
def test_a_product_is_told_to_have_the_fraction_bits_of_its_factors(kind: str) -> None:
    """Also where a sum takes twice or half of it: what is twice a product of limbs stands one position higher."""
    terms, bounds, discard, constant = KINDS[kind]
    made = operations(of_limbs(routine_of([terms], bounds, discard, constant=constant)))
    bits = {each.result: each.format.fraction for each in made if isinstance(each.format, Signal)}
    products = [each for each in made if each.op is MachineOp.MULTIPLY]
    assert products
    assert all(bits[each.result] == sum(bits[arg] for arg in each.args) for each in products)


def wide_left(routine: Routine) -> bool:
    return any(each.op is MachineOp.MULTIPLY and each.format.width == 64 for each in operations(routine))  # type: ignore[union-attr]


def test_words_that_fill_the_word_are_left_to_products_of_64_bits() -> None:
    """High limbs of 2^31 may be 2^15 and more: nothing proves their sums, so nothing is made of limbs."""
    routine = routine_of([[*PAIR, *PAIR]], [1 << 31, 1 << 31], 34, result=1 << 30)
    assert made_of_limbs(routine, (), False).sums == {}
    assert wide_left(of_limbs(routine))
    assert not wide_left(of_limbs(routine_of([PAIR], [Q, V], 34)))


def test_a_sum_that_is_left_leaves_nothing_behind() -> None:
    """Neither a word cut for it, nor a name of one: each of its products fits, their sum is not proved to."""
    named, large = {0: "a", 1: "b", 2: "c", 3: "d"}, 2**31 - 2**17
    routine = routine_of(
        [PAIR, [((2, 3), False, 0), ((3, 2), False, 0), ((2, 3), False, 0)]], [Q, V, large, large], 32, result=1 << 30
    )
    made = made_of_limbs(replace(routine, names=named), (), False)
    assert len(made.sums) == 1
    assert set(made.names.values()) == {"a_low", "a_high", "b_low", "b_high"}
    whole = of_limbs(replace(routine, names=named))
    assert set(whole.names) <= {each.result for each in operations(whole)}


@pytest.mark.parametrize(
    "change",
    [{"rounding": "even"}, {"limits": (-5, 5)}, {"residual": ("kept", Index(0))}, {"accumulator": 32}, {"discard": 0}],
    ids=lambda change: next(iter(change)),
)
def test_sums_of_another_kind_are_left_alone(change: dict[str, Any]) -> None:
    routine = routine_of([PAIR], [Q, V], 32)
    body = tuple(
        replace(each, detail=replace(each.detail, **change))
        if isinstance(each, Operation) and isinstance(each.detail, Mac)
        else each
        for each in routine.body
    )
    assert made_of_limbs(routine, (), False).sums
    assert made_of_limbs(routine.with_body(body), (), False).sums == {}


def overflows(routine: Routine, rows: Sequence[list[int]]) -> bool:
    try:
        for row in rows:
            run(routine, {"word": row})
    except TooLargeError:
        return True
    return False


def test_lengths_prove_what_components_do_not() -> None:
    """Of a quaternion product the norms bound every sum of limbs: fewer words hold it."""
    routine = routine_of([DOT], [Q, Q, Q, Q, V, V, V, V], 35, result=int(Q * V / 2**35) + 2)
    norms = ((frozenset(range(4)), Q * WORD.lsb), (frozenset(range(4, 8)), V * WORD.lsb))
    known, unknown = of_limbs(routine, norms), of_limbs(routine)
    assert len(operations(known)) < len(operations(unknown))
    for angle in range(64):
        one = (
            [Q if angle % 4 == k else 0 for k in range(4)]
            if angle < 4
            else [int(Q / 2 * (-1) ** (angle >> k)) for k in range(4)]
        )
        other = [int(V / 2 * (-1) ** (angle // 3 >> k)) for k in range(4)]
        row = {"word": [*one, *other]}
        assert run(known, row)[1] == run(routine, row)[1]
    # They do matter: beyond them a sum is beyond its word.
    assert overflows(known, [[Q, Q, Q, Q, *(sign * V for sign in signs)] for signs in product((1, -1), repeat=4)])


words = st.integers(2, 2**31 - 2**17)


@st.composite
def drawn(draw: Any) -> tuple[Products, list[int], int, int]:
    bounds = draw(st.lists(words, min_size=2, max_size=6))
    one = st.integers(0, len(bounds) - 1)
    terms = draw(st.lists(st.tuples(st.tuples(one, one), st.booleans(), st.integers(0, 3)), min_size=1, max_size=5))
    terms += draw(st.lists(st.tuples(st.tuples(one), st.booleans(), st.integers(0, 30)), max_size=2))
    size = sum(_size(args, bounds) << shift for args, _, shift in terms)
    constant = draw(st.integers(-size, size))
    discard = max(draw(st.integers(1, 40)), (size + abs(constant)).bit_length() - 30, 1)
    return terms, bounds, discard, constant


@settings(max_examples=300, deadline=None)
@given(drawn(), st.sampled_from(["up", "floor"]), st.data())
def test_any_sum_has_its_bits(sum_: tuple[Products, list[int], int, int], rounding: str, data: Any) -> None:
    """In the range that its result is said to keep: what is beyond is not looked at."""
    terms, bounds, discard, constant = sum_
    size = sum(_size(args, bounds) << shift for args, _, shift in terms) + abs(constant)
    if size >= 2**62:
        return
    result = data.draw(st.integers(1, (size >> discard) + 1))
    routine = routine_of([terms], bounds, discard, rounding, constant, result)
    made = of_limbs(routine)
    for _ in range(8):
        row = [data.draw(st.one_of(st.sampled_from(corners(bound)), st.integers(-bound, bound))) for bound in bounds]
        if within(routine, row):
            assert run(made, {"word": row})[1] == run(routine, {"word": row})[1]


def within(routine: Routine, row: list[int]) -> bool:
    return not overflows(routine, [row])


def test_squares_are_bounded_by_their_sum_only_alone() -> None:
    """Two squares and a product above them that takes away what they have too much: no word holds the squares."""
    terms = [((0, 0), False, 0), ((1, 1), False, 0), ((2, 3), True, 1)]
    routine = routine_of([terms], [Q + Q // 3] * 4, 30, result=1 << 20)
    row = [Q + Q // 3] * 4
    assert within(routine, row)
    assert run(of_limbs(routine), {"word": row})[1] == run(routine, {"word": row})[1]


def test_squares_that_a_constant_leaves_little_of_are_bounded_by_the_result() -> None:
    """(1 - |q|^2)/2 + u: the squares stand above u, and nothing but the result proves that they fit at its position."""
    u = 5_400_000
    terms = [((4,), False, 29), *(((k, k), True, 0) for k in range(4))]
    routine = routine_of([terms], [*[Q] * 4, u], 27, constant=1 << 60, result=90_000_000)
    made = of_limbs(routine)
    assert not wide_left(made)
    one, half = 1 << 30, 1 << 29
    for q in ([one, 0, 0, 0], [half, -half, half, -half], [Q, 0, 0, 0], [0, 0, -one + 2**22, 1], [half + 2**20] * 4):
        for word in (u, -u, 0, 1):
            assert within(routine, [*q, word])
            assert run(made, {"word": [*q, word]})[1] == run(routine, {"word": [*q, word]})[1]


def test_only_the_first_pile_is_rounded() -> None:
    """What the second carries is whole: its range goes down to the floor of its least value."""
    least = -(2**31 - 2**17) + 2**15
    product = Addend((least, 2**30))
    levels, carries = levels_of(Words(routine_of([PAIR], [Q, V], 34)), {0: [product, product]}, 16, "up")
    assert [len(pile) for pile in levels[0].piles] == [1, 1]
    assert [low for low, _ in carries] == [least + 2**15 >> 16, least >> 16]


# -- functions --------------------------------------------------------------------------------------------

CROSS = [[((k, 3 + (k + 1) % 3), False, 0), (((k + 1) % 3, 3 + k), True, 0)] for k in range(3)]


def test_alike_sums_call_one_function() -> None:
    routine = routine_of(CROSS, [Q, V, Q, V, Q, V], 34)
    made = of_limbs(routine, shared=True)
    calls = [each for each in made.body if isinstance(each, Call)]
    assert {each.routine for each in calls} == set(made.callees)
    assert [len(calls), len(made.callees)] == [3, 1]
    callee = made.callees["sums_sum_1"]
    assert callee.by_value
    assert callee.steps[0].text == "sum = (a b - c d) / 2^34 in raw words, of limbs"
    for row in ([Q, -V, Q, V, -Q, V], [Q, V, Q, -V, Q, V], [1, 2, 3, 4, 5, 6], [-Q] * 6):
        assert run(made, {"word": row})[1] == run(routine, {"word": row})[1]


@pytest.mark.parametrize("change", ["discard", "sign", "constant"])
def test_sums_that_differ_share_no_function(change: str) -> None:
    one, other = [((0, 1), False, 0), ((2, 3), False, 0)], [((0, 1), False, 0), ((2, 3), change == "sign", 0)]
    routine = routine_of([one, other], [V] * 4, 34)
    body = list(routine.body)
    at = len(body) - 3
    last = body[at]
    assert isinstance(last, Operation)
    assert isinstance(last.detail, Mac)
    if change == "discard":
        body[at] = replace(last, detail=replace(last.detail, discard=35), format=Signal(32, 25))
    if change == "constant":
        literal = Operation(99, MachineOp.LITERAL, constant=F(5) * WIDE.lsb, format=WIDE)
        detail = replace(last.detail, terms=(*last.detail.terms, Aligned((99,))))
        body[at : at + 1] = [literal, replace(last, args=(*last.args, 99), detail=detail)]
    assert made_of_limbs(routine.with_body(tuple(body)), (), True).callees == {}


def test_few_alike_sums_are_written_out() -> None:
    assert of_limbs(routine_of([PAIR, PAIR], [Q, V], 34), shared=True).callees == {}


# -- mistakes that turn the tests above red ----------------------------------------------------------------


def differ(routine: Routine) -> bool:
    """Tell whether limbs give other bits than the sum, or a word too large, somewhere at the corners."""
    made = of_limbs(routine)
    try:
        return any(
            run(made, {"word": list(row)})[1] != run(routine, {"word": list(row)})[1]
            for row in product(corners(Q)[::3], corners(V)[::2])
        )
    except TooLargeError:
        return True


def test_a_limb_width_off_by_one_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    routine = routine_of([PAIR], [Q, V], 32)
    assert not differ(routine)
    right = limbs.LimbSums._emit

    def off(self: Any, op: MachineOp, args: Any, signal: Any, limits: Any, shift: Any = None) -> int:
        wrong = Shift(shift.bits - 1) if op in (MachineOp.LOW, MachineOp.REMAINDER) else shift
        return right(self, op, args, signal, limits, wrong)

    monkeypatch.setattr(limbs.LimbSums, "_emit", off)
    assert differ(routine)


def test_a_limb_in_the_wrong_place_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    routine = routine_of([PAIR], [Q, V], 32)
    right = limbs.LimbSums._cut

    def off(self: Any, word: int) -> Any:
        low, *high = right(self, word)
        return (low, *(replace(each, position=each.position + 1) for each in high))

    monkeypatch.setattr(limbs.LimbSums, "_cut", off)
    assert differ(routine)


def test_a_range_that_is_too_small_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """With products said to be half as large, sums are made that do not fit their words."""
    routine = routine_of([DOT], [Q, Q, Q, Q, V, V, V, V], 35)
    right = Words.sum

    def halved(self: Words, addends: Any) -> Any:
        low, high = right(self, addends)
        return low // 2, high // 2

    choice = Random(1).choice
    rows = [[choice(corners(bound)) for bound in (Q, Q, Q, Q, V, V, V, V)] for _ in range(2000)]
    assert not overflows(of_limbs(routine), rows)
    monkeypatch.setattr(Words, "sum", halved)
    assert overflows(of_limbs(routine), rows)


def test_a_lost_carry_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    routine = routine_of([PAIR], [Q, V], 32)
    right = limbs.LimbSums._carried

    def lost(self: Any, levels: Any, sums: Any, rounding: str) -> Any:
        return right(self, [levels[-1]], sums, rounding)

    monkeypatch.setattr(limbs.LimbSums, "_carried", lost)
    assert differ(routine)
