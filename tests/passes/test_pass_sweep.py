"""What nothing uses is swept away, and only that."""

from __future__ import annotations

from typing import Any

import pytest
from real_routines import F, operations, written

from qcone.ir.check import check
from qcone.ir.evaluate import agree
from qcone.ir.indexed import history, loop, table
from qcone.ir.operations import RealOp
from qcone.ir.statement import Call, Loop, Operation, Role, Write, walk
from qcone.ir.subroutine import subroutine
from qcone.passes.sweep import sweep


def test_a_chain_without_an_end() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        lost = F(1, 3) * (x + s)
        lost = lost * lost
        return x - s

    routine = written(author)
    swept = check(sweep(routine), RealOp)
    assert operations(swept) == {"subtract": 1}
    assert len([each for each in swept.body if isinstance(each, Operation)]) == 3
    assert agree(routine, swept)


def test_what_is_used_stays() -> None:
    routine = written(lambda v, x, s: F(1, 3) * (x + s) - v.__iter__().__next__())
    assert operations(sweep(routine)) == operations(routine)


@pytest.mark.parametrize("rolled", [True, False])
def test_arrays(rolled: bool) -> None:
    """Written out, neither history nor table is left; rolled, both stay."""

    def author(v: Any, x: Any, s: Any) -> Any:
        weight = table("weight", x, [F(1, 3), F(1, 5), F(1, 7)])
        r = history("r", x, 3)
        r[0] = x
        for n in loop("n", x, 1, 2):
            r[n] = weight[n] * r[n - 1]
        return r[2]

    routine = written(author, rolled)
    swept = check(sweep(routine), RealOp)
    roles = [block.role for block in swept.blocks]
    assert (Role.LOCAL in roles, Role.TABLE in roles) == (rolled, rolled)
    assert {Role.STATE, Role.INPUT, Role.OUTPUT} <= set(roles)
    assert agree(routine, swept)


def test_a_history_that_nothing_reads() -> None:
    """Its writes go, the loop that is empty then, and the history."""

    def author(v: Any, x: Any, s: Any) -> Any:
        r, kept = history("r", x, 3), history("kept", x, 3)
        kept[0] = x
        for n in loop("n", x, 0, 2):
            r[n] = F(1, 3) * x
        for n in loop("n", x, 1, 2):
            r[n] = x
            kept[n] = kept[n - 1] + s
        return kept[2]

    routine = written(author, rolled=True)
    swept = check(sweep(routine), RealOp)
    assert [block.name for block in swept.having(Role.LOCAL)] == ["kept"]
    assert len([each for each in swept.body if isinstance(each, Loop)]) == 1
    assert {each.place.block for each in walk(swept.body) if isinstance(each, Write)} == {"kept", "out"}
    assert operations(swept) == {"add": 1}
    assert agree(routine, swept)


def test_calls() -> None:
    @subroutine
    def used(a):  # type: ignore[no-untyped-def]
        lost = a * a
        return (a + a) if lost else a

    @subroutine
    def unused(a):  # type: ignore[no-untyped-def]
        return a * a

    def author(v: Any, x: Any, s: Any) -> Any:
        unused(x)
        return used(x)

    routine = written(author)
    swept = check(sweep(routine), RealOp)
    assert [each.routine for each in swept.body if isinstance(each, Call)] == ["used"]
    assert set(swept.callees) == {"used"}
    assert operations(swept.callees["used"]) == {"add": 1}
    assert agree(routine, swept)


def test_writes_to_state_and_outputs_stay() -> None:
    from dataclasses import replace

    from qcone.ir.statement import Place

    routine = written(lambda v, x, s: x)
    stored = replace(routine, body=(*routine.body, Write(Place("s"), routine.body[3].result)))  # type: ignore[union-attr]
    assert [each.place.block for each in sweep(stored).body if isinstance(each, Write)] == ["out", "s"]
