"""Templates lay out; what they are not given is an error, never an empty place."""

from __future__ import annotations

import re
from dataclasses import fields, replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from jinja2 import TemplateNotFound, UndefinedError

from qcone.backends import page as pages
from qcone.backends.templates import PLACES, render
from shipped import DESIGNS, shipped

FOLDER = Path(__file__).parents[2] / "templates"
TEMPLATES = sorted(path.relative_to(FOLDER).as_posix() for path in FOLDER.rglob("*.j2"))


def page() -> pages.Page:
    return pages.Page(
        name="design",
        command="qcone generate a.toml --design design",
        license="MIT-0",
        facts=("first fact", "", "second fact"),
        macros=(pages.Macro("DESIGN_VERSION", "1", "Interface."),),
        fields=(pages.Field("float q[4];", "attitude"),),
        functions=(pages.Documented("void design_init(void)", ("    return;",), False, ("Contract.", "", "More.")),),
        integers=True,
        significand="FLT_MANT_DIG",
        digits=24,
        interface=1,
    )


@pytest.mark.parametrize("name", TEMPLATES)
def test_template_given_nothing_is_an_error(name: str) -> None:
    with pytest.raises(UndefinedError):
        render(name)


@pytest.mark.parametrize("field", [each.name for each in fields(pages.Page)])
def test_page_that_lacks_a_field_is_an_error(field: str) -> None:
    """An empty place in a C file would be worse than no file."""
    given = {each.name: getattr(page(), each.name) for each in fields(pages.Page) if each.name != field}
    lacking = SimpleNamespace(**given)
    driver = shipped(next(iter(DESIGNS))).driver
    asking = [name for name in TEMPLATES if f"page.{field}" in (FOLDER / name).read_text(encoding="utf-8")]
    name = next((name for name in asking if name != "c/_banner.j2"), "c/routine.c.j2")
    with pytest.raises(UndefinedError, match=f"'{field}'"):
        render(name, page=lacking, driver=driver, guard="GUARD_H")


def test_unknown_template_is_an_error() -> None:
    with pytest.raises(TemplateNotFound):
        render("c/absent.c.j2")


def test_templates_are_found_in_the_package_or_in_the_checkout() -> None:
    assert PLACES[1] == FOLDER
    assert PLACES[0].parent.name == "qcone"


@pytest.mark.parametrize("name", TEMPLATES)
def test_templates_compute_nothing(name: str) -> None:
    """Python owns every expression: in a template stand names, the position of a row in its array, and little else."""
    text = (FOLDER / name).read_text(encoding="utf-8")
    for expression in re.findall(r"\{\{(.*?)\}\}", text):
        assert not re.search(r"[+*/%]|\|\s*(?!upper\b)\w+", expression), expression
    assert not re.search(r"\{%-?\s*(set|macro|call|import)\b", text)


def test_page_is_laid_out() -> None:
    text = pages.header(page())
    assert text.startswith(
        "/* Generated, do not edit. Made by: qcone generate a.toml --design design\n *\n * first fact\n *\n"
    )
    assert " * SPDX-License-Identifier: MIT-0\n" in text
    assert "#ifndef DESIGN_H\n#define DESIGN_H\n\n#include <float.h>\n#include <stdint.h>\n" in text
    assert "/* Interface. */\n#define DESIGN_VERSION 1\n" in text
    assert "    float q[4]; /* attitude */\n} design_state;\n" in text
    assert "/*\n * Contract.\n *\n * More.\n */\nvoid design_init(void);\n" in text
    assert text.endswith("#endif\n")


def test_internal_functions_are_not_declared() -> None:
    hidden = pages.Documented("static void design_part(void)", ("    return;",), True, ())
    shown = replace(page(), functions=(*page().functions, hidden))
    assert "design_part" not in pages.header(shown)
    assert "static void design_part(void)\n{\n    return;\n}\n" in pages.source(shown)


def test_stdint_is_included_where_it_is_used() -> None:
    assert "<stdint.h>" not in pages.header(replace(page(), integers=False))


@pytest.mark.parametrize("text", ["a < b && c > d", 'q\' = "q"'])
def test_text_is_not_escaped(text: str) -> None:
    assert f" * {text}\n" in pages.header(replace(page(), facts=(text,)))


@pytest.mark.parametrize("name", DESIGNS)
def test_nothing_of_a_template_is_left(name: str) -> None:
    for text in (*shipped(name).files.values(), shipped(name).main):
        assert not re.search(r"\{\{|\}\}(?! *;)|\{%|%\}|\{#|\bNone\b|Undefined", text)


def test_every_field_of_a_page_is_used() -> None:
    """What no template asks for is dead weight."""
    text = "".join((FOLDER / name).read_text(encoding="utf-8") for name in TEMPLATES)
    assert [each.name for each in fields(pages.Page) if f"page.{each.name}" not in text] == []
    # Raw words are made and read by Python alone: no template asks for fraction bits.
    unused = [each.name for each in fields(pages.Driver) if f"driver.{each.name}" not in text]
    assert unused == ["fraction_bits"]
