"""R1 and R2: coefficients derived over the rationals, and the drift in pure coning to a hundred digits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal, localcontext
from fractions import Fraction
from math import comb

from qcone.algorithms import coefficients as derived
from qcone.algorithms.polynomial_rate import difference_table
from qcone.algorithms.rotation_vector import sum_difference_weights
from qcone.reference import taylor, weights
from qcone.studies.claims.claim import Claim, Settings, judged, verdict_of

F = Fraction
Vector = tuple[Decimal, Decimal, Decimal]
Row = Sequence[Fraction]
Found = Sequence[tuple[Row, Row]]
Quaternion = tuple[Decimal, ...]

DIGITS = 120
CONE, PHASE = Decimal("1e-12"), Decimal("0.02")
"""Half-cone angle in rad, small enough for the law's leading order; phase of the cone in one sub-sample."""

SIZES = range(2, 7)
LARGEST_DENOMINATOR = 400_000

DRIFT: Mapping[str, Mapping[int, tuple[Fraction, int]]] = {
    "taylor": {2: (F(1, 30), 5), 3: (F(-3, 80), 5), 4: (F(-8, 189), 7), 5: (F(275, 12096), 7), 6: (F(9, 200), 9)},
    "coning": {2: (F(1, 30), 5), 3: (F(3, 280), 7), 4: (F(1, 315), 9), 5: (F(5, 5544), 11), 6: (F(1, 4004), 13)},
}
"""Drift c a^2 x^p of one update, a the half-cone angle, x the phase of one sub-sample: c and p by N."""


def derivations(settings: Settings) -> Iterator[Claim]:
    """R1: derive the papers' coefficients and the tables of the literature, and compare fractions."""
    parabola, optimal = derived.taylor(3), derived.coning(3)
    yield _equal("33/80, 57/80 from the parabola", "xu2019", "33/80, 57/80", [parabola[1, 3], parabola[1, 2]])
    yield _equal("9/20, 27/40 for coning", "cao", "9/20, 27/40", [optimal[1, 3], optimal[1, 2]])
    found: Found = [(_flat(derived.rate_fit(n)), _fit(taylor.ABOUT_START[n])) for n in SIZES]
    yield _table("rate fit about the start, N = 2..6", "xu2019", found)
    found = [(_flat(_about_midpoint(n)), _fit(taylor.ABOUT_MIDPOINT[n])) for n in SIZES]
    yield _table("rate fit about the midpoint, N = 2..6", "xu2019", found)
    found = [(_pairs(derived.taylor(n)), _typed(weights.TAYLOR[n])) for n in SIZES]
    yield _table("polynomial pair weights, N = 2..6", "xu2019", found)
    found = [(list(derived.coning_totals(n)), _typed([weights.SPACING[n]])) for n in SIZES]
    yield _table("coning-optimal totals, N = 2..6", "cao", found)
    found = [(_pairs(derived.expanded(n)), _typed(weights.EXPANDED[n])) for n in SIZES]
    yield _table("coning-optimal weights with exact moments, N = 2..6", "cao", found)
    sets = (derived.taylor, derived.coning, derived.expanded)
    found = [(_pairs(_multiplied_out(each(n), n)), _pairs(each(n))) for each in sets for n in SIZES]
    yield _table("sum and difference form multiplied out, three sets, N = 2..6", "cao", found)
    found = [(_flat(derived.rates_to_increments(n)), _typed(weights.RATE_SAMPLES[n])) for n in SIZES]
    yield _table("increments from rates, N = 2..6", "cao", found)


def _equal(claim: str, paper: str, printed: str, values: Sequence[Fraction]) -> Claim:
    text = ", ".join(map(str, values))
    return Claim("R1", claim, paper, printed, text, "equal fractions", verdict_of(text == printed))


def _table(claim: str, paper: str, found: Found) -> Claim:
    """Return the claim that derived rows are the typed ones; the tables of N = 2..6 one after another."""
    entries = [pair for ours, typed in found for pair in zip(ours, typed, strict=True)]
    equal = sum(ours == typed for ours, typed in entries)
    total = len(entries)
    return Claim("R1", claim, paper, f"{total} fractions", f"{equal} equal", "all equal", verdict_of(equal == total))


def _flat(rows: Sequence[Row]) -> list[Fraction]:
    return [value for row in rows for value in row]


def _about_midpoint(n: int) -> list[Row]:
    """Return the fit in powers of v = u - 1/2 on theta_1 .. theta_N, from that on their forward differences."""
    differences = [[F((-1) ** (k - i) * comb(k, i)) for i in range(n)] for k in range(n)]
    return [
        [sum((row[k] * differences[k][i] for k in range(n)), F(0)) for i in range(n)]
        for row in difference_table(n, "midpoint")
    ]


def _pairs(pairs: derived.Pairs) -> list[Fraction]:
    return [pairs[key] for key in sorted(pairs)]


def _fit(rows: taylor.Rows) -> list[Fraction]:
    return [F(value, denominator) for denominator, row in rows for value in row]


def _typed(rows: Sequence[Sequence[float]]) -> list[Fraction]:
    """Return the fractions that were typed: each float is one rounded quotient of small integers."""
    return [F(value).limit_denominator(LARGEST_DENOMINATOR) for row in rows for value in row]


def _multiplied_out(pairs: derived.Pairs, n: int) -> dict[tuple[int, int], Fraction]:
    """Return the pair weights of sum_j (sum_i c_ij s_i) x d_j."""
    found = dict.fromkeys(pairs, F(0))
    for i, row in enumerate(sum_difference_weights(pairs, n), start=1):
        for j, factor in enumerate(row, start=1):
            for a in {i, n + 1 - i}:
                for b, sign in ((n + 1 - j, 1), (j, -1)):
                    if a != b:
                        found[min(a, b), max(a, b)] += factor * sign * (1 if a < b else -1)
    return found


def coning_drift(settings: Settings) -> Iterator[Claim]:
    """R2: drift of one update in pure coning, calculated with 120 digits, over the law c a^2 x^p."""
    papers = {"taylor": ("xu2019", "polynomial weights"), "coning": ("cao", "coning-optimal weights")}
    for name, (paper, words) in papers.items():
        with localcontext() as context:
            context.prec = DIGITS
            ratios = []
            for n, (factor, power) in DRIFT[name].items():
                law = Decimal(factor.numerator) / factor.denominator * CONE**2 * PHASE**power
                ratios.append(float(_drift(derived.pair_weights(n, name), n) / law))
        text = f"coning drift over its law, N = 2..6, {words}, half-cone 1e-12 rad, phase 0.02"
        yield judged("R2", text, paper, "1", ratios, (0.999, 1.001))


def _drift(pairs: derived.Pairs, n: int) -> Decimal:
    """Return the z component, rad, of r_computed (x) conj(r_true) for one update that begins at phase 0."""
    half = PHASE / 2
    across, along = 2 * _sine(CONE) * _sine(half), 2 * PHASE * _sine(CONE / 2) ** 2
    theta: list[Vector] = []
    for i in range(n):
        middle = PHASE * i + half
        theta.append((across * _cosine(middle), -across * _sine(middle), along))
    phi = [sum((each[axis] for each in theta), Decimal(0)) for axis in range(3)]
    for (i, j), weight in pairs.items():
        k = Decimal(weight.numerator) / weight.denominator
        (a, b, c), (d, e, f) = theta[i - 1], theta[j - 1]
        phi = [p + k * q for p, q in zip(phi, (b * f - c * e, c * d - a * f, a * e - b * d), strict=True)]
    size = sum((each * each for each in phi), Decimal(0)).sqrt()
    scale = _sine(size / 2) / size
    computed = (_cosine(size / 2), *(scale * each for each in phi))
    true = _product(_conjugate(_on_cone(Decimal(0))), _on_cone(n * PHASE))
    return 2 * _product(computed, _conjugate(true))[3]


def _on_cone(phase: Decimal) -> Quaternion:
    sine = _sine(CONE / 2)
    return _cosine(CONE / 2), sine * _sine(phase), sine * _cosine(phase), Decimal(0)


def _conjugate(q: Quaternion) -> Quaternion:
    return q[0], -q[1], -q[2], -q[3]


def _product(p: Quaternion, q: Quaternion) -> Quaternion:
    (a, b, c, d), (w, x, y, z) = p, q
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def _sine(x: Decimal) -> Decimal:
    return _series(x, x, 1)


def _cosine(x: Decimal) -> Decimal:
    return _series(x, Decimal(1), 0)


def _series(x: Decimal, first: Decimal, start: int) -> Decimal:
    """Return first - first x^2/((s+1)(s+2)) + ..., until a term no longer counts."""
    total, term, k = first, first, start
    while abs(term) > Decimal(10) ** -DIGITS * abs(first):
        term = -term * x * x / ((k + 1) * (k + 2))
        total, k = total + term, k + 2
    return total
