"""Cycle counts against sums made by hand from the cores' manuals."""

from __future__ import annotations

import numpy as np
import pytest
from code_on import image_of

from qcone.targets.code import Disassembler
from qcone.targets.cycles import MODELS, cycles
from qcone.targets.emulation import Call, Emulation, job_for
from qcone.targets.job import Buffer, Pointer
from qcone.targets.machines import TARGETS

# name: (assembly, loads and stores through r0; {model: (low, high)}, `bx lr` included)
LISTINGS = {
    "sums": ("adds r1, r1, r2\\n adds r1, r1, r2", {"m0": (5, 5), "m0plus": (4, 4), "m3": (4, 6), "m4": (4, 6)}),
    "a product": ("muls r1, r2, r1", {"m0": (4, 35), "m0plus": (3, 34), "m3": (3, 5), "m4": (3, 5)}),
    "a load and a store": (
        "ldr r1, [r0]\\n str r1, [r0]",
        {"m0": (7, 7), "m0plus": (6, 6), "m3": (4, 8), "m4": (4, 8)},
    ),
    "three registers each way": (
        "push {r4, r5, r6}\\n pop {r4, r5, r6}",
        {"m0": (11, 11), "m0plus": (10, 10), "m3": (10, 12), "m4": (10, 12)},
    ),
    "a branch taken": ("b 1f\\n nop\\n1:", {"m0": (6, 6), "m0plus": (4, 4), "m3": (4, 8), "m4": (4, 8)}),
    "a branch not taken": (
        "cmp r0, r0\\n bne 1f\\n1:",
        {"m0": (5, 5), "m0plus": (4, 4), "m3": (4, 6), "m4": (4, 6)},
    ),
    "a 64-bit product": ("umull r1, r2, r2, r1", {"m3": (5, 9), "m4": (3, 5)}),
    "a sum of 64-bit products": ("umlal r1, r2, r2, r1", {"m3": (6, 11), "m4": (3, 5)}),
    "a block passed over": ("cmp r0, r0\\n itt ne\\n movne r1, r2\\n movne r2, r1", {"m3": (6, 8), "m4": (6, 8)}),
}
FLOATS = {
    "products apart": ("vmul.f32 s0, s1, s2\\n vmul.f32 s3, s1, s2", (4, 6)),
    "a sum that waits for its product": ("vmul.f32 s0, s1, s2\\n vadd.f32 s0, s0, s1", (5, 7)),
    "a product with a sum": ("vmla.f32 s0, s1, s2", (5, 7)),
    "a quotient": ("vdiv.f32 s0, s1, s2", (16, 18)),
    "a load and a store": ("vldr s0, [r0]\\n vstr s0, [r0]", (4, 8)),
}
CALLED = 'void called(void *p);\n__attribute__((naked)) void called(void *p) {{ __asm__("{}\\n bx lr"); }}\n'


def counted(target: str, listing: str) -> tuple[int, int]:
    image = image_of(CALLED.format(listing), target, ("-Wno-everything",))
    function = image.function("called")
    assert function
    job = job_for(
        TARGETS[target], image, (Buffer("p", bytes(8), True),), (Call(function.address, (Pointer(0),), traced=True),)
    )
    with Emulation() as emulation:
        ran = emulation.run(job)
    assert ran.fault is None
    model = MODELS[TARGETS[target].cycles or ""]
    return cycles(model, Disassembler(image), np.frombuffer(ran.traces[0], np.uint32))


@pytest.mark.parametrize("what", LISTINGS)
def test_integer_listing(what: str) -> None:
    listing, wanted = LISTINGS[what]
    assert {core: counted(f"cortex-{core}", listing) for core in wanted} == wanted


@pytest.mark.parametrize("what", FLOATS)
def test_float_listing(what: str) -> None:
    listing, wanted = FLOATS[what]
    assert counted("cortex-m4f", listing) == wanted


def test_every_table_says_what_it_assumes() -> None:
    assert all("without wait states" in each.assumptions for each in MODELS.values())
