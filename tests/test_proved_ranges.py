"""What is proved of a fixed-point design holds: no value leaves its bound, no partial sum its accumulator.

Inputs are random and corners of the declared range, chained and from restarts; then any state that is said to be
possible, the attitude's length at the ends of its range and the carried roundings at theirs. With --rows N the
flagships are run on so many rows each, 100,000 at a time:

    pytest tests/test_proved_ranges.py -k flagship --rows 10000000
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from fixed_designs import ACCUMULATIONS, CATALOGUE, FLAGSHIP, fixed, made
from qcone.backends.bittrue import State, new_state
from qcone.bundle import Bundle
from qcone.ir.detail import Mac
from qcone.ir.statement import Operation, Routine
from watching import Seen, Watched, drawn, watch

Array = NDArray[Any]
ROWS = 100_000
OUTPUTS = {"outputs": "quaternion,dcm,euler"}
STATES = [name for name in CATALOGUE if "rotation-vector" in name or "picard" in name]
LANES = 20_000


@pytest.mark.parametrize("name", CATALOGUE)
def test_no_value_leaves_its_proved_range(name: str) -> None:
    bundle = fixed(name)
    for seen in watch(bundle, drawn(bundle, ROWS if CATALOGUE[name][0] == FLAGSHIP else ROWS // 5)):
        assert list(seen.beyond()) == []


@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
@pytest.mark.parametrize("number", ["fixed32", "fixed16"])
def test_no_value_of_a_flagship_leaves_its_proved_range(number: str, accumulate: str, rows: int | None) -> None:
    """With its matrix and its angles; as many rows as are asked for."""
    bundle = made(FLAGSHIP, number, accumulate, **OUTPUTS)
    for seed in range(max(1, (rows or ROWS // 5) // ROWS)):
        for seen in watch(bundle, drawn(bundle, min(rows or ROWS // 5, ROWS), 100 + seed)):
            assert list(seen.beyond()) == []


@pytest.mark.parametrize("euler", ["zyx", "zxy"])
def test_no_angle_leaves_its_proved_range(euler: str) -> None:
    bundle = made(FLAGSHIP, "fixed32", "delta", **OUTPUTS, euler=euler)
    for seen in watch(bundle, drawn(bundle, ROWS // 5, 5)):
        assert list(seen.beyond()) == []


# -- any state that is said to be possible ----------------------------------------------------------------


def carried(bundle: Bundle) -> dict[int, int]:
    """Return how many bits are rounded away into each component of the residual."""
    assert bundle.macs is not None
    macs = [each.detail for routine in bundle.macs.routines for each in _operations(routine)]
    return {mac.residual[1].constant: mac.discard for mac in macs if isinstance(mac, Mac) and mac.residual is not None}


def _operations(routine: Routine) -> list[Operation]:
    return [each for each in routine.body if isinstance(each, Operation)]


def any_state(bundle: Bundle, previous: Array, seed: int) -> State:
    """Return states with |q| within 1 +- spread and at its ends, any residual, and a full history."""
    generator = np.random.default_rng(seed)
    state = new_state(bundle.machine, bundle.facts.number, LANES)
    assert bundle.facts.proved is not None
    spread, signal = float(bundle.facts.proved.spread), bundle.machine.state[0].format
    assert signal is not None
    length = 1 + spread * generator.choice([-1.0, 1.0, 0.0, *generator.uniform(-1, 1, 5)], LANES)
    q = generator.standard_normal((4, LANES))
    q[:, : LANES // 4] = np.sign(q[:, : LANES // 4])  # all alike, or along an axis
    q[:, LANES // 4 : LANES // 2] = np.eye(4)[generator.integers(4, size=LANES // 4)].T
    # Half a last bit of a component, kept clear of the ends.
    q *= (length + np.sign(1 - length) * 2 * float(signal.lsb)) / np.linalg.norm(q, axis=0)
    state["q"][:] = np.rint(np.ldexp(q, signal.fraction)).astype(np.int64)
    for component, bits in carried(bundle).items():
        half = 1 << (bits - 1)
        ends = generator.choice([-half, half - 1, 0], LANES)
        inside = generator.integers(-half, half, LANES)
        state["residual"][component] = np.where(generator.random(LANES) < 0.5, ends, inside)
    if "previous" in state:
        state["previous"][:] = previous
        state["count"][:] = bundle.facts.algorithm.previous
    return state


def length(bundle: Bundle, state: State) -> Array:
    signal = bundle.machine.state[0].format
    assert signal is not None
    norms: Array = np.linalg.norm(np.ldexp(state["q"].astype(np.float64), -signal.fraction), axis=0)
    return norms


@pytest.mark.parametrize("name", STATES)
def test_updates_keep_the_attitude_within_its_proved_range_from_any_state(name: str) -> None:
    bundle = fixed(name)
    assert bundle.macs is not None
    assert bundle.facts.proved is not None
    previous = bundle.facts.algorithm.previous
    stream = drawn(bundle, 8 * LANES, 7, LANES).inputs
    state = any_state(bundle, stream[:, previous - 1 :: -1][:, :previous].reshape(LANES, -1).T, 9)
    before = length(bundle, state)
    spread = float(bundle.facts.proved.spread)
    assert before.min() == pytest.approx(1 - spread, abs=1e-3 * spread + 4e-4)
    assert before.max() == pytest.approx(1 + spread, abs=1e-3 * spread + 4e-4)
    for program in (bundle.macs, bundle.machine):
        copy = {name: words.copy() for name, words in state.items()}
        model = Watched(bundle, program)
        model.run("update", copy, {"dtheta": stream[:, previous].T})
        assert list(model.seen.beyond()) == []
    assert np.abs(length(bundle, copy) - 1).max() <= spread
    for component, bits in carried(bundle).items():
        assert np.abs(copy["residual"][component]).max() <= 1 << (bits - 1)


# -- the checks themselves ----------------------------------------------------------------------------------


@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
def test_the_flagship_comes_near_its_bounds(accumulate: str) -> None:
    """A bound that nothing comes near would be no test: the rotation vector reaches nine tenths of its own."""
    bundle = fixed(f"{FLAGSHIP} fixed32 {accumulate}")
    seen, _ = watch(bundle, drawn(bundle, ROWS))
    assert bundle.macs is not None
    update = bundle.macs.routine("update")
    shares = {
        update.names[each.result]: seen.values["update", each.result] * each.format.lsb / each.bound  # type: ignore
        for each in _operations(update)
        if each.bound and each.result in update.names
    }
    for name in ("dtheta1_x", "phi_x", "v_x", "phi_square"):
        assert shares[name] > 0.9, shares


@pytest.mark.parametrize(("factor", "said"), [(2, "is beyond 0.0"), (20, "is beyond an accumulator of")])
def test_inputs_beyond_the_declared_range_are_noticed(factor: int, said: str) -> None:
    bundle = fixed(f"{FLAGSHIP} fixed32 delta")
    wide = drawn(bundle, 2000, lanes=200)
    model, state = Watched(bundle), any_state(bundle, np.empty(0), 3)
    few = {name: words[:, :200] for name, words in state.items()}
    model.run("update", few, {"dtheta": wide.inputs[:, 0].T.astype(np.int64) * factor})
    assert any(said in each for each in model.seen.beyond())


def test_a_bound_that_is_too_low_is_noticed() -> None:
    bundle = fixed(f"{FLAGSHIP} fixed32 delta")
    seen, _ = watch(bundle, drawn(bundle, 2000))
    update = seen.program.routine("update")
    for k, each in enumerate(update.body):
        if isinstance(each, Operation) and each.bound and seen.values["update", each.result]:
            reached = seen.values["update", each.result] * each.format.lsb  # type: ignore[union-attr]
            lower = (*update.body[:k], replace(each, bound=reached * 999 / 1000), *update.body[k + 1 :])
            routines = tuple(
                routine if routine.name != "update" else update.with_body(lower) for routine in seen.program.routines
            )
            told = list(Seen(replace(seen.program, routines=routines), seen.values, seen.partial).beyond())
            assert len(told) == 1
            assert told[0].startswith(f"update: value {each.result} ")
