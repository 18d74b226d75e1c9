"""Guard: clamp every word that is handed in, so that nothing relies on its being in the declared range."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from qcone.ir.detail import Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Routine, Statement, unused
from qcone.passes.rebuild import rebuild


def guarded(routine: Routine, given: set[str], limits: dict[int, Fraction]) -> Routine:
    """Return the routine with every word that is handed in clamped; what to is added to `limits`."""
    renamed: dict[int, int] = {}
    fresh = unused(routine)

    def visit(operation: Operation) -> Iterable[Statement]:
        nonlocal fresh
        if isinstance(operation.detail, Sum):
            terms = tuple(
                replace(term, args=tuple(renamed.get(arg, arg) for arg in term.args)) for term in operation.detail.terms
            )
            operation = replace(operation, detail=replace(operation.detail, terms=terms))
        if operation.place is None or operation.place.block not in given:
            return (operation,)
        detail = Sum((Term(Fraction(1), (operation.result,)),))
        guard = Operation(fresh, RealOp.SUM, (operation.result,), step=operation.step, detail=detail)
        limits[fresh] = limits[operation.result]
        names[fresh] = f"{names.get(operation.result, 'given')}_clamped"
        renamed[operation.result] = fresh
        fresh += 1
        return (operation, guard)

    names = dict(routine.names)
    body = rebuild(routine.body, visit, renamed)
    return replace(routine, body=body, names=names)
