"""Writing: how the shorthand of the papers, exp(phi) and q (x) r, is written out in operations."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class Series:
    """The two polynomials of the exponential of a rotation vector, in x = |phi|^2, by exact coefficients.

    cos(|phi|/2) - 1 = cosine[0] x + cosine[1] x^2 + ... and
    sin(|phi|/2)/|phi| = 1/2 + sine[0] x + sine[1] x^2 + ...
    """

    cosine: tuple[Fraction, ...]
    sine: tuple[Fraction, ...]


@dataclass(frozen=True)
class Writing:
    """The choices that change what is written down, all others being equal.

    `form` is "as-written" (square root, divisions, sine and cosine, plain product, as the paper counts) or
    "factored" (polynomials, an increment held apart from 1). `accumulate` is "standard", q (x) r, or
    "delta", q + q (x) (r - 1). `renormalise` folds e = (1 - |q|^2)/2 into the scalar part of r. `rolled`
    keeps the author's loops. `series` is what exp() uses; None where it is not yet chosen.
    """

    form: str = "factored"
    series: Series | None = None
    accumulate: str = "delta"
    renormalise: bool = True
    rolled: bool = False

    @property
    def as_written(self) -> bool:
        """Tell whether this is the paper's own form."""
        return self.form == "as-written"


AS_WRITTEN = Writing(form="as-written", accumulate="standard", renormalise=False)
