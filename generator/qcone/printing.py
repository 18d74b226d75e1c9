"""Printing: a lowered program becomes the files of a bundle: every line of C, its contract, the batch loop."""

from __future__ import annotations

from qcone import contract, routine_contract, stage_routines
from qcone.backends import page as pages
from qcone.backends.c_furniture import furniture
from qcone.backends.c_source import functions
from qcone.backends.c_state import state_fields, state_initialiser, type_of
from qcone.bundle import Bundle, Lowered
from qcone.contract import Facts
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.machine import MachineOp
from qcone.ir.statement import Loop, Operation, Program, Role, Shape, reachable, walk
from qcone.state_routines import SETTERS
from qcone.targets.probe import contraction_probe


def emit(facts: Facts, written: Program, lowered: Lowered) -> Bundle:
    """Return the bundle of a lowered program: header, source and the batch loop it is tested with."""
    number, machine = facts.number, lowered.machine
    name, floating = machine.name, isinstance(facts.number, Floating)
    documented = tuple(
        pages.Documented(
            each.signature,
            each.body,
            each.internal,
            () if each.internal else routine_contract.of_routine(machine.routine(each.routine), facts),
        )
        for each in functions(machine, number)
    )
    page = pages.Page(
        name=name,
        command=contract.command(facts.design),
        license=facts.design.license,
        facts=contract.banner(facts),
        macros=contract.macros(facts, state_initialiser(machine, number), _bits(machine)),
        fields=tuple(pages.Field(*each) for each in state_fields(machine, number)),
        functions=documented,
        integers=any(block.integer for block in machine.state) or _has_integers(machine),
        significand=("FLT_MANT_DIG" if number.ctype == "float" else "DBL_MANT_DIG") if floating else "",
        digits=number.precision,
        interface=contract.INTERFACE,
        small=() if isinstance(number, Floating) else tuple(each.text for each in furniture(machine, number)),
    )
    driver = _driver(machine, number)
    header, source = pages.header(page), pages.source(page)
    return Bundle(
        facts,
        written,
        machine,
        header,
        source,
        pages.driver(driver, page),
        pages.vectors_main(driver),
        driver,
        lowered.macs,
    )


def _has_integers(machine: Program) -> bool:
    """Tell whether a routine counts in a loop or compares."""
    every = (each for routine in machine.routines for each in (routine, *reachable(routine)))
    return any(
        isinstance(each, Loop) or (isinstance(each, Operation) and each.op is MachineOp.LESS)
        for routine in every
        for each in walk(routine.body)
    )


def _bits(machine: Program) -> tuple[tuple[str, int], ...]:
    """Return the fraction bits of every block that is handed in or out, by name."""
    found: dict[str, int] = {}
    for routine in machine.routines:
        for block in (*routine.having(Role.INPUT), *routine.having(Role.OUTPUT)):
            if block.format is not None:
                found[block.name] = block.format.fraction
    return tuple(found.items())


def _driver(machine: Program, number: Floating | Fixed) -> pages.Driver:
    words: list[str] = []
    word_ctype = number.ctype if isinstance(number, Floating) else "int64_t"
    for block in machine.state:
        cast = f"({word_ctype})" if type_of(block, number) != word_ctype else ""
        single = block.shape is Shape.SCALAR and block.count == 1
        words += [f"{cast}state.{block.name}{'' if single else f'[{k}]'}" for k in range(block.size)]
    given = machine.routine("update").having(Role.INPUT)[0]
    setter = next(routine for routine in machine.routines if routine.name in SETTERS.values())
    sizes = {each.name: sum(block.size for block in each.having(Role.OUTPUT)) for each in machine.routines}
    outputs = tuple((name, size) for name, size in sizes.items() if size and name not in stage_routines.ROUTINES)
    stage = tuple((name, size) for name, size in sizes.items() if name in stage_routines.ROUTINES)
    return pages.Driver(
        name=machine.name,
        ctype=number.ctype,
        word_ctype=word_ctype,
        input_ctype=type_of(given, number),
        input_size=given.size,
        has_start=machine.has("start"),
        setter=setter.name,
        attitude_size=setter.having(Role.INPUT)[0].size,
        outputs=outputs,
        stage=stage,
        state_words=tuple(words),
        word_count=len(words) + sum(size for _, size in (*outputs, *stage)),
        probe=contraction_probe(f"{machine.name}_contracts") if isinstance(number, Floating) else "",
        fraction_bits=_bits(machine),
    )
