"""Games between generations: Nash averaging, exploitability, diversity, and meta-solvers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.readable import Readable
from matrixworld.analysis.cycles import transitive_fit
from matrixworld.analysis.intervals import (
    LEVEL,
    Estimate,
    t_ends,
)
from matrixworld.analysis.payoffs import Rates, check_payoff, check_rates, require, swap_teams

# Capture rates closer than this count as equal: the tolerance of the linear programmes.
_TIE = 1e-7
# Weights below this count as 0, by the same tolerance.
_NOTHING = 1e-7
# A row that gets so much less than the value has no weight, for all tolerances of the solver.
_LESS = 1e-3
_RANK = 1e-9  # singular values below this share of the largest are 0
_STRICT = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
_MOST_STEPS = 200


@dataclass(frozen=True, eq=False, repr=False)
class Nash(Readable):
    """The maximum-entropy Nash equilibrium of a payoff matrix, and payoffs against it.

    `value`: capture rate when both teams play their mixtures, the weights `pursuers` (n,) and
    `evaders` (m,). `pursuer_averages` and `evader_averages`, the Nash averages: capture rate, and
    escape rate, of each generation against the mixture of the other team.
    """

    value: float
    pursuers: Rates
    evaders: Rates
    pursuer_averages: Rates
    evader_averages: Rates


def nash_averaging(payoff: ArrayLike) -> Nash:
    """Find the maximum-entropy equilibrium of `payoff` (n, m), and the payoffs against it.

    The zero-sum game is solved by linear programming. The optimal mixtures of a team form a
    polytope; the one of maximum entropy is unique. Copies of a generation share its weight and
    change neither the value nor the averages. Payoffs closer than 1e-7 count as equal.

    References
    ----------
    Balduzzi et al. (2018), "Re-evaluating evaluation": the case of agents against tasks. Dantzig
    (1951), "A proof of the equivalence of the programming problem and the game problem".
    """
    matrix = check_payoff(payoff)
    swapped = swap_teams(matrix)
    # Three steps: one optimal mixture of each team, one with the largest support, and among the
    # mixtures of that support the one of maximum entropy.
    p, q = _optimal(matrix), _optimal(swapped)
    # The payoffs that both mixtures guarantee; the two bounds are equal but for rounding.
    low, high = float((p @ matrix).min()), 1.0 - float((q @ swapped).min())
    # The largest support is needed because entropy has no finite slope at a weight of 0.
    inner_p, inner_q = _inner(matrix, low, p, q), _inner(swapped, 1.0 - high, q, p)
    p = _max_entropy(matrix, low, inner_p, inner_q > 0.0)
    q = _max_entropy(swapped, 1.0 - high, inner_q, inner_p > 0.0)
    return Nash((low + high) / 2.0, p, q, matrix @ q, 1.0 - p @ matrix)


def game_value(payoff: ArrayLike) -> float:
    """Return ``nash_averaging(payoff).value`` from one linear programme."""
    matrix = check_payoff(payoff)
    return float((_optimal(matrix) @ matrix).min())


def _optimal(matrix: Rates) -> Rates:
    """Return a mixture p of rows that guarantees the most: max v with ``p @ matrix >= v``."""
    rows, columns = matrix.shape
    # The variables are the weights p and the guaranteed payoff v.
    # Against each column the mixture guarantees v: v - (p @ matrix)_h <= 0.
    upper = np.hstack([-matrix.T, np.ones((columns, 1))])
    equal = np.append(np.ones(rows), 0.0)
    cost = np.append(np.zeros(rows), -1.0)
    bounds = [(0.0, None)] * rows + [(None, None)]
    return _mixture(_solve(cost, upper, np.zeros(columns), equal, bounds)[:rows])


def _inner(matrix: Rates, value: float, start: Rates, answer: Rates) -> Rates:
    """Return an optimal mixture of all rows that have a weight in any optimal mixture.

    It is the mean of ``start``, which is optimal, and of further ones, each of which maximises the
    weights, up to ``1 / rows`` each, of the rows that no mixture has used so far. Rows that get
    less than the value against ``answer``, an optimal mixture of columns, have none.
    """
    rows, columns = matrix.shape
    kept = np.vstack(
        [
            np.hstack([-matrix.T, np.zeros((columns, rows))]),
            np.hstack([-np.eye(rows), np.eye(rows)]),
        ]
    )
    limits = np.append(np.full(columns, -value), np.zeros(rows))
    equal = np.repeat([1.0, 0.0], rows)
    found = [np.where(start > _NOTHING, start, 0.0)]
    possible = matrix @ answer > value - _LESS
    while (possible & (unused := ~np.any(found, axis=0))).any():
        ends = np.where(unused, 1.0 / rows, 0.0)
        bounds = [(0.0, None)] * rows + [(0.0, float(end)) for end in ends]
        mixture = _solve(np.repeat([0.0, -1.0], rows), kept, limits, equal, bounds)[:rows]
        if not (mixture[unused] > _NOTHING).any():
            break
        found.append(np.where(mixture > _NOTHING, mixture, 0.0))
    return _mixture(np.mean(found, axis=0))


def _solve(
    cost: Rates,
    upper: Rates,
    limits: Rates,
    equal: Rates,
    bounds: Sequence[tuple[float | None, float | None]],
) -> Rates:
    """Return the x of least cost within bounds, ``upper @ x <= limits`` and ``equal @ x = 1``."""
    from scipy.optimize import linprog

    # If rounding leaves no solution within the strict tolerances, the default ones (1e-7) serve. To
    # simplify the programme first, as HiGHS does, can lose its only solution by rounding.
    for options in (_STRICT, None, {"presolve": False}):
        result = linprog(
            cost, upper, limits, equal[None], [1.0], bounds, method="highs", options=options
        )
        if result.status == 0:
            solution: Rates = result.x
            return solution
    raise RuntimeError(f"expected a solution of the linear programme, got: {result.message}")


def _mixture(weights: Rates) -> Rates:
    # The solver may return weights just below 0.
    positive = np.maximum(weights, 0.0)
    mixture: Rates = positive / positive.sum()
    return mixture


def _max_entropy(matrix: Rates, value: float, inner: Rates, tight: NDArray[np.bool_]) -> Rates:
    """Return the optimal mixture of maximum entropy.

    In every optimal mixture the columns ``tight``, which the opponent may play, give exactly
    ``value``, and the others at least that. Rows outside the support of ``inner`` have no weight.
    """
    used = inner > 0.0
    margins = (matrix - value)[used]
    equations = np.vstack([margins[:, tight].T, np.ones(used.sum())])
    target = np.append(np.zeros(tight.sum()), 1.0)
    # The linear programme satisfies the equations to its tolerance only: project onto them.
    start = inner[used] - np.linalg.pinv(equations, rcond=_RANK) @ (
        equations @ inner[used] - target
    )
    if (start <= 0.0).any():  # weights close to the tolerance: keep those of the programme
        start = inner[used]
    directions = _null_space(equations)
    # Inequalities rarely bind, so Newton's method first tries without them.
    best = _newton(start, directions)
    slack = margins[:, ~tight].T
    if slack.size and (slack @ best).min() < -_TIE:
        best = _bounded(start, directions, slack)
    # Rows outside the support keep an exact 0.
    mixture = np.zeros(len(matrix))
    mixture[used] = best
    return _mixture(mixture)


def _null_space(equations: Rates) -> Rates:
    """Return orthonormal directions, shape (rows, d), that keep all equations."""
    _, sizes, right = np.linalg.svd(equations)
    directions: Rates = right[int(np.sum(sizes > _RANK * sizes[0])) :].T
    return directions


def _newton(start: Rates, directions: Rates) -> Rates:
    """Maximise the entropy of ``start + directions @ z`` by Newton's method, keeping it > 0."""
    p = start
    for _ in range(_MOST_STEPS if directions.size else 0):
        gradient = directions.T @ np.log(p)
        curvature = directions.T @ (directions / p[:, None])
        step = -directions @ np.linalg.solve(curvature, gradient)
        falling = -np.min(step / p, initial=0.0)
        # Beyond a relative step of 1 a logarithm is no longer close to its tangent.
        p = p + step * min(1.0, 0.5 / falling if falling > 0.5 else 1.0)
        if np.abs(step / p).max() < 1e-12:
            break
    return p


def _bounded(start: Rates, directions: Rates, slack: Rates) -> Rates:
    """Maximise the entropy under ``slack @ p >= 0``: some columns outside the support bind."""
    from scipy.optimize import minimize

    def negative_entropy(z: Rates) -> tuple[float, Rates]:
        p = np.maximum(start + directions @ z, 1e-300)
        return float(p @ np.log(p)), directions.T @ np.log(p)

    # Weights stay at least 0, too: SLSQP has no limit on steps as `_newton` has.
    inequalities = np.vstack([slack, np.eye(len(start))])
    result = minimize(
        negative_entropy,
        np.zeros(directions.shape[1]),
        jac=True,
        method="SLSQP",
        constraints={
            "type": "ineq",
            "fun": lambda z: inequalities @ (start + directions @ z),
            "jac": lambda z: inequalities @ directions,
        },
        options={"ftol": 1e-14, "maxiter": 1000},
    )
    best: Rates = start + directions @ result.x
    if (inequalities @ best).min() < -1e-6:
        raise RuntimeError(f"expected a mixture of maximum entropy, got: {result.message}")
    return best


# ---- Best responses ------------------------------------------------------------------------------

_ROUNDING = 1e-9  # tolerance of the sum of a mixture


class Exploitability(NamedTuple):
    """Gain of a best response against each team's mixture, in capture rates, at least 0.

    How much the best evaders lower, and the best pursuers raise, the capture rate.
    """

    pursuers: float
    evaders: float

    @property
    def total(self) -> float:
        """Sum of both gains (NashConv); 0 if and only if the mixtures are a Nash equilibrium."""
        return self.pursuers + self.evaders


def exploitability(payoff: ArrayLike, pursuers: ArrayLike, evaders: ArrayLike) -> Exploitability:
    """Return the gains of the best generations of the matrix against two mixtures.

    They are ``p M q - min_h (p M)_h`` of the pursuers and ``max_g (M q)_g - p M q`` of the evaders.
    Opponents outside the matrix may gain more: see `coevolution.best_responses`.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
    pursuers, evaders : array_like of float, shapes (n,) and (m,)
        Mixtures p and q: weights of at least 0 with sum 1.

    References
    ----------
    Lanctot et al. (2017), "A unified game-theoretic approach to multiagent reinforcement learning",
    where the sum is called NashConv.
    """
    matrix = check_payoff(payoff)
    p = check_mixture(pursuers, matrix.shape[0], "pursuers")
    q = check_mixture(evaders, matrix.shape[1], "evaders")
    # A mixture has a best response among the pure generations, so one minimum or maximum is enough.
    rate = float(p @ matrix @ q)
    lowest, highest = float((p @ matrix).min()), float((matrix @ q).max())
    # A best response never loses; rounding may put the difference just below 0.
    return Exploitability(max(0.0, rate - lowest), max(0.0, highest - rate))


def check_mixture(weights: ArrayLike, length: int, team: str) -> Rates:
    """Return weights of at least 0 with sum 1, or raise a ValueError that names the team."""
    mixture = check_rates(weights, ndim=1, what=f"weights of the {team}")
    require(len(mixture) == length, f"{length} weights of the {team}", len(mixture))
    total = float(mixture.sum())
    require(math.isclose(total, 1.0, abs_tol=_ROUNDING), f"weights of the {team} with sum 1", total)
    return mixture


# ---- Effective diversity -------------------------------------------------------------------------


def effective_diversity(payoff: ArrayLike) -> float:
    """Return how much the generations of the equilibrium win more than the value, where they do.

    ``p max(0, M - v) q`` in the capture rates of `payoff` (n, m), with the mixtures p and q and the
    value v of `nash_averaging`. 0 if one generation of each team is best; 1/6 in
    rock-paper-scissors. Weak generations count nothing, copies share their weight, and both teams
    have the same number. Noise makes it larger; ``MEASURES["effective_diversity"]`` allows for it.

    References
    ----------
    Balduzzi et al. (2019), "Open-ended learning in symmetric zero-sum games": ``p max(0, A) p`` of
    a symmetric game, whose value is 0. Here the value is subtracted, because roles differ.
    """
    matrix = check_payoff(payoff)
    nash = nash_averaging(matrix)
    return float(nash.pursuers @ np.maximum(0.0, matrix - nash.value) @ nash.evaders)


def effective_diversity_over_episodes(scores: Rates, *, level: float = LEVEL) -> Estimate:
    """Return the effective diversity of the measured equilibrium, with an interval over episodes.

    One half of the episodes (n, m, episodes) chooses the mixtures, and the cells in which pursuers
    do better than both mixtures explain; the other half measures the excess of these cells, and
    both change roles, so that noise that was chosen is not measured. The lower end is without what
    the nearest transitive matrix has of the excess, and the upper end contains
    `effective_diversity` of all episodes, which is too large.
    """
    matrix, halves = scores.mean(axis=2), (scores[:, :, 0::2], scores[:, :, 1::2])
    fit, found = transitive_fit(matrix), []
    for chooses, measures in (halves, halves[::-1]):
        weights = _excess_weights(chooses.mean(axis=2))
        each = np.tensordot(weights, measures, 2)
        ordered = max(0.0, float((weights * fit).sum()))
        found.append((each.mean(), each.mean() - ordered, *t_ends(each, level)))
    value, least, low, high = np.mean(found, axis=0).tolist()
    most = max(value, effective_diversity(matrix))
    ends = low + least - value, high + most - value
    return Estimate(value, *ends, "episodes", biased_low=least, biased_high=most)


def _excess_weights(matrix: Rates) -> Rates:
    """Return the weights of cells whose sum is the excess of a matrix over its mixtures' means."""
    nash = nash_averaging(matrix)
    p, q = nash.pursuers, nash.evaders
    excess = matrix - (matrix @ q)[:, None] - p @ matrix + p @ matrix @ q
    chosen = np.outer(p, q) * (excess > 0.0)
    # The same sum of chosen cells, of the matrix itself instead of its excess.
    rows, columns = chosen.sum(axis=1), chosen.sum(axis=0)
    weights: Rates = (
        chosen - np.outer(rows, q) - np.outer(p, columns) + np.outer(p, q) * chosen.sum()
    )
    return weights


# ---- Meta-solvers of PSRO ------------------------------------------------------------------------

MetaSolver = Callable[[ArrayLike], Rates]
"""Payoffs (n, m) of a team's generations against those of the other -> weights (m,) with which the
next generation of the team meets these."""


def projected_replicator_dynamics(
    payoff: ArrayLike, *, steps: int = 2_000, rate: float = 0.1, least: float = 1e-6
) -> tuple[Rates, Rates]:
    """Return the mean mixtures of both teams, (n,) and (m,), under projected replicator dynamics.

    ::

        p, q = uniform mixtures
        repeat steps times:
            p = project(p + rate p (M q - p M q));  q = project(q + rate q (p M q - p M))
        project(x) = the nearest mixture whose weights are all at least `least`

    In zero-sum games these means approach an equilibrium (Lanctot et al. 2017).
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

    In PSRO_rN every member of the support of an equilibrium learns against the members that it
    beats or ties, with their weights in it (Balduzzi et al. 2019, algorithm 4). With two
    populations these are the other team's, and a tie is the value of the game. The one member that
    learns is the newest row; if it is not in the support, it meets the whole equilibrium.
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
