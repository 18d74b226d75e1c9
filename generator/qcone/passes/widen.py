"""Widen the attitude: keep what is accumulated in a word twice as wide, and work with its upper half.

The state has bits to spare for increments far below the last bit of a word; products need none of them, so every use
but the accumulation itself takes the attitude rounded to a word.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from qcone.ir.detail import Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Routine, Statement, Write, unused
from qcone.passes.rebuild import regrouped


def widen(routine: Routine, held: str) -> Routine:
    """Return the routine with the block `held` accumulated as it is, and rounded to a word for every other use."""
    return _Widening(routine, held).run()


class _Widening:
    def __init__(self, routine: Routine, held: str) -> None:
        self.routine, self.held = routine, held
        self.names = dict(routine.names)
        self.upper: dict[int, int] = {}
        self.read: set[int] = set()
        self.next = unused(routine)

    def run(self) -> Routine:
        body = tuple(each for statement in self.routine.body for each in self._statement(statement))
        groups = (
            replace(group, block=self.held)
            if not self.read.isdisjoint(group.values) and group.kind == "input"
            else group
            for group in self.routine.groups
        )
        renamed = {whole: upper for whole, upper in self.upper.items() if whole in self.read}
        return replace(self.routine, body=body, names=self.names, groups=regrouped(tuple(groups), renamed))

    def _statement(self, statement: Statement) -> Iterable[Statement]:
        if isinstance(statement, Write):
            writes_state = statement.place.block == self.held
            value = statement.value if writes_state else self.upper.get(statement.value, statement.value)
            return (replace(statement, value=value),)
        if not isinstance(statement, Operation):
            return (statement,)
        args = [self.upper.get(arg, arg) for arg in statement.args]
        if statement.op is RealOp.ACCUMULATE:
            args[0] = statement.args[0]
        made = replace(statement, args=tuple(args))
        reads = statement.op is RealOp.READ and statement.place is not None and statement.place.block == self.held
        if reads or statement.op is RealOp.ACCUMULATE:
            return (made, *self._upper(made))
        return (made,)

    def _upper(self, whole: Operation) -> Iterable[Statement]:
        """Write the value rounded to a word, under its own name; the whole word is the state's."""
        value, self.next = self.next, self.next + 1
        name = self.names.get(whole.result)
        if name:
            if whole.op is RealOp.READ:
                self.names[whole.result] = f"{name}_whole"
                self.names[value] = name
            else:
                self.names[value] = f"{name}_upper"
        self.upper[whole.result] = value
        if whole.op is RealOp.READ:
            self.read.add(whole.result)
        detail = Sum((Term(Fraction(1), (whole.result,)),))
        return (Operation(value, RealOp.SUM, (whole.result,), step=whole.step, detail=detail),)
