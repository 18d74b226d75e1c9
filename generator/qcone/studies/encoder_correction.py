"""Correct the attitude of a rotating unit: encoder angle and tilt of the turning sensors, fitted to a recording.

rins (1)-(16). The sensor frame s turns by the angle al about z of the body b; s' is the ideal rotation frame,
s the actual one. East-north-up and right-forward-up axes; v_s' = C_b^{s'}(al) v_b = Rz(al)^T v_b.
Two errors are fitted by least squares and taken out: the first harmonic of the encoder angle, which is azimuth,
and the second harmonic of the tilt of s against s', which is pitch and roll.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from qcone.errors import UsageError
from qcone.reference.quaternion import Array, product
from qcone.studies.encoder_log import EncoderLog, check_columns, check_log, encoder_steps, gyro_steps

SMALLEST_SINGULAR_VALUE = 1e-4  # of the largest, unit columns: below it noise is magnified ten thousandfold
ENCODER_ORDER, TILT_ORDER = 1, 2


@dataclass(frozen=True)
class Harmonic:
    """sine sin(order al) + cosine cos(order al) + offset, in rad; `residual` is the rms of the fit, in rad."""

    sine: float
    cosine: float
    offset: float
    order: int
    residual: float

    def at(self, angle_rad: Array) -> Array:
        """Return the value (n,) in rad at the encoder angles `angle_rad` (n,) rad; rins (13), (16)."""
        phase = self.order * np.asarray(angle_rad, dtype=np.float64)
        value: Array = self.sine * np.sin(phase) + self.cosine * np.cos(phase) + self.offset
        return value


def encoder_difference(log: EncoderLog) -> Array:
    """Return Delta al = al_enc - int (w_z - bias) dt, (n,) rad: the encoder against the gyro; rins (6)-(7).

    The integral starts from the first encoder angle. The bias, gyro drift and earth rate together, is what
    grows with time beside the first harmonic. Where both directions take equal times it is the mean of both
    rates in (7); it needs neither whole periods nor instants of reversal.

    Raises UsageError as `fit_encoder` does.
    """
    check_log(log)
    difference = np.concatenate([[0.0], np.cumsum(encoder_steps(log) - gyro_steps(log))])
    elapsed = log.time_s - log.time_s[0]
    growth = elapsed / elapsed[-1]
    rows = np.column_stack([_rows(log.encoder_rad, ENCODER_ORDER), growth])
    solution, _ = _least_squares(log, rows, difference)
    flat: Array = difference - solution[-1] * growth
    return flat


def fit_encoder(log: EncoderLog) -> Harmonic:
    """Return A, B, C of the encoder error A sin al + B cos al + C, in rad; rins (13)-(14).

    C depends on where the gyro's integral starts: it is a constant azimuth, which alignment has to settle.

    Raises UsageError for columns of unlike length, numbers that are not finite, fewer rows than unknowns, times
    that do not increase or are uneven, less than a full turn, an encoder that does not go with the gyro, and
    angles that do not determine the harmonic.
    """
    return _fit(log, log.encoder_rad, ENCODER_ORDER, encoder_difference(log))


def corrected_angle(log: EncoderLog, encoder: Harmonic | None) -> Array:
    """Return al - (A sin al + B cos al + C), (n,) rad, or al where there is no `encoder` fit; rins (15)."""
    angle = np.asarray(log.encoder_rad, dtype=np.float64)
    return angle if encoder is None else angle - encoder.at(angle)


def averaged(log: EncoderLog, seconds: float) -> EncoderLog:
    """Return the log with each encoder angle the mean over the `seconds` around it, to see below its pulses.

    The encoder is averaged against the gyro, Delta al of (7), which bridges the turning and its reversals. The
    window is centred, so that nothing lags, but for half of it at both ends of the log, where it stands still. The
    angle comes out counted through. Raises UsageError as `fit_encoder` does, or for a window that is not positive.
    """
    if not 0 < seconds < np.inf:
        raise UsageError(f"{log.source}: a window of {seconds:g} s holds no row, give a positive time")
    difference = encoder_difference(log)
    turned = log.encoder_rad[0] + np.concatenate([[0.0], np.cumsum(encoder_steps(log))])
    rows, step = difference.size, float(np.median(np.diff(log.time_s)))
    window = min(2 * int(seconds / (2 * step)) + 1, rows)
    total = np.concatenate([[0.0], np.cumsum(difference)])
    mean = (total[window:] - total[:-window]) / window
    nearest = np.clip(np.arange(rows) - window // 2, 0, rows - window)
    return replace(log, encoder_rad=turned - difference + mean[nearest])


def level(log: EncoderLog, encoder: Harmonic | None = None) -> tuple[float, float]:
    """Return pitch and roll (ZXY, right-forward-up) in rad of the standing body, from the mean force in b; rins (2).

    Over whole turns the mean is free of accelerometer biases (3) and of the second harmonic of the tilt.
    Raises UsageError as `fit_tilt` does.
    """
    check_log(log)
    angle = corrected_angle(log, encoder)
    x, y, z = (np.asarray(axis, dtype=np.float64) for axis in np.transpose(log.force_m_s2))
    sine, cosine = np.sin(angle), np.cos(angle)
    right, forward, up = (float(np.mean(each)) for each in (cosine * x - sine * y, sine * x + cosine * y, z))
    gravity = float(np.linalg.norm([right, forward, up]))
    if not up > 0.5 * gravity:
        raise UsageError(
            f"{log.source}: the mean specific force is {up:g} of {gravity:g} m/s2 along z, tilt is read against "
            f"gravity, give specific force, +9.8 m/s2 along the upright axis at rest"
        )
    return float(np.arcsin(forward / gravity)), float(np.arctan2(-right, up))


def fit_tilt(
    log: EncoderLog, encoder: Harmonic | None = None, pitch_roll_rad: tuple[float, float] | None = None
) -> tuple[Harmonic, Harmonic]:
    """Return delta_x and delta_y, the tilt of s against s', as A2 sin 2al + B2 cos 2al + C2 in rad; rins (8)-(9), (16).

    `encoder` corrects the angle; `pitch_roll_rad` is the body's pitch and roll of the alignment, by default
    `level` of the log. f_s' is gravity projected through them and df = f_s - f_s' = -delta x f_s'; the g of (9) is
    the z component of f_s', the same for a level body.

    C2 is a constant tilt and an accelerometer bias in one (5 ug pass for 1 arcsec): no log tells them apart. Where
    the bias is the larger part, use the fit with `offset` replaced by zero.

    Raises UsageError for what `fit_encoder` raises it, or where gravity is not along z.
    """
    from_mean = level(log, encoder)
    pitch, roll = from_mean if pitch_roll_rad is None else pitch_roll_rad
    angle = corrected_angle(log, encoder)
    gravity = float(np.mean(np.linalg.norm(log.force_m_s2, axis=1)))
    right, forward, up = -np.cos(pitch) * np.sin(roll), np.sin(pitch), np.cos(pitch) * np.cos(roll)
    df_x = log.force_m_s2[:, 0] - gravity * (np.cos(angle) * right + np.sin(angle) * forward)
    df_y = log.force_m_s2[:, 1] - gravity * (np.cos(angle) * forward - np.sin(angle) * right)
    delta_x, delta_y = df_y / (gravity * up), -df_x / (gravity * up)
    return _fit(log, angle, TILT_ORDER, delta_x), _fit(log, angle, TILT_ORDER, delta_y)


def correct(log: EncoderLog, encoder: Harmonic | None = None, tilt: tuple[Harmonic, Harmonic] | None = None) -> Array:
    """Return the attitude of the body (n, 4), C_b^n = C_s^n C_{s'}^s C_b^{s'}(al_corrected); rins (4), (10), (15).

    Without `encoder` or `tilt` that correction is left out; without both it is rins (4).
    Raises UsageError for columns of unlike length, numbers that are not finite, or a log without `q_ns`.
    """
    check_columns(log)
    if log.q_ns is None:
        raise UsageError(
            f"{log.source}: no attitude of the sensor frame, the body's attitude is taken from it, give q_ns"
        )
    angle = corrected_angle(log, encoder)
    delta_x, delta_y = (each.at(angle) for each in tilt) if tilt else (np.zeros_like(angle), np.zeros_like(angle))
    return body_attitude(log.q_ns, angle, delta_x, delta_y)


def body_attitude(q_ns: Array, angle_rad: Array, delta_x_rad: Array, delta_y_rad: Array) -> Array:
    """Return the attitude of the body (n, 4) of that of the sensors `q_ns` (n, 4), angle and tilts (n,) rad.

    C_{s'}^s = Ry(delta_y)^T Rx(delta_x)^T and C_b^{s'} = Rz(al)^T as quaternions; rins (5), (10), (11). For small
    tilts C_{s'}^s is I - [delta x], rins (12).
    """
    tilted = product(_turn_back(delta_y_rad, axis=1), _turn_back(delta_x_rad, axis=0))
    return product(product(q_ns, tilted), _turn_back(angle_rad, axis=2))


def _turn_back(angle: Array, axis: int) -> Array:
    """Return the quaternion (n, 4) of a rotation by -`angle` (n,) rad about a coordinate axis."""
    half = 0.5 * np.asarray(angle, dtype=np.float64)
    q = np.zeros((half.size, 4))
    q[:, 0], q[:, 1 + axis] = np.cos(half), -np.sin(half)
    return q


def _rows(angle: Array, order: int) -> Array:
    """Return the rows [sin, cos, 1] of the measurement equations, (n, 3); rins (14)."""
    phase = order * np.asarray(angle, dtype=np.float64)
    return np.column_stack([np.sin(phase), np.cos(phase), np.ones_like(phase)])


def _fit(log: EncoderLog, angle: Array, order: int, values: Array) -> Harmonic:
    (sine, cosine, offset), residual = _least_squares(log, _rows(angle, order), values)
    return Harmonic(float(sine), float(cosine), float(offset), order, residual)


def _least_squares(log: EncoderLog, rows: Array, values: Array) -> tuple[Array, float]:
    """Return the coefficients and the rms residual in rad; refuse rows that leave a coefficient undetermined."""
    lengths = np.linalg.norm(rows, axis=0)
    singular = np.linalg.svd(rows / np.where(lengths > 0, lengths, 1.0), compute_uv=False)
    if singular[-1] < SMALLEST_SINGULAR_VALUE * singular[0]:
        raise UsageError(
            f"{log.source}: the fit is singular, the encoder angles are too alike to tell its {rows.shape[1]} "
            f"unknowns apart, record more angles of the turn"
        )
    solution = np.asarray(np.linalg.lstsq(rows, values, rcond=None)[0], dtype=np.float64)
    return solution, float(np.sqrt(np.mean((values - rows @ solution) ** 2)))
