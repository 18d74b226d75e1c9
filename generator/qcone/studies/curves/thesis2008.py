"""thesis2008's drift tables as curves: drift, its ratios, the norm, and the true error with two starters."""

from __future__ import annotations

import numpy as np

from qcone.studies.claims.claim import Settings
from qcone.studies.claims.thesis2008 import STEPS, step_of
from qcone.studies.curves.figure import Curve, Figure, Level, Panel
from qcone.studies.multistep import FREQUENCIES, multistep

SHOWN = 4
"""Frequencies whose norm is drawn: 2.5, 5, 7.5 and 10 Hz."""

POINTS = 400
FREQUENCY = "coning frequency, Hz"


def drift_tables(settings: Settings) -> Figure:
    """Return the drift against frequency and step, its ratios, the norm against time, and the true error."""
    x = np.array(FREQUENCIES)
    steps = {part: step_of(settings, part) for part in STEPS}
    found = {part: multistep(step) for part, step in steps.items()}
    drift = tuple(
        Curve(f"step {1e3 * steps[part]:g} ms", x, found[part].drift, "o-", k) for k, part in enumerate(STEPS)
    )
    pairs = ((0.75, 0.25, "3"), (0.5, 0.25, "2"), (0.75, 0.5, "1.5"))
    ratios = tuple(
        Curve(f"step x {factor}", x, found[long].drift / found[short].drift, "o-", k)
        for k, (long, short, factor) in enumerate(pairs)
    )
    said = tuple(Level(value, f"thesis: {value}") for value in (200, 30, 7))
    last = found[STEPS[-1]]
    every = slice(None, None, max(len(last.time_s) // POINTS, 1))
    norm = tuple(
        Curve(f"{FREQUENCIES[k]:g} Hz", last.time_s[every], 1e5 * last.norm[k, every], "-", k) for k in range(SHOWN)
    )
    errors = []
    for group, starter in enumerate(("heun", "runge-kutta-4")):
        worst = multistep(steps[0.5], starter).error.max(axis=1)
        errors.append(Curve(f"{starter} start", x, worst, "o-", group))
    errors.append(Curve("drift (Milne)", x, found[0.5].drift, "o--", 2))
    panels = (
        Panel("drift: Milne's estimate of a step", FREQUENCY, "mean drift of a step", drift, False, True),
        Panel("drift ratio", FREQUENCY, "ratio", ratios, False, True, levels=said),
        Panel(
            f"norm, step {1e3 * steps[1.0]:g} ms",
            "time, s",
            "(|q| - 1) / 1e-5",
            norm,
            note="thesis: normalised at 2.5 and 5 Hz, deviates at 7.5 and 10 Hz",
        ),
        Panel(
            f"true attitude error, step {1e3 * steps[0.5]:g} ms",
            FREQUENCY,
            "largest error in 10 s, rad",
            tuple(errors),
            log_y=True,
            note="thesis: rates used directly, so a small error",
        ),
    )
    return Figure(
        "thesis2008_drift", "thesis2008: Adams-Moulton of fourth order along its coning motion, 10 s", 2, panels
    )


FIGURES = (drift_tables,)
