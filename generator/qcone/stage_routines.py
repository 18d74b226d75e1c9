"""The routines of a rotating unit around an update: take its harmonics, correct its angle, give the body's attitude.

The attitude that the update keeps is that of the turning sensors; what is given here is that of the body; rins.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from qcone import state_routines as around
from qcone.algorithms import outputs, rotating_unit
from qcone.algorithms.rotating_unit import Harmonic
from qcone.ir.blocks import Matrix, Quaternion, Scalar, Vector
from qcone.ir.builder import Builder
from qcone.ir.functions import PI
from qcone.ir.statement import Block, Role, Routine, Shape, Step
from qcone.ir.writing import Writing

CORRECT, BODY = "correct", "body_quaternion"
ROUTINES = (CORRECT, BODY, "body_dcm", "body_euler")
"""What is called with the encoder's angle after an update, in this order: each takes what those before it gave."""

LARGEST_ANGLE = 3 * PI
"""The encoder's angle is at most so large in size, rad: 0..2 pi and -pi..pi, and half a turn beyond either."""


@dataclass(frozen=True)
class Kept:
    """What the state keeps of one harmonic: the name of its block, of what it corrects, and its letters in rins."""

    block: str
    of: str
    letters: str


KEPT = (
    Kept("azimuth_harmonic", "azimuth", "A, B, C of the encoder error A sin al + B cos al + C, rad"),
    Kept("tilt_x_harmonic", "tilt_x", "A2, B2, C2 of the tilt about x, A2 sin 2al + B2 cos 2al + C2, rad"),
    Kept("tilt_y_harmonic", "tilt_y", "A2, B2, C2 of the tilt about y, A2 sin 2al + B2 cos 2al + C2, rad"),
)


def bounds(largest: Fraction) -> dict[str, Fraction]:
    """Return the largest size of every scalar of the stage, component by component: rad.

    Of a harmonic sqrt(A^2 + B^2) + |C| <= largest. Seen one by one the terms may be larger: sines and cosines are
    known to 1 and a little, those of the doubled angle, as products, to 2.
    """
    angle = LARGEST_ANGLE + 4 * largest
    found = {"encoder": angle, "angle": angle, "tilt": 6 * largest}
    for each in KEPT:
        found |= {each.block: largest, each.of: largest}
    return found


def state(largest: Fraction) -> tuple[Block, ...]:
    """Return the blocks that keep the harmonics; `largest` bounds every coefficient, rad."""
    return tuple(Block(each.block, Shape.SCALAR, Role.STATE, 3, each.letters, largest) for each in KEPT)


def routines(
    blocks: tuple[Block, ...], wanted: tuple[str, ...], writing: Writing, convention: str
) -> tuple[Routine, ...]:
    """Return the stage's routines; the attitude is the first of the state's `blocks`, `wanted` are the outputs."""
    harmonics = tuple(block for each in KEPT for block in blocks if block.name == each.block)
    largest = harmonics[0].norm or Fraction(0)
    made = [_set_correction(harmonics, writing), _correct(harmonics, writing)]
    made.append(_body_quaternion(blocks[0], largest, writing, convention))
    if "dcm" in wanted:
        made.append(_body_dcm(writing))
    if "euler" in wanted:
        made.append(_body_euler(writing, convention))
    return tuple(made)


def _set_correction(harmonics: tuple[Block, ...], writing: Writing) -> Routine:
    """Write `set_correction`: the nine coefficients of a unit, kept as they are given."""
    given = [
        Block(each.of, Shape.SCALAR, Role.INPUT, 3, "rad", block.norm)
        for each, block in zip(KEPT, harmonics, strict=True)
    ]
    builder = Builder("set_correction", (*harmonics, *given), writing)
    for block, source in zip(harmonics, given, strict=True):
        values = [_scalar(builder, source, k, f"{source.name}_{part}") for k, part in enumerate(PARTS)]
        for k, value in enumerate(values):
            builder.write(block, k, value.value)
        builder.label(Step(block.unit))
    return builder.routine("Take the harmonics of the encoder's error and of the tilt.")


PARTS = ("sine", "cosine", "offset")


def _correct(harmonics: tuple[Block, ...], writing: Writing) -> Routine:
    """Write `correct`: the corrected angle, and the tilts that belong to it."""
    largest = harmonics[0].norm or Fraction(0)
    encoder = Block("encoder", Shape.SCALAR, Role.INPUT, unit="encoder angle, rad", norm=LARGEST_ANGLE)
    angle = Block("angle", Shape.SCALAR, Role.OUTPUT, unit="corrected angle, rad", norm=LARGEST_ANGLE + largest)
    tilt = Block("tilt", Shape.SCALAR, Role.OUTPUT, 2, "tilt about x and y, rad", largest)
    builder = Builder(CORRECT, (*harmonics, encoder, angle, tilt), writing)
    al = _scalar(builder, encoder, 0, "al")
    found: list[Harmonic] = []
    for each, block in zip(KEPT, harmonics, strict=True):
        sine, cosine, offset = (_scalar(builder, block, k, f"{each.of}_{part}") for k, part in enumerate(PARTS))
        found.append((sine, cosine, offset))
    builder.label(Step("the encoder's angle and the harmonics, read once"))
    corrected, delta_x, delta_y = rotating_unit.correction(al, *found)
    builder.write(angle, 0, corrected.value)
    builder.write(tilt, 0, delta_x.value)
    builder.write(tilt, 1, delta_y.value)
    return builder.routine("Correct the encoder's angle, and give the tilt of the sensors at it.")


def _body_quaternion(held: Block, largest: Fraction, writing: Writing, convention: str) -> Routine:
    """Write `body_quaternion`: the attitude of the body from that of the sensors, the angle and the tilt."""
    angle = Block("angle", Shape.SCALAR, Role.INPUT, unit="corrected angle, rad", norm=LARGEST_ANGLE + largest)
    tilt = Block("tilt", Shape.SCALAR, Role.INPUT, 2, "tilt about x and y, rad", largest)
    out = Block("q_nb", Shape.QUATERNION, Role.OUTPUT, unit="attitude of the body: w, x, y, z; body to navigation")
    builder = Builder(BODY, (held, angle, tilt, out), writing)
    quantity = around.read_once(builder, held)
    if isinstance(quantity, Matrix):
        quantity = outputs.quaternion_of(quantity)
    elif isinstance(quantity, Vector):
        quantity = outputs.quaternion_of_angles(quantity, convention)
    assert isinstance(quantity, Quaternion)
    al = _scalar(builder, angle, 0, "al")
    delta_x, delta_y = _scalar(builder, tilt, 0, "delta_x"), _scalar(builder, tilt, 1, "delta_y")
    builder.label(Step("corrected angle and tilts"))
    around.write(builder, out, 0, rotating_unit.body_attitude(quantity, al, delta_x, delta_y))
    return builder.routine("Give the attitude quaternion of the body.")


def _body_dcm(writing: Writing) -> Routine:
    """Write `body_dcm`: the matrix of the body's quaternion."""
    made = around.dcm(_of_body(), writing, "zyx")
    return replace(made, name="body_dcm", summary="Give the direction cosine matrix of the body.")


def _body_euler(writing: Writing, convention: str) -> Routine:
    """Write `body_euler`: roll, pitch and yaw of the body's quaternion."""
    made = around.euler(_of_body(), writing, convention)
    return replace(made, name="body_euler", summary="Give roll, pitch and yaw of the body.")


def _of_body() -> Block:
    return Block("q_nb", Shape.QUATERNION, Role.INPUT, unit="attitude of the body, as body_quaternion() gives it")


def _scalar(builder: Builder, block: Block, part: int, name: str) -> Scalar:
    """Read one component of a block by a name of its own."""
    value = builder.read(block, part)
    builder.names[value] = name
    return Scalar(builder, (value,), builder.group("input", (value,), norm=block.norm))
