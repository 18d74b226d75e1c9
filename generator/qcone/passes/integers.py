"""From `mac` to the integer operations that C is printed from: exact passes, one after the other."""

from __future__ import annotations

from qcone.ir.statement import Routine
from qcone.passes.expand import expand
from qcone.passes.negate import negate
from qcone.passes.read_late import read_late


def to_integers(routine: Routine, proved: bool) -> Routine:
    """Return a routine of `mac` operations in integer operations of the generic core.

    Unless all is `proved` to fit, no word is negated for its own sake and no sum is made in a single word.
    """
    return read_late(expand(negate(routine) if proved else routine, narrow=proved))
