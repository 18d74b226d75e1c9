"""The attitude-update algorithms by hand: rotation vector, previous-sample and single-sample Picard forms."""

from __future__ import annotations

from typing import Literal

import numpy as np

from qcone.reference.kinematics import chain
from qcone.reference.quaternion import (
    Array,
    change_from_rotation_vector,
    from_rotation_vector,
    normalise,
    product,
)
from qcone.reference.weights import CAO_13, EXPANDED, PREVIOUS, RATE_SAMPLES, SPACING, SPREAD, TAYLOR, Rows

__all__ = [
    "COEFFICIENTS",
    "exponential",
    "increments_cao_13",
    "increments_from_rates",
    "normalise",
    "pair_weights",
    "picard",
    "rotation_vector",
    "rotation_vector_previous",
    "run",
    "update",
]

COEFFICIENTS = ("taylor", "coning", "expanded", "compressed")

Order = Literal[1, 2, 3, 4, "closed"]


def pair_weights(subsamples: int, coefficients: str) -> dict[tuple[int, int], float]:
    """Return the weight of theta_i x theta_j for the pairs i < j that have one, `subsamples` 1..6.

    `coefficients`: `taylor` (exact for polynomial rates), `coning` (coning-optimal, spread evenly),
    `expanded` (coning-optimal, low moments exact) or `compressed` (coning-optimal, all on the last sub-
    sample). One sub-sample has no pairs.

    Raises ValueError for another number or name.
    """
    n = subsamples
    if n not in TAYLOR:
        raise ValueError(f"subsamples is {n}, the tables hold 1 to 6")
    if coefficients == "taylor":
        return _pairs(TAYLOR[n])
    if coefficients == "expanded":
        return _pairs(EXPANDED[n])
    if coefficients == "coning":
        return {(i, i + d): weight for d, weight in enumerate(SPREAD[n], 1) for i in range(1, n - d + 1)}
    if coefficients == "compressed":
        return {(n - d, n): weight for d, weight in enumerate(SPACING[n], 1)}
    raise ValueError(f"coefficients is {coefficients!r}, choose one of {', '.join(COEFFICIENTS)}")


def _pairs(rows: Rows) -> dict[tuple[int, int], float]:
    return {(i, j): weight for i, row in enumerate(rows, 1) for j, weight in enumerate(row, i + 1)}


def rotation_vector(dtheta: Array, coefficients: str = "coning") -> Array:
    """Return phi = sum theta_i + sum k_ij theta_i x theta_j, (..., 3) rad, of the increments (..., N, 3) rad.

    cao (12), xu2019 (4). Raises ValueError for N outside 1..6 or unknown `coefficients`.
    """
    dtheta = np.asarray(dtheta, dtype=np.float64)
    coning = np.zeros_like(dtheta[..., 0, :])
    for (i, j), weight in pair_weights(dtheta.shape[-2], coefficients).items():
        coning += weight * np.cross(dtheta[..., i - 1, :], dtheta[..., j - 1, :])
    phi: Array = np.sum(dtheta, axis=-2) + coning
    return phi


def rotation_vector_previous(dtheta: Array, previous: Array) -> Array:
    """Return phi = theta + (sum c_p theta_{-p}) x theta, (..., 3) rad, of the newest increment `dtheta`.

    `dtheta` (..., 3) rad; `previous` (..., P, 3) are the P = 1..5 increments before it, the most recent
    first. P = 1 is Savage 1998. Raises ValueError for another P.
    """
    dtheta, previous = np.asarray(dtheta, dtype=np.float64), np.asarray(previous, dtype=np.float64)
    if previous.shape[-2] not in PREVIOUS:
        raise ValueError(f"previous holds {previous.shape[-2]} increments, the tables hold 1 to 5")
    weighted = np.einsum("p,...pi->...i", np.array(PREVIOUS[previous.shape[-2]]), previous)
    phi: Array = dtheta + np.cross(weighted, dtheta)
    return phi


def exponential(phi: Array) -> Array:
    """Return the update r (..., 4) of the rotation vector `phi` (..., 3) rad, in closed form; cao (9)."""
    return from_rotation_vector(phi)


def picard(dtheta: Array, order: Order) -> Array:
    """Return the update r (..., 4) of one increment `dtheta` (..., 3) rad; cao (7)-(9).

    The series in |dtheta| is cut at `order` 1..4, or summed in closed form (`closed`). A cut series is not
    a unit quaternion. Raises ValueError for another order.
    """
    return np.array([1.0, 0.0, 0.0, 0.0]) + _picard_change(dtheta, order)


def _picard_change(dtheta: Array, order: Order) -> Array:
    """Return r - 1, which keeps the precision of small increments."""
    dtheta = np.asarray(dtheta, dtype=np.float64)
    if order == "closed":
        return change_from_rotation_vector(dtheta)
    x = np.sum(dtheta * dtheta, axis=-1, keepdims=True)
    half, third = np.full_like(x, 1 / 2), 1 / 2 - x / 48
    parts: dict[Order, tuple[Array, Array]] = {
        1: (np.zeros_like(x), half),
        2: (-x / 8, half),
        3: (-x / 8, third),
        4: (-x / 8 + x**2 / 384, third),
    }
    if order not in parts:
        raise ValueError(f"order is {order!r}, choose 1, 2, 3, 4 or 'closed'")
    scalar, factor = parts[order]
    return np.concatenate([scalar, factor * dtheta], axis=-1)


def update(q: Array, r: Array) -> Array:
    """Return q (x) r, (..., 4): the attitude after the update; cao (8)."""
    return product(q, r)


def run(
    start: Array,
    dtheta: Array,
    *,
    coefficients: str = "coning",
    previous: int = 0,
    history: Array | None = None,
    order: Order | None = None,
) -> Array:
    """Return the attitude (updates, 4) after each update from `start` (4,) by `dtheta` (updates, N, 3) rad.

    With N sub-samples the rotation vector takes `coefficients`. With one, `previous` 1..5 selects the
    previous-sample form and `order` the Picard form. `history` (previous, 3) rad, the most recent first,
    are the increments before the first update; without it the first `previous` updates use phi = theta, as
    firmware starts up. The result is not renormalised: its direction does not depend on its norm.

    Raises ValueError for a combination that does not exist.
    """
    dtheta = np.asarray(dtheta, dtype=np.float64)
    if (previous or order is not None) and dtheta.shape[-2] != 1:
        raise ValueError(f"previous and order need one sub-sample an update, dtheta has {dtheta.shape[-2]}")
    if previous and order is not None:
        raise ValueError("previous and order are different algorithms, choose one")
    if history is not None and np.shape(history) != (previous, 3):
        raise ValueError(f"history has shape {np.shape(history)}, previous = {previous} needs ({previous}, 3)")
    if order is not None:
        return chain(start, _picard_change(dtheta[:, 0], order))
    phi = _with_previous(dtheta[:, 0], previous, history) if previous else rotation_vector(dtheta, coefficients)
    return chain(start, change_from_rotation_vector(phi))


def _with_previous(dtheta: Array, previous: int, history: Array | None) -> Array:
    """Return phi (updates, 3) of the increments (updates, 3) in their order of time."""
    before = np.zeros((previous, 3)) if history is None else np.asarray(history, dtype=np.float64)[::-1]
    stream = np.concatenate([before, dtheta])
    lagged = [stream[previous - p : len(stream) - p] for p in range(1, previous + 1)]
    phi = rotation_vector_previous(dtheta, np.stack(lagged, axis=-2))
    if history is None:
        phi[:previous] = dtheta[:previous]
    return phi


def increments_from_rates(omega: Array, interval: float) -> Array:
    """Return increments (..., N, 3) rad from the rates (..., N + 1, 3) rad/s at sub-sample ends, N = 1..6.

    `interval` is the update interval in s, N sub-samples long; exact for rates of polynomial degree N.
    Raises ValueError for another N.
    """
    omega = np.asarray(omega, dtype=np.float64)
    if omega.shape[-2] - 1 not in RATE_SAMPLES:
        raise ValueError(f"omega holds {omega.shape[-2]} rates, the tables hold 2 to 7")
    return interval * (np.array(RATE_SAMPLES[omega.shape[-2] - 1]) @ omega)


def increments_cao_13(omega: Array, interval: float) -> Array:
    """Return increments (..., 3, 3) rad from four rates (..., 4, 3) rad/s by cao (13), third line corrected.

    `interval` is the update interval in s. Raises ValueError for another number of rates.
    """
    omega = np.asarray(omega, dtype=np.float64)
    if omega.shape[-2] != 4:
        raise ValueError(f"omega holds {omega.shape[-2]} rates, cao (13) takes 4")
    return interval * (np.array(CAO_13) @ omega)
