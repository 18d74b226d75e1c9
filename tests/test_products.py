"""Products by the core: which form a design takes, what its banner says, and the same bits in every form."""

from __future__ import annotations

from dataclasses import replace

import pytest

from fixed_designs import ACCUMULATIONS, FLAGSHIP, SERIES, made
from qcone.errors import CheckError, DesignError
from qcone.formats.fixed import Signal
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Call, Operation, Program
from qcone.products import products_of
from qcone.verify import accept, read_back
from shipped import design_of, shipped
from watching import drawn, watch

LIMBS, SHARED, LIBRARY, WIDE = (
    f"rotation_vector_3_coning_fixed32{each}" for each in ("_limbs", "_limbs_shared", "_library", "")
)
FORMS = ("limbs", "limbs-shared")
ROWS = 4000

CHOSEN = {
    ("generic", "auto", "fixed32"): "wide",
    ("generic", "wide", "fixed32"): "wide",
    ("generic", "limbs", "fixed32"): "limbs",
    ("generic", "limbs-shared", "fixed32"): "limbs-shared",
    ("generic", "library", "fixed32"): "library",
    ("cortex-m0", "auto", "fixed32"): "limbs",
    ("cortex-m0plus", "auto", "fixed32"): "limbs",
    ("cortex-m0", "limbs-shared", "fixed32"): "limbs-shared",
    ("cortex-m0plus", "library", "fixed32"): "library",
    ("cortex-m0", "auto", "fixed16"): "wide",
    ("cortex-m0", "wide", "fixed16"): "wide",
    ("cortex-m0", "auto", "float32"): "wide",
    ("cortex-m3", "auto", "fixed32"): "wide",
    ("cortex-m4", "wide", "fixed32"): "wide",
    ("cortex-m4", "limbs", "fixed32"): "limbs",
    ("rv32imc", "auto", "fixed32"): "wide",
    ("host", "auto", "fixed32"): "wide",
}


@pytest.mark.parametrize(("core", "multiply", "number"), CHOSEN)
def test_form_is_chosen_by_core_and_multiply(core: str, multiply: str, number: str) -> None:
    design = design_of(FLAGSHIP, core=core, multiply=multiply, number=number)
    assert products_of(design) == CHOSEN[core, multiply, number]


@pytest.mark.parametrize("option", [{"rounding": "even"}, {"overflow": "saturate"}, {"overflow": "wrap"}])
def test_a_core_without_long_products_takes_its_library_where_limbs_will_not_do(option: dict[str, str]) -> None:
    assert products_of(design_of(FLAGSHIP, number="fixed32", core="cortex-m0", **option)) == "library"
    assert products_of(design_of(FLAGSHIP, number="fixed32", core="cortex-m4", **option)) == "wide"


@pytest.mark.parametrize("multiply", ["wide", "limbs", "limbs-shared", "library"])
def test_floats_have_no_form(multiply: str) -> None:
    with pytest.raises(DesignError, match=f'multiply = "{multiply}" does not go with number.format = "float32"'):
        products_of(design_of(FLAGSHIP, number="float32", multiply=multiply))


# -- bits ---------------------------------------------------------------------------------------------------


def long_products(program: Program) -> int:
    every = (each for one in program.routines for routine in (one, *one.callees.values()) for each in routine.body)
    return sum(
        isinstance(each, Operation)
        and each.op is MachineOp.MULTIPLY
        and isinstance(each.format, Signal)
        and each.format.width == 64
        for each in every
    )


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
def test_flagship_has_its_bits_in_every_form(accumulate: str, form: str) -> None:
    """With its matrix and its angles: limbs and the sums they stand for agree, and no word is beyond its own."""
    options = {"outputs": "quaternion,dcm,euler"}
    wide = made(FLAGSHIP, "fixed32", accumulate, **options)
    bundle = made(FLAGSHIP, "fixed32", accumulate, **options, core="cortex-m0", multiply=form)
    assert bundle.macs == wide.macs
    for seen in watch(bundle, drawn(bundle, ROWS)):
        assert list(seen.beyond()) == []
    assert (long_products(bundle.machine) < long_products(wide.machine) / 2) or accumulate == "compensated"


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("example", [SERIES[2], SERIES[3], "picard order=4", "runge-kutta-4 attitude=quaternion"])
def test_other_algorithms_have_their_bits_in_every_form(example: str, form: str) -> None:
    smooth = {"max_angular_acceleration_dps2": "20000", "max_jerk_dps3": "1000000"}
    bundle = made(example, "fixed32", "delta", **smooth, core="cortex-m0", multiply=form)
    for seen in watch(bundle, drawn(bundle, ROWS // 4)):
        assert list(seen.beyond()) == []


@pytest.mark.parametrize("name", [LIMBS, SHARED])
def test_shipped_forms_hold_no_product_of_64_bits(name: str) -> None:
    bundle = shipped(name)
    assert long_products(bundle.machine) == 0
    assert "int64_t" not in bundle.source.partition(f"void {name}_update(")[2]
    assert accept(bundle)


def test_library_is_the_c_of_wide() -> None:
    def code(name: str) -> str:
        update = shipped(name).source.partition(f"void {name}_update(")[2].partition("\n}\n")[0]
        return update.replace(name, "")

    assert code(LIBRARY) == code(WIDE)
    assert code(LIMBS) != code(WIDE)


def test_functions_are_shared_where_that_is_smaller() -> None:
    update = shipped(SHARED).machine.routine("update")
    calls = [each.routine for each in update.body if isinstance(each, Call)]
    assert set(calls) == set(update.callees)
    assert all(calls.count(name) >= 3 for name in update.callees)
    assert all(callee.by_value for callee in update.callees.values())
    assert shipped(LIMBS).machine.routine("update").callees == {}


TAMPERED = {
    "another value returned": ("return sum;", "return sum_1;"),
    "words in another order": ("(g_y, k_z, g_z, k_y)", "(g_z, k_z, g_y, k_y)"),
    "another function called": (f"= {SHARED}_update_sum_1(d_x)", f"= {SHARED}_dcm_sum_1(d_x)"),
    "a limb of another word": ("low_16(a)", "low_16(b)"),
    "another low limb": ("x << 16), 16)", "x << 15), 15)"),
}


@pytest.mark.parametrize("what", TAMPERED)
def test_text_that_is_not_the_routine_is_refused(what: str) -> None:
    bundle, (old, new) = shipped(SHARED), TAMPERED[what]
    read_back(bundle)
    assert old in bundle.source
    with pytest.raises(CheckError, match="is not"):
        read_back(replace(bundle, source=bundle.source.replace(old, new, 1)))


# -- banner -------------------------------------------------------------------------------------------------

PROVED = "of 16- and 15-bit limbs, added before the carry, proved to fit 32 bits"
TOLD = {
    ("cortex-m0", "auto"): f"{PROVED}: cortex-m0 has none of 64 bits",
    (
        "cortex-m0plus",
        "limbs-shared",
    ): f"{PROVED}, alike sums in functions of their own: cortex-m0plus has none of 64 bits",
    ("generic", "limbs"): f'{PROVED}: as multiply = "limbs" asks',
    ("generic", "wide"): "of 64 bits, as C has them",
    ("cortex-m4", "auto"): "of 64 bits, as cortex-m4 has them",
    ("cortex-m0", "library"): "of 64 bits, by the compiler's library: cortex-m0 has none of 64 bits",
    ("generic", "library"): 'of 64 bits, by the compiler\'s library: as multiply = "library" asks',
    ("generic", "auto"): "",
}


@pytest.mark.parametrize(("core", "multiply"), TOLD)
def test_banner_says_which_form_and_why(core: str, multiply: str) -> None:
    bundle = made(FLAGSHIP, "fixed32", "delta", core=core, multiply=multiply)
    banner = " ".join(bundle.source.partition("*/")[0].replace("\n *", " ").split())
    said = TOLD[core, multiply]
    assert bundle.facts.products == said
    assert (f" products: {said} high words:" in banner) if said else ("products: of" not in banner)
    assert ("sums as in 64;" in banner) == said.startswith(PROVED)


def test_banner_counts_the_products_of_64_bits_that_are_left() -> None:
    bundle = made(FLAGSHIP, "fixed32", "compensated", core="cortex-m0")
    left = long_products(bundle.machine)
    assert left
    assert bundle.facts.products.endswith(
        f"; {left} of 64 bits, in sums of another kind or where limbs are not proved to fit"
    )


@pytest.mark.parametrize("number", ["fixed16", "float32"])
def test_banner_is_silent_where_there_is_no_choice(number: str) -> None:
    assert made(FLAGSHIP, number, "delta", core="cortex-m0").facts.products == ""
