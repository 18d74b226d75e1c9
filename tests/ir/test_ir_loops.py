"""Counted loops from an author's file to bits: rolled into C loops or written out, the same calculation."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from authored import INSIDE, LADDER, ORDER, TAYLOR, bundle_of, paper
from numpy.typing import NDArray
from recurrences import UPDATES, Q, product

from qcone.backends.bittrue import Model, dtype_of
from qcone.backends.counts import Counts
from qcone.bundle import Bundle
from qcone.ir.evaluate import agree, evaluate
from qcone.pipeline import prepare
from qcone.targets.build import warnings
from qcone.targets.compiler import Compiler
from qcone.verify import ACCEPT_ROWS, accept, read_back, verify

F = Fraction
TEXTS = {"taylor": TAYLOR, "ladder": LADDER}
NUMBERS = ("float32", "float64")
LOOPS = ("rolled", "unrolled")
ROWS = 300


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("loops")


@cache
def made(
    folder: Path, text: str, loop: str, number: str = "float32", accumulate: str = "", axes: str = "x,y,z"
) -> Bundle:
    return bundle_of(folder, TEXTS[text], loop=loop, number=number, accumulate=accumulate, axes=axes)


# -- the value -------------------------------------------------------------------------------------------------


def increments(text: str, scale: int | Fraction = 1) -> list[tuple[Fraction, ...]]:
    count = 3 if text == "taylor" else 1
    return [tuple(scale * F(k * k % 19 - 9, 30 + k) for k in range(3 * i + 1, 3 * i + 4)) for i in range(count)]


def flat(vectors: list[tuple[Fraction, ...]]) -> list[Fraction]:
    return [part for vector in vectors for part in vector]


@pytest.mark.parametrize("loop", LOOPS)
@pytest.mark.parametrize("text", TEXTS)
def test_the_routine_means_the_recurrence(folder: Path, text: str, loop: str) -> None:
    dtheta = increments(text)
    routine = made(folder, text, loop).written.routine("update")
    found = evaluate(routine, {"q": list(Q), "dtheta": flat(dtheta)}).blocks["q"]
    assert tuple(found) == UPDATES[text](Q, dtheta)


@pytest.mark.parametrize("loop", LOOPS)
@pytest.mark.parametrize("text", TEXTS)
def test_the_passes_keep_the_meaning(folder: Path, text: str, loop: str) -> None:
    bundle = made(folder, text, loop)
    ready = prepare(bundle.written, bundle.facts.design)
    assert agree(bundle.written.routine("update"), ready.routine("update"))


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("loop", LOOPS)
@pytest.mark.parametrize("text", TEXTS)
def test_the_model_is_near_the_exact_value(folder: Path, text: str, loop: str, number: str) -> None:
    """Increments of 0.1 rad lose no more than the rounding of some twenty operations of the size of q."""
    bundle = made(folder, text, loop, number)
    dtype = dtype_of(bundle.facts.number)
    dtheta = [tuple(F(float(dtype(part))) for part in each) for each in increments(text, F(1, 3))]
    q = tuple(F(float(dtype(part))) for part in Q)
    state = {"q": np.array([[part] for part in map(float, q)], dtype)}
    given = np.array([[float(part)] for part in flat(dtheta)], dtype)
    Model(bundle.machine, bundle.facts.number).run("update", state, {"dtheta": given})
    error = max(abs(F(float(got)) - want) for got, want in zip(state["q"][:, 0], UPDATES[text](q, dtheta), strict=True))
    assert error < 4 * F(float(np.finfo(dtype).eps))


# -- the bits --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "loop", "number"),
    [*(("taylor", loop, number) for loop in LOOPS for number in NUMBERS), ("ladder", "rolled", "float32")],
)
def test_c_and_model_agree(folder: Path, text: str, loop: str, number: str, first_compiler: Compiler) -> None:
    outcomes = list(verify(made(folder, text, loop, number), ROWS, cc=first_compiler.command[0]))
    assert {(each.level, each.status) for each in outcomes} == {(f"-O{level}", "ok") for level in "0123s"}
    assert all(each.differing_bits == 0 and (each.rows or 0) >= ROWS for each in outcomes)


def test_pairs_of_a_loop_are_not_fused(folder: Path, first_compiler: Compiler) -> None:
    """A vectorising compiler for this very processor, fused multiply-add or not, gives the same bits."""
    bundle = made(folder, "taylor", "rolled")
    outcomes = list(verify(bundle, ROWS, cc=first_compiler.command[0], cflags=["-march=native"]))
    assert {(each.status, each.differing_bits) for each in outcomes} == {("ok", 0)}


@pytest.mark.parametrize("accumulate", ["standard", "compensated"])
def test_every_accumulation(folder: Path, accumulate: str, first_compiler: Compiler) -> None:
    evidence = accept(made(folder, "taylor", "rolled", "float32", accumulate), first_compiler.command[0]).evidence
    assert evidence.rows >= ACCEPT_ROWS
    assert evidence.differing_bits == 0


def words(bundle: Bundle, inputs: NDArray[Any], attitude: NDArray[Any]) -> NDArray[Any]:
    state = {"q": attitude.copy()}
    Model(bundle.machine, bundle.facts.number).run("update", state, {"dtheta": inputs})
    return state["q"]


@pytest.mark.parametrize("axes", ["x,y,z", "y,-x,z", "-z,-y,-x"])
@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("text", TEXTS)
def test_rolled_and_written_out_give_the_same_bits(folder: Path, text: str, number: str, axes: str) -> None:
    rolled, out = (made(folder, text, loop, number, "", axes) for loop in LOOPS)
    random = np.random.default_rng(7)
    dtype = dtype_of(rolled.facts.number)
    size = 3 * rolled.facts.algorithm.subsamples
    inputs = (random.standard_normal((size, 4000)) * 2.0 ** random.integers(-30, 1, 4000)).astype(dtype)
    attitude = random.standard_normal((4, 4000)).astype(dtype)
    first, second = words(rolled, inputs, attitude), words(out, inputs, attitude)
    assert np.isfinite(first).all()
    assert np.array_equal(first.view(f"u{first.itemsize}"), second.view(f"u{first.itemsize}"))
    assert not np.array_equal(first, attitude)


# -- the counts ------------------------------------------------------------------------------------------------


def update_counts(bundle: Bundle) -> Mapping[str, Counts]:
    return bundle.facts.counts["update"]


@pytest.mark.parametrize("text", TEXTS)
def test_as_written_both_execute_the_same(folder: Path, text: str) -> None:
    rolled, out = (update_counts(made(folder, text, loop))["as-written"] for loop in LOOPS)
    assert rolled == out
    assert rolled.multiply > 50


def test_what_the_recurrence_costs(folder: Path) -> None:
    """Counted by hand: r_n takes min(n, 3) pure products and one scaling, the sum four additions a term."""
    counts = update_counts(made(folder, "taylor", "rolled"))["as-written"]
    pure = sum(min(n, 3) for n in range(1, ORDER + 1))
    fit, zeros, finish = 9 * 3, 2 * 3, 16 + 4 + 1
    assert counts.multiply == 12 * pure + 4 * ORDER + fit + zeros + finish
    assert counts.negate == pure
    between, total = 4 * (pure - ORDER), 4 * ORDER
    assert counts.add + counts.subtract == 8 * pure + between + total + 9 * 2 + (12 + 3 + 1 + 1 + 4)


def test_emitted_they_are_equal_where_nothing_folds(folder: Path) -> None:
    rolled, out = (update_counts(made(folder, "ladder", loop))["emitted"] for loop in LOOPS)
    assert rolled == out


def test_written_out_the_passes_find_more(folder: Path) -> None:
    """Written out, 1/n is a constant and the sign of a product goes into the next sum; rolled, neither can be."""
    rolled, out = (update_counts(made(folder, "taylor", loop))["emitted"] for loop in LOOPS)
    assert (rolled.as_papers_count().multiply, rolled.negate) == (412, ORDER)
    assert (out.as_papers_count().multiply, out.negate) == (399, 0)
    assert all(getattr(out, kind.name) == 0 for kind in fields(Counts) if kind.name in ("divide", "square_root"))


# -- the text --------------------------------------------------------------------------------------------------


def body_of(bundle: Bundle) -> str:
    return bundle.source[bundle.source.index("void att_update(") :]


def test_rolled_text_has_the_loops(folder: Path) -> None:
    text = body_of(made(folder, "taylor", "rolled"))
    assert re.findall(r"for \(.*\) \{", text) == [
        "for (int32_t n = 1; n <= 2; ++n) {",
        "for (int32_t j = 1; j <= n - 1; ++j) {",
        "for (int32_t n = 3; n <= 10; ++n) {",
        "for (int32_t j = 1; j <= 2; ++j) {",
    ]
    assert re.findall(r"^ +(?:static const )?float \w+\[\d+\]", text, re.MULTILINE) == [
        "    static const float inverse[11]",
        "    float a[9]",
        "    float r[44]",
        "    float total[44]",
    ]
    assert "r[4 * n - 4 * j - 4]" in text
    assert "#include <stdint.h>" in made(folder, "taylor", "rolled").header


def test_written_out_text_has_neither_loop_nor_array(folder: Path) -> None:
    bundle = made(folder, "taylor", "unrolled")
    text = body_of(bundle)
    assert "for (" not in text
    assert not re.search(r"^ +(static )?(const )?float \w+\[", text, re.MULTILINE)
    assert "int32_t" not in bundle.header + bundle.source
    assert "stdint" not in bundle.header + bundle.source


@pytest.mark.parametrize("loop", LOOPS)
@pytest.mark.parametrize("text", TEXTS)
def test_compilers_have_nothing_to_say(folder: Path, text: str, loop: str, first_compiler: Compiler) -> None:
    bundle = made(folder, text, loop)
    firmware = {name: file for name, file in bundle.sources.items() if not name.endswith("_run.c")}
    assert warnings(first_compiler, firmware) == ""


def test_numbers_in_the_text_are_distinct_names(folder: Path) -> None:
    for loop in LOOPS:
        names = re.findall(r"const float (\w+) =", body_of(made(folder, "taylor", loop)).split("\n}\n")[0])
        assert len(names) == len(set(names)) > 200


# -- loops of a less usual kind ----------------------------------------------------------------------------------

SIGNED = paper(
    """\
    (d,) = dtheta
    back = -d
    first, second = history("first", d, 4), history("second", d, 4)
    for n in loop("n", d, 0, 3):
        first[n] = back
    for n in loop("n", d, 0, 3):
        second[3 - n] = F(1, 3) * back - first[n]
    return q * rotation(F(-1, 8) * dot(back, d), second[0] - back + first[3])
    """
)
EMPTY = paper(
    """\
    (d,) = dtheta
    r = history("r", d, 4)
    r[0] = d
    for n in loop("n", d, 1, 3):
        r[n] = r[n - 1] + F(1, 3) * d
        for j in loop("j", d, 2, n):
            r[n] = r[n] + F(1, 7) * cross(r[n - j], d)
    for n in loop("n", d, 3, 2):
        r[n] = d
    return q * rotation(0, r[3])
    """
)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (SIGNED, lambda d: (F(1, 8) * sum(x * x for x in d), *(-F(1, 3) * x + x + x - x for x in d))),
        (EMPTY, None),
        (INSIDE, None),
    ],
    ids=["signs", "turns that do not run", "loop in a subroutine"],
)
def test_other_loops(tmp_path: Path, text: str, expected: Any, first_compiler: Compiler) -> None:
    bundles = [bundle_of(tmp_path, text, loop=loop) for loop in LOOPS]
    assert {each.status for each in verify(bundles[0], ROWS, cc=first_compiler.command[0])} == {"ok"}
    for bundle in bundles:
        read_back(bundle)
        firmware = {name: file for name, file in bundle.sources.items() if not name.endswith("_run.c")}
        assert warnings(first_compiler, firmware) == ""
    random = np.random.default_rng(3)
    inputs, attitude = random.standard_normal((3, 500)).astype("f4"), random.standard_normal((4, 500)).astype("f4")
    rolled, out = (words(bundle, inputs, attitude) for bundle in bundles)
    assert np.array_equal(rolled.view("u4"), out.view("u4"))
    if expected is not None:
        d = tuple(F(k, 17) for k in (3, -5, 7))
        u, *v = expected(d)
        e = (1 - sum(part * part for part in Q)) / 2
        found = evaluate(bundles[0].written.routine("update"), {"q": list(Q), "dtheta": list(d)}).blocks["q"]
        assert tuple(found) == product(Q, (1 + u + e, *v))
