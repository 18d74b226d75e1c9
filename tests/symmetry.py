"""Symmetries of an update, measured: which hold to the last bit on thousands of rows, and one update of a design."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from qcone.backends.bittrue import Model, dtype_of, new_state
from qcone.bundle import Bundle

Array = NDArray[Any]
Phi = Callable[[Array, Array], Array]
"""From increments (N, 3, rows) and the increments before them (P, 3, rows), newest first, to phi (3, rows)."""

ROWS = 4000
CYCLIC = [1, 2, 0]
FLIPS = [np.array([[x], [y], [x * y]]) for x, y in ((1, -1), (-1, 1), (-1, -1))]


def bits(values: Array) -> Array:
    """Return the words of floats, the two zeros as one."""
    words: Array = (np.asarray(values) + values.dtype.type(0)).view(f"u{values.dtype.itemsize}")
    return words


def same(first: Array, second: Array) -> bool:
    return first.dtype == second.dtype and np.array_equal(bits(first), bits(second))


def samples(count: int, dtype: Any, seed: int) -> Array:
    """Return vectors (count, 3, ROWS) of many sizes, among them zeros of both signs and the smallest numbers."""
    random = np.random.default_rng(seed)
    values = 0.01 * random.standard_normal((count, 3, ROWS)) * 2.0 ** random.integers(-30, 1, ROWS)
    values = values.astype(dtype)
    some = random.random(values.shape)
    values[some < 0.02] = 0.0
    values[some > 0.98] = -0.0
    tiny = random.integers(-1000, 1000, values.shape).astype(dtype) * np.finfo(dtype).smallest_subnormal
    return np.where(random.random(ROWS) < 0.05, tiny, values)


def holding(phi: Phi, dtheta: Array, previous: Array, total: Callable[[Array], Array]) -> set[str]:
    """Return the properties that phi has on these increments; `total` is S as the form sums it."""
    usual, found = phi(dtheta, previous), set()
    if same(phi(dtheta[:, CYCLIC], previous[:, CYCLIC]), usual[CYCLIC]):
        found.add("cyclic")
    if all(same(phi(dtheta * s, previous * s), usual * s) for s in signs_in(dtheta.dtype, FLIPS)):
        found.add("flip")
    if same(phi(-dtheta[::-1], -previous), -usual):
        found.add("time-reversal")
    steady = np.broadcast_to(dtheta[:1], dtheta.shape).copy()
    if same(phi(steady, np.broadcast_to(dtheta[:1], previous.shape).copy()), total(steady)):
        found.add("constant-rate")
    return found


def signs_in(dtype: Any, signs: list[Array]) -> Iterator[Array]:
    return (each.astype(dtype) for each in signs)


def pairwise(dtheta: Array) -> Array:
    """Return S by symmetric pairs, (theta_1 + theta_N) + (theta_2 + theta_(N-1)) + ..., the middle one last."""
    n = len(dtheta)
    parts = [dtheta[i] + dtheta[n - 1 - i] for i in range(n // 2)] + [dtheta[n // 2]] * (n % 2)
    return left_to_right(np.array(parts))


def left_to_right(dtheta: Array) -> Array:
    """Return S in the order of time."""
    total = dtheta[0]
    for each in dtheta[1:]:
        total = total + each
    return total


class Run:
    """One update of a shipped design on many rows: its named values, and q after it."""

    def __init__(self, bundle: Bundle, q: Array, given: Array, previous: Array, before: Array | None = None) -> None:
        """Set the attitude (4, rows), and the history or the first rate, and run one update."""
        model = Model(bundle.machine, bundle.facts.number)
        state = new_state(bundle.machine, bundle.facts.number, ROWS)
        self.named: dict[str, Array] = {}
        with np.errstate(all="ignore"):
            model.run("set_quaternion", state, {"q_nb": q})
            if before is not None:
                model.run("start", state, {"omega": before})
            if len(previous):
                state["previous"][:] = previous.reshape(-1, ROWS)
                state["count"][:] = len(previous)
            name = "dtheta" if before is None else "omega"
            model.run("update", state, {name: given.reshape(-1, ROWS)}, self.named)
        self.q, self.residual = state["q"], state.get("residual", np.zeros_like(state["q"]))

    def vector(self, *names: str) -> Array:
        """Return the first of the named vectors that the routine has; a sign may have been carried past the name."""
        name = next(each for each in names if f"{each}_x" in self.named or f"{each}_x_negated" in self.named)
        words = [f"{name}_{axis}" for axis in "xyz"]
        return np.array([self.named[w] if w in self.named else -self.named[f"{w}_negated"] for w in words])

    @property
    def phi(self) -> Array:
        """Return phi; one increment alone is phi itself and keeps its own name."""
        return self.vector("phi", "dtheta")

    @property
    def r(self) -> Array:
        """Return what of r depends on the rotation: u (or a_c, or nothing at order 1) and the vector part."""
        scalar = next((self.named[each] for each in ("u", "a_c") if each in self.named), np.zeros(ROWS, self.q.dtype))
        return np.array([np.broadcast_to(scalar, ROWS), *self.vector("v", "r")])


def attitudes(dtype: Any) -> Array:
    q = np.random.default_rng(3).standard_normal((4, ROWS))
    q[:, :4] = np.eye(4)
    q /= np.linalg.norm(q, axis=0)
    rounded: Array = q.astype(dtype)
    return rounded


def one(bundle: Bundle) -> Array:
    return np.array([[1], [0], [0], [0]]).repeat(ROWS, 1).astype(dtype_of(bundle.facts.number))


def scalar_and(signs: Array) -> Array:
    """Return the signs of a quaternion's components, given those of its vector part."""
    return np.concatenate([np.ones((1, 1), signs.dtype), signs])
