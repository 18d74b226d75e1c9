"""What reading a recording says of one that it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from qcone.errors import UsageError
from qcone.studies.recording import read_recording


def refusal(path: Path, content: str | bytes, kind: str = "increment", **options: object) -> str:
    """Write the file, read it, and return the message with the folder taken off."""
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    with pytest.raises(UsageError) as caught:
        read_recording(path, kind, **options)  # type: ignore[arg-type]
    assert caught.value.exit_code == 2
    return str(caught.value).replace(str(path), "walk.csv")
