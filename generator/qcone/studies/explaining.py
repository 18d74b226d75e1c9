"""Explain an algorithm: its derivation in steps with exact rationals, its leading error, and what its papers misprint.

The steps are those the algorithm is made of: the headings of its two written forms, with their equation numbers.
"""

from __future__ import annotations

from fractions import Fraction

from qcone.assembly import assemble, writing_of
from qcone.design import Design
from qcone.ir.specification import Algorithm
from qcone.ir.statement import Program, walk
from qcone.ir.writing import AS_WRITTEN, Series, Writing
from qcone.registry import algorithm_of
from qcone.studies.derivations import derivation, leading_error
from qcone.studies.misprints import errata

Row = dict[str, object]
NO_SERIES = Series((Fraction(-1, 8), Fraction(1, 384)), (Fraction(-1, 48),))
"""Taylor coefficients, to show the form of the exponential; a design chooses its own."""


def rows(design: Design) -> list[Row]:
    """Return the explanation as rows: part, equation, text."""
    algorithm = algorithm_of(design)
    found = [_row("algorithm", str(algorithm.source), f"{algorithm.name}: {algorithm.summary}")]
    found += [_row("derivation", equation, text) for equation, text in derivation(design, algorithm)]
    found += _steps(algorithm, design, AS_WRITTEN, "as written")
    if algorithm.written is not None or algorithm.state == "quaternion":
        found += _steps(algorithm, design, writing_of(design, NO_SERIES), "factored")
    found += [_row("error", equation, text) for equation, text in leading_error(design, algorithm)]
    found += [_row("erratum", "", text) for text in (*algorithm.errata, *errata(design))]
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
