"""Ask the emulator, and outlive it: a process of its own makes the calls, and its crash is an answer too."""

from __future__ import annotations

import pickle
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from types import TracebackType

from qcone.errors import MissingToolError
from qcone.targets.elf import Image
from qcone.targets.job import LONGEST, ROOM, Buffer, Call, Job, Ran
from qcone.targets.machines import Target

ANSWER_S = 300.0
_SERVE = "import sys; sys.path[:] = {path!r}; from qcone.targets.emulator import serve; serve()"


class NotMeasuredError(MissingToolError):
    """The emulator gave no answer, so nothing is known of the code it ran (exit code 3)."""


class Emulation:
    """A process that runs jobs one after another; it is started when first asked, and again after a crash."""

    def __init__(self, answer_s: float = ANSWER_S) -> None:
        """Wait at most `answer_s` seconds for each answer."""
        self._answer_s = answer_s
        self._process: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> Emulation:
        """Return itself."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """End the process."""
        self.close()

    def close(self) -> None:
        """End the process, if there is one."""
        if self._process:
            self._process.kill()
            for stream in (self._process.stdin, self._process.stdout):
                if stream:
                    with suppress(BrokenPipeError):  # what a dead process was still to be told
                        stream.close()
            self._process.wait()
            self._process = None

    def run(self, job: Job) -> Ran:
        """Run a job. Raises NotMeasuredError when the process crashes, is silent, or refuses the job."""
        process = self._process = self._process or _start()
        assert process.stdin
        assert process.stdout
        silent = threading.Event()

        def give_up() -> None:
            silent.set()
            process.kill()

        patience = threading.Timer(self._answer_s, give_up)
        patience.start()
        try:
            pickle.dump(job, process.stdin)
            process.stdin.flush()
            answer = pickle.load(process.stdout)
        except (EOFError, OSError, pickle.UnpicklingError) as error:
            code = process.wait()
            self.close()
            how = f"gave no answer within {self._answer_s:g} s" if silent.is_set() else _ended(code)
            raise NotMeasuredError(f"not measured: the emulator {how}") from error
        finally:
            patience.cancel()
        if isinstance(answer, Ran):
            return answer
        self.close()
        if isinstance(answer, MissingToolError):
            raise answer
        raise NotMeasuredError(f"not measured: the emulator refused: {answer}")


def _start() -> subprocess.Popen[bytes]:
    command = [sys.executable, "-c", _SERVE.format(path=sys.path)]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def _ended(code: int) -> str:
    if code < 0:
        return f"was ended by signal {signal.Signals(-code).name}"
    return f"ended with exit code {code}"


def job_for(
    target: Target,
    image: Image,
    buffers: tuple[Buffer, ...],
    calls: tuple[Call, ...],
    *,
    flush: bool = False,
    instructions: int = 1 << 62,
    least: int = 0,
    longest: int = LONGEST,
) -> Job:
    """Return the job that makes `calls` in an image on a target; see Job.

    Raises NotMeasuredError for more memory than a target of 32 bits has room for beside the image.
    """
    asked = sum(len(each.data) for each in buffers)
    if asked > ROOM:
        much, most = -(-asked >> 20), ROOM >> 20
        raise NotMeasuredError(f"not measured: {much} MB of buffers, an emulated memory has {most}: take fewer rows")
    return Job(
        target.architecture,
        target.model,
        target.big_endian,
        tuple((each.address, each.data, each.size) for each in image.segments),
        buffers,
        calls,
        target.fpu != "none",
        image.symbols.get("__global_pointer$"),
        flush,
        instructions,
        least,
        longest,
    )
