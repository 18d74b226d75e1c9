"""The classical Runge-Kutta method of order four on quaternion, direction cosine matrix and Euler angles.

Rates come at the ends and the middle of every update interval: a stream (2 n + 1, 3) for n updates.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from qcone.reference.euler import Convention, angle_rates
from qcone.reference.kinematics import chain
from qcone.reference.matrices import chain_matrices
from qcone.reference.quaternion import Array, product

Derivative = Callable[[Array, Array], Array]


def rk4_quaternion(q: Array, omega: Array, interval: float) -> Array:
    """Return the attitude (..., 4) one `interval` in s after `q` (..., 4), by q' = 1/2 q (x) (0, omega).

    `omega` (..., 3, 3) rad/s holds the body rates at the start, the middle and the end of the interval. The result is
    not a unit quaternion. Raises ValueError for another number of rates.
    """
    q = np.asarray(q, dtype=np.float64)
    return q + rk4_increment(quaternion_rate, q, omega, interval)


def rk4_dcm(c: Array, omega: Array, interval: float) -> Array:
    """Return C_nb (..., 3, 3) one `interval` in s after `c`, by C' = C [omega x]; rates as for `rk4_quaternion`."""
    c = np.asarray(c, dtype=np.float64)
    return c + rk4_increment(matrix_rate, c, omega, interval)


def rk4_euler(angles: Array, omega: Array, interval: float, convention: Convention = "zyx") -> Array:
    """Return roll, pitch, yaw (..., 3) in rad one `interval` in s after `angles`; rates as for `rk4_quaternion`.

    The angles are not wrapped. Loses the attitude where the pitch comes near 90 degrees.
    """
    angles = np.asarray(angles, dtype=np.float64)
    return angles + rk4_increment(lambda y, rate: angle_rates(y, rate, convention), angles, omega, interval)


def rk4_increment(derivative: Derivative, y: Array, omega: Array, interval: float) -> Array:
    """Return h (k1 + 2 k2 + 2 k3 + k4)/6, the shape of `y`, of y' = derivative(y, rate); rates as above."""
    omega = np.asarray(omega, dtype=np.float64)
    if omega.shape[-2] != 3:
        raise ValueError(f"omega holds {omega.shape[-2]} rates, a step takes 3: start, middle, end")
    begin, middle, end = np.moveaxis(omega, -2, 0)
    k1 = derivative(y, begin)
    k2 = derivative(y + interval / 2 * k1, middle)
    k3 = derivative(y + interval / 2 * k2, middle)
    k4 = derivative(y + interval * k3, end)
    increment: Array = interval / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return increment


def quaternion_rate(q: Array, omega: Array) -> Array:
    """Return q' = 1/2 q (x) (0, omega), shape (..., 4), at the body rate `omega` (..., 3) rad/s."""
    return product(q, np.concatenate([np.zeros_like(omega[..., :1]), omega], axis=-1)) / 2


def matrix_rate(c: Array, omega: Array) -> Array:
    """Return C' = C [omega x], shape (..., 3, 3), at the body rate `omega` (..., 3) rad/s: rows crossed with it."""
    rate: Array = np.cross(c, omega[..., np.newaxis, :])
    return rate


def run_quaternion(start: Array, omega: Array, interval: float) -> Array:
    """Return the attitude (updates, 4) after each `interval` in s from `start` (4,).

    `omega` (2 updates + 1, 3) rad/s: ends and middles in turn. The step is linear in q, so each is taken from the
    identity and multiplied on. Not renormalised: the direction does not depend on the norm. Raises ValueError for an
    even number of rates.
    """
    rates = intervals(omega)
    identity = np.broadcast_to(np.array([1.0, 0.0, 0.0, 0.0]), (len(rates), 4))
    return chain(start, rk4_increment(quaternion_rate, identity, rates, interval))


def run_dcm(start: Array, omega: Array, interval: float, *, orthogonal: bool = False) -> Array:
    """Return C_nb (updates, 3, 3) after each `interval` in s from `start` (3, 3); `omega` as for `run_quaternion`.

    With `orthogonal` every attitude goes through one step C (3 I - C^T C)/2.
    """
    rates = intervals(omega)
    identity = np.broadcast_to(np.eye(3), (len(rates), 3, 3))
    return chain_matrices(start, rk4_increment(matrix_rate, identity, rates, interval), orthogonal=orthogonal)


def run_euler(start: Array, omega: Array, interval: float, convention: Convention = "zyx") -> Array:
    """Return roll, pitch, yaw (updates, 3) in rad, not wrapped, after each `interval` in s from `start` (3,) rad.

    `omega` as for `run_quaternion`.
    """
    angles = np.asarray(start, dtype=np.float64)
    rates = intervals(omega)
    history = np.empty((len(rates), 3))
    for k, rate in enumerate(rates):
        angles = history[k] = rk4_euler(angles, rate, interval, convention)
    return history


def intervals(omega: Array) -> Array:
    """Return (n, 3, 3) rad/s, start, middle and end of each interval, of the stream `omega` (2 n + 1, 3) rad/s."""
    omega = np.asarray(omega, dtype=np.float64)
    if len(omega) % 2 == 0:
        raise ValueError(f"omega holds {len(omega)} rates, n updates take 2 n + 1")
    return np.stack([omega[:-1:2], omega[1::2], omega[2::2]], axis=1)
