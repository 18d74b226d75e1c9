"""R12 to R14, D11 and D12: the drift and the norm of the multistep method of thesis2008."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qcone.studies.claims.claim import Claim, Range, Settings, about, judged, verdict_of
from qcone.studies.multistep import FREQUENCIES, multistep

PAPER = "thesis2008"
DRIFT = "drift read as Milne's estimate of one step, 19/270 |corrector - predictor|, its mean over 10 s"
STEPS = (0.25, 0.5, 0.75, 1.0)
"""Time steps, in units of the longest: 2.5, 5, 7.5 and 10 ms."""

NORM_LOSS = {1.0: (6.4e-7, 8.3e-6, 3.1e-5, 5.9e-5), 0.5: (2.3e-8, 3.1e-7, 1.4e-6, 4.1e-6)}
"""|q| - 1 after 10 s at 2.5, 5, 7.5 and 10 Hz, for steps of 10 and 5 ms."""

RATIOS: tuple[tuple[float, float, str, str, Range], ...] = (
    (0.75, 0.5, "1.5", "nearly 7", (6.9, 7.7)),
    (0.5, 0.25, "2", "30", (30.0, 32.5)),
    (0.75, 0.25, "3", "200", (210.0, 245.0)),
)
"""A step, the one it is compared with, their ratio, the thesis' ratio of drifts, the accepted range."""

LAST_HZ = 20.0


def step_of(settings: Settings, part: float) -> float:
    """Return a time step in s; the longest is one sample at the slowest rate."""
    return part / settings.rate_hz


def step_ratios(settings: Settings) -> Iterator[Claim]:
    """R12: how the drift grows with the time step."""
    drift = {part: multistep(step_of(settings, part)).drift for part in STEPS}
    used = [i for i, frequency in enumerate(FREQUENCIES) if frequency <= LAST_HZ]
    for long, short, factor, printed, accepted in RATIOS:
        text = f"drift ratio for {factor} times the step, at 2.5, 5, .. {LAST_HZ:g} Hz"
        values = (drift[long] / drift[short])[used].tolist()
        yield judged("R12", text, PAPER, printed, values, accepted, DRIFT)


def frequency_ratios(settings: Settings) -> Iterator[Claim]:
    """R13 and D11: how the drift grows with the frequency, at the step of 5 ms."""
    step = step_of(settings, 0.5)
    drift = dict(zip(FREQUENCIES, multistep(step).drift.tolist(), strict=True))
    low, high = drift[5.0] / drift[2.5], drift[20.0] / drift[17.5]
    where = f"step {1e3 * step:g} ms"
    yield judged("R13", f"drift ratio from 2.5 to 5 Hz, {where}", PAPER, "15", low, (15.7, 16.1), DRIFT)
    reading = f"{DRIFT}; the rate of growth declines, the number is D11"
    yield judged("R13", f"drift ratio from 17.5 to 20 Hz, {where}", PAPER, "1.5", high, (1.63, 1.73), reading)
    why = "1.5 is 1.68: the fourth power of 20/17.5 is 1.71, and the decline takes little of it"
    yield judged(
        "D11", f"drift rises 1.5 times from 17.5 to 20 Hz, {where}", PAPER, "1.5", high, (1.45, 1.55), otherwise=why
    )


def norm_loss(settings: Settings) -> Iterator[Claim]:
    """R14: |q| - 1 after 10 s."""
    for part, table in NORM_LOSS.items():
        step = step_of(settings, part)
        found = multistep(step).norm[: len(table), -1].tolist()
        inside = all(
            low <= value <= high for value, (low, high) in zip(found, (about(t, 0.1) for t in table), strict=True)
        )
        yield Claim(
            "R14",
            f"|q| - 1 after 10 s at 2.5, 5, 7.5, 10 Hz, step {1e3 * step:g} ms",
            PAPER,
            "normalised at 2.5 and 5 Hz, deviates at 7.5 and 10 Hz",
            ", ".join(f"{value:.3g}" for value in found),
            ", ".join(f"{value:.2g}" for value in table) + " +- 10 %",
            verdict_of(inside, "reading"),
            "on a scale of 1e-5, at the step of 10 ms" if inside else "measured outside the accepted range",
        )


def true_error(settings: Settings) -> Iterator[Claim]:
    """D12: the attitude error itself, and what a better starter gains."""
    worst = {part: multistep(step_of(settings, part)).error.max(axis=1) for part in STEPS}
    for long, short, factor, printed, accepted in RATIOS:
        ratio = float(worst[long][0] / worst[short][0])
        text = f"the drift is that of the attitude: its true error at 2.5 Hz for {factor} times the step"
        why = "the ratios are those of Milne's estimate; the true error is the starter's, third order: 3.4, 8, 27"
        yield judged("D12", text, PAPER, printed, ratio, accepted, otherwise=why)
    step = step_of(settings, 0.5)
    heun, cured = (float(np.max(multistep(step, starter).error[0])) for starter in ("heun", "runge-kutta-4"))
    text = (
        f"rates used directly give a small error: Heun start {heun:.2g} rad, Runge-Kutta start {cured:.2g} rad, "
        f"2.5 Hz, step {1e3 * step:g} ms; their ratio"
    )
    why = "the Heun start of three steps leaves an error dozens of times that of the method; start with runge-kutta-4"
    yield judged("D12", text, PAPER, "small error", heun / cured, (0, 2), otherwise=why)
