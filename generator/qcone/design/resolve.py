"""One design from its table: every key checked, every default filled in."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from qcone.design.catalogue import AlgorithmEntry, Value
from qcone.design.design import Design, Imu, Number, Rins
from qcone.design.keys import (
    BUDGET_KEYS,
    C_KEYWORDS,
    DESIGN_KEYS,
    IMU_KEYS,
    NAME_PATTERN,
    NUMBER_KEYS,
    RINS_KEYS,
    TARGETS,
    Key,
    is_user_algorithm,
    parameter_key,
    unchecked_keys,
)
from qcone.design.mistakes import did_you_mean
from qcone.design.places import Finding, Places, shown
from qcone.design.rules import check_rules, decorated
from qcone.design.shapes import check_keys


def resolve(
    name: str,
    table: dict[str, Any],
    places: Places,
    catalogue: Sequence[AlgorithmEntry],
    *,
    file: str,
    directory: Path | None,
) -> tuple[Design | None, list[Finding]]:
    """Return the design that `table` describes and no findings, or None and every mistake in it."""
    algorithm = table.get("algorithm")
    entry = next((each for each in catalogue if each.id == algorithm), None)
    every_parameter = {each.name: None for one in catalogue for each in one.parameters}
    keys = unchecked_keys(every_parameter) if entry is None else tuple(parameter_key(each) for each in entry.parameters)
    given, findings = check_keys(table, keys, places, frozenset(every_parameter))
    findings = check_name(name) + findings
    refused = frozenset(each.path for each in findings)
    parameters: dict[str, Value] = {}
    if entry is not None:
        parameters = {each.name: given.get(each.name, each.default) for each in entry.parameters}
    elif isinstance(algorithm, str):
        if is_user_algorithm(algorithm):
            findings += decorated(given, keys, places)
        else:
            findings.append(_unknown_algorithm(algorithm, catalogue, places))
    spoiled = any((each.name,) in refused for each in keys)
    findings += check_rules(given, refused, places)
    if entry is not None and not spoiled:
        explicit = frozenset(parameters) & frozenset(given)
        for key, what, why, hint in entry.conflicts(parameters, explicit):
            findings.append(Finding((key,), "QC107", what, why, hint))
    if findings:
        return None, findings
    return _design(name, file, parameters, given, directory), []


def check_name(name: str) -> list[Finding]:
    """Return the finding for a name that cannot begin the names of C functions; usually none."""
    what = f"{shown(name)} cannot name a design"
    if not re.fullmatch(NAME_PATTERN, name):
        why = "it begins the names of C functions: a lower case letter, then at most 63 of a-z, 0-9 and _"
        fixed = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")[:64]
        usable = re.fullmatch(NAME_PATTERN, fixed) and fixed not in C_KEYWORDS
        return [Finding((), "QC110", what, why, f"write for example {fixed}" if usable else "choose another")]
    if name in C_KEYWORDS:
        return [Finding((), "QC110", what, "it is a C keyword", f"write for example {name}_1")]
    return []


def _unknown_algorithm(algorithm: str, catalogue: Sequence[AlgorithmEntry], places: Places) -> Finding:
    ids = [each.id for each in catalogue]
    near = did_you_mean(algorithm, ids)
    hint = f"did you mean {shown(near)}?" if near else f"the catalogue has {', '.join(ids)}"
    why = "it is not in the catalogue"
    if ".py" in algorithm or ":" in algorithm:
        why, hint = (
            "a function of your own is written file.py:function",
            'write for example "my_paper.py:my_update"',
        )
    return Finding(("algorithm",), "QC109", f"{places.given(('algorithm',), algorithm)} is unknown", why, hint)


def _with_defaults(keys: tuple[Key, ...], given: Mapping[str, Any]) -> dict[str, Any]:
    return {key.name: given.get(key.name, key.default) for key in keys}


def _design(
    name: str, file: str, parameters: Mapping[str, Value], given: Mapping[str, Any], directory: Path | None
) -> Design:
    budget = given.get("budget", {})
    return Design(
        name=name,
        file=file,
        parameters=dict(sorted(parameters.items())),
        imu=Imu(**_with_defaults(IMU_KEYS, given["imu"])),
        number=Number(**_with_defaults(NUMBER_KEYS, given["number"])),
        budget={key.name: budget[key.name] for key in BUDGET_KEYS if key.name in budget},
        target_budgets={target: dict(budget[target]) for target in TARGETS if target in budget},
        rins=Rins(**_with_defaults(RINS_KEYS, given["rins"])) if "rins" in given else None,
        directory=directory,
        **_with_defaults(DESIGN_KEYS, given),
    )
