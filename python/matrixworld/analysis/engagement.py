"""Disengagement: one team wins nearly all matches, so neither team gets a signal to learn from.

It is measured over generations, by which team wins both team phases.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.payoffs import Rates, check_rates, require

PURSUERS_WIN, EVADERS_WIN = 0.97, 0.03
"""Capture rates above which the pursuers, and below which the evaders have won; races with too few
evader epochs reach the first."""
PATIENCE = 3
"""Fewest generations in a row that count: many normal races have one one-sided generation."""


@dataclass(frozen=True)
class Disengagement:
    """Generations `first` to `last`, included, in which the `winner` won both team phases.

    The winner is ``"pursuers"`` or ``"evaders"``.
    """

    winner: str
    first: int
    last: int

    def __len__(self) -> int:
        return self.last - self.first + 1

    def __str__(self) -> str:
        loser = "evaders" if self.winner == "pursuers" else "pursuers"
        return (
            f"generations {self.first} to {self.last}: the {self.winner} win nearly all matches, "
            f"so neither team has much to learn from; give the {loser} more epochs"
        )


def disengagements(rates: ArrayLike) -> tuple[Disengagement, ...]:
    """Find the longest stretches of generations in which one team wins both team phases.

    They come in order; the last one has not ended if its `last` is the newest generation.

    Parameters
    ----------
    rates : array_like of float, shape (K, 2)
        Capture rate after the pursuers' and after the evaders' team phase of generations 1, 2, ...
        A matrix gives them by `team_phase_rates`, a training log during the race. K may be 0,
        before the first generation.

    Notes
    -----
    Pursuers win a team phase with a capture rate above .97, evaders with one below .03. A stretch
    has at least 3 generations.
    """
    # Both team phases have to be one-sided: a team that only wins after its own turn is in a race.
    winners = (
        "pursuers" if min(pair) > PURSUERS_WIN else "evaders" if max(pair) < EVADERS_WIN else None
        for pair in _check_team_phases(rates).tolist()
    )
    found, first = [], 1
    # Groups of equal winners; None, a contested generation, ends a stretch.
    for winner, group in groupby(winners):
        after = first + len(list(group))
        if winner is not None and after - first >= PATIENCE:
            found.append(Disengagement(winner, first, after - 1))
        first = after
    return tuple(found)


def one_sidedness(rates: ArrayLike, episodes: float, *, level: float) -> Estimate:
    """Return how much of the payoff the winning team gets, where a race is most one-sided.

    The rates (K, 2) are those of both team phases, as for `disengagements`; the number of episodes
    is effective: as many wins and losses as have the variance of each rate. The number is the mean
    payoff of the winning team over consecutive generations, half of the K rounded up, for which it
    is largest; in [1/2, 1].

    The interval is that of Clopper and Pearson (1934) for the effective number of episodes (Korn
    and Graubard 1998). Each end is at the level of all stretches together (Bonferroni), so the
    choice of the stretch does not matter. The ends are `biased_low` and `biased_high`, too.
    """
    from scipy.special import betaincinv

    array = _check_team_phases(rates)
    length = -(-len(array) // 2)
    # Mean of each stretch of that length; a stretch in which evaders win is seen from their side.
    means = np.convolve(array.mean(axis=1), np.full(length, 1.0 / length), mode="valid")
    payoffs = np.maximum(means, 1.0 - means)
    matches = 2 * length * episodes
    wins, losses = payoffs * matches, (1.0 - payoffs) * matches
    tail = (1.0 - level) / 2.0 / len(payoffs)
    # At no loss the upper end is 1, where the formula divides by zero; payoffs are never 0.
    lows = betaincinv(wins, losses + 1.0, tail)
    highs = np.where(
        losses > 0.0, betaincinv(wins + 1.0, np.maximum(losses, 1e-9), 1.0 - tail), 1.0
    )
    best = int(payoffs.argmax())
    low, high = float(lows[best]), float(highs.max())
    return Estimate(float(payoffs[best]), low, high, "episodes", biased_low=low, biased_high=high)


def _check_team_phases(rates: ArrayLike) -> Rates:
    if np.shape(rates) == (0, 2):  # a race before its first generation is valid
        return np.empty((0, 2))
    array = check_rates(rates, ndim=2, what="team phase capture rates")
    require(array.shape[1] == 2, "team phase capture rates of shape (K, 2)", array.shape)
    return array
