"""Ranges used: how many of its bits every value of a fixed-point design takes on a run, and how many it spares."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, log2

import numpy as np

from qcone.backends.bittrue import Array, Model, new_state
from qcone.bundle import Bundle
from qcone.errors import UsageError
from qcone.formats.fixed import Signal
from qcone.ir.statement import Operation, Role
from qcone.vectors import Vectors
from qcone.verify import restart_lanes

Row = dict[str, object]
SERVED = {"update": ("update", "hold", "start_up", "steady")}
"""The routines behind one call; their values are told apart by name where they have the same one."""


@dataclass
class _Seen:
    signal: Signal
    bound: float
    largest: int = 0


def rows(bundle: Bundle, vectors: Vectors) -> list[Row]:
    """Return a row for each named value: its format, the bits its bound needs, those used, and those to spare.

    Bits are those of the magnitude, without the sign. Raises UsageError for a design of floats: they have no ranges.
    """
    if bundle.macs is None:
        raise UsageError(f"design '{bundle.name}': floats have no ranges, only a fixed-point design has")
    seen = _values(bundle)
    _run(bundle, vectors, seen)
    return [_row(bundle, *key, each) for key, each in seen.items() if each.largest or each.bound]


def _values(bundle: Bundle) -> dict[tuple[str, str], _Seen]:
    assert bundle.macs is not None
    seen: dict[tuple[str, str], _Seen] = {}
    run = {"update", *SERVED["update"], *(name for name, _ in bundle.driver.outputs)}
    for routine in bundle.macs.routines:
        if routine.name not in run:
            continue
        for each in routine.body:
            if isinstance(each, Operation) and isinstance(each.format, Signal) and each.bound is not None:
                name = routine.names.get(each.result)
                if name:
                    seen[routine.name, name] = _Seen(each.format, float(each.bound / each.format.lsb))
    return seen


def _run(bundle: Bundle, vectors: Vectors, seen: dict[tuple[str, str], _Seen]) -> None:
    assert bundle.macs is not None
    model = Model(bundle.macs, bundle.facts.number)
    lanes, steps = vectors.restart.shape
    state = new_state(bundle.macs, bundle.facts.number, lanes)
    given = bundle.macs.routine("update").having(Role.INPUT)[0].name
    for step in range(steps):
        restart_lanes(model, bundle, state, vectors, step)
        calls = [("update", {given: vectors.inputs[:, step].T}), *((name, {}) for name, _ in bundle.driver.outputs)]
        for name, inputs in calls:
            watch: dict[str, Array] = {}
            model.run(name, state, inputs, watch)
            for routine in SERVED.get(name, (name,)):
                for value, words in watch.items():
                    if (routine, value) in seen:
                        largest = int(np.abs(np.asarray(words, np.int64)).max())
                        seen[routine, value].largest = max(seen[routine, value].largest, largest)


def _row(bundle: Bundle, routine: str, name: str, seen: _Seen) -> Row:
    used, needed = _bits(seen.largest), _bits(seen.bound)
    return {
        "design": bundle.name,
        "routine": routine,
        "value": name,
        "format": seen.signal.name,
        "bound_bits": needed,
        "used_bits": used,
        "spare_bits": seen.signal.width - 1 - used,
    }


def _bits(size: float) -> int:
    return ceil(log2(size + 1)) if size >= 1 else 0
