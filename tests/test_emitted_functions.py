"""Arctangent, arcsine, sine, cosine and square root without a library: the compiled C against 40 digits.

A user's own algorithm gives the functions of its samples out as entries of a matrix. Arguments are rounded to the
format first; what is measured is the function of the rounded argument, in units of the last place of pi.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from qcone.bundle import Bundle
from qcone.design import design_from_options
from qcone.formats.floating import FLOATING
from qcone.passes.functions import choose_functions
from qcone.pipeline import build
from qcone.registry import entries
from qcone.targets.compiler import Compiler
from qcone.verify import read_back
from running import singly

EXACT = mpmath.mp.clone()
EXACT.dps = 40
NUMBERS = ("float32", "float64")
ROWS = 4000
Array = NDArray[Any]

FUNCTIONS = """\
from qcone.ir.real import Source, algorithm, arcsine, arctangent_2, matrix, number, sine_cosine, square_root_of_unit

@algorithm("functions", source=Source("paper", "(1)"), subsamples=2, state="dcm")
def functions(c, dtheta):
    (y, x, s), (angle, square, _) = dtheta
    sine, cosine = sine_cosine(angle)
    zero = number(0, y)
    return matrix([arctangent_2(y, x), arcsine(s), sine, cosine, square_root_of_unit(square), *[zero] * 4])
"""


@dataclass(frozen=True)
class Given:
    """Arguments, rounded to the format: rows of y, x of the arctangent, of the arcsine, an angle, a square."""

    rows: Array

    def column(self, k: int) -> list[Any]:
        return [EXACT.mpf(value) for value in self.rows[:, k].astype(np.float64).tolist()]


def corners(number: str) -> list[float]:
    info = np.finfo(number)
    tiny, least = float(info.tiny), float(info.smallest_subnormal)
    return [0.0, 1.0, 0.5, tiny, 3 * tiny, least, 5 * least, 1e-30, 0.41421356, 2.4142135, 1e15, float(info.eps)]


def arguments(number: str) -> Given:
    """Return all quadrants, axes, diagonals, tiny and unlike sizes; the ends and beyond of the arcsine; three turns."""
    random = np.random.default_rng(12)
    directions = random.uniform(-np.pi, np.pi, ROWS)
    y, x = np.sin(directions), np.cos(directions)
    sizes = 2.0 ** random.integers(-60, 20, (2, ROWS))
    y, x = np.where(random.random(ROWS) < 0.5, [y, x], [y, x] * sizes)
    seam = random.random(ROWS) < 0.2
    y[seam] = x[seam] * np.tan(np.pi / 8 * random.integers(-4, 5, seam.sum()) * (1 + 1e-7 * random.random(seam.sum())))
    ends = random.choice([-1, 1], ROWS) * (1 - 2.0 ** -random.integers(1, 54, ROWS))
    s = np.where(random.random(ROWS) < 0.3, ends, random.uniform(-1.1, 1.1, ROWS))
    s = np.where(random.random(ROWS) < 0.1, s * 2.0 ** -random.integers(10, 100, ROWS), s)
    angle = random.uniform(-3, 3, ROWS) * np.pi
    angle = np.where(random.random(ROWS) < 0.2, np.pi / 4 * random.integers(-12, 13, ROWS), angle)
    angle = np.where(random.random(ROWS) < 0.1, angle * 2.0 ** -random.integers(1, 100, ROWS), angle)
    square = random.random(ROWS) * 2.0 ** -random.integers(0, 40, ROWS)
    signed = [sign * value for value in corners(number) for sign in (1.0, -1.0)]
    pairs = np.array([(a, b) for a in signed for b in signed])
    most = np.resize(np.clip(signed, -2, 2), len(pairs))
    several = [
        np.concatenate([y, pairs[:, 0]]),
        np.concatenate([x, pairs[:, 1]]),
        np.concatenate([s, most]),
        np.concatenate([angle, most]),
        np.concatenate([square, np.abs(np.clip(most, -1, 1))]),
    ]
    return Given(np.stack([*several, np.zeros(ROWS + len(pairs))], axis=1).astype(number))


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Bundle]:
    file: Path = tmp_path_factory.mktemp("functions") / "functions.py"
    file.write_text(FUNCTIONS, encoding="utf-8")

    @cache
    def of(number: str) -> Bundle:
        options = {"algorithm": f"{file}:functions", "number": number, "max_rate_dps": "573", "update_hz": "100"}
        bundle = build(design_from_options("functions", options, entries()))
        read_back(bundle)
        return bundle

    return of


@pytest.fixture(scope="module")
def found(built: Callable[[str], Bundle], first_compiler: Compiler) -> Callable[[str], tuple[Given, Array]]:
    """Return a function that gives arguments and the functions of the compiled C, (rows, 9); the model's bits."""

    @cache
    def of(number: str) -> tuple[Given, Array]:
        given = arguments(number)
        return given, singly(built(number), first_compiler, given.rows, exact=True)["c"].astype(np.float64)

    return of


Found = Callable[[str], tuple[Given, Array]]


def worst(have: Array, wanted: list[Any], unit: float) -> float:
    """Return the largest error in units."""
    assert np.isfinite(have).all()
    return float(max(abs(EXACT.mpf(value) - want) for value, want in zip(have.tolist(), wanted, strict=True)) / unit)


def place_of_pi(number: str) -> float:
    """Return the unit of the last place of pi."""
    return float(np.spacing(np.dtype(number).type(np.pi)))


@pytest.mark.parametrize("number", NUMBERS)
def test_arctangent_in_all_quadrants(found: Found, number: str) -> None:
    given, have = found(number)
    y, x = given.column(0), given.column(1)
    wanted = [EXACT.atan2(b, a) if a or b else EXACT.mpf(0) for b, a in zip(y, x, strict=True)]
    assert worst(have[:, 0], wanted, place_of_pi(number)) <= 4
    quadrants = {(float(b) > 0, float(a) > 0) for b, a in zip(y, x, strict=True) if a and b}
    assert len(quadrants) == 4


@pytest.mark.parametrize("number", NUMBERS)
def test_arctangent_on_the_axes(found: Found, number: str) -> None:
    """Zero, a quarter and half a turn are those numbers rounded; both zeros are one."""
    given, have = found(number)
    y, x = given.rows[:, 0].astype(np.float64), given.rows[:, 1].astype(np.float64)
    pi = float(np.dtype(number).type(np.pi))
    for chosen, wanted in (
        ((y == 0) & (x >= 0), 0.0),
        ((y == 0) & (x < 0), pi),
        ((y > 0) & (x == 0), pi / 2),
        ((y < 0) & (x == 0), -pi / 2),
    ):
        assert chosen.sum() > 5
        assert set(np.abs(have[chosen, 0] - wanted)) == {0.0}


@pytest.mark.parametrize("number", NUMBERS)
def test_arctangent_of_small_angles_keeps_its_digits(found: Found, number: str) -> None:
    given, have = found(number)
    y, x = given.rows[:, 0].astype(np.float64), given.rows[:, 1].astype(np.float64)
    ratio = np.divide(y, x, out=np.ones_like(y), where=x >= 2.0**-60)
    small = (x >= 2.0**-60) & (np.abs(ratio) < 1e-4) & (np.abs(ratio) > 1e-30)
    assert small.sum() > 50
    error = np.abs(have[small, 0] / np.arctan(ratio[small]) - 1)
    assert error.max() <= 2 * float(np.finfo(number).eps)


@pytest.mark.parametrize("number", NUMBERS)
def test_arcsine_is_clamped_and_sharp_at_its_ends(found: Found, number: str) -> None:
    given, have = found(number)
    one = EXACT.mpf(1)
    wanted = [EXACT.asin(max(-one, min(one, value))) for value in given.column(2)]
    assert worst(have[:, 1], wanted, place_of_pi(number)) <= 4
    beyond = np.abs(given.rows[:, 2]) >= 1
    assert beyond.sum() > 100
    half = float(np.dtype(number).type(np.pi)) / 2
    np.testing.assert_array_equal(np.abs(have[beyond, 1]), half)


@pytest.mark.parametrize("number", NUMBERS)
def test_sine_and_cosine_over_three_turns(found: Found, number: str) -> None:
    """Up to 3 pi in size. What is left is the rounding of pi and of the fold."""
    given, have = found(number)
    angles, epsilon = given.column(3), float(np.finfo(number).eps)
    assert worst(have[:, 2], list(map(EXACT.sin, angles)), epsilon) <= 4
    assert worst(have[:, 3], list(map(EXACT.cos, angles)), epsilon) <= 4


@pytest.mark.parametrize("number", NUMBERS)
def test_square_root_is_right_to_its_last_bits(found: Found, number: str) -> None:
    """Relative to the root where a power of four of the ladder reaches, then beneath half the last place of 1."""
    given, have = found(number)
    reach = EXACT.mpf(4) ** -sum(choose_functions(FLOATING[number]).ladder)
    epsilon = float(np.finfo(number).eps)
    for value, root in zip(given.column(4), have[:, 4].tolist(), strict=True):
        wanted = EXACT.sqrt(value)
        allowed = 2 * epsilon * wanted if value >= reach else epsilon / 2
        assert abs(EXACT.mpf(root) - wanted) <= allowed


@pytest.mark.parametrize("number", NUMBERS)
def test_nothing_of_a_library_is_called(built: Callable[[str], Bundle], number: str) -> None:
    text = re.sub(r"/\*.*?\*/", "", built(number).source, flags=re.DOTALL)
    assert "math.h" not in text
    assert set(re.findall(r"(\w+)\(", text)) <= {"defined", *re.findall(r"functions_\w+", text)}
