"""What cannot be written down is refused as it is written: inexact numbers, shapes that do not fit, strangers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from quantities import Page

from qcone.errors import UsageError
from qcone.ir.blocks import cross, dot, matrix, number
from qcone.ir.update import exp, quaternion, rotation


@pytest.mark.parametrize(
    "write",
    [
        lambda page: page.x + 0.5,
        lambda page: 0.5 + page.x,
        lambda page: page.x - 0.5,
        lambda page: 0.5 - page.x,
        lambda page: 0.5 * page.x,
        lambda page: page.x * 0.5,
        lambda page: page.x / 0.5,
        lambda page: 0.5 * page.a,
        lambda page: page.a * 0.5,
        lambda page: page.a / 0.5,
        lambda page: 0.5 * page.q,
        lambda page: page.q * 0.5,
        lambda page: number(0.5, page.x),
    ],
)
def test_floats_are_refused(write: Callable[[Page], Any]) -> None:
    expected = r"^a constant must be exact: write it as a fraction, F\(9, 20\), instead of 0\.5$"
    with pytest.raises(UsageError, match=expected):
        write(Page())


def test_truth_values_are_no_numbers() -> None:
    with pytest.raises(UsageError, match="instead of True"):
        Page().x + True


@pytest.mark.parametrize(
    ("write", "what"),
    [
        (lambda page: page.a * page.b, "vector"),
        (lambda page: page.x + page.a, "vector"),
        (lambda page: page.x * matrix([page.x] * 9), "matrix"),
        (lambda page: page.x / page.q, "quaternion"),
        (lambda page: page.q + page.x, "quaternion"),
        (lambda page: page.a * rotation(page.x, page.a), "rotation"),
        (lambda page: page.x * "1/3", "str"),
    ],
)
def test_shapes_that_have_no_such_operation(write: Callable[[Page], Any], what: str) -> None:
    with pytest.raises(UsageError, match=f"^a scalar or an exact number is needed here, not a {what}$"):
        write(Page())


@pytest.mark.parametrize(
    "write", [lambda page: page.a + page.q, lambda page: page.a - 1, lambda page: page.q - page.p.vector]
)
def test_sums_of_different_shapes_are_refused(write: Callable[[Page], Any]) -> None:
    with pytest.raises(TypeError, match="unsupported operand"):
        write(Page())


def test_division_by_zero_is_refused() -> None:
    with pytest.raises(UsageError, match=r"^a division by zero is written here$"):
        Page().a / 0


@pytest.mark.parametrize(
    "write",
    [
        lambda one, other: one.a + other.a,
        lambda one, other: one.x * other.x,
        lambda one, other: one.x * other.a,
        lambda one, other: one.a / other.x,
        lambda one, other: one.q * other.a,
        lambda one, other: one.q * other.q,
        lambda one, other: cross(one.a, other.a),
        lambda one, other: dot(one.a, other.a),
        lambda one, other: quaternion(one.x, other.a),
        lambda one, other: matrix([one.x] * 8 + [other.x]),
        lambda one, other: (one.q * rotation(one.x, other.a)).finish(),
    ],
)
def test_quantities_of_two_routines_are_not_mixed(write: Callable[[Page, Page], Any]) -> None:
    """Their values are numbered apart: mixed, they would stand for other quantities."""
    with pytest.raises(UsageError, match=r"^a subroutine calculates with its arguments only"):
        write(Page(), Page())


def test_exp_takes_a_vector() -> None:
    with pytest.raises(UsageError, match=r"^exp takes a rotation vector of three components, not Quaternion$"):
        exp(Page().q)  # type: ignore[arg-type]


def test_rotation_takes_scalar_and_vector() -> None:
    page = Page()
    with pytest.raises(UsageError, match=r"^rotation\(u, v\) takes the scalar part minus one and the vector part"):
        rotation(page.a, page.x)  # type: ignore[arg-type]


def test_a_rotation_is_multiplied_from_the_left_by_the_attitude() -> None:
    page = Page()
    twice = rotation(page.x, page.a)
    with pytest.raises(
        UsageError, match=r"^a rotation is multiplied from the left by the attitude q, not by a update$"
    ):
        page.q * twice * twice
