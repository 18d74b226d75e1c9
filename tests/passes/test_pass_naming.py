"""Every value gets a name of its own that C takes and a reviewer can follow."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from real_routines import F, written

from qcone.formats.floating import FLOAT32
from qcone.ir.blocks import cross, dot
from qcone.ir.identifier import KEYWORDS
from qcone.ir.indexed import history, loop
from qcone.ir.labels import named, step
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Call, Operation, Routine, walk
from qcone.ir.subroutine import subroutine
from qcone.passes.lower_float import lower_float
from qcone.passes.naming import name_values
from qcone.pipeline import RESERVED
from qcone.registry import entries


def printed(routine: Routine) -> dict[int, str]:
    """Return the names of the values that are printed, and hold them against every rule."""
    made = name_values(lower_float(routine, FLOAT32), RESERVED)
    statements = list(walk(made.body))
    values = [each.result for each in statements if isinstance(each, Operation) and each.op is not MachineOp.LITERAL]
    used = {arg for each in statements if isinstance(each, Operation | Call) for arg in each.args}
    used |= {each.value for each in statements if hasattr(each, "value")}
    values += [result for each in statements if isinstance(each, Call) for result in each.results if result in used]
    names = [made.names[value] for value in values]
    assert len(names) == len(set(names)), "two values of one name"
    for name in names:
        assert re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name), name
        assert not re.fullmatch(r"t\d+", name), name
    assert not set(names) & (KEYWORDS | set(RESERVED) | {block.name for block in made.blocks})
    return {value: made.names[value] for value in values}


def test_parts_are_numbered_after_what_they_lead_to() -> None:
    routine = written(lambda v, x, s: step("coning = v x (v + v)", "", cross(v, v + v)))
    names = list(printed(routine).values())
    assert {"coning_x", "coning_y", "coning_z", "coning_x_1", "coning_x_2"} <= set(names)
    assert sorted(name for name in names if name.startswith("coning_z")) == ["coning_z", "coning_z_1", "coning_z_2"]


def test_what_leads_nowhere_named_is_called_after_the_place() -> None:
    names = set(printed(written(lambda v, x, s: cross(v, v + v))).values())
    assert {name for name in names if not re.match("v_|x_2$|s_2$", name)} == {f"out_{k}" for k in range(1, 13)}


def test_an_authors_two_equal_names() -> None:
    routine = written(lambda v, x, s: named("twice", x + s) * named("twice", x - s))
    assert {"twice", "twice_2"} <= set(printed(routine).values())


def test_a_name_that_looks_like_a_numbered_one() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        parts = named("phi_1", x + s), named("phi_2", x - s)
        return named("phi", dot(v, v) * x + parts[0] * parts[1])

    names = printed(written(author)).values()
    assert {"phi", "phi_1", "phi_2", "phi_3"} <= set(names)
    assert not [name for name in names if re.fullmatch(r"phi_\d_\d", name)]


@pytest.mark.parametrize("word", ["int", "double", "register", "restrict", "class", "state", "result", "x", "out"])
def test_words_that_are_taken(word: str) -> None:
    names = printed(written(lambda v, x, s: named(word, x + s) * x)).values()
    assert word == "x" or word not in names
    assert any(re.fullmatch(rf"{word}_\d", name) for name in names)


def test_greek_and_underscores() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        return named("Δθ", x + s) * named("_", x - s) * named("__I", x * s)

    assert {"Deltatheta", "value", "I"} <= set(printed(written(author)).values())


def test_loops_share_no_name() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        n_, r = named("n", x + s), history("r", x, 4)
        r[0] = n_
        for n in loop("n", x, 1, 3):
            r[n] = named("term", r[n - 1] * x + s)
        for n in loop("n", x, 1, 3):
            r[n] = named("term", r[n - 1] * s + x)
        return r[3]

    names = set(printed(written(author, rolled=True)).values())
    assert {"term", "term_2", "n_2"} <= names
    assert "n" not in names


def test_the_array_of_a_call_has_a_name_of_its_own() -> None:
    @subroutine
    def third(a):  # type: ignore[no-untyped-def]
        return F(1, 3) * a

    def before(v: Any, x: Any, s: Any) -> Any:
        return named("y_result", x + s) * named("y", third(x))

    def after(v: Any, x: Any, s: Any) -> Any:
        value = named("y", third(x))
        return named("y_result", x + s) * value

    for author, call in ((before, "y_2"), (after, "y")):
        routine = written(author)
        names = printed(routine)
        (result,) = (each.results[0] for each in routine.body if isinstance(each, Call))
        assert names[result] == call
        assert f"{call}_result" not in names.values()


def test_only_used_results_of_a_call_are_named() -> None:
    @subroutine
    def turned(a):  # type: ignore[no-untyped-def]
        return cross(a, a + a)

    routine = written(lambda v, x, s: list(turned(v))[1])
    (call,) = (each for each in routine.body if isinstance(each, Call))
    assert [result in printed(routine) for result in call.results] == [False, True, False]


def test_a_long_chain_without_a_name() -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        for _ in range(1500):
            x = x + s
        return x

    names = printed(written(author))
    assert "out_1500" in names.values()


@given(st.lists(st.sampled_from(["phi", "phi_x", "phi_1", "phi_result", "φ", "int", "t123", "s", "out_1"]), max_size=8))
def test_any_names(chosen: list[str]) -> None:
    def author(v: Any, x: Any, s: Any) -> Any:
        total = x
        for name in chosen:
            total = named(name, total * x + s) if name != "t123" else total + x
        return cross(v, v * total)

    printed(written(author))


def test_names_change_nothing_else() -> None:
    machine = lower_float(written(lambda v, x, s: cross(v, v + v)), FLOAT32)
    assert replace(name_values(machine, RESERVED), names=machine.names) == machine


def test_every_name_of_the_catalogue() -> None:
    """The longest update of all: six increments."""
    from qcone.assembly import assemble, writing_of
    from qcone.design import design_from_options
    from qcone.ir.writing import Series
    from qcone.pipeline import prepare
    from qcone.registry import algorithm_of

    options = {"algorithm": "rotation-vector", "subsamples": "6", "update_hz": "100", "max_rate_dps": "573"}
    design = design_from_options("six", {**options, "number": "float32", "coefficients": "expanded"}, entries())
    series = Series((F(-1, 8),), (F(-1, 48),))
    program = prepare(assemble(algorithm_of(design), design, writing_of(design, series)), design)
    names = printed(program.routine("update"))
    assert len(names) > 150
    assert not [name for name in names.values() if name.startswith("value")]
