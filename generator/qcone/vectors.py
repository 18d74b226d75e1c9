"""Vectors: the inputs on which C and model are compared, drawn from the declared range and its corners.

Lanes are independent runs; a lane's rows follow one another. Every lane begins with a restart; some restart
on every row (single step), most run on for long (chained).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone import sensor
from qcone.backends.bittrue import dtype_of
from qcone.bundle import Bundle
from qcone.declaration import in_fixed_point
from qcone.draws import attitudes, samples, smooth
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.statement import Block, Role
from qcone.passes.samples import Samples
from qcone.unit_vectors import HARMONICS, angles_of_encoder, harmonics
from qcone.words import to_increments, to_words

GO_ON, INIT, SET, CORRECT = 0, 1, 2, 3
LANES = 256
SINGLE_STEP_LANES = 8
CHAINED_LANES = 32
SUBNORMAL_ROWS = 8
"""Lanes that restart on every row; lanes that never do; rows of a chain that are subnormal throughout."""
CORRECTED = 0.05
"""How often the coefficients of a rotating unit are set anew."""


@dataclass(frozen=True)
class Vectors:
    """Rows by lane: arrays (lanes, steps, ...). `restart` says what precedes the update of a row.

    `attitude` (4) is for a SET, `before` (3) the rate that `start` takes, `inputs` the argument of `update`. Of a
    rotating unit `encoder` () is the angle after the update, `correction` (9) the harmonics for a CORRECT; where they
    are None they are zero.
    """

    restart: NDArray[np.int32]
    attitude: NDArray[Any]
    before: NDArray[Any]
    inputs: NDArray[Any]
    encoder: NDArray[Any] | None = None
    correction: NDArray[Any] | None = None

    @property
    def rows(self) -> int:
        """Return the number of updates."""
        return int(self.restart.size)

    def first(self, steps: int) -> Vectors:
        """Return the first rows of every lane."""
        cut = Vectors(*(each[:, :steps] for each in (self.restart, self.attitude, self.before, self.inputs)))
        if self.encoder is None or self.correction is None:
            return cut
        return replace(cut, encoder=self.encoder[:, :steps], correction=self.correction[:, :steps])

    @property
    def unit(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the angles (lanes, steps) and the harmonics (lanes, steps, 9) of a rotating unit."""
        shape, dtype = self.restart.shape, self.inputs.dtype
        angles = np.zeros(shape, dtype) if self.encoder is None else self.encoder
        return angles, np.zeros((*shape, HARMONICS), dtype) if self.correction is None else self.correction


def draw(bundle: Bundle, rows: int, seed: int = 1) -> Vectors:
    """Return at least `rows` rows of vectors for a design; the same for the same seed."""
    lanes = min(LANES, max(1, rows // 4))
    generator = np.random.default_rng(seed)
    shape = lanes, -(-rows // lanes)
    return _draw(bundle, generator, lambda: _restarts(generator, *shape), shape)


def draw_chain(bundle: Bundle, rows: int, seed: int = 1) -> Vectors:
    """Return one lane that runs on for `rows` rows without a restart, and a tenth as many with restarts after them.

    In the last rows every float is subnormal, +-1/16 of the smallest normal number (2^-130 in float32), the attitude
    the identity: a sum that is flushed to zero then shows in the attitude.
    """
    generator = np.random.default_rng(seed)
    tail = max(1, rows // 10)

    def restarts() -> NDArray[np.int32]:
        restart = np.full((1, rows + tail), GO_ON, np.int32)
        restart[0, 0] = SET
        restart[0, rows:] = generator.choice([GO_ON, INIT, SET], tail, p=[0.4, 0.2, 0.4])
        restart[0, -min(tail, SUBNORMAL_ROWS) :] = INIT
        return restart

    chain = _draw(bundle, generator, restarts, (1, rows + tail))
    if chain.inputs.dtype.kind == "f":
        last = chain.inputs[:, -min(tail, SUBNORMAL_ROWS) :]
        last[:] = np.copysign(np.finfo(last.dtype).tiny / 16, last)
    return chain


def _draw(
    bundle: Bundle,
    generator: np.random.Generator,
    restarts: Callable[[], NDArray[np.int32]],
    shape: tuple[int, int],
) -> Vectors:
    block = bundle.machine.routine("update").having(Role.INPUT)[0]
    setting = bundle.machine.routine(bundle.driver.setter).having(Role.INPUT)[0]
    counted = bundle.facts.design.input == "counts"
    radius = sensor.counts_radius(bundle.facts.design) if counted else float(block.norm or 1)
    kind = dtype_of(bundle.facts.number) if block.format is None else np.float64
    known = known_samples(bundle)
    if known is None or known.first is None:
        inputs = samples(generator, (*shape, block.count), radius, kind)
        before = samples(generator, shape, radius, kind)
    else:
        inputs, before = smooth(generator, (*shape, block.count), known)
    inputs = inputs.reshape(*shape, block.size)
    starts = in_form(attitudes(generator, shape), bundle.driver.setter)
    vectors = Vectors(
        restarts(),
        to_words(bundle, setting.name, starts),
        _inside(to_words(bundle, block.name, before), block),
        _beyond(bundle, _inside(to_words(bundle, block.name, inputs, bundle.driver.input_ctype), block), generator),
    )
    return _with_unit(bundle, vectors, generator) if bundle.driver.stage else vectors


def _with_unit(bundle: Bundle, vectors: Vectors, generator: np.random.Generator) -> Vectors:
    """Return the vectors with angles and harmonics of a rotating unit, set anew now and then.

    Of several lanes every one begins at `init`: harmonics outlast the setting of an attitude, and another lane's are
    not its own.
    """
    restart, shape = vectors.restart, vectors.restart.shape
    if shape[0] > 1:
        restart[:, 0] = INIT
    corrected = generator.random(shape) < CORRECTED
    corrected[::2, 1:2] = True
    restart[corrected & (restart == GO_ON)] = CORRECT
    fixed, largest = isinstance(bundle.facts.number, Fixed), float(bundle.facts.known.correction or 0)
    dtype = np.float64 if fixed else dtype_of(bundle.facts.number)
    angles = angles_of_encoder(generator, shape, dtype)
    waves = harmonics(generator, shape, largest, dtype)
    words = to_words(bundle, "encoder", angles), to_words(bundle, "azimuth", waves)
    return replace(vectors, encoder=words[0], correction=words[1])


def _beyond(bundle: Bundle, words: NDArray[Any], generator: np.random.Generator) -> NDArray[Any]:
    """Replace some rows by any words there are, for designs that say what happens beyond the declared range."""
    number = bundle.facts.design.number
    if not isinstance(bundle.facts.number, Fixed) or (number.overflow == "prove" and not number.clamp_inputs):
        return words
    info = np.iinfo(words.dtype)
    wild = generator.integers(info.min, info.max, words.shape, dtype=np.int64, endpoint=True).astype(words.dtype)
    ends = generator.random(words.shape) < 0.2
    wild[ends] = generator.choice([info.min, info.max, 0], words.shape)[ends]
    chosen = (generator.random(words.shape[:2]) < 0.5) & (np.arange(len(words)) % 4 == 0)[:, None]
    return np.where(chosen[..., None], wild, words)


def known_samples(bundle: Bundle) -> Samples | None:
    """Return what fixed point relies on of samples that follow one another; None for floats."""
    if isinstance(bundle.facts.number, Floating):
        return None
    return in_fixed_point(bundle.facts.design, bundle.facts.algorithm, bundle.facts.known, None).samples


def _inside(words: NDArray[Any], block: Block) -> NDArray[Any]:
    """Bring fixed-point words back that rounding took outside the declared range by more than it allows.

    A norm may exceed the declared one by a last bit. A vector on the surface, rounded, may by the root of three halves
    of one; then its components are cut by a last bit.
    """
    if block.format is None or block.norm is None:
        return words
    largest = float(block.norm / block.format.lsb) + 1
    entries = words.reshape(*words.shape[:-1], -1, 3).astype(np.float64)
    over = np.sqrt((entries**2).sum(axis=-1, keepdims=True)) > largest
    cut = np.where(over, entries - np.sign(entries), entries)
    return cut.reshape(words.shape).astype(words.dtype)


def in_words(
    bundle: Bundle, restart: NDArray[np.int32], attitude: NDArray[Any], before: NDArray[Any], inputs: NDArray[Any]
) -> Vectors:
    """Return real values as the C takes them: attitudes and rates rounded, increments with the residue carried on.

    `inputs` (lanes, steps, N, 3) follow one another within a lane.
    """
    lanes, steps = restart.shape
    block = bundle.machine.routine("update").having(Role.INPUT)[0]
    setting = bundle.machine.routine(bundle.driver.setter).having(Role.INPUT)[0]
    if block.name == "omega":
        words = to_words(bundle, block.name, inputs)
    else:
        words = to_increments(bundle, inputs.reshape(lanes, -1, 3), axis=1)
    given = np.ascontiguousarray(words.reshape(lanes, steps, -1))
    return Vectors(restart, to_words(bundle, setting.name, attitude), to_words(bundle, block.name, before), given)


def in_form(q: NDArray[Any], setter: str, convention: str = "zyx") -> NDArray[Any]:
    """Return unit quaternions (..., 4) as the state takes them: so, as matrices (..., 9) or Euler angles (..., 3)."""
    if setter == "set_quaternion":
        return q
    w, x, y, z = np.moveaxis(q, -1, 0)
    if setter == "set_euler":
        return _angles(w, x, y, z, convention)
    rows = [
        *(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        *(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        *(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    ]
    return np.stack(rows, axis=-1)


def _restarts(generator: np.random.Generator, lanes: int, steps: int) -> NDArray[np.int32]:
    restart = generator.choice([GO_ON, INIT, SET], (lanes, steps), p=[0.97, 0.01, 0.02]).astype(np.int32)
    restart[:CHAINED_LANES] = GO_ON
    restart[-SINGLE_STEP_LANES:] = SET
    restart[:, 0] = generator.choice([INIT, SET], lanes)
    return restart


def _angles(w: NDArray[Any], x: NDArray[Any], y: NDArray[Any], z: NDArray[Any], convention: str) -> NDArray[Any]:
    """Return roll, pitch, yaw by half sums and half differences."""
    a, b = (x, y) if convention == "zyx" else (y, -x)
    half_sum, half_difference = np.arctan2(z + a, w - b), np.arctan2(z - a, w + b)
    up, down = np.hypot(w + b, z - a), np.hypot(w - b, z + a)
    pitch = (2 * np.arctan2(up, down) - np.pi / 2) * (1 if convention == "zyx" else -1)
    return np.stack([half_sum - half_difference, pitch, half_sum + half_difference], axis=-1)
