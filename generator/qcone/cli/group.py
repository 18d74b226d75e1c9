"""The group of commands, and what they share: options, how rows are printed, how our errors end."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from typing import Any

import click

from qcone import __version__
from qcone.errors import QconeError
from qcone.reports.table import render

LAYOUTS = ("table", "json", "csv", "md", "tex")
DESIGN_OPTIONS = (  # noqa: SIM905  seventeen lines say no more
    "subsamples coefficients previous order about attitude starter form exponential "
    "renormalise loop axes increments accumulate number max-rate-dps update-hz"
).split()


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


def print_rows(command: str, rows: Sequence[dict[str, object]], layout: str) -> None:
    """Print the rows a command found, in the layout of --format."""
    click.echo(render(command, rows, layout), nl=False)


def say(text: str, kind: str = "note") -> None:
    """Say something beside the result, on the standard error output."""
    click.echo(f"{kind}: {text}", err=True)
