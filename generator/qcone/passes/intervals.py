"""Intervals of exact rationals: sums, products, quotients, and rounding outwards."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

Interval = tuple[Fraction, Fraction]
ZERO = Fraction(0)
BITS = 40
"""Bounds are rounded outwards to so many bits: exact fractions would grow with every product."""


def plus(a: Interval, b: Interval) -> Interval:
    """Return the range of a + b."""
    return (a[0] + b[0], a[1] + b[1])


def times(a: Interval, b: Interval) -> Interval:
    """Return the range of a b."""
    products = [x * y for x in a for y in b]
    return (min(products), max(products))


def quotient(a: Interval, b: Interval) -> Interval:
    """Return the range of a / b. Raises ZeroDivisionError where b may be 0."""
    if b[0] <= 0 <= b[1]:
        raise ZeroDivisionError
    return times(a, (1 / b[1], 1 / b[0]))


def root_above(square: Fraction) -> Fraction:
    """Return a rational not below the square root, within 2^-60 of it, relatively."""
    if not square:
        return ZERO
    shift = max(0, 124 - (square.numerator.bit_length() - square.denominator.bit_length()))
    shift += shift % 2
    scaled = -(-square.numerator * (1 << shift) // square.denominator)
    return Fraction(isqrt(scaled) + 1, 1 << (shift // 2))


def outward(interval: Interval) -> Interval:
    """Round the ends outwards to `BITS` bits."""
    low, high = interval
    return (-_up(-low), _up(high))


def _up(value: Fraction) -> Fraction:
    if not value:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length() - BITS
    scale = Fraction(2) ** exponent
    return -(-value / scale).__floor__() * scale
