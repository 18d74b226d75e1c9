"""c_out is what `generate` would write, byte for byte, here and on any other machine, at any other time."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from qcone.bundle import MANIFEST
from qcone.studies.generating import diff, status
from shipped import DESIGNS, FOLDER

ROOT = Path(__file__).parents[1]
C_OUT = ROOT / "c_out"

GENERATE = """
import getpass, hashlib, os, platform, random, socket, sys, time, uuid
from pathlib import Path
from qcone.bundle import with_manifest
from qcone.design import read_designs
from qcone.pipeline import build
from qcone.registry import entries

def refused(*_, **__):
    raise AssertionError("generation asks who, where or when")

for module, name in ((getpass, "getuser"), (os, "getlogin"), (os, "uname"), (platform, "node"), (platform, "uname"),
                     (socket, "gethostname"), (time, "time"), (time, "time_ns"), (time, "strftime"), (uuid, "uuid4"),
                     (uuid, "getnode"), (random, "random")):
    setattr(module, name, refused)
whole = hashlib.sha256()
for file in sorted(Path(sys.argv[1]).glob("*.toml")):
    for design in read_designs(file, entries()):
        for path, text in with_manifest(build(design)).items():
            whole.update(f"{design.name}/{path}\\0{text}\\0".encode())
print(whole.hexdigest())
"""


@pytest.fixture(scope="module")
def folder() -> Path:
    """The committed folder; without it nothing below could fail."""
    assert C_OUT.is_dir()
    return C_OUT


def test_every_file_is_what_generate_would_write(folder: Path) -> None:
    rows = status(DESIGNS.values(), folder)
    assert len(rows) == 4 * len(DESIGNS)
    assert [row for row in rows if row["status"] != "fresh"] == []
    assert diff(list(DESIGNS.values()), folder) == ""


def test_folders_are_the_designs_and_hold_their_files_alone(folder: Path) -> None:
    assert sorted(path.name for path in folder.iterdir()) == sorted(DESIGNS)
    for name in DESIGNS:
        every = {path.relative_to(folder / name).as_posix() for path in (folder / name).rglob("*.*")}
        found = sorted(every - {"cost.json"})
        assert found == [MANIFEST, f"src/{name}.c", f"src/{name}.h", f"test/{name}_run.c"]


def test_shipped_designs_are_those_asked_for() -> None:
    """N = 1 to 4 in both formats, taylor beside coning, every accumulation."""
    base = "rotation_vector_3_coning_"
    wanted = (
        {"rotation_vector_1_"} | {f"rotation_vector_{n}_coning_" for n in (2, 3, 4)} | {"rotation_vector_3_taylor_"}
    )
    names = {f"{name}{number}" for name in wanted for number in ("float32", "float64")}
    names |= {
        f"{base}{number}{accumulate}"
        for number in ("float32", "float64")
        for accumulate in ("", "_standard", "_compensated")
    }
    assert names <= set(DESIGNS)


FOREIGN = {
    "an absolute path": r"(?<![\w.*/<])/(?:usr|home|root|tmp|work|opt|var|etc|Users|private)\b|[A-Za-z]:\\",
    "a home": r"~/|\$HOME|\.\./",
    "a date": r"\b(?:19|20)\d\d-\d\d-\d\d\b|\b\d\d:\d\d:\d\d\b|__DATE__|__TIME__|\bUTC\b",
    "a compiler": r"\bgcc \d|\bclang \d|\bzig\b",
}
"""What would differ on another machine."""


@pytest.mark.parametrize("what", FOREIGN)
def test_nothing_tells_where_or_when_it_was_made(folder: Path, what: str) -> None:
    pattern = re.compile(FOREIGN[what])
    found = [
        f"{path.relative_to(folder)}:{number}: {line}"
        for path in sorted(folder.rglob("*.*"))
        if not (what == "a compiler" and path.name == "cost.json")  # whose figures belong to one
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if pattern.search(line)
    ]
    assert found == []


EXAMPLES = {
    "an absolute path": 'made from "/home/ann/design.toml"',
    "a home": "qcone generate ../design.toml",
    "a date": "made 2024-05-01",
    "a compiler": "verified with gcc 12.2.0",
}


@pytest.mark.parametrize("what", FOREIGN)
def test_pattern_finds_its_example(what: str) -> None:
    assert re.search(FOREIGN[what], EXAMPLES[what])


def test_files_are_plain_text(folder: Path) -> None:
    for path in folder.rglob("*.*"):
        data = path.read_bytes()
        assert data.endswith(b"\n"), path
        assert b"\r" not in data, path
        assert data.isascii(), path


@pytest.fixture(scope="module")
def digests(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Generate everything twice, in other folders, under other hash seeds, locales, zones and users."""
    found = {}
    for seed, zone, locale, user in (("0", "UTC", "C", "ann"), ("4711", "Pacific/Chatham", "tr_TR.UTF-8", "bob")):
        environment = {
            **os.environ,
            "PYTHONHASHSEED": seed,
            "TZ": zone,
            "LC_ALL": locale,
            "USER": user,
            "LOGNAME": user,
        }
        environment |= {"HOSTNAME": f"{user}s-machine", "COLUMNS": "40"}
        environment["PYTHONPATH"] = str(FOLDER.parents[1])
        command = [sys.executable, "-c", GENERATE, str(FOLDER)]
        where = tmp_path_factory.mktemp("elsewhere")
        done = subprocess.run(command, cwd=where, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        found[seed] = done.stdout
    return found


def test_folder_hash_seed_locale_and_zone_leave_no_trace(digests: dict[str, str]) -> None:
    first, second = digests.values()
    assert len(first.strip()) == 64
    assert first == second


def test_designs_read_by_another_path_give_the_same_files(tmp_path: Path) -> None:
    """A design file says the same wherever it lies."""
    for file in FOLDER.glob("*.toml"):
        (tmp_path / file.name).write_bytes(file.read_bytes())
    command = [sys.executable, "-m", "qcone", "generate", *sorted(path.name for path in tmp_path.iterdir())]
    environment = {**os.environ, "PYTHONPATH": str(FOLDER.parents[1])}
    check = [*command, "--check", "-o", str(C_OUT), "--format", "csv"]
    done = subprocess.run(check, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
