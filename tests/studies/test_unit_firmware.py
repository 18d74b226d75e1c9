"""The body's attitude from compiled C: NumPy's twin to the rounding, in both formats, and what it refuses."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from qcone.errors import UsageError
from qcone.reference.rotating_unit import ARCSEC, Record, simulate
from qcone.studies import unit_firmware
from qcone.studies.claims.claim import Settings
from qcone.studies.curves import rins as curves
from qcone.studies.encoder_correction import Harmonic, correct, fit_encoder, fit_tilt
from qcone.studies.encoder_log import EncoderLog
from qcone.studies.encoder_readouts import correction_rows, log_of, peak_to_peak
from qcone.studies.unit_firmware import firmware_attitude

pytestmark = pytest.mark.usefixtures("first_compiler")

Fits = tuple[Harmonic, tuple[Harmonic, Harmonic]]


@pytest.fixture(scope="module", params=["ideal", "raw", "averaged"])
def record(request: pytest.FixtureRequest) -> Record:
    return simulate(request.param, seed=2)


@pytest.fixture(scope="module")
def log(record: Record) -> EncoderLog:
    return log_of(record)


@pytest.fixture(scope="module")
def fits(log: EncoderLog) -> Fits:
    encoder = fit_encoder(log)
    return encoder, fit_tilt(log, encoder)


@pytest.mark.parametrize(("number", "units"), [("float64", 5), ("float32", 5)])
def test_numpy_says_the_same_to_the_rounding(log: EncoderLog, fits: Fits, number: str, units: int) -> None:
    """Over 4200 s: with both corrections, each alone, and none; float32 rounds its arguments too."""
    encoder, tilt = fits
    allowed = units * float(np.finfo(number).eps)
    for one, other in ((encoder, tilt), (encoder, None), (None, tilt), (None, None)):
        assert np.abs(firmware_attitude(log, one, other, number) - correct(log, one, other)).max() <= allowed


def test_peaks_are_those_of_numpy(record: Record, log: EncoderLog, fits: Fits) -> None:
    ours = peak_to_peak(firmware_attitude(log, *fits), record.body_attitude)
    assert ours == pytest.approx(peak_to_peak(correct(log, *fits), record.body_attitude), abs=1e-6)
    single = peak_to_peak(firmware_attitude(log, *fits, number="float32"), record.body_attitude)
    assert single == pytest.approx(ours, abs=0.3)


def test_a_log_without_the_sensors_attitude_is_refused(log: EncoderLog) -> None:
    with pytest.raises(UsageError, match="no attitude of the sensor frame"):
        firmware_attitude(replace(log, q_ns=None))


def test_angles_and_harmonics_beyond_the_declared_range_are_refused(log: EncoderLog) -> None:
    beyond = replace(log, encoder_rad=log.encoder_rad + 4 * np.pi)
    with pytest.raises(UsageError, match=re.escape("rad, firmware takes 3 pi: wrap it to a turn")):
        firmware_attitude(beyond)
    offset = Harmonic(500 * ARCSEC, 0.0, 101 * ARCSEC, 1, 0.0)
    with pytest.raises(UsageError, match=re.escape("a harmonic reaches 0.002914 rad, the design declares 0.002909")):
        firmware_attitude(log, offset)
    with pytest.raises(UsageError, match="a harmonic reaches"):
        firmware_attitude(log, None, (Harmonic(0, 0, 0, 2, 0), offset))
    firmware_attitude(log, replace(offset, offset=100 * ARCSEC))


def test_the_claims_and_the_figures_come_from_the_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """A turn of the attitude that the C gave shows in every row after the correction, and in the figures."""
    honest = correction_rows(3, 1.0)
    drawn = curves.pitch_and_roll(Settings(seed=3))
    right = unit_firmware.verify.c_words

    def words(*given: object) -> object:
        found, contracted = right(*given)  # type: ignore[arg-type]
        bent = found.copy()
        bent[..., -4:] += 1e-5 * np.sin(np.arange(found.shape[1]))[:, None]
        return bent, contracted

    monkeypatch.setattr(unit_firmware.verify, "c_words", words)
    curves._unit.cache_clear()
    for row, other in zip(honest, correction_rows(3, 1.0), strict=True):
        assert row["measured"] != other["measured"]
        assert row["before"] != other["before"]
    bent = curves.pitch_and_roll(Settings(seed=3))
    curves._unit.cache_clear()
    assert not np.array_equal(drawn.panels[0].curves[1].y, bent.panels[0].curves[1].y)
