"""The page of a design: everything its C files say, as plain text, ready for the templates to lay out."""

from __future__ import annotations

from dataclasses import dataclass

from qcone.backends.templates import render


@dataclass(frozen=True)
class Documented:
    """A function with the contract above its prototype, line by line; no contract for internal ones."""

    signature: str
    body: tuple[str, ...]
    internal: bool
    contract: tuple[str, ...]


@dataclass(frozen=True)
class Field:
    """A member of the state structure."""

    declaration: str
    meaning: str


@dataclass(frozen=True)
class Macro:
    """A macro of the header."""

    name: str
    text: str
    meaning: str


@dataclass(frozen=True)
class Page:
    """One design, printed. `banner` and `facts` are comment lines; `significand` guards the number format."""

    name: str
    command: str
    license: str
    facts: tuple[str, ...]
    macros: tuple[Macro, ...]
    fields: tuple[Field, ...]
    functions: tuple[Documented, ...]
    integers: bool
    significand: str
    digits: int
    interface: int
    small: tuple[str, ...] = ()
    """The small functions of a fixed-point file, as text; there `significand` is empty."""


@dataclass(frozen=True)
class Driver:
    """The test-only batch loop: sizes of one row of inputs, state words and outputs, and what to call.

    `outputs` are the functions that report on the state alone, `stage` those of a rotating unit, each with the number
    of values it gives.
    """

    name: str
    ctype: str
    word_ctype: str
    input_ctype: str
    input_size: int
    has_start: bool
    setter: str
    attitude_size: int
    outputs: tuple[tuple[str, int], ...]
    stage: tuple[tuple[str, int], ...]
    state_words: tuple[str, ...]
    word_count: int
    probe: str
    fraction_bits: tuple[tuple[str, int], ...] = ()
    """Fraction bits of the blocks handed in and out, by name; none for floats."""

    def bits(self, block: str) -> int | None:
        """Return the fraction bits of a block; None for floats."""
        return dict(self.fraction_bits).get(block)

    @property
    def reported(self) -> tuple[tuple[str, int], ...]:
        """Return every function that gives values after an update, in the order of a row's words."""
        return (*self.outputs, *self.stage)

    @property
    def body(self) -> tuple[tuple[str, int], ...]:
        """Return the functions of the stage that take the body's quaternion alone."""
        return self.stage[2:]


def header(page: Page) -> str:
    """Return the text of the header file."""
    return render("c/routine.h.j2", page=page, guard=page.name.upper() + "_H")


def source(page: Page) -> str:
    """Return the text of the source file."""
    return render("c/routine.c.j2", page=page)


def driver(made: Driver, page: Page) -> str:
    """Return the text of the batch loop."""
    return render("c/run.c.j2", driver=made, page=page)


def vectors_main(made: Driver) -> str:
    """Return a main program that runs the batch loop on a file of vectors: for sanitizers."""
    return render("c/main.c.j2", driver=made)


def board_main(made: Driver) -> str:
    """Return a main program that runs the batch loop's rows on a bare Cortex-M, by semihosting."""
    return render("c/board.c.j2", driver=made)


def avr_main(made: Driver) -> str:
    """Return a main program that runs rows kept in flash on an ATmega328P and writes their words to its serial port."""
    return render("c/avr.c.j2", driver=made)
