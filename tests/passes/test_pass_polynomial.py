"""Polynomials over the rationals: the bound is a proof and close, the approximation is the best one."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qcone.passes.polynomial import best, bound, simplest

F = Fraction
SAMPLES = 240


def at(polynomial: list[Fraction], t: Fraction) -> Fraction:
    return sum((c * t**k for k, c in enumerate(polynomial)), F(0))


def sampled(polynomial: list[Fraction], end: Fraction) -> Fraction:
    """Return the largest |value| on a grid that contains both ends."""
    return max(abs(at(polynomial, end * k / SAMPLES)) for k in range(SAMPLES + 1))


RATIONALS = st.fractions(min_value=-5, max_value=5, max_denominator=50)


@settings(deadline=None, max_examples=30)
@given(st.lists(RATIONALS, min_size=1, max_size=8), st.fractions(F(1, 10), 3, max_denominator=20))
def test_the_bound_holds(polynomial: list[Fraction], end: Fraction) -> None:
    assert bound(polynomial, end) >= sampled(polynomial, end)


CHEBYSHEV = [F(int(c)) for c in np.polynomial.chebyshev.cheb2poly([0] * 9 + [1])]


@pytest.mark.parametrize(
    ("polynomial", "end", "largest"),
    [
        ([F(-3)], F(2), F(3)),
        ([F(0), F(1)], F(5, 3), F(5, 3)),
        ([F(0), F(1), F(-1)], F(1), F(1, 4)),
        ([F(1), F(-2), F(1)], F(3), F(4)),
        (CHEBYSHEV, F(1), F(1)),
        ([F(0)] * 8 + [F(7)], F(1, 2), F(7, 2**8)),
    ],
)
def test_the_bound_is_close(polynomial: list[Fraction], end: Fraction, largest: Fraction) -> None:
    assert largest <= bound(polynomial, end) <= largest * F(11, 10)


@pytest.mark.parametrize("degree", [1, 2, 3, 4])
@pytest.mark.parametrize("end", [F(1, 10), F(1), F(3)])
def test_the_bound_of_an_error_is_close(degree: int, end: Fraction) -> None:
    """What it is for: the difference of a function and its approximation, of many equal extremes."""
    error = approximation_error(degree, end)
    largest = sampled(error, end)
    assert largest <= bound(error, end) <= largest * F(11, 10)


def test_more_pieces_are_closer() -> None:
    assert 1 <= bound(CHEBYSHEV, F(1), 64) < bound(CHEBYSHEV, F(1), 16) < bound(CHEBYSHEV, F(1), 8)


TARGET = [F(0) if k % 2 else F((-1) ** (k // 2), 2**k * factorial(k)) for k in range(20)]
TARGET[0] = F(0)
"""cos(t/2) - 1 as a long Taylor polynomial."""


def approximation_error(degree: int, end: Fraction) -> list[Fraction]:
    powers = [2 * k + 2 for k in range(degree)]
    error = list(TARGET)
    for power, coefficient in zip(powers, best(TARGET, powers, end), strict=True):
        error[power] -= coefficient
    return error


def extremes(error: list[Fraction], end: Fraction) -> list[Fraction]:
    """Return the largest value of each run of one sign, with its sign."""
    found: list[Fraction] = []
    for k in range(1, 20 * SAMPLES // 8 + 1):
        value = at(error, end * k / (20 * SAMPLES // 8))
        if not value:
            continue
        if not found or (found[-1] > 0) != (value > 0):
            found.append(value)
        elif abs(value) > abs(found[-1]):
            found[-1] = value
    return found


@pytest.mark.parametrize("degree", [1, 2, 3, 4])
@pytest.mark.parametrize("end", [F(1, 10), F(1), F(3)])
def test_the_best_approximation_equioscillates(degree: int, end: Fraction) -> None:
    """De la Vallee-Poussin: degree + 1 alternating extremes, the smallest bounds what any approximation must miss."""
    found = [abs(value) for value in extremes(approximation_error(degree, end), end)]
    assert len(found) == degree + 1
    assert min(found) / max(found) > F(95, 100)


def test_a_polynomial_is_its_own_best_approximation() -> None:
    target = [F(0), F(0), F(1, 3), F(0), F(-2, 7)]
    assert best(target, [2, 4], F(1)) == [F(1, 3), F(-2, 7)]


def test_the_best_line_through_the_origin() -> None:
    """t^2 by c t on [0, 1]: c = 2 (sqrt 2 - 1), the error (sqrt 2 - 1)^2 there and at the end."""
    (slope,) = best([F(0), F(0), F(1)], [1], F(1))
    assert abs(float(slope) - 2 * (2**0.5 - 1)) < 1e-4


@given(RATIONALS, RATIONALS)
def test_simplest(a: Fraction, b: Fraction) -> None:
    low, high = min(a, b), max(a, b)
    found = simplest(low, high)
    assert low <= found <= high
    for denominator in range(1, found.denominator):
        assert not any(low <= F(k, denominator) <= high for k in (int(low * denominator) + d for d in (-1, 0, 1)))


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [(F(-1), F(1), F(0)), (F(1, 3), F(1, 2), F(1, 2)), (F(314, 100), F(315, 100), F(22, 7)), (F(2), F(9, 4), F(2))],
)
def test_simplest_examples(low: Fraction, high: Fraction, expected: Fraction) -> None:
    assert simplest(low, high) == expected == simplest(high, low) == -simplest(-low, -high)
