"""The papers' figures: drawn as SVG, the same bytes each time, with axes, units, legends and claims."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner, Result

from qcone.cli import main
from qcone.errors import UsageError
from qcone.reports import figures
from qcone.studies import reproducing
from qcone.studies.claims.claim import Settings
from qcone.studies.curves.figure import Curve, Figure, Gap, Level, Panel, Span

NAMES = {
    "cao": ["cao_fig1", "cao_lock"],
    "thesis2008": ["thesis2008_drift"],
    "rins": ["rins_fig6", "rins_fig8", "rins_fig13", "rins_fig15", "rins_fig16", "rins_fig18"],
    "xu2019": ["xu2019_fig1", "xu2019_fig2", "xu2019_fig3", "xu2019_fig4"],
}
X = np.linspace(1.0, 10.0, 7)
SMALL = Figure(
    "small",
    "a small figure",
    2,
    (
        Panel(
            "left",
            "time, s",
            "angle, rad",
            (Curve("one", X, X**2), Curve("two", X, 5 * X, "o--", 7)),
            log_x=True,
            log_y=True,
            levels=(Level(30.0, "paper: 30"), Level(3.0, "")),
            spans=(Span(2.0, 3.0, "paper: here"),),
            gaps=(Gap(5.0, 25.0, 50.0),),
            note="paper: better",
            y_range=(0.5, 200.0),
        ),
        Panel("middle", "time, s", "rate, rad/s", (Curve("three", X, -X),)),
        Panel("right", "time, s", "norm", (Curve("four", X, 0 * X),)),
    ),
)


def words_of(drawn: bytes) -> str:
    return " | ".join(text for text in ElementTree.fromstring(drawn).itertext() if text.strip())


def test_a_figure_shows_what_it_describes() -> None:
    drawn = words_of(figures.svg(SMALL))
    for word in ("a small figure", "left", "middle", "right", "time, s", "angle, rad", "rate, rad/s", "one", "two"):
        assert word in drawn
    for claim in ("paper: 30", "paper: here", "paper: better"):
        assert claim in drawn


def test_bytes_are_the_same_again_and_name_neither_date_nor_program() -> None:
    drawn = figures.svg(SMALL)
    assert figures.svg(SMALL) == drawn
    text = drawn.decode()
    assert "dc:date" not in text
    assert "Matplotlib v" not in text


def test_a_figure_is_a_picture_too() -> None:
    assert figures.png(SMALL).startswith(b"\x89PNG")


@pytest.mark.parametrize("paper", ["cao", "thesis2008", "rins"])
def test_figures_of_a_paper(paper: str, first_compiler: object) -> None:
    """Those of xu2019 are drawn by the next test."""
    made = [make() for make in reproducing.figures(paper, Settings())]
    assert [figure.name for figure in made] == NAMES[paper]
    for figure in made:
        _complete(figure, paper.removesuffix("2008"))


def test_figures_of_xu2019(first_compiler: object) -> None:
    makers = reproducing.figures("xu2019", Settings(rate_hz=500.0))
    assert len(makers) == len(NAMES["xu2019"])
    for make, name in zip([*makers[:2], makers[3]], [*NAMES["xu2019"][:2], NAMES["xu2019"][3]], strict=True):
        figure = make()
        assert figure.name == name
        _complete(figure, "xu2019")


def _complete(figure: Figure, paper: str) -> None:
    """Check that a figure has data, units, legends, and says somewhere what the paper claims."""
    said = []
    for panel in figure.panels:
        assert panel.title
        assert panel.x_label
        assert panel.y_label
        assert panel.curves
        for curve in panel.curves:
            assert curve.label
            assert len(curve.x) == len(curve.y) > 5
            assert np.isfinite(curve.y).mean() > 0.9
        said += [panel.note, *(mark.label for mark in (*panel.levels, *panel.spans))]
    assert any(text.startswith(f"{paper}:") for text in said), figure.name
    drawn = words_of(figures.svg(figure))
    assert figure.title.split(";")[0] in drawn


def test_no_folder_draws_nothing() -> None:
    assert figures.prepare(None) is None

    def never() -> Figure:
        raise AssertionError("a figure nobody asked for")

    assert list(figures.draw([never], None)) == []


def test_figures_go_into_a_folder_that_is_made(tmp_path: Path) -> None:
    folder = figures.prepare(tmp_path / "a" / "b")
    assert list(figures.draw([lambda: SMALL], folder)) == [tmp_path / "a" / "b" / "small.svg"]
    assert (tmp_path / "a" / "b" / "small.svg").read_bytes() == figures.svg(SMALL)


def test_a_folder_that_cannot_be_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UsageError, match=r"cannot make this folder: .*; choose another"):
        figures.prepare(tmp_path / "file" / "below")
    (tmp_path / "small.svg").mkdir()
    with pytest.raises(UsageError, match=r"cannot write small\.svg: .*; choose another folder"):
        list(figures.draw([lambda: SMALL], tmp_path))


def reproduce(*words: str) -> Result:
    return CliRunner().invoke(main, ["reproduce", *words], prog_name="qcone")


def test_the_command_draws_and_says_where(tmp_path: Path, first_compiler: object) -> None:
    result = reproduce("thesis2008", "--plots", str(tmp_path / "plots"), "--format", "csv")
    assert result.exit_code == 0, result.output
    file = tmp_path / "plots" / "thesis2008_drift.svg"
    assert result.stderr == f"note: drawn: {file}\n"
    assert [path.name for path in (tmp_path / "plots").iterdir()] == [file.name]


def test_without_matplotlib_the_extra_is_named_before_any_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = importlib.util.find_spec
    monkeypatch.setattr(figures, "find_spec", lambda name: None if name == "matplotlib" else real(name))
    result = reproduce("thesis2008", "--plots", str(tmp_path / "plots"))
    assert result.exit_code == 3
    assert result.stderr == "--plots: matplotlib is not installed: pip install 'qcone[plot]'\n"
    assert result.stdout == ""
    assert not (tmp_path / "plots").exists()
