"""float32 and float64: rounded as the processor does it, and literals that C reads back to the bit."""

from __future__ import annotations

import ctypes
import ctypes.util
import math
import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from qcone.formats.floating import FLOAT32, FLOAT64, FLOATING, Floating

F = Fraction
TO: dict[str, Any] = {"float32": np.float32, "float64": np.float64}
FORMATS = st.sampled_from([FLOAT32, FLOAT64])
EACH = pytest.mark.parametrize("number", [FLOAT32, FLOAT64], ids=lambda number: number.name)


def exact(value: Any) -> Fraction:
    return Fraction(float(value))


@EACH
def test_the_numbers_of_a_format_are_those_of_the_processor(number: Floating) -> None:
    info = np.finfo(TO[number.name])
    assert number.tiny == exact(info.smallest_subnormal)
    assert number.smallest_normal == exact(info.tiny)
    assert number.ulp(F(1)) == exact(info.eps)
    assert number.precision == info.nmant + 1
    assert FLOATING[number.name] is number


def test_what_c_calls_them() -> None:
    assert [(each.ctype, each.suffix) for each in (FLOAT32, FLOAT64)] == [("float", "F"), ("double", "")]


# -- rounding --------------------------------------------------------------------------------------------------


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_numbers_of_float32_stay(value: float) -> None:
    assert FLOAT32.round(F(value)) == F(value)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_numbers_of_float64_stay(value: float) -> None:
    assert FLOAT64.round(F(value)) == F(value)


@given(st.floats(-3.4e38, 3.4e38, allow_nan=False))
@example(1 + 2.0**-24)
@example(1 + 3 * 2.0**-24)
@example(-1 - 2.0**-24 - 2.0**-52)
@example(2.0**-150)
@example(2.0**-150 * (1 + 2.0**-52))
@example(3 * 2.0**-150)
@example(1.5 * 2.0**-149)
@example(2.0**-126 - 2.0**-150)
def test_float32_is_rounded_as_the_processor_does(value: float) -> None:
    """Ties to even, subnormals too."""
    assert FLOAT32.round(F(value)) == exact(np.float32(value))


@given(st.fractions(max_denominator=10**30))
def test_float64_is_rounded_as_python_divides(value: Fraction) -> None:
    """int / int is correctly rounded in Python."""
    assert FLOAT64.round(value) == F(value.numerator / value.denominator)


@given(FORMATS, st.fractions(-(10**30), 10**30))
def test_rounding_is_to_the_nearest(number: Floating, value: Fraction) -> None:
    rounded = number.round(value)
    assert abs(rounded - value) <= number.ulp(value) / 2
    assert number.round(rounded) == rounded
    assert number.round(-value) == -rounded


@given(FORMATS, st.fractions(-(10**6), 10**6), st.fractions(-(10**6), 10**6))
def test_rounding_keeps_the_order(number: Floating, a: Fraction, b: Fraction) -> None:
    low, high = min(a, b), max(a, b)
    assert number.round(low) <= number.round(high)


@given(st.floats(2.0**-1000, 1e300), st.sampled_from([1, -1]))
def test_ulp_is_the_spacing_of_float64(value: float, sign: int) -> None:
    assert FLOAT64.ulp(F(sign * value)) == exact(np.spacing(value))


@given(st.floats(0, 2.0**100, width=32, exclude_min=True))
def test_ulp_is_the_spacing_of_float32(value: float) -> None:
    assert FLOAT32.ulp(F(value)) == exact(np.spacing(np.float32(value)))


@EACH
def test_zero(number: Floating) -> None:
    assert number.round(F(0)) == 0
    assert number.ulp(F(0)) == number.tiny
    assert number.literal(F(0)) == "0.0" + number.suffix


@EACH
def test_what_is_too_large(number: Floating) -> None:
    """Halfway between the largest number and the next power of two, and from there on."""
    largest = exact(np.finfo(TO[number.name]).max)
    over = largest + number.ulp(largest) / 2
    assert number.round(over - F(1, 10**6)) == largest
    for value in (over, -over, 2 * largest):
        with pytest.raises(OverflowError, match=f"^{value} is beyond the range of {number.name}$"):
            number.round(value)


@EACH
def test_what_is_too_small(number: Floating) -> None:
    assert number.round(number.tiny / 2) == 0
    assert number.round(number.tiny / 2 + F(1, 10**400)) == number.tiny
    assert number.round(-number.tiny * F(3, 2)) == -2 * number.tiny


# -- literals --------------------------------------------------------------------------------------------------

C_LITERAL = re.compile(r"-?(\d+\.\d+)(e[+-]\d\d\d?)?F?")


def library() -> Any:
    found = ctypes.CDLL(ctypes.util.find_library("c") or None)
    found.strtof.restype, found.strtod.restype = ctypes.c_float, ctypes.c_double
    for each in (found.strtof, found.strtod):
        each.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    return found


LIBRARY = library()


def read_by_c(number: Floating) -> Callable[[str], Fraction]:
    """Return how the C library reads a number of the format."""
    read = LIBRARY.strtof if number is FLOAT32 else LIBRARY.strtod
    return lambda text: F(read(text.encode(), None))


def check_literal(number: Floating, value: Fraction) -> None:
    text = number.literal(value)
    assert C_LITERAL.fullmatch(text), text
    assert text.endswith("F") == (number is FLOAT32)
    plain = text.removesuffix("F")
    assert exact(TO[number.name](plain)) == value
    assert read_by_c(number)(plain) == value


@settings(deadline=None)
@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
@example(0.1)
@example(2.0**-149)
@example(2.0**-126)
@example(float(np.finfo(np.float32).max))
@example(16777216.0)
@example(-1e15)
@example(1e16)
def test_literals_of_float32(value: float) -> None:
    check_literal(FLOAT32, exact(np.float32(value)))


@settings(deadline=None)
@given(st.floats(allow_nan=False, allow_infinity=False))
@example(0.1)
@example(5e-324)
@example(2.2250738585072014e-308)
@example(1.7976931348623157e308)
@example(9007199254740993.0)
@example(1e22)
@example(1e23)
def test_literals_of_float64(value: float) -> None:
    check_literal(FLOAT64, F(value))


def significant(text: str) -> int:
    """Return the number of significant digits."""
    digits = re.sub(r"e.*|[-.F]", "", text).lstrip("0")
    return max(1, len(digits.rstrip("0")))


def fewest(number: Floating, value: float) -> int:
    """Return how many digits of the value, rounded by Python's own formatting, read back: found independently."""
    read = TO[number.name]
    return next(digits for digits in range(1, 18) if read(format(value, f".{digits - 1}e")) == value)


@settings(deadline=None)
@given(st.floats(2.0**-120, 2.0**100, width=32))
def test_literals_of_float32_have_the_fewest_digits(value: float) -> None:
    assert significant(FLOAT32.literal(F(value))) == significant(format(value, f".{fewest(FLOAT32, value) - 1}e"))


@settings(deadline=None, max_examples=50)
@given(st.floats(1e-100, 1e100))
def test_literals_of_float64_have_the_fewest_digits(value: float) -> None:
    assert significant(FLOAT64.literal(F(value))) == significant(format(value, f".{fewest(FLOAT64, value) - 1}e"))


@settings(deadline=None, max_examples=50)
@given(st.floats(1e-100, 1e100).filter(lambda value: math.frexp(value)[0] != 0.5))
def test_between_powers_of_two_there_is_no_shorter_literal(value: float) -> None:
    assert significant(FLOAT64.literal(F(value))) == significant(repr(value))


@pytest.mark.parametrize(
    ("number", "value", "shortest"),
    [(FLOAT64, 2.0**-140, "7.174648137343064e-43"), (FLOAT32, 2.0**-96, "1.2621775e-29")],
    ids=["float64", "float32"],
)
def test_at_a_power_of_two_there_may_be(number: Floating, value: float, shortest: str) -> None:
    """The shorter decimal is not the value's own rounding to so many digits: it is not what is printed."""
    assert exact(TO[number.name](shortest)) == F(value)
    assert significant(number.literal(F(value))) == significant(shortest) + 1
    check_literal(number, F(value))


@pytest.mark.parametrize(
    ("value", "float32", "float64"),
    [
        (F(1), "1.0F", "1.0"),
        (F(-1, 2), "-0.5F", "-0.5"),
        (F(1, 3), "0.33333334F", "0.3333333333333333"),
        (F(9, 20), "0.45F", "0.45"),
        (F(-27, 40), "-0.675F", "-0.675"),
        (F(1, 10**4), "0.0001F", "0.0001"),
        (F(1, 10**5), "1.0e-05F", "1.0e-05"),
        (F(1, 10**7), "1.0e-07F", "1.0e-07"),
        (F(25, 10**8), "2.5e-07F", "2.5e-07"),
        (F(10**15), "1000000000000000.0F", "1000000000000000.0"),
        (F(10**20), "1.0e+20F", "1.0e+20"),
        (F(123), "123.0F", "123.0"),
    ],
)
def test_literal(value: Fraction, float32: str, float64: str) -> None:
    assert FLOAT32.literal(FLOAT32.round(value)) == float32
    assert FLOAT64.literal(FLOAT64.round(value)) == float64


@EACH
def test_a_number_of_another_format_is_refused(number: Floating) -> None:
    with pytest.raises(ValueError, match=f"^1/3 is not a number of {number.name}; round it first$"):
        number.literal(F(1, 3))
