"""Negate: make a negated operand once where several products are subtracted, so that they are added. Exact.

Cores multiply and add in one instruction; few multiply and subtract. One negation of a word that is a factor of
two subtracted products or more is cheaper than subtracting each. A word in its range has a negative: |raw| < 2^(W-1).
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from qcone.formats.fixed import Signal
from qcone.ir.detail import Aligned, Mac
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation, Routine, Statement, unused
from qcone.passes.fuse import args_of

WORTH = 2
"""Subtracted products that a negation has to serve; for a single one it costs what it saves."""


def negate(routine: Routine) -> Routine:
    """Return a routine of `mac` operations with factors of subtracted products negated once, where that pays."""
    negated = _chosen(routine)
    if not negated:
        return routine
    return _Negation(routine, negated).run()


class _Negation:
    def __init__(self, routine: Routine, negated: dict[int, Signal]) -> None:
        self.routine, self.negated = routine, negated
        self.names = dict(routine.names)
        self.next = unused(routine)
        self.made: dict[int, int] = {}
        self.body: list[Statement] = []

    def run(self) -> Routine:
        for statement in self.routine.body:
            mac = _double(statement)
            if mac is not None and isinstance(statement, Operation):
                terms = tuple(self._term(term, statement.step) for term in mac.terms)
                statement = replace(statement, args=args_of(terms), detail=replace(mac, terms=terms))
            self.body.append(statement)
        return replace(self.routine, body=tuple(self.body), names=self.names)

    def _term(self, term: Aligned, step: int) -> Aligned:
        """Return what is added for a subtracted product of a negated word; every other term as it is."""
        value = next((word for word in self.negated if word in term.args), None) if _subtracted(term) else None
        if value is None:
            return term
        if value not in self.made:
            self._make(value, step)
        args = tuple(self.made[value] if arg == value else arg for arg in term.args)
        return replace(term, args=args, negative=False)

    def _make(self, value: int, step: int) -> None:
        self.made[value], self.next = self.next, self.next + 1
        if value in self.names:
            self.names[self.made[value]] = f"{self.names[value]}_negated"
        operation = Operation(self.made[value], MachineOp.NEGATE, (value,), step=step, format=self.negated[value])
        self.body.append(operation)


def _chosen(routine: Routine) -> dict[int, Signal]:
    """Return the words to be negated: the one that serves most products first, until none serves enough."""
    formats = {
        each.result: each.format
        for each in routine.body
        if isinstance(each, Operation) and isinstance(each.format, Signal)
    }
    macs = filter(None, map(_double, routine.body))
    left = [term.args for mac in macs for term in mac.terms if _subtracted(term)]
    chosen: dict[int, Signal] = {}
    while True:
        uses = Counter(arg for args in left for arg in args)
        most = max(uses.values(), default=0)
        if most < WORTH:
            return chosen
        value = min(arg for arg, times in uses.items() if times == most)
        chosen[value] = formats[value]
        left = [args for args in left if value not in args]


def _double(statement: Statement) -> Mac | None:
    """Return the sum that a statement makes in a double word of 64 bits; None for every other statement."""
    mac = statement.detail if isinstance(statement, Operation) else None
    return mac if isinstance(mac, Mac) and mac.accumulator == 64 else None


def _subtracted(term: Aligned) -> bool:
    """Tell whether a term is a subtracted product of two words; a square has no factor to be negated alone."""
    return term.negative and len(term.args) == 2 and term.args[0] != term.args[1]
