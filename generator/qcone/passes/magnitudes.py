"""Magnitudes: what no value of a routine can exceed, roundings included, from what is declared of its blocks.

Three views of the same values, each an exact rational bound, and the least of them counts: intervals; Euclidean
norms of vectors and quaternions, |a x b| <= |a| |b|, |q (x) r| = |q| |r|; and, for weighted sums of input samples,
their differences in time, which a declared angular acceleration and jerk bound.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from qcone.ir.detail import Limits, Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Group, Operation, Routine
from qcone.passes.intervals import ZERO, Interval, outward, quotient, root_above, times
from qcone.passes.lengths import norm_of
from qcone.passes.samples import Forms, Samples


@dataclass(frozen=True)
class Declared:
    """What is declared of a block: each component's interval, and the norm of each entry, from and to."""

    interval: Interval
    norm: Interval | None = None


class Magnitudes:
    """The bounds of one routine's values; `errors` are the roundings each value carries."""

    def __init__(
        self,
        routine: Routine,
        declared: Mapping[str, Declared],
        samples: Samples | None = None,
        errors: Mapping[int, Fraction] | None = None,
        turn: Fraction | None = None,
        limits: Mapping[int, Fraction] | None = None,
    ) -> None:
        """Bound every value of a routine of sums, in order.

        `turn` bounds the rotation vector of one update over the rationals. Its own roundings are far below a
        thousandth of it in every format, and that much is added. `limits` are the sizes that results are clamped to
        where they can be larger: `clamped` are those that can.
        """
        self.limits = limits or {}
        self.clamped: set[int] = set()
        self.routine, self.declared = routine, declared
        self.errors = errors or {}
        turned = {group.operands[0] for group in routine.groups if group.kind == "exp"}
        self._turns = {number: turn * Fraction(1025, 1024) for number in turned} if turn is not None else {}
        self.values: dict[int, Interval] = {}
        self._raw: dict[int, Interval] = {}
        self._forms = Forms(samples)
        self._rules: dict[int, Interval | None] = {}
        self._norms: dict[int, Interval | None] = {}
        self._holding: dict[int, list[int]] = {}
        self._read: dict[int, str] = {}
        self._twins: dict[tuple[int, ...], list[int]] = {}
        for number, group in enumerate(routine.groups):
            self._twins.setdefault(group.values, []).append(number)
            for value in group.values:
                self._holding.setdefault(value, []).append(number)
        for statement in routine.body:
            if isinstance(statement, Operation):
                self._bound(statement)

    def of(self, value: int) -> Fraction:
        """Return the largest size of a value."""
        low, high = self.values[value]
        return max(-low, high)

    def _bound(self, operation: Operation) -> None:
        result = operation.result
        error = self.errors.get(result, ZERO)
        self._forms.note(operation, error)
        low, high = self._operation(operation)
        low, high = low - error, high + error
        if operation.op is RealOp.CLAMP and isinstance(operation.detail, Limits):
            low, high = max(low, operation.detail.low), min(high, operation.detail.high)
            low, high = min(low, high), max(low, high)
        most = self.limits.get(result) if operation.op in (RealOp.SUM, RealOp.WIDE) else None
        if most is not None and max(-low, high) > most:
            self.clamped.add(result)
            low, high = max(low, -most), min(high, most)
            low, high = min(low, high), max(low, high)
        self._raw[result] = outward((low, high))
        for number in self._holding.get(result, ()):
            known = self._rule(number)
            if known is None:
                continue
            slop = self._slop(self.routine.groups[number])
            if len(self.routine.groups[number].values) == 1:
                low, high = max(low, known[0] - slop), min(high, known[1] + slop)
            else:
                low, high = max(low, -known[1] - slop), min(high, known[1] + slop)
        self.values[result] = outward((min(low, high), max(low, high)))

    def _operation(self, operation: Operation) -> Interval:
        args = [self.values[arg] for arg in operation.args if arg in self.values]
        match operation.op:
            case RealOp.CONSTANT:
                assert operation.constant is not None
                return (operation.constant, operation.constant)
            case RealOp.READ:
                assert operation.place is not None
                self._read[operation.result] = operation.place.block
                return self.declared[operation.place.block].interval
            case RealOp.SUM | RealOp.WIDE:
                assert isinstance(operation.detail, Sum)
                total = self._sum(operation.detail.terms)
                most = self._forms.bound(operation.result)
                if most is not None:
                    total = (max(total[0], -most), min(total[1], most))
                return total
            case RealOp.SELECT:
                return (min(args[1][0], args[2][0]), max(args[1][1], args[2][1]))
            case RealOp.LESS:
                return (ZERO, Fraction(1))
            case RealOp.CLAMP:
                return args[0]
            case RealOp.DIVIDE:
                return quotient(args[0], args[1])
        raise AssertionError(f"{operation.op} is not of a routine of sums")

    def _sum(self, terms: tuple[Term, ...]) -> Interval:
        low = high = ZERO
        for term in terms:
            a, b = self.term(term)
            low, high = low + a, high + b
        return low, high

    def term(self, term: Term) -> Interval:
        """Return the interval of one term."""
        if not term.args:
            return (term.coefficient, term.coefficient)
        a = self.values[term.args[0]]
        if len(term.args) == 2:
            if term.args[0] == term.args[1]:
                most = max(a[0] * a[0], a[1] * a[1])
                a = (ZERO if a[0] <= 0 <= a[1] else min(a[0] * a[0], a[1] * a[1]), most)
            else:
                a = times(a, self.values[term.args[1]])
                together = self._together(*term.args)
                if together is not None:
                    a = (max(a[0], -together), min(a[1], together))
        low, high = term.coefficient * a[0], term.coefficient * a[1]
        return (min(low, high), max(low, high))

    def _together(self, a: int, b: int) -> Fraction | None:
        """Return a bound of |x y| for components x, y of one vector: half its square, 2 |x y| <= x^2 + y^2."""
        found = []
        for number in self._holding.get(a, ()):
            group = self.routine.groups[number]
            if b in group.values and len(group.values) > 1:
                norm = self.norm(number)
                if norm is not None:
                    found.append(norm[1] * norm[1] / 2)
        return min(found, default=None)

    def of_any_subset(self, operation: Operation) -> Fraction | None:
        """Return a bound of any partial sum of a sum that is a component of a product of vectors, in any order.

        Such a component is a scalar product of the two vectors' components in some order and with some signs; so is
        every part of it, of shorter vectors: |a| |b| bounds them all (Cauchy, Schwarz).
        """
        assert isinstance(operation.detail, Sum)
        terms = operation.detail.terms
        if any(len(term.args) != 2 for term in terms) or len({abs(term.coefficient) for term in terms}) != 1:
            return None
        scale, found = abs(terms[0].coefficient), []
        for number in self._holding.get(operation.result, ()):
            group = self.routine.groups[number]
            whole = group.kind in ("dot", "cross") or (group.kind == "product" and len(group.values) == 4)
            norms = [self.norm(operand) for operand in group.operands] if whole else []
            sizes = [norm[1] for norm in norms if norm is not None]
            if len(sizes) == 2 and all(len(self.routine.groups[each].values) > 1 for each in group.operands):
                found.append(max(Fraction(1), scale) * sizes[0] * sizes[1])
        return min(found, default=None)

    # -- groups ---------------------------------------------------------------------------------------

    def norm(self, number: int) -> Interval | None:
        """Return the norm of a group, from and to; for one of a single value, its interval."""
        if number not in self._norms:
            group = self.routine.groups[number]
            known = self._rules_together(group)
            if known is not None:
                slop = self._slop(group)
                low = known[0] - slop if len(group.values) == 1 else max(ZERO, known[0] - slop)
                known = outward((low, known[1] + slop))
            own = [self._raw[value] for value in group.values if value in self._raw]
            if own and len(own) == len(group.values):
                if len(own) == 1:
                    known = own[0] if known is None else (max(known[0], own[0][0]), min(known[1], own[0][1]))
                else:
                    most = root_above(sum((max(-a, b) ** 2 for a, b in own), ZERO))
                    known = (ZERO, most) if known is None else (known[0], min(known[1], most))
            together = self._forms.norm(group.values)
            if together is not None:
                known = (ZERO, together) if known is None else (min(known[0], together), min(known[1], together))
            self._norms[number] = known
        return self._norms[number]

    def _rules_together(self, group: Group) -> Interval | None:
        """Return what all records of the same values say of them."""
        found = [rule for twin in self._twins[group.values] if (rule := self._rule(twin)) is not None]
        return (max(low for low, _ in found), min(high for _, high in found)) if found else None

    def _slop(self, group: Group) -> Fraction:
        errors = [self.errors.get(value if value >= 0 else ~value, ZERO) for value in group.values]
        return errors[0] if len(errors) == 1 else root_above(sum((each * each for each in errors), ZERO))

    def _rule(self, number: int) -> Interval | None:
        if number not in self._rules:
            self._rules[number] = None  # a group put together of parts of another leads back to itself
            known, turn = self._by_kind(self.routine.groups[number]), self._turns.get(number)
            if turn is not None:
                known = (ZERO, turn) if known is None else (min(known[0], turn), min(known[1], turn))
            self._rules[number] = known
        return self._rules[number]

    def _by_kind(self, group: Group) -> Interval | None:
        single = len(group.values) == 1
        if group.kind == "input":
            block = next((self._read[value] for value in group.values if value in self._read), group.block)
            known = self.declared.get(block)
            if known is not None:
                if known.norm is not None and len(group.values) == 9:
                    return (ZERO, known.norm[1] ** 2)
                return known.interval if single else known.norm
            if group.norm is None:
                return None
            return (-group.norm, group.norm) if single else (ZERO, group.norm)
        if group.kind == "constant" and group.factor is not None:
            return (group.factor, group.factor)
        if group.kind in ("other", "root"):
            return None
        if group.kind == "row" and self.routine.groups[group.operands[0]].kind == "input":
            whole = self.routine.groups[group.operands[0]]
            block = next((self._read[value] for value in whole.values if value in self._read), whole.block)
            norm = self.declared[block].norm if block in self.declared else None
            # What is declared holds of the first two rows; the third is their cross product.
            return norm if norm is None or group.factor != 2 else (ZERO, norm[1] ** 2)
        if group.kind == "together":
            parts = [self.norm(operand) for operand in group.operands]
            if any(each is None for each in parts):
                return None
            return (ZERO, root_above(sum((max(-each[0], each[1]) ** 2 for each in parts if each), ZERO)))
        if group.kind == "part" and single:
            # One component of what was put together is what it was before.
            whole = self.routine.groups[group.operands[0]]
            same = [each for each in whole.operands if self.routine.groups[each].values == group.values]
            if whole.kind == "together" and same:
                return self.norm(same[0])
        operands = [self.norm(operand) for operand in group.operands]
        if group.kind in ("products", "sums") and group.factor is not None:
            ends = [each[1] for each in operands if each is not None]
            if len(ends) < len(operands):
                return None
            if group.kind == "products":
                ends = [a * b for a, b in zip(ends[::2], ends[1::2], strict=True)]
            return (ZERO, abs(group.factor) * sum(ends, ZERO))
        if not operands or any(each is None for each in operands[:3]):
            return None
        known_operands = [each for each in operands[:3] if each is not None]
        sizes = [len(self.routine.groups[operand].values) for operand in group.operands]
        bound = norm_of(group, single, known_operands, sizes)
        if bound is None or group.kind != "rotated":
            return bound
        # q and r are exact in the rule; what is rounded on the way to the new attitude stands in the other operands,
        # and an error there moves it by at most |q| <= 2 times itself.
        slop = 2 * sum((self._slop(self.routine.groups[operand]) for operand in group.operands[3:]), ZERO)
        return (max(ZERO, bound[0] - slop), bound[1] + slop)
