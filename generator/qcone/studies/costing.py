"""Measure what designs cost on targets, hold it against their budgets, and lay it out as rows."""

from __future__ import annotations

import re
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from qcone import cost, verify
from qcone.bundle import Bundle, digest
from qcone.design import Design
from qcone.errors import CheckError, UsageError
from qcone.on_target import Emulations
from qcone.pipeline import build
from qcone.studies.selection import Say
from qcone.studies.verifying import WORKERS, flags_of
from qcone.targets.compiler import LEVELS, Compiler
from qcone.targets.cross import check_suits, cross_compiler, suits
from qcone.targets.cycles import MODELS
from qcone.targets.emulation import NotMeasuredError
from qcone.targets.machines import TARGETS, Target, targets_of

Row = dict[str, object]


@dataclass(frozen=True)
class Request:
    """What is to be measured: targets, compiler and levels, or the user's own program `elf`."""

    targets: tuple[Target, ...]
    compiler: Compiler | None
    cflags: tuple[str, ...]
    levels: tuple[str | None, ...]
    elf: Path | None


@dataclass(frozen=True)
class Line:
    """The cost of one design on one target as a flat row; `source` is the digest of the code that was measured.

    `more` is kept beside the row: what needs no column.
    """

    row: Row
    source: str
    more: Row
    measured: bool = True


@dataclass
class Found:
    """Every line, what is wrong, and whether something could not be measured."""

    lines: list[Line] = field(default_factory=list)
    failed: bool = False
    missing: bool = False


def request(target: str, cc: str | None, cflags: str, level: str, elf: Path | None) -> Request:
    """Check what was asked for. Raises UsageError, or MissingToolError when there is no compiler."""
    targets = targets_of(target)
    levels = tuple(level.split(","))
    for word in levels:
        if word not in LEVELS:
            raise UsageError(f"--level {word}: the levels are {', '.join(LEVELS)}")
    if target == "all":
        targets = tuple(each for each in targets if each.emulated)
    elif TARGETS["host"] in targets:
        raise UsageError("--target host: what an update costs is measured on the other targets; name one of them")
    if elf is not None:
        if len(targets) != 1:
            raise UsageError("--elf: say which one target the program is for, as in --target cortex-m4f")
        for given, option in ((cc, "--cc"), (cflags, "--cflags")):
            if given:
                raise UsageError(f"{option} {given}: the program of --elf is built already; leave it out")
        return Request(targets, None, (), (None,), elf)
    compiler = cross_compiler(cc)
    if target == "all":
        targets = tuple(each for each in targets if suits(compiler, each))
    for each in targets:
        check_suits(compiler, each)
    if not targets:
        raise UsageError(f"--cc {compiler.name}: it compiles for {compiler.machine}, which is no target")
    return Request(targets, compiler, flags_of(cflags), levels, None)


def measure_designs(designs: Iterable[Design], asked: Request, say: Say) -> Found:
    """Measure every design on every target; say what does not fit into a row, and how cycles were counted.

    What is wrong with one design and target (a budget, a gate, other bits) is said, and the rest measured.
    """
    found = Found()
    met: dict[str, None] = {}
    with Emulations() as emulations, ThreadPoolExecutor(WORKERS) as pool:
        for design in designs:
            bundle = build(design)
            verify.read_back(bundle)
            work = [(target, level) for target in asked.targets for level in asked.levels]
            for (target, level), result in zip(
                work, pool.map(partial(_one, bundle, asked, emulations), work), strict=True
            ):
                _take(found, bundle, target, level, result, say)
                met.update({target.cycles: None} if target.cycles else {})
            _say_libraries(found, bundle.name, say)
    for model in met:
        say(f"cycles on {model}: an estimate from the table of the core's manual: {MODELS[model].assumptions}")
    return found


def _one(
    bundle: Bundle, asked: Request, emulations: Emulations, work: tuple[Target, str | None]
) -> cost.Cost | CheckError | NotMeasuredError:
    target, level = work
    try:
        with emulations.one() as emulation:
            if asked.elf is not None:
                return cost.measure_elf(bundle, target, asked.elf, emulation)
            assert asked.compiler
            assert level
            return cost.measure(bundle, target, asked.compiler, level, emulation, asked.cflags)
    except (CheckError, NotMeasuredError) as error:
        return error


def _take(
    found: Found,
    bundle: Bundle,
    target: Target,
    level: str | None,
    result: cost.Cost | CheckError | NotMeasuredError,
    say: Say,
) -> None:
    if isinstance(result, CheckError):
        say(str(result), "error")
        found.failed = True
        return
    if isinstance(result, NotMeasuredError):
        say(f"{bundle.name} on {target.name}: {result}", "error")
        found.missing = True
        found.lines.append(
            Line(_empty(bundle.name, target.name, level), code_digest(bundle.source), {}, measured=False)
        )
        return
    row = _row(result)
    where = f"{bundle.name} on {target.name}"
    for finding in result.findings:
        say(f"{where}: {finding.gate}: {finding.text}", "error")
        found.failed = True
    for key, allowed in bundle.facts.design.target_budgets.get(target.name, {}).items():
        taken = row[key]
        if isinstance(taken, int) and taken > allowed:
            say(f"{where}: {key} is {taken}, over the budget of {allowed}: cheapen the design or raise it", "error")
            found.failed = True
    if result.reconciliation is not None and not result.reconciliation.holds:
        say(f"{where}: {result.reconciliation.text}", "warning")
    found.lines.append(Line(row, code_digest(bundle.source), _more(result)))


def code_digest(source: str) -> str:
    """Return the digest of C text without its comments, which cost nothing, and whatever space it is set with."""
    return digest(" ".join(re.sub(r"/\*.*?\*/", " ", source, flags=re.DOTALL).split()))


def _say_libraries(found: Found, design: str, say: Say) -> None:
    own = [each for each in found.lines if each.row["design"] == design and each.more.get("library_bytes")]
    if own:
        words = ", ".join(f"{each.row['target']} {each.row['level']} {each.more['library_bytes']}" for each in own)
        say(f"{design}: bytes of the compiler's own routines, not in text_bytes: {words}")


def _empty(design: str, target: str, level: str | None) -> Row:
    return {
        "design": design,
        "target": target,
        "compiler": None,
        "level": level,
        "instructions_min": None,
        "instructions_max": None,
        "text_bytes": None,
        "rodata_bytes": None,
        "stack_bytes": None,
        "cycles_low": None,
        "cycles_high": None,
        "calls": None,
        "fused": None,
        "soft_float": None,
    }


def _row(found: cost.Cost) -> Row:
    ran = found.executed
    low, high = ran.cycles or (None, None)
    return _empty(found.design, found.target.name, found.level) | {
        "compiler": found.compiler,
        "instructions_min": ran.instructions[0],
        "instructions_max": ran.instructions[1],
        "text_bytes": found.text_bytes,
        "rodata_bytes": found.read_only_bytes,
        "stack_bytes": found.stack_bytes,
        "cycles_low": low,
        "cycles_high": high,
        "calls": ", ".join(ran.routines),
        "fused": ", ".join(ran.fused),
        "soft_float": ", ".join(found.soft_float),
    }


def _more(found: cost.Cost) -> Row:
    return {
        "library_bytes": found.library_bytes,
        "updates": found.executed.updates,
        "cycles_assume": MODELS[found.target.cycles].assumptions if found.target.cycles else None,
        "operations": found.reconciliation.text if found.reconciliation else None,
    }
