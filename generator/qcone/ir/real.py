"""The real language: what the paper wrote. Exact constants, one written operation = one value, nothing shared.

This module is also the door for authors: everything an algorithm file may use is named in `__all__`.
"""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817  the papers' coefficients are written F(9, 20)

from qcone.ir.blocks import Matrix, Quaternion, Scalar, Vector, cross, dot, matrix, named, number, sqrt, step
from qcone.ir.indexed import history, loop, table
from qcone.ir.operations import RealOp
from qcone.ir.specification import Algorithm, Source, algorithm
from qcone.ir.statement import Block, Role, Routine, Shape
from qcone.ir.subroutine import subroutine
from qcone.ir.update import Rotation, Update, exp, quaternion, rotation

__all__ = [
    "Algorithm",
    "Block",
    "F",
    "Matrix",
    "Quaternion",
    "RealOp",
    "Role",
    "Rotation",
    "Routine",
    "Scalar",
    "Shape",
    "Source",
    "Update",
    "Vector",
    "algorithm",
    "cross",
    "dot",
    "exp",
    "history",
    "loop",
    "matrix",
    "named",
    "number",
    "quaternion",
    "rotation",
    "sqrt",
    "step",
    "subroutine",
    "table",
]
