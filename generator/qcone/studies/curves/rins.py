"""rins figures 6, 8, 13, 15, 16 and 18: a rotating unit before and after its corrections, simulated."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from qcone.reference.euler import to_angles
from qcone.reference.quaternion import Array
from qcone.reference.rotating_unit import simulate
from qcone.studies.claims.claim import Settings
from qcone.studies.claims.rins import rate_of
from qcone.studies.curves.figure import Curve, Figure, Level, Panel
from qcone.studies.encoder_correction import averaged, encoder_difference, fit_encoder, fit_tilt
from qcone.studies.encoder_readouts import ARCSEC, WINDOW, log_of
from qcone.studies.unit_firmware import firmware_attitude

POINTS = 840
UNIT = "simulated unit, 20000 pulses a turn averaged over 10 s"
TIME, ANGLE = "time, s", "encoder angle, deg"
ARCMIN = 60 * ARCSEC
ROLL, PITCH, AZIMUTH = 0, 1, 2


@dataclass(frozen=True)
class Unit:
    """What the figures show, (n, ...) in rad and s: errors are roll, pitch, azimuth, tilts about x and y."""

    time: Array
    angle: Array
    difference: Array
    difference_fit: Array
    tilt: Array
    tilt_fit: Array
    before: Array
    after: Array


@cache
def _unit(settings: Settings) -> Unit:
    record = simulate("raw", seed=settings.seed, rate_hz=rate_of(settings))
    log = averaged(log_of(record), WINDOW)
    encoder = fit_encoder(log)
    tilt = fit_tilt(log, encoder)
    force = log.force_m_s2
    gravity = float(np.mean(np.linalg.norm(force, axis=1)))
    mean_x, mean_y = _level_part(force[:, 0], log.encoder_rad), _level_part(force[:, 1], log.encoder_rad)
    raw_tilt = np.stack([(force[:, 1] - mean_y) / gravity, -(force[:, 0] - mean_x) / gravity], axis=-1)
    every = slice(None, None, max(len(record.time) // POINTS, 1))
    errors = []
    for q in (firmware_attitude(log), firmware_attitude(log, encoder, tilt)):
        error = to_angles(q, "zxy") - to_angles(record.body_attitude, "zxy")
        wrapped = np.mod(error + np.pi, 2 * np.pi) - np.pi
        errors.append((wrapped - wrapped.mean(axis=0))[every])
    fitted = np.stack([each.at(log.encoder_rad) for each in tilt], axis=-1)
    return Unit(
        record.time[every],
        np.mod(log.encoder_rad, 2 * np.pi)[every],
        encoder_difference(log)[every],
        encoder.at(log.encoder_rad)[every],
        _smooth(raw_tilt, len(record.time))[every],
        fitted[every],
        *errors,
    )


def _level_part(force: Array, angle: Array) -> Array:
    """Return the part of a horizontal force that pitch and roll of the standing body explain: the first harmonic."""
    rows = np.column_stack([np.sin(angle), np.cos(angle)])
    part: Array = rows @ np.linalg.lstsq(rows, force, rcond=None)[0]
    return part


def _smooth(values: Array, rows: int) -> Array:
    """Return the mean over 10 s or so of each column, for the eye: noise of 20 ug is 4 arcsec."""
    width = max(rows // 420, 1)
    kernel = np.full(width, 1 / width)
    whole = np.convolve(np.ones(rows), kernel, mode="same")
    return np.stack([np.convolve(column, kernel, mode="same") / whole for column in values.T], axis=-1)


def attitude_errors(settings: Settings) -> Figure:
    """Return figure 6: attitude errors of the turning unit, before any correction."""
    unit = _unit(settings)
    panels = tuple(_error_panel(unit, axis, corrected=False) for axis in (PITCH, ROLL, AZIMUTH))
    return Figure("rins_fig6", f"rins fig. 6: attitude errors while turning; {UNIT}", 1, panels)


def encoder_errors(settings: Settings) -> Figure:
    """Return figure 8: encoder angle less the gyro's integral, against time."""
    unit = _unit(settings)
    curves = (
        Curve("encoder - gyro", unit.time, unit.difference / ARCMIN, ".", 0),
        Curve("first harmonic fitted", unit.time, unit.difference_fit / ARCMIN, "-", 1),
    )
    said = "rins: repeats in every period, amplitude 1 to 2 arcmin"
    panels = (Panel("encoder angle error", TIME, "error, arcmin", curves, note=said),)
    return Figure("rins_fig8", f"rins fig. 8: encoder angle less integrated rate; {UNIT}", 1, panels)


def encoder_fit(settings: Settings) -> Figure:
    """Return figure 13: the encoder error against the angle, and its fit."""
    unit = _unit(settings)
    order = np.argsort(unit.angle)
    degrees = np.rad2deg(unit.angle[order])
    residual = (unit.difference - unit.difference_fit)[order] / ARCSEC
    curves = (
        Curve("encoder - gyro", degrees, unit.difference[order] / ARCMIN, ".", 0),
        Curve("first harmonic fitted", degrees, unit.difference_fit[order] / ARCMIN, "-", 1),
    )
    left = (Curve("residual", degrees, residual, ".", 2),)
    said = (Level(20, "rins: residual less than 20 arcsec"), Level(-20, ""))
    panels = (
        Panel("encoder angle error", ANGLE, "error, arcmin", curves, note="rins: first harmonic of the angle"),
        Panel("what the fit leaves", ANGLE, "residual, arcsec", left, levels=said),
    )
    return Figure("rins_fig13", f"rins fig. 13: encoder angle error; {UNIT}", 2, panels)


def azimuth(settings: Settings) -> Figure:
    """Return figure 15: the azimuth error before and after."""
    panels = (_error_panel(_unit(settings), AZIMUTH, corrected=True),)
    return Figure("rins_fig15", f"rins fig. 15: azimuth before and after the correction; {UNIT}", 1, panels)


def tilt_angles(settings: Settings) -> Figure:
    """Return figure 16: the tilt of the turning sensors against the angle, and its fit."""
    unit = _unit(settings)
    order = np.argsort(unit.angle)
    degrees = np.rad2deg(unit.angle[order])
    panels = []
    for axis, name in enumerate("xy"):
        curves = (
            Curve("from accelerometers, 10 s mean", degrees, unit.tilt[order, axis] / ARCSEC, ".", 0),
            Curve("second harmonic fitted", degrees, unit.tilt_fit[order, axis] / ARCSEC, "-", 1),
        )
        said = "rins: second harmonic, at most about 30 arcsec" if axis == 0 else ""
        panels.append(Panel(f"tilt about {name}", ANGLE, f"delta {name}, arcsec", curves, note=said))
    return Figure("rins_fig16", f"rins fig. 16: tilt of the turning sensors; {UNIT}", 2, tuple(panels))


def pitch_and_roll(settings: Settings) -> Figure:
    """Return figure 18: pitch and roll errors before and after."""
    unit = _unit(settings)
    panels = tuple(_error_panel(unit, axis, corrected=True) for axis in (PITCH, ROLL))
    return Figure("rins_fig18", f"rins fig. 18: pitch and roll before and after the correction; {UNIT}", 1, panels)


def _error_panel(unit: Unit, axis: int, corrected: bool) -> Panel:
    name = ("roll", "pitch", "azimuth")[axis]
    scale, label = (ARCMIN, "arcmin") if axis == AZIMUTH else (ARCSEC, "arcsec")
    swing = [float(np.ptp(each[:, axis])) / scale for each in (unit.before, unit.after)]
    curves = [Curve(f"before, {swing[0]:.2g} {label} peak to peak", unit.time, unit.before[:, axis] / scale, "-", 0)]
    first, then = (
        ("2 to 3 arcmin", "less than 0.5 arcmin") if axis == AZIMUTH else ("20 to 30 arcsec", "less than 5 arcsec")
    )
    said = f"rins: swings by {first}"
    levels: tuple[Level, ...] = ()
    if corrected:
        after = f"after, {swing[1]:.2g} {label} peak to peak"
        curves.append(Curve(after, unit.time, unit.after[:, axis] / scale, "-", 1))
        band = 0.25 if axis == AZIMUTH else 2.5
        levels = (Level(band, f"rins: {then} peak to peak"), Level(-band, ""))
    return Panel(name, TIME, f"{name} error, {label}", tuple(curves), levels=levels, note=said)


FIGURES = (attitude_errors, encoder_errors, encoder_fit, azimuth, tilt_angles, pitch_and_roll)
