"""From scores to the fitness of candidates.

A measure of the game gives a value for each match. With several opponents a candidate has several
values, which become one fitness: their mean, or competitive fitness sharing.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from matrixworld.coevolution.types import FloatArray

Table = Callable[[FloatArray], FloatArray]
"""Arranges one value of each match (M,) as a table (n, m) of individuals against opponents, with
NaN for pairs that did not play."""

# How the values of a candidate against several opponents become its fitness.
NO_SHARING = "none"
COMPETITIVE = "competitive"


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

    An opponent is worth 1 in total, shared by those that beat it; NaN where it was not met. The
    sums are multiplied by n / m, with the m opponents that were met: so a population that beats
    every opponent has a mean of 1, whatever its size.
    """
    n = len(payoff)
    m = np.count_nonzero(~np.isnan(payoff).all(axis=0))
    wins = np.nan_to_num(payoff)
    # An opponent that no individual beats is worth nothing, and would divide by zero.
    beaten = wins[:, wins.sum(axis=0) > 0.0]
    shares: FloatArray = (beaten / beaten.sum(axis=0)).sum(axis=1)
    return shares * (n / m)
