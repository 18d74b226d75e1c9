"""Draws: random inputs of every kind an update is handed, inside the declared range and on its corners."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.passes.samples import Samples

HARMONICS = 9
"""Coefficients of a rotating unit."""


def angles_of_encoder(generator: np.random.Generator, shape: tuple[int, int], dtype: Any) -> NDArray[Any]:
    """Return angles of at most 3 pi in size: any, multiples of pi/4 and their neighbours, both zeros, tiny ones."""
    whole = np.pi / 4 * generator.integers(-12, 13, shape)
    angles = generator.uniform(-3 * np.pi, 3 * np.pi, shape).astype(dtype)
    kind, info = generator.random(shape), np.finfo(dtype)
    rounded = whole.astype(dtype)
    for low, values in (
        (0.5, rounded),
        (0.65, np.nextafter(rounded, dtype(0))),
        (0.75, np.nextafter(rounded, dtype(4 * np.pi)) * (np.abs(whole) < 3 * np.pi)),
        (0.8, dtype(0.0) * np.sign(angles)),
        (0.85, np.copysign(dtype(3 * np.pi), angles)),
        (0.9, angles * dtype(2.0**-30)),
        (0.95, np.copysign(dtype(info.tiny), angles)),
        (0.98, np.copysign(info.smallest_subnormal, angles)),
    ):
        angles = np.where(kind >= low, values, angles)
    return angles.astype(dtype)


def harmonics(generator: np.random.Generator, shape: tuple[int, int], largest: float, dtype: Any) -> NDArray[Any]:
    """Return three harmonics (..., 9), of each sqrt(A^2 + B^2) + |C| up to the largest correction in rad, or zero."""
    phase = generator.uniform(-np.pi, np.pi, (*shape, 3))
    size = largest * np.where(generator.random((*shape, 3)) < 0.3, 1.0, generator.random((*shape, 3)))
    offset = size * generator.choice([-1.0, 0.0, 1.0, 0.3], (*shape, 3))
    waves = size - np.abs(offset)
    found = np.stack([waves * np.sin(phase), waves * np.cos(phase), offset], axis=-1)
    found[generator.random((*shape, 3)) < 0.1] = 0.0
    return found.reshape(*shape, HARMONICS).astype(dtype)


def attitudes(generator: np.random.Generator, shape: tuple[int, int]) -> NDArray[Any]:
    """Return unit quaternions (..., 4), one in ten of them an axis, its opposite or (1, 1, 1, 1)/2."""
    q = generator.standard_normal((*shape, 4))
    q /= np.linalg.norm(q, axis=-1, keepdims=True)
    corners = np.concatenate([np.eye(4), -np.eye(4), np.full((1, 4), 0.5)])
    chosen = generator.random(shape) < 0.1
    q[chosen] = corners[generator.integers(len(corners), size=int(chosen.sum()))]
    return q


def samples(generator: np.random.Generator, shape: tuple[int, ...], radius: float, dtype: Any) -> NDArray[Any]:
    """Return vectors in the ball of that radius: inside, on the surface, on the axes, zeros, the smallest numbers."""
    direction = generator.standard_normal((*shape, 3))
    direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
    vectors = direction * radius * np.cbrt(generator.random((*shape, 1)))
    sign = np.where(generator.random((*shape, 3)) < 0.5, -1.0, 1.0)
    kind = generator.random(shape)
    info = np.finfo(dtype)
    axis = np.eye(3)[generator.integers(3, size=shape)]

    def put(low: float, high: float, values: NDArray[Any]) -> None:
        chosen = (low <= kind) & (kind < high)
        vectors[chosen] = values[chosen]

    put(0.50, 0.70, direction * radius)
    put(0.70, 0.80, axis * sign * radius)
    put(0.80, 0.86, sign * 0.0)
    put(0.86, 0.90, axis * sign * 0.0)
    put(0.90, 0.93, direction * radius * 2.0**-40)
    result = vectors.astype(dtype)
    tiny = sign * float(info.tiny)
    chosen = (kind >= 0.93) & (kind < 0.96)
    result[chosen] = tiny[chosen].astype(dtype)
    chosen = kind >= 0.96
    counts = generator.integers(1, 1 << 20, (*shape, 3))
    subnormal = (sign * counts).astype(dtype) * info.smallest_subnormal
    result[chosen] = subnormal[chosen]
    return result


def smooth(
    generator: np.random.Generator, shape: tuple[int, int, int], samples: Samples
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return samples on circles, as fast as the declared differences allow, and the sample before each update."""
    lanes, steps, count = shape
    assert samples.first is not None
    most = float(samples.largest)
    size = most * np.where(generator.random(lanes) < 0.5, 1.0, generator.random(lanes) ** 2 + 2.0**-20)
    turn = np.minimum(float(samples.first) / size, 2.0)
    if samples.second is not None:
        turn = np.minimum(turn, np.sqrt(float(samples.second) / size))
    turn *= np.where(generator.random(lanes) < 0.7, 1.0, generator.random(lanes))
    first = generator.standard_normal((lanes, 3))
    first /= np.linalg.norm(first, axis=-1, keepdims=True)
    second = np.cross(first, generator.standard_normal((lanes, 3)))
    second /= np.linalg.norm(second, axis=-1, keepdims=True)
    phase = turn[:, None] * np.arange(steps * count + 1) + generator.uniform(0, 2 * np.pi, (lanes, 1))
    path = size[:, None, None] * (
        np.cos(phase)[..., None] * first[:, None] + np.sin(phase)[..., None] * second[:, None]
    )
    return path[:, 1:].reshape(lanes, steps, count, 3), path[:, :-1:count]
