"""The rate as a polynomial: from N angle increments to its coefficients, by Newton's forward differences.

omega(u) T = sum_j W_j u^j about the start of the update (xu2019 (2), (9)), or sum_j w_j v^j about its middle,
v = u - 1/2. In terms of f_0 = theta_1, f_1 = theta_2 - theta_1, f_2 = theta_3 - 2 theta_2 + theta_1, ... the
first table is triangular: fewer products, and differences of neighbours lose no digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction as F  # noqa: N817  as the papers' fractions are written
from functools import cache
from math import comb

from qcone.algorithms.coefficients import rate_fit
from qcone.algorithms.family import Values
from qcone.ir.real import History, Index, Scalar, Vector, heading, history, loop, named, number, table

Table = tuple[tuple[F, ...], ...]
ORDERS = {1: 10, 2: 10, 3: 10, 4: 10, 5: 12, 6: 16}
"""Orders of the series that leave the fit's own error alone, by sub-samples; xu2019 takes 10 for three."""


@cache
def difference_table(subsamples: int, about: str) -> Table:
    """Return B with W_j = sum_k B[j][k] f_k, `about` "start" or "midpoint"."""
    n = subsamples
    fit = rate_fit(n) if about == "start" else _about_midpoint(rate_fit(n))
    # theta_(i+1) = sum_k C(i, k) f_k
    return tuple(tuple(sum((row[i] * comb(i, k) for i in range(n)), F(0)) for k in range(n)) for row in fit)


def _about_midpoint(fit: Table) -> Table:
    """Return the fit in powers of v = u - 1/2."""
    n = len(fit)
    half = F(1, 2)
    return tuple(
        tuple(sum((fit[k][i] * comb(k, j) * half ** (k - j) for k in range(j, n)), F(0)) for i in range(n))
        for j in range(n)
    )


def in_components(name: str, dtheta: Sequence[Vector], about: str, scale: Sequence[F]) -> History:
    """Write the rate's coefficients, the j-th times scale[j], as components x, y, z, x, y each.

    The repeated components let a loop over axes index a cross product without a remainder.
    """
    n, like = len(dtheta), dtheta[0]
    first = next(iter(like))
    f = history("f", first, 3 * n)
    for k, theta in enumerate(dtheta):
        for i, part in enumerate(theta):
            f[3 * k + i] = part
    for k in loop("k", like, 1, n - 1):
        for i in loop("i", like, 0, 3 * n - 1 - 3 * k):
            f[3 * n - 1 - i] = f[3 * n - 1 - i] - f[3 * n - 4 - i]
    heading("f_k = forward differences of theta_1 .. theta_N", "", like)
    rows = difference_table(n, about)
    weights = table("fit", like, [scale[j] * rows[j][k] for j in range(n) for k in range(n)])
    a = history(name, first, 5 * n)
    total = history("sum", first, 1)
    for j in loop("j", like, 0, n - 1):
        for i in loop("i", like, 0, 2):
            total[0] = number(0, like)
            for k in loop("k", like, 0, n - 1):
                total[0] = total[0] + weights[n * j + k] * f[3 * k + i]
            a[5 * j + i] = component(f"{name}{j}", i, total[0])
        a[5 * j + 3] = a[5 * j]
        a[5 * j + 4] = a[5 * j + 1]
    heading(f"{name}_j = sum_k fit_jk f_k, coefficients of the rate", "xu2019 (9)", like)
    return a


def component(name: str, part: int | Index, value: Scalar, letters: str = "xyz") -> Scalar:
    """Name a component after its letter where loops are written out."""
    return named(f"{name}_{letters[part]}", value) if isinstance(part, int) else value


def order_of_accuracy(subsamples: int, order: int, about: str = "start") -> int:
    """Return the global order of a fit through N increments solved by a series of that order.

    A symmetric stencil of N samples supports 2 floor(N/2) + 2: more terms of the series cannot pass that. A shorter
    series stops at its own order. About the midpoint, and for one sub-sample, whose axis stands still, the first
    term left out after an odd order changes the length alone, so that the next even order is reached.
    """
    gains = about == "midpoint" or subsamples == 1
    return min(2 * (subsamples // 2) + 2, order + order % 2 if gains else order)


def low_order(values: Values) -> str | None:
    """Return why an order is too low for the sub-samples; None when it is not."""
    order, n = int(str(values["order"])), int(str(values["subsamples"]))
    if order >= 2 * n:
        return None
    return f"order = {order} drops second-order terms of the fit through {n} sub-samples: use order >= {2 * n}"
