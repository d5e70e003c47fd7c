"""How sure a number is: bootstrap intervals over training runs, and over episodes."""

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
"""Default share of intervals that should hold the true value."""
RESAMPLES = 2000
FEW_RUNS = 5
"""With fewer runs an interval is said to be too narrow: resamples repeat the same few runs."""


@dataclass(frozen=True)
class Estimate:
    """A number, and an interval if there is anything to take one from."""

    value: float
    low: float | None
    """Lower end; None without an interval."""
    high: float | None
    over: str
    """What was resampled: ``"runs"``, ``"episodes"`` or ``"nothing"``."""
    samples: int
    """Number of runs, or of episodes a cell."""
    note: str = ""
    """Why there is no interval, or why not to trust it."""

    def __str__(self) -> str:
        if self.low is None or self.high is None:
            return _rounded(self.value)
        return f"{_rounded(self.value)} ({_rounded(self.low)} to {_rounded(self.high)})"


@dataclass(frozen=True, eq=False)
class Band:
    """A curve, and its pointwise interval over runs if there are several."""

    mean: Rates
    """Shape ``(k,)``."""
    low: Rates | None
    """Shape ``(k,)``, or None for a single run."""
    high: Rates | None


def bootstrap_runs(
    values: ArrayLike,
    *,
    level: float = LEVEL,
    resamples: int = RESAMPLES,
    rng: np.random.Generator | int = 0,
) -> Estimate:
    """Mean over training runs with a BCa interval (Efron, 1987), by `scipy.stats.bootstrap`.

    ``values``, shape ``(runs,)``, finite: one number of each independent run. A run is what varies
    when a method is tried again; episodes or generations of one run are no substitute. A single run
    gets no interval, and its note says so. Where BCa is not defined (runs that agree but for one,
    say) the percentile interval is taken.

    Raises ValueError for another shape, values that are not finite, a level outside (0, 1).
    """
    array = _check_values(values, "values of runs")
    _check_settings(level, resamples)
    mean, runs = float(array.mean()), len(array)
    if runs == 1:
        return Estimate(mean, None, None, "nothing", 1, "a single run has no interval over runs")
    note = f"{runs} runs only: the interval is too narrow" if runs < FEW_RUNS else ""
    if np.ptp(array) == 0.0:
        return Estimate(mean, mean, mean, "runs", runs, note)
    low, high = _interval((array,), _mean, "BCa", level, resamples, rng)
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
    """Mean curve over training runs with percentile intervals, each point by itself.

    ``curves``, shape ``(runs, k)``, finite. Runs are drawn whole. Raises ValueError for another
    shape, values that are not finite, a level outside (0, 1).
    """
    array = np.asarray(curves, dtype=np.float64)
    require(array.ndim == 2 and array.size > 0, "curves of shape (runs, k)", array.shape)
    require(bool(np.isfinite(array).all()), "finite curves", "others")
    _check_settings(level, resamples)
    runs = len(array)
    if runs == 1:
        return Band(array[0], None, None)
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
    """Mean of ``one`` less mean of ``other`` with a percentile interval over their episodes.

    Both of shape ``(episodes,)``, finite, drawn independently. Raises ValueError for another shape
    or fewer than two episodes in either.
    """
    first, second = _check_values(one, "episodes"), _check_values(other, "episodes")
    _check_settings(level, resamples)
    fewest = min(len(first), len(second))
    require(fewest >= 2, "at least 2 episodes", fewest)
    difference = float(first.mean() - second.mean())
    if np.ptp(first) == np.ptp(second) == 0.0:
        return Estimate(difference, difference, difference, "episodes", fewest)
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
    """A measure of the payoff matrix with a basic interval over the episodes of each cell.

    ``scores``, shape ``(n, m, episodes)``: capture rates in [0, 1], at least two episodes a cell.
    ``measure`` takes a matrix ``(n, m)`` and returns a number. Each cell's episodes are drawn anew,
    with replacement, apart from the other cells'. The interval says how much *this* run's number
    owes to the luck of its episodes, and nothing about other runs.

    Basic interval (Davison and Hinkley, 1997): resampling adds the noise of the episodes a second
    time, which lowers a transitive share, and the ends are mirrored at the estimate so that they
    make up for it; a number that noise moves far lies outside its own interval then, and its note
    says so. Ends are cut to ``bounds``, the range of the measure.

    Raises ValueError for another shape, fewer than two episodes, scores outside [0, 1].
    """
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    _check_settings(level, resamples)
    episodes = array.shape[2]
    require(episodes >= 2, "at least 2 episodes a cell", episodes)
    generator = np.random.default_rng(rng)
    value = float(measure(array.mean(axis=2)))
    drawn = np.array([float(measure(_resampled(array, generator))) for _ in range(resamples)])
    known = drawn[np.isfinite(drawn)]
    if math.isnan(value) or not len(known):
        return Estimate(value, None, None, "nothing", episodes, "not defined for this matrix")
    ends = 2.0 * value - np.quantile(known, [(1.0 + level) / 2.0, (1.0 - level) / 2.0])
    low, high = np.clip(ends, *bounds).tolist()
    note = "" if low <= value <= high else "noise of the episodes moves it out of its own interval"
    return Estimate(value, low, high, "episodes", episodes, note)


def _rounded(value: float) -> str:
    return f"{round(value, 3) + 0.0:.3f}"  # no minus before a zero


def _resampled(scores: Rates, generator: np.random.Generator) -> Rates:
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
        warnings.simplefilter("ignore")  # NaN says that the method is not defined here
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
