"""A design from command line options: the same words, the same checks, no file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

from qcone.design.catalogue import AlgorithmEntry
from qcone.design.design import Design
from qcone.design.keys import DESIGN_KEYS, IMU_KEYS, NUMBER_KEYS, RINS_KEYS, Key, Kind
from qcone.design.numbers import is_decimal, toml_float
from qcone.design.places import KeyPath, OptionPlaces, option_word, problems
from qcone.design.resolve import resolve
from qcone.errors import DesignError

_WHOLE = re.compile(r"[+-]?[0-9]{1,40}")


def design_from_options(name: str, options: Mapping[str, object], catalogue: Sequence[AlgorithmEntry]) -> Design:
    """Return the design that command line options describe, named `name`.

    `options` maps option words (`max_rate_dps` or `max-rate-dps`; `number` is the number format) to text or
    to values; None and empty tuples are options not given. Lists are comma separated: `quaternion,dcm`,
    `0.1,0,-0.2`, and nine numbers for a calibration, row after row. A float is the decimal that it prints as.

    Raises:
        DesignError: with every mistake; the place of each is its option, such as `--max-rate-dps`.

    """
    table: dict[str, Any] = {}
    words: list[str] = []
    for word, value in options.items():
        if value is None or value == ():
            continue
        path, key = _key(word.replace("-", "_").strip("_"))
        words.append(option_word(path))
        below = table.setdefault(path[0], {}) if len(path) > 1 else table
        below[path[-1]] = _toml_value(key.kind if key else None, value)
    places = OptionPlaces(words)
    design, findings = resolve(name, table, places, catalogue, file="", directory=None)
    if design is None:
        found = sorted(problems(findings, places), key=lambda each: each[0])
        raise DesignError([problem for _, problem in found])
    return design


def _key(name: str) -> tuple[KeyPath, Key | None]:
    """Return the path and the key of an option; an algorithm's parameters have no key here."""
    if name == "number":
        return ("number", "format"), next(key for key in NUMBER_KEYS if key.name == "format")
    tables: tuple[tuple[KeyPath, tuple[Key, ...]], ...] = (
        (("imu",), IMU_KEYS),
        (("number",), NUMBER_KEYS),
        (("rins",), RINS_KEYS),
        ((), DESIGN_KEYS),
    )
    for table, keys in tables:
        for key in keys:
            if key.name == name and name != "format":
                return (*table, name), key
    return (name,), None


def _toml_value(kind: Kind | None, value: object) -> object:
    """Return an option's value as tomllib would have read it."""
    if isinstance(value, float):
        return toml_float(repr(value))
    if isinstance(value, list | tuple):
        if kind in ("choices", "pins"):
            value = ",".join(map(str, value))
        else:
            return [_toml_value("decimal", each) for each in value]
    if not isinstance(value, str):
        return value
    parts = [part.strip() for part in re.split("[,;]", value)]
    if kind is None:
        return int(value) if _WHOLE.fullmatch(value) else value
    if kind == "decimal":
        return _number(value)
    if kind in ("choices", "pins"):
        return parts
    if kind == "vector":
        return [_number(part) for part in parts]
    if kind == "matrix":
        numbers = [_number(part) for part in parts]
        return [numbers[row : row + 3] for row in range(0, len(numbers), 3)]
    if kind == "flag":
        return {"true": True, "false": False}.get(value, value)
    return value


def _number(text: str) -> Decimal | str:
    return toml_float(text) if is_decimal(text) else text
