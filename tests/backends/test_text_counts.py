"""Counts of the text: what the C executes, found without the routine, and the same as the routine's."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import written
from pycparser import CParser, c_ast

from qcone import verify
from qcone.backends.counts import Counts, count
from qcone.backends.parse_back import TYPES
from qcone.backends.text_counts import count_text
from qcone.bundle import Bundle
from qcone.errors import CheckError
from shipped import DESIGNS, shipped

SMALL = {
    "round_": "shift",
    "floor_": "shift",
    "shift_left_": "shift",
    "low_": "shift",
    "left_of_": "subtract",
    "clamp_": "select",
    "add_": "add",
    "subtract_": "subtract",
    "negate_": "negate",
}
"""What a call of a small function stands for, by how its name begins."""
KINDS = {"+": "add", "-": "subtract", "*": "multiply", "/": "divide", "<": "compare"}


class Tally(c_ast.NodeVisitor):
    """Counts the operators of a function body without loops, by its syntax tree alone.

    What it calls by value is one of the `others`, counted before.
    """

    def __init__(self, others: Mapping[str, Counts]) -> None:
        self.others = others
        self.found: Counter[str] = Counter()

    def visit_BinaryOp(self, node: c_ast.BinaryOp) -> None:  # noqa: N802  pycparser's name
        if node.op == "!=":
            return
        kind = KINDS[node.op]
        if kind == "multiply" and any(self._power_of_two(side) for side in (node.left, node.right)):
            kind = "shift" if any(self._whole(side) is not None for side in (node.left, node.right)) else "power_of_two"
        self.found[kind] += 1
        self.generic_visit(node)

    def visit_FuncCall(self, node: c_ast.FuncCall) -> None:  # noqa: N802
        """A small function is one operation of fixed point."""
        if node.name.name == "INT64_C":
            return
        if node.name.name in self.others:
            self.found.update(asdict(self.others[node.name.name]))
            return
        words = [word for word in SMALL if node.name.name.startswith(word)]
        self.found[SMALL[words[0]]] += 1

    def visit_TernaryOp(self, node: c_ast.TernaryOp) -> None:  # noqa: N802
        self.found["select"] += 1
        self.generic_visit(node)

    def visit_UnaryOp(self, node: c_ast.UnaryOp) -> None:  # noqa: N802
        if node.op == "-" and not isinstance(node.expr, c_ast.Constant):
            self.found["negate"] += 1
        self.generic_visit(node)

    def visit_Assignment(self, node: c_ast.Assignment) -> None:  # noqa: N802
        """The counter of updates is an integer: its advance is no operation of the algorithm."""
        if not isinstance(node.rvalue, c_ast.BinaryOp):
            self.generic_visit(node)

    def visit_ArrayRef(self, node: c_ast.ArrayRef) -> None:  # noqa: N802
        """An index is no operation of the algorithm."""

    def _whole(self, node: c_ast.Node) -> int | None:
        """Return an integer constant; None for anything else. A negative one is no power of two."""
        if isinstance(node, c_ast.FuncCall) and node.name.name == "INT64_C":
            node = node.args.exprs[0]
        return int(node.value) if isinstance(node, c_ast.Constant) and node.type == "int" else None

    def _power_of_two(self, node: c_ast.Node) -> bool:
        whole = self._whole(node)
        if whole is not None:
            return whole > 0 and whole & (whole - 1) == 0
        if isinstance(node, c_ast.UnaryOp):
            node = node.expr
        if not isinstance(node, c_ast.Constant):
            return False
        number = np.float32(node.value.rstrip("F")) if node.value.endswith("F") else float(node.value)
        value = Fraction(float(number))
        while value and value.denominator % 2 == 0:
            value *= 2
        while value and value.numerator % 2 == 0:
            value /= 2
        return value == 1


def _straight(node: c_ast.Node) -> bool:
    if isinstance(node, c_ast.Return):
        return isinstance(node.expr, c_ast.ID)
    return isinstance(node, c_ast.Decl | c_ast.Assignment | c_ast.UnaryOp)


def tallies(bundle: Bundle) -> dict[str, Counts]:
    """Count every function of the text."""
    header = re.sub(r"#ifdef __cplusplus\n.*?#endif\n", "", bundle.header, flags=re.DOTALL)
    text = re.sub(r"/\*.*?\*/", " ", header + bundle.source, flags=re.DOTALL)
    text = re.sub(r"static inline .*?\n}\n", "", text, flags=re.DOTALL)
    tree = CParser().parse(TYPES + "\n".join(line for line in text.splitlines() if not line.startswith("#")))
    found: dict[str, Counts] = {}
    for node in tree.ext:
        if isinstance(node, c_ast.FuncDef) and all(map(_straight, node.body.block_items)):
            tally = Tally(found)
            tally.visit(node.body)
            found[node.decl.name] = Counts(**tally.found)
    return found


@pytest.mark.parametrize("name", DESIGNS)
def test_report_routine_and_two_readings_of_the_text_agree(name: str) -> None:
    bundle = shipped(name)
    text, tally = count_text(bundle.header, bundle.source), tallies(bundle)
    assert bundle.facts.counts
    for routine, levels in bundle.facts.counts.items():
        function = f"{name}_{routine}"
        assert levels["emitted"] == count(bundle.machine.routine(routine)) == text[function]
        assert tally.get(function, text[function]) == text[function]
    for function, counts in tally.items():
        assert text[function] == counts


@pytest.mark.parametrize("name", DESIGNS)
def test_banner_tells_the_counts_of_the_text(name: str) -> None:
    bundle = shipped(name)
    text = count_text(bundle.header, bundle.source)
    lines = re.findall(r"^ \* (\w+) emitted +([\d ]+)$", bundle.header, re.MULTILINE)
    assert lines
    for routine, numbers in lines:
        said = Counts(*_in_order([int(number) for number in numbers.split()]))
        assert said == text[f"{name}_{routine}"]


def _in_order(columns: list[int]) -> list[int]:
    """Bring the banner's columns into the order of the fields."""
    multiply, power_of_two, add, subtract, negate, divide, square_root, trigonometric, compare, select, *shift = columns
    return [multiply, power_of_two, divide, add, subtract, negate, square_root, trigonometric, compare, select, *shift]


def test_rolled_and_written_out_execute_the_same(tmp_path: Path) -> None:
    executed = []
    for loop in ("rolled", "unrolled"):
        bundle = written.bundle(tmp_path, loop)
        text = count_text(bundle.header, bundle.source)["recurrence_update"]
        assert text == count(bundle.machine.routine("update")) == bundle.facts.counts["update"]["emitted"]
        executed.append(text.as_papers_count())
    assert executed[0] == executed[1]
    written_once = products_in_text(written.bundle(tmp_path, "rolled"))
    assert executed[0].multiply > written_once, "a loop is executed more often than it is written"


def products_in_text(bundle: Bundle) -> int:
    body = bundle.source.partition("recurrence_update(")[2].partition("\n}\n")[0]
    return len(re.findall(r"^ +const float \w+ = \S+(?: /\*.*?\*/)? \* ", body, re.MULTILINE))


LOOPS = """
static void part(const float a_in0, float result[1])
{
    const float b = a_in0 * a_in0;
    const float c = b + 1.0F;
    const float d = -c;
    result[0] = d;
}
void whole(const float a[4])
{
    float t[4];
    for (int32_t n = 1; n <= 3; ++n) {
        const float u = a[n] / 3.0F;
        for (int32_t m = n - 1; m <= 2 * n; ++m) {
            const float v = 0.25F * a[n - 1];
            const float w = v - -2.0F;
            float r_result[1];
            part(w, r_result);
            const float r = r_result[0];
            t[n] = r;
        }
    }
}
"""


def test_nested_loops_with_bounds_of_the_outer_counter_and_calls() -> None:
    """Inner turns: n = 1 has m = 0..2, n = 2 has 1..4, n = 3 has 2..6: 3 + 4 + 5 = 12."""
    found = count_text("", LOOPS)
    assert found["part"] == Counts(multiply=1, add=1, negate=1)
    assert found["whole"] == Counts(divide=3, power_of_two=12, subtract=12, multiply=12, add=12, negate=12)


@pytest.mark.parametrize(("factor", "apart"), [("0.5F", 1), ("-4.0F", 1), ("1.0F", 1), ("0.3F", 0), ("0.0F", 0)])
def test_products_by_powers_of_two_are_apart(factor: str, apart: int) -> None:
    found = count_text("", f"void f(const float a[1]) {{ const float b = {factor} * a[0]; }}")["f"]
    assert (found.power_of_two, found.multiply) == (apart, 1 - apart)


def test_branches_count_the_dearer_one() -> None:
    text = "void g(float a[1]) { const float b = a[0] * a[0]; }\nvoid h(float a[1]) { const float b = a[0] + a[0]; }\n"
    text += "void f(s_state *state, float a[1]) { if (state->count < 2) { g(a); } else { h(a); } }\n"
    found = count_text("typedef struct { int32_t count; } s_state;\n", text)
    assert found["f"] == Counts(multiply=1, add=1)


def test_counts_that_do_not_reconcile_are_refused() -> None:
    bundle = shipped("rotation_vector_3_coning_float32")
    levels = dict(bundle.facts.counts)
    emitted = levels["update"]["emitted"]
    levels["update"] = {**levels["update"], "emitted": replace(emitted, multiply=emitted.multiply - 1)}
    claimed = replace(bundle, facts=replace(bundle.facts, counts=levels))
    message = f"{bundle.name}: update: the counts of report, routine and text do not reconcile"
    with pytest.raises(CheckError, match=f"^{re.escape(message)}$"):
        verify.read_back(claimed)


def test_text_that_counts_otherwise_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The text's own count is asked: were it another, nothing would be written."""
    bundle = shipped("rotation_vector_3_coning_float32")
    other = {
        name: replace(counts, add=counts.add + 1) for name, counts in count_text(bundle.header, bundle.source).items()
    }
    monkeypatch.setattr(verify, "count_text", lambda *_: other)
    with pytest.raises(CheckError, match="do not reconcile"):
        verify.accept(bundle)


def test_every_kind_is_named() -> None:
    assert set(asdict(Counts())) == {
        *KINDS.values(),
        *("negate", "power_of_two", "square_root", "trigonometric", "select", "shift"),
    }
