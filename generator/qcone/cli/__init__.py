"""The command line: parsing and printing only. Every command is a function of `studies` or `pipeline`."""

from __future__ import annotations

from qcone.cli import asking, emitting, measuring, recordings
from qcone.cli.group import DESIGN_OPTIONS, LAYOUTS, main

__all__ = ["DESIGN_OPTIONS", "LAYOUTS", "asking", "emitting", "main", "measuring", "recordings"]
