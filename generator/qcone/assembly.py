"""Assembly: an algorithm and a design become a program of the real language: every routine firmware calls.

The state holds the attitude `q`; `omega_last` where the input is rates; `previous` and `count` where the
algorithm looks back. The routines are `init`, `set_quaternion`, `start` (rates), `update` (with `start_up`
and `steady` behind it where there is a history), `renormalise` (when separate), `quaternion` and `dcm`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from qcone.algorithms import attitude, increments
from qcone.design import Design
from qcone.errors import UsageError
from qcone.ir import trace
from qcone.ir.blocks import Quantity, Quaternion, Vector, of
from qcone.ir.builder import Builder
from qcone.ir.operations import RealOp
from qcone.ir.specification import Algorithm
from qcone.ir.statement import Advance, Block, Choose, Place, Program, Role, Routine, Shape, Step
from qcone.ir.writing import Series, Writing
from qcone.passes.ranges import rotation_vector_bound

PI_ABOVE = Fraction(314159265358980, 10**14)
"""A rational just above pi, for declared rates in deg/s."""


@dataclass(frozen=True)
class Declaration:
    """What the design declares of the sensor, in the units of the routines.

    `interval` of one update in s; `rate` the largest body rate in rad/s; `increment` the largest angle
    increment of one sub-sample in rad: bounds of Euclidean norms, rounded up.
    """

    interval: Fraction
    rate: Fraction
    increment: Fraction


def declaration(design: Design, algorithm: Algorithm) -> Declaration:
    """Return the declared ranges: |omega| <= max_rate and |theta| <= max_rate / (N update_hz)."""
    interval = 1 / design.imu.update_hz
    rate = round_up(design.imu.max_rate_dps * PI_ABOVE / 180, 8)
    if design.input == "rate":
        increment = increments.gain(algorithm.subsamples, design.increments) * interval * rate
    else:
        increment = rate * interval / algorithm.subsamples
    return Declaration(interval, rate, round_up(increment, 8))


def round_up(value: Fraction, digits: int) -> Fraction:
    """Return `value` rounded up to that many significant decimal digits."""
    scale = Fraction(1)
    while value * scale < 10 ** (digits - 1):
        scale *= 10
    while value * scale >= 10**digits:
        scale /= 10
    return Fraction(-((-value * scale).__floor__())) / scale


def rotation_bound(algorithm: Algorithm, design: Design) -> Fraction | None:
    """Return a bound of |phi| in one update, rad, rounded up; None where no exponential is taken.

    Both written forms give the same phi, so the smaller of their bounds holds for both.
    Raises UsageError when the argument of exp cannot be bounded.
    """
    bounds = []
    accumulate = "standard" if design.number.accumulate == "standard" else "delta"
    for form in ("as-written", "factored"):
        routines = _update_routines(algorithm, design, Writing(form=form, accumulate=accumulate))
        try:
            found = [rotation_vector_bound(routine) for routine in routines]
        except ValueError as error:
            place = algorithm.name
            raise UsageError(f"algorithm '{place}': {error}; give exp a sum of products of the increments") from error
        bounds += [max(known for known in found if known is not None)] if any(found) else []
    return round_up(min(bounds), 4) if bounds else None


def assemble(algorithm: Algorithm, design: Design, writing: Writing) -> Program:
    """Return the program of a design in the real language, every routine as its author wrote it."""
    q, others = _state(algorithm, design)
    state = (q, *others)
    routines = [_init(state, writing), _set_quaternion(state, writing)]
    if design.input == "rate":
        routines.append(_start(others[0], writing))
    routines += _update_routines(algorithm, design, writing)
    if design.renormalise == "separate" and not writing.as_written:
        routines.append(_renormalise(q, writing))
    routines.append(_quaternion(q, writing))
    if "dcm" in design.outputs:
        routines.append(_dcm(q, writing))
    return Program(design.name, state, tuple(routines))


def writing_of(design: Design, series: Series | None) -> Writing:
    """Return how the design wants the shorthand written out."""
    rolled = design.loop == "rolled"
    if design.form == "as-written":
        return Writing("as-written", None, "standard", False, rolled)
    accumulate = "standard" if design.number.accumulate == "standard" else "delta"
    return Writing("factored", series, accumulate, design.renormalise == "every", rolled)


def _state(algorithm: Algorithm, design: Design) -> tuple[Block, tuple[Block, ...]]:
    q = Block("q", Shape.QUATERNION, Role.STATE, unit="attitude quaternion q_nb: w, x, y, z; body to navigation")
    others = []
    if design.input == "rate":
        others.append(
            Block("omega_last", Shape.VECTOR, Role.STATE, unit="newest rate sample so far, rad/s, sensor axes")
        )
    if algorithm.previous:
        unit = "earlier angle increments, newest first, rad, body axes"
        others.append(Block("previous", Shape.VECTOR, Role.STATE, algorithm.previous, unit))
        others.append(Block("count", Shape.SCALAR, Role.STATE, unit="updates since the last restart", integer=True))
    return q, tuple(others)


def _update_routines(algorithm: Algorithm, design: Design, writing: Writing) -> list[Routine]:
    if not algorithm.previous:
        return [_update(algorithm, algorithm, design, writing, "update")]
    startup = algorithm.startup or algorithm
    first = _update(startup, algorithm, design, writing, "start_up")
    steady = _update(algorithm, algorithm, design, writing, "steady")
    blocks = tuple(block for block in steady.blocks if block.role is not Role.LOCAL)
    place = Place("count")
    step = Step(f"the history is full after {algorithm.previous} updates")
    choice = Choose(place, ((algorithm.previous, "start_up"),), "steady")
    update = Routine("update", blocks, (choice,), (step,), summary="Advance the attitude by one update.")
    return [first, steady, update]


def _update(algorithm: Algorithm, whole: Algorithm, design: Design, writing: Writing, name: str) -> Routine:
    """Write one update: read, permute the axes, make increments of rates, run the author's function, store."""
    known = declaration(design, whole)
    q, others = _state(whole, design)
    rates = design.input == "rate"
    unit, norm = ("rad/s", known.rate) if rates else ("rad", known.increment)
    given = Block("omega" if rates else "dtheta", Shape.VECTOR, Role.INPUT, whole.subsamples, unit, norm)
    builder = Builder(name, (q, *others, given), writing, trace.heading(algorithm.author(writing.form)))
    attitude_now = _read(builder, q, 0)
    samples = [_in_body_axes(builder, given, k, design.axes) for k in range(whole.subsamples)]
    builder.label(Step("attitude and input"))
    if rates:
        first = _in_body_axes(builder, others[0], 0, design.axes, given.norm)
        builder.label(Step("the sample at the start of the interval"))
        dtheta = increments.increments((first, *samples), known.interval, design.increments)
        dtheta = tuple(of(builder, Shape.VECTOR, each.values, known.increment) for each in dtheta)
    else:
        dtheta = tuple(samples)
    arguments: dict[str, object] = {"q": attitude_now, "dtheta": dtheta}
    previous = next((block for block in others if block.name == "previous"), None)
    if previous is not None:
        before = tuple(
            of(builder, Shape.VECTOR, _read(builder, previous, k).values, known.increment)
            for k in range(previous.count)
        )
        builder.label(Step("increments of the updates before, newest first"))
        arguments["previous"] = before
    result = trace.attitude(algorithm, writing.form, builder, arguments)
    _write(builder, q, 0, result)
    if rates:
        _write_raw(builder, others[0], given, whole.subsamples - 1)
    if previous is not None:
        kept = [*reversed(dtheta), *before][: previous.count]
        for k, vector in enumerate(kept):
            _write(builder, previous, k, vector)
    builder.label(Step("store"))
    routine = builder.routine("Advance the attitude by one update.")
    if previous is not None and name == "start_up":
        routine = routine.with_body((*routine.body, Advance(Place("count"), len(routine.steps) - 1)))
    return routine


def _read(builder: Builder, block: Block, entry: int) -> Quantity:
    size = block.shape.value
    values = [builder.read(block, size * entry + part) for part in range(size)]
    quantity: Quantity = of(builder, block.shape, values, block.norm)
    return quantity


def _in_body_axes(
    builder: Builder,
    block: Block,
    entry: int,
    axes: tuple[tuple[int, int], ...],
    norm: Fraction | None = None,
) -> Vector:
    """Read a vector given along the sensor's axes and return it along the body's: signs only, no arithmetic."""
    vector = _read(builder, block, entry)
    if axes == ((0, 1), (1, 1), (2, 1)):
        values = vector.values
    else:
        number = str(entry + 1) if block.count > 1 else ""
        for value in vector.values:
            builder.names.pop(value, None)
        values = tuple(_turned(builder, vector.values[index], sign) for index, sign in axes)
        builder.name_values(f"{block.name}{number}", Shape.VECTOR, values)
    turned: Vector = of(builder, Shape.VECTOR, values, norm or block.norm)
    return turned


def _turned(builder: Builder, value: int, sign: int) -> int:
    return value if sign > 0 else builder.emit(RealOp.NEGATE, value)


def _write(builder: Builder, block: Block, entry: int, quantity: Quantity) -> None:
    for part, value in enumerate(quantity.values):
        builder.write(block, block.shape.value * entry + part, value)


def _write_raw(builder: Builder, block: Block, source: Block, entry: int) -> None:
    """Keep the newest sample as the sensor gave it."""
    values = [builder.read(source, 3 * entry + part) for part in range(3)]
    for part, value in enumerate(values):
        builder.write(block, part, value)


def _init(state: tuple[Block, ...], writing: Writing) -> Routine:
    builder = Builder("init", state, writing)
    for block in state:
        for part in range(block.size):
            one = block.name == "q" and part == 0
            builder.write(block, part, builder.constant(Fraction(1 if one else 0)))
    return builder.routine("Set the identity attitude and clear the history.")


def _set_quaternion(state: tuple[Block, ...], writing: Writing) -> Routine:
    given = Block("q_nb", Shape.QUATERNION, Role.INPUT, unit="unit attitude quaternion: w, x, y, z")
    builder = Builder("set_quaternion", (*state, given), writing)
    result = attitude.normalised(_as_quaternion(builder, given))
    for block in state:
        if block.name == "q":
            _write(builder, block, 0, result)
        elif block.name != "omega_last":
            for part in range(block.size):
                builder.write(block, part, builder.constant(Fraction(0)))
    builder.label(Step("store"))
    return builder.routine("Set the attitude, normalised once, and clear the history.")


def _as_quaternion(builder: Builder, block: Block) -> Quaternion:
    quantity = _read(builder, block, 0)
    assert isinstance(quantity, Quaternion)
    builder.label(Step(f"{block.name}, read once"))
    return quantity


def _start(omega_last: Block, writing: Writing) -> Routine:
    given = Block("omega", Shape.VECTOR, Role.INPUT, unit="rad/s")
    builder = Builder("start", (omega_last, given), writing)
    _write_raw(builder, omega_last, given, 0)
    return builder.routine("Take the rate sample at the start of the first update.")


def _renormalise(q: Block, writing: Writing) -> Routine:
    builder = Builder("renormalise", (q,), writing)
    _write(builder, q, 0, attitude.normalised(_as_quaternion(builder, q)))
    return builder.routine("Bring the attitude quaternion back to unit length, by one Newton step.")


def _quaternion(q: Block, writing: Writing) -> Routine:
    out = Block("q_nb", Shape.QUATERNION, Role.OUTPUT, unit="attitude quaternion: w, x, y, z; body to navigation")
    builder = Builder("quaternion", (q, out), writing)
    _write(builder, out, 0, _read(builder, q, 0))
    return builder.routine("Give the attitude quaternion.")


def _dcm(q: Block, writing: Writing) -> Routine:
    out = Block("c_nb", Shape.MATRIX, Role.OUTPUT, unit="direction cosine matrix, row major: v_n = C_nb v_b")
    builder = Builder("dcm", (q, out), writing)
    form = attitude.dcm_squares if writing.as_written else attitude.dcm
    _write(builder, out, 0, form(_as_quaternion(builder, q)))
    return builder.routine("Give the direction cosine matrix.")
