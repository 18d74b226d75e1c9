"""The state structure in C: its members, how a component is reached, and what a static state begins with."""

from __future__ import annotations

from fractions import Fraction

from qcone.backends import c_fixed
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.statement import Block, Operation, Place, Program, Shape, Write


def field(block: Block, place: Place) -> str:
    """Return a component of a state block as a member: an array element, or the member itself for one scalar."""
    if block.shape is Shape.SCALAR and block.count == 1:
        return block.name
    return f"{block.name}[{place.index}]"


def type_of(block: Block, number: Floating | Fixed) -> str:
    """Return the C type of a block's components."""
    if block.integer:
        return "int32_t"
    return block.format.ctype if block.format else number.ctype


def constant(value: Fraction, block: Block, number: Floating | Fixed) -> str:
    """Return a component's initial value as C has it."""
    if block.integer:
        return str(int(value))
    if block.format:
        return c_fixed.literal(value, block.format)
    assert isinstance(number, Floating)
    return number.literal(value)


def state_fields(program: Program, number: Floating | Fixed) -> list[tuple[str, str]]:
    """Return the members of the state structure as (declaration, meaning)."""
    fields = []
    for block in program.state:
        ctype = type_of(block, number)
        array = "" if block.shape is Shape.SCALAR and block.count == 1 else f"[{block.size}]"
        fields.append((f"{ctype} {block.name}{array};", block.unit))
    return fields


def state_initialiser(program: Program, number: Floating | Fixed) -> str:
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
        texts = [constant(values[k] or Fraction(0), block, number) for k in range(block.size)]
        scalar = block.shape is Shape.SCALAR and block.count == 1
        parts.append(texts[0] if scalar else f"{{ {', '.join(texts)} }}")
    return f"{{ {', '.join(parts)} }}"
