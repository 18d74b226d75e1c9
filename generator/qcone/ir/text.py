"""A routine as text: stable, for people and for tests that assert what a pass leaves behind."""

from __future__ import annotations

from collections.abc import Iterator

from qcone.ir.statement import Advance, Call, Choose, Loop, Operation, Program, Ready, Routine, Statement, Write


def dump(routine: Routine) -> str:
    """Return the routine, one statement a line, steps as headings."""
    lines = [f"routine {routine.name}"]
    for block in routine.blocks:
        many = f"{block.count} x " if block.count > 1 else ""
        lines.append(f"  {block.role.value} {block.name}: {many}{block.shape.name.lower()}")
    shown = None
    for depth, statement in _flat(routine.body, 1):
        if statement.step != shown:
            shown = statement.step
            step = routine.steps[shown]
            if step.text:
                lines.append(f"  # {step.text}" + (f"  [{step.equation}]" if step.equation else ""))
        lines.append("  " * depth + _line(statement, routine))
    for callee in routine.callees.values():
        lines.append("")
        lines.extend(dump(callee).splitlines())
    return "\n".join(lines) + "\n"


def dump_program(program: Program) -> str:
    """Return every routine of the program."""
    return "\n".join(dump(routine) for routine in program.routines)


def _flat(body: tuple[Statement, ...], depth: int) -> Iterator[tuple[int, Statement]]:
    for statement in body:
        yield depth, statement
        if isinstance(statement, Loop):
            yield from _flat(statement.body, depth + 1)


def _line(statement: Statement, routine: Routine) -> str:
    def name(value: int) -> str:
        return routine.names.get(value, f"%{value}")

    match statement:
        case Operation(result, op, args, constant, place):
            operands = [name(arg) for arg in args]
            operands += [str(constant)] if constant is not None else []
            operands += [str(place)] if place is not None else []
            typed = f" : {getattr(statement.format, 'name', statement.format)}" if statement.format else ""
            return f"{name(result)} = {op.value} {', '.join(operands)}{typed}"
        case Write(place, value):
            return f"{place} := {name(value)}"
        case Loop(counter, first, last):
            return f"for {counter} in {first} .. {last}"
        case Call(callee, args, results):
            return f"{', '.join(map(name, results))} = call {callee}({', '.join(map(name, args))})"
        case Ready(place, limit):
            return f"return {place} >= {limit}"
        case Advance(place):
            return f"{place} := {place} + 1"
        case Choose(place, cases, otherwise):
            below = "; ".join(f"below {limit}: {routine_name}" for limit, routine_name in cases)
            return f"choose by {place}: {below}; otherwise: {otherwise}"
    raise AssertionError(statement)
