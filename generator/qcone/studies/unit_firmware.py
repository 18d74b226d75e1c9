"""The attitude of the body of a rotating unit from the generated, compiled C: its angle and tilt corrected; rins (10).

The twin of `encoder_correction.correct`, which does the same by NumPy.
"""

from __future__ import annotations

import numpy as np

from qcone import verify
from qcone.backends.bittrue import dtype_of
from qcone.errors import UsageError
from qcone.reference.quaternion import Array
from qcone.stage_routines import BODY, LARGEST_ANGLE
from qcone.studies.encoder_correction import Harmonic
from qcone.studies.encoder_log import EncoderLog, check_columns
from qcone.studies.replaying import outputs_of
from qcone.studies.simulating import compiled, options
from qcone.unit_vectors import HARMONICS
from qcone.vectors import CORRECT, SET, Vectors, in_form

ZERO = Harmonic(0.0, 0.0, 0.0, 1, 0.0)


def firmware_attitude(
    log: EncoderLog,
    encoder: Harmonic | None = None,
    tilt: tuple[Harmonic, Harmonic] | None = None,
    number: str = "float64",
) -> Array:
    """Return the attitude of the body (n, 4), as the C of a rotation-vector design gives it row by row.

    The sensors' attitude `q_ns` of each row is set, the encoder's angle corrected, the body's attitude given. A
    correction that is None is zero. Raises UsageError for a log without `q_ns`, columns of unlike length, numbers that
    are not finite, and angles or harmonics beyond what the C declares; MissingToolError without a compiler.
    """
    check_columns(log)
    if log.q_ns is None:
        raise UsageError(
            f"{log.source}: no attitude of the sensor frame, the body's attitude is taken from it, give q_ns"
        )
    bundle, library = compiled(
        options("rotation-vector", number=number, max_rate_dps=573, update_hz=100, max_correction_arcsec=600)
    )
    harmonics = [each or ZERO for each in (encoder, *(tilt or (None, None)))]
    _check_range(log, harmonics, float(bundle.facts.known.correction or 0))
    rows, dtype = len(log.time_s) + 1, dtype_of(bundle.facts.number)
    restart = np.full((1, rows), SET, np.int32)
    restart[0, 0] = CORRECT
    attitude = np.zeros((1, rows, bundle.driver.attitude_size), dtype)
    attitude[0, 1:] = in_form(log.q_ns, bundle.driver.setter)
    angles = np.zeros((1, rows), dtype)
    angles[0, 1:] = log.encoder_rad
    correction = np.zeros((1, rows, HARMONICS), dtype)
    correction[0, 0] = [value for each in harmonics for value in (each.sine, each.cosine, each.offset)]
    still = np.zeros((1, rows, 3), dtype)
    vectors = Vectors(restart, attitude, still, still, angles, correction)
    produced, _ = verify.c_words(bundle, library, vectors)
    return outputs_of(bundle, produced)[BODY][0, 1:]


def _check_range(log: EncoderLog, harmonics: list[Harmonic], largest: float) -> None:
    """Raise UsageError for an angle or a harmonic beyond what the C declares."""
    angle = float(np.abs(log.encoder_rad).max())
    if angle > LARGEST_ANGLE:
        raise UsageError(f"{log.source}: the encoder reaches {angle:.4g} rad, firmware takes 3 pi: wrap it to a turn")
    for each in harmonics:
        size = float(np.hypot(each.sine, each.cosine)) + abs(each.offset)
        if size > largest:
            raise UsageError(
                f"{log.source}: a harmonic reaches {size:.4g} rad, the design declares {largest:.4g}: is the encoder's "
                "zero where it is meant to be?"
            )
