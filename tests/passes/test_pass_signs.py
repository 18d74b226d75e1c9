"""Signs go where they cost nothing, and every signed permutation of the axes is free."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from itertools import permutations, product
from typing import Any

import numpy as np
import pytest
from real_routines import F, operations, written

from qcone.backends.bittrue import Model, dtype_of, new_state
from qcone.backends.counts import Counts
from qcone.bundle import Bundle
from qcone.design import design_from_options
from qcone.ir.blocks import cross, dot, sqrt
from qcone.ir.check import check
from qcone.ir.evaluate import agree, evaluate
from qcone.ir.indexed import history, loop
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation
from qcone.ir.subroutine import subroutine
from qcone.passes.signs import signs
from qcone.passes.sweep import sweep
from qcone.pipeline import build
from qcone.registry import entries

ABSORBED: list[tuple[Callable[[Any, Any, Any], Any], dict[str, int]]] = [
    (lambda v, x, s: x + -s, {"subtract": 1}),
    (lambda v, x, s: x - -s, {"add": 1}),
    (lambda v, x, s: -x + s, {"subtract": 1}),
    (lambda v, x, s: x * -s + x, {"multiply": 1, "subtract": 1}),
    (lambda v, x, s: x - -s * x, {"multiply": 1, "add": 1}),
    (lambda v, x, s: -x * -s, {"multiply": 1}),
    (lambda v, x, s: -x / -s, {"divide": 1}),
    (lambda v, x, s: x + -x / s, {"divide": 1, "subtract": 1}),
    (lambda v, x, s: (-x).__neg__(), {}),
    (lambda v, x, s: (-x - s) + x, {"add": 1, "subtract": 1}),
    (lambda v, x, s: (-x + -s) * -s, {"add": 1, "multiply": 1}),
    (lambda v, x, s: x - (-(F(1, 3) * -s)) * (-x), {"multiply": 2, "add": 1}),
    (lambda v, x, s: cross(-v, -v + v), {"multiply": 6, "subtract": 6}),
    (lambda v, x, s: dot(-v, -v) + x, {"multiply": 3, "add": 3}),
]
KEPT: list[tuple[Callable[[Any, Any, Any], Any], dict[str, int]]] = [
    (lambda v, x, s: -x, {"negate": 1}),
    (lambda v, x, s: -x - s, {"add": 1, "negate": 1}),
    (lambda v, x, s: -(x * s), {"multiply": 1, "negate": 1}),
    (lambda v, x, s: -x * s, {"multiply": 1, "negate": 1}),
    (lambda v, x, s: sqrt(-x), {"square_root": 1, "negate": 1}),
    (lambda v, x, s: sqrt(-x) + sqrt(-x), {"square_root": 2, "add": 1, "negate": 2}),
]


@pytest.mark.parametrize(("author", "left"), ABSORBED + KEPT)
def test_operations_left(author: Callable[[Any, Any, Any], Any], left: dict[str, int]) -> None:
    routine = written(author)
    signed = check(sweep(signs(routine)), RealOp)
    assert operations(signed) == left
    assert agree(routine, signed)


def test_one_negation_before_two_writes_of_the_same_value() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        x, y, _ = v
        return type(v)(v.builder, ((-x).value, (-x).value, y.value), v.group)

    routine = written(author)
    assert operations(routine)["negate"] == 2
    assert agree(routine, check(signs(routine), RealOp))


def test_operands_of_a_difference_stand_in_their_order() -> None:
    routine = signs(written(lambda v, x, s: -x + s))
    (difference,) = (each for each in routine.body if isinstance(each, Operation) and each.op is RealOp.SUBTRACT)
    assert [routine.names[arg] for arg in difference.args] == ["s", "x"]


def test_a_name_says_that_the_sign_is_turned() -> None:
    from qcone.ir.labels import named

    routine = signs(written(lambda v, x, s: x - named("p", -x * s)))
    (value,) = (each.result for each in routine.body if isinstance(each, Operation) and each.op is RealOp.MULTIPLY)
    assert routine.names[value] == "p_negated"


def test_a_negation_made_in_a_loop_is_not_seen_outside() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        back = -x
        r = history("r", x, 3)
        r[0] = s
        for n in loop("n", x, 1, 2):
            r[n] = back
        t = history("t", x, 2)
        t[0] = back
        for n in loop("n", x, 1, 1):
            t[n] = F(1, 3) * back + r[n] + t[n - 1]
        return t[1] - back

    routine = written(author, rolled=True)
    signed = check(signs(routine), RealOp)
    assert agree(routine, signed)
    assert agree(signed, written(author))


def test_subroutines() -> None:
    @subroutine
    def odd(a, b):  # type: ignore[no-untyped-def]
        return a - -b * a

    routine = written(lambda v, x, s: odd(-x, s))
    signed = check(sweep(signs(routine)), RealOp)
    assert operations(signed) == {"negate": 1}
    assert operations(signed.callees["odd"]) == {"multiply": 1, "add": 1}
    assert agree(routine, signed)


def test_without_a_negation_nothing_changes() -> None:
    routine = written(lambda v, x, s: x - s)
    assert signs(routine) == routine


# -- axes --------------------------------------------------------------------------------------------------------

AXES = [
    tuple(zip(order, turned, strict=True)) for order in permutations(range(3)) for turned in product((1, -1), repeat=3)
]
"""For each body axis the sensor's and its sign: all 48."""
ALGORITHMS: dict[str, dict[str, str]] = {
    "three samples": {"algorithm": "rotation-vector", "subsamples": "3", "coefficients": "coning"},
    "one sample of rates": {"algorithm": "rotation-vector", "subsamples": "1", "input": "rate"},
    "history": {"algorithm": "rotation-vector", "subsamples": "1", "previous": "2"},
}


def spelt(axes: tuple[tuple[int, int], ...]) -> str:
    return ",".join(("-" if sign < 0 else "") + "xyz"[index] for index, sign in axes)


@cache
def turned_design(name: str, axes: tuple[tuple[int, int], ...]) -> Bundle:
    base = {"number": "float32", "update_hz": "100", "max_rate_dps": "573"}
    return build(design_from_options("turned", {**base, **ALGORITHMS[name], "axes": spelt(axes)}, entries()))


def emitted(bundle: Bundle) -> dict[str, Counts]:
    return {routine: levels["emitted"] for routine, levels in bundle.facts.counts.items()}


def test_there_are_48() -> None:
    assert len({spelt(axes) for axes in AXES}) == 48


@pytest.mark.parametrize("name", ALGORITHMS)
def test_every_mounting_costs_the_same(name: str) -> None:
    """No operation more or less, sums and differences together: a sign turns one into the other."""

    def total(counts: Counts) -> tuple[int, ...]:
        return counts.multiply, counts.power_of_two, counts.add + counts.subtract, counts.divide

    straight = {routine: total(counts) for routine, counts in emitted(turned_design(name, AXES[0])).items()}
    negations = {each.negate for each in emitted(turned_design(name, AXES[0])).values()}
    assert negations == {0}
    for axes in AXES:
        found = emitted(turned_design(name, axes))
        assert {routine: total(counts) for routine, counts in found.items()} == straight, spelt(axes)


@pytest.mark.parametrize("name", ["three samples", "one sample of rates", "history"])
def test_mounting_needs_no_negation(name: str) -> None:
    for axes in AXES:
        assert {counts.negate for counts in emitted(turned_design(name, axes)).values()} == {0}, spelt(axes)


@pytest.mark.parametrize("axes", AXES, ids=spelt)
def test_a_turned_sensor_gives_the_attitude_of_turned_increments(axes: tuple[tuple[int, int], ...]) -> None:
    """Bit for bit, but for the sign of zeros: the same as the straight design fed with what the body feels."""
    straight, mounted = turned_design("three samples", AXES[0]), turned_design("three samples", axes)
    number = straight.facts.number
    random = np.random.default_rng(11)
    sensor = (0.03 * random.standard_normal((3, 3, 200))).astype(dtype_of(number))
    body = np.stack([sign * sensor[:, index] for index, sign in axes], axis=1)
    states = []
    for bundle, inputs in ((mounted, sensor), (straight, body)):
        state = new_state(bundle.machine, number, 200)
        model = Model(bundle.machine, number)
        model.run("init", state)
        for _ in range(3):
            model.run("update", state, {"dtheta": np.ascontiguousarray(inputs.reshape(9, 200))})
        states.append(state["q"] + np.float32(0))
    assert np.array_equal(states[0].view("u4"), states[1].view("u4"))
    assert np.abs(states[0][1:]).min() > 0


@pytest.mark.parametrize("axes", AXES[1::7], ids=spelt)
def test_a_turned_sensor_over_fractions(axes: tuple[tuple[int, int], ...]) -> None:
    """The routine means the straight routine of permuted inputs, exactly."""
    straight, mounted = (turned_design("three samples", each).written.routine("update") for each in (AXES[0], axes))
    sensor = [Fraction(k * k % 17 - 8, 90 + k) for k in range(9)]
    body = [sign * sensor[3 * k + index] for k in range(3) for index, sign in axes]
    q = [Fraction(4, 5), Fraction(1, 5), Fraction(-2, 5), Fraction(2, 7)]
    found = evaluate(mounted, {"q": q, "dtheta": sensor}).blocks["q"]
    assert found == evaluate(straight, {"q": q, "dtheta": body}).blocks["q"]
