"""The bit-true model, one update from each state that the C itself reached: all rows at once.

When every update gives from the C's own state what the model gives, and the first state is set by both alike, then
by induction the whole chain is the model's. So a chain of any length costs one run of the model on as many lanes.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from qcone.backends.bittrue import Model, State, new_state
from qcone.backends.c_state import type_of
from qcone.bundle import Bundle
from qcone.ir.statement import Role
from qcone.unit_words import handed, settings, stage_words, unit_rows
from qcone.vectors import INIT, Vectors
from qcone.words import TYPES


def model_steps(bundle: Bundle, vectors: Vectors, words: NDArray[Any]) -> NDArray[Any]:
    """Return the words (lanes, steps, words) that the model reaches from the state of `words` one row before.

    Every lane must begin with a restart.
    """
    lanes, steps = vectors.restart.shape
    state = _states(bundle, words)
    model = Model(bundle.machine, bundle.facts.number)
    restart = vectors.restart.reshape(-1)
    attitude, before, inputs = (
        each.reshape(lanes * steps, -1) for each in (vectors.attitude, vectors.before, vectors.inputs)
    )
    encoder, harmonics = unit_rows(vectors, slice(None))
    with np.errstate(all="ignore"):
        for kind, name in settings(bundle):
            chosen = restart == kind
            if chosen.any():
                part = {block: array[:, chosen] for block, array in state.items()}
                model.run(name, part, handed(bundle, name, attitude[chosen], harmonics[chosen]))
                if bundle.driver.has_start:
                    model.run("start", part, {"omega": before[chosen].T})
                for block, array in part.items():
                    state[block][:, chosen] = array
        model.run("update", state, {argument(bundle, "update"): np.ascontiguousarray(inputs.T)})
        reported = [each for name, _ in bundle.driver.outputs for each in model.run(name, state).values()]
        reported += stage_words(model, bundle, state, encoder)
    found = np.concatenate([*state.values(), *reported], dtype=words.dtype, casting="unsafe")
    return np.ascontiguousarray(found.T).reshape(words.shape)


def first_state(bundle: Bundle, vectors: Vectors) -> State:
    """Return the state after the restart of the first row of the first lane."""
    model = Model(bundle.machine, bundle.facts.number)
    state = new_state(bundle.machine, bundle.facts.number, 1)
    name = "init" if vectors.restart[0, 0] == INIT else bundle.driver.setter
    model.run(name, state, {argument(bundle, bundle.driver.setter): vectors.attitude[0, :1].T})
    if bundle.driver.has_start:
        model.run("start", state, {"omega": vectors.before[0, :1].T})
    return state


def state_type(bundle: Bundle, big_endian: bool = False) -> np.dtype[Any]:
    """Return the layout of the C structure of the state, members aligned by their own size."""
    order: Literal[">", "<"] = ">" if big_endian else "<"
    types = [np.dtype(TYPES[type_of(block, bundle.facts.number)]) for block in bundle.machine.state]
    fields = [
        (block.name, each.newbyteorder(order), (block.size,))
        for block, each in zip(bundle.machine.state, types, strict=True)
    ]
    return np.dtype(fields, align=True)


def packed(bundle: Bundle, state: State, big_endian: bool = False) -> bytes:
    """Return the state of the first lane as bytes of the C structure."""
    record = np.zeros(1, state_type(bundle, big_endian))
    for name, array in state.items():
        record[name][0] = array[:, 0]
    return record.tobytes()


def unpacked(bundle: Bundle, data: bytes, big_endian: bool = False) -> NDArray[Any]:
    """Return the words (rows, words) of states as C structures one after another, without outputs."""
    records = np.frombuffer(data, state_type(bundle, big_endian))
    names = records.dtype.names or ()
    return np.concatenate([records[name] for name in names], axis=1, dtype=TYPES[bundle.driver.word_ctype])


def _states(bundle: Bundle, words: NDArray[Any]) -> State:
    """Return the state before every row, taken from the words of the row before; zeros before the first."""
    lanes, steps, _ = words.shape
    state = new_state(bundle.machine, bundle.facts.number, lanes * steps)
    at = 0
    for array in state.values():
        part = words[:, :-1, at : at + len(array)]
        array.reshape(len(array), lanes, steps)[:, :, 1:] = np.moveaxis(part, 2, 0)
        at += len(array)
    return state


def argument(bundle: Bundle, routine: str) -> str:
    """Return the name of the block that a routine is handed first."""
    return bundle.machine.routine(routine).having(Role.INPUT)[0].name
