"""Every key by itself: pydantic checks names, types and ranges of one design; the wording is ours."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any

from qcone.design.keys import LICENSE_PATTERN, MOST_FRACTION_BITS, PIN_PATTERN, Key, Kind, tables
from qcone.design.mistakes import missing_key, unknown_key, wrong_choice, wrong_type
from qcone.design.numbers import exact, signed_permutation
from qcone.design.places import Finding, KeyPath, Places, shown

if TYPE_CHECKING:
    from pydantic import BaseModel
    from pydantic_core import ErrorDetails

Table = dict[str, Any]


def check_keys(
    table: Table, parameters: tuple[Key, ...], places: Places, known_elsewhere: frozenset[str]
) -> tuple[Table, list[Finding]]:
    """Check the keys of one design; return the legal ones and a finding for every other or absent one.

    The legal values are exact: numbers are Fractions, axes pairs. `parameters` are the algorithm's keys;
    `known_elsewhere` names those of other algorithms, for the message.
    """
    from pydantic import ValidationError

    model = _model(parameters)
    known = tables(parameters)
    findings: list[Finding] = []
    legal = table
    try:
        values = model.model_validate(legal)
    except ValidationError as error:
        for each in error.errors(include_url=False):
            path = tuple(part for part in each["loc"] if isinstance(part, str))
            findings.append(_finding(each, path, known, places, known_elsewhere))
            legal = _without(legal, path)
        values = model.model_validate(legal)
    doubted = {finding.path for finding in findings}
    for path, key in (((*above, key.name), key) for above, keys in known.items() for key in keys):
        if key.required and not _given(legal, path) and not any(path[: len(bad)] == bad for bad in doubted):
            findings.append(missing_key(path, key, places))
    return _values(values), findings


def _values(model: BaseModel) -> Table:
    """Return the keys given, as they are: pydantic's own dump would turn Fractions into text."""
    values: Table = {}
    for name, info in type(model).model_fields.items():
        if name in model.model_fields_set and info.alias is not None:
            value = getattr(model, name)
            values[info.alias] = _values(value) if hasattr(value, "model_fields_set") else value
    return values


def _given(table: Table, path: KeyPath) -> bool:
    for part in path[:-1]:
        table = table.get(part, {})
    return path[-1] in table


def _without(table: Table, path: KeyPath) -> Table:
    """Return a copy of `table` without the key at `path`, which may be gone already."""
    head, *rest = path
    if rest and head in table:
        return table | {head: _without(table[head], tuple(rest))}
    return {key: value for key, value in table.items() if key != head}


def _finding(
    error: ErrorDetails,
    path: KeyPath,
    known: Mapping[KeyPath, tuple[Key, ...]],
    places: Places,
    known_elsewhere: frozenset[str],
) -> Finding:
    """Say in our words what pydantic found at `path`."""
    value, kind = error["input"], error["type"]
    if kind == "extra_forbidden":
        return unknown_key(path, known, places, known_elsewhere)
    key = next((key for key in known.get(path[:-1], ()) if key.name == path[-1]), None)
    if key is None:  # a table of keys, given as something else
        what = f"{places.word(path)} must be a table, not {shown(value)}"
        return Finding(path, "QC104", what, "", f"write a header [design.NAME.{'.'.join(path)}]")
    if kind == "literal_error":
        return wrong_choice(path, key, value, places)
    if kind == "greater_than_equal":
        return Finding(path, "QC106", f"{places.given(path, value)} is out of range", "it must be 0 or more")
    if kind == "too_short":
        what = f"{places.word(path)} is an empty list"
        return Finding(path, "QC106", what, "", f"write {places.proposal(path, key.example)}")
    if kind.startswith("QC"):
        context = error["ctx"]
        return Finding(path, kind, f"{places.given(path, value)} {context['what']}", context["why"], context["hint"])
    return wrong_type(path, key, value, places)


@cache
def _model(parameters: tuple[Key, ...]) -> type[BaseModel]:
    """Return the pydantic model of a design: every key optional, so that the legal ones can stand alone."""
    from pydantic import ConfigDict, Field, create_model

    config = ConfigDict(extra="forbid", strict=True)

    def build(path: KeyPath) -> type[BaseModel]:
        subtables = [each for each in known if each and each[:-1] == path]
        types: Table = {key.name: _type(key) for key in known[path]}
        types |= {each[-1]: build(each) for each in subtables}
        # Keys are aliases, so that no key can meet a name of pydantic's own.
        fields: Table = {
            f"key_{index}": (type_, Field(default=None, alias=name))
            for index, (name, type_) in enumerate(types.items())
        }
        model: type[BaseModel] = create_model("_".join(("design", *path)), __config__=config, **fields)
        return model

    known = tables(parameters)
    return build(())


def _type(key: Key) -> Any:
    """Return the pydantic type of a key's values."""
    from typing import Annotated, Literal

    from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator

    word: Any = Literal[key.choices] if key.choices else str
    plain = BeforeValidator(_word)
    types: dict[Kind, Any] = {
        "choice": Annotated[word, plain],
        "choices": Annotated[list[Annotated[word, plain]], Field(min_length=1), AfterValidator(_different)],
        "decimal": Annotated[Any, PlainValidator(lambda value: _positive(value, rational=False))],
        "rational": Annotated[Any, PlainValidator(lambda value: _positive(value, rational=True))],
        "vector": Annotated[Any, PlainValidator(_three(_rational))],
        "matrix": Annotated[Any, PlainValidator(_three(_three(_rational)))],
        "count": Annotated[int, Field(ge=0)],
        "flag": bool,
        "pins": Annotated[list[str], Field(min_length=1), AfterValidator(_pins)],
        "axes": Annotated[str, AfterValidator(_axes)],
        "license": Annotated[str, AfterValidator(_license)],
        "text": str,
        "unchecked": Any,
    }
    return types[key.kind]


def _refused(code: str, what: str, why: str = "", hint: str = "") -> Exception:
    from pydantic_core import PydanticCustomError

    return PydanticCustomError(code, "{what}", {"what": what, "why": why, "hint": hint})


def _word(value: object) -> object:
    """Pass words and integers only: to a Literal, true is 1 and so is 1.0."""
    if isinstance(value, str) or type(value) is int:
        return value
    raise _refused("type", "")


def _rational(value: object) -> Fraction:
    try:
        number = exact(value, rational=True)
    except OverflowError:
        raise _refused("QC106", "is out of range", "no such magnitude is meant") from None
    except ZeroDivisionError:
        raise _refused("QC106", "is out of range", "it divides by zero") from None
    if number is None:
        raise _refused("type", "")
    return number


def _positive(value: object, *, rational: bool) -> object:
    if isinstance(value, str) and not rational:
        raise _refused("type", "")
    number = _rational(value)
    if not number > 0:
        raise _refused("QC106", "is out of range", "it must be greater than 0")
    return number


def _three(part: Callable[[object], object]) -> Callable[[object], object]:
    def three(value: object) -> object:
        if not isinstance(value, list | tuple) or len(value) != 3:
            raise _refused("type", "")
        return tuple(part(each) for each in value)

    return three


def _different(values: list[str]) -> tuple[str, ...]:
    twice = sorted({value for value in values if values.count(value) > 1})
    if twice:
        what = f"names {' and '.join(map(shown, twice))} more than once"
        raise _refused("QC112", what, "", "name each once")
    return tuple(values)


def _pins(values: list[str]) -> tuple[tuple[str, int], ...]:
    found: dict[str, int] = {}
    for value in values:
        if not re.fullmatch(PIN_PATTERN, value):
            raise _refused("QC105", "is not allowed", f"{shown(value)} is no pin", 'write for example ["phi_x = 29"]')
        name, _, bits = (part.strip() for part in value.partition("="))
        if int(bits) > MOST_FRACTION_BITS:
            why = f"{shown(name)} may have {MOST_FRACTION_BITS} fraction bits at most"
            raise _refused("QC106", "is out of range", why, "pin fewer")
        if name in found:
            raise _refused("QC112", f"pins {shown(name)} more than once", "", "pin each value once")
        found[name] = int(bits)
    return tuple(sorted(found.items()))


def _axes(value: str) -> object:
    axes = signed_permutation(value)
    if axes is None:
        why = "each of x, y and z must stand once, with or without a minus sign"
        raise _refused("QC108", "is not a signed permutation", why, 'write for example "y,-x,z"')
    return axes


def _license(value: str) -> str:
    if not re.fullmatch(LICENSE_PATTERN, value):
        raise _refused("QC113", "is not an SPDX identifier", "", 'write for example "MIT-0" or "Apache-2.0"')
    return value
