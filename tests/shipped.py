"""The shipped designs, and designs of any algorithm of the catalogue, each built once for all tests."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path

import qcone
from qcone.algorithms import CATALOGUE
from qcone.algorithms import family as family_of
from qcone.bundle import Bundle
from qcone.design import Design, design_from_options, read_designs
from qcone.pipeline import build
from qcone.registry import entries

FOLDER = Path(qcone.__file__).parent / "designs"
DESIGNS = {design.name: design for file in sorted(FOLDER.glob("*.toml")) for design in read_designs(file, entries())}

EXAMPLES = {
    " ".join([family.id, *(f"{name}={value}" for name, value in example.items() if value)]): (family.id, example)
    for family in CATALOGUE
    for example in family.examples
}
"""Every algorithm of the catalogue: its family and its parameters, by a readable name."""

THROUGH_PHI = ("rotation-vector", "picard")
"""Families whose update is the exponential of a rotation vector, or a series of it."""
WITH_PHI = [name for name, (family, _) in EXAMPLES.items() if family in THROUGH_PHI]
WITHOUT_PHI = [name for name in EXAMPLES if name not in WITH_PHI]


@cache
def shipped(name: str) -> Bundle:
    return build(DESIGNS[name])


def tampered(name: str, old: str, new: str) -> Bundle:
    """Return a shipped design with one thing in its C that is another than the generator wrote."""
    bundle = shipped(name)
    assert old in bundle.source
    return replace(bundle, source=bundle.source.replace(old, new, 1))


def design_of(example: str, **options: object) -> Design:
    """Return the design of an algorithm of the catalogue; 0.1 rad an update unless `options` say otherwise.

    What evaluates the rate takes rates, everything else increments.
    """
    family, parameters = EXAMPLES[example]
    given = {name: value for name, value in parameters.items() if value}
    if family_of(family).make(parameters).takes == "omega":
        given["input"] = "rate"
    base: Mapping[str, object] = {"number": "float64", "max_rate_dps": "573", "update_hz": "100"}
    return design_from_options("tested", {"algorithm": family, **given, **base, **options}, entries())
