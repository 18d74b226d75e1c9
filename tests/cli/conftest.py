"""A folder of one's own, and the command line run in it."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result
from given import GOOD

from qcone import verify
from qcone.cli import main

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run `qcone` with the given words in an empty folder; a traceback of ours fails the test."""
    monkeypatch.chdir(tmp_path)

    def command(*words: str) -> Result:
        result = CliRunner().invoke(main, list(words), prog_name="qcone")
        assert isinstance(result.exception, SystemExit | None), result.exception
        assert "Traceback" not in result.output
        return result

    return command


@pytest.fixture
def good(tmp_path: Path) -> Path:
    """A design file with one small design, `good`."""
    file = tmp_path / "good.toml"
    file.write_text(GOOD)
    return file


@pytest.fixture
def flipped_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make every compiled C give one wrong bit, in the last word of the second row."""
    honest = verify.c_words

    def words(*arguments: Any) -> Any:
        found, contracted = honest(*arguments)
        found[0, 1, -1] = np.nextafter(found[0, 1, -1], found.dtype.type(2))
        return found, contracted

    monkeypatch.setattr(verify, "c_words", words)


@pytest.fixture
def no_compiler(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Empty the PATH and hide the ziglang package."""
    real = importlib.util.find_spec

    def find(name: str, *rest: str) -> object:
        return None if name == "ziglang" else real(name, *rest)

    monkeypatch.setenv("PATH", str(tmp_path_factory.mktemp("empty")))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(importlib.util, "find_spec", find)
