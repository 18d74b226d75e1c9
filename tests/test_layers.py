"""Imports point one way: from the command line down to the two languages, never up and never sideways."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "generator" / "qcone"

LAYERS: tuple[frozenset[str], ...] = (
    frozenset({"elimination", "errors"}),
    frozenset({"formats"}),
    frozenset({"ir", "design"}),
    frozenset({"algorithms", "passes", "backends", "targets", "reference"}),
    frozenset(
        {
            *(
                "admission",
                "assembly",
                "bundle",
                "contract",
                "cost",
                "declaration",
                "draws",
                "on_avr",
                "on_board",
                "reconciliation",
            ),
            *("on_target", "outcomes", "reconciliation", "routine_contract"),
            *(
                "pipeline",
                "printing",
                "products",
                "registry",
                "sensor",
                "stage_contract",
                "stage_routines",
                "state_routines",
            ),
            *("stepwise", "unit_vectors", "unit_words", "vectors", "verify", "words"),
        }
    ),
    frozenset({"studies", "reports"}),
    frozenset({"cli"}),
    frozenset({"__main__"}),
)
"""From the ground up. A room imports from lower layers and from itself."""

ONE_STOREY = LAYERS[4]
"""Modules of one layer that may use one another; they are one step of the way, split by idea."""

SEES_ONLY: Mapping[str, frozenset[str]] = {
    "algorithms": frozenset({"qcone.algorithms", "qcone.elimination", "qcone.ir.real", "qcone.errors"}),
    "reference": frozenset({"qcone.reference", "numpy"}),
    "__init__": frozenset({"qcone.ir.real"}),
    "__main__": frozenset({"qcone.cli"}),
}
"""Rooms that see less than their layer: what they may import beside the standard library."""

NEVER_SEES: Mapping[str, frozenset[str]] = {"targets": frozenset({"qcone.ir", "qcone.backends", "qcone.passes"})}
ONE_DOOR = ("click", "cffi", "jinja2", "pycparser", "unicorn", "capstone", "elftools")
"""Packages that one module alone imports; the command line, which is one package, counts as one."""

LONGEST = 300


@dataclass(frozen=True)
class Import:
    """One name imported by one line: `module` as written, made absolute."""

    place: str
    importer: str
    module: str

    @property
    def room(self) -> str:
        """Return the room of the package that is imported; empty for another package, `qcone` for its top."""
        parts = self.module.split(".")
        if parts[0] != "qcone":
            return ""
        return parts[1] if len(parts) > 1 else "qcone"


def modules_of(package: Path) -> dict[str, Path]:
    """Return the modules of a package by dotted name inside it: `ir.real`, `cli`, `ir.__init__`."""
    return {".".join(path.relative_to(package).with_suffix("").parts): path for path in sorted(package.rglob("*.py"))}


def imports_of(package: Path) -> Iterator[Import]:
    """Yield every import, in functions and under TYPE_CHECKING too; a submodule taken by `from` is a module."""
    modules = modules_of(package)
    known = {name.removesuffix(".__init__") for name in modules}
    for name, path in modules.items():
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            place = f"{package.name}/{path.relative_to(package).as_posix()}:{getattr(node, 'lineno', 0)}"
            if isinstance(node, ast.Import):
                for alias in node.names:
                    yield Import(place, name, alias.name)
            elif isinstance(node, ast.ImportFrom):
                base = _absolute(node, name)
                for alias in node.names:
                    whole = f"{base}.{alias.name}"
                    is_module = whole.removeprefix("qcone.") in known and whole.startswith("qcone.")
                    yield Import(place, name, whole if is_module else base)


def _absolute(node: ast.ImportFrom, importer: str) -> str:
    if not node.level:
        return node.module or ""
    above = ["qcone", *importer.split(".")][: -node.level]
    return ".".join([*above, *([node.module] if node.module else [])])


def violations(package: Path) -> list[str]:
    """Return every import that breaks the rule, as `file:line: who may not import what`."""
    return [f"{each.place}: {reason}" for each in imports_of(package) for reason in _reasons(each)]


def _reasons(each: Import) -> Iterator[str]:
    room = each.importer.split(".")[0]
    if room in SEES_ONLY:
        inside = any(_within(each.module, allowed) for allowed in SEES_ONLY[room])
        if not inside and each.module.split(".")[0] not in sys.stdlib_module_names:
            yield f"'{room}' sees only {', '.join(sorted(SEES_ONLY[room]))}, not {each.module}"
        return
    if any(_within(each.module, hidden) for hidden in NEVER_SEES.get(room, ())):
        yield f"'{room}' never sees {each.module}"
        return
    if each.room in ("", "qcone", room) or each.module == "qcone.__version__":
        return
    if _layer(room) is None or _layer(each.room) is None:
        yield f"'{each.room if _layer(room) is not None else room}' stands in no layer"
        return
    here, there = _height(room), _height(each.room)
    if there > here:
        yield f"'{room}' imports upward from '{each.room}'"
    elif there == here and room not in ONE_STOREY:
        yield f"'{room}' imports sideways from '{each.room}'"


def _within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


def _layer(room: str) -> int | None:
    return next((height for height, rooms in enumerate(LAYERS) if room in rooms), None)


def _height(room: str) -> int:
    height = _layer(room)
    assert height is not None
    return height


def cycle(edges: Mapping[str, set[str]]) -> list[str]:
    """Return the modules of one import cycle, or nothing."""
    done: set[str] = set()

    def visit(name: str, path: list[str]) -> list[str]:
        if name in path:
            return [*path[path.index(name) :], name]
        if name in done:
            return []
        for other in sorted(edges.get(name, ())):
            found = visit(other, [*path, name])
            if found:
                return found
        done.add(name)
        return []

    return next((found for name in sorted(edges) if (found := visit(name, []))), [])


def edges_of(package: Path) -> dict[str, set[str]]:
    """Return which modules each module imports; the package's own top, which all may import, left out."""
    known = modules_of(package)
    edges: dict[str, set[str]] = {name: set() for name in known}
    for each in imports_of(package):
        target = each.module.removeprefix("qcone.")
        target = target if target in known else f"{target}.__init__"
        if each.room and target in known and target != each.importer:
            edges[each.importer].add(target)
    return edges


def test_imports_point_one_way() -> None:
    assert violations(PACKAGE) == []


def test_every_room_stands_in_a_layer() -> None:
    rooms = {name.split(".")[0] for name in modules_of(PACKAGE)} - {"__init__"}
    assert rooms == frozenset().union(*LAYERS)


def test_no_modules_import_one_another_in_a_circle() -> None:
    assert cycle(edges_of(PACKAGE)) == []


@pytest.mark.parametrize("name", ONE_DOOR)
def test_package_has_one_door(name: str) -> None:
    doors = sorted({_door(each.place) for each in imports_of(PACKAGE) if _within(each.module, name)})
    assert len(doors) == 1, f"{name} is imported by {', '.join(doors) or 'nobody'}"


def _door(place: str) -> str:
    module = place.rpartition(":")[0]
    return "qcone/cli" if module.startswith("qcone/cli/") else module


def test_no_module_holds_two_ideas() -> None:
    long = {
        f"{path.relative_to(PACKAGE.parent)}: {lines} lines"
        for path in PACKAGE.rglob("*.py")
        if (lines := len(path.read_text(encoding="utf-8").splitlines())) > LONGEST
    }
    assert long == set()


FORBIDDEN = ("util", "utils", "helper", "helpers", "manager", "managers", "common", "misc")


def test_no_module_is_a_drawer_of_odds_and_ends() -> None:
    assert [name for name in modules_of(PACKAGE) if name.rpartition(".")[2] in FORBIDDEN] == []


BROKEN = {
    "ir/real.py": ("from qcone.design import read\n", "'ir' imports sideways from 'design'"),
    "passes/fold.py": ("\nfrom qcone import pipeline\n", "'passes' imports upward from 'pipeline'"),
    "passes/share.py": ("from ..backends.counts import count\n", "'passes' imports sideways from 'backends'"),
    "passes/share2.py": (
        "def f():\n    import qcone.backends.counts\n",
        "'passes' imports sideways from 'backends'",
    ),
    "algorithms/cao.py": (
        "from qcone.ir.machine import MachineOp\n",
        "'algorithms' sees only qcone.algorithms, qcone.elimination, qcone.errors, qcone.ir.real, not qcone.ir.machine",
    ),
    "algorithms/numeric.py": (
        "import numpy as np\n",
        "'algorithms' sees only qcone.algorithms, qcone.elimination, qcone.errors, qcone.ir.real, not numpy",
    ),
    "reference/motions.py": (
        "import qcone.errors\n",
        "'reference' sees only numpy, qcone.reference, not qcone.errors",
    ),
    "targets/host.py": (
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from qcone.ir import real\n",
        "'targets' never sees qcone.ir.real",
    ),
    "studies/sweep.py": ("from qcone.reports import table\n", "'studies' imports sideways from 'reports'"),
    "reports/table.py": ("from qcone import cli\n", "'reports' imports upward from 'cli'"),
    "attic.py": ("from qcone.ir import real\n", "'attic' stands in no layer"),
}


@pytest.mark.parametrize("path", BROKEN)
def test_broken_rule_is_told_with_file_and_line(tmp_path: Path, path: str) -> None:
    package = tmp_path / "qcone"
    for name in ("ir/real.py", "ir/machine.py", "design/read.py", "cli.py", "pipeline.py", "reports/table.py", path):
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text("")
    text, reason = BROKEN[path]
    (package / path).write_text(text)
    line = next(n for n, each in enumerate(text.splitlines(), 1) if "qcone" in each or "numpy" in each or ".." in each)
    assert violations(package) == [f"qcone/{path}:{line}: {reason}"]


def test_circle_is_found() -> None:
    assert cycle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]
    assert cycle({"a": {"b"}, "b": {"c"}, "c": set()}) == []
