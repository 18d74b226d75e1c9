"""Lint, layout and types are tests like any other."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NoReturn

import pytest

ROOT = Path(__file__).parents[1]
MissingTool = Callable[[str], NoReturn]

LINT = ("ruff", "check", "--no-cache", "generator", "tests")
LAYOUT = ("ruff", "format", "--check", "--diff", "--no-cache", "generator", "tests")
TYPES = ("mypy", "--strict", "--no-error-summary", "--config-file", "pyproject.toml")


def run(arguments: Sequence[str], missing_tool: MissingTool) -> tuple[int, str]:
    """Run a tool of this environment on the checkout; return its exit code and all it said."""
    if importlib.util.find_spec(arguments[0]) is None:
        missing_tool(f"{arguments[0]} (pip install -e '.[test]')")
    done = subprocess.run([sys.executable, "-m", *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


@pytest.mark.parametrize("tool", [LINT, LAYOUT], ids=["lint", "layout"])
def test_ruff_has_nothing_to_say(tool: Sequence[str], missing_tool: MissingTool) -> None:
    code, said = run(tool, missing_tool)
    assert code == 0, said


def test_types_are_strict_and_sound(missing_tool: MissingTool) -> None:
    code, said = run(TYPES, missing_tool)
    assert code == 0, said


MISTAKES = {
    "lint": (("ruff", "check", "--no-cache"), "import os\n", "F401"),
    "layout": (("ruff", "format", "--check", "--no-cache"), "a = {  'a':1}\n", "reformatted"),
    "types": (("mypy", "--strict", "--cache-dir", "/dev/null"), "def f(a): return a\n", "no-untyped-def"),
}


@pytest.mark.parametrize("kind", MISTAKES)
def test_tool_finds_a_mistake(tmp_path: Path, kind: str, missing_tool: MissingTool) -> None:
    tool, text, word = MISTAKES[kind]
    (tmp_path / "mistake.py").write_text(text)
    code, said = run([*tool, str(tmp_path / "mistake.py")], missing_tool)
    assert code == 1
    assert word in said
