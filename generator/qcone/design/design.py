"""A resolved design: every key has a value, every number is exact, and the digest names the result."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from fractions import Fraction
from pathlib import Path

from qcone.design.catalogue import Value

Vector = tuple[Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class Imu:
    """The sensor's declaration. Rates in deg/s, `update_hz` in attitude updates a second; all exact.

    `quantum_dps` (deg/s for one count), `bias_dps` (sensor axes) and `calibration` (3 x 3, rows) are None
    unless the design's input is `counts`; there the last two are None when not given.
    """

    update_hz: Fraction
    max_rate_dps: Fraction
    max_angular_acceleration_dps2: Fraction | None
    max_jerk_dps3: Fraction | None
    quantum_dps: Fraction | None
    bias_dps: Vector | None
    calibration: tuple[Vector, Vector, Vector] | None


@dataclass(frozen=True)
class Number:
    """The number format and what is done at its edges; the last three matter to fixed formats only."""

    format: str
    accumulate: str
    overflow: str
    rounding: str
    clamp_inputs: bool
    pins: tuple[tuple[str, int], ...] = ()
    """Fraction bits that values of an update shall have, by name."""


@dataclass(frozen=True)
class Rins:
    """The stage of a rotating unit: encoder angle and tilt corrected, the body's attitude given.

    `max_correction_arcsec` bounds sqrt(A^2 + B^2) + |C| of each harmonic the firmware is given.
    """

    max_correction_arcsec: Fraction


@dataclass(frozen=True)
class Design:
    """One design with every default filled in.

    `axes` holds, for each body axis, the index of the sensor axis (0..2) and its sign (+1 or -1).
    `file` is the design file's base name, empty from the command line, `line` that of its table; `directory` is its
    folder, from which a user's own `my_paper.py:my_update` is found. `rins` is None where that stage is not asked for.
    Mappings are to be read, never written.
    """

    name: str
    file: str
    algorithm: str
    parameters: Mapping[str, Value] = field(hash=False)
    input: str
    increments: str
    axes: tuple[tuple[int, int], ...]
    outputs: tuple[str, ...]
    form: str
    euler: str
    loop: str
    exponential: str
    renormalise: str
    core: str
    multiply: str
    license: str
    imu: Imu
    number: Number
    budget: Mapping[str, int] = field(hash=False)
    target_budgets: Mapping[str, Mapping[str, int]] = field(hash=False)
    rins: Rins | None = None
    directory: Path | None = field(default=None, compare=False)
    line: int = field(default=0, compare=False)

    @property
    def digest(self) -> str:
        """Return the SHA-256, in hex, of everything here that decides the output.

        File, folder and budgets do not, nor does what is not asked for, a stage or pins. A user's own algorithm
        enters by its name only, not by its text.
        """
        text = json.dumps(_plain(self), sort_keys=True, separators=(",", ":"), ensure_ascii=True)
        return hashlib.sha256(text.encode("ascii")).hexdigest()


_UNDIGESTED = frozenset({"file", "directory", "line", "budget", "target_budgets"})
_ON_REQUEST = frozenset({"rins", "pins"})


def _plain(value: object) -> object:
    if isinstance(value, Design | Imu | Number | Rins):
        names = [each.name for each in fields(value) if each.name not in _UNDIGESTED]
        names = [name for name in names if name not in _ON_REQUEST or getattr(value, name)]
        return {name: _plain(getattr(value, name)) for name in names}
    if isinstance(value, Mapping):
        return {str(key): _plain(each) for key, each in value.items()}
    if isinstance(value, tuple):
        return [_plain(each) for each in value]
    return f"{value.numerator}/{value.denominator}" if isinstance(value, Fraction) else value
