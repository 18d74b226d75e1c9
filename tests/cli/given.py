"""A small design, rows of a report read back, and a look at a whole folder."""

from __future__ import annotations

import json
from pathlib import Path

GOOD = """\
[design.good]
algorithm = "rotation-vector"
subsamples = 2
outputs = ["quaternion", "dcm"]
imu = { update_hz = 100, max_rate_dps = 573 }
number = { format = "float32" }
"""


def everything(folder: Path) -> dict[str, bytes]:
    """Return every file below a folder with what it holds, and every folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() if path.is_file() else b"" for path in folder.rglob("*")
    }


COUNTS = [
    *("design", "algorithm", "form", "level"),
    *("multiply", "power_of_two", "divide", "add", "subtract", "negate", "square_root", "trigonometric"),
    *("compare", "select", "shift", "word_bits", "product_bits"),
]


def rows_of(run, *words: str) -> list[dict[str, object]]:
    result = run(*words, "--format", "json")
    document = json.loads(result.stdout)
    assert list(document) == ["schema_version", "command", "rows"]
    assert document["schema_version"] == 1
    assert document["command"] == words[0]
    rows: list[dict[str, object]] = document["rows"]
    assert rows
    assert all(not isinstance(value, list | dict) for row in rows for value in row.values()), "flat rows"
    return rows
