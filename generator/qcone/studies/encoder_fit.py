"""The nine coefficients of a rotating unit from a user's own log, as its firmware takes them."""

from __future__ import annotations

from math import hypot
from pathlib import Path

from qcone.studies.encoder_correction import Harmonic, averaged, fit_encoder, fit_tilt
from qcone.studies.encoder_readouts import ARCSEC
from qcone.studies.encoder_recording import read_encoder_log
from qcone.studies.selection import Say

Row = dict[str, object]


def fitted_rows(path: Path, columns: str | None, average: float | None, instantaneous: bool, say: Say) -> list[Row]:
    """Fit the encoder's first harmonic and the tilt's second; return a row each for azimuth, tilt_x and tilt_y.

    Keys: quantity, harmonic, sine_rad, cosine_rad, offset_rad (what `<name>_set_correction` takes, in this order),
    largest_arcsec (of the correction: what `max_correction_arcsec` has to cover) and residual_arcsec (rms). `average`
    is the window in s over which the encoder is averaged against the gyro; see `read_encoder_log` for the rest.
    Raises UsageError for a log that cannot be read or fitted.
    """
    log = read_encoder_log(path, columns, instantaneous)
    if average is not None:
        log = averaged(log, average)
    encoder = fit_encoder(log)
    tilt_x, tilt_y = fit_tilt(log, encoder)
    say("the azimuth's offset depends on where the log begins: alignment has to settle it, zero leaves it out")
    say("a tilt's offset holds the accelerometer's bias too, 5 ug as 1 arcsec: zero leaves both out")
    return [_row("azimuth", encoder), _row("tilt_x", tilt_x), _row("tilt_y", tilt_y)]


def _row(quantity: str, fitted: Harmonic) -> Row:
    return {
        "quantity": quantity,
        "harmonic": fitted.order,
        "sine_rad": fitted.sine,
        "cosine_rad": fitted.cosine,
        "offset_rad": fitted.offset,
        "largest_arcsec": (hypot(fitted.sine, fitted.cosine) + abs(fitted.offset)) / ARCSEC,
        "residual_arcsec": fitted.residual / ARCSEC,
    }
