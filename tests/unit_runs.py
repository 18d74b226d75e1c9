"""The compiled C of a rotating unit on rows of angles, harmonics and attitudes, and the exact functions beside it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np
from numpy.typing import ArrayLike, NDArray

from qcone.bundle import Bundle
from qcone.design import Design
from qcone.ir.statement import Role
from qcone.targets.compiler import Compiler
from qcone.vectors import CORRECT, INIT, SET, Vectors, in_form
from qcone.verify import c_words, differing_bits, model_words, open_library
from qcone.words import TYPES, from_words, to_words
from shipped import design_of

EXACT = mpmath.mp.clone()
EXACT.dps = 40
Array = NDArray[Any]


def unit(example: str = "rotation-vector subsamples=1", **options: object) -> Design:
    """Return a design of the catalogue with the stage of a rotating unit; 600 arcsec unless `options` say otherwise."""
    return design_of(example, **{"max_correction_arcsec": 600, **options})


@dataclass(frozen=True)
class Turned:
    """What each row was given, as the C takes it, and gave: angles (n,), tilt (n, 2), quaternions (n, 4), and so on."""

    encoder: Array
    q_ns: Array
    angle: Array
    tilt: Array
    q_nb: Array
    dcm: Array | None
    euler: Array | None
    harmonics: Array


def turned(
    bundle: Bundle,
    compiler: Compiler,
    encoder: ArrayLike,
    harmonics: ArrayLike,
    attitude: ArrayLike,
    model: bool = True,
) -> Turned:
    """Set each row's harmonics (9), then its attitude (w, x, y, z), stand still for an update, and run the stage.

    With `model` the bit-true model runs too and may not differ in any bit.
    """
    rows = len(np.asarray(encoder))
    restart = np.full((1, 2 * rows + 1), SET, np.int32)
    restart[0, 1::2], restart[0, 0] = CORRECT, INIT
    size = bundle.machine.routine("update").having(Role.INPUT)[0].size
    held = in_form(np.broadcast_to(np.asarray(attitude, np.float64), (rows, 4)), bundle.driver.setter)

    setting = bundle.machine.routine(bundle.driver.setter).having(Role.INPUT)[0]

    def doubled(block: str, values: ArrayLike, *shape: int) -> Array:
        whole = np.broadcast_to(to_words(bundle, block, np.asarray(values, np.float64)), (rows, *shape))
        return np.concatenate([whole[:1], np.repeat(whole, 2, axis=0)])[np.newaxis]

    still = np.zeros((1, 2 * rows + 1, 3), TYPES[bundle.driver.ctype])
    vectors = Vectors(
        restart,
        doubled(setting.name, held, held.shape[1]),
        still,
        np.zeros((1, 2 * rows + 1, size), TYPES[bundle.driver.input_ctype]),
        doubled("encoder", encoder),
        doubled("azimuth", harmonics, 9),
    )
    words, contracted = c_words(bundle, open_library(bundle, compiler, "-O2"), vectors)
    assert not contracted
    if model:
        assert differing_bits(words, model_words(bundle, vectors)) == 0
    given = from_words(bundle, "encoder", vectors.unit[0][0, 2::2])
    return _named(bundle, words[0, 2::2], given, from_words(bundle, "azimuth", vectors.unit[1][0, 2::2]))


def _named(bundle: Bundle, words: Array, encoder: Array, harmonics: Array) -> Turned:
    found, first = {}, len(bundle.driver.state_words)
    for name, _ in bundle.driver.reported:
        for block in bundle.machine.routine(name).having(Role.OUTPUT):
            found[name, block.name] = from_words(bundle, block.name, words[:, first : first + block.size])
            first += block.size
    return Turned(
        encoder,
        found["quaternion", "q_nb"],
        found["correct", "angle"][:, 0],
        found["correct", "tilt"],
        found["body_quaternion", "q_nb"],
        found.get(("body_dcm", "c_nb")),
        found.get(("body_euler", "rpy")),
        harmonics,
    )


def exact_correction(encoder: float, harmonics: Array) -> tuple[Any, Any, Any]:
    """Return the corrected angle and the tilts about x and y of one row, to 40 digits; rins (13), (15), (16)."""
    al, (a, b, c, *rest) = EXACT.mpf(encoder), [EXACT.mpf(value) for value in harmonics.tolist()]
    corrected = al - (a * EXACT.sin(al) + b * EXACT.cos(al) + c)
    twice = (EXACT.sin(2 * corrected), EXACT.cos(2 * corrected), 1)
    return corrected, EXACT.fdot(rest[:3], twice), EXACT.fdot(rest[3:], twice)


def exact_body(q_ns: Array, angle: float, tilt: Array) -> list[Any]:
    """Return C_s^n C_s'^s C_b^s' as a quaternion, to 40 digits, by three turns back about y, x and z; rins (10)."""
    found = [EXACT.mpf(value) for value in q_ns.tolist()]
    for axis, turn in ((1, float(tilt[1])), (0, float(tilt[0])), (2, angle)):
        half = EXACT.mpf(turn) / 2
        back = [EXACT.cos(half), EXACT.mpf(0), EXACT.mpf(0), EXACT.mpf(0)]
        back[1 + axis] = -EXACT.sin(half)
        found = _product(found, back)
    return found


def _product(p: list[Any], q: list[Any]) -> list[Any]:
    (a, b, c, d), (w, x, y, z) = p, q
    return [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]


def rows(number: str, count: int, largest: float, seed: int = 3) -> tuple[Array, Array, Array]:
    """Return encoder angles, harmonics and attitudes, rounded: all turns, multiples of pi/4 and their neighbours."""
    random, dtype = np.random.default_rng(seed), np.dtype(number).type
    eighths = (np.pi / 4 * np.arange(-12, 13)).astype(dtype)
    near = np.concatenate([eighths, np.nextafter(eighths, dtype(0)), [dtype(0.0), dtype(-0.0), np.finfo(dtype).tiny]])
    angle = np.concatenate([np.tile(near, 4), random.uniform(-3 * np.pi, 3 * np.pi, count).astype(dtype)])
    total = len(angle)
    phase, share = random.uniform(-np.pi, np.pi, (total, 3)), random.uniform(-1, 1, (total, 3))
    size = largest * np.where(random.random((total, 3)) < 0.5, 1, random.random((total, 3)))
    parts = [(1 - np.abs(share)) * size * np.sin(phase), (1 - np.abs(share)) * size * np.cos(phase), share * size]
    harmonics = np.stack(parts, axis=-1).reshape(total, 9)
    harmonics[: len(near)] = 0  # angles and corners as they are
    q = random.standard_normal((total, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    q[: 2 * len(near)] = np.eye(4)[0]
    return angle, harmonics.astype(dtype), q
