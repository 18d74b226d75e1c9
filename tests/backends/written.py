"""A user's algorithm with a loop over a history, a table and a subroutine, for readings of every kind of statement."""

from __future__ import annotations

from pathlib import Path

from qcone.bundle import Bundle
from qcone.design import design_from_options
from qcone.design.design import Design
from qcone.pipeline import build
from qcone.registry import entries

TEXT = '''\
from qcone import F, Source, algorithm, cross, dot, history, loop, rotation, subroutine, table


@subroutine
def turned(a, b):
    """Give a third of a x b."""
    return F(1, 3) * cross(a, b)


@algorithm("recurrence", source=Source("cao", "(9)"), subsamples=1)
def recurrence(q, dtheta):
    (d,) = dtheta
    term = history("term", d, 4)
    weight = table("weight", d, [1, F(1, 4), F(1, 16), F(-1, 3)])
    term[0] = d
    for n in loop("n", d, 1, 3):
        term[n] = weight[n] * turned(d, term[n - 1])
    return q * rotation(F(-1, 8) * dot(d, d), F(1, 2) * d + term[3])
'''


def design_of_file(algorithm: str, **options: str) -> Design:
    """Return the design of a user's algorithm, `file.py:name`, float32 with both outputs unless told otherwise."""
    base = {"number": "float32", "update_hz": "100", "max_rate_dps": "573", "outputs": "quaternion,dcm"}
    name = algorithm.rpartition(":")[2]
    return design_from_options(name, {"algorithm": algorithm, **base, **options}, entries())


def bundle(folder: Path, loop: str, number: str = "float32") -> Bundle:
    """Write the file into a folder and return what is emitted for its algorithm."""
    file = folder / "recurrence.py"
    file.write_text(TEXT)
    return build(design_of_file(f"{file}:recurrence", loop=loop, number=number))
