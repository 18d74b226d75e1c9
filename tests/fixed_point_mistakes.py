"""Mistakes of fixed point, made on purpose: a shift that truncates, a format one bit off, a rounding not carried."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from qcone.ir import update
from qcone.ir.detail import Mac, Shift
from qcone.ir.statement import Operation
from qcone.passes import fixed_point, integers


def every_sum(change: Callable[[Operation, Mac, str], Mac], patch: pytest.MonkeyPatch) -> None:
    """Change the sums of products of every routine, as they are lowered: `change` is told the value's name."""
    right = fixed_point.lower_fixed

    def lowered(*given: Any) -> Any:
        routine, residuals = right(*given)
        body = tuple(
            replace(each, detail=change(each, each.detail, routine.names.get(each.result, "")))
            if isinstance(each, Operation) and isinstance(each.detail, Mac)
            else each
            for each in routine.body
        )
        return routine.with_body(body), residuals

    patch.setattr(fixed_point, "lower_fixed", lowered)


def shifts_that_truncate(patch: pytest.MonkeyPatch) -> None:
    every_sum(lambda each, mac, name: replace(mac, rounding="floor"), patch)


def integer_shifts_that_truncate(patch: pytest.MonkeyPatch) -> None:
    """In the integer operations, and so in the C, but not in the sums of products they are made of."""
    right = integers.expand

    def expanded(*given: Any, **named: Any) -> Any:
        routine = right(*given, **named)
        body = tuple(
            replace(each, detail=replace(each.detail, rounding="floor"))
            if isinstance(each, Operation) and isinstance(each.detail, Shift) and each.detail.rounding
            else each
            for each in routine.body
        )
        return routine.with_body(body)

    patch.setattr(integers, "expand", expanded)


def format_one_bit_off(patch: pytest.MonkeyPatch) -> None:
    """A bit too few is dropped of the vector part of r: it is twice as large as its format says."""

    def change(each: Operation, mac: Mac, name: str) -> Mac:
        return replace(mac, discard=mac.discard - 1) if name.startswith(("bent_", "v_")) and mac.discard else mac

    every_sum(change, patch)


def format_one_bit_off_the_other_way(patch: pytest.MonkeyPatch) -> None:
    """A bit too many is dropped of |phi|^2."""

    def change(each: Operation, mac: Mac, name: str) -> Mac:
        return replace(mac, discard=mac.discard + 1) if name == "phi_square" else mac

    every_sum(change, patch)


def rounding_not_carried(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(update, "carried", lambda vector, _: vector)


NOTICED_BY: dict[str, tuple[Callable[[pytest.MonkeyPatch], None], tuple[str, ...]]] = {
    "truncating shift": (shifts_that_truncate, ("fixed point, error",)),
    "truncating shift, of integers alone": (integer_shifts_that_truncate, ("fixed point, levels agree",)),
    "format one bit off, too coarse": (format_one_bit_off, ("fixed point, error", "fixed point, proved ranges")),
    "format one bit off, too fine": (format_one_bit_off_the_other_way, ("fixed point, error",)),
    "rounding not carried": (rounding_not_carried, ("fixed point, error",)),
}
"""Every mutation and the checks that notice it."""
