"""alpha-Rank: which pairs would evolution visit, and for how long?"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.payoff import Rates, check_payoff, require

ALPHA = 100.0
"""Default selection strength: a hundredth of capture rate more wins a population of 50."""
POPULATION = 50
"""Default size of each population (the paper's m)."""
MOST_STATES = 4096
"""Pairs (n times m) that are solved; 64 x 64 generations take a few seconds."""

_BLOCK = 64  # states
_RAREST = 1e-60
"""Smallest fixation probability. Rarer ones could matter only between attractors that nothing more
frequent connects, and there they would leave the range of floating-point numbers."""


@dataclass(frozen=True, eq=False)
class AlphaRank:
    """Share of the time that each pair, and each generation of a team, is the one that plays."""

    pairs: Rates
    """Shape ``(n, m)``, sum 1."""
    pursuers: Rates
    """Shape ``(n,)``, sum 1."""
    evaders: Rates
    """Shape ``(m,)``, sum 1."""


def alpha_rank(
    payoff: ArrayLike, *, alpha: float = ALPHA, population: int = POPULATION
) -> AlphaRank:
    """alpha-Rank of two populations (Omidshafiei et al., 2019): the stationary distribution.

    In each state all pursuers are of one generation g and all evaders of one h. A mutant, of each
    of the ``n + m - 2`` other generations of either team alike with ``eta = 1 / (n + m - 2)``,
    takes over its team with the probability :func:`fixation_probability` of what it gains.
    ``alpha = inf`` gives the limit in which only mutants that lose nothing take over.

    Solved by the elimination of Grassmann, Taksar and Heyman (1985), which never subtracts: it is
    exact to rounding even where states are left once in 1e60 steps, the rarest that is counted.

    Raises ValueError unless ``alpha > 0``, ``population >= 2`` and ``n m <= 4096``.
    Time O(n^3 m^3), memory O(n^2 m^2).
    """
    matrix = check_payoff(payoff)
    require(matrix.size <= MOST_STATES, f"at most {MOST_STATES} pairs (n times m)", matrix.size)
    pairs = _stationary(_transitions(matrix, alpha, population)).reshape(matrix.shape)
    return AlphaRank(pairs, pairs.sum(axis=1), pairs.sum(axis=0))


def fixation_probability(
    gain: ArrayLike, *, alpha: float = ALPHA, population: int = POPULATION
) -> Rates:
    """``(1 - e^(-alpha d)) / (1 - e^(-m alpha d))`` for a payoff gain d, ``1/m`` for d = 0.

    Written with ``expm1`` of ``-alpha |d|``, and ``e^((m - 1) alpha d)`` apart for d < 0, so that
    nothing overflows or cancels. ``alpha = inf``: 1, ``1/m`` and 0. Any shape, which is kept.

    Raises ValueError unless ``alpha > 0`` and ``population >= 2``.
    """
    require(alpha > 0.0, "an alpha above 0", alpha)
    require(population >= 2, "a population of at least 2", population)
    d = np.asarray(gain, dtype=np.float64)
    if math.isinf(alpha):
        return np.where(d > 0.0, 1.0, np.where(d < 0.0, 0.0, 1.0 / population))
    strength = -alpha * np.abs(d)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        better = np.expm1(strength) / np.expm1(population * strength)
    falling = np.exp(np.minimum(0.0, (population - 1) * alpha * d))
    # Below 1e-300 numerator and denominator lose their digits; the ratio is 1/m to rounding.
    return np.where(np.abs(strength) < 1e-300, 1.0 / population, better * falling)


def _transitions(matrix: Rates, alpha: float, population: int) -> Rates:
    """Probabilities between different states ``g * m + h``; the diagonal, to stay, is left 0."""
    rows, columns = matrix.shape
    eta = 1.0 / max(1, rows + columns - 2)  # a single pair stays
    chain = np.zeros((rows, columns, rows, columns))
    # [g, h, g']: what pursuers g' gain over g; [g, h, h']: what evaders h' gain over h.
    pursuers = matrix.T[None, :, :] - matrix[:, :, None]
    evaders = matrix[:, :, None] - matrix[:, None, :]
    for h in range(columns):
        chain[:, h, :, h] = _rate(pursuers[:, h], alpha, population)
    for g in range(rows):
        chain[g, :, g, :] = _rate(evaders[g], alpha, population)
    flat: Rates = eta * chain.reshape(matrix.size, matrix.size)
    np.fill_diagonal(flat, 0.0)
    return flat


def _rate(gain: Rates, alpha: float, population: int) -> Rates:
    rate = fixation_probability(gain, alpha=alpha, population=population)
    floored: Rates = np.maximum(rate, _RAREST)
    return floored


def _stationary(chain: Rates) -> Rates:
    """Stationary distribution of an irreducible chain; overwrites it. Grassmann et al. (1985).

    From the last to the second, states are left out: who went there goes straight to where they
    lead. A block of them at a time, so that most of the work is one matrix product.
    """
    for end in range(len(chain), 1, -_BLOCK):
        begin = max(end - _BLOCK, 1)
        for k in range(end - 1, begin - 1, -1):
            done = slice(k + 1, end)  # left out in this block, not yet seen in row and column k
            chain[k, :k] += chain[k, done] @ chain[done, :k]
            chain[:k, k] += chain[:k, done] @ chain[done, k]
            chain[:k, k] /= max(chain[k, :k].sum(), np.finfo(float).tiny)
        block = slice(begin, end)
        chain[:begin, :begin] += chain[:begin, block] @ chain[block, :begin]
    shares = np.ones(len(chain))
    for k in range(1, len(chain)):
        shares[k] = shares[:k] @ chain[:k, k]
        shares[: k + 1] /= shares[: k + 1].sum()
    return shares
