"""Products and sums of the C and of the machine: how they agree, and when they do not."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from qcone.backends.counts import Counts, Products, products
from qcone.cost import measure
from qcone.reconciliation import reconcile, reconcile_words
from qcone.targets.cross import cross_compiler
from qcone.targets.emulation import Emulation
from qcone.targets.machines import TARGETS
from qcone.targets.traces import Executed
from shipped import shipped

EMITTED = Counts(multiply=38, power_of_two=1, add=33, subtract=13)
SELECTING = replace(EMITTED, select=2)
RECONCILED = {
    "as emitted": (EMITTED, (39, 39), (46, 46), True, "39 and 46 executed"),
    "x + x for 2 x": (EMITTED, (38, 38), (47, 47), True, "38 and 47 executed: 1 by 2 became x + x"),
    "a product lost": (EMITTED, (38, 38), (46, 46), False, "but 38 and 46 executed"),
    "two doubled, one by 2": (EMITTED, (37, 37), (48, 48), False, "but 37 and 48 executed"),
    "a sum more": (EMITTED, (39, 39), (47, 47), False, "but 39 and 47 executed"),
    "as data decides": (EMITTED, (38, 39), (46, 46), False, "executed 38 to 39 and 46 to 46, as data decides"),
    "one arm alone": (SELECTING, (39, 39), (44, 46), True, "one arm of a select alone"),
    "arms and a sum more": (SELECTING, (39, 39), (46, 47), False, "as data decides"),
}


@pytest.mark.parametrize("what", RECONCILED)
def test_reconciliation(what: str) -> None:
    emitted, products, sums, holds, said = RECONCILED[what]
    found = reconcile(emitted, Executed(1, (1, 1), products, sums, None, (), (), ()))
    assert found.holds == holds
    assert found.text.startswith("39 products and 46 sums emitted")
    assert said in found.text


WORDS = {
    "as emitted": (Products(40, 0, 5), (40, 40), (0, 0), False, True, "40 products of 64 bits emitted, 40 executed"),
    "of two kinds": (
        *(Products(4, 9, 0), (4, 4), (9, 9), False, True),
        "4 products of 64 bits and 9 products of 32 bits emitted, 4 and 9 executed",
    ),
    "short ones alone": (
        *(Products(0, 9, 0), (0, 0), (9, 9), False, True),
        "9 products of 32 bits emitted, 0 and 9 executed",
    ),
    "none": (Products(0, 0, 0), (0, 0), (0, 0), False, True, "no products emitted, 0 and 0 executed"),
    "lower halves": (
        *(Products(40, 0, 5), (40, 40), (37, 37), True, True),
        "40 products of 64 bits emitted, 40 and 37 executed: 37 are lower halves",
    ),
    "lower halves where one instruction makes both": (
        *(Products(40, 0, 5), (40, 40), (37, 37), False, False),
        "40 products of 64 bits emitted, but 40 and 37 executed: the compiler makes products in ways of its own",
    ),
    "more lower halves than products": (
        *(Products(40, 0, 5), (40, 40), (41, 41), True, False),
        "40 products of 64 bits emitted, but 40 and 41 executed: the compiler makes products in ways of its own",
    ),
    "constants": (
        *(Products(0, 151, 18), (0, 0), (149, 149), False, True),
        "151 products of 32 bits emitted, 0 and 149 executed: 2 by constants became shifts and sums",
    ),
    "constants and lower halves": (
        *(Products(40, 2, 1), (39, 39), (38, 38), True, True),
        "40 products of 64 bits and 2 products of 32 bits emitted, 39 and 38 executed: 36 are lower halves, 1 by "
        "constants became shifts and sums",
    ),
    "more missing than constants": (
        *(Products(40, 0, 2), (37, 37), (0, 0), False, False),
        "40 products of 64 bits emitted, but 37 executed: the compiler makes products in ways of its own",
    ),
    "one more": (
        *(Products(40, 0, 5), (41, 41), (0, 0), False, False),
        "40 products of 64 bits emitted, but 41 executed: the compiler makes products in ways of its own",
    ),
    "as data decides": (
        *(Products(40, 0, 5), (39, 40), (0, 0), False, False),
        "40 products of 64 bits emitted; executed 39 to 40 and 0 to 0, as data decides",
    ),
}


@pytest.mark.parametrize("what", WORDS)
def test_words_are_reconciled(what: str) -> None:
    emitted, whole, lower, separate, holds, said = WORDS[what]
    ran = Executed(1, (1, 1), (0, 0), (0, 0), None, (), (), (), whole, lower)
    found = reconcile_words(emitted, ran, separate)
    assert (found.holds, found.text) == (holds, said)


@pytest.fixture(scope="module")
def emulation() -> Iterator[Emulation]:
    with Emulation() as one:
        yield one


EMITTED_WORDS = {"": Products(40, 0, 5), "_compensated": Products(40, 0, 5), "_limbs_shared": Products(0, 151, 18)}


@pytest.mark.parametrize("form", EMITTED_WORDS)
@pytest.mark.parametrize("target", ["cortex-m0", "cortex-m3", "cortex-m4", "cortex-m7f", "rv32imc", "powerpc"])
def test_every_product_of_fixed_point_is_accounted_for(form: str, target: str, emulation: Emulation) -> None:
    bundle = shipped(f"rotation_vector_3_coning_fixed32{form}")
    assert products(bundle.machine.routine("update")) == EMITTED_WORDS[form]
    found = measure(bundle, TARGETS[target], cross_compiler(), "-O2", emulation)
    assert found.reconciliation
    assert found.reconciliation.holds, found.reconciliation.text
    assert found.executed.whole[0] == EMITTED_WORDS[form].whole
    assert EMITTED_WORDS[form].lower - EMITTED_WORDS[form].constant <= found.executed.lower[0]
