"""What a real routine means: run it on numbers of any kind, exact fractions or high-precision floats.

`Numbers` supplies the operations. The same body, over `fractions.Fraction`, proves two written forms equal;
over mpmath, it is the truth a polynomial is judged against.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from qcone.errors import UsageError
from qcone.ir.detail import Limits, Sum
from qcone.ir.operations import RealOp
from qcone.ir.statement import Advance, Call, Choose, Loop, Operation, Ready, Role, Routine, Statement, Write


@dataclass(frozen=True)
class Numbers:
    """A kind of number: how to make one of a fraction, and its root, sine and cosine where it has them."""

    of: Callable[[Fraction], Any] = lambda value: value
    square_root: Callable[[Any], Any] | None = None
    sine: Callable[[Any], Any] | None = None
    cosine: Callable[[Any], Any] | None = None
    arcsine: Callable[[Any], Any] | None = None
    arctangent_2: Callable[[Any, Any], Any] | None = None


EXACT = Numbers()
"""Rational arithmetic. A routine with a square root, a sine or a cosine cannot be run on it."""


@dataclass(frozen=True)
class Outcome:
    """The blocks a routine wrote, component by component, and every named value."""

    blocks: Mapping[str, list[Any]]
    named: Mapping[str, Any]

    def vector(self, name: str) -> tuple[Any, Any, Any]:
        """Return the components x, y, z of a named step."""
        return self.named[f"{name}_x"], self.named[f"{name}_y"], self.named[f"{name}_z"]


def evaluate(routine: Routine, inputs: Mapping[str, Sequence[Any]], numbers: Numbers = EXACT) -> Outcome:
    """Run the routine on component lists for its state and input blocks.

    Raises KeyError for a block that is not given, ArithmeticError for an operation the numbers lack, and
    UsageError for a component that is read before it is written.
    """
    memory: dict[str, list[Any]] = {}
    for block in routine.blocks:
        if block.role is Role.TABLE:
            memory[block.name] = [numbers.of(entry) for entry in block.entries]
        elif block.role in (Role.STATE, Role.INPUT):
            memory[block.name] = list(inputs[block.name])
        else:
            memory[block.name] = [None] * block.size
    values: dict[int, Any] = {}
    writes: list[tuple[str, int, Any]] = []
    _run(routine.body, routine, memory, values, {}, numbers, writes)
    for name, index, value in writes:
        memory[name][index] = value
    named = {routine.names[key]: value for key, value in values.items() if key in routine.names}
    return Outcome(memory, named)


def agree(one: Routine, other: Routine) -> bool:
    """Tell whether two routines over the same state and inputs give the same, exactly, on one set of odd fractions.

    Rational functions that differ do so almost everywhere. A routine with a root, a sine or a cosine, or one
    that hands its call on, has no exact value: it agrees with anything.
    """
    taken = [block for block in one.blocks if block.role in (Role.STATE, Role.INPUT)]
    numbers = iter(Fraction(k * k % 101 + 1, 97 + 2 * k) for k in range(1, 1 + sum(block.size for block in taken)))
    inputs = {block.name: [next(numbers) for _ in range(block.size)] for block in taken}
    try:
        first, second = evaluate(one, inputs), evaluate(other, inputs)
    except ArithmeticError:
        return True
    given = [block.name for block in one.blocks if block.role in (Role.STATE, Role.OUTPUT)]
    return all(first.blocks[name] == second.blocks[name] for name in given)


def _run(
    body: Sequence[Statement],
    routine: Routine,
    memory: dict[str, list[Any]],
    values: dict[int, Any],
    counters: dict[str, int],
    numbers: Numbers,
    writes: list[tuple[str, int, Any]],
) -> None:
    for statement in body:
        match statement:
            case Operation():
                values[statement.result] = _value(statement, memory, values, counters, numbers)
            case Write():
                index, value = statement.place.index.at(counters), values[statement.value]
                if routine.block(statement.place.block).role is Role.STATE:
                    writes.append((statement.place.block, index, value))
                else:
                    memory[statement.place.block][index] = value
            case Loop():
                for turn in statement.turns(counters):
                    _run(
                        statement.body,
                        routine,
                        memory,
                        values,
                        counters | {statement.counter: turn},
                        numbers,
                        writes,
                    )
            case Call():
                _call(statement, routine, values, numbers)
            case Advance():
                index = statement.place.index.at(counters)
                writes.append((statement.place.block, index, memory[statement.place.block][index] + 1))
            case Choose() | Ready():
                raise ArithmeticError(f"{routine.name} only hands its call on; evaluate the routine it chooses")


def _call(call: Call, routine: Routine, values: dict[int, Any], numbers: Numbers) -> None:
    callee = routine.callees[call.routine]
    arguments = [values[value] for value in call.args]
    inputs: dict[str, list[Any]] = {}
    for block in callee.having(Role.INPUT):
        inputs[block.name], arguments = arguments[: block.size], arguments[block.size :]
    outcome = evaluate(callee, inputs, numbers)
    flat = [part for block in callee.having(Role.OUTPUT) for part in outcome.blocks[block.name]]
    values.update(zip(call.results, flat, strict=True))


def _value(
    operation: Operation,
    memory: dict[str, list[Any]],
    values: dict[int, Any],
    counters: dict[str, int],
    numbers: Numbers,
) -> Any:
    args = [values[arg] for arg in operation.args]
    if isinstance(operation.detail, Sum):
        return _sum(operation.detail, values, numbers)
    match operation.op:
        case RealOp.CONSTANT:
            assert operation.constant is not None
            return numbers.of(operation.constant)
        case RealOp.READ:
            assert operation.place is not None
            found = memory[operation.place.block][operation.place.index.at(counters)]
            if found is None:
                raise UsageError(f"{operation.place} is read before it is written, at {counters or 'its first use'}")
            return found
        case RealOp.ADD | RealOp.ACCUMULATE:
            return args[0] + args[1]
        case RealOp.SUBTRACT:
            return args[0] - args[1]
        case RealOp.MULTIPLY:
            return args[0] * args[1]
        case RealOp.DIVIDE:
            return args[0] / args[1]
        case RealOp.NEGATE:
            return -args[0]
        case RealOp.LESS:
            return args[0] < args[1]
        case RealOp.SELECT:
            return args[1] if args[0] else args[2]
        case RealOp.CARRY | RealOp.WIDE:
            return args[0]
        case RealOp.CLAMP if isinstance(operation.detail, Limits):
            low, high = numbers.of(operation.detail.low), numbers.of(operation.detail.high)
            return low if args[0] < low else high if high < args[0] else args[0]
        case RealOp.ARCTANGENT_2 if numbers.arctangent_2 is not None:
            return numbers.arctangent_2(*args)
    functions: dict[object, Callable[[Any], Any] | None] = {
        RealOp.SQUARE_ROOT: numbers.square_root,
        RealOp.SINE: numbers.sine,
        RealOp.COSINE: numbers.cosine,
        RealOp.ARCSINE: numbers.arcsine,
    }
    function = functions.get(operation.op)
    if function is None:
        raise ArithmeticError(f"{operation.op.value} has no meaning in exact arithmetic")
    return function(args[0])


def _sum(detail: Sum, values: Mapping[int, Any], numbers: Numbers) -> Any:
    """Return a sum of terms, each an exact coefficient times the product of its values."""
    total = numbers.of(Fraction(0))
    for term in detail.terms:
        product = numbers.of(term.coefficient)
        for arg in term.args:
            product = product * values[arg]
        total = total + product
    return total
