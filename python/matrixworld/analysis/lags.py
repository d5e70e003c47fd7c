"""The payoff by the age of the opponent, and what each team phase undid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld.analysis.payoff import Rates, check_payoff


@dataclass(frozen=True, eq=False)
class LagProfile:
    """Mean capture rate by lag; three arrays of length ``n + m - 1``, lags ascending."""

    lags: NDArray[np.int64]
    """Pursuer generation minus evader generation, from ``-(m - 1)`` to ``n - 1``."""
    means: Rates
    """Mean over k of ``M[k + d, k]``."""
    cells: NDArray[np.int64]
    """Number of cells behind each mean: few at both ends."""

    def at(self, lag: int) -> float:
        """The mean at one lag. Raises ValueError outside the profile."""
        first, last = int(self.lags[0]), int(self.lags[-1])
        if not first <= lag <= last:
            raise ValueError(f"expected a lag from {first} to {last}, got {lag}")
        return float(self.means[lag - first])


def lag_profile(payoff: ArrayLike) -> LagProfile:
    """Mean over k of ``M[k + d, k]`` for every lag d: pursuers of d generations after the evaders.

    Specialists beat the current opponent and no other (a notch at 0 in a flat line); generalists
    keep gaining on everyone (a rising line).
    """
    matrix = check_payoff(payoff)
    rows, columns = matrix.shape
    lags = np.arange(1 - columns, rows)
    diagonals = [np.diagonal(matrix, offset=-d) for d in lags]
    means = np.array([diagonal.mean() for diagonal in diagonals])
    return LagProfile(lags, means, np.array([len(diagonal) for diagonal in diagonals]))


def lag_rise(payoff: ArrayLike, lag: int | None = None) -> float:
    """How much better later pursuers do than earlier: lag profile at ``+lag`` less at ``-lag``.

    In [-1, 1]; the same number after swapping the teams. ``lag`` defaults to a third of the
    generations (10 of 31). Raises ValueError unless ``1 <= lag < min(n, m)``.
    """
    matrix = check_payoff(payoff)
    shortest = min(matrix.shape)
    lag = default_rise_lag(shortest) if lag is None else lag
    if not 1 <= lag < shortest:
        raise ValueError(f"expected a lag from 1 to {shortest - 1}, got {lag}")
    profile = lag_profile(matrix)
    return profile.at(lag) - profile.at(-lag)


def default_rise_lag(generations: int) -> int:
    """A third of the generations, rounded down, at least 1."""
    return max(1, generations // 3)


def half_steps(payoff: ArrayLike) -> Rates:
    """Capture rate after each team phase of generations 1, 2, ...; shape ``(K, 2)``, K >= 0.

    Row ``k - 1`` holds ``M[k, k - 1]``, after the pursuers of generation k have learned, and
    ``M[k, k]``, after the evaders have answered; ``K = min(n, m) - 1``.
    """
    matrix = check_payoff(payoff)
    k = np.arange(1, min(matrix.shape))
    return np.stack([matrix[k, k - 1], matrix[k, k]], axis=1)


def swing(payoff: ArrayLike, start: int | None = None) -> float:
    """Mean of ``abs(M[k, k - 1] - M[k, k])`` over generations k >= start: what one answer undoes.

    ``start`` defaults to a quarter of the generations, rounded up (8 of 31), to leave out the
    naive ones. Raises ValueError unless ``1 <= start < min(n, m)``. Pursuers learn first in a
    generation, so swapping the teams does not give the same number.
    """
    rates = half_steps(payoff)
    start = default_swing_start(len(rates) + 1) if start is None else start
    if not 1 <= start <= len(rates):
        raise ValueError(f"expected a start from 1 to {len(rates)}, got {start}")
    return float(np.abs(rates[start - 1 :, 0] - rates[start - 1 :, 1]).mean())


def default_swing_start(generations: int) -> int:
    """A quarter of the generations, rounded up, at least 1."""
    return max(1, -(-generations // 4))
