"""Polynomials with exact coefficients: rigorous bounds on an interval, and best uniform approximation.

Everything is rational, so the result is the same on every machine and the bound is a proof, not a
measurement. `bound` uses Bernstein's form: a polynomial on [0, 1] lies within the range of its Bernstein
coefficients; splitting the interval tightens that quadratically.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb, lcm
from operator import mul

from qcone.elimination import solve

Polynomial = Sequence[Fraction]
"""Coefficients from the constant on."""


def bound(polynomial: Polynomial, end: Fraction, pieces: int = 32) -> Fraction:
    """Return a rigorous upper bound of |polynomial| on [0, end]; within a few per cent of the maximum."""
    numerators, denominator = _whole(polynomial, end / pieces)
    n = len(numerators) - 1
    common = lcm(*(comb(n, k) for k in range(n + 1)))
    weights = [[comb(i, k) * (common // comb(n, k)) for k in range(i + 1)] for i in range(n + 1)]
    largest = 0
    for _ in range(pieces):
        for row in weights:
            largest = max(largest, abs(sum(map(mul, row, numerators))))
        for start in range(n):
            for k in range(n - 1, start - 1, -1):
                numerators[k] += numerators[k + 1]
    return Fraction(largest, denominator * common)


def _whole(polynomial: Polynomial, unit: Fraction) -> tuple[list[int], int]:
    """Return whole numbers a and d with polynomial(unit k) = sum a_i k^i / d: integer arithmetic is fast."""
    scaled = [coefficient * unit**power for power, coefficient in enumerate(polynomial)]
    denominator = lcm(*(each.denominator for each in scaled))
    return [int(each * denominator) for each in scaled], denominator


def _at_grid(polynomial: Polynomial, end: Fraction) -> list[int]:
    """Return polynomial(end k / GRID), k = 1 .. GRID, times one common factor that is left open."""
    numerators, _ = _whole(polynomial, end / GRID)
    values = []
    for k in range(1, GRID + 1):
        total = 0
        for numerator in reversed(numerators):
            total = total * k + numerator
        values.append(total)
    return values


def best(target: Polynomial, powers: Sequence[int], end: Fraction) -> list[Fraction]:
    """Return coefficients c with |target(t) - sum c_i t^powers_i| on [0, end] as small as can be.

    Remez' exchange in exact arithmetic: solve for an error of alternating sign at as many points as there
    are unknowns, move the points to the extremes of that error, repeat. Extremes are sought on a fixed grid
    of rationals; what the grid misses changes the result by less than a thousandth of the error.
    """
    count = len(powers) + 1
    points = [max(1, round(GRID * _spread(i, count))) for i in range(count)]
    coefficients: list[Fraction] = []
    for _ in range(ROUNDS):
        places = [end * k / GRID for k in points]
        solution = solve(
            [[*(t**power for power in powers), Fraction((-1) ** i)] for i, t in enumerate(places)],
            [sum((c * t**power for power, c in enumerate(target)), Fraction(0)) for t in places],
        )
        coefficients = solution[:-1]
        moved = _extremes(target, powers, coefficients, end, count)
        if moved is None or moved == points:
            break
        points = moved
    return coefficients


GRID = 256
ROUNDS = 8


def _spread(i: int, count: int) -> float:
    """Return where the i-th of `count` extremes of a Chebyshev polynomial lies in [0, 1], to a start's accuracy."""
    fraction = (i + 0.5) / count
    return fraction * fraction * (3 - 2 * fraction)


def _extremes(
    target: Polynomial, powers: Sequence[int], coefficients: Sequence[Fraction], end: Fraction, count: int
) -> list[int] | None:
    """Return the grid's points of largest error, one for each run of equal sign; None if there are too few runs."""
    error = list(target) + [Fraction(0)] * (max(powers) + 1 - len(target))
    for power, coefficient in zip(powers, coefficients, strict=True):
        error[power] -= coefficient
    runs: list[tuple[int, int]] = []
    sign = 0
    for k, at in enumerate(_at_grid(error, end), start=1):
        here = (at > 0) - (at < 0)
        if here and here != sign:
            runs.append((abs(at), k))
            sign = here
        elif here and abs(at) > runs[-1][0]:
            runs[-1] = (abs(at), k)
    if len(runs) < count:
        return None
    while len(runs) > count:
        runs.pop(0 if runs[0][0] < runs[-1][0] else -1)
    return [k for _, k in runs]


def simplest(low: Fraction, high: Fraction) -> Fraction:
    """Return the fraction of least denominator in [low, high]."""
    if low > high:
        low, high = high, low
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -simplest(-high, -low)
    whole = low.numerator // low.denominator
    if low == whole:
        return Fraction(whole)
    if whole + 1 <= high:
        return Fraction(whole + 1)
    return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole))


def shifted(polynomial: Polynomial, start: Fraction) -> list[Fraction]:
    """Return the coefficients in s of polynomial(start + s)."""
    result = list(polynomial)
    for first in range(len(result)):
        for k in range(len(result) - 2, first - 1, -1):
            result[k] += start * result[k + 1]
    return result
