"""Progress: against current, past and unknown opponents, and against each lag of opponents."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_floats, check_integer
from matrixworld._util.readable import Readable
from matrixworld.analysis.intervals import Estimate, check_cells
from matrixworld.analysis.payoffs import (
    ByTeam,
    Rates,
    check_payoff,
    check_rates,
    require,
    swap_teams,
)


@dataclass(frozen=True, eq=False)
class TeamProgress:
    """Payoff of one team against one kind of opponents, over its generations 0 to k - 1.

    `scores`, shape (..., k): mean payoff of each generation. `gains`, shape (..., k - 1): score of
    generations 1, 2, ... minus that of the previous generation against the same opponents.
    """

    scores: Rates
    gains: Rates

    @property
    def mean_gain(self) -> float:
        """Mean of the gains; positive for progress of this kind, NaN for a single generation."""
        return float(self.gains.mean()) if self.gains.size else float("nan")


def generalization(payoff: ArrayLike) -> ByTeam[Rates]:
    """Return the mean payoff of each generation of both teams against all opponents, in [0, 1].

    Capture rates of the pursuers, row means of `payoff` (n, m), and escape rates of the evaders.

    References
    ----------
    Floreano and Nolfi (1997), "Adaptive behavior in competing co-evolving species": the master
    tournament. Sun et al. (2023), "MatrixWorld", arXiv:2307.14854: the figure of generalization.
    """
    matrix = check_payoff(payoff)
    return ByTeam(matrix.mean(axis=1), 1.0 - matrix.mean(axis=0))


def local_progress(payoff: ArrayLike) -> ByTeam[TeamProgress]:
    """Return progress against current opponents: those of the same generation of `payoff` (n, m).

    A race that only cycles has local progress, too: each generation beats the newest opponents and
    loses to others. Gain of pursuers g: ``M[g, g] - M[g - 1, g]``, for ``g < min(n, m)``.

    References
    ----------
    Miconi (2009), "Why coevolution doesn't 'work': superiority and progress in coevolution".
    Simione and Nolfi (2021), "Long-term progress and behavior complexification in competitive
    coevolution".
    """
    # Later generations of the longer team have no opponent of their own generation.
    matrix = check_payoff(payoff)
    k = min(matrix.shape)
    return _both_teams(matrix[:k, :k], np.eye(k, dtype=bool))


def historical_progress(payoff: ArrayLike) -> ByTeam[TeamProgress]:
    """Return progress against all opponents so far: those of the same and of earlier generations.

    Gain of pursuers g: mean over ``h <= g`` of ``M[g, h] - M[g - 1, h]``; for evaders the same on
    ``1 - M.T``. Generations of the longer team in `payoff` (n, m) beyond the end of the shorter one
    play against all of its generations. Sources: as for `local_progress`.
    """
    matrix = check_payoff(payoff)
    # Square at the longer side, so that the same mask serves the matrix and the swapped one.
    return _both_teams(matrix, np.tri(max(matrix.shape)) > 0.0)


def global_progress(cross: ArrayLike) -> ByTeam[TeamProgress]:
    """Return progress against unknown opponents: all opponents of other independent runs.

    A race can make historical progress without global progress if a team learns the habits of its
    own opponents only. Scores have the shapes (runs, n) and (runs, m).

    Parameters
    ----------
    cross : array_like of float, shape (runs, runs, n, m)
        Cross tests: capture rates of the pursuers of run r against the evaders of run s. Entries
        with ``r == s`` are not used and may be NaN.
    """
    array = check_floats("cross tests", cross)
    require(
        array.ndim == 4 and array.shape[0] == array.shape[1],
        "cross tests of shape (runs, runs, n, m)",
        array.shape,
    )
    runs = len(array)
    require(runs >= 2, "cross tests between at least 2 runs", runs)
    # Opponents of the same run are no unknown opponents: the team has trained against them.
    others = ~np.eye(runs, dtype=bool)
    # Only the entries between different runs are checked; the diagonal may be NaN.
    flat = check_payoff(array[others].reshape(runs * (runs - 1), -1))
    played = np.zeros(array.shape)
    played[others] = flat.reshape(-1, *array.shape[2:])
    # Sum over the other runs (the diagonal holds 0), mean over the generations of their opponents.
    pursuers = played.sum(axis=1).mean(axis=-1) / (runs - 1)
    evaders = 1.0 - played.sum(axis=0).mean(axis=-2) / (runs - 1)
    return ByTeam(
        TeamProgress(pursuers, np.diff(pursuers, axis=-1)),
        TeamProgress(evaders, np.diff(evaders, axis=-1)),
    )


def _both_teams(matrix: Rates, opponents: NDArray[np.bool_]) -> ByTeam[TeamProgress]:
    """Return progress of both teams; ``opponents[g, h]``: generation g is scored against h."""
    return ByTeam(_progress(matrix, opponents), _progress(swap_teams(matrix), opponents))


def _progress(matrix: Rates, opponents: NDArray[np.bool_]) -> TeamProgress:
    rows, columns = matrix.shape
    met = opponents[:rows, :columns]
    weights = met / met.sum(axis=1, keepdims=True)
    scores = (weights * matrix).sum(axis=1)
    # Both generations of a difference are weighted by the opponents of the later one.
    gains = (weights[1:] * np.diff(matrix, axis=0)).sum(axis=1)
    return TeamProgress(scores, gains)


# ---- By the lag between opponents ----------------------------------------------------------------


@dataclass(frozen=True, eq=False, repr=False)
class LagProfile(Readable):
    """Mean capture rate by lag, pursuer minus evader generation, from ``-(m - 1)`` to ``n - 1``.

    `means` are those over k of ``M[k + lag, k]``; `cells` is the number of cells in each mean.
    """

    lags: NDArray[np.int64]
    means: Rates
    cells: NDArray[np.int64]

    def at(self, lag: int) -> float:
        """Return the mean at one lag, or raise ValueError if the profile does not contain it."""
        first, last = int(self.lags[0]), int(self.lags[-1])
        return float(self.means[check_integer("lag", lag, first, last) - first])


def lag_profile(payoff: ArrayLike) -> LagProfile:
    """Return the mean capture rate in `payoff` (n, m) for every lag between pursuers and evaders.

    At lag d: pursuers against evaders that are d generations older. Specialists beat the current
    opponent only, so their profile is flat with a notch at 0; that of generalists rises.
    """
    matrix = check_payoff(payoff)
    rows, columns = matrix.shape
    lags = np.arange(1 - columns, rows)
    # NumPy counts offsets above the diagonal, where evaders are newer: the sign changes.
    diagonals = [np.diagonal(matrix, offset=-d) for d in lags]
    means = np.array([diagonal.mean() for diagonal in diagonals])
    return LagProfile(lags, means, np.array([len(diagonal) for diagonal in diagonals]))


def lag_rise(matrix: Rates) -> float:
    """Return how much better later pursuers do than earlier ones, in [-1, 1].

    Lag profile at a third of the generations minus that at minus as much.
    """
    # Long enough for strength to grow by more than noise, short enough to leave many cells. Both
    # lags have the same number of cells in a square matrix, so both means are equally noisy.
    profile, lag = lag_profile(matrix), max(1, min(matrix.shape) // 3)
    return profile.at(lag) - profile.at(-lag)


def team_phase_rates(payoff: ArrayLike) -> Rates:
    """Return the capture rate after each team phase of generations 1, 2, ... in `payoff` (n, m).

    Row ``k - 1`` of the result (min(n, m) - 1, 2) holds ``M[k, k - 1]``, after the pursuers of
    generation k have learned, and ``M[k, k]``, after the evaders have learned.
    """
    matrix = check_payoff(payoff)
    # Generation 0 is untrained: no team phase precedes it.
    k = np.arange(1, min(matrix.shape))
    return np.stack([matrix[k, k - 1], matrix[k, k]], axis=1)


def swing(matrix: Rates) -> float:
    """Return how much the capture rate changes on average in the evaders' team phase.

    Generations before a quarter of them, rounded up, do not count: the first are untrained.
    """
    # Row k - 1 belongs to generation k.
    first = max(1, -(-min(matrix.shape) // 4))
    rates = team_phase_rates(matrix)[first - 1 :]
    return float(np.abs(rates[:, 0] - rates[:, 1]).mean())


# ---- Disengagement: one team wins nearly all matches, so neither team learns ---------------------

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

    Pursuers win a team phase with a capture rate above .97, evaders with one below .03. A stretch
    has at least 3 generations; the last one has not ended if its `last` is the newest generation.

    Parameters
    ----------
    rates : array_like of float, shape (K, 2)
        Capture rate after the pursuers' and after the evaders' team phase of generations 1, 2, ...
        A matrix gives them by `team_phase_rates`, a training log during the race. K may be 0,
        before the first generation.
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

    The number is the mean payoff of the winning team over consecutive generations, half of the K
    rounded up, for which it is largest, from `rates` (K, 2) as for `disengagements`. The interval
    is that of Clopper and Pearson (1934) for as many wins and losses as have the variance of each
    rate (Korn and Graubard 1998), at the level of all stretches together (Bonferroni).
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
    given = check_floats("team phase capture rates", rates)
    if given.shape == (0, 2):  # a race before its first generation is valid
        return given
    array = check_rates(given, ndim=2, what="team phase capture rates")
    require(array.shape[1] == 2, "team phase capture rates of shape (K, 2)", array.shape)
    return array


# ---- CIAO: current individuals against ancestral opponents ---------------------------------------

# Fewest pairs of cells for a correlation; with fewer it is dominated by chance.
_FEWEST_PAIRS = 6


@dataclass(frozen=True, eq=False)
class Triangle:
    """One team's half of a CIAO plot, measured by its own payoff: higher is better.

    `payoff` (n, m): of generation g against opponents of generation ``h <= g``; NaN where these are
    newer. `by_age` (n,): mean payoff by age ``g - h`` of the opponent.

    `fading`: mean payoff against the newer half of the ancestral opponents minus that against the
    older half. Positive: old opponents are forgotten. Negative: new opponents are harder.

    `stripes`: regularity with which wins and losses come back with the age of the opponent: the
    first peak of the autocorrelation along the rows after it has been negative, in [0, 1]; 0
    without one, and up to about .2 of noise. `period`: the lag of that peak.
    """

    payoff: Rates
    by_age: Rates
    fading: float
    stripes: float
    period: int | None


def ciao(payoff: ArrayLike) -> ByTeam[Triangle]:
    """Compare current individuals with ancestral opponents, in a triangle of each team.

    Stripes show intransitivity. Fading away from the diagonal, the current opponent, shows that a
    team loses to opponents that it once beat. A race in which both teams keep improving shows
    neither. Of team and opponents in `payoff` (n, m).

    References
    ----------
    Cliff and Miller (1995), "Tracking the Red Queen: measurements of adaptive progress in
    co-evolutionary simulations".
    """
    matrix = check_payoff(payoff)
    return ByTeam(_triangle(matrix), _triangle(swap_teams(matrix)))


def _triangle(matrix: Rates) -> Triangle:
    lower = np.where(np.tri(*matrix.shape) > 0.0, matrix, np.nan)
    # If the team has more generations than its opponents, some diagonals may be empty.
    diagonals = [np.diagonal(lower, offset=-age) for age in range(len(lower))]
    by_age = np.array([cells.mean() if len(cells) else np.nan for cells in diagonals])
    stripes, period = _first_peak(autocorrelation(lower))
    return Triangle(lower, by_age, _fading(lower), stripes, period)


def _fading(lower: Rates) -> float:
    """Return newer minus older half; the middle one of an odd number of opponents is left out."""
    differences = []
    for row in lower:
        known = row[~np.isnan(row)]
        half = len(known) // 2
        if half:
            differences.append(known[-half:].mean() - known[:half].mean())
    return float(np.mean(differences)) if differences else float("nan")


def autocorrelation(lower: Rates) -> Rates:
    """Return the correlation of ``M[g, h]`` with ``M[g, h - d]`` in a lower triangle, by d.

    Stripes count wherever they lie in a row. NaN where fewer than 6 pairs of cells are left.
    """
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


def _correlation(one: Rates, other: Rates) -> float:
    # NaN marks cells outside the triangle; a pair counts if both of its cells lie inside.
    both = ~(np.isnan(one) | np.isnan(other))
    x, y = one[both], other[both]
    if len(x) < _FEWEST_PAIRS or min(np.ptp(x), np.ptp(y)) < 1e-12:
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def _first_peak(correlations: Rates) -> tuple[float, int | None]:
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


# ---- Dominance tournament ------------------------------------------------------------------------

SIGNIFICANCE = 0.05
"""Default level of the one-sided test against each earlier dominant generation."""

_ROUNDING = 1e-12  # differences of mean scores below this are floating-point noise


@dataclass(frozen=True)
class Ladder:
    """The dominant generations of one team, ascending; 0 is the first.

    `p_values`: for each of them after the first, the largest one against an earlier one.
    """

    generations: tuple[int, ...]
    p_values: tuple[float, ...]

    def __len__(self) -> int:
        return len(self.generations)


def dominance_tournament(scores: ArrayLike, *, level: float = SIGNIFICANCE) -> ByTeam[Ladder]:
    """Find the generations that beat all dominant generations before them.

    A generation is dominant if its mean score against the whole archive of the other team is
    significantly higher than that of every earlier dominant generation. Generation 0 is dominant.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Capture rate of each episode; at least two independent episodes of each cell. Counts of won
        episodes are scores, too: ``np.arange(episodes) < wins[..., None]``.
    level : float, optional
        Significance level of the one-sided test, in (0, 1/2]. Among k equal generations at most
        about ``k * level`` are dominant by chance.

    References
    ----------
    Stanley and Miikkulainen (2002), "The dominance tournament method of monitoring progress in
    coevolution"; extended here to two teams. The test is Welch's t (1947) of the two mean scores,
    with the degrees of freedom of Satterthwaite (1946): the archive is fixed, episodes are random.
    """
    array = check_cells(scores, level)
    require(0.0 < level <= 0.5, "a level in (0, 0.5]", level)
    episodes = array.shape[2]
    means, variances = array.mean(axis=2), array.var(axis=2, ddof=1) / episodes
    return ByTeam(
        _ladder(means, variances, episodes - 1, level),
        _ladder(1.0 - means.T, variances.T, episodes - 1, level),
    )


def _ladder(means: Rates, variances: Rates, freedom: int, level: float) -> Ladder:
    # A score is the mean of m cells, so each cell's variance counts 1 / m^2.
    parts = variances / means.shape[1] ** 2
    # Of each generation its score, the variance of the score, and the sum over cells of squared
    # variance / degrees of freedom (Satterthwaite).
    scores = np.stack(
        [means.mean(axis=1), parts.sum(axis=1), (parts**2 / freedom).sum(axis=1)], axis=1
    )
    dominant, p_values = [0], []
    # In the order of time: a generation is compared with the dominant ones before it only.
    for generation in range(1, len(scores)):
        p = max(_p_value(scores[generation], scores[earlier]) for earlier in dominant)
        if p < level:
            dominant.append(generation)
            p_values.append(p)
    return Ladder(tuple(dominant), tuple(p_values))


def _p_value(one: Rates, other: Rates) -> float:
    """Return the p-value of the hypothesis that ``one`` scores no higher than ``other``."""
    from scipy.special import stdtr

    difference = float(one[0] - other[0])
    variance, spread = (one + other)[1:].tolist()
    if abs(difference) <= _ROUNDING or variance == 0.0:  # Welch's t is not defined
        return 0.0 if difference > _ROUNDING else 1.0
    # The squares of tiny variances are 0 in floating point.
    freedom = variance**2 / spread if spread > 0.0 else np.inf
    return float(stdtr(freedom, -difference / np.sqrt(variance)))
