"""From the scores of matches to the fitness of candidates."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from matrixworld.coevolution.sharing import competitive_sharing, reduced_virulence
from matrixworld.coevolution.types import FloatArray, Team
from matrixworld.rollout import EpisodeStatistics


def captured_fraction(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Share of evaders captured, averaged over the steps: fast captures count more. In [0, 1]."""
    captured = np.asarray(scores.captured_fraction, dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def capture_rate(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Share of evaders captured at the end of the episode. In [0, 1]."""
    captured = np.asarray(scores.capture_rate, dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def rewards(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Rewards summed over the team and the steps (not zero-sum)."""
    returns = scores.pursuer_return if team == "pursuer" else scores.evader_return
    return np.asarray(returns, dtype=np.float64)


FITNESS: dict[str, Callable[[EpisodeStatistics, Team], FloatArray]] = {
    "captured-fraction": captured_fraction,
    "capture-rate": capture_rate,
    "rewards": rewards,
}


def fitness(
    scores: EpisodeStatistics, team: Team, *, measure: str, overlap_penalty: float
) -> FloatArray:
    """Return the fitness (M,) of `team` in M matches, averaged over the worlds of each.

    Parameters
    ----------
    scores : of M matches, arrays (M, worlds).
    team : whose fitness.
    measure : key of `FITNESS`. The capture measures are 1 minus for evaders.
    overlap_penalty : penalty on evaders that share cells, times their overlap in [0, 1].
        Without it, where teammates may share a cell, evaders pile up in one corner: either nobody
        finds them or all are lost at once.
    """
    values = FITNESS[measure](scores, team)
    if team == "evader":
        values = values - overlap_penalty * np.asarray(scores.evader_overlap, dtype=np.float64)
    means: FloatArray = values.mean(axis=1)
    return means


def win_rates(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Return the payoff (M,) to `team`, in [0, 1], averaged over the worlds of each match."""
    return np.asarray(capture_rate(scores, team).mean(axis=1))


SHARING = ("none", "competitive")
"""How an individual's results against its opponents make its fitness."""


def mean_over_met(values: FloatArray) -> FloatArray:
    """Return the mean (n,) of each row of (n, m), leaving out NaN: who was not met."""
    means = values.mean(axis=1)
    return np.asarray(np.nanmean(values, axis=1) if np.isnan(means).any() else means)


def shared_fitness(
    fitness: FloatArray, payoff: FloatArray, *, sharing: str, virulence: float | None
) -> FloatArray:
    """Return the fitness (n,) of individuals from what they came to against m opponents.

    What `competitive_sharing` (scaled by n / m: then a population that beats everybody has a mean
    of 1) or `reduced_virulence` makes of the payoffs, less the mean penalty ``payoff - fitness``.
    With neither, the mean fitness over opponents.

    Parameters
    ----------
    fitness, payoff : (n, m), with the penalties and without; NaN where two did not meet.
    sharing : one of `SHARING`.
    virulence : from 0.5 to 1, or None.
    """
    if sharing == "competitive":
        n, m = len(payoff), np.count_nonzero(~np.isnan(payoff).all(axis=0))
        earned = competitive_sharing(np.nan_to_num(payoff)) * (n / m)
    elif virulence is not None:
        earned = reduced_virulence(np.nansum(payoff, axis=1), virulence)
    else:
        return mean_over_met(fitness)
    return np.asarray(earned - mean_over_met(payoff - fitness))
