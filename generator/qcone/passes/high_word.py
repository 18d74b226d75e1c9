"""High word: choose fraction bits so that 32 bits are dropped, where a core has an instruction for just that.

Rounding a 64-bit sum by 32 bits is taking its upper word: one multiply instruction on many cores, no shift. A value
whose sum drops fewer bits gives some of its own up, as long as the error this adds to the new attitude stays far
below the last bit of a word. The search is greedy, round by round.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.fixed import Signal
from qcone.ir.detail import Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Write
from qcone.passes.choices import Formats
from qcone.passes.qassign import Assigner

WORD = 32
LEAST = 22
"""A sum that drops fewer bits than this would lose too many to drop a whole word."""
ROUNDS = 8
SEEN = {False: Fraction(1, 2**37), True: Fraction(1, 2**43)}
"""What one value's rounding may add to the attitude, where updates are rounded to a word, and where they are carried:
2^-7 and 2^-13 of its last bit."""
ALIGNED = 32
"""How much more where it saves a shift of every other product of a sum."""
LONE = 128
"""How much more for a product that is a sum of its own: product and rounding become one instruction."""


@dataclass(frozen=True)
class HighWord:
    """What the search did: sums of double words before and after that drop a whole one, and the error bounds."""

    before: int
    after: int
    sums: int
    error_before: Fraction
    error_after: Fraction


def high_word(assigner: Assigner, found: Formats, carried: bool) -> tuple[Formats, HighWord]:
    """Return formats of more whole words dropped, and what that cost. `carried` says that roundings are."""
    first = _state(assigner, found)
    best, known = found, first
    for _ in range(ROUNDS):
        changes = _changes(assigner, best, known, SEEN[carried])
        if not changes:
            break
        caps = dict(assigner.choices.caps)
        for value, bits in changes.items():
            if value in assigner.pins:
                continue
            assigner.choices.caps[value] = min(bits, assigner.choices.caps.get(value, bits))
        try:
            tried = assigner.run()
        except UsageError:
            assigner.choices.caps = caps
            break
        now = _state(assigner, tried)
        if now.whole < known.whole:
            assigner.choices.caps = caps
            best = assigner.run()
            break
        best, known = tried, now
    last = _state(assigner, best)
    return best, HighWord(first.whole, last.whole, last.sums, first.total, last.total)


@dataclass(frozen=True)
class _State:
    weights: dict[int, Fraction]
    dropped: dict[int, int]
    made: frozenset[int]
    """Values that are sums: those whose bits are a choice."""
    lone: frozenset[int]
    """Sums of one product."""
    total: Fraction

    @property
    def whole(self) -> int:
        return sum(1 for bits in self.dropped.values() if bits == WORD)

    @property
    def sums(self) -> int:
        return len(self.dropped)


def _state(assigner: Assigner, found: Formats) -> _State:
    weights = _weights(found)
    dropped: dict[int, int] = {}
    errors: list[Fraction] = []
    for statement in found.routine.body:
        if not isinstance(statement, Operation) or not isinstance(statement.detail, Sum):
            continue
        signal = found.signals[statement.result]
        finest, _ = found.accumulated(statement)
        bits = finest - signal.fraction
        product = any(len(term.args) == 2 or not _free(term.coefficient) for term in statement.detail.terms)
        if product and signal.width == assigner.number.width == WORD:
            dropped[statement.result] = bits
        if bits > 0 and not statement.detail.carried:
            errors.append(weights.get(statement.result, Fraction(0)) * signal.lsb / 2)
    made = frozenset(
        each.result
        for each in found.routine.body
        if isinstance(each, Operation) and each.op in (RealOp.SUM, RealOp.WIDE)
    )
    lone = frozenset(
        each.result
        for each in found.routine.body
        if isinstance(each, Operation) and isinstance(each.detail, Sum) and len(each.detail.terms) == 1
    )
    return _State(weights, dropped, made, lone, sum(errors, Fraction(0)))


def _free(coefficient: Fraction) -> bool:
    top, bottom = abs(coefficient.numerator), coefficient.denominator
    return top & (top - 1) == 0 and bottom & (bottom - 1) == 0


def _weights(found: Formats) -> dict[int, Fraction]:
    """Return how far an error of each value moves what is written, at most, in the first order."""
    assert found.magnitudes is not None
    of = found.magnitudes.of
    weights: dict[int, Fraction] = {}
    for statement in found.routine.body:
        if isinstance(statement, Write):
            weights[statement.value] = Fraction(1)
    scalars = _scalars(found)
    for statement in reversed(found.routine.body):
        if not isinstance(statement, Operation) or not isinstance(statement.detail, Sum):
            continue
        weight = weights.get(statement.result, Fraction(0))
        if statement.result in scalars:
            weight = weights[statement.result] = min(weight, scalars[statement.result])
        for term in statement.detail.terms:
            for at, arg in enumerate(term.args):
                size = abs(term.coefficient)
                for other in (*term.args[:at], *term.args[at + 1 :]):
                    size *= of(other)
                weights[arg] = weights.get(arg, Fraction(0)) + weight * size
    return weights


def _scalars(found: Formats) -> dict[int, Fraction]:
    """Return the values of a rotation's scalar part, and how much an error of them counts.

    An error d of it makes the new attitude longer, which is brought back, and turns it by |v| d less.
    """
    assert found.magnitudes is not None
    scalars: dict[int, Fraction] = {}
    for group in found.routine.groups:
        if group.kind == "rotated":
            across = found.magnitudes.norm(group.operands[2])
            for operand in (group.operands[1], *group.operands[4:]):
                values = found.routine.groups[operand].values
                if len(values) == 1 and across is not None:
                    scalars[values[0]] = across[1]
    return scalars


def _changes(assigner: Assigner, found: Formats, known: _State, seen: Fraction) -> dict[int, int]:
    """Return fraction bits for values that can do with fewer, so that their sums drop a whole word."""
    changes: dict[int, int] = {}
    for value, bits in known.dropped.items():
        if not LEAST <= bits < WORD or value in assigner.choices.forced:
            continue
        signal: Signal = found.signals[value]
        wanted = signal.fraction - (WORD - bits)
        added = known.weights.get(value, Fraction(0)) * Fraction(2) ** -(wanted + 1)
        if added <= seen * (LONE if value in known.lone else 1):
            changes[value] = wanted
    if not changes:
        for statement in found.routine.body:
            if isinstance(statement, Operation) and isinstance(statement.detail, Sum):
                changes |= _fewer(assigner, found, known, statement, seen)
    return changes


def _fewer(assigner: Assigner, found: Formats, known: _State, operation: Operation, seen: Fraction) -> dict[int, int]:
    """Return fewer bits for the factors of a sum's finest products, so that all are on one binary point."""
    assert isinstance(operation.detail, Sum)
    _, bits = found.accumulated(operation)
    products = [
        (term, each)
        for term, each in zip(operation.detail.terms, bits, strict=True)
        if len(term.args) == 2 and each is not None
    ]
    if len(products) < 2:
        return {}
    wanted = min(each for _, each in products)
    changes: dict[int, int] = {}
    for term, each in products:
        if each == wanted:
            continue
        fewer = _factor(assigner, found, known, term, each - wanted, seen)
        if fewer is None:
            return {}
        changes[fewer] = found.signals[fewer].fraction - (each - wanted)
    return changes


def _factor(assigner: Assigner, found: Formats, known: _State, term: Term, less: int, seen: Fraction) -> int | None:
    """Return a factor that can do with so many bits less; None where none can."""
    for value in sorted(term.args, key=lambda arg: known.weights.get(arg, Fraction(0))):
        if value in assigner.choices.forced or value not in known.made or term.args[0] == term.args[1]:
            continue
        added = known.weights.get(value, Fraction(0)) * found.signals[value].lsb * 2 ** (less - 1)
        if added <= seen * ALIGNED:
            return value
    return None
