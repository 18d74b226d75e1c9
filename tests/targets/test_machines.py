"""The table of targets is whole: every name of a design file, what compilers are told, what arithmetic there is."""

from __future__ import annotations

import pytest

from qcone.design import TARGETS as NAMES
from qcone.errors import UsageError
from qcone.targets.cycles import MODELS
from qcone.targets.machines import DOUBLE, NONE, SINGLE, TARGETS, targets_of
from qcone.targets.qemu import boards_for

EMULATED = [each for each in TARGETS.values() if each.emulated]


def test_every_name_of_a_design_file_has_its_row() -> None:
    assert tuple(TARGETS) == NAMES


@pytest.mark.parametrize("target", EMULATED, ids=lambda each: each.name)
def test_an_fpu_is_named_to_both_compilers(target) -> None:
    """Without its name clang makes soft float of a hard-float ABI."""
    words = " ".join(target.zig)
    if target.architecture == "arm":
        assert ("eabihf" in words) == ("-mfloat-abi=hard" in target.gcc) == (target.fpu != NONE)
        assert ("vfp4d16sp" in words or "fp_armv8d16sp" in words) == (target.fpu == SINGLE)
        assert ("fp_armv8d16" in words and "d16sp" not in words) == (target.fpu == DOUBLE)
    if target.architecture == "riscv":
        assert ("+f" in words) == ("-mabi=ilp32f" in target.gcc) == (target.fpu == SINGLE)


def test_what_each_fpu_computes() -> None:
    assert {name: (each.computes(32), each.computes(64)) for name, each in TARGETS.items() if each.emulated} == {
        **dict.fromkeys(("cortex-m0", "cortex-m0plus", "cortex-m3", "cortex-m4", "rv32imc"), (False, False)),
        **dict.fromkeys(("cortex-m4f", "cortex-m33f", "rv32imfc"), (True, False)),
        **dict.fromkeys(("cortex-m7f", "powerpc"), (True, True)),
    }


def test_products_that_one_instruction_gives() -> None:
    """As the architecture manuals have them: ARMv6-M has 32 bits alone; SMMUL came with the DSP extension."""
    assert [name for name, each in TARGETS.items() if not each.long_multiply] == ["cortex-m0", "cortex-m0plus"]
    without = [name for name, each in TARGETS.items() if not each.high_word]
    assert without == ["cortex-m0", "cortex-m0plus", "cortex-m3"]


def test_cycles_have_a_table_and_boards_a_core() -> None:
    assert {each.cycles for each in EMULATED} - {None} == set(MODELS)
    assert [each.name for each in boards_for(EMULATED, "all")] == [
        *("cortex-m0", "cortex-m3", "cortex-m4", "cortex-m4f", "cortex-m7f", "cortex-m33f")
    ]


def test_lists_of_names() -> None:
    assert [each.name for each in targets_of("cortex-m4f, host,cortex-m4f")] == ["cortex-m4f", "host"]
    assert targets_of("all") == tuple(TARGETS.values())


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("cortexm4f", "--target cortexm4f: unknown target; did you mean 'cortex-m4f'?"),
        ("host,al", "--target al: unknown target; did you mean 'all'?"),
        ("avr", "--target avr: unknown target; the targets are: host, cortex-m0"),
        ("", "--target : unknown target; the targets are: "),
    ],
)
def test_unknown_target(words: str, said: str) -> None:
    with pytest.raises(UsageError) as caught:
        targets_of(words)
    assert str(caught.value).startswith(said)
