"""Multi-sub-sample quaternion algorithm: a Taylor series of the attitude for a polynomial rate, xu2019 (5) to (9).

The paper differentiates q' = 1/2 q (x) omega by the binomial rule, (7); without factorials and binomials that is
r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j with A_j = W_j/2, and r = sum r_n. About the midpoint of the update the
same polynomial needs half the range: r = (E - O)* (x) (E + O), with E and O the even and the odd terms at its end.

The recurrence is written once, over components, and is emitted as loops or written out. A sum begins at +0, so
that it can never be -0; a term that is a product with zero then changes nothing, and is left out where loops are
written out: the bits are the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from qcone.algorithms.dense_taylor import quaternion_dense
from qcone.algorithms.family import Choice, Family
from qcone.algorithms.polynomial_rate import ORDERS, component, in_components, low_order, order_of_accuracy
from qcone.ir.real import (
    Algorithm,
    F,
    History,
    Index,
    Quaternion,
    Rotation,
    Source,
    Vector,
    algorithm,
    heading,
    history,
    loop,
    named,
    number,
    quaternion,
    recorded_products,
    recorded_sum,
    rotation,
    step,
    table,
    vector,
)

Number = Index | int
MOST_ORDER = 24
SOURCE = Source("xu2019", "(5), (7), (8)")
ABOUT = ("start", "midpoint")


def quaternion_taylor(subsamples: int, order: int, about: str) -> Algorithm:
    """Return the series of that order for N = 1..6 sub-samples, about the start or the midpoint of the update."""

    @algorithm(
        f"quaternion-taylor-{subsamples}-{order}-{about}",
        source=SOURCE,
        subsamples=subsamples,
        order=order_of_accuracy(subsamples, order, about),
        properties=frozenset({"flip"}),
        summary="r_0 = 1, r_n = 1/n sum_j r_(n-1-j) (x) A_j, r = sum r_n",
    )
    def written(q: Quaternion, dtheta: Sequence[Vector], interval: Fraction) -> Any:
        return quaternion_dense(q, dtheta, interval, order)

    @written.factored
    def series(q: Quaternion, dtheta: Sequence[Vector]) -> Any:
        scale = [F(1, 2) if about == "start" else F(1, 2 ** (j + 2)) for j in range(subsamples)]
        rate = in_components("A", dtheta, about, scale)
        if about == "midpoint":
            return q * _about_midpoint(*_terms(rate, dtheta[0], subsamples, order, 2))
        (total,) = _terms(rate, dtheta[0], subsamples, order, 1)
        return q * rotation(named("u", total.scalar), named("v", total.vector))

    return written


def _terms(a: History, like: Vector, n: int, order: int, sums: int) -> list[Quaternion]:
    """Write r_1 .. r_P; return their sum and, where two sums are asked for, that with alternating signs.

    Both are without r_0 = 1, so that no digit of them is lost.
    """
    first = next(iter(like))
    inverse = table("inverse", like, [F(0), *(F(1, k) for k in range(1, order + 1))])
    signs = table("sign", like, [F((-1) ** (k * s)) for s in range(sums) for k in range(order + 1)])
    r, t = history("r", first, 6 * (order + n)), history("term", first, 4)
    totals = history("total", first, 4 * sums)
    zero = number(0, like)
    for i in loop("i", like, 0, 6 * n - 1):
        r[i] = zero
    r[6 * (n - 1)] = number(1, like)
    for i in loop("i", like, 0, 4 * sums - 1):
        totals[i] = zero
    heading("r_0 = 1", "xu2019 (8)", like)
    terms: list[Quaternion] = []
    for k in loop("n", like, 1, order):
        for i in loop("i", like, 0, 3):
            t[i] = zero
        for j in loop("j", like, 0, n - 1):
            _add_product(t, r, 6 * (k - 1 - j + n - 1), a, 5 * j, like)
        base = 6 * (k + n - 1)
        for i in loop("i", like, 0, 3):
            r[base + i] = component(f"r{k}", i, inverse[k] * t[i], "wxyz")
            for s in range(sums):
                term = r[base + i] if s == 0 else signs[k + s * (order + 1)] * r[base + i]
                totals[4 * s + i] = totals[4 * s + i] + term
        r[base + 4] = r[base + 1]
        r[base + 5] = r[base + 2]
        if isinstance(k, int):
            terms.append(_record(r, a, k, n))
        heading(f"r_{k} = 1/{k} sum_j r_({k}-1-j) (x) A_j", "xu2019 (7)", like)
    alternating = ", and with alternating signs" if sums == 2 else ""
    heading(f"total = r_1 + ... + r_{order}{alternating}", "xu2019 (8)", like)
    parts = [[totals[4 * s + i] for i in range(4)] for s in range(sums)]
    whole = [quaternion(w, vector(x, y, z)) for w, x, y, z in parts]
    for each in whole:
        recorded_sum(each, terms)
    return whole


def _record(r: History, a: History, k: int, n: int) -> Quaternion:
    """Return the term r_k as a quaternion, on record as 1/k sum_j r_(k-1-j) (x) A_j."""

    def at(index: int) -> Quaternion:
        return quaternion(r[index], vector(r[index + 1], r[index + 2], r[index + 3]))

    term = at(6 * (k + n - 1))
    pairs = [(at(6 * (k - 1 - j + n - 1)), vector(a[5 * j], a[5 * j + 1], a[5 * j + 2])) for j in range(min(k, n))]
    recorded_products(term, pairs, F(1, k))
    return term


def _add_product(t: History, r: History, base: Number, a: History, lag: Number, like: Vector) -> None:
    """Add the product of a term and a pure quaternion to t. Components lie as w, x, y, z, x, y and x, y, z, x, y."""
    for i in loop("i", like, 0, 2):
        t[0] = t[0] - r[base + 1 + i] * a[lag + i]
        first = t[1 + i] + r[base] * a[lag + i]
        t[1 + i] = first + r[base + 2 + i] * a[lag + i + 2] - r[base + 3 + i] * a[lag + i + 1]


def _about_midpoint(b: Quaternion, a: Quaternion) -> Rotation | Quaternion:
    """Write r = (1 + a)* (x) (1 + b) as the rotation [1 + u, v]: r - 1 = a* + b + a* (x) b."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    u = aw + bw + (aw * bw + ax * bx + ay * by + az * bz)
    x = bx - ax + (aw * bx - ax * bw - ay * bz + az * by)
    y = by - ay + (aw * by - ay * bw - az * bx + ax * bz)
    z = bz - az + (aw * bz - az * bw - ax * by + ay * bx)
    u = step("u = scalar part of r - 1", "r = (E - O)* (x) (E + O)", u)
    return rotation(u, step("v = vector part of r", "r = (E - O)* (x) (E + O)", vector(x, y, z)))


FAMILY = Family(
    id="quaternion-taylor",
    title="Taylor series of the quaternion for a polynomial rate",
    source=SOURCE,
    parameters=(
        Choice("subsamples", (1, 2, 3, 4, 5, 6), 1, "angle increments in one update"),
        Choice("order", tuple(range(1, MOST_ORDER + 1)), 10, "order of the series"),
        Choice("about", ABOUT, "start", "point the series is taken about"),
    ),
    make=lambda values: quaternion_taylor(
        int(str(values["subsamples"])), int(str(values["order"])), str(values["about"] or "start")
    ),
    examples=tuple({"subsamples": n, "order": order, "about": about} for n, order in ORDERS.items() for about in ABOUT),
    caution=low_order,
)
