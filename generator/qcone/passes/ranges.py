"""Bound what an update sees: the Euclidean norm of every vector, from the norms declared for its inputs.

|a + b| <= |a| + |b|, |c a| = |c| |a|, |a x b| <= |a| |b|, |a . b| <= |a| |b|: over the rationals, exact.
"""

from __future__ import annotations

from fractions import Fraction

from qcone.ir.statement import Routine, reachable


def norms(routine: Routine) -> tuple[Fraction | None, ...]:
    """Return a bound for every group of the routine; None where nothing is known."""
    bounds: list[Fraction | None] = []
    for group in routine.groups:
        known = [bounds[operand] for operand in group.operands]
        operands = [each for each in known if each is not None]
        if group.norm is not None:
            bounds.append(group.norm)
        elif not known or len(operands) < len(known):
            bounds.append(None)
        elif group.kind in ("sum", "difference"):
            bounds.append(operands[0] + operands[1])
        elif group.kind == "scale" and group.factor is not None:
            bounds.append(abs(group.factor) * operands[0])
        elif group.kind in ("cross", "dot", "product"):
            bounds.append(operands[0] * operands[1])
        elif group.kind in ("part", "row", "exp"):
            bounds.append(operands[0])
        else:
            bounds.append(None)
    return tuple(bounds)


def rotation_vector_bound(routine: Routine) -> Fraction | None:
    """Return a bound of the largest |phi| handed to exp in the routine; None if it calls no exp.

    Raises ValueError when an exponential's argument cannot be bounded; inside a subroutine none can.
    """
    for callee in reachable(routine):
        if any(group.kind == "exp" for group in callee.groups):
            raise ValueError(f"{callee.name}: a subroutine takes exp of an argument for which no bound is known")
    found: list[Fraction] = []
    for group, bound in zip(routine.groups, norms(routine), strict=True):
        if group.kind == "exp":
            if bound is None:
                raise ValueError(f"{routine.name}: no bound is known for the argument of exp")
            found.append(bound)
    return max(found, default=None)
