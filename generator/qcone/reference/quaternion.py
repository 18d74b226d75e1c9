"""Quaternion algebra, scalar first, Hamilton product, body to navigation frame."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]

SERIES_BELOW = 1e-4  # |phi|^2; the first dropped term of the series is then below 1e-24


def product(p: Array, q: Array) -> Array:
    """Return the Hamilton product p (x) q, shape (..., 4); cao (2)."""
    p0, p1, p2, p3 = np.moveaxis(np.asarray(p, dtype=np.float64), -1, 0)
    q0, q1, q2, q3 = np.moveaxis(np.asarray(q, dtype=np.float64), -1, 0)
    return np.stack(
        [
            p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
            p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
            p0 * q2 - p1 * q3 + p2 * q0 + p3 * q1,
            p0 * q3 + p1 * q2 - p2 * q1 + p3 * q0,
        ],
        axis=-1,
    )


def conjugate(q: Array) -> Array:
    """Return q with its vector part negated: the inverse rotation of a unit quaternion, shape (..., 4)."""
    inverse: Array = np.asarray(q, dtype=np.float64) * np.array([1.0, -1.0, -1.0, -1.0])
    return inverse


def normalise(q: Array) -> Array:
    """Return q divided by its Euclidean norm, shape (..., 4)."""
    q = np.asarray(q, dtype=np.float64)
    unit: Array = q / np.linalg.norm(q, axis=-1, keepdims=True)
    return unit


def change_from_rotation_vector(phi: Array) -> Array:
    """Return r - 1 for the unit quaternion r of the rotation vector `phi` (..., 3) rad, shape (..., 4).

    The difference keeps the full relative precision of a small rotation, which r itself loses beside its 1:
    the scalar part is cos(|phi|/2) - 1 = -2 sin^2(|phi|/4).
    """
    phi = np.asarray(phi, dtype=np.float64)
    x = np.sum(phi * phi, axis=-1, keepdims=True)
    angle = np.sqrt(x)
    small = x < SERIES_BELOW
    series = 1 / 2 - x / 48 + x**2 / 3840 - x**3 / 645120
    closed = np.sin(angle / 2) / np.where(small, 1.0, angle)
    return np.concatenate([-2 * np.sin(angle / 4) ** 2, np.where(small, series, closed) * phi], axis=-1)


def from_rotation_vector(phi: Array) -> Array:
    """Return the unit quaternion [cos(|phi|/2), sin(|phi|/2) phi/|phi|] of `phi` (..., 3) rad; cao (1)."""
    r = change_from_rotation_vector(phi)
    r[..., 0] = np.cos(np.linalg.norm(phi, axis=-1) / 2)
    return r


def to_rotation_vector(q: Array) -> Array:
    """Return the shortest rotation vector (..., 3) in rad, norm at most pi, of `q` (..., 4) of any norm."""
    q = np.asarray(q, dtype=np.float64)
    q = np.where(q[..., :1] < 0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(sine, q[..., :1])
    factor = np.where(sine > 0, angle, 2.0) / np.where(sine > 0, sine, 1.0)
    vector: Array = factor * q[..., 1:]
    return vector


def to_matrix(q: Array) -> Array:
    """Return C_nb (..., 3, 3), v_n = C_nb v_b, of the unit quaternion `q`; cao (15)."""
    q0, q1, q2, q3 = np.moveaxis(np.asarray(q, dtype=np.float64), -1, 0)
    rows = [
        [q0**2 + q1**2 - q2**2 - q3**2, 2 * (q1 * q2 - q0 * q3), 2 * (q1 * q3 + q0 * q2)],
        [2 * (q1 * q2 + q0 * q3), q0**2 - q1**2 + q2**2 - q3**2, 2 * (q2 * q3 - q0 * q1)],
        [2 * (q1 * q3 - q0 * q2), 2 * (q2 * q3 + q0 * q1), q0**2 - q1**2 - q2**2 + q3**2],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def from_matrix(c: Array) -> Array:
    """Return the unit quaternion (..., 4), scalar part >= 0, of the rotation matrix C_nb (..., 3, 3).

    Shepperd's method: divide by the largest of the four components, so that no rotation angle is singular.
    """
    c = np.asarray(c, dtype=np.float64)
    c11, c22, c33 = c[..., 0, 0], c[..., 1, 1], c[..., 2, 2]
    x, y, z = c[..., 2, 1] - c[..., 1, 2], c[..., 0, 2] - c[..., 2, 0], c[..., 1, 0] - c[..., 0, 1]
    xy, xz, yz = c[..., 0, 1] + c[..., 1, 0], c[..., 0, 2] + c[..., 2, 0], c[..., 1, 2] + c[..., 2, 1]
    # Row k is 4 q_k q: each row is parallel to q, and the row of the largest q_k is the longest.
    rows = np.stack(
        [
            np.stack([1 + c11 + c22 + c33, x, y, z], axis=-1),
            np.stack([x, 1 + c11 - c22 - c33, xy, xz], axis=-1),
            np.stack([y, xy, 1 - c11 + c22 - c33, yz], axis=-1),
            np.stack([z, xz, yz, 1 - c11 - c22 + c33], axis=-1),
        ],
        axis=-2,
    )
    squares = np.diagonal(rows, axis1=-2, axis2=-1)
    largest = np.argmax(squares, axis=-1)[..., np.newaxis, np.newaxis]
    q = normalise(np.take_along_axis(rows, largest, axis=-2)[..., 0, :])
    return np.where(q[..., :1] < 0, -q, q)


def error_angle(q_estimate: Array, q_true: Array) -> Array:
    """Return the angle (...) in rad, 0 to pi, of the rotation between two attitudes (..., 4) of any norm.

    conj(q_true) (x) q_estimate has the vector part of conj(q_true) (x) (q_estimate - q_true), and the
    difference of neighbouring numbers is exact: errors far below the 1e-16 of a direct product are
    resolved.
    """
    estimate, true = _same_hemisphere(q_estimate, q_true)
    vector = product(conjugate(true), estimate - true)[..., 1:]
    scalar = np.abs(np.sum(true * estimate, axis=-1))
    angle: Array = 2 * np.arctan2(np.linalg.norm(vector, axis=-1), scalar)
    return angle


def navigation_error(q_estimate: Array, q_true: Array) -> Array:
    """Return the rotation vector (..., 3) in rad of q_estimate (x) conj(q_true): error in navigation axes."""
    estimate, true = _same_hemisphere(q_estimate, q_true)
    vector = product(estimate - true, conjugate(true))[..., 1:]
    scalar = np.sum(true * estimate, axis=-1, keepdims=True)
    return to_rotation_vector(np.concatenate([scalar, vector], axis=-1))


def _same_hemisphere(q_estimate: Array, q_true: Array) -> tuple[Array, Array]:
    """Return both attitudes as float64, the first negated where that brings it nearer to the second."""
    estimate, true = np.asarray(q_estimate, dtype=np.float64), np.asarray(q_true, dtype=np.float64)
    opposite = np.sum(estimate * true, axis=-1, keepdims=True) < 0
    return np.where(opposite, -estimate, estimate), true
