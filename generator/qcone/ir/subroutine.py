"""Subroutines: a function of vectors and quaternions that is written once and called: a static function in C."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from qcone.errors import UsageError
from qcone.ir.blocks import Quantity, of, together
from qcone.ir.builder import Builder
from qcone.ir.identifier import is_identifier
from qcone.ir.statement import Block, Role, Routine


def subroutine(function: Callable[..., Any]) -> Callable[..., Any]:
    """Make a called routine of an author's function.

    Its arguments and its one result are scalars, vectors, quaternions or matrices. In C it becomes a static
    function called where the author calls it, which keeps repeated work small; the operations are the same
    as if they were written out. A function called with other shapes, or another function of the same name,
    is another routine. Raises UsageError for a name that C cannot hold and, when it is called, for anything
    that is handed in, used or returned and is not a quantity of the routine.
    """
    name = function.__name__
    if not is_identifier(name):
        raise UsageError(f"the subroutine '{name}' cannot be called so in C: make it a function with a plain name")

    def call(*arguments: Quantity) -> Any:
        if not arguments or not all(isinstance(each, Quantity) for each in arguments):
            raise UsageError(f"{name} takes scalars, vectors, quaternions or matrices only")
        outer = together(*arguments)
        blocks = [Block(f"arg{i + 1}", each.shape, Role.INPUT) for i, each in enumerate(arguments)]
        inner = Builder(name, blocks, outer.writing)
        inner.subroutines = outer.subroutines
        given = [of(inner, block.shape, [inner.read(block, part) for part in range(block.size)]) for block in blocks]
        result = function(*given)
        inner.refuse_open_loop()
        if not isinstance(result, Quantity):
            raise UsageError(f"{name} returns {type(result).__name__}, not a scalar, vector, quaternion or matrix")
        together(given[0], result)
        output = Block("value", result.shape, Role.OUTPUT)
        inner.blocks.append(output)
        for part, value in enumerate(result.values):
            inner.write(output, part, value)
        made = _under_its_own_name(inner.routine(function.__doc__ or ""), outer)
        values = outer.call(made, [value for each in arguments for value in each.values])
        return of(outer, result.shape, values)

    call.__name__ = name
    call.__doc__ = function.__doc__
    return call


def _under_its_own_name(made: Routine, outer: Builder) -> Routine:
    """Return the routine, numbered where another one has taken the function's name."""
    name, number = made.name, 1
    while True:
        wanted = replace(made, name=name)
        if outer.subroutines.setdefault(name, wanted) == wanted:
            return wanted
        number += 1
        name = f"{made.name}_{number}"
