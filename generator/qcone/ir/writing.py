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
class Functions:
    """Polynomials of the functions that output stages need, by exact coefficients.

    atan(t) = t + t^3 (arctangent[0] + arctangent[1] t^2 + ...) for |t| <= 0.4143, `eighth` being tan(pi/8);
    1/sqrt(t) begins at reciprocal_root[0] + reciprocal_root[1] t + ... on [1, 4]; `ladder` lists the powers of four
    by which a square root brings its argument there, the largest first. sin(t) = t + t^3 (sine[0] + ...) and
    cos(t) = 1 + t^2 (cosine[0] + ...) for 0 <= t <= pi/4. `smallest` is what a divisor is at least in fixed point,
    `negligible` the ratio up to which floats take an angle for 0.
    """

    arctangent: tuple[Fraction, ...]
    eighth: Fraction
    reciprocal_root: tuple[Fraction, ...]
    ladder: tuple[int, ...]
    sine: tuple[Fraction, ...]
    cosine: tuple[Fraction, ...]
    smallest: Fraction
    negligible: Fraction


@dataclass(frozen=True)
class SmallAngle:
    """The series of sine and cosine as far as angles of at most `largest` rad need them, by exact coefficients.

    sin(t) = t + t^3 (sine[0] + sine[1] t^2 + ...) and cos(t) = 1 + t^2 (cosine[0] + ...); either may be empty.
    """

    largest: Fraction
    sine: tuple[Fraction, ...]
    cosine: tuple[Fraction, ...]


@dataclass(frozen=True)
class Writing:
    """The choices that change what is written down, all others being equal.

    `form` is "as-written" (square root, divisions, sine and cosine, plain product, as the paper counts) or
    "factored" (polynomials, an increment held apart from 1). `accumulate` is "standard", q (x) r, or
    "delta", q + q (x) (r - 1). `renormalise` folds e = (1 - |q|^2)/2 into the scalar part of r. `rolled`
    keeps the author's loops. `series` is what exp() uses, `functions` what arctangents and roots use, `small_angle`
    what corrections of a bounded size use; None where they are not chosen: in the real language. `fixed` writes for a
    fixed-point format, where sums are exact but for one rounding and every range must be plain; `carry` carries the
    rounding of rotation vectors to the next update.
    """

    form: str = "factored"
    series: Series | None = None
    accumulate: str = "delta"
    renormalise: bool = True
    rolled: bool = False
    functions: Functions | None = None
    small_angle: SmallAngle | None = None
    fixed: bool = False
    carry: bool = False

    @property
    def as_written(self) -> bool:
        """Tell whether this is the paper's own form."""
        return self.form == "as-written"


AS_WRITTEN = Writing(form="as-written", accumulate="standard", renormalise=False)
