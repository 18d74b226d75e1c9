"""The attitude file: exact text, exact round trip, whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from qcone.errors import UsageError
from qcone.studies.attitude_csv import write_attitude

TIMES = np.array([0.01, 0.02])
Q = np.array([[1.0, -0.0, 0.1, 1 / 3], [0.5, 0.5, -0.5, 0.5]])
TEXT = "t_s,q0,q1,q2,q3\n0.01,1,-0,0.10000000000000001,0.33333333333333331\n0.02,0.5,0.5,-0.5,0.5\n"


def test_the_text_is_the_contract(tmp_path: Path) -> None:
    write_attitude(tmp_path / "out.csv", TIMES, Q)
    assert (tmp_path / "out.csv").read_bytes() == TEXT.encode()


def test_raw_words_follow_for_fixed_point(tmp_path: Path) -> None:
    raw = np.array([[2**30, 0, -1, 7], [-(2**31), 2**31 - 1, 5, -5]], dtype=np.int64)
    write_attitude(tmp_path / "out.csv", TIMES, Q, raw)
    lines = (tmp_path / "out.csv").read_text().splitlines()
    plain = TEXT.splitlines()
    assert lines == [
        plain[0] + ",raw0,raw1,raw2,raw3",
        plain[1] + ",1073741824,0,-1,7",
        plain[2] + ",-2147483648,2147483647,5,-5",
    ]


@given(
    rows=arrays(np.float64, (3, 5), elements=st.floats(allow_nan=False)),
    raw=arrays(np.int64, (3, 4), elements=st.integers(-(2**63), 2**63 - 1)),
)
def test_reading_gives_back_every_bit(
    tmp_path_factory: pytest.TempPathFactory, rows: np.ndarray, raw: np.ndarray
) -> None:
    path = tmp_path_factory.mktemp("round") / "trip.csv"
    write_attitude(path, rows[:, 0], rows[:, 1:], raw)
    cells = [line.split(",") for line in path.read_text().splitlines()[1:]]
    assert np.array([[float(cell) for cell in row[:5]] for row in cells]).tobytes() == rows.tobytes()
    assert [[int(cell) for cell in row[5:]] for row in cells] == raw.tolist()


def test_float32_attitudes_are_written_with_their_exact_value(tmp_path: Path) -> None:
    q = Q.astype(np.float32)
    write_attitude(tmp_path / "out.csv", TIMES, q)
    back = np.loadtxt(tmp_path / "out.csv", delimiter=",", skiprows=1)[:, 1:]
    assert back.astype(np.float32).tobytes() == q.tobytes()
    np.testing.assert_array_equal(back, q)


def test_no_updates_leave_the_header(tmp_path: Path) -> None:
    write_attitude(tmp_path / "out.csv", np.zeros(0), np.zeros((0, 4)))
    assert (tmp_path / "out.csv").read_text() == "t_s,q0,q1,q2,q3\n"


@pytest.mark.parametrize(
    ("time_s", "q", "raw", "name"),
    [
        (TIMES, Q[:1], None, "q"),
        (TIMES, Q[:, :3], None, "q"),
        (TIMES, Q, np.zeros((1, 4), dtype=np.int64), "raw"),
        (TIMES[:, np.newaxis], Q, None, "time_s"),
    ],
)
def test_arrays_that_do_not_fit_write_nothing(
    tmp_path: Path, time_s: np.ndarray, q: np.ndarray, raw: np.ndarray | None, name: str
) -> None:
    with pytest.raises(ValueError, match=rf"^{name} has shape"):
        write_attitude(tmp_path / "out.csv", time_s, q, raw)
    assert list(tmp_path.iterdir()) == []


def refusal(path: Path) -> str:
    with pytest.raises(UsageError) as caught:
        write_attitude(path, TIMES, Q)
    return str(caught.value)


HINT = "give -o a file in a folder that exists and is writable"


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    path = tmp_path / "none" / "out.csv"
    assert refusal(path) == f"{path}: cannot be written, No such file or directory, {HINT}"
    assert list(tmp_path.iterdir()) == []


def test_a_folder_in_place_of_the_file(tmp_path: Path) -> None:
    assert refusal(tmp_path) == f"{tmp_path}: cannot be written, Is a directory, {HINT}"
    assert list(tmp_path.iterdir()) == []


def test_the_root_folder_is_no_file() -> None:
    assert refusal(Path("/")) == f"/: cannot be written, Is a directory, {HINT}"


def test_a_file_in_place_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("kept")
    path = tmp_path / "file" / "out.csv"
    assert refusal(path) == f"{path}: cannot be written, Not a directory, {HINT}"
    assert (tmp_path / "file").read_text() == "kept"


def test_a_folder_without_permission(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def denied(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("qcone.studies.attitude_csv.open", denied, raising=False)  # root is never denied
    path = tmp_path / "out.csv"
    assert refusal(path) == f"{path}: cannot be written, Permission denied, {HINT}"
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("failing", ["replace", "write"])
def test_a_failure_half_way_keeps_the_old_file_and_leaves_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: str
) -> None:
    path = tmp_path / "out.csv"
    path.write_text("old")

    def full_disk(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    if failing == "replace":
        monkeypatch.setattr("qcone.studies.attitude_csv.os.replace", full_disk)
    else:
        real_open = open

        class Full:
            def __init__(self, name: Path, mode: str) -> None:
                self.file = real_open(name, mode)

            def __enter__(self) -> Full:
                return self

            def __exit__(self, *_: object) -> None:
                self.file.close()

            def write(self, content: bytes) -> None:
                self.file.write(content[:10])
                full_disk()

        monkeypatch.setattr("qcone.studies.attitude_csv.open", Full, raising=False)
    assert refusal(path) == f"{path}: cannot be written, No space left on device, {HINT}"
    assert [entry.name for entry in tmp_path.iterdir()] == ["out.csv"]
    assert path.read_text() == "old"


def test_an_old_file_is_replaced_and_a_link_is_followed(tmp_path: Path) -> None:
    path, link = tmp_path / "out.csv", tmp_path / "link.csv"
    path.write_text("old")
    link.symlink_to(path)
    write_attitude(link, TIMES, Q)
    assert link.is_symlink()
    assert path.read_text() == TEXT
    assert len(list(tmp_path.iterdir())) == 2


def test_a_device_is_written_to_not_replaced() -> None:
    write_attitude(Path(os.devnull), TIMES, Q)
    assert Path(os.devnull).is_char_device()
