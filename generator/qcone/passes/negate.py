"""Negate: make a negated operand once where several products are subtracted, so that they are added. Exact.

Cores multiply and add in one instruction; few multiply and subtract. One negation of a word that is a factor of
two subtracted products or more is cheaper than subtracting each. A word in its range has a negative: |raw| < 2^(W-1).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace

from qcone.formats.fixed import Signal
from qcone.ir.detail import Aligned, Mac
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation, Routine, Statement, unused

WORTH = 2
"""Subtracted products that a negation has to serve; for a single one it costs what it saves."""


def negate(routine: Routine) -> Routine:
    """Return a routine of `mac` operations with factors of subtracted products negated once, where that pays."""
    negated = _chosen(routine)
    if not negated:
        return routine
    made: dict[int, int] = {}
    names = dict(routine.names)
    following = unused(routine)
    body: list[Statement] = []
    for statement in routine.body:
        if isinstance(statement, Operation) and isinstance(statement.detail, Mac):
            taken = _taken(statement.detail, negated)
            for value in taken:
                if value not in made:
                    made[value], following = following, following + 1
                    if value in names:
                        names[made[value]] = f"{names[value]}_negated"
                    body.append(
                        Operation(made[value], MachineOp.NEGATE, (value,), step=statement.step, format=negated[value])
                    )
            statement = _with(statement, statement.detail, {value: made[value] for value in taken})
        body.append(statement)
    return replace(routine, body=tuple(body), names=names)


def _chosen(routine: Routine) -> dict[int, Signal]:
    """Return the words to be negated: the one that serves most products first, until none serves enough."""
    formats = {
        each.result: each.format
        for each in routine.body
        if isinstance(each, Operation) and isinstance(each.format, Signal)
    }
    left = [term.args for each in _macs(routine) for term in each.terms if _subtracted(term)]
    chosen: dict[int, Signal] = {}
    while True:
        uses = Counter(arg for args in left for arg in args)
        most = max(uses.values(), default=0)
        if most < WORTH:
            return chosen
        value = min(arg for arg, times in uses.items() if times == most)
        chosen[value] = formats[value]
        left = [args for args in left if value not in args]


def _macs(routine: Routine) -> Iterable[Mac]:
    """Yield the sums that are made in a double word of 64 bits."""
    for statement in routine.body:
        mac = statement.detail if isinstance(statement, Operation) else None
        if isinstance(mac, Mac) and mac.accumulator == 64:
            yield mac


def _subtracted(term: Aligned) -> bool:
    """Tell whether a term is a subtracted product of two words; a square has no factor to be negated alone."""
    return term.negative and len(term.args) == 2 and term.args[0] != term.args[1]


def _taken(mac: Mac, negated: dict[int, Signal]) -> tuple[int, ...]:
    """Return the words that a sum takes negated, in its order."""
    if mac.accumulator != 64:
        return ()
    found = (_factor(term, negated) for term in mac.terms if _subtracted(term))
    return tuple(dict.fromkeys(value for value in found if value is not None))


def _factor(term: Aligned, negated: dict[int, Signal]) -> int | None:
    return next((arg for arg in negated if arg in term.args), None)


def _with(operation: Operation, mac: Mac, made: dict[int, int]) -> Operation:
    """Return a sum that adds what it subtracted, of the negated words in `made`."""
    terms: list[Aligned] = []
    for term in mac.terms:
        value = next((arg for arg in made if arg in term.args), None) if _subtracted(term) else None
        if value is not None:
            args = tuple(made[value] if arg == value else arg for arg in term.args)
            term = replace(term, args=args, negative=False)
        terms.append(term)
    args = tuple(dict.fromkeys(arg for term in terms for arg in term.args))
    return replace(operation, args=args, detail=replace(mac, terms=tuple(terms)))
