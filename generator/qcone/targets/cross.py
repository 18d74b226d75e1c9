"""Build a program for a target: emitted C unchanged, with ziglang or with a gcc for that machine.

No C library is linked and no start-up code: the program is a set of functions that an executor calls by address.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from pathlib import Path

from qcone.errors import MissingToolError, UsageError
from qcone.targets.build import build_image
from qcone.targets.compiler import Compiler, compilers, flags, is_zig
from qcone.targets.elf import Image, read_image
from qcone.targets.extra import FIX
from qcone.targets.machines import Target

LEVEL = "-O2"
_COMMON = ("-g", "-ffreestanding", "-ffunction-sections", "-fdata-sections")
_NO_UNWINDING = ("-fno-unwind-tables", "-fno-asynchronous-unwind-tables")

# A gcc without a C library may still call these four. Volatile: a loop must not become a call of itself.
_MEMORY = """\
#include <stddef.h>

void *memset(void *to, int value, size_t size);
void *memcpy(void *to, const void *from, size_t size);
void *memmove(void *to, const void *from, size_t size);
int memcmp(const void *a, const void *b, size_t size);

void *memset(void *to, int value, size_t size)
{
    volatile unsigned char *out = to;
    for (size_t k = 0; k < size; ++k) {
        out[k] = (unsigned char)value;
    }
    return to;
}

void *memmove(void *to, const void *from, size_t size)
{
    volatile unsigned char *out = to;
    const volatile unsigned char *in = from;
    for (size_t k = 0; k < size; ++k) {
        const size_t at = (out < in) ? k : (size - 1U - k);
        out[at] = in[at];
    }
    return to;
}

void *memcpy(void *to, const void *from, size_t size)
{
    return memmove(to, from, size);
}

int memcmp(const void *a, const void *b, size_t size)
{
    const volatile unsigned char *first = a;
    const volatile unsigned char *second = b;
    for (size_t k = 0; k < size; ++k) {
        if (first[k] != second[k]) {
            return (first[k] < second[k]) ? -1 : 1;
        }
    }
    return 0;
}
"""


def cross_compiler(cc: str | None = None) -> Compiler:
    """Return the compiler for other machines: `cc`, or the ziglang package. Raises MissingToolError."""
    if cc is not None:
        return compilers(cc)[0]
    found = next((each for each in compilers() if each.name == "zig"), None)
    if found is None:
        raise MissingToolError(f"ziglang is not installed, which compiles for targets other than the host; {FIX}")
    return found


def suits(compiler: Compiler, target: Target) -> bool:
    """Tell whether a compiler makes programs for a target: zig for every one, a gcc for the machine it states."""
    return is_zig(compiler) or compiler.machine.startswith(target.prefix)


def check_suits(compiler: Compiler, target: Target) -> None:
    """Raise UsageError for a compiler of another machine."""
    if not suits(compiler, target):
        machine = compiler.machine or "a machine it does not state"
        raise UsageError(
            f"--cc {compiler.name}: it compiles for {machine}, not for {target.name}; "
            f"name a {target.prefix} gcc, or leave --cc out"
        )


def build(
    compiler: Compiler,
    target: Target,
    files: Mapping[str, str],
    entries: Sequence[str],
    level: str = LEVEL,
    extra: Sequence[str] = (),
    script: str | None = None,
) -> Path:
    """Compile and link `files` for a target and return the cached program.

    `entries` are the functions kept, with all they call; what nobody calls is dropped. `script` names a linker
    script among the files. Raises CompileError.
    """
    names = [f"-Wl,-u,{each}" for each in entries[1:]]
    chosen = [*_COMMON, *flags(compiler), level, *(target.zig if is_zig(compiler) else target.gcc), *_NO_UNWINDING]
    chosen += [*extra, "-nostdlib", "-lcompiler_rt" if is_zig(compiler) else "-lgcc"]
    chosen += [f"-Wl,-e,{entries[0]}", *names, "-Wl,--gc-sections", *(["-T", script] if script else [])]
    sources = files if is_zig(compiler) else {**files, "memory.c": _MEMORY}
    return build_image(compiler, sources, tuple(chosen))


@functools.lru_cache(maxsize=64)
def _read(path: Path) -> Image:
    return read_image(path.read_bytes(), path.name)


def built_image(
    compiler: Compiler,
    target: Target,
    files: Mapping[str, str],
    entries: Sequence[str],
    level: str = LEVEL,
    extra: Sequence[str] = (),
) -> Image:
    """Build as `build` does and read the result."""
    return _read(build(compiler, target, files, entries, level, extra))
