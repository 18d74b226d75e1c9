"""Judge the clock of a recording, and put irregular samples onto an even one.

The interpolant is local: the cubic through the four nearest samples (Lagrange), two on each side, or the four
outermost ones at an end. For steps h and a signal f its error is at most 3/128 h^4 max|f''''| inside and
1/24 h^4 max|f''''| in the two outermost steps: fourth order, on uneven steps too, and exact on cubics.
No four samples straddle a gap; a gap is bridged by a straight line and said so.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from qcone.errors import UsageError

IRREGULAR = 0.01  # of the median step: more than this off it is irregular
GAP = 5.0  # median steps: a longer step is a gap
BUNCHED = 0.2  # of the median step: across shorter ones a cubic magnifies noise
GAPS_NAMED = 3
MAX_ROWS = 10_000_000  # 320 MB of times and values
RATE_RANGE_HZ = (1e-6, 1e9)


def first_irregular(time_s: NDArray[np.float64]) -> int | None:
    """Return the first index whose step from the sample before is more than 1 % off the median, if any.

    Times of size T are themselves rounded, so a step may be off by two spacings of float64 at T on top.
    """
    steps = np.diff(time_s)
    if steps.size == 0:
        return None
    median = float(np.median(steps))
    allowed = IRREGULAR * median + 2.0 * float(np.spacing(np.max(np.abs(time_s))))
    off = np.flatnonzero(np.abs(steps - median) > allowed)
    return int(off[0]) + 1 if off.size else None


def even_rate(time_s: NDArray[np.float64]) -> Fraction:
    """Return the rate in Hz of increasing, regular times (n >= 2).

    From the mean step, which unlike the median is not biased where times are written with few digits; taken
    as the nearest fraction with a denominator up to 10,000 (of the rate, or of the step where that is over
    1 s), so that 0.01 s is 100 Hz exactly and 0.0035 s is 2000/7 Hz.
    """
    step = (float(time_s[-1]) - float(time_s[0])) / (time_s.size - 1)
    if step > 1.0:
        return 1 / Fraction(step).limit_denominator(10_000)
    return (1 / Fraction(step)).limit_denominator(10_000)


def resample(
    place: str, kind: str, time_s: NDArray[np.float64], values: NDArray[np.float64], hz: Fraction
) -> tuple[NDArray[np.float64], NDArray[np.float64], tuple[str, ...]]:
    """Interpolate samples (n, 3) at increasing times (n,) in s onto a grid of `hz`.

    Return times, values and remarks. Rates are interpolated as they are; the grid starts at the first
    instant. Increments are summed to the angle turned so far (the first one is taken to last the median
    step), the angle is interpolated and differenced: no angle is lost or made up to the last grid time, and
    the grid starts where the first increment does. `place` names the recording.

    Raises UsageError where there is no step to judge, or more than ten million rows would come out.
    """
    if time_s.size < 2:
        raise UsageError(f"{place}: one row cannot be resampled, it has no step, drop --resample")
    steps = np.diff(time_s)
    median = float(np.median(steps))
    knots, curve = time_s, values
    if kind == "increment":
        knots = np.concatenate(([time_s[0] - median], time_s))
        curve = np.concatenate((np.zeros((1, 3)), np.cumsum(values, axis=0)))
    # The last grid time may overshoot the recording by a rounding, never by a billionth of a step.
    intervals = int(np.floor((knots[-1] - knots[0]) * float(hz) * (1.0 + 1e-15) + 1e-9))
    if intervals >= MAX_ROWS:
        raise UsageError(
            f"{place}: resampling {knots[-1] - knots[0]:g} s to {float(hz):g} Hz makes {intervals} rows, "
            f"more than {MAX_ROWS} are not taken, give a lower --resample or look for a jump in "
            f"the time column"
        )
    grid = knots[0] + np.arange(intervals + 1.0) * float(hz.denominator) / float(hz.numerator)
    resampled = _interpolate(knots, curve, grid, GAP * median)
    notes = _remarks(kind, time_s, steps, median, hz)
    if kind == "increment":
        return grid[1:], np.diff(resampled, axis=0), notes
    return grid, resampled, notes


def _interpolate(
    knots: NDArray[np.float64], values: NDArray[np.float64], at: NDArray[np.float64], gap: float
) -> NDArray[np.float64]:
    """Evaluate the local cubic at times `at`, and a straight line in every step longer than `gap` seconds."""
    result = np.stack([np.interp(at, knots, column) for column in values.T], axis=1)
    ends = np.concatenate(([0], np.flatnonzero(np.diff(knots) > gap) + 1, [knots.size]))
    for first, end in pairwise(ends.tolist()):
        low = int(np.searchsorted(at, knots[first]))
        high = at.size if end == knots.size else int(np.searchsorted(at, knots[end - 1], side="right"))
        result[low:high] = _local_cubic(knots[first:end], values[first:end], at[low:high])
    return result


def _local_cubic(
    knots: NDArray[np.float64], values: NDArray[np.float64], at: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Evaluate the polynomial through the nearest four knots (all of them where there are fewer)."""
    points = min(4, knots.size)
    first = np.searchsorted(knots, at, side="right") - points // 2
    first = np.clip(first, 0, knots.size - points)
    result = np.zeros((at.size, 3))
    for near in range(points):
        weight = np.ones(at.size)
        for other in range(points):
            if other != near:
                weight *= (at - knots[first + other]) / (knots[first + near] - knots[first + other])
        result += weight[:, np.newaxis] * values[first + near]
    return result


def _remarks(
    kind: str, time_s: NDArray[np.float64], steps: NDArray[np.float64], median: float, hz: Fraction
) -> tuple[str, ...]:
    """Say what was resampled, each gap with its place, and what a cubic cannot mend."""
    regularity = "regular" if first_irregular(time_s) is None else "irregular"
    shortest, longest = float(steps.min()), float(steps.max())
    notes = [f"resampled to {float(hz):g} Hz from {regularity} steps ({1e3 * shortest:.3g} .. {1e3 * longest:.3g} ms)"]
    gaps = np.flatnonzero(steps > GAP * median)
    filled = "the increment after it is taken to cover it" if kind == "increment" else "filled by a straight line"
    for row in gaps[:GAPS_NAMED].tolist():
        notes.append(
            f"gap of {1e3 * steps[row]:.3g} ms ({steps[row] / median:.3g} median steps) between data rows "
            f"{row + 1} and {row + 2}, {float(time_s[row])!r} .. {float(time_s[row + 1])!r} s: {filled}"
        )
    if gaps.size > GAPS_NAMED:
        notes.append(f"{gaps.size - GAPS_NAMED} more gaps after these, {gaps.size} in all")
    if shortest < BUNCHED * median:
        notes.append(
            f"steps are bunched (shortest {1e3 * shortest:.3g} ms, median {1e3 * median:.3g} ms): a cubic "
            f"magnifies noise there; if the sensor sampled evenly, give --sample-hz instead"
        )
    if kind == "rate" and float(hz) * median < 0.5:
        notes.append(
            f"{float(hz):g} Hz keeps fewer than half of the rates: motion faster than {float(hz) / 2:g} Hz "
            f"is not filtered out but folded"
        )
    return tuple(notes)
