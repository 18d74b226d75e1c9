"""Family: algorithms that differ by parameters only, as one row of the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from qcone.ir.real import Algorithm, Source

Values = Mapping[str, int | str | None]
Conflict = tuple[str, str, str, str]
"""(parameter, what is wrong, why, hint)."""


@dataclass(frozen=True)
class Choice:
    """One parameter: its name as design key and command-line option, every legal value, the default."""

    name: str
    choices: tuple[int | str, ...]
    default: int | str | None
    help: str


@dataclass(frozen=True)
class Family:
    """A row of the catalogue: what may be chosen, and how to make the algorithm of a choice."""

    id: str
    title: str
    source: Source
    parameters: tuple[Choice, ...]
    make: Callable[[Values], Algorithm]
    conflicts: Callable[[Values, frozenset[str]], Sequence[Conflict]] = lambda values, given: ()
    """What is wrong with a choice, given the names that were chosen and not left to their defaults."""
    examples: tuple[Values, ...] = field(default_factory=tuple)
    """One choice of parameters for every algorithm of the family: what tests and `list` go through."""
    caution: Callable[[Values], str | None] = lambda _: None
    """What speaks against a choice that is no mistake."""
