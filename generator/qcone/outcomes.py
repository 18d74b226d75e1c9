"""Outcomes: what was found when C and model were compared, and how a difference is told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.bundle import Bundle
from qcone.targets.compiler import Compiler
from qcone.targets.probe import CONTRACTED, FLUSHED, SLP_CONTRACTED
from qcone.vectors import Vectors

NOT_MEASURED, COMPILES = "not-measured", "compiles"

_FUSES = "the build fuses products and sums: compile with -ffp-contract=off"
_FLUSHES = (
    "flush-to-zero is on: subnormal numbers become 0, and components between 0 and 2^-48 may lose bits; switch it off"
)


@dataclass(frozen=True)
class Outcome:
    """One line of `qcone verify`.

    `status` is ok, differs, contracted, flushed, reports, refused, absent; on targets also soft-float, stray-double,
    faults, not-measured, and compiles, where nothing ran.
    """

    design: str
    compiler: str
    level: str | None = None
    target: str = "host"
    rows: int | None = None
    differing_bits: int | None = None
    first_difference: str | None = None
    sanitizer_reports: int | None = None
    contracted: bool | None = None
    status: str = "ok"

    @property
    def failed(self) -> bool:
        """Tell whether this line is a failure; an absent compiler is not one, nor what could not be measured."""
        return self.status not in ("ok", "absent", COMPILES, NOT_MEASURED)


def judged(
    outcome: Outcome, bundle: Bundle, vectors: Vectors, words: NDArray[Any], expected: NDArray[Any], probed: int
) -> Outcome:
    """Return an outcome with the differing bits of `words`, the first difference, and what the probe says."""
    differing = differing_bits(words, expected)
    first = [describe_first(bundle, vectors, words, expected)] if differing else []
    contracted, status = bool(probed & (CONTRACTED | SLP_CONTRACTED)), "differs" if differing else "ok"
    if probed & FLUSHED:
        status, first = "flushed", [_FLUSHES, *first]
    if contracted:
        status, first = "contracted", [_FUSES, *first]
    return replace(
        outcome,
        rows=vectors.rows,
        differing_bits=differing,
        first_difference="; ".join(first) or None,
        contracted=contracted,
        status=status,
    )


def named(compiler: Compiler) -> str:
    """Return what reports call a compiler: its name and version."""
    return f"{compiler.name} {compiler.version}".strip()


def differing_bits(words: NDArray[Any], expected: NDArray[Any]) -> int:
    """Count the bits in which two arrays of the same type differ."""
    return int(np.bitwise_count(_difference(words, expected)).sum())


def _difference(words: NDArray[Any], expected: NDArray[Any]) -> NDArray[Any]:
    """Return the words' bits that differ; sign and payload of a NaN are unspecified, so two NaN are the same."""
    kind = np.uint32 if words.dtype == np.float32 else np.uint64
    difference: NDArray[Any] = words.view(kind) ^ expected.view(kind)
    difference[np.isnan(words) & np.isnan(expected)] = 0
    return difference


PARTS = {3: ("roll", "pitch", "yaw"), 4: tuple("wxyz"), 9: tuple(f"{row}{column}" for row in "123" for column in "123")}
"""What the words of an output are, by their number."""
TURN = {"correct": ("angle", "tilt x", "tilt y")}
"""What the words of a rotating unit's correction are."""


def word_names(bundle: Bundle) -> list[str]:
    """Return what each word of a row is."""
    cast = f"({bundle.driver.word_ctype})"
    names = [word.replace(cast, "").removeprefix("state.") for word in bundle.driver.state_words]
    return names + [f"{name} {part}" for name, size in bundle.driver.reported for part in TURN.get(name, PARTS[size])]


def describe_first(bundle: Bundle, vectors: Vectors, words: NDArray[Any], expected: NDArray[Any]) -> str:
    """Say where C and model differ first, with the operands of that update."""
    different = _difference(words, expected) != 0
    lanes, steps = np.nonzero(different.any(axis=2))
    at = int(np.argmin(steps))
    lane, step = int(lanes[at]), int(steps[at])
    word = int(np.argmax(different[lane, step]))
    state: Sequence[float] = list(expected[lane, step - 1, : len(bundle.driver.state_words)]) if step else []
    unit = [vectors.unit[0][lane, step]] if bundle.driver.stage else []
    operands = ", ".join(map(_shown, [*vectors.inputs[lane, step], *unit]))
    before = ", ".join(map(_shown, state))
    return (
        f"lane {lane}, step {step}, {word_names(bundle)[word]}: C {_shown(words[lane, step, word])}, model "
        f"{_shown(expected[lane, step, word])}; input {operands}; state before {before or 'a restart'}"
    )


def _shown(word: Any) -> str:
    """Return a word as it is compared: the bits of a float, the raw integer of fixed point."""
    return str(int(word)) if isinstance(word, np.integer) else float(word).hex()
