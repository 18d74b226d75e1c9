from __future__ import annotations

import math
import re
from fractions import Fraction

import numpy as np
import pytest

from qcone.reference import attitude, quaternion, weights

EPS = np.finfo(np.float64).eps
FLOOR = 1.2e-16  # of r, for increments rounded to float64

KEYS = {
    "taylor": "rv_uncompressed",
    "coning": "rv_compressed_spread",
    "compressed": "rv_compressed_last",
    "expanded": "rv_hybrid",
}
ALL_FORMS = [(n, name) for n in range(1, 7) for name in attitude.COEFFICIENTS]


def exact_key(subsamples: int, coefficients: str) -> str:
    return KEYS["coning" if coefficients == "expanded" and subsamples <= 3 else coefficients]


def as_float(table: dict[str, str]) -> dict[str, float]:
    return {key: float(Fraction(value)) for key, value in table.items()}


@pytest.mark.parametrize("n", range(1, 7))
def test_pair_tables_are_the_exact_ones(case, n: int) -> None:
    exact = case("coefficients")[str(n)]

    def named(coefficients: str) -> dict[str, float]:
        return {f"{i}x{j}": weight for (i, j), weight in attitude.pair_weights(n, coefficients).items()}

    assert named("taylor") == as_float(exact["uncompressed"])
    assert named("compressed") == as_float(exact["compressed_last"])
    spread = as_float(exact["compressed_spread"])
    pairs = {f"{i}x{j}": spread[str(j - i)] for i in range(1, n + 1) for j in range(i + 1, n + 1)}
    assert named("coning") == pairs
    assert named("expanded") == (as_float(exact["hybrid"]) if n >= 3 else named("coning"))
    assert dict(enumerate(weights.SPACING[n], 1)) == {
        int(d): float(Fraction(value)) for d, value in exact["compressed_Kd"].items()
    }


@pytest.mark.parametrize("n", range(1, 7))
def test_rate_table_is_the_exact_one(case, n: int) -> None:
    rows = case("coefficients")[str(n)]["rate_samples_T"]
    assert weights.RATE_SAMPLES[n] == tuple(tuple(float(Fraction(value)) for value in row) for row in rows)


def sine_series(terms: int) -> list[Fraction]:
    """Coefficients of x^0, x^1, .. of sin x."""
    return [Fraction((-1) ** (k // 2), math.factorial(k)) if k % 2 else Fraction(0) for k in range(terms)]


@pytest.mark.parametrize("p", range(1, 6))
def test_previous_weights_null_the_coning_error(p: int) -> None:
    """(x - sin x)/2 = 2 (1 - cos x) sum c_k sin k x up to x^(2P+1): the condition of pure coning, exactly."""
    terms = 2 * p + 4
    c = [Fraction(weight).limit_denominator(50_000) for weight in weights.PREVIOUS[p]]
    assert tuple(float(weight) for weight in c) == weights.PREVIOUS[p]
    sine = sine_series(terms)
    versine = [Fraction(0)] * 2 + [
        Fraction((-1) ** (k // 2 + 1), math.factorial(k)) if k % 2 == 0 else Fraction(0) for k in range(2, terms)
    ]
    lagged = [sum(weight * k**m for k, weight in enumerate(c, 1)) * sine[m] for m in range(terms)]
    left = [((1 if m == 1 else 0) - sine[m]) / 2 for m in range(terms)]
    right = [2 * sum(versine[i] * lagged[m - i] for i in range(m + 1)) for m in range(terms)]
    assert left[: 2 * p + 2] == right[: 2 * p + 2]
    assert left[2 * p + 3] != right[2 * p + 3]


@pytest.mark.parametrize(("n", "coefficients"), ALL_FORMS)
def test_update_meets_the_exact_value_on_motions(case, rounded, n: int, coefficients: str) -> None:
    for entry in case("truth_motions"):
        theta = rounded(entry["theta"])[:n]
        exact = rounded(entry["updates"][str(n)]["r_algorithm"][exact_key(n, coefficients)])
        r = attitude.exponential(attitude.rotation_vector(theta, coefficients))
        np.testing.assert_allclose(r, exact, atol=FLOOR, rtol=0, err_msg=entry["name"])


@pytest.mark.parametrize(("n", "coefficients"), ALL_FORMS)
def test_update_meets_the_exact_value_on_polynomials(case, rounded, n: int, coefficients: str) -> None:
    entries = [entry for entry in case("truth_polynomial") if entry["N"] == n]
    assert len(entries) == 2
    for entry in entries:
        exact = rounded(entry["r_algorithm"][exact_key(n, coefficients)])
        r = attitude.exponential(attitude.rotation_vector(rounded(entry["theta_exact"]), coefficients))
        np.testing.assert_allclose(r, exact, atol=FLOOR, rtol=0)


def test_picard_closed_meets_the_exact_single_sample_value(case, rounded) -> None:
    for entry in case("truth_motions"):
        exact = rounded(entry["updates"]["1"]["r_algorithm"]["rv_uncompressed"])
        r = attitude.picard(rounded(entry["theta"])[0], "closed")
        np.testing.assert_allclose(r, exact, atol=FLOOR, rtol=0)


@pytest.mark.parametrize(
    ("order", "norm_error", "power"), [(1, 1 / 8, 2), (2, 1 / 128, 4), (3, -1 / 384, 4), (4, None, 6)]
)
def test_picard_orders_have_their_norm_error(order, norm_error: float | None, power: int) -> None:
    errors = []
    for size in (0.4, 0.2):
        r = attitude.picard(size * np.array([0.36, -0.48, 0.8]), order)
        errors.append(np.linalg.norm(r) - 1)
    assert math.log2(errors[0] / errors[1]) == pytest.approx(power, abs=0.05)
    if norm_error is not None:
        assert errors[1] / 0.2**power == pytest.approx(norm_error, rel=0.01)


def test_picard_orders_approach_the_closed_form() -> None:
    theta = np.array([0.1, -0.2, 0.05])
    closed = attitude.picard(theta, "closed")
    errors = [np.abs(attitude.picard(theta, order) - closed).max() for order in (1, 2, 3, 4)]
    x = theta @ theta
    dropped = (x / 8, 0.2 * x / 48, x**2 / 384, 0.2 * x**2 / 3840)
    np.testing.assert_allclose(errors, dropped, rtol=0.01)


@pytest.mark.parametrize("n", range(1, 7))
def test_increments_from_rates_are_exact_to_degree_n(n: int) -> None:
    rng, interval = np.random.default_rng(n), 0.25
    u = np.linspace(0, 1, n + 1)
    for degree, exact in ((n, True), (n + 1, False)):
        polynomial = rng.normal(size=(5, degree + 1, 3))
        omega = np.einsum("tk,bki->bti", u[:, np.newaxis] ** np.arange(degree + 1), polynomial)
        powers = u[:, np.newaxis] ** np.arange(1, degree + 2) / np.arange(1, degree + 2)
        expected = interval * np.einsum("tk,bki->bti", np.diff(powers, axis=0), polynomial)
        dtheta = attitude.increments_from_rates(omega, interval)
        assert dtheta.shape == (5, n, 3)
        assert bool(np.abs(dtheta - expected).max() < 8 * EPS) is exact


def test_cao_13_is_exact_to_degree_two() -> None:
    u, interval = np.linspace(0, 1, 4), 0.1
    for degree, exact in ((0, True), (1, True), (2, True), (3, False)):
        omega = np.outer(u**degree, [1.0, -2.0, 0.5])
        expected = interval * np.outer(np.diff(u ** (degree + 1)) / (degree + 1), [1.0, -2.0, 0.5])
        error = np.abs(attitude.increments_cao_13(omega, interval) - expected).max()
        assert bool(error < 4 * EPS) is exact


def test_constant_rate_leaves_the_sum() -> None:
    dtheta = np.tile([0.01, -0.02, 0.03], (6, 1))
    for name in attitude.COEFFICIENTS:
        np.testing.assert_array_equal(attitude.rotation_vector(dtheta, name), np.sum(dtheta, axis=0))
    phi = attitude.rotation_vector_previous(dtheta[0], dtheta[:5])
    np.testing.assert_allclose(phi, dtheta[0], rtol=0, atol=1e-18)


def test_batches_are_the_single_cases() -> None:
    dtheta = np.random.default_rng(7).normal(size=(2, 5, 3, 3)) * 0.01
    batch = attitude.rotation_vector(dtheta, "taylor")
    np.testing.assert_array_equal(batch[1, 4], attitude.rotation_vector(dtheta[1, 4], "taylor"))
    previous = attitude.rotation_vector_previous(dtheta[..., 0, :], dtheta[..., 1:, :])
    np.testing.assert_allclose(
        previous[1, 4],
        attitude.rotation_vector_previous(dtheta[1, 4, 0], dtheta[1, 4, 1:]),
        rtol=0,
        atol=1e-18,
    )
    np.testing.assert_array_equal(attitude.picard(batch, 3)[1, 4], attitude.picard(batch[1, 4], 3))


def test_run_is_the_chain_of_updates() -> None:
    dtheta = np.random.default_rng(8).normal(size=(50, 3, 3)) * 0.02
    start = quaternion.normalise(np.array([1.0, 2.0, -3.0, 4.0]))
    attitudes = attitude.run(start, dtheta, coefficients="taylor")
    q = start
    for k in range(50):
        q = attitude.update(q, attitude.exponential(attitude.rotation_vector(dtheta[k], "taylor")))
        np.testing.assert_allclose(attitudes[k], q, atol=20 * EPS, rtol=0)


def test_run_starts_a_history_form_without_history() -> None:
    dtheta = np.random.default_rng(9).normal(size=(9, 3)) * 0.02
    start = np.array([1.0, 0.0, 0.0, 0.0])
    attitudes = attitude.run(start, dtheta[:, np.newaxis], previous=2)
    q = start
    for k in range(9):
        phi = dtheta[k] if k < 2 else attitude.rotation_vector_previous(dtheta[k], dtheta[[k - 1, k - 2]])
        q = attitude.update(q, attitude.exponential(phi))
        np.testing.assert_allclose(attitudes[k], q, atol=4 * EPS, rtol=0)
    resumed = attitude.run(attitudes[3], dtheta[4:, np.newaxis], previous=2, history=dtheta[[3, 2]])
    np.testing.assert_allclose(resumed, attitudes[4:], atol=4 * EPS, rtol=0)


def test_picard_run_multiplies_the_picard_updates() -> None:
    dtheta = np.random.default_rng(10).normal(size=(6, 3)) * 0.1
    start = np.array([1.0, 0.0, 0.0, 0.0])
    q = start
    for row in dtheta:
        q = attitude.update(q, attitude.picard(row, 2))
    np.testing.assert_allclose(attitude.run(start, dtheta[:, np.newaxis], order=2)[-1], q, atol=4 * EPS, rtol=0)


ONE, THREE = np.zeros((4, 1, 3)), np.zeros((4, 3, 3))
START = np.array([1.0, 0.0, 0.0, 0.0])

REFUSED = {
    "subsamples is 7, the tables hold 1 to 6": lambda: attitude.rotation_vector(np.zeros((7, 3))),
    "coefficients is 'best', choose one of taylor, coning, expanded, compressed": lambda: attitude.rotation_vector(
        THREE, "best"
    ),
    "previous holds 6 increments, the tables hold 1 to 5": lambda: attitude.rotation_vector_previous(
        np.zeros(3), np.zeros((6, 3))
    ),
    "order is 5, choose 1, 2, 3, 4 or 'closed'": lambda: attitude.picard(np.zeros(3), 5),
    "previous and order need one sub-sample an update, dtheta has 3": lambda: attitude.run(START, THREE, previous=1),
    "previous and order are different algorithms, choose one": lambda: attitude.run(START, ONE, previous=1, order=1),
    "history has shape (1, 3), previous = 2 needs (2, 3)": lambda: attitude.run(
        START, ONE, previous=2, history=np.zeros((1, 3))
    ),
    "omega holds 8 rates, the tables hold 2 to 7": lambda: attitude.increments_from_rates(np.zeros((8, 3)), 0.01),
    "omega holds 3 rates, cao (13) takes 4": lambda: attitude.increments_cao_13(np.zeros((3, 3)), 0.01),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_does_not_exist_is_refused(message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        REFUSED[message]()
