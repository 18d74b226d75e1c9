"""Linear systems over the rationals."""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817  as everywhere

import pytest

from qcone.elimination import rank, solve

SQUARE = [[F(0), F(2), F(1)], [F(1), F(-1), F(0)], [F(3), F(0), F(-2)]]


def test_a_system_is_solved_exactly() -> None:
    wanted = [F(1, 3), F(-2, 7), F(5)]
    right = [sum((a * x for a, x in zip(row, wanted, strict=True)), F(0)) for row in SQUARE]
    assert solve(SQUARE, right) == wanted


def test_a_singular_system_has_no_solution() -> None:
    with pytest.raises(ZeroDivisionError):
        solve([[F(1), F(2)], [F(2), F(4)]], [F(1), F(2)])


def test_rank() -> None:
    assert rank(SQUARE) == 3
    assert rank([*SQUARE, [a + b for a, b in zip(SQUARE[0], SQUARE[1], strict=True)]]) == 3
    assert rank([[F(1), F(2)], [F(2), F(4)]]) == 1
    assert rank([]) == rank([[F(0)]]) == 0
