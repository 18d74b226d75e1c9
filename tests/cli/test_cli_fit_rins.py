"""`qcone fit-rins`: rows in every layout, and logs that cannot be fitted: one message, exit code 2, nothing written."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from given import everything

from qcone.cli import LAYOUTS

HEADER = "t_s,encoder_rad,gyr_z_rad_s,acc_x_m_s2,acc_y_m_s2,acc_z_m_s2\n"
KEYS = ["quantity", "harmonic", "sine_rad", "cosine_rad", "offset_rad", "largest_arcsec", "residual_arcsec"]
TURN = 2 * np.pi


def log(turns: float, step_s: float = 0.5, rows: int | None = None, rate: float = 0.05, sense: int = 1) -> str:
    """Return a log that turns one way; 100 arcsec of first harmonic, 20 of second."""
    count = int(turns * TURN / (rate * step_s)) + 2 if rows is None else rows
    time = step_s * np.arange(count)
    angle = rate * time
    encoder = angle + np.deg2rad(100 / 3600) * np.sin(angle)
    tilt = np.deg2rad(20 / 3600) * np.cos(2 * angle)
    lines = [
        f"{t:.6f},{sense * np.mod(a, TURN):.12f},{rate:.15f},0,{9.8 * d:.12f},9.8\n"
        for t, a, d in zip(time, encoder, tilt, strict=True)
    ]
    return HEADER + "".join(lines)


@pytest.fixture
def unit(tmp_path: Path) -> Path:
    """Three whole turns of 250 rows: over them the mean force is the body's."""
    file = tmp_path / "unit.csv"
    file.write_text(log(3, rows=750, rate=TURN / 125))
    return file


def test_rows_of_fit_rins(run, unit: Path) -> None:
    result = run("fit-rins", "unit.csv", "--format", "json")
    assert result.exit_code == 0
    document = json.loads(result.stdout)
    assert (document["schema_version"], document["command"]) == (1, "fit-rins")
    azimuth, tilt_x, tilt_y = document["rows"]
    assert [list(row) for row in document["rows"]] == [KEYS] * 3
    assert azimuth["sine_rad"] == pytest.approx(np.deg2rad(100 / 3600), rel=1e-3)
    assert tilt_x["cosine_rad"] == pytest.approx(np.deg2rad(20 / 3600), rel=1e-3)
    assert abs(tilt_y["sine_rad"]) < np.deg2rad(0.01 / 3600)
    assert azimuth["residual_arcsec"] < 0.1
    assert result.stderr.count("note: ") == 2


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_layout(run, unit: Path, layout: str) -> None:
    result = run("fit-rins", "unit.csv", "--format", layout)
    assert result.exit_code == 0
    for word in ("azimuth", "tilt_x", "tilt_y"):
        assert word in result.stdout.replace("\\_", "_").replace("tilt x", "tilt_x").replace("tilt y", "tilt_y")


BAD = {
    "no full turn": (
        log(0.6),
        (),
        "unit.csv: no full turn, the encoder covers 21",
        "record at least one turn (encoder_rad is in rad)\n",
    ),
    "fewer rows than unknowns": (
        log(1, rows=3),
        (),
        "unit.csv: fewer rows than unknowns, 3 given for 4 (sine, cosine, offset and gyro bias)",
        "record at least one turn\n",
    ),
    "a singular fit": (
        log(3, step_s=TURN / 0.05),
        (),
        "unit.csv: the fit is singular, the encoder angles are too alike to tell its 4 unknowns apart",
        "record more angles of the turn\n",
    ),
    "the wrong sense": (log(2, sense=-1), (), "unit.csv: the encoder turns -", "in rad and rad/s\n"),
    "an irregular step": (
        log(2).replace("\n3.000000,", "\n3.100000,"),
        (),
        "unit.csv: row 7: irregular time step, 0.6 s where the median is 0.5 s",
        "resample the log or cut it there\n",
    ),
    "a column that is not there": (
        log(2),
        ("--columns", "encoder=angle"),
        "unit.csv:1: no column 'angle', the columns are 't_s'",
        "map the names with --columns\n",
    ),
    "a window of nothing": (log(2), ("--average", "0"), "unit.csv: a window of 0 s", "give a positive time\n"),
    "a window that is no number": (
        log(2),
        ("--average", "nan"),
        "unit.csv: a window of nan s",
        "give a positive time\n",
    ),
    "no file": (None, (), "unit.csv: cannot be read, No such file or directory", "give an existing CSV file\n"),
}


@pytest.mark.parametrize("what", BAD)
def test_bad_logs(run, tmp_path: Path, what: str) -> None:
    text, words, begins, ends = BAD[what]
    if text is not None:
        (tmp_path / "unit.csv").write_text(text)
    before = everything(tmp_path)
    result = run("fit-rins", "unit.csv", *words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith(begins), result.stderr
    assert result.stderr.endswith(ends), result.stderr
    assert result.stderr.count("\n") == 1
    assert everything(tmp_path) == before
