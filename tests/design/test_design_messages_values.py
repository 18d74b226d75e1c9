"""Mistakes in values, and between keys that are legal by themselves (QC105 to QC113)."""

# Messages stand whole on their lines, so that a search finds them.

from __future__ import annotations

import re
from pathlib import Path

import pytest
from bad_files import counts, end, imu, messages, top
from fake_catalogue import GOOD

IDENTIFIER = "it begins the names of C functions: a lower case letter, then at most 63 of a-z, 0-9 and _"
AS_WRITTEN = 'does not go with `form = "as-written"`, the paper\'s form has its own, leave it out'
AXES = (
    "is not a signed permutation, each of x, y and z must stand once, with or without a minus sign,"
    ' write for example "y,-x,z"'
)

ONE_MISTAKE = [
    # QC105: not among the choices
    (
        top('coefficients = "conning"'),
        '3: error QC105: `coefficients = "conning"` is not allowed, the choice is "taylor", "coning", "expanded" or'
        ' "compressed", did you mean "coning"?',
    ),
    (
        top('outputs = ["dcm", "quat"]'),
        '3: error QC105: `outputs = "quat"` is not allowed, the choice is "quaternion", "dcm" or "euler"',
    ),
    (
        GOOD.replace('"rotation-vector"', '"picard"\norder = "3"'),
        '3: error QC105: `order = "3"` is not allowed, the choice is 1 to 4 or "closed", write 3 without quotes',
    ),
    (
        top('euler = "xyz"'),
        '3: error QC105: `euler = "xyz"` is not allowed, the choice is "zyx" or "zxy", did you mean "zxy"?',
    ),
    # QC106: out of range
    (
        GOOD.replace("= 100", "= -1"),
        "5: error QC106: `imu.update_hz = -1` is out of range, it must be greater than 0",
    ),
    (
        GOOD.replace("573", "0.0"),
        "6: error QC106: `imu.max_rate_dps = 0.0` is out of range, it must be greater than 0",
    ),
    (
        GOOD.replace("573", "inf"),
        "6: error QC106: `imu.max_rate_dps = Infinity` is out of range, no such magnitude is meant",
    ),
    (
        GOOD.replace("573", "nan"),
        "6: error QC106: `imu.max_rate_dps = NaN` is out of range, no such magnitude is meant",
    ),
    (
        GOOD.replace("573", "1e999999999"),
        "6: error QC106: `imu.max_rate_dps = 1E+999999999` is out of range, no such magnitude is meant",
    ),
    (
        GOOD.replace("573", f"1e{'9' * 30}"),
        "6: error QC106: `imu.max_rate_dps = Infinity` is out of range, no such magnitude is meant",
    ),
    (
        GOOD.replace("573", "9" * 4000),
        "6: error QC106: `imu.max_rate_dps = ...` is out of range, no such magnitude is meant",
    ),
    (
        imu("max_jerk_dps3 = 0"),
        "7: error QC106: `imu.max_jerk_dps3 = 0` is out of range, it must be greater than 0",
    ),
    (
        imu("max_angular_acceleration_dps2 = -2.5"),
        "7: error QC106: `imu.max_angular_acceleration_dps2 = -2.5` is out of range, it must be greater than 0",
    ),
    (
        counts('quantum_dps = "1/0"'),
        '8: error QC106: `imu.quantum_dps = "1/0"` is out of range, it divides by zero',
    ),
    (
        counts('quantum_dps = "-1/4"'),
        '8: error QC106: `imu.quantum_dps = "-1/4"` is out of range, it must be greater than 0',
    ),
    (
        end("[design.att.budget]\ndivide = -1\n"),
        "11: error QC106: `budget.divide = -1` is out of range, it must be 0 or more",
    ),
    (
        end("[design.att.budget.rv32imc]\ninstructions_max = -1\n"),
        "11: error QC106: `budget.rv32imc.instructions_max = -1` is out of range, it must be 0 or more",
    ),
    (
        top("outputs = []"),
        '3: error QC106: `outputs` is an empty list, write `outputs = ["quaternion"]` in [design.att]',
    ),
    (
        end("[design.att.rins]\nmax_correction_arcsec = 0\n"),
        "11: error QC106: `rins.max_correction_arcsec = 0` is out of range, it must be greater than 0",
    ),
    (
        end("[design.att.rins]\nmax_correction_arcsec = -600.5\n"),
        "11: error QC106: `rins.max_correction_arcsec = -600.5` is out of range, it must be greater than 0",
    ),
    (
        end("[design.att.rins]\nmax_correction_arcsec = nan\n"),
        "11: error QC106: `rins.max_correction_arcsec = NaN` is out of range, no such magnitude is meant",
    ),
    (
        end("[design.att.rins]\nmax_correction_arcsec = 36000.5\n"),
        "11: error QC106: `rins.max_correction_arcsec = 36000.5` is out of range, more than 10 deg is a mounting, not"
        " the error of an encoder or a bearing, give 36000 or less",
    ),
    # QC107: keys that do not go together
    (
        end('rounding = "even"\n'),
        '10: error QC107: `number.rounding` does not go with `number.format = "float32"`, only fixed formats have it,'
        " leave it out",
    ),
    (
        end("clamp_inputs = false\n"),
        '10: error QC107: `number.clamp_inputs` does not go with `number.format = "float32"`, only fixed formats have'
        " it, leave it out",
    ),
    (
        end('accumulate = "delta"\n').replace("[design.att.imu]", 'form = "as-written"\n[design.att.imu]'),
        f"11: error QC107: `number.accumulate` {AS_WRITTEN}",
    ),
    (top('form = "as-written"\nrenormalise = "every"'), f"4: error QC107: `renormalise` {AS_WRITTEN}"),
    (top('exponential = "taylor"\nform = "as-written"'), f"3: error QC107: `exponential` {AS_WRITTEN}"),
    (
        top('input = "counts"'),
        '3: error QC107: `input = "counts"` needs `imu.quantum_dps`, a count has no unit, add'
        ' `quantum_dps = "2000/32768"` in [design.att.imu]',
    ),
    (
        imu("quantum_dps = 1"),
        '7: error QC107: `imu.quantum_dps` needs `input = "counts"`, other inputs have units already, leave it out',
    ),
    (
        imu("calibration = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
        '7: error QC107: `imu.calibration` needs `input = "counts"`, other inputs have units already, leave it out',
    ),
    (
        GOOD.replace("573", "18000.5"),
        "6: error QC107: `imu.max_rate_dps = 18000.5` turns 180.005 deg in one update, more than half a turn cannot be"
        " told from less, raise `imu.update_hz` to 101 or more",
    ),
    (
        top('coefficients = "coning"'),
        "3: error QC107: `coefficients` given for one sub-sample, there is no coning term, leave it out",
    ),
    (
        GOOD.replace('"rotation-vector"', '"my.py:f"\nprevious = 2'),
        "3: error QC107: `previous` does not go with `my.py:f`, the function's own decorator says it, leave it out",
    ),
    # QC108: axes
    *((top(f'axes = "{axes}"'), f'3: error QC108: `axes = "{axes}"` {AXES}') for axes in ("", "x,y", "x,-x,z")),
    *((top(f'axes = "{axes}"'), f'3: error QC108: `axes = "{axes}"` {AXES}') for axes in ("x,y,w", "--x,y,z")),
    # QC109: algorithms
    (
        GOOD.replace("rotation-vector", "zzz"),
        '2: error QC109: `algorithm = "zzz"` is unknown, it is not in the catalogue, the catalogue has rotation-vector,'
        " picard",
    ),
    *(
        (
            GOOD.replace('"rotation-vector"', f'"{algorithm}"'),
            f'2: error QC109: `algorithm = "{shown}"` is unknown, a function of your own is written file.py:function,'
            ' write for example "my_paper.py:my_update"',
        )
        for algorithm, shown in [
            ("my.py", "my.py"),
            ("my:f", "my:f"),
            (".py:f", ".py:f"),
            ("a.py:f\\n", "a.py:f?"),
        ]
    ),
    # QC110: names
    (
        GOOD.replace("design.att", "design.Att-Fast"),
        f'1: error QC110: "Att-Fast" cannot name a design, {IDENTIFIER}, write for example att_fast',
    ),
    (
        GOOD.replace("design.att", "design.3d"),
        f'1: error QC110: "3d" cannot name a design, {IDENTIFIER}, choose another',
    ),
    (
        GOOD.replace("design.att", f"design.{'a' * 65}"),
        f'1: error QC110: "{"a" * 56}... cannot name a design, {IDENTIFIER}, write for example {"a" * 64}',
    ),
    (
        GOOD.replace("design.att", "design.double"),
        '1: error QC110: "double" cannot name a design, it is a C keyword, write for example double_1',
    ),
    # QC111: nothing there
    ("", "1: error QC111: there is no design in this file, start with a header such as [design.my_attitude]"),
    (
        "# a comment\n\n[design]\n",
        "3: error QC111: there is no design in this file, start with a header such as [design.my_attitude]",
    ),
    # QC112, QC113
    (
        top('outputs = ["dcm", "euler", "dcm"]'),
        '3: error QC112: `outputs = ["dcm", "euler", "dcm"]` names "dcm" more than once, name each once',
    ),
    *(
        (
            top(f'license = "{name}"'),
            f'3: error QC113: `license = "{shown}"` is not an SPDX identifier, write for example "MIT-0" or'
            ' "Apache-2.0"',
        )
        for name, shown in [("", ""), ("M I T", "M I T"), ("MIT\\n", "MIT?"), ("*/", "*/")]
    ),
]


@pytest.mark.parametrize(("text", "message"), ONE_MISTAKE, ids=[message[:60] for _, message in ONE_MISTAKE])
def test_each_mistake_has_its_message(tmp_path: Path, text: str | bytes, message: str) -> None:
    assert messages(tmp_path, text) == [f"bad.toml:{message}"]


def test_every_code_has_a_message_here() -> None:
    codes = {match for _, message in ONE_MISTAKE for match in re.findall(r"QC\d+", message)}
    assert codes == {f"QC{number}" for number in range(105, 114)}
