"""Loops and calls read back from C: the text as printed is accepted, one changed character is not."""

from __future__ import annotations

from dataclasses import replace

import pytest
from authored import INSIDE, TAYLOR, bundle_of

from qcone.bundle import Bundle
from qcone.errors import CheckError
from qcone.verify import read_back


@pytest.fixture(scope="module")
def rolled(tmp_path_factory: pytest.TempPathFactory) -> Bundle:
    return bundle_of(tmp_path_factory.mktemp("rolled"), TAYLOR, loop="rolled")


@pytest.fixture(scope="module")
def unrolled(tmp_path_factory: pytest.TempPathFactory) -> Bundle:
    return bundle_of(tmp_path_factory.mktemp("unrolled"), TAYLOR, loop="unrolled")


@pytest.fixture(scope="module")
def calling(tmp_path_factory: pytest.TempPathFactory) -> Bundle:
    return bundle_of(tmp_path_factory.mktemp("calling"), INSIDE, loop="rolled")


def test_as_printed(rolled: Bundle, unrolled: Bundle, calling: Bundle) -> None:
    for bundle in (rolled, unrolled, calling):
        read_back(bundle)


def refused(bundle: Bundle, old: str, new: str) -> str:
    """Return what is said of the text with the first `old` replaced."""
    assert old in bundle.source
    with pytest.raises(CheckError) as caught:
        read_back(replace(bundle, source=bundle.source.replace(old, new, 1)))
    return str(caught.value)


FIRST = "for (int32_t n = 1; n <= 2; ++n) {"
INNER = "for (int32_t j = 1; j <= n - 1; ++j) {"
SECOND = "for (int32_t n = 3; n <= 10; ++n) {"

CHANGES = {
    "last": (SECOND, SECOND.replace("10", "9")),
    "first": (SECOND, SECOND.replace("= 3", "= 4")),
    "last of the inner loop": (INNER, INNER.replace("n - 1", "n")),
    "first of the inner loop": (INNER, INNER.replace("j = 1", "j = 0")),
    "comparison": (FIRST, FIRST.replace("<=", "<")),
    "step down": (FIRST, FIRST.replace("++n", "--n")),
    "step by two": (FIRST, FIRST.replace("++n", "n += 2")),
    "another counter compared": (INNER, INNER.replace("j <=", "n <=")),
    "another counter stepped": (INNER, INNER.replace("++j", "++n")),
    "narrow counter": (FIRST, FIRST.replace("int32_t", "short")),
    "outer counter declared before": (FIRST, FIRST.replace("int32_t n = 1", "n = 1")),
    "index of a read": ("= r[4 * n - 4 * j - 4];", "= r[4 * n - 4 * j - 3];"),
    "sign of a counter": ("= r[4 * n - 4 * j - 4];", "= r[4 * n + 4 * j - 4];"),
    "factor of a counter": ("= r[4 * n - 4 * j - 4];", "= r[3 * n - 4 * j - 4];"),
    "counter of a read": ("= a[3 * j];", "= a[3 * n];"),
    "index of a write": ("        r[4 * n + 1] = ", "        r[4 * n + 2] = "),
    "index of a table": ("= inverse[n];", "= inverse[n - 1];"),
    "another array": ("= r[4 * n - 4 * j - 4];", "= total[4 * n - 4 * j - 4];"),
    "a product of counters": ("= inverse[n];", "= inverse[n * n];"),
    "entry of a table": ("0.33333334F", "0.33333337F"),
    "sign of an entry": ("0.33333334F", "-0.33333334F"),
    "type of an entry": ("0.33333334F", "0.33333334"),
    "order of a table": ("1.0F, 0.5F, ", "0.5F, 1.0F, "),
    "missing entry": ("1.0F, 0.5F, ", "1.0F, "),
    "type of a table": ("static const float inverse", "static const double inverse"),
    "table that may change": ("static const float inverse", "static float inverse"),
    "size of a history": ("float r[44];", "float r[45];"),
    "history with a beginning": ("float r[44];", "float r[44] = { 1.0F };"),
    "no loop": (FIRST, "{"),
    "another kind of loop": (FIRST, "while (n <= 2) {"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_one_change_is_caught(rolled: Bundle, name: str) -> None:
    assert refused(rolled, *CHANGES[name]).startswith("att: the C text is not the routine: ")


def test_the_statement_is_named(rolled: Bundle) -> None:
    said = refused(rolled, "= inverse[n];", "= inverse[n - 1];")
    assert "att_update: statement " in said


CALLS = {
    "order of arguments": ("att_rungs(dtheta_x, dtheta_y,", "att_rungs(dtheta_y, dtheta_x,"),
    "another function": (
        "    att_rungs(",
        "    att_rung(",
    ),
    "size of the result": ("_result[3];", "_result[4];"),
    "part of the result": ("_result[1];", "_result[2];"),
    "result of a function": ("    result[0] = ", "    result[1] = "),
    "argument of a function": ("const float arg1_in0,", "const double arg1_in0,"),
    "argument that is read": ("= arg1_in0;", "= arg1_in1;"),
    "loop in a function": ("n <= 3", "n <= 2"),
    "visible function": ("static void att_rungs", "void att_rungs"),
}


@pytest.mark.parametrize("name", CALLS)
def test_one_change_of_a_call_is_caught(calling: Bundle, name: str) -> None:
    assert refused(calling, *CALLS[name]).startswith("att: the C text is not the routine: ")
