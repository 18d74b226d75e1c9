"""What a rotating unit gains by correcting its encoder angle and tilt, for encoders read out in different ways.

rins figures 15 and 18: peak-to-peak azimuth, pitch and roll error over 4200 s, before and after. Each row fits the
simulated recording itself, on the host; the body's attitude is that of the generated, compiled C. Nothing is taken
from the truth but the errors it is judged by. The sensors' own attitude C_s^n is taken as exact, as the paper has it:
only its transfer to the body is studied.
"""

from __future__ import annotations

import numpy as np

from qcone.errors import UsageError
from qcone.reference.euler import to_angles
from qcone.reference.quaternion import Array
from qcone.reference.rotating_unit import PERIOD, Readout, Record, simulate
from qcone.studies.encoder_correction import averaged, fit_encoder, fit_tilt
from qcone.studies.encoder_log import EncoderLog
from qcone.studies.unit_firmware import firmware_attitude

Row = dict[str, object]

ARCSEC = float(np.deg2rad(1 / 3600))
WINDOW = 10.0  # s
FASTEST_HZ = 100.0  # 420,001 rows
READOUTS: tuple[tuple[str, Readout, str, str], ...] = (
    ("ideal", "ideal", "no pulses", "float64"),
    ("raw", "raw", "20000 pulses a turn, 64.8 arcsec each", "float64"),
    ("x4", "x4", "80000 steps a turn, 16.2 arcsec each", "float64"),
    ("averaged", "averaged", "20000 pulses a turn, mean of the last 10 s", "float64"),
    ("averaged, C in float32", "averaged", "20000 pulses a turn, mean of the last 10 s", "float32"),
    ("averaged-centred", "raw", "20000 pulses a turn, mean of the 10 s around, bridged by the gyro", "float64"),
)
"""Name, read-out of the encoder, what it means, number format of the C that corrects."""
AZIMUTH = (150.0, 30.0)  # arcsec peak to peak: at least before, under after
PITCH_ROLL = ((27.0, 30.0), 5.0)  # arcsec peak to peak: from, to before, under after


def log_of(record: Record, source: str = "simulated unit") -> EncoderLog:
    """Return what a unit would have recorded of a simulated run: no truth but its own sensors' attitude."""
    return EncoderLog(
        time_s=record.time,
        encoder_rad=record.encoder,
        rate_z_rad_s=record.gyro[:, 2],
        force_m_s2=record.specific_force,
        q_ns=record.sensor_attitude,
        source=source,
    )


def peak_to_peak(q_estimate: Array, q_true: Array) -> tuple[float, float, float]:
    """Return the spread of the roll, pitch and azimuth error in arcsec of attitudes (n, 4), convention ZXY."""
    error = to_angles(q_estimate, "zxy") - to_angles(q_true, "zxy")
    wrapped = np.mod(error + np.pi, 2 * np.pi) - np.pi
    roll, pitch, azimuth = np.ptp(wrapped, axis=0) / ARCSEC
    return float(roll), float(pitch), float(azimuth)


def correction_rows(seed: int = 0, rate_hz: float = 10.0) -> list[Row]:
    """Return azimuth, pitch and roll before and after the correction for every read-out, a row each.

    Keys: id (R15 azimuth, R16 pitch and roll), claim, paper, read_out, quantity, unit, before, paper_value, measured
    (peak to peak after), tolerance, verdict, reason. `seed` moves the noise, `rate_hz` the sampling.
    Raises UsageError for a `rate_hz` that is out of range or puts no sample on the reversals, MissingToolError without
    a compiler.
    """
    if not 0 < rate_hz <= FASTEST_HZ or (rate_hz * PERIOD / 2) % 1:
        raise UsageError(
            f"--rate-hz {rate_hz:g}: the unit reverses every {PERIOD / 2:g} s and that must be whole samples, at most "
            f"{FASTEST_HZ:g} Hz, give 10 or another whole number"
        )
    rows: list[Row] = []
    for name, readout, meaning, number in READOUTS:
        record = simulate(readout, seed=seed, rate_hz=rate_hz)
        log = log_of(record)
        log = averaged(log, WINDOW) if name == "averaged-centred" else log
        encoder = fit_encoder(log)
        corrected = firmware_attitude(log, encoder, fit_tilt(log, encoder), number)
        before = peak_to_peak(firmware_attitude(log, number=number), record.body_attitude)
        after = peak_to_peak(corrected, record.body_attitude)
        rows.append(_azimuth_row(name, meaning, before[2], after[2]))
        rows.append(_tilt_row(name, meaning, "pitch", before[1], after[1]))
        rows.append(_tilt_row(name, meaning, "roll", before[0], after[0]))
    return rows


def azimuth_verdict(before: float, after: float, meaning: str) -> tuple[str, str]:
    """Return verdict and reason of azimuth errors in arcsec peak to peak, for a read-out of this `meaning`."""
    least, most = AZIMUTH
    if before < least:
        return "does-not-hold", f"{before:.1f} arcsec before the correction, there is less to correct than claimed"
    if after >= most:
        return "does-not-hold", f"{after:.1f} arcsec are left, the read-out is too coarse: {meaning}"
    return "holds-under-reading", f"if the encoder is read finer than its stated 1.08 arcmin: {meaning}"


def tilt_verdict(before: float, after: float, meaning: str) -> tuple[str, str]:
    """Return verdict and reason of pitch or roll errors in arcsec peak to peak, for a read-out of this `meaning`."""
    (low, high), most = PITCH_ROLL
    if low <= before <= high and after < most:
        return "holds", ""
    return "does-not-hold", f"{before:.1f} arcsec before and {after:.1f} after, {meaning}"


def _azimuth_row(name: str, meaning: str, before: float, after: float) -> Row:
    verdict, reason = azimuth_verdict(before, after, meaning)
    return {
        "id": "R15",
        "claim": "azimuth from 2..3 arcmin to under 0.5 arcmin",
        **_row(name, "azimuth", before, after),
        "paper_value": "120..180 -> under 30",
        "tolerance": f"from {AZIMUTH[0]:g} or more to under {AZIMUTH[1]:g}",
        "verdict": verdict,
        "reason": reason,
    }


def _tilt_row(name: str, meaning: str, quantity: str, before: float, after: float) -> Row:
    (low, high), most = PITCH_ROLL
    verdict, reason = tilt_verdict(before, after, meaning)
    return {
        "id": "R16",
        "claim": "pitch and roll from 20..30 to under 5 arcsec",
        **_row(name, quantity, before, after),
        "paper_value": "20..30 -> under 5",
        "tolerance": f"from {low:g}..{high:g} to under {most:g}",
        "verdict": verdict,
        "reason": reason,
    }


def _row(name: str, quantity: str, before: float, after: float) -> Row:
    return {
        "paper": "rins",
        "read_out": name,
        "quantity": quantity,
        "unit": "arcsec",
        "before": before,
        "measured": after,
    }
