"""From scores to the fitness of candidates.

A measure of the game gives a value for each match. With several opponents a candidate has several
values, which become one fitness: their mean, or competitive fitness sharing.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from matrixworld.coevolution.game import Game, Scores
from matrixworld.coevolution.pursuit import FITNESS
from matrixworld.coevolution.sections import Section, section, setting
from matrixworld.coevolution.types import FloatArray, Team

Table = Callable[[FloatArray], FloatArray]
"""Arranges one value of each match (M,) as a table (n, m) of individuals against opponents, with
NaN for pairs that did not play."""

SHARING = ("none", "competitive")
"""How the values of a candidate against several opponents become its fitness."""


@section
class FitnessSettings(Section):
    """What candidates are selected by."""

    measure: str = setting("captured-fraction", f"one of {', '.join(FITNESS)}", choices=FITNESS)
    cost_limit: float | None = setting(
        None,
        "collisions at fault per 1000 agent-steps; candidates within it rank first; default: no "
        "limit",
    )
    sharing: str = setting(
        "none", f"fitness sharing over several opponents: {', '.join(SHARING)}", choices=SHARING
    )

    def check(self) -> None:
        """Raise ValueError for sharing of rewards, which are not in [0, 1]."""
        if self.sharing != "none" and self.measure == "rewards":
            raise ValueError("sharing: expected a measure from 0 to 1, got 'rewards'")

    def fitness(self, game: Game, scores: Scores, team: Team, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's individuals from their matches (M,)."""
        values = table(game.values(scores, team, self.measure).mean(axis=1))
        found = mean_over_opponents(values)
        if self.sharing != "none":
            # Sharing is of results in [0, 1]; the penalty is subtracted afterwards.
            payoff = table(game.values(scores, team, self.measure, raw=True).mean(axis=1))
            found = shared_fitness(payoff) - mean_over_opponents(payoff - values)
        if self.cost_limit is None:
            return found
        excess = mean_over_opponents(table(game.costs(scores, team))) - self.cost_limit
        return feasible_first(found, excess)


def feasible_first(fitness: FloatArray, violation: FloatArray) -> FloatArray:
    """Return a fitness (n,) that ranks candidates with no `violation` (n,) of a limit first.

    Others rank by their violation alone (Deb 2000, "An efficient constraint handling method").
    """
    within = violation <= 0.0
    worst = fitness[within].min() if within.any() else 0.0
    return np.where(within, fitness, worst - violation)


def mean_over_opponents(values: FloatArray) -> FloatArray:
    """Return the mean of each row of (n, m) values; NaN marks an opponent that was not met."""
    # `nanmean` is several times slower; most tables have no NaN.
    means = values.mean(axis=1)
    return np.asarray(np.nanmean(values, axis=1) if np.isnan(means).any() else means)


def shared_fitness(payoff: FloatArray) -> FloatArray:
    """Return competitive fitness sharing (n,) of payoffs (n, m): Rosin & Belew 1997.

    An opponent is worth 1 in total, shared by those that beat it; NaN where it was not met. By
    n / m times: a population that beats every opponent has a mean of 1, whatever its size.
    """
    n, m = len(payoff), np.count_nonzero(~np.isnan(payoff).all(axis=0))
    wins = np.nan_to_num(payoff)
    # An opponent that no individual beats is worth nothing, and would divide by zero.
    beaten = wins[:, wins.sum(axis=0) > 0.0]
    shares: FloatArray = (beaten / beaten.sum(axis=0)).sum(axis=1)
    return shares * (n / m)
