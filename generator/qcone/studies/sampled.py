"""Errors of the compiled C on sampled motions: the coning and the manoeuvre of xu2019, ideal or quantised.

The attitude is normalised before angles are taken. Coning errors are the largest of pitch, roll and yaw (ZXY, as the
paper's axes want it) over 60 s; those of the manoeuvre the angle between attitudes over 1.2 s.
"""

from __future__ import annotations

from functools import cache
from math import pi

import numpy as np

from qcone.reference.euler import to_angles
from qcone.reference.kinematics import IDENTITY
from qcone.reference.motions import Motion, coning, large_angle_manoeuvre
from qcone.reference.quaternion import Array, error_angle, normalise
from qcone.studies.simulating import Options, options, run

QUANTUM = pi / 180 / 3600
"""One pulse of the quantised gyro: 1 arcsec, in rad."""

CONING, MANOEUVRE = coning(), large_angle_manoeuvre()
CONING_DPS, MANOEUVRE_DPS = 80, 900
"""Declared rates in deg/s: the motions reach 63 and 790; a pulse more is covered."""

Angles = tuple[float, float, float]


def algorithm(name: str, n: int, slowest_hz: float, max_rate_dps: float, **words: object) -> Options:
    """Return an algorithm of `n` sub-samples whose declared range covers sub-samples at `slowest_hz` and faster.

    The state is compensated: what a minute at 1 kHz rounds would else be a tenth of the best errors of xu2019.
    """
    update_hz = f"{slowest_hz / n:.9f}"
    given = {"accumulate": "compensated", "max_rate_dps": max_rate_dps, "update_hz": update_hz, **words}
    return options(name, subsamples=n, **given)


@cache
def coning_errors(words: Options, n: int, rate_hz: float, quantised: bool = False) -> Angles:
    """Return the largest errors of pitch, roll and yaw in rad over 60 s of sub-samples at `rate_hz`."""
    times = _times(CONING.duration, n, rate_hz)
    dtheta, true = _sampled_coning(n, rate_hz, quantised)
    q = run(words, CONING.attitude(times[:1]), dtheta[np.newaxis])["quaternion"][0]
    error = to_angles(normalise(q), "zxy") - true
    roll, pitch, yaw = np.abs(np.mod(error + np.pi, 2 * np.pi) - np.pi).max(axis=0).tolist()
    return pitch, roll, yaw


@cache
def manoeuvre_track(words: Options, n: int, rate_hz: float, quantised: bool = False) -> tuple[Array, Array]:
    """Return the ends of the updates (k,) in s and the attitude error (k,) in rad, sub-samples at `rate_hz`."""
    times = _times(MANOEUVRE.duration, n, rate_hz)
    dtheta = MANOEUVRE.increments(times)
    if quantised:
        dtheta = floored(dtheta)
    q = run(words, IDENTITY[np.newaxis], dtheta.reshape(1, -1, n, 3))["quaternion"][0]
    ends = times[n::n]
    return ends, error_angle(q, MANOEUVRE.attitude(ends))


def manoeuvre_error(words: Options, n: int, rate_hz: float, quantised: bool = False) -> float:
    """Return the largest attitude error in rad over the 1.2 s of the manoeuvre."""
    return float(manoeuvre_track(words, n, rate_hz, quantised)[1].max())


def rounded(dtheta: Array, angle: Array) -> Array:
    """Return increments (n, 3) as a counter of pulses gives them that rounds; `angle` (3,) rad is its start."""
    return _pulses(dtheta, angle, np.rint)


def floored(dtheta: Array) -> Array:
    """Return increments (n, 3) as a counter of whole pulses gives them, from 0."""
    return _pulses(dtheta, np.zeros(3), np.floor)


def _pulses(dtheta: Array, angle: Array, whole: np.ufunc) -> Array:
    """Quantise the running angle and take differences: what a pulse leaves is carried to the next."""
    running = angle + np.concatenate([np.zeros((1, 3)), np.cumsum(dtheta, axis=0)])
    counted: Array = QUANTUM * np.diff(whole(running / QUANTUM), axis=0)
    return counted


def _times(duration: float, n: int, rate_hz: float) -> Array:
    updates = int(duration * rate_hz / n * (1 + 1e-12))
    times: Array = np.arange(updates * n + 1) / rate_hz
    return times


@cache
def _sampled_coning(n: int, rate_hz: float, quantised: bool) -> tuple[Array, Array]:
    """Return the increments (updates, N, 3) in rad and the true roll, pitch, yaw (updates, 3) at the ends."""
    times = _times(CONING.duration, n, rate_hz)
    dtheta = CONING.increments(times)
    if quantised:
        dtheta = rounded(dtheta, _starting_angle(CONING))
    return dtheta.reshape(-1, n, 3), to_angles(CONING.attitude(times[n::n]), "zxy")


def _starting_angle(motion: Motion) -> Array:
    """Return the antiderivative of the rate at t = 0, as xu2019 writes the cumulative angle of coning, rad."""
    angle = np.zeros(3)
    for term in motion.sinusoids:
        angle -= np.array(term.sine) / (2 * np.pi * term.frequency)
    return angle
