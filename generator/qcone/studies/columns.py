"""Find named columns in a CSV file, and read their cells as numbers.

Messages name the file, its line and the data row (the first row after the header is 1).
"""

from __future__ import annotations

import csv
import difflib
import io
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from qcone.errors import UsageError

COLUMNS = {
    "increment": {"t": "t_s", "x": "dtheta_x_rad", "y": "dtheta_y_rad", "z": "dtheta_z_rad"},
    "rate": {"t": "t_s", "x": "gyr_x_rad_s", "y": "gyr_y_rad_s", "z": "gyr_z_rad_s"},
    "counts": {"t": "t_s", "x": "count_x", "y": "count_y", "z": "count_z"},
}
UNITS = {
    "increment": {"rad": 1.0, "deg": math.pi / 180, "arcsec": math.pi / 648_000},
    "rate": {"rad/s": 1.0, "deg/s": math.pi / 180},
    "counts": {"count": 1.0, "deg/s": 0.0},
}
"""Factors to radians and rad/s; whole counts are taken as they are, and 0 means that the quantum decides."""
LARGEST = 1e100  # in size; squares and sums of anything smaller stay finite


@dataclass(frozen=True)
class Table:
    """The cells of a CSV file as text (names stripped), with the file line each row starts on."""

    path: Path
    header: Sequence[str]
    header_line: int
    rows: Sequence[Sequence[str]]
    lines: Sequence[int]

    def place(self, row: int) -> str:
        """Return `file:line: data row r` of a 0-based row."""
        return f"{self.path}:{self.lines[row]}: data row {row + 1}"


def parse_columns(text: str, kind: str) -> tuple[dict[str, str], float]:
    """Return the column names by key t, x, y, z, and the factor to radians."""
    form = "write 't=NAME;x=NAME;y=NAME;z=NAME;unit=UNIT' (t and unit may be left out)"
    found: dict[str, str] = {}
    for part in filter(str.strip, text.split(";")):
        key, equals, name = (piece.strip() for piece in part.partition("="))
        if not equals or not name:
            raise UsageError(f"--columns: '{part.strip()}' is not key=name, {form}")
        if key not in ("t", "x", "y", "z", "unit"):
            raise UsageError(f"--columns: unknown key '{key}', {form}")
        if key in found:
            raise UsageError(f"--columns: '{key}' is given twice, {form}")
        found[key] = name
    if missing := [key for key in "xyz" if key not in found]:
        raise UsageError(f"--columns: no {', '.join(missing)}, all three axes are needed, {form}")
    for first, second in ("xy", "xz", "yz"):
        if found[first] == found[second]:
            raise UsageError(
                f"--columns: {first} and {second} both name '{found[first]}', give each axis its own column"
            )
    unit = found.pop("unit", next(iter(UNITS[kind])))
    if unit not in UNITS[kind]:
        hint = f"give one of {', '.join(UNITS[kind])}"
        for other in UNITS:
            if unit in UNITS[other]:
                hint = f"{hint}, or --input {other}"
        raise UsageError(f"--columns: unknown unit '{unit}' for --input {kind}, {hint}")
    return found, UNITS[kind][unit]


def read_table(path: Path) -> Table:
    """Read a UTF-8 CSV file (with or without byte order mark), leaving out blank lines."""
    try:
        content = path.read_bytes()
    except OSError as reason:
        raise UsageError(f"{path}: cannot be read, {reason.strerror or reason}, give an existing CSV file") from reason
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as reason:
        before = reason.object.count(b"\n", 0, reason.start)
        raise UsageError(
            f"{path}:{before + 1}: not UTF-8 text ({reason.reason}), save the file as UTF-8 CSV"
        ) from reason
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    rows: list[list[str]] = []
    lines: list[int] = []
    line = 1
    try:
        for row in reader:
            if len(row) > 1 or (row and row[0].strip()):
                rows.append(row)
                lines.append(line)
            line = reader.line_num + 1
    except csv.Error as reason:
        raise UsageError(f"{path}:{line}: not CSV ({reason}), check the quotes of this line") from reason
    if not rows:
        raise UsageError(f"{path}: the file is empty, a header line and rows are needed")
    return Table(path, [name.strip() for name in rows[0]], lines[0], rows[1:], lines[1:])


def find_columns(table: Table, names: Mapping[str, str], kind: str, *, needs_time: bool) -> dict[str, int]:
    """Return the position of each named column; only the default t may be missing, where it is not needed."""
    if needs_time and "t" not in names:
        raise UsageError("--columns: no t, the times come from a column t=NAME or from --sample-hz HZ, give one")
    header = table.header
    for name in names.values():
        if header.count(name) > 1:
            raise UsageError(
                f"{table.path}:{table.header_line}: column '{name}' stands there twice, rename one of the two"
            )
    optional = () if needs_time or names != COLUMNS[kind] else ("t",)
    missing = [name for key, name in names.items() if name not in header and key not in optional]
    if missing:
        raise UsageError(_missing(table, missing, names, kind))
    return {key: header.index(name) for key, name in names.items() if name in header}


def _missing(table: Table, missing: Sequence[str], names: Mapping[str, str], kind: str) -> str:
    """Return the message for columns that are not there, with the likeliest reason."""
    header = table.header
    free = {name.casefold(): name for name in header if name not in names.values()}
    near = [(name, difflib.get_close_matches(name.casefold(), free, n=1)) for name in missing]
    meant = [f"did you mean '{free[close[0]]}' for '{name}'?" for name, close in near if close]
    other = next(name for name in COLUMNS if name != kind)
    hint = "map the names with --columns"
    if all(name in header for key, name in COLUMNS[other].items() if key != "t"):
        hint = f"these are columns of --input {other}"
    elif len(header) == 1 and any(mark in header[0] for mark in ";\t|"):
        hint = "columns are separated by commas"
    elif all(_is_number(cell) for cell in header):
        hint = "the first line must name the columns"
    elif missing == ["t_s"]:
        hint = "map its name with --columns, or give --sample-hz HZ"
    wanted = "columns" if len(missing) > 1 else "column"
    text = f"{table.path}:{table.header_line}: no {wanted} {', '.join(repr(name) for name in missing)}"
    return ", ".join([text, *meant, f"the columns are {', '.join(repr(name) for name in header)}", hint])


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def read_numbers(table: Table, columns: Sequence[int]) -> NDArray[np.float64]:
    """Return the cells of `columns` (rows, len(columns)); the first row that cannot be used is named."""
    width = len(table.header)
    numbers = np.empty((len(table.rows), len(columns)))
    for row, cells in enumerate(table.rows):
        if len(cells) != width and (len(cells) < width or any(map(str.strip, cells[width:]))):
            raise UsageError(
                f"{table.place(row)}: {len(cells)} cells where the header has {width}, the line is cut short "
                f"or has a stray comma (decimals take a point), mend or remove it"
            )
        for place, column in enumerate(columns):
            numbers[row, place] = read_number(table, row, column)
    return numbers


def read_number(table: Table, row: int, column: int) -> float:
    """Return one cell as a finite float."""
    cell = table.rows[row][column]
    try:
        value = float(cell)
        if abs(value) < LARGEST and "_" not in cell:
            return value
        what = f"'{cell.strip()}' is not a finite number below {LARGEST:g} in size"
    except ValueError:
        what = f"'{cell.strip()}' is not a number" if cell.strip() else "the cell is empty"
    raise UsageError(
        f"{table.place(row)}, column '{table.header[column]}': {what}, every sample counts, remove the row or mend it"
    )
