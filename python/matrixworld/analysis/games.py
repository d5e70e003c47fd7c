"""Games between generations: Nash averaging, exploitability and alpha-Rank."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.readable import Readable
from matrixworld.analysis.cycles import transitive_fit
from matrixworld.analysis.intervals import (
    LEVEL,
    Estimate,
    difference_over_episodes,
    t_ends,
)
from matrixworld.analysis.payoffs import Mask, Rates, check_payoff, check_rates, require, swap_teams

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

    `value`: capture rate when both teams play their mixtures. `pursuers` (n,) and `evaders` (m,):
    weight of each generation in its team's mixture; sum 1. `pursuer_averages` and
    `evader_averages`, the Nash averages: capture rate, and escape rate, of each generation against
    the mixture of the other team; at most `value`, and ``1 - value``.
    """

    value: float
    pursuers: Rates
    evaders: Rates
    pursuer_averages: Rates
    evader_averages: Rates


def nash_averaging(payoff: ArrayLike) -> Nash:
    """Find the maximum-entropy equilibrium of a payoff matrix, and the payoffs against it.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Payoffs that differ by less than 1e-7 count as equal.

    Notes
    -----
    The zero-sum game M is solved by linear programming. The optimal mixtures of a team form a
    polytope; the one of maximum entropy is unique. Swapping the teams swaps the mixtures. Copies of
    a generation share its weight and change neither the value nor the averages.

    M is not embedded into one symmetric game: capture rates are not centred, so that game favours
    one role, and its equilibrium collapses onto one side.

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

    It is the mean of ``start``, which is optimal, and of further optimal mixtures. Each of these
    maximises the weights, up to ``1 / rows`` each, of the rows that no mixture has used so far.
    Rows that get less than the value against ``answer``, an optimal mixture of columns, have none.
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


def _max_entropy(matrix: Rates, value: float, inner: Rates, tight: Mask) -> Rates:
    """Return the optimal mixture of maximum entropy.

    In every optimal mixture the columns ``tight``, which the opponent may play, give exactly
    ``value``, and the others at least ``value``. Rows outside the support of ``inner`` have no
    weight.
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

    Of the `pursuers`: how much the best evader generation lowers the capture rate; of the
    `evaders`: how much the best pursuer generation raises it.
    """

    pursuers: float
    evaders: float

    @property
    def total(self) -> float:
        """Sum of both gains (NashConv); 0 if and only if the mixtures are a Nash equilibrium."""
        return self.pursuers + self.evaders


class ResponseGain(NamedTuple):
    """Gain of a response that was evolved against a frozen champion, and its budget in matches."""

    gain: Estimate
    budget: int

    def __str__(self) -> str:
        return (
            f"a best response evolved for {self.budget:,} matches gains {self.gain}: "
            "the champion's exploitability is at least that"
        )


def exploitability(payoff: ArrayLike, pursuers: ArrayLike, evaders: ArrayLike) -> Exploitability:
    """Return the gains of the best generations of the matrix against two mixtures.

    They are ``p M q - min_h (p M)_h`` of the pursuers and ``max_g (M q)_g - p M q`` of the evaders.
    Opponents outside the matrix may gain more: see `response_gain`.

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


def response_gain(before: ArrayLike, after: ArrayLike, *, budget: int) -> ResponseGain:
    """Return a lower bound of a champion's exploitability from a response evolved against it.

    A lower bound, because a longer search may find a better response.

    Parameters
    ----------
    before : array_like of float, shape (episodes,)
        Scores in [0, 1] of the champion's current opponents against the frozen champion.
    after : array_like of float, shape (other_episodes,)
        Scores in [0, 1] of the response against the frozen champion, in new episodes: scores in the
        episodes of its selection are too high.
    budget : int
        Matches spent on evolving the response, at least 1.
    """
    require(budget >= 1, "a budget of at least 1 match", budget)
    old = check_rates(before, ndim=1, what="scores before")
    new = check_rates(after, ndim=1, what="scores after")
    # Both score lists come from independent episodes; they need not have the same length.
    return ResponseGain(difference_over_episodes(new, old), budget)


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

    ``p max(0, M - v) q`` in capture rates, with the mixtures p and q and the value v of
    `nash_averaging`. 0 if one generation of each team is best; 1/6 in rock-paper-scissors.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        Noise makes the number larger; ``MEASURES["effective_diversity"]`` allows for it.

    Notes
    -----
    Weak generations count nothing, and copies share their weight. What evaders win more than
    ``1 - v`` is the same, so both teams have one diversity. Another measure, the expected
    cardinality of a determinantal point process (Perez-Nieves et al. 2021), depends on the scale of
    the payoffs, counts weak generations, and takes noise for diversity.

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

    The scores have the shape (n, m, episodes), of at least 4 episodes. One half of them chooses the
    mixtures, and the cells in which pursuers do better than both mixtures explain; the other half
    measures the excess of these cells, and both change roles. So noise that was chosen is not
    measured. The excess is what remains of a cell without the mixtures' means of its row and its
    column: these are the value in an equilibrium, but not in one that noise has spread over strong
    and weak generations. The lower end is without what the nearest transitive matrix has of the
    excess, and the upper end contains `effective_diversity` of all episodes, which is too large.
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
    """Share of time that the populations spend at each pair and at each generation.

    Shapes (n, m), (n,) and (m,); each has the sum 1.
    """

    pairs: Rates
    pursuers: Rates
    evaders: Rates


def alpha_rank(
    payoff: ArrayLike, *, alpha: float = ALPHA, population: int = POPULATION
) -> AlphaRank:
    """Return the stationary distribution of two populations under mutation and selection.

    Parameters
    ----------
    payoff : array_like of float, shape (n, m)
        With ``n m <= 4096``.
    alpha : float, optional
        Selection strength, above 0. ``inf``: only mutants that lose nothing take over.
    population : int, optional
        Size of each population (m in the paper), at least 2.

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
    """Return the probability that one mutant with a gain d takes over a population of size m.

    ``(1 - e^(-alpha d)) / (1 - e^(-m alpha d))``, and ``1 / m`` for d = 0, in the shape of `gain`.
    With ``alpha = inf``: 1 for gains, ``1 / m`` for d = 0, 0 for losses.
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

    def rate(gain: Rates) -> Rates:
        # A positive rate between all neighbours keeps the chain irreducible: one solution.
        return np.maximum(fixation_probability(gain, alpha=alpha, population=population), _RAREST)

    for h in range(columns):
        chain[:, h, :, h] = rate(pursuers[:, h])
    for g in range(rows):
        chain[g, :, g, :] = rate(evaders[g])
    flat: Rates = eta * chain.reshape(matrix.size, matrix.size)
    # The elimination never uses the probability to stay.
    np.fill_diagonal(flat, 0.0)
    return flat


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
