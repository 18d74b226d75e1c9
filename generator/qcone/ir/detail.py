"""What an operation needs beyond its operands: the terms of a sum, how it is rounded, the limits of a clamp.

A sum of products is one operation, with one rounding: in the real language its terms carry exact coefficients, in the
machine language they are aligned words in an accumulator.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from qcone.ir.index import Index


@dataclass(frozen=True)
class Term:
    """coefficient * product of the values `args`: none (a constant), one or two.

    With two values the coefficient is a power of two with a sign: it costs nothing. `part` is the value that the term
    was a part of before it was taken into a larger sum, `step` the heading that stood over it.
    """

    coefficient: Fraction
    args: tuple[int, ...] = ()
    part: int | None = None
    step: int = 0


@dataclass(frozen=True)
class Sum:
    """A sum of terms. `carried` asks the number format to carry its rounding on to the next update."""

    terms: tuple[Term, ...]
    carried: bool = False


@dataclass(frozen=True)
class Aligned:
    """A term of an accumulator: the product of one or two words, shifted left by `shift` bits."""

    args: tuple[int, ...]
    negative: bool = False
    shift: int = 0


@dataclass(frozen=True)
class Mac:
    """Aligned terms added in an accumulator of `accumulator` bits, of which the last `discard` are rounded away.

    `residual` is the component of the state block of that name in which what was rounded away waits for the next
    update; `limits` the raw values that the result is kept between where it saturates.
    """

    terms: tuple[Aligned, ...]
    accumulator: int
    discard: int
    rounding: str
    residual: tuple[str, Index] | None = None
    limits: tuple[int, int] | None = None


@dataclass(frozen=True)
class Shift:
    """Move by `bits`: to the left exactly, or to the right, a word of `width` bits, with a rounding."""

    bits: int
    rounding: str = ""
    width: int = 64


@dataclass(frozen=True)
class Limits:
    """The least and the greatest value of a clamp: exact numbers in the real language, raw words in the machine's."""

    low: Fraction
    high: Fraction


Detail = Sum | Mac | Shift | Limits
