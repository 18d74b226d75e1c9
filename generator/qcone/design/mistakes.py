"""The words of the mistakes that a single key can hold."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches

from qcone.design.keys import Key
from qcone.design.numbers import is_decimal
from qcone.design.places import Finding, KeyPath, Places, described, shown


def did_you_mean(word: str, known: Sequence[str]) -> str:
    """Return the known word nearest to `word`, or an empty text when none is near."""
    return next(iter(get_close_matches(word.lower(), known, n=1, cutoff=0.6)), "")


def unknown_key(
    path: KeyPath, known: Mapping[KeyPath, tuple[Key, ...]], places: Places, known_elsewhere: frozenset[str]
) -> Finding:
    """Return the finding for a key that its table does not have: where it belongs, or which is near."""
    *above, name = path
    table = tuple(above)
    here = [key.name for key in known[table]] + [each[-1] for each in known if each and each[:-1] == table]
    what, why = f"unknown key {places.word(path)}", ""
    homes = [(other, key) for other, keys in known.items() for key in keys if key.name == name]
    near = did_you_mean(name, here)
    if homes:
        home, key = homes[0]
        hint = f"it belongs elsewhere: write {places.proposal((*home, name), key.example)}"
    elif not table and name in known_elsewhere:
        why, hint = "this algorithm has no such parameter", "leave it out or choose another algorithm"
    elif near:
        hint = f"did you mean {places.word((*table, near))}?"
    else:
        hint = f"the keys here are {', '.join(here)}"
    return Finding(path, "QC102", what, why, hint)


def missing_key(path: KeyPath, key: Key, places: Places) -> Finding:
    """Return the finding for a required key that is absent."""
    what = f"{places.word(path)} is missing"
    hint = f"add {places.proposal(path, key.example)}"
    return Finding(path, "QC103", what, f"it has no default ({key.help})", hint)


def wrong_choice(path: KeyPath, key: Key, value: object, places: Places) -> Finding:
    """Return the finding for a value that is not among the choices, by its type or by its value."""
    if type(value) not in {type(choice) for choice in key.choices}:
        return wrong_type(path, key, value, places)
    words = [each for each in key.choices if isinstance(each, str)]
    near = did_you_mean(value, words) if isinstance(value, str) else ""
    same = next((choice for choice in key.choices if str(choice) == value), None)
    hint = f"did you mean {shown(near)}?" if near else ""
    if same is not None:
        hint = f"write {shown(same)} without quotes"
    what = f"{places.given(path, value)} is not allowed"
    return Finding(path, "QC105", what, f"the choice is {listed(key.choices)}", hint)


def wrong_type(path: KeyPath, key: Key, value: object, places: Places) -> Finding:
    """Return the finding for a value that is not the kind of thing its key takes."""
    what = f"{places.word(path)} must be {_kind(key)}, not {described(value)}"
    hint = f"write for example {places.proposal(path, key.example)}"
    unquoted = key.kind in ("decimal", "count") or (key.kind == "choice" and isinstance(key.choices[0], int))
    if isinstance(value, str) and unquoted and is_decimal(value):
        hint = "leave out the quotes"
    elif key.kind == "choices" and value in key.choices:
        hint = f"write {places.proposal(path, f'[{shown(value)}]')}"
    return Finding(path, "QC104", what, "", hint)


def listed(choices: Sequence[int | str]) -> str:
    """Return choices in words: 1 to 6; or "zyx" or "zxy"; or 1 to 4 or "closed"."""
    numbers = [choice for choice in choices if isinstance(choice, int)]
    words = [shown(choice) for choice in choices if isinstance(choice, str)]
    if len(numbers) > 2 and numbers == list(range(numbers[0], numbers[-1] + 1)):
        words = [f"{numbers[0]} to {numbers[-1]}", *words]
    else:
        words = [*(str(number) for number in numbers), *words]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} or {words[-1]}"


def _kind(key: Key) -> str:
    """Return what a key takes, in words."""
    kinds = {
        "choices": "a list of strings",
        "pins": "a list of strings",
        "decimal": "a number",
        "rational": 'a number or a string "p/q"',
        "vector": "a list of three numbers",
        "matrix": "a list of three rows of three numbers",
        "count": "a whole number",
        "flag": "true or false",
    }
    if key.kind == "choice":
        types = {type(choice) for choice in key.choices}
        return " or ".join(["a whole number"] * (int in types) + ["a string"] * (str in types))
    return kinds.get(key.kind, "a string")
