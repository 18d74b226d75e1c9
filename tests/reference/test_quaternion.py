from __future__ import annotations

import mpmath
import numpy as np
import pytest

from qcone.reference import quaternion

EPS = np.finfo(np.float64).eps


def unit(rng: np.random.Generator, *shape: int) -> np.ndarray:
    return quaternion.normalise(rng.normal(size=(*shape, 4)))


def test_product_is_hamiltons() -> None:
    one, i, j, k = np.eye(4)
    table = {(0, 0): one, (1, 1): -one, (2, 2): -one, (3, 3): -one, (1, 2): k, (2, 3): i, (3, 1): j}
    for (a, b), expected in table.items():
        np.testing.assert_array_equal(quaternion.product(np.eye(4)[a], np.eye(4)[b]), expected)
        if a != b:
            np.testing.assert_array_equal(quaternion.product(np.eye(4)[b], np.eye(4)[a]), -expected)


def test_product_rotates_from_body_to_navigation() -> None:
    rng = np.random.default_rng(1)
    p, q, v = unit(rng, 7), unit(rng, 7), rng.normal(size=(7, 3))
    pure = np.concatenate([np.zeros((7, 1)), v], axis=-1)
    sandwich = quaternion.product(quaternion.product(q, pure), quaternion.conjugate(q))
    rotated = np.einsum("nij,nj->ni", quaternion.to_matrix(q), v)
    np.testing.assert_allclose(sandwich[:, 1:], rotated, atol=8 * EPS)
    both = quaternion.to_matrix(quaternion.product(p, q))
    np.testing.assert_allclose(both, quaternion.to_matrix(p) @ quaternion.to_matrix(q), atol=8 * EPS)


def test_conversions_meet_the_exact_cases(case, rounded) -> None:
    conversions = case("truth_misc")["conversions"]
    assert len(conversions) == 5
    for exact in conversions:
        phi, q, c = rounded(exact["phi"]), rounded(exact["q"]), rounded(exact["C"])
        np.testing.assert_allclose(quaternion.from_rotation_vector(phi), q, atol=EPS / 2, rtol=0)
        np.testing.assert_allclose(quaternion.to_matrix(q), c, atol=1.5 * EPS, rtol=0)
        assert quaternion.error_angle(quaternion.from_matrix(c), q) < 2 * EPS
        shortest = phi * (1 - 2 * np.pi / np.linalg.norm(phi)) if np.linalg.norm(phi) > np.pi else phi
        np.testing.assert_allclose(quaternion.to_rotation_vector(q), shortest, atol=4 * EPS, rtol=0)


@pytest.mark.parametrize("angle", [1e-200, 1e-9, 1e-3, 0.00999, 0.01001, 0.1, 1.0, 3.1, 6.2])
def test_rotation_vector_keeps_its_relative_precision(angle: float) -> None:
    phi = angle * np.array([0.36, -0.48, 0.8])
    with mpmath.workdps(450):
        x = [mpmath.mpf(float(component)) for component in phi]
        norm = mpmath.sqrt(sum(component**2 for component in x))
        exact = [float(mpmath.cos(norm / 2) - 1)] + [float(mpmath.sin(norm / 2) / norm * c) for c in x]
    change = quaternion.change_from_rotation_vector(phi)
    assert change[0] == pytest.approx(exact[0], rel=5 * EPS, abs=0)
    # Near a full turn the sine is as sharp as its argument, no sharper.
    np.testing.assert_allclose(change[1:], exact[1:], rtol=0, atol=2 * EPS * min(angle, 1))
    r = quaternion.from_rotation_vector(phi)
    np.testing.assert_array_equal(r[1:], change[1:])
    assert abs(np.linalg.norm(r) - 1) <= EPS


def test_zero_rotation_is_exact() -> None:
    np.testing.assert_array_equal(quaternion.from_rotation_vector(np.zeros((2, 3))), [[1, 0, 0, 0]] * 2)
    np.testing.assert_array_equal(quaternion.to_rotation_vector(np.array([2.0, 0, 0, 0])), np.zeros(3))


def test_from_matrix_inverts_to_matrix_everywhere() -> None:
    half_turns = np.concatenate([np.zeros((4, 1)), [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0, -0.8]]], axis=1)
    q = np.concatenate([unit(np.random.default_rng(2), 1000), half_turns, np.eye(4)])
    back = quaternion.from_matrix(quaternion.to_matrix(q))
    assert np.all(back[:, 0] >= 0)
    assert quaternion.error_angle(back, q).max() < 8 * EPS


@pytest.mark.parametrize("size", [1e-18, 1e-16, 1e-12, 1e-6, 0.1, 3.0])
@pytest.mark.parametrize("factor", [1.0, -1.0])
def test_error_angle_resolves_the_numbers_it_is_given(size: float, factor: float) -> None:
    true = quaternion.from_rotation_vector(np.array([1e-9, 2e-9, -3e-9]) if size < 1e-15 else np.array([1.0, -2, 0.5]))
    estimate = quaternion.product(true, quaternion.from_rotation_vector(size * np.array([0.36, -0.48, 0.8])))
    with mpmath.workdps(60):
        a, b = [mpmath.mpf(float(x)) for x in true], [mpmath.mpf(float(x)) for x in estimate]
        vector = (
            a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2],
            a[0] * b[2] + a[1] * b[3] - a[2] * b[0] - a[3] * b[1],
            a[0] * b[3] - a[1] * b[2] + a[2] * b[1] - a[3] * b[0],
        )
        scalar = sum(x * y for x, y in zip(a, b, strict=True))
        exact = float(2 * mpmath.atan2(mpmath.sqrt(sum(x**2 for x in vector)), scalar))
    assert exact > 0
    # Rounding of the product with the difference: relative to the error, wherever the norms agree.
    assert quaternion.error_angle(factor * estimate, true) == pytest.approx(exact, rel=1e-14, abs=0)


def test_error_angle_of_known_turns() -> None:
    true = unit(np.random.default_rng(3), 4)
    angle = np.array([0.0, 1e-10, 1.0, np.pi])
    turned = quaternion.product(true, quaternion.from_rotation_vector(np.outer(angle, [0.0, 0.6, 0.8])))
    np.testing.assert_allclose(quaternion.error_angle(3.0 * turned, -true), angle, atol=8 * EPS, rtol=0)
    assert quaternion.error_angle(true, true).max() == 0.0


def test_navigation_error_is_in_navigation_axes() -> None:
    true = unit(np.random.default_rng(4), 5)
    error = np.outer([0.0, 1e-12, 1e-6, 0.1, 2.0], [0.36, -0.48, 0.8])
    estimate = quaternion.product(quaternion.from_rotation_vector(error), true)
    for sign in (1, -1):
        np.testing.assert_allclose(quaternion.navigation_error(sign * estimate, true), error, atol=8 * EPS, rtol=0)
