"""The digest names what decides the output, the same on every machine."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import fields, replace
from fractions import Fraction
from pathlib import Path

import pytest
from fake_catalogue import CATALOGUE

from qcone.design import Design, Imu, Number, Rins, design_from_options

ONE = Fraction(1)
DESIGN = design_from_options(
    "att",
    {
        "algorithm": "rotation-vector",
        "subsamples": 3,
        "coefficients": "coning",
        "number": "fixed32",
        "update_hz": "99.2",
        "max_rate_dps": "573",
    },
    CATALOGUE,
)


def test_the_digest_is_the_same_everywhere() -> None:
    assert DESIGN.digest == "3eb047fd0cc48dc9e2914d647eb8ad9a53ff7f3b7f057373affd7b0c53cf7d39"


def test_the_digest_is_sha256_of_canonical_json() -> None:
    text = (
        '{"algorithm":"rotation-vector","axes":[[0,1],[1,1],[2,1]],"core":"generic","euler":"zyx",'
        '"exponential":"minimax","form":"factored","imu":{"bias_dps":null,"calibration":null,'
        '"max_angular_acceleration_dps2":null,"max_jerk_dps3":null,"max_rate_dps":"573/1","quantum_dps":null,'
        '"update_hz":"496/5"},"increments":"interpolating","input":"increment","license":"MIT-0",'
        '"loop":"unrolled","multiply":"auto","name":"att","number":{"accumulate":"delta","clamp_inputs":false,'
        '"format":"fixed32","overflow":"prove","rounding":"up"},"outputs":["quaternion"],"parameters":'
        '{"coefficients":"coning","previous":0,"subsamples":3},"renormalise":"every"}'
    )
    assert DESIGN.digest == hashlib.sha256(text.encode()).hexdigest()


def test_file_folder_and_budgets_do_not_enter() -> None:
    moved = replace(
        DESIGN,
        file="other.toml",
        directory=Path("/elsewhere"),
        budget={"multiply": 1},
        target_budgets={"host": {"text_bytes": 1}},
    )
    assert moved.digest == DESIGN.digest


def test_the_order_of_parameters_does_not_enter() -> None:
    turned = replace(DESIGN, parameters=dict(reversed(DESIGN.parameters.items())))
    assert list(turned.parameters) != list(DESIGN.parameters)
    assert turned.digest == DESIGN.digest


def _imu(**change: object) -> Callable[[Design], Design]:
    return lambda design: replace(design, imu=replace(design.imu, **change))  # type: ignore[arg-type]


def _number(**change: object) -> Callable[[Design], Design]:
    return lambda design: replace(design, number=replace(design.number, **change))  # type: ignore[arg-type]


def _top(**change: object) -> Callable[[Design], Design]:
    return lambda design: replace(design, **change)  # type: ignore[arg-type]


CHANGES: dict[str, Callable[[Design], Design]] = {
    "name": _top(name="att2"),
    "algorithm": _top(algorithm="my.py:f"),
    "parameters": _top(parameters={"subsamples": 3}),
    "input": _top(input="rate"),
    "increments": _top(increments="cao-13"),
    "axes": _top(axes=((0, 1), (1, 1), (2, -1))),
    "outputs": _top(outputs=("quaternion", "dcm")),
    "form": _top(form="as-written"),
    "euler": _top(euler="zxy"),
    "loop": _top(loop="rolled"),
    "exponential": _top(exponential="taylor"),
    "renormalise": _top(renormalise="never"),
    "core": _top(core="cortex-m0"),
    "multiply": _top(multiply="wide"),
    "license": _top(license="MIT"),
    "rins": _top(rins=Rins(Fraction(600))),
    "imu.update_hz": _imu(update_hz=Fraction(100)),
    "imu.max_rate_dps": _imu(max_rate_dps=Fraction(573) + Fraction(1, 10**30)),
    "imu.max_angular_acceleration_dps2": _imu(max_angular_acceleration_dps2=ONE),
    "imu.max_jerk_dps3": _imu(max_jerk_dps3=ONE),
    "imu.quantum_dps": _imu(quantum_dps=ONE),
    "imu.bias_dps": _imu(bias_dps=(ONE, ONE, ONE)),
    "imu.calibration": _imu(calibration=((ONE, ONE, ONE),) * 3),
    "number.format": _number(format="fixed16"),
    "number.accumulate": _number(accumulate="standard"),
    "number.overflow": _number(overflow="wrap"),
    "number.rounding": _number(rounding="even"),
    "number.clamp_inputs": _number(clamp_inputs=True),
    "number.pins": _number(pins=(("phi_x", 29),)),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES.keys())
def test_everything_else_enters(change: Callable[[Design], Design]) -> None:
    assert change(DESIGN).digest != DESIGN.digest


def test_no_field_is_forgotten_here() -> None:
    outside = {"file", "directory", "line", "budget", "target_budgets", "imu", "number"}
    names = {field.name for field in fields(Design)} - outside
    names |= {f"imu.{field.name}" for field in fields(Imu)} | {f"number.{field.name}" for field in fields(Number)}
    assert names == CHANGES.keys()


def test_a_stage_that_is_not_asked_for_leaves_no_trace_and_one_that_is_enters_with_its_keys() -> None:
    digests = [replace(DESIGN, rins=rins).digest for rins in (None, Rins(Fraction(600)), Rins(Fraction(601)))]
    assert digests[0] == DESIGN.digest
    assert len(set(digests)) == 3
    assert [field.name for field in fields(Rins)] == ["max_correction_arcsec"]


def test_the_folder_does_not_make_two_designs_different_but_the_file_does() -> None:
    assert replace(DESIGN, directory=Path("/elsewhere")) == DESIGN
    assert replace(DESIGN, file="other.toml") != DESIGN
