"""Series rolled into loops and written out: the same bits; what either costs in products and in bytes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from elf import read_symbols
from qcone.bundle import Bundle
from qcone.pipeline import build
from qcone.targets.build import compile_object
from qcone.targets.compiler import Compiler
from qcone.vectors import draw
from qcone.verify import c_words, differing_bits, model_words, open_library
from shipped import DESIGNS, design_of, shipped

CORTEX_M4F = ("-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m4+vfp4d16sp", "-fno-unwind-tables")
SERIES = [name for name in DESIGNS if "taylor" in name and "rolled" in name]
ROLLED = "quaternion_taylor_3_10_rolled_float32"
UPDATE_BYTES = 750


def written_out(bundle: Bundle) -> Bundle:
    """Return the bundle of the same design with its loops written out."""
    return build(replace(bundle.facts.design, loop="unrolled"))


@pytest.mark.parametrize("name", SERIES)
def test_rolled_and_written_out_are_the_same_bits(first_compiler: Compiler, name: str) -> None:
    rolled = shipped(name)
    other = written_out(rolled)
    assert "for (" in rolled.source
    assert "for (" not in other.source
    vectors = draw(rolled, 4000)
    found, _ = c_words(rolled, open_library(rolled, first_compiler, "-O2"), vectors)
    expected, _ = c_words(other, open_library(other, first_compiler, "-O2"), vectors)
    assert np.isfinite(found).all()
    assert differing_bits(found, expected) == 0
    assert differing_bits(found, model_words(other, vectors)) == 0


@pytest.mark.parametrize("number", ["float32", "float64"])
@pytest.mark.parametrize(
    ("example", "most"),
    [("quaternion-taylor subsamples=3 order=10 about=start", 334), ("dcm-taylor subsamples=3 order=10", 399)],
)
def test_products_of_an_update_written_out(example: str, most: int, number: str) -> None:
    """Renormalisation included, products by powers of two apart; no division, root or sine."""
    counts = build(design_of(example, number=number)).facts.counts["update"]["emitted"]
    assert counts.multiply <= most
    assert (counts.divide, counts.square_root, counts.trigonometric) == (0, 0, 0)


@pytest.fixture(scope="module")
def bytes_of(zig: Compiler) -> dict[str, int]:
    """The update of the rolled and of the written-out design on Cortex-M4F at -Os."""
    bundle = shipped(ROLLED)
    found = {}
    for loop, each in (("rolled", bundle), ("unrolled", written_out(bundle))):
        files = {f"{ROLLED}.h": each.header, f"{ROLLED}.c": each.source}
        symbols = read_symbols(compile_object(zig, files, "-Os", target_flags=CORTEX_M4F).read_bytes())
        assert symbols.undefined == frozenset()
        found[loop] = symbols.sizes[f"{ROLLED}_update"]
    return found


def test_a_rolled_update_is_small(bytes_of: dict[str, int]) -> None:
    assert bytes_of["rolled"] <= UPDATE_BYTES
    assert bytes_of["unrolled"] > 3 * bytes_of["rolled"]
