"""Write a replayed attitude as CSV, whole or not at all."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from qcone.errors import UsageError


def write_attitude(
    path: Path,
    time_s: NDArray[np.floating],
    q: NDArray[np.floating],
    raw: NDArray[np.integer] | None = None,
) -> None:
    """Write `t_s,q0,q1,q2,q3` (and `raw0..raw3` for fixed point), one row an update, at its end.

    `time_s` (n,) in s; `q` (n, 4), scalar first, body to navigation; `raw` (n, 4) two's-complement words.
    Numbers are `%.17g`: reading them gives the same float64. The rows go to a temporary file in the same
    folder that then takes the place of `path`, so a reader sees the old file or the new one. A link is
    followed; a device or pipe is written to directly.

    Raises UsageError where the folder or file cannot be written (nothing new is left behind), ValueError
    where the arrays differ in length or have other shapes.
    """
    text = "".join(_lines(time_s, q, raw))
    target = Path(os.path.realpath(path))
    try:
        if target.exists() and not target.is_file() and not target.is_dir():
            target.write_bytes(text.encode("ascii"))
        else:
            _replace(target, text.encode("ascii"))
    except OSError as reason:
        raise UsageError(
            f"{path}: cannot be written, {reason.strerror or reason}, give -o a file in a folder that exists "
            f"and is writable"
        ) from reason


def _lines(time_s: NDArray[np.floating], q: NDArray[np.floating], raw: NDArray[np.integer] | None) -> Iterator[str]:
    """Yield the header and the rows, checking shapes first."""
    updates = len(time_s)
    shapes = {"time_s": (time_s.shape, (updates,)), "q": (q.shape, (updates, 4))}
    if raw is not None:
        shapes["raw"] = (raw.shape, (updates, 4))
    for name, (given, wanted) in shapes.items():
        if given != wanted:
            raise ValueError(f"{name} has shape {given}, not {wanted}")
    yield "t_s,q0,q1,q2,q3" + (",raw0,raw1,raw2,raw3" if raw is not None else "") + "\n"
    numbers = np.column_stack((time_s, q)).astype(np.float64).tolist()
    if raw is None:
        for row in numbers:
            yield ",".join([f"{number:.17g}" for number in row]) + "\n"
    else:
        for row, words in zip(numbers, raw.tolist(), strict=True):
            yield ",".join([f"{number:.17g}" for number in row] + [f"{word:d}" for word in words]) + "\n"


def _replace(target: Path, content: bytes) -> None:
    """Put `content` at `target` in one step; on any failure the temporary file is removed."""
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    temporary = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        with open(temporary, "wb") as file:
            file.write(content)
        os.replace(temporary, target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
