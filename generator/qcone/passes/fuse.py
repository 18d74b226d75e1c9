"""Fuse sums: operations whose results only enter one sum become its terms. Exact over the rationals.

Fixed point rounds a sum of products once. What is used once, in a sum, a difference, a negation or a product with a
power of two, is taken into its consumer; a product with a power of two alone is a change of the binary point and no
operation at all. What is left are sums of terms, beside reads, comparisons, selections, clamps and divisions.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from qcone.errors import UsageError
from qcone.ir.detail import Aligned, Sum, Term
from qcone.ir.operations import RealOp
from qcone.ir.statement import Call, Loop, Operation, Routine, Statement, Write, walk

Terms = tuple[Term, ...]
NOTHING: Terms = (Term(Fraction(0)),)
"""The terms of a sum in which everything cancels."""


def fuse(routine: Routine) -> Routine:
    """Return the routine in sums of products. Raises UsageError for one that holds a loop or a call."""
    if any(isinstance(each, Loop | Call) for each in walk(routine.body)):
        raise UsageError(
            f"the routine '{routine.name}' has a loop or calls a subroutine: in fixed point every turn has formats of "
            'its own; set loop = "unrolled" and write subroutines out'
        )
    return _Fusion(routine).run()


class _Fusion:
    def __init__(self, routine: Routine) -> None:
        self.routine = routine
        self.uses: Counter[int] = Counter()
        for statement in walk(routine.body):
            match statement:
                case Operation():
                    self.uses.update(statement.args)
                case Write():
                    self.uses[statement.value] += 1
        self.sums: dict[int, Terms] = {}
        self.origin: dict[int, Operation] = {}
        self.as_values: set[int] = set()
        """Constants that are needed as values, beside the sums that take them in."""
        self.names = dict(routine.names)
        self.body: list[Statement] = []

    def run(self) -> Routine:
        for statement in self.routine.body:
            match statement:
                case Operation():
                    self._operation(statement)
                case Write():
                    self.body.append(replace(statement, value=self._value(statement.value)))
                case _:
                    self.body.append(statement)
        return replace(self.routine, body=self._in_order(), names=self.names)

    def _in_order(self) -> tuple[Statement, ...]:
        """Return the statements, each operation where its author wrote it and what it is made of stands before it."""
        at = {each.result: k for k, each in enumerate(self.routine.body) if isinstance(each, Operation)}
        operations = [each for each in self.body if isinstance(each, Operation)]
        operations.sort(key=lambda each: at[each.result])
        return (*operations, *(each for each in self.body if not isinstance(each, Operation)))

    def _operation(self, operation: Operation) -> None:
        result, op, args = operation.result, operation.op, operation.args
        self.origin[result] = operation
        if op is RealOp.CONSTANT and operation.constant is not None:
            self.sums[result] = (Term(operation.constant),)
        elif op in (RealOp.ADD, RealOp.ACCUMULATE):
            self.sums[result] = _merged(self._terms(args[0]) + self._terms(args[1]))
        elif op is RealOp.SUBTRACT:
            self.sums[result] = _merged(self._terms(args[0]) + _scaled(self._terms(args[1]), Fraction(-1)))
        elif op is RealOp.NEGATE:
            self.sums[result] = _scaled(self._terms(args[0]), Fraction(-1))
        elif op is RealOp.MULTIPLY:
            self.sums[result] = self._product(*args)
        elif op in (RealOp.CARRY, RealOp.WIDE):
            terms = self._terms(args[0], mark=False) or NOTHING
            detail = Sum(terms, carried=op is RealOp.CARRY)
            self.body.append(
                replace(operation, op=RealOp.SUM if op is RealOp.CARRY else op, args=args_of(terms), detail=detail)
            )
            if args[0] in self.names:
                self.names.setdefault(result, self.names[args[0]])
        else:
            self.body.append(replace(operation, args=tuple(map(self._value, args))))

    def _terms(self, value: int, mark: bool = True) -> Terms:
        """Return what stands for a value in a sum: its own terms where nothing else needs it, or itself.

        With `mark` they remember the value they are a part of, where it has a name.
        """
        terms = self.sums.get(value)
        if terms is None:
            return (Term(Fraction(1), (value,)),)
        if is_scale(terms) or not any(term.args for term in terms):
            return terms
        if self.uses[value] == 1:
            if not mark or value not in self.names:
                return terms
            step = self.origin[value].step
            return tuple(term if term.part is not None else replace(term, part=value, step=step) for term in terms)
        self._keep(value)
        return (Term(Fraction(1), (value,)),)

    def _keep(self, value: int) -> None:
        """Write the sum of a value that is needed as such."""
        terms = self.sums.pop(value) or NOTHING
        origin = self.origin[value]
        operation = replace(origin, op=RealOp.SUM, args=args_of(terms), constant=None, place=None, detail=Sum(terms))
        self.body.append(operation)

    def _value(self, value: int) -> int:
        """Return a value that is written: the one itself, or what it is another name for."""
        terms = self.sums.get(value)
        if terms is None:
            return value
        if len(terms) == 1 and terms[0].coefficient == 1 and len(terms[0].args) == 1:
            return terms[0].args[0]
        if self.origin[value].op is RealOp.CONSTANT:
            if value not in self.as_values:
                self.as_values.add(value)
                self.body.append(self.origin[value])
            return value
        self._keep(value)
        return value

    def _factor(self, value: int) -> tuple[Fraction, int | None]:
        """Return a value as a coefficient times a written value; None for a constant."""
        terms = self.sums.get(value)
        if terms is not None and not terms:
            return Fraction(0), None
        if terms is not None and len(terms) == 1 and not terms[0].args:
            return terms[0].coefficient, None
        if terms is not None and is_scale(terms):
            return terms[0].coefficient, terms[0].args[0]
        return Fraction(1), self._value(value)

    def _product(self, left: int, right: int) -> Terms:
        for factor, other in ((left, right), (right, left)):
            constant = self.sums.get(factor)
            if constant is not None and len(constant) == 1 and not constant[0].args:
                scale = constant[0].coefficient
                if is_power_of_two(scale) or not scale:
                    return _scaled(self._terms(other), scale) if scale else ()
                (k, value) = self._factor(other)
                if not k:
                    return ()
                return (Term(scale * k),) if value is None else (Term(scale * k, (value,)),)
        (a, x), (b, y) = self._factor(left), self._factor(right)
        if not a * b:
            return ()
        if x is None or y is None:
            return (Term(a * b, tuple(each for each in (x, y) if each is not None)),)
        return (Term(a * b, (x, y)),)


def is_scale(terms: Terms) -> bool:
    """Tell whether the terms are one value times a power of two: the same word, its binary point elsewhere."""
    return len(terms) == 1 and len(terms[0].args) == 1 and is_power_of_two(terms[0].coefficient)


def is_power_of_two(value: Fraction) -> bool:
    """Tell whether a number is 2^k or -2^k."""
    top, bottom = abs(value.numerator), value.denominator
    return bool(top) and top & (top - 1) == 0 and bottom & (bottom - 1) == 0


def args_of(terms: Iterable[Term | Aligned]) -> tuple[int, ...]:
    """Return the values that terms are made of, each once."""
    return tuple(dict.fromkeys(arg for term in terms for arg in term.args))


def _scaled(terms: Terms, factor: Fraction) -> Terms:
    return tuple(Term(term.coefficient * factor, term.args) for term in terms)


def _merged(terms: Terms) -> Terms:
    """Put terms of the same values together where a power of two, or nothing, comes of it."""
    merged: list[Term] = []
    for term in terms:
        key = tuple(sorted(term.args))
        for at, other in enumerate(merged):
            total = other.coefficient + term.coefficient
            if tuple(sorted(other.args)) == key and (not key or not total or is_power_of_two(total)):
                merged[at] = replace(other, coefficient=total)
                break
        else:
            merged.append(term)
    return tuple(term for term in merged if term.coefficient)
