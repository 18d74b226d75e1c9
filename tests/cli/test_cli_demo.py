"""The demonstration, whole: what a fresh checkout shows."""

from __future__ import annotations

import re
from pathlib import Path

from given import everything


def test_demo_shows_no_differing_bit_and_what_coning_is_worth(run, tmp_path: Path) -> None:
    result = run("demo")
    assert (result.exit_code, result.stderr) == (0, "")
    assert "read the C back: every statement is the routine's\n" in result.stdout
    (settings, bits) = re.findall(r"compiled with (\d+) compiler settings .*: (\d+) differing bits\n", result.stdout)[0]
    assert int(settings) >= 5
    assert int(bits) == 0
    errors = dict(re.findall(r"^(rotation-vector-\S+ +float\d\d) +([\d.e+-]+)$", result.stdout, re.MULTILINE))
    plain, coning = (float(errors[name]) for name in sorted(errors) if name.endswith("float64"))
    assert plain > 1000 * coning, "the coning term is worth three orders"
    assert everything(tmp_path) == {}
