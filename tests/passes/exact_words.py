"""Fixed-point routines run on Python's integers, which never overflow: every word and every sum is looked at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from qcone.formats.fixed import Signal
from qcone.ir.detail import Limits, Mac, Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Call, Operation, Role, Routine, Write

Memory = dict[str, list[int]]


class TooLargeError(AssertionError):
    """A word or a sum does not fit."""


def rounded(x: int, bits: int, rounding: str) -> int:
    """Return x / 2^bits, by the definition of each rounding."""
    exact = Fraction(x, 1 << bits)
    if rounding == "up":
        return (exact + Fraction(1, 2)).__floor__()
    return round(exact) if rounding == "even" else exact.__floor__()


def fitting(x: int, width: int, what: object) -> int:
    """Return x; raise TooLargeError when it is no word of that width."""
    if not -(1 << (width - 1)) <= x < 1 << (width - 1):
        raise TooLargeError(f"{x} is no word of {width} bits: {what}")
    return x


def run(routine: Routine, given: Mapping[str, Sequence[int]]) -> tuple[dict[int, int], Memory]:
    """Run a routine of sums of products, or of integer operations; return every value and what is written.

    Raises TooLargeError where a word, a product or a sum on its way does not fit.
    """
    memory: Memory = {block.name: list(given.get(block.name, [0] * block.size)) for block in routine.blocks}
    values: dict[int, int] = {}
    kept: list[tuple[str, int, int]] = []
    for statement in routine.body:
        if isinstance(statement, Operation):
            values[statement.result] = _operation(statement, values, memory, kept)
        elif isinstance(statement, Call):
            values.update(_call(routine.callees[statement.routine], statement, values))
        elif isinstance(statement, Write):
            block, at = statement.place.block, statement.place.index.constant
            if routine.block(block).role is Role.STATE:
                kept.append((block, at, values[statement.value]))
            else:
                memory[block][at] = values[statement.value]
    for block, at, word in kept:
        memory[block][at] = word
    return values, memory


def _call(callee: Routine, call: Call, values: Mapping[int, int]) -> dict[int, int]:
    left = [values[arg] for arg in call.args]
    given: dict[str, list[int]] = {}
    for block in callee.having(Role.INPUT):
        given[block.name], left = left[: block.size], left[block.size :]
    _, memory = run(callee, given)
    results = [word for block in callee.having(Role.OUTPUT) for word in memory[block.name]]
    return dict(zip(call.results, results, strict=True))


def _operation(
    operation: Operation, values: Mapping[int, int], memory: Memory, kept: list[tuple[str, int, int]]
) -> int:
    detail, signal = operation.detail, operation.format
    args = [values[arg] for arg in operation.args]
    if operation.op is MachineOp.LESS:
        return int(args[0] < args[1])
    assert isinstance(signal, Signal)
    result = _result(operation, args, values, memory, kept)
    if operation.bound is not None and abs(result) * signal.lsb > operation.bound:
        raise TooLargeError(f"{result * signal.lsb} is beyond the bound {operation.bound}: {operation}")
    del detail
    return fitting(result, signal.width, operation)


def _result(
    operation: Operation,
    args: list[int],
    values: Mapping[int, int],
    memory: Memory,
    kept: list[tuple[str, int, int]],
) -> int:
    detail = operation.detail
    match operation.op:
        case MachineOp.LITERAL:
            assert isinstance(operation.format, Signal)
            assert operation.constant is not None
            return operation.format.raw(operation.constant)
        case MachineOp.READ:
            assert operation.place is not None
            return memory[operation.place.block][operation.place.index.constant]
        case MachineOp.MAC:
            assert isinstance(detail, Mac)
            return _mac(operation, detail, values, memory, kept)
        case MachineOp.ADD:
            return args[0] + args[1]
        case MachineOp.SUBTRACT:
            return args[0] - args[1]
        case MachineOp.MULTIPLY:
            return args[0] * args[1]
        case MachineOp.NEGATE:
            return -args[0]
        case MachineOp.NARROW:
            return args[0]
        case MachineOp.SELECT:
            return args[1] if args[0] else args[2]
        case MachineOp.CLAMP:
            assert isinstance(detail, Limits)
            return min(max(args[0], int(detail.low)), int(detail.high))
    assert isinstance(detail, Shift)
    match operation.op:
        case MachineOp.REMAINDER:
            return args[0] - (args[1] << detail.bits)
        case MachineOp.LOW:
            half = 1 << (detail.bits - 1)
            return (args[0] + half) % (1 << detail.bits) - half
        case MachineOp.SHIFT_LEFT:
            return args[0] << detail.bits
        case MachineOp.SHIFT_RIGHT:
            if detail.rounding != "floor":
                fitting(args[0] + (1 << (detail.bits - 1)), detail.width, operation)
            return rounded(args[0], detail.bits, detail.rounding)
    raise AssertionError(operation.op)


def _mac(
    operation: Operation, mac: Mac, values: Mapping[int, int], memory: Memory, kept: list[tuple[str, int, int]]
) -> int:
    terms = []
    for term in mac.terms:
        product = 1 << term.shift
        for arg in term.args:
            product *= values[arg]
        terms.append(-product if term.negative else product)
    residual = 0
    if mac.residual is not None:
        name, index = mac.residual
        residual = memory[name][index.constant]
    # Every partial sum in any order, what is carried and what rounding adds included.
    half = (1 << mac.discard) >> 1
    for sign in (1, -1):
        alike = sum(abs(each) for each in (*terms, residual) if each * sign > 0)
        fitting(sign * (alike + half) if sign > 0 else -alike, mac.accumulator, operation)
    result = rounded(sum(terms) + residual, mac.discard, mac.rounding)
    if mac.residual is not None:
        kept.append((mac.residual[0], mac.residual[1].constant, sum(terms) + residual - (result << mac.discard)))
    if mac.limits is not None:
        result = min(max(result, mac.limits[0]), mac.limits[1])
    return result
