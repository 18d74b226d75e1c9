"""WHAT is calculated: the papers' algorithms, as data. The catalogue is this one tuple."""

from __future__ import annotations

from qcone.algorithms import picard, rotation_vector
from qcone.algorithms.family import Choice, Family

CATALOGUE: tuple[Family, ...] = (
    rotation_vector.FAMILY,
    picard.FAMILY,
)

__all__ = ["CATALOGUE", "Choice", "Family", "family"]


def family(name: str) -> Family:
    """Return the family of that id; KeyError when the catalogue has none."""
    for each in CATALOGUE:
        if each.id == name:
            return each
    raise KeyError(name)
