"""Operation counts of the emitted text alone: what the C says, without a look at the routine it was printed from."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import fields
from fractions import Fraction

from qcone.backends.counts import Counts, is_power_of_two
from qcone.backends.parse_back import Line, inline_functions, read_functions

COUNTED = {
    "add": "add",
    "subtract": "subtract",
    "multiply": "multiply",
    "divide": "divide",
    "negate": "negate",
    "less": "compare",
    "select": "select",
}
"""What a kind of statement is counted as."""
WRAPPING = {"add": "add", "subtract": "subtract", "negate": "negate", "shift_left": "shift"}
"""What a call of a small function that wraps around is counted as."""


def count_text(header: str, source: str) -> dict[str, Counts]:
    """Return the operations one call of each function of the text executes, by the function's name.

    Loops and calls are multiplied out. Of branches the dearer one counts, kind by kind. Raises
    UnreadableError for text that no printer of ours writes.
    """
    bodies = {name: lines for name, (_, lines) in read_functions(header, inline_functions(source)[1]).items()}
    return {name: Counts(**_lines(lines, bodies, {})) for name, lines in bodies.items()}


def _lines(lines: Sequence[Line], bodies: Mapping[str, Sequence[Line]], counters: Mapping[str, int]) -> Counter[str]:
    found: Counter[str] = Counter()
    for line in lines:
        if line.kind == "loop":
            first, last = (_index(each, counters) for each in line.operands)
            for turn in range(first, last + 1):
                found += _lines(line.body, bodies, {**counters, line.target: turn})
        elif line.kind == "choose":
            branches = [_lines([each], bodies, counters) for each in line.body]
            found += Counter({kind: max(each[kind] for each in branches) for kind in COUNTED.values()})
        elif line.kind == "call" or line.kind in bodies:
            name = line.target if line.kind == "call" else line.kind
            called = Counts(**_lines(bodies[name], bodies, {}))
            found += Counter({each.name: getattr(called, each.name) for each in fields(called)})
        elif line.kind == "multiply" and any(map(_is_integer_power, line.operands)):
            found["shift"] += 1
        elif line.kind == "multiply" and any(map(_is_literal_power, line.operands)):
            found["power_of_two"] += 1
        elif line.kind.startswith(("round_", "floor_", "low_")):
            found["shift"] += 1
        elif line.kind.startswith("left_of_"):
            found["subtract"] += 1
        elif line.kind.startswith("clamp_"):
            found["select"] += 1
        elif line.kind.rpartition("_")[0] in WRAPPING:
            found[WRAPPING[line.kind.rpartition("_")[0]]] += 1
        elif line.kind in COUNTED:
            found[COUNTED[line.kind]] += 1
    return found


def _is_integer_power(operand: str) -> bool:
    """Tell whether an operand is an integer constant 2^k: the product is a left shift, as C99 has it."""
    digits = operand.removeprefix("int64_t ")
    return digits.isdigit() and is_power_of_two(Fraction(int(digits)))


def _is_literal_power(operand: str) -> bool:
    """Tell whether an operand, as it is read back (`float 1/4`, `-double 2`, a name), is a literal 2^k."""
    _, space, value = operand.rpartition(" ")
    return bool(space) and is_power_of_two(Fraction(value))


def _index(text: str, counters: Mapping[str, int]) -> int:
    """Return the value of a canonical index expression, `3 + 2*n`, at the counters."""
    value = 0
    for term in text.split(" + "):
        factor, _, name = term.partition("*")
        value += int(factor) * (counters[name] if name else 1)
    return value
