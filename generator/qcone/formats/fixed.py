"""Fixed point: a signal is a two's-complement word of W bits with F fraction bits, value = raw * 2^-F.

F may be larger than W: a small quantity has only fraction bits. A number format names the word that values are kept
in and the word twice as wide in which sums are made; it says how a sum is rounded back, once, and what happens beyond
the declared range.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

ROUNDINGS = ("up", "even", "floor")


@dataclass(frozen=True)
class Signal:
    """How one value is kept: `width` bits, of which `fraction` follow the binary point (any integer)."""

    width: int
    fraction: int

    @property
    def name(self) -> str:
        """Return the name of the format, such as s32.F36."""
        return f"s{self.width}.F{self.fraction}"

    @property
    def ctype(self) -> str:
        """Return the C type of the word."""
        return f"int{self.width}_t"

    @property
    def lsb(self) -> Fraction:
        """Return the value of the last bit."""
        return Fraction(2) ** -self.fraction

    @property
    def most(self) -> int:
        """Return the largest raw value."""
        return (1 << (self.width - 1)) - 1

    def raw(self, value: Fraction) -> int:
        """Return the raw word of an exactly representable value; ValueError for any other."""
        raw = value / self.lsb
        if raw.denominator != 1 or not -self.most - 1 <= raw <= self.most:
            raise ValueError(f"{value} is not a value of {self.name}")
        return int(raw)

    def nearest(self, value: Fraction) -> Fraction:
        """Return the nearest value of the format, halves up; ValueError beyond its range."""
        raw = (value / self.lsb + Fraction(1, 2)).__floor__()
        if not -self.most - 1 <= raw <= self.most:
            raise ValueError(f"{value} is beyond the range of {self.name}")
        return raw * self.lsb


@dataclass(frozen=True)
class Fixed:
    """A fixed-point number format: values in `width` bits, sums and carried states in twice as many.

    `rounding` of what a sum discards: "up" is to nearest, halves up, "even" to nearest, halves to even, "floor" down.
    `overflow` beyond the declared range: "prove" (none can happen within it), "saturate" or "wrap".
    """

    name: str
    width: int
    rounding: str = "up"
    overflow: str = "prove"

    @property
    def wide(self) -> int:
        """Return the width in bits of sums and carried states."""
        return 2 * self.width

    @property
    def ctype(self) -> str:
        """Return the C type of a value."""
        return f"int{self.width}_t"

    @property
    def wraps(self) -> bool:
        """Tell whether what is beyond a word wraps around."""
        return self.overflow == "wrap"

    @property
    def precision(self) -> int:
        """Return how many bits a value has beside its sign."""
        return self.width - 1

    def signal(self, bound: Fraction, width: int | None = None) -> Signal:
        """Return the finest format in which every value up to `bound` in size can be kept; 0 bounds take all bits."""
        width = width or self.width
        most = 2 ** (width - 1) - 1
        if not bound:
            return Signal(width, width - 1)
        fraction = width - 1 - _above(bound)
        if bound * Fraction(2) ** fraction > most:
            fraction -= 1
        return Signal(width, fraction)

    def ulp(self, value: Fraction) -> Fraction:
        """Return the last bit of the finest format that can hold `value`."""
        return self.signal(abs(value)).lsb

    def rounding_error(self, lsb: Fraction) -> Fraction:
        """Return the largest error of one rounding to multiples of `lsb`."""
        return lsb if self.rounding == "floor" else lsb / 2


def _above(bound: Fraction) -> int:
    """Return the least k with bound <= 2^k."""
    guess = bound.numerator.bit_length() - bound.denominator.bit_length()
    for k in (guess - 1, guess, guess + 1):
        if bound <= Fraction(2) ** k:
            return k
    raise AssertionError(bound)


WIDTHS = {"fixed32": 32, "fixed16": 16}
