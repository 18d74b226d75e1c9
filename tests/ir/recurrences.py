"""The recurrences of `authored`, from scratch over fractions: what their routines must mean."""

from __future__ import annotations

from fractions import Fraction

from authored import ORDER

from qcone.algorithms.coefficients import rate_fit

F = Fraction
Quaternion = tuple[Fraction, ...]


def product(p: Quaternion, q: Quaternion) -> Quaternion:
    a, b, c, d = p
    e, f, g, h = q
    return (
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    )


def scaled(factor: Fraction, q: Quaternion) -> Quaternion:
    return tuple(factor * part for part in q)


def added(*terms: Quaternion) -> Quaternion:
    return tuple(sum(parts, F(0)) for parts in zip(*terms, strict=True))


def taylor_update(q: Quaternion, dtheta: list[tuple[Fraction, ...]]) -> Quaternion:
    """Return q (x) r, renormalised, r the Taylor polynomial of q' = 1/2 q (x) (0, omega): from scratch."""
    coefficients = [
        (F(0), *(sum((row[i] * dtheta[i][axis] for i in range(3)), F(0)) / 2 for axis in range(3)))
        for row in rate_fit(3)
    ]
    r = [(F(1), F(0), F(0), F(0))]
    for n in range(1, ORDER + 1):
        terms = [product(r[n - 1 - j], coefficients[j]) for j in range(min(n, 3))]
        r.append(scaled(F(1, n), added(*terms)))
    e = (1 - sum(part * part for part in q)) / 2
    whole = added(*r)
    return product(q, (whole[0] + e, *whole[1:]))


def ladder_update(q: Quaternion, dtheta: list[tuple[Fraction, ...]]) -> Quaternion:
    (d,) = dtheta
    v = tuple(F(2, 3) * part for part in d)
    for n in range(1, 6):
        turned = (d[1] * v[2] - d[2] * v[1], d[2] * v[0] - d[0] * v[2], d[0] * v[1] - d[1] * v[0])
        v = tuple(F(1, 2 * n + 1) * t + part for t, part in zip(turned, v, strict=True))
    e = (1 - sum(part * part for part in q)) / 2
    return product(q, (1 + e - sum(part * part for part in d) / 8, *(part / 2 for part in v)))


UPDATES = {"taylor": taylor_update, "ladder": ladder_update}
Q = (F(4, 5), F(2, 7), F(-1, 3), F(3, 11))
