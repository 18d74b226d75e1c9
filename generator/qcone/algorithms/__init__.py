"""WHAT is calculated: the papers' algorithms, as data. The catalogue is this one tuple."""

from __future__ import annotations

from qcone.algorithms import (
    adams_moulton,
    dcm_taylor,
    euler_angles,
    picard,
    quaternion_taylor,
    rotation_vector,
    runge_kutta,
)
from qcone.algorithms.family import Choice, Family

CATALOGUE: tuple[Family, ...] = (
    rotation_vector.FAMILY,
    picard.FAMILY,
    quaternion_taylor.FAMILY,
    dcm_taylor.FAMILY,
    runge_kutta.FAMILY,
    adams_moulton.FAMILY,
    euler_angles.FAMILY,
)

__all__ = ["CATALOGUE", "Choice", "Family", "family"]


def family(name: str) -> Family:
    """Return the family of that id; KeyError when the catalogue has none."""
    for each in CATALOGUE:
        if each.id == name:
            return each
    raise KeyError(name)
