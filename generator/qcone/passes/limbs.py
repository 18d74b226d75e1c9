"""Limbs: sums of products of words, made of 32-bit products of their parts: for cores whose products have 32 bits.

A word is cut into a low limb, its last bits, and a high limb, the rest: x = high 2^k + low. Products of limbs that
stand at one bit position are added first, in one word, and the whole is carried to the next position once:

    floor((a 2^k + b) / 2^n) = floor((a + floor(b / 2^k)) / 2^(n - k)),    0 <= k <= n.

What stands at the last discarded bit or above is added after the rounding. All of it is exact, and every word on the
way is proved to fit. A sum for which that is not so is left to others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from qcone.formats.fixed import Signal
from qcone.ir.detail import Aligned, Mac, Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation
from qcone.passes.limb_levels import Level, UnprovedError, levels_of, spread
from qcone.passes.limb_ranges import LEAST, MOST, WORD, Addend, Limb, Range, Words

HALF = WORD // 2
"""The bits that cores extend to a word in one instruction."""
WEIGHTS = {MachineOp.MULTIPLY: 2}
"""Instructions of an operation where it is more than one: a product overwrites a factor, which is copied before."""


@dataclass(frozen=True)
class Cut:
    """Where a word is cut: `bits` in its low limb, 0 for none; from -2^(bits-1) on if that is `signed`, else from 0."""

    bits: int
    signed: bool = True

    @property
    def weight(self) -> int:
        """Return the instructions it takes."""
        return 2 + self.signed + (self.bits != HALF) if self.bits else 0


Total = tuple[int, tuple[Addend, ...]]
"""A sum: its value, and the addends in it."""


class LimbSums:
    """Sums of one routine, made of limbs: `operations` collects them, `weight` counts the instructions they take."""

    def __init__(self, words: Words, cuts: Mapping[int, Cut], free: int) -> None:
        """Take what is known of the words, how they are cut, and the first number of a new value."""
        self.names: dict[int, str] = {}
        self.words, self.cuts, self.next = words, cuts, free
        self.operations: list[Operation] = []
        self.weight = 0
        self.made: dict[int, tuple[Limb, ...]] = {}
        self.step = self.fraction = 0

    def make(self, operation: Operation, mac: Mac) -> None:
        """Make the result of a sum of products. Raises UnprovedError where a word is not proved to fit."""
        assert isinstance(operation.format, Signal)
        self.step, self.fraction = operation.step, operation.format.fraction + mac.discard
        places, rounding = self._places(mac)
        levels, carries = levels_of(self.words, places, mac.discard, rounding)
        above = {place: addends for place, addends in sorted(places.items()) if place >= mac.discard}
        # The result is known to fit, and so is what is added to the carries to make it.
        result = int(operation.bound / operation.format.lsb) if operation.bound is not None else MOST
        late = result + sum(max(-low, high) for low, high in carries)
        sums = self._products(levels, above, late, mac.discard)
        carried = self._carried(levels, sums, rounding)
        if above:
            carried.append(self._above(above, sums, late, mac.discard))
        total: Total | None = None
        for each in carried:
            total = self._more(total, each, mac.discard, result if each is carried[-1] else None)
        last = self.operations[-1]
        assert total is not None
        assert last.result == total[0]
        self.operations[-1] = replace(last, result=operation.result, format=operation.format, bound=operation.bound)

    def _places(self, mac: Mac) -> tuple[dict[int, list[Addend]], str]:
        """Return what stands at each position, and the rounding: a half that is part of a constant needs no other."""
        places: dict[int, list[Addend]] = {}
        constant = 0
        for order, term in enumerate(mac.terms):
            if len(term.args) == 1 and term.args[0] in self.words.constants:
                raw = self.words.constants[term.args[0]] << term.shift
                constant += -raw if term.negative else raw
                continue
            for place, addend in self._term(term, order):
                places.setdefault(place, []).append(addend)
        below = sorted(place for place in places if place < mac.discard)
        if not below or below[0]:
            raise UnprovedError
        rounding, ends = mac.rounding, sorted({*places, mac.discard} if max(places) < mac.discard else places)
        kept = spread(constant, ends)
        if rounding == "up" and below[-1] in kept:
            rounding, kept = "floor", spread(constant + (1 << (mac.discard - 1)), ends)
        for place, raw in kept.items():
            known = Addend((abs(raw), abs(raw)), negative=raw < 0, order=len(mac.terms))
            places.setdefault(place, []).append(known)
        return places, rounding

    def _term(self, term: Aligned, order: int) -> list[tuple[int, Addend]]:
        """Return the products of limbs that a term is the sum of, and where they stand."""
        if len(term.args) == 1:
            word = term.args[0]
            return [(term.shift, Addend(self.words.ranges[word], (), word, term.negative, order))]
        square = term.args[0] == term.args[1]
        found = []
        for one in self.limbs(term.args[0]):
            for other in self.limbs(term.args[1]):
                if square and other.position < one.position:
                    continue  # (h 2^k + l)^2 = h^2 2^2k + h l 2^(k+1) + l^2
                twice = square and other is not one
                ends = [x * y for x in one.range for y in other.range]
                least = 0 if square and not twice else min(ends)
                place = one.position + other.position + term.shift + twice
                found.append((place, Addend((least, max(ends)), (one, other), None, term.negative, order)))
        return found

    def limbs(self, word: int) -> tuple[Limb, ...]:
        """Return the limbs of a word, the low one first; a word is cut once."""
        if word not in self.made:
            self.made[word] = self._constant(word) if word in self.words.constants else self._cut(word)
        return self.made[word]

    def _constant(self, word: int) -> tuple[Limb, ...]:
        raw, cut = self.words.constants[word], self.cuts[word]
        if not cut.bits:
            return (Limb(0, (raw, raw), None, word, 0),)
        low = raw % (1 << cut.bits)
        if cut.signed and low >= 1 << (cut.bits - 1):
            low -= 1 << cut.bits
        parts = ((0, low), (cut.bits, (raw - low) >> cut.bits))
        return tuple(Limb(place, (part, part), None, word, cut.bits) for place, part in parts if part)

    def _cut(self, word: int) -> tuple[Limb, ...]:
        cut, (least, most) = self.cuts[word], self.words.ranges[word]
        bits, signal = cut.bits, self.words.formats[word]
        if not bits:
            return (Limb(0, (least, most), word, word, 0),)
        start = -(1 << (bits - 1)) if cut.signed else 0
        ends, before = (start, start + (1 << bits) - 1), self.weight
        rest, drop = word, Shift(bits, "floor", WORD)
        if cut.signed:
            low = self._emit(MachineOp.LOW, (word,), signal, ends, Shift(bits))
            rest = self._emit(MachineOp.SUBTRACT, (word, low), signal, (least - ends[1], most - ends[0]))
        limits = (least - start >> bits, most - start >> bits)
        high = self._emit(MachineOp.SHIFT_RIGHT, (rest,), Signal(WORD, signal.fraction - bits), limits, drop)
        if not cut.signed:
            low = self._emit(MachineOp.REMAINDER, (word, high), signal, ends, Shift(bits))
        self.weight = before + cut.weight
        if word in self.words.names:
            self.names |= {low: f"{self.words.names[word]}_low", high: f"{self.words.names[word]}_high"}
        return (Limb(0, ends, low, word, bits), Limb(bits, limits, high, word, bits))

    def _products(
        self, levels: Sequence[Level], above: Mapping[int, Sequence[Addend]], late: int, discard: int
    ) -> dict[tuple[int, int], Total]:
        """Make the products and add them to their piles, term by term: limbs are used while they are at hand."""
        jobs = [(each, (level.place, at)) for level in levels for at, pile in enumerate(level.piles) for each in pile]
        jobs += [(each, (place, 0)) for place, addends in above.items() for each in addends]
        # Parts of a sum of squares are no larger than the sum.
        rising = all(each.signed[0] >= 0 for addends in above.values() for each in addends)
        sums: dict[tuple[int, int], Total] = {}
        for each, (place, at) in sorted(jobs, key=lambda job: (job[0].negative, job[0].order)):
            most = late >> (place - discard) if rising and place >= discard else None
            sums[place, at] = self._more(sums.get((place, at)), each, place, most)
        return sums

    def _carried(self, levels: Sequence[Level], sums: Mapping[tuple[int, int], Total], rounding: str) -> list[Addend]:
        """Carry each level to the next; return what is carried beyond the last one."""
        carried: list[Addend] = []
        for level in levels:
            whole, handed, bits = sums[level.place, 0], carried, level.bits
            for each in handed:
                whole = self._more(whole, each, level.place)
            carried = []
            signal, own = Signal(WORD, self.fraction - level.upper), Signal(WORD, self.fraction - level.place)
            for at in range(1, len(level.piles)):
                value, (low, high) = sums[level.place, at][0], self.words.sum(sums[level.place, at][1])
                limits = (low >> bits, high >> bits)
                carry = self._emit(MachineOp.SHIFT_RIGHT, (value,), signal, limits, Shift(bits, "floor", WORD))
                rest = (0, (1 << bits) - 1)
                left = self._emit(MachineOp.REMAINDER, (value, carry), own, rest, Shift(bits))
                whole = self._more(whole, Addend(rest, value=left), level.place)
                carried.append(Addend(limits, value=carry))
            low, high = (end + level.half for end in self.words.sum(whole[1]))
            word = "floor" if level is not levels[-1] else rounding
            shift, limits = Shift(bits, word, WORD), (low >> bits, high >> bits)
            carry = self._emit(MachineOp.SHIFT_RIGHT, (whole[0],), signal, limits, shift)
            carried.insert(0, Addend(limits, value=carry))
        return carried

    def _above(
        self, above: Mapping[int, Sequence[Addend]], sums: Mapping[tuple[int, int], Total], late: int, discard: int
    ) -> Addend:
        """Return what stands at the last discarded bit and above, as a number of last bits of the result."""
        places = [*sorted(above, reverse=True), discard]
        # What is added so far is the whole, which is known, less what is to come.
        most, left = {}, late
        for place in sorted(above):
            most[place] = left >> (place - discard)
            left += max(map(abs, self.words.sum(above[place]))) << (place - discard)
        whole: Total | None = None
        for place, lower in pairwise(places):
            here = sums[place, 0]
            if whole is not None:
                here = self._more(here, Addend(self.words.sum(whole[1]), value=whole[0]), place)
            low, high = self.words.sum(here[1])
            low, high = max(low, -most[place]), min(high, most[place])
            bits, value = place - lower, here[0]
            limits = (low << bits, high << bits)
            if bits:
                signal = Signal(WORD, self.fraction - lower)
                value = self._emit(MachineOp.SHIFT_LEFT, (value,), signal, limits, Shift(bits))
            whole = value, (Addend(limits, value=value),)
        assert whole is not None
        return whole[1][0]

    def _more(self, total: Total | None, each: Addend, place: int, most: int | None = None) -> Total:
        """Add to a sum, or begin one; where `most` is given it is known, by other reasons, to be no larger."""
        signal = Signal(WORD, self.fraction - place)
        if total is None and each.constant:
            return self._literal(each.signed[0], self.fraction - place), (each,)
        value = self._value(each, place)
        if total is None:
            if each.negative:
                value = self._emit(MachineOp.NEGATE, (value,), signal, each.signed)
            return value, (each,)
        both = (*total[1], each)
        low, high = self.words.sum(both)
        if most is not None:
            low, high = max(low, -most), min(high, most)
        op = MachineOp.SUBTRACT if each.negative else MachineOp.ADD
        return self._emit(op, (total[0], value), signal, (low, high)), both

    def _value(self, addend: Addend, place: int) -> int:
        """Return the value of an addend without its sign."""
        if addend.value is not None:
            return addend.value
        if addend.constant:
            return self._literal(addend.range[0], self.fraction - place)
        bits = sum(self.words.formats[limb.word].fraction - limb.position for limb in addend.limbs)
        signal = Signal(WORD, bits)
        known, other = sorted(addend.limbs, key=lambda limb: limb.value is not None)
        if other.value is None:
            raise UnprovedError
        if known.value is not None:
            return self._emit(MachineOp.MULTIPLY, (known.value, other.value), signal, addend.range)
        factor = known.range[0]
        if factor > 0 and not factor & (factor - 1):
            shift = Shift(factor.bit_length() - 1)
            shifted = shift.bits and self._emit(MachineOp.SHIFT_LEFT, (other.value,), signal, addend.range, shift)
            return shifted or other.value
        fraction = self.words.formats[known.word].fraction - known.position
        return self._emit(MachineOp.MULTIPLY, (self._literal(factor, fraction), other.value), signal, addend.range)

    def _literal(self, raw: int, fraction: int) -> int:
        signal = Signal(WORD, fraction)
        if not LEAST <= raw <= MOST:
            raise UnprovedError
        value, self.next, self.weight = self.next, self.next + 1, self.weight + 1
        literal = Operation(value, MachineOp.LITERAL, constant=raw * signal.lsb, step=self.step, format=signal)
        self.operations.append(literal)
        return value

    def _emit(
        self, op: MachineOp, args: tuple[int, ...], signal: Signal, limits: Range, shift: Shift | None = None
    ) -> int:
        """Append an operation whose result is proved to stay within the limits."""
        if not LEAST <= limits[0] <= limits[1] <= MOST:
            raise UnprovedError
        rounded = shift is not None and shift.rounding == "up"
        value, self.next, self.weight = self.next, self.next + 1, self.weight + WEIGHTS.get(op, 1) + rounded
        self.operations.append(Operation(value, op, args, step=self.step, format=signal, detail=shift))
        return value
