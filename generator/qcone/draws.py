"""Draws: random inputs of every kind an update is handed, inside the declared range and on its corners."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.passes.samples import Samples


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
