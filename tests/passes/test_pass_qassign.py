"""How formats are chosen: as fine as a bound allows; parts rounded first where a sum is too wide; what is refused."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from real_routines import F, written
from sums import GIVEN, Choice, expressions, fused, routine_of

from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Sum
from qcone.ir.statement import Operation, Routine
from qcone.passes.choices import Formats, UnfitError
from qcone.passes.fit import LEAST_DROPPED, SHORTEST_CONSTANT
from qcone.passes.magnitudes import Declared
from qcone.passes.qassign import Assigner

FIXED32, FIXED16 = Fixed("fixed32", 32), Fixed("fixed16", 16)
SIZES = {"v": F(1, 2), "x": F(3, 4), "s": F(1, 1000)}


def assigned(
    routine: Routine, number: Fixed = FIXED32, sizes: dict[str, Fraction] = SIZES, **blocks: Signal
) -> tuple[Assigner, Formats]:
    signals = {name: number.signal(size) for name, size in sizes.items()}
    declared = {name: Declared((-size, size)) for name, size in sizes.items()}
    assigner = Assigner(fused(routine), number, signals | blocks, declared)
    return assigner, assigner.run()


def sums(found: Formats) -> list[Operation]:
    return [each for each in found.routine.body if isinstance(each, Operation) and isinstance(each.detail, Sum)]


def dropped(found: Formats, operation: Operation) -> int:
    """Return how many bits a sum drops."""
    return found.finest(operation) - found.signals[operation.result].fraction


def test_a_product_takes_every_bit_that_its_bound_leaves() -> None:
    _, found = assigned(written(lambda v, x, s: x * s))
    (product,) = sums(found)
    assert found.signals[product.result] == FIXED32.signal(F(3, 4000) * F(1001, 1000))
    assert dropped(found, product) == 31 + 40 - 41


def test_an_exact_sum_is_kept_no_finer_than_it_is() -> None:
    """Words of F31 and F40 halved have no more bits than they came with."""
    _, found = assigned(written(lambda v, x, s: F(1, 2**20) * x))
    (total,) = sums(found)
    assert found.signals[total.result].fraction == 31 + 20
    assert dropped(found, total) == 0


def test_a_constant_is_as_long_as_a_word_and_no_longer_than_it_must() -> None:
    _, found = assigned(written(lambda v, x, s: F(1, 3) * x + F(3, 8) * s))
    (total,) = sums(found)
    third, eighths = (found.constants[total.result, at] for at in range(2))
    assert third == Signal(32, 32)
    assert eighths == Signal(32, 3)


@pytest.mark.parametrize("number", [FIXED32, FIXED16], ids=lambda each: each.name)
def test_a_product_beside_a_word_is_rounded_first_where_both_are_too_wide(number: Fixed) -> None:
    """x near 1 and a product of tiny values share no accumulator: the product becomes a value of its own."""
    sizes = {"v": F(1, 2), "x": F(100), "s": F(1, 1000)}
    assigner, found = assigned(written(lambda v, x, s: x + s * s), number, sizes)
    part, total = sums(found)
    assert part.result in assigner.choices.split
    assert isinstance(part.detail, Sum)
    assert [len(term.args) for term in part.detail.terms] == [2]
    assert isinstance(total.detail, Sum)
    assert part.result in total.args
    assert found.accumulator_size(total) < 2 ** (number.wide - 1)


@pytest.mark.parametrize("size", [F(4), F(50), F(90)])
def test_what_is_split_off_is_rounded_where_many_bits_are_dropped(size: Fraction) -> None:
    """Dropping a few bits halves up is biased: the part is rounded to the sum's own last bit, and added exactly."""
    sizes = {"v": F(1, 2), "x": size, "s": F(9, 10)}
    assigner, found = assigned(written(lambda v, x, s: x + s * s), FIXED32, sizes)
    part, total = sums(found)
    assert part.result in assigner.choices.split
    assert dropped(found, part) >= LEAST_DROPPED
    assert dropped(found, total) == 0
    assert found.signals[part.result].fraction == found.signals[total.result].fraction


@settings(max_examples=150, deadline=None)
@given(expressions)
def test_no_sum_drops_a_few_bits_of_what_was_split_off_alone(choices: list[Choice]) -> None:
    found = drawn(choices)
    if found is None:
        return
    assigner, formats = found
    for total in sums(formats):
        assert isinstance(total.detail, Sum)
        if total.detail.carried or not 0 < dropped(formats, total) < LEAST_DROPPED:
            continue
        own = formats.signals[total.result].fraction
        _, bits = formats.accumulated(total)
        fine = [term for term, each in zip(total.detail.terms, bits, strict=True) if each is not None and each > own]
        assert not all(len(term.args) == 1 and term.args[0] in assigner.choices.split for term in fine)


def drawn(choices: list[Choice]) -> tuple[Assigner, Formats] | None:
    try:
        return assigned(routine_of(choices), FIXED32, {block.name: F(1) for block in GIVEN})
    except UnfitError:
        return None


@settings(max_examples=150, deadline=None)
@given(expressions)
def test_no_constant_is_shorter_than_it_may_become(choices: list[Choice]) -> None:
    found = drawn(choices)
    if found is None:
        return
    _, formats = found
    for total in sums(formats):
        assert isinstance(total.detail, Sum)
        for at, term in enumerate(total.detail.terms):
            signal = formats.constants.get((total.result, at))
            if signal is not None:
                exact = abs(term.coefficient) / signal.lsb
                assert exact.denominator == 1 or exact >= 2 ** (SHORTEST_CONSTANT - 1)


# -- what is refused ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("author", "message"),
    [
        (lambda v, x, s: x + x, "'value 5' in 'written' may reach 1.5, 1 bit more than s32.F31 holds"),
        (lambda v, x, s: 100 * x, "'value 6' in 'written' may reach 75, 7 bits more than s32.F31 holds"),
        (lambda v, x, s: x - x + F(5), "'value .*' in 'written' may reach 5, 3 bits more than s32.F31 holds"),
    ],
)
def test_a_value_that_its_block_cannot_hold_is_named_with_the_missing_bits(author: Any, message: str) -> None:
    with pytest.raises(UnfitError, match=message):
        assigned(written(author), out=Signal(32, 31))


def test_a_quotient_by_what_may_be_zero_is_refused() -> None:
    with pytest.raises(UnfitError, match="the routine 'written' divides by a value that may be zero"):
        assigned(written(lambda v, x, s: s / x))
