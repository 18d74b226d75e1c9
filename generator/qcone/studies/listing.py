"""The catalogue as rows: every algorithm with its parameters, order, least operations and source."""

from __future__ import annotations

from functools import cache

from qcone.algorithms import CATALOGUE
from qcone.backends.counts import Counts
from qcone.design import design_from_options
from qcone.ir.specification import Algorithm
from qcone.pipeline import build
from qcone.registry import entries

Row = dict[str, object]


def rows() -> list[Row]:
    """Return one row for every algorithm of the catalogue; counts are of the emitted float64 update."""
    return [dict(row) for row in _rows()]


@cache
def _rows() -> list[Row]:
    found: list[Row] = []
    for family in CATALOGUE:
        for values in family.examples:
            algorithm = family.make(values)
            given = {name: value for name, value in values.items() if value is not None}
            words = ", ".join(f"{name} = {value}" for name, value in given.items() if value != 0)
            found.append(
                {
                    "id": family.id,
                    "parameters": words,
                    "order": algorithm.order,
                    "counts": _operations(family.id, given, algorithm),
                    "source": str(algorithm.source),
                }
            )
    return found


def _operations(name: str, given: dict[str, int | str], algorithm: Algorithm) -> str:
    taken = "rate" if algorithm.takes == "omega" else "increment"
    options = {
        "algorithm": name,
        **given,
        "input": taken,
        "number": "float64",
        "max_rate_dps": "573",
        "update_hz": "100",
    }
    facts = build(design_from_options("listed", options, entries())).facts
    counts: Counts = (facts.counts.get("steady") or facts.counts["update"])["emitted"]
    return f"{counts.multiply} multiply, {counts.add + counts.subtract} add and subtract"
