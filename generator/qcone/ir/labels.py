"""Names and headings: what a quantity is called in C, and the equation that stands above its operations."""

from __future__ import annotations

from qcone.errors import UsageError
from qcone.ir.blocks import Q, Quantity
from qcone.ir.statement import Step


def named(name: str, quantity: Q) -> Q:
    """Name a quantity without a heading of its own; the step that follows covers it."""
    quantity.builder.name_values(name, quantity.shape, quantity.values)
    return quantity


def heading(text: str, equation: str, near: Quantity) -> None:
    """Head the operations written since the last step, naming none of them."""
    near.builder.label(Step(text, equation))


def step(text: str, equation: str, quantity: Q) -> Q:
    """Name a quantity and head the operations that made it.

    `text` is the equation as a line of text, `phi = S + u x k`; what stands before the equals sign becomes
    the name of the quantity in C. `equation` is where the source prints it, "cao (12)". Everything written
    since the last step belongs to this one.
    """
    name = text.partition("=")[0].strip()
    if not name.isidentifier():
        raise UsageError(f"step {text!r}: the text must begin with a name and an equals sign, as in 'phi = ...'")
    quantity.builder.label(Step(text, equation))
    quantity.builder.name_values(name, quantity.shape, quantity.values)
    return quantity
