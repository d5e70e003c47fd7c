"""CIAO: each generation's current individual against its ancestral opponents, as numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_payoff, swap_teams

_FEWEST_PAIRS = 6
"""Cells that a correlation takes; with fewer it is anything."""


@dataclass(frozen=True, eq=False)
class Triangle:
    """One team's half of a CIAO plot, from its own point of view: higher is better."""

    payoff: Rates
    """Shape ``(n, m)``: generation g of the team against opponents of generation h <= g, in [0, 1];
    NaN elsewhere, where opponents are not its ancestors' contemporaries."""
    by_age: Rates
    """Shape ``(n,)``: mean payoff by age ``g - h`` of the opponent, 0 the current one; NaN where
    there are none."""
    fading: float
    """Mean over generations of the payoff against the newer half of their ancestral opponents less
    that against the older half, in [-1, 1]. Above 0: old opponents are forgotten, below 0: new ones
    are harder. NaN with fewer than two generations of opponents."""
    stripes: float
    """How regularly wins and losses come back with the age of the opponent: the first peak of the
    autocorrelation along the rows after it has been negative, in [0, 1]; 0 without such a peak.
    Noise alone gives up to about .2 on 30 generations."""
    period: int | None
    """Generations from stripe to stripe, where that peak lies; None without one."""


class Ciao(NamedTuple):
    """The two triangles."""

    pursuers: Triangle
    """Payoff ``M[g, h]``, h <= g; its array has the shape ``(n, m)``."""
    evaders: Triangle
    """Payoff ``1 - M[g, h]``, g <= h; its array has the shape ``(m, n)``, evaders first."""


def ciao(payoff: ArrayLike) -> Ciao:
    """Current individual against ancestral opponents (Cliff and Miller, 1995).

    Both triangles hold the diagonal: the current opponent. Stripes show cycling; fading away from
    the diagonal shows that a team forgets how to beat whom it once beat. In a race of ever better
    teams there are neither: old opponents are the easy ones.
    """
    matrix = check_payoff(payoff)
    return Ciao(_triangle(matrix), _triangle(swap_teams(matrix)))


def autocorrelation(payoff: ArrayLike) -> Rates:
    """Correlation of ``M[g, h]`` with ``M[g, h - d]`` within the lower triangle, for each d.

    Shape ``(m // 2,)``. Rows (without their mean) are pooled, whatever their phase, so stripes
    count wherever they lie. NaN where fewer than 6 pairs are left or they do not vary. Entry 0 is 1
    by definition.
    """
    return _autocorrelation(_lower(check_payoff(payoff)))


def _triangle(matrix: Rates) -> Triangle:
    lower = _lower(matrix)
    stripes, period = _first_peak(_autocorrelation(lower))
    return Triangle(lower, _by_age(lower), _fading(lower), stripes, period)


def _lower(matrix: Rates) -> Rates:
    return np.where(np.tri(*matrix.shape) > 0.0, matrix, np.nan)


def _by_age(lower: Rates) -> Rates:
    """Ages of which all opponents lie beyond the last one have no cells."""
    diagonals = [np.diagonal(lower, offset=-age) for age in range(len(lower))]
    return np.array([cells.mean() if len(cells) else np.nan for cells in diagonals])


def _fading(lower: Rates) -> float:
    """With an odd number of opponents the middle one is on neither side."""
    differences = []
    for row in lower:
        known = row[~np.isnan(row)]
        half = len(known) // 2
        if half:
            differences.append(known[-half:].mean() - known[:half].mean())
    return float(np.mean(differences)) if differences else float("nan")


def _autocorrelation(lower: Rates) -> Rates:
    # Row 0 has one cell, and a row without its mean is 0 there: it tells nothing.
    counts = np.sum(~np.isnan(lower), axis=1, keepdims=True)
    centered = lower - np.nansum(lower, axis=1, keepdims=True) / counts
    columns = lower.shape[1]
    found = [
        _correlation(centered[1:, lag:], centered[1:, : columns - lag])
        for lag in range(columns // 2)
    ]
    return np.array(found)


def _correlation(one: Rates, other: Rates) -> float:
    both = ~(np.isnan(one) | np.isnan(other))
    x, y = one[both], other[both]
    if len(x) < _FEWEST_PAIRS or min(np.ptp(x), np.ptp(y)) < 1e-12:
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def _first_peak(correlations: Rates) -> tuple[float, int | None]:
    """Height and place of the first local maximum above 0 after the first value below 0."""
    below = np.flatnonzero(correlations < 0.0)
    start = int(below[0]) + 1 if len(below) else len(correlations)
    for lag in range(start, len(correlations) - 1):
        before, here, after = correlations[lag - 1 : lag + 2]
        if here > 0.0 and here > before and here >= after:
            return min(1.0, float(here)), lag
    return 0.0, None
