"""Read the log of a rotating unit from CSV: encoder angle, rate about the axis, specific force."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from qcone.errors import UsageError
from qcone.studies.columns import Table, read_numbers, read_table
from qcone.studies.encoder_log import EncoderLog

NAMES: Mapping[str, str] = {
    "t": "t_s",
    "encoder": "encoder_rad",
    "gyr_z": "gyr_z_rad_s",
    "acc_x": "acc_x_m_s2",
    "acc_y": "acc_y_m_s2",
    "acc_z": "acc_z_m_s2",
}
"""The columns by key, as they are called where --columns does not say otherwise."""

UNITS = {"rad": 1.0, "deg": math.pi / 180}
FORM = f"write '{';'.join(f'{key}=NAME' for key in NAMES)};unit=UNIT', those of another name alone"


def read_encoder_log(path: Path, columns: str | None = None, instantaneous: bool = False) -> EncoderLog:
    """Read a CSV file: a header line, then rows of time, encoder angle, rate about the axis of rotation, force.

    `columns` maps names and unit (`t=Time (s);encoder=Angle (deg);unit=deg`); the unit is that of the encoder and, a
    second, of the gyro. The force may be in any unit: only its direction counts. With `instantaneous` the rates are
    taken to be those of the rows' instants, and the mean with the row before is what `EncoderLog` wants.

    Raises UsageError for anything in the file or the option that cannot be used, with its place and a hint.
    """
    names, scale = _parse(columns or "")
    table = read_table(path)
    places = _find(table, names)
    if not table.rows:
        raise UsageError(f"{path}: no data rows after the header, nothing to fit")
    numbers = read_numbers(table, [places[key] for key in NAMES])
    rate = numbers[:, 2] * scale
    if instantaneous:
        rate = np.concatenate([rate[:1], (rate[1:] + rate[:-1]) / 2])
    return EncoderLog(numbers[:, 0], numbers[:, 1] * scale, rate, numbers[:, 3:], source=str(path))


def _parse(text: str) -> tuple[dict[str, str], float]:
    """Return the column names by key, and the factor to radians."""
    found: dict[str, str] = {}
    for part in filter(str.strip, text.split(";")):
        key, equals, name = (piece.strip() for piece in part.partition("="))
        if not equals or not name:
            raise UsageError(f"--columns: '{part.strip()}' is not key=name, {FORM}")
        if key not in (*NAMES, "unit"):
            raise UsageError(f"--columns: unknown key '{key}', {FORM}")
        if key in found:
            raise UsageError(f"--columns: '{key}' is given twice, {FORM}")
        found[key] = name
    unit = found.pop("unit", "rad")
    if unit not in UNITS:
        raise UsageError(f"--columns: unknown unit '{unit}', give one of {', '.join(UNITS)}")
    names = {**NAMES, **found}
    for key, name in names.items():
        other = next(each for each, given in names.items() if given == name)
        if other != key:
            raise UsageError(f"--columns: {other} and {key} both name '{name}', give each its own column")
    return names, UNITS[unit]


def _find(table: Table, names: Mapping[str, str]) -> dict[str, int]:
    """Return the position of each named column."""
    place = f"{table.path}:{table.header_line}"
    for name in names.values():
        if table.header.count(name) > 1:
            raise UsageError(f"{place}: column '{name}' stands there twice, rename one of the two")
    missing = [name for name in names.values() if name not in table.header]
    if missing:
        free = {name.casefold(): name for name in table.header if name not in names.values()}
        near = [(name, difflib.get_close_matches(name.casefold(), free, n=1)) for name in missing]
        meant = [f"did you mean '{free[close[0]]}' for '{name}'?" for name, close in near if close]
        text = f"{place}: no column{'s' * (len(missing) > 1)} {', '.join(map(repr, missing))}"
        there = f"the columns are {', '.join(map(repr, table.header))}"
        raise UsageError(", ".join([text, *meant, there, "map the names with --columns"]))
    return {key: table.header.index(name) for key, name in names.items()}
