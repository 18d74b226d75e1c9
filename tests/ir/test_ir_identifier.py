"""Names of an author's in C: Greek letters are spelt out, words of the language are not taken."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from qcone.ir.identifier import KEYWORDS, RESERVED, identifier, is_identifier


@pytest.mark.parametrize(
    ("name", "plain"),
    [
        ("phi_x", "phi_x"),
        ("φ_x", "phi_x"),
        ("Δθ_y", "Deltatheta_y"),
        ("ς", "sigma"),
        ("ώ", "omega"),
        ("élan", "elan"),
        ("_w", "w"),
        ("__A_x", "A_x"),
        ("_", "value"),
        ("数_x", "x"),
        ("数", "value"),
    ],
)
def test_identifier(name: str, plain: str) -> None:
    assert identifier(name) == plain


@given(st.text())
def test_any_text_becomes_an_identifier_of_c(text: str) -> None:
    assert re.fullmatch("[A-Za-z][A-Za-z0-9_]*", identifier(text))


@given(st.from_regex("[A-Za-z][A-Za-z0-9_]{0,20}", fullmatch=True))
def test_plain_names_stay(name: str) -> None:
    assert identifier(name) == name
    assert is_identifier(name) == (name not in KEYWORDS | RESERVED)


@pytest.mark.parametrize("name", ["", "3x", "x y", "φ", "_x", "int", "double", "int32_t", "state", "result", "class"])
def test_what_no_array_may_be_called(name: str) -> None:
    assert not is_identifier(name)
