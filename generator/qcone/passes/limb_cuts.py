"""Cuts: where each word of a routine is cut into limbs, so that its sums of products take the fewest instructions.

Whatever the cuts, the bits are the same; which limb sums fit a word depends on them. Words of one role, such as the
first factors of a quaternion product, are tried together, all cuts of both factors, then each word alone, until
nothing gets better.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from qcone.ir.detail import Mac
from qcone.ir.statement import Operation, Routine
from qcone.passes.fuse import args_of
from qcone.passes.limb_levels import UnprovedError
from qcone.passes.limb_ranges import WORD, Words
from qcone.passes.limbs import Cut, LimbSums

CUTS = (Cut(16), Cut(15), Cut(16, signed=False), Cut(0))
UNPROVED = 60
"""Instructions of a 64-bit product by the compiler's library and of its sum: what is left where no limbs will do."""
Sums = Mapping[int, tuple[Operation, Mac]]


def sums_of_products(routine: Routine, words: Words) -> dict[int, tuple[Operation, Mac]]:
    """Return the sums of products that limbs may make: of words alone, rounded, with nothing carried and no limits."""
    found = {}
    for each in routine.body:
        if not isinstance(each, Operation) or not isinstance(each.detail, Mac):
            continue
        mac, args = each.detail, args_of(each.detail.terms)
        plain = mac.residual is None and mac.limits is None and mac.rounding != "even" and mac.discard > 0
        single = words.formats[each.result].width == WORD and all(
            arg in words.ranges or arg in words.constants for arg in args
        )
        if plain and single and factors(mac) and mac.accumulator == 2 * WORD:
            found[each.result] = (each, mac)
    return found


def factors(mac: Mac, side: int | None = None) -> tuple[int, ...]:
    """Return the words that a sum multiplies, of both sides or of one."""
    products = (term.args for term in mac.terms if len(term.args) == 2)
    return tuple(dict.fromkeys(arg for args in products for arg in (args if side is None else (args[side],))))


def choose_cuts(sums: Sums, words: Words) -> dict[int, Cut]:
    """Return a cut for every word that the sums multiply."""
    return _Search(sums, words).run()


class _Search:
    def __init__(self, sums: Sums, words: Words) -> None:
        self.sums, self.words = sums, words
        self.users: dict[int, list[int]] = {}
        for result, (_, mac) in sums.items():
            for word in factors(mac):
                self.users.setdefault(word, []).append(result)
        self.known: dict[tuple[object, ...], int] = {}

    def run(self) -> dict[int, Cut]:
        cuts = dict.fromkeys(self.users, CUTS[0])
        while True:
            before = cuts
            for left, right in self._moves():
                for one in CUTS:
                    for other in CUTS if right else CUTS[:1]:
                        cuts = self._better(cuts, {**dict.fromkeys(left, one), **dict.fromkeys(right, other)})
            if cuts == before:
                return cuts

    def _better(self, cuts: dict[int, Cut], change: Mapping[int, Cut]) -> dict[int, Cut]:
        """Return the changed cuts where they take fewer instructions, else those there were."""
        changed = {word: cut for word, cut in change.items() if cuts[word] != cut}
        if not changed:
            return cuts
        tried = {**cuts, **changed}
        touched = dict.fromkeys(result for word in changed for result in self.users[word])
        costs = [
            sum(self._cost(each, some) for each in touched) + sum(self._cutting(each, some[each]) for each in changed)
            for some in (tried, cuts)
        ]
        return tried if costs[0] < costs[1] else cuts

    def _moves(self) -> Iterable[tuple[tuple[int, ...], tuple[int, ...]]]:
        """Return the sets of words that are tried together: both sides of a product, and every word alone."""
        sides = [self._roles(side) for side in (0, 1)]
        both = dict.fromkeys((sides[0][result], sides[1][result]) for result in self.sums)
        return [*both, *(((word,), ()) for word in self.users)]

    def _roles(self, side: int) -> dict[int, tuple[int, ...]]:
        """Return for each sum the words on one side of its products, and all that stand beside them elsewhere."""
        roles: list[set[int]] = []
        for _, mac in self.sums.values():
            own = set(factors(mac, side))
            for other in [role for role in roles if role & own]:
                roles.remove(other)
                own |= other
            roles.append(own)
        found = {word: tuple(sorted(role)) for role in roles for word in role}
        return {result: found[factors(mac, side)[0]] for result, (_, mac) in self.sums.items()}

    def _cutting(self, word: int, cut: Cut) -> int:
        return 0 if word in self.words.constants else cut.weight

    def _cost(self, result: int, cuts: Mapping[int, Cut]) -> int:
        """Return the instructions of a sum whose words are cut."""
        operation, mac = self.sums[result]
        words = factors(mac)
        key = (result, *(cuts[each] for each in words))
        if key not in self.known:
            trial = LimbSums(self.words, cuts, 0)
            try:
                for each in words:
                    trial.limbs(each)
                trial.weight = 0
                trial.make(operation, mac)
                self.known[key] = trial.weight
            except UnprovedError:
                self.known[key] = UNPROVED * sum(len(term.args) == 2 for term in mac.terms)
        return self.known[key]
