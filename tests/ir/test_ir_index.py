"""Component numbers that count with loops: their arithmetic, and the text that C reads."""

from __future__ import annotations

from collections.abc import Mapping

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pycparser import CParser

from qcone.backends.c_operands import affine
from qcone.backends.c_operands import expression as read_index
from qcone.ir.index import FIRST, Index

SMALL = st.integers(-50, 50)
COUNTERS = st.fixed_dictionaries(dict.fromkeys(("n", "j", "k"), SMALL))


@st.composite
def indexes(draw: st.DrawFn) -> Index:
    total = Index(draw(SMALL))
    for name in draw(st.lists(st.sampled_from(["n", "j", "k"]), max_size=4)):
        total = total + Index(0, ((name, 1),)) * draw(SMALL)
    return total


@given(indexes(), indexes(), SMALL, COUNTERS)
def test_arithmetic_is_that_of_the_values(a: Index, b: Index, factor: int, at: Mapping[str, int]) -> None:
    assert (a + b).at(at) == a.at(at) + b.at(at)
    assert (a - b).at(at) == a.at(at) - b.at(at)
    assert (a + factor).at(at) == (factor + a).at(at) == a.at(at) + factor
    assert (a - factor).at(at) == a.at(at) - factor
    assert (factor - a).at(at) == factor - a.at(at)
    assert (a * factor).at(at) == (factor * a).at(at) == a.at(at) * factor


@given(indexes(), COUNTERS)
def test_terms_that_vanish_are_left_out(a: Index, at: Mapping[str, int]) -> None:
    assert (a - a).terms == ()
    assert (a * 0) == FIRST
    assert all(factor for _, factor in a.terms)


@given(indexes(), COUNTERS)
def test_the_text_means_the_index(a: Index, at: Mapping[str, int]) -> None:
    assert eval(str(a), {}, dict(at)) == a.at(at)


@given(indexes())
def test_the_text_is_read_back_from_c(a: Index) -> None:
    tree = CParser().parse(f"int f(void) {{ x[{a}]; }}")
    node = tree.ext[0].body.block_items[0].subscript
    assert read_index(node) == affine({"": a.constant, **dict(a.terms)})


@pytest.mark.parametrize(
    ("index", "text"),
    [
        (Index(), "0"),
        (Index(-3), "-3"),
        (Index(0, (("n", 1),)), "n"),
        (Index(0, (("n", -1),)), "-n"),
        (Index(-1, (("n", 3), ("j", 1))), "3 * n + j - 1"),
        (Index(2, (("n", 4), ("j", -4))), "4 * n - 4 * j + 2"),
        (Index(40, (("j", -4),)), "40 - 4 * j"),
        (Index(0, (("j", -4), ("n", 1))), "n - 4 * j"),
        (Index(-2, (("j", -4),)), "-4 * j - 2"),
    ],
)
def test_text(index: Index, text: str) -> None:
    assert str(index) == text


def test_a_product_of_counters_is_not_affine() -> None:
    n = Index(0, (("n", 1),))
    with pytest.raises(TypeError, match="unsupported operand"):
        n * n  # type: ignore[operator]


@pytest.mark.parametrize("other", [0.5, "1", None])
def test_other_numbers_are_refused(other: object) -> None:
    n = Index(0, (("n", 1),))
    for act in (lambda: n + other, lambda: n - other, lambda: n * other):  # type: ignore[operator]
        with pytest.raises(TypeError, match=r"unsupported operand|can't multiply"):
            act()
