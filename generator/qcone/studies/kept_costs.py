"""Costs kept beside the emitted C: `cost.json` of each design, and the table of the README made from them."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from qcone.bundle import MANIFEST
from qcone.errors import UsageError
from qcone.studies.costing import Line, Row
from qcone.targets.machines import TARGETS

FILE = "cost.json"
README = "README.md"
BEGIN, END = "<!-- costs: begin -->", "<!-- costs: end -->"
_KEY = ("target", "level", "compiler")
_ALL = tuple(name for name, each in TARGETS.items() if each.emulated)


def check_request(write: bool, diff: bool, elf: Path | None) -> None:
    """Raise UsageError for options that do not go together."""
    if write and diff:
        raise UsageError("--write and --diff: choose one; --diff shows what --write would change")
    if elf is not None and (write or diff):
        raise UsageError("--elf: figures of a program of your own are not kept; leave out --write and --diff")


def write(lines: Sequence[Line], folder: Path) -> list[Path]:
    """Keep every line in its design's cost.json, in the place of one for the same target, level and compiler.

    Lines of other C than the one measured now are dropped. The README beside the folder gets its table anew where it
    has the two markers. Returns the files written. Raises UsageError where a design was not generated into the folder.
    """
    texts = {}
    for name in dict.fromkeys(str(each.row["design"]) for each in lines):
        own = [each for each in lines if each.row["design"] == name]
        place = folder / name
        if not (place / MANIFEST).is_file():
            raise UsageError(f"{place}: no design was generated there; run: qcone generate DESIGN.toml -o {folder}")
        document = _kept(place)
        rows = document.get("rows", []) if document.get("source") == own[0].source else []
        by_key = {_key(row): row for row in rows} | {_key(each.row): each.row | each.more for each in own}
        ordered = sorted(by_key.values(), key=lambda row: (_ALL.index(row["target"]), row["level"], row["compiler"]))
        content = {"schema_version": 1, "design": name, "source": own[0].source, "rows": ordered}
        texts[place / FILE] = json.dumps(content, indent=2) + "\n"
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8", newline="\n")
    readme = folder.parent / README
    renewed = with_table(readme.read_text(encoding="utf-8"), folder) if readme.is_file() else None
    if renewed is None:
        return list(texts)
    readme.write_text(renewed, encoding="utf-8", newline="\n")
    return [*texts, readme]


def differences(lines: Sequence[Line], folder: Path) -> list[Row]:
    """Return one row for each figure that is not as kept, and for each line that is not kept at all."""
    rows: list[Row] = []
    for line in lines:
        document = _kept(folder / str(line.row["design"]))
        rows += _differences(line, document)
    return rows


def _differences(line: Line, document: Mapping[str, Any]) -> Iterator[Row]:
    place = {"design": line.row["design"], "target": line.row["target"], "level": line.row["level"]}
    if document.get("source") != line.source:
        yield {**place, "figure": "source", "kept": document.get("source"), "measured": line.source}
        return
    kept = next((row for row in document["rows"] if _key(row) == _key(line.row)), None)
    if kept is None:
        others = sorted({row["compiler"] for row in document["rows"] if row["target"] == line.row["target"]})
        said = ", ".join(others) or None
        yield {**place, "figure": "compiler", "kept": said, "measured": line.row["compiler"]}
        return
    for figure, value in {**line.row, **line.more}.items():
        if kept.get(figure) != value:
            yield {**place, "figure": figure, "kept": kept.get(figure), "measured": value}


def with_table(text: str, folder: Path) -> str | None:
    """Return a README with the table between its markers made anew; None where it has no markers."""
    begin, end = text.find(BEGIN), text.find(END)
    if begin < 0 or end < begin:
        return None
    return f"{text[: begin + len(BEGIN)]}\n{table(folder)}{text[end:]}"


def table(folder: Path) -> str:
    """Return the kept costs as a Markdown table: instructions at most and bytes of text, a column for each target.

    The rows are those of ziglang at -O2, so that one compiler speaks for all targets.
    """
    cells: dict[str, dict[str, str]] = {}
    compilers = set()
    for file in sorted(folder.glob(f"*/{FILE}")):
        for row in _kept(file.parent).get("rows", []):
            if row["level"] == "-O2" and row["compiler"].startswith("zig "):
                cells.setdefault(row["design"], {})[row["target"]] = f"{row['instructions_max']} / {row['text_bytes']}"
                compilers.add(row["compiler"])
    shown = [name for name in _ALL if any(name in each for each in cells.values())]
    head = f"Instructions of one update at most / bytes of its code; {', '.join(sorted(compilers))}, -O2:\n\n"
    lines = [f"| design | {' | '.join(shown)} |", f"|---|{'---|' * len(shown)}"]
    lines += [f"| {name} | {' | '.join(each.get(one, '') for one in shown)} |" for name, each in cells.items()]
    return head + "\n".join(lines) + "\n"


def _kept(place: Path) -> dict[str, Any]:
    """Return what is kept of a design; empty where nothing is. Raises UsageError for a file that is not ours."""
    file = place / FILE
    if not file.is_file():
        return {}
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
        if isinstance(document["rows"], list) and all(set(_KEY) <= set(row) for row in document["rows"]):
            return dict(document)
    except (ValueError, KeyError, TypeError):
        pass
    raise UsageError(f"{file}: not a file of costs; remove it, and keep them anew with --write")


def _key(row: Mapping[str, Any]) -> tuple[Any, ...]:
    return tuple(row[each] for each in _KEY)
