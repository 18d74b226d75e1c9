"""The emulator: makes the calls of a job under unicorn, in a process of its own, which may crash.

Accesses of traced calls are watched one by one: guard pages see only what leaves a page, and the models do not
refuse every unaligned access that a real core does.
"""

from __future__ import annotations

import pickle
import sys
from array import array
from typing import Any

from qcone.errors import MissingToolError
from qcone.targets.job import Call, Fault, Job, Pointer, Ran
from qcone.targets.registers import library, processor

PAGE = 0x1000
STACK_TOP, STACK_SIZE = 0x7800_0000, 0x4_0000
BUFFERS = 0x2000_0000
"""Above every image, with room for all the buffers a job may have below the stack."""
RETURN = 0x7C00_0000

_DATA_ABORT = 4
_IT_STATE = 0x0600_FC00


class Emulator:
    """One emulated processor with an image and its buffers in memory. Every buffer ends where a page does."""

    def __init__(self, job: Job) -> None:
        """Make the processor, load the image, lay out buffers and stack, with nothing mapped around them."""
        self.job = job
        self.uc, self._convention = processor(job)
        self._unicorn = unicorn = library()
        self._read_write = unicorn.UC_PROT_READ | unicorn.UC_PROT_WRITE
        self._load()
        self._places = self._lay_out()
        self.uc.mem_map(STACK_TOP - STACK_SIZE, STACK_SIZE, self._read_write)
        self.uc.mem_map(RETURN, PAGE)
        self.uc.hook_add(unicorn.UC_HOOK_MEM_INVALID, self._on_invalid)
        if job.architecture == "arm":
            self.uc.hook_add(unicorn.UC_HOOK_INTR, self._on_exception)
        self._readable = [(address, address + size) for address, _, size in job.segments] + self._places
        self._writable: list[tuple[int, int]] = []
        self._trace = array("I")
        self._fault: Fault | None = None
        self._entry = self._lowest = self._owned = STACK_TOP
        self._stack = 0
        self._call = 0
        self._watched = False

    def run(self) -> Ran:
        """Make the calls in order; stop at the first fault."""
        kept: list[bytes] = []
        traces: list[bytes] = []
        executed = 0
        for number, call in enumerate(self.job.calls):
            self._call = number
            if call.traced and executed >= self.job.instructions and len(traces) >= self.job.least:
                break
            self._make(call)
            if self._fault:
                break
            if call.traced:
                traces.append(self._trace.tobytes())
                executed += len(self._trace)
            if call.kept is not None:
                kept.append(self._bytes(call.kept))
        buffers = tuple(map(self._bytes, range(len(self._places))))
        return Ran(buffers, tuple(kept), tuple(traces), self._stack, self._fault)

    def _load(self) -> None:
        pages: set[int] = set()
        for address, _, size in self.job.segments:
            pages |= set(range(address // PAGE, (address + size - 1) // PAGE + 1))
        for page in sorted(pages):
            self.uc.mem_map(page * PAGE, PAGE)
        for address, data, _ in self.job.segments:
            self.uc.mem_write(address, data)

    def _lay_out(self) -> list[tuple[int, int]]:
        places, at = [], BUFFERS
        for each in self.job.buffers:
            size = -(-len(each.data) // 8) * 8  # an element may need its alignment
            length = max(PAGE, -(-size // PAGE) * PAGE)
            self.uc.mem_map(at, length, self._read_write)
            start = at + length - size
            self.uc.mem_write(start, each.data)
            if not each.writable:
                self.uc.mem_protect(at, length, self._unicorn.UC_PROT_READ)
            places.append((start, start + len(each.data)))
            at += length + PAGE
        return places

    def _bytes(self, buffer: int) -> bytes:
        start, end = self._places[buffer]
        return bytes(self.uc.mem_read(start, end - start))

    def _make(self, call: Call) -> None:
        """Make one call and wait until it returns."""
        if call.traced and not self._watched:
            self._watch()
        self._trace = array("I")
        self._enter(call)
        start = call.address | 1 if self.job.architecture == "arm" else call.address
        try:
            self.uc.emu_start(start, RETURN)
        except self._unicorn.UcError as error:
            self._fail("instruction", self._pc(), str(error).partition(" (")[0].lower())
        if self._fault is None and self._pc() != RETURN:
            self._fail("instruction", self._pc(), "the call did not return")
        if call.traced:
            self._stack = max(self._stack, self._entry - self._lowest)

    def _watch(self) -> None:
        unicorn = self._unicorn
        self.uc.ctl_flush_tb()  # blocks translated before know no hooks
        self.uc.hook_add(unicorn.UC_HOOK_CODE, self._on_code)
        self.uc.hook_add(unicorn.UC_HOOK_MEM_READ, self._on_read)
        self.uc.hook_add(unicorn.UC_HOOK_MEM_WRITE, self._on_write)
        self._watched = True

    def _enter(self, call: Call) -> None:
        """Put the arguments where the callee looks for them: registers, then the stack."""
        given = [self._places[a.buffer][0] + a.offset if isinstance(a, Pointer) else a for a in call.arguments]
        pointed = {each.buffer for each in call.arguments if isinstance(each, Pointer)}
        self._writable = [self._places[each] for each in sorted(pointed) if self.job.buffers[each].writable]
        registers = self._convention.arguments
        stacked = given[len(registers) :]
        self._entry = self._lowest = (STACK_TOP - 64 - 4 * len(stacked)) // 16 * 16
        for register, value in zip(registers, given, strict=False):
            self.uc.reg_write(register, value)
        order: Any = "big" if self.job.big_endian else "little"
        above = self._entry + self._convention.linkage
        self.uc.mem_write(above, b"".join(each.to_bytes(4, order) for each in stacked))
        self._owned = above + 4 * len(stacked)
        self.uc.reg_write(self._convention.sp, self._entry)
        self.uc.reg_write(self._convention.back, RETURN | 1 if self.job.architecture == "arm" else RETURN)

    def _pc(self) -> int:
        return int(self.uc.reg_read(self._convention.pc))

    def _on_code(self, uc: Any, address: int, size: int, data: object) -> None:
        self._trace.append(address)
        if not self._stack:  # what is reserved and never written shows in the pointer alone
            self._lowest = min(self._lowest, int(uc.reg_read(self._convention.sp)))
        if len(self._trace) > self.job.longest:
            self._fail("instruction", address, f"the call did not return within {self.job.longest} instructions")

    def _leave_block(self) -> None:
        """Clear the state of an IT block, which unicorn (2.1.4) leaves behind after a watched access inside one.

        The block's own instructions are translated already; the next ones would be taken for conditional.
        """
        status = self._convention.block_status
        if status is not None and (held := int(self.uc.reg_read(status))) & _IT_STATE:
            self.uc.reg_write(status, held & ~_IT_STATE)

    def _on_read(self, uc: Any, access: int, address: int, size: int, value: int, data: object) -> None:
        self._leave_block()
        self._check("read", address, size, self._readable, STACK_TOP)

    def _on_write(self, uc: Any, access: int, address: int, size: int, value: int, data: object) -> None:
        self._leave_block()
        if STACK_TOP - STACK_SIZE <= address < self._lowest:
            self._lowest = address
        self._check("write", address, size, self._writable, self._owned)

    def _check(self, verb: str, address: int, size: int, allowed: list[tuple[int, int]], stack: int) -> None:
        if address % min(size, 4):
            self._fail("unaligned", self._trace[-1], f"{verb} of {size} bytes at {self._described(address)}")
        elif not (STACK_TOP - STACK_SIZE <= address <= stack - size) and not any(
            low <= address <= high - size for low, high in allowed
        ):
            self._fail("out of bounds", self._trace[-1], f"{verb} of {size} bytes at {self._described(address)}")

    def _on_invalid(self, uc: Any, access: int, address: int, size: int, value: int, data: object) -> bool:
        unicorn, where = self._unicorn, self._described(address)
        if access in (unicorn.UC_MEM_FETCH_UNMAPPED, unicorn.UC_MEM_FETCH_PROT):
            self._fail("instruction", self._pc(), f"it went to {where}, where there is no code")
        else:
            verb = "write" if access in (unicorn.UC_MEM_WRITE_UNMAPPED, unicorn.UC_MEM_WRITE_PROT) else "read"
            self._fail("out of bounds", self._pc(), f"{verb} of {size} bytes at {where}")
        return False

    def _on_exception(self, uc: Any, number: int, data: object) -> None:
        if number == _DATA_ABORT:  # unmapped memory is told before; what is left is alignment
            self._fail("unaligned", self._pc(), "a load or store of a word that the core refuses")
        else:
            self._fail("instruction", self._pc(), f"exception {number}")

    def _fail(self, kind: str, pc: int, what: str) -> None:
        if self._fault is None:
            self._fault = Fault(kind, pc, what, self._call)
        self.uc.emu_stop()

    def _described(self, address: int) -> str:
        """Return an address by the buffer it lies in or beside."""
        for number, (start, end) in enumerate(self._places):
            if start - PAGE // 2 <= address < end + PAGE // 2:
                return f"byte {address - start} of {self.job.buffers[number].name}, which has {end - start}"
        return f"address 0x{address:08x}"


def serve() -> None:
    """Answer jobs from standard input, pickled, on standard output, until the input ends."""
    given, answers = sys.stdin.buffer, sys.stdout.buffer
    while True:
        try:
            job = pickle.load(given)
        except EOFError:
            return
        try:
            answer: object = Emulator(job).run()
        except MissingToolError as error:
            answer = error
        except Exception as error:  # the parent says it
            answer = f"{type(error).__name__}: {error}"
        answers.write(pickle.dumps(answer))
        answers.flush()
