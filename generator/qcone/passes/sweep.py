"""Sweep away what nothing uses, histories and tables that a written-out loop has left behind among it: exact."""

from __future__ import annotations

from dataclasses import replace

from qcone.ir.statement import Call, Loop, Operation, Role, Routine, Statement, Write, walk


def sweep(routine: Routine) -> Routine:
    """Return the routine without operations and calls whose values are never used, and without unread local blocks."""
    while True:
        body = _kept(routine.body, _used(routine), _read(routine))
        if body == routine.body:
            break
        routine = replace(routine, body=body)
    read = _read(routine)
    blocks = tuple(
        block for block in routine.blocks if block.role not in (Role.LOCAL, Role.TABLE) or block.name in read
    )
    called = {each.routine for each in walk(routine.body) if isinstance(each, Call)}
    callees = {name: sweep(callee) for name, callee in routine.callees.items() if name in called}
    return replace(routine, blocks=blocks, callees=callees)


def _used(routine: Routine) -> set[int]:
    used: set[int] = set()
    for statement in walk(routine.body):
        match statement:
            case Operation() | Call():
                used.update(statement.args)
            case Write():
                used.add(statement.value)
    return used


def _read(routine: Routine) -> set[str]:
    """Return the names of the blocks that are read, and of those that others see."""
    places = (each.place for each in walk(routine.body) if isinstance(each, Operation) and each.place)
    seen = {block.name for block in routine.blocks if block.role in (Role.STATE, Role.OUTPUT)}
    return seen | {place.block for place in places}


def _kept(body: tuple[Statement, ...], used: set[int], read: set[str]) -> tuple[Statement, ...]:
    kept: list[Statement] = []
    for statement in body:
        match statement:
            case Operation(result) if result not in used:
                continue
            case Call() if used.isdisjoint(statement.results):
                continue
            case Write(place) if place.block not in read:
                continue
            case Loop():
                inner = _kept(statement.body, used, read)
                if inner:
                    kept.append(replace(statement, body=inner))
            case _:
                kept.append(statement)
    return tuple(kept)
