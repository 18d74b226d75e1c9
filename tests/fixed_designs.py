"""Designs in fixed point: every family of the catalogue, each built once for all tests."""

from __future__ import annotations

from functools import cache

from qcone.bundle import Bundle
from qcone.pipeline import build
from shipped import EXAMPLES, WITH_PHI, design_of

FLAGSHIP = "rotation-vector subsamples=3 coefficients=coning"
ACCUMULATIONS = ("delta", "standard", "compensated")
SMOOTH = {"max_angular_acceleration_dps2": "20000", "max_jerk_dps3": "1000000"}
"""What has to be declared of samples, beside their size, for fits of polynomials to fit a word."""

SERIES = (
    "quaternion-taylor subsamples=1 order=10 about=midpoint",
    "quaternion-taylor subsamples=3 order=10 about=start",
    "quaternion-taylor subsamples=3 order=10 about=midpoint",
    "dcm-taylor subsamples=3 order=10",
)
INTEGRATED = tuple(name for name in EXAMPLES if name.startswith(("runge-kutta", "adams-moulton")))

CATALOGUE = {
    **{f"{FLAGSHIP} fixed32 {how}": (FLAGSHIP, "fixed32", how) for how in ACCUMULATIONS},
    **{f"{FLAGSHIP} fixed16 {how}": (FLAGSHIP, "fixed16", how) for how in ACCUMULATIONS},
    **{
        f"{name} fixed32 {ACCUMULATIONS[k % 3]}": (name, "fixed32", ACCUMULATIONS[k % 3])
        for k, name in enumerate((*WITH_PHI, *SERIES, *INTEGRATED))
    },
    **{
        f"{name} fixed16 {ACCUMULATIONS[(k + 1) % 3]}": (name, "fixed16", ACCUMULATIONS[(k + 1) % 3])
        for k, name in enumerate(WITH_PHI)
        if name.startswith("rotation-vector") and k % 3 == 0
    },
}
"""Every form with a rotation vector, some of every other family, accumulations in turn; some of them in 16 bits."""


@cache
def fixed(name: str, rounding: str = "up") -> Bundle:
    """Return the design of that name, at 573 deg/s and 100 updates/s.

    SMOOTH is declared where it is needed, and of half of the others.
    """
    example, number, accumulate = CATALOGUE[name]
    smooth = example in (*SERIES, *INTEGRATED) or list(CATALOGUE).index(name) % 2
    return made(example, number, accumulate, rounding=rounding, **(SMOOTH if smooth else {}))


@cache
def made(example: str, number: str, accumulate: str, **options: str) -> Bundle:
    """Return a design of the catalogue with options of its own."""
    return build(design_of(example, number=number, accumulate=accumulate, **options))
