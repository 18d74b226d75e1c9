"""From the text of a design file to resolved designs."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from qcone.design.catalogue import AlgorithmEntry
from qcone.design.design import Design
from qcone.design.lines import LineIndex, index_lines
from qcone.design.mistakes import did_you_mean
from qcone.design.numbers import toml_float
from qcone.design.places import FilePlaces, dotted, problems, shown
from qcone.design.resolve import resolve
from qcone.errors import DesignError, Problem, UsageError

_START = "start with a header such as [design.my_attitude]"


def read_designs(path: Path, catalogue: Sequence[AlgorithmEntry]) -> tuple[Design, ...]:
    """Read every design of the file at `path`, in the order of the file.

    Raises:
        UsageError: the file cannot be read.
        DesignError: the file has mistakes; carries every one, in the order of the file.

    """
    file = path.as_posix()
    text = _text(path)
    try:
        document = tomllib.loads(text, parse_float=toml_float)
    except (ValueError, RecursionError) as error:
        raise DesignError([_syntax(file, text, error)]) from None
    lines = index_lines(text)
    found = _strangers(document, file, lines)
    designs: list[Design] = []
    tables = document.get("design")
    for name, table in tables.items() if isinstance(tables, dict) else ():
        if not isinstance(table, dict):
            line = lines.line(("design", name))
            what = f"`{dotted(('design', name))}` must be a table, not {shown(table)}"
            hint = "put the keys of a design below a header [design.NAME]"
            found.append((line, Problem(f"{file}:{line}", "QC104", what, "", hint)))
            continue
        places = FilePlaces(file, name, lines)
        design, findings = resolve(name, table, places, catalogue, file=path.name, directory=path.parent)
        found += problems(findings, places)
        designs += [replace(design, line=lines.line(("design", name)))] if design else []
    if found:
        raise DesignError([problem for _, problem in sorted(found, key=lambda each: each[0])])
    return tuple(designs)


def _text(path: Path) -> str:
    """Return the text of a file, its line ends as tomllib sees them."""
    try:
        raw = path.read_bytes()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"cannot read design file {path.as_posix()}: {reason}") from None
    try:
        return raw.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        hint = "save the file as UTF-8"
        problem = Problem(f"{path.as_posix()}:{line}", "QC101", "not valid TOML: not UTF-8 text", "", hint)
        raise DesignError([problem]) from None


def _syntax(file: str, text: str, error: Exception) -> Problem:
    """Return the one problem of a text that is not TOML; its line is only in the error's message."""
    if isinstance(error, RecursionError):
        return Problem(f"{file}:1", "QC101", "not valid TOML: nested too deeply")
    message = str(error)
    position = re.search(r" \(at (?:line (\d+), column (\d+)|end of document)\)$", message)
    if position is None:
        return Problem(f"{file}:1", "QC101", f"not valid TOML: {_lower_first(message)}")
    what = f"not valid TOML: {_lower_first(message[: position.start()])}"
    if position[1] is None:
        last = text.rstrip("\n").count("\n") + 1
        return Problem(f"{file}:{last}", "QC101", what, "the file ends there")
    return Problem(f"{file}:{position[1]}", "QC101", what, f"at column {position[2]}")


def _lower_first(text: str) -> str:
    return text[:1].lower() + text[1:]


def _strangers(document: dict[str, Any], file: str, lines: LineIndex) -> list[tuple[int, Problem]]:
    """Return the problems of a file's top level: keys that are not `design`, and no design at all."""
    found = []

    def mistake(key: str, code: str, what: str, hint: str) -> None:
        line = lines.line((key,))
        found.append((line, Problem(f"{file}:{line}", code, what, "", hint)))

    for key in document:
        if key != "design":
            near = did_you_mean(key, ["design"])
            hint = "did you mean `design`?" if near else "keys of a design stand below a header [design.NAME]"
            mistake(key, "QC102", f"unknown key `{dotted((key,))}`", hint)
    tables = document.get("design", {})
    if not isinstance(tables, dict):
        mistake("design", "QC104", f"`design` must be a table, not {shown(tables)}", _START)
    elif not tables:
        mistake("design", "QC111", "there is no design in this file", _START)
    return found
