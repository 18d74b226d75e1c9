"""The papers' algorithms on the command line: an order too low, a rate that is missing, errors propagated."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from given import everything, rows_of

LOW = """\
[design.low]
algorithm = "dcm-taylor"
subsamples = 4
order = 7
imu = { update_hz = 100, max_rate_dps = 573 }
number = { format = "float32" }
"""
WARNING = (
    "warning: design '{}': order = {} drops second-order terms of the fit through {} sub-samples: use order >= {}\n"
)

RATES = "t_s,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s\n" + "".join(f"{k / 100},0.1,{k / 50},0\n" for k in range(6))
INCREMENTS = RATES.replace("gyr", "dtheta").replace("rad_s", "rad")
REPLAY = ("replay", "a.csv", "--algorithm", "adams-moulton-4", "--number", "float64", "-o", "o.csv")


@pytest.mark.parametrize("words", [("generate",), ("generate", "--dry-run"), ("verify", "--rows", "8"), ("counts",)])
def test_an_order_too_low_is_warned_of(run, tmp_path: Path, words: tuple[str, ...]) -> None:
    """The result is given all the same; an order of twice the sub-samples is not warned of."""
    (tmp_path / "low.toml").write_text(LOW)
    result = run(words[0], "low.toml", *words[1:])
    assert (result.exit_code, result.stderr) == (0, WARNING.format("low", 7, 4, 8))
    assert "low" in result.stdout
    (tmp_path / "low.toml").write_text(LOW.replace("7", "8", 1))
    assert run(words[0], "low.toml", *words[1:]).stderr == ""


@pytest.mark.parametrize("command", ["counts", "explain"])
@pytest.mark.parametrize("algorithm", ["quaternion-taylor", "dcm-taylor"])
def test_an_order_too_low_is_warned_of_among_options(run, command: str, algorithm: str) -> None:
    result = run(command, algorithm, "--subsamples", "3", "--order", "5")
    assert result.exit_code == 0
    assert result.stderr == WARNING.format({"counts": "counted", "explain": "explained"}[command], 5, 3, 6)


def test_the_caution_stands_in_the_header_too(run, tmp_path: Path) -> None:
    (tmp_path / "low.toml").write_text(LOW)
    run("generate", "low.toml")
    header = (tmp_path / "c_out" / "low" / "src" / "low.h").read_text()
    assert "caution:     order = 7 drops second-order terms" in header


def test_adams_moulton_of_increments_is_refused(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(INCREMENTS)
    result = run(*REPLAY, "--max-rate-dps", "573")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == (
        "command line: error QC207: design 'replayed': adams-moulton-4-runge-kutta-4 takes rates, the design has "
        'input = "increment", it evaluates the rate at instants, the newest at the end of the interval, set input = '
        '"rate" and give it rates (replay: --input rate)\n'
    )
    assert sorted(everything(tmp_path)) == ["a.csv"]


def test_adams_moulton_without_the_look_ahead_rate_is_refused(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("\n".join(RATES.splitlines()[:2]) + "\n")
    result = run(*REPLAY, "--input", "rate", "--sample-hz", "100", "--max-rate-dps", "573")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "1 given and one update takes 2 (1 and the one it starts from)" in result.stderr
    assert sorted(everything(tmp_path)) == ["a.csv"]


def test_an_irregular_step_is_refused(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(RATES.replace("0.04,", "0.043,"))
    result = run(*REPLAY, "--input", "rate", "--max-rate-dps", "573")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "a.csv:6: data row 5: irregular step, 13 ms where the median step is 10 ms" in result.stderr
    assert sorted(everything(tmp_path)) == ["a.csv"]


HELD = "note: the starter holds the attitude for the first 2 updates"


@pytest.mark.parametrize(
    ("rows", "more"), [(5, ""), (2, ", more than the recording makes: it has no attitude of its own")]
)
def test_updates_that_hold_the_attitude_are_told(run, tmp_path: Path, rows: int, more: str) -> None:
    (tmp_path / "a.csv").write_text("\n".join(RATES.splitlines()[: rows + 2]) + "\n")
    result = run(*REPLAY, "--input", "rate", "--max-rate-dps", "573")
    assert (result.exit_code, result.stdout, result.stderr) == (0, "", f"{HELD}{more}\n")
    written = (tmp_path / "o.csv").read_text().splitlines()[1:]
    assert len(written) == rows
    assert [row.partition(",")[2] == "1,0,0,0" for row in written] == [True, True, *[False] * (rows - 2)]
    assert HELD not in run(*REPLAY, "--starter", "heun", "--input", "rate", "--max-rate-dps", "573").stderr


ACCURACY = [
    *("case", "motion", "size", "unit", "predicted", "simulated", "ratio", "deviation", "with_products", "holds"),
    *("paper", "reason"),
]


def test_rows_of_accuracy(run) -> None:
    """The additive model follows small errors; of a large misalignment alone it is exact, of large rate errors not."""
    rows = rows_of(run, "accuracy")
    assert {tuple(row) for row in rows} == {tuple(ACCURACY)}
    holds = {(row["case"], row["size"]): row["holds"] for row in rows}
    assert holds["gyro bias", 1e-3]
    assert holds["scale error", 1e-3]
    assert holds["misalignment", 2.5]
    assert not holds["gyro bias", 1e-1]
    assert not holds["scale error", 1e-1]
    assert all(bool(row["reason"]) is not row["holds"] for row in rows)
    assert all(row["with_products"] < 1e-7 for row in rows)


def test_accuracy_at_another_frequency(run) -> None:
    usual, faster = (rows_of(run, "accuracy", *words) for words in ((), ("--frequency-hz", "10")))
    assert [row["simulated"] for row in usual] != [row["simulated"] for row in faster]
    for wrong in ("0", "-1", "25.5", "nan"):
        result = run("accuracy", "--frequency-hz", wrong)
        assert (result.exit_code, result.stdout) == (2, "")
        assert result.stderr == (
            f"--frequency-hz {float(wrong):g}: steps of 2.5 ms follow a motion of up to 25 Hz; give more than 0 and at "
            "most 25\n"
        )


def test_explain_names_equations_and_exact_numbers(run) -> None:
    words = ("explain", "rotation-vector", "--subsamples", "3", "--coefficients", "taylor", "--format", "json")
    rows = json.loads(run(*words).stdout)["rows"]
    assert {tuple(row) for row in rows} == {("part", "equation", "text")}
    said = {row["text"]: row["equation"] for row in rows}
    assert said["k_13 = 33/80"].startswith("phi = S + sum")
    assert "xu2019 (2)" in said.values()
    assert [*dict.fromkeys(row["part"] for row in rows)] == [
        *("algorithm", "derivation", "as written", "factored", "error", "erratum")
    ]
