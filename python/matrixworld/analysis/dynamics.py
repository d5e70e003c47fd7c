"""Replicator dynamics of two populations: how shares of strategies change under selection alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import check_integer
from matrixworld._util.readable import Readable
from matrixworld.analysis.games import check_mixture
from matrixworld.analysis.payoffs import Rates, check_finite, require

TIME = 200.0
"""Default duration: a strategy that gains .05 more than another becomes e^10 times as frequent."""


@dataclass(frozen=True, eq=False, repr=False)
class ReplicatorPath(Readable):
    """Shares of all strategies over time.

    `times` (points,); `pursuers` (points, n) and `evaders` (points, m): shares of the strategies of
    the row and of the column population; the sum at each time is 1.
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
    evader_payoff: ArrayLike | None = None,
    *,
    pursuers: ArrayLike | None = None,
    evaders: ArrayLike | None = None,
    time: float = TIME,
    points: int = 201,
) -> ReplicatorPath:
    """Let the shares of strategies grow by what they gain against the other population.

    ``x_g' = x_g ((A y)_g - x A y)`` and ``y_h' = y_h ((x B)_h - x B y)``: strategies above the mean
    of their population become more frequent. Nothing mutates, so a share of 0 stays 0.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoffs A of the row population: capture rates, or any finite numbers.
    evader_payoff : array_like of float, shape (n, m), optional
        Payoffs B of the column population. The default is ``-A``; ``1 - A`` gives the same path.
    pursuers, evaders : array_like of float, shapes (n,) and (m,), optional
        Shares at the begin, with sum 1. The default is equal shares.
    time : float, optional
        Duration, finite and above 0. With payoffs k times as large, all is k times as fast.
    points : int, optional
        Number of times at which shares are returned, at least 2; the first is 0.

    Notes
    -----
    SciPy integrates (DOP853, tolerances 1e-12) the payoff that each strategy has collected; shares
    are proportional to its exponential, so they stay positive with sum 1.

    References
    ----------
    Taylor and Jonker (1978), "Evolutionary stable strategies and game dynamics". Hofbauer (1996),
    "Evolutionary dynamics for bimatrix games: a Hamiltonian system?", equation 1.1.
    """
    from scipy.integrate import solve_ivp

    a = check_finite(payoff, "payoffs", "of shape (n, m)", ndim=2)
    b = -a if evader_payoff is None else check_finite(evader_payoff, "payoffs", "(n, m)", ndim=2)
    require(b.shape == a.shape, f"payoffs of the evaders of shape {a.shape}", b.shape)
    require(0.0 < time < math.inf, "a finite time above 0", time)
    check_integer("points", points, 2)
    n, m = a.shape
    x = check_mixture(np.full(n, 1.0 / n) if pursuers is None else pursuers, n, "pursuers")
    y = check_mixture(np.full(m, 1.0 / m) if evaders is None else evaders, m, "evaders")

    def collected(_: float, state: Rates) -> Rates:
        return np.append(a @ _shares(y, state[n:]), _shares(x, state[:n]) @ b)

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
