"""Intervals over the episodes of one run: how well this run was measured."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.cycles import transitive_share
from matrixworld.analysis.intervals import (
    LEVEL,
    UNBOUNDED,
    Band,
    Bounds,
    Estimate,
    band_over_runs,
    check_level,
    does_not_vary,
    t_ends,
    t_quantile,
    without_interval,
)
from matrixworld.analysis.payoff import Rates, check_rates, require

BIASED = "biased by episode noise: no interval"
"""Note of measures that noise shifts by an unknown amount, such as maxima of cells."""
FEWEST_EPISODES = 4
"""Fewest episodes for the interval of a transitive share: the jackknife leaves out one of them."""
DRAWS = 10_000
"""Draws of weights for an interval of a mean; the ends vary by about 1 % of the width."""


def mean_over_episodes(
    scores: ArrayLike, *, level: float = LEVEL, rng: np.random.Generator | int = 0
) -> Estimate:
    """Return the mean of scores in [0, 1] with an interval that needs no other assumption.

    Parameters
    ----------
    scores : array_like of float, shape (episodes,)
        Scores in [0, 1] of independent episodes, at least two.
    level : float, optional
        Confidence level, in (0, 1).
    rng : numpy.random.Generator or int, optional
        Generator or seed of the drawn weights.

    Returns
    -------
    Estimate
        The mean with its interval, which has a width even if all episodes are equal.

    Raises
    ------
    ValueError
        If the shape is another one, there are fewer than two episodes, scores are outside [0, 1],
        or the level is outside (0, 1).

    Notes
    -----
    The upper end is a quantile of the weighted mean of the scores and one further score of 1, with
    weights that are uniform on the simplex; the lower end adds a 0. For win or loss this is the
    interval of Clopper and Pearson (1934). Other scores with the same mean vary less, and their
    interval is narrower.

    References
    ----------
    Gaffke (2005), "Three test statistics for a nonparametric one-sided hypothesis on the mean of a
    nonnegative variable". Learned-Miller and Thomas (2020), "A new confidence interval for the mean
    of a bounded random variable".
    """
    array = _check_scores(scores, level)
    low, high = _ends_of_mean(array, level, rng)
    return Estimate(float(array.mean()), low, high, "episodes", len(array))


def difference_over_episodes(
    one: ArrayLike,
    other: ArrayLike,
    *,
    level: float = LEVEL,
    rng: np.random.Generator | int = 0,
) -> Estimate:
    """Return the difference of two means of scores in [0, 1] with an interval over episodes.

    Parameters
    ----------
    one : array_like of float, shape (episodes,)
        Scores in [0, 1] of independent episodes, at least two.
    other : array_like of float, shape (other_episodes,)
        Scores in [0, 1] of other independent episodes, at least two.
    level : float, optional
        Confidence level, in (0, 1).
    rng : numpy.random.Generator or int, optional
        Generator or seed of the drawn weights.

    Returns
    -------
    Estimate
        Mean of `one` minus mean of `other`.

    Raises
    ------
    ValueError
        As `mean_over_episodes`.

    Notes
    -----
    The squared distances of both means from the ends of their own intervals are added, as Newcombe
    (1998) does for shares. This keeps the asymmetry of the two intervals.

    References
    ----------
    Zou and Donner (2008), "Construction of confidence limits about effect measures: a general
    approach".
    """
    first, second = _check_scores(one, level), _check_scores(other, level)
    means = float(first.mean()), float(second.mean())
    ends = [_ends_of_mean(each, level, rng) for each in (first, second)]
    difference = means[0] - means[1]
    low = difference - math.hypot(means[0] - ends[0][0], ends[1][1] - means[1])
    high = difference + math.hypot(ends[0][1] - means[0], means[1] - ends[1][0])
    fewest = min(len(first), len(second))
    return Estimate(difference, max(low, -1.0), min(high, 1.0), "episodes", fewest)


def linear_over_episodes(
    scores: ArrayLike,
    measure: Callable[[Rates], float],
    *,
    level: float = LEVEL,
    bounds: Bounds = UNBOUNDED,
) -> Estimate:
    """Return a linear measure of the payoff matrix with a t interval over episodes.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Scores in [0, 1] of independent episodes, at least two of each cell.
    measure : callable
        Takes a matrix (n, m) and returns a weighted sum of its cells plus a constant, such as a
        mean or a difference of means.
    level : float, optional
        Confidence level, in (0, 1).
    bounds : tuple of float, optional
        Smallest and largest possible value; the interval is clipped to them.

    Returns
    -------
    Estimate
        The measure of the mean matrix. It has no interval if it is the same in each episode.

    Raises
    ------
    ValueError
        If the shape is another one, there are fewer than two episodes, scores are outside [0, 1],
        or the level is outside (0, 1).

    Notes
    -----
    Episode e of all cells is one measurement of the whole matrix, independent of other episodes.
    A linear measure of the mean matrix is the mean of the measures of these matrices, so the t
    interval of a mean applies. Cells may share the seeds of their episodes.
    """
    array = _check_cells(scores, level)
    episodes = array.shape[2]
    value = float(measure(array.mean(axis=2)))
    if math.isnan(value):
        return without_interval(value, episodes, "not defined for this matrix")
    each = np.array([measure(array[:, :, e]) for e in range(episodes)])
    if does_not_vary(each):
        return without_interval(value, episodes, "no interval: all episodes are equal")
    return Estimate(value, *t_ends(each, level, bounds), "episodes", episodes)


def generalization_over_episodes(scores: ArrayLike, *, level: float = LEVEL) -> tuple[Band, Band]:
    """Return `generalization` of pursuers and of evaders with t intervals over episodes.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Capture rates in [0, 1] of independent episodes, at least two of each cell.
    level : float, optional
        Confidence level of each point, in (0, 1). A whole curve leaves the band more often.

    Returns
    -------
    pursuers, evaders : Band
        Mean payoffs of the n and of the m generations. Where all episodes are equal, the band has
        no width, which is no certainty.

    Raises
    ------
    ValueError
        As `linear_over_episodes`.

    Notes
    -----
    The interval is about other episodes of the same opponents, not about other opponents. As in
    `linear_over_episodes`, episode e of all cells is one measurement of each mean.
    """
    array = _check_cells(scores, level)
    captured, escaped = array.mean(axis=1).T, 1.0 - array.mean(axis=0).T
    pursuers, evaders = (
        band_over_runs(each, level=level, bounds=(0.0, 1.0)) for each in (captured, escaped)
    )
    return pursuers, evaders


def transitive_share_over_episodes(scores: ArrayLike, *, level: float = LEVEL) -> Estimate:
    """Return the transitive share without episode noise, with an interval over episodes.

    Parameters
    ----------
    scores : array_like of float, shape (n, m, episodes)
        Scores in [0, 1] of independent episodes, at least two of each cell.
    level : float, optional
        Confidence level, in (0, 1).

    Returns
    -------
    Estimate
        The share, in [0, 1], that endless episodes would give. It has no interval with fewer than
        `FEWEST_EPISODES` episodes, or if the cells do not vary more than episode noise does: then
        nothing can be said about shares of their variation.

    Raises
    ------
    ValueError
        As `linear_over_episodes`.

    Notes
    -----
    The share is ``1 - residual / total``. Both sums of squares are too large by the variance of the
    noise, because each cell is multiplied by itself. Products of different episodes of a cell have
    no such bias, and the sums are estimated from these (U statistics). The interval inverts a t
    test, as Fieller's theorem does for a ratio: it holds all shares r for which
    ``residual - (1 - r) total`` differs from 0 by at most t standard errors. These come from the
    jackknife over episodes, which never underestimates a variance on average.

    References
    ----------
    Hoeffding (1948), "A class of statistics with asymptotically normal distribution". Fieller
    (1954), "Some problems in interval estimation". Efron and Stein (1981), "The jackknife estimate
    of variance".
    """
    array = _check_cells(scores, level)
    episodes = array.shape[2]
    measured = transitive_share(array.mean(axis=2))
    if episodes < FEWEST_EPISODES:
        return without_interval(measured, episodes, f"{BIASED} below {FEWEST_EPISODES} episodes")
    ends = _cyclic_share(*_sums_without_noise(array), t_quantile(level, episodes - 1))
    if ends is None:
        return without_interval(measured, episodes, f"{BIASED}, no variation beyond it")
    value, low, high = (float(share) for share in np.clip(1.0 - np.array(ends), 0.0, 1.0))
    return Estimate(value, low, high, "episodes", episodes, "episode noise subtracted")


def _sums_without_noise(scores: Rates) -> tuple[Rates, Rates]:
    """Return residual and total sum of squares, shape (2,), and their covariance, shape (2, 2)."""
    matrices = np.moveaxis(scores, 2, 0)
    episodes = len(matrices)
    total = matrices - matrices.mean(axis=(1, 2), keepdims=True)
    residual = total - total.mean(axis=1, keepdims=True) - total.mean(axis=2, keepdims=True)
    parts = np.stack([residual, total]).reshape(2, episodes, -1)
    products = parts @ parts.transpose(0, 2, 1)
    # Products of an episode with itself hold the noise, so only those of two episodes count.
    of_episode = products.sum(axis=2) - np.diagonal(products, axis1=1, axis2=2)
    everything = of_episode.sum(axis=1)
    left_out = everything[:, None] - 2.0 * of_episode
    jackknife = left_out / ((episodes - 1) * (episodes - 2))
    deviations = jackknife - jackknife.mean(axis=1, keepdims=True)
    covariance = (episodes - 1) / episodes * deviations @ deviations.T
    return everything / (episodes * (episodes - 1)), covariance


def _cyclic_share(sums: Rates, covariance: Rates, t: float) -> tuple[float, float, float] | None:
    """Return the share q with its largest and smallest value, or None if the total may be 0.

    The ends solve ``(residual - q total)^2 = t^2 variance(residual - q total)``.
    """
    residual, total = sums.tolist()
    a = total**2 - t**2 * covariance[1, 1]
    b = residual * total - t**2 * covariance[0, 1]
    c = residual**2 - t**2 * covariance[0, 0]
    if total <= 0.0 or a <= 0.0:
        return None
    half = math.sqrt(max(0.0, b**2 - a * c))
    return residual / total, (b + half) / a, (b - half) / a


def _ends_of_mean(
    scores: Rates, level: float, rng: np.random.Generator | int
) -> tuple[float, float]:
    values, counts = np.unique(scores, return_counts=True)
    # Weights of equal scores add up: a gamma variable for each value instead of each episode.
    generator = np.random.default_rng(rng)
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


def _check_cells(scores: ArrayLike, level: float) -> Rates:
    array = check_rates(scores, ndim=3, what="scores (n, m, episodes)")
    check_level(level)
    require(array.shape[2] >= 2, "at least 2 episodes a cell", array.shape[2])
    return array
