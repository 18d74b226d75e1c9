"""Gates: what may not stand in a program of this design on this target, found in the code without running it.

Each changes bits, or cost by a factor of ten, and compilers do it without a word: floats computed in software beside
an FPU, a double in single precision, a product fused with a sum.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from qcone.targets.code import Disassembler
from qcone.targets.elf import Function, Image
from qcone.targets.library import public_name, soft_bits
from qcone.targets.machines import Target

_DEFINITION = re.compile(r"^(?:static |inline )*(?:const )?\w+ \**(\w+)\((?!.*;$)", re.MULTILINE)


@dataclass(frozen=True)
class Finding:
    """One thing that may not be: its gate (`soft-float`, `stray-double`, `fused`), and what to do."""

    gate: str
    text: str


def defined_in(source: str) -> frozenset[str]:
    """Return the names of the functions that emitted C text defines, each at the beginning of a line."""
    return frozenset(_DEFINITION.findall(source))


def emitted_functions(image: Image, own: frozenset[str]) -> tuple[Function, ...]:
    """Return the functions of an image that have these names, and the parts a compiler made of them (`name.part.0`)."""
    return tuple(each for each in image.functions if each.name.partition(".")[0] in own)


def called(code: Disassembler, functions: Iterable[Function]) -> dict[int, str]:
    """Return what functions call directly and is none of them: addresses, and the names the image has for them."""
    own = tuple(functions)
    found: dict[int, str] = {}
    for function in own:
        for to in code.destinations(function):
            names = code.image.names_at(to)
            if names and not any(to in each for each in own):
                found[to] = public_name(names)
    return dict(sorted(found.items(), key=lambda each: each[1]))


def findings(code: Disassembler, names: frozenset[str], target: Target, bits: int | None) -> Iterator[Finding]:
    """Yield what may not be in a design's functions, by their names; `bits` of its floats, None for fixed point."""
    own = emitted_functions(code.image, names)
    for routine in sorted(set(called(code, own).values())):
        width = soft_bits(routine)
        if routine in ("fmaf", "fma"):
            yield Finding("fused", f"{routine} is called, which fuses a product with a sum")
        if width is not None and (bits is None or width > bits):
            meant = "fixed point" if bits is None else f"float{bits}"
            yield Finding("stray-double", f"{routine} is called, and nothing in {meant} code needs it")
        elif width is not None and target.computes(width):
            hint = f"tell the compiler of it: {' '.join(target.zig)} for clang, {' '.join(target.gcc)} for gcc"
            yield Finding("soft-float", f"{routine} is called, though {target.name} has an FPU for it; {hint}")
    for function in own:
        for instruction in code.of(function):
            computed = code.arithmetic(instruction)
            if computed is None:
                continue
            place = f"{instruction.mnemonic} at {code.image.place(instruction.address)}"
            if computed.fused:
                yield Finding("fused", f"{place} fuses a product with a sum: compile with -ffp-contract=off")
            elif bits is None or computed.bits > bits:
                yield Finding("stray-double", f"{place} computes {computed.bits} bits in narrower code")
