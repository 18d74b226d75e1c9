"""Attitudes given out in fixed point, to a few last bits and poles included: angles, matrices, quaternions of those."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from fixed_designs import FLAGSHIP, SMOOTH, made
from qcone.backends.bittrue import Model, State, new_state
from qcone.bundle import Bundle
from qcone.reference.euler import from_angles
from qcone.reference.quaternion import error_angle, normalise, to_matrix
from qcone.words import from_words, to_words
from test_attitude_states import attitudes

Array = NDArray[np.float64]
NUMBERS = ("fixed32", "fixed16")
CONVENTIONS = ("zyx", "zxy")
MATRICES = ("dcm-taylor subsamples=3 order=10", "runge-kutta-4 attitude=dcm")
SHORT = {"fixed32": 1e-7, "fixed16": 1e-3}


def near_poles(convention: str, number: str) -> Array:
    """Return attitudes about both poles: at them, and off by from a last bit up to a degree."""
    random = np.random.default_rng(4)
    sizes = random.choice([0.0, *10.0 ** np.arange(-9.0, -1.0), SHORT[number]], 3000)
    pitch = random.choice([-1, 1], 3000) * (np.pi / 2 - sizes * random.random(3000))
    angles = np.stack([random.uniform(-np.pi, np.pi, 3000), pitch, random.uniform(-np.pi, np.pi, 3000)], axis=1)
    return from_angles(angles, convention)


def held(bundle: Bundle, setter: str, block: str, given: Array) -> tuple[Model, State]:
    """Set attitudes, rounded to words, in as many lanes."""
    model = Model(bundle.machine, bundle.facts.number)
    state = new_state(bundle.machine, bundle.facts.number, len(given))
    model.run(setter, state, {block: to_words(bundle, block, given).T})
    return model, state


def out(bundle: Bundle, model: Model, state: State, routine: str, block: str) -> Array:
    return from_words(bundle, block, np.asarray(model.run(routine, state)[block]).T)


def last_bits(bundle: Bundle, block: str, error: Any) -> float:
    bits = bundle.driver.bits(block)
    assert bits is not None
    return float(np.max(error)) * 2.0**bits


@pytest.mark.parametrize("accumulate", ["delta", "compensated"])
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("number", NUMBERS)
def test_angles_give_the_attitude_back_at_poles_and_everywhere(number: str, convention: str, accumulate: str) -> None:
    """Within 16 last bits of an angle; the attitude is the one the quaternion output tells."""
    bundle = made(FLAGSHIP, number, accumulate, outputs="quaternion,dcm,euler", euler=convention)
    q = np.concatenate([attitudes(), near_poles(convention, number)])
    model, state = held(bundle, "set_quaternion", "q_nb", q)
    kept = normalise(out(bundle, model, state, "quaternion", "q_nb"))
    angles = out(bundle, model, state, "euler", "rpy")
    rebuilt = from_angles(angles, convention)
    assert last_bits(bundle, "rpy", error_angle(rebuilt, kept)) <= 16
    beyond = np.abs(angles) - [np.pi, np.pi / 2, np.pi]
    assert last_bits(bundle, "rpy", beyond) <= 8
    assert np.ptp(angles, axis=0).min() > 3


@pytest.mark.parametrize("number", NUMBERS)
def test_a_matrix_is_that_of_the_quaternion(number: str) -> None:
    """Each entry within 8 last bits; and the quaternion within 4 of what was set."""
    bundle = made(FLAGSHIP, number, "delta", outputs="quaternion,dcm,euler")
    q = attitudes()
    model, state = held(bundle, "set_quaternion", "q_nb", q)
    kept = out(bundle, model, state, "quaternion", "q_nb")
    assert last_bits(bundle, "q_nb", np.abs(kept - q)) <= 4
    matrix = out(bundle, model, state, "dcm", "c_nb").reshape(-1, 3, 3)
    assert last_bits(bundle, "c_nb", np.abs(matrix - to_matrix(normalise(kept)))) <= 8


@pytest.mark.parametrize("accumulate", ["delta", "standard"])
@pytest.mark.parametrize("example", MATRICES)
def test_shepperds_rule_finds_the_quaternion_of_a_matrix(example: str, accumulate: str) -> None:
    """At every seam, where two components are alike: within 8 last bits, the largest component positive or its sign."""
    bundle = made(example, "fixed32", accumulate, outputs="quaternion,dcm", **SMOOTH)
    q = attitudes()
    model, state = held(bundle, "set_dcm", "c_nb", to_matrix(q).reshape(-1, 9))
    matrix = out(bundle, model, state, "dcm", "c_nb")
    assert last_bits(bundle, "c_nb", np.abs(matrix - to_matrix(q).reshape(-1, 9))) <= 8
    found = out(bundle, model, state, "quaternion", "q_nb")
    assert np.abs(np.linalg.norm(found, axis=1) - 1).max() < 1e-7
    assert last_bits(bundle, "q_nb", error_angle(normalise(found), q)) <= 16
    alike = np.where(np.sum(found * q, axis=1, keepdims=True) < 0, -q, q)
    assert last_bits(bundle, "q_nb", np.abs(found - alike)) <= 8


@pytest.mark.parametrize("number", NUMBERS)
def test_what_is_set_is_brought_to_unit_length(number: str) -> None:
    """One Newton step takes an attitude that is off by 2^-11 to within 2^-21, or to last bits."""
    bundle = made(FLAGSHIP, number, "delta", outputs="quaternion,dcm,euler")
    for factor in (1 - 2.0**-11, 1 + 2.0**-11):
        model, state = held(bundle, "set_quaternion", "q_nb", attitudes() * factor)
        norm = np.linalg.norm(out(bundle, model, state, "quaternion", "q_nb"), axis=1)
        assert np.abs(norm - 1).max() <= 1.5 * 2.0**-22 + 2 * 2.0 ** -(bundle.driver.bits("q_nb") or 0)
