"""Small C functions that integer operations are made of: rounding shifts, clamps, words that wrap around.

Everything is defined by C99 alone: a negative value is never shifted left, a right shift of one is written so that
its result does not depend on the implementation, and what is narrowed is known to fit. Shifting the unsigned image
and narrowing it takes the fewest instructions; it holds for up to as many bits as are dropped with the upper word.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from qcone.backends.c_fixed import WRAPPING, clamp_name, integer, low_name, narrow_name, remainder_name, shift_name
from qcone.formats.fixed import Fixed, Signal
from qcone.ir.detail import Shift
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Call, Operation, Program, reachable, walk


@dataclass(frozen=True)
class Furniture:
    """A small function that statements call: its name and its whole text."""

    name: str
    text: str


def furniture(program: Program, number: Fixed) -> tuple[Furniture, ...]:
    """Return the small functions a program calls, each after those it calls itself."""
    made: dict[str, Furniture] = {}
    wraps = number.overflow == "wrap"
    routines = (each for routine in program.routines for each in (*reachable(routine), routine))
    for routine in routines:
        widths: dict[int, int] = {}
        for statement in walk(routine.body):
            if isinstance(statement, Call):
                widths.update(dict.fromkeys(statement.results, number.width))
            if not isinstance(statement, Operation):
                continue
            if isinstance(statement.format, Signal):
                widths[statement.result] = statement.format.width
            for each in _needed(statement, widths, wraps):
                made.setdefault(each.name, each)
    first = ("wrapped", "shift_right")
    return tuple(sorted(made.values(), key=lambda each: (not each.name.startswith(first), *_order(each.name))))


def _order(name: str) -> tuple[str, int]:
    word, _, number = name.rpartition("_")
    return {"wrapped": "", "shift_right": " "}.get(word, word), int(number)


def _remainder(operation: Operation, widths: dict[int, int]) -> Furniture:
    """Return the difference modulo the result's word, which it fits: so the lower words are enough."""
    assert isinstance(operation.format, Signal)
    assert isinstance(operation.detail, Shift)
    whole, rounded = (widths[arg] for arg in operation.args)
    name, result = remainder_name(operation, whole), operation.format.width
    # Below 32 bits C promotes to int, in which a shift of an unsigned word may overflow.
    unsigned = f"uint{max(result, 32)}_t"
    value = f"wrapped_{result}(left)" if result >= 32 else f"wrapped_{result}((uint{result}_t)left)"
    return Furniture(
        name,
        f"/* whole - 2^{operation.detail.bits} rounded; the result fits {result} bits. */\n"
        f"static inline int{result}_t {name}(int{whole}_t whole, int{rounded}_t rounded)\n"
        "{\n"
        f"    const {unsigned} left = ({unsigned})whole - (({unsigned})rounded << {operation.detail.bits});\n"
        f"    return {value};\n"
        "}\n",
    )


def _narrowing(operation: Operation, width: int) -> Furniture:
    assert isinstance(operation.format, Signal)
    name, result = narrow_name(operation, width), operation.format.width
    return Furniture(
        name,
        f"/* x, modulo 2^{result}. */\n"
        f"static inline int{result}_t {name}(int{width}_t x)\n"
        "{\n"
        f"    return wrapped_{result}((uint{result}_t)x);\n"
        "}\n",
    )


def _needed(operation: Operation, widths: dict[int, int], wraps: bool) -> Iterable[Furniture]:
    if wraps and operation.op in WRAPPING and isinstance(operation.format, Signal):
        yield _wrapped(operation.format.width)
        yield _wrapping(operation)
    if wraps and operation.op is MachineOp.NARROW and isinstance(operation.format, Signal):
        yield _wrapped(operation.format.width)
        yield _narrowing(operation, widths[operation.args[0]])
    if operation.op is MachineOp.REMAINDER and isinstance(operation.format, Signal):
        yield _wrapped(operation.format.width)
        yield _remainder(operation, widths)
    if operation.op is MachineOp.LOW:
        yield _wrapped(32)
        yield _shift_right(32)
        yield Furniture(low_name(operation), _low(operation))
    if operation.op is MachineOp.SHIFT_RIGHT:
        width = widths[operation.args[0]]
        assert isinstance(operation.format, Signal)
        assert isinstance(operation.detail, Shift)
        if not _by_image(operation, width):
            yield _shift_right(width)
            if wraps:
                yield _wrapped(width)
                yield _wrapped(operation.format.width)
        yield Furniture(shift_name(operation, width), _rounding(operation, width, wraps))
    elif operation.op is MachineOp.CLAMP:
        width = widths[operation.args[0]]
        yield Furniture(clamp_name(operation, width), _clamp(operation, width))


def _by_image(operation: Operation, width: int) -> bool:
    """Tell whether the unsigned image may be shifted: the bits that come in from above are dropped again."""
    assert isinstance(operation.format, Signal)
    assert isinstance(operation.detail, Shift)
    fits = width == 64 and operation.format.width == 32 and operation.detail.bits <= 32
    return fits and operation.detail.rounding == "up"


def _shift_right(width: int) -> Furniture:
    ctype = f"int{width}_t"
    name = f"shift_right_{width}"
    return Furniture(
        name,
        f"/* x / 2^bits, rounded down, 0 <= bits < {width}. */\n"
        f"static inline {ctype} {name}({ctype} x, int bits)\n"
        "{\n"
        f"    return (((({ctype})-1) >> 1) == -1) ? (x >> bits) : ((x < 0) ? ~(~x >> bits) : (x >> bits));\n"
        "}\n",
    )


def _wrapped(width: int) -> Furniture:
    ctype = f"int{width}_t"
    most = "INT64_MAX" if width == 64 else str(2 ** (width - 1) - 1)
    unsigned = f"uint{width}_t"
    back = f"-({ctype})(~bits) - 1" if width > 16 else f"({ctype})(-({ctype})({unsigned})(~bits) - 1)"
    return Furniture(
        f"wrapped_{width}",
        f"/* The word of {width} bits with these bits. */\n"
        f"static inline {ctype} wrapped_{width}({unsigned} bits)\n"
        "{\n"
        f"    return (bits <= ({unsigned}){most}) ? ({ctype})bits : ({back});\n"
        "}\n",
    )


def _wrapping(operation: Operation) -> Furniture:
    """Return a sum, difference or shift in a word of the result's width, whatever does not fit dropped."""
    assert isinstance(operation.format, Signal)
    width, word = operation.format.width, WRAPPING[operation.op]
    ctype, unsigned = operation.format.ctype, f"uint{width}_t"
    told, given, made = {
        "add": ("a + b", f"{ctype} a, {ctype} b", f"({unsigned})a + ({unsigned})b"),
        "subtract": ("a - b", f"{ctype} a, {ctype} b", f"({unsigned})a - ({unsigned})b"),
        "negate": ("-a", f"{ctype} a", f"0U - ({unsigned})a"),
        "shift_left": ("a * 2^bits", f"{ctype} a, int bits", f"({unsigned})a << bits"),
    }[word]
    return Furniture(
        f"{word}_{width}",
        f"/* {told}, modulo 2^{width}. */\n"
        f"static inline {ctype} {word}_{width}({given})\n"
        "{\n"
        f"    return wrapped_{width}({made});\n"
        "}\n",
    )


def _rounding(operation: Operation, width: int, wraps: bool) -> str:
    assert isinstance(operation.format, Signal)
    assert isinstance(operation.detail, Shift)
    bits, rounding, result = operation.detail.bits, operation.detail.rounding, operation.format.width
    name, out, into = shift_name(operation, width), f"int{result}_t", f"int{width}_t"
    half = 1 << (bits - 1)
    told = {"up": "to nearest, halves up", "even": "to nearest, halves to even", "floor": "down"}[rounding]
    fits = f"; the result fits {result} bits" if result < width else ""
    head = f"/* x / 2^{bits}, rounded {told}{fits}. */\nstatic inline {out} {name}({into} x)\n{{\n"
    cast = f"({out})" if result < width else ""
    if wraps and not _by_image(operation, width):
        return head + _wrapping_rounding(operation, width) + "}\n"
    if _by_image(operation, width):
        body = (
            f"    const uint32_t image = (uint32_t)(((uint64_t)x + UINT64_C({half})) >> {bits});\n"
            "    return (image <= 0x7FFFFFFFU) ? (int32_t)image : (-(int32_t)(~image) - 1);\n"
        )
    elif rounding == "floor":
        body = f"    return {cast}shift_right_{width}(x, {bits});\n"
    elif rounding == "up":
        body = f"    return {cast}shift_right_{width}(x + {integer(half, width)}, {bits});\n"
    else:
        unsigned = f"uint{width}_t"
        half_image, mask = (f"UINT64_C({each})" if width > 32 else f"{each}U" for each in (half, 2 * half - 1))
        body = (
            f"    const {into} up = shift_right_{width}(x + {integer(half, width)}, {bits});\n"
            f"    const int tie = ((({unsigned})x + {half_image}) & {mask}) == 0;\n"
            f"    return {cast}((tie != 0) ? (up - (up & 1)) : up);\n"
        )
    return head + body + "}\n"


def _wrapping_rounding(operation: Operation, width: int) -> str:
    """Return the body of a rounding whose sum may be any word."""
    assert isinstance(operation.format, Signal)
    assert isinstance(operation.detail, Shift)
    bits, rounding, result = operation.detail.bits, operation.detail.rounding, operation.format.width
    unsigned, half = f"uint{width}_t", 1 << (bits - 1)
    constant = f"UINT64_C({half})" if width > 32 else f"{half}U"
    mask = f"UINT64_C({2 * half - 1})" if width > 32 else f"{2 * half - 1}U"
    whole = "x" if rounding == "floor" else f"wrapped_{width}(({unsigned})x + {constant})"
    lines = [f"    const int{width}_t up = shift_right_{width}({whole}, {bits});\n"]
    value = "up"
    if rounding == "even":
        lines.append(f"    const int tie = ((({unsigned})x + {constant}) & {mask}) == 0;\n")
        value = "((tie != 0) ? (up - (up & 1)) : up)"
    narrowed = f"wrapped_{result}((uint{result}_t){value})" if result < width else value
    return "".join([*lines, f"    return {narrowed};\n"])


def _low(operation: Operation) -> str:
    """Return the low limb of a word: its bits are shifted up and back, which extends their sign."""
    assert isinstance(operation.detail, Shift)
    bits = operation.detail.bits
    return (
        f"/* The last {bits} bits of x, from -2^{bits - 1} on: x less a multiple of 2^{bits}. */\n"
        f"static inline int32_t {low_name(operation)}(int32_t x)\n"
        "{\n"
        f"    return shift_right_32(wrapped_32((uint32_t)x << {32 - bits}), {32 - bits});\n"
        "}\n"
    )


def _clamp(operation: Operation, width: int) -> str:
    assert isinstance(operation.format, Signal)
    into, out = f"int{width}_t", operation.format.ctype
    cast = f"({out})" if operation.format.width < width else ""
    return (
        "/* x, kept from low to high. */\n"
        f"static inline {out} {clamp_name(operation, width)}({into} x, {into} low, {into} high)\n"
        "{\n"
        f"    return {cast}((x < low) ? low : ((x > high) ? high : x));\n"
        "}\n"
    )
