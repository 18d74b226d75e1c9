"""Share common sub-expressions: exact. The same operation on the same values is done once.

Operands of + and * are compared in either order, which IEEE 754 allows: both orders give the same bits.
Values of a loop are shared inside it; reads of what loops write are not shared at all.
"""

from __future__ import annotations

from dataclasses import replace

from qcone.ir.operations import RealOp
from qcone.ir.statement import Loop, Operation, Role, Routine, Statement
from qcone.passes.rebuild import rebuild, regrouped

_COMMUTATIVE = {RealOp.ADD, RealOp.MULTIPLY}


def share(routine: Routine) -> Routine:
    """Return the routine with repeated operations done once."""
    steady = {block.name for block in routine.blocks if block.role in (Role.INPUT, Role.STATE, Role.TABLE)}
    names = dict(routine.names)
    renamed: dict[int, int] = {}
    body = _scope(routine.body, {}, renamed, steady, names)
    callees = {name: share(callee) for name, callee in routine.callees.items()}
    return replace(routine, body=body, names=names, groups=regrouped(routine.groups, renamed), callees=callees)


def _scope(
    body: tuple[Statement, ...],
    outer: dict[object, int],
    renamed: dict[int, int],
    steady: set[str],
    names: dict[int, str],
) -> tuple[Statement, ...]:
    seen = dict(outer)

    def visit(operation: Operation) -> tuple[Statement, ...]:
        if operation.place is not None and operation.place.block not in steady:
            return (operation,)
        args = tuple(sorted(operation.args)) if operation.op in _COMMUTATIVE else operation.args
        key = (operation.op, args, operation.constant, operation.place)
        first = seen.setdefault(key, operation.result)
        if first == operation.result:
            return (operation,)
        renamed[operation.result] = first
        if operation.result in names:
            names.setdefault(first, names[operation.result])
        return ()

    result: list[Statement] = []
    for statement in body:
        if isinstance(statement, Loop):
            inner = _scope(statement.body, seen, renamed, steady, names)
            result.append(replace(statement, body=inner))
        else:
            result.extend(rebuild((statement,), visit, renamed))
    return tuple(result)
