"""Algorithm: an author's function with what must be known beside it. The catalogue and a user's paper use the same."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from qcone.errors import UsageError
from qcone.ir.statement import Block

Author = Callable[..., Any]
Truncation = Callable[[Fraction], tuple[Fraction, Fraction]]
"""From a bound of an increment, rad, to bounds of the error of r: of its scalar part, of its vector part."""


@dataclass(frozen=True)
class Source:
    """Where an algorithm is printed: the paper's key ("cao", "xu2019", ...) and its equation numbers."""

    key: str
    equation: str

    def __str__(self) -> str:
        """Return `cao (12), (14)`."""
        return f"{self.key} {self.equation}".strip()


@dataclass(frozen=True)
class Phase:
    """What serves the updates after a restart while their number is below `limit`; `name` is its routine's."""

    name: str
    limit: int
    write: Author
    written: Author | None = None

    def author(self, form: str) -> Author:
        """Return the author's function for a form."""
        return self.written if form == "as-written" and self.written is not None else self.write


@dataclass(eq=False)
class Algorithm:
    """One attitude update: what it needs, the author's function, and what is claimed of it.

    `write` receives the blocks it names as arguments: the attitude, `q` (quaternion, body to navigation), `c`
    (direction cosine matrix) or `rpy` (Euler angles) as `state` says; `dtheta` (a tuple of `subsamples` angle
    increments, rad) or, where `takes` says so, `omega` (the rate at the start of the interval and the newer ones,
    rad/s); with `previous` > 0, `previous` (a tuple of earlier increments, newest first); each block of `memory`
    (a tuple); and `interval`, s, an exact fraction. It returns the new attitude or, with memory, the attitude and a
    mapping of what is to be kept. `phases` serve the first updates after a restart. `written` is the paper's own
    form where that differs. `startup` serves the first updates after a restart, until the history is full.
    `order` is the global order of accuracy in general motion; `properties` are the symmetries that hold
    to the last bit: "cyclic", "flip", "time-reversal", "constant-rate"; `written_properties` are those of
    the paper's own form, where its order of operations keeps fewer. `truncation` bounds what a series of the
    algorithm's own leaves out.
    """

    name: str
    source: Source
    subsamples: int
    write: Author
    previous: int = 0
    written: Author | None = None
    startup: Algorithm | None = None
    order: int | None = None
    properties: frozenset[str] = field(default_factory=frozenset)
    written_properties: frozenset[str] | None = None
    errata: tuple[str, ...] = ()
    summary: str = ""
    state: str = "quaternion"
    takes: str = "dtheta"
    memory: tuple[Block, ...] = ()
    phases: tuple[Phase, ...] = ()
    truncation: Truncation | None = None

    def factored(self, function: Author) -> Algorithm:
        """Take `function` as the form firmware runs; what was decorated first stays the paper's own form."""
        self.written, self.write = self.write, function
        return self

    @property
    def held(self) -> int:
        """Return for how many updates after a restart a starter holds the attitude."""
        return max((phase.limit for phase in self.phases if phase.name == "hold"), default=0)

    def author(self, form: str) -> Author:
        """Return the author's function for a form, "as-written" or "factored"."""
        return self.written if form == "as-written" and self.written is not None else self.write

    def claims(self, form: str) -> frozenset[str]:
        """Return the symmetries claimed to hold to the last bit for a form, "as-written" or "factored"."""
        if form == "as-written" and self.written_properties is not None:
            return self.written_properties
        return self.properties


def algorithm(
    name: str,
    *,
    source: Source,
    subsamples: int = 1,
    previous: int = 0,
    order: int | None = None,
    properties: frozenset[str] = frozenset(),
    written_properties: frozenset[str] | None = None,
    startup: Algorithm | None = None,
    errata: tuple[str, ...] = (),
    summary: str = "",
    state: str = "quaternion",
    takes: str = "dtheta",
    memory: tuple[Block, ...] = (),
    phases: tuple[Phase, ...] = (),
    truncation: Truncation | None = None,
) -> Callable[[Author], Algorithm]:
    """Make an `Algorithm` of the decorated function.

    With `previous` > 0 and no `startup`, the start-up sees zeros for the increments it does not have yet.
    Raises UsageError for a number of sub-samples or of previous increments that makes no sense.
    """
    if not 1 <= subsamples <= MOST_SUBSAMPLES:
        raise UsageError(f"algorithm '{name}': subsamples = {subsamples} is not between 1 and {MOST_SUBSAMPLES}")
    if not 0 <= previous <= MOST_SUBSAMPLES:
        raise UsageError(f"algorithm '{name}': previous = {previous} is not between 0 and {MOST_SUBSAMPLES}")

    def decorate(function: Author) -> Algorithm:
        return Algorithm(
            name=name,
            source=source,
            subsamples=subsamples,
            write=function,
            previous=previous,
            order=order,
            properties=properties,
            written_properties=written_properties,
            startup=startup,
            errata=errata,
            summary=summary,
            state=state,
            takes=takes,
            memory=memory,
            phases=phases,
            truncation=truncation,
        )

    return decorate


MOST_SUBSAMPLES = 12
"""More than any paper uses; a number above it is a slip of the pen, not a design."""
