"""Multi-sub-sample direction cosine algorithm: a Taylor series for a polynomial rate, xu2019 (10) to (13).

C' = C [omega x] means that every row v of C obeys v' = v x omega, so v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j:
six products where a 3 x 3 product takes 27. Two rows are carried on, the third is their cross product. The
paper's (13) prints [a x], [b x], [c x] for derivatives of the rate; the constants 1, 2, 6 are missing there, and
(11) has Omega on the wrong side: both are used corrected.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from qcone.algorithms.dense_taylor import dcm_dense
from qcone.algorithms.family import Choice, Family
from qcone.algorithms.polynomial_rate import ORDERS, component, in_components, low_order, order_of_accuracy
from qcone.algorithms.quaternion_taylor import MOST_ORDER
from qcone.ir.real import (
    Algorithm,
    F,
    History,
    Matrix,
    Source,
    Vector,
    algorithm,
    heading,
    history,
    loop,
    number,
    recorded_products,
    recorded_sum,
    rows,
    step,
    table,
    vector,
)

SOURCE = Source("xu2019", "(10) to (13), (11) and (13) corrected")


def dcm_taylor(subsamples: int, order: int) -> Algorithm:
    """Return the series of that order for N = 1..6 sub-samples."""

    @algorithm(
        f"dcm-taylor-{subsamples}-{order}",
        source=SOURCE,
        subsamples=subsamples,
        order=order_of_accuracy(subsamples, order),
        properties=frozenset({"flip"}),
        summary="v_0 = v, v_n = 1/n sum_j v_(n-1-j) x W_j, row by row",
        errata=("xu2019 (11) multiplies from the wrong side", "xu2019 (13) lacks the constants 1, 2, 6"),
        state="dcm",
    )
    def written(c: Matrix, dtheta: Sequence[Vector], interval: Fraction) -> Any:
        return dcm_dense(c, dtheta, interval, order)

    @written.factored
    def series(c: Matrix, dtheta: Sequence[Vector]) -> Any:
        rate = in_components("W", dtheta, "start", [F(1)] * subsamples)
        first = _row("a", c.row(0), rate, subsamples, order)
        second = _row("b", c.row(1), rate, subsamples, order)
        return rows(c, first, second)

    return written


def _row(name: str, row: Vector, w: History, n: int, order: int) -> Vector:
    """Write v_1 .. v_P of one row and return their sum: the row's increment."""
    first = next(iter(row))
    zero = number(0, row)
    inverse = table(f"inverse_{name}", row, [F(0), *(F(1, k) for k in range(1, order + 1))])
    v, t, total = history(name, first, 5 * (order + n)), history(f"t_{name}", first, 3), history(f"d{name}", first, 3)
    for i in loop("i", row, 0, 5 * n - 1):
        v[i] = zero
    start = 5 * (n - 1)
    for i, part in enumerate((*row, *list(row)[:2])):
        v[start + i] = part
    for i in loop("i", row, 0, 2):
        total[i] = zero
    heading(f"{name}_0 = a row of C", "xu2019 (12)", row)
    terms: list[Vector] = []
    for k in loop("n", row, 1, order):
        for i in loop("i", row, 0, 2):
            t[i] = zero
            for j in loop("j", row, 0, n - 1):
                base = 5 * (k - 1 - j + n - 1)
                t[i] = t[i] + v[base + 1 + i] * w[5 * j + 2 + i] - v[base + 2 + i] * w[5 * j + 1 + i]
        base = 5 * (k + n - 1)
        for i in loop("i", row, 0, 2):
            v[base + i] = component(f"{name}{k}", i, inverse[k] * t[i])
            total[i] = total[i] + v[base + i]
        v[base + 3] = v[base]
        v[base + 4] = v[base + 1]
        if isinstance(k, int):
            terms.append(_record(v, w, k, n))
        heading(f"{name}_{k} = 1/{k} sum_j {name}_({k}-1-j) x W_j", "xu2019 (13)", row)
    change = step(f"d{name} = sum {name}_n", "xu2019 (12)", vector(total[0], total[1], total[2]))
    recorded_sum(change, terms)
    return change


def _record(v: History, w: History, k: int, n: int) -> Vector:
    """Return the term v_k as a vector, on record as 1/k sum_j v_(k-1-j) x W_j."""

    def at(index: int) -> Vector:
        return vector(v[index], v[index + 1], v[index + 2])

    term = at(5 * (k + n - 1))
    lags = range(min(k, n))
    recorded_products(term, [(at(5 * (k - 1 - j + n - 1)), _coefficient(w, j)) for j in lags], F(1, k))
    return term


def _coefficient(w: History, j: int) -> Vector:
    return vector(w[5 * j], w[5 * j + 1], w[5 * j + 2])


FAMILY = Family(
    id="dcm-taylor",
    title="Taylor series of the direction cosine matrix for a polynomial rate",
    source=SOURCE,
    parameters=(
        Choice("subsamples", (1, 2, 3, 4, 5, 6), 1, "angle increments in one update"),
        Choice("order", tuple(range(1, MOST_ORDER + 1)), 10, "order of the series"),
    ),
    make=lambda values: dcm_taylor(int(str(values["subsamples"])), int(str(values["order"]))),
    examples=tuple({"subsamples": n, "order": order} for n, order in ORDERS.items()),
    caution=low_order,
)
