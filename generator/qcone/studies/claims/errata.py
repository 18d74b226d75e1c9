"""D2, D3, D9 and D10: equations as printed, beside the generated C of the corrected ones, on the manoeuvre.

Each is one update from the identity over 1/rate seconds, 10 ms in the dossier's figures.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import comb, factorial

import numpy as np

from qcone.reference.kinematics import IDENTITY
from qcone.reference.quaternion import Array, error_angle, from_matrix
from qcone.studies.claims.claim import DOES_NOT_HOLD, Claim, Settings, judged
from qcone.studies.sampled import MANOEUVRE, MANOEUVRE_DPS
from qcone.studies.simulating import options, run

ORDER = 10


def matrix_equations(settings: Settings) -> Iterator[Claim]:
    """D2 and D3: the derivatives of the direction cosine matrix as xu2019 prints them."""
    interval = 1 / settings.rate_hz
    dtheta = MANOEUVRE.increments(np.linspace(0, interval, 4))
    true = MANOEUVRE.attitude(np.array([interval]))[0]
    words = options("dcm-taylor", subsamples=3, order=ORDER, **_declared(settings))
    corrected = float(
        error_angle(run(words, IDENTITY[np.newaxis], dtheta[np.newaxis, np.newaxis])["quaternion"][0], true)[0]
    )
    for id_, number, what, why in (
        ("D2", "(11)", "Omega C^(n-1-i)", "C' = C Omega puts Omega on the right: C^(n-1-i) Omega^(i)"),
        ("D3", "(13)", "[a x], [b x], [c x]", "constants missing: Omega, Omega', Omega'' are [a x], 2 [b x], 6 [c x]"),
    ):
        matrix = _printed(dtheta, interval, left=number == "(11)", bare=number == "(13)")
        error = float(error_angle(from_matrix(matrix), true))
        text = (
            f"{number} as printed, {what}: error in rad of one update of {1e3 * interval:g} ms; "
            f"corrected, C: {corrected:.2g}"
        )
        yield judged(id_, text, "xu2019", number, error, (0, 1.5 * corrected), otherwise=why)


def _printed(dtheta: Array, interval: float, *, left: bool, bare: bool) -> Array:
    """Return the matrix after one update: (12) with derivatives by (11), Omega `left`, or by (13), `bare`."""
    one, two, three = dtheta
    a = (11 * one - 7 * two + 2 * three) / (2 * interval)
    b = 4.5 * (-2 * one + 3 * two - three) / interval**2
    c = 4.5 * (one - 2 * two + three) / interval**3
    constants = (1, 1, 1) if bare else (1, 2, 6)
    omega = [factor * _cross(each) for factor, each in zip(constants, (a, b, c), strict=True)]
    derivatives = [np.eye(3)]
    for n in range(1, ORDER + 1):
        terms = ((comb(n - 1, i), omega[i], derivatives[n - 1 - i]) for i in range(min(n, 3)))
        derivatives.append(sum((k * (w @ d if left else d @ w) for k, w, d in terms), np.zeros((3, 3))))
    return sum((interval**n / factorial(n) * d for n, d in enumerate(derivatives)), np.zeros((3, 3)))


def _cross(v: Array) -> Array:
    """Return [v x], the matrix of a cross product."""
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def increments_from_rates(settings: Settings) -> Iterator[Claim]:
    """D9: theta_3 of cao (13) as printed."""
    interval = 1 / settings.rate_hz
    times = np.linspace(0, interval, 4)
    rates, true = MANOEUVRE.rate(times), MANOEUVRE.attitude(times[-1:])
    found: dict[str, float] = {}
    for rule in ("cao-13", "interpolating"):
        words = options("rotation-vector", subsamples=3, input="rate", increments=rule, **_declared(settings))
        q = run(words, IDENTITY[np.newaxis], rates[np.newaxis, np.newaxis, 1:], rates[:1])["quaternion"][0]
        found[rule] = float(error_angle(q, true)[0])
    nodes = ((5, 8, -1, 0), (-1, 8, 5, 0), (-1, 8, 0, 5))
    printed = interval / 36 * np.array(nodes) @ rates
    words = options("rotation-vector", subsamples=3, **_declared(settings))
    error = float(
        error_angle(run(words, IDENTITY[np.newaxis], printed[np.newaxis, np.newaxis])["quaternion"][0], true)[0]
    )
    text = (
        f"(13) theta_3 as printed: error in rad of one update of {1e3 * interval:g} ms; corrected, C: "
        f"{found['cao-13']:.2g}, through four nodes, C: {found['interpolating']:.2g}"
    )
    why = "theta_3 is printed on omega(0), omega(T/3); it belongs on omega(T/3), omega(2T/3)"
    yield judged("D9", text, "cao", "(13)", error, (0, 1.5 * found["cao-13"]), otherwise=why)


def figure_without_data(settings: Settings) -> Iterator[Claim]:
    """D10: figure 1 of cao."""
    reason = "no motion, rate or duration is given, and a relative error is undefined where the angle is 0"
    text = "fig. 1: relative errors of roll, pitch and yaw are small"
    yield Claim("D10", text, "cao", "a figure", None, "none given", DOES_NOT_HOLD, reason)


def _declared(settings: Settings) -> dict[str, str]:
    """Return words that declare the range of an update of 1/rate seconds, printed increments included."""
    return {"max_rate_dps": f"{2 * MANOEUVRE_DPS}", "update_hz": f"{settings.rate_hz:.9f}"}
