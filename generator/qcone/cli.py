"""The command line: parsing and printing only. Every command is a function of `studies` or `pipeline`."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import click

from qcone import __version__
from qcone.errors import QconeError, UsageError
from qcone.reports.progress import shown
from qcone.reports.table import render

LAYOUTS = ("table", "json", "csv", "md", "tex")
DESIGN_OPTIONS = (  # noqa: SIM905  seventeen lines say no more
    "subsamples coefficients previous order about attitude starter form exponential "
    "renormalise loop axes increments accumulate number max-rate-dps update-hz"
).split()
DEFAULT_ROWS = 100_000


class Commands(click.Group):
    """The group of commands; turns our errors into one message and the exit code of its kind."""

    def invoke(self, context: click.Context) -> Any:
        """Run a command; a QconeError becomes its message, anything else is a bug of ours (exit code 70)."""
        try:
            return super().invoke(context)
        except QconeError as error:
            click.echo(str(error), err=True)
            sys.exit(error.exit_code)
        except (click.ClickException, click.exceptions.Exit, click.Abort):
            raise
        except BrokenPipeError:
            sys.exit(0)
        except Exception as error:
            if context.params.get("traceback"):
                raise
            click.echo(f"internal error: {type(error).__name__}: {error}", err=True)
            click.echo("this is a bug of qcone: please report it with the output of `qcone --traceback ...`", err=True)
            sys.exit(70)


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="qcone")
@click.option("--traceback", is_flag=True, help="Show the Python traceback of an internal error.")
def main(traceback: bool) -> None:
    """From the equation in the paper to attitude firmware you can trust."""


def report(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the option --format."""
    option = click.option(
        "--format", "layout", type=click.Choice(LAYOUTS), default="table", help="How rows are printed."
    )
    return option(command)


def design_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the keys of a design as options."""
    for word in reversed(DESIGN_OPTIONS):
        command = click.option(f"--{word}", metavar="VALUE", help=f"Design key {word.replace('-', '_')}.")(command)
    return command


@main.command()
def demo() -> None:
    """Generate a design, compile it, verify its bits, print its cost, replay a motion."""
    from qcone.studies.demonstration import demonstrate

    for step in demonstrate():
        click.echo(f"- {step.text}")
        if step.rows:
            click.echo(render("demo", step.rows, "table"))


@main.command("list")
@report
def list_command(layout: str) -> None:
    """List the catalogue: id, parameters, order, operations, source."""
    from qcone.studies.listing import rows

    _print("list", rows(), layout)


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

    designs = designs_of(files, names, _say)
    if check or dry_run:
        rows = generating.status(shown(designs, "checking"), Path(output))
        _print("generate", rows, layout)
        sys.exit(int(check and any(row["status"] != "fresh" for row in rows)))
    if diff:
        text = generating.diff(designs, Path(output))
        click.echo(text, nl=False)
        sys.exit(1 if text else 0)
    _print("generate", generating.generate(shown(designs, "generating"), Path(output), force, cc), layout)


@main.command()
@click.argument("files", metavar="DESIGN.toml...", nargs=-1, required=True)
@click.option("--design", "names", multiple=True, metavar="NAME", help="Only this design of the file.")
@click.option("--target", default="host", metavar="NAME", help="Where the C runs: host.")
@click.option("--cc", metavar="CC", help="Only this compiler.")
@click.option("--cflags", default="", metavar="STR", help="Further flags for the compilers.")
@click.option("--rows", default=DEFAULT_ROWS, type=click.IntRange(1), help="Updates to compare.")
@click.option("--seed", default=1, type=click.IntRange(0), help="Seed of the vectors.")
@report
def verify(
    files: tuple[str, ...],
    names: tuple[str, ...],
    target: str,
    cc: str | None,
    cflags: str,
    rows: int,
    seed: int,
    layout: str,
) -> None:
    """Compare the compiled C with the bit-true model, bit for bit."""
    from qcone.studies.selection import designs_of
    from qcone.studies.verifying import verify_designs

    outcomes = list(verify_designs(shown(designs_of(files, names, _say), "verifying"), target, rows, cc, cflags, seed))
    _print("verify", [outcome.row for outcome in outcomes], layout)
    sys.exit(int(any(outcome.failed for outcome in outcomes)))


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

    _print("counts", counting.rows(subject, names, against, options, _say), layout)


@main.command()
@click.argument("file", metavar="FILE.csv", type=click.Path(path_type=Path))
@click.option("--algorithm", metavar="ID", help="Catalogue id; its parameters are options.")
@click.option("--design", "named", multiple=True, metavar="FILE.toml:NAME", help="A design; several are compared.")
@click.option("--input", "kind", type=click.Choice(("increment", "rate")), default="increment", help="What a row is.")
@click.option("--columns", metavar="MAP", help="Names and unit: 't=Time (s);x=...;y=...;z=...;unit=deg/s'.")
@click.option("--sample-hz", type=float, help="Sample rate; gives or overrules the time column.")
@click.option("--resample", type=float, metavar="HZ", help="Bring irregular rows to this rate, by cubics.")
@click.option("--initial", default="1,0,0,0", metavar="W,X,Y,Z", help="Attitude at the start.")
@click.option("--compare", is_flag=True, help="Hold every word against the bit-true model; exit 1 if a bit differs.")
@click.option("--cc", metavar="CC", help="Compiler to use.")
@click.option("-o", "--output", type=click.Path(path_type=Path), metavar="OUT.csv", help="Where the attitude goes.")
@design_options
@report
def replay(
    file: Path,
    algorithm: str | None,
    named: tuple[str, ...],
    kind: str,
    columns: str | None,
    sample_hz: float | None,
    resample: float | None,
    initial: str,
    compare: bool,
    cc: str | None,
    output: Path | None,
    layout: str,
    **options: str | None,
) -> None:
    """Run the generated, compiled C on recorded or simulated motion."""
    from qcone.studies import recording as recordings
    from qcone.studies import session
    from qcone.studies.selection import one_design, refuse_options

    if bool(algorithm) == bool(named):
        raise UsageError("give --algorithm ID with its parameters, or --design FILE.toml:NAME, one of the two")
    recording = recordings.read_recording(file, kind, columns=columns, sample_hz=sample_hz, resample_hz=resample)
    if algorithm:
        designs = [session.design_for(recording, algorithm, options, _say)]
    else:
        refuse_options(options, "the design file decides; leave the option out")
        designs = [one_design(each, _say) for each in named]
    if output is None and len(designs) < 2:
        raise UsageError("-o OUT.csv says where the attitude is to be written")
    rows = session.run(shown(designs, "replaying"), recording, session.quaternion(initial), output, cc, compare, _say)
    if len(designs) > 1 or layout != "table":
        _print("replay", rows, layout)


@main.command()
@click.argument("algorithm", metavar="ALGORITHM")
@design_options
@report
def explain(algorithm: str, layout: str, **options: str | None) -> None:
    """Explain an algorithm: its derivation with exact rationals, its leading error, known errata."""
    from qcone.studies.explaining import rows
    from qcone.studies.selection import from_options

    defaults = {"number": "float64", "max-rate-dps": "573", "update-hz": "100"}
    _print("explain", rows(from_options("explained", algorithm, options, defaults, _say)), layout)


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
    _print("reproduce", rows, layout)
    for file in figures.draw(shown(reproducing.figures(paper, settings), "drawing"), folder):
        _say(f"drawn: {file}")
    sys.exit(int(reproducing.broken(rows, settings)))


@main.command()
@click.option("--frequency-hz", default=2.5, metavar="HZ", help="Frequency of the coning motion of thesis2008.")
@report
def accuracy(frequency_hz: float, layout: str) -> None:
    """Propagate errors of a unit by the additive model of thesis2008, beside their simulation."""
    from qcone.studies import error_model

    cases = shown(error_model.standard_cases(), "propagating")
    _print("accuracy", error_model.error_rows(error_model.coning(frequency_hz), cases), layout)


@main.command()
@report
def doctor(layout: str) -> None:
    """Tell what is installed, and the exact fix for what is not."""
    from qcone.studies.doctor import rows

    found = rows()
    _print("doctor", found, layout)
    if any(row["status"] == "missing" for row in found):
        sys.exit(3)


@main.command()
def schema() -> None:
    """Print the JSON schema of design files."""
    import json

    from qcone.design import json_schema
    from qcone.registry import entries

    click.echo(json.dumps(json_schema(entries()), indent=2))


def _print(command: str, rows: Sequence[dict[str, object]], layout: str) -> None:
    click.echo(render(command, rows, layout), nl=False)


def _say(text: str, kind: str = "note") -> None:
    click.echo(f"{kind}: {text}", err=True)
