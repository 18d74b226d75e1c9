"""The bit-true model is the routine, operation by operation, in the format's own type."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import written

from qcone.backends.bittrue import ARITHMETIC, DTYPES, Model, dtype_of, new_state
from qcone.backends.bittrue_fixed import OPERATIONS
from qcone.bundle import Bundle
from qcone.formats.fixed import WIDTHS
from qcone.formats.floating import FLOATING
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Role
from shipped import DESIGNS, shipped

NAME = "rotation_vector_3_coning_float32"
HISTORY = "rotation_vector_1_previous_2_float32"


def model_of(bundle: Bundle) -> Model:
    return Model(bundle.machine, bundle.facts.number)


def inputs_of(bundle: Bundle, lanes: int, seed: int = 5) -> dict[str, np.ndarray]:
    block = bundle.machine.routine("update").having(Role.INPUT)[0]
    values = np.random.default_rng(seed).uniform(-0.03, 0.03, (block.size, lanes))
    return {block.name: values.astype(dtype_of(bundle.facts.number))}


def test_every_format_has_its_type() -> None:
    assert set(DTYPES) == {*FLOATING, *WIDTHS}
    assert [np.dtype(DTYPES[name]).itemsize for name in ("float32", "float64", *WIDTHS)] == [4, 8, 8, 8]


def test_every_machine_operation_has_a_meaning() -> None:
    known = {*ARITHMETIC, *OPERATIONS, MachineOp.LITERAL, MachineOp.READ}
    assert known == set(MachineOp)


@pytest.mark.parametrize("name", DESIGNS)
def test_lanes_are_independent_and_keep_the_type(name: str) -> None:
    """Seven runs at once are seven runs one by one."""
    bundle = shipped(name)
    model, dtype = model_of(bundle), dtype_of(bundle.facts.number)
    together = new_state(bundle.machine, bundle.facts.number, 7)
    model.run("init", together)
    steps = [inputs_of(bundle, 7, seed) for seed in range(4)]
    for given in steps:
        model.run("update", together, given)
    assert together[bundle.machine.state[0].name].dtype == dtype
    for lane in range(7):
        alone = new_state(bundle.machine, bundle.facts.number, 1)
        model.run("init", alone)
        for given in steps:
            model.run("update", alone, {block: values[:, lane : lane + 1] for block, values in given.items()})
        for block, values in together.items():
            assert values[:, lane].tobytes() == alone[block][:, 0].tobytes(), block


def test_lanes_of_different_age_take_their_own_routine() -> None:
    """A counter chooses for each lane: one lane restarts, the others go on with their history."""
    bundle = shipped(HISTORY)
    model, number = model_of(bundle), bundle.facts.number
    mixed = new_state(bundle.machine, number, 2)
    mixed["count"][:] = [[0, 2]]
    mixed["q"][0] = 1
    mixed["previous"][:] = np.float32(0.02)
    alone = [{block: values[:, lane : lane + 1].copy() for block, values in mixed.items()} for lane in range(2)]
    given = inputs_of(bundle, 2)
    model.run("update", mixed, given)
    for lane, routine in enumerate(("start_up", "steady")):
        model.run(routine, alone[lane], {block: values[:, lane : lane + 1] for block, values in given.items()})
        for block, values in mixed.items():
            assert values[:, lane].tobytes() == alone[lane][block][:, 0].tobytes(), f"{routine}: {block}"
    assert mixed["count"].dtype == np.int32
    assert mixed["count"].tolist() == [[1, 2]]


def test_each_operation_is_rounded_by_itself() -> None:
    """The named values of a run are, each, the exact operation on its operands rounded once to the format."""
    bundle = shipped(NAME)
    state, watch = new_state(bundle.machine, bundle.facts.number, 1), {}
    model = model_of(bundle)
    model.run("init", state)
    model.run("update", state, inputs_of(bundle, 1))
    before = state["q"].copy()
    model.run("update", state, inputs_of(bundle, 1, seed=6), watch)
    exact = {name: Fraction(float(np.ravel(value)[0])) for name, value in watch.items()}
    number = bundle.facts.number
    product = exact["coning_x_1"]
    assert product == number.round(exact["g_y"] * exact["k_z"])
    assert product != exact["g_y"] * exact["k_z"], "a product that needed no rounding shows nothing"
    assert exact["coning_x"] == number.round(exact["coning_x_1"] - exact["coning_x_2"])
    assert exact["q_w"] == Fraction(float(before[0, 0]))


def test_inputs_and_outputs_are_not_the_state_itself() -> None:
    """What is read before a write keeps its value; what is given back does not change later."""
    bundle = shipped(NAME)
    model, state = model_of(bundle), new_state(bundle.machine, bundle.facts.number, 2)
    model.run("init", state)
    (attitude,) = model.run("quaternion", state).values()
    kept = attitude.copy()
    given = inputs_of(bundle, 2)
    untouched = given["dtheta"].copy()
    model.run("update", state, given)
    assert attitude.tobytes() == kept.tobytes()
    assert given["dtheta"].tobytes() == untouched.tobytes()
    assert state["q"].tobytes() != kept.tobytes()


@pytest.mark.parametrize("number", ["float32", "float64"])
def test_rolled_and_written_out_give_the_same_bits(tmp_path: Path, number: str) -> None:
    results = []
    for loop in ("rolled", "unrolled"):
        bundle = written.bundle(tmp_path, loop, number)
        model, state = model_of(bundle), new_state(bundle.machine, bundle.facts.number, 50)
        model.run("init", state)
        for seed in range(3):
            model.run("update", state, inputs_of(bundle, 50, seed))
        results.append(state["q"].tobytes())
    assert results[0] == results[1]
