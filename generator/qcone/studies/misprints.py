"""What the papers misprint, or say otherwise than they did it, by the algorithm it concerns."""

from __future__ import annotations

from collections.abc import Iterator

from qcone.design import Design

CAO_13 = "cao (13), third row, is printed on omega(0) and omega(T/3); it belongs on omega(T/3) and omega(2T/3)"
CAO_15 = "cao (15) gives a matrix for a unit quaternion only"
CAO_16 = "cao (16) takes arctan where beyond 90 degrees only atan2 is right, and needs its arcsin argument clamped"
SERIES = (
    "xu2019 (5), (7): M' multiplies q from the left and is the matrix of a product from the right, q (x) omega",
    "xu2019 table 1 leaves out the additions inside 23 of 24 dense products: 507 and 270 are 1611 and 684",
    "xu2019 figure 3 at N = 6 takes a series of order 12 or more: order 10, as printed, gets worse again",
)
BY_ALGORITHM = {
    "picard": (
        "cao (7): Sigma is the name of the 4 x 4 matrix of the integrated rate, not a sum sign; exact for a fixed axis",
    ),
    "quaternion-taylor": SERIES,
    "dcm-taylor": SERIES[1:],
    "adams-moulton-4": (
        "thesis2008: its ratios 7, 30, 200 are of Milne's estimate; the true error, the starter's, has 3.4, 8, 27",
        "thesis2008: '1.5 times from 17.5 to 20 Hz' is 1.68",
        "thesis2008: rates used directly do not give a small error: Heun's start leaves 40 times that of the method",
    ),
    "euler-angles": ("cao calls its own algorithm full-scale, as this one is not: cos(pitch) = 0 divides its rates",),
}


def errata(design: Design) -> Iterator[str]:
    """Yield the errata that concern a design: of its algorithm, of its input stage, of its outputs."""
    n = design.parameters.get("subsamples")
    if design.algorithm == "rotation-vector":
        yield "cao (10): the bracket over phi^2 is 0/0 at phi = 0; it is 1/12 + phi^2/720 + ... there"
        if n == 3:
            yield "cao (12) is said to come from the parabola; the parabola gives 33/80 and 57/80, xu2019 (4)"
            yield "cao (12): T is the update period, three sampling periods"
            yield "xu2019 figure 1 was made with the coefficients of cao (12), not with those of its (4)"
    yield from BY_ALGORITHM.get(design.algorithm, ())
    if design.input == "rate" and design.algorithm not in ("runge-kutta-4", "adams-moulton-4", "euler-angles"):
        yield CAO_13
    if "dcm" in design.outputs:
        yield CAO_15
    if "euler" in design.outputs:
        yield CAO_16
