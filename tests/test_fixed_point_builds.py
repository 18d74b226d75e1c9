"""The bits of fixed point hold on every compiler, at every level, with any flags, and under the sanitizers."""

from __future__ import annotations

import platform
from collections.abc import Callable
from typing import NoReturn

import pytest

from fixed_designs import FLAGSHIP, made
from qcone.bundle import Bundle
from qcone.targets.compiler import LEVELS, Compiler, compilers
from qcone.targets.probe import has_fma
from qcone.verify import verify

FLAGS = ("-ffp-contract=fast", "-fno-signed-zeros", "-ffinite-math-only", "-fno-strict-aliasing")
"""Of -ffast-math, what does not outlast the library: all of it links code that turns subnormals off for the process."""
OUTPUTS = "quaternion,dcm,euler"


def flagship(number: str, rounding: str = "up") -> Bundle:
    return made(FLAGSHIP, number, "compensated", outputs=OUTPUTS, rounding=rounding)


@pytest.mark.parametrize(("number", "rounding"), [("fixed32", "up"), ("fixed32", "even"), ("fixed16", "up")])
@pytest.mark.parametrize("compiler", compilers(), ids=lambda each: each.name)
def test_no_flag_and_no_level_changes_a_bit(compiler: Compiler, number: str, rounding: str) -> None:
    fused = ("-mfma",) if has_fma() and platform.machine().lower() in ("x86_64", "amd64", "i686") else ()
    outcomes = list(verify(flagship(number, rounding), 4000, " ".join(compiler.command), (*FLAGS, *fused)))
    assert {each.level for each in outcomes} >= set(LEVELS)
    for each in outcomes:
        assert (each.status, each.differing_bits, each.contracted or False) == ("ok", 0, False), each
        assert each.sanitizer_reports in (None, 0)


def test_both_sanitizers_look_at_it(missing_tool: Callable[[str], NoReturn]) -> None:
    gcc = [each for each in compilers() if each.family == "gcc"]
    if not gcc:
        missing_tool("gcc (apt install gcc)")
    outcomes = verify(flagship("fixed32"), 2000, gcc[0].command[0])
    (ran,) = (each for each in outcomes if each.sanitizer_reports is not None)
    assert ran.compiler.endswith(" undefined+address")
    assert (ran.status, ran.sanitizer_reports, ran.differing_bits) == ("ok", 0, 0)
