"""Euler angles integrated over a pitch of 90 degrees go wrong for good; quaternions on the same rates do not notice.

The figure cao_lock draws these runs of the compiled C.
"""

from __future__ import annotations

import numpy as np
import pytest

from qcone.reference.euler import to_angles
from qcone.studies.curves.cao import OVER_THE_POLE, THROUGH_THE_POLE, over_the_pole

pytestmark = pytest.mark.usefixtures("first_compiler")

RATES_HZ = (100, 400)
POLE = np.pi / 2
"""When pitch is nearest to 90 degrees, in s, at 1 rad/s."""


def test_the_motion_passes_the_pole_closely() -> None:
    times = np.linspace(POLE - 0.01, POLE + 0.01, 2001)
    pitch = to_angles(OVER_THE_POLE.attitude(times))[:, 1]
    assert np.rad2deg(pitch.max()) * 3600 == pytest.approx(90 * 3600 - 20.6, abs=0.5)


@pytest.mark.parametrize("hz", RATES_HZ)
def test_euler_angles_are_lost_at_the_pole(hz: float) -> None:
    """Half a second before it they are right to 1e-12 rad; from then on they are off by minutes of arc and more."""
    ends, error, _ = over_the_pole("euler-angles", hz)
    assert error[ends < POLE - 0.5].max() < 1e-12
    assert error[ends > POLE + 0.5].min() > 1e-3


@pytest.mark.parametrize("hz", RATES_HZ)
@pytest.mark.parametrize("name", [name for name in THROUGH_THE_POLE if name != "euler-angles"])
def test_quaternions_pass_it_unharmed(name: str, hz: float) -> None:
    ends, error, angles = over_the_pole(name, hz)
    before, after = error[ends < POLE - 0.5].max(), error[ends > POLE + 0.5].max()
    assert after < 1e-10
    assert after < 10 * before + 1e-14, "what grows is the method's own error, in proportion to time"
    assert np.abs(angles[:, 1]).max() <= np.pi / 2
