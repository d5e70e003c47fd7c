"""Is there an order of strength, or does it depend on who meets whom?"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import SHRINKAGE, Rates, check_payoff, require
from matrixworld.analysis.payoff import logits as logits_of

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


class TwoWayParts(NamedTuple):
    """``M = mean + pursuers[:, None] + evaders + cyclic``; in units of the capture rate."""

    mean: float
    pursuers: Rates
    """Shape ``(n,)``, sum 0: how much more than the mean each pursuer generation captures."""
    evaders: Rates
    """Shape ``(m,)``, sum 0: how much more each evader generation is captured (higher: weaker)."""
    cyclic: Rates
    """Shape ``(n, m)``, rows and columns sum to 0: what depends on who meets whom, and noise."""


def transitive_share(
    payoff: ArrayLike, *, logits: bool = False, shrinkage: float = SHRINKAGE
) -> float:
    """Share of the variance that each generation's own strength explains, in [0, 1].

    ``1 - |R|^2 / |M - mean|^2`` with the residual R of the two-way analysis of variance
    ``M = mean + r_g + c_h + R``, which on two teams is the Hodge decomposition. 1: strengths add
    up; 0: only who meets whom matters. NaN for a constant matrix. Noise alone gives about
    ``(n + m - 2) / (n m - 1)``, so low values need :func:`checkerboards` beside them.

    A perfectly transitive matrix of zeros and ones (a staircase) reaches 2/3 only, because sums
    cannot saturate. ``logits=True`` decomposes the :func:`logits` of the shrunken rates
    ``x = shrinkage + (1 - 2 shrinkage) M`` instead, which straightens graded matrices that flatten
    out at 0 and 1. Shrinking, unlike clipping, keeps the order of all cells.

    Raises ValueError unless ``0 < shrinkage < 1/2``.
    """
    matrix = check_payoff(payoff)
    values = logits_of(matrix, shrinkage=shrinkage) if logits else matrix
    total = float(np.sum((values - values.mean()) ** 2))
    if total <= values.size * _ROUNDING**2:
        return math.nan
    return min(1.0, max(0.0, 1.0 - float(np.sum(_parts(values).cyclic ** 2)) / total))


def two_way_parts(payoff: ArrayLike) -> TwoWayParts:
    """The four parts of ``M = mean + r_g + c_h + R``, each orthogonal to the others.

    The two-way analysis of variance (Fisher, 1925). On the complete bipartite graph of two teams
    ``r_g + c_h`` is the gradient flow of the Hodge decomposition of games (Candogan et al., 2011)
    and R its cyclic part. :func:`transitive_share` says how much the first three explain.
    """
    return _parts(check_payoff(payoff))


def _parts(values: Rates) -> TwoWayParts:
    mean = float(values.mean())
    pursuers, evaders = values.mean(axis=1) - mean, values.mean(axis=0) - mean
    return TwoWayParts(mean, pursuers, evaders, values - mean - pursuers[:, None] - evaders)


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
    require(0.0 <= margin < 1.0, "a margin in [0, 1)", margin)
    require(level is None or 0.0 <= level <= 1.0, "a level in [0, 1] or None", level)
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
