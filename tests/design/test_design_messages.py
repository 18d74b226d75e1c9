"""All mistakes of a design file come at once, each on its line, and none of them breeds another."""

# Messages stand whole on their lines, so that a search finds them.

from __future__ import annotations

from pathlib import Path

from bad_files import counts, messages, top
from fake_catalogue import GOOD

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
    assert messages(tmp_path, MANY) == [
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


def test_a_refused_key_spoils_no_rule_about_it(tmp_path: Path) -> None:
    text = counts("quantum_dps = true").replace("counts", "count") + 'accumulate = "kahan"\n'
    assert [message.split(",")[0] for message in messages(tmp_path, text)] == [
        'bad.toml:3: error QC105: `input = "count"` is not allowed',
        'bad.toml:8: error QC104: `imu.quantum_dps` must be a number or a string "p/q"',
        'bad.toml:12: error QC105: `number.accumulate = "kahan"` is not allowed',
    ]


def test_parameters_of_an_unknown_algorithm_are_not_called_unknown(tmp_path: Path) -> None:
    text = GOOD.replace('"rotation-vector"', '"picart"\norder = 9\nsubsamples = "x"')
    assert messages(tmp_path, text) == [
        'bad.toml:2: error QC109: `algorithm = "picart"` is unknown, it is not in the catalogue, did you mean "picard"?'
    ]


def test_two_wrong_elements_of_a_list_are_two_messages(tmp_path: Path) -> None:
    text = top('outputs = [\n  "qat",\n  "quaternion",\n  "dcn",\n]')
    assert [message.split(",")[0] for message in messages(tmp_path, text)] == [
        'bad.toml:3: error QC105: `outputs = "qat"` is not allowed',
        'bad.toml:3: error QC105: `outputs = "dcn"` is not allowed',
    ]


def test_a_refused_parameter_breaks_no_rule_of_its_algorithm(tmp_path: Path) -> None:
    text = top('subsamples = 7\ncoefficients = "coning"')
    assert messages(tmp_path, text) == [
        "bad.toml:3: error QC105: `subsamples = 7` is not allowed, the choice is 1 to 6"
    ]


def test_windows_line_ends_do_not_move_the_lines(tmp_path: Path) -> None:
    text = (GOOD + "axis = 1\n\n# comment\n[design.att.budget]\nhost = { bytes = 1 }\nadd = -1\n").replace("\n", "\r\n")
    assert [message[:24] for message in messages(tmp_path, text)] == [
        "bad.toml:10: error QC102",
        "bad.toml:14: error QC102",
        "bad.toml:15: error QC106",
    ]


C99_KEYWORDS = """
auto break case char const continue default do double else enum extern float for goto if inline int long
register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
"""


def test_no_keyword_of_c99_names_a_design(tmp_path: Path) -> None:
    words = C99_KEYWORDS.split()
    assert len(words) == 34
    text = "\n".join(GOOD.replace("design.att", f"design.{word}") for word in words)
    assert [message.split(": ", 1)[1] for message in messages(tmp_path, text)] == [
        f'error QC110: "{word}" cannot name a design, it is a C keyword, write for example {word}_1' for word in words
    ]
