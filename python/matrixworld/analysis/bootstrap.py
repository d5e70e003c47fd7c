"""Bootstrap intervals over training runs and over episodes."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.payoff import Rates, check_rates, require

LEVEL = 0.95
"""Default confidence level: share of intervals that should contain the true value."""
RESAMPLES = 2000
"""Default number of resamples; more change the ends of 95 % intervals little."""
FEW_RUNS = 5
"""With fewer runs an interval is too narrow: resamples repeat the same few runs."""


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
        What was resampled: ``"runs"``, ``"episodes"`` or ``"nothing"``.
    samples : int
        Number of runs, or number of episodes of each cell.
    note : str, optional
        Why there is no interval, or why it is not reliable.
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
    """

    mean: Rates
    low: Rates | None
    high: Rates | None


def bootstrap_runs(
    values: ArrayLike,
    *,
    level: float = LEVEL,
    resamples: int = RESAMPLES,
    rng: np.random.Generator | int = 0,
) -> Estimate:
    """Return the mean over training runs with a bootstrap interval.

    Parameters
    ----------
    values : array_like of float, shape (runs,)
        One finite number for each independent run. Episodes or generations of one run do not
        replace runs, because a method that is tried again gives another run.
    level : float, optional
        Confidence level, in (0, 1).
    resamples : int, optional
        Number of resamples, at least 1.
    rng : numpy.random.Generator or int, optional
        Generator or seed.

    Returns
    -------
    Estimate
        The mean with a BCa interval, or with the percentile interval where BCa is not defined (for
        example if all runs but one agree). A single run has no interval.

    Raises
    ------
    ValueError
        If the shape is another one, values are not finite, or the level is outside (0, 1).

    References
    ----------
    Efron (1987), "Better bootstrap confidence intervals"; computed by `scipy.stats.bootstrap`.
    """
    array = _check_values(values, "values of runs")
    _check_settings(level, resamples)
    # A single run says nothing about the variation between runs.
    mean, runs = float(array.mean()), len(array)
    if runs == 1:
        return Estimate(mean, None, None, "nothing", 1, "a single run has no interval over runs")
    note = f"{runs} runs only: the interval is too narrow" if runs < FEW_RUNS else ""
    if np.ptp(array) == 0.0:  # equal values: both methods are undefined
        return Estimate(mean, mean, mean, "runs", runs, note)
    low, high = _interval((array,), _mean, "BCa", level, resamples, rng)
    # SciPy returns NaN where BCa is not defined.
    if math.isnan(low) or math.isnan(high):
        low, high = _interval((array,), _mean, "percentile", level, resamples, rng)
    return Estimate(mean, low, high, "runs", runs, note)


def bootstrap_band(
    curves: ArrayLike,
    *,
    level: float = LEVEL,
    resamples: int = RESAMPLES,
    rng: np.random.Generator | int = 0,
) -> Band:
    """Return the mean curve over training runs with pointwise percentile intervals.

    Parameters
    ----------
    curves : array_like of float, shape (runs, k)
        One finite curve for each run. Runs are resampled as a whole.
    level : float, optional
        Confidence level, in (0, 1).
    resamples : int, optional
        Number of resamples, at least 1.
    rng : numpy.random.Generator or int, optional
        Generator or seed.

    Returns
    -------
    Band
        The mean curve, and its interval if there are several runs.

    Raises
    ------
    ValueError
        If the shape is another one, values are not finite, or the level is outside (0, 1).
    """
    array = np.asarray(curves, dtype=np.float64)
    require(array.ndim == 2 and array.size > 0, "curves of shape (runs, k)", array.shape)
    require(bool(np.isfinite(array).all()), "finite curves", "others")
    _check_settings(level, resamples)
    runs = len(array)
    if runs == 1:
        return Band(array[0], None, None)
    # How often each run is drawn, times the curves: one product instead of a copy of all resamples.
    chosen = np.random.default_rng(rng).integers(runs, size=(resamples, runs))
    weights = np.apply_along_axis(np.bincount, 1, chosen, minlength=runs) / runs
    means = weights @ array
    low, high = np.quantile(means, [(1.0 - level) / 2.0, (1.0 + level) / 2.0], axis=0)
    return Band(array.mean(axis=0), low, high)


def bootstrap_difference(
    one: ArrayLike,
    other: ArrayLike,
    *,
    level: float = LEVEL,
    resamples: int = RESAMPLES,
    rng: np.random.Generator | int = 0,
) -> Estimate:
    """Return the difference of two means with a percentile interval over episodes.

    Parameters
    ----------
    one : array_like of float, shape (episodes,)
        Finite values of independent episodes, at least two.
    other : array_like of float, shape (other_episodes,)
        Finite values of other independent episodes, at least two.
    level : float, optional
        Confidence level, in (0, 1).
    resamples : int, optional
        Number of resamples, at least 1.
    rng : numpy.random.Generator or int, optional
        Generator or seed.

    Returns
    -------
    Estimate
        Mean of `one` minus mean of `other`.

    Raises
    ------
    ValueError
        If the shape is another one, or there are fewer than two episodes in either.
    """
    first, second = _check_values(one, "episodes"), _check_values(other, "episodes")
    _check_settings(level, resamples)
    fewest = min(len(first), len(second))
    require(fewest >= 2, "at least 2 episodes", fewest)
    difference = float(first.mean() - second.mean())
    if np.ptp(first) == np.ptp(second) == 0.0:
        return Estimate(difference, difference, difference, "episodes", fewest)
    # Percentile: means of many episodes are hardly skewed, so BCa has little to correct.
    low, high = _interval((first, second), _mean_difference, "percentile", level, resamples, rng)
    return Estimate(difference, low, high, "episodes", fewest)


def bootstrap_episodes(
    scores: ArrayLike,
    measure: Callable[[Rates], float],
    *,
    level: float = LEVEL,
    resamples: int = 200,
    bounds: tuple[float, float] = (-math.inf, math.inf),
    rng: np.random.Generator | int = 0,
) -> Estimate:
    """Return a measure of the payoff matrix with a basic interval over the episodes of each cell.

    The interval tells how well *this* run was measured, and nothing about other runs.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Capture rates of episodes, in [0, 1]; at least two episodes of each cell.
    measure : callable
        Takes a matrix (n, m) and returns a number.
    level : float, optional
        Confidence level, in (0, 1).
    resamples : int, optional
        Number of resamples, at least 1.
    bounds : tuple of float, optional
        Range of the measure; the interval is clipped to it.
    rng : numpy.random.Generator or int, optional
        Generator or seed.

    Returns
    -------
    Estimate
        The measure of the mean matrix. Its note says if it lies outside its own interval.

    Raises
    ------
    ValueError
        If the shape is another one, there are fewer than two episodes, or scores are outside
        [0, 1].

    Notes
    -----
    The episodes of each cell are resampled independently of other cells. Resampling adds the noise
    of the episodes a second time, which lowers a transitive share, for example. The basic interval
    reflects the quantiles at the estimate and so corrects this bias. A number with a large bias
    lies outside its own interval.

    References
    ----------
    Davison and Hinkley (1997), "Bootstrap methods and their application".
    """
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    _check_settings(level, resamples)
    episodes = array.shape[2]
    require(episodes >= 2, "at least 2 episodes a cell", episodes)
    generator = np.random.default_rng(rng)
    value = float(measure(array.mean(axis=2)))
    drawn = np.array([float(measure(resampled_means(array, generator))) for _ in range(resamples)])
    # A resample may be constant, where a transitive share is not defined.
    known = drawn[np.isfinite(drawn)]
    if math.isnan(value) or not len(known):
        return Estimate(value, None, None, "nothing", episodes, "not defined for this matrix")
    # The upper quantile gives the lower end: the interval is reflected at the value.
    ends = 2.0 * value - np.quantile(known, [(1.0 + level) / 2.0, (1.0 - level) / 2.0])
    low, high = np.clip(ends, *bounds).tolist()
    note = "" if low <= value <= high else "biased by episode noise: outside its own interval"
    return Estimate(value, low, high, "episodes", episodes, note)


def _rounded(value: float) -> str:
    return f"{round(value, 3) + 0.0:.3f}"  # adding 0.0 turns -0.0 into 0.0


def resampled_means(scores: Rates, generator: np.random.Generator) -> Rates:
    """Return the mean of each cell over as many of its episodes, drawn with replacement."""
    chosen = generator.integers(scores.shape[2], size=scores.shape)
    mean: Rates = np.take_along_axis(scores, chosen, axis=2).mean(axis=2)
    return mean


def _interval(
    samples: tuple[Rates, ...],
    statistic: Callable[..., Any],
    method: str,
    level: float,
    resamples: int,
    rng: np.random.Generator | int,
) -> tuple[float, float]:
    from scipy.stats import bootstrap

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # NaN ends already say that the method is not defined
        found = bootstrap(
            samples,
            statistic,
            vectorized=True,
            confidence_level=level,
            n_resamples=resamples,
            method=method,
            random_state=np.random.default_rng(rng),
        ).confidence_interval
    return float(found.low), float(found.high)


def _mean(values: NDArray[np.float64], axis: int = -1) -> Any:
    return values.mean(axis=axis)


def _mean_difference(one: NDArray[np.float64], other: NDArray[np.float64], axis: int = -1) -> Any:
    return one.mean(axis=axis) - other.mean(axis=axis)


def _check_values(values: ArrayLike, what: str) -> Rates:
    array = np.asarray(values, dtype=np.float64)
    require(array.ndim == 1 and array.size > 0, f"{what} of shape (k,), k >= 1", array.shape)
    bad = array[~np.isfinite(array)]
    require(not len(bad), f"finite {what}", bad[:1])
    return array


def _check_settings(level: float, resamples: int) -> None:
    require(0.0 < level < 1.0, "a level in (0, 1)", level)
    require(resamples >= 1, "at least 1 resample", resamples)
