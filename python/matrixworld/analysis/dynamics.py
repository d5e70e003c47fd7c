"""Dynamics of two populations: replicator dynamics, and alpha-Rank."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_integer, check_number, check_real
from matrixworld._util.readable import Readable
from matrixworld.analysis.games import check_mixture
from matrixworld.analysis.payoffs import Rates, check_finite, check_payoff, require

TIME = 200.0
"""Default duration: a strategy that gains .05 more than another becomes e^10 times as frequent."""


@dataclass(frozen=True, eq=False, repr=False)
class ReplicatorPath(Readable):
    """Shares of all strategies: `times` (points,), `pursuers` (points, n), `evaders` (points, m).

    The shares of a population sum to 1 at each time.
    """

    times: Rates
    pursuers: Rates
    evaders: Rates

    def divergence(self, pursuers: ArrayLike, evaders: ArrayLike) -> Rates:
        """Return the distance (points,) from two mixtures p and q: ``KL(p | x) + KL(q | y)``, nats.

        In a zero-sum game it never rises if (p, q) is a Nash equilibrium, and is constant if the
        equilibrium plays all strategies: shares then go round it for ever (Hofbauer 1996).
        """
        from scipy.special import rel_entr

        p = check_mixture(pursuers, self.pursuers.shape[1], "pursuers")
        q = check_mixture(evaders, self.evaders.shape[1], "evaders")
        parts = rel_entr(p, self.pursuers).sum(axis=1), rel_entr(q, self.evaders).sum(axis=1)
        return np.asarray(sum(parts))


def replicator_dynamics(
    payoff: ArrayLike,
    *,
    pursuers: ArrayLike | None = None,
    evaders: ArrayLike | None = None,
    time: float = TIME,
    points: int = 201,
) -> ReplicatorPath:
    """Let the shares of strategies grow by what they gain against the other population.

    ``x_g' = x_g ((A y)_g - x A y)`` and ``y_h' = y_h (x A y - (x A)_h)``: strategies above the mean
    of their population become more frequent. Nothing mutates, so a share of 0 stays 0. SciPy
    integrates the payoff that each strategy has collected; shares are proportional to its
    exponential.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoffs A of the row population, any finite numbers; the other one has ``-A``, or ``1 - A``.
    pursuers, evaders : array_like of float, shapes (n,) and (m,), optional
        Shares at the begin, with sum 1. The default is equal shares.
    time : float, optional
        Duration, finite and above 0. With payoffs k times as large, all is k times as fast.
    points : int, optional
        Number of times at which shares are returned, at least 2; the first is 0.

    References
    ----------
    Taylor and Jonker (1978), "Evolutionary stable strategies and game dynamics". Hofbauer (1996),
    "Evolutionary dynamics for bimatrix games: a Hamiltonian system?", equation 1.1.
    """
    from scipy.integrate import solve_ivp

    a = check_finite(payoff, "payoffs (n, m)", ndim=2)
    time = check_number("time", time, least=0.0, positive=True)
    points = check_integer("points", points, 2)
    n, m = a.shape
    x = check_mixture(np.full(n, 1.0 / n) if pursuers is None else pursuers, n, "pursuers")
    y = check_mixture(np.full(m, 1.0 / m) if evaders is None else evaders, m, "evaders")

    def collected(_: float, state: Rates) -> Rates:
        return np.append(a @ _shares(y, state[n:]), _shares(x, state[:n]) @ -a)

    times = np.linspace(0.0, time, points)
    solved = solve_ivp(
        collected, (0.0, time), np.zeros(n + m), "DOP853", times, rtol=1e-12, atol=1e-12
    )
    if not solved.success:
        raise RuntimeError(f"expected a path of the replicator dynamics, got: {solved.message}")
    return ReplicatorPath(times, _shares(x, solved.y[:n].T), _shares(y, solved.y[n:].T))


def _shares(start: Rates, collected: Rates) -> Rates:
    # The largest exponent is 0, so that nothing overflows.
    grown = start * np.exp(collected - collected.max(axis=-1, keepdims=True))
    shares: Rates = grown / grown.sum(axis=-1, keepdims=True)
    return shares


# ---- alpha-Rank of two populations ---------------------------------------------------------------

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


@dataclass(frozen=True, eq=False, repr=False)
class AlphaRank(Readable):
    """Share of time at each pair (n, m), and at each generation (n,) and (m,); each sums to 1."""

    pairs: Rates
    pursuers: Rates
    evaders: Rates


def alpha_rank(
    payoff: ArrayLike, *, alpha: float = ALPHA, population: int = POPULATION
) -> AlphaRank:
    """Return the stationary distribution of two populations under mutation and selection.

    In each state all pursuers are of one generation and all evaders of one generation. A mutant of
    each of the ``n + m - 2`` other generations appears with the same probability, and takes over
    its team with the probability that its gain alone gives it (equation 8 of the paper).

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        With ``n m <= 4096``.
    alpha : float, optional
        Selection strength, above 0. ``inf``: only mutants that lose nothing take over.
    population : int, optional
        Size of each population (m in the paper), at least 2.

    References
    ----------
    Omidshafiei et al. (2019), "alpha-Rank: multi-agent evaluation by evolution". Grassmann, Taksar
    and Heyman (1985), "Regenerative analysis and steady state distributions for Markov chains": an
    elimination that never subtracts, so the result is exact to rounding.
    """
    matrix = check_payoff(payoff)
    require(check_real("alpha", alpha) > 0.0, "an alpha above 0", alpha)
    population = check_integer("population", population, 2)
    # The chain has n m states and its matrix (n m)^2 entries: 134 MB at the limit.
    require(matrix.size <= MOST_STATES, f"at most {MOST_STATES} pairs (n times m)", matrix.size)
    pairs = _stationary(_transitions(matrix, alpha, population)).reshape(matrix.shape)
    return AlphaRank(pairs, pairs.sum(axis=1), pairs.sum(axis=0))


def _transitions(matrix: Rates, alpha: float, population: int) -> Rates:
    """Return probabilities between different states ``g * m + h``; the diagonal is 0."""
    rows, columns = matrix.shape
    eta = 1.0 / max(1, rows + columns - 2)  # a single pair stays
    chain = np.zeros((rows, columns, rows, columns))
    # [g, h, g']: gain of pursuers g' over g; [g, h, h']: gain of evaders h' over h.
    pursuers = matrix.T[None, :, :] - matrix[:, :, None]
    evaders = matrix[:, :, None] - matrix[:, None, :]
    # A positive rate between all neighbours keeps the chain irreducible: one solution.
    for h in range(columns):
        chain[:, h, :, h] = np.maximum(_fixation(pursuers[:, h], alpha, population), _RAREST)
    for g in range(rows):
        chain[g, :, g, :] = np.maximum(_fixation(evaders[g], alpha, population), _RAREST)
    flat: Rates = eta * chain.reshape(matrix.size, matrix.size)
    # The elimination never uses the probability to stay.
    np.fill_diagonal(flat, 0.0)
    return flat


def _fixation(gain: Rates, alpha: float, population: int) -> Rates:
    """Return the probability that one mutant with a gain d takes over a population of size m.

    ``(1 - e^(-alpha d)) / (1 - e^(-m alpha d))``; 1/m for d = 0, as in the limit.
    """
    if math.isinf(alpha):
        return np.where(gain > 0.0, 1.0, np.where(gain < 0.0, 0.0, 1.0 / population))
    # expm1 of -alpha |d|, times e^((m - 1) alpha d) for d < 0: nothing overflows or cancels.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        strength = -alpha * np.abs(gain)
        better = np.expm1(strength) / np.expm1(population * strength)
        falling = np.exp(np.minimum(0.0, (population - 1) * alpha * gain))
    # Below 1e-300 numerator and denominator lose digits; the ratio is 1/m to rounding.
    return np.where(np.abs(strength) < 1e-300, 1.0 / population, better * falling)


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
