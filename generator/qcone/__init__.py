"""qcone: from the equation in the paper to attitude firmware you can trust.

Frames, units and letters, once. A vector has components along body axes x forward, y right, z down unless a
design permutes them; v_n = C_nb v_b takes it to navigation. Quaternions are scalar first, w, x, y, z, with
Hamilton's product: q' = 1/2 q (x) (0, omega), q_(k+1) = q_k (x) r_k, v_n = q (x) v_b (x) q*. Rates are rad/s,
angle increments `dtheta` and rotation vectors `phi` rad, time s; keys of design files name other units.

What an author of an algorithm needs is loaded from here on first use; importing qcone loads no more.
"""

from __future__ import annotations

from typing import Any

__version__ = "0.1.0"

_AUTHOR = (
    "Algorithm", "F", "Source", "algorithm", "cross", "dot", "exp", "history", "loop", "matrix", "named", "number",
    "quaternion", "rotation", "sqrt", "step", "subroutine", "table",
)  # fmt: skip
__all__ = ["__version__", *_AUTHOR]


def __getattr__(name: str) -> Any:
    """Load a public name from the real language on first use."""
    if name not in _AUTHOR:
        raise AttributeError(f"module 'qcone' has no attribute '{name}'")
    from qcone.ir import real

    return getattr(real, name)
