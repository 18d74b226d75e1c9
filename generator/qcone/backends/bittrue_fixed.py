"""The bit-true model of fixed point: raw words as 64-bit integers, `mac` and what it expands to side by side.

No sum is anywhere near 2^63: that was proved when the formats were chosen, so NumPy's integers, which wrap silently,
hold every word exactly. NumPy shifts negative integers right arithmetically, which is floor(x / 2^n).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.formats.fixed import Signal
from qcone.ir.detail import Limits, Mac, Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation

Array = NDArray[Any]
Kept = list[tuple[str, int, Array]]
"""What is to be written when the routine ends: block, component, word."""
OPERATIONS = frozenset(
    {
        MachineOp.MAC,
        MachineOp.CLAMP,
        MachineOp.SHIFT_LEFT,
        MachineOp.SHIFT_RIGHT,
        MachineOp.DIVIDE,
        MachineOp.LOW,
        MachineOp.NARROW,
        MachineOp.REMAINDER,
        MachineOp.MULTIPLY,
        MachineOp.ADD,
        MachineOp.SUBTRACT,
        MachineOp.NEGATE,
    }
)


def raw(operation: Operation) -> Any:
    """Return a constant's raw word."""
    assert isinstance(operation.format, Signal)
    assert operation.constant is not None
    return np.int64(operation.format.raw(operation.constant))


def run(operation: Operation, values: Mapping[int, Any], memory: Mapping[str, Array], kept: Kept, wraps: bool) -> Any:
    """Run one operation on raw words; with `wraps`, what does not fit a word is dropped."""
    if not wraps:
        return _run(operation, values, memory, kept, lambda value, width: value)
    assert isinstance(operation.format, Signal)
    return word(_run(operation, values, memory, kept, word), operation.format.width)


def word(value: Any, width: int) -> Any:
    """Return the word of `width` bits that has the last bits of a value."""
    unused = np.int64(64 - width)
    return (value << unused) >> unused


def _run(
    operation: Operation, values: Mapping[int, Any], memory: Mapping[str, Array], kept: Kept, fit: Callable[..., Any]
) -> Any:
    detail = operation.detail
    args = [values[arg] for arg in operation.args]
    match operation.op:
        case MachineOp.MAC if isinstance(detail, Mac):
            return _mac(detail, values, memory, kept, fit)
        case MachineOp.ADD:
            return args[0] + args[1]
        case MachineOp.SUBTRACT:
            return args[0] - args[1]
        case MachineOp.MULTIPLY:
            return args[0] * args[1]
        case MachineOp.NEGATE:
            return -args[0]
        case MachineOp.LOW if isinstance(detail, Shift):
            return word(args[0], detail.bits)
        case MachineOp.NARROW:
            return args[0]
        case MachineOp.CLAMP if isinstance(detail, Limits):
            return np.clip(args[0], np.int64(int(detail.low)), np.int64(int(detail.high)))
        case MachineOp.REMAINDER if isinstance(detail, Shift):
            return args[0] - args[1] * np.int64(1 << detail.bits)
        case MachineOp.SHIFT_LEFT if isinstance(detail, Shift):
            return args[0] * np.int64(1 << detail.bits)
        case MachineOp.SHIFT_RIGHT if isinstance(detail, Shift):
            return rounded(args[0], detail.bits, detail.rounding, fit, detail.width)
        case MachineOp.DIVIDE:
            top = args[0] * np.int64(1 << detail.bits) if isinstance(detail, Shift) else args[0]
            size = np.abs(top) // np.abs(args[1])
            return np.where((top < 0) != (args[1] < 0), -size, size)
    raise AssertionError(operation.op)


def rounded(
    x: Any, bits: int, rounding: str, fit: Callable[..., Any] = lambda value, width: value, width: int = 64
) -> Any:
    """Return x / 2^bits, rounded up at halves, to even at halves, or down; `fit` brings a sum into its word."""
    if not bits:
        return x
    if rounding == "floor":
        return x >> np.int64(bits)
    half = fit(x + np.int64(1 << (bits - 1)), width)
    up = half >> np.int64(bits)
    if rounding == "even":
        tie = (half & np.int64((1 << bits) - 1)) == 0
        return np.where(tie, up - (up & np.int64(1)), up)
    return up


def _mac(mac: Mac, values: Mapping[int, Any], memory: Mapping[str, Array], kept: Kept, fit: Callable[..., Any]) -> Any:
    total: Any = np.int64(0)
    for term in mac.terms:
        value = values[term.args[0]]
        if len(term.args) == 2:
            value = value * values[term.args[1]]
        value = value * np.int64(1 << term.shift)
        total = total - value if term.negative else total + value
    if mac.residual is not None:
        name, index = mac.residual
        total = total + memory[name][index.constant]
    total = fit(total, mac.accumulator)
    result = rounded(total, mac.discard, mac.rounding, fit, mac.accumulator)
    if mac.residual is not None:
        left = fit(total - result * np.int64(1 << mac.discard), mac.accumulator)
        kept.append((mac.residual[0], mac.residual[1].constant, left))
    if mac.limits is not None:
        low, high = map(np.int64, mac.limits)
        result = np.clip(result, low, high)
    return result
