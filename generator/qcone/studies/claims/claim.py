"""A claim of a paper, what was measured for it, and the verdict."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

HOLDS, UNDER_READING, DOES_NOT_HOLD = "holds", "holds-under-reading", "does-not-hold"
BASE_HZ = 100.0
"""The papers' slowest sampling rate, which the accepted ranges are stated for."""

Measured = float | str | None
Range = tuple[float, float]


@dataclass(frozen=True)
class Settings:
    """What the command line chooses: the `seed` of noise and drawn cases; `rate_hz`, the slowest sampling rate.

    Every rate of the studies keeps its ratio to 100 Hz: xu2019 samples at 1, 2, 5, 10 and 100 times `rate_hz`,
    the manoeuvre at 10 times, the time steps of thesis2008 are 1/4, 1/2, 3/4 and 1 of its inverse.
    """

    seed: int = 0
    rate_hz: float = BASE_HZ


@dataclass(frozen=True)
class Claim:
    """One row: `id` R1..R17 or D1..D13, the paper's value, ours, the accepted range, the verdict and why.

    `verdict` is HOLDS, UNDER_READING or DOES_NOT_HOLD; None where nothing could be measured.
    """

    id: str
    claim: str
    paper: str
    paper_value: str
    measured: Measured
    tolerance: str
    verdict: str | None
    reason: str = ""


Study = Callable[[Settings], Iterable[Claim]]


def within(values: Iterable[float], accepted: Range) -> bool:
    """Tell whether every value lies in the accepted range, its ends included."""
    low, high = accepted
    return all(low <= value <= high for value in values)


def verdict_of(holds: bool, reading: str = "") -> str:
    """Return the verdict; with a `reading` a claim that holds does so only as that says."""
    if not holds:
        return DOES_NOT_HOLD
    return UNDER_READING if reading else HOLDS


def judged(
    id: str,  # noqa: A002  the column's name
    claim: str,
    paper: str,
    paper_value: str,
    values: float | Sequence[float],
    accepted: Range,
    reading: str = "",
    otherwise: str = "",
) -> Claim:
    """Return a claim whose values all have to lie in the `accepted` range.

    `reading` is how the claim has to be read to hold, `otherwise` why it does not where it does not.
    """
    several = [values] if isinstance(values, float | int) else list(values)
    holds = within(several, accepted)
    reason = reading if holds else otherwise or "measured outside the accepted range"
    return Claim(id, claim, paper, paper_value, measured(several), shown(accepted), verdict_of(holds, reading), reason)


def about(value: float, relative: float) -> Range:
    """Return the range `value` +- `relative` of it."""
    return value * (1 - relative), value * (1 + relative)


def shown(accepted: Range) -> str:
    """Return an accepted range as text; one end may be infinite."""
    low, high = accepted
    if low == float("-inf"):
        return f"at most {high:.4g}"
    if high == float("inf"):
        return f"at least {low:.4g}"
    return f"{low:.4g} .. {high:.4g}"


def measured(values: Sequence[float]) -> Measured:
    """Return a single value as a number, several as text, to four digits."""
    if len(values) == 1:
        return values[0] if isinstance(values[0], int) else float(f"{values[0]:.4g}")
    return ", ".join(f"{value:.4g}" for value in values)
