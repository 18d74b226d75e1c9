"""The classical fourth-order Runge-Kutta method on the attitude equation, from rates: the papers' baseline.

One update takes the rates at its start, middle and end. As written: f(q, t) = 1/2 q (x) (0, omega(t)), k1 .. k4 and
q + h (k1 + 2 k2 + 2 k3 + k4)/6. Factored: the step is part of the rates, g = h/2 omega, so that k1 = q (x) g and the
increment is (k1 + k4)/6 + (k2 + k3)/3. For a matrix every row obeys v' = v x omega: two rows, g = h omega.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from qcone.algorithms.family import Choice, Family
from qcone.ir.real import (
    Algorithm,
    F,
    Matrix,
    Quaternion,
    Source,
    Vector,
    algorithm,
    cross,
    increment,
    matrix,
    rows,
    step,
)

SOURCE = Source("classical", "Runge 1895, Kutta 1901")
SIXTH, THIRD = F(1, 6), F(1, 3)
PROPERTIES = frozenset({"flip"})


def quaternion_form() -> Algorithm:
    """Return the method on the quaternion."""

    @algorithm(
        "runge-kutta-4-quaternion", source=SOURCE, subsamples=2, order=4, properties=PROPERTIES, takes="omega",
        summary="k = 1/2 q (x) omega; q + h (k1 + 2 k2 + 2 k3 + k4)/6",
    )  # fmt: skip
    def written(q: Quaternion, omega: Sequence[Vector], interval: Fraction) -> Any:
        start, middle, end = omega
        half = F(1, 2)
        k1 = step("k1 = f(q, t)", "f = 1/2 q (x) omega", half * (q * start))
        k2 = step("k2 = f(q + h k1/2, t + h/2)", "", half * ((q + (interval / 2) * k1) * middle))
        k3 = step("k3 = f(q + h k2/2, t + h/2)", "", half * ((q + (interval / 2) * k2) * middle))
        k4 = step("k4 = f(q + h k3, t + h)", "", half * ((q + interval * k3) * end))
        change = (interval / 6) * (k1 + 2 * k2 + 2 * k3 + k4)
        return increment(q, step("dq = h (k1 + 2 k2 + 2 k3 + k4)/6", "", change))

    @written.factored
    def factored(q: Quaternion, omega: Sequence[Vector], interval: Fraction) -> Any:
        start, middle, end = (step(f"g{i} = h/2 omega_{i}", "", (interval / 2) * rate) for i, rate in enumerate(omega))
        half = F(1, 2)
        k1 = step("k1 = q (x) g0", "", q * start)
        k2 = step("k2 = (q + k1/2) (x) g1", "", (q + half * k1) * middle)
        k3 = step("k3 = (q + k2/2) (x) g1", "", (q + half * k2) * middle)
        k4 = step("k4 = (q + k3) (x) g2", "", (q + k3) * end)
        return increment(q, step("dq = (k1 + k4)/6 + (k2 + k3)/3", "", SIXTH * (k1 + k4) + THIRD * (k2 + k3)))

    return written


def dcm_form() -> Algorithm:
    """Return the method on the direction cosine matrix: three rows; factored, two rows and their cross product."""

    @algorithm(
        "runge-kutta-4-dcm", source=SOURCE, subsamples=2, order=4, properties=PROPERTIES,
        written_properties=PROPERTIES | {"cyclic"}, takes="omega", state="dcm",
        summary="k = C [omega x]; C + h (k1 + 2 k2 + 2 k3 + k4)/6, row by row",
    )  # fmt: skip
    def written(c: Matrix, omega: Sequence[Vector], interval: Fraction) -> Any:
        return matrix([entry for i in range(3) for entry in _row_as_written(i, c.row(i), omega, interval)])

    @written.factored
    def by_rows(c: Matrix, omega: Sequence[Vector], interval: Fraction) -> Any:
        rates = [step(f"g{i} = h omega_{i}", "", interval * rate) for i, rate in enumerate(omega)]
        return rows(c, _row("a", c.row(0), rates), _row("b", c.row(1), rates))

    return written


def _row_as_written(number: int, row: Vector, omega: Sequence[Vector], h: Fraction) -> Vector:
    start, middle, end = omega
    name = "abc"[number]
    k1 = step(f"{name}1 = f({name}, t)", "f = v x omega, v a row of C", cross(row, start))
    k2 = step(f"{name}2 = f({name} + h {name}1/2, t + h/2)", "", cross(row + (h / 2) * k1, middle))
    k3 = step(f"{name}3 = f({name} + h {name}2/2, t + h/2)", "", cross(row + (h / 2) * k2, middle))
    k4 = step(f"{name}4 = f({name} + h {name}3, t + h)", "", cross(row + h * k3, end))
    change = (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4)
    text = f"{name}_next = {name} + h ({name}1 + 2 {name}2 + 2 {name}3 + {name}4)/6"
    return step(text, "", row + change)


def _row(name: str, row: Vector, rates: Sequence[Vector]) -> Vector:
    start, middle, end = rates
    half = F(1, 2)
    k1 = step(f"{name}1 = {name} x g0", "", cross(row, start))
    k2 = step(f"{name}2 = ({name} + {name}1/2) x g1", "", cross(row + half * k1, middle))
    k3 = step(f"{name}3 = ({name} + {name}2/2) x g1", "", cross(row + half * k2, middle))
    k4 = step(f"{name}4 = ({name} + {name}3) x g2", "", cross(row + k3, end))
    change = SIXTH * (k1 + k4) + THIRD * (k2 + k3)
    return step(f"d{name} = ({name}1 + {name}4)/6 + ({name}2 + {name}3)/3", "", change)


FAMILY = Family(
    id="runge-kutta-4",
    title="classical Runge-Kutta method on the attitude equation, from rates",
    source=SOURCE,
    parameters=(Choice("attitude", ("quaternion", "dcm"), "quaternion", "what is integrated"),),
    make=lambda values: dcm_form() if values["attitude"] == "dcm" else quaternion_form(),
    examples=({"attitude": "quaternion"}, {"attitude": "dcm"}),
)
