"""Identifiers: what may stand as a name in emitted C, and the nearest such name to an author's own."""

from __future__ import annotations

import re
import unicodedata

KEYWORDS = frozenset(
    """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while asm bool true
    false class new delete this template namespace operator private public protected try catch int32_t
    """.split()  # noqa: SIM905  a list of words is read more easily as words
)
"""Words that are no identifiers in C or C++, or that the emitted text uses otherwise."""
RESERVED = frozenset({"state", "result"})
"""What the emitted functions call their own arguments."""
_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


def is_identifier(name: str) -> bool:
    """Tell whether `name` may be given to an array, a counter or a function of the emitted C."""
    return bool(_PLAIN.fullmatch(name)) and name not in KEYWORDS | RESERVED


def identifier(name: str) -> str:
    """Return the name in ASCII, `phi` for the Greek letter, without underscores in front: C keeps those for itself."""
    plain = re.sub(r"[^A-Za-z0-9_]", "", "".join(map(_spelt, name))).lstrip("_0123456789")
    return plain or "value"


def _spelt(letter: str) -> str:
    """Return a letter in ASCII: a Greek one by its name, an accented one without its accent."""
    if letter.isascii():
        return letter
    found = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (?:FINAL )?(\w+)(?: WITH .*)?", unicodedata.name(letter, ""))
    if found:
        return found[2].lower() if found[1] == "SMALL" else found[2].capitalize()
    return unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
