"""Progress: against all opponents, by their lag and their age; and where a race is one-sided."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_floats
from matrixworld._util.readable import Readable
from matrixworld._util.teams import BOTH
from matrixworld.analysis import payoffs
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.teams import names_of


def generalization(payoff: ArrayLike) -> payoffs.ByTeam[payoffs.Rates]:
    """Return the mean payoff of each generation of both teams against all opponents, in [0, 1].

    Capture rates of the pursuers, row means of `payoff` (n, m), and escape rates of the evaders.

    Floreano and Nolfi (1997), "Adaptive behavior in competing co-evolving species": the master
    tournament. Sun et al. (2023), "MatrixWorld", arXiv:2307.14854: the figure of generalization.
    """
    matrix = payoffs.check_payoff(payoff)
    return payoffs.ByTeam(matrix.mean(axis=1), 1.0 - matrix.mean(axis=0))


@dataclass(frozen=True, eq=False, repr=False)
class LagProfile(Readable):
    """Means over k of ``M[k + lag, k]`` by lag, ``1 - m`` to ``n - 1``, of so many cells."""

    lags: NDArray[np.int64]
    means: payoffs.Rates
    cells: NDArray[np.int64]


def lag_profile(payoff: ArrayLike) -> LagProfile:
    """Return the mean capture rate in `payoff` (n, m) for every lag between pursuers and evaders.

    At lag d: pursuers against evaders that are d generations older. Specialists beat the current
    opponent only, so their profile is flat with a notch at 0; that of generalists rises.
    """
    matrix = payoffs.check_payoff(payoff)
    rows, columns = matrix.shape
    lags = np.arange(1 - columns, rows)
    # NumPy counts offsets above the diagonal, where evaders are newer: the sign changes.
    diagonals = [np.diagonal(matrix, offset=-d) for d in lags]
    means = np.array([diagonal.mean() for diagonal in diagonals])
    return LagProfile(lags, means, np.array([len(diagonal) for diagonal in diagonals]))


def lag_rise(matrix: payoffs.Rates) -> float:
    """Return the lag profile at a third of the generations minus that at minus as much."""
    # Long enough for strength to grow by more than noise, short enough to leave many cells. Both
    # lags have the same number of cells in a square matrix, so both means are equally noisy.
    lag = max(1, min(matrix.shape) // 3)
    return float(np.diagonal(matrix, -lag).mean()) - float(np.diagonal(matrix, lag).mean())


def team_phase_rates(payoff: ArrayLike) -> payoffs.Rates:
    """Return the capture rate after each team phase of generations 1, 2, ... in `payoff` (n, m).

    Row ``k - 1`` of the result (min(n, m) - 1, 2) holds ``M[k, k - 1]``, after the pursuers of
    generation k have learned, and ``M[k, k]``, after the evaders have learned.
    """
    matrix = payoffs.check_payoff(payoff)
    # Generation 0 is untrained: no team phase precedes it.
    k = np.arange(1, min(matrix.shape))
    return np.stack([matrix[k, k - 1], matrix[k, k]], axis=1)


PURSUERS_WIN = 0.97
EVADERS_WIN = 0.03
"""Capture rates above which the pursuers, and below which the evaders have won; races with too few
evader epochs reach the first."""
PATIENCE = 3
"""Fewest generations in a row that count: many normal races have one one-sided generation."""


@dataclass(frozen=True)
class Disengagement:
    """Generations `first` to `last`, included, in which the `winner` won both team phases."""

    winner: str
    first: int
    last: int

    def __len__(self) -> int:
        return self.last - self.first + 1

    def __str__(self) -> str:
        return self.in_words()

    def in_words(self, teams: tuple[str, str] = BOTH) -> str:
        """Return what happened, and what to do, in the words of a game with these teams."""
        names = names_of(teams)
        winner = names[self.winner]
        loser = names["evaders" if self.winner == "pursuers" else "pursuers"]
        return (
            f"generations {self.first} to {self.last}: the {winner} win nearly all matches, "
            f"so neither team has much to learn from; give the {loser} more epochs"
        )


def disengagements(rates: ArrayLike) -> tuple[Disengagement, ...]:
    """Find the longest stretches of generations in which one team wins both team phases.

    Pursuers win a team phase with a capture rate above .97, evaders with one below .03. The `rates`
    are those after the pursuers' and after the evaders' team phase of generations 1, 2, ..., (K,
    2), by `team_phase_rates` or from a training log. A stretch has at least 3 generations; the last
    one has not ended if its `last` is the newest generation.
    """
    # Both team phases have to be one-sided: a team that only wins after its own turn is in a race.
    winners = map(_winner, _check_team_phases(rates).tolist())
    stretches = []
    first = 1
    # Groups of equal winners; None, a contested generation, ends a stretch.
    for winner, group in groupby(winners):
        after = first + len(list(group))
        if winner is not None and after - first >= PATIENCE:
            stretches.append(Disengagement(winner, first, after - 1))
        first = after
    return tuple(stretches)


def _winner(rates: list[float]) -> str | None:
    """Return the team that won both team phases of a generation; None if neither did."""
    if min(rates) > PURSUERS_WIN:
        return "pursuers"
    if max(rates) < EVADERS_WIN:
        return "evaders"
    return None


def one_sidedness(rates: ArrayLike, episodes: float, *, level: float) -> Estimate:
    """Return the largest mean payoff of the winning team over half of the generations in a row."""
    # The interval is that of Clopper and Pearson (1934) for as many wins and losses as have the
    # variance of each rate (Korn and Graubard 1998): infinitely many if the rates are exact.
    from scipy.special import betaincinv

    array = _check_team_phases(rates)
    length = -(-len(array) // 2)
    # Mean of each stretch of that length; a stretch in which evaders win is seen from their side.
    means = np.convolve(array.mean(axis=1), np.full(length, 1.0 / length), mode="valid")
    winning = np.maximum(means, 1.0 - means)
    best = int(winning.argmax())
    if math.isinf(episodes):
        rate = float(winning[best])
        return Estimate(rate, rate, rate, "episodes", biased_low=rate, biased_high=rate)
    matches = 2 * length * episodes
    wins, losses = winning * matches, (1.0 - winning) * matches
    tail = (1.0 - level) / 2.0 / len(winning)  # of all stretches together (Bonferroni)
    # At no loss the upper end is 1, where the formula divides by zero; payoffs are never 0.
    lows = betaincinv(wins, losses + 1.0, tail)
    highs = np.where(
        losses > 0.0, betaincinv(wins + 1.0, np.maximum(losses, 1e-9), 1.0 - tail), 1.0
    )
    low, high = float(lows[best]), float(highs.max())
    return Estimate(float(winning[best]), low, high, "episodes", biased_low=low, biased_high=high)


def _check_team_phases(rates: ArrayLike) -> payoffs.Rates:
    array = check_floats("team phase capture rates", rates)
    if array.shape == (0, 2):  # a race before its first generation is valid
        return array
    array = payoffs.check_rates(array, ndim=2, what="team phase capture rates")
    payoffs.require(array.shape[1] == 2, "team phase capture rates of shape (K, 2)", array.shape)
    return array


# Fewest pairs of cells for a correlation; with fewer it is dominated by chance.
_FEWEST_PAIRS = 6


@dataclass(frozen=True, eq=False)
class Triangle:
    """One team's half of a CIAO plot: its payoffs (n, m), NaN for opponents newer than itself."""

    payoff: payoffs.Rates
    by_age: payoffs.Rates  # mean payoff (n,) by age ``g - h`` of the opponent
    fading: float
    """Against the newer half of the opponents minus the older: if positive, these are forgotten."""
    stripes: float
    """Regularity, in [0, 1], with which wins and losses come back with the age of the opponent: the
    first peak of the autocorrelation after it has been negative; up to about .2 by noise."""
    period: int | None  # lag of that peak


def ciao(payoff: ArrayLike) -> payoffs.ByTeam[Triangle]:
    """Compare current individuals with ancestral opponents, in a triangle of each team.

    Stripes show intransitivity. Fading away from the diagonal, the current opponent, shows that a
    team loses to opponents that it once beat. A race in which both teams keep improving shows
    neither. Of team and opponents in `payoff` (n, m).

    Cliff and Miller (1995), "Tracking the Red Queen: measurements of adaptive progress in
    co-evolutionary simulations".
    """
    matrix = payoffs.check_payoff(payoff)
    return payoffs.ByTeam(triangle(matrix), triangle(payoffs.swap_teams(matrix)))


def triangle(matrix: payoffs.Rates) -> Triangle:
    """Return the half of a CIAO plot of the team that has the rows of a payoff matrix."""
    lower = np.where(np.tri(*matrix.shape) > 0.0, matrix, np.nan)
    # If the team has more generations than its opponents, some diagonals may be empty.
    diagonals = [np.diagonal(lower, offset=-age) for age in range(len(lower))]
    by_age = np.array([cells.mean() if len(cells) else np.nan for cells in diagonals])
    stripes, period = _first_peak(autocorrelation(lower))
    return Triangle(lower, by_age, _fading(lower), stripes, period)


def _fading(lower: payoffs.Rates) -> float:
    """Return newer minus older half; the middle one of an odd number of opponents is left out."""
    differences = []
    for row in lower:
        known = row[~np.isnan(row)]
        half = len(known) // 2
        if half:
            differences.append(known[-half:].mean() - known[:half].mean())
    return float(np.mean(differences)) if differences else float("nan")


def autocorrelation(lower: payoffs.Rates) -> payoffs.Rates:
    """Return the correlation of ``M[g, h]`` with ``M[g, h - d]`` in a lower triangle, by d."""
    counts = np.sum(~np.isnan(lower), axis=1, keepdims=True)
    centered = lower - np.nansum(lower, axis=1, keepdims=True) / counts
    # Lags up to half of the opponents: beyond them few pairs of cells are left.
    columns = lower.shape[1]
    # Row 0 has one cell, which is 0 after centering and carries no information.
    found = [
        _correlation(centered[1:, lag:], centered[1:, : columns - lag])
        for lag in range(columns // 2)
    ]
    return np.array(found)


def _correlation(one: payoffs.Rates, other: payoffs.Rates) -> float:
    # NaN marks cells outside the triangle; a pair counts if both of its cells lie inside.
    both = ~(np.isnan(one) | np.isnan(other))
    x, y = one[both], other[both]
    if len(x) < _FEWEST_PAIRS or min(np.ptp(x), np.ptp(y)) < 1e-12:
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def _first_peak(correlations: payoffs.Rates) -> tuple[float, int | None]:
    """Return height and lag of the first positive local maximum after the first negative value."""
    # Neighbouring generations are alike, so the correlation first falls from 1 whatever happens;
    # only a rise after it has been negative shows that something comes back.
    below = np.flatnonzero(correlations < 0.0)
    start = int(below[0]) + 1 if len(below) else len(correlations)
    for lag in range(start, len(correlations) - 1):
        before, here, after = correlations[lag - 1 : lag + 2]
        if here > 0.0 and here > before and here >= after:
            return min(1.0, float(here)), lag
    return 0.0, None
