"""Assign formats: how many fraction bits each value of a routine of sums is kept with, so that no sum overflows.

Every value takes as many bits as its bound leaves in the word. Then sums are made to fit their accumulators (`fit`),
to a fixpoint: bounds include every rounding, so they are taken anew after each change.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Limits, Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Place, Routine, Statement, Write
from qcone.passes.choices import Choices, Formats, PinError, UnfitError, nearest
from qcone.passes.fit import fit
from qcone.passes.fuse import is_power_of_two
from qcone.passes.magnitudes import Declared, Magnitudes
from qcone.passes.samples import Samples

ROUNDS = 200


class Assigner:
    """Finds the formats of one routine; `blocks` are those of its blocks, `pins` fraction bits a user asks for."""

    def __init__(
        self,
        routine: Routine,
        number: Fixed,
        blocks: Mapping[str, Signal],
        declared: Mapping[str, Declared],
        samples: Samples | None = None,
        turn: Fraction | None = None,
        limits: Mapping[int, Fraction] | None = None,
        pins: Mapping[int, int] | None = None,
    ) -> None:
        """Prepare the routine: what is written becomes a value in the block's format."""
        self.number, self.blocks, self.declared = number, blocks, declared
        self.samples, self.turn, self.limits = samples, turn, dict(limits or {})
        self.grouped = {value for group in routine.groups for value in group.values}
        self.choices = Choices(routine, number)
        self.pins = dict(pins or {})
        self.choices.routine = self._with_written(routine)

    @property
    def routine(self) -> Routine:
        """Return the routine as it now stands."""
        return self.choices.routine

    @property
    def written(self) -> Mapping[Place, int]:
        """Return the value that is written to each place."""
        return self.choices.written

    def run(self) -> Formats:
        """Return the formats. Raises UnfitError where no choice fits."""
        errors: dict[int, Fraction] = {}
        for _ in range(ROUNDS):
            found = self._assign(errors)
            if fit(self.choices, found):
                errors = self._errors(found)
                continue
            again = self._errors(found)
            if all(again.get(key, 0) <= errors.get(key, Fraction(0)) for key in again):
                return found
            errors = {key: max(again.get(key, Fraction(0)), errors.get(key, Fraction(0))) for key in again}
        raise UnfitError(f"the routine '{self.routine.name}' finds no formats in {ROUNDS} rounds")

    # -- preparation ----------------------------------------------------------------------------------

    def _with_written(self, routine: Routine) -> Routine:
        sums: dict[int, Operation] = {}
        constants: dict[int, Operation] = {}
        for statement in routine.body:
            if isinstance(statement, Operation):
                if statement.op is RealOp.SUM:
                    sums[statement.result] = statement
                elif statement.op is RealOp.CONSTANT:
                    constants[statement.result] = statement
        body: list[Statement] = []
        for statement in routine.body:
            signal = self._block(statement.place) if isinstance(statement, Write) else None
            if isinstance(statement, Write) and signal is not None:
                self.choices.written[statement.place] = statement.value
                if statement.value in sums and statement.value not in self.choices.forced:
                    self.choices.forced[statement.value] = signal
                elif statement.value in constants:
                    copy = self.choices.fresh()
                    body.append(replace(constants[statement.value], result=copy, step=statement.step))
                    self.choices.forced[copy] = signal
                    self.choices.written[statement.place] = copy
                    statement = replace(statement, value=copy)
                else:
                    copy = self.choices.fresh()
                    name = self.choices.names.get(statement.value)
                    if name:
                        self.choices.names[copy] = name
                    detail = Sum((Term(Fraction(1), (statement.value,)),))
                    body.append(Operation(copy, RealOp.SUM, (statement.value,), step=statement.step, detail=detail))
                    self.choices.forced[copy] = signal
                    statement = replace(statement, value=copy)
            body.append(statement)
        used = {each.value for each in body if isinstance(each, Write)}
        used |= {arg for each in body if isinstance(each, Operation) for arg in each.args}
        kept = (each for each in body if not isinstance(each, Operation) or each.result in used)
        return replace(routine, body=tuple(kept), names=self.choices.names)

    def _block(self, place: Place) -> Signal | None:
        return self.blocks.get(place.block)

    # -- one round ------------------------------------------------------------------------------------

    def _assign(self, errors: Mapping[int, Fraction]) -> Formats:
        found = Formats(self.routine)
        try:
            found.magnitudes = Magnitudes(
                self.choices.routine, self.declared, self.samples, errors, self.turn, self.limits
            )
        except ZeroDivisionError:
            raise UnfitError(
                f"the routine '{self.routine.name}' divides by a value that may be zero: a quotient has no bound there"
            ) from None
        clamped = {
            each.args[0]: each.detail
            for each in self.routine.body
            if isinstance(each, Operation) and isinstance(each.detail, Limits)
        }
        for statement in self.routine.body:
            if isinstance(statement, Operation) and statement.op is not RealOp.LESS:
                found.signals[statement.result] = self._signal(statement, found, clamped)
        return found

    def _signal(self, operation: Operation, found: Formats, clamped: Mapping[int, Limits]) -> Signal:
        assert found.magnitudes is not None
        result, number = operation.result, self.number
        bound = found.magnitudes.of(result)
        match operation.op:
            case RealOp.READ if operation.place is not None:
                return self._kept(result, self.blocks[operation.place.block])
            case RealOp.CONSTANT:
                return self._forced(result, bound) or self._capped(result, number.signal(bound))
            case RealOp.SUM | RealOp.WIDE:
                return self._sum(operation, found, bound)
            case RealOp.SELECT:
                options = [found.signals[arg] for arg in operation.args[1:]]
                width = max(each.width for each in options)
                finest = max(each.fraction for each in options)
                return self._capped(result, Signal(width, min(finest, number.signal(bound, width).fraction)))
            case RealOp.CLAMP:
                before = found.signals[operation.args[0]]
                fits = bound * 2**before.fraction < 2 ** (number.width - 1)
                return Signal(number.width if fits else before.width, before.fraction)
            case RealOp.DIVIDE:
                limits = clamped.get(result)
                most = max(abs(limits.low), abs(limits.high)) if limits else bound
                fraction = number.signal(most).fraction
                top, bottom = (found.signals[arg] for arg in operation.args)
                size = found.magnitudes.of(operation.args[0])
                room = 2 ** (number.wide - 1)
                while max(size * Fraction(2) ** bottom.fraction, bound) * Fraction(2) ** fraction >= room:
                    fraction -= 1
                return Signal(number.wide, max(fraction, top.fraction - bottom.fraction))
        raise AssertionError(operation.op)

    def _forced(self, value: int, bound: Fraction) -> Signal | None:
        """Return the format of the block that a value is written to; None where it is not written."""
        signal = self.choices.forced.get(value)
        if signal is not None and bound * 2**signal.fraction >= 2 ** (signal.width - 1):
            raise self._unfit(value, bound, signal)
        return None if signal is None else self._kept(value, signal)

    def _kept(self, value: int, signal: Signal) -> Signal:
        """Return the format of a block. Raises PinError where a pin asks for another."""
        if self.pins.get(value, signal.fraction) != signal.fraction:
            raise self._unpinned(value, f"its block is kept as {signal.name}")
        return signal

    def _unpinned(self, value: int, why: str) -> PinError:
        name = self.routine.names.get(value, f"value {value}")
        return PinError(f"'{name}' in '{self.routine.name}' cannot have the pinned {self.pins[value]} bits: {why}")

    def _capped(self, value: int, signal: Signal) -> Signal:
        cap, pin = self.choices.caps.get(value), self.pins.get(value)
        if pin is not None:
            if pin > signal.fraction:
                raise self._unpinned(value, f"{pin - signal.fraction} more than a word of its range holds")
            if cap is not None and cap < pin:
                raise self._unpinned(value, f"sums of it fit their accumulator with {cap} at most")
            return replace(signal, fraction=pin)
        return signal if cap is None or cap >= signal.fraction else replace(signal, fraction=cap)

    def _sum(self, operation: Operation, found: Formats, bound: Fraction) -> Signal:
        assert isinstance(operation.detail, Sum)
        result = operation.result
        for at, term in enumerate(operation.detail.terms):
            if term.args and not is_power_of_two(term.coefficient):
                found.constants[result, at] = self._constant(term.coefficient, self.choices.short.get((result, at)))
        width = self.number.wide if operation.op is RealOp.WIDE else self.number.width
        forced = self._forced(result, bound)
        if forced is not None:
            return forced
        signal = self._capped(result, self.number.signal(bound, width))
        finest, _ = found.accumulated(operation)
        if result in self.pins and finest > -(10**6) and finest < signal.fraction:
            raise self._unpinned(result, f"what it is made of has {finest}")
        if finest > -(10**6):
            signal = replace(signal, fraction=min(signal.fraction, finest))
        return signal

    def _constant(self, value: Fraction, short: int | None) -> Signal:
        """Return the shortest format that a constant is as exact in as a whole word, or as a shortened one, allows."""
        size = abs(value)
        width = self.number.width - (short or 0)
        signal = self.number.signal(size, width)
        raw = round(size * Fraction(2) ** signal.fraction)
        if raw >= 2 ** (width - 1):
            signal = replace(signal, fraction=signal.fraction - 1)
            raw = round(size * Fraction(2) ** signal.fraction)
        while raw and raw % 2 == 0:
            raw //= 2
            signal = replace(signal, fraction=signal.fraction - 1)
        return Signal(self.number.width, signal.fraction)

    def _unfit(self, value: int, bound: Fraction, signal: Signal) -> UnfitError:
        missing = 0
        while bound * 2**signal.fraction >= 2 ** (signal.width - 1 + missing):
            missing += 1
        name = self.routine.names.get(value, f"value {value}")
        return UnfitError(
            f"'{name}' in '{self.routine.name}' may reach {float(bound):.4g}, {missing} bit{'s' * (missing > 1)} more "
            f"than {signal.name} holds"
        )

    def _errors(self, found: Formats) -> dict[int, Fraction]:
        """Return the error that each value adds: its rounding, its constants' and those of parts rounded first."""
        assert found.magnitudes is not None
        errors: dict[int, Fraction] = {}
        for statement in found.routine.body:
            if not isinstance(statement, Operation) or statement.op is RealOp.LESS:
                continue
            lsb = found.signals[statement.result].lsb
            if isinstance(statement.detail, Sum):
                error = self.own_error(found, statement)
                for term in statement.detail.terms:
                    error += self._inner_error(found, term, errors)
                errors[statement.result] = error
            elif statement.op is RealOp.READ:
                errors[statement.result] = Fraction(0)
            elif statement.constant is not None:
                off = nearest(statement.constant, found.signals[statement.result]) - statement.constant
                errors[statement.result] = abs(off)
            else:
                errors[statement.result] = lsb
        return errors

    def own_error(self, found: Formats, operation: Operation) -> Fraction:
        """Return what a sum's own rounding and those of its constants may add."""
        assert isinstance(operation.detail, Sum)
        signal = found.signals[operation.result]
        finest, _ = found.accumulated(operation)
        error = Fraction(0)
        if finest > signal.fraction:
            error = signal.lsb if operation.detail.carried else self.number.rounding_error(signal.lsb)
        for at, term in enumerate(operation.detail.terms):
            error += self._constant_error(found, operation.result, at, term, finest)
        return error

    def _inner_error(self, found: Formats, term: Term, errors: Mapping[int, Fraction]) -> Fraction:
        """Return what the roundings of operands that are in no group add: the rules of groups do not see them."""
        assert found.magnitudes is not None
        total = Fraction(0)
        for arg in term.args:
            if arg in self.grouped or not errors.get(arg):
                continue
            others = list(term.args)
            others.remove(arg)
            size = abs(term.coefficient)
            for other in others:
                size *= found.magnitudes.of(other)
            total += size * errors[arg]
        return total

    def _constant_error(self, found: Formats, result: int, at: int, term: Term, finest: int) -> Fraction:
        if not term.args:
            lsb = Fraction(2) ** -finest
            return Fraction(0) if (term.coefficient / lsb).denominator == 1 else lsb / 2
        signal = found.constants.get((result, at))
        if signal is None:
            return Fraction(0)
        off = abs(nearest(term.coefficient, signal) - term.coefficient)
        assert found.magnitudes is not None
        return off * found.magnitudes.of(term.args[0])
