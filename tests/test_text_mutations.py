"""A change of the C text that changes what it says is found by reading it back, before any vector runs."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
import pytest

from qcone import verify
from qcone.backends.expected import differences
from qcone.bundle import Bundle
from qcone.errors import CheckError
from qcone.targets.compiler import Compiler
from qcone.vectors import draw
from shipped import DESIGNS, shipped

CHANGED = [
    "picard_1_4_float32",
    "rotation_vector_4_expanded_float64",
    "rotation_vector_3_coning_float32_compensated",
    "rotation_vector_1_previous_2_float32",
    "rotation_vector_3_coning_rate_float32",
    "quaternion_taylor_3_10_rolled_float32",
    "rotation_vector_3_coning_euler_zyx_float32",
    "adams_moulton_4_runge_kutta_4_float64",
    "dcm_taylor_3_10_rolled_float64",
]
PLACES = 5
"""Places changed, one at a time, of every kind in every design."""

LITERAL = re.compile(r"(?<![\w.])(\d+\.\d+(?:e[+-]\d+)?)(F?)(?!\w)")
BINARY = re.compile(r"= (\S+(?: /\* \S+ \*/)?) ([-+*]) (\S+(?: /\* \S+ \*/)?);")
OTHER_OPERATOR = {"+": "-", "-": "+", "*": "+"}


def without_comments(line: str) -> str:
    """Blank out comments, so that nothing in them is changed."""
    return re.sub(r"/\*.*?\*/", lambda match: " " * len(match[0]), line)


def literal(line: str) -> Iterator[str]:
    """One unit in the last place, up and down."""
    for match in LITERAL.finditer(without_comments(line)):
        kind = np.float32 if match[2] else np.float64
        for end in (np.inf, -np.inf):
            changed = np.nextafter(kind(match[1]), kind(end))
            yield (
                line[: match.start()]
                + f"{changed:.17g}{'' if '.' in f'{changed:.17g}' else '.0'}"
                + match[2]
                + line[match.end() :]
            )


def operator(line: str) -> Iterator[str]:
    for match in BINARY.finditer(line):
        yield line[: match.start(2)] + OTHER_OPERATOR[match[2]] + line[match.end(2) :]


def operand_order(line: str) -> Iterator[str]:
    for match in BINARY.finditer(line):
        if match[1] != match[3]:
            yield f"{line[: match.start()]}= {match[3]} {match[2]} {match[1]};"


def operand(line: str) -> Iterator[str]:
    """Another component of the same vector."""
    for match in re.finditer(r"(?<=[= ])(\w+)_([xyz])(?=[; ])", without_comments(line)):
        if match.start() > line.find("="):
            other = "xyz"[("xyz".index(match[2]) + 1) % 3]
            yield line[: match.start(2)] + other + line[match.end(2) :]


def index(line: str) -> Iterator[str]:
    for match in re.finditer(r"\[(\d+)\]", line):
        yield line[: match.start()] + f"[{int(match[1]) + 1}]" + line[match.end() :]


def type_(line: str) -> Iterator[str]:
    for match in re.finditer(r"\b(float|double)\b", without_comments(line)):
        yield line[: match.start()] + ("double" if match[1] == "float" else "float") + line[match.end() :]


def qualifier(line: str) -> Iterator[str]:
    if line.startswith("    const "):
        yield line.replace("const ", "", 1)


def dropped(line: str) -> Iterator[str]:
    yield ""


def added(line: str) -> Iterator[str]:
    """The statement once more: under another name where it defines one, else the same write again."""
    yield line + "\n" + re.sub(r"^(    const \w+ )(\w+)( =.*)$", r"\1\2_again\3", line)


KINDS: dict[str, Callable[[str], Iterator[str]]] = {
    "literal": literal,
    "operator": operator,
    "operand order": operand_order,
    "operand": operand,
    "index": index,
    "type": type_,
    "qualifier": qualifier,
    "dropped statement": dropped,
    "added statement": added,
}


def statements(source: str) -> list[int]:
    """Return the numbers of the lines that hold a statement."""
    lines = source.splitlines()
    return [k for k, line in enumerate(lines) if line.startswith("    ") and line.endswith(";")]


def changes(source: str, kind: str) -> Iterator[str]:
    lines = source.splitlines()
    for k in statements(source):
        for changed in KINDS[kind](lines[k]):
            yield "\n".join([*lines[:k], changed, *lines[k + 1 :]]) + "\n"


def found(name: str, source: str) -> list[str]:
    bundle = shipped(name)
    return differences(bundle.machine, bundle.facts.number, bundle.header, source)


@pytest.mark.parametrize("name", DESIGNS)
def test_the_text_as_it_is_has_no_differences(name: str) -> None:
    assert found(name, shipped(name).source) == []


@pytest.mark.parametrize("name", CHANGED)
@pytest.mark.parametrize("kind", KINDS)
def test_a_changed_text_is_found(kind: str, name: str) -> None:
    every = list(changes(shipped(name).source, kind))
    assert len(every) >= 2
    for changed in random.Random(f"{kind} {name}").sample(every, min(PLACES, len(every))):
        assert changed != shipped(name).source
        assert found(name, changed), changed


@pytest.mark.parametrize("name", CHANGED)
def test_statements_in_another_order_are_found(name: str) -> None:
    lines = shipped(name).source.splitlines()
    pairs = [k for k in statements(shipped(name).source) if k + 1 in set(statements(shipped(name).source))]
    for k in random.Random(name).sample(pairs, PLACES):
        swapped = [*lines[:k], lines[k + 1], lines[k], *lines[k + 2 :]]
        assert found(name, "\n".join(swapped) + "\n")


def test_the_difference_names_function_statement_and_both_texts() -> None:
    name = "rotation_vector_3_coning_float32"
    source = shipped(name).source.replace(
        "const float p_x = dtheta1_x + dtheta3_x;", "const float p_x = dtheta1_x - dtheta3_x;"
    )
    said = found(name, source)
    assert len(said) == 1
    assert said[0].startswith(f"{name}_update: statement ")
    assert "p_x = subtract(dtheta1_x, dtheta3_x)" in said[0]
    assert "p_x = add(dtheta1_x, dtheta3_x)" in said[0]


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_compiled_or_run_for_a_changed_text(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object) -> None:
        raise AssertionError("a vector was drawn, or a compiler asked")

    for each in ("draw", "first_compiler", "compilers", "build_shared", "model_words"):
        monkeypatch.setattr(verify, each, never)
    bundle = shipped("rotation_vector_3_coning_float32")
    changed = replace(bundle, source=next(changes(bundle.source, kind)))
    with pytest.raises(CheckError, match="the C text is not the routine"):
        verify.accept(changed)
    (outcome,) = verify.verify(changed, 100)
    assert (outcome.status, outcome.failed) == ("refused", True)


def bits_that_notice(bundle: Bundle, compiler: Compiler, kind: str, lines: str, places: int) -> list[int]:
    """Return in how many bits changes of the update, on lines of that pattern, show in a run of 2000 rows."""
    start = bundle.source.index(f"void {bundle.name}_update(")
    end = bundle.source.index("\n}\n", start) + 3
    update = bundle.source[start:end]
    vectors = draw(bundle, 2000)
    expected = verify.model_words(bundle, vectors)
    whole = update.splitlines()
    every = [
        changed
        for changed in changes(update, kind)
        if any(re.search(lines, line) for line, other in zip(whole, changed.splitlines(), strict=True) if line != other)
    ]
    found = []
    for changed in random.Random(kind).sample(every, places):
        text = bundle.source[:start] + changed + bundle.source[end:]
        library = verify.open_library(replace(bundle, source=text), compiler, "-O2")
        words, _ = verify.c_words(bundle, library, vectors)
        found.append(verify.differing_bits(words, expected))
    return found


LARGE_TERMS = r"const float (k_[xyz]|s|e_1) ="
SMALL_TERMS = r"const float (u_1|s_1) ="


@pytest.mark.parametrize(
    ("kind", "lines"), [("literal", LARGE_TERMS), ("operator", "."), ("operand", "."), ("index", ".")]
)
def test_the_bits_notice_it_too(kind: str, lines: str, first_compiler: Compiler) -> None:
    """Were the text not read back, the vectors would still tell it from the model."""
    bundle = shipped("rotation_vector_3_coning_float32")
    assert min(bits_that_notice(bundle, first_compiler, kind, lines, 3)) > 0


def test_the_bits_cannot_notice_the_last_place_of_a_small_term(first_compiler: Compiler) -> None:
    """That is why the text is read back: beside the term it is added to, one unit is rounded away."""
    bundle = shipped("rotation_vector_3_coning_float32")
    assert max(bits_that_notice(bundle, first_compiler, "literal", SMALL_TERMS, 4)) == 0
