"""The emitted C suits every compiler: no warnings, C99, C++17 for the header, nothing from a library."""

from __future__ import annotations

import platform
import shutil
import subprocess
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NoReturn

import pytest

from elf import read_symbols
from qcone.targets.build import compile_object, warnings
from qcone.targets.compiler import Compiler, first_compiler
from shipped import DESIGNS, shipped

STRICT = ("-Wfloat-equal", "-Wstrict-prototypes", "-Wmissing-prototypes", "-Wold-style-definition", "-Wvla")
"""Beyond the flags the emitted header promises."""

CORTEX_M4F = ("-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m4+vfp4d16sp", "-fno-unwind-tables")
X86 = platform.machine().lower() in {"x86_64", "amd64"}
SINGLES = [name for name in DESIGNS if DESIGNS[name].number.format == "float32"]
DOUBLES = [name for name in DESIGNS if DESIGNS[name].number.format == "float64"]
ONE_EACH = ("rotation_vector_3_coning_float32", "rotation_vector_3_coning_float64")
MissingTool = Callable[[str], NoReturn]


@pytest.fixture(scope="module", params=["gcc", "zig"])
def compiler(request: pytest.FixtureRequest) -> Compiler:
    found: Compiler = request.getfixturevalue(request.param)
    return found


def files_of(name: str) -> dict[str, str]:
    """Return everything emitted for a design, and the program that runs its batch loop on a file."""
    bundle = shipped(name)
    return {**bundle.sources, f"{name}_main.c": bundle.main}


def firmware_of(name: str) -> dict[str, str]:
    """Return the two files that go into a firmware."""
    bundle = shipped(name)
    return {f"{name}.h": bundle.header, f"{name}.c": bundle.source}


def compiled(command: Sequence[str], files: Mapping[str, str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Write the files and run a compiler among them."""
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("name", DESIGNS)
def test_no_warnings(compiler: Compiler, name: str) -> None:
    assert warnings(compiler, files_of(name), extra=STRICT) == ""


WARNED = {
    "float-conversion": "float f(double a);\nfloat f(double a) { return a; }\n",
    "double-promotion": "double f(float a);\ndouble f(float a) { return a * 2.0; }\n",
    "float-equal": "int f(float a);\nint f(float a) { return a == 0.1F; }\n",
    "missing-prototypes": "int f(int a) { return a; }\n",
    "strict-prototypes": "int f();\n",
    "undef": "#if NOT_DEFINED\n#endif\nint f(int a);\n",
    "shadow": "int f(int a);\nint f(int a) { { int a = 1; (void)a; } return a; }\n",
}


@pytest.mark.parametrize("flag", WARNED)
def test_flags_are_in_force(compiler: Compiler, flag: str) -> None:
    assert f"-W{flag}" in warnings(compiler, {"warned.c": WARNED[flag]}, extra=STRICT).replace(
        "-Werror=", "-W"
    ).replace("-Wimplicit-float-conversion", "-Wfloat-conversion")


@pytest.fixture(scope="module")
def tcc(missing_tool: MissingTool) -> str:
    return shutil.which("tcc") or missing_tool("tcc (apt install tcc)")


@pytest.mark.parametrize("name", DESIGNS)
def test_tcc_takes_it_as_c99(tcc: str, name: str, tmp_path: Path) -> None:
    files = files_of(name)
    sources = [each for each in files if each.endswith(".c")]
    done = compiled([tcc, "-std=c99", "-Wall", "-Werror", *sources, "-o", "program"], files, tmp_path)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    assert (tmp_path / "program").exists()


@pytest.mark.parametrize("name", ONE_EACH)
def test_tcc_of_the_x87_is_refused(missing_tool: MissingTool, name: str, tmp_path: Path) -> None:
    x87 = shutil.which("i386-tcc") or missing_tool("i386-tcc (apt install tcc)")
    done = compiled([x87, "-std=c99", "-E", f"{name}.c"], firmware_of(name), tmp_path)
    assert done.returncode != 0
    assert f"{name}: needs FLT_EVAL_METHOD 0" in done.stderr


CALLER = """\
#include "{name}.h"

int main()
{{
    {name}_state state = {upper}_STATE_INIT;
    {given} input[3 * {upper}_SUBSAMPLES] = {{}};
    {ctype} q[4];
    {name}_init(&state);
    {start}{name}_update(&state, input);
    {name}_quaternion(&state, q);
    return q[0] < {upper}_INTERVAL_S ? 1 : 0;
}}
"""


@pytest.fixture(scope="module", params=["g++", "zig c++"])
def cxx(request: pytest.FixtureRequest, missing_tool: MissingTool) -> tuple[str, ...]:
    if request.param == "g++":
        return (shutil.which("g++") or missing_tool("g++ (apt install g++)"),)
    zig: Compiler = request.getfixturevalue("zig")
    return (*zig.command[:-1], "c++")


@pytest.mark.parametrize("name", DESIGNS)
def test_header_serves_cpp17(cxx: Sequence[str], name: str, tmp_path: Path) -> None:
    bundle = shipped(name)
    start = f"{name}_start(&state, input);\n    " if bundle.driver.has_start else ""
    driver = bundle.driver
    text = CALLER.format(name=name, upper=name.upper(), ctype=driver.ctype, given=driver.input_ctype, start=start)
    files = {f"{name}.h": bundle.header, "caller.cpp": text}
    flags = ("-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror", "-O1")
    done = compiled([*cxx, *flags, "-c", "caller.cpp", "-o", "caller.o"], files, tmp_path)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    needed = read_symbols((tmp_path / "caller.o").read_bytes()).undefined
    assert {f"{name}_init", f"{name}_update", f"{name}_quaternion"} <= needed, "names are C's, not mangled"


def cortex_m4f(zig: Compiler, files: Mapping[str, str], level: str = "-O2") -> Path:
    return compile_object(zig, files, level, target_flags=CORTEX_M4F)


@pytest.mark.parametrize("name", SINGLES)
@pytest.mark.parametrize("level", ["-O0", "-O2", "-Os"])
def test_float32_needs_nothing_on_cortex_m4f(zig: Compiler, name: str, level: str) -> None:
    symbols = read_symbols(cortex_m4f(zig, firmware_of(name), level).read_bytes())
    assert symbols.undefined == frozenset()
    assert symbols.exported == public_names(name)


def public_names(name: str) -> frozenset[str]:
    """Return the functions the contract names for a design."""
    bundle = shipped(name)
    design, state = bundle.facts.design, bundle.facts.algorithm.state
    words = {"init", f"set_{state}", "update", "quaternion", *design.outputs}
    words |= {"start"} if design.input == "rate" else set()
    words |= {"renormalise"} if design.renormalise == "separate" else set()
    words |= {"ready", "error_estimate"} if design.algorithm == "adams-moulton-4" else set()
    if design.rins:
        words |= {"set_correction", "correct", "body_quaternion"} | {f"body_{each}" for each in design.outputs}
    return frozenset(f"{name}_{word}" for word in words)


ARM_DOUBLE = frozenset(f"__aeabi_{word}" for word in ("dadd", "dsub", "dmul", "ddiv", "drsub", "dcmplt", "dcmpgt"))


@pytest.mark.parametrize("name", DOUBLES)
def test_float64_needs_only_soft_arithmetic_on_cortex_m4f(zig: Compiler, name: str) -> None:
    symbols = read_symbols(cortex_m4f(zig, firmware_of(name)).read_bytes())
    assert symbols.undefined <= ARM_DOUBLE
    assert symbols.exported == public_names(name)


def test_reader_sees_libm_and_soft_double(zig: Compiler) -> None:
    text = "double sqrt(double a);\nfloat f(float a);\nfloat f(float a) { return (float)sqrt(a * 0.1 + a); }\n"
    symbols = read_symbols(cortex_m4f(zig, {"soft.c": text}).read_bytes())
    assert {"sqrt", "__aeabi_dmul", "__aeabi_dadd", "__aeabi_f2d", "__aeabi_d2f"} <= symbols.undefined
    assert symbols.exported == {"f"}


@pytest.mark.parametrize("name", DESIGNS)
def test_nothing_is_needed_on_this_machine(compiler: Compiler, name: str) -> None:
    if platform.system() != "Linux":
        pytest.skip("objects here are not ELF: the cross-compiled ones are read instead")
    symbols = read_symbols(compile_object(compiler, firmware_of(name), "-O2").read_bytes())
    assert symbols.undefined == frozenset()
    assert symbols.exported == public_names(name)


def refusal(compiler: Compiler, name: str, *extra: str) -> str:
    """Return what a compiler says of a design it must refuse."""
    return warnings(compiler, firmware_of(name), extra=extra)


@pytest.mark.parametrize("name", ONE_EACH)
def test_fast_math_is_refused(compiler: Compiler, name: str) -> None:
    said = refusal(compiler, name, "-ffast-math")
    assert f"{name}: compile without -ffast-math: the order of operations is part of the result" in said


@pytest.mark.parametrize("name", ONE_EACH)
@pytest.mark.parametrize("unit", [("-mfpmath=387",), ("-m32", "-mfpmath=387")], ids=" ".join)
def test_excess_precision_is_refused(gcc: Compiler, name: str, unit: Sequence[str]) -> None:
    if not X86:
        pytest.skip("this processor has no x87")
    said = refusal(gcc, name, *unit)
    assert f"{name}: needs FLT_EVAL_METHOD 0: every operation rounded to its own type" in said


@pytest.mark.parametrize("name", ONE_EACH)
def test_another_number_format_is_refused(gcc: Compiler, name: str) -> None:
    said = refusal(
        gcc, name, "-U__FLT_MANT_DIG__", "-D__FLT_MANT_DIG__=8", "-U__DBL_MANT_DIG__", "-D__DBL_MANT_DIG__=8"
    )
    assert f"{name}: needs the binary formats of IEEE 754" in said


@pytest.mark.parametrize("name", ONE_EACH)
def test_files_of_two_versions_are_refused(name: str) -> None:
    files = files_of(name)
    macro = f"#define {name.upper()}_VERSION "
    assert f"{macro}1\n" in files[f"{name}.h"]
    files[f"{name}.h"] = files[f"{name}.h"].replace(f"{macro}1\n", f"{macro}2\n")
    said = warnings(first_compiler(), files).splitlines()
    for file in (f"{name}.c", f"{name}_run.c"):
        told = [line for line in said if line.startswith(f"{file}:") and "error" in line]
        assert any(f"{name}.h is of another version than this file: generate both again" in line for line in told)
