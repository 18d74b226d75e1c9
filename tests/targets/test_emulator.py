"""The emulator calls as firmware does, and catches what a real core refuses and what no core would notice."""

from __future__ import annotations

import os
import signal
import struct

import pytest
from code_on import EMULATED, image_of, run_on

from qcone.targets import emulation as emulations
from qcone.targets.emulation import Emulation, NotMeasuredError
from qcone.targets.job import Buffer, Pointer
from qcone.targets.machines import TARGETS

ADD = "void called(const float *a, float *b);\nvoid called(const float *a, float *b) { b[1] = a[0] + b[0]; }\n"
MANY = (
    "void called(int a, int b, int c, int d, int e, int f, int g, int h, int i, int *out);\n"
    "void called(int a, int b, int c, int d, int e, int f, int g, int h, int i, int *out)\n"
    "{ out[0] = a + 2 * b + 4 * c + 8 * d + 16 * e + 32 * f + 64 * g + 128 * h + 256 * i; }\n"
)


def floats(*values: float, big: bool = False) -> bytes:
    return struct.pack(f"{'>' if big else '<'}{len(values)}f", *values)


@pytest.mark.parametrize("target", EMULATED)
def test_floats_and_stacked_arguments_on_every_target(target: str) -> None:
    big = TARGETS[target].big_endian
    ran = run_on(target, ADD, [Buffer("a", floats(1.5, big=big)), Buffer("b", floats(2.25, 0, big=big), True)])
    assert ran.fault is None
    assert ran.buffers[1] == floats(2.25, 3.75, big=big)
    ran = run_on(target, MANY, [Buffer("out", bytes(4), True)], [*[1] * 9, Pointer(0)])
    assert ran.fault is None
    assert ran.buffers[0] == (511).to_bytes(4, "big" if big else "little")


FAULTS = {
    "a write past the end": ("b[2] = a[0];", "out of bounds", "write of 4 bytes at byte 8 of b, which has 8"),
    "a write before the beginning": ("b[-1] = a[0];", "out of bounds", "write of 4 bytes at byte -4 of b"),
    "a write to what is read only": ("((float *)a)[0] = 1.0F;", "out of bounds", "write of 4 bytes at byte 0 of a"),
    "a read past the end": ("b[0] = a[1];", "out of bounds", "read of 4 bytes at byte 4 of a, which has 4"),
    "a write far away": ("*(volatile int *)0x40000000 = 1;", "out of bounds", "write of 4 bytes at address 0x40000000"),
    "a write above the stack": (
        "*(volatile int *)((char *)__builtin_frame_address(0) + 4096) = 1;",
        "out of bounds",
        "write of 4 bytes at address 0x78000",
    ),
    "a jump to nowhere": ("((void (*)(void))0x50000001)();", "instruction", ""),
    "a loop without end": ("for (volatile int n = 0;;) { n = 1; }", "instruction", "the call did not return within"),
}


@pytest.mark.parametrize("what", FAULTS)
def test_fault_is_caught_and_told(what: str, monkeypatch: pytest.MonkeyPatch) -> None:
    statement, kind, said = FAULTS[what]
    text = f"void called(const float *a, float *b);\nvoid called(const float *a, float *b) {{ {statement} }}\n"
    buffers = [Buffer("a", floats(1.0)), Buffer("b", floats(2.0, 3.0), True)]
    ran = run_on("cortex-m4f", text, buffers)
    assert ran.fault
    assert ran.fault.kind == kind
    assert ran.fault.what.startswith(said)


def test_write_of_one_byte_past_the_end_is_caught() -> None:
    """A guard page would not see it: the buffer's 8 bytes go on for four more."""
    text = "void called(char *b);\nvoid called(char *b) { b[4] = 1; }\n"
    ran = run_on("cortex-m0", text, [Buffer("b", bytes(4), True)])
    assert ran.fault
    assert ran.fault.what == "write of 1 bytes at byte 4 of b, which has 4"


UNALIGNED = "void called(char *b);\nvoid called(char *b) { *(volatile float *)(void *)(b + 2) = 1.0F; }\n"


@pytest.mark.parametrize("target", EMULATED)
def test_unaligned_access_is_caught_also_where_the_model_lets_it_pass(target: str) -> None:
    ran = run_on(target, UNALIGNED, [Buffer("b", bytes(8), True)])
    assert ran.fault
    assert ran.fault.kind == "unaligned"
    assert image_of(UNALIGNED, target).place(ran.fault.pc).startswith("called+0x")


def test_models_refuse_what_their_core_lacks() -> None:
    """Under unicorn's mode for Cortex-M a Cortex-M0 would run both."""
    divide = "int called(int a, int b);\nint called(int a, int b) { int q; __asm__(%s); return q; }\n"
    text = divide % '"sdiv %0, %1, %2" : "=r"(q) : "r"(a), "r"(b)'
    image = image_of(text, "cortex-m3")
    for target, runs in (("cortex-m3", True), ("cortex-m0", False)):
        function = image.function("called")
        assert function
        call = emulations.Call(function.address, (84, 2), traced=True)
        with Emulation() as emulation:
            ran = emulation.run(emulations.job_for(TARGETS[target], image, (), (call,)))
        assert (ran.fault is None) == runs


# Returns through a pop that is conditional, to an instruction that is to set the flags.
CONDITIONAL_POP = r"""
void called(int *a);
__attribute__((naked)) void called(int *a)
{
    __asm__("push {lr}\n adr r1, 1f\n adds r1, #1\n push {r1}\n movs r2, #0\n movs r3, #1\n cmp r3, #2\n"
            " it ne\n popne {pc}\n .align 2\n1: subs r3, #1\n beq 2f\n movs r2, #7\n2: adds r2, #2\n"
            " str r2, [r0]\n pop {pc}");
}
"""


def test_watched_load_in_a_conditional_block_leaves_nothing_behind() -> None:
    """Unicorn takes the instruction it returns to for conditional too, and those set no flags."""
    for traced in (False, True):
        ran = run_on("cortex-m4", CONDITIONAL_POP, [Buffer("a", bytes(4), True)], traced=traced)
        assert (ran.fault, ran.buffers[0]) == (None, (2).to_bytes(4, "little"))


def test_stack_is_counted_to_the_byte_reserved_or_written() -> None:
    text = "int called(int n);\nint called(int n) { volatile char room[%d]; room[n] = 1; return room[n]; }\n"
    stack = {size: run_on("cortex-m0", text % size, arguments=[1]).stack for size in (8, 408)}
    assert stack[408] - stack[8] == 400


def test_executed_addresses_are_those_of_the_function_in_order() -> None:
    ran = run_on("cortex-m4f", ADD, [Buffer("a", floats(1)), Buffer("b", floats(1, 0), True)], times=3)
    function = image_of(ADD, "cortex-m4f").function("called")
    assert function
    assert len(ran.traces) == 3
    first = struct.unpack(f"<{len(ran.traces[0]) // 4}I", ran.traces[0])
    assert first[0] == function.address
    assert list(first) == sorted(first)
    assert all(address in function for address in first)


HALF = "void called(float *a);\nvoid called(float *a) { a[0] = a[0] * 0.5F; }\n"


@pytest.mark.parametrize("target", ["cortex-m4f", "cortex-m7f", "cortex-m33f"])
def test_flush_to_zero_is_what_the_fpu_does(target: str) -> None:
    smallest = floats(2.0**-126)
    kept, flushed = (run_on(target, HALF, [Buffer("a", smallest, True)], flush=on).buffers[0] for on in (False, True))
    assert (kept, flushed) == (floats(2.0**-127), floats(0.0))


def test_a_crash_is_not_measured_and_the_next_job_is(monkeypatch: pytest.MonkeyPatch) -> None:
    with Emulation() as emulation:
        buffers = [Buffer("a", floats(1)), Buffer("b", floats(1, 0), True)]
        assert run_on("cortex-m0", ADD, buffers, emulation=emulation).fault is None
        assert emulation._process
        os.kill(emulation._process.pid, signal.SIGSEGV)
        with pytest.raises(
            NotMeasuredError, match=r"^not measured: the emulator was ended by signal SIGSEGV$"
        ) as caught:
            run_on("cortex-m0", ADD, buffers, emulation=emulation)
        assert caught.value.exit_code == 3
        assert run_on("cortex-m0", ADD, buffers, emulation=emulation).fault is None


def test_a_silent_emulator_is_not_measured() -> None:
    text = "void called(void);\nvoid called(void) { for (volatile int n = 0;;) { n = 1; } }\n"
    with Emulation(answer_s=1.0) as emulation, pytest.raises(NotMeasuredError, match="gave no answer within 1 s"):
        run_on("cortex-m0", text, traced=False, emulation=emulation)


def test_a_job_it_cannot_play_is_not_measured() -> None:
    with Emulation() as emulation, pytest.raises(NotMeasuredError, match="the emulator refused: UcError: "):
        run_on(
            "cortex-m0", ADD, [Buffer("a", floats(1)), Buffer("b", floats(1, 0), True)], flush=True, emulation=emulation
        )
