"""Admission: what only the whole design shows to be impossible, said before anything is built (codes QC2xx)."""

from __future__ import annotations

from qcone.design import Design
from qcone.errors import DesignError, Problem
from qcone.formats.fixed import WIDTHS, Fixed
from qcone.formats.floating import FLOATING, Floating
from qcone.ir.specification import Algorithm


def problem(design: Design, code: str, what: str, why: str = "", hint: str = "") -> DesignError:
    """Return the error of one mistake that only the whole design shows."""
    place = f"{design.file}:{design.line}" if design.file else "command line"
    return DesignError([Problem(place, code, f"design '{design.name}': {what}", why, hint)])


def number_of(design: Design) -> Floating | Fixed:
    """Return the design's number format. Raises DesignError for what does not go with it."""
    chosen = design.number
    if chosen.format in FLOATING:
        if design.input == "counts":
            what = f'input = "counts" does not go with number.format = "{chosen.format}"'
            why = "whole counts become increments in integers, the residue carried"
            raise problem(design, "QC202", what, why, f"use {' or '.join(WIDTHS)}")
        return FLOATING[chosen.format]
    for key, given, other, why, hint in (
        ("form", design.form, "as-written", "the paper's form is written for real numbers", 'set form = "factored"'),
        ("loop", design.loop, "rolled", "every turn has formats of its own", 'set loop = "unrolled"'),
    ):
        if given == other:
            raise problem(design, "QC201", f'{key} = "{other}" does not go with "{chosen.format}"', why, hint)
    return Fixed(chosen.format, WIDTHS[chosen.format], chosen.rounding, chosen.overflow)


def check_stages(design: Design, algorithm: Algorithm) -> None:
    """Raise DesignError when the input, or the stage from rates to increments, does not fit the algorithm."""
    if algorithm.takes == "omega" and design.input != "rate":
        what = f'{algorithm.name} takes rates, the design has input = "{design.input}"'
        why = "it evaluates the rate at instants, the newest at the end of the interval"
        raise problem(design, "QC207", what, why, 'set input = "rate" and give it rates (replay: --input rate)')
    if design.increments != "interpolating" and design.input != "rate":
        what = f'increments = "{design.increments}" belongs to input = "rate"'
        raise problem(design, "QC205", what, "angle increments need no stage before the update", "leave the key out")
    if algorithm.state == "euler":
        _check_angles(design, algorithm)
    if design.increments == "cao-13" and algorithm.subsamples != 3:
        what = f'increments = "cao-13" needs three sub-samples, the algorithm has {algorithm.subsamples}'
        raise problem(design, "QC206", what, "cao (13) is a rule for four rates", 'use increments = "interpolating"')


def _check_angles(design: Design, algorithm: Algorithm) -> None:
    """Raise DesignError for what an attitude kept as roll, pitch, yaw cannot have."""
    refused = (
        ("euler", design.euler, "zxy", "its equations are those of zyx", "leave the key out"),
        ("accumulate", design.number.accumulate, "compensated", "angles are wrapped, not carried on", "leave it out"),
        ("renormalise", design.renormalise, "separate", "angles have no length to bring back", "leave it out"),
    )
    for key, given, other, why, hint in refused:
        if given == other:
            raise problem(design, "QC208", f'{algorithm.name} has no {key} = "{other}"', why, hint)
