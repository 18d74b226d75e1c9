"""Records: how vectors written component by component arose, so that their lengths are bounded as vectors are.

A recurrence over components writes scalars; that together they are 1/n sum a x b is not to be seen in them. A record
says so and writes nothing. Rolled into loops, where components have no names, there is nothing to record.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from qcone.ir.blocks import Quantity


def recorded_products(result: Quantity, pairs: Sequence[tuple[Quantity, Quantity]], factor: Fraction | int) -> None:
    """Record that `result` is factor times a sum of products: |result| <= factor sum |a| |b|.

    A product is that of two quaternions, or a cross product.
    """
    if all(isinstance(each.values, tuple) for each in (result, *(each for pair in pairs for each in pair))):
        operands = [each.group for pair in pairs for each in pair]
        result.builder.group("products", result.values, operands, Fraction(factor))


def recorded_square(result: Quantity, of: Quantity) -> None:
    """Record that the scalar `result` is |of|^2."""
    result.builder.group("dot", result.values, (of.group, of.group))


def recorded_sum(result: Quantity, parts: Sequence[Quantity]) -> None:
    """Record that `result` is the sum of `parts`: |result| <= sum |part|."""
    result.builder.group("sums", result.values, [each.group for each in parts], Fraction(1))
