"""Read emitted C back into machine statements, by pycparser, and compare them with the routine one by one.

That the C is the model rests on this and not only on test vectors: every statement of every function must
be the routine's, operands in order, literals to the last bit, types and all.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from qcone.backends.c_operands import WORDS, CParser, ParseError, UnreadableError, c_ast, expression, operand

OPERATORS = {"+": "add", "-": "subtract", "*": "multiply", "/": "divide", "<": "less"}
TYPES = "typedef short int16_t; typedef int int32_t; typedef long long int64_t;\n"
INLINE = re.compile(r"(?:/\*(?:(?!\*/).)*\*/\n)?static inline .*?\n}\n", re.DOTALL)
"""A small function and the comment above it."""


@dataclass(frozen=True)
class Line:
    """One statement of C: what it is, what it defines or writes, its operands as text, its type."""

    kind: str
    target: str
    operands: tuple[str, ...] = ()
    ctype: str = ""
    body: tuple[Line, ...] = field(default=())

    def __str__(self) -> str:
        """Return the statement on one line, for messages."""
        return f"{self.ctype} {self.target} = {self.kind}({', '.join(self.operands)})".strip()


def read_functions(header: str, source: str) -> dict[str, tuple[str, tuple[Line, ...]]]:
    """Return, for every function of the source, its signature as text and its statements.

    Raises UnreadableError for text that is not C, or that is C no printer of ours writes.
    """
    _refuse_directives(source)
    text = TYPES + _bare(header) + _bare(source)
    try:
        tree = CParser().parse(text)
    except ParseError as error:
        raise UnreadableError(f"not C: {error}") from error
    found = {}
    for node in tree.ext:
        if not isinstance(node, c_ast.FuncDef | c_ast.Typedef) and not isinstance(node.type, c_ast.FuncDecl):
            raise UnreadableError(f"a declaration outside every function: {getattr(node, 'name', None)}")
        if isinstance(node, c_ast.Typedef) and node.name not in WORDS and not node.name.endswith("_state"):
            raise UnreadableError(f"a type that is not emitted: {node.name}")
        if isinstance(node, c_ast.FuncDef):
            try:
                found[node.decl.name] = (_signature(node), tuple(_lines(node.body.block_items or ())))
            except (AttributeError, KeyError, TypeError, ValueError) as error:  # a tree of another shape than ours
                raise UnreadableError(f"{node.decl.name}: a form that is not emitted: {error}") from error
    return found


def inline_functions(source: str) -> tuple[tuple[str, ...], str]:
    """Return the small functions a source begins with, as their texts, and the source without them."""
    return tuple(INLINE.findall(source)), INLINE.sub("", source)


def _refuse_directives(source: str) -> None:
    """Refuse what would change the statements unseen: a macro, or statements under a condition."""
    depth = 0
    for line in re.sub(r"/\*.*?\*/", " ", source, flags=re.DOTALL).splitlines():
        word = line.lstrip().removeprefix("#").split(" ")[0] if line.lstrip().startswith("#") else None
        if word not in (None, "include", "if", "endif", "error", "pragma"):
            raise UnreadableError(f"a directive that is not emitted: {line.strip()}")
        depth += {"if": 1, "endif": -1}.get(word or "", 0)
        if depth and word is None and line.strip():
            raise UnreadableError(f"a statement under a condition: {line.strip()}")


def _bare(text: str) -> str:
    """Leave out comments, directives and what only a C++ compiler sees."""
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    text = re.sub(r"^#ifdef __cplusplus$.*?^#endif$", "", text, flags=re.DOTALL | re.MULTILINE)
    return "".join(line for line in text.splitlines(keepends=True) if not line.lstrip().startswith("#"))


def _signature(node: c_ast.FuncDef) -> str:
    """Return `static void name(parameters)`."""
    arguments = node.decl.type.args
    given = ", ".join(declared(each) for each in (arguments.params if arguments else ()))
    words = [*node.decl.storage, *node.decl.type.type.quals, *node.decl.type.type.type.names]
    return f"{' '.join(words)} {node.decl.name}({given})"


def read_structure(header: str, name: str) -> tuple[str, ...]:
    """Return the members of the structure `name` as declarations, in order.

    Raises UnreadableError where there is none, or the text is not C.
    """
    try:
        tree = CParser().parse(TYPES + _bare(header))
    except ParseError as error:
        raise UnreadableError(f"not C: {error}") from error
    for node in tree.ext:
        if isinstance(node, c_ast.Typedef) and node.name == name:
            members = getattr(getattr(node.type, "type", None), "decls", None) or ()
            return tuple(declared(each) for each in members)
    raise UnreadableError(f"there is no structure {name}")


def read_macros(text: str) -> dict[str, str]:
    """Return the macros of a text by name, their replacement without white space."""
    bare = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    lines = (line.lstrip() for line in bare.splitlines())
    parts = (line[1:].split(None, 2) for line in lines if line.startswith("#"))
    return {part[1]: "".join("".join(part[2:]).split()) for part in parts if part[0] == "define" and len(part) > 1}


def declared(node: Any) -> str:
    """Return a declaration's type, name and size as text."""
    kind, size, pointer = node.type, "", ""
    while not isinstance(kind, c_ast.TypeDecl):
        if isinstance(kind, c_ast.ArrayDecl):
            size += f"[{expression(kind.dim) if kind.dim is not None else ''}]"
        elif isinstance(kind, c_ast.PtrDecl):
            pointer += "*"
        else:
            raise UnreadableError(f"a declaration of {node.name} that is not emitted: {type(kind).__name__}")
        kind = kind.type
    words = [*node.storage, *kind.quals, *getattr(kind.type, "names", ())]
    return f"{' '.join(words)} {pointer}{node.name or ''}{size}".strip()


def _lines(items: Sequence[Any]) -> Iterator[Line]:
    for node in items:
        match node:
            case c_ast.Decl():
                yield _declaration(node)
            case c_ast.Assignment() if node.op == "=":
                yield _written(node)
            case c_ast.FuncCall():
                arguments = tuple(operand(each) for each in node.args.exprs)
                yield Line("call", node.name.name, arguments)
            case c_ast.Cast() if getattr(node.to_type.type.type, "names", None) == ["void"]:
                yield Line("unused", operand(node.expr))
            case c_ast.For():
                yield _loop(node)
            case c_ast.Return():
                yield _returned(node)
            case c_ast.If():
                yield _choice(node)
            case _:
                raise UnreadableError(f"a statement that is not emitted: {type(node).__name__}")


def _declaration(node: Any) -> Line:
    if isinstance(node.type, c_ast.ArrayDecl):
        entries = tuple(operand(each) for each in node.init.exprs) if node.init else ()
        return Line("array", declared(node), entries)
    ctype = declared(node).removesuffix(node.name).strip()
    value = node.init
    if value is None:
        raise UnreadableError(f"a declaration without a value: {node.name}")
    if isinstance(value, c_ast.BinaryOp):
        if value.op not in OPERATORS:
            raise UnreadableError(f"an operator that is not emitted: {value.op}")
        return Line(OPERATORS[value.op], node.name, (operand(value.left), operand(value.right)), ctype)
    if isinstance(value, c_ast.FuncCall) and value.name.name != "INT64_C":
        return Line(value.name.name, node.name, tuple(operand(each) for each in value.args.exprs), ctype)
    if isinstance(value, c_ast.TernaryOp):
        return Line("select", node.name, (_condition(value.cond), operand(value.iftrue), operand(value.iffalse)), ctype)
    if isinstance(value, c_ast.UnaryOp) and value.op == "-" and not isinstance(value.expr, c_ast.Constant):
        return Line("negate", node.name, (operand(value.expr),), ctype)
    return Line("read", node.name, (operand(value),), ctype)


def _returned(node: Any) -> Line:
    """Read `return (counter >= limit) ? 1 : 0;`, or `return name;`."""
    value = node.expr
    if isinstance(value, c_ast.ID):
        return Line("return", "", (operand(value),))
    whole = isinstance(value, c_ast.TernaryOp) and isinstance(value.cond, c_ast.BinaryOp) and value.cond.op == ">="
    if whole and (operand(value.iftrue), operand(value.iffalse)) == ("1", "0"):
        return Line("ready", operand(value.cond.left), (operand(value.cond.right),))
    raise UnreadableError("a return that is not emitted")


def _condition(node: Any) -> str:
    """Read `name != 0`."""
    if isinstance(node, c_ast.BinaryOp) and node.op == "!=" and operand(node.right) == "0":
        return operand(node.left)
    raise UnreadableError("a condition that is not emitted")


def _written(node: Any) -> Line:
    target = operand(node.lvalue)
    if isinstance(node.rvalue, c_ast.BinaryOp):
        if operand(node.rvalue.left) == target and node.rvalue.op == "+" and operand(node.rvalue.right) == "1":
            return Line("advance", target)
        raise UnreadableError(f"a write of more than one value: {target}")
    return Line("write", target, (operand(node.rvalue),))


def _loop(node: Any) -> Line:
    match node.init, node.cond, node.next:
        case c_ast.DeclList(decls=[counter]), c_ast.BinaryOp(op="<="), c_ast.UnaryOp(op="++" | "p++"):
            pass
        case _:
            raise UnreadableError("a loop that is not emitted")
    same = operand(node.cond.left) == operand(node.next.expr) == counter.name
    if not same or declared(counter) != f"int32_t {counter.name}":
        raise UnreadableError(f"a loop over {counter.name} that is not emitted")
    last = expression(node.cond.right)
    body = tuple(_lines(node.stmt.block_items or ()))
    return Line("loop", counter.name, (expression(counter.init), last), "int32_t", body)


def _choice(node: Any) -> Line:
    """Read if (counter < limit) { f(..); } else ... as one line with a call for each case."""
    calls: list[Line] = []
    operands: list[str] = []
    target = operand(node.cond.left)
    while isinstance(node, c_ast.If):
        if node.cond.op != "<" or operand(node.cond.left) != target:
            raise UnreadableError("a condition that is not emitted")
        operands.append(operand(node.cond.right))
        calls.extend(_lines(node.iftrue.block_items))
        node = node.iffalse
    calls.extend(_lines(node.block_items))
    return Line("choose", target, tuple(operands), body=tuple(calls))
