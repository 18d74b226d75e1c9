"""Attitudes kept as matrix, quaternion or angles: set, read, kept at length, brought back by a call; compiled C."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from qcone.backends.bittrue import dtype_of
from qcone.bundle import Bundle
from qcone.pipeline import build
from qcone.reference import euler, quaternion
from qcone.reference.motions import Motion, Sinusoid
from qcone.targets.build import build_shared
from qcone.targets.compiler import Compiler
from qcone.targets.host import Library
from running import Ran, chain, singly
from shipped import design_of

NUMBERS = ("float32", "float64")
MATRICES = ("dcm-taylor subsamples=3 order=10", "runge-kutta-4 attitude=dcm")
QUATERNIONS = (
    "quaternion-taylor subsamples=3 order=10 about=start",
    "quaternion-taylor subsamples=6 order=16 about=midpoint",
    "runge-kutta-4 attitude=quaternion",
    "adams-moulton-4 starter=runge-kutta-4",
    "adams-moulton-4 starter=heun",
)
UPDATES = 100_000
HZ = 128
"""Updates a second; their interval is no rounded number."""


def built(example: str, number: str, **options: object) -> Bundle:
    return build(design_of(example, **{"number": number, "outputs": "quaternion,dcm", "update_hz": HZ, **options}))


def attitudes() -> NDArray[np.float64]:
    """Return unit quaternions: everywhere, turns by 180 degrees about every axis, and the seams of Shepperd's rule.

    At a seam two of the four components are equally large; each of the four is the largest in its turn.
    """
    random = np.random.default_rng(2)
    general = random.standard_normal((800, 4))
    half_turns = np.concatenate([np.zeros((300, 1)), random.standard_normal((300, 3))], axis=1)
    near_half_turns = half_turns + random.standard_normal((300, 4)) * 10.0 ** random.uniform(-17, -3, (300, 1))
    equal = [
        sign * row
        for i in range(4)
        for j in range(4)
        for sign in (1.0, -1.0)
        for row in (np.eye(4)[i] + np.eye(4)[j], np.eye(4)[i] - 0.999999 * np.eye(4)[j] * (i != j))
    ]
    all_equal = [[w, x, y, z] for w in (1, -1) for x in (1, -1) for y in (1, -1) for z in (1, -1)]
    found = np.concatenate([general, half_turns, near_half_turns, equal, all_equal, np.eye(4), -np.eye(4)])
    unit: NDArray[np.float64] = quaternion.normalise(found)
    return unit


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("example", MATRICES)
def test_the_quaternion_of_a_matrix_is_right_to_its_last_bits(
    first_compiler: Compiler, example: str, number: str
) -> None:
    """Shepperd's rule in all four cases: within 8 units of the last place of 1, of unit length, by either sign."""
    bundle, q = built(example, number), attitudes()
    given = quaternion.to_matrix(q).reshape(-1, 9)
    found = singly(bundle, first_compiler, np.zeros((len(q), 3 * bundle.facts.algorithm.subsamples)), given, exact=True)
    kept = found.q * np.where((found.q * q).sum(axis=1) < 0, -1, 1)[:, None]
    epsilon = float(np.finfo(dtype_of(bundle.facts.number)).eps)
    largest = np.abs(q).argmax(axis=1)
    for case in range(4):
        chosen = largest == case
        assert chosen.sum() > 200
        assert np.abs(kept[chosen] - q[chosen]).max() <= 8 * epsilon
    assert np.abs(np.linalg.norm(found.q, axis=1) - 1).max() <= 4 * epsilon
    assert np.abs(found.dcm - quaternion.to_matrix(q)).max() <= 8 * epsilon


@pytest.mark.parametrize("number", NUMBERS)
def test_setting_a_matrix_orthonormalises_it(first_compiler: Compiler, number: str) -> None:
    """Errors of 1e-3 in every component become errors of their square: rows of unit length at right angles."""
    bundle, q = built(MATRICES[0], number), attitudes()
    random = np.random.default_rng(4)
    bent = quaternion.to_matrix(q) + 1e-3 * random.standard_normal((len(q), 3, 3))
    c = singly(bundle, first_compiler, np.zeros((len(q), 9)), bent.reshape(-1, 9), exact=True).dcm
    defect = np.abs(c @ np.swapaxes(c, 1, 2) - np.eye(3)).max()
    assert defect < 1e-4
    assert defect < np.abs(bent @ np.swapaxes(bent, 1, 2) - np.eye(3)).max() / 100
    assert np.abs(np.linalg.det(c) - 1).max() < 1e-4
    assert np.abs(c - bent).max() < 1e-2


WANDERING = Motion(
    "wandering",
    UPDATES / HZ,
    sinusoids=(
        Sinusoid(0.3234567, (0.3, 0.0, -0.4), (0.0, 0.5, 0.2)),
        Sinusoid(0.9123456, (-0.3, 0.6, 0.0), (0.4, 0.0, 0.5)),
        Sinusoid(2.3456789, (0.6, 0.0, 0.8), (0.0, -0.9, 0.3)),
    ),
)
"""A motion that does not come round again, nor far from the start: coefficients rounded to float32 turn it little."""


def long_run(example: str, number: str, compiler: Compiler, rows: int = UPDATES, **options: object) -> Ran:
    """Run updates of the wandering motion from the identity; samples are rounded to float32 in either format."""
    bundle = built(example, number, **options)
    n = bundle.facts.algorithm.subsamples
    times = np.arange(rows * n + 1) / (HZ * n)
    samples = WANDERING.rate(times)[1:] if bundle.driver.has_start else WANDERING.increments(times)
    before = WANDERING.rate(times[:1])[0].astype(np.float32)
    return chain(bundle, compiler, samples.astype(np.float32).reshape(rows, n, 3), None, before)


def truncation_of_one_update(example: str, compiler: Compiler) -> float:
    """Return the most that one update does to the length, or to a product of rows, where nothing renormalises."""
    found = long_run(example, "float64", compiler, 2000, renormalise="never")
    if example in MATRICES:
        return float(np.abs(np.diff(found.dcm @ np.swapaxes(found.dcm, 1, 2), axis=0)).max())
    return float(np.abs(np.diff(np.linalg.norm(found.q, axis=1))).max())


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("example", QUATERNIONS)
def test_length_is_kept_over_many_updates(first_compiler: Compiler, example: str, number: str) -> None:
    """Nothing adds up: what is off is off by rounding and by the truncation of an update or two."""
    allowed = 4 * float(np.finfo(number).eps) + 2 * truncation_of_one_update(example, first_compiler)
    q = long_run(example, number, first_compiler).q
    assert np.abs(np.linalg.norm(q, axis=1) - 1).max() <= allowed


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("example", MATRICES)
def test_a_matrix_stays_orthogonal_over_many_updates(first_compiler: Compiler, example: str, number: str) -> None:
    allowed = 8 * float(np.finfo(number).eps) + 2 * truncation_of_one_update(example, first_compiler)
    found = long_run(example, number, first_compiler)
    assert np.abs(found.dcm @ np.swapaxes(found.dcm, 1, 2) - np.eye(3)).max() <= allowed
    assert np.abs(np.linalg.det(found.dcm) - 1).max() <= allowed
    assert np.abs(np.linalg.norm(found.q, axis=1) - 1).max() <= allowed


@pytest.mark.parametrize("example", [QUATERNIONS[0], MATRICES[0]])
def test_left_alone_it_drifts_away(first_compiler: Compiler, example: str) -> None:
    """So that the two tests above show something."""
    found = long_run(example, "float32", first_compiler, renormalise="never", accumulate="standard")
    defect = np.abs(found.dcm @ np.swapaxes(found.dcm, 1, 2) - np.eye(3)).max()
    assert defect > 100 * np.finfo(np.float32).eps


@pytest.mark.parametrize("example", [*QUATERNIONS, *MATRICES])
def test_compensation_gains_for_everything_that_accumulates(first_compiler: Compiler, example: str) -> None:
    """float32 against float64 on the same samples; of the multistep methods the weights' own rounding is left."""
    kinds = {"true": ("float64", "delta"), "plain": ("float32", "delta"), "carried": ("float32", "compensated")}
    runs = {
        name: long_run(example, number, first_compiler, 20_000, accumulate=accumulate).dcm
        for name, (number, accumulate) in kinds.items()
    }
    plain, carried = (np.abs(runs[name] - runs["true"]).max() for name in ("plain", "carried"))
    assert carried < plain / (5 if "taylor" in example else 1.5)


@pytest.mark.parametrize("example", [*QUATERNIONS, *MATRICES])
def test_compensation_follows_a_turn_too_slow_for_the_last_place(first_compiler: Compiler, example: str) -> None:
    """Each update turns by less than half a unit of the last place of q: a plain sum stands still, or runs off."""
    rate, rows = np.array([3e-7, 2e-7, -2e-7]), 20_000
    turned = quaternion.from_rotation_vector(rate * rows / HZ)
    start = quaternion.normalise(np.array([0.55, 0.5, -0.45, 0.5]))
    found = {}
    for accumulate in ("delta", "compensated"):
        bundle = built(example, "float32", accumulate=accumulate)
        n = bundle.facts.algorithm.subsamples
        sample = rate if bundle.driver.has_start else rate / (HZ * n)
        attitude = quaternion.to_matrix(start).reshape(9) if example in MATRICES else start
        run = chain(bundle, first_compiler, np.broadcast_to(sample, (rows, n, 3)), attitude, rate)
        wanted = quaternion.to_matrix(quaternion.product(start, turned))
        found[accumulate] = np.abs(run.dcm[-1] - wanted).max()
    moved = float(np.linalg.norm(rate)) * rows / HZ
    assert found["delta"] > 0.3 * moved, "nothing moves, or something else"
    assert found["compensated"] < 4 * np.finfo(np.float32).eps


CALL = """\
#include <stdint.h>
#include "tested.h"

void call(int32_t rows, const {ctype} *given, {ctype} *kept);
void call(int32_t rows, const {ctype} *given, {ctype} *kept)
{{
    tested_state state = TESTED_STATE_INIT;
    for (int32_t row = 0; row < rows; ++row) {{
        for (int32_t k = 0; k < {size}; ++k) {{
            state.{block}[k] = given[{size} * row + k];
        }}
        tested_renormalise(&state);
        for (int32_t k = 0; k < {size}; ++k) {{
            kept[{size} * row + k] = state.{block}[k];
        }}
    }}
}}
"""


def renormalised(bundle: Bundle, compiler: Compiler, given: NDArray[Any], block: str) -> NDArray[Any]:
    """Return the state block after one call of `renormalise`, from rows of what it held."""
    ctype, size = bundle.driver.ctype, given.shape[1]
    files = {**bundle.sources, "call.c": CALL.format(ctype=ctype, size=size, block=block)}
    declaration = f"void call(int32_t rows, const {ctype} *given, {ctype} *kept);"
    library = Library(build_shared(compiler, files, "-O1"), declaration)
    given = np.ascontiguousarray(given, dtype_of(bundle.facts.number))
    kept = np.zeros_like(given)
    library.run("call", len(given), given, kept)
    return kept.astype(np.float64)


@pytest.mark.parametrize("number", NUMBERS)
def test_renormalise_brings_a_quaternion_back(first_compiler: Compiler, number: str) -> None:
    bundle = built(QUATERNIONS[0], number, renormalise="separate")
    q = attitudes()
    epsilon = float(np.finfo(number).eps)
    for off in (1e-3, -1e-3):
        kept = renormalised(bundle, first_compiler, (1 + off) * q, "q")
        length = np.linalg.norm(kept, axis=1)
        assert np.abs(length - 1).max() <= 1.5 * off**2 + abs(off) ** 3 + 4 * epsilon
        assert np.abs(kept / length[:, None] - q).max() <= 4 * epsilon


@pytest.mark.parametrize("number", NUMBERS)
def test_renormalise_brings_a_matrix_back(first_compiler: Compiler, number: str) -> None:
    bundle = built(MATRICES[0], number, renormalise="separate")
    random = np.random.default_rng(8)
    bent = quaternion.to_matrix(attitudes())
    bent = bent + 1e-3 * random.uniform(-1, 1, bent.shape)
    kept = renormalised(bundle, first_compiler, bent.reshape(-1, 9), "c").reshape(-1, 3, 3)
    assert np.abs(kept @ np.swapaxes(kept, 1, 2) - np.eye(3)).max() < 3e-5


@pytest.mark.parametrize("example", [*QUATERNIONS, *MATRICES])
def test_renormalise_is_there_when_it_is_asked_for(example: str) -> None:
    for chosen, there in (("separate", True), ("every", False), ("never", False)):
        bundle = built(example, "float64", renormalise=chosen)
        assert ("tested_renormalise(" in bundle.header) is there
        routines = [each for each in bundle.machine.routines if each.name in ("update", "steady")]
        headings = " ".join(f"{step.text} {step.equation}" for each in routines for step in each.steps)
        assert bool(re.search("renormalisation|re-orthogonalisation", headings)) is (chosen == "every")


@pytest.mark.parametrize("number", NUMBERS)
def test_angles_are_kept_as_they_are_set(first_compiler: Compiler, number: str) -> None:
    bundle = build(design_of("euler-angles", number=number, outputs="quaternion,dcm,euler"))
    random = np.random.default_rng(9)
    angles = random.uniform(-1, 1, (500, 3)) * [np.pi, 1.5, np.pi]
    found = singly(bundle, first_compiler, np.zeros((500, 6)), angles, exact=True)
    epsilon = float(np.finfo(number).eps)
    q = euler.from_angles(angles.astype(number).astype(np.float64))
    np.testing.assert_array_equal(found["euler"], angles.astype(number))
    assert np.abs(found.q - q).max() <= 4 * epsilon
    assert np.abs(found.dcm - quaternion.to_matrix(q)).max() <= 8 * epsilon
