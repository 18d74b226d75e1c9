"""Symmetries that hold to the last bit, for every shipped design and every form that goes through a phi.

cyclic         permuting the body axes cyclically permutes phi
flip           turning the body axes by 180 degrees about one of them flips phi, and with it r and q
time-reversal  theta_i -> -theta_(N+1-i) negates phi, and conjugates r
constant-rate  equal increments give phi = S

They are about the increments along the body's axes. Bits are compared, but for the sign of zeros: x - x is
+0 whichever way round it is written. A property that is not claimed must fail: no claim is missing.
"""

from __future__ import annotations

import numpy as np
import pytest

from checks import literals_are_rounded_once
from qcone.assembly import assemble
from qcone.backends.bittrue import Model, dtype_of, new_state
from qcone.bundle import Bundle
from qcone.formats.floating import FLOATING
from qcone.ir.evaluate import Numbers, evaluate
from qcone.ir.statement import Routine
from qcone.ir.writing import AS_WRITTEN, Writing
from qcone.registry import algorithm_of
from shipped import DESIGNS, THROUGH_PHI, WITH_PHI, design_of, shipped
from symmetry import (
    CYCLIC,
    FLIPS,
    ROWS,
    Array,
    Phi,
    Run,
    attitudes,
    holding,
    left_to_right,
    one,
    pairwise,
    same,
    samples,
    scalar_and,
    signs_in,
)

FLOATS = [name for name, design in DESIGNS.items() if design.number.format in FLOATING]
"""What fixed point promises is another thing, and next door."""
DESIGNED = [name for name in FLOATS if DESIGNS[name].algorithm in THROUGH_PHI]
RATES = [name for name in DESIGNED if DESIGNS[name].input == "rate"]
INCREMENTS = [name for name in DESIGNED if name not in RATES]


# -- every form of the catalogue, run in the number format's arithmetic ---------------------------------


def written(example: str, form: str, number: str) -> Phi:
    """Return phi as the routine of that form calculates it, one rounded operation after another."""
    design = design_of(example, number=number)
    program = assemble(algorithm_of(design), design, AS_WRITTEN if form == "as-written" else Writing())
    routine: Routine = program.routine("steady" if program.has("steady") else "update")
    chosen, kind = FLOATING[number], np.dtype(number).type
    numbers = Numbers(lambda exact: kind(float(chosen.round(exact))), np.sqrt, np.sin, np.cos)

    def phi(dtheta: Array, previous: Array) -> Array:
        given = {"q": [kind(1), kind(0), kind(0), kind(0)], "dtheta": [*dtheta.reshape(-1, ROWS)]}
        history = {"previous": [*previous.reshape(-1, ROWS)], "count": [len(previous)]}
        with np.errstate(all="ignore"):
            outcome = evaluate(routine, {**given, **history}, numbers)
        return np.array(outcome.vector("phi" if "phi_x" in outcome.named else "dtheta"))

    return phi


@pytest.mark.parametrize("number", ["float32", "float64"])
@pytest.mark.parametrize("form", ["as-written", "factored"])
@pytest.mark.parametrize("example", WITH_PHI)
def test_a_form_has_the_properties_it_claims_and_no_others(example: str, form: str, number: str) -> None:
    algorithm = algorithm_of(design_of(example))
    dtheta = samples(algorithm.subsamples, number, 1)
    previous = samples(algorithm.previous, number, 2)
    total = left_to_right if form == "as-written" else pairwise
    found = holding(written(example, form, number), dtheta, previous, total)
    assert found == algorithm.claims(form)


def test_what_the_design_says_does_not_hold_is_not_claimed() -> None:
    for example in WITH_PHI:
        algorithm = algorithm_of(design_of(example))
        one_sided = "previous" in example or ("compressed" in example and algorithm.subsamples > 2)
        assert ("time-reversal" in algorithm.claims("factored")) is not one_sided
        assert {"cyclic", "flip"} <= algorithm.claims("factored") & algorithm.claims("as-written")


# -- every shipped design, by its bit-true model --------------------------------------------------------


@pytest.mark.parametrize("name", INCREMENTS)
def test_a_shipped_design_has_the_properties_it_claims_and_no_others(name: str) -> None:
    bundle = shipped(name)
    algorithm, dtype = bundle.facts.algorithm, dtype_of(bundle.facts.number)
    dtheta, previous = samples(algorithm.subsamples, dtype, 4), samples(algorithm.previous, dtype, 5)
    start = one(bundle)
    found = holding(lambda d, p: Run(bundle, start, d, p).phi, dtheta, previous, pairwise)
    assert found == algorithm.claims(bundle.facts.design.form)


@pytest.mark.parametrize("name", INCREMENTS)
def test_flipping_the_axes_flips_r_and_q_of_a_shipped_design(name: str) -> None:
    bundle = shipped(name)
    algorithm, dtype = bundle.facts.algorithm, dtype_of(bundle.facts.number)
    dtheta, previous = samples(algorithm.subsamples, dtype, 6), samples(algorithm.previous, dtype, 7)
    q = attitudes(dtype)
    usual = Run(bundle, q, dtheta, previous)
    for signs in signs_in(dtype, FLIPS):
        flipped = Run(bundle, q * scalar_and(signs), dtheta * signs, previous * signs)
        assert same(flipped.r, usual.r * scalar_and(signs))
        assert same(flipped.q, usual.q * scalar_and(signs))
        assert same(flipped.residual, usual.residual * scalar_and(signs))


@pytest.mark.parametrize("name", INCREMENTS)
def test_reversing_time_conjugates_r_of_a_shipped_design_that_claims_it(name: str) -> None:
    bundle = shipped(name)
    algorithm, dtype = bundle.facts.algorithm, dtype_of(bundle.facts.number)
    dtheta, previous = samples(algorithm.subsamples, dtype, 8), samples(algorithm.previous, dtype, 9)
    start = one(bundle)
    usual, back = Run(bundle, start, dtheta, previous), Run(bundle, start, -dtheta[::-1], -previous)
    conjugated = same(back.r, usual.r * np.array([[1], [-1], [-1], [-1]], dtype))
    assert conjugated is ("time-reversal" in algorithm.claims(bundle.facts.design.form))


@pytest.mark.parametrize("name", [name for name in INCREMENTS if DESIGNS[name].parameters.get("previous")])
def test_the_start_up_of_a_history_form_takes_the_increment_for_phi(name: str) -> None:
    bundle = shipped(name)
    dtype = dtype_of(bundle.facts.number)
    model, state = Model(bundle.machine, bundle.facts.number), new_state(bundle.machine, bundle.facts.number, ROWS)
    model.run("init", state)
    stream = samples(bundle.facts.algorithm.previous, dtype, 10)
    for dtheta in stream:
        named: dict[str, Array] = {}
        with np.errstate(all="ignore"):
            model.run("update", state, {"dtheta": dtheta}, named)
        assert "phi_x" not in named
        assert "h_x" not in named
    assert same(state["previous"], stream[::-1].reshape(-1, ROWS))
    model.run("update", state, {"dtheta": stream[0]}, named)
    assert "phi_x" in named


@pytest.mark.parametrize("name", FLOATS)
def test_the_constants_of_a_shipped_design_are_rounded_once(name: str) -> None:
    assert literals_are_rounded_once(shipped(name))


# -- rates: the stage before the update adds samples in their order of time ------------------------------


def body_rates(bundle: Bundle, seed: int) -> tuple[Array, Array]:
    """Return rates (N + 1, 3, ROWS) along the body's axes, the last one that of `start`."""
    rates = 3000 * samples(bundle.facts.algorithm.subsamples + 1, dtype_of(bundle.facts.number), seed)
    return rates[:-1], rates[-1]


def sensor(bundle: Bundle, body: Array) -> Array:
    """Return vectors (..., 3, rows) along the sensor's axes, given them along the body's."""
    turned = np.empty_like(body)
    for axis, (index, sign) in enumerate(bundle.facts.design.axes):
        turned[..., index, :] = sign * body[..., axis, :]
    return turned


def body(bundle: Bundle, sensor: Array) -> Array:
    """Return vectors (..., 3, rows) along the body's axes, given them along the sensor's."""
    return np.stack([sign * sensor[..., index, :] for index, sign in bundle.facts.design.axes], axis=-2)


def run_rates(bundle: Bundle, q: Array, rates: Array, before: Array) -> Run:
    return Run(bundle, q, sensor(bundle, rates), np.empty(0), sensor(bundle, before))


@pytest.mark.parametrize("name", RATES)
def test_a_rate_design_keeps_the_symmetries_of_space(name: str) -> None:
    bundle = shipped(name)
    (rates, before), q = body_rates(bundle, 11), attitudes(dtype_of(bundle.facts.number))
    usual = run_rates(bundle, q, rates, before)
    assert same(run_rates(bundle, q, rates[:, CYCLIC], before[CYCLIC]).phi, usual.phi[CYCLIC])
    for signs in signs_in(usual.q.dtype, FLIPS):
        flipped = run_rates(bundle, q * scalar_and(signs), rates * signs, before * signs)
        assert same(flipped.phi, usual.phi * signs)
        assert same(flipped.r, usual.r * scalar_and(signs))
        assert same(flipped.q, usual.q * scalar_and(signs))


@pytest.mark.parametrize("name", RATES)
def test_a_rate_design_makes_of_its_increments_the_phi_of_the_increment_design(name: str) -> None:
    """So time reversal and constant rate hold for it as far as they can: about increments, turned into body axes."""
    bundle = shipped(name)
    rates, before = body_rates(bundle, 12)
    run = run_rates(bundle, one(bundle), rates, before)
    dtheta = np.array([run.vector(f"theta{i + 1}") for i in range(len(rates))])
    dtheta = body(bundle, dtheta)
    twin = shipped(name.replace("_rate_", "_"))
    assert twin.facts.algorithm.name == bundle.facts.algorithm.name
    assert same(Run(twin, one(twin), dtheta, np.empty(0)).phi, run.phi)
    assert np.abs(run.phi).max() > 0.01


@pytest.mark.parametrize("name", RATES)
def test_rates_themselves_are_not_symmetric_in_time_to_the_last_bit(name: str) -> None:
    bundle = shipped(name)
    rates, before = body_rates(bundle, 13)
    stream = np.array([before, *rates])
    usual, back = run_rates(bundle, one(bundle), rates, before), -stream[::-1]
    reversed_run = run_rates(bundle, one(bundle), back[1:], back[0])
    assert not same(reversed_run.phi, -usual.phi)
    np.testing.assert_allclose(reversed_run.phi, -usual.phi, atol=1e-6 * float(np.abs(usual.phi).max()))
