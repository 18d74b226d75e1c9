"""A change of the C text of a fixed-point design is found by reading it back, its small functions among it."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest

from qcone import verify
from qcone.errors import CheckError
from shipped import shipped
from test_text_mutations import added, dropped, found, index, operand, operand_order, operator, qualifier
from test_text_mutations import without_comments as bare

CHANGED = [
    "rotation_vector_3_coning_fixed32_compensated",
    "rotation_vector_3_coning_even_fixed32",
    "rotation_vector_1_fixed16",
]
PLACES = 6
"""Places changed, one at a time, of every kind in every design."""
NUMBER = re.compile(r"(?<![\w.])(?:INT64_C\((-?\d+)\)|(\d+))(?![\w.\]])")


def literal(line: str) -> Iterator[str]:
    """One more and one less: of a constant, a factor, a limit."""
    for match in NUMBER.finditer(bare(line)):
        group = 1 if match[1] is not None else 2
        for change in (1, -1):
            changed = str(int(match[group]) + change)
            yield line[: match.start(group)] + changed + line[match.end(group) :]


def word(line: str) -> Iterator[str]:
    """A word of another width: of a value, or the cast before a product."""
    for match in re.finditer(r"\bint(16|32|64)_t\b", bare(line)):
        other = {"16": "32", "32": "64", "64": "32"}[match[1]]
        yield line[: match.start(1)] + other + line[match.end(1) :]


def cast(line: str) -> Iterator[str]:
    """No cast before a product: it would be made in too short a word."""
    for match in re.finditer(r"\(int(16|32|64)_t\)", bare(line)):
        yield line[: match.start()] + line[match.end() :]


def function(line: str) -> Iterator[str]:
    """Another number of bits dropped, or another rounding."""
    for match in re.finditer(r"\b(round|round_even|left_of)(_wide|_short)?_(\d+)\(", bare(line)):
        yield line[: match.start(3)] + str(int(match[3]) + 1) + line[match.end(3) :]
        yield line[: match.start(1)] + "floor" + line[match.end(1) :]


KINDS: dict[str, Callable[[str], Iterator[str]]] = {
    "literal": literal,
    "word": word,
    "cast": cast,
    "function": function,
    "operator": operator,
    "operand order": operand_order,
    "operand": operand,
    "index": index,
    "qualifier": qualifier,
    "dropped statement": dropped,
    "added statement": added,
}


def halves(name: str) -> tuple[str, str]:
    """Return a source in two: with the small functions, and from the first routine on."""
    source = shipped(name).source
    at = source.index(f"\nvoid {name}_init(") if f"\nvoid {name}_init(" in source else source.index("\nvoid ")
    return source[:at], source[at:]


def changes(name: str, kind: str) -> Iterator[str]:
    head, body = halves(name)
    lines = body.splitlines()
    for k, line in enumerate(lines):
        # What stands behind a statement says its format and its bound.
        text, mark, remark = line.partition("  /* F")
        if not text.startswith("    ") or not text.endswith(";"):
            continue
        for changed in KINDS[kind](text):
            yield head + "\n".join([*lines[:k], changed + mark + remark, *lines[k + 1 :]]) + "\n"


def small_functions(name: str) -> Iterator[str]:
    """Yield the source with one number or operator of one small function changed, or one function gone."""
    head, body = halves(name)
    lines = head.splitlines()
    for k, line in enumerate(lines):
        if line.startswith("    "):
            for match in re.finditer(r"\b\d+\b", line):
                changed = line[: match.start()] + str(int(match[0]) + 1) + line[match.end() :]
                yield "\n".join([*lines[:k], changed, *lines[k + 1 :]]) + "\n" + body
            for old, new in ((" + ", " - "), (" - ", " + "), (" < ", " > "), (" <= ", " < "), ("~", "-"), (">>", "<<")):
                if old in line:
                    yield "\n".join([*lines[:k], line.replace(old, new, 1), *lines[k + 1 :]]) + "\n" + body
        elif line.startswith("static inline ") and "int32_t x" in line:
            yield "\n".join([*lines[:k], line.replace("int32_t x", "int64_t x"), *lines[k + 1 :]]) + "\n" + body


@pytest.mark.parametrize("name", CHANGED)
@pytest.mark.parametrize("kind", KINDS)
def test_a_changed_text_is_found(kind: str, name: str) -> None:
    every = [each for each in changes(name, kind) if each != shipped(name).source]
    assert len(every) >= 2
    for changed in random.Random(f"{kind} {name}").sample(every, min(PLACES, len(every))):
        assert found(name, changed), changed


@pytest.mark.parametrize("name", CHANGED)
def test_a_changed_small_function_is_found(name: str) -> None:
    every = [each for each in small_functions(name) if each != shipped(name).source]
    assert len(every) > 20
    for changed in random.Random(name).sample(every, 12):
        said = found(name, changed)
        assert said, changed


def test_a_function_that_nothing_calls_is_found() -> None:
    name = CHANGED[0]
    head, body = halves(name)
    more = head + "\nstatic inline int32_t round_63(int64_t x)\n{\n    return (int32_t)(x >> 63);\n}\n" + body
    assert found(name, more)


def test_the_difference_names_the_small_function() -> None:
    name = CHANGED[0]
    changed = shipped(name).source.replace("UINT64_C(2147483648)) >> 32", "UINT64_C(2147483647)) >> 32")
    assert changed != shipped(name).source
    (said,) = found(name, changed)
    assert "round_32" in said


def test_nothing_is_compiled_or_run_for_a_changed_small_function(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object) -> None:
        raise AssertionError("a vector was drawn, or a compiler asked")

    for each in ("draw", "first_compiler", "compilers", "build_shared", "model_words"):
        monkeypatch.setattr(verify, each, never)
    bundle = shipped(CHANGED[0])
    changed = replace(bundle, source=bundle.source.replace(">> 32);", ">> 31);"))
    assert changed.source != bundle.source
    with pytest.raises(CheckError, match="the C text is not the routine"):
        verify.accept(changed)
