"""Operation counts of an algorithm or a design, beside what a paper says it costs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict

from qcone.admission import number_of
from qcone.assembly import assemble, writing_of
from qcone.backends.counts import Counts, count
from qcone.design import Design
from qcone.errors import UsageError
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Program, walk
from qcone.ir.writing import AS_WRITTEN
from qcone.pipeline import build, choose_exponential, prepare
from qcone.registry import algorithm_of

Row = dict[str, object]

XU2019_TABLE_1: Mapping[str, Counts] = {
    "rotation-vector": Counts(trigonometric=2, square_root=1, multiply=70, divide=4, add=32, subtract=18),
    "quaternion-taylor": Counts(multiply=2043, add=507, subtract=18),
    "dcm-taylor": Counts(multiply=920, add=270, subtract=9),
}
"""xu2019 table 1, operations for the attitude matrix with three sub-samples; the Taylor rows of order 10."""

PAPERS = {"xu2019": XU2019_TABLE_1}
FORMS = ("as-written", "factored")
COMPARABLE = {"rotation-vector": {"subsamples": 3}}
"""The parameters for which the paper's column speaks of our algorithm."""


def rows_of_design(design: Design, forms: Sequence[str], against: str | None = None) -> list[Row]:
    """Return the counts of one update plus the direction cosine matrix, at every level of every form.

    as-written counts products by powers of two among the products, as papers do; shared and emitted count
    them apart. `against` adds the paper's own column, and ours by its convention.
    """
    rows: list[Row] = []
    if against:
        rows += _paper_rows(design, against)
    for form in forms:
        rows += _levels(design, form)
    return rows


def paper_table(paper: str) -> list[Row]:
    """Return every column of the paper's table, as the paper prints it."""
    return [_row(None, name, "as-written", "paper", counts, True) for name, counts in _table(paper).items()]


def _table(paper: str) -> Mapping[str, Counts]:
    if paper not in PAPERS:
        raise UsageError(f"--against {paper}: there is no table of that paper; choose {', '.join(PAPERS)}")
    return PAPERS[paper]


def _paper_rows(design: Design, paper: str) -> list[Row]:
    column = _table(paper).get(design.algorithm)
    if column is None:
        raise UsageError(f"--against {paper}: its table has no column for '{design.algorithm}'")
    for name, wanted in COMPARABLE.get(design.algorithm, {}).items():
        if design.parameters.get(name) != wanted:
            raise UsageError(f"--against {paper}: its table is for {name} = {wanted}; give --{name} {wanted}")
    algorithm = algorithm_of(design)
    ours = _written(assemble(algorithm, design, AS_WRITTEN))
    return [
        _row(None, design.algorithm, "as-written", "paper", column, True),
        _row(None, design.algorithm, "as-written", "paper-convention", ours.as_papers_count(), True),
    ]


def _levels(design: Design, form: str) -> list[Row]:
    algorithm, number = algorithm_of(design), number_of(design)
    if form == "as-written":
        written = assemble(algorithm, design, AS_WRITTEN)
    else:
        chosen = choose_exponential(design, algorithm, number)
        written = assemble(algorithm, design, writing_of(design, chosen.series if chosen else None))
    ready = prepare(written, design)
    rows = [
        _row(design.name, design.algorithm, form, "as-written", _written(written).as_papers_count(), True),
        _row(design.name, design.algorithm, form, "shared", _written(ready)),
    ]
    if form == design.form and not _needs_libm(ready):
        machine = build(design).machine
        rows.append(_row(design.name, design.algorithm, form, "emitted", _written(machine)))
    return rows


def _needs_libm(program: Program) -> bool:
    functions = (RealOp.SQUARE_ROOT, RealOp.SINE, RealOp.COSINE)
    return any(
        isinstance(each, Operation) and each.op in functions
        for routine in program.routines
        for each in walk(routine.body)
    )


def _written(program: Program) -> Counts:
    """Return the counts of one update in the steady state, and of the matrix where it is given."""
    total = count(program.routine("steady" if program.has("steady") else "update"))
    return total + count(program.routine("dcm")) if program.has("dcm") else total


def _row(design: str | None, algorithm: str, form: str, level: str, counts: Counts, as_paper: bool = False) -> Row:
    values: Row = asdict(counts)
    if as_paper:
        values["power_of_two"] = None
    missing: Row = {"compare": None, "select": None, "shift": None, "word_bits": None, "product_bits": None}
    return {"design": design, "algorithm": algorithm, "form": form, "level": level, **values, **missing}
