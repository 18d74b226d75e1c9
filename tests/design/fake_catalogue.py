"""A catalogue of two algorithms, enough for every rule of a design file."""

from __future__ import annotations

from collections.abc import Mapping

from qcone.design import AlgorithmEntry, Parameter, Value


def _rotation_vector_conflicts(
    values: Mapping[str, Value], explicit: frozenset[str]
) -> list[tuple[str, str, str, str]]:
    if "coefficients" in explicit and values["subsamples"] == 1:
        return [
            (
                "coefficients",
                "`coefficients` given for one sub-sample",
                "there is no coning term",
                "leave it out",
            )
        ]
    return []


def _no_conflicts(values: Mapping[str, Value], explicit: frozenset[str]) -> list[tuple[str, str, str, str]]:
    return []


ROTATION_VECTOR = AlgorithmEntry(
    "rotation-vector",
    (
        Parameter("subsamples", (1, 2, 3, 4, 5, 6), 1, "sub-samples an update"),
        Parameter("coefficients", ("taylor", "coning", "expanded", "compressed"), None, "coning coefficients"),
        Parameter("previous", (0, 1, 2, 3, 4, 5), 0, "earlier increments used"),
    ),
    _rotation_vector_conflicts,
)

PICARD = AlgorithmEntry(
    "picard", (Parameter("order", (1, 2, 3, 4, "closed"), "closed", "order of the iteration"),), _no_conflicts
)

CATALOGUE = (ROTATION_VECTOR, PICARD)

GOOD = """\
[design.att]
algorithm = "rotation-vector"

[design.att.imu]
update_hz = 100
max_rate_dps = 573

[design.att.number]
format = "float32"
"""
"""The smallest file there is."""
