"""Commands that emit C and count its operations."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from qcone.cli.group import design_options, main, print_rows, report, say
from qcone.reports.progress import shown
from qcone.reports.table import render


@main.command()
def demo() -> None:
    """Generate a design, compile it, verify its bits, print its cost, replay a motion."""
    from qcone.studies.demonstration import demonstrate

    for step in demonstrate():
        click.echo(f"- {step.text}")
        if step.rows:
            click.echo(render("demo", step.rows, "table"))


@main.command()
@click.argument("files", metavar="DESIGN.toml...", nargs=-1, required=True)
@click.option("--design", "names", multiple=True, metavar="NAME", help="Only this design of the file.")
@click.option("-o", "--output", default="c_out", metavar="DIR", help="Folder of the designs' folders (c_out).")
@click.option("--check", is_flag=True, help="Write nothing; tell stale, edited and missing files; exit 1 if any.")
@click.option("--diff", is_flag=True, help="Write nothing; print what would change.")
@click.option("--dry-run", is_flag=True, help="Write nothing; list the files.")
@click.option("--force", is_flag=True, help="Overwrite files that were edited by hand.")
@click.option("--cc", metavar="CC", help="Compiler to verify with.")
@report
def generate(
    files: tuple[str, ...],
    names: tuple[str, ...],
    output: str,
    check: bool,
    diff: bool,
    dry_run: bool,
    force: bool,
    cc: str | None,
    layout: str,
) -> None:
    """Emit verified C for the designs of a file."""
    from qcone.studies import generating
    from qcone.studies.selection import designs_of

    designs = designs_of(files, names, say)
    if check or dry_run:
        rows = generating.status(shown(designs, "checking"), Path(output))
        print_rows("generate", rows, layout)
        sys.exit(int(check and any(row["status"] != "fresh" for row in rows)))
    if diff:
        text = generating.diff(designs, Path(output))
        click.echo(text, nl=False)
        sys.exit(1 if text else 0)
    print_rows("generate", generating.generate(shown(designs, "generating"), Path(output), force, cc), layout)


@main.command()
@click.argument("subject", metavar="[ALGORITHM or DESIGN.toml]", required=False)
@click.option("--design", "names", multiple=True, metavar="NAME", help="Only this design of the file.")
@click.option("--against", metavar="PAPER", help="Beside the table of a paper: xu2019.")
@design_options
@report
def counts(
    subject: str | None, names: tuple[str, ...], against: str | None, layout: str, **options: str | None
) -> None:
    """Count the operations of an update and of the direction cosine matrix, at every level."""
    from qcone.studies import counting

    print_rows("counts", counting.rows(subject, names, against, options, say), layout)
