"""Levels: what products of limbs are added at each bit position, in words that are proved to hold it.

Addends that do not fit one word together make several: piles, of which all but the first hand on their carries and
leave what is below to the first.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from qcone.passes.limb_ranges import LEAST, MOST, WORD, Addend, Range, Words


class UnprovedError(Exception):
    """A word on the way is not proved to fit."""


@dataclass(frozen=True)
class Level:
    """What is added at a position and carried to `upper`: piles of addends, and half a last bit where it is rounded."""

    place: int
    upper: int
    piles: tuple[tuple[Addend, ...], ...]
    half: int

    @property
    def bits(self) -> int:
        """Return how far it is shifted."""
        return self.upper - self.place


def levels_of(
    words: Words, places: Mapping[int, Sequence[Addend]], discard: int, rounding: str
) -> tuple[list[Level], list[Range]]:
    """Return the levels below the last discarded bit, upwards, and the ranges of what they carry beyond it.

    Raises UnprovedError where a sum of them, a half included, may not fit a word.
    """
    below = sorted(place for place in places if place < discard)
    levels, carries = [], list[Range]()
    for place, upper in zip(below, [*below[1:], discard], strict=True):
        if upper - place >= WORD:
            raise UnprovedError
        half = 1 << (upper - place - 1) if upper == discard and rounding == "up" else 0
        level, ranges = _level(words, Level(place, upper, (), half), places[place], [Addend(each) for each in carries])
        # Only the first pile is rounded; of the others the carries are whole.
        halves = [half, *[0] * (len(ranges) - 1)]
        carries = [(a + up >> level.bits, b + up >> level.bits) for (a, b), up in zip(ranges, halves, strict=True)]
        levels.append(level)
    return levels, carries


def _level(words: Words, level: Level, addends: Sequence[Addend], into: Sequence[Addend]) -> tuple[Level, list[Range]]:
    """Return the level with its piles, and the range of each pile with all that is handed to it."""
    ordered = tuple(sorted(addends, key=lambda each: (each.negative, each.order)))
    if _fits(words, [*ordered, *into], level.half):
        return Level(level.place, level.upper, (ordered,), level.half), [words.sum([*ordered, *into])]
    left = Addend((0, (1 << level.bits) - 1))
    piles: list[list[Addend]] = []
    for each in ordered:
        for at, pile in enumerate(piles):
            handed = [*into, left, left] if at == 0 else []
            if _fits(words, [*pile, each, *handed], level.half):
                pile.append(each)
                break
        else:
            piles.append([each])
    first = [*piles[0], *into, *[left] * (len(piles) - 1)]
    if not _fits(words, first, level.half):
        raise UnprovedError
    found = Level(level.place, level.upper, tuple(map(tuple, piles)), level.half)
    return found, [words.sum(first), *map(words.sum, piles[1:])]


def _fits(words: Words, addends: Sequence[Addend], half: int) -> bool:
    low, high = words.sum(addends)
    return low >= LEAST and high + half <= MOST


def spread(constant: int, places: Sequence[int]) -> dict[int, int]:
    """Return a constant as a sum of words at the given positions, of which the least is 0."""
    kept = {}
    for place in reversed(places):
        raw = constant >> place
        constant -= raw << place
        if raw:
            kept[place] = raw
    return kept
