"""Fold exact constants: exact. What is known before run time is calculated over the rationals.

x + 0 and x * 0 stay as they are: a sum with zero is not x for a negative zero, nor a product 0 for NaN.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from fractions import Fraction

from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Routine, Statement
from qcone.passes.rebuild import names_after, rebuild, regrouped

_EXACT: Mapping[object, Callable[..., Fraction | None]] = {
    RealOp.ADD: lambda a, b: a + b,
    RealOp.SUBTRACT: lambda a, b: a - b,
    RealOp.MULTIPLY: lambda a, b: a * b,
    RealOp.DIVIDE: lambda a, b: a / b if b else None,
    RealOp.NEGATE: lambda a: -a,
}


def fold(routine: Routine) -> Routine:
    """Return the routine with constant operations calculated, and products with 1 and -1 left out."""
    known: dict[int, Fraction] = {}
    renamed: dict[int, int] = {}

    def visit(operation: Operation) -> Iterable[Statement]:
        if operation.op is RealOp.CONSTANT and operation.constant is not None:
            known[operation.result] = operation.constant
            return (operation,)
        if operation.op in _EXACT and all(arg in known for arg in operation.args):
            value = _EXACT[operation.op](*(known[arg] for arg in operation.args))
            if value is not None:
                known[operation.result] = value
                return (replace(operation, op=RealOp.CONSTANT, args=(), constant=value),)
        if operation.op is RealOp.MULTIPLY:
            for factor, other in (operation.args, operation.args[::-1]):
                if known.get(factor) == 1:
                    renamed[operation.result] = other
                    return ()
                if known.get(factor) == -1:
                    return (replace(operation, op=RealOp.NEGATE, args=(other,)),)
        return (operation,)

    body = rebuild(routine.body, visit, renamed)
    names = names_after(routine.names, renamed)
    callees = {name: fold(callee) for name, callee in routine.callees.items()}
    return replace(routine, body=body, names=names, groups=regrouped(routine.groups, renamed), callees=callees)
