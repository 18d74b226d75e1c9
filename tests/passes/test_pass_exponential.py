"""The polynomials of the exponential: their stated error is one, and not much more than the error is."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import factorial

import mpmath
import pytest

from qcone.errors import UsageError
from qcone.formats.floating import FLOAT32, FLOAT64, Floating
from qcone.passes.exponential import PI_BELOW, Exponential, choose, taylor, truncation

F = Fraction
RANGES = [F(1, 1000), F(102, 1000), F(1, 2), F(2), F(314, 100)]
ACCUMULATE = ["delta", "standard", "compensated"]
SAMPLES = 300


def high(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def scalar_error(chosen: Exponential, t: mpmath.mpf) -> mpmath.mpf:
    polynomial = sum(high(c) * t ** (2 * k) for k, c in enumerate(chosen.series.cosine, 1))
    return mpmath.cos(t / 2) - 1 - polynomial


def vector_error(chosen: Exponential, t: mpmath.mpf) -> mpmath.mpf:
    polynomial = sum(high(c) * t ** (2 * k + 1) for k, c in enumerate((F(1, 2), *chosen.series.sine)))
    return mpmath.sin(t / 2) - polynomial


@pytest.mark.parametrize("accumulate", ["delta", "standard"])
@pytest.mark.parametrize("phi_max", RANGES)
@pytest.mark.parametrize("number", [FLOAT32, FLOAT64], ids=lambda number: number.name)
@pytest.mark.parametrize("kind", ["minimax", "taylor"])
def test_the_stated_error(kind: str, number: Floating, phi_max: Fraction, accumulate: str) -> None:
    """Measured to 40 digits and more: nowhere above what is stated, and somewhere within 1.2 of it."""
    chosen = choose(kind, phi_max, number, accumulate)
    with mpmath.workdps(100):
        points = [high(phi_max) * k / SAMPLES for k in range(1, SAMPLES + 1)]
        for stated, error in ((chosen.scalar_error, scalar_error), (chosen.vector_error, vector_error)):
            measured = max(abs(error(chosen, t)) for t in points)
            assert measured <= high(stated) <= mpmath.mpf("1.2") * measured


@pytest.mark.parametrize("phi_max", RANGES)
@pytest.mark.parametrize("number", [FLOAT32, FLOAT64], ids=lambda number: number.name)
@pytest.mark.parametrize("kind", ["minimax", "taylor"])
def test_the_error_hides_behind_the_rounding(kind: str, number: Floating, phi_max: Fraction) -> None:
    """A quarter of the last bit of what it is added to: v, and cos - 1 or cos itself."""
    for accumulate in ACCUMULATE:
        chosen = choose(kind, phi_max, number, accumulate)
        assert chosen.vector_error <= number.ulp(phi_max / 2) / 4
        consumer = 1 - phi_max**2 / 8 if accumulate == "standard" else phi_max**2 / 8
        assert chosen.scalar_error <= number.ulp(consumer) / 4


@pytest.mark.parametrize("kind", ["minimax", "taylor"])
def test_the_degree_is_the_least(kind: str) -> None:
    """One coefficient fewer, the best one of its kind, is not enough."""
    from qcone.passes import exponential

    for phi_max in RANGES[1:]:
        chosen = choose(kind, phi_max, FLOAT32, "delta")
        goals = {"cosine": FLOAT32.ulp(phi_max**2 / 8) / 4, "sine": FLOAT32.ulp(phi_max / 2) / 4}
        for function, coefficients in (("cosine", chosen.series.cosine), ("sine", chosen.series.sine)):
            if len(coefficients) > 1:
                fewer = exponential._coefficients(kind, function, len(coefficients) - 1, phi_max, goals[function])
                assert truncation(function, fewer, phi_max) > goals[function]


def degrees(chosen: Exponential) -> tuple[int, int]:
    return len(chosen.series.cosine), len(chosen.series.sine)


def test_degrees_for_firmware() -> None:
    """float32 at up to 0.102 rad an update: cos of degree 2, sin of degree 1 in |phi|^2."""
    assert degrees(choose("minimax", F(102, 1000), FLOAT32, "delta")) == (2, 1)


@pytest.mark.parametrize("kind", ["minimax", "taylor"])
@pytest.mark.parametrize("number", [FLOAT32, FLOAT64], ids=lambda number: number.name)
def test_the_degree_grows_with_the_range(kind: str, number: Floating) -> None:
    found = [degrees(choose(kind, phi_max, number, "delta")) for phi_max in RANGES]
    for smaller, larger in pairwise(found):
        assert smaller[0] <= larger[0]
        assert smaller[1] <= larger[1]
    assert found[0][0] < found[2][0] < found[-1][0]


def test_the_degree_grows_with_the_format() -> None:
    for phi_max in RANGES[1:]:
        narrow, wide = (degrees(choose("minimax", phi_max, number, "delta")) for number in (FLOAT32, FLOAT64))
        assert narrow[0] < wide[0]
        assert narrow[1] < wide[1]


def test_minimax_is_no_longer_than_taylor() -> None:
    pairs = [(choose("minimax", end, FLOAT64, "delta"), choose("taylor", end, FLOAT64, "delta")) for end in RANGES]
    assert all(degrees(a)[k] <= degrees(b)[k] for a, b in pairs for k in (0, 1))
    assert any(degrees(a) != degrees(b) for a, b in pairs)


def test_standard_needs_less_of_the_scalar_part() -> None:
    """Added to 1, the scalar part shows only what is above the last bit of 1."""
    for phi_max in RANGES[:3]:
        standard, delta = (choose("minimax", phi_max, FLOAT64, each) for each in ("standard", "delta"))
        assert degrees(standard)[0] <= degrees(delta)[0]
        assert degrees(standard)[1] == degrees(delta)[1]
    assert (
        degrees(choose("minimax", RANGES[1], FLOAT64, "standard"))[0]
        < degrees(choose("minimax", RANGES[1], FLOAT64, "delta"))[0]
    )


def test_taylor_has_the_coefficients_of_taylor() -> None:
    """cos(t/2) - 1 = sum (-1)^k (t/2)^2k / (2k)!, sin(t/2) / t likewise: exact."""
    series = choose("taylor", F(2), FLOAT64, "delta").series
    assert series.cosine == tuple(F((-1) ** k, 4**k * factorial(2 * k)) for k in range(1, len(series.cosine) + 1))
    assert series.sine == tuple(F((-1) ** k, 2 * 4**k * factorial(2 * k + 1)) for k in range(1, len(series.sine) + 1))
    assert taylor("cosine", 2) == [F(-1, 8), F(1, 384)]
    assert taylor("sine", 2) == [F(-1, 48), F(1, 3840)]


def test_minimax_is_near_taylor_and_short() -> None:
    chosen = choose("minimax", F(102, 1000), FLOAT32, "delta")
    assert abs(chosen.series.cosine[0] + F(1, 8)) < F(1, 10**6)
    assert abs(chosen.series.sine[0] + F(1, 48)) < F(1, 10**4)
    assert all(each.denominator < 10**12 for each in (*chosen.series.cosine, *chosen.series.sine))


@pytest.mark.parametrize("phi_max", [PI_BELOW, F(22, 7), F(4)])
def test_half_a_turn_is_too_much(phi_max: Fraction) -> None:
    with pytest.raises(UsageError) as caught:
        choose("minimax", phi_max, FLOAT32, "delta")
    assert str(caught.value) == (
        f"the rotation vector may reach {float(phi_max):.3g} rad in one update, and an attitude update holds only "
        "below pi: raise update_hz or lower max_rate_dps"
    )


def test_just_below_half_a_turn_is_not() -> None:
    assert F(3141592653589794, 10**15) > PI_BELOW
    assert choose("minimax", PI_BELOW - F(1, 10**9), FLOAT32, "delta").phi_max < PI_BELOW


def test_the_bound_covers_the_rest_of_the_series() -> None:
    """No coefficients at all: the error is the function, whose largest value is at the end."""
    with mpmath.workdps(40):
        for function, largest in (("cosine", 1 - mpmath.cos(1)), ("sine", mpmath.mpf(1) - mpmath.sin(1))):
            assert largest <= high(truncation(function, [], F(2))) <= mpmath.mpf("1.2") * largest
