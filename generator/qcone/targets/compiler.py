"""Find the C compilers of this machine and the flags under which each one keeps the written operations.

The search order is the `cc` argument, `$CC`, cc, gcc, clang and last the ziglang package, which is clang in a
Python wheel: with it a machine needs no system compiler at all.
"""

from __future__ import annotations

import functools
import importlib.metadata
import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import PurePath

from qcone.errors import MissingToolError

LEVELS = ("-O0", "-O1", "-O2", "-O3", "-Os")

WARNING_FLAGS = (
    "-std=c99",
    "-pedantic",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Wsign-conversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Wundef",
)

FIX = "run: pip install 'qcone[compiler]' (or: apt install gcc)"
_ZIG_NAMES = {"zig", "ziglang", "python-zig"}
_ANSWER_S = 60.0


@dataclass(frozen=True)
class Compiler:
    """A C compiler that answers on this machine.

    `name` is what reports call it: gcc, clang, cc, zig, or the base name of the program in `$CC` or `--cc`.
    `command` starts it; `family` is gcc, clang (zig too), tcc or unknown; `version` is the number it states.
    `identity` is all it says of itself and its `machine`: two compilers with one identity are one program.
    """

    name: str
    command: tuple[str, ...]
    family: str
    version: str
    identity: str = field(default="", repr=False)
    machine: str = field(default="", repr=False)


def compilers(cc: str | None = None) -> tuple[Compiler, ...]:
    """Return the distinct compilers that answer, in search order.

    A `cc` that is gcc or clang under another name is listed once, under the family's name. A `$CC` that does
    not answer is passed over; an explicit `cc` that does not raises MissingToolError.
    """
    found: dict[str, Compiler] = {}
    if cc is not None:
        chosen = _asked(_base_name(_words(cc)), _words(cc))
        if chosen is None:
            raise MissingToolError(_unusable(cc))
        found[chosen.identity] = chosen
    for name, command in _candidates():
        compiler = _asked(name, command)
        if compiler is None:
            continue
        known = found.setdefault(compiler.identity, compiler)
        if known.name == "cc" and known.family == name:
            found[compiler.identity] = compiler
    return tuple(found.values())


def first_compiler(cc: str | None = None) -> Compiler:
    """Return the compiler to use: `cc` when given, else the first found; MissingToolError names the fix."""
    found = compilers(cc)
    if not found:
        raise MissingToolError(
            f"no C compiler found: $CC, cc, gcc and clang do not answer and the ziglang package is not installed; {FIX}"
        )
    return found[0]


def absent() -> tuple[str, ...]:
    """Return those of the families gcc and clang that have no compiler here, so that reports can say so."""
    families = {compiler.family for compiler in compilers()}
    return tuple(family for family in ("gcc", "clang") if family not in families)


def flags(compiler: Compiler) -> tuple[str, ...]:
    """Return the flags under which `compiler` performs each written operation, rounded by itself.

    gcc forms fused add/subtract pairs in its SLP vectoriser even under -ffp-contract=off. zig adds checks of
    undefined behaviour, and calls to their runtime, at -O0 or without a level: give it a level every time.
    The processor is left as the compiler has it (zig: the native one).
    """
    if compiler.family == "tcc":
        return ("-std=c99",)
    common = ("-std=c99", "-ffp-contract=off")
    if compiler.family == "gcc":
        return (*common, "-fno-tree-vectorize")
    return (*common, "-fno-sanitize=undefined") if is_zig(compiler) else common


def is_zig(compiler: Compiler) -> bool:
    """Tell whether `compiler` is `zig cc`, whose runtime libraries are built on first use (seconds)."""
    return any(_plain(word) in _ZIG_NAMES for word in compiler.command)


def _candidates() -> Iterator[tuple[str, tuple[str, ...]]]:
    chosen = os.environ.get("CC", "").strip()
    if chosen:
        yield _base_name(_words(chosen)), _words(chosen)
    for name in ("cc", "gcc", "clang"):
        yield name, (name,)
    if importlib.util.find_spec("ziglang") is not None:
        yield "zig", (sys.executable, "-m", "ziglang", "cc")


def _words(cc: str) -> tuple[str, ...]:
    """Split a command such as `ccache gcc -m32`, unless it names one program whose path has spaces."""
    return (cc,) if shutil.which(cc) else tuple(shlex.split(cc, posix=os.name == "posix")) or (cc,)


def _base_name(command: tuple[str, ...]) -> str:
    """Return the program's own name: the last word that is no option (`ccache gcc -m32` is gcc)."""
    if any(_plain(word) in _ZIG_NAMES for word in command):
        return "zig"
    return _plain([word for word in command if not word.startswith("-")][-1] if command[0] else "")


def _plain(word: str) -> str:
    return PurePath(word).name.removesuffix(".exe")


def _asked(name: str, command: tuple[str, ...]) -> Compiler | None:
    """Ask `command` who it is; None when it is absent or does not answer."""
    program = shutil.which(command[0])
    if program is None:
        return None
    program = os.path.abspath(program)  # builds run in folders of their own
    text, machine = _self_description((program, *command[1:]))
    if not text:
        return None
    family = _family(text)
    stated = re.search(r"\d+\.\d+(\.\d+)?", re.sub(r"\([^)]*\)", "", text))
    version = stated.group() if stated else "unknown"
    if name == "zig" and importlib.util.find_spec("ziglang") is not None:
        version += f" (ziglang {importlib.metadata.version('ziglang')})"
    options = " ".join(word for word in command[1:] if word.startswith("-") and word != "-m")
    return Compiler(name, (program, *command[1:]), family, version, f"{family} {text} {machine} {options}", machine)


@functools.cache
def _self_description(command: tuple[str, ...]) -> tuple[str, str]:
    """Return the version text without the program's name, and the machine it compiles for."""
    text = _answer(command, "--version") or _answer(command, "-v")
    first, _, rest = text.partition("\n")
    if "Free Software Foundation" in text:
        first = first.partition(" ")[2]
    return "\n".join((first, rest)).strip(), _answer(command, "-dumpmachine")


def _answer(command: tuple[str, ...], option: str) -> str:
    try:
        done = subprocess.run(
            [*command, option],
            capture_output=True,
            text=True,
            errors="replace",
            timeout=_ANSWER_S,
            check=False,
            env={**os.environ, "LC_ALL": "C"},
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return (done.stdout or done.stderr).strip() if done.returncode == 0 else ""


def _family(text: str) -> str:
    if "clang" in text:
        return "clang"
    if "Free Software Foundation" in text:
        return "gcc"
    return "tcc" if text.startswith("tcc") else "unknown"


def _unusable(cc: str) -> str:
    words = _words(cc)
    if shutil.which(words[0]) is None:
        what = f"there is no program {words[0]!r} on this machine"
    else:
        what = "it does not answer to --version as a C compiler does"
    return f"--cc {cc}: {what}; name an installed C compiler, or leave --cc out: {FIX}"
