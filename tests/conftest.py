"""Options and folders shared by all tests."""

from __future__ import annotations

from pathlib import Path

import pytest


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
