"""Small C functions, built for a target and called under the emulator."""

from __future__ import annotations

from collections.abc import Sequence

from qcone.targets.cross import built_image, cross_compiler
from qcone.targets.elf import Image
from qcone.targets.emulation import Emulation, job_for
from qcone.targets.job import Buffer, Call, Pointer, Ran
from qcone.targets.machines import TARGETS, Target

EMULATED = tuple(name for name, each in TARGETS.items() if each.emulated)


def image_of(text: str, target: Target | str, extra: Sequence[str] = (), level: str = "-O2") -> Image:
    """Build C text whose function is `called` for a target."""
    chosen = TARGETS[target] if isinstance(target, str) else target
    return built_image(cross_compiler(), chosen, {"called.c": text}, ["called"], level, extra)


def run_on(
    target: str,
    text: str,
    buffers: Sequence[Buffer] = (),
    arguments: Sequence[int | Pointer] | None = None,
    *,
    traced: bool = True,
    flush: bool = False,
    times: int = 1,
    longest: int = 100_000,
    emulation: Emulation | None = None,
) -> Ran:
    """Call `called` with the buffers, in order, unless other `arguments` are given."""
    image = image_of(text, target)
    function = image.function("called")
    assert function
    given = tuple(arguments if arguments is not None else map(Pointer, range(len(buffers))))
    call = Call(function.address, given, traced=traced)
    job = job_for(TARGETS[target], image, tuple(buffers), (call,) * times, flush=flush, longest=longest)
    if emulation:
        return emulation.run(job)
    with Emulation() as own:
        return own.run(job)
