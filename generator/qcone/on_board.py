"""Verify on a board that qemu plays: the same vectors and words as on the other executor, by another emulator."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends.page import board_main
from qcone.bundle import Bundle
from qcone.outcomes import NOT_MEASURED, Outcome, judged, named
from qcone.stepwise import model_steps
from qcone.targets import qemu
from qcone.targets.compiler import Compiler
from qcone.targets.cross import LEVEL
from qcone.targets.emulation import NotMeasuredError
from qcone.targets.machines import Target
from qcone.vectors import Vectors
from qcone.verify import run_arrays


def verify_on_board(
    bundle: Bundle, target: Target, compiler: Compiler, vectors: Vectors, cflags: Sequence[str] = ()
) -> Outcome:
    """Return the outcome of one design on a target's board; `absent` where qemu is not installed.

    Raises CompileError. A qemu that fails, or writes fewer words than rows, is the outcome not-measured.
    """
    version = qemu.version()
    if version is None:
        return Outcome(bundle.name, qemu.PROGRAM, target=target.name, first_difference=qemu.FIX, status="absent")
    outcome = Outcome(bundle.name, f"{named(compiler)} on qemu {version}", LEVEL, target.name)
    arrays = run_arrays(bundle, vectors)
    files = {**bundle.sources, "board.c": board_main(bundle.driver)}
    try:
        data = qemu.run(compiler, target, files, rows_of(vectors), cflags)
    except NotMeasuredError as error:
        return replace(outcome, first_difference=str(error), status=NOT_MEASURED)
    words, probed = arrays["words"], arrays["probed"]
    if len(data) != words.nbytes + probed.nbytes:
        said = f"not measured: {len(data)} bytes written, not {words.nbytes + probed.nbytes}"
        return replace(outcome, first_difference=said, status=NOT_MEASURED)
    words = np.frombuffer(data, words.dtype, words.size).reshape(words.shape)
    mask = int(np.frombuffer(data, probed.dtype, 1, words.nbytes)[0])
    return judged(outcome, bundle, vectors, words, model_steps(bundle, vectors, words), mask)


def _unit(vectors: Vectors) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return angles (n, 1) and harmonics (n, 9) of a rotating unit."""
    angles, harmonics = vectors.unit
    return angles[0, :, np.newaxis], harmonics[0]


def rows_of(vectors: Vectors) -> bytes:
    """Return the rows of the only lane as structures of C, one after another."""
    parts = {
        "attitude": vectors.attitude[0],
        "before": vectors.before[0],
        "input": vectors.inputs[0],
        **({} if vectors.encoder is None else dict(zip(("encoder", "correction"), _unit(vectors), strict=True))),
        "restart": vectors.restart[0],
    }
    layout = [(name, part.dtype.newbyteorder("<"), part.shape[1:]) for name, part in parts.items()]
    records = np.zeros(vectors.rows, np.dtype(layout, align=True))
    for name, part in parts.items():
        records[name] = part
    return records.tobytes()
