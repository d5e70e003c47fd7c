"""Forgetting: how far generations fall below the best of their ancestors."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.measurement import Measurement
from matrixworld.analysis.payoff import Rates, check_payoff, require, swap_teams


class Forgetting(NamedTuple):
    """Drop of each generation below the best of its ancestors, in [0, 1].

    Parameters
    ----------
    pursuers : ndarray of float64, shape (n,)
        Drop of the pursuers.
    evaders : ndarray of float64, shape (m,)
        Drop of the evaders.
    """

    pursuers: Rates
    evaders: Rates


def forgetting(payoff: ArrayLike) -> Forgetting:
    """Return how far each generation falls below the best of its ancestors, over all opponents.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    Forgetting
        Mean drop of each generation. It is 0 where no generation lost a payoff that an earlier one
        had.

    Notes
    -----
    For pursuers of generation g: mean over h of ``max(M[:g + 1, h]) - M[g, h]``; for evaders the
    same on ``1 - M``. The maximum of many noisy cells is too high by chance, so a few hundredths
    mean nothing; `held_out_forgetting` has no such bias.

    References
    ----------
    Chaudhry et al. (2018), "Riemannian walk for incremental learning", where forgetting is measured
    at the end of training only.
    """
    matrix = check_payoff(payoff)
    return held_out_forgetting(matrix, matrix)


def held_out_forgetting(one: ArrayLike, other: ArrayLike) -> Forgetting:
    """Return forgetting without selection bias: best ancestors are chosen in other episodes.

    Parameters
    ----------
    one : array_like of float, shape (n, m)
        Capture rates of all pairs in one set of episodes.
    other : array_like of float, shape (n, m)
        Capture rates of the same pairs in other episodes.

    Returns
    -------
    Forgetting
        Drop of each generation below the best ancestor, mean over opponents.

    Raises
    ------
    ValueError
        If the shapes differ, or these are not payoff matrices.

    Notes
    -----
    For each opponent one set of episodes chooses the best ancestor, and the other set measures how
    far a generation falls below it; then the sets change roles, and the mean is taken. Pure noise
    gives 0 on average, and noise that hides the best ancestor makes the value too low. `forgetting`
    chooses and measures in the same episodes, so its value is too high. The same matrix twice gives
    `forgetting`.
    """
    first, second = check_payoff(one), check_payoff(other)
    require(first.shape == second.shape, f"two matrices of shape {first.shape}", second.shape)
    pairs = ((first, second), (swap_teams(first), swap_teams(second)))
    # Each set of episodes chooses once and measures once, so that no episode is wasted.
    pursuers, evaders = ((_drops(a, b) + _drops(b, a)) / 2.0 for a, b in pairs)
    return Forgetting(pursuers, evaders)


def mean_forgetting(
    halves: tuple[Rates, Rates], noise: ArrayLike, generations: slice, *, level: float = 0.95
) -> Measurement:
    """Return the mean forgetting of the row team over some generations, with an interval.

    Parameters
    ----------
    halves : tuple of ndarray of float64, shape (n, m)
        Payoffs of the row team in two independent sets of episodes of equal size.
    noise : array_like of float, shape (n, m)
        Variance of the mean of both sets in each cell.
    generations : slice
        Generations (rows) whose drops are averaged. Their ancestors are all earlier rows.
    level : float, optional
        Confidence level, in (0, 1).

    Returns
    -------
    Measurement
        `held_out_forgetting`, which is not too high on average. `over` is `forgetting`, which is
        not too low on average; the interval reaches from below the first to above the second.
    """
    from scipy.special import ndtri

    first, second = halves
    value = float(((_drops(first, second) + _drops(second, first)) / 2.0)[generations].mean())
    both = (first + second) / 2.0
    naive = float(_drops(both, both)[generations].mean())
    variance = np.asarray(noise, dtype=np.float64)
    reach = float(ndtri((1.0 + level) / 2.0))
    # The two directions share episodes; the mean of their errors holds for any correlation.
    errors = [_error(chooses, 2.0 * variance, generations) for chooses in (first, second)]
    low = value - reach * float(np.mean(errors))
    high = naive + reach * _error(both, variance, generations)
    # No generation can fall below ancestors by less than 0; noise can make the estimate negative.
    return Measurement(max(0.0, value), low, max(high, value), under=value, over=naive)


def _drops(chooses: Rates, measures: Rates) -> Rates:
    """Return the drop of each row below the best row so far, mean over columns; shape (n,)."""
    heights = np.take_along_axis(measures, _best_so_far(chooses), axis=0)
    drops: Rates = (heights - measures).mean(axis=1)
    return drops


def _best_so_far(scores: Rates) -> NDArray[np.intp]:
    """Return for each cell the row of the best cell of its column so far; of equals the first."""
    rows = np.arange(len(scores))[:, np.newaxis]
    best = np.maximum.accumulate(scores, axis=0)
    # A new best is above all before it; the row number of the last new best is carried on.
    before = np.vstack([np.full((1, scores.shape[1]), -np.inf), best[:-1]])
    best_row: NDArray[np.intp] = np.maximum.accumulate(np.where(scores > before, rows, 0), axis=0)
    return best_row


def _error(chooses: Rates, variance: Rates, generations: slice) -> float:
    """Return the standard error of the mean drop, given which ancestors were chosen."""
    # The mean drop is a sum of cells with these weights: + for the best ancestor, - for the row.
    weights = np.zeros_like(chooses)
    chosen = _best_so_far(chooses)[generations]
    columns = np.broadcast_to(np.arange(chooses.shape[1]), chosen.shape)
    np.add.at(weights, (chosen, columns), 1.0)
    weights[generations] -= 1.0
    return float(np.sqrt((weights**2 * variance).sum()) / chosen.size)
