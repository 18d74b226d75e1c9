"""Choose the polynomials of arctangent, sine, cosine and reciprocal root for a number format, with proven errors."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import factorial, isqrt

from qcone.elimination import solve
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.writing import Functions, SmallAngle
from qcone.passes import polynomial

EIGHTH = Fraction(41421356, 10**8)
"""tan(pi/8), just below: above it an angle is counted from pi/4."""
ARCTANGENT_END = Fraction(4143, 10**4)
"""The largest argument of the arctangent's polynomial: (1 - EIGHTH)/(1 + EIGHTH) and roundings are below it."""
QUARTER = Fraction(78540, 10**5)
"""Just above pi/4: the largest argument of sine and cosine polynomials."""
SPARE = 64
"""How far above the least normal number a ratio still counts for 0: past the roundings of the comparison."""
TRIGONOMETRIC_TERMS = 14
TERMS = 28
"""Terms of the arctangent's series that stand for the function: the next is below 2^-70 at the end."""


@cache
def choose_functions(number: Floating | Fixed) -> Functions:
    """Return the polynomials of least degree whose errors disappear in the format.

    The arctangent is within a quarter of the last bit of 1; two Newton steps take the reciprocal root to half of it.
    """
    ladder = tuple(1 << k for k in reversed(range((2 * number.precision).bit_length() - 1)))
    goal = number.ulp(Fraction(1)) / 4
    sine, cosine = _trigonometric(3, goal), _trigonometric(2, goal)
    smallest = Fraction(16, 2**number.precision)
    negligible = SPARE * number.smallest_normal if isinstance(number, Floating) else Fraction(0)
    root = _reciprocal_root(number)
    return Functions(_arctangent(goal), EIGHTH, root, ladder, sine, cosine, smallest, negligible)


@cache
def choose_small_angle(number: Floating | Fixed, largest: Fraction) -> SmallAngle:
    """Return the shortest series of sine and cosine for |t| <= `largest` <= 1 rad.

    The terms fall and alternate, so that what is left out is less than the first term left out: at most a quarter
    of the last bit of 1.
    """
    goal = number.ulp(Fraction(1)) / 4
    return SmallAngle(largest, _terms(3, largest, goal), _terms(2, largest, goal))


def _terms(power: int, largest: Fraction, goal: Fraction) -> tuple[Fraction, ...]:
    """Return the coefficients of t^power, t^(power + 2), ... of sine (power = 3) or cosine (power = 2)."""
    terms: list[Fraction] = []
    while largest**power / factorial(power) > goal:
        terms.append(Fraction((-1) ** (len(terms) + 1), factorial(power)))
        power += 2
    return tuple(terms)


def _arctangent(goal: Fraction) -> tuple[Fraction, ...]:
    target = _series()
    for degree in range(2, TERMS):
        powers = [2 * k + 3 for k in range(degree)]
        exact = polynomial.best(target, powers, ARCTANGENT_END)
        room = [goal / (64 * degree * ARCTANGENT_END**power) for power in powers]
        short = [polynomial.simplest(c - r, c + r) for c, r in zip(exact, room, strict=True)]
        if arctangent_error(short) <= goal:
            return tuple(short)
    raise AssertionError("the series has terms enough for every format")


def _trigonometric(first: int, goal: Fraction) -> tuple[Fraction, ...]:
    """Return the polynomial of sin(t) - t (first = 3) or cos(t) - 1 (first = 2) for 0 <= t <= QUARTER."""
    target = [Fraction(0)] * (first + 2 * TRIGONOMETRIC_TERMS)
    for k in range(TRIGONOMETRIC_TERMS):
        target[first + 2 * k] = Fraction((-1) ** (k + 1), factorial(first + 2 * k))
    rest = QUARTER ** (first + 2 * TRIGONOMETRIC_TERMS) / factorial(first + 2 * TRIGONOMETRIC_TERMS)
    for degree in range(2, TRIGONOMETRIC_TERMS):
        powers = [first + 2 * k for k in range(degree)]
        exact = polynomial.best(target, powers, QUARTER)
        room = [goal / (64 * degree * QUARTER**power) for power in powers]
        short = [polynomial.simplest(c - r, c + r) for c, r in zip(exact, room, strict=True)]
        error = list(target)
        for power, coefficient in zip(powers, short, strict=True):
            error[power] -= coefficient
        if polynomial.bound(error, QUARTER) + rest <= goal:
            return tuple(short)
    raise AssertionError("the series has terms enough for every format")


def _series() -> list[Fraction]:
    """Return the Taylor polynomial of atan(t) - t."""
    target = [Fraction(0)] * (2 * TERMS + 2)
    for k in range(1, TERMS + 1):
        target[2 * k + 1] = Fraction((-1) ** k, 2 * k + 1)
    return target


def arctangent_error(coefficients: list[Fraction]) -> Fraction:
    """Return a proven bound of the polynomial's error for |t| <= ARCTANGENT_END."""
    error = _series()
    for k, coefficient in enumerate(coefficients):
        error[2 * k + 3] -= coefficient
    rest = ARCTANGENT_END ** (2 * TERMS + 3) / (2 * TERMS + 3)
    return polynomial.bound(error, ARCTANGENT_END) + rest


def _reciprocal_root(number: Floating | Fixed) -> tuple[Fraction, ...]:
    """Return a polynomial p with |1/sqrt(t) - p(t)| so small on [1, 4] that two Newton steps reach the format."""
    goal = Fraction(1, 2**number.precision)
    for degree in range(2, 16):
        coefficients = _interpolated(degree)
        error = root_error(coefficients)
        once = 2 * error * error
        if 2 * once * once <= goal:
            return tuple(coefficients)
    raise AssertionError("the degree grows by one bit and a half a step")


def root_error(coefficients: list[Fraction]) -> Fraction:
    """Return a proven bound of |p(t) sqrt(t) - 1| on [1, 4]: |t p^2 - 1| bounds it where p is positive."""
    square = [Fraction(0)] * (2 * len(coefficients))
    for i, a in enumerate(coefficients):
        for k, b in enumerate(coefficients):
            square[i + k + 1] += a * b
    square[0] -= 1
    return polynomial.bound(polynomial.shifted(square, Fraction(1)), Fraction(3), 64)


def _interpolated(degree: int) -> list[Fraction]:
    """Interpolate 1/sqrt(t) where the error of a best polynomial of that degree nearly vanishes, in short fractions."""
    nodes = [Fraction(5, 2) + Fraction(3, 2) * _cosine(2 * k + 1, 2 * degree + 2) for k in range(degree + 1)]
    rows = [[t**power for power in range(degree + 1)] for t in nodes]
    roots = [Fraction(10**24, isqrt(int(t * 10**24) * 10**24)) for t in nodes]
    solution = solve(rows, roots)
    return [Fraction(round(c * 2**44), 2**44) for c in solution]


def _cosine(top: int, bottom: int) -> Fraction:
    """Return cos(pi top/bottom) to three digits: where nodes lie is a choice, not a constant of nature."""
    x = Fraction(314159, 10**5) * top / bottom
    total, term = Fraction(1), Fraction(1)
    for k in range(1, 12):
        term *= -x * x / ((2 * k - 1) * (2 * k))
        total += term
    return Fraction(round(total * 1000), 1000)
