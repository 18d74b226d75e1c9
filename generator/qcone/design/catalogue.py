"""What a caller declares of its algorithms, so that a design can be checked without knowing them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

Value = int | str | None
"""A resolved algorithm parameter; None means that the parameter does not apply or follows from the others."""

Conflict = tuple[str, str, str, str]
"""A parameter's name, then what is wrong with it, why, and what to write instead."""


@dataclass(frozen=True)
class Parameter:
    """One algorithm parameter: the same word is the design key and the command line option.

    `choices` is every legal value; the order is the order in which messages list them.
    """

    name: str
    choices: tuple[int | str, ...]
    default: Value
    help: str


@dataclass(frozen=True)
class AlgorithmEntry:
    """One catalogue row: an id, its parameters and the rules between them.

    `conflicts` takes the resolved values and the names given explicitly. It is called only when every given
    parameter is legal by itself.
    """

    id: str
    parameters: tuple[Parameter, ...]
    conflicts: Callable[[Mapping[str, Value], frozenset[str]], Sequence[Conflict]]
