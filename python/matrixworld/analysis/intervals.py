"""Intervals over training runs: Student's t for means, differences and curves."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.payoff import Rates, require

LEVEL = 0.95
"""Default confidence level: share of intervals that should contain the true value."""
FEW_RUNS = 5
"""With fewer runs an interval is wide, since the variation between runs is hardly known."""
SINGLE_RUN = "a single run has no interval over runs"
Bounds = tuple[float, float]
"""Smallest and largest possible value."""
UNBOUNDED: Bounds = (-math.inf, math.inf)


@dataclass(frozen=True)
class Estimate:
    """A number with its interval, if there is one.

    Parameters
    ----------
    value : float
        The number; NaN if it is not defined.
    low : float or None
        Lower end of the interval; None without an interval.
    high : float or None
        Upper end of the interval; None without an interval.
    over : str
        What varies in the interval: ``"runs"``, ``"episodes"`` or ``"nothing"``.
    samples : int
        Number of runs, or number of episodes of each cell.
    note : str, optional
        Why there is no interval, or what to know about it.
    """

    value: float
    low: float | None
    high: float | None
    over: str
    samples: int
    note: str = ""

    def __str__(self) -> str:
        if self.low is None or self.high is None:
            return _rounded(self.value)
        return f"{_rounded(self.value)} ({_rounded(self.low)} to {_rounded(self.high)})"


@dataclass(frozen=True, eq=False)
class Band:
    """A mean curve with its pointwise interval over runs.

    Parameters
    ----------
    mean : ndarray of float64, shape (k,)
        Mean over runs.
    low : ndarray of float64, shape (k,), or None
        Lower ends; None for a single run.
    high : ndarray of float64, shape (k,), or None
        Upper ends; None for a single run.
    runs : ndarray of int64, shape (k,), or None
        Number of runs behind each point; None for a band over episodes.
    """

    mean: Rates
    low: Rates | None
    high: Rates | None
    runs: NDArray[np.int64] | None = None

    __repr__ = short_repr


def interval_over_runs(
    values: ArrayLike, *, level: float = LEVEL, bounds: Bounds = UNBOUNDED
) -> Estimate:
    """Return the mean over training runs with Student's t interval.

    Parameters
    ----------
    values : array_like of float, shape (runs,)
        One finite number for each independent run. Episodes or generations of one run do not
        replace runs, because a method that is tried again gives another run.
    level : float, optional
        Confidence level, in (0, 1).
    bounds : tuple of float, optional
        Smallest and largest possible value; the interval is clipped to them.

    Returns
    -------
    Estimate
        The mean with its interval. A single run has no interval, and runs with equal values have
        none either: they do not show how much runs vary.

    Raises
    ------
    ValueError
        If the shape is another one, values are not finite, or the level is outside (0, 1).

    Notes
    -----
    ``mean +- t s / sqrt(runs)`` with the t quantile of ``runs - 1`` degrees of freedom. The
    coverage is exact for normal values; evolution/results/coverage has it for others.

    References
    ----------
    Student (1908), "The probable error of a mean".
    """
    array = check_values(values, "values of runs")
    check_level(level)
    mean, runs = float(array.mean()), len(array)
    missing = _no_variation(array)
    if missing:
        return without_interval(mean, runs, missing)
    return Estimate(mean, *t_ends(array, level, bounds), "runs", runs, few_runs(runs))


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
    one : array_like of float, shape (runs,)
        One finite number for each run of the first group.
    other : array_like of float, shape (other_runs,)
        One finite number for each run of the second group.
    paired : bool, optional
        Whether entry i of both groups belongs together, for example through the same seed. The
        default is independent groups, whose variances may differ (Welch).
    level : float, optional
        Confidence level, in (0, 1).
    bounds : tuple of float, optional
        Smallest and largest possible difference; the interval is clipped to them.

    Returns
    -------
    Estimate
        Mean of `one` minus mean of `other`. There is no interval if a group has a single run, or if
        neither group varies.

    Raises
    ------
    ValueError
        As `interval_over_runs`, and if paired groups do not have the same length.

    References
    ----------
    Welch (1947), "The generalization of 'Student's' problem when several different population
    variances are involved".
    """
    first, second = (check_values(each, "values of runs") for each in (one, other))
    check_level(level)
    if paired:
        require(len(first) == len(second), f"{len(first)} paired runs", len(second))
        return interval_over_runs(first - second, level=level, bounds=bounds)
    difference, fewest = float(first.mean() - second.mean()), min(len(first), len(second))
    missing = _no_variation(first if len(first) == fewest else second)
    # Groups of equal values have an interval if the other group varies.
    if missing and (fewest == 1 or (_no_variation(first) and _no_variation(second))):
        return without_interval(difference, fewest, missing)
    parts = [float(each.var(ddof=1)) / len(each) for each in (first, second)]
    freedom = sum(parts) ** 2 / sum(
        part**2 / (len(each) - 1) for part, each in zip(parts, (first, second), strict=True)
    )
    half = t_quantile(level, freedom) * math.sqrt(sum(parts))
    ends = _clipped(difference, half, bounds)
    return Estimate(difference, *ends, "runs", fewest, few_runs(fewest))


def band_over_runs(curves: ArrayLike, *, level: float = LEVEL, bounds: Bounds = UNBOUNDED) -> Band:
    """Return the mean curve over training runs with Student's t interval at each point.

    Parameters
    ----------
    curves : array_like of float, shape (runs, k)
        One curve for each run; NaN where a run has no value. Every point needs a run.
    level : float, optional
        Confidence level of each point, in (0, 1). A whole curve leaves the band more often.
    bounds : tuple of float, optional
        Smallest and largest possible value; the band is clipped to them.

    Returns
    -------
    Band
        The mean curve over the runs that have a value, and its interval if there are several runs:
        NaN at points of a single run. Where all runs are equal, the band has no width, which is no
        certainty.

    Raises
    ------
    ValueError
        If the shape is another one, a point has no run, values are infinite, or the level is
        outside (0, 1).
    """
    array = np.asarray(curves, dtype=np.float64)
    require(array.ndim == 2 and array.size > 0, "curves of shape (runs, k)", array.shape)
    require(not np.isinf(array).any(), "finite curves", "infinite values")
    known = ~np.isnan(array)
    counts = known.sum(axis=0)
    require(bool(counts.all()), "a run with a value at each point", "points without one")
    check_level(level)
    mean = np.nansum(array, axis=0) / counts
    if len(array) == 1:
        return Band(mean, None, None, counts)
    squares = np.where(known, array - mean, 0.0) ** 2
    # No interval where a single run is left: there is nothing to divide by.
    freedom = np.where(counts > 1, counts - 1.0, np.nan)
    half = t_quantiles(level, freedom) * np.sqrt(squares.sum(axis=0) / freedom / counts)
    ends = np.maximum(mean - half, bounds[0]), np.minimum(mean + half, bounds[1])
    return Band(mean, *ends, counts)


def t_quantiles(level: float, freedom: Rates) -> Rates:
    """Return half the width of two-sided t intervals in standard errors; NaN stays NaN."""
    from scipy.special import stdtrit

    return np.asarray(stdtrit(freedom, (1.0 + level) / 2.0), dtype=np.float64)


def t_quantile(level: float, freedom: float) -> float:
    """Return half the width of a two-sided t interval in standard errors."""
    return float(t_quantiles(level, np.asarray(freedom)))


def t_ends(values: Rates, level: float, bounds: Bounds) -> tuple[float, float]:
    """Return the ends of the t interval of a mean, clipped to the bounds."""
    half = t_quantile(level, len(values) - 1) * float(values.std(ddof=1)) / math.sqrt(len(values))
    return _clipped(float(values.mean()), half, bounds)


def does_not_vary(values: Rates) -> bool:
    """Return whether values are equal but for rounding, so that no interval follows from them."""
    return float(np.ptp(values)) <= 1e-12 * max(1.0, float(np.abs(values).max()))


def without_interval(value: float, samples: int, note: str) -> Estimate:
    """Return an estimate that has no interval, with the reason."""
    return Estimate(value, None, None, "nothing", samples, note)


def check_values(values: ArrayLike, what: str) -> Rates:
    """Return finite values, shape (k,), as float64, or raise a ValueError."""
    array = np.asarray(values, dtype=np.float64)
    require(array.ndim == 1 and array.size > 0, f"{what} of shape (k,), k >= 1", array.shape)
    bad = array[~np.isfinite(array)]
    require(not len(bad), f"finite {what}", bad[:1])
    return array


def check_level(level: float) -> None:
    """Raise a ValueError unless the level lies in (0, 1)."""
    require(0.0 < level < 1.0, "a level in (0, 1)", level)


def _no_variation(values: Rates) -> str:
    """Return why values say nothing about the variation between runs; empty if they do."""
    if len(values) == 1:
        return SINGLE_RUN
    return f"no interval: all {len(values)} runs are equal" if does_not_vary(values) else ""


def few_runs(runs: int) -> str:
    """Return what to know about the interval of few runs; empty for others."""
    return f"{runs} runs only: the interval is wide" if runs < FEW_RUNS else ""


def _clipped(value: float, half: float, bounds: Bounds) -> tuple[float, float]:
    return max(value - half, bounds[0]), min(value + half, bounds[1])


def _rounded(value: float) -> str:
    return f"{round(value, 3) + 0.0:.3f}"  # adding 0.0 turns -0.0 into 0.0
