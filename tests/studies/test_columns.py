"""Columns of a CSV file: names, units, text layout, and every message with its place."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from refusing import refusal

from qcone.errors import UsageError
from qcone.studies.recording import read_recording

INCREMENTS = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad\n"
RATES = "t_s,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s\n"
GOOD = INCREMENTS + "0.01,1e-3,2e-3,3e-3\n0.02,4e-3,5e-3,6e-3\n0.03,7e-3,8e-3,9e-3\n"


@pytest.fixture
def csv_file(tmp_path: Path) -> Path:
    return tmp_path / "walk.csv"


@pytest.mark.parametrize(
    ("kind", "unit", "factor"),
    [
        ("increment", "rad", 1.0),
        ("increment", "deg", math.pi / 180),
        ("increment", "arcsec", math.pi / 648000),
        ("rate", "rad/s", 1.0),
        ("rate", "deg/s", math.pi / 180),
    ],
)
def test_columns_map_names_and_units(csv_file: Path, kind: str, unit: str, factor: float) -> None:
    csv_file.write_text("when,gx=1,gy,gz\n0,1,2,3\n0.5,4,5,6\n")
    recording = read_recording(csv_file, kind, columns=f" t = when ; x=gx=1;y=gy;z=gz;unit={unit};")
    np.testing.assert_allclose(recording.values, factor * np.array([[1, 2, 3], [4, 5, 6]]), rtol=3e-16)
    assert recording.sample_hz == 2


def test_unit_defaults_to_radians(csv_file: Path) -> None:
    csv_file.write_text("a,b,c\n1,2,3\n")
    recording = read_recording(csv_file, "rate", columns="x=c;y=b;z=a", sample_hz=50)
    assert recording.values.tolist() == [[3, 2, 1]]


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
def test_byte_order_mark_and_line_ends_do_not_matter(csv_file: Path, newline: str) -> None:
    csv_file.write_bytes(b"\xef\xbb\xbf" + GOOD.replace("\n", newline).encode())
    assert read_recording(csv_file, "increment").values[2].tolist() == [7e-3, 8e-3, 9e-3]


def test_trailing_empty_cells_are_not_a_mistake(csv_file: Path) -> None:
    csv_file.write_text(RATES + "0,1,2,3,\n1,4,5,6, \n")
    assert read_recording(csv_file, "rate").values.tolist() == [[1, 2, 3], [4, 5, 6]]


@pytest.mark.parametrize(
    ("cell", "what"),
    [
        ("nan", "'nan' is not a finite number below 1e+100 in size"),
        ("-inf", "'-inf' is not a finite number below 1e+100 in size"),
        ("1e100", "'1e100' is not a finite number below 1e+100 in size"),
        ("1_0", "'1_0' is not a finite number below 1e+100 in size"),
        ("", "the cell is empty"),
        (" ", "the cell is empty"),
        ("n/a", "'n/a' is not a number"),
        ('"0,5"', "'0,5' is not a number"),
    ],
)
@pytest.mark.parametrize("column", [0, 2])
def test_a_bad_cell_is_named(csv_file: Path, cell: str, what: str, column: int) -> None:
    cells = ["0.02", "4e-3", "5e-3", "6e-3"]
    cells[column] = cell
    text = INCREMENTS + "0.01,1e-3,2e-3,3e-3\n\n" + ",".join(cells) + "\n0.03,x,x,x\n"
    name = ["t_s", "", "dtheta_y_rad"][column]
    assert refusal(csv_file, text) == (
        f"walk.csv:4: data row 2, column '{name}': {what}, every sample counts, remove the row or mend it"
    )


@pytest.mark.parametrize(("line", "count"), [("0.02,4e-3,5e-3", 3), ("0,02,4e-3,5e-3,6e-3", 5)])
def test_a_row_of_another_length_is_named(csv_file: Path, line: str, count: int) -> None:
    assert refusal(csv_file, INCREMENTS + "0.01,1,2,3\n" + line + "\n") == (
        f"walk.csv:3: data row 2: {count} cells where the header has 4, the line is cut short or has a stray "
        "comma (decimals take a point), mend or remove it"
    )


@pytest.mark.parametrize(
    ("header", "kind", "message"),
    [
        (
            "t_s,dtheta_x_rad,dtheta_y,dtheta_z_rad",
            "increment",
            "no column 'dtheta_y_rad', did you mean 'dtheta_y' for 'dtheta_y_rad'?, the columns are 't_s', "
            "'dtheta_x_rad', 'dtheta_y', 'dtheta_z_rad', map the names with --columns",
        ),
        (
            "T_S,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s",
            "rate",
            "no column 't_s', did you mean 'T_S' for 't_s'?, the columns are 'T_S', 'gyr_x_rad_s', "
            "'gyr_y_rad_s', 'gyr_z_rad_s', map its name with --columns, or give --sample-hz HZ",
        ),
        (
            "a,b,c,d",
            "rate",
            "no columns 't_s', 'gyr_x_rad_s', 'gyr_y_rad_s', 'gyr_z_rad_s', the columns are 'a', 'b', "
            "'c', 'd', map the names with --columns",
        ),
        (
            "t_s,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s",
            "increment",
            "no columns 'dtheta_x_rad', 'dtheta_y_rad', 'dtheta_z_rad', the columns are 't_s', "
            "'gyr_x_rad_s', 'gyr_y_rad_s', 'gyr_z_rad_s', these are columns of --input rate",
        ),
        (
            "millis,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s",
            "rate",
            "no column 't_s', the columns are 'millis', 'gyr_x_rad_s', 'gyr_y_rad_s', 'gyr_z_rad_s', map "
            "its name with --columns, or give --sample-hz HZ",
        ),
    ],
)
def test_missing_columns(csv_file: Path, header: str, kind: str, message: str) -> None:
    assert refusal(csv_file, f"\n{header}\n1,2,3,4\n", kind) == f"walk.csv:2: {message}"


def test_a_header_of_numbers_or_other_separators_is_recognised(csv_file: Path) -> None:
    assert refusal(csv_file, "0.1,1,2,3\n").endswith("the first line must name the columns")
    assert refusal(csv_file, GOOD.replace(",", ";")).endswith("columns are separated by commas")


def test_a_mapped_time_column_must_be_there_even_when_overruled(csv_file: Path) -> None:
    columns = "t=when;x=dtheta_x_rad;y=dtheta_y_rad;z=dtheta_z_rad"
    assert "no column 'when'" in refusal(csv_file, GOOD, columns=columns, sample_hz=100)


def test_a_column_standing_twice(csv_file: Path) -> None:
    text = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad,dtheta_x_rad\n1,2,3,4,5\n"
    assert refusal(csv_file, text) == ("walk.csv:1: column 'dtheta_x_rad' stands there twice, rename one of the two")


FORM = "write 't=NAME;x=NAME;y=NAME;z=NAME;unit=UNIT' (t and unit may be left out)"


@pytest.mark.parametrize(
    ("columns", "kind", "message"),
    [
        ("t=a;w=b", "rate", f"unknown key 'w', {FORM}"),
        ("x=a;x=b", "rate", f"'x' is given twice, {FORM}"),
        ("t=a;x=b", "rate", f"no y, z, all three axes are needed, {FORM}"),
        ("", "rate", f"no x, y, z, all three axes are needed, {FORM}"),
        ("x=a;gyro", "rate", f"'gyro' is not key=name, {FORM}"),
        ("x=;y=b", "rate", f"'x=' is not key=name, {FORM}"),
        ("x=a;y=b;z=a", "rate", "x and z both name 'a', give each axis its own column"),
        ("x=a;y=b;z=c;unit=rpm", "rate", "unknown unit 'rpm' for --input rate, give one of rad/s, deg/s"),
        (
            "x=a;y=b;z=c;unit=deg/s",
            "increment",
            "unknown unit 'deg/s' for --input increment, give one of rad, deg, arcsec, or --input rate, or --input "
            "counts",
        ),
        (
            "x=a;y=b;z=c",
            "rate",
            "no t, the times come from a column t=NAME or from --sample-hz HZ, give one",
        ),
    ],
)
def test_a_bad_columns_option(csv_file: Path, columns: str, kind: str, message: str) -> None:
    assert refusal(csv_file, "a,b,c\n1,2,3\n", kind, columns=columns) == f"--columns: {message}"


@pytest.mark.parametrize("content", ["", "\n \n", "\ufeff"])
def test_an_empty_file(csv_file: Path, content: str) -> None:
    assert refusal(csv_file, content) == "walk.csv: the file is empty, a header line and rows are needed"


def test_a_header_alone(csv_file: Path) -> None:
    assert refusal(csv_file, INCREMENTS) == "walk.csv: no data rows after the header, nothing to replay"


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    for path, reason in ((tmp_path / "none.csv", "No such file or directory"), (tmp_path, "Is a directory")):
        with pytest.raises(UsageError) as caught:
            read_recording(path, "rate")
        assert str(caught.value) == f"{path}: cannot be read, {reason}, give an existing CSV file"


def test_text_that_is_not_utf8(csv_file: Path) -> None:
    assert refusal(csv_file, GOOD.encode() + b"0.04,\xff,1,1\n") == (
        "walk.csv:5: not UTF-8 text (invalid start byte), save the file as UTF-8 CSV"
    )


def test_a_quote_that_never_closes(csv_file: Path) -> None:
    assert refusal(csv_file, INCREMENTS + '0.01,1,2,3\n0.02,"1,2,3\n0.03,1,2,3\n') == (
        "walk.csv:3: not CSV (unexpected end of data), check the quotes of this line"
    )
