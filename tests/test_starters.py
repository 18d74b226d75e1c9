"""Adams-Moulton around a restart, through the compiled C: hold, three steps, ready; and what a start costs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from qcone.bundle import Bundle
from qcone.pipeline import build
from qcone.reference import motions, quaternion
from qcone.reference.motions import Motion
from qcone.reference.quaternion import Array
from qcone.targets.build import build_shared
from qcone.targets.compiler import Compiler
from qcone.targets.host import Library
from running import chain, singly
from shipped import design_of

CURED, THESIS = "adams-moulton-4 starter=runge-kutta-4", "adams-moulton-4 starter=heun"
HZ = 200

READY = """\
#include <stdint.h>
#include "tested.h"

void run_ready(int32_t rows, const double *start, const double *omega, const int32_t *restart, int32_t *ready);
void run_ready(int32_t rows, const double *start, const double *omega, const int32_t *restart, int32_t *ready)
{
    static tested_state state;
    tested_init(&state);
    tested_start(&state, start);
    ready[0] = tested_ready(&state);
    for (int32_t row = 0; row < rows; ++row) {
        if (restart[row] != 0) {
            const double q[4] = { 0.0, 1.0, 0.0, 0.0 };
            tested_set_quaternion(&state, q);
        }
        tested_update(&state, &omega[3 * row]);
        ready[row + 1] = tested_ready(&state);
    }
}
"""


def ready_after(bundle: Bundle, compiler: Compiler, updates: int, restart_at: int | None = None) -> list[int]:
    """Return what `ready` says before the first update and after each."""
    files = {**bundle.sources, "ready.c": READY}
    declaration = READY.splitlines()[3]
    library = Library(build_shared(compiler, files, "-O1"), declaration)
    restart = np.zeros(updates, np.int32)
    if restart_at is not None:
        restart[restart_at] = 1
    ready = np.full(updates + 1, -1, np.int32)
    omega = np.full((updates + 1, 3), 0.25)
    library.run("run_ready", updates, omega[0].copy(), omega[1:].copy(), restart, ready)
    return ready.tolist()


def test_the_cured_starter_is_ready_with_the_third_update(first_compiler: Compiler) -> None:
    bundle = build(design_of(CURED))
    assert ready_after(bundle, first_compiler, 6) == [0, 0, 0, 1, 1, 1, 1]
    assert ready_after(bundle, first_compiler, 7, restart_at=4) == [0, 0, 0, 1, 1, 0, 0, 1]


def test_the_thesis_starter_is_current_from_the_first_update_on(first_compiler: Compiler) -> None:
    bundle = build(design_of(THESIS))
    assert ready_after(bundle, first_compiler, 4) == [0, 1, 1, 1, 1]


@pytest.mark.parametrize("example", ["runge-kutta-4 attitude=quaternion", "rotation-vector subsamples=1 previous=3"])
def test_what_needs_no_starter_has_no_ready(example: str) -> None:
    assert "_ready" not in build(design_of(example)).header


def moved(motion: Motion, seconds: float, hz: int, example: str, compiler: Compiler, **options: Any) -> NDArray[Any]:
    """Return the attitude error angle after each update, rad."""
    times = np.arange(round(seconds * hz) + 1) / hz
    omega = motion.rate(times)
    bundle = build(design_of(example, update_hz=str(hz), max_rate_dps="900", **options))
    found = chain(bundle, compiler, omega[1:], motion.attitude(times[:1])[0], omega[0])
    return quaternion.error_angle(found.q, motion.attitude(times[1:]))


def test_two_updates_hold_and_the_third_makes_three_steps(first_compiler: Compiler) -> None:
    motion, start = motions.large_angle_manoeuvre(), quaternion.normalise(np.array([0.5, -0.1, 0.7, 0.5]))
    times = np.arange(7) / HZ
    omega = motion.rate(times)
    bundle = build(design_of(CURED, max_rate_dps="900", update_hz=str(HZ)))
    found = chain(bundle, first_compiler, omega[1:], start, omega[0], exact=True)
    true = quaternion.product(start, motion.attitude(times[1:]))
    np.testing.assert_array_equal(found.q[0], found.q[1])
    assert quaternion.error_angle(found.q[:2], start).max() < 1e-15
    held = quaternion.error_angle(found.q[:2], true[:2])
    assert held[1] > 1.9 * held[0] > 1e-3, "the attitude is that of the start"
    assert quaternion.error_angle(found.q[2:], true[2:]).max() < 1e-7, "and then the time's own"
    assert not found["error_estimate"][:3].any(), "the starter has no estimate"
    assert found["error_estimate"][3:].any(axis=1).all()


def test_a_restart_clears_what_was_estimated(first_compiler: Compiler) -> None:
    bundle = build(design_of(THESIS, max_rate_dps="900", update_hz=str(HZ)))
    omega: Array = motions.large_angle_manoeuvre().rate(np.arange(6) / HZ)
    found = singly(bundle, first_compiler, omega[1:], np.eye(4)[0], omega[:-1])
    assert not found["error_estimate"].any()
    assert (found["count"] == 1).all()


def test_the_cured_starter_gains_forty_times_at_2_5_hz(first_compiler: Compiler) -> None:
    """thesis2008's coning, 5 ms: Heun's three steps leave 3.9e-6 rad for good, the other starter 9.7e-8."""
    motion = motions.thesis_coning(2.5)
    thesis = moved(motion, 10, HZ, THESIS, first_compiler).max()
    cured = moved(motion, 10, HZ, CURED, first_compiler)[2:].max()
    assert thesis == pytest.approx(3.9e-6, rel=0.02)
    assert cured == pytest.approx(9.7e-8, rel=0.02)
    assert thesis / cured == pytest.approx(40, rel=0.05)


DRIFT = {(2.5, 400): 3.92e-11, (2.5, 200): 1.25e-9, (10, 200): 3.16e-7, (10, 100): 9.62e-6, (20, 200): 4.81e-6}
"""Mean over 10 s of the size of (19/270)(c - p), by frequency and updates a second: the papers' drift."""


@pytest.mark.parametrize(("frequency", "hz"), DRIFT)
def test_milne_s_estimate_is_the_papers_drift(first_compiler: Compiler, frequency: float, hz: int) -> None:
    motion = motions.thesis_coning(frequency)
    omega = motion.rate(np.arange(10 * hz + 1) / hz)
    bundle = build(design_of(THESIS, update_hz=str(hz), renormalise="never"))
    found = chain(bundle, first_compiler, omega[1:], np.eye(4)[0], omega[0])
    drift = np.linalg.norm(found["error_estimate"][3:], axis=1).mean()
    assert drift == pytest.approx(DRIFT[frequency, hz], rel=0.01)
