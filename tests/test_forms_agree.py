"""The written forms of every algorithm are one algorithm: equal over the rationals, r within the stated truncation.

phi, Picard's series, the Taylor series and a step of Runge-Kutta or Adams-Moulton are polynomials of what they are
given: both forms are evaluated on random fractions and must be equal. The exponential is not: sine and cosine as
written are taken to 40 digits, and the factored polynomials must stay within the bound their banner states, over the
whole declared range. A matrix's third row is the cross product of the others in the factored form alone.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import mpmath
import pytest

from qcone.algorithms import attitude
from qcone.assembly import assemble, writing_of
from qcone.declaration import declaration
from qcone.design import Design
from qcone.formats.floating import FLOATING
from qcone.ir.evaluate import EXACT, Numbers, Outcome, evaluate
from qcone.ir.specification import Algorithm
from qcone.ir.statement import Program
from qcone.ir.writing import AS_WRITTEN
from qcone.passes.exponential import Exponential
from qcone.pipeline import choose_exponential
from qcone.registry import algorithm_of
from shipped import EXAMPLES, WITH_PHI, WITHOUT_PHI, design_of

RADIANS = mpmath.mp.clone()
RADIANS.dps = 40
DIGITS = Numbers(lambda exact: RADIANS.mpf(exact.numerator) / exact.denominator, RADIANS.sqrt, RADIANS.sin, RADIANS.cos)
UNKNOWN = Numbers(square_root=lambda _: Fraction(1), sine=lambda _: Fraction(0), cosine=lambda _: Fraction(1))
"""Rational arithmetic in which the exponential has some value: for what comes before it."""

TRIALS = 5
SERIES = [name for name in EXAMPLES if name.startswith("picard") and not name.endswith("closed")]
EXPONENTIALS = [name for name in WITH_PHI if name not in SERIES]
SIGMA = "dtheta"
"""One increment alone is phi itself and keeps its own name."""


def fractions(count: int, seed: object) -> list[Fraction]:
    generator = random.Random(str(seed))
    return [Fraction(generator.randint(-(10**6), 10**6), generator.randint(10**6, 10**8)) for _ in range(count)]


def forms(example: str, **options: object) -> tuple[Algorithm, Exponential | None, Program, Program]:
    """Return the algorithm, its exponential, and the program as written and factored, nothing renormalised."""
    design: Design = design_of(example, renormalise="never", **options)
    algorithm = algorithm_of(design)
    chosen = choose_exponential(design, algorithm, FLOATING[design.number.format])
    factored = assemble(algorithm, design, writing_of(design, chosen.series if chosen else None))
    return algorithm, chosen, assemble(algorithm, design, AS_WRITTEN), factored


def update(program: Program, inputs: Mapping[str, Sequence[Any]], numbers: Numbers, start_up: bool = False) -> Outcome:
    name = "start_up" if start_up else "steady" if program.has("steady") else "update"
    return evaluate(program.routine(name), inputs, numbers)


def inputs_of(algorithm: Algorithm, seed: object) -> dict[str, list[Fraction]]:
    size = {"q": 4, "dtheta": 3 * algorithm.subsamples, "previous": 3 * algorithm.previous}
    return {name: fractions(count, (seed, name)) for name, count in size.items()} | {"count": [Fraction(9)]}


def phi(outcome: Outcome) -> tuple[Any, Any, Any]:
    return outcome.vector("phi" if "phi_x" in outcome.named else SIGMA)


@pytest.mark.parametrize("example", EXPONENTIALS)
def test_phi_is_the_same_over_the_rationals(example: str) -> None:
    algorithm, _, written, factored = forms(example)
    for seed in range(TRIALS):
        inputs = inputs_of(algorithm, seed)
        as_written = phi(update(written, inputs, UNKNOWN))
        assert as_written == phi(update(factored, inputs, EXACT))
        assert all(isinstance(part, Fraction) for part in as_written)


@pytest.mark.parametrize("example", [name for name in EXAMPLES if "previous" in name])
def test_start_up_is_the_same_over_the_rationals(example: str) -> None:
    algorithm, _, written, factored = forms(example)
    inputs = inputs_of(algorithm, example)
    as_written = update(written, inputs, UNKNOWN, start_up=True)
    result = update(factored, inputs, EXACT, start_up=True)
    assert phi(as_written) == phi(result) == tuple(inputs["dtheta"])
    kept = (inputs["dtheta"] + inputs["previous"])[: 3 * algorithm.previous]
    assert as_written.blocks["previous"] == result.blocks["previous"] == kept


@pytest.mark.parametrize("accumulate", ["standard", "delta"])
@pytest.mark.parametrize("example", SERIES)
def test_series_update_is_the_same_over_the_rationals(example: str, accumulate: str) -> None:
    algorithm, _, written, factored = forms(example, accumulate=accumulate)
    for seed in range(TRIALS):
        inputs = inputs_of(algorithm, seed)
        as_written = update(written, inputs, EXACT).blocks["q"]
        assert as_written == update(factored, inputs, EXACT).blocks["q"]
        assert as_written != inputs["q"]


SAME_POLYNOMIAL = [name for name in WITHOUT_PHI if not name.startswith("euler") and "midpoint" not in name]
"""Euler angles have one form; about the midpoint the series leaves out other terms than the paper's, see below."""


def stepped(example: str, seed: object, accumulate: str = "delta", routine: str = "") -> tuple[list[Any], ...]:
    """Return every block of the state after a step from random fractions: as written, and factored.

    What a multistep method keeps are slopes q' as written, and h q' factored.
    """
    algorithm, _, written, factored = forms(example, accumulate=accumulate, max_rate_dps="573")
    h = declaration(design_of(example), algorithm).interval
    sizes = {block.name: block.size for block in written.state} | {algorithm.takes: 3 * algorithm.subsamples}
    inputs = {name: fractions(size, (seed, name)) for name, size in sizes.items()} | {"count": [Fraction(9)]}
    name = routine or ("steady" if written.has("steady") else "update")
    found = []
    for program, scale in ((written, 1), (factored, h)):
        kept = {"f": [scale * value for value in inputs["f"]]} if "f" in sizes else {}
        blocks = dict(evaluate(program.routine(name), inputs | kept, EXACT).blocks)
        if "f" in sizes:
            blocks["f"] = [value / scale for value in blocks["f"]]
        state = [block.name for block in written.state]
        found.append([value for each in state for value in blocks.get(each, ())[: 6 if each == "c" else None]])
        assert blocks[state[0]] != inputs[state[0]]
    return tuple(found)


@pytest.mark.parametrize("accumulate", ["standard", "delta"])
@pytest.mark.parametrize("example", SAME_POLYNOMIAL)
def test_a_step_is_the_same_over_the_rationals(example: str, accumulate: str) -> None:
    for seed in range(2):
        written, factored = stepped(example, seed, accumulate)
        assert written == factored


@pytest.mark.parametrize("starter", ["heun", "runge-kutta-4"])
def test_a_starter_is_the_same_over_the_rationals(starter: str) -> None:
    for seed in range(3):
        written, factored = stepped(f"adams-moulton-4 starter={starter}", seed, routine="start_up")
        assert written == factored


@pytest.mark.parametrize("n", range(1, 7))
def test_about_the_midpoint_the_series_differs_by_what_either_leaves_out(n: int) -> None:
    """Half the interval, of one polynomial rate, leaves 2^-(P + 1) of it: the first order that is left out."""
    example = next(name for name in EXAMPLES if f"taylor subsamples={n} " in name and "midpoint" in name)
    _, _, written, factored = forms(example)
    order = int(example.partition("order=")[2].partition(" ")[0])
    q, rate = fractions(4, n), [[50 * value for value in fractions(3, (n, j))] for j in range(n)]
    difference = []
    for span in (Fraction(1, 64), Fraction(1, 128)):
        ends = [span * Fraction(k, n) for k in range(n + 1)]
        theta = [
            sum(rate[j][axis] * (late ** (j + 1) - early ** (j + 1)) / (j + 1) for j in range(n))
            for early, late in pairwise(ends)
            for axis in range(3)
        ]
        pair = [update(program, {"q": q, "dtheta": theta}, EXACT).blocks["q"] for program in (written, factored)]
        difference.append(max(abs(a - b) for a, b in zip(*pair, strict=True)))
    assert float(difference[0] / difference[1]) == pytest.approx(2 ** (order + 1), rel=0.2)


def largest(program: Program, algorithm: Algorithm, bound: Fraction, part: Fraction, seed: object) -> dict[str, Any]:
    """Return inputs, in 40 digits, scaled so that |phi| is that part of its bound."""
    inputs = {name: [DIGITS.of(value) for value in values] for name, values in inputs_of(algorithm, seed).items()}
    inputs["q"] = [RADIANS.mpf(int(name == "w")) for name in "wxyz"]
    wanted, scale = RADIANS.mpf(part.numerator) / part.denominator * DIGITS.of(bound), RADIANS.mpf(1)
    for _ in range(60):
        scaled = {name: [scale * value for value in inputs[name]] for name in ("dtheta", "previous")}
        size = RADIANS.norm(phi(update(program, inputs | scaled, DIGITS)))
        if abs(size / wanted - 1) < RADIANS.mpf(10) ** -30:
            break
        scale *= wanted / size
    else:
        raise AssertionError("no scale gives that |phi|")
    return inputs | scaled


@pytest.mark.parametrize("kind", ["minimax", "taylor"])
@pytest.mark.parametrize("number", ["float32", "float64"])
@pytest.mark.parametrize("example", EXPONENTIALS)
def test_r_is_within_the_stated_truncation(example: str, number: str, kind: str) -> None:
    algorithm, chosen, written, factored = forms(example, number=number, exponential=kind)
    assert chosen is not None
    parts = [Fraction(2, 5), Fraction(9, 10), 1 - Fraction(1, 10**9)]
    for seed, part in enumerate(parts):
        inputs = largest(factored, algorithm, chosen.phi_max, part, seed)
        r = update(written, inputs, DIGITS).blocks["q"]
        named = update(factored, inputs, DIGITS).named
        scalar = abs(1 + named["u"] - r[0])
        vector = RADIANS.norm([named[f"v_{axis}"] - component for axis, component in zip("xyz", r[1:], strict=True)])
        assert scalar <= DIGITS.of(chosen.scalar_error)
        assert vector <= DIGITS.of(chosen.vector_error)


@pytest.mark.parametrize("number", ["float32", "float64"])
@pytest.mark.parametrize("rate", ["573", "5730"])
def test_the_stated_truncation_is_nearly_reached(number: str, rate: str) -> None:
    """A bound far above the truth would show nothing; the largest error over the range comes near it."""
    _, chosen, written, factored = forms("rotation-vector subsamples=1", number=number, max_rate_dps=rate)
    assert chosen is not None
    scalar = vector = RADIANS.mpf(0)
    for k in range(1, 201):
        theta = DIGITS.of(chosen.phi_max * Fraction(k, 200))
        inputs = {"q": [RADIANS.mpf(int(name == "w")) for name in "wxyz"], "dtheta": [theta, theta * 0, theta * 0]}
        r = update(written, inputs, DIGITS).blocks["q"]
        named = update(factored, inputs, DIGITS).named
        scalar = max(scalar, abs(1 + named["u"] - r[0]))
        vector = max(vector, abs(named["v_x"] - r[1]))
    assert DIGITS.of(chosen.scalar_error) / 2 < scalar <= DIGITS.of(chosen.scalar_error)
    assert DIGITS.of(chosen.vector_error) / 2 < vector <= DIGITS.of(chosen.vector_error)


@pytest.mark.parametrize("length", [Fraction(1), Fraction(3, 2)])
def test_matrix_forms_differ_by_the_length_alone(length: Fraction) -> None:
    """The squares of cao (5) give |q|^2 C, the nine products of cao (15) C of a unit q: equal at length one."""
    assert attitude.dcm is not attitude.dcm_squares
    _, _, written, factored = forms("rotation-vector subsamples=1", outputs="quaternion,dcm")
    q = [length * part for part in (Fraction(1, 6), Fraction(-1, 2), Fraction(5, 6), Fraction(-1, 6))]
    assert sum(part * part for part in q) == length**2
    squares = evaluate(written.routine("dcm"), {"q": q}).blocks["c_nb"]
    products = evaluate(factored.routine("dcm"), {"q": q}).blocks["c_nb"]
    assert (squares == products) is (length == 1)
