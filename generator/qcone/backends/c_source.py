"""C text of machine routines: one operation a statement, blocks under their equations. The printer decides nothing."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from qcone.backends import c_fixed
from qcone.backends.c_signature import (
    INDENT,
    LINE,
    components,
    gives,
    parameters,
    remarked,
    result_array,
    signature_of,
    unused,
    writes_state,
)
from qcone.backends.c_state import field, type_of
from qcone.formats.fixed import Fixed, Signal
from qcone.formats.floating import Floating
from qcone.ir.machine import MachineOp
from qcone.ir.statement import (
    Advance,
    Call,
    Choose,
    Loop,
    Operation,
    Place,
    Program,
    Ready,
    Role,
    Routine,
    Statement,
    Write,
    walk,
)

SIGNS = {
    MachineOp.ADD: "+",
    MachineOp.SUBTRACT: "-",
    MachineOp.MULTIPLY: "*",
    MachineOp.DIVIDE: "/",
}
MOST_DENOMINATOR = 10**30
INTERNAL = frozenset({"hold", "start_up", "steady"})
"""Routines that only `update` calls: static."""


@dataclass(frozen=True)
class Function:
    """One C function: its signature without the semicolon, its body line by line, and whether it is internal."""

    routine: str
    signature: str
    body: tuple[str, ...]
    internal: bool


class UnprintableError(Exception):
    """An operation that no pass has lowered to the machine language."""


def functions(program: Program, number: Floating | Fixed) -> tuple[Function, ...]:
    """Return every function of the program, callees before their callers."""
    done: dict[str, Function] = {}
    for routine in program.routines:
        for callee in _callees(routine):
            if callee.name not in done:
                done[callee.name] = _scalar_function(callee, program, number)
        done[routine.name] = _function(routine, program, number)
    return tuple(done.values())


def _callees(routine: Routine) -> Iterator[Routine]:
    for callee in routine.callees.values():
        yield from _callees(callee)
        yield callee


def _function(routine: Routine, program: Program, number: Floating | Fixed) -> Function:
    arguments = []
    if routine.having(Role.STATE):
        arguments.append(f"{'' if writes_state(routine) else 'const '}{program.name}_state *state")
    for block in parameters(routine):
        const = "const " if block.role is Role.INPUT else ""
        arguments.append(f"{const}{type_of(block, number)} {block.name}[{block.size}]")
    name = f"{program.name}_{routine.name}"
    internal = routine.name in INTERNAL
    returns = "int" if any(isinstance(each, Ready) for each in routine.body) else "void"
    signature = signature_of(f"{'static ' if internal else ''}{returns} {name}", arguments)
    return Function(routine.name, signature, tuple(_Printer(routine, program, number).lines()), internal)


def _scalar_function(routine: Routine, program: Program, number: Floating | Fixed) -> Function:
    """Print a callee: scalars in by value, results out through one array, or returned where that is so."""
    names = [f"const {number.ctype} {part}" for block in routine.having(Role.INPUT) for part in components(block)]
    size = sum(block.size for block in routine.having(Role.OUTPUT))
    returns = number.ctype if routine.by_value else "void"
    results = [] if routine.by_value else [f"{number.ctype} result[{size}]"]
    signature = signature_of(f"static {returns} {program.name}_{routine.name}", [*names, *results])
    printer = _Printer(routine, program, number, scalar=True)
    return Function(routine.name, signature, tuple(printer.lines()), True)


def literal(constant: Fraction, exact: Fraction | None, number: Floating | Fixed, signal: Signal | None = None) -> str:
    """Return a literal, with the rational it was rounded from beside it.

    Not beside a multiple of 1/8, nor where the rational is that of an irrational number such as pi.
    """
    if signal is not None:
        text = c_fixed.literal(constant, signal)
        return text if exact is None or not exact or exact.denominator > MOST_DENOMINATOR else f"{text} /* {exact} */"
    assert isinstance(number, Floating)
    text = number.literal(constant)
    plain = exact is None or 8 % exact.denominator == 0 or exact.denominator > MOST_DENOMINATOR
    return text if plain else f"{text} /* {exact} */"


def _filled(entries: Sequence[str], indent: str) -> Iterator[str]:
    """Yield entries of an initialiser in lines, a comment beside its entry."""
    line = indent + entries[0]
    for entry in entries[1:]:
        if len(f"{line}, {entry},") > LINE:
            yield f"{line},"
            line = indent + entry
        else:
            line = f"{line}, {entry}"
    yield line


class _Printer:
    def __init__(self, routine: Routine, program: Program, number: Floating | Fixed, scalar: bool = False) -> None:
        self.routine, self.program, self.number, self.scalar = routine, program, number, scalar
        literals = [
            (each, each.constant)
            for each in walk(routine.body)
            if isinstance(each, Operation) and each.op is MachineOp.LITERAL and each.constant is not None
        ]
        self.constants = {each.result: constant for each, constant in literals}
        self.literals = {
            each.result: literal(constant, each.exact, number, each.format if isinstance(each.format, Signal) else None)
            for each, constant in literals
        }
        self.integers = c_fixed.IntegerText(routine, number)
        self.shown: int | None = None

    def lines(self) -> Iterator[str]:
        """Yield the body, indented."""
        for block in self.routine.having(Role.TABLE):
            pairs = zip(block.entries, block.exact, strict=True)
            entries = [literal(entry, exact, self.number) for entry, exact in pairs]
            yield f"{INDENT}static const {self.number.ctype} {block.name}[{block.size}] = {{"
            yield from _filled(entries, INDENT * 2)
            yield f"{INDENT}}};"
        for block in self.routine.having(Role.LOCAL):
            yield f"{INDENT}{self.number.ctype} {block.name}[{block.size}];"
        for name in unused(self.routine, self.scalar):
            yield f"{INDENT}(void){name};"
        yield from self._body(self.routine.body, 1)

    def _body(self, body: Sequence[Statement], depth: int) -> Iterator[str]:
        indent = INDENT * depth
        for statement in body:
            if isinstance(statement, Operation) and statement.op is MachineOp.LITERAL:
                continue
            yield from self._heading(statement.step, indent)
            match statement:
                case Loop(counter, first, last, inner):
                    yield f"{indent}for (int32_t {counter} = {first}; {counter} <= {last}; ++{counter}) {{"
                    if inner[0].step != statement.step:
                        self.shown = None  # the heading inside stands right under the brace
                    yield from self._body(inner, depth + 1)
                    yield f"{indent}}}"
                case Ready(place, limit):
                    yield f"{indent}return ({self._place(place)} >= {limit}) ? 1 : 0;"
                case Choose(place, cases, otherwise):
                    yield from self._choose(place, cases, otherwise, indent)
                case _:
                    for line in self._simple(statement):
                        yield indent + line

    def _heading(self, number: int, indent: str) -> Iterator[str]:
        if number == self.shown:
            return
        if self.shown is not None:
            yield ""
        self.shown = number
        step = self.routine.steps[number]
        if step.text:
            text = f"{step.text}{f'   [{step.equation}]' if step.equation else ''}"
            text = text.replace("*/", "* /").replace("/*", "/ *")
            separator = f"\n{indent} * "
            lines = textwrap.wrap(text, LINE, break_long_words=False, break_on_hyphens=False)
            yield f"{indent}/* {separator.join(lines)} */"

    def _simple(self, statement: Statement) -> Iterator[str]:
        ctype = self.number.ctype
        match statement:
            case Operation(result, op, args, _, place):
                name = self.routine.names[result]
                if isinstance(statement.format, Signal):
                    remark = c_fixed.remark(statement)
                    text = f"const {statement.format.ctype} {name} = {self._integer(statement)};"
                    yield from remarked(text, remark)
                elif op in SIGNS:
                    yield f"const {ctype} {name} = {self._use(args[0])} {SIGNS[op]} {self._use(args[1])};"
                elif op is MachineOp.LESS:
                    yield f"const int32_t {name} = {self._use(args[0])} < {self._use(args[1])};"
                elif op is MachineOp.SELECT:
                    chosen = f"{self._use(args[1])} : {self._use(args[2])}"
                    yield f"const {ctype} {name} = ({self._use(args[0])} != 0) ? {chosen};"
                elif op is MachineOp.NEGATE:
                    yield f"const {ctype} {name} = -{self._use(args[0])};"
                elif op is MachineOp.READ and place is not None:
                    yield f"const {ctype} {name} = {self._place(place)};"
                else:
                    raise UnprintableError(f"{self.routine.name}: {op} must be lowered before it is printed")
            case Write(_, value) if self.routine.by_value:
                yield f"return {self._use(value)};"
            case Write(place, value):
                yield f"{self._place(place)} = {self._stored(place, value)};"
            case Advance(place):
                yield f"{self._place(place)} = {self._place(place)} + 1;"
            case Call(name, args, (result,)) if self.routine.callees[name].by_value:
                start = f"const {ctype} {self.routine.names[result]} = {self.program.name}_{name}"
                text = f"{signature_of(start, list(map(self._use, args)))};"
                yield from remarked(text, c_fixed.remark(gives(self.routine.callees[name])))
            case Call(name, args, results):
                array = result_array(statement, self.routine)
                given = ", ".join([*map(self._use, args), array])
                yield f"{ctype} {array}[{len(results)}];"
                yield f"{self.program.name}_{name}({given});"
                for part, result in enumerate(results):
                    if result in self.routine.names:
                        yield f"const {ctype} {self.routine.names[result]} = {array}[{part}];"

    def _integer(self, operation: Operation) -> str:
        """Return the expression of an integer operation."""
        op, args, place = operation.op, operation.args, operation.place
        called = self.integers.call(operation)
        if called is not None:
            name, constants = called
            return f"{name}({', '.join([*map(self._use, args), *constants])})"
        if op is MachineOp.READ and place is not None:
            return self._place(place)
        if op is MachineOp.SELECT:
            return f"({self._use(args[0])} != 0) ? {self._use(args[1])} : {self._use(args[2])}"
        if op is MachineOp.NARROW:
            return f"({getattr(operation.format, 'ctype', '')}){self._use(args[0])}"
        first = f"{self.integers.casts(operation)}{self._use(args[0])}"
        if op is MachineOp.NEGATE:
            return f"-{first}"
        if op is MachineOp.SHIFT_LEFT:
            return f"{first} * {self.integers.factor(operation)}"
        if op in SIGNS:
            return f"{first} {SIGNS[op]} {self._use(args[1])}"
        raise UnprintableError(f"{self.routine.name}: {op} must be lowered before it is printed")

    def _choose(self, place: Place, cases: tuple[tuple[int, str], ...], otherwise: str, indent: str) -> Iterator[str]:
        arguments = ", ".join(["state", *(block.name for block in parameters(self.routine))])
        word = "if"
        for limit, name in cases:
            yield f"{indent}{word} ({self._place(place)} < {limit}) {{"
            yield f"{indent}{INDENT}{self.program.name}_{name}({arguments});"
            word = "} else if"
        yield f"{indent}}} else {{"
        yield f"{indent}{INDENT}{self.program.name}_{otherwise}({arguments});"
        yield f"{indent}}}"

    def _use(self, value: int) -> str:
        return self.literals.get(value) or self.routine.names[value]

    def _stored(self, place: Place, value: int) -> str:
        """Return what is written to a place: a counter takes an integer."""
        integer = self.routine.block(place.block).integer and value in self.constants
        return str(int(self.constants[value])) if integer else self._use(value)

    def _place(self, place: Place) -> str:
        block = self.routine.block(place.block)
        if block.role is Role.STATE:
            return f"state->{field(block, place)}"
        if self.scalar and block.role is Role.INPUT:
            return components(block)[place.index.constant]
        if self.scalar and block.role is Role.OUTPUT:
            outputs = self.routine.having(Role.OUTPUT)
            before = sum(each.size for each in outputs[: outputs.index(block)])
            return f"result[{place.index + before}]"
        return f"{place.block}[{place.index}]"
