"""What a linked ELF file holds: segments to load, functions by name, and where code turns into data."""

from __future__ import annotations

import io
from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from qcone.errors import UsageError
from qcone.targets.extra import needed
from qcone.targets.machines import Target

MACHINES: Mapping[str, str] = {"EM_ARM": "arm", "EM_RISCV": "riscv", "EM_PPC": "powerpc"}
_WRITABLE, _ALLOCATED, _EXECUTABLE = 0x1, 0x2, 0x4
_UNWINDING = (".ARM.exidx", ".ARM.extab", ".eh_frame")


@dataclass(frozen=True)
class Function:
    """A function of an image: where it begins, the bit of Thumb left out, and how many bytes it takes."""

    name: str
    address: int
    size: int

    def __contains__(self, address: int) -> bool:
        """Tell whether an address lies inside."""
        return self.address <= address < self.address + self.size


@dataclass(frozen=True)
class Segment:
    """Bytes to be loaded at an address; `size` may be larger, the rest is zero."""

    address: int
    data: bytes
    size: int


@dataclass(frozen=True)
class Section:
    """A section that takes memory."""

    name: str
    address: int
    size: int
    code: bool
    writable: bool


@dataclass(frozen=True)
class Image:
    """A linked ELF file, read. `marks` say from which address on there is code (True) or data in between.

    `producer` is the compiler's line in the file, empty where it left none.
    """

    architecture: str
    big_endian: bool
    linked: bool
    segments: tuple[Segment, ...]
    sections: tuple[Section, ...]
    functions: tuple[Function, ...]
    symbols: Mapping[str, int]
    marks: tuple[tuple[int, bool], ...]
    producer: str

    @cached_property
    def _sorted(self) -> tuple[tuple[int, ...], tuple[Function, ...]]:
        placed = tuple(sorted(self.functions, key=lambda each: (each.address, each.size, each.name)))
        return tuple(each.address for each in placed), placed

    def function(self, name: str) -> Function | None:
        """Return the function of that name, if there is one."""
        return next((each for each in self.functions if each.name == name), None)

    def names_at(self, address: int) -> tuple[str, ...]:
        """Return the names of the functions that begin at an address, in order."""
        return tuple(sorted(each.name for each in self.functions if each.address == address))

    def around(self, address: int) -> Function | None:
        """Return the last function that begins at or before an address and holds it."""
        addresses, placed = self._sorted
        at = bisect_right(addresses, address) - 1
        return placed[at] if at >= 0 and (address in placed[at] or address == placed[at].address) else None

    def place(self, address: int) -> str:
        """Return an address as `function+offset`, for people."""
        found = self.around(address)
        return f"{found.name}+0x{address - found.address:x}" if found else f"0x{address:08x}"

    def bytes_at(self, address: int, size: int) -> bytes:
        """Return bytes of the loaded image; fewer where it ends."""
        for each in self.segments:
            if each.address <= address < each.address + len(each.data):
                return each.data[address - each.address :][:size]
        return b""

    @property
    def code_bytes(self) -> int:
        """Return the bytes of all code, literals between it counted."""
        return sum(each.size for each in self.sections if each.code)

    @property
    def read_only_bytes(self) -> int:
        """Return the bytes of constants outside the code, tables for unwinding left out."""
        constants = [each for each in self.sections if not each.code and not each.writable]
        return sum(each.size for each in constants if not each.name.startswith(_UNWINDING))


def read_image(data: bytes, name: str) -> Image:
    """Read an ELF file. Raises UsageError when it is none, or of a machine that no target has."""
    with needed("pyelftools"):
        from elftools.common.exceptions import ELFError
        from elftools.elf.elffile import ELFFile
    try:
        file = ELFFile(io.BytesIO(data))
        machine = str(file["e_machine"])
        if machine not in MACHINES or file.elfclass != 32:
            raise UsageError(f"{name}: an ELF file of {file.elfclass} bits for {machine}; no target is that")
        return _image(file, MACHINES[machine])
    except (ELFError, UnicodeDecodeError, ValueError, KeyError, AttributeError, TypeError, OverflowError) as error:
        raise UsageError(f"{name}: not a whole ELF file: {error or 'cut short'}; give what the linker wrote") from error


def _image(file: Any, architecture: str) -> Image:
    thumb = 1 if architecture == "arm" else 0
    functions: list[Function] = []
    symbols: dict[str, int] = {}
    marks: list[tuple[int, bool]] = []
    executable = {number for number, each in enumerate(file.iter_sections()) if each["sh_flags"] & _EXECUTABLE}
    tables = [each for each in file.iter_sections() if each["sh_type"] == "SHT_SYMTAB"]
    for symbol in (each for table in tables for each in table.iter_symbols()):
        kind, name, value, where = symbol["st_info"]["type"], symbol.name, int(symbol["st_value"]), symbol["st_shndx"]
        if where == "SHN_UNDEF" or not name:
            continue
        symbols[name] = value
        if name.startswith(("$t", "$a", "$x", "$d")):
            if where in executable:
                marks.append((value, name[1] != "d"))
        elif kind == "STT_FUNC":
            functions.append(Function(name, value & ~thumb, int(symbol["st_size"])))
    sections = tuple(
        Section(
            each.name,
            each["sh_addr"],
            each["sh_size"],
            bool(each["sh_flags"] & _EXECUTABLE),
            bool(each["sh_flags"] & _WRITABLE),
        )
        for each in file.iter_sections()
        if each["sh_flags"] & _ALLOCATED and each["sh_size"]
    )
    segments = tuple(
        Segment(each["p_vaddr"], each.data(), each["p_memsz"])
        for each in file.iter_segments()
        if each["p_type"] == "PT_LOAD" and each["p_memsz"]
    )
    comment = file.get_section_by_name(".comment")
    lines = comment.data().decode("utf-8", "replace").split("\0") if comment else []
    said = [each for each in lines if each and not each.startswith("Linker:")]
    return Image(
        architecture,
        not file.little_endian,
        file["e_type"] == "ET_EXEC",
        segments,
        sections,
        tuple(functions),
        symbols,
        tuple(sorted(marks)),
        said[-1] if said else "",
    )


def check_fits(image: Image, target: Target, name: str) -> None:
    """Raise UsageError unless an image is linked and of the target's architecture."""
    if (image.architecture, image.big_endian) != (target.architecture, target.big_endian):
        order = "big-endian" if image.big_endian else "little-endian"
        raise UsageError(f"--elf {name}: it is {order} {image.architecture}, not {target.name}; name its target")
    if not image.linked:
        raise UsageError(f"--elf {name}: it is not linked: give the program, not an object")
