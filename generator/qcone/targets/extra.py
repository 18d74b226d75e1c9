"""The optional packages of the extra [target]: imported where they are used, with an error that names the extra."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from qcone.errors import MissingToolError

EXTRA = ("ziglang", "unicorn", "capstone", "pyelftools")
FIX = "run: pip install 'qcone[target]'"


@contextmanager
def needed(package: str) -> Iterator[None]:
    """Turn a failed import of a package of the extra into a MissingToolError that says what to install."""
    try:
        yield
    except ImportError as error:
        raise MissingToolError(f"{package} is not installed, which targets other than the host need; {FIX}") from error
