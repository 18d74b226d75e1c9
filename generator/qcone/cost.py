"""Cost: what one update of a design takes on a target, measured on the code itself, whose bits are compared first.

A figure belongs to a compiler and a level. The update is called as firmware calls it, many times in a chain; every
instruction and every access of memory is watched.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from qcone.backends.counts import products
from qcone.bundle import Bundle
from qcone.errors import CheckError, UsageError
from qcone.on_target import float_bits, in_order, told
from qcone.outcomes import describe_first, differing_bits, named
from qcone.reconciliation import Reconciliation, reconcile, reconcile_words
from qcone.stepwise import first_state, model_steps, packed, unpacked
from qcone.targets.code import Disassembler
from qcone.targets.compiler import Compiler
from qcone.targets.cross import built_image
from qcone.targets.elf import Function, Image, check_fits, read_image
from qcone.targets.emulation import Emulation, job_for
from qcone.targets.gates import Finding, defined_in, emitted_functions, findings
from qcone.targets.job import Buffer, Call, Pointer, Ran
from qcone.targets.library import soft_bits
from qcone.targets.machines import Target
from qcone.targets.traces import Executed, executed
from qcone.vectors import Vectors, draw_chain

UPDATES = 1000
LEAST_UPDATES = 16
INSTRUCTIONS = 500_000
"""Updates measured: up to so many, but no more after so many instructions, and never fewer than the least."""
SETTLED = 8
"""Updates made before the first one measured: start-up routines have done their part."""


@dataclass(frozen=True)
class Cost:
    """What one update of a design takes. `text_bytes` are those of its own functions, `read_only_bytes` constants.

    `executed` is what was run. `findings` are things that may not be; a figure with one is no figure of the design.
    `library_bytes` are the code of the compiler's own routines that it needs, beside `text_bytes`; None in a program
    that holds more than the design.
    """

    design: str
    target: Target
    compiler: str
    level: str | None
    executed: Executed
    text_bytes: int
    read_only_bytes: int | None
    library_bytes: int | None
    stack_bytes: int
    findings: tuple[Finding, ...]
    reconciliation: Reconciliation | None

    @property
    def soft_float(self) -> tuple[str, ...]:
        """Return the routines called that compute floats in software."""
        return tuple(name for name in self.executed.routines if soft_bits(name))


def measure(
    bundle: Bundle, target: Target, compiler: Compiler, level: str, emulation: Emulation, cflags: Sequence[str] = ()
) -> Cost:
    """Build a design's update for a target and measure it.

    Raises CompileError, NotMeasuredError when the emulator crashes, CheckError when the code faults or gives other
    bits than the model.
    """
    sources = {name: text for name, text in bundle.sources.items() if not name.endswith("_run.c")}
    image = built_image(compiler, target, sources, [f"{bundle.name}_update"], level, cflags)
    return _measured(bundle, target, image, named(compiler), level, emulation, alone=True)


def measure_elf(bundle: Bundle, target: Target, file: Path, emulation: Emulation) -> Cost:
    """Measure the update of a design in a program that the user built.

    Raises UsageError when the file is no program for the target or lacks the update, and as `measure` does.
    """
    try:
        image = read_image(file.read_bytes(), file.name)
    except OSError as error:
        raise UsageError(f"--elf {file}: {error.strerror}; give the program your linker wrote") from error
    check_fits(image, target, file.name)
    return _measured(bundle, target, image, image.producer or "not stated in the file", None, emulation, alone=False)


def _measured(
    bundle: Bundle,
    target: Target,
    image: Image,
    compiler: str,
    level: str | None,
    emulation: Emulation,
    alone: bool,
) -> Cost:
    update = image.function(f"{bundle.name}_update")
    if update is None:
        raise UsageError(
            f"the program has no function {bundle.name}_update: link the design into it, call it, and keep the symbols"
        )
    vectors = draw_chain(bundle, UPDATES + SETTLED)
    ran = _run(bundle, target, image, update, vectors, emulation)
    code, own = Disassembler(image), defined_in(bundle.source)
    found = executed(code, own, target, ran.traces)
    text = _text_bytes(code, own, update, found)
    return Cost(
        bundle.name,
        target,
        compiler,
        level,
        found,
        text,
        image.read_only_bytes if alone else None,
        image.code_bytes - text if alone else None,
        ran.stack,
        tuple(findings(code, own, target, float_bits(bundle))),
        _reconciled(bundle, target, found),
    )


def _run(bundle: Bundle, target: Target, image: Image, update: Function, vectors: Vectors, emulation: Emulation) -> Ran:
    """Make the updates of a chain one by one, and raise CheckError unless every state is the model's."""
    stride = vectors.inputs[0, 0].nbytes
    buffers = (
        Buffer("the state", packed(bundle, first_state(bundle, vectors), target.big_endian), True),
        Buffer("the samples", in_order(vectors.inputs[0, : UPDATES + SETTLED], target)),
    )
    calls = tuple(
        Call(update.address, (Pointer(0), Pointer(1, row * stride)), traced=row >= SETTLED, kept=0)
        for row in range(UPDATES + SETTLED)
    )
    ran = emulation.run(job_for(target, image, buffers, calls, instructions=INSTRUCTIONS, least=LEAST_UPDATES))
    if ran.fault:
        raise CheckError(f"{bundle.name} on {target.name}: {told(image, ran.fault)}")
    states = unpacked(bundle, b"".join(ran.kept), target.big_endian)
    part = vectors.first(len(states))
    words = np.zeros((1, len(states), bundle.driver.word_count), states.dtype)
    words[0, :, : states.shape[1]] = states
    expected = model_steps(bundle, part, words)
    words[0, :, states.shape[1] :] = expected[0, :, states.shape[1] :]
    if differing_bits(words, expected):
        difference = describe_first(bundle, part, words, expected)
        raise CheckError(f"{bundle.name} on {target.name}: not measured: its bits are not the model's: {difference}")
    return ran


def _text_bytes(code: Disassembler, names: frozenset[str], update: Function, found: Executed) -> int:
    """Return the bytes of the update and of all functions of the design that it reaches."""
    own = emitted_functions(code.image, names)
    reached, ahead = {update}, [update]
    ahead += [each for each in own if each.name in found.functions]
    while ahead:
        function = ahead.pop()
        reached.add(function)
        to = set(code.destinations(function))
        ahead += [each for each in own if each.address in to and each not in reached]
    return sum({each.address: each.size for each in reached}.values())


def _reconciled(bundle: Bundle, target: Target, found: Executed) -> Reconciliation:
    """Hold what was executed against what is emitted: of the update that is made once a history is full."""
    name = "steady" if bundle.machine.has("steady") else "update"
    if float_bits(bundle):
        return reconcile(bundle.facts.counts[name]["emitted"], found)
    return reconcile_words(products(bundle.machine.routine(name)), found, target.separate_halves)
