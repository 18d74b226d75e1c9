"""Verify on an AVR: that the C compiles for it, and, where its tools are installed, that the bits are the model's."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from qcone.backends.page import avr_main
from qcone.bundle import Bundle
from qcone.on_board import rows_of
from qcone.outcomes import COMPILES, NOT_MEASURED, Outcome, judged, named
from qcone.stepwise import model_steps
from qcone.targets import avr
from qcone.targets.build import CompileError
from qcone.targets.compiler import Compiler
from qcone.targets.emulation import NotMeasuredError
from qcone.vectors import draw_chain
from qcone.verify import run_arrays


def verify_on_avr(bundle: Bundle, compiler: Compiler, seed: int = 1) -> Iterator[Outcome]:
    """Yield the outcome of compiling with zig, then that of running under simavr, or that it is absent."""
    sources = {name: text for name, text in bundle.sources.items() if not name.endswith("_run.c")}
    outcome = Outcome(bundle.name, named(compiler), avr.LEVEL, avr.NAME, status=COMPILES)
    try:
        avr.compile_check(compiler, sources)
    except CompileError as error:
        yield replace(outcome, first_difference=_first_error(error), status="refused")
        return
    yield outcome
    if not avr.present():
        yield Outcome(bundle.name, avr.SIMULATOR, target=avr.NAME, first_difference=avr.FIX, status="absent")
        return
    gcc = avr.cross_gcc()
    ran = replace(outcome, compiler=f"{named(gcc)} on {avr.SIMULATOR}")
    vectors = draw_chain(bundle, 1000, seed)
    count = min(vectors.rows, avr.VECTOR_BYTES * vectors.rows // len(rows_of(vectors)))
    vectors = vectors.first(count)
    words = run_arrays(bundle, vectors)["words"]
    try:
        data = avr.run(gcc, {**sources, "avr.c": avr_main(bundle.driver)}, rows_of(vectors), count)
    except NotMeasuredError as error:
        yield replace(ran, first_difference=str(error), status=NOT_MEASURED)
        return
    if len(data) != words.nbytes:
        said = f"not measured: {len(data)} bytes written, not {words.nbytes}"
        yield replace(ran, first_difference=said, status=NOT_MEASURED)
        return
    words = np.frombuffer(data, words.dtype).reshape(words.shape)
    yield replace(judged(ran, bundle, vectors, words, model_steps(bundle, vectors, words), 0), contracted=None)


def _first_error(error: CompileError) -> str:
    return next((line for line in error.said.splitlines() if "error" in line), error.said[:200])
