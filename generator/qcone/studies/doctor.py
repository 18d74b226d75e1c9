"""What is installed, and the exact fix for what is not."""

from __future__ import annotations

import importlib.metadata
import platform
import sys

from qcone import __version__
from qcone.targets import avr, qemu
from qcone.targets.compiler import absent, compilers
from qcone.targets.probe import has_fma
from qcone.targets.sanitize import available_sanitizers

Row = dict[str, object]

PACKAGES = ("numpy", "cffi", "jinja2", "click", "rich", "pydantic", "pycparser")
EXTRAS = {"ziglang": "compiler", "unicorn": "target", "capstone": "target", "pyelftools": "target"}


def rows() -> list[Row]:
    """Return one row for each thing looked for: what, whether it is there, its version, what to do."""
    found = [
        _row(
            "python",
            platform.python_version() if sys.version_info >= (3, 11) else None,
            "install Python 3.11 or newer",
        )
    ]
    found.append(_row("qcone", __version__, ""))
    found += [_row(name, _version(name), f"pip install {name}") for name in PACKAGES]
    found += [_row(name, _version(name), f"pip install 'qcone[{extra}]'", False) for name, extra in EXTRAS.items()]
    usable = compilers()
    for each in usable:
        sanitizers = "+".join(available_sanitizers(each)) or "none"
        found.append(_row(f"compiler {each.name}", f"{each.version}, sanitizers: {sanitizers}", ""))
    for family in absent():
        fix = "pip install 'qcone[compiler]'" if family == "clang" else "apt install gcc"
        found.append(_row(f"compiler family {family}", None, fix, required=not usable))
    found.append(_row(qemu.PROGRAM, qemu.version(), qemu.FIX, False))
    found.append(_row(f"{avr.SIMULATOR} and {avr.COMPILER}", "installed" if avr.present() else None, avr.FIX, False))
    found.append(
        _row(
            "fused multiply-add in this CPU",
            "yes" if has_fma() else None,
            "contraction cannot be tested here",
            False,
        )
    )
    return found


def _version(name: str) -> str | None:
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return None


def _row(what: str, version: str | None, fix: str, required: bool = True) -> Row:
    status = "ok" if version else "missing" if required else "absent"
    return {"item": what, "status": status, "version": version, "fix": None if version else fix}
