"""R11 and D7: the large-angle manoeuvre of xu2019, figure 4, and the reference the paper judged it by."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qcone.reference.kinematics import IDENTITY
from qcone.reference.quaternion import error_angle
from qcone.studies.claims.claim import Claim, Settings, about, judged
from qcone.studies.sampled import MANOEUVRE, MANOEUVRE_DPS, algorithm, manoeuvre_error
from qcone.studies.simulating import Options, run

PAPER = "xu2019"
FASTEST_HZ = 1_000_000.0


def rate_of(settings: Settings) -> float:
    """Return the sub-sample rate in Hz: 1 kHz in the paper."""
    return 10 * settings.rate_hz


def algorithms(settings: Settings, n: int = 3) -> dict[str, Options]:
    """Return the paper's three algorithms by name."""
    rate = rate_of(settings)
    return {
        "rotation vector": algorithm("rotation-vector", n, rate, MANOEUVRE_DPS, coefficients="coning"),
        "quaternion series": algorithm("quaternion-taylor", n, rate, MANOEUVRE_DPS, order=10),
        "matrix series": algorithm("dcm-taylor", n, rate, MANOEUVRE_DPS, order=10),
    }


def large_angles(settings: Settings) -> Iterator[Claim]:
    """R11: figure 4, ideal and with pulses of 1 arcsec."""
    rate = rate_of(settings)
    made = algorithms(settings)
    ideal = {name: manoeuvre_error(words, 3, rate) for name, words in made.items()}
    for name, error in ideal.items():
        accepted = about(6.0e-9 if name == "rotation vector" else 1.1e-10, 0.1)
        text = f"fig. 4: largest attitude error of the {name} in rad, {rate:g} Hz"
        yield judged("R11", text, PAPER, "not given", error, accepted)
    ratios = [ideal["rotation vector"] / ideal[name] for name in ("quaternion series", "matrix series")]
    text = "fig. 4: error of the rotation vector over that of the quaternion series, of the matrix series"
    reading = "about two orders of magnitude read as 1.7, a factor near 53"
    yield judged("R11", text, PAPER, "about 2 orders", ratios, (45, 65), reading)
    pulses = [manoeuvre_error(words, 3, rate, True) for words in made.values()]
    text = "fig. 4: attitude error in rad with pulses of 1 arcsec, of the three algorithms"
    yield judged("R11", text, PAPER, "alike", pulses, about(7.9e-6, 0.1))


def papers_reference(settings: Settings) -> Iterator[Claim]:
    """D7: single samples at 1 MHz, which the paper takes for the truth."""
    rate = min(10_000 * settings.rate_hz, FASTEST_HZ)
    words = algorithm("rotation-vector", 1, rate, MANOEUVRE_DPS)
    times = np.arange(int(MANOEUVRE.duration * rate * (1 + 1e-12)) + 1) / rate
    q = run(words, IDENTITY[np.newaxis], MANOEUVRE.increments(times)[np.newaxis, :, np.newaxis])["quaternion"][0]
    every = max(len(q) // 1200, 1)
    ends = times[every::every]
    error = float(error_angle(q[every - 1 :: every], MANOEUVRE.attitude(ends)).max())
    text = f"a single-sample quaternion at {rate:g} Hz serves as the standard of fig. 4: its own error in rad"
    why = "of the order of what it is to judge: too coarse below 1e-11 rad, as for four sub-samples; a series is exact"
    yield judged("D7", text, PAPER, "the standard", error, (0, 1e-13), otherwise=why)
