"""Files on disk: what generate writes, what it refuses to touch, and how it tells stale, edited and missing apart."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from given import GOOD, everything

FILES = ["src/good.h", "src/good.c", "test/good_run.c", "manifest.json"]
TWO = GOOD + GOOD.replace("design.good", "design.second")
LOST = "its changes would be lost: move them into the design, or overwrite the file with --force\n"


def statuses(result) -> dict[str, str]:
    return {f"{row['design']}/{row['file']}": row["status"] for row in json.loads(result.stdout)["rows"]}


def each(status: str, **other: str) -> dict[str, str]:
    """Return that every file of the design has a status, but for those named by their ending."""
    return {f"good/{file}": other.get(file.rpartition(".")[2], status) for file in FILES}


def generate(run, *words: str):
    return run("generate", "good.toml", *words, "--format", "json")


def test_first_again_and_check(run, good: Path, tmp_path: Path) -> None:
    result = generate(run, "--check")
    assert (result.exit_code, statuses(result)) == (1, each("missing"))
    assert sorted(everything(tmp_path)) == ["good.toml"]
    result = generate(run)
    assert (result.exit_code, statuses(result)) == (0, each("created"))
    first = everything(tmp_path)
    result = generate(run, "--check")
    assert (result.exit_code, statuses(result)) == (0, each("fresh"))
    result = generate(run)
    assert (result.exit_code, statuses(result)) == (0, each("same"))
    assert everything(tmp_path) == first
    assert not [name for name in first if name.endswith((".partial", ".o", ".so"))]


def test_bytes_are_those_written(run, good: Path, tmp_path: Path) -> None:
    for row in json.loads(generate(run).stdout)["rows"]:
        assert (tmp_path / "c_out" / row["design"] / row["file"]).stat().st_size == row["bytes"]


def test_missing_stale_and_edited_are_told_apart(run, good: Path, tmp_path: Path) -> None:
    generate(run)
    folder = tmp_path / "c_out" / "good"
    (folder / "src/good.h").unlink()
    result = generate(run, "--check")
    assert (result.exit_code, statuses(result)) == (1, each("fresh", h="missing"))
    generate(run)
    good.write_text(GOOD.replace("573", "500"))
    result = generate(run, "--check")
    assert result.exit_code == 1
    assert statuses(result) == {**each("stale"), "good/test/good_run.c": "fresh"}
    assert statuses(generate(run)) == {**each("changed"), "good/test/good_run.c": "same"}
    (folder / "src/good.c").write_text((folder / "src/good.c").read_text().replace("q_w", "q_v"))
    result = generate(run, "--check")
    assert result.exit_code == 1
    assert statuses(result) == {**each("fresh"), "good/src/good.c": "edited"}


def test_edited_and_stale_at_once_is_edited(run, good: Path, tmp_path: Path) -> None:
    """The hand's work must not be lost because the design changed too."""
    generate(run)
    file = tmp_path / "c_out/good/src/good.c"
    file.write_text(file.read_text() + "\n")
    good.write_text(GOOD.replace("573", "500"))
    assert statuses(generate(run, "--check"))["good/src/good.c"] == "edited"
    assert generate(run).exit_code == 1


@pytest.mark.parametrize("path", ["src/good.c", "src/good.h", "test/good_run.c"])
def test_edited_file_is_not_overwritten_without_force(run, good: Path, tmp_path: Path, path: str) -> None:
    generate(run)
    file = tmp_path / "c_out" / "good" / path
    whole = file.read_text()
    file.write_text("/* mine */\n" + whole)
    before = everything(tmp_path)
    result = run("generate", "good.toml")
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr == f"c_out/good/{path}: edited by hand; {LOST}"
    assert everything(tmp_path) == before
    result = generate(run, "--force")
    assert (result.exit_code, statuses(result)[f"good/{path}"]) == (0, "changed")
    assert file.read_text() == whole


def test_files_without_a_manifest_are_somebody_s(run, good: Path, tmp_path: Path) -> None:
    file = tmp_path / "c_out/good/src/good.c"
    file.parent.mkdir(parents=True)
    file.write_text("int mine;\n")
    result = run("generate", "good.toml")
    assert (result.exit_code, result.stderr) == (1, f"c_out/good/src/good.c: edited by hand; {LOST}")
    assert file.read_text() == "int mine;\n"


@pytest.mark.parametrize("text", ["not JSON", "[]", '{"files": 3}', '{"files": {"src/good.c": 7}}'])
def test_spoilt_manifest_is_edited_by_hand(run, good: Path, tmp_path: Path, text: str) -> None:
    generate(run)
    (tmp_path / "c_out/good/manifest.json").write_text(text)
    result = generate(run, "--check")
    assert (result.exit_code, statuses(result)) == (1, each("fresh", json="edited"))
    result = run("generate", "good.toml")
    assert (result.exit_code, result.stderr) == (1, f"c_out/good/manifest.json: edited by hand; {LOST}")
    assert (tmp_path / "c_out/good/manifest.json").read_text() == text
    assert statuses(generate(run, "--force")) == each("same", json="changed")


def test_a_manifest_with_one_word_changed_is_edited_by_hand(run, good: Path, tmp_path: Path) -> None:
    generate(run)
    manifest = tmp_path / "c_out/good/manifest.json"
    manifest.write_text(manifest.read_text().replace('"not bounded"', '"bounded"', 1))
    assert statuses(generate(run, "--check")) == each("fresh", json="edited")


def test_dry_run_and_diff_write_nothing(run, good: Path, tmp_path: Path) -> None:
    result = generate(run, "--dry-run")
    assert (result.exit_code, statuses(result)) == (0, each("missing"))
    result = run("generate", "good.toml", "--diff")
    assert result.exit_code == 1
    assert "--- a/good/src/good.c\n+++ b/good/src/good.c\n@@ -0,0 +1," in result.stdout
    assert sorted(everything(tmp_path)) == ["good.toml"]
    generate(run)
    result = run("generate", "good.toml", "--diff")
    assert (result.exit_code, result.output) == (0, "")
    good.write_text(GOOD.replace("573", "500"))
    before = everything(tmp_path)
    result = run("generate", "good.toml", "--diff")
    assert result.exit_code == 1
    assert "\n- * range:       |omega| <= 573 deg/s" in result.stdout
    assert "\n+ * range:       |omega| <= 500 deg/s" in result.stdout
    assert everything(tmp_path) == before


def test_one_design_of_a_file(run, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(TWO)
    run("generate", "two.toml", "--design", "second")
    assert [path.name for path in (tmp_path / "c_out").iterdir()] == ["second"]


def test_one_name_in_two_files(run, good: Path, tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text(GOOD.replace("573", "500"))
    before = everything(tmp_path)
    for command in ("generate", "verify"):
        result = run(command, "good.toml", "other.toml")
        assert (result.exit_code, result.stdout) == (2, "")
        assert result.stderr == (
            "design 'good' stands in more than one of good.toml, other.toml; give one another name\n"
        )
    assert everything(tmp_path) == before


@pytest.mark.parametrize("output", ["taken", "taken/below"])
def test_file_in_the_place_of_the_output_folder(run, good: Path, tmp_path: Path, output: str) -> None:
    (tmp_path / "taken").write_text("a file\n")
    before = everything(tmp_path)
    result = run("generate", "good.toml", "-o", output)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == (
        f"{output}/good: cannot write the design there: Not a directory; choose another folder with -o\n"
    )
    assert everything(tmp_path) == before


def test_folder_in_the_place_of_a_file(run, good: Path, tmp_path: Path) -> None:
    (tmp_path / "c_out/good/src/good.c").mkdir(parents=True)
    before = everything(tmp_path)
    result = run("generate", "good.toml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("c_out/good: cannot write the design there: ")
    assert everything(tmp_path) == before


def test_second_design_that_cannot_be_written_leaves_the_first_alone(run, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(TWO)
    (tmp_path / "c_out").mkdir()
    (tmp_path / "c_out" / "second").write_text("a file\n")
    before = everything(tmp_path)
    result = run("generate", "two.toml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("c_out/second: cannot write the design there: ")
    assert everything(tmp_path) == before


def test_second_design_edited_by_hand_leaves_the_first_alone(run, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(TWO)
    run("generate", "two.toml")
    (tmp_path / "c_out/second/src/second.c").write_text("int mine;\n")
    (tmp_path / "two.toml").write_text(TWO.replace("573", "500"))
    before = everything(tmp_path)
    result = run("generate", "two.toml")
    assert (result.exit_code, result.stderr) == (1, f"c_out/second/src/second.c: edited by hand; {LOST}")
    assert everything(tmp_path) == before


@pytest.mark.usefixtures("flipped_bit", "good")
def test_result_of_a_failed_comparison_is_not_written(run, tmp_path: Path) -> None:
    result = run("generate", "good.toml")
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr.startswith("good: not written: differs: lane 0, step 1, dcm 33: C ")
    assert sorted(everything(tmp_path)) == ["good.toml"]
