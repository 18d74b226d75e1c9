"""The quantiser carries its residual, and runs through the C refuse what a design does not declare."""

from __future__ import annotations

import numpy as np
import pytest

from qcone.errors import UsageError
from qcone.studies.sampled import (
    CONING,
    CONING_DPS,
    QUANTUM,
    algorithm,
    coning_errors,
    floored,
    manoeuvre_error,
    rounded,
)
from qcone.studies.simulating import options, run

pytestmark = pytest.mark.usefixtures("first_compiler")


def test_pulses_are_whole_and_their_residual_is_carried() -> None:
    dtheta = np.random.default_rng(1).normal(scale=3 * QUANTUM, size=(5000, 3))
    start = np.array([0.3, -0.2, 0.1]) * QUANTUM
    for given, furthest in ((rounded(dtheta, start), 0.5), (floored(dtheta), 1.0)):
        pulses = given / QUANTUM
        assert np.abs(pulses - np.rint(pulses)).max() < 1e-9
        off = np.cumsum(given - dtheta, axis=0)
        assert np.abs(off).max() <= (furthest + 0.31) * QUANTUM, "an error that grows is not carried"


def test_increments_rounded_one_by_one_are_another_much_worse_model() -> None:
    """The running angle is what is quantised: without the residual yaw is off by arc minutes in a minute."""
    words = algorithm("rotation-vector", 3, 100, CONING_DPS, coefficients="coning")
    times = np.arange(6001) / 100
    alone = QUANTUM * np.rint(CONING.increments(times) / QUANTUM)
    q = run(words, CONING.attitude(times[:1]), alone.reshape(1, -1, 3, 3))["quaternion"][0]
    off = 2 * np.abs((q - CONING.attitude(times[3::3]))[:, 3]).max()
    assert off > 10 * max(coning_errors(words, 3, 100, True))


def test_errors_are_those_published() -> None:
    words = algorithm("rotation-vector", 3, 100, CONING_DPS, coefficients="taylor")
    assert coning_errors(words, 3, 100) == pytest.approx((5.5e-8, 1.1e-7, 1.8e-5), rel=0.03)
    series = algorithm("quaternion-taylor", 3, 1000, 900)
    assert manoeuvre_error(series, 3, 1000) == pytest.approx(1.1e-10, rel=0.1)


def test_faster_motion_than_declared_is_refused() -> None:
    words = options("rotation-vector", subsamples=1, max_rate_dps=10, update_hz=100)
    start, slow = np.eye(4)[:1], np.full((1, 2, 1, 3), 1e-4)
    assert run(words, start, slow)["quaternion"].shape == (1, 2, 4)
    with pytest.raises(UsageError, match=r"the motion reaches 0\.01732 in a sample, the design declares 0\.001745"):
        run(words, start, 100 * slow)


def test_lanes_are_runs_of_their_own() -> None:
    words = options("rotation-vector", subsamples=2, max_rate_dps=573, update_hz=100)
    random = np.random.default_rng(2)
    start = random.normal(size=(3, 4))
    start /= np.linalg.norm(start, axis=1, keepdims=True)
    inputs = 0.01 * random.normal(size=(3, 20, 2, 3))
    together = run(words, start, inputs)["quaternion"]
    for lane in range(3):
        alone = run(words, start[lane : lane + 1], inputs[lane : lane + 1])["quaternion"][0]
        assert (together[lane] == alone).all()
