"""The dominance tournament: generations that were significantly better than all before them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_payoff, check_rates, require

LEVEL = 0.05
"""Default significance level of the one-sided test against each earlier dominant generation."""

_ROUNDING = 1e-12  # differences of mean scores below this are floating-point noise


@dataclass(frozen=True)
class Ladder:
    """The dominant generations of one team, ascending.

    Parameters
    ----------
    generations : tuple of int
        Generation 0, and every generation that scored significantly higher than all dominant
        generations before it.
    p_values : tuple of float
        For each dominant generation after the first, the largest p-value against an earlier one.
    """

    generations: tuple[int, ...]
    p_values: tuple[float, ...]

    def __len__(self) -> int:
        return len(self.generations)


class Dominance(NamedTuple):
    """The dominant generations of both teams: the more, the more significant steps of progress.

    Parameters
    ----------
    pursuers : Ladder
        Dominant generations of the pursuers.
    evaders : Ladder
        Dominant generations of the evaders.
    """

    pursuers: Ladder
    evaders: Ladder


class _Scores(NamedTuple):
    """Mean score of each generation over the other team's archive, and its variance; (n,) each."""

    mean: Rates
    variance: Rates  # of the mean
    spread: Rates  # sum over cells of squared variance / degrees of freedom (Satterthwaite)


def dominance_tournament(scores: ArrayLike, *, level: float = LEVEL) -> Dominance:
    """Find the generations that beat all dominant generations before them.

    A generation is dominant if its mean score against the whole archive of the other team is
    significantly higher than that of every earlier dominant generation. Generation 0 is dominant.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Capture rate of each episode, in [0, 1]; at least two independent episodes of each cell.
    level : float, optional
        Significance level of the one-sided test, in (0, 1/2].

    Returns
    -------
    Dominance
        The dominant generations of both teams.

    Raises
    ------
    ValueError
        If the shape is another one, a cell has a single episode, scores are outside [0, 1], or the
        level is outside (0, 1/2].

    Notes
    -----
    The test is Welch's t of the two mean scores. The archive is fixed and only episodes are random,
    so the variance of a mean score is the sum of ``s_gh^2 / episodes`` over opponents h, divided by
    ``m^2``. A generation has to pass against *all* dominant ones, which needs no correction for
    multiple tests. But each new generation is another chance to pass: among k equal generations at
    most about ``k * level`` are dominant by chance. Where no score varies, every difference is
    significant.

    References
    ----------
    Stanley and Miikkulainen (2002), "The dominance tournament method of monitoring progress in
    coevolution"; extended here to two teams. Welch (1947) and Satterthwaite (1946) for the degrees
    of freedom.
    """
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    episodes = array.shape[2]
    require(episodes >= 2, "at least 2 episodes a cell", episodes)
    means, variances = array.mean(axis=2), array.var(axis=2, ddof=1) / episodes
    return _both_ladders(means, variances, episodes - 1, level)


def dominance_of_counts(wins: ArrayLike, episodes: ArrayLike, *, level: float = LEVEL) -> Dominance:
    """Find the dominant generations from counts of won episodes.

    Parameters
    ----------
    wins : array_like of whole numbers, shape (n, m)
        Episodes of each cell that the pursuers won.
    episodes : array_like of whole numbers, shape (n, m) or ()
        Episodes of each cell, or one number for all cells.
    level : float, optional
        Significance level of the one-sided test, in (0, 1/2].

    Returns
    -------
    Dominance
        The dominant generations of both teams, as `dominance_tournament` defines them.

    Raises
    ------
    ValueError
        Unless counts are whole, ``0 <= wins <= episodes`` and ``episodes >= 1``.

    Notes
    -----
    The variance of a cell is ``q (1 - q) / episodes`` with ``q = (wins + 1) / (episodes + 2)``, so
    a cell without losses still has some variance. The test is the normal limit of Welch's t.

    References
    ----------
    Agresti and Caffo (2000), "Simple and effective confidence intervals for proportions".
    """
    won, played = np.broadcast_arrays(np.asarray(wins, float), np.asarray(episodes, float))
    whole = np.isfinite(won) & np.isfinite(played) & (won % 1 == 0) & (played % 1 == 0)
    bad = np.argwhere(~(whole & (played >= 1) & (won >= 0) & (won <= played)))
    if len(bad):
        where = tuple(int(i) for i in bad[0])
        raise ValueError(
            "expected whole numbers 0 <= wins <= episodes and episodes >= 1, "
            f"got {won[where]:g} of {played[where]:g} at index {where}"
        )
    means = check_payoff(won / played)
    # One win and one loss are added: otherwise a cell without losses would have no variance.
    shrunken = (won + 1.0) / (played + 2.0)
    return _both_ladders(means, shrunken * (1.0 - shrunken) / played, np.inf, level)


def _both_ladders(means: Rates, variances: Rates, freedom: float, level: float) -> Dominance:
    require(0.0 < level <= 0.5, "a level in (0, 0.5]", level)
    return Dominance(
        _ladder(_totals(means, variances, freedom), level),
        _ladder(_totals(1.0 - means.T, variances.T, freedom), level),
    )


def _totals(means: Rates, variances: Rates, freedom: float) -> _Scores:
    # A score is the mean of m cells, so each cell's variance counts 1 / m^2.
    parts = variances / means.shape[1] ** 2
    return _Scores(means.mean(axis=1), parts.sum(axis=1), (parts**2 / freedom).sum(axis=1))


def _ladder(scores: _Scores, level: float) -> Ladder:
    dominant, p_values = [0], []
    # In the order of time: a generation is compared with the dominant ones before it only.
    for generation in range(1, len(scores.mean)):
        p = max(_p_value(scores, generation, earlier) for earlier in dominant)
        if p < level:
            dominant.append(generation)
            p_values.append(p)
    return Ladder(tuple(dominant), tuple(p_values))


def _p_value(scores: _Scores, one: int, other: int) -> float:
    """Return the p-value of the hypothesis that ``one`` scores no higher than ``other``."""
    from scipy.special import stdtr

    difference = float(scores.mean[one] - scores.mean[other])
    variance = float(scores.variance[one] + scores.variance[other])
    if abs(difference) <= _ROUNDING or variance == 0.0:  # Welch's t is not defined
        return 0.0 if difference > _ROUNDING else 1.0
    spread = float(scores.spread[one] + scores.spread[other])
    # Infinite degrees of freedom make Student's t the normal distribution.
    freedom = variance**2 / spread if spread > 0.0 else np.inf
    return float(stdtr(freedom, -difference / np.sqrt(variance)))
