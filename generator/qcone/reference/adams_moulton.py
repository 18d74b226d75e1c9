"""The Adams-Bashforth predictor and Adams-Moulton corrector of order four of thesis2008, with both starters."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from qcone.reference.quaternion import Array
from qcone.reference.renormalisation import excess
from qcone.reference.runge_kutta import quaternion_rate, rk4_increment

Starter = Literal["heun", "runge-kutta-4"]
STARTERS = ("heun", "runge-kutta-4")

# Rows: the cubic through the rates at 0, 1, 2, 3, read at 1/2, 3/2, 5/2.
MIDDLES = np.array([[5, 15, -5, 1], [-1, 9, 9, -1], [1, -5, 15, 5]]) / 16
# Newest first: f_k, f_{k-1}, f_{k-2}, f_{k-3}; the corrector begins at f(p, t_{k+1}).
PREDICTOR = np.array([55, -59, 37, -9]) / 24
CORRECTOR = np.array([9, 19, -5, 1]) / 24
MILNE = -19 / 270


@dataclass(frozen=True)
class Run:
    """What a run gives after each update.

    `attitude` (updates, 4); `estimate` (updates, 4), Milne's estimate -19/270 (c - p) of the error of the step, zero
    for the three updates of the starter, which have none; `ready` (updates,), whether the attitude belongs to the time
    of the newest rate.
    """

    attitude: Array
    estimate: Array
    ready: NDArray[np.bool_]


def adams_moulton(
    start: Array, omega: Array, interval: float, starter: Starter = "runge-kutta-4", *, renormalise: bool = True
) -> Run:
    """Integrate q' = 1/2 q (x) (0, omega) from `start` (4,) over the rates `omega` (updates + 1, 3) rad/s.

    Rates are `interval` s apart, the first at the start, and update k takes the rate at its own end. The first three
    updates start the method: `heun`, a step each, thesis2008; `runge-kutta-4` holds the attitude for two updates, and
    the third makes three Runge-Kutta steps with middle rates from the cubic through the four rates. With
    `renormalise` every step ends with q (3 - |q|^2)/2. The stored derivative is always that of the state as stored.

    Raises ValueError for another starter, or for fewer than four rates.
    """
    omega = np.asarray(omega, dtype=np.float64)
    if starter not in STARTERS:
        raise ValueError(f"starter is {starter!r}, choose heun or runge-kutta-4")
    if len(omega) < 4:
        raise ValueError(f"omega holds {len(omega)} rates, the starter takes 4")
    begin = _heun if starter == "heun" else _runge_kutta
    first, carried = begin(np.asarray(start, dtype=np.float64), omega[:4], interval, renormalise)
    states = np.empty((len(omega), 4))
    states[:4] = first
    estimate = np.zeros((len(omega) - 1, 4))
    half = _right_matrices(omega) / 2  # f(q, t_k) = half_k q
    f = np.einsum("kij,kj->ki", half[:4], first)[::-1]  # newest first
    for k in range(3, len(omega) - 1):
        prediction = interval * (PREDICTOR @ f)
        predicted = half[k + 1] @ (states[k] + prediction)
        correction = interval * (CORRECTOR @ np.vstack([predicted, f[:3]]))
        estimate[k] = MILNE * (correction - prediction)
        states[k + 1], carried = _advance(states[k], correction, carried, renormalise)
        f = np.vstack([half[k + 1] @ states[k + 1], f[:3]])
    ready = np.ones(len(omega) - 1, dtype=np.bool_)
    if starter == "runge-kutta-4":
        ready[:2], states[1:3] = False, states[0]
    return Run(states[1:], estimate, ready)


def _advance(q: Array, increment: Array, carried: Array, renormalise: bool) -> tuple[Array, Array]:
    """Return the next state, and the rounding of the sum for the next step."""
    delta = increment + carried
    if renormalise:
        delta = delta + excess(q + delta) * (q + delta)
    following = q + delta
    return following, delta - (following - q)


def _heun(start: Array, omega: Array, interval: float, renormalise: bool) -> tuple[Array, Array]:
    """Return the states (4, 4) at four rates: p = q + h f, then q + (h/2)(f + f(p)); and the rounding carried."""
    states, carried = [start], np.zeros(4)
    for now, following in pairwise(omega):
        slope = quaternion_rate(states[-1], now)
        slope_ahead = quaternion_rate(states[-1] + interval * slope, following)
        q, carried = _advance(states[-1], interval / 2 * (slope + slope_ahead), carried, renormalise)
        states.append(q)
    return np.array(states), carried


def _runge_kutta(start: Array, omega: Array, interval: float, renormalise: bool) -> tuple[Array, Array]:
    """Return the states (4, 4) at four rates by Runge-Kutta steps, and the rounding carried."""
    states, carried = [start], np.zeros(4)
    for rates in np.stack([omega[:-1], MIDDLES @ omega, omega[1:]], axis=1):
        increment = rk4_increment(quaternion_rate, states[-1], rates, interval)
        q, carried = _advance(states[-1], increment, carried, renormalise)
        states.append(q)
    return np.array(states), carried


def _right_matrices(omega: Array) -> Array:
    """Return the matrices (n, 4, 4) of q -> q (x) (0, omega): Sigma of cao (7)."""
    basis = 2 * quaternion_rate(np.eye(4), omega[:, np.newaxis, :])
    return np.swapaxes(basis, -1, -2)
