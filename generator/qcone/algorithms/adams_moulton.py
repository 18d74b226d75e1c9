"""Adams-Bashforth predictor and Adams-Moulton corrector of fourth order on the attitude quaternion, thesis2008.

As written, f = 1/2 q (x) omega and a step of h. Factored, the step is part of the rates: f = q (x) g, g = h/2 omega,
  p = q + (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24, f_p = p (x) g_new,
  q' = q + (9 f_p + 19 f_0 - 5 f_1 + f_2)/24, and Milne's estimate of its error is -19/270 (q' - p).
The newest rate is the look-ahead: the attitude is valid at its time. f_0 is formed from the state anew in every
update, so that renormalisation and history agree. The thesis starts with Heun's method, which leaves an error of
third order for good; the starter `runge-kutta-4` holds the attitude for two updates and in the third makes three
Runge-Kutta steps, with the rates between samples taken from the cubic through the four samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from qcone.algorithms.family import Choice, Family
from qcone.ir.real import (
    Algorithm,
    Block,
    F,
    Phase,
    Quaternion,
    Role,
    Shape,
    Source,
    Vector,
    algorithm,
    heading,
    increment,
    step,
)

SOURCE = Source("thesis2008", "Adams-Moulton, Milne")
HALF = F(1, 2)
STARTERS = ("runge-kutta-4", "heun")
SLOPES = Block("f", Shape.QUATERNION, Role.STATE, 3, "slopes of the last steps, newest first: h q', as written q'")
ERROR = Block("error", Shape.QUATERNION, Role.STATE, unit="Milne's estimate of the last step's error")
RATES = Block("rates", Shape.VECTOR, Role.STATE, 2, "rates taken while the starter waits, oldest first, rad/s")


def adams_moulton(starter: str) -> Algorithm:
    """Return the method with the starter "heun" (the thesis) or "runge-kutta-4" (the cure)."""
    memory: tuple[Block, ...] = (SLOPES, ERROR)
    phases: tuple[Phase, ...] = (Phase("start_up", 3, _heun, _heun_as_written),)
    if starter != "heun":
        memory = (*memory, RATES)
        phases = (Phase("hold", 2, _hold), Phase("start_up", 3, _three_steps, _three_steps_as_written))

    @algorithm(
        f"adams-moulton-4-{starter}", source=SOURCE, subsamples=1, order=4 if starter != "heun" else 3, takes="omega",
        properties=frozenset({"flip"}), memory=memory, phases=phases,
        summary="p = q + h (55 f_0 - 59 f_1 + 37 f_2 - 9 f_3)/24; q + h (9 f_p + 19 f_0 - 5 f_1 + f_2)/24",
    )  # fmt: skip
    def written(q: Quaternion, omega: Sequence[Vector], interval: Fraction, f: Sequence[Quaternion]) -> Any:
        last, new = omega
        f1, f2, f3 = f
        f0 = step("f0 = f(q, t)", "f = 1/2 q (x) omega", HALF * (q * last))
        predicted = (interval / 24) * (55 * f0 - 59 * f1 + 37 * f2 - 9 * f3)
        predictor = step("dp = h (55 f0 - 59 f1 + 37 f2 - 9 f3)/24", "Adams-Bashforth", predicted)
        p = step("p = q + dp", "Adams-Bashforth", q + predictor)
        slope = step("fp = f(p, t + h)", "", HALF * (p * new))
        corrected = (interval / 24) * (9 * slope + 19 * f0 - 5 * f1 + f2)
        change = step("dq = h (9 fp + 19 f0 - 5 f1 + f2)/24", "Adams-Moulton", corrected)
        error = step("error = -19/270 (dq - dp)", "Milne", F(-19, 270) * (change - predictor))
        return increment(q, change), {"f": (f0, f1, f2), "error": (error,)}

    @written.factored
    def steady(q: Quaternion, omega: Sequence[Vector], interval: Fraction, f: Sequence[Quaternion]) -> Any:
        last, new = _steps(omega, interval)
        f1, f2, f3 = f
        f0 = step("f0 = q (x) g0", "", q * last)
        predicted = F(55, 24) * f0 - F(59, 24) * f1 + F(37, 24) * f2 - F(9, 24) * f3
        predictor = step("dp = (55 f0 - 59 f1 + 37 f2 - 9 f3)/24", "Adams-Bashforth", predicted)
        p = step("p = q + dp", "Adams-Bashforth", q + predictor)
        slope = step("fp = p (x) g1", "", p * new)
        corrected = F(9, 24) * slope + F(19, 24) * f0 - F(5, 24) * f1 + F(1, 24) * f2
        change = step("dq = (9 fp + 19 f0 - 5 f1 + f2)/24", "Adams-Moulton", corrected)
        error = step("error = -19/270 (dq - dp)", "Milne", F(-19, 270) * (change - predictor))
        return increment(q, change), {"f": (f0, f1, f2), "error": (error,)}

    return written


def _steps(omega: Sequence[Vector], interval: Fraction) -> tuple[Vector, Vector]:
    last, new = omega
    return step("g0 = h/2 omega, last", "", (interval / 2) * last), step(
        "g1 = h/2 omega, new", "", (interval / 2) * new
    )


def _heun(q: Quaternion, omega: Sequence[Vector], interval: Fraction, f: Sequence[Quaternion]) -> Any:
    """Write one step of Heun's method: p = q + f_0, q' = q + (f_0 + f_p)/2."""
    last, new = _steps(omega, interval)
    f0 = step("f0 = q (x) g0", "", q * last)
    slope = step("fp = (q + f0) (x) g1", "Heun", (q + f0) * new)
    change = step("dq = (f0 + fp)/2", "Heun", F(1, 2) * (f0 + slope))
    return increment(q, change), {"f": (f0, f[0], f[1])}


def _heun_as_written(q: Quaternion, omega: Sequence[Vector], interval: Fraction, f: Sequence[Quaternion]) -> Any:
    """Write one step of Heun's method: p = q + h f_0, q' = q + h (f_0 + f_p)/2."""
    last, new = omega
    f0 = step("f0 = f(q, t)", "f = 1/2 q (x) omega", HALF * (q * last))
    slope = step("fp = f(q + h f0, t + h)", "Heun", HALF * ((q + interval * f0) * new))
    change = step("dq = h (f0 + fp)/2", "Heun", (interval / 2) * (f0 + slope))
    return increment(q, change), {"f": (f0, f[0], f[1])}


def _hold(q: Quaternion, omega: Sequence[Vector], rates: Sequence[Vector]) -> Any:
    """Keep the attitude and the rate at the start of this interval."""
    return q, {"rates": (rates[1], omega[0])}


def _three_steps(q: Quaternion, omega: Sequence[Vector], interval: Fraction, rates: Sequence[Vector]) -> Any:
    """Write three Runge-Kutta steps; the rates between samples come from the cubic through the four."""
    samples = (*rates, *omega)
    middles = _middles(samples)
    slopes: list[Quaternion] = []
    total: Quaternion | None = None
    now = q
    for k, middle in enumerate(middles):
        first, change = _runge_kutta(now, [(interval / 2) * each for each in (samples[k], middle, samples[k + 1])], k)
        slopes.append(first)
        total = change if total is None else total + change
        now = q + total
    assert total is not None
    total = step("dq = the three steps together", "Runge-Kutta", total)
    return increment(q, total), {"f": (slopes[2], slopes[1], slopes[0])}


def _three_steps_as_written(q: Quaternion, omega: Sequence[Vector], interval: Fraction, rates: Sequence[Vector]) -> Any:
    """Write three Runge-Kutta steps of h, each from the attitude the one before leaves."""
    samples = (*rates, *omega)
    slopes: list[Quaternion] = []
    total: Quaternion | None = None
    for k, middle in enumerate(_middles(samples)):
        now = q if total is None else q + total
        k1 = HALF * (now * samples[k])
        k2 = HALF * ((now + (interval / 2) * k1) * middle)
        k3 = HALF * ((now + (interval / 2) * k2) * middle)
        k4 = HALF * ((now + interval * k3) * samples[k + 1])
        change = (interval / 6) * (k1 + 2 * k2 + 2 * k3 + k4)
        change = step(f"dq{k} = h (k1 + 2 k2 + 2 k3 + k4)/6 of step {k + 1}", "Runge-Kutta", change)
        slopes.append(k1)
        total = change if total is None else total + change
    assert total is not None
    total = step("dq = the three steps together", "Runge-Kutta", total)
    return increment(q, total), {"f": (slopes[2], slopes[1], slopes[0])}


def _middles(samples: Sequence[Vector]) -> tuple[Vector, ...]:
    w0, w1, w2, w3 = samples
    middles = (
        F(5, 16) * w0 + F(15, 16) * w1 - F(5, 16) * w2 + F(1, 16) * w3,
        F(-1, 16) * w0 + F(9, 16) * w1 + F(9, 16) * w2 - F(1, 16) * w3,
        F(1, 16) * w0 - F(5, 16) * w1 + F(15, 16) * w2 + F(5, 16) * w3,
    )
    heading("rates in the middle of each interval, from the cubic through four samples", "", w0)
    return middles


def _runge_kutta(q: Quaternion, g: Sequence[Vector], number: int) -> tuple[Quaternion, Quaternion]:
    k1 = q * g[0]
    k2 = (q + HALF * k1) * g[1]
    k3 = (q + HALF * k2) * g[1]
    k4 = (q + k3) * g[2]
    text = f"dq{number} = (k1 + k4)/6 + (k2 + k3)/3 of step {number + 1}"
    return k1, step(text, "Runge-Kutta", F(1, 6) * (k1 + k4) + F(1, 3) * (k2 + k3))


FAMILY = Family(
    id="adams-moulton-4",
    title="Adams-Bashforth predictor, Adams-Moulton corrector, with Milne's error estimate",
    source=SOURCE,
    parameters=(Choice("starter", STARTERS, STARTERS[0], "method of the first three steps"),),
    make=lambda values: adams_moulton(str(values["starter"] or STARTERS[0])),
    examples=({"starter": "runge-kutta-4"}, {"starter": "heun"}),
)
