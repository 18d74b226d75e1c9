"""Verify designs on targets and lay the outcomes out as rows."""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from qcone import on_avr, on_board, on_target, verify
from qcone.bundle import Bundle
from qcone.design import Design
from qcone.errors import UsageError
from qcone.outcomes import NOT_MEASURED, Outcome
from qcone.pipeline import build
from qcone.studies import ranges_used
from qcone.targets.cross import check_suits, cross_compiler, suits
from qcone.targets.machines import NONE, TARGETS, Target, targets_of
from qcone.targets.qemu import boards_for
from qcone.vectors import draw, draw_chain

HOST_ROWS = 100_000
WORKERS = max(1, min(4, os.cpu_count() or 1))


@dataclass(frozen=True)
class Request:
    """What is asked of a verification, in the words of the command line; `rows` None means the usual number."""

    target: str = "host"
    rows: int | None = None
    cc: str | None = None
    cflags: str = ""
    seed: int = 1
    executor: str = "unicorn"
    flush: bool = False


@dataclass(frozen=True)
class Line:
    """One outcome as a flat row, whether it is a failure, and whether anything was measured at all."""

    row: dict[str, object]
    failed: bool
    measured: bool = True


def ranges_of(designs: Iterable[Design], rows: int | None, seed: int) -> Iterator[dict[str, object]]:
    """Yield the bits that every value of fixed-point designs uses. Raises UsageError for a design of floats."""
    for design in designs:
        bundle = build(design)
        yield from ranges_used.rows(bundle, draw(bundle, rows or HOST_ROWS, seed))


def verify_designs(designs: Iterable[Design], request: Request) -> Iterator[Line]:
    """Yield one line for each design, target, compiler and level.

    Raises UsageError for a target there is not or an option that does not go with it, MissingToolError when the extra
    for targets is not installed.
    """
    if request.executor == "simavr":
        yield from map(_line, _on_avr(designs, request))
        return
    targets = _targets(request)
    flags = flags_of(request.cflags)
    emulated = tuple(each for each in targets if each.emulated)
    with on_target.Emulations() as emulations, ThreadPoolExecutor(WORKERS) as pool:
        for bundle in map(build, designs):
            if TARGETS["host"] in targets:
                for outcome in verify.verify(bundle, request.rows or HOST_ROWS, request.cc, flags, request.seed):
                    yield _line(outcome)
            if emulated:
                yield from map(_line, _on_targets(bundle, emulated, request, flags, emulations, pool))


def _targets(request: Request) -> tuple[Target, ...]:
    """Return the targets asked for that the compiler and the executor can serve."""
    targets = targets_of(request.target)
    if request.executor == "qemu":
        targets = boards_for(targets, request.target)
    if request.cc and any(each.emulated for each in targets):
        compiler = cross_compiler(request.cc)
        if request.target == "all":
            targets = tuple(each for each in targets if each.emulated and suits(compiler, each))
        for each in targets:
            if each.emulated:
                check_suits(compiler, each)
    if request.flush:
        _check_flush(targets, request)
    return targets


def _on_avr(designs: Iterable[Design], request: Request) -> Iterator[Outcome]:
    given = {
        f"--target {request.target}": request.target != "host",
        f"--cc {request.cc}": request.cc,
        f"--cflags {request.cflags}": request.cflags,
        f"--rows {request.rows}": request.rows,
        "--flush-to-zero": request.flush,
    }
    for option in (option for option, is_given in given.items() if is_given):
        raise UsageError(f"{option}: --executor simavr plays one AVR, in its own way; leave the option out")
    compiler = cross_compiler()
    for bundle in map(build, designs):
        verify.read_back(bundle)
        yield from on_avr.verify_on_avr(bundle, compiler, request.seed)


def _check_flush(targets: Iterable[Target], request: Request) -> None:
    if request.executor == "qemu":
        raise UsageError("--flush-to-zero: only the executor unicorn has it; leave --executor out")
    for each in targets:
        if each.architecture != "arm" or each.fpu == NONE:
            able = ", ".join(name for name, one in TARGETS.items() if one.architecture == "arm" and one.fpu != NONE)
            raise UsageError(f"--flush-to-zero: {each.name} has no such mode; the targets that have it: {able}")


def _on_targets(
    bundle: Bundle,
    targets: tuple[Target, ...],
    request: Request,
    flags: tuple[str, ...],
    emulations: on_target.Emulations,
    pool: ThreadPoolExecutor,
) -> Iterator[Outcome]:
    compiler = cross_compiler(request.cc)
    verify.read_back(bundle)
    vectors = draw_chain(bundle, request.rows or on_target.ROWS, request.seed)

    def outcome(target: Target) -> Outcome:
        if request.executor == "qemu":
            return on_board.verify_on_board(bundle, target, compiler, vectors, flags)
        with emulations.one() as emulation:
            return on_target.verify_on(bundle, target, compiler, vectors, emulation, flags, request.flush)

    yield from pool.map(outcome, targets)


def flags_of(text: str) -> tuple[str, ...]:
    """Return the words of --cflags. Raises UsageError where a quote is not closed."""
    try:
        return tuple(shlex.split(text))
    except ValueError as error:
        raise UsageError(f"--cflags {text!r}: {error}") from error


def _line(outcome: Outcome) -> Line:
    return Line(
        {
            "design": outcome.design,
            "compiler": outcome.compiler,
            "level": outcome.level,
            "target": outcome.target,
            "rows": outcome.rows,
            "differing_bits": outcome.differing_bits,
            "first_difference": outcome.first_difference,
            "sanitizer_reports": outcome.sanitizer_reports,
            "contracted": outcome.contracted,
            "status": outcome.status,
        },
        outcome.failed,
        outcome.status != NOT_MEASURED,
    )
