"""The contract of the command line: help, rows, layouts, streams, exit codes, and what starting it costs."""

from __future__ import annotations

import csv
import io
import json
import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from given import COUNTS, GOOD, rows_of
from help_texts import COMMANDS, FOLDER, file_of, help_of

import qcone
from qcone import __version__
from qcone.algorithms import CATALOGUE
from qcone.cli import DESIGN_OPTIONS, main
from qcone.design import DESIGN_KEYS, IMU_KEYS, NUMBER_KEYS
from qcone.registry import entries

SOURCES = str(Path(qcone.__file__).parents[1])

VERIFY = [
    *("design", "compiler", "level", "target", "rows", "differing_bits", "first_difference"),
    *("sanitizer_reports", "contracted", "status"),
]
LIST = ["id", "parameters", "order", "counts", "source"]


@pytest.mark.parametrize("command", COMMANDS)
def test_help_is_as_recorded(command: str) -> None:
    """Spaces apart: versions of click break lines differently. After a wanted change run tests/cli/help_texts.py."""
    assert help_of(command).split() == file_of(command).read_text(encoding="utf-8").split()


def test_every_snapshot_has_its_command() -> None:
    assert sorted(path.name for path in FOLDER.iterdir()) == sorted(file_of(command).name for command in COMMANDS)


def test_every_command_is_explained_in_one_sentence() -> None:
    for name, command in main.commands.items():
        text = command.get_short_help_str(200)
        assert text.endswith("."), name
        assert "\n" not in text, name


def test_options_are_the_words_of_design_keys() -> None:
    """But for the number format, which is --number."""
    keys = {key.name for table in (DESIGN_KEYS, IMU_KEYS, NUMBER_KEYS) for key in table}
    keys |= {parameter.name for entry in entries() for parameter in entry.parameters}
    assert {word.replace("-", "_") for word in DESIGN_OPTIONS} - keys == {"number"}


def test_rows_of_list(run) -> None:
    rows = rows_of(run, "list")
    assert {tuple(row) for row in rows} == {tuple(LIST)}
    assert [*dict.fromkeys(row["id"] for row in rows)] == [family.id for family in CATALOGUE]
    assert all(row["order"] and row["counts"] and row["source"] for row in rows)


def test_rows_of_counts(run, good: Path) -> None:
    for words in ((), ("rotation-vector", "--subsamples", "2"), ("good.toml",), ("good.toml", "--form", "as-written")):
        rows = rows_of(run, "counts", *words)
        assert {tuple(row) for row in rows} == {tuple(COUNTS)}
        assert {row["level"] for row in rows} <= {"paper", "paper-convention", "as-written", "shared", "emitted"}
        for row in rows:
            assert all(row[key] is None for key in COUNTS[-5:]), "fixed point alone has these"
            assert all(isinstance(row[key], int) for key in COUNTS[4:-5] if key != "power_of_two")
    assert {row["design"] for row in rows} == {"good"}
    assert {row["design"] for row in rows_of(run, "counts", "picard")} == {None}


def test_rows_of_verify(run, good: Path) -> None:
    rows = rows_of(run, "verify", "good.toml", "--rows", "64")
    assert {tuple(row) for row in rows} == {tuple(VERIFY)}
    for row in rows:
        if row["status"] != "absent":
            assert (row["design"], row["target"], row["rows"], row["differing_bits"]) == ("good", "host", 64, 0)
            assert row["status"] == "ok"
            assert row["first_difference"] is None
            assert (row["contracted"] is None) != (row["sanitizer_reports"] is None), "each line has its own check"


def test_rows_of_generate_and_doctor(run, good: Path) -> None:
    rows = rows_of(run, "generate", "good.toml")
    assert {tuple(row) for row in rows} == {("design", "file", "status", "bytes")}
    rows = rows_of(run, "doctor")
    assert {tuple(row) for row in rows} == {("item", "status", "version", "fix")}


def test_counts_of_the_paper_are_met(run) -> None:
    words = ("rotation-vector", "--subsamples", "3", "--coefficients", "taylor", "--form", "as-written")
    rows = rows_of(run, "counts", *words, "--against", "xu2019")
    (row,) = (row for row in rows if row["level"] == "as-written")
    wanted = {"multiply": 70, "divide": 4, "add": 32, "subtract": 18, "square_root": 1, "trigonometric": 2}
    assert {key: row[key] for key in wanted} == wanted
    assert row["form"] == "as-written"
    assert {row["level"]: row["multiply"] for row in rows}["paper"] == 70


def test_csv_is_read_back(run) -> None:
    rows = list(csv.DictReader(io.StringIO(run("list", "--format", "csv").stdout)))
    assert [list(row) for row in rows] == [LIST] * len(rows)
    assert rows[0]["id"] == "rotation-vector"


def test_result_on_stdout_notes_on_stderr(run, tmp_path: Path) -> None:
    (tmp_path / "turn.csv").write_text("t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad\n0.01,0,0,0.001\n0.02,0,0,0.001\n")
    words = ("replay", "turn.csv", "--algorithm", "rotation-vector", "--number", "float64", "-o", "out.csv")
    result = run(*words)
    assert (result.exit_code, result.stdout) == (0, "")
    assert result.stderr == "note: declared rate taken from the data: --max-rate-dps 5.8\n"
    assert (tmp_path / "out.csv").read_text().startswith("t_s,q0,q1,q2,q3\n0.01,")


def test_quiet_where_nobody_looks(run, tmp_path: Path) -> None:
    """Several designs take a while; without a terminal nothing is said of it."""
    (tmp_path / "two.toml").write_text(GOOD + GOOD.replace("design.good", "design.second"))
    result = run("generate", "two.toml", "--format", "json")
    assert (result.exit_code, result.stderr) == (0, "")
    assert len(json.loads(result.stdout)["rows"]) == 8


def on_terminal(words: list[str], folder: Path, error_only: bool = False, **environment: str) -> tuple[bytes, bytes]:
    """Run qcone on a terminal; return what the terminal got, and stdout where only stderr is the terminal."""
    ours, theirs = pty.openpty()
    settings = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "COLUMNS", "FORCE_COLOR")}
    process = subprocess.Popen(
        [sys.executable, "-m", "qcone", *words],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE if error_only else theirs,
        stderr=theirs,
        env={**settings, "TERM": "xterm-256color", "PYTHONPATH": SOURCES, **environment},
    )
    os.close(theirs)
    shown = b""
    while True:
        try:
            part = os.read(ours, 4096)
        except OSError:  # the other end is closed
            part = b""
        if not part:
            break
        shown += part
    printed = process.stdout.read() if process.stdout else b""
    if process.stdout:
        process.stdout.close()
    os.close(ours)
    assert process.wait() == 0
    return shown, printed


def test_no_color_means_plain(tmp_path: Path) -> None:
    assert b"\x1b[" in on_terminal(["counts"], tmp_path)[0], "a terminal gets a styled head"
    assert b"\x1b[" not in on_terminal(["counts"], tmp_path, NO_COLOR="1")[0]


def test_progress_goes_to_the_terminal_and_not_into_the_result(tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(GOOD + GOOD.replace("design.good", "design.second"))
    words = ["generate", "two.toml", "--dry-run", "--format", "json"]
    shown, printed = on_terminal(words, tmp_path, error_only=True)
    assert b"checking" in shown
    assert [row["status"] for row in json.loads(printed)["rows"]] == ["missing"] * 8


def test_version(run) -> None:
    assert run("--version").stdout == f"qcone, version {__version__}\n"


def test_schema_is_one_for_design_files(run) -> None:
    document = json.loads(run("schema").stdout)
    assert "json-schema.org" in document["$schema"]
    assert "design" in document["properties"]


def test_exit_code_0(run) -> None:
    assert run("list").exit_code == 0


@pytest.mark.parametrize("words", [["nosuch"], ["counts", "--nosuch"], ["generate"], ["counts", "nosuch"], []])
def test_exit_code_2(run, words: list[str]) -> None:
    result = run(*words)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr


def test_exit_code_70_is_a_bug_of_ours_told_without_a_traceback(run, monkeypatch: pytest.MonkeyPatch) -> None:
    from qcone.studies import listing

    def broken() -> None:
        raise RuntimeError("the lamp is out")

    monkeypatch.setattr(listing, "rows", broken)
    result = run("list")
    assert result.exit_code == 70
    assert result.stdout == ""
    assert result.stderr == (
        "internal error: RuntimeError: the lamp is out\n"
        "this is a bug of qcone: please report it with the output of `qcone --traceback ...`\n"
    )
    shown = CliRunner().invoke(main, ["--traceback", "list"])
    assert isinstance(shown.exception, RuntimeError)


HEAVY = ("numpy", "jinja2", "rich", "pydantic", "cffi", "pycparser")


@pytest.mark.parametrize("command", COMMANDS)
def test_help_loads_nothing_heavy(command: str) -> None:
    words = [command, "--help"] if command else ["--help"]
    code = f"import sys\nfrom qcone.cli import main\ntry:\n    main({words!r})\nexcept SystemExit as end:\n"
    code += "    assert not end.code\n"
    assert loaded(code) == set()


def test_importing_qcone_loads_nothing_heavy() -> None:
    assert loaded("import qcone\nqcone.__version__\n") == set()
    assert loaded("from qcone import algorithm, exp\n") == set()


def test_what_is_loaded_is_seen() -> None:
    assert loaded("import numpy\n") == {"numpy"}


def loaded(code: str) -> set[str]:
    """Return the heavy packages a fresh interpreter has loaded after some code."""
    code += f"import sys\nprint('loaded:', *[name for name in {HEAVY!r} if name in sys.modules])\n"
    environment = {**os.environ, "PYTHONPATH": SOURCES}
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return set(done.stdout.splitlines()[-1].removeprefix("loaded:").split())


@pytest.mark.parametrize("words", [["schema"], ["counts", "--format", "json"]])
def test_reader_that_goes_away_is_no_error(words: list[str], tmp_path: Path) -> None:
    command = [sys.executable, "-m", "qcone", *words]
    environment = {**os.environ, "PYTHONPATH": SOURCES}
    process = subprocess.Popen(command, env=environment, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    said = process.stderr.read()
    process.stderr.close()
    assert (process.wait(), said) == (0, b"")
