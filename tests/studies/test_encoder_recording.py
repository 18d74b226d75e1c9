"""A unit's own log: read, mapped, refused with its place; and the nine coefficients that come out of it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from qcone.errors import UsageError
from qcone.reference.rotating_unit import ARCSEC, simulate
from qcone.studies.encoder_correction import averaged, fit_encoder, fit_tilt
from qcone.studies.encoder_fit import fitted_rows
from qcone.studies.encoder_readouts import log_of
from qcone.studies.encoder_recording import read_encoder_log

HEADER = "t_s,encoder_rad,gyr_z_rad_s,acc_x_m_s2,acc_y_m_s2,acc_z_m_s2"
ROWS = "0,0.1,0.01,0,0,9.8\n1,0.11,0.03,0.1,0.2,9.8\n2,0.13,0.01,0,0,9.8\n"
FORM = "write 't=NAME;encoder=NAME;gyr_z=NAME;acc_x=NAME;acc_y=NAME;acc_z=NAME;unit=UNIT', those of another name alone"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "unit.csv"


def test_a_log_is_read_column_by_column(file: Path) -> None:
    file.write_text(f"{HEADER}\n{ROWS}")
    log = read_encoder_log(file)
    np.testing.assert_array_equal(log.time_s, [0, 1, 2])
    np.testing.assert_array_equal(log.encoder_rad, [0.1, 0.11, 0.13])
    np.testing.assert_array_equal(log.rate_z_rad_s, [0.01, 0.03, 0.01])
    np.testing.assert_array_equal(log.force_m_s2, [[0, 0, 9.8], [0.1, 0.2, 9.8], [0, 0, 9.8]])
    assert log.q_ns is None
    assert log.source == str(file)


def test_rates_of_instants_become_means_over_the_step_before(file: Path) -> None:
    file.write_text(f"{HEADER}\n{ROWS}")
    np.testing.assert_allclose(read_encoder_log(file, None, True).rate_z_rad_s, [0.01, 0.02, 0.02], rtol=1e-15)


def test_names_and_units_are_mapped_and_the_others_keep_theirs(file: Path) -> None:
    file.write_text(
        f"x,{HEADER}\n".replace("encoder_rad", "Angle (deg)").replace("gyr_z_rad_s", "wz")
        + "9,"
        + ROWS[:-1].replace("\n", "\n9,")
    )
    log = read_encoder_log(file, "encoder=Angle (deg); gyr_z = wz ;unit=deg")
    np.testing.assert_allclose(log.encoder_rad, np.deg2rad([0.1, 0.11, 0.13]), rtol=1e-15)
    np.testing.assert_allclose(log.rate_z_rad_s, np.deg2rad([0.01, 0.03, 0.01]), rtol=1e-15)


MAPS = {
    "encoder": f"--columns: 'encoder' is not key=name, {FORM}",
    "encoder=": f"--columns: 'encoder=' is not key=name, {FORM}",
    "x=a": f"--columns: unknown key 'x', {FORM}",
    "t=a;t=b": f"--columns: 't' is given twice, {FORM}",
    "unit=grad": "--columns: unknown unit 'grad', give one of rad, deg",
    "acc_x=a;acc_y=a": "--columns: acc_x and acc_y both name 'a', give each its own column",
    "encoder=gyr_z_rad_s": "--columns: encoder and gyr_z both name 'gyr_z_rad_s', give each its own column",
}


@pytest.mark.parametrize("text", MAPS)
def test_a_map_that_cannot_be_read_is_refused(file: Path, text: str) -> None:
    file.write_text(f"{HEADER}\n{ROWS}")
    with pytest.raises(UsageError, match=f"^{re.escape(MAPS[text])}$"):
        read_encoder_log(file, text)


FILES = {
    "no such column": (
        f"{HEADER}\n".replace("encoder_rad", "encoder_rd"),
        ":1: no column 'encoder_rad', did you mean 'encoder_rd' for 'encoder_rad'?, the columns are 't_s', "
        "'encoder_rd', 'gyr_z_rad_s', 'acc_x_m_s2', 'acc_y_m_s2', 'acc_z_m_s2', map the names with --columns",
    ),
    "several missing": (
        "t_s,encoder_rad,gyr_z_rad_s\n",
        ":1: no columns 'acc_x_m_s2', 'acc_y_m_s2', 'acc_z_m_s2', the columns are 't_s', 'encoder_rad', 'gyr_z_rad_s', "
        "map the names with --columns",
    ),
    "a column twice": (f"{HEADER},t_s\n", ":1: column 't_s' stands there twice, rename one of the two"),
    "no rows": (f"{HEADER}\n", ": no data rows after the header, nothing to fit"),
    "nothing": ("", ": the file is empty, a header line and rows are needed"),
    "no number": (
        f"{HEADER}\n{ROWS}3,x,0,0,0,9\n",
        ":5: data row 4, column 'encoder_rad': 'x' is not a number, every sample counts, remove the row or mend it",
    ),
    "a short row": (
        f"{HEADER}\n1,2,3\n",
        ":2: data row 1: 3 cells where the header has 6, the line is cut short or has a stray comma (decimals take a "
        "point), mend or remove it",
    ),
}


@pytest.mark.parametrize("what", FILES)
def test_a_file_that_cannot_be_read_is_refused_with_its_place(file: Path, what: str) -> None:
    text, message = FILES[what]
    file.write_text(text)
    with pytest.raises(UsageError, match=f"^{re.escape(str(file) + message)}$"):
        read_encoder_log(file)


def written(file: Path, readout: str, degrees: bool = False, seed: int = 0) -> None:
    """Write what a simulated unit records, its encoder wrapped to a turn."""
    log = log_of(simulate(readout, seed=seed))  # type: ignore[arg-type]
    scale = 180 / np.pi if degrees else 1.0
    columns = [log.time_s, scale * np.mod(log.encoder_rad, 2 * np.pi), scale * log.rate_z_rad_s, *log.force_m_s2.T]
    rows = (",".join(f"{value:.17g}" for value in row) for row in np.column_stack(columns))
    file.write_text("\n".join([HEADER, *rows, ""]))


def said() -> tuple[list[str], object]:
    notes: list[str] = []
    return notes, lambda text, kind="note": notes.append(f"{kind}: {text}")


def test_the_coefficients_of_a_simulated_unit_come_out(file: Path) -> None:
    written(file, "ideal", seed=3)
    notes, say = said()
    azimuth, tilt_x, tilt_y = fitted_rows(file, None, None, False, say)  # type: ignore[arg-type]
    assert [each["quantity"] for each in (azimuth, tilt_x, tilt_y)] == ["azimuth", "tilt_x", "tilt_y"]
    assert [each["harmonic"] for each in (azimuth, tilt_x, tilt_y)] == [1, 2, 2]
    near = {"abs": 0.1 * ARCSEC}
    assert [azimuth["sine_rad"], azimuth["cosine_rad"]] == pytest.approx([54 * ARCSEC, -51 * ARCSEC], **near)
    assert [tilt_x["sine_rad"], tilt_x["cosine_rad"]] == pytest.approx([13.6 * ARCSEC, 0], **near)
    assert [tilt_y["sine_rad"], tilt_y["cosine_rad"]] == pytest.approx([0, 13.6 * ARCSEC], **near)
    log = log_of(simulate("ideal", seed=3))
    encoder = fit_encoder(log)
    for row, fitted in zip((azimuth, tilt_x, tilt_y), (encoder, *fit_tilt(log, encoder)), strict=True):
        wanted = [fitted.sine, fitted.cosine, fitted.offset]
        assert [row["sine_rad"], row["cosine_rad"], row["offset_rad"]] == pytest.approx(wanted, abs=1e-9)
        assert row["residual_arcsec"] == pytest.approx(fitted.residual / ARCSEC, rel=1e-4)
        size = np.hypot(fitted.sine, fitted.cosine) + abs(fitted.offset)
        assert row["largest_arcsec"] == pytest.approx(size / ARCSEC, rel=1e-4)
    assert len(notes) == 2
    assert all(each.startswith("note: ") for each in notes)


def test_degrees_are_the_same_log(file: Path) -> None:
    _, say = said()
    found = []
    for degrees, columns in ((False, None), (True, "unit=deg")):
        written(file, "raw", degrees)
        found.append(fitted_rows(file, columns, None, False, say))  # type: ignore[arg-type]
    for one, other in zip(*found, strict=True):
        assert one.pop("quantity") == other.pop("quantity")
        assert list(one.values()) == pytest.approx(list(other.values()), rel=1e-6, abs=1e-12)


def test_averaging_sees_below_the_pulses(file: Path) -> None:
    written(file, "raw")
    _, say = said()
    raw, *_ = fitted_rows(file, None, None, False, say)  # type: ignore[arg-type]
    fine, *_ = fitted_rows(file, None, 10.0, False, say)  # type: ignore[arg-type]
    assert float(str(raw["residual_arcsec"])) > 18
    assert float(str(fine["residual_arcsec"])) < 4
    log = averaged(log_of(simulate("raw")), 10.0)
    assert fine["sine_rad"] == pytest.approx(fit_encoder(log).sine, abs=1e-9)
