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
    shown = _shown(rows)
    rules = "".join("---:|" if _numbers(rows, name) else "---|" for name in shown)
    lines = [f"| {' | '.join(map(_head, shown))} |", f"|{rules}"]
    lines += [f"| {' | '.join(_line(row[name]).replace('|', chr(92) + '|') for name in shown)} |" for row in rows]
    return "\n".join(lines) + "\n"


def _latex(command: str, rows: Sequence[Row]) -> str:
    r"""Return a table to be put in by \\input, shrunk where it is wider than the line."""
    shown = _shown(rows)
    lines = [
        r"% \usepackage{booktabs,graphicx}",
        r"\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{%",
        rf"\begin{{tabular}}{{{''.join('r' if _numbers(rows, name) else 'l' for name in shown)}}}",
        r"\toprule",
        " & ".join(_latex_head(rows, name) for name in shown) + r" \\",
        r"\midrule",
    ]
    lines += [" & ".join(_tex(_line(row[name])) for name in shown) + r" \\" for row in rows]
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}}"]) + "\n"


def _latex_head(rows: Sequence[Row], name: str) -> str:
    """Return a heading, upright where it is much wider than the numbers below it."""
    head = _tex(_head(name))
    widest = max(len(_line(row[name])) for row in rows)
    return rf"\rotatebox{{90}}{{{head}}}" if _numbers(rows, name) and len(head) > widest + 3 else head


def _table(command: str, rows: Sequence[Row]) -> str:
    from rich.console import Console
    from rich.table import Table

    table = Table(box=None, pad_edge=False, header_style="bold")
    shown = _shown(rows)
    for name in shown:
        table.add_column(_head(name), justify="right" if _numbers(rows, name) else "left", overflow="fold")
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


def _shown(rows: Sequence[Row]) -> list[str]:
    """Return the columns that apply to a row at least: what people read leaves the others out."""
    return [name for name in _columns(rows) if any(row[name] is not None for row in rows)]


def _numbers(rows: Sequence[Row], name: str) -> bool:
    return all(isinstance(row[name], int | float) or row[name] is None for row in rows)


def _head(name: str) -> str:
    return name.replace("_", " ")


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
