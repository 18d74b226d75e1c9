"""Explain an algorithm: its derivation in steps with exact rationals, its leading error, and what its papers misprint.

The steps are those the algorithm is made of: the headings of its two written forms, with their equation numbers.
Coefficients come from the derivation itself, not from a table.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from qcone.algorithms import coefficients
from qcone.algorithms.dense_taylor import dense_products
from qcone.algorithms.polynomial_rate import difference_table
from qcone.algorithms.rotation_vector import sum_difference_weights
from qcone.assembly import assemble, writing_of
from qcone.design import Design
from qcone.ir.specification import Algorithm
from qcone.ir.statement import Program, walk
from qcone.ir.writing import AS_WRITTEN, Series, Writing
from qcone.registry import algorithm_of

Row = dict[str, object]
NO_SERIES = Series((Fraction(-1, 8), Fraction(1, 384)), (Fraction(-1, 48),))
"""Taylor coefficients, to show the form of the exponential; a design chooses its own."""


def rows(design: Design) -> list[Row]:
    """Return the explanation as rows: part, equation, text."""
    algorithm = algorithm_of(design)
    found = [_row("algorithm", str(algorithm.source), f"{algorithm.name}: {algorithm.summary}")]
    found += [_row("derivation", equation, text) for equation, text in _derivation(design)]
    found += _steps(algorithm, design, AS_WRITTEN, "as written")
    found += _steps(algorithm, design, writing_of(design, NO_SERIES), "factored")
    found += [_row("error", equation, text) for equation, text in _error(design, algorithm)]
    found += [_row("erratum", "", text) for text in (*algorithm.errata, *_errata(design))]
    return found


def _row(part: str, equation: str, text: str) -> Row:
    return {"part": part, "equation": equation, "text": text}


def _steps(algorithm: Algorithm, design: Design, writing: Writing, part: str) -> list[Row]:
    """Return the headings of the update, in order."""
    program: Program = assemble(algorithm, design, writing)
    routine = program.routine("steady" if program.has("steady") else "update")
    order = dict.fromkeys(statement.step for statement in walk(routine.body))
    steps = [routine.steps[number] for number in order]
    return [_row(part, step.equation, step.text) for step in steps if " = " in step.text]


def _derivation(design: Design) -> Iterator[tuple[str, str]]:
    n = int(str(design.parameters.get("subsamples") or 1))
    if design.algorithm == "rotation-vector":
        yield from _rotation_vector(n, design)
    elif design.algorithm in ("quaternion-taylor", "dcm-taylor"):
        about = str(design.parameters.get("about") or "start")
        for j, row in enumerate(difference_table(n, about)):
            yield "xu2019 (9)", f"W_{j} = {_combination(row, 'f')}, f_k the forward differences of the increments"
        order = int(str(design.parameters["order"]))
        yield "xu2019 (7)", f"order {order} takes {dense_products(n, order)} dense products as the paper writes it"
    if design.input == "rate" and "omega" not in design.algorithm:
        for i, row in enumerate(coefficients.rates_to_increments(n)):
            yield "interpolation", f"theta_{i + 1} = T ({_combination(row, 'omega')})"


def _rotation_vector(n: int, design: Design) -> Iterator[tuple[str, str]]:
    previous = int(str(design.parameters.get("previous") or 0))
    if previous:
        for p, weight in enumerate(coefficients.history_weights(previous), start=1):
            yield "coning condition", f"weight of theta[-{p}] x theta = {weight}"
        return
    if n == 1:
        return
    name = str(design.parameters.get("coefficients") or "coning")
    yield "Bortz 1971", "phi' = omega + 1/2 phi x omega + 1/12 phi x (phi x omega) + ..., alpha = int omega dt"
    if name == "taylor":
        for j, row in enumerate(coefficients.rate_fit(n)):
            yield "xu2019 (2)", f"omega T, power {j} of t/T: {_combination(row, 'theta', 1)}"
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


def _combination(row: tuple[Fraction, ...], name: str, first: int = 0) -> str:
    terms = [(factor, f"{name}_{k}") for k, factor in enumerate(row, start=first) if factor]
    text = " ".join(f"{'-' if factor < 0 else '+'} {abs(factor)} {term}" for factor, term in terms)
    return text.removeprefix("+ ")


def _error(design: Design, algorithm: Algorithm) -> Iterator[tuple[str, str]]:
    yield (
        "general motion",
        f"global order {algorithm.order}: the error of a run falls as the {algorithm.order}th power of T",
    )
    if design.algorithm == "rotation-vector" and not design.parameters.get("previous"):
        n = int(str(design.parameters["subsamples"]))
        name = str(design.parameters.get("coefficients") or "coning") if n > 1 else ""
        power, coefficient = coefficients.coning_residual(n, name)
        yield (
            "coning",
            f"drift of one update: {coefficient} a^2 x^{power}, a the half-cone angle, x the phase of a sub-sample",
        )
        yield "third order", "the triple products of the rotation vector are left out: local error of order T^5"


def _errata(design: Design) -> Iterator[str]:
    if design.algorithm == "rotation-vector" and design.parameters.get("subsamples") == 3:
        yield "cao (12) is said to come from the parabola; the parabola gives 33/80 and 57/80, xu2019 (4)"
        yield "xu2019 figure 1 was made with the coefficients of cao (12), not with those of its (4)"
    if design.input == "rate":
        yield "cao (13), third row, is printed on omega(0) and omega(T/3); it belongs on omega(T/3) and omega(2T/3)"
