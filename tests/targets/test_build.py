from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext
from pathlib import Path

import pytest

from qcone.targets import build
from qcone.targets.build import CompileError, build_shared, compile_object, warnings
from qcone.targets.compiler import Compiler, first_compiler
from qcone.targets.host import Library

TWICE = {
    "twice.h": "int twice(int a);\n",
    "twice.c": '#include "twice.h"\nint twice(int a) { return 2 * a; }\n',
}
NARROWS = {"narrow.c": "int narrow(long a);\nint narrow(long a) { return a; }\n"}


def _twice(path: Path) -> int | None:
    return Library(path, "int twice(int a);").run("twice", 21)


def test_second_build_runs_no_compiler(each_compiler: Compiler, monkeypatch: pytest.MonkeyPatch) -> None:
    first = build_shared(each_compiler, TWICE, "-O1")
    monkeypatch.setattr(build, "_run", lambda *_: pytest.fail("the compiler ran again"))
    assert build_shared(each_compiler, dict(reversed(TWICE.items())), "-O1") == first
    assert _twice(first) == 42


def test_each_ingredient_gives_its_own_file(gcc: Compiler) -> None:
    newer = Compiler(gcc.name, gcc.command, gcc.family, "99.0", gcc.identity)
    commented = {**TWICE, "twice.h": TWICE["twice.h"] + "/* changed */\n"}
    paths = [
        build_shared(gcc, TWICE, "-O1"),
        build_shared(gcc, TWICE, "-O2"),
        build_shared(gcc, TWICE, "-O1", ["-DUNUSED"]),
        build_shared(gcc, commented, "-O1"),
        build_shared(newer, TWICE, "-O1"),
        compile_object(gcc, TWICE, "-O1"),
    ]
    assert len(set(paths)) == len(paths)


def test_files_in_folders_and_several_sources(each_compiler: Compiler) -> None:
    files = {
        "src/twice.h": TWICE["twice.h"],
        "src/twice.c": TWICE["twice.c"],
        "test/four.c": '#include "src/twice.h"\nint four(int a);\nint four(int a) { return twice(twice(a)); }\n',
    }
    library = Library(build_shared(each_compiler, files, "-O2"), "int four(int a);")
    assert library.run("four", 3) == 12


def test_parallel_builds_agree_and_leave_nothing_else(
    gcc: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build, "_folder", lambda: tmp_path)
    with ThreadPoolExecutor(4) as pool:
        paths = set(pool.map(lambda _: build_shared(gcc, TWICE, "-O2"), range(4)))
    (path,) = paths
    assert list(tmp_path.iterdir()) == [path]
    assert _twice(path) == 42


def test_compile_failure_shows_command_and_message_and_keeps_nothing(
    each_compiler: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build, "_folder", lambda: tmp_path)
    with pytest.raises(CompileError) as caught:
        build_shared(each_compiler, {"broken.c": "int broken(void) { return nothing; }\n"}, "-O2")
    message = str(caught.value)
    assert caught.value.exit_code == 3
    first, *said, last = message.splitlines()
    assert first.startswith(f"{each_compiler.name} {each_compiler.version} could not compile: ")
    assert "-ffp-contract=off" in first
    assert "broken.c" in first
    assert any("broken.c:1:" in line and "nothing" in line for line in said)
    assert last == "try another compiler with --cc; `qcone doctor` lists those found here"
    assert str(tmp_path) not in message
    assert list(tmp_path.iterdir()) == []


def test_long_compiler_message_is_cut_and_says_so(gcc: Compiler) -> None:
    text = "".join(f"int f{n}(void) {{ return nothing{n}; }}\n" for n in range(40))
    with pytest.raises(CompileError, match=r"\.\.\. \d+ more lines") as caught:
        build_shared(gcc, {"broken.c": text}, "-O0")
    assert len(str(caught.value).splitlines()) == 15
    assert "nothing39" in caught.value.said


def test_compiler_that_vanished_is_a_compile_error() -> None:
    gone = Compiler("gone", ("/nowhere/gone",), "gcc", "1.0")
    with pytest.raises(CompileError, match=r"gone 1\.0 could not compile.*\n.*No such file"):
        build_shared(gone, TWICE, "-O2")


@pytest.mark.parametrize("name", ["../outside.c", "/outside.c", "-o.c"])
def test_file_name_outside_the_build_folder_is_refused(gcc: Compiler, name: str) -> None:
    with pytest.raises(ValueError, match="does not name a file inside the build folder"):
        build_shared(gcc, {name: ""}, "-O2")


def test_ziglang_alone_builds_without_building_a_libc(
    zig: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(tmp_path / "zig"))
    monkeypatch.setattr(build, "_folder", lambda: tmp_path)
    found = first_compiler()
    assert found == zig
    assert _twice(build_shared(found, TWICE, "-O0")) == 42
    built = {path.name for path in (tmp_path / "zig").rglob("*.*") if path.is_file()}
    assert built
    assert not [name for name in built if name.startswith(("libc", "libcompiler_rt"))]


def test_object_for_another_machine(zig: Compiler) -> None:
    target = ("-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m4+vfp4d16sp", "-ffreestanding")
    header = compile_object(zig, TWICE, "-O2", target_flags=target).read_bytes()[:20]
    assert header[:5] == b"\x7fELF\x01"
    assert int.from_bytes(header[18:20], "little") == 40, "e_machine is Arm"


def test_object_takes_one_source(gcc: Compiler) -> None:
    with pytest.raises(ValueError, match=r"one \.c file makes one object"):
        compile_object(gcc, {"a.c": "", "b.c": ""}, "-O2")


def test_clean_text_has_no_warnings(each_compiler: Compiler) -> None:
    assert warnings(each_compiler, TWICE) == ""


def test_warnings_are_returned_every_time(
    each_compiler: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The same old files each time: zig knows them again, and repeats nothing that it only warned about.
    for name, text in {**TWICE, **NARROWS}.items():
        (tmp_path / name).write_text(text)
        os.utime(tmp_path / name, (1e9, 1e9))
    monkeypatch.setattr(build, "_write", lambda *_: None)
    monkeypatch.setattr(build.tempfile, "TemporaryDirectory", lambda **_: nullcontext(str(tmp_path)))
    for _ in range(2):
        assert "narrow.c:2:" in warnings(each_compiler, {**TWICE, **NARROWS})


def test_compiler_that_fails_in_silence_is_not_clean(gcc: Compiler, monkeypatch: pytest.MonkeyPatch) -> None:
    def silent(command: Sequence[str], _: Path) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, 1, "", "")

    monkeypatch.setattr(build, "_run", silent)
    assert warnings(gcc, NARROWS) == "narrow.c: gcc failed and said nothing\n"
