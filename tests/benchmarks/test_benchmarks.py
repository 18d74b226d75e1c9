"""How fast: run with `pytest --benchmark-only tests/benchmarks`. Rates asked for are asserted, on the best round."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from qcone.backends.bittrue import Model, new_state
from qcone.bundle import VerifiedBundle
from qcone.pipeline import build as build_design
from qcone.targets import build as builds
from qcone.targets.compiler import Compiler
from qcone.vectors import GO_ON, INIT, Vectors
from qcone.verify import accept, c_words, differing_bits, model_words, open_library
from shipped import DESIGNS, shipped

DESIGN = "rotation_vector_3_coning_float64"
MODEL_RATE = 1e6
"""Updates a second asked of the bit-true model over independent lanes."""
C_RATE = 20e6
"""Updates a second asked of the compiled C called through cffi, every word of state and outputs written."""

Benchmark = Callable[..., Any]


def per_second(benchmark: Any, updates: int) -> float:
    """Return the best round's rate, and put it into the report."""
    rate: float = updates / benchmark.stats.stats.min
    benchmark.extra_info["updates_per_second"] = round(rate)
    return rate


def test_the_shipped_catalogue_is_generated_and_verified(
    benchmark: Any, first_compiler: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every design built, read back, compiled with nothing cached, and compared on 2,000 rows, in this process."""

    def nothing_built_yet() -> None:
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        folder.mkdir()
        monkeypatch.setattr(builds, "_folder", lambda: folder)

    def everything() -> list[VerifiedBundle]:
        return [accept(build_design(design)) for design in DESIGNS.values()]

    done = benchmark.pedantic(everything, setup=nothing_built_yet, rounds=2)
    assert [each.bundle.name for each in done] == list(DESIGNS)
    assert len(list(tmp_path.iterdir())) >= 2
    assert all(each.evidence.differing_bits == 0 for each in done)


@pytest.mark.parametrize("lanes", [256, 1024, 4096])
def test_model_updates(benchmark: Any, lanes: int) -> None:
    bundle, calls = shipped(DESIGN), 20
    model, state = Model(bundle.machine, bundle.facts.number), new_state(bundle.machine, bundle.facts.number, lanes)
    model.run("init", state)
    dtheta = 0.01 * np.random.default_rng(1).standard_normal((9, lanes))

    def updates() -> None:
        for _ in range(calls):
            model.run("update", state, {"dtheta": dtheta})

    benchmark(updates)
    rate = per_second(benchmark, calls * lanes)
    if lanes == 1024:
        assert rate >= MODEL_RATE


@pytest.mark.parametrize("level", ["-O2", "-O3"])
def test_c_updates(benchmark: Any, first_compiler: Compiler, level: str) -> None:
    """The batch loop of the tests: one attitude run on, its state, quaternion and matrix written after each update."""
    bundle, rows = shipped(DESIGN), 200_000
    restart = np.full((1, rows), GO_ON, np.int32)
    restart[0, 0] = INIT
    dtheta = 0.01 * np.random.default_rng(1).standard_normal((1, rows, 9))
    vectors = Vectors(restart, np.zeros((1, rows, 4)), np.zeros((1, rows, 3)), dtheta)
    library = open_library(bundle, first_compiler, level)
    words = np.zeros((1, rows, bundle.driver.word_count))
    contracted = np.zeros(1, np.int32)
    arrays = [vectors.restart, vectors.attitude, vectors.before, vectors.inputs, words, contracted]
    benchmark(library.run, f"{bundle.name}_run", rows, *arrays)
    few = Vectors(restart[:, :500], np.zeros((1, 500, 4)), np.zeros((1, 500, 3)), dtheta[:, :500])
    assert differing_bits(words[:, :500].copy(), model_words(bundle, few)) == 0
    assert differing_bits(words, c_words(bundle, library, vectors)[0]) == 0
    rate = per_second(benchmark, rows)
    if level == "-O2":
        assert rate >= C_RATE
