"""From wins to fitness where opponents are scarce: competitive sharing, reduced virulence."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.types import FloatArray

LEAST_VIRULENCE = 0.5
"""At it the fittest are those with half of the most wins; below, the most wins score under 0."""


def competitive_sharing(wins: ArrayLike) -> FloatArray:
    """Return ``f_i = sum_j w_ij / sum_k w_kj``, over the opponents j that somebody beats.

    Each opponent is worth 1 in all, shared by those who beat it: a rare win counts for more.
    Source: Rosin & Belew 1997, "New methods for competitive coevolution", competitive fitness
    sharing.

    Parameters
    ----------
    wins : (n, m) numbers >= 0, how surely individual i beats opponent j.

    Returns
    -------
    (n,) fitness, which sums to the number of opponents that somebody beats.
    """
    matrix = np.asarray(wins, dtype=np.float64)
    if matrix.ndim != 2 or not ((matrix >= 0.0) & (matrix < np.inf)).all():
        raise ValueError(f"wins: expected (n, m) numbers >= 0, got shape {matrix.shape}: {matrix}")
    beaten = matrix[:, matrix.sum(axis=0) > 0.0]
    fitness: FloatArray = (beaten / beaten.sum(axis=0)).sum(axis=1)
    return fitness


def reduced_virulence(wins: ArrayLike, virulence: float) -> FloatArray:
    """Return ``f = 2x/v - x^2/v^2`` with ``x = wins / best wins``: it is best to win v of the best.

    At 1 more wins are always better; below, a team that could win everything is held back, so
    that the other keeps something to learn from. Source: Cartlidge & Bullock 2004, "Combating
    coevolutionary disengagement by reducing parasite virulence", Evolutionary Computation 12(2).

    Parameters
    ----------
    wins : (n,) numbers >= 0, what each individual has won.
    virulence : v, from 0.5 to 1.

    Returns
    -------
    (n,) fitness, at most 1; zeros where nobody has won anything.
    """
    values = np.asarray(wins, dtype=np.float64)
    if values.ndim != 1 or not ((values >= 0.0) & (values < np.inf)).all():
        raise ValueError(f"wins: expected (n,) numbers >= 0, got shape {values.shape}: {values}")
    if not LEAST_VIRULENCE <= virulence <= 1.0:
        raise ValueError(f"virulence: expected {LEAST_VIRULENCE} to 1, got {virulence}")
    best = values.max(initial=0.0)
    share = (values / best if best > 0.0 else values) / virulence
    fitness: FloatArray = 2.0 * share - share * share
    return fitness
