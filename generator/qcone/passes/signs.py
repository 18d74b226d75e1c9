"""Carry signs to where they cost nothing: exact, up to the sign of a zero.

A negation moves through products into the next sum, which becomes a difference, or, if nothing takes it,
stays before the write. So a signed permutation of the axes costs no operation, unless what is turned is
stored. IEEE 754 rounds symmetrically: (-a) b = -(a b) and (-a) + (-b) = -(a + b), bit for bit unless the
result is a zero.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from qcone.ir.operations import RealOp
from qcone.ir.statement import (
    Advance,
    Call,
    Choose,
    Group,
    Loop,
    Operation,
    Ready,
    Routine,
    Statement,
    Write,
    results,
    walk,
)
from qcone.passes.rebuild import regrouped


def signs(routine: Routine) -> Routine:
    """Return the routine with negations absorbed wherever an operation can take them."""
    callees = {name: signs(callee) for name, callee in routine.callees.items()}
    if not any(isinstance(each, Operation) and each.op is RealOp.NEGATE for each in walk(routine.body)):
        return replace(routine, callees=callees)
    carrier = _Carrier(routine)
    body = carrier.body(routine.body)
    return replace(routine, body=body, names=carrier.names, groups=carrier.groups(routine.groups), callees=callees)


class _Carrier:
    """Knows, for every value of the old body, which new value stands for it and with which sign."""

    def __init__(self, routine: Routine) -> None:
        self.names = dict(routine.names)
        self.stand_in: dict[int, tuple[int, int]] = {}
        self.next = max(results(routine.body), default=-1) + 1

    def groups(self, groups: tuple[Group, ...]) -> tuple[Group, ...]:
        """Return the groups over what stands for their values; a single value with the other sign is marked by ~.

        The norm of a vector does not depend on the signs of its components.
        """
        stand_in = {value: other for value, (_, other) in self.stand_in.items() if other != value}
        negated = {value for value, (sign, _) in self.stand_in.items() if sign < 0}
        kept = (
            replace(group, values=(~group.values[0],))
            if len(group.values) == 1 and group.values[0] in negated
            else group
            for group in groups
        )
        return regrouped(tuple(kept), stand_in)

    def body(self, body: tuple[Statement, ...]) -> tuple[Statement, ...]:
        out: list[Statement] = []
        for statement in body:
            match statement:
                case Operation():
                    self._operation(statement, out)
                case Write():
                    value = self._positive(statement.value, statement, out.append)
                    out.append(replace(statement, value=value))
                case Loop():
                    before = dict(self.stand_in)
                    out.append(replace(statement, body=self.body(statement.body)))
                    self.stand_in = before  # a negation made inside the loop is not to be seen outside it
                case Call():
                    args = tuple(self._positive(arg, statement, out.append) for arg in statement.args)
                    out.append(replace(statement, args=args))
                case Advance() | Choose() | Ready():
                    out.append(statement)
        return tuple(out)

    def _operation(self, operation: Operation, out: list[Statement]) -> None:
        signed = [self.stand_in.get(arg, (1, arg)) for arg in operation.args]
        sign = 1
        match operation.op:
            case RealOp.NEGATE:
                sign, value = signed[0]
                self.stand_in[operation.result] = (-sign, value)
                if operation.result in self.names and value not in self.names:
                    self.names[value] = self.names[operation.result] + ("_negated" if sign > 0 else "")
                return
            case RealOp.MULTIPLY | RealOp.DIVIDE:
                sign = signed[0][0] * signed[1][0]
                operation = replace(operation, args=(signed[0][1], signed[1][1]))
            case RealOp.ADD | RealOp.SUBTRACT:
                (s, a), (t, b) = signed
                t = t if operation.op is RealOp.ADD else -t
                if s == t:
                    sign, operation = s, replace(operation, op=RealOp.ADD, args=(a, b))
                else:
                    first, second = (a, b) if s > 0 else (b, a)
                    operation = replace(operation, op=RealOp.SUBTRACT, args=(first, second))
            case _:
                args = tuple(self._positive(arg, operation, out.append) for arg in operation.args)
                operation = replace(operation, args=args)
        if sign < 0:
            self.stand_in[operation.result] = (-1, operation.result)
            if operation.result in self.names:
                self.names[operation.result] += "_negated"
        out.append(operation)

    def _positive(self, value: int, near: Statement, append: Callable[[Statement], None]) -> int:
        sign, stand_in = self.stand_in.get(value, (1, value))
        if sign > 0:
            return stand_in
        result, self.next = self.next, self.next + 1
        append(Operation(result, RealOp.NEGATE, (stand_in,), step=near.step))
        self.stand_in[value] = (1, result)
        return result
