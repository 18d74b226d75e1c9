"""Elimination over the rationals: small linear systems solved exactly, and the rank of a matrix."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction


def solve(rows: Sequence[Sequence[Fraction]], right: Sequence[Fraction]) -> list[Fraction]:
    """Solve a square linear system. Raises ZeroDivisionError for a singular one."""
    size = len(rows)
    work = [[*row, side] for row, side in zip(rows, right, strict=True)]
    for column in range(size):
        pivot = next((row for row in range(column, size) if work[row][column]), column)
        work[column], work[pivot] = work[pivot], work[column]
        for row in range(size):
            if row != column and work[row][column]:
                factor = work[row][column] / work[column][column]
                work[row] = [p - factor * q for p, q in zip(work[row], work[column], strict=True)]
    return [work[i][size] / work[i][i] for i in range(size)]


def rank(rows: Sequence[Sequence[Fraction]]) -> int:
    """Return the rank of a matrix."""
    work = [list(row) for row in rows]
    found = 0
    for column in range(len(work[0]) if work else 0):
        pivot = next((row for row in range(found, len(work)) if work[row][column]), None)
        if pivot is None:
            continue
        work[found], work[pivot] = work[pivot], work[found]
        for row in range(found + 1, len(work)):
            factor = work[row][column] / work[found][column]
            work[row] = [p - factor * q for p, q in zip(work[row], work[found], strict=True)]
        found += 1
    return found
