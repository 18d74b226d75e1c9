"""Coefficients of the rotation-vector algorithms, derived from first principles over the rationals.

Notation: N sub-samples of equal length make one update of length 1; theta_i are their angle increments.
phi = S + sum k_ij theta_i x theta_j (i < j), S = sum theta_i, is the rotation vector to second order.

taylor      fit the rate by the polynomial of degree N - 1 whose integrals are the increments, integrate
            Bortz' 1/2 alpha x omega exactly (xu2019 (2) to (4))
coning      choose only the sum K_d of the weights of all pairs d apart, so that the drift in pure coning
            vanishes to the highest order; spread K_d evenly over its pairs (cao (12) for N = 3)
compressed  the same K_d, all of it on the pair with the last increment
expanded    the same K_d, and the exact second-order moments of `taylor` as far as freedom is left
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction as F  # noqa: N817  as the papers' fractions are written
from functools import cache
from math import factorial

from qcone.elimination import rank, solve

Pairs = Mapping[tuple[int, int], F]
"""Weight of theta_i x theta_j for i < j, counted from 1."""


def pair_weights(subsamples: int, coefficients: str) -> Pairs:
    """Return the pair weights of one of the four sets, N = 2..6; KeyError for another name."""
    return {"taylor": taylor, "coning": coning, "compressed": compressed, "expanded": expanded}[coefficients](
        subsamples
    )


@cache
def rate_fit(subsamples: int) -> tuple[tuple[F, ...], ...]:
    """Return M with omega(u) = sum_j u^j sum_i M[j][i] theta_i on u in [0, 1]: the fit through the increments."""
    n = subsamples
    integrals = [[(F(i + 1, n) ** (j + 1) - F(i, n) ** (j + 1)) / (j + 1) for j in range(n)] for i in range(n)]
    columns = [solve(integrals, [F(int(i == k)) for i in range(n)]) for k in range(n)]
    return tuple(tuple(columns[i][j] for i in range(n)) for j in range(n))


@cache
def taylor(subsamples: int) -> Pairs:
    """Return the weights of the polynomial fit: those of 1/2 int alpha x omega over the update."""
    fit, n = rate_fit(subsamples), subsamples
    moments = [[F(1, (j + 1) * (j + k + 2)) for k in range(n)] for j in range(n)]

    def weight(a: int, b: int) -> F:
        products = (moments[j][k] * fit[j][a] * fit[k][b] for j in range(n) for k in range(n))
        return sum(products, F(0)) / 2

    return {(a + 1, b + 1): weight(a, b) - weight(b, a) for a in range(n) for b in range(a + 1, n)}


@cache
def coning_totals(subsamples: int) -> tuple[F, ...]:
    """Return K_1 .. K_(N-1): the total weight of pairs d apart that nulls the coning drift up to x^(2N-1).

    For a classical coning motion, x its phase in one sub-sample, the drift of one update is proportional to
    (N x - sin N x)/2 - 2 (1 - cos x) sum_d K_d sin(d x).
    """
    n = subsamples
    return _null([_series_of_drift(d) for d in range(1, n)], _missing(n), n - 1)


def coning_residual(subsamples: int, coefficients: str) -> tuple[int, F]:
    """Return p and c: the drift one update leaves in pure coning is c a^2 x^p to leading order.

    `a` is the half-cone angle, x the phase of the motion in one sub-sample.
    """
    totals = [F(0)] * subsamples
    for (i, j), weight in (pair_weights(subsamples, coefficients) if subsamples > 1 else {}).items():
        totals[j - i] += weight
    left = list(_missing(subsamples))
    for d in range(1, subsamples):
        left = [value - totals[d] * term for value, term in zip(left, _series_of_drift(d), strict=True)]
    power, value = next((3 + 2 * k, value) for k, value in enumerate(left) if value)
    return power, value


@cache
def history_weights(previous: int) -> tuple[F, ...]:
    """Return c_1 .. c_P of phi = theta + (sum c_p theta_(-p)) x theta, nulling the coning drift up to x^(2P+1)."""
    return _null([_series_of_drift(p) for p in range(1, previous + 1)], _missing(1), previous)


def _missing(n: int) -> list[F]:
    """Return the odd Taylor coefficients, from x^3 on, of (n x - sin(n x))/2."""
    return [-_sine(n, power) / 2 for power in range(3, 3 + 2 * ORDERS, 2)]


def _series_of_drift(d: int) -> list[F]:
    """Return the odd Taylor coefficients, from x^3 on, of 2 (1 - cos x) sin(d x): products of sines as sums."""
    return [2 * _sine(d, p) - _sine(d + 1, p) - _sine(d - 1, p) for p in range(3, 3 + 2 * ORDERS, 2)]


ORDERS = 12


def _sine(d: int, power: int) -> F:
    return F((-1) ** (power // 2) * d**power, factorial(power))


def _null(columns: Sequence[Sequence[F]], target: Sequence[F], count: int) -> tuple[F, ...]:
    rows = [[column[row] for column in columns] for row in range(count)]
    return tuple(solve(rows, list(target[:count])))


@cache
def coning(subsamples: int) -> Pairs:
    """Return the coning-optimal totals spread evenly over the pairs of each spacing: symmetric in time."""
    n, totals = subsamples, coning_totals(subsamples)
    return {(i, i + d): totals[d - 1] / (n - d) for d in range(1, n) for i in range(1, n - d + 1)}


@cache
def compressed(subsamples: int) -> Pairs:
    """Return the coning-optimal totals, each on its pair with the last increment."""
    n, totals = subsamples, coning_totals(subsamples)
    return {(n - d, n): totals[d - 1] for d in range(n - 1, 0, -1)}


@cache
def expanded(subsamples: int) -> Pairs:
    """Return the time-symmetric weights with coning-optimal totals and, as far as possible, exact moments.

    The moments are the coefficients of w_a x w_b in the second-order term, where omega = sum w_j v^j about
    the middle of the update. They are demanded in order of total degree a + b, the lowest first and those of
    w_5, which increments determine worst, last in their degree, until the weights are determined.
    """
    n = subsamples
    pairs = sorted({min((i, j), (n + 1 - j, n + 1 - i)) for i in range(1, n) for j in range(i + 1, n + 1)})
    rows = [[F(_mirrors(pair, n) if pair[1] - pair[0] == d else 0) for pair in pairs] for d in range(1, n)]
    right = list(coning_totals(n))
    exact = taylor(n)
    moments = [(a, b) for a in range(n) for b in range(a + 1, n) if (a + b) % 2]
    for a, b in sorted(moments, key=lambda m: (sum(m), m[1] == 5, m)):
        row = [sum((_moment(p, a, b, n) for p in _both(pair, n)), F(0)) for pair in pairs]
        goal = sum((weight * _moment(pair, a, b, n) for pair, weight in exact.items()), F(0))
        if rank(rows) < len(pairs) and rank([*rows, row]) > rank(rows):
            rows.append(row)
            right.append(goal)
    chosen, sides = _independent(rows, right)
    weights = dict(zip(pairs, solve(chosen, sides), strict=True))
    return {mirror: weights[pair] for pair in pairs for mirror in _both(pair, n)}


def _both(pair: tuple[int, int], n: int) -> list[tuple[int, int]]:
    return sorted({pair, (n + 1 - pair[1], n + 1 - pair[0])})


def _mirrors(pair: tuple[int, int], n: int) -> int:
    return len(_both(pair, n))


def _moment(pair: tuple[int, int], a: int, b: int, n: int) -> F:
    """Return what theta_i x theta_j contributes to w_a x w_b."""

    def part(i: int, power: int) -> F:
        start, end = F(i - 1, n) - F(1, 2), F(i, n) - F(1, 2)
        return (end ** (power + 1) - start ** (power + 1)) / (power + 1)

    i, j = pair
    return part(i, a) * part(j, b) - part(i, b) * part(j, a)


def _independent(rows: Sequence[Sequence[F]], right: Sequence[F]) -> tuple[list[list[F]], list[F]]:
    chosen: list[list[F]] = []
    sides: list[F] = []
    for row, side in zip(rows, right, strict=True):
        if rank([*chosen, list(row)]) > len(chosen):
            chosen.append(list(row))
            sides.append(side)
    return chosen, sides


@cache
def rates_to_increments(subsamples: int) -> tuple[tuple[F, ...], ...]:
    """Return R with theta_i = T sum_j R[i][j] omega_j: the polynomial through N + 1 rate samples, integrated."""
    n = subsamples
    nodes = [[F(k, n) ** j for j in range(n + 1)] for k in range(n + 1)]
    rows = []
    for i in range(n):
        integrals = [(F(i + 1, n) ** (j + 1) - F(i, n) ** (j + 1)) / (j + 1) for j in range(n + 1)]
        transposed = [[nodes[k][j] for k in range(n + 1)] for j in range(n + 1)]
        rows.append(tuple(solve(transposed, integrals)))
    return tuple(rows)


CAO_13: tuple[tuple[F, ...], ...] = (
    (F(5, 36), F(8, 36), F(-1, 36), F(0)),
    (F(-1, 36), F(8, 36), F(5, 36), F(0)),
    (F(0), F(-1, 36), F(8, 36), F(5, 36)),
)
"""cao (13), three-node weights on omega(0), omega(T/3), omega(2T/3), omega(T). The third row is corrected: the
paper prints it on omega(0) and omega(T/3), which is not even of first order. A test derives all three."""
