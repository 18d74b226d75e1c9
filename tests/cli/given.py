"""A small design, and a look at a whole folder."""

from __future__ import annotations

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
