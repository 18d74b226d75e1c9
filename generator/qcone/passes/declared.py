"""What fixed point may rely on: declared ranges of what is handed in, and what follows for differences in time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from qcone.formats.fixed import Fixed
from qcone.passes.samples import Samples


@dataclass(frozen=True)
class Declaration:
    """What is declared of inputs: norms of the vectors handed in, and their differences in time.

    `turn` is what follows for the rotation vector of one update, rad.
    """

    inputs: Mapping[str, Fraction] = field(hash=False)
    samples: Samples | None = None
    turn: Fraction | None = None
    counts: Mapping[str, Fraction] = field(default_factory=dict, hash=False)
    """The largest whole count of a block of counts."""
    unlimited: frozenset[str] = frozenset()
    """Blocks that may hold any word: the routine limits them itself."""
    bounded: Mapping[str, Fraction] = field(default_factory=dict, hash=False)
    """The largest size of the scalars of further blocks."""
    renormalised: bool = True
    """Whether every update brings the attitude's length back."""
    series: Fraction | None = None
    """How far one update's rotation, as a series, is from a unit quaternion; None where it is not known."""
    pins: tuple[tuple[str, int], ...] = ()
    """Fraction bits that values of an update shall have, by name."""


def with_last_bits(declaration: Declaration, number: Fixed) -> Declaration:
    """Return the declaration of samples that were rounded to words: differences may be larger by a last bit."""
    if declaration.samples is None:
        return declaration
    lsb = 2 * number.ulp(declaration.samples.largest)
    return replace(declaration, samples=replace(declaration.samples, lsb=lsb))


def scaled(declaration: Declaration, part: Fraction) -> Declaration:
    """Return the declaration of a smaller range."""
    samples, turn = declaration.samples, declaration.turn
    if samples is not None:
        first, second = (each and each * part for each in (samples.first, samples.second))
        samples = replace(samples, largest=samples.largest * part, first=first, second=second)
    inputs = {name: bound * part for name, bound in declaration.inputs.items()}
    return replace(declaration, inputs=inputs, samples=samples, turn=turn and turn * part)
