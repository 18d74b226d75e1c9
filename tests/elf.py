"""The symbol table of an ELF object, read without any tool: what the object needs and what it defines."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass

SYMBOL_TABLE = 2
UNDEFINED = 0
LOCAL = 0


@dataclass(frozen=True)
class Symbols:
    """Names the object leaves undefined, names it defines for others, and the bytes of each of these."""

    undefined: frozenset[str]
    exported: frozenset[str]
    sizes: Mapping[str, int]


def read_symbols(data: bytes) -> Symbols:
    """Return the symbols of a little-endian ELF object, 32 or 64 bits."""
    if data[:4] != b"\x7fELF" or data[5] != 1:
        raise ValueError("not a little-endian ELF object")
    wide = data[4] == 2
    (table,) = struct.unpack_from("<Q" if wide else "<I", data, 40 if wide else 32)
    size, count = struct.unpack_from("<HH", data, 58 if wide else 46)
    sections = [_section(data, table + size * n, wide) for n in range(count)]
    undefined, sizes = set(), {}
    for kind, offset, length, link in sections:
        if kind != SYMBOL_TABLE:
            continue
        names = sections[link][1]
        for at in range(offset, offset + length, 24 if wide else 16):
            if wide:
                name, info, _, where, _, bytes_ = struct.unpack_from("<IBBHQQ", data, at)
            else:
                name, _, bytes_, info, _, where = struct.unpack_from("<IIIBBH", data, at)
            text = data[names + name : data.index(b"\0", names + name)].decode()
            if not text:
                continue
            if where == UNDEFINED:
                undefined.add(text)
            elif info >> 4 != LOCAL:
                sizes[text] = bytes_
    return Symbols(frozenset(undefined), frozenset(sizes), sizes)


def _section(data: bytes, at: int, wide: bool) -> tuple[int, int, int, int]:
    """Return type, file offset, size and link of a section."""
    if wide:
        _, kind, _, _, offset, size, link = struct.unpack_from("<IIQQQQI", data, at)
    else:
        _, kind, _, _, offset, size, link = struct.unpack_from("<IIIIIII", data, at)
    return kind, offset, size, link
