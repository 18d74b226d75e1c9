from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from qcone.errors import MissingToolError
from qcone.targets import compiler
from qcone.targets.compiler import Compiler, absent, compilers, first_compiler, flags

GNU = "(Debian 12.2.0-14) 12.2.0\nCopyright (C) 2022 Free Software Foundation, Inc."
CLANG = "clang version 14.0.6\nTarget: x86_64-pc-linux-gnu"
FIX = "run: pip install 'qcone[compiler]' (or: apt install gcc)"
Add = Callable[..., Path]


def _names(cc: str | None = None) -> list[str]:
    return [found.name for found in compilers(cc)]


def test_cc_that_is_gcc_is_listed_once_as_gcc(fake_compilers: Add) -> None:
    fake_compilers("cc", f"cc {GNU}")
    gcc = fake_compilers("gcc", f"gcc {GNU}")
    assert [(c.name, c.command, c.family, c.version) for c in compilers()] == [("gcc", (str(gcc),), "gcc", "12.2.0")]


def test_cc_that_is_clang_keeps_its_place_before_gcc(fake_compilers: Add) -> None:
    fake_compilers("cc", CLANG)
    fake_compilers("gcc", f"gcc {GNU}")
    fake_compilers("clang", CLANG)
    assert _names() == ["clang", "gcc"]


def test_cc_that_is_neither_gcc_nor_clang_keeps_its_name(fake_compilers: Add) -> None:
    fake_compilers("cc", "strange compiler 3.1")
    fake_compilers("gcc", f"gcc {GNU}")
    assert [(c.name, c.family, c.version) for c in compilers()] == [
        ("cc", "unknown", "3.1"),
        ("gcc", "gcc", "12.2.0"),
    ]


def test_same_version_text_for_another_machine_is_another_compiler(
    fake_compilers: Add, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_compilers("aarch64-linux-gnu-gcc", f"aarch64-linux-gnu-gcc {GNU}", machine="aarch64-linux-gnu")
    fake_compilers("gcc", f"gcc {GNU}")
    monkeypatch.setenv("CC", "aarch64-linux-gnu-gcc")
    assert _names() == ["aarch64-linux-gnu-gcc", "gcc"]


def test_search_order_is_argument_then_environment_then_names(
    fake_compilers: Add, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number, name in enumerate(("clang", "gcc", "cc", "second", "first")):
        fake_compilers(name, f"own compiler 1.{number}")
    monkeypatch.setenv("CC", "second")
    assert _names("first") == ["first", "second", "cc", "gcc", "clang"]
    assert first_compiler("first").name == "first"
    assert first_compiler().name == "second"


def test_command_in_cc_variable_keeps_its_words_and_is_named_by_the_program(
    fake_compilers: Add, monkeypatch: pytest.MonkeyPatch
) -> None:
    ccache = fake_compilers("ccache", f"gcc {GNU}")
    fake_compilers("gcc", f"gcc {GNU}")
    monkeypatch.setenv("CC", "ccache gcc -m32")
    assert [(c.name, c.command[1:]) for c in compilers()] == [("gcc", ("gcc", "-m32")), ("gcc", ())]
    assert compilers()[0].command[0] == str(ccache)


def test_program_path_with_a_space_is_one_word(fake_compilers: Add) -> None:
    program = fake_compilers("my compiler", f"gcc {GNU}")
    assert compilers(str(program))[0].command == (str(program),)


def test_program_that_fails_is_passed_over(fake_compilers: Add, monkeypatch: pytest.MonkeyPatch) -> None:
    fake_compilers("cc", f"cc {GNU}", status=1)
    fake_compilers("gcc", f"gcc {GNU}")
    monkeypatch.setenv("CC", "nothing-of-this-name")
    assert _names() == ["gcc"]


def test_absent_families_are_named(fake_compilers: Add, monkeypatch: pytest.MonkeyPatch) -> None:
    assert absent() == ("gcc", "clang")
    fake_compilers("gcc", f"gcc {GNU}")
    assert absent() == ("clang",)


def test_ziglang_counts_as_the_clang_family(zig: Compiler, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    assert absent() == ("gcc",)
    assert compilers() == (zig,)
    assert zig.command == (sys.executable, "-m", "ziglang", "cc")
    assert "(ziglang 0." in zig.version


@pytest.mark.usefixtures("fake_compilers")
def test_no_compiler_names_the_fix() -> None:
    assert compilers() == ()
    with pytest.raises(MissingToolError) as caught:
        first_compiler()
    assert str(caught.value) == (
        "no C compiler found: $CC, cc, gcc and clang do not answer and the ziglang package is not installed; " + FIX
    )
    assert caught.value.exit_code == 3


def test_cc_option_without_such_a_program_says_so(fake_compilers: Add) -> None:
    fake_compilers("gcc", f"gcc {GNU}")
    with pytest.raises(MissingToolError) as caught:
        first_compiler("no-such-cc -O2")
    assert str(caught.value) == (
        "--cc no-such-cc -O2: there is no program 'no-such-cc' on this machine; name an installed C compiler,"
        f" or leave --cc out: {FIX}"
    )


def test_cc_option_naming_no_compiler_says_so(fake_compilers: Add) -> None:
    fake_compilers("list", "usage: list", status=2)
    with pytest.raises(MissingToolError) as caught:
        compilers("list")
    assert "--cc list: it does not answer to --version as a C compiler does" in str(caught.value)


def test_empty_cc_option_is_an_error_not_the_default(fake_compilers: Add) -> None:
    fake_compilers("gcc", f"gcc {GNU}")
    with pytest.raises(MissingToolError, match="there is no program ''"):
        first_compiler("")


@pytest.mark.parametrize(
    ("name", "command", "family", "expected"),
    [
        ("gcc", ("gcc",), "gcc", ("-std=c99", "-ffp-contract=off", "-fno-tree-vectorize")),
        ("clang", ("clang",), "clang", ("-std=c99", "-ffp-contract=off")),
        (
            "zig",
            ("py", "-m", "ziglang", "cc"),
            "clang",
            ("-std=c99", "-ffp-contract=off", "-fno-sanitize=undefined"),
        ),
        ("zig", ("/opt/zig", "cc"), "clang", ("-std=c99", "-ffp-contract=off", "-fno-sanitize=undefined")),
        ("tcc", ("tcc",), "tcc", ("-std=c99",)),
        ("cc", ("cc",), "unknown", ("-std=c99", "-ffp-contract=off")),
    ],
)
def test_flags_of_each_family(name: str, command: tuple[str, ...], family: str, expected: tuple[str, ...]) -> None:
    assert flags(Compiler(name, command, family, "1.0")) == expected


def test_warning_flags_are_those_the_emitted_files_promise() -> None:
    promised = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Wundef"
    assert " ".join(compiler.WARNING_FLAGS) == promised
