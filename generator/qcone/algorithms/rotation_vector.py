"""Rotation-vector algorithms: N angle increments make one rotation vector, its exponential the update.

phi = S + sum k_ij theta_i x theta_j (cao (12), xu2019 (4)); the weights are derived in `coefficients`.
A set that is symmetric in time needs only floor(N/2) cross products: with p_i = theta_i + theta_(N+1-i)
and d_j = theta_(N+1-j) - theta_j the second-order term is sum_j (sum_i c_ij p_i) x d_j. Sums are formed
by symmetric pairs, so that reversing time negates phi to the last bit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from qcone.algorithms import coefficients as weights
from qcone.algorithms.family import Choice, Conflict, Family, Values
from qcone.ir.real import Algorithm, F, Quaternion, Source, Vector, algorithm, cross, exp, step

Vectors = Sequence[Vector]
SETS = ("taylor", "coning", "expanded", "compressed")
SOURCES: Mapping[str, Source] = {
    "taylor": Source("xu2019", "(4)"),
    "coning": Source("cao", "(12)"),
    "expanded": Source("song2013", "expanded coning, derived here"),
    "compressed": Source("ignagni1990", "compressed coning, derived here"),
}
SYMMETRIC = frozenset({"cyclic", "flip", "time-reversal", "constant-rate"})
LEFT_TO_RIGHT = SYMMETRIC - {"time-reversal"}
"""Symmetric weights, but a sum of three or more increments in their order: reversing time reorders it."""
ONE_SIDED = frozenset({"cyclic", "flip"})


def _example(subsamples: int, coefficients: str | None = None, previous: int = 0) -> Values:
    return {"subsamples": subsamples, "coefficients": coefficients, "previous": previous}


EXAMPLES = (
    _example(1),
    *(_example(n, each) for n in range(2, 7) for each in SETS),
    *(_example(1, previous=count) for count in range(1, 6)),
)


def rotation_vector(subsamples: int, coefficients: str | None, previous: int = 0) -> Algorithm:
    """Return the algorithm for N = 1..6 sub-samples, or for one sub-sample with 1..5 previous increments."""
    if previous:
        return _with_history(previous)
    if subsamples == 1 or coefficients is None:
        return _single()
    return _multiple(subsamples, coefficients)


def _single() -> Algorithm:
    @algorithm(
        "rotation-vector-1",
        source=Source("cao", "(8), (9)"),
        subsamples=1,
        order=2,
        properties=SYMMETRIC,
        summary="phi = theta",
    )
    def single(q: Quaternion, dtheta: Vectors) -> Any:
        (theta,) = dtheta
        return q * exp(step("phi = theta", "cao (8)", theta))

    return single


def _multiple(n: int, coefficients: str) -> Algorithm:
    pairs = weights.pair_weights(n, coefficients)
    source = SOURCES[coefficients]
    lopsided = coefficients == "compressed" and n > 2
    symmetric_as_written = SYMMETRIC if n == 2 else LEFT_TO_RIGHT

    @algorithm(
        f"rotation-vector-{n}-{coefficients}",
        source=Source(source.key, f"{source.equation}, cao (14)"),
        subsamples=n,
        order=3 if lopsided else 4,
        properties=ONE_SIDED if lopsided else SYMMETRIC,
        written_properties=ONE_SIDED if coefficients == "compressed" else symmetric_as_written,
        summary=_written_text(n, pairs, coefficients),
    )
    def multiple(q: Quaternion, dtheta: Vectors) -> Any:
        return q * exp(
            step(_written_text(n, pairs, coefficients), str(source), _as_written(dtheta, pairs, coefficients))
        )

    @multiple.factored
    def factored(q: Quaternion, dtheta: Vectors) -> Any:
        total, sums, differences = _pairwise(dtheta)
        coning = _compressed(dtheta, pairs) if lopsided else _factored(total, sums, differences, pairs, n, str(source))
        return q * exp(step("phi = S + coning", str(source), total + coning))

    return multiple


def _with_history(count: int) -> Algorithm:
    lags = weights.history_weights(count)
    source = Source("savage1998", "(46)")

    @algorithm(
        f"rotation-vector-1-previous-{count}",
        source=source,
        subsamples=1,
        previous=count,
        order=3,
        properties=ONE_SIDED,
        startup=_single(),
        summary=f"phi = theta + ({_lag_text(lags)}) x theta",
    )
    def sliding(q: Quaternion, dtheta: Vectors, previous: Vectors) -> Any:
        (theta,) = dtheta
        before = step(f"h = {_lag_text(lags)}", str(source), _weighted(lags, previous))
        coning = step("coning = h x theta", str(source), cross(before, theta))
        return q * exp(step("phi = theta + coning", str(source), theta + coning))

    return sliding


def _lag_text(lags: Sequence[F]) -> str:
    return " ".join(f"{_signed(c, i == 0)} theta[-{i + 1}]" for i, c in enumerate(lags))


def _as_written(dtheta: Sequence[Vector], pairs: weights.Pairs, coefficients: str) -> Vector:
    """Write phi as the papers do: for three sub-samples two cross products, else one for each pair."""
    total = dtheta[0]
    for theta in dtheta[1:]:
        total = total + theta
    if coefficients == "compressed":
        return total + cross(_weighted([pairs[i + 1, len(dtheta)] for i in range(len(dtheta) - 1)], dtheta), dtheta[-1])
    if len(dtheta) == 3:
        d1, d2, d3 = dtheta
        return total + pairs[1, 3] * cross(d1, d3) + pairs[1, 2] * cross(d2, d3 - d1)
    for (i, j), weight in sorted(pairs.items()):
        total = total + weight * cross(dtheta[i - 1], dtheta[j - 1])
    return total


def _written_text(n: int, pairs: weights.Pairs, coefficients: str) -> str:
    total = " + ".join(f"theta_{i}" for i in range(1, n + 1))
    if n == 3 and coefficients != "compressed":
        return f"phi = {total} + {pairs[1, 3]} theta_1 x theta_3 + {pairs[1, 2]} theta_2 x (theta_3 - theta_1)"
    if n == 2:
        return f"phi = {total} + {pairs[1, 2]} theta_1 x theta_2"
    if coefficients == "compressed":
        inner = " + ".join(f"{pairs[i, n]} theta_{i}" for i in range(1, n))
        return f"phi = {total} + ({inner}) x theta_{n}"
    return f"phi = {total} + sum k_ij theta_i x theta_j"


def _weighted(factors: Sequence[F], vectors: Sequence[Vector]) -> Vector:
    total = factors[0] * vectors[0]
    for factor, vector in zip(factors[1:], vectors[1:], strict=False):
        total = total + factor * vector
    return total


def _pairwise(dtheta: Sequence[Vector]) -> tuple[Vector, list[Vector], list[Vector]]:
    """Return S, the sums s_i (the middle increment last, for odd N) and the differences d_j."""
    n = len(dtheta)
    half = range(1, n // 2 + 1)

    def mark(i: int) -> str:
        return "" if n < 4 else str(i)

    sums = [step(f"p{mark(i)} = theta_{i} + theta_{n + 1 - i}", "", dtheta[i - 1] + dtheta[n - i]) for i in half]
    differences = [step(f"d{mark(j)} = theta_{n + 1 - j} - theta_{j}", "", dtheta[n - j] - dtheta[j - 1]) for j in half]
    text = " + ".join(f"p{mark(i)}" for i in half)
    total = sums[0]
    for each in sums[1:]:
        total = total + each
    if n % 2:
        middle = dtheta[n // 2]
        total, sums = total + middle, [*sums, middle]
        text += f" + theta_{n // 2 + 1}"
    return step(f"S = {text}", "", total), sums, differences


def _compressed(dtheta: Sequence[Vector], pairs: weights.Pairs) -> Vector:
    n = len(dtheta)
    factors = [pairs[i, n] for i in range(1, n)]
    text = " ".join(f"{_signed(c, i == 0)} theta_{i + 1}" for i, c in enumerate(factors))
    before = step(f"h = {text}", "ignagni1990", _weighted(factors, dtheta))
    return step(f"coning = h x theta_{n}", "ignagni1990", cross(before, dtheta[-1]))


def _factored(
    total: Vector, sums: list[Vector], differences: list[Vector], pairs: weights.Pairs, n: int, source: str
) -> Vector:
    table = sum_difference_weights(pairs, n)
    if n == 2:
        k = step(f"k = {table[0][0]} d", source, table[0][0] * differences[0])
        return step("coning = S x k", source, cross(total, k))
    if n == 3 and table[1][0] == 3 * table[0][0]:
        g = step("g = S + 2 theta_2", source, total + sums[1] + sums[1])
        k = step(f"k = {table[0][0]} d", source, table[0][0] * differences[0])
        return step("coning = g x k", source, cross(g, k))
    coning = None
    for j, difference in enumerate(differences):
        mark = "" if n < 4 else str(j + 1)
        column = [row[j] for row in table]
        names = [f"p{i + 1 if n > 3 else ''}" for i in range(n // 2)] + [f"theta_{n // 2 + 1}"] * (n % 2)
        text = " ".join(f"{_signed(c, i == 0)} {names[i]}" for i, c in enumerate(column))
        g = step(f"g{mark} = {text}", source, _weighted(column, sums))
        term = step(f"{'coning' if n < 4 else 'coning' + mark} = g{mark} x d{mark}", source, cross(g, difference))
        coning = term if coning is None else coning + term
    assert coning is not None
    return coning if n < 4 else step(f"coning = {_listing('coning', len(differences))}", source, coning)


def _listing(name: str, count: int) -> str:
    return " + ".join(f"{name}{i + 1}" for i in range(count))


def _signed(factor: F, first: bool) -> str:
    sign = "-" if factor < 0 else ("" if first else "+")
    return f"{sign}{'' if first or not sign else ' '}{abs(factor)}"


def sum_difference_weights(pairs: weights.Pairs, n: int) -> list[list[F]]:
    """Return c[i][j] with sum k_ij theta_i x theta_j = sum_j (sum_i c[i][j] s_i) x d_j.

    Raises ValueError for weights that are not symmetric in time: theirs leave other products over.
    """
    half, rows = n // 2, (n + 1) // 2
    table = [[F(0)] * half for _ in range(rows)]
    left_over: dict[tuple[str, int, int], F] = {}

    def parts(i: int) -> list[tuple[str, int, F]]:
        if i == n + 1 - i:
            return [("s", rows - 1, F(1))]
        place = min(i, n + 1 - i) - 1
        return [("s", place, F(1, 2)), ("d", place, F(-1 if i <= half else 1, 2))]

    for (i, j), weight in pairs.items():
        for a, p, f in parts(i):
            for b, r, g in parts(j):
                value = weight * f * g
                if (a, b) == ("s", "d"):
                    table[p][r] += value
                elif (a, b) == ("d", "s"):
                    table[r][p] -= value
                elif p != r:
                    key, sign = ((a, p, r), 1) if p < r else ((a, r, p), -1)
                    left_over[key] = left_over.get(key, F(0)) + sign * value
    if any(left_over.values()):
        raise ValueError("these pair weights are not symmetric in time")
    return table


def _conflicts(values: Values, given: frozenset[str]) -> list[Conflict]:
    found: list[Conflict] = []
    if values["subsamples"] == 1 and "coefficients" in given:
        found.append(
            (
                "coefficients",
                "coefficients belong to two or more sub-samples",
                "with subsamples = 1 there is no pair of increments to weigh",
                "leave the key out",
            )
        )
    if values["previous"] and values["subsamples"] != 1:
        found.append(
            (
                "previous",
                f"previous = {values['previous']} needs subsamples = 1",
                "the history form takes one new increment an update",
                "set subsamples = 1 or previous = 0",
            )
        )
    return found


def _make(values: Values) -> Algorithm:
    subsamples, previous = values["subsamples"], values["previous"] or 0
    coefficients = values.get("coefficients") or "coning"
    return rotation_vector(int(str(subsamples)), str(coefficients) if subsamples != 1 else None, int(previous))


FAMILY = Family(
    id="rotation-vector",
    title="rotation vector from N angle increments, coning corrected",
    source=Source("cao, xu2019", "(12); (4)"),
    parameters=(
        Choice("subsamples", (1, 2, 3, 4, 5, 6), 1, "angle increments in one update"),
        Choice("coefficients", SETS, None, "coning weights; coning unless given, none for one sub-sample"),
        Choice("previous", (0, 1, 2, 3, 4, 5), 0, "increments of earlier updates used, with one sub-sample"),
    ),
    make=_make,
    conflicts=_conflicts,
    examples=EXAMPLES,
)
"""`subsamples` 1 to 6 with one of four coefficient sets, or one sub-sample with up to five previous ones."""
