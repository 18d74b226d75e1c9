"""A second executor: qemu-system-arm plays a whole board, whose program reads and writes files by semihosting."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from qcone.errors import UsageError
from qcone.targets.compiler import Compiler
from qcone.targets.cross import LEVEL, build
from qcone.targets.emulation import NotMeasuredError
from qcone.targets.machines import TARGETS, Board, Target

PROGRAM = "qemu-system-arm"
FIX = "apt install qemu-system-arm"
ANSWER_S = 300.0

_SCRIPT = """\
ENTRY(board_reset)
MEMORY {{
    code (rx) : ORIGIN = 0x{code:08x}, LENGTH = {code_size}
    data (rw) : ORIGIN = 0x{data:08x}, LENGTH = {data_size}
}}
SECTIONS {{
    .text : {{ KEEP(*(.vectors)) *(.text*) *(.rodata*) }} > code
    .ARM.exidx : {{ *(.ARM.exidx*) }} > code
    .data : {{ *(.data*) }} > data
    .bss : {{ *(.bss*) *(COMMON) }} > data
    board_stack_top = 0x{top:08x};
}}
"""


def boards_for(targets: Sequence[Target], words: str) -> tuple[Target, ...]:
    """Return the targets that have a board: of `all` those that do; otherwise UsageError for one that does not."""
    able = [name for name, each in TARGETS.items() if each.board]
    for each in targets:
        if each.board is None and words != "all":
            raise UsageError(f"--executor qemu: {each.name} has no board in it; those that have one: {', '.join(able)}")
    return tuple(each for each in targets if each.board)


def version() -> str | None:
    """Return the version of qemu-system-arm; None when it is not installed."""
    program = shutil.which(PROGRAM)
    if program is None:
        return None
    done = subprocess.run([program, "--version"], capture_output=True, text=True, check=False)
    match = re.search(r"\d+\.\d+\.\d+", done.stdout)
    return match.group() if match else None


def run(
    compiler: Compiler, target: Target, files: Mapping[str, str], vectors: bytes, extra: Sequence[str] = ()
) -> bytes:
    """Build `files`, which hold a board's main program, run it on the rows `vectors`, and return what it wrote.

    Raises CompileError, and NotMeasuredError when qemu fails or does not end.
    """
    board = target.board
    assert board
    sources = {**files, "board.ld": _script(board)}
    program = build(compiler, target, sources, ["board_reset"], LEVEL, extra, "board.ld")
    with tempfile.TemporaryDirectory(prefix="qcone-") as name:
        folder = Path(name)
        (folder / "vectors").write_bytes(vectors)
        quiet = ("-nographic", "-monitor", "none", "-serial", "none")
        asking = ("-semihosting-config", "enable=on,target=native")
        command = [PROGRAM, "-M", board.name, *quiet, *asking, "-kernel", str(program)]
        try:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=ANSWER_S, check=False)
        except subprocess.TimeoutExpired as error:
            raise NotMeasuredError(f"not measured: {PROGRAM} did not end within {ANSWER_S:g} s") from error
        except OSError as error:
            raise NotMeasuredError(f"not measured: {PROGRAM}: {error.strerror}; {FIX}") from error
        written = folder / "words"
        if done.returncode or not written.is_file():
            said = (done.stderr.strip().splitlines() or ["it said nothing"])[0]
            raise NotMeasuredError(f"not measured: {PROGRAM} ended with exit code {done.returncode}: {said}")
        return written.read_bytes()


def _script(board: Board) -> str:
    (code, code_size), (data, data_size) = board.code, board.data
    return _SCRIPT.format(code=code, code_size=code_size, data=data, data_size=data_size, top=data + data_size)
