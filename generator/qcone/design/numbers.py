"""Exact values from what a user wrote: decimals and rationals to Fractions, axes to a signed permutation."""

from __future__ import annotations

import re
from decimal import Decimal, DecimalException
from fractions import Fraction

_DECIMAL = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,4})?")
_RATIONAL = re.compile(r"([+-]?[0-9]{1,40}) */ *([0-9]{1,40})")
_MOST_DIGITS = 40
_LARGEST_EXPONENT = 30


def toml_float(text: str) -> Decimal:
    """Return the decimal that a TOML float spells, infinite where its exponent is beyond any use."""
    try:
        return Decimal(text)
    except DecimalException:
        return Decimal("inf")


def exact(value: object, *, rational: bool = False) -> Fraction | None:
    """Return `value` as the exact number written, or None when it is not a number.

    Takes int, Decimal and Fraction, and with `rational` also strings such as "2000/32768" and "0.061".

    Raises:
        OverflowError: beyond 40 digits or outside 1e-30 .. 1e30, infinite or not a number. Such a value is a
            slip, and an exact fraction of it could fill the memory.
        ZeroDivisionError: a rational over zero.

    """
    if isinstance(value, Fraction):
        return value
    if isinstance(value, str) and rational:
        text = value.strip()
        if match := _RATIONAL.fullmatch(text):
            return Fraction(int(match[1]), int(match[2]))
        value = toml_float(text) if _DECIMAL.fullmatch(text) else value
    if isinstance(value, bool) or not isinstance(value, int | Decimal):
        return None
    if isinstance(value, int):
        if abs(value) > 10**_LARGEST_EXPONENT:
            raise OverflowError
        return Fraction(value)
    if not value.is_finite() or len(value.as_tuple().digits) > _MOST_DIGITS:
        raise OverflowError
    if value and abs(value.adjusted()) > _LARGEST_EXPONENT:
        raise OverflowError
    return Fraction(value) if value else Fraction(0)


def is_decimal(text: str) -> bool:
    """Tell whether `text` spells a decimal number, as a command line gives it."""
    return _DECIMAL.fullmatch(text) is not None


def signed_permutation(text: str) -> tuple[tuple[int, int], ...] | None:
    """Return (sensor axis, sign) for each body axis of a text such as "y,-x,z", or None when it is not one.

    The body's first axis is then the sensor's y, its second the negated x, its third z.
    """
    parts = [part.strip() for part in text.split(",")]
    found = []
    for part in parts:
        sign, letter = (-1 if part.startswith("-") else 1), part.removeprefix("-")
        if letter not in ("x", "y", "z"):
            return None
        found.append(("xyz".index(letter), sign))
    return tuple(found) if sorted(axis for axis, _ in found) == [0, 1, 2] else None
