"""Verify designs on targets and lay the outcomes out as rows."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from difflib import get_close_matches

from qcone import verify
from qcone.design import TARGETS, Design
from qcone.errors import UsageError
from qcone.pipeline import build

AVAILABLE = ("host",)


@dataclass(frozen=True)
class Line:
    """One outcome as a flat row, and whether it is a failure."""

    row: dict[str, object]
    failed: bool


def verify_designs(
    designs: Iterable[Design], target: str, rows: int, cc: str | None = None, cflags: str = "", seed: int = 1
) -> Iterator[Line]:
    """Yield one line for each design, compiler and level. Raises UsageError for a target there is not."""
    check_target(target)
    try:
        flags = tuple(shlex.split(cflags))
    except ValueError as error:
        raise UsageError(f"--cflags {cflags!r}: {error}") from error
    for design in designs:
        for outcome in verify.verify(build(design), rows, cc, flags, seed):
            yield Line(
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
            )


def check_target(names: str) -> None:
    """Raise UsageError for a target that is unknown or not available in this version."""
    for name in [] if names == "all" else names.split(","):
        if name in AVAILABLE:
            continue
        if name in TARGETS:
            raise UsageError(f"--target {name}: not available in this version; choose {', '.join(AVAILABLE)}")
        close = get_close_matches(name, (*TARGETS, "all"), 1)
        hint = f"did you mean '{close[0]}'?" if close else f"the targets are: {', '.join(TARGETS)}"
        raise UsageError(f"--target {name}: unknown target; {hint}")
