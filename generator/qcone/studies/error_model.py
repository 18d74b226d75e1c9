"""The additive quaternion error model of thesis2008: predicted attitude error beside the simulated one.

The unit computes q^ from what its gyros and its navigation computer give, w^ = w + dw and w_in^ = w_in + dw_in, where
the true attitude q follows w and w_in (rad/s; body rate against inertial space in body axes, rate of the
navigation frame in its own):

    q' = 1/2 q (x) w - 1/2 w_in (x) q,   dq = q^ - q                                       (thesis2008; cao (6))
    dq' = 1/2 dq (x) w^ - 1/2 w_in^ (x) dq + 1/2 q^ (x) dw - 1/2 dw_in (x) q^              (linear)
          - 1/2 dq (x) dw + 1/2 dw_in (x) dq                                               (products)

It is driven by the attitude computer's output, the measured rates and the frame rate, as the thesis says. With
the products of two errors it is exact at any size. The additive linear model leaves them out, and takes the scale
error of the measured rate, dw = b + k w^: so it keeps a misalignment alone at any size, and stops holding with the
size of the rate errors, or of the misalignment where both are there. What it leaves out is of second order.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from qcone.errors import UsageError
from qcone.reference.kinematics import integrate
from qcone.reference.motions import Motion, thesis_coning
from qcone.reference.quaternion import Array, from_rotation_vector, navigation_error, product

Row = dict[str, object]
Vector = tuple[float, float, float]

HOLDS_WITHIN = 0.01  # of the simulated dq
STEP = 2.5e-3  # s, of the error equation at most; a step takes its coefficients at both ends and the middle
FASTEST_HZ = 25.0
"""The fastest motion of thesis2008."""

EARTH_RATE = 7.292115e-5  # rad/s
LATITUDE = float(np.deg2rad(45.0))
FRAME_RATE: Vector = (0.0, EARTH_RATE * float(np.cos(LATITUDE)), EARTH_RATE * float(np.sin(LATITUDE)))
"""Rate of the east-north-up frame against inertial space at 45 deg of latitude, at rest, in rad/s."""
AXIS: Vector = (2 / 3, -1 / 3, 2 / 3)


@dataclass(frozen=True)
class ErrorCase:
    """Errors of a unit: gyro `bias` (rad/s, body axes), gyro `scale` error (0.01 = 1 %), initial `misalignment`.

    The misalignment is a rotation vector in rad, navigation axes: q^(0) = exp(misalignment) (x) q(0). `frame` is
    the error of the navigation-frame rate, rad/s, navigation axes. `size` is how large the case is, in `unit`.
    """

    name: str
    size: float
    unit: str
    bias: Vector = (0.0, 0.0, 0.0)
    scale: float = 0.0
    misalignment: Vector = (0.0, 0.0, 0.0)
    frame: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Propagation:
    """The end of a run: the error quaternion dq (4,) and the attitude error (3,) in rad, navigation axes."""

    dq: Array
    error: Array


def standard_cases() -> tuple[ErrorCase, ...]:
    """Return the cases of the study, small to large: each error alone, then misalignment beside a bias.

    The smallest bias is 0.58 deg/h, the smallest scale error 10 ppm, the smallest misalignment 1 mrad; the
    largest are far beyond any unit, to show where the model ends.
    """
    cases = [ErrorCase("gyro bias", size, "rad/s", bias=_along(size)) for size in (2.8e-6, 1e-4, 1e-3, 1e-2, 1e-1)]
    cases += [ErrorCase("scale error", size, "1", scale=size) for size in (1e-5, 1e-3, 1e-2, 1e-1)]
    cases += [ErrorCase("misalignment", size, "rad", misalignment=_along(size)) for size in (1e-3, 0.1, 1.0, 2.5)]
    cases += [ErrorCase("frame rate error", size, "rad/s", frame=_along(size)) for size in (1e-6, 1e-2)]
    beside = _along(5e-3)
    cases += [
        ErrorCase("misalignment, 5 mrad/s bias", size, "rad", bias=beside, misalignment=_across(size))
        for size in (1e-3, 0.1, 1.0)
    ]
    return tuple(cases)


def coning(frequency_hz: float) -> Motion:
    """Return ten seconds of thesis2008's coning. Raises UsageError for a frequency its rate sampling cannot follow."""
    if not 0 < frequency_hz <= FASTEST_HZ:
        raise UsageError(
            f"--frequency-hz {frequency_hz:g}: steps of {1000 * STEP:g} ms follow a motion of up to {FASTEST_HZ:g} Hz; "
            f"give more than 0 and at most {FASTEST_HZ:g}"
        )
    return thesis_coning(frequency_hz)


def error_rows(
    motion: Motion | None = None, cases: Iterable[ErrorCase] | None = None, frame_rate: Vector = FRAME_RATE
) -> list[Row]:
    """Return a row for every case at the end of `motion`, by default thesis2008's coning at 2.5 Hz over 10 s.

    Keys: case, motion, size, unit; predicted, simulated (attitude error of the linear model and of the simulation,
    rad) and their ratio; deviation (|dq predicted - dq simulated| / |dq simulated|), with_products (the same with the
    products kept), holds (deviation at most 1 %), paper, reason. The motion's rate is against inertial space.

    Raises UsageError for a case without any error or whose error the motion does not bring out, with numbers that
    are not finite, or a scale error of -1 or less.
    """
    chosen = thesis_coning(2.5) if motion is None else motion
    rows: list[Row] = []
    for case in standard_cases() if cases is None else cases:
        _check(case)
        simulated = simulate(chosen, case, frame_rate)
        if not np.any(simulated.dq):
            raise UsageError(
                f"{case.name}: motion {chosen.name} brings out no attitude error, a ratio needs one, give a motion "
                f"that turns"
            )
        linear = predict(chosen, case, frame_rate)
        whole = predict(chosen, case, frame_rate, products=True)
        predicted, actual = (float(np.linalg.norm(each.error)) for each in (linear, simulated))
        deviation, with_products = _deviation(linear, simulated), _deviation(whole, simulated)
        left_out = "the linear model leaves out products of errors; with them it holds"
        rows.append(
            {
                "case": case.name,
                "motion": chosen.name,
                "size": case.size,
                "unit": case.unit,
                "predicted": predicted,
                "simulated": actual,
                "ratio": predicted / actual,
                "deviation": deviation,
                "with_products": with_products,
                "holds": deviation <= HOLDS_WITHIN,
                "paper": "thesis2008",
                "reason": "" if deviation <= HOLDS_WITHIN else left_out,
            }
        )
    return rows


def simulate(motion: Motion, case: ErrorCase, frame_rate: Vector = FRAME_RATE) -> Propagation:
    """Return the error at the end of `motion`, from true and erroneous rates integrated to float64 precision."""
    times, computed = _computed(motion, case, frame_rate)
    q_true, q_computed = product(_frame_turn(times[-1:], frame_rate), motion.attitude(times[-1:]))[0], computed[-1]
    return Propagation(q_computed - q_true, navigation_error(q_computed, q_true))


def predict(motion: Motion, case: ErrorCase, frame_rate: Vector = FRAME_RATE, *, products: bool = False) -> Propagation:
    """Return the error at the end of `motion` by the additive model, linear or with the `products` of errors.

    It sees what a unit has: its computed attitude, its measured rates, and the errors it is asked about; the true
    attitude enters at t = 0 only. Classical Runge-Kutta steps of 2.5 ms at most.
    """
    times, computed = _computed(motion, case, frame_rate)
    bias, frame_error = np.array(case.bias), np.array(case.frame)
    measured = (1 + case.scale) * motion.rate(times) + bias
    measured_frame = np.array(frame_rate) + frame_error
    if products:
        gyro_error = measured - (measured - bias) / (1 + case.scale)
        turning = _right(_half(measured - gyro_error)) - _left(_half(measured_frame - frame_error))
    else:
        gyro_error = bias + case.scale * measured
        turning = _right(_half(measured)) - _left(_half(measured_frame))
    driven = product(computed, _half(gyro_error)) - product(_half(frame_error), computed)
    dq = computed[0] - motion.attitude(times[:1])[0]
    for carried, added in zip(*_runge_kutta(turning, driven, float(times[2])), strict=True):
        dq = carried @ dq + added
    return Propagation(dq, navigation_error(computed[-1], computed[-1] - dq))


def _runge_kutta(turning: Array, driven: Array, step: float) -> tuple[Array, Array]:
    """Return M (n, 4, 4) and g (n, 4) of dq_{k+1} = M_k dq_k + g_k, one classical step of dq' = turning dq + driven.

    `turning` (2 n + 1, 4, 4) and `driven` (2 n + 1, 4) stand at the ends and middles of the steps, in 1/s. A stage
    is affine in dq as well: columns 0..3 multiply it, column 4 is added.
    """
    slope = np.concatenate([turning, driven[..., np.newaxis]], axis=-1)
    begin, middle, end = slope[:-1:2], slope[1::2], slope[2::2]
    start = np.eye(4, 5)

    def at(here: Array, dq: Array) -> Array:
        stage: Array = here[..., :4] @ dq
        stage[..., 4] += here[..., 4]
        return stage

    first = at(begin, start)
    second = at(middle, start + step / 2 * first)
    third = at(middle, start + step / 2 * second)
    fourth = at(end, start + step * third)
    after = start + step / 6 * (first + 2 * second + 2 * third + fourth)
    return after[..., :4], after[..., 4]


@lru_cache(maxsize=1)  # one case is simulated, and predicted twice
def _computed(motion: Motion, case: ErrorCase, frame_rate: Vector) -> tuple[Array, Array]:
    """Return times (2 steps + 1,) s and the attitude a unit with these errors computes, without error of its own."""
    times = np.linspace(0.0, motion.duration, 2 * int(np.ceil(motion.duration / STEP)) + 1)
    bias = np.array(case.bias)

    def rate(t: Array) -> Array:
        wrong: Array = (1 + case.scale) * motion.rate(t) + bias
        return wrong

    def increments(t: Array) -> Array:
        wrong: Array = (1 + case.scale) * motion.increments(t) + np.outer(np.diff(t), bias)
        return wrong

    start = product(from_rotation_vector(np.array(case.misalignment)), motion.attitude(times[:1])[0])
    measured_frame = np.array(frame_rate) + np.array(case.frame)
    return times, product(_frame_turn(times, measured_frame), integrate(rate, increments, times, start))


def _frame_turn(times: Array, frame_rate: Vector | Array) -> Array:
    """Return exp(-w_in t / 2), (n, 4): from the navigation frame at t = 0 to the one at t."""
    return from_rotation_vector(np.outer(-times, frame_rate))


def _half(rate: Array) -> Array:
    """Return half the rates (..., 3) as pure quaternions (..., 4)."""
    return 0.5 * np.concatenate([np.zeros_like(rate[..., :1]), rate], axis=-1)


def _left(q: Array) -> Array:
    """Return the matrix (..., 4, 4) of p -> q (x) p."""
    return np.stack([product(q, unit) for unit in np.eye(4)], axis=-1)


def _right(q: Array) -> Array:
    """Return the matrix (..., 4, 4) of p -> p (x) q."""
    return np.stack([product(unit, q) for unit in np.eye(4)], axis=-1)


def _deviation(predicted: Propagation, simulated: Propagation) -> float:
    return float(np.linalg.norm(predicted.dq - simulated.dq) / np.linalg.norm(simulated.dq))


def _along(size: float) -> Vector:
    return (size * AXIS[0], size * AXIS[1], size * AXIS[2])


def _across(size: float) -> Vector:
    """Return a vector at right angles to that of `_along`: the products of errors then do not commute."""
    return (2 * size / 3, 2 * size / 3, -size / 3)


def _check(case: ErrorCase) -> None:
    values = np.array([*case.bias, case.scale, *case.misalignment, *case.frame])
    if not np.all(np.isfinite(values)):
        raise UsageError(f"{case.name}: an error is not a finite number, nothing can be propagated, give numbers")
    if not np.any(values):
        raise UsageError(f"{case.name}: no error is given, a ratio needs one, give a bias, scale or misalignment")
    if not case.scale > -1:
        raise UsageError(f"{case.name}: scale error {case.scale:g} leaves no rate to measure, give more than -1")
