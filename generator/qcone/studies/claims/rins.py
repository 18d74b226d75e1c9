"""R15, R16 and D13: the rotating unit of rins before and after its corrections, through the generated C."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from qcone.studies.claims.claim import DOES_NOT_HOLD, Claim, Settings
from qcone.studies.encoder_readouts import FASTEST_HZ, Row, correction_rows

PAPER = "rins"
HALF_PERIOD = 525  # s between reversals, which have to fall on samples
COARSE = ("raw", "x4")
"""Encoders read out no finer than a pulse, or a quarter of one."""


def rate_of(settings: Settings) -> float:
    """Return the sampling rate in Hz: a tenth of the slowest rate of the other papers, reversals on samples."""
    wanted = min(settings.rate_hz / 10, FASTEST_HZ)
    return round(HALF_PERIOD * wanted) / HALF_PERIOD


def corrections(settings: Settings) -> Iterator[Claim]:
    """R15, R16: azimuth of encoders read finely; pitch and roll of every encoder. D13: azimuth of the raw encoder."""
    for row in _rows(settings):
        azimuth = row["id"] == "R15"
        if not azimuth or row["read_out"] not in COARSE:
            yield _claim(str(row["id"]), row)
    for row in _rows(settings):
        if row["id"] == "R15" and row["read_out"] in COARSE:
            yield _claim("D13", row)


@cache
def _rows(settings: Settings) -> list[Row]:
    return correction_rows(settings.seed, rate_of(settings))


def _claim(id_: str, row: Row) -> Claim:
    before, after = float(str(row["before"])), float(str(row["measured"]))
    verdict, reason = str(row["verdict"]), str(row["reason"])
    if id_ == "D13" and verdict == DOES_NOT_HOLD:
        reason = f"half an arcmin is finer than a pulse of 1.08 arcmin: {reason}"
    return Claim(
        id_,
        f"{row['quantity']} error before -> after the correction, arcsec peak to peak, encoder {row['read_out']}",
        PAPER,
        str(row["paper_value"]),
        f"{before:.4g} -> {after:.4g}",
        str(row["tolerance"]),
        verdict,
        reason,
    )
