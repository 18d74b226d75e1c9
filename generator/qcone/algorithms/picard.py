"""Picard's solution for one angle increment, axis held fixed: cao (7) to (9), orders 1 to 4 and closed.

With x = |sigma|^2: a_c = cos(|sigma|/2) and a_s = sin(|sigma|/2)/|sigma| cut off at the order in |sigma|.
All orders are of local order three when the axis moves: no coning correction is possible with one sample.
"""

from __future__ import annotations

from typing import Any

from qcone.algorithms.family import Choice, Family
from qcone.algorithms.rotation_vector import SYMMETRIC, Vectors
from qcone.ir.real import (
    Algorithm,
    F,
    Quaternion,
    Rotation,
    Source,
    Vector,
    algorithm,
    dot,
    exp,
    number,
    quaternion,
    rotation,
    step,
)

ORDERS: tuple[int | str, ...] = (1, 2, 3, 4, "closed")
SOURCE = Source("cao", "(7), (8), (9)")


def picard(order: int | str) -> Algorithm:
    """Return the single-sample algorithm cut off at `order` in |sigma|, or "closed" (sine and cosine)."""

    @algorithm(
        f"picard-{order}",
        source=SOURCE,
        subsamples=1,
        order=2,
        properties=SYMMETRIC,
        summary="r = [a_c, a_s sigma], sigma = theta",
        truncation=None if order == "closed" else lambda size: left_out(int(order), size),
    )
    def single(q: Quaternion, dtheta: Vectors) -> Any:
        (theta,) = dtheta
        sigma = step("phi = theta", "cao (7)", theta)
        if order == "closed":
            return q * exp(sigma)
        return q * _series_as_written(sigma, int(order))

    @single.factored
    def factored(q: Quaternion, dtheta: Vectors) -> Any:
        (theta,) = dtheta
        sigma = step("phi = theta", "cao (7)", theta)
        if order == "closed":
            return q * exp(sigma)
        return q * _series_factored(sigma, int(order))

    return single


def left_out(order: int, size: F) -> tuple[F, F]:
    """Return bounds of the first terms dropped, which bound alternating, falling series: |sigma| <= size < pi."""
    square = size * size
    scalar = {1: square / 8, 2: square**2 / 384, 3: square**2 / 384, 4: square**3 / 46080}[order]
    vector = {1: size * square / 48, 2: size * square / 48, 3: size * square**2 / 3840, 4: size * square**2 / 3840}[
        order
    ]
    return scalar, vector


def _series_as_written(sigma: Vector, order: int) -> Quaternion:
    """Write cao (9): a_c = 1 - h/2! + h^2/4!, a_s = 1/2 (1 - h/3!), h = (sigma/2)^2, as far as the order goes."""
    if order == 1:
        return step("r = [1, 1/2 sigma]", "cao (9)", quaternion(number(1, sigma), F(1, 2) * sigma))
    h = step("h = 1/4 |sigma|^2", "cao (9)", F(1, 4) * dot(sigma, sigma))
    a_c = 1 - F(1, 2) * h
    if order == 4:
        a_c = a_c + F(1, 24) * (h * h)
    a_c = step("a_c = cos(|sigma|/2), series", "cao (9)", a_c)
    if order == 2:
        return step("r = [a_c, 1/2 sigma]", "cao (9)", quaternion(a_c, F(1, 2) * sigma))
    a_s = step("a_s = sin(|sigma|/2)/|sigma|, series", "cao (9)", F(1, 2) * (1 - F(1, 6) * h))
    return step("r = [a_c, a_s sigma]", "cao (9)", quaternion(a_c, a_s * sigma))


def _series_factored(sigma: Vector, order: int) -> Rotation | Quaternion:
    if order == 1:
        return rotation(0, step("v = 1/2 phi", "cao (9)", F(1, 2) * sigma))
    x = step("phi_square = |phi|^2", "", dot(sigma, sigma))
    u = x * (F(-1, 8) + F(1, 384) * x) if order == 4 else F(-1, 8) * x
    u = step("u = a_c - 1", "cao (9)", u)
    if order == 2:
        return rotation(u, step("v = 1/2 phi", "cao (9)", F(1, 2) * sigma))
    s = step("s = a_s = 1/2 - |phi|^2/48", "cao (9)", F(1, 2) - F(1, 48) * x)
    return rotation(u, step("v = s phi", "cao (9)", s * sigma))


FAMILY = Family(
    id="picard",
    title="Picard series for one angle increment, axis held fixed",
    source=SOURCE,
    parameters=(Choice("order", ORDERS, "closed", "order of the series in |sigma|"),),
    make=lambda values: picard(values["order"] or "closed"),
    examples=tuple({"order": order} for order in ORDERS),
)
