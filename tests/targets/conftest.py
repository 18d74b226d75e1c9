from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from qcone.targets import compiler
from qcone.targets.compiler import Compiler


def _one(config: pytest.Config, family: str, name: str, fix: str) -> Compiler:
    for found in compiler.compilers():
        if found.family == family and name in ("", found.name):
            return found
    if config.getoption("--require-tools"):
        pytest.fail(f"missing tool: {fix}", pytrace=False)
    pytest.skip(f"missing tool: {fix}")


@pytest.fixture
def gcc(pytestconfig: pytest.Config) -> Compiler:
    return _one(pytestconfig, "gcc", "", "gcc (apt install gcc)")


@pytest.fixture
def zig(pytestconfig: pytest.Config) -> Compiler:
    return _one(pytestconfig, "clang", "zig", "ziglang (pip install 'qcone[compiler]')")


@pytest.fixture(params=["gcc", "zig"])
def each_compiler(request: pytest.FixtureRequest) -> Compiler:
    found: Compiler = request.getfixturevalue(request.param)
    return found


@pytest.fixture
def fake_compilers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Path]:
    """Make a machine with no compiler but the given ones: programs that only say who they are."""
    folder = tmp_path / "bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(compiler.importlib.util, "find_spec", lambda name: None)

    def add(name: str, version: str, machine: str = "x86_64-linux-gnu", status: int = 0) -> Path:
        program = folder / name
        program.write_text(
            f'#!/bin/sh\nif [ "$1" = -dumpmachine ]; then echo "{machine}"; else echo "{version}"; fi\nexit {status}\n'
        )
        program.chmod(0o755)
        return program

    return add
