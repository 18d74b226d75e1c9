"""A compiler that is missing or fails: exit code 3 with the exact fix, nothing written. Contraction: exit code 1."""

from __future__ import annotations

import json
import platform
from pathlib import Path

import pytest
from given import everything

from qcone.targets.compiler import compilers
from qcone.targets.probe import has_fma

NONE = (
    "no C compiler found: $CC, cc, gcc and clang do not answer and the ziglang package is not installed; "
    "run: pip install 'qcone[compiler]' (or: apt install gcc)\n"
)
RECORDING = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad\n0.01,0,0,0.001\n0.02,0,0,0.001\n"
REPLAY = ("replay", "turn.csv", "--algorithm", "rotation-vector", "--number", "float64", "-o", "out.csv")
NEEDING = {
    "generate": ("generate", "good.toml"),
    "verify": ("verify", "good.toml", "--rows", "64"),
    "replay": REPLAY,
}


@pytest.fixture
def turn(tmp_path: Path) -> Path:
    file = tmp_path / "turn.csv"
    file.write_text(RECORDING)
    return file


@pytest.mark.usefixtures("no_compiler", "good", "turn")
@pytest.mark.parametrize("command", NEEDING)
def test_no_compiler(run, tmp_path: Path, command: str) -> None:
    before = everything(tmp_path)
    result = run(*NEEDING[command])
    assert (result.exit_code, result.stdout) == (3, "")
    assert result.stderr.removeprefix("note: declared rate taken from the data: --max-rate-dps 5.8\n") == NONE
    assert everything(tmp_path) == before


@pytest.mark.usefixtures("no_compiler")
def test_demo_without_a_compiler_says_so(run, tmp_path: Path) -> None:
    result = run("demo")
    assert (result.exit_code, result.stderr) == (3, NONE)
    assert everything(tmp_path) == {}


@pytest.mark.usefixtures("no_compiler")
def test_doctor_without_a_compiler_names_the_fixes(run) -> None:
    result = run("doctor", "--format", "json")
    assert result.exit_code == 3
    missing = {row["item"]: row["fix"] for row in json.loads(result.stdout)["rows"] if row["status"] == "missing"}
    assert missing == {
        "compiler family gcc": "apt install gcc",
        "compiler family clang": "pip install 'qcone[compiler]'",
    }


@pytest.mark.usefixtures("no_compiler", "good")
def test_what_needs_no_compiler_goes_on_without_one(run) -> None:
    for words in (("counts", "good.toml"), ("generate", "good.toml", "--dry-run"), ("list",), ("schema",)):
        assert run(*words).exit_code == 0, words


def test_a_machine_with_a_compiler_is_well(run) -> None:
    assert compilers()
    result = run("doctor", "--format", "json")
    assert result.exit_code == 0
    rows = json.loads(result.stdout)["rows"]
    assert {row["status"] for row in rows} <= {"ok", "absent"}
    assert all((row["fix"] is None) == (row["status"] == "ok") for row in rows)


@pytest.fixture
def failing(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A compiler that says it is gcc and compiles nothing."""
    script = tmp_path_factory.mktemp("bin") / "failcc"
    script.write_text(
        "#!/bin/sh\n"
        'case "$*" in\n'
        '*--version*) echo "gcc (nobody) 9.9.9"; echo "Copyright (C) Free Software Foundation, Inc.";;\n'
        "*-dumpmachine*) echo x86_64-linux-gnu;;\n"
        '*) echo "good.c:1:1: error: I am out of ink" >&2; exit 1;;\n'
        "esac\n"
    )
    script.chmod(0o755)
    return script


@pytest.mark.usefixtures("good", "turn")
@pytest.mark.parametrize("command", NEEDING)
def test_compile_failure(run, tmp_path: Path, failing: Path, command: str) -> None:
    before = everything(tmp_path)
    result = run(*NEEDING[command], "--cc", str(failing))
    assert (result.exit_code, result.stdout) == (3, "")
    lines = [line for line in result.stderr.splitlines() if not line.startswith("note: ")]
    assert lines[0].startswith(f"failcc 9.9.9 could not compile: {failing} ")
    assert "-ffp-contract=off" in lines[0]
    assert lines[1:] == [
        "  good.c:1:1: error: I am out of ink",
        "try another compiler with --cc; `qcone doctor` lists those found here",
    ]
    assert everything(tmp_path) == before


@pytest.mark.usefixtures("good")
def test_compiler_named_from_this_folder(run, tmp_path: Path, failing: Path) -> None:
    """The build runs elsewhere, the name still means this folder's."""
    (tmp_path / "cc-here").symlink_to(failing)
    result = run("generate", "good.toml", "--cc", "./cc-here")
    assert result.exit_code == 3
    assert "I am out of ink" in result.stderr


@pytest.mark.usefixtures("good")
def test_compiler_that_is_not_there(run, tmp_path: Path) -> None:
    result = run("generate", "good.toml", "--cc", "gcc-99")
    assert (result.exit_code, result.stdout) == (3, "")
    assert result.stderr == (
        "--cc gcc-99: there is no program 'gcc-99' on this machine; name an installed C compiler, or leave --cc out: "
        "run: pip install 'qcone[compiler]' (or: apt install gcc)\n"
    )
    assert sorted(everything(tmp_path)) == ["good.toml"]


@pytest.mark.usefixtures("good")
def test_flag_no_compiler_knows(run) -> None:
    result = run("verify", "good.toml", "--rows", "64", "--cflags=-fno-such-flag-at-all")
    assert (result.exit_code, result.stdout) == (3, "")
    assert "could not compile: " in result.stderr
    assert "-fno-such-flag-at-all" in result.stderr


@pytest.mark.usefixtures("good")
def test_contraction_is_a_failed_check(run, missing_tool) -> None:
    gcc = [found for found in compilers() if found.family == "gcc"]
    if not gcc:
        missing_tool("gcc (apt install gcc)")
    if not has_fma():
        pytest.skip("this processor has no fused multiply-add: contraction cannot be shown here")
    unit = "-mfma " if platform.machine().lower() in {"x86_64", "amd64"} else ""
    words = ("verify", "good.toml", "--rows", "500", "--cc", gcc[0].command[0], "--format", "json")
    assert run(*words, f"--cflags={unit}".strip()).exit_code == 0
    result = run(*words, f"--cflags={unit}-ffp-contract=fast")
    assert result.exit_code == 1
    rows = {row["level"]: row for row in json.loads(result.stdout)["rows"] if row["contracted"] is not None}
    for level in ("-O2", "-O3", "-Os"):
        assert (rows[level]["status"], rows[level]["contracted"]) == ("contracted", True)
        assert rows[level]["differing_bits"] > 0
        assert rows[level]["first_difference"].startswith("the build fuses products and sums: ")


@pytest.mark.usefixtures("good", "flipped_bit")
def test_a_bit_that_differs_is_a_failed_check(run) -> None:
    result = run("verify", "good.toml", "--rows", "64", "--format", "json")
    assert result.exit_code == 1
    rows = [row for row in json.loads(result.stdout)["rows"] if row["contracted"] is not None]
    for row in rows:
        assert row["status"] == "differs"
        assert row["differing_bits"] > 0
        assert row["first_difference"].startswith("lane 0, step 1, dcm 33: C ")


@pytest.mark.usefixtures("good")
def test_absent_compilers_are_listed_as_absent(run, monkeypatch, missing_tool) -> None:
    from qcone import verify

    gcc = [found for found in compilers() if found.family == "gcc"] or missing_tool("gcc (apt install gcc)")
    monkeypatch.setattr(verify, "compilers", lambda: (gcc[0],))
    monkeypatch.setattr(verify, "absent", lambda: ("clang",))
    result = run("verify", "good.toml", "--rows", "64", "--format", "json")
    assert result.exit_code == 0
    last = json.loads(result.stdout)["rows"][-1]
    assert (last["compiler"], last["status"], last["rows"]) == ("clang", "absent", None)
