"""Options and folders shared by all tests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NoReturn

import pytest
from hypothesis import settings

from qcone.targets import build
from qcone.targets.compiler import Compiler, compilers, is_zig

settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")  # how long an example takes says nothing: the machine may be busy


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--shared",
        type=Path,
        default=None,
        help="folder that holds truth/ (exact cases) and data/ (recordings); default: ../shared",
    )
    parser.addoption(
        "--require-tools",
        action="store_true",
        help="fail, rather than skip, where an optional tool or folder is absent",
    )
    parser.addoption(
        "--rows", type=int, default=None, help="rows of long runs, where a test takes as many as asked for"
    )


@pytest.fixture(scope="session")
def rows(pytestconfig: pytest.Config) -> int | None:
    """As many rows as are asked for; None for the test's own number."""
    asked: int | None = pytestconfig.getoption("--rows")
    return asked


@pytest.fixture(scope="session")
def missing_tool(pytestconfig: pytest.Config) -> Callable[[str], NoReturn]:
    """Skip the test, naming the tool and how to install it; with --require-tools fail it."""

    def absent(tool: str) -> NoReturn:
        if pytestconfig.getoption("--require-tools"):
            pytest.fail(f"missing tool: {tool}", pytrace=False)
        pytest.skip(f"missing tool: {tool}")

    return absent


@pytest.fixture(autouse=True, scope="session")
def build_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Keep the builds of this run apart from the user's: nothing is found that was not built here."""
    folder = tmp_path_factory.mktemp("builds")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "_folder", lambda: folder)
        yield folder


@pytest.fixture(scope="session")
def first_compiler(missing_tool: Callable[[str], NoReturn]) -> Compiler:
    """Find the compiler that commands take when none is named."""
    found = compilers()
    if not found:
        missing_tool("a C compiler (pip install 'qcone[compiler]', or apt install gcc)")
    return found[0]


@pytest.fixture(scope="session")
def gcc(missing_tool: Callable[[str], NoReturn]) -> Compiler:
    """Find gcc."""
    return next((found for found in compilers() if found.family == "gcc"), None) or missing_tool(
        "gcc (apt install gcc)"
    )


@pytest.fixture(scope="session")
def zig(missing_tool: Callable[[str], NoReturn]) -> Compiler:
    """Find the compiler that also compiles for microcontrollers."""
    return next((found for found in compilers() if is_zig(found)), None) or missing_tool(
        "ziglang (pip install 'qcone[compiler]')"
    )


@pytest.fixture(scope="session")
def truth(request: pytest.FixtureRequest) -> Path:
    """The folder of exact cases."""
    return _shared_folder(request.config, "truth")


@pytest.fixture(scope="session")
def recordings(request: pytest.FixtureRequest) -> Path:
    """The folder of recorded motion."""
    return _shared_folder(request.config, "data")


def _shared_folder(config: pytest.Config, name: str) -> Path:
    shared: Path = config.getoption("--shared") or config.rootpath.parent / "shared"
    folder = shared / name
    if not folder.is_dir():
        reason = f"no folder {folder}: give the one that holds {name}/ with --shared FOLDER"
        if config.getoption("--require-tools"):
            pytest.fail(reason, pytrace=False)
        pytest.skip(reason)
    return folder
