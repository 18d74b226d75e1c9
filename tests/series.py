"""The Taylor series of xu2019 in 40 digits, from the published tables of the reference: what one update must give."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from exactly import EXACT
from qcone.reference.taylor import ABOUT_MIDPOINT, ABOUT_START

Digits = list[Any]
"""Components to 40 digits."""


def product(p: Sequence[Any], q: Sequence[Any]) -> Digits:
    return [
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    ]


def conjugate(q: Sequence[Any]) -> Digits:
    return [q[0], -q[1], -q[2], -q[3]]


def cross(a: Sequence[Any], b: Sequence[Any]) -> Digits:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(*rows: Sequence[Any]) -> Digits:
    return [sum(column, EXACT.mpf(0)) for column in zip(*rows, strict=True)]


def times(factor: Any, row: Sequence[Any]) -> Digits:
    return [factor * value for value in row]


def matrix(q: Sequence[Any]) -> Digits:
    """Return C_nb of a quaternion of any length, row major."""
    w, x, y, z = times(1 / EXACT.norm(q), q)
    return [
        *(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        *(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        *(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    ]


def rate(theta: Sequence[Sequence[Any]], about: str) -> list[Digits]:
    """Return W_j with omega T = sum_j W_j x^j through the increments (N, 3)."""
    table = (ABOUT_START if about == "start" else ABOUT_MIDPOINT)[len(theta)]
    rows = [plus(*(times(factor, row) for factor, row in zip(top, theta, strict=True))) for _, top in table]
    return [times(EXACT.mpf(1) / bottom, row) for (bottom, _), row in zip(table, rows, strict=True)]


def quaternion_series(theta: Sequence[Sequence[Any]], order: int, about: str) -> Digits:
    """Return r to that order: the sum of r_n = 1/n sum_j r_(n-1-j) (x) A_j, or conj(E - O) (x) (E + O)."""
    a = [[EXACT.mpf(0), *times(EXACT.mpf(1) / 2, row)] for row in rate(theta, about)]
    one = list(map(EXACT.mpf, (1, 0, 0, 0)))
    terms = [one]
    for n in range(1, order + 1):
        products = [product(terms[n - 1 - j], a[j]) for j in range(min(n, len(a)))]
        terms.append(times(EXACT.mpf(1) / n, plus(*products)))
    if about == "start":
        return plus(*terms)
    ahead = plus(*(times(EXACT.mpf(2) ** -n, term) for n, term in enumerate(terms)))
    behind = plus(*(times((-EXACT.mpf(2)) ** -n, term) for n, term in enumerate(terms)))
    return product(conjugate(behind), ahead)


def matrix_series(theta: Sequence[Sequence[Any]], order: int) -> Digits:
    """Return C after one update from the identity: two rows by the series, the third their cross product."""
    w = rate(theta, "start")
    rows = []
    for axis in range(2):
        terms = [[EXACT.mpf(int(axis == k)) for k in range(3)]]
        for n in range(1, order + 1):
            products = [cross(terms[n - 1 - j], w[j]) for j in range(min(n, len(w)))]
            terms.append(times(EXACT.mpf(1) / n, plus(*products)))
        rows.append(plus(*terms))
    return [*rows[0], *rows[1], *cross(*rows)]
