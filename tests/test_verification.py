"""Verification refuses: another text before it is compiled, another bit, fused arithmetic, undefined behaviour."""

from __future__ import annotations

import platform
from collections.abc import Callable
from dataclasses import replace
from typing import NoReturn

import numpy as np
import pytest

from qcone import verify
from qcone.bundle import VerifiedBundle
from qcone.errors import CheckError
from qcone.targets.compiler import LEVELS, Compiler, compilers, is_zig
from qcone.targets.probe import has_fma
from qcone.vectors import GO_ON, INIT, SET, draw
from shipped import DESIGNS, shipped, tampered

NAME = "rotation_vector_3_coning_float32"
X86 = platform.machine().lower() in {"x86_64", "amd64"}
MissingTool = Callable[[str], NoReturn]


@pytest.fixture(scope="module")
def gcc(missing_tool: MissingTool) -> Compiler:
    found = [each for each in compilers() if each.family == "gcc"]
    return found[0] if found else missing_tool("gcc (apt install gcc)")


@pytest.fixture(scope="module")
def zig(missing_tool: MissingTool) -> Compiler:
    found = [each for each in compilers() if is_zig(each)]
    return found[0] if found else missing_tool("ziglang (pip install 'qcone[compiler]')")


@pytest.fixture
def only(monkeypatch: pytest.MonkeyPatch) -> Callable[[Compiler], None]:
    """Leave one compiler on this machine."""

    def leave(compiler: Compiler) -> None:
        monkeypatch.setattr(verify, "compilers", lambda: (compiler,))

    return leave


CHANGES = {
    "a literal": ("0.225F", "0.22500002F"),
    "an operator": ("coning_x_1 - coning_x_2", "coning_x_1 + coning_x_2"),
    "operand order": ("coning_x_1 - coning_x_2", "coning_x_2 - coning_x_1"),
}


@pytest.mark.parametrize("what", CHANGES)
def test_changed_text_is_refused_before_it_is_compiled(what: str, monkeypatch: pytest.MonkeyPatch) -> None:
    bundle = tampered(NAME, *CHANGES[what])
    for step in ("build_shared", "draw", "first_compiler", "compilers"):
        monkeypatch.setattr(verify, step, lambda *_, **__: pytest.fail("went on to compile"))
    with pytest.raises(CheckError, match=f"^{NAME}: the C text is not the routine: {NAME}_update: statement "):
        verify.accept(bundle)
    (outcome,) = verify.verify(bundle, 100)
    assert (outcome.status, outcome.compiler, outcome.failed) == ("refused", "none", True)
    assert outcome.first_difference is not None
    assert outcome.first_difference.startswith(f"{NAME}: the C text is not the routine: ")


@pytest.mark.parametrize("name", DESIGNS)
def test_every_shipped_design_is_accepted(name: str) -> None:
    accepted = verify.accept(shipped(name))
    assert isinstance(accepted, VerifiedBundle)
    assert (accepted.evidence.differing_bits, accepted.evidence.rows >= verify.ACCEPT_ROWS) == (0, True)


def test_all_levels_and_sanitizers_of_both_compilers(gcc: Compiler, zig: Compiler) -> None:
    outcomes = list(verify.verify(shipped(NAME), 2000))
    assert {each.status for each in outcomes} <= {"ok", "absent"}
    for compiler in (gcc, zig):
        label = f"{compiler.name} {compiler.version}"
        assert [each.level for each in outcomes if each.compiler == label] == list(LEVELS)
    assert {each.differing_bits for each in outcomes if each.status == "ok"} == {0}
    sanitized = [each for each in outcomes if each.sanitizer_reports is not None]
    assert {each.compiler.rpartition(" ")[2] for each in sanitized} == {"undefined+address", "undefined"}
    assert {each.sanitizer_reports for each in sanitized} == {0}


def test_a_different_bit_is_told_with_its_place_and_operands(
    monkeypatch: pytest.MonkeyPatch, only: Callable[[Compiler], None], gcc: Compiler
) -> None:
    """Were the text not read back, the vectors would still find one changed unit of the last place."""
    monkeypatch.setattr(verify, "read_back", lambda _: None)
    only(gcc)
    bundle = tampered(NAME, "0.225F", "0.22500002F")
    with pytest.raises(CheckError, match=f"^{NAME}: not written: differs: lane "):
        verify.accept(bundle)
    outcomes = list(verify.verify(bundle, 500))
    assert {each.status for each in outcomes} == {"differs"}
    for each in outcomes[: len(LEVELS)]:
        assert each.differing_bits is not None
        assert each.differing_bits > 0
        assert each.first_difference is not None
        assert each.first_difference.startswith("lane ")
        for word in (", step ", ": C ", ", model ", "; input ", "; state before "):
            assert word in each.first_difference


def fused_unit() -> list[str]:
    if not has_fma():
        pytest.skip("this processor has no fused multiply-add: contraction cannot be shown here")
    return ["-mfma"] if X86 else []


@pytest.mark.parametrize("name", [NAME, "rotation_vector_3_coning_float64"])
def test_contraction_by_gcc_is_reported(only: Callable[[Compiler], None], gcc: Compiler, name: str) -> None:
    only(gcc)
    outcomes = list(verify.verify(shipped(name), 500, cflags=[*fused_unit(), "-ffp-contract=fast"]))
    found = {each.level: each for each in outcomes if each.contracted is not None}
    for level in ("-O2", "-O3", "-Os"):
        assert (found[level].status, found[level].contracted, found[level].failed) == ("contracted", True, True)
        assert found[level].differing_bits, "fusing shows in the bits"
        assert found[level].first_difference is not None
        assert found[level].first_difference.startswith(
            "the build fuses products and sums: compile with -ffp-contract=off; lane "
        )


def test_contraction_by_clang_is_reported(only: Callable[[Compiler], None], zig: Compiler) -> None:
    """`fast` overrules the pragma in the file; `on` does not, and is told all the same."""
    fused_unit()
    only(zig)
    for mode, differs in (("fast", True), ("on", False)):
        outcomes = list(verify.verify(shipped(NAME), 500, cflags=[f"-ffp-contract={mode}"]))
        (each,) = (each for each in outcomes if each.level == "-O2")
        assert (each.status, each.contracted, each.failed) == ("contracted", True, True)
        assert bool(each.differing_bits) == differs


def test_fused_bits_under_a_sanitizer_are_told(only: Callable[[Compiler], None], zig: Compiler) -> None:
    fused_unit()
    only(zig)
    outcomes = list(verify.verify(shipped(NAME), 500, cflags=["-ffp-contract=fast"]))
    (sanitized,) = (each for each in outcomes if each.sanitizer_reports is not None)
    assert (sanitized.status, sanitized.sanitizer_reports, sanitized.failed) == ("differs", 0, True)
    assert (sanitized.first_difference or "").startswith("lane ")


def test_pairs_fused_by_gcc_s_vectoriser_are_reported(only: Callable[[Compiler], None], gcc: Compiler) -> None:
    """gcc fuses neighbouring lanes under -ffp-contract=off; our flags forbid it, and without them it is told."""
    only(gcc)
    unit = fused_unit()
    plain = list(verify.verify(shipped(NAME), 500, cflags=unit))
    assert {each.status for each in plain} == {"ok"}
    paired = list(verify.verify(shipped(NAME), 500, cflags=[*unit, "-ftree-slp-vectorize"]))
    if X86:
        assert "contracted" in {each.status for each in paired}


def test_undefined_behaviour_is_reported(
    monkeypatch: pytest.MonkeyPatch, only: Callable[[Compiler], None], gcc: Compiler
) -> None:
    monkeypatch.setattr(verify, "read_back", lambda _: None)
    only(gcc)
    bundle = shipped("rotation_vector_1_previous_2_float32")
    old = "state->count = state->count + 1;"
    source = bundle.source.replace(old, f"{old}\n    volatile int32_t most = 2147483647; most = most + 1;")
    assert source != bundle.source
    (sanitized,) = (each for each in verify.verify(replace(bundle, source=source), 200) if each.sanitizer_reports)
    assert (sanitized.status, sanitized.failed) == ("reports", True)
    assert "signed integer overflow" in (sanitized.first_difference or "")


def test_absent_compilers_are_listed_and_are_no_failure(
    monkeypatch: pytest.MonkeyPatch, only: Callable[[Compiler], None], gcc: Compiler
) -> None:
    only(gcc)
    monkeypatch.setattr(verify, "absent", lambda: ("clang",))
    *_, last = verify.verify(shipped(NAME), 100)
    assert (last.compiler, last.status, last.failed, last.differing_bits) == ("clang", "absent", False, None)


@pytest.mark.parametrize("name", [NAME, "rotation_vector_3_coning_rate_float32", "rotation_vector_1_float64"])
def test_vectors_hold_the_corners(name: str) -> None:
    """Inside the declared ball and on it, axis extremes, both zeros, smallest normals, subnormals, restarts."""
    bundle = shipped(name)
    vectors = draw(bundle, 20_000)
    info = np.finfo(vectors.inputs.dtype)
    known = bundle.facts.known
    radius = float(known.rate if bundle.driver.has_start else known.increment)
    samples = vectors.inputs.reshape(-1, 3).astype(np.float64)
    norms = np.linalg.norm(samples, axis=1)
    size = np.abs(vectors.inputs)
    assert norms.max() <= radius * (1 + 4 * info.eps)
    assert (norms > radius * (1 - 4 * info.eps)).mean() > 0.1
    assert ((norms > 0.1 * radius) & (norms < 0.9 * radius)).any()
    for axis in range(3):
        for sign in (1, -1):
            assert ((sign * samples[:, axis] > radius * (1 - 4 * info.eps)).sum()) > 10
    assert np.signbit(vectors.inputs[size == 0]).any()
    assert not np.signbit(vectors.inputs[size == 0]).all()
    assert (size == info.tiny).any()
    assert ((size > 0) & (size < info.tiny)).any()
    assert set(np.unique(vectors.restart)) == {GO_ON, INIT, SET}
    assert (vectors.restart == GO_ON).all(axis=1).sum() == 0, "every lane begins with a restart"
    assert (vectors.restart[:, 1:] == GO_ON).all(axis=1).any(), "a lane that runs on"
    assert (vectors.restart == SET).all(axis=1).any(), "a lane of single steps"


def test_vectors_are_the_same_for_the_same_seed() -> None:
    first, again, other = (draw(shipped(NAME), 1000, seed) for seed in (7, 7, 8))
    assert first.inputs.tobytes() == again.inputs.tobytes()
    assert first.inputs.tobytes() != other.inputs.tobytes()
    assert first.rows >= 1000


def test_what_the_header_says_of_a_series_of_its_own_holds() -> None:
    """Picard's orders state what they leave out; the bound holds against the closed form and is not far from it."""
    import numpy as np

    from qcone.algorithms.picard import left_out
    from qcone.ir.real import F
    from qcone.reference.attitude import picard

    size = F(1, 10)
    theta = np.array([[0.06, -0.08, 0.0]])
    for order in (1, 2, 3, 4):
        difference = picard(theta, order)[0] - picard(theta, "closed")[0]
        scalar, vector = (float(each) for each in left_out(order, size))
        assert 0.9 * scalar < abs(difference[0]) <= scalar * (1 + 1e-9)
        assert 0.9 * vector < float(np.linalg.norm(difference[1:])) <= vector * (1 + 1e-9)
