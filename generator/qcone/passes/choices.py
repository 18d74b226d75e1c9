"""Choices: the formats of a routine of sums, and what has been decided on the way to them."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Sum, Term
from qcone.ir.statement import Operation, Place, Routine, unused
from qcone.passes.fuse import is_power_of_two
from qcone.passes.magnitudes import Magnitudes


class UnfitError(UsageError):
    """A routine whose values do not fit the format: names the value and the bits that are missing."""


class PinError(UnfitError):
    """A pin that cannot be kept: names the value and what stands against it."""


class Choices:
    """What is decided of one routine: its statements as they now stand, and fewer bits where they were called for.

    `caps` are the most fraction bits of a value, `short` the bits by which a constant of a sum is shortened, `forced`
    the formats of what is written, `written` the value of each place, `split` the parts that are rounded first.
    """

    def __init__(self, routine: Routine, number: Fixed) -> None:
        """Decide nothing yet."""
        self.routine, self.number = routine, number
        self.names = dict(routine.names)
        self.caps: dict[int, int] = {}
        self.short: dict[tuple[int, int], int] = {}
        self.forced: dict[int, Signal] = {}
        self.written: dict[Place, int] = {}
        self.split: set[int] = set()
        self._next = unused(routine)

    def fresh(self) -> int:
        """Return a value that nothing defines yet."""
        value, self._next = self._next, self._next + 1
        return value


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

    def finest(self, operation: Operation) -> int:
        """Return the fraction bits of a sum's accumulator: not fewer than those of its result."""
        finest, _ = self.accumulated(operation)
        return max(finest, self.signals[operation.result].fraction)

    def accumulator_size(self, operation: Operation) -> Fraction:
        """Return the largest raw value in a sum's accumulator, in any order of its terms, rounding included."""
        assert isinstance(operation.detail, Sum)
        assert self.magnitudes is not None
        finest = self.finest(operation)
        size = Fraction(0)
        for at, term in enumerate(operation.detail.terms):
            low, high = self.magnitudes.term(term)
            most = max(-low, high)
            signal = self.constants.get((operation.result, at))
            if signal is not None:
                most = most / abs(term.coefficient) * abs(nearest(term.coefficient, signal))
            size += most
        subset = self.magnitudes.of_any_subset(operation)
        if subset is not None:
            size = min(size, subset)
        discard = finest - self.signals[operation.result].fraction
        rounding = Fraction(2) ** (discard - 1) if discard > 0 else Fraction(0)
        if operation.detail.carried:
            rounding *= 2
        return size * Fraction(2) ** finest + rounding


def exponent(power: Fraction) -> int:
    """Return k of 2^k or -2^k."""
    return abs(power.numerator).bit_length() - power.denominator.bit_length()


def nearest(value: Fraction, signal: Signal) -> Fraction:
    """Return the nearest multiple of the format's last bit, halves up."""
    return (value / signal.lsb + Fraction(1, 2)).__floor__() * signal.lsb
