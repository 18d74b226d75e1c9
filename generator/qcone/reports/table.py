"""One list of flat rows in five formats: a table for people, JSON, CSV, Markdown, LaTeX."""

from __future__ import annotations

import csv
import io
import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence

Row = Mapping[str, object]
SCHEMA_VERSION = 1
PIPE_WIDTH = 220
"""Columns of a table that no terminal limits."""


def render(command: str, rows: Sequence[Row], layout: str) -> str:
    """Return the rows in a layout, one of LAYOUTS. Every row has the keys of the first; None does not apply."""
    return LAYOUTS[layout](command, rows)


def _json(command: str, rows: Sequence[Row]) -> str:
    return json.dumps({"schema_version": SCHEMA_VERSION, "command": command, "rows": list(rows)}, indent=2) + "\n"


def _csv(command: str, rows: Sequence[Row]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_columns(rows))
    writer.writerows([_cell(value) for value in row.values()] for row in rows)
    return text.getvalue()


def _markdown(command: str, rows: Sequence[Row]) -> str:
    columns = _columns(rows)
    lines = [f"| {' | '.join(columns)} |", f"|{'---|' * len(columns)}"]
    lines += [f"| {' | '.join(_line(value).replace('|', chr(92) + '|') for value in row.values())} |" for row in rows]
    return "\n".join(lines) + "\n"


def _latex(command: str, rows: Sequence[Row]) -> str:
    r"""Return a booktabs table to be put in by \\input."""
    columns = _columns(rows)
    lines = [
        rf"\begin{{tabular}}{{{'l' * len(columns)}}}",
        r"\toprule",
        " & ".join(map(_tex, columns)) + r" \\",
        r"\midrule",
    ]
    lines += [" & ".join(_tex(_line(value)) for value in row.values()) + r" \\" for row in rows]
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}"]) + "\n"


def _table(command: str, rows: Sequence[Row]) -> str:
    from rich.console import Console
    from rich.table import Table

    table = Table(box=None, pad_edge=False, header_style="bold")
    shown = [name for name in _columns(rows) if any(row[name] is not None for row in rows)]
    for name in shown:
        numbers = all(isinstance(row[name], int | float) or row[name] is None for row in rows)
        table.add_column(name.replace("_", " "), justify="right" if numbers else "left", overflow="fold")
    for row in rows:
        table.add_row(*(_cell(row[name]) for name in shown))
    terminal = sys.stdout.isatty()
    page = io.StringIO()
    styled = terminal and not os.environ.get("NO_COLOR")
    width = None if terminal else PIPE_WIDTH
    console = Console(width=width, file=page, force_terminal=styled, highlight=False, markup=False, emoji=False)
    if terminal:
        console.width = Console().width
    console.print(table)
    text = page.getvalue()
    return "\n".join(line.rstrip() for line in text.splitlines()) + "\n"


def _columns(rows: Sequence[Row]) -> list[str]:
    return list(rows[0]) if rows else []


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _line(value: object) -> str:
    """Return a cell where a line's end would end the row."""
    return " ".join(_cell(value).split("\n"))


def _tex(text: str) -> str:
    special = {
        "\\": r"\textbackslash{}",
        "&": r"\&",
        "%": r"\%",
        "_": r"\_",
        "#": r"\#",
        "$": r"\$",
        "^": r"\^{}",
        "~": r"\~{}",
        "{": r"\{",
        "}": r"\}",
    }
    return "".join(special.get(mark, mark) for mark in text)


LAYOUTS: Mapping[str, Callable[[str, Sequence[Row]], str]] = {
    "table": _table,
    "json": _json,
    "csv": _csv,
    "md": _markdown,
    "tex": _latex,
}
