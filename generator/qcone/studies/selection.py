"""Which designs a command is about: those of files, one of them by name, or one written as options."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Protocol

from qcone.design import Design, design_from_options, read_designs
from qcone.errors import UsageError
from qcone.registry import algorithm_of, caution_of, entries


class Say(Protocol):
    """Takes what is to be said beside the result, and whether it is a "note" or a "warning"."""

    def __call__(self, text: str, kind: str = "note") -> None:
        """Say it."""


def caution(design: Design, say: Say | None) -> Design:
    """Warn of what speaks against a design that is no mistake, and return the design."""
    if say and (reason := caution_of(design)):
        say(f"design '{design.name}': {reason}", "warning")
    return design


def designs_of(files: Sequence[str], names: Sequence[str], say: Say | None = None) -> list[Design]:
    """Read design files and keep the named designs; a name that is nowhere, or in two files, is an error.

    With `say`, designs that are better made otherwise are warned of.
    """
    designs = [design for file in files for design in read_designs(Path(file), entries())]
    known = [design.name for design in designs]
    twice = [name for name in known if known.count(name) > 1]
    if twice:
        raise UsageError(f"design '{twice[0]}' stands in more than one of {', '.join(files)}; give one another name")
    for name in names:
        if name not in known:
            close = get_close_matches(name, known, 1)
            hint = f"did you mean '{close[0]}'?" if close else f"there are: {', '.join(known)}"
            raise UsageError(f"--design {name}: no such design in {', '.join(files)}; {hint}")
    return [caution(design, say) for design in designs if not names or design.name in names]


def one_design(text: str, say: Say | None = None) -> Design:
    """Return the design written `FILE.toml:NAME`; warnings as for `designs_of`."""
    file, colon, name = text.rpartition(":")
    if not colon or not file:
        raise UsageError(f"--design {text}: write FILE.toml:NAME")
    return designs_of((file,), (name,), say)[0]


def from_options(
    name: str,
    algorithm: str,
    options: Mapping[str, str | None],
    defaults: Mapping[str, str],
    say: Say | None = None,
) -> Design:
    """Return the design of command-line options; `defaults` stand where an option is not given.

    What evaluates rates takes rates, unless an option says otherwise. Warnings as for `designs_of`.
    """
    given = {word.replace("_", "-"): value for word, value in options.items() if value is not None}
    words = {"algorithm": algorithm, **defaults, **given}
    design = design_from_options(name, words, entries())
    if "input" not in given and algorithm_of(design).takes == "omega":
        design = design_from_options(name, {**words, "input": "rate"}, entries())
    return caution(design, say)


def refuse_options(options: Mapping[str, str | None], why: str) -> None:
    """Raise UsageError when an option is given that would be passed over."""
    for word, value in options.items():
        if value is not None:
            raise UsageError(f"--{word.replace('_', '-')} {value}: {why}")
