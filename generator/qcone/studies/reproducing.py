"""Reproduce: measure every claim of the papers anew. Nothing is stored: a seed or a rate moves the figures."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from functools import partial

from qcone.errors import UsageError
from qcone.studies.claims import coning, counts, errata, exact, manoeuvre, rins, thesis2008, values
from qcone.studies.claims.claim import BASE_HZ, DOES_NOT_HOLD, Claim, Settings, Study
from qcone.studies.curves import cao as cao_curves
from qcone.studies.curves import rins as rins_curves
from qcone.studies.curves import thesis2008 as thesis2008_curves
from qcone.studies.curves import xu2019 as xu2019_curves
from qcone.studies.curves.figure import Figure

Row = dict[str, object]

PAPERS = ("cao", "thesis2008", "rins", "xu2019")
SLOWEST_HZ, FASTEST_HZ = 25.0, 2000.0
"""Rates the studies can be run at: series do not converge at slower ones, faster ones take memory."""

STUDIES: tuple[tuple[Study, tuple[str, ...]], ...] = (
    (exact.derivations, ("cao", "xu2019")),
    (exact.coning_drift, ("cao", "xu2019")),
    (counts.table_1, ("xu2019",)),
    (counts.least_counts, ("xu2019",)),
    (coning.ideal_sampling, ("xu2019",)),
    (coning.more_subsamples, ("xu2019",)),
    (coning.quantised, ("xu2019",)),
    (manoeuvre.large_angles, ("xu2019",)),
    (manoeuvre.papers_reference, ("xu2019",)),
    (thesis2008.step_ratios, ("thesis2008",)),
    (thesis2008.frequency_ratios, ("thesis2008",)),
    (thesis2008.norm_loss, ("thesis2008",)),
    (thesis2008.true_error, ("thesis2008",)),
    (rins.corrections, ("rins",)),
    (values.rotation_vector_values, ("cao",)),
    (values.series_values, ("xu2019",)),
    (errata.matrix_equations, ("xu2019",)),
    (errata.increments_from_rates, ("cao",)),
    (errata.figure_without_data, ("cao",)),
)
"""Every study with the papers whose claims it measures."""

FIGURES: Mapping[str, tuple[Callable[[Settings], Figure], ...]] = {
    "cao": cao_curves.FIGURES,
    "thesis2008": thesis2008_curves.FIGURES,
    "rins": rins_curves.FIGURES,
    "xu2019": xu2019_curves.FIGURES,
}


def settings_of(paper: str | None, seed: int, rate_hz: float) -> Settings:
    """Return the settings of a run. Raises UsageError for a paper there is not, or a rate out of range."""
    if paper is not None and paper not in PAPERS:
        close = get_close_matches(paper, PAPERS, 1, 0.4)
        hint = f"did you mean '{close[0]}'?" if close else f"the papers are: {', '.join(PAPERS)}"
        raise UsageError(f"reproduce {paper}: there is no such paper; {hint}")
    if not SLOWEST_HZ <= rate_hz <= FASTEST_HZ:
        raise UsageError(
            f"--rate-hz {rate_hz:g}: the papers' slowest sampling rate is {BASE_HZ:g} Hz and the others keep their "
            f"ratio to it; give {SLOWEST_HZ:g} to {FASTEST_HZ:g} Hz"
        )
    return Settings(seed, rate_hz)


def work(paper: str | None, settings: Settings) -> list[Callable[[], list[Claim]]]:
    """Return what is to be done for a paper, or for all, one study at a time."""

    def claims(study: Study) -> list[Claim]:
        return [claim for claim in study(settings) if paper in (None, claim.paper)]

    return [partial(claims, study) for study, papers in STUDIES if paper is None or paper in papers]


def rows(done: Iterable[Callable[[], list[Claim]]]) -> list[Row]:
    """Do the work and return a row for each claim: R1 to R17, then the D lines."""
    claims = [claim for study in done for claim in study()]
    return [dict(vars(claim)) for claim in sorted(claims, key=lambda claim: (claim.id[0] != "R", int(claim.id[1:])))]


def broken(found: Iterable[Row], settings: Settings) -> bool:
    """Tell whether a claim R1 to R17 fails at the papers' rates: then something of ours is broken.

    At another rate the accepted ranges are not stated, and a D line is known not to hold.
    """
    failed = any(str(row["id"]).startswith("R") and row["verdict"] == DOES_NOT_HOLD for row in found)
    return failed and settings.rate_hz == BASE_HZ


def figures(paper: str | None, settings: Settings) -> list[Callable[[], Figure]]:
    """Return what makes each figure of a paper, or of all."""
    chosen = PAPERS if paper is None else (paper,)
    return [partial(make, settings) for name in chosen for make in FIGURES[name]]
