"""alpha-Rank of two populations: the share of time that evolution spends at each pair."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.payoff import Rates, check_payoff, require

ALPHA = 100.0
"""Default selection strength: a mutant that gains .01 takes over a population of 50 with
probability .63."""
POPULATION = 50
"""Default size of each population (the paper's m)."""
MOST_STATES = 4096
"""Largest number of pairs (n times m); 64 x 64 generations take a few seconds."""

_BLOCK = 64  # states that are eliminated together
# Smallest fixation probability. Smaller ones matter only between attractors without a more
# frequent connection, and there the shares would leave the range of floating-point numbers.
_RAREST = 1e-60


@dataclass(frozen=True, eq=False)
class AlphaRank:
    """Share of time that the populations spend at each pair and at each generation.

    Parameters
    ----------
    pairs : ndarray of float64, shape (n, m)
        Share of each pair; sum 1.
    pursuers : ndarray of float64, shape (n,)
        Share of each pursuer generation; sum 1.
    evaders : ndarray of float64, shape (m,)
        Share of each evader generation; sum 1.
    """

    pairs: Rates
    pursuers: Rates
    evaders: Rates

    __repr__ = short_repr


def alpha_rank(
    payoff: ArrayLike, *, alpha: float = ALPHA, population: int = POPULATION
) -> AlphaRank:
    """Return the stationary distribution of two populations under mutation and selection.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoff matrix, with ``n m <= 4096``.
    alpha : float, optional
        Selection strength, above 0. ``inf``: only mutants that lose nothing take over.
    population : int, optional
        Size of each population (m in the paper), at least 2.

    Returns
    -------
    AlphaRank
        Shares of the pairs and of the generations.

    Raises
    ------
    ValueError
        If a parameter is out of its range, or the matrix is too large.

    Notes
    -----
    In each state all pursuers are of one generation g and all evaders of one generation h. A mutant
    of each of the ``n + m - 2`` other generations appears with the same probability
    ``eta = 1 / (n + m - 2)``. It takes over its team with the `fixation_probability` of its gain.

    The stationary distribution is solved by an elimination that never subtracts: it is exact to
    rounding even if a state is left once in 1e60 steps, the smallest probability that is used. Time
    O(n^3 m^3), memory O(n^2 m^2).

    References
    ----------
    Omidshafiei et al. (2019), "alpha-Rank: multi-agent evaluation by evolution". Grassmann, Taksar
    and Heyman (1985), "Regenerative analysis and steady state distributions for Markov chains".
    """
    matrix = check_payoff(payoff)
    # The chain has n m states and its matrix (n m)^2 entries: 134 MB at the limit.
    require(matrix.size <= MOST_STATES, f"at most {MOST_STATES} pairs (n times m)", matrix.size)
    pairs = _stationary(_transitions(matrix, alpha, population)).reshape(matrix.shape)
    return AlphaRank(pairs, pairs.sum(axis=1), pairs.sum(axis=0))


def fixation_probability(
    gain: ArrayLike, *, alpha: float = ALPHA, population: int = POPULATION
) -> Rates:
    """Return the probability that one mutant takes over a population.

    Parameters
    ----------
    gain : array_like of float
        Payoff of the mutant minus payoff of the population, d.
    alpha : float, optional
        Selection strength, above 0.
    population : int, optional
        Size m of the population, at least 2.

    Returns
    -------
    ndarray of float64
        ``(1 - e^(-alpha d)) / (1 - e^(-m alpha d))``, and ``1 / m`` for d = 0, in the shape of
        `gain`. With ``alpha = inf``: 1 for gains, ``1 / m`` for d = 0, 0 for losses.

    Raises
    ------
    ValueError
        Unless ``alpha > 0`` and ``population >= 2``.

    References
    ----------
    Omidshafiei et al. (2019), as for `alpha_rank`.
    """
    require(alpha > 0.0, "an alpha above 0", alpha)
    require(population >= 2, "a population of at least 2", population)
    d = np.asarray(gain, dtype=np.float64)
    if math.isinf(alpha):
        return np.where(d > 0.0, 1.0, np.where(d < 0.0, 0.0, 1.0 / population))
    # expm1 of -alpha |d|, times e^((m - 1) alpha d) for d < 0: nothing overflows or cancels.
    strength = -alpha * np.abs(d)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        better = np.expm1(strength) / np.expm1(population * strength)
    falling = np.exp(np.minimum(0.0, (population - 1) * alpha * d))
    # Below 1e-300 numerator and denominator lose digits; the ratio is 1/m to rounding.
    return np.where(np.abs(strength) < 1e-300, 1.0 / population, better * falling)


def _transitions(matrix: Rates, alpha: float, population: int) -> Rates:
    """Return probabilities between different states ``g * m + h``; the diagonal is 0."""
    rows, columns = matrix.shape
    eta = 1.0 / max(1, rows + columns - 2)  # a single pair stays
    chain = np.zeros((rows, columns, rows, columns))
    # [g, h, g']: gain of pursuers g' over g; [g, h, h']: gain of evaders h' over h.
    pursuers = matrix.T[None, :, :] - matrix[:, :, None]
    evaders = matrix[:, :, None] - matrix[:, None, :]
    for h in range(columns):
        chain[:, h, :, h] = _rate(pursuers[:, h], alpha, population)
    for g in range(rows):
        chain[g, :, g, :] = _rate(evaders[g], alpha, population)
    flat: Rates = eta * chain.reshape(matrix.size, matrix.size)
    # The elimination never uses the probability to stay.
    np.fill_diagonal(flat, 0.0)
    return flat


def _rate(gain: Rates, alpha: float, population: int) -> Rates:
    rate = fixation_probability(gain, alpha=alpha, population=population)
    # A positive rate between all neighbours keeps the chain irreducible, so its solution is unique.
    floored: Rates = np.maximum(rate, _RAREST)
    return floored


def _stationary(chain: Rates) -> Rates:
    """Return the stationary distribution of an irreducible chain, which is overwritten.

    States are eliminated from the last to the second: a transition to an eliminated state becomes a
    transition to its successors (Grassmann et al., 1985). They are eliminated in blocks, so that
    most of the work is one matrix product.
    """
    for end in range(len(chain), 1, -_BLOCK):
        begin = max(end - _BLOCK, 1)
        for k in range(end - 1, begin - 1, -1):
            done = slice(k + 1, end)  # eliminated in this block, not yet applied to row, column k
            chain[k, :k] += chain[k, done] @ chain[done, :k]
            chain[:k, k] += chain[:k, done] @ chain[done, k]
            chain[:k, k] /= max(chain[k, :k].sum(), np.finfo(float).tiny)
        block = slice(begin, end)
        chain[:begin, :begin] += chain[:begin, block] @ chain[block, :begin]
    # Back substitution; normalising at each state keeps the shares in the floating-point range.
    shares = np.ones(len(chain))
    for k in range(1, len(chain)):
        shares[k] = shares[:k] @ chain[:k, k]
        shares[: k + 1] /= shares[: k + 1].sum()
    return shares
