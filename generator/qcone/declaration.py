"""What a design declares of the sensor, in the units of the routines, and what fixed point may rely on of it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from qcone import sensor
from qcone import stage_routines as stage
from qcone.algorithms import increments
from qcone.design import Design
from qcone.ir.specification import Algorithm
from qcone.passes import declared
from qcone.passes.exponential import Exponential
from qcone.passes.samples import Samples

PI_ABOVE = Fraction(314159265358980, 10**14)
"""A rational just above pi, for declared rates in deg/s."""
ROOT_3_ABOVE = Fraction(173205081, 10**8)
"""A rational just above the square root of 3."""


@dataclass(frozen=True)
class Declaration:
    """What the design declares of the sensor, in the units of the routines.

    `interval` of one update in s; `rate` the largest body rate in rad/s; `increment` the largest angle
    increment of one sub-sample in rad: bounds of Euclidean norms, rounded up.
    """

    interval: Fraction
    rate: Fraction
    increment: Fraction
    limit: Fraction
    """What each component handed in is limited to, in its unit, where the design clamps inputs."""
    correction: Fraction | None = None
    """The largest correction of a rotating unit, rad; None without that stage."""


def declaration(design: Design, algorithm: Algorithm) -> Declaration:
    """Return the declared ranges: |omega| <= max_rate and |theta| <= max_rate / (N update_hz)."""
    interval = 1 / design.imu.update_hz
    rate = round_up(design.imu.max_rate_dps * PI_ABOVE / 180, 8)
    if design.input == "rate":
        increment = increments.gain(algorithm.subsamples, design.increments) * interval * rate
    else:
        increment = rate * interval / algorithm.subsamples
    limit = rate if design.input == "rate" else increment
    if design.number.clamp_inputs:
        # Each component is limited by itself: the corner of that cube is sqrt(3) away.
        rate, increment = rate * ROOT_3_ABOVE, increment * ROOT_3_ABOVE
    correction = round_up(design.rins.max_correction_arcsec * PI_ABOVE / 648000, 8) if design.rins else None
    return Declaration(interval, round_up(rate, 8), round_up(increment, 8), round_up(limit, 8), correction)


def in_fixed_point(
    design: Design, algorithm: Algorithm, known: Declaration, exponential: Exponential | None
) -> declared.Declaration:
    """Return what fixed point may rely on: norms of what is handed in, its differences in time, the rotation vector."""
    inputs = {
        "dtheta": known.increment,
        "previous": known.increment,
        "omega": known.rate,
        "omega_last": known.rate,
    }
    turn = exponential.phi_max if exponential else None
    whole: dict[str, Fraction] = {}
    if design.input == "counts":
        whole["counts"] = Fraction(sensor.largest_count(design))
        inputs["dtheta"] = known.increment
    unlimited = frozenset({"dtheta", "omega"} if design.number.clamp_inputs else ())
    renormalised = design.renormalise == "every"
    series = _series_error(algorithm, known, exponential)
    samples = _samples(design, algorithm, known)
    bounded = stage.bounds(known.correction) if known.correction is not None else {}
    return declared.Declaration(
        inputs, samples, turn, whole, unlimited, bounded, renormalised, series, design.number.pins
    )


def _series_error(algorithm: Algorithm, known: Declaration, exponential: Exponential | None) -> Fraction | None:
    """Return how far the rotation of one update, as a series, is from a unit quaternion."""
    if exponential is not None:
        return exponential.scalar_error + exponential.vector_error
    if algorithm.truncation is not None:
        return sum(algorithm.truncation(known.increment), Fraction(0))
    return None


def _samples(design: Design, algorithm: Algorithm, known: Declaration) -> Samples:
    """Return how far samples that follow one another may be apart: by the angular acceleration and jerk declared."""
    n, rates = algorithm.subsamples, design.input == "rate"
    spacing = known.interval / n
    largest, name = (known.rate, "omega") if rates else (known.increment, "dtheta")
    at = {(name, 3 * k + axis): (axis, k) for k in range(n) for axis in range(3)}
    at |= {("omega_last", axis): (axis, -1) for axis in range(3)}
    if not rates:
        at |= {("previous", 3 * k + axis): (axis, -1 - k) for k in range(algorithm.previous) for axis in range(3)}
    unit = spacing * (1 if rates else spacing)

    def bound(declared: Fraction | None, scale: Fraction) -> Fraction | None:
        return None if declared is None else round_up(declared * PI_ABOVE / 180 * scale, 8)

    if design.input == "counts":
        at = {}
    acceleration, jerk = design.imu.max_angular_acceleration_dps2, design.imu.max_jerk_dps3
    return Samples(largest, bound(acceleration, unit), bound(jerk, unit * spacing), at)


def round_up(value: Fraction, digits: int) -> Fraction:
    """Return `value` rounded up to that many significant decimal digits."""
    scale = Fraction(1)
    while value * scale < 10 ** (digits - 1):
        scale *= 10
    while value * scale >= 10**digits:
        scale /= 10
    return Fraction(-((-value * scale).__floor__())) / scale
