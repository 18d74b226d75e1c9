"""Mistakes in what is written where: no TOML, unknown, missing and mistyped keys (QC101 to QC104)."""

# Messages stand whole on their lines, so that a search finds them.

from __future__ import annotations

import re
from pathlib import Path

import pytest
from bad_files import counts, end, imu, messages, top
from fake_catalogue import GOOD

WHOLE = "a list of three rows of three numbers"
MATRIX = "`calibration = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]` in [design.att.imu]"
DESIGN_WORDS = (
    "algorithm, input, increments, axes, outputs, form, euler, loop, exponential, renormalise, core, multiply,"
    " license, subsamples, coefficients, previous, imu, number, rins, budget"
)

ONE_MISTAKE = [
    # QC101: not TOML
    (GOOD + "x = \n", "10: error QC101: not valid TOML: invalid value, at column 5"),
    (GOOD + "\nx = [1,\n2,", "12: error QC101: not valid TOML: invalid value, the file ends there"),
    (b"# one\n# \xff\n", "2: error QC101: not valid TOML: not UTF-8 text, save the file as UTF-8"),
    ("x = " + "[" * 50000, "1: error QC101: not valid TOML: nested too deeply"),
    # QC102: unknown keys
    ("[desing.att]\n" + GOOD, "1: error QC102: unknown key `desing`, did you mean `design`?"),
    (
        '"a b\\n" = 1\n' + GOOD,
        '1: error QC102: unknown key `"a b?"`, keys of a design stand below a header [design.NAME]',
    ),
    (top("outptus = []"), "3: error QC102: unknown key `outptus`, did you mean `outputs`?"),
    (top("Input = 1"), "3: error QC102: unknown key `Input`, did you mean `input`?"),
    (top("zzz = 1"), f"3: error QC102: unknown key `zzz`, the keys here are {DESIGN_WORDS}"),
    (
        top("update_hz = 1"),
        "3: error QC102: unknown key `update_hz`, it belongs elsewhere: write `update_hz = 100` in [design.att.imu]",
    ),
    (
        end('axes = "x,y,z"\n'),
        '10: error QC102: unknown key `number.axes`, it belongs elsewhere: write `axes = "y,-x,z"` in [design.att]',
    ),
    (
        top("order = 2"),
        "3: error QC102: unknown key `order`, this algorithm has no such parameter, leave it out or choose another"
        " algorithm",
    ),
    (top("[design.att.immu]"), "3: error QC102: unknown key `immu`, did you mean `imu`?"),
    (
        imu("max_rat_dps = 5"),
        "7: error QC102: unknown key `imu.max_rat_dps`, did you mean `imu.max_rate_dps`?",
    ),
    (
        end('overflw = "wrap"\n'),
        "10: error QC102: unknown key `number.overflw`, did you mean `number.overflow`?",
    ),
    (
        end("[design.att.budget]\nmultiplies = 3\n"),
        "11: error QC102: unknown key `budget.multiplies`, did you mean `budget.multiply`?",
    ),
    (
        end("[design.att.budget.cortex-m33]\n"),
        "10: error QC102: unknown key `budget.cortex-m33`, did you mean `budget.cortex-m33f`?",
    ),
    (
        end("[design.att.budget.host]\nstack = 3\n"),
        "11: error QC102: unknown key `budget.host.stack`, did you mean `budget.host.stack_bytes`?",
    ),
    (
        end("[design.att.rins]\nmax_corection_arcsec = 3\n"),
        "11: error QC102: unknown key `rins.max_corection_arcsec`, did you mean `rins.max_correction_arcsec`?",
    ),
    (
        top("max_correction_arcsec = 3"),
        "3: error QC102: unknown key `max_correction_arcsec`, it belongs elsewhere: write `max_correction_arcsec = 600`"
        " in [design.att.rins]",
    ),
    # QC103: missing keys
    (
        GOOD.replace('algorithm = "rotation-vector"\n', ""),
        "1: error QC103: `algorithm` is missing, it has no default (a catalogue id, or file.py:function),"
        ' add `algorithm = "rotation-vector"` in [design.att]',
    ),
    (
        GOOD.replace("update_hz = 100\n", ""),
        "4: error QC103: `imu.update_hz` is missing, it has no default (attitude updates a second),"
        " add `update_hz = 100` in [design.att.imu]",
    ),
    (
        GOOD.replace('[design.att.number]\nformat = "float32"\n', ""),
        "1: error QC103: `number.format` is missing, it has no default (number format),"
        ' add `format = "float32"` in [design.att.number]',
    ),
    # QC104: wrong types
    (
        "design = 3\n",
        "1: error QC104: `design` must be a table, not 3, start with a header such as [design.my_attitude]",
    ),
    (
        '[design]\nalgorithm = "picard"\n',
        '2: error QC104: `design.algorithm` must be a table, not "picard", put the keys of a design below a header'
        " [design.NAME]",
    ),
    (
        "[[design.att]]\n",
        "1: error QC104: `design.att` must be a table, not [{...}], put the keys of a design below a header"
        " [design.NAME]",
    ),
    (
        end('[design.b]\nalgorithm = "picard"\nnumber.format = "float32"\nimu = [1]\n'),
        "13: error QC104: `imu` must be a table, not [1], write a header [design.NAME.imu]",
    ),
    (top("rins = true"), "3: error QC104: `rins` must be a table, not true, write a header [design.NAME.rins]"),
    (
        end('[design.att.rins]\nmax_correction_arcsec = "much"\n'),
        '11: error QC104: `rins.max_correction_arcsec` must be a number, not the string "much", write for example'
        " `max_correction_arcsec = 600` in [design.att.rins]",
    ),
    (
        end("[design.att.rins]\nmax_correction_arcsec = [600]\n"),
        "11: error QC104: `rins.max_correction_arcsec` must be a number, not the list [600], write for example"
        " `max_correction_arcsec = 600` in [design.att.rins]",
    ),
    (
        end("[design.att.budget]\nhost = 3\n"),
        "11: error QC104: `budget.host` must be a table, not 3, write a header [design.NAME.budget.host]",
    ),
    (
        GOOD.replace('"rotation-vector"', "3"),
        "2: error QC104: `algorithm` must be a string, not the number 3, write for example"
        ' `algorithm = "rotation-vector"` in [design.att]',
    ),
    (
        top("subsamples = true"),
        "3: error QC104: `subsamples` must be a whole number, not true, write for example `subsamples = 1` in"
        " [design.att]",
    ),
    (
        top("subsamples = 3.0"),
        "3: error QC104: `subsamples` must be a whole number, not the number 3.0, write for example"
        " `subsamples = 1` in [design.att]",
    ),
    (
        top('subsamples = "3"'),
        '3: error QC104: `subsamples` must be a whole number, not the string "3", leave out the quotes',
    ),
    (
        GOOD.replace('"rotation-vector"', '"picard"\norder = []'),
        "3: error QC104: `order` must be a whole number or a string, not the list [], write for example"
        " `order = 1` in [design.att]",
    ),
    (
        top("form = 1979-05-27"),
        "3: error QC104: `form` must be a string, not 1979-05-27, write for example"
        ' `form = "factored"` in [design.att]',
    ),
    (
        top('outputs = "dcm"'),
        '3: error QC104: `outputs` must be a list of strings, not the string "dcm", write `outputs = ["dcm"]` in'
        " [design.att]",
    ),
    (
        top("outputs = 3"),
        "3: error QC104: `outputs` must be a list of strings, not the number 3, write for example"
        ' `outputs = ["quaternion"]` in [design.att]',
    ),
    (
        top("outputs = [3]"),
        "3: error QC104: `outputs` must be a list of strings, not the number 3, write for example"
        ' `outputs = ["quaternion"]` in [design.att]',
    ),
    (
        top("axes = [1, 2]"),
        "3: error QC104: `axes` must be a string, not the list [1, 2], write for example"
        ' `axes = "y,-x,z"` in [design.att]',
    ),
    (
        GOOD.replace("573", '"fast"'),
        '6: error QC104: `imu.max_rate_dps` must be a number, not the string "fast", write for example'
        " `max_rate_dps = 573` in [design.att.imu]",
    ),
    (
        GOOD.replace("573", "true"),
        "6: error QC104: `imu.max_rate_dps` must be a number, not true, write for example"
        " `max_rate_dps = 573` in [design.att.imu]",
    ),
    (
        counts('quantum_dps = "1/x"'),
        '8: error QC104: `imu.quantum_dps` must be a number or a string "p/q", not the string "1/x", write for'
        ' example `quantum_dps = "2000/32768"` in [design.att.imu]',
    ),
    (
        counts("quantum_dps = 1\nbias_dps = [1, 2]"),
        "9: error QC104: `imu.bias_dps` must be a list of three numbers, not the list [1, 2], write for example"
        " `bias_dps = [0.1, -0.2, 0.05]` in [design.att.imu]",
    ),
    (
        counts("quantum_dps = 1\ncalibration = [[1, 0, 0], [0, 1, 0], [0, 0]]"),
        f"9: error QC104: `imu.calibration` must be {WHOLE}, not the list [[1, 0, 0], [0, 1, 0], [0, 0]], write for"
        f" example {MATRIX}",
    ),
    (
        counts("quantum_dps = 1\ncalibration = {a = 1}"),
        f"9: error QC104: `imu.calibration` must be {WHOLE}, not a table, write for example {MATRIX}",
    ),
    (
        end("clamp_inputs = 1\n").replace("float32", "fixed32"),
        "10: error QC104: `number.clamp_inputs` must be true or false, not the number 1, write for example"
        " `clamp_inputs = false` in [design.att.number]",
    ),
    (
        end("[design.att.budget]\nadd = 1.5\n"),
        "11: error QC104: `budget.add` must be a whole number, not the number 1.5, write for example"
        " `add = 60` in [design.att.budget]",
    ),
    (
        end("[design.att.budget]\nadd = true\n"),
        "11: error QC104: `budget.add` must be a whole number, not true, write for example"
        " `add = 60` in [design.att.budget]",
    ),
]


@pytest.mark.parametrize(("text", "message"), ONE_MISTAKE, ids=[message[:60] for _, message in ONE_MISTAKE])
def test_each_mistake_has_its_message(tmp_path: Path, text: str | bytes, message: str) -> None:
    assert messages(tmp_path, text) == [f"bad.toml:{message}"]


def test_every_code_has_a_message_here() -> None:
    codes = {match for _, message in ONE_MISTAKE for match in re.findall(r"QC\d+", message)}
    assert codes == {f"QC{number}" for number in range(101, 105)}
