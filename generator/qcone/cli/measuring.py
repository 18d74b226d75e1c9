"""Commands that run emitted C where it will run: whether the bits agree, and what an update costs."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from qcone.cli.group import main, print_rows, report, say
from qcone.reports.progress import shown

DEFAULT_ROWS = 100_000
NOT_MEASURED = 3
"""Exit code of a command that found nothing wrong and could not measure everything."""

TARGETS = "Where the C runs: all, or names with commas, as in cortex-m0,cortex-m4f."


@main.command()
@click.argument("files", metavar="DESIGN.toml...", nargs=-1, required=True)
@click.option("--design", "names", multiple=True, metavar="NAME", help="Only this design of the file.")
@click.option("--target", default="host", metavar="NAME,...", help=TARGETS)
@click.option("--cc", metavar="CC", help="Only this compiler.")
@click.option("--cflags", default="", metavar="STR", help="Further flags for the compilers.")
@click.option("--rows", type=click.IntRange(1), help="Updates to compare: 100000 on the host, 10000 elsewhere.")
@click.option("--seed", default=1, type=click.IntRange(0), help="Seed of the vectors.")
@click.option(
    "--executor",
    type=click.Choice(("unicorn", "qemu", "simavr")),
    default="unicorn",
    help="What plays the target; simavr an AVR.",
)
@click.option("--ranges", is_flag=True, help="Show the bits every value of a fixed-point design uses on these rows.")
@click.option("--flush-to-zero", "flush", is_flag=True, help="Have the target's FPU take subnormal numbers for zero.")
@report
def verify(
    files: tuple[str, ...],
    names: tuple[str, ...],
    target: str,
    cc: str | None,
    cflags: str,
    rows: int | None,
    seed: int,
    executor: str,
    ranges: bool,
    flush: bool,
    layout: str,
) -> None:
    """Compare the compiled C with the bit-true model, bit for bit."""
    from qcone.studies.selection import designs_of
    from qcone.studies.verifying import Request, ranges_of, verify_designs

    if ranges:
        print_rows("verify", list(ranges_of(shown(designs_of(files, names, say), "running"), rows, seed)), layout)
        return
    request = Request(target, rows, cc, cflags, seed, executor, flush)
    lines = list(verify_designs(shown(designs_of(files, names, say), "verifying"), request))
    print_rows("verify", [each.row for each in lines], layout)
    if any(each.failed for each in lines):
        sys.exit(1)
    sys.exit(NOT_MEASURED if any(not each.measured for each in lines) else 0)


@main.command()
@click.argument("files", metavar="DESIGN.toml...", nargs=-1, required=True)
@click.option("--design", "names", multiple=True, metavar="NAME", help="Only this design of the file.")
@click.option("--target", default="all", metavar="NAME,...", help=TARGETS)
@click.option("--cc", metavar="CC", help="A compiler for the target, such as arm-none-eabi-gcc.")
@click.option("--cflags", default="", metavar="STR", help="Further flags for the compiler.")
@click.option("--level", default="-O2", metavar="LEVEL,...", help="Optimisation levels, as in -O2,-Os.")
@click.option("--elf", type=click.Path(path_type=Path), metavar="FILE", help="Measure in a program of your own build.")
@click.option("--write", is_flag=True, help="Keep the figures in cost.json beside the C, and in the README's table.")
@click.option("--diff", is_flag=True, help="Compare with the figures kept; exit 1 where one differs.")
@click.option("-o", "--output", default="c_out", metavar="DIR", help="Folder of the designs' folders (c_out).")
@report
def cost(
    files: tuple[str, ...],
    names: tuple[str, ...],
    target: str,
    cc: str | None,
    cflags: str,
    level: str,
    elf: Path | None,
    write: bool,
    diff: bool,
    output: str,
    layout: str,
) -> None:
    """Measure what one update costs on each target: instructions, bytes, stack, cycles."""
    from qcone.studies import costing, kept_costs
    from qcone.studies.selection import designs_of

    request = costing.request(target, cc, cflags, level, elf)
    kept_costs.check_request(write, diff, elf)
    found = costing.measure_designs(shown(designs_of(files, names, say), "measuring"), request, say)
    if diff:
        different = kept_costs.differences(found.lines, Path(output))
        if different or layout != "table":
            print_rows("cost", different, layout)
        if not different:
            say("every figure measured is as kept")
        sys.exit(1 if different or found.failed else NOT_MEASURED if found.missing else 0)
    print_rows("cost", [each.row for each in found.lines], layout)
    if write and not found.failed and not found.missing:
        for file in kept_costs.write(found.lines, Path(output)):
            say(f"kept: {file}")
    sys.exit(1 if found.failed else NOT_MEASURED if found.missing else 0)
