"""Subroutines: a function of vectors and quaternions that is written once and called: a static function in C."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from qcone.errors import UsageError
from qcone.ir.blocks import Quantity, of
from qcone.ir.builder import Builder
from qcone.ir.statement import Block, Role, Shape


def subroutine(function: Callable[..., Any]) -> Callable[..., Any]:
    """Make a called routine of an author's function.

    Its arguments and its one result are scalars, vectors, quaternions or matrices. In C it becomes a static
    function called where the author calls it, which keeps repeated work small; the operations are the same
    as if they were written out. A function called with other shapes is another routine.
    """

    def call(*arguments: Quantity) -> Any:
        if not arguments or not all(isinstance(each, Quantity) for each in arguments):
            raise UsageError(f"{function.__name__} takes scalars, vectors, quaternions or matrices only")
        outer = arguments[0].builder
        shapes = [each.shape for each in arguments]
        blocks = [Block(f"arg{i + 1}", shape, Role.INPUT) for i, shape in enumerate(shapes)]
        inner = Builder(_name(function.__name__, shapes, outer), blocks, outer.writing)
        given = [of(inner, block.shape, [inner.read(block, part) for part in range(block.size)]) for block in blocks]
        result = function(*given)
        if not isinstance(result, Quantity):
            raise UsageError(
                f"{function.__name__} returns {type(result).__name__}, not a scalar, vector, quaternion or matrix"
            )
        output = Block("value", result.shape, Role.OUTPUT)
        inner.blocks.append(output)
        for part, value in enumerate(result.values):
            inner.write(output, part, value)
        flat = [value for each in arguments for value in each.values]
        values = outer.call(inner.routine(function.__doc__ or ""), flat)
        return of(outer, result.shape, values)

    call.__name__ = function.__name__
    call.__doc__ = function.__doc__
    return call


def _name(base: str, shapes: list[Shape], outer: Builder) -> str:
    """Return the routine's name: the function's, with its shapes where another set of shapes has taken that."""
    wanted = [Block(f"arg{i + 1}", shape, Role.INPUT) for i, shape in enumerate(shapes)]
    taken = outer.callees.get(base)
    if taken is None or list(taken.having(Role.INPUT)) == wanted:
        return base
    return "_".join([base, *(shape.name.lower() for shape in shapes)])
