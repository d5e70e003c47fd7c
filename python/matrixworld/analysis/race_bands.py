"""Mean curves of several runs of a race, with pointwise intervals over runs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.generalization import generalization
from matrixworld.analysis.intervals import LEVEL, UNBOUNDED, Band, Bounds, band_over_runs
from matrixworld.analysis.lags import LagProfile, lag_profile
from matrixworld.analysis.payoff import Rates, check_payoff, require
from matrixworld.analysis.ratings import ELO_POINTS, elo


@dataclass(frozen=True, eq=False)
class RaceBands:
    """Curves of several runs: means with intervals, and the single runs.

    Parameters
    ----------
    pursuer_generalization, evader_generalization : Band
        Mean payoff of each generation against all opponents of the race, in [0, 1]. Shapes (n,) and
        (m,).
    pursuer_ratings, evader_ratings : Band
        Elo rating of each generation in points (`elo`, times `ELO_POINTS`), mean 0 over the
        generations of a run. Shapes (n,) and (m,).
    lag_profile : Band
        Mean capture rate at each of `lags`, shape (n + m - 1,).
    lags : ndarray of int64, shape (n + m - 1,)
        Pursuer generation minus evader generation, ascending.
    """

    pursuer_generalization: Band
    evader_generalization: Band
    pursuer_ratings: Band
    evader_ratings: Band
    lag_profile: Band
    lags: NDArray[np.int64]

    __repr__ = short_repr


def race_bands(payoffs: Iterable[ArrayLike], *, level: float = LEVEL) -> RaceBands:
    """Return mean generalization, ratings and lag profile of several runs, with intervals.

    Parameters
    ----------
    payoffs : iterable of array_like of float, each of shape (n, m)
        Payoff matrix of each run. Runs may have different numbers of generations, such as runs that
        were stopped early: a mean is over the runs that have the generation.
    level : float, optional
        Confidence level of each point, in (0, 1).

    Returns
    -------
    RaceBands
        Each `Band` tells the number of runs behind each point. A point of a single run has no
        interval.

    Raises
    ------
    ValueError
        If there is no run, or a matrix is not as `check_payoff` expects.

    Notes
    -----
    Student's t interval at each point, that of rates clipped to [0, 1]; see `band_over_runs`.
    """
    matrices = [check_payoff(payoff) for payoff in payoffs]
    require(bool(matrices), "at least one run", "none")
    scores = [generalization(matrix) for matrix in matrices]
    ratings = [elo(matrix) for matrix in matrices]
    profiles = [lag_profile(matrix) for matrix in matrices]
    first = min(int(profile.lags[0]) for profile in profiles)
    aligned = [_from(profile, first) for profile in profiles]

    def band(curves: list[Rates], bounds: Bounds = (0.0, 1.0)) -> Band:
        return band_over_runs(_padded(curves), level=level, bounds=bounds)

    return RaceBands(
        band([each.pursuers for each in scores]),
        band([each.evaders for each in scores]),
        band([ELO_POINTS * each.pursuers for each in ratings], UNBOUNDED),
        band([ELO_POINTS * each.evaders for each in ratings], UNBOUNDED),
        band(aligned),
        np.arange(first, first + max(map(len, aligned))),
    )


def _from(profile: LagProfile, first: int) -> Rates:
    """Return the means of a profile, with NaN for lags from `first` to its own first one."""
    return np.concatenate([np.full(int(profile.lags[0]) - first, np.nan), profile.means])


def _padded(curves: Sequence[Rates]) -> Rates:
    """Return curves of different lengths as the rows of one array, with NaN at their ends."""
    rows = np.full((len(curves), max(map(len, curves))), np.nan)
    for row, curve in zip(rows, curves, strict=True):
        row[: len(curve)] = curve
    return rows
