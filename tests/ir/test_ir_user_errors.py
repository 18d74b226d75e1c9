"""What an author gets wrong is said with the file and the line, and is never a traceback."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from authored import IMPORTS, TAYLOR, bundle_of, design_of, paper

from qcone.errors import UsageError
from qcone.pipeline import build

FIRST = IMPORTS.count("\n") + 4
"""The line of `def my_update` in the files of `paper`: imports, two empty lines, the decorator."""
BODY = FIRST + 1
D = "(d,) = dtheta\n"
R0 = D + 'r = history("r", d, 4)\nr[0] = d\n'


def said(folder: Path, text: str, **options: str) -> str:
    """Return the error message of a user's file."""
    with pytest.raises(UsageError) as caught:
        bundle_of(folder, text, **options)
    assert caught.value.exit_code == 2
    return str(caught.value)


MISTAKES = {
    "undefined name": (
        D + "x = F(1, 2) * theta\nreturn q * exp(x)\n",
        BODY + 1,
        "NameError: name 'theta' is not defined",
    ),
    "float": (
        D + "return q * exp(0.5 * d)\n",
        BODY + 1,
        "a constant must be exact: write it as a fraction, F(9, 20), instead of 0.5",
    ),
    "float on the right": (
        D + "return q * exp(d * 0.5)\n",
        BODY + 1,
        "a constant must be exact: write it as a fraction, F(9, 20), instead of 0.5",
    ),
    "division by zero": (D + "\nreturn q * exp(d / 0)\n", BODY + 2, "a division by zero is written here"),
    "fraction of zero": (D + "return q * exp(F(1, 0) * d)\n", BODY + 1, "ZeroDivisionError: Fraction(1, 0)"),
    "exception": (D + "raise RuntimeError('not done yet')\n", BODY + 1, "RuntimeError: not done yet"),
    "assertion": (D + "assert len(dtheta) == 2, 'two samples'\n", BODY + 1, "AssertionError: two samples"),
    "too few samples": ("d1, d2 = dtheta\n", BODY, "ValueError: not enough values to unpack (expected 2, got 1)"),
    "sum of shapes": (D + "return q * exp(d + q)\n", BODY + 1, "TypeError: unsupported operand type(s) for +"),
    "product of vectors": (
        D + "return q * exp(d * d)\n",
        BODY + 1,
        "a scalar or an exact number is needed here, not a vector",
    ),
    "exp of a scalar": (
        D + "return q * exp(dot(d, d))\n",
        BODY + 1,
        "exp takes a rotation vector of three components, not Scalar",
    ),
    "step without a name": (
        D + 'return q * exp(step("cao (8)", "", d))\n',
        BODY + 1,
        "step 'cao (8)': the text must begin with a name and an equals sign, as in 'phi = ...'",
    ),
    "history of another shape": (
        D + 'r = history("r", q, 2)\nr[0] = d\n',
        BODY + 2,
        "history 'r' holds quaternions",
    ),
    "history not written": (
        D + 'r = history("r", d, 2)\nreturn q * exp(r[1])\n',
        BODY + 2,
        "history 'r': entry 1 is read before it is written",
    ),
    "history too far": (D + 'r = history("r", d, 2)\nr[2] = d\n', BODY + 2, "history 'r' has entries 0 to 1, not 2"),
    "history below": (D + 'r = history("r", d, 2)\nr[0] = r[-1]\n', BODY + 2, "history 'r' has entries 0 to 1, not -1"),
    "history twice": (
        D + 'r = history("r", d, 2)\nr = history("r", d, 2)\n',
        BODY + 2,
        "update: the block 'r' is declared twice; give each history its own name",
    ),
    "history like an argument": (
        D + 'r = history("dtheta", d, 2)\n',
        BODY + 1,
        "update: the block 'dtheta' is declared twice; give each history its own name",
    ),
    "history with an odd name": (
        D + 'r = history("state", d, 2)\n',
        BODY + 1,
        "the history 'state' cannot be called so in C: use a letter, then letters, digits and underscores, and no word "
        "of the language",
    ),
    "table too far": (
        D + 't = table("t", d, [F(1, 3)])\nreturn q * exp(t[1] * d)\n',
        BODY + 2,
        "table 't' has entries 0 to 0, not 1",
    ),
    "table below": (
        D + 't = table("t", d, [F(1, 3)])\nreturn q * exp(t[-1] * d)\n',
        BODY + 2,
        "table 't' has entries 0 to 0, not -1",
    ),
    "table of floats": (
        D + 't = table("t", d, [0.1])\n',
        BODY + 1,
        "a constant must be exact: write it as a fraction, F(9, 20), instead of 0.1",
    ),
    "table with an odd name": (
        D + 't = table("int", d, [1])\n',
        BODY + 1,
        "the table 'int' cannot be called so in C: use a letter, then letters, digits and underscores, and no word of "
        "the language",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes(tmp_path: Path, name: str) -> None:
    body, line, what = MISTAKES[name]
    assert said(tmp_path, paper(body)).startswith(f"my_paper.py:{line}: algorithm 'mine': {what}")


LOOPS = {
    "break": (
        R0 + 'for n in loop("n", d, 1, 3):\n    r[n] = r[n - 1]\n    break\nreturn q * exp(r[1])\n',
        "the loop over 'n' is left by break or return; a rolled loop runs to its end: give it other bounds",
    ),
    "return": (
        R0 + 'for n in loop("n", d, 1, 3):\n    return q * rotation(0, d)\n',
        "the loop over 'n' is left by break or return; a rolled loop runs to its end: give it other bounds",
    ),
    "value of a turn": (
        R0 + 'for n in loop("n", d, 1, 3):\n    x = F(1, 3) * r[n - 1]\n    r[n] = x\nreturn q * rotation(0, x + x)\n',
        "what is calculated inside a rolled loop is used outside it: keep it in a history",
    ),
    "counter twice": (
        R0 + 'for n in loop("n", d, 1, 2):\n    for m in loop("n", d, 1, 1):\n        r[n] = d\nreturn q * exp(d)\n',
        "the loop counter 'n' has the name of another counter or block: rename it",
    ),
    "counter like a history": (
        R0 + 'for n in loop("r", d, 1, 2):\n    r[n] = d\nreturn q * exp(d)\n',
        "the loop counter 'r' has the name of another counter or block: rename it",
    ),
    "counter with an odd name": (
        R0 + 'for n in loop("for", d, 1, 2):\n    r[n] = d\nreturn q * exp(d)\n',
        "the loop counter 'for' cannot be called so in C: use a letter, then letters, digits and underscores, and no "
        "word of the language",
    ),
    "counter in a fraction": (
        R0 + 'for n in loop("n", d, 1, 3):\n    r[n] = F(1, n) * d\nreturn q * exp(r[3])\n',
        "TypeError: both arguments should be Rational instances",
    ),
    "counter compared": (
        R0 + 'for n in loop("n", d, 1, 3):\n    r[n] = r[min(n, 2) - 1]\nreturn q * exp(r[3])\n',
        "TypeError: '<' not supported between instances of 'int' and 'Index'",
    ),
}


@pytest.mark.parametrize("name", LOOPS)
def test_loops_that_cannot_be_rolled(tmp_path: Path, name: str) -> None:
    body, what = LOOPS[name]
    message = said(tmp_path, paper(body), loop="rolled")
    assert re.match(r"my_paper\.py:\d+: algorithm 'mine': ", message)
    assert what in message


ANOTHER = "rolled into loops it is another calculation than written out"


TURNS = {
    "carried variable": 'p = d\nfor n in loop("n", d, 1, 3):\n    p = p + F(1, 3) * d\n    r[n] = p\n',
    "carried in a list": 'box = [d]\nfor n in loop("n", d, 1, 3):\n    box[0] = box[0] + d\n    r[n] = box[0]\n',
    "if": 'for n in loop("n", d, 1, 3):\n    r[n] = F(1, 3) * r[n - 1]\n    if n == 2:\n        r[n] = r[n] + d\n',
}


@pytest.mark.parametrize("name", TURNS)
def test_loops_that_say_something_else_rolled(tmp_path: Path, name: str) -> None:
    """Python would run such a loop turn by turn; rolled, its one written turn means another thing."""
    body = f"{R0}{TURNS[name]}return q * rotation(0, r[3])\n"
    assert build(design_of(tmp_path, paper(body), loop="unrolled"))
    assert said(tmp_path, paper(body), loop="rolled").startswith(f"algorithm 'mine': {ANOTHER}: what one turn hands")


def test_written_out_bounds_are_numbers(tmp_path: Path) -> None:
    """A counter of a rolled loop is no bound of one that is written out; kept from a run before, it is refused."""
    body = R0 + 'for n in loop("n", d, 1, bound):\n    r[n] = d\nreturn q * exp(d)\n'
    text = paper(body, before="from qcone.ir.index import Index\nbound = Index(2)\n")
    assert "loop 'n': its bounds must be numbers where loops are written out" in said(tmp_path, text)


# -- what is returned, what is taken -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("result", "given"),
    [
        ("dtheta[0]", "Vector"),
        ("dot(dtheta[0], dtheta[0])", "Scalar"),
        ("None", "NoneType"),
        ("(q, q)", "tuple"),
        ("rotation(0, dtheta[0])", "a rotation"),
        ("exp(dtheta[0])", "a rotation"),
    ],
)
def test_wrong_result(tmp_path: Path, result: str, given: str) -> None:
    assert said(tmp_path, paper(f"return {result}\n")) == (
        f"my_paper.py:{FIRST - 1}: algorithm 'mine' returns {given}, not the new attitude: return a quaternion, "
        "as in `return q * exp(phi)`"
    )


@pytest.mark.parametrize("accumulate", ["delta", "compensated"])
def test_a_plain_product_has_no_increment(tmp_path: Path, accumulate: str) -> None:
    text = paper("(d,) = dtheta\nreturn q * quaternion(1 - F(1, 8) * dot(d, d), F(1, 2) * d)\n")
    assert said(tmp_path, text, accumulate=accumulate) == (
        f"my_paper.py:{FIRST - 1}: algorithm 'mine' returns q (x) r as a plain product, from which no increment is "
        'held apart: return q * rotation(u, v) with r = [1 + u, v], or set accumulate = "standard"'
    )
    assert bundle_of(tmp_path, text, accumulate="standard")


def test_an_argument_that_is_no_block(tmp_path: Path) -> None:
    text = paper("return q * exp(gyro[0])\n").replace("(q, dtheta)", "(q, gyro)")
    assert said(tmp_path, text) == (
        f"my_paper.py:{FIRST - 1}: 'gyro' is not a block of this algorithm; there are: q, interval, dtheta"
    )


def test_the_error_of_a_function_it_calls_is_placed_at_the_call(tmp_path: Path) -> None:
    before = "def helper(v):\n    return missing * v\n"
    text = paper("(d,) = dtheta\nreturn q * exp(helper(d))\n", before=before)
    line = text.splitlines().index("    return q * exp(helper(d))") + 1
    assert said(tmp_path, text) == (f"my_paper.py:{line}: algorithm 'mine': NameError: name 'missing' is not defined")


def test_a_constant_beyond_the_format(tmp_path: Path) -> None:
    text = paper("return q * rotation(0, F(10**39) * dtheta[0])\n")
    assert said(tmp_path, text) == (
        f"the routine 'update': the constant {10**39} is beyond the range of float32: scale the equation"
    )
    assert bundle_of(tmp_path, text, number="float64")


def test_a_root_is_not_emitted(tmp_path: Path) -> None:
    text = paper("(d,) = dtheta\nreturn q * rotation(sqrt(dot(d, d)), d)\n")
    assert said(tmp_path, text) == (
        "the routine 'update' takes a square root, which emitted C does without: set form = \"factored\""
    )


@pytest.mark.parametrize(("word", "value"), [("subsamples", 0), ("subsamples", 13), ("previous", -1), ("previous", 13)])
def test_senseless_numbers_of_samples(tmp_path: Path, word: str, value: int) -> None:
    text = paper("return q * exp(dtheta[0])\n").replace("subsamples=1", f"{word}={value}")
    message = said(tmp_path, text)
    least = 1 if word == "subsamples" else 0
    assert message == f"my_paper.py: algorithm 'mine': {word} = {value} is not between {least} and 12"


# -- the file itself -----------------------------------------------------------------------------------------


def test_a_file_that_is_right(tmp_path: Path) -> None:
    assert bundle_of(tmp_path, TAYLOR).facts.algorithm.name == "mine"


def test_no_such_file(tmp_path: Path) -> None:
    design = design_of(tmp_path, TAYLOR)
    (tmp_path / "my_paper.py").unlink()
    with pytest.raises(UsageError) as caught:
        build(design)
    assert str(caught.value) == (
        f"{tmp_path / 'my_paper.py'}: there is no such file; 'algorithm' takes a path from the design file's folder"
    )


def test_no_such_function(tmp_path: Path) -> None:
    assert said(tmp_path, TAYLOR, function="other") == "my_paper.py: 'other' is not in the file"


@pytest.mark.parametrize("thing", ["def other(q, dtheta):\n    return q\n", "other = 3\n", "other = 'a name'\n"])
def test_not_an_algorithm(tmp_path: Path, thing: str) -> None:
    assert said(tmp_path, f"{TAYLOR}\n{thing}", function="other") == (
        "my_paper.py: 'other' is not an algorithm: decorate the function with @algorithm"
    )


def test_syntax_error(tmp_path: Path) -> None:
    message = said(tmp_path, f"{TAYLOR}\nx = = 3\n")
    assert message.startswith(f"my_paper.py:{TAYLOR.count(chr(10)) + 2}: SyntaxError: invalid syntax")


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("import no_such_module_at_all", "ModuleNotFoundError: No module named 'no_such_module_at_all'"),
        ("from qcone import no_such_name", "ImportError: cannot import name 'no_such_name' from 'qcone'"),
        ("1 / 0", "ZeroDivisionError: division by zero"),
        ("raise SystemExit('over')", "SystemExit: over"),
    ],
)
def test_errors_at_import(tmp_path: Path, line: str, what: str) -> None:
    assert said(tmp_path, f"\n{line}\n{TAYLOR}").startswith(f"my_paper.py:2: {what}")


def test_a_dataclass_of_the_file_finds_its_module(tmp_path: Path) -> None:
    text = (
        "from __future__ import annotations\nfrom dataclasses import dataclass\nfrom typing import ClassVar\n\n"
        "@dataclass\nclass Gains:\n    kind: ClassVar[str] = 'x'\n    first: int = 1\n\n"
    )
    assert bundle_of(tmp_path, text + TAYLOR).facts.algorithm.name == "mine"


def test_nothing_is_left_beside_the_file(tmp_path: Path) -> None:
    bundle_of(tmp_path, TAYLOR)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["my_paper.py", "paper.toml"]
