"""From `mac` to the integer operations that C is printed from: exact passes, one after the other.

How products are made is the core's affair: `wide`, of words twice as wide, by an instruction or, under the name of
`library`, by the compiler's library; `limbs`, of 32-bit products of parts of words; `limbs-shared`, of these in
functions that several sums call.
"""

from __future__ import annotations

from qcone.ir.statement import Routine
from qcone.passes.expand import expand
from qcone.passes.limb_ranges import Norms
from qcone.passes.limb_sums import made_of_limbs
from qcone.passes.negate import negate
from qcone.passes.read_late import read_late

LIMBS = ("limbs", "limbs-shared")


def to_integers(routine: Routine, proved: bool, products: str = "wide", norms: Norms = ()) -> Routine:
    """Return a routine of `mac` operations in integer operations, its products made as `products` says.

    Unless all is `proved` to fit, no word is negated for its own sake, no sum is made in a single word, and none of
    limbs. `norms` are what is known of the lengths of sets of values.
    """
    if proved and products in LIMBS:
        return read_late(expand(routine, made=made_of_limbs(routine, norms, shared=products == "limbs-shared")))
    return read_late(expand(negate(routine) if proved else routine, narrow=proved))
