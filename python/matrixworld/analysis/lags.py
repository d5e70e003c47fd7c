"""The payoff by the age of the opponent, and the swing between team phases."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.payoff import Rates, check_payoff


@dataclass(frozen=True, eq=False)
class LagProfile:
    """Mean capture rate by lag.

    Parameters
    ----------
    lags : ndarray of int64, shape (n + m - 1,)
        Pursuer generation minus evader generation, ascending from ``-(m - 1)`` to ``n - 1``.
    means : ndarray of float64, shape (n + m - 1,)
        Mean over k of ``M[k + lag, k]``.
    cells : ndarray of int64, shape (n + m - 1,)
        Number of cells in each mean; few at both ends.
    """

    lags: NDArray[np.int64]
    means: Rates
    cells: NDArray[np.int64]

    __repr__ = short_repr

    def at(self, lag: int) -> float:
        """Return the mean at one lag, or raise ValueError if the profile does not contain it."""
        first, last = int(self.lags[0]), int(self.lags[-1])
        if not first <= lag <= last:
            raise ValueError(f"expected a lag from {first} to {last}, got {lag}")
        return float(self.means[lag - first])


def lag_profile(payoff: ArrayLike) -> LagProfile:
    """Return the mean capture rate for every lag between pursuers and evaders.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    LagProfile
        At lag d: pursuers against evaders that are d generations older. Specialists beat the
        current opponent only, so their profile is flat with a notch at 0. Generalists keep
        improving against all opponents, so their profile rises.
    """
    matrix = check_payoff(payoff)
    rows, columns = matrix.shape
    lags = np.arange(1 - columns, rows)
    # NumPy counts offsets above the diagonal, where evaders are newer: the sign changes.
    diagonals = [np.diagonal(matrix, offset=-d) for d in lags]
    means = np.array([diagonal.mean() for diagonal in diagonals])
    return LagProfile(lags, means, np.array([len(diagonal) for diagonal in diagonals]))


def lag_rise(payoff: ArrayLike, lag: int | None = None) -> float:
    """Return how much better later pursuers do than earlier ones.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    lag : int, optional
        Generations between the opponents. The default is a third of the generations (10 of 31).

    Returns
    -------
    float
        Lag profile at ``+lag`` minus lag profile at ``-lag``, in [-1, 1]. Swapping the teams gives
        the same number.

    Raises
    ------
    ValueError
        Unless ``1 <= lag < min(n, m)``.
    """
    matrix = check_payoff(payoff)
    shortest = min(matrix.shape)
    lag = default_rise_lag(shortest) if lag is None else lag
    if not 1 <= lag < shortest:
        raise ValueError(f"expected a lag from 1 to {shortest - 1}, got {lag}")
    # Both lags have the same number of cells in a square matrix, so both means are equally noisy.
    profile = lag_profile(matrix)
    return profile.at(lag) - profile.at(-lag)


# Long enough for strength to grow by more than noise, short enough to leave many cells.
def default_rise_lag(generations: int) -> int:
    """Return a third of the generations, rounded down, at least 1."""
    return max(1, generations // 3)


def team_phase_rates(payoff: ArrayLike) -> Rates:
    """Return the capture rate after each team phase of generations 1, 2, ...

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    ndarray of float64, shape (K, 2)
        With ``K = min(n, m) - 1``. Row ``k - 1`` holds ``M[k, k - 1]``, after the pursuers of
        generation k have learned, and ``M[k, k]``, after the evaders have learned.
    """
    matrix = check_payoff(payoff)
    # Generation 0 is untrained: no team phase precedes it.
    k = np.arange(1, min(matrix.shape))
    return np.stack([matrix[k, k - 1], matrix[k, k]], axis=1)


def swing(payoff: ArrayLike, start: int | None = None) -> float:
    """Return how much the capture rate changes on average in the evaders' team phase.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    start : int, optional
        First generation of the mean. The default is a quarter of the generations, rounded up (8 of
        31), which leaves out the untrained ones.

    Returns
    -------
    float
        Mean of ``abs(M[k, k - 1] - M[k, k])`` over generations ``k >= start``.

    Raises
    ------
    ValueError
        Unless ``1 <= start < min(n, m)``.

    Notes
    -----
    Pursuers learn first in a generation, so swapping the teams gives another number.
    """
    rates = team_phase_rates(payoff)
    # Row k - 1 belongs to generation k, hence one more generation than rows.
    start = default_swing_start(len(rates) + 1) if start is None else start
    if not 1 <= start <= len(rates):
        raise ValueError(f"expected a start from 1 to {len(rates)}, got {start}")
    return float(np.abs(rates[start - 1 :, 0] - rates[start - 1 :, 1]).mean())


def default_swing_start(generations: int) -> int:
    """Return a quarter of the generations, rounded up, at least 1."""
    return max(1, -(-generations // 4))
