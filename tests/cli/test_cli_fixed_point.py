"""Fixed point from the command line: what is refused and why, pins, ranges, studies, raw counts."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from given import everything, rows_of

HEAD = """\
[design.mine]
algorithm = "rotation-vector"
imu = { update_hz = 100, max_rate_dps = 573 }
"""
FIXED = HEAD + 'number = { format = "fixed32" }\n'
COUNTS = HEAD.replace("573 }", '573, quantum_dps = "1/20" }') + 'input = "counts"\n'
LENGTH = "the length of 'q' is not proved to stay near 1: one update may take one within 1/2 of 1 to 1.64"
RANGE = "raise update_hz, lower max_rate_dps, or choose a wider format"
PIN = "pin fewer bits, or take the names from the emitted C"


def pinned(*pins: str) -> str:
    words = ", ".join(f'"{each}"' for each in pins)
    return f'{HEAD}subsamples = 3\nnumber = {{ format = "fixed32", pins = [{words}] }}\n'


FILES = {
    "the paper's form": (
        FIXED + 'form = "as-written"\n',
        '1: error QC201: design \'mine\': form = "as-written" does not go with "fixed32", the paper\'s form is written '
        'for real numbers, set form = "factored"',
    ),
    "loops": (
        FIXED + 'loop = "rolled"\n',
        '1: error QC201: design \'mine\': loop = "rolled" does not go with "fixed32", every turn has formats of its '
        'own, set loop = "unrolled"',
    ),
    "counts into floats": (
        COUNTS + 'number = { format = "float32" }\n',
        '1: error QC202: design \'mine\': input = "counts" does not go with number.format = "float32", whole counts '
        "become increments in integers, the residue carried, use fixed32 or fixed16",
    ),
    "no declared rate": (
        FIXED.replace(", max_rate_dps = 573", ""),
        "3: error QC103: `imu.max_rate_dps` is missing, it has no default (largest Euclidean norm of the body rate, "
        "deg/s), add `max_rate_dps = 573` in [design.mine.imu]",
    ),
    "a rate beyond 16 bits": (
        HEAD.replace("573", "9000") + 'number = { format = "fixed16" }\n',
        f"1: error QC211: design 'mine': {LENGTH}; 1/2 of the declared rate would do, {RANGE}",
    ),
    "a quotient without a bound": (
        HEAD.replace("rotation-vector", "euler-angles") + 'input = "rate"\nnumber = { format = "fixed32" }\n',
        "1: error QC211: design 'mine': the routine 'update' divides by a value that may be zero: a quotient has no "
        f"bound there, {RANGE}",
    ),
    "limbs of floats": (
        HEAD + 'multiply = "limbs"\nnumber = { format = "float32" }\n',
        '1: error QC209: design \'mine\': multiply = "limbs" does not go with number.format = "float32", products of '
        "floats are the core's own, or its library's, leave the key out",
    ),
    "limbs of short words": (
        HEAD + 'multiply = "limbs-shared"\nnumber = { format = "fixed16" }\n',
        '1: error QC209: design \'mine\': multiply = "limbs-shared" does not go with number.format = "fixed16", '
        "products of its words fit 32 bits, leave the key out",
    ),
    "limbs and ties": (
        HEAD + 'multiply = "limbs"\nnumber = { format = "fixed32", rounding = "even" }\n',
        '1: error QC209: design \'mine\': multiply = "limbs" does not go with number.rounding = "even", a tie shows '
        'in the whole sum alone, set multiply = "wide"',
    ),
    "limbs that may not fit": (
        HEAD + 'core = "cortex-m0"\nmultiply = "limbs"\nnumber = { format = "fixed32", overflow = "wrap" }\n',
        '1: error QC209: design \'mine\': multiply = "limbs" does not go with number.overflow = "wrap", limbs are '
        'proved to fit in the declared range alone, set multiply = "library"',
    ),
    "long products of a core without them": (
        FIXED + 'core = "cortex-m0plus"\nmultiply = "wide"\n',
        '1: error QC209: design \'mine\': multiply = "wide" does not go with core = "cortex-m0plus", it has no '
        "instruction for products of 64 bits, use limbs, limbs-shared or library, or leave the key out",
    ),
    "a library for a core that needs none": (
        FIXED + 'core = "cortex-m4"\nmultiply = "library"\n',
        '1: error QC209: design \'mine\': multiply = "library" does not go with core = "cortex-m4", it has an '
        "instruction for products of 64 bits, leave the key out",
    ),
    "a pin over the word": (
        pinned("phi_x = 40"),
        "1: error QC211: design 'mine': 'phi_x' in 'update' cannot have the pinned 40 bits: 6 more than a word of its "
        f"range holds, {PIN}",
    ),
    "a pin of nothing": (
        pinned("psi_x = 20"),
        f"1: error QC211: design 'mine': no value of an update is called 'psi_x', pinned to 20 bits, {PIN}",
    ),
    "pins that contradict": (
        pinned("phi_x = 20", "phi_x = 21"),
        '5: error QC112: `number.pins = ["phi_x = 20", "phi_x = 21"]` pins "phi_x" more than once, pin each value once',
    ),
    "more fraction bits than a double word": (
        pinned("phi_x = 63"),
        '5: error QC106: `number.pins = ["phi_x = 63"]` is out of range, "phi_x" may have 62 fraction bits at most, '
        "pin fewer",
    ),
    "a pin that is none": (
        pinned("phi_x : 29"),
        '5: error QC105: `number.pins = ["phi_x : 29"]` is not allowed, "phi_x : 29" is no pin, write for example '
        '["phi_x = 29"]',
    ),
    "pins of a float": (
        pinned("phi_x = 20").replace("fixed32", "float32"),
        '5: error QC107: `number.pins` does not go with `number.format = "float32"`, only fixed formats have it, leave '
        "it out",
    ),
}


@pytest.mark.parametrize("what", FILES)
def test_bad_design(run, tmp_path: Path, what: str) -> None:
    text, message = FILES[what]
    (tmp_path / "bad.toml").write_text(text)
    before = everything(tmp_path)
    result = run("generate", "bad.toml")
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", f"bad.toml:{message}\n")
    assert everything(tmp_path) == before


def emitted(run, folder: Path, text: str) -> str:
    (folder / "mine.toml").write_text(text)
    assert run("generate", "mine.toml").exit_code == 0
    assert run("verify", "mine.toml", "--rows", "200").exit_code == 0
    return (folder / "c_out/mine/src/mine.c").read_text()


def test_pin_is_kept_and_its_price_is_said(run, tmp_path: Path) -> None:
    free, coarse = (emitted(run, tmp_path, pinned(*pins)) for pins in (("phi_x = 29",), ("phi_x = 12",)))
    for text, bits in ((free, 29), (coarse, 12)):
        assert re.search(rf"const int32_t phi_x = .*/\* F{bits},", text)
    bounds = [float(re.search(r"one update is within (\S+) of", text)[1]) for text in (free, coarse)]
    assert bounds[1] > 1e4 * bounds[0]


def test_ranges_of_a_design(run, tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(FIXED)
    rows = rows_of(run, "verify", "mine.toml", "--ranges", "--rows", "2000")
    assert list(rows[0]) == ["design", "routine", "value", "format", "bound_bits", "used_bits", "spare_bits"]
    update = {row["value"]: row for row in rows if row["routine"] == "update"}
    assert update["q_w"]["format"] == "s32.F30"
    for row in rows:
        assert 0 <= row["used_bits"] <= row["bound_bits"] <= 64
        width = int(re.match(r"s(\d+)\.F", row["format"])[1])
        assert row["spare_bits"] == width - 1 - row["used_bits"], "one bit is the sign"


def test_floats_have_no_ranges(run, tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(HEAD + 'number = { format = "float32" }\n')
    result = run("verify", "mine.toml", "--ranges")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == "design 'mine': floats have no ranges, only a fixed-point design has\n"


@pytest.mark.parametrize("quantum", ["0", "-1", "nan", "1000"])
def test_a_quantum_that_is_none(run, quantum: str) -> None:
    result = run("accuracy", "--study", "number-formats", "--quantum-arcsec", quantum)
    said = f"--quantum-arcsec {float(quantum):g} is no quantum: give one above 0 and below 1000\n"
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", said)


def test_quantum_of_another_study(run) -> None:
    result = run("accuracy", "--quantum-arcsec", "1")
    said = "--quantum-arcsec belongs to --study number-formats: leave it out, or ask for that study\n"
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", said)
