"""Machine code read back: float operations by name, calls near and far, data between code, gates, reconciled counts."""

from __future__ import annotations

from dataclasses import replace

import pytest
from code_on import EMULATED, image_of

from qcone.errors import UsageError
from qcone.targets.code import Arithmetic, Disassembler
from qcone.targets.elf import check_fits, read_image
from qcone.targets.gates import findings
from qcone.targets.library import adds, multiplies, soft_bits
from qcone.targets.machines import TARGETS

FLOATING = [name for name in EMULATED if TARGETS[name].computes(32)]
POLYNOMIAL = (
    "float called(float a, float b, float c);\n"
    "float called(float a, float b, float c) { const float m = a * b; const float s = m + c; return s - a; }\n"
)


def computed(text: str, target: str, *extra: str) -> list[Arithmetic]:
    image = image_of(text, target, extra)
    code = Disassembler(image)
    function = image.function("called")
    assert function
    return [found for each in code.of(function) if (found := code.arithmetic(each))]


@pytest.mark.parametrize("target", FLOATING)
def test_products_and_sums_of_every_fpu(target: str) -> None:
    found = computed(POLYNOMIAL, target)
    assert (sum(each.multiply for each in found), sum(each.add for each in found)) == (1, 2)
    assert {(each.fused, each.bits) for each in found} == {(False, 32)}
    double = [TARGETS[target].computes(64)] and computed(POLYNOMIAL.replace("float", "double"), target)
    assert {each.bits for each in double} == ({64} if TARGETS[target].computes(64) else set())


@pytest.mark.parametrize("target", ["cortex-m7f", "rv32imfc", "powerpc"])
def test_fused_product_is_known(target: str) -> None:
    assert any(each.fused for each in computed(POLYNOMIAL, target, "-ffp-contract=fast"))


def test_product_summed_with_two_roundings_is_not_fused() -> None:
    """VMLA rounds its product; gcc -Os uses it, and clang for the Cortex-M7."""
    (first, second) = computed(POLYNOMIAL, "cortex-m7f")
    assert (first.multiply, first.add, first.fused) == (1, 1, False)
    assert (second.multiply, second.add) == (0, 1)


DOUBLES = "float called(float a);\nfloat called(float a) { return (float)(0.1 * a); }\n"


@pytest.mark.parametrize("target", EMULATED)
def test_calls_are_found_near_and_far(target: str) -> None:
    image = image_of(DOUBLES, target)
    function = image.function("called")
    assert function
    to = {name for at in Disassembler(image).destinations(function) for name in image.names_at(at)}
    product = {"__aeabi_dmul", "__muldf3"} & to
    assert bool(product) == (not TARGETS[target].computes(64))


def test_literals_between_code_are_not_read_as_code() -> None:
    """0xee070a81 as data is a VMLA as code."""
    text = "float called(float a);\nfloat called(float a) { return a * -1.04482937e+28F; }\n"
    image = image_of(text, "cortex-m4f")
    function = image.function("called")
    assert function
    code = Disassembler(image)
    assert image.marks
    end = max(each.fall_through for each in code.of(function))
    assert end < function.address + function.size
    assert bytes.fromhex("810a07ee") in image.bytes_at(end, 8)
    assert sum(each.multiply for each in computed(text, "cortex-m4f")) == 1


BROKEN = replace(TARGETS["cortex-m4f"], zig=("-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m4"))
FMA = "float called(float a, float b, float c);\nfloat called(float a, float b, float c) "


def gates(text: str, target, bits: int | None = 32, *extra: str) -> list[str]:
    text = text.replace("called", "design_update")
    image = image_of(text + "\nvoid called(void);\nvoid called(void) { }\n", target, ("-Wl,-u,design_update", *extra))
    return sorted({each.gate for each in findings(Disassembler(image), frozenset({"design_update"}), target, bits)})


def test_gates() -> None:
    m0, m4f, m7f = (TARGETS[name] for name in ("cortex-m0", "cortex-m4f", "cortex-m7f"))
    assert gates(POLYNOMIAL, m0) == gates(POLYNOMIAL, m4f) == gates(POLYNOMIAL, m7f) == []
    assert gates(POLYNOMIAL, BROKEN) == ["soft-float"], "the FPU is not named"
    assert gates(POLYNOMIAL.replace("float", "double"), m4f, 64) == [], "which its FPU does not compute"
    assert gates(DOUBLES, m0) == gates(DOUBLES, m4f) == gates(DOUBLES, m7f) == ["stray-double"]
    assert gates(POLYNOMIAL, m4f, None) == gates(POLYNOMIAL, m0, None) == ["stray-double"], "in fixed point"
    assert gates(POLYNOMIAL, m7f, 32, "-ffp-contract=fast") == ["fused"]
    assert gates(FMA + "{ return __builtin_fmaf(a, b, c); }\n", m0) == ["fused"]


NAMES = {
    "__aeabi_fadd": (32, False, True),
    "__aeabi_fmul": (32, True, False),
    "__aeabi_frsub": (32, False, True),
    "__aeabi_cfcmple": (32, False, False),
    "__aeabi_ui2f": (32, False, False),
    "__mulsf3": (32, True, False),
    "__subsf3": (32, False, True),
    "__aeabi_dmul": (64, True, False),
    "__aeabi_d2f": (64, False, False),
    "__aeabi_f2d": (64, False, False),
    "__aeabi_cdcmple": (64, False, False),
    "__adddf3": (64, False, True),
    "__extendsfdf2": (64, False, False),
    "__truncdfsf2": (64, False, False),
    "__floatsidf": (64, False, False),
    "__aeabi_lmul": (None, False, False),
    "__aeabi_idiv": (None, False, False),
    "__aeabi_memcpy": (None, False, False),
    "__divsi3": (None, False, False),
    "memset": (None, False, False),
}


@pytest.mark.parametrize("name", NAMES)
def test_library_routines_by_name(name: str) -> None:
    assert (soft_bits(name), multiplies(name), adds(name)) == NAMES[name]


def test_files_that_are_no_program() -> None:
    with pytest.raises(UsageError, match=r"^notes.txt: not a whole ELF file: "):
        read_image(b"not an ELF file at all", "notes.txt")
    from qcone.targets.cross import build, cross_compiler

    path = build(cross_compiler(), TARGETS["cortex-m4f"], {"called.c": POLYNOMIAL}, ["called"])
    data = path.read_bytes()
    for length in (4, 40, 52, len(data) // 2):
        with pytest.raises(UsageError, match=r"^cut.elf: "):
            read_image(data[:length], "cut.elf")
    image = read_image(data, "whole.elf")
    check_fits(image, TARGETS["cortex-m4f"], "whole.elf")
    with pytest.raises(UsageError, match="it is little-endian arm, not rv32imc; name its target"):
        check_fits(image, TARGETS["rv32imc"], "whole.elf")
    with pytest.raises(UsageError, match="it is not linked: give the program, not an object"):
        check_fits(replace(image, linked=False), TARGETS["cortex-m4f"], "whole.elf")
    other = data[:18] + (62).to_bytes(2, "little") + data[20:]
    with pytest.raises(UsageError, match="an ELF file of 32 bits for EM_X86_64; no target is that"):
        read_image(other, "other.elf")
