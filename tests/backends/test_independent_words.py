"""The flagships' sums of products against an independent fixed-point arithmetic: apytypes, value by value.

Its products and sums grow by as many bits as they need, so nothing overflows there; its casts round by modes of its
own. Every value of an update is compared, of the model and of apytypes, bit for bit.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Mapping
from typing import Any, NoReturn

import numpy as np
import pytest
from numpy.typing import NDArray

from fixed_designs import ACCUMULATIONS, FLAGSHIP, fixed
from qcone.backends.bittrue import new_state
from qcone.formats.fixed import ROUNDINGS, Signal
from qcone.ir.detail import Mac
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Operation, Routine
from watching import Watched, drawn

Array = NDArray[Any]
MODES = {"up": "TIES_POS", "even": "TIES_EVEN", "floor": "TO_NEG"}
LANES = 1000


@pytest.fixture(scope="module")
def apytypes(missing_tool: Callable[[str], NoReturn]) -> Any:
    if importlib.util.find_spec("apytypes") is None:
        missing_tool("apytypes (pip install -e '.[test]')")
    return importlib.import_module("apytypes")


def array(apytypes: Any, words: Array, signal: Signal) -> Any:
    """Return words as apytypes has them; F may be beyond the word."""
    raw = np.broadcast_to(words, LANES).astype(np.int64).tolist()
    return apytypes.APyFixedArray(raw, bits=signal.width, frac_bits=signal.fraction)


def words(found: Any, width: int) -> Array:
    """Return the raw words of an array of apytypes, with their signs."""
    bits = np.array([int(each) for each in found.to_bits()], dtype=object)
    return np.where(bits >= 1 << (width - 1), bits - (1 << width), bits).astype(np.int64)


def independent(
    apytypes: Any, routine: Routine, known: Mapping[int, Array], memory: Mapping[str, Array]
) -> dict[int, Array]:
    """Return every sum of products by apytypes, from what was read and the constants as the model has them."""
    formats = {each.result: each.format for each in routine.body if isinstance(each, Operation)}
    values: dict[int, Any] = {}
    found = {}
    for each in routine.body:
        if not isinstance(each, Operation):
            continue
        assert isinstance(each.format, Signal)
        if each.op is not MachineOp.MAC:
            assert each.op in (MachineOp.READ, MachineOp.LITERAL)
            values[each.result] = array(apytypes, known[each.result], each.format)
            continue
        assert isinstance(each.detail, Mac)
        finest = each.format.fraction + each.detail.discard
        total = None
        for term in each.detail.terms:
            product = values[term.args[0]]
            fraction = sum(formats[arg].fraction for arg in term.args)  # type: ignore[union-attr]
            if len(term.args) == 2:
                product = product * values[term.args[1]]
            # A factor of a power of two moves the binary point: what was F is what the sum's alignment makes of it.
            moved = finest - term.shift - fraction
            product = apytypes.APyFixedArray(product.to_bits(), bits=product.bits, frac_bits=product.frac_bits + moved)
            signed = -product if term.negative else product
            total = signed if total is None else total + signed
        if each.detail.residual is not None:
            name, index = each.detail.residual
            total = total + array(apytypes, memory[name][index.constant], Signal(64, finest))
        mode = getattr(apytypes.QuantizationMode, MODES[each.detail.rounding])
        result = total.cast(bits=each.format.width, frac_bits=each.format.fraction, quantization=mode)
        values[each.result] = result
        found[each.result] = words(result, each.format.width)
    return found


@pytest.mark.parametrize("rounding", ROUNDINGS)
@pytest.mark.parametrize("accumulate", ACCUMULATIONS)
@pytest.mark.parametrize("number", ["fixed32", "fixed16"])
def test_every_value_is_that_of_an_independent_arithmetic(
    apytypes: Any, number: str, accumulate: str, rounding: str
) -> None:
    bundle = fixed(f"{FLAGSHIP} {number} {accumulate}", rounding)
    assert bundle.macs is not None
    vectors, model = drawn(bundle, 6 * LANES, lanes=LANES), Watched(bundle)
    state = new_state(bundle.machine, bundle.facts.number, LANES)
    model.run("set_quaternion", state, {"q_nb": vectors.attitude[:, 0].T})
    routine = model.program.routine("update")
    for step in range(3):
        before = {name: block.copy() for name, block in state.items()}
        watched: dict[str, Array] = {}
        model.run("update", state, {"dtheta": vectors.inputs[:, step].T}, watched)
        known = {int(name.split()[1]): value for name, value in watched.items()}
        found = independent(apytypes, routine, known, before)
        assert len(found) > 20
        for value, expected in found.items():
            np.testing.assert_array_equal(np.broadcast_to(known[value], LANES), expected, str(value))
    assert np.abs(state["q"]).max() > 0
