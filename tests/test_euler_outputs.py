"""Roll, pitch, yaw of the compiled C against 40 digits: what the header promises, everywhere and at the poles.

Errors are in units of the last place of pi. The attitude that the three angles stand for is compared with the
quaternion the C reports; each angle with that quaternion's own, where it has one.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from exactly import EXACT
from qcone.pipeline import build
from qcone.reference import euler, quaternion
from qcone.targets.compiler import Compiler
from qcone.vectors import in_form
from running import singly
from series import conjugate, product
from shipped import design_of

NUMBERS = ("float32", "float64")
CONVENTIONS = ("zyx", "zxy")
HOLDERS = ("rotation-vector subsamples=1", "dcm-taylor subsamples=1 order=10")
"""Attitudes kept as a quaternion, and as a matrix."""

REBUILT, SINGLE = 8, 4
Digits = list[Any]


def attitudes(convention: str) -> NDArray[np.float64]:
    """Return unit quaternions: everywhere, all quadrants, at the poles, and near them at every distance."""
    random = np.random.default_rng(21)
    angles = random.uniform(-np.pi, np.pi, (400, 3))
    angles[:, 1] = random.uniform(-np.pi / 2, np.pi / 2, 400)
    near = angles[:300].copy()
    near[:, 1] = random.choice([-1, 1], 300) * (np.pi / 2 - 10.0 ** random.uniform(-17, -1, 300))
    near[200:, 1] = random.choice([-1, 1], 100) * np.pi / 2
    quarters = np.pi / 4 * random.integers(-4, 5, (150, 3))
    quarters[:, 1] = np.pi / 4 * random.integers(-2, 3, 150)
    signs = np.array(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 4)).reshape(4, -1).T
    corners = quaternion.normalise(signs[np.any(signs != 0, axis=1)])
    every = [euler.from_angles(each, convention) for each in (angles, near, quarters)]  # type: ignore[arg-type]
    found: NDArray[np.float64] = np.concatenate([*every, corners])
    return found * random.choice([-1, 1], (len(found), 1))


def exact_angles(q: Digits, convention: str) -> Digits:
    """Return roll, pitch, yaw of a quaternion of any length by the matrix: cao (16), or its like for zxy."""
    w, x, y, z = [value / EXACT.norm(q) for value in q]
    if convention == "zyx":
        roll = EXACT.atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z)
        yaw = EXACT.atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z)
        sine = 2 * (w * y - x * z)
    else:
        roll = EXACT.atan2(2 * (w * y - x * z), w * w - x * x - y * y + z * z)
        yaw = EXACT.atan2(2 * (w * z - x * y), w * w - x * x + y * y - z * z)
        sine = 2 * (y * z + w * x)
    return [roll, EXACT.asin(max(EXACT.mpf(-1), min(EXACT.mpf(1), sine))), yaw]


def exact_quaternion(angles: Sequence[Any], convention: str) -> Digits:
    roll, pitch, yaw = (EXACT.mpf(float(angle)) / 2 for angle in angles)
    about = {"zyx": (3, 2, 1), "zxy": (3, 1, 2)}[convention]
    q = [EXACT.mpf(1), *[EXACT.mpf(0)] * 3]
    for axis, half in zip(about, (yaw, pitch, roll), strict=True):
        turn = [EXACT.cos(half), *(EXACT.sin(half) if k == axis else EXACT.mpf(0) for k in (1, 2, 3))]
        q = product(q, turn)
    return q


@pytest.fixture(scope="module")
def run(first_compiler: Compiler) -> Any:
    @cache
    def of(holder: str, number: str, convention: str) -> tuple[list[Digits], NDArray[Any]]:
        """Return the quaternions the C reports, to 40 digits, and its angles."""
        bundle = build(design_of(holder, number=number, outputs="quaternion,euler", euler=convention))
        given = in_form(attitudes(convention), bundle.driver.setter)
        still = np.zeros((len(given), 3 * bundle.facts.algorithm.subsamples))
        found = singly(bundle, first_compiler, still, given, exact=True)
        return [[EXACT.mpf(value) for value in row] for row in found.q.tolist()], found["euler"].astype(np.float64)

    return of


def unit(number: str) -> float:
    return float(np.spacing(np.dtype(number).type(np.pi)))


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("holder", HOLDERS)
def test_the_attitude_of_the_angles_is_the_quaternion_s(run: Any, holder: str, convention: str, number: str) -> None:
    quaternions, angles = run(holder, number, convention)
    worst = 0.0
    for q, rpy in zip(quaternions, angles, strict=True):
        between = product(conjugate([value / EXACT.norm(q) for value in q]), exact_quaternion(rpy, convention))
        worst = max(worst, float(2 * EXACT.norm(between[1:])))
    assert worst <= REBUILT * unit(number)


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("holder", HOLDERS)
def test_each_angle_is_within_what_the_pole_allows(run: Any, holder: str, convention: str, number: str) -> None:
    quaternions, angles = run(holder, number, convention)
    worst, poles = 0.0, 0
    for q, rpy in zip(quaternions, angles, strict=True):
        wanted = exact_angles(q, convention)
        cosine = EXACT.cos(wanted[1])
        poles += cosine < 1e-6
        for have, want in zip(rpy.tolist(), wanted, strict=True):
            off = abs(EXACT.mpf(have) - want)
            off = min(off, abs(off - 2 * EXACT.pi))  # roll and yaw of -pi and pi are one
            worst = max(worst, float(off * cosine))
    assert poles > 100
    assert worst <= SINGLE * unit(number)


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("holder", HOLDERS)
def test_angles_stay_in_their_ranges(run: Any, holder: str, convention: str, number: str) -> None:
    """Of pitch that is a half pi rounded, of roll and yaw pi rounded: the formats' own, one unit above the truth."""
    _, angles = run(holder, number, convention)
    pi = float(np.dtype(number).type(np.pi))
    assert np.isfinite(angles).all()
    assert np.abs(angles[:, 1]).max() <= pi / 2
    assert np.abs(angles[:, [0, 2]]).max() <= pi
    quadrants = {tuple(signs) for signs in np.sign(angles).tolist()}
    assert len({signs for signs in quadrants if 0 not in signs}) == 8


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_the_header_states_what_is_measured_here(convention: str) -> None:
    bundle = build(design_of(HOLDERS[0], outputs="euler", euler=convention))
    header = " ".join(bundle.header.replace(" * ", " ").split())
    assert f"convention {convention}; roll and yaw in [-pi, pi], pitch at most pi/2 in size." in header
    assert f"within {REBUILT} units in the last place of pi of the quaternion's, poles included;" in header
    assert f"each angle within {SINGLE} such units over cos(pitch)." in header
