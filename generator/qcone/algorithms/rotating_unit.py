"""The rotating unit: correct the encoder's angle and the tilt of the turning sensors, and give the body's attitude.

rins (10) to (16). The sensor frame s turns by the encoder's angle al about z of the body b; s' is the ideal rotation
frame, s the actual one: v_s' = Rz(al)^T v_b and v_s = Ry(delta_y)^T Rx(delta_x)^T v_s'. A harmonic is its three
coefficients: those of sine and cosine, and the offset.
"""

from __future__ import annotations

from qcone.ir.real import (
    F,
    Quaternion,
    Scalar,
    named,
    quaternion,
    sine_cosine,
    sine_cosine_of_small,
    step,
    vector,
    within,
)

ABOVE_ONE = F(129, 128)
"""What no component of an attitude exceeds, roundings included."""
Harmonic = tuple[Scalar, Scalar, Scalar]


def correction(al: Scalar, azimuth: Harmonic, tilt_x: Harmonic, tilt_y: Harmonic) -> tuple[Scalar, Scalar, Scalar]:
    """Write the corrected angle and the tilts about x and y of an encoder's angle of at most 3 pi in size, rad.

    The tilts belong to the corrected angle: its sine and cosine are those of al turned back by the small error.
    """
    sine, cosine = sine_cosine(al)
    sine = named("sin_al", sine)
    cosine = step("cos_al = cos al, with sin_al = sin al: al folded to [0, pi/4], polynomials", "", cosine)
    error = step("error = A sin al + B cos al + C", "rins (13)", _at(azimuth, sine, cosine))
    corrected = step("al_corr = al - error", "rins (15)", al - error)
    small_sine, small_cosine = sine_cosine_of_small(error)
    small_sine = named("sin_error", small_sine)
    small_cosine = step("cos_error = cos(error), with sin_error: as far as so small an angle needs", "", small_cosine)
    sine_corrected = named("sin_corr", sine * small_cosine - cosine * small_sine)
    cosine_corrected = step("cos_corr = cos(al - error), with sin_corr", "", cosine * small_cosine + sine * small_sine)
    doubled = sine_corrected + sine_corrected
    twice_sine = named("sin_2al", doubled * cosine_corrected)
    twice_cosine = step("cos_2al = cos 2al_corr, with sin_2al", "", 1 - doubled * sine_corrected)
    delta_x = step("delta_x = A2 sin 2al + B2 cos 2al + C2", "rins (16)", _at(tilt_x, twice_sine, twice_cosine))
    delta_y = step("delta_y = A2 sin 2al + B2 cos 2al + C2", "rins (16)", _at(tilt_y, twice_sine, twice_cosine))
    return corrected, delta_x, delta_y


def _at(harmonic: Harmonic, sine: Scalar, cosine: Scalar) -> Scalar:
    a, b, c = harmonic
    return a * sine + b * cosine + c


def body_attitude(q_ns: Quaternion, al: Scalar, delta_x: Scalar, delta_y: Scalar) -> Quaternion:
    """Write q_nb = q_ns (x) q_sb of the corrected angle and the tilts, rad: C_b^n = C_s^n C_s'^s C_b^s'(al)."""
    sx, cx = _half("x", delta_x)
    sy, cy = _half("y", delta_y)
    w, x, y, z = named("tilt_w", cy * cx), named("tilt_x", cy * sx), named("tilt_y", sy * cx), named("tilt_z", sy * sx)
    z = step("tilt_z = sin_y sin_x; C_s'^s as [tilt_w, -tilt_x, -tilt_y, -tilt_z]", "rins (11)", z)
    sine, cosine = sine_cosine(F(1, 2) * al)
    sine = named("sin_half", sine)
    cosine = step("cos_half = cos(al/2), with sin_half: al/2 folded to [0, pi/4], polynomials", "", cosine)
    turned = quaternion(
        w * cosine - z * sine, vector(y * sine - x * cosine, -(y * cosine + x * sine), -(z * cosine + w * sine))
    )
    q_sb = step("q_sb = C_s'^s C_b^s' = [tilt_w, -tilt_x, ...] (x) [cos_half, 0, 0, -sin_half]", "rins (5)", turned)
    w, x, y, z = (within(part, -ABOVE_ONE, ABOVE_ONE) for part in q_ns.times(q_sb))
    return step("q_nb = q_ns (x) q_sb", "rins (10)", quaternion(w, vector(x, y, z)))


def _half(axis: str, delta: Scalar) -> tuple[Scalar, Scalar]:
    """Write sine and cosine of half a tilt."""
    sine, cosine = sine_cosine_of_small(F(1, 2) * delta)
    sine = named(f"sin_{axis}", sine)
    return sine, step(f"cos_{axis} = cos(delta_{axis}/2), with sin_{axis}", "", cosine)
