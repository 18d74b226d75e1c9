"""Expand `mac` into integer operations: products, sums, shifts, one rounding. Exact: no bit of any result changes.

The core decides how a product is made. `generic` takes a product of two words in a word twice as wide, as C has it.
That no partial sum overflows, in any order of the terms, was shown when the formats were chosen.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from qcone.formats.fixed import Signal
from qcone.ir.detail import Aligned, Limits, Mac, Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation, Place, Routine, Statement, Write, results, unused


@dataclass(frozen=True)
class Made:
    """Sums of products that are made already: the statements of each by its result, and the routines they call.

    `names` are those of values on the way.
    """

    sums: Mapping[int, tuple[Statement, ...]] = field(default_factory=dict)
    names: Mapping[int, str] = field(default_factory=dict)
    callees: Mapping[str, Routine] = field(default_factory=dict)


WIDE = Made()
"""Every product is one of words twice as wide."""


def expand(routine: Routine, narrow: bool = True, made: Made = WIDE) -> Routine:
    """Return the routine in integer operations of the generic core.

    With `narrow`, sums are made in single words where they are proved to fit. Sums in `made` are taken from there.
    """
    return _Expansion(routine, narrow, made).run()


class _Expansion:
    def __init__(self, routine: Routine, narrow: bool, made: Made) -> None:
        self.routine, self.made = routine, made
        self.names = {**routine.names, **made.names}
        self.next = max([unused(routine), *(value + 1 for body in made.sums.values() for value in results(body))])
        self.body: list[Statement] = []
        self.formats: dict[int, Signal] = {}
        self.bounds: dict[int, Fraction] = {}
        self.narrow = narrow

    def run(self) -> Routine:
        for statement in self.routine.body:
            if isinstance(statement, Operation):
                if isinstance(statement.format, Signal):
                    self.formats[statement.result] = statement.format
                    if statement.bound is not None:
                        self.bounds[statement.result] = statement.bound
                if statement.result in self.made.sums:
                    self.body.extend(self.made.sums[statement.result])
                    continue
                if isinstance(statement.detail, Mac):
                    self._mac(statement, statement.detail)
                    continue
                if statement.op is MachineOp.DIVIDE and isinstance(statement.detail, Shift):
                    self._quotient(statement, statement.detail)
                    continue
            self.body.append(statement)
        callees = {**self.routine.callees, **self.made.callees}
        return replace(self.routine, body=tuple(self.body), names=self.names, callees=callees)

    def _emit(
        self, op: MachineOp, args: tuple[int, ...], signal: Signal, like: Operation, shift: Shift | None = None
    ) -> int:
        value, self.next = self.next, self.next + 1
        self.body.append(Operation(value, op, args, step=like.step, format=signal, detail=shift))
        self.formats[value] = signal
        return value

    def _mac(self, operation: Operation, mac: Mac) -> None:
        assert isinstance(operation.format, Signal)
        late = self._late_terms(operation, mac)
        early = tuple(term for term in mac.terms if term not in late)
        wide = Signal(operation.format.width if late else mac.accumulator, operation.format.fraction + mac.discard)
        total = self._total(early, wide, operation)
        if not late:
            self._result(operation, mac, total, wide)
            return
        # What is a whole number of last bits is added after the rounding: floor((a 2^n + x)/2^n) = a + floor(x/2^n).
        part, self.next = self.next, self.next + 1
        name = self.names.get(operation.result)
        if name:
            self.names[part] = f"{name}_fine"
        fine = replace(operation, result=part, bound=None)
        self.formats[part] = operation.format
        self._result(fine, mac, total, wide)
        shifted = tuple(replace(term, shift=term.shift - mac.discard) for term in late)
        whole = self._total((Aligned((part,)), *shifted), operation.format, operation)
        self._rounded(operation, replace(mac, discard=0), whole)

    def _late_terms(self, operation: Operation, mac: Mac) -> tuple[Aligned, ...]:
        """Return the words that may be added after the rounding, where that leaves the sum before it in one word."""
        assert isinstance(operation.format, Signal)
        width = operation.format.width
        if mac.rounding == "even" or mac.limits is not None or not self.narrow or width != 32 or mac.accumulator != 64:
            return ()
        late = tuple(each for each in mac.terms if len(each.args) == 1 and each.shift >= mac.discard > 0)
        early = [each for each in mac.terms if each not in late]
        if not late or not early or any(len(each.args) > 1 for each in early):
            return ()
        before, after = (self._size(terms) for terms in (early, late))
        if before is None or any(self.formats[each.args[0]].width != width for each in early):
            return ()
        before += Fraction(2) ** (mac.discard + 1)
        # One word more gives the result, which fits; of several each sum on the way has to.
        if len(late) > 1 and (after is None or after + before >= Fraction(2) ** (width - 1 + mac.discard)):
            return ()
        return late if before < 2 ** (width - 1) else ()

    def _size(self, terms: Iterable[Aligned]) -> Fraction | None:
        """Return the largest size of a sum of words, in the accumulator's last bits; None where it is not known."""
        size = Fraction(0)
        for each in terms:
            bound = self.bounds.get(each.args[0])
            if bound is None:
                return None
            size += bound / self.formats[each.args[0]].lsb * 2**each.shift
        return size

    def _total(self, terms: tuple[Aligned, ...], wide: Signal, like: Operation) -> int:
        """Write a sum: what is added, less the sum of what is subtracted; a product is added in one instruction."""
        added = [each for each in terms if not each.negative]
        taken = [each for each in terms if each.negative]
        if not added:
            return self._emit(MachineOp.NEGATE, (self._added(taken, wide, like),), wide, like)
        total = self._added(added, wide, like)
        if taken:
            total = self._emit(MachineOp.SUBTRACT, (total, self._added(taken, wide, like)), wide, like)
        return total

    def _added(self, terms: list[Aligned], wide: Signal, like: Operation) -> int:
        total = self._term(terms[0], wide, like)
        for term in terms[1:]:
            total = self._emit(MachineOp.ADD, (total, self._term(term, wide, like)), wide, like)
        return total

    def _result(self, operation: Operation, mac: Mac, total: int, wide: Signal) -> None:
        if mac.residual is not None:
            self._carried(operation, mac, total, wide)
        elif mac.limits is not None:
            self._clamped(operation, mac, total, wide)
        else:
            self._rounded(operation, mac, total)

    def _quotient(self, operation: Operation, shift: Shift) -> None:
        """Write a quotient: the numerator is shifted left, the division drops what is below the last bit."""
        top, bottom = operation.args
        assert isinstance(operation.format, Signal)
        if shift.bits:
            signal = Signal(operation.format.width, self.formats[top].fraction + shift.bits)
            top = self._emit(MachineOp.SHIFT_LEFT, (top,), signal, operation, shift)
        self.body.append(replace(operation, args=(top, bottom), detail=None))

    def _term(self, term: Aligned, wide: Signal, like: Operation) -> int:
        value = term.args[0]
        if len(term.args) == 2:
            bits = sum(self.formats[arg].fraction for arg in term.args)
            value = self._emit(MachineOp.MULTIPLY, term.args, Signal(wide.width, bits), like)
        if term.shift:
            value = self._emit(MachineOp.SHIFT_LEFT, (value,), wide, like, Shift(term.shift))
        return value

    def _clamped(self, operation: Operation, mac: Mac, total: int, wide: Signal) -> int:
        """Write the result, rounded in the accumulator's word and then clamped; return what was rounded."""
        assert isinstance(operation.format, Signal)
        assert mac.limits is not None
        whole = total
        if mac.discard:
            signal = Signal(wide.width, operation.format.fraction)
            whole = self._emit(
                MachineOp.SHIFT_RIGHT, (total,), signal, operation, Shift(mac.discard, mac.rounding, wide.width)
            )
        low, high = mac.limits
        limits = Limits(Fraction(low), Fraction(high))
        self.body.append(replace(operation, op=MachineOp.CLAMP, args=(whole,), detail=limits))
        return whole

    def _rounded(self, operation: Operation, mac: Mac, total: int) -> None:
        """Write the result: what was summed, without the bits to be discarded, in the word of the result."""
        assert isinstance(operation.format, Signal)
        common = replace(operation, args=(total,), detail=None)
        if mac.discard:
            shift = Shift(mac.discard, mac.rounding, self.formats[total].width)
            self.body.append(replace(common, op=MachineOp.SHIFT_RIGHT, detail=shift))
            return
        last = self.body[-1] if self.body else None
        fresh = isinstance(last, Operation) and last.result == total and total not in operation.args
        if isinstance(last, Operation) and fresh and self.formats[total].width == operation.format.width:
            # The last sum is the result: it takes its name, format and bound.
            self.body[-1] = replace(last, result=operation.result, format=operation.format, bound=operation.bound)
            return
        narrower = self.formats[total].width > operation.format.width
        op = MachineOp.NARROW if narrower else MachineOp.SHIFT_LEFT
        self.body.append(replace(common, op=op, detail=None if narrower else Shift(0)))

    def _carried(self, operation: Operation, mac: Mac, total: int, wide: Signal) -> None:
        """Write acc + residual, its rounding, and what the rounding takes away as the residual of the next update."""
        assert mac.residual is not None
        assert isinstance(operation.format, Signal)
        name, index = mac.residual
        place = Place(name, index)
        kept = self.routine.block(name).format
        assert kept is not None
        called = self.names.get(operation.result, "value")
        carried = self.next
        self.next += 1
        self.body.append(
            Operation(
                carried, MachineOp.READ, place=place, step=operation.step, format=Signal(kept.width, wide.fraction)
            )
        )
        self.formats[carried] = Signal(kept.width, wide.fraction)
        self.names[carried] = f"{called}_carried"
        total = self._emit(MachineOp.ADD, (total, carried), wide, operation)
        self.names[total] = f"{called}_whole"
        rounded = operation.result
        if mac.limits is not None:
            rounded = self._clamped(operation, mac, total, wide)
        else:
            self._rounded(operation, mac, total)
        signal = Signal(kept.width, wide.fraction)
        left = self._emit(MachineOp.REMAINDER, (total, rounded), signal, operation, Shift(mac.discard))
        self.names[left] = f"{called}_left"
        # Kept at once: what waits for the end of the routine would hold a register until then.
        self.body.append(Write(place, left, operation.step))
