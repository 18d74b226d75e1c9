"""Draw figures as SVG with matplotlib: the same bytes for the same data; axes, units, legends, claims marked.

A figure is what `studies.curves.figure` describes: panels of curves, with levels, spans, gaps and notes of the paper.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from qcone.errors import MissingToolError, UsageError

PANEL_INCHES = (4.3, 3.9)
WIDE_INCHES = (9.0, 2.9)
TITLE_INCHES = 0.45
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#7b3294", "#56b4e9", "#b8860b")
"""Told apart by colour-blind eyes too; a curve's group chooses."""

CLAIM = "#8b0000"
"""Colour of what a paper says."""

STYLE: Any = {
    "svg.hashsalt": "qcone",
    "svg.fonttype": "none",
    "font.family": "DejaVu Sans",
    "font.size": 8.5,
    "axes.titlesize": 9.5,
    "legend.fontsize": 7.5,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.3,
    "lines.markersize": 3.0,
}


def prepare(folder: Path | None) -> Path | None:
    """Return the folder for figures, made if need be, before anything is measured for them; None for no folder.

    Raises MissingToolError without matplotlib, UsageError when the folder cannot be made.
    """
    if folder is None:
        return None
    if find_spec("matplotlib") is None:
        raise MissingToolError("--plots: matplotlib is not installed: pip install 'qcone[plot]'")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = error.strerror or str(error)
        raise UsageError(f"--plots {folder}: cannot make this folder: {reason}; choose another") from error
    return folder


def draw(figures: Iterable[Callable[[], Any]], folder: Path | None) -> Iterator[Path]:
    """Make and draw figures into `folder`, NAME.svg each, and yield the files; nothing is made for no folder.

    Raises UsageError when a file cannot be written.
    """
    for make in figures if folder else ():
        figure = make()
        file = Path(folder or ".", f"{figure.name}.svg")
        try:
            file.write_bytes(svg(figure))
        except OSError as error:
            reason = error.strerror or str(error)
            raise UsageError(f"--plots {folder}: cannot write {file.name}: {reason}; choose another folder") from error
        yield file


def svg(figure: Any) -> bytes:
    """Return a figure as SVG: no date and no name of a program, identifiers salted with a fixed word."""
    return _drawn(figure, "svg", metadata={"Date": None, "Creator": None})


def png(figure: Any) -> bytes:
    """Return a figure as a picture of 110 dots an inch."""
    return _drawn(figure, "png", dpi=110)


def _drawn(figure: Any, kind: str, **how: Any) -> bytes:
    import matplotlib
    from matplotlib.figure import Figure

    rows = -(-len(figure.panels) // figure.columns)
    width, height = WIDE_INCHES if figure.columns == 1 else PANEL_INCHES
    with matplotlib.rc_context(STYLE):
        page = Figure(figsize=(width * figure.columns, height * rows + TITLE_INCHES), layout="constrained")
        page.suptitle(figure.title, fontsize=10.5)
        places = page.subplots(rows, figure.columns, squeeze=False).ravel()
        for axes, panel in zip(places, figure.panels, strict=False):
            _panel(axes, panel, figure.columns == 1)
        for axes in places[len(figure.panels) :]:
            axes.set_axis_off()
        file = io.BytesIO()
        page.savefig(file, format=kind, **how)
    return file.getvalue()


def _panel(axes: Any, panel: Any, wide: bool) -> None:
    for curve in panel.curves:
        colour = COLOURS[curve.group % len(COLOURS)]
        axes.plot(curve.x, curve.y, curve.style, color=colour, label=curve.label)
    for level in panel.levels:
        axes.axhline(level.y, color=CLAIM, linestyle=":", linewidth=1.1, label=level.label or None)
    for span in panel.spans:
        axes.axvspan(span.low, span.high, color=CLAIM, alpha=0.1, linewidth=0, label=span.label)
    axes.set_xscale("log" if panel.log_x else "linear")
    axes.set_yscale("log" if panel.log_y else "linear")
    if panel.y_range:
        axes.set_ylim(*panel.y_range)
    for gap in panel.gaps:
        ends = {"xy": (gap.x, gap.low), "xytext": (gap.x, gap.high)}
        axes.annotate("", **ends, arrowprops={"arrowstyle": "<->", "color": CLAIM, "shrinkA": 0, "shrinkB": 0})
    axes.set_title(panel.title, pad=16 if panel.note else 6)
    axes.text(0.5, 1.02, panel.note, transform=axes.transAxes, ha="center", color=CLAIM, fontsize=7.5, style="italic")
    axes.set_xlabel(panel.x_label)
    axes.set_ylabel(panel.y_label)
    entries = len(axes.get_legend_handles_labels()[1])
    across = entries if wide else min(entries, 2)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2 if wide else -0.14), ncols=across, frameon=False)
