"""The emitted C on emulated targets: the same bits after every update of a chain, and each gate red when it must be."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from qcone import pipeline
from qcone.bundle import Bundle
from qcone.on_avr import verify_on_avr
from qcone.on_board import verify_on_board
from qcone.on_target import verify_on
from qcone.stepwise import model_steps, packed, state_type, unpacked
from qcone.targets import avr, qemu
from qcone.targets import emulation as emulations
from qcone.targets.cross import cross_compiler
from qcone.targets.emulation import Emulation, NotMeasuredError
from qcone.targets.machines import TARGETS, Target
from qcone.vectors import GO_ON, INIT, SUBNORMAL_ROWS, Vectors, draw_chain
from qcone.verify import Outcome, model_words
from shipped import DESIGNS, shipped, tampered

NAME = "rotation_vector_3_coning_float32"
EMULATED = [name for name, each in TARGETS.items() if each.emulated]
BOARDS = ("cortex-m0", "cortex-m3", "cortex-m4f")


@pytest.fixture(scope="module")
def emulation() -> Iterator[Emulation]:
    with Emulation() as one:
        yield one


def outcome(
    bundle: Bundle, target: Target | str, emulation: Emulation, rows: int = 300, *cflags: str, flush: bool = False
) -> Outcome:
    chosen = TARGETS[target] if isinstance(target, str) else target
    return verify_on(bundle, chosen, cross_compiler(), draw_chain(bundle, rows), emulation, cflags, flush)


@pytest.mark.parametrize("target", EMULATED)
def test_ten_thousand_chained_updates_have_the_models_bits(target: str, emulation: Emulation) -> None:
    found = outcome(shipped(NAME), target, emulation, 10_000)
    assert (found.status, found.differing_bits, found.contracted, found.first_difference) == ("ok", 0, False, None)
    assert (found.target, found.level, found.rows) == (target, "-O2", 11_000)


@pytest.mark.parametrize(
    "name",
    [
        "rotation_vector_3_coning_float64_compensated",
        "rotation_vector_1_previous_5_float64",
        "rotation_vector_3_coning_rate_float32",
        "dcm_taylor_3_10_rolled_float32",
        "euler_angles_float64",
        "adams_moulton_4_heun_float32",
    ],
)
@pytest.mark.parametrize("target", ["cortex-m3", "cortex-m7f", "powerpc"])
def test_histories_starters_loops_and_other_states(name: str, target: str, emulation: Emulation) -> None:
    """A counter beside the attitude, a start from a rate, tables, matrices: laid out as the target lays them out."""
    found = outcome(shipped(name), target, emulation)
    assert (found.status, found.differing_bits, found.first_difference) == ("ok", 0, None)


def test_chain_runs_on_and_ends_in_subnormal_increments_from_the_identity() -> None:
    vectors = draw_chain(shipped(NAME), 1000)
    assert vectors.restart.shape == (1, 1100)
    assert (vectors.restart[0, 1:1000] == GO_ON).all()
    assert (vectors.restart[0, -SUBNORMAL_ROWS:] == INIT).all()
    assert (np.abs(vectors.inputs[0, -SUBNORMAL_ROWS:]) == 2.0**-130).all()


@pytest.mark.parametrize("name", [NAME, "rotation_vector_1_previous_2_float32", "adams_moulton_4_heun_float64"])
def test_steps_from_the_codes_own_states_are_the_chain(name: str) -> None:
    """From the model's own words the steps give them back; from others they stop doing so at the other one."""
    bundle = shipped(name)
    vectors = draw_chain(bundle, 200)
    words = model_words(bundle, vectors)
    steps = model_steps(bundle, vectors, words)
    assert steps.tobytes() == words.tobytes()
    changed = words.copy()
    changed[0, 50, 0] = np.nextafter(changed[0, 50, 0], words.dtype.type(2))
    different = (model_steps(bundle, vectors, changed) != changed).any(axis=2)[0]
    assert different.argmax() == 50


def test_state_is_laid_out_as_the_c_structure() -> None:
    """An attitude in double beside a 32-bit counter: the structure's size is a multiple of 8."""
    bundle = shipped("rotation_vector_1_previous_5_float64")
    layout = state_type(bundle)
    assert layout.itemsize % 8 == 0
    assert {name: layout.fields[name][1] for name in ("q",)} == {"q": 0} if layout.fields else False
    values = {name: np.arange(1, size[0].shape[0] + 1)[:, None] for name, size in (layout.fields or {}).items()}
    for big in (False, True):
        words = unpacked(bundle, packed(bundle, values, big), big)
        assert words[0].tolist() == [each for array in values.values() for each in array[:, 0].tolist()]


def test_fpu_that_is_not_named_is_caught(emulation: Emulation) -> None:
    """The ABI is hard float, the code calls soft routines all the same, and every bit would be right."""
    broken = replace(TARGETS["cortex-m4f"], zig=("-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m4"))
    found = outcome(shipped(NAME), broken, emulation)
    assert (found.status, found.failed) == ("soft-float", True)
    assert found.first_difference is not None
    assert found.first_difference.startswith("__aeabi_fadd is called, though cortex-m4f has an FPU for it; ")


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("cortex-m0", "__aeabi_d2f is called, and nothing in float32 code needs it"),
        ("cortex-m4f", "__aeabi_d2f is called, and nothing in float32 code needs it"),
        ("rv32imfc", "__extendsfdf2 is called, and nothing in float32 code needs it"),
        ("cortex-m7f", "vmul.f64 at rotation_vector_3_coning_float32_update+0x"),
    ],
)
def test_soft_double_is_caught(target: str, said: str, emulation: Emulation) -> None:
    bundle = tampered(NAME, "0.225F /* 9/40 */ * d_x", "(float)(0.225 * d_x)")
    found = outcome(bundle, target, emulation)
    assert (found.status, found.failed) == ("stray-double", True)
    assert found.first_difference is not None
    assert found.first_difference.startswith(said)


@pytest.mark.parametrize(("target", "word"), [("cortex-m7f", "vfm"), ("rv32imfc", "fmadd.s"), ("powerpc", "fm")])
def test_fused_product_is_caught(target: str, word: str, emulation: Emulation) -> None:
    found = outcome(shipped(NAME), target, emulation, 300, "-ffp-contract=fast")
    assert (found.status, found.failed) == ("contracted", True)
    assert found.first_difference is not None
    assert found.first_difference.startswith(word)
    assert found.first_difference.endswith("fuses a product with a sum: compile with -ffp-contract=off")


@pytest.mark.parametrize("target", ["cortex-m0", "cortex-m4f", "rv32imc"])
def test_unaligned_access_is_caught(target: str, emulation: Emulation) -> None:
    read = "const float dtheta1_x = *(const float *)(const void *)((const char *)dtheta + 2);"
    found = outcome(tampered(NAME, "const float dtheta1_x = dtheta[0];", read), target, emulation)
    assert (found.status, found.failed) == ("faults", True)
    assert found.first_difference is not None
    assert found.first_difference.startswith("unaligned: ")
    assert f", by {NAME}_update+0x" in found.first_difference


STORE = "    state->q[3] = q_next_z;\n}\n\nvoid rotation_vector_3_coning_float32_quaternion"
BEYOND = {
    "the state": ("state->q[4] = q_next_z;", "out of bounds: write of 4 bytes at byte 16 of the state, which has 16"),
    "the input": ("((float *)dtheta)[0] = 0.0F;", "out of bounds: write of 4 bytes at byte 0 of dtheta"),
}


@pytest.mark.parametrize("where", BEYOND)
@pytest.mark.parametrize("target", ["cortex-m0", "cortex-m4f", "powerpc"])
def test_write_out_of_bounds_is_caught(where: str, target: str, emulation: Emulation) -> None:
    statement, said = BEYOND[where]
    bundle = tampered(NAME, STORE, STORE.replace("}\n", f"    {statement}\n}}\n", 1))
    found = outcome(bundle, target, emulation)
    assert (found.status, found.failed) == ("faults", True)
    assert found.first_difference is not None
    assert found.first_difference.startswith(said)


@pytest.mark.parametrize("target", ["cortex-m4f", "cortex-m7f", "cortex-m33f"])
def test_flush_to_zero_is_caught(target: str, emulation: Emulation) -> None:
    """Increments of 2^-130 leave no trace in the attitude; the probe says why."""
    found = outcome(shipped(NAME), target, emulation, flush=True)
    assert (found.status, found.failed) == ("flushed", True)
    assert found.differing_bits
    assert found.first_difference is not None
    assert found.first_difference.startswith("flush-to-zero is on: ")
    assert "; lane 0, step 3" in found.first_difference


def test_flushed_bits_hold_where_the_header_says_they_do(emulation: Emulation) -> None:
    """Components that are 0 or at least 2^-48 in size: no bit differs, and the mode is told all the same."""
    bundle = shipped(NAME)
    whole = draw_chain(bundle, 2000).first(2000)
    inputs = np.where(np.abs(whole.inputs) < 2.0**-48, np.float32(0), whole.inputs)
    assert (inputs != whole.inputs).any()
    vectors = Vectors(whole.restart, whole.attitude, whole.before, inputs)
    found = verify_on(bundle, TARGETS["cortex-m4f"], cross_compiler(), vectors, emulation, flush=True)
    assert (found.status, found.differing_bits) == ("flushed", 0)


def test_one_unit_of_the_last_place_is_caught(emulation: Emulation) -> None:
    found = outcome(tampered(NAME, "0.225F", "0.22500002F"), "cortex-m0", emulation)
    assert (found.status, found.failed) == ("differs", True)
    assert found.differing_bits
    assert (found.first_difference or "").startswith("lane 0, step ")


def dividing(monkeypatch: pytest.MonkeyPatch) -> Bundle:
    """Return a design whose Euler angles divide whatever comes of it, subnormal quotients included."""
    chosen = pipeline.choose_functions
    monkeypatch.setattr(pipeline, "choose_functions", lambda number: replace(chosen(number), negligible=Fraction(0)))
    return pipeline.build(DESIGNS["rotation_vector_3_coning_euler_zyx_float32"])


@pytest.mark.parametrize(("target", "wrong"), [("cortex-m3", True), ("cortex-m4f", False), ("powerpc", False)])
def test_wrong_quotient_of_a_runtime_library_is_told(
    target: str, wrong: bool, monkeypatch: pytest.MonkeyPatch, emulation: Emulation
) -> None:
    """ziglang's soft division rounds subnormal quotients wrongly; a divider in hardware does not."""
    found = outcome(dividing(monkeypatch), target, emulation, 10_000)
    assert (found.status == "differs") == bool(found.differing_bits) == wrong
    said = "the compiler's own division rounds subnormal quotients wrongly: 0x1."
    assert (found.first_difference or "").startswith(said) == wrong


@pytest.mark.parametrize(
    ("name", "target"),
    [
        ("rotation_vector_3_coning_euler_zyx_float32", "cortex-m3"),
        ("rotation_vector_3_coning_euler_zyx_float64", "cortex-m4f"),
        ("dcm_taylor_3_10_euler_float64", "rv32imc"),
    ],
)
def test_shipped_designs_make_no_subnormal_quotient(name: str, target: str, emulation: Emulation) -> None:
    found = outcome(shipped(name), target, emulation, 10_000)
    assert (found.status, found.differing_bits) == ("ok", 0)


def test_library_that_divides_right_is_not_blamed(
    missing_tool, monkeypatch: pytest.MonkeyPatch, emulation: Emulation
) -> None:
    if not gcc_for_arm():
        missing_tool("arm-none-eabi-gcc (apt install gcc-arm-none-eabi)")
    bundle, target = dividing(monkeypatch), TARGETS["cortex-m3"]
    gcc = cross_compiler("arm-none-eabi-gcc")
    found = verify_on(bundle, target, gcc, draw_chain(bundle, 10_000), emulation)
    assert (found.status, found.differing_bits) == ("ok", 0)
    changed = replace(bundle, source=bundle.source.replace("0.225F", "0.22500002F", 1))
    found = verify_on(changed, target, gcc, draw_chain(bundle, 300), emulation)
    assert (found.status, (found.first_difference or "").partition(" ")[0]) == ("differs", "lane")


def test_emulator_that_crashes_has_measured_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def crash(*_: object) -> None:
        raise NotMeasuredError("not measured: the emulator was ended by signal SIGSEGV")

    monkeypatch.setattr(Emulation, "run", crash)
    with Emulation() as one:
        found = outcome(shipped(NAME), "cortex-m0", one)
    assert (found.status, found.failed, found.differing_bits) == ("not-measured", False, None)
    assert found.first_difference == "not measured: the emulator was ended by signal SIGSEGV"


def test_more_rows_than_memory_are_not_measured(monkeypatch: pytest.MonkeyPatch, emulation: Emulation) -> None:
    monkeypatch.setattr(emulations, "ROOM", 1 << 20)
    found = outcome(shipped(NAME), "powerpc", emulation, 30_000)
    assert (found.status, found.failed, found.differing_bits) == ("not-measured", False, None)
    said = "not measured: 5 MB of buffers, an emulated memory has 1: take fewer rows"  # one that is begun counts
    assert found.first_difference == said
    assert outcome(shipped(NAME), "powerpc", emulation, 300).status == "ok"


@pytest.mark.parametrize("cc", [None, "arm-none-eabi-gcc"], ids=["zig", "gcc"])
@pytest.mark.parametrize("target", BOARDS)
def test_qemu_reaches_the_same_words(target: str, cc: str | None, missing_tool) -> None:
    if qemu.version() is None:
        missing_tool(f"qemu-system-arm ({qemu.FIX})")
    if cc and not gcc_for_arm():
        missing_tool("arm-none-eabi-gcc (apt install gcc-arm-none-eabi)")
    bundle = shipped(NAME)
    found = verify_on_board(bundle, TARGETS[target], cross_compiler(cc), draw_chain(bundle, 2000))
    assert (found.status, found.differing_bits, found.contracted, found.rows) == ("ok", 0, False, 2200)
    assert f" on qemu {qemu.version()}" in found.compiler


def test_qemu_would_see_another_bit(missing_tool) -> None:
    if qemu.version() is None:
        missing_tool(f"qemu-system-arm ({qemu.FIX})")
    bundle = tampered(NAME, "0.225F", "0.22500002F")
    found = verify_on_board(bundle, TARGETS["cortex-m4f"], cross_compiler(), draw_chain(bundle, 300))
    assert (found.status, found.failed) == ("differs", True)


def test_qemu_that_is_absent_or_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    bundle, target = shipped(NAME), TARGETS["cortex-m4f"]
    vectors = draw_chain(bundle, 10)
    monkeypatch.setattr(qemu, "version", lambda: None)
    found = verify_on_board(bundle, target, cross_compiler(), vectors)
    assert (found.status, found.failed, found.compiler) == ("absent", False, "qemu-system-arm")
    monkeypatch.setattr(qemu, "version", lambda: "1.2.3")
    monkeypatch.setattr(qemu, "PROGRAM", "false")
    found = verify_on_board(bundle, target, cross_compiler(), vectors)
    assert (found.status, found.first_difference) == (
        "not-measured",
        "not measured: false ended with exit code 1: it said nothing",
    )
    monkeypatch.setattr(qemu, "run", lambda *_: b"few")
    found = verify_on_board(bundle, target, cross_compiler(), vectors)
    assert found.status == "not-measured"
    assert (found.first_difference or "").startswith("not measured: 3 bytes written, not ")


def test_avr_runs_the_same_words(missing_tool) -> None:
    if not avr.present():
        missing_tool(f"simavr and avr-gcc ({avr.FIX})")
    compiled, ran = verify_on_avr(shipped(NAME), cross_compiler())
    assert (compiled.status, compiled.differing_bits, compiled.failed) == ("compiles", None, False)
    assert (ran.status, ran.differing_bits, ran.target) == ("ok", 0, "avr")
    assert ran.rows
    assert ran.rows > 100
    _, other = verify_on_avr(tampered(NAME, "0.225F", "0.22500002F"), cross_compiler())
    assert (other.status, other.failed) == ("differs", True)


def test_avr_without_its_tools_is_a_compile_check(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(avr, "present", lambda: False)
    compiled, absent = verify_on_avr(shipped(NAME), cross_compiler())
    assert (compiled.status, absent.status, absent.first_difference) == ("compiles", "absent", avr.FIX)
    (refused,) = verify_on_avr(shipped("rotation_vector_3_coning_float64"), cross_compiler())
    assert (refused.status, refused.failed) == ("refused", True)
    assert "needs the binary formats of IEEE 754" in (refused.first_difference or "")


def gcc_for_arm() -> bool:
    import shutil

    return shutil.which("arm-none-eabi-gcc") is not None
