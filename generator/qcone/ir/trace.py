"""Trace: run an author's function once and keep what it wrote down.

Names come from the author: a quantity that no `step` named takes the name of the local variable that held
it, and the author's own source line stands as the heading over its operations. What the author got wrong
is said with the file and the line.
"""

from __future__ import annotations

import ast
import inspect
import linecache
import sys
import textwrap
from collections.abc import Callable, Mapping
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

from qcone.errors import QconeError, UsageError
from qcone.ir.blocks import Quantity, Quaternion
from qcone.ir.builder import Builder
from qcone.ir.frame import RowUpdate
from qcone.ir.labels import step
from qcone.ir.specification import Author
from qcone.ir.statement import Step
from qcone.ir.update import Increment, Rotation, Update


def heading(function: Callable[..., Any]) -> Callable[[], Step | None]:
    """Return a function that tells which statement of `function` is running, as a step."""
    code, lines = function.__code__, _statement_lines(function)

    def current() -> Step | None:
        frame: FrameType | None = sys._getframe(1)
        while frame is not None and frame.f_code is not code:
            frame = frame.f_back
        text = lines.get(frame.f_lineno) if frame is not None else None
        return Step(text) if text else None

    return current


def attitude(
    name: str, function: Author, builder: Builder, arguments: Mapping[str, Any]
) -> tuple[Quantity, Mapping[str, tuple[Quantity, ...]]]:
    """Run an author's function on the blocks it names; return the new attitude, written out, and what is to be kept.

    Raises UsageError, with file and line, for a name that is not defined, an argument that is not a block, a
    result that is not an attitude, or any other mistake of the author's.
    """
    wanted = list(inspect.signature(function).parameters)
    unknown = [each for each in wanted if each not in arguments]
    if unknown:
        known = ", ".join(arguments)
        raise UsageError(f"{_place(function)}: '{unknown[0]}' is not a block of this algorithm; there are: {known}")
    names: dict[str, Any] = {}
    try:
        result = _run(function, {each: arguments[each] for each in wanted}, names)
        builder.refuse_open_loop()
    except QconeError as error:
        raise type(error)(f"{_place(function, error)}: algorithm '{name}': {error}") from error
    except (
        Exception,
        SystemExit,
    ) as error:  # the author's code may fail in any way; it is shown as the author's mistake
        what = f"{type(error).__name__}: {error}"
        raise UsageError(f"{_place(function, error)}: algorithm '{name}': {what}") from error
    for local, value in names.items():
        if isinstance(value, Quantity):
            builder.name_values(local, value.shape, value.values)
    kept: Mapping[str, tuple[Quantity, ...]] = {}
    if isinstance(result, tuple) and len(result) == 2 and isinstance(result[1], Mapping):
        result, kept = result
    return _finish(result, name, function, builder), kept


def _finish(result: Any, name: str, function: Author, builder: Builder) -> Quantity:
    if isinstance(result, Update | Increment | RowUpdate):
        return result.finish()
    if isinstance(result, Quaternion) and builder.is_state(result.values):
        return result
    if isinstance(result, Quaternion):
        if not builder.writing.as_written and builder.writing.accumulate != "standard":
            raise UsageError(
                f"{_place(function)}: algorithm '{name}' returns q (x) r as a plain product, from which "
                "no increment is held apart: return q * rotation(u, v) with r = [1 + u, v], or set "
                'accumulate = "standard"'
            )
        builder.settle(but_last=True)
        return step("q_next = q (x) r", "", result)
    held = builder.blocks[0]
    if isinstance(result, Quantity) and held.shape is result.shape:
        builder.label(Step(f"{held.name}_next = the new attitude"))
        builder.name_values(f"{held.name}_next", result.shape, result.values)
        return result
    given = type(result).__name__ if not isinstance(result, Rotation) else "a rotation"
    raise UsageError(
        f"{_place(function)}: algorithm '{name}' returns {given}, not the new attitude: "
        "return a quaternion, as in `return q * exp(phi)`"
    )


def _run(function: Callable[..., Any], arguments: Mapping[str, Any], names: dict[str, Any]) -> Any:
    """Call the function and keep its local variables as they stand when it returns."""
    code = function.__code__

    def watch(frame: FrameType, event: str, _: Any) -> None:
        if event == "return" and frame.f_code is code:
            names.update({name: value for name, value in frame.f_locals.items() if name not in arguments})

    before = sys.getprofile()
    sys.setprofile(watch)
    try:
        return function(**arguments)
    finally:
        sys.setprofile(before)


def _statement_lines(function: Callable[..., Any]) -> dict[int, str]:
    """Return, for every line of the function, the statement it belongs to, on one line."""
    first = function.__code__.co_firstlineno
    try:
        source = textwrap.dedent(inspect.getsource(function))
    except (OSError, TypeError):
        return {}
    lines: dict[int, str] = {}
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Assign | ast.AugAssign | ast.AnnAssign | ast.Return | ast.Expr):
            text = " ".join(" ".join(source.splitlines()[node.lineno - 1 : node.end_lineno]).split())
            for line in range(node.lineno, (node.end_lineno or node.lineno) + 1):
                lines[first + line - 1] = text
    return lines


def _place(function: Callable[..., Any], error: BaseException | None = None) -> str:
    """Return `file:line` inside the author's function: of the error, else of the function itself."""
    code: CodeType = function.__code__
    line = code.co_firstlineno
    trace = error.__traceback__ if error else None
    while trace is not None:
        if trace.tb_frame.f_code is code:
            line = trace.tb_lineno
        trace = trace.tb_next
    linecache.checkcache(code.co_filename)
    return f"{Path(code.co_filename).name}:{line}"
