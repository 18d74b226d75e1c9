"""Command line options make the same design as a file does, and the same mistakes, named as options."""

# Messages stand whole on their lines, so that a search finds them.

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest
from fake_catalogue import CATALOGUE

from qcone.design import design_from_options, read_designs
from qcone.errors import DesignError

OPTIONS = {"algorithm": "rotation-vector", "number": "float32", "max-rate-dps": "573", "update_hz": "100"}

FILE = """\
[design.att]
algorithm = "rotation-vector"
subsamples = 3
coefficients = "coning"
input = "counts"
axes = "-x,z,y"
outputs = ["dcm", "euler"]
imu.update_hz = 99.2
imu.max_rate_dps = 573.1
imu.quantum_dps = "2000/32768"
imu.bias_dps = ["1/3", -0.5, 2]
imu.calibration = [[1, 0.01, 0], [0, 1, 0], [0, 0, "99/100"]]
number.format = "fixed32"
number.accumulate = "compensated"
number.clamp_inputs = true
"""

TEXTS: dict[str, object] = {
    "algorithm": "rotation-vector",
    "subsamples": "3",
    "coefficients": "coning",
    "input": "counts",
    "axes": "-x,z,y",
    "outputs": "dcm,euler",
    "update-hz": "99.2",
    "max-rate-dps": "573.1",
    "quantum-dps": "2000/32768",
    "bias-dps": "1/3,-0.5,2",
    "calibration": "1,0.01,0;0,1,0;0,0,99/100",
    "number": "fixed32",
    "accumulate": "compensated",
    "clamp-inputs": "true",
    "renormalise": None,
    "license": (),
}

VALUES: dict[str, object] = {
    "algorithm": "rotation-vector",
    "subsamples": 3,
    "coefficients": "coning",
    "input": "counts",
    "axes": "-x,z,y",
    "outputs": ("dcm", "euler"),
    "update_hz": 99.2,
    "max_rate_dps": Decimal("573.1"),
    "quantum_dps": Fraction(2000, 32768),
    "bias_dps": (Fraction(1, 3), -0.5, 2),
    "calibration": ((1, 0.01, 0), (0, 1, 0), (0, 0, Fraction(99, 100))),
    "number": "fixed32",
    "accumulate": "compensated",
    "clamp_inputs": True,
}


SEPARATE = TEXTS | {"outputs": ("dcm", "euler"), "bias-dps": ["1/3", "-0.5", "2"]}


@pytest.mark.parametrize("options", [TEXTS, VALUES, SEPARATE], ids=["texts", "values", "separate"])
def test_options_make_the_same_design_as_a_file(tmp_path: Path, options: dict[str, object]) -> None:
    file = tmp_path / "designs.toml"
    file.write_text(FILE)
    (from_file,) = read_designs(file, CATALOGUE)
    design = design_from_options("att", options, CATALOGUE)
    assert design.digest == from_file.digest
    assert (design.imu, design.number, design.parameters) == (
        from_file.imu,
        from_file.number,
        from_file.parameters,
    )
    assert design.file == ""
    assert design.directory is None


def _messages(options: dict[str, object], name: str = "att") -> list[str]:
    with pytest.raises(DesignError) as caught:
        design_from_options(name, options, CATALOGUE)
    return str(caught.value).split("\n")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"max-rate-dps": None},
            "--max-rate-dps: error QC103: `--max-rate-dps` is missing, it has no default"
            " (largest Euclidean norm of the body rate, deg/s), add `--max-rate-dps 573`",
        ),
        (
            {"number": None},
            "--number: error QC103: `--number` is missing, it has no default (number format), add `--number float32`",
        ),
        (
            {"max_rate_dps": "fast", "max-rate-dps": None},
            '--max-rate-dps: error QC104: `--max-rate-dps` must be a number, not the string "fast", write for'
            " example `--max-rate-dps 573`",
        ),
        (
            {"update_hz": "0"},
            "--update-hz: error QC106: `--update-hz 0` is out of range, it must be greater than 0",
        ),
        (
            {"update_hz": float("inf")},
            "--update-hz: error QC106: `--update-hz Infinity` is out of range, no such magnitude is meant",
        ),
        (
            {"subsamples": "7"},
            "--subsamples: error QC105: `--subsamples 7` is not allowed, the choice is 1 to 6",
        ),
        (
            {"subsamples": "three"},
            '--subsamples: error QC104: `--subsamples` must be a whole number, not the string "three", write for'
            " example `--subsamples 1`",
        ),
        (
            {"number": "float31"},
            '--number: error QC105: `--number float31` is not allowed, the choice is "float32", "float64", "fixed32"'
            ' or "fixed16", did you mean "float32"?',
        ),
        (
            {"format": "json"},
            "--format: error QC102: unknown key `--format`, it belongs elsewhere: write `--number float32`",
        ),
        (
            {"order": "2"},
            "--order: error QC102: unknown key `--order`, this algorithm has no such parameter, leave it out or"
            " choose another algorithm",
        ),
        (
            {"overflow": "wrap"},
            "--overflow: error QC107: `--overflow` does not go with `--number float32`, only fixed formats have it,"
            " leave it out",
        ),
        (
            {"outputs": "dcm,dcm"},
            '--outputs: error QC112: `--outputs dcm,dcm` names "dcm" more than once, name each once',
        ),
        (
            {"calibration": "1,2,3,4", "input": "counts", "quantum-dps": "1"},
            "--calibration: error QC104: `--calibration` must be a list of three rows of three numbers, not the list"
            " [[1, 2, 3], [4]], write for example `--calibration 1,0,0,0,1,0,0,0,1`",
        ),
        (
            {"clamp_inputs": "yes", "number": "fixed32"},
            '--clamp-inputs: error QC104: `--clamp-inputs` must be true or false, not the string "yes", write for'
            " example `--clamp-inputs false`",
        ),
        (
            {"max-rate-dps": "20000"},
            "--max-rate-dps: error QC107: `--max-rate-dps 20000` turns 200 deg in one update, more than half a turn"
            " cannot be told from less, raise `--update-hz` to 112 or more",
        ),
    ],
)
def test_each_mistake_is_named_as_an_option(change: dict[str, object], message: str) -> None:
    assert _messages(OPTIONS | change) == [message]


def test_all_mistakes_come_at_once_in_the_order_given_with_missing_ones_last() -> None:
    options: dict[str, object] = {"axes": "x", "algorithm": "picard", "order": "9", "number": "x"}
    assert [message.split(":")[0] for message in _messages(options | {"max-rate-dps": "1"})] == [
        "--axes",
        "--order",
        "--number",
        "--update-hz",
    ]


def test_the_name_is_checked_too() -> None:
    assert _messages(OPTIONS, "for") == [
        '--design: error QC110: "for" cannot name a design, it is a C keyword, write for example for_1'
    ]
