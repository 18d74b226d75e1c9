"""Run C under the sanitizers of undefined behaviour and of memory, in a process of its own.

A compiler may accept -fsanitize and check nothing: tcc does, and `zig cc` has no address sanitizer. So each
sanitizer counts as available only after it has caught a mistake made on purpose.
"""

from __future__ import annotations

import functools
import os
import re
import signal
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from qcone.targets.build import CompileError, build_program
from qcone.targets.compiler import Compiler, is_zig

SANITIZERS = ("undefined", "address")

_ZIG_LIBRARIES = ("-nostdlib", "-lc")
_REPORT = re.compile(r"^.*(?:runtime error: |SUMMARY: AddressSanitizer: ).*$", re.MULTILINE)
_ADDRESS = re.compile(r"\b0x[0-9a-f]+")
_FOLDERS = re.compile(r"/\S*/")
_RUNTIME = {"ubsan_reports.c": (Path(__file__).parent / "ubsan_reports.c").read_text(encoding="utf-8")}

_CONTROLS = {
    "undefined": """\
int main(void)
{
    volatile int largest = 2147483647;
    volatile int sum = largest + 1;
    return sum == 0;
}
""",
    "address": """\
int main(void)
{
    volatile int words[2] = {0, 0};
    volatile int after = 2;
    return *(&words[0] + after) == 1;
}
""",
}


@dataclass(frozen=True)
class SanitizerReport:
    """What the sanitizers said of one run.

    `available` is False when this compiler has none that works; `sanitizers` are those that ran. `reports`
    counts the places reported, and one for a signal, a failed exit or a run without end; `first` is the first
    of them. `output` is what the program wrote.
    """

    available: bool
    reports: int
    first: str
    output: bytes
    sanitizers: tuple[str, ...]


def run_sanitized(
    compiler: Compiler,
    files: Mapping[str, str],
    level: str,
    main: str,
    vectors: bytes,
    extra: Sequence[str] = (),
    timeout_s: float = 600.0,
) -> SanitizerReport:
    """Build `files` and the program text `main` with the sanitizers of `compiler`, and run it on `vectors`.

    The program reads `vectors` from the file named by its first argument, writes its result to the file named
    by its second and returns 0. Raises CompileError when the text does not compile.
    """
    sanitizers = available_sanitizers(compiler)
    if not sanitizers:
        return SanitizerReport(False, 0, "", b"", ())
    program = _build(compiler, {**files, "sanitized_main.c": main}, level, sanitizers, extra)
    with tempfile.TemporaryDirectory(prefix="qcone-") as folder:
        read, written = Path(folder) / "vectors", Path(folder) / "result"
        read.write_bytes(vectors)
        reports = _reports(program, (str(read), str(written)), timeout_s)
        output = written.read_bytes() if written.exists() else b""
    return SanitizerReport(True, len(reports), reports[0] if reports else "", output, sanitizers)


@functools.cache
def available_sanitizers(compiler: Compiler) -> tuple[str, ...]:
    """Return those of SANITIZERS that catch, with `compiler`, the mistake they are for."""
    return tuple(name for name in SANITIZERS if _catches(compiler, name))


def _catches(compiler: Compiler, sanitizer: str) -> bool:
    try:
        program = _build(compiler, {"control.c": _CONTROLS[sanitizer]}, "-O1", (sanitizer,), ())
    except CompileError:
        return False
    said = _reports(program, (), timeout_s=60.0)
    return bool(said) and _REPORT.match(said[0]) is not None


def _build(
    compiler: Compiler, files: Mapping[str, str], level: str, sanitizers: Sequence[str], extra: Sequence[str]
) -> Path:
    chosen = ["-g", "-fno-omit-frame-pointer", *(f"-fsanitize={name}" for name in sanitizers)]
    if "undefined" in sanitizers:
        chosen += ["-fsanitize=float-cast-overflow", "-fsanitize-recover=undefined,float-cast-overflow"]
    if not is_zig(compiler):
        return build_program(compiler, files, level, (*chosen, *extra))
    # zig's own runtime stops at the first report and takes some twenty seconds to build; ours goes on.
    libraries = _ZIG_LIBRARIES if _links_at_once(compiler) else ()
    return build_program(compiler, {**files, **_RUNTIME}, level, (*chosen, *extra, *libraries))


@functools.cache
def _links_at_once(compiler: Compiler) -> bool:
    """Tell whether zig can use the libc that is here, and so be spared the seconds of building its own."""
    try:
        build_program(compiler, _RUNTIME | {"main.c": "int main(void) { return 0; }\n"}, "-O1", _ZIG_LIBRARIES)
    except CompileError:
        return False
    return True


def _reports(program: Path, arguments: Sequence[str], timeout_s: float) -> list[str]:
    """Run `program` and return one line for each thing wrong with the run."""
    settings = {"ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=0", "LC_ALL": "C"}
    try:
        done = subprocess.run(
            [str(program), *arguments],
            capture_output=True,
            text=True,
            errors="replace",
            timeout=timeout_s,
            check=False,
            env={**os.environ, **settings},
        )
    except subprocess.TimeoutExpired:
        return [f"the program did not end within {timeout_s:g} s"]
    except OSError as error:
        return [f"the program could not be started: {error}"]
    found = [_ADDRESS.sub("0x...", _FOLDERS.sub("", match)) for match in _REPORT.findall(done.stderr)]
    if found or done.returncode == 0:
        return found
    if done.returncode < 0:
        return [f"the program was ended by signal {signal.Signals(-done.returncode).name}"]
    return [f"the program ended with exit code {done.returncode}: {done.stderr.strip()[:200]}"]
