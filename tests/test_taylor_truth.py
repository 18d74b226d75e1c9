"""The compiled Taylor algorithms against 40-digit truth: one update from the identity is r, or its matrix.

The fit goes through differences of neighbouring increments, which lose no digits: the floors here are those of the
rotation vector for every number of sub-samples, where the published tables of the fit lose up to two digits at six.
"""

from __future__ import annotations

from math import ceil, pi
from pathlib import Path

import numpy as np
import pytest

from exactly import EXACT, Case, cases_of, error, rounded
from qcone.algorithms.polynomial_rate import ORDERS
from qcone.bundle import Bundle
from qcone.design import design_from_options
from qcone.pipeline import build
from qcone.reference import motions
from qcone.registry import entries
from qcone.targets.compiler import Compiler
from running import singly
from series import Digits, matrix, matrix_series, quaternion_series

FLOORS = {"float32": 5e-8, "float64": 1.2e-16}
EPSILON = {"float32": 2.0**-23, "float64": 2.0**-52}
UPDATE_HZ = 10
KEYS = {"quat_taylor10": (10, "start"), "quat_taylor_mid8": (8, "midpoint"), "quat_taylor_mid10": (10, "midpoint")}
"""Keys of the truth files: order and point of the series."""


def built(algorithm: str, number: str, largest: float, n: int, **parameters: object) -> Bundle:
    """Build a design of N sub-samples whose declared increments reach `largest` rad."""
    dps = ceil(largest * n * UPDATE_HZ * 180 / pi) + 1
    base = {"algorithm": algorithm, "subsamples": n, "number": number, "outputs": "quaternion,dcm"}
    declared = {"max_rate_dps": str(dps), "update_hz": str(UPDATE_HZ)}
    return build(design_from_options("tested", {**base, **declared, **parameters}, entries()))


def largest_of(found: list[Case]) -> float:
    return float(np.linalg.norm([rounded(theta) for _, theta, _ in found], axis=-1).max())


@pytest.mark.parametrize("number", FLOORS)
@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("n", ORDERS)
def test_one_update_meets_the_exact_value(truth: Path, first_compiler: Compiler, n: int, key: str, number: str) -> None:
    found, (order, about) = list(cases_of(truth, n, key)), KEYS[key]
    assert len(found) == 6
    bundle = built("quaternion-taylor", number, largest_of(found), n, order=order, about=about)
    r = singly(bundle, first_compiler, np.array([rounded(theta) for _, theta, _ in found]), exact=True).q
    errors = {name: error(row, exact) for row, (name, _, exact) in zip(r, found, strict=True)}
    assert max(errors.values()) <= FLOORS[number], errors


@pytest.mark.parametrize("n", ORDERS)
def test_the_truth_files_hold_the_series_of_the_published_tables(truth: Path, n: int) -> None:
    """So that what follows may take any order from the tables."""
    for key, (order, about) in KEYS.items():
        for name, theta, exact in cases_of(truth, n, key):
            found = quaternion_series(theta, order, about)
            assert max(abs(have - want) for have, want in zip(found, exact, strict=True)) < 1e-37, name


@pytest.mark.parametrize("number", FLOORS)
@pytest.mark.parametrize("n", ORDERS)
def test_one_update_of_the_matrix_is_the_matrix_of_r(
    truth: Path, first_compiler: Compiler, n: int, number: str
) -> None:
    """But for the terms each series leaves out: the matrix turns by the whole angle, the quaternion by half of it."""
    found = list(cases_of(truth, n, "quat_taylor10"))
    bundle = built("dcm-taylor", number, largest_of(found), n, order=10)
    c = singly(bundle, first_compiler, np.array([rounded(theta) for _, theta, _ in found]), exact=True)["c"]
    for row, (name, theta, r) in zip(c, found, strict=True):
        series, whole = matrix_series(theta, 10), matrix_series(theta, 24)
        left_out = apart(series, whole) + apart(matrix(r), matrix(quaternion_series(theta, 24, "start")))
        assert apart(whole, matrix(quaternion_series(theta, 24, "start"))) < 1e-20, "one polynomial, one attitude"
        assert error(row, series) <= 2 * FLOORS[number], name
        assert error(row, matrix(r)) <= 2 * FLOORS[number] + left_out, name


def apart(first: Digits, second: Digits) -> float:
    return float(max(abs(a - b) for a, b in zip(first, second, strict=True)))


STARTS = (0.1, 0.3, 0.5, 0.6, 0.8, 1.0)
"""Updates of 0.1 s of the large-angle manoeuvre: more than a radian each."""


@pytest.mark.parametrize(("order", "number"), [*((order, "float64") for order in (1, 2, 5, 10, 24)), (10, "float32")])
@pytest.mark.parametrize("n", ORDERS)
def test_a_large_update_is_the_series_of_its_order(first_compiler: Compiler, n: int, order: int, number: str) -> None:
    """To the last bit or two, where leaving out a term would show: up to order 10 the next term is far larger."""
    motion = motions.large_angle_manoeuvre()
    increments = [motion.increments(start + np.arange(n + 1) * 0.1 / n) for start in STARTS]
    theta = np.array(increments).astype(number).astype(np.float64)
    assert np.linalg.norm(theta.sum(axis=1), axis=-1).max() > 1
    exact = [[[EXACT.mpf(value) for value in row] for row in case] for case in theta.tolist()]
    largest = float(np.linalg.norm(theta, axis=-1).max())
    for about in ("start", "midpoint"):
        bundle = built("quaternion-taylor", number, largest, n, order=order, about=about, loop="rolled")
        r = singly(bundle, first_compiler, theta).q
        for row, case in zip(r, exact, strict=True):
            assert error(row, quaternion_series(case, order, about)) <= EPSILON[number], about
    bundle = built("dcm-taylor", number, largest, n, order=order, loop="rolled")
    for row, case in zip(singly(bundle, first_compiler, theta)["c"], exact, strict=True):
        assert error(row, matrix_series(case, order)) <= 3 * EPSILON[number]


@pytest.mark.parametrize("order", [2, 5, 10])
def test_series_of_neighbouring_orders_are_told_apart(order: int) -> None:
    """The large updates are hard enough: up to order 10 one term less is a thousand times the rounding."""
    theta = motions.large_angle_manoeuvre().increments(0.3 + np.arange(4) * 0.1 / 3)
    exact = [[EXACT.mpf(value) for value in row] for row in theta.tolist()]
    for more, less in (
        (quaternion_series(exact, order, "start"), quaternion_series(exact, order - 1, "start")),
        (matrix_series(exact, order), matrix_series(exact, order - 1)),
    ):
        assert apart(more, less) > 1000 * EPSILON["float64"]
