"""The exact cases of one update: increments and r to 40 digits, and what a result misses them by."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
from numpy.typing import NDArray

FLOORS = {"float32": 6e-8, "float64": 1.2e-16}
KEYS = {
    "taylor": "rv_uncompressed",
    "coning": "rv_compressed_spread",
    "compressed": "rv_compressed_last",
    "expanded": "rv_hybrid",
}
EXACT = mpmath.mp.clone()
EXACT.dps = 40

Case = tuple[str, list[list[Any]], list[Any]]
"""A name, increments (N, 3) and r (4), to 40 digits."""


def number_of(text: str) -> Any:
    """Return a number of the truth files, a decimal or a fraction, to 40 digits."""
    exact = Fraction(text)
    return EXACT.mpf(exact.numerator) / exact.denominator


def cases(truth: Path, n: int, coefficients: str) -> Iterator[Case]:
    yield from cases_of(truth, n, KEYS["coning" if coefficients == "expanded" and n <= 3 else coefficients])


def cases_of(truth: Path, n: int, key: str) -> Iterator[Case]:
    """Yield the cases of N sub-samples with the r of an algorithm by the key of the truth files."""
    for entry in _load(truth / "truth_motions.json"):
        r = entry["updates"][str(n)]["r_algorithm"][key]
        yield entry["name"], [list(map(number_of, row)) for row in entry["theta"][:n]], list(map(number_of, r))
    for k, entry in enumerate(_load(truth / "truth_polynomial.json")):
        if entry["N"] == n:
            theta = [list(map(number_of, row)) for row in entry["theta_exact"]]
            yield f"polynomial {k}", theta, list(map(number_of, entry["r_algorithm"][key]))


@cache
def _load(file: Path) -> Any:
    return json.loads(file.read_text())


def error(r: NDArray[Any], exact: list[Any]) -> float:
    """Return the largest error of a component of r, the difference taken in 40 digits."""
    return float(max(abs(EXACT.mpf(float(have)) - want) for have, want in zip(r, exact, strict=True)))


def rounded(theta: list[list[Any]]) -> list[list[float]]:
    return [[float(value) for value in row] for row in theta]


def closed_form(sigma: list[Any]) -> list[Any]:
    length = EXACT.norm(sigma)
    return [EXACT.cos(length / 2), *(EXACT.sin(length / 2) / length * value for value in sigma)]
