"""Chains of direction cosine matrices, with the rounding of every sum carried to the next."""

from __future__ import annotations

import numpy as np

from qcone.reference.quaternion import Array
from qcone.reference.renormalisation import reorthogonalise


def chain_matrices(start: Array, change: Array, *, orthogonal: bool = False) -> Array:
    """Return C_nb (n, 3, 3) after each update C_{k+1} = C_k (I + change_k), from `start` (3, 3).

    `change` (n, 3, 3) is R - I. With `orthogonal` every attitude goes through one step C (3 I - C^T C)/2
    before the next update; without it C keeps whatever orthogonality the updates have.
    """
    c = np.array(start, dtype=np.float64)
    carried = np.zeros((3, 3))
    attitudes = np.empty((len(change), 3, 3))
    for k, turn in enumerate(np.asarray(change, dtype=np.float64)):
        delta = c @ turn + carried
        if orthogonal:
            raw = c + delta
            delta = delta + (reorthogonalise(raw) - raw)
        following = c + delta
        carried = delta - (following - c)
        c = attitudes[k] = following
    return attitudes
