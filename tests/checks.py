"""What other tests rest on, brought down to functions that tell whether it holds: to be tried on mistakes.

Each check builds its design afresh, so that whatever has been changed in the package shows.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from exactly import FLOORS, cases, error, rounded
from qcone.algorithms import coefficients, increments, rotation_vector
from qcone.assembly import assemble, writing_of
from qcone.backends.bittrue import Model, new_state
from qcone.bundle import Bundle
from qcone.errors import CheckError
from qcone.ir.evaluate import Numbers, evaluate
from qcone.ir.statement import Role
from qcone.ir.writing import AS_WRITTEN
from qcone.pipeline import build
from qcone.reference import attitude, motions, quaternion
from qcone.registry import algorithm_of
from qcone.targets.compiler import Compiler
from qcone.vectors import SET, Vectors, draw, in_words
from qcone.verify import c_words, model_words, open_library
from qcone.words import from_words
from shipped import design_of
from symmetry import Run, holding, one, pairwise, samples
from watching import watch

CONING_3 = "rotation-vector subsamples=3 coefficients=coning"
CONING_4 = "rotation-vector subsamples=4 coefficients=coning"
HISTORY = "rotation-vector subsamples=1 previous=3"
PICARD = "picard order=3"


def symmetries(bundle: Bundle) -> set[str]:
    algorithm = bundle.facts.algorithm
    dtheta = samples(algorithm.subsamples, bundle.facts.number.name, 21)
    start, none = one(bundle), np.empty((0, 3, dtheta.shape[-1]), dtheta.dtype)
    return holding(lambda d, _: Run(bundle, start, d, none).phi, dtheta, none, pairwise)


def symmetry(name: str) -> bool:
    """phi of four sub-samples has the symmetry it claims, to the last bit (test_exact_properties)."""
    return name in symmetries(build(design_of(CONING_4)))


def forms_agree() -> bool:
    """phi as written and factored are equal over the rationals, and the products of Picard's (test_forms_agree)."""
    stand_in = Numbers(square_root=lambda _: Fraction(1), sine=lambda _: Fraction(0), cosine=lambda _: Fraction(1))
    q = [Fraction(k, 7) for k in (3, -2, 5, 1)]
    for example in (CONING_3, CONING_4, "rotation-vector subsamples=4 coefficients=compressed", PICARD):
        design = design_of(example, renormalise="never")
        algorithm = algorithm_of(design)
        dtheta = [Fraction((7 * k * k + 3) % 23 - 11, 1000) for k in range(3 * algorithm.subsamples)]
        writings = (AS_WRITTEN, writing_of(design, None))
        routines = [assemble(algorithm, design, writing).routine("update") for writing in writings]
        found = [evaluate(routine, {"q": q, "dtheta": dtheta}, stand_in) for routine in routines]
        if example == PICARD:
            if found[0].blocks["q"] != found[1].blocks["q"]:
                return False
        elif found[0].vector("phi") != found[1].vector("phi"):
            return False
    return True


def model_run(bundle: Bundle, given: NDArray[np.float64], q: NDArray[np.float64]) -> Iterator[NDArray[Any]]:
    """Yield q and C_nb of one lane after each of the updates (updates, components), from the attitude q."""
    model, state = Model(bundle.machine, bundle.facts.number), new_state(bundle.machine, bundle.facts.number, 1)
    name = bundle.machine.routine("update").having(Role.INPUT)[0].name
    model.run("set_quaternion", state, {"q_nb": q[:, None]})
    if bundle.driver.has_start:
        model.run("start", state, {"omega": given[0, :, None]})
        given = given[1:].reshape(-1, 3 * bundle.facts.algorithm.subsamples)
    for row in given:
        model.run("update", state, {name: row[:, None]})
        yield np.concatenate([state["q"], *model.run("dcm", state).values()])[:, 0]


def follows(example: str, **options: object) -> bool:
    """The model follows the hand-written reference through a manoeuvre, quaternion and matrix (test_accuracy)."""
    bundle = build(design_of(example, max_rate_dps="2000", outputs="quaternion,dcm", **options))
    n, previous = bundle.facts.algorithm.subsamples, bundle.facts.algorithm.previous
    motion, times = motions.large_angle_manoeuvre(), np.arange(20 * n + 1) / (100 * n)
    start = np.array([0.5, -0.1, 0.7, 0.5])
    start /= np.linalg.norm(start)
    rates, steps = options.get("input") == "rate", times.reshape(-1)
    dtheta = motion.increments(times).reshape(-1, n, 3)
    given = dtheta.reshape(len(dtheta), -1)
    if rates:
        omega = motion.rate(steps)
        ends = np.array([omega[n * k : n * k + n + 1] for k in range(len(dtheta))])
        rule = attitude.increments_cao_13 if options.get("increments") == "cao-13" else attitude.increments_from_rates
        dtheta, given = rule(ends, 0.01), omega
    if axes := options.get("axes"):
        assert axes == "y,-x,z"
        given = given.reshape(-1, 3)[:, [1, 0, 2]] * np.array([-1, 1, 1])
        given = given if rates else given.reshape(len(dtheta), -1)
    wanted = attitude.run(start, dtheta, coefficients="coning", previous=previous)
    found = np.array(list(model_run(bundle, given, start)))
    close = quaternion.error_angle(found[:, :4], wanted).max() < 1e-14
    matrix = np.abs(found[:, 4:].reshape(-1, 3, 3) - quaternion.to_matrix(quaternion.normalise(wanted))).max() < 4e-15
    unit = np.abs(np.linalg.norm(found[:, :4], axis=1) - 1).max() < 1e-15
    return bool(close and matrix and unit)


def exact(truth: Path) -> bool:
    """The first update meets the 40-digit value (test_truth)."""
    for chosen in ("coning", "compressed"):
        example = f"rotation-vector subsamples=4 coefficients={chosen}"
        bundle = build(design_of(example, max_rate_dps="5730", outputs="quaternion,dcm"))
        for _, theta, r in cases(truth, 4, chosen):
            (row,) = model_run(bundle, np.array(rounded(theta)).reshape(1, -1), np.eye(4)[0])
            if error(row[:4], r) > FLOORS["float64"]:
                return False
    return True


def accurate(compiler: Compiler) -> bool:
    """A minute of coning has the published error, 1.3e-11 rad (test_accuracy)."""
    bundle, motion, times = build(design_of(CONING_3)), motions.coning(), np.arange(60_001) / 1000
    rows = 20_000
    restart = np.zeros((1, rows), np.int32)
    restart[0, 0] = SET
    first = np.zeros((1, rows, 4))
    first[0, 0] = motion.attitude(times[:1])
    vectors = Vectors(restart, first, np.zeros((1, rows, 3)), motion.increments(times).reshape(1, rows, 9))
    words, _ = c_words(bundle, open_library(bundle, compiler, "-O2"), vectors)
    worst = quaternion.error_angle(words[0, :, :4], motion.attitude(times[3::3])).max()
    return bool(1.3e-11 / 1.2 < worst < 1.3e-11 * 1.2)


ARCSEC = np.pi / 180 / 3600
FIXED_ERRORS = {"delta": 0.05, "compensated": 1e-3}
"""What a minute of coning may be off by in 32-bit fixed point, arcsec; the algorithm's own error is 1.4e-4."""


def accurate_in_fixed_point(compiler: Compiler, accumulate: str) -> bool:
    """A minute of coning, from several attitudes, in the words of a design and in its C (test_word_lengths)."""
    bundle, motion = build(design_of(CONING_3, number="fixed32", accumulate=accumulate)), motions.coning()
    lanes, rows = 8, 6000
    times = np.arange(3 * rows + 1) / 300
    turned = quaternion.normalise(np.random.default_rng(2).standard_normal((lanes, 4)))
    ends = motion.attitude(times[[0, -1]])
    attitudes = np.zeros((lanes, rows, 4))
    attitudes[:, 0] = quaternion.product(turned, np.broadcast_to(ends[0], (lanes, 4)))
    given = np.broadcast_to(motion.increments(times).reshape(1, rows, 3, 3), (lanes, rows, 3, 3))
    restart = np.zeros((lanes, rows), np.int32)
    restart[:, 0] = SET
    vectors = in_words(bundle, restart, attitudes, np.zeros((lanes, rows, 3)), given)
    words, _ = c_words(bundle, open_library(bundle, compiler, "-O2"), vectors)
    held = bundle.machine.state[0].format
    assert held is not None
    q = quaternion.normalise(np.ldexp(words[:, -1, :4].astype(np.float64), -held.fraction))
    first = quaternion.normalise(from_words(bundle, "q_nb", vectors.attitude[:, 0]))
    back = quaternion.conjugate(np.broadcast_to(ends[0], (lanes, 4)))
    truth = quaternion.product(quaternion.product(first, back), np.broadcast_to(ends[1], (lanes, 4)))
    return bool(quaternion.error_angle(q, truth).max() < FIXED_ERRORS[accumulate] * ARCSEC)


def levels_agree() -> bool:
    """Sums of products and the integer operations made of them give the same words (test_proved_ranges)."""
    bundle = build(design_of(CONING_3, number="fixed32", accumulate="compensated"))
    try:
        model_words(bundle, draw(bundle, 2000))
    except CheckError:
        return False
    return True


def within_bounds() -> bool:
    """No value is beyond what is proved of it (test_proved_ranges)."""
    bundle = build(design_of(CONING_3, number="fixed32"))
    return not any(list(seen.beyond()) for seen in watch(bundle, draw(bundle, 2000)))


LITERAL = re.compile(r"(\d+\.\d+(?:e[+-]\d+)?)(F?) /\* (-?\d+/\d+) \*/")


def literals_are_rounded_once(*bundles: Bundle) -> bool:
    """Every literal of the text is the number nearest to the rational printed beside it: no other is nearer."""
    seen = 0
    for bundle in bundles or [build(design_of(CONING_4, number=number)) for number in ("float32", "float64")]:
        kind = np.dtype(bundle.facts.number.name).type
        for match in LITERAL.finditer(bundle.source):
            have, want = kind(match[1]), abs(Fraction(match[3]))
            others = [Fraction(float(np.nextafter(have, kind(end)))) for end in (0, np.inf)]
            if any(abs(other - want) < abs(Fraction(float(have)) - want) for other in others):
                return False
            seen += 1
    return seen > 0


def increments_are_exact() -> bool:
    """Rates that are polynomials of the rule's degree give their integrals, over the rationals."""
    for rule, n, degree in (("cao-13", 3, 2), *(("interpolating", n, n) for n in range(1, 7))):
        for row, (begin, end) in zip(increments.weights(n, rule), _intervals(n), strict=True):
            for power in range(degree + 1):
                total = sum((w * Fraction(k, n) ** power for k, w in enumerate(row)), Fraction(0))
                if total != (end ** (power + 1) - begin ** (power + 1)) / (power + 1):
                    return False
    return True


def _intervals(n: int) -> list[tuple[Fraction, Fraction]]:
    return [(Fraction(i, n), Fraction(i + 1, n)) for i in range(n)]


def weights_are_published() -> bool:
    """The derived pair weights are those typed in from the literature (reference), each to its last bit."""
    for n in range(2, 7):
        for chosen in rotation_vector.SETS:
            derived = {pair: float(weight) for pair, weight in coefficients.pair_weights(n, chosen).items()}
            if derived != attitude.pair_weights(n, chosen):
                return False
    return True


CHECKS: dict[str, Callable[[pytest.FixtureRequest], bool]] = {
    **{name: partial(lambda _, name: symmetry(name), name=name) for name in ("cyclic", "flip", "time-reversal")},
    "constant-rate": lambda _: symmetry("constant-rate"),
    "forms agree": lambda _: forms_agree(),
    "exact value": lambda request: exact(request.getfixturevalue("truth")),
    "published error": lambda request: accurate(request.getfixturevalue("first_compiler")),
    "reference": lambda _: follows(CONING_3) and follows(CONING_4),
    "reference, history": lambda _: follows(HISTORY),
    "reference, rates": lambda _: follows(CONING_3, input="rate"),
    "reference, cao (13)": lambda _: follows(CONING_3, input="rate", increments="cao-13"),
    "reference, axes": lambda _: follows(CONING_3, axes="y,-x,z") and follows(CONING_3, axes="y,-x,z", input="rate"),
    "fixed point, error": lambda request: all(
        accurate_in_fixed_point(request.getfixturevalue("first_compiler"), each) for each in FIXED_ERRORS
    ),
    "fixed point, levels agree": lambda _: levels_agree(),
    "fixed point, proved ranges": lambda _: within_bounds(),
    "literals rounded once": lambda _: literals_are_rounded_once(),
    "increments exact": lambda _: increments_are_exact(),
    "weights published": lambda _: weights_are_published(),
}
