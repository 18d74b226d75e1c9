"""Error and order of each algorithm on whole motions, against the published figures."""

from __future__ import annotations

import math

import numpy as np
import pytest

from qcone.reference import attitude, motions, quaternion


def worst_error(motion: motions.Motion, rate_hz: int, subsamples: int, **form: object) -> float:
    """Return the largest attitude error angle at update instants, sub-samples at `rate_hz`, in rad."""
    updates = round(motion.duration * rate_hz) // subsamples
    times = np.arange(updates * subsamples + 1) / rate_hz
    truth = motion.attitude(times[::subsamples])
    dtheta = motion.increments(times).reshape(updates, subsamples, 3)
    q = attitude.run(truth[0], dtheta, **form)
    return float(quaternion.error_angle(q, truth[1:]).max())


CONING_AT_1_KHZ = {
    (1, "coning"): 7.5e-5,
    (2, "taylor"): 2.4e-9,
    (3, "taylor"): 1.8e-9,
    (4, "taylor"): 3.5e-11,
    (6, "taylor"): 1.8e-10,
    (3, "compressed"): 3.0e-10,
    (4, "compressed"): 9.6e-10,
    (6, "compressed"): 4.1e-9,
    (3, "expanded"): 1.3e-11,
    (4, "expanded"): 3.5e-11,
    (5, "expanded"): 8.6e-11,
    (6, "expanded"): 1.8e-10,
}


@pytest.mark.parametrize(("n", "coefficients"), CONING_AT_1_KHZ)
def test_a_minute_of_coning_has_the_published_error(n: int, coefficients: str) -> None:
    error = worst_error(motions.coning(), 1000, n, coefficients=coefficients)
    published = CONING_AT_1_KHZ[n, coefficients]
    assert published / 1.2 < error < published * 1.2


# Columns: thesis coning 10 and 25 Hz at 200 Hz, large angle at 1 kHz and 100 Hz, tumble at 200 Hz.
OTHER_MOTIONS = {
    (1, "taylor"): (2.0e-4, 4.8e-4, 1.1e-5, 1.1e-3, 4.5e-3),
    (2, "taylor"): (3.8e-6, 5.6e-5, 9.6e-10, 9.6e-6, 1.3e-5),
    (3, "taylor"): (2.7e-6, 3.0e-5, 6.1e-9, 6.1e-5, 6.4e-5),
    (4, "taylor"): (1.9e-7, 1.7e-5, 1.9e-8, 1.9e-4, 2.0e-4),
    (6, "taylor"): (2.1e-7, 5.1e-6, 9.6e-8, 9.5e-4, 1.0e-3),
    (3, "compressed"): (9.4e-8, 7.2e-6, 1.0e-7, 8.2e-5, 1.5e-4),
    (4, "compressed"): (7.3e-8, 1.1e-6, 3.3e-7, 2.6e-4, 4.8e-4),
    (6, "compressed"): (3.4e-7, 1.4e-6, 1.4e-6, 1.3e-3, 2.1e-3),
    (3, "expanded"): (9.3e-8, 7.2e-6, 5.9e-9, 5.9e-5, 6.4e-5),
    (4, "expanded"): (4.3e-8, 1.1e-6, 1.9e-8, 1.9e-4, 2.0e-4),
    (5, "expanded"): (9.9e-8, 4.9e-7, 4.6e-8, 4.6e-4, 4.9e-4),
    (6, "expanded"): (2.0e-7, 5.6e-7, 9.6e-8, 9.5e-4, 1.0e-3),
}


@pytest.mark.parametrize(("n", "coefficients"), OTHER_MOTIONS)
def test_other_motions_have_the_published_error(n: int, coefficients: str) -> None:
    runs = (
        (motions.thesis_coning(10.0), 200),
        (motions.thesis_coning(25.0), 200),
        (motions.large_angle_manoeuvre(), 1000),
        (motions.large_angle_manoeuvre(), 100),
        (motions.tumble(), 200),
    )
    errors = [worst_error(motion, rate_hz, n, coefficients=coefficients) for motion, rate_hz in runs]
    np.testing.assert_allclose(errors, OTHER_MOTIONS[n, coefficients], rtol=0.1)


@pytest.mark.parametrize(("p", "published"), [(1, 2.4e-9), (2, 3.3e-11), (3, 2.8e-11)])
def test_a_minute_of_coning_with_known_history_has_the_published_error(p: int, published: float) -> None:
    history = motions.coning().increments(np.arange(-p, 1) / 1000)[::-1]
    error = worst_error(motions.coning(), 1000, 1, previous=p, history=history)
    assert published / 1.2 < error < published * 1.2


SLOPES = [
    *((n, {"coefficients": name}, 4) for n in (2, 3, 4, 5, 6) for name in ("taylor", "coning", "expanded")),
    *((n, {"coefficients": "compressed"}, 3) for n in (3, 4, 5, 6)),
    *((1, {"order": order}, 2) for order in (1, 2, 3, 4, "closed")),
    *((1, {"previous": p}, 3) for p in (1, 2, 3, 4, 5)),
    (1, {}, 2),
]


@pytest.mark.parametrize(("n", "form", "slope"), SLOPES, ids=str)
def test_order_on_the_large_angle_manoeuvre(n: int, form: dict[str, object], slope: int) -> None:
    motion = motions.large_angle_manoeuvre()
    errors = [worst_error(motion, rate_hz, n, **form) for rate_hz in (1000, 2000)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(slope, abs=0.2)
