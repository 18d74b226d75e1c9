"""The additive quaternion error model: exact where it should be, second order off where it must be."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from qcone.errors import UsageError
from qcone.reference.motions import Motion, slew, thesis_coning, tumble
from qcone.reference.quaternion import from_rotation_vector, product
from qcone.studies.error_model import AXIS, ErrorCase, Row, error_rows, predict, simulate

FAST_FRAME = (0.3, -0.2, 0.25)  # rad/s; the earth's rate is too small to show a wrong sign


@pytest.fixture(scope="module")
def table() -> list[Row]:
    return error_rows()


def along(size: float) -> tuple[float, float, float]:
    return (size * AXIS[0], size * AXIS[1], size * AXIS[2])


def off(
    motion: Motion, case: ErrorCase, products: bool = False, frame: tuple[float, float, float] = FAST_FRAME
) -> float:
    """|dq predicted - dq simulated|."""
    return float(np.linalg.norm(predict(motion, case, frame, products=products).dq - simulate(motion, case, frame).dq))


def test_the_simulation_solves_the_attitude_equation_of_both_rates() -> None:
    motion, case = slew((0.8, -0.5, 0.3)), ErrorCase("all", 1.0, "1", along(0.02), 0.03, along(0.4), along(0.05))
    ends = []
    for scale, bias, frame_error, start in (
        (1.0, np.zeros(3), np.zeros(3), np.zeros(3)),
        (1.03, np.array(case.bias), np.array(case.frame), np.array(case.misalignment)),
    ):
        body = np.concatenate([[0.0], scale * np.array([0.8, -0.5, 0.3]) + bias])
        frame = np.concatenate([[0.0], np.array(FAST_FRAME) + frame_error])
        q, h = from_rotation_vector(start), 1e-2
        for _ in range(1000):
            k = [np.zeros(4)]
            for weight in (0.0, 0.5, 0.5, 1.0):
                at = q + weight * h * k[-1]
                k.append(0.5 * product(at, body) - 0.5 * product(frame, at))
            q = q + h / 6 * (k[1] + 2 * k[2] + 2 * k[3] + k[4])
        ends.append(q)
    np.testing.assert_allclose(simulate(motion, case, FAST_FRAME).dq, ends[1] - ends[0], atol=1e-10)


def test_at_rest_the_linear_model_is_its_closed_form() -> None:
    """q^ = exp(b t / 2) drives dq' = 1/2 dq (x) b + 1/2 q^ (x) b, which dq = (b t / 2) (x) exp(b t / 2) solves."""
    rest, bias = slew((0.0, 0.0, 0.0)), np.array(along(0.05))
    predicted = predict(rest, ErrorCase("bias", 0.05, "rad/s", bias=along(0.05)), (0.0, 0.0, 0.0)).dq
    half = np.concatenate([[0.0], 0.5 * 10.0 * bias])
    np.testing.assert_allclose(predicted, product(half, from_rotation_vector(10.0 * bias)), atol=1e-12)


@pytest.mark.parametrize(
    "case",
    [
        ErrorCase("bias", 0.1, "rad/s", bias=along(0.1)),
        ErrorCase("scale", 0.1, "1", scale=0.1),
        ErrorCase("misalignment", 2.5, "rad", misalignment=along(2.5)),
        ErrorCase("frame", 0.05, "rad/s", frame=(0.0, 0.05, 0.02)),
        ErrorCase("all", 1.0, "1", (0.02, 0.05, -0.03), -0.05, (0.5, -0.9, 0.3), (0.01, -0.02, 0.03)),
    ],
    ids=lambda case: case.name,
)
def test_with_the_products_the_model_is_exact_at_any_size(case: ErrorCase) -> None:
    assert off(thesis_coning(2.5), case, products=True) < 1e-9
    assert off(tumble(), case, products=True) < 1e-6


def test_a_misalignment_alone_is_kept_by_the_linear_model_at_any_size() -> None:
    for size in (1e-3, 1.0, 3.0):
        case = ErrorCase("misalignment", size, "rad", misalignment=along(size))
        assert off(thesis_coning(2.5), case) < 1e-9 * size
        np.testing.assert_allclose(np.linalg.norm(simulate(thesis_coning(2.5), case).error), size, rtol=1e-12)


@pytest.mark.parametrize(
    ("kind", "small"),
    [("bias", 1e-4), ("scale", 1e-4), ("frame", 1e-4)],
)
@pytest.mark.parametrize("motion", [thesis_coning(2.5), slew(), tumble()], ids=lambda motion: motion.name)
def test_what_the_linear_model_leaves_out_is_of_second_order(motion: Motion, kind: str, small: float) -> None:
    misses, short = [], replace(motion, duration=2.0)
    for size in (small, 2 * small, 10 * small):
        value = size if kind == "scale" else along(size)
        misses.append(off(short, ErrorCase(kind, size, "", **{kind: value})))  # type: ignore[arg-type]
    assert misses[1] / misses[0] == pytest.approx(4, rel=0.02)
    assert misses[2] / misses[0] == pytest.approx(100, rel=0.03)


def test_about_one_axis_the_linear_model_misses_a_quarter_of_the_angle() -> None:
    """At rest |dq| = phi/2 and it misses phi^2/8: a deviation of phi/4, 1 % at 0.04 rad."""
    rest = slew((0.0, 0.0, 0.0))
    cases = [ErrorCase("bias", size, "rad/s", bias=along(size)) for size in (1e-5, 1e-3, 3.9e-3, 4.1e-3)]
    rows = error_rows(rest, cases, (0.0, 0.0, 0.0))
    for row in rows:
        phi = row["simulated"]
        assert phi == pytest.approx(10.0 * float(str(row["size"])), rel=1e-12)
        assert row["deviation"] == pytest.approx(float(str(phi)) / 4, rel=1e-3)
    assert [row["holds"] for row in rows] == [True, True, True, False]


def test_a_misalignment_spoils_the_share_of_a_bias_beside_it() -> None:
    """dq (x) dw is left out beside q^ (x) dw: of what a bias adds, the part |dq| = 2 sin(misalignment / 4)."""
    motion, misalignment, bias = thesis_coning(2.5), (2 / 3, 2 / 3, -1 / 3), along(1e-5)
    alone = ErrorCase("alone", 1.0, "rad", misalignment=misalignment)
    both = ErrorCase("both", 1.0, "rad", bias=bias, misalignment=misalignment)
    truth, model = (run(motion, both).dq - run(motion, alone).dq for run in (simulate, predict))
    share = float(np.linalg.norm(model - truth) / np.linalg.norm(truth))
    assert share == pytest.approx(2 * np.sin(1 / 4), rel=1e-3)


def test_small_errors_are_predicted_and_large_ones_shown_not_to_be(table: list[Row]) -> None:
    by_case: dict[str, list[Row]] = {}
    for row in table:
        by_case.setdefault(str(row["case"]), []).append(row)
    smallest = {name: rows[0] for name, rows in by_case.items()}
    for name, bound in (("gyro bias", 5e-6), ("scale error", 3e-5), ("misalignment", 1e-9), ("frame rate error", 2e-6)):
        assert float(str(smallest[name]["deviation"])) < bound, name
        assert abs(float(str(smallest[name]["ratio"])) - 1) < bound, name
    held = {name: [row["holds"] for row in rows] for name, rows in by_case.items()}
    assert held == {
        "gyro bias": [True, True, True, False, False],
        "scale error": [True, True, False, False],
        "misalignment": [True, True, True, True],
        "frame rate error": [True, False],
        "misalignment, 5 mrad/s bias": [True, False, False],
    }
    assert all(float(str(row["with_products"])) < 1e-8 for row in table)
    assert all(("leaves out products" in str(row["reason"])) != row["holds"] for row in table)


def test_rows_are_flat_and_repeatable(table: list[Row]) -> None:
    assert error_rows(cases=[ErrorCase("gyro bias", 1e-4, "rad/s", bias=along(1e-4))]) == [table[1]]
    assert all(isinstance(value, str | float | bool) for row in table for value in row.values())
    assert {row["paper"] for row in table} == {"thesis2008"}


def test_the_predicted_error_points_where_the_simulated_one_does() -> None:
    case = ErrorCase("bias", 1e-5, "rad/s", bias=(1e-5, 0.0, 0.0))
    np.testing.assert_allclose(predict(tumble(), case).error, simulate(tumble(), case).error, rtol=1e-5)


@pytest.mark.parametrize(
    ("case", "message"),
    [
        (ErrorCase("none", 0.0, "1"), "none: no error is given, a ratio needs one, give a bias, scale or misalignment"),
        (ErrorCase("hole", 0.0, "1", bias=(0.0, np.nan, 0.0)), "hole: an error is not a finite number"),
        (ErrorCase("dead", -1.0, "1", scale=-1.0), "dead: scale error -1 leaves no rate to measure, give more than -1"),
    ],
    ids=lambda value: value.name if isinstance(value, ErrorCase) else "",
)
def test_a_case_that_says_nothing_is_refused(case: ErrorCase, message: str) -> None:
    with pytest.raises(UsageError, match=re.escape(message)):
        error_rows(cases=[case])


def test_a_motion_that_shows_nothing_is_refused() -> None:
    with pytest.raises(UsageError, match=re.escape("scale: motion slew brings out no attitude error")):
        error_rows(slew((0.0, 0.0, 0.0)), [ErrorCase("scale", 0.1, "1", scale=0.1)])
