"""Angles of an encoder and harmonics of a rotating unit, drawn from what is declared of them and its corners."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

HARMONICS = 9
"""Coefficients of the three harmonics of a rotating unit."""


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
