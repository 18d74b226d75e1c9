"""Euler angles in the two conventions of navigation, accurate at the poles too.

`zyx`: C_nb = Rz(yaw) Ry(pitch) Rx(roll), forward-right-down; cao (16). `zxy`: C_nb = Rz(yaw) Rx(pitch) Ry(roll),
right-forward-up; rins. Angles are always in the order roll, pitch, yaw, in rad, pitch within -pi/2..pi/2. At a pole
only the sum or the difference of roll and yaw is determined; the angles returned there share it equally.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from qcone.reference.quaternion import Array, from_matrix

Convention = Literal["zyx", "zxy"]
CONVENTIONS = ("zyx", "zxy")


def to_angles(q: Array, convention: Convention = "zyx") -> Array:
    """Return roll, pitch, yaw (..., 3) in rad of the attitude `q` (..., 4) of any norm.

    From half sums and differences of roll and yaw, which stay sharp where asin(C31) and atan2(C21, C11) do not: near
    a pole the rounding is that of `q` divided by cos(pitch). Raises ValueError for another convention.
    """
    w, x, y, z = np.moveaxis(np.asarray(q, dtype=np.float64), -1, 0)
    if _checked(convention) == "zyx":
        # (cos + sin)(pitch/2) times cos, sin of (yaw - roll)/2; (cos - sin)(pitch/2) times cos, sin of (yaw + roll)/2.
        up, down = (w + y, z - x), (w - y, z + x)
        half_difference, half_sum = np.arctan2(*reversed(up)), np.arctan2(*reversed(down))
    else:
        # The other way round: the pitch axis is x.
        up, down = (w + x, z + y), (w - x, z - y)
        half_sum, half_difference = np.arctan2(*reversed(up)), np.arctan2(*reversed(down))
    pitch = 2 * np.arctan2(np.hypot(*up), np.hypot(*down)) - np.pi / 2
    return np.stack([_wrapped(half_sum - half_difference), pitch, _wrapped(half_sum + half_difference)], axis=-1)


def from_angles(angles: Array, convention: Convention = "zyx") -> Array:
    """Return the unit quaternion (..., 4) of roll, pitch, yaw (..., 3) in rad; ValueError for another convention."""
    half = np.moveaxis(np.asarray(angles, dtype=np.float64), -1, 0) / 2
    (cr, cp, cy), (sr, sp, sy) = np.cos(half), np.sin(half)
    if _checked(convention) == "zyx":
        parts = [
            cy * cp * cr + sy * sp * sr,
            cy * cp * sr - sy * sp * cr,
            cy * sp * cr + sy * cp * sr,
            sy * cp * cr - cy * sp * sr,
        ]
    else:
        parts = [
            cy * cp * cr - sy * sp * sr,
            cy * sp * cr - sy * cp * sr,
            cy * cp * sr + sy * sp * cr,
            sy * cp * cr + cy * sp * sr,
        ]
    return np.stack(parts, axis=-1)


def matrix_to_angles(c: Array, convention: Convention = "zyx") -> Array:
    """Return roll, pitch, yaw (..., 3) in rad of the rotation matrix C_nb (..., 3, 3); ValueError as above."""
    return to_angles(from_matrix(c), convention)


def matrix_from_angles(angles: Array, convention: Convention = "zyx") -> Array:
    """Return C_nb (..., 3, 3) of roll, pitch, yaw (..., 3) in rad; ValueError for another convention."""
    angles = np.asarray(angles, dtype=np.float64)
    roll, pitch, yaw = angles[..., 0], angles[..., 1], angles[..., 2]
    if _checked(convention) == "zyx":
        return turn(2, yaw) @ turn(1, pitch) @ turn(0, roll)
    return turn(2, yaw) @ turn(0, pitch) @ turn(1, roll)


def turn(axis: int, angle: Array) -> Array:
    """Return the rotation (..., 3, 3) by `angle` (...) in rad about the axis x, y, z = 0, 1, 2."""
    angle = np.asarray(angle, dtype=np.float64)
    following, last = (axis + 1) % 3, (axis + 2) % 3
    c = np.zeros((*angle.shape, 3, 3))
    c[..., axis, axis] = 1
    c[..., following, following] = c[..., last, last] = np.cos(angle)
    c[..., last, following] = np.sin(angle)
    c[..., following, last] = -np.sin(angle)
    return c


def angle_rates(angles: Array, omega: Array, convention: Convention = "zyx") -> Array:
    """Return the derivatives (..., 3) in rad/s of roll, pitch, yaw (..., 3) rad at body rates `omega` (..., 3) rad/s.

    They grow as 1/cos(pitch): the equations lock at a pitch of 90 degrees. Raises ValueError for another convention.
    """
    roll, pitch, _ = np.moveaxis(np.asarray(angles, dtype=np.float64), -1, 0)
    x, y, z = np.moveaxis(np.asarray(omega, dtype=np.float64), -1, 0)
    sine, cosine = np.sin(roll), np.cos(roll)
    if _checked(convention) == "zyx":
        across, roll_axis, pitch_rate = y * sine + z * cosine, x, y * cosine - z * sine
    else:
        across, roll_axis, pitch_rate = z * cosine - x * sine, y, x * cosine + z * sine
    sign = 1 if convention == "zyx" else -1
    return np.stack([roll_axis + sign * np.tan(pitch) * across, pitch_rate, across / np.cos(pitch)], axis=-1)


def _wrapped(angle: Array) -> Array:
    """Return `angle` (...) within -2 pi..2 pi rad brought to -pi..pi."""
    turned: Array = np.where(np.abs(angle) > np.pi, angle - np.copysign(2 * np.pi, angle), angle)
    return turned


def _checked(convention: str) -> str:
    if convention not in CONVENTIONS:
        raise ValueError(f"convention is {convention!r}, choose zyx or zxy")
    return convention
