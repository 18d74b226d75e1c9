"""Rows of odd texts and numbers in every layout."""

from __future__ import annotations

import csv
import io
import json

import pytest

from qcone.reports.table import LAYOUTS, render

ROWS = [
    {"name": "a|b", "value": 1.5, "big": 12345678, "ok": True, "none": None},
    {"name": 'line\nbreak, "quoted"', "value": 1e-9, "big": 0, "ok": False, "none": None},
    {"name": r"50 % of {x_1} & $y^2 ~ #3 \ end", "value": None, "big": -1, "ok": None, "none": None},
]


def test_json_keeps_everything() -> None:
    assert json.loads(render("odd", ROWS, "json")) == {"schema_version": 1, "command": "odd", "rows": ROWS}


def test_csv_is_read_back() -> None:
    head, *rows = csv.reader(io.StringIO(render("odd", ROWS, "csv")))
    assert head == ["name", "value", "big", "ok", "none"]
    assert [row[0] for row in rows] == [row["name"] for row in ROWS]
    assert [row[1:] for row in rows] == [
        ["1.5", "12345678", "yes", ""],
        ["1e-09", "0", "no", ""],
        ["", "-1", "", ""],
    ]


def test_markdown_rows_stay_one_line_and_pipes_are_escaped() -> None:
    lines = render("odd", ROWS, "md").splitlines()
    assert len(lines) == 2 + len(ROWS)
    assert lines[2].startswith(r"| a\|b | 1.5 | 12345678 | yes |")
    assert lines[3].startswith('| line break, "quoted" | 1e-09 |')


def test_latex_escapes_what_latex_reads() -> None:
    lines = render("odd", ROWS, "tex").splitlines()
    assert len(lines) == 8 + len(ROWS)
    assert r"50 \% of \{x\_1\} \& \$y\^{}2 \~{} \#3 \textbackslash{} end &" in lines[8]
    assert all(line.endswith(r"\\") for line in lines[6:-2])


def test_latex_sets_numbers_right_and_wide_headings_upright() -> None:
    rows = [{"name": "a", "square_root": 1, "long": 12345}, {"name": "b", "square_root": None, "long": 0}]
    lines = render("odd", rows, "tex").splitlines()
    assert lines[2] == r"\begin{tabular}{lrr}"
    assert lines[4] == r"name & \rotatebox{90}{square root} & long \\"


@pytest.mark.parametrize("layout", ["md", "tex"])
def test_what_people_read_leaves_out_columns_that_never_apply(layout: str) -> None:
    assert "none" not in render("odd", ROWS, layout)


def test_table_leaves_out_columns_that_never_apply() -> None:
    head, *rest = render("odd", ROWS, "table").splitlines()
    assert head.split() == ["name", "value", "big", "ok"]
    assert len(rest) >= len(ROWS)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_markup_of_the_terminal_is_text(layout: str) -> None:
    """Square brackets in a message are no style."""
    assert "[bold]x[/bold]" in render("odd", [{"name": "[bold]x[/bold]"}], layout)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_no_rows(layout: str) -> None:
    assert render("odd", [], layout).endswith("\n")
