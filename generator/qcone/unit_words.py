"""What a rotating unit adds to a row: what its setting routine is handed, and the words its stage gives."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends.bittrue import Model, State
from qcone.bundle import Bundle
from qcone.ir.statement import Role
from qcone.vectors import CORRECT, INIT, SET, Vectors


def settings(bundle: Bundle) -> tuple[tuple[int, str], ...]:
    """Return the routines that may precede an update, each with the kind of restart that asks for it."""
    several = ((INIT, "init"), (SET, bundle.driver.setter))
    return (*several, (CORRECT, "set_correction")) if bundle.driver.stage else several


def handed(bundle: Bundle, routine: str, attitude: NDArray[Any], correction: NDArray[Any]) -> dict[str, NDArray[Any]]:
    """Return what a setting routine takes of its rows (n, ...): the attitude, or the harmonics one by one."""
    blocks = bundle.machine.routine(routine).having(Role.INPUT)
    values = (correction if routine == "set_correction" else attitude).T
    found, first = {}, 0
    for block in blocks:
        found[block.name] = values[first : first + block.size]
        first += block.size
    return found


def unit_rows(vectors: Vectors, step: int | slice) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the encoder's angles and the harmonics of a step of every lane, or of every row by a whole slice."""
    angles, harmonics = vectors.unit
    return angles[:, step].reshape(-1), harmonics[:, step].reshape(-1, harmonics.shape[-1])


def stage_words(model: Model, bundle: Bundle, state: State, encoder: NDArray[Any]) -> list[NDArray[Any]]:
    """Run the stage at the encoder's angles (lanes,); return what its functions give, nothing without a stage."""
    known: dict[str, NDArray[Any]] = {"encoder": encoder[np.newaxis]}
    words: list[NDArray[Any]] = []
    for name, _ in bundle.driver.stage:
        found = model.run(name, state, known)
        words += found.values()
        known |= found
    return words
