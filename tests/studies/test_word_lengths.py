"""What a number format costs in accuracy: the figures that fixed point is held to, and the norm over a million updates.

Bounds are those asked of the formats; what is measured stands beside them.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from qcone.reference.motions import coning
from qcone.studies import word_lengths
from qcone.studies.simulating import compiled
from qcone.targets.compiler import Compiler
from qcone.vectors import GO_ON, SET, in_words
from qcone.verify import c_words

ROUNDS = 1_000_000
ASKED = {
    ("fixed32", "compensated", "coning"): 6e-4,
    ("fixed32", "compensated", "slew"): 5e-4,
    ("fixed32", "compensated", "earth rate"): 1e-5,
    ("fixed32", "delta", "coning"): 0.02,
    ("fixed16", "compensated", "coning"): 85.0,
    ("fixed16", "compensated", "slew"): 35.0,
}
"""The rms final error in arcsec after a minute, at most."""


@cache
def error(number: str, accumulate: str, motion: str, quantum: float | None = None) -> float:
    (row,) = word_lengths.rows([(number, accumulate)], [motion], quantum)
    return row.error_arcsec


@pytest.mark.usefixtures("first_compiler")
@pytest.mark.parametrize(("number", "accumulate", "motion"), ASKED)
def test_fixed_point_is_as_accurate_as_is_asked(number: str, accumulate: str, motion: str) -> None:
    found = error(number, accumulate, motion)
    assert found <= ASKED[number, accumulate, motion]
    # A figure far below what words of that length can give would be a mistake of the measurement.
    assert found > ASKED[number, accumulate, motion] / 100


@pytest.mark.usefixtures("first_compiler")
@pytest.mark.parametrize("motion", word_lengths.MOTIONS)
def test_words_of_32_bits_beat_a_float_of_32_bits(motion: str) -> None:
    for accumulate in ("standard", "delta", "compensated"):
        assert error("fixed32", "compensated", motion) < error("float32", accumulate, motion) / 20
    assert error("fixed32", "delta", motion) < error("float32", "delta", motion)


@pytest.mark.usefixtures("first_compiler")
def test_behind_the_quantum_of_a_gyro_fixed_point_is_not_seen() -> None:
    exact = error("float64", "delta", "coning", 1.0)
    assert abs(error("fixed32", "compensated", "coning", 1.0) / exact - 1) < 0.05
    assert exact > 1000 * error("float64", "delta", "coning")
    assert error("float32", "delta", "coning", 1.0) > 1.5 * exact


@pytest.mark.usefixtures("first_compiler")
def test_every_row_of_the_study_is_told() -> None:
    rows = list(word_lengths.rows([("float64", "delta")], ["slew"]))
    assert [(row.number, row.motion, row.quantum_arcsec) for row in rows] == [("float64", "slew", None)]
    assert rows[0].error_arcsec < 1e-6
    assert rows[0].norm_error < 1e-14


# -- the norm, over a million updates ------------------------------------------------------------------------

NORMS = {("fixed32", "compensated"): 2e-9, ("fixed32", "delta"): 2e-9, ("fixed16", "compensated"): 2e-4}
"""The largest | |q| - 1 | on the way, at most."""


@pytest.mark.parametrize(("number", "accumulate"), NORMS)
def test_a_million_updates_keep_the_norm(number: str, accumulate: str, first_compiler: Compiler) -> None:
    bundle, library = compiled(word_lengths.design(number, accumulate))
    period = 6000
    increments = coning().increments(np.arange(3 * period + 1) / 300).reshape(-1, 3, 3)
    given = np.resize(increments, (1, ROUNDS, 3, 3))
    restart = np.full((1, ROUNDS), GO_ON, np.int32)
    restart[0, 0] = SET
    attitude = np.zeros((1, ROUNDS, 4))
    attitude[0, 0] = np.array([0.5, -0.1, 0.7, 0.5]) / np.linalg.norm([0.5, -0.1, 0.7, 0.5])
    vectors = in_words(bundle, restart, attitude, np.zeros((1, ROUNDS, 3)), given)
    words, _ = c_words(bundle, library, vectors)
    held = bundle.machine.state[0].format
    assert held is not None
    q = np.ldexp(words[0, :, :4].astype(np.float64), -held.fraction)
    norm = np.abs(np.linalg.norm(q, axis=1) - 1).max()
    assert norm < NORMS[number, accumulate]
    assert bundle.facts.proved is not None
    assert norm <= bundle.facts.proved.spread
    assert np.ptp(q, axis=0).min() > 1e-2
