"""Symmetries of fixed point to the last bit: sums are exact until they are rounded, so their order does not show.

cyclic         permuting the body axes cyclically permutes phi, r and q, which floats cannot promise of r and q
flip           turning the body axes by 180 degrees about one of them flips phi, r and q: with rounding = "even" and
               nothing carried, for halves that go up are not symmetric
time-reversal  theta_i -> -theta_(N+1-i) negates phi and conjugates r, where the form claims it; likewise
constant-rate  equal increments give phi = S, rounded once: for every form, since what cancels cancels exactly
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from fixed_designs import ACCUMULATIONS, FLAGSHIP, SMOOTH, made
from qcone.backends.bittrue_fixed import rounded
from qcone.bundle import Bundle
from qcone.formats.fixed import WIDTHS, Signal
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation, Role, walk
from shipped import DESIGNS, THROUGH_PHI, WITH_PHI, shipped
from symmetry import CYCLIC, FLIPS, ROWS, Run, attitudes, holding, same, scalar_and, signs_in
from watching import drawn

Array = NDArray[Any]
NEIGHBOURS = ("subsamples=2 coefficients=e", "subsamples=2 coefficients=t", "subsamples=5", "previous=2", "previous=4")
"""What differs from another form in weights or in a number alone."""
CHOSEN = [example for example in WITH_PHI if not any(each in example for each in NEIGHBOURS)]
FORMS = [
    (example, number, ACCUMULATIONS[k % 3])
    for k, example in enumerate(CHOSEN)
    for number in ("fixed32", "fixed16")
    if number == "fixed32" or (example.startswith("rotation") and k % 4 == 1)
]
EACH_FORM = pytest.mark.parametrize(("example", "number", "accumulate"), FORMS)
PERMUTED = [0, *(1 + k for k in CYCLIC)]
OTHERS = ["quaternion-taylor subsamples=1 order=10 about=midpoint", "runge-kutta-4 attitude=quaternion"]


def vectors(bundle: Bundle, count: int, seed: int) -> Array:
    """Return words of samples (count, 3, ROWS), inside the declared range and at its corners."""
    if not count:
        return np.empty((0, 3, ROWS), np.int64)
    rows = drawn(bundle, 4 * ROWS * count, seed, ROWS).inputs.reshape(ROWS, -1, 3)
    return np.moveaxis(rows[:, :count], 0, 2).astype(np.int64)


def samples(bundle: Bundle, seed: int) -> tuple[Array, Array]:
    algorithm = bundle.facts.algorithm
    return vectors(bundle, algorithm.subsamples, seed), vectors(bundle, algorithm.previous, seed + 1)


def start(bundle: Bundle) -> Array:
    """Return attitudes (4, ROWS) as words."""
    given = bundle.machine.routine("set_quaternion").having(Role.INPUT)[0].format
    assert given is not None
    return np.rint(np.ldexp(attitudes(np.float64), given.fraction)).astype(np.int64)


def fractions(bundle: Bundle) -> dict[str, int]:
    """Return the fraction bits of every named value of the update."""
    update = bundle.machine.routine("steady" if bundle.machine.has("steady") else "update")
    return {
        update.names[each.result]: each.format.fraction
        for each in update.body
        if isinstance(each, Operation) and isinstance(each.format, Signal) and each.result in update.names
    }


def phi_of(bundle: Bundle, dtheta: Array, previous: Array) -> Array:
    return Run(bundle, start(bundle), dtheta, previous).phi


def properties(bundle: Bundle, seed: int) -> set[str]:
    """Return which properties phi has."""
    bits = fractions(bundle)
    given = next(bits[name] for name in ("dtheta_x", "dtheta1_x") if name in bits)
    dropped = given - bits.get("phi_x", given)

    def total(dtheta: Array) -> Array:
        whole = dtheta.sum(0)
        return rounded(whole, dropped, bundle.facts.number.rounding) if dropped >= 0 else whole << -dropped

    dtheta, previous = samples(bundle, seed)
    return holding(lambda d, p: phi_of(bundle, d, p), dtheta, previous, total)


@EACH_FORM
def test_phi_has_what_its_form_claims_and_is_exact_at_a_constant_rate(
    example: str, number: str, accumulate: str
) -> None:
    bundle = made(example, number, accumulate, rounding="even")
    claimed = bundle.facts.algorithm.claims("factored") | {"constant-rate"}
    assert properties(bundle, 1) == claimed


@EACH_FORM
def test_permuting_the_axes_permutes_r_and_q(example: str, number: str, accumulate: str) -> None:
    bundle = made(example, number, accumulate, rounding="even")
    (dtheta, previous), q = samples(bundle, 3), start(bundle)
    usual = Run(bundle, q, dtheta, previous)
    turned = Run(bundle, q[PERMUTED], dtheta[:, CYCLIC], previous[:, CYCLIC])
    assert same(turned.q, usual.q[PERMUTED])
    if has_r(usual):
        assert same(turned.r, usual.r[PERMUTED])
    if "residual" in fields(bundle) and not usual.residual.shape[0] % 3:
        pairs = usual.residual.reshape(-1, 3, ROWS)
        assert same(turned.residual.reshape(-1, 3, ROWS), pairs[:, CYCLIC])


def fields(bundle: Bundle) -> list[str]:
    return [block.name for block in bundle.machine.state]


def has_r(run: Run) -> bool:
    """Tell whether the update has a vector part of r: at order 1 and 2 of Picard's it goes into q at once."""
    return any(name.startswith(("v_x", "r_x")) for name in run.named)


@EACH_FORM
def test_flipping_the_axes_flips_r_and_q_rounded_to_even(example: str, number: str, accumulate: str) -> None:
    bundle = made(example, number, accumulate, rounding="even")
    (dtheta, previous), q = samples(bundle, 5), start(bundle)
    usual = Run(bundle, q, dtheta, previous)
    for signs in signs_in(np.int64, FLIPS):
        flipped = Run(bundle, q * scalar_and(signs), dtheta * signs, previous * signs)
        assert same(flipped.q, usual.q * scalar_and(signs))
        if has_r(usual):
            assert same(flipped.r, usual.r * scalar_and(signs))


@EACH_FORM
def test_reversing_time_conjugates_r_rounded_to_even_where_it_is_claimed(
    example: str, number: str, accumulate: str
) -> None:
    bundle = made(example, number, accumulate, rounding="even")
    (dtheta, previous), q = samples(bundle, 7), start(bundle)
    usual, back = Run(bundle, q, dtheta, previous), Run(bundle, q, -dtheta[::-1], -previous)
    if has_r(usual):
        conjugated = same(back.r, usual.r * np.array([[1], [-1], [-1], [-1]]))
        assert conjugated is ("time-reversal" in bundle.facts.algorithm.claims("factored"))


@pytest.mark.parametrize("number", ["fixed32", "fixed16"])
@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
def test_halves_that_go_up_are_not_symmetric(accumulate: str, number: str) -> None:
    """So the flip and the reversal of time are claimed of rounding to even alone; the cyclic one is of both."""
    bundle = made(FLAGSHIP, number, accumulate)
    dtheta, previous = samples(bundle, 9)
    assert properties(bundle, 9) >= {"cyclic", "constant-rate"}
    usual = Run(bundle, start(bundle), dtheta, previous)
    (signs, *_) = signs_in(np.int64, FLIPS)
    flipped = Run(bundle, start(bundle) * scalar_and(signs), dtheta * signs, previous)
    assert not same(flipped.r, usual.r * scalar_and(signs))
    assert np.abs(flipped.r - usual.r * scalar_and(signs)).max() <= 2


@pytest.mark.parametrize("example", OTHERS)
@pytest.mark.parametrize("accumulate", ["delta", "standard"])
def test_an_update_that_goes_through_no_phi_turns_with_its_axes(example: str, accumulate: str) -> None:
    """Flipped, and permuted too: in floats a sum of three products depends on their order."""
    bundle = made(example, "fixed32", accumulate, rounding="even", **SMOOTH)
    rates, q = bundle.facts.algorithm.takes == "omega", start(bundle)
    words = vectors(bundle, bundle.facts.algorithm.subsamples, 11)
    before = words[0] if rates else None
    none = np.empty((0, 3, ROWS), np.int64)
    usual = Run(bundle, q, words, none, before)
    assert not same(usual.q, q)
    turned = Run(bundle, q[PERMUTED], words[:, CYCLIC], none, None if before is None else before[CYCLIC])
    assert same(turned.q, usual.q[PERMUTED])
    for signs in signs_in(np.int64, FLIPS):
        flipped = Run(bundle, q * scalar_and(signs), words * signs, none, None if before is None else before * signs)
        assert same(flipped.q, usual.q * scalar_and(signs))


# -- the shipped designs -----------------------------------------------------------------------------------

SHIPPED = [name for name, design in DESIGNS.items() if design.number.format in WIDTHS]
THROUGH_INCREMENTS = [
    name for name in SHIPPED if DESIGNS[name].algorithm in THROUGH_PHI and DESIGNS[name].input == "increment"
]


def test_a_design_that_rounds_to_even_is_shipped() -> None:
    assert any(DESIGNS[name].number.rounding == "even" for name in THROUGH_INCREMENTS)


@pytest.mark.parametrize("name", THROUGH_INCREMENTS)
def test_a_shipped_design_has_the_symmetries_of_fixed_point(name: str) -> None:
    bundle = shipped(name)
    found, claimed = properties(bundle, 21), bundle.facts.algorithm.claims("factored") | {"constant-rate"}
    if DESIGNS[name].number.rounding == "even":
        assert found == claimed
    else:
        assert {"cyclic", "constant-rate"} <= found <= claimed
    (dtheta, previous), q = samples(bundle, 23), start(bundle)
    usual = Run(bundle, q, dtheta, previous)
    turned = Run(bundle, q[PERMUTED], dtheta[:, CYCLIC], previous[:, CYCLIC])
    assert same(turned.q, usual.q[PERMUTED])


@pytest.mark.parametrize("name", SHIPPED)
def test_the_constants_of_a_shipped_design_are_rounded_once(name: str) -> None:
    """As factors of products and as words; limbs cut them afterwards, without rounding."""
    bundle = shipped(name)
    assert bundle.macs is not None
    seen = 0
    for routine in (bundle.macs if "limbs" in DESIGNS[name].multiply else bundle.machine).routines:
        for each in walk(routine.body):
            if isinstance(each, Operation) and each.op is MachineOp.LITERAL and isinstance(each.format, Signal):
                assert each.constant is not None
                assert each.exact is not None
                error = each.constant - each.exact
                assert -each.format.lsb / 2 < error <= each.format.lsb / 2
                seen += 1
    assert seen > 3
