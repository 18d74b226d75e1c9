"""The state structure in C: its members, how a component is reached, and what a static state begins with."""

from __future__ import annotations

from fractions import Fraction

from qcone.formats.floating import Floating
from qcone.ir.statement import Block, Operation, Place, Program, Shape, Write


def field(block: Block, place: Place) -> str:
    """Return a component of a state block as a member: an array element, or the member itself for one scalar."""
    if block.shape is Shape.SCALAR and block.count == 1:
        return block.name
    return f"{block.name}[{place.index}]"


def state_fields(program: Program, number: Floating) -> list[tuple[str, str]]:
    """Return the members of the state structure as (declaration, meaning)."""
    fields = []
    for block in program.state:
        ctype = "int32_t" if block.integer else number.ctype
        array = "" if block.shape is Shape.SCALAR and block.count == 1 else f"[{block.size}]"
        fields.append((f"{ctype} {block.name}{array};", block.unit))
    return fields


def state_initialiser(program: Program, number: Floating) -> str:
    """Return the initialiser of a static state: what `init` writes."""
    init = program.routine("init")
    literals = {each.result: each.constant for each in init.body if isinstance(each, Operation)}
    parts = []
    for block in program.state:
        values = {
            each.place.index.constant: literals[each.value]
            for each in init.body
            if isinstance(each, Write) and each.place.block == block.name
        }
        texts = []
        for k in range(block.size):
            value = values[k] or Fraction(0)
            texts.append(str(int(value)) if block.integer else number.literal(value))
        scalar = block.shape is Shape.SCALAR and block.count == 1
        parts.append(texts[0] if scalar else f"{{ {', '.join(texts)} }}")
    return f"{{ {', '.join(parts)} }}"
