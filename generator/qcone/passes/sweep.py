"""Sweep away what nothing uses: exact."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from qcone.ir.statement import Call, Operation, Routine, Statement, Write, walk
from qcone.passes.rebuild import rebuild


def sweep(routine: Routine) -> Routine:
    """Return the routine without operations whose value is never used."""
    while True:
        used: set[int] = set()
        for statement in walk(routine.body):
            match statement:
                case Operation() | Call():
                    used.update(statement.args)
                case Write():
                    used.add(statement.value)

        def visit(operation: Operation, used: set[int] = used) -> Iterable[Statement]:
            return (operation,) if operation.result in used else ()

        body = rebuild(routine.body, visit, {})
        if body == routine.body:
            callees = {name: sweep(callee) for name, callee in routine.callees.items()}
            return replace(routine, callees=callees)
        routine = replace(routine, body=body)
