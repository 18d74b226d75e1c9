"""A design file that is right: defaults, exact numbers, several designs, a user's own function."""

from __future__ import annotations

import pickle
import subprocess
import sys
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

import pytest
from fake_catalogue import CATALOGUE, GOOD
from hypothesis import given
from hypothesis import strategies as st

from qcone.design import DESIGN_KEYS, NUMBER_KEYS, Design, Imu, Number, Rins, read_designs
from qcone.errors import UsageError

FULL = """\
[design.att_counts]
algorithm = "picard"
order = 3
input = "counts"
increments = "cao-13"
axes = "y, -x,z"
outputs = ["euler", "quaternion"]
form = "factored"
euler = "zxy"
loop = "rolled"
exponential = "taylor"
renormalise = "separate"
core = "cortex-m4f"
multiply = "limbs-shared"
license = "LicenseRef-Own-1.0"
rins = { max_correction_arcsec = 90.5 }
imu = { update_hz = 99.2, max_rate_dps = 1_000.5, quantum_dps = "2000/32768", max_jerk_dps3 = 1e6 }

[design.att_counts.number]
format = "fixed16"
accumulate = "standard"
overflow = "wrap"
rounding = "even"
clamp_inputs = true

[design.att_counts.budget]
multiply = 60
square_root = 0
cortex-m4f.text_bytes = 2048
[design.att_counts.budget.powerpc]
stack_bytes = 64
"""


SOURCES = str(Path(__file__).parents[2] / "generator")


def _read(folder: Path, text: str) -> tuple[Design, ...]:
    file = folder / "designs.toml"
    file.write_text(text, encoding="utf-8")
    return read_designs(file, CATALOGUE)


def test_every_key_but_four_has_a_default(tmp_path: Path) -> None:
    assert _read(tmp_path, GOOD) == (
        Design(
            name="att",
            file="designs.toml",
            algorithm="rotation-vector",
            parameters={"coefficients": None, "previous": 0, "subsamples": 1},
            input="increment",
            increments="interpolating",
            axes=((0, 1), (1, 1), (2, 1)),
            outputs=("quaternion",),
            form="factored",
            euler="zyx",
            loop="unrolled",
            exponential="minimax",
            renormalise="every",
            core="generic",
            multiply="auto",
            license="MIT-0",
            imu=Imu(Fraction(100), Fraction(573), None, None, None, None, None),
            number=Number("float32", "delta", "prove", "up", False),
            budget={},
            target_budgets={},
        ),
    )


def test_parameters_are_sorted_by_name(tmp_path: Path) -> None:
    assert list(_read(tmp_path, GOOD)[0].parameters) == ["coefficients", "previous", "subsamples"]


def test_every_key_is_read(tmp_path: Path) -> None:
    (design,) = _read(tmp_path, FULL)
    assert design == Design(
        name="att_counts",
        file="designs.toml",
        algorithm="picard",
        parameters={"order": 3},
        input="counts",
        increments="cao-13",
        axes=((1, 1), (0, -1), (2, 1)),
        outputs=("euler", "quaternion"),
        form="factored",
        euler="zxy",
        loop="rolled",
        exponential="taylor",
        renormalise="separate",
        core="cortex-m4f",
        multiply="limbs-shared",
        license="LicenseRef-Own-1.0",
        imu=Imu(
            update_hz=Fraction(992, 10),
            max_rate_dps=Fraction(10005, 10),
            max_angular_acceleration_dps2=None,
            max_jerk_dps3=Fraction(1000000),
            quantum_dps=Fraction(2000, 32768),
            bias_dps=None,
            calibration=None,
        ),
        number=Number("fixed16", "standard", "wrap", "even", True),
        budget={"multiply": 60, "square_root": 0},
        target_budgets={"cortex-m4f": {"text_bytes": 2048}, "powerpc": {"stack_bytes": 64}},
        rins=Rins(Fraction(181, 2)),
    )
    assert design.directory == tmp_path


def test_an_empty_table_asks_for_the_stage_with_its_default(tmp_path: Path) -> None:
    assert _read(tmp_path, GOOD)[0].rins is None
    assert _read(tmp_path, GOOD + "[design.att.rins]\n")[0].rins == Rins(Fraction(600))
    assert _read(tmp_path, GOOD + "[design.att.rins]\nmax_correction_arcsec = 36000\n")[0].rins == Rins(Fraction(36000))


def test_bias_and_calibration_are_exact_as_written(tmp_path: Path) -> None:
    keys = 'bias_dps = [0.1, "-1/3", 2]\ncalibration = [[1.01, 0, 0], [0, "99/100", 0], [0, 0, 1]]\n'
    text = GOOD.replace('"rotation-vector"', '"rotation-vector"\ninput = "counts"')
    (design,) = _read(tmp_path, text.replace("573\n", f"573\nquantum_dps = 0.061\n{keys}"))
    assert design.imu.quantum_dps == Fraction(61, 1000)
    assert design.imu.bias_dps == (Fraction(1, 10), Fraction(-1, 3), Fraction(2))
    zero, one = Fraction(0), Fraction(1)
    assert design.imu.calibration == (
        (Fraction(101, 100), zero, zero),
        (zero, Fraction(99, 100), zero),
        (zero, zero, one),
    )


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("100", Fraction(100)),
        ("99.2", Fraction(496, 5)),
        ("0.1", Fraction(1, 10)),
        ("1e3", Fraction(1000)),
        ("1_0.5", Fraction(21, 2)),
        ("333.33333333333333333333", Fraction(33333333333333333333333, 10**20)),
    ],
)
def test_a_number_is_the_decimal_that_was_written(tmp_path: Path, written: str, value: Fraction) -> None:
    text = GOOD.replace("update_hz = 100", f"update_hz = {written}").replace("573", "10")
    (design,) = _read(tmp_path, text)
    assert design.imu.update_hz == value
    assert isinstance(design.imu.update_hz, Fraction)


def test_designs_come_in_the_order_of_the_file(tmp_path: Path) -> None:
    names = ["zeta", "alpha", "mid_1"]
    text = "\n".join(GOOD.replace("design.att", f"design.{name}") for name in names)
    assert [design.name for design in _read(tmp_path, text)] == names


def test_a_byte_order_mark_and_windows_line_ends_are_accepted(tmp_path: Path) -> None:
    file = tmp_path / "designs.toml"
    file.write_bytes(b"\xef\xbb\xbf" + GOOD.replace("\n", "\r\n").encode())
    assert read_designs(file, CATALOGUE) == _read(tmp_path, GOOD)


def test_a_users_own_function_has_no_parameters_of_ours(tmp_path: Path) -> None:
    (design,) = _read(tmp_path, GOOD.replace("rotation-vector", "sub/my_paper.py:my_update"))
    assert design.algorithm == "sub/my_paper.py:my_update"
    assert design.parameters == {}
    assert design.directory == tmp_path


@pytest.mark.parametrize(
    "name",
    ["a", "a" * 64, "x_1", "att_cao3_fixed32", "integer", "rotation_vector_3_coning_fixed32_compensated"],
)
def test_a_c_identifier_in_lower_case_names_a_design(tmp_path: Path, name: str) -> None:
    assert _read(tmp_path, GOOD.replace("design.att", f"design.{name}"))[0].name == name


def test_the_as_written_form_is_accepted_without_words_of_ours(tmp_path: Path) -> None:
    text = GOOD.replace("[design.att.imu]", 'form = "as-written"\n[design.att.imu]')
    assert _read(tmp_path, text)[0].form == "as-written"


def test_half_a_turn_an_update_is_still_allowed(tmp_path: Path) -> None:
    (design,) = _read(tmp_path, GOOD.replace("573", "18000"))
    assert design.imu.max_rate_dps / design.imu.update_hz == 180


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    file = tmp_path / "absent.toml"
    with pytest.raises(UsageError) as caught:
        read_designs(file, CATALOGUE)
    assert str(caught.value) == f"cannot read design file {file.as_posix()}: No such file or directory"
    assert caught.value.exit_code == 2


def test_a_folder_is_not_a_design_file(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        read_designs(tmp_path, CATALOGUE)
    assert str(caught.value) == f"cannot read design file {tmp_path.as_posix()}: Is a directory"


def test_a_design_can_be_hashed_and_sent_to_another_process(tmp_path: Path) -> None:
    (design,) = _read(tmp_path, FULL)
    again = pickle.loads(pickle.dumps(design))
    assert again == design
    assert hash(again) == hash(design)


def test_importing_the_package_loads_no_pydantic_and_nothing_else_of_ours() -> None:
    code = (
        "import sys, qcone.design\n"
        "ours = {n for n in sys.modules if n.startswith('qcone.') and not n.startswith('qcone.design')}\n"
        "print(sorted(ours), 'pydantic' in sys.modules, 'numpy' in sys.modules)"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env={"PYTHONPATH": SOURCES}
    )
    assert result.stdout == "['qcone.errors'] False False\n"


def _drawn_words(fixed: bool) -> st.SearchStrategy[dict[str, object]]:
    words = {
        key.name: st.sampled_from(key.choices)
        for key in DESIGN_KEYS
        if key.kind == "choice" and key.name not in ("input", "form")
    }
    number = {
        f"number.{key.name}": st.booleans() if key.kind == "flag" else st.sampled_from(key.choices)
        for key in NUMBER_KEYS
        if key.kind != "pins" and (key.name == "accumulate" or (fixed and key.name != "format"))
    }
    if fixed:
        pins = st.dictionaries(st.sampled_from(["phi_x", "dq_w", "u"]), st.integers(0, 62), min_size=1)
        number["number.pins"] = pins.map(_pin_words)
    formats = ["fixed32", "fixed16"] if fixed else ["float32", "float64"]
    own = {
        "coefficients": st.sampled_from(["taylor", "coning"]),
        "previous": st.integers(0, 5),
        "axes": st.permutations("xyz").flatmap(
            lambda axes: st.tuples(*(st.sampled_from([axis, f"-{axis}"]) for axis in axes)).map(",".join)
        ),
        "outputs": st.lists(st.sampled_from(["quaternion", "dcm", "euler"]), min_size=1, unique=True),
    }
    required = {
        "subsamples": st.integers(2, 6),
        "number.format": st.sampled_from(formats),
        "imu.update_hz": st.decimals(1, 9999, places=3),
        "imu.max_rate_dps": st.decimals("0.001", 180, places=3),
    }
    return st.fixed_dictionaries(required, optional={**words, **number, **own})


def _pin_words(pins: Mapping[str, int]) -> list[str]:
    return [f"{name} = {bits}" for name, bits in pins.items()]


def _toml(values: dict[str, object]) -> str:
    def spelled(value: object) -> str:
        if isinstance(value, bool):
            return str(value).lower()
        if isinstance(value, list | tuple):
            return f"[{', '.join(map(spelled, value))}]"
        return f'"{value}"' if isinstance(value, str) else str(value)

    lines = [f"{key} = {spelled(value)}" for key, value in values.items()]
    return "\n".join(["[design.att]", 'algorithm = "rotation-vector"', *lines, ""])


def _written_out(design: Design) -> dict[str, object]:
    """Every resolved value as a design file would say it, defaults included."""
    axes = ",".join(("-" if sign < 0 else "") + "xyz"[axis] for axis, sign in design.axes)
    words = {key.name: getattr(design, key.name) for key in DESIGN_KEYS if key.name != "algorithm"}
    parameters = {name: value for name, value in design.parameters.items() if value is not None}
    fixed = design.number.format.startswith("fixed")
    number = {
        f"number.{key.name}": getattr(design.number, key.name)
        for key in NUMBER_KEYS
        if fixed or key.name in ("format", "accumulate")
    }
    if pins := number.pop("number.pins", None):
        number["number.pins"] = _pin_words(dict(pins))
    rates = {f"imu.{key}": float(getattr(design.imu, key)) for key in ("update_hz", "max_rate_dps")}
    return words | parameters | number | rates | {"axes": axes}


@given(st.booleans().flatmap(_drawn_words))
def test_a_design_written_out_in_full_reads_the_same(
    tmp_path_factory: pytest.TempPathFactory, values: dict[str, object]
) -> None:
    folder = tmp_path_factory.getbasetemp()
    (design,) = _read(folder, _toml(values))
    (again,) = _read(folder, _toml(_written_out(design)))
    assert again == design
    assert again.digest == design.digest
    assert design.imu.update_hz == Fraction(values["imu.update_hz"])  # type: ignore[arg-type]
    given_words = {name: value for name, value in values.items() if hasattr(design, name) and name != "axes"}
    for name, value in given_words.items():
        assert getattr(design, name) == (tuple(value) if isinstance(value, list) else value)
