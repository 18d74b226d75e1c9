"""What the emitted C of a routine must say, statement by statement, in the terms the text is read back in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from qcone.backends.c_fixed import IntegerText
from qcone.backends.c_furniture import furniture
from qcone.backends.c_operands import UnreadableError, affine
from qcone.backends.c_signature import components, parameters, result_array, unused
from qcone.backends.c_source import functions
from qcone.backends.c_state import field, state_fields, state_initialiser
from qcone.backends.parse_back import Line, inline_functions, read_functions, read_macros, read_structure
from qcone.formats.fixed import Fixed, Signal
from qcone.formats.floating import Floating
from qcone.ir.index import Index
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


def differences(program: Program, number: Floating | Fixed, header: str, source: str) -> list[str]:
    """Return how the text differs from the program: empty when every statement of every function agrees."""
    small, source = inline_functions(source)
    wanted = tuple(each.text for each in furniture(program, number)) if isinstance(number, Fixed) else ()
    if small != wanted:
        odd = next((text for text in (*small, *wanted) if text not in wanted or text not in small), "their order")
        return [f"a small function is not as it is emitted: {' '.join(odd.split())}"]
    try:
        found = read_functions(header, source)
        members = read_structure(header, f"{program.name}_state")
    except UnreadableError as error:
        return [str(error)]
    return [*_compare_header(program, number, members, read_macros(header)), *_compare(program, number, found)]


def _compare_header(
    program: Program, number: Floating | Fixed, members: tuple[str, ...], macros: Mapping[str, str]
) -> Iterator[str]:
    """Compare what the header fixes of the state: its members, their types, what a static state begins with."""
    wanted = tuple(declaration.removesuffix(";") for declaration, _ in state_fields(program, number))
    if members != wanted:
        yield f"{program.name}_state: members ({'; '.join(members)}) instead of ({'; '.join(wanted)})"
    prefix = program.name.upper() + "_"
    for name in macros:
        if not name.startswith(prefix):
            yield f"{name}: a macro that is not emitted"
    initial = "".join(state_initialiser(program, number).split())
    if macros.get(f"{prefix}STATE_INIT") != initial:
        yield f"{prefix}STATE_INIT: {macros.get(f'{prefix}STATE_INIT')} instead of {initial}"


def _compare(
    program: Program, number: Floating | Fixed, found: Mapping[str, tuple[str, tuple[Line, ...]]]
) -> Iterator[str]:
    routines = {f"{program.name}_{routine.name}": routine for routine in program.routines}
    for routine in program.routines:
        for callee in _callees(routine):
            routines.setdefault(f"{program.name}_{callee.name}", callee)
    wanted_signatures = {f"{program.name}_{each.routine}": each.signature for each in functions(program, number)}
    for name in sorted(set(routines) ^ set(found)):
        yield f"{name}: {'missing from the text' if name in routines else 'not in the program'}"
    scalar = {callee.name for routine in program.routines for callee in _callees(routine)}
    for name, routine in routines.items():
        if name not in found:
            continue
        signature, lines = found[name]
        if _squeezed(signature) != _squeezed(wanted_signatures[name]):
            yield f"{name}: `{signature}` instead of `{' '.join(wanted_signatures[name].split())}`"
        expected = tuple(_Reader(routine, program, number, routine.name in scalar).lines())
        yield from _compare_lines(name, lines, expected)


def _callees(routine: Routine) -> Iterator[Routine]:
    for callee in routine.callees.values():
        yield from _callees(callee)
        yield callee


def _squeezed(text: str) -> str:
    return "".join(text.split())


def _compare_lines(name: str, found: Sequence[Line], expected: Sequence[Line]) -> Iterator[str]:
    for number, (have, want) in enumerate(zip(found, expected, strict=False), start=1):
        if have != want:
            yield f"{name}: statement {number} is `{have}`, the routine has `{want}`"
            return
    if len(found) != len(expected):
        yield f"{name}: {len(found)} statements, the routine has {len(expected)}"


class _Reader:
    """Says what each statement of a routine must look like in C."""

    def __init__(self, routine: Routine, program: Program, number: Floating | Fixed, scalar: bool) -> None:
        self.routine, self.program, self.number, self.scalar = routine, program, number, scalar
        literals = [each for each in walk(routine.body) if isinstance(each, Operation) and each.op is MachineOp.LITERAL]
        self.constants = {each.result: each.constant for each in literals if each.constant is not None}
        self.literals = {
            each.result: self._literal(each.constant, each.format) for each in literals if each.constant is not None
        }
        self.integers = IntegerText(routine, number)

    def lines(self) -> Iterator[Line]:
        """Yield the expected statements."""
        ctype = self.number.ctype
        for block in self.routine.having(Role.TABLE):
            entries = tuple(self._literal(entry) for entry in block.entries)
            yield Line("array", f"static const {ctype} {block.name}[{block.size}]", entries)
        for block in self.routine.having(Role.LOCAL):
            yield Line("array", f"{ctype} {block.name}[{block.size}]")
        yield from (Line("unused", name) for name in unused(self.routine, self.scalar))
        yield from self._body(self.routine.body)

    def _body(self, body: Sequence[Statement]) -> Iterator[Line]:
        ctype = f"const {self.number.ctype}"
        names = self.routine.names
        for statement in body:
            match statement:
                case Operation(result, op):
                    if op is MachineOp.LITERAL:
                        continue
                    kind, operands = self._parts(statement)
                    typed = f"const {statement.format.ctype if statement.format else ''}"
                    yield Line(kind, names[result], operands, typed)
                case Write(_, value) if self.routine.by_value:
                    yield Line("return", "", (self._use(value),))
                case Write(place, value):
                    integer = self.routine.block(place.block).integer
                    stored = self.constants.get(value) if integer else None
                    yield Line("write", self._place(place), (self._use(value) if stored is None else str(stored),))
                case Ready(place, limit):
                    yield Line("ready", self._place(place), (str(limit),))
                case Advance(place):
                    yield Line("advance", self._place(place))
                case Loop(counter, first, last, inner):
                    yield Line("loop", counter, (_index(first), _index(last)), "int32_t", tuple(self._body(inner)))
                case Call(name, args, (result,)) if self.routine.callees[name].by_value:
                    yield Line(f"{self.program.name}_{name}", names[result], tuple(map(self._use, args)), ctype)
                case Call(name, args, results):
                    array = result_array(statement, self.routine)
                    yield Line("array", f"{self.number.ctype} {array}[{len(results)}]")
                    yield Line("call", f"{self.program.name}_{name}", (*map(self._use, args), array))
                    for part, result in enumerate(results):
                        if result in names:
                            yield Line("read", names[result], (f"{array}[{part}]",), ctype)
                case Choose(place, cases, otherwise):
                    arguments = ("state", *(block.name for block in parameters(self.routine)))
                    calls = [*(name for _, name in cases), otherwise]
                    body_lines = tuple(Line("call", f"{self.program.name}_{name}", arguments) for name in calls)
                    limits = tuple(str(limit) for limit, _ in cases)
                    yield Line("choose", self._place(place), limits, body=body_lines)

    def _parts(self, operation: Operation) -> tuple[str, tuple[str, ...]]:
        """Return what kind of statement an operation is, and its operands, casts among them."""
        if operation.place is not None:
            return operation.op.value, (self._place(operation.place),)
        operands = list(map(self._use, operation.args))
        if not isinstance(operation.format, Signal):
            return operation.op.value, tuple(operands)
        called = self.integers.call(operation)
        if called is not None:
            name, constants = called
            return name, (*operands, *(_whole(each) for each in constants))
        if operation.op is MachineOp.NARROW:
            return "read", (f"({operation.format.ctype}){operands[0]}",)
        if operation.op is not MachineOp.SELECT:
            operands[0] = self.integers.casts(operation) + operands[0]
        if operation.op is MachineOp.SHIFT_LEFT:
            return "multiply", (*operands, _whole(self.integers.factor(operation)))
        return operation.op.value, tuple(operands)

    def _use(self, value: int) -> str:
        return self.literals.get(value) or self.routine.names[value]

    def _literal(self, value: Fraction, signal: object = None) -> str:
        if isinstance(signal, Signal):
            raw = signal.raw(value)
            return f"int64_t {raw}" if signal.width > 32 else str(raw)
        sign = "-" if value < 0 else ""
        return f"{sign}{self.number.ctype} {abs(value)}"

    def _place(self, place: Place) -> str:
        block = self.routine.block(place.block)
        index = _index(place.index)
        if block.role is Role.STATE:
            whole = field(block, place)
            return f"state->{block.name}[{index}]" if "[" in whole else f"state->{whole}"
        if self.scalar and block.role is Role.INPUT:
            return components(block)[place.index.constant]
        if self.scalar and block.role is Role.OUTPUT:
            outputs = self.routine.having(Role.OUTPUT)
            before = sum(each.size for each in outputs[: outputs.index(block)])
            return f"result[{_index(place.index + before)}]"
        return f"{place.block}[{index}]"


def _whole(text: str) -> str:
    """Return an integer constant in the terms it is read back in."""
    return f"int64_t {text[8:-1]}" if text.startswith("INT64_C(") else text


def _index(index: Index) -> str:
    return affine({"": index.constant, **dict(index.terms)})
