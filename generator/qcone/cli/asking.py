"""Commands that answer: what there is, where it comes from, what is installed."""

from __future__ import annotations

import sys
from dataclasses import asdict
from pathlib import Path

import click

from qcone.cli.group import design_options, main, print_rows, report, say
from qcone.errors import UsageError
from qcone.reports.progress import shown

STUDIES = "error-model: thesis2008's propagation; number-formats: what words and roundings cost."


@main.command("list")
@report
def list_command(layout: str) -> None:
    """List the catalogue: id, parameters, order, operations, source."""
    from qcone.studies.listing import rows

    print_rows("list", rows(), layout)


@main.command()
@click.argument("algorithm", metavar="ALGORITHM")
@design_options
@report
def explain(algorithm: str, layout: str, **options: str | None) -> None:
    """Explain an algorithm: its derivation with exact rationals, its leading error, known errata."""
    from qcone.studies.explaining import rows
    from qcone.studies.selection import from_options

    defaults = {"number": "float64", "max-rate-dps": "573", "update-hz": "100"}
    print_rows("explain", rows(from_options("explained", algorithm, options, defaults, say)), layout)


@main.command()
@click.argument("paper", metavar="[PAPER]", required=False)
@click.option("--plots", type=click.Path(path_type=Path), metavar="DIR", help="Draw the papers' figures there, as SVG.")
@click.option("--seed", default=0, type=click.IntRange(0), help="Seed of the noise and of the cases drawn at random.")
@click.option("--rate-hz", default=100.0, help="Slowest sampling rate; the others keep their ratio to it.")
@report
def reproduce(paper: str | None, plots: Path | None, seed: int, rate_hz: float, layout: str) -> None:
    """Measure the claims of cao, thesis2008, rins and xu2019 anew, and tell which hold."""
    from qcone.reports import figures
    from qcone.studies import reproducing

    settings = reproducing.settings_of(paper, seed, rate_hz)
    folder = figures.prepare(plots)
    rows = reproducing.rows(shown(reproducing.work(paper, settings), "reproducing"))
    print_rows("reproduce", rows, layout)
    for file in figures.draw(shown(reproducing.figures(paper, settings), "drawing"), folder):
        say(f"drawn: {file}")
    sys.exit(int(reproducing.broken(rows, settings)))


@main.command()
@click.option("--study", type=click.Choice(("error-model", "number-formats")), default="error-model", help=STUDIES)
@click.option("--quantum-arcsec", type=float, metavar="ARCSEC", help="Quantum of the gyro, for number-formats.")
@click.option("--seed", default=1, type=click.IntRange(0), help="Seed of the attitudes, for number-formats.")
@click.option("--frequency-hz", default=2.5, metavar="HZ", help="Frequency of the coning motion of thesis2008.")
@report
def accuracy(study: str, quantum_arcsec: float | None, seed: int, frequency_hz: float, layout: str) -> None:
    """Study accuracy: of a unit with errors, by the model of thesis2008; of the number formats, on three motions."""
    from qcone.studies import error_model, word_lengths

    if quantum_arcsec is not None and study != "number-formats":
        raise UsageError("--quantum-arcsec belongs to --study number-formats: leave it out, or ask for that study")
    if quantum_arcsec is not None and not 0 < quantum_arcsec < 1000:
        raise UsageError(f"--quantum-arcsec {quantum_arcsec:g} is no quantum: give one above 0 and below 1000")
    if study == "number-formats":
        found = word_lengths.rows(quantum_arcsec=quantum_arcsec, seed=seed)
        print_rows("accuracy", [asdict(each) for each in found], layout)
        return
    cases = shown(error_model.standard_cases(), "propagating")
    print_rows("accuracy", error_model.error_rows(error_model.coning(frequency_hz), cases), layout)


@main.command()
@report
def doctor(layout: str) -> None:
    """Tell what is installed, and the exact fix for what is not."""
    from qcone.studies.doctor import rows

    found = rows()
    print_rows("doctor", found, layout)
    if any(row["status"] == "missing" for row in found):
        sys.exit(3)


@main.command()
def schema() -> None:
    """Print the JSON schema of design files."""
    import json

    from qcone.design import json_schema
    from qcone.registry import entries

    click.echo(json.dumps(json_schema(entries()), indent=2))
