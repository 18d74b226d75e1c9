"""The bit-true model: a machine routine run by NumPy, operation by operation, in the format's own type.

Every value is an array over independent lanes. NumPy's +, -, * and / on float32 and float64 arrays are the
correctly rounded operations of IEEE 754, so this is the routine, bit for bit, and not an approximation of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends import bittrue_fixed
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.machine import MachineOp
from qcone.ir.statement import (
    Advance,
    Call,
    Choose,
    Loop,
    Operation,
    Program,
    Ready,
    Role,
    Routine,
    Statement,
    Write,
)

Array = NDArray[Any]
State = dict[str, Array]
"""Component arrays by block name, shape (components, lanes)."""

DTYPES: Mapping[str, Any] = {
    "float32": np.float32,
    "float64": np.float64,
    "fixed32": np.int64,
    "fixed16": np.int64,
}
"""Fixed point is run in 64 bits: every word and every sum was shown to fit."""
COUNTER = np.int32
ARITHMETIC: Mapping[object, Callable[..., Array]] = {
    MachineOp.ADD: np.add,
    MachineOp.SUBTRACT: np.subtract,
    MachineOp.MULTIPLY: np.multiply,
    MachineOp.DIVIDE: np.divide,
    MachineOp.NEGATE: np.negative,
    MachineOp.LESS: np.less,
    MachineOp.SELECT: np.where,
    MachineOp.NARROW: np.positive,
}


def dtype_of(number: Floating | Fixed) -> Any:
    """Return the NumPy type of a format."""
    return DTYPES[number.name]


def new_state(program: Program, number: Floating | Fixed, lanes: int) -> State:
    """Return the state of `lanes` independent runs, all zero; `init` or `set_quaternion` must follow."""
    return {
        block.name: np.zeros((block.size, lanes), COUNTER if block.integer else dtype_of(number))
        for block in program.state
    }


@dataclass(frozen=True)
class Kind:
    """How a routine's numbers are held: their NumPy type, whether they are raw words, and whether those wrap around."""

    dtype: Any
    fixed: bool
    wraps: bool


class Model:
    """The routines of one program, to be run on arrays.

    `run(name, state, inputs)` runs a routine on state and input arrays of shape (components, lanes),
    changes the state in place and returns the output blocks. With `watch`, the named values too.
    """

    def __init__(self, program: Program, number: Floating | Fixed) -> None:
        """Prepare the program's routines."""
        self.program, self.number = program, number
        self._kind = Kind(dtype_of(number), isinstance(number, Fixed), isinstance(number, Fixed) and number.wraps)

    def run(
        self,
        name: str,
        state: State,
        inputs: Mapping[str, Array] | None = None,
        watch: dict[str, Array] | None = None,
    ) -> dict[str, Array]:
        """Run one routine; see the class."""
        routine = self.program.routine(name)
        lanes = next(iter(state.values())).shape[1]
        first = routine.body[0] if routine.body else None
        if isinstance(first, Choose):
            self._choose(first, state, inputs or {}, watch)
            return {}
        return _run(routine, state, inputs or {}, lanes, self._kind, watch)

    def _choose(
        self, choice: Choose, state: State, inputs: Mapping[str, Array], watch: dict[str, Array] | None
    ) -> None:
        """Run, for each lane, the routine its counter chooses."""
        counter = state[choice.place.block][choice.place.index.constant]
        left = np.ones(counter.shape, bool)
        for limit, name in (*choice.cases, (None, choice.otherwise)):
            chosen = left if limit is None else left & (counter < limit)
            left = left & ~chosen
            if chosen.all():
                self.run(name, state, inputs, watch)
                return
            if chosen.any():
                part = {block: array[:, chosen] for block, array in state.items()}
                self.run(name, part, {block: array[:, chosen] for block, array in inputs.items()}, watch)
                for block, array in part.items():
                    state[block][:, chosen] = array


def _run(
    routine: Routine,
    state: State,
    inputs: Mapping[str, Array],
    lanes: int,
    kind: Kind,
    watch: dict[str, Array] | None,
) -> dict[str, Array]:
    memory: dict[str, Array] = {}
    for block in routine.blocks:
        if block.role is Role.STATE:
            memory[block.name] = state[block.name]
        elif block.role is Role.INPUT:
            given = inputs[block.name]
            memory[block.name] = given.astype(np.int64) if kind.fixed else given
        elif block.role is Role.TABLE:
            memory[block.name] = np.array([[kind.dtype(entry)] for entry in map(float, block.entries)], kind.dtype)
        else:
            memory[block.name] = np.zeros((block.size, lanes), kind.dtype)
    values: dict[int, Any] = {}
    _body(routine.body, routine, memory, values, {}, kind, lanes)
    if watch is not None:
        watch.update({routine.names[key]: value for key, value in values.items() if key in routine.names})
    return {block.name: memory[block.name] for block in routine.having(Role.OUTPUT)}


def _body(
    body: Sequence[Statement],
    routine: Routine,
    memory: dict[str, Array],
    values: dict[int, Any],
    counters: dict[str, int],
    kind: Kind,
    lanes: int,
) -> None:
    kept: list[tuple[str, int, Array]] = []
    for statement in body:
        match statement:
            case Operation(result, op, args, constant, place):
                if kind.fixed and op in bittrue_fixed.OPERATIONS:
                    values[result] = bittrue_fixed.run(statement, values, memory, kept, kind.wraps)
                elif op in ARITHMETIC:
                    values[result] = ARITHMETIC[op](*[values[arg] for arg in args])
                elif constant is not None:
                    values[result] = bittrue_fixed.raw(statement) if kind.fixed else kind.dtype(float(constant))
                elif place is not None:
                    array = memory[place.block][place.index.at(counters)]
                    values[result] = array.copy() if routine.block(place.block).role is not Role.INPUT else array
            case Write(place, value):
                memory[place.block][place.index.at(counters)] = values[value]
            case Loop(counter, _, _, inner):
                for turn in statement.turns(counters):
                    _body(inner, routine, memory, values, counters | {counter: turn}, kind, lanes)
            case Call():
                _call(statement, routine, values, kind, lanes)
            case Advance(place):
                memory[place.block][place.index.at(counters)] += COUNTER(1)
            case Choose() | Ready():
                raise AssertionError("a choice stands alone in its routine")
    for name, component, left in kept:
        memory[name][component] = left


def _call(call: Call, routine: Routine, values: dict[int, Any], kind: Kind, lanes: int) -> None:
    callee = routine.callees[call.routine]
    given = [np.broadcast_to(values[arg], (lanes,)) for arg in call.args]
    inputs: dict[str, Array] = {}
    for block in callee.having(Role.INPUT):
        inputs[block.name], given = np.array(given[: block.size]), given[block.size :]
    outputs = _run(callee, {}, inputs, lanes, kind, None)
    flat = [row for block in callee.having(Role.OUTPUT) for row in outputs[block.name]]
    values.update(zip(call.results, flat, strict=True))
