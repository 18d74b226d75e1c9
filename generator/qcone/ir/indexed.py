"""Rows of quantities and the loops that run over them, for recurrences: rolled into C loops or written out.

The author writes the recurrence once. Rolled, the body runs once with a symbolic counter; written out, it
runs for every number and no array is left. The operations and their order are the same, so are the bits.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from qcone.errors import UsageError
from qcone.ir.blocks import Number, Quantity, Scalar, exact, of
from qcone.ir.builder import Builder
from qcone.ir.index import Index
from qcone.ir.statement import Block, Role, Shape


class History:
    """A named row of quantities that loops read and write: `r[n] = r[n - 1] * v`.

    Where loops are written out, its entries are plain values and no array is left.
    """

    def __init__(self, builder: Builder, block: Block) -> None:
        self._builder = builder
        self._block = block
        self._written: dict[int, Any] = {}

    def __setitem__(self, index: Index | int, quantity: Quantity) -> None:
        """Store an entry."""
        if quantity.shape is not self._block.shape:
            raise UsageError(f"history '{self._block.name}' holds {self._block.shape.name.lower()}s")
        self._refuse_outside(index)
        if quantity.builder is not self._builder:
            raise UsageError("a subroutine calculates with its arguments only: hand it every quantity as an argument")
        if not self._builder.writing.rolled and isinstance(index, int):
            self._written[index] = quantity
            return
        base = index * self._block.shape.value
        for part, value in enumerate(quantity.values):
            self._builder.write(self._block, base + part, value)

    def __getitem__(self, index: Index | int) -> Any:
        """Read an entry."""
        self._refuse_outside(index)
        if not self._builder.writing.rolled and isinstance(index, int):
            if index not in self._written:
                raise UsageError(f"history '{self._block.name}': entry {index} is read before it is written")
            return self._written[index]
        base = index * self._block.shape.value
        values = [self._builder.read(self._block, base + part) for part in range(self._block.shape.value)]
        return of(self._builder, self._block.shape, values)

    def _refuse_outside(self, index: Index | int) -> None:
        if isinstance(index, int) and not 0 <= index < self._block.count:
            raise UsageError(f"history '{self._block.name}' has entries 0 to {self._block.count - 1}, not {index}")


def history(name: str, like: Quantity, count: int) -> History:
    """Declare a named history of `count` quantities of the same shape as `like`."""
    builder = like.builder
    return History(builder, builder.declare(name, like.shape, count, Role.LOCAL))


class Table:
    """A row of exact constants, read by a loop counter."""

    def __init__(self, builder: Builder, block: Block) -> None:
        self._builder = builder
        self._block = block

    def __getitem__(self, index: Index | int) -> Scalar:
        """Read a constant."""
        if isinstance(index, int):
            if not 0 <= index < self._block.count:
                raise UsageError(f"table '{self._block.name}' has entries 0 to {self._block.count - 1}, not {index}")
            value = self._builder.constant(self._block.entries[index])
        else:
            value = self._builder.read(self._block, index)
        largest = max(abs(entry) for entry in self._block.entries)
        return Scalar(self._builder, (value,), self._builder.group("input", (value,), norm=largest))


def table(name: str, like: Quantity, entries: Sequence[Number]) -> Table:
    """Declare a named table of exact constants beside `like`."""
    builder = like.builder
    block = builder.declare(name, Shape.SCALAR, len(entries), Role.TABLE, [exact(entry) for entry in entries])
    return Table(builder, block)


def loop(counter: str, like: Quantity, first: Index | int, last: Index | int) -> Iterator[Any]:
    """Yield a counter from `first` to `last`, both ends included.

    Written as `for n in loop("n", q, 1, 10)`. Rolled, the body runs once with a symbolic counter and becomes a C
    loop; otherwise it runs for every number and is written out. The operations and their order are the same.
    """
    builder = like.builder
    if builder.writing.rolled:
        lower = first if isinstance(first, Index) else Index(first)
        upper = last if isinstance(last, Index) else Index(last)
        if not lower.terms and not upper.terms and lower.constant > upper.constant:
            return
        yield from builder.loop(counter, lower, upper)
        return
    if isinstance(first, Index) or isinstance(last, Index):
        raise UsageError(f"loop '{counter}': its bounds must be numbers where loops are written out")
    yield from range(first, last + 1)
