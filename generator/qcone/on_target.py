"""Verify on a target: the emitted C, built for another machine, runs there and is held against the model.

First the program is inspected: nothing soft where there is hardware, no stray double, nothing fused. Then every
function is called alone with each access of memory watched. Last the batch loop runs a long chain of updates, and
every word of the state and of every output is compared.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from queue import SimpleQueue
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends.bittrue import dtype_of
from qcone.bundle import Bundle
from qcone.ir.statement import Role
from qcone.outcomes import NOT_MEASURED, Outcome, judged, named
from qcone.stepwise import argument, first_state, model_steps, packed
from qcone.targets.code import Disassembler
from qcone.targets.compiler import Compiler
from qcone.targets.cross import LEVEL, built_image
from qcone.targets.division import wrong_quotient
from qcone.targets.elf import Image
from qcone.targets.emulation import Emulation, NotMeasuredError, job_for
from qcone.targets.gates import called, defined_in, emitted_functions, findings
from qcone.targets.job import Buffer, Call, Fault, Pointer
from qcone.targets.library import divides
from qcone.targets.machines import Target
from qcone.vectors import Vectors
from qcone.verify import run_arrays

ROWS = 10_000
"""Updates of the chain, unless more are asked for."""
WATCHED, LEAST_WATCHED, INSTRUCTIONS = 24, 6, 100_000
"""Updates called one by one, every access of memory watched: fewer where they are long, past any start-up always."""
STATUS = {"fused": "contracted"}
"""What a gate is called in an outcome, where not by its own name."""


class Emulations:
    """Emulators to be lent, one to each worker at a time; made when first needed."""

    def __init__(self) -> None:
        """Begin with none."""
        self._free: SimpleQueue[Emulation] = SimpleQueue()
        self._all: list[Emulation] = []

    def __enter__(self) -> Emulations:
        """Return itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """End them all."""
        for each in self._all:
            each.close()

    @contextmanager
    def one(self) -> Iterator[Emulation]:
        """Lend one that nobody uses."""
        if self._free.empty():
            emulation = Emulation()
            self._all.append(emulation)
        else:
            emulation = self._free.get()
        try:
            yield emulation
        finally:
            self._free.put(emulation)


def verify_on(
    bundle: Bundle,
    target: Target,
    compiler: Compiler,
    vectors: Vectors,
    emulation: Emulation,
    cflags: Sequence[str] = (),
    flush: bool = False,
) -> Outcome:
    """Return the outcome of one design on one target. Raises CompileError; a crash is the outcome not-measured.

    With `flush`, the FPU takes subnormal numbers for zero, as firmware may have it do.
    """
    outcome = Outcome(bundle.name, named(compiler), LEVEL, target.name)
    image = built_image(compiler, target, bundle.sources, [f"{bundle.name}_run"], LEVEL, cflags)
    bits, code, own = float_bits(bundle), Disassembler(image), defined_in(bundle.source)
    finding = next(findings(code, own, target, bits), None)
    if finding:
        return replace(outcome, first_difference=finding.text, status=STATUS.get(finding.gate, finding.gate))
    try:
        fault = _watched(bundle, target, image, vectors, emulation, flush)
        if fault:
            return replace(outcome, first_difference=fault, status="faults")
        found = _batch(outcome, bundle, target, image, vectors, emulation, flush)
        if (
            found.status == "differs"
            and bits
            and any(map(divides, called(code, emitted_functions(image, own)).values()))
        ):
            wrong = wrong_quotient(compiler, target, bits, emulation, cflags)
            reason = f"the compiler's own division rounds subnormal quotients wrongly: {wrong}; " if wrong else ""
            found = replace(found, first_difference=f"{reason}{found.first_difference}")
        return found
    except NotMeasuredError as error:
        return replace(outcome, first_difference=str(error), status=NOT_MEASURED)


def float_bits(bundle: Bundle) -> int | None:
    """Return the bits of a design's floats; None for fixed point."""
    dtype = np.dtype(dtype_of(bundle.facts.number))
    return dtype.itemsize * 8 if dtype.kind == "f" else None


def told(image: Image, fault: Fault) -> str:
    """Return a fault as a line for people."""
    kind = {"instruction": "fault"}.get(fault.kind, fault.kind)
    return f"{kind}: {fault.what}, by {image.place(fault.pc)}"


def in_order(array: NDArray[Any], target: Target) -> bytes:
    """Return an array as the target's memory holds it."""
    return array.astype(array.dtype.newbyteorder(">" if target.big_endian else "<")).tobytes()


def _watched(
    bundle: Bundle, target: Target, image: Image, vectors: Vectors, emulation: Emulation, flush: bool
) -> str | None:
    """Call every function alone, accesses watched; return what went wrong first."""
    name, rows = bundle.name, min(WATCHED, vectors.rows)
    size = vectors.inputs[0, 0].nbytes
    buffers = [
        Buffer("the state", packed(bundle, first_state(bundle, vectors), target.big_endian), True),
        Buffer(argument(bundle, bundle.driver.setter), in_order(vectors.attitude[0, :1], target)),
        Buffer(argument(bundle, "update"), in_order(vectors.inputs[0, :rows], target)),
    ]
    calls = [("init", (Pointer(0),)), (bundle.driver.setter, (Pointer(0), Pointer(1)))]
    if bundle.driver.has_start:
        calls.append(("start", (Pointer(0), Pointer(len(buffers)))))
        buffers.append(Buffer("omega", in_order(vectors.before[0, :1], target)))
    outputs: list[tuple[str, tuple[Pointer, ...]]] = []
    for output, count in bundle.driver.outputs:
        outputs.append((output, (Pointer(0), Pointer(len(buffers)))))
        buffers.append(Buffer(f"the argument of {output}()", bytes(count * vectors.attitude.dtype.itemsize), True))
    outputs += _stage(bundle, target, vectors, buffers)
    least = 0
    for row in range(rows):
        calls.append(("update", (Pointer(0), Pointer(2, row * size))))
        calls += outputs if row < 2 else []
        least = len(calls) if row < LEAST_WATCHED else least
    made = []
    for each, arguments in calls:
        function = image.function(f"{name}_{each}")
        assert function, each
        made.append(Call(function.address, arguments, traced=True))
    limits = {"instructions": INSTRUCTIONS, "least": least}
    fault = emulation.run(job_for(target, image, tuple(buffers), tuple(made), flush=flush, **limits)).fault
    return None if fault is None else told(image, fault)


def _stage(
    bundle: Bundle, target: Target, vectors: Vectors, buffers: list[Buffer]
) -> list[tuple[str, tuple[Pointer, ...]]]:
    """Return the calls of a rotating unit's stage, nothing without one; what they take joins the buffers."""
    if not bundle.driver.stage:
        return []
    angles, harmonics = vectors.unit
    size = vectors.attitude.dtype.itemsize
    at: dict[str, int] = {}
    for name, values in (
        *zip(("azimuth", "tilt_x", "tilt_y"), np.split(harmonics[0, 1], 3), strict=True),
        ("encoder", angles[0, :1]),
    ):
        at[name] = len(buffers)
        buffers.append(Buffer(name, in_order(values, target)))
    calls: list[tuple[str, tuple[Pointer, ...]]] = []
    for name in ("set_correction", *(name for name, _ in bundle.driver.stage)):
        routine = bundle.machine.routine(name)
        for block in routine.having(Role.OUTPUT):
            at[block.name] = len(buffers)
            buffers.append(Buffer(f"{block.name} of {name}()", bytes(block.size * size), True))
        taken = [Pointer(at[block.name]) for block in (*routine.having(Role.INPUT), *routine.having(Role.OUTPUT))]
        calls.append((name, (*([Pointer(0)] if routine.having(Role.STATE) else []), *taken)))
    return calls


def _batch(
    outcome: Outcome,
    bundle: Bundle,
    target: Target,
    image: Image,
    vectors: Vectors,
    emulation: Emulation,
    flush: bool,
) -> Outcome:
    """Run the batch loop on all rows and compare."""
    arrays = run_arrays(bundle, vectors)
    buffers = tuple(
        Buffer(name, in_order(array, target), name in ("words", "probed")) for name, array in arrays.items()
    )
    function = image.function(f"{bundle.name}_run")
    assert function
    call = Call(function.address, (vectors.rows, *map(Pointer, range(len(buffers)))))
    ran = emulation.run(job_for(target, image, buffers, (call,), flush=flush))
    if ran.fault:
        return replace(outcome, rows=vectors.rows, first_difference=told(image, ran.fault), status="faults")
    words, probed = (
        np.frombuffer(data, each.dtype.newbyteorder(">" if target.big_endian else "<")).astype(each.dtype)
        for data, each in zip(ran.buffers[-2:], list(arrays.values())[-2:], strict=True)
    )
    words = words.reshape(arrays["words"].shape)
    return judged(outcome, bundle, vectors, words, model_steps(bundle, vectors, words), int(probed[0]))
