"""Walk a body and rebuild it, renaming values on the way: what every pass over statements has in common."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from qcone.ir.statement import Advance, Call, Choose, Group, Loop, Operation, Ready, Statement, Write

Visit = Callable[[Operation], Iterable[Statement]]


def rebuild(body: tuple[Statement, ...], visit: Visit, renamed: dict[int, int]) -> tuple[Statement, ...]:
    """Return the body with every operation replaced by what `visit` gives for it.

    `visit` sees operations whose operands are renamed already, and may add to `renamed` to stand one
    value in for another from there on.
    """
    result: list[Statement] = []
    for statement in body:
        match statement:
            case Operation():
                args = tuple(renamed.get(arg, arg) for arg in statement.args)
                result.extend(visit(replace(statement, args=args)))
            case Write():
                result.append(replace(statement, value=renamed.get(statement.value, statement.value)))
            case Loop():
                result.append(replace(statement, body=rebuild(statement.body, visit, renamed)))
            case Call():
                result.append(replace(statement, args=tuple(renamed.get(arg, arg) for arg in statement.args)))
            case Advance() | Choose() | Ready():
                result.append(statement)
    return tuple(result)


def regrouped(groups: tuple[Group, ...], renamed: Mapping[int, int]) -> tuple[Group, ...]:
    """Return the groups over the values that stand for theirs now: bounds follow a value under its new name."""
    return tuple(
        replace(group, values=tuple(final(value, renamed) for value in group.values))
        if any(value in renamed for value in group.values)
        else group
        for group in groups
    )


def final(value: int, renamed: Mapping[int, int]) -> int:
    """Return what stands for a value in the end."""
    while value in renamed:
        value = renamed[value]
    return value


def names_after(names: Mapping[int, str], renamed: Mapping[int, int]) -> dict[int, str]:
    """Return the names of values where some stand in for others: a value without a name takes that of the one gone."""
    kept = dict(names)
    for gone, stand_in in renamed.items():
        if gone in kept:
            kept.setdefault(stand_in, kept[gone])
    return kept
