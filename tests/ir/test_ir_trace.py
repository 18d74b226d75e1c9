"""From an author's file to a routine: names from local variables, source lines and steps as headings."""

from __future__ import annotations

from pathlib import Path

import pytest
from authored import bundle_of, paper

from qcone.backends.c_source import functions
from qcone.bundle import Bundle
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Routine


def update_of(folder: Path, body: str, **options: str) -> Routine:
    return bundle_of(folder, paper(body), **options).written.routine("update")


def headed(routine: Routine) -> list[str]:
    """Return the headings in order, each once for a run of statements under it."""
    found: list[str] = []
    for statement in routine.body:
        step = routine.steps[statement.step]
        text = step.text + (f" [{step.equation}]" if step.equation else "")
        if not found or found[-1] != text:
            found.append(text)
    return found


FINISH = [
    "q_square = |q|^2",
    "e = (1 - |q|^2)/2 [renormalisation, folded into the scalar part]",
    "a = u + e",
    "dq = q (x) [a, v] [cao (14)]",
    "q_next = q + dq",
    "store",
]


def test_source_lines_are_headings(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        # a comment between
        half = F(1, 2) * d
        u = F(-1, 2) * dot(
            half,  half
        )
        return q * rotation(u, half - F(1, 24) * dot(d, d) * half)
    """
    assert headed(update_of(tmp_path, body)) == [
        "attitude and input",
        "half = F(1, 2) * d",
        "u = F(-1, 2) * dot( half, half )",
        "return q * rotation(u, half - F(1, 24) * dot(d, d) * half)",
        *FINISH,
    ]


def test_a_step_takes_the_lines_before_it(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        half = F(1, 2) * d
        v = step("v = half of it", "paper (3)", half - F(1, 24) * dot(d, d) * half)
        u = F(-1, 2) * dot(half, half)
        return q * rotation(u, v)
    """
    assert headed(update_of(tmp_path, body)) == [
        "attitude and input",
        "v = half of it [paper (3)]",
        "u = F(-1, 2) * dot(half, half)",
        *FINISH,
    ]


def test_the_exponential_does_not_take_the_lines_before_it(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        phi = F(3, 2) * d - F(1, 2) * d
        return q * exp(phi)
    """
    found = headed(update_of(tmp_path, body))
    assert found[:3] == ["attitude and input", "phi = F(3, 2) * d - F(1, 2) * d", "phi_square = |phi|^2"]


def test_a_plain_product_takes_its_own_line_only(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        r = quaternion(1 - F(1, 8) * dot(d, d), F(1, 2) * d)
        return q * r
    """
    assert headed(update_of(tmp_path, body, accumulate="standard")) == [
        "attitude and input",
        "r = quaternion(1 - F(1, 8) * dot(d, d), F(1, 2) * d)",
        "q_next = q (x) r",
        "store",
    ]


def test_local_variables_are_names(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        half = F(1, 2) * d
        size = dot(half, half)
        u = named("small", F(-1, 2) * size)
        turn = quaternion(1 + u, half)
        count = 3
        return q * rotation(u, turn.vector)
    """
    routine = update_of(tmp_path, body)
    names = set(routine.names.values())
    assert {"half_x", "half_y", "half_z", "size", "small", "turn_w", "dtheta_x", "q_w", "q_next_z"} <= names
    assert not {"u", "d_x", "turn_x", "count"} & names


def test_a_quantity_keeps_the_name_of_its_step(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        mine = step("phi = theta + 0", "cao (8)", d + 0 * d)
        return q * exp(mine)
    """
    names = set(update_of(tmp_path, body).names.values())
    assert "phi_x" in names
    assert "mine_x" not in names


def test_greek_names_are_spelt_out_in_c(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        φ = F(3, 2) * d - F(1, 2) * d
        return q * exp(φ)
    """
    made = bundle_of(tmp_path, paper(body))
    assert "const float phi_x = " in made.source
    assert "/* φ = F(3, 2) * d - F(1, 2) * d */" in made.source


def test_a_comment_in_the_source_does_not_end_that_of_c(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        v = F(1, 2) * d + dot(d, d) * d if d else None  # */ not the end /* nor a beginning
        u = F(1, 3) * dot(
            d,  # */
            d,
        )
        return q * rotation(u, v)
    """
    made = bundle_of(tmp_path, paper(body))
    assert "/* u = F(1, 3) * dot( d, # * / d, ) */" in made.source


def test_a_heading_over_a_loop_is_that_of_its_body(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        r = history("r", d, 4)
        r[0] = d
        for n in loop("n", d, 1, 3):
            r[n] = F(1, 3) * cross(d, r[n - 1])
        return q * rotation(F(-1, 8) * dot(d, d), r[3])
    """
    text = bundle_of(tmp_path, paper(body), loop="rolled").source
    assert "\n    for (int32_t n = 1; n <= 3; ++n) {\n        /* r[n] = F(1, 3) * cross(d, r[n - 1]) */\n" in text
    assert "/* q_square = |q|^2 */\n    for" not in text


def test_a_step_covers_a_whole_loop(tmp_path: Path) -> None:
    body = """\
        (d,) = dtheta
        r = history("r", d, 4)
        r[0] = d
        for n in loop("n", d, 1, 3):
            r[n] = step("r[n] = d x r / 3".replace("[n]", "_n"), "paper (5)", F(1, 3) * cross(d, r[n - 1]))
        return q * rotation(F(-1, 8) * dot(d, d), r[3])
    """
    made = bundle_of(tmp_path, paper(body), loop="rolled")
    assert "/* r_n = d x r / 3   [paper (5)] */" in made.source


def test_one_return_line_with_everything(tmp_path: Path) -> None:
    routine = update_of(tmp_path, "return q * exp(dtheta[0])\n")
    assert headed(routine)[0:2] == ["attitude and input", "phi_square = |phi|^2"]


AXES = "y,-x,z"


def test_turned_axes_are_read_as_the_sensor_has_them(tmp_path: Path) -> None:
    routine = update_of(tmp_path, "return q * exp(dtheta[0])\n", axes=AXES)
    by_name = {name: value for value, name in routine.names.items()}
    definitions = {each.result: each for each in routine.body if isinstance(each, Operation)}
    assert {by_name[f"dtheta_{axis}"] for axis in "xyz"} <= set(definitions)
    assert [definitions[by_name[f"dtheta_{axis}"]].place.index.constant for axis in "xyz"] == [0, 1, 2]
    assert any("along the sensor's axes: body x, y, z = " in step.text for step in routine.steps)
    negated = [each for each in definitions.values() if each.op is RealOp.NEGATE]
    assert [each.args for each in negated] == [(by_name["dtheta_x"],)]


@pytest.mark.parametrize("form", ["as-written", "factored"])
def test_the_forms_of_an_algorithm(tmp_path: Path, form: str) -> None:
    """`factored` gives firmware another form; the paper's own form stays what was decorated first."""
    text = paper("return q * rotation(0, F(1, 3) * dtheta[0])\n") + (
        "\n\n@my_update.factored\ndef form(q, dtheta):\n    return q * rotation(0, F(1, 7) * dtheta[0])\n"
    )
    made: Bundle = bundle_of(tmp_path, text, form=form)
    constants = {str(each.exact) for each in made.machine.routine("update").body if isinstance(each, Operation)}
    assert ("1/3" in constants, "1/7" in constants) == (form == "as-written", form == "factored")


def test_printed_names_are_those_of_the_routine(tmp_path: Path) -> None:
    made = bundle_of(tmp_path, paper("(d,) = dtheta\nhalf = F(1, 2) * d\nreturn q * rotation(0, half)\n"))
    (update,) = (each for each in functions(made.machine, made.facts.number) if each.routine == "update")
    assert "    const float half_x = 0.5F * dtheta_x;" in update.body
