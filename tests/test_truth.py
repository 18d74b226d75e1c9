"""The compiled C and its model against 40-digit truth: one update from the identity is r.

The floors are those of research on rounding alone: increments are rounded to the type, and what is left is
the rounding of one update.
"""

from __future__ import annotations

from math import factorial, pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from exactly import EXACT, FLOORS, KEYS, cases, closed_form, error, rounded
from qcone.backends.bittrue import dtype_of
from qcone.bundle import Bundle
from qcone.pipeline import build
from qcone.targets.compiler import Compiler
from qcone.vectors import INIT, Vectors
from qcone.verify import c_words, differing_bits, model_words, open_library
from shipped import design_of

UPDATE_HZ = 10


def built(example: str, number: str, largest: float, n: int) -> Bundle:
    """Build a design whose declared increments reach `largest` rad."""
    dps = np.ceil(largest * n * UPDATE_HZ * 180 / pi) + 1
    bundle = build(design_of(example, number=number, max_rate_dps=f"{dps:.0f}", update_hz=str(UPDATE_HZ)))
    assert bundle.facts.known.increment >= largest
    return bundle


def first_updates(bundle: Bundle, compiler: Compiler, theta: NDArray[np.float64]) -> NDArray[Any]:
    """Return r (rows, 4) from the compiled C, of increments (rows, N, 3); the model gives the same bits."""
    dtype, rows = dtype_of(bundle.facts.number), len(theta)
    vectors = Vectors(
        np.full((1, rows), INIT, np.int32),
        np.zeros((1, rows, 4), dtype),
        np.zeros((1, rows, 3), dtype),
        theta.astype(dtype).reshape(1, rows, -1),
    )
    words, contracted = c_words(bundle, open_library(bundle, compiler, "-O2"), vectors)
    assert not contracted
    assert differing_bits(words, model_words(bundle, vectors)) == 0
    return words[0, :, len(bundle.driver.state_words) :][:, :4]


FORMS = [
    (1, "taylor", "rotation-vector subsamples=1"),
    *((n, each, f"rotation-vector subsamples={n} coefficients={each}") for n in range(2, 7) for each in KEYS),
]


@pytest.mark.parametrize("number", FLOORS)
@pytest.mark.parametrize(("n", "coefficients", "example"), FORMS, ids=[form[2] for form in FORMS])
def test_one_update_meets_the_exact_value(
    truth: Path, first_compiler: Compiler, n: int, coefficients: str, example: str, number: str
) -> None:
    found = list(cases(truth, n, coefficients))
    assert len(found) == 6
    theta = np.array([rounded(theta) for _, theta, _ in found])
    bundle = built(example, number, float(np.linalg.norm(theta, axis=-1).max()), n)
    r = first_updates(bundle, first_compiler, theta)
    errors = {name: error(row, exact) for row, (name, _, exact) in zip(r, found, strict=True)}
    assert max(errors.values()) <= FLOORS[number], errors


def test_coefficient_sets_are_told_apart_in_float64(truth: Path, first_compiler: Compiler) -> None:
    """The cases are hard enough: with another set's weights an update misses the exact value."""
    found = list(cases(truth, 4, "taylor"))
    theta = np.array([rounded(theta) for _, theta, _ in found])
    largest = float(np.linalg.norm(theta, axis=-1).max())
    for other in ("coning", "compressed", "expanded"):
        bundle = built(f"rotation-vector subsamples=4 coefficients={other}", "float64", largest, 4)
        r = first_updates(bundle, first_compiler, theta)
        worst = max(error(row, exact) for row, (_, _, exact) in zip(r, found, strict=True))
        assert worst > 1000 * FLOORS["float64"], other


@pytest.mark.parametrize("number", FLOORS)
@pytest.mark.parametrize(("n", "coefficients", "example"), FORMS[1:], ids=[form[2] for form in FORMS[1:]])
def test_the_coning_term_is_told_from_none(truth: Path, n: int, coefficients: str, example: str, number: str) -> None:
    """In either format: the rotation by the sum of the increments alone misses the exact value."""
    missed = []
    for _, theta, exact in cases(truth, n, coefficients):
        total = [sum(column) for column in zip(*theta, strict=True)]
        closed = closed_form(total)
        missed.append(float(max(abs(have - want) for have, want in zip(closed, exact, strict=True))))
    assert max(missed) > 100 * FLOORS[number]


PICARD = {1: (1, 1), 2: (2, 1), 3: (2, 2), 4: (3, 2)}
"""Terms kept of cos(|sigma|/2) and of sin(|sigma|/2)/|sigma|, by order."""


def first_dropped(kept: tuple[int, int], size: float) -> tuple[float, float]:
    """Return the first terms left out, of the scalar and of the vector part: both series alternate and fall."""
    half, (k, m) = size / 2, kept
    return half ** (2 * k) / factorial(2 * k), half ** (2 * m + 1) / factorial(2 * m + 1)


@pytest.mark.parametrize("order", [*PICARD, "closed"])
def test_picard_is_the_closed_form_but_for_the_first_term_left_out(first_compiler: Compiler, order: int | str) -> None:
    axis = np.array([0.36, -0.48, 0.8])
    sizes = np.array([0.01, 0.1, 0.3, 0.5])
    theta = (sizes[:, None] * axis).reshape(-1, 1, 3)
    bundle = built(f"picard order={order}", "float64", 0.5, 1)
    for r, sigma in zip(first_updates(bundle, first_compiler, theta), theta[:, 0], strict=True):
        closed = closed_form([EXACT.mpf(value) for value in sigma.tolist()])
        length = float(np.linalg.norm(sigma))
        scalar = float(abs(EXACT.mpf(float(r[0])) - closed[0]))
        parts = zip(r[1:].tolist(), closed[1:], strict=True)
        vector = float(EXACT.norm([EXACT.mpf(have) - want for have, want in parts]))
        floor = 2 * FLOORS["float64"]
        if isinstance(order, str):
            assert scalar <= FLOORS["float64"]
            assert vector <= FLOORS["float64"]
            continue
        scalar_bound, vector_bound = first_dropped(PICARD[order], length)
        assert 0.95 * scalar_bound - floor <= scalar <= scalar_bound + floor
        assert 0.95 * vector_bound - floor <= vector <= vector_bound + floor


NORM_ERRORS = {1: (1 / 8, 2), 2: (1 / 128, 4), 3: (-1 / 384, 4)}
"""|r| - 1 = factor |sigma|^power, to leading order; nothing renormalises r itself."""


@pytest.mark.parametrize("order", NORM_ERRORS)
def test_picard_has_its_norm_error(first_compiler: Compiler, order: int) -> None:
    theta = 0.05 * np.array([[[0.36, -0.48, 0.8]]])
    r = first_updates(built(f"picard order={order}", "float64", 0.1, 1), first_compiler, theta)[0]
    factor, power = NORM_ERRORS[order]
    assert np.linalg.norm(r) - 1 == pytest.approx(factor * 0.05**power, rel=0.02)


@pytest.mark.parametrize("number", FLOORS)
def test_picard_closed_meets_the_exact_single_sample_value(truth: Path, first_compiler: Compiler, number: str) -> None:
    found = list(cases(truth, 1, "taylor"))
    theta = np.array([rounded(theta) for _, theta, _ in found])
    bundle = built("picard order=closed", number, float(np.linalg.norm(theta, axis=-1).max()), 1)
    for row, (name, _, exact) in zip(first_updates(bundle, first_compiler, theta), found, strict=True):
        assert error(row, exact) <= FLOORS[number], name
