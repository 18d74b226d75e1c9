from __future__ import annotations

import re
from itertools import pairwise

import mpmath
import numpy as np
import pytest

from qcone.reference import kinematics, motions, quaternion

EPS = np.finfo(np.float64).eps

EXACT = {
    "coning_xu2019": lambda: motions.coning(),
    "coning_fast_small": lambda: motions.coning(np.deg2rad(0.1), 100 * np.pi),
    "large_angle_t0.0": motions.large_angle_manoeuvre,
    "large_angle_t0.6": motions.large_angle_manoeuvre,
}


@pytest.mark.parametrize("name", EXACT)
def test_increments_and_attitudes_meet_the_exact_cases(case, rounded, name: str) -> None:
    exact = next(entry for entry in case("truth_motions") if entry["name"] == name)
    motion = EXACT[name]()
    times = float(exact["t0"]) + float(exact["s"]) * np.arange(13)
    theta, q = rounded(exact["theta"]), rounded(exact["q"])
    peak_rate = np.linalg.norm(motion.rate(times), axis=-1).max()
    # The instants themselves are rounded: both ends of an interval by at most half a unit.
    late = peak_rate * np.spacing(times[-1])
    np.testing.assert_allclose(motion.increments(times), theta, atol=late + np.spacing(np.abs(theta).max()), rtol=0)
    attitude = motion.attitude(times)
    if name.startswith("large"):  # the cases there start from the identity
        attitude = quaternion.product(quaternion.conjugate(attitude[0]), attitude)
        integrated = kinematics.integrate(motion.rate, motion.increments, times)
        assert quaternion.error_angle(integrated, q).max() < late + EPS / 2
    assert quaternion.error_angle(attitude, q).max() < late + 2 * EPS


def test_there_is_an_exact_case_for_each_name(case) -> None:
    assert {entry["name"] for entry in case("truth_motions")} == set(EXACT)


@pytest.mark.parametrize("frequency", ["2.5", "5", "10", "20", "25"])
def test_thesis_coning_meets_the_exact_attitudes(case, rounded, frequency: str) -> None:
    exact = case("truth_misc")["thesis2008"]["q"][frequency]
    q = motions.thesis_coning(float(frequency)).attitude(np.array([float(t) for t in exact]))
    assert quaternion.error_angle(q, rounded(list(exact.values()))).max() < EPS


@pytest.mark.parametrize("name", motions.MOTIONS)
def test_increments_are_the_integral_of_the_rate(name: str) -> None:
    motion = motions.MOTIONS[name]()
    times = np.sort(np.random.default_rng(6).uniform(0, motion.duration, 40))
    times = np.sort(np.concatenate([times, times + 2e-3]))
    x, weights = np.polynomial.legendre.leggauss(24)
    inner = np.linspace(times[:-1], times[1:], 21)  # panels short against the fastest vibration
    panels = np.zeros((len(times) - 1, 3))
    for begin, end in pairwise(inner):
        nodes = (begin + end)[:, np.newaxis] / 2 + np.outer(end - begin, x) / 2
        rate = motion.rate(nodes.ravel()).reshape(*nodes.shape, 3)
        panels += np.einsum("n,k,nki->ni", (end - begin) / 2, weights, rate)
    np.testing.assert_allclose(motion.increments(times), panels, rtol=0, atol=1e-13)


@pytest.mark.parametrize("name", motions.MOTIONS)
def test_increments_do_not_cancel_over_short_intervals(name: str) -> None:
    motion = motions.MOTIONS[name]()
    times = 0.37 + 2.0**-40 * np.arange(3)
    np.testing.assert_allclose(
        motion.increments(times) / 2.0**-40, motion.rate(times[:-1] + 2.0**-41), rtol=0, atol=1e-13
    )


@pytest.mark.parametrize("name", motions.MOTIONS)
def test_attitude_follows_the_rate(name: str) -> None:
    motion = motions.MOTIONS[name]()
    times = np.linspace(0.0, min(motion.duration, 2.0), 21)
    q = motion.attitude(times)
    integrated = kinematics.integrate(motion.rate, motion.increments, times, start=q[0], step=7e-4)
    turned = np.linalg.norm(motion.rate(np.linspace(0, times[-1], 500)), axis=-1).mean() * times[-1]
    assert quaternion.error_angle(integrated, q).max() < (1 + turned) * EPS
    np.testing.assert_allclose(np.linalg.norm(q, axis=-1), 1, atol=4 * EPS, rtol=0)


def test_a_minute_of_coning_stays_at_rounding() -> None:
    motion = motions.coning()
    times = np.array([0.0, 59.0, 60.0])
    q = motion.attitude(times)
    integrated = kinematics.integrate(motion.rate, motion.increments, times, start=q[0], step=4e-3)
    # The same roundings return in every turn of the cone: half a unit of an increment, 15 000 times.
    assert quaternion.error_angle(integrated, q).max() < 15_000 * np.spacing(1.1 * 4e-3) / 2


def test_large_angle_is_the_printed_angle() -> None:
    tau = np.array([0.0, 0.3, 1.2])
    sine, versine = np.sin(2.6 * np.pi * tau), 1 - np.cos(2.6 * np.pi * tau)
    x = -1.1 * tau + 0.45 * tau**2 - 0.6 * tau**3 + 1.1 * tau**4 - 0.1 * tau**5 + 0.2 * sine + 0.3 * versine
    y = -0.5 * tau + 1.0 * tau**2 - 0.3 * tau**3 + 0.7 * tau**4 - 0.2 * tau**5 - 0.5 * sine + 0.6 * versine
    z = 0.3 * tau - 1.2 * tau**2 + 2.0 * tau**3 - 0.9 * tau**4 + 0.4 * tau**5 + 0.8 * sine - 0.9 * versine
    angle = np.diff(np.stack([x, y, z], axis=-1), axis=0)
    np.testing.assert_allclose(motions.large_angle_manoeuvre().increments(tau), angle, atol=1e-14, rtol=0)


def test_tumble_is_the_stated_rate() -> None:
    t = np.linspace(0, 6, 50)
    x = 12 * np.cos(2.6 * np.pi * t) + 6
    y = 10 * np.cos(1.8 * np.pi * t + 0.3) - 5
    z = 8 * np.cos(3.4 * np.pi * t + 1) + 15
    np.testing.assert_allclose(motions.tumble().rate(t), np.stack([x, y, z], axis=-1), atol=1e-12, rtol=0)


def test_random_motion_is_seeded_and_of_the_stated_size() -> None:
    assert motions.random_motion(3) == motions.random_motion(3)
    assert motions.random_motion(3) != motions.random_motion(4)
    motion = motions.random_motion(3)
    power = sum(np.square(term.cosine) + np.square(term.sine) for term in motion.sinusoids) / 2
    np.testing.assert_allclose(power, [1.0, 1.0, 1.0], rtol=1e-12)
    frequencies = [term.frequency for term in motion.sinusoids]
    assert len(frequencies) == 120
    assert min(frequencies) >= 0.2
    assert max(frequencies) <= 25
    assert motion.polynomial == ((0.3, -0.2, 0.1),)


@pytest.mark.parametrize(("frequency", "t"), [(2.0, 59.999), (25.0, 10.01), (0.1, 1e4), (157.3, 3600.7)])
def test_phase_is_exact_after_many_turns(frequency: float, t: float) -> None:
    with mpmath.workdps(40):
        turns = mpmath.mpf(frequency) * mpmath.mpf(t)
        exact = float(2 * mpmath.pi * (turns - mpmath.nint(turns)))
    assert motions.phase(frequency, np.array([t]))[0] == pytest.approx(exact, rel=4 * EPS, abs=1e-18)


def test_attitude_takes_times_in_any_order() -> None:
    motion = motions.large_angle_manoeuvre()
    q = motion.attitude(np.array([0.5, 0.0, 0.25, 0.5]))
    np.testing.assert_array_equal(q[0], q[3])
    np.testing.assert_array_equal(q[1], [1, 0, 0, 0])
    assert quaternion.error_angle(q[2], motion.attitude(np.array([0.25]))[0]) < EPS


def test_times_before_the_start_are_refused() -> None:
    with pytest.raises(ValueError, match=re.escape("motion tumble starts at t = 0")):
        motions.tumble().attitude(np.array([-0.1]))
