"""Recordings that cannot be replayed: the file, the line, what is wrong and what to do; nothing written."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from given import GOOD, everything

HEADER = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad\n"
REPLAY = (
    "replay",
    "a.csv",
    "--algorithm",
    "rotation-vector",
    "--subsamples",
    "2",
    "--number",
    "float64",
    "-o",
    "o.csv",
)
EVEN = HEADER + "".join(f"{0.01 * k:.2f},0,0,0.001\n" for k in range(1, 6))

RECORDINGS = {
    "a missing column": (
        "t_s,dtheta_x_rad,dtheta_y_rad\n0.01,0,0\n0.02,0,0\n",
        "a.csv:1: no column 'dtheta_z_rad', the columns are 't_s', 'dtheta_x_rad', 'dtheta_y_rad', map the names with "
        "--columns\n",
    ),
    "the columns of the other kind": (
        "t_s,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s\n0,0,0,0\n",
        "a.csv:1: no columns 'dtheta_x_rad', 'dtheta_y_rad', 'dtheta_z_rad', the columns are 't_s', 'gyr_x_rad_s', "
        "'gyr_y_rad_s', 'gyr_z_rad_s', these are columns of --input rate\n",
    ),
    "a NaN": (
        HEADER + "0.01,0,0,0\n0.02,nan,0,0\n0.03,0,0,0\n",
        "a.csv:3: data row 2, column 'dtheta_x_rad': 'nan' is not a finite number below 1e+100 in size, every sample "
        "counts, remove the row or mend it\n",
    ),
    "a time that stands still": (
        HEADER + "0.01,0,0,0\n0.02,0,0,0\n0.02,0,0,0\n0.03,0,0,0\n",
        "a.csv:4: data row 3: time does not increase, 0.02 s comes after 0.02 s, sort or remove rows, or give "
        "--sample-hz HZ if they are evenly sampled\n",
    ),
    "a time that goes back": (
        HEADER + "0.01,0,0,0\n0.03,0,0,0\n0.02,0,0,0\n",
        "a.csv:4: data row 3: time does not increase, 0.02 s comes after 0.03 s, sort or remove rows, or give "
        "--sample-hz HZ if they are evenly sampled\n",
    ),
    "an irregular step": (
        HEADER + "0.01,0,0,0\n0.02,0,0,0\n0.035,0,0,0\n0.045,0,0,0\n0.055,0,0,0\n",
        "a.csv:4: data row 3: irregular step, 15 ms where the median step is 10 ms (1 % is allowed), give --resample "
        "HZ to interpolate, or --sample-hz HZ if only the times are off\n",
    ),
    "a gap": (
        HEADER + "0.01,0,0,0\n0.02,0,0,0\n0.03,0,0,0\n0.5,0,0,0\n0.51,0,0,0\n",
        "a.csv:5: data row 4: irregular step, 470 ms where the median step is 10 ms (1 % is allowed), give --resample "
        "HZ to interpolate, or --sample-hz HZ if only the times are off\n",
    ),
    "no rows": (HEADER, "a.csv: no data rows after the header, nothing to replay\n"),
    "nothing at all": ("", "a.csv: the file is empty, a header line and rows are needed\n"),
}


@pytest.mark.parametrize("what", RECORDINGS)
def test_bad_recording(run, tmp_path: Path, what: str) -> None:
    text, message = RECORDINGS[what]
    (tmp_path / "a.csv").write_text(text)
    result = run(*REPLAY)
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", message)
    assert sorted(everything(tmp_path)) == ["a.csv"]


def test_fewer_rows_than_one_update(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(HEADER + "0.01,0,0,0.001\n0.02,0,0,0.001\n")
    result = run(*REPLAY, "--subsamples", "3")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == (
        "note: declared rate taken from the data: --max-rate-dps 5.8\n"
        "a.csv: fewer rows than one update, 2 given and one update takes 3, give a longer recording or a smaller "
        "--subsamples\n"
    )
    assert sorted(everything(tmp_path)) == ["a.csv"]


@pytest.mark.parametrize("what", ["an irregular step", "a gap"])
def test_resample_takes_what_is_irregular(run, tmp_path: Path, what: str) -> None:
    (tmp_path / "a.csv").write_text(RECORDINGS[what][0])
    result = run(*REPLAY, "--resample", "100")
    assert (result.exit_code, result.stdout) == (0, "")
    assert "note: resampled to 100 Hz from irregular steps" in result.stderr
    assert (tmp_path / "o.csv").read_text().startswith("t_s,q0,q1,q2,q3\n")


NOTE = "note: declared rate taken from the data: --max-rate-dps 5.8\n"
OPTIONS = {
    "no number format": (("--number",), (), "--number: say the number format, float32 or float64\n"),
    "no output": (("-o",), (), f"{NOTE}-o OUT.csv says where the attitude is to be written\n"),
    "no algorithm": (
        ("--algorithm",),
        (),
        "give --algorithm ID with its parameters, or --design FILE.toml:NAME, one of the two\n",
    ),
    "algorithm and design": (
        (),
        ("--design", "good.toml:good"),
        "give --algorithm ID with its parameters, or --design FILE.toml:NAME, one of the two\n",
    ),
    "an update rate": (
        (),
        ("--update-hz", "50"),
        "--update-hz: a recording's own rate decides; give --sample-hz to overrule its time column\n",
    ),
    "three numbers": ((), ("--initial", "1,0,0"), f"{NOTE}--initial 1,0,0: write four numbers, w,x,y,z\n"),
    "no unit quaternion": (
        (),
        ("--initial", "2,0,0,0"),
        f"{NOTE}--initial: w,x,y,z must be a unit quaternion, its length is 2\n",
    ),
    "an unknown unit": (
        (),
        ("--columns", "x=dtheta_x_rad;y=dtheta_y_rad;z=dtheta_z_rad;unit=rpm"),
        "--columns: unknown unit 'rpm' for --input increment, give one of rad, deg, arcsec\n",
    ),
    "a rate of nothing": (
        (),
        ("--sample-hz", "0"),
        "--sample-hz: 0.0 is not a usable rate, give Hz from 1e-06 to 1e+09\n",
    ),
    "seven sub-samples": (
        (),
        ("--subsamples", "7"),
        f"{NOTE}--subsamples: error QC105: `--subsamples 7` is not allowed, the choice is 1 to 6\n",
    ),
    "coefficients for one sub-sample": (
        (),
        ("--subsamples", "1", "--coefficients", "coning"),
        f"{NOTE}--coefficients: error QC107: coefficients belong to two or more sub-samples, with subsamples = 1 there "
        "is no pair of increments to weigh, leave the key out\n",
    ),
    "a folder that is not there": (
        (),
        ("-o", "nowhere/o.csv"),
        f"{NOTE}note: 1 of 5 rows left over at the end and dropped: an update takes 2\n"
        "nowhere/o.csv: cannot be written, No such file or directory, give -o a file in a folder that exists and is "
        "writable\n",
    ),
}


@pytest.mark.parametrize("what", OPTIONS)
def test_bad_replay_option(run, good: Path, tmp_path: Path, what: str) -> None:
    left_out, added, message = OPTIONS[what]
    (tmp_path / "a.csv").write_text(EVEN)
    words = list(REPLAY)
    for option in left_out:
        at = words.index(option)
        del words[at : at + 2]
    result = run(*words, *added)
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", message)
    assert sorted(everything(tmp_path)) == ["a.csv", "good.toml"]


DESIGNS = {
    ("--design", "good.toml"): "--design good.toml: write FILE.toml:NAME\n",
    ("--design", "good.toml:goood"): "--design goood: no such design in good.toml; did you mean 'good'?\n",
    ("--design", "good.toml:good"): (
        "a.csv: 100 samples a second, but design 'good' is made for 200: resample with --resample 200, or change "
        "update_hz\n"
    ),
    ("--design", "good.toml:good", "--subsamples", "2"): (
        "--subsamples 2: the design file decides; leave the option out\n"
    ),
}


@pytest.mark.parametrize("words", DESIGNS, ids=" ".join)
def test_design_that_does_not_suit(run, good: Path, tmp_path: Path, words: tuple[str, ...]) -> None:
    (tmp_path / "a.csv").write_text(EVEN)
    result = run("replay", "a.csv", *words, "-o", "o.csv")
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", DESIGNS[words])
    assert sorted(everything(tmp_path)) == ["a.csv", "good.toml"]


def test_file_that_is_not_there(run) -> None:
    result = run(*REPLAY)
    assert result.exit_code == 2
    assert result.stderr == "a.csv: cannot be read, No such file or directory, give an existing CSV file\n"


def test_replay_compared_with_the_model(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(EVEN)
    result = run(*REPLAY, "--compare")
    assert (result.exit_code, result.stdout) == (0, "")
    assert result.stderr.endswith("note: 0 differing bits against the bit-true model in 2 updates\n")
    rows = (tmp_path / "o.csv").read_text().splitlines()
    assert [row.partition(",")[0] for row in rows] == ["t_s", "0.02", "0.040000000000000001"]


@pytest.mark.usefixtures("flipped_bit")
def test_replay_that_differs_from_the_model_is_a_failed_check(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(EVEN)
    result = run(*REPLAY, "--compare")
    assert (result.exit_code, result.stdout) == (1, "")
    assert re.search(r"^\d+ bits differ: lane 0, step 1, quaternion z: C ", result.stderr, re.MULTILINE)
    assert sorted(everything(tmp_path)) == ["a.csv"]


def test_several_designs_are_compared_in_a_table(run, tmp_path: Path) -> None:
    fast = GOOD.replace("update_hz = 100", "update_hz = 50")
    (tmp_path / "two.toml").write_text(fast + fast.replace("design.good", "design.wide").replace("float32", "float64"))
    (tmp_path / "a.csv").write_text(EVEN)
    result = run("replay", "a.csv", "--design", "two.toml:good", "--design", "two.toml:wide", "--format", "csv")
    assert result.exit_code == 0
    lines = result.stdout.splitlines()
    assert lines[0] == "design,updates,compared,largest_deg,final_deg,differing_bits"
    assert [line.split(",")[:3] for line in lines[1:]] == [["good", "2", "2"], ["wide", "2", "2"]]
    assert lines[1].endswith(",0,0,")


def test_beyond_the_declared_rate_is_said(run, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(EVEN)
    result = run(*REPLAY, "--max-rate-dps", "3")
    assert result.exit_code == 0
    assert (
        "the recording reaches 0.001 rad, design 'replayed' declares 0.0005236: accuracy is lost there" in result.stderr
    )
