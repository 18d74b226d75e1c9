"""The C is read back and held against the routine: one changed literal, operator, operand or type is found."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import written

from qcone.backends.c_operands import UnreadableError
from qcone.backends.expected import differences
from qcone.backends.parse_back import read_functions
from qcone.bundle import Bundle
from shipped import DESIGNS, shipped

NAME = "rotation_vector_3_coning_float32"
HISTORY = "rotation_vector_1_previous_2_float32"


def found_in(bundle: Bundle, source: str | None = None, header: str | None = None) -> list[str]:
    header = bundle.header if header is None else header
    source = bundle.source if source is None else source
    return differences(bundle.machine, bundle.facts.number, header, source)


@pytest.mark.parametrize("name", DESIGNS)
def test_shipped_text_is_the_routine(name: str) -> None:
    assert found_in(shipped(name)) == []


@pytest.mark.parametrize("number", ["float32", "float64"])
@pytest.mark.parametrize("loop", ["rolled", "unrolled"])
def test_loops_tables_and_subroutines_are_read_back(tmp_path: Path, loop: str, number: str) -> None:
    assert found_in(written.bundle(tmp_path, loop, number)) == []


TAMPERED = {
    "literal, last bit": (NAME, "0.225F", "0.22500002F"),
    "literal, sign": (NAME, "-0.125F", "0.125F"),
    "literal, type": (NAME, "0.225F", "0.225"),
    "operator": (NAME, "coning_x_1 - coning_x_2", "coning_x_1 + coning_x_2"),
    "operand order": (NAME, "coning_x_1 - coning_x_2", "coning_x_2 - coning_x_1"),
    "operand order of a sum": (NAME, "q_square_1 + q_square_2", "q_square_2 + q_square_1"),
    "operand": (NAME, "g_y * k_z", "g_y * k_y"),
    "type of a value": (NAME, "const float coning_x =", "const double coning_x ="),
    "constness": (NAME, "const float coning_x =", "float coning_x ="),
    "name": (NAME, "const float coning_x =", "const float coning_w ="),
    "target of a write": (NAME, "state->q[1] = q_next_x", "state->q[2] = q_next_x"),
    "input index": (NAME, "= dtheta[4]", "= dtheta[5]"),
    "statement left out": (NAME, "    state->q[3] = q_next_z;\n", ""),
    "statement added": (
        NAME,
        "    state->q[3] = q_next_z;\n",
        "    state->q[3] = q_next_z;\n    state->q[3] = q_next_z;\n",
    ),
    "size of an argument": (NAME, "const float dtheta[9]", "const float dtheta[6]"),
    "const of an argument": (NAME, "const float dtheta[9]", "float dtheta[9]"),
    "function left out": (NAME, "_update(", "_updated("),
    "limit of the start-up": (HISTORY, "state->count < 2", "state->count < 3"),
    "order of the start-up": (HISTORY, "_start_up(state, dtheta);", "_steady(state, dtheta);"),
    "counter not advanced": (HISTORY, "    state->count = state->count + 1;\n", ""),
    "counter set to one": (HISTORY, "state->count = 0;", "state->count = 1;"),
    "history lagging": (HISTORY, "state->previous[3] = previous1_x", "state->previous[3] = previous2_x"),
}


@pytest.mark.parametrize("what", TAMPERED)
def test_one_change_is_found(what: str) -> None:
    name, old, new = TAMPERED[what]
    bundle = shipped(name)
    assert old in bundle.source
    assert found_in(bundle, bundle.source.replace(old, new, 1)) != []


LOOPS = {
    "first turn": ("n = 1; n <= 3", "n = 2; n <= 3"),
    "last turn": ("n = 1; n <= 3", "n = 1; n <= 2"),
    "index": ("term[3 * n - 3]", "term[3 * n - 2]"),
    "table entry": ("1.0F, 0.25F,", "1.0F, 0.125F,"),
    "table size": ("weight[4]", "weight[5]"),
    "argument of the call": ("turned_1, turned_2", "turned_2, turned_1"),
    "part of the result": ("_result[1];", "_result[2];"),
    "body of the subroutine": ("arg1_y * arg2_z", "arg1_z * arg2_y"),
    "result of the subroutine": ("result[0] = value_x", "result[1] = value_x"),
}


@pytest.mark.parametrize("what", LOOPS)
def test_one_change_in_a_loop_or_subroutine_is_found(tmp_path: Path, what: str) -> None:
    old, new = LOOPS[what]
    bundle = written.bundle(tmp_path, "rolled")
    assert old in bundle.source
    assert found_in(bundle, bundle.source.replace(old, new, 1)) != []


def test_difference_names_function_statement_and_both_sides() -> None:
    bundle = shipped(NAME)
    (message,) = found_in(bundle, bundle.source.replace("coning_x_1 - coning_x_2", "coning_x_1 + coning_x_2"))
    assert re.fullmatch(
        rf"{NAME}_update: statement \d+ is `const float coning_x = add\(coning_x_1, coning_x_2\)`, "
        r"the routine has `const float coning_x = subtract\(coning_x_1, coning_x_2\)`",
        message,
    )


def test_missing_and_foreign_functions_are_named() -> None:
    bundle = shipped(NAME)
    assert found_in(bundle, bundle.source.replace("_dcm(", "_matrix(")) == [
        f"{NAME}_dcm: missing from the text",
        f"{NAME}_matrix: not in the program",
    ]


def test_changed_parameters_are_shown() -> None:
    bundle = shipped(NAME)
    (message,) = found_in(bundle, bundle.source.replace("const float dtheta[9]", "const float dtheta[6]"))
    assert message.startswith(
        f"{NAME}_update: `void {NAME}_update({NAME}_state *state, const float dtheta[6])` instead of"
    )


def test_comments_and_blanks_are_not_statements() -> None:
    bundle = shipped(NAME)
    bare = re.sub(r"\n\s*/\*.*?\*/", "", bundle.source, flags=re.DOTALL).replace("    ", " ")
    assert bare != bundle.source
    assert found_in(bundle, bare) == []


UNREADABLE = {
    "while (1) { }": "a statement that is not emitted: While",
    "g(a); a[0] += 1.0F;": "a statement that is not emitted: Assignment",
    "float b; g(a);": "a declaration without a value: b",
    "const float b = a[0] & 2;": "an operator that is not emitted: &",
    "g();": "f: a form that is not emitted: 'NoneType' object has no attribute 'exprs'",
    "for (;;) { }": "a loop that is not emitted",
    "const float b = a[0] * 2.0F + 1.0F;": "an operand that is not emitted: BinaryOp",
    "const float b = (float)1;": "an operand that is not emitted: Cast",
    "const float b = 1.0L * a[0];": "a literal of type long double: 1.0L",
    "float b[2]; b[0] = a[0] + a[1];": "a write of more than one value: b[0]",
    "for (int32_t n = 1; n < 3; ++n) { }": "a loop that is not emitted",
    "for (int32_t n = 3; n <= 3; --n) { }": "a loop that is not emitted",
    "if (a[0] > 2) { g(a); } else { g(a); }": "a condition that is not emitted",
    "const float b = a[1 << 1];": "an index that is not emitted: BinaryOp",
    "return;": "a return that is not emitted",
    "const float b = a[0] % 2;": "an operator that is not emitted: %",
    "const float b = !a[0];": "an operand that is not emitted: UnaryOp",
}


@pytest.mark.parametrize("body", UNREADABLE)
def test_text_no_printer_writes_is_refused_with_a_reason(body: str) -> None:
    source = f"void g(const float a[2]) {{ g(a); }}\nvoid f(const float a[2]) {{ {body} }}\n"
    with pytest.raises(UnreadableError) as caught:
        read_functions("", source)
    assert str(caught.value) == UNREADABLE[body]


def test_text_that_is_not_c_is_refused() -> None:
    with pytest.raises(UnreadableError, match="not C: "):
        read_functions("", "void f( {")


UNSEEN = {
    "#define q_next_w q_next_x": "a directive that is not emitted: #define q_next_w q_next_x",
    "#undef FLT_RADIX": "a directive that is not emitted: #undef FLT_RADIX",
    "#if 0\n    const float b = a[0] + a[1];\n#endif": "a statement under a condition: const float b = a[0] + a[1];",
}


@pytest.mark.parametrize("directive", UNSEEN)
def test_directive_that_would_change_statements_unseen_is_refused(directive: str) -> None:
    bundle = shipped(NAME)
    spoilt = bundle.source.replace("\n{\n", f"\n{{\n{directive}\n", 1)
    assert spoilt != bundle.source
    assert found_in(bundle, spoilt) == [UNSEEN[directive]]


def test_refusal_is_a_difference() -> None:
    bundle = shipped(NAME)
    spoilt = bundle.source.replace("const float e = 0.5F * e_1;", "const float e = 0.5F * e_1 + 0.0F;")
    assert spoilt != bundle.source
    assert found_in(bundle, spoilt) == ["an operand that is not emitted: BinaryOp"]


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        ("    float q[4];", "    double q[4];", f"{NAME}_state: members (double q[4]) instead of (float q[4])"),
        ("{ { 1.0F, 0.0F", "{ { 1.0F, 0.5F", "STATE_INIT: {{1.0F,0.5F,0.0F,0.0F}} instead of {{1.0F,0.0F,0.0F,0.0F}}"),
        ("#include <float.h>", "#define float double", "float: a macro that is not emitted"),
        (f"}} {NAME}_state;", "} other_state;", "not C"),
    ],
)
def test_a_changed_header_is_found(old: str, new: str, found: str) -> None:
    bundle = shipped(NAME)
    assert old in bundle.header
    messages = found_in(bundle, header=bundle.header.replace(old, new, 1))
    assert any(found in message for message in messages), messages


def test_a_changed_return_type_is_found() -> None:
    bundle = shipped(NAME)
    (message,) = found_in(bundle, bundle.source.replace(f"void {NAME}_init(", f"int {NAME}_init("))
    assert message.startswith(f"{NAME}_init: `int {NAME}_init({NAME}_state *state)` instead of `void {NAME}_init(")
