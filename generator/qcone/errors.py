"""Errors a user can act on, and the exit code each one ends the command with.

Every message says where, what, why and what to do. A traceback is a bug of ours (exit code 70).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


class QconeError(Exception):
    """Base of every error that is shown to the user as a message, never as a traceback."""

    exit_code = 70


class CheckError(QconeError):
    """The thing that was checked does not hold: stale, different, over budget (exit code 1)."""

    exit_code = 1


class UsageError(QconeError):
    """What was asked for is not possible as written (exit code 2)."""

    exit_code = 2


class MissingToolError(QconeError):
    """The environment lacks a tool, or a tool failed; the message names the exact fix (exit code 3)."""

    exit_code = 3


@dataclass(frozen=True)
class Problem:
    """One mistake in a design: where it stands, what it is, why it matters and what to write instead.

    `place` is `file:line` for a design file and the option's name for a command line.
    """

    place: str
    code: str
    what: str
    why: str = ""
    hint: str = ""

    def __str__(self) -> str:
        """Return `place: error QCnnn: what, why, hint`, leaving out the parts that are empty."""
        text = ", ".join(part for part in (self.what, self.why, self.hint) if part)
        return f"{self.place}: error {self.code}: {text}"


class DesignError(UsageError):
    """A design with mistakes; carries every one of them, in the order of the file (exit code 2)."""

    def __init__(self, problems: Sequence[Problem]) -> None:
        """Keep the `problems`; the message is one line for each."""
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))
