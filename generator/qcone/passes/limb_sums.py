"""Sums of products of limbs: every one of a routine that is proved, written out, or in functions that several call.

A function takes words and cuts them itself: no more than eight, and only where it takes fewer instructions than to
write its sum out at every place.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from qcone.formats.fixed import Signal
from qcone.ir.detail import Aligned, Mac
from qcone.ir.index import Index
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Block, Call, Operation, Place, Role, Routine, Shape, Statement, Step, Write, unused
from qcone.passes.expand import Made, expand
from qcone.passes.fuse import args_of
from qcone.passes.limb_cuts import Sums, choose_cuts, sums_of_products
from qcone.passes.limb_levels import UnprovedError
from qcone.passes.limb_ranges import Norms, Words
from qcone.passes.limbs import LimbSums

LETTERS = "abcdefgh"
MOST_WORDS = len(LETTERS)
CALL, CUT = 2, 4
"""Instructions that a call takes beside handing over the words; and, at most, the cut of one of them."""
Members = list[tuple[Operation, Mac]]


def made_of_limbs(routine: Routine, norms: Norms, shared: bool) -> Made:
    """Return the sums of products of a routine that limbs can make; with `shared`, alike ones in functions."""
    words = Words(routine, norms)
    sums = sums_of_products(routine, words)
    called = _functions(routine, sums, words) if shared else Made()
    own = {result: each for result, each in sums.items() if result not in called.sums}
    made, _ = _written_out(routine, own, words)
    return Made({**made.sums, **called.sums}, made.names, called.callees)


def _written_out(routine: Routine, sums: Sums, words: Words) -> tuple[Made, int]:
    """Return each sum that is proved, and the instructions of all, the cuts left out."""
    cuts = choose_cuts(sums, words)
    limbs = LimbSums(words, cuts, unused(routine))
    found: dict[int, tuple[Statement, ...]] = {}
    for result, (operation, mac) in sums.items():
        begun, before = len(limbs.operations), (dict(limbs.made), dict(limbs.names), limbs.weight)
        try:
            limbs.make(operation, mac)
        except UnprovedError:
            limbs.made, limbs.names, limbs.weight = before
            del limbs.operations[begun:]
            continue
        found[result] = tuple(limbs.operations[begun:])
    cutting = sum(cuts[word].weight for word in limbs.made if word not in words.constants)
    return Made(found, limbs.names), limbs.weight - cutting


def _functions(routine: Routine, sums: Sums, words: Words) -> Made:
    """Return a call for every sum that a function makes, and the functions."""
    alike: dict[object, Members] = {}
    for operation, mac in sums.values():
        alike.setdefault(_form(operation, mac, words), []).append((operation, mac))
    calls: dict[int, tuple[Statement, ...]] = {}
    callees: dict[str, Routine] = {}
    for members in alike.values():
        given = [_words(mac, words) for _, mac in members]
        if len(members) < 2 or len(given[0]) > MOST_WORDS:
            continue
        name = f"{routine.name}_sum_{len(callees) + 1}"
        alone = _alone(name, members, given, words)
        inner = Words(alone)
        made, weight = _written_out(alone, sums_of_products(alone, inner), inner)
        function = weight + CUT * len(given[0]) + CALL
        if not made.sums or function + len(members) * (CALL + len(given[0])) >= len(members) * weight:
            continue
        callees[name] = replace(expand(alone, made=made), by_value=True)
        for (operation, _), args in zip(members, given, strict=True):
            calls[operation.result] = (Call(name, args, (operation.result,), operation.step),)
    return Made(calls, callees=callees)


def _words(mac: Mac, words: Words) -> tuple[int, ...]:
    """Return the words of a sum that are no constants, in the order they stand in."""
    return tuple(arg for arg in args_of(mac.terms) if arg not in words.constants)


def _form(operation: Operation, mac: Mac, words: Words) -> object:
    """Return all that a function of a sum depends on: two sums with one form are one function of their words."""
    given = _words(mac, words)
    named: dict[int, object] = {arg: ("word", k) for k, arg in enumerate(given)}
    known = {arg: (raw, words.formats[arg]) for arg, raw in words.constants.items()}
    terms = tuple((term.negative, term.shift, *((named | known)[arg] for arg in term.args)) for term in mac.terms)
    return terms, mac.discard, mac.rounding, tuple(words.formats[arg] for arg in given), operation.format


def _alone(name: str, members: Members, given: Sequence[tuple[int, ...]], words: Words) -> Routine:
    """Return the sum as a routine of its words, with the widest ranges that any member has."""
    (operation, mac), args = members[0], given[0]
    body: list[Statement] = []
    at: dict[int, int] = {}
    for k, arg in enumerate(args):
        most = max(max(-words.ranges[each[k]][0], words.ranges[each[k]][1]) for each in given)
        signal = words.formats[arg]
        at[arg] = k
        place = Place("word", Index(k))
        body.append(Operation(k, MachineOp.READ, place=place, format=signal, bound=most * signal.lsb))
    for term in mac.terms:
        for arg in term.args:
            if arg not in at:
                at[arg] = len(at)
                constant = words.constants[arg] * words.formats[arg].lsb
                body.append(Operation(at[arg], MachineOp.LITERAL, constant=constant, format=words.formats[arg]))
    terms = tuple(replace(term, args=tuple(at[arg] for arg in term.args)) for term in mac.terms)
    bounds = [each.bound for each, _ in members]
    bound = None if any(each is None for each in bounds) else max(each for each in bounds if each is not None)
    result = len(at)
    body.append(
        Operation(
            result,
            MachineOp.MAC,
            args_of(terms),
            format=operation.format,
            detail=replace(mac, terms=terms),
            bound=bound,
        )
    )
    body.append(Write(Place("value"), result))
    blocks = (
        Block("word", Shape.SCALAR, Role.INPUT, len(args)),
        Block("value", Shape.SCALAR, Role.OUTPUT),
    )
    step = Step(f"sum = ({_written(terms, body)}) / 2^{mac.discard} in raw words, of limbs")
    names = {**dict(zip(range(len(args)), LETTERS, strict=False)), result: "sum"}
    return Routine(name, blocks, tuple(body), (step,), names)


def _written(terms: Sequence[Aligned], body: Sequence[Statement]) -> str:
    """Return a sum as a reader writes it, its words called by letters."""
    known = {each.result: each for each in body if isinstance(each, Operation)}
    text = ""
    for term in terms:
        factors = [f"2^{term.shift}"] if term.shift else []
        for arg in term.args:
            made = known[arg]
            raw = made.constant / made.format.lsb if made.constant and isinstance(made.format, Signal) else None
            factors.append(LETTERS[arg] if raw is None else str(raw))
        sign = "-" if term.negative else "+" if text else ""
        text += f" {sign} {' '.join(factors)}" if text else f"{sign}{' '.join(factors)}"
    return text
