"""xu2019 figures 1 to 4: coning, ideal and quantised; three to six sub-samples; the large-angle manoeuvre."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qcone.studies.claims.claim import Settings
from qcone.studies.claims.coning import AXES, PITCH, YAW, matrix, quaternion, rotation_vector, top_rate
from qcone.studies.claims.manoeuvre import algorithms, rate_of
from qcone.studies.curves.figure import Curve, Figure, Gap, Level, Panel, Span
from qcone.studies.sampled import QUANTUM, coning_errors, manoeuvre_track
from qcone.studies.simulating import Options

STEPS = (1.0, 1.2, 1.5, 1.8, 2.1, 2.5, 3.0, 4.0, 5.0, 7.0, 10.0, 20.0, 50.0)
"""Sampling rates, in units of the slowest, below the fastest."""

FEWER_STEPS = (1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 30.0)
RATE = "sub-sample rate, Hz"
PULSES_RANGE = (1e-6, 1e-4)
FLOOR = 1e-16
"""Errors below it are drawn on it: a logarithm has no 0, and float64 no digits there."""


def ideal(settings: Settings) -> Figure:
    """Return figure 1: attitude errors against the sampling rate, ideal increments."""
    drawn = {
        "rotation vector, 9/20, 27/40": rotation_vector(settings),
        "rotation vector, 33/80, 57/80": rotation_vector(settings, coefficients="taylor"),
        "quaternion series": quaternion(settings),
        "matrix series": matrix(settings),
    }
    panels = _by_rate(settings, drawn, quantised=False)
    at = 10 * settings.rate_hz
    best, series = (coning_errors(words, 3, at) for words in (rotation_vector(settings), quaternion(settings)))
    marked = []
    for axis, panel in enumerate(panels):
        better, worse = sorted((best[axis], series[axis]))
        said = (
            f"xu2019: series 2 orders {'worse' if axis == YAW else 'better'}; here {worse / better:.3g}x at the arrow"
        )
        marked.append(replace(panel, gaps=(Gap(at, better, worse),), note=said))
    title = "xu2019 fig. 1: coning, half-angle 5 deg, 4 pi rad/s, 60 s, three sub-samples, ideal"
    return Figure("xu2019_fig1", title, 3, tuple(marked))


def quantised(settings: Settings) -> Figure:
    """Return figure 2: the same with pulses of 1 arcsec."""
    drawn = {
        "rotation vector, 9/20, 27/40": rotation_vector(settings),
        "quaternion series": quaternion(settings),
        "matrix series": matrix(settings),
    }
    panels = _by_rate(settings, drawn, quantised=True)
    level = Level(QUANTUM / 2, "half a pulse")
    span = Span(settings.rate_hz, 2.1 * settings.rate_hz, "xu2019: rotation vector better")
    said = "xu2019: alike, no gain with rate"
    marked = [replace(panel, levels=(level,), note=said, y_range=PULSES_RANGE) for panel in panels[:YAW]]
    marked.append(replace(panels[YAW], spans=(span,), note=said, y_range=PULSES_RANGE))
    title = "xu2019 fig. 2: coning as in fig. 1, increments in pulses of 1 arcsec, residual carried"
    return Figure("xu2019_fig2", title, 3, tuple(marked))


def more_subsamples(settings: Settings) -> Figure:
    """Return figure 3: three to six sub-samples, pitch and yaw."""
    counts = range(3, 7)
    families = {
        "rotation vector": {n: rotation_vector(settings, n) for n in counts},
        "quaternion series, order 10": {n: quaternion(settings, n) for n in counts},
        "quaternion series, order 16": {n: quaternion(settings, n, 16) for n in counts},
        "matrix series, order 10": {n: matrix(settings, n) for n in counts},
    }
    rates = _rates(settings, FEWER_STEPS)
    panels = []
    for axis in (PITCH, YAW):
        for name, drawn in families.items():
            curves = []
            for n, words in drawn.items():
                errors = [max(coning_errors(words, n, rate)[axis], FLOOR) for rate in rates]
                curves.append(Curve(f"N = {n}", np.array(rates), np.array(errors), "o-", n - 3))
            said = "xu2019: degrades with N" if name == "rotation vector" else "xu2019: improves with N, below 1 kHz"
            panel = Panel(name, RATE, f"{AXES[axis]} error, rad", tuple(curves), True, True, note=said)
            panels.append(replace(panel, y_range=(0.5 * FLOOR, 1e-4)))
    title = "xu2019 fig. 3: coning as in fig. 1, three to six sub-samples, ideal"
    return Figure("xu2019_fig3", title, 4, tuple(panels))


def large_angles(settings: Settings) -> Figure:
    """Return figure 4: the attitude error along the manoeuvre."""
    rate = rate_of(settings)
    panels = []
    for pulses, name in ((False, "ideal increments"), (True, "pulses of 1 arcsec")):
        curves = []
        for group, (label, words) in enumerate(algorithms(settings).items()):
            time, error = manoeuvre_track(words, 3, rate, pulses)
            curves.append(Curve(label, time, np.maximum(error, FLOOR), ("-", "-", "--")[group], group))
        gaps: tuple[Gap, ...] = ()
        note = "xu2019: alike"
        if not pulses:
            high, low = float(curves[0].y.max()), float(curves[1].y.max())
            at = float(curves[0].x[curves[0].y.argmax()])
            gaps, note = (Gap(at, low, high),), f"xu2019: about 2 orders; here {high / low:.3g}x, the largest errors"
        y_range = PULSES_RANGE if pulses else None
        panel = Panel(name, "time, s", "attitude error, rad", tuple(curves), False, True, gaps=gaps, note=note)
        panels.append(replace(panel, y_range=y_range))
    title = f"xu2019 fig. 4: large-angle manoeuvre, sub-samples at {rate:g} Hz, three sub-samples"
    return Figure("xu2019_fig4", title, 2, tuple(panels))


def _by_rate(settings: Settings, drawn: dict[str, Options], quantised: bool) -> list[Panel]:
    rates = _rates(settings, STEPS)
    panels = []
    for axis, name in enumerate(AXES):
        curves = []
        for group, (label, words) in enumerate(drawn.items()):
            errors = [max(coning_errors(words, 3, rate, quantised)[axis], FLOOR) for rate in rates]
            style = "--" if label.startswith("matrix") else "o" if "33/80" in label else "-"
            curves.append(Curve(label, np.array(rates), np.array(errors), style, group))
        panels.append(Panel(name, RATE, f"largest {name} error, rad", tuple(curves), True, True))
    return panels


def _rates(settings: Settings, steps: tuple[float, ...]) -> list[float]:
    top = top_rate(settings)
    return [step * settings.rate_hz for step in steps if step * settings.rate_hz < top] + [top]


FIGURES = (ideal, quantised, more_subsamples, large_angles)
