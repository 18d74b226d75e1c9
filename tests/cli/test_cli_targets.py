"""verify --target and cost on the command line: rows, exit codes, figures kept and compared, what cannot be asked."""

from __future__ import annotations

import builtins
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from given import GOOD, everything

from qcone.targets.emulation import Emulation, NotMeasuredError

COST = [
    *("design", "target", "compiler", "level", "instructions_min", "instructions_max", "text_bytes", "rodata_bytes"),
    *("stack_bytes", "cycles_low", "cycles_high", "calls", "fused", "soft_float"),
]
MEASURE = ("cost", "good.toml", "--target", "cortex-m4f,rv32imfc")


def rows_of(result: Any) -> list[dict[str, Any]]:
    rows: list[dict[str, Any]] = json.loads(result.stdout)["rows"]
    return rows


def test_rows_of_verify_on_targets(run, good: Path) -> None:
    result = run("verify", "good.toml", "--target", "cortex-m0,powerpc", "--rows", "200", "--format", "json")
    assert (result.exit_code, result.stderr) == (0, "")
    assert [(row["target"], row["level"], row["status"], row["differing_bits"]) for row in rows_of(result)] == [
        ("cortex-m0", "-O2", "ok", 0),
        ("powerpc", "-O2", "ok", 0),
    ]
    assert all(row["compiler"].startswith("zig ") and row["contracted"] is False for row in rows_of(result))


def test_rows_of_cost(run, good: Path) -> None:
    result = run("cost", "good.toml", "--target", "cortex-m4f,rv32imc", "--format", "json")
    assert result.exit_code == 0
    hard, soft = rows_of(result)
    assert [list(row) for row in (hard, soft)] == [COST, COST]
    assert (hard["target"], hard["calls"], hard["fused"], hard["soft_float"]) == ("cortex-m4f", "", "", "")
    assert hard["instructions_min"] == hard["instructions_max"]
    assert hard["cycles_low"] < hard["cycles_high"]
    assert soft["soft_float"] == soft["calls"] == "__addsf3, __mulsf3, __subsf3"
    assert soft["instructions_min"] < soft["instructions_max"]
    assert soft["cycles_low"] is soft["cycles_high"] is None
    assert result.stderr.splitlines()[0].startswith(
        "note: good: bytes of the compiler's own routines, not in text_bytes: "
    )
    assert (
        "note: cycles on cortex-m4: an estimate from the table of the core's manual: memory without wait"
        in result.stderr
    )


def test_levels(run, good: Path) -> None:
    result = run("cost", "good.toml", "--target", "cortex-m4f", "--level=-O2,-Os", "--format", "json")
    assert [row["level"] for row in rows_of(result)] == ["-O2", "-Os"]


@pytest.fixture
def kept(run, good: Path, tmp_path: Path) -> Path:
    """A generated design whose costs are kept, beside a README with a place for them."""
    (tmp_path / "README.md").write_text("# firmware\n<!-- costs: begin -->\nold\n<!-- costs: end -->\nrest\n")
    assert run("generate", "good.toml").exit_code == 0
    result = run(*MEASURE, "--write")
    assert result.exit_code == 0
    assert "note: kept: c_out/good/cost.json\n" in result.stderr
    return tmp_path / "c_out" / "good" / "cost.json"


def test_costs_are_kept_and_compared(run, kept: Path, tmp_path: Path) -> None:
    document = json.loads(kept.read_text())
    assert [row["target"] for row in document["rows"]] == ["cortex-m4f", "rv32imfc"]
    assert document["rows"][0]["operations"].endswith("executed")
    assert document["rows"][1]["library_bytes"] == 0
    first = document["rows"][0]
    head, table = (tmp_path / "README.md").read_text().split("<!-- costs: begin -->\n")
    assert head == "# firmware\n"
    assert f"| good | {first['instructions_max']} / {first['text_bytes']} | " in table
    assert table.endswith("<!-- costs: end -->\nrest\n")
    assert "old" not in table
    before = everything(tmp_path)
    result = run(*MEASURE, "--diff", "--format", "json")
    assert (result.exit_code, rows_of(result)) == (0, [])
    assert run(*MEASURE, "--write").exit_code == 0
    assert everything(tmp_path) == before, "the same figures are the same bytes"


def test_a_figure_that_differs_is_a_failed_check(run, kept: Path) -> None:
    document = json.loads(kept.read_text())
    was = document["rows"][0]["instructions_max"]
    document["rows"][0]["instructions_max"] = was - 1
    kept.write_text(json.dumps(document))
    result = run(*MEASURE, "--diff", "--format", "json")
    place = {"design": "good", "target": "cortex-m4f", "level": "-O2"}
    assert (result.exit_code, rows_of(result)) == (
        1,
        [{**place, "figure": "instructions_max", "kept": was - 1, "measured": was}],
    )


@pytest.mark.parametrize("figure", ["source", "compiler"])
def test_figures_of_other_c_or_another_compiler_are_told(run, kept: Path, figure: str) -> None:
    document = json.loads(kept.read_text())
    holder = document if figure == "source" else document["rows"][0]
    holder[figure] = "zig 1.0"
    kept.write_text(json.dumps(document))
    result = run("cost", "good.toml", "--target", "cortex-m4f", "--diff", "--format", "json")
    assert result.exit_code == 1
    (row,) = rows_of(result)
    assert (row["figure"], row["kept"]) == (figure, "zig 1.0")


def test_new_c_drops_the_figures_of_the_old(run, kept: Path, good: Path) -> None:
    good.write_text(GOOD.replace("subsamples = 2", "subsamples = 3"))
    assert run("generate", "good.toml").exit_code == 0
    assert run("cost", "good.toml", "--target", "cortex-m4f", "--write").exit_code == 0
    assert [row["target"] for row in json.loads(kept.read_text())["rows"]] == ["cortex-m4f"]


def test_costs_need_a_generated_design(run, good: Path, tmp_path: Path) -> None:
    result = run("cost", "good.toml", "--target", "cortex-m4f", "--write")
    assert result.exit_code == 2
    assert result.stderr.endswith(
        "c_out/good: no design was generated there; run: qcone generate DESIGN.toml -o c_out\n"
    )
    assert sorted(everything(tmp_path)) == ["good.toml"]


def test_a_file_of_costs_that_is_not_ours(run, kept: Path) -> None:
    kept.write_text("{}")
    result = run(*MEASURE, "--diff")
    assert result.exit_code == 2
    assert result.stderr.endswith(
        "c_out/good/cost.json: not a file of costs; remove it, and keep them anew with --write\n"
    )


def test_budget_of_a_target_is_a_failed_check(run, good: Path) -> None:
    budget = "\n[design.good.budget.cortex-m4f]\ntext_bytes = {}\ninstructions_max = {}\nstack_bytes = {}\n"
    good.write_text(GOOD + budget.format(10, 11, 0))
    result = run("cost", "good.toml", "--target", "cortex-m4f", "--format", "json")
    assert result.exit_code == 1
    (row,) = rows_of(result)
    said = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
    assert said == [
        f"error: good on cortex-m4f: {key} is {row[key]}, over the budget of {most}: cheapen the design or raise it"
        for key, most in (("text_bytes", 10), ("instructions_max", 11), ("stack_bytes", 0))
    ]
    good.write_text(GOOD + budget.format(1000, 1000, 1000))
    assert run("cost", "good.toml", "--target", "cortex-m4f").exit_code == 0
    good.write_text(GOOD + budget.format(0, 0, 0))
    assert run("cost", "good.toml", "--target", "cortex-m33f").exit_code == 0, "a budget is of its own target"


def test_a_gate_is_a_failed_check(run, good: Path) -> None:
    """Flags that fuse: on the Cortex-M7, where clang does it, the bits are other ones and no figure is given."""
    words = ("good.toml", "--target", "cortex-m7f", "--cflags=-ffp-contract=fast", "--format", "json")
    result = run("cost", *words)
    assert (result.exit_code, rows_of(result)) == (1, [])
    assert result.stderr.startswith("error: good on cortex-m7f: not measured: its bits are not the model's: ")
    result = run("verify", *words)
    assert (result.exit_code, rows_of(result)[0]["status"]) == (1, "contracted")


def test_flush_to_zero_is_a_failed_check(run, good: Path) -> None:
    result = run(
        "verify", "good.toml", "--target", "cortex-m4f", "--rows", "200", "--flush-to-zero", "--format", "json"
    )
    (row,) = rows_of(result)
    assert (result.exit_code, row["status"]) == (1, "flushed")
    assert row["differing_bits"] > 0


@pytest.mark.parametrize("command", ["verify", "cost"])
def test_a_crash_of_the_emulator_is_not_measured(
    run, good: Path, command: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(*_: object) -> None:
        raise NotMeasuredError("not measured: the emulator was ended by signal SIGSEGV")

    monkeypatch.setattr(Emulation, "run", crash)
    result = run(command, "good.toml", "--target", "cortex-m0", "--format", "json")
    (row,) = rows_of(result)
    assert result.exit_code == 3
    if command == "verify":
        assert (row["status"], row["differing_bits"]) == ("not-measured", None)
        assert row["first_difference"] == "not measured: the emulator was ended by signal SIGSEGV"
    else:
        assert {key for key, value in row.items() if value is not None} == {"design", "target", "level"}
        assert "good on cortex-m0: not measured: the emulator was ended by signal SIGSEGV\n" in result.stderr


@pytest.mark.parametrize("package", ["unicorn", "capstone", "elftools"])
@pytest.mark.parametrize("command", ["verify", "cost"])
def test_missing_package_of_the_extra(
    run, good: Path, command: str, package: str, hide: Callable[[str], None], tmp_path: Path
) -> None:
    hide(package)
    result = run(command, "good.toml", "--target", "cortex-m0")
    assert (result.exit_code, result.stdout) == (3, "")
    name = {"elftools": "pyelftools"}.get(package, package)
    assert result.stderr == (
        f"{name} is not installed, which targets other than the host need; run: pip install 'qcone[target]'\n"
    )
    assert sorted(everything(tmp_path)) == ["good.toml"]


@pytest.mark.usefixtures("no_compiler", "good")
@pytest.mark.parametrize("command", ["verify", "cost"])
def test_missing_ziglang(run, command: str) -> None:
    result = run(command, "good.toml", "--target", "cortex-m0")
    assert (result.exit_code, result.stdout) == (3, "")
    assert result.stderr == (
        "ziglang is not installed, which compiles for targets other than the host; run: pip install 'qcone[target]'\n"
    )


@pytest.fixture
def hide(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], None]:
    """Make a package impossible to import, here and in the emulator's process."""
    from qcone.targets import cross, emulation

    def away(package: str) -> None:
        cross._read.cache_clear()
        folder = tmp_path_factory.mktemp("hidden")
        (folder / f"{package}.py").write_text("raise ImportError('hidden')\n")
        monkeypatch.setattr(emulation.sys, "path", [str(folder), *emulation.sys.path])
        honest = builtins.__import__

        def refuse(name: str, *rest: Any) -> Any:
            if name.split(".")[0] == package:
                raise ImportError("hidden")
            return honest(name, *rest)

        monkeypatch.setattr(builtins, "__import__", refuse)

    return away


REFUSED = {
    ("verify", "good.toml", "--target", "cortex-m4f", "--executor", "qemu", "--flush-to-zero"): (
        "--flush-to-zero: only the executor unicorn has it; leave --executor out\n"
    ),
    ("verify", "good.toml", "--target", "cortex-m0", "--flush-to-zero"): (
        "--flush-to-zero: cortex-m0 has no such mode; the targets that have it: cortex-m4f, cortex-m7f, cortex-m33f\n"
    ),
    ("verify", "good.toml", "--target", "rv32imc", "--executor", "qemu"): (
        "--executor qemu: rv32imc has no board in it; those that have one: cortex-m0, cortex-m3, cortex-m4, "
        "cortex-m4f, cortex-m7f, cortex-m33f\n"
    ),
    (
        "cost",
        "good.toml",
        "--target",
        "cortexm4f",
    ): "--target cortexm4f: unknown target; did you mean 'cortex-m4f'?\n",
    ("cost", "good.toml", "--target", "host"): (
        "--target host: what an update costs is measured on the other targets; name one of them\n"
    ),
    ("verify", "good.toml", "--target", "cortex-m0", "--executor", "simavr"): (
        "--target cortex-m0: --executor simavr plays one AVR, in its own way; leave the option out\n"
    ),
    ("cost", "good.toml", "--level", "-O9"): "--level -O9: the levels are -O0, -O1, -O2, -O3, -Os\n",
    ("cost", "good.toml", "--elf", "a.elf"): (
        "--elf: say which one target the program is for, as in --target cortex-m4f\n"
    ),
    ("cost", "good.toml", "--elf", "a.elf", "--target", "cortex-m0", "--cc", "gcc"): (
        "--cc gcc: the program of --elf is built already; leave it out\n"
    ),
    ("cost", "good.toml", "--elf", "a.elf", "--target", "cortex-m0"): (
        "--elf a.elf: No such file or directory; give the program your linker wrote\n"
    ),
    ("cost", "good.toml", "--elf", "good.toml", "--target", "cortex-m0"): (
        "good.toml: not a whole ELF file: Magic number does not match; give what the linker wrote\n"
    ),
    ("cost", "good.toml", "--elf", "a.elf", "--target", "cortex-m0", "--write"): (
        "--elf: figures of a program of your own are not kept; leave out --write and --diff\n"
    ),
    ("cost", "good.toml", "--write", "--diff"): (
        "--write and --diff: choose one; --diff shows what --write would change\n"
    ),
}


@pytest.mark.parametrize("words", REFUSED, ids=" ".join)
def test_what_cannot_be_asked(run, good: Path, tmp_path: Path, words: tuple[str, ...]) -> None:
    result = run(*words)
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", REFUSED[words])
    assert sorted(everything(tmp_path)) == ["good.toml"]


@pytest.mark.usefixtures("good")
def test_compiler_of_another_machine(run, missing_tool) -> None:
    gcc = next((each for each in _compilers() if each.family == "gcc" and "arm" not in each.machine), None)
    if gcc is None:
        missing_tool("gcc (apt install gcc)")
    for command in ("verify", "cost"):
        result = run(command, "good.toml", "--target", "cortex-m0", "--cc", gcc.command[0])
        assert (result.exit_code, result.stdout) == (2, "")
        assert result.stderr == (
            f"--cc {gcc.name}: it compiles for {gcc.machine}, not for cortex-m0; name a arm-none-eabi gcc, or leave "
            "--cc out\n"
        )


def _compilers() -> Any:
    from qcone.targets.compiler import compilers

    return compilers()
