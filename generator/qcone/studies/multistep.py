"""Runs of the thesis' multistep method: the compiled C of Adams-Moulton along its coning, all frequencies at once.

"Drift" is Milne's estimate of one step's error, its mean over 10 s. Nothing is normalised.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from qcone.reference.motions import thesis_coning
from qcone.reference.quaternion import Array, error_angle
from qcone.studies.simulating import options, run

DURATION = 10.0  # s
FREQUENCIES = tuple(2.5 * k for k in range(1, 11))
"""Coning frequencies of the thesis, in Hz."""

MAX_RATE_DPS = 30
STARTING = 3
"""Steps of the starter: they give no estimate."""


@dataclass(frozen=True)
class Multistep:
    """What a run gives at each frequency: `drift` (f,), `norm` (f, steps) = |q| - 1, `error` (f, steps) in rad.

    `time_s` (steps,) are the ends of the steps from the third on, where the starter is done and the attitude valid.
    """

    time_s: Array
    drift: Array
    norm: Array
    error: Array


@cache
def multistep(step_s: float, starter: str = "heun") -> Multistep:
    """Return the runs of one time step in s, from the starter "heun" (the thesis) or "runge-kutta-4"."""
    words = options(
        "adams-moulton-4",
        starter=starter,
        input="rate",
        renormalise="never",
        max_rate_dps=MAX_RATE_DPS,
        update_hz=f"{1 / step_s:.12f}",
    )
    times: Array = np.arange(round(DURATION / step_s) + 1) * np.float64(step_s)
    motions = [thesis_coning(frequency) for frequency in FREQUENCIES]
    rates = np.stack([motion.rate(times) for motion in motions])
    start = np.stack([motion.attitude(times[:1])[0] for motion in motions])
    found = run(words, start, rates[:, 1:, np.newaxis], rates[:, 0])
    q, ends = found["quaternion"][:, STARTING - 1 :], times[STARTING:]
    true = np.stack([motion.attitude(ends) for motion in motions])
    estimate = np.linalg.norm(found["error_estimate"][:, STARTING:], axis=-1)
    return Multistep(ends, estimate.mean(axis=1), np.linalg.norm(q, axis=-1) - 1, error_angle(q, true))
