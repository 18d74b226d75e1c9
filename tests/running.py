"""The compiled C of a design, run on rows of samples: every state block and every output after each update."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from qcone.backends.bittrue import dtype_of
from qcone.bundle import Bundle
from qcone.ir.statement import Role
from qcone.targets.compiler import Compiler
from qcone.vectors import GO_ON, INIT, SET, Vectors
from qcone.verify import c_words, differing_bits, model_words, open_library

Array = NDArray[Any]


@dataclass(frozen=True)
class Ran:
    """What was seen after each update, by name of the state block or of the output: (updates, components)."""

    words: Array
    names: dict[str, slice]

    def __getitem__(self, name: str) -> Array:
        """Return the rows of a block."""
        return self.words[:, self.names[name]]

    @property
    def q(self) -> Array:
        """Return the quaternion output, as float64."""
        return self["quaternion"].astype(np.float64)

    @property
    def dcm(self) -> Array:
        """Return the matrix output (updates, 3, 3), as float64."""
        return self["dcm"].astype(np.float64).reshape(-1, 3, 3)


def _names(bundle: Bundle) -> dict[str, slice]:
    found, at = {}, 0
    sizes = [(block.name, block.size) for block in bundle.machine.state]
    for name, size in (*sizes, *bundle.driver.outputs):
        found[name] = slice(at, at + size)
        at += size
    return found


def chain(
    bundle: Bundle,
    compiler: Compiler,
    samples: Array,
    attitude: ArrayLike | None = None,
    before: ArrayLike | None = None,
    *,
    exact: bool = False,
) -> Ran:
    """Run updates one after another on `samples` (updates, ...), from the identity or from `attitude`.

    `attitude` is what the design's setter takes, `before` the rate that `start` takes. With `exact` the bit-true
    model runs too and may not differ in any bit.
    """
    restart = np.full((1, len(samples)), GO_ON, np.int32)
    restart[0, 0] = INIT if attitude is None else SET
    return _run(bundle, compiler, samples, restart, attitude, before, exact)


def singly(
    bundle: Bundle,
    compiler: Compiler,
    samples: Array,
    attitude: ArrayLike | None = None,
    before: ArrayLike | None = None,
    *,
    exact: bool = False,
) -> Ran:
    """Run every update of `samples` from the identity, or from its own row of `attitude`."""
    restart = np.full((1, len(samples)), INIT if attitude is None else SET, np.int32)
    return _run(bundle, compiler, samples, restart, attitude, before, exact)


def _run(
    bundle: Bundle,
    compiler: Compiler,
    samples: Array,
    restart: NDArray[np.int32],
    attitude: ArrayLike | None,
    before: ArrayLike | None,
    exact: bool,
) -> Ran:
    dtype, rows = dtype_of(bundle.facts.number), len(samples)
    held = np.zeros((1, rows, bundle.driver.attitude_size), dtype)
    first = np.zeros((1, rows, 3), dtype)
    if attitude is not None:
        held[0] = np.asarray(attitude).reshape(-1, bundle.driver.attitude_size)
    if before is not None:
        first[0] = before
    given = np.ascontiguousarray(samples, dtype).reshape(1, rows, -1)
    vectors = Vectors(restart, held, first, given)
    words, contracted = c_words(bundle, open_library(bundle, compiler, "-O2"), vectors)
    assert not contracted
    if exact:
        assert differing_bits(words, model_words(bundle, vectors)) == 0
    return Ran(words[0], _names(bundle))


def input_size(bundle: Bundle) -> int:
    """Return how many values one update takes."""
    return bundle.machine.routine("update").having(Role.INPUT)[0].size
