"""The JSON schema of design files, for editors: completion and the mistakes of single keys.

Draft 4, the level that TOML editors support best, written out in full without references. It is looser than
reading a file: which parameters and values go with which algorithm, and rules between keys, are left to that.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from qcone.design.catalogue import AlgorithmEntry
from qcone.design.keys import (
    LICENSE_PATTERN,
    NAME_PATTERN,
    PIN_PATTERN,
    USER_ALGORITHM_PATTERN,
    Key,
    parameter_key,
    tables,
)
from qcone.design.places import KeyPath

_RATIONAL = {"anyOf": [{"type": "number"}, {"type": "string", "pattern": "^[-+0-9.eE /]+$"}]}
_VECTOR = {"type": "array", "items": _RATIONAL, "minItems": 3, "maxItems": 3}
_POSITIVE = {"type": "number", "minimum": 0, "exclusiveMinimum": True}
_AXIS = " *-?[xyz] *"


def json_schema(catalogue: Sequence[AlgorithmEntry]) -> dict[str, Any]:
    """Return the schema of a file of designs whose algorithms are those of `catalogue`."""
    known = tables(_merged(catalogue))
    ids = [entry.id for entry in catalogue]

    def table(path: KeyPath) -> dict[str, Any]:
        keys = known[path]
        below = [each for each in known if each and each[:-1] == path]
        properties = {key.name: _property(key, ids) for key in keys} | {each[-1]: table(each) for each in below}
        required = [key.name for key in keys if key.required]
        required += [each[-1] for each in below if any(key.required for key in known[each])]
        needs = {"required": required} if required else {}
        return {"type": "object", "properties": properties, "additionalProperties": False, **needs}

    designs = {
        "type": "object",
        "patternProperties": {NAME_PATTERN: table(())},
        "additionalProperties": False,
        "minProperties": 1,
    }
    return {
        "$schema": "http://json-schema.org/draft-04/schema#",
        "title": "qcone design file",
        "type": "object",
        "properties": {"design": designs},
        "additionalProperties": False,
        "required": ["design"],
    }


def _merged(catalogue: Sequence[AlgorithmEntry]) -> tuple[Key, ...]:
    """Return every algorithm's parameters as keys; those of one name share the union of their choices."""
    merged: dict[str, Key] = {}
    for parameter in (each for entry in catalogue for each in entry.parameters):
        key = parameter_key(parameter)
        if other := merged.get(key.name):
            choices = tuple(dict.fromkeys((*other.choices, *key.choices)))
            same = other.default if other.default == key.default else None
            key = Key(key.name, "choice", other.help, other.example, choices, same)
        merged[key.name] = key
    return tuple(merged.values())


def _property(key: Key, algorithms: Sequence[str]) -> dict[str, Any]:
    word: dict[str, Any] = {"enum": list(key.choices)}
    kinds: dict[str, dict[str, Any]] = {
        "choice": word,
        "choices": {"type": "array", "items": word, "minItems": 1, "uniqueItems": True},
        "decimal": _POSITIVE,
        "rational": {"anyOf": [_POSITIVE, _RATIONAL["anyOf"][1]]},
        "vector": _VECTOR,
        "matrix": {"type": "array", "items": _VECTOR, "minItems": 3, "maxItems": 3},
        "count": {"type": "integer", "minimum": 0},
        "flag": {"type": "boolean"},
        "pins": {"type": "array", "items": {"type": "string", "pattern": PIN_PATTERN}, "minItems": 1},
        "axes": {"type": "string", "pattern": f"^{_AXIS},{_AXIS},{_AXIS}$"},
        "license": {"type": "string", "pattern": LICENSE_PATTERN},
        "text": {"anyOf": [{"enum": list(algorithms)}, {"type": "string", "pattern": USER_ALGORITHM_PATTERN}]},
    }
    default = "x,y,z" if key.kind == "axes" else key.default
    if isinstance(default, Fraction):
        default = default.numerator if default.denominator == 1 else float(default)
    told = {} if default is None else {"default": list(default) if isinstance(default, tuple) else default}
    return {"description": key.help, **kinds[key.kind], **told}
