"""Reconciliation: how the products and sums that a machine executes are those that the C spells out."""

from __future__ import annotations

from dataclasses import dataclass

from qcone.backends.counts import Counts, Products
from qcone.targets.traces import Executed


@dataclass(frozen=True)
class Reconciliation:
    """What one update emits and executes; `text` says how they agree, or do not."""

    holds: bool
    text: str


def reconcile_words(emitted: Products, found: Executed, separate_halves: bool) -> Reconciliation:
    """Say how the integer products executed are those emitted.

    A compiler may make a product by a constant of shifts and sums. With `separate_halves` the lower half of a product
    of two words is an instruction of its own, left out where nothing needs it.
    """
    written = [
        f"{number} products of {bits} bits" for number, bits in ((emitted.whole, 64), (emitted.lower, 32)) if number
    ]
    said = f"{' and '.join(written) or 'no products'} emitted"
    (whole, most), (lower, largest) = found.whole, found.lower
    if whole != most or lower != largest:
        return Reconciliation(False, f"{said}; executed {whole} to {most} and {lower} to {largest}, as data decides")
    done = f"{whole} and {lower} executed" if lower or not whole else f"{whole} executed"
    halves = min(whole, max(0, lower - emitted.lower)) if separate_halves else 0
    missing = emitted.whole - whole, emitted.lower - (lower - halves)
    if min(missing) < 0 or sum(missing) > emitted.constant:
        return Reconciliation(False, f"{said}, but {done}: the compiler makes products in ways of its own")
    reasons = [f"{halves} are lower halves"] * bool(halves)
    reasons += [f"{sum(missing)} by constants became shifts and sums"] * bool(sum(missing))
    return Reconciliation(True, f"{said}, {done}{': ' if reasons else ''}{', '.join(reasons)}")


def reconcile(emitted: Counts, found: Executed) -> Reconciliation:
    """Say how the float products and sums executed are those emitted.

    A compiler may make a sum x + x of a product by 2, and no other exchange keeps the bits; anything else is a
    mismatch.
    """
    products, sums = emitted.multiply + emitted.power_of_two, emitted.add + emitted.subtract
    (least, most), (fewest, largest) = found.multiply, found.add
    said = f"{products} products and {sums} sums emitted"
    if emitted.select and (least, most) == (products, products) and fewest < sums and largest <= sums:
        reason = "a sum that one arm of a select alone needs is made there"
        return Reconciliation(True, f"{said}, {most} and {fewest} to {largest} executed: {reason}")
    if least != most or fewest != largest:
        return Reconciliation(False, f"{said}; executed {least} to {most} and {fewest} to {largest}, as data decides")
    doubled = products - most
    if (doubled, largest) == (0, sums):
        return Reconciliation(True, f"{said}, {most} and {largest} executed")
    if 0 < doubled <= emitted.power_of_two and largest == sums + doubled:
        return Reconciliation(True, f"{said}, {most} and {largest} executed: {doubled} by 2 became x + x")
    return Reconciliation(False, f"{said}, but {most} and {largest} executed: the compiler changed the arithmetic")
