"""Operation counts of an algorithm or a design, beside what a paper says it costs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace

from qcone.admission import number_of
from qcone.algorithms.dense_taylor import dense_products
from qcone.assembly import assemble
from qcone.backends.counts import Counts, count
from qcone.design import Design, design_from_options
from qcone.errors import UsageError
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Program, walk
from qcone.ir.writing import AS_WRITTEN
from qcone.pipeline import build, choose_exponential, choose_writing, prepare
from qcone.registry import algorithm_of, entries
from qcone.stage_routines import BODY, CORRECT
from qcone.studies.selection import Say, designs_of, from_options, refuse_options

Row = dict[str, object]

XU2019_TABLE_1: Mapping[str, Counts] = {
    "rotation-vector": Counts(trigonometric=2, square_root=1, multiply=70, divide=4, add=32, subtract=18),
    "quaternion-taylor": Counts(multiply=2043, add=507, subtract=18),
    "dcm-taylor": Counts(multiply=920, add=270, subtract=9),
}
"""xu2019 table 1, operations for the attitude matrix with three sub-samples; the Taylor rows of order 10."""

TABLE_DESIGN = {
    "number": "float64",
    "max_rate_dps": "573",
    "update_hz": "100",
    "outputs": "quaternion,dcm",
    "renormalise": "never",
}
"""The paper's algorithms do not renormalise; what they are compared with does not either."""

PAPERS = {"xu2019": XU2019_TABLE_1}
FORMS = ("as-written", "factored")
TABLE_ROWS = (
    ("as-written", "paper"),
    ("as-written", "paper-convention"),
    ("as-written", "as-written"),
    ("factored", "emitted"),
)
STAGE = (CORRECT, BODY)
COMPARABLE: Mapping[str, Mapping[str, int]] = {
    "rotation-vector": {"subsamples": 3},
    "quaternion-taylor": {"subsamples": 3, "order": 10},
    "dcm-taylor": {"subsamples": 3, "order": 10},
}
"""The parameters for which the paper's column speaks of our algorithm."""

DENSE_SIZE = {"quaternion-taylor": 4, "dcm-taylor": 3}
"""Rows of the matrices whose products the paper's Taylor columns count."""


def rows(
    subject: str | None, names: Sequence[str], against: str | None, options: Mapping[str, str | None], say: Say
) -> list[Row]:
    """Return the counts of a catalogue id with its options, of the designs of a file, or a paper's whole table.

    Raises UsageError for options that do not go together.
    """
    form = options["form"]
    others = {word: value for word, value in options.items() if word != "form"}
    if form is not None and form not in FORMS:
        raise UsageError(f"--form {form}: choose {' or '.join(FORMS)}")
    if names and not (subject or "").endswith(".toml"):
        raise UsageError(f"--design {names[0]}: say which design file it is in")
    if subject is None:
        refuse_options(options, "say which algorithm it is for")
        return paper_table(against or "xu2019")
    if subject.endswith(".toml"):
        refuse_options(others, "the design file decides; leave the option out")
        designs = designs_of((subject,), names, say)
        return [row for design in designs for row in rows_of_design(design, (form or design.form,), against)]
    defaults = {"number": "float64", "max-rate-dps": "573", "update-hz": "100", "outputs": "quaternion,dcm"}
    design = from_options("counted", subject, others, defaults, say)
    found = rows_of_design(design, (form,) if form else FORMS, against)
    return [{**row, "design": None} for row in found]


def rows_of_design(design: Design, forms: Sequence[str], against: str | None = None) -> list[Row]:
    """Return the counts of one update plus the direction cosine matrix, at every level of every form.

    as-written counts products by powers of two among the products, as papers do; shared and emitted count
    them apart. The stage of a rotating unit follows in rows of its own. `against` adds the paper's own column, and
    ours by its convention; as-written then covers what the paper's column does.
    """
    rows: list[Row] = []
    if against:
        rows += _paper_rows(design, against)
    for form in forms:
        rows += _levels(design, form, bool(against))
    return rows + _stage(design) if design.rins and not against else rows


def paper_table(paper: str) -> list[Row]:
    """Return the paper's whole table, four rows an algorithm.

    They are its column, ours by its convention, ours as written with every operation counted, and the least form.
    """
    rows: list[Row] = []
    for name in _table(paper):
        given = {"algorithm": name, **COMPARABLE[name], **TABLE_DESIGN}
        if name == "rotation-vector":
            given["coefficients"] = "taylor"
        every = rows_of_design(design_from_options("counted", given, entries()), FORMS, paper)
        rows += [row for row in every if (row["form"], row["level"]) in TABLE_ROWS]
    return [{**row, "design": None} for row in rows]


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
    ours = _within_extent(design, _written(assemble(algorithm, design, AS_WRITTEN)).as_papers_count())
    return [
        _row(None, design.algorithm, "as-written", "paper", column, True),
        _row(None, design.algorithm, "as-written", "paper-convention", _by_convention(design, ours), True),
    ]


def _within_extent(design: Design, counts: Counts) -> Counts:
    """Return the counts of what the paper's column covers: for the matrix it ends with R, before C R."""
    if design.algorithm != "dcm-taylor":
        return counts
    return replace(counts, multiply=counts.multiply - 27, add=counts.add - 18)


def _by_convention(design: Design, counts: Counts) -> Counts:
    """Return the counts by the convention of xu2019: of the dense products' inner additions, those of one product."""
    size = DENSE_SIZE.get(design.algorithm)
    if size is None:
        return counts
    products = dense_products(int(str(design.parameters["subsamples"])), int(str(design.parameters["order"])))
    return replace(counts, add=counts.add - (products - 1) * size * size * (size - 1))


def _levels(design: Design, form: str, against: bool) -> list[Row]:
    algorithm, number = algorithm_of(design), number_of(design)
    writing = AS_WRITTEN
    if form != "as-written":
        writing = choose_writing(design, algorithm, choose_exponential(design, algorithm, number))
    written = assemble(algorithm, design, writing)
    ready = prepare(written, design)
    counted = _written(written).as_papers_count()
    if against and form == "as-written":
        counted = _within_extent(design, counted)
    rows = [
        _row(design.name, design.algorithm, form, "as-written", counted, True),
        _row(design.name, design.algorithm, form, "shared", _written(ready)),
    ]
    if form == design.form and not _needs_libm(ready):
        machine = build(design).machine
        rows.append(_row(design.name, design.algorithm, form, "emitted", _written(machine)))
    return rows


def _stage(design: Design) -> list[Row]:
    """Return the counts of a rotating unit's stage: the angle corrected and the body's quaternion given, once."""
    written = assemble(algorithm_of(design), design, AS_WRITTEN)
    paper = sum((count(written.routine(name)) for name in STAGE), Counts())
    known = build(design).facts.counts
    rows = [_row(design.name, "rins", "as-written", "as-written", paper.as_papers_count(), True)]
    for level in ("shared", "emitted"):
        total = sum((known[name][level] for name in STAGE), Counts())
        row = _row(design.name, "rins", design.form, level, total)
        rows.append({**row, "compare": total.compare, "select": total.select})
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
