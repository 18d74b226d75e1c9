"""A figure as data: panels of curves on labelled axes, and the paper's claim where it belongs."""

from __future__ import annotations

from dataclasses import dataclass

from qcone.reference.quaternion import Array


@dataclass(frozen=True)
class Curve:
    """Points `x`, `y` (n,) in the units of the axes; `style` is a line of matplotlib's letters: "-", "--", ".", "o-".

    Curves of one `group` have one colour.
    """

    label: str
    x: Array
    y: Array
    style: str = "-"
    group: int = 0


@dataclass(frozen=True)
class Level:
    """A value the paper states, drawn across the panel; the second of two with one meaning has an empty label."""

    y: float
    label: str


@dataclass(frozen=True)
class Span:
    """A range of x the paper speaks of."""

    low: float
    high: float
    label: str


@dataclass(frozen=True)
class Gap:
    """A distance the panel's note speaks of, between two values of y at one x."""

    x: float
    low: float
    high: float


@dataclass(frozen=True)
class Panel:
    """One pair of axes, of the range `y_range` where it is given; `note` is what the paper says of it."""

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    log_x: bool = False
    log_y: bool = False
    levels: tuple[Level, ...] = ()
    spans: tuple[Span, ...] = ()
    gaps: tuple[Gap, ...] = ()
    note: str = ""
    y_range: tuple[float, float] | None = None


@dataclass(frozen=True)
class Figure:
    """A figure: `name` is that of its file, `columns` the number of panels side by side."""

    name: str
    title: str
    columns: int
    panels: tuple[Panel, ...]
