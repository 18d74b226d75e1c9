"""Give every value a name a reviewer can follow: the author's, or the nearest named result's with a number.

The second product on the way to `coning_x` becomes `coning_x_2`. Exact: names change no bit.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from qcone.ir.machine import MachineOp
from qcone.ir.statement import SUFFIXES, Call, Loop, Operation, Place, Routine, Statement, Write, walk

C_KEYWORDS = frozenset(
    """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while asm bool true
    false class new delete this template namespace operator private public protected try catch
    """.split()  # noqa: SIM905  a list of words is read more easily as words
)
"""Words that are no identifiers in C or C++."""


def name_values(routine: Routine, reserved: Iterable[str] = ()) -> Routine:
    """Return the routine with a distinct C identifier for every value; literals are printed where they are used."""
    taken = set(reserved) | C_KEYWORDS | {block.name for block in routine.blocks}
    taken |= {each.counter for each in walk(routine.body) if isinstance(each, Loop)}
    consumers = _first_consumers(routine)
    values = _values(routine)
    names: dict[int, str] = {}
    for value in values:
        if value in routine.names:
            names[value] = _free(routine.names[value], taken)
    counts: dict[str, int] = {}
    for value in values:
        if value in names:
            continue
        base = _base(value, consumers, names, routine)
        number = counts.get(base, 0)
        while True:
            number += 1
            if f"{base}_{number}" not in taken:
                break
        counts[base] = number
        names[value] = _free(f"{base}_{number}", taken)
    callees = {name: name_values(callee, reserved) for name, callee in routine.callees.items()}
    return replace(routine, names=names, callees=callees)


def _free(wanted: str, taken: set[str]) -> str:
    name, number = wanted, 1
    while name in taken:
        number += 1
        name = f"{wanted}_{number}"
    taken.add(name)
    return name


def _values(routine: Routine) -> list[int]:
    values: list[int] = []
    for statement in walk(routine.body):
        if isinstance(statement, Operation) and statement.op is not MachineOp.LITERAL:
            values.append(statement.result)
        elif isinstance(statement, Call):
            values.extend(statement.results)
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
    statement = consumers.get(value)
    match statement:
        case Operation():
            return names.get(statement.result) or _base(statement.result, consumers, names, routine)
        case Write(place):
            return _component(routine, place)
        case Call():
            return statement.routine
    return "value"


def _component(routine: Routine, place: Place) -> str:
    """Return how a written component is called: `c_nb_31`, or the block's name where a loop counts it."""
    block = routine.block(place.block)
    if place.index.terms or block.count > 1:
        return block.name
    return block.name + SUFFIXES[block.shape][place.index.constant]
