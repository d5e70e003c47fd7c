"""From episode statistics to the fitness of candidates.

A measure of `FITNESS` gives a value for each match. With several opponents a candidate has several
values, which become one fitness: their mean, competitive fitness sharing, or reduced virulence.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_floats, check_number
from matrixworld.coevolution.types import TEAMS, FloatArray, Team

if TYPE_CHECKING:
    from matrixworld.play.rollout import EpisodeStatistics


FITNESS = ("captured-fraction", "capture-rate", "rewards")
"""Measures: of the captured evaders the share averaged over the steps, in which fast captures count
more, or the share at the end, both in [0, 1] (of the evaders 1 minus those of the pursuers); and
the rewards summed over the team and the steps (not zero-sum)."""

SHARING = ("none", "competitive")
"""How the values of a candidate against several opponents become its fitness."""

LEAST_VIRULENCE = 0.5
"""Below it, a candidate with the most wins would have a fitness below 0."""


def measured(scores: EpisodeStatistics, team: Team, measure: str) -> FloatArray:
    """Return a measure of `FITNESS` for a team, (M, worlds) float64."""
    if measure == "rewards":
        returns = scores.pursuer_return if team == "pursuer" else scores.evader_return
        return np.asarray(returns, dtype=np.float64)
    captured = np.asarray(getattr(scores, measure.replace("-", "_")), dtype=np.float64)
    return captured if team == "pursuer" else 1.0 - captured


def fitness(
    scores: EpisodeStatistics, team: Team, *, measure: str, overlap_penalty: float
) -> FloatArray:
    """Return the fitness (M,) of a team in M matches, the mean over the worlds of each.

    The penalty on evaders that share cells is multiplied by their overlap in [0, 1]. Without it,
    where teammates may share a cell, all evaders gather in one corner. Then pursuers find either no
    evader or all of them at once, and evaders learn little from it.
    """
    values = measured(scores, team, measure)
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
    return np.asarray(measured(scores, team, "capture-rate").mean(axis=1))


def mean_over_opponents(values: FloatArray) -> FloatArray:
    """Return the mean of each row of (n, m) values; NaN marks an opponent that was not met."""
    # `nanmean` is several times slower; most tables have no NaN.
    means = values.mean(axis=1)
    return np.asarray(np.nanmean(values, axis=1) if np.isnan(means).any() else means)


def shared_fitness(fitness: FloatArray, payoff: FloatArray, virulence: float | None) -> FloatArray:
    """Return the fitness (n,) of individuals from results (n, m) against several opponents.

    `fitness` has the penalties, `payoff` has not; NaN marks opponents that were not met. The result
    is `reduced_virulence` of the payoffs, or without it `competitive_sharing`, minus the mean
    penalty. Sharing is scaled by n / m: a population that beats every opponent then has a mean
    fitness of 1, whatever its size.
    """
    if virulence is not None:
        earned = reduced_virulence(np.nansum(payoff, axis=1), virulence)
    else:
        n, m = len(payoff), np.count_nonzero(~np.isnan(payoff).all(axis=0))
        earned = competitive_sharing(np.nan_to_num(payoff)) * (n / m)
    return np.asarray(earned - mean_over_opponents(payoff - fitness))


def competitive_sharing(wins: ArrayLike) -> FloatArray:
    """Return the fitness (n,) float64 by competitive fitness sharing.

    Each opponent is worth 1 in total, shared by the individuals that beat it. A rare win therefore
    counts for more: ``f_i = sum_j w_ij / sum_k w_kj``, over the opponents j that at least one
    individual beats, whose number is the sum of the fitness.

    Parameters
    ----------
    wins : array_like of float, shape (n, m)
        How surely individual i beats opponent j; ValueError unless all are finite and at least 0.

    References
    ----------
    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """
    # Not only zeros and ones: a mean over episodes is a share of a win.
    matrix = check_floats("wins", wins)
    if matrix.ndim != 2 or not ((matrix >= 0.0) & (matrix < np.inf)).all():
        raise ValueError(f"wins: expected (n, m) numbers >= 0, got shape {matrix.shape}: {matrix}")
    # An opponent that no individual beats is worth nothing, and would divide by zero.
    beaten = matrix[:, matrix.sum(axis=0) > 0.0]
    fitness: FloatArray = (beaten / beaten.sum(axis=0)).sum(axis=1)
    return fitness


def reduced_virulence(wins: ArrayLike, virulence: float) -> FloatArray:
    """Return the fitness (n,) float64 by reduced virulence, at most 1; zeros if all wins are 0.

    ``f = 2x/v - x^2/v^2`` with ``x = wins / max(wins)`` and virulence v: the best share of the most
    wins is v. At virulence 1 more wins are always better. Below 1 a team that could win every match
    is held back, so that the other team keeps something to learn from.

    Parameters
    ----------
    wins : array_like of float, shape (n,)
        Wins of each individual; ValueError unless all are finite and at least 0.
    virulence : float
        From 0.5 to 1, or ValueError is raised.

    References
    ----------
    Cartlidge & Bullock 2004, "Combating coevolutionary disengagement by reducing parasite
    virulence", Evolutionary Computation 12(2).
    """
    values = check_floats("wins", wins)
    check_number("virulence", virulence, least=LEAST_VIRULENCE, most=1.0)
    if values.ndim != 1 or not ((values >= 0.0) & (values < np.inf)).all():
        raise ValueError(f"wins: expected (n,) numbers >= 0, got shape {values.shape}: {values}")
    best = values.max(initial=0.0)
    share = (values / best if best > 0.0 else values) / virulence
    fitness: FloatArray = 2.0 * share - share * share
    return fitness
