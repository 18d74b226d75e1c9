"""R3 to R5 and D8: the operations xu2019 counts in its table 1, by its convention, in full, and the least of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from qcone.design import design_from_options
from qcone.registry import entries
from qcone.studies.claims.claim import DOES_NOT_HOLD, Claim, Settings, judged, verdict_of
from qcone.studies.counting import Row, paper_table, rows_of_design

PAPER = "xu2019"
LEAST: Mapping[str, int] = {"rotation-vector": 47, "quaternion-taylor": 362, "dcm-taylor": 399}
"""Fewest products known for an update and the matrix, three sub-samples; series of order 10."""

LEAST_MAGNUS: Mapping[int, int] = {5: 79, 7: 110, 9: 140}
"""The same of Magnus series for the parabola, by weight: the highest power of the interval that is kept."""

FULL_ADDITIONS: Mapping[str, int] = {"quaternion-taylor": 1611, "dcm-taylor": 684}
TRUE_COST = "the convention leaves the additions inside 23 of 24 dense products out"


def table_1(settings: Settings) -> Iterator[Claim]:
    """R3, R4 and D8: table 1 whole, by its convention and in full."""
    rows = {(row["algorithm"], row["level"]): row for row in paper_table(PAPER)}
    for name in ("rotation-vector", "quaternion-taylor", "dcm-taylor"):
        ours, theirs = (_numbers(rows[name, level], name) for level in ("paper-convention", "paper"))
        words = "multiply/divide/add/subtract/square root/trigonometric"
        if name != "rotation-vector":
            words = "multiply/add/subtract, dense matrices"
        yield Claim(
            "R3" if name == "rotation-vector" else "R4",
            f"table 1, {name}, three sub-samples: {words}",
            PAPER,
            theirs,
            ours,
            "equal",
            verdict_of(ours == theirs),
            "" if ours == theirs else "counted otherwise by the same convention",
        )
    for name, full in FULL_ADDITIONS.items():
        counted = _count(rows[name, "as-written"], "add")
        yield judged("R4", f"additions of {name} counted in full", PAPER, "not given", counted, (full, full))
    for name in FULL_ADDITIONS:
        printed, counted = _count(rows[name, "paper"], "add"), _count(rows[name, "as-written"], "add")
        equal = printed == counted
        yield Claim(
            "D8",
            f"table 1 gives the additions of {name} as a true cost",
            PAPER,
            str(printed),
            counted,
            f"{printed} exactly",
            verdict_of(equal),
            "" if equal else TRUE_COST,
        )


def least_counts(settings: Settings) -> Iterator[Claim]:
    """R5: products of the emitted C, those by powers of two among them, and no division, root or sine."""
    for name, most in LEAST.items():
        words = {"algorithm": name, "subsamples": "3", "outputs": "quaternion,dcm", "renormalise": "never"}
        rate = {"number": "float64", "max_rate_dps": "573", "update_hz": "100"}
        rows = rows_of_design(design_from_options("least", words | rate, entries()), ("factored",))
        emitted = next(row for row in rows if row["level"] == "emitted")
        rest = sum(_count(emitted, kind) for kind in ("divide", "square_root", "trigonometric"))
        products = _count(emitted, "multiply") + _count(emitted, "power_of_two")
        found = judged("R5", f"least products, {name}", PAPER, "not given", products, (float("-inf"), most))
        if rest:
            reason = f"{rest} divisions, roots, sines or cosines beside the products"
            found = Claim(**(vars(found) | {"verdict": DOES_NOT_HOLD, "reason": reason}))
        yield found
    for weight, most in LEAST_MAGNUS.items():
        claim = f"least products, magnus of weight {weight}"
        reason = "not implemented: the catalogue has no magnus yet, so nothing was measured"
        yield Claim("R5", claim, PAPER, "not given", None, f"at most {most}", None, reason)


def _numbers(row: Row, name: str) -> str:
    kinds: tuple[str, ...] = ("multiply", "divide", "add", "subtract", "square_root", "trigonometric")
    if name != "rotation-vector":
        kinds = ("multiply", "add", "subtract")
    return "/".join(str(_count(row, kind)) for kind in kinds)


def _count(row: Row, kind: str) -> int:
    return int(str(row[kind]))
