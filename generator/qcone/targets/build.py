"""Compile source text into shared objects, objects and programs, kept in a folder addressed by content.

The same text, flags and compiler give the same file, so a second build costs one hash. Files appear by an
atomic rename: parallel runs may build the same thing and none ever sees half a file.
"""

from __future__ import annotations

import functools
import hashlib
import os
import platform
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePosixPath

from qcone.errors import MissingToolError
from qcone.targets.compiler import WARNING_FLAGS, Compiler, flags, is_zig

_SHOWN_LINES = 12
_COMPILE_S = 600.0


class CompileError(MissingToolError):
    """A compiler refused the text: carries the command and the first lines of what it said (exit code 3)."""

    def __init__(self, compiler: Compiler, command: Sequence[str], said: str) -> None:
        """Keep what `compiler` said in full as `said`; the message shows the beginning."""
        self.said = said
        lines = said.strip().splitlines() or ["(it said nothing)"]
        more = [f"... {len(lines) - _SHOWN_LINES} more lines"] if len(lines) > _SHOWN_LINES else []
        super().__init__(
            "\n".join(
                (
                    f"{compiler.name} {compiler.version} could not compile: {shlex.join(command)}",
                    *(f"  {line}" for line in (*lines[:_SHOWN_LINES], *more)),
                    "try another compiler with --cc; `qcone doctor` lists those found here",
                )
            )
        )


def build_shared(compiler: Compiler, files: Mapping[str, str], level: str, extra: Sequence[str] = ()) -> Path:
    """Compile every .c of `files` (name to text) into one shared object and return its cached path.

    `level` is one of LEVELS; `extra` flags come last and so overrule the standard ones. Raises CompileError.
    """
    chosen = ["-shared", "-fPIC", *flags(compiler), level]
    if is_zig(compiler) and sys.platform.startswith("linux"):
        # The loading process has a libc already; linking none spares zig the seconds of building its own.
        chosen.append("-nostdlib")
    return _cached(compiler, files, (*chosen, *extra), ".so")


def build_program(compiler: Compiler, files: Mapping[str, str], level: str, extra: Sequence[str] = ()) -> Path:
    """Compile every .c of `files` into one program and return its cached path; CompileError as above."""
    return _cached(compiler, files, (*flags(compiler), level, *extra), ".exe")


def compile_object(
    compiler: Compiler,
    files: Mapping[str, str],
    level: str,
    extra: Sequence[str] = (),
    target_flags: Sequence[str] = (),
) -> Path:
    """Compile the one .c of `files` (the rest are headers) into an object, for this machine or another.

    `target_flags` name the other machine, for zig as `-target thumb-freestanding-eabihf
    -mcpu=cortex_m4+vfp4d16sp`. Raises CompileError.
    """
    if len(_sources(files)) != 1:
        raise ValueError(f"one .c file makes one object, got {_sources(files)}")
    return _cached(compiler, files, ("-c", *flags(compiler), level, *target_flags, *extra), ".o")


def build_image(compiler: Compiler, files: Mapping[str, str], chosen: Sequence[str]) -> Path:
    """Compile and link every .c of `files` with exactly the `chosen` flags; CompileError as above."""
    return _cached(compiler, files, chosen, ".elf")


def warnings(compiler: Compiler, files: Mapping[str, str], level: str = "-O2", extra: Sequence[str] = ()) -> str:
    """Return what `compiler` says of each .c of `files` under WARNING_FLAGS; empty when it says nothing."""
    said = []
    # zig repeats no warning for text it has compiled before, but it does repeat an error.
    chosen = (*flags(compiler), *WARNING_FLAGS, "-Werror", level, *extra)
    with tempfile.TemporaryDirectory(prefix="qcone-") as name:
        folder = Path(name)
        _write(files, folder)
        for source in _sources(files):
            done = _run((*compiler.command, *chosen, "-c", "-I.", source, "-o", "checked.o"), folder)
            said.append(done.stderr + done.stdout)
            if done.returncode != 0 and not said[-1].strip():
                said[-1] = f"{source}: {compiler.name} failed and said nothing\n"
    return "".join(said)


def _cached(compiler: Compiler, files: Mapping[str, str], chosen: Sequence[str], suffix: str) -> Path:
    key = hashlib.sha256()
    told = (*compiler.command, compiler.version, compiler.identity, _processor(), *chosen)
    for text in (*told, *(part for name in sorted(files) for part in (name, files[name]))):
        data = text.encode()
        key.update(b"%d:" % len(data) + data)
    folder = _folder()
    product = folder / f"{key.hexdigest()}{suffix}"
    if product.exists():
        return product
    with tempfile.TemporaryDirectory(prefix="build-", dir=folder) as name:
        work = Path(name)
        _write(files, work)
        # Libraries named in `chosen` must follow the sources that need them.
        command = (*compiler.command, "-I.", *_sources(files), *chosen, "-o", "product")
        done = _run(command, work)
        if done.returncode != 0 or not (work / "product").exists():
            raise CompileError(compiler, command, done.stderr + done.stdout)
        os.replace(work / "product", product)
    return product


def _sources(files: Mapping[str, str]) -> list[str]:
    return sorted(name for name in files if name.endswith(".c"))


def _write(files: Mapping[str, str], folder: Path) -> None:
    for name, text in files.items():
        relative = PurePosixPath(name)
        if relative.is_absolute() or ".." in relative.parts or name.startswith("-"):
            raise ValueError(f"{name!r} does not name a file inside the build folder")
        path = folder / relative
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")


def _run(command: Sequence[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a compiler inside `folder`, so that its messages name the files as the caller does."""
    try:
        return subprocess.run(
            command,
            cwd=folder,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=_COMPILE_S,
            check=False,
            env={**os.environ, "LC_ALL": "C"},
        )
    except subprocess.TimeoutExpired:
        said = f"it did not end within {_COMPILE_S:.0f} s"
    except OSError as error:
        said = str(error)
    return subprocess.CompletedProcess(command, 1, "", said)


@functools.cache
def _processor() -> str:
    """Return what distinguishes this processor: zig compiles for the native one."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="ascii", errors="replace").splitlines()
    except OSError:
        lines = []
    told = [line for line in lines if line.startswith(("flags", "Features", "model name"))]
    return " ".join((platform.system(), platform.machine(), platform.processor(), *told[:2]))


@functools.cache
def _folder() -> Path:
    """Return the user's cache folder, or one of this process alone where that cannot be written."""
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData/Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library/Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME") or Path("~/.cache").expanduser())
    folder = base / "qcone"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError:
        return Path(tempfile.mkdtemp(prefix="qcone-"))
