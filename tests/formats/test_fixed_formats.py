"""Words with a binary point: the finest format for a bound, values as raw words, the size of a rounding."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from qcone.formats.fixed import ROUNDINGS, Fixed, Signal

F = Fraction
FIXED32, FIXED16 = Fixed("fixed32", 32), Fixed("fixed16", 16)
NUMBERS = [FIXED32, FIXED16]
WIDTHS = st.sampled_from([16, 32, 64])
FRACTIONS = st.integers(-40, 90)
sizes = st.builds(
    lambda top, bottom, power: F(top, bottom) * F(2) ** power,
    st.integers(1, 10**9),
    st.integers(1, 10**9),
    st.integers(-60, 60),
)


def test_a_signal_says_what_it_is() -> None:
    signal = Signal(32, 36)
    assert (signal.name, signal.ctype, signal.lsb, signal.most) == ("s32.F36", "int32_t", F(1, 2**36), 2**31 - 1)
    assert Signal(16, -3).lsb == 8
    assert Signal(64, 62).most == 2**63 - 1


def test_a_number_says_what_it_is() -> None:
    assert (FIXED32.wide, FIXED32.ctype, FIXED32.precision) == (64, "int32_t", 31)
    assert (FIXED16.wide, FIXED16.ctype, FIXED16.precision) == (32, "int16_t", 15)
    assert (FIXED32.rounding, FIXED32.overflow) == ("up", "prove")


@given(WIDTHS, FRACTIONS, st.data())
def test_every_word_has_a_value_and_every_value_its_word(width: int, fraction: int, data: st.DataObject) -> None:
    signal = Signal(width, fraction)
    word = data.draw(st.integers(-signal.most - 1, signal.most))
    assert signal.raw(word * signal.lsb) == word
    assert signal.nearest(word * signal.lsb) == word * signal.lsb
    with pytest.raises(ValueError, match=rf"is not a value of s{width}\.F{fraction}"):
        signal.raw((word + F(1, 3)) * signal.lsb)


@pytest.mark.parametrize("signal", [Signal(16, 15), Signal(32, 40), Signal(64, 62)])
def test_the_most_negative_word_is_a_word_and_no_other_beyond(signal: Signal) -> None:
    least = -(signal.most + 1)
    assert signal.raw(least * signal.lsb) == least
    assert signal.nearest((least - F(1, 2)) * signal.lsb) == least * signal.lsb
    for beyond in (least - 1, signal.most + 1):
        with pytest.raises(ValueError, match="is not a value of"):
            signal.raw(beyond * signal.lsb)
        with pytest.raises(ValueError, match="is beyond the range of"):
            signal.nearest(beyond * signal.lsb)
    with pytest.raises(ValueError, match="is beyond the range of"):
        signal.nearest((signal.most + F(1, 2)) * signal.lsb)


@given(st.sampled_from([Signal(16, 12), Signal(32, 36)]), st.fractions(-1, 1, max_denominator=10**12))
def test_nearest_is_nearest_and_halves_go_up(signal: Signal, share: Fraction) -> None:
    value = share * signal.most * signal.lsb
    error = signal.nearest(value) - value
    assert -signal.lsb / 2 < error <= signal.lsb / 2


@pytest.mark.parametrize(("value", "nearest"), [(F(5, 2), 3), (F(-5, 2), -2), (F(1, 2), 1), (F(-1, 2), 0)])
def test_halves_go_up_at_both_signs(value: Fraction, nearest: int) -> None:
    assert Signal(16, 0).nearest(value) == nearest


# -- the finest format for a bound -----------------------------------------------------------------------


@given(st.sampled_from(NUMBERS), sizes)
def test_a_bound_has_the_finest_format_that_holds_it(number: Fixed, bound: Fraction) -> None:
    signal = number.signal(bound)
    assert signal.width == number.width
    assert bound <= signal.most * signal.lsb
    finer = Signal(signal.width, signal.fraction + 1)
    assert bound > finer.most * finer.lsb


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("power", [-30, -1, 0, 1, 7])
def test_a_power_of_two_needs_a_bit_more_than_what_is_just_below_it(number: Fixed, power: int) -> None:
    """A word holds 1 - 2^-(W-1) at most: one itself takes a bit before the point."""
    one, lsb = F(2) ** power, F(2) ** (power - number.precision)
    assert number.signal(one).fraction == number.precision - 1 - power
    assert number.signal(one - lsb).fraction == number.precision - power
    assert number.signal(one - lsb / 2).fraction == number.precision - 1 - power
    assert number.signal(one + lsb).fraction == number.precision - 1 - power


@pytest.mark.parametrize("number", NUMBERS)
def test_zero_takes_all_bits(number: Fixed) -> None:
    assert number.signal(F(0)) == Signal(number.width, number.width - 1)


@pytest.mark.parametrize("number", NUMBERS)
@given(bound=sizes)
def test_a_wider_word_has_as_many_more_bits(number: Fixed, bound: Fraction) -> None:
    wide = number.signal(bound, number.wide)
    assert wide.width == 2 * number.width
    # Where the narrow word just fails to hold the bound, the wide one may just hold it.
    assert wide.fraction - number.signal(bound).fraction - number.width in (0, 1)


@given(st.sampled_from(NUMBERS), sizes)
def test_the_last_bit_of_a_value_is_that_of_its_finest_format(number: Fixed, size: Fraction) -> None:
    assert number.ulp(size) == number.ulp(-size) == number.signal(size).lsb


# -- the size of a rounding --------------------------------------------------------------------------------


@pytest.mark.parametrize("rounding", ROUNDINGS)
@given(value=st.fractions(-1000, 1000, max_denominator=10**6), fraction=st.integers(-2, 8))
def test_no_rounding_is_off_by_more_than_is_said(rounding: str, value: Fraction, fraction: int) -> None:
    lsb = F(2) ** -fraction
    words = value / lsb
    if rounding == "up":
        rounded = (words + F(1, 2)).__floor__()
    else:
        rounded = round(words) if rounding == "even" else words.__floor__()
    assert abs(rounded * lsb - value) <= Fixed("fixed32", 32, rounding).rounding_error(lsb)


def test_what_is_said_of_a_rounding_is_reached() -> None:
    assert Fixed("fixed32", 32, "up").rounding_error(F(1, 8)) == F(1, 16)
    assert Fixed("fixed32", 32, "even").rounding_error(F(1, 8)) == F(1, 16)
    assert Fixed("fixed32", 32, "floor").rounding_error(F(1, 8)) == F(1, 8)
