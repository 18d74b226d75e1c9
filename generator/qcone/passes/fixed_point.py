"""Bring a whole program to fixed point: the formats of its blocks, the range the attitude never leaves, each routine.

The attitude's length has to stay within a range for ever, not for one update: a range is sought that every routine
maps into itself, roundings included. What else the state keeps is bounded by what is written to it, to a fixpoint.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.check import check
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Program, Role, Routine, Write
from qcone.passes.block_ranges import GIVEN, RESIDUAL, WHOLE_BITS, BlockRanges, change, length
from qcone.passes.choices import Formats, PinError
from qcone.passes.declared import Declaration, scaled, with_last_bits
from qcone.passes.errors import errors
from qcone.passes.fuse import fuse
from qcone.passes.guard import guarded
from qcone.passes.high_word import WORD, HighWord, high_word
from qcone.passes.integers import to_integers
from qcone.passes.intervals import root_above
from qcone.passes.limb_ranges import known_norms
from qcone.passes.lower_fixed import Residual, lower_fixed, residual_block, with_residual
from qcone.passes.magnitudes import Declared, Magnitudes
from qcone.passes.qassign import Assigner
from qcone.passes.sweep import sweep
from qcone.passes.widen import widen

CARRYING = ("update", "steady")
UPDATING = ("update", "start_up", "hold", "steady")
HALVINGS = 8
"""How often a declared range that cannot be proved is halved, at most, to tell what could be."""
SETTING = ("init", "set_quaternion", "set_dcm", "set_euler")


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


def to_fixed(
    program: Program, number: Fixed, declaration: Declaration, compensated: bool, products: str = "wide"
) -> FixedProgram:
    """Return the program in fixed point. Raises UsageError for what does not fit, naming the value and the bits."""
    return _FixedPoint(program, number, declaration, compensated, products).run()


class _FixedPoint:
    def __init__(
        self, program: Program, number: Fixed, declaration: Declaration, compensated: bool, products: str = "wide"
    ) -> None:
        self.program, self.number, self.products = program, number, products
        self.declaration = with_last_bits(declaration, number)
        self.compensated = compensated
        self.held = program.state[0]
        self.fused = tuple(map(self._fused, program.routines))
        self.ranges = BlockRanges(program, self.fused, number, self.declaration, compensated)
        self.escaped: tuple[Fraction, tuple[Fraction, Fraction]] | None = None
        self.cost: dict[str, HighWord] = {}

    def run(self) -> FixedProgram:
        self._check_pins()
        failed: UsageError | None = None
        for spread, declared in self._possible():
            signals = self.ranges.signals()
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
        what = change(self.ranges.signals()[self.held.name], *self.escaped) if self.escaped else "change it too much"
        raise UsageError(
            f"the length of '{self.held.name}' is not proved to stay near 1: one update may {what}"
            + self._what_would_do()
        )

    def _check_pins(self) -> None:
        """Raise PinError for a pin of a value that no update has."""
        updates = [routine for routine in self.fused if routine.name in UPDATING]
        known = {
            routine.names.get(each.result, "")
            for routine in updates
            for each in routine.body
            if isinstance(each, Operation)
        }
        for name, bits in self.declaration.pins:
            if name not in known:
                raise PinError(f"no value of an update is called '{name}', pinned to {bits} bits")

    def _what_would_do(self) -> str:
        """Say which part of the declared range could be proved; nothing where none is found."""
        if not self._fits(HALVINGS):
            return ""
        halvings = bisect_left(range(1, HALVINGS), True, key=self._fits) + 1
        return f"; 1/{2**halvings} of the declared rate would do"

    def _fits(self, halvings: int) -> bool:
        """Tell whether some range of the length is kept, if the declared range is halved so many times."""
        smaller = scaled(self.declaration, Fraction(1, 2**halvings))
        return _FixedPoint(self.program, self.number, smaller, self.compensated).may_fit()

    def may_fit(self) -> bool:
        """Tell whether some range of the attitude's length is kept, if nothing is rounded."""
        return any(True for _ in self._possible())

    def _possible(self) -> Iterator[tuple[Fraction, Mapping[str, Declared]]]:
        """Yield each range of the length that would be kept if nothing were rounded, and what it means for blocks."""
        for spare, spread, nearest in self.ranges.spreads():
            self.ranges.spare, self.ranges.nearest = spare, nearest
            self.ranges.settle(spread)
            declared = self.ranges.declared(spread)
            if all(self._may_stay(routine, declared, spread) for routine in self.fused):
                yield spread, declared

    def _fused(self, routine: Routine) -> Routine:
        if self.compensated and self.held in routine.blocks:
            routine = sweep(widen(routine, self.held.name))
        return check(fuse(routine), RealOp)

    # -- routines -------------------------------------------------------------------------------------

    def _assigned(
        self, routine: Routine, signals: Mapping[str, Signal], declared: Mapping[str, Declared]
    ) -> tuple[Assigner, Formats]:
        samples, turn = self.declaration.samples, self.declaration.turn
        assigner = Assigner(routine, self.number, signals, declared, samples, turn, pins=self._pins(routine))
        return assigner, assigner.run()

    def _pins(self, routine: Routine) -> dict[int, int]:
        """Return the pinned fraction bits of a routine's values."""
        pins = dict(self.declaration.pins) if routine.name in UPDATING else {}
        return {value: pins[name] for value, name in routine.names.items() if name in pins}

    def _in_whole_words(self, assigner: Assigner, found: Formats, spread: Fraction) -> tuple[Assigner, Formats]:
        """Return an update whose sums drop whole words where they may; any other routine as it is."""
        if assigner.routine.name not in UPDATING or self.number.width != WORD:
            return assigner, found
        better, cost = high_word(assigner, found, self.compensated)
        if not self._stays(assigner, better, spread):
            return assigner, found
        self.cost[assigner.routine.name] = cost
        return assigner, better

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
        safe = guarded(replace(routine, groups=()), given, limits)
        again = Assigner(safe, self.number, signals, bare, None, None, limits, self._pins(safe))
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
            bound = self.ranges.bounds.get(place.block)
            if bound is not None and place.block not in WHOLE_BITS and magnitudes.of(value) > bound:
                return False
        for name, values in self.ranges.entries(
            {place: value for place, value in written.items() if place.block in self.ranges.norms}
        ):
            if length(magnitudes, found.routine, list(values))[1] > self.ranges.norms[name]:
                return False
        held = [value for place, value in assigner.written.items() if place.block == self.held.name]
        return self._keeps_length(magnitudes, found.routine, held, spread)

    def _may_stay(self, routine: Routine, declared: Mapping[str, Declared], spread: Fraction) -> bool:
        """Tell whether a routine would keep the attitude's length in the range if nothing were rounded."""
        magnitudes = self.ranges.magnitudes(routine, declared)
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
            low, high = length(magnitudes, routine, written[entry : entry + size])
            most = (1 + spread) ** 2 if (size, entry) == (3, 6) else 1 + spread
            if high > most or (size == 4 and self.ranges.nearest and low < 1 - spread):
                self.escaped = spread, (low, high)
                return False
        return True

    @staticmethod
    def _is_kept(routine: Routine, written: list[int]) -> bool:
        reads = {each.result for each in routine.body if isinstance(each, Operation) and each.place is not None}
        return all(value in reads for value in written)

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
            routines = [with_residual(each, block, each.name in SETTING) for each in routines]
        macs = replace(self.program, state=state, routines=tuple(routines))
        integers = replace(macs, routines=tuple(map(self._integers, routines, done)))
        return FixedProgram(macs, integers, proved)

    def _integers(self, routine: Routine, assigned: tuple[Assigner, Formats]) -> Routine:
        return to_integers(routine, self.number.overflow == "prove", self.products, known_norms(assigned[1]))
