from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from qcone.reference import matrices, quaternion, renormalisation

EPS = np.finfo(np.float64).eps


@pytest.mark.parametrize("error", [1e-3, -1e-5, 0.0])
def test_renormalise_leaves_three_halves_of_the_square(error: float) -> None:
    unit = quaternion.normalise(np.random.default_rng(1).normal(size=(20, 4)))
    restored = renormalisation.renormalise((1 + error) * unit)
    loss = np.linalg.norm(restored, axis=-1) - 1
    np.testing.assert_allclose(loss, -1.5 * error**2, rtol=2 * abs(error), atol=4 * EPS)
    assert quaternion.error_angle(restored, unit).max() < 4 * EPS


def test_reorthogonalise_squares_the_loss() -> None:
    random = np.random.default_rng(2)
    c = quaternion.to_matrix(quaternion.normalise(random.normal(size=(20, 4))))
    stretch = random.normal(size=(20, 3, 3)) * 1e-4
    stretch = (stretch + np.swapaxes(stretch, -1, -2)) / 2
    restored = renormalisation.reorthogonalise(c @ (np.eye(3) + stretch))
    # (I + S)(I - S - S^2/2) = I - 3/2 S^2 - S^3/2.
    np.testing.assert_allclose(restored, c @ (np.eye(3) - 1.5 * stretch @ stretch), atol=1e-11, rtol=0)


def test_chain_of_matrices_is_the_exact_product() -> None:
    phi = np.random.default_rng(3).normal(size=(300, 3)) * 0.02
    start = quaternion.to_matrix(quaternion.normalise(np.array([1.0, -2.0, 3.0, 0.5])))
    change = quaternion.to_matrix(quaternion.from_rotation_vector(phi)) - np.eye(3)
    exact = [[Fraction(x) for x in row] for row in start.tolist()]
    for turn in change.tolist():
        turn = [[Fraction(x) + (i == j) for j, x in enumerate(row)] for i, row in enumerate(turn)]
        product = [[sum(exact[i][k] * turn[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        # 200 bits are exact for the comparison and keep the fractions short.
        exact = [[Fraction(round(x * 2**200), 2**200) for x in row] for row in product]
    chained = matrices.chain_matrices(start, change)
    np.testing.assert_allclose(chained[-1], np.array(exact, dtype=np.float64), atol=EPS, rtol=0)


def test_orthogonal_chain_stays_orthogonal() -> None:
    random = np.random.default_rng(4)
    turn = quaternion.to_matrix(quaternion.from_rotation_vector(random.normal(size=(500, 3)) * 0.02))
    change = turn * (1 + 1e-6) - np.eye(3)  # every update stretches
    losses = []
    for orthogonal in (False, True):
        c = matrices.chain_matrices(np.eye(3), change, orthogonal=orthogonal)
        losses.append(np.abs(np.swapaxes(c, -1, -2) @ c - np.eye(3)).max())
    assert losses[0] == pytest.approx((1 + 1e-6) ** 1000 - 1, rel=1e-6)
    assert losses[1] == pytest.approx(3e-12, rel=0.01)  # 2 * 3/2 * (1e-6)^2 of the last update


def test_chain_of_nothing_is_empty() -> None:
    assert matrices.chain_matrices(np.eye(3), np.empty((0, 3, 3))).shape == (0, 3, 3)
