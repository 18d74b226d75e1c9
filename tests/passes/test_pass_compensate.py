"""Compensated accumulation: nothing but rounding is carried, and what is carried is all of it."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import numpy as np
import pytest

from qcone.assembly import assemble, writing_of
from qcone.backends.bittrue import Model, new_state
from qcone.bundle import Bundle
from qcone.design import Design, design_from_options
from qcone.ir.check import check_program
from qcone.ir.evaluate import evaluate
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Program, Routine, Write, walk
from qcone.ir.writing import Series
from qcone.passes.compensate import compensate
from qcone.pipeline import build
from qcone.registry import algorithm_of, entries

F = Fraction
SERIES = Series((F(-1, 8), F(1, 384)), (F(-1, 48), F(1, 3840)))


def design(accumulate: str = "compensated", number: str = "float32", **options: str) -> Design:
    base = {"algorithm": "rotation-vector", "subsamples": "3", "update_hz": "100", "max_rate_dps": "573"}
    outputs = {"outputs": "quaternion,dcm", "number": number, "accumulate": accumulate}
    return design_from_options("carried", {**base, **outputs, **options}, entries())


@cache
def programs() -> tuple[Program, Program]:
    """Return the program with plain and with compensated accumulation, in the real language."""
    chosen = design(renormalise="separate")
    plain = assemble(algorithm_of(chosen), chosen, writing_of(chosen, SERIES))
    return plain, check_program(compensate(plain), RealOp)


Q = [F(4, 5), F(1, 7), F(-2, 9), F(3, 11)]
DTHETA = [F(k * k % 23 - 11, 400) for k in range(1, 10)]
C = [F(1, 10**6), F(-2, 10**6), F(3, 10**7), F(-5, 10**8)]


def test_the_residual_stays_zero_over_fractions() -> None:
    plain, carried = programs()
    expected = evaluate(plain.routine("update"), {"q": Q, "dtheta": DTHETA}).blocks["q"]
    found = evaluate(carried.routine("update"), {"q": Q, "dtheta": DTHETA, "residual": [F(0)] * 4}).blocks
    assert found["q"] == expected
    assert found["residual"] == [0, 0, 0, 0]


def test_a_residual_is_paid_back_over_fractions() -> None:
    """q' = q + (dq - c) exactly, and nothing is left over."""
    plain, carried = programs()
    expected = evaluate(plain.routine("update"), {"q": Q, "dtheta": DTHETA}).blocks["q"]
    found = evaluate(carried.routine("update"), {"q": Q, "dtheta": DTHETA, "residual": C}).blocks
    assert found["q"] == [value - c for value, c in zip(expected, C, strict=True)]
    assert found["residual"] == [0, 0, 0, 0]


@pytest.mark.parametrize("name", ["quaternion", "dcm"])
def test_what_is_reported_is_q_less_the_residual(name: str) -> None:
    plain, carried = programs()
    whole = [value - c for value, c in zip(Q, C, strict=True)]
    output = {"quaternion": "q_nb", "dcm": "c_nb"}[name]
    expected = evaluate(plain.routine(name), {"q": whole}).blocks[output]
    assert evaluate(carried.routine(name), {"q": Q, "residual": C}).blocks[output] == expected


@pytest.mark.parametrize(("name", "inputs"), [("init", {}), ("set_quaternion", {"q_nb": Q})])
def test_setting_the_attitude_clears_the_residual(name: str, inputs: dict[str, list[Fraction]]) -> None:
    plain, carried = programs()
    found = evaluate(carried.routine(name), {"q": Q, "residual": C, **inputs}).blocks
    assert found["residual"] == [0, 0, 0, 0]
    assert found["q"] == evaluate(plain.routine(name), {"q": Q, **inputs}).blocks["q"]


def added(routine: Routine, other: Routine) -> int:
    sizes = [
        sum(isinstance(each, Operation) and each.op is not RealOp.READ for each in walk(r.body))
        for r in (routine, other)
    ]
    return sizes[0] - sizes[1]


def test_what_it_costs() -> None:
    """Three subtractions a component in an update, one where it is reported; no product anywhere."""
    plain, carried = programs()
    assert added(carried.routine("update"), plain.routine("update")) == 12
    assert added(carried.routine("quaternion"), plain.routine("quaternion")) == 4
    assert added(carried.routine("dcm"), plain.routine("dcm")) == 4


def test_the_residual_is_part_of_the_state_and_is_stored_last() -> None:
    _, carried = programs()
    assert [block.name for block in carried.state] == ["q", "residual"]
    writes = [each.place.block for each in carried.routine("update").body if isinstance(each, Write)]
    assert writes == ["q"] * 4 + ["residual"] * 4
    assert not any(
        isinstance(each, Operation) and each.op is RealOp.ACCUMULATE for each in carried.routine("update").body
    )


def test_the_steps_are_named() -> None:
    update = programs()[1].routine("update")
    assert "y = increment - c, next = now + y, c_next = (next - now) - y, c the residual" in [
        each.text for each in update.steps
    ]
    assert {"residual_w", "y_x", "gained_y", "residual_next_z"} <= set(update.names.values())


@pytest.mark.parametrize("number", ["float32", "float64"])
def test_in_floating_point_it_loses_less(number: str) -> None:
    """Slow constant rotations for 1,000 updates: the rounding does not pile up where it is carried."""
    lanes, updates = 32, 1000
    rate = 1e-4 * np.random.default_rng(2).standard_normal((3, lanes)).astype(number)

    def drift(accumulate: str) -> float:
        bundle: Bundle = build(design(accumulate, number))
        model, state = Model(bundle.machine, bundle.facts.number), new_state(bundle.machine, bundle.facts.number, lanes)
        model.run("init", state)
        for _ in range(updates):
            model.run("update", state, {"dtheta": np.tile(rate, (3, 1))})
        angle = 3 * updates * rate.astype(np.longdouble)
        size = np.sqrt((angle * angle).sum(axis=0))
        truth = np.array([np.cos(size / 2), *(np.sin(size / 2) * angle / size)])
        return float(np.abs(model.run("quaternion", state)["q_nb"] - truth).max())

    plain, carried = drift("delta"), drift("compensated")
    assert carried < plain / 4
    assert carried < 4 * float(np.finfo(number).eps)
