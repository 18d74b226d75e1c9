from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from qcone.errors import MissingToolError
from qcone.targets.build import build_shared
from qcone.targets.compiler import Compiler
from qcone.targets.host import Library, LibraryError

DECLARATIONS = """\
typedef struct { float q[4]; int32_t count; } part_state;
void negate_float(const float *in, float *out, int n);
void negate_double(const double *in, double *out, int n);
void negate_int16(const int16_t *in, int16_t *out, int n);
void negate_int32(const int32_t *in, int32_t *out, int n);
void negate_int64(const int64_t *in, int64_t *out, int n);
void count_up(part_state *states, int n);
int add(int a, int b);
double half(double a);
"""


def _negate(name: str, c_type: str) -> str:
    return (
        f"void negate_{name}(const {c_type} *in, {c_type} *out, int n)\n"
        f"{{ for (int i = 0; i < n; i++) out[i] = ({c_type})-in[i]; }}\n"
    )


TEXT = (
    "#include <stdint.h>\n"
    + DECLARATIONS
    + _negate("float", "float")
    + _negate("double", "double")
    + "".join(_negate(f"int{bits}", f"int{bits}_t") for bits in (16, 32, 64))
    + "void count_up(part_state *s, int n)\n"
    "{ for (int i = 0; i < n; i++) { s[i].count++; s[i].q[3] = 0.5F; } }\n"
    "int add(int a, int b) { return a + b; }\n"
    "double half(double a) { return a / 2; }\n"
)


@pytest.fixture
def library(each_compiler: Compiler) -> Library:
    return Library(build_shared(each_compiler, {"part.c": TEXT}, "-O2"), DECLARATIONS + "int gone(void);")


@pytest.mark.parametrize(
    ("name", "dtype"),
    [
        ("float", np.float32),
        ("double", np.float64),
        ("int16", np.int16),
        ("int32", np.int32),
        ("int64", np.int64),
    ],
)
def test_arrays_are_read_and_written_in_place(library: Library, name: str, dtype: type) -> None:
    given = np.arange(1, 7, dtype=dtype).reshape(2, 3)
    out = np.zeros((2, 3), dtype)
    assert library.run(f"negate_{name}", given, out, 6) is None
    np.testing.assert_array_equal(out, -given)


def test_structures_are_whole_bytes_of_an_array(library: Library) -> None:
    states = np.zeros(3 * 20, np.uint8)
    library.run("count_up", states, 3)
    whole = states.view(np.dtype([("q", np.float32, 4), ("count", np.int32)]))
    np.testing.assert_array_equal(whole["count"], [1, 1, 1])
    np.testing.assert_array_equal(whole["q"], [[0, 0, 0, 0.5]] * 3)
    with pytest.raises(TypeError, match="argument 1 of count_up must hold whole part_state of 20 bytes, got 19"):
        library.run("count_up", states[:19].copy(), 1)


def test_integers_go_in_and_come_back(library: Library) -> None:
    assert library.run("add", 40, np.int64(2)) == 42


def test_missing_function_names_the_function(library: Library) -> None:
    with pytest.raises(LibraryError, match=r"has no function 'gone' as declared: check .*gone"):
        library.run("gone")
    with pytest.raises(LibraryError, match="has no function 'never_declared'"):
        library.run("never_declared")


def test_wrong_element_type_is_refused(library: Library) -> None:
    wide = np.zeros(3)
    with pytest.raises(TypeError, match=r"argument 1 of negate_float is declared float \*, got an array of float64"):
        library.run("negate_float", wide, wide, 3)
    swapped = np.zeros(3, ">f8")
    with pytest.raises(TypeError, match="got an array of >f8"):
        library.run("negate_double", wide, swapped, 3)


def test_array_with_gaps_is_refused(library: Library) -> None:
    columns = np.zeros((3, 2))[:, 0]
    with pytest.raises(TypeError, match="argument 2 of negate_double must be a C-contiguous array"):
        library.run("negate_double", np.zeros(3), columns, 3)


def test_wrong_kinds_and_numbers_of_arguments_are_refused(library: Library) -> None:
    with pytest.raises(TypeError, match="add takes 2 arguments, got 1"):
        library.run("add", 1)
    with pytest.raises(TypeError, match=r"argument 1 of negate_double is declared double \*, got a int"):
        library.run("negate_double", 1, np.zeros(1), 1)
    with pytest.raises(TypeError, match="argument 2 of add is declared int, got an array of float64"):
        library.run("add", 1, np.zeros(1))
    with pytest.raises(OverflowError):
        library.run("add", 2**31, 0)


def test_floating_result_is_refused_not_truncated(library: Library) -> None:
    with pytest.raises(TypeError, match="half returns double: let it write to an array"):
        library.run("half", 3)


def test_object_for_no_machine_is_a_clear_error(tmp_path: Path) -> None:
    path = tmp_path / "product.so"
    path.write_text("not a library")
    with pytest.raises(MissingToolError, match=r"^product\.so: this machine cannot load .* with --cc$") as caught:
        Library(path, "int add(int a, int b);")
    assert caught.value.exit_code == 3
