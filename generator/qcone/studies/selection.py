"""Which designs a command is about: those of files, one of them by name, or one written as options."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path

from qcone.design import Design, design_from_options, read_designs
from qcone.errors import UsageError
from qcone.registry import entries


def designs_of(files: Sequence[str], names: Sequence[str]) -> list[Design]:
    """Read design files and keep the named designs; a name that is nowhere, or in two files, is an error."""
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
    return [design for design in designs if not names or design.name in names]


def one_design(text: str) -> Design:
    """Return the design written `FILE.toml:NAME`."""
    file, colon, name = text.rpartition(":")
    if not colon or not file:
        raise UsageError(f"--design {text}: write FILE.toml:NAME")
    return designs_of((file,), (name,))[0]


def from_options(name: str, algorithm: str, options: Mapping[str, str | None], defaults: Mapping[str, str]) -> Design:
    """Return the design of command-line options; `defaults` stand where an option is not given."""
    given = {word.replace("_", "-"): value for word, value in options.items() if value is not None}
    return design_from_options(name, {"algorithm": algorithm, **defaults, **given}, entries())


def refuse_options(options: Mapping[str, str | None], why: str) -> None:
    """Raise UsageError when an option is given that would be passed over."""
    for word, value in options.items():
        if value is not None:
            raise UsageError(f"--{word.replace('_', '-')} {value}: {why}")
