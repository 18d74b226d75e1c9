"""A simulated inertial unit that turns to and fro on its vertical axis, and the corrections of its attitude; rins.

East-north-up navigation frame; body frame right-forward-up, at rest. The sensor frame is the body frame turned by the
angle alpha about its z axis, and then tilted by the axis that does not stand still: C_s's = Ry(tilt_y)^T Rx(tilt_x)^T.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from qcone.reference.euler import from_angles
from qcone.reference.quaternion import Array, conjugate, from_rotation_vector, product, to_matrix, to_rotation_vector

Readout = Literal["ideal", "raw", "x4", "averaged"]
Harmonics = tuple[tuple[int, float, float], ...]  # (k, a, b) of a sin(k alpha) + b cos(k alpha), in rad

ARCSEC = float(np.deg2rad(1 / 3600))
DURATION = 4200.0  # s: four periods, each one turn forward and one back
PERIOD = 1050.0  # s
PULSES = 20000  # a turn
AVERAGED = 10.0  # s
EARTH_RATE = 7.292115e-5  # rad/s
GRAVITY = 9.80665  # m/s^2


@dataclass(frozen=True)
class Imperfections:
    """What is wrong with a unit: angles in rad, rates in rad/s, specific force in m/s^2; noise is rms and white.

    The defaults are the unit of the paper: 1..2 arcmin once a turn in the encoder, 30 arcsec twice a turn in the tilt.
    """

    encoder: Harmonics = (
        (1, 54 * ARCSEC, -51 * ARCSEC),
        (2, 4 * ARCSEC, 0.0),
        (3, 0.0, 3 * ARCSEC),
    )
    encoder_offset: float = 18 * ARCSEC
    encoder_noise: float = 1 * ARCSEC
    tilt_x: Harmonics = ((2, 13.6 * ARCSEC, 0.0), (3, 0.0, 1 * ARCSEC))
    tilt_y: Harmonics = ((2, 0.0, 13.6 * ARCSEC), (3, 0.0, 1 * ARCSEC))
    gyro_drift: tuple[float, float, float] = (5e-8, -4e-8, 6e-8)  # about 0.01 deg/h
    gyro_noise: float = 0.0
    accelerometer_bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    accelerometer_noise: float = 20e-6 * GRAVITY


@dataclass(frozen=True)
class Record:
    """What a run of the unit gives at n instants.

    `time` (n,) s; `encoder` (n,) rad, the read-out; `gyro` (n, 3) rad/s, the mean over the sample interval that ends
    at the instant, so that its sum is an angle; `specific_force` (n, 3) m/s^2. And the truth: `angle` (n,) rad, within
    0..2 pi; `tilt` (n, 2) rad; `sensor_attitude` and `body_attitude` (n, 4), to the navigation frame.
    """

    time: Array
    encoder: Array
    gyro: Array
    specific_force: Array
    angle: Array
    tilt: Array
    sensor_attitude: Array
    body_attitude: Array


def simulate(
    readout: Readout = "ideal",
    *,
    seed: int = 0,
    rate_hz: float = 10.0,
    attitude: tuple[float, float, float] = (0.004, -0.003, 0.7),
    latitude: float = 0.7,
    imperfections: Imperfections | None = None,
) -> Record:
    """Return 4200 s of a unit at rest at `attitude` (roll, pitch, yaw in rad, convention zxy), sampled at `rate_hz`.

    `readout` of the encoder: `ideal`, `raw` (rounded to 20000 pulses a turn), `x4` (to a quarter of a pulse) or
    `averaged` (`raw`, its error averaged over the last 10 s, as a gyro that bridges ten seconds allows). The unit has
    been turning before t = 0, so the average has a past. The same `seed` gives the same record; the noises do not
    depend on `readout`. `latitude` in rad. Raises ValueError for another `readout`, and for a `rate_hz` that does not
    put a sample on every reversal.
    """
    if readout not in ("ideal", "raw", "x4", "averaged"):
        raise ValueError(f"readout is {readout!r}, choose ideal, raw, x4 or averaged")
    if rate_hz <= 0 or (rate_hz * PERIOD / 2) % 1:
        raise ValueError(f"rate_hz is {rate_hz}, half a period of {PERIOD / 2} s must hold whole samples")
    unit = Imperfections() if imperfections is None else imperfections
    past = max(round(AVERAGED * rate_hz), 1)
    time = np.arange(-past, round(DURATION * rate_hz) + 1) / rate_hz
    random = np.random.default_rng(seed)
    encoder_noise = unit.encoder_noise * random.standard_normal(len(time))
    gyro_noise = unit.gyro_noise * random.standard_normal((len(time), 3))
    force_noise = unit.accelerometer_noise * random.standard_normal((len(time), 3))

    angle = true_angle(time)
    tilt = np.stack([_periodic(unit.tilt_x, angle), _periodic(unit.tilt_y, angle)], axis=-1)
    body = np.broadcast_to(from_angles(np.array(attitude), "zxy"), (len(time), 4))
    sensor = product(body, sensor_turn(angle, tilt))
    earth = EARTH_RATE * np.array([0.0, np.cos(latitude), np.sin(latitude)])
    inertial = product(from_rotation_vector(np.outer(time, earth)), sensor)
    # The sensor turns by arcseconds off one axis within a sample: the rotation vector is the integral of the rate.
    turned = to_rotation_vector(product(conjugate(inertial[:-1]), inertial[1:]))
    gyro = np.concatenate([turned[:1], turned]) * rate_hz + np.array(unit.gyro_drift) + gyro_noise
    up = np.swapaxes(to_matrix(sensor), -1, -2) @ np.array([0.0, 0.0, GRAVITY])
    force = up + np.array(unit.accelerometer_bias) + force_noise
    error = _periodic(unit.encoder, angle) + unit.encoder_offset + encoder_noise
    encoder = _read(angle + error, angle, readout, past)
    columns = (time, encoder, gyro, force, angle, tilt, sensor, body)
    return Record(*(np.ascontiguousarray(column[past:]) for column in columns))


def true_angle(time: Array) -> Array:
    """Return alpha (n,) rad at `time` (n,) s: from 0 up to one turn in half a period, and back down in the other."""
    phase = np.mod(time, PERIOD) / PERIOD
    return 4 * np.pi * np.minimum(phase, 1 - phase)


def sensor_turn(angle: Array, tilt: Array) -> Array:
    """Return q (..., 4) from sensor to body axes, of `angle` (...) and `tilt` (..., 2) in rad; rins (5), (11)."""
    zero = np.zeros_like(angle)
    parts = [
        np.stack([zero, zero, angle], axis=-1),
        np.stack([tilt[..., 0], zero, zero], axis=-1),
        np.stack([zero, tilt[..., 1], zero], axis=-1),
    ]
    z, x, y = (from_rotation_vector(part) for part in parts)
    return product(product(z, x), y)


def corrected_angle(encoder: Array, coefficients: tuple[float, float, float]) -> Array:
    """Return alpha - (A sin alpha + B cos alpha + C), (...) rad, of the read-out `encoder` (...) rad; rins (15)."""
    a, b, c = coefficients
    angle: Array = encoder - (a * np.sin(encoder) + b * np.cos(encoder) + c)
    return angle


def modelled_tilt(angle: Array, coefficients: Array) -> Array:
    """Return the tilt (..., 2) rad, A2 sin 2 alpha + B2 cos 2 alpha + C2, of rows A2, B2, C2 for x and y; rins (16)."""
    twice = 2 * np.asarray(angle, dtype=np.float64)
    tilt: Array = np.stack([np.sin(twice), np.cos(twice), np.ones_like(twice)], axis=-1) @ np.asarray(coefficients).T
    return tilt


def body_attitude(sensor_attitude: Array, angle: Array, tilt: Array) -> Array:
    """Return the attitude (..., 4) of the body from that of the sensors, C_bn = C_sn C_s's C_bs'; rins (4), (10).

    `angle` (...) and `tilt` (..., 2) in rad.
    """
    return product(sensor_attitude, conjugate(sensor_turn(angle, tilt)))


def _periodic(harmonics: Harmonics, angle: Array) -> Array:
    return sum((a * np.sin(k * angle) + b * np.cos(k * angle) for k, a, b in harmonics), np.zeros_like(angle))


def _read(reading: Array, angle: Array, readout: Readout, past: int) -> Array:
    """Return the read-out (n,) rad of the encoder at `reading`, a window of `past` samples before each averaged."""
    if readout == "ideal":
        return reading
    quantum = 2 * np.pi / (4 * PULSES if readout == "x4" else PULSES)
    quantised: Array = quantum * np.rint(reading / quantum)
    if readout != "averaged":
        return quantised
    total = np.concatenate([[0.0], np.cumsum(quantised - angle)])
    averaged = np.array(quantised)
    averaged[past:] = angle[past:] + (total[past + 1 :] - total[1:-past]) / past
    return averaged
