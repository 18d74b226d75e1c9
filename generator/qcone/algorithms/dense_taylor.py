"""The Taylor algorithms as xu2019 counts them: derivatives by dense matrix products, (7), (8), (11), (12).

D_0 = I, D_1 = M_0, D_n = sum_i binom(n-1, i) M_i D_(n-1-i); R = I + sum h^n/n! D_n. A product with I is free, every
other is dense: 64 products and 48 additions for 4 x 4, 27 and 18 for 3 x 3. Nothing here is meant for firmware: it is
the form the paper's table 1 is about. The constants of (13) and the side of (11) are corrected.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import comb, factorial
from typing import Any

from qcone.algorithms.coefficients import rate_fit
from qcone.ir.real import F, Matrix, Quaternion, Scalar, Vector, heading, matrix, number, quaternion, step, vector

Dense = list[list[Scalar]]


def dense_products(subsamples: int, order: int) -> int:
    """Return how many dense products the recursion takes: those with D_0 = I are free."""
    return sum(min(n - 1, subsamples) for n in range(2, order + 1))


def quaternion_dense(q: Quaternion, dtheta: Sequence[Vector], interval: Fraction, order: int) -> Quaternion:
    """Write q' = R q with the 4 x 4 matrices of q' = 1/2 M'(omega) q."""
    rates = _derivatives(dtheta, interval, F(1, 2))
    matrices = [_right_multiplication(rate) for rate in rates]
    result = _series(matrices, order, interval, left=True, near=q)
    w, x, y, z = (_row_product(row, list(q)) for row in result)
    return step("q_next = R q", "xu2019 (8)", quaternion(w, vector(x, y, z)))


def dcm_dense(c: Matrix, dtheta: Sequence[Vector], interval: Fraction, order: int) -> Matrix:
    """Write C' = C R with the 3 x 3 matrices of C' = C [omega x]."""
    rates = _derivatives(dtheta, interval, F(1))
    result = _series([_skew(rate) for rate in rates], order, interval, left=False, near=c)
    entries = list(c)
    old = [entries[3 * i : 3 * i + 3] for i in range(3)]
    new = _product(old, result)
    return step("c_next = C R", "xu2019 (12)", matrix([entry for row in new for entry in row]))


def _derivatives(dtheta: Sequence[Vector], interval: Fraction, factor: F) -> list[Vector]:
    """Write the rate and its derivatives at the start of the update, times `factor`.

    For three sub-samples as (9) writes the parabola: a, 2 b, 6 c from the increments.
    """
    if len(dtheta) == 3:
        d1, d2, d3 = dtheta
        near = d1
        squared, cubed = number(1 / interval**2, near), number(1 / interval**3, near)
        a = step(
            "a = (11 th1 - 7 th2 + 2 th3)/(2 h)", "xu2019 (9)", (factor / (2 * interval)) * (11 * d1 - 7 * d2 + 2 * d3)
        )
        b = step("b = 9/2 (3 th2 - (2 th1 + th3))/h^2", "xu2019 (9)", (9 * factor * squared) * (3 * d2 - (2 * d1 + d3)))
        c = step("c = 9/2 (th1 - 2 th2 + th3)/h^3", "xu2019 (9)", (27 * factor * cubed) * (d1 - 2 * d2 + d3))
        return [a, b, c]
    rates = []
    for j, row in enumerate(rate_fit(len(dtheta))):
        total = row[0] * dtheta[0]
        for weight, theta in zip(row[1:], dtheta[1:], strict=True):
            total = total + weight * theta
        scale = factor * factorial(j) / interval ** (j + 1)
        rates.append(step(f"w{j} = derivative {j} of the rate at the start", "xu2019 (9)", scale * total))
    return rates


def _series(matrices: list[Dense], order: int, interval: Fraction, left: bool, near: Any) -> Dense:
    """Write R = I + sum h^n/n! D_n by the binomial rule, (7) or (11)."""
    size = len(matrices[0])
    unit = [[number(int(i == k), near) for k in range(size)] for i in range(size)]
    terms: list[Dense | None] = [None, matrices[0]]
    for n in range(2, order + 1):
        total: Dense | None = None
        for i in range(min(n, len(matrices))):
            before = terms[n - 1 - i]
            if before is None:
                part = matrices[i]
            else:
                part = _product(matrices[i], before) if left else _product(before, matrices[i])
            part = part if i == 0 else _scaled(comb(n - 1, i), part)
            total = part if total is None else _sum(total, part)
        terms.append(total)
        heading(f"D_{n} = sum_i binom({n - 1}, i) M_i D_({n - 1}-i)", "xu2019 (7)" if left else "xu2019 (11)", near)
    result = unit
    for n, term in enumerate(terms):
        if term is not None:
            result = _sum(result, _scaled(interval**n / factorial(n), term))
    heading("R = I + sum h^n/n! D_n", "xu2019 (8)" if left else "xu2019 (12)", near)
    return result


def _right_multiplication(v: Vector) -> Dense:
    """Write the matrix M'(v) with M' q = q (x) (0, v)."""
    x, y, z = v
    zero = number(0, v)
    return [[zero, -x, -y, -z], [x, zero, z, -y], [y, -z, zero, x], [z, y, -x, zero]]


def _skew(v: Vector) -> Dense:
    """Write [v x]."""
    x, y, z = v
    zero = number(0, v)
    return [[zero, -z, y], [z, zero, -x], [-y, x, zero]]


def _product(a: Dense, b: Dense) -> Dense:
    columns = [list(column) for column in zip(*b, strict=True)]
    return [[_row_product(row, column) for column in columns] for row in a]


def _row_product(row: Sequence[Scalar], column: Sequence[Scalar]) -> Scalar:
    first, *others = (p * q for p, q in zip(row, column, strict=True))
    for other in others:
        first = first + other
    return first


def _scaled(factor: Fraction | int, a: Dense) -> Dense:
    return [[factor * entry for entry in row] for row in a]


def _sum(a: Dense, b: Dense) -> Dense:
    return [[p + q for p, q in zip(first, second, strict=True)] for first, second in zip(a, b, strict=True)]
