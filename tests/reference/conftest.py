"""The exact cases as dictionaries; numbers in them are strings of 40 digits or fractions."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest


@pytest.fixture(scope="session")
def case(truth: Path) -> Callable[[str], Any]:
    """Return the parsed contents of one file of exact cases, by its stem."""

    def load(stem: str) -> Any:
        return json.loads((truth / f"{stem}.json").read_text())

    return load


@pytest.fixture(scope="session")
def rounded() -> Callable[[Any], np.ndarray]:
    """Return nested lists of exact numbers as an array, each correctly rounded to float64."""

    def convert(value: Any) -> Any:
        return [convert(item) for item in value] if isinstance(value, list) else float(Fraction(value))

    return lambda value: np.array(convert(value))
