"""Products: how the design's core multiplies words, chosen by its keys `core` and `multiply`, and told in the banner.

The bits are the same whatever the form; instructions, bytes and the compiler's library are not.
"""

from __future__ import annotations

from typing import NoReturn

from qcone.admission import problem
from qcone.backends.counts import products
from qcone.design import Design
from qcone.formats.fixed import WIDTHS
from qcone.formats.floating import FLOATING
from qcone.ir.statement import Program
from qcone.passes.integers import LIMBS
from qcone.passes.limb_ranges import WORD
from qcone.targets.machines import TARGETS


def products_of(design: Design) -> str:
    """Return how the design's products are made: wide, limbs, limbs-shared or library.

    Raises DesignError where its number format, or its core, has no such form.
    """
    chosen, asked = design.number, design.multiply
    wide = WIDTHS.get(chosen.format, 0) < WORD  # floats and short words: every core, or its library, has their products
    short = _short(design)
    if asked == "auto":
        if wide or not short:
            return "wide"
        return "limbs" if chosen.rounding != "even" and chosen.overflow == "prove" else "library"
    if chosen.format in FLOATING or (wide and asked != "wide"):
        kind = "floats are the core's own, or its library's" if chosen.format in FLOATING else "its words fit 32 bits"
        _no_products(design, f'number.format = "{chosen.format}"', f"products of {kind}", "leave the key out")
    if asked in LIMBS:
        hint = f'set multiply = "{"library" if short else "wide"}"'
        if chosen.rounding == "even":
            _no_products(design, 'number.rounding = "even"', "a tie shows in the whole sum alone", hint)
        if chosen.overflow != "prove":
            why = "limbs are proved to fit in the declared range alone"
            _no_products(design, f'number.overflow = "{chosen.overflow}"', why, hint)
    if short and asked == "wide" and not wide:
        hint = f"use {', '.join(LIMBS)} or library, or leave the key out"
        _no_products(design, f'core = "{design.core}"', "it has no instruction for products of 64 bits", hint)
    if design.core in TARGETS and not short and asked == "library":
        why = "it has an instruction for products of 64 bits"
        _no_products(design, f'core = "{design.core}"', why, "leave the key out")
    return asked


def _no_products(design: Design, other: str, why: str, hint: str) -> NoReturn:
    raise problem(design, "QC209", f'multiply = "{design.multiply}" does not go with {other}', why, hint)


def told(design: Design, form: str, machine: Program) -> str:
    """Return how products are made and why, where the design says it or its core asks for it; else nothing."""
    if WIDTHS.get(design.number.format, 0) < WORD or (design.core, design.multiply) == ("generic", "auto"):
        return ""
    if form == "wide":
        return "of 64 bits, as C has them" if design.core == "generic" else f"of 64 bits, as {design.core} has them"
    why = f"{design.core} has none of 64 bits" if _short(design) else f'as multiply = "{form}" asks'
    if form == "library":
        return f"of 64 bits, by the compiler's library: {why}"
    shared = ", alike sums in functions of their own" if form == "limbs-shared" else ""
    left = sum(products(routine).whole for routine in machine.routines)
    rest = f"; {left} of 64 bits, in sums of another kind or where limbs are not proved to fit" if left else ""
    return f"of 16- and 15-bit limbs, added before the carry, proved to fit 32 bits{shared}: {why}{rest}"


def _short(design: Design) -> bool:
    """Tell whether the core is known to have no instruction for products of 64 bits."""
    core = TARGETS.get(design.core)
    return core is not None and not core.long_multiply
