"""Euler angles integrated by the classical Runge-Kutta method, cao: the baseline that locks at a pitch of 90 degrees.

zyx: roll' = wx + tan(pitch) (wy sin(roll) + wz cos(roll)), pitch' = wy cos(roll) - wz sin(roll),
     yaw' = (wy sin(roll) + wz cos(roll)) / cos(pitch)
It is here to be compared with, not to be flown. At the pole the rates have no bound: there one change is cut at half a
turn, so that what comes out is a wrong attitude, as the method gives it, and not a number without meaning.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from qcone.algorithms.family import Choice, Family
from qcone.algorithms.outputs import wrapped
from qcone.ir.real import (
    PI,
    Algorithm,
    F,
    Scalar,
    Source,
    Vector,
    algorithm,
    heading,
    less,
    number,
    select,
    sine_cosine,
    step,
    vector,
)

SOURCE = Source("cao", "introduction; kinematics of roll, pitch, yaw")
SMALLEST_COSINE = F(1, 2**60)
"""Stands for a cosine of the pitch that is zero; any other is larger in every format."""


def euler_angles() -> Algorithm:
    """Return the method; one update takes the rates at its start, middle and end."""

    @algorithm(
        "euler-angles", source=SOURCE, subsamples=2, order=4, takes="omega", state="euler",
        summary="Runge-Kutta on roll' = wx + tan(pitch) (wy sin(roll) + wz cos(roll)), ...",
    )  # fmt: skip
    def locks(rpy: Vector, omega: Sequence[Vector], interval: Fraction) -> Any:
        start, middle, end = omega
        half, h = F(1, 2), interval
        k1 = _slope("k1", rpy, start)
        k2 = _slope("k2", rpy + _cut((half * h) * k1), middle)
        k3 = _slope("k3", rpy + _cut((half * h) * k2), middle)
        k4 = _slope("k4", rpy + _cut(h * k3), end)
        change = step("change = h/6 (k1 + k4) + h/3 (k2 + k3)", "", (h / 6) * (k1 + k4) + (h / 3) * (k2 + k3))
        roll, pitch, yaw = rpy + _cut(change)
        text = "rpy_next = rpy + change, each in [-pi, pi]"
        return step(text, "", vector(wrapped(roll), wrapped(pitch), wrapped(yaw)))

    return locks


def _slope(name: str, angles: Vector, omega: Vector) -> Vector:
    roll, pitch, _ = angles
    x, y, z = omega
    heading(f"rates and angles for {name}", "", angles)
    (sr, cr), (sp, cp) = sine_cosine(roll), sine_cosine(pitch)
    cp = select(less(cp * cp, SMALLEST_COSINE**2), SMALLEST_COSINE, cp)
    around = (y * sr + z * cr) / cp
    return step(f"{name} = (roll', pitch', yaw')", "zyx kinematics", vector(x + sp * around, y * cr - z * sr, around))


def _cut(change: Vector) -> Vector:
    """Write a change of angles, each at most half a turn in size."""
    x, y, z = (_at_most_half_a_turn(each) for each in change)
    return vector(x, y, z)


def _at_most_half_a_turn(angle: Scalar) -> Scalar:
    angle = select(less(number(PI, angle), angle), PI, angle)
    return select(less(angle, -PI), -PI, angle)


FAMILY = Family(
    id="euler-angles",
    title="Euler angles by Runge-Kutta, the baseline that locks at 90 degrees of pitch",
    source=SOURCE,
    parameters=tuple[Choice, ...](),
    make=lambda values: euler_angles(),
    examples=({},),
)
