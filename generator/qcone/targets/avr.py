"""An 8-bit AVR: ziglang shows that the C compiles for it, avr-gcc and simavr that it runs there.

It is no row of the table of targets: ziglang cannot link for it, and unicorn cannot play it.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Mapping

from qcone.targets.build import build_image, compile_object
from qcone.targets.compiler import Compiler, compilers, flags
from qcone.targets.emulation import NotMeasuredError

NAME = "avr"
PART = "atmega328p"
LEVEL = "-Os"
SIMULATOR, COMPILER = "simavr", "avr-gcc"
FIX = "apt install simavr gcc-avr avr-libc"
VECTOR_BYTES = 12_000
"""Flash that vectors may take: the part has 32 kB for them and the code."""
ANSWER_S = 120.0
_ZIG = ("-target", "avr-freestanding", f"-mcpu={PART}", f"-mmcu={PART}", "-ffreestanding")
_LINE = re.compile(r"^(?:\x1b\[\d+m)*((?:[0-9a-f]{2})+)\.?\s*$", re.MULTILINE)


def present() -> bool:
    """Tell whether both the compiler and the simulator are installed."""
    return bool(shutil.which(SIMULATOR) and shutil.which(COMPILER))


def compile_check(compiler: Compiler, files: Mapping[str, str]) -> None:
    """Compile the one .c of `files` with zig for the part. Raises CompileError."""
    compile_object(compiler, files, LEVEL, target_flags=_ZIG)


def cross_gcc() -> Compiler:
    """Return avr-gcc. Raises MissingToolError."""
    return compilers(COMPILER)[0]


def run(compiler: Compiler, files: Mapping[str, str], vectors: bytes, rows: int) -> bytes:
    """Build `files`, which hold a main program, with rows of vectors in flash, and return the bytes it wrote.

    Raises CompileError, and NotMeasuredError when the simulator fails or does not end.
    """
    listed = ", ".join(map(str, vectors))
    header = f"#define AVR_ROWS {rows}U\nstatic const uint8_t avr_vectors[] PROGMEM = {{{listed}}};\n"
    chosen = (*flags(compiler), LEVEL, f"-mmcu={PART}", "-ffunction-sections", "-Wl,--gc-sections", "-lm")
    program = build_image(compiler, {**files, "vectors.h": header}, chosen)
    command = [SIMULATOR, "-m", PART, "-f", "16000000", str(program)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=ANSWER_S, check=False)
    except subprocess.TimeoutExpired as error:
        raise NotMeasuredError(f"not measured: {SIMULATOR} did not end within {ANSWER_S:g} s") from error
    except OSError as error:
        raise NotMeasuredError(f"not measured: {SIMULATOR}: {error.strerror}; {FIX}") from error
    return bytes.fromhex("".join(_LINE.findall(done.stdout + done.stderr)))
