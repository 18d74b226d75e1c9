from __future__ import annotations

import re
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from qcone.reference import kinematics, motions, quaternion

EPS = np.finfo(np.float64).eps


def test_large_angle_manoeuvre_meets_the_exact_attitudes(case, rounded) -> None:
    exact = case("truth_misc")["large_angle_full"]["q"]
    times = np.array([0.0, *map(float, exact)])
    motion = motions.large_angle_manoeuvre()
    for step in (1e-3, 4e-3):
        q = kinematics.integrate(motion.rate, motion.increments, times, step=step)
        np.testing.assert_array_equal(q[0], kinematics.IDENTITY)
        assert quaternion.error_angle(q[1:], rounded(list(exact.values()))).max() < 1e-15
        assert np.abs(np.linalg.norm(q, axis=-1) - 1).max() <= 2 * EPS


@pytest.mark.parametrize("frequency", ["2.5", "5", "10", "20", "25"])
def test_thesis_coning_is_integrated_to_the_closed_form(case, rounded, frequency: str) -> None:
    exact = case("truth_misc")["thesis2008"]["q"][frequency]
    motion = motions.thesis_coning(float(frequency))
    q = kinematics.integrate(motion.rate, motion.increments, np.array([0.0, *map(float, exact)]))
    assert quaternion.error_angle(q[1:], rounded(list(exact.values()))).max() < 1e-15


def test_collocation_is_of_order_twelve() -> None:
    motion = motions.thesis_coning(25.0)
    times = np.array([0.0, 0.2])
    errors = [
        quaternion.error_angle(
            kinematics.integrate(motion.rate, motion.increments, times, step=step)[1],
            motion.attitude(times)[1],
        )
        for step in (0.02, 0.01)
    ]
    assert errors[1] > 1e-15
    assert 11 < np.log2(errors[0] / errors[1]) < 13.5


def test_start_attitude_is_carried() -> None:
    motion, start = (
        motions.slew((1.0, 2.0, -2.0)),
        quaternion.from_rotation_vector(np.array([0.3, 0.2, -0.9])),
    )
    q = kinematics.integrate(motion.rate, motion.increments, np.array([2.0, 2.0, 2.5]), start=start)
    np.testing.assert_array_equal(q[1], q[0])
    turn = quaternion.from_rotation_vector(np.array([0.5, 1.0, -1.0]))
    np.testing.assert_allclose(q[2], quaternion.product(start, turn), atol=2 * EPS, rtol=0)


def test_bortz_series_is_the_closed_form() -> None:
    phi, omega = np.array([0.1, -0.1, 0.14]), np.array([3.0, 1.0, -7.0])
    with mpmath.workdps(40):
        norm = mpmath.sqrt(sum(mpmath.mpf(float(x)) ** 2 for x in phi))
        factor = float((1 - norm * mpmath.sin(norm) / (2 * (1 - mpmath.cos(norm)))) / norm**2)
    expected = omega + np.cross(phi, omega) / 2 + factor * np.cross(phi, np.cross(phi, omega))
    np.testing.assert_allclose(kinematics.bortz(phi, omega), expected, rtol=4 * EPS)


def test_chain_is_the_exact_product_of_rotations() -> None:
    phi = np.random.default_rng(5).normal(size=(300, 3)) * 0.02
    change = quaternion.change_from_rotation_vector(phi)
    start = quaternion.normalise(np.array([1.0, -2.0, 3.0, 0.5]))
    exact = [Fraction(x) for x in start.tolist()]
    for row in change.tolist():
        a, b, c, d = (Fraction(x) for x in row)
        w, x, y, z = exact
        step = (w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c)
        step += (w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a)
        # 200 bits are exact for the comparison and keep the fractions short.
        exact = [Fraction(round((p + q) * 2**200), 2**200) for p, q in zip(exact, step, strict=True)]
    np.testing.assert_allclose(kinematics.chain(start, change)[-1], [float(value) for value in exact], atol=EPS, rtol=0)


def test_a_long_chain_does_not_walk_away() -> None:
    phi, updates = np.array([1e-3, -2e-3, 2e-3]), 50_000
    change = np.tile(quaternion.change_from_rotation_vector(phi), (updates, 1))
    last = kinematics.chain(kinematics.IDENTITY, change)[-1]
    # The rounding of one phi, repeated, is the floor: 150 rad at half an ulp of the components of r - 1.
    assert quaternion.error_angle(last, quaternion.from_rotation_vector(updates * phi)) < 150 * EPS
    assert abs(np.linalg.norm(last) - 1) < 50 * EPS


def test_chain_of_nothing_is_empty() -> None:
    assert kinematics.chain(kinematics.IDENTITY, np.empty((0, 4))).shape == (0, 4)


def test_decreasing_times_are_refused() -> None:
    motion = motions.tumble()
    with pytest.raises(ValueError, match=re.escape("times must not decrease")):
        kinematics.integrate(motion.rate, motion.increments, np.array([0.0, 1.0, 0.5]))


def test_a_step_that_turns_too_far_is_refused() -> None:
    motion = motions.tumble()
    with pytest.raises(ValueError, match=re.escape("a step turns more than 0.2 rad, choose a shorter step")):
        kinematics.integrate(motion.rate, motion.increments, np.array([0.0, 1.0]), step=0.05)
