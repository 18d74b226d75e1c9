"""Errors: how far what a routine computes can be from exact arithmetic, by running every bound forwards.

|fl(x) - x| <= E(x): a sum adds its terms' errors, a product a b adds |a| E(b) + |b| E(a) + E(a) E(b), and every
rounding adds its own. Constants count as what they were rounded from. Inputs and state count as exact: so it is the
error of one update from the attitude before it.
"""

from __future__ import annotations

from fractions import Fraction

from qcone.ir.detail import Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation
from qcone.passes.choices import Formats, nearest
from qcone.passes.qassign import Assigner

ZERO = Fraction(0)


def errors(assigner: Assigner, found: Formats) -> dict[int, Fraction]:
    """Return a bound of every value's error; a routine that selects or divides has bounds up to there only."""
    bounds: dict[int, Fraction] = {}
    for statement in found.routine.body:
        if not isinstance(statement, Operation):
            continue
        if statement.op is RealOp.READ:
            bounds[statement.result] = ZERO
        elif statement.constant is not None and statement.op is RealOp.CONSTANT:
            lsb = found.signals[statement.result]
            bounds[statement.result] = abs(nearest(statement.constant, lsb) - statement.constant)
        elif isinstance(statement.detail, Sum) and all(arg in bounds for arg in statement.args):
            bounds[statement.result] = _sum(assigner, found, statement, bounds)
        elif statement.op is RealOp.CLAMP and statement.args[0] in bounds:
            bounds[statement.result] = bounds[statement.args[0]] + found.signals[statement.result].lsb
    return bounds


def _sum(assigner: Assigner, found: Formats, operation: Operation, bounds: dict[int, Fraction]) -> Fraction:
    assert isinstance(operation.detail, Sum)
    total = assigner.own_error(found, operation)
    for term in operation.detail.terms:
        total += _term(found, term, bounds)
    return total


def _term(found: Formats, term: Term, bounds: dict[int, Fraction]) -> Fraction:
    assert found.magnitudes is not None
    size = abs(term.coefficient)
    if len(term.args) == 1:
        return size * bounds[term.args[0]]
    if len(term.args) == 2:
        a, b = term.args
        of = found.magnitudes.of
        return size * (of(a) * bounds[b] + of(b) * bounds[a] + bounds[a] * bounds[b])
    return ZERO
