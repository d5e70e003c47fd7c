"""Is there an order of strength, or does it depend on who meets whom?"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_payoff

SHRINKAGE = 0.01
"""Default pull towards 1/2 before a logit: 0 and 1 become .01 and .99, logits -4.6 and 4.6."""

_ROUNDING = 1e-12  # differences of capture rates below this are floating-point noise


@dataclass(frozen=True)
class Checkerboards:
    """``count`` of ``possible`` quadruples (two pursuer and two evader generations)."""

    count: int
    possible: int

    @property
    def share(self) -> float:
        """``count / possible``; NaN where no quadruple is possible."""
        return self.count / self.possible if self.possible else math.nan


def transitive_share(
    payoff: ArrayLike, *, logits: bool = False, shrinkage: float = SHRINKAGE
) -> float:
    """Share of the variance that each generation's own strength explains, in [0, 1].

    ``1 - |R|^2 / |M - mean|^2`` with the residual R of the two-way analysis of variance
    ``M = mean + r_g + c_h + R``, which on two teams is the Hodge decomposition. 1: strengths add
    up; 0: only who meets whom matters. NaN for a constant matrix. Noise alone gives about
    ``(n + m - 2) / (n m - 1)``, so low values need :func:`checkerboards` beside them.

    A perfectly transitive matrix of zeros and ones (a staircase) reaches 2/3 only, because sums
    cannot saturate. ``logits=True`` decomposes ``log(x / (1 - x))`` of the shrunken rates
    ``x = shrinkage + (1 - 2 shrinkage) M`` instead, which straightens graded matrices that flatten
    out at 0 and 1. Shrinking, unlike clipping, keeps the order of all cells.

    Raises ValueError unless ``0 < shrinkage < 1/2``.
    """
    matrix = check_payoff(payoff)
    values = _logits(matrix, shrinkage) if logits else matrix
    centered = values - values.mean()
    total = float(np.sum(centered**2))
    if total <= centered.size * _ROUNDING**2:
        return math.nan
    residual = centered - centered.mean(axis=1, keepdims=True) - centered.mean(axis=0)
    return min(1.0, max(0.0, 1.0 - float(np.sum(residual**2)) / total))


def checkerboards(
    payoff: ArrayLike, *, margin: float = 0.0, level: float | None = 0.5
) -> Checkerboards:
    """Count checkerboards: p1 beats e1 and not e2, while p2 beats e2 and not e1.

    Over unordered pairs of rows and of columns, a checkerboard has, for one naming of the two
    columns,

    - four margins above ``margin``: each of ``M[p1, e1]`` and ``M[p2, e2]`` exceeds each of
      ``M[p1, e2]`` and ``M[p2, e1]`` by more than ``margin``;
    - and, unless ``level`` is None, both winners above ``level`` and both losers not above it.

    With the level, "beats" means a capture rate above one half: matching pennies have 1 of 1,
    rock-paper-scissors (a draw is not a win) 3 of 9. Without it cells are compared with each other
    only: cycling between capture rates of .1 and .4 is seen too, a strictly increasing function
    applied to M changes nothing at margin 0, and swapping the teams gives the same count (at a
    level of .5 it does where no cell is exactly .5). Both ways a staircase, and any matrix
    ``f(r_g + c_h)`` with f increasing, has none.

    Raises ValueError unless ``0 <= margin < 1`` and ``level`` is None or in [0, 1].
    Time and memory: O(n^2 m^2) and O(n m^2).
    """
    matrix = check_payoff(payoff)
    _require(0.0 <= margin < 1.0, "a margin in [0, 1)", margin)
    _require(level is None or 0.0 <= level <= 1.0, "a level in [0, 1] or None", level)
    prefers = _prefers(matrix, margin, level)
    count = sum(_count_from(p, matrix, prefers, margin) for p in range(len(matrix) - 1))
    rows, columns = matrix.shape
    return Checkerboards(count, math.comb(rows, 2) * math.comb(columns, 2))


def _prefers(matrix: Rates, margin: float, level: float | None) -> np.ndarray:
    """``[p, a, b]``: p beats a and not b by the margin, shape ``(n, m, m)`` bool."""
    prefers: np.ndarray = matrix[:, :, None] - matrix[:, None, :] > margin
    if level is not None:
        wins = matrix > level
        prefers &= wins[:, :, None] & ~wins[:, None, :]
    return prefers


def _count_from(p: int, matrix: Rates, prefers: np.ndarray, margin: float) -> int:
    """Checkerboards of row p with the rows after it, over ordered pairs of columns (e1, e2)."""
    after = slice(p + 1, None)
    p_leads = matrix[p] - matrix[after] > margin  # (rows, e1)
    p_trails = matrix[after] - matrix[p] > margin  # (rows, e2)
    found = prefers[p] & prefers[after].transpose(0, 2, 1)
    found &= p_leads[:, :, None] & p_trails[:, None, :]
    return int(np.count_nonzero(found))


def _logits(matrix: Rates, shrinkage: float) -> Rates:
    _require(0.0 < shrinkage < 0.5, "a shrinkage in (0, 0.5)", shrinkage)
    shrunken = shrinkage + (1.0 - 2.0 * shrinkage) * matrix
    logits: Rates = np.log(shrunken) - np.log1p(-shrunken)
    return logits


def _require(condition: bool, expected: str, received: object) -> None:
    if not condition:
        raise ValueError(f"expected {expected}, got {received}")
