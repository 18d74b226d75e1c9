from __future__ import annotations

import math
import re

import numpy as np
import pytest

from qcone.reference import motions, quaternion, runge_kutta
from qcone.reference.adams_moulton import CORRECTOR, MIDDLES, MILNE, PREDICTOR, Run, adams_moulton

EPS = np.finfo(np.float64).eps


def run(
    motion: motions.Motion, interval: float, duration: float, starter: str, **options: bool
) -> tuple[Run, np.ndarray]:
    """The result, and the true attitudes at its instants."""
    times = np.arange(round(duration / interval) + 1) * interval
    truth = motion.attitude(times)
    return adams_moulton(truth[0], motion.rate(times), interval, starter, **options), truth[1:]


def worst_error(motion: motions.Motion, interval: float, duration: float, starter: str) -> float:
    result, truth = run(motion, interval, duration, starter)
    return float(quaternion.error_angle(result.attitude, truth)[result.ready].max())


@pytest.mark.parametrize(("weights", "newest", "constant"), [(PREDICTOR, 0, 251 / 720), (CORRECTOR, 1, -19 / 720)])
def test_weights_integrate_cubics(weights: np.ndarray, newest: int, constant: float) -> None:
    """The integral of x^m over 0..1 from the values at `newest` and the three instants before it."""
    nodes = newest - np.arange(4.0)
    for m in range(4):
        assert weights @ nodes**m == pytest.approx(1 / (m + 1), abs=8 * EPS)
    assert 1 / 5 - weights @ nodes**4 == pytest.approx(constant * math.factorial(4), rel=1e-13)


def test_middles_read_cubics() -> None:
    nodes, middles = np.arange(4.0), np.array([0.5, 1.5, 2.5])
    for m in range(4):
        np.testing.assert_allclose(MIDDLES @ nodes**m, middles**m, rtol=4 * EPS)
    assert not np.allclose(MIDDLES @ nodes**4, middles**4)


@pytest.mark.parametrize("motion", [motions.thesis_coning(2.5), motions.large_angle_manoeuvre()], ids=lambda m: m.name)
@pytest.mark.parametrize(("starter", "order"), [("heun", 3), ("runge-kutta-4", 4)])
def test_order_of_the_attitude(motion: motions.Motion, starter: str, order: int) -> None:
    """Heun's constant error of O(h^3) at the start hides the order of the method itself."""
    intervals = (0.002, 0.001) if motion.name == "large-angle" else (0.005, 0.0025)
    errors = [worst_error(motion, interval, 1.2, starter) for interval in intervals]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.2)


def test_the_better_starter_gains_forty_times() -> None:
    motion = motions.thesis_coning(2.5)
    heun, runge = (worst_error(motion, 0.005, 10.0, starter) for starter in ("heun", "runge-kutta-4"))
    assert heun == pytest.approx(3.9e-6, rel=0.02)
    assert runge == pytest.approx(9.7e-8, rel=0.02)


@pytest.mark.parametrize("frequency", ["2.5", "5"])
def test_thesis_coning_is_met_at_a_small_step(case, rounded, frequency: str) -> None:
    exact = case("truth_misc")["thesis2008"]["q"][frequency]
    motion, interval = motions.thesis_coning(float(frequency)), 1 / 4000
    result, _ = run(motion, interval, 1.0, "runge-kutta-4")
    errors = [quaternion.error_angle(result.attitude[-1], rounded(exact["1"]))]
    coarse, _ = run(motion, 2 * interval, 1.0, "runge-kutta-4")
    errors.append(quaternion.error_angle(coarse.attitude[-1], rounded(exact["1"])))
    assert errors[0] < 1e-11
    assert math.log2(errors[1] / errors[0]) == pytest.approx(4, abs=0.2)


# Mean Milne estimate over 10 s at steps of 2.5, 5, 7.5 and 10 ms, by frequency of the coning in Hz.
DRIFT = {
    2.5: (3.92e-11, 1.25e-9, 9.51e-9, 4.00e-8),
    5.0: (6.27e-10, 2.00e-8, 1.51e-7, 6.32e-7),
    10.0: (1.00e-8, 3.16e-7, 2.35e-6, 9.62e-6),
    20.0: (1.58e-7, 4.81e-6, 3.36e-5, 1.26e-4),
    25.0: (3.82e-7, 1.13e-5, 7.54e-5, 2.64e-4),
}


def drift(frequency: float, interval: float, **options: bool) -> float:
    result, _ = run(motions.thesis_coning(frequency), interval, 10.0, "heun", **options)
    return float(np.linalg.norm(result.estimate[3:], axis=-1).mean())


@pytest.mark.parametrize("renormalise", [True, False])
@pytest.mark.parametrize("frequency", DRIFT)
def test_drift_has_the_published_size(frequency: float, renormalise: bool) -> None:
    drifts = [drift(frequency, interval, renormalise=renormalise) for interval in (0.0025, 0.005, 0.0075, 0.01)]
    np.testing.assert_allclose(drifts, DRIFT[frequency], rtol=0.01)
    if frequency <= 20:
        assert 6.9 < drifts[2] / drifts[1] < 7.7
        assert 30 < drifts[1] / drifts[0] < 32.5
        assert 210 < drifts[2] / drifts[0] < 245


def test_drift_grows_with_frequency_as_published() -> None:
    assert drift(5.0, 0.005) / drift(2.5, 0.005) == pytest.approx(15.9, abs=0.2)
    assert drift(20.0, 0.005) / drift(17.5, 0.005) == pytest.approx(1.68, abs=0.05)


# |q| - 1 after 10 s without renormalisation, at steps of 5 and 10 ms, to two digits.
NORM_LOSS = {2.5: (2.3e-8, 6.4e-7), 5.0: (3.1e-7, 8.3e-6), 7.5: (1.4e-6, 3.1e-5), 10.0: (4.1e-6, 5.9e-5)}


@pytest.mark.parametrize("frequency", NORM_LOSS)
def test_norm_is_lost_as_published(frequency: float) -> None:
    for interval, published in zip((0.005, 0.01), NORM_LOSS[frequency], strict=True):
        free, _ = run(motions.thesis_coning(frequency), interval, 10.0, "heun", renormalise=False)
        kept, _ = run(motions.thesis_coning(frequency), interval, 10.0, "heun")
        norm = np.linalg.norm(free.attitude, axis=-1)
        assert float(f"{norm[-1] - 1:.1e}") == published
        # q (3 - |q|^2)/2 leaves three halves of the square.
        step = max(abs(norm[0] - 1), np.abs(np.diff(norm)).max())
        assert np.abs(np.linalg.norm(kept.attitude, axis=-1) - 1).max() < 1.6 * step**2 + 4 * EPS


@pytest.mark.parametrize("renormalise", [True, False])
def test_estimate_is_the_error_of_the_step(renormalise: bool) -> None:
    """true - c of the first step of the method, from a history good to one more order."""
    motion, differences = motions.thesis_coning(5.0), []
    for interval in (0.004, 0.002):
        result, truth = run(motion, interval, 4 * interval, "runge-kutta-4", renormalise=renormalise)
        turned = quaternion.product(quaternion.conjugate(truth[2]), truth[3])
        error = quaternion.product(result.attitude[2], turned) - result.attitude[3]
        estimate = result.estimate[3]
        if renormalise:  # which takes the part along q away
            estimate = estimate - (estimate @ truth[3]) * truth[3]
        differences.append(np.linalg.norm(estimate - error) / np.linalg.norm(error))
    assert differences[1] < 0.05
    assert differences[0] / differences[1] == pytest.approx(2, abs=0.05)


def textbook(start: np.ndarray, omega: np.ndarray, h: float, renormalise: bool) -> tuple[np.ndarray, np.ndarray]:
    """Heun, then the textbook's predictor and corrector, one line each."""

    def f(q: np.ndarray, k: int) -> np.ndarray:
        return quaternion.product(q, np.array([0.0, *omega[k]])) / 2

    def stored(q: np.ndarray) -> np.ndarray:
        return q * (3 - q @ q) / 2 if renormalise else q

    q, estimate = [start], np.zeros((len(omega) - 1, 4))
    for k in range(3):
        p = q[k] + h * f(q[k], k)
        q.append(stored(q[k] + h / 2 * (f(q[k], k) + f(p, k + 1))))
    for k in range(3, len(omega) - 1):
        f0, f1, f2, f3 = (f(q[k - i], k - i) for i in range(4))
        p = q[k] + h / 24 * (55 * f0 - 59 * f1 + 37 * f2 - 9 * f3)
        c = q[k] + h / 24 * (9 * f(p, k + 1) + 19 * f0 - 5 * f1 + f2)
        q.append(stored(c))
        estimate[k] = -19 / 270 * (c - p)
    return np.array(q[1:]), estimate


@pytest.mark.parametrize("renormalise", [True, False])
def test_run_is_the_textbook(renormalise: bool) -> None:
    motion, interval = motions.large_angle_manoeuvre(), 0.01
    omega = motion.rate(np.arange(101) * interval)
    start = quaternion.normalise(np.array([1.0, 2.0, -3.0, 4.0]))
    attitude, estimate = textbook(start, omega, interval, renormalise)
    result = adams_moulton(start, omega, interval, "heun", renormalise=renormalise)
    np.testing.assert_allclose(result.attitude, attitude, atol=100 * EPS, rtol=0)
    np.testing.assert_allclose(result.estimate, estimate, atol=100 * EPS, rtol=0)
    assert result.ready.all()


@pytest.mark.parametrize("renormalise", [True, False])
def test_runge_kutta_starter_holds_then_makes_three_steps(renormalise: bool) -> None:
    """With a rate that is a cubic the middle rates are exact."""
    polynomial = np.random.default_rng(2).normal(size=(4, 3))
    times = np.arange(13) * 0.05
    omega = times[:, np.newaxis] ** np.arange(4) @ polynomial
    start = quaternion.normalise(np.array([1.0, 2.0, -3.0, 4.0]))
    result = adams_moulton(start, omega[::2], 0.1, "runge-kutta-4", renormalise=renormalise)
    steps = runge_kutta.run_quaternion(start, omega[:7], 0.1)
    np.testing.assert_array_equal(result.attitude[:2], [start, start])
    assert result.ready.tolist() == [False, False, True, True, True, True]
    third = quaternion.normalise(steps[2]) if renormalise else steps[2]
    np.testing.assert_allclose(result.attitude[2], third, atol=20 * EPS, rtol=0)
    np.testing.assert_array_equal(result.estimate[:3], np.zeros((3, 4)))
    assert np.all(np.linalg.norm(result.estimate[3:], axis=-1) > 0)


@pytest.mark.parametrize("starter", ["heun", "runge-kutta-4"])
def test_start_attitude_turns_the_whole_run(starter: str) -> None:
    omega = motions.large_angle_manoeuvre().rate(np.arange(60) * 0.005)
    turn = quaternion.normalise(np.array([0.3, -0.2, 0.5, 0.7]))
    here = adams_moulton(np.array([1.0, 0, 0, 0]), omega, 0.005, starter)
    there = adams_moulton(turn, omega, 0.005, starter)
    np.testing.assert_allclose(there.attitude, quaternion.product(turn, here.attitude), atol=20 * EPS, rtol=0)
    np.testing.assert_allclose(there.estimate, quaternion.product(turn, here.estimate), atol=20 * EPS, rtol=0)


def test_milne_is_the_ratio_of_the_constants() -> None:
    assert pytest.approx((-19 / 720) / (251 / 720 + 19 / 720), rel=1e-15) == MILNE


REFUSED = {
    "starter is 'euler', choose heun or runge-kutta-4": lambda: adams_moulton(
        np.eye(4)[0], np.zeros((9, 3)), 0.1, "euler"
    ),
    "omega holds 3 rates, the starter takes 4": lambda: adams_moulton(np.eye(4)[0], np.zeros((3, 3)), 0.1),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_does_not_exist_is_refused(message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        REFUSED[message]()
