"""A declared range beyond what is proved is refused: nothing is written, and half of it would do."""

from __future__ import annotations

from pathlib import Path

import pytest
from given import everything

DESIGN = """\
[design.mine]
algorithm = "rotation-vector"
subsamples = 3
imu = {{ update_hz = 100, max_rate_dps = {rate} }}
number = {{ format = "{number}"{more} }}
"""

BEYOND = (
    "fast.toml:1: error QC211: design 'mine': the length of 'q' is not proved to stay near 1: one update may take one "
    "within 1/2 of 1 to 3.21{bits}; 1/2 of the declared rate would do, raise update_hz, lower max_rate_dps, or choose "
    "a wider format\n"
)


@pytest.mark.parametrize("more", ["", ', accumulate = "compensated"', ', accumulate = "standard"'])
@pytest.mark.parametrize("number", ["fixed32", "fixed16"])
def test_a_range_beyond_the_proof_is_refused_and_nothing_written(run, tmp_path: Path, number: str, more: str) -> None:
    (tmp_path / "fast.toml").write_text(DESIGN.format(rate=12000, number=number, more=more))
    before = everything(tmp_path)
    result = run("generate", "fast.toml")
    word = {"fixed32": "s32.F30", "fixed16": "s16.F14"}[number]
    # A double word has bits to spare for such a length: what is missing is a range that it returns to.
    bits = "" if "compensated" in more else f", 1 bit more than {word} holds"
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", BEYOND.format(bits=bits))
    assert everything(tmp_path) == before


def test_the_range_that_would_do_does(run, tmp_path: Path) -> None:
    (tmp_path / "half.toml").write_text(DESIGN.format(rate=6000, number="fixed32", more=""))
    result = run("generate", "half.toml")
    assert result.exit_code == 0
    assert (tmp_path / "c_out" / "mine" / "src" / "mine.c").is_file()


def test_a_design_beyond_the_proof_leaves_its_neighbour_unwritten(run, tmp_path: Path) -> None:
    good = DESIGN.format(rate=573, number="fixed32", more="").replace("mine", "good")
    (tmp_path / "fast.toml").write_text(DESIGN.format(rate=12000, number="fixed32", more="") + good)
    result = run("generate", "fast.toml")
    assert result.exit_code == 2
    assert not (tmp_path / "c_out").exists()
