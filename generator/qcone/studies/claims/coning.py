"""R6 to R10, D1 and D4 to D6: the coning motion of xu2019, figures 1 to 3.

`rate` is the sub-sample rate: only so does figure 3 come out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from math import log10

import numpy as np

from qcone.studies.claims.claim import Claim, Settings, about, judged
from qcone.studies.sampled import CONING_DPS, Angles, algorithm, coning_errors
from qcone.studies.simulating import Options

PAPER = "xu2019"
SWEEP = (1, 2, 5, 10)
"""Sampling rates, in units of the slowest."""

FASTEST_HZ = 10_000.0
PITCH, ROLL, YAW = 0, 1, 2
AXES = ("pitch", "roll", "yaw")
COARSE = "two orders of magnitude read as 1.7, a factor near 55"
SUBSAMPLE_RATE = "the sampling frequency is that of the sub-samples"
SMALL, LARGE = float("-inf"), float("inf")


def rotation_vector(settings: Settings, n: int = 3, coefficients: str = "coning") -> Options:
    """Return the rotation vector with `coefficients` "coning" (cao (12) for N = 3) or "taylor" (xu2019 (4))."""
    return algorithm("rotation-vector", n, settings.rate_hz, CONING_DPS, coefficients=coefficients)


def quaternion(settings: Settings, n: int = 3, order: int = 10, about: str = "start") -> Options:
    """Return the Taylor series of the quaternion."""
    return algorithm("quaternion-taylor", n, settings.rate_hz, CONING_DPS, order=order, about=about)


def matrix(settings: Settings, n: int = 3, order: int = 10) -> Options:
    """Return the Taylor series of the direction cosine matrix."""
    return algorithm("dcm-taylor", n, settings.rate_hz, CONING_DPS, order=order)


def rates(settings: Settings) -> list[float]:
    """Return the sampling rates in Hz that claims are made for."""
    return [factor * settings.rate_hz for factor in SWEEP]


def top_rate(settings: Settings) -> float:
    """Return the fastest sampling rate in Hz, of the quantised runs: 10 kHz in the paper."""
    return max(min(100 * settings.rate_hz, FASTEST_HZ), rates(settings)[-1])


def ideal_sampling(settings: Settings) -> Iterator[Claim]:
    """R6, R7, R8 and D1: figure 1."""
    at = _in_words(rates(settings))
    best, parabola, series = (
        [coning_errors(make(settings), 3, rate) for rate in rates(settings)]
        for make in (rotation_vector, _printed, quaternion)
    )
    direct = [coning_errors(matrix(settings), 3, rate) for rate in rates(settings)]
    for axis in (PITCH, ROLL):
        text = f"fig. 1: {AXES[axis]} error of the rotation vector over that of the quaternion series, at {at}"
        yield judged("R6", text, PAPER, "2 orders", _ratios(best, series, axis), (50, 60), COARSE)
        text = f"fig. 1: {AXES[axis]} error of the rotation vector over that of the matrix series, at {at}"
        yield judged("R6", text, PAPER, "2 orders", _ratios(best, direct, axis), (50, 60), COARSE)
    text = f"fig. 1: yaw error of the quaternion series over that of the rotation vector with 9/20, 27/40, at {at}"
    reading = "only with 9/20, 27/40 of cao; the paper names 33/80, 57/80, see D1"
    yield judged("R7", text, PAPER, "2 orders", _ratios(series, best, YAW), (230, 420), reading)
    text = f"the same ratio with 33/80, 57/80, at {at}"
    yield judged("R7", text, PAPER, "not given", _ratios(series, parabola, YAW), (0.997, 1.003))
    for axis in (PITCH, ROLL):
        yield _slope(settings, f"{AXES[axis]} error of the rotation vector", best, axis)
    for axis in (PITCH, ROLL, YAW):
        yield _slope(settings, f"{AXES[axis]} error of the quaternion series", series, axis)
    text = f"fig. 1: with 33/80, 57/80 as printed the new algorithms' yaw is 2 orders worse, at {at}"
    why = "the parabola's coefficients leave the series' own yaw drift; figure 1 was made with 9/20, 27/40"
    yield judged("D1", text, PAPER, "2 orders", _ratios(series, parabola, YAW), (30, LARGE), otherwise=why)


def _printed(settings: Settings) -> Options:
    return rotation_vector(settings, coefficients="taylor")


def _ratios(over: list[Angles], under: list[Angles], axis: int) -> list[float]:
    return [a[axis] / b[axis] for a, b in zip(over, under, strict=True)]


def _slope(settings: Settings, name: str, errors: list[Angles], axis: int) -> Claim:
    slope = np.polyfit(np.log(rates(settings)), np.log([each[axis] for each in errors]), 1)[0]
    text = f"fig. 1: {name} falls with the sampling rate, log-log slope"
    return judged("R8", text, PAPER, "improves", float(slope), (-4.1, -3.9))


def more_subsamples(settings: Settings) -> Iterator[Claim]:
    """R9 and D5: figure 3, three to six sub-samples."""
    rate = settings.rate_hz
    counts = range(3, 7)
    grown = [coning_errors(rotation_vector(settings, n), n, rate)[PITCH] for n in counts]
    for n, factor in zip(counts[1:], (3.2, 2.3, 2.1), strict=True):
        ratio = grown[n - 3] / grown[n - 4]
        text = f"fig. 3: pitch error of the rotation vector grows from N = {n - 1} to {n}, {rate:g} Hz"
        yield judged("R9", text, PAPER, "degrades", ratio, about(factor, 0.1), SUBSAMPLE_RATE)
    for name, order, where in (("order 16", 16, "start"), ("order 10 about the midpoint", 10, "midpoint")):
        errors = [coning_errors(quaternion(settings, n, order, where), n, rate)[PITCH] for n in counts]
        text = f"fig. 3: pitch error of the quaternion series, {name}, over that of one sub-sample less, N = 4, 5, 6"
        falls = [b / a for a, b in pairwise(errors)]
        yield judged("R9", text, PAPER, "improves", falls, (0, 0.999), "with a series long enough; order 10: see D5")
    for name, make in (("quaternion", quaternion), ("matrix", matrix)):
        series = {n: coning_errors(make(settings, n), n, rate)[PITCH] for n in (5, 6)}
        text = f"fig. 3: the {name} series of order 10 improves from N = 5 to 6 (pitch, N = 6 over 5), {rate:g} Hz"
        why = "order 10 truncates: six sub-samples take a series of order 12 or more"
        yield judged("D5", text, PAPER, "improves", series[6] / series[5], (0, 1), otherwise=why)


def quantised(settings: Settings) -> Iterator[Claim]:
    """R10, D4 and D6: figure 2, a pulse of 1 arcsec with its residual carried."""
    sampled = [*rates(settings), top_rate(settings)]
    named: list[tuple[str, Callable[[Settings], Options]]] = [
        ("rotation vector", rotation_vector),
        ("quaternion series", quaternion),
        ("matrix series", matrix),
    ]
    for name, make in named:
        floor = [coning_errors(make(settings), 3, rate, True)[PITCH] for rate in sampled]
        text = f"fig. 2: pitch error of the {name} in rad, pulses of 1 arcsec, at {_in_words(sampled)}"
        yield judged("R10", text, PAPER, "alike, no gain with rate", floor, (2.0e-6, 3.6e-6))
    best, series = (
        [coning_errors(make(settings), 3, rate, True)[YAW] for rate in rates(settings)]
        for make in (rotation_vector, quaternion)
    )
    reading = "quantised yaw depends on how the rate divides the coning period: in kind, not a sharp band"
    text = f"fig. 2: yaw error of the rotation vector over that of the quaternion series, {settings.rate_hz:g} Hz"
    yield judged("R10", text, PAPER, "better at 100..210 Hz", best[0] / series[0], (0.6, 0.7), reading)
    text = f"the same ratio at {_in_words(rates(settings)[1:3])}"
    yield judged("R10", text, PAPER, "alike above 210 Hz", [best[1] / series[1], best[2] / series[2]], (0.95, 1.05))
    yield from _orders_lost(settings, sampled)
    yield from _unstable(settings)


def _orders_lost(settings: Settings, sampled: list[float]) -> Iterator[Claim]:
    for name, words in (("rotation vector", rotation_vector(settings)), ("quaternion series", quaternion(settings))):
        pairs = [[coning_errors(words, 3, rate, pulses)[PITCH] for pulses in (True, False)] for rate in sampled]
        lost = [log10(with_pulses / without) for with_pulses, without in pairs]
        text = f"pulses of 1 arcsec cost the {name} 4 to 5 orders (pitch), at {_in_words(sampled)}"
        why = "a floor of half a pulse, not a constant loss: the better the ideal error, the more is lost"
        yield judged("D4", text, PAPER, "4..5 orders", lost, (4, 5), otherwise=why)


def _unstable(settings: Settings) -> Iterator[Claim]:
    rate = settings.rate_hz
    plain = max(coning_errors(rotation_vector(settings, 6), 6, rate, True))
    for name, make in (("quaternion", quaternion), ("matrix", matrix)):
        series = max(coning_errors(make(settings, 6), 6, rate, True))
        text = f"the {name} series of order 10 takes pulses as well as the rotation vector, N = 6 (ratio), {rate:g} Hz"
        why = (
            "a series of order 10 about the start amplifies quantised increments of six sub-samples: take the midpoint"
        )
        yield judged("D6", text, PAPER, "improves with N", series / plain, (0, 1.1), otherwise=why)


def _in_words(found: list[float]) -> str:
    return ", ".join(f"{rate:g}" for rate in found) + " Hz"
