from __future__ import annotations

import dataclasses
import re

import numpy as np
import pytest

from qcone.reference import euler, quaternion, rotating_unit
from qcone.reference.rotating_unit import ARCSEC, Imperfections, Record

EPS = np.finfo(np.float64).eps
PERFECT = Imperfections(
    encoder=(),
    encoder_offset=0.0,
    encoder_noise=0.0,
    tilt_x=(),
    tilt_y=(),
    gyro_drift=(0.0, 0.0, 0.0),
    accelerometer_noise=0.0,
)


def fit(angle: np.ndarray, harmonic: int, values: np.ndarray) -> np.ndarray:
    """Coefficients of sine, cosine and 1 by least squares; rins (13), (14), (16)."""
    rows = np.stack([np.sin(harmonic * angle), np.cos(harmonic * angle), np.ones_like(angle)], axis=-1)
    return np.linalg.lstsq(rows, values, rcond=None)[0]


def gyro_angle(record: Record) -> np.ndarray:
    """The turn by the gyro, its drift and the earth taken out by turning both ways; rins (6), (7)."""
    forward = np.mod(record.time - 1e-6, rotating_unit.PERIOD)[1:] < rotating_unit.PERIOD / 2
    rate = record.gyro[1:, 2]
    bias = (rate[forward].mean() + rate[~forward].mean()) / 2
    return np.concatenate([[0.0], np.cumsum((rate - bias) * np.diff(record.time))])


def peak_to_peak(record: Record, angle: np.ndarray, tilt: np.ndarray) -> np.ndarray:
    """Of roll, pitch and azimuth extracted with `angle` and `tilt`, in arcsec."""
    body = rotating_unit.body_attitude(record.sensor_attitude, angle, tilt)
    error = euler.to_angles(body, "zxy") - euler.to_angles(record.body_attitude, "zxy")
    return np.ptp(error, axis=0) / ARCSEC


@pytest.mark.parametrize(
    ("readout", "before", "after"),
    [("ideal", 160, 19.9), ("raw", 222, 81), ("x4", 173, 33.5), ("averaged", 156, None)],
)
def test_corrections_gain_what_is_published(readout: str, before: float, after: float | None) -> None:
    record = rotating_unit.simulate(readout)
    level = np.zeros_like(record.tilt)
    coefficients = fit(record.encoder, 1, record.encoder - gyro_angle(record))
    np.testing.assert_allclose(coefficients / ARCSEC, [54, -51, 18], atol=0.4)
    corrected = rotating_unit.corrected_angle(record.encoder, tuple(coefficients))
    ideal = rotating_unit.body_attitude(record.body_attitude, -corrected, level)  # C_b^n C_s'^b
    up = np.swapaxes(quaternion.to_matrix(ideal), -1, -2)[..., 2] * rotating_unit.GRAVITY
    residual = record.specific_force - up
    tilt = np.stack([residual[:, 1], -residual[:, 0]], axis=-1) / rotating_unit.GRAVITY  # rins (9)
    second = fit(corrected, 2, tilt).T
    np.testing.assert_allclose(second / ARCSEC, [[13.6, 0, 0], [0, 13.6, 0]], atol=0.1)
    raw = peak_to_peak(record, record.encoder, level)
    better = peak_to_peak(record, corrected, rotating_unit.modelled_tilt(corrected, second))
    # Roll and pitch from 27..30 to under 5, whatever the encoder; azimuth hangs on it. How much quantisation an average
    # leaves depends on how samples fall on pulses: there only the 30 arcsec of the claim bind.
    assert np.all((raw[:2] > 27) & (raw[:2] < 30))
    assert np.all((better[:2] > 2) & (better[:2] < 3.1))
    assert raw[2] == pytest.approx(before, rel=0.02)
    if after is not None:
        assert better[2] == pytest.approx(after, rel=0.03)
    assert bool(better[2] < 30) is (readout in ("ideal", "averaged"))


def test_perfect_unit_gives_its_body_attitude_back() -> None:
    record = rotating_unit.simulate(imperfections=PERFECT)
    np.testing.assert_array_equal(record.encoder, record.angle)
    np.testing.assert_array_equal(record.tilt, 0)
    body = rotating_unit.body_attitude(record.sensor_attitude, record.encoder, record.tilt)
    assert quaternion.error_angle(body, record.body_attitude).max() < 4 * EPS
    angles = euler.to_angles(record.body_attitude, "zxy")
    np.testing.assert_allclose(angles, np.broadcast_to([0.004, -0.003, 0.7], angles.shape), atol=4 * EPS)
    assert np.abs(gyro_angle(record) - record.angle).max() < 1e-9


def test_the_unit_turns_four_times_to_and_fro() -> None:
    record = rotating_unit.simulate(rate_hz=1.0)
    assert record.time[0] == 0
    assert record.time[-1] == 4200
    np.testing.assert_array_equal(np.diff(record.time), 1)
    for column in (record.encoder, record.gyro, record.specific_force, record.angle, record.tilt):
        assert len(column) == 4201
    at = {0: 0, 262.5: 0.5, 525: 1, 787.5: 0.5, 1050: 0, 1575: 1, 4200: 0}
    turns = rotating_unit.true_angle(np.array([*at])) / (2 * np.pi)
    np.testing.assert_allclose(turns, [*at.values()], atol=EPS)
    rate = np.rad2deg(record.gyro[1:, 2])
    np.testing.assert_allclose(np.abs(rate), 360 / 525, atol=0.005)
    assert np.count_nonzero(np.diff(np.sign(rate))) == 7


def test_gyro_is_the_earth_the_turn_and_the_tilt() -> None:
    record = rotating_unit.simulate(imperfections=dataclasses.replace(Imperfections(), gyro_drift=(0.0, 0.0, 0.0)))
    turned = quaternion.from_rotation_vector(record.gyro[1:] / 10)
    earth = rotating_unit.EARTH_RATE * np.array([0.0, np.cos(0.7), np.sin(0.7)])
    step = quaternion.from_rotation_vector(earth / 10)
    carried = quaternion.product(record.sensor_attitude[:-1], turned)
    expected = quaternion.product(step, record.sensor_attitude[1:])
    assert quaternion.error_angle(carried, expected).max() < 8 * EPS
    drifting = rotating_unit.simulate(imperfections=dataclasses.replace(PERFECT, gyro_drift=(1e-6, 2e-6, 3e-6)))
    ideal = rotating_unit.simulate(imperfections=PERFECT)
    np.testing.assert_allclose(
        drifting.gyro - ideal.gyro, np.broadcast_to([1e-6, 2e-6, 3e-6], ideal.gyro.shape), atol=1e-15
    )


def test_specific_force_is_gravity_in_tilted_axes() -> None:
    """rins (9): a level frame tilted by delta sees -delta_y and +delta_x of gravity."""
    unit = dataclasses.replace(Imperfections(), accelerometer_noise=0.0)
    record = rotating_unit.simulate(attitude=(0.0, 0.0, 1.0), imperfections=unit)
    g = rotating_unit.GRAVITY
    expected = g * np.stack([-record.tilt[:, 1], record.tilt[:, 0], np.ones(len(record.time))], axis=-1)
    np.testing.assert_allclose(record.specific_force, expected, atol=1e-7)
    assert np.ptp(record.specific_force[:, 0]) / g == pytest.approx(2 * 14 * ARCSEC, rel=0.1)
    noisy = rotating_unit.simulate(attitude=(0.0, 0.0, 1.0)).specific_force - record.specific_force
    assert noisy.std() == pytest.approx(20e-6 * g, rel=0.02)
    biased = dataclasses.replace(unit, accelerometer_bias=(1e-3, -2e-3, 3e-3))
    shift = rotating_unit.simulate(attitude=(0.0, 0.0, 1.0), imperfections=biased).specific_force
    np.testing.assert_allclose(shift - record.specific_force, np.tile([1e-3, -2e-3, 3e-3], (len(shift), 1)), atol=1e-14)


def test_encoder_is_quantised_as_its_read_out_says() -> None:
    records = {name: rotating_unit.simulate(name) for name in ("ideal", "raw", "x4", "averaged")}
    ideal = records["ideal"].encoder
    error = ideal - records["ideal"].angle
    assert np.ptp(error) / ARCSEC == pytest.approx(160, abs=3)
    for name, pulses in (("raw", 20000), ("x4", 80000)):
        quantum = 2 * np.pi / pulses
        counts = records[name].encoder / quantum
        np.testing.assert_allclose(counts, np.rint(counts), atol=1e-9)
        np.testing.assert_allclose(np.abs(records[name].encoder - ideal).max(), quantum / 2, rtol=1e-3)
    past = records["raw"].encoder - records["raw"].angle
    averaged = records["averaged"].encoder - records["averaged"].angle
    expected = np.convolve(past, np.full(100, 0.01), mode="valid")
    np.testing.assert_allclose(averaged[99:], expected, atol=1e-12)
    assert np.std(averaged[:99] - error[:99]) < 8 * ARCSEC  # the first ten seconds have a past


def test_records_are_seeded() -> None:
    first, again, other = (rotating_unit.simulate("raw", seed=seed, rate_hz=2.0) for seed in (3, 3, 4))
    for field in dataclasses.fields(Record):
        np.testing.assert_array_equal(getattr(first, field.name), getattr(again, field.name))
    assert np.any(first.encoder != other.encoder)
    assert np.any(first.specific_force != other.specific_force)
    np.testing.assert_array_equal(first.angle, other.angle)
    np.testing.assert_array_equal(rotating_unit.simulate("ideal", seed=3, rate_hz=2.0).gyro, first.gyro)
    noisy = rotating_unit.simulate(seed=3, imperfections=dataclasses.replace(PERFECT, gyro_noise=1e-6))
    quiet = rotating_unit.simulate(seed=3, imperfections=PERFECT)
    assert (noisy.gyro - quiet.gyro).std() == pytest.approx(1e-6, rel=0.02)


def test_tilt_turns_x_then_y() -> None:
    """C_s's = Ry(tilt_y)^T Rx(tilt_x)^T and C_bs' = Rz(angle)^T; rins (5), (11)."""
    angle, tilt = 0.7, np.array([0.02, -0.03])
    c_bs = quaternion.to_matrix(rotating_unit.sensor_turn(np.array(angle), tilt))  # from sensor to body
    expected = euler.turn(1, tilt[1]).T @ euler.turn(0, tilt[0]).T @ euler.turn(2, angle).T
    np.testing.assert_allclose(c_bs.T, expected, atol=2 * EPS)
    small = np.array([[1, 0, 0.03], [0, 1, 0.02], [-0.03, -0.02, 1]])  # rins (12): [[1,0,-y],[0,1,x],[y,-x,1]]
    c_s = quaternion.to_matrix(rotating_unit.sensor_turn(np.array(0.0), tilt)).T
    np.testing.assert_allclose(c_s, small, atol=1e-3)


REFUSED = {
    "readout is 'best', choose ideal, raw, x4 or averaged": lambda: rotating_unit.simulate("best"),
    "rate_hz is 0.3, half a period of 525.0 s must hold whole samples": lambda: rotating_unit.simulate(rate_hz=0.3),
    "rate_hz is 0.0, half a period of 525.0 s must hold whole samples": lambda: rotating_unit.simulate(rate_hz=0.0),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_does_not_exist_is_refused(message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        REFUSED[message]()
