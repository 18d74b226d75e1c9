"""Read late: read the state where it is first needed, not at the head of a routine. Exact.

A word that is read early holds a register, or a place on the stack, until it is used. The components of a block are
read together, with what is made of each alone, before the first operation that needs one of them.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from qcone.ir.machine import MachineOp
from qcone.ir.statement import Call, Operation, Role, Routine, Statement, Write


@dataclass
class _Waiting:
    """What is not written out yet, by block; and the block of each value that waits."""

    statements: dict[str, list[Statement]] = field(default_factory=dict)
    of: dict[int, str] = field(default_factory=dict)

    def add(self, operation: Operation, block: str) -> None:
        self.statements.setdefault(block, []).append(operation)
        self.of[operation.result] = block

    def needed(self, statement: Statement) -> set[str]:
        """Return the blocks that have to be read before a statement: a block that is written is one of them."""
        match statement:
            case Operation(args=args) | Call(args=args):
                return {self.of[arg] for arg in args if arg in self.of}
            case Write(place, value):
                return {place.block} | ({self.of[value]} if value in self.of else set())
        return set(self.statements)

    def out(self, block: str) -> list[Statement]:
        self.of = {value: other for value, other in self.of.items() if other != block}
        return self.statements.pop(block, [])


def read_late(routine: Routine) -> Routine:
    """Return a routine without loops, its state read where it is needed. What nothing needs is read last."""
    state = {block.name for block in routine.having(Role.STATE)}
    waiting = _Waiting()
    body: list[Statement] = []
    for statement in routine.body:
        blocks = waiting.needed(statement)
        if isinstance(statement, Operation):
            if statement.op is MachineOp.READ and statement.place is not None and statement.place.block in state:
                waiting.add(statement, statement.place.block)
                continue
            if blocks and len(statement.args) == 1 and statement.op is MachineOp.SHIFT_RIGHT:
                waiting.add(statement, blocks.pop())
                continue
        for block in [each for each in waiting.statements if each in blocks]:
            body.extend(waiting.out(block))
        body.append(statement)
    for block in list(waiting.statements):
        body.extend(waiting.out(block))
    return replace(routine, body=tuple(body))
