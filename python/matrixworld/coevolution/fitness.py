"""From episode statistics to the fitness of candidates.

A measure of `FITNESS` gives a value for each match. With several opponents a candidate has several
values, which become one fitness: their mean, competitive fitness sharing, or reduced virulence.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.types import TEAMS, FloatArray, Team

if TYPE_CHECKING:
    from matrixworld.play.rollout import EpisodeStatistics


def captured_fraction(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Return the share of evaders captured, averaged over the steps, in [0, 1].

    Fast captures count more.
    """
    captured = np.asarray(scores.captured_fraction, dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def capture_rate(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Return the share of evaders captured at the end of the episode, in [0, 1]."""
    captured = np.asarray(scores.capture_rate, dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def rewards(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Return the rewards summed over the team and the steps (not zero-sum)."""
    returns = scores.pursuer_return if team == "pursuer" else scores.evader_return
    return np.asarray(returns, dtype=np.float64)


FITNESS: dict[str, Callable[[EpisodeStatistics, Team], FloatArray]] = {
    "captured-fraction": captured_fraction,
    "capture-rate": capture_rate,
    "rewards": rewards,
}
"""Measures by name. The capture measures of the evaders are 1 minus those of the pursuers."""

SHARING = ("none", "competitive")
"""How the values of a candidate against several opponents become its fitness."""

LEAST_VIRULENCE = 0.5
"""Below it, a candidate with the most wins would have a fitness below 0."""


def fitness(
    scores: EpisodeStatistics, team: Team, *, measure: str, overlap_penalty: float
) -> FloatArray:
    """Return the fitness of a team in each match, averaged over the worlds of the match.

    Parameters
    ----------
    scores : EpisodeStatistics
        Statistics of M matches, arrays of shape (M, worlds).
    team : {"pursuer", "evader"}
        Team whose fitness is returned.
    measure : str
        Key of `FITNESS`.
    overlap_penalty : float
        Penalty on evaders that share cells, multiplied by their overlap in [0, 1].

    Returns
    -------
    ndarray of float64, shape (M,)
        Fitness; higher is better.

    Notes
    -----
    Without the penalty, where teammates may share a cell, all evaders gather in one corner. Then
    pursuers find either no evader or all of them at once, and evaders learn little from it.
    """
    values = FITNESS[measure](scores, team)
    if team == "evader":
        values = values - overlap_penalty * np.asarray(scores.evader_overlap, dtype=np.float64)
    means: FloatArray = values.mean(axis=1)
    return means


def collisions(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Return the collisions (M,) at fault of `team` in each match, per 1000 agent-steps."""
    t = TEAMS.index(team)
    # (M, worlds, teams, kinds); a rate over all worlds of a match, as `SafetyMonitor` counts it.
    faults = np.asarray(scores.faults)[:, :, t].sum(axis=(1, 2))
    steps = np.asarray(scores.agent_steps)[:, :, t].sum(axis=1)
    return np.asarray(1000.0 * faults / np.maximum(steps, 1), dtype=np.float64)


def feasible_first(fitness: ArrayLike, violation: ArrayLike) -> FloatArray:
    """Return a fitness (n,) that ranks candidates within a limit before all others.

    `violation` (n,) is by how much each exceeds the limit; within it 0 or less. Of two candidates
    within the limit, the fitter one is better; of two beyond it, the one with the smaller
    violation.

    Deb 2000, "An efficient constraint handling method for genetic algorithms", Computer Methods in
    Applied Mechanics and Engineering 186, equation 5.
    """
    values, beyond = np.asarray(fitness, np.float64), np.asarray(violation, np.float64)
    within = beyond <= 0.0
    worst = values[within].min() if within.any() else 0.0
    return np.where(within, values, worst - beyond)


def win_rates(scores: EpisodeStatistics, team: Team) -> FloatArray:
    """Return the payoff (M,) to `team`, in [0, 1], averaged over the worlds of each match."""
    return np.asarray(capture_rate(scores, team).mean(axis=1))


def mean_over_opponents(values: FloatArray) -> FloatArray:
    """Return the mean of each row of (n, m) values; NaN marks an opponent that was not met."""
    # `nanmean` is several times slower; most tables have no NaN.
    means = values.mean(axis=1)
    return np.asarray(np.nanmean(values, axis=1) if np.isnan(means).any() else means)


def shared_fitness(
    fitness: FloatArray, payoff: FloatArray, *, sharing: str, virulence: float | None
) -> FloatArray:
    """Return the fitness (n,) of individuals from results (n, m) against several opponents.

    `fitness` has the penalties, `payoff` has not; NaN marks opponents that were not met. The result
    is `competitive_sharing` or `reduced_virulence` of the payoffs, minus the mean penalty; with
    neither, the mean fitness over opponents. Sharing is scaled by n / m: a population that beats
    every opponent then has a mean fitness of 1, whatever its size.
    """
    if sharing == "competitive":
        n, m = len(payoff), np.count_nonzero(~np.isnan(payoff).all(axis=0))
        earned = competitive_sharing(np.nan_to_num(payoff)) * (n / m)
    elif virulence is not None:
        earned = reduced_virulence(np.nansum(payoff, axis=1), virulence)
    else:
        return mean_over_opponents(fitness)
    return np.asarray(earned - mean_over_opponents(payoff - fitness))


def competitive_sharing(wins: ArrayLike) -> FloatArray:
    """Return the fitness by competitive fitness sharing.

    Each opponent is worth 1 in total, shared by the individuals that beat it. A rare win therefore
    counts for more.

    Parameters
    ----------
    wins : array_like of float, shape (n, m)
        How surely individual i beats opponent j, at least 0.

    Returns
    -------
    ndarray of float64, shape (n,)
        Fitness. It sums to the number of opponents that at least one individual beats.

    Raises
    ------
    ValueError
        If `wins` has another shape, or holds a number that is negative or not finite.

    Notes
    -----
    ``f_i = sum_j w_ij / sum_k w_kj``, over the opponents j that at least one individual beats.

    References
    ----------
    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """
    # Not only zeros and ones: a mean over episodes is a share of a win.
    matrix = np.asarray(wins, dtype=np.float64)
    if matrix.ndim != 2 or not ((matrix >= 0.0) & (matrix < np.inf)).all():
        raise ValueError(f"wins: expected (n, m) numbers >= 0, got shape {matrix.shape}: {matrix}")
    # An opponent that no individual beats is worth nothing, and would divide by zero.
    beaten = matrix[:, matrix.sum(axis=0) > 0.0]
    fitness: FloatArray = (beaten / beaten.sum(axis=0)).sum(axis=1)
    return fitness


def reduced_virulence(wins: ArrayLike, virulence: float) -> FloatArray:
    """Return the fitness by reduced virulence: the best share of the most wins is `virulence`.

    At virulence 1 more wins are always better. Below 1 a team that could win every match is held
    back, so that the other team keeps something to learn from.

    Parameters
    ----------
    wins : array_like of float, shape (n,)
        Wins of each individual, at least 0.
    virulence : float
        From 0.5 to 1.

    Returns
    -------
    ndarray of float64, shape (n,)
        Fitness, at most 1; zeros if all wins are 0.

    Raises
    ------
    ValueError
        If `wins` has another shape, or holds a number that is negative or not finite; if
        `virulence` is out of range.

    Notes
    -----
    ``f = 2x/v - x^2/v^2`` with ``x = wins / max(wins)`` and virulence v.

    References
    ----------
    Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing parasite
    virulence", Evolutionary Computation 12(2).
    """
    values = np.asarray(wins, dtype=np.float64)
    if values.ndim != 1 or not ((values >= 0.0) & (values < np.inf)).all():
        raise ValueError(f"wins: expected (n,) numbers >= 0, got shape {values.shape}: {values}")
    if not LEAST_VIRULENCE <= virulence <= 1.0:
        raise ValueError(f"virulence: expected {LEAST_VIRULENCE} to 1, got {virulence}")
    best = values.max(initial=0.0)
    share = (values / best if best > 0.0 else values) / virulence
    fitness: FloatArray = 2.0 * share - share * share
    return fitness
