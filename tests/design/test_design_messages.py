"""Every mistake in a design file has one message of its own, on its line; all of them come at once."""

# Messages stand whole on their lines, so that a search finds them.

from __future__ import annotations

import re
from pathlib import Path

import pytest
from fake_catalogue import CATALOGUE, GOOD

from qcone.design import read_designs
from qcone.errors import DesignError


def _messages(folder: Path, text: str | bytes) -> list[str]:
    """Return the messages of a design file with this text, without the folder."""
    file = folder / "bad.toml"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(DesignError) as caught:
        read_designs(file, CATALOGUE)
    assert caught.value.exit_code == 2
    lines = str(caught.value).split("\n")
    assert lines == [str(problem) for problem in caught.value.problems]
    prefix = f"{folder.as_posix()}/"
    assert all(line.startswith(prefix) for line in lines)
    return [line.removeprefix(prefix) for line in lines]


MANY = """\
[design.att]
algorithm = "rotation-vector"
subsamples = 7
axes = "x,x,z"
coeficients = "coning"

[design.att.imu]
update_hz = 0
bias_dps = [1, 2, 3]

[design.att.number]
format = "float16"
clamp_inputs = "no"

[design.Int]
algorithm = "rotation-vektor"
imu = { update_hz = "100", max_rate_dps = 573 }
number = { format = "float32", overflow = "wrap" }

[extra]
"""


def test_all_mistakes_of_a_file_are_reported_at_once_in_its_order(tmp_path: Path) -> None:
    assert _messages(tmp_path, MANY) == [
        "bad.toml:3: error QC105: `subsamples = 7` is not allowed, the choice is 1 to 6",
        'bad.toml:4: error QC108: `axes = "x,x,z"` is not a signed permutation, each of x, y and z must stand once,'
        ' with or without a minus sign, write for example "y,-x,z"',
        "bad.toml:5: error QC102: unknown key `coeficients`, did you mean `coefficients`?",
        "bad.toml:7: error QC103: `imu.max_rate_dps` is missing, it has no default (largest Euclidean norm of the"
        " body rate, deg/s), add `max_rate_dps = 573` in [design.att.imu]",
        "bad.toml:8: error QC106: `imu.update_hz = 0` is out of range, it must be greater than 0",
        'bad.toml:9: error QC107: `imu.bias_dps` needs `input = "counts"`, other inputs have units already,'
        " leave it out",
        'bad.toml:12: error QC105: `number.format = "float16"` is not allowed, the choice is "float32", "float64",'
        ' "fixed32" or "fixed16", did you mean "float64"?',
        'bad.toml:13: error QC104: `number.clamp_inputs` must be true or false, not the string "no", write for'
        " example `clamp_inputs = false` in [design.att.number]",
        'bad.toml:15: error QC110: "Int" cannot name a design, it begins the names of C functions: a lower case'
        " letter, then at most 63 of a-z, 0-9 and _, choose another",
        'bad.toml:16: error QC109: `algorithm = "rotation-vektor"` is unknown, it is not in the catalogue, did you'
        ' mean "rotation-vector"?',
        'bad.toml:17: error QC104: `imu.update_hz` must be a number, not the string "100", leave out the quotes',
        'bad.toml:18: error QC107: `number.overflow` does not go with `number.format = "float32"`, only fixed'
        " formats have it, leave it out",
        "bad.toml:20: error QC102: unknown key `extra`, keys of a design stand below a header [design.NAME]",
    ]


def _top(line: str) -> str:
    return GOOD.replace("\n\n[design.att.imu]", f"\n{line}\n[design.att.imu]")


def _imu(line: str) -> str:
    return GOOD.replace("max_rate_dps = 573", f"max_rate_dps = 573\n{line}")


def _counts(line: str) -> str:
    return _imu(line).replace('"rotation-vector"', '"rotation-vector"\ninput = "counts"')


def _end(lines: str) -> str:
    return GOOD + lines


WHOLE = "a list of three rows of three numbers"
MATRIX = "`calibration = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]` in [design.att.imu]"
IDENTIFIER = "it begins the names of C functions: a lower case letter, then at most 63 of a-z, 0-9 and _"
AS_WRITTEN = 'does not go with `form = "as-written"`, the paper\'s form has its own, leave it out'
AXES = (
    "is not a signed permutation, each of x, y and z must stand once, with or without a minus sign,"
    ' write for example "y,-x,z"'
)
DESIGN_WORDS = (
    "algorithm, input, increments, axes, outputs, form, euler, loop, exponential, renormalise, core, multiply,"
    " license, subsamples, coefficients, previous, imu, number, budget"
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
    (_top("outptus = []"), "3: error QC102: unknown key `outptus`, did you mean `outputs`?"),
    (_top("Input = 1"), "3: error QC102: unknown key `Input`, did you mean `input`?"),
    (_top("zzz = 1"), f"3: error QC102: unknown key `zzz`, the keys here are {DESIGN_WORDS}"),
    (
        _top("update_hz = 1"),
        "3: error QC102: unknown key `update_hz`, it belongs elsewhere: write `update_hz = 100` in [design.att.imu]",
    ),
    (
        _end('axes = "x,y,z"\n'),
        '10: error QC102: unknown key `number.axes`, it belongs elsewhere: write `axes = "y,-x,z"` in [design.att]',
    ),
    (
        _top("order = 2"),
        "3: error QC102: unknown key `order`, this algorithm has no such parameter, leave it out or choose another"
        " algorithm",
    ),
    (_top("[design.att.immu]"), "3: error QC102: unknown key `immu`, did you mean `imu`?"),
    (
        _imu("max_rat_dps = 5"),
        "7: error QC102: unknown key `imu.max_rat_dps`, did you mean `imu.max_rate_dps`?",
    ),
    (
        _end('overflw = "wrap"\n'),
        "10: error QC102: unknown key `number.overflw`, did you mean `number.overflow`?",
    ),
    (
        _end("[design.att.budget]\nmultiplies = 3\n"),
        "11: error QC102: unknown key `budget.multiplies`, did you mean `budget.multiply`?",
    ),
    (
        _end("[design.att.budget.cortex-m33]\n"),
        "10: error QC102: unknown key `budget.cortex-m33`, did you mean `budget.cortex-m33f`?",
    ),
    (
        _end("[design.att.budget.host]\nstack = 3\n"),
        "11: error QC102: unknown key `budget.host.stack`, did you mean `budget.host.stack_bytes`?",
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
        _end('[design.b]\nalgorithm = "picard"\nnumber.format = "float32"\nimu = [1]\n'),
        "13: error QC104: `imu` must be a table, not [1], write a header [design.NAME.imu]",
    ),
    (
        _end("[design.att.budget]\nhost = 3\n"),
        "11: error QC104: `budget.host` must be a table, not 3, write a header [design.NAME.budget.host]",
    ),
    (
        GOOD.replace('"rotation-vector"', "3"),
        "2: error QC104: `algorithm` must be a string, not the number 3, write for example"
        ' `algorithm = "rotation-vector"` in [design.att]',
    ),
    (
        _top("subsamples = true"),
        "3: error QC104: `subsamples` must be a whole number, not true, write for example `subsamples = 1` in"
        " [design.att]",
    ),
    (
        _top("subsamples = 3.0"),
        "3: error QC104: `subsamples` must be a whole number, not the number 3.0, write for example"
        " `subsamples = 1` in [design.att]",
    ),
    (
        _top('subsamples = "3"'),
        '3: error QC104: `subsamples` must be a whole number, not the string "3", leave out the quotes',
    ),
    (
        GOOD.replace('"rotation-vector"', '"picard"\norder = []'),
        "3: error QC104: `order` must be a whole number or a string, not the list [], write for example"
        " `order = 1` in [design.att]",
    ),
    (
        _top("form = 1979-05-27"),
        "3: error QC104: `form` must be a string, not 1979-05-27, write for example"
        ' `form = "factored"` in [design.att]',
    ),
    (
        _top('outputs = "dcm"'),
        '3: error QC104: `outputs` must be a list of strings, not the string "dcm", write `outputs = ["dcm"]` in'
        " [design.att]",
    ),
    (
        _top("outputs = 3"),
        "3: error QC104: `outputs` must be a list of strings, not the number 3, write for example"
        ' `outputs = ["quaternion"]` in [design.att]',
    ),
    (
        _top("outputs = [3]"),
        "3: error QC104: `outputs` must be a list of strings, not the number 3, write for example"
        ' `outputs = ["quaternion"]` in [design.att]',
    ),
    (
        _top("axes = [1, 2]"),
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
        _counts('quantum_dps = "1/x"'),
        '8: error QC104: `imu.quantum_dps` must be a number or a string "p/q", not the string "1/x", write for'
        ' example `quantum_dps = "2000/32768"` in [design.att.imu]',
    ),
    (
        _counts("quantum_dps = 1\nbias_dps = [1, 2]"),
        "9: error QC104: `imu.bias_dps` must be a list of three numbers, not the list [1, 2], write for example"
        " `bias_dps = [0.1, -0.2, 0.05]` in [design.att.imu]",
    ),
    (
        _counts("quantum_dps = 1\ncalibration = [[1, 0, 0], [0, 1, 0], [0, 0]]"),
        f"9: error QC104: `imu.calibration` must be {WHOLE}, not the list [[1, 0, 0], [0, 1, 0], [0, 0]], write for"
        f" example {MATRIX}",
    ),
    (
        _counts("quantum_dps = 1\ncalibration = {a = 1}"),
        f"9: error QC104: `imu.calibration` must be {WHOLE}, not a table, write for example {MATRIX}",
    ),
    (
        _end("clamp_inputs = 1\n").replace("float32", "fixed32"),
        "10: error QC104: `number.clamp_inputs` must be true or false, not the number 1, write for example"
        " `clamp_inputs = false` in [design.att.number]",
    ),
    (
        _end("[design.att.budget]\nadd = 1.5\n"),
        "11: error QC104: `budget.add` must be a whole number, not the number 1.5, write for example"
        " `add = 60` in [design.att.budget]",
    ),
    (
        _end("[design.att.budget]\nadd = true\n"),
        "11: error QC104: `budget.add` must be a whole number, not true, write for example"
        " `add = 60` in [design.att.budget]",
    ),
    # QC105: not among the choices
    (
        _top('coefficients = "conning"'),
        '3: error QC105: `coefficients = "conning"` is not allowed, the choice is "taylor", "coning", "expanded" or'
        ' "compressed", did you mean "coning"?',
    ),
    (
        _top('outputs = ["dcm", "quat"]'),
        '3: error QC105: `outputs = "quat"` is not allowed, the choice is "quaternion", "dcm" or "euler"',
    ),
    (
        GOOD.replace('"rotation-vector"', '"picard"\norder = "3"'),
        '3: error QC105: `order = "3"` is not allowed, the choice is 1 to 4 or "closed", write 3 without quotes',
    ),
    (
        _top('euler = "xyz"'),
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
        _imu("max_jerk_dps3 = 0"),
        "7: error QC106: `imu.max_jerk_dps3 = 0` is out of range, it must be greater than 0",
    ),
    (
        _imu("max_angular_acceleration_dps2 = -2.5"),
        "7: error QC106: `imu.max_angular_acceleration_dps2 = -2.5` is out of range, it must be greater than 0",
    ),
    (
        _counts('quantum_dps = "1/0"'),
        '8: error QC106: `imu.quantum_dps = "1/0"` is out of range, it divides by zero',
    ),
    (
        _counts('quantum_dps = "-1/4"'),
        '8: error QC106: `imu.quantum_dps = "-1/4"` is out of range, it must be greater than 0',
    ),
    (
        _end("[design.att.budget]\ndivide = -1\n"),
        "11: error QC106: `budget.divide = -1` is out of range, it must be 0 or more",
    ),
    (
        _end("[design.att.budget.rv32imc]\ninstructions_max = -1\n"),
        "11: error QC106: `budget.rv32imc.instructions_max = -1` is out of range, it must be 0 or more",
    ),
    (
        _top("outputs = []"),
        '3: error QC106: `outputs` is an empty list, write `outputs = ["quaternion"]` in [design.att]',
    ),
    # QC107: keys that do not go together
    (
        _end('rounding = "even"\n'),
        '10: error QC107: `number.rounding` does not go with `number.format = "float32"`, only fixed formats have it,'
        " leave it out",
    ),
    (
        _end("clamp_inputs = false\n"),
        '10: error QC107: `number.clamp_inputs` does not go with `number.format = "float32"`, only fixed formats have'
        " it, leave it out",
    ),
    (
        _end('accumulate = "delta"\n').replace("[design.att.imu]", 'form = "as-written"\n[design.att.imu]'),
        f"11: error QC107: `number.accumulate` {AS_WRITTEN}",
    ),
    (_top('form = "as-written"\nrenormalise = "every"'), f"4: error QC107: `renormalise` {AS_WRITTEN}"),
    (_top('exponential = "taylor"\nform = "as-written"'), f"3: error QC107: `exponential` {AS_WRITTEN}"),
    (
        _top('input = "counts"'),
        '3: error QC107: `input = "counts"` needs `imu.quantum_dps`, a count has no unit, add'
        ' `quantum_dps = "2000/32768"` in [design.att.imu]',
    ),
    (
        _imu("quantum_dps = 1"),
        '7: error QC107: `imu.quantum_dps` needs `input = "counts"`, other inputs have units already, leave it out',
    ),
    (
        _imu("calibration = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
        '7: error QC107: `imu.calibration` needs `input = "counts"`, other inputs have units already, leave it out',
    ),
    (
        GOOD.replace("573", "18000.5"),
        "6: error QC107: `imu.max_rate_dps = 18000.5` turns 180.005 deg in one update, more than half a turn cannot be"
        " told from less, raise `imu.update_hz` to 101 or more",
    ),
    (
        _top('coefficients = "coning"'),
        "3: error QC107: `coefficients` given for one sub-sample, there is no coning term, leave it out",
    ),
    (
        GOOD.replace('"rotation-vector"', '"my.py:f"\nprevious = 2'),
        "3: error QC107: `previous` does not go with `my.py:f`, the function's own decorator says it, leave it out",
    ),
    # QC108: axes
    *((_top(f'axes = "{axes}"'), f'3: error QC108: `axes = "{axes}"` {AXES}') for axes in ("", "x,y", "x,-x,z")),
    *((_top(f'axes = "{axes}"'), f'3: error QC108: `axes = "{axes}"` {AXES}') for axes in ("x,y,w", "--x,y,z")),
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
        _top('outputs = ["dcm", "euler", "dcm"]'),
        '3: error QC112: `outputs = ["dcm", "euler", "dcm"]` names "dcm" more than once, name each once',
    ),
    *(
        (
            _top(f'license = "{name}"'),
            f'3: error QC113: `license = "{shown}"` is not an SPDX identifier, write for example "MIT-0" or'
            ' "Apache-2.0"',
        )
        for name, shown in [("", ""), ("M I T", "M I T"), ("MIT\\n", "MIT?"), ("*/", "*/")]
    ),
]


@pytest.mark.parametrize(("text", "message"), ONE_MISTAKE, ids=[message[:60] for _, message in ONE_MISTAKE])
def test_each_mistake_has_its_message(tmp_path: Path, text: str | bytes, message: str) -> None:
    assert _messages(tmp_path, text) == [f"bad.toml:{message}"]


def test_every_code_has_a_message_here() -> None:
    codes = {match for _, message in ONE_MISTAKE for match in re.findall(r"QC\d+", message)}
    assert codes == {f"QC{number}" for number in range(101, 114)}


def test_a_refused_key_spoils_no_rule_about_it(tmp_path: Path) -> None:
    text = _counts("quantum_dps = true").replace("counts", "count") + 'accumulate = "kahan"\n'
    assert [message.split(",")[0] for message in _messages(tmp_path, text)] == [
        'bad.toml:3: error QC105: `input = "count"` is not allowed',
        'bad.toml:8: error QC104: `imu.quantum_dps` must be a number or a string "p/q"',
        'bad.toml:12: error QC105: `number.accumulate = "kahan"` is not allowed',
    ]


def test_parameters_of_an_unknown_algorithm_are_not_called_unknown(tmp_path: Path) -> None:
    text = GOOD.replace('"rotation-vector"', '"picart"\norder = 9\nsubsamples = "x"')
    assert _messages(tmp_path, text) == [
        'bad.toml:2: error QC109: `algorithm = "picart"` is unknown, it is not in the catalogue, did you mean "picard"?'
    ]


def test_two_wrong_elements_of_a_list_are_two_messages(tmp_path: Path) -> None:
    text = _top('outputs = [\n  "qat",\n  "quaternion",\n  "dcn",\n]')
    assert [message.split(",")[0] for message in _messages(tmp_path, text)] == [
        'bad.toml:3: error QC105: `outputs = "qat"` is not allowed',
        'bad.toml:3: error QC105: `outputs = "dcn"` is not allowed',
    ]
