"""What the traces of a routine say: instructions, products and sums executed, library routines entered, cycles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from qcone.targets.code import Disassembler
from qcone.targets.cycles import MODELS, cycles
from qcone.targets.gates import emitted_functions
from qcone.targets.library import adds, multiplies, multiplies_integers, public_name
from qcone.targets.machines import Target

Trace = NDArray[np.uint32]


@dataclass(frozen=True)
class Executed:
    """Over all traces, the fewest and most; `routines` are library routines entered from the design's own code.

    `multiply` and `add` count float products and sums alike, in instructions or in calls. `whole` counts products of
    two integers with their upper half, `lower` those without. `functions` are the names of the design's functions that
    ran, `cycles` is None where no honest table exists.
    """

    updates: int
    instructions: tuple[int, int]
    multiply: tuple[int, int]
    add: tuple[int, int]
    cycles: tuple[int, int] | None
    routines: tuple[str, ...]
    functions: tuple[str, ...]
    fused: tuple[str, ...]
    whole: tuple[int, int] = (0, 0)
    lower: tuple[int, int] = (0, 0)


def executed(code: Disassembler, names: frozenset[str], target: Target, traces: Sequence[bytes]) -> Executed:
    """Read the traces of updates of a design, whose functions have these names. ValueError when there are none."""
    # Where no instruction depends on data, all traces are one.
    arrays = [np.frombuffer(each, np.uint32) for each in dict.fromkeys(traces)]
    own = emitted_functions(code.image, names)
    inside = _Inside(code, [(each.address, each.address + each.size) for each in own])
    counts = [inside.count(each) for each in arrays]
    model = MODELS[target.cycles] if target.cycles else None
    ranges = [cycles(model, code, each) for each in arrays] if model else []
    met = np.unique(np.concatenate(arrays))
    functions = [each.name for each in own if ((met >= each.address) & (met < each.address + each.size)).any()]
    fused = sorted({code.at(int(each)).mnemonic for each in met[inside.mask(met)] if inside.is_fused(int(each))})
    return Executed(
        len(traces),
        _range([len(each) for each in arrays]),
        _range([each.multiply for each in counts]),
        _range([each.add for each in counts]),
        (min(low for low, _ in ranges), max(high for _, high in ranges)) if ranges else None,
        tuple(sorted({name for each in counts for name in each.routines})),
        tuple(dict.fromkeys(functions)),
        tuple(fused),
        _range([each.whole for each in counts]),
        _range([each.lower for each in counts]),
    )


def _range(values: Sequence[int]) -> tuple[int, int]:
    return min(values), max(values)


@dataclass(frozen=True)
class _Counted:
    multiply: int
    add: int
    routines: frozenset[str]
    whole: int
    lower: int


class _Inside:
    """Tells a design's own instructions from those of a library, and counts them."""

    def __init__(self, code: Disassembler, ranges: Sequence[tuple[int, int]]) -> None:
        self._code, self._ranges = code, ranges

    def mask(self, trace: Trace) -> NDArray[np.bool_]:
        found = np.zeros(trace.shape, bool)
        for low, high in self._ranges:
            found |= (trace >= low) & (trace < high)
        return found

    def is_fused(self, address: int) -> bool:
        computed = self._code.arithmetic(self._code.at(address))
        return computed is not None and computed.fused

    def count(self, trace: Trace) -> _Counted:
        own = self.mask(trace)
        multiply = add = 0
        words = {64: 0, 32: 0}
        for address, times in zip(*(each.tolist() for each in np.unique(trace[own], return_counts=True)), strict=True):
            instruction = self._code.at(address)
            bits = self._code.product(instruction)
            if bits:
                words[bits] += times
            computed = self._code.arithmetic(instruction)
            if computed:
                multiply, add = multiply + times * computed.multiply, add + times * computed.add
        entered = trace[1:][own[:-1] & ~own[1:]]
        routines = set()
        for address, times in zip(*(each.tolist() for each in np.unique(entered, return_counts=True)), strict=True):
            routine = public_name(self._code.image.names_at(address))
            routines.add(routine)
            multiply, add = multiply + times * multiplies(routine), add + times * adds(routine)
            words[64] += times * multiplies_integers(routine)
        return _Counted(multiply, add, frozenset(routines), words[64], words[32])
