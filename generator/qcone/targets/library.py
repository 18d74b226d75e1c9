"""The compilers' own routines by name: which of them compute floats in software, and what each computes."""

from __future__ import annotations

import re

_DOUBLE = re.compile(r"__aeabi_(?:c?d\w+|f2d|u?[il]l?2d)|__\w*df\w*")
_SINGLE = re.compile(r"__aeabi_(?:c?f\w+|d2f|u?[il]l?2f)|__\w*sf\w*")
_MULTIPLY = re.compile(r"__aeabi_[fd]mul|__mul[sd]f3")
_DIVIDE = re.compile(r"__aeabi_[fd]div|__div[sd]f3")
_ADD = re.compile(r"__aeabi_[fd](?:add|r?sub)|__(?:add|sub)[sd]f3")


def soft_bits(name: str) -> int | None:
    """Return 32 or 64 for a routine that computes or converts floats of so many bits; None for every other."""
    if _DOUBLE.fullmatch(name) or name == "__aeabi_d2f":
        return 64
    return 32 if _SINGLE.fullmatch(name) else None


def multiplies(name: str) -> bool:
    """Tell whether a routine is the product of two floats."""
    return _MULTIPLY.fullmatch(name) is not None


def multiplies_integers(name: str) -> bool:
    """Tell whether a routine is the product of two integers of 64 bits."""
    return name in ("__aeabi_lmul", "__muldi3")


def adds(name: str) -> bool:
    """Tell whether a routine is the sum or difference of two floats."""
    return _ADD.fullmatch(name) is not None


def divides(name: str) -> bool:
    """Tell whether a routine is the quotient of two floats."""
    return _DIVIDE.fullmatch(name) is not None


def public_name(names: tuple[str, ...]) -> str:
    """Return the name of a routine that has several: the one that says what it computes, if any does."""
    plain = [name for name in names if "." not in name]
    usual = [name for name in plain if name.startswith("__aeabi")]
    telling = [name for name in plain if soft_bits(name)]
    return (*usual, *telling, *plain, *names, "?")[0]
