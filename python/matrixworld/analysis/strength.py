"""How much a team's strength changes over some generations, with an interval.

Two questions have two intervals. `strength_change`: how much did the strength change, given the
noise of the episodes? `strength_gain`: is there a trend, given that strength also fluctuates from
generation to generation? A random walk ends somewhere: it has a change, and no trend.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.measurement import Measurement
from matrixworld.analysis.payoff import Rates, require

GRID = 40
"""Values of each standard deviation over which the posterior is summed."""
WIDEST = (4.0, 3.0)
"""Largest standard deviations of steps and of fluctuation on the grid, in units of that of the
observed steps."""
_NEGLIGIBLE = 1e-8  # weight of a point of the grid that is left out
_LEAST = 1e-9  # a team that never changes has steps of 0; the grid needs a width


def strength_gain(scores: ArrayLike, noise: ArrayLike, *, level: float = 0.95) -> Measurement:
    """Return how much the strength of a team changes from its first to its last generation.

    Parameters
    ----------
    scores : array_like of float, shape (k,)
        Mean payoff of each generation against the same opponents; at least 4 generations.
    noise : array_like of float, shape (k,)
        Variance of the measurement error of each score; 0 if it is unknown, which widens the
        interval.
    level : float, optional
        Probability of the interval, in (0, 1).

    Returns
    -------
    Measurement
        ``k - 1`` times the drift, with an equal-tailed credible interval.

    Raises
    ------
    ValueError
        If the shapes differ or there are fewer generations.

    Notes
    -----
    The model is a random walk with drift that is observed with fluctuation and noise (the local
    level model with drift, Harvey 1989)::

        score[g]        = strength[g] + fluctuation[g] + error[g]
        strength[g + 1] = strength[g] + drift + step[g]
        step ~ N(0, s^2)    fluctuation ~ N(0, t^2)    error ~ N(0, mean noise)

    A team that improves steadily has small steps, and its drift is known as well as that of a
    regression line, also if single generations fluctuate about it. A team that jumps once, or
    drifts at random, has large steps, and its drift cannot be told from 0. The prior is flat on the
    drift, on s and on t, which Gelman (2006) recommends for standard deviations of few
    observations. Given s and t the drift is normal; both are summed out on a grid.

    References
    ----------
    Harvey (1989), "Forecasting, structural time series models and the Kalman filter". Gelman
    (2006), "Prior distributions for variance parameters in hierarchical models", Bayesian Analysis
    1(3).
    """
    y, variances = _checked(scores, noise)
    steps = len(y) - 1
    drifts, deviations, weights = _posterior(np.diff(y), float(variances.mean()))
    tail = (1.0 - level) / 2.0
    low, middle, high = (
        steps * _quantile(p, drifts, deviations, weights) for p in (tail, 0.5, 1.0 - tail)
    )
    # A mean score lies in [0, 1], so it cannot change by more than 1.
    low, middle, high = np.clip([low, middle, high], -1.0, 1.0).tolist()
    return Measurement(middle, low, high)


def strength_change(scores: ArrayLike, noise: ArrayLike, *, level: float = 0.95) -> Measurement:
    """Return the linear change of a team's strength from its first to its last generation.

    Parameters
    ----------
    scores, noise : array_like of float, shape (k,)
        As for `strength_gain`.
    level : float, optional
        Confidence level, in (0, 1).

    Returns
    -------
    Measurement
        ``k - 1`` times the slope of the least-squares line. The interval is normal with the known
        noise. If all noise is 0, which means unknown, it is Student's t interval with the scatter
        about the line.

    Raises
    ------
    ValueError
        As for `strength_gain`.
    """
    from scipy.special import stdtrit

    y, variances = _checked(scores, noise)
    steps = len(y) - 1
    places = np.arange(len(y)) - steps / 2.0
    weights = steps * places / (places**2).sum()
    freedom = np.inf
    if not variances.any():
        freedom = len(y) - 2
        residuals = y - y.mean() - places * (places @ y) / (places**2).sum()
        variances = np.full(len(y), (residuals**2).sum() / freedom)
    value = float(weights @ y)
    reach = float(stdtrit(freedom, (1.0 + level) / 2.0) * np.sqrt(weights**2 @ variances))
    return Measurement(value, value - reach, value + reach)


def _checked(scores: ArrayLike, noise: ArrayLike) -> tuple[Rates, Rates]:
    y, variances = np.asarray(scores, dtype=np.float64), np.asarray(noise, dtype=np.float64)
    require(y.ndim == 1 and y.shape == variances.shape, "scores and noise of shape (k,)", y.shape)
    require(len(y) >= 4, "at least 4 generations", len(y))
    return y, variances


def _posterior(steps: Rates, noise: float) -> tuple[Rates, Rates, Rates]:
    """Return mean and standard deviation of the drift for each s and t, and their weights."""
    spread = max(float(steps.std()), _LEAST)
    middles = (np.arange(GRID) + 0.5) / GRID * spread
    s, t = (grid.reshape(-1, 1) for grid in np.meshgrid(*(most * middles for most in WIDEST)))
    # Neighbouring differences share a score: covariance 2, -1 on the diagonals, whose eigenvectors
    # are sines.
    k = np.arange(1, len(steps) + 1)
    angles = np.pi * k / (len(steps) + 1)
    vectors = np.sin(np.outer(k, angles)) * np.sqrt(2.0 / (len(steps) + 1))
    ones, values = vectors.sum(axis=0), vectors.T @ steps
    precision = 1.0 / ((noise + t**2) * (2.0 - 2.0 * np.cos(angles)) + s**2)
    total = (precision * ones**2).sum(axis=1)
    drifts = (precision * ones * values).sum(axis=1) / total
    misfit = (precision * (values - drifts[:, np.newaxis] * ones) ** 2).sum(axis=1)
    # The likelihood of s and t with the drift integrated out.
    log_weights = 0.5 * (np.log(precision).sum(axis=1) - np.log(total) - misfit)
    weights = np.exp(log_weights - log_weights.max())
    kept = weights > _NEGLIGIBLE * weights.sum()
    return drifts[kept], total[kept] ** -0.5, weights[kept] / weights[kept].sum()


def _quantile(probability: float, means: Rates, deviations: Rates, weights: Rates) -> float:
    """Return a quantile of a mixture of normal distributions."""
    from scipy.optimize import brentq
    from scipy.special import ndtr

    reach = 12.0 * float(deviations.max())
    ends = float(means.min()) - reach, float(means.max()) + reach
    return float(brentq(lambda x: weights @ ndtr((x - means) / deviations) - probability, *ends))
