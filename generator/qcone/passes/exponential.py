"""Choose the polynomials of the exponential: kind, degree and exact coefficients, with the truncation bound.

With t = |phi| on [0, Phi], the vector part of r is phi/t sin(t/2) and the small scalar part cos(t/2) - 1.
The polynomials are t/2 + s_0 t^3 + s_1 t^5 + ... and c_0 t^2 + c_1 t^4 + ...; the 1/2 stays exact, so that
slow rotation is followed without a scale error. Their errors are bounded over the rationals: the difference
to a Taylor polynomial of high degree by Bernstein's form, the rest of the series by its first term (it
alternates and falls).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import factorial

from qcone.errors import UsageError
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.writing import Series
from qcone.passes import polynomial

PI_BELOW = Fraction(314159265358979, 10**14)
"""A rational just below pi: the largest rotation vector an update may declare."""
MOST_DEGREE = 14
UNSEEN = 64
"""How far below a last bit the truncation stays where roundings are carried: it adds up, update by update."""
EXTRA_TERMS = 4
"""Terms of the Taylor polynomial beyond the degree sought that stand for the function itself."""


@dataclass(frozen=True)
class Exponential:
    """The chosen series, the range it is for, and how far it can be from the exponential there.

    `phi_max` in rad; `scalar_error` bounds the error of cos(|phi|/2), `vector_error` that of the vector part
    (its Euclidean norm), both for every |phi| <= phi_max. `kind` is "minimax" or "taylor".
    """

    kind: str
    series: Series
    phi_max: Fraction
    scalar_error: Fraction
    vector_error: Fraction


def choose(kind: str, phi_max: Fraction, number: Floating | Fixed, accumulate: str) -> Exponential:
    """Return the series of least degree whose error disappears behind the rounding of its consumer.

    An error up to a quarter of the last bit of what it is added to is invisible there: for the vector part
    and, in the delta forms, for the small scalar part, the last bit of their own largest value; in the
    standard form the scalar part is added to 1. Raises UsageError when |phi| may reach pi.
    """
    if phi_max >= PI_BELOW:
        raise UsageError(
            f"the rotation vector may reach {float(phi_max):.3g} rad in one update, and an attitude update holds "
            "only below pi: raise update_hz or lower max_rate_dps"
        )
    cosine_end = 1 - phi_max * phi_max / 8 if accumulate == "standard" else phi_max * phi_max / 8
    scalar_goal = number.ulp(cosine_end) / 4
    vector_goal = number.ulp(phi_max / 2) / 4
    if isinstance(number, Fixed) and accumulate == "compensated":
        vector_goal /= UNSEEN  # roundings of the vector part are carried, what the polynomial lacks is not
    cosine, scalar_error = _least(kind, "cosine", phi_max, scalar_goal)
    sine, vector_error = _least(kind, "sine", phi_max, vector_goal)
    return Exponential(kind, Series(cosine, sine), phi_max, scalar_error, vector_error)


@cache
def _least(kind: str, function: str, end: Fraction, goal: Fraction) -> tuple[tuple[Fraction, ...], Fraction]:
    for degree in range(1, MOST_DEGREE + 1):
        coefficients = _coefficients(kind, function, degree, end, goal)
        error = truncation(function, coefficients, end)
        if error <= goal:
            return tuple(coefficients), error
    raise UsageError(f"no polynomial of degree {MOST_DEGREE} follows the {function} to |phi| = {float(end):.3g} rad")


def powers_of(function: str, degree: int) -> list[int]:
    """Return the powers of t = |phi| that the free coefficients belong to."""
    return [2 * k + (2 if function == "cosine" else 3) for k in range(degree)]


def taylor(function: str, degree: int) -> list[Fraction]:
    """Return the Taylor coefficients of cos(t/2) - 1 or sin(t/2) - t/2 that belong to `powers_of`."""
    return [Fraction((-1) ** (power // 2), 2**power * factorial(power)) for power in powers_of(function, degree)]


def truncation(function: str, coefficients: Sequence[Fraction], end: Fraction) -> Fraction:
    """Return a proven bound of the series' error for 0 <= t <= end."""
    long = len(coefficients) + EXTRA_TERMS
    while True:
        rest = abs(taylor(function, long + 1)[-1]) * end ** powers_of(function, long + 1)[-1]
        error = _difference(function, coefficients, long)
        largest = polynomial.bound(error, end)
        if rest <= largest / 100 or not largest:
            return largest + rest
        long += 2


def _difference(function: str, coefficients: Sequence[Fraction], long: int) -> list[Fraction]:
    powers = powers_of(function, long)
    error = [Fraction(0)] * (powers[-1] + 1)
    for power, coefficient in zip(powers, taylor(function, long), strict=True):
        error[power] = coefficient
    for power, coefficient in zip(powers, coefficients, strict=False):
        error[power] -= coefficient
    return error


def _coefficients(kind: str, function: str, degree: int, end: Fraction, goal: Fraction) -> list[Fraction]:
    if kind == "taylor":
        return taylor(function, degree)
    target = _difference(function, [], degree + EXTRA_TERMS)
    powers = powers_of(function, degree)
    exact = polynomial.best(target, powers, end)
    shortened = []
    for power, coefficient in zip(powers, exact, strict=True):
        room = goal / (64 * degree * end**power)
        shortened.append(polynomial.simplest(coefficient - room, coefficient + room))
    return shortened
