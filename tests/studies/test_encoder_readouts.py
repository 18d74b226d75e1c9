"""The table of encoder read-outs: what holds of the paper's half arc minute, and what does not."""

from __future__ import annotations

import re

import numpy as np
import pytest

from qcone.errors import UsageError
from qcone.reference.euler import from_angles
from qcone.reference.rotating_unit import ARCSEC, simulate
from qcone.studies.encoder_correction import fit_encoder, fit_tilt
from qcone.studies.encoder_readouts import Row, azimuth_verdict, correction_rows, log_of, peak_to_peak, tilt_verdict


@pytest.fixture(scope="module")
def table() -> list[Row]:
    return correction_rows()


def rows_of(table: list[Row], quantity: str) -> dict[str, tuple[float, float, str]]:
    return {
        str(row["read_out"]): (float(str(row["before"])), float(str(row["measured"])), str(row["verdict"]))
        for row in table
        if row["quantity"] == quantity
    }


def test_azimuth_falls_below_half_an_arc_minute_unless_pulses_are_taken_raw(table: list[Row]) -> None:
    azimuth = rows_of(table, "azimuth")
    for name in ("ideal", "averaged", "averaged, C in float32", "averaged-centred"):
        before, after, verdict = azimuth[name]
        assert before >= 150
        assert after < 30
        assert verdict == "holds-under-reading"
    before, after, verdict = azimuth["raw"]
    assert before == pytest.approx(222, rel=0.05)
    assert after == pytest.approx(81, rel=0.05)
    assert verdict == "does-not-hold"
    before, after, verdict = azimuth["x4"]
    assert before == pytest.approx(173, rel=0.05)
    assert 30 < after == pytest.approx(33.5, rel=0.1)
    assert verdict == "does-not-hold"


def test_pitch_and_roll_fall_below_five_arcsec(table: list[Row]) -> None:
    for quantity in ("pitch", "roll"):
        for before, after, verdict in rows_of(table, quantity).values():
            assert 27 <= before <= 30
            assert after < 3.5
            assert verdict == "holds"


def test_verdicts_need_the_error_to_be_there_before_and_gone_after() -> None:
    assert azimuth_verdict(150.0, 29.9, "x")[0] == "holds-under-reading"
    assert azimuth_verdict(149.9, 10.0, "x")[0] == "does-not-hold"
    assert "less to correct than claimed" in azimuth_verdict(149.9, 10.0, "x")[1]
    assert azimuth_verdict(150.0, 30.0, "x")[0] == "does-not-hold"
    assert tilt_verdict(27.0, 4.9, "x") == ("holds", "")
    for before, after in ((26.9, 4.9), (30.1, 4.9), (28.0, 5.0)):
        assert tilt_verdict(before, after, "x") == (
            "does-not-hold",
            f"{before:.1f} arcsec before and {after:.1f} after, x",
        )


def test_every_row_is_flat_and_says_why_where_it_does_not_hold(table: list[Row]) -> None:
    keys = set(table[0])
    assert {"id", "claim", "paper", "paper_value", "measured", "tolerance", "verdict", "reason"} <= keys
    for row in table:
        assert set(row) == keys
        assert all(isinstance(value, str | float) for value in row.values())
        assert row["verdict"] == "holds" or row["reason"]
    reasons = {row["read_out"]: str(row["reason"]) for row in table if row["quantity"] == "azimuth"}
    assert reasons["raw"].endswith("are left, the read-out is too coarse: 20000 pulses a turn, 64.8 arcsec each")
    assert reasons["averaged"].startswith("if the encoder is read finer than its stated 1.08 arcmin")


def test_the_seed_and_the_rate_move_the_figures(table: list[Row]) -> None:
    slow, again, other = correction_rows(0, 1.0), correction_rows(0, 1.0), correction_rows(5, 1.0)
    assert slow == again
    for row, moved, default in zip(slow, other, table, strict=True):
        assert row["measured"] != moved["measured"]
        assert row["measured"] != default["measured"]


@pytest.mark.parametrize("rate", [0.0, -1.0, np.nan, np.inf, 0.3, 101.0])
def test_a_rate_the_unit_cannot_be_sampled_at_is_refused(rate: float) -> None:
    with pytest.raises(UsageError, match=re.escape(f"--rate-hz {rate:g}: the unit reverses every 525 s and that must")):
        correction_rows(rate_hz=rate)


def test_the_fit_finds_the_simulated_harmonics() -> None:
    log = log_of(simulate("ideal", seed=3))
    encoder = fit_encoder(log)
    assert encoder.sine == pytest.approx(54 * ARCSEC, abs=0.1 * ARCSEC)
    assert encoder.cosine == pytest.approx(-51 * ARCSEC, abs=0.1 * ARCSEC)
    # Left are the harmonics of 4 and 3 arcsec and 1 arcsec of noise.
    assert encoder.residual == pytest.approx(np.sqrt(4**2 / 2 + 3**2 / 2 + 1) * ARCSEC, rel=0.01)
    tilt_x, tilt_y = fit_tilt(log, encoder)
    assert (tilt_x.sine, tilt_y.cosine) == pytest.approx((13.6 * ARCSEC, 13.6 * ARCSEC), abs=0.1 * ARCSEC)
    assert (tilt_x.cosine, tilt_y.sine) == pytest.approx((0.0, 0.0), abs=0.1 * ARCSEC)


def test_the_papers_residual_of_twenty_arcsec_is_its_pulse() -> None:
    """A pulse of 64.8 arcsec alone leaves 64.8/sqrt(12) = 18.7 arcsec rms."""
    assert fit_encoder(log_of(simulate("raw"))).residual / ARCSEC == pytest.approx(
        np.hypot(64.8 / np.sqrt(12), 3.68), rel=0.01
    )


def test_peaks_are_of_the_angles_named_and_wrap() -> None:
    true = from_angles(np.array([[0.1, 0.2, np.pi - 1e-6]] * 3), "zxy")
    off = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, -2.0, 3.0]]) * ARCSEC
    wrong = from_angles(np.array([[0.1, 0.2, np.pi - 1e-6]]) + off, "zxy")
    assert peak_to_peak(wrong, true) == pytest.approx((1.0, 2.0, 3.0), rel=1e-6)
