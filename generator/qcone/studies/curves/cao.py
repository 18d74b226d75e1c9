"""cao figure 1 on a stated motion, the paper gives none; and the pole that its introduction warns of."""

from __future__ import annotations

import numpy as np

from qcone.reference.euler import to_angles
from qcone.reference.kinematics import IDENTITY
from qcone.reference.motions import slew
from qcone.reference.quaternion import Array, error_angle
from qcone.studies.claims.claim import Settings
from qcone.studies.curves.figure import Curve, Figure, Panel
from qcone.studies.sampled import MANOEUVRE, MANOEUVRE_DPS, algorithm
from qcone.studies.simulating import options, run

ANGLES = ("roll", "pitch", "yaw")
SMALLEST = 0.01
"""Angles in rad below which a relative error is not drawn: it is undefined at 0."""

SMALLEST_ERROR = 1e-17
"""What stands for no error in rad on a logarithmic axis."""


def relative_errors(settings: Settings) -> Figure:
    """Return figure 1: relative errors of roll, pitch and yaw (ZYX) with three sub-samples, and the angles."""
    rate = 10 * settings.rate_hz
    outputs = "quaternion,euler"
    words = algorithm("rotation-vector", 3, rate, MANOEUVRE_DPS, coefficients="coning", outputs=outputs)
    updates = int(MANOEUVRE.duration * rate / 3 * (1 + 1e-12))
    times = np.arange(3 * updates + 1) / rate
    dtheta = MANOEUVRE.increments(times).reshape(1, -1, 3, 3)
    computed = run(words, IDENTITY[np.newaxis], dtheta)["euler"][0]
    ends = times[3::3]
    true = to_angles(MANOEUVRE.attitude(ends))
    error = np.abs(np.mod(computed - true + np.pi, 2 * np.pi) - np.pi)
    relative = np.where(np.abs(true) > SMALLEST, error / np.maximum(np.abs(true), SMALLEST), np.nan)
    angles = tuple(Curve(name, ends, np.rad2deg(true[:, k]), "-", k) for k, name in enumerate(ANGLES))
    errors = tuple(Curve(name, ends, relative[:, k], "-", k) for k, name in enumerate(ANGLES))
    panels = (
        Panel("true angles", "time, s", "angle, deg", angles),
        Panel(
            "relative error of the C's Euler angles",
            "time, s",
            "|error / angle|",
            errors,
            log_y=True,
            note="cao: errors are small; no motion, rate or scale given",
        ),
    )
    title = f"cao fig. 1 on the large-angle manoeuvre of xu2019, optimised three sub-samples at {rate:g} Hz"
    return Figure("cao_fig1", title, 2, panels)


OVER_THE_POLE = slew((0.0, 1.0, 1e-4))
"""Loops of 1 rad/s that pass the pole, a pitch of 90 degrees, by 20 arcsec: at 1.57, 4.71 and 7.85 s."""

THROUGH_THE_POLE = ("euler-angles", "runge-kutta-4", "rotation-vector")


def over_the_pole(name: str, update_hz: float) -> tuple[Array, Array, Array]:
    """Return ends of updates (k,) in s, attitude errors (k,) in rad and angles (k, 3) in rad, of an algorithm's C."""
    updates = int(OVER_THE_POLE.duration * update_hz * (1 + 1e-12))
    times = np.arange(2 * updates + 1) / (2 * update_hz)
    rates = OVER_THE_POLE.rate(times)
    words: dict[str, object] = {"outputs": "quaternion,euler", "max_rate_dps": 80, "update_hz": f"{update_hz:.9f}"}
    words |= {"subsamples": 2} if name == "rotation-vector" else {}
    start = OVER_THE_POLE.attitude(times[:1])
    outputs = run(options(name, input="rate", **words), start, rates[1:].reshape(1, -1, 2, 3), rates[:1])
    ends = times[2::2]
    return ends, error_angle(outputs["quaternion"][0], OVER_THE_POLE.attitude(ends)), outputs["euler"][0]


def lock(settings: Settings) -> Figure:
    """Return the attitude error of Euler angles integrated over the pole, beside quaternion forms on the same rates."""
    angles, errors = [], []
    for group, name in enumerate(THROUGH_THE_POLE):
        ends, error, computed = over_the_pole(name, settings.rate_hz)
        errors.append(Curve(name, ends, np.maximum(error, SMALLEST_ERROR), "-", group))
        if name != "rotation-vector":
            style = "-" if group else "--"
            angles.append(Curve(f"pitch, {name}", ends, np.rad2deg(computed[:, 1]), style, group))
    panels = (
        Panel("pitch", "time, s", "angle, deg", tuple(angles), note="past the pole three times"),
        Panel(
            "attitude error of the C",
            "time, s",
            "error, rad",
            tuple(errors),
            log_y=True,
            note="cao: Euler angles are not suitable for full-scale attitude",
        ),
    )
    title = f"Euler angles lock at 90 degrees: loops of 1 rad/s past the pole by 20 arcsec, {settings.rate_hz:g} Hz"
    return Figure("cao_lock", title, 2, panels)


FIGURES = (relative_errors, lock)
