"""Resampling: order of accuracy, exactness on cubics, gaps, and what is said about it."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from qcone.errors import UsageError
from qcone.studies.recording import read_recording
from qcone.studies.resample import even_rate, first_irregular, resample


def jittered(count: int, step: float, share: float = 0.2) -> NDArray[np.float64]:
    """Increasing times from 0 whose steps vary by up to twice `share`."""
    times = step * (np.arange(count) + share * np.random.default_rng(5).uniform(-1, 1, count))
    return times - times[0]


def smooth(t: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([np.sin(3 * t), np.cos(2 * t + 1), np.exp(-t) * np.sin(4 * t)], axis=1)


def smooth_angle(t: NDArray[np.float64]) -> NDArray[np.float64]:
    """The integral of `smooth` from 0."""
    decaying = (4 - np.exp(-t) * (np.sin(4 * t) + 4 * np.cos(4 * t))) / 17
    return np.stack([(1 - np.cos(3 * t)) / 3, (np.sin(2 * t + 1) - np.sin(1)) / 2, decaying], axis=1)


def largest_error(kind: str, count: int, hz: int = 97) -> float:
    """Resample two seconds of the smooth motion in `count` uneven steps; return the largest error."""
    knots = jittered(count + 1, 2 / count)
    if kind == "rate":
        times, values, _ = resample("smooth", kind, knots, smooth(knots), Fraction(hz))
        return float(np.max(np.abs(values - smooth(times))))
    first = float(np.median(np.diff(knots[1:])))  # what the first increment is taken to last
    knots = np.concatenate(([knots[1] - first], knots[1:]))
    increments = np.diff(smooth_angle(knots), axis=0)
    times, values, _ = resample("smooth", kind, knots[1:], increments, Fraction(hz))
    edges = np.concatenate(([times[0] - 1 / hz], times))
    return float(np.max(np.abs(values - np.diff(smooth_angle(edges), axis=0))))


@pytest.mark.parametrize("kind", ["rate", "increment"])
def test_the_error_falls_with_the_fourth_power_of_the_step(kind: str) -> None:
    errors = np.array([largest_error(kind, count) for count in (100, 200, 400, 800)])
    slopes = np.log2(errors[:-1] / errors[1:])
    mean_order = np.log2(errors[0] / errors[-1]) / 3
    assert 3.7 < mean_order < 4.3, (errors, slopes)


def test_the_stated_bound_holds_and_is_not_loose() -> None:
    step, frequency = 0.01, 20.0
    knots = step * np.arange(101)
    signal = np.repeat(np.sin(frequency * knots)[:, np.newaxis], 3, axis=1)
    times, values, _ = resample("sine", "rate", knots, signal, Fraction(1700))
    error = np.abs(values[:, 0] - np.sin(frequency * times))
    scale = (step * frequency) ** 4
    inside = (times > step) & (times < 0.99)
    assert 0.9 * 3 / 128 * scale < error[inside].max() <= 3 / 128 * scale
    assert 3 / 128 * scale < error[~inside].max() <= 1 / 24 * scale


@given(coefficients=st.lists(st.floats(-10, 10), min_size=4, max_size=4), seed=st.integers(0, 99))
def test_cubics_are_reproduced(coefficients: list[float], seed: int) -> None:
    knots = np.cumsum(np.random.default_rng(seed).uniform(0.5, 1.5, 12))
    cubic = np.polynomial.Polynomial(coefficients, domain=[knots[0], knots[-1]])
    values = np.stack([cubic(knots), -cubic(knots), 0 * knots], axis=1)
    times, got, _ = resample("cubic", "rate", knots, values, Fraction(7))
    np.testing.assert_allclose(got[:, 0], cubic(times), atol=1e-11)
    np.testing.assert_allclose(got[:, 1], -cubic(times), atol=1e-11)


def test_samples_that_lie_on_the_grid_are_kept_as_they_are() -> None:
    knots = np.array([0.0, 0.25, 0.375, 0.5, 1.0, 1.25])
    values = np.random.default_rng(2).normal(size=(6, 3))
    times, got, _ = resample("grid", "rate", knots, values, Fraction(8))
    assert times.tolist() == [k / 8 for k in range(11)]
    for knot, value in zip(knots, values, strict=True):
        np.testing.assert_array_equal(got[round(8 * knot)], value)


def test_increments_keep_the_whole_angle() -> None:
    rng = np.random.default_rng(3)
    steps = np.full(500, 0.01)
    steps[100:200:2] += 0.003
    steps[101:200:2] -= 0.003
    times = 4.0 + np.cumsum(steps)  # 5 s from 4 s: 250 steps of 20 ms end with the last row
    increments = rng.normal(size=(500, 3))
    at, got, _ = resample("angle", "increment", times, increments, Fraction(50))
    np.testing.assert_allclose(at, 4.0 + 0.02 * np.arange(1, 251), rtol=1e-12)
    np.testing.assert_allclose(got.sum(axis=0), increments.sum(axis=0), atol=1e-9)
    np.testing.assert_allclose(got[0], increments[:2].sum(axis=0), atol=1e-9)


# --- gaps ---------------------------------------------------------------------------------------------------


def with_gap() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Ten steps of 10 ms, a gap of 120 ms after data row 5, noise on every sample."""
    times = 0.01 * np.arange(10)
    times[5:] += 0.11
    return times, np.random.default_rng(7).normal(size=(10, 3))


def test_a_gap_is_bridged_by_a_straight_line_and_no_cubic_reaches_over_it() -> None:
    times, values = with_gap()
    at, got, _ = resample("gap", "rate", times, values, Fraction(1000))
    inside = (at > times[4]) & (at < times[5])
    assert inside.sum() > 100
    for axis in range(3):
        np.testing.assert_allclose(got[inside, axis], np.interp(at[inside], times, values[:, axis]), atol=1e-12)
    moved = values.copy()
    moved[5:] += 100.0
    _, other, _ = resample("gap", "rate", times, moved, Fraction(1000))
    before = at <= times[4]
    np.testing.assert_array_equal(other[before], got[before])
    assert not np.array_equal(other[inside], got[inside])


@pytest.mark.parametrize(
    ("kind", "filled"),
    [
        ("rate", "filled by a straight line"),
        ("increment", "the increment after it is taken to cover it"),
    ],
)
def test_a_gap_is_said_with_its_place(kind: str, filled: str) -> None:
    times, values = with_gap()
    _, _, notes = resample("gap", kind, times, values, Fraction(100))
    assert notes == (
        "resampled to 100 Hz from irregular steps (10 .. 120 ms)",
        f"gap of 120 ms (12 median steps) between data rows 5 and 6, 0.04 .. 0.16 s: {filled}",
    )


def test_many_gaps_are_counted() -> None:
    times = 0.01 * np.arange(60)
    for first in range(10, 60, 10):
        times[first:] += 0.1
    _, _, notes = resample("gaps", "rate", times, np.zeros((60, 3)), Fraction(100))
    assert [note[:3] for note in notes] == ["res", "gap", "gap", "gap", "2 m"]
    assert notes[-1] == "2 more gaps after these, 5 in all"


def test_a_step_of_five_medians_is_not_a_gap() -> None:
    times = np.array([0.0, 1.0, 2.0, 3.0, 8.0, 9.0, 10.0])
    _, _, notes = resample("five", "rate", times, np.zeros((7, 3)), Fraction(1))
    assert notes == ("resampled to 1 Hz from irregular steps (1e+03 .. 5e+03 ms)",)


# --- remarks and refusals -----------------------------------------------------------------------------------


def test_bunched_steps_are_said() -> None:
    times = np.array([0.0, 0.01, 0.02, 0.03, 0.031, 0.04, 0.05])
    _, _, notes = resample("bunched", "rate", times, np.zeros((7, 3)), Fraction(100))
    assert notes[1:] == (
        "steps are bunched (shortest 1 ms, median 10 ms): a cubic magnifies noise there; if the sensor "
        "sampled evenly, give --sample-hz instead",
    )


def test_thinned_rates_are_said_to_fold_but_increments_keep_the_angle() -> None:
    times = 0.01 * np.arange(1, 101)
    _, _, notes = resample("thin", "rate", times, np.zeros((100, 3)), Fraction(40))
    assert notes == (
        "resampled to 40 Hz from regular steps (10 .. 10 ms)",
        "40 Hz keeps fewer than half of the rates: motion faster than 20 Hz is not filtered out but folded",
    )
    _, _, notes = resample("thin", "increment", times, np.zeros((100, 3)), Fraction(40))
    assert notes == ("resampled to 40 Hz from regular steps (10 .. 10 ms)",)


def test_too_many_rows_are_refused_before_they_are_made() -> None:
    times = np.array([0.0, 0.01, 0.02, 1e6])
    with pytest.raises(UsageError) as caught:
        resample("walk.csv", "rate", times, np.zeros((4, 3)), Fraction(100))
    assert str(caught.value) == (
        "walk.csv: resampling 1e+06 s to 100 Hz makes 100000000 rows, more than 10000000 are not taken, "
        "give a lower --resample or look for a jump in the time column"
    )


def test_one_row_has_no_step() -> None:
    with pytest.raises(UsageError) as caught:
        resample("walk.csv", "rate", np.zeros(1), np.zeros((1, 3)), Fraction(100))
    assert str(caught.value) == "walk.csv: one row cannot be resampled, it has no step, drop --resample"


def test_two_and_three_samples_take_a_line_and_a_parabola() -> None:
    line = np.repeat([[1.0], [3.0]], 3, axis=1)
    _, got, _ = resample("two", "rate", np.array([0.0, 1.0]), line, Fraction(4))
    assert got[:, 0].tolist() == [1.0, 1.5, 2.0, 2.5, 3.0]
    knots = np.array([0.0, 1.0, 2.0])
    square = np.repeat((knots**2)[:, np.newaxis], 3, axis=1)
    times, got, _ = resample("three", "rate", knots, square, Fraction(4))
    np.testing.assert_allclose(got[:, 2], times**2, atol=1e-15)


@pytest.mark.parametrize("hz", [Fraction(100), Fraction(2000, 7), Fraction(1, 3), Fraction("99.123456789012")])
def test_the_grid_ends_where_the_recording_does(hz: Fraction) -> None:
    times = np.array([float(k / hz) for k in range(1000)])
    at, _, _ = resample("end", "rate", times, np.zeros((1000, 3)), hz)
    assert at.size == 1000
    np.testing.assert_allclose(at, times, rtol=4e-16)


def test_the_recording_carries_the_remarks_of_both_options(tmp_path: Path) -> None:
    path = tmp_path / "walk.csv"
    path.write_text("t_s,gyr_x_rad_s,gyr_y_rad_s,gyr_z_rad_s\n5,1,2,3\n5,1,2,3\n5,1,2,3\n")
    recording = read_recording(path, "rate", sample_hz=10, resample_hz=20)
    assert recording.sample_hz == 20
    np.testing.assert_allclose(recording.time_s, [5.0, 5.05, 5.1, 5.15, 5.2])
    assert recording.notes == (
        "times follow --sample-hz 10, column 't_s' gives only the first",
        "resampled to 20 Hz from regular steps (100 .. 100 ms)",
    )


@pytest.mark.parametrize("offset", [0.0, -0.003, 1.7e9, -1.7e9])
@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("step", [0.01, 0.003])
def test_one_percent_off_is_regular_wherever_the_clock_starts(step: float, side: int, offset: float) -> None:
    for percent, row in ((1.0, None), (1.05, 41)):
        steps = np.full(99, step)
        steps[40] *= 1 + side * percent / 100
        times = np.concatenate(([0.0], np.cumsum(steps)))
        assert first_irregular(offset + times) == row


def test_regularity_is_judged_by_the_median() -> None:
    assert first_irregular(np.array([3.0])) is None
    assert first_irregular(0.0035 * np.arange(100) - 0.003) is None
    assert first_irregular(np.array([0.0, 9.0, 10.0, 11.0])) == 1
    assert even_rate(np.array([0.0, 0.25, 0.5])) == 4
