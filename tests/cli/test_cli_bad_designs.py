"""Designs that cannot be built: one clear message for each mistake, exit code 2, nothing written."""

from __future__ import annotations

from pathlib import Path

import pytest
from given import GOOD, everything

HEAD = """\
[design.mine]
algorithm = "rotation-vector"
imu = { update_hz = 100, max_rate_dps = 573 }
number = { format = "float32" }
"""

SEVERAL = """\
[design.one]
algorithm = "rotation-vector"
subsamples = 7
coeficients = "coning"
imu = { update_hz = 100 }
number = { format = "float31" }

[design.two]
algorithm = "rotation-vektor"
imu = { update_hz = -1, max_rate_dps = 573 }
number = { format = "float32" }
"""

MANY = """\
bad.toml:3: error QC105: `subsamples = 7` is not allowed, the choice is 1 to 6
bad.toml:4: error QC102: unknown key `coeficients`, did you mean `coefficients`?
bad.toml:5: error QC103: `imu.max_rate_dps` is missing, it has no default (largest Euclidean norm of the body rate, \
deg/s), add `max_rate_dps = 573` in [design.one.imu]
bad.toml:6: error QC105: `number.format = "float31"` is not allowed, the choice is "float32", "float64", "fixed32" \
or "fixed16", did you mean "float32"?
bad.toml:9: error QC109: `algorithm = "rotation-vektor"` is unknown, it is not in the catalogue, did you mean \
"rotation-vector"?
bad.toml:10: error QC106: `imu.update_hz = -1` is out of range, it must be greater than 0
"""

NO_PAIR = (
    "error QC107: coefficients belong to two or more sub-samples, with subsamples = 1 there is no pair of increments "
    "to weigh, leave the key out\n"
)

FILES = {
    "several mistakes at once": (SEVERAL, MANY),
    "unknown key": (
        HEAD + "subsample = 3\n",
        "bad.toml:5: error QC102: unknown key `subsample`, did you mean `subsamples`?\n",
    ),
    "seven sub-samples": (
        HEAD + "subsamples = 7\n",
        "bad.toml:5: error QC105: `subsamples = 7` is not allowed, the choice is 1 to 6\n",
    ),
    "more than half a turn": (
        HEAD.replace("573", "18001"),
        "bad.toml:3: error QC107: `imu.max_rate_dps = 18001` turns 180.01 deg in one update, more than half a turn "
        "cannot be told from less, raise `imu.update_hz` to 101 or more\n",
    ),
    "|phi| over pi by the coning term": (
        HEAD.replace("573", "17990") + "subsamples = 3\n",
        "bad.toml:1: error QC204: design 'mine': the rotation vector may reach 5.11 rad in one update, and an attitude "
        "update holds only below pi: raise update_hz or lower max_rate_dps\n",
    ),
    "coefficients for one sub-sample": (HEAD + 'coefficients = "coning"\n', f"bad.toml:5: {NO_PAIR}"),
    "coefficients for one sub-sample with previous": (
        HEAD + 'previous = 2\ncoefficients = "taylor"\n',
        f"bad.toml:6: {NO_PAIR}",
    ),
    "rates asked of increments": (
        HEAD.replace("rotation-vector", "adams-moulton-4"),
        "bad.toml:1: error QC207: design 'mine': adams-moulton-4-runge-kutta-4 takes rates, the design has input = "
        '"increment", it evaluates the rate at instants, the newest at the end of the interval, set input = "rate" and '
        "give it rates (replay: --input rate)\n",
    ),
    "no design": (
        "",
        "bad.toml:1: error QC111: there is no design in this file, start with a header such as [design.my_attitude]\n",
    ),
}


@pytest.mark.parametrize("words", [("generate",), ("generate", "--check"), ("generate", "--diff"), ("verify",)])
@pytest.mark.parametrize("what", FILES)
def test_bad_design(run, tmp_path: Path, what: str, words: tuple[str, ...]) -> None:
    text, message = FILES[what]
    (tmp_path / "bad.toml").write_text(text)
    before = everything(tmp_path)
    result = run(*words, "bad.toml")
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", message)
    assert everything(tmp_path) == before


def test_mistakes_of_all_kinds_in_one_run_and_nothing_of_the_good_design(run, tmp_path: Path) -> None:
    (tmp_path / "bad.toml").write_text(GOOD + "\n" + SEVERAL)
    result = run("generate", "bad.toml")
    assert result.exit_code == 2
    assert len(result.stderr.splitlines()) == 6
    assert result.stderr.startswith("bad.toml:10: error QC105: ")
    assert sorted(everything(tmp_path)) == ["bad.toml"]


def test_bad_design_in_the_second_file(run, good: Path, tmp_path: Path) -> None:
    (tmp_path / "bad.toml").write_text(HEAD + "subsamples = 7\n")
    result = run("generate", "good.toml", "bad.toml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert sorted(everything(tmp_path)) == ["bad.toml", "good.toml"]


def test_mistake_only_building_shows_in_the_second_design(run, tmp_path: Path) -> None:
    """The first design is built, compiled and compared before the second one fails: still nothing is written."""
    (tmp_path / "two.toml").write_text(GOOD + HEAD.replace("573", "17990") + "subsamples = 3\n")
    result = run("generate", "two.toml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "QC204" in result.stderr
    assert sorted(everything(tmp_path)) == ["two.toml"]


USER = """\
from qcone import F, Source, algorithm, cross, exp

SOURCE = Source("cao", "(12)")


@algorithm("turned", source=SOURCE, subsamples=2)
def turned(q, dtheta):
    return exp(dtheta[0])


@algorithm("vector", source=SOURCE, subsamples=2)
def vector(q, dtheta):
    return dtheta[0] + dtheta[1]


@algorithm("nothing", source=SOURCE, subsamples=2)
def nothing(q, dtheta):
    q * exp(dtheta[0])


@algorithm("undefined", source=SOURCE, subsamples=2)
def undefined(q, dtheta):
    a, b = dtheta
    return q * exp(a + b + corss(a, b))


@algorithm("other-block", source=SOURCE, subsamples=2)
def other_block(q, velocity):
    return q * exp(velocity[0])


@algorithm("short", source=SOURCE, subsamples=2)
def short(q, dtheta):
    a, b, c = dtheta
    return q * exp(a + b + c)


@algorithm("divided", source=SOURCE, subsamples=2)
def divided(q, dtheta):
    return q * exp(F(1, 0) * dtheta[0])


def plain(q, dtheta):
    return q * exp(dtheta[0])


@algorithm("good", source=SOURCE, subsamples=2)
def good(q, dtheta):
    a, b = dtheta
    return q * exp(a + b + F(2, 3) * cross(a, b))
"""

RETURN = "not the new attitude: return a quaternion, as in `return q * exp(phi)`"
WRONG = {
    "turned": f"my.py:6: algorithm 'turned' returns a rotation, {RETURN}\n",
    "vector": f"my.py:11: algorithm 'vector' returns Vector, {RETURN}\n",
    "nothing": f"my.py:16: algorithm 'nothing' returns NoneType, {RETURN}\n",
    "undefined": "my.py:24: algorithm 'undefined': NameError: name 'corss' is not defined\n",
    "other_block": "my.py:27: 'velocity' is not a block of this algorithm; there are: q, interval, dtheta\n",
    "short": "my.py:34: algorithm 'short': ValueError: not enough values to unpack (expected 3, got 2)\n",
    "divided": "my.py:40: algorithm 'divided': ZeroDivisionError: Fraction(1, 0)\n",
    "plain": "my.py: 'plain' is not an algorithm: decorate the function with @algorithm\n",
    "absent": "my.py: 'absent' is not in the file\n",
}


@pytest.mark.parametrize("name", WRONG)
def test_mistake_in_a_user_s_algorithm(run, tmp_path: Path, name: str) -> None:
    (tmp_path / "my.py").write_text(USER)
    (tmp_path / "my.toml").write_text(HEAD.replace("rotation-vector", f"my.py:{name}"))
    result = run("generate", "my.toml")
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", WRONG[name])
    assert sorted(everything(tmp_path)) == ["my.py", "my.toml"]


BROKEN = {
    "import nosuchmodule\n": "my.py:1: ModuleNotFoundError: No module named 'nosuchmodule'\n",
    "x = 1\ndef f(:\n": "my.py:2: SyntaxError: ",
    "x = 1\n\nraise ValueError('no luck')\n": "my.py:3: ValueError: no luck\n",
}


@pytest.mark.parametrize("text", BROKEN)
def test_user_s_file_that_does_not_run(run, tmp_path: Path, text: str) -> None:
    (tmp_path / "my.py").write_text(text)
    (tmp_path / "my.toml").write_text(HEAD.replace("rotation-vector", "my.py:good"))
    result = run("generate", "my.toml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith(BROKEN[text])
    assert result.stderr.count("\n") == 1
    assert sorted(everything(tmp_path)) == ["my.py", "my.toml"]


def test_user_s_file_that_is_not_there(run, tmp_path: Path) -> None:
    (tmp_path / "my.toml").write_text(HEAD.replace("rotation-vector", "your.py:good"))
    result = run("generate", "my.toml")
    assert result.exit_code == 2
    assert result.stderr == "your.py: there is no such file; 'algorithm' takes a path from the design file's folder\n"


def test_user_s_algorithm_that_is_right(run, tmp_path: Path) -> None:
    (tmp_path / "my.py").write_text(USER)
    (tmp_path / "my.toml").write_text(HEAD.replace("rotation-vector", "my.py:good"))
    assert run("generate", "my.toml").exit_code == 0
    assert (tmp_path / "c_out" / "mine" / "src" / "mine.c").is_file()
    assert not (tmp_path / "__pycache__").exists()


OPTIONS = {
    ("counts", "rotation-vector", "--subsamples", "7"): (
        "--subsamples: error QC105: `--subsamples 7` is not allowed, the choice is 1 to 6\n"
    ),
    ("counts", "rotation-vektor"): (
        "--algorithm: error QC109: `--algorithm rotation-vektor` is unknown, it is not in the catalogue, did you mean "
        '"rotation-vector"?\n'
    ),
    ("counts", "rotation-vector", "--coefficients", "coning"): f"--coefficients: {NO_PAIR}",
    ("counts", "rotation-vector", "--previous", "2", "--coefficients", "taylor"): f"--coefficients: {NO_PAIR}",
    ("counts", "rotation-vector", "--form", "exact"): "--form exact: choose as-written or factored\n",
    ("counts", "--against", "cao"): "--against cao: there is no table of that paper; choose xu2019\n",
    ("counts", "rotation-vector", "--against", "xu2019"): (
        "--against xu2019: its table is for subsamples = 3; give --subsamples 3\n"
    ),
    ("counts", "picard", "--against", "xu2019"): "--against xu2019: its table has no column for 'picard'\n",
    ("counts", "--subsamples", "3"): "--subsamples 3: say which algorithm it is for\n",
    ("counts", "--form", "factored"): "--form factored: say which algorithm it is for\n",
    ("counts", "picard", "--design", "good"): "--design good: say which design file it is in\n",
    ("counts", "good.toml", "--subsamples", "3"): "--subsamples 3: the design file decides; leave the option out\n",
    ("counts", "good.toml", "--design", "goood"): (
        "--design goood: no such design in good.toml; did you mean 'good'?\n"
    ),
    ("generate", "good.toml", "--design", "other"): "--design other: no such design in good.toml; there are: good\n",
    ("generate", "absent.toml"): "cannot read design file absent.toml: No such file or directory\n",
    ("verify", "good.toml", "--target", "hst"): "--target hst: unknown target; did you mean 'host'?\n",
    ("verify", "good.toml", "--target", "cortex-m5"): "--target cortex-m5: unknown target; did you mean 'cortex-m4'?\n",
    ("verify", "good.toml", "--target", "abacus"): (
        "--target abacus: unknown target; the targets are: host, cortex-m0, cortex-m0plus, cortex-m3, cortex-m4, "
        "cortex-m4f, cortex-m7f, cortex-m33f, rv32imc, rv32imfc, powerpc\n"
    ),
    ("verify", "good.toml", "--cflags", "'-O2"): '--cflags "\'-O2": No closing quotation\n',
}


@pytest.mark.parametrize("words", OPTIONS, ids=" ".join)
def test_bad_option(run, good: Path, tmp_path: Path, words: tuple[str, ...]) -> None:
    result = run(*words)
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", OPTIONS[words])
    assert sorted(everything(tmp_path)) == ["good.toml"]


CLICK = {
    ("counts", "--frm", "x"): "No such option '--frm'.",
    ("verify", "good.toml", "--rows", "0"): "0 is not in the range x>=1.",
    ("verify", "good.toml", "--rows", "many"): "'many' is not a valid integer range.",
    ("generate",): "Missing argument 'DESIGN.toml...'.",
    ("lst",): "No such command 'lst'.",
}


@pytest.mark.parametrize("words", CLICK, ids=" ".join)
def test_bad_words(run, words: tuple[str, ...]) -> None:
    result = run(*words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert CLICK[words] in result.stderr


def test_what_whole_designs_show_is_said_of_all_of_them(run, tmp_path: Path) -> None:
    second = HEAD.replace("mine", "other").replace("rotation-vector", "runge-kutta-4")
    dear = GOOD + "budget = { multiply = 3, add = 3 }\n"
    (tmp_path / "bad.toml").write_text(f"{HEAD.replace('float32', 'fixed32')}loop = 'rolled'\n{second}\n{dear}")
    result = run("generate", "bad.toml")
    codes = [line.split(": error ")[1][:5] for line in result.stderr.splitlines()]
    assert (result.exit_code, result.stdout, codes) == (2, "", ["QC201", "QC207"])
    (tmp_path / "dear.toml").write_text(dear)
    result = run("generate", "dear.toml")
    over = "38 of 'multiply', over the budget of 3 and 24 of 'add', over the budget of 3"
    assert (result.exit_code, result.stderr.partition(" takes ")[2].partition(": choose")[0]) == (1, over)


def test_budget_exceeded_is_a_failed_check(run, tmp_path: Path) -> None:
    (tmp_path / "dear.toml").write_text(GOOD + "budget = { multiply = 30, add = 500 }\n")
    for words in (("generate",), ("generate", "--check"), ("verify",), ("counts",)):
        result = run(*words, "dear.toml")
        assert (result.exit_code, result.stdout) == (1, "")
        assert result.stderr == (
            "design 'good': an update takes 38 of 'multiply', over the budget of 30: choose a cheaper algorithm or "
            "raise the budget\n"
        )
    assert sorted(everything(tmp_path)) == ["dear.toml"]


def test_every_operation_can_be_budgeted(run, tmp_path: Path) -> None:
    kinds = ("multiply", "divide", "add", "subtract", "negate", "square_root", "trigonometric")
    budget = ", ".join(f"{kind} = 500" for kind in kinds)
    (tmp_path / "fair.toml").write_text(GOOD + f"budget = {{ {budget} }}\n")
    assert run("generate", "fair.toml").exit_code == 0
