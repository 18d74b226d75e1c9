"""Machine code read back: the instructions of an image, what each computes, and what it calls."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from qcone.targets.elf import Function, Image
from qcone.targets.extra import needed

_LONGEST = 4
"""Bytes of the longest instruction of any target."""


@dataclass(frozen=True)
class Instruction:
    """One instruction: where it is, how many bytes it takes, and its text."""

    address: int
    size: int
    mnemonic: str
    operands: str

    @property
    def fall_through(self) -> int:
        """Return the address after it."""
        return self.address + self.size


@dataclass(frozen=True)
class Arithmetic:
    """What a float instruction computes: products, sums, whether fused, and in how many bits."""

    multiply: int
    add: int
    fused: bool
    bits: int


# Two roundings or one: VMLA rounds the product, VFMA does not.
_FLOAT: Mapping[str, tuple[tuple[str, int, int, bool], ...]] = {
    "arm": (
        (r"vn?mul\w*\.f(?P<bits>32|64)", 1, 0, False),
        (r"v(?:add|sub)\w*\.f(?P<bits>32|64)", 0, 1, False),
        (r"vn?ml[as]\w*\.f(?P<bits>32|64)", 1, 1, False),
        (r"vfn?m[as]\w*\.f(?P<bits>32|64)", 1, 1, True),
    ),
    "riscv": (
        (r"fmul\.(?P<bits>s|d)", 1, 0, False),
        (r"f(?:add|sub)\.(?P<bits>s|d)", 0, 1, False),
        (r"fn?m(?:add|sub)\.(?P<bits>s|d)", 1, 1, True),
    ),
    "powerpc": (
        (r"fmul(?P<bits>s?)\.?", 1, 0, False),
        (r"f(?:add|sub)(?P<bits>s?)\.?", 0, 1, False),
        (r"fn?m(?:add|sub)(?P<bits>s?)\.?", 1, 1, True),
    ),
}
_SINGLE = ("32", "s")
# Products of two words: all of their bits or the upper half, and the lower half alone.
_WORDS: Mapping[str, tuple[str, str]] = {
    "arm": (
        r"[us](?:mull|mlal)s?|umaal|smm(?:ul|la|ls)r?",
        r"muls?|ml[as]s?|smul[btw][bt]|smlal?[btw][bt]|sml[as]l?dx?",
    ),
    "riscv": (r"mulhs?u?", r"(?:c\.)?mul"),
    "powerpc": (r"mulhwu?\.?", r"mull[wi]o?\.?"),
}
_CALL = re.compile(r"(?:bl|bl?x|b\.w|b|jal|j|c\.jal|c\.j)")
_ADDRESSES = 0xFFFF_FFFF
_DESTINATION = re.compile(r"#?(-?0x[0-9a-f]+|-?\d+)$")


class Disassembler:
    """Reads instructions out of an image, each address once."""

    def __init__(self, image: Image) -> None:
        """Prepare to read the image's architecture."""
        with needed("capstone"):
            import capstone as cs
        modes = {
            "arm": (cs.CS_ARCH_ARM, cs.CS_MODE_THUMB | cs.CS_MODE_MCLASS | cs.CS_MODE_V8),
            "riscv": (cs.CS_ARCH_RISCV, cs.CS_MODE_RISCV32 | cs.CS_MODE_RISCVC),
            "powerpc": (cs.CS_ARCH_PPC, cs.CS_MODE_32 | cs.CS_MODE_BIG_ENDIAN),
        }
        self.image = image
        self._reader: Any = cs.Cs(*modes[image.architecture])
        self._known: dict[int, Instruction] = {}

    def at(self, address: int) -> Instruction:
        """Return the instruction at an address; what cannot be read is named `unknown`."""
        if address not in self._known:
            data = self.image.bytes_at(address, _LONGEST)
            read = next(self._reader.disasm_lite(data, address, 1), None)
            size = 2 if self.image.architecture == "arm" else 4
            found = Instruction(address, size, "unknown", "") if read is None else Instruction(*read)
            self._known[address] = found
        return self._known[address]

    def of(self, function: Function) -> Iterator[Instruction]:
        """Yield the instructions of a function, data between them left out."""
        address = function.address
        while address < function.address + function.size:
            if not self._is_code(address):
                address += 4 - address % 4
                continue
            instruction = self.at(address)
            yield instruction
            address = instruction.fall_through

    def _is_code(self, address: int) -> bool:
        code = True
        for at, is_code in self.image.marks:
            if at > address:
                break
            code = is_code
        return code

    def arithmetic(self, instruction: Instruction) -> Arithmetic | None:
        """Return what a float instruction computes; None for every other."""
        for pattern, multiply, add, fused in _FLOAT[self.image.architecture]:
            if match := re.fullmatch(pattern, instruction.mnemonic):
                return Arithmetic(multiply, add, fused, 32 if match["bits"] in _SINGLE else 64)
        return None

    def product(self, instruction: Instruction) -> int | None:
        """Return 64 for a product of two words with its upper half, 32 for one without; None for no such product."""
        whole, lower = _WORDS[self.image.architecture]
        name = instruction.mnemonic.removesuffix(".w")
        if re.fullmatch(whole, name):
            return 64
        return 32 if re.fullmatch(lower, name) else None

    def destinations(self, function: Function) -> Iterator[int]:
        """Yield where the direct calls and jumps of a function go."""
        upper: dict[str, int] = {}
        for instruction in self.of(function):
            words = [each.strip() for each in instruction.operands.split(",")]
            if instruction.mnemonic == "auipc":  # a RISC-V call may be far: its upper bits are made first
                upper[words[0]] = instruction.address + (int(words[1], 0) << 12)
            elif instruction.mnemonic in ("jalr", "jr") and len(words) > 1 and words[-2] in upper:
                yield upper[words[-2]] + int(words[-1], 0) & _ADDRESSES
            elif _CALL.fullmatch(instruction.mnemonic) and (match := _DESTINATION.search(words[-1])):
                base = instruction.address if self.image.architecture == "riscv" else 0
                yield base + int(match[1], 0)
