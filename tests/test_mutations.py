"""Mistakes made on purpose, each with the check that notices it.

A mutation changes the product where its author could have slipped: a sign, a weight, an order, a time. A check
is one of those the rest of the tests rest on, brought down to a function. With nothing changed every check
holds; with a mutation made, the checks its row names do not. Mutations of the C text are next door.
"""

from __future__ import annotations

import platform
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, NoReturn

import pytest

import fixed_point_mistakes
from checks import CHECKS, CONING_3
from qcone import assembly, pipeline
from qcone.algorithms import attitude as written_attitude
from qcone.algorithms import coefficients, rotation_vector
from qcone.formats.floating import Floating
from qcone.ir import products, update
from qcone.ir.blocks import Quantity
from qcone.ir.builder import Builder
from qcone.ir.operations import RealOp
from qcone.ir.statement import Block, Operation, Program, Role, Statement
from qcone.pipeline import build
from qcone.targets.compiler import compilers
from qcone.targets.probe import has_fma
from qcone.verify import verify
from shipped import design_of


@pytest.mark.parametrize("check", CHECKS)
def test_with_nothing_changed_every_check_holds(check: str, request: pytest.FixtureRequest) -> None:
    assert CHECKS[check](request)


Patch = pytest.MonkeyPatch


def cross_with_a_flipped_sign(patch: Patch) -> None:
    def cross(emit: Callable[..., int], a: Sequence[int], b: Sequence[int]) -> tuple[int, ...]:
        x, y, _ = right(emit, a, b)
        products_ = emit(RealOp.MULTIPLY, a[0], b[1]), emit(RealOp.MULTIPLY, a[1], b[0])
        return x, y, emit(RealOp.ADD, *products_)

    right = products.cross
    patch.setattr(products, "cross", cross)


def cross_with_a_wrong_component(patch: Patch) -> None:
    def cross(emit: Callable[..., int], a: Sequence[int], b: Sequence[int]) -> tuple[int, ...]:
        _, y, z = right(emit, a, b)
        products_ = emit(RealOp.MULTIPLY, a[1], b[2]), emit(RealOp.MULTIPLY, a[2], b[2])
        return emit(RealOp.SUBTRACT, *products_), y, z

    right = products.cross
    patch.setattr(products, "cross", cross)


def coning_with_a_flipped_sign(patch: Patch) -> None:
    right = rotation_vector._factored
    patch.setattr(rotation_vector, "_factored", lambda *given: -right(*given))


def coning_zero(patch: Patch) -> None:
    right = rotation_vector._factored
    patch.setattr(rotation_vector, "_factored", lambda *given: 0 * right(*given))


def coning_zero_in_both_forms(patch: Patch) -> None:
    """As where the increment before is overwritten by the newest one and then multiplied with it."""
    right = rotation_vector.cross
    patch.setattr(rotation_vector, "cross", lambda a, _: right(a, a))


def weight_one_unit_off(patch: Patch) -> None:
    right = coefficients.coning

    def coning(n: int) -> dict[tuple[int, int], Fraction]:
        pairs = dict(right(n))
        pairs[1, n] += Fraction(1, pairs[1, n].denominator)
        return pairs

    patch.setattr(coefficients, "coning", coning)


def history_weight_one_unit_off(patch: Patch) -> None:
    right = coefficients.history_weights
    patch.setattr(
        coefficients, "history_weights", lambda p: (right(p)[0] + Fraction(1, right(p)[0].denominator), *right(p)[1:])
    )


def literal_one_unit_off(patch: Patch) -> None:
    right = pipeline.lower_program

    def lowered(program: Program, number: Floating) -> Program:
        def changed(each: Statement) -> Statement:
            if isinstance(each, Operation) and each.constant is not None and each.constant != each.exact:
                return replace(each, constant=each.constant + number.ulp(each.constant))
            return each

        machine = right(program, number)
        routines = [routine.with_body(tuple(map(changed, routine.body))) for routine in machine.routines]
        return replace(machine, routines=tuple(routines))

    patch.setattr(pipeline, "lower_program", lowered)


def difference_with_swapped_operands(patch: Patch) -> None:
    right = rotation_vector._pairwise

    def pairwise(dtheta: Sequence[Any]) -> tuple[Any, Any, Any]:
        total, sums, _ = right(dtheta)
        return total, sums, [dtheta[j] - dtheta[-1 - j] for j in range(len(dtheta) // 2)]

    patch.setattr(rotation_vector, "_pairwise", pairwise)


def subtraction_forgotten(patch: Patch) -> None:
    right = rotation_vector._pairwise

    def pairwise(dtheta: Sequence[Any]) -> tuple[Any, Any, Any]:
        total, sums, _ = right(dtheta)
        return total, sums, [dtheta[-1 - j] for j in range(len(dtheta) // 2)]

    patch.setattr(rotation_vector, "_pairwise", pairwise)


def renormalisation_with_swapped_operands(patch: Patch) -> None:
    right = update._with_renormalisation
    patch.setattr(update, "_with_renormalisation", lambda q, u: 2 * u - right(q, u))


def coning_one_sample_late(patch: Patch) -> None:
    right = rotation_vector._pairwise

    def pairwise(dtheta: Sequence[Any]) -> tuple[Any, Any, Any]:
        total, _, _ = right(dtheta)
        return total, *right((dtheta[0], *dtheta[:-1]))[1:]

    patch.setattr(rotation_vector, "_pairwise", pairwise)


def history_one_sample_late(patch: Patch) -> None:
    right = rotation_vector._weighted
    patch.setattr(rotation_vector, "_weighted", lambda factors, before: right(factors, (*before[1:], before[-1])))


def rate_one_sample_late(patch: Patch) -> None:
    """Keep the last but one rate for the next update, instead of the last."""
    right = assembly.around.write

    def write(builder: Builder, block: Block, entry: int, quantity: Quantity) -> None:
        if block.name == "omega_last":
            given = next(each for each in builder.blocks if each.role is Role.INPUT)
            quantity = assembly.around.read(builder, given, max(given.count - 2, 0))
        right(builder, block, entry, quantity)

    patch.setattr(assembly.around, "write", write)


def product_reversed(patch: Patch) -> None:
    right = update._least_product
    patch.setattr(update, "_least_product", lambda p, q: right(q, p))


def product_as_written_reversed(patch: Patch) -> None:
    right = products.hamilton
    patch.setattr(products, "hamilton", lambda emit, p, q: right(emit, q, p))


def cao_13_as_printed(patch: Patch) -> None:
    printed = (Fraction(-1, 36), Fraction(8, 36), Fraction(0), Fraction(5, 36))
    patch.setattr(coefficients, "CAO_13", (*coefficients.CAO_13[:2], printed))


def sum_from_left_to_right(patch: Patch) -> None:
    right = rotation_vector._pairwise

    def pairwise(dtheta: Sequence[Any]) -> tuple[Any, Any, Any]:
        _, sums, differences = right(dtheta)
        total = dtheta[0]
        for each in dtheta[1:]:
            total = total + each
        return total, sums, differences

    patch.setattr(rotation_vector, "_pairwise", pairwise)


def axes_without_their_signs(patch: Patch) -> None:
    patch.setattr(assembly, "_turned", lambda builder, value, sign: value)


def matrix_transposed(patch: Patch) -> None:
    right = written_attitude.dcm

    def transposed(q: Any) -> Any:
        entries = right(q)
        values = tuple(entries.values[3 * column + row] for row in range(3) for column in range(3))
        return replace(entries, values=values)

    patch.setattr(written_attitude, "dcm", transposed)


Mutation = Callable[[Patch], None]

NOTICED_BY: dict[str, tuple[Mutation, tuple[str, ...]]] = {
    "flipped sign, in a cross product": (cross_with_a_flipped_sign, ("cyclic", "exact value", "reference")),
    "wrong component in a cross product": (cross_with_a_wrong_component, ("flip", "cyclic", "exact value")),
    "flipped sign, of the coning term": (coning_with_a_flipped_sign, ("forms agree", "exact value", "published error")),
    "pair weight one unit off": (weight_one_unit_off, ("weights published", "exact value", "published error")),
    "history weight one unit off": (history_weight_one_unit_off, ("reference, history",)),
    "literal one unit off in its last place": (literal_one_unit_off, ("literals rounded once",)),
    "operands of a difference swapped": (difference_with_swapped_operands, ("forms agree", "exact value")),
    "subtraction forgotten": (subtraction_forgotten, ("constant-rate", "time-reversal", "forms agree", "exact value")),
    "operands of 1 - |q|^2 swapped": (renormalisation_with_swapped_operands, ("reference",)),
    "one-sample lag, in the coning term": (coning_one_sample_late, ("forms agree", "exact value", "published error")),
    "one-sample lag, in the history": (history_one_sample_late, ("reference, history",)),
    "one-sample lag, in the first rate": (rate_one_sample_late, ("reference, rates", "reference, cao (13)")),
    "quaternion product reversed": (product_reversed, ("reference", "published error")),
    "quaternion product as written reversed": (product_as_written_reversed, ("forms agree",)),
    "cao (13) as printed": (cao_13_as_printed, ("increments exact", "reference, cao (13)")),
    "coning term zero": (coning_zero, ("forms agree", "exact value", "published error", "reference")),
    "coning term zero in both forms": (
        coning_zero_in_both_forms,
        ("exact value", "published error", "reference", "reference, history"),
    ),
    "sum from left to right": (sum_from_left_to_right, ("time-reversal",)),
    "signs of the axes dropped": (axes_without_their_signs, ("reference, axes",)),
    **fixed_point_mistakes.NOTICED_BY,
    "matrix transposed": (matrix_transposed, ("reference",)),
}
"""Every mutation and the checks that notice it."""


@pytest.mark.parametrize(
    ("mutation", "check"), [(name, check) for name, (_, checks) in NOTICED_BY.items() for check in checks]
)
def test_a_mutation_is_noticed(mutation: str, check: str, request: pytest.FixtureRequest, monkeypatch: Patch) -> None:
    NOTICED_BY[mutation][0](monkeypatch)
    assert not CHECKS[check](request)


def test_every_check_is_needed_by_some_mutation() -> None:
    named = {check for _, checks in NOTICED_BY.values() for check in checks}
    assert named == set(CHECKS)


def test_contraction_is_noticed(missing_tool: Callable[[str], NoReturn]) -> None:
    """Built with fused multiply-add allowed, the C is reported as contracted, at every level that fuses."""
    if not has_fma():
        missing_tool("a processor with fused multiply-add: without one nothing can contract")
    gcc = [each for each in compilers() if each.family == "gcc"]
    if not gcc:
        missing_tool("gcc (apt install gcc)")
    wide = ("-mfma",) if platform.machine().lower() in ("x86_64", "amd64", "i686") else ()
    flags = ("-ffp-contract=fast", *wide)
    outcomes = {each.level: each for each in verify(build(design_of(CONING_3)), 2000, gcc[0].command[0], flags)}
    for level in ("-O2", "-O3", "-Os"):
        assert (outcomes[level].status, outcomes[level].contracted) == ("contracted", True)
        assert outcomes[level].failed
        assert "the build fuses products and sums" in str(outcomes[level].first_difference)
        assert outcomes[level].differing_bits
