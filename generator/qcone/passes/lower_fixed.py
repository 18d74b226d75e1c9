"""Lower a routine of sums to fixed point: one `mac` for each sum, constants rounded once, operands brought together.

A comparison and a selection take words of one format, so what differs is aligned first. A sum of a single word that
needs neither a shift nor a rounding is that word.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.fixed import Fixed, Signal
from qcone.formats.floating import TRUTH
from qcone.ir.detail import Aligned, Limits, Mac, Shift, Sum
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Choose, Operation, Place, Role, Routine, Shape, Statement, Write, unused
from qcone.passes.choices import Formats, nearest
from qcone.passes.fuse import args_of
from qcone.passes.qassign import Assigner


@dataclass(frozen=True)
class Residual:
    """A carried rounding: the format of what waits for the next update, and what is carried, for the reader."""

    signal: Signal
    of: str


def lower_fixed(
    assigner: Assigner, found: Formats, carry: str | None, blocks: Mapping[str, Signal]
) -> tuple[Routine, tuple[Residual, ...]]:
    """Return the routine in fixed-point operations and what it carries, in the state block named `carry`.

    Without `carry` nothing is carried. Raises UsageError for an operation firmware does without.
    """
    return _Lowering(assigner, found, carry, blocks).run()


class _Lowering:
    def __init__(self, assigner: Assigner, found: Formats, carry: str | None, blocks: Mapping[str, Signal]) -> None:
        self.assigner, self.found, self.carry, self.blocks = assigner, found, carry, blocks
        self.number: Fixed = assigner.number
        self.routine = found.routine
        self.signals = dict(found.signals)
        self.renamed: dict[int, int] = {}
        self.constants: dict[int, Fraction] = {}
        self.body: list[Statement] = []
        self.residuals: list[Residual] = []
        self.names = dict(self.routine.names)
        self.next = unused(self.routine)

    def run(self) -> tuple[Routine, tuple[Residual, ...]]:
        for statement in self.routine.body:
            match statement:
                case Operation():
                    self._operation(statement)
                case Write(place, value):
                    block = self.routine.block(place.block)
                    if block.integer:
                        self.body.append(statement)
                        self._integer_literal(value)
                    else:
                        self.body.append(replace(statement, value=self._use(value)))
                case _:
                    self.body.append(statement)
        own = tuple(
            replace(block, format=self.blocks[block.name]) if block.name in self.blocks else block
            for block in self.routine.blocks
        )
        if self.residuals and self.carry:
            own = (*own, residual_block(self.carry, tuple(self.residuals)))
        return replace(self.routine, blocks=own, body=tuple(self.body), names=self.names), tuple(self.residuals)

    def _integer_literal(self, value: int) -> None:
        """A counter is set to a whole number: its literal stays one."""
        for at, statement in enumerate(self.body):
            if isinstance(statement, Operation) and statement.result == value:
                assert statement.constant is not None
                exact = self.constants.get(value, statement.constant)
                self.body[at] = replace(statement, constant=exact, format=Signal(32, 0))

    def _use(self, value: int) -> int:
        while value in self.renamed:
            value = self.renamed[value]
        return value

    def _fresh(self, signal: Signal) -> int:
        value, self.next = self.next, self.next + 1
        self.signals[value] = signal
        return value

    def _operation(self, operation: Operation) -> None:
        result, op = operation.result, operation.op
        bound = None if op is RealOp.LESS else self._bound(result)
        args = tuple(map(self._use, operation.args))
        signal = self.signals.get(result)
        match op:
            case RealOp.CONSTANT:
                assert operation.constant is not None
                assert signal is not None
                self.constants[result] = operation.constant
                self.body.append(self._literal(operation.constant, signal, operation.step, result))
            case RealOp.READ:
                self.body.append(replace(operation, op=MachineOp.READ, format=signal, bound=bound))
            case RealOp.SUM | RealOp.WIDE:
                self._sum(operation, bound)
            case RealOp.LESS:
                left, right = self._together(args, operation.step)
                self.body.append(replace(operation, op=MachineOp.LESS, args=(left, right), format=TRUTH))
            case RealOp.SELECT:
                assert signal is not None
                chosen = [self._in(arg, signal, operation.step) for arg in args[1:]]
                self.body.append(
                    replace(operation, op=MachineOp.SELECT, args=(args[0], *chosen), format=signal, bound=bound)
                )
            case RealOp.CLAMP:
                assert isinstance(operation.detail, Limits)
                assert signal is not None
                lsb = signal.lsb
                most = self.signals[args[0]].most
                low = max(-(-operation.detail.low // lsb), -most)
                limits = Limits(Fraction(low), Fraction(min(operation.detail.high // lsb, most)))
                self.body.append(
                    replace(operation, op=MachineOp.CLAMP, args=args, format=signal, detail=limits, bound=bound)
                )
            case RealOp.DIVIDE:
                assert signal is not None
                top, bottom = (self.signals[arg] for arg in args)
                shift = Shift(signal.fraction + bottom.fraction - top.fraction)
                if shift.bits < 0:
                    raise UsageError(f"'{self.names.get(result)}': a quotient with more bits than its numerator has")
                self.body.append(
                    replace(operation, op=MachineOp.DIVIDE, args=args, format=signal, detail=shift, bound=bound)
                )
            case _:
                raise UsageError(
                    f"the routine '{self.routine.name}' takes a {op.value.replace('_', ' ')}, which emitted C does "
                    'without: set form = "factored"'
                )

    def _bound(self, value: int) -> Fraction:
        assert self.found.magnitudes is not None
        return self.found.magnitudes.of(value)

    def _literal(self, value: Fraction, signal: Signal, step: int, result: int | None = None) -> Operation:
        rounded = nearest(value, signal)
        made = self._fresh(signal) if result is None else result
        return Operation(made, MachineOp.LITERAL, constant=rounded, step=step, format=signal, exact=value)

    def _in(self, value: int, signal: Signal, step: int) -> int:
        """Return a word in another format: shifted, or rounded."""
        have = self.signals[value]
        if have == signal:
            return value
        if value in self.constants:
            literal = self._literal(self.constants[value], signal, step)
            self.constants[literal.result] = self.constants[value]
            self.body.append(literal)
            return literal.result
        discard = max(0, have.fraction - signal.fraction)
        term = Aligned((value,), shift=max(0, signal.fraction - have.fraction))
        copy = self._fresh(signal)
        if value in self.names:
            self.names[copy] = f"{self.names[value]}_aligned"
        detail = Mac((term,), self.number.wide, discard, self.number.rounding)
        self.body.append(Operation(copy, MachineOp.MAC, (value,), step=step, format=signal, detail=detail))
        return copy

    def _together(self, args: tuple[int, ...], step: int) -> tuple[int, int]:
        """Return two words in one format, without rounding either but a constant."""
        left, right = args
        for one, other in ((left, right), (right, left)):
            if other in self.constants:
                wide = self.signals[one]
                aligned = self._in(other, self._for_constant(other, wide), step)
                return (one, aligned) if one == left else (aligned, one)
        finest = max(self.signals[left].fraction, self.signals[right].fraction)
        signal = Signal(self.number.wide, finest)
        if self.signals[left].fraction == self.signals[right].fraction:
            return left, right
        return self._in(left, signal, step), self._in(right, signal, step)

    def _for_constant(self, value: int, near: Signal) -> Signal:
        """Return the format in which a constant is compared: one wide enough for it, with the other's fraction bits."""
        raw = abs(nearest(self.constants[value], near)) / near.lsb
        width = near.width if raw < 2 ** (near.width - 1) else self.number.wide
        return Signal(width, near.fraction)

    def _limits(self, result: int, signal: Signal) -> tuple[int, int] | None:
        """Return the raw values a result is clamped to; None where it cannot be beyond them."""
        assert self.found.magnitudes is not None
        if result not in self.found.magnitudes.clamped:
            return None
        most = min(int(self.found.magnitudes.limits[result] / signal.lsb), signal.most)
        return -most, most

    def _sum(self, operation: Operation, bound: Fraction | None) -> None:
        assert isinstance(operation.detail, Sum)
        result, detail = operation.result, operation.detail
        signal = self.signals[result]
        finest, bits = self.found.accumulated(operation)
        finest = max(finest, signal.fraction)
        aligned: list[Aligned] = []
        literals: list[Statement] = []
        for at, (term, have) in enumerate(zip(detail.terms, bits, strict=True)):
            negative = term.coefficient < 0
            args = tuple(map(self._use, term.args))
            if have is None:
                literal = self._literal(abs(term.coefficient), Signal(self.number.wide, finest), operation.step)
                literals.append(literal)
                aligned.append(Aligned((literal.result,), negative))
                continue
            if (result, at) in self.found.constants:
                literal = self._literal(abs(term.coefficient), self.found.constants[result, at], operation.step)
                literals.append(literal)
                args = (literal.result, *args)
            aligned.append(Aligned(args, negative, finest - have))
        discard = finest - signal.fraction
        assert self.found.magnitudes is not None
        free = result not in self.found.magnitudes.clamped
        plain = free and len(aligned) == 1 and len(aligned[0].args) == 1 and not aligned[0].negative
        if plain and not aligned[0].shift and not discard and not literals:
            word = aligned[0].args[0]
            if self.signals[word] == signal:
                self.renamed[result] = word
                return
        self.body.extend(literals)
        size = self.found.accumulator_size(operation)
        narrow = (
            self.number.overflow == "prove"
            and size < 2 ** (self.number.width - 1)
            and self.number.width == 32
            and signal.width == 32
        )
        linear = all(len(each.args) == 1 for each in aligned)
        accumulator = self.number.width if narrow and linear else self.number.wide
        residual = None
        if detail.carried and self.carry and discard:
            residual = (self.carry, Index(len(self.residuals)))
            width = self.number.width if discard < self.number.width else self.number.wide
            self.residuals.append(Residual(Signal(width, finest), self.names.get(result, "value")))
        limits = self._limits(result, signal)
        made = Mac(tuple(aligned), accumulator, discard, self.number.rounding, residual, limits)
        self.body.append(
            replace(operation, op=MachineOp.MAC, args=args_of(aligned), format=signal, detail=made, bound=bound)
        )


def residual_block(name: str, residuals: tuple[Residual, ...]) -> Block:
    """Return the state block of the carried roundings: one word each, all of the widest one's width."""
    width = max(each.signal.width for each in residuals)
    kept = ", ".join(dict.fromkeys(each.of.rpartition("_")[0] or each.of for each in residuals))
    unit = f"roundings carried to the next update: of {kept}"
    return Block(name, Shape.SCALAR, Role.STATE, len(residuals), unit, format=Signal(width, 0))


def with_residual(routine: Routine, block: Block, sets: bool) -> Routine:
    """Clear what is carried where a routine `sets` the attitude, and hand it on where it hands its call on."""
    hands_on = any(isinstance(each, Choose) for each in routine.body)
    if not sets and not hands_on:
        return routine
    blocks = (routine.blocks[0], block, *routine.blocks[1:])
    body: tuple[Statement, ...] = routine.body
    if not hands_on:
        value = unused(routine)
        step = len(routine.steps) - 1
        assert block.format is not None
        zero = Operation(
            value, MachineOp.LITERAL, constant=Fraction(0), step=step, format=block.format, exact=Fraction(0)
        )
        body = (*body, zero, *(Write(Place(block.name, Index(k)), value, step) for k in range(block.size)))
    return replace(routine, blocks=blocks, body=body)
