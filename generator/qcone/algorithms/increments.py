"""From rate samples to angle increments: the stage before the update when the sensor gives rates."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from qcone.algorithms import coefficients
from qcone.ir.real import Vector, step

RULES = ("interpolating", "cao-13")


def weights(subsamples: int, rule: str) -> tuple[tuple[Fraction, ...], ...]:
    """Return R with theta_i = T sum_j R[i][j] omega_j. Raises ValueError: cao (13) is for three sub-samples."""
    if rule == "cao-13":
        if subsamples != 3:
            raise ValueError("cao (13) is for three sub-samples")
        return coefficients.CAO_13
    return coefficients.rates_to_increments(subsamples)


def increments(omega: Sequence[Vector], interval: Fraction, rule: str) -> tuple[Vector, ...]:
    """Write the N increments [rad] of N + 1 rates [rad/s] at equal spacing over `interval` seconds.

    The polynomial through all samples is integrated over each
    sub-interval, or the three-node rule of cao (13),
    corrected. The interval is part of the constants: no product with T is left.
    """
    source = "cao (13), third row corrected" if rule == "cao-13" else "polynomial through all samples"
    rows = weights(len(omega) - 1, rule)
    thetas = []
    for i, row in enumerate(rows):
        total = None
        for factor, rate in zip(row, omega, strict=True):
            if factor:
                term = (interval * factor) * rate
                total = term if total is None else total + term
        assert total is not None
        terms = " ".join(f"{'-' if f < 0 else '+'} {abs(f)} w{j}" for j, f in enumerate(row) if f).removeprefix("+ ")
        number = str(i + 1) if len(rows) > 1 else ""
        thetas.append(step(f"theta{number} = T ({terms})", source, total))
    return tuple(thetas)


def gain(subsamples: int, rule: str) -> Fraction:
    """Return the largest sum |R_ij| over j: |theta_i| <= gain T max |omega|."""
    return max(sum((abs(each) for each in row), Fraction(0)) for row in weights(subsamples, rule))
