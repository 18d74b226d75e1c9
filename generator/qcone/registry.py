"""Registry: from the words of a design to an algorithm, of the catalogue or of a user's own file."""

from __future__ import annotations

import hashlib
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

from qcone.algorithms import CATALOGUE, family
from qcone.design import AlgorithmEntry, Design, Parameter
from qcone.errors import UsageError
from qcone.ir.specification import Algorithm


def entries() -> tuple[AlgorithmEntry, ...]:
    """Return the catalogue as the table that design files are checked against."""
    return tuple(
        AlgorithmEntry(
            each.id,
            tuple(Parameter(c.name, c.choices, c.default, c.help) for c in each.parameters),
            each.conflicts,
        )
        for each in CATALOGUE
    )


def algorithm_of(design: Design) -> Algorithm:
    """Return the algorithm a design names. A user's file is code: it is imported by its explicit path only.

    Raises UsageError when the file, or the function in it, is not there or is no algorithm.
    """
    if ":" not in design.algorithm:
        return family(design.algorithm).make(design.parameters)
    name, path = design.algorithm.rpartition(":")[2], _file_of(design)
    if not path.is_file():
        raise UsageError(f"{path}: there is no such file; 'algorithm' takes a path from the design file's folder")
    found = vars(_load(path)).get(name)
    if not isinstance(found, Algorithm):
        what = (
            "is not an algorithm: decorate the function with @algorithm" if found is not None else "is not in the file"
        )
        raise UsageError(f"{path.name}: '{name}' {what}")
    return found


def caution_of(design: Design) -> str | None:
    """Return what speaks against a design that is no mistake; None for most, and for a user's own algorithm."""
    return None if ":" in design.algorithm else family(design.algorithm).caution(design.parameters)


def digest_of(design: Design) -> str:
    """Return the SHA-256 of the design; with a user's own file, of its text too, so that its edits show."""
    if ":" not in design.algorithm:
        return design.digest
    text = _file_of(design).read_bytes().replace(b"\r\n", b"\n")
    return hashlib.sha256(design.digest.encode() + text).hexdigest()


def _file_of(design: Design) -> Path:
    return (design.directory or Path()) / design.algorithm.rpartition(":")[0]


def _load(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"qcone_user_{path.stem}", path)
    if spec is None or spec.loader is None:
        raise UsageError(f"{path.name}: not a Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses and pickles of the user's look their module up there
    before = sys.dont_write_bytecode
    sys.dont_write_bytecode = True
    try:
        spec.loader.exec_module(module)
    except UsageError as error:
        raise UsageError(f"{path.name}: {error}") from error
    except (Exception, SystemExit) as error:  # a user's file may fail in any way: it is the user's mistake
        line = getattr(error, "lineno", None) or _line_in(path, error)
        raise UsageError(f"{path.name}:{line}: {type(error).__name__}: {error}") from error
    finally:
        sys.dont_write_bytecode = before
    return module


def _line_in(path: Path, error: BaseException) -> int:
    line, trace = 1, error.__traceback__
    while trace is not None:
        if Path(trace.tb_frame.f_code.co_filename).absolute() == path.absolute():
            line = trace.tb_lineno
        trace = trace.tb_next
    return line
