"""Component numbers that count with the loops around them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Index:
    """A component number, affine in the counters of the loops around it."""

    constant: int = 0
    terms: tuple[tuple[str, int], ...] = ()

    def at(self, counters: Mapping[str, int]) -> int:
        """Return the number for the given values of the loop counters."""
        return self.constant + sum(factor * counters[name] for name, factor in self.terms)

    def __add__(self, other: Index | int) -> Index:
        """Add a number or another affine index."""
        if not isinstance(other, Index | int):
            return NotImplemented
        if isinstance(other, int):
            return Index(self.constant + other, self.terms)
        factors = dict(self.terms)
        for name, factor in other.terms:
            factors[name] = factors.get(name, 0) + factor
        kept = tuple((name, factor) for name, factor in factors.items() if factor)
        return Index(self.constant + other.constant, kept)

    __radd__ = __add__

    def __mul__(self, factor: int) -> Index:
        """Scale by a whole number; a product of two counters is not affine."""
        if not isinstance(factor, int):
            return NotImplemented
        terms = tuple((name, factor * each) for name, each in self.terms if factor * each)
        return Index(self.constant * factor, terms)

    __rmul__ = __mul__

    def __sub__(self, other: Index | int) -> Index:
        """Subtract a number or another affine index."""
        if not isinstance(other, Index | int):
            return NotImplemented
        return self + (-other if isinstance(other, int) else other * -1)

    def __rsub__(self, other: int) -> Index:
        """Subtract this index from a number."""
        return self * -1 + other

    def __str__(self) -> str:
        """Return the index as C writes it, `3 * n + j - 1`, a positive part first where there is one: `40 - 4 * j`."""
        parts = [(factor, name if abs(factor) == 1 else f"{abs(factor)} * {name}") for name, factor in self.terms]
        if self.constant or not parts:
            parts.append((self.constant, str(abs(self.constant))))
        first = next((part for part in parts if part[0] > 0), parts[0])
        parts.remove(first)
        text = ("-" if first[0] < 0 else "") + first[1]
        return text + "".join(f" {'-' if factor < 0 else '+'} {part}" for factor, part in parts)


FIRST = Index()
"""The first component."""
