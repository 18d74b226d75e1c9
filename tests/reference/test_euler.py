from __future__ import annotations

import re
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from qcone.reference import euler, quaternion

EPS = np.finfo(np.float64).eps
CONVENTIONS = euler.CONVENTIONS


def angles_of_matrix(c: list[list[mpmath.mpf]], convention: str) -> list[mpmath.mpf]:
    """Roll, pitch, yaw from the elements of C_nb, as textbooks have them."""
    if convention == "zyx":
        return [mpmath.atan2(c[2][1], c[2][2]), mpmath.asin(-c[2][0]), mpmath.atan2(c[1][0], c[0][0])]
    return [mpmath.atan2(-c[2][0], c[2][2]), mpmath.asin(c[2][1]), mpmath.atan2(-c[0][1], c[1][1])]


def angles_of_quaternion(q: np.ndarray, convention: str) -> list[float] | None:
    """The exact angles of the four numbers given, rounded once; `q` of any norm. None exactly at a pole."""
    with mpmath.workdps(80):
        w, x, y, z = (mpmath.mpf(float(component)) for component in q)
        norm = w * w + x * x + y * y + z * z
        c = [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
        yaw_pair = (c[0][0], c[1][0]) if convention == "zyx" else (c[0][1], c[1][1])
        if not any(yaw_pair):
            return None
        return [float(angle) for angle in angles_of_matrix([[e / norm for e in row] for row in c], convention)]


def apart(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Distance of angles on the circle."""
    difference = np.abs(np.asarray(a) - np.asarray(b))
    return np.minimum(difference, np.abs(2 * np.pi - difference))


def attitudes(convention: str) -> np.ndarray:
    """Random attitudes, attitudes at all distances from both poles, and quarter and half turns."""
    random = np.random.default_rng(1)
    anywhere = random.normal(size=(100, 4))
    distance = np.repeat(10.0 ** -np.arange(0.0, 13.0), 8)
    sign = np.where(np.arange(len(distance)) % 2, 1, -1)
    angles = np.stack([distance, sign * (np.pi / 2 - distance), distance], axis=-1)
    angles[:, ::2] = random.uniform(-np.pi, np.pi, (len(distance), 2))
    quarters = np.array([[a, b, c] for a in range(-1, 3) for b in (-1, 0, 1) for c in range(-1, 3)]) * np.pi / 2
    turned = euler.from_angles(np.concatenate([angles, quarters]), convention)
    return np.concatenate([anywhere, turned, -turned, np.eye(4), [[1, 0, 1, 0], [1, 1, 0, 0], [1, -1, 0, 0]]])


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_conversions_meet_the_exact_cases(case, rounded, convention: str) -> None:
    for exact in case("truth_misc")["conversions"]:
        with mpmath.workdps(40):
            c = [[mpmath.mpf(element) for element in row] for row in exact["C"]]
            angles = [float(angle) for angle in angles_of_matrix(c, convention)]
        if convention == "zyx":
            published = [float(Fraction(exact[f"{name}_zyx"])) for name in ("roll", "pitch", "yaw")]
            np.testing.assert_allclose(angles, published, atol=1e-15, rtol=0)
        q, matrix = rounded(exact["q"]), rounded(exact["C"])
        cosine = np.cos(angles[1])
        np.testing.assert_allclose(euler.to_angles(q, convention), angles, atol=4 * EPS / cosine, rtol=0)
        np.testing.assert_allclose(euler.matrix_to_angles(matrix, convention), angles, atol=8 * EPS / cosine, rtol=0)
        assert quaternion.error_angle(euler.from_angles(np.array(angles), convention), q) < 4 * EPS
        np.testing.assert_allclose(euler.matrix_from_angles(angles, convention), matrix, atol=4 * EPS, rtol=0)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_angles_are_those_of_the_numbers_given(convention: str) -> None:
    """Near a pole too: nothing but the rounding of `q` itself is amplified there."""
    q = attitudes(convention)
    exact = [angles_of_quaternion(row, convention) for row in q]
    defined = np.array([angles is not None for angles in exact])
    assert defined.sum() > 300
    angles = euler.to_angles(q[defined], convention)
    errors = apart(angles, np.array([angles for angles in exact if angles is not None]))
    assert errors.max() < 6 * EPS  # three units in the last place of pi


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_the_attitude_is_rebuilt_everywhere(convention: str) -> None:
    q = attitudes(convention)
    c = quaternion.to_matrix(quaternion.normalise(q))
    for angles in (euler.to_angles(q, convention), euler.matrix_to_angles(c, convention)):
        assert np.abs(angles[:, ::2]).max() <= np.pi
        assert np.abs(angles[:, 1]).max() <= np.pi / 2
        assert quaternion.error_angle(euler.from_angles(angles, convention), q).max() < 8 * EPS
        np.testing.assert_allclose(euler.matrix_from_angles(angles, convention), c, atol=8 * EPS, rtol=0)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("convention", "axis"), [("zyx", 2), ("zxy", 1)])
def test_at_a_pole_roll_and_yaw_share_their_turn(convention: str, axis: int, sign: int) -> None:
    q = np.array([1.0, 0.0, 0.0, 0.0])
    q[axis] = sign
    np.testing.assert_allclose(euler.to_angles(q, convention), [0, sign * np.pi / 2, 0], atol=EPS, rtol=0)
    turned = quaternion.product(quaternion.from_rotation_vector(np.array([0, 0, 0.6])), q)
    roll, pitch, yaw = euler.to_angles(turned, convention)
    assert pitch == pytest.approx(sign * np.pi / 2, abs=1e-7)
    assert abs(roll) == pytest.approx(0.3, abs=4 * EPS)
    assert yaw == pytest.approx(0.3, abs=4 * EPS)


def test_each_angle_turns_about_its_axis() -> None:
    """Nose up is positive pitch forward-right-down about y, and right-forward-up about x."""
    small = 0.1
    roll, pitch, yaw = np.eye(3) * small
    axes = {"zyx": (roll, pitch, yaw), "zxy": (pitch, roll, yaw)}
    for convention, (x, y, z) in axes.items():
        for axis, angles in enumerate((x, y, z)):
            q = quaternion.from_rotation_vector(np.eye(3)[axis] * small)
            np.testing.assert_allclose(euler.from_angles(angles, convention), q, atol=EPS, rtol=0)
            np.testing.assert_allclose(euler.matrix_from_angles(angles, convention), quaternion.to_matrix(q), atol=EPS)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_rates_move_the_matrix_as_the_body_rate_does(convention: str) -> None:
    random = np.random.default_rng(5)
    angles = random.uniform(-1, 1, (50, 3)) * [np.pi, 1.4, np.pi]
    omega = random.normal(size=(50, 3))
    rates, h = euler.angle_rates(angles, omega, convention), 1e-4
    ahead, behind = (euler.matrix_from_angles(angles + step * rates, convention) for step in (h, -h))
    c = euler.matrix_from_angles(angles, convention)
    expected = np.cross(c, omega[:, np.newaxis, :])  # the rows of C [omega x]
    size = 1 + np.linalg.norm(rates, axis=-1)[:, np.newaxis, np.newaxis] ** 3
    assert np.max(np.abs((ahead - behind) / (2 * h) - expected) / size) < h**2


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_batches_are_the_single_cases(convention: str) -> None:
    q = quaternion.normalise(np.random.default_rng(6).normal(size=(2, 3, 4)))
    angles = euler.to_angles(q, convention)
    assert angles.shape == (2, 3, 3)
    np.testing.assert_allclose(angles[1, 2], euler.to_angles(q[1, 2], convention), atol=2 * EPS, rtol=0)
    assert euler.from_angles(angles, convention).shape == (2, 3, 4)
    assert euler.matrix_from_angles(angles, convention).shape == (2, 3, 3, 3)
    np.testing.assert_allclose(euler.matrix_to_angles(quaternion.to_matrix(q), convention), angles, atol=1e-14, rtol=0)


@pytest.mark.parametrize(
    "call", [euler.to_angles, euler.from_angles, euler.matrix_from_angles, lambda x, c: euler.angle_rates(x, x, c)]
)
def test_another_convention_is_refused(call) -> None:
    argument = np.zeros(4 if call is euler.to_angles else 3)
    with pytest.raises(ValueError, match=re.escape("convention is 'xyz', choose zyx or zxy")):
        call(argument, "xyz")
