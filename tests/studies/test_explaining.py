"""Explanations: of every algorithm of the catalogue, with numbers that are those of the algorithm itself."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from functools import cache

import pytest

from qcone.assembly import assemble
from qcone.declaration import declaration
from qcone.ir.evaluate import EXACT, evaluate
from qcone.ir.writing import AS_WRITTEN
from qcone.registry import algorithm_of
from qcone.studies.derivations import combination, multistep_weights
from qcone.studies.explaining import Row, rows
from shipped import EXAMPLES, design_of


@cache
def explained(example: str, **options: str) -> list[Row]:
    return rows(design_of(example, **options))


def texts(example: str, part: str, **options: str) -> list[str]:
    return [str(row["text"]) for row in explained(example, **options) if row["part"] == part]


@pytest.mark.parametrize("example", EXAMPLES)
def test_every_algorithm_is_explained(example: str) -> None:
    algorithm = algorithm_of(design_of(example))
    assert texts(example, "algorithm") == [f"{algorithm.name}: {algorithm.summary}"]
    assert texts(example, "derivation")
    assert texts(example, "as written")
    assert f"falls as T^{algorithm.order}" in texts(example, "error")[0]
    assert len(texts(example, "error")) > 1
    assert all({"part", "equation", "text"} == set(row) for row in explained(example))


def test_multistep_weights_and_constants_are_those_of_the_textbook() -> None:
    predictor, corrector = multistep_weights((0, -1, -2, -3)), multistep_weights((1, 0, -1, -2))
    assert predictor == ([Fraction(w, 24) for w in (55, -59, 37, -9)], Fraction(251, 720))
    assert corrector == ([Fraction(w, 24) for w in (9, 19, -5, 1)], Fraction(-19, 720))
    said = texts("adams-moulton-4 starter=heun", "error")
    assert "251/720 h^5 q^(5)" in said
    assert "-19/720 h^5 q^(5)" in said
    assert "true - corrected = -19/270 (corrected - predicted)" in said


def turned(example: str, angle: Fraction) -> list[Fraction]:
    """Return the attitude after one update, as written, about the x axis by `angle`."""
    design = design_of(example)
    algorithm = algorithm_of(design)
    program = assemble(algorithm, design, AS_WRITTEN)
    start = [Fraction(int(k % 4 == 0)) for k in range(9 if algorithm.state == "dcm" else 4)]
    given: dict[str, list[Fraction]] = {program.state[0].name: start}
    if algorithm.takes == "omega":
        rate = [angle / declaration(design, algorithm).interval, Fraction(0), Fraction(0)]
        given |= {"omega_last": rate, "omega": rate * 2}
    else:
        given["dtheta"] = [angle, Fraction(0), Fraction(0)]
    return list(evaluate(program.routine("update"), given, EXACT).blocks[program.state[0].name])


@pytest.mark.parametrize(("attitude", "bottom", "part"), [("quaternion", 3840, 1), ("dcm", 120, 7)])
def test_the_leading_term_of_runge_kutta_is_what_is_left(attitude: str, bottom: int, part: int) -> None:
    """About a fixed axis: the sine that one step gives misses the true one by that term."""
    example = f"runge-kutta-4 attitude={attitude}"
    assert f"|omega h|^5/{bottom};" in texts(example, "error")[1]
    angle = Fraction(1, 32)
    true = math.sin(angle / 2 if attitude == "quaternion" else angle)
    missed = true - float(turned(example, angle)[part])
    assert missed == pytest.approx(float(angle) ** 5 / bottom, rel=0.01)


@pytest.mark.parametrize("order", ["1", "2", "3", "4"])
def test_the_length_of_picard_s_series_is_what_it_has(order: str) -> None:
    said = next(text for text in texts(f"picard order={order}", "error") if text.startswith("|r|"))
    match = re.fullmatch(r"\|r\| - 1 = (-?)x(?:\^(\d))?/(\d+), x = \|sigma\|\^2", said)
    assert match
    angle = Fraction(1, 32)
    r = turned(f"picard order={order}", angle)
    excess = (sum(value * value for value in r) - 1) / 2
    wanted = (-1 if match[1] else 1) * float(angle) ** (2 * int(match[2] or 1)) / int(match[3])
    assert float(excess) == pytest.approx(wanted, rel=0.01)


ERRATA = {
    "rotation-vector subsamples=3 coefficients=coning": ["33/80 and 57/80", "figure 1"],
    "quaternion-taylor subsamples=3 order=10 about=start": ["1611", "order 12 or more"],
    "dcm-taylor subsamples=3 order=10": ["(11) multiplies from the wrong side", "(13) lacks the constants 1, 2, 6"],
    "picard order=closed": ["Sigma"],
    "adams-moulton-4 starter=heun": ["Milne's estimate", "1.68", "40 times"],
    "euler-angles": ["cos(pitch) = 0"],
}


@pytest.mark.parametrize("example", ERRATA)
def test_what_the_papers_misprint_is_said(example: str) -> None:
    said = " ".join(texts(example, "erratum"))
    assert all(words in said for words in ERRATA[example])


def test_errata_of_stages_are_said_where_the_stage_is_used() -> None:
    example = "rotation-vector subsamples=3 coefficients=coning"
    assert not any("cao (13)" in text for text in texts(example, "erratum"))
    assert any("cao (13), third row" in text for text in texts(example, "erratum", input="rate"))
    assert not any("cao (13)" in text for text in texts("runge-kutta-4 attitude=dcm", "erratum"))
    assert any("cao (16)" in text for text in texts(example, "erratum", outputs="euler"))


@pytest.mark.parametrize("rule", ["interpolating", "cao-13"])
def test_increments_are_those_of_the_design_s_rule(rule: str) -> None:
    example = "rotation-vector subsamples=3 coefficients=coning"
    said = [text for text in texts(example, "derivation", input="rate", increments=rule) if text.startswith("theta_")]
    assert len(said) == 3
    first = {"interpolating": "1/8 omega_0 + 19/72 omega_1 - 5/72 omega_2 + 1/72 omega_3"}
    assert first.get(rule, "5/36 omega_0 + 2/9 omega_1 - 1/36 omega_2") in said[0]


def test_a_weighted_sum_is_written_as_one_writes_it() -> None:
    assert combination((Fraction(-1, 2), Fraction(0), Fraction(1), Fraction(-1)), "w") == "- 1/2 w_0 + w_2 - w_3"
