"""Signatures of C functions: what a routine is handed, what it gives, and what of it the routine uses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from qcone.ir.statement import Advance, Block, Call, Choose, Operation, Role, Routine, Write, walk

INDENT = "    "
LINE = 105


def parameters(routine: Routine) -> tuple[Block, ...]:
    """Return the array arguments of a routine's function, in order: inputs, then outputs."""
    return (*routine.having(Role.INPUT), *routine.having(Role.OUTPUT))


def signature_of(start: str, arguments: Sequence[str]) -> str:
    """Return a signature on one line, or with its arguments on lines of their own where it would be too long."""
    given = ", ".join(arguments) or "void"
    if len(start) + len(given) <= LINE:
        return f"{start}({given})"
    rows = [arguments[0]]
    for argument in arguments[1:]:
        if len(f"{INDENT}{rows[-1]}, {argument}") <= LINE:
            rows[-1] += f", {argument}"
        else:
            rows.append(argument)
    return f"{start}(\n{INDENT}" + f",\n{INDENT}".join(rows) + ")"


def remarked(text: str, remark: str) -> Iterator[str]:
    """Yield a statement with a remark beside it, or above it where the line would be too long."""
    if len(text) + len(remark) + 2 > LINE:
        yield remark
        yield from text.splitlines()
    else:
        yield f"{text}  {remark}" if remark else text


def components(block: Block) -> list[str]:
    """Return the names of a callee's scalar arguments."""
    return [f"{block.name}_in{i}" for i in range(block.size)]


def result_array(call: Call, routine: Routine) -> str:
    """Return how the array is called that takes what a call gives: after its first result that is used."""
    return f"{next(routine.names[result] for result in call.results if result in routine.names)}_result"


def gives(callee: Routine) -> Operation:
    """Return the operation that makes what a callee returns by value."""
    (value,) = (each.value for each in callee.body if isinstance(each, Write))
    return next(each for each in callee.body if isinstance(each, Operation) and each.result == value)


def unused(routine: Routine, scalar: bool) -> list[str]:
    """Return the input arguments of a routine's function that its body does not look at."""
    read = [each.place for each in walk(routine.body) if isinstance(each, Operation) and each.place]
    if any(isinstance(each, Choose) for each in routine.body):
        return []
    if scalar:
        seen = {f"{place.block}_in{place.index.constant}" for place in read}
        return [name for block in routine.having(Role.INPUT) for name in components(block) if name not in seen]
    return [block.name for block in routine.having(Role.INPUT) if all(place.block != block.name for place in read)]


def writes_state(routine: Routine) -> bool:
    """Tell whether a routine changes the state."""
    for statement in walk(routine.body):
        if isinstance(statement, Advance | Choose):
            return True
        if isinstance(statement, Write) and routine.block(statement.place.block).role is Role.STATE:
            return True
    return False
