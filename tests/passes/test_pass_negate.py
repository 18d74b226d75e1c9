"""Negated operands: made once where they serve several subtracted products, and nothing else changes."""

from __future__ import annotations

import numpy as np
import pytest

from qcone.backends.bittrue import Model, new_state
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.check import check
from qcone.ir.detail import Aligned, Mac
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Operation, Place, Program, Role, Routine, Shape, Write
from qcone.passes.expand import expand
from qcone.passes.negate import negate

WORD, RESULT = Signal(32, 20), Signal(32, 12)
NUMBER = Fixed("fixed32", 32)
STATE = Block("state", Shape.SCALAR, Role.STATE, format=WORD)


def routine(*sums: tuple[Aligned, ...], accumulator: int = 64) -> Routine:
    """Return sums of products of four words a, b, c, d of F20, each rounded to F12."""
    given = Block("word", Shape.SCALAR, Role.INPUT, 4, format=WORD)
    out = Block("sum", Shape.SCALAR, Role.OUTPUT, len(sums), format=RESULT)
    reads = [Operation(k, MachineOp.READ, place=Place("word", Index(k)), format=WORD) for k in range(4)]
    made: list[Operation | Write] = []
    for k, terms in enumerate(sums):
        args = tuple(dict.fromkeys(arg for term in terms for arg in term.args))
        mac = Mac(terms, accumulator, 28, "up")
        made.append(Operation(10 + k, MachineOp.MAC, args, format=RESULT, detail=mac))
        made.append(Write(Place("sum", Index(k)), 10 + k))
    names = dict(enumerate("abcd"))
    return check(Routine("sums", (given, out), (*reads, *made), names=names), MachineOp)


def plus(*args: int) -> Aligned:
    return Aligned(args)


def minus(*args: int) -> Aligned:
    return Aligned(args, negative=True)


def negated(made: Routine) -> list[str]:
    """Return the names of the words that are negated."""
    check(made, MachineOp)
    operations = [each for each in made.body if isinstance(each, Operation) and each.op is MachineOp.NEGATE]
    factors = [made.names[each.args[0]] for each in operations]
    assert [made.names[each.result] for each in operations] == [f"{factor}_negated" for factor in factors]
    return factors


def subtracted(made: Routine) -> int:
    macs = [each.detail for each in made.body if isinstance(each, Operation) and isinstance(each.detail, Mac)]
    return sum(term.negative for mac in macs for term in mac.terms)


def test_a_factor_of_two_subtracted_products_is_negated_once() -> None:
    before = routine((plus(0, 2), minus(1, 3)), (plus(1, 2), minus(0, 3)))
    after = negate(before)
    assert negated(after) == ["d"]
    assert (subtracted(before), subtracted(after)) == (2, 0)


def test_the_factor_that_serves_most_products_comes_first() -> None:
    after = negate(routine((minus(0, 1), minus(0, 2)), (minus(0, 3), minus(1, 3)), (minus(1, 2),)))
    assert negated(after) == ["a", "b"]
    assert subtracted(after) == 0


UNTOUCHED = {
    "one product": ((plus(0, 1), minus(2, 3)),),
    "squares": ((plus(0, 1), minus(2, 2), minus(3, 3)), (minus(2, 2),)),
    "words": ((plus(0, 1), minus(2), minus(3)), (plus(1), minus(2))),
    "added": ((plus(0, 1), plus(0, 2)),),
}


@pytest.mark.parametrize("name", UNTOUCHED)
def test_what_does_not_pay_is_left_alone(name: str) -> None:
    before = routine(*UNTOUCHED[name])
    assert negate(before) is before


def test_sums_of_single_words_are_left_alone() -> None:
    """Products of 16 bits are made in 32, where subtracting one is an instruction too."""
    before = routine((minus(0, 1),), (minus(0, 2),), accumulator=32)
    assert negate(before) is before


def test_no_bit_changes() -> None:
    before = routine((plus(0, 2), minus(1, 3), minus(0, 1)), (plus(1, 2), minus(0, 3)))
    words = np.random.default_rng(4).integers(-(2**30), 2**30, (4, 500)).astype(np.int32)
    found = []
    for made in (before, expand(before), negate(before), expand(negate(before))):
        program = Program("sums", (STATE,), (made,))
        state = new_state(program, NUMBER, words.shape[1])
        found.append(Model(program, NUMBER).run("sums", state, {"word": words})["sum"])
    assert len({each.tobytes() for each in found}) == 1
    assert np.abs(found[0]).max() > 2**20
