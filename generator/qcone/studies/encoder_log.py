"""A recording of a rotating unit: the encoder of its axis beside its gyro and accelerometers; rins (6)-(7).

Everything that makes such a recording useless for a fit is refused here, with the row where it stands.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qcone.errors import UsageError
from qcone.reference.quaternion import Array

IRREGULAR = 0.01  # of the median step: more than this off it is irregular
AGREEMENT = (0.5, 2.0)  # encoder turn for turn of the gyro; outside it a sign or a unit is wrong
UNKNOWNS = 4  # sine, cosine and offset of the first harmonic, and the gyro bias


@dataclass(frozen=True)
class EncoderLog:
    """A recording of a rotating unit whose body stands still, one row each `time_s`, evenly spaced.

    `time_s` (n,) s; `encoder_rad` (n,) rad, wrapped or counted through; `rate_z_rad_s` (n,) the gyro along the axis
    of rotation, mean over the step that ends at the row, as a gyro that counts angle gives it; `force_m_s2` (n, 3)
    specific force in the sensor frame; `q_ns` (n, 4) attitude of the sensor frame, to navigation, as the unit computes
    it (not needed to fit). `source` names the recording in messages.

    Of a gyro that gives instantaneous rates, enter the mean of each row's rate and the one before: half a step of
    rotation at every reversal is arc minutes.
    """

    time_s: Array
    encoder_rad: Array
    rate_z_rad_s: Array
    force_m_s2: Array
    q_ns: Array | None = None
    source: str = "encoder log"


def gyro_steps(log: EncoderLog) -> Array:
    """Return the angle the gyro turned from row to row, (n - 1,) rad, bias included."""
    steps: Array = np.diff(log.time_s) * log.rate_z_rad_s[1:]
    return steps


def encoder_steps(log: EncoderLog) -> Array:
    """Return the angle the encoder turned from row to row, (n - 1,) rad, its wraps removed.

    The gyro tells how many whole turns a step went, so that fast or sparse recordings are not folded.
    """
    steps = np.diff(log.encoder_rad)
    unwrapped: Array = steps - 2 * np.pi * np.round((steps - gyro_steps(log)) / (2 * np.pi))
    return unwrapped


def check_log(log: EncoderLog) -> None:
    """Refuse a log nothing can be fitted to.

    Raises UsageError for arrays of unlike length, numbers that are not finite, fewer rows than unknowns, times that
    do not increase or are uneven, less than a full turn, and an encoder that does not go with the gyro.
    """
    check_columns(log)
    if log.time_s.size < UNKNOWNS:
        raise UsageError(
            f"{log.source}: fewer rows than unknowns, {log.time_s.size} given for {UNKNOWNS} (sine, cosine, offset "
            f"and gyro bias), record at least one turn"
        )
    _check_clock(log)
    _check_turn(log)


def check_columns(log: EncoderLog) -> None:
    """Refuse columns of unlike length and numbers that are not finite (UsageError), naming the first."""
    rows = np.size(log.time_s)
    columns = {
        "time_s": (log.time_s, (rows,)),
        "encoder_rad": (log.encoder_rad, (rows,)),
        "rate_z_rad_s": (log.rate_z_rad_s, (rows,)),
        "force_m_s2": (log.force_m_s2, (rows, 3)),
        "q_ns": (log.q_ns, (rows, 4)),
    }
    for name, (values, shape) in columns.items():
        if values is None:
            continue
        if np.shape(values) != shape:
            raise UsageError(
                f"{log.source}: {name} has shape {np.shape(values)}, the {rows} rows of time_s need {shape}, "
                f"give every column of every row"
            )
        bad = np.flatnonzero(~np.isfinite(values).all(axis=tuple(range(1, len(shape)))))
        if bad.size:
            raise UsageError(
                f"{log.source}: row {int(bad[0]) + 1}: {name} is not a finite number ({bad.size} of {rows} rows), "
                f"no row is left out unasked, mend or remove it"
            )


def _check_clock(log: EncoderLog) -> None:
    steps = np.diff(log.time_s)
    if np.any(steps <= 0):
        row = int(np.argmax(steps <= 0)) + 1
        raise UsageError(
            f"{log.source}: row {row + 1}: time does not increase, {float(log.time_s[row])!r} s comes after "
            f"{float(log.time_s[row - 1])!r} s, sort or remove rows"
        )
    median = float(np.median(steps))
    allowed = IRREGULAR * median + 2.0 * float(np.spacing(np.max(np.abs(log.time_s))))
    off = np.flatnonzero(np.abs(steps - median) > allowed)
    if off.size:
        row = int(off[0]) + 1
        raise UsageError(
            f"{log.source}: row {row + 1}: irregular time step, {float(steps[row - 1]):g} s where the median is "
            f"{median:g} s, the angle the gyro turned in a gap is lost, resample the log or cut it there"
        )


def _check_turn(log: EncoderLog) -> None:
    steps, gyro = encoder_steps(log), gyro_steps(log)
    turned = float(np.ptp(np.concatenate([[0.0], np.cumsum(steps)])))
    if turned + float(np.max(np.abs(steps))) < 2 * np.pi:  # a turn of samples ends one step short of its beginning
        raise UsageError(
            f"{log.source}: no full turn, the encoder covers {np.rad2deg(turned):.4g} deg, the harmonics need "
            f"angles of all 360 deg, record at least one turn (encoder_rad is in rad)"
        )
    agreement = float(steps @ gyro / max(float(gyro @ gyro), float(np.finfo(np.float64).tiny)))
    if not AGREEMENT[0] <= agreement <= AGREEMENT[1]:
        raise UsageError(
            f"{log.source}: the encoder turns {agreement:.3g} times what the gyro does, which is its reference, "
            f"give both the same sense of rotation, in rad and rad/s"
        )
