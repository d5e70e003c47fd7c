"""What the analysis says of a race, as plain values for a page.

Numbers and verdicts come from `matrixworld.analysis`, from the same functions that the command line
and the figures use; the page computes none of its own.
"""

from __future__ import annotations

from typing import Any

from matrixworld import analysis
from matrixworld.analysis.evidence import FEWEST_EPISODES
from matrixworld.analysis.plain_values import plain_values
from matrixworld.analysis.summary import MARGIN
from matrixworld.coevolution.payoff import Payoff

BOARDS = 12
"""The most checkerboards on a page: the strongest ones."""


def findings(payoff: Payoff) -> dict[str, Any]:
    """Return judgement, headline numbers and curves of a race.

    Parameters
    ----------
    payoff : Payoff
        Of at least 2 x 2 generations.

    Returns
    -------
    dict
        Plain values that JSON can hold.
    """
    matrix, rates = payoff.capture_rate, payoff.capture_rates
    judgement = analysis.judge(rates, per_episode=True)
    summary = analysis.summarize(matrix)
    return {
        "headline": analysis.headline(judgement),
        "window": judgement.window,
        "table": [list(row) for row in analysis.judgement_table(judgement)],
        "reasons": analysis.explain(judgement).splitlines(),
        "description": analysis.describe(summary).splitlines(),
        "noise": _noise(payoff, summary.last_half),
        "generalization": _generalization(payoff),
        "lags": plain_values(analysis.lag_profile(matrix)),
        "ciao": _ciao(payoff),
        "ratings": _ratings(payoff),
        "checkerboards": plain_values(
            analysis.strongest_checkerboards(matrix, count=BOARDS, margin=MARGIN)
        ),
        "margin": MARGIN,
    }


def _noise(payoff: Payoff, late: analysis.PartSummary) -> dict[str, Any]:
    """Return transitive share and checkerboards of the last half, and what noise alone gives."""
    rates = payoff.capture_rates[late.first_pursuers :, late.first_evaders :]
    # A single episode of each cell does not show its noise.
    noise = analysis.noise_reference(rates, margin=MARGIN) if rates.shape[2] >= 2 else None
    return {
        "transitive_share": late.transitive_share,
        "transitive_share_noise": noise and plain_values(noise.transitive_share),
        "checkerboard_share": late.checkerboard_share,
        "checkerboard_share_noise": noise and plain_values(noise.checkerboards),
    }


def _generalization(payoff: Payoff) -> dict[str, Any]:
    """Return the mean score of each generation, with intervals where episodes allow them."""
    means = analysis.generalization(payoff.capture_rate)
    curves: dict[str, Any] = {
        team: {"mean": plain_values(getattr(means, team)), "low": None, "high": None}
        for team in ("pursuers", "evaders")
    }
    if payoff.capture_rates.shape[2] >= 2:
        bands = analysis.generalization_over_episodes(payoff.capture_rates)
        for team, band in zip(curves, bands, strict=True):
            curves[team] |= {"low": plain_values(band.low), "high": plain_values(band.high)}
    return curves


def _ciao(payoff: Payoff) -> dict[str, Any]:
    # The triangles are the two halves of the payoff, which the page has.
    both = analysis.ciao(payoff.capture_rate)
    return {
        team: {
            "by_age": plain_values(triangle.by_age),
            "fading": plain_values(triangle.fading),
            "stripes": triangle.stripes,
            "period": triangle.period,
        }
        for team, triangle in both._asdict().items()
    }


def _ratings(payoff: Payoff) -> dict[str, Any]:
    ratings = analysis.elo(payoff.capture_rate)
    return {
        "pursuers": plain_values(ratings.pursuers * analysis.ELO_POINTS),
        "evaders": plain_values(ratings.evaders * analysis.ELO_POINTS),
        "offset": ratings.offset * analysis.ELO_POINTS,
    }


def too_few_episodes(payoff: Payoff) -> str:
    """Return what a small number of episodes means for the judgement; empty if they are enough."""
    episodes = payoff.capture_rates.shape[2]
    if episodes >= FEWEST_EPISODES:
        return ""
    return (
        f"Each cell has {episodes} episode{'' if episodes == 1 else 's'}; it takes at least "
        f"{FEWEST_EPISODES} to tell all conditions from noise."
    )
