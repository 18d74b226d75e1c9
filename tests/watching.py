"""The bit-true model of the sums of products, watched: what every value and every partial sum reaches."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import reduce
from operator import mul
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from qcone import vectors as drawing
from qcone import verify
from qcone.backends.bittrue import Model, State
from qcone.bundle import Bundle
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Mac
from qcone.ir.statement import Operation, Program, Routine
from qcone.vectors import Vectors

Array = NDArray[Any]


@dataclass
class Seen:
    """The largest raw size of every value and of every sum of products on its way, by routine and value."""

    program: Program
    values: dict[tuple[str, int], float] = field(default_factory=dict)
    partial: dict[tuple[str, int], float] = field(default_factory=dict)

    def note(self, routine: Routine, watched: Mapping[str, Array]) -> None:
        """Take in one run. Partial sums are taken in float64: they may be beyond 2^63, which integers would hide."""
        found = {int(key.split()[1]): value for key, value in watched.items() if key.split()[0] == routine.name}
        if not found:
            return
        for operation in _operations(routine):
            key, value = (routine.name, operation.result), found[operation.result]
            self.values[key] = max(self.values.get(key, 0), float(np.abs(value).max()))
            if isinstance(operation.detail, Mac):
                largest = max(float(np.abs(each).max()) for each in _partial_sums(operation.detail, found))
                self.partial[key] = max(self.partial.get(key, 0), largest)

    def beyond(self) -> Iterator[str]:
        """Say what exceeded its proved bound, its word or its accumulator."""
        for routine in self.program.routines:
            for operation in _operations(routine):
                key = (routine.name, operation.result)
                if key not in self.values or not isinstance(operation.format, Signal):
                    continue
                raw, said = self.values[key], f"{routine.name}: value {operation.result} ({operation.op.value})"
                if operation.bound is not None and raw > operation.bound / operation.format.lsb:
                    yield f"{said}: {raw * float(operation.format.lsb)} is beyond {float(operation.bound)}"
                if raw > operation.format.most + (operation.bound is None):
                    yield f"{said}: {raw} is beyond {operation.format.name}"
                if isinstance(operation.detail, Mac) and self.partial[key] >= 2 ** (operation.detail.accumulator - 1):
                    yield f"{said}: {self.partial[key]} is beyond an accumulator of {operation.detail.accumulator}"


def _operations(routine: Routine) -> Iterator[Operation]:
    return (each for each in routine.body if isinstance(each, Operation))


def _partial_sums(mac: Mac, values: Mapping[int, Array]) -> Iterator[Array]:
    """Yield the sum after each term, in the order in which the C adds them, and with the rounding added."""
    first = next((each for each in mac.terms if not each.negative), mac.terms[0])
    total: Array = np.zeros(1)
    for term in (first, *(each for each in mac.terms if each is not first)):
        product = reduce(mul, (np.asarray(values[arg], np.float64) for arg in term.args)) * 2.0**term.shift
        yield product
        total = total - product if term.negative else total + product
        yield total
    if mac.discard:
        # What is carried from the update before is at most the rounding of one.
        yield np.abs(total) + 2.0 ** (mac.discard - 1) * (1 if mac.residual is None else 2)


def _named(program: Program) -> Program:
    """Give every value a name, so that it is watched."""
    routines = (
        replace(each, names={step.result: f"{each.name} {step.result}" for step in _operations(each)})
        for each in program.routines
    )
    return replace(program, routines=tuple(routines))


class Watched(Model):
    """The model of a design's sums of products, or of its integer operations, every value watched."""

    def __init__(self, bundle: Bundle, program: Program | None = None) -> None:
        """Give every value a name."""
        chosen = program or bundle.macs
        assert chosen is not None
        self.seen = Seen(_named(chosen))
        super().__init__(self.seen.program, bundle.facts.number)

    def run(
        self,
        name: str,
        state: State,
        inputs: Mapping[str, Array] | None = None,
        watch: dict[str, Array] | None = None,
    ) -> dict[str, Array]:
        watched: dict[str, Array] = {}
        found = super().run(name, state, inputs, watched if watch is None else watch)
        if watch is None:
            for routine in self.seen.program.routines:
                self.seen.note(routine, watched)
        return found


def watch(bundle: Bundle, vectors: Vectors) -> tuple[Seen, Seen]:
    """Run both levels of the model, which must agree; return what sums of products and integer operations reached."""
    assert bundle.macs is not None
    models = [Watched(bundle, program) for program in (bundle.macs, bundle.machine)]

    def model(program: Program, number: Fixed) -> Model:
        return models[0] if program is bundle.macs else models[1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(verify, "Model", model)
        verify.model_words(bundle, vectors)
    return models[0].seen, models[1].seen


def drawn(bundle: Bundle, rows: int, seed: int = 1, lanes: int = 2000) -> Vectors:
    """Return rows of vectors in so many lanes: wide arrays are quickly run."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(drawing, "LANES", lanes)
        return drawing.draw(bundle, rows, seed)
