"""What the emitted files say of a rotating unit: what is declared of it, and above each function of the stage."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction

from qcone.declaration import Declaration
from qcone.design import Rins
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating

STAGE = "encoder angle and tilt of a rotating unit corrected, rins (10) to (16); the attitude kept is the sensors'"

ANGLE_UNITS, TILT_UNITS, QUATERNION_UNITS = 8, 24, 8
"""Errors, in units of the last place of 1: of an angle's and a tilt's correction, by the largest correction in rad;
of a component of the body's quaternion.

Sine and cosine are within 4 units over the range: 2.2 of them from folding by a rounded 2 pi and pi, which turns
both together, the rest from the polynomials and their roundings. A harmonic adds the roundings of two products and
two sums; the tilt's angle is doubled, and the error of its sine with it. Folding turns q_sb as a whole by those 2.2,
the other 0.9 of sine and cosine add by their squares, the products by half a unit each, and the product with q_ns
two units: 7.1.
"""

FIXED = 4
"""How much larger the same errors are in fixed point, where an angle of 3 pi leaves sine and cosine two bits fewer."""


def declared(rins: Rins, known: Declaration) -> str:
    """Say what is declared of a rotating unit."""
    largest = Decimal(rins.max_correction_arcsec.numerator) / Decimal(rins.max_correction_arcsec.denominator)
    return (
        "encoder angle at most 3 pi in size; sqrt(A^2 + B^2) + |C| of each harmonic at most "
        f"{float(known.correction or 0):.5g} rad ({largest.normalize():f} arcsec)"
    )


def of_routines(number: Floating | Fixed, known: Declaration, angles: Sequence[str]) -> dict[str, list[str]]:
    """Return the contract of each function of the stage; `angles` are the lines of the Euler angles."""
    largest = known.correction or Fraction(0)
    unit = number.ulp(Fraction(1)) * (FIXED if isinstance(number, Fixed) else 1)
    angle, tilt = (f"{float(units * unit * largest):.2g} rad" for units in (ANGLE_UNITS, TILT_UNITS))
    return {
        "set_correction": [
            "azimuth: A, B, C of the encoder's error A sin al + B cos al + C, rins (13).",
            "tilt_x: A2, B2, C2 of the sensors' tilt A2 sin 2al + B2 cos 2al + C2 about x, rins (16).",
            "tilt_y: the same about y.",
            f"Range: rad; sqrt(A^2 + B^2) + |C| of each at most {float(largest):.5g}. Zero after init(); kept by what "
            "sets the attitude.",
        ],
        "correct": [
            "encoder: angle of the sensors against the body about the body's z axis, at the time of the attitude; rad, "
            "at most 3 pi in size: 0..2 pi and -pi..pi both, with half a turn to spare. Beyond it the result is wrong.",
            f"angle: al - (A sin al + B cos al + C), not wrapped; within half a unit of its last place and {angle}.",
            f"tilt: about x and y, at the corrected angle, rad; within {tilt} of the exact function.",
        ],
        "body_quaternion": [
            "angle: rad, as correct() gives it.",
            "tilt: about x and y, rad, as correct() gives it.",
            "q_nb: w, x, y, z; body to navigation, C_b^n = C_s^n C_s'^s C_b^s'.",
            f"Each component is within {float(QUATERNION_UNITS * unit):.2g} of the exact function of the arguments and "
            "of the attitude that quaternion() gives.",
        ],
        "body_dcm": [
            "q_nb: as body_quaternion() gives it.",
            "c_nb: row major, v_n = C_nb v_b.",
        ],
        "body_euler": ["q_nb: as body_quaternion() gives it.", *angles],
    }
