"""Design files with a mistake in them, and the messages they get."""

from __future__ import annotations

from pathlib import Path

import pytest
from fake_catalogue import CATALOGUE, GOOD

from qcone.design import read_designs
from qcone.errors import DesignError


def messages(folder: Path, text: str | bytes) -> list[str]:
    """Return the messages of a design file with this text, without the folder."""
    file = folder / "bad.toml"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(DesignError) as caught:
        read_designs(file, CATALOGUE)
    assert caught.value.exit_code == 2
    lines = str(caught.value).split("\n")
    assert lines == [str(problem) for problem in caught.value.problems]
    prefix = f"{folder.as_posix()}/"
    assert all(line.startswith(prefix) for line in lines)
    return [line.removeprefix(prefix) for line in lines]


def top(line: str) -> str:
    return GOOD.replace("\n\n[design.att.imu]", f"\n{line}\n[design.att.imu]")


def imu(line: str) -> str:
    return GOOD.replace("max_rate_dps = 573", f"max_rate_dps = 573\n{line}")


def counts(line: str) -> str:
    return imu(line).replace('"rotation-vector"', '"rotation-vector"\ninput = "counts"')


def end(lines: str) -> str:
    return GOOD + lines
