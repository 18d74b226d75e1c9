"""What the emitted C looks like: one operation a statement, under its equation, and nothing it does not need."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import written
from pycparser import CParser, c_ast

from qcone.backends.parse_back import TYPES
from qcone.bundle import Bundle
from qcone.pipeline import build
from qcone.verify import read_back
from shipped import DESIGNS, shipped

LONGEST = 120
ONE_LINE = ("#define", "#error", "/* Generated")
"""What cannot be broken: a macro, a message, the command that makes the file."""

SMALL = re.compile(r"^static inline .*?\n}\n", re.DOTALL | re.MULTILINE)
"""A small function of fixed point: what stands for one operation."""
ARITHMETIC = {"+", "-", "*", "/"}


def texts(bundle: Bundle) -> dict[str, str]:
    return {**bundle.files, "main": bundle.main}


def functions(bundle: Bundle) -> dict[str, c_ast.FuncDef]:
    """Parse header and source as a C compiler sees them, without the product's own reader."""
    text = re.sub(r"#ifdef __cplusplus\n.*?#endif\n", "", bundle.header, flags=re.DOTALL) + bundle.source
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    text = SMALL.sub("", text)
    text = "\n".join(line for line in text.splitlines() if not line.startswith("#"))
    tree = CParser().parse(TYPES + text)
    return {node.decl.name: node for node in tree.ext if isinstance(node, c_ast.FuncDef)}


class Operations(c_ast.NodeVisitor):
    """Counts the arithmetic of one statement, indexes and loop headers left out."""

    def __init__(self) -> None:
        self.found = 0

    def visit_BinaryOp(self, node: c_ast.BinaryOp) -> None:  # noqa: N802  pycparser's name
        self.found += node.op in ARITHMETIC
        self.generic_visit(node)

    def visit_UnaryOp(self, node: c_ast.UnaryOp) -> None:  # noqa: N802
        self.found += node.op == "-" and not isinstance(node.expr, c_ast.Constant)
        self.generic_visit(node)

    def visit_ArrayRef(self, node: c_ast.ArrayRef) -> None:  # noqa: N802
        """An index is no operation on values."""


def operations(node: c_ast.Node) -> int:
    visitor = Operations()
    visitor.visit(node)
    return visitor.found


def statements(node: c_ast.Compound) -> list[c_ast.Node]:
    """Return the simple statements of a body, those in loops and branches too."""
    found: list[c_ast.Node] = []
    for each in node.block_items or ():
        if isinstance(each, c_ast.For):
            found += statements(each.stmt)
        elif isinstance(each, c_ast.If):
            found += statements(each.iftrue)
            found += statements(each.iffalse) if isinstance(each.iffalse, c_ast.Compound) else []
        else:
            found.append(each)
    return found


@pytest.mark.parametrize("name", DESIGNS)
def test_one_operation_a_const_statement(name: str) -> None:
    for function, node in functions(shipped(name)).items():
        for each in statements(node.body):
            assert operations(each) <= 1, f"{function}: line with {operations(each)} operations"
            if isinstance(each, c_ast.Decl):
                assert each.init is None or "const" in each.quals, f"{function}: {each.name} can change"
            if isinstance(each, c_ast.Assignment) and operations(each):
                assert each.lvalue.field.name == "count", f"{function}: arithmetic in a write"


def test_one_operation_a_statement_in_loops_and_subroutines(tmp_path: Path) -> None:
    found = functions(written.bundle(tmp_path, "rolled"))
    assert "recurrence_turned" in found
    every = [each for node in found.values() for each in statements(node.body)]
    assert {operations(each) for each in every} == {0, 1}


def test_two_operations_would_be_seen() -> None:
    tree = CParser().parse("void f(float a) { const float b = a * a + a; const float c = -a; float d = -1.0F; }")
    assert [operations(each) for each in statements(tree.ext[0].body)] == [2, 1, 0]


@pytest.mark.parametrize("name", DESIGNS)
def test_only_the_contract_is_visible(name: str) -> None:
    bundle = shipped(name)
    called = {callee for routine in bundle.machine.routines for callee in routine.callees}
    hidden = {f"{name}_{word}" for word in ("hold", "start_up", "steady", *called)}
    for function, node in functions(bundle).items():
        static = "static" in node.decl.storage
        assert static == (function in hidden), function
        assert static != (f"{function}(" in bundle.header), function


def test_subroutine_is_static(tmp_path: Path) -> None:
    found = functions(written.bundle(tmp_path, "rolled"))
    assert found["recurrence_turned"].decl.storage == ["static"]


@pytest.mark.parametrize("name", DESIGNS)
def test_layout(name: str) -> None:
    for path, text in texts(shipped(name)).items():
        assert text.endswith("\n"), path
        assert not text.endswith("\n\n"), path
        assert "\n\n\n" not in text, path
        assert "\t" not in text, path
        for number, line in enumerate(text.splitlines(), 1):
            assert line == line.rstrip(), f"{path}:{number}: trailing blanks"
            assert line.startswith(ONE_LINE) or len(line) <= LONGEST, f"{path}:{number}: {len(line)} columns"


def test_long_signatures_and_headings_are_broken(tmp_path: Path) -> None:
    bundle = written.bundle(tmp_path, "rolled", "float64")
    assert max(len(line) for line in bundle.source.splitlines() if not line.startswith(ONE_LINE)) <= LONGEST
    assert re.search(r"^static void recurrence_turned\(\n    const double arg1_in0,", bundle.source, re.MULTILINE)


@pytest.mark.parametrize("name", DESIGNS)
def test_names_are_the_specification_s(name: str) -> None:
    """No numbered temporaries, nothing twice in a function, nothing that C keeps for itself."""
    for function, node in functions(shipped(name)).items():
        names = [each.name for each in statements(node.body) if isinstance(each, c_ast.Decl)]
        assert len(names) == len(set(names)), function
        assert not [each for each in names if re.fullmatch(r"(t|tmp|temp|value)_?\d+", each)], function
        assert not [each for each in names if each.startswith("_")], function


@pytest.mark.parametrize("name", DESIGNS)
def test_no_format_has_literals_of_another(name: str) -> None:
    bundle = shipped(name)
    text = re.sub(r"/\*.*?\*/", " ", bundle.source, flags=re.DOTALL)
    literals = re.findall(r"(?<![\w.])\d+\.\d+(?:e[+-]\d+)?F?", text)
    number = bundle.facts.number.name
    assert bool(literals) == number.startswith("float")
    assert {literal.endswith("F") for literal in literals} <= {number == "float32"}
    assert ("double" in text) == (number == "float64")
    assert ("float" in text.replace(name, "")) == (number == "float32")


@pytest.mark.parametrize("name", DESIGNS)
def test_source_needs_no_library_and_keeps_no_state(name: str) -> None:
    bundle = shipped(name)
    included = set(re.findall(r"#include (\S+)", bundle.header + bundle.source))
    assert included <= {"<float.h>", "<stdint.h>", f'"{name}.h"'}
    text = re.sub(r"/\*.*?\*/", " ", bundle.source, flags=re.DOTALL)
    assert not re.search(r"\b(malloc|sqrt|sin|cos|volatile|goto|while|memcpy|union|asm)\b", text)
    assert not re.search(r"^(static )?(const )?(float|double|int32_t) \w+( =|\[)", text, re.MULTILINE)


@pytest.mark.parametrize("name", DESIGNS)
def test_every_function_has_its_contract(name: str) -> None:
    """Above each prototype: purpose, type, and for what goes in or out its meaning."""
    header = shipped(name).header
    prototypes = re.findall(r"/\*\n((?: \*.*\n)+?) \*/\nvoid (\w+)\(([^;]*)\);", header)
    assert len(prototypes) == len(re.findall(r"^void ", header, re.MULTILINE))
    for contract, function, arguments in prototypes:
        assert "Type of values: " in contract, function
        for argument in re.findall(r"(\w+)\[\d+\]", arguments):
            assert f" {argument}: " in contract, f"{function}: {argument}"
    update = next(contract for contract, function, _ in prototypes if function == f"{name}_update")
    unit = "deg/s" if shipped(name).facts.design.input == "counts" else "rad"
    for word in (unit, "Range: ", "Truncation: "):
        assert word in update
    bounded = re.search(r"Rounding: (not bounded|one update is within [\d.e-]+ of exact arithmetic)", update)
    assert bounded
    assert shipped(name).facts.number.name.startswith("fixed") or bounded[1] == "not bounded"


def test_counter_is_set_by_an_integer() -> None:
    source = shipped("rotation_vector_1_previous_2_float32").source
    assert source.count("state->count = 0;\n") == 2
    assert "state->count = state->count + 1;\n" in source


def test_comment_of_an_author_cannot_close_the_comment(tmp_path: Path) -> None:
    """A heading is the author's text: whatever it holds stays a comment."""
    file = tmp_path / "sly.py"
    file.write_text(
        "from qcone import Source, algorithm, exp, step\n\n"
        '@algorithm("sly", source=Source("cao", "(14)"), subsamples=1)\n'
        "def sly(q, dtheta):\n"
        '    return q * exp(step("phi = theta */ int evil; /*", "(1) */", dtheta[0] + dtheta[0]))\n'
    )
    design = written.design_of_file(f"{file}:sly")
    bundle = build(design)
    read_back(bundle)
    assert "evil" in bundle.source
    assert "evil" not in re.sub(r"/\*.*?\*/", " ", bundle.source, flags=re.DOTALL)
