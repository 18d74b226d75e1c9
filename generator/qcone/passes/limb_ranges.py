"""Ranges of sums of limbs: by intervals and, where the addends are part of a scalar product, by lengths as well.

|a . b| <= |a| |b| (Cauchy, Schwarz) bounds every part of a scalar product, in any order. Of the limbs of a vector x of
m components, each cut at bit k, x = high 2^k + low: |high| <= (|x| + |low|) / 2^k, and |low| <= sqrt(m) 2^k.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from qcone.formats.fixed import Signal
from qcone.ir.statement import Operation, Routine
from qcone.passes.choices import Formats
from qcone.passes.intervals import root_above

WORD = 32
LEAST, MOST = -(1 << (WORD - 1)), (1 << (WORD - 1)) - 1
Range = tuple[int, int]
Norms = Sequence[tuple[frozenset[int], Fraction]]
"""What is known of the Euclidean norms of sets of values."""


def known_norms(found: Formats) -> Norms:
    """Return what is known of the lengths of a routine's vectors and quaternions, roundings included."""
    if found.magnitudes is None:
        return ()
    several = [(number, group) for number, group in enumerate(found.routine.groups) if len(group.values) > 1]
    norms = [(group, found.magnitudes.norm(number)) for number, group in several]
    values = [(frozenset(each if each >= 0 else ~each for each in group.values), norm) for group, norm in norms]
    return tuple((words, norm[1]) for words, norm in values if norm is not None)


@dataclass(frozen=True)
class Limb:
    """A part of a word, `position` bits up in it, in raw words: a value, or a constant where `value` is None.

    `range` are its least and its greatest value, `word` is the value it is a part of, `bits` where that is cut.
    """

    position: int
    range: Range
    value: int | None
    word: int
    bits: int


@dataclass(frozen=True)
class Addend:
    """What is added at a bit position: the product of two limbs, a value, or a constant where it is neither.

    `range` is that of the product, value or constant; `order` that of the term it comes from.
    """

    range: Range
    limbs: tuple[Limb, ...] = ()
    value: int | None = None
    negative: bool = False
    order: int = 0

    @property
    def signed(self) -> Range:
        """Return the range with the sign."""
        low, high = self.range
        return (-high, -low) if self.negative else (low, high)

    @property
    def constant(self) -> bool:
        """Tell whether it is a constant."""
        return self.value is None and not self.limbs


class Words:
    """What is known of the words of a routine: names, raw ranges, raw constants, formats, norms."""

    def __init__(self, routine: Routine, norms: Norms = ()) -> None:
        """Take every value of the routine; the ranges are those of its bounds, which hold of rounded values."""
        self.names = routine.names
        self.ranges: dict[int, Range] = {}
        self.constants: dict[int, int] = {}
        self.formats: dict[int, Signal] = {}
        for each in routine.body:
            if not isinstance(each, Operation) or not isinstance(each.format, Signal):
                continue
            self.formats[each.result] = each.format
            if each.constant is not None:
                self.constants[each.result] = each.format.raw(each.constant)
            elif each.format.width == WORD:
                most = int(each.bound / each.format.lsb) if each.bound is not None else -LEAST
                self.ranges[each.result] = (max(-most, LEAST), min(most, MOST))
        self._norms = list(self._raw(norms))
        self._memo: dict[frozenset[int], Fraction] = {}

    def _raw(self, norms: Norms) -> Iterable[tuple[frozenset[int], Fraction]]:
        """Yield the norms of words of one format, in their last bits."""
        for values, norm in norms:
            signals = {self.formats.get(each) for each in values}
            signal = signals.pop()
            if signal is not None and not signals:
                yield values, norm / signal.lsb

    def norm(self, words: frozenset[int]) -> Fraction:
        """Return a bound of the norm of some words, in their last bits."""
        if words not in self._memo:
            known = [norm for values, norm in self._norms if words <= values]
            self._memo[words] = min([*known, _length(self.ranges[each] for each in words)])
        return self._memo[words]

    def sum(self, addends: Sequence[Addend]) -> Range:
        """Return a range that a sum, and every part of it, stays within."""
        low = high = 0
        alike: dict[tuple[int, ...], list[Addend]] = {}
        for each in addends:
            if len(each.limbs) == 2 and all(limb.value is not None for limb in each.limbs):
                one, other = each.limbs
                alike.setdefault((one.position, one.bits, other.position, other.bits), []).append(each)
                continue
            low, high = low + min(each.signed[0], 0), high + max(each.signed[1], 0)
        for some in alike.values():
            least = sum(min(each.signed[0], 0) for each in some)
            most = sum(max(each.signed[1], 0) for each in some)
            size = int(self._limbs([each.limbs[0] for each in some]) * self._limbs([each.limbs[1] for each in some]))
            low, high = low + max(least, -size), high + min(most, size)
        return low, high

    def _limbs(self, limbs: Sequence[Limb]) -> Fraction:
        """Return a bound of the norm of limbs of one position, one of each word."""
        own = _length(limb.range for limb in limbs)
        words = frozenset(limb.word for limb in limbs)
        if not limbs[0].position or len(words) < len(limbs):
            return own
        scale = 1 << limbs[0].bits
        return min(own, (self.norm(words) + root_above(Fraction(len(limbs))) * scale) / scale)


def _length(ranges: Iterable[Range]) -> Fraction:
    return root_above(Fraction(sum(max(-low, high) ** 2 for low, high in ranges)))
