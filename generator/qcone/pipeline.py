"""READ ME FIRST. From a design to a bundle of C, on one screen: spec, real, passes, machine, readings.

    written   assemble the author's routine and those around it, nothing shared     real language
    ready     fold constants, share, sweep, carry signs: exact passes only          real language
    machine   lower to the number format, name every value                          machine language
    readings  print C, count operations; the bit-true model runs the same routines

`check` looks for legality after every pass. `verify.accept` reads the C back, compares bits, and gives the
`VerifiedBundle` that alone can be written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from qcone import stage_routines
from qcone.admission import check_stages, number_of, problem
from qcone.assembly import assemble, rotation_bound, writing_of
from qcone.backends.counts import Counts, count
from qcone.bundle import Bundle, Lowered
from qcone.contract import Facts
from qcone.declaration import declaration, in_fixed_point
from qcone.design import Design
from qcone.errors import CheckError, DesignError, Problem, UsageError
from qcone.formats.fixed import Fixed
from qcone.formats.floating import Floating
from qcone.ir.check import check_program
from qcone.ir.evaluate import agree
from qcone.ir.machine import MachineOp
from qcone.ir.operations import RealOp
from qcone.ir.specification import Algorithm
from qcone.ir.statement import Program, Routine
from qcone.ir.writing import Writing
from qcone.passes.choices import PinError
from qcone.passes.compensate import compensate
from qcone.passes.declared import Declaration as Declared
from qcone.passes.exponential import Exponential, choose
from qcone.passes.fixed_point import to_fixed
from qcone.passes.fold import fold
from qcone.passes.functions import choose_functions, choose_small_angle
from qcone.passes.lower_float import lower_program
from qcone.passes.naming import name_values
from qcone.passes.share import share
from qcone.passes.signs import signs
from qcone.passes.sweep import sweep
from qcone.passes.zeros import zeros
from qcone.printing import emit
from qcone.products import products_of, told
from qcone.registry import algorithm_of, digest_of

EXACT: tuple[Callable[[Routine], Routine], ...] = (fold, share, zeros, sweep, signs, sweep)
RESERVED = ("state", "result")
COUNTED = ("update", "hold", "start_up", "steady", "dcm", "euler", *stage_routines.ROUTINES)
"""The routines whose operations are reported: those that run with every update, and the outputs beyond a copy."""


def build(design: Design) -> Bundle:
    """Return the bundle of a design: its programs, its C and its facts. Raises a QconeError that says why not."""
    number = number_of(design)
    algorithm = algorithm_of(design)
    check_stages(design, algorithm)
    products = products_of(design)
    exponential = choose_exponential(design, algorithm, number)
    written = write(design, algorithm, exponential)
    ready = prepare(written, design)
    known = declaration(design, algorithm)
    lowered = lower(ready, design, number, in_fixed_point(design, algorithm, known, exponential))
    counts = levels(written, ready, lowered.machine)
    said = told(design, products, lowered.machine)
    facts = Facts(design, algorithm, number, known, exponential, digest_of(design), counts, lowered.proved, said)
    _within_budget(facts)
    return emit(facts, written, lowered)


def choose_exponential(design: Design, algorithm: Algorithm, number: Floating | Fixed) -> Exponential | None:
    """Return the polynomials of exp for the declared range; None where the algorithm takes no exp."""
    phi_max = rotation_bound(algorithm, design)
    if phi_max is None:
        return None
    try:
        return choose(design.exponential, phi_max, number, design.number.accumulate)
    except UsageError as error:
        raise problem(design, "QC204", str(error)) from error


def choose_writing(design: Design, algorithm: Algorithm, exponential: Exponential | None) -> Writing:
    """Return how the shorthand is written out, with the polynomials of the design's number format."""
    number, largest = number_of(design), declaration(design, algorithm).correction
    small = choose_small_angle(number, largest) if largest else None
    return writing_of(design, exponential.series if exponential else None, choose_functions(number), small)


def write(design: Design, algorithm: Algorithm, exponential: Exponential | None) -> Program:
    """Return the program as its author wrote it, in the design's form.

    Raises UsageError when loops kept as loops do not say what they say written out, turn by turn.
    """
    writing = choose_writing(design, algorithm, exponential)
    program = check_program(assemble(algorithm, design, writing), RealOp)
    if writing.rolled:
        written_out = assemble(algorithm, design, replace(writing, rolled=False))
        if not all(map(agree, program.routines, written_out.routines)):
            raise UsageError(
                f"algorithm '{algorithm.name}': rolled into loops it is another calculation than written out: what one "
                "turn hands to the next belongs into a history, and a turn may not depend on the counter by an if"
            )
    return program


def prepare(program: Program, design: Design) -> Program:
    """Apply the exact passes: no bit of any result can change."""
    if isinstance(number_of(design), Floating) and design.number.accumulate == "compensated":
        program = check_program(compensate(program), RealOp)
    for each in EXACT:
        program = replace(program, routines=tuple(map(each, program.routines)))
        check_program(program, RealOp)
    return program


def lower(program: Program, design: Design, number: Floating | Fixed, declared: Declared) -> Lowered:
    """Type every value and give it a name; fixed point by way of sums of products, with formats that are proved."""
    if isinstance(number, Floating):
        return Lowered(_named(lower_program(program, number)))
    products = products_of(design)
    try:
        fixed = to_fixed(program, number, declared, design.number.accumulate == "compensated", products)
    except UsageError as error:
        hint = "raise update_hz, lower max_rate_dps, or choose a wider format"
        if isinstance(error, PinError):
            hint = "pin fewer bits, or take the names from the emitted C"
        raise problem(design, "QC211", str(error), "", hint) from error
    return Lowered(_named(fixed.integers), check_program(fixed.macs, MachineOp), fixed.proved)


def _named(machine: Program) -> Program:
    check_program(machine, MachineOp)
    named = tuple(name_values(routine, RESERVED) for routine in machine.routines)
    return check_program(replace(machine, routines=named), MachineOp)


def levels(written: Program, ready: Program, machine: Program) -> dict[str, dict[str, Counts]]:
    """Count the routines that firmware runs every update, at three levels."""
    found: dict[str, dict[str, Counts]] = {}
    for routine in machine.routines:
        if routine.name not in COUNTED:
            continue
        if routine.name == "update" and machine.has("steady"):
            continue
        found[routine.name] = {
            "as-written": count(written.routine(routine.name)).as_papers_count(),
            "shared": count(ready.routine(routine.name)),
            "emitted": count(routine),
        }
    return found


def _within_budget(facts: Facts) -> None:
    """Raise a CheckError when an update costs more than the design's budget allows."""
    spent = facts.counts.get("steady") or facts.counts["update"]
    over = [
        f"{getattr(spent['emitted'], kind)} of '{kind}', over the budget of {allowed}"
        for kind, allowed in facts.design.budget.items()
        if getattr(spent["emitted"], kind) > allowed
    ]
    if over:
        raise CheckError(
            f"design '{facts.design.name}': an update takes {' and '.join(over)}: choose a cheaper algorithm or raise "
            "the budget"
        )


def build_all(designs: Iterable[Design]) -> tuple[Bundle, ...]:
    """Build several designs, in order. Raises one DesignError with the mistakes of all of them."""
    bundles: list[Bundle] = []
    problems: list[Problem] = []
    late: CheckError | None = None
    for design in designs:
        try:
            bundles.append(build(design))
        except DesignError as error:
            problems += error.problems
        except CheckError as error:
            late = late or error
    if problems:
        raise DesignError(problems)
    if late:
        raise late
    return tuple(bundles)
