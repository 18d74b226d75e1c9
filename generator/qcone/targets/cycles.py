"""Cycles of a trace on the Cortex-M cores whose timing is published, as a range with its assumptions.

ARM's Technical Reference Manuals of the Cortex-M0, M0+, M3 and M4 give the table. Memory has no wait states, which on
real parts dominates; the M3 and M4 are given as a range because how long a branch refills the pipeline, and whether
a load overlaps the one before, depends on what surrounds it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from qcone.targets.code import Disassembler, Instruction

Range = tuple[int, int]
_BRANCH = re.compile(r"(?:b|bl|bx|blx|cbn?z|tb[bh])(?:eq|ne|[hl][sioe]|cs|cc|mi|pl|v[sc]|g[et]|l[et]|al)?(?:\.[wn])?")
_LOAD = re.compile(r"ldrs?[bh]?(?:\.w)?(?:[a-z]{2})?(?:\.w)?")
_STORE = re.compile(r"str[bh]?(?:\.w)?(?:[a-z]{2})?(?:\.w)?")
_SEVERAL = re.compile(r"(?:push|pop|ldm|stm|vpush|vpop|vldm|vstm)\w*(?:\.w)?")
_FLOAT_RESULT = re.compile(r"v(?:n?mul|add|sub|n?ml[as]|fn?m[as]|div|sqrt|neg|abs|cvt\w*)(?:\w\w)?\.f32\S*")
_IT_BLOCK = 4
"""Instructions that one IT makes conditional, at most."""


@dataclass(frozen=True)
class Model:
    """The table of one core: (fewest, most) cycles of an instruction, and what a taken branch adds."""

    assumptions: str
    cost: Callable[[Instruction], Range]
    taken: Callable[[Instruction], Range]
    interlock: bool = False


def _registers(instruction: Instruction) -> int:
    inside = instruction.operands.partition("{")[2].partition("}")[0]
    names = [each.strip() for each in inside.split(",") if each.strip()]
    return sum(2 if each.startswith("d") else 1 for each in names)


def _small(instruction: Instruction) -> Range:
    """Return the cycles of an ARMv6-M instruction. The multiplier takes 1 cycle or 32, as the part's maker chose."""
    name = instruction.mnemonic
    if _SEVERAL.fullmatch(name):
        return (1 + _registers(instruction),) * 2
    if _LOAD.fullmatch(name) or _STORE.fullmatch(name):
        return 2, 2
    if name.startswith("mul"):
        return 1, 32
    return (3, 3) if name in ("mrs", "msr", "dmb", "dsb", "isb") else (1, 1)


def _large(long_product: Range, long_sum: Range, product_sum: int) -> Callable[[Instruction], Range]:
    """Return the table of an ARMv7-M core, given its 64-bit products, sums of them, and 32-bit sums of products."""

    def cost(instruction: Instruction) -> Range:
        name = instruction.mnemonic
        if _SEVERAL.fullmatch(name):
            return (1 + _registers(instruction),) * 2
        if name.startswith(("ldrd", "strd")):
            return 2, 3
        if _LOAD.fullmatch(name) or _STORE.fullmatch(name):
            return 1, 2
        if name.startswith(("vldr", "vstr")):
            return (2, 3) if instruction.operands.startswith("d") else (1, 2)
        if name.startswith(("umull", "smull")):
            return long_product
        if name.startswith(("umlal", "smlal", "umaal")):
            return long_sum
        if name.startswith(("mla", "mls")):
            return product_sum, product_sum
        if name.startswith(("udiv", "sdiv")):
            return 2, 12
        if name.startswith(("vdiv", "vsqrt")):
            return 14, 14
        if re.match(r"v(?:n?ml[as]|fn?m[as])", name):
            return 3, 3
        return 1, 1

    return cost


def _refill(short: int, call: int, returning: int) -> Callable[[Instruction], Range]:
    def taken(instruction: Instruction) -> Range:
        extra = call if instruction.mnemonic == "bl" else returning if instruction.mnemonic == "pop" else short
        return extra, extra

    return taken


def _pipeline(instruction: Instruction) -> Range:
    return 1, 3


_NO_WAIT = "memory without wait states"
_RANGE = "a taken branch 2 to 4 cycles, a load or store 1 to 2"
MODELS: Mapping[str, Model] = {
    "cortex-m0": Model(f"{_NO_WAIT}; multiplier of 1 cycle (low) or 32 (high)", _small, _refill(2, 3, 3)),
    "cortex-m0plus": Model(f"{_NO_WAIT}; multiplier of 1 cycle (low) or 32 (high)", _small, _refill(1, 2, 2)),
    "cortex-m3": Model(f"{_NO_WAIT}; {_RANGE}, a 64-bit product 3 to 5", _large((3, 5), (4, 7), 2), _pipeline),
    "cortex-m4": Model(f"{_NO_WAIT}; {_RANGE}", _large((1, 1), (1, 1), 1), _pipeline, interlock=True),
}


def cycles(model: Model, code: Disassembler, trace: NDArray[np.uint32]) -> Range:
    """Return the fewest and most cycles of the instructions executed at the addresses of a trace, in order."""
    pairs = (trace[:-1].astype(np.uint64) << np.uint64(32)) | trace[1:]
    distinct, times = np.unique(pairs, return_counts=True)
    low, high = model.cost(code.at(int(trace[-1])))
    extra = model.taken(code.at(int(trace[-1])))  # the return to the caller
    low, high = low + extra[0], high + extra[1]
    for pair, count in zip(distinct.tolist(), times.tolist(), strict=True):
        least, most = _step(model, code, code.at(pair >> 32), code.at(pair & 0xFFFF_FFFF))
        low, high = low + count * least, high + count * most
    return low, high


def _step(model: Model, code: Disassembler, this: Instruction, following: Instruction) -> Range:
    """Return the cycles from one executed instruction to the next."""
    low, high = model.cost(this)
    skipped = _skipped(code, this, following)
    if following.address != this.fall_through and not skipped:
        extra = model.taken(this)
        return low + extra[0], high + extra[1]
    if model.interlock and _FLOAT_RESULT.fullmatch(this.mnemonic):
        result, *_ = (each.strip() for each in this.operands.split(","))
        used = [each.strip() for each in following.operands.split(",")]
        waits = int(result in (used if following.mnemonic.startswith("vstr") else used[1:]))
        low, high = low + waits, high + waits
    return low + skipped, high + skipped


def _skipped(code: Disassembler, this: Instruction, following: Instruction) -> int:
    """Return how many instructions an IT block passed over: each costs a cycle and leaves no trace."""
    if _BRANCH.fullmatch(this.mnemonic) or "pc" in this.operands:
        return 0
    at, passed = this.fall_through, 0
    while at < following.address and passed < _IT_BLOCK:
        at, passed = code.at(at).fall_through, passed + 1
    return passed if at == following.address else 0
