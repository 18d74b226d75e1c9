"""Replay: run the generated, compiled C of a design on recorded or simulated motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone import outcomes, verify
from qcone.bundle import Bundle
from qcone.errors import CheckError, UsageError
from qcone.ir.statement import Role
from qcone.studies.recording import Recording, Updates, split_updates
from qcone.targets.compiler import first_compiler
from qcone.targets.probe import CONTRACTED, SLP_CONTRACTED
from qcone.vectors import GO_ON, SET, Vectors, in_form, in_words
from qcone.words import from_words

IDENTITY = (1.0, 0.0, 0.0, 0.0)
LEVEL = "-O2"
RATE_TOLERANCE = 0.01
UNIT_TOLERANCE = 1e-3


@dataclass(frozen=True)
class Replay:
    """What the C reports after each update: `time_s` (n,), the attitude `q` (n, 4), `notes` for the user.

    `outputs` (n, k) hold every output by its function's name: `quaternion`, `dcm`, `euler`, `error_estimate`.
    """

    time_s: NDArray[np.float64]
    q: NDArray[np.float64]
    notes: tuple[str, ...]
    outputs: Mapping[str, NDArray[np.float64]]
    raw: NDArray[np.int64] | None = None
    """The raw words of `q` in fixed point."""


def replay(
    bundle: Bundle,
    recording: Recording,
    initial: Sequence[float] = IDENTITY,
    cc: str | None = None,
    compare: bool = False,
) -> Replay:
    """Return the attitude along a recording, from the compiled C of `bundle`.

    `initial` is the attitude at the start, of unit length to within 0.1 %. With `compare` every word of
    every update is held against the bit-true model, and a difference raises CheckError. Raises UsageError when
    the recording does not suit the design, MissingToolError when there is no compiler.
    """
    design = bundle.facts.design
    if design.input == "increment":
        recording = recording.as_increments()
    _suits(bundle, recording)
    updates = split_updates(recording, bundle.facts.algorithm.subsamples)
    vectors = _vectors(bundle, updates, initial)
    library = verify.open_library(bundle, first_compiler(cc), LEVEL)
    words, probed = verify.c_words(bundle, library, vectors)
    notes = [*updates.notes]
    if probed & (CONTRACTED | SLP_CONTRACTED):
        notes.append("this build fuses products and sums: its bits are not the model's")
    if held := bundle.facts.algorithm.held:
        missing = "" if len(updates.values) > held else ", more than the recording makes: it has no attitude of its own"
        notes.append(f"the starter holds the attitude for the first {held} updates{missing}")
    if bundle.driver.stage:
        notes.append("the attitude is that of the turning sensors: a recording has no encoder angle")
    largest = float(np.sqrt((recording.as_increments().values ** 2).sum(axis=1).max()))
    declared = float(bundle.facts.known.rate if recording.kind == "rate" else bundle.facts.known.increment)
    if largest > declared * (1 + 1e-9):
        unit = "rad/s" if recording.kind == "rate" else "rad"
        notes.append(
            f"the recording reaches {largest:.4g} {unit}, design '{design.name}' declares {declared:.4g}: "
            "accuracy is lost there"
        )
    if compare:
        expected = verify.model_words(bundle, vectors)
        differing = outcomes.differing_bits(words, expected)
        if differing:
            raise CheckError(f"{differing} bits differ: {outcomes.describe_first(bundle, vectors, words, expected)}")
        notes.append(f"0 differing bits against the bit-true model in {vectors.rows} updates")
    outputs = {name: each[0] for name, each in outputs_of(bundle, words).items()}
    return Replay(updates.time_s, outputs["quaternion"], tuple(notes), outputs, _raw(bundle, words))


def vectors_of(bundle: Bundle, recording: Recording, initial: Sequence[float]) -> Vectors:
    """Return a recording as the rows a design is run on. Raises UsageError when the recording does not suit it."""
    if bundle.facts.design.input == "increment":
        recording = recording.as_increments()
    _suits(bundle, recording)
    return _vectors(bundle, split_updates(recording, bundle.facts.algorithm.subsamples), initial)


def outputs_of(bundle: Bundle, words: NDArray[Any]) -> dict[str, NDArray[np.float64]]:
    """Return the outputs (lanes, steps, k) by name, of the words (lanes, steps, words) a run wrote."""
    found, first = {}, len(bundle.driver.state_words)
    for name, size in bundle.driver.reported:
        block = bundle.machine.routine(name).having(Role.OUTPUT)[0]
        found[name] = from_words(bundle, block.name, words[..., first : first + size])
        first += size
    return found


def _raw(bundle: Bundle, words: NDArray[Any]) -> NDArray[np.int64] | None:
    """Return the raw words of the reported quaternion (steps, 4); None for floats."""
    if bundle.macs is None:
        return None
    first = len(bundle.driver.state_words)
    for name, size in bundle.driver.outputs:
        if name == "quaternion":
            break
        first += size
    return words[0, :, first : first + 4].astype(np.int64)


def _suits(bundle: Bundle, recording: Recording) -> None:
    design = bundle.facts.design
    wanted = design.input
    if recording.kind != wanted:
        read = f"the recording was read as {recording.kind.removesuffix('s')}s"
        raise UsageError(f"design '{design.name}' takes input = \"{design.input}\", {read}")
    if recording.quantum_dps is not None and recording.quantum_dps != design.imu.quantum_dps:
        raise UsageError(
            f"design '{design.name}' takes counts of {design.imu.quantum_dps} deg/s, the recording has counts of "
            f"{recording.quantum_dps} deg/s"
        )
    expected = design.imu.update_hz * bundle.facts.algorithm.subsamples
    if abs(recording.sample_hz / expected - 1) > RATE_TOLERANCE:
        raise UsageError(
            f"{recording.source}: {float(recording.sample_hz):.6g} samples a second, but design '{design.name}' "
            f"is made for {float(expected):.6g}: resample with --resample {float(expected):.6g}, or change update_hz"
        )


def _vectors(bundle: Bundle, updates: Updates, initial: Sequence[float]) -> Vectors:
    start = np.asarray(initial, np.float64)
    length = float(np.linalg.norm(start))
    if start.shape != (4,) or not abs(length - 1) <= UNIT_TOLERANCE:
        raise UsageError(f"--initial: w,x,y,z must be a unit quaternion, its length is {length:.6g}")
    rows = len(updates.values)
    restart = np.full((1, rows), GO_ON, np.int32)
    restart[0, 0] = SET
    attitude: NDArray[Any] = np.zeros((1, rows, bundle.driver.attitude_size))
    attitude[0, 0] = in_form(start / length, bundle.driver.setter, bundle.facts.design.euler)
    before = np.zeros((1, rows, 3))
    if updates.start is not None:
        before[0, 0] = updates.start
    return in_words(bundle, restart, attitude, before, updates.values.reshape(1, rows, -1, 3))


def angles_between(p: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angle in rad between attitudes row by row, (n, 4) each; good to the last digit when small."""
    p = p / np.linalg.norm(p, axis=1, keepdims=True)
    q = q / np.linalg.norm(q, axis=1, keepdims=True)
    near = np.linalg.norm(p - q * np.where((p * q).sum(axis=1) < 0, -1, 1)[:, None], axis=1)
    angle: NDArray[np.float64] = 4 * np.arcsin(np.minimum(near / 2, 1))
    return angle
