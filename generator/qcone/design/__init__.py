"""Design files: read, validate and resolve what a user asks for, with every mistake reported at once.

The catalogue of algorithms is given by the caller as data; nothing here knows a particular algorithm.
Importing this package loads neither pydantic nor anything else of qcone but its errors.
"""

from __future__ import annotations

from qcone.design.catalogue import AlgorithmEntry, Parameter, Value
from qcone.design.design import Design, Imu, Number, Rins
from qcone.design.keys import DESIGN_KEYS, IMU_KEYS, NUMBER_KEYS, RINS_KEYS, TARGETS, Key
from qcone.design.options import design_from_options
from qcone.design.read import read_designs
from qcone.design.schema import json_schema

__all__ = [
    "DESIGN_KEYS",
    "IMU_KEYS",
    "NUMBER_KEYS",
    "RINS_KEYS",
    "TARGETS",
    "AlgorithmEntry",
    "Design",
    "Imu",
    "Key",
    "Number",
    "Parameter",
    "Rins",
    "Value",
    "design_from_options",
    "json_schema",
    "read_designs",
]
