"""Recordings: exact reading, real files, clocks, cutting into updates, the declared rate."""

from __future__ import annotations

import math
import time
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from refusing import refusal

from qcone.errors import UsageError
from qcone.studies.recording import Recording, max_rate_dps, read_recording, split_updates

INCREMENTS = "t_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad\n"
RATES = "t_s,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s\n"
FUSION = "t=Time (s);x=Gyroscope X (deg/s);y=Gyroscope Y (deg/s);z=Gyroscope Z (deg/s);unit=deg/s"  # own names
GOOD = INCREMENTS + "0.01,1e-3,2e-3,3e-3\n0.02,4e-3,5e-3,6e-3\n0.03,7e-3,8e-3,9e-3\n"


@pytest.fixture
def csv_file(tmp_path: Path) -> Path:
    return tmp_path / "walk.csv"


# --- what is read -------------------------------------------------------------------------------------------


def test_increments_are_read_exactly_and_extra_columns_are_ignored(csv_file: Path) -> None:
    csv_file.write_text(
        "temperature, dtheta_z_rad ,dtheta_x_rad,t_s,dtheta_y_rad,note\n"
        "20,0.3,0.1,0.01,0.2,warm\n\n20,-0.6,-0.4,0.02,-0.5,\n"
    )
    recording = read_recording(csv_file, "increment")
    assert recording.values.tolist() == [[0.1, 0.2, 0.3], [-0.4, -0.5, -0.6]]
    assert recording.time_s.tolist() == [0.01, 0.02]
    assert (recording.kind, recording.sample_hz, recording.notes) == ("increment", 100, ())


@given(
    values=arrays(np.float64, (4, 3), elements=st.floats(-1e99, 1e99)),
    step=st.sampled_from([0.001, 0.0035, 0.01, 1 / 3]),
)
def test_reading_gives_back_the_float64_written(
    tmp_path_factory: pytest.TempPathFactory, values: np.ndarray, step: float
) -> None:
    path = tmp_path_factory.mktemp("round") / "trip.csv"
    times = step * np.arange(1, 5)
    rows = np.column_stack((times, values)).tolist()
    path.write_text(INCREMENTS + "".join(",".join(f"{cell:.17g}" for cell in row) + "\n" for row in rows))
    recording = read_recording(path, "increment")
    assert recording.values.tobytes() == values.tobytes()
    assert recording.time_s.tobytes() == times.tobytes()


def test_sixty_thousand_rows_take_well_under_a_second(csv_file: Path) -> None:
    rng = np.random.default_rng(1)
    rows = np.column_stack((0.001 * np.arange(1, 60_001), rng.normal(size=(60_000, 3)))).tolist()
    csv_file.write_text(INCREMENTS + "".join(",".join(map(repr, row)) + "\n" for row in rows))
    start = time.process_time()
    recording = read_recording(csv_file, "increment")
    assert time.process_time() - start < 0.8
    assert recording.values.shape == (60_000, 3)


# --- real recordings ----------------------------------------------------------------------------------------


def test_broad_reads_as_it_is(recordings: Path) -> None:
    recording = read_recording(recordings / "broad07_fast_rotation.csv", "rate")
    assert recording.values.shape == (8572, 3)
    assert recording.time_s[0] == -0.003
    assert recording.sample_hz == Fraction(2000, 7)
    assert recording.values[0].tolist() == [14.43051, -0.9704851, -0.8117561]
    assert max_rate_dps(recording) == 1100  # 18.725 rad/s


def test_fusion_is_irregular_and_resamples(recordings: Path) -> None:
    path = recordings / "fusion_sensor_data.csv"
    with pytest.raises(
        UsageError, match=r":10: data row 9: irregular step, 7\.5593 ms where the median step is 10\.0794"
    ):
        read_recording(path, "rate", columns=FUSION)
    recording = read_recording(path, "rate", columns=FUSION, resample_hz=100)
    assert recording.sample_hz == 100
    assert recording.notes == ("resampled to 100 Hz from irregular steps (7.56 .. 30.2 ms)",)
    np.testing.assert_allclose(np.diff(recording.time_s), 0.01, rtol=1e-9)
    assert max_rate_dps(recording) == 370


def test_imucal_has_no_time_column(recordings: Path) -> None:
    recording = read_recording(
        recordings / "imucal_session.csv", "rate", columns="x=gyr_x;y=gyr_y;z=gyr_z;unit=deg/s", sample_hz=100
    )
    assert recording.values.shape == (10376, 3)
    assert recording.time_s[:3].tolist() == [0.0, 0.01, 0.02]
    counts = np.rad2deg(recording.values) * 32768 / 2000
    assert np.max(np.abs(counts - np.rint(counts))) < 1e-9


# --- the clock ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("step", "decimals", "hz"),
    [
        (Fraction(1, 100), 6, Fraction(100)),
        (Fraction(7, 2000), 6, Fraction(2000, 7)),
        (Fraction(1, 1000), 17, Fraction(1000)),
        (Fraction(1, 3), 17, Fraction(3)),
        (Fraction(5, 2), 3, Fraction(2, 5)),
        (Fraction(3600), 3, Fraction(1, 3600)),
        (Fraction(100_000), 3, Fraction(1, 100_000)),
    ],
)
def test_the_rate_is_the_fraction_behind_the_times(csv_file: Path, step: Fraction, decimals: int, hz: Fraction) -> None:
    rows = "".join(f"{float(k * step - 3):.{decimals}f},1,2,3\n" for k in range(50))
    csv_file.write_text(RATES + rows)
    assert read_recording(csv_file, "rate").sample_hz == hz


def test_times_with_few_digits_do_not_bias_the_rate(csv_file: Path) -> None:
    rows = "".join(f"{k / 3000:.6f},1,2,3\n" for k in range(3001))  # steps of 333 and 334 us
    csv_file.write_text(RATES + rows)
    assert abs(read_recording(csv_file, "rate").sample_hz / 3000 - 1) < 1e-6


@pytest.mark.parametrize(("slip", "step"), [(0.000101, "10.101"), (-0.000101, "9.899"), (0.03, "40")])
def test_more_than_one_percent_names_the_first_row(csv_file: Path, slip: float, step: str) -> None:
    times = 0.01 * np.arange(20)
    times[7:] += slip
    times[12:] += slip
    text = RATES + "".join(f"{t:.9f},1,2,3\n" for t in times.tolist())
    assert refusal(csv_file, text, "rate") == (
        f"walk.csv:9: data row 8: irregular step, {step} ms where the median step is 10 ms (1 % is allowed), "
        f"give --resample HZ to interpolate, or --sample-hz HZ if only the times are off"
    )


def test_sample_hz_overrules_the_time_column_but_for_its_origin(csv_file: Path) -> None:
    csv_file.write_text(RATES + "5,1,2,3\nbad,1,2,3\n1,1,2,3\n")
    recording = read_recording(csv_file, "rate", sample_hz=8)
    assert recording.time_s.tolist() == [5.0, 5.125, 5.25]
    assert recording.sample_hz == 8
    assert recording.notes == ("times follow --sample-hz 8, column 't_s' gives only the first",)


@pytest.mark.parametrize(("kind", "times"), [("increment", [0.125, 0.25]), ("rate", [0.0, 0.125])])
def test_without_times_the_motion_starts_at_zero(csv_file: Path, kind: str, times: list[float]) -> None:
    names = {"increment": INCREMENTS, "rate": RATES}[kind].removeprefix("t_s,")
    csv_file.write_text(names + "1,2,3\n4,5,6\n")
    recording = read_recording(csv_file, kind, sample_hz=8)
    assert recording.time_s.tolist() == times
    assert recording.notes == ()


def test_sample_hz_is_the_decimal_written(csv_file: Path) -> None:
    csv_file.write_text(GOOD)
    assert read_recording(csv_file, "increment", sample_hz=285.714).sample_hz == Fraction("285.714")


@pytest.mark.parametrize("second", ["0.01", "0.005"])
@pytest.mark.parametrize("options", [{}, {"resample_hz": 100}])
def test_time_that_does_not_increase(csv_file: Path, second: str, options: dict[str, float]) -> None:
    text = INCREMENTS + f"0.01,1,2,3\n{second},1,2,3\n0.03,1,2,3\n"
    assert refusal(csv_file, text, **options) == (
        f"walk.csv:3: data row 2: time does not increase, {second} s comes after 0.01 s, sort or remove "
        f"rows, or give --sample-hz HZ if they are evenly sampled"
    )


def test_one_row_needs_a_rate(csv_file: Path) -> None:
    row = INCREMENTS + "0.01,1,2,3\n"
    assert refusal(csv_file, row) == ("walk.csv: one row has no step to take the rate from, give --sample-hz HZ")
    assert read_recording(csv_file, "increment", sample_hz=100).values.tolist() == [[1, 2, 3]]


def test_steps_that_cannot_be_seconds(csv_file: Path) -> None:
    text = RATES + "".join(f"{k}e-12,1,2,3\n" for k in range(5))
    assert refusal(csv_file, text, "rate") == ("walk.csv: steps of 1e-12 s are not usable, are the times in seconds?")


@pytest.mark.parametrize("hz", [0, -1, math.nan, math.inf, 1e-7, 2e9])
@pytest.mark.parametrize(("name", "option"), [("sample_hz", "--sample-hz"), ("resample_hz", "--resample")])
def test_a_bad_rate_option(csv_file: Path, hz: float, name: str, option: str) -> None:
    assert refusal(csv_file, GOOD, **{name: hz}) == (
        f"{option}: {hz} is not a usable rate, give Hz from 1e-06 to 1e+09"
    )


def test_an_unknown_kind(csv_file: Path) -> None:
    assert refusal(csv_file, GOOD, "angles") == ("--input: 'angles' is not known, give one of increment, rate, counts")


# --- cutting into updates -----------------------------------------------------------------------------------


def sampled(kind: str, rows: int, hz: int = 100) -> Recording:
    """Rows whose values say which row and axis they are."""
    values = np.arange(3.0 * rows).reshape(rows, 3)
    return Recording(kind, np.arange(1, rows + 1) / hz, values, Fraction(hz), ("first",), "walk.csv")


@pytest.mark.parametrize("subsamples", [1, 2, 3, 6])
@pytest.mark.parametrize("kind", ["increment", "rate"])
def test_updates_take_their_rows_in_order(kind: str, subsamples: int) -> None:
    start = int(kind == "rate")
    recording = sampled(kind, 4 * subsamples + start)
    updates = split_updates(recording, subsamples)
    assert updates.values.shape == (4, subsamples, 3)
    np.testing.assert_array_equal(updates.values.reshape(-1, 3), recording.values[start:])
    for k in range(4):
        assert updates.time_s[k] == recording.time_s[start + (k + 1) * subsamples - 1]
    assert updates.notes == ("first",)
    if kind == "rate":
        assert updates.start is not None
        assert updates.start.tolist() == recording.values[0].tolist()
    else:
        assert updates.start is None


@pytest.mark.parametrize(("kind", "rows"), [("increment", 8), ("rate", 9)])
def test_rows_left_over_are_dropped_with_a_note(kind: str, rows: int) -> None:
    updates = split_updates(sampled(kind, rows), 3)
    assert updates.values.shape == (2, 3, 3)
    assert len(updates.time_s) == 2
    assert updates.notes == (
        "first",
        f"2 of {rows} rows left over at the end and dropped: an update takes 3",
    )


@pytest.mark.parametrize(
    ("kind", "rows", "takes"), [("increment", 2, "3"), ("rate", 3, "4 (3 and the one it starts from)")]
)
def test_fewer_rows_than_one_update(kind: str, rows: int, takes: str) -> None:
    with pytest.raises(UsageError) as caught:
        split_updates(sampled(kind, rows), 3)
    assert str(caught.value) == (
        f"walk.csv: fewer rows than one update, {rows} given and one update takes {takes}, give a longer "
        f"recording or a smaller --subsamples"
    )


# --- the declared rate --------------------------------------------------------------------------------------


def one_sample(kind: str, value: list[float], hz: Fraction) -> Recording:
    return Recording(kind, np.array([0.0]), np.array([value]), hz)


@pytest.mark.parametrize(
    ("dps", "declared"),
    [
        (573, 580),
        (580, 580),
        (580.001, 590),
        (99.0, 99),
        (99.01, 100),
        (100, 100),
        (0.0123, Fraction(13, 1000)),
        (2000, 2000),
        (2001, 2100),
    ],
)
def test_the_largest_norm_rounds_up_to_two_digits(dps: float, declared: Fraction) -> None:
    rate = math.radians(dps)
    assert max_rate_dps(one_sample("rate", [0.0, -0.6 * rate, 0.8 * rate], Fraction(7))) == declared
    assert max_rate_dps(one_sample("increment", [rate / 400, 0.0, 0.0], Fraction(400))) == declared


@given(norm=st.floats(1e-6, 1e6))
def test_the_declared_rate_is_no_less_and_barely_more(norm: float) -> None:
    declared = max_rate_dps(one_sample("rate", [norm, 0.0, 0.0], Fraction(1)))
    true = math.degrees(norm)
    assert declared * (1 + Fraction(1, 10**14)) >= true
    assert declared <= Fraction(true) * Fraction(11, 10) * (1 + Fraction(1, 10**14))
    digits = f"{float(declared):.15e}".split("e")[0].rstrip("0").replace(".", "")
    assert len(digits) <= 2


def test_the_largest_of_all_rows_counts_and_stillness_declares_one() -> None:
    values = np.array([[1.0, 0, 0], [0, -3.0, 4.0], [2.0, 2, 2]])
    recording = Recording("rate", np.arange(3.0), values, Fraction(1))
    assert max_rate_dps(recording) == 290  # 5 rad/s = 286.5 deg/s
    assert max_rate_dps(one_sample("rate", [0.0, 0.0, 0.0], Fraction(1))) == 1
