"""What --help says, command by command. To write the snapshots again: `python tests/cli/help_texts.py`."""

from __future__ import annotations

from pathlib import Path

from click.testing import CliRunner

from qcone.cli import main

FOLDER = Path(__file__).parent / "help"
COMMANDS = ("", *sorted(main.commands))


def help_of(command: str) -> str:
    """Return what `qcone COMMAND --help` prints on a page 100 columns wide."""
    words = [command, "--help"] if command else ["--help"]
    return CliRunner().invoke(main, words, prog_name="qcone", terminal_width=100, max_content_width=100).output


def file_of(command: str) -> Path:
    """Return where the snapshot of a command is kept."""
    return FOLDER / f"{command or 'qcone'}.txt"


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for each in COMMANDS:
        file_of(each).write_text(help_of(each), encoding="utf-8")
