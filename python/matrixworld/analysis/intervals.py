"""Intervals: over training runs, over the episodes of one run, and of collision rates.

Student's t (means, curves, linear measures), Welch's t (differences of runs), Gaffke's (scores in
[0, 1]) and the bootstrap-t of a rate.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_bool, check_floats, check_integer, check_real, shown
from matrixworld._util.readable import Parts, Readable
from matrixworld.analysis.payoffs import Rates, check_finite, check_rates, require
from matrixworld.analysis.reasons import NOTHING, Reason, Why

LEVEL = 0.95  # default confidence level: share of intervals that should contain the true value
FEW_RUNS = 5
"""With fewer runs an interval is wide, since the variation between runs is hardly known."""
RUNS_FOR_T = 4  # fewest runs of which a judgement takes the mean: of fewer, one run decides
DRAWS = 10_000
"""Draws of weights for an interval of a mean; the ends vary by about 1 % of the width."""
EPISODES_FOR_RATES = 20
"""Fewest episodes for the interval of a collision rate; with less, uneven rates are covered too
rarely."""
COLLIDING_FOR_RATES = 5  # fewest episodes with a collision of the kind for an interval of its rate
RESAMPLES_OF_RATES = 1000
RESAMPLES = 2000
"""Bootstrap samples of an interquartile mean; the ends of the interval then vary by some percent of
its width."""
TRIMMED = 0.25  # share of the scores that an interquartile mean leaves out at each end
Bounds = tuple[float, float]  # smallest and largest possible value
UNBOUNDED: Bounds = (-math.inf, math.inf)
UNIT: Bounds = (0.0, 1.0)


@dataclass(frozen=True)
class Estimate(Readable):
    """A number with its interval, if there is one.

    The `value` is NaN if it is not defined; the ends `low` and `high` are None without an interval.
    What varies in it (`across`) is ``"runs"``, ``"episodes"`` or ``"nothing"``; there are so many
    `samples`, runs or episodes of each cell, 0 if unknown. A `note` says why there is no interval,
    or what to know about it. `biased_low` and `biased_high` are not too high and not too low on
    average, where the number has a bias of unknown size; intervals over runs rest on them.
    """

    value: float
    low: float | None = None
    high: float | None = None
    across: str = "nothing"
    samples: int = 0
    note: Reason = NOTHING
    biased_low: float | None = None
    biased_high: float | None = None

    def _parts(self) -> Parts:
        return [format(self)]

    def __float__(self) -> float:
        return self.value

    def __format__(self, form: str) -> str:
        """Return number and interval, each in a form as in an f-string; ".3f" by default."""
        ends = (self.value, self.low, self.high)
        # Adding 0.0 turns -0.0 into 0.0.
        shown = [format(round(x, 3) + 0.0, form or ".3f") for x in ends if x is not None]
        return f"{shown[0]} ({shown[1]} to {shown[2]})" if len(shown) == 3 else shown[0]

    @property
    def ends(self) -> tuple[float, float]:
        """Ends of the interval; ValueError if there is none."""
        if self.low is None or self.high is None:
            raise ValueError(f"expected an estimate with an interval, got {self}: {self.note}")
        return self.low, self.high

    def clipped(self, bounds: Bounds) -> Estimate:
        """Return the estimate with value and ends inside bounds, if it has an interval."""
        if self.low is None or self.high is None:
            return self
        least, most = bounds
        value, low, high = (min(max(number, least), most) for number in (self.value, *self.ends))
        return replace(self, value=value, low=low, high=high)

    @property
    def sign(self) -> int:
        """1 if the whole interval is above 0, -1 if it is below, 0 if neither can be told."""
        return 0 if self.low is None else int(self.ends[0] > 0.0) - int(self.ends[1] < 0.0)


@dataclass(frozen=True, eq=False, repr=False)
class Band(Readable):
    """A mean curve with its pointwise interval; all of shape (k,).

    `places`: where the points lie, such as generations. `low` and `high` are NaN where there is no
    interval, and None for a single run.
    """

    places: NDArray[Any]
    mean: Rates
    low: Rates | None
    high: Rates | None


def interval_over_runs(
    values: ArrayLike, *, level: float = LEVEL, bounds: Bounds = UNBOUNDED
) -> Estimate:
    """Return the mean over training runs with Student's t interval.

    Parameters
    ----------
    values : array_like, shape (runs,)
        One finite number for each independent run, which episodes or generations do not replace.
    level : float, optional
        Level of the interval, in (0, 1). The default is 0.95.
    bounds : tuple of float, optional
        Smallest and largest possible value, to which the interval is clipped.

    Returns
    -------
    Estimate
        A single run has no interval, and runs with equal values have none either: they do not show
        how much runs vary. The coverage is exact for normal values; evolution/results/coverage has
        it for others.
    """
    array = _check_values(values)
    check_level(level)
    _check_bounds(bounds)
    mean, runs = float(array.mean()), len(array)
    missing = _no_variation(array)
    if missing:
        return Estimate(mean, samples=runs, note=missing)
    low, high = t_ends(array, level, bounds)
    return Estimate(mean, low, high, "runs", runs, few_runs(runs))


def difference_of_runs(
    one: ArrayLike,
    other: ArrayLike,
    *,
    paired: bool = False,
    level: float = LEVEL,
    bounds: Bounds = UNBOUNDED,
) -> Estimate:
    """Return the difference between the means of two groups of runs with a t interval.

    Parameters
    ----------
    one, other : array_like, shapes (runs,)
        A finite number for each run. Groups are independent, and their variances may differ
        (Welch 1947).
    paired : bool, optional
        Whether entry i of both belongs together, for example through the same seed. The default
        is False.
    level, bounds : optional
        As for `interval_over_runs`.

    Returns
    -------
    Estimate
        `one` minus `other`; without an interval if a group has a single run, or neither varies.
    """
    first = _check_values(one)
    second = _check_values(other)
    check_level(level)
    _check_bounds(bounds)
    if check_bool("paired", paired):
        require(len(first) == len(second), f"{len(first)} paired runs", len(second))
        return interval_over_runs(first - second, level=level, bounds=bounds)
    difference = float(first.mean() - second.mean())
    fewest = min(len(first), len(second))
    missing = _no_variation(first if len(first) == fewest else second)
    # Groups of equal values have an interval if the other group varies.
    if missing and (fewest == 1 or (_no_variation(first) and _no_variation(second))):
        return Estimate(difference, samples=fewest, note=missing)
    parts = [float(group.var(ddof=1)) / len(group) for group in (first, second)]
    freedom = sum(parts) ** 2 / sum(
        part**2 / (len(group) - 1) for part, group in zip(parts, (first, second), strict=True)
    )
    half = float(t_quantile(level, freedom)) * math.sqrt(sum(parts))
    low = max(difference - half, bounds[0])
    high = min(difference + half, bounds[1])
    return Estimate(difference, low, high, "runs", fewest, few_runs(fewest))


def band_over_runs(
    curves: ArrayLike,
    *,
    places: ArrayLike | None = None,
    level: float = LEVEL,
    bounds: Bounds = UNBOUNDED,
) -> Band:
    """Return the mean curve over training runs with Student's t interval at each point, or NaN.

    `curves` (runs, k) are NaN where a run has no value; every point needs a run. The points lie at
    `places` (k,), by default 0, 1, ... `level` and `bounds` are as for `interval_over_runs`, at
    each point: a whole curve leaves the band more often.
    """
    array = check_finite(curves, "curves (runs, k)", ndim=2, gaps=True)
    known = ~np.isnan(array)
    counts = known.sum(axis=0)
    require(bool(counts.all()), "a run with a value at each point", "points without one")
    check_level(level)
    _check_bounds(bounds)
    at = np.arange(array.shape[1])
    if places is not None:
        shape = check_floats("places", places).shape
        require(shape == counts.shape, f"places of shape {counts.shape}", shape)
        at = np.asarray(places)
    mean = np.nansum(array, axis=0) / counts
    if len(array) == 1:
        return Band(at, mean, None, None)
    squares = (np.where(known, array - mean, 0.0) ** 2).sum(axis=0)
    # Single runs and equal ones say nothing about others; equal but for rounding, too.
    freedom = np.where(squares > 1e-24 * counts * np.maximum(1.0, mean**2), counts - 1.0, np.nan)
    half = t_quantile(level, freedom) * np.sqrt(squares / freedom / counts)
    return Band(at, mean, np.maximum(mean - half, bounds[0]), np.minimum(mean + half, bounds[1]))


def around(singles: Sequence[Estimate]) -> Estimate:
    """Return the mean of runs with the interval that contains the intervals of all of them."""
    low = min(single.ends[0] for single in singles)
    high = max(single.ends[1] for single in singles)
    return Estimate(float(np.mean([single.value for single in singles])), low, high, "runs")


# ---- Scores of several runs ---------------------------------------------------------------------


def fewest_runs(level: float = LEVEL) -> int:
    """Return the fewest runs with which intervals of scores are given: 6 at a level of 95 %."""
    check_level(level)
    # All n runs lie on the same side of the median with probability ``2 ** (1 - n)``, so a
    # bootstrap interval of fewer runs cannot reach the level, whatever its method.
    return max(2, math.ceil(1.0 - math.log2(1.0 - level)))


def interquartile_mean(scores: ArrayLike, *, level: float = LEVEL, seed: int = 0) -> Estimate:
    """Return the mean of the middle half of scores, with a bootstrap interval.

    Single runs that fail and single opponents that are easy count less than in the mean.

    Parameters
    ----------
    scores : array_like, shape (runs, opponents)
        Finite scores.
    level : float, optional
        Level of the interval, in (0, 1). The default is 0.95.
    seed : int, optional
        Seed of the bootstrap samples. The default is 0.

    Returns
    -------
    Estimate
        Without an interval below 6 runs (at 95 %), and if all runs are equal.

    Notes
    -----
    Whole runs are resampled, because scores of one run against several opponents depend on each
    other. The interval is an expanded percentile interval (Hesterberg), since plain percentiles are
    too narrow for few runs.

    References
    ----------
    Agarwal et al. (2021), "Deep reinforcement learning at the edge of the statistical precipice",
    NeurIPS. Hesterberg (2015), "What teachers should know about the bootstrap", The American
    Statistician 69(4).
    """
    array = check_finite(scores, "scores (runs, opponents)", ndim=2)
    value = _middle_mean(array)
    runs = len(array)
    fewest = fewest_runs(level)
    if runs < fewest:
        return Estimate(value, samples=runs, note=Reason(Why.TOO_FEW_RUNS, fewest))
    if np.ptp(array, axis=0).max() == 0.0:
        return Estimate(value, samples=runs, note=Reason(Why.EQUAL_RUNS, runs))
    rng = np.random.default_rng(check_integer("seed", seed, 0))
    drawn = [_middle_mean(array[rng.integers(runs, size=runs)]) for _ in range(RESAMPLES)]
    tail = expanded_tail(runs, level)
    low, high = np.quantile(drawn, [tail, 1.0 - tail])
    return Estimate(value, float(low), float(high), "runs", runs)


def expanded_tail(runs: int, level: float) -> float:
    """Return the probability below the lower end of an expanded percentile interval."""
    from scipy.special import ndtr

    return float(ndtr(-math.sqrt(runs / (runs - 1)) * float(t_quantile(level, runs - 1))))


def _middle_mean(scores: Rates) -> float:
    ordered = np.sort(scores, axis=None)
    cut = int(TRIMMED * len(ordered))
    return float(ordered[cut : len(ordered) - cut].mean())


# ---- Over the episodes of one run ---------------------------------------------------------------


def mean_over_episodes(scores: ArrayLike, *, level: float = LEVEL) -> Estimate:
    """Return the mean of scores in [0, 1] with an interval that needs no other assumption.

    Parameters
    ----------
    scores : array_like, shape (episodes,)
        Scores in [0, 1] of at least two independent episodes.
    level : float, optional
        Level of the interval, in (0, 1). The default is 0.95.

    Returns
    -------
    Estimate
        The mean with its interval, which has a width even if all episodes are equal.

    Notes
    -----
    The upper end is a quantile of the weighted mean of the scores and one further score of 1, with
    weights that are uniform on the simplex; the lower end adds a 0. For win or loss this is the
    interval of Clopper and Pearson (1934).

    References
    ----------
    Gaffke (2005), "Three test statistics for a nonparametric one-sided hypothesis on the mean of a
    nonnegative variable". Learned-Miller and Thomas (2020), "A new confidence interval for the mean
    of a bounded random variable".
    """
    array = _check_scores(scores, level)
    low, high = _ends_of_mean(array, level)
    return Estimate(float(array.mean()), low, high, "episodes", len(array))


def difference_over_episodes(one: ArrayLike, other: ArrayLike, *, level: float = LEVEL) -> Estimate:
    """Return the difference of two means of scores in [0, 1] with an interval over episodes.

    Squared distances from the ends of both own intervals are added (Newcombe 1998).
    """
    first = mean_over_episodes(one, level=level)
    second = mean_over_episodes(other, level=level)
    (first_low, first_high), (second_low, second_high) = first.ends, second.ends
    difference = first.value - second.value
    low = difference - math.hypot(first.value - first_low, second_high - second.value)
    high = difference + math.hypot(first_high - first.value, second.value - second_low)
    fewest = min(first.samples, second.samples)
    return Estimate(difference, max(low, -1.0), min(high, 1.0), "episodes", fewest)


def linear_over_episodes(
    scores: ArrayLike,
    measure: Callable[[Rates], float],
    *,
    level: float = LEVEL,
    bounds: Bounds = UNBOUNDED,
) -> Estimate:
    """Return a sum of cells of the payoff matrix with a t interval over episodes (n, m, episodes).

    Episode e of all cells, which may share its seed, is one measurement of the whole matrix.
    """
    array = check_cells(scores, level)
    episodes = array.shape[2]
    value = float(measure(array.mean(axis=2)))
    if math.isnan(value):
        return Estimate(value, samples=episodes, note=Reason(Why.NOT_OF_THIS_MATRIX))
    values = np.array([measure(array[:, :, e]) for e in range(episodes)])
    if does_not_vary(values):
        return Estimate(value, samples=episodes, note=Reason(Why.EQUAL_EPISODES))
    low, high = t_ends(values, level, bounds)
    return Estimate(value, low, high, "episodes", episodes)


def generalization_over_episodes(scores: ArrayLike) -> tuple[Band, Band]:
    """Return `generalization` of both teams with t intervals over episodes (n, m, episodes)."""
    array = check_cells(scores, LEVEL)
    return mean_over_opponents(array), mean_over_opponents(1.0 - array.swapaxes(0, 1))


def mean_over_opponents(scores: Rates) -> Band:
    """Return the means of the rows of (n, m, episodes), with t intervals over the episodes."""
    return band_over_runs(scores.mean(axis=1).T, bounds=UNIT)


def _ends_of_mean(scores: Rates, level: float) -> tuple[float, float]:
    values, counts = np.unique(scores, return_counts=True)
    # Weights of equal scores add up: a gamma variable for each value instead of each episode.
    generator = np.random.default_rng(0)
    drawn: Any = generator.standard_gamma(counts, (DRAWS, len(counts)))
    extra = generator.standard_exponential(DRAWS)
    known, total = drawn @ values, drawn.sum(axis=1) + extra
    # The further score is 0 for the lower end and 1 for the upper end.
    low = np.quantile(known / total, (1.0 - level) / 2.0)
    high = np.quantile((known + extra) / total, (1.0 + level) / 2.0)
    return float(low), float(high)


def _check_scores(scores: ArrayLike, level: float) -> Rates:
    array = check_rates(scores, ndim=1, what="scores of episodes")
    check_level(level)
    require(len(array) >= 2, "at least 2 episodes", len(array))
    return array


def check_cells(scores: ArrayLike, level: float) -> Rates:
    """Return scores (n, m, episodes) of at least two episodes, or raise a ValueError."""
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    check_level(level)
    require(array.shape[2] >= 2, "at least 2 episodes a cell", array.shape[2])
    return array


# ---- Of collision rates -------------------------------------------------------------------------


def rate_intervals(
    counts: NDArray[np.int64], agent_steps: NDArray[np.int64], seed: int = 0
) -> NDArray[np.float64]:
    """Return bootstrap-t intervals (..., 2, 3, 2) of rates per 1000 agent-steps (Hall 1988).

    Counts are (episodes, ..., 2, 3), agent-steps in collision by team and kind; agent-steps are
    (episodes, 2). NaN with too few episodes, or too few with a collision.
    """
    # Each resample of episodes gives the distance of its rate from the rate of all in standard
    # errors of a ratio; its quantiles replace those of Student's t: counts are skewed.
    n, rng = len(counts), np.random.default_rng(seed)
    c: NDArray[Any] = counts.reshape(n, -1).astype(float)
    colliding = (c > 0).sum(axis=0)
    # Agent-steps lack the other axes and the kinds: a length of 1 there.
    by_team = agent_steps.reshape(n, *(1,) * (counts.ndim - 3), 2, 1).astype(float)
    s = np.broadcast_to(by_team, counts.shape).reshape(n, -1)
    data = np.concatenate([c, s, c * c, c * s, s * s], axis=1)
    draws = (np.bincount(rng.integers(n, size=n), minlength=n) for _ in range(RESAMPLES_OF_RATES))
    # One draw is how often each episode occurs in a resample: a product sums the whole resample.
    sums = np.stack([data.sum(axis=0), *(times @ data for times in draws)])
    c, s, cc, cs, ss = np.moveaxis(sums.reshape(len(sums), 5, -1), 1, 0)
    s = np.maximum(s, 1.0)  # a team without agent-steps has no collisions either
    rates = c / s  # of the data in row 0, and of the resamples
    errors = np.sqrt(np.maximum(cc - 2 * rates * cs + rates**2 * ss, 0.0)) / s  # but for a factor
    with np.errstate(divide="ignore", invalid="ignore"):
        # A resample of equal episodes is infinitely many standard errors away, if it differs.
        t = (rates[1:] - rates[0]) / errors[1:]
        t[np.isnan(t)] = 0.0
        # Without interpolation, which has no result between two infinities.
        tails = (1 + LEVEL) / 2, (1 - LEVEL) / 2
        ends = rates[0] - np.quantile(t, tails, axis=0, method="nearest") * errors[0]
    ends = np.clip(ends, 0.0, 1.0)
    ends[:, (colliding < COLLIDING_FOR_RATES) | (n < EPISODES_FOR_RATES)] = np.nan
    return np.asarray(1000 * ends.T.reshape(*counts.shape[1:], 2))


# ---- Parts of intervals --------------------------------------------------------------------------


def t_quantile(level: float, freedom: float | Rates) -> Rates:
    """Return half the width of two-sided t intervals in standard errors; NaN stays NaN."""
    from scipy.special import stdtrit

    return np.asarray(stdtrit(freedom, (1.0 + level) / 2.0), dtype=np.float64)


def normal_quantile(level: float) -> float:
    """Return half the width of a two-sided normal interval in standard errors."""
    from scipy.special import ndtri

    return float(ndtri((1.0 + level) / 2.0))


def level_of_each(count: int) -> float:
    """Return the level of each of so many intervals that hold together at `LEVEL` (Bonferroni)."""
    return 1.0 - (1.0 - LEVEL) / count


def t_ends(values: ArrayLike, level: float, bounds: Bounds = UNBOUNDED) -> tuple[float, float]:
    """Return the ends of the t interval of a mean, clipped to the bounds."""
    array = np.asarray(values, dtype=np.float64)
    error = float(np.std(array, ddof=1)) / math.sqrt(len(array))
    half = float(t_quantile(level, len(array) - 1)) * error
    mean = float(array.mean())
    return max(mean - half, bounds[0]), min(mean + half, bounds[1])


def prediction_reach(values: ArrayLike, level: float) -> float:
    """Return how far one more value may lie from the mean of some, in an interval of a level.

    Values are independent and normal (Whitmore 1986, "Prediction limits for a univariate normal
    observation", The American Statistician 40).
    """
    array = np.asarray(values, dtype=np.float64)
    n = len(array)
    return float(t_quantile(level, n - 1) * np.std(array, ddof=1) * math.sqrt(1.0 + 1.0 / n))


def does_not_vary(values: Rates) -> bool:
    """Return whether values are equal but for rounding, so that no interval follows from them."""
    return float(np.ptp(values)) <= 1e-12 * max(1.0, float(np.abs(values).max()))


def check_level(level: float) -> None:
    """Raise a ValueError unless the level lies in (0, 1)."""
    require(0.0 < check_real("level", level) < 1.0, "a level in (0, 1)", level)


def _check_bounds(bounds: Bounds) -> None:
    ends = check_floats("bounds", bounds)
    require(ends.shape == (2,) and ends[0] <= ends[1], "bounds (low, high)", shown(bounds))


def few_runs(runs: int) -> Reason:
    """Return what to know about the interval of few runs; nothing for others."""
    return Reason(Why.FEW_RUNS, runs) if runs < FEW_RUNS else NOTHING


def _no_variation(values: Rates) -> Reason:
    """Return why values say nothing about the variation between runs; nothing if they do."""
    if len(values) == 1:
        return Reason(Why.SINGLE_RUN)
    if does_not_vary(values):
        return Reason(Why.EQUAL_RUNS, len(values))
    return NOTHING


def _check_values(values: ArrayLike) -> Rates:
    return check_finite(values, "values of runs", ndim=1)
