"""Words: real values as the C takes them and gives them back, in floats or in raw fixed-point words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.bundle import Bundle

Array = NDArray[Any]
TYPES: Mapping[str, Any] = {
    "float": np.float32,
    "double": np.float64,
    "int16_t": np.int16,
    "int32_t": np.int32,
    "int64_t": np.int64,
}
"""NumPy types by C type."""


def to_words(bundle: Bundle, block: str, values: Array, ctype: str | None = None) -> Array:
    """Return real values as words of a block handed in, each rounded to the nearest by itself.

    What is beyond the word is cut to its largest value.
    """
    dtype = TYPES[ctype or bundle.driver.ctype]
    bits = bundle.driver.bits(block)
    if bits is None:
        return values.astype(dtype)
    info = np.iinfo(np.dtype(dtype))
    words: Array = np.clip(np.rint(np.ldexp(np.asarray(values, np.float64), bits)), info.min, info.max).astype(dtype)
    return words


def to_increments(bundle: Bundle, values: Array, axis: int) -> Array:
    """Return angle increments as words, the residue of each rounding carried to the next one along `axis`.

    So a pulse counter works: what is rounded is the angle, and its differences are the increments.
    """
    block, ctype = bundle.driver_input, bundle.driver.input_ctype
    bits = bundle.driver.bits(block)
    if bits is None:
        return values.astype(TYPES[ctype])
    if block == "counts":
        return values.astype(TYPES[ctype])
    angle = np.cumsum(np.ldexp(np.asarray(values, np.longdouble), bits), axis=axis)
    whole = np.rint(angle)
    steps: Array = np.diff(whole, axis=axis, prepend=0).astype(TYPES[ctype])
    return steps


def from_words(bundle: Bundle, block: str, words: Array) -> NDArray[np.float64]:
    """Return the real values of words given out."""
    bits = bundle.driver.bits(block)
    values: NDArray[np.float64] = words.astype(np.float64)
    return values if bits is None else np.ldexp(values, -bits)
