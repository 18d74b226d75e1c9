"""Generate: bring the folders of designs up to date, or tell how they stand."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from pathlib import Path

from qcone import verify
from qcone.bundle import compare, with_manifest, write
from qcone.design import Design
from qcone.pipeline import build, build_all

Row = dict[str, object]


def generate(designs: Iterable[Design], folder: Path, force: bool, cc: str | None = None) -> list[Row]:
    """Write every design, verified, into its folder; all are built and accepted before the first is written.

    Returns one row a file: `created`, `changed` or `same`. Raises the errors of `build`, `verify.accept` and `write`.
    """
    accepted = [verify.accept(bundle, cc) for bundle in build_all(designs)]
    rows: list[Row] = []
    words = {"missing": "created", "fresh": "same"}
    for each, files in zip(accepted, write(accepted, folder, force), strict=True):
        for file in files:
            rows.append(_row(each.bundle.name, file.path, words.get(file.status, "changed"), each.contents[file.path]))
    return rows


def status(designs: Iterable[Design], folder: Path) -> list[Row]:
    """Return one row a file: `fresh`, `stale`, `edited` or `missing`. Nothing is compiled or written."""
    rows = []
    for design in designs:
        contents = with_manifest(build(design))
        for file in compare(contents, folder / design.name):
            rows.append(_row(design.name, file.path, file.status, contents[file.path]))
    return rows


def _row(design: str, path: str, state: str, text: str) -> Row:
    return {"design": design, "file": path, "status": state, "bytes": len(text.encode())}


def diff(designs: Sequence[Design], folder: Path) -> str:
    """Return a unified diff from the files on disk to what would be written; empty when nothing would change."""
    text: list[str] = []
    for design in designs:
        for path, new in with_manifest(build(design)).items():
            file = folder / design.name / path
            old = file.read_text(encoding="utf-8") if file.is_file() else ""
            name = f"{design.name}/{path}"
            text += difflib.unified_diff(old.splitlines(True), new.splitlines(True), f"a/{name}", f"b/{name}")
    return "".join(text)
