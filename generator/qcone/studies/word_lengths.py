"""What the number format costs in accuracy: every format and accumulation, on three motions, from one run.

Three sub-samples with coning coefficients, 100 updates/s, 60 s; the rms over 32 attitudes at the start of the final
error, in arcsec. Increments are those of a pulse counter that counts in last bits: the residue is carried.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import pi

import numpy as np

from qcone.reference.motions import Motion, coning, slew
from qcone.reference.quaternion import Array, conjugate, error_angle, normalise, product
from qcone.studies.simulating import Options, as_given, options, run

ARCSEC = pi / 180 / 3600
UPDATE_HZ, SUBSAMPLES, DURATION = 100, 3, 60
RATE_DPS = 573
ATTITUDES, SEED = 32, 1
EARTH = 15 * ARCSEC
MOTIONS: dict[str, Motion] = {
    "coning": coning(),
    "slew": slew((2.1, -1.8, 2.46)),
    "earth rate": slew((EARTH * 0.48, -EARTH * 0.6, EARTH * 0.64)),
}
"""xu2019 coning, 5 deg and 2 Hz; a steady turn of 3.7 rad/s; the earth's, 15 arcsec/s."""
NUMBERS = (
    ("float64", "delta"),
    ("float32", "standard"),
    ("float32", "delta"),
    ("float32", "compensated"),
    ("fixed32", "standard"),
    ("fixed32", "delta"),
    ("fixed32", "compensated"),
    ("fixed16", "compensated"),
)


@dataclass(frozen=True)
class Row:
    """The rms final error in arcsec of a number format on a motion, and the largest | |q| - 1 | on the way."""

    number: str
    accumulate: str
    motion: str
    quantum_arcsec: float | None
    error_arcsec: float
    norm_error: float


def design(number: str, accumulate: str) -> Options:
    """Return the words of the study's design in a number format."""
    words = {"coefficients": "coning", "update_hz": UPDATE_HZ, "max_rate_dps": RATE_DPS}
    return options("rotation-vector", subsamples=SUBSAMPLES, number=number, accumulate=accumulate, **words)


def rows(
    numbers: Iterable[tuple[str, str]] = NUMBERS,
    motions: Iterable[str] = tuple(MOTIONS),
    quantum_arcsec: float | None = None,
    seed: int = SEED,
) -> Iterable[Row]:
    """Yield a row for each format and motion; with a quantum, increments are whole multiples of it, residue carried."""
    for motion in motions:
        for number, accumulate in numbers:
            errors, norm = final_errors(design(number, accumulate), MOTIONS[motion], quantum_arcsec, seed)
            rms = float(np.sqrt(np.mean(errors**2))) / ARCSEC
            yield Row(number, accumulate, motion, quantum_arcsec, rms, norm)


def final_errors(words: Options, motion: Motion, quantum_arcsec: float | None, seed: int) -> tuple[Array, float]:
    """Return the final errors in rad of the compiled C from 32 attitudes, and the largest | |q| - 1 | on the way."""
    samples = DURATION * UPDATE_HZ * SUBSAMPLES
    times = np.arange(samples + 1) / (UPDATE_HZ * SUBSAMPLES)
    increments = motion.increments(times)
    if quantum_arcsec is not None:
        angle = np.rint(np.cumsum(increments, axis=0) / (quantum_arcsec * ARCSEC)) * (quantum_arcsec * ARCSEC)
        increments = np.diff(angle, axis=0, prepend=np.zeros((1, 3)))
    generator = np.random.default_rng(seed)
    turned = normalise(generator.standard_normal((ATTITUDES, 4)))
    ends = motion.attitude(np.array([0.0, DURATION]))
    start = product(turned, np.broadcast_to(ends[0], (ATTITUDES, 4)))
    # The attitude handed in is rounded too; the C is judged from what it was given.
    start = as_given(words, start)
    turned = product(normalise(start), np.broadcast_to(conjugate(ends[0]), (ATTITUDES, 4)))
    truth = product(turned, np.broadcast_to(ends[1], (ATTITUDES, 4)))
    given = np.broadcast_to(increments.reshape(1, -1, SUBSAMPLES, 3), (ATTITUDES, samples // SUBSAMPLES, SUBSAMPLES, 3))
    q = run(words, start, given)["kept"]
    norm = float(np.abs(np.linalg.norm(q, axis=-1) - 1).max())
    return error_angle(normalise(q[:, -1]), truth), norm
