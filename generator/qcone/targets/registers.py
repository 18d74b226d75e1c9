"""How each architecture is called under unicorn: its processor, its argument registers, its stack at entry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from qcone.targets.extra import needed
from qcone.targets.job import Job

_FLUSH_TO_ZERO = 1 << 24
_FPU_ON = 0x2000
"""The bit that switches the FPU on, in RISC-V's mstatus and in PowerPC's MSR alike."""


@dataclass(frozen=True)
class Convention:
    """Registers by unicorn's numbers, and `linkage`, the bytes above the stack pointer that a callee may write.

    `block_status` is the register that holds the state of a Thumb IT block.
    """

    pc: int
    sp: int
    back: int
    arguments: tuple[int, ...]
    linkage: int
    block_status: int | None = None


def library() -> Any:
    """Return the unicorn package. Raises MissingToolError."""
    with needed("unicorn"):
        import unicorn
    return unicorn


def processor(job: Job) -> tuple[Any, Convention]:
    """Return an emulated processor with its FPU on, and how functions are called on it. Raises MissingToolError."""
    makers = {"arm": _arm, "riscv": _riscv, "powerpc": _powerpc}
    return makers[job.architecture](job, library())


def _arm(job: Job, unicorn: Any) -> tuple[Any, Convention]:
    from unicorn import arm_const as arm

    # The mode for Cortex-M plays a Cortex-M33 whatever core is named (unicorn 2.1.4); plain Thumb plays the core.
    uc = unicorn.Uc(unicorn.UC_ARCH_ARM, unicorn.UC_MODE_THUMB)
    uc.ctl_set_cpu_model(getattr(arm, f"UC_CPU_ARM_{job.model}"))
    if job.flush:
        _flush(uc, arm)
    given = (arm.UC_ARM_REG_R0, arm.UC_ARM_REG_R1, arm.UC_ARM_REG_R2, arm.UC_ARM_REG_R3)
    return uc, Convention(arm.UC_ARM_REG_PC, arm.UC_ARM_REG_SP, arm.UC_ARM_REG_LR, given, 0, arm.UC_ARM_REG_CPSR)


def _flush(uc: Any, arm: Any) -> None:
    """Execute what firmware executes for it; writing the register from outside does not reach the FPU."""
    uc.mem_map(0, 0x1000)
    uc.mem_write(0, bytes.fromhex("e1ee100a"))  # vmsr fpscr, r0
    uc.reg_write(arm.UC_ARM_REG_R0, _FLUSH_TO_ZERO)
    uc.emu_start(1, 4)
    uc.mem_unmap(0, 0x1000)


def _riscv(job: Job, unicorn: Any) -> tuple[Any, Convention]:
    from unicorn import riscv_const as riscv

    uc = unicorn.Uc(unicorn.UC_ARCH_RISCV, unicorn.UC_MODE_RISCV32)
    uc.ctl_set_cpu_model(getattr(riscv, f"UC_CPU_RISCV32_{job.model}"))
    if job.fpu:
        uc.reg_write(riscv.UC_RISCV_REG_MSTATUS, uc.reg_read(riscv.UC_RISCV_REG_MSTATUS) | _FPU_ON)
    if job.global_pointer is not None:
        uc.reg_write(riscv.UC_RISCV_REG_GP, job.global_pointer)
    given = tuple(getattr(riscv, f"UC_RISCV_REG_A{number}") for number in range(8))
    return uc, Convention(riscv.UC_RISCV_REG_PC, riscv.UC_RISCV_REG_SP, riscv.UC_RISCV_REG_RA, given, 0)


def _powerpc(job: Job, unicorn: Any) -> tuple[Any, Convention]:
    from unicorn import ppc_const as ppc

    uc = unicorn.Uc(unicorn.UC_ARCH_PPC, unicorn.UC_MODE_PPC32 | unicorn.UC_MODE_BIG_ENDIAN)
    uc.reg_write(ppc.UC_PPC_REG_MSR, uc.reg_read(ppc.UC_PPC_REG_MSR) | _FPU_ON)
    given = tuple(getattr(ppc, f"UC_PPC_REG_{number}") for number in range(3, 11))
    # A callee keeps its return address in the caller's frame, above the back chain.
    return uc, Convention(ppc.UC_PPC_REG_PC, ppc.UC_PPC_REG_1, ppc.UC_PPC_REG_LR, given, 8)
