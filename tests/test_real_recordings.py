"""Recorded motion through the generated, compiled C: the bits are the model's, the attitudes lie where they should."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result
from numpy.typing import NDArray

from qcone.cli import main
from qcone.reference import quaternion
from shipped import EXAMPLES

pytestmark = pytest.mark.usefixtures("first_compiler")

BROAD = ("broad07_fast_rotation.csv", "--input", "rate")
FUSION_COLUMNS = "t=Time (s);x=Gyroscope X (deg/s);y=Gyroscope Y (deg/s);z=Gyroscope Z (deg/s);unit=deg/s"
FUSION = ("fusion_sensor_data.csv", "--input", "rate", "--columns", FUSION_COLUMNS, "--resample", "100")
RECORDINGS = {"broad07": (BROAD, 8572, 2000 / 7, 1200), "fusion": (FUSION, 13533, 100, 400)}
"""Arguments, samples after resampling, sub-samples a second, and a declared rate in deg/s above the data's."""


def replay(folder: Path, recording: Sequence[str], *options: str) -> Result:
    file, *arguments = recording
    return CliRunner().invoke(main, ["replay", str(folder / file), *arguments, *options])


CONING_3 = "rotation-vector subsamples=3 coefficients=coning"
COMPARED = [
    *((name, CONING_3, number) for name in RECORDINGS for number in ("float32", "float64")),
    ("broad07", "rotation-vector subsamples=4 coefficients=expanded", "float64"),
    ("broad07", "rotation-vector subsamples=1 previous=2", "float32"),
]


@pytest.mark.parametrize(("name", "example", "number"), COMPARED)
def test_the_bits_are_the_models_on_recorded_words(
    recordings: Path, tmp_path: Path, name: str, example: str, number: str
) -> None:
    recording, samples, _, _ = RECORDINGS[name]
    family, parameters = EXAMPLES[example]
    words = [word for key, value in parameters.items() if value for word in (f"--{key}", str(value))]
    output = tmp_path / "attitude.csv"
    chosen = ("--algorithm", family, *words, "--number", number)
    result = replay(recordings, recording, *chosen, "--compare", "-o", str(output))
    assert result.exit_code == 0, result.output
    updates = (samples - 1) // int(parameters.get("subsamples") or 1)
    assert f"0 differing bits against the bit-true model in {updates} updates" in result.stderr
    rows = np.loadtxt(output, delimiter=",", skiprows=1)
    assert rows.shape == (updates, 5)
    np.testing.assert_allclose(np.linalg.norm(rows[:, 1:], axis=1), 1, atol=4 * float(np.finfo(number).eps))


def test_an_irregular_recording_is_refused_unless_resampled(recordings: Path, tmp_path: Path) -> None:
    output = tmp_path / "attitude.csv"
    chosen = ("--algorithm", "rotation-vector", "--number", "float32", "-o", str(output))
    result = replay(recordings, FUSION[:-2], *chosen)
    assert result.exit_code == 2
    assert "irregular step" in result.stderr
    assert not output.exists()


@pytest.mark.parametrize(("axes", "right"), [("x,y,z", True), ("-x,y,-z", False), ("y,z,x", False)])
def test_the_attitude_follows_the_optical_reference(recordings: Path, tmp_path: Path, axes: str, right: bool) -> None:
    """Half a minute of fast rotation: errors of the gyroscope leave degrees, wrong axes or signs half a turn."""
    table = np.genfromtxt(recordings / BROAD[0], delimiter=",", names=True)
    seen = np.array([table[f"ref_{part}"] for part in "wxyz"]).T
    start = ",".join(f"{part:.17g}" for part in seen[0] / np.linalg.norm(seen[0]))
    output = tmp_path / "attitude.csv"
    chosen = ("--algorithm", "rotation-vector", "--subsamples", "3", "--number", "float64", "--axes", axes)
    result = replay(recordings, BROAD, *chosen, "--initial", start, "-o", str(output))
    assert result.exit_code == 0, result.output
    rows = np.loadtxt(output, delimiter=",", skiprows=1)
    at = np.searchsorted(table["t_s"], rows[:, 0] - 1e-6)
    known = np.isfinite(seen[at]).all(axis=1)
    assert known.sum() > 2000
    largest = float(np.degrees(quaternion.error_angle(rows[known, 1:], seen[at[known]])).max())
    assert largest < 15 if right else largest > 150


DESIGNS = {
    "coning_3_float64": 'subsamples = 3\ncoefficients = "coning"\n',
    "coning_3_float32": 'subsamples = 3\ncoefficients = "coning"\n',
    "coning_3_float32_standard": 'subsamples = 3\ncoefficients = "coning"\n',
    "coning_3_float32_compensated": 'subsamples = 3\ncoefficients = "coning"\n',
    "taylor_3_float64": 'subsamples = 3\ncoefficients = "taylor"\n',
    "compressed_3_float64": 'subsamples = 3\ncoefficients = "compressed"\n',
    "single_1_float64": "subsamples = 1\n",
    "single_1_float32": "subsamples = 1\n",
    "history_1_float64": "subsamples = 1\nprevious = 3\n",
}


def design_file(path: Path, sample_hz: float, max_rate_dps: int) -> Path:
    """Write the designs above for a recording."""
    text = ""
    for name, keys in DESIGNS.items():
        words = name.split("_")
        accumulate = words[3] if len(words) > 3 else "delta"
        text += f'[design.{name}]\nalgorithm = "rotation-vector"\ninput = "rate"\n{keys}'
        hz = f"{sample_hz / int(words[1]):.9f}"
        text += f"imu = {{ update_hz = {hz}, max_rate_dps = {max_rate_dps} }}\n"
        text += f'number = {{ format = "{words[2]}", accumulate = "{accumulate}" }}\n\n'
    path.write_text(text)
    return path


@pytest.fixture(scope="module", params=list(RECORDINGS))
def differences(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The table of attitude differences to the first design, largest in degrees, by design."""
    recording, samples, hz, rate = RECORDINGS[request.param]
    folder: Path = request.getfixturevalue("recordings")
    file = design_file(tmp_path_factory.mktemp("designs") / "compared.toml", hz, rate)
    chosen = [word for name in DESIGNS for word in ("--design", f"{file}:{name}")]
    result = replay(folder, recording, *chosen, "--format", "json")
    assert result.exit_code == 0, result.output
    table = json.loads(result.stdout)
    assert table["command"] == "replay"
    assert [row["design"] for row in table["rows"]] == list(DESIGNS)
    assert {row["compared"] for row in table["rows"]} == {(samples - 1) // 3}
    return {row["design"]: row["largest_deg"] for row in table["rows"]}


def test_differences_between_formats_and_algorithms_are_sane(differences: dict[str, Any]) -> None:
    """Rounding to float32 leaves less than a thousandth of a degree; one sub-sample an update loses far more."""
    assert differences["coning_3_float64"] == 0
    rounding = [differences["coning_3_float32"], differences["coning_3_float32_standard"]]
    assert 0 < differences["coning_3_float32_compensated"] < min(rounding)
    assert max(rounding) < 1e-3
    single = differences["single_1_float64"]
    assert 100 * max(rounding) < single < 1
    assert differences["single_1_float32"] == pytest.approx(single, abs=1e-3)
    assert 0 < differences["taylor_3_float64"] < differences["compressed_3_float64"] < single
    assert 0 < differences["history_1_float64"] < single


QUANTUM_DPS, SAMPLE_HZ = Fraction(2000, 32768), 100
"""Deg/s of one count of the gyroscope of `imucal_session.csv`, and its rate."""


@pytest.fixture(scope="module")
def counts(recordings: Path) -> NDArray[np.int64]:
    """The words of a real gyroscope, as its registers held them: the recording has them times the quantum."""
    table = np.genfromtxt(recordings / "imucal_session.csv", delimiter=",", names=True)
    found = np.array([table[f"gyr_{axis}"] for axis in "xyz"]).T / float(QUANTUM_DPS)
    whole = np.rint(found).astype(np.int64)
    assert np.abs(found - whole).max() < 1e-6
    assert np.linalg.norm(whole * float(QUANTUM_DPS), axis=1).max() == pytest.approx(908, abs=1)
    assert -(2**15) <= whole.min() < whole.max() < 2**15
    return whole


def attitudes(result: Result, file: Path, updates: int) -> NDArray[np.float64]:
    assert result.exit_code == 0, result.output
    assert f"0 differing bits against the bit-true model in {updates} updates" in result.stderr
    return np.loadtxt(file, delimiter=",", skiprows=1)[:, 1:5]


@pytest.mark.parametrize("accumulate", ["delta", "compensated"])
@pytest.mark.parametrize("subsamples", [1, 3])
def test_counts_of_a_gyroscope_give_the_attitude_of_the_increments_they_stand_for(
    counts: NDArray[np.int64], tmp_path: Path, subsamples: int, accumulate: str
) -> None:
    common = ("--algorithm", "rotation-vector", "--subsamples", str(subsamples), "--max-rate-dps", "910", "--compare")
    updates, output = len(counts) // subsamples, tmp_path / "attitude.csv"
    np.savetxt(tmp_path / "counts.csv", counts, "%d", ",", header="x,y,z", comments="")
    words = ("--quantum-dps", str(QUANTUM_DPS), "--sample-hz", str(SAMPLE_HZ), "--columns", "x=x;y=y;z=z")
    chosen = ("--number", "fixed32", "--accumulate", accumulate, "-o", str(output))
    result = replay(tmp_path, ("counts.csv", "--input", "counts", *words), *common, *chosen)
    found = attitudes(result, output, updates)
    increments = np.radians(counts * float(QUANTUM_DPS)) / SAMPLE_HZ
    rows = np.column_stack([np.arange(1, len(counts) + 1) / SAMPLE_HZ, increments])
    names = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad"
    np.savetxt(tmp_path / "increments.csv", rows, "%.17g", ",", header=names, comments="")
    result = replay(tmp_path, ("increments.csv",), *common, "--number", "float64", "-o", str(output))
    exact = attitudes(result, output, updates)
    largest = float(np.degrees(quaternion.error_angle(found, exact)).max())
    # Words of the attitude say 1e-7 deg; a wrong sign, quantum or rate would show in whole degrees.
    assert 1e-8 < largest < 1e-3
