"""Symmetries to the last bit of updates that go through no phi: of the attitude after one update.

flip           turning the body axes by 180 degrees about one of them turns the attitude with them
time-reversal  theta_i -> -theta_(N+1-i) gives, from the identity, the inverse attitude
cyclic         permuting the axes permutes the attitude: a sum of three products depends on their order, and of a
               matrix two rows are carried on, so that only Runge-Kutta on three rows has it

Turns are of the order of a radian, where no digit of a small term is lost beside 1. Bits are compared, but for
the sign of zeros. A property that is not claimed must fail: no claim is missing.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from qcone.assembly import assemble
from qcone.formats.floating import FLOATING
from qcone.ir.evaluate import Numbers, evaluate
from qcone.ir.writing import AS_WRITTEN, Writing
from qcone.registry import algorithm_of
from qcone.vectors import in_form
from shipped import WITHOUT_PHI, design_of
from symmetry import CYCLIC, FLIPS, ROWS, Array, attitudes, same, samples, signs_in

IDENTITY = np.array([[1.0], [0.0], [0.0], [0.0]]).repeat(ROWS, 1)
HELD = {"quaternion": "q", "dcm": "c"}
ATTITUDES = [name for name in WITHOUT_PHI if not name.startswith("euler")]
"""Euler angles claim nothing: their axes are not alike."""


def after_one_update(example: str, form: str, number: str) -> Callable[[Array, Array], Array]:
    """Return the attitude as the routine of that form calculates it from the one before and samples (count, 3, rows).

    Attitudes are (4, rows) or (9, rows).
    """
    design = design_of(example, number=number)
    algorithm = algorithm_of(design)
    program = assemble(algorithm, design, AS_WRITTEN if form == "as-written" else Writing())
    routine = program.routine("start_up" if program.has("start_up") else "update")
    chosen, kind, held = FLOATING[number], np.dtype(number).type, HELD[algorithm.state]
    numbers = Numbers(lambda exact: kind(float(chosen.round(exact))))

    def attitude(start: Array, given: Array) -> Array:
        inputs: dict[str, list[Array]] = {held: [*start]}
        if algorithm.takes == "omega":
            inputs["omega_last"], inputs["omega"] = [*given[0]], [*given[1:].reshape(-1, ROWS)]
        else:
            inputs["dtheta"] = [*given.reshape(-1, ROWS)]
        for block in algorithm.memory:
            inputs[block.name] = [np.zeros(ROWS, kind)] * block.size
        with np.errstate(all="ignore"):
            blocks = evaluate(routine, {**inputs, "count": [2]}, numbers).blocks
        return np.array([np.broadcast_to(value, ROWS) for value in blocks[held]])

    return attitude


def flipped(attitude: Array, signs: Array) -> Array:
    """Turn the axes of an attitude: signs (3, 1) of the axes."""
    if len(attitude) == 4:
        return np.concatenate([attitude[:1], attitude[1:] * signs])
    return (attitude.reshape(3, 3, -1) * signs[:, None] * signs[None]).reshape(9, -1)


def permuted(attitude: Array) -> Array:
    if len(attitude) == 4:
        return attitude[[0, *(1 + k for k in CYCLIC)]]
    return attitude.reshape(3, 3, -1)[CYCLIC][:, CYCLIC].reshape(9, -1)


def inverse(attitude: Array) -> Array:
    if len(attitude) == 4:
        return np.concatenate([attitude[:1], -attitude[1:]])
    return attitude.reshape(3, 3, -1).swapaxes(0, 1).reshape(9, -1)


@pytest.mark.parametrize(
    ("form", "number"), [("as-written", "float64"), ("factored", "float32"), ("factored", "float64")]
)
@pytest.mark.parametrize("example", ATTITUDES)
def test_a_form_has_the_properties_it_claims_and_no_others(example: str, form: str, number: str) -> None:
    algorithm = algorithm_of(design_of(example))
    attitude = after_one_update(example, form, number)
    rates = algorithm.takes == "omega"
    given = samples(algorithm.subsamples + rates, number, 31) * (3000 if rates else 30)
    start, identity = (in_form(q.T, f"set_{algorithm.state}").T.copy() for q in (attitudes(number), IDENTITY))
    usual, found = attitude(start, given), set()
    assert np.abs(usual - start).max() > 0.3
    if same(attitude(permuted(start), given[:, CYCLIC]), permuted(usual)):
        found.add("cyclic")
    if all(
        same(attitude(flipped(start, signs), given * signs), flipped(usual, signs))
        for signs in signs_in(given.dtype, FLIPS)
    ):
        found.add("flip")
    identity = identity.astype(number)
    if same(attitude(identity, -given[::-1]), inverse(attitude(identity, given))):
        found.add("time-reversal")
    assert found == algorithm.claims(form)


def test_what_is_claimed() -> None:
    """Every attitude turns with its axes; Euler angles claim nothing, their axes are not alike."""
    for example in ATTITUDES:
        algorithm = algorithm_of(design_of(example))
        assert algorithm.claims("factored") == {"flip"}
        three_rows = example == "runge-kutta-4 attitude=dcm"
        assert algorithm.claims("as-written") == ({"cyclic", "flip"} if three_rows else {"flip"})
    assert algorithm_of(design_of("euler-angles")).claims("factored") == frozenset()
