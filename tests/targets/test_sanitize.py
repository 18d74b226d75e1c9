from __future__ import annotations

import struct
import sys
from pathlib import Path

import pytest

from qcone.targets.build import CompileError
from qcone.targets.compiler import Compiler
from qcone.targets.sanitize import SanitizerReport, available_sanitizers, run_sanitized

HEADER = "#include <stdint.h>\nint32_t routine(int32_t a, int32_t b);\n"
ADD = HEADER + "int32_t routine(int32_t a, int32_t b) { return a + b; }\n"
TWO_PLACES = HEADER + (
    "int32_t routine(int32_t a, int32_t b)\n{\n    const int32_t sum = a + b;\n    return sum ^ (a * 2);\n}\n"
)
OVERRUN = HEADER + (
    "int32_t routine(int32_t a, int32_t b)\n{\n    int32_t w[2] = {a, b};\n"
    "    int32_t *volatile p = w;\n    return p[b];\n}\n"
)
MAIN = """\
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
int32_t routine(int32_t a, int32_t b);
int main(int argc, char **argv)
{
    int32_t row[2];
    FILE *vectors = fopen(argv[1], "rb");
    FILE *result = fopen(argv[2], "wb");
    if (argc != 3 || vectors == NULL || result == NULL) { return 9; }
    while (fread(row, sizeof row, 1, vectors) == 1) {
        const int32_t out = routine(row[0], row[1]);
        if (fwrite(&out, sizeof out, 1, result) != 1) { return 9; }
    }
    return fclose(vectors) + fclose(result);
}
"""
LARGEST = 2**31 - 1


def _run(compiler: Compiler, routine: str, *rows: tuple[int, int], main: str = MAIN) -> SanitizerReport:
    vectors = b"".join(struct.pack("=2i", *row) for row in rows)
    return run_sanitized(compiler, {"routine.c": routine}, "-O1", main, vectors, timeout_s=10.0)


def test_clean_routine_has_no_report_and_its_output_comes_back(each_compiler: Compiler) -> None:
    report = _run(each_compiler, ADD, (1, 2), (LARGEST, -1))
    assert report == SanitizerReport(
        True, 0, "", struct.pack("=2i", 3, LARGEST - 1), available_sanitizers(each_compiler)
    )
    assert "undefined" in report.sanitizers


def test_signed_overflow_is_reported_with_its_place(each_compiler: Compiler) -> None:
    report = _run(each_compiler, ADD, (1, 2), (LARGEST, 1))
    assert report.reports == 1
    assert report.first.startswith("routine.c:3:")
    assert "overflow" in report.first


def test_every_place_is_counted_once(each_compiler: Compiler) -> None:
    report = _run(each_compiler, TWO_PLACES, *[(LARGEST, 1)] * 3)
    assert report.reports == 2
    assert report.first.startswith("routine.c:5:")
    assert len(report.output) == 12


def test_read_past_the_end_is_caught_by_the_address_sanitizer(gcc: Compiler) -> None:
    assert available_sanitizers(gcc) == ("undefined", "address")
    report = _run(gcc, OVERRUN, (1, 0), (1, 2))
    assert report.reports == 1
    assert report.first == "SUMMARY: AddressSanitizer: stack-buffer-overflow routine.c:7 in routine"


def test_first_report_names_no_address(gcc: Compiler) -> None:
    misaligned = HEADER + (
        "int32_t routine(int32_t a, int32_t b)\n{\n    int32_t w[2] = {a, b};\n"
        "    char *volatile p = (char *)w + 1;\n    return *(int32_t *)(void *)p;\n}\n"
    )
    report = _run(gcc, misaligned, (1, 2))
    assert report.reports >= 1
    assert report.first.startswith("routine.c:7:")
    assert "misaligned address 0x... for" in report.first


def test_signal_is_a_report(each_compiler: Compiler) -> None:
    killed = "#include <signal.h>\nint main(void) { return raise(SIGKILL); }\n"
    report = _run(each_compiler, ADD, main=killed)
    assert (report.reports, report.first) == (1, "the program was ended by signal SIGKILL")
    assert report.output == b""


def test_failed_exit_is_a_report(each_compiler: Compiler) -> None:
    report = _run(each_compiler, ADD, main="int main(void) { return 5; }\n")
    assert (report.reports, report.first) == (1, "the program ended with exit code 5: ")


def test_run_without_end_is_a_report(gcc: Compiler) -> None:
    endless = "int main(void) { for (;;) { } }\n"
    report = run_sanitized(gcc, {"routine.c": ADD}, "-O1", endless, b"", timeout_s=0.2)
    assert (report.reports, report.first) == (1, "the program did not end within 0.2 s")


def test_text_that_does_not_compile_is_an_error_not_a_clean_run(each_compiler: Compiler) -> None:
    with pytest.raises(CompileError, match="broken"):
        _run(each_compiler, HEADER + "broken\n", (1, 2))


def test_compiler_that_ignores_the_flags_has_no_sanitizer(gcc: Compiler, tmp_path: Path) -> None:
    script = tmp_path / "deaf.py"
    script.write_text(
        "import subprocess, sys\n"
        f"heard = [word for word in sys.argv[1:] if not word.startswith('-fsanitize')]\n"
        f"sys.exit(subprocess.run([{gcc.command[0]!r}, *heard]).returncode)\n"
    )
    deaf = Compiler("deaf", (sys.executable, str(script)), "gcc", "1.0")
    assert available_sanitizers(deaf) == ()
    assert _run(deaf, ADD, (LARGEST, 1)) == SanitizerReport(False, 0, "", b"", ())
