"""Whatever stands in a design, the answer is a design or messages of ours, never another exception."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
from fake_catalogue import CATALOGUE, GOOD
from hypothesis import given
from hypothesis import strategies as st

from qcone.design import DESIGN_KEYS, IMU_KEYS, NUMBER_KEYS, design_from_options, read_designs
from qcone.errors import DesignError

VALUES = st.sampled_from(
    [
        *(
            "1",
            "0",
            "-1",
            "9" * 300,
            "1.5",
            "1e400",
            "-inf",
            "nan",
            "0x1F",
            "true",
            '""',
            '"x"',
            '"1/0"',
            '"1/2"',
        ),
        *(
            '"counts"',
            '"as-written"',
            '"fixed32"',
            '"float32"',
            '"my.py:f"',
            '"rate"',
            '"picard"',
            '"y,-x,z"',
        ),
        *("[]", "[[]]", "[1, 2, 3]", '["dcm", 1]', "[[1,0,0],[0,1,0],[0,0,inf]]", "{}", "{a = 1}", "[{}]"),
        *("1979-05-27", "07:32:00", "1979-05-27T07:32:00Z", '"\\u0000"', '"\\U0001F600"', "'''\n]'''"),
    ]
)
PATHS = [
    *(key.name for key in DESIGN_KEYS),
    *(f"imu.{key.name}" for key in IMU_KEYS),
    *(f"number.{key.name}" for key in NUMBER_KEYS),
    *(
        "imu",
        "number",
        "budget",
        "budget.multiply",
        "budget.host",
        "budget.host.text_bytes",
        "subsamples",
        "order",
    ),
    *('"a b"', '""', '"\\n"', "imu.imu", "budget.cortex-m4f.host"),
]


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("any") / "any.toml"


def _answer(file: Path, content: bytes) -> None:
    file.write_bytes(content)
    lines: list[str] = []
    try:
        designs = read_designs(file, CATALOGUE)
    except DesignError as error:
        designs, lines = (), str(error).split("\n")
    assert all(line.startswith(f"{file.as_posix()}:") and ": error QC1" in line for line in lines)
    assert all(len(design.digest) == 64 for design in designs)
    assert bool(designs) != bool(lines)


@given(st.dictionaries(st.sampled_from(PATHS), VALUES, max_size=6))
def test_any_values_of_any_keys(file: Path, values: dict[str, str]) -> None:
    base = {
        "algorithm": '"picard"',
        "imu.update_hz": "1",
        "imu.max_rate_dps": "1",
        "number.format": '"fixed16"',
    }
    lines = [f"{path} = {value}" for path, value in (base | values).items()]
    _answer(file, "\n".join(["[design.att]", *lines]).encode())


@given(st.integers(0, len(GOOD)), st.integers(0, len(GOOD)), st.binary(max_size=4))
def test_any_damage_to_a_file(file: Path, start: int, length: int, instead: bytes) -> None:
    good = GOOD.encode()
    _answer(file, good[:start] + instead + good[start + length :])


@given(
    st.dictionaries(
        st.sampled_from(["", "number", "format", "imu", "budget", "subsamples", "x-y", *PATHS]),
        st.one_of(VALUES, st.none(), st.floats(), st.booleans(), st.integers(), st.lists(st.integers() | st.text())),
        max_size=8,
    )
)
def test_any_options(options: dict[str, object]) -> None:
    with suppress(DesignError):
        assert design_from_options("att", options, CATALOGUE).digest
