"""How a message names a key, a value and a place: in the words of a design file, or of the command line."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Protocol

from qcone.design.lines import LineIndex
from qcone.errors import Problem

_BARE_KEY = re.compile("[A-Za-z0-9_-]+")

KeyPath = tuple[str, ...]
"""A key's path inside its design, such as ("imu", "update_hz"); () is the design itself."""


@dataclass(frozen=True)
class Finding:
    """A mistake before it has a place."""

    path: KeyPath
    code: str
    what: str
    why: str = ""
    hint: str = ""


class Places(Protocol):
    """The wording of one source of designs."""

    def where(self, path: KeyPath) -> str:
        """Return the place a problem of `path` is shown at."""

    def order(self, path: KeyPath) -> int:
        """Return the position of `path` in the source, to sort by."""

    def word(self, path: KeyPath) -> str:
        """Return the key as its user knows it."""

    def given(self, path: KeyPath, value: object) -> str:
        """Return the key with the value it was given."""

    def proposal(self, path: KeyPath, example: str) -> str:
        """Return what to write to give the key a value; `example` is TOML."""


@dataclass(frozen=True)
class FilePlaces:
    """The wording for one design of a file."""

    file: str
    name: str
    lines: LineIndex

    def where(self, path: KeyPath) -> str:
        """Return `file:line`."""
        return f"{self.file}:{self.order(path)}"

    def order(self, path: KeyPath) -> int:
        """Return the line."""
        return self.lines.line(("design", self.name, *path))

    def word(self, path: KeyPath) -> str:
        """Return the dotted key."""
        return f"`{dotted(path)}`"

    def given(self, path: KeyPath, value: object) -> str:
        """Return `key = value`."""
        return f"`{dotted(path)} = {shown(value)}`"

    def proposal(self, path: KeyPath, example: str) -> str:
        """Return `key = example` and its table."""
        return f"`{path[-1]} = {example}` in [{dotted(('design', self.name, *path[:-1]))}]"


@dataclass(frozen=True)
class OptionPlaces:
    """The wording for a design made of command line options; `given_words` in the order they were given."""

    given_words: Sequence[str]

    def where(self, path: KeyPath) -> str:
        """Return the option."""
        return option_word(path)

    def order(self, path: KeyPath) -> int:
        """Return the option's turn; absent ones come last."""
        word = option_word(path)
        return self.given_words.index(word) if word in self.given_words else len(self.given_words)

    def word(self, path: KeyPath) -> str:
        """Return the option."""
        return f"`{option_word(path)}`"

    def given(self, path: KeyPath, value: object) -> str:
        """Return the option and its value."""
        return f"`{option_word(path)} {_bare(shown(value))}`"

    def proposal(self, path: KeyPath, example: str) -> str:
        """Return the option and an example."""
        return f"`{option_word(path)} {_bare(example)}`"


def dotted(path: KeyPath) -> str:
    """Return a path as TOML writes it, with quotes around the parts that need them."""
    return ".".join(part if _BARE_KEY.fullmatch(part) else shown(part) for part in path)


def option_word(path: KeyPath) -> str:
    """Return the option of a key; the number format is `--number`, as `--format` is that of reports."""
    if path == ("number", "format"):
        return "--number"
    return "--" + (path[-1] if path else "design").replace("_", "-")


def problems(findings: Sequence[Finding], places: Places) -> list[tuple[int, Problem]]:
    """Give every finding its place, each with the position to sort by."""
    return [
        (places.order(each.path), Problem(places.where(each.path), each.code, each.what, each.why, each.hint))
        for each in findings
    ]


def shown(value: object) -> str:
    """Return `value` as TOML would spell it, shortened to a line."""
    if isinstance(value, bool):
        text = str(value).lower()
    elif isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        text = f'"{"".join(letter if letter.isprintable() else "?" for letter in escaped)}"'
    elif isinstance(value, list | tuple):
        text = f"[{', '.join(shown(each) for each in value)}]"
    elif isinstance(value, dict):
        text = "{...}"
    elif isinstance(value, int | Decimal | Fraction):
        # An integer may be longer than Python agrees to print.
        text = str(value) if not isinstance(value, int) or value.bit_length() < 400 else "..."
    else:
        text = str(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def described(value: object) -> str:
    """Return `value` with the kind of thing it is, as in: the string "fast"."""
    if isinstance(value, str):
        return f"the string {shown(value)}"
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list | tuple):
        return f"the list {shown(value)}"
    if isinstance(value, bool) or not isinstance(value, int | Decimal | Fraction):
        return shown(value)
    return f"the number {shown(value)}"


def _bare(text: str) -> str:
    return re.sub(r'[\[\]" ]', "", text)
