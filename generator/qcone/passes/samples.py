"""Samples in time: bounds of weighted sums of them, by how far neighbours and second differences are apart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from qcone.ir.detail import Sum
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation
from qcone.passes.intervals import ZERO

Form = tuple[dict[tuple[str, int], Fraction], Fraction]
"""Weights by (block, component), and the roundings of their sum."""


@dataclass(frozen=True)
class Samples:
    """Samples in time: how far apart neighbours and second differences are at most, and where components lie.

    `at` gives the instant, counted in samples, of a component; components of one axis are told apart by it.
    """

    largest: Fraction
    first: Fraction | None
    second: Fraction | None
    at: Mapping[tuple[str, int], tuple[int, int]] = field(hash=False)
    """(axis, instant) by (block, component)."""
    lsb: Fraction = ZERO

    def bound(self, form: Mapping[tuple[str, int], Fraction], error: Fraction) -> Fraction:
        """Bound sum c_i x_i by the samples, by their first and by their second differences (Abel's summation)."""
        instants = [self.at[key][1] for key in form]
        row = [ZERO] * (max(instants) - min(instants) + 1)
        for key, factor in form.items():
            row[self.at[key][1] - min(instants)] += factor
        size = sum((abs(each) for each in row), ZERO)
        bounds = [size * self.largest]
        if self.first is not None:
            total, partial = _partial(row)
            ends = abs(total) * self.largest
            bounds.append(ends + sum((abs(each) for each in partial), ZERO) * self.first)
            if self.second is not None and partial:
                inner, twice = _partial(partial)
                rest = sum((abs(each) for each in twice), ZERO) * self.second
                bounds.append(ends + abs(inner) * self.first + rest)
        return min(bounds) + size * self.lsb + error


def _partial(row: list[Fraction]) -> tuple[Fraction, list[Fraction]]:
    """Return the sum of a row, and its partial sums but the last: sum c_i x_i = C x_last - sum C_i (x_i+1 - x_i)."""
    sums, total = [], ZERO
    for each in row:
        total += each
        sums.append(total)
    return total, sums[:-1]


class Forms:
    """Which values of a routine are weighted sums of samples, all of one axis, and what bounds them."""

    def __init__(self, samples: Samples | None) -> None:
        """Begin with none; without samples there never are any."""
        self.samples = samples
        self._forms: dict[int, Form] = {}

    def note(self, operation: Operation, error: Fraction) -> None:
        """Note a result, rounded with that error, if it is such a sum."""
        if self.samples is None:
            return
        if operation.op is RealOp.READ and operation.place is not None:
            key = (operation.place.block, operation.place.index.constant)
            if key in self.samples.at:
                self._forms[operation.result] = ({key: Fraction(1)}, ZERO)
            return
        if operation.op not in (RealOp.SUM, RealOp.WIDE) or not isinstance(operation.detail, Sum):
            return
        total: dict[tuple[str, int], Fraction] = {}
        for term in operation.detail.terms:
            form = self._forms.get(term.args[0]) if len(term.args) == 1 else None
            if form is None:
                return
            for key, factor in form[0].items():
                total[key] = total.get(key, ZERO) + term.coefficient * factor
            error += abs(term.coefficient) * form[1]
        if len({self.samples.at[key][0] for key in total}) == 1:
            self._forms[operation.result] = (total, error)

    def bound(self, value: int) -> Fraction | None:
        """Return the largest size of a value; None where it is no such sum."""
        form = self._forms.get(value)
        return None if form is None or self.samples is None else self.samples.bound(*form)

    def norm(self, values: tuple[int, ...]) -> Fraction | None:
        """Return the largest norm of three components that are one weighted sum of sample vectors; None otherwise.

        What is declared of samples and their differences are norms, so one bound holds for the vector.
        """
        forms = [form for value in values if (form := self._forms.get(value)) is not None]
        if len(values) != 3 or self.samples is None or len(forms) != 3:
            return None
        at = self.samples.at
        rows = [{(key[0], at[key][1]): abs(factor) for key, factor in form[0].items()} for form in forms]
        axes = {at[key][0] for form in forms for key in form[0]}
        if rows[0] != rows[1] or rows[0] != rows[2] or len(axes) != 3:
            return None
        return self.samples.bound(forms[0][0], 2 * max(error for _, error in forms))
