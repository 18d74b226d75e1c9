"""R17: one update of every algorithm by the compiled C, against the same formula over the rationals.

Cases: two coning motions, two stretches of the large-angle manoeuvre, and polynomial rates drawn at random. Increments
are rounded to the number format before the C takes them; the exact value is that of the increments themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache
from math import ceil, degrees, sqrt

import numpy as np

from qcone.algorithms import coefficients
from qcone.reference.kinematics import IDENTITY
from qcone.reference.motions import Motion, coning, large_angle_manoeuvre
from qcone.reference.quaternion import Array
from qcone.studies.claims.claim import Claim, Settings, judged
from qcone.studies.simulating import options, run

F = Fraction
Vector = tuple[Fraction, ...]
Increments = list[Vector]
Quaternion = tuple[Fraction, ...]

UPDATE_HZ = 10
ORDER = 10
SHARPEST = F(1, 10**40)
INTERVALS = (F(1, 10), F(1, 100))
"""Update intervals in s of the polynomial rates."""

SETS = ("taylor", "coning", "expanded", "compressed")
FLOORS = {
    "rotation-vector": {"float64": {1.2e-16: range(1, 7)}, "float32": {6e-8: range(1, 7)}},
    "quaternion-taylor": {
        "float64": {1.3e-16: range(1, 5), 5e-16: range(5, 6), 1.2e-14: range(6, 7)},
        "float32": {5e-8: range(1, 4), 2e-7: range(4, 5), 7e-7: range(5, 6), 3e-6: range(6, 7)},
    },
}
"""Most that a component of r may be off, and the numbers of sub-samples it holds for."""


def rotation_vector_values(settings: Settings) -> Iterator[Claim]:
    """R17: rotation vector, one to six sub-samples, every coefficient set."""
    yield from _claims(settings, "rotation-vector", "cao", _rotation_vector_error)


def series_values(settings: Settings) -> Iterator[Claim]:
    """R17: quaternion series of order 10, one to six sub-samples."""
    yield from _claims(settings, "quaternion-taylor", "xu2019", _series_error)


def _claims(settings: Settings, name: str, paper: str, error: Callable[[Settings, int, str], float]) -> Iterator[Claim]:
    for number, floors in FLOORS[name].items():
        for most, counts in floors.items():
            which = f"N = {counts[0]}" + (f"..{counts[-1]}" if len(counts) > 1 else "")
            text = f"largest error of r, {name}, {which}, {number}"
            worst = max(error(settings, n, number) for n in counts)
            yield judged("R17", text, paper, "not given", worst, (0, most))


def _rotation_vector_error(settings: Settings, n: int, number: str) -> float:
    worst = 0.0
    for name in SETS if n > 1 else ("",):
        pairs = coefficients.pair_weights(n, name) if name else {}
        words = {"coefficients": name} if name else {}
        exact = [_exponential(_rotation_vector(theta, pairs)) for theta in _cases(settings, n)]
        worst = max(worst, _error(settings, "rotation-vector", n, number, exact, **words))
    return worst


def _series_error(settings: Settings, n: int, number: str) -> float:
    exact = [_series(theta) for theta in _cases(settings, n)]
    return _error(settings, "quaternion-taylor", n, number, exact, order=ORDER)


def _error(settings: Settings, name: str, n: int, number: str, exact: Sequence[Quaternion], **words: object) -> float:
    """Return the largest error of a component of r, each difference exact, over all cases."""
    cases = _cases(settings, n)
    largest = max(sqrt(sum(each * each for each in theta)) for case in cases for theta in case)
    dps = ceil(degrees(largest) * n * UPDATE_HZ) + 1
    given = options(name, subsamples=n, number=number, max_rate_dps=dps, update_hz=UPDATE_HZ, **words)
    inputs = np.array([[[float(part) for part in theta] for theta in case] for case in cases])[:, np.newaxis]
    computed = run(given, np.tile(IDENTITY, (len(cases), 1)), inputs)["quaternion"][:, 0]
    pairs = zip(computed.tolist(), exact, strict=True)
    return float(max(abs(F(have) - want) for row, r in pairs for have, want in zip(row, r, strict=True)))


@cache
def _cases(settings: Settings, n: int) -> list[Increments]:
    """Return the increments in rad of every case, exactly."""
    s = 1 / settings.rate_hz
    fast = coning(cone_angle=float(np.deg2rad(0.1)), cone_rate=100 * np.pi)
    sampled: tuple[tuple[Motion, float, float], ...] = (
        (coning(), 0.0, s),
        (fast, 0.0, s / 20),
        (large_angle_manoeuvre(), 0.0, s / 10),
        (large_angle_manoeuvre(), 0.6, s / 10),
    )
    cases = []
    for motion, start, step in sampled:
        instants: Array = start + step * np.arange(n + 1, dtype=np.float64)
        dtheta = motion.increments(instants)
        cases.append([tuple(map(F, row)) for row in dtheta.tolist()])
    random = np.random.default_rng([settings.seed, n])
    for interval in INTERVALS:
        rate = [[F(value, 500) for value in row] for row in random.integers(-1000, 1001, (n, 3)).tolist()]
        cases.append([_integral(rate, interval * i / n, interval * (i + 1) / n) for i in range(n)])
    return cases


def _integral(rate: Sequence[Sequence[Fraction]], start: Fraction, end: Fraction) -> Vector:
    """Return the integral of sum rate_k t^k from `start` to `end`."""
    powers = [(end ** (k + 1) - start ** (k + 1)) / (k + 1) for k in range(len(rate))]
    return tuple(sum((power * row[axis] for power, row in zip(powers, rate, strict=True)), F(0)) for axis in range(3))


def _rotation_vector(theta: Increments, pairs: coefficients.Pairs) -> Vector:
    """Return S + sum k_ij theta_i x theta_j; cao (12), xu2019 (4)."""
    phi = tuple(sum((each[axis] for each in theta), F(0)) for axis in range(3))
    for (i, j), weight in pairs.items():
        product = _cross(theta[i - 1], theta[j - 1])
        phi = tuple(p + weight * q for p, q in zip(phi, product, strict=True))
    return phi


def _exponential(phi: Vector) -> Quaternion:
    """Return [cos(|phi|/2), sin(|phi|/2) phi/|phi|] by their series, to 40 digits."""
    x = sum((each * each for each in phi), F(0))
    cosine, sine, term, k = F(0), F(0), F(1), 0
    while term > SHARPEST:
        cosine += (-1) ** k * term
        sine += (-1) ** k * term / (2 * (2 * k + 1))
        term = F(round(term * x / (4 * (2 * k + 1) * (2 * k + 2)) * 10**50), 10**50)
        k += 1
    return (cosine, *(sine * each for each in phi))


def _series(theta: Increments) -> Quaternion:
    """Return r = sum r_n, r_n = 1/n sum_j r_(n-1-j) (x) (0, W_j/2); xu2019 (7), (8)."""
    fit = coefficients.rate_fit(len(theta))
    half_rates = [
        tuple(sum((k * each[axis] for k, each in zip(row, theta, strict=True)), F(0)) / 2 for axis in range(3))
        for row in fit
    ]
    terms: list[Quaternion] = [(F(1), F(0), F(0), F(0))]
    for n in range(1, ORDER + 1):
        parts = [_times(terms[n - 1 - j], half_rates[j]) for j in range(min(n, len(theta)))]
        terms.append(tuple(sum(column, F(0)) / n for column in zip(*parts, strict=True)))
    return tuple(sum(column, F(0)) for column in zip(*terms, strict=True))


def _times(p: Quaternion, v: Vector) -> Quaternion:
    """Return p (x) (0, v)."""
    w, u = p[0], p[1:]
    product = _cross(u, v)
    scalar = -sum((a * b for a, b in zip(u, v, strict=True)), F(0))
    return (scalar, *(w * b + c for b, c in zip(v, product, strict=True)))


def _cross(u: Vector, v: Vector) -> Vector:
    (a, b, c), (d, e, f) = u, v
    return b * f - c * e, c * d - a * f, a * e - b * d
