"""The largest size that a value of a routine reaches, sought: random inputs in their declared norms, then climbing."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.ir.evaluate import Numbers, evaluate
from qcone.ir.statement import Block, Routine
from qcone.passes.magnitudes import Declared

Array = NDArray[np.float64]
Given = dict[str, Array]
"""Components by lanes."""
ROUNDS, LANES = 60, 4000
FLOATS = Numbers(of=float)


def _within(raw: Array, declared: Declared, generator: np.random.Generator, keep: bool) -> Array:
    """Bring vectors into their declared norm, most of them to one of its ends; numbers into their interval."""
    low, high = map(float, declared.norm or declared.interval)
    if declared.norm is None:
        return np.clip(raw, low, high)
    norm = np.maximum(np.linalg.norm(raw, axis=0), 1e-300)
    if not keep:
        size = generator.choice([low, high, high], raw.shape[1])
        return raw / norm * np.where(generator.random(raw.shape[1]) < 0.1, generator.uniform(low, high), size)
    return raw / norm * np.clip(norm, low, high)


def largest(
    routine: Routine, declared: Mapping[str, Declared], size: Callable[[Sequence[Any]], Array], values: Sequence[int]
) -> float:
    """Return the largest `size` found of some values of the routine."""
    generator = np.random.default_rng(5)
    named = Routine(routine.name, routine.blocks, routine.body, names={value: f"n{value}" for value in values})

    def run(given: Given) -> Array:
        inputs = {name: list(components) for name, components in given.items()}
        found = evaluate(named, inputs, FLOATS).named
        return size([np.broadcast_to(found[f"n{value}"], LANES) for value in values])

    def drawn(block: Block) -> Array:
        raw = generator.standard_normal((block.size, LANES))
        if declared[block.name].norm is None:
            low, high = map(float, declared[block.name].interval)
            raw = generator.choice([low, high, *generator.uniform(low, high, 4)], (block.size, LANES))
        return _within(raw, declared[block.name], generator, keep=False)

    blocks = [block for block in routine.blocks if block.name in declared]
    given = {block.name: drawn(block) for block in blocks}
    best = run(given)
    for turn in range(ROUNDS):
        top = np.argsort(best)[-LANES // 20 :]
        step = 0.5 * 0.85**turn
        tried = {}
        for block in blocks:
            base = np.repeat(given[block.name][:, top], 20, axis=1)
            wide = float(max(map(abs, declared[block.name].interval)))
            moved = base + step * wide * generator.standard_normal(base.shape) * (generator.random(LANES) < 0.9)
            tried[block.name] = _within(moved, declared[block.name], generator, keep=True)
        found = run(tried)
        better = found > best
        given = {name: np.where(better, tried[name], given[name]) for name in given}
        best = np.maximum(best, found)
    return float(best.max())


def length(parts: Sequence[Array]) -> Array:
    """Return the Euclidean norm of components."""
    norms: Array = np.sqrt(sum((part**2 for part in parts), np.zeros(LANES)))
    return norms
