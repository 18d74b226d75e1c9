"""From sums of products to integer operations: what is added after a rounding, and when that may be."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from qcone.formats.fixed import Signal
from qcone.ir.check import check
from qcone.ir.detail import Aligned, Mac
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Operation, Place, Role, Routine, Shape, Write
from qcone.passes.expand import expand

F = Fraction


def linear(shifts: list[int], bounds: list[Fraction], discard: int, bound: Fraction) -> Routine:
    """Return words added and rounded by 2^-discard in a sum of F20, each a number of whole 2^shift."""
    given = Block("word", Shape.SCALAR, Role.INPUT, len(shifts), format=Signal(32, 20))
    signal = Signal(32, 20 - discard)
    out = Block("sum", Shape.SCALAR, Role.OUTPUT, format=signal)
    reads = [
        Operation(k, MachineOp.READ, place=Place("word", Index(k)), format=Signal(32, 20 - shift), bound=size)
        for k, (shift, size) in enumerate(zip(shifts, bounds, strict=True))
    ]
    terms = tuple(Aligned((k,), shift=shift) for k, shift in enumerate(shifts))
    mac, values = Mac(terms, 64, discard, "up"), tuple(range(len(shifts)))
    total = Operation(9, MachineOp.MAC, values, format=signal, detail=mac, bound=bound)
    body = (*reads, total, Write(Place("sum"), 9))
    return check(Routine("linear", (given, out), body, names={9: "total"}), MachineOp)


def right_shifts(routine: Routine) -> list[int]:
    """Return the widths of the words that are shifted."""
    formats = {each.result: each.format for each in routine.body if isinstance(each, Operation)}
    shifts = [each for each in routine.body if isinstance(each, Operation) and each.op is MachineOp.SHIFT_RIGHT]
    return [formats[each.args[0]].width for each in shifts]  # type: ignore[union-attr]


def test_a_word_that_is_a_whole_number_of_last_bits_is_added_after_the_rounding() -> None:
    routine = linear([0, 8], [F(1), F(100)], 4, F(101))
    assert right_shifts(expand(routine, narrow=True)) == [32]
    assert right_shifts(expand(routine, narrow=False)) == [64]


@pytest.mark.parametrize("number", ["one", "two"])
def test_what_fits_one_word_only_together_is_added_in_two(number: str) -> None:
    """With one word to be added the sum is the result; with two the first of them may already be beyond a word."""
    late = [8] if number == "one" else [8, 8]
    routine = linear([0, *late], [F(1), *[F(30000)] * len(late)], 4, F(30000))
    assert right_shifts(expand(routine, narrow=True)) == ([32] if number == "one" else [64])


def test_a_doubled_word_is_twice_as_large() -> None:
    """2 x is x with its point moved: in the sum it counts twice."""
    routine = linear([0, 12], [F(1100), F(1)], 4, F(2300))
    assert right_shifts(expand(routine, narrow=True)) == [32]
    doubled = Mac((Aligned((0,), shift=1), Aligned((1,), shift=12)), 64, 4, "up")
    body = tuple(
        replace(each, detail=doubled) if isinstance(each, Operation) and each.detail else each for each in routine.body
    )
    assert right_shifts(expand(routine.with_body(body), narrow=True)) == [64]
