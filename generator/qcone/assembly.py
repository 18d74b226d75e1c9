"""Assembly: an algorithm and a design become a program of the real language: every routine firmware calls.

The state holds the attitude `q`; `omega_last` where the input is rates; `previous` and `count` where the
algorithm looks back; last the harmonics of a rotating unit. The routines are `init`, `set_quaternion`, `start`
(rates), `update` (with `start_up` and `steady` behind it where there is a history), `renormalise` (when separate),
`quaternion` and `dcm`; last those of a rotating unit.
"""

from __future__ import annotations

from fractions import Fraction

from qcone import sensor
from qcone import stage_routines as stage
from qcone import state_routines as around
from qcone.algorithms import increments
from qcone.declaration import Declaration, declaration, round_up
from qcone.design import Design
from qcone.errors import UsageError
from qcone.formats.fixed import WIDTHS, Signal
from qcone.ir import trace
from qcone.ir.blocks import Vector, of
from qcone.ir.builder import Builder
from qcone.ir.operations import RealOp
from qcone.ir.specification import Algorithm, Author, Phase
from qcone.ir.statement import Advance, Block, Choose, Place, Program, Role, Routine, Shape, Step
from qcone.ir.writing import Functions, Series, SmallAngle, Writing
from qcone.passes.ranges import rotation_vector_bound

Axes = tuple[tuple[int, int], ...]
SAME_AXES: Axes = ((0, 1), (1, 1), (2, 1))


def rotation_bound(algorithm: Algorithm, design: Design) -> Fraction | None:
    """Return a bound of |phi| in one update, rad, rounded up; None where no exponential is taken.

    Both written forms give the same phi, so the smaller of their bounds holds for both.
    Raises UsageError when the argument of exp cannot be bounded.
    """
    bounds: list[Fraction] = []
    accumulate = "standard" if design.number.accumulate == "standard" else "delta"
    for form in ("factored", "as-written"):
        if form == "as-written" and not bounds:
            break
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
    state = _state(algorithm, design)
    held, blocks = state[0], {block.name: block for block in state}
    routines = [around.initial(state, writing), around.setter(state, writing)]
    if "omega_last" in blocks:
        limit = declaration(design, algorithm).limit if design.number.clamp_inputs else None
        routines.append(around.start(blocks["omega_last"], writing, limit))
    routines += _update_routines(algorithm, design, writing)
    if design.renormalise == "separate" and not writing.as_written and held.name != "rpy":
        routines.append(around.renormalise(held, writing))
    routines.append(around.quaternion(held, writing, design.euler))
    if "dcm" in design.outputs:
        routines.append(around.dcm(held, writing, design.euler))
    if "euler" in design.outputs:
        routines.append(around.euler(held, writing, design.euler))
    if "error" in blocks:
        routines.append(around.error_estimate(blocks["error"], writing))
    if algorithm.phases:
        routines.append(around.ready(blocks["count"], algorithm.held + 1))
    if design.rins:
        routines += stage.routines(state, design.outputs, writing, design.euler)
    return Program(design.name, state, tuple(routines))


def writing_of(
    design: Design, series: Series | None, functions: Functions | None = None, small: SmallAngle | None = None
) -> Writing:
    """Return how the design wants the shorthand written out."""
    rolled = design.loop == "rolled"
    fixed = design.number.format in WIDTHS
    carry = fixed and design.number.accumulate == "compensated"
    if design.form == "as-written":
        return Writing("as-written", None, "standard", False, rolled, functions, small)
    accumulate = "standard" if design.number.accumulate == "standard" else "delta"
    return Writing(
        "factored", series, accumulate, design.renormalise == "every", rolled, functions, small, fixed, carry
    )


def _state(algorithm: Algorithm, design: Design) -> tuple[Block, ...]:
    """Return the attitude, then what is kept beside it."""
    blocks = [around.ATTITUDES[algorithm.state]]
    if design.input == "rate":
        unit = "newest rate sample so far, rad/s, sensor axes"
        blocks.append(Block("omega_last", Shape.VECTOR, Role.STATE, unit=unit))
    if algorithm.previous:
        unit = "earlier angle increments, newest first, rad, sensor axes"
        blocks.append(Block("previous", Shape.VECTOR, Role.STATE, algorithm.previous, unit))
    blocks += algorithm.memory
    if _phases(algorithm):
        unit = "updates since the last restart, as far as they matter"
        blocks.append(Block("count", Shape.SCALAR, Role.STATE, unit=unit, integer=True))
    if known := declaration(design, algorithm).correction:
        blocks += stage.state(known)
    return tuple(blocks)


def _phases(algorithm: Algorithm) -> tuple[Phase, ...]:
    """Return what serves the first updates after a restart; a history form's are its start-up."""
    if not algorithm.previous:
        return algorithm.phases
    startup = algorithm.startup or algorithm
    return (Phase("start_up", algorithm.previous, startup.write, startup.written),)


def _update_routines(algorithm: Algorithm, design: Design, writing: Writing) -> list[Routine]:
    phases = _phases(algorithm)
    if not phases:
        return [_update(algorithm, algorithm.author(writing.form), design, writing, "update")]
    routines = [_update(algorithm, each.author(writing.form), design, writing, each.name) for each in phases]
    steady = _update(algorithm, algorithm.author(writing.form), design, writing, "steady")
    counted = [each.with_body((*each.body, Advance(Place("count"), len(each.steps) - 1))) for each in routines]
    blocks = tuple(block for block in steady.blocks if block.role not in (Role.LOCAL, Role.TABLE))
    choice = Choose(Place("count"), tuple((each.limit, each.name) for each in phases), "steady")
    step = Step(f"the history is full after {phases[-1].limit} updates")
    update = Routine("update", blocks, (choice,), (step,), summary="Advance the attitude by one update.")
    return [*counted, steady, update]


def _update(algorithm: Algorithm, author: Author, design: Design, writing: Writing, name: str) -> Routine:
    """Write one update: read, permute the axes, make increments of rates, run the author's function, store."""
    known = declaration(design, algorithm)
    state = _state(algorithm, design)
    held, rates = state[0], design.input == "rate"
    given = _given(design, algorithm, known)
    norm = given.norm or known.increment
    builder = Builder(name, (*state, given), writing, trace.heading(author))
    arguments: dict[str, object] = {held.name: around.read(builder, held, 0), "interval": known.interval}
    samples = [_entry(builder, given, k, norm) for k in range(algorithm.subsamples)]
    builder.label(Step(f"attitude and input{_said(design.axes)}"))
    if design.input == "counts":
        samples = sensor.increments_of_counts(samples, design, known.interval, known.increment)
    elif design.number.clamp_inputs:
        samples = [sensor.clamped(builder, each, known.limit, norm) for each in samples]
        builder.label(Step("each component limited to the declared range"))
    if rates:
        last = next(block for block in state if block.name == "omega_last")
        samples.insert(0, _entry(builder, last, 0, norm))
        builder.label(Step("the sample at the start of the interval"))
    made = tuple(samples)
    if rates and algorithm.takes == "dtheta":
        steps = increments.increments(samples, known.interval, design.increments)
        made = tuple(of(builder, Shape.VECTOR, each.values, known.increment) for each in steps)
    arguments[algorithm.takes] = tuple(_turned(builder, vector, design.axes) for vector in made)
    before: tuple[Vector, ...] = ()
    if algorithm.previous:
        block = next(block for block in state if block.name == "previous")
        before = tuple(_entry(builder, block, k, known.increment) for k in range(block.count))
        builder.label(Step(block.unit))
        arguments["previous"] = tuple(_turned(builder, vector, design.axes) for vector in before)
    for block in algorithm.memory:
        arguments[block.name] = tuple(around.read(builder, block, k) for k in range(block.count))
        builder.label(Step(block.unit))
    result, kept = trace.attitude(algorithm.name, author, builder, arguments)
    around.write(builder, held, 0, result)
    if rates:
        around.write(builder, last, 0, samples[-1])
    if algorithm.previous:
        for k, vector in enumerate((*reversed(made), *before)[: algorithm.previous]):
            around.write(builder, next(block for block in state if block.name == "previous"), k, vector)
    for block in algorithm.memory:
        for k, quantity in enumerate(kept.get(block.name, ())):
            around.write(builder, block, k, quantity)
    builder.label(Step("store"))
    return builder.routine("Advance the attitude by one update.")


def _given(design: Design, algorithm: Algorithm, known: Declaration) -> Block:
    """Return the block an update is handed: increments, rates or whole counts."""
    if design.input == "counts":
        unit = "whole counts of the gyro, sensor axes"
        return Block(
            "counts", Shape.VECTOR, Role.INPUT, algorithm.subsamples, unit, format=Signal(sensor.COUNT_BITS, 0)
        )
    name, unit, norm = ("omega", "rad/s", known.rate) if design.input == "rate" else ("dtheta", "rad", known.increment)
    return Block(name, Shape.VECTOR, Role.INPUT, algorithm.subsamples, unit, norm)


def _entry(builder: Builder, block: Block, entry: int, norm: Fraction) -> Vector:
    """Read a vector, along the axes it is kept in, under a bound of its norm."""
    vector: Vector = of(builder, Shape.VECTOR, around.read(builder, block, entry).values, norm)
    return vector


def _turned(builder: Builder, vector: Vector, axes: Axes) -> Vector:
    """Return a vector given along the sensor's axes as one along the body's: signs only, no arithmetic is left."""
    if axes == SAME_AXES:
        return vector
    values = [vector.values[index] for index, _ in axes]
    signed = [
        value if sign > 0 else builder.emit(RealOp.NEGATE, value) for value, (_, sign) in zip(values, axes, strict=True)
    ]
    return Vector(builder, tuple(signed), builder.group("scale", signed, (vector.group,), Fraction(1)))


def _said(axes: Axes) -> str:
    """Return how the body's axes lie in the sensor's, as a remark; nothing where they are the same."""
    if axes == SAME_AXES:
        return ""
    return ", along the sensor's axes: body x, y, z = " + ", ".join(
        f"{'-' if s < 0 else ''}{'xyz'[i]}" for i, s in axes
    )
