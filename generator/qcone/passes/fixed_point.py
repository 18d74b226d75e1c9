"""Bring a whole program to fixed point: the formats of its blocks, the range the attitude never leaves, each routine.

The attitude's length has to stay within a range for ever, not for one update: a range is sought that every routine
maps into itself, roundings included. What else the state keeps is bounded by what is written to it, to a fixpoint.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Sum, Term
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Choose, Operation, Place, Program, Role, Routine, Statement, Write, unused
from qcone.passes.choices import Formats
from qcone.passes.errors import errors
from qcone.passes.expand import expand
from qcone.passes.fuse import fuse
from qcone.passes.high_word import WORD, HighWord, high_word
from qcone.passes.lower_fixed import Residual, lower_fixed, residual_block
from qcone.passes.magnitudes import Declared, Magnitudes, Samples, root_above
from qcone.passes.qassign import Assigner
from qcone.passes.rebuild import rebuild
from qcone.passes.sweep import sweep
from qcone.passes.widen import widen

SPREADS = tuple(
    Fraction(each)
    for each in (
        "1/65536",
        "1/4096",
        "1/1024",
        "1/256",
        "1/64",
        "1/32",
        "1/16",
        "1/10",
        "3/20",
        "1/5",
        "11/50",
        "3/10",
        "2/5",
        "1/2",
    )
)
"""How far from 1 the attitude's length may be: the least of these that the updates keep."""
RESIDUAL = "residual"
LEFT_ALONE = Fraction(1, 64)
"""How far from 1 it may drift where updates do not bring it back."""
GIVEN = Fraction(1, 1024)
"""How far from 1 the length of an attitude may be that is handed in."""
PI_ABOVE = Fraction(355, 113)
CARRYING = ("update", "steady")
UPDATING = ("update", "start_up", "hold", "steady")
SETTING = ("init", "set_quaternion", "set_dcm", "set_euler")
WHOLE_BITS = {"q": 1, "c": 1, "rpy": 2, "q_nb": 1, "c_nb": 1, "angles": 2}
"""Bits before the binary point beside the sign, of attitudes kept, handed in and given out."""


@dataclass(frozen=True)
class Declaration:
    """What is declared of inputs: norms of the vectors handed in, and their differences in time.

    `turn` is what follows for the rotation vector of one update, rad.
    """

    inputs: Mapping[str, Fraction] = field(hash=False)
    samples: Samples | None = None
    turn: Fraction | None = None
    counts: Mapping[str, Fraction] = field(default_factory=dict, hash=False)
    """The largest whole count of a block of counts."""
    unlimited: frozenset[str] = frozenset()
    """Blocks that may hold any word: the routine limits them itself."""
    bounded: Mapping[str, Fraction] = field(default_factory=dict, hash=False)
    """The largest size of the scalars of further blocks."""
    renormalised: bool = True
    """Whether every update brings the attitude's length back."""
    series: Fraction | None = None
    """How far one update's rotation, as a series, is from a unit quaternion; None where it is not known."""


@dataclass(frozen=True)
class Proved:
    """What is proved of a program in fixed point.

    `spread` bounds | |q| - 1 |; `rounding` how far one update is from exact arithmetic, in the components' norm, None
    where it is not bounded. Where updates do not bring the length back, `growth` bounds what one of them adds to it,
    and `updates` is how many keep it within `spread`. `words` is what the search for whole words did to an update.
    """

    spread: Fraction
    rounding: Fraction | None = None
    growth: Fraction | None = None
    updates: int | None = None
    words: HighWord | None = None


@dataclass(frozen=True)
class FixedProgram:
    """A program in fixed point: in `mac` operations, and in integer operations."""

    macs: Program
    integers: Program
    proved: Proved


def to_fixed(program: Program, number: Fixed, declaration: Declaration, compensated: bool) -> FixedProgram:
    """Return the program in fixed point. Raises UsageError for what does not fit, naming the value and the bits."""
    return _FixedPoint(program, number, declaration, compensated).run()


def _with_last_bits(declaration: Declaration, number: Fixed) -> Declaration:
    """Return the declaration of samples that were rounded to words: differences may be larger by a last bit."""
    if declaration.samples is None:
        return declaration
    lsb = 2 * number.ulp(declaration.samples.largest)
    return replace(declaration, samples=replace(declaration.samples, lsb=lsb))


def _guarded(routine: Routine, given: set[str], limits: dict[int, Fraction]) -> Routine:
    """Return the routine with every word that is handed in clamped; what to is added to `limits`."""
    renamed: dict[int, int] = {}
    fresh = unused(routine)

    def visit(operation: Operation) -> Iterable[Statement]:
        nonlocal fresh
        if isinstance(operation.detail, Sum):
            terms = tuple(
                replace(term, args=tuple(renamed.get(arg, arg) for arg in term.args)) for term in operation.detail.terms
            )
            operation = replace(operation, detail=replace(operation.detail, terms=terms))
        if operation.place is None or operation.place.block not in given:
            return (operation,)
        detail = Sum((Term(Fraction(1), (operation.result,)),))
        guard = Operation(fresh, RealOp.SUM, (operation.result,), step=operation.step, detail=detail)
        limits[fresh] = limits[operation.result]
        names[fresh] = f"{names.get(operation.result, 'given')}_clamped"
        renamed[operation.result] = fresh
        fresh += 1
        return (operation, guard)

    names = dict(routine.names)
    body = rebuild(routine.body, visit, renamed)
    return replace(routine, body=body, names=names)


def _scaled(declaration: Declaration, part: Fraction) -> Declaration:
    """Return the declaration of a smaller range."""
    samples, turn = declaration.samples, declaration.turn
    if samples is not None:
        first, second = (each and each * part for each in (samples.first, samples.second))
        samples = replace(samples, largest=samples.largest * part, first=first, second=second)
    inputs = {name: bound * part for name, bound in declaration.inputs.items()}
    return replace(declaration, inputs=inputs, samples=samples, turn=turn and turn * part)


class _FixedPoint:
    def __init__(self, program: Program, number: Fixed, declaration: Declaration, compensated: bool) -> None:
        self.program, self.number = program, number
        self.declaration = _with_last_bits(declaration, number)
        self.compensated = compensated
        self.held = program.state[0]
        self.fused = tuple(map(self._fused, program.routines))
        self.bounds: dict[str, Fraction] = {}
        self.norms: dict[str, Fraction] = {}
        self.nearest, self.spare = True, 0
        self.cost: dict[str, HighWord] = {}

    def run(self) -> FixedProgram:
        failed: UsageError | None = None
        for spare, spread, nearest in self._spreads():
            self.spare, self.nearest = spare, nearest
            self._settle(spread)
            signals, declared = self._signals(), self._declared(spread)
            if not all(self._may_stay(routine, declared, spread) for routine in self.fused):
                continue
            try:
                done = [self._assigned(routine, signals, declared) for routine in self.fused]
            except UsageError as error:
                failed = failed or error
                continue
            if all(self._stays(assigner, found, spread) for assigner, found in done):
                done = [self._in_whole_words(assigner, found, spread) for assigner, found in done]
                proved = self._proved(done, spread)
                if self.number.overflow == "saturate":
                    done = [self._saturated(assigner, found, signals, declared) for assigner, found in done]
                return self._lowered(done, signals, proved)
        if failed:
            raise failed
        raise UsageError(
            f"the length of '{self.held.name}' is not proved to stay near 1: one update may change it too much"
            + self._what_would_do()
        )

    def _what_would_do(self) -> str:
        """Say which part of the declared range could be proved; nothing where none is found."""
        for halvings in range(1, 9):
            part = Fraction(1, 2**halvings)
            smaller = _FixedPoint(self.program, self.number, _scaled(self.declaration, part), self.compensated)
            if smaller.may_fit():
                return f"; 1/{2**halvings} of the declared rate would do"
        return ""

    def may_fit(self) -> bool:
        """Tell whether some range of the attitude's length is kept, if nothing is rounded."""
        for spare, spread, nearest in self._spreads():
            self.spare, self.nearest = spare, nearest
            self._settle(spread)
            declared = self._declared(spread)
            if all(self._may_stay(routine, declared, spread) for routine in self.fused):
                return True
        return False

    def _fused(self, routine: Routine) -> Routine:
        if self.compensated and self.held in routine.blocks:
            routine = sweep(widen(routine, self.held.name))
        return fuse(routine)

    # -- blocks ---------------------------------------------------------------------------------------

    def _spreads(self) -> Iterator[tuple[int, Fraction, bool]]:
        """Yield what is to be tried: spare bits of a wide state, how far from 1 the length may be, a least length.

        An attitude of angles has no length to be kept, nor has one that every update brings back only from above.
        A partial sum on the way to a new attitude may be longer than the attitude itself: then spare bits help.
        """
        if self.held.name == "rpy":
            yield 0, GIVEN, False
            return
        if not self.declaration.renormalised:
            yield from ((spare, LEFT_ALONE, True) for spare in ((0, 1, 2) if self.compensated else (0,)))
            return
        for spare in (0, 1, 2) if self.compensated else (0,):
            for kept in (True, False):
                yield from ((spare, spread, kept) for spread in SPREADS)

    def _blocks(self) -> dict[str, Block]:
        blocks = {block.name: block for block in self.program.state if not block.integer}
        for routine in self.program.routines:
            blocks |= {block.name: block for block in routine.blocks if not block.integer}
        return {name: block for name, block in blocks.items() if block.role not in (Role.LOCAL, Role.TABLE)}

    def _signals(self) -> dict[str, Signal]:
        width, signals = self.number.width, {}
        for name, block in self._blocks().items():
            if block.format is not None:
                signals[name] = block.format
            elif name in WHOLE_BITS:
                signals[name] = Signal(width, width - 1 - WHOLE_BITS[name])
            elif name in self.declaration.bounded:
                signals[name] = self.number.signal(self.declaration.bounded[name])
            elif name in self.declaration.inputs:
                # One bit is left free, so that sums and differences of two samples are exact.
                fine = self.number.signal(self.declaration.inputs[name])
                signals[name] = Signal(width, fine.fraction - 1)
            else:
                signals[name] = self.number.signal(self.bounds.get(name, Fraction(0)))
        if self.compensated:
            whole = WHOLE_BITS[self.held.name] + self.spare
            signals[self.held.name] = Signal(2 * width, 2 * width - 1 - whole)
        return signals

    def _declared(self, spread: Fraction) -> dict[str, Declared]:
        declared: dict[str, Declared] = {}
        signals = self._signals()
        for name in self._blocks():
            if name == "q":
                low, high = 1 - spread, 1 + spread
                declared[name] = Declared((-high, high), (low if self.nearest else Fraction(0), high))
            elif name == "c":
                high = 1 + spread
                declared[name] = Declared((-high * high, high * high), (Fraction(0), high))
            elif name in ("q_nb", "c_nb"):
                low, high = 1 - GIVEN, 1 + GIVEN
                declared[name] = Declared((-high, high), (low, high))
            elif name in ("rpy", "angles"):
                declared[name] = Declared((-PI_ABOVE, PI_ABOVE))
            elif name in self.declaration.bounded:
                most = self.declaration.bounded[name]
                declared[name] = Declared((-most, most))
            elif name in self.declaration.counts:
                most = self.declaration.counts[name]
                declared[name] = Declared((-most, most))
            elif name in self.declaration.unlimited:
                most = (signals[name].most + 1) * signals[name].lsb
                declared[name] = Declared((-most, most))
            elif name in self.declaration.inputs:
                most = self.declaration.inputs[name] + signals[name].lsb
                declared[name] = Declared((-most, most), (Fraction(0), most))
            else:
                most = self.bounds.get(name, Fraction(0))
                declared[name] = Declared((-most, most), (Fraction(0), self.norms.get(name, Fraction(0))))
        return declared

    def _settle(self, spread: Fraction) -> None:
        """Bound what the state keeps beside the attitude by what is written to it, to a fixpoint."""
        stated = (WHOLE_BITS, self.declaration.inputs, self.declaration.counts, self.declaration.bounded)
        known = {name for each in stated for name in each} - {RESIDUAL}
        open_blocks = [name for name in self._blocks() if name not in known]
        for _ in range(12):
            declared, changed = self._declared(spread), False
            for routine in self.fused:
                magnitudes = self._magnitudes(routine, declared)
                if magnitudes is None:
                    continue
                written: dict[Place, int] = {
                    each.place: each.value
                    for each in routine.body
                    if isinstance(each, Write) and each.place.block in open_blocks
                }
                moved = {
                    each.result: each.place.block
                    for each in routine.body
                    if isinstance(each, Operation) and each.place is not None
                }
                written = {place: value for place, value in written.items() if moved.get(value) != place.block}
                for place, value in written.items():
                    changed |= self._grow(self.bounds, place.block, magnitudes.of(value))
                for name, values in self._entries(written):
                    changed |= self._grow(self.norms, name, self._length(magnitudes, routine, list(values))[1])
            if not changed:
                return

    @staticmethod
    def _grow(known: dict[str, Fraction], name: str, size: Fraction) -> bool:
        """Take a larger bound, with room for roundings; tell whether it was larger."""
        size *= Fraction(1025, 1024)
        if size <= known.get(name, Fraction(0)):
            return False
        known[name] = size * Fraction(33, 32)
        return True

    def _entries(self, written: Mapping[Place, int]) -> Iterator[tuple[str, tuple[int, ...]]]:
        """Yield the values written to each entry of each block."""
        blocks = self._blocks()
        for name in dict.fromkeys(place.block for place in written):
            size = blocks[name].shape.value
            components = {place.index.constant: value for place, value in written.items() if place.block == name}
            for entry in range(blocks[name].count):
                values = [components.get(size * entry + part) for part in range(size)]
                if None not in values:
                    yield name, tuple(value for value in values if value is not None)

    def _magnitudes(self, routine: Routine, declared: Mapping[str, Declared]) -> Magnitudes | None:
        try:
            return Magnitudes(routine, declared, self.declaration.samples, None, self.declaration.turn)
        except ZeroDivisionError:
            return None

    # -- routines -------------------------------------------------------------------------------------

    def _assigned(
        self, routine: Routine, signals: Mapping[str, Signal], declared: Mapping[str, Declared]
    ) -> tuple[Assigner, Formats]:
        assigner = Assigner(routine, self.number, signals, declared, self.declaration.samples, self.declaration.turn)
        return assigner, assigner.run()

    def _in_whole_words(self, assigner: Assigner, found: Formats, spread: Fraction) -> tuple[Assigner, Formats]:
        """Return an update whose sums drop whole words where they may; any other routine as it is."""
        if assigner.routine.name not in UPDATING or self.number.width != WORD:
            return assigner, found
        better, cost = high_word(assigner, found, self.compensated)
        self.cost[assigner.routine.name] = cost
        return assigner, better if self._stays(assigner, better, spread) else found

    def _saturated(
        self, assigner: Assigner, found: Formats, signals: Mapping[str, Signal], declared: Mapping[str, Declared]
    ) -> tuple[Assigner, Formats]:
        """Return a routine that clamps each value to what it cannot exceed in the declared range, if anything can.

        Then whatever words are handed in, operands are within those bounds, each by itself: so sums fit, and no
        fact of lengths is used.
        """
        assert found.magnitudes is not None
        routine = next(each for each in self.fused if each.name == assigner.routine.name)
        limits = {value: found.magnitudes.of(value) for value in found.magnitudes.values}
        given = {block.name for block in routine.having(Role.INPUT)}
        bare = {name: Declared(each.interval) for name, each in declared.items()}
        for name in given:
            most = (signals[name].most + 1) * signals[name].lsb
            bare[name] = Declared((-most, most))
        guarded = _guarded(replace(routine, groups=()), given, limits)
        again = Assigner(guarded, self.number, signals, bare, None, None, limits)
        return again, again.run()

    def _stays(self, assigner: Assigner, found: Formats, spread: Fraction) -> bool:
        """Tell whether a routine writes only attitudes whose length is in the range, and what else was declared."""
        magnitudes = found.magnitudes
        assert magnitudes is not None
        moved = {
            each.result: each.place.block
            for each in found.routine.body
            if isinstance(each, Operation) and each.place is not None
        }
        written = {place: value for place, value in assigner.written.items() if moved.get(value) != place.block}
        for place, value in written.items():
            bound = self.bounds.get(place.block)
            if bound is not None and place.block not in WHOLE_BITS and magnitudes.of(value) > bound:
                return False
        for name, values in self._entries(
            {place: value for place, value in written.items() if place.block in self.norms}
        ):
            if self._length(magnitudes, found.routine, list(values))[1] > self.norms[name]:
                return False
        held = [value for place, value in assigner.written.items() if place.block == self.held.name]
        return self._keeps_length(magnitudes, found.routine, held, spread)

    def _may_stay(self, routine: Routine, declared: Mapping[str, Declared], spread: Fraction) -> bool:
        """Tell whether a routine would keep the attitude's length in the range if nothing were rounded."""
        magnitudes = self._magnitudes(routine, declared)
        written = [
            each.value for each in routine.body if isinstance(each, Write) and each.place.block == self.held.name
        ]
        return magnitudes is None or self._keeps_length(magnitudes, routine, written, spread)

    def _keeps_length(self, magnitudes: Magnitudes, routine: Routine, written: list[int], spread: Fraction) -> bool:
        if self.held.name == "rpy" or not written or self._is_kept(routine, written):
            return True
        if not self.declaration.renormalised and routine.name in UPDATING:
            return True  # its length is left to drift, for as many updates as are proved
        size = 4 if self.held.name == "q" else 3
        for entry in range(0, len(written), size):
            low, high = self._length(magnitudes, routine, written[entry : entry + size])
            most = (1 + spread) ** 2 if (size, entry) == (3, 6) else 1 + spread
            if high > most or (size == 4 and self.nearest and low < 1 - spread):
                return False
        return True

    @staticmethod
    def _is_kept(routine: Routine, written: list[int]) -> bool:
        reads = {each.result for each in routine.body if isinstance(each, Operation) and each.place is not None}
        return all(value in reads for value in written)

    @staticmethod
    def _length(magnitudes: Magnitudes, routine: Routine, values: list[int]) -> tuple[Fraction, Fraction]:
        """Return the range of a written vector's length: of every group over it, and of its components."""
        intervals = [magnitudes.values[value] for value in values]
        low = 1 / root_above(1 / sum((max(a, -b, Fraction(0)) ** 2 for a, b in intervals), Fraction(1, 2**200)))
        high = root_above(sum((max(-a, b) ** 2 for a, b in intervals), Fraction(0)))
        for number, group in enumerate(routine.groups):
            if group.values == tuple(values):
                norm = magnitudes.norm(number)
                if norm is not None:
                    low, high = max(low, norm[0]), min(high, norm[1])
        return low, high

    def _proved(self, done: list[tuple[Assigner, Formats]], spread: Fraction) -> Proved:
        """Return what is proved of the updates. Raises UsageError where the length is left to drift without a bound."""
        words = self.cost.get("steady", self.cost.get("update"))
        rounding: Fraction | None = Fraction(0)
        for assigner, found in done:
            written = [value for place, value in assigner.written.items() if place.block == self.held.name]
            if assigner.routine.name not in UPDATING or not written or self._is_kept(assigner.routine, written):
                continue
            known = errors(assigner, found)
            if rounding is None or any(value not in known for value in written):
                rounding = None
                continue
            rounding = max(rounding, root_above(sum((known[value] ** 2 for value in written), Fraction(0))))
        if self.declaration.renormalised or self.held.name == "rpy":
            return Proved(spread, rounding, words=words)
        if rounding is None or self.declaration.series is None:
            raise UsageError(
                "what one update adds to the attitude's length is not bounded for this algorithm: set renormalise = "
                '"every"'
            )
        growth = (1 + spread) * self.declaration.series + rounding
        return Proved(spread, rounding, growth, int((spread - GIVEN) / growth), words)

    # -- the machine program --------------------------------------------------------------------------

    def _lowered(
        self, done: list[tuple[Assigner, Formats]], signals: Mapping[str, Signal], proved: Proved
    ) -> FixedProgram:
        carried: tuple[Residual, ...] = ()
        routines: list[Routine] = []
        for assigner, found in done:
            carry = RESIDUAL if found.routine.name in CARRYING else None
            routine, residuals = lower_fixed(assigner, found, carry, signals)
            carried = carried or residuals
            routines.append(routine)
        state = tuple(replace(b, format=signals[b.name]) if b.name in signals else b for b in self.program.state)
        if carried:
            block = residual_block(RESIDUAL, carried)
            state = (state[0], block, *state[1:])
            routines = [self._with_residual(routine, block) for routine in routines]
        macs = replace(self.program, state=state, routines=tuple(routines))
        integers = replace(macs, routines=tuple(expand(each, self.number.overflow == "prove") for each in routines))
        return FixedProgram(macs, integers, proved)

    def _with_residual(self, routine: Routine, block: Block) -> Routine:
        """Clear what is carried where the attitude is set, and hand it on where a call is handed on."""
        hands_on = any(isinstance(each, Choose) for each in routine.body)
        if routine.name not in SETTING and not hands_on:
            return routine
        blocks = (routine.blocks[0], block, *routine.blocks[1:])
        body: tuple[Statement, ...] = routine.body
        if not hands_on:
            value = unused(routine)
            step = len(routine.steps) - 1
            assert block.format is not None
            zero = Operation(
                value, MachineOp.LITERAL, constant=Fraction(0), step=step, format=block.format, exact=Fraction(0)
            )
            body = (*body, zero, *(Write(Place(block.name, Index(k)), value, step) for k in range(block.size)))
        return replace(routine, blocks=blocks, body=body)
