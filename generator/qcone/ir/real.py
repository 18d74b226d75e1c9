"""The real language: what the paper wrote. Exact constants, one written operation = one value, nothing shared.

This module is also the door for authors: everything an algorithm file may use is named in `__all__`.
"""

from __future__ import annotations

from fractions import Fraction as F  # noqa: N817  the papers' coefficients are written F(9, 20)

from qcone.ir.blocks import Matrix, Quaternion, Scalar, Vector, cross, dot, matrix, number, sqrt, vector
from qcone.ir.frame import rows
from qcone.ir.functions import (
    PI,
    arcsine,
    arctangent_2,
    less,
    ratio,
    reciprocal_root,
    select,
    sine_cosine,
    sine_cosine_of_small,
    square_root,
    square_root_of_unit,
    wide,
    within,
)
from qcone.ir.index import Index
from qcone.ir.indexed import History, history, loop, table
from qcone.ir.labels import heading, named, step
from qcone.ir.operations import RealOp
from qcone.ir.records import recorded_products, recorded_square, recorded_sum
from qcone.ir.specification import Algorithm, Phase, Source, algorithm
from qcone.ir.statement import Block, Role, Routine, Shape
from qcone.ir.subroutine import subroutine
from qcone.ir.update import (
    Rotation,
    Update,
    exp,
    increment,
    quaternion,
    rotation,
    shortened,
)

__all__ = [
    "PI",
    "Algorithm",
    "Block",
    "F",
    "History",
    "Index",
    "Matrix",
    "Phase",
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
    "arcsine",
    "arctangent_2",
    "cross",
    "dot",
    "exp",
    "heading",
    "history",
    "increment",
    "less",
    "loop",
    "matrix",
    "named",
    "number",
    "quaternion",
    "ratio",
    "reciprocal_root",
    "recorded_products",
    "recorded_square",
    "recorded_sum",
    "rotation",
    "rows",
    "select",
    "shortened",
    "sine_cosine",
    "sine_cosine_of_small",
    "sqrt",
    "square_root",
    "square_root_of_unit",
    "step",
    "subroutine",
    "table",
    "vector",
    "wide",
    "within",
]
