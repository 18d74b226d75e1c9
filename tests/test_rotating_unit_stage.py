"""The stage of a rotating unit in compiled C: exact to the stated units, the reference's twin, for every algorithm."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from qcone import pipeline, verify
from qcone.algorithms import rotating_unit as written
from qcone.formats.fixed import Signal
from qcone.ir.machine import MachineOp
from qcone.ir.real import Quaternion, Scalar
from qcone.ir.statement import Operation
from qcone.outcomes import describe_first, word_names
from qcone.pipeline import build
from qcone.reference import euler, quaternion, rotating_unit
from qcone.stage_contract import ANGLE_UNITS, QUATERNION_UNITS, TILT_UNITS
from qcone.targets.build import build_shared
from qcone.targets.compiler import Compiler, compilers
from qcone.targets.host import Library
from qcone.vectors import CORRECT, INIT, draw
from shipped import EXAMPLES, shipped
from unit_runs import Turned, exact_body, exact_correction, rows, turned, unit

NUMBERS = ("float32", "float64")
COUNT = 1000
FLOORS = {"angle": 2.0, "tilt": 6.5, "quaternion": 2.0}
"""What is measured over the rows below, rounded up; the bounds that the header states are those of the worst case."""


@cache
def ran(number: str, compiler: Compiler, arcsec: int = 600) -> Turned:
    bundle = build(unit(number=number, max_correction_arcsec=arcsec, outputs="quaternion,dcm,euler"))
    largest = float(bundle.facts.known.correction or 0)
    return turned(bundle, compiler, *rows(number, COUNT, largest))


def errors(found: Turned, number: str, largest: float) -> dict[str, float]:
    """Return the largest errors against the exact functions, in the units the header states them in."""
    unit_, dtype = float(np.finfo(number).eps), np.dtype(number).type
    worst = {"angle": 0.0, "tilt": 0.0, "quaternion": 0.0}
    for k, encoder in enumerate(found.encoder.tolist()):
        corrected, *tilts = exact_correction(encoder, found.harmonics[k])
        half_place = float(np.spacing(np.abs(dtype(found.angle[k])))) / 2
        angle = (float(abs(found.angle[k] - corrected)) - half_place) / (unit_ * largest)
        tilt = max(float(abs(have - want)) for have, want in zip(found.tilt[k].tolist(), tilts, strict=True))
        body = exact_body(found.q_ns[k], float(found.angle[k]), found.tilt[k])
        part = max(float(abs(have - want)) for have, want in zip(found.q_nb[k].tolist(), body, strict=True))
        for name, value in (("angle", angle), ("tilt", tilt / (unit_ * largest)), ("quaternion", part / unit_)):
            worst[name] = max(worst[name], value)
    return worst


BOUNDS = {"angle": ANGLE_UNITS, "tilt": TILT_UNITS, "quaternion": QUATERNION_UNITS}


@pytest.mark.parametrize("arcsec", [600, 36000])
@pytest.mark.parametrize("number", NUMBERS)
def test_errors_are_below_the_stated_units(number: str, arcsec: int, first_compiler: Compiler) -> None:
    largest = np.deg2rad(arcsec / 3600)
    worst = errors(ran(number, first_compiler, arcsec), number, largest)
    for name, value in worst.items():
        assert value <= FLOORS[name] <= BOUNDS[name], (name, value)


@pytest.mark.parametrize("number", NUMBERS)
def test_sine_and_cosine_of_the_half_angle_over_the_whole_range(number: str, first_compiler: Compiler) -> None:
    """With nothing to correct and the sensors at rest the body's quaternion is cos and -sin of half the angle."""
    found = ran(number, first_compiler)
    still = (found.harmonics == 0).all(axis=1) & (found.q_ns == [1, 0, 0, 0]).all(axis=1)
    assert still.sum() > 50
    angles = found.angle[still]
    assert (angles == rows(number, COUNT, 1)[0][still]).all(), "an angle without an error is left as it is"
    assert np.abs(angles).max() > 9.42
    half = angles / 2
    wanted = np.stack([np.cos(half), 0 * half, 0 * half, -np.sin(half)], axis=1)
    assert np.abs(found.q_nb[still] - wanted).max() <= 4 * np.finfo(number).eps


@pytest.mark.parametrize("number", NUMBERS)
def test_the_reference_says_the_same(number: str, first_compiler: Compiler) -> None:
    """The hand-written twin in float64, on the rounded arguments."""
    found, epsilon = ran(number, first_compiler), float(np.finfo(number).eps)
    encoder = rows(number, COUNT, np.deg2rad(1 / 6))[0].astype(np.float64)
    harmonics = found.harmonics
    error = encoder - rotating_unit.corrected_angle(encoder, (harmonics[:, 0], harmonics[:, 1], harmonics[:, 2]))
    corrected = encoder - error
    assert np.abs(found.angle - corrected).max() <= 4.1 * epsilon, "half a place of 3 pi"
    tilts = [rotating_unit.modelled_tilt(corrected[k], harmonics[k, 3:].reshape(2, 3)) for k in range(len(corrected))]
    assert np.abs(found.tilt - np.stack(tilts)).max() <= 0.03 * epsilon
    body = rotating_unit.body_attitude(quaternion.normalise(found.q_ns), found.angle, found.tilt)
    assert np.abs(quaternion.normalise(found.q_nb) - body).max() <= 4 * epsilon
    assert found.dcm is not None
    assert found.euler is not None
    assert np.abs(found.dcm.reshape(-1, 3, 3) - quaternion.to_matrix(found.q_nb)).max() <= 4 * epsilon
    rebuilt = euler.from_angles(found.euler, "zyx")
    assert quaternion.error_angle(rebuilt, body).max() <= 16 * float(np.spacing(np.dtype(number).type(np.pi)))


@pytest.mark.parametrize("example", EXAMPLES)
def test_every_algorithm_takes_the_stage(example: str, first_compiler: Compiler) -> None:
    """Whatever the state is, the body's attitude belongs to the quaternion that is reported; no bit differs."""
    number = NUMBERS[list(EXAMPLES).index(example) % 2]
    bundle = build(unit(example, number=number))
    verify.read_back(bundle)
    random = np.random.default_rng(7)
    angles = random.uniform(-3 * np.pi, 3 * np.pi, 60)
    q = quaternion.normalise(random.standard_normal((60, 4)))
    found = turned(bundle, first_compiler, angles, np.resize([2e-4, -1e-4, 3e-4], (60, 9)), q)
    body = rotating_unit.body_attitude(found.q_ns, found.angle, found.tilt)
    assert np.abs(found.q_nb - body).max() <= 4 * np.finfo(number).eps


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("accumulate", ["delta", "standard", "compensated"])
@pytest.mark.parametrize("example", ["rotation-vector subsamples=3 coefficients=coning", "runge-kutta-4 attitude=dcm"])
def test_every_accumulation_takes_the_stage(example: str, accumulate: str, number: str) -> None:
    design = unit(example, number=number, accumulate=accumulate, outputs="quaternion,dcm,euler")
    assert verify.accept(build(design)).evidence.differing_bits == 0


def test_all_levels_and_sanitizers_of_both_compilers() -> None:
    outcomes = list(verify.verify(shipped("rotation_vector_3_coning_rins_float32"), 3000))
    assert {each.status for each in outcomes} <= {"ok", "absent"}
    assert {each.differing_bits for each in outcomes if each.status == "ok"} == {0}
    assert len([each for each in outcomes if each.status == "ok"]) == 6 * len(compilers())
    assert {each.sanitizer_reports for each in outcomes if each.sanitizer_reports is not None} == {0}


def test_the_compensated_attitude_is_the_one_that_is_turned(first_compiler: Compiler) -> None:
    """The body's attitude is made of q less its residual, as quaternion() reports it."""
    bundle = build(unit(number="float32", accumulate="compensated"))
    names = [block.name for block in bundle.machine.routine("body_quaternion").blocks]
    assert "residual" in names
    assert "residual" not in [block.name for block in bundle.machine.routine("correct").blocks]


ACROSS = """\
#include "tested.h"

void run_across(double *out);
void run_across(double *out)
{
    static const tested_state fresh = TESTED_STATE_INIT;
    tested_state state = fresh;
    const double a[3] = { 1e-4, 2e-4, 3e-4 };
    const double x[3] = { 4e-5, 5e-5, 6e-5 };
    const double y[3] = { 7e-5, 8e-5, 9e-5 };
    const double q[4] = { 0.0, 1.0, 0.0, 0.0 };
    const double encoder = 1.0;
    tested_correct(&state, &encoder, &out[0], &out[1]);
    tested_set_correction(&state, a, x, y);
    tested_correct(&state, &encoder, &out[3], &out[4]);
    tested_set_quaternion(&state, q);
    tested_correct(&state, &encoder, &out[6], &out[7]);
    tested_init(&state);
    tested_correct(&state, &encoder, &out[9], &out[10]);
}
"""


def test_harmonics_are_zero_at_first_and_outlast_an_attitude(first_compiler: Compiler) -> None:
    bundle = build(unit())
    files = {**bundle.sources, "across.c": ACROSS}
    library = Library(build_shared(first_compiler, files, "-O1"), "void run_across(double *out);")
    out = np.full(12, np.nan)
    library.run("run_across", out)
    fresh, corrected, after, cleared = out.reshape(4, 3)
    np.testing.assert_array_equal(fresh, [1, 0, 0])
    np.testing.assert_array_equal(after, corrected)
    np.testing.assert_array_equal(cleared, fresh)
    assert corrected[0] == pytest.approx(1 - (1e-4 * np.sin(1) + 2e-4 * np.cos(1) + 3e-4), abs=1e-15)
    s, c = np.sin(2 * corrected[0]), np.cos(2 * corrected[0])
    tilts = [4e-5 * s + 5e-5 * c + 6e-5, 7e-5 * s + 8e-5 * c + 9e-5]
    assert corrected[1:] == pytest.approx(tilts, abs=1e-18)


@pytest.mark.parametrize("number", NUMBERS)
def test_vectors_hold_the_corners_of_the_stage(number: str) -> None:
    bundle = shipped(f"rotation_vector_3_coning_rins_{number}")
    vectors = draw(bundle, 20_000)
    angles, harmonics = vectors.unit
    dtype, info = np.dtype(number).type, np.finfo(number)
    for eighth in range(-12, 13):
        assert (angles == dtype(np.pi / 4 * eighth)).sum() > 20
    assert np.abs(angles).max() == dtype(3 * np.pi)
    assert np.signbit(angles[angles == 0]).any()
    assert not np.signbit(angles[angles == 0]).all()
    assert ((np.abs(angles) > 0) & (np.abs(angles) < info.tiny)).any()
    largest = float(bundle.facts.known.correction or 0)
    size = np.hypot(harmonics[..., ::3], harmonics[..., 1::3]) + np.abs(harmonics[..., 2::3])
    assert size.max() <= largest * (1 + 4 * info.eps)
    assert (size > largest * (1 - 1e-6)).mean() > 0.1
    assert (vectors.restart == CORRECT).sum() > 500
    assert (vectors.restart[:, 0] == INIT).all()
    assert vectors.inputs.tobytes() == draw(bundle, 20_000).inputs.tobytes()


def test_a_lane_carries_no_harmonics_into_another() -> None:
    """A lane's first row is an `init`: the C, which runs lane after lane, would otherwise still hold the last one's."""
    bundle = shipped("rotation_vector_3_coning_rins_float64")
    vectors = draw(bundle, 400)
    first = [block.name for block in bundle.machine.state].index("azimuth_harmonic")
    at = sum(block.size for block in bundle.machine.state[:first])
    words = verify.model_words(bundle, vectors)
    assert not words[:, 0, at : at + 9].any()
    assert words[:, 1, at : at + 9].any()


def test_a_wrong_stage_bit_is_told_with_its_function(monkeypatch: pytest.MonkeyPatch) -> None:
    bundle = shipped("rotation_vector_3_coning_rins_float64")
    vectors = draw(bundle, 200)
    expected = verify.model_words(bundle, vectors)
    words = expected.copy()
    at = word_names(bundle).index("body_quaternion w")
    words[3, 1, at] = np.nextafter(words[3, 1, at], 2)
    told = describe_first(bundle, vectors, words, expected)
    assert told.startswith("lane 3, step 1, body_quaternion w: C ")
    assert float(vectors.unit[0][3, 1]).hex() in told


Patch = pytest.MonkeyPatch
Mutation = Callable[[Patch], None]


def _correction(change: Callable[..., tuple[Scalar, Scalar, Scalar]]) -> Mutation:
    right = written.correction
    return lambda patch: patch.setattr(written, "correction", lambda *given: change(right, *given))


def _body(change: Callable[..., Quaternion]) -> Mutation:
    right = written.body_attitude
    return lambda patch: patch.setattr(written, "body_attitude", lambda *given: change(right, *given))


def _rotated(a: tuple[Any, ...]) -> tuple[Any, ...]:
    return a[1], a[0], a[2]


MUTATIONS: dict[str, tuple[Mutation, str]] = {
    "sine and cosine of the encoder's error exchanged": (
        _correction(lambda right, al, a, x, y: right(al, _rotated(a), x, y)),
        "angle",
    ),
    "the offset subtracted twice": (
        _correction(lambda right, al, a, x, y: right(al - a[2], a, x, y)),
        "angle",
    ),
    "the error added": (
        _correction(lambda right, al, a, x, y: right(al, tuple(-each for each in a), x, y)),
        "angle",
    ),
    "the tilt at the angle that is not corrected": (
        _correction(
            lambda right, al, a, x, y: (right(al, a, x, y)[0], *right(al, tuple(0 * each for each in a), x, y)[1:])
        ),
        "tilt",
    ),
    "tilts exchanged": (_correction(lambda right, al, a, x, y: right(al, a, y, x)), "tilt"),
    "the body turned forward": (_body(lambda right, q, al, x, y: right(q, -al, x, y)), "quaternion"),
    "the tilt turned forward": (_body(lambda right, q, al, x, y: right(q, al, -x, -y)), "quaternion"),
    "the tilts about each other's axis": (_body(lambda right, q, al, x, y: right(q, al, y, x)), "quaternion"),
}


@pytest.mark.parametrize("what", MUTATIONS)
def test_mistakes_are_seen(what: str, monkeypatch: Patch, first_compiler: Compiler) -> None:
    mutate, name = MUTATIONS[what]
    mutate(monkeypatch)
    bundle = build(unit(number="float64"))
    largest = float(bundle.facts.known.correction or 0)
    found = turned(bundle, first_compiler, *rows("float64", 60, largest))
    assert errors(found, "float64", largest)[name] > 1000 * BOUNDS[name]


def test_a_series_a_term_short_is_seen(monkeypatch: Patch, first_compiler: Compiler) -> None:
    """At the largest correction there is, the last term of cosine still shows."""
    right = pipeline.choose_small_angle
    monkeypatch.setattr(
        pipeline, "choose_small_angle", lambda *given: replace(right(*given), cosine=right(*given).cosine[:-1])
    )
    bundle = build(unit(number="float64", max_correction_arcsec=36000))
    found = turned(bundle, first_compiler, *rows("float64", 60, np.deg2rad(10)))
    assert errors(found, "float64", np.deg2rad(10))["tilt"] > 2 * FLOORS["tilt"]


def test_fixed_point_keeps_what_its_header_states(first_compiler: Compiler) -> None:
    """Against 40 digits of the rounded arguments: half a place and the stated errors, read from the header."""
    bundle = shipped("rotation_vector_3_coning_rins_fixed32_compensated")
    largest = float(bundle.facts.known.correction or 0)
    found = turned(bundle, first_compiler, *rows("float64", COUNT, largest))
    header = " ".join(re.sub(r"\n ?\*? *", " ", bundle.header).split())
    angle, tilt, part = (
        float(re.findall(pattern, header)[0])
        for pattern in (
            r"its last place and (\S+) rad",
            r"within (\S+) rad of the exact",
            r"is within (\S+) of the exact",
        )
    )
    half_place = 2.0 ** -(bundle.driver.bits("angle") + 1)
    for k, encoder in enumerate(found.encoder.tolist()):
        corrected, *tilts = exact_correction(encoder, found.harmonics[k])
        assert abs(found.angle[k] - corrected) <= half_place + angle
        assert max(abs(have - want) for have, want in zip(found.tilt[k].tolist(), tilts, strict=True)) <= tilt
        body = exact_body(found.q_ns[k], float(found.angle[k]), found.tilt[k])
        assert max(abs(have - want) for have, want in zip(found.q_nb[k].tolist(), body, strict=True)) <= part


def test_a_coefficient_at_its_end_may_be_rounded_up_to_a_word() -> None:
    """The largest correction is no word: the nearest one is beyond it, and still in the range that is relied on."""
    bundle = build(unit(number="fixed32", max_correction_arcsec=601))
    largest = bundle.facts.known.correction
    assert largest is not None
    read = [each for each in bundle.machine.routine("set_correction").body if isinstance(each, Operation)]
    bounds = [(each.format, each.bound) for each in read if each.op is MachineOp.READ]
    assert len(bounds) == 9
    for signal, bound in bounds:
        assert isinstance(signal, Signal)
        assert bound is not None
        word = round(largest / signal.lsb)
        assert word * signal.lsb > largest
        assert word * signal.lsb <= bound
