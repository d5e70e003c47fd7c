"""The dominance tournament: which generations were really a step up?"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_payoff, check_rates, require

LEVEL = 0.05
"""Default level of the one-sided test of a champion against each rung."""

_ROUNDING = 1e-12  # differences of mean scores below this are floating-point noise


@dataclass(frozen=True)
class Ladder:
    """One team's dominant generations, in the order in which they came."""

    generations: tuple[int, ...]
    """Generation 0, and every one that scored significantly higher than all rungs before it."""
    p_values: tuple[float, ...]
    """For each rung after the first, the largest p-value against an earlier rung."""

    def __len__(self) -> int:
        return len(self.generations)


class Dominance(NamedTuple):
    """The ladders of both teams: the longer, the more real steps of progress."""

    pursuers: Ladder
    evaders: Ladder


class _Scores(NamedTuple):
    """Mean score of each generation over the other team's archive, and how sure it is; ``(n,)``."""

    mean: Rates
    variance: Rates
    """Of the mean."""
    spread: Rates
    """Sum of the squared variances of the cells over their degrees of freedom (Satterthwaite)."""


def dominance_tournament(scores: ArrayLike, *, level: float = LEVEL) -> Dominance:
    """The generations that beat all dominant ones before them (Stanley and Miikkulainen, 2002).

    Extended to two teams: the champion of a generation joins its team's ladder if its mean score
    against the other team's whole archive is significantly higher than that of every earlier rung.

    ``scores``, shape ``(n, m, episodes)``: capture rate of each episode, in [0, 1], at least two
    episodes a cell, played independently.

    The test: Welch's t of the two mean scores, one-sided at ``level``. The archive is fixed and
    only episodes are random, so the variance of a mean score is the sum of ``s_gh^2 / episodes``
    over opponents h, divided by m^2; degrees of freedom after Welch (1947) and Satterthwaite
    (1946). A champion has to pass against *all* rungs, which needs no correction; but each new
    generation is another chance, so among k equal generations about ``k * level`` rungs at most
    are chance. Where no score varies every difference is significant.

    Raises ValueError for another shape, a single episode, scores outside [0, 1], or a level
    outside (0, 1/2].
    """
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    episodes = array.shape[2]
    require(episodes >= 2, "at least 2 episodes a cell", episodes)
    means, variances = array.mean(axis=2), array.var(axis=2, ddof=1) / episodes
    return _both_ladders(means, variances, episodes - 1, level)


def dominance_of_counts(wins: ArrayLike, episodes: ArrayLike, *, level: float = LEVEL) -> Dominance:
    """The same from counts: ``wins`` of ``episodes`` that the pursuers won, shape ``(n, m)`` each.

    ``episodes`` may be one number for all cells. Scores are the shares ``wins / episodes``; the
    variance of a cell is ``q (1 - q) / episodes`` with ``q = (wins + 1) / (episodes + 2)``
    (Agresti and Caffo, 2000), so that a cell without a loss is not taken for certain, and the test
    is the normal limit of Welch's.

    Raises ValueError unless counts are whole, ``0 <= wins <= episodes`` and ``episodes >= 1``.
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
    shrunken = (won + 1.0) / (played + 2.0)
    return _both_ladders(means, shrunken * (1.0 - shrunken) / played, np.inf, level)


def _both_ladders(means: Rates, variances: Rates, freedom: float, level: float) -> Dominance:
    require(0.0 < level <= 0.5, "a level in (0, 0.5]", level)
    return Dominance(
        _ladder(_totals(means, variances, freedom), level),
        _ladder(_totals(1.0 - means.T, variances.T, freedom), level),
    )


def _totals(means: Rates, variances: Rates, freedom: float) -> _Scores:
    parts = variances / means.shape[1] ** 2
    return _Scores(means.mean(axis=1), parts.sum(axis=1), (parts**2 / freedom).sum(axis=1))


def _ladder(scores: _Scores, level: float) -> Ladder:
    rungs, p_values = [0], []
    for generation in range(1, len(scores.mean)):
        p = max(_p_value(scores, generation, rung) for rung in rungs)
        if p < level:
            rungs.append(generation)
            p_values.append(p)
    return Ladder(tuple(rungs), tuple(p_values))


def _p_value(scores: _Scores, one: int, other: int) -> float:
    """Of the hypothesis that ``one`` scores no higher than ``other``."""
    from scipy.special import stdtr

    difference = float(scores.mean[one] - scores.mean[other])
    variance = float(scores.variance[one] + scores.variance[other])
    if abs(difference) <= _ROUNDING or variance == 0.0:
        return 0.0 if difference > _ROUNDING else 1.0
    spread = float(scores.spread[one] + scores.spread[other])
    freedom = variance**2 / spread if spread > 0.0 else np.inf
    return float(stdtr(freedom, -difference / np.sqrt(variance)))
