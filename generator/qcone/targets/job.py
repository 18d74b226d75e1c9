"""What an emulator is asked and what it answers: plain data that travels between two processes."""

from __future__ import annotations

from dataclasses import dataclass, field

LONGEST = 20_000_000
ROOM = 1 << 30
"""Bytes that the buffers of a job may have, all together."""


@dataclass(frozen=True)
class Buffer:
    """Memory handed to the code: its name for people, its bytes at the start, whether the code may write there."""

    name: str
    data: bytes
    writable: bool = False


@dataclass(frozen=True)
class Pointer:
    """An argument that is the address of a buffer, or of a place inside it."""

    buffer: int
    offset: int = 0


@dataclass(frozen=True)
class Call:
    """A call of the function at an address. With `traced`, its instructions and memory accesses are watched.

    `kept` is the buffer whose bytes after the call are answered.
    """

    address: int
    arguments: tuple[int | Pointer, ...]
    traced: bool = False
    kept: int | None = None


@dataclass(frozen=True)
class Job:
    """An image, its memory and the calls to make, in order.

    `architecture` and `model` are those of the target, `big_endian` its order of bytes. `segments` are (address,
    bytes, size). `fpu` switches a float unit on, `global_pointer` is for RISC-V. With `flush`, the FPU takes
    subnormal numbers for zero. Traced calls end when `instructions` have been executed, but not before `least` of
    them were made; one that takes more than `longest` instructions counts as one that does not return.
    """

    architecture: str
    model: str
    big_endian: bool
    segments: tuple[tuple[int, bytes, int], ...]
    buffers: tuple[Buffer, ...]
    calls: tuple[Call, ...]
    fpu: bool = False
    global_pointer: int | None = None
    flush: bool = False
    instructions: int = 1 << 62
    least: int = 0
    longest: int = LONGEST


@dataclass(frozen=True)
class Fault:
    """What stopped a call: `unaligned`, `out of bounds`, `instruction` or `exception`; where, and what it did."""

    kind: str
    pc: int
    what: str
    call: int


@dataclass(frozen=True)
class Ran:
    """The answer: every buffer at the end, what was kept of each call, the executed addresses of each traced one.

    `stack` is the largest number of bytes below the stack pointer at entry that were written or reserved.
    """

    buffers: tuple[bytes, ...]
    kept: tuple[bytes, ...]
    traces: tuple[bytes, ...]
    stack: int
    fault: Fault | None = field(default=None)
