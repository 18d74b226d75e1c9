"""Binary floating point: float32 and float64 of IEEE 754, with rounding done once, in exact arithmetic."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class Floating:
    """A binary floating-point format: `precision` bits of significand, exponents from `lowest` up.

    `lowest` is the exponent of the smallest normal number's last bit's weight 2^(lowest): subnormals are
    multiples of it. `suffix` ends a C literal; `digits` is enough to read any number back exactly.
    """

    name: str
    ctype: str
    precision: int
    lowest: int
    digits: int
    suffix: str

    def ulp(self, value: Fraction) -> Fraction:
        """Return the spacing of numbers of this format at `value`; at a power of two, the spacing above it."""
        return Fraction(2) ** max(_exponent(abs(value)) - self.precision + 1, self.lowest) if value else self.tiny

    @property
    def tiny(self) -> Fraction:
        """Return the smallest positive number, a subnormal."""
        return Fraction(2) ** self.lowest

    @property
    def smallest_normal(self) -> Fraction:
        """Return the smallest positive normal number."""
        return Fraction(2) ** (self.lowest + self.precision - 1)

    def round(self, value: Fraction) -> Fraction:
        """Return the nearest number of the format, ties to even, as an exact fraction.

        The constants of an attitude update are far from the ends of the exponent range; a value that would
        overflow raises OverflowError.
        """
        if not value:
            return value
        spacing = self.ulp(value)
        rounded = round(value / spacing) * spacing
        if abs(rounded) >= Fraction(2) ** (2 - self.lowest - self.precision + 1):
            raise OverflowError(f"{value} is beyond the range of {self.name}")
        return rounded

    def literal(self, value: Fraction) -> str:
        """Return `value`, rounded to the fewest decimal digits that read back as exactly this number of the format.

        That is the shortest literal there is, but for some powers of two: below them numbers lie closer than
        above, and a decimal that is not the nearest of its length may read back with a digit less.
        """
        if self.round(value) != value:
            raise ValueError(f"{value} is not a number of {self.name}; round it first")
        for digits in range(1, self.digits + 1):
            text = _decimal(value, digits)
            if self._reads(text, value):
                return (text if any(mark in text for mark in ".e") else text + ".0") + self.suffix
        raise ValueError(f"{self.digits} digits do not hold {value} in {self.name}")

    def _reads(self, text: str, value: Fraction) -> bool:
        """Tell whether a decimal reads back as `value`; one of few digits may lie beyond the largest number."""
        try:
            return self.round(Fraction(text)) == value
        except OverflowError:
            return False


@dataclass(frozen=True)
class Truth:
    """A truth value: 1 or 0."""

    name: str = "truth"
    ctype: str = "int32_t"


TRUTH = Truth()


def _exponent(value: Fraction) -> int:
    """Return floor(log2(value)) of a positive fraction."""
    guess = value.numerator.bit_length() - value.denominator.bit_length()
    return guess if Fraction(2) ** guess <= value else guess - 1


def _decimal(value: Fraction, digits: int) -> str:
    """Return `value` rounded to that many significant decimal digits, in the style of %g."""
    if not value:
        return "0"
    sign, value = ("-" if value < 0 else ""), abs(value)
    exponent = 0
    while value >= Fraction(10) ** (exponent + 1):
        exponent += 1
    while value < Fraction(10) ** exponent:
        exponent -= 1
    number = round(value / Fraction(10) ** (exponent - digits + 1))
    if number == 10**digits:
        number, exponent = number // 10, exponent + 1
    text = str(number).rstrip("0")
    if -5 < exponent < 16:
        if exponent < 0:
            return f"{sign}0.{'0' * (-exponent - 1)}{text}"
        whole = text[: exponent + 1].ljust(exponent + 1, "0")
        return f"{sign}{whole}.{text[exponent + 1 :] or '0'}"
    return f"{sign}{text[0]}.{text[1:] or '0'}e{exponent:+03d}"


FLOAT32 = Floating("float32", "float", 24, -149, 9, "F")
FLOAT64 = Floating("float64", "double", 53, -1074, 17, "")
FLOATING = {each.name: each for each in (FLOAT32, FLOAT64)}
