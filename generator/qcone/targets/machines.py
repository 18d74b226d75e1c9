"""The targets: one row each. How a compiler is told of it, which processor runs it, what its arithmetic has.

The compiler flags name the FPU, without which clang makes soft float of a hard-float ABI and says nothing. A
lowering asks the last facts: whether one instruction gives the 64 bits of a 32-bit product, or its upper word.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from qcone.errors import UsageError

NONE, SINGLE, DOUBLE = "none", "single", "double"
"""What an FPU computes in hardware; `double` includes `single`."""


@dataclass(frozen=True)
class Board:
    """A board of qemu-system-arm: its name, and where its memories for code and for data lie (address, bytes)."""

    name: str
    code: tuple[int, int]
    data: tuple[int, int]


@dataclass(frozen=True)
class Target:
    """A processor on which emitted C runs.

    `architecture` is host, arm, riscv or powerpc; `zig` and `gcc` are what their compilers are told, `prefix` is how
    the machine of such a gcc begins. `model` is the processor the emulator plays, `cycles` the table of cycle counts
    where an honest one exists, `board` one of qemu. `long_multiply`: one instruction gives all 64 bits of the product
    of two 32-bit words, or two give its halves; `high_word`: one gives the upper 32 alone.
    """

    name: str
    architecture: str
    zig: tuple[str, ...] = ()
    gcc: tuple[str, ...] = ()
    prefix: str = ""
    model: str = ""
    fpu: str = NONE
    big_endian: bool = False
    long_multiply: bool = True
    high_word: bool = True
    cycles: str | None = None
    board: Board | None = None

    @property
    def emulated(self) -> bool:
        """Tell whether it is another machine than this one."""
        return self.architecture != "host"

    @property
    def separate_halves(self) -> bool:
        """Tell whether each half of a product of two words is an instruction of its own."""
        return self.architecture in ("riscv", "powerpc")

    def computes(self, bits: int) -> bool:
        """Tell whether its FPU computes floats of that many bits."""
        return self.fpu == DOUBLE or (self.fpu == SINGLE and bits == 32)


_FLASH, _RAM = 0x0000_0000, 0x2000_0000
_MICROBIT = Board("microbit", (_FLASH, 256 << 10), (_RAM, 16 << 10))
_LM3S = Board("lm3s6965evb", (_FLASH, 256 << 10), (_RAM, 64 << 10))
_AN386 = Board("mps2-an386", (_FLASH, 4 << 20), (_RAM, 4 << 20))
_AN500 = Board("mps2-an500", (_FLASH, 4 << 20), (_RAM, 4 << 20))
_AN505 = Board("mps2-an505", (0x1000_0000, 4 << 20), (0x3800_0000, 4 << 20))


def _cortex_m(
    name: str,
    core: str,
    model: str,
    fpu: str = NONE,
    unit: tuple[str, str] = ("", ""),
    *,
    long_multiply: bool = True,
    high_word: bool = False,
    cycles: str | None = None,
    board: Board | None = None,
) -> Target:
    """Return the row of a Cortex-M; `unit` is the name of its FPU to clang and to gcc."""
    hard = fpu != NONE
    clang_core = core.replace("-", "_") + (f"+{unit[0]}" if hard else "")
    zig = ("-target", f"thumb-freestanding-eabi{'hf' if hard else ''}", f"-mcpu={clang_core}")
    gcc = ("-mthumb", f"-mcpu={core}", *(("-mfloat-abi=hard", f"-mfpu={unit[1]}") if hard else ("-mfloat-abi=soft",)))
    return Target(
        name,
        "arm",
        zig,
        gcc,
        "arm-none-eabi",
        model,
        fpu,
        long_multiply=long_multiply,
        high_word=high_word,
        cycles=cycles,
        board=board,
    )


def _riscv(name: str, extensions: str, model: str, fpu: str = NONE) -> Target:
    """Return the row of a 32-bit RISC-V; zig finds the ABI in the extensions."""
    zig = ("-target", "riscv32-freestanding", f"-mcpu=generic_rv32+{'+'.join(extensions)}")
    gcc = (f"-march=rv32i{''.join(each for each in 'mafdc' if each in extensions)}", "-mcmodel=medany")
    return Target(name, "riscv", zig, (*gcc, f"-mabi=ilp32{'f' if fpu == SINGLE else ''}"), "riscv", model, fpu)


_ROWS = (
    Target("host", "host"),
    _cortex_m("cortex-m0", "cortex-m0", "CORTEX_M0", long_multiply=False, cycles="cortex-m0", board=_MICROBIT),
    _cortex_m("cortex-m0plus", "cortex-m0plus", "CORTEX_M0", long_multiply=False, cycles="cortex-m0plus"),
    _cortex_m("cortex-m3", "cortex-m3", "CORTEX_M3", cycles="cortex-m3", board=_LM3S),
    _cortex_m("cortex-m4", "cortex-m4", "CORTEX_M4", high_word=True, cycles="cortex-m4", board=_AN386),
    _cortex_m(
        *("cortex-m4f", "cortex-m4", "CORTEX_M4", SINGLE, ("vfp4d16sp", "fpv4-sp-d16")),
        high_word=True,
        cycles="cortex-m4",
        board=_AN386,
    ),
    _cortex_m(
        *("cortex-m7f", "cortex-m7", "CORTEX_M7", DOUBLE, ("fp_armv8d16", "fpv5-d16")), high_word=True, board=_AN500
    ),
    _cortex_m(
        *("cortex-m33f", "cortex-m33", "CORTEX_M33", SINGLE, ("fp_armv8d16sp", "fpv5-sp-d16")),
        high_word=True,
        board=_AN505,
    ),
    _riscv("rv32imc", "mc", "SIFIVE_E31"),
    _riscv("rv32imfc", "mcf", "ANY", SINGLE),
    Target(
        "powerpc",
        "powerpc",
        ("-target", "powerpc-freestanding-eabihf", "-mcpu=ppc"),
        ("-m32", "-mcpu=powerpc", "-mhard-float"),
        "powerpc",
        "",
        DOUBLE,
        big_endian=True,
    ),
)

TARGETS: Mapping[str, Target] = {each.name: each for each in _ROWS}
"""Every target by name."""


def targets_of(words: str) -> tuple[Target, ...]:
    """Return the targets of a comma-separated list, in its order; `all` is every one. UsageError names a wrong one."""
    if words == "all":
        return tuple(TARGETS.values())
    return tuple(dict.fromkeys(_named(word.strip(), tuple(TARGETS)) for word in words.split(",")))


def _named(word: str, known: Sequence[str]) -> Target:
    if word in TARGETS:
        return TARGETS[word]
    close = get_close_matches(word, (*known, "all"), 1)
    hint = f"did you mean '{close[0]}'?" if close else f"the targets are: {', '.join(known)}"
    raise UsageError(f"--target {word}: unknown target; {hint}")
