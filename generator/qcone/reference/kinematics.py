"""Attitude from a rate function, to float64 precision: Gauss collocation of Bortz's equation."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from qcone.reference.quaternion import Array, change_from_rotation_vector

IDENTITY: Array = np.array([1.0, 0.0, 0.0, 0.0])

STAGES = 6  # Gauss-Legendre nodes a step: order 12
ITERATIONS = 12
LARGEST_STEP_ANGLE = 0.2  # rad; within it the iteration and the series of bortz() converge to float64


def integrate(
    rate: Callable[[Array], Array],
    increments: Callable[[Array], Array],
    times: Array,
    start: Array = IDENTITY,
    step: float = 1e-3,
) -> Array:
    """Return the attitudes (n, 4), body to navigation, at the non-decreasing `times` (n,) s.

    `rate(t)` gives the body rate (m, 3) rad/s at m instants, `increments(t)` its exact integrals (m - 1, 3)
    rad between consecutive instants. `start` is the attitude at times[0]; `step` bounds the steps, in s.
    The error over a manoeuvre of about 10 rad is a few 1e-16 rad where the rate is smooth over a step.

    Raises ValueError for decreasing times, or when a step turns more than 0.2 rad.
    """
    grid, wanted = _subdivide(np.asarray(times, dtype=np.float64), step)
    attitudes = chain(start, change_from_rotation_vector(rotation_vectors(rate, increments, grid)))
    return np.concatenate([np.asarray(start, dtype=np.float64)[np.newaxis], attitudes])[wanted]


def rotation_vectors(rate: Callable[[Array], Array], increments: Callable[[Array], Array], times: Array) -> Array:
    """Return the exact rotation vectors (n - 1, 3) rad between consecutive `times` (n,) s.

    phi = S + int (phi' - omega) dt: the large part S comes from `increments`, so the quadrature, with its
    rounded weights, only sees the small non-commuting part. Raises ValueError when a step turns more than
    0.2 rad.
    """
    nodes, weights, matrix = _gauss_legendre(STAGES)
    duration = np.diff(times)[:, np.newaxis, np.newaxis]
    instants = times[:-1, np.newaxis] + np.diff(times)[:, np.newaxis] * nodes
    omega = rate(instants.ravel()).reshape(-1, STAGES, 3)
    if np.any(np.linalg.norm(omega * duration, axis=-1) > LARGEST_STEP_ANGLE):
        raise ValueError(f"a step turns more than {LARGEST_STEP_ANGLE} rad, choose a shorter step")
    slope = omega
    for _ in range(ITERATIONS):
        slope = bortz(duration * (matrix @ slope), omega)
    noncommuting = np.einsum("s,nsi->ni", weights, slope - omega)
    phi: Array = increments(times) + duration[:, 0] * noncommuting
    return phi


def bortz(phi: Array, omega: Array) -> Array:
    """Return phi' (..., 3) rad/s of a rotation vector `phi` below 0.2 rad at body rate `omega`; cao (10)."""
    x = np.sum(phi * phi, axis=-1, keepdims=True)
    factor = 1 / 12 + x / 720 + x**2 / 30240 + x**3 / 1209600 + x**4 / 47900160
    across = np.cross(phi, omega)
    slope: Array = omega + across / 2 + factor * np.cross(phi, across)
    return slope


def chain(start: Array, change: Array) -> Array:
    """Return the attitude (n, 4) after each update q_{k+1} = q_k (x) (1 + change_k), from `start` (4,).

    `change` (n, 4) is r - 1. Adding q (x) change with the rounding of each sum carried to the next keeps the
    rounding of a long chain near one unit in the last place, where repeated products would walk away.
    Nothing is renormalised.
    """
    w, x, y, z = (float(component) for component in np.asarray(start))
    carried_w = carried_x = carried_y = carried_z = 0.0
    attitudes = []
    # Python floats are the same float64 and a hundred times faster here than arrays of four.
    for a, b, c, d in np.asarray(change, dtype=np.float64).tolist():
        delta_w = (w * a - x * b - y * c - z * d) + carried_w
        delta_x = (w * b + x * a + y * d - z * c) + carried_x
        delta_y = (w * c - x * d + y * a + z * b) + carried_y
        delta_z = (w * d + x * c - y * b + z * a) + carried_z
        next_w, next_x, next_y, next_z = w + delta_w, x + delta_x, y + delta_y, z + delta_z
        carried_w, carried_x = delta_w - (next_w - w), delta_x - (next_x - x)
        carried_y, carried_z = delta_y - (next_y - y), delta_z - (next_z - z)
        w, x, y, z = next_w, next_x, next_y, next_z
        attitudes.append((w, x, y, z))
    return np.array(attitudes, dtype=np.float64).reshape(-1, 4)


def _gauss_legendre(stages: int) -> tuple[Array, Array, Array]:
    """Return nodes and weights on [0, 1], and the integrals of the Lagrange polynomials up to each node."""
    x, weights = legendre.leggauss(stages)
    values = legendre.legvander(x, stages)
    orders = np.arange(1, stages)
    integrals = np.empty((stages, stages))
    integrals[:, 0] = (x + 1) / 2
    integrals[:, 1:] = (values[:, 2:] - values[:, :-2]) / (2 * (2 * orders + 1))
    matrix = (integrals * (2 * np.arange(stages) + 1)) @ (values[:, :-1] * weights[:, np.newaxis] / 2).T
    return (x + 1) / 2, weights / 2, matrix


def _subdivide(times: Array, step: float) -> tuple[Array, NDArray[np.int64]]:
    """Return a grid that holds `times` with gaps of at most `step`, and the index of each time in it."""
    gaps = np.diff(times)
    if np.any(gaps < 0):
        raise ValueError("times must not decrease")
    parts = np.maximum(np.ceil(gaps / step), 1).astype(np.int64)
    wanted = np.concatenate([[0], np.cumsum(parts)])
    part = np.arange(wanted[-1]) - np.repeat(wanted[:-1], parts)
    inner = np.repeat(times[:-1], parts) + np.repeat(gaps, parts) * (part / np.repeat(parts, parts))
    return np.concatenate([inner, times[-1:]]), wanted
