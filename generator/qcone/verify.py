"""Verify: do the readings agree? The C is read back statement by statement, then run against the model.

Every word of the state and of every output after every update is compared, bit for bit, for each compiler,
optimisation level and target. A difference names its first row and what went into it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends.bittrue import Model, State, dtype_of, new_state
from qcone.backends.counts import count
from qcone.backends.expected import differences
from qcone.backends.text_counts import count_text
from qcone.bundle import Bundle, Evidence, VerifiedBundle
from qcone.errors import CheckError
from qcone.ir.statement import Program, Role
from qcone.outcomes import Outcome, describe_first, differing_bits, judged, named
from qcone.targets.build import CompileError, build_shared
from qcone.targets.compiler import LEVELS, Compiler, absent, compilers, first_compiler
from qcone.targets.host import Library
from qcone.targets.sanitize import run_sanitized
from qcone.unit_words import handed, settings, stage_words, unit_rows
from qcone.vectors import Vectors, draw
from qcone.words import TYPES

ACCEPT_ROWS = 2000
SANITIZED_LEVEL = "-O1"


def accept(bundle: Bundle, cc: str | None = None) -> VerifiedBundle:
    """Read the text back, compile it once at -O2 and compare 2,000 rows; return what may be written.

    Raises CheckError when the text or a bit differs, MissingToolError when there is no compiler.
    """
    read_back(bundle)
    compiler = first_compiler(cc)
    vectors = draw(bundle, ACCEPT_ROWS)
    outcome = _compare(bundle, compiler, "-O2", (), vectors, model_words(bundle, vectors))
    if outcome.failed:
        raise CheckError(f"{bundle.name}: not written: {outcome.status}: {outcome.first_difference}")
    return VerifiedBundle(bundle, Evidence(vectors.rows, 0, outcome.compiler, "-O2"))


def read_back(bundle: Bundle) -> None:
    """Raise CheckError unless the C text says, statement by statement and count by count, what the routines say."""
    found = differences(bundle.machine, bundle.facts.number, bundle.header, bundle.source)
    if found:
        raise CheckError(f"{bundle.name}: the C text is not the routine: {found[0]}")
    text = count_text(bundle.header, bundle.source)
    for name, levels in bundle.facts.counts.items():
        if not count(bundle.machine.routine(name)) == levels["emitted"] == text[f"{bundle.name}_{name}"]:
            raise CheckError(f"{bundle.name}: {name}: the counts of report, routine and text do not reconcile")


def verify(
    bundle: Bundle, rows: int, cc: str | None = None, cflags: Sequence[str] = (), seed: int = 1
) -> Iterator[Outcome]:
    """Yield one outcome for each compiler and level, for the sanitizers, and for compilers that are absent."""
    try:
        read_back(bundle)
    except CheckError as error:
        yield Outcome(bundle.name, "none", first_difference=str(error), status="refused")
        return
    vectors = draw(bundle, rows, seed)
    expected = model_words(bundle, vectors)
    chosen = (first_compiler(cc),) if cc else compilers() or (first_compiler(),)
    work = [(compiler, level) for compiler in chosen for level in LEVELS]
    _build_ahead(bundle, work, cflags)
    for compiler, level in work:
        yield _compare(bundle, compiler, level, cflags, vectors, expected)
    for compiler in chosen:
        yield from _sanitized(bundle, compiler, cflags, vectors, expected)
    if not cc:
        for family in absent():
            yield Outcome(bundle.name, family, status="absent")


def _build_ahead(bundle: Bundle, work: Iterable[tuple[Compiler, str]], cflags: Sequence[str]) -> None:
    """Compile everything at once, so that what follows finds it built."""
    with ThreadPoolExecutor(max_workers=2) as pool:
        for each in [pool.submit(build_shared, compiler, bundle.sources, level, cflags) for compiler, level in work]:
            each.exception()


def model_words(bundle: Bundle, vectors: Vectors) -> NDArray[Any]:
    """Run the bit-true model; return (lanes, steps, words): the state, then every output, after each update."""
    if bundle.macs is None:
        return _run_model(bundle, bundle.machine, vectors)
    words, summed = (_run_model(bundle, program, vectors) for program in (bundle.machine, bundle.macs))
    if not np.array_equal(words, summed):
        raise CheckError(f"{bundle.name}: the integer operations do not give what their sums of products give")
    return words


def _run_model(bundle: Bundle, program: Program, vectors: Vectors) -> NDArray[Any]:
    number = bundle.facts.number
    model = Model(program, number)
    lanes, steps = vectors.restart.shape
    state = new_state(program, number, lanes)
    words = np.empty((steps, bundle.driver.word_count, lanes), dtype_of(number))
    given = bundle.machine.routine("update").having(Role.INPUT)[0].name
    with np.errstate(all="ignore"):
        for step in range(steps):
            restart_lanes(model, bundle, state, vectors, step)
            model.run("update", state, {given: np.ascontiguousarray(vectors.inputs[:, step].T)})
            reported = [each for name, _ in bundle.driver.outputs for each in model.run(name, state).values()]
            reported += stage_words(model, bundle, state, unit_rows(vectors, step)[0])
            np.concatenate([*state.values(), *reported], out=words[step], casting="unsafe")
    return np.ascontiguousarray(words.transpose(2, 0, 1))


def restart_lanes(model: Model, bundle: Bundle, state: State, vectors: Vectors, step: int) -> None:
    """Set anew the lanes that the vectors restart before a step."""
    _, harmonics = unit_rows(vectors, step)
    for kind, name in settings(bundle):
        chosen = vectors.restart[:, step] == kind
        if not chosen.any():
            continue
        part = {block: array[:, chosen] for block, array in state.items()}
        model.run(name, part, handed(bundle, name, vectors.attitude[chosen, step], harmonics[chosen]))
        if bundle.driver.has_start:
            model.run("start", part, {"omega": vectors.before[chosen, step].T})
        for block, array in part.items():
            state[block][:, chosen] = array


def c_words(bundle: Bundle, library: Library, vectors: Vectors) -> tuple[NDArray[Any], int]:
    """Run the compiled C on the vectors; return the same words, and what the probe says of the build."""
    arrays = run_arrays(bundle, vectors)
    library.run(f"{bundle.name}_run", vectors.rows, *arrays.values())
    return arrays["words"], int(arrays["probed"][0])


def run_arrays(bundle: Bundle, vectors: Vectors) -> dict[str, NDArray[Any]]:
    """Return what the batch loop takes after the number of rows, in order; it writes the last two."""
    return {
        **given_arrays(bundle, vectors),
        "words": np.zeros((*vectors.restart.shape, bundle.driver.word_count), TYPES[bundle.driver.word_ctype]),
        "probed": np.zeros(1, np.int32),
    }


def given_arrays(bundle: Bundle, vectors: Vectors) -> dict[str, NDArray[Any]]:
    """Return what the batch loop reads, in order."""
    given = {
        "restart": vectors.restart,
        "attitude": vectors.attitude,
        "before": vectors.before,
        "input": vectors.inputs,
    }
    if bundle.driver.stage:
        given |= dict(zip(("encoder", "correction"), map(np.ascontiguousarray, vectors.unit), strict=True))
    return given


def declaration(bundle: Bundle) -> str:
    """Return the C declaration of the batch loop."""
    driver, ctype = bundle.driver, bundle.driver.ctype
    unit = f"const {ctype} *encoder, const {ctype} *correction, " if driver.stage else ""
    return (
        f"void {bundle.name}_run(int32_t rows, const int32_t *restart, const {ctype} *attitude, "
        f"const {ctype} *before, const {driver.input_ctype} *input, {unit}{driver.word_ctype} *words, "
        "int32_t *contracted);"
    )


def open_library(bundle: Bundle, compiler: Compiler, level: str, cflags: Sequence[str] = ()) -> Library:
    """Compile the design and its batch loop and open the result."""
    return Library(build_shared(compiler, bundle.sources, level, cflags), declaration(bundle))


def _compare(
    bundle: Bundle,
    compiler: Compiler,
    level: str,
    cflags: Sequence[str],
    vectors: Vectors,
    expected: NDArray[Any],
) -> Outcome:
    words, probed = c_words(bundle, open_library(bundle, compiler, level, cflags), vectors)
    return judged(Outcome(bundle.name, named(compiler), level), bundle, vectors, words, expected, probed)


def _sanitized(
    bundle: Bundle, compiler: Compiler, cflags: Sequence[str], vectors: Vectors, expected: NDArray[Any]
) -> Iterator[Outcome]:
    data = b"".join(
        np.ascontiguousarray(each).tobytes()
        for each in (np.array([vectors.rows], np.int32), *given_arrays(bundle, vectors).values())
    )
    done = Outcome(bundle.name, named(compiler), SANITIZED_LEVEL, "host", vectors.rows)
    try:
        report = run_sanitized(compiler, bundle.sources, SANITIZED_LEVEL, bundle.main, data, cflags)
    except CompileError as error:
        yield replace(done, first_difference=str(error), status="refused")
        return
    if not report.available:
        return
    words, first, differing = np.frombuffer(report.output, expected.dtype), report.first or None, None
    if words.size == expected.size:
        words = words.reshape(expected.shape)
        differing = differing_bits(words, expected)
        first = first or (describe_first(bundle, vectors, words, expected) if differing else None)
    else:
        first = first or f"the program wrote {words.size} words, not {expected.size}"
    status = "reports" if report.reports else "differs" if differing != 0 else "ok"
    yield replace(
        done,
        compiler=f"{done.compiler} {'+'.join(report.sanitizers)}",
        differing_bits=differing,
        first_difference=first,
        sanitizer_reports=report.reports,
        status=status,
    )
