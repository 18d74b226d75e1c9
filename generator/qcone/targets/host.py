"""Run compiled C in this process: a shared object opened by cffi (ABI mode), arrays passed by address."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cffi
import numpy as np
from numpy.typing import NDArray

from qcone.errors import MissingToolError, QconeError

_DTYPES = {
    "float": np.float32,
    "double": np.float64,
    "int8_t": np.int8,
    "int16_t": np.int16,
    "int32_t": np.int32,
    "int64_t": np.int64,
    "uint8_t": np.uint8,
    "uint16_t": np.uint16,
    "uint32_t": np.uint32,
    "uint64_t": np.uint64,
    "int": np.intc,
    "unsigned char": np.uint8,
}


class LibraryError(QconeError):
    """A shared object and its declarations do not belong together (exit code 70: a mistake of ours)."""


class Library:
    """A shared object whose functions are called with arrays and integers.

    `declarations` are plain C declarations, without directives: `void f_run(f_state *state, const float *in,
    int n);` with any structure they name. Raises MissingToolError when the object cannot be loaded here.
    """

    def __init__(self, path: Path, declarations: str) -> None:
        """Open the shared object at `path`."""
        self.path = path
        self._ffi = cffi.FFI()
        self._ffi.cdef(declarations)
        try:
            self._symbols: Any = self._ffi.dlopen(str(path.resolve()))
        except OSError as error:
            raise MissingToolError(
                f"{path.name}: this machine cannot load what the compiler built ({error}); a compiler for"
                " another machine cannot be used here: name one for this machine with --cc"
            ) from error

    def run(self, function: str, *arguments: NDArray[Any] | int) -> int | None:
        """Call `function` and return its integer, or None where it is void.

        An array goes where a pointer is declared: C-contiguous, of the pointer's element type (of any type,
        and a whole number of structures, for a pointer to a structure), and the function may write to it.
        The caller sees to the lengths. Raises LibraryError when there is no such function, TypeError when an
        argument does not fit its declaration or the function returns neither an integer nor nothing.
        """
        try:
            called = getattr(self._symbols, function)
        except AttributeError as error:
            raise LibraryError(
                f"{self.path.name} has no function {function!r} as declared: check that the routine's file is"
                f" in the build and that the name is spelt the same in both ({error})"
            ) from error
        signature = self._ffi.typeof(called)
        declared = signature.args
        if signature.result.cname in ("float", "double", "long double"):
            raise TypeError(f"{function} returns {signature.result.cname}: let it write to an array")
        if len(declared) != len(arguments):
            raise TypeError(f"{function} takes {len(declared)} arguments, got {len(arguments)}")
        passed = []
        for position, (kind, argument) in enumerate(zip(declared, arguments, strict=True), start=1):
            place = f"argument {position} of {function}"
            if kind.kind == "pointer":
                passed.append(self._address(kind, argument, place))
            elif isinstance(argument, int | np.integer):
                passed.append(int(argument))
            else:
                raise TypeError(f"{place} is declared {kind.cname}, got {_described(argument)}")
        result = called(*passed)
        return None if result is None else int(result)

    def _address(self, kind: Any, argument: object, place: str) -> Any:
        """Return the address of an array as the declared pointer, after checking that it may be one."""
        element = kind.item
        if not isinstance(argument, np.ndarray):
            raise TypeError(f"{place} is declared {kind.cname}, got {_described(argument)}")
        if not argument.flags.c_contiguous:
            raise TypeError(f"{place} must be a C-contiguous array: pass numpy.ascontiguousarray of it")
        if element.kind == "primitive":
            wanted = _DTYPES.get(element.cname)
            if wanted is None or argument.dtype != np.dtype(wanted):
                raise TypeError(f"{place} is declared {kind.cname}, got {_described(argument)}")
        elif element.kind == "struct" and argument.nbytes % self._ffi.sizeof(element) != 0:
            size = self._ffi.sizeof(element)
            raise TypeError(f"{place} must hold whole {element.cname} of {size} bytes, got {argument.nbytes}")
        memory: Any = argument  # a buffer, which its type says only from Python 3.12 on
        return self._ffi.cast(kind, self._ffi.from_buffer(memory))


def _described(argument: object) -> str:
    if isinstance(argument, np.ndarray):
        return f"an array of {argument.dtype}"
    return f"a {type(argument).__name__}"
