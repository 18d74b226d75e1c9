"""Give every value a name a reviewer can follow: the author's, or the nearest named result's with a number.

The second product on the way to `coning_x` becomes `coning_x_2`. Exact: names change no bit.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from qcone.ir.identifier import KEYWORDS, identifier
from qcone.ir.machine import MachineOp
from qcone.ir.statement import SUFFIXES, Call, Loop, Operation, Place, Routine, Statement, Write, walk


def name_values(routine: Routine, reserved: Iterable[str] = ()) -> Routine:
    """Return the routine with a distinct C identifier for every value; literals are printed where they are used.

    Of what a call gives, only the used results are named; the first name with `_result` is free for their array.
    """
    taken = set(reserved) | KEYWORDS | {block.name for block in routine.blocks}
    taken |= {each.counter for each in walk(routine.body) if isinstance(each, Loop)}
    consumers = _first_consumers(routine)
    values = _values(routine, consumers)
    names: dict[int, str] = {}
    for value, ending in values.items():
        if value in routine.names:
            names[value] = _free(identifier(routine.names[value]), ending, taken)
    counts: dict[str, int] = {}
    for value, ending in values.items():
        if value in names:
            continue
        base = _base(value, consumers, names, routine)
        number = counts.get(base, 0)
        while True:
            number += 1
            if f"{base}_{number}" not in taken:
                break
        counts[base] = number
        names[value] = _free(f"{base}_{number}", ending, taken)
    callees = {name: name_values(callee, reserved) for name, callee in routine.callees.items()}
    return replace(routine, names=names, callees=callees)


def _free(wanted: str, ending: str, taken: set[str]) -> str:
    """Return the name, numbered where it, or it with the ending, is taken; both are taken from there on."""
    name, number = wanted, 1
    while not taken.isdisjoint((name, name + ending)):
        number += 1
        name = f"{wanted}_{number}"
    taken.update((name, name + ending))
    return name


def _values(routine: Routine, consumers: dict[int, Statement]) -> dict[int, str]:
    """Return the values to be named, in order, each with the ending that must be free beside its name."""
    values: dict[int, str] = {}
    for statement in walk(routine.body):
        if isinstance(statement, Operation) and statement.op is not MachineOp.LITERAL:
            values[statement.result] = ""
        elif isinstance(statement, Call):
            used = [result for result in statement.results if result in consumers]
            values.update({result: "_result" if result == used[0] else "" for result in used})
    return values


def _first_consumers(routine: Routine) -> dict[int, Statement]:
    """Return, for each value, the first statement that uses it."""
    consumers: dict[int, Statement] = {}
    for statement in walk(routine.body):
        match statement:
            case Operation() | Call():
                for arg in statement.args:
                    consumers.setdefault(arg, statement)
            case Write():
                consumers.setdefault(statement.value, statement)
    return consumers


def _base(value: int, consumers: dict[int, Statement], names: dict[int, str], routine: Routine) -> str:
    """Follow a value to the first named result it leads to, or to the component it is written to."""
    while True:
        match consumers.get(value):
            case Operation(result):
                if result in names:
                    return names[result]
                value = result
            case Write(place):
                return _component(routine, place)
            case Call(called):
                return called
            case _:
                return "value"


def _component(routine: Routine, place: Place) -> str:
    """Return how a written component is called: `c_nb_31`, or the block's name where a loop counts it."""
    block = routine.block(place.block)
    if place.index.terms or block.count > 1:
        return block.name
    return block.name + SUFFIXES[block.shape][place.index.constant]
