"""The demonstration: one design from specification to verified C, its cost, and what its coning term is worth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import pi

import numpy as np

from qcone import verify
from qcone.bundle import Bundle
from qcone.design import design_from_options
from qcone.pipeline import build
from qcone.reference import motions, quaternion
from qcone.registry import entries
from qcone.studies.recording import Recording
from qcone.studies.replaying import replay
from qcone.targets.compiler import first_compiler

ROWS = 20_000
SECONDS = 60.0
UPDATE_HZ = 100
CONE_ANGLE, CONE_RATE = 5 * pi / 180, 4 * pi
ARCSEC = 180 * 3600 / pi


@dataclass(frozen=True)
class Step:
    """One thing the demonstration did, in words, or rows to be shown as a table."""

    text: str
    rows: tuple[dict[str, object], ...] = ()


def demonstrate() -> Iterator[Step]:
    """Yield the steps as they are done. Raises MissingToolError where there is no compiler."""
    bundle = _design("demo_coning_float32", 3, "coning", "float32")
    yield Step(f"generated {bundle.name}: {bundle.facts.algorithm.summary}   [{bundle.facts.algorithm.source}]")
    verify.read_back(bundle)
    yield Step("read the C back: every statement is the routine's")
    compiler = first_compiler()
    outcomes = list(verify.verify(bundle, ROWS, compiler.command[0] if compiler.name != "zig" else None))
    compared = [each for each in outcomes if each.differing_bits is not None]
    bad = [each for each in outcomes if each.failed]
    bits = sum(each.differing_bits or 0 for each in compared)
    yield Step(
        f"compiled with {len(compared)} compiler settings and compared {ROWS} updates each with the model: "
        f"{bits} differing bits" + (f"; FAILED: {bad[0].first_difference}" if bad else "")
    )
    yield Step("operations of one update and of the direction cosine matrix", tuple(_operations(bundle)))
    yield Step(f"coning motion, 5 deg, 2 Hz, {SECONDS:.0f} s: error of the compiled C", tuple(_coning()))


def _design(name: str, subsamples: int, coefficients: str | None, number: str) -> Bundle:
    options = {
        "algorithm": "rotation-vector",
        "subsamples": subsamples,
        "coefficients": coefficients,
        "number": number,
        "max_rate_dps": "573",
        "update_hz": str(UPDATE_HZ),
        "outputs": "quaternion,dcm",
    }
    return build(design_from_options(name, options, entries()))


def _operations(bundle: Bundle) -> Iterator[dict[str, object]]:
    for routine, levels in bundle.facts.counts.items():
        for level, counts in levels.items():
            yield {
                "routine": routine,
                "level": level,
                "multiply": counts.multiply,
                "by 2^k": counts.power_of_two,
                "add": counts.add,
                "subtract": counts.subtract,
                "divide": counts.divide,
                "sqrt": counts.square_root,
                "trig": counts.trigonometric,
            }


def _coning() -> Iterator[dict[str, object]]:
    motion = motions.coning(CONE_ANGLE, CONE_RATE)
    for subsamples, coefficients, number in (
        (1, None, "float64"),
        (3, "coning", "float32"),
        (3, "coning", "float64"),
    ):
        bundle = _design("demo", subsamples, coefficients, number)
        rate = UPDATE_HZ * subsamples
        times = np.arange(int(SECONDS * rate) + 1) / rate
        recording = Recording("increment", times[1:], motion.increments(times), Fraction(rate))
        start = motion.attitude(times[:1])[0]
        run = replay(bundle, recording, start)
        error = quaternion.error_angle(run.q, motion.attitude(run.time_s))
        yield {
            "algorithm": bundle.facts.algorithm.name,
            "number": number,
            "largest error, arcsec": float(f"{error.max() * ARCSEC:.3g}"),
        }
