"""Read recorded or simulated gyroscope samples from CSV, and cut them into attitude updates.

Messages name the file, its line and the data row (the first row after the header is 1).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from qcone.errors import UsageError
from qcone.studies.columns import (
    COLUMNS,
    Table,
    find_columns,
    parse_columns,
    read_number,
    read_numbers,
    read_table,
)
from qcone.studies.resample import RATE_RANGE_HZ, even_rate, first_irregular, resample

COUNT_TOLERANCE = 1e-6
LARGEST_COUNT = 32767


@dataclass(frozen=True)
class Recording:
    """Samples of the body's rotation at even times, in radians and seconds, or in whole counts.

    `kind` is "increment" (`values` (n, 3) in rad, `time_s` (n,) the END of each sub-sample), "rate" (rad/s
    at the instants `time_s`) or "counts" (whole counts of `quantum_dps` deg/s, the mean rate of the sub-sample that
    ends at `time_s`). `sample_hz` is the sub-sample rate; `notes` are remarks for the user; `source`
    is the file's name for messages.
    """

    kind: str
    time_s: NDArray[np.float64]
    values: NDArray[np.float64]
    sample_hz: Fraction
    notes: tuple[str, ...] = ()
    source: str = "recording"
    path: Path | None = None
    quantum_dps: Fraction | None = None

    def as_increments(self) -> Recording:
        """Return counts as the increments they stand for; any other recording as it is."""
        if self.quantum_dps is None:
            return self
        unit = math.pi / 180 * float(self.quantum_dps / self.sample_hz)
        return replace(self, kind="increment", values=self.values * unit, quantum_dps=None)


@dataclass(frozen=True)
class Updates:
    """A recording cut into attitude updates.

    `values` (updates, N, 3) are the sub-samples of each update, `time_s` (updates,) its end. For rates
    `start` (3,) is the sample before the first update; for increments it is None. `notes` are those of the
    recording and the rows dropped.
    """

    start: NDArray[np.float64] | None
    values: NDArray[np.float64]
    time_s: NDArray[np.float64]
    notes: tuple[str, ...]


def read_recording(
    path: Path,
    kind: str,
    *,
    columns: str | None = None,
    sample_hz: float | Fraction | None = None,
    resample_hz: float | Fraction | None = None,
    quantum_dps: Fraction | None = None,
) -> Recording:
    """Read a CSV file of `kind` "increment", "rate" or "counts": a header line, then rows at even times.

    `columns` maps names and unit (`t=Time (s);x=...;y=...;z=...;unit=deg/s`); other columns are ignored.
    `sample_hz` gives or overrules the time column, of which only the first row is then read, as the origin
    (without one, the first sub-sample starts, or the first rate is taken, at 0 s). Otherwise a step more than
    1 % off the median is refused unless `resample_hz` puts the samples onto an even grid.

    `quantum_dps` belongs to counts: deg/s of one; rates in deg/s are counts too where they are whole multiples of it.

    Raises UsageError for anything in the file or the options that cannot be used, with its place and a hint.
    """
    if kind not in COLUMNS:
        raise UsageError(f"--input: '{kind}' is not known, give one of {', '.join(COLUMNS)}")
    if kind == "counts" and quantum_dps is None:
        raise UsageError("--input counts: a count has no unit, give --quantum-dps, as in --quantum-dps 2000/32768")
    if kind == "counts" and resample_hz is not None:
        raise UsageError("--resample: counts are whole numbers and cannot be interpolated, give --sample-hz HZ")
    given_hz = None if sample_hz is None else _rate("--sample-hz", sample_hz)
    wanted_hz = None if resample_hz is None else _rate("--resample", resample_hz)
    names, scale = (COLUMNS[kind], 1.0) if columns is None else parse_columns(columns, kind)
    table = read_table(path)
    places = find_columns(table, names, kind, needs_time=given_hz is None)
    if not table.rows:
        raise UsageError(f"{path}: no data rows after the header, nothing to replay")

    axes = [places["x"], places["y"], places["z"]]
    numbers = read_numbers(table, axes if given_hz else [places["t"], *axes])
    values = np.ascontiguousarray(numbers[:, -3:])
    values = values * scale if quantum_dps is None else _whole(table, values, None if scale else quantum_dps)
    notes: tuple[str, ...] = ()
    if given_hz is not None:
        origin = 0.0 if kind == "rate" else float(1 / given_hz)
        if "t" in places:
            origin = read_number(table, 0, places["t"])
            notes = (f"times follow --sample-hz {float(given_hz):g}, column '{names['t']}' gives only the first",)
        time_s = origin + np.arange(len(values)) / float(given_hz)
        hz = given_hz
    else:
        time_s = np.ascontiguousarray(numbers[:, 0])
        hz = _clock(table, time_s, resampled=wanted_hz is not None)
    if wanted_hz is not None:
        time_s, values, remarks = resample(str(path), kind, time_s, values, wanted_hz)
        hz, notes = wanted_hz, notes + remarks
    return Recording(kind, time_s, values, hz, notes, str(path), path, quantum_dps)


def _whole(table: Table, values: NDArray[np.float64], quantum: Fraction | None) -> NDArray[np.float64]:
    """Return values as whole counts of 16 bits, of `quantum` deg/s each where they are rates."""
    counts = values if quantum is None else values / float(quantum)
    whole = np.rint(counts)
    odd = (np.abs(counts - whole) > COUNT_TOLERANCE).any(axis=1)
    if odd.any():
        row = int(np.argmax(odd))
        unit = "counts" if quantum is None else f"multiples of {quantum} deg/s"
        raise UsageError(f"{table.place(row)}: not whole {unit}, give the right --quantum-dps, or --input rate")
    over = (np.abs(whole) > LARGEST_COUNT).any(axis=1)
    if over.any():
        row = int(np.argmax(over))
        raise UsageError(f"{table.place(row)}: a count beyond 16 bits, give the right --quantum-dps, or --input rate")
    return whole


def split_updates(recording: Recording, subsamples: int) -> Updates:
    """Cut a recording into updates of `subsamples` (N): N k increments, or N k + 1 rates, make k updates.

    Raises UsageError where there are fewer rows than one update takes.
    """
    rates = recording.kind == "rate"
    rows = len(recording.values)
    updates, left = divmod(rows - rates, subsamples)
    if updates < 1:
        takes = f"{subsamples + rates} ({subsamples} and the one it starts from)" if rates else f"{subsamples}"
        raise UsageError(
            f"{recording.source}: fewer rows than one update, {rows} given and one update takes "
            f"{takes}, give a longer recording or a smaller --subsamples"
        )
    used = slice(int(rates), int(rates) + updates * subsamples)
    notes = recording.notes
    if left:
        notes += (f"{left} of {rows} rows left over at the end and dropped: an update takes {subsamples}",)
    return Updates(
        start=recording.values[0].copy() if rates else None,
        values=recording.values[used].reshape(updates, subsamples, 3),
        time_s=recording.time_s[used][subsamples - 1 :: subsamples],
        notes=notes,
    )


def max_rate_dps(recording: Recording) -> Fraction:
    """Return the largest norm of the samples as a rate in deg/s, rounded up to two significant digits.

    Of an increment: its norm times the sub-sample rate. A norm within 2^-50 (relative) above two digits
    counts as those digits: a declared range holds plus one input LSB. Samples that are all zero give 1.
    """
    x, y, z = recording.values.T
    norm = float(np.max(np.hypot(np.hypot(x, y), z)))
    if recording.quantum_dps is not None and norm:
        return _two_digits(Fraction(norm) * recording.quantum_dps * (1 - Fraction(1, 2**50)))
    if norm == 0.0:
        return Fraction(1)
    per_second = recording.sample_hz if recording.kind == "increment" else 1
    return _two_digits(Fraction(norm) * per_second * Fraction(180 / math.pi) * (1 - Fraction(1, 2**50)))


def _two_digits(dps: Fraction) -> Fraction:
    exponent = Decimal(float(dps)).adjusted() - 1
    return math.ceil(dps / Fraction(10) ** exponent) * Fraction(10) ** exponent


def _rate(option: str, hz: float | Fraction) -> Fraction:
    """Return an option's rate as the decimal that was written."""
    low, high = RATE_RANGE_HZ
    if not low <= hz <= high:
        raise UsageError(f"{option}: {hz} is not a usable rate, give Hz from {low:g} to {high:g}")
    return Fraction(str(hz))


def _clock(table: Table, time_s: NDArray[np.float64], *, resampled: bool) -> Fraction:
    """Return the sub-sample rate of the time column, refusing times that do not increase or are uneven."""
    if len(time_s) < 2:
        raise UsageError(f"{table.path}: one row has no step to take the rate from, give --sample-hz HZ")
    steps = np.diff(time_s)
    if (steps <= 0).any():
        row = int(np.argmax(steps <= 0)) + 1
        raise UsageError(
            f"{table.place(row)}: time does not increase, {float(time_s[row])!r} s comes "
            f"after {float(time_s[row - 1])!r} s, sort or remove rows, or give --sample-hz HZ if they are "
            f"evenly sampled"
        )
    row_off = None if resampled else first_irregular(time_s)
    if row_off is not None:
        raise UsageError(
            f"{table.place(row_off)}: irregular step, {1e3 * steps[row_off - 1]:.6g} ms where the median "
            f"step is {1e3 * float(np.median(steps)):.6g} ms (1 % is allowed), give --resample HZ to "
            f"interpolate, or --sample-hz HZ if only the times are off"
        )
    hz = even_rate(time_s)
    low, high = RATE_RANGE_HZ
    if not low <= hz <= high:
        raise UsageError(f"{table.path}: steps of {float(steps[0]):g} s are not usable, are the times in seconds?")
    return hz
