"""Runge-Kutta and Adams-Moulton in compiled C against the hand-written references: the same method, to rounding.

Without renormalisation C and reference do the same sums in another order. With it, C folds the correction of the
incoming attitude into the next step where the reference corrects the attitude it gives out: they differ by that much
of the method's own error, and converge together.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from qcone.pipeline import build
from qcone.reference import adams_moulton, motions, quaternion, runge_kutta
from qcone.reference.adams_moulton import STARTERS, Starter
from qcone.reference.quaternion import Array
from qcone.targets.compiler import Compiler
from running import Ran, chain
from shipped import design_of

HZ = 200
START = quaternion.normalise(np.array([0.5, -0.1, 0.7, 0.5]))
MOTION = motions.large_angle_manoeuvre()
ACCUMULATIONS = ("standard", "delta", "compensated")
ROUNDING = 5e-15
"""rad, of some 240 steps in float64."""


def rates(hz: int, per_update: int) -> Array:
    """Return the rates of the manoeuvre, `per_update` to one update, the first at its start."""
    return MOTION.rate(np.arange(round(MOTION.duration * hz) * per_update + 1) / (hz * per_update))


def run(example: str, compiler: Compiler, omega: Array, start: Array, hz: int = HZ, **options: Any) -> Ran:
    given = {"max_rate_dps": "900", "update_hz": str(hz), "outputs": "quaternion,dcm", **options}
    bundle = build(design_of(example, **given))
    samples = omega[1:].reshape(-1, bundle.facts.algorithm.subsamples, 3)
    return chain(bundle, compiler, samples, start, omega[0], exact=True)


@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
def test_runge_kutta_is_the_reference_s(first_compiler: Compiler, accumulate: str) -> None:
    omega = rates(HZ, 2)
    example = "runge-kutta-4 attitude=quaternion"
    found = run(example, first_compiler, omega, START, accumulate=accumulate, renormalise="never")
    np.testing.assert_allclose(found.q, runge_kutta.run_quaternion(START, omega, 1 / HZ), atol=ROUNDING, rtol=0)


@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
def test_runge_kutta_on_the_matrix_is_the_reference_s(first_compiler: Compiler, accumulate: str) -> None:
    """The rows that are integrated; the third is their cross product, where the reference integrates it too."""
    omega, start = rates(HZ, 2), quaternion.to_matrix(START)
    found = run("runge-kutta-4 attitude=dcm", first_compiler, omega, start, accumulate=accumulate, renormalise="never")
    reference = runge_kutta.run_dcm(start, omega, 1 / HZ)
    np.testing.assert_allclose(found.dcm[:, :2], reference[:, :2], atol=ROUNDING, rtol=0)
    np.testing.assert_allclose(found.dcm[:, 2], np.cross(found.dcm[:, 0], found.dcm[:, 1]), atol=1e-15, rtol=0)


@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
@pytest.mark.parametrize("starter", STARTERS)
def test_adams_moulton_is_the_reference_s(first_compiler: Compiler, starter: Starter, accumulate: str) -> None:
    """Attitude and Milne's estimate, the updates of the starter included."""
    omega = rates(HZ, 1)
    example = f"adams-moulton-4 starter={starter}"
    found = run(example, first_compiler, omega, START, accumulate=accumulate, renormalise="never")
    reference = adams_moulton.adams_moulton(START, omega, 1 / HZ, starter, renormalise=False)
    np.testing.assert_allclose(found.q, reference.attitude, atol=ROUNDING, rtol=0)
    assert np.abs(reference.estimate).max() > 1e-9
    np.testing.assert_allclose(found["error_estimate"], reference.estimate, atol=1e-17, rtol=0)


@pytest.mark.parametrize("example", ["runge-kutta-4 attitude=quaternion", "runge-kutta-4 attitude=dcm"])
def test_folded_renormalisation_leaves_the_direction_alone(first_compiler: Compiler, example: str) -> None:
    """It differs from the reference by a hundredth of the method's error and less."""
    omega = rates(HZ, 2)
    matrix = example.endswith("dcm")
    start = quaternion.to_matrix(START) if matrix else START
    found = run(example, first_compiler, omega, start)
    if matrix:
        reference = quaternion.from_matrix(runge_kutta.run_dcm(start, omega, 1 / HZ, orthogonal=True))
    else:
        reference = runge_kutta.run_quaternion(START, omega, 1 / HZ)
    error = quaternion.error_angle(reference, true_attitude(HZ)).max()
    assert quaternion.error_angle(found.q, reference).max() < (0.06 if matrix else 0.01) * error


@pytest.mark.parametrize("starter", STARTERS)
def test_adams_moulton_renormalised_is_as_near_to_the_truth_as_the_reference(
    first_compiler: Compiler, starter: Starter
) -> None:
    for hz in (100, 200, 400):
        omega, true = rates(hz, 1), true_attitude(hz)
        found = run(f"adams-moulton-4 starter={starter}", first_compiler, omega, START, hz)
        reference = adams_moulton.adams_moulton(START, omega, 1 / hz, starter)
        ours, theirs = (quaternion.error_angle(q[2:], true[2:]).max() for q in (found.q, reference.attitude))
        assert ours == pytest.approx(theirs, rel=0.02)
        np.testing.assert_allclose(
            found["error_estimate"], reference.estimate, atol=0.02 * np.abs(reference.estimate).max()
        )


def true_attitude(hz: int) -> Array:
    """Return the attitude after each update, from START."""
    times = np.arange(1, round(MOTION.duration * hz) + 1) / hz
    return quaternion.product(START, MOTION.attitude(times))
