"""The Taylor-series updates of xu2019, quaternion and direction cosine matrix, by their recursions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

import numpy as np

from qcone.reference.kinematics import chain
from qcone.reference.matrices import chain_matrices
from qcone.reference.quaternion import Array, conjugate, product

About = Literal["start", "midpoint"]
Rows = tuple[tuple[int, tuple[int, ...]], ...]

# omega(u T) T = sum_j W_j u^j, u = 0..1 over the update interval; row j is the denominator of W_j and its numerators,
# the weights of theta_1 .. theta_N. The polynomial of degree N - 1 whose integrals over the N sub-intervals are the
# increments; xu2019 (2), (3) is N = 3.
ABOUT_START: Mapping[int, Rows] = {
    1: ((1, (1,)),),
    2: ((1, (3, -1)), (1, (-4, 4))),
    3: ((2, (11, -7, 2)), (1, (-18, 27, -9)), (2, (27, -54, 27))),
    4: (
        (3, (25, -23, 13, -3)),
        (3, (-140, 276, -180, 44)),
        (1, (80, -208, 176, -48)),
        (3, (-128, 384, -384, 128)),
    ),
    5: (
        (12, (137, -163, 137, -63, 12)),
        (12, (-1125, 2725, -2625, 1275, -250)),
        (8, (2125, -6750, 8000, -4250, 875)),
        (6, (-1875, 6875, -9375, 5625, -1250)),
        (24, (3125, -12500, 18750, -12500, 3125)),
    ),
    6: (
        (10, (147, -213, 237, -163, 62, -10)),
        (5, (-812, 2320, -2945, 2135, -835, 137)),
        (2, (1323, -4941, 7506, -5886, 2403, -405)),
        (1, (-1260, 5436, -9360, 8064, -3492, 612)),
        (1, (1134, -5346, 10044, -9396, 4374, -810)),
        (5, (-1944, 9720, -19440, 19440, -9720, 1944)),
    ),
}

# The same polynomial in v = u - 1/2.
ABOUT_MIDPOINT: Mapping[int, Rows] = {
    1: ((1, (1,)),),
    2: ((1, (1, 1)), (1, (-4, 4))),
    3: ((8, (-1, 26, -1)), (2, (-9, 0, 9)), (2, (27, -54, 27))),
    4: (
        (3, (-1, 7, 7, -1)),
        (3, (4, -60, 60, -4)),
        (1, (16, -16, -16, 16)),
        (3, (-128, 384, -384, 128)),
    ),
    5: (
        (1152, (27, -348, 6402, -348, 27)),
        (48, (125, -850, 0, 850, -125)),
        (16, (-125, 1500, -2750, 1500, -125)),
        (12, (-625, 1250, 0, -1250, 625)),
        (24, (3125, -12500, 18750, -12500, 3125)),
    ),
    6: (
        (10, (1, -8, 37, 37, -8, 1)),
        (5, (-2, 25, -245, 245, -25, 2)),
        (2, (-27, 189, -162, -162, 189, -27)),
        (1, (36, -396, 1008, -1008, 396, -36)),
        (1, (162, -486, 324, 324, -486, 162)),
        (5, (-1944, 9720, -19440, 19440, -9720, 1944)),
    ),
}


def rate_fit(dtheta: Array, about: About = "start") -> Array:
    """Return the coefficients (..., N, 3) in rad of omega T = sum_j W_j x^j, for increments (..., N, 3) rad.

    x = (t - t_k)/T about the `start` of the interval, less 1/2 about its `midpoint`. The sums, which cancel all but the
    curvature of the rate, are exact before they are rounded. Raises ValueError for N outside 1..6 or another `about`.
    """
    tables = {"start": ABOUT_START, "midpoint": ABOUT_MIDPOINT}
    if about not in tables:
        raise ValueError(f"about is {about!r}, choose start or midpoint")
    dtheta = np.asarray(dtheta, dtype=np.float64)
    n = dtheta.shape[-2]
    if n not in tables[about]:
        raise ValueError(f"dtheta holds {n} sub-samples, the tables hold 1 to 6")
    denominators = np.array([[denominator] for denominator, _ in tables[about][n]], dtype=np.float64)
    numerators = np.array([weights for _, weights in tables[about][n]], dtype=np.float64)
    high, low = _on_a_grid(dtheta)
    coefficients: Array = (numerators @ high + numerators @ low) / denominators
    return coefficients


def _on_a_grid(dtheta: Array) -> tuple[Array, Array]:
    """Return multiples of 2^-26 of the largest increment, whose short multiples add without rounding, and the rest."""
    _, exponent = np.frexp(np.max(np.abs(dtheta), axis=-2, keepdims=True))
    grid = np.ldexp(1.0, np.maximum(exponent, -900) - 26)  # a grid below the smallest float is none
    high: Array = np.rint(dtheta / grid) * grid
    return high, dtheta - high


def quaternion_taylor(dtheta: Array, order: int, about: About = "start") -> Array:
    """Return the update r (..., 4) of increments (..., N, 3) rad by the Taylor series up to `order` >= 1.

    About the start r = sum r_n, xu2019 (5)-(9) with the factorials divided out; about the midpoint
    r = conj(E - O) (x) (E + O) from the even and odd terms over half the interval. A cut series is not a unit
    quaternion. Raises ValueError for N outside 1..6, order below 1 or another `about`.
    """
    return np.array([1.0, 0.0, 0.0, 0.0]) + quaternion_taylor_change(dtheta, order, about)


def quaternion_taylor_change(dtheta: Array, order: int, about: About = "start") -> Array:
    """Return r - 1 of `quaternion_taylor`, which keeps the precision of small increments."""
    terms = _quaternion_terms(rate_fit(dtheta, about) / 2, _checked(order))
    if about == "start":
        return _sum(terms)
    half = [term / 2**n for n, term in enumerate(terms, 1)]
    even = _sum(half[1::2]) if order > 1 else np.zeros_like(half[0])  # E = 1 + even
    odd = _sum(half[0::2])
    before, after = conjugate(even - odd), even + odd
    return before + after + product(before, after)


def _quaternion_terms(a: Array, order: int) -> list[Array]:
    """Return r_1 .. r_order, r_n = (1/n) sum_j r_{n-1-j} (x) (0, A_j), each (..., 4)."""
    pure = np.concatenate([np.zeros_like(a[..., :1]), a], axis=-1)
    terms = [np.broadcast_to(np.array([1.0, 0.0, 0.0, 0.0]), pure[..., 0, :].shape)]
    for n in range(1, order + 1):
        products = [product(terms[n - 1 - j], pure[..., j, :]) for j in range(min(n, a.shape[-2]))]
        terms.append(_sum(products) / n)
    return terms[1:]


def dcm_taylor(dtheta: Array, order: int) -> Array:
    """Return the update R (..., 3, 3), C_{k+1} = C_k R, of increments (..., N, 3) rad by the series up to `order`.

    xu2019 (10)-(13) as corrected: C^(n) = sum binom C^(n-1-i) Omega^(i). A cut series is not orthogonal. Raises
    ValueError for N outside 1..6 or order below 1.
    """
    return np.eye(3) + dcm_taylor_change(dtheta, order)


def dcm_taylor_change(dtheta: Array, order: int) -> Array:
    """Return R - I of `dcm_taylor`, which keeps the precision of small increments."""
    w = rate_fit(dtheta)
    terms = [np.broadcast_to(np.eye(3), (*w.shape[:-2], 3, 3))]
    for n in range(1, _checked(order) + 1):
        # Rows of D [w x] are the rows of D, crossed with w.
        products = [np.cross(terms[n - 1 - j], w[..., j, np.newaxis, :]) for j in range(min(n, w.shape[-2]))]
        terms.append(_sum(products) / n)
    return _sum(terms[1:])


def run_quaternion(start: Array, dtheta: Array, order: int, about: About = "start") -> Array:
    """Return the attitude (updates, 4) after each update from `start` (4,) by `dtheta` (updates, N, 3) rad.

    Not renormalised: the direction of the result does not depend on its norm, which shows the truncation.
    """
    return chain(start, quaternion_taylor_change(dtheta, order, about))


def run_dcm(start: Array, dtheta: Array, order: int, *, orthogonal: bool = False) -> Array:
    """Return C_nb (updates, 3, 3) after each update from `start` (3, 3) by `dtheta` (updates, N, 3) rad.

    With `orthogonal` every attitude goes through one step C (3 I - C^T C)/2. Without it, quantised increments and six
    sub-samples lose orthogonality, and with it the attitude.
    """
    return chain_matrices(start, dcm_taylor_change(dtheta, order), orthogonal=orthogonal)


def _checked(order: int) -> int:
    if order < 1:
        raise ValueError(f"order is {order}, the series starts at 1")
    return order


def _sum(terms: list[Array]) -> Array:
    """Return the sum of at least one term, the last and smallest first."""
    total = terms[-1]
    for term in reversed(terms[:-1]):
        total = total + term
    return total
