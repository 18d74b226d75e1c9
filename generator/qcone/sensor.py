"""Sensor: what stands between the words a design is handed and the vectors its algorithm takes.

Whole counts of a gyro become angle increments by one constant each, the quantum over the sample rate, or by the rows
of a calibration; what a word cannot hold is carried to the next update, as a pulse counter does. Inputs may be
limited to their declared range, component by component.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import sqrt

from qcone.design import Design
from qcone.ir.blocks import Scalar, Vector, of
from qcone.ir.builder import Builder
from qcone.ir.labels import step
from qcone.ir.operations import RealOp
from qcone.ir.statement import Shape

PI = Fraction(31415926535897932384626433832795028841971693993751, 10**49)
COUNT_BITS = 16
"""Width of a gyro's word."""


def increments_of_counts(counts: Sequence[Vector], design: Design, interval: Fraction, norm: Fraction) -> list[Vector]:
    """Write theta = M (quantum n - bias) T/N, rad, for the whole counts n of each sub-sample, the residue carried.

    M is the calibration, rows of body axes; `norm` bounds |theta|. Counts, bias and M are along the sensor's axes.
    """
    quantum = design.imu.quantum_dps
    assert quantum is not None
    unit = PI / 180 * interval / len(counts)
    rows = design.imu.calibration or ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    bias = design.imu.bias_dps or (Fraction(0),) * 3
    made = []
    for k, vector in enumerate(counts):
        parts = [_row(list(vector), [Fraction(each) for each in row], quantum * unit, bias, unit) for row in rows]
        builder = vector.builder
        values = [builder.emit(RealOp.CARRY, part.value) for part in parts]
        theta: Vector = of(builder, Shape.VECTOR, values, norm)
        mark = str(k + 1) if len(counts) > 1 else ""
        text = f"theta{mark} = quantum T/N counts{' - bias' if design.imu.bias_dps else ''}, rad, the residue carried"
        made.append(
            step(text if design.imu.calibration is None else text.replace("= quantum", "= M quantum"), "", theta)
        )
    return made


def _row(
    counts: list[Scalar], row: Sequence[Fraction], scale: Fraction, bias: Sequence[Fraction], unit: Fraction
) -> Scalar:
    """Write one component: sum of M_ij quantum n_j, less the bias's share of an interval."""
    terms = [(scale * factor) * count for factor, count in zip(row, counts, strict=True) if factor]
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    offset = unit * sum((factor * each for factor, each in zip(row, bias, strict=True)), Fraction(0))
    return total - offset if offset else total


def largest_count(design: Design) -> int:
    """Return the largest size of a count that a rate within the declared range can give, or the word's largest.

    A true rate w reads n = (M^-1 w + bias)/quantum: bounded by the Frobenius norm of the calibration's inverse.
    """
    quantum = design.imu.quantum_dps
    assert quantum is not None
    rows = design.imu.calibration
    gain = Fraction(1) if rows is None else _inverse_norm(rows)
    bias = max((abs(each) for each in design.imu.bias_dps or ()), default=Fraction(0))
    most = (design.imu.max_rate_dps * gain + bias) / quantum + 1
    return min(-(-most.numerator // most.denominator), 1 << (COUNT_BITS - 1))


def counts_radius(design: Design) -> float:
    """Return a length of count vectors whose rates are all within the declared range."""
    quantum = design.imu.quantum_dps
    assert quantum is not None
    rows = design.imu.calibration or ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    gain = sqrt(sum(Fraction(each) ** 2 for row in rows for each in row))
    bias = sqrt(sum(each * each for each in design.imu.bias_dps or ()))
    gain = 1.0 if design.imu.calibration is None else gain
    return max(1.0, min((float(design.imu.max_rate_dps) / gain - bias) / float(quantum), 32767.0))


def _inverse_norm(rows: Sequence[Sequence[Fraction]]) -> Fraction:
    """Return a bound of |M^-1 w| / |w|, by cofactors. Raises ZeroDivisionError for a singular M."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    cofactors = (
        *(e * i - f * h, c * h - b * i, b * f - c * e),
        *(f * g - d * i, a * i - c * g, c * d - a * f),
        *(d * h - e * g, b * g - a * h, a * e - b * d),
    )
    determinant = a * cofactors[0] + b * cofactors[3] + c * cofactors[6]
    # The sum of sizes is not below the root of the sum of squares.
    return sum((abs(each) for each in cofactors), Fraction(0)) / abs(determinant)


def clamped(builder: Builder, vector: Vector, limit: Fraction, norm: Fraction) -> Vector:
    """Write a vector with each component limited to `limit`; `norm` is what then bounds its length."""
    values = [builder.clamp(value, -limit, limit) for value in vector.values]
    limited: Vector = of(builder, Shape.VECTOR, values, norm)
    return limited
