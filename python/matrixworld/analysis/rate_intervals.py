"""Intervals of collision rates: ratios of counts to agent-steps that vary between episodes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

LEVEL = 0.95
"""Level of the confidence intervals."""
FEWEST_EPISODES = 20
"""Fewest episodes for an interval; with less, uneven rates are covered too rarely."""
FEWEST_COLLIDING = 5
"""Fewest episodes with a collision of the kind for an interval of its rate."""
_RESAMPLES = 1000
_TAILS = ((1 + LEVEL) / 2, (1 - LEVEL) / 2)


def rate_intervals(
    counts: NDArray[np.int64], agent_steps: NDArray[np.int64], seed: int = 0
) -> NDArray[np.float64]:
    """Return bootstrap-t intervals of rates per 1000 agent-steps.

    Parameters
    ----------
    counts : ndarray of int64, shape (episodes, ..., 2, 3)
        Agent-steps in collision in each episode, by team and kind.
    agent_steps : ndarray of int64, shape (episodes, 2)
        Agent-steps of each team.
    seed : int, optional
        Seed of the bootstrap.

    Returns
    -------
    ndarray of float64, shape (..., 2, 3, 2)
        Ends of the intervals. NaN with fewer than `FEWEST_EPISODES` episodes, or fewer than
        `FEWEST_COLLIDING` with a count above 0.

    Notes
    -----
    Episodes are resampled. Each resample gives the distance of its rate from the rate of all
    episodes in standard errors of a ratio; quantiles of this distance replace those of Student's
    t. This covers skewed counts better than quantiles of the resampled rates.

    References
    ----------
    Hall (1988), "Theoretical comparison of bootstrap confidence intervals".
    """
    n, rng = len(counts), np.random.default_rng(seed)
    c = counts.reshape(n, -1).astype(float)
    s = np.broadcast_to(_by_kind(agent_steps, counts.ndim), counts.shape).reshape(n, -1)
    data = np.concatenate([c, s, c * c, c * s, s * s], axis=1)
    draws = (np.bincount(rng.integers(n, size=n), minlength=n) for _ in range(_RESAMPLES))
    # One draw is how often each episode occurs in a resample: a product sums the whole resample.
    sums = np.stack([data.sum(axis=0), *(times @ data for times in draws)])
    ends = _ends(*_rates_and_errors(sums.reshape(len(sums), 5, -1)))
    ends[:, ((c > 0).sum(axis=0) < FEWEST_COLLIDING) | (n < FEWEST_EPISODES)] = np.nan
    return np.asarray(1000 * ends.T.reshape(*counts.shape[1:], 2))


def _by_kind(agent_steps: NDArray[np.int64], ndim: int) -> NDArray[np.float64]:
    """Return agent-steps (episodes, 2) with axes of length 1 for all other axes of the counts."""
    shape = (len(agent_steps), *(1,) * (ndim - 3), 2, 1)
    return agent_steps.reshape(shape).astype(float)


def _rates_and_errors(sums: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return ratios c / s, shape (k, rates), and their standard errors up to a constant factor."""
    c, s, cc, cs, ss = np.moveaxis(sums, 1, 0)
    s = np.maximum(s, 1.0)  # a team without agent-steps has no collisions either
    rates = c / s
    return rates, np.sqrt(np.maximum(cc - 2 * rates * cs + rates**2 * ss, 0.0)) / s


def _ends(rates: NDArray[Any], errors: NDArray[Any]) -> NDArray[np.float64]:
    """Return the ends of the intervals, shape (2, rates); row 0 is the data, others resamples."""
    with np.errstate(divide="ignore", invalid="ignore"):
        # A resample of equal episodes is infinitely many standard errors away, if it differs.
        t = (rates[1:] - rates[0]) / errors[1:]
        t[np.isnan(t)] = 0.0
        # Without interpolation, which has no result between two infinities.
        ends = rates[0] - np.quantile(t, _TAILS, axis=0, method="nearest") * errors[0]
    return np.asarray(np.clip(ends, 0.0, 1.0))
