"""Bundle: the files of one design and what is known of them. Only a `VerifiedBundle` can be written to disk."""

from __future__ import annotations

import errno
import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path

from qcone import __version__
from qcone.backends.counts import Counts
from qcone.backends.page import Driver
from qcone.contract import FLAGS, GCC_FLAGS, INTERFACE, Facts, command, rounding, truncation
from qcone.errors import CheckError, UsageError
from qcone.formats.floating import Floating
from qcone.ir.statement import Program, Role
from qcone.passes.fixed_point import Proved

MANIFEST = "manifest.json"


@dataclass(frozen=True)
class Lowered:
    """A program in machine operations. In fixed point `machine` is in integers, and `macs` what that was expanded from.

    `proved` is what is known of it, there.
    """

    machine: Program
    macs: Program | None = None
    proved: Proved | None = None


@dataclass(frozen=True)
class Bundle:
    """A design, its programs in both languages, and its C.

    `written` is the program as its author wrote it, `machine` what is emitted; `header`, `source`, `run` and
    `main` are texts; `driver` says how the batch loop lays out its rows; `macs` is what a fixed-point `machine` was
    expanded from.
    """

    facts: Facts
    written: Program
    machine: Program
    header: str
    source: str
    run: str
    main: str
    driver: Driver
    macs: Program | None = None

    @property
    def name(self) -> str:
        """Return the design's name, which is the name of its folder, files and functions."""
        return self.facts.design.name

    @property
    def driver_input(self) -> str:
        """Return the name of what an update is handed."""
        return self.machine.routine("update").having(Role.INPUT)[0].name

    @property
    def files(self) -> Mapping[str, str]:
        """Return the emitted files but the manifest, by path inside the design's folder."""
        return {
            f"src/{self.name}.h": self.header,
            f"src/{self.name}.c": self.source,
            f"test/{self.name}_run.c": self.run,
        }

    @property
    def sources(self) -> Mapping[str, str]:
        """Return what a compiler needs for the shared object under test."""
        return {Path(path).name: text for path, text in self.files.items()}


@dataclass(frozen=True)
class Evidence:
    """What was compared: rows of vectors, differing bits, and what compiled the C."""

    rows: int
    differing_bits: int
    compiler: str
    level: str


@dataclass(frozen=True)
class VerifiedBundle:
    """A bundle whose text was read back and whose bits were compared; made by `verify.accept` alone."""

    bundle: Bundle
    evidence: Evidence

    @property
    def contents(self) -> Mapping[str, str]:
        """Return every file to be written, the manifest with them."""
        return with_manifest(self.bundle)


def with_manifest(bundle: Bundle) -> Mapping[str, str]:
    """Return the emitted files and their manifest; the same on every machine."""
    facts = bundle.facts
    chosen = facts.exponential
    manifest = {
        "schema_version": 1,
        "generator": f"qcone {__version__}",
        "command": command(facts.design),
        "design": bundle.name,
        "design_digest": facts.digest,
        "interface": INTERFACE,
        "algorithm": facts.algorithm.name,
        "source": str(facts.algorithm.source),
        "number": facts.number.name,
        "flags": FLAGS,
        "flags_gcc": GCC_FLAGS,
        "ranges": {
            "interval_s": str(facts.known.interval),
            "rate_rad_s": str(facts.known.rate),
            "increment_rad": str(facts.known.increment),
            "rotation_vector_rad": str(chosen.phi_max) if chosen else None,
            **({"correction_rad": str(facts.known.correction)} if facts.known.correction else {}),
        },
        "truncation": truncation(facts),
        "rounding": rounding(facts),
        "counts": {
            routine: {level: _counts(counts, facts) for level, counts in levels.items()}
            for routine, levels in facts.counts.items()
        },
        "files": {path: digest(text) for path, text in bundle.files.items()},
    }
    manifest["manifest"] = digest(json.dumps(manifest, indent=2))
    return {**bundle.files, MANIFEST: json.dumps(manifest, indent=2) + "\n"}


def _counts(counts: Counts, facts: Facts) -> dict[str, int]:
    """Return the counts that apply: only integers are shifted."""
    found = asdict(counts)
    if isinstance(facts.number, Floating):
        del found["shift"]
    return found


def digest(text: str) -> str:
    """Return the SHA-256 of a text file's bytes."""
    return hashlib.sha256(text.encode()).hexdigest()


@dataclass(frozen=True)
class FileStatus:
    """How a file on disk stands to what would be written: `fresh`, `stale`, `edited` or `missing`."""

    path: str
    status: str


def compare(contents: Mapping[str, str], folder: Path) -> tuple[FileStatus, ...]:
    """Tell, for each file, whether it is fresh, stale (made from other inputs), edited by hand, or missing.

    A file is edited when its bytes are not those its own manifest recorded.
    """
    recorded = _recorded(folder)
    result = []
    for path, text in contents.items():
        file = folder / path
        if not file.is_file():
            status = "missing"
        else:
            found = file.read_bytes()
            if found == text.encode():
                status = "fresh"
            elif (path == MANIFEST and not _is_its_own(found)) or (
                path != MANIFEST and recorded.get(path) != hashlib.sha256(found).hexdigest()
            ):
                status = "edited"
            else:
                status = "stale"
        result.append(FileStatus(path, status))
    return tuple(result)


def _is_its_own(manifest: bytes) -> bool:
    """Tell whether a manifest is as some version of ours wrote it: its own digest is that of the rest."""
    try:
        content = json.loads(manifest)
        said = content.pop("manifest")
    except (ValueError, KeyError, AttributeError, TypeError):
        return False
    return bool(said == digest(json.dumps(content, indent=2)))


def _recorded(folder: Path) -> Mapping[str, str]:
    try:
        files = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))["files"]
    except (OSError, ValueError, KeyError, TypeError):
        return {}
    return files if isinstance(files, dict) else {}


def write(bundles: Sequence[VerifiedBundle], root: Path, force: bool = False) -> tuple[tuple[FileStatus, ...], ...]:
    """Write verified bundles, each into the folder of its name under `root`; return what each file was before.

    Raises CheckError for a file edited by hand, unless `force`; UsageError when a folder cannot be written.
    Every file of every bundle is written beside its place before the first one is moved there, a bundle's
    manifest last: what fails leaves the files of before.
    """
    folders = [root / each.bundle.name for each in bundles]
    before = tuple(compare(each.contents, folder) for each, folder in zip(bundles, folders, strict=True))
    for files, folder in zip(before, folders, strict=True):
        edited = [each.path for each in files if each.status == "edited"]
        if edited and not force:
            raise CheckError(
                f"{folder / edited[0]}: edited by hand; its changes would be lost: move them into the design, or "
                "overwrite the file with --force"
            )
    temporary: list[tuple[Path, Path]] = []
    made: list[Path] = []
    folder = root
    try:
        for each, folder in zip(bundles, folders, strict=True):
            for path, text in each.contents.items():
                place = folder / path
                made += _make_folder(place.parent)
                if place.is_dir():
                    raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
                beside = place.with_name(place.name + ".partial")
                temporary.append((beside, place))
                beside.write_bytes(text.encode())
        for beside, place in temporary:
            os.replace(beside, place)
    except OSError as error:
        for beside, _ in temporary:
            beside.unlink(missing_ok=True)
        for empty in reversed(made):
            with suppress(OSError):
                empty.rmdir()
        reason = error.strerror or str(error)
        raise UsageError(f"{folder}: cannot write the design there: {reason}; choose another folder with -o") from error
    return before


def _make_folder(folder: Path) -> list[Path]:
    """Make a folder and those above it; return the new ones, outermost first."""
    new = [each for each in (folder, *folder.parents) if not each.exists()]
    folder.mkdir(parents=True, exist_ok=True)
    return new[::-1]
