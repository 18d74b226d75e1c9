"""Where an algorithm's coefficients come from, and the first term of its error, with exact rationals.

Nothing here is a table: weights are solved for anew, from the conditions that the papers state.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import factorial

from qcone.algorithms import coefficients, increments
from qcone.algorithms.dense_taylor import dense_products
from qcone.algorithms.polynomial_rate import difference_table
from qcone.algorithms.rotation_vector import sum_difference_weights
from qcone.design import Design
from qcone.elimination import solve
from qcone.ir.specification import Algorithm

Line = tuple[str, str]
"""An equation or the name of a condition, and a line of text."""

BACKWARD = (0, -1, -2, -3)
"""Nodes of the predictor, in steps from the last attitude; the corrector's begin at the new one."""


def derivation(design: Design, algorithm: Algorithm) -> Iterator[Line]:
    """Yield the derivation of a design's coefficients, a line each."""
    n = algorithm.subsamples
    if design.algorithm == "rotation-vector":
        yield (
            "Bortz 1971, cao (10)",
            "phi' = omega + 1/2 phi x omega + 1/12 phi x (phi x omega) + ..., alpha = int omega dt",
        )
        yield from _rotation_vector(n, design)
    elif design.algorithm == "picard":
        yield from _picard()
    elif design.algorithm == "quaternion-taylor":
        yield "xu2019 (5)", "q' = 1/2 q (x) omega, so q^(n) = 1/2 sum_i binom(n-1, i) q^(n-1-i) (x) omega^(i)"
        yield "xu2019 (7)", "q^(n) T^n/n! = q (x) r_n: r_n = 1/n sum_j r_(n-1-j) (x) A_j, A_j = W_j/2"
        yield from _fit(n, design, "A")
    elif design.algorithm == "dcm-taylor":
        yield "xu2019 (10)", "C' = C [omega x]: each row v of C obeys v' = v x omega"
        yield "xu2019 (13)", "v^(n) T^n/n! = v_n: v_n = 1/n sum_j v_(n-1-j) x W_j"
        yield from _fit(n, design, "W")
    elif design.algorithm == "runge-kutta-4":
        yield (
            "Kutta 1901",
            "nodes 0, 1/2, 1/2, 1; weights 1/6, 1/3, 1/3, 1/6: Simpson's rule where f depends on t alone",
        )
    elif design.algorithm == "adams-moulton-4":
        yield from _multistep(str(design.parameters["starter"]))
    elif design.algorithm == "euler-angles":
        yield "C = Rz(yaw) Ry(pitch) Rx(roll)", "omega = (roll', 0, 0) + Rx^T (0, pitch', 0) + Rx^T Ry^T (0, 0, yaw')"
        yield (
            "solved for the rates",
            "yaw' cos(pitch) = wy sin(roll) + wz cos(roll): the division that locks at 90 degrees",
        )
    if design.input == "rate" and algorithm.takes == "dtheta":
        for i, row in enumerate(increments.weights(n, design.increments)):
            yield f"{design.increments} increments", f"theta_{i + 1} = T ({combination(row, 'omega')})"


def leading_error(design: Design, algorithm: Algorithm) -> Iterator[Line]:
    """Yield the order of a design's error and the first term of it that is not zero."""
    order, n = algorithm.order, algorithm.subsamples
    if order is not None:
        one = "" if algorithm.phases else f", that of one update as T^{order + 1}"
        yield "general motion", f"the error of a run falls as T^{order}{one}"
    if design.algorithm in ("rotation-vector", "picard") and n == 1 and not design.parameters.get("previous"):
        yield "leading term", "1/12 omega x omega' T^3, the turning of the axis within an update"
    elif design.algorithm == "rotation-vector":
        yield from _third_order(n, design)
    if design.algorithm == "picard":
        yield from _picard_order(str(design.parameters["order"]))
    if design.algorithm == "rotation-vector" and not design.parameters.get("previous"):
        yield _coning(n, str(design.parameters.get("coefficients") or "coning") if n > 1 else "")
    if design.algorithm in ("quaternion-taylor", "dcm-taylor"):
        power = int(str(design.parameters["order"])) + 1
        yield "series", f"the first term left out is of order {power} in T; it is off in length as well"
        yield _coning(n, "taylor" if n > 1 else "")
    if design.algorithm == "runge-kutta-4":
        half = 1 if design.parameters["attitude"] == "dcm" else 2
        yield "leading term", f"about a fixed axis |omega h|^5/{120 * half**5}; in general of order h^5 in each step"
    if design.algorithm == "adams-moulton-4":
        yield from _multistep_error(str(design.parameters["starter"]))
    if design.algorithm == "euler-angles":
        yield (
            "leading term",
            "h^5 times the fifth derivative of the angles, which grows as 1/cos(pitch)^5: no bound at 90 degrees",
        )


def combination(row: Sequence[Fraction], name: str, first: int = 0) -> str:
    """Return a weighted sum as text."""
    terms = [(factor, f"{name}_{k}") for k, factor in enumerate(row, start=first) if factor]
    text = " ".join(
        f"{'-' if factor < 0 else '+'} {'' if abs(factor) == 1 else f'{abs(factor)} '}{term}" for factor, term in terms
    )
    return text.removeprefix("+ ")


def multistep_weights(nodes: Sequence[int]) -> tuple[list[Fraction], Fraction]:
    """Return the weights that integrate a cubic through four nodes over [0, 1], and the error constant of h^5 y^(5)."""
    powers = [[Fraction(node) ** power for node in nodes] for power in range(len(nodes))]
    weights = solve(powers, [Fraction(1, power + 1) for power in range(len(nodes))])
    last = sum((w * Fraction(node) ** 4 for w, node in zip(weights, nodes, strict=True)), Fraction(0))
    return weights, (Fraction(1, 5) - last) / factorial(4)


def _rotation_vector(n: int, design: Design) -> Iterator[Line]:
    previous = int(str(design.parameters.get("previous") or 0))
    if previous:
        for p, weight in enumerate(coefficients.history_weights(previous), start=1):
            yield "coning condition", f"weight of theta[-{p}] x theta = {weight}"
        return
    if n == 1:
        yield "fixed axis", "phi = theta: every cross product with omega is zero"
        return
    name = str(design.parameters.get("coefficients") or "coning")
    if name == "taylor":
        for j, row in enumerate(coefficients.rate_fit(n)):
            yield "xu2019 (2)", f"omega T, power {j} of t/T: {combination(row, 'theta', 1)}"
    else:
        for d, total in enumerate(coefficients.coning_totals(n), start=1):
            yield "coning condition", f"sum of the weights of pairs {d} apart: K_{d} = {total}"
    weights = coefficients.pair_weights(n, name)
    for (i, j), weight in sorted(weights.items()):
        yield "phi = S + sum k_ij theta_i x theta_j", f"k_{i}{j} = {weight}"
    if name != "compressed" or n == 2:
        for p, column in enumerate(sum_difference_weights(weights, n), start=1):
            for q, weight in enumerate(column, start=1):
                yield "factored by sums s_i and differences d_j", f"s_{p} x d_{q}: {weight}"


def _third_order(n: int, design: Design) -> Iterator[Line]:
    if design.parameters.get("previous"):
        yield "leading term", "the increments before weigh coning only: in general motion T^4 is left"
        return
    if design.parameters.get("coefficients") == "compressed" and n > 2:
        yield "leading term", "the pairs with the last increment weigh coning only: in general motion T^4 is left"
        return
    fit = ", with the fit's own" if n == 2 else ""
    yield "leading term", f"m x (m x p)/360 + n x (n x m)/240 + (m.m) m x n/720 is left out, of order T^5{fit}"
    yield "where", "omega T = m + n v + p v^2, v = t/T - 1/2"


def _coning(n: int, name: str) -> Line:
    power, coefficient = coefficients.coning_residual(n, name)
    return (
        "coning",
        f"drift of one update: {coefficient} a^2 x^{power}, a the half-cone angle, x the phase of a sub-sample",
    )


def _picard() -> Iterator[Line]:
    yield "cao (7)", "r = exp(1/2 sigma), sigma = int omega dt, every commutator left out"
    for name, terms in (
        ("a_c", [Fraction((-1) ** k, 4**k * factorial(2 * k)) for k in range(4)]),
        ("a_s", [Fraction((-1) ** k, 2 * 4**k * factorial(2 * k + 1)) for k in range(4)]),
    ):
        text = combination(terms, "x").replace(" x_0", "").replace("x_0", "1").replace("x_1", "x").replace("_", "^")
        yield "cao (9)", f"{name} = {text} ..., x = |sigma|^2"


def _picard_order(order: str) -> Iterator[Line]:
    lengths = {"1": "x/8", "2": "x^2/128", "3": "-x^2/384", "4": "-x^3/9216", "closed": "none"}
    yield "length", f"|r| - 1 = {lengths[order]}, x = |sigma|^2" if order != "closed" else "|r| = 1"


def _fit(n: int, design: Design, name: str) -> Iterator[Line]:
    about = str(design.parameters.get("about") or "start")
    power = "t/T" if about == "start" else "t/T - 1/2"
    yield "xu2019 (2)", f"omega T = sum_j W_j ({power})^j, through the increments; f_k their forward differences"
    for j, row in enumerate(difference_table(n, about)):
        yield "xu2019 (9)", f"W_{j} = {combination(row, 'f')}"
    if about == "midpoint":
        yield "midpoint", "E, O the even and odd terms at T/2: r = (E - O)* (x) (E + O)"
    order = int(str(design.parameters["order"]))
    where = "(7)" if name == "A" else "(11)"
    yield f"xu2019 {where}", f"order {order} takes {dense_products(n, order)} dense products as the paper writes it"


def _multistep(starter: str) -> Iterator[Line]:
    yield "thesis2008", "q(t + h) = q + int f dt, f = 1/2 q (x) omega replaced by the cubic through four slopes"
    for name, nodes in (("Adams-Bashforth", BACKWARD), ("Adams-Moulton", tuple(node + 1 for node in BACKWARD))):
        weights, _ = multistep_weights(nodes)
        names = [f"f({node:+d})" if node else "f(0)" for node in nodes]
        text = " ".join(f"{'-' if w < 0 else '+'} {abs(w)} {f}" for w, f in zip(weights, names, strict=True))
        yield name, f"h ({text.removeprefix('+ ')})"
    if starter == "heun":
        yield "starter", "Heun: p = q + h f(0), q + h/2 (f(0) + f(p)), three times"
    else:
        yield "starter", "three Runge-Kutta steps, their middle rates from the cubic through the first four samples"


def _multistep_error(starter: str) -> Iterator[Line]:
    (_, predictor), (_, corrector) = (multistep_weights(tuple(node + k for node in BACKWARD)) for k in (0, 1))
    yield "predictor", f"{predictor} h^5 q^(5)"
    yield "corrector", f"{corrector} h^5 q^(5)"
    yield "Milne", f"true - corrected = {corrector / (predictor - corrector)} (corrected - predicted)"
    if starter == "heun":
        yield "starter", "three local errors of order h^3, which stay in the attitude for good"
