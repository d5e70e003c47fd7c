"""Transitive and cyclic parts of a payoff matrix, and checkerboards."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import SHRINKAGE, Mask, Rates, check_payoff, require
from matrixworld.analysis.payoff import logits as logits_of

_ROUNDING = 1e-12  # differences of capture rates below this are floating-point noise


@dataclass(frozen=True)
class Checkerboards:
    """Number of checkerboards in a payoff matrix.

    Parameters
    ----------
    count : int
        Quadruples of two pursuer and two evader generations that are checkerboards.
    possible : int
        All quadruples.
    """

    count: int
    possible: int

    @property
    def share(self) -> float:
        """``count / possible``; NaN where no quadruple is possible."""
        return self.count / self.possible if self.possible else math.nan


@dataclass(frozen=True)
class Checkerboard:
    """One checkerboard: each of its pursuers is better against its own evader.

    Parameters
    ----------
    pursuers : tuple of int
        The two pursuer generations.
    evaders : tuple of int
        The two evader generations: the first pursuers are better against the first evaders.
    margin : float
        By how much each of the two better cells exceeds each of the two worse ones.
    """

    pursuers: tuple[int, int]
    evaders: tuple[int, int]
    margin: float


class TwoWayParts(NamedTuple):
    """Parts of ``M = mean + pursuers[:, None] + evaders + cyclic``, in units of the capture rate.

    Parameters
    ----------
    mean : float
        Mean of the matrix.
    pursuers : ndarray of float64, shape (n,)
        How much more than the mean each pursuer generation captures; sum 0.
    evaders : ndarray of float64, shape (m,)
        How much more than the mean each evader generation is captured; sum 0. Higher is weaker.
    cyclic : ndarray of float64, shape (n, m)
        The rest, which depends on the pairing or is noise; all rows and columns sum to 0.
    """

    mean: float
    pursuers: Rates
    evaders: Rates
    cyclic: Rates


def transitive_share(
    payoff: ArrayLike, *, logits: bool = False, shrinkage: float = SHRINKAGE
) -> float:
    """Return the share of the variance that each generation's own strength explains.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    logits : bool, optional
        Decompose the logits of the shrunken rates instead of the rates.
    shrinkage : float, optional
        Shrinkage before the logits, in (0, 1/2); see `matrixworld.analysis.logits`.

    Returns
    -------
    float
        In [0, 1]. 1: the strengths of both generations add up to the capture rate. 0: only the
        pairing matters. NaN for a constant matrix.

    Raises
    ------
    ValueError
        If the shrinkage is outside (0, 1/2).

    Notes
    -----
    The share is ``1 - |R|^2 / |M - mean|^2`` with the residual R of `two_way_parts`. Noise alone
    gives about ``(n + m - 2) / (n m - 1)``, so a low value is no proof of cycles: look at
    `checkerboards`, too.

    A perfectly transitive matrix of zeros and ones (a staircase) reaches 2/3 only, because a sum of
    strengths does not saturate. Logits straighten graded matrices that flatten out at 0 and 1.
    """
    matrix = check_payoff(payoff)
    values = logits_of(matrix, shrinkage=shrinkage) if logits else matrix
    total = float(np.sum((values - values.mean()) ** 2))
    if total <= values.size * _ROUNDING**2:  # constant but for rounding
        return math.nan
    return min(1.0, max(0.0, 1.0 - float(np.sum(_parts(values).cyclic ** 2)) / total))


def two_way_parts(payoff: ArrayLike) -> TwoWayParts:
    """Decompose a payoff matrix into mean, strength of each generation, and cyclic part.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.

    Returns
    -------
    TwoWayParts
        The parts of ``M = mean + r_g + c_h + R``, each orthogonal to the others.

    Notes
    -----
    On the complete bipartite graph of two teams ``r_g + c_h`` is the gradient flow of the Hodge
    decomposition of games, and R is its cyclic part.

    References
    ----------
    Fisher (1925), "Statistical methods for research workers": two-way analysis of variance.
    Candogan et al. (2011), "Flows and decompositions of games: harmonic and potential games".
    """
    return _parts(check_payoff(payoff))


def _parts(values: Rates) -> TwoWayParts:
    mean = float(values.mean())
    # With one value in each cell the least-squares strengths are row and column means.
    pursuers, evaders = values.mean(axis=1) - mean, values.mean(axis=0) - mean
    return TwoWayParts(mean, pursuers, evaders, values - mean - pursuers[:, None] - evaders)


def checkerboards(
    payoff: ArrayLike, *, margin: float = 0.0, level: float | None = 0.5
) -> Checkerboards:
    """Count checkerboards: pursuers p1 beat e1 but not e2, and p2 beat e2 but not e1.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    margin : float, optional
        Each of ``M[p1, e1]`` and ``M[p2, e2]`` exceeds each of ``M[p1, e2]`` and ``M[p2, e1]`` by
        more than this, in [0, 1).
    level : float or None, optional
        Capture rate in [0, 1] above which pursuers beat evaders: both winning cells lie above it,
        both losing cells do not. None: cells are compared with each other only.

    Returns
    -------
    Checkerboards
        Counted over unordered pairs of rows and unordered pairs of columns.

    Raises
    ------
    ValueError
        Unless ``0 <= margin < 1`` and the level is None or in [0, 1].

    Notes
    -----
    At the level 1/2, matching pennies have 1 checkerboard of 1 possible, and rock-paper-scissors (a
    draw is not a win) has 3 of 9. Without a level, a cycle between capture rates of .1 and .4 is
    found, too; at margin 0 a strictly increasing function of M changes nothing; and swapping the
    teams gives the same count (at a level of .5 it does if no cell is exactly .5). With or without
    a level, a staircase and any matrix ``f(r_g + c_h)`` with increasing f have none.

    Time O(n^2 m^2), memory O(n m^2).
    """
    matrix = check_payoff(payoff)
    require(0.0 <= margin < 1.0, "a margin in [0, 1)", margin)
    require(level is None or 0.0 <= level <= 1.0, "a level in [0, 1] or None", level)
    prefers = _prefers(matrix, margin, level)
    # One row at a time: all pairs of rows at once would take O(n^2 m^2) memory.
    count = sum(_count_from(p, matrix, prefers, margin) for p in range(len(matrix) - 1))
    rows, columns = matrix.shape
    return Checkerboards(count, math.comb(rows, 2) * math.comb(columns, 2))


def _prefers(matrix: Rates, margin: float, level: float | None) -> Mask:
    """Return ``[p, a, b]``: p beats a and not b by the margin; bool, shape (n, m, m)."""
    # Two of the four margins compare cells of one row, so they serve all pairs of rows.
    prefers: Mask = matrix[:, :, None] - matrix[:, None, :] > margin
    if level is not None:
        wins = matrix > level
        prefers &= wins[:, :, None] & ~wins[:, None, :]
    return prefers


def _count_from(p: int, matrix: Rates, prefers: Mask, margin: float) -> int:
    """Count checkerboards of row p with later rows, over ordered pairs of columns (e1, e2)."""
    # Columns are ordered and rows are not: each checkerboard is found under one naming only.
    after = slice(p + 1, None)
    p_leads = matrix[p] - matrix[after] > margin  # (rows, e1)
    p_trails = matrix[after] - matrix[p] > margin  # (rows, e2)
    found = prefers[p] & prefers[after].transpose(0, 2, 1)
    found &= p_leads[:, :, None] & p_trails[:, None, :]
    return int(np.count_nonzero(found))


def strongest_checkerboards(
    payoff: ArrayLike, *, count: int = 12, margin: float = 0.0
) -> tuple[Checkerboard, ...]:
    """Return checkerboards with large margins that differ from each other.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix.
    count : int, optional
        The most checkerboards, at least 0. The default is 12.
    margin : float, optional
        Their margins are above this, in [0, 1).

    Returns
    -------
    tuple of Checkerboard
        In descending order of the margin. No two have more than two generations in common: a strong
        one has many neighbours that show the same. The largest of many margins is larger than the
        true one; `noise_reference` says how many checkerboards noise alone makes.

    Raises
    ------
    ValueError
        Unless ``count >= 0`` and ``0 <= margin < 1``.
    """
    matrix = check_payoff(payoff)
    require(count >= 0, "a count of at least 0", count)
    require(0.0 <= margin < 1.0, "a margin in [0, 1)", margin)
    pairs = itertools.combinations(range(len(matrix)), 2)
    boards = sorted((_strongest_of(matrix, p, q) for p, q in pairs), key=lambda b: -b.margin)
    chosen: list[Checkerboard] = []
    for board in boards:
        if board.margin <= margin or len(chosen) == count:
            break
        if all(_in_common(board, other) <= 2 for other in chosen):
            chosen.append(board)
    return tuple(chosen)


def _strongest_of(matrix: Rates, p: int, q: int) -> Checkerboard:
    """Return the checkerboard of two rows with the largest margin, which may be negative."""
    better = np.minimum(matrix[p][:, None], matrix[q])  # (evaders of p, evaders of q)
    worse = np.maximum(matrix[p], matrix[q][:, None])
    margins = better - worse
    a, b = np.unravel_index(int(margins.argmax()), margins.shape)
    return Checkerboard((p, q), (int(a), int(b)), float(margins[a, b]))


def _in_common(one: Checkerboard, other: Checkerboard) -> int:
    pursuers = set(one.pursuers) & set(other.pursuers)
    return len(pursuers) + len(set(one.evaders) & set(other.evaders))
