"""Simulate: run the generated, compiled C of a design along motions, several independent runs at once."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone import verify
from qcone.bundle import Bundle
from qcone.design import design_from_options
from qcone.errors import UsageError
from qcone.pipeline import build
from qcone.reference.quaternion import Array
from qcone.registry import entries
from qcone.studies.replaying import LEVEL, outputs_of
from qcone.targets.compiler import first_compiler
from qcone.targets.host import Library
from qcone.vectors import GO_ON, SET, in_form, in_words
from qcone.words import from_words, to_words

Options = tuple[tuple[str, str], ...]
"""Words of a design as on the command line, `algorithm` among them."""

ROUNDED = 1 + 1e-9  # declared ranges are rounded, inputs may lie on their surface


def options(algorithm: str, **words: object) -> Options:
    """Return the words of a design, float64 unless `number` says otherwise."""
    given = {"number": "float64", **{word: str(value) for word, value in words.items()}}
    return (("algorithm", algorithm), *sorted(given.items()))


@cache
def compiled(words: Options) -> tuple[Bundle, Library]:
    """Return the bundle of a design and its compiled C, made once. Raises MissingToolError without a compiler."""
    bundle = build(design_from_options("simulated", dict(words), entries()))
    return bundle, verify.open_library(bundle, first_compiler(), LEVEL)


def run(words: Options, start: Array, inputs: Array, before: Array | None = None) -> Mapping[str, Array]:
    """Return the outputs (lanes, updates, k) of the compiled C by name, and as `kept` the attitude of the state.

    `start` (lanes, 4) are the attitudes at the beginning, `inputs` (lanes, updates, N, 3) the increments in rad or
    rates in rad/s, `before` (lanes, 3) the rates at the beginning. All are rounded to the number format of the design.
    Raises UsageError for inputs beyond the range the design declares: its figures would be those of another design.
    """
    bundle, library = compiled(words)
    lanes, updates = inputs.shape[:2]
    declared = float(bundle.facts.known.rate if before is not None else bundle.facts.known.increment)
    largest = float(np.sqrt((inputs**2).sum(axis=-1).max()))
    if largest > declared * ROUNDED:
        raise UsageError(f"the motion reaches {largest:.4g} in a sample, the design declares {declared:.4g}")
    restart = np.full((lanes, updates), GO_ON, np.int32)
    restart[:, 0] = SET
    attitude: NDArray[Any] = np.zeros((lanes, updates, bundle.driver.attitude_size))
    attitude[:, 0] = in_form(start, bundle.driver.setter, bundle.facts.design.euler)
    first = np.zeros((lanes, updates, 3))
    if before is not None:
        first[:, 0] = before
    produced, _ = verify.c_words(bundle, library, in_words(bundle, restart, attitude, first, inputs))
    return {**outputs_of(bundle, produced), "kept": _kept(bundle, produced)}


def as_given(words: Options, attitudes: Array) -> Array:
    """Return unit quaternions (n, 4) as a design of quaternions takes them: rounded."""
    bundle, _ = compiled(words)
    return from_words(bundle, "q_nb", to_words(bundle, "q_nb", attitudes))


def _kept(bundle: Bundle, produced: NDArray[Any]) -> Array:
    """Return the attitude as the state keeps it, what is carried of a float's rounding with it."""
    held, *others = bundle.machine.state
    kept: Array = produced[..., : held.size].astype(np.float64)
    if held.format is not None:
        return np.ldexp(kept, -held.format.fraction)
    if others and others[0].name == "residual":
        carried = others[0].size
        kept[..., :carried] -= produced[..., held.size : held.size + carried]
    return kept
