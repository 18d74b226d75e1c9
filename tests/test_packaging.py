"""What is built is whole: templates and designs travel in the wheel, and the installed tool needs no checkout."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

import pytest

from qcone import __version__

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "generator" / "qcone"
INFO = f"qcone-{__version__}.dist-info/"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory, missing_tool: Callable[[str], NoReturn]) -> Path:
    """Build the sdist, and the wheel from it: what the sdist lacks, the wheel lacks."""
    for tool in ("build", "hatchling"):
        if importlib.util.find_spec(tool) is None:
            missing_tool(f"{tool} (pip install -e '.[test]')")
    folder = tmp_path_factory.mktemp("built")
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(folder), str(ROOT)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


@pytest.fixture(scope="module")
def wheel(built: Path) -> dict[str, bytes]:
    """The files of the wheel by name."""
    (path,) = built.glob("*.whl")
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


@pytest.fixture(scope="module")
def sdist(built: Path) -> dict[str, bytes]:
    """The files of the sdist by name, its top folder left out."""
    (path,) = built.glob("*.tar.gz")
    found = {}
    with tarfile.open(path) as archive:
        for member in archive.getmembers():
            file = archive.extractfile(member)
            if file is not None:
                found[member.name.partition("/")[2]] = file.read()
    return found


@pytest.fixture(scope="module")
def installed(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install the wheel alone into a folder; what it depends on is found where it is."""
    folder = tmp_path_factory.mktemp("installed")
    (path,) = built.glob("*.whl")
    pip = ("-m", "pip", "install", "-q", "--disable-pip-version-check", "--no-deps", "--no-index")
    command = [sys.executable, *pip, "--target", str(folder), str(path)]
    subprocess.run(command, check=True, capture_output=True)
    return folder


def files_under(folder: Path) -> dict[str, bytes]:
    """Return the files below a folder, caches left out, by their place in it."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }


def run(installed: Path, folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run the installed tool in a folder outside the checkout."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    environment["PYTHONPATH"] = str(installed)
    command = [sys.executable, "-P", *arguments]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def test_wheel_holds_the_package_and_the_templates_and_nothing_else(wheel: dict[str, bytes]) -> None:
    wanted = {f"qcone/{name}": data for name, data in files_under(PACKAGE).items()}
    wanted |= {f"qcone/templates/{name}": data for name, data in files_under(ROOT / "templates").items()}
    inside = {name: data for name, data in wheel.items() if not name.startswith(INFO)}
    assert sorted(inside) == sorted(wanted)
    assert inside == wanted


@pytest.mark.parametrize(
    "name",
    [
        "qcone/py.typed",
        "qcone/templates/c/routine.c.j2",
        "qcone/designs/rotation_vector.toml",
        "qcone/targets/ubsan_reports.c",
        f"{INFO}licenses/LICENSE",
    ],
)
def test_wheel_holds(wheel: dict[str, bytes], name: str) -> None:
    assert name in wheel


def test_wheel_starts_the_command_line(wheel: dict[str, bytes]) -> None:
    assert wheel[f"{INFO}entry_points.txt"].decode() == "[console_scripts]\nqcone = qcone.cli:main\n"


def test_sdist_holds_the_checkout(sdist: dict[str, bytes]) -> None:
    for top in ("generator", "templates", "c_out", "tests"):
        wanted = {f"{top}/{name}": data for name, data in files_under(ROOT / top).items()}
        assert {name: data for name, data in sdist.items() if name.startswith(f"{top}/")} == wanted
    rest = {name for name in sdist if "/" not in name}
    assert rest == {".gitignore", "CHANGELOG.md", "LICENSE", "PKG-INFO", "README.md", "pyproject.toml"}


def test_installed_tool_counts_outside_the_checkout(installed: Path, tmp_path: Path) -> None:
    where = run(installed, tmp_path, "-c", "import qcone; print(qcone.__file__)")
    assert Path(where.stdout.strip()).is_relative_to(installed), where.stderr
    done = run(installed, tmp_path, "-m", "qcone", "counts", "rotation-vector", "--subsamples", "3", "--format", "json")
    assert (done.returncode, done.stderr) == (0, "")
    rows = json.loads(done.stdout)["rows"]
    assert ("factored", "emitted") in {(row["form"], row["level"]) for row in rows}
    assert list(tmp_path.iterdir()) == []


def test_installed_templates_and_designs_are_those_of_the_checkout(installed: Path, tmp_path: Path) -> None:
    """c_out of the checkout is fresh by the designs and templates of the installed package."""
    designs = sorted(str(path) for path in (installed / "qcone" / "designs").glob("*.toml"))
    command = ("-m", "qcone", "generate", *designs, "--check", "-o", str(ROOT / "c_out"), "--format", "csv")
    done = run(installed, tmp_path, *command)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout


def test_installed_script_answers(installed: Path, tmp_path: Path) -> None:
    (script,) = (installed / "bin").iterdir()
    done = run(installed, tmp_path, str(script), "--version")
    assert (done.returncode, done.stdout) == (0, f"qcone, version {__version__}\n")
