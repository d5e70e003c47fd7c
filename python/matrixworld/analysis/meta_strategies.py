"""Meta-solvers of PSRO: against which mixture of the other team's generations to respond.

Policy-space response oracles (Lanctot et al. 2017, "A unified game-theoretic approach to multiagent
reinforcement learning", NeurIPS 30) play an *empirical game*, whose strategies are the generations
so far. A meta-solver finds a mixture of these for each team, its *meta-strategy*; the next
generation of each team is a response to the meta-strategy of the other. ::

    p[0], e[0]
    for k in 1, 2, ...:
        M[g, h] = payoff of p[g] against e[h], for all g and h so far
        p[k] = response to the meta-strategy of the evaders in M;  e[k] likewise

With the mixture of a Nash equilibrium and exact responses this is the double oracle algorithm
(McMahan, Gordon & Blum 2003), which ends in an equilibrium of the whole game; with the uniform
mixture it is fictitious play.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.games import nash_averaging
from matrixworld.analysis.payoffs import Rates, check_payoff, require

MetaSolver = Callable[[ArrayLike], Rates]
"""Payoffs (n, m) of a team's generations against those of the other -> weights (m,) with which the
next generation of the team meets these."""

_TIE = 1e-7  # the tolerance of `nash_averaging`


def projected_replicator_dynamics(
    payoff: ArrayLike, *, steps: int = 2_000, rate: float = 0.1, least: float = 1e-6
) -> tuple[Rates, Rates]:
    """Return the mean mixtures of both teams, (n,) and (m,), under projected replicator dynamics.

    ::

        p, q = uniform mixtures
        repeat steps times:
            p = project(p + rate p (M q - p M q));  q = project(q + rate q (p M q - p M))
        project(x) = the nearest mixture whose weights are all at least `least`

    In zero-sum games these means approach an equilibrium; the mixtures themselves need not.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    steps : int, optional
        Number of steps, at least 1.
    rate : float, optional
        Length of a step, above 0.
    least : float, optional
        Smallest weight, from 0 to one over the number of generations of either team.

    References
    ----------
    Lanctot et al. (2017), "A unified game-theoretic approach to multiagent reinforcement learning".
    """
    matrix = check_payoff(payoff)
    most = 1.0 / max(matrix.shape)
    require(steps >= 1, "at least 1 step", steps)
    require(rate > 0.0, "a rate above 0", rate)
    require(0.0 <= least <= most, f"a smallest weight from 0 to {most:g}", least)
    p, q = (np.full(size, 1.0 / size) for size in matrix.shape)
    total_p, total_q = p.copy(), q.copy()
    for _ in range(steps):
        of_p, of_q = matrix @ q, p @ matrix
        mean = p @ of_p
        p = _projected(p + rate * p * (of_p - mean), least)
        q = _projected(q + rate * q * (mean - of_q), least)
        total_p += p
        total_q += q
    return total_p / total_p.sum(), total_q / total_q.sum()


def _projected(mixture: Rates, least: float) -> Rates:
    """Return the nearest mixture (Euclidean) whose weights are at least `least`."""
    # A step keeps the sum of 1, but rounding errors of the sum would grow from step to step.
    mixture = mixture / mixture.sum()
    if mixture.min() >= least:
        return mixture
    # As many of the largest weights as possible are shifted alike; the others are the smallest.
    largest = np.sort(mixture)[::-1]
    count = np.arange(1, len(mixture) + 1)
    shift = (1.0 - (len(mixture) - count) * least - np.cumsum(largest)) / count
    free = int(np.flatnonzero(largest + shift > least)[-1])
    nearest: Rates = np.maximum(mixture + shift[free], least)
    return nearest


def _nash(payoff: ArrayLike) -> Rates:
    return nash_averaging(payoff).evaders


def _prd(payoff: ArrayLike) -> Rates:
    return projected_replicator_dynamics(payoff)[1]


def rectified_nash(payoff: ArrayLike) -> Rates:
    """Return weights (m,) of the opponents that the newest row should meet: its rectified Nash.

    In PSRO_rN every member v of a population in the support of its Nash equilibrium learns against
    the members w that it beats or ties, with their weights in the equilibrium, in order to amplify
    what it is good at. That is defined for one population in a symmetric game, where a tie has the
    payoff 0 and as many members are added as the support has. With two populations the members w
    are the other team's; neither team beats the other at the value of the game, which therefore
    stands for 0. One learner adds one generation at a time, and starts from the newest one, which
    is v. If v is not in the support, PSRO_rN would not train it: then it meets the whole
    equilibrium.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoffs of the learning team; its newest generation is the last row.

    References
    ----------
    Balduzzi et al. (2019), "Open-ended learning in symmetric zero-sum games", algorithm 4.
    """
    nash = nash_averaging(payoff)
    beaten = check_payoff(payoff)[-1] >= nash.value - _TIE
    # A member of the support has the value as its mean, so that it beats or ties some opponent.
    weights = nash.evaders * (beaten if nash.pursuers[-1] > 0.0 else 1.0)
    total = float(weights.sum())
    return weights / total if total > 0.0 else nash.evaders


META_SOLVERS: dict[str, MetaSolver] = {
    "nash": _nash,
    "prd": _prd,
    "rectified": rectified_nash,
}
"""Name -> meta-solver. The uniform mixture is the opponent sampler `Uniform`."""
