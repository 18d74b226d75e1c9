"""What an update costs: within the figures asked for, the same every time, explained by the operations emitted."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NoReturn

import pytest

from qcone.cost import Cost, measure, measure_elf
from qcone.errors import CheckError, UsageError
from qcone.studies.costing import code_digest
from qcone.studies.kept_costs import FILE, with_table
from qcone.targets import build
from qcone.targets.cross import build as build_program
from qcone.targets.cross import cross_compiler
from qcone.targets.emulation import Emulation
from qcone.targets.machines import TARGETS
from shipped import shipped, tampered

DELTA = "rotation_vector_3_coning_float32"
STANDARD, COMPENSATED = f"{DELTA}_standard", f"{DELTA}_compensated"
M4F = TARGETS["cortex-m4f"]
C_OUT = Path(__file__).parents[1] / "c_out"
TIMED = ("cortex-m0", "cortex-m0plus", "cortex-m3", "cortex-m4", "cortex-m4f")
EMULATED = [name for name, each in TARGETS.items() if each.emulated]
MissingTool = Callable[[str], NoReturn]


@pytest.fixture(scope="module")
def emulation() -> Iterator[Emulation]:
    with Emulation() as one:
        yield one


@pytest.fixture(scope="module")
def arm_gcc(missing_tool: MissingTool) -> str:
    return shutil.which("arm-none-eabi-gcc") or missing_tool("arm-none-eabi-gcc (apt install gcc-arm-none-eabi)")


# N = 3, |phi| <= 0.102, renormalised on every update: instructions, bytes of text, bytes of stack.
MOST = {STANDARD: (114, 470, 24), DELTA: (114, 470, 24), COMPENSATED: (136, None, None)}


@pytest.mark.parametrize("name", MOST)
def test_cortex_m4f_keeps_within_its_figures(name: str, emulation: Emulation) -> None:
    found = measure(shipped(name), M4F, cross_compiler(), "-O2", emulation)
    instructions, text, stack = MOST[name]
    least, most = found.executed.instructions
    assert least == most <= instructions, "no instruction depends on data"
    assert found.executed.updates == 1000
    assert text is None or found.text_bytes <= text
    assert stack is None or found.stack_bytes <= stack
    assert (found.executed.routines, found.executed.fused, found.soft_float, found.findings) == ((), (), (), ())
    assert found.library_bytes == found.read_only_bytes == 0


# The same in fixed point on cores with products of 64 bits: instructions and bytes of stack.
LONG = {
    ("rotation_vector_3_coning_fixed32", "cortex-m4"): (185, None),
    ("rotation_vector_3_coning_fixed32_compensated", "cortex-m4"): (295, 180),
    ("rotation_vector_3_coning_fixed32_compensated", "rv32imc"): (510, None),
}


@pytest.mark.parametrize(("name", "target"), LONG)
def test_fixed_point_keeps_within_its_figures(name: str, target: str, emulation: Emulation) -> None:
    found = measure(shipped(name), TARGETS[target], cross_compiler(), "-O2", emulation)
    instructions, stack = LONG[name, target]
    least, most = found.executed.instructions
    assert least == most <= instructions, "no instruction depends on data"
    assert stack is None or found.stack_bytes <= stack
    assert (found.executed.routines, found.findings) == ((), ())


def test_gcc_keeps_fixed_point_within_its_figure(arm_gcc: str, emulation: Emulation) -> None:
    name = "rotation_vector_3_coning_fixed32_compensated"
    found = measure(shipped(name), TARGETS["cortex-m4"], cross_compiler(arm_gcc), "-O2", emulation)
    assert found.executed.instructions[0] == found.executed.instructions[1] <= 245


# And on cores whose products have 32 bits: instructions and bytes of text, at a level.
SHORT = {
    ("limbs", "-O2"): (950, None),
    ("limbs_shared", "-Os"): (1050, 1550),
    ("library", "-O2"): (None, 1150),
    ("library", "-Os"): (None, 1150),
}


@pytest.mark.parametrize("target", ["cortex-m0", "cortex-m0plus"])
@pytest.mark.parametrize(("form", "level"), SHORT)
def test_products_of_small_cores_keep_within_their_figures(
    form: str, level: str, target: str, emulation: Emulation
) -> None:
    found = measure(
        shipped(f"rotation_vector_3_coning_fixed32_{form}"), TARGETS[target], cross_compiler(), level, emulation
    )
    instructions, text = SHORT[form, level]
    least, most = found.executed.instructions
    assert least == most, "no instruction depends on data"
    assert instructions is None or most <= instructions
    assert text is None or found.text_bytes <= text
    assert found.executed.routines == (("__aeabi_lmul",) if form == "library" else ())
    assert found.findings == ()


def test_gcc_for_size_keeps_within_its_figure(arm_gcc: str, emulation: Emulation) -> None:
    found = measure(shipped(DELTA), M4F, cross_compiler(arm_gcc), "-Os", emulation)
    assert found.executed.instructions[0] == found.executed.instructions[1] <= 92
    assert found.compiler.startswith("arm-none-eabi-gcc ")


@pytest.mark.parametrize("target", EMULATED)
def test_operations_executed_are_those_emitted(target: str, emulation: Emulation) -> None:
    """38 products and one by 2^-1, 33 + 13 sums: instructions where there is an FPU, calls where there is none."""
    found = measure(shipped(DELTA), TARGETS[target], cross_compiler(), "-O2", emulation)
    assert found.reconciliation
    assert (found.reconciliation.holds, found.executed.multiply, found.executed.add) == (True, (39, 39), (46, 46))
    soft = not TARGETS[target].computes(32)
    assert bool(found.soft_float) == bool(found.executed.routines) == bool(found.library_bytes) == soft
    assert (found.executed.cycles is not None) == (target in TIMED)
    if found.executed.cycles:
        low, high = found.executed.cycles
        assert found.executed.instructions[0] < low < high


def figures(found: Cost) -> tuple[object, ...]:
    return found.executed, found.text_bytes, found.read_only_bytes, found.library_bytes, found.stack_bytes


def test_figures_are_the_same_in_three_runs_and_from_an_empty_cache(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, emulation: Emulation
) -> None:
    bundle, target = shipped(DELTA), TARGETS["cortex-m4"]
    first = measure(bundle, target, cross_compiler(), "-O2", emulation)
    with Emulation() as another:
        again = measure(bundle, target, cross_compiler(), "-O2", another)
    monkeypatch.setattr(build, "_folder", lambda: tmp_path)
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(tmp_path / "zig"))
    monkeypatch.setenv("ZIG_LOCAL_CACHE_DIR", str(tmp_path / "zig"))
    emptied = measure(bundle, target, cross_compiler(), "-O2", emulation)
    assert len(list(tmp_path.glob("*.elf"))) == 1
    assert figures(first) == figures(again) == figures(emptied)


def test_other_bits_have_no_figures(emulation: Emulation) -> None:
    with pytest.raises(CheckError, match="on cortex-m4f: not measured: its bits are not the model's: lane 0, step "):
        measure(tampered(DELTA, "0.225F", "0.22500002F"), M4F, cross_compiler(), "-O2", emulation)


def test_a_fault_has_no_figures(emulation: Emulation) -> None:
    read = "const float dtheta1_x = *(const float *)(const void *)((const char *)dtheta + 2);"
    bundle = tampered(DELTA, "const float dtheta1_x = dtheta[0];", read)
    with pytest.raises(CheckError, match=f"^{DELTA} on cortex-m4f: unaligned: read of 4 bytes at "):
        measure(bundle, M4F, cross_compiler(), "-O2", emulation)


def test_a_product_that_is_not_emitted_is_reported(emulation: Emulation) -> None:
    """Bits that stay the same do not hide it: x * 1 is x, made where the compiler cannot see it."""
    one = "const volatile float unit = 1.0F;\n    const float dtheta1_x = dtheta[0] * unit;"
    found = measure(tampered(DELTA, "const float dtheta1_x = dtheta[0];", one), M4F, cross_compiler(), "-O2", emulation)
    assert found.reconciliation
    assert not found.reconciliation.holds
    assert found.reconciliation.text.startswith("39 products and 46 sums emitted, but 40 and 46 executed")


MAIN = """\
#include "{name}.h"
void firmware(void);
static {name}_state state;
static float samples[9];
void firmware(void) {{ {name}_init(&state); for (;;) {{ {name}_update(&state, samples); }} }}
"""


def firmware(cc: str | None, *flags: str) -> Path:
    bundle = shipped(DELTA)
    sources = {name: text for name, text in bundle.sources.items() if not name.endswith("_run.c")}
    files = {**sources, "firmware.c": MAIN.format(name=DELTA)}
    return build_program(cross_compiler(cc), M4F, files, ["firmware"], "-Os", flags)


def test_a_users_own_build_is_measured(arm_gcc: str, emulation: Emulation) -> None:
    found = measure_elf(shipped(DELTA), M4F, firmware(arm_gcc), emulation)
    own = measure(shipped(DELTA), M4F, cross_compiler(arm_gcc), "-Os", emulation)
    assert (found.executed.instructions, found.text_bytes, found.stack_bytes) == (
        *(own.executed.instructions, own.text_bytes, own.stack_bytes),
    )
    assert found.compiler.startswith("GCC: (")
    assert (found.level, found.read_only_bytes, found.library_bytes) == (None, None, None)


def test_a_users_build_that_fuses_is_found_out(emulation: Emulation) -> None:
    with pytest.raises(CheckError, match="its bits are not the model's"):
        measure_elf(shipped(DELTA), TARGETS["cortex-m7f"], fused_firmware(), emulation)


def fused_firmware() -> Path:
    bundle = shipped(DELTA)
    sources = {name: text for name, text in bundle.sources.items() if not name.endswith("_run.c")}
    files = {**sources, "firmware.c": MAIN.format(name=DELTA)}
    m7f, fast = TARGETS["cortex-m7f"], ("-ffp-contract=fast",)
    return build_program(cross_compiler(), m7f, files, ["firmware"], "-O2", fast)


def test_a_program_without_the_update(tmp_path: Path, emulation: Emulation) -> None:
    text = {"other.c": "void other(void);\nvoid other(void) { }\n"}
    with pytest.raises(UsageError, match=f"^the program has no function {DELTA}_update: link the design into it, "):
        measure_elf(shipped(DELTA), M4F, build_program(cross_compiler(), M4F, text, ["other"]), emulation)
    with pytest.raises(UsageError, match="No such file or directory; give the program your linker wrote"):
        measure_elf(shipped(DELTA), M4F, tmp_path / "absent.elf", emulation)


def test_kept_figures_are_those_of_the_c_beside_them() -> None:
    kept = sorted(C_OUT.glob(f"*/{FILE}"))
    assert {f"{DELTA}{way}" for way in ("", "_standard", "_compensated")} <= {path.parent.name for path in kept}
    for path in kept:
        source = (path.parent / "src" / f"{path.parent.name}.c").read_text(encoding="utf-8")
        assert json.loads(path.read_text())["source"] == code_digest(source), path


def test_comments_and_space_are_no_part_of_what_was_measured() -> None:
    assert code_digest("a = b; /* one\n two */\n c;") == code_digest("a = b;  c; /* three */")
    assert code_digest("a = b;") != code_digest("a = c;")


def test_table_of_the_readme_is_made_of_the_kept_figures() -> None:
    text = (C_OUT.parent / "README.md").read_text(encoding="utf-8")
    assert with_table(text, C_OUT) == text
    assert with_table("no markers", C_OUT) is None


@pytest.mark.parametrize("name", [STANDARD, DELTA, COMPENSATED])
def test_kept_figures_are_measured_again(name: str, emulation: Emulation) -> None:
    rows = json.loads((C_OUT / name / FILE).read_text())["rows"]
    assert [row["target"] for row in rows] == EMULATED
    (kept,) = (row for row in rows if row["target"] == "cortex-m4f")
    found = measure(shipped(name), M4F, cross_compiler(), "-O2", emulation)
    if kept["compiler"] != found.compiler:
        pytest.skip(f"the figures are those of {kept['compiler']}, here is {found.compiler}")
    assert (kept["instructions_min"], kept["instructions_max"]) == found.executed.instructions
    assert (kept["cycles_low"], kept["cycles_high"]) == found.executed.cycles
    assert (kept["text_bytes"], kept["stack_bytes"]) == (found.text_bytes, found.stack_bytes)


@pytest.mark.parametrize("form", ["limbs", "limbs_shared", "library"])
def test_the_readme_tells_the_kept_figures_of_products(form: str) -> None:
    rows = json.loads((C_OUT / f"rotation_vector_3_coning_fixed32_{form}" / FILE).read_text())["rows"]
    figures = {row["level"]: row for row in rows if row["target"] == "cortex-m0"}
    cells = [f"{figures[level]['instructions_max']} / {figures[level]['text_bytes']}" for level in ("-O2", "-Os")]
    assert f"| `{form.replace('_', '-')}` | {' | '.join(cells)} |" in (C_OUT.parent / "README.md").read_text()
