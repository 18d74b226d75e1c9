"""Test motions with exact angle increments, body rates and attitudes.

Every motion here has a rate that is a polynomial in time plus sinusoids, so that its increments have a
closed form in which nothing cancels. Cases A to E are the motions the accuracy figures of the algorithms
are stated for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from types import MappingProxyType

import numpy as np

from qcone.reference.kinematics import integrate
from qcone.reference.quaternion import Array, from_rotation_vector

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Sinusoid:
    """A body rate cosine * cos(2 pi f t) + sine * sin(2 pi f t) in rad/s; f = frequency in Hz, above 0."""

    frequency: float
    cosine: Vector = (0.0, 0.0, 0.0)
    sine: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Motion:
    """A body rate in rad/s, sum of polynomial[k] t^k and of `sinusoids`, over `duration` s from t = 0."""

    name: str
    duration: float
    polynomial: tuple[Vector, ...] = ()
    sinusoids: tuple[Sinusoid, ...] = ()
    closed_form: Callable[[Array], Array] | None = field(default=None, compare=False, repr=False)

    def rate(self, t: Array) -> Array:
        """Return the body rate (n, 3) in rad/s at the instants `t` (n,) in s."""
        t = np.asarray(t, dtype=np.float64)
        omega = np.zeros((len(t), 3))
        for coefficient in reversed(self.polynomial):
            omega = omega * t[:, np.newaxis] + np.array(coefficient)
        for term in self.sinusoids:
            angle = phase(term.frequency, t)
            omega += np.outer(np.cos(angle), term.cosine) + np.outer(np.sin(angle), term.sine)
        return omega

    def increments(self, times: Array) -> Array:
        """Return the integrals (n - 1, 3) in rad of the rate between consecutive `times` (n,) in s.

        The difference b^k - a^k is taken as (b - a) sum b^i a^(k-1-i), and differences of sines and cosines
        as products, so that small increments keep their relative precision.
        """
        times = np.asarray(times, dtype=np.float64)
        begin, end = times[:-1], times[1:]
        duration = end - begin
        angle = np.zeros((len(duration), 3))
        for k, coefficient in enumerate(self.polynomial):
            mean_power = sum((begin**i * end ** (k - i) for i in range(k + 1)), np.zeros_like(begin)) / (k + 1)
            angle += np.outer(duration * mean_power, coefficient)
        for term in self.sinusoids:
            half = np.pi * term.frequency * duration
            middle = phase(term.frequency, begin) + half
            width = np.sin(half) / (np.pi * term.frequency)
            angle += np.outer(width * np.cos(middle), term.cosine)
            angle += np.outer(width * np.sin(middle), term.sine)
        return angle

    def attitude(self, t: Array) -> Array:
        """Return the attitude quaternions (n, 4), body to navigation, at the instants `t` (n,) in s.

        In closed form where the motion has one; else integrated from the identity at t = 0, to a few 1e-16
        rad a second, for `t` in any order. Raises ValueError for a negative time of a motion without a
        closed form.
        """
        t = np.asarray(t, dtype=np.float64)
        if self.closed_form is not None:
            return self.closed_form(t)
        if np.any(t < 0):
            raise ValueError(f"motion {self.name} starts at t = 0")
        instants, position = np.unique(np.concatenate([[0.0], t]), return_inverse=True)
        return integrate(self.rate, self.increments, instants)[position[1:]]


def phase(frequency: float, t: Array) -> Array:
    """Return 2 pi frequency t in rad, reduced to -pi..pi, for a `frequency` in Hz and times `t` (n,) in s.

    The product is exact before whole turns are dropped (Dekker's splitting), so a long run keeps its phase to
    1e-15.
    """
    turns = frequency * t
    (high_f, low_f), (high_t, low_t) = _split(np.float64(frequency)), _split(t)
    dropped = ((high_f * high_t - turns) + high_f * low_t + low_f * high_t) + low_f * low_t
    angle: Array = 2 * np.pi * ((turns - np.rint(turns)) + dropped)
    return angle


def _split(value: Array | np.float64) -> tuple[Array | np.float64, Array | np.float64]:
    """Return two parts of 26 bits whose sum is `value`; products of such parts are exact."""
    scaled = (2.0**27 + 1) * value
    high = scaled - (scaled - value)
    return high, value - high


def coning(cone_angle: float = np.deg2rad(5.0), cone_rate: float = 4 * np.pi) -> Motion:
    """Return classical coning about z, `cone_angle` in rad, `cone_rate` in rad/s; xu2019 (14), case A.

    The attitude at t = 0 is [cos(cone_angle/2), 0, sin(cone_angle/2), 0], not the identity.
    """
    frequency = cone_rate / (2 * np.pi)
    across, along = cone_rate * np.sin(cone_angle), 2 * cone_rate * np.sin(cone_angle / 2) ** 2
    return Motion(
        name="coning",
        duration=60.0,
        polynomial=((0.0, 0.0, float(along)),),
        sinusoids=(Sinusoid(frequency, cosine=(float(across), 0.0, 0.0), sine=(0.0, -float(across), 0.0)),),
        closed_form=partial(_coning_attitude, cone_angle, frequency),
    )


def _coning_attitude(cone_angle: float, frequency: float, t: Array) -> Array:
    half_sine, zero, angle = np.sin(cone_angle / 2), np.zeros_like(t), phase(frequency, t)
    return np.stack(
        [
            zero + np.cos(cone_angle / 2),
            half_sine * np.sin(angle),
            half_sine * np.cos(angle),
            zero,
        ],
        axis=-1,
    )


def thesis_coning(frequency: float = 10.0) -> Motion:
    """Return omega = [0.5 sin 2 pi f t, 0.5 cos 2 pi f t, 0.01] rad/s, f in Hz; thesis2008, case B.

    In axes that turn with the rate vector the motion is a constant rate, hence the closed form.
    """
    return Motion(
        name="thesis-coning",
        duration=6.0,
        polynomial=((0.0, 0.0, 0.01),),
        sinusoids=(Sinusoid(frequency, cosine=(0.0, 0.5, 0.0), sine=(0.5, 0.0, 0.0)),),
        closed_form=partial(_thesis_attitude, frequency),
    )


def _thesis_attitude(frequency: float, t: Array) -> Array:
    """Return exp(w t) (x) exp((0, 0, turn t)) for w = (0, 0.5, 0.01 - turn), without cancellation.

    With psi = turn t / 2 and |w| t / 2 = psi + delta, the large angle psi enters only through its phase.
    """
    turn = 2 * np.pi * frequency
    norm = np.hypot(0.5, 0.01 - turn)
    excess = (0.5**2 + 0.01**2 - 2 * 0.01 * turn) / (norm + turn)  # |w| - turn, without cancellation
    tilt = (excess + 0.01) / norm  # 1 + w_z / |w|
    delta, psi = excess * t / 2, phase(frequency / 2, t)
    sine, across = np.sin(psi + delta), 0.5 / norm
    return np.stack(
        [
            np.cos(delta) - tilt * sine * np.sin(psi),
            across * sine * np.sin(psi),
            across * sine * np.cos(psi),
            -np.sin(delta) + tilt * sine * np.cos(psi),
        ],
        axis=-1,
    )


def large_angle_manoeuvre() -> Motion:
    """Return Savage's large-angle manoeuvre of 1.2 s, rates up to 12 rad/s; xu2019 (15), case C.

    The equation printed there is the cumulative angle in rad; this is its derivative.
    """
    frequency = 1.3
    turn = 2 * np.pi * frequency
    return Motion(
        name="large-angle",
        duration=1.2,
        polynomial=(
            (-1.1, -0.5, 0.3),
            (2 * 0.45, 2 * 1.0, 2 * -1.2),
            (3 * -0.6, 3 * -0.3, 3 * 2.0),
            (4 * 1.1, 4 * 0.7, 4 * -0.9),
            (5 * -0.1, 5 * -0.2, 5 * 0.4),
        ),
        sinusoids=(
            Sinusoid(
                frequency,
                cosine=(0.2 * turn, -0.5 * turn, 0.8 * turn),
                sine=(0.3 * turn, 0.6 * turn, -0.9 * turn),
            ),
        ),
    )


def tumble() -> Motion:
    """Return a fast tumble of 6 s, rates up to 31 rad/s; case D.

    omega = (12 cos 2.6 pi t + 6, 10 cos(1.8 pi t + 0.3) - 5, 8 cos(3.4 pi t + 1) + 15) rad/s.
    """
    y_cosine, y_sine = 10 * float(np.cos(0.3)), -10 * float(np.sin(0.3))
    z_cosine, z_sine = 8 * float(np.cos(1.0)), -8 * float(np.sin(1.0))
    return Motion(
        name="tumble",
        duration=6.0,
        polynomial=((6.0, -5.0, 15.0),),
        sinusoids=(
            Sinusoid(1.3, cosine=(12.0, 0.0, 0.0)),
            Sinusoid(0.9, cosine=(0.0, y_cosine, 0.0), sine=(0.0, y_sine, 0.0)),
            Sinusoid(1.7, cosine=(0.0, 0.0, z_cosine), sine=(0.0, 0.0, z_sine)),
        ),
    )


def random_motion(seed: int = 0) -> Motion:
    """Return 6 s of random vibration: 40 sines an axis, 0.2 to 25 Hz, 1 rad/s rms an axis, biased; case E.

    The bias is (0.3, -0.2, 0.1) rad/s. The same `seed` gives the same motion.
    """
    random = np.random.default_rng(seed)
    sinusoids = []
    for axis in range(3):
        frequencies = 0.2 + 24.8 * random.random(40)
        phases = 2 * np.pi * random.random(40)
        amplitude = np.sqrt(2 / 40)
        for frequency, phase in zip(frequencies, phases, strict=True):
            unit = np.eye(3)[axis] * amplitude
            x, y, z = (unit * np.cos(phase)).tolist()
            u, v, w = (unit * np.sin(phase)).tolist()
            sinusoids.append(Sinusoid(float(frequency), cosine=(x, y, z), sine=(u, v, w)))
    return Motion("random", 6.0, polynomial=((0.3, -0.2, 0.1),), sinusoids=tuple(sinusoids))


def slew(rate: Vector = (0.3, -0.2, 0.5)) -> Motion:
    """Return a rotation at the constant body `rate` in rad/s: every coning term vanishes."""
    return Motion("slew", 10.0, polynomial=(rate,), closed_form=partial(_slew_attitude, rate))


def _slew_attitude(rate: Vector, t: Array) -> Array:
    return from_rotation_vector(np.outer(t, rate))


MOTIONS: Mapping[str, Callable[..., Motion]] = MappingProxyType(
    {
        "coning": coning,
        "thesis-coning": thesis_coning,
        "large-angle": large_angle_manoeuvre,
        "tumble": tumble,
        "random": random_motion,
        "slew": slew,
    }
)
