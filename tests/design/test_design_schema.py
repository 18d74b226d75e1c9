"""The JSON schema accepts what reading accepts and refuses the mistakes of single keys."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
from fake_catalogue import CATALOGUE, GOOD

from qcone.design import json_schema, read_designs

SCHEMA = json_schema(CATALOGUE)

TYPES: dict[str, Any] = {
    "object": dict,
    "array": list,
    "string": str,
    "boolean": bool,
    "integer": int,
    "number": (int, float),
}

CHECKED = {
    *("type", "enum", "anyOf", "properties", "patternProperties", "additionalProperties", "required"),
    *(
        "minProperties",
        "items",
        "minItems",
        "maxItems",
        "uniqueItems",
        "minimum",
        "exclusiveMinimum",
        "pattern",
    ),
}
TOLD = {"$schema", "title", "description", "default"}


def _is(value: object, kind: str) -> bool:
    return isinstance(value, TYPES[kind]) and (kind == "boolean" or not isinstance(value, bool))


def _same(one: object, other: object) -> bool:
    return one == other and isinstance(one, bool) == isinstance(other, bool)


def accepts(schema: dict[str, Any], value: object) -> bool:
    """Tell whether `value` meets a schema of the few words that ours uses (draft 4); others are an error."""
    assert set(schema) <= CHECKED | TOLD, set(schema) - CHECKED - TOLD
    if "type" in schema and not _is(value, schema["type"]):
        return False
    if "enum" in schema and not any(_same(value, each) for each in schema["enum"]):
        return False
    if "anyOf" in schema and not any(accepts(each, value) for each in schema["anyOf"]):
        return False
    if isinstance(value, dict):
        return _accepts_object(schema, value)
    if isinstance(value, list):
        few = len(value) < schema.get("minItems", 0) or len(value) > schema.get("maxItems", len(value))
        twice = schema.get("uniqueItems") and len({json.dumps(each) for each in value}) < len(value)
        return not few and not twice and all(accepts(schema.get("items", {}), each) for each in value)
    if isinstance(value, str):
        return "pattern" not in schema or re.search(schema["pattern"], value) is not None
    if "minimum" in schema and isinstance(value, int | float):
        return value > schema["minimum"] or (value == schema["minimum"] and not schema.get("exclusiveMinimum"))
    return True


def _accepts_object(schema: dict[str, Any], value: dict[str, Any]) -> bool:
    if set(schema.get("required", ())) - set(value) or len(value) < schema.get("minProperties", 0):
        return False
    for name, each in value.items():
        schemas = [schema["properties"][name]] if name in schema.get("properties", {}) else []
        schemas += [one for pattern, one in schema.get("patternProperties", {}).items() if re.search(pattern, name)]
        if not schemas and schema.get("additionalProperties") is False:
            return False
        if not all(accepts(one, each) for one in schemas):
            return False
    return True


def _top(line: str) -> str:
    return GOOD.replace("\n\n[design.att.imu]", f"\n{line}\n[design.att.imu]")


GOOD_FILES = [
    GOOD,
    GOOD.replace("100", "99.2"),
    GOOD.replace("rotation-vector", "sub/my.py:f"),
    _top('subsamples = 3\ncoefficients = "coning"\naxes = "y, -x,z"'),
    _top('outputs = ["dcm", "euler"]\nlicense = "MIT"'),
    GOOD.replace('"rotation-vector"', '"picard"\norder = "closed"'),
    _top('input = "counts"').replace(
        "573",
        '573\nquantum_dps = "2000/32768"\nbias_dps = [1, -0.5, "1/3"]',
    ),
    _top('input = "counts"').replace(
        "573", f"573\nquantum_dps = 0.061\ncalibration = [{', '.join(['[1, 0, 0.5]'] * 3)}]"
    ),
    GOOD.replace("float32", "fixed16") + 'overflow = "wrap"\nclamp_inputs = true\n',
    GOOD + "[design.att.rins]\n",
    GOOD + "[design.att.rins]\nmax_correction_arcsec = 120.5\n",
    GOOD + "[design.att.budget]\nmultiply = 0\n[design.att.budget.cortex-m4f]\ntext_bytes = 2048\n",
]


@pytest.mark.parametrize("text", GOOD_FILES)
def test_the_schema_accepts_what_reading_accepts(tmp_path: Path, text: str) -> None:
    file = tmp_path / "good.toml"
    file.write_text(text)
    assert len(read_designs(file, CATALOGUE)) == 1
    assert accepts(SCHEMA, tomllib.loads(text))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[design]\n",
        "x = 1\n" + GOOD,
        GOOD.replace("design.att", "design.Att"),
        GOOD.replace("design.att", f"design.{'a' * 65}"),
        GOOD.replace("rotation-vector", "rotation-vektor"),
        GOOD.replace('algorithm = "rotation-vector"\n', ""),
        GOOD.replace("update_hz = 100\n", ""),
        GOOD.replace('[design.att.number]\nformat = "float32"\n', ""),
        GOOD.replace("= 100", "= 0"),
        GOOD.replace("= 100", '= "100"'),
        GOOD.replace("float32", "float16"),
        _top("subsamples = 7"),
        _top("subsamples = true"),
        _top("unknown = 7"),
        _top('axes = "x,y"'),
        _top("outputs = []"),
        _top('outputs = ["dcm", "dcm"]'),
        _top('outputs = ["quat"]'),
        _top('license = "M I T"'),
        GOOD.replace("573", "573\nbias_dps = [1, 2]"),
        GOOD.replace("573", "573\ncalibration = [[1, 0, 0], [0, 1, 0], [0, 0]]"),
        GOOD + "clamp_inputs = 1\n",
        GOOD + "[design.att.rins]\nmax_correction_arcsec = 0\n",
        GOOD + "[design.att.rins]\nmax_correction = 600\n",
        GOOD + "[design.att.budget]\nmultiply = -1\n",
        GOOD + "[design.att.budget]\nmultiply = 1.5\n",
        GOOD + "[design.att.budget.cortex-m9]\n",
        GOOD + "[design.att.budget.host]\nbytes = 3\n",
    ],
)
def test_the_schema_refuses_the_mistakes_of_single_keys(text: str) -> None:
    assert not accepts(SCHEMA, tomllib.loads(text))


def test_the_schema_is_plain_json_without_references() -> None:
    text = json.dumps(SCHEMA)
    assert json.loads(text) == SCHEMA
    assert "$ref" not in text
    assert "$defs" not in text


def test_an_editor_is_told_what_each_key_means() -> None:
    (design,) = SCHEMA["properties"]["design"]["patternProperties"].values()
    properties = design["properties"]
    assert properties["axes"]["default"] == "x,y,z"
    assert properties["outputs"]["default"] == ["quaternion"]
    assert properties["subsamples"] == {
        "description": "sub-samples an update",
        "enum": [1, 2, 3, 4, 5, 6],
        "default": 1,
    }
    assert properties["rins"]["properties"]["max_correction_arcsec"]["default"] == 600
    tables = [properties, *(properties[name]["properties"] for name in ("imu", "number", "rins", "budget"))]
    for table in tables:
        assert all(each.get("description") or each["type"] == "object" for each in table.values())


def test_parameters_that_share_a_name_share_their_choices() -> None:
    from dataclasses import replace

    from fake_catalogue import PICARD

    from qcone.design import Parameter

    other = replace(PICARD, id="taylor", parameters=(Parameter("order", (2, 10), 10, "order of the series"),))
    (design,) = json_schema([PICARD, other])["properties"]["design"]["patternProperties"].values()
    assert design["properties"]["order"] == {
        "description": "order of the iteration",
        "enum": [1, 2, 3, 4, "closed", 10],
    }
