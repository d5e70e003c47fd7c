"""CIAO: current individuals against ancestral opponents, as numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_payoff, swap_teams

# Fewest pairs of cells for a correlation; with fewer it is dominated by chance.
_FEWEST_PAIRS = 6


@dataclass(frozen=True, eq=False)
class Triangle:
    """One team's half of a CIAO plot, measured by its own payoff: higher is better.

    Parameters
    ----------
    payoff : ndarray of float64, shape (n, m)
        Payoff of generation g of the team against opponents of generation ``h <= g``, in [0, 1];
        NaN where opponents are newer than the team.
    by_age : ndarray of float64, shape (n,)
        Mean payoff by age ``g - h`` of the opponent; age 0 is the current one. NaN where no
        opponent has that age.
    fading : float
        Mean over generations of the payoff against the newer half of the ancestral opponents minus
        the payoff against the older half, in [-1, 1]. Positive: old opponents are forgotten.
        Negative: new opponents are harder. NaN with fewer than two generations of opponents.
    stripes : float
        Regularity with which wins and losses come back with the age of the opponent: the first peak
        of the autocorrelation along the rows after it has been negative, in [0, 1]; 0 without such
        a peak. Noise alone gives up to about .2 on 30 generations.
    period : int or None
        Generations between stripes: the lag of that peak; None without one.
    """

    payoff: Rates
    by_age: Rates
    fading: float
    stripes: float
    period: int | None


class Ciao(NamedTuple):
    """The CIAO triangles of both teams.

    Parameters
    ----------
    pursuers : Triangle
        Payoff ``M[g, h]`` for ``h <= g``, in an array of shape (n, m).
    evaders : Triangle
        Payoff ``1 - M[g, h]`` for ``g <= h``, in an array of shape (m, n), evaders in rows.
    """

    pursuers: Triangle
    evaders: Triangle


def ciao(payoff: ArrayLike) -> Ciao:
    """Compare current individuals with ancestral opponents.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    Ciao
        Both triangles contain the diagonal, which is the current opponent. Stripes show cycling.
        Fading away from the diagonal shows that a team loses to opponents that it once beat. A race
        in which both teams keep improving shows neither, since old opponents are easy.

    References
    ----------
    Cliff and Miller (1995), "Tracking the Red Queen: measurements of adaptive progress in
    co-evolutionary simulations".
    """
    matrix = check_payoff(payoff)
    return Ciao(_triangle(matrix), _triangle(swap_teams(matrix)))


def autocorrelation(payoff: ArrayLike) -> Rates:
    """Return the correlation of ``M[g, h]`` with ``M[g, h - d]`` in the lower triangle.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    ndarray of float64, shape (m // 2,)
        Entry d is the correlation at lag d; entry 0 is 1 by definition. NaN where fewer than 6
        pairs of cells are left or they do not vary.

    Notes
    -----
    The mean of each row is subtracted, then all rows are pooled. Therefore stripes count wherever
    they lie in a row.
    """
    return _autocorrelation(_lower(check_payoff(payoff)))


def _triangle(matrix: Rates) -> Triangle:
    lower = _lower(matrix)
    stripes, period = _first_peak(_autocorrelation(lower))
    return Triangle(lower, _by_age(lower), _fading(lower), stripes, period)


def _lower(matrix: Rates) -> Rates:
    return np.where(np.tri(*matrix.shape) > 0.0, matrix, np.nan)


def _by_age(lower: Rates) -> Rates:
    # If the team has more generations than its opponents, some diagonals may be empty.
    diagonals = [np.diagonal(lower, offset=-age) for age in range(len(lower))]
    return np.array([cells.mean() if len(cells) else np.nan for cells in diagonals])


def _fading(lower: Rates) -> float:
    """Return newer minus older half; the middle one of an odd number of opponents is left out."""
    differences = []
    for row in lower:
        known = row[~np.isnan(row)]
        half = len(known) // 2
        if half:
            differences.append(known[-half:].mean() - known[:half].mean())
    return float(np.mean(differences)) if differences else float("nan")


def _autocorrelation(lower: Rates) -> Rates:
    counts = np.sum(~np.isnan(lower), axis=1, keepdims=True)
    centered = lower - np.nansum(lower, axis=1, keepdims=True) / counts
    # Lags up to half of the opponents: beyond them few pairs of cells are left.
    columns = lower.shape[1]
    # Row 0 has one cell, which is 0 after centering and carries no information.
    found = [
        _correlation(centered[1:, lag:], centered[1:, : columns - lag])
        for lag in range(columns // 2)
    ]
    return np.array(found)


def _correlation(one: Rates, other: Rates) -> float:
    # NaN marks cells outside the triangle; a pair counts if both of its cells lie inside.
    both = ~(np.isnan(one) | np.isnan(other))
    x, y = one[both], other[both]
    if len(x) < _FEWEST_PAIRS or min(np.ptp(x), np.ptp(y)) < 1e-12:
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def _first_peak(correlations: Rates) -> tuple[float, int | None]:
    """Return height and lag of the first positive local maximum after the first negative value."""
    # Neighbouring generations are alike, so the correlation first falls from 1 whatever happens;
    # only a rise after it has been negative shows that something comes back.
    below = np.flatnonzero(correlations < 0.0)
    start = int(below[0]) + 1 if len(below) else len(correlations)
    for lag in range(start, len(correlations) - 1):
        before, here, after = correlations[lag - 1 : lag + 2]
        if here > 0.0 and here > before and here >= after:
            return min(1.0, float(here)), lag
    return 0.0, None
