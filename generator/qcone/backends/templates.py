"""Find and render templates: the one file that knows where they live, and the one that loads jinja2."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

PACKAGE = Path(__file__).parents[1]
PLACES = (PACKAGE / "templates", PACKAGE.parents[1] / "templates")
"""In an installed wheel, beside the package; in a checkout, at its top."""


@cache
def _environment() -> Environment:
    return Environment(
        loader=FileSystemLoader([str(place) for place in PLACES]),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )


def render(name: str, **context: Any) -> str:
    """Return the template of that name, filled in."""
    return _environment().get_template(name).render(**context)
