"""cao figure 1 on a stated motion: the paper gives none."""

from __future__ import annotations

import numpy as np

from qcone.reference.euler import to_angles
from qcone.reference.kinematics import IDENTITY
from qcone.studies.claims.claim import Settings
from qcone.studies.curves.figure import Curve, Figure, Panel
from qcone.studies.sampled import MANOEUVRE, MANOEUVRE_DPS, algorithm
from qcone.studies.simulating import run

ANGLES = ("roll", "pitch", "yaw")
SMALLEST = 0.01
"""Angles in rad below which a relative error is not drawn: it is undefined at 0."""


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


FIGURES = (relative_errors,)
