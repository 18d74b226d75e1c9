"""Lengths: the Euclidean norm of what is made of vectors and quaternions, from the norms of these."""

from __future__ import annotations

from fractions import Fraction

from qcone.ir.statement import Group
from qcone.passes.intervals import ZERO, Interval, plus, root_above, times


def norm_of(group: Group, single: bool, operands: list[Interval], sizes: list[int]) -> Interval | None:
    """Return the bound of a group from those of its operands."""
    first, last = operands[0], operands[-1]
    match group.kind:
        case "sum" | "difference" if len(operands) == 2:
            if single:
                return plus(first, last if group.kind == "sum" else (-last[1], -last[0]))
            return (max(ZERO, first[0] - last[1], last[0] - first[1]), first[1] + last[1])
        case "scale" if group.factor is not None:
            if single:
                return times((group.factor, group.factor), first)
            return (abs(group.factor) * first[0], abs(group.factor) * first[1])
        case "cross":
            return (ZERO, first[1] * last[1])
        case "dot":
            if group.operands[0] == group.operands[1]:
                return (first[0] * first[0], first[1] * first[1])
            return (-first[1] * last[1], first[1] * last[1])
        case "product":
            if single:
                return times(first, last)
            ends = [max(-a, b) if size == 1 else b for (a, b), size in zip(operands, sizes, strict=True)]
            low = first[0] * last[0] if 1 not in sizes else ZERO
            return (low, ends[0] * ends[1])
        case "part":
            most = max(-first[0], first[1])
            return (-most, most) if single else (ZERO, most)
        case "rotated":
            return _rotated(operands[:3], renormalised=bool(group.factor))
        case "row_renormalised" if first[1] ** 2 > Fraction(3, 2):
            return None  # |a|^2 <= 2 (1 + e_b) is not known to hold
        case "renormalised" | "row_renormalised":
            low, high = _length_after(first, ZERO, ZERO) if group.factor else first
            change = last[1] if len(operands) > 1 else ZERO
            low = ZERO if group.kind == "row_renormalised" else max(ZERO, low - change)
            return (low, high + change)
        case "row":
            return first
        case "matrix":  # of a quaternion: 1 - 2 (y^2 + z^2), 2 (x y - w z) and so on, and the products' roundings
            return (ZERO, max(Fraction(1), 2 * first[1] * first[1] - 1) + Fraction(1, 2**8))
    return None


def _rotated(operands: list[Interval], renormalised: bool) -> Interval:
    """Bound |q (x) [1 + u + e, v]|, e = (1 - |q|^2)/2: |q|^2 ((1 + u + e)^2 + |v|^2)."""
    length, u, v = operands
    if not renormalised:
        low, high = length[0] * (1 + u[0]), length[1] * (1 + u[1])
    else:
        low, high = _length_after(length, u[0], u[1])
    across = length[1] * v[1]
    return (max(ZERO, low), root_above(high * high + across * across))


def _length_after(length: Interval, u_low: Fraction, u_high: Fraction) -> Interval:
    """Return the range of n (1 + u + (1 - n^2)/2) over the range of the length n: its maximum is at n^2 = 1 + 2u/3."""

    def at(n: Fraction, u: Fraction) -> Fraction:
        return n * (1 + u + (1 - n * n) / 2)

    top = max(at(length[0], u_high), at(length[1], u_high))
    square = 1 + 2 * u_high / 3
    if square > 0 and length[0] ** 2 <= square <= length[1] ** 2:
        top = max(top, root_above(square) * square)
    return min(at(length[0], u_low), at(length[1], u_low)), top
