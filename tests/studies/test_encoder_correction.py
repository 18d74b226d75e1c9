"""Encoder and tilt correction: exact on exact harmonics, blind to what it cannot see, and clear about bad logs."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from qcone.errors import UsageError
from qcone.reference import rotating_unit
from qcone.reference.euler import from_angles, turn
from qcone.reference.quaternion import error_angle, from_matrix, to_matrix
from qcone.studies.encoder_correction import (
    Harmonic,
    averaged,
    body_attitude,
    correct,
    corrected_angle,
    encoder_difference,
    fit_encoder,
    fit_tilt,
    level,
)
from qcone.studies.encoder_log import EncoderLog

Array = NDArray[np.float64]

ARCSEC = np.deg2rad(1 / 3600)
TURN_RATE = np.deg2rad(360 / 525)  # rad/s
G = 9.8
A, B = 54 * ARCSEC, -51 * ARCSEC
TILT_X, TILT_Y = (9 * ARCSEC, 4 * ARCSEC), (-3 * ARCSEC, 11 * ARCSEC)
PITCH, ROLL = 0.02, -0.01


def to_and_fro(time: Array) -> Array:
    """An encoder angle that goes one turn up in 525 s and one down."""
    phase = np.mod(time, 1050.0)
    return TURN_RATE * np.minimum(phase, 1050.0 - phase)


def exact_log(
    encoder: Array, time: Array, *, drift: float = 7e-5, force_bias: tuple[float, float] = (0.0, 0.0)
) -> EncoderLog:
    """A log whose errors are exactly harmonics of the encoder angle, and whose body stands at PITCH, ROLL."""
    angle = encoder - (A * np.sin(encoder) + B * np.cos(encoder))
    rate = np.concatenate([[0.0], np.diff(angle) / np.diff(time)]) + drift
    tilt_x, tilt_y = (p * np.sin(2 * angle) + q * np.cos(2 * angle) for p, q in (TILT_X, TILT_Y))
    to_body = turn(2, angle) @ turn(0, tilt_x) @ turn(1, tilt_y)
    q_nb = from_angles(np.array([ROLL, PITCH, 0.7]), "zxy")
    up = to_matrix(q_nb)[2]
    force = G * np.einsum("nij,i->nj", to_body, up) + np.array([*force_bias, 0.0])
    return EncoderLog(time, encoder, rate, force, from_matrix(to_matrix(q_nb) @ to_body), "unit.csv")


@pytest.fixture(scope="module")
def exact() -> EncoderLog:
    time = np.arange(0.0, 2100.5, 0.5)
    return exact_log(to_and_fro(time), time)


def one_way(turns: float = 1.3, step: float = 0.5) -> EncoderLog:
    time = np.arange(0.0, 525.0 * turns, step)
    return exact_log(0.4 + TURN_RATE * time, time)


def refused(log: EncoderLog, message: str) -> None:
    for fit in (fit_encoder, fit_tilt, level, encoder_difference):
        with pytest.raises(UsageError, match=re.escape(message)):
            fit(log)


@pytest.mark.parametrize("log", ["exact", "one_way", "part of a period", "fast", "down"])
def test_an_exact_first_harmonic_is_found(log: str, exact: EncoderLog) -> None:
    time = np.arange(0.0, 3000.0)
    logs = {
        "exact": exact,
        "one_way": one_way(),
        "part of a period": exact_log(to_and_fro(time[:1333] + 411.0), time[:1333]),
        "fast": exact_log(2.4 * time, time),  # 137 deg a row
        "down": exact_log(-TURN_RATE * time, time),
    }
    found = fit_encoder(logs[log])
    assert found.sine == pytest.approx(A, abs=1e-4 * ARCSEC)
    assert found.cosine == pytest.approx(B, abs=1e-4 * ARCSEC)
    assert found.residual < 1e-4 * ARCSEC
    assert found.order == 1


def test_the_corrected_angle_is_the_true_one_but_for_a_constant(exact: EncoderLog) -> None:
    truth = exact.encoder_rad - (A * np.sin(exact.encoder_rad) + B * np.cos(exact.encoder_rad))
    assert np.ptp(exact.encoder_rad - truth) > 148 * ARCSEC
    assert np.ptp(corrected_angle(exact, fit_encoder(exact)) - truth) < 1e-4 * ARCSEC
    assert np.array_equal(corrected_angle(exact, None), exact.encoder_rad)


def test_a_wrapped_encoder_is_the_same_encoder(exact: EncoderLog) -> None:
    for log in (exact, one_way(2.2), exact_log(2.4 * np.arange(900.0), np.arange(900.0))):
        wrapped = replace(log, encoder_rad=np.mod(log.encoder_rad, 2 * np.pi))
        assert np.ptp(wrapped.encoder_rad) < 2 * np.pi
        np.testing.assert_allclose(encoder_difference(wrapped), encoder_difference(log), atol=1e-11)


def test_gyro_drift_and_earth_rate_do_not_matter(exact: EncoderLog) -> None:
    for drift in (0.0, 1e-3, -4e-3):
        shifted = replace(exact, rate_z_rad_s=exact.rate_z_rad_s + drift)
        np.testing.assert_allclose(encoder_difference(shifted), encoder_difference(exact), atol=1e-10)


def test_over_whole_periods_the_bias_is_the_mean_of_both_directions(exact: EncoderLog) -> None:
    """rins (7) as printed: half the sum of the mean rates of forward and of reverse rotation."""
    rate = exact.rate_z_rad_s[1:]
    bias = (rate[rate > 0].mean() + rate[rate < 0].mean()) / 2
    assert bias == pytest.approx(7e-5, abs=1e-12)
    gyro = np.concatenate([[0.0], np.cumsum(0.5 * (rate - bias))])
    np.testing.assert_allclose(encoder_difference(exact), exact.encoder_rad - gyro, atol=1e-8)


@pytest.mark.parametrize("given", [None, (PITCH, ROLL)])
def test_an_exact_second_harmonic_of_the_tilt_is_found(exact: EncoderLog, given: tuple[float, float] | None) -> None:
    truth = exact.encoder_rad - (A * np.sin(exact.encoder_rad) + B * np.cos(exact.encoder_rad))
    for found, (sine, cosine) in zip(
        fit_tilt(replace(exact, encoder_rad=truth), None, given), (TILT_X, TILT_Y), strict=True
    ):
        # Second order: tilt times pitch, and the level of the mean force.
        assert found.sine == pytest.approx(sine, abs=0.01 * ARCSEC)
        assert found.cosine == pytest.approx(cosine, abs=0.01 * ARCSEC)
        assert abs(found.offset) < 0.01 * ARCSEC
        assert found.residual < 0.4 * ARCSEC
        assert found.order == 2


def test_the_level_of_the_body_is_the_mean_force(exact: EncoderLog) -> None:
    biased = replace(exact, force_m_s2=exact.force_m_s2 + np.array([1e-3, -2e-3, 0.0]))
    for log in (exact, biased):
        np.testing.assert_allclose(level(log, replace(fit_encoder(log), offset=0.0)), (PITCH, ROLL), atol=0.05 * ARCSEC)


def test_the_corrected_attitude_is_the_bodys(exact: EncoderLog) -> None:
    encoder = fit_encoder(exact)
    truth = np.broadcast_to(from_angles(np.array([ROLL, PITCH, 0.7]), "zxy"), (exact.time_s.size, 4))
    corrected = correct(exact, replace(encoder, offset=0.0), fit_tilt(exact, encoder))
    assert np.max(error_angle(correct(exact), truth)) > 70 * ARCSEC
    assert np.max(error_angle(correct(exact, replace(encoder, offset=0.0)), truth)) > 8 * ARCSEC
    assert np.max(error_angle(corrected, truth)) < 0.05 * ARCSEC


def test_the_rotations_are_those_of_the_paper() -> None:
    """rins (5), (10), (11) as matrices, and (12) for small tilts."""
    angle, x, y = np.array([0.3, -2.0]), np.array([0.02, -0.3]), np.array([-0.05, 0.4])
    q_ns = from_angles(np.array([[0.1, 0.2, 0.3], [-0.4, 0.5, 2.0]]), "zxy")
    c = to_matrix(q_ns) @ np.swapaxes(turn(1, y), -1, -2) @ np.swapaxes(turn(0, x), -1, -2)
    c = c @ np.swapaxes(turn(2, angle), -1, -2)
    np.testing.assert_allclose(to_matrix(body_attitude(q_ns, angle, x, y)), c, atol=1e-15)
    tilt = np.stack([x, y], axis=-1)
    np.testing.assert_allclose(
        rotating_unit.body_attitude(q_ns, angle, tilt), body_attitude(q_ns, angle, x, y), atol=1e-15
    )
    dx, dy = 3e-5, -4e-5
    identity = np.array([[1.0, 0.0, 0.0, 0.0]])
    small = to_matrix(body_attitude(identity, np.zeros(1), np.array([dx]), np.array([dy])))[0]
    np.testing.assert_allclose(small, [[1, 0, -dy], [0, 1, dx], [dy, -dx, 1]], atol=2e-9)


def test_an_accelerometer_bias_passes_for_a_constant_tilt(exact: EncoderLog) -> None:
    """What no log can tell apart: 50 ug read as 10 arcsec of tilt, which the correction would put into pitch."""
    biased = replace(exact, force_m_s2=exact.force_m_s2 + np.array([0.0, 50e-6 * G, 0.0]))
    encoder = fit_encoder(biased)
    tilt_x, tilt_y = fit_tilt(biased, encoder)
    assert tilt_x.offset == pytest.approx(50e-6, rel=1e-2)
    truth = np.broadcast_to(from_angles(np.array([ROLL, PITCH, 0.7]), "zxy"), (exact.time_s.size, 4))
    angle_only = replace(encoder, offset=0.0)
    spoilt = correct(biased, angle_only, (tilt_x, tilt_y))
    mended = correct(biased, angle_only, (replace(tilt_x, offset=0.0), replace(tilt_y, offset=0.0)))
    assert np.max(error_angle(spoilt, truth)) == pytest.approx(50e-6, rel=0.02)
    assert np.max(error_angle(mended, truth)) < 0.1 * ARCSEC


def test_averaging_sees_below_the_pulses_and_lags_nowhere() -> None:
    quantum, time = 2 * np.pi / 20000, np.arange(10501) / 10
    log, inside = exact_log(to_and_fro(time), time), slice(50, -50)
    pulses = replace(log, encoder_rad=quantum * np.floor(log.encoder_rad / quantum))
    assert np.ptp(pulses.encoder_rad - log.encoder_rad) > 60 * ARCSEC
    for coarse in (pulses, replace(pulses, encoder_rad=np.mod(pulses.encoder_rad, 2 * np.pi))):
        error = averaged(coarse, 10.0).encoder_rad - log.encoder_rad
        assert np.ptp(error[inside]) < 10 * ARCSEC
        assert np.ptp(error) < 20 * ARCSEC
    error = np.abs(averaged(log, 10.0).encoder_rad - log.encoder_rad)[inside]
    steady = np.abs(time[inside] - 525.0) > 5.0
    assert np.max(error[steady]) < 0.1 * ARCSEC
    # The error of the encoder turns back with it: its slope there, over half a window.
    assert np.max(error) == pytest.approx(abs(A) * TURN_RATE * 2.5, rel=0.05)
    flat = averaged(log, 1e6).encoder_rad - log.encoder_rad + encoder_difference(log)
    assert np.ptp(flat) < 1e-9
    np.testing.assert_allclose(averaged(log, 0.01).encoder_rad, log.encoder_rad, atol=1e-12)


@pytest.mark.parametrize("seconds", [0.0, -1.0, np.nan, np.inf])
def test_a_window_must_be_a_time(exact: EncoderLog, seconds: float) -> None:
    with pytest.raises(
        UsageError, match=re.escape(f"unit.csv: a window of {seconds:g} s holds no row, give a positive")
    ):
        averaged(exact, seconds)


def test_less_than_a_full_turn_is_refused() -> None:
    refused(one_way(0.9), "unit.csv: no full turn, the encoder covers 323.7 deg, the harmonics need angles of all 360")
    time = np.arange(0.0, 2000.0)
    half = exact_log(0.45 * to_and_fro(time), time)  # much travelled, never around
    refused(half, "no full turn, the encoder covers 162 deg")
    still = replace(half, encoder_rad=np.full(2000, 1.0), rate_z_rad_s=np.zeros(2000))
    refused(still, "no full turn, the encoder covers 0 deg")


def test_exactly_one_turn_of_samples_is_enough() -> None:
    log = one_way(1.0)
    assert np.ptp(log.encoder_rad) < 2 * np.pi
    assert fit_encoder(log).sine == pytest.approx(A, abs=1e-3 * ARCSEC)


def test_fewer_rows_than_unknowns_are_refused() -> None:
    time = np.arange(3.0)
    refused(exact_log(2.5 * time, time), "unit.csv: fewer rows than unknowns, 3 given for 4 (sine, cosine, offset and")
    refused(exact_log(2.5 * time[:1], time[:1]), "fewer rows than unknowns, 1 given")
    empty = np.zeros(0)
    refused(
        EncoderLog(empty, empty, empty, np.zeros((0, 3)), source="none.csv"), "none.csv: fewer rows than unknowns, 0"
    )


@pytest.mark.parametrize("step", [2 * np.pi, np.pi])
def test_angles_that_are_all_alike_make_a_singular_fit(step: float) -> None:
    time = np.arange(40.0)
    log = exact_log(0.3 + step * time, time)
    for fit in (fit_encoder, fit_tilt):
        with pytest.raises(
            UsageError, match=re.escape("unit.csv: the fit is singular, the encoder angles are too alike")
        ):
            fit(log) if fit is fit_encoder else fit(log, None, (PITCH, ROLL))


def test_a_quarter_of_a_turn_a_row_fits_the_angle_but_not_the_tilt() -> None:
    time = np.arange(40.0)
    log = exact_log(0.3 + np.pi / 2 * time, time)
    assert fit_encoder(log).cosine == pytest.approx(B, abs=1e-3 * ARCSEC)
    with pytest.raises(
        UsageError, match=re.escape("the fit is singular, the encoder angles are too alike to tell its 3")
    ):
        fit_tilt(log)


@pytest.mark.parametrize("column", ["time_s", "encoder_rad", "rate_z_rad_s", "force_m_s2", "q_ns"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_numbers_that_are_not_finite_are_refused_with_their_row(exact: EncoderLog, column: str, value: float) -> None:
    damaged: Any = np.array(getattr(exact, column))
    damaged[41:43, ...] = value
    log = replace(exact, **{column: damaged})
    message = f"unit.csv: row 42: {column} is not a finite number (2 of 4201 rows), no row is left out unasked"
    refused(log, message)
    with pytest.raises(UsageError, match=re.escape(message)):
        correct(log)


def test_columns_of_unlike_length_are_refused(exact: EncoderLog) -> None:
    message = "unit.csv: encoder_rad has shape (4200,), the 4201 rows of time_s need (4201,), give every column"
    refused(replace(exact, encoder_rad=exact.encoder_rad[1:]), message)
    refused(replace(exact, force_m_s2=exact.force_m_s2[:, :2]), "force_m_s2 has shape (4201, 2), the 4201 rows")
    refused(replace(exact, q_ns=exact.force_m_s2), "q_ns has shape (4201, 3)")


def test_irregular_time_is_refused_with_its_row(exact: EncoderLog) -> None:
    late = exact.time_s.copy()
    late[100:] += 0.006
    refused(replace(exact, time_s=late), "unit.csv: row 101: irregular time step, 0.506 s where the median is 0.5 s")
    late[100:] -= 0.002
    assert fit_encoder(replace(exact, time_s=late)).order == 1
    back = exact.time_s.copy()
    back[7] = back[6]
    refused(replace(exact, time_s=back), "unit.csv: row 8: time does not increase, 3.0 s comes after 3.0 s")


def test_an_encoder_against_the_gyro_is_refused(exact: EncoderLog) -> None:
    refused(replace(exact, encoder_rad=-exact.encoder_rad), "unit.csv: the encoder turns -1 times what the gyro does")
    degrees = replace(exact, rate_z_rad_s=np.rad2deg(exact.rate_z_rad_s - 7e-5))
    refused(degrees, "the encoder turns 0.0175 times what the gyro does, which is its reference")
    refused(replace(exact, rate_z_rad_s=0.0 * exact.rate_z_rad_s), "the encoder turns 0 times what the gyro does")


def test_force_that_is_not_gravity_is_refused(exact: EncoderLog) -> None:
    for force in (-exact.force_m_s2, exact.force_m_s2[:, [2, 0, 1]], 0.0 * exact.force_m_s2):
        with pytest.raises(UsageError, match=r"unit.csv: the mean specific force is \S+ of \S+ m/s2 along z"):
            fit_tilt(replace(exact, force_m_s2=force))


def test_without_the_sensors_attitude_there_is_no_body_attitude(exact: EncoderLog) -> None:
    log = replace(exact, q_ns=None)
    with pytest.raises(
        UsageError, match=re.escape("unit.csv: no attitude of the sensor frame, the body's attitude is")
    ):
        correct(log, fit_encoder(log))


def test_a_harmonic_is_what_it_says() -> None:
    found = Harmonic(sine=2.0, cosine=3.0, offset=0.5, order=2, residual=0.0).at(np.array([0.0, np.pi / 4, np.pi / 2]))
    np.testing.assert_allclose(found, [3.5, 2.5, -2.5], atol=1e-15)


def test_a_log_is_left_as_it_was(exact: EncoderLog) -> None:
    before = {name: np.array(getattr(exact, name)) for name in ("time_s", "encoder_rad", "rate_z_rad_s", "force_m_s2")}
    correct(averaged(exact, 5.0), fit_encoder(exact), fit_tilt(exact))
    for name, values in before.items():
        assert np.array_equal(getattr(exact, name), values)
