from __future__ import annotations

import math
import re
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest

from qcone.reference import motions, quaternion, taylor

EPS = np.finfo(np.float64).eps
ARCSEC = np.deg2rad(1 / 3600)
FLOOR = 1.2e-16  # of r, for increments rounded to float64: whatever the fit, its sums are exact
EXACT = [("quat_taylor10", 10, "start"), ("quat_taylor_mid8", 8, "midpoint"), ("quat_taylor_mid10", 10, "midpoint")]


@pytest.mark.parametrize("n", range(1, 7))
def test_rate_fits_are_the_exact_ones(case, n: int) -> None:
    exact = case("coefficients")[str(n)]
    for table, key in ((taylor.ABOUT_START, "rate_fit_T"), (taylor.ABOUT_MIDPOINT, "rate_fit_mid_T")):
        typed = [[Fraction(weight, denominator) for weight in weights] for denominator, weights in table[n]]
        assert typed == [[Fraction(value) for value in row] for row in exact[key]]


@pytest.mark.parametrize("about", ["start", "midpoint"])
@pytest.mark.parametrize("n", range(1, 7))
def test_rate_fit_recovers_a_polynomial(n: int, about: str) -> None:
    """In fractions: the sub-interval integrals of x^j give back the j-th unit vector."""
    shift = Fraction(0) if about == "start" else Fraction(1, 2)
    edges = [Fraction(i, n) - shift for i in range(n + 1)]
    for j in range(n):
        theta = [float((b ** (j + 1) - a ** (j + 1)) / (j + 1)) for a, b in pairwise(edges)]
        fit = taylor.rate_fit(np.array(theta)[:, np.newaxis] * np.ones(3), about)
        # The rounding of the increments themselves, through the largest weight of the fit.
        largest = max(abs(weight) / denominator for denominator, row in taylor.ABOUT_START[n] for weight in row)
        np.testing.assert_allclose(fit, np.eye(n)[j][:, np.newaxis] * np.ones(3), atol=largest * EPS, rtol=0)


@pytest.mark.parametrize(("key", "order", "about"), EXACT)
@pytest.mark.parametrize("n", range(1, 7))
def test_update_meets_the_exact_value_on_motions(case, rounded, n: int, key: str, order: int, about: str) -> None:
    for entry in case("truth_motions"):
        exact = rounded(entry["updates"][str(n)]["r_algorithm"][key])
        r = taylor.quaternion_taylor(rounded(entry["theta"])[:n], order, about)
        np.testing.assert_allclose(r, exact, atol=FLOOR, rtol=0, err_msg=entry["name"])


@pytest.mark.parametrize(("key", "order", "about"), EXACT)
@pytest.mark.parametrize("n", range(1, 7))
def test_update_meets_the_exact_value_on_polynomials(case, rounded, n: int, key: str, order: int, about: str) -> None:
    entries = [entry for entry in case("truth_polynomial") if entry["N"] == n]
    assert len(entries) == 2
    for entry in entries:
        r = taylor.quaternion_taylor(rounded(entry["theta_exact"]), order, about)
        np.testing.assert_allclose(r, rounded(entry["r_algorithm"][key]), atol=FLOOR, rtol=0)


@pytest.mark.parametrize("n", range(1, 7))
def test_long_series_are_the_exact_solution_for_a_polynomial_rate(case, rounded, n: int) -> None:
    for entry in (entry for entry in case("truth_polynomial") if entry["N"] == n):
        theta, exact = rounded(entry["theta_exact"]), rounded(entry["r_exact"])
        for about in ("start", "midpoint"):
            r = taylor.quaternion_taylor(theta, 24, about)
            np.testing.assert_allclose(r, exact, atol=FLOOR, rtol=0)
        # A matrix element moves twice as far as r; its exact value is rounded too.
        matrix = taylor.dcm_taylor(theta, 24)
        np.testing.assert_allclose(matrix, quaternion.to_matrix(exact), atol=2 * FLOOR + EPS, rtol=0)


def exact_matrix(theta: list[list[Fraction]], order: int) -> list[list[Fraction]]:
    """xu2019 (11) with the missing constants of (13), in fractions, N = 3 and T = 1: derivatives at the start."""
    first, second, third = theta
    a = [(11 * x - 7 * y + 2 * z) / 2 for x, y, z in zip(first, second, third, strict=True)]
    b = [Fraction(9, 2) * (-2 * x + 3 * y - z) for x, y, z in zip(first, second, third, strict=True)]
    c = [Fraction(9, 2) * (x - 2 * y + z) for x, y, z in zip(first, second, third, strict=True)]

    def skew(v: list[Fraction], factor: int) -> list[list[Fraction]]:
        x, y, z = (factor * component for component in v)
        return [[Fraction(0), -z, y], [z, Fraction(0), -x], [-y, x, Fraction(0)]]

    def times(p: list[list[Fraction]], q: list[list[Fraction]], factor: int) -> list[list[Fraction]]:
        return [[factor * sum(p[i][k] * q[k][j] for k in range(3)) for j in range(3)] for i in range(3)]

    rates = [skew(a, 1), skew(b, 2), skew(c, 6)]
    derivatives = [[[Fraction(int(i == j)) for j in range(3)] for i in range(3)]]
    for n in range(1, order + 1):
        parts = [times(derivatives[n - 1 - i], rates[i], math.comb(n - 1, i)) for i in range(min(n, 3))]
        derivatives.append([[sum(part[i][j] for part in parts) for j in range(3)] for i in range(3)])
    return [[sum(d[i][j] / math.factorial(n) for n, d in enumerate(derivatives)) for j in range(3)] for i in range(3)]


@pytest.mark.parametrize("order", [1, 2, 3, 4, 7, 10])
def test_dcm_meets_the_corrected_paper_in_fractions(order: int) -> None:
    theta = [[Fraction(x, 256) for x in row] for row in ((7, -3, 5), (2, 8, -4), (-6, 1, 9))]
    matrix = taylor.dcm_taylor(np.array(theta, dtype=np.float64), order)
    exact = np.array(exact_matrix(theta, order), dtype=np.float64)
    np.testing.assert_allclose(matrix, exact, atol=2 * EPS, rtol=0)


@pytest.mark.parametrize(
    ("form", "order"),
    [*((form, order) for form in ("start", "dcm") for order in (1, 2, 3, 6, 9)), ("midpoint", 1), ("midpoint", 2)],
)
def test_the_first_dropped_term_is_the_next_power(form: str, order: int) -> None:
    def update(theta: np.ndarray, cut: int) -> np.ndarray:
        if form == "dcm":
            return taylor.dcm_taylor_change(theta, cut)
        return taylor.quaternion_taylor_change(theta, cut, form)

    polynomial = np.random.default_rng(order).normal(size=(3, 3))
    errors = []
    for interval in (0.02, 0.01) if order < 6 else (0.4, 0.2):
        u = np.linspace(0, 1, 4)
        powers = [interval ** (j + 1) * np.diff(u ** (j + 1)) / (j + 1) for j in range(3)]
        theta = np.stack(powers, axis=-1) @ polynomial
        errors.append(np.abs(update(theta, order) - update(theta, 24)).max())
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order + 1, abs=0.2)


@pytest.mark.parametrize("size", [0.0, 5e-324, 1e-310, 2.3e-308, 1e-290, 1e-20])
def test_tiny_increments_are_their_sum(size: float) -> None:
    dtheta = size * np.array([[1.0, -2.0, 3.0]] * 3)
    change = taylor.quaternion_taylor_change(dtheta, 10)
    np.testing.assert_allclose(change, [0, *(1.5 * dtheta[0])], rtol=1e-15, atol=2e-323 + 16 * size**2)


def test_batches_are_the_single_cases() -> None:
    dtheta = np.random.default_rng(7).normal(size=(2, 5, 4, 3)) * 0.01
    for about in ("start", "midpoint"):
        batch = taylor.quaternion_taylor(dtheta, 8, about)
        assert batch.shape == (2, 5, 4)
        np.testing.assert_allclose(batch[1, 4], taylor.quaternion_taylor(dtheta[1, 4], 8, about), atol=EPS, rtol=0)
    matrices = taylor.dcm_taylor(dtheta, 8)
    assert matrices.shape == (2, 5, 3, 3)
    np.testing.assert_allclose(matrices[1, 4], taylor.dcm_taylor(dtheta[1, 4], 8), atol=EPS, rtol=0)


def test_runs_are_chains_of_updates() -> None:
    dtheta = np.random.default_rng(8).normal(size=(40, 3, 3)) * 0.02
    start = quaternion.normalise(np.array([1.0, 2.0, -3.0, 4.0]))
    for about in ("start", "midpoint"):
        attitudes, q = taylor.run_quaternion(start, dtheta, 8, about), start
        for k in range(40):
            q = quaternion.product(q, taylor.quaternion_taylor(dtheta[k], 8, about))
            np.testing.assert_allclose(attitudes[k], q, atol=20 * EPS, rtol=0)
    c = quaternion.to_matrix(start)
    matrices = taylor.run_dcm(c, dtheta, 8)
    for k in range(40):
        c = c @ taylor.dcm_taylor(dtheta[k], 8)
        np.testing.assert_allclose(matrices[k], c, atol=20 * EPS, rtol=0)


def worst_error(motion: motions.Motion, rate_hz: int, subsamples: int, form: str, order: int) -> float:
    updates = round(motion.duration * rate_hz) // subsamples
    times = np.arange(updates * subsamples + 1) / rate_hz
    truth = motion.attitude(times[::subsamples])
    dtheta = motion.increments(times).reshape(updates, subsamples, 3)
    if form == "dcm":
        q = quaternion.from_matrix(taylor.run_dcm(quaternion.to_matrix(truth[0]), dtheta, order))
    else:
        q = taylor.run_quaternion(truth[0], dtheta, order, form)
    return float(quaternion.error_angle(q, truth[1:]).max())


# The fit of N increments is of degree N - 1, and one better for an even N. Rates at which neither the truncation of the
# order nor the rounding of the increments shows.
@pytest.mark.parametrize("form", ["start", "midpoint", "dcm"])
@pytest.mark.parametrize(("n", "order", "slope"), [(1, 10, 2), (2, 10, 4), (3, 10, 4), (4, 10, 6), (5, 12, 6)])
def test_order_on_the_large_angle_manoeuvre(form: str, n: int, order: int, slope: int) -> None:
    errors = [worst_error(motions.large_angle_manoeuvre(), rate_hz, n, form, order) for rate_hz in (200, 400)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(slope, abs=0.2)


@pytest.mark.parametrize("form", ["start", "midpoint", "dcm"])
@pytest.mark.parametrize(
    ("n", "order", "slope"), [(1, 4, 2), (2, 6, 4), (3, 10, 4), (4, 10, 6), (5, 12, 6), (6, 16, 8)]
)
def test_order_on_the_thesis_coning(form: str, n: int, order: int, slope: int) -> None:
    errors = [worst_error(motions.thesis_coning(10.0), rate_hz * n, n, form, order) for rate_hz in (60, 120)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(slope, abs=0.2)


# A minute of coning at 100 Hz of sub-samples: form, N, order, largest error about x and about z in rad.
CONING_AT_100_HZ = [
    ("start", 3, 10, 9.9e-10, 1.8e-5),
    ("start", 4, 10, 4.5e-11, 2.4e-7),
    ("start", 5, 10, 1.5e-10, 9.8e-8),
    ("start", 6, 10, 3.2e-10, 1.8e-7),
    ("start", 4, 16, 3.0e-11, 2.4e-7),
    ("start", 5, 16, 5.0e-12, 9.9e-8),
    ("start", 6, 16, 3.2e-13, 2.6e-9),
    ("midpoint", 3, 10, 9.9e-10, 1.8e-5),
    ("midpoint", 4, 10, 3.0e-11, 2.4e-7),
    ("midpoint", 5, 10, 5.0e-12, 9.9e-8),
    ("midpoint", 6, 10, 1.6e-13, 2.8e-9),
]


@pytest.mark.parametrize(("form", "n", "order", "pitch", "yaw"), CONING_AT_100_HZ)
def test_a_minute_of_coning_has_the_published_error(form: str, n: int, order: int, pitch: float, yaw: float) -> None:
    motion = motions.coning()
    times = np.arange(6000 // n * n + 1) / 100
    truth = motion.attitude(times[::n])
    q = taylor.run_quaternion(truth[0], motion.increments(times).reshape(-1, n, 3), order, form)
    error = np.abs(quaternion.navigation_error(quaternion.normalise(q), truth[1:])).max(axis=0)
    assert error[0] == pytest.approx(pitch, rel=0.06)
    assert error[2] == pytest.approx(yaw, rel=0.06)


def quantised(n: int) -> tuple[np.ndarray, np.ndarray]:
    """The manoeuvre at 1 kHz through a pulse counter of one arcsec: increments, and the attitudes at the updates."""
    motion = motions.large_angle_manoeuvre()
    times = np.arange(1201) / 1000
    angle = np.concatenate([np.zeros((1, 3)), np.cumsum(motion.increments(times), axis=0)])
    dtheta = np.diff(ARCSEC * np.floor(angle / ARCSEC), axis=0).reshape(-1, n, 3)
    return dtheta, motion.attitude(times[::n])


@pytest.mark.parametrize(
    ("form", "order", "published"), [("start", 10, 1.2e-4), ("start", 16, 7.8e-6), ("midpoint", 10, 7.8e-6)]
)
def test_six_quantised_subsamples_have_the_published_error(form: str, order: int, published: float) -> None:
    dtheta, truth = quantised(6)
    q = taylor.run_quaternion(truth[0], dtheta, order, form)
    assert quaternion.error_angle(q, truth[1:]).max() == pytest.approx(published, rel=0.02)


def test_six_quantised_subsamples_cost_the_matrix_its_orthogonality() -> None:
    dtheta, truth = quantised(6)
    losses, errors = [], []
    for orthogonal in (False, True):
        c = taylor.run_dcm(np.eye(3), dtheta, 10, orthogonal=orthogonal)
        losses.append(np.abs(np.swapaxes(c, -1, -2) @ c - np.eye(3)).max())
        errors.append(quaternion.error_angle(quaternion.from_matrix(c), truth[1:]).max())
    assert losses[0] > 1e-2
    assert losses[1] < 1e-6
    assert errors[0] > 1e-3 > 2 * errors[1]


REFUSED = {
    "dtheta holds 7 sub-samples, the tables hold 1 to 6": lambda: taylor.quaternion_taylor(np.zeros((7, 3)), 10),
    "about is 'end', choose start or midpoint": lambda: taylor.quaternion_taylor(np.zeros((3, 3)), 10, "end"),
    "order is 0, the series starts at 1": lambda: taylor.quaternion_taylor(np.zeros((3, 3)), 0),
    "order is -1, the series starts at 1": lambda: taylor.dcm_taylor(np.zeros((3, 3)), -1),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_does_not_exist_is_refused(message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        REFUSED[message]()
