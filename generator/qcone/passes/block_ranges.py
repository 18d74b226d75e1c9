"""Ranges of the blocks of a program in fixed point: their formats, and what is declared or found of what they hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from qcone.formats.fixed import Fixed, Signal
from qcone.ir.statement import Block, Operation, Place, Program, Role, Routine, Write
from qcone.passes.declared import Declaration
from qcone.passes.intervals import root_above
from qcone.passes.magnitudes import Declared, Magnitudes

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
LEFT_ALONE = Fraction(1, 64)
"""How far from 1 it may drift where updates do not bring it back."""
GIVEN = Fraction(1, 1024)
"""How far from 1 the length of an attitude may be that is handed in."""
WHOLE_BITS = {"q": 1, "c": 1, "rpy": 2, "q_nb": 1, "c_nb": 1, "angles": 2}
"""Bits before the binary point beside the sign, of attitudes kept, handed in and given out."""
PI_ABOVE = Fraction(355, 113)
RESIDUAL = "residual"


def length(magnitudes: Magnitudes, routine: Routine, values: list[int]) -> tuple[Fraction, Fraction]:
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


def change(signal: Signal, spread: Fraction, reached: tuple[Fraction, Fraction]) -> str:
    """Say what an update may do to a length within `spread` of 1, and how many bits that is more than a word holds."""
    low, high = reached
    end = high if high > 1 + spread else low
    missing = 0
    while high * 2**signal.fraction >= 2 ** (signal.width - 1 + missing):
        missing += 1
    more = f", {missing} bit{'s' * (missing > 1)} more than {signal.name} holds" if missing else ""
    return f"take one within {spread} of 1 to {float(end):.3g}{more}"


class BlockRanges:
    """What is known of the blocks of one program: `bounds` and `norms` of what the state keeps beside the attitude.

    `spare` bits a wide attitude has to spare, and `nearest` tells whether its length has a least value: both are what
    is being tried.
    """

    def __init__(
        self,
        program: Program,
        fused: tuple[Routine, ...],
        number: Fixed,
        declaration: Declaration,
        compensated: bool,
    ) -> None:
        """Begin with no range found; `fused` are the program's routines of sums."""
        self.program, self.fused, self.number = program, fused, number
        self.declaration, self.compensated = declaration, compensated
        self.held = program.state[0]
        self.bounds: dict[str, Fraction] = {}
        self.norms: dict[str, Fraction] = {}
        self.nearest, self.spare = True, 0

    def spreads(self) -> Iterator[tuple[int, Fraction, bool]]:
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

    def signals(self) -> dict[str, Signal]:
        """Return the format of every block, as far as its range is known."""
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

    def declared(self, spread: Fraction) -> dict[str, Declared]:
        """Return the ranges of every block where the length of the attitude is within `spread` of 1."""
        declared: dict[str, Declared] = {}
        signals = self.signals()
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
                most = self.declaration.bounded[name] + signals[name].lsb
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

    def settle(self, spread: Fraction) -> None:
        """Bound what the state keeps beside the attitude by what is written to it, to a fixpoint."""
        stated = (WHOLE_BITS, self.declaration.inputs, self.declaration.counts, self.declaration.bounded)
        known = {name for each in stated for name in each} - {RESIDUAL}
        open_blocks = [name for name in self._blocks() if name not in known]
        for _ in range(12):
            declared, changed = self.declared(spread), False
            for routine in self.fused:
                magnitudes = self.magnitudes(routine, declared)
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
                for name, values in self.entries(written):
                    changed |= self._grow(self.norms, name, length(magnitudes, routine, list(values))[1])
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

    def entries(self, written: Mapping[Place, int]) -> Iterator[tuple[str, tuple[int, ...]]]:
        """Yield the values written to each entry of each block."""
        blocks = self._blocks()
        for name in dict.fromkeys(place.block for place in written):
            size = blocks[name].shape.value
            components = {place.index.constant: value for place, value in written.items() if place.block == name}
            for entry in range(blocks[name].count):
                values = [components.get(size * entry + part) for part in range(size)]
                if None not in values:
                    yield name, tuple(value for value in values if value is not None)

    def magnitudes(self, routine: Routine, declared: Mapping[str, Declared]) -> Magnitudes | None:
        """Return the bounds of a routine; None where it divides by what may be 0."""
        try:
            return Magnitudes(routine, declared, self.declaration.samples, None, self.declaration.turn)
        except ZeroDivisionError:
            return None
