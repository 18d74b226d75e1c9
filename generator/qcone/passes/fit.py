"""Fit sums into their accumulators: what is too wide needs fewer bits after one step, and another round finds out.

A constant is shortened; what is finer than the rest of its sum is rounded first, as a value of its own; or an operand
is kept with fewer bits. What has no such step left has no room.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from qcone.ir.detail import Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Operation, Statement
from qcone.passes.choices import Choices, Formats, UnfitError, nearest
from qcone.passes.fuse import args_of, is_power_of_two

LEAST_DROPPED = 8
"""Fewer dropped bits than these would show the bias of rounding halves up."""
SHORTEST_CONSTANT = 12
"""Bits that a constant keeps at least when it is shortened to make a sum fit."""


def fit(choices: Choices, found: Formats) -> bool:
    """Mend every sum that overflows its accumulator, one step each; tell whether there was one.

    Raises UnfitError where no step is left.
    """
    return _Fitting(choices, found).mend()


class _Fitting:
    """One round: the formats as they were found, and the choices to be made after them."""

    def __init__(self, choices: Choices, found: Formats) -> None:
        self.choices, self.found = choices, found
        operations = [each for each in choices.routine.body if isinstance(each, Operation)]
        self.made = {each.result: each for each in operations}
        self.users: dict[int, list[Operation]] = {}
        for each in operations:
            for arg in each.args:
                self.users.setdefault(arg, []).append(each)

    def mend(self) -> bool:
        """Mend every sum that overflows its accumulator, one step each; tell whether there was one."""
        assert self.found.magnitudes is not None
        body: list[Statement] = []
        mended = False
        for statement in self.choices.routine.body:
            if isinstance(statement, Operation) and isinstance(statement.detail, Sum):
                broad = self._broad_factor(statement.detail)
                if broad is not None:
                    mended = True
                    body.extend(self._narrowed(statement, broad))
                    continue
                over = self._over(statement)
                if over > 0:
                    mended = True
                    split = self._step(statement, over)
                    if split is not None:
                        body.extend(split)
                        continue
            body.append(statement)
        mended = mended or self._free_of_bias()
        if mended:
            self.choices.routine = replace(self.choices.routine, body=tuple(body), names=self.choices.names)
        return mended

    def _broad_factor(self, detail: Sum) -> int | None:
        """Return a factor of a product that is wider than a word; None when there is none."""
        for term in detail.terms:
            if len(term.args) == 2 or not is_power_of_two(term.coefficient):
                for arg in term.args:
                    if self.found.signals[arg].width > self.choices.number.width:
                        return arg
        return None

    def _narrowed(self, operation: Operation, broad: int) -> list[Statement]:
        """Round a factor to a word first."""
        assert isinstance(operation.detail, Sum)
        value = self.choices.fresh()
        name = self.choices.names.get(broad)
        if name:
            self.choices.names[value] = f"{name}_upper"
        first = Sum((Term(Fraction(1), (broad,)),))
        made = Operation(value, RealOp.SUM, (broad,), step=operation.step, detail=first)
        terms = tuple(
            replace(term, args=tuple(value if arg == broad else arg for arg in term.args))
            if len(term.args) == 2 or not is_power_of_two(term.coefficient)
            else term
            for term in operation.detail.terms
        )
        return [made, replace(operation, args=args_of(terms), detail=replace(operation.detail, terms=terms))]

    def _free_of_bias(self) -> bool:
        """Round what was split off a sum to the sum's own last bit where that would drop only few bits after all.

        Rounding halves up is biased by 2^-(n+1) of a last bit when n bits are dropped: seen for few bits alone. A part
        that is rounded where many bits are dropped, and then added exactly, has no such bias. Carried sums have none.
        """
        changed = False
        for statement in self.choices.routine.body:
            if (
                not isinstance(statement, Operation)
                or not isinstance(statement.detail, Sum)
                or statement.detail.carried
            ):
                continue
            own = self.found.signals[statement.result].fraction
            finest, bits = self.found.accumulated(statement)
            if not 0 < finest - own < LEAST_DROPPED:
                continue
            fine = [
                term for term, each in zip(statement.detail.terms, bits, strict=True) if each is not None and each > own
            ]
            if all(len(term.args) == 1 and term.args[0] in self.choices.split for term in fine):
                for term in fine:
                    over = self.found.term_bits(statement.result, 0, term)
                    assert over is not None
                    self.choices.caps[term.args[0]] = self.found.signals[term.args[0]].fraction - (over - own)
                    changed = True
        return changed

    def _over(self, operation: Operation) -> int:
        size, over = self.found.accumulator_size(operation), 0
        while size >= 2 ** (self.choices.number.wide - 1 + over):
            over += 1
        return over

    def _step(self, operation: Operation, over: int) -> list[Statement] | None:
        """Make one sum need fewer bits: return the statements that stand for it, or None where only a cap changed."""
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        finest, bits = self.found.accumulated(operation)
        top = [at for at, each in enumerate(bits) if each == finest]
        own = self.found.signals[operation.result]
        if finest <= own.fraction and own.width == self.choices.number.wide:
            if operation.result in self.choices.forced:
                raise self._no_room(operation, over)
            self.choices.caps[operation.result] = own.fraction - over
        constant = all((operation.result, at) in self.found.constants for at in top)
        if constant and all(self._shorten(operation.result, at, over) for at in top):
            return None
        part = self._part(operation, top, bits)
        if part is not None:
            return self._split(operation, part)
        wanted = {at: self._wanted(terms[at], over) for at in top}
        if all(wanted.values()):
            # The finest terms have an operand whose last bits nothing misses: it is kept with fewer.
            for each in wanted.values():
                assert each is not None
                self.choices.caps[each] = min(
                    self.choices.caps.get(each, 10**6), self.found.signals[each].fraction - over
                )
            return None
        if len(top) < len(terms):
            linear = [at for at in top if len(terms[at].args) == 1]
            if linear:
                return self._recast(operation, linear[0], finest - over)
            return self._split(operation, top)
        for at in top:
            movable = [arg for arg in terms[at].args if arg not in self.choices.forced and self._movable(arg)]
            if not movable:
                raise self._no_room(operation, over)
            widest = max(movable, key=lambda arg: self.found.signals[arg].fraction)
            self.choices.caps[widest] = self.found.signals[widest].fraction - over
        return None

    def _wanted(self, term: Term, over: int) -> int | None:
        """Return an operand of a term that can do without its last `over` bits; None when there is none."""
        free = [arg for arg in term.args if arg not in self.choices.forced and self._movable(arg)]
        free.sort(key=lambda arg: -self.found.signals[arg].fraction)
        return next((arg for arg in free if self._harmless(arg, self.found.signals[arg].fraction - over)), None)

    def _harmless(self, value: int, bits: int) -> bool:
        """Tell whether rounding a value to so many fraction bits stays below the last bit of all that use it."""
        assert self.found.magnitudes is not None
        error = Fraction(2) ** -(bits + 1)
        for statement in self.users.get(value, []):
            if not isinstance(statement.detail, Sum):
                return False
            for term in statement.detail.terms:
                if value not in term.args:
                    continue
                size = abs(term.coefficient) * (2 if term.args == (value, value) else 1)
                others = list(term.args)
                others.remove(value)
                for other in others:
                    size *= self.found.magnitudes.of(other)
                rest = [other for other in statement.detail.terms if value not in other.args]
                inherent = max((self._inherent(other) for other in rest), default=Fraction(0))
                if size * error > max(inherent, self.found.signals[statement.result].lsb / 2):
                    return False
        return True

    def _inherent(self, term: Term) -> Fraction:
        """Return what the roundings of a term's own operands make of it."""
        assert self.found.magnitudes is not None
        total = Fraction(0)
        for arg in term.args:
            if self._movable(arg):
                # By its own bound, not as it is kept now: else one loss would justify the next.
                size = abs(term.coefficient) * self.choices.number.ulp(self.found.magnitudes.of(arg)) / 2
                others = list(term.args)
                others.remove(arg)
                for other in others:
                    size *= self.found.magnitudes.of(other)
                total += size
        return total

    def _movable(self, value: int) -> bool:
        operation = self.made.get(value)
        return operation is not None and operation.op in (RealOp.SUM, RealOp.CONSTANT, RealOp.WIDE, RealOp.SELECT)

    def _shorten(self, value: int, at: int, over: int) -> bool:
        now = self.choices.short.get((value, at), 0)
        signal = self.found.constants[value, at]
        term = self.made[value].detail
        assert isinstance(term, Sum)
        raw = abs(nearest(term.terms[at].coefficient, signal)) / signal.lsb
        length = int(raw).bit_length()
        if length - over < SHORTEST_CONSTANT:
            return False
        self.choices.short[value, at] = max(now, self.choices.number.width - 1 - length) + over
        return True

    def _part(self, operation: Operation, top: list[int], bits: list[int | None]) -> list[int] | None:
        """Return the terms to be rounded first: those of the finest ones' own sum, or products among linear terms."""
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        for at in top:
            part = terms[at].part
            if part is not None:
                members = [k for k, term in enumerate(terms) if term.part == part]
                if len(members) < len(terms) and any(not self._is_linear(terms[k]) for k in members):
                    return members
        products = [k for k, term in enumerate(terms) if not self._is_linear(term)]
        words = [k for k, term in enumerate(terms) if self._is_linear(term) and term.args]
        if products and words and any(at in products for at in top):
            return products
        return None

    @staticmethod
    def _is_linear(term: Term) -> bool:
        return (len(term.args) < 2 and is_power_of_two(term.coefficient)) or not term.args

    def _split(self, operation: Operation, members: list[int]) -> list[Statement]:
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        self.choices.short = {key: bits for key, bits in self.choices.short.items() if key[0] != operation.result}
        parts = {terms[k].part for k in members}
        part = parts.pop() if len(parts) == 1 else None
        fresh = part is None
        value = self.choices.fresh() if part is None else part
        first = Sum(tuple(replace(terms[k], part=None) for k in members))
        name = self.choices.names.get(operation.result)
        if fresh and name:
            self.choices.names[value] = f"{name}_part"
        wide = (
            operation.result in self.choices.forced
            and self.choices.forced[operation.result].width == self.choices.number.wide
        )
        op = RealOp.WIDE if wide or operation.op is RealOp.WIDE else RealOp.SUM
        self.choices.split.add(value)
        step = terms[members[0]].step if part is not None else operation.step
        made = Operation(value, op, args_of(first.terms), step=step, detail=first)
        rest = list(terms)
        rest[members[0]] = Term(Fraction(1), (value,))
        kept = tuple(term for k, term in enumerate(rest) if k == members[0] or k not in members)
        detail = replace(operation.detail, terms=kept)
        return [made, replace(operation, args=args_of(kept), detail=detail)]

    def _recast(self, operation: Operation, at: int, bits: int) -> list[Statement]:
        """Round one linear term first, to so many fraction bits."""
        assert isinstance(operation.detail, Sum)
        self.choices.short = {key: bits for key, bits in self.choices.short.items() if key[0] != operation.result}
        term = operation.detail.terms[at]
        value = self.choices.fresh()
        name = self.choices.names.get(term.args[0])
        if name:
            self.choices.names[value] = f"{name}_rounded"
        self.choices.caps[value] = bits
        first = Sum((replace(term, part=None),))
        kept = tuple(Term(Fraction(1), (value,)) if k == at else each for k, each in enumerate(operation.detail.terms))
        made = Operation(value, RealOp.SUM, term.args, step=operation.step, detail=first)
        return [made, replace(operation, args=args_of(kept), detail=replace(operation.detail, terms=kept))]

    def _no_room(self, operation: Operation, over: int) -> UnfitError:
        name = self.choices.routine.names.get(operation.result, f"value {operation.result}")
        return UnfitError(
            f"the sum '{name}' in '{self.choices.routine.name}' needs {over} bit{'s' * (over > 1)} more than an "
            f"accumulator of {self.choices.number.wide}"
        )
