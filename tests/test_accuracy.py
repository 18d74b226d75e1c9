"""`qcone replay` of exact increments: the compiled C has the published errors and orders, in float64.

Increments are closed forms of the motion, written with 17 digits; errors are attitude error angles against
the motion's true attitude at update instants.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from numpy.typing import NDArray

from qcone.cli import main
from qcone.pipeline import build
from qcone.reference import motions, quaternion
from qcone.reference.attitude import run
from qcone.reference.motions import Motion
from qcone.registry import algorithm_of
from qcone.targets.compiler import Compiler
from qcone.vectors import in_form
from running import chain
from shipped import EXAMPLES, design_of

pytestmark = pytest.mark.usefixtures("first_compiler")

HEADER = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad"
Recorded = Callable[[Motion, int], Path]


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Recorded:
    """Return a function that writes a motion's increments at a rate in Hz as CSV, once."""
    folder = tmp_path_factory.mktemp("motions")

    def write(motion: Motion, rate_hz: int) -> Path:
        file = folder / f"{motion.name}_{rate_hz}.csv"
        if not file.exists():
            times = np.arange(round(motion.duration * rate_hz) + 1) / rate_hz
            rows = np.column_stack([times[1:], motion.increments(times)])
            np.savetxt(file, rows, fmt="%.17g", delimiter=",", header=HEADER, comments="")
        return file

    return write


def replay(file: Path, example: str, initial: NDArray[np.float64], output: Path) -> NDArray[np.float64]:
    """Replay the increments of `file` in float64 and return the rows t_s, q0..q3 that were written."""
    family, parameters = EXAMPLES[example]
    options = [word for name, value in parameters.items() if value for word in (f"--{name}", str(value))]
    given = ",".join(f"{part:.17g}" for part in initial)
    arguments = ["replay", str(file), "--algorithm", family, *options, "--number", "float64", "--initial", given]
    result = CliRunner().invoke(main, [*arguments, "-o", str(output)])
    assert result.exit_code == 0, result.output
    rows: NDArray[np.float64] = np.loadtxt(output, delimiter=",", skiprows=1)
    return rows


def errors(motion: Motion, rate_hz: int, example: str, recorded: Recorded, folder: Path) -> NDArray[np.float64]:
    """Return the attitude error angle after each update, rad."""
    start = motion.attitude(np.zeros(1))[0]
    rows = replay(recorded(motion, rate_hz), example, start, folder / "attitude.csv")
    return quaternion.error_angle(rows[:, 1:], motion.attitude(rows[:, 0]))


def named(n: int, coefficients: str) -> str:
    return f"rotation-vector subsamples={n}" + f" coefficients={coefficients}" * bool(coefficients)


CONING_AT_1_KHZ = {
    (1, ""): 7.5e-5,
    (2, "taylor"): 2.4e-9,
    (3, "taylor"): 1.8e-9,
    (4, "taylor"): 3.5e-11,
    (6, "taylor"): 1.8e-10,
    (3, "compressed"): 3.0e-10,
    (4, "compressed"): 9.6e-10,
    (6, "compressed"): 4.1e-9,
    (3, "expanded"): 1.3e-11,
    (4, "expanded"): 3.5e-11,
    (5, "expanded"): 8.6e-11,
    (6, "expanded"): 1.8e-10,
}
"""Largest error in rad of a minute of the coning of xu2019: half-angle 5 degrees, 4 pi rad/s."""


@pytest.mark.parametrize(("n", "coefficients"), CONING_AT_1_KHZ)
def test_a_minute_of_coning_has_the_published_error(
    n: int, coefficients: str, recorded: Recorded, tmp_path: Path
) -> None:
    found = errors(motions.coning(), 1000, named(n, coefficients), recorded, tmp_path)
    assert len(found) == 60_000 // n
    published = CONING_AT_1_KHZ[n, coefficients]
    assert published / 1.2 < found.max() < published * 1.2


HIGH = {"subsamples=4": 6, "subsamples=5": 6, "subsamples=6": 8}


def order_of(example: str) -> int:
    """Return the global order in general motion that the literature gives the algorithm.

    A polynomial through N increments, its attitude by a long series, supports 2 floor(N/2) + 2; a rotation vector
    of two factors stops at 4, and at 3 with a one-sided weighting, as does a start by Heun's method.
    """
    family, _, parameters = example.partition(" ")
    if family.endswith("taylor"):
        return 2 if "subsamples=1 " in example else HIGH.get(parameters.partition(" ")[0], 4)
    if family == "picard" or example == "rotation-vector subsamples=1":
        return 2
    if "previous" in example or ("compressed" in example and "subsamples=2" not in example) or "heun" in example:
        return 3
    return 4


THROUGH_INCREMENTS = [name for name in EXAMPLES if name.startswith(("rotation-vector", "picard"))]


@pytest.mark.parametrize("example", THROUGH_INCREMENTS)
def test_order_on_the_large_angle_manoeuvre(example: str, recorded: Recorded, tmp_path: Path) -> None:
    motion = motions.large_angle_manoeuvre()
    coarse, fine = (errors(motion, rate_hz, example, recorded, tmp_path).max() for rate_hz in (1000, 2000))
    assert math.log2(coarse / fine) == pytest.approx(order_of(example), abs=0.2)


def largest_error(motion: Motion, hz: int, example: str, compiler: Compiler) -> float:
    """Return the largest attitude error angle at that rate of samples, but for the two updates a starter holds, rad."""
    algorithm = algorithm_of(design_of(example))
    n, updates = algorithm.subsamples, round(motion.duration * hz / algorithm.subsamples)
    times = np.arange(updates * n + 1) / hz
    bundle = build(design_of(example, update_hz=str(hz / n), max_rate_dps="900"))
    samples = motion.rate(times)[1:] if algorithm.takes == "omega" else motion.increments(times)
    start = in_form(motion.attitude(times[:1]), bundle.driver.setter)[0]
    found = chain(bundle, compiler, samples.reshape(updates, n, 3), start, motion.rate(times[:1])[0])
    return float(quaternion.error_angle(found.q, motion.attitude(times[n::n]))[2:].max())


@pytest.mark.parametrize("example", [name for name in EXAMPLES if name not in THROUGH_INCREMENTS])
def test_order_of_what_takes_series_or_rates(example: str, first_compiler: Compiler) -> None:
    """Where rounding is far below the error: at order 8 there is little room between it and the series' end.

    Euler angles are followed where they can be, far from a pitch of 90 degrees.
    """
    motion = motions.thesis_coning(2.5) if example == "euler-angles" else motions.large_angle_manoeuvre()
    hz = 150 if order_of(example) == 8 else 200
    coarse, fine = (largest_error(motion, each, example, first_compiler) for each in (hz, 2 * hz))
    assert math.log2(coarse / fine) == pytest.approx(order_of(example), abs=0.2)


@pytest.mark.parametrize("example", EXAMPLES)
def test_the_catalogue_claims_the_order_that_is_measured(example: str) -> None:
    assert algorithm_of(design_of(example)).order == order_of(example)


@pytest.mark.parametrize("previous", range(1, 6))
def test_start_up_of_a_history_form_is_what_is_specified(previous: int, recorded: Recorded, tmp_path: Path) -> None:
    """The first updates take phi = theta, those after it the history: the hand-written reference does the same."""
    motion = motions.large_angle_manoeuvre()
    times = np.arange(1201) / 1000
    dtheta = motion.increments(times)[:, None]
    start = motion.attitude(np.zeros(1))[0]
    example = f"rotation-vector subsamples=1 previous={previous}"
    rows = replay(recorded(motion, 1000), example, start, tmp_path / "attitude.csv")
    reference = run(start, dtheta, previous=previous)
    assert quaternion.error_angle(rows[:, 1:], reference).max() < 1e-13
    single = run(start, dtheta[:previous])
    assert quaternion.error_angle(rows[:previous, 1:], single).max() < 1e-15


def test_the_attitude_starts_where_it_is_told(recorded: Recorded, tmp_path: Path) -> None:
    """With the identity instead of the motion's first attitude the error is the whole cone."""
    motion = motions.coning()
    rows = replay(recorded(motion, 1000), "rotation-vector subsamples=1", np.eye(4)[0], tmp_path / "attitude.csv")
    found = quaternion.error_angle(rows[:, 1:], motion.attitude(rows[:, 0]))
    assert found.min() > 0.08
