"""One Newton step back to a unit quaternion or an orthogonal matrix: no division, no square root."""

from __future__ import annotations

import numpy as np

from qcone.reference.quaternion import Array


def excess(q: Array) -> Array:
    """Return e = (1 - |q|^2)/2, shape (..., 1): q (1 + e) has a norm error of 3/2 times the square of q's."""
    q = np.asarray(q, dtype=np.float64)
    e: Array = (1 - np.sum(q * q, axis=-1, keepdims=True)) / 2
    return e


def renormalise(q: Array) -> Array:
    """Return q (3 - |q|^2)/2, shape (..., 4), for a norm near 1."""
    q = np.asarray(q, dtype=np.float64)
    return q + excess(q) * q


def reorthogonalise(c: Array) -> Array:
    """Return C (3 I - C^T C)/2, shape (..., 3, 3), for a matrix near a rotation."""
    c = np.asarray(c, dtype=np.float64)
    step: Array = c + c @ (np.eye(3) - np.swapaxes(c, -1, -2) @ c) / 2
    return step
