"""The series of small angles: no term too many, none too few, and what is left out is beneath the format."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

import mpmath
import pytest

from qcone.formats.floating import FLOATING
from qcone.ir.writing import SmallAngle
from qcone.passes.functions import choose_small_angle

F = Fraction
EXACT = mpmath.mp.clone()
EXACT.dps = 60


def errors(chosen: SmallAngle, t: Fraction) -> tuple[float, float]:
    """Return how far the polynomials are from sine and cosine at t."""
    sine = t + sum((c * t ** (3 + 2 * k) for k, c in enumerate(chosen.sine)), F(0))
    cosine = 1 + sum((c * t ** (2 + 2 * k) for k, c in enumerate(chosen.cosine)), F(0))
    angle = EXACT.mpf(t.numerator) / t.denominator
    parts = ((sine, EXACT.sin(angle)), (cosine, EXACT.cos(angle)))
    one, other = (float(abs(EXACT.mpf(have.numerator) / have.denominator - want)) for have, want in parts)
    return one, other


@pytest.mark.parametrize("largest", [F(1, 10**9), F(1, 20000), F(29, 10000), F(1746, 10000), F(1)])
@pytest.mark.parametrize("number", FLOATING)
def test_the_shortest_series_within_a_quarter_of_the_last_place(number: str, largest: Fraction) -> None:
    chosen = choose_small_angle(FLOATING[number], largest)
    allowed = FLOATING[number].ulp(F(1)) / 4
    for part in range(-8, 9):
        assert max(errors(chosen, largest * part / 8)) <= allowed
    shorter = [
        SmallAngle(largest, chosen.sine[:-1], chosen.cosine) if chosen.sine else None,
        SmallAngle(largest, chosen.sine, chosen.cosine[:-1]) if chosen.cosine else None,
    ]
    for which, each in enumerate(shorter):
        assert each is None or errors(each, largest)[which] > 0.9 * allowed


def test_coefficients_are_those_of_the_series() -> None:
    chosen = choose_small_angle(FLOATING["float64"], F(1))
    assert chosen.sine[:3] == (F(-1, 6), F(1, 120), F(-1, 5040))
    assert chosen.cosine[:3] == (F(-1, 2), F(1, 24), F(-1, 720))
    for k, coefficient in enumerate(chosen.sine):
        assert abs(coefficient) == F(1, factorial(3 + 2 * k))


def test_the_least_angles_need_no_term() -> None:
    chosen = choose_small_angle(FLOATING["float32"], F(1, 10**5))
    assert (chosen.sine, chosen.cosine) == ((), ())
