"""The stage of a rotating unit as text: what the files say of it, and no trace of it where it is not asked for."""

from __future__ import annotations

import re

from qcone.bundle import with_manifest
from qcone.design import design_from_options
from qcone.pipeline import build
from qcone.registry import entries
from qcone.studies.counting import rows_of_design
from shipped import shipped
from unit_runs import unit

FIXED = "rotation_vector_3_coning_rins_fixed32_compensated"
FRACTION_BITS = {"ENCODER": 27, "ANGLE": 27, "TILT": 36, "AZIMUTH": 39, "TILT_X": 39, "TILT_Y": 39}


def body_of(text: str, function: str) -> str:
    return text.split(f"_{function}(", 1)[1].split("\n}\n", 1)[0]


def test_the_axes_of_the_sensor_leave_the_stage_alone() -> None:
    plain, turned_axes = (build(unit(axes=axes)).source for axes in ("x,y,z", "y,-x,z"))
    for function in ("set_correction", "correct", "body_quaternion"):
        assert body_of(plain, function) == body_of(turned_axes, function)
    assert plain != turned_axes


def test_no_branch_and_nothing_of_a_library() -> None:
    for number in ("float32", "float64"):
        text = re.sub(r"/\*.*?\*/", "", build(unit(number=number)).source, flags=re.DOTALL)
        for function in ("correct", "body_quaternion"):
            assert not re.search(r"\b(if|for|while|switch|goto)\b", body_of(text, function))
            assert not re.search(r"\w\(", body_of(text, function).split("{", 1)[1])
        assert "math.h" not in text
        assert ("double" in text) == (number == "float64")


def test_the_header_says_what_is_declared_and_promised() -> None:
    header = " ".join(re.sub(r"\n ?\*? *", " ", shipped("rotation_vector_3_coning_rins_float32").header).split())
    for words in (
        "encoder angle at most 3 pi in size; sqrt(A^2 + B^2) + |C| of each harmonic at most 0.0029089 rad (600 arcsec)",
        "rad, at most 3 pi in size: 0..2 pi and -pi..pi both",
        "within half a unit of its last place and 2.8e-09 rad",
        "within 8.3e-09 rad of the exact function",
        "within 9.5e-07 of the exact function",
        "The correction is zero.",
        "The correction is kept.",
        "rins (10) to (16)",
        "correct emitted",
        "body_quaternion emitted",
    ):
        assert words in header, words


def test_without_the_table_there_is_no_trace_of_it() -> None:
    bundle = shipped("rotation_vector_3_coning_float32")
    assert not bundle.driver.stage
    for text in with_manifest(bundle).values():
        assert "correct" not in text
        assert "body_" not in text


def test_counts_of_the_stage_have_rows_of_their_own() -> None:
    design = unit("rotation-vector subsamples=3 coefficients=coning", number="float64")
    found = [row for row in rows_of_design(design, ("factored",)) if row["algorithm"] == "rins"]
    assert [row["level"] for row in found] == ["as-written", "shared", "emitted"]
    assert found[0]["trigonometric"] == 10, "two for al, two for the error, two for each half tilt, two for half al"
    assert (found[2]["trigonometric"], found[2]["divide"], found[2]["square_root"]) == (0, 0, 0)
    levels = build(design).facts.counts
    for kind in ("multiply", "add", "subtract", "compare", "select"):
        assert found[2][kind] == sum(getattr(levels[name]["emitted"], kind) for name in ("correct", "body_quaternion"))


def test_options_ask_for_the_stage_too() -> None:
    words = {"algorithm": "rotation-vector", "number": "float64", "update_hz": "100", "max_rate_dps": "573"}
    assert design_from_options("a", words, entries()).rins is None
    asked = design_from_options("a", {**words, "max-correction-arcsec": "120"}, entries()).rins
    assert asked is not None
    assert asked.max_correction_arcsec == 120


def test_the_header_gives_the_fraction_bits_of_every_argument_of_the_stage() -> None:
    for argument, bits in FRACTION_BITS.items():
        assert f"#define {FIXED.upper()}_{argument}_FRACTION_BITS {bits}\n" in shipped(FIXED).header
