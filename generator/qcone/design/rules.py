"""The rules between keys: what one of them means for another."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from qcone.design.keys import FIXED_FORMATS, Key
from qcone.design.places import Finding, KeyPath, Places

_HALF_TURN_DEG = 180
_LARGEST_CORRECTION_ARCSEC = 36000
_CONFLICT = "QC107"


def check_rules(given: dict[str, Any], refused: frozenset[KeyPath], places: Places) -> Iterator[Finding]:
    """Yield a finding for every rule broken by the keys given, which are each legal by themselves.

    Keys that were `refused` are absent from `given`, and rules about them are silent.
    """
    imu, number = given.get("imu", {}), given.get("number", {})
    yield from _fixed_only(number, places)
    yield from _as_written(given, number, places)
    yield from _counts_only(given, imu, refused, places)
    yield from _half_turn(imu, places)
    yield from _small_correction(given.get("rins", {}), places)


def decorated(given: dict[str, Any], parameters: tuple[Key, ...], places: Places) -> Iterator[Finding]:
    """Yield a finding for every algorithm parameter given beside a user's own function."""
    for key in parameters:
        if key.name in given:
            what = f"{places.word((key.name,))} does not go with `{given['algorithm']}`"
            why = "the function's own decorator says it"
            yield Finding((key.name,), _CONFLICT, what, why, "leave it out")


def _fixed_only(number: dict[str, Any], places: Places) -> Iterator[Finding]:
    format_ = number.get("format")
    if format_ is None or format_ in FIXED_FORMATS:
        return
    for name in ("overflow", "rounding", "clamp_inputs", "pins"):
        if name in number:
            path = ("number", name)
            what = f"{places.word(path)} does not go with {places.given(('number', 'format'), format_)}"
            yield Finding(path, _CONFLICT, what, "only fixed formats have it", "leave it out")


def _as_written(given: dict[str, Any], number: dict[str, Any], places: Places) -> Iterator[Finding]:
    if given.get("form") != "as-written":
        return
    own: list[tuple[KeyPath, dict[str, Any]]] = [
        (("number", "accumulate"), number),
        (("renormalise",), given),
        (("exponential",), given),
    ]
    for path, table in own:
        if path[-1] in table:
            what = f"{places.word(path)} does not go with {places.given(('form',), 'as-written')}"
            yield Finding(path, _CONFLICT, what, "the paper's form has its own", "leave it out")


def _counts_only(
    given: dict[str, Any], imu: dict[str, Any], refused: frozenset[KeyPath], places: Places
) -> Iterator[Finding]:
    quantum = ("imu", "quantum_dps")
    counts = places.given(("input",), "counts")
    if refused & {("input",), ("imu",), quantum}:
        return
    if given.get("input") != "counts":
        for name in ("quantum_dps", "bias_dps", "calibration"):
            if name in imu:
                path = ("imu", name)
                what = f"{places.word(path)} needs {counts}"
                yield Finding(path, _CONFLICT, what, "other inputs have units already", "leave it out")
    elif "quantum_dps" not in imu:
        what, proposal = f"{counts} needs {places.word(quantum)}", places.proposal(quantum, '"2000/32768"')
        yield Finding(("input",), _CONFLICT, what, "a count has no unit", f"add {proposal}")


def _half_turn(imu: dict[str, Any], places: Places) -> Iterator[Finding]:
    if "update_hz" not in imu or "max_rate_dps" not in imu:
        return
    path, rate = ("imu", "max_rate_dps"), imu["max_rate_dps"]
    angle: Fraction = rate / imu["update_hz"]
    if angle > _HALF_TURN_DEG:
        needed = -(-rate // _HALF_TURN_DEG)
        what = f"{places.given(path, _decimal(rate))} turns {float(angle):.6g} deg in one update"
        why = "more than half a turn cannot be told from less"
        yield Finding(path, _CONFLICT, what, why, f"raise {places.word(('imu', 'update_hz'))} to {needed} or more")


def _small_correction(rins: dict[str, Any], places: Places) -> Iterator[Finding]:
    path, largest = ("rins", "max_correction_arcsec"), rins.get("max_correction_arcsec", 0)
    if largest > _LARGEST_CORRECTION_ARCSEC:
        what = f"{places.given(path, _decimal(largest))} is out of range"
        why = "more than 10 deg is a mounting, not the error of an encoder or a bearing"
        yield Finding(path, "QC106", what, why, f"give {_LARGEST_CORRECTION_ARCSEC} or less")


def _decimal(value: Fraction) -> object:
    return value.numerator if value.denominator == 1 else float(value)
