"""Operands of emitted C, read back: names, components under affine indices, literals as exact values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from pycparser import CParser, c_ast
from pycparser.c_parser import ParseError

from qcone.formats.floating import FLOATING

__all__ = ["WORDS", "CParser", "ParseError", "UnreadableError", "affine", "c_ast", "expression", "operand"]

WORDS = ("int16_t", "int32_t", "int64_t")
NUMBERS = {each.ctype: each for each in FLOATING.values()}


class UnreadableError(Exception):
    """The text holds something that no emitted routine contains."""


def operand(node: Any) -> str:
    """Return an operand: a name, a component, or a literal as its C type and exact value."""
    match node:
        case c_ast.ID():
            return str(node.name)
        case c_ast.Constant():
            return _literal(node)
        case c_ast.UnaryOp() if node.op == "-" and isinstance(node.expr, c_ast.Constant):
            return "-" + _literal(node.expr)
        case c_ast.ArrayRef():
            return f"{operand(node.name)}[{expression(node.subscript)}]"
        case c_ast.Cast() if getattr(node.to_type.type.type, "names", [""])[0] in WORDS:
            return f"({node.to_type.type.type.names[0]}){operand(node.expr)}"
        case c_ast.FuncCall() if node.name.name == "INT64_C":
            return f"int64_t {_whole(node.args.exprs)}"
        case c_ast.StructRef() if node.type == "->":
            return f"{operand(node.name)}->{node.field.name}"
    raise UnreadableError(f"an operand that is not emitted: {type(node).__name__}")


def _whole(arguments: Sequence[Any]) -> int:
    """Return the number inside INT64_C(..)."""
    (node,) = arguments
    if isinstance(node, c_ast.UnaryOp) and node.op == "-":
        return -int(node.expr.value)
    return int(node.value)


def _literal(node: Any) -> str:
    text = str(node.value)
    if node.type == "int":
        return text
    number = NUMBERS.get(node.type)
    if number is None:
        raise UnreadableError(f"a literal of type {node.type}: {text}")
    return f"{node.type} {number.round(Fraction(text.rstrip('fF')))}"


def expression(node: Any) -> str:
    """Return an index expression, canonical: constants and sums of multiples of counters."""
    terms: dict[str, int] = {}
    _collect(node, 1, terms)
    return affine(terms)


def affine(terms: Mapping[str, int]) -> str:
    """Return `{'n': 3, '': -1}` as a canonical text, the constant under the empty name."""
    return (
        " + ".join(f"{factor}*{name}" if name else str(factor) for name, factor in sorted(terms.items()) if factor)
        or "0"
    )


def _collect(node: Any, factor: int, terms: dict[str, int]) -> None:
    match node:
        case c_ast.Constant() if node.type == "int":
            terms[""] = terms.get("", 0) + factor * int(node.value)
        case c_ast.ID():
            terms[node.name] = terms.get(node.name, 0) + factor
        case c_ast.UnaryOp() if node.op == "-":
            _collect(node.expr, -factor, terms)
        case c_ast.BinaryOp() if node.op in "+-":
            _collect(node.left, factor, terms)
            _collect(node.right, factor if node.op == "+" else -factor, terms)
        case c_ast.BinaryOp() if node.op == "*":
            scale: dict[str, int] = {}
            _collect(node.left, factor, scale)
            if set(scale) - {""}:
                raise UnreadableError("an index that is not affine")
            _collect(node.right, scale.get("", 0), terms)
        case _:
            raise UnreadableError(f"an index that is not emitted: {type(node).__name__}")
