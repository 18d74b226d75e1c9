"""A replay session: the designs for a recording, their runs, and how far their attitudes lie apart."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import pi
from pathlib import Path

from qcone.design import Design, design_from_options
from qcone.design.numbers import exact
from qcone.errors import UsageError
from qcone.pipeline import build
from qcone.registry import algorithm_of, entries
from qcone.studies import ranges_used
from qcone.studies.attitude_csv import write_attitude
from qcone.studies.recording import Recording, max_rate_dps
from qcone.studies.replaying import Replay, angles_between, replay, vectors_of
from qcone.studies.selection import Say, caution

DEGREES = 180 / pi


def design_for(recording: Recording, algorithm: str, options: Mapping[str, str | None], say: Say) -> Design:
    """Return the design of command-line options for a recording; what is not given is taken from the data.

    The update rate is the sample rate over the sub-samples; the declared rate, unless given, the data's
    largest norm rounded up to two digits, which is said.
    """
    given = {word.replace("_", "-"): value for word, value in options.items() if value is not None}
    if "number" not in given:
        raise UsageError("--number: say the number format, float32 or float64")
    if "update-hz" in given:
        raise UsageError("--update-hz: a recording's own rate decides; give --sample-hz to overrule its time column")
    if "max-rate-dps" not in given:
        rate = max_rate_dps(recording)
        given["max-rate-dps"] = _decimal(rate)
        say(f"declared rate taken from the data: --max-rate-dps {given['max-rate-dps']}")
    base = {"algorithm": algorithm, "input": recording.kind, **given}
    if recording.quantum_dps is not None:
        base["quantum-dps"] = str(recording.quantum_dps)
    hz = _decimal(recording.sample_hz)
    single = design_from_options("replayed", {**base, "update_hz": hz}, entries())
    update_hz = recording.sample_hz / algorithm_of(single).subsamples
    return caution(design_from_options("replayed", {**base, "update_hz": _decimal(update_hz)}, entries()), say)


def _decimal(value: Fraction) -> str:
    return str(value.numerator) if value.denominator == 1 else repr(float(value))


def quantum(kind: str, text: str | None, designs: Sequence[Design]) -> Fraction | None:
    """Return the deg/s of one count, as given or as the designs have it; None where rows are no counts.

    Raises UsageError for an option that is no positive number, or that goes with no counts.
    """
    if kind != "counts":
        if text is not None:
            raise UsageError("--quantum-dps: it belongs to --input counts, leave it out")
        return None
    if text is None:
        return next((each.imu.quantum_dps for each in designs if each.imu.quantum_dps is not None), None)
    try:
        found = exact(text, rational=True)
    except (OverflowError, ZeroDivisionError):
        found = None
    if found is None or found <= 0:
        raise UsageError(f"--quantum-dps {text}: write a positive number, such as 2000/32768 or 0.061")
    return found


def ranges(designs: Sequence[Design], recording: Recording, initial: Sequence[float]) -> list[dict[str, object]]:
    """Return the bits that every value of fixed-point designs uses along a recording."""
    found: list[dict[str, object]] = []
    for design in designs:
        bundle = build(design)
        found += ranges_used.rows(bundle, vectors_of(bundle, recording, initial))
    return found


def quaternion(text: str) -> tuple[float, float, float, float]:
    """Return the quaternion written `w,x,y,z`. Raises UsageError for anything else."""
    parts = text.split(",")
    try:
        w, x, y, z = map(float, parts)
    except ValueError as error:
        raise UsageError(f"--initial {text}: write four numbers, w,x,y,z") from error
    return w, x, y, z


def run(
    designs: Iterable[Design],
    recording: Recording,
    initial: Sequence[float],
    output: Path | None,
    cc: str | None,
    compare: bool,
    say: Say,
) -> list[dict[str, object]]:
    """Run each design on the recording; write the first one's attitude; return their differences to it in degrees."""
    if output is not None and output.exists() and recording.path is not None and output.samefile(recording.path):
        raise UsageError(f"{output}: this is the recording itself; write the attitude to another file")
    rows: list[dict[str, object]] = []
    first: Replay | None = None
    for design in designs:
        done = replay(build(design), recording, initial, cc, compare)
        for note in done.notes:
            say(f"{design.name}: {note}" if first else note)
        if first is None:
            first = done
            if output is not None:
                write_attitude(output, done.time_s, done.q, done.raw)
        rows.append({**_difference(design, done, first), "differing_bits": 0 if compare else None})
    return rows


def _difference(design: Design, done: Replay, first: Replay) -> dict[str, object]:
    shared = sorted(set(done.time_s.tolist()) & set(first.time_s.tolist()))
    if not shared:
        return {
            "design": design.name,
            "updates": len(done.q),
            "compared": 0,
            "largest_deg": None,
            "final_deg": None,
        }
    ours = {time: row for row, time in enumerate(done.time_s.tolist())}
    theirs = {time: row for row, time in enumerate(first.time_s.tolist())}
    angles = angles_between(done.q[[ours[t] for t in shared]], first.q[[theirs[t] for t in shared]]) * DEGREES
    return {
        "design": design.name,
        "updates": len(done.q),
        "compared": len(shared),
        "largest_deg": float(angles.max()),
        "final_deg": float(angles[-1]),
    }
