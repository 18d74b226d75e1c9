"""A user's own file beside a design that names it, as a user has them; and the recurrence of the Taylor series."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

from qcone.bundle import Bundle
from qcone.design import Design, read_designs
from qcone.pipeline import build
from qcone.registry import entries

IMPORTS = """\
from qcone import (
    F, Source, algorithm, cross, dot, exp, history, loop, matrix, named, number, quaternion, rotation, sqrt, step,
    subroutine, table,
)
"""

DESIGN = """\
[design.att]
algorithm = "my_paper.py:{function}"
loop = "{loop}"
form = "{form}"
axes = "{axes}"

[design.att.imu]
update_hz = 100
max_rate_dps = 573

[design.att.number]
format = "{number}"
{accumulate}
"""


def design_of(
    folder: Path,
    text: str,
    function: str = "my_update",
    *,
    loop: str = "unrolled",
    form: str = "factored",
    number: str = "float32",
    accumulate: str = "",
    axes: str = "x,y,z",
) -> Design:
    """Write `my_paper.py` and `paper.toml` into the folder and return the design."""
    (folder / "my_paper.py").write_text(text, encoding="utf-8")
    chosen = f'accumulate = "{accumulate}"' if accumulate else ""
    filled = DESIGN.format(function=function, loop=loop, form=form, number=number, accumulate=chosen, axes=axes)
    (folder / "paper.toml").write_text(filled, encoding="utf-8")
    (design,) = read_designs(folder / "paper.toml", entries())
    return design


def paper(body: str, before: str = "", subsamples: int = 1) -> str:
    """Return the text of a user's file: `my_update(q, dtheta)` with that body, after the lines `before`."""
    head = f'@algorithm("mine", source=Source("paper", "(1)"), subsamples={subsamples})\ndef my_update(q, dtheta):\n'
    return f"{IMPORTS}\n{dedent(before)}\n{head}{indent(dedent(body), '    ')}"


def bundle_of(folder: Path, text: str, **options: str) -> Bundle:
    """Return what is emitted for the user's file."""
    return build(design_of(folder, text, **options))


ORDER = 10
TAYLOR = paper(
    f"""\
    d1, d2, d3 = dtheta
    a = history("a", d1, 3)
    a[0] = step("a0 = omega(0) T/2", "xu2019 (3)", F(11, 4) * d1 - F(7, 4) * d2 + F(1, 2) * d3)
    a[1] = -9 * d1 + F(27, 2) * d2 - F(9, 2) * d3
    a[2] = F(27, 4) * d1 - F(27, 2) * d2 + F(27, 4) * d3
    inverse = table("inverse", q, [0, *(F(1, n) for n in range(1, {ORDER} + 1))])
    r = history("r", q, {ORDER} + 1)
    total = history("total", q, {ORDER} + 1)
    r[0] = quaternion(number(1, q), 0 * d1)
    total[0] = quaternion(number(0, q), 0 * d1)
    for n in loop("n", q, 1, 2):
        r[n] = r[n - 1] * a[0]
        for j in loop("j", q, 1, n - 1):
            r[n] = r[n] + r[n - 1 - j] * a[j]
        r[n] = inverse[n] * r[n]
        total[n] = total[n - 1] + r[n]
    for n in loop("n", q, 3, {ORDER}):
        r[n] = r[n - 1] * a[0]
        for j in loop("j", q, 1, 2):
            term = r[n - 1 - j] * a[j]
            r[n] = r[n] + term
        r[n] = inverse[n] * r[n]
        total[n] = total[n - 1] + r[n]
    e = total[{ORDER}]
    return q * rotation(e.scalar, e.vector)
    """,
    subsamples=3,
)
"""xu2019 (7), (8) normalised: r_n = (1/n) sum_j r_(n-1-j) (x) A_j, A_j half the coefficients of the fitted rate."""

LADDER = paper(
    """\
    (d,) = dtheta
    weight = table("weight", d, [F(1, 3), F(1, 5), F(1, 7), F(1, 9), F(1, 11)])
    v = history("v", d, 6)
    v[0] = F(2, 3) * d
    for n in loop("n", d, 1, 5):
        v[n] = weight[n - 1] * cross(d, v[n - 1]) + v[n - 1]
    back = history("back", d, 6)
    for n in loop("n", d, 0, 5):
        back[n] = v[5 - n]
    return q * rotation(F(-1, 8) * dot(d, d), F(1, 2) * back[0])
    """
)
"""Nothing here folds away or carries a sign: rolled and written out execute the same operations one for one."""

INSIDE = paper(
    """\
    (d,) = dtheta
    return q * rotation(F(-1, 8) * dot(d, d), F(1, 2) * rungs(d, F(1, 2) * d))
    """,
    before="""\
    @subroutine
    def rungs(a, b):
        r = history("r", a, 4)
        w = table("w", a, [F(1, 3), F(1, 5), F(1, 7), F(1, 9)])
        r[0] = a
        for n in loop("n", a, 1, 3):
            r[n] = r[n - 1] - w[n] * cross(r[n - 1], b)
        return r[3]
    """,
)
"""A loop inside a subroutine."""
