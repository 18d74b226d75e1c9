"""Commands on what a unit recorded: run the C on it, fit what corrects it."""

from __future__ import annotations

from pathlib import Path

import click

from qcone.cli.group import design_options, main, print_rows, report, say
from qcone.errors import UsageError
from qcone.reports.progress import shown

INPUTS = ("increment", "rate", "counts")


@main.command()
@click.argument("file", metavar="FILE.csv", type=click.Path(path_type=Path))
@click.option("--algorithm", metavar="ID", help="Catalogue id; its parameters are options.")
@click.option("--design", "named", multiple=True, metavar="FILE.toml:NAME", help="A design; several are compared.")
@click.option("--input", "kind", type=click.Choice(INPUTS), default="increment", help="What a row is.")
@click.option("--columns", metavar="MAP", help="Names and unit: 't=Time (s);x=...;y=...;z=...;unit=deg/s'.")
@click.option("--sample-hz", type=float, help="Sample rate; gives or overrules the time column.")
@click.option("--resample", type=float, metavar="HZ", help="Bring irregular rows to this rate, by cubics.")
@click.option("--quantum-dps", metavar="P/Q", help="Deg/s of one count; a design's own where it has one.")
@click.option("--ranges", is_flag=True, help="Show the bits every value of a fixed-point design uses on the recording.")
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
    quantum_dps: str | None,
    ranges: bool,
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
    designs = [one_design(each, say) for each in named]
    recording = recordings.read_recording(
        file,
        kind,
        columns=columns,
        sample_hz=sample_hz,
        resample_hz=resample,
        quantum_dps=session.quantum(kind, quantum_dps, designs),
    )
    if algorithm:
        designs = [session.design_for(recording, algorithm, options, say)]
    else:
        refuse_options(options, "the design file decides; leave the option out")
    if ranges:
        print_rows("replay", session.ranges(designs, recording, session.quaternion(initial)), layout)
        return
    if output is None and len(designs) < 2:
        raise UsageError("-o OUT.csv says where the attitude is to be written")
    rows = session.run(shown(designs, "replaying"), recording, session.quaternion(initial), output, cc, compare, say)
    if len(designs) > 1 or layout != "table":
        print_rows("replay", rows, layout)


@main.command("fit-rins")
@click.argument("file", metavar="LOG.csv", type=click.Path(path_type=Path))
@click.option("--columns", metavar="MAP", help="Names and unit: 't=Time;encoder=...;gyr_z=...;acc_x=...;unit=deg'.")
@click.option("--average", type=float, metavar="SECONDS", help="Average the encoder over so long, bridged by the gyro.")
@click.option("--instantaneous", is_flag=True, help="Rates are those of instants, not means over the step before.")
@report
def fit_rins(file: Path, columns: str | None, average: float | None, instantaneous: bool, layout: str) -> None:
    """Fit the corrections of a rotating unit to the log of its encoder, gyro and accelerometers."""
    from qcone.studies.encoder_fit import fitted_rows

    print_rows("fit-rins", fitted_rows(file, columns, average, instantaneous, say), layout)
