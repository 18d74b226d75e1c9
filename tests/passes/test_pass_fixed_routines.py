"""Random routines of sums in fixed point: what is accepted fits, both levels agree, and errors are within bounds."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction

import pytest
from exact_words import TooLargeError, run
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sums import GIVEN, Choice, expressions, fused, routine_of

from qcone.formats.fixed import ROUNDINGS, Fixed, Signal
from qcone.ir.check import check
from qcone.ir.detail import Aligned, Mac
from qcone.ir.evaluate import evaluate
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation, Routine
from qcone.passes.choices import UnfitError
from qcone.passes.errors import errors
from qcone.passes.expand import Made, expand
from qcone.passes.limb_ranges import known_norms
from qcone.passes.limb_sums import made_of_limbs
from qcone.passes.lower_fixed import lower_fixed
from qcone.passes.magnitudes import Declared
from qcone.passes.qassign import Assigner

F = Fraction
SIZES = {"kept": F(3, 2), "first": F(1), "second": F(1, 100)}
DECLARED = {name: Declared((-size, size)) for name, size in SIZES.items()}
WIDTHS = {"fixed32": 32, "fixed16": 16}
UNFIT = re.compile(
    r"'\w.*' in 'drawn' may reach [\d.e+-]+, \d+ bits? more than s\d+\.F-?\d+ holds"
    r"|the sum '.+' in 'drawn' needs \d+ bits? more than an accumulator of (32|64)"
)
numbers = st.sampled_from([Fixed(name, WIDTHS[name], rounding) for name in WIDTHS for rounding in ROUNDINGS])
many = settings(max_examples=250, deadline=None, suppress_health_check=[HealthCheck.filter_too_much])


@dataclass(frozen=True)
class Written:
    """A routine in sums, in fixed point and, in every form, in integer operations, and what is proved of it."""

    exact: Routine
    macs: Routine
    integers: tuple[Routine, ...]
    errors: dict[int, Fraction]
    signals: dict[str, Signal]


def made(choices: list[Choice], number: Fixed) -> Written | None:
    """Return a random routine in fixed point; None where it does not fit."""
    routine = fused(routine_of(choices))
    signals = {name: number.signal(size) for name, size in SIZES.items()}
    assigner = Assigner(routine, number, signals, DECLARED)
    said, found = "", None
    try:
        found = assigner.run()
    except UnfitError as error:
        said = str(error)
    if found is None:
        assert UNFIT.fullmatch(said), said
        return None
    macs, residuals = lower_fixed(assigner, found, "residual", signals)
    assert len(residuals) == sum(
        isinstance(each.detail, Mac) and each.detail.residual is not None
        for each in macs.body
        if isinstance(each, Operation)
    )
    check(macs, MachineOp)
    forms = [(True, Made()), (False, Made())]
    forms += [(True, made_of_limbs(macs, known_norms(found), shared)) for shared in (False, True)]
    integers = tuple(check(expand(macs, narrow, sums), MachineOp) for narrow, sums in forms)
    return Written(found.routine, macs, integers, errors(assigner, found), signals)


shares = st.lists(
    st.one_of(st.sampled_from([F(1), F(-1), F(0)]), st.fractions(-1, 1, max_denominator=2**40)),
    min_size=sum(block.size for block in GIVEN),
    max_size=sum(block.size for block in GIVEN),
)
"""Of what is declared of each component: both ends, nothing, and between."""


def words(made: Written, shares: list[Fraction]) -> dict[str, list[int]]:
    left = iter(shares)
    return {
        block.name: [int(next(left) * SIZES[block.name] / made.signals[block.name].lsb) for _ in range(block.size)]
        for block in GIVEN
    }


@many
@given(expressions, numbers, shares)
def test_what_is_accepted_fits_and_both_levels_agree(
    choices: list[Choice], number: Fixed, given: list[Fraction]
) -> None:
    """At both ends of every input: no word, product, partial sum or rounding is beyond its word or its bound."""
    found = made(choices, number)
    if found is None:
        return
    inputs = words(found, given)
    values, memory = run(found.macs, inputs)
    for integers in found.integers:
        same, others = run(integers, inputs)
        assert others == memory
        assert {key: same[key] for key in values if key in same} == {key: values[key] for key in values if key in same}


@many
@given(expressions, numbers, shares)
def test_no_value_is_further_from_exact_than_is_proved(
    choices: list[Choice], number: Fixed, given: list[Fraction]
) -> None:
    found = made(choices, number)
    if found is None:
        return
    inputs = words(found, given)
    values, _ = run(found.macs, inputs)
    named = replace(found.exact, names={key: str(key) for key in found.errors})
    exact = evaluate(
        named, {name: [raw * found.signals[name].lsb for raw in each] for name, each in inputs.items()}
    ).named
    formats = {each.result: each.format for each in found.macs.body if isinstance(each, Operation)}
    for key, bound in found.errors.items():
        signal = formats.get(key)
        if isinstance(signal, Signal):
            assert abs(values[key] * signal.lsb - exact[str(key)]) <= bound


@many
@given(expressions, st.sampled_from(ROUNDINGS), st.lists(shares, min_size=2, max_size=5))
def test_what_is_carried_adds_up_to_what_was_rounded_away(
    choices: list[Choice], rounding: str, stream: list[list[Fraction]]
) -> None:
    """The words given out and what is left are the sum of what came in, to the last bit, over any number of updates."""
    found = made([*choices, ("scale", 0, 0, F(9, 20)), ("carry", 0, 0, F(1))], Fixed("fixed32", 32, rounding))
    if found is None:
        return
    carried = {
        each.result: each.detail
        for each in found.macs.body
        if isinstance(each, Operation) and isinstance(each.detail, Mac) and each.detail.residual
    }
    given_out = dict.fromkeys(carried, 0)
    came_in = dict.fromkeys(carried, 0)
    left: list[int] = [0] * len(carried)
    for shares_ in stream:
        values, memory = run(found.macs, {**words(found, shares_), "residual": left})
        for key, mac in carried.items():
            given_out[key] += values[key] << mac.discard
            came_in[key] += sum(_term(term, values) for term in mac.terms)
        left = memory.get("residual", [])
    for key, mac in carried.items():
        assert mac.residual is not None
        assert came_in[key] == given_out[key] + left[mac.residual[1].constant]
        assert abs(left[mac.residual[1].constant]) < (1 << mac.discard)


def _term(term: Aligned, values: dict[int, int]) -> int:
    product = (-1 if term.negative else 1) << term.shift
    for arg in term.args:
        product *= values[arg]
    return product


# -- the harness itself ------------------------------------------------------------------------------------


def plain(number: Fixed = Fixed("fixed32", 32)) -> Written:  # noqa: B008
    """Return first[0] * second[0] + 1/3 first[1] - first[2], a word and a product and a constant."""
    choices: list[Choice] = [
        ("multiply", 4, 1, F(1)),
        ("scale", 4, 0, F(1, 3)),
        ("add", 0, 1, F(1)),
        ("subtract", 0, 5, F(1)),
    ]
    found = made(choices, number)
    assert found is not None
    return found


def changed(routine: Routine, **change: object) -> Routine:
    """Change the first sum of products of a routine."""
    body = list(routine.body)
    at, mac = next(
        (k, each) for k, each in enumerate(body) if isinstance(each, Operation) and isinstance(each.detail, Mac)
    )
    assert isinstance(mac.detail, Mac)
    body[at] = replace(mac, detail=replace(mac.detail, **change))  # type: ignore[arg-type]
    return routine.with_body(tuple(body))


def test_an_accumulator_that_is_too_short_is_noticed() -> None:
    found = plain()
    inputs = words(found, [F(1)] * 7)
    run(found.macs, inputs)
    with pytest.raises(TooLargeError, match="no word of 32 bits"):
        run(changed(found.macs, accumulator=32), inputs)


def test_fewer_dropped_bits_are_noticed() -> None:
    found = plain()
    first = next(mac for each in found.macs.body if isinstance(mac := getattr(each, "detail", None), Mac))
    with pytest.raises(TooLargeError, match="beyond the bound"):
        run(changed(found.macs, discard=first.discard - 1), words(found, [F(1)] * 7))


def test_another_rounding_is_noticed() -> None:
    found = plain()
    truncated = changed(found.macs, rounding="floor")
    given = [words(found, [F(k, 97)] * 7) for k in range(1, 40)]
    assert any(run(truncated, each)[1] != run(found.macs, each)[1] for each in given)
