"""Vectors: the inputs on which C and model are compared, drawn from the declared range and its corners.

Lanes are independent runs; a lane's rows follow one another. Every lane begins with a restart; some restart
on every row (single step), most run on for long (chained).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends.bittrue import dtype_of
from qcone.bundle import Bundle
from qcone.ir.statement import Role

GO_ON, INIT, SET = 0, 1, 2
LANES = 256
SINGLE_STEP_LANES = 8
CHAINED_LANES = 32
"""Lanes that restart on every row; lanes that never do."""


@dataclass(frozen=True)
class Vectors:
    """Rows by lane: arrays (lanes, steps, ...). `restart` says what precedes the update of a row.

    `attitude` (4) is for a SET, `before` (3) the rate that `start` takes, `inputs` the argument of `update`.
    """

    restart: NDArray[np.int32]
    attitude: NDArray[Any]
    before: NDArray[Any]
    inputs: NDArray[Any]

    @property
    def rows(self) -> int:
        """Return the number of updates."""
        return int(self.restart.size)


def draw(bundle: Bundle, rows: int, seed: int = 1) -> Vectors:
    """Return at least `rows` rows of vectors for a design; the same for the same seed."""
    lanes = min(LANES, max(1, rows // 4))
    steps = -(-rows // lanes)
    generator = np.random.default_rng(seed)
    dtype = dtype_of(bundle.facts.number)
    block = bundle.machine.routine("update").having(Role.INPUT)[0]
    radius = float(block.norm or 1)
    inputs = _samples(generator, (lanes, steps, block.count), radius, dtype).reshape(lanes, steps, block.size)
    before = _samples(generator, (lanes, steps), radius, dtype)
    return Vectors(_restarts(generator, lanes, steps), _attitudes(generator, (lanes, steps), dtype), before, inputs)


def _restarts(generator: np.random.Generator, lanes: int, steps: int) -> NDArray[np.int32]:
    restart = generator.choice([GO_ON, INIT, SET], (lanes, steps), p=[0.97, 0.01, 0.02]).astype(np.int32)
    restart[:CHAINED_LANES] = GO_ON
    restart[-SINGLE_STEP_LANES:] = SET
    restart[:, 0] = generator.choice([INIT, SET], lanes)
    return restart


def _attitudes(generator: np.random.Generator, shape: tuple[int, int], dtype: Any) -> NDArray[Any]:
    q = generator.standard_normal((*shape, 4))
    q /= np.linalg.norm(q, axis=-1, keepdims=True)
    corners = np.concatenate([np.eye(4), -np.eye(4), np.full((1, 4), 0.5)])
    chosen = generator.random(shape) < 0.1
    q[chosen] = corners[generator.integers(len(corners), size=int(chosen.sum()))]
    return q.astype(dtype)


def _samples(generator: np.random.Generator, shape: tuple[int, ...], radius: float, dtype: Any) -> NDArray[Any]:
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
