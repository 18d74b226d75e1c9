from __future__ import annotations

import platform
import re
from collections.abc import Sequence

import pytest

from qcone.targets.build import build_shared, compile_object, warnings
from qcone.targets.compiler import LEVELS, Compiler, is_zig
from qcone.targets.host import Library
from qcone.targets.probe import CONTRACTED, SLP_CONTRACTED, contraction_probe, has_fma

X86 = platform.machine().lower() in {"x86_64", "amd64"}


def _probe(compiler: Compiler, level: str, extra: Sequence[str] = (), without: tuple[str, str] = ("", "")) -> int:
    """Run the probe; `without` replaces one of its lines, which must be there."""
    text = contraction_probe("here_contracts")
    assert without[0] in text
    files = {"probe.c": text.replace(*without)}
    library = Library(build_shared(compiler, files, level, extra), "int here_contracts(void);")
    found = library.run("here_contracts")
    assert found is not None
    return found


def _fused_unit(compiler: Compiler) -> list[str]:
    """Return the flags that let `compiler` use the fused unit of an x86 processor; others have one always."""
    if not has_fma():
        pytest.skip("this processor has no fused multiply-add: contraction cannot be shown here")
    return [] if is_zig(compiler) or not X86 else ["-mfma"]


def test_fused_unit_is_found_as_numpy_finds_it() -> None:
    numpy_core = pytest.importorskip("numpy._core._multiarray_umath")
    found = numpy_core.__cpu_features__
    known = [found[name] for name in ("FMA3", "X86_V3", "NEON_FMA", "ASIMD") if name in found]
    assert has_fma() == any(known)


def test_probe_has_no_warnings(each_compiler: Compiler) -> None:
    strict = ("-Wstrict-prototypes", "-Wmissing-prototypes")
    assert warnings(each_compiler, {"probe.c": contraction_probe("att_contracts")}, extra=strict) == ""


def test_two_probes_live_in_one_build(gcc: Compiler) -> None:
    files = {f"{name}.c": contraction_probe(name) for name in ("one", "two")}
    library = Library(build_shared(gcc, files, "-O2"), "int one(void); int two(void);")
    assert (library.run("one"), library.run("two")) == (0, 0)


@pytest.mark.parametrize("level", LEVELS)
def test_default_flags_do_not_contract(each_compiler: Compiler, level: str) -> None:
    assert _probe(each_compiler, level) == 0
    assert _probe(each_compiler, level, _fused_unit(each_compiler)) == 0


@pytest.mark.parametrize("level", ["-O2", "-O3", "-Os"])
def test_contraction_is_found_when_it_is_on(each_compiler: Compiler, level: str) -> None:
    on = [*_fused_unit(each_compiler), "-ffp-contract=fast"]
    assert _probe(each_compiler, level, on) & CONTRACTED


def test_contraction_within_one_expression_is_found(zig: Compiler) -> None:
    assert _probe(zig, "-O2", [*_fused_unit(zig), "-ffp-contract=on"]) == CONTRACTED


LANES = """\
void lanes(const double *restrict a, const double *restrict c, double *restrict o);
void lanes(const double *restrict a, const double *restrict c, double *restrict o)
{
    const double m0 = a[0] * a[0];
    const double m1 = a[1] * a[1];
    o[0] = m0 - c[0];
    o[1] = m1 + c[1];
}
"""


def test_gcc_slp_pairs_need_their_own_flag(gcc: Compiler) -> None:
    unit = _fused_unit(gcc)
    paired = [*unit, "-ftree-slp-vectorize"]
    assembly = compile_object(gcc, {"lanes.c": LANES}, "-O2", ["-S", *paired]).read_text()
    if re.search(r"v?fn?m[as]", assembly.partition("lanes:")[2]) is None:
        pytest.skip(f"gcc {gcc.version} on {platform.machine()} fuses no lanes: nothing to guard against")
    assert _probe(gcc, "-O2", paired) == SLP_CONTRACTED
    for alone in (
        ("probe_float_call(as, cs, o);", "o[0] = o[1] = o[2] = o[3] = 0.0F;"),
        ("probe_double_call(xs, zs, w);", "w[0] = w[1] = 0.0;"),
    ):
        assert _probe(gcc, "-O2", paired, without=alone) == SLP_CONTRACTED, f"without {alone[0]}"
    assert _probe(gcc, "-O2", unit) == 0
