"""Subroutines: written once, called where the author calls them, a static function in C."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from authored import bundle_of, paper

from qcone.backends.bittrue import Model
from qcone.bundle import Bundle
from qcone.errors import UsageError
from qcone.ir.evaluate import evaluate
from qcone.ir.statement import Call, Routine, walk
from qcone.passes.ranges import rotation_vector_bound
from qcone.targets.build import warnings
from qcone.targets.compiler import Compiler
from qcone.verify import read_back, verify

F = Fraction
CALLED_TWICE = paper(
    """\
    (d,) = dtheta
    first = turned(d, F(1, 2) * d + F(1, 3) * q.vector)
    second = turned(first, d)
    return q * rotation(F(-1, 8) * dot(d, d), second)
    """,
    before='''\
    @subroutine
    def turned(a, b):
        """Give a - (a x b) / 7."""
        return a - F(1, 7) * cross(a, b)
    ''',
)
WRITTEN_OUT = CALLED_TWICE.replace("@subroutine\n", "")


def update_of(bundle: Bundle) -> Routine:
    return bundle.written.routine("update")


def clean(bundle: Bundle, compiler: Compiler) -> None:
    """Hold a bundle against its text, its model and the compiler's warnings."""
    read_back(bundle)
    firmware = {name: file for name, file in bundle.sources.items() if not name.endswith("_run.c")}
    assert warnings(compiler, firmware) == ""
    outcomes = list(verify(bundle, 200, cc=compiler.command[0]))
    assert {(each.status, each.differing_bits) for each in outcomes} == {("ok", 0)}


def test_one_static_function_called_twice(tmp_path: Path, first_compiler: Compiler) -> None:
    bundle = bundle_of(tmp_path, CALLED_TWICE)
    text = bundle.source
    assert len(re.findall(r"^static void att_turned\(", text, re.MULTILINE)) == 1
    assert len(re.findall(r"^    att_turned\(", text, re.MULTILINE)) == 2
    assert text.index("static void att_turned(") < text.index("void att_update(")
    assert "att_turned" not in bundle.header
    clean(bundle, first_compiler)


def test_counts_are_those_of_every_call(tmp_path: Path) -> None:
    called, out = (bundle_of(tmp_path, text).facts.counts["update"] for text in (CALLED_TWICE, WRITTEN_OUT))
    assert called == out
    turned, halves, finish = 2 * (6 + 3), 3 + 3, (3 + 1) + 16 + 4 + 1
    assert called["as-written"].multiply == turned + halves + finish


def test_the_bits_are_those_of_the_same_written_out(tmp_path: Path) -> None:
    random = np.random.default_rng(5)
    inputs, attitude = random.standard_normal((3, 2000)).astype("f4"), random.standard_normal((4, 2000)).astype("f4")
    results = []
    for text in (CALLED_TWICE, WRITTEN_OUT):
        bundle = bundle_of(tmp_path, text)
        state = {"q": attitude.copy()}
        Model(bundle.machine, bundle.facts.number).run("update", state, {"dtheta": inputs})
        results.append(state["q"].view("u4"))
    assert np.array_equal(*results)


def test_the_value_is_that_of_the_same_written_out(tmp_path: Path) -> None:
    inputs = {"q": [F(3, 5), F(1, 7), F(-2, 9), F(4, 11)], "dtheta": [F(1, 13), F(-5, 17), F(7, 19)]}
    called, out = (update_of(bundle_of(tmp_path, text)) for text in (CALLED_TWICE, WRITTEN_OUT))
    assert evaluate(called, inputs).blocks["q"] == evaluate(out, inputs).blocks["q"]
    assert [type(each) for each in walk(called.body)].count(Call) == 2
    assert [type(each) for each in walk(out.body)].count(Call) == 0


def test_names_follow_the_call(tmp_path: Path) -> None:
    text = bundle_of(tmp_path, CALLED_TWICE).source
    assert "    float first_x_result[3];\n" in text
    assert "    const float first_y = first_x_result[1];\n" in text


CLOSURES = paper(
    """\
    (d,) = dtheta
    return q * rotation(F(-1, 8) * dot(d, d), by(F(1, 3))(d) + by(F(1, 5))(d) + by(F(1, 3))(q.vector))
    """,
    before="""\
    def by(factor):
        @subroutine
        def scaled(v):
            return factor * v
        return scaled
    """,
)


def test_two_functions_of_one_name_are_two(tmp_path: Path, first_compiler: Compiler) -> None:
    """A factory makes functions that are called alike: none stands for another, and equal ones are one."""
    bundle = bundle_of(tmp_path, CLOSURES)
    assert re.findall(r"^static void (\w+)\(", bundle.source, re.MULTILINE) == ["att_scaled", "att_scaled_2"]
    q, d = [F(1), F(1, 7), F(2, 7), F(3, 7)], [F(1, 2), F(1, 3), F(1, 5)]
    found = evaluate(update_of(bundle), {"q": q, "dtheta": d}).named
    v = [F(1, 3) * a + F(1, 5) * a + F(1, 3) * b for a, b in zip(d, q[1:], strict=True)]
    assert found["dq_w"] == q[0] * found["a"] - sum(a * b for a, b in zip(q[1:], v, strict=True))
    clean(bundle, first_compiler)


def test_other_shapes_are_another_routine(tmp_path: Path, first_compiler: Compiler) -> None:
    text = paper(
        "(d,) = dtheta\nreturn q * rotation(third(dot(d, d)), third(d) + third(q).vector)\n",
        before="@subroutine\ndef third(x):\n    return F(1, 3) * x\n",
    )
    bundle = bundle_of(tmp_path, text)
    names = re.findall(r"^static void (\w+)\(", bundle.source, re.MULTILINE)
    assert sorted(names) == ["att_third", "att_third_2", "att_third_3"]
    clean(bundle, first_compiler)


NESTED = paper(
    """\
    (d,) = dtheta
    return q * rotation(F(-1, 8) * dot(d, d), twice(d) + once(d))
    """,
    before="""\
    @subroutine
    def once(v):
        return v - F(1, 3) * cross(v, F(1, 7) * v + F(1, 9) * v)

    def inner(factor):
        @subroutine
        def once(v):
            return factor * v
        return once

    @subroutine
    def twice(v):
        return v + inner(F(1, 11))(v)
    """,
)


def test_subroutines_that_call_others(tmp_path: Path, first_compiler: Compiler) -> None:
    """Names stay apart over all levels: the `once` that only `twice` calls is not the `once` of the update."""
    bundle = bundle_of(tmp_path, NESTED)
    names = re.findall(r"^static void (\w+)\(", bundle.source, re.MULTILINE)
    assert names == ["att_once", "att_twice", "att_once_2"]
    q, d = [F(1), F(1, 7), F(2, 7), F(3, 7)], [F(1, 2), F(1, 3), F(1, 5)]
    found = evaluate(update_of(bundle), {"q": q, "dtheta": d}).named
    v = [part * (1 + F(1, 11)) + part for part in d]  # d x d is zero
    assert found["dq_w"] == q[0] * found["a"] - sum(a * b for a, b in zip(q[1:], v, strict=True))
    clean(bundle, first_compiler)


def test_what_a_call_gives_and_nothing_uses(tmp_path: Path, first_compiler: Compiler) -> None:
    text = paper(
        "(d,) = dtheta\nlost = turned(d, q)\nreturn q * rotation(0, turned(q, d).vector)\n",
        before="@subroutine\ndef turned(a, b):\n    return F(1, 3) * a * b if a.shape.value == 4 else F(1, 3) * b\n",
    )
    bundle = bundle_of(tmp_path, text)
    assert bundle.source.count("    att_turned") == 1
    assert "_result[0]" not in bundle.source
    clean(bundle, first_compiler)


def test_arguments_that_are_not_looked_at(tmp_path: Path, first_compiler: Compiler) -> None:
    text = paper(
        "return q * rotation(0, part(q))\n",
        before="@subroutine\ndef part(p):\n    return F(1, 3) * p.vector\n",
    )
    bundle = bundle_of(tmp_path, text)
    assert "    (void)arg1_in0;\n" in bundle.source
    assert "    (void)dtheta;\n" in bundle.source
    assert "(void)arg1_in1" not in bundle.source
    clean(bundle, first_compiler)


def test_signs_and_constants_in_a_subroutine(tmp_path: Path, first_compiler: Compiler) -> None:
    text = paper(
        "(d,) = dtheta\nreturn q * rotation(F(-1, 8) * dot(d, d), F(1, 2) * odd(-d))\n",
        before="@subroutine\ndef odd(v):\n    return -cross(-v, F(1, 3) * (v + v) * 1 * -1) - v\n",
    )
    bundle = bundle_of(tmp_path, text)
    counts = bundle.facts.counts["update"]
    assert counts["as-written"].negate == 9
    assert counts["emitted"].negate == 3 + 3  # before the call, and before the result
    clean(bundle, first_compiler)


def test_names_beside_the_array_of_a_result(tmp_path: Path, first_compiler: Compiler) -> None:
    text = paper(
        "(d,) = dtheta\nv = third(d)\nv_x_result = dot(d, v)\nreturn q * rotation(v_x_result, v)\n",
        before="@subroutine\ndef third(x):\n    return F(1, 3) * x\n",
    )
    clean(bundle_of(tmp_path, text), first_compiler)


# -- what is refused ------------------------------------------------------------------------------------------


def said(folder: Path, body: str, before: str, **options: str) -> str:
    with pytest.raises(UsageError) as caught:
        bundle_of(folder, paper(body, before), **options)
    return str(caught.value)


G = "(d,) = dtheta\nreturn q * rotation(0, g(d))\n"


@pytest.mark.parametrize(
    ("body", "before", "what"),
    [
        (
            "(d,) = dtheta\n@subroutine\ndef g(v):\n    return cross(v, d)\nreturn q * rotation(0, g(F(1, 3) * d))\n",
            "",
            "a subroutine calculates with its arguments only: hand it every quantity as an argument",
        ),
        (
            "(d,) = dtheta\n@subroutine\ndef g(v):\n    return d\nreturn q * rotation(0, g(F(1, 3) * d))\n",
            "",
            "a subroutine calculates with its arguments only",
        ),
        (
            "(d,) = dtheta\nr = history('r', d, 2)\n@subroutine\ndef g(v):\n    r[0] = v\n    return v\n"
            "return q * rotation(0, g(d))\n",
            "",
            "a subroutine calculates with its arguments only",
        ),
        ("return q * rotation(0, g(3))\n", "@subroutine\ndef g(v):\n    return v\n", "g takes scalars, vectors"),
        ("return q * rotation(0, g())\n", "@subroutine\ndef g():\n    return 1\n", "g takes scalars, vectors"),
        (G, "@subroutine\ndef g(v):\n    return None\n", "g returns NoneType, not a scalar, vector, quaternion or"),
        (G, "@subroutine\ndef g(v):\n    return (v, v)\n", "g returns tuple, not a scalar, vector, quaternion or"),
        (G, "@subroutine\ndef g(v):\n    return missing\n", "NameError: name 'missing' is not defined"),
        (G, "@subroutine\ndef g(v):\n    return g(v)\n", "RecursionError: maximum recursion depth exceeded"),
    ],
    ids=["captured", "handed through", "history", "number", "nothing", "no result", "two", "undefined", "recursive"],
)
def test_refused(tmp_path: Path, body: str, before: str, what: str) -> None:
    message = said(tmp_path, body, before)
    assert re.match(r"my_paper\.py:\d+: algorithm 'mine': ", message)
    assert what in message


def test_a_loop_is_not_left_inside(tmp_path: Path) -> None:
    before = '@subroutine\ndef g(v):\n    for n in loop("n", v, 0, 2):\n        return v + v\n'
    assert "the loop over 'n' is left by break or return" in said(tmp_path, G, before, loop="rolled")


@pytest.mark.parametrize("name", ["update", "init", "quaternion"])
def test_a_name_that_is_a_function_of_the_design(tmp_path: Path, name: str) -> None:
    message = said(
        tmp_path, G.replace("g(", f"{name}_("), f"@subroutine\ndef {name}(v):\n    return v + v\n{name}_ = {name}\n"
    )
    assert message == f"the subroutine '{name}' has the name of another function: rename it"


@pytest.mark.parametrize(
    ("name", "function"),
    [("state", "def state(v):\n    return v\ng = subroutine(state)\n"), ("<lambda>", "g = subroutine(lambda v: v)\n")],
)
def test_a_name_that_c_cannot_hold(tmp_path: Path, name: str, function: str) -> None:
    message = said(tmp_path, G, function)
    assert message.endswith(f"the subroutine '{name}' cannot be called so in C: make it a function with a plain name")


def test_no_exponential_of_an_argument_without_a_bound(tmp_path: Path) -> None:
    """Its range decides the polynomial: hidden in a subroutine it must not be overlooked."""
    text = (
        paper(
            "return q * rotation(0, F(1, 3) * dtheta[0])\n",
            before="@subroutine\ndef g(v):\n    return exp(v).v\n",
        )
        + "\n\n@my_update.factored\ndef form(q, dtheta):\n    return q * rotation(0, g(dtheta[0]))\n"
    )
    with pytest.raises(UsageError, match="g: a subroutine takes exp of an argument for which no bound is known"):
        bundle_of(tmp_path, text)


def test_a_routine_without_exponential_has_no_bound(tmp_path: Path) -> None:
    assert rotation_vector_bound(update_of(bundle_of(tmp_path, CALLED_TWICE))) is None
