"""Table 1 of xu2019, whole, in every layout: what the paper prints, what we count, and the least there is."""

from __future__ import annotations

import pytest
from given import COUNTS, rows_of

from qcone.cli import LAYOUTS

RV, QT, DT = "rotation-vector", "quaternion-taylor", "dcm-taylor"
TABLE_1 = [
    (RV, "as-written", "paper", 70, None, 4, 32, 18, 0, 1, 2),
    (RV, "as-written", "paper-convention", 70, None, 4, 32, 18, 6, 1, 2),
    (RV, "as-written", "as-written", 70, None, 4, 32, 18, 6, 1, 2),
    (RV, "factored", "emitted", 50, 0, 0, 39, 18, 0, 0, 0),
    (QT, "as-written", "paper", 2043, None, 0, 507, 18, 0, 0, 0),
    (QT, "as-written", "paper-convention", 2043, None, 0, 507, 18, 18, 0, 0),
    (QT, "as-written", "as-written", 2043, None, 0, 1611, 18, 18, 0, 0),
    (QT, "factored", "emitted", 337, 15, 0, 208, 162, 0, 0, 0),
    (DT, "as-written", "paper", 920, None, 0, 270, 9, 0, 0, 0),
    (DT, "as-written", "paper-convention", 920, None, 0, 270, 9, 9, 0, 0),
    (DT, "as-written", "as-written", 920, None, 0, 684, 9, 9, 0, 0),
    (DT, "factored", "emitted", 381, 18, 0, 240, 174, 0, 0, 0),
]
"""xu2019 table 1: the paper's columns, ours by its convention, ours in full, and the least form of each.

Negations are counted here and not by the paper; the least forms are for three sub-samples, order 10, matrix included.
"""

SHOWN = COUNTS[1:-5]
HEADS = [name.replace("_", " ") for name in SHOWN]


def texts(row: tuple[object, ...]) -> list[str]:
    return ["" if value is None else str(value) for value in row]


def test_the_paper_s_whole_table(run) -> None:
    rows = rows_of(run, "counts")
    assert [tuple(row[name] for name in SHOWN) for row in rows] == TABLE_1
    assert rows == rows_of(run, "counts", "--against", "xu2019")


def csv_table() -> str:
    lines = [",".join(COUNTS), *(",".join(["", *texts(row), *[""] * 5]) for row in TABLE_1)]
    return "\n".join(lines) + "\n"


def markdown_table() -> str:
    rules = "|---|---|---|" + "---:|" * 8
    return "\n".join([f"| {' | '.join(HEADS)} |", rules, *(f"| {' | '.join(texts(row))} |" for row in TABLE_1)]) + "\n"


def latex_table() -> str:
    upright = [
        name if name in ("algorithm", "form", "level", "add") else rf"\rotatebox{{90}}{{{name}}}" for name in HEADS
    ]
    lines = [
        r"% \usepackage{booktabs,graphicx}",
        r"\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{%",
        r"\begin{tabular}{lllrrrrrrrr}",
        r"\toprule",
        " & ".join(upright) + r" \\",
        r"\midrule",
        *(" & ".join(texts(row)) + r" \\" for row in TABLE_1),
        r"\bottomrule",
        r"\end{tabular}}",
    ]
    return "\n".join(lines) + "\n"


WRITTEN_OUT = {"csv": csv_table, "md": markdown_table, "tex": latex_table}


@pytest.mark.parametrize("layout", WRITTEN_OUT)
def test_layouts(run, layout: str) -> None:
    result = run("counts", "--format", layout)
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout == WRITTEN_OUT[layout]()


def test_table_is_the_default_and_every_layout_is_offered(run) -> None:
    head, *lines = run("counts").stdout.splitlines()
    assert head.split() == " ".join(HEADS).split()
    assert [line.split() for line in lines] == [[cell for cell in texts(row) if cell] for row in TABLE_1]
    assert set(LAYOUTS) == {*WRITTEN_OUT, "table", "json"}
    result = run("counts", "--format", "xml")
    assert result.exit_code == 2
    assert "'xml' is not one of 'table', 'json', 'csv', 'md', 'tex'" in result.stderr
