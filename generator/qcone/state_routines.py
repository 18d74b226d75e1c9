"""The routines around an update: set the state, report it, in whatever form the attitude is kept.

The attitude block is `q` (quaternion), `c` (direction cosine matrix) or `rpy` (roll, pitch, yaw); every form reports
a quaternion, and a matrix or Euler angles where the design asks for them.
"""

from __future__ import annotations

from fractions import Fraction

from qcone.algorithms import attitude, outputs
from qcone.ir.blocks import Matrix, Quantity, Quaternion, Vector, of
from qcone.ir.builder import Builder
from qcone.ir.statement import Block, Place, Ready, Role, Routine, Shape, Step
from qcone.ir.writing import Writing
from qcone.sensor import clamped

ATTITUDES = {
    "quaternion": Block(
        "q", Shape.QUATERNION, Role.STATE, unit="attitude quaternion q_nb: w, x, y, z; body to navigation"
    ),
    "dcm": Block("c", Shape.MATRIX, Role.STATE, unit="direction cosine matrix C_nb, row major: v_n = C_nb v_b"),
    "euler": Block("rpy", Shape.VECTOR, Role.STATE, unit="roll, pitch, yaw, rad"),
}
"""The state block of each form of the attitude."""

GIVEN = {
    "q": Block("q_nb", Shape.QUATERNION, Role.INPUT, unit="unit attitude quaternion: w, x, y, z"),
    "c": Block("c_nb", Shape.MATRIX, Role.INPUT, unit="direction cosine matrix, row major"),
    "rpy": Block("angles", Shape.VECTOR, Role.INPUT, unit="roll, pitch, yaw, rad"),
}
SETTERS = {"q": "set_quaternion", "c": "set_dcm", "rpy": "set_euler"}
KEPT_ACROSS_SETTING = frozenset({"omega_last", "azimuth_harmonic", "tilt_x_harmonic", "tilt_y_harmonic"})
"""A rate sample stays the newest one when the attitude is set anew; a unit's harmonics belong to the unit."""


def initial(state: tuple[Block, ...], writing: Writing) -> Routine:
    """Write `init`: the identity attitude, everything else zero."""
    builder = Builder("init", state, writing)
    ones = {"q": {0}, "c": {0, 4, 8}, "rpy": set()}[state[0].name]
    for block in state:
        for part in range(block.size):
            one = block is state[0] and part in ones
            builder.write(block, part, builder.constant(Fraction(1 if one else 0)))
    return builder.routine("Set the identity attitude and clear the history.")


def setter(state: tuple[Block, ...], writing: Writing) -> Routine:
    """Write `set_quaternion`, `set_dcm` or `set_euler`: the attitude, normalised once, and an empty history."""
    held = state[0]
    given = GIVEN[held.name]
    builder = Builder(SETTERS[held.name], (*state, given), writing)
    quantity = read_once(builder, given)
    result: Quantity = quantity
    if isinstance(quantity, Quaternion):
        result = attitude.normalised(quantity)
    elif isinstance(quantity, Matrix):
        result = attitude.orthonormalised(quantity)
    for block in state:
        if block is held:
            write(builder, block, 0, result)
        elif block.name not in KEPT_ACROSS_SETTING:
            for part in range(block.size):
                builder.write(block, part, builder.constant(Fraction(0)))
    builder.label(Step("store"))
    once = {"q": ", normalised once,", "c": ", orthonormalised once,", "rpy": ""}[held.name]
    return builder.routine(f"Set the attitude{once} and clear the history.")


def start(omega_last: Block, writing: Writing, limit: Fraction | None = None) -> Routine:
    """Write `start`: the rate sample at the start of the first update, limited to `limit` where there is one."""
    given = Block("omega", Shape.VECTOR, Role.INPUT, unit="rad/s")
    builder = Builder("start", (omega_last, given), writing)
    taken = read(builder, given, 0)
    if limit is not None:
        assert isinstance(taken, Vector)
        taken = clamped(builder, taken, limit, limit)
        builder.label(Step("each component limited to the declared range"))
    write(builder, omega_last, 0, taken)
    return builder.routine("Take the rate sample at the start of the first update.")


def renormalise(held: Block, writing: Writing) -> Routine:
    """Write `renormalise`, for designs that leave it to the user."""
    builder = Builder("renormalise", (held,), writing)
    quantity = read_once(builder, held)
    result = attitude.normalised(quantity) if isinstance(quantity, Quaternion) else quantity
    result = attitude.orthonormalised(quantity) if isinstance(quantity, Matrix) else result
    write(builder, held, 0, result)
    return builder.routine("Bring the attitude back to unit length, by one Newton step.")


def quaternion(held: Block, writing: Writing, convention: str) -> Routine:
    """Write `quaternion`: the attitude as a quaternion, by Shepperd's rule from a matrix."""
    out = Block("q_nb", Shape.QUATERNION, Role.OUTPUT, unit="attitude quaternion: w, x, y, z; body to navigation")
    builder = Builder("quaternion", (held, out), writing)
    quantity = read_once(builder, held)
    if isinstance(quantity, Matrix):
        quantity = outputs.quaternion_of(quantity)
    elif isinstance(quantity, Vector):
        quantity = outputs.quaternion_of_angles(quantity, convention)
    write(builder, out, 0, quantity)
    return builder.routine("Give the attitude quaternion.")


def dcm(held: Block, writing: Writing, convention: str) -> Routine:
    """Write `dcm`: the direction cosine matrix."""
    out = Block("c_nb", Shape.MATRIX, Role.OUTPUT, unit="direction cosine matrix, row major: v_n = C_nb v_b")
    builder = Builder("dcm", (held, out), writing)
    quantity = read_once(builder, held)
    if isinstance(quantity, Vector):
        quantity = outputs.quaternion_of_angles(quantity, convention)
    if isinstance(quantity, Quaternion):
        quantity = (attitude.dcm_squares if writing.as_written else attitude.dcm)(quantity)
    write(builder, out, 0, quantity)
    return builder.routine("Give the direction cosine matrix.")


def euler(held: Block, writing: Writing, convention: str) -> Routine:
    """Write `euler`: roll, pitch and yaw in a convention, "zyx" or "zxy"."""
    out = Block("rpy", Shape.VECTOR, Role.OUTPUT, unit="roll, pitch, yaw, rad")
    if held.name == out.name:
        out = Block("angles", Shape.VECTOR, Role.OUTPUT, unit=out.unit)
    builder = Builder("euler", (held, out), writing)
    quantity = read_once(builder, held)
    if isinstance(quantity, Matrix):
        quantity = outputs.quaternion_of(quantity)
    if isinstance(quantity, Quaternion):
        quantity = outputs.euler_angles(quantity, convention)
    write(builder, out, 0, quantity)
    return builder.routine("Give roll, pitch and yaw.")


def error_estimate(error: Block, writing: Writing) -> Routine:
    """Write `error_estimate`: the method's own estimate of its last step's error."""
    out = Block("e", Shape.QUATERNION, Role.OUTPUT, unit="estimated error of the last step, quaternion components")
    builder = Builder("error_estimate", (error, out), writing)
    write(builder, out, 0, read(builder, error, 0))
    return builder.routine("Give the estimated error of the last update.")


def ready(count: Block, limit: int) -> Routine:
    """Write `ready`: whether the attitude is current, as it is after the first `limit` updates."""
    body = (Ready(Place(count.name), limit),)
    step = Step(f"the attitude is current from update {limit} on")
    return Routine("ready", (count,), body, (step,), summary="Tell whether the attitude is current.")


def read(builder: Builder, block: Block, entry: int) -> Quantity:
    """Read one entry of a block."""
    size = block.shape.value
    values = [builder.read(block, size * entry + part) for part in range(size)]
    quantity: Quantity = of(builder, block.shape, values, block.norm)
    return quantity


def read_once(builder: Builder, block: Block) -> Quantity:
    """Read a block of one entry under a heading of its own."""
    quantity = read(builder, block, 0)
    builder.label(Step(f"{block.name}, read once"))
    return quantity


def write(builder: Builder, block: Block, entry: int, quantity: Quantity) -> None:
    """Store a quantity in one entry of a block."""
    for part, value in enumerate(quantity.values):
        builder.write(block, block.shape.value * entry + part, value)
