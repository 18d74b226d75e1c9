"""The keys of a design file as data: validation, defaults, JSON schema and options all read this table."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from qcone.design.catalogue import Parameter

Kind = Literal[
    "choice",  # one of `choices`
    "choices",  # a list of different `choices`
    "decimal",  # a positive number, taken as the decimal written
    "rational",  # the same, or a string "p/q"
    "vector",  # three numbers or rationals, any sign
    "matrix",  # three rows of them
    "count",  # a non-negative integer
    "flag",  # true or false
    "pins",  # a list of strings "NAME = BITS"
    "axes",  # a signed permutation such as "y,-x,z"
    "license",  # one SPDX identifier
    "text",
    "unchecked",
]

TARGETS = (
    "host",
    "cortex-m0",
    "cortex-m0plus",
    "cortex-m3",
    "cortex-m4",
    "cortex-m4f",
    "cortex-m7f",
    "cortex-m33f",
    "rv32imc",
    "rv32imfc",
    "powerpc",
)
"""Every target name."""

FIXED_FORMATS = ("fixed32", "fixed16")


@dataclass(frozen=True)
class Key:
    """One key: `example` is what a message proposes to write, as TOML; None as default means not given."""

    name: str
    kind: Kind
    help: str
    example: str
    choices: tuple[int | str, ...] = ()
    default: object = None
    required: bool = False


def _words(name: str, told: str, *choices: str) -> Key:
    return Key(name, "choice", told, f'"{choices[0]}"', choices, choices[0])


DESIGN_KEYS = (
    Key("algorithm", "text", "a catalogue id, or file.py:function", '"rotation-vector"', required=True),
    _words("input", "what the sensor delivers", "increment", "rate", "counts"),
    _words("increments", "how rates become increments", "interpolating", "cao-13"),
    Key("axes", "axes", "sensor to body, signed", '"y,-x,z"', default=((0, 1), (1, 1), (2, 1))),
    Key(
        "outputs",
        "choices",
        "attitude representations to emit",
        '["quaternion"]',
        ("quaternion", "dcm", "euler"),
        ("quaternion",),
    ),
    _words("form", "what firmware runs, or what the paper counts", "factored", "as-written"),
    _words("euler", "convention of roll, pitch and yaw", "zyx", "zxy"),
    _words("loop", "fast, or small, with the same bits", "unrolled", "rolled"),
    _words("exponential", "polynomial of the exponential", "minimax", "taylor"),
    _words("renormalise", "when the attitude is brought back to unit length", "every", "separate", "never"),
    _words("core", "processor the C is written for", "generic", *TARGETS),
    _words("multiply", "how products are made", "auto", "wide", "limbs", "limbs-shared", "library"),
    Key("license", "license", "SPDX identifier of the emitted files", '"MIT-0"', default="MIT-0"),
)

IMU_KEYS = (
    Key("update_hz", "decimal", "attitude updates a second", "100", required=True),
    Key("max_rate_dps", "decimal", "largest Euclidean norm of the body rate, deg/s", "573", required=True),
    Key("max_angular_acceleration_dps2", "decimal", "largest angular acceleration, deg/s^2", "20000"),
    Key("max_jerk_dps3", "decimal", "largest angular jerk, deg/s^3", "1000000"),
    Key("quantum_dps", "rational", "rate of one count, deg/s", '"2000/32768"'),
    Key("bias_dps", "vector", "rate bias on the sensor axes, deg/s", "[0.1, -0.2, 0.05]"),
    Key("calibration", "matrix", "scale and misalignment, 3 x 3", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
)

NUMBER_KEYS = (
    Key(
        "format",
        "choice",
        "number format",
        '"float32"',
        ("float32", "float64", *FIXED_FORMATS),
        required=True,
    ),
    _words("accumulate", "how an update is added to the attitude", "delta", "standard", "compensated"),
    _words("overflow", "what happens outside the declared range", "prove", "saturate", "wrap"),
    _words("rounding", "of ties and remainders", "up", "even", "floor"),
    Key("clamp_inputs", "flag", "limit inputs to the declared range", "false", default=False),
    Key("pins", "pins", "fraction bits of values of an update, by name", '["phi_x = 29"]', default=()),
)

RINS_KEYS = (
    Key(
        "max_correction_arcsec",
        "decimal",
        "largest correction of the encoder angle, and largest tilt, arcsec",
        "600",
        default=Fraction(600),
    ),
)
"""The keys of the stage of a rotating unit; giving the table, empty or not, asks for the stage."""


def _counts(told: str, *names: str) -> tuple[Key, ...]:
    return tuple(Key(name, "count", told, "60") for name in names)


BUDGET_KEYS = _counts(
    "most operations in one update",
    *("multiply", "divide", "add", "subtract", "negate", "square_root", "trigonometric"),
)

TARGET_BUDGET_KEYS = _counts("most on this target", "text_bytes", "instructions_max", "stack_bytes")

NAME_PATTERN = "^[a-z][a-z0-9_]{0,63}$"
USER_ALGORITHM_PATTERN = r"^[^:\n]*[^:/\n]\.py:[A-Za-z_][A-Za-z0-9_]*$"
PIN_PATTERN = "^ *[a-z][a-z0-9_]* *= *[0-9]{1,3} *$"
MOST_FRACTION_BITS = 62
LICENSE_PATTERN = "^[A-Za-z0-9][A-Za-z0-9.+-]*$"

_C_KEYWORDS = """
alignas alignof auto bool break case char const constexpr continue default do double else enum extern false
float for goto if inline int long nullptr register restrict return short signed sizeof static static_assert
struct switch thread_local true typedef typeof typeof_unqual union unsigned void volatile while
"""

C_KEYWORDS = frozenset(_C_KEYWORDS.split())
"""The lower case words of C99 to C23."""


def is_user_algorithm(algorithm: str) -> bool:
    """Tell whether `algorithm` names a function in a user's own file, `file.py:function`."""
    return re.fullmatch(USER_ALGORITHM_PATTERN, algorithm) is not None


def parameter_key(parameter: Parameter) -> Key:
    """Return the design key of an algorithm's `parameter`."""
    first = parameter.choices[0]
    example = f'"{first}"' if isinstance(first, str) else str(first)
    return Key(parameter.name, "choice", parameter.help, example, parameter.choices, parameter.default)


def unchecked_keys(names: Iterable[str]) -> tuple[Key, ...]:
    """Return keys that accept anything, for parameters of an algorithm that is itself in doubt."""
    return tuple(Key(name, "unchecked", "", "") for name in names)


def tables(parameters: tuple[Key, ...]) -> Mapping[tuple[str, ...], tuple[Key, ...]]:
    """Return the keys of every table of a design by the table's path, given its algorithm's keys."""
    own = {key.name for key in DESIGN_KEYS}
    design = (*DESIGN_KEYS, *(key for key in parameters if key.name not in own))
    found: dict[tuple[str, ...], tuple[Key, ...]] = {(): design, ("imu",): IMU_KEYS, ("number",): NUMBER_KEYS}
    found |= {("rins",): RINS_KEYS, ("budget",): BUDGET_KEYS}
    return found | {("budget", target): TARGET_BUDGET_KEYS for target in TARGETS}
