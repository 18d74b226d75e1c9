"""Contract: what the emitted files say of themselves, as lines of text: banner, macros, and above each function."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

from qcone import __version__, stage_contract
from qcone.backends.counts import Counts
from qcone.backends.page import Macro
from qcone.declaration import Declaration
from qcone.design import Design
from qcone.formats.fixed import Fixed
from qcone.formats.floating import FLOAT64, Floating
from qcone.ir.specification import Algorithm
from qcone.passes.exponential import Exponential
from qcone.passes.fixed_point import Proved
from qcone.registry import caution_of

INTERFACE = 1
"""Raised when the emitted functions, macros or state change their meaning."""
WIDTH = 96
BEYOND = (
    "beyond it nothing is bounded: accuracy is lost and, far beyond it, the state can diverge to NaN for good, "
    "so clamp inputs that can be so large; setting the attitude anew brings it back"
)
FLAGS = "-std=c99 -ffp-contract=off"
GCC_FLAGS = "-fno-tree-vectorize"
ANY_MACHINE = (
    "The bits are the same on every machine that rounds each operation to its own IEEE 754 format. Under "
    "flush-to-zero they hold for components that are 0 or at least 2^-48 in size; the payload and sign of a NaN are "
    "unspecified."
)


ARGUMENTS = {
    "dtheta": "DTHETA",
    "omega": "OMEGA",
    "q_nb": "Q",
    "c_nb": "C",
    "rpy": "RPY",
    "angles": "RPY",
    "e": "E",
    **{name: name.upper() for name in ("encoder", "angle", "tilt", "azimuth", "tilt_x", "tilt_y")},
}
"""What an argument is called in the macro of its fraction bits."""


EVERYWHERE = (
    "Integer arithmetic of C99 alone, without undefined and without implementation-defined results: the bits are the "
    "same on every conforming compiler and processor, whatever its flags."
)


@dataclass(frozen=True)
class Facts:
    """What is known of a design when its files are written."""

    design: Design
    algorithm: Algorithm
    number: Floating | Fixed
    known: Declaration
    exponential: Exponential | None
    digest: str
    counts: dict[str, dict[str, Counts]]
    """Counts by routine, then by level: as-written, shared, emitted."""
    proved: Proved | None = None
    """What is proved in fixed point."""
    products: str = ""
    """How products of words are made, as a sentence, where there is something to be said."""


def command(design: Design) -> str:
    """Return the command that makes the files again."""
    return f"qcone generate {design.file or 'DESIGN.toml'} --design {design.name}"


def banner(facts: Facts) -> tuple[str, ...]:
    """Return the lines of the comment that opens both files."""
    design, algorithm = facts.design, facts.algorithm
    caution = caution_of(design)
    fixed = isinstance(facts.number, Fixed)
    lines = [
        f"qcone {__version__}, design {design.name}, SHA-256 of the design",
        facts.digest,
        "",
        *_item("algorithm", f"{algorithm.name}, form {design.form}, {_accumulation(facts)}"),
        *_item("source", _source(algorithm)),
        *(_item("stage", stage_contract.STAGE) if design.rins else []),
        *(_item("equation", algorithm.summary) if algorithm.summary else []),
        *_item("number", _number(facts)),
        *_item("flags", _flags(facts)),
        "",
        *_item("range", _range(facts)),
        *(_item("unit", stage_contract.declared(design.rins, facts.known)) if design.rins else []),
        *_item("truncation", truncation(facts)),
        *_item("rounding", rounding(facts)),
        *(_item("products", facts.products) if facts.products else []),
        *_words(facts),
        *(_item("caution", caution) if caution else []),
        "",
    ]
    wide = max(18, *(len(f"{routine} {level} ") for routine, levels in facts.counts.items() for level in levels))
    lines.append(
        f"{'operations':<{wide}}multiply  by 2^k  add  subtract  negate  divide  sqrt  trig  less  select"
        + "  shift" * fixed
    )
    for routine, levels in facts.counts.items():
        for level, counts in levels.items():
            lines.append(
                f"{routine + ' ' + level:<{wide}}{counts.multiply:>8}{counts.power_of_two:>8}{counts.add:>5}"
                f"{counts.subtract:>10}{counts.negate:>8}{counts.divide:>8}{counts.square_root:>6}{counts.trigonometric:>6}"
                f"{counts.compare:>6}{counts.select:>8}" + (f"{counts.shift:>7}" if fixed else "")
            )
    return (*lines, "", *textwrap.wrap(EVERYWHERE if fixed else ANY_MACHINE, WIDTH))


def _number(facts: Facts) -> str:
    number = facts.number
    if isinstance(number, Floating):
        return f"{number.name}, every operation rounded once"
    rounding = {"up": "to nearest, halves up", "even": "to nearest, halves to even", "floor": "down"}[number.rounding]
    as_in = "as in" if facts.products.startswith("of 16-") else "in"
    return (
        f"{number.name}: words of {number.width} bits, sums {as_in} {number.wide}; every sum of products rounded once, "
        f"{rounding}; formats and bounds stand beside every line: F fraction bits, value = raw * 2^-F"
    )


def _flags(facts: Facts) -> str:
    if isinstance(facts.number, Fixed):
        return "-std=c99; no other flag matters"
    return f"{FLAGS}; with gcc, where the target has vector FMA, also {GCC_FLAGS}"


def _item(title: str, text: str) -> list[str]:
    text = f"{title + ':':<12} {_plain(text)}"
    return textwrap.wrap(text, WIDTH, subsequent_indent=" " * 13, break_on_hyphens=False)


def _plain(text: str) -> str:
    """Return an author's text as it may stand in a comment: on one line, and not ending it."""
    return " ".join(text.replace("*/", "* /").replace("/*", "/ *").split())


def _accumulation(facts: Facts) -> str:
    """Say how an update reaches the attitude, in the form the attitude is kept."""
    design, algorithm = facts.design, facts.algorithm
    whole, added = {
        "quaternion": ("q' = q (x) r", "q' = q + q (x) (r - 1)"),
        "dcm": ("C' = C R", "C' = C + dC, two rows and their cross product"),
        "euler": ("rpy' = rpy + change", "rpy' = rpy + change"),
    }[algorithm.state]
    if algorithm.state == "euler":
        return added
    if algorithm.takes == "omega" and algorithm.state == "quaternion":
        whole = added = "q' = q + dq"
    if design.form == "as-written":
        return f"{whole}, not renormalised"
    standard = design.number.accumulate == "standard" and algorithm.state == "quaternion"
    carried = ""
    if design.number.accumulate == "compensated":
        kept = ", kept in twice the bits" if isinstance(facts.number, Fixed) else " (Kahan)"
        carried = f", the rounding carried to the next update{kept}"
    word = "renormalised" if algorithm.state == "quaternion" else "re-orthogonalised"
    folded = {"every": f"{word} on every update", "separate": f"{word} by a call", "never": f"not {word}"}
    return f"{whole if standard else added}{carried}, {folded[design.renormalise]}"


def _source(algorithm: Algorithm) -> str:
    errata = "".join(f"; {each}" for each in algorithm.errata)
    return f"{algorithm.source}{errata}"


def _range(facts: Facts) -> str:
    design, known = facts.design, facts.known
    text = (
        f"|omega| <= {decimal(design.imu.max_rate_dps)} deg/s ({digits(known.rate)} rad/s), "
        f"{decimal(design.imu.update_hz)} updates/s; |dtheta| <= {digits(known.increment)} rad"
    )
    if facts.exponential:
        text += f"; |phi| <= {digits(facts.exponential.phi_max)} rad"
    if facts.proved is not None and facts.algorithm.state != "euler":
        what = "| |q| - 1 |" if facts.algorithm.state == "quaternion" else "length of a row of C, less 1,"
        text += f"; {what} <= {digits(facts.proved.spread, 3)} {_how_long(facts)}, proved"
    return text + f"; {beyond(facts)}"


def _how_long(facts: Facts) -> str:
    proved = facts.proved
    if proved is None or proved.updates is None:
        return "always"
    return f"for {proved.updates} updates after it was set or renormalised"


def rounding(facts: Facts) -> str:
    """Return the bound of one update's rounding as a sentence."""
    proved = facts.proved
    if proved is None or proved.rounding is None:
        return "not bounded"
    text = f"one update is within {digits(proved.rounding, 2)} of exact arithmetic, in the norm of the components"
    if facts.design.number.accumulate == "compensated":
        text += ", what is carried included, which does not add up"
    if proved.growth is not None:
        text += f"; it adds at most {digits(proved.growth, 2)} to the length"
    return f"{text}; proved"


def _words(facts: Facts) -> list[str]:
    """Return what the search for whole words did, where a format has it."""
    words = facts.proved.words if facts.proved else None
    if words is None:
        return []
    return _item(
        "high words",
        f"{words.after} of {words.sums} rounded sums of products drop a whole word, {words.before} before formats were "
        f"searched for that; of one update's errors in the first order it made {digits(words.error_after, 2)} of "
        f"{digits(words.error_before, 2)}",
    )


def beyond(facts: Facts) -> str:
    """Say what happens to inputs beyond the declared range."""
    if isinstance(facts.number, Floating):
        return BEYOND
    if facts.design.number.clamp_inputs:
        return "each component of an input beyond it is clamped to it"
    return {
        "prove": "within it no sum overflows, as is proved; beyond it nothing is promised: clamp inputs that can be "
        "so large",
        "saturate": "beyond it results are clamped to their words, and accuracy is lost",
        "wrap": "beyond it results wrap around, and accuracy is lost",
    }[facts.number.overflow]


def truncation(facts: Facts) -> str:
    """Return the proven error of the exponential's polynomials, or what stands in its place, as a sentence."""
    chosen, order = facts.exponential, facts.algorithm.order
    if chosen is None:
        made = facts.algorithm.truncation
        if made is not None:
            scalar, vector = (digits(each, 2) for each in made(facts.known.increment))
            return f"series of the algorithm's order in |phi|; error of r at most {scalar} (scalar), {vector} (vector)"
        functions = "no function is approximated"
        if facts.algorithm.state == "euler":
            functions = "sine and cosine by polynomials, each within a quarter of the last place of 1"
        return f"{functions}; the method is of order {order} in the interval" if order else functions
    return (
        f"{chosen.kind} polynomials of degree {len(chosen.series.cosine)} (cos) and {len(chosen.series.sine)} (sin) in "
        f"|phi|^2; error of r at most {digits(chosen.scalar_error, 2)} (scalar), {digits(chosen.vector_error, 2)} "
        "(vector), proved over the rationals"
    )


def digits(value: Fraction, digits: int = 5) -> str:
    """Return a number in so many significant digits."""
    return f"{float(value):.{digits}g}"


def decimal(value: Fraction) -> str:
    """Return a number as the decimal it was written as, where it is one."""
    digits = Decimal(value.numerator) / Decimal(value.denominator)
    return f"{digits.normalize():f}" if Fraction(digits) == value else f"{float(value):.17g}"


def macros(facts: Facts, initialiser: str, bits: tuple[tuple[str, int], ...] = ()) -> tuple[Macro, ...]:
    """Return the macros of the header; `bits` are the fraction bits of the arguments of fixed point."""
    name = facts.design.name.upper()
    number = facts.number if isinstance(facts.number, Floating) else FLOAT64
    interval = number.literal(number.round(facts.known.interval))
    places = {ARGUMENTS[block]: fraction for block, fraction in bits if block in ARGUMENTS}
    return (
        *(
            Macro(
                f"{name}_{argument}_FRACTION_BITS", str(fraction), f"{argument.lower()}: value = raw * 2^-{fraction}."
            )
            for argument, fraction in places.items()
        ),
        Macro(f"{name}_VERSION", str(INTERFACE), "Interface of the emitted code; companions check it."),
        Macro(f"{name}_SUBSAMPLES", str(facts.algorithm.subsamples), "Samples handed to one update."),
        Macro(f"{name}_INTERVAL_S", interval, "Time of one update in seconds."),
        Macro(f"{name}_STATE_INIT", initialiser, "Initialiser of a state: what init() sets."),
    )
