"""On which line a key of a TOML text stands; tomllib does not say."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

Path = tuple[str, ...]

_BLANK = re.compile(r"(?:[ \t\n]|#[^\n]*)*")
_KEY_PART = re.compile(r"""[ \t]*("(?:\\.|[^"\\\n])*"|'[^'\n]*'|[A-Za-z0-9_-]+)[ \t]*(\.?)""")
# A multi-line string may end in up to two quotes of its own before the three that close it.
_VALUE_TOKEN = re.compile(
    r'''"""(?:\\.|[^\\])*?"{3,5}|\'{3}.*?\'{3,5}|"(?:\\.|[^"\\\n])*"|'[^'\n]*'|#[^\n]*|.''', re.DOTALL
)


@dataclass(frozen=True)
class LineIndex:
    """Lines (from 1) of the keys and table headers of one TOML text."""

    written: Mapping[Path, int]
    implied: Mapping[Path, int]  # tables that only appear as the beginning of a longer key

    def line(self, path: Sequence[str | int]) -> int:
        """Return the line of `path`, or of the nearest table around it; 1 when there is none."""
        names = tuple(part for part in path if isinstance(part, str))
        for end in range(len(names), 0, -1):
            found = self.written.get(names[:end]) or self.implied.get(names[:end])
            if found:
                return found
        return 1


def index_lines(text: str) -> LineIndex:
    """Index the keys of `text`, which tomllib has already accepted and whose line ends are single newlines.

    Keys of inline tables and elements of arrays are not indexed: they share their parent's line.
    """
    written: dict[Path, int] = {}
    implied: dict[Path, int] = {}
    table: Path = ()
    position, line = _skip_blank(text, 0), 1
    line += text.count("\n", 0, position)
    while position < len(text):
        header = text[position] == "["
        if header:
            start = position + (2 if text.startswith("[[", position) else 1)
            table, end = _read_key(text, start)
            path = table
        else:
            key, end = _read_key(text, position)
            path = table + key
        written.setdefault(path, line)
        for length in range(1, len(path)):
            implied.setdefault(path[:length], line)
        end = _skip_blank(text, _skip_value(text, end))
        line += text.count("\n", position, end)
        position = end
    return LineIndex(written, implied)


def _skip_blank(text: str, position: int) -> int:
    match = _BLANK.match(text, position)
    return match.end() if match else position


def _read_key(text: str, position: int) -> tuple[Path, int]:
    """Return the parts of a dotted key and where it ends."""
    parts: list[str] = []
    more = True
    while more:
        match = _KEY_PART.match(text, position)
        if match is None:  # only for text that tomllib would refuse
            return tuple(parts), position + 1
        part = match[1]
        parts.append(tomllib.loads(f"key = {part}")["key"] if part[0] in "\"'" else part)
        position, more = match.end(), bool(match[2])
    return tuple(parts), position


def _skip_value(text: str, position: int) -> int:
    """Return where the rest of a statement ends: at a newline outside brackets and strings."""
    depth = 0
    while position < len(text):
        match = _VALUE_TOKEN.match(text, position)
        if match is None:
            break
        token = match[0]
        if token == "\n" and depth <= 0:
            break
        depth += (token in ("[", "{")) - (token in ("]", "}"))
        position = match.end()
    return position
