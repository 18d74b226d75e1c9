"""Assign formats: how many fraction bits each value of a routine of sums is kept with, so that no sum overflows.

Every value takes as many bits as its bound leaves in the word. Then sums are made to fit their accumulators, to a
fixpoint: a constant is shortened; what is finer than the rest of its sum is rounded first, as a value of its own; or
an operand is kept with fewer bits. Bounds include every rounding, so they are taken anew after each change.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Limits, Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Place, Routine, Statement, Write, unused
from qcone.passes.fuse import is_power_of_two
from qcone.passes.magnitudes import Declared, Magnitudes, Samples

ROUNDS = 200
LEAST_DROPPED = 8
"""Fewer dropped bits than these would show the bias of rounding halves up."""
SHORTEST_CONSTANT = 12
"""Bits that a constant keeps at least when it is shortened to make a sum fit."""


class UnfitError(UsageError):
    """A routine whose values do not fit the format: names the value and the bits that are missing."""


@dataclass
class Formats:
    """A routine of sums with the format of every value, of every constant factor, and what is known of its values."""

    routine: Routine
    signals: dict[int, Signal] = field(default_factory=dict)
    constants: dict[tuple[int, int], Signal] = field(default_factory=dict)
    """By value and place of the term in its sum."""
    magnitudes: Magnitudes | None = None

    def accumulated(self, operation: Operation) -> tuple[int, list[int | None]]:
        """Return the fraction bits of a sum's accumulator, and of each term; None for a constant term."""
        assert isinstance(operation.detail, Sum)
        found: list[int | None] = []
        for at, term in enumerate(operation.detail.terms):
            found.append(self.term_bits(operation.result, at, term))
        own = self.signals[operation.result].fraction if operation.result in self.signals else -(10**6)
        known = [each for each in found if each is not None]
        return (max(known) if known else own), found

    def term_bits(self, value: int, at: int, term: Term) -> int | None:
        """Return the fraction bits of one term of a value's sum."""
        if not term.args:
            return None
        bits = sum(self.signals[arg].fraction for arg in term.args)
        if is_power_of_two(term.coefficient):
            return bits - exponent(term.coefficient)
        return bits + self.constants[value, at].fraction


def exponent(power: Fraction) -> int:
    """Return k of 2^k or -2^k."""
    return abs(power.numerator).bit_length() - power.denominator.bit_length()


class Assigner:
    """Finds the formats of one routine; `blocks` are those of its blocks, `pinned` fraction bits a user asks for."""

    def __init__(
        self,
        routine: Routine,
        number: Fixed,
        blocks: Mapping[str, Signal],
        declared: Mapping[str, Declared],
        samples: Samples | None = None,
        turn: Fraction | None = None,
        limits: Mapping[int, Fraction] | None = None,
        caps: Mapping[int, int] | None = None,
    ) -> None:
        """Prepare the routine: what is written becomes a value in the block's format."""
        self.number, self.blocks, self.declared = number, blocks, declared
        self.samples, self.turn, self.limits = samples, turn, dict(limits or {})
        self.caps: dict[int, int] = dict(caps or {})
        self.short: dict[tuple[int, int], int] = {}
        self.next = unused(routine)
        self.forced: dict[int, Signal] = {}
        self.written: dict[Place, int] = {}
        self.split: set[int] = set()
        self.indexed: Routine | None = None
        self.made: dict[int, Operation] = {}
        self.users: dict[int, list[Operation]] = {}
        self.names = dict(routine.names)
        self.grouped = {value for group in routine.groups for value in group.values}
        self.routine = self._with_written(routine)

    def run(self) -> Formats:
        """Return the formats. Raises UnfitError where no choice fits."""
        errors: dict[int, Fraction] = {}
        for _ in range(ROUNDS):
            found = self._assign(errors)
            if self._mend(found):
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
                self.written[statement.place] = statement.value
                if statement.value in sums and statement.value not in self.forced:
                    self.forced[statement.value] = signal
                elif statement.value in constants:
                    copy = self._fresh()
                    body.append(replace(constants[statement.value], result=copy, step=statement.step))
                    self.forced[copy] = signal
                    self.written[statement.place] = copy
                    statement = replace(statement, value=copy)
                else:
                    copy = self._fresh()
                    name = self.names.get(statement.value)
                    if name:
                        self.names[copy] = name
                    detail = Sum((Term(Fraction(1), (statement.value,)),))
                    body.append(Operation(copy, RealOp.SUM, (statement.value,), step=statement.step, detail=detail))
                    self.forced[copy] = signal
                    statement = replace(statement, value=copy)
            body.append(statement)
        used = {each.value for each in body if isinstance(each, Write)}
        used |= {arg for each in body if isinstance(each, Operation) for arg in each.args}
        kept = (each for each in body if not isinstance(each, Operation) or each.result in used)
        return replace(routine, body=tuple(kept), names=self.names)

    def _fresh(self) -> int:
        value, self.next = self.next, self.next + 1
        return value

    def _block(self, place: Place) -> Signal | None:
        return self.blocks.get(place.block)

    # -- one round ------------------------------------------------------------------------------------

    def _assign(self, errors: Mapping[int, Fraction]) -> Formats:
        found = Formats(self.routine)
        try:
            found.magnitudes = Magnitudes(self.routine, self.declared, self.samples, errors, self.turn, self.limits)
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
                return self.blocks[operation.place.block]
            case RealOp.CONSTANT:
                return self.forced.get(result) or self._capped(result, number.signal(bound))
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

    def _capped(self, value: int, signal: Signal) -> Signal:
        cap = self.caps.get(value)
        return signal if cap is None or cap >= signal.fraction else replace(signal, fraction=cap)

    def _sum(self, operation: Operation, found: Formats, bound: Fraction) -> Signal:
        assert isinstance(operation.detail, Sum)
        result = operation.result
        for at, term in enumerate(operation.detail.terms):
            if term.args and not is_power_of_two(term.coefficient):
                found.constants[result, at] = self._constant(term.coefficient, self.short.get((result, at)))
        width = self.number.wide if operation.op is RealOp.WIDE else self.number.width
        if result in self.forced:
            signal = self.forced[result]
            if bound * 2**signal.fraction >= 2 ** (signal.width - 1):
                raise self._unfit(result, bound, signal)
            return signal
        signal = self._capped(result, self.number.signal(bound, width))
        finest, _ = found.accumulated(operation)
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

    # -- making sums fit ------------------------------------------------------------------------------

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

    def _mend(self, found: Formats) -> bool:
        """Mend every sum that overflows its accumulator, one step each; tell whether there was one."""
        assert found.magnitudes is not None
        body: list[Statement] = []
        mended = False
        for statement in self.routine.body:
            if isinstance(statement, Operation) and isinstance(statement.detail, Sum):
                broad = self._broad_factor(statement.detail, found)
                if broad is not None:
                    mended = True
                    body.extend(self._narrowed(statement, broad))
                    continue
                over = self._over(statement, found)
                if over > 0:
                    mended = True
                    split = self._step(statement, found, over)
                    if split is not None:
                        body.extend(split)
                        continue
            body.append(statement)
        mended = mended or self._free_of_bias(found)
        if mended:
            self.routine = replace(self.routine, body=tuple(body), names=self.names)
        return mended

    def _broad_factor(self, detail: Sum, found: Formats) -> int | None:
        """Return a factor of a product that is wider than a word; None when there is none."""
        for term in detail.terms:
            if len(term.args) == 2 or not is_power_of_two(term.coefficient):
                for arg in term.args:
                    if found.signals[arg].width > self.number.width:
                        return arg
        return None

    def _narrowed(self, operation: Operation, broad: int) -> list[Statement]:
        """Round a factor to a word first."""
        assert isinstance(operation.detail, Sum)
        value = self._fresh()
        name = self.names.get(broad)
        if name:
            self.names[value] = f"{name}_upper"
        first = Sum((Term(Fraction(1), (broad,)),))
        made = Operation(value, RealOp.SUM, (broad,), step=operation.step, detail=first)
        terms = tuple(
            replace(term, args=tuple(value if arg == broad else arg for arg in term.args))
            if len(term.args) == 2 or not is_power_of_two(term.coefficient)
            else term
            for term in operation.detail.terms
        )
        return [made, replace(operation, args=_args(terms), detail=replace(operation.detail, terms=terms))]

    def _free_of_bias(self, found: Formats) -> bool:
        """Round what was split off a sum to the sum's own last bit where that would drop only few bits after all.

        Rounding halves up is biased by 2^-(n+1) of a last bit when n bits are dropped: seen for few bits alone. A part
        that is rounded where many bits are dropped, and then added exactly, has no such bias. Carried sums have none.
        """
        changed = False
        for statement in self.routine.body:
            if (
                not isinstance(statement, Operation)
                or not isinstance(statement.detail, Sum)
                or statement.detail.carried
            ):
                continue
            own = found.signals[statement.result].fraction
            finest, bits = found.accumulated(statement)
            if not 0 < finest - own < LEAST_DROPPED:
                continue
            fine = [
                term for term, each in zip(statement.detail.terms, bits, strict=True) if each is not None and each > own
            ]
            if all(len(term.args) == 1 and term.args[0] in self.split for term in fine):
                for term in fine:
                    over = found.term_bits(statement.result, 0, term)
                    assert over is not None
                    self.caps[term.args[0]] = found.signals[term.args[0]].fraction - (over - own)
                    changed = True
        return changed

    def accumulator_size(self, operation: Operation, found: Formats) -> Fraction:
        """Return the largest raw value in a sum's accumulator, in any order of its terms, rounding included."""
        assert isinstance(operation.detail, Sum)
        assert found.magnitudes is not None
        finest = self._finest(operation, found)
        size = Fraction(0)
        for at, term in enumerate(operation.detail.terms):
            low, high = found.magnitudes.term(term)
            most = max(-low, high)
            signal = found.constants.get((operation.result, at))
            if signal is not None:
                most = most / abs(term.coefficient) * abs(nearest(term.coefficient, signal))
            size += most
        subset = found.magnitudes.of_any_subset(operation)
        if subset is not None:
            size = min(size, subset)
        discard = finest - found.signals[operation.result].fraction
        rounding = Fraction(2) ** (discard - 1) if discard > 0 else Fraction(0)
        if operation.detail.carried:
            rounding *= 2
        return size * Fraction(2) ** finest + rounding

    def _finest(self, operation: Operation, found: Formats) -> int:
        finest, _ = found.accumulated(operation)
        return max(finest, found.signals[operation.result].fraction)

    def _over(self, operation: Operation, found: Formats) -> int:
        size, over = self.accumulator_size(operation, found), 0
        while size >= 2 ** (self.number.wide - 1 + over):
            over += 1
        return over

    def _step(self, operation: Operation, found: Formats, over: int) -> list[Statement] | None:
        """Make one sum need fewer bits: return the statements that stand for it, or None where only a cap changed."""
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        finest, bits = found.accumulated(operation)
        top = [at for at, each in enumerate(bits) if each == finest]
        own = found.signals[operation.result]
        if finest <= own.fraction and own.width == self.number.wide:
            if operation.result in self.forced:
                raise self._no_room(operation, over)
            self.caps[operation.result] = own.fraction - over
        constant = all((operation.result, at) in found.constants for at in top)
        if constant and all(self._shorten(operation.result, at, over, found) for at in top):
            return None
        part = self._part(operation, top, bits)
        if part is not None:
            return self._split(operation, part)
        wanted = {at: self._wanted(terms[at], found, over) for at in top}
        if all(wanted.values()):
            # The finest terms have an operand whose last bits nothing misses: it is kept with fewer.
            for each in wanted.values():
                assert each is not None
                self.caps[each] = min(self.caps.get(each, 10**6), found.signals[each].fraction - over)
            return None
        if len(top) < len(terms):
            linear = [at for at in top if len(terms[at].args) == 1]
            if linear:
                return self._recast(operation, linear[0], finest - over, found)
            return self._split(operation, top)
        for at in top:
            movable = [arg for arg in terms[at].args if arg not in self.forced and self.movable(arg)]
            if not movable:
                raise self._no_room(operation, over)
            widest = max(movable, key=lambda arg: found.signals[arg].fraction)
            self.caps[widest] = found.signals[widest].fraction - over
        return None

    def _wanted(self, term: Term, found: Formats, over: int) -> int | None:
        """Return an operand of a term that can do without its last `over` bits; None when there is none."""
        free = [arg for arg in term.args if arg not in self.forced and self.movable(arg)]
        free.sort(key=lambda arg: -found.signals[arg].fraction)
        return next((arg for arg in free if self._harmless(arg, found.signals[arg].fraction - over, found)), None)

    def _harmless(self, value: int, bits: int, found: Formats) -> bool:
        """Tell whether rounding a value to so many fraction bits stays below the last bit of all that use it."""
        assert found.magnitudes is not None
        error = Fraction(2) ** -(bits + 1)
        self._index()
        for statement in self.users.get(value, []):
            if not isinstance(statement.detail, Sum):
                return False
            for term in statement.detail.terms:
                if value not in term.args:
                    continue
                size = abs(term.coefficient) * (2 if term.args == (value, value) else 1)
                others = list(term.args)
                others.remove(value)
                for other in others:
                    size *= found.magnitudes.of(other)
                rest = [other for other in statement.detail.terms if value not in other.args]
                inherent = max((self._inherent(other, found) for other in rest), default=Fraction(0))
                if size * error > max(inherent, found.signals[statement.result].lsb / 2):
                    return False
        return True

    def _inherent(self, term: Term, found: Formats) -> Fraction:
        """Return what the roundings of a term's own operands make of it."""
        assert found.magnitudes is not None
        total = Fraction(0)
        for arg in term.args:
            if self.movable(arg):
                # By its own bound, not as it is kept now: else one loss would justify the next.
                size = abs(term.coefficient) * self.number.ulp(found.magnitudes.of(arg)) / 2
                others = list(term.args)
                others.remove(arg)
                for other in others:
                    size *= found.magnitudes.of(other)
                total += size
        return total

    def movable(self, value: int) -> bool:
        self._index()
        operation = self.made.get(value)
        return operation is not None and operation.op in (RealOp.SUM, RealOp.CONSTANT, RealOp.WIDE, RealOp.SELECT)

    def _index(self) -> None:
        """Note what makes every value and what uses it, once for each shape of the routine."""
        if self.indexed is self.routine:
            return
        self.indexed = self.routine
        operations = [each for each in self.routine.body if isinstance(each, Operation)]
        self.made = {each.result: each for each in operations}
        self.users = {}
        for each in operations:
            for arg in each.args:
                self.users.setdefault(arg, []).append(each)

    def _shorten(self, value: int, at: int, over: int, found: Formats) -> bool:
        now = self.short.get((value, at), 0)
        signal = found.constants[value, at]
        self._index()
        term = self.made[value].detail
        assert isinstance(term, Sum)
        raw = abs(nearest(term.terms[at].coefficient, signal)) / signal.lsb
        length = int(raw).bit_length()
        if length - over < SHORTEST_CONSTANT:
            return False
        self.short[value, at] = max(now, self.number.width - 1 - length) + over
        return True

    def _part(self, operation: Operation, top: list[int], bits: list[int | None]) -> list[int] | None:
        """Return the terms to be rounded first: those of the finest ones' own sum, or products among linear terms."""
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        for at in top:
            part = terms[at].part
            if part is not None:
                members = [k for k, term in enumerate(terms) if term.part == part]
                if len(members) < len(terms) and any(not self._is_linear(terms[k]) for k in members):
                    return members
        products = [k for k, term in enumerate(terms) if not self._is_linear(term)]
        words = [k for k, term in enumerate(terms) if self._is_linear(term) and term.args]
        if products and words and any(at in products for at in top):
            return products
        return None

    @staticmethod
    def _is_linear(term: Term) -> bool:
        return (len(term.args) < 2 and is_power_of_two(term.coefficient)) or not term.args

    def _split(self, operation: Operation, members: list[int]) -> list[Statement]:
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        self.short = {key: bits for key, bits in self.short.items() if key[0] != operation.result}
        parts = {terms[k].part for k in members}
        part = parts.pop() if len(parts) == 1 else None
        fresh = part is None
        value = self._fresh() if part is None else part
        first = Sum(tuple(replace(terms[k], part=None) for k in members))
        name = self.names.get(operation.result)
        if fresh and name:
            self.names[value] = f"{name}_part"
        wide = operation.result in self.forced and self.forced[operation.result].width == self.number.wide
        op = RealOp.WIDE if wide or operation.op is RealOp.WIDE else RealOp.SUM
        self.split.add(value)
        step = terms[members[0]].step if part is not None else operation.step
        made = Operation(value, op, _args(first.terms), step=step, detail=first)
        rest = list(terms)
        rest[members[0]] = Term(Fraction(1), (value,))
        kept = tuple(term for k, term in enumerate(rest) if k == members[0] or k not in members)
        detail = replace(operation.detail, terms=kept)
        return [made, replace(operation, args=_args(kept), detail=detail)]

    def _recast(self, operation: Operation, at: int, bits: int, found: Formats) -> list[Statement]:
        """Round one linear term first, to so many fraction bits."""
        assert isinstance(operation.detail, Sum)
        self.short = {key: bits for key, bits in self.short.items() if key[0] != operation.result}
        term = operation.detail.terms[at]
        value = self._fresh()
        name = self.names.get(term.args[0])
        if name:
            self.names[value] = f"{name}_rounded"
        self.caps[value] = bits
        first = Sum((replace(term, part=None),))
        kept = tuple(Term(Fraction(1), (value,)) if k == at else each for k, each in enumerate(operation.detail.terms))
        made = Operation(value, RealOp.SUM, term.args, step=operation.step, detail=first)
        return [made, replace(operation, args=_args(kept), detail=replace(operation.detail, terms=kept))]

    def _no_room(self, operation: Operation, over: int) -> UnfitError:
        name = self.routine.names.get(operation.result, f"value {operation.result}")
        return UnfitError(
            f"the sum '{name}' in '{self.routine.name}' needs {over} bit{'s' * (over > 1)} more than an accumulator of "
            f"{self.number.wide}"
        )


def nearest(value: Fraction, signal: Signal) -> Fraction:
    """Return the nearest multiple of the format's last bit, halves up."""
    return (value / signal.lsb + Fraction(1, 2)).__floor__() * signal.lsb


def _args(terms: tuple[Term, ...]) -> tuple[int, ...]:
    return tuple(dict.fromkeys(arg for term in terms for arg in term.args))
